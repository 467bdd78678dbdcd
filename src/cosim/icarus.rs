//! Icarus Verilog.

use super::{Job, Outcome, Part, Simulator, bench};
use crate::error::Error;
use crate::spec::Language;
use crate::tool::{self, IVERILOG, VVP};

/// Icarus Verilog.
#[derive(Clone, Copy, Debug)]
pub(super) struct Icarus;

impl Simulator for Icarus {
    fn name(&self) -> &'static str {
        "icarus"
    }

    fn language(&self) -> Option<Language> {
        Some(Language::Verilog)
    }

    fn run(&self, job: &Job, part: Part) -> Result<Outcome, Error> {
        let scratch = bench::copied(job, tool::scratch()?)?;
        let mut compile = IVERILOG.command(scratch.path());
        // Its driver puts temporary files there, by way of a shell.
        compile.env("TMPDIR", ".");
        compile.args(["-g2005", "-Wall", "-o", "core.vvp"]).args(part.sources(job, Language::Verilog));
        if let Some(failed) = bench::compiled(self.name(), IVERILOG, &IVERILOG.output(&mut compile)?, job, part) {
            return Ok(failed);
        }
        let mut run = VVP.command(scratch.path());
        run.args(["-n", "core.vvp"]);
        Ok(bench::judge(self.name(), &VVP.output(&mut run)?, job, part))
    }
}
