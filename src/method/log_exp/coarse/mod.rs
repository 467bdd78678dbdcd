//! The method with less accuracy than the output's last bit, and so with less hardware.

pub(super) mod datapath;
pub(super) mod model;

use clap::ValueEnum;
use serde::{Deserialize, Serialize};

use crate::fixed::Width;

/// 1 where n = 1 gives x by a way of its own.
const ONE: Width = Width("one");

/// The accuracies, in bits, that may be asked for.
pub const ACCURACY: std::ops::RangeInclusive<u32> = 3..=15;
/// Input fraction bits with which one may be: the proof goes over every input code.
pub const ACCURACY_INPUT_FRACTION: std::ops::RangeInclusive<u32> = 8..=20;

/// Where the function tables of a core are meant to lie; its widths are chosen accordingly.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Memory {
    /// Where they cost least, a block RAM counting as much as some hundred LUTs.
    Auto,
    /// In LUTs: no table is larger than synthesis leaves there.
    Logic,
    /// In block RAMs, wherever that saves LUTs.
    Block,
}
