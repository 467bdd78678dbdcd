//! The proof of the wrapper with AXI4-Stream interfaces: for every source and every sink, forever.
//!
//! What is claimed stands in `templates/formal/stream.v`, of the wrapper around the core itself: no beat is lost,
//! doubled, made up or reordered, `tlast`, `tuser` and `tdata` stay with their beat, a beat that waits stays as it is,
//! the source waits for the sink only, a full pipeline gives a beat at every clock, and a reset drops everything. What
//! the core computes is left open: that is for [`crate::verify::cosim`] and the equivalence of its languages.
//!
//! It is proved by induction over two clocks (`yosys-smtbmc` with Yices): the first clocks after a reset keep the
//! claims, and a clock that keeps them is followed by one that does. For that the claims say, too, where each beat is:
//! signals of the wrapper and of its core are connected by their names to the module that holds the claims. Last, three
//! situations are shown to happen at all, so that the claims are not about nothing.

use std::path::Path;
use std::process::Command;

use askama::Template;

use super::{Proof, ProofStatus, Step, tried};
use crate::core::Design;
use crate::emit::{Axis, package, render};
use crate::platform::error::Error;
use crate::platform::tool::{self, YICES, YOSYS, YOSYS_SMTBMC};
use crate::spec::Language;
use crate::synth;

#[derive(Template)]
#[template(path = "formal/stream.v", escape = "none")]
struct Claims<'a> {
    axis: &'a Axis,
}

/// The file with the wrapper and its core as Verilog.
const WRAPPER: &str = "wrapper.v";
/// The file with the claims.
const CLAIMS: &str = "stream.v";
/// The file with all of it for the solver.
const PROBLEM: &str = "stream.smt2";

/// Proves what the core's wrapper promises, once for each of its languages; of a core without a wrapper there is
/// nothing to prove.
///
/// `directory` is the core's. `progress` is told of each claim before and after it is looked at.
///
/// # Errors
/// A tool that is not installed, or a text that GHDL or Yosys does not read.
pub fn stream(design: &Design, directory: &Path, progress: &dyn Fn(Step)) -> Result<Vec<Proof>, Error> {
    let Some(axis) = package::axis(design) else { return Ok(Vec::new()) };
    let of_language = |&language: &Language| {
        let claim = format!("{} in {language} keeps every beat, in order and unchanged, at full throughput", axis.name);
        tried(claim, progress, || prove(design, &axis, directory, language))
    };
    design.spec.languages.iter().map(of_language).collect()
}

fn prove(design: &Design, axis: &Axis, directory: &Path, language: Language) -> Result<(ProofStatus, String), Error> {
    if YICES.version().is_none() {
        return Err(YICES.missing());
    }
    let scratch = tool::scratch()?;
    let put = |name: &str, bytes: &[u8]| {
        let path = scratch.path().join(name);
        let made = path.parent().map_or(Ok(()), std::fs::create_dir_all);
        made.and_then(|()| std::fs::write(&path, bytes)).map_err(|error| Error::io("cannot write", &path, error))
    };
    let read = |path: String| {
        let path = directory.join(path);
        std::fs::read(&path).map_err(|error| Error::io("cannot read", &path, error))
    };
    let mut texts = read(package::rtl_path(design, language))?;
    texts.extend(read(package::axis_path(design, language))?);
    if language == Language::Vhdl {
        // A file of both: GHDL's synthesis is given one.
        put("wrapper.vhd", &texts)?;
        texts = synth::as_verilog(&axis.name, directory, &scratch.path().join("wrapper.vhd"))?;
    } else if design.reads_files() {
        for table in design.tables() {
            let path = package::rom_path(design, table, package::read_format(&design.spec));
            put(&path, &read(path.clone())?)?;
        }
    }
    put(WRAPPER, &texts)?;
    put(CLAIMS, render(&Claims { axis })?.as_bytes())?;
    put("stream.ys", script(axis)?.as_bytes())?;
    YOSYS.succeed(YOSYS.command(scratch.path()).args(["-q", "stream.ys"]))?;

    // Beats that leave the skid register, and a full wrapper that is reset, take a walk through the pipeline.
    let walk = (axis.latency + 8).to_string();
    let solve = |arguments: &[&str]| -> Result<Answer, Error> {
        let mut command: Command = YOSYS_SMTBMC.command(scratch.path());
        command.args(["-s", "yices"]).args(arguments).arg(PROBLEM);
        let output = YOSYS_SMTBMC.output(&mut command)?;
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        let answer = Answer::of(&text).filter(|answer| output.status.success() == (*answer == Answer::Holds));
        answer.ok_or_else(|| Error::ToolFailed {
            tool: YOSYS_SMTBMC.program.to_owned(),
            what: output.status.to_string(),
            output: tool::tail(&output, 12),
        })
    };
    if let Answer::Fails(what) = solve(&["-t", "3"])? {
        return Ok((ProofStatus::Refuted, format!("false soon after a reset: {what}")));
    }
    if let Answer::Fails(what) = solve(&["-i", "-t", "2"])? {
        // Either a claim is false some clocks after a reset, or it is true and does not follow.
        return Ok(match solve(&["-t", &walk])? {
            Answer::Fails(what) => (ProofStatus::Refuted, format!("false within {walk} clocks of a reset: {what}")),
            Answer::Holds => {
                (ProofStatus::Open, format!("true for {walk} clocks, but one does not follow from the others: {what}"))
            }
        });
    }
    Ok(match solve(&["-c", "-t", &walk])? {
        Answer::Holds => (ProofStatus::Proved, "by induction over two clocks".to_owned()),
        Answer::Fails(what) => (ProofStatus::Open, format!("a situation that it speaks of does not happen: {what}")),
    })
}

/// What the solver says.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Answer {
    Holds,
    /// With the claim that fails.
    Fails(String),
}

impl Answer {
    /// From what `yosys-smtbmc` prints, if that is whole.
    fn of(text: &str) -> Option<Self> {
        let after =
            |what: &str| text.lines().find_map(|line| line.split_once(what).map(|(_, rest)| rest.trim().to_owned()));
        match after("Status: ")?.as_str() {
            "PASSED" => Some(Self::Holds),
            "FAILED" => {
                let claim = after("Assert failed in stream: ").or_else(|| after("Unreached cover statement at "));
                Some(Self::Fails(claim.unwrap_or_else(|| "it does not say which".to_owned())))
            }
            _ => None,
        }
    }
}

/// The script that makes the problem: the wrapper's signals are connected to the claims once everything is one module.
fn script(axis: &Axis) -> Result<String, Error> {
    let mut script = format!(
        "read_verilog -formal -sv {CLAIMS}\nread_verilog {WRAPPER}\nhierarchy -check -top stream\nproc\nflatten\ncd \
         stream\n"
    );
    let own = ["ready", "skid_valid", "last", "user", "skid"].map(|name| (name.to_owned(), format!("dut.{name}")));
    let lanes = axis.inputs.lanes.iter().chain(&axis.outputs.lanes).map(|lane| lane.port.name.clone());
    let of_core =
        std::iter::once("valid".to_owned()).chain(lanes).map(|name| (name.clone(), format!("dut.core.{name}")));
    for (name, signal) in own.into_iter().chain(of_core) {
        script += &format!("connect -nomap -nounset -set \\{name} \\{signal}\n");
    }
    // What the core computes is left open, so that no solver multiplies.
    script += "cd ..\ncutpoint t:$mul\nopt_clean\nmemory_nordff\nasync2sync\nopt -full\ndffunmap\nopt_clean\n";
    // Newer ones have a cell for all kinds of claims.
    let help = YOSYS.succeed(YOSYS.command(Path::new(".")).args(["-p", "help chformal"]))?;
    if String::from_utf8_lossy(&help).contains("-lower") {
        script += "chformal -lower\n";
    }
    script += &format!("write_smt2 -wires {PROBLEM}\n");
    Ok(script)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_solvers_answers_are_read() {
        let failed = "##   0:00:02  BMC failed!\n##   0:00:02  Assert failed in stream: beat_stays\n##   0:00:02  \
         Status: FAILED\n";
        assert_eq!(Answer::of(failed), Some(Answer::Fails("beat_stays".to_owned())));
        assert_eq!(Answer::of("##   0:00:00  Status: PASSED\n"), Some(Answer::Holds));
        assert_eq!(Answer::of("##   0:00:00  Status: PREUNSAT\n"), None);
        assert_eq!(Answer::of("##   0:00:00  Checking assertions in step 0..\n"), None);
    }
}
