//! What every method is asked with.

use serde::{Deserialize, Serialize};

use super::Shininess;

/// Input fraction bits that are allowed.
pub const INPUT_FRACTION: std::ops::RangeInclusive<u32> = 4..=24;
/// Output fraction bits that are allowed.
pub const OUTPUT_FRACTION: std::ops::RangeInclusive<u32> = 4..=20;

/// What the core is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Operand {
    /// The cosine x, signed Q1.F.
    Cos,
    /// The versine u = 1 - x, unsigned UQ1.F.
    Versine,
}

/// Which codes of the operand's port the core may be given.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum InputRange {
    /// Any: a cosine is signed, Q1.F, and what lies outside [0, 1] is taken to the nearer end.
    Any,
    /// Those in [0, 1]: the port is unsigned, UQ1.F, and nothing is compared. A code above 1 counts as what it is above
    /// 1.
    Unit,
}

/// The shininesses that a lobe serves, and the formats of what goes in and comes out.
#[derive(Clone, Debug, PartialEq)]
pub struct Interface {
    /// The shininesses that the core serves.
    pub shininess: Shininess,
    /// F: fraction bits of the input.
    pub input_fraction: u32,
    /// G: fraction bits of the output.
    pub output_fraction: u32,
    /// What the core is given.
    pub operand: Operand,
    /// Which codes of it the core may be given.
    pub input_range: InputRange,
    /// Whether the output is never to fall as the cosine rises.
    pub monotone: bool,
}
