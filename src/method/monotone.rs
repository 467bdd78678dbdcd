//! Whether the output of a lobe never falls as the cosine rises.
//!
//! x^n does not, and a highlight that did would show rings. The real lobes of the methods do not either, but roundings
//! may: a product of a factor that rises and one that falls, each rounded down, now and then goes the wrong way by a
//! last bit. So words and widths are chosen with this check, which runs the neighbouring inputs themselves.

use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

use super::{Interface, Operand};
use crate::datapath::Datapath;
use crate::datapath::evaluate::Evaluator;
use crate::lobe::Lobe;

/// The most inputs that are all run.
const MOST_INPUTS: u64 = 1 << 26;
/// Outputs that are computed at a time.
const BLOCK: i64 = 4096;

/// Neighbouring cosines in [0, 1] of which the greater has the lesser output.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Falls {
    /// How many pairs of neighbours were compared, over all shininesses.
    pub pairs: u64,
    /// Whether these are all there are: then no fall is a proof that there is none.
    pub exhaustive: bool,
    /// In how many the output falls.
    pub count: u64,
    /// By how many ulps it does at most.
    pub most_ulps: u32,
    /// The shininess and the greater cosine where it falls most; of equals the first shininess.
    pub worst: [f64; 2],
}

impl Falls {
    /// Whether it is proved that the output never falls.
    #[must_use]
    pub fn is_proof(&self) -> bool {
        self.exhaustive && self.count == 0
    }

    fn and(self, other: Self) -> Self {
        let worst = if other.most_ulps > self.most_ulps { other } else { self };
        Self { pairs: self.pairs + other.pairs, count: self.count + other.count, ..worst }
    }
}

/// Steps of the versine at which real lobes are compared.
const STEPS: u32 = 1 << 12;
/// What real lobes may rise by: their coefficients' own rounding.
const ROUNDING: f64 = 1e-7;

/// Whether the methods' own lobes never rise with the versine. Between interpolated coefficients they may, past the
/// minimum of a parabola that is cut where the next row's is.
#[must_use]
pub fn are_falling(lobes: &[Box<dyn Lobe>]) -> bool {
    lobes.par_iter().all(|lobe| {
        let values = (0..=STEPS).map(|step| lobe.at(f64::from(step) / f64::from(STEPS)));
        let mut before = f64::INFINITY;
        values.into_iter().all(|value| {
            let falls = value <= before + ROUNDING;
            before = value;
            falls
        })
    })
}

/// The check of lobes with an interface.
#[derive(Debug)]
pub struct Check<'a> {
    interface: &'a Interface,
    /// Every so many blocks of operand codes one is run.
    stride: i64,
    /// The row at which the last lobe failed: most others fail there as well.
    suspect: AtomicUsize,
}

impl<'a> Check<'a> {
    /// Of the lobes of an interface.
    #[must_use]
    pub fn new(interface: &'a Interface) -> Self {
        let inputs = interface.shininess.rows() as u64 * ((1 << interface.input_fraction) + 1);
        Self { interface, stride: inputs.div_ceil(MOST_INPUTS) as i64, suspect: AtomicUsize::new(0) }
    }

    /// The falls of one row: all, or those of the first block that has one.
    fn of_row(&self, evaluator: &Evaluator, row: usize, all: bool) -> Falls {
        let index = self.interface.shininess.index_of_row(row);
        let one = 1i64 << self.interface.input_fraction;
        let rises = self.interface.operand == Operand::Cos;
        let mut outputs = [0; BLOCK as usize];
        let mut found = Falls { pairs: 0, exhaustive: self.stride == 1, count: 0, most_ulps: 0, worst: [0.0; 2] };
        // A block begins with the last code of the one before.
        for first in (0..one).step_by(((BLOCK - 1) * self.stride) as usize) {
            let count = (one + 1 - first).min(BLOCK) as usize;
            evaluator.evaluate(index, first, 1, &mut outputs[..count]);
            for (place, pair) in outputs[..count].windows(2).enumerate() {
                let (lesser, greater) = if rises { (pair[0], pair[1]) } else { (pair[1], pair[0]) };
                if lesser > greater {
                    found.count += 1;
                    if lesser - greater > found.most_ulps {
                        found.most_ulps = lesser - greater;
                        let code = first + place as i64;
                        let cosine = if rises { code + 1 } else { one - code };
                        found.worst = [self.interface.shininess.value(row), cosine as f64 / one as f64];
                    }
                }
            }
            found.pairs += count as u64 - 1;
            if !all && found.count > 0 {
                break;
            }
        }
        found
    }

    /// Whether the lobe of a datapath never falls.
    #[must_use]
    pub fn holds(&self, datapath: &Datapath) -> bool {
        let evaluator = Evaluator::new(&datapath.graph, &datapath.tables);
        self.each_row(|row| (self.of_row(&evaluator, row, false).count == 0).then_some(())).is_some()
    }

    /// What is made of each row, if something is of all. The row of which nothing was made last is tried first.
    pub fn each_row<T: Send>(&self, made: impl Fn(usize) -> Option<T> + Sync) -> Option<Vec<T>> {
        made(self.suspect.load(Ordering::Relaxed))?;
        let or_suspect = |row: usize| {
            let made = made(row);
            if made.is_none() {
                self.suspect.store(row, Ordering::Relaxed);
            }
            made
        };
        (0..self.interface.shininess.rows()).into_par_iter().map(or_suspect).collect()
    }

    /// All falls of the lobe of a datapath.
    ///
    /// # Panics
    /// Never: a set has a shininess.
    #[must_use]
    pub fn falls(&self, datapath: &Datapath) -> Falls {
        let evaluator = Evaluator::new(&datapath.graph, &datapath.tables);
        let rows = (0..self.interface.shininess.rows()).into_par_iter();
        let falls: Vec<Falls> = rows.map(|row| self.of_row(&evaluator, row, true)).collect();
        falls.into_iter().reduce(Falls::and).expect("a set has a shininess")
    }
}
