//! `brdfgen cosim`.

use std::path::PathBuf;

use clap::Args;
use quick_junit::{NonSuccessKind, Report, TestCase, TestCaseStatus, TestSuite};
use serde_json::json;

use super::source::{OnDisk, Source};
use super::{Verdict, progress, say, say_json, write_to};
use crate::core::BlockDesign;
use crate::platform::error::{Error, refuse};
use crate::spec::Language;
use crate::synth::{self, Options};
use crate::target::Family;
use crate::verify::cosim::{self, Job, Lint, Outcome, Sim};

#[derive(Args)]
pub(super) struct Arguments {
    /// What simulates; all takes every simulator that reads one of the core's languages
    #[arg(long, value_enum, default_value = "builtin")]
    sim: Sim,

    /// Every input instead of the golden vectors: --sim verilator takes the Verilog, ghdl the VHDL (through its
    /// synthesis and Verilator), all takes both
    #[arg(long)]
    exhaustive: bool,

    /// The netlist that `synth` makes of the core for this family, registers in its blocks included, in place of the
    /// core: ecp5, in Icarus
    #[arg(long, value_enum, value_name = "FAMILY", conflicts_with_all = ["exhaustive", "sim"])]
    netlist: Option<Family>,

    /// Have the tools at hand read the text as well, as `generate --lint`
    #[arg(long)]
    lint: bool,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,

    /// Write the result as JUnit XML as well
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,

    #[command(flatten)]
    source: Source,
}

pub(super) fn run(arguments: Arguments) -> Result<Verdict, Error> {
    let design = arguments.source.design()?;
    arguments.source.paths_of_core().may_write("--junit", arguments.junit.as_ref()).check()?;
    refuse!(
        arguments.exhaustive && design.is_sampled(),
        format!("--exhaustive runs every input, and {} has too many", design.spec.block.kind().noun()),
        "leave it out: the golden vectors and the digests are checked"
    );
    let modelled = |family: Family| match &family.description().models {
        Some(models) => Ok((family, models)),
        None => Err(Error::input(
            format!("--netlist {} has no models of its cells", family.name),
            format!("{} has", Family::names(|family| family.models.is_some()).join(", ")),
        )),
    };
    let netlist = arguments.netlist.map(modelled).transpose()?;
    let core = OnDisk::of(&arguments.source, design)?;
    let (job, design) = (core.job(), &core.design);
    let sims = arguments.sim.expand(&design.spec.languages);
    let mut outcomes = Vec::new();
    if let (true, BlockDesign::Lobe(lobe)) = (arguments.exhaustive, design.block()) {
        for language in exhaustive_languages(arguments.sim, &design.spec.languages)? {
            let bar = progress::bar("every input", 1);
            let tell = |done: u64, total: u64| {
                bar.set_length(total);
                bar.set_position(done);
            };
            outcomes.push(cosim::exhaustive(lobe, job.directory, language, &tell)?);
            bar.finish_and_clear();
        }
    } else if let Some((family, models)) = netlist {
        outcomes.push(cosim::model(&job));
        let spinner = progress::spinner("netlist".to_owned());
        let netlist = synth::netlist(design, &Options::new(family))?;
        outcomes.push(cosim::netlist(&job, models, &netlist)?);
        spinner.finish_and_clear();
    } else {
        outcomes.push(cosim::model(&job));
        for sim in sims {
            let spinner = progress::spinner(format!("{sim:?}").to_lowercase());
            outcomes.push(cosim::golden(sim, &job)?);
            outcomes.extend(cosim::around(sim, &job)?);
            spinner.finish_and_clear();
        }
    }
    let lints = if arguments.lint { lint(&job)? } else { Vec::new() };
    let passed = outcomes.iter().all(Outcome::passed) && are_clean(&lints);
    if let Some(path) = &arguments.junit {
        write_to(path, junit(&design.spec.name, &outcomes, &lints)?.as_bytes())?;
    }
    if arguments.json {
        let list: Vec<_> = outcomes
            .iter()
            .map(|outcome| {
                let mut value = json!(outcome);
                value["passed"] = json!(outcome.passed());
                value
            })
            .collect();
        let mut answer = json!({ "core": design.spec.name, "passed": passed, "simulations": list });
        if arguments.lint {
            answer["lint"] = json!(lints);
        }
        say_json(&answer);
    } else {
        outcomes.iter().for_each(say_outcome);
        lints.iter().for_each(say_lint);
    }
    Ok(Verdict::of(passed))
}

fn exhaustive_languages(sim: Sim, languages: &[Language]) -> Result<Vec<Language>, Error> {
    let wanted = match sim {
        Sim::Verilator => vec![Language::Verilog],
        Sim::Ghdl => vec![Language::Vhdl],
        Sim::All => languages.to_vec(),
        Sim::Builtin | Sim::Icarus => {
            return Err(Error::input(
                format!("--exhaustive does not go with --sim {}", format!("{sim:?}").to_lowercase()),
                "use --sim verilator for the Verilog, ghdl for the VHDL, or all for both",
            ));
        }
    };
    match wanted.iter().find(|language| !languages.contains(language)) {
        Some(missing) => Err(Error::input(format!("the core has no {missing}"), "generate it with that language")),
        None => Ok(wanted),
    }
}

/// Prints what a simulator found.
pub(super) fn say_outcome(outcome: &Outcome) {
    say(format!(
        "{} {}: {} of {} compared on {}, {} mismatches, {:.1} s",
        if outcome.passed() { "PASS" } else { "FAIL" },
        outcome.simulator,
        outcome.vectors,
        outcome.expected_vectors,
        outcome.mode,
        outcome.mismatches,
        outcome.seconds,
    ));
    for line in &outcome.first {
        say(format!("  {line}"));
    }
}

/// What the tools at hand say of a core's text.
pub(super) fn lint(job: &Job) -> Result<Vec<Lint>, Error> {
    let spinner = progress::spinner("lint".to_owned());
    let lints = cosim::lint(job, &|tool| spinner.set_message(tool.to_owned()))?;
    spinner.finish_and_clear();
    Ok(lints)
}

/// Whether none of them complains.
pub(super) fn are_clean(lints: &[Lint]) -> bool {
    lints.iter().all(|lint| lint.verdict != cosim::LintStatus::Fail)
}

/// Prints what a tool says.
pub(super) fn say_lint(lint: &Lint) {
    let Lint { tool, language, what, verdict, lines, seconds } = lint;
    match verdict {
        cosim::LintStatus::Pass => say(format!("PASS {tool}: {language}, {what}, {seconds:.1} s")),
        cosim::LintStatus::Fail => say(format!("FAIL {tool}: {language}, {what}, {seconds:.1} s")),
        cosim::LintStatus::NotRun => say(format!("not run {tool}: {language}; {}", lines.join("; "))),
    }
    if *verdict == cosim::LintStatus::Fail {
        lines.iter().for_each(|line| say(format!("  {line}")));
    }
}

fn junit(core: &str, outcomes: &[Outcome], lints: &[Lint]) -> Result<String, Error> {
    let mut suite = TestSuite::new(core);
    for outcome in outcomes {
        let status = if outcome.passed() {
            TestCaseStatus::success()
        } else {
            let mut status = TestCaseStatus::non_success(NonSuccessKind::Failure);
            status.set_message(format!("{} mismatches", outcome.mismatches)).set_description(outcome.first.join("\n"));
            status
        };
        let mut case = TestCase::new(format!("{}: {}", outcome.simulator, outcome.mode), status);
        case.set_time(std::time::Duration::from_secs_f64(outcome.seconds));
        suite.add_test_case(case);
    }
    for lint in lints {
        let status = match lint.verdict {
            cosim::LintStatus::Pass => TestCaseStatus::success(),
            cosim::LintStatus::NotRun => TestCaseStatus::skipped(),
            cosim::LintStatus::Fail => {
                let mut status = TestCaseStatus::non_success(NonSuccessKind::Failure);
                status.set_message("the tool complains").set_description(lint.lines.join("\n"));
                status
            }
        };
        let mut case = TestCase::new(format!("{}: {}, {}", lint.tool, lint.language, lint.what), status);
        case.set_time(std::time::Duration::from_secs_f64(lint.seconds));
        suite.add_test_case(case);
    }
    let mut report = Report::new("brdfgen cosim");
    report.add_test_suite(suite);
    report.to_string().map_err(|error| Error::input(error.to_string(), "the JUnit report cannot be written"))
}
