//! GHDL.

use std::path::Path;

use super::tool::GHDL;
use super::{Job, Outcome, Simulator, bench};
use crate::error::Error;
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

    fn golden(&self, job: &Job) -> Result<Outcome, Error> {
        let scratch = bench::scratch()?;
        let options = ["--std=08".to_owned(), format!("--workdir={}", scratch.path().display())];
        let top = format!("{}_tb", job.design.spec.name);
        let mut analyse = GHDL.command(job.directory);
        analyse.arg("-a").args(&options).args(bench::sources(job, Language::Vhdl));
        if let Some(failed) = bench::compiled(self.name(), GHDL, &GHDL.output(&mut analyse)?, job) {
            return Ok(failed);
        }
        let mut run = GHDL.command(job.directory);
        run.arg("--elab-run").args(&options).arg(&top);
        // With a compiling back end GHDL leaves an executable in the current directory: let it be the scratch one.
        run.current_dir(scratch.path());
        link_core(job.directory, scratch.path())?;
        Ok(bench::judge(self.name(), &GHDL.output(&mut run)?, job))
    }
}

/// Makes the files that a bench reads visible in `scratch` under their usual relative paths.
fn link_core(core: &Path, scratch: &Path) -> Result<(), Error> {
    for part in ["golden", "rom"] {
        let target = scratch.join(part);
        std::fs::create_dir_all(&target).map_err(|error| Error::io("cannot make", &target, error))?;
        let source = core.join(part);
        let entries = std::fs::read_dir(&source).map_err(|error| Error::io("cannot read", &source, error))?;
        for entry in entries.flatten().filter(|entry| entry.path().is_file()) {
            let to = target.join(entry.file_name());
            std::fs::copy(entry.path(), &to).map_err(|error| Error::io("cannot copy to", &to, error))?;
        }
    }
    Ok(())
}
