//! Runs a core in simulators and compares it with the model.
//!
//! Each [`Simulator`] runs a core's golden vectors; some run every input. None is believed on its exit status alone: it
//! must say how many vectors it compared, and that must be all of them.

mod bench;
mod builtin;
mod compiled;
mod exhaustive;
mod ghdl;
mod icarus;
mod lint;
mod mutants;
mod netlist;
mod sequence;
mod stream;
mod verilator;

pub use builtin::{Engine, Vectors, builtin_engine};
pub use exhaustive::exhaustive;
pub use lint::{Lint, LintStatus, lint};
pub(crate) use mutants::{AtRandom, Mutants};
pub use netlist::netlist;
pub use sequence::sequence;
pub use stream::stream;

use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::core::Design;
use crate::emit::package::Part;
use crate::platform::error::Error;
use crate::spec::Language;
use crate::verify::golden::{Golden, differences};

/// A simulator that brdfgen can use.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Sim {
    /// In this process: the rust-hdl kernel where there is one of the core's widths, else the datapath's pipeline.
    Builtin,
    /// Icarus Verilog.
    Icarus,
    /// Verilator.
    Verilator,
    /// GHDL.
    Ghdl,
    /// Every one that has a language of the core.
    All,
}

impl Sim {
    /// The simulators that this names, for a core in these languages.
    #[must_use]
    pub fn expand(self, languages: &[Language]) -> Vec<Self> {
        match self {
            Self::All => [Self::Builtin, Self::Icarus, Self::Verilator, Self::Ghdl]
                .into_iter()
                .filter(|sim| sim.language().is_none_or(|language| languages.contains(&language)))
                .collect(),
            one => vec![one],
        }
    }

    /// The language that it reads; the built-in one reads neither.
    #[must_use]
    pub fn language(self) -> Option<Language> {
        self.simulator().language()
    }

    fn simulator(self) -> Box<dyn Simulator> {
        match self {
            Self::Builtin | Self::All => Box::new(builtin::Builtin),
            Self::Icarus => Box::new(icarus::Icarus),
            Self::Verilator => Box::new(verilator::Verilator),
            Self::Ghdl => Box::new(ghdl::Ghdl),
        }
    }
}

/// A simulator that can run a core's golden vectors.
pub trait Simulator {
    /// Its name, for messages.
    fn name(&self) -> &'static str;

    /// The language that it reads, if it reads one.
    fn language(&self) -> Option<Language>;

    /// Runs the golden vectors with one of the core's benches; the built-in one has the core's only.
    ///
    /// # Errors
    /// If a program that it needs is not installed or cannot be started; a core that fails is an [`Outcome`].
    fn run(&self, job: &Job, part: Part) -> Result<Outcome, Error>;
}

/// A core on disk, with what it is compared with.
#[derive(Clone, Copy, Debug)]
pub struct Job<'a> {
    /// The core.
    pub design: &'a Design,
    /// Its golden vectors.
    pub golden: &'a Golden,
    /// Its directory, with `rtl/`, `tb/`, `rom/` and `golden/`.
    pub directory: &'a Path,
}

/// What a simulator found.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Outcome {
    /// What ran, such as "icarus" or "builtin (rust-hdl kernel)".
    pub simulator: String,
    /// What it ran, such as "golden vectors" or "every input".
    pub mode: &'static str,
    /// The vectors compared.
    pub vectors: u64,
    /// The vectors that should have been.
    pub expected_vectors: u64,
    /// The vectors that differ.
    pub mismatches: u64,
    /// The first differences, a line each, or what else went wrong.
    pub first: Vec<String>,
    /// The time it took, building included.
    pub seconds: f64,
}

impl Outcome {
    /// Nothing compared yet of so many vectors.
    fn none(simulator: &str, mode: &'static str, expected_vectors: u64) -> Self {
        let (simulator, first) = (simulator.to_owned(), Vec::new());
        Self { simulator, mode, vectors: 0, expected_vectors, mismatches: 0, first, seconds: 0.0 }
    }

    /// Whether every vector was compared and none differs.
    #[must_use]
    pub fn passed(&self) -> bool {
        self.mismatches == 0 && self.vectors > 0 && self.vectors == self.expected_vectors && self.first.is_empty()
    }
}

/// Differences that are listed in full; more are counted.
pub const LISTED: usize = 10;

/// The golden file against the model: what the simulators are compared with must be right itself.
#[must_use]
pub fn model(job: &Job) -> Outcome {
    let start = std::time::Instant::now();
    let expected = Golden::of(job.design);
    let found = differences(job.design, &expected, job.golden);
    let count = expected.vectors().len() as u64;
    Outcome {
        simulator: "model".to_owned(),
        mode: "golden vectors",
        vectors: count,
        expected_vectors: count,
        mismatches: found.len() as u64,
        first: found.iter().take(LISTED).map(ToString::to_string).collect(),
        seconds: start.elapsed().as_secs_f64(),
    }
}

/// Runs the golden vectors through a simulator.
///
/// # Errors
/// A simulator that is not installed, or a language that the core does not have.
pub fn golden(sim: Sim, job: &Job) -> Result<Outcome, Error> {
    run(sim, job, Part::Core)
}

/// Runs the golden vectors through what is around the core, with pauses: its sequencer, and its wrapper with
/// AXI4-Stream interfaces with stalls of both sides. Nothing of a core without them, and of the built-in simulator,
/// which steps the datapath and not their HDL.
///
/// # Errors
/// As [`golden`].
pub fn around(sim: Sim, job: &Job) -> Result<Vec<Outcome>, Error> {
    if sim.language().is_none() {
        return Ok(Vec::new());
    }
    Part::of(job.design).into_iter().skip(1).map(|part| run(sim, job, part)).collect()
}

fn run(sim: Sim, job: &Job, part: Part) -> Result<Outcome, Error> {
    if let Some(language) = sim.language() {
        has_language(job, language)?;
    }
    let start = std::time::Instant::now();
    let mut outcome = sim.simulator().run(job, part)?;
    outcome.seconds = start.elapsed().as_secs_f64();
    Ok(outcome)
}

fn has_language(job: &Job, language: Language) -> Result<(), Error> {
    if job.design.spec.languages.contains(&language) {
        return Ok(());
    }
    Err(Error::input(
        format!("the core {} has no {language}", job.design.spec.name),
        "generate it with that language, or choose another simulator",
    ))
}
