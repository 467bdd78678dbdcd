//! GHDL.

use std::path::Path;

use super::{Job, Outcome, Part, Simulator, bench};
use crate::error::Error;
use crate::spec::Language;
use crate::tool::{self, GHDL};

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
        let top = part.top(job);
        let mut analyse = GHDL.command(scratch.path());
        analyse.args(["-a", "--std=08"]).args(part.sources(job, Language::Vhdl));
        if let Some(failed) = bench::compiled(self.name(), GHDL, &GHDL.output(&mut analyse)?, job, part) {
            return Ok(failed);
        }
        let mut run = GHDL.command(scratch.path());
        run.args(["--elab-run", "--std=08", &top]);
        Ok(bench::judge(self.name(), &GHDL.output(&mut run)?, job, part))
    }
}

/// A VHDL core, the entity `top` in the file `source`, as Verilog by GHDL's synthesis. `directory` is the core's: a ROM file is read at
/// elaboration by its path relative to that.
///
/// # Errors
/// If GHDL is not installed or does not take the file.
pub(crate) fn as_verilog(top: &str, directory: &Path, source: &Path) -> Result<Vec<u8>, Error> {
    let scratch = tool::scratch()?;
    let source = std::path::absolute(source).map_err(|error| Error::io("cannot find", source, error))?;
    let mut command = GHDL.command(directory);
    command.args(["--synth", "--std=08", "--out=verilog"]).arg(format!("--workdir={}", scratch.path().display()));
    command.arg(source).args(["-e", top]);
    GHDL.succeed(&mut command)
}
