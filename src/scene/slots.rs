//! The lobes of a scene's pictures by the vectorised arithmetic of a core: each code that they ask for is computed once.

use std::collections::BTreeMap;

use rayon::prelude::*;

use super::highlight::Codes;
use super::{Frame, Highlights, Scene};
use crate::core::Design;
use crate::platform::error::Error;

/// The widest gap, in codes, that is evaluated too and passed over.
const GAP: i64 = 512;
/// The codes that the scene's pictures ask for of cores with one kind of port: each row's distinct operands once.
pub(super) struct Slots {
    /// The code of `in_n` of each row that is asked for, its operands' codes, ascending, and how many come before them.
    rows: Vec<(u32, Vec<i64>, usize)>,
    /// For each picture the place of each sample's code among all of them; `NONE` where the light gives no highlight.
    places: Vec<Vec<u32>>,
}

impl Slots {
    const NONE: u32 = u32::MAX;

    pub(super) fn of<'a>(design: &Design, scene: &Scene, frames: impl Iterator<Item = &'a Frame> + Clone) -> Self {
        let codes: Vec<Codes> = frames.clone().map(|frame| Codes::of(design, scene, frame)).collect();
        let mut by_row: BTreeMap<u32, Vec<i64>> = BTreeMap::new();
        for (codes, frame) in codes.iter().zip(frames.clone()) {
            for (index, operand) in (0..frame.versine.len()).filter_map(|sample| codes.sample(frame, sample)) {
                by_row.entry(index).or_default().push(operand.into());
            }
        }
        let mut before = 0;
        let mut rows = Vec::with_capacity(by_row.len());
        for (index, mut operands) in by_row {
            operands.par_sort_unstable();
            operands.dedup();
            let count = operands.len();
            rows.push((index, operands, before));
            before += count;
        }
        let place = |(index, operand): (u32, i32)| {
            let row = rows.partition_point(|(other, ..)| *other < index);
            let (_, operands, before) = &rows[row];
            (before + operands.partition_point(|&other| other < i64::from(operand))) as u32
        };
        let of_frame = |(codes, frame): (&Codes, &Frame)| -> Vec<u32> {
            let sample = |sample: usize| codes.sample(frame, sample).map_or(Self::NONE, place);
            (0..frame.versine.len()).into_par_iter().map(sample).collect()
        };
        let places = codes.iter().zip(frames).map(of_frame).collect();
        Self { rows, places }
    }

    /// The core's results for all of the codes.
    pub(super) fn results(&self, design: &Design) -> Vec<f64> {
        let evaluator = design.evaluator();
        let lsb = design.output_format().lsb();
        let of_row = |(index, operands, _): &(u32, Vec<i64>, usize)| {
            let mut results = Vec::with_capacity(operands.len());
            let mut outputs = vec![0u32; 4096];
            let mut rest = &operands[..];
            while let Some(&first) = rest.first() {
                let most = first + outputs.len() as i64;
                let near = rest.windows(2).take_while(|pair| pair[1] - pair[0] <= GAP && pair[1] < most).count();
                let (own, others) = rest.split_at(near + 1);
                let count = (own[near] - first + 1) as usize;
                evaluator.evaluate(*index, first, 1, &mut outputs[..count]);
                results.extend(own.iter().map(|code| f64::from(outputs[(code - first) as usize]) * lsb));
                rest = others;
            }
            results
        };
        let parts: Vec<Vec<f64>> = self.rows.par_iter().map(of_row).collect();
        parts.concat()
    }

    pub(super) fn highlights(&self, view: usize, results: &[f64]) -> Vec<f64> {
        let value = |&place: &u32| if place == Self::NONE { 0.0 } else { results[place as usize] };
        self.places[view].par_iter().map(value).collect()
    }
}

/// The values of a frame's lobes by a core's vectorised arithmetic.
#[derive(Clone, Copy, Debug)]
pub struct Vectorised<'a>(pub &'a Design);

impl Highlights for Vectorised<'_> {
    fn of(&self, scene: &Scene, frame: &Frame) -> Result<Vec<f64>, Error> {
        let slots = Slots::of(self.0, scene, std::iter::once(frame));
        Ok(slots.highlights(0, &slots.results(self.0)))
    }
}
