//! The error and the cost of many cores, a few at a time.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use rayon::ThreadPool;
use serde::Serialize;

use super::point::NO_CORE;
use super::store::Provenance;
use super::sweep::Core;
use super::{Cost, Model, Point, Results, Shape, Store};
use crate::core::Design;
use crate::method::word;
use crate::platform::error::Error;
use crate::synth::{self, Options};
use crate::target::Family;

/// How costs are found.
#[derive(Clone, Debug)]
pub enum Costing {
    /// By synthesis, and by placement where the family has one.
    Synthesis(Flow),
    /// By a cost model.
    Estimate(Model),
}

/// How cores are synthesised, for all families.
#[derive(Clone, Debug, PartialEq)]
pub struct Flow {
    /// How many seeds the placement is done with.
    pub seeds: u32,
    /// The clock that the placement is asked for, in MHz; `None` is the family's own.
    pub target_mhz: Option<f64>,
    /// Whether cores are placed.
    pub place: bool,
    /// Whether registers are moved into DSP blocks and block RAMs, as [`Options::pack`].
    pub pack: bool,
    /// Yosys, as [`Options::yosys`].
    pub yosys: Option<String>,
    /// The folder where results are kept; `None` keeps none.
    pub cache: Option<PathBuf>,
}

/// What a run did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Summary {
    /// Points that were there already.
    pub kept: usize,
    /// Points made.
    pub made: usize,
    /// Cores among them that cannot be built.
    pub no_core: usize,
    /// Points among them at which a tool failed.
    pub failed: usize,
    /// Points that failed in an earlier run and were not tried again.
    pub failed_before: usize,
}

impl Default for Flow {
    /// Three seeds, each family's own clock, and results that are kept.
    fn default() -> Self {
        let cache = Some(synth::default_cache());
        Self { seeds: 3, target_mhz: None, place: true, pack: true, yosys: None, cache }
    }
}

impl Flow {
    /// The options for a family.
    #[must_use]
    pub fn options(&self, family: Family) -> Options {
        let defaults = Options::new(family);
        Options {
            seeds: self.seeds,
            target_mhz: self.target_mhz.unwrap_or(defaults.target_mhz),
            place: self.place,
            pack: self.pack,
            yosys: self.yosys.clone(),
            cache: self.cache.clone(),
            ..defaults
        }
    }
}

impl Costing {
    /// By the cost model that the results of the program give.
    ///
    /// # Errors
    /// None in a program whose results are whole.
    pub fn built_in() -> Result<Self, Error> {
        Ok(Self::Estimate(Model::fit(&Results::built_in()?)?))
    }

    /// What makes the figures of these cores.
    ///
    /// # Errors
    /// A tool that is not installed, or a family that the model was not fitted for.
    pub fn provenance(&self, cores: &[Core]) -> Result<Provenance, Error> {
        let families: BTreeSet<Family> = cores.iter().map(|core| core.family).collect();
        let mut tools = BTreeMap::new();
        for family in families {
            let of_family = match self {
                Self::Synthesis(flow) => synth::tools(&flow.options(family))?,
                Self::Estimate(model) => model.tools(family)?.clone(),
            };
            tools.insert(word(&family), of_family);
        }
        let costing = match self {
            Self::Synthesis(Flow { place: false, .. }) => "synthesis without placement".to_owned(),
            Self::Synthesis(Flow { seeds, target_mhz, .. }) => match target_mhz {
                None => format!("synthesis and placement with {seeds} seeds"),
                Some(mhz) => format!("synthesis and placement with {seeds} seeds for {mhz} MHz"),
            },
            Self::Estimate(model) => format!("estimates by the model {}", model.digest()),
        };
        let packed = match self {
            Self::Synthesis(Flow { pack: false, .. }) => ", registers left outside of blocks",
            _ => "",
        };
        let costing = costing + packed;
        Ok(Provenance { program: env!("CARGO_PKG_VERSION").to_owned(), costing, tools })
    }

    /// What a core takes.
    ///
    /// # Errors
    /// A family without a cost model, or a tool that is missing or fails.
    pub fn cost(&self, design: &Design, family: Family) -> Result<Cost, Error> {
        let latency = design.whole_latency();
        Ok(match self {
            Self::Estimate(model) => Cost::estimated(&model.estimate(family, &Shape::of(design))?, latency),
            Self::Synthesis(flow) => Cost::measured(&synth::synthesise(design, &flow.options(family))?, latency),
        })
    }

    /// The point of a core. What is wrong with the core is in it; what is wrong with the machine is an error.
    fn point(&self, core: &Core, pool: &ThreadPool) -> Result<Point, Error> {
        let measured =
            pool.install(|| Design::new(core.spec.clone()).map(|design| (Point::measured(core, &design), design)));
        let (point, design) = match measured {
            Ok(measured) => measured,
            Err(error) => {
                return Ok(Point { failure: Some(format!("{NO_CORE}{error}")), ..Point::unmeasured(core) });
            }
        };
        match self {
            Self::Estimate(model) => {
                let estimate = model.estimate(core.family, &point.shape)?;
                Ok(Point { estimate: Some(estimate), ..point })
            }
            Self::Synthesis(flow) => match synth::synthesise(&design, &flow.options(core.family)) {
                Ok(synthesis) => Ok(Point { synthesis: Some(synthesis), ..point }),
                Err(error @ (Error::ToolFailed { .. } | Error::TimeLimit { .. })) => {
                    Ok(Point { failure: Some(in_full(&error)), ..point })
                }
                Err(other) => Err(other),
            },
        }
    }
}

/// An error's message with what a tool printed.
fn in_full(error: &Error) -> String {
    match error {
        Error::ToolFailed { output, .. } => format!("{error}\n{output}"),
        other => other.to_string(),
    }
}

/// What becomes of points that failed before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Failed {
    /// They stay as they are.
    Keep,
    /// They are made anew.
    Retry,
}

/// Measures those of the cores that the store does not hold yet, `jobs` at a time, and puts each into it as soon as it
/// is there. `progress` is told of each point: how many are done,
/// of how many, and the point.
///
/// # Errors
/// A tool that is not installed, or a store that cannot be written; what was finished is in the store.
pub fn run(
    cores: &[Core],
    costing: &Costing,
    store: &mut Store,
    jobs: usize,
    failed: Failed,
    progress: &(dyn Fn(usize, usize, &Point) + Sync),
) -> Result<Summary, Error> {
    let known = store.known()?;
    let retries = failed == Failed::Retry;
    let wanted: Vec<&Core> =
        cores.iter().filter(|core| known.get(&core.id).is_none_or(|&has_failed| has_failed && retries)).collect();
    let failed_before = cores.iter().filter(|core| known.get(&core.id) == Some(&true)).count();
    let mut summary = Summary { kept: cores.len() - wanted.len(), ..Summary::default() };
    summary.failed_before = if retries { 0 } else { failed_before };
    // The measurement of one core shares these threads with that of the others.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(jobs).build();
    let pool = pool.map_err(|error| Error::input(format!("{jobs} threads: {error}"), "use fewer --jobs"))?;
    let next = AtomicUsize::new(0);
    let stopped = AtomicBool::new(false);
    let shared = Mutex::new((store, summary, None));
    std::thread::scope(|scope| {
        for _ in 0..jobs.min(wanted.len()) {
            scope.spawn(|| {
                while !stopped.load(Ordering::Relaxed) {
                    let Some(core) = wanted.get(next.fetch_add(1, Ordering::Relaxed)) else { break };
                    let made = costing.point(core, &pool);
                    let mut shared = shared.lock().unwrap_or_else(PoisonError::into_inner);
                    let (store, summary, error) = &mut *shared;
                    match made.and_then(|point| store.put(&point).map(|()| point)) {
                        Ok(point) => {
                            summary.made += 1;
                            summary.failed += usize::from(point.is_to_retry());
                            summary.no_core += usize::from(point.failure.is_some() && !point.is_to_retry());
                            progress(summary.made, wanted.len(), &point);
                        }
                        Err(first) => {
                            stopped.store(true, Ordering::Relaxed);
                            error.get_or_insert(first);
                        }
                    }
                }
            });
        }
    });
    let (_, summary, error) = shared.into_inner().unwrap_or_else(PoisonError::into_inner);
    error.map_or(Ok(summary), Err)
}
