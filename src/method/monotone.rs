//! Whether the output of a lobe never falls as the cosine rises.
//!
//! x^n does not, and a highlight that did would show rings. The real lobes of the methods do not either, but roundings
//! may: a product of a factor that rises and one that falls, each rounded down, now and then goes the wrong way by a
//! last bit. So words and widths are chosen with this check, which runs the neighbouring inputs themselves.

use std::iter::StepBy;
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

use super::{Interface, Operand};
use crate::datapath::Datapath;
use crate::datapath::evaluate::Evaluator;
use crate::lobe::Lobe;

/// The most inputs that are all run.
const MOST_INPUTS: u64 = 1 << 26;
/// The pairs that are run of more inputs, and the neighbouring codes of which all or none are run.
const SAMPLED: u64 = 1 << 22;
const BLOCK: i64 = 256;
/// The fewest blocks of a row.
const FEWEST_BLOCKS: u64 = 4;
/// Outputs that are computed at a time: most lobes that fall do early.
const CHUNK: usize = 1024;

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
        (0..=STEPS).map(|step| lobe.at(f64::from(step) / f64::from(STEPS))).is_sorted_by(|a, b| *b <= *a + ROUNDING)
    })
}

/// A lobe with one shininess: its outputs by the codes of its operand.
pub struct Row<'r> {
    evaluator: &'r Evaluator<'r>,
    index: u32,
    operand: Operand,
}

impl<'r> Row<'r> {
    /// With this code of `in_n`.
    #[must_use]
    pub fn new(evaluator: &'r Evaluator<'r>, index: u32, operand: Operand) -> Self {
        Self { evaluator, index, operand }
    }

    /// The output at a code of the operand.
    #[must_use]
    pub fn output(&self, code: i64) -> u32 {
        let mut output = [0];
        self.evaluator.evaluate(self.index, code, 1, &mut output);
        output[0]
    }

    /// Each code from `first` on that has its successor up to `last`, where of these two the greater cosine has the
    /// lesser output; with by how much.
    pub fn falls(&self, first: i64, last: i64) -> impl Iterator<Item = (i64, u32)> + '_ {
        // A chunk begins with the last code of the one before.
        (first..last).step_by(CHUNK - 1).flat_map(move |start| {
            let mut outputs = [0; CHUNK];
            let outputs = &mut outputs[..(last + 1 - start).min(CHUNK as i64) as usize];
            self.evaluator.evaluate(self.index, start, 1, outputs);
            let [before, behind] = [&outputs[..outputs.len() - 1], &outputs[1..]];
            let (lesser, greater) = match self.operand {
                Operand::Cos => (before, behind),
                Operand::Versine => (behind, before),
            };
            let pairs = lesser.iter().zip(greater);
            // Most chunks have none, which vector instructions tell.
            if !pairs.clone().fold(false, |any, (lesser, greater)| any | (lesser > greater)) {
                return Vec::new();
            }
            let fall = |(place, (lesser, greater)): (usize, (&u32, &u32))| {
                (lesser > greater).then(|| (start + place as i64, lesser - greater))
            };
            pairs.enumerate().filter_map(fall).collect()
        })
    }
}

/// The check of lobes with an interface.
#[derive(Debug)]
pub struct Check<'a> {
    interface: &'a Interface,
    /// Every so many rows one is run.
    step: usize,
    /// The first and the last operand code of each block that is run of a row: of one block where all are.
    blocks: Vec<[i64; 2]>,
    exhaustive: bool,
    /// The row at which the last lobe failed: most others fail there as well.
    suspect: AtomicUsize,
}

impl<'a> Check<'a> {
    /// Of the lobes of an interface: all inputs if they are no more than 2^26, else blocks of neighbouring ones, which
    /// lie the closer the nearer they are to the lobe's peak, where it falls steepest.
    #[must_use]
    pub fn new(interface: &'a Interface) -> Self {
        let (rows, one) = (interface.shininess.rows() as u64, 1i64 << interface.input_fraction);
        let suspect = AtomicUsize::new(0);
        if rows * (one as u64 + 1) <= MOST_INPUTS {
            return Self { interface, step: 1, blocks: vec![[0, one]], exhaustive: true, suspect };
        }
        let step = rows.div_ceil(SAMPLED / BLOCK as u64 / FEWEST_BLOCKS);
        let count = (SAMPLED / rows.div_ceil(step) / BLOCK as u64) as i64;
        let versine = |place: i64| (one as f64 * (place as f64 / count as f64).powi(2)) as i64;
        let block = |place: i64| {
            let [first, last] = [versine(place), (versine(place) + BLOCK).min(versine(place + 1))];
            match interface.operand {
                Operand::Versine => [first, last],
                Operand::Cos => [one - last, one - first],
            }
        };
        Self { interface, step: step as usize, blocks: (0..count).map(block).collect(), exhaustive: false, suspect }
    }

    fn row<'r>(&self, evaluator: &'r Evaluator<'r>, row: usize) -> Row<'r> {
        Row::new(evaluator, self.interface.shininess.index_of_row(row), self.interface.operand)
    }

    /// The first and the last operand code of each block that is run of a row, between two codes.
    pub fn blocks(&self, from: i64, to: i64) -> impl Iterator<Item = (i64, i64)> + '_ {
        let within = move |&[first, last]: &[i64; 2]| (first.max(from), last.min(to));
        self.blocks.iter().map(within).filter(|(first, last)| first < last)
    }

    /// [`Check::blocks`] between cosines of 0 and 1.
    fn all_blocks(&self) -> impl Iterator<Item = (i64, i64)> + '_ {
        self.blocks(0, 1 << self.interface.input_fraction)
    }

    /// Whether the lobe of a datapath never falls.
    #[must_use]
    pub fn holds(&self, datapath: &Datapath) -> bool {
        let evaluator = Evaluator::new(&datapath.graph, &datapath.tables);
        let never_falls = |row: usize| {
            let row = self.row(&evaluator, row);
            self.all_blocks().all(|(first, last)| row.falls(first, last).next().is_none()).then_some(())
        };
        self.all_of(self.rows(), never_falls).is_some()
    }

    /// The rows that are run.
    fn rows(&self) -> StepBy<Range<usize>> {
        (0..self.interface.shininess.rows()).step_by(self.step)
    }

    /// What is made of each row, if something is of all. The row of which nothing was made last is tried first.
    pub fn each_row<T: Send>(&self, made: impl Fn(usize) -> Option<T> + Sync) -> Option<Vec<T>> {
        self.all_of((0..self.interface.shininess.rows()).step_by(1), made)
    }

    fn all_of<T: Send>(&self, rows: StepBy<Range<usize>>, made: impl Fn(usize) -> Option<T> + Sync) -> Option<Vec<T>> {
        made(self.suspect.load(Ordering::Relaxed))?;
        let or_suspect = |row: usize| {
            let made = made(row);
            if made.is_none() {
                self.suspect.store(row, Ordering::Relaxed);
            }
            made
        };
        rows.collect::<Vec<_>>().into_par_iter().map(or_suspect).collect()
    }

    /// What is known of a lobe for which the check holds.
    #[must_use]
    pub fn none(&self) -> Falls {
        let pairs: i64 = self.all_blocks().map(|(first, last)| last - first).sum();
        Falls {
            pairs: pairs as u64 * self.rows().len() as u64,
            exhaustive: self.exhaustive,
            count: 0,
            most_ulps: 0,
            worst: [0.0; 2],
        }
    }

    /// All falls of the lobe of a datapath.
    #[must_use]
    pub fn falls(&self, datapath: &Datapath) -> Falls {
        let evaluator = Evaluator::new(&datapath.graph, &datapath.tables);
        let one = 1i64 << self.interface.input_fraction;
        let of_row = |place: usize| {
            let row = self.row(&evaluator, place);
            let falls = self.all_blocks().flat_map(|(first, last)| row.falls(first, last));
            falls.fold((0, 0, [0.0; 2]), |(count, most, worst), (code, ulps)| {
                if ulps <= most {
                    return (count + 1, most, worst);
                }
                let cosine = if self.interface.operand == Operand::Cos { code + 1 } else { one - code };
                (count + 1, ulps, [self.interface.shininess.value(place), cosine as f64 / one as f64])
            })
        };
        let rows: Vec<_> = self.rows().collect::<Vec<_>>().into_par_iter().map(of_row).collect();
        rows.into_iter().fold(self.none(), |found, (count, most_ulps, worst)| {
            let found = Falls { count: found.count + count, ..found };
            if most_ulps > found.most_ulps { Falls { most_ulps, worst, ..found } } else { found }
        })
    }
}
