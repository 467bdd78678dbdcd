//! `brdfgen generate`.

use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::json;

use super::choose::{self, ConstraintFlags};
use super::scene::{self, SceneFlags};
use super::source::Source;
use super::{Verdict, progress, say, say_json, warn};
use crate::core::{Account, BlockDesign, Design, Direction, Part};
use crate::emit::package::{self, File, Stale};
use crate::explore::choose::Constraints;
use crate::explore::{MaxError, Objective};
use crate::generate::Core;
use crate::platform::error::Error;
use crate::reflectance;
use crate::reflectance::measure::Quality;
use crate::spec::{CoreSpec, REFLECTANCE_DIRECTORY};

#[derive(Args)]
pub(super) struct Arguments {
    /// Directory of the core: new, empty, or one that brdfgen wrote
    #[arg(long, short, value_name = "DIR")]
    out: PathBuf,

    /// Write nothing: compare DIR with what would be written, exit 1 if it differs
    #[arg(long)]
    check: bool,

    /// Then have the tools at hand read the text: Icarus, Verilator, Yosys and GHDL, and NVC, slang and Verible where
    /// they are installed; exit 1 if one complains
    #[arg(long, conflicts_with = "check")]
    lint: bool,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,

    /// Choose the cheapest core whose |result - x^n| is at most this (0.01, 1% or 2^-7), as `choose` does; other keys
    /// of the core that are given narrow the choice
    #[arg(id = "lobe_error", long = "max-error", value_name = "ERROR", help_heading = "Choice")]
    max_error: Option<MaxError>,

    /// What of the chosen core is to be least, as `choose --objective` [default: lut]
    #[arg(long, value_enum, value_name = "COST", help_heading = "Choice", requires = "lobe_error")]
    goal: Option<Objective>,

    #[command(flatten)]
    constraints: ConstraintFlags,

    #[command(flatten)]
    scene: SceneFlags,

    #[command(flatten)]
    source: Source,
}

/// The core of a spec, with these files beside its own.
fn of_spec(spec: CoreSpec, others: Vec<File>) -> Result<Core, Error> {
    let spinner = progress::spinner(format!("generating {}", spec.name));
    let core = Core::of(Design::new(spec)?, others)?;
    spinner.finish_and_clear();
    Ok(core)
}

/// Compares the directory with the files that would be written.
fn check(arguments: &Arguments, core: &Core) -> Verdict {
    let (stale, count) = (core.check(&arguments.out), core.files.len());
    let (ends_only, other): (Vec<_>, Vec<_>) = stale.iter().copied().partition(|(_, stale)| *stale == Stale::LineEnds);
    let paths = |of: &[(&str, Stale)]| of.iter().map(|(path, _)| (*path).to_owned()).collect::<Vec<_>>();
    if arguments.json {
        let (differ, ends_only) = (paths(&stale), paths(&ends_only));
        say_json(&json!({ "checked": count, "differ": differ, "differ_in_line_ends_only": ends_only }));
        return Verdict::of(stale.is_empty());
    }
    for (path, stale) in &other {
        let what = if *stale == Stale::Missing { "is missing" } else { "differs" };
        say(format!("{} {what}", arguments.out.join(path).display()));
    }
    if let Some((first, _)) = ends_only.first() {
        let first = arguments.out.join(first);
        let whose = match ends_only.len() {
            1 => format!("{} differs in its line ends only", first.display()),
            count => format!("{} and {} more differ in their line ends only", first.display(), count - 1),
        };
        say(format!(
            "{whose}: a check-out has put CR LF for LF, or an editor a byte order mark in front; `* -text` in \
             .gitattributes leaves files as they are"
        ));
    }
    say(format!("{} of {count} files are as they should be", count - stale.len()));
    Verdict::of(stale.is_empty())
}

/// What is asked of a core that is to be chosen, if one is.
fn constraints(arguments: &Arguments, is_scene: bool) -> Result<Option<Constraints>, Error> {
    if !is_scene && !arguments.scene.is_empty() {
        return Err(Error::input(
            "--margin, --synth and --for-material are for scenes",
            "give a scene file, or leave them out",
        ));
    }
    if is_scene && (arguments.max_error.is_some() || !arguments.constraints.is_empty()) {
        return Err(Error::input(
            "a scene says itself what error its pictures may have and what is asked of the core",
            "write it in the tables [budget] and [core] of the scene file",
        ));
    }
    match arguments.max_error {
        None if arguments.constraints.is_empty() => Ok(None),
        None => Err(Error::input(
            "a core can only be chosen by its error",
            "give --max-error, or leave the other flags of the choice out",
        )),
        Some(error) => {
            let goal = arguments.goal.unwrap_or(Objective::Lut);
            arguments.constraints.with_error(error, goal, arguments.source.fields()?).map(Some)
        }
    }
}

/// The core that is asked for, with the latency that the results promise; none if none meets the constraints.
fn chosen(arguments: &Arguments, constraints: &Constraints) -> Result<Option<(Core, u32)>, Error> {
    let choice = constraints.choose(&arguments.constraints.results()?)?;
    let Some(chosen) = &choice.chosen else {
        if arguments.json {
            say_json(&choice);
        }
        choose::describe(constraints, &choice).iter().for_each(warn);
        return Ok(None);
    };
    if !arguments.json {
        choose::describe(constraints, &choice).iter().for_each(say);
    }
    Ok(Some((of_spec(constraints.spec_of(chosen)?.resolve()?, Vec::new())?, chosen.cost.latency)))
}

/// Whether a chosen core is what was asked for: the figures that it is chosen by may be of another version of this
/// program.
fn keeps(constraints: &Constraints, promised: u32, core: &Core) -> bool {
    let latency = core.design.schedule.latency;
    if let Account::Lobe { measured, .. } = &core.account
        && measured.max_abs > constraints.max_error.0
    {
        warn(format!(
            "the chosen core has an error of {}, more than asked for: the results that it was chosen from are of \
             another version",
            package::percent_text(measured.max_abs)
        ));
        return false;
    }
    if promised != latency {
        warn(format!(
            "the core takes {latency} clocks, where the results say {promised}: they are of another version, or of \
             more shininesses"
        ));
    }
    !constraints.limits.iter().any(|&(objective, most)| objective == Objective::Latency && latency > most)
}

/// How the core's pictures meet those of the table or the matcap's picture that it is made of, if it is, and what that
/// is called: its directory knows the samples only.
fn file_quality(arguments: &Arguments, design: &Design) -> Result<Option<(&'static str, Quality)>, Error> {
    let BlockDesign::Image(image) = design.block() else { return Ok(None) };
    let fields = arguments.source.fields()?.reflectance;
    let Some(file) = fields.file.filter(|file| !Path::new(file).is_dir()) else { return Ok(None) };
    let source = reflectance::Source::open(Path::new(&file), fields.lookup.unwrap_or_default())?;
    Ok(match &source {
        reflectance::Source::Images(picture) => {
            Some(("picture", image.block.matcap_error(picture, image.of.exposure).quality))
        }
        _ => source.reflectance().map(|table| ("table", image.quality(table))),
    })
}

pub(super) fn run(arguments: Arguments) -> Result<Verdict, Error> {
    let of_scene = arguments.source.scene()?;
    let constraints = constraints(&arguments, of_scene.is_some())?;
    if !arguments.check {
        package::check_target(&arguments.out)?;
    }
    let core = match (&of_scene, &constraints) {
        (Some((scene, keys)), _) => {
            scene::make(scene, &arguments.scene, keys, arguments.json)?.map(|core| (core, None))
        }
        (None, None) => Some((of_spec(arguments.source.spec()?, arguments.source.companions())?, None)),
        (None, Some(constraints)) => {
            chosen(&arguments, constraints)?.map(|(core, promised)| (core, Some((constraints, promised))))
        }
    };
    let Some((core, asked)) = core else { return Ok(Verdict::Differs) };
    if arguments.check {
        return Ok(check(&arguments, &core));
    }

    // A core's own directory is made anew from its own core.toml.
    let results = arguments.constraints.paths();
    let paths = results.joined(arguments.source.paths());
    let own = |path: &&str| *path == "core.toml" || Path::new(path).starts_with(REFLECTANCE_DIRECTORY);
    let renewed = core.files.iter().map(|file| file.path.as_str()).filter(own);
    let paths = renewed.fold(paths, |paths, path| paths.renewing(&arguments.out.join(path)));
    paths.writes_in("--out", &arguments.out, core.files.iter().map(|file| file.path.as_str())).check()?;
    if !asked.is_none_or(|(constraints, promised)| keeps(constraints, promised, &core)) {
        return Ok(Verdict::Differs);
    }

    // A scene's choice has said what its pictures make of it.
    let of_file = if of_scene.is_some() { None } else { file_quality(&arguments, &core.design)? };
    // Checked before it is written: a core that fails leaves no directory behind.
    let outcome = core.simulate()?;
    if outcome.passed() {
        core.write(&arguments.out)?;
    }
    // Of a core that fails there is nothing to read.
    let lints =
        if arguments.lint && outcome.passed() { super::cosim::lint(&core.job(&arguments.out))? } else { Vec::new() };
    let passed = outcome.passed() && super::cosim::are_clean(&lints);
    let Core { design, account, files, .. } = &core;
    if arguments.json {
        let mut answer = json!({
            "directory": arguments.out.display().to_string(),
            "name": design.spec.name,
            "files": files.iter().map(|file| &file.path).collect::<Vec<_>>(),
            "latency": design.schedule.latency,
            "measured": account,
            "cosim": outcome,
            "passed": passed,
        });
        if let Some((what, quality)) = &of_file {
            answer[format!("measured_against_{what}")] = json!(quality);
        }
        if design.spec.block.has_lobe() {
            answer["proved_ulps"] = json!(design.lobe().budget.proved_ulps);
        }
        if arguments.lint {
            answer["lint"] = json!(lints);
        }
        say_json(&answer);
        return Ok(Verdict::of(passed));
    }
    describe(design, account).iter().for_each(say);
    match of_file {
        Some((_, Quality { mean, .. })) if core.design.sums().is_none() => {
            say(format!("against the picture itself: {mean:.1} dB"));
        }
        Some((_, Quality { mean, worst, worst_phi, .. })) => {
            say(format!("against the table itself: {mean:.1} dB in the mean, {worst:.1} dB at {worst_phi} degrees"));
        }
        None => {}
    }
    super::cosim::say_outcome(&outcome);
    if outcome.passed() {
        say(format!("{} files in {}", files.len(), arguments.out.display()));
    } else {
        say("nothing was written");
    }
    lints.iter().for_each(super::cosim::say_lint);
    Ok(Verdict::of(passed))
}

/// A core and its errors, in lines.
fn describe(design: &Design, account: &Account) -> Vec<String> {
    let multipliers: Vec<String> = design.function().multipliers().iter().map(|(a, b)| format!("{a}x{b}")).collect();
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
    let mut lines = vec![format!(
        "{}: {} -> {}, {} clocks, multipliers {}, {}",
        design.spec.name,
        formats(Direction::In),
        formats(Direction::Out),
        design.schedule.latency,
        multipliers.join(" "),
        if memories.is_empty() { "no ROM".to_owned() } else { format!("ROM {}", memories.join(", ")) },
    )];
    let proved = || package::interval_text(design.lobe().budget.proved_ulps);
    match account {
        Account::Lobe { measured, .. } => {
            let proved = proved();
            lines.push(format!(
                "error against the method: proved {proved} ulp, measured {} over {} inputs{}",
                package::interval_text(measured.ulps),
                measured.sweep.inputs,
                if measured.sweep.exhaustive { " (all in [0, 1])" } else { "" },
            ));
            lines.push(format!(
                "error against x^n: {} at most, {} on the epicentre ({} relative)",
                package::percent_text(measured.max_abs),
                package::percent_text(measured.max_abs_epicentre),
                package::percent_text(measured.max_rel_epicentre),
            ));
        }
        Account::Shader(error) => {
            let samples = error.samples;
            lines.push(format!("error of the lobe against its method: proved {} ulp", proved()));
            lines.push(format!("error against the exact shader in codes of a channel, over {samples} samples:"));
            lines.extend(error.parts.iter().chain([&error.whole]).map(part_line));
        }
        Account::Image(error) => {
            let (mean, worst) = (error.quality.mean, error.quality.worst);
            let against = if error.of_samples { " against the stored samples" } else { "" };
            lines.push(match design.sums() {
                None => format!("a picture of a sphere{against}: {mean:.1} dB"),
                Some(_) => format!(
                    "pictures of a sphere{against}, lit from {} angles: {mean:.1} dB in the mean, {worst:.1} dB at {} \
                     degrees",
                    error.angles, error.quality.worst_phi
                ),
            });
            let (samples, exact) = (error.samples, error.exact());
            lines.push(format!("error against {exact} in codes of a channel, over {samples} samples:"));
            lines.extend(error.parts.iter().chain([&error.whole]).map(part_line));
        }
    }
    lines
}

/// A part of an error, in a line.
fn part_line(part: &Part) -> String {
    format!("  {:<12} {} rms {:.3}", part.name, package::interval_text(part.codes), part.rms)
}
