//! Verilator, with the generated bench.

use super::compiled::CORE;
use super::{Job, Outcome, Part, Simulator, bench};
use crate::platform::error::Error;
use crate::platform::tool::{self, VERILATOR};
use crate::spec::Language;

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

    fn run(&self, job: &Job, part: Part) -> Result<Outcome, Error> {
        let scratch = bench::copied(job, tool::scratch_for_make()?)?;
        let mut compile = VERILATOR.command(scratch.path());
        compile.args(["--binary", "--timing", "-Wno-fatal", "-O3", "-j", "2", "--Mdir", "obj_dir"]);
        compile.args(["--top-module", &part.bench_name(job.design), "-o", "bench"]);
        // A bench runs for a fraction of a second: its compiler's optimisation takes longer than it saves.
        compile.args(["-MAKEFLAGS", "OPT_FAST=-O0 OPT_GLOBAL=-O0 OPT_SLOW=-O0"]);
        compile.args(part.paths_with_bench(job.design, Language::Verilog));
        if let Some(failed) = bench::compiled(self.name(), VERILATOR, &VERILATOR.output(&mut compile)?, job, part) {
            return Ok(failed);
        }
        let mut run = tool::program(scratch.path().join("obj_dir").join("bench"));
        Ok(bench::judge(self.name(), &CORE.output(run.current_dir(scratch.path()))?, job, part))
    }
}
