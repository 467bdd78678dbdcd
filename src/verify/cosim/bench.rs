//! What the external simulators share: compiling a core with its bench, and judging what the bench says.

use std::process::Output;

use super::{Job, LISTED, Outcome};
use crate::emit::package::Part;
use crate::platform::error::Error;
use crate::platform::tool::{Tool, tail};
use crate::platform::transient::Folder;

/// What is compared where a part of a core is run by its own bench, as [`Outcome::mode`] says it.
fn mode(part: Part) -> &'static str {
    match part {
        Part::Core => "golden vectors",
        Part::Lights => "golden vectors in sequence",
        Part::Table => "golden vectors through the table of lights",
        Part::Axis => "golden vectors through AXI4-Stream",
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
    Outcome { first, ..Outcome::none(simulator, mode(part), job.golden.vectors().len() as u64) }
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
    let name = part.name(job.design);
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
