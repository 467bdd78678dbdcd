//! GHDL.

use super::{Job, Outcome, Part, Simulator, bench};
use crate::platform::error::Error;
use crate::platform::tool::{self, GHDL};
use crate::spec::Language;

/// GHDL.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ghdl;

impl Simulator for Ghdl {
    fn name(&self) -> &'static str {
        "ghdl"
    }

    fn language(&self) -> Option<Language> {
        Some(Language::Vhdl)
    }

    fn run(&self, job: &Job, part: Part) -> Result<Outcome, Error> {
        // A compiling back end leaves an executable in the current directory.
        let scratch = bench::copied(job, tool::scratch()?)?;
        let top = part.bench_name(job.design);
        let mut analyse = GHDL.command(scratch.path());
        analyse.args(["-a", "--std=08"]).args(part.paths_with_bench(job.design, Language::Vhdl));
        if let Some(failed) = bench::compiled(self.name(), GHDL, &GHDL.output(&mut analyse)?, job, part) {
            return Ok(failed);
        }
        let mut run = GHDL.command(scratch.path());
        run.args(["--elab-run", "--std=08", &top]);
        Ok(bench::judge(self.name(), &GHDL.output(&mut run)?, job, part))
    }
}
