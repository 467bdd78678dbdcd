//! Verilator, with the generated bench.

use super::{Job, Outcome, Simulator, bench};
use crate::error::Error;
use crate::spec::Language;
use crate::tool::{self, VERILATOR};

/// Verilator, with the generated bench.
#[derive(Clone, Copy, Debug)]
pub(super) struct Verilator;

impl Simulator for Verilator {
    fn name(&self) -> &'static str {
        "verilator"
    }

    fn language(&self) -> Option<Language> {
        Some(Language::Verilog)
    }

    fn golden(&self, job: &Job) -> Result<Outcome, Error> {
        let scratch = tool::scratch()?;
        let mut compile = VERILATOR.command(job.directory);
        compile.args(["--binary", "--timing", "-Wno-fatal", "-O3", "-j", "2", "--Mdir"]);
        compile.arg(scratch.path()).args(["--top-module", &format!("{}_tb", job.design.spec.name), "-o", "bench"]);
        compile.args(bench::sources(job, Language::Verilog));
        if let Some(failed) = bench::compiled(self.name(), VERILATOR, &VERILATOR.output(&mut compile)?, job) {
            return Ok(failed);
        }
        let mut run = std::process::Command::new(scratch.path().join("bench"));
        let output = run.current_dir(job.directory).output().map_err(|error| VERILATOR.start_error(error))?;
        Ok(bench::judge(self.name(), &output, job))
    }
}
