//! Claims about what is around a core, proved by induction over two clocks (`yosys-smtbmc` with Yices): the first
//! clocks after a reset keep the claims, and a clock that keeps them is followed by one that does. For that the claims
//! say, too, what state each clock leaves: signals of the text are connected by their names to the module that holds
//! the claims. Last, situations are shown to happen at all, so that the claims are not about nothing.
//!
//! What the core computes is left open: that is for [`crate::verify::cosim`] and the equivalence of its languages.

use std::path::Path;
use std::process::Command;

use super::ProofStatus;
use crate::core::Design;
use crate::emit::package::{self, Part};
use crate::platform::error::Error;
use crate::platform::tool::{self, YICES, YOSYS, YOSYS_SMTBMC};
use crate::spec::Language;
use crate::synth;

/// Claims about a text.
pub(super) struct Claims {
    /// The module that holds them.
    pub(super) module: &'static str,
    /// Its text.
    pub(super) text: String,
    /// What they are about.
    pub(super) part: Part,
    /// The wires of the module that are connected, each to a signal of the text.
    pub(super) connections: Vec<(String, String)>,
    /// Clocks in which what comes in has left.
    pub(super) walk: u32,
}

/// The file with the text as Verilog.
const TEXT: &str = "text.v";
/// The file with the claims.
const CLAIMS: &str = "claims.v";
/// The file with all of it for the solver.
const PROBLEM: &str = "claims.smt2";

/// Proves claims about a core's texts in a language.
///
/// # Errors
/// A tool that is not installed, or a text that GHDL or Yosys does not read.
pub(super) fn prove(
    design: &Design,
    claims: &Claims,
    directory: &Path,
    language: Language,
) -> Result<(ProofStatus, String), Error> {
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
    let mut texts = Vec::new();
    for path in claims.part.rtl_paths(design, language) {
        texts.extend(read(path)?);
    }
    if language == Language::Vhdl {
        // A file of all: GHDL's synthesis is given one.
        put("text.vhd", &texts)?;
        texts = synth::as_verilog(&claims.part.name(design), directory, &scratch.path().join("text.vhd"))?;
    } else if design.reads_files() {
        for table in design.tables() {
            let path = package::rom_path(design, table, package::read_format(&design.spec));
            put(&path, &read(path.clone())?)?;
        }
    }
    put(TEXT, &texts)?;
    put(CLAIMS, claims.text.as_bytes())?;
    put("claims.ys", script(claims)?.as_bytes())?;
    YOSYS.succeed(YOSYS.command(scratch.path()).args(["-q", "claims.ys"]))?;

    let walk = claims.walk.to_string();
    let solve = |arguments: &[&str]| -> Result<Answer, Error> {
        let mut command: Command = YOSYS_SMTBMC.command(scratch.path());
        command.args(["-s", "yices"]).args(arguments).arg(PROBLEM);
        let output = YOSYS_SMTBMC.output(&mut command)?;
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        let answer =
            Answer::of(claims.module, &text).filter(|answer| output.status.success() == (*answer == Answer::Holds));
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
    fn of(module: &str, text: &str) -> Option<Self> {
        let after =
            |what: &str| text.lines().find_map(|line| line.split_once(what).map(|(_, rest)| rest.trim().to_owned()));
        match after("Status: ")?.as_str() {
            "PASSED" => Some(Self::Holds),
            "FAILED" => {
                let claim =
                    after(&format!("Assert failed in {module}: ")).or_else(|| after("Unreached cover statement at "));
                Some(Self::Fails(claim.unwrap_or_else(|| "it does not say which".to_owned())))
            }
            _ => None,
        }
    }
}

/// The script that makes the problem: the text's signals are connected to the claims once everything is one module.
fn script(claims: &Claims) -> Result<String, Error> {
    let module = claims.module;
    let mut script = format!(
        "read_verilog -formal -sv {CLAIMS}\nread_verilog {TEXT}\nhierarchy -check -top {module}\nproc\nflatten\ncd \
         {module}\n"
    );
    for (name, signal) in &claims.connections {
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
        assert_eq!(Answer::of("stream", failed), Some(Answer::Fails("beat_stays".to_owned())));
        assert_eq!(Answer::of("stream", "##   0:00:00  Status: PASSED\n"), Some(Answer::Holds));
        assert_eq!(Answer::of("stream", "##   0:00:00  Status: PREUNSAT\n"), None);
        assert_eq!(Answer::of("stream", "##   0:00:00  Checking assertions in step 0..\n"), None);
    }
}
