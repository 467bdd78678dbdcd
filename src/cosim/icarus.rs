//! Icarus Verilog.

use super::{Job, Outcome, Simulator, bench};
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

    fn golden(&self, job: &Job) -> Result<Outcome, Error> {
        let scratch = tool::scratch()?;
        let program = scratch.path().join("core.vvp");
        let mut compile = IVERILOG.command(job.directory);
        compile.args(["-g2005", "-Wall", "-o"]).arg(&program).args(bench::sources(job, Language::Verilog));
        if let Some(failed) = bench::compiled(self.name(), IVERILOG, &IVERILOG.output(&mut compile)?, job) {
            return Ok(failed);
        }
        let mut run = VVP.command(job.directory);
        run.arg("-n").arg(&program);
        Ok(bench::judge(self.name(), &VVP.output(&mut run)?, job))
    }
}
