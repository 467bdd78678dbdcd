//! The core that a scene needs: the cheapest whose pictures keep the budget.
//!
//! Candidates are the methods of the crate, each with its coefficients and with a few fraction bits of input and output
//! around the fewest that any core can do with ([`Requirements`]). Every candidate draws the scene's pictures through
//! its bit-exact arithmetic.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use serde::Serialize;

use super::highlight::{CoreModel, Exact};
use super::require::{PictureError, ShininessRow};
use super::slots::{Slots, Vectorised};
use super::{Difference, Highlights, Requirements, Scene};
use crate::core::{Design, Measured};
use crate::emit::package::counted;
use crate::explore::choose::{Candidate, MISSES, NearMiss, Ranking, Standing, too_slow};
use crate::explore::run::Costing;
use crate::explore::sweep::Core;
use crate::explore::{Cost, Model, Objective, Point, Results};
use crate::fixed::exp2;
use crate::platform::error::{Error, refuse};
use crate::spec::{BlockKind, SpecFields};
use crate::synth::{self, Tools};
use crate::target::Family;

/// The runner-ups that a choice names.
pub const RUNNER_UPS: usize = 6;
/// The cores that are synthesised, where costs are synthesised: so many of those that are cheapest by the cost model.
const SHORTLIST: usize = 8;

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
    /// The root of the mean square of result - `x^n` over the lit samples of the base picture: what the scene meets of
    /// the lobe's error.
    pub lobe_rms: f64,
    /// The largest error in output steps that any view of these materials under these lights can have before the
    /// channel is rounded: the largest over the rows of `sum(k_s I) full (max |result - x^n| + n 2^-(F+1))`, the
    /// bracket at most 1, as result and lobe lie in [0, 1].
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
    pub misses: Vec<NearMiss<SceneCore>>,
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

/// What of a port decides which codes the samples come to.
type PortKey = (u32, bool, i128, i128);

/// The search for a scene's core.
pub struct Search<'a> {
    pub(super) scene: &'a Scene,
    pub(super) requirements: &'a Requirements,
    costing: &'a Costing,
    /// The cost model by which cores are ranked before any is synthesised, and the family whose it is.
    screen: (Model, Family),
    pub(super) keys: SpecFields,
    slots: Mutex<BTreeMap<PortKey, Arc<Slots>>>,
}

impl<'a> Search<'a> {
    /// Prepares the search; `keys` narrow it beside those of the scene's `[core]`, over which they win.
    ///
    /// # Errors
    /// A scene without any highlight, keys that make no lobe, or a family without a cost model where costs are to be
    /// estimated.
    pub fn new(
        scene: &'a Scene,
        requirements: &'a Requirements,
        costing: &'a Costing,
        keys: &SpecFields,
    ) -> Result<Self, Error> {
        refuse!(
            requirements.rows.is_empty(),
            format!("the scene {} needs no core: no highlight falls on any pixel", scene.name),
            "give a material that objects have a k_s above 0, or move a light or the camera"
        );
        let keys = keys.clone().or(scene.core.keys.clone());
        if let Some(kind) = keys.block.filter(|&kind| kind != BlockKind::Lobe) {
            let what = format!("a scene's core is chosen among lobes, and {} is asked for", kind.noun());
            return Err(Error::input(what, "leave `block` out"));
        }
        refuse!(
            keys.shininess.is_some() || keys.material.is_some() || keys.shininess_fraction.is_some(),
            "a scene's core serves the shininesses of the scene",
            "leave shininess, shininess_fraction and material out"
        );
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
                let screened = if model.of(family).is_ok() { family } else { Family::default() };
                (model, screened)
            }
        };
        Ok(Self { scene, requirements, costing, screen, keys, slots: Mutex::default() })
    }

    fn slots(&self, design: &Design) -> Arc<Slots> {
        let format = design.lobe().operand_format();
        let key = (
            design.lobe().interface.input_fraction,
            design.lobe().takes_versine(),
            format.min_code(),
            format.max_code(),
        );
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
    pub(super) fn draw(&self, fields: SpecFields) -> Option<SceneCore> {
        let design = Design::new(fields.resolve().ok()?).ok()?;
        let (measured, by_row) = Measured::with_rows(design.lobe());
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
        let full = self.scene.full_scale();
        let half_step = exp2(-(design.lobe().interface.input_fraction as i32) - 1);
        let bound = |(row, own): (&ShininessRow, &f64)| row.weight * full * (own + row.shininess * half_step).min(1.0);
        let guarantee = self.requirements.rows.iter().zip(&by_row).map(bound).fold(0.0, f64::max);
        let lobe_rms = if count == 0 { 0.0 } else { (sum / count as f64).sqrt() };
        Some(SceneCore { candidate: Candidate { point, cost }, base, moved, lobe_rms, guarantee })
    }

    pub(super) fn missed(&self, core: &SceneCore) -> Vec<(f64, String)> {
        let budget = &self.requirements.budget;
        let mut missed = budget.missed(&core.base, "the picture");
        missed.extend(budget.missed(&core.moved, "a moved picture"));
        missed
    }

    pub(super) fn keeps(&self, core: &SceneCore) -> bool {
        self.missed(core).is_empty()
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
        refuse!(
            all.is_empty(),
            "no core can be built with these keys for this scene",
            "leave some of the keys of [core], or of the flags, out"
        );
        let (considered, min_mhz) = (all.len(), self.scene.core.min_mhz);
        let mut meeting = self.ranked(all.clone(), min_mhz).meeting.len();
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
        let Ranking { meeting: ranked, misses } = self.ranked(all, min_mhz);
        let mut ranked = ranked.into_iter();
        let chosen = ranked.next();
        let others: Vec<SceneCore> = ranked.collect();
        let runner_ups = chosen.as_ref().map(|chosen| self.runner_ups(chosen, &others)).unwrap_or_default();
        let misses = misses.into_iter().take(MISSES).collect();
        let estimated = matches!(self.costing, Costing::Estimate(_));
        Ok(SceneChoice { chosen, runner_ups, others, misses, considered, meeting, estimated, tools })
    }

    /// Takes another core in place of the chosen one, one of the others; the dearer ones are left as runners-up.
    /// `refused` are those that do not do after all, with why.
    pub fn take(&self, choice: &mut SceneChoice, core: &SceneCore, refused: Vec<NearMiss<SceneCore>>) {
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

    /// Draws all pictures of the scene through the bit-exact model of a core and through its vectorised arithmetic, the
    /// base picture whole, sample by sample, and says how they differ from the exact ones.
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
                let exact = frame.picture(self.scene, &Exact.of(self.scene, frame)?);
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
