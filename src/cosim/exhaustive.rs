//! Every input through a compiled core.
//!
//! Verilator compiles the core with a harness of ours, `testbench/exhaustive.cpp`, into a program that reads ranges of operand codes and
//! writes the results, both as binary records through pipes. The results are compared with the vectorised evaluator
//! (itself checked against the model). VHDL goes through GHDL's synthesis to Verilog first, so that its check is not
//! independent of GHDL's front end.

use std::fs;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use sha2::{Digest, Sha256};

use super::{Job, LISTED, Outcome, ghdl};
use crate::error::Error;
use crate::golden::all_codes;
use crate::package;
use crate::spec::{Language, hex};
use crate::tool::{self, Tool, VERILATOR, tail};

const HARNESS: &str = include_str!("../../testbench/exhaustive.cpp");

/// Runs every code of the operand port for every row through the core in one language; `progress` is told how many
/// inputs are done, of how many.
///
/// # Errors
/// A tool that is not installed or does not compile the core.
pub fn exhaustive(job: &Job, language: Language, progress: &dyn Fn(u64, u64)) -> Result<Outcome, Error> {
    let start = std::time::Instant::now();
    let simulator = match language {
        Language::Verilog => "verilator",
        Language::Vhdl => "ghdl --synth, verilator",
    };
    let mut outcome = match compile(job, language) {
        Ok(program) => run(job, &program, progress)?,
        // A core that does not compile has failed its check; what other languages' checks found still counts.
        Err(Error::ToolFailed { tool, what, output }) => Outcome {
            first: vec![format!("{tool} does not compile the core ({what}): {output}")],
            ..nothing_compared(job)
        },
        Err(other) => return Err(other),
    };
    outcome.simulator = simulator.to_owned();
    outcome.seconds = start.elapsed().as_secs_f64();
    Ok(outcome)
}

/// The core in one language as a program.
fn compile(job: &Job, language: Language) -> Result<PathBuf, Error> {
    let source = job.directory.join(package::rtl_path(job.design, language));
    let verilog = match language {
        Language::Verilog => fs::read(&source).map_err(|error| Error::io("cannot read", &source, error))?,
        Language::Vhdl => ghdl::as_verilog(&job.design.spec.name, job.directory, &source)?,
    };
    build(job, &verilog)
}

/// The inputs that a run has to compare.
fn inputs(job: &Job) -> u64 {
    job.design.spec.shininess.rows() as u64 * all_codes(job.design.operand_format()).1
}

fn nothing_compared(job: &Job) -> Outcome {
    Outcome {
        simulator: String::new(),
        mode: "every input",
        vectors: 0,
        expected_vectors: inputs(job),
        mismatches: 0,
        first: Vec::new(),
        seconds: 0.0,
    }
}

/// The compiled core; a build takes some ten seconds, so it is kept.
fn build(job: &Job, verilog: &[u8]) -> Result<PathBuf, Error> {
    let design = job.design;
    let version = VERILATOR.version().ok_or_else(|| VERILATOR.missing())?;
    let flags = format!(
        "-O2 -DOPERAND={} -DOPERAND_BITS={} -DLATENCY={}",
        design.operand_name(),
        design.operand_format().width(),
        design.schedule.latency
    );
    // The memories keep the words that they come up with.
    let low: String = design.write_ports().iter().map(|port| format!(" core->{} = 0;", port.enable.name)).collect();
    let harness = format!("#define DISABLE_WRITES{low}\n{HARNESS}");
    let mut digest = Sha256::new();
    for part in [verilog, harness.as_bytes(), flags.as_bytes(), version.as_bytes()] {
        digest.update((part.len() as u64).to_le_bytes());
        digest.update(part);
    }
    let cache = tool::cache_directory();
    let kept = cache.join(format!("{}-{}", design.spec.name, &hex(&digest.finalize())[..24]));
    if kept.exists() {
        return Ok(kept);
    }
    fs::create_dir_all(&cache).map_err(|error| Error::io("cannot make", &cache, error))?;
    let scratch =
        tempfile::tempdir_in(&cache).map_err(|error| Error::io("cannot make a directory in", &cache, error))?;
    let put = |name: &str, bytes: &[u8]| {
        let path = scratch.path().join(name);
        fs::write(&path, bytes).map_err(|error| Error::io("cannot write", &path, error))
    };
    put("core.v", verilog)?;
    put("exhaustive.cpp", harness.as_bytes())?;
    let mut command = VERILATOR.command(scratch.path());
    command.args(["--cc", "--exe", "--build", "-O3", "-Wno-fatal", "-Wno-lint", "-j", "2", "--prefix", "Vcore"]);
    command.args(["--top-module", &design.spec.name, "-CFLAGS", &flags, "core.v", "exhaustive.cpp"]);
    VERILATOR.succeed(&mut command)?;
    let built = scratch.path().join("obj_dir").join("Vcore");
    // A rename, so that two runs at once do not see each other's half-copied program.
    fs::rename(&built, &kept).map_err(|error| Error::io("cannot keep", &kept, error))?;
    Ok(kept)
}

fn run(job: &Job, program: &Path, progress: &dyn Fn(u64, u64)) -> Result<Outcome, Error> {
    let harness = Tool { program: "the compiled core", version_flag: "", package: "verilator", pypi: "", purpose: "" };
    let design = job.design;
    let (first, count) = all_codes(design.operand_format());
    let rows = design.spec.shininess.rows();
    let indices: Vec<u32> = (0..rows).map(|row| design.spec.shininess.index_of_row(row)).collect();
    let total = inputs(job);
    // The ROM file, if there is one, is named relative to the core's directory.
    let mut child = Command::new(program)
        .current_dir(job.directory)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(|error| harness.start_error(error))?;
    let mut stdin = child.stdin.take();
    let mut stdout = child.stdout.take().ok_or_else(|| harness.missing())?;

    let mut outcome = nothing_compared(job);
    std::thread::scope(|scope| {
        let sent = indices.clone();
        let mut pipe = stdin.take();
        scope.spawn(move || {
            for index in sent {
                let mut record = Vec::with_capacity(12);
                record.extend(index.to_le_bytes());
                record.extend((first as i32).to_le_bytes());
                record.extend((count as u32).to_le_bytes());
                // A core that ended early is noticed by its missing results.
                if pipe.as_mut().is_none_or(|pipe| pipe.write_all(&record).is_err()) {
                    return;
                }
            }
        });
        let evaluator = design.evaluator();
        let block = count.min(1 << 16) as usize;
        let (mut bytes, mut expected) = (vec![0u8; 4 * block], vec![0u32; block]);
        'rows: for &index in &indices {
            for start in (0..count).step_by(block) {
                if stdout.read_exact(&mut bytes).is_err() {
                    break 'rows;
                }
                evaluator.evaluate(index, first + start as i64, 1, &mut expected);
                let got = bytes.as_chunks::<4>().0.iter().map(|bytes| u32::from_le_bytes(*bytes));
                for (offset, (got, &expected)) in got.zip(&expected).enumerate() {
                    if got != expected {
                        outcome.mismatches += 1;
                        if outcome.first.len() < LISTED {
                            let operand = first + start as i64 + offset as i64;
                            outcome
                                .first
                                .push(format!("in_n {index}, operand {operand}: expected {expected}, got {got}"));
                        }
                    }
                }
                outcome.vectors += block as u64;
                progress(outcome.vectors, total);
            }
        }
    });
    drop(stdout);
    let output = child.wait_with_output().map_err(|error| harness.start_error(error))?;
    if !output.status.success() {
        outcome.first.push(format!("the compiled core ends with {}: {}", output.status, tail(&output, 4)));
    }
    Ok(outcome)
}
