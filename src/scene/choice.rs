//! The core that a scene needs: the cheapest whose pictures keep the budget.
//!
//! Candidates are the methods of the crate, each with its coefficients and with a few fraction bits of input and output around the fewest
//! that any core can do with ([`Requirements`]). Every candidate draws the scene's pictures through its bit-exact arithmetic.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use clap::ValueEnum;
use rayon::prelude::*;
use serde::Serialize;

use super::highlight::{Codes, CoreModel};
use super::require::PictureError;
use super::{Difference, Frame, Highlights, Requirements, Scene};
use crate::core::{Design, Measured};
use crate::emit::package::counted;
use crate::explore::choose::{Candidate, MISSES, Ranking, Standing, too_slow};
use crate::explore::run::Costing;
use crate::explore::sweep::Core;
use crate::explore::{Cost, Model, Objective, Point, Results};
use crate::fit;
use crate::fixed::exp2;
use crate::method::log_exp::{ACCURACY, ACCURACY_INPUT_FRACTION};
use crate::method::table::TABLE_BITS;
use crate::platform::error::Error;
use crate::spec::{
    Coefficients, Divider, INPUT_FRACTION, InputRange, Inside, Material, MethodName, OUTPUT_FRACTION, SpecFields, Tail,
};
use crate::synth::{self, Family, Tools};

/// The runner-ups that a choice names.
pub const RUNNER_UPS: usize = 6;
/// The cores that are synthesised, where costs are synthesised: so many of those that are cheapest by the cost model.
const SHORTLIST: usize = 8;
/// Fraction bits of a port that are tried, from the fewest that any core can do with.
const WIDTHS: u32 = 3;
/// The fewest fraction bits that are tried of a port of which no number is enough.
const UNMET_WIDTH: u32 = 18;
/// A method that misses the budget by more octaves than this with the most fraction bits is not tried with fewer.
const HOPELESS: f64 = 1.0;
/// The widest gap, in codes, that is evaluated too and passed over.
const GAP: i64 = 512;

/// A core with its cost and with what it makes of the scene's pictures.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SceneCore {
    /// The core and its cost.
    #[serde(flatten)]
    pub candidate: Candidate,
    /// The error of the base picture.
    pub base: PictureError,
    /// The worst error of a moved picture.
    pub moved: PictureError,
    /// The root of the mean square of result - `x^n` over the lit samples of the base picture: what the scene meets of the lobe's error.
    pub lobe_rms: f64,
    /// The largest error in output steps that any view of these materials under these lights can have before the channel is rounded: the
    /// largest over the rows of `sum(k_s I) full (max |result - x^n| + n 2^-(F+1))`, the bracket at most 1, as result and lobe lie in [0, 1].
    pub guarantee: f64,
}

/// A core that keeps the budget and is not chosen.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RunnerUp {
    /// The core.
    #[serde(flatten)]
    pub core: SceneCore,
    /// Why it is not chosen.
    pub why: String,
}

/// A core that does not keep the budget or is too slow.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NearMiss {
    /// The core.
    #[serde(flatten)]
    pub core: SceneCore,
    /// How far it misses: the sum of log2 of value / allowed over what it misses.
    pub octaves: f64,
    /// What it misses, and by how much.
    pub why: Vec<String>,
}

/// The outcome.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SceneChoice {
    /// The cheapest core that keeps the budget.
    pub chosen: Option<SceneCore>,
    /// The next ones: the cheapest of each other method or way of coefficients first, each group the cheapest first.
    pub runner_ups: Vec<RunnerUp>,
    /// All others that keep the budget, the cheapest first.
    #[serde(skip)]
    pub others: Vec<SceneCore>,
    /// The nearest misses, the nearest first.
    pub misses: Vec<NearMiss>,
    /// How many cores drew the pictures.
    pub considered: usize,
    /// How many of them keep the budget and the frequency by the cost model.
    pub meeting: usize,
    /// Whether the costs are estimates.
    pub estimated: bool,
    /// The tools that the costs are of.
    pub tools: Option<Tools>,
}

impl SceneCore {
    /// The greatest number of output steps by which a channel of any view can be off.
    #[must_use]
    pub fn guaranteed_steps(&self) -> u32 {
        // Codes of values less than e apart are at most the next whole number apart.
        libm::ceil(self.guarantee - 1e-9) as u32
    }

    /// Its spec.
    ///
    /// # Errors
    /// A point of another version of the program.
    pub fn spec(&self) -> Result<SpecFields, Error> {
        SpecFields::parse(&self.candidate.point.spec, &self.candidate.point.id)
    }
}

/// The codes that the scene's pictures ask for of cores with one kind of port: each row's distinct operands once.
struct Slots {
    /// The code of `in_n` of each row that is asked for, its operands' codes, ascending, and how many come before them.
    rows: Vec<(u32, Vec<i64>, usize)>,
    /// For each picture the place of each sample's code among all of them; `NONE` where the light gives no highlight.
    places: Vec<Vec<u32>>,
}

impl Slots {
    const NONE: u32 = u32::MAX;

    fn of<'a>(design: &Design, scene: &Scene, frames: impl Iterator<Item = &'a Frame> + Clone) -> Self {
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
    fn results(&self, design: &Design) -> Vec<f64> {
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

    fn highlights(&self, view: usize, results: &[f64]) -> Vec<f64> {
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

/// What of a port decides which codes the samples come to.
type PortKey = (u32, bool, i128, i128);

/// The search for a scene's core.
pub struct Search<'a> {
    scene: &'a Scene,
    requirements: &'a Requirements,
    costing: &'a Costing,
    /// The cost model by which cores are ranked before any is synthesised, and the family whose it is.
    screen: (Model, Family),
    keys: SpecFields,
    slots: Mutex<BTreeMap<PortKey, Arc<Slots>>>,
}

/// What candidates have in common but for the fraction bits.
#[derive(Clone, Debug)]
struct Axis {
    fields: SpecFields,
    /// Whether the accuracy is yet to be found.
    coarse: bool,
}

impl<'a> Search<'a> {
    /// Prepares the search; `keys` narrow it beside those of the scene's `[core]`, over which they win.
    ///
    /// # Errors
    /// A scene without any highlight, keys that make no lobe, or a family without a cost model where costs are to be estimated.
    pub fn new(
        scene: &'a Scene,
        requirements: &'a Requirements,
        costing: &'a Costing,
        keys: &SpecFields,
    ) -> Result<Self, Error> {
        if requirements.rows.is_empty() {
            return Err(Error::input(
                format!("the scene {} needs no core: no highlight falls on any pixel", scene.name),
                "give a material that objects have a k_s above 0, or move a light or the camera",
            ));
        }
        let keys = keys.clone().or(scene.core.keys.clone());
        if keys.block.is_some_and(|block| block != crate::spec::BlockKind::Lobe) {
            return Err(Error::input("a scene's core is chosen among lobes", "leave block = \"shader\" out"));
        }
        if keys.shininess.is_some() || keys.material.is_some() || keys.shininess_fraction.is_some() {
            return Err(Error::input(
                "a scene's core serves the shininesses of the scene",
                "leave shininess, shininess_fraction and material out",
            ));
        }
        let family = scene.core.family;
        let screen = match costing {
            Costing::Estimate(model) => {
                model.of(family).map_err(|error| {
                    Error::input(
                        error.to_string(),
                        "let the cores be synthesised, with --synth, or choose another family",
                    )
                })?;
                (model.clone(), family)
            }
            Costing::Synthesis(_) => {
                let model = Model::fit(&Results::built_in()?)?;
                let screened = [family, Family::Ecp5].into_iter().find(|&family| model.of(family).is_ok());
                (model, screened.unwrap_or(Family::Ecp5))
            }
        };
        Ok(Self { scene, requirements, costing, screen, keys, slots: Mutex::default() })
    }

    /// The keys that every candidate has unless others are given: the scene's name and materials, and a port for what occurs.
    fn common(&self) -> SpecFields {
        let material = |row: &super::require::Row| Material {
            name: row.name.clone(),
            shininess: row.shininess,
            ..Material::default()
        };
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
        let mut axes = Vec::new();
        for &method in MethodName::value_variants() {
            let about = method.about();
            if about.is_baseline && self.keys.method != Some(method) {
                continue;
            }
            let plain = SpecFields { method: Some(method), ..SpecFields::default() };
            let mut own = vec![plain.clone()];
            if !about.coefficients.is_empty() {
                own = Vec::new();
                for &coefficients in about.coefficients {
                    let with = SpecFields { coefficients: Some(coefficients), ..plain.clone() };
                    match coefficients {
                        Coefficients::Paper => own.push(with),
                        Coefficients::Minimax => own.extend(
                            objectives
                                .iter()
                                .map(|&objective| SpecFields { objective: Some(objective), ..with.clone() }),
                        ),
                    }
                }
            }
            let spread = |own: Vec<SpecFields>, set: &dyn Fn(SpecFields, usize) -> SpecFields, count: usize| {
                own.into_iter()
                    .flat_map(|one| (0..count).map(move |place| (one.clone(), place)))
                    .map(|(one, place)| set(one, place))
                    .collect::<Vec<_>>()
            };
            if about.has("tail") {
                let tails = [Tail::Cut, Tail::Hold];
                own = spread(own, &|one, place| SpecFields { tail: Some(tails[place]), ..one }, 2);
            }
            if about.has("inside") {
                let insides = [Inside::Linear, Inside::Quadratic];
                own = spread(own, &|one, place| SpecFields { inside: Some(insides[place]), ..one }, 2);
            }
            if about.has("divider") {
                let dividers = [Divider::Digit, Divider::Reciprocal];
                own = spread(own, &|one, place| SpecFields { divider: Some(dividers[place]), ..one }, 2);
            }
            if about.has("table_bits") {
                let (from, count) = (*TABLE_BITS.start() + 2, 9);
                own = spread(own, &|one, place| SpecFields { table_bits: Some(from + place as u32), ..one }, count);
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

    fn slots(&self, design: &Design) -> Arc<Slots> {
        let format = design.operand_format();
        let key = (design.spec.interface.input_fraction, design.takes_versine(), format.min_code(), format.max_code());
        let kept = |slots: &Mutex<BTreeMap<PortKey, Arc<Slots>>>| {
            slots.lock().unwrap_or_else(PoisonError::into_inner).get(&key).cloned()
        };
        // Not made under the lock: the threads that make it may take up another candidate meanwhile.
        kept(&self.slots).unwrap_or_else(|| {
            let frames = self.requirements.views.iter().map(|view| &view.lit);
            let made = Arc::new(Slots::of(design, self.scene, frames));
            let mut all = self.slots.lock().unwrap_or_else(PoisonError::into_inner);
            all.entry(key).or_insert(made).clone()
        })
    }

    /// Builds a core and lets it draw; none where none can be built.
    fn draw(&self, fields: SpecFields) -> Option<SceneCore> {
        let design = Design::new(fields.resolve().ok()?).ok()?;
        let (measured, by_row) = Measured::with_rows(&design);
        let core = Core::new(design.spec.clone(), self.scene.core.family);
        let point = Point::with_measured(&core, &design, &measured);
        let estimate = self.screen.0.estimate(self.screen.1, &point.shape).ok()?;
        let point = Point { estimate: Some(estimate), ..point };
        let cost = point.cost()?;

        let slots = self.slots(&design);
        let results = slots.results(&design);
        let [base, moved] = self.requirements.errors(self.scene, &|view| slots.highlights(view, &results));
        let (own, view) = (slots.highlights(0, &results), &self.requirements.views[0]);
        let lit = |(sample, _): &(usize, &f64)| !view.lit.versine[*sample].is_nan();
        let squares = own.iter().enumerate().filter(lit).map(|(sample, value)| {
            let off = value - view.lobes[sample];
            off * off
        });
        let (count, sum) = squares.fold((0u64, 0.0), |(count, sum), square| (count + 1, sum + square));
        let full = f64::from((1u32 << self.scene.channel_bits) - 1);
        let half_step = exp2(-(design.spec.interface.input_fraction as i32) - 1);
        let bound =
            |(row, own): (&super::require::Row, &f64)| row.weight * full * (own + row.shininess * half_step).min(1.0);
        let guarantee = self.requirements.rows.iter().zip(&by_row).map(bound).fold(0.0, f64::max);
        let lobe_rms = if count == 0 { 0.0 } else { (sum / count as f64).sqrt() };
        Some(SceneCore { candidate: Candidate { point, cost }, base, moved, lobe_rms, guarantee })
    }

    fn missed(&self, core: &SceneCore) -> Vec<(f64, String)> {
        let budget = &self.requirements.budget;
        let mut missed = budget.missed(&core.base, "the picture");
        missed.extend(budget.missed(&core.moved, "a moved picture"));
        missed
    }

    fn keeps(&self, core: &SceneCore) -> bool {
        self.missed(core).is_empty()
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

    /// The coarse exact lobes: the least accuracy that keeps the budget, from below, then with fewer fraction bits. An accuracy of one bit
    /// more halves the error, so that the first guess, from the budget, is nearly right; a core takes seconds to build.
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
                let full = f64::from((1u32 << self.scene.channel_bits) - 1);
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

    /// How a core stands in the choice.
    fn standing(&self, core: &SceneCore, min_mhz: Option<f64>) -> Standing {
        let mut missed = self.missed(core);
        missed.extend(too_slow(&core.candidate.cost, min_mhz));
        let steps = f64::from(core.base.max_steps.max(core.moved.max_steps));
        let errors = vec![core.base.mean_square.max(core.moved.mean_square), steps];
        Standing { cost: core.candidate.cost, errors, missed }
    }

    /// Ranks candidates.
    #[must_use]
    pub fn ranked(&self, all: Vec<SceneCore>, min_mhz: Option<f64>) -> Ranking<SceneCore> {
        Ranking::of(all, self.scene.core.objective, min_mhz, &|core| self.standing(core, min_mhz))
    }

    /// A core with its cost by the costing of the search.
    fn costed(&self, core: SceneCore) -> Result<SceneCore, Error> {
        let Costing::Synthesis(flow) = self.costing else { return Ok(core) };
        let design = Design::new(core.spec()?.resolve()?)?;
        let synthesis = synth::synthesise(&design, &flow.options(self.scene.core.family))?;
        let point = Point { synthesis: Some(synthesis), estimate: None, ..core.candidate.point.clone() };
        let cost = point.cost().unwrap_or(core.candidate.cost);
        Ok(SceneCore { candidate: Candidate { point, cost }, ..core })
    }

    /// The cost and the ROM's bits of a core, by the costing of the search.
    ///
    /// # Errors
    /// Fields that make no core, or a tool that fails.
    pub fn cost(&self, fields: &SpecFields) -> Result<(Cost, u64), Error> {
        let design = Design::new(fields.clone().resolve()?)?;
        let rom_bits = design.tables().iter().map(|table| table.bits() as u64).sum();
        let cost = self.costing.cost(&design, self.scene.core.family)?;
        Ok((cost, rom_bits))
    }

    /// Chooses the scene's core. `progress` is told what is done, how much of it and of how much.
    ///
    /// # Errors
    /// A tool that is missing or fails.
    pub fn choose(&self, progress: &(dyn Fn(&'static str, usize, usize) + Sync)) -> Result<SceneChoice, Error> {
        let mut all = self.candidates(&|done, of| progress("drawing the scene through cores", done, of));
        if all.is_empty() {
            return Err(Error::input(
                "no core can be built with these keys for this scene",
                "leave some of the keys of [core], or of the flags, out",
            ));
        }
        let (considered, wished) = (all.len(), self.scene.core.min_mhz);
        let mut meeting = self.ranked(all.clone(), wished).meeting.len();
        if let Costing::Synthesis(_) = self.costing {
            // The frequency is left to the synthesis.
            let Ranking { meeting: met, misses } = self.ranked(all, None);
            meeting = met.len();
            let few = met.into_iter().take(SHORTLIST).chain(misses.into_iter().take(MISSES).map(|miss| miss.core));
            let few: Vec<SceneCore> = few.collect();
            let of = few.len();
            all = Vec::with_capacity(of);
            for (place, core) in few.into_iter().enumerate() {
                progress("synthesising", place, of);
                all.push(self.costed(core)?);
            }
        }
        let tools = all.iter().find_map(|core| core.candidate.point.tools()).cloned();
        let Ranking { meeting: ranked, misses } = self.ranked(all, wished);
        let mut ranked = ranked.into_iter();
        let chosen = ranked.next();
        let others: Vec<SceneCore> = ranked.collect();
        let runner_ups = chosen.as_ref().map(|chosen| self.runner_ups(chosen, &others)).unwrap_or_default();
        let miss = |miss: crate::explore::choose::Missed<SceneCore>| NearMiss {
            core: miss.core,
            octaves: miss.octaves,
            why: miss.why,
        };
        let misses = misses.into_iter().take(MISSES).map(miss).collect();
        let estimated = matches!(self.costing, Costing::Estimate(_));
        Ok(SceneChoice { chosen, runner_ups, others, misses, considered, meeting, estimated, tools })
    }

    /// Takes another core in place of the chosen one, one of the others; the dearer ones are left as runners-up. `refused` are those that do
    /// not do after all, with why.
    pub fn take(&self, choice: &mut SceneChoice, core: &SceneCore, refused: Vec<NearMiss>) {
        let id = |core: &SceneCore| core.candidate.point.id.clone();
        let place = choice.others.iter().position(|other| id(other) == id(core)).map_or(0, |place| place + 1);
        choice.others.drain(..place);
        choice.runner_ups = self.runner_ups(core, &choice.others);
        choice.chosen = Some(core.clone());
        choice.misses.splice(0..0, refused);
        choice.misses.truncate(MISSES);
    }

    /// The cheapest of each other way, then more until there are enough.
    fn runner_ups(&self, chosen: &SceneCore, ranked: &[SceneCore]) -> Vec<RunnerUp> {
        let way = |core: &SceneCore| {
            let Point { method, coefficients, .. } = &core.candidate.point;
            let coarse = core.candidate.point.variant.split(' ').any(|pair| pair.starts_with("accuracy="));
            (method.clone(), coefficients.clone(), coarse)
        };
        let mut seen = vec![way(chosen)];
        let (mut first, mut rest) = (Vec::new(), Vec::new());
        for core in ranked {
            let own = way(core);
            if seen.contains(&own) {
                rest.push(core);
            } else {
                seen.push(own);
                first.push(core);
            }
        }
        let why = |core: &SceneCore| RunnerUp { why: self.dearer(chosen, core), core: core.clone() };
        first.into_iter().chain(rest).take(RUNNER_UPS).map(why).collect()
    }

    /// In what a core is behind the chosen one.
    fn dearer(&self, chosen: &SceneCore, core: &SceneCore) -> String {
        let (own, best) = (&core.candidate.cost, &chosen.candidate.cost);
        let objective = self.scene.core.objective;
        let more = |objective: Objective| (objective.of(own), objective.of(best), objective);
        let order = objective.order().map(more);
        let behind = order.into_iter().find(|(own, best, _)| own != best);
        match behind {
            Some((own, best, objective)) => format!("{} more", objective.counted(own.saturating_sub(best))),
            None if own.ff > best.ff => format!("{} more", counted(own.ff - best.ff, "flip-flop")),
            None => "as cheap, and no better in the picture".to_owned(),
        }
    }

    /// Draws all pictures of the scene through the bit-exact model of a core and through its vectorised arithmetic, the base picture
    /// whole, sample by sample, and says how they differ from the exact ones.
    ///
    /// # Errors
    /// The first sample that the two do not agree on: a fault of the program.
    pub fn verified(&self, design: &Design) -> Result<Verified, Error> {
        let Requirements { frame, views, pictures, .. } = self.requirements;
        let model = CoreModel::new(design)?;
        let mut samples = 0;
        let frames = std::iter::once(frame).chain(views.iter().skip(1).map(|view| &view.lit));
        let mut base = None;
        let mut moved = PictureError::default();
        for (place, frame) in frames.enumerate() {
            let own = model.of(self.scene, frame)?;
            let other = Vectorised(design).of(self.scene, frame)?;
            if let Some(sample) = (0..own.len()).find(|&sample| own[sample].to_bits() != other[sample].to_bits()) {
                return Err(Error::input(
                    format!(
                        "sample {sample} of the picture {}: the model says {} and the datapath {}",
                        pictures[place], own[sample], other[sample]
                    ),
                    "this is a fault of the program",
                ));
            }
            samples += frame.versine.iter().filter(|versine| !versine.is_nan()).count() as u64;
            if place == 0 {
                let exact = frame.picture(self.scene, &super::highlight::Exact.of(self.scene, frame)?);
                base = Some(Difference::of(&exact, &frame.picture(self.scene, &own)));
            } else {
                moved = moved.worst(views[place].error(self.scene, &own));
            }
        }
        let base = base.ok_or_else(|| Error::input("there is no picture", "this is a fault of the program"))?;
        Ok(Verified { samples, pictures: pictures.len(), base, moved })
    }
}

/// The scene's pictures through the bit-exact model of a core.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Verified {
    /// The samples on which model and datapath were found to agree: every lit one of every picture.
    pub samples: u64,
    /// The pictures.
    pub pictures: usize,
    /// How the base picture differs from the exact one.
    pub base: Difference,
    /// The worst of the moved pictures.
    pub moved: PictureError,
}

/// A level with two significant digits, below the given one: where exactly it lies does not matter, and a spec is for people too.
fn rounded_level(level: f64) -> f64 {
    let scale = libm::pow(10.0, 1.0 - libm::floor(libm::log10(level)));
    (libm::floor(level * scale) / scale).clamp(0.001, 0.99)
}
