//! Golden vectors: make and compare; what they hold and their file stand in [`crate::core::golden`].
//!
//! A golden file holds two things. Its *vectors* are a few thousand inputs with the expected outputs and with pauses
//! between them, for test benches. Its *digests* stand for all inputs: for each shininess one number over the outputs
//! for every code of the operand port. Other cores have too many inputs for that: the digests of a shader are over a
//! stream of samples a material, those of an image-based block over a few streams.

mod choose;
mod detection;
mod image;
mod matcap;
mod samples;
mod shader;

use rayon::prelude::*;
use serde::Serialize;
use xxhash_rust::xxh3::Xxh3;

pub use crate::core::golden::{Golden, RowDigest, Vector, complemented, complemented_tables, parse};

use crate::core::golden::digest_rows;
use crate::core::{BlockDesign, Design, Direction, LobeDesign};
use crate::fixed::{Format, Rng};

/// The heading of the vectors that a spec asks for.
const FROM_SPEC: &str = "inputs of the spec, one a clock and then with a clock without ce before each";

/// The vectors for inputs that a spec asks for. They come last and take no part in the choice of the others, so that
/// one more changes none of these.
///
/// Some mistakes need inputs right behind one another, others a clock without `ce` while an input is in a certain
/// register.
pub(crate) fn asked_for(design: &Design, inputs: &[Vec<i64>]) -> Vec<Vector> {
    let vector = |stall| {
        move |inputs: &Vec<i64>| Vector { outputs: design.evaluate(inputs), inputs: inputs.clone(), idle: 0, stall }
    };
    inputs.iter().map(vector(0)).chain(inputs.iter().map(vector(1))).collect()
}

/// Clocks of a pause: mostly none, else up to three.
fn pause(rng: &mut Rng) -> u32 {
    if rng.below(12) == 0 { 1 + rng.below(3) as u32 } else { 0 }
}

/// Places of candidates that together detect everything that any of the `candidates` detects: always the one that
/// detects most of what is left. `detects` has a row for each thing that is to be detected.
fn greedy(candidates: usize, detects: &[Vec<bool>]) -> Vec<usize> {
    let mut open: Vec<&Vec<bool>> = detects.iter().collect();
    let mut chosen = Vec::new();
    loop {
        let detected = |place: usize| open.iter().filter(|detects| detects[place]).count();
        // The first of the best: `max_by_key` would take the last.
        let best = (0..candidates).rev().max_by_key(|&place| detected(place));
        let Some(best) = best.filter(|&place| detected(place) > 0) else { return chosen };
        chosen.push(best);
        open.retain(|detects| !detects[best]);
    }
}

impl Golden {
    /// The golden vectors of a design.
    #[must_use]
    pub fn of(design: &Design) -> Self {
        let rows = digest_rows(design);
        let digest_of = |row| match design.block() {
            BlockDesign::Lobe(lobe) => {
                let index = lobe.interface.shininess.index_of_row(row);
                RowDigest { index, digest: digest(lobe, index) }
            }
            BlockDesign::Shader(shader) => {
                let index = shader.lobe.interface.shininess.index_of_row(row);
                RowDigest { index, digest: samples::digest(design, shader::stream(shader, index)) }
            }
            BlockDesign::Image(image) => {
                RowDigest { index: row as u32, digest: samples::digest(design, image::stream(image, row as u32)) }
            }
        };
        let digests = rows.into_par_iter().map(digest_of).collect();
        let mut groups = match design.block() {
            BlockDesign::Lobe(lobe) => choose::vectors(lobe),
            BlockDesign::Shader(shader) => shader::vectors(shader),
            BlockDesign::Image(image) => image::vectors(image),
        };
        if !design.spec.golden_inputs.0.is_empty() {
            groups.push((FROM_SPEC.to_owned(), asked_for(design, &design.spec.golden_inputs.0)));
        }
        Self { core: design.spec.name.clone(), spec_digest: design.spec.digest(), groups, digests }
    }
}

/// All codes of a port, as numbers: the least and how many.
#[must_use]
pub fn all_codes(format: Format) -> (i64, u64) {
    (format.min_code() as i64, 1 << format.width())
}

/// The digest of a shininess by the vectorised evaluator.
fn digest(lobe: LobeDesign<'_>, index: u32) -> u64 {
    let evaluator = lobe.evaluator();
    let (first, count) = all_codes(lobe.operand_format());
    let mut outputs = vec![0u32; 4096];
    let mut hash = OutputHash::default();
    let mut done = 0;
    while done < count {
        let block = (count - done).min(outputs.len() as u64);
        let outputs = &mut outputs[..block as usize];
        evaluator.evaluate(index, first + done as i64, 1, outputs);
        hash.update(outputs);
        done += block;
    }
    hash.digest()
}

/// The hash of a row's outputs, in the order of the operand's codes.
#[derive(Default)]
pub struct OutputHash {
    hash: Xxh3,
    bytes: Vec<u8>,
}

impl OutputHash {
    /// The next outputs.
    pub fn update(&mut self, outputs: &[u32]) {
        self.bytes.clear();
        self.bytes.extend(outputs.iter().flat_map(|output| output.to_le_bytes()));
        self.hash.update(&self.bytes);
    }

    /// The digest of all outputs so far.
    #[must_use]
    pub fn digest(&self) -> u64 {
        self.hash.digest()
    }
}

/// A code at an input port.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PortCode {
    /// The port's name.
    pub port: String,
    /// The code.
    pub code: i64,
    /// The number that it stands for.
    pub value: f64,
}

/// A way in which two golden files differ.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Difference {
    /// A vector's outputs.
    Output {
        /// The codes at the inputs.
        inputs: Vec<PortCode>,
        /// What the first of them selects.
        selected: String,
        /// What the model computes.
        expected: Vec<i64>,
        /// What the file says.
        got: Vec<i64>,
    },
    /// A vector that the file has in another form, or not at all.
    Vector {
        /// Its place, from 1.
        place: usize,
        /// What it should be.
        expected: Option<Vector>,
        /// What the file has.
        got: Option<Vector>,
    },
    /// A row's digest.
    Digest {
        /// The name of the first input port.
        port: String,
        /// Its code.
        index: u32,
        /// What the model computes.
        expected: Option<u64>,
        /// What the file has.
        got: Option<u64>,
    },
}

impl std::fmt::Display for Difference {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let digest = |digest: &Option<u64>| digest.map_or("none".to_owned(), |d| format!("{d:016x}"));
        let vector = |vector: &Option<Vector>| {
            vector.as_ref().map_or("none".to_owned(), |v| {
                let (inputs, outputs) = (codes_text(&v.inputs), codes_text(&v.outputs));
                format!("inputs {inputs} outputs {outputs} idle {} stall {}", v.idle, v.stall)
            })
        };
        match self {
            Self::Output { inputs, selected, expected, got } => {
                for (place, PortCode { port, code, value }) in inputs.iter().enumerate() {
                    match place {
                        0 => write!(f, "{port} = {code} ({selected})")?,
                        _ => write!(f, ", {port} = {code} ({value})")?,
                    }
                }
                write!(f, ": expected {}, got {}", codes_text(expected), codes_text(got))
            }
            Self::Vector { place, expected, got } => {
                write!(f, "vector {place}: expected {}, got {}", vector(expected), vector(got))
            }
            Self::Digest { port, index, expected, got } => {
                write!(f, "digest of {port} = {index}: expected {}, got {}", digest(expected), digest(got))
            }
        }
    }
}

/// Codes with spaces between them, for messages.
#[must_use]
pub fn codes_text(codes: &[i64]) -> String {
    codes.iter().map(i64::to_string).collect::<Vec<_>>().join(" ")
}

/// Every difference between what a design's golden file should be and what a file holds, in order.
#[must_use]
pub fn differences(design: &Design, expected: &Golden, got: &Golden) -> Vec<Difference> {
    let mut found = Vec::new();
    let ports = design.numbers(Direction::In);
    let (want, have) = (expected.vectors(), got.vectors());
    for place in 0..want.len().max(have.len()) {
        match (want.get(place), have.get(place)) {
            (Some(a), Some(b)) if a == b => {}
            (Some(&a), Some(&b)) if Vector { outputs: b.outputs.clone(), ..a.clone() } == *b => {
                let code = |(&(port, format), &code): (&(&str, Format), &i64)| PortCode {
                    port: port.to_owned(),
                    code,
                    value: format.value(code.into()),
                };
                found.push(Difference::Output {
                    inputs: ports.iter().zip(&a.inputs).map(code).collect(),
                    selected: design.selected(a.inputs[0]),
                    expected: a.outputs.clone(),
                    got: b.outputs.clone(),
                });
            }
            (a, b) => found.push(Difference::Vector {
                place: place + 1,
                expected: a.map(|&v| v.clone()),
                got: b.map(|&v| v.clone()),
            }),
        }
    }
    for place in 0..expected.digests.len().max(got.digests.len()) {
        let (a, b) = (expected.digests.get(place), got.digests.get(place));
        if a != b {
            let index = a.or(b).map_or(0, |d| d.index);
            let (expected, got) = (a.map(|d| d.digest), b.map(|d| d.digest));
            found.push(Difference::Digest { port: ports[0].0.to_owned(), index, expected, got });
        }
    }
    found
}
