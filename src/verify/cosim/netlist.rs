//! A netlist of a family's cells in the core's place.

use std::time::Instant;

use super::{Job, Outcome, Part, bench, icarus};
use crate::emit::package;
use crate::platform::error::Error;
use crate::platform::tool;
use crate::spec::Language;
use crate::target::Models;

/// Runs the golden vectors through a netlist of a family's cells as Verilog such as [`crate::synth::netlist`] makes, by
/// the core's own bench, or that of its sequencer, in Icarus Verilog. A cell, or a setting of
/// one, without a model fails.
///
/// # Errors
/// Icarus is not installed, or the core has no Verilog bench; a netlist that fails is an [`Outcome`].
pub fn netlist(job: &Job, models: &Models, verilog: &[u8]) -> Result<Outcome, Error> {
    super::has_language(job, Language::Verilog)?;
    let start = Instant::now();
    let scratch = bench::copied(job, tool::scratch()?)?;
    let mut sources = Vec::new();
    for (name, bytes) in [("cells.v", models.verilog.as_bytes()), ("netlist.v", verilog)] {
        package::write_file(&scratch.path().join(name), bytes)?;
        sources.push(name.to_owned());
    }
    let part = Part::whole(job.design);
    sources.extend(part.bench_paths(job.design, Language::Verilog));
    // Icarus only warns of a parameter that a module does not have.
    let mut outcome = icarus::simulate(&scratch, &sources, &["warning: parameter "], job, part)?;
    outcome.mode = models.mode;
    outcome.seconds = start.elapsed().as_secs_f64();
    Ok(outcome)
}
