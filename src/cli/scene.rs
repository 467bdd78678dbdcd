//! `brdfgen scene`, and what `brdfgen generate` says of a scene's core.

use std::path::PathBuf;

use clap::{Args, Subcommand};
use serde_json::json;

use super::choose::{cost_text, error_text};
use super::source::read_scene;
use super::{Verdict, progress, say, say_json, warn};
use crate::core::Design;
use crate::emit::package::{File, counted};
use crate::explore::run::{Costing, Flow};
use crate::explore::{Cost, Model, Results};
use crate::platform::error::Error;
use crate::report::ScenePart;
use crate::scene::choice::{NearMiss, RunnerUp, SceneChoice, SceneCore, Search, Verified};
use crate::scene::document::{Findings, budget_text, keys_text, psnr_text, saving_text};
use crate::scene::require::{Counts, PictureError};
use crate::scene::shade::{self, Shaded};
use crate::scene::simplify::{Simplification, simplifications};
use crate::scene::{Budget, CoreModel, Exact, Frame, Highlights, Requirements, Scene, Tracer, reflectance, sheet};
use crate::spec::{BlockKind, ShaderFields, SpecFields};
use crate::synth;

#[derive(Args)]
pub(super) struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Say what a scene requires of a core, which core is the cheapest that keeps its budget, and what that core leaves out
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

/// The degrees that the camera and the lights are moved by where the user does not say.
pub(super) const MARGIN: f64 = 5.0;

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
}

impl SceneFlags {
    /// Whether none of them is given.
    pub(super) fn is_empty(&self) -> bool {
        self.margin.is_none() && !self.synth
    }
}

/// How costs are found: by synthesis, or by the cost model.
pub(super) fn costing(synthesis: bool) -> Result<Costing, Error> {
    if !synthesis {
        return Ok(Costing::Estimate(Model::fit(&Results::built_in()?)?));
    }
    let cache = Some(synth::default_cache());
    Ok(Costing::Synthesis(Flow { seeds: 3, target_mhz: None, place: true, pack: true, yosys: None, cache }))
}

/// A scene's core.
pub(super) struct Made {
    pub(super) design: Design,
    /// The files beside the core's own.
    pub(super) files: Vec<File>,
}

/// What is known of a scene, with a core or without.
struct Known {
    requirements: Requirements,
    choice: SceneChoice,
    core: Option<(SceneCore, Design, Vec<Simplification>, Verified)>,
    /// The shader around it, where one is asked for.
    shaded: Option<Shaded>,
    /// The least frequency that the scene wishes.
    min_mhz: Option<f64>,
}

impl Known {
    fn of(scene: &Scene, flags: &SceneFlags, keys: &SpecFields) -> Result<Self, Error> {
        // The lobe is chosen as if it were alone.
        let asked = keys.clone().or(scene.core.keys.clone());
        let alone = |keys: &SpecFields| SpecFields { block: None, shader: ShaderFields::default(), ..keys.clone() };
        let (keys, mut lobe_scene) = (&alone(keys), scene.clone());
        lobe_scene.core.keys = alone(&scene.core.keys);
        let scene = &lobe_scene;
        let bar = progress::bar("rendering", 1);
        let told = |done, of| progress::show(&bar, done, of);
        let requirements = Requirements::of(scene, flags.margin.unwrap_or(MARGIN), &told)?;
        let costing = costing(flags.synth)?;
        let search = Search::new(scene, &requirements, &costing, keys)?;
        let mut choice = search.choose(&|what, done, of| {
            bar.set_message(what);
            told(done, of);
        })?;
        let shader = asked.block == Some(BlockKind::Shader);
        if !shader && !asked.shader.is_empty() {
            return Err(Error::input("keys of a shader are given for a lobe", "use --block shader, or leave them out"));
        }
        let shaded = if shader {
            bar.set_message("drawing the scene through its shader");
            bar.set_length(0);
            shade::around(&search, &mut choice, (scene, &requirements), &asked.shader, &|| bar.inc(1))?
        } else {
            None
        };
        let core = match &choice.chosen {
            None => None,
            Some(chosen) => {
                bar.set_message("verifying");
                let design = Design::new(chosen.spec()?.resolve()?)?;
                let verified = search.verified(&design)?;
                let list = simplifications(scene, &requirements, &search, chosen)?;
                Some((chosen.clone(), design, list, verified))
            }
        };
        bar.finish_and_clear();
        Ok(Self { requirements, choice, core, shaded, min_mhz: scene.core.min_mhz })
    }

    fn findings<'a>(&'a self, scene: &'a Scene) -> Option<Findings<'a>> {
        let (chosen, design, simplifications, verified) = self.core.as_ref()?;
        let Self { requirements, choice, shaded, .. } = self;
        let shaded = shaded.as_ref();
        Some(Findings { scene, requirements, choice, chosen, simplifications, design, verified, shaded })
    }
}

pub(super) fn run(arguments: &Arguments) -> Result<Verdict, Error> {
    let Command::Inspect(inspect) = &arguments.command;
    let scene = read_scene(&inspect.scene)?;
    let known = Known::of(&scene, &inspect.flags, &inspect.keys)?;
    let findings = known.findings(&scene);
    if inspect.json {
        match &findings {
            Some(findings) => say_json(&findings.json()),
            None => say_json(&json!({ "requires": known.requirements, "choice": known.choice })),
        }
        return Ok(Verdict::of(findings.is_some()));
    }
    requirements_text(&scene, &known.requirements).iter().for_each(say);
    choice_text(&known).iter().for_each(say);
    Ok(Verdict::of(findings.is_some()))
}

/// The core that a scene needs, and the files that go with it; none where no core keeps the budget. Says what was chosen unless `quiet`.
pub(super) fn make(scene: &Scene, flags: &SceneFlags, keys: &SpecFields, quiet: bool) -> Result<Option<Made>, Error> {
    let known = Known::of(scene, flags, keys)?;
    let files = known.findings(scene).map(|findings| findings.files()).transpose()?;
    let lines = choice_text(&known);
    let kept = known.shaded.as_ref().is_none_or(|shaded| shaded.missed.is_empty());
    match (known.core, files) {
        (Some((_, design, ..)), Some(files)) if kept => {
            if !quiet {
                lines.iter().for_each(say);
            }
            Ok(Some(Made { design: known.shaded.map_or(design, |shaded| shaded.design), files }))
        }
        _ => {
            if quiet {
                say_json(&known.choice);
            }
            lines.iter().for_each(warn);
            Ok(None)
        }
    }
}

/// A scene's part of the report; none where no core keeps the budget.
pub(super) fn part(scene: &Scene) -> Result<Option<ScenePart>, Error> {
    let known = Known::of(scene, &SceneFlags::default(), &SpecFields::default())?;
    let Some(findings) = known.findings(scene) else { return Ok(None) };
    let tracer = Tracer::new(scene);
    let frame = Frame::trace(&tracer, scene, &|| {});
    let base = reflectance::bases(&tracer, scene, &frame, &[&scene.exact_looks()?], &|| {}).concat();
    let frame = Frame { base, ..frame };
    let exact = frame.picture(scene, &Exact.of(scene, &frame)?);
    let own = frame.picture(scene, &CoreModel::new(findings.design)?.of(scene, &frame)?);
    let lines = [format!("core {}", findings.chosen.candidate.point.name)];
    let budget = budget_text(&scene.budget);
    let sheet = sheet::triptych(
        &frame,
        [&exact, &own],
        "core",
        &findings.verified.base,
        &scene.name,
        &lines,
        &format!("budget: {budget}"),
    );
    Ok(Some(ScenePart::of(&findings, &sheet)))
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
        "  the shader around it: vectors of {bits} fraction bits, F{}, {} clocks; {} samples through its bit-exact model: base {}; moved {}{end}",
        spec.interface.input_fraction,
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
        "  no shader around {} keeps the budget; this one does with {} in [budget]; fewer lights, or keys that are given (method, output_fraction, \
         vector_fraction) left out or finer, may help too",
        if shaded.tried == 1 { "this lobe".to_owned() } else { format!("any of {} lobes", shaded.tried) },
        wanted.collect::<Vec<_>>().join(" and "),
    ))
}

/// The choice, what it leaves out, and what it was chosen from.
fn choice_text(known: &Known) -> Vec<String> {
    let Known { requirements, choice, core, shaded, .. } = known;
    let SceneChoice { runner_ups, misses, considered, meeting, estimated, tools, .. } = choice;
    let mut lines = Vec::new();
    match core {
        None => {
            let mhz = known.min_mhz.map(|mhz| format!(" at {mhz} MHz or more"));
            lines.push(format!("no core keeps {}{}", budget_text(&requirements.budget), mhz.unwrap_or_default()));
        }
        Some((chosen, _, simplifications, verified)) => {
            lines.push(core_text(chosen));
            let point = &chosen.candidate.point;
            lines.push(format!(
                "  the lobe is off by {} at most, {:.2e} rms on the picture's samples; {} ROM bits",
                error_text(point.max_abs),
                chosen.lobe_rms,
                point.rom_bits,
            ));
            lines.push(format!(
                "  {} lit samples of {} through the bit-exact model: {} at most in the base picture, {} in the moved ones",
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
    let speed = if known.min_mhz.is_some() { " and the frequency" } else { "" };
    lines.push(format!("{meeting} of the {considered} cores considered keep the budget{speed}"));
    if !runner_ups.is_empty() {
        let row = |RunnerUp { core, why }: &RunnerUp| core_row(core, why.clone());
        lines.extend(cores_table("runners-up", &runner_ups.iter().map(row).collect::<Vec<_>>()));
    }
    if !misses.is_empty() {
        let row = |NearMiss { core, why, .. }: &NearMiss| core_row(core, why.join(", "));
        lines.extend(cores_table("nearest misses", &misses.iter().map(row).collect::<Vec<_>>()));
    }
    if let Some(tools) = tools {
        let how = if *estimated { "estimated by a cost model that follows" } else { "synthesised with" };
        lines.push(format!("costs {how} {}", tools.yosys));
    }
    lines
}
