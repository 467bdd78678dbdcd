//! `brdfgen generate`.

use std::fs;
use std::path::PathBuf;

use clap::Args;
use serde_json::json;

use super::choose::{self, WishFlags};
use super::scene::{self, Made, SceneFlags};
use super::source::Source;
use super::{Verdict, progress, say, say_json, warn};
use crate::verify::cosim::{self, Job, Sim};
use crate::core::{Account, Design};
use crate::platform::error::Error;
use crate::explore::{MaxError, Objective};
use crate::verify::golden::Golden;
use crate::core::Direction;
use crate::platform::input;
use crate::emit::package::{self, File};
use crate::spec::CoreSpec;

#[derive(Args)]
pub(super) struct Arguments {
    /// Directory of the core: new, empty, or one that brdfgen wrote
    #[arg(long, short, value_name = "DIR")]
    out: PathBuf,

    /// Write nothing: compare DIR with what would be written, exit 1 if it differs
    #[arg(long)]
    check: bool,

    /// Then have the tools at hand read the text: Icarus, Verilator, Yosys and GHDL, and NVC, slang and Verible where they are installed;
    /// exit 1 if one complains
    #[arg(long, conflicts_with = "check")]
    lint: bool,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,

    /// Choose the cheapest core whose |result - x^n| is at most this (0.01, 1% or 2^-7), as `choose` does; other keys of the core that
    /// are given narrow the choice
    #[arg(long, value_name = "ERROR", help_heading = "Choice")]
    max_error: Option<MaxError>,

    /// What of the chosen core is to be least, as `choose --objective` [default: lut]
    #[arg(long, value_enum, value_name = "COST", help_heading = "Choice", requires = "max_error")]
    goal: Option<Objective>,

    #[command(flatten)]
    wish: WishFlags,

    #[command(flatten)]
    scene: SceneFlags,

    #[command(flatten)]
    source: Source,
}

/// The core of a spec, and the files that go with it.
fn of_spec(spec: CoreSpec, files: Vec<File>) -> Result<Made, Error> {
    let spinner = progress::spinner(format!("building {}", spec.name));
    let design = Design::new(spec)?;
    spinner.finish_and_clear();
    Ok(Made { design, files })
}

/// Compares the directory with the files that would be written.
fn check(arguments: &Arguments, files: &[File]) -> Verdict {
    let of_directory = |file: &File| fs::read(arguments.out.join(&file.path)).ok();
    let stale: Vec<(&File, Option<Vec<u8>>)> = files
        .iter()
        .map(|file| (file, of_directory(file)))
        .filter(|(file, there)| there.as_deref() != Some(&file.bytes))
        .collect();
    let same_lines = |(file, there): &&(&File, Option<Vec<u8>>)| {
        let lines = |bytes: &[u8]| str::from_utf8(bytes).map(|text| input::plain(text).into_owned()).ok();
        there.as_deref().and_then(lines).is_some_and(|text| Some(text) == lines(&file.bytes))
    };
    let (ends_only, other): (Vec<_>, Vec<_>) = stale.iter().partition(same_lines);
    let paths =
        |of: &[&(&File, Option<Vec<u8>>)]| of.iter().map(|(file, _)| file.path.clone()).collect::<Vec<String>>();
    if arguments.json {
        let differ = stale.iter().map(|(file, _)| &file.path).collect::<Vec<_>>();
        say_json(&json!({ "checked": files.len(), "differ": differ, "differ_in_line_ends_only": paths(&ends_only) }));
    } else {
        for (file, there) in &other {
            let what = if there.is_some() { "differs" } else { "is missing" };
            say(format!("{} {what}", arguments.out.join(&file.path).display()));
        }
        if let Some((first, _)) = ends_only.first() {
            let first = arguments.out.join(&first.path);
            let whose = match ends_only.len() {
                1 => format!("{} differs in its line ends only", first.display()),
                count => format!("{} and {} more differ in their line ends only", first.display(), count - 1),
            };
            say(format!(
                "{whose}: a check-out has put CR LF for LF, or an editor a byte order mark in front; `* -text` in .gitattributes leaves \
                 files as they are"
            ));
        }
        say(format!("{} of {} files are as they should be", files.len() - stale.len(), files.len()));
    }
    Verdict::of(stale.is_empty())
}

pub(super) fn run(arguments: Arguments) -> Result<Verdict, Error> {
    let of_scene = arguments.source.scene()?;
    if of_scene.is_none() && !arguments.scene.is_empty() {
        return Err(Error::input("--margin and --synth are for scenes", "give a scene file, or leave them out"));
    }
    if of_scene.is_some() && (arguments.max_error.is_some() || !arguments.wish.is_empty()) {
        return Err(Error::input(
            "a scene says itself what error its pictures may have and what is wished of the core",
            "write it in the tables [budget] and [core] of the scene file",
        ));
    }
    let wish = match arguments.max_error {
        None if arguments.wish.is_empty() => None,
        None => {
            return Err(Error::input(
                "a core can only be chosen by its error",
                "give --max-error, or leave the other flags of the choice out",
            ));
        }
        Some(error) => {
            let goal = arguments.goal.unwrap_or(Objective::Lut);
            Some(arguments.wish.wish(error, goal, arguments.source.fields()?)?)
        }
    };
    if !arguments.check {
        package::check_target(&arguments.out)?;
    }
    let mut promised = None;
    let made = match (&of_scene, &wish) {
        (Some((scene, keys)), _) => match scene::make(scene, &arguments.scene, keys, arguments.json)? {
            Some(made) => made,
            None => return Ok(Verdict::Differs),
        },
        (None, None) => of_spec(arguments.source.spec()?, arguments.source.companions())?,
        (None, Some(wish)) => {
            let choice = wish.choose(&arguments.wish.results()?)?;
            let Some(chosen) = &choice.chosen else {
                if arguments.json {
                    say_json(&choice);
                }
                choose::describe(wish, &choice).iter().for_each(warn);
                return Ok(Verdict::Differs);
            };
            if !arguments.json {
                choose::describe(wish, &choice).iter().for_each(say);
            }
            promised = Some(chosen.cost.latency);
            of_spec(wish.spec_of(chosen)?.resolve()?, Vec::new())?
        }
    };
    let Made { design, files: others } = made;
    package::check_names(&design)?;
    let spinner = progress::spinner(format!("generating {}", design.spec.name));
    let account = Account::of(&design);
    let golden = Golden::of(&design);
    let files = package::files_with(&design, &account, &golden, others)?;
    spinner.finish_and_clear();

    if arguments.check {
        return Ok(check(&arguments, &files));
    }

    // A core's own directory is made anew from its own core.toml.
    let results = arguments.wish.paths();
    let paths = results.joined(arguments.source.paths()).renewing(&arguments.out.join("core.toml"));
    paths.writes_in("--out", &arguments.out, files.iter().map(|file| file.path.as_str())).check()?;

    // The figures that a core is chosen by may be of another version of this program.
    if let (Some(MaxError(wished)), Account::Lobe(measured)) = (arguments.max_error, &account)
        && measured.max_abs > wished
    {
        warn(format!(
            "the chosen core has an error of {}, more than wished: the results that it was chosen from are of another version",
            package::percent_text(measured.max_abs)
        ));
        return Ok(Verdict::Differs);
    }
    let latency = design.schedule.latency;
    if let Some(promised) = promised.filter(|&promised| promised != latency) {
        warn(format!(
            "the core takes {latency} clocks, where the results say {promised}: they are of another version, or of more shininesses"
        ));
    }
    let limits = wish.iter().flat_map(|wish| &wish.limits);
    if limits.into_iter().any(|&(objective, most)| objective == Objective::Latency && latency > most) {
        return Ok(Verdict::Differs);
    }

    // Checked before it is written: a core that fails leaves no directory behind.
    let job = Job { design: &design, golden: &golden, directory: &arguments.out };
    let outcome = cosim::golden(Sim::Builtin, &job)?;
    if outcome.passed() {
        package::write_directory(&arguments.out, &files)?;
    }
    // Of a core that fails there is nothing to read.
    let lints = if arguments.lint && outcome.passed() { super::cosim::lint(&job)? } else { Vec::new() };
    let clean = super::cosim::are_clean(&lints);
    if arguments.json {
        let mut answer = json!({
            "directory": arguments.out.display().to_string(),
            "name": design.spec.name,
            "files": files.iter().map(|file| &file.path).collect::<Vec<_>>(),
            "latency": design.schedule.latency,
            "proved_ulps": design.budget.proved_ulps,
            "measured": account,
            "cosim": outcome,
            "passed": outcome.passed() && clean,
        });
        if arguments.lint {
            answer["lint"] = json!(lints);
        }
        say_json(&answer);
        return Ok(Verdict::of(outcome.passed() && clean));
    }
    let multipliers: Vec<String> = design.graph().multipliers().iter().map(|(a, b)| format!("{a}x{b}")).collect();
    let memories: Vec<String> =
        design.tables().iter().map(|table| format!("{} x {} bits", table.depth(), table.word_bits())).collect();
    let formats = |direction: Direction| -> String {
        let all = design.numbers(direction);
        match all.as_slice() {
            // The first input is an index.
            [_, (_, operand)] | [(_, operand)] => operand.to_string(),
            many => format!("{} ports", many.len()),
        }
    };
    say(format!(
        "{}: {} -> {}, {} clocks, multipliers {}, {}",
        design.spec.name,
        formats(Direction::In),
        formats(Direction::Out),
        design.schedule.latency,
        multipliers.join(" "),
        if memories.is_empty() { "no ROM".to_owned() } else { format!("ROM {}", memories.join(", ")) },
    ));
    let proved = package::interval_text(design.budget.proved_ulps);
    match &account {
        Account::Lobe(measured) => {
            say(format!(
                "error against the method: proved {proved} ulp, measured {} over {} inputs{}",
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
        }
        Account::Shader(error) => {
            say(format!("error of the lobe against its method: proved {proved} ulp"));
            say(format!("error against the exact shader in codes of a channel, over {} samples:", error.samples));
            for part in error.parts.iter().chain([&error.whole]) {
                say(format!("  {:<12} {} rms {:.3}", part.name, package::interval_text(part.codes), part.rms));
            }
        }
    }
    super::cosim::say_outcome(&outcome);
    if outcome.passed() {
        say(format!("{} files in {}", files.len(), arguments.out.display()));
    } else {
        say("nothing was written");
    }
    lints.iter().for_each(super::cosim::say_lint);
    Ok(Verdict::of(outcome.passed() && clean))
}
