//! The core as a graph of typed fixed-point operations.
//!
//! One description serves both languages, the cycle-accurate simulation and the vectorised evaluator:
//! - [`graph`]: operations, formats and their integer semantics;
//! - [`builder`]: builds a graph and bounds, row by row, the range and the error of every value;
//! - [`quadratic`], [`cubic`] and the others named after methods: one builder a method and form;
//! - [`normalise`]: leading zeros counted and shifted out;
//! - [`shader`]: a lobe's graph with the cosine in front of it and the colours behind it;
//! - [`widths`]: "computing just right": the cheapest inner widths whose proved error is below one output ulp;
//! - [`schedule`]: places the pipeline registers;
//! - [`simulate`]: the pipeline, clock by clock;
//! - [`evaluate`]: the function, many inputs at a time;
//! - [`fault`]: what can be wrong with it.

pub mod builder;
mod chords;
mod coefficients;
pub mod cubic;
pub mod cubic_rational;
mod divide;
pub mod evaluate;
mod exponent;
pub mod fault;
pub mod graph;
pub mod harris;
pub mod log_exp;
pub mod normalise;
mod polynomial;
pub mod power;
pub mod quadratic;
pub mod range;
pub mod schedule;
pub mod schlick;
pub mod segmented;
pub mod shader;
pub mod simulate;
pub mod squaring;
pub mod tabulated;
pub mod versine_log;
pub mod widths;

use crate::emit::rom::Table;
use crate::fixed::Interval;
use crate::lobe::Lobe;
use crate::platform::error::Error;
use crate::spec::{CoreSpec, Form, Method, Widths};

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
    /// The sum of both.
    #[must_use]
    pub fn total(&self) -> Interval {
        self.coefficients + self.arithmetic
    }
}

/// An inner width that may be chosen: its name and the values worth trying.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// The name, as in [`Widths`].
    pub name: &'static str,
    /// What is quantised to this many fraction bits.
    pub meaning: &'static str,
    /// The narrowest and the widest value.
    pub range: std::ops::RangeInclusive<i32>,
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

    /// What the bounds of `hardware - method` are to stay below, in output ulps.
    fn tolerance(&self) -> f64 {
        1.0
    }

    /// Widths whose errors do not add, by their names: they are probed together.
    fn interacting(&self) -> &'static [&'static [&'static str]] {
        &[]
    }

    /// An estimate of the hardware's size in LUTs for these widths, for ranking only.
    fn cost(&self, widths: &Widths) -> f64;

    /// The memories with these widths, the coefficient ROM first.
    fn tables(&self, widths: &Widths) -> Vec<Table>;

    /// The datapath with these widths and memories, or `None` where a product would be wider than the tools of this crate
    /// compute exactly (126 bits) or a value would leave its format.
    fn build(&self, widths: &Widths, tables: Vec<Table>) -> Option<Datapath>;

    /// The first and the last versine code that a row of the coefficient ROM serves, which may be past the last there is; `None` if
    /// it serves none, as a segment past x = 0.
    fn versines(&self, row: usize) -> Option<[i128; 2]> {
        let _ = row;
        Some([0, i128::MAX])
    }

    /// The fields of the coefficient ROM whose words are searched where coefficients are fitted: the coefficients proper, not what
    /// places or scales them.
    fn searched(&self) -> &'static [&'static str] {
        &["c", "big_a", "a"]
    }

    /// What the core computes and how, for its datasheet.
    fn description(&self, tables: &[Table]) -> Description;

    /// The real-valued method of each shininess, in the order of the set: what the hardware approximates.
    fn lobes(&self, tables: &[Table]) -> Vec<Box<dyn Lobe>>;
}

/// The architecture that a spec asks for.
///
/// # Errors
/// A shininess or level that the method refuses, or a form that does not serve the set.
pub fn architecture(spec: &CoreSpec) -> Result<Box<dyn Architecture + '_>, Error> {
    // A program that uses this crate may have made the spec itself.
    if spec.form == Form::Paper && spec.shininess.frac_bits() > 0 {
        return Err(Error::input(
            "the paper form takes no shininess between the integers of a range",
            "use the stable form, which interpolates its coefficients",
        ));
    }
    Ok(match (spec.method, spec.form) {
        (Method::Quadratic, Form::Stable) => Box::new(quadratic::Stable::new(spec)?),
        (Method::Quadratic, Form::Paper) => Box::new(quadratic::Paper::new(spec)?),
        (Method::Cubic, Form::Stable) | (Method::CubicThreePoint, _) => Box::new(cubic::Stable::new(spec)?),
        (Method::Cubic, Form::Paper) => Box::new(cubic::Paper::new(spec)?),
        (
            Method::CubicMinZero
            | Method::Lyon2
            | Method::Lyon4
            | Method::Lyon8
            | Method::Power2
            | Method::Power4
            | Method::Power8,
            _,
        ) => power::architecture(spec)?,
        (Method::Segmented2 | Method::Segmented4 | Method::Segmented8, _) => Box::new(segmented::Architect::new(spec)?),
        (Method::Schlick, _) => Box::new(schlick::Schlick::new(spec)?),
        (Method::CubicRational, _) => Box::new(cubic_rational::CubicRational::new(spec)?),
        (Method::LogExp, _) => match spec.accuracy {
            None => Box::new(log_exp::LogExp::new(spec)?),
            Some(bits) => Box::new(versine_log::VersineLog::new(spec, bits)?),
        },
        (Method::Squaring, _) => Box::new(squaring::Squaring::new(spec)?),
        (Method::Harris, _) => Box::new(harris::Harris::new(spec)?),
        (Method::Table, _) => Box::new(tabulated::Tabulated::new(spec)?),
    })
}

/// A rough size of a multiplier in LUTs, for ranking: every 18 by 18 tile counts, and within a tile the bits do.
fn multiplier_cost(a_bits: i32, b_bits: i32) -> f64 {
    let tiles = |bits: i32| f64::from((bits.max(1) + 17) / 18);
    400.0 * tiles(a_bits) * tiles(b_bits) + f64::from(a_bits * b_bits) / 8.0
}
