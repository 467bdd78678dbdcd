//! The lobes of a scene's pictures by the arithmetic of a core: each code that they ask for is computed once.

use std::sync::atomic::{AtomicU64, Ordering};

use rayon::prelude::*;

use super::frame::BACKGROUND;
use super::highlight::Codes;
use super::{Frame, Highlights, Scene};
use crate::core::Design;
use crate::platform::error::Error;

/// The widest gap, in codes, that is evaluated too and passed over.
const GAP: i64 = 512;

/// The codes that the scene's pictures ask for of cores with one kind of port: each row's distinct operands once.
pub(super) struct Slots {
    /// The code of `in_n` of each row, and its operands' codes, ascending.
    pub rows: Vec<(u32, Vec<i64>)>,
    /// For each picture the place of each sample's code among all of them; `NONE` where the light gives no highlight.
    places: Vec<Vec<u32>>,
}

impl Slots {
    const NONE: u32 = u32::MAX;

    pub(super) fn of<'a>(design: &Design, scene: &Scene, frames: impl Iterator<Item = &'a Frame> + Clone) -> Self {
        let codes: Vec<Codes> = frames.clone().map(|frame| Codes::of(design, scene, frame)).collect();
        let mut seen = vec![false; scene.materials.len()];
        for &material in frames.clone().flat_map(|frame| &frame.material).filter(|material| **material != BACKGROUND) {
            seen[usize::from(material)] = true;
        }
        // The frames' materials have the same codes.
        let all = codes.iter().take(1).flat_map(|codes| &codes.indices);
        let mut indices: Vec<u32> = all.zip(seen).filter(|(_, seen)| *seen).map(|(&index, _)| index).collect();
        indices.sort_unstable();
        indices.dedup();
        let format = design.lobe().operand_format();
        let (first, last) = (format.min_code() as i64, format.max_code() as i64);
        // A bit for each code of each row, in words: whether it is asked for.
        let words = (last - first) as usize / 64 + 1;
        let asked: Vec<AtomicU64> = (0..indices.len() * words).map(|_| AtomicU64::new(0)).collect();
        let bit = |(index, operand): (u32, i32)| {
            let row = indices.partition_point(|other| *other < index);
            let place = (i64::from(operand) - first) as usize;
            (row * words + place / 64, place % 64)
        };
        for (codes, frame) in codes.iter().zip(frames.clone()) {
            let samples = (0..frame.versine.len()).into_par_iter();
            samples.filter_map(|sample| codes.sample(frame, sample)).map(bit).for_each(|(word, bit)| {
                if asked[word].load(Ordering::Relaxed) >> bit & 1 == 0 {
                    asked[word].fetch_or(1 << bit, Ordering::Relaxed);
                }
            });
        }
        // Each word with how many codes are asked for before it.
        let mut count = 0;
        let counted = |word: AtomicU64| {
            let word = word.into_inner();
            count += word.count_ones();
            (word, count - word.count_ones())
        };
        let asked: Vec<(u64, u32)> = asked.into_iter().map(counted).collect();
        let operands = |row: &[(u64, u32)]| -> Vec<i64> {
            let of_word = |(place, &(word, _)): (usize, &(u64, u32))| {
                let bits = (0..64).filter(move |bit| word >> bit & 1 == 1);
                bits.map(move |bit| first + (64 * place + bit) as i64)
            };
            row.iter().enumerate().flat_map(of_word).collect()
        };
        let rows = indices.iter().copied().zip(asked.chunks(words).map(operands)).collect();
        let place = |code: (u32, i32)| {
            let (word, bit) = bit(code);
            let (word, before) = asked[word];
            before + (word & ((1 << bit) - 1)).count_ones()
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
        let lsb = design.lobe().output_format().lsb();
        let of_row = |(index, operands): &(u32, Vec<i64>)| {
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
