//! Golden vectors: make, write, read, compare.
//!
//! A golden file holds two things. Its *vectors* are a few thousand inputs with the expected outputs and with pauses between
//! them, for test benches. Its *digests* stand for all inputs: for each shininess one number over the outputs for
//! every code of the operand port.

mod choose;
mod file;

use rayon::prelude::*;
use serde::Serialize;
use xxhash_rust::xxh3::Xxh3;

pub use file::parse;

use crate::design::Design;
use crate::number::Format;

/// An input, its expected output, and the pauses before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Vector {
    /// The code of `in_n`.
    pub index: u32,
    /// The code of the operand port, as a number (negative for negative cosines).
    pub operand: i64,
    /// The code of `out_spec`.
    pub output: u32,
    /// Enabled clocks without a valid input before this one.
    pub idle: u32,
    /// Clocks with `ce` low while this one waits.
    pub stall: u32,
}

/// The digest of one shininess.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct RowDigest {
    /// The code of `in_n`.
    pub index: u32,
    /// XXH3-64 of the outputs for all operand codes, the least first, each as four little-endian bytes.
    pub digest: u64,
}

/// The golden vectors of a core.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Golden {
    /// The core's name.
    pub core: String,
    /// The digest of its spec.
    pub spec_digest: String,
    /// The vectors, in groups with a heading.
    pub groups: Vec<(String, Vec<Vector>)>,
    /// The digests.
    pub digests: Vec<RowDigest>,
}

/// The most outputs that the digests of a file cover; with more, only evenly spaced rows have one.
const MOST_OUTPUTS: u64 = 1 << 30;

impl Golden {
    /// The golden vectors of a design.
    #[must_use]
    pub fn of(design: &Design) -> Self {
        let rows = digest_rows(design);
        let digests = rows
            .into_par_iter()
            .map(|row| {
                let index = design.spec.shininess.index_of_row(row);
                RowDigest { index, digest: digest(design, index) }
            })
            .collect();
        Self {
            core: design.spec.name.clone(),
            spec_digest: design.spec.digest(),
            groups: choose::vectors(design),
            digests,
        }
    }

    /// All vectors, in order.
    #[must_use]
    pub fn vectors(&self) -> Vec<Vector> {
        self.groups.iter().flat_map(|(_, vectors)| vectors.iter().copied()).collect()
    }
}

/// The rows that have a digest: all, or evenly spaced ones where all would take too long.
fn digest_rows(design: &Design) -> Vec<usize> {
    let outputs = (design.spec.shininess.rows() as u64) << design.operand_format().width();
    let step = outputs.div_ceil(MOST_OUTPUTS).max(1) as usize;
    (0..design.spec.shininess.rows()).step_by(step).collect()
}

/// All codes of a port, as numbers: the least and how many.
#[must_use]
pub fn all_codes(format: Format) -> (i64, u64) {
    (format.min_code() as i64, 1 << format.width())
}

/// The digest of a shininess by the vectorised evaluator.
fn digest(design: &Design, index: u32) -> u64 {
    let evaluator = design.evaluator();
    let (first, count) = all_codes(design.operand_format());
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

/// A way in which two golden files differ.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Difference {
    /// A vector's output.
    Output {
        /// The code of `in_n`.
        index: u32,
        /// The shininess that it selects.
        shininess: f64,
        /// The operand's code.
        operand: i64,
        /// The operand's value.
        value: f64,
        /// What the model computes.
        expected: u32,
        /// What the file says.
        got: u32,
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
        /// The code of `in_n`.
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
            vector.map_or("none".to_owned(), |v| {
                format!("in_n {} operand {} output {} idle {} stall {}", v.index, v.operand, v.output, v.idle, v.stall)
            })
        };
        match self {
            Self::Output { index, shininess, operand, value, expected, got } => write!(
                f,
                "in_n = {index} (n = {shininess}), operand {operand} ({value}): expected {expected}, got {got}"
            ),
            Self::Vector { place, expected, got } => {
                write!(f, "vector {place}: expected {}, got {}", vector(expected), vector(got))
            }
            Self::Digest { index, expected, got } => {
                write!(f, "digest of in_n = {index}: expected {}, got {}", digest(expected), digest(got))
            }
        }
    }
}

/// Every difference between what a design's golden file should be and what a file holds, in order.
#[must_use]
pub fn differences(design: &Design, expected: &Golden, got: &Golden) -> Vec<Difference> {
    let mut found = Vec::new();
    let (want, have) = (expected.vectors(), got.vectors());
    for place in 0..want.len().max(have.len()) {
        match (want.get(place), have.get(place)) {
            (Some(a), Some(b)) if a == b => {}
            (Some(a), Some(b)) if Vector { output: b.output, ..*a } == *b => found.push(Difference::Output {
                index: a.index,
                shininess: design.spec.shininess.value(design.spec.shininess.row_of_index(a.index)),
                operand: a.operand,
                value: design.operand_format().value(a.operand.into()),
                expected: a.output,
                got: b.output,
            }),
            (a, b) => found.push(Difference::Vector { place: place + 1, expected: a.copied(), got: b.copied() }),
        }
    }
    for place in 0..expected.digests.len().max(got.digests.len()) {
        let (a, b) = (expected.digests.get(place), got.digests.get(place));
        if a != b {
            let index = a.or(b).map_or(0, |d| d.index);
            found.push(Difference::Digest { index, expected: a.map(|d| d.digest), got: b.map(|d| d.digest) });
        }
    }
    found
}
