//! A cost model: what synthesis will make of a core, from what the core is made of.
//!
//! DSP blocks and block RAMs follow from rules that Yosys has too ([`crate::target`]): how it splits a multiplication
//! over blocks, and when a memory is worth a block. LUTs, flip-flops and the least period are sums of the sizes of a
//! core's parts ([`Shape`]), each with a factor that is fitted to measured points by least squares of the relative
//! error, for each family of one version of the tools. The model says itself how far it is off: each point is estimated
//! by a fit to all others.

use std::collections::{BTreeMap, BTreeSet};

use serde::Serialize;
use sha2::{Digest, Sha256};

use super::shape::Multiplier;
use super::{Estimate, Point, Results, Shape};
use crate::method::word;
use crate::platform::error::{Error, refuse};
use crate::spec::hex;
use crate::synth::{Synthesis, Tools};
use crate::target::Family;

/// The fewest measured points that a family's model is fitted to.
pub const FEWEST: usize = 12;

/// Cost models by family.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Model(BTreeMap<String, FamilyModel>);

/// The cost model of a family.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FamilyModel {
    /// The tools whose results it follows.
    pub tools: Tools,
    /// The number of points that it was fitted to.
    pub points: usize,
    /// What a unit of each of [`Terms::lut`] takes, in LUTs.
    lut: Vec<f64>,
    /// What a unit of each of [`Terms::ff`] takes, in flip-flops.
    ff: Vec<f64>,
    /// What a unit of each of [`Terms::period`] takes, in ns; none where fewer than [`FEWEST`] points were placed.
    period: Option<Vec<f64>>,
    /// How far the estimates are off.
    pub accuracy: Vec<Accuracy>,
}

/// How far estimates are off: |estimated - measured| / max(1, measured), each point estimated by a fit to all others.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Accuracy {
    /// What is estimated: `LUT`, `FF`, `DSP`, `BRAM` or `MHz`.
    pub what: &'static str,
    /// The median of it.
    pub median: f64,
    /// The worst of it.
    pub worst: f64,
    /// The point with the worst.
    pub at: String,
    /// The number of points.
    pub points: usize,
}

/// What a core's cost is a sum of.
struct Terms {
    lut: Vec<f64>,
    ff: Vec<f64>,
    period: Vec<f64>,
    dsp: u32,
    bram: u32,
}

impl Terms {
    fn of(family: Family, shape: &Shape) -> Self {
        let (mut dsp, mut bram) = (0, 0);
        // Products without a block; what hangs over where an operand is wider than a block; operands of products in one
        // block and in several; the most blocks of a product; bits of memories in LUTs, words of block RAMs.
        let [mut soft, mut over, mut whole, mut split, mut most, mut looked_up, mut words] = [0u32; 7];
        let widest = family.dsp.widest();
        for multiplier in &shape.multipliers {
            let &Multiplier { wide, narrow, signed } = multiplier;
            let [multipliers, parts] = family.dsp.multipliers([wide, narrow], signed);
            dsp += parts;
            most = most.max(multipliers);
            if multipliers == 0 {
                soft += wide * narrow;
                continue;
            }
            let beyond = [(wide, narrow, widest[0]), (narrow, wide, widest[1])];
            over += beyond.iter().map(|&(own, other, widest)| if own > widest { other } else { 0 }).sum::<u32>();
            *(if multipliers == 1 { &mut whole } else { &mut split }) += wide + narrow;
        }
        for memory in &shape.memories {
            match family.bram.blocks(memory.depth, memory.word) * u32::from(memory.registered) {
                0 => looked_up += memory.depth * memory.word,
                blocks => {
                    bram += blocks;
                    words += memory.word;
                }
            }
        }
        let &Shape { adder_bits, mux_bits, shift_bits, register_bits, .. } = shape;
        let real = |counts: &[u32]| counts.iter().copied().map(f64::from).collect();
        Self {
            lut: real(&[adder_bits, mux_bits, shift_bits, looked_up, soft, over]),
            // Registers go into the blocks, and adders and selectors into the registers of others.
            ff: real(&[1, register_bits, whole, split, words, adder_bits, mux_bits]),
            // Block RAMs lie apart, the farther the more of them there are.
            period: vec![
                1.0,
                f64::from(bram).sqrt(),
                f64::from(most.saturating_sub(1)),
                f64::from(u32::from(soft > 0)),
            ],
            dsp: dsp.div_ceil(family.dsp.parts),
            bram,
        }
    }
}

/// The sum of terms, each with its factor.
fn sum(factors: &[f64], terms: &[f64]) -> f64 {
    factors.iter().zip(terms).fold(0.0, |sum, (factor, term)| sum + factor * term)
}

/// Which factors of a cost are allowed.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Factors {
    Any,
    NotNegative,
}

/// The factors with the least squares of the relative error.
fn fit(rows: &[(&[f64], f64)], allowed: Factors) -> Vec<f64> {
    let count = rows.first().map_or(0, |(terms, _)| terms.len());
    let mut used: Vec<bool> = (0..count).map(|term| rows.iter().any(|(terms, _)| terms[term] != 0.0)).collect();
    loop {
        let chosen: Vec<usize> = (0..count).filter(|&term| used[term]).collect();
        let factors = least_squares(rows, &chosen);
        let least = factors.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1));
        match least {
            // Nothing is built by taking something away: the part is left out, the most negative first.
            Some((place, &factor)) if allowed == Factors::NotNegative && factor < 0.0 => used[chosen[place]] = false,
            _ => {
                let mut all = vec![0.0; count];
                for (&term, factor) in chosen.iter().zip(factors) {
                    all[term] = factor;
                }
                return all;
            }
        }
    }
}

/// The factors of the chosen terms by the normal equations, solved by Cholesky's method.
fn least_squares(rows: &[(&[f64], f64)], chosen: &[usize]) -> Vec<f64> {
    let size = chosen.len();
    let scale: Vec<f64> =
        chosen.iter().map(|&term| rows.iter().fold(0.0, |most: f64, (terms, _)| most.max(terms[term].abs()))).collect();
    let mut matrix = vec![vec![0.0; size]; size];
    let mut right = vec![0.0; size];
    for (terms, value) in rows {
        let weight = 1.0 / value.max(1.0);
        let row: Vec<f64> = chosen.iter().zip(&scale).map(|(&term, scale)| terms[term] / scale * weight).collect();
        for i in 0..size {
            for j in 0..size {
                matrix[i][j] += row[i] * row[j];
            }
            right[i] += row[i] * value * weight;
        }
    }
    // So little that it only decides between terms that always come together.
    let trace: f64 = (0..size).map(|i| matrix[i][i]).sum();
    for (i, row) in matrix.iter_mut().enumerate() {
        row[i] += 1e-9 * trace;
    }
    let mut lower = vec![vec![0.0; size]; size];
    for i in 0..size {
        for j in 0..=i {
            let rest: f64 = matrix[i][j] - (0..j).map(|k| lower[i][k] * lower[j][k]).sum::<f64>();
            lower[i][j] = if i == j { rest.max(f64::MIN_POSITIVE).sqrt() } else { rest / lower[j][j] };
        }
    }
    let mut middle = vec![0.0; size];
    for i in 0..size {
        middle[i] = (right[i] - (0..i).map(|k| lower[i][k] * middle[k]).sum::<f64>()) / lower[i][i];
    }
    let mut factors = vec![0.0; size];
    for i in (0..size).rev() {
        factors[i] = (middle[i] - (i + 1..size).map(|k| lower[k][i] * factors[k]).sum::<f64>()) / lower[i][i];
    }
    factors.iter().zip(&scale).map(|(factor, scale)| factor / scale).collect()
}

/// A measured point as the fit sees it.
struct Sample<'a> {
    point: &'a Point,
    synthesis: &'a Synthesis,
    terms: Terms,
}

impl Sample<'_> {
    fn period(&self) -> Option<f64> {
        self.synthesis.timing.as_ref().map(|timing| 1e3 / timing.median_mhz)
    }
}

impl FamilyModel {
    fn of(tools: Tools, samples: &[Sample]) -> Self {
        let all: Vec<&Sample> = samples.iter().collect();
        let mut model = Self::fitted(tools, &all);
        model.accuracy = model.accuracy(&all);
        model
    }

    /// A model fitted to points, without a word on its accuracy.
    fn fitted(tools: Tools, samples: &[&Sample]) -> Self {
        let lut: Vec<(&[f64], f64)> =
            samples.iter().map(|s| (&s.terms.lut[..], f64::from(s.synthesis.resources.lut_total))).collect();
        let ff: Vec<(&[f64], f64)> =
            samples.iter().map(|s| (&s.terms.ff[..], f64::from(s.synthesis.resources.ff))).collect();
        let period: Vec<(&[f64], f64)> =
            samples.iter().filter_map(|s| Some((&s.terms.period[..], s.period()?))).collect();
        Self {
            tools,
            points: samples.len(),
            lut: fit(&lut, Factors::NotNegative),
            // A register that goes into a block is taken away.
            ff: fit(&ff, Factors::Any),
            period: (period.len() >= FEWEST).then(|| fit(&period, Factors::NotNegative)),
            accuracy: Vec::new(),
        }
    }

    fn estimate(&self, terms: &Terms) -> Estimate {
        let count = |factors: &[f64], terms: &[f64]| sum(factors, terms).round().max(0.0) as u32;
        Estimate {
            tools: self.tools.clone(),
            points: self.points as u32,
            lut: count(&self.lut, &terms.lut),
            ff: count(&self.ff, &terms.ff),
            dsp: terms.dsp,
            bram: terms.bram,
            mhz: self.period.as_ref().map(|factors| 1e3 / sum(factors, &terms.period).max(1.0)),
        }
    }

    fn accuracy(&self, samples: &[&Sample]) -> Vec<Accuracy> {
        let mut off: [Vec<(f64, &str)>; 5] = Default::default();
        for (place, sample) in samples.iter().enumerate() {
            let others: Vec<&Sample> =
                samples.iter().enumerate().filter(|(other, _)| *other != place).map(|(_, sample)| *sample).collect();
            let estimate = Self::fitted(self.tools.clone(), &others).estimate(&sample.terms);
            let measured = &sample.synthesis.resources;
            let counts = [
                (estimate.lut, measured.lut_total),
                (estimate.ff, measured.ff),
                (estimate.dsp, measured.dsp),
                (estimate.bram, measured.bram),
            ];
            let name = sample.point.name.as_str();
            for (off, (estimate, measured)) in off.iter_mut().zip(counts) {
                off.push((f64::from(estimate.abs_diff(measured)) / f64::from(measured.max(1)), name));
            }
            if let (Some(mhz), Some(timing)) = (estimate.mhz, &sample.synthesis.timing) {
                off[4].push(((mhz - timing.median_mhz).abs() / timing.median_mhz, name));
            }
        }
        let summed_up = |(what, mut off): (&'static str, Vec<(f64, &str)>)| {
            off.sort_by(|a, b| a.0.total_cmp(&b.0));
            let &(worst, at) = off.last()?;
            Some(Accuracy { what, median: off[off.len() / 2].0, worst, at: at.to_owned(), points: off.len() })
        };
        ["LUT", "FF", "DSP", "BRAM", "MHz"].into_iter().zip(off).filter_map(summed_up).collect()
    }
}

impl Model {
    /// Fits a model for each family that has enough points with a synthesis.
    ///
    /// # Errors
    /// Points of a family by several versions of Yosys, or no family with at least [`FEWEST`] points.
    pub fn fit(results: &Results) -> Result<Self, Error> {
        let mut by_family: BTreeMap<Family, Vec<Sample>> = BTreeMap::new();
        for point in results.points().iter().filter(|point| point.failure.is_none()) {
            if let Some(synthesis) = &point.synthesis {
                let terms = Terms::of(point.family, &point.shape);
                by_family.entry(point.family).or_default().push(Sample { point, synthesis, terms });
            }
        }
        let mut models = BTreeMap::new();
        for (family, samples) in by_family {
            let versions: BTreeSet<&str> = samples.iter().map(|sample| sample.synthesis.tools.yosys.as_str()).collect();
            if versions.len() > 1 {
                return Err(Error::input(
                    format!(
                        "the measured points of {} are of {}",
                        word(&family),
                        versions.into_iter().collect::<Vec<_>>().join(" and of ")
                    ),
                    "a cost model follows one version: give --fit-from a results file of one",
                ));
            }
            if samples.len() < FEWEST {
                continue;
            }
            let placed = samples.iter().find(|sample| sample.synthesis.tools.nextpnr.is_some());
            let tools = placed.unwrap_or(&samples[0]).synthesis.tools.clone();
            models.insert(word(&family), FamilyModel::of(tools, &samples));
        }
        refuse!(
            models.is_empty(),
            format!("no family has {FEWEST} measured points to fit a cost model to"),
            "explore some without --estimate, and give them with --fit-from"
        );
        Ok(Self(models))
    }

    /// The model of a family.
    ///
    /// # Errors
    /// A family without one.
    pub fn of(&self, family: Family) -> Result<&FamilyModel, Error> {
        self.0.get(&word(&family)).ok_or_else(|| {
            let known: Vec<&str> = self.0.keys().map(String::as_str).collect();
            Error::input(
                format!("there is no cost model for {}", word(&family)),
                format!(
                    "the measured points give one for {}: explore {FEWEST} points or more of the family, and give them \
                     with --fit-from",
                    known.join(", ")
                ),
            )
        })
    }

    /// The tools that the model of a family follows.
    ///
    /// # Errors
    /// A family without a model.
    pub fn tools(&self, family: Family) -> Result<&Tools, Error> {
        self.of(family).map(|model| &model.tools)
    }

    /// The families that have a model, with it.
    pub fn families(&self) -> impl Iterator<Item = (&str, &FamilyModel)> {
        self.0.iter().map(|(family, model)| (family.as_str(), model))
    }

    /// What a core of this shape will cost.
    ///
    /// # Errors
    /// A family without a model.
    pub fn estimate(&self, family: Family, shape: &Shape) -> Result<Estimate, Error> {
        Ok(self.of(family)?.estimate(&Terms::of(family, shape)))
    }

    /// 16 hexadecimal digits that stand for the model.
    ///
    /// # Panics
    /// Never: a model has a JSON form.
    #[must_use]
    pub fn digest(&self) -> String {
        let text = serde_json::to_string(self).expect("JSON of plain values");
        hex(&Sha256::digest(text))[..16].to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fit_finds_the_factors_and_leaves_out_what_would_be_negative() {
        let terms: Vec<[f64; 3]> = (0..20).map(|i| [1.0, f64::from(i * 7 % 11), f64::from(i * 5 % 13)]).collect();
        let rows = |factors: [f64; 3]| -> Vec<f64> { terms.iter().map(|terms| sum(&factors, terms)).collect() };
        let close = |a: &[f64], b: [f64; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-4);
        let fitted = |values: &[f64], allowed| {
            let rows: Vec<(&[f64], f64)> =
                terms.iter().zip(values).map(|(terms, &value)| (&terms[..], value)).collect();
            fit(&rows, allowed)
        };
        assert!(close(&fitted(&rows([20.0, 3.0, 2.0]), Factors::NotNegative), [20.0, 3.0, 2.0]));
        assert!(close(&fitted(&rows([40.0, 3.0, -2.0]), Factors::Any), [40.0, 3.0, -2.0]));
        let positive = fitted(&rows([40.0, 3.0, -2.0]), Factors::NotNegative);
        assert!(positive[2] == 0.0 && positive[1] > 0.0, "{positive:?}");
    }
}
