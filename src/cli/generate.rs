//! `brdfgen generate`.

use std::fs;
use std::path::PathBuf;

use clap::Args;
use serde_json::json;

use super::source::Source;
use super::{Verdict, progress, say, say_json};
use crate::cosim::{self, Job, Sim};
use crate::design::{Design, Measured};
use crate::error::Error;
use crate::golden::Golden;
use crate::package;

#[derive(Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    source: Source,

    /// Directory of the core: new, empty, or one that brdfgen wrote
    #[arg(long, short, value_name = "DIR")]
    out: PathBuf,

    /// Write nothing: compare DIR with what would be written, exit 1 if it differs
    #[arg(long)]
    check: bool,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,
}

pub(super) fn run(arguments: Arguments) -> Result<Verdict, Error> {
    let spec = arguments.source.spec()?;
    if !arguments.check {
        package::check_target(&arguments.out)?;
    }
    let spinner = progress::spinner(format!("generating {}", spec.name));
    let design = Design::new(spec)?;
    let measured = Measured::of(&design);
    let golden = Golden::of(&design);
    let files = package::files(&design, &measured, &golden)?;
    spinner.finish_and_clear();

    if arguments.check {
        let stale: Vec<&str> = files
            .iter()
            .filter(|file| fs::read(arguments.out.join(&file.path)).ok().as_deref() != Some(&file.bytes))
            .map(|file| file.path.as_str())
            .collect();
        if arguments.json {
            say_json(&json!({ "checked": files.len(), "differ": stale }));
        } else {
            for path in &stale {
                say(format!("{} differs", arguments.out.join(path).display()));
            }
            say(format!("{} of {} files are as they should be", files.len() - stale.len(), files.len()));
        }
        return Ok(Verdict::of(stale.is_empty()));
    }

    // Checked before it is written: a core that fails leaves no directory behind.
    let job = Job { design: &design, golden: &golden, directory: &arguments.out };
    let outcome = cosim::golden(Sim::Builtin, &job)?;
    if outcome.passed() {
        package::write_directory(&arguments.out, &files)?;
    }
    if arguments.json {
        say_json(&json!({
            "directory": arguments.out.display().to_string(),
            "name": design.spec.name,
            "files": files.iter().map(|file| &file.path).collect::<Vec<_>>(),
            "latency": design.schedule.latency,
            "proved_ulps": design.budget.proved_ulps,
            "measured": measured,
            "cosim": outcome,
            "passed": outcome.passed(),
        }));
        return Ok(Verdict::of(outcome.passed()));
    }
    let multipliers: Vec<String> = design.graph().multipliers().iter().map(|(a, b)| format!("{a}x{b}")).collect();
    let memories: Vec<String> =
        design.tables().iter().map(|table| format!("{} x {} bits", table.depth(), table.word_bits())).collect();
    say(format!(
        "{}: {} -> {}, {} clocks, multipliers {}, {}",
        design.spec.name,
        design.operand_format(),
        design.output_format(),
        design.schedule.latency,
        multipliers.join(" "),
        if memories.is_empty() { "no ROM".to_owned() } else { format!("ROM {}", memories.join(", ")) },
    ));
    say(format!(
        "error against the method: proved {} ulp, measured {} over {} inputs{}",
        package::interval_text(design.budget.proved_ulps),
        package::interval_text(measured.ulps),
        measured.sweep.inputs,
        if measured.sweep.exhaustive { " (all in [0, 1])" } else { "" },
    ));
    say(format!(
        "error against x^n: {} at most, {} on the epicentre ({} relative)",
        package::percent_text(measured.max_abs),
        package::percent_text(measured.max_abs_epicentre),
        package::percent_text(measured.max_rel_epicentre),
    ));
    super::cosim::say_outcome(&outcome);
    if outcome.passed() {
        say(format!("{} files in {}", files.len(), arguments.out.display()));
    } else {
        say("nothing was written");
    }
    Ok(Verdict::of(outcome.passed()))
}
