//! The cores that the study inspects.

use clap::ValueEnum;
use serde::Serialize;

use super::EXTREMES;
use super::inspect::Inspection;
use crate::core::Design;
use crate::method::About;
use crate::spec::{MethodName, SpecFields};

/// What is varied, everything else at its usual value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Axis {
    /// Every method, form and operand at the extreme shininesses
    Shininess,
    /// The level Q from 0.05 to 0.95
    Level,
    /// Input fractions from 8 to 24
    Input,
    /// Output fractions from 4 to 20
    Output,
}

impl Axis {
    /// What the axis' values are called.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Shininess => "shininess",
            Self::Level => "level",
            Self::Input => "input",
            Self::Output => "output",
        }
    }
}

/// A core of the study.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Case {
    /// What is varied.
    pub axis: Axis,
    /// The value that it has.
    pub value: String,
    /// The method, with what is not usual of it.
    pub method: String,
    /// The spec.
    pub spec: String,
}

/// A core of the study with what was found.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Entry {
    /// The core.
    #[serde(flatten)]
    pub case: Case,
    /// Why there is no such core.
    pub refused: Option<String>,
    /// What was found of it.
    pub found: Option<Inspection>,
}

/// Shininesses for the axes that vary a format: fewer, because every input is run.
const FEW: [f64; 6] = [1.0, 1.001, 2.0, 3.0, 1000.0, 65536.0];

/// Those at which the input's fraction matters most, for cores with more than 2^[`ALL_OF_FEW`] codes a shininess.
const LARGE: [f64; 2] = [1000.0, 65536.0];

/// Up to this input fraction the cores of [`Axis::Input`] have all of the shininesses.
pub const ALL_OF_FEW: u32 = 22;

/// Levels of Q, in twentieths.
const LEVELS: std::ops::RangeInclusive<u32> = 1..=19;

fn list(shininesses: &[f64]) -> String {
    let texts: Vec<String> = shininesses.iter().map(f64::to_string).collect();
    format!("[{}]", texts.join(", "))
}

/// The set for a method: powers of two where it takes no others.
fn set(about: &About, shininesses: &[f64]) -> String {
    match about.powers_of_two {
        true if shininesses == LARGE => list(&[1024.0, 65536.0]),
        true => list(&[1.0, 2.0, 4.0, 1024.0, 4096.0, 65536.0]),
        false => list(shininesses),
    }
}

/// How many cores a study has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// Formats of 12 bits, and every fourth value of an axis.
    Quick,
    /// All.
    Whole,
}

/// The cores of an axis, for these methods.
#[must_use]
pub fn cases(axis: Axis, methods: &[MethodName], extent: Extent) -> Vec<Case> {
    let mut cases = Vec::new();
    let (input, output, step, widest_input) = match extent {
        Extent::Quick => (12, 12, 4, 16),
        Extent::Whole => (16, 16, 1, 24),
    };
    let mut add = |method: &str, value: String, spec: String| {
        cases.push(Case { axis, value, method: method.to_owned(), spec });
    };
    for &method in methods {
        let about = method.about();
        let name = about.name;
        let head = |shininesses: &[f64]| format!("method = \"{name}\"\nshininess = {}\n", set(about, shininesses));
        let formats = |input: u32, output: u32| format!("input_fraction = {input}\noutput_fraction = {output}\n");
        match axis {
            Axis::Shininess => {
                let base = head(&EXTREMES) + &formats(input, output);
                add(name, "cosine".to_owned(), base.clone());
                add(name, "versine".to_owned(), base.clone() + "operand = \"versine\"\n");
                if about.has("form") {
                    add(&format!("{name}, printed form"), "cosine".to_owned(), base.clone() + "form = \"paper\"\n");
                }
                if about.has("tail") {
                    add(&format!("{name}, held"), "cosine".to_owned(), base.clone() + "tail = \"hold\"\n");
                }
                if about.has("accuracy") {
                    add(&format!("{name}, accuracy 9"), "cosine".to_owned(), base + "accuracy = 9\n");
                }
            }
            Axis::Level if about.has("q") => {
                for level in LEVELS.step_by(step) {
                    let q = f64::from(level) / 20.0;
                    // The second point of the three-point cubic lies below the first.
                    let second = if about.has("g") { format!("g = {}\n", q / 9.0) } else { String::new() };
                    add(
                        name,
                        format!("Q = {q}"),
                        head(&EXTREMES) + &formats(input, output) + &format!("q = {q}\n") + &second,
                    );
                }
            }
            Axis::Level => {}
            Axis::Input => {
                for fraction in (8..=widest_input).step_by(step) {
                    let set: &[f64] = if fraction > ALL_OF_FEW { &LARGE } else { &FEW };
                    add(name, format!("F = {fraction}"), head(set) + &formats(fraction, output));
                }
            }
            Axis::Output => {
                for fraction in (4..=20).step_by(step) {
                    add(name, format!("G = {fraction}"), head(&FEW) + &formats(input, fraction));
                }
            }
        }
    }
    cases
}

impl Case {
    /// Builds and inspects the core.
    #[must_use]
    pub fn inspect(&self) -> Entry {
        let case = self.clone();
        let design = SpecFields::parse(&self.spec, "spec").and_then(SpecFields::resolve).and_then(Design::new);
        match design {
            Ok(design) => Entry { case, refused: None, found: Some(Inspection::of(design.lobe())) },
            Err(error) => Entry { case, refused: Some(error.to_string()), found: None },
        }
    }
}

/// All methods that are built as hardware.
#[must_use]
pub fn methods() -> Vec<MethodName> {
    MethodName::value_variants().to_vec()
}
