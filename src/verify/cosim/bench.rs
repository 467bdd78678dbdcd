//! What the external simulators share: compiling a core with its bench, and judging what the bench says.

use std::process::Output;

use super::{Job, LISTED, Outcome};
use crate::core::Design;
use crate::emit::package;
use crate::platform::error::Error;
use crate::platform::tool::{Tool, tail};
use crate::platform::transient::Folder;
use crate::spec::Language;

/// What of a core's directory is run, each by its own bench.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The core.
    Core,
    /// Its sequencer.
    Lights,
    /// Its table of lights.
    Table,
    /// Its wrapper with AXI4-Stream interfaces.
    Axis,
}

impl Part {
    /// What there is of a core.
    pub fn of(design: &Design) -> Vec<Self> {
        let lights = design.sums().map(|_| Self::Lights);
        let table = design.light_table().map(|_| Self::Table);
        let axis = design.spec.axi_stream.map(|_| Self::Axis);
        std::iter::once(Self::Core).chain(lights).chain(table).chain(axis).collect()
    }

    /// What it is, and its bench.
    pub(super) fn nouns(self) -> [&'static str; 2] {
        match self {
            Self::Core => ["the core", "the core's bench"],
            Self::Lights => ["the sequencer", "the sequencer's bench"],
            Self::Table => ["the table of lights", "the table's bench"],
            Self::Axis => ["the AXI4-Stream wrapper", "the wrapper's bench"],
        }
    }

    /// What is compared, as [`Outcome::mode`] says it.
    fn mode(self) -> &'static str {
        match self {
            Self::Core => "golden vectors",
            Self::Lights => "golden vectors in sequence",
            Self::Table => "golden vectors through the table of lights",
            Self::Axis => "golden vectors through AXI4-Stream",
        }
    }

    /// The name of what it runs.
    pub(super) fn name(self, job: &Job) -> String {
        match self {
            Self::Core => job.design.spec.name.clone(),
            Self::Lights => format!("{}_lights", job.design.spec.name),
            Self::Table => format!("{}_table", job.design.spec.name),
            Self::Axis => format!("{}_axis", job.design.spec.name),
        }
    }

    /// The name of its own top.
    pub(super) fn top(self, job: &Job) -> String {
        format!("{}_tb", self.name(job))
    }

    /// The core and the bench, relative to the core's directory.
    pub(super) fn sources(self, job: &Job, language: Language) -> Vec<String> {
        let mut sources = package::rtl_paths(job.design, language);
        let own = Self::of(job.design).iter().position(|&part| part == self).map_or(1, |place| place + 1);
        sources.truncate(own);
        sources.push(match self {
            Self::Core => package::bench_path(job.design, language),
            Self::Lights => package::sequencer_bench_path(job.design, language),
            Self::Table => package::table_bench_path(job.design, language),
            Self::Axis => package::axis_bench_path(job.design, language),
        });
        sources
    }
}

/// Puts a copy of the core's sources and of the files that its bench reads into a directory, under their usual relative
/// paths: simulators and what they start read few names of directories as they are, those with spaces, quotes and other
/// letters among them.
pub(super) fn copied(job: &Job, scratch: Folder) -> Result<Folder, Error> {
    // A core without a memory has no folder for it.
    let rom = (!job.design.tables().is_empty()).then_some("rom");
    for part in ["rtl", "tb", "golden"].into_iter().chain(rom) {
        let target = scratch.path().join(part);
        std::fs::create_dir_all(&target).map_err(|error| Error::io("cannot make", &target, error))?;
        let source = job.directory.join(part);
        let entries = std::fs::read_dir(&source).map_err(|error| Error::io("cannot read", &source, error))?;
        for entry in entries.flatten().filter(|entry| entry.path().is_file()) {
            let to = target.join(entry.file_name());
            std::fs::copy(entry.path(), &to).map_err(|error| Error::io("cannot copy to", &to, error))?;
        }
    }
    Ok(scratch)
}

/// An outcome without a vector compared.
pub(super) fn failure(simulator: &str, job: &Job, part: Part, first: Vec<String>) -> Outcome {
    Outcome { first, ..Outcome::none(simulator, part.mode(), job.golden.vectors().len() as u64) }
}

/// The failed outcome of a compilation that did not succeed.
pub(super) fn compiled(simulator: &str, tool: Tool, output: &Output, job: &Job, part: Part) -> Option<Outcome> {
    (!output.status.success()).then(|| {
        let what = format!("{} does not compile the core ({}): {}", tool.program, output.status, tail(output, 12));
        failure(simulator, job, part, vec![what])
    })
}

/// Reads the bench's last line; without a whole one, or with another status than the line says, it failed.
pub(super) fn judge(simulator: &str, output: &Output, job: &Job, part: Part) -> Outcome {
    let name = part.name(job);
    let text = format!("{}\n{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    let marker = format!("brdfgen: {name}: ");
    let verdict = text.lines().rev().find_map(|line| line.split_once(&marker).map(|(_, rest)| rest.trim().to_owned()));
    let Some(verdict) = verdict else {
        let what = format!("the bench gave no verdict ({}): {}", output.status, tail(output, 12));
        return failure(simulator, job, part, vec![what]);
    };
    let number = |before: &str| -> Option<u64> {
        verdict.split(before).next()?.split_ascii_whitespace().next_back()?.parse().ok()
    };
    let (vectors, mismatches) = (number(" vectors compared"), number(" mismatches"));
    let said_pass = verdict.ends_with("PASS");
    let mut outcome = failure(simulator, job, part, Vec::new());
    let (Some(vectors), Some(mismatches)) = (vectors, mismatches) else {
        outcome.first = vec![format!("the bench's verdict is not understood: {verdict}")];
        return outcome;
    };
    (outcome.vectors, outcome.mismatches) = (vectors, mismatches);
    if said_pass != output.status.success() {
        outcome.first.push(format!("the bench says {verdict} and ends with {}", output.status));
    } else if !said_pass {
        let told = text.lines().filter_map(|line| line.split_once(&marker).map(|(_, rest)| rest.trim()));
        outcome.first.extend(told.filter(|line| *line != verdict).take(LISTED).map(str::to_owned));
        if outcome.first.is_empty() {
            outcome.first.push(verdict);
        }
    }
    outcome
}
