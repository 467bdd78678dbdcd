//! `brdfgen render`.

use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::time::Instant;

use clap::{Args, ValueEnum};
use serde::Serialize;
use serde_json::{Value, json};

use super::scene::{MARGIN, costing};
use super::source::{read_scene, reads_core};
use super::{Verdict, progress, say, say_json, write_to};
use crate::design::Design;
use crate::error::Error;
use crate::explore::sweep::Core;
use crate::explore::{Cost, Point};
use crate::input;
use crate::package::{self, counted};
use crate::paths::Paths;
use crate::scene::choice::Search;
use crate::scene::require::PictureError;
use crate::scene::sheet::{self, Cell, Sheet};
use crate::scene::{Compiled, CoreModel, Difference, Exact, Frame, Highlights, Requirements, Scene, picture};
use crate::spec::{BlockKind, CoreSpec, Language, Shininess, SpecFields};
use crate::synth::Family;
use crate::tool;

/// The cores that `--compare` shows where it is not told which.
const COMPARED: &str =
    "quadratic,cubic,cubic-min-zero:coefficients=minimax,schlick,power-4,log-exp:accuracy=5,log-exp:accuracy=9";

#[derive(Args)]
pub(super) struct Arguments {
    /// The scene, a TOML file
    #[arg(value_name = "SCENE")]
    scene: PathBuf,

    /// The picture: a PNG file with 8 bits a channel, or 16 where the scene has more than 8; `-` is standard output
    #[arg(long, short, value_name = "FILE.png")]
    out: PathBuf,

    /// What the PNG file shows: the three pictures side by side with their figures, or one of them alone, pixel for pixel
    #[arg(long, value_enum, default_value = "all", conflicts_with = "compare")]
    only: Only,

    /// Write the pictures as OpenEXR too, in the layers exact, core and difference (in output steps)
    #[arg(long, value_name = "FILE.exr", conflicts_with = "compare")]
    exr: Option<PathBuf>,

    /// How the core's highlights are computed: by its bit-exact model, or by the core itself, compiled by Verilator and given every
    /// sample of the picture
    #[arg(long, value_enum, default_value = "model")]
    through: Through,

    /// The size of the picture in pixels [default: the scene's]
    #[arg(long, value_name = "WxH")]
    size: Option<Size>,

    /// Make a contact sheet of several cores: methods, each with keys if need be, as in `cubic,log-exp:accuracy=9`, spec files or core
    /// directories [default: quadratic, cubic, cubic-min-zero minimax, schlick, power-4, log-exp of accuracy 5 and 9]
    #[arg(long, value_name = "CORES", num_args = 0..=1, require_equals = true, value_delimiter = ',', default_missing_value = COMPARED, conflicts_with = "method")]
    compare: Option<Vec<String>>,

    /// Where a core is to be chosen: move the camera and each light by so many degrees too, 0 to 45 [default: 5]
    #[arg(long, value_name = "DEGREES", allow_negative_numbers = true, conflicts_with_all = ["compare", "core", "method"])]
    margin: Option<f64>,

    /// Costs by synthesis and placement instead of the cost model, where a core is to be chosen and with --compare
    #[arg(long, conflicts_with_all = ["core", "method"])]
    synth: bool,

    /// With --compare: the family of FPGAs that the costs are for [default: the scene's]
    #[arg(long, value_enum, requires = "compare")]
    family: Option<Family>,

    /// The core: a spec file, or the directory of a generated core; flags win over it. Without it and without --method: the cheapest core
    /// that keeps the scene's budget
    #[arg(long, value_name = "SPEC", help_heading = "Core", conflicts_with = "compare")]
    core: Option<PathBuf>,

    #[command(flatten)]
    fields: SpecFields,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,
}

/// What the picture file shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Only {
    /// Exact, core and difference, with figures
    All,
    /// The picture with `x^n` in double precision
    Exact,
    /// The core's picture
    Core,
    /// How far the core's picture is off, as a heat map
    Difference,
}

/// What computes the core's highlights.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum, Serialize)]
#[serde(rename_all = "lowercase")]
enum Through {
    /// The bit-exact model
    Model,
    /// The core's own HDL, compiled
    Verilator,
}

/// The largest side of a picture, in pixels.
const LARGEST: u32 = 16_384;

/// A picture's size.
#[derive(Clone, Copy, Debug)]
struct Size(u32, u32);

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let side = |side: &str| side.parse().ok().filter(|side| (1..=LARGEST).contains(side));
        text.split_once('x')
            .and_then(|(width, height)| Some(Self(side(width)?, side(height)?)))
            .ok_or_else(|| format!("a size is written WIDTHxHEIGHT, as in 320x240, each from 1 to {LARGEST}"))
    }
}

/// The seconds that each part of the work took.
#[derive(Serialize)]
struct Seconds {
    trace: f64,
    exact: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    core: Option<f64>,
    files: f64,
}

/// A core, and where it is on disk if it is taken from there as it is.
struct Chosen {
    design: Design,
    directory: Option<PathBuf>,
}

pub(super) fn run(arguments: &Arguments) -> Result<Verdict, Error> {
    let to_stdout = |path: &Path| path.as_os_str() == "-";
    let piped = to_stdout(&arguments.out) || arguments.exr.as_deref().is_some_and(to_stdout);
    if piped && (arguments.json || arguments.exr.as_deref().is_some_and(to_stdout) && to_stdout(&arguments.out)) {
        return Err(Error::input("standard output cannot take two things", "write the picture to a file"));
    }
    std::iter::once(&arguments.out).chain(&arguments.exr).try_for_each(|path| check_writable(path))?;
    let scene = read_scene(&arguments.scene)?;
    let scene = match arguments.size {
        Some(Size(width, height)) => scene.resized(width, height),
        None => scene,
    };
    check_paths(arguments)?;
    // Wrong specs are named before the work begins.
    if let Some(compared) = &arguments.compare {
        let cores: Vec<Chosen> =
            compared.iter().map(|entry| compared_core(entry, arguments, &scene)).collect::<Result<_, _>>()?;
        return compare(arguments, &scene, &cores, piped);
    }
    let core = match (arguments.only, &arguments.exr) {
        (Only::Exact, None) => None,
        _ => Some(the_core(arguments, &scene)?),
    };

    let mut clock = Instant::now();
    let mut lap = || std::mem::replace(&mut clock, Instant::now()).elapsed().as_secs_f64();
    let frame = trace(&scene);
    let traced = lap();
    let exact = frame.picture(&scene, &Exact.of(&scene, &frame)?);
    let mut seconds = Seconds { trace: traced, exact: lap(), core: None, files: 0.0 };
    let of_core = match &core {
        Some(core) => {
            let own = frame.picture(&scene, &highlights(core, arguments.through, &scene, &frame)?);
            let difference = Difference::of(&exact, &own);
            seconds.core = Some(lap());
            Some((&core.design, own, difference))
        }
        None => None,
    };

    let missed = of_core.as_ref().map(|(.., difference)| missed(&scene, difference)).unwrap_or_default();
    let verdict =
        if missed.is_empty() { format!("within the budget: {}", budget_text(&scene)) } else { missed.join("; ") };
    let mut panels = Value::Null;
    let bytes = match (arguments.only, &of_core) {
        (Only::All, Some((design, own, difference))) => {
            let lines = [scene_text(&scene, &frame), format!("core {}", core_text(design))];
            let Sheet { pixels, panels: places } =
                sheet::triptych(&frame, [&exact, own], difference, &scene.name, &lines, &verdict);
            panels = json!(places);
            pixels.png()
        }
        (Only::Core, Some((_, own, _))) => own.pixels().png(),
        (Only::Difference, Some((.., difference))) => sheet::heat_map(&frame, difference, 8).png(),
        _ => exact.pixels().png(),
    };
    // Both files are made before one is written.
    let exr = match (&arguments.exr, &of_core) {
        (Some(path), Some((_, own, _))) => Some((path, picture::exr(&exact, own)?)),
        _ => None,
    };
    write_to(&arguments.out, &bytes)?;
    if let Some((path, bytes)) = &exr {
        write_to(path, bytes)?;
    }
    seconds.files = lap();

    if arguments.json {
        let core = of_core.as_ref().map(|(design, _, difference)| {
            json!({
                "name": design.spec.name,
                "digest": design.spec.digest(),
                "flags": design.spec.flags().join(" "),
                "latency": design.schedule.latency,
                "through": arguments.through,
                "difference": difference,
            })
        });
        say_json(&json!({
            "scene": scene.name,
            "width": frame.width,
            "height": frame.height,
            "channel_bits": scene.channel_bits,
            "samples": samples(&frame),
            "core": core,
            "budget": budget_json(&scene),
            "kept": core.as_ref().map(|_| missed.is_empty()),
            "missed": missed,
            "panels": panels,
            "seconds": seconds,
        }));
    } else if !piped {
        say(format!("{}: {}", scene.name, scene_text(&scene, &frame)));
        if let Some((design, _, difference)) = &of_core {
            say(format!("core {}", core_text(design)));
            say(format!("  {}", sheet::figures(difference).join(", ")));
            say(format!("  pixels by the steps that they are off: {}", histogram(difference)));
            say(format!("  {verdict}"));
        }
        let core = seconds.core.map(|core| {
            let by = if arguments.through == Through::Model { "model" } else { "compiled core" };
            format!(", with those of the {by} in {core:.2} s")
        });
        say(format!(
            "traced in {:.2} s, exact highlights in {:.2} s{}, files in {:.2} s",
            seconds.trace,
            seconds.exact,
            core.unwrap_or_default(),
            seconds.files
        ));
        for path in std::iter::once(&arguments.out).chain(&arguments.exr) {
            say(path.display().to_string());
        }
    }
    Ok(Verdict::of(missed.is_empty()))
}

/// The contact sheet.
fn compare(arguments: &Arguments, scene: &Scene, cores: &[Chosen], piped: bool) -> Result<Verdict, Error> {
    let family = arguments.family.unwrap_or(scene.core.family);
    let costing = costing(arguments.synth)?;
    let frame = trace(scene);
    let exact = frame.picture(scene, &Exact.of(scene, &frame)?);
    let bar = progress::bar("cores", cores.len() as u64);
    let mut cells = Vec::new();
    let mut list = Vec::new();
    for Chosen { design, .. } in cores {
        let core = Chosen { design: design.clone(), directory: None };
        let own = frame.picture(scene, &highlights(&core, arguments.through, scene, &frame)?);
        let difference = Difference::of(&exact, &own);
        let cost = costing.cost(design, family)?;
        let name = name(design);
        let missed = missed(scene, &difference);
        let kept = if missed.is_empty() { "keeps the budget" } else { "misses the budget" };
        list.push(json!({
            "name": name,
            "flags": design.spec.flags().join(" "),
            "cost": cost,
            "difference": difference,
            "kept": missed.is_empty(),
        }));
        cells.push(Cell { name, picture: own, difference, lines: cost_lines(&cost), verdict: kept.to_owned() });
        bar.inc(1);
    }
    bar.finish_and_clear();
    let source = if arguments.synth { "measured" } else { "estimated" };
    let lines = [
        scene_text(scene, &frame),
        format!("shininess {}; budget: {}", shininess_text(scene), budget_text(scene)),
        format!("cost for {}, {source}", crate::explore::sweep::word(&family)),
    ];
    let Sheet { pixels, panels } = sheet::contact(&frame, &exact, &cells, &scene.name, &lines);
    write_to(&arguments.out, &pixels.png())?;
    if arguments.json {
        say_json(&json!({
            "scene": scene.name,
            "width": frame.width,
            "height": frame.height,
            "channel_bits": scene.channel_bits,
            "samples": samples(&frame),
            "family": family,
            "through": arguments.through,
            "budget": budget_json(scene),
            "cores": list,
            "panels": panels,
        }));
    } else if !piped {
        say(format!("{}: {}", scene.name, lines.join("; ")));
        for Cell { name, difference, lines, verdict, .. } in &cells {
            let [most, mean, psnr, off] = sheet::figures(difference);
            say(format!("{name}: {}; {psnr}, {most}, {mean}, {off}; {verdict}", lines.join(", ")));
        }
        say(arguments.out.display().to_string());
    }
    Ok(Verdict::Done)
}

/// Refuses an output over what is read: the scene and its meshes have been by now.
fn check_paths(arguments: &Arguments) -> Result<(), Error> {
    let cores = arguments.compare.iter().flatten().map(Path::new).filter(|core| core.exists());
    let paths = cores.chain(arguments.core.as_deref()).fold(Paths::new(), |paths, core| {
        if core.is_dir() { reads_core(paths, "the core", core) } else { paths.reads("the core", core) }
    });
    paths.writes("--out", &arguments.out).may_write("--exr", arguments.exr.as_ref()).check()
}

/// Refuses a file that cannot be written, before the work begins.
fn check_writable(path: &Path) -> Result<(), Error> {
    let directory = path.parent().filter(|parent| !parent.as_os_str().is_empty());
    match directory.filter(|directory| !directory.is_dir()) {
        Some(missing) => Err(Error::input(
            format!("there is no directory {} for {}", missing.display(), path.display()),
            "make it first, or name another place",
        )),
        None if path.is_dir() => Err(Error::input(format!("{} is a directory", path.display()), "name a file")),
        None => Ok(()),
    }
}

/// Reads the keys of a core; a scene is told apart.
fn read_core(path: &Path) -> Result<SpecFields, Error> {
    if path.is_dir() {
        return SpecFields::read(&path.join("core.toml"));
    }
    let text = input::read_text(path, "").unwrap_or_default();
    if Scene::is_scene(&text) {
        return Err(Error::input(
            format!("{} is a scene, and no core", path.display()),
            "give --core a spec file or the directory of a generated core",
        ));
    }
    SpecFields::read(path)
}

/// The core of these keys for a scene: for the shininesses of its objects' materials, unless the keys name some.
fn core_for(scene: &Scene, fields: SpecFields) -> Result<Design, Error> {
    if fields.block == Some(BlockKind::Shader) {
        return Err(Error::input(
            "the core is a shader, and a picture's highlights need a lobe",
            "leave block = \"shader\" and the other keys of a shader out",
        ));
    }
    let own = fields.shininess.is_some() || fields.material.is_some();
    let shininess = if own { fields.shininess.clone() } else { Some(Shininess::List(shininesses(scene))) };
    Design::new(SpecFields { shininess, ..fields }.resolve()?)
}

/// The distinct shininesses of the materials that objects have, ascending.
fn shininesses(scene: &Scene) -> Vec<f64> {
    let mut all: Vec<f64> = scene.objects.iter().map(|object| scene.materials[object.material].shininess).collect();
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

/// The one core that the arguments name.
fn the_core(arguments: &Arguments, scene: &Scene) -> Result<Chosen, Error> {
    let flags = arguments.fields.clone();
    if let Some(path) = &arguments.core {
        let directory = (path.is_dir() && flags == SpecFields::default()).then(|| path.clone());
        return Ok(Chosen { design: core_for(scene, flags.or(read_core(path)?))?, directory });
    }
    if flags.method.is_none() {
        return Ok(Chosen { design: needed_core(arguments, scene, &flags)?, directory: None });
    }
    Ok(Chosen { design: core_for(scene, with_wishes(flags, scene))?, directory: None })
}

/// The core that the scene needs, with these keys, as `generate` chooses it.
fn needed_core(arguments: &Arguments, scene: &Scene, keys: &SpecFields) -> Result<Design, Error> {
    let bar = progress::bar("rendering", 1);
    let told = |done, of| progress::show(&bar, done, of);
    let requirements = Requirements::of(scene, arguments.margin.unwrap_or(MARGIN), &told)?;
    let costing = costing(arguments.synth)?;
    let choice = Search::new(scene, &requirements, &costing, keys)?.choose(&|what, done, of| {
        bar.set_message(what);
        told(done, of);
    })?;
    bar.finish_and_clear();
    let chosen = choice.chosen.ok_or_else(|| {
        Error::input(
            format!("none of the {} cores considered keeps the budget of the scene {}", choice.considered, scene.name),
            "allow more in its [budget], or name a core with --core or --method: its picture is drawn in any case",
        )
    })?;
    Design::new(chosen.spec()?.resolve()?)
}

/// Keys of a core with a method of its own, and where one is missing that of the scene's `[core]` that any core may have.
fn with_wishes(fields: SpecFields, scene: &Scene) -> SpecFields {
    let wishes = scene.core.keys.clone();
    fields.or(SpecFields {
        input_fraction: wishes.input_fraction,
        output_fraction: wishes.output_fraction,
        operand: wishes.operand,
        pipeline: wishes.pipeline,
        ..SpecFields::default()
    })
}

/// A core that `--compare` names: `METHOD`, `METHOD:KEY=VALUE:...`, a spec file or a directory.
fn compared_core(entry: &str, arguments: &Arguments, scene: &Scene) -> Result<Chosen, Error> {
    let path = Path::new(entry);
    let fields = if path.exists() {
        read_core(path)?
    } else {
        let mut parts = entry.split(':');
        let mut text = format!("method = {:?}\n", parts.next().unwrap_or_default());
        for part in parts {
            let (key, value) = part.split_once('=').ok_or_else(|| {
                Error::input(
                    format!("`{part}` in `{entry}` is no key with its value"),
                    "write METHOD:KEY=VALUE, as in log-exp:accuracy=9, the name of a file, or that of a core's directory",
                )
            })?;
            // Numbers as they are, words in quotes.
            let value = if value.parse::<f64>().is_ok() { value.to_owned() } else { format!("{value:?}") };
            text += &format!("{key} = {value}\n");
        }
        SpecFields::parse(&text, &format!("--compare {entry}"))?
    };
    let fields = with_wishes(arguments.fields.clone().or(fields), scene);
    Ok(Chosen { design: core_for(scene, fields)?, directory: None })
}

/// The picture before its highlights.
fn trace(scene: &Scene) -> Frame {
    let bar = progress::bar("rows traced", scene.height.into());
    let frame = Frame::render(scene, &|| bar.inc(1));
    bar.finish_and_clear();
    frame
}

/// The core's highlights.
fn highlights(core: &Chosen, through: Through, scene: &Scene, frame: &Frame) -> Result<Vec<f64>, Error> {
    if through == Through::Model {
        return CoreModel::new(&core.design)?.of(scene, frame);
    }
    let bar = progress::bar("samples through the compiled core", samples(frame));
    let tell = |done: u64| bar.set_position(done);
    let scratch = tool::scratch()?;
    let directory = match &core.directory {
        Some(directory) => directory,
        None => {
            let languages = &core.design.spec.languages;
            let language = if languages.contains(&Language::Verilog) { Language::Verilog } else { Language::Vhdl };
            for file in package::sources(&core.design, language)? {
                package::write_file(&scratch.path().join(&file.path), &file.bytes)?;
            }
            scratch.path()
        }
    };
    let highlights = Compiled::new(&core.design, directory, &tell)?.of(scene, frame);
    bar.finish_and_clear();
    highlights
}

/// The number of lobes that a picture asks for.
fn samples(frame: &Frame) -> u64 {
    frame.versine.iter().filter(|versine| !versine.is_nan()).count() as u64
}

/// What of the scene's budget a picture misses, in words.
fn missed(scene: &Scene, difference: &Difference) -> Vec<String> {
    let error = PictureError::of(difference, scene.channel_bits);
    scene.budget.missed(&error, "the picture").into_iter().map(|(_, why)| why).collect()
}

fn budget_json(scene: &Scene) -> Value {
    let (max_steps, min_psnr) = scene.budget.limits();
    json!({ "max_steps": max_steps, "min_psnr": min_psnr })
}

fn budget_text(scene: &Scene) -> String {
    let (steps, psnr) = scene.budget.limits();
    let steps = steps.map(|steps| format!("at most {steps} {} off", if steps == 1 { "step" } else { "steps" }));
    let psnr = psnr.map(|psnr| format!("a PSNR of at least {psnr} dB"));
    steps.into_iter().chain(psnr).collect::<Vec<_>>().join(", ")
}

fn shininess_text(scene: &Scene) -> String {
    shininesses(scene).iter().map(f64::to_string).collect::<Vec<_>>().join(", ")
}

fn scene_text(scene: &Scene, frame: &Frame) -> String {
    format!(
        "{} × {} pixels, {} bits a channel, {}, {}, {} samples",
        frame.width,
        frame.height,
        scene.channel_bits,
        crate::explore::sweep::word(&scene.model),
        counted(scene.lights.len() as u64, "light"),
        samples(frame)
    )
}

/// A core's short name for people, without its shininesses.
fn name(design: &Design) -> String {
    // Those that need not be named.
    let spec = CoreSpec { shininess: Shininess::Range(1, 1000), ..design.spec.clone() };
    Point::unmeasured(&Core::new(spec, Family::Ecp5)).name
}

/// A core in a line.
fn core_text(design: &Design) -> String {
    format!(
        "{}: {}, n = {}, {} clocks",
        design.spec.name,
        name(design),
        design.spec.shininess.to_string().replace(',', ", "),
        design.schedule.latency
    )
}

/// A core's cost in two lines.
fn cost_lines(cost: &Cost) -> Vec<String> {
    let Cost { lut, dsp, bram, latency, .. } = cost;
    let mhz = cost.mhz_text(0);
    vec![
        format!("{lut} LUTs, {}, {}", counted(*dsp, "DSP"), counted(*bram, "block RAM")),
        format!("{mhz}, {latency} clocks"),
    ]
}

/// The pixels off by 0, 1, 2 and so on; long lists with their greatest only.
fn histogram(difference: &Difference) -> String {
    const LISTED: usize = 12;
    let listed = difference.pixels.iter().take(LISTED).enumerate().map(|(steps, count)| format!("{steps}: {count}"));
    let more: u64 = difference.pixels.iter().skip(LISTED).sum();
    let more = (more > 0).then(|| format!("more: {more}"));
    listed.chain(more).collect::<Vec<_>>().join(", ")
}
