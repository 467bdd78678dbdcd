//! The generated test benches in Icarus, Verilator and GHDL.

use std::path::Path;
use std::process::Output;

use super::tool::{GHDL, IVERILOG, Tool, VERILATOR, VVP, tail};
use super::{Job, LISTED, Outcome};
use crate::error::Error;
use crate::package;
use crate::spec::Language;

fn scratch() -> Result<tempfile::TempDir, Error> {
    tempfile::Builder::new()
        .prefix("brdfgen-")
        .tempdir()
        .map_err(|error| Error::io("cannot make a directory in", &std::env::temp_dir(), error))
}

pub(super) fn icarus(job: &Job) -> Result<Outcome, Error> {
    let scratch = scratch()?;
    let program = scratch.path().join("core.vvp");
    let mut compile = IVERILOG.command(job.directory);
    compile.args(["-g2005", "-Wall", "-o"]).arg(&program).args(sources(job, Language::Verilog));
    if let Some(failed) = compiled("icarus", IVERILOG, &IVERILOG.output(&mut compile)?, job) {
        return Ok(failed);
    }
    let mut run = VVP.command(job.directory);
    run.arg("-n").arg(&program);
    Ok(judge("icarus", &VVP.output(&mut run)?, job))
}

pub(super) fn verilator(job: &Job) -> Result<Outcome, Error> {
    let scratch = scratch()?;
    let mut compile = VERILATOR.command(job.directory);
    compile.args(["--binary", "--timing", "-Wno-fatal", "-O3", "-j", "2", "--Mdir"]);
    compile.arg(scratch.path()).args(["--top-module", &format!("{}_tb", job.design.spec.name), "-o", "bench"]);
    compile.args(sources(job, Language::Verilog));
    if let Some(failed) = compiled("verilator", VERILATOR, &VERILATOR.output(&mut compile)?, job) {
        return Ok(failed);
    }
    let mut run = std::process::Command::new(scratch.path().join("bench"));
    let output = run.current_dir(job.directory).output().map_err(|error| VERILATOR.start_error(error))?;
    Ok(judge("verilator", &output, job))
}

pub(super) fn ghdl(job: &Job) -> Result<Outcome, Error> {
    let scratch = scratch()?;
    let options = ["--std=08".to_owned(), format!("--workdir={}", scratch.path().display())];
    let bench = format!("{}_tb", job.design.spec.name);
    let mut analyse = GHDL.command(job.directory);
    analyse.arg("-a").args(&options).args(sources(job, Language::Vhdl));
    if let Some(failed) = compiled("ghdl", GHDL, &GHDL.output(&mut analyse)?, job) {
        return Ok(failed);
    }
    let mut run = GHDL.command(job.directory);
    run.arg("--elab-run").args(&options).arg(&bench);
    // With a compiling back end GHDL leaves an executable in the current directory: let it be the scratch one.
    run.current_dir(scratch.path());
    link_core(job.directory, scratch.path())?;
    Ok(judge("ghdl", &GHDL.output(&mut run)?, job))
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

fn sources(job: &Job, language: Language) -> [String; 2] {
    [package::rtl_path(job.design, language), package::bench_path(job.design, language)]
}

fn failure(simulator: &str, job: &Job, first: Vec<String>) -> Outcome {
    Outcome {
        simulator: simulator.to_owned(),
        mode: "golden vectors",
        vectors: 0,
        expected_vectors: job.golden.vectors().len() as u64,
        mismatches: 0,
        first,
        seconds: 0.0,
    }
}

/// The failed outcome of a compilation that did not succeed.
fn compiled(simulator: &str, tool: Tool, output: &Output, job: &Job) -> Option<Outcome> {
    (!output.status.success()).then(|| {
        let what = format!("{} does not compile the core: {}", tool.program, tail(output, 12));
        failure(simulator, job, vec![what])
    })
}

/// Reads the bench's last line; without a whole one, or with another status than the line says, it failed.
fn judge(simulator: &str, output: &Output, job: &Job) -> Outcome {
    let name = &job.design.spec.name;
    let text = format!("{}\n{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    let marker = format!("brdfgen: {name}: ");
    let verdict = text.lines().rev().find_map(|line| line.split_once(&marker).map(|(_, rest)| rest.trim().to_owned()));
    let Some(verdict) = verdict else {
        return failure(simulator, job, vec![format!("the bench gave no verdict: {}", tail(output, 12))]);
    };
    let number = |before: &str| -> Option<u64> {
        verdict.split(before).next()?.split_ascii_whitespace().next_back()?.parse().ok()
    };
    let (vectors, mismatches) = (number(" vectors compared"), number(" mismatches"));
    let said_pass = verdict.ends_with("PASS");
    let mut outcome = failure(simulator, job, Vec::new());
    let (Some(vectors), Some(mismatches)) = (vectors, mismatches) else {
        outcome.first = vec![format!("the bench's verdict is not understood: {verdict}")];
        return outcome;
    };
    (outcome.vectors, outcome.mismatches) = (vectors, mismatches);
    if said_pass != output.status.success() {
        outcome.first.push(format!("the bench says {verdict} and ends with {}", output.status));
    } else if !said_pass {
        let told = text.lines().filter(|line| !line.trim().is_empty() && !line.contains(&marker));
        outcome.first.extend(told.take(LISTED).map(str::to_owned));
        if outcome.first.is_empty() {
            outcome.first.push(verdict);
        }
    }
    outcome
}
