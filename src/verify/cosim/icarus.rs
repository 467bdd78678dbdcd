//! Icarus Verilog.

use super::{Job, LISTED, Outcome, Part, Simulator, bench};
use crate::platform::error::Error;
use crate::platform::tool::{self, IVERILOG, VVP};
use crate::platform::transient::Folder;
use crate::spec::Language;

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
        simulate(&scratch, &part.paths_with_bench(job.design, Language::Verilog), &[], job, part)
    }
}

/// Compiles these files of a directory, whose last one is a bench of this part of the core, and runs them. What the
/// compiler says with one of `fatal` in it is no mere warning.
pub(super) fn simulate(
    directory: &Folder,
    sources: &[String],
    fatal: &[&str],
    job: &Job,
    part: Part,
) -> Result<Outcome, Error> {
    let mut compile = IVERILOG.command(directory.path());
    // Its driver puts temporary files there, by way of a shell.
    compile.env("TMPDIR", ".");
    // A module that nobody uses would be a top as well.
    compile.args(["-g2005", "-Wall", "-s", &part.bench_name(job.design), "-o", "core.vvp"]).args(sources);
    let output = IVERILOG.output(&mut compile)?;
    if let Some(failed) = bench::compiled(Icarus.name(), IVERILOG, &output, job, part) {
        return Ok(failed);
    }
    let said = String::from_utf8_lossy(&output.stderr);
    let lines: Vec<String> =
        said.lines().filter(|line| fatal.iter().any(|words| line.contains(words))).map(str::to_owned).collect();
    if !lines.is_empty() {
        return Ok(bench::failure(Icarus.name(), job, part, lines.into_iter().take(LISTED).collect()));
    }
    let mut run = VVP.command(directory.path());
    run.args(["-n", "core.vvp"]);
    Ok(bench::judge(Icarus.name(), &VVP.output(&mut run)?, job, part))
}
