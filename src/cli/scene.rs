//! `brdfgen scene`, and what `brdfgen generate` says of a scene's core.

use std::path::PathBuf;

use clap::{Args, Subcommand};
use serde_json::json;

use super::choose::{cost_text, error_text};
use super::source::read_scene;
use super::{Verdict, progress, say, say_json, warn};
use crate::emit::package::counted;
use crate::explore::Cost;
use crate::explore::choose::NearMiss;
use crate::explore::run::{Costing, Flow};
use crate::generate::Core;
use crate::platform::error::{Error, refuse};
use crate::scene::choice::{RunnerUp, SceneChoice, SceneCore};
use crate::scene::document::{Findings, budget_text, keys_text, psnr_text, saving_text};
use crate::scene::image_choice::{ImageCandidate, ImageChoice, ImageSearch};
use crate::scene::require::{MARGIN, PictureError};
use crate::scene::shade::Shaded;
use crate::scene::survey::Counts;
use crate::scene::{Budget, Requirements, Scene, SceneInspection};
use crate::spec::{BlockKind, SpecFields};

#[derive(Args)]
pub(super) struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Say what a scene requires of a core, which core is the cheapest that keeps its budget, and what that core leaves
    /// out
    Inspect(Inspect),
}

#[derive(Args)]
struct Inspect {
    /// A scene file
    #[arg(value_name = "SCENE")]
    scene: PathBuf,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,

    #[command(flatten)]
    flags: SceneFlags,

    #[command(flatten)]
    keys: SpecFields,
}

/// How a scene's core is chosen.
#[derive(Args, Clone, Debug, Default)]
#[command(next_help_heading = "Scene")]
pub(super) struct SceneFlags {
    /// Move the camera and each light by so many degrees too, 0 to 45: what these pictures need is kept [default: 5]
    #[arg(long, value_name = "DEGREES", allow_negative_numbers = true)]
    margin: Option<f64>,

    /// Costs by synthesis instead of the cost model
    #[arg(long)]
    synth: bool,

    /// With --block image: the material with a reflectance that the core is for, where the scene has several
    #[arg(long, value_name = "NAME")]
    for_material: Option<String>,
}

impl SceneFlags {
    /// Whether none of them is given.
    pub(super) fn is_empty(&self) -> bool {
        self.margin.is_none() && !self.synth && self.for_material.is_none()
    }
}

/// How costs are found: by synthesis, or by the cost model.
pub(super) fn costing(synthesis: bool) -> Result<Costing, Error> {
    if synthesis { Ok(Costing::Synthesis(Flow::default())) } else { Costing::built_in() }
}

/// Inspects a scene.
pub(super) fn inspect(scene: &Scene, flags: &SceneFlags, keys: &SpecFields) -> Result<SceneInspection, Error> {
    refuse!(
        flags.for_material.is_some(),
        "--for-material is given, and the core is a lobe, which serves all classical materials",
        "use --block image, or leave it out"
    );
    let bar = progress::bar("rendering", 1);
    let (margin, costing) = (flags.margin.unwrap_or(MARGIN), costing(flags.synth)?);
    let inspection = SceneInspection::of(scene, margin, &costing, keys, &progress::steps(&bar))?;
    bar.finish_and_clear();
    Ok(inspection)
}

pub(super) fn run(arguments: &Arguments) -> Result<Verdict, Error> {
    let Command::Inspect(arguments) = &arguments.command;
    let scene = read_scene(&arguments.scene)?;
    if is_image(&scene, &arguments.keys) {
        let choice = choose_image(&scene, &arguments.flags, &arguments.keys)?;
        if arguments.json {
            say_json(&choice.json(&scene));
        } else {
            image_text(&scene, &choice).iter().for_each(say);
        }
        return Ok(Verdict::of(choice.chosen.is_some()));
    }
    let inspection = inspect(&scene, &arguments.flags, &arguments.keys)?;
    let findings = inspection.findings(&scene);
    if arguments.json {
        match &findings {
            Some(findings) => say_json(&findings.json()),
            None => say_json(&json!({ "requires": inspection.requirements, "choice": inspection.choice })),
        }
        return Ok(Verdict::of(findings.is_some()));
    }
    requirements_text(&scene, &inspection.requirements).iter().for_each(say);
    choice_text(&scene, &inspection).iter().for_each(say);
    Ok(Verdict::of(findings.is_some()))
}

/// The core that a scene needs; none where no core keeps the budget. Says what was chosen unless `quiet`.
pub(super) fn make(scene: &Scene, flags: &SceneFlags, keys: &SpecFields, quiet: bool) -> Result<Option<Core>, Error> {
    if is_image(scene, keys) {
        return make_image(scene, flags, keys, quiet);
    }
    let inspection = inspect(scene, flags, keys)?;
    let lines = choice_text(scene, &inspection);
    if !inspection.is_kept() {
        if quiet {
            say_json(&inspection.choice);
        }
        lines.iter().for_each(warn);
        return Ok(None);
    }
    if !quiet {
        lines.iter().for_each(say);
    }
    let spinner = progress::spinner(format!("generating the core of {}", scene.name));
    let core = inspection.generate(scene);
    spinner.finish_and_clear();
    core
}

/// Whether an image-based core is asked for.
fn is_image(scene: &Scene, keys: &SpecFields) -> bool {
    keys.block.or(scene.core.keys.block) == Some(BlockKind::Image)
}

/// The image-based core that a material of the scene needs.
fn choose_image(scene: &Scene, flags: &SceneFlags, keys: &SpecFields) -> Result<ImageChoice, Error> {
    let (margin, costing) = (flags.margin.unwrap_or(MARGIN), costing(flags.synth)?);
    let search = ImageSearch::new(scene, flags.for_material.as_deref(), margin, &costing, keys)?;
    let bar = progress::bar("candidates", 1);
    let choice = search.choose(&progress::steps(&bar))?;
    bar.finish_and_clear();
    Ok(choice)
}

/// As [`make`], of an image-based core.
fn make_image(scene: &Scene, flags: &SceneFlags, keys: &SpecFields, quiet: bool) -> Result<Option<Core>, Error> {
    let choice = choose_image(scene, flags, keys)?;
    let lines = image_text(scene, &choice);
    if choice.chosen.is_none() {
        if quiet {
            say_json(&choice.json(scene));
        }
        lines.iter().for_each(warn);
        return Ok(None);
    }
    if !quiet {
        lines.iter().for_each(say);
    }
    let spinner = progress::spinner(format!("generating the core of {}", scene.name));
    let core = choice.generate(scene);
    spinner.finish_and_clear();
    core
}

/// The image-based candidates, what each costs and misses, and the choice.
fn image_text(scene: &Scene, choice: &ImageChoice) -> Vec<String> {
    let [width, height] = choice.size;
    let mut lines = vec![
        format!("{}: {} ({})", scene.name, choice.material, choice.reflectance),
        format!("budget: {}; candidates in a picture of {width} by {height}", budget_text(&scene.budget)),
        String::new(),
    ];
    let row = |one: &ImageCandidate| {
        let Cost { lut, dsp, bram, mhz, .. } = one.cost;
        let mhz = mhz.map_or_else(|| "-".to_owned(), |mhz| format!("{mhz:.0}"));
        let psnr = |psnr: Option<f64>| psnr.map_or_else(|| "-".to_owned(), |psnr| format!("{psnr:.1}"));
        let counts = [lut, dsp, bram].map(|count| count.to_string());
        let errors = [one.error.max_steps.to_string(), psnr(one.error.psnr), psnr(one.psnr)];
        let figures = counts.into_iter().chain([mhz, one.memory_bits.to_string()]).chain(errors);
        [one.title(), one.verdict()].into_iter().chain(figures).collect()
    };
    let heading =
        ["candidate", "budget", "LUT", "DSP", "BRAM", "MHz", "memory bits", "steps", "PSNR in dB", "of the objects"];
    lines.extend(table(&heading, &choice.candidates.iter().map(row).collect::<Vec<_>>(), 2));
    lines.push(format!("costs for {}{}", scene.core.family.name, choice.source()));
    match choice.chosen().zip(choice.verified) {
        None => lines.push(format!("no image-based core keeps {}", budget_text(&scene.budget))),
        Some((chosen, [base, moved])) => lines.push(format!(
            "chosen: {}; {}; whole picture {}; moved {}",
            chosen.name,
            cost_text(&chosen.cost),
            picture_text(&base),
            picture_text(&moved)
        )),
    }
    lines.extend(choice.cheaper_shader().map(|_| {
        "the fitted cos^n shader keeps the budget at less: shading = \"classical\" in the scene, and no --block image, \
         makes its core"
            .to_owned()
    }));
    lines
}

/// A table of columns with a heading each; all but the first `left` are set flush right.
fn table(heading: &[&str], rows: &[Vec<String>], left: usize) -> Vec<String> {
    let width = |column: usize| {
        let own = rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
        own.max(heading[column].chars().count())
    };
    let line = |cells: Vec<&str>| {
        let cell = |(column, cell): (usize, &str)| {
            let width = width(column);
            if column < left { format!("{cell:<width$}") } else { format!("{cell:>width$}") }
        };
        format!("  {}", cells.into_iter().enumerate().map(cell).collect::<Vec<_>>().join("  ").trim_end())
    };
    let mut lines = vec![line(heading.to_vec())];
    lines.extend(rows.iter().map(|row| line(row.iter().map(String::as_str).collect())));
    lines
}

fn share(part: u64, whole: u64) -> String {
    if whole == 0 { "-".to_owned() } else { format!("{:.2} %", 100.0 * part as f64 / whole as f64) }
}

fn bits(bits: Option<u32>) -> String {
    bits.map_or_else(|| "none".to_owned(), |bits| bits.to_string())
}

/// A kind of samples and how many of them there are.
type Kind = (&'static str, fn(&Counts) -> u64);

/// What a scene requires, as tables.
fn requirements_text(scene: &Scene, requirements: &Requirements) -> Vec<String> {
    let Requirements { materials, rows, base, moved, pictures, size, moved_size, saturated, .. } = requirements;
    let moves = pictures.len() - 1;
    let mut lines = vec![format!(
        "{}: {} by {} pixels, {} bits a channel, {}; {}",
        scene.name,
        size[0],
        size[1],
        scene.channel_bits,
        counted(requirements.lights as u64, "light"),
        if moves == 0 {
            "no moved pictures".to_owned()
        } else {
            let [width, height] = moved_size;
            let pictures = counted(moves as u64, "moved picture");
            format!("{pictures} of {width} by {height}, by {}", degrees(requirements.margin_degrees))
        },
    )];
    lines.push(format!("budget: {}", budget_text(&requirements.budget)));
    lines.push(String::new());
    let heading = [
        "material",
        "row",
        "shininess",
        "peak steps",
        "lit base",
        "lit moved",
        "epicentre",
        "tail",
        "unseen",
        "x < 0",
        "least x",
    ];
    let row = |need: &crate::scene::require::MaterialNeed| {
        let both = need.base.and(&need.moved);
        let of = |count: u64| share(count, both.lit());
        vec![
            need.name.clone(),
            need.row.map_or_else(|| "none".to_owned(), |row| row.to_string()),
            if need.measured { "-".to_owned() } else { need.shininess.to_string() },
            format!("{:.1}", need.peak_steps),
            need.base.lit().to_string(),
            need.moved.lit().to_string(),
            of(both.epicentre),
            of(both.visible_tail),
            of(both.invisible_tail),
            of(both.negative),
            need.least_cosine.map_or_else(|| "-".to_owned(), |least| format!("{least:.4}")),
        ]
    };
    lines.extend(table(&heading, &materials.iter().map(row).collect::<Vec<_>>(), 1));
    lines.push(String::new());
    let kinds: [Kind; 6] = [
        ("epicentre, x^n >= 1/2", |counts| counts.epicentre),
        ("tail of half a step or more", |counts| counts.visible_tail),
        ("tail below half a step", |counts| counts.invisible_tail),
        ("negative cosine", |counts| counts.negative),
        ("behind the surface or in shadow", |counts| counts.dark),
        ("material without a highlight", |counts| counts.matte),
    ];
    let of_kind =
        |(name, of): Kind| vec![name.to_owned(), share(of(base), base.samples), share(of(moved), moved.samples)];
    lines.extend(table(&["samples", "base", "moved"], &kinds.map(of_kind), 1));
    lines.push(String::new());
    lines.push(format!("rows of the core: {}", rows.len()));
    lines.push(format!(
        "pixels above full scale: {} in the base picture, {} in the moved ones",
        saturated[0], saturated[1]
    ));
    for (port, need) in [("input", requirements.input_fraction), ("output", requirements.output_fraction)] {
        lines.push(format!(
            "fraction bits of the {port}: at least {} by the pictures, {} by the derivation for any view",
            bits(need.measured),
            bits(need.derived),
        ));
    }
    lines.push(String::new());
    lines
}

fn degrees(angle: f64) -> String {
    format!("{angle} degree{}", if angle == 1.0 { "" } else { "s" })
}

fn picture_text(error: &PictureError) -> String {
    let PictureError { max_steps, mean_steps, psnr, .. } = error;
    format!("{} at most, {mean_steps:.4} in the mean, {}", counted(*max_steps, "step"), psnr_text(*psnr))
}

fn core_text(core: &SceneCore) -> String {
    format!(
        "{}: {}; base {}; moved {}",
        core.candidate.point.name,
        cost_text(&core.candidate.cost),
        picture_text(&core.base),
        picture_text(&core.moved),
    )
}

/// A core as a row of [`cores_table`].
fn core_row(core: &SceneCore, why: String) -> Vec<String> {
    let Cost { lut, ff, dsp, bram, latency, mhz, .. } = core.candidate.cost;
    let mhz = mhz.map_or_else(|| "-".to_owned(), |mhz| format!("{mhz:.0}"));
    let psnr = |psnr: Option<f64>| psnr.map_or_else(|| "-".to_owned(), |psnr| format!("{psnr:.1}"));
    let counts = [lut, ff, dsp, bram, latency].map(|count| count.to_string());
    let steps = format!("{}, {}", core.base.max_steps, core.moved.max_steps);
    let psnrs = format!("{}, {}", psnr(core.base.psnr), psnr(core.moved.psnr));
    [core.candidate.point.name.clone(), why].into_iter().chain(counts).chain([mhz, steps, psnrs]).collect()
}

/// Cores in a table with what there is to say of each; of two figures of pictures the second is of the moved ones.
fn cores_table(what: &str, rows: &[Vec<String>]) -> Vec<String> {
    let heading = [what, "why", "LUT", "FF", "DSP", "BRAM", "clocks", "MHz", "steps", "PSNR in dB"];
    table(&heading, rows, 2)
}

/// A shader around the chosen lobe.
fn shader_text(shaded: &Shaded) -> String {
    let spec = &shaded.design.spec;
    let bits = spec.block.shader().map_or(0, |shader| shader.vector_fraction);
    let end = if shaded.missed.is_empty() { String::new() } else { format!("; {}", shaded.missed.join(", ")) };
    format!(
        "  the shader around it: vectors of {bits} fraction bits, F{}, {} clocks; {} samples through its bit-exact \
         model: base {}; moved {}{end}",
        spec.block.lobe().interface.input_fraction,
        shaded.design.schedule.latency,
        shaded.samples,
        picture_text(&shaded.base),
        picture_text(&shaded.moved),
    )
}

/// What would help where no shader keeps the budget.
fn shader_help(shaded: &Shaded, budget: &Budget) -> Option<String> {
    if shaded.missed.is_empty() {
        return None;
    }
    let (steps, psnr) = budget.limits();
    let both = [shaded.base, shaded.moved];
    let most = both.iter().map(|error| error.max_steps).max().unwrap_or_default();
    let least = both.iter().filter_map(|error| error.psnr).fold(f64::INFINITY, f64::min);
    let floor = (least * 100.0).floor() / 100.0;
    let wanted = steps.map(|_| format!("max_steps = {most}"));
    let wanted = wanted.into_iter().chain(psnr.map(|psnr| format!("min_psnr = {}", psnr.min(floor))));
    Some(format!(
        "  no shader around {} keeps the budget; this one does with {} in [budget]; fewer lights, or keys that are \
         given (method, output_fraction, vector_fraction) left out or finer, may help too",
        if shaded.tried == 1 { "this lobe".to_owned() } else { format!("any of {} lobes", shaded.tried) },
        wanted.collect::<Vec<_>>().join(" and "),
    ))
}

/// The choice, what it leaves out, and what it was chosen from.
fn choice_text(scene: &Scene, inspection: &SceneInspection) -> Vec<String> {
    let SceneInspection { requirements, choice, shaded, .. } = inspection;
    let min_mhz = scene.core.min_mhz;
    let SceneChoice { runner_ups, misses, considered, meeting, estimated, tools, .. } = choice;
    let mut lines = Vec::new();
    match inspection.findings(scene) {
        None => {
            let mhz = min_mhz.map(|mhz| format!(" at {mhz} MHz or more"));
            lines.push(format!("no core keeps {}{}", budget_text(&requirements.budget), mhz.unwrap_or_default()));
        }
        Some(Findings { chosen, simplifications, verified, .. }) => {
            lines.push(core_text(chosen));
            let point = &chosen.candidate.point;
            lines.push(format!(
                "  the lobe is off by {} at most, {:.2e} rms on the picture's samples; {} ROM bits",
                error_text(point.max_abs),
                chosen.lobe_rms,
                point.rom_bits,
            ));
            lines.push(format!(
                "  {} lit samples of {} through the bit-exact model: {} at most in the base picture, {} in the moved \
                 ones",
                verified.samples,
                counted(verified.pictures as u64, "picture"),
                counted(verified.base.max_steps, "step"),
                verified.moved.max_steps,
            ));
            lines.push(format!("  any other view: {} at most", counted(chosen.guaranteed_steps(), "step")));
            lines.extend(shaded.iter().map(shader_text));
            lines.extend(shaded.iter().filter_map(|shaded| shader_help(shaded, &requirements.budget)));
            for (applies, heading) in [(true, "left out:"), (false, "not left out:")] {
                lines.push(heading.to_owned());
                for one in simplifications.iter().filter(|one| one.applies == applies) {
                    lines.push(format!("  {}: {}", one.what, one.reason));
                    if let Some(saves) = &one.saves {
                        lines.push(format!("    {}; saves {}", keys_text(&one.keys), saving_text(saves)));
                    }
                }
            }
        }
    }
    let speed = if min_mhz.is_some() { " and the frequency" } else { "" };
    lines.push(format!("{meeting} of the {considered} cores considered keep the budget{speed}"));
    if !runner_ups.is_empty() {
        let row = |RunnerUp { core, why }: &RunnerUp| core_row(core, why.clone());
        lines.extend(cores_table("runners-up", &runner_ups.iter().map(row).collect::<Vec<_>>()));
    }
    if !misses.is_empty() {
        let row = |NearMiss { core, why, .. }: &NearMiss<SceneCore>| core_row(core, why.join(", "));
        lines.extend(cores_table("nearest misses", &misses.iter().map(row).collect::<Vec<_>>()));
    }
    if let Some(tools) = tools {
        let how = if *estimated { "estimated by a cost model that follows" } else { "synthesised with" };
        lines.push(format!("costs {how} {}", tools.yosys));
    }
    lines
}
