//! The cores that are tried for a scene: which methods, with which coefficients and fraction bits.

use std::sync::atomic::{AtomicUsize, Ordering};

use clap::ValueEnum;
use rayon::prelude::*;

use super::Requirements;
use super::choice::{SceneCore, Search};
use super::require::ShininessRow;
use crate::fit;
use crate::method::log_exp::{ACCURACY, ACCURACY_INPUT_FRACTION};
use crate::method::table::TABLE_BITS;
use crate::spec::{
    Coefficients, Divider, INPUT_FRACTION, InputRange, Inside, Material, MethodName, OUTPUT_FRACTION, SpecFields, Tail,
};

/// Fraction bits of a port that are tried, from the fewest that any core can do with.
const WIDTHS: u32 = 3;
/// The fewest fraction bits that are tried of a port of which no number is enough.
const UNMET_WIDTH: u32 = 18;
/// A method that misses the budget by more octaves than this with the most fraction bits is not tried with fewer.
const HOPELESS: f64 = 1.0;

/// What candidates have in common but for the fraction bits.
#[derive(Clone, Debug)]
struct Axis {
    fields: SpecFields,
    /// Whether the accuracy is yet to be found.
    coarse: bool,
}

/// A level with two significant digits, below the given one: where exactly it lies does not matter, and a spec is for
/// people too.
fn rounded_level(level: f64) -> f64 {
    let scale = libm::pow(10.0, 1.0 - libm::floor(libm::log10(level)));
    (libm::floor(level * scale) / scale).clamp(0.001, 0.99)
}

impl Search<'_> {
    /// The keys that every candidate has unless others are given: the scene's name and materials, and a port for what
    /// occurs.
    fn common(&self) -> SpecFields {
        let material =
            |row: &ShininessRow| Material { name: row.name.clone(), shininess: row.shininess, ..Material::default() };
        SpecFields {
            name: Some(self.scene.name.clone()),
            material: Some(self.requirements.rows.iter().map(material).collect()),
            input_range: self.requirements.stays_in_range().then_some(InputRange::Unit),
            ..SpecFields::default()
        }
    }

    /// The fields of a candidate; none where the keys say otherwise or make no core with it.
    fn fields(&self, own: &SpecFields) -> Option<SpecFields> {
        let given = self.keys.clone().or(own.clone());
        let agrees = given == own.clone().or(self.keys.clone());
        let fields = given.or(self.common());
        (agrees && fields.clone().resolve().is_ok()).then_some(fields)
    }

    /// The methods with their coefficients, without fraction bits.
    fn axes(&self) -> Vec<Axis> {
        let level = self.requirements.invisible_below.filter(|level| (0.001..=0.99).contains(level));
        let level = level.map(|level| fit::Objective::MaxAbsLevel { level: rounded_level(level) });
        let objectives: Vec<fit::Objective> =
            [Some(fit::Objective::MaxAbs), level, Some(fit::Objective::Weighted { power: 0.5 })]
                .into_iter()
                .flatten()
                .collect();
        let (mut axes, none) = (Vec::new(), SpecFields::default);
        for &method in MethodName::value_variants() {
            let about = method.about();
            if about.is_baseline && self.keys.method != Some(method) {
                continue;
            }
            let plain = SpecFields { method: Some(method), ..none() };
            let mut own = vec![plain.clone()];
            let mut spread = |ways: Vec<SpecFields>| {
                let with_all = |one: &SpecFields| -> Vec<SpecFields> {
                    ways.iter().map(|way| one.clone().or(way.clone())).collect()
                };
                own = own.iter().flat_map(with_all).collect();
            };
            if !about.coefficients.is_empty() {
                let ways = |&coefficients: &Coefficients| {
                    let with = SpecFields { coefficients: Some(coefficients), ..none() };
                    match coefficients {
                        Coefficients::Paper => vec![with],
                        Coefficients::Minimax => objectives
                            .iter()
                            .map(|&objective| SpecFields { objective: Some(objective), ..with.clone() })
                            .collect(),
                    }
                };
                spread(about.coefficients.iter().flat_map(ways).collect());
            }
            if about.has("tail") {
                spread([Tail::Cut, Tail::Hold].map(|tail| SpecFields { tail: Some(tail), ..none() }).into());
            }
            if about.has("inside") {
                let insides = [Inside::Linear, Inside::Quadratic];
                spread(insides.map(|inside| SpecFields { inside: Some(inside), ..none() }).into());
            }
            if about.has("divider") {
                let dividers = [Divider::Digit, Divider::Reciprocal];
                spread(dividers.map(|divider| SpecFields { divider: Some(divider), ..none() }).into());
            }
            if about.has("table_bits") {
                let bits = (*TABLE_BITS.start() + 2..).take(9);
                spread(bits.map(|bits| SpecFields { table_bits: Some(bits), ..none() }).collect());
            }
            axes.extend(own.into_iter().map(|fields| Axis { fields, coarse: false }));
            if about.has("accuracy") {
                axes.push(Axis { fields: plain, coarse: true });
            }
        }
        axes
    }

    /// The fraction bits that are tried of a port, ascending.
    fn widths(given: Option<u32>, fewest: Option<u32>, allowed: std::ops::RangeInclusive<u32>) -> Vec<u32> {
        if let Some(given) = given {
            return vec![given];
        }
        let last = *allowed.end();
        // Where no width is enough, the misses are no nearer with the widest ports than with these.
        let first = fewest.unwrap_or(UNMET_WIDTH).clamp(*allowed.start(), last);
        (first..=(first + WIDTHS - 1).min(last)).collect()
    }

    /// The candidates of an axis.
    fn along(&self, axis: &Axis) -> Vec<SceneCore> {
        let Requirements { input_fraction, output_fraction, .. } = self.requirements;
        let allowed = if axis.coarse { ACCURACY_INPUT_FRACTION } else { INPUT_FRACTION };
        let inputs = Self::widths(self.keys.input_fraction, input_fraction.measured, allowed);
        let outputs = Self::widths(self.keys.output_fraction, output_fraction.measured, OUTPUT_FRACTION);
        let with = |input: u32, output: u32| SpecFields {
            input_fraction: Some(input),
            output_fraction: Some(output),
            ..axis.fields.clone()
        };
        let draw = |own: &SpecFields| self.fields(own).and_then(|fields| self.draw(fields));
        if axis.coarse {
            return self.coarse(&inputs, &outputs, &with, &draw);
        }
        let (Some(&most_in), Some(&most_out)) = (inputs.last(), outputs.last()) else { return Vec::new() };
        let Some(finest) = draw(&with(most_in, most_out)) else { return Vec::new() };
        let octaves: f64 = self.missed(&finest).iter().map(|(octaves, _)| octaves).sum();
        let mut drawn = vec![finest];
        if octaves <= HOPELESS {
            let pairs = inputs.iter().flat_map(|&input| outputs.iter().map(move |&output| (input, output)));
            let others: Vec<(u32, u32)> = pairs.filter(|&pair| pair != (most_in, most_out)).collect();
            drawn.par_extend(others.into_par_iter().filter_map(|(input, output)| draw(&with(input, output))));
        }
        drawn
    }

    /// The coarse exact lobes: the least accuracy that keeps the budget, from below, then with fewer fraction bits. An
    /// accuracy of one bit more halves the error, so that the first guess, from the budget, is nearly right; a core
    /// takes seconds to build.
    fn coarse(
        &self,
        inputs: &[u32],
        outputs: &[u32],
        with: &(dyn Fn(u32, u32) -> SpecFields + Sync),
        draw: &(dyn Fn(&SpecFields) -> Option<SceneCore> + Sync),
    ) -> Vec<SceneCore> {
        let middle = |all: &[u32]| all.get(1).or(all.first()).copied();
        let (Some(input), Some(output)) = (middle(inputs), middle(outputs)) else { return Vec::new() };
        // An accuracy is at most G - 1.
        let fine = |accuracy: u32, output: u32| match self.keys.output_fraction {
            Some(given) => given,
            None => output.max(accuracy + 1),
        };
        let at = |accuracy: u32, input: u32, output: u32| {
            draw(&SpecFields { accuracy: Some(accuracy), ..with(input, fine(accuracy, output)) })
        };
        let mut drawn = Vec::new();
        let found = match self.keys.accuracy {
            Some(given) => Some(given).filter(|&given| {
                drawn.extend(at(given, input, output));
                drawn.last().is_some_and(|core| self.keeps(core))
            }),
            None => {
                let full = self.scene.full_scale();
                let strongest = self.requirements.rows.iter().map(|row| row.weight * full).fold(0.0, f64::max);
                let steps = self.requirements.budget.steps(self.scene.channel_bits).max(0.01);
                let guess = libm::ceil(libm::log2((strongest / steps).max(1.0))) as u32;
                let mut accuracy = guess.saturating_sub(1).clamp(*ACCURACY.start(), *ACCURACY.end());
                let (mut best, mut failed) = (None, None);
                while let Some(core) = at(accuracy, input, output) {
                    let keeps = self.keeps(&core);
                    drawn.push(core);
                    let next = if keeps {
                        best = Some(accuracy);
                        accuracy - 1
                    } else {
                        failed = Some(accuracy);
                        accuracy + 1
                    };
                    if !ACCURACY.contains(&next) || Some(next) == best || Some(next) == failed {
                        break;
                    }
                    accuracy = next;
                }
                best
            }
        };
        if let Some(accuracy) = found {
            let mut pairs: Vec<(u32, u32)> = Vec::new();
            for &input in &inputs[..inputs.len().min(2)] {
                for &output in &outputs[..outputs.len().min(2)] {
                    let pair = (input, fine(accuracy, output));
                    if !pairs.contains(&pair) {
                        pairs.push(pair);
                    }
                }
            }
            pairs.retain(|&pair| pair != (input, fine(accuracy, output)));
            drawn.par_extend(pairs.into_par_iter().filter_map(|(input, output)| at(accuracy, input, output)));
        }
        drawn
    }

    /// All candidates, in the order of their ids. `progress` is told how many of how many methods are done.
    #[must_use]
    pub fn candidates(&self, progress: &(dyn Fn(usize, usize) + Sync)) -> Vec<SceneCore> {
        let axes: Vec<Axis> = self.axes();
        let finished = AtomicUsize::new(0);
        // The slowest first.
        let mut order: Vec<usize> = (0..axes.len()).collect();
        order.sort_by_key(|&place| !axes[place].coarse);
        let parts: Vec<Vec<SceneCore>> = order
            .into_par_iter()
            .map(|place| {
                let drawn = self.along(&axes[place]);
                progress(finished.fetch_add(1, Ordering::Relaxed) + 1, axes.len());
                drawn
            })
            .collect();
        let mut all = parts.concat();
        all.sort_by(|a, b| a.candidate.point.id.cmp(&b.candidate.point.id));
        all.dedup_by(|a, b| a.candidate.point.id == b.candidate.point.id);
        all
    }
}
