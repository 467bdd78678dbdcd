//! Every reader of files on a corpus, on what has once made one of them fail, and on changes of both. The corpus comes
//! from the fuzzer; see docs/fuzzing.md.

#[path = "../../fuzz/targets.rs"]
mod targets;

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use brdfgen::emit::rom::{self, RomFormat};
use brdfgen::scene::mesh::{Mesh, Normals};
use brdfgen::spec::SpecFields;
use brdfgen::verify::golden;
use rand_core::{Rng, SeedableRng};
use rand_pcg::Pcg64;
use rayon::prelude::*;
use targets::TARGETS;

/// The longest that a reader may take for a file of the corpus, on a busy machine; the fuzzer allows as much.
const LONGEST: Duration = Duration::from_secs(10);
/// Changed inputs for each reader; of specs of which cores are made, fewer.
const CHANGED: u64 = 1500;
const CHANGED_SPECS: u64 = 300;

/// The kept inputs of a reader with their names, in order.
fn corpus(name: &str) -> Vec<(PathBuf, Vec<u8>)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz");
    let mut files = Vec::new();
    for kind in ["corpus", "regressions"] {
        let Ok(entries) = fs::read_dir(root.join(kind).join(name)) else { continue };
        files.extend(entries.map(|entry| entry.unwrap().path()).map(|path| (path.clone(), fs::read(path).unwrap())));
    }
    files.sort();
    files
}

/// Runs a reader on an input; what fails is named.
fn holds(name: &str, run: fn(&[u8]), bytes: &[u8], what: &str) {
    let start = Instant::now();
    let shown = || String::from_utf8_lossy(bytes).chars().take(2000).collect::<String>();
    if catch_unwind(AssertUnwindSafe(|| run(bytes))).is_err() {
        panic!("{name}: {what}:\n{}", shown());
    }
    assert!(start.elapsed() < LONGEST, "{name}: {what} took {:?}:\n{}", start.elapsed(), shown());
}

#[test]
fn the_corpus_is_read_or_refused() {
    for (name, run) in TARGETS {
        let files = corpus(name);
        assert!(files.len() > 3, "{name} has {} files", files.len());
        files.par_iter().for_each(|(path, bytes)| holds(name, run, bytes, &path.display().to_string()));
    }
}

/// Cut, repeated, joined and overwritten, always in the same ways.
#[test]
fn changed_files_are_read_or_refused() {
    for (name, run) in TARGETS {
        let files = corpus(name);
        let changed = if name == "generate" { CHANGED_SPECS } else { CHANGED };
        (0..changed).into_par_iter().for_each(|seed| {
            let mut rng = Pcg64::seed_from_u64(seed);
            let mut below = |most: usize| (rng.next_u64() % most.max(1) as u64) as usize;
            let mut bytes = files[below(files.len())].1.clone();
            for _ in 0..=below(4) {
                let (at, length) = (below(bytes.len() + 1), below(12));
                let end = (at + length).min(bytes.len());
                match below(7) {
                    0 => bytes.truncate(at),
                    1 => drop(bytes.drain(at..end)),
                    2 => bytes.splice(at..at, bytes[at..end].repeat(1 + below(40))).for_each(drop),
                    3 => bytes.iter_mut().skip(at).take(1).for_each(|byte| *byte ^= 1 << below(8)),
                    4 => bytes
                        .iter_mut()
                        .skip(at)
                        .take(length)
                        .for_each(|byte| *byte = b"0123456789.,;:-+=\"'[]{}\n \0\xff"[below(27)]),
                    5 => {
                        let numbers =
                            ["4294967296", "-1", "1e999", "nan", "18446744073709551616", "0x", "ffffffff", "\u{301}"];
                        bytes.splice(at..end, numbers[below(8)].bytes()).for_each(drop);
                    }
                    _ => {
                        let other = &files[below(files.len())].1;
                        let from = below(other.len() + 1);
                        bytes.splice(at.., other[from..].iter().copied()).for_each(drop);
                    }
                }
            }
            holds(name, run, &bytes, &format!("change {seed}"));
        });
    }
}

/// A failure can be had again, and a run that passed passes again: no test draws other inputs each time.
#[test]
fn property_tests_draw_the_same_inputs_in_every_run() {
    let seed = proptest::test_runner::Config::default().rng_seed;
    assert!(matches!(seed, proptest::test_runner::RngSeed::Fixed(_)), ".cargo/config.toml fixes it, not {seed:?}");
}

/// A property that does not hold is noticed, with the input.
#[test]
fn what_fails_is_named() {
    let fails = |bytes: &[u8]| assert!(!bytes.contains(&b'7'), "a seven");
    holds("test", fails, b"1", "fine");
    let noticed = catch_unwind(|| holds("test", fails, b"a 7", "planted")).unwrap_err();
    assert_eq!(noticed.downcast_ref::<String>().unwrap(), "test: planted:\na 7");
}

/// The error of something that must be refused.
#[track_caller]
fn refused<T>(result: Result<T, brdfgen::platform::error::Error>) -> String {
    result.err().expect("it must be refused").to_string()
}

/// What asks for absurd amounts is refused in words at once, and takes no memory.
#[test]
fn absurd_sizes_are_refused() {
    let start = Instant::now();
    for text in [
        "shininess = \"1..=4000000000\"",
        "shininess = \"0..=4294967295\"",
        "shininess = \"1..=4294967295\"\nshininess_fraction = 10",
        "shininess = \"1..=65536\"\nshininess_fraction = 4000000000",
        "shininess = [5]\ninput_fraction = 4000000000",
        "shininess = [5]\noutput_fraction = 4294967295",
        "shininess = [5]\npipeline = 4000000000",
        "shininess = [1e300]",
        "shininess = [inf]",
        "shininess = [nan]",
    ] {
        let text = format!("method = \"quadratic\"\n{text}\n");
        refused(SpecFields::parse(&text, "spec.toml").and_then(SpecFields::resolve));
    }
    for key in ["table_bits = 4000000000", "table_bits = 60"] {
        let text = format!("method = \"table\"\nshininess = [5]\n{key}\n");
        refused(SpecFields::parse(&text, "spec.toml").and_then(SpecFields::resolve));
    }
    for (format, text) in [
        (RomFormat::Mem, "@ffffffff 1\n"),
        (RomFormat::Mem, "@ffffffffffffffff 1\n"),
        (RomFormat::Mem, "@ffffffffffffffffffffffff 1\n"),
        (RomFormat::Hex, ":02000004FFFFFC\n:0100000001FE\n:00000001FF\n"),
        (RomFormat::Mif, "DEPTH = 1099511627776; WIDTH = 8; CONTENT BEGIN 0 : 1; END;"),
        (RomFormat::Mif, "DEPTH = 99999999999999999999999; WIDTH = 8; CONTENT BEGIN 0 : 1; END;"),
        (RomFormat::Mif, "DEPTH = 4; WIDTH = 8; CONTENT BEGIN [0..ffffffff] : 1; END;"),
        (RomFormat::Mif, "DEPTH = 4; WIDTH = 4000000000; CONTENT BEGIN 0 : 1; END;"),
        (RomFormat::Vhdl, "constant c : t := (4294967295 => \"00000001\"); end;"),
        (RomFormat::Vhdl, "constant c : t := (0 => 4000000000x\"1\"); end;"),
        (RomFormat::Csv, "address,word\n4294967295,1\n"),
    ] {
        refused(rom::read(text.as_bytes(), format, "file", 8));
    }
    for header in [
        "format ascii 1.0\nelement vertex 99999999999",
        "format ascii 1.0\nelement vertex 18446744073709551615",
        "format ascii 1.0\nelement vertex 99999999999999999999999",
        "format binary_little_endian 1.0\nelement vertex 99999999999",
        "format binary_big_endian 1.0\nelement vertex 4294967296",
    ] {
        let text = format!(
            "ply\n{header}\nproperty float x\nproperty float y\nproperty float z\nelement face 99999999999\nproperty \
             list uint int vertex_indices\nend_header\n0 0 0\n"
        );
        refused(Mesh::parse(text.as_bytes(), "mesh.ply", Normals::File));
    }
    let list = "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty \
     float z\n\
                element face 1\nproperty list uint int vertex_indices\nend_header\n";
    let bytes = [list.as_bytes(), &[0; 12], &[0xff; 4], &[0; 8]].concat();
    refused(Mesh::parse(&bytes, "mesh.ply", Normals::File));
    refused(Mesh::parse(b"v 0 0 0\nf 4294967297 1 1\nf 99999999999999999999999 1 1\n", "mesh.obj", Normals::File));
    let design = SpecFields::parse("method = \"quadratic\"\nshininess = [5]\n", "spec")
        .and_then(SpecFields::resolve)
        .and_then(brdfgen::core::Design::new)
        .unwrap();
    let head = format!("# core {}\n# spec {}\n", design.spec.name, design.spec.digest());
    for line in [
        "c 99999999999999999999999",
        "c 18446744073709551615",
        "c 1\nv 0 0 0 99999999999999999999999 0",
        "c 0\nd ffffffffff 0000000000000000",
    ] {
        refused(golden::parse(&design, &format!("{head}{line}\n"), "file.vec"));
    }
    assert!(start.elapsed() < LONGEST, "{:?}", start.elapsed());
}
