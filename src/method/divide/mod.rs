//! The quotient of two numbers, for the methods that divide.

pub(super) mod datapath;
pub(super) mod model;

use clap::ValueEnum;
use serde::{Deserialize, Serialize};

use crate::fixed::Width;

/// What of the denominator addresses the reciprocals.
const INDEX: Width = Width("index");
/// The reciprocal.
const R: Width = Width("r");
/// The slope of the reciprocal.
const SLOPE: Width = Width("slope");

/// How a core divides.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Divider {
    /// One quotient digit a step, by subtraction: no multiplier.
    Digit,
    /// A table of reciprocals with their slopes, and a multiplication.
    Reciprocal,
}
