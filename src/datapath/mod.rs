//! The core as a graph of typed fixed-point operations.
//!
//! One description serves both languages, the cycle-accurate simulation and the vectorised evaluator:
//! - [`graph`]: operations, formats and their integer semantics;
//! - [`builder`]: builds a graph and bounds, row by row, the range and the error of every value;
//! - [`normalise`]: leading zeros counted and shifted out;
//! - [`widths`]: "computing just right": the cheapest inner widths whose proved error is below one output ulp;
//! - [`products`]: wide products, built of DSP blocks;
//! - [`schedule`]: places the pipeline registers;
//! - [`simulate`]: the pipeline, clock by clock;
//! - [`evaluate`]: the function, many inputs at a time;
//! - [`fault`]: what can be wrong with it.

pub mod builder;
pub mod evaluate;
pub mod fault;
pub mod graph;
pub mod normalise;
pub mod products;
pub mod range;
pub mod schedule;
pub mod simulate;
pub mod widths;

use crate::fixed::{Interval, Table, Width, Widths};
use crate::lobe::Lobe;

/// A core's graph with its ROM and the proof of its error.
#[derive(Clone, Debug)]
pub struct Datapath {
    /// The operations.
    pub graph: graph::Graph,
    /// The memories, as the graph numbers them; a coefficient ROM comes first.
    pub tables: Vec<Table>,
    /// Numbers of the method that are in no memory but constants of the graph, such as the bounds of segments.
    pub constants: Vec<i128>,
    /// The proved error of each case.
    pub errors: Vec<CaseError>,
}

impl Datapath {
    /// The coefficient ROM, if the method has one.
    #[must_use]
    pub fn coefficients(&self) -> Option<&Table> {
        self.tables.iter().find(|table| table.name == Table::COEFFICIENTS)
    }
}

/// Bounds of `hardware - method` in output ulps for one case of the analysis, over every representable input in it.
#[derive(Clone, Copy, Debug)]
pub struct CaseError {
    /// The shininess; the largest of the set where a case holds several.
    pub shininess: f64,
    /// From rounding the coefficients to ROM words.
    pub coefficients: Interval,
    /// From every quantisation in the datapath, the output's included.
    pub arithmetic: Interval,
}

impl CaseError {
    /// The sum of both, and 0 where the surface faces away: there the result is exact, and no coefficient acts.
    #[must_use]
    pub fn total(&self) -> Interval {
        (self.coefficients + self.arithmetic).hull(Interval::ZERO)
    }
}

/// An inner width that may be chosen: its handle and the values worth trying.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Its handle.
    pub width: Width,
    /// What is quantised to this many fraction bits.
    pub meaning: &'static str,
    /// The narrowest and the widest value.
    pub range: std::ops::RangeInclusive<i32>,
}

impl Parameter {
    /// A width with what it is and the values worth trying.
    #[must_use]
    pub fn new(width: Width, meaning: &'static str, range: std::ops::RangeInclusive<i32>) -> Self {
        Self { width, meaning, range }
    }

    /// It with neither end of its range above this.
    #[must_use]
    pub fn up_to(self, cap: i32) -> Self {
        Self { range: (*self.range.start()).min(cap)..=(*self.range.end()).min(cap), ..self }
    }
}

/// What a core computes and how, for people.
#[derive(Clone, Debug)]
pub struct Description {
    /// The real-valued method, in x, u and the coefficients.
    pub formula: String,
    /// How it is evaluated, and how the result is rounded.
    pub evaluation: String,
}

/// One method in one form: what can be chosen, what it costs, and how it is built.
pub trait Architecture: Sync {
    /// The inner widths that may be chosen.
    fn parameters(&self) -> Vec<Parameter>;

    /// The widths that are tried where those of [`Architecture::parameters`] are all refused; none unless there are.
    fn finest(&self) -> Vec<Parameter> {
        Vec::new()
    }

    /// What the bounds of `hardware - method` are to stay below, in output ulps.
    fn tolerance(&self) -> f64 {
        1.0
    }

    /// Widths whose errors do not add: they are probed together.
    fn interacting(&self) -> &'static [&'static [Width]] {
        &[]
    }

    /// An estimate of the hardware's size in LUTs for these widths, for ranking only.
    fn cost(&self, widths: &Widths) -> f64;

    /// The memories with these widths, the coefficient ROM first.
    fn tables(&self, widths: &Widths) -> Vec<Table>;

    /// The datapath with these widths and memories, or `None` where a product would be wider than the tools of this
    /// crate compute exactly (126 bits) or a value would leave its format.
    fn build(&self, widths: &Widths, tables: Vec<Table>) -> Option<Datapath>;

    /// The first and the last versine code that a row of the coefficient ROM serves, which may be past the last there
    /// is; `None` if it serves none, as a segment past x = 0.
    fn versines(&self, row: usize) -> Option<[i128; 2]> {
        let _ = row;
        Some([0, i128::MAX])
    }

    /// The fields of the coefficient ROM whose words are searched where coefficients are fitted: the coefficients
    /// proper, not what places or scales them.
    fn searched(&self) -> &'static [&'static str] {
        &["c", "big_a", "a"]
    }

    /// What the core computes and how, for its datasheet.
    fn description(&self, tables: &[Table]) -> Description;

    /// The real-valued method of each shininess, in the order of the set: what the hardware approximates.
    fn lobes(&self, tables: &[Table]) -> Vec<Box<dyn Lobe>>;
}

/// A rough size of a multiplier in LUTs, for ranking: every 18 by 18 tile counts, and within a tile the bits do.
pub(crate) fn multiplier_cost(a_bits: i32, b_bits: i32) -> f64 {
    let tiles = |bits: i32| f64::from((bits.max(1) + 17) / 18);
    400.0 * tiles(a_bits) * tiles(b_bits) + f64::from(a_bits * b_bits) / 8.0
}
