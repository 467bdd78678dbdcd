//! The built program, from the outside: what it refuses, what it writes, what it says and how it ends.

mod answers;
mod bad_input;
mod generate;

use std::ffi::OsString;
use std::fs;
use std::path::Path;

use ihex::Record;
use proptest::prelude::*;
use quick_junit::{Report, TestCaseStatus};
use serde_json::json;
use sha2::{Digest, Sha256};

use crate::common::{Scratch, Tree};

/// A small core: three rows, every one of its 1024 operand codes quickly run through.
const SMALL: &str = "--method quadratic --shininess 1,5,20.5 --input-fraction 8 --output-fraction 8";
/// The same spec as TOML.
const SMALL_TOML: &str = "method = \"quadratic\"\nshininess = [1, 5, 20.5]\ninput_fraction = 8\noutput_fraction = 8\n";
/// Another method, a range and the other operand.
const CUBIC: &str = "--method cubic --shininess 3..=9 --input-fraction 8 --output-fraction 8 --operand versine";

/// A directory with the small core in `core`.
fn with_core() -> Scratch {
    let scratch = Scratch::new();
    scratch.run(&format!("generate {SMALL} --out core")).succeeds();
    scratch
}

/// `text` with the first occurrence of `from`, which must be there, replaced.
#[track_caller]
fn replaced(text: &str, from: &str, to: &str) -> String {
    assert!(text.contains(from), "`{from}` is not in\n{text}");
    text.replacen(from, to, 1)
}

// Bad input
