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
use crate::core::Design;
use crate::platform::error::Error;
use crate::explore::sweep::Core;
use crate::explore::{Cost, Point};
use crate::platform::input;
use crate::emit::package::{self, counted};
use crate::platform::paths::Paths;

use crate::scene::choice::Search;
use crate::scene::reflectance::{self, Compared, Looks, Measured, Shading, Viewer};
use crate::scene::require::PictureError;
use crate::scene::sheet::{self, Cell, Sheet};
use crate::scene::{
    Compiled, CoreModel, Difference, Exact, Frame, Highlights, Picture, Requirements, Scene, Tracer, picture,
};
use crate::spec::{BlockKind, Colour, CoreSpec, Language, Shininess, SpecFields};
use crate::synth::Family;
use crate::platform::tool;

/// The cores that `--compare` shows where it is not told which.
const COMPARED: [&str; 7] = [
    "quadratic",
    "cubic",
    "cubic-min-zero:coefficients=minimax",
    "schlick",
    "power-4",
    "log-exp:accuracy=5",
    "log-exp:accuracy=9",
];

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
    /// directories [default: quadratic, cubic, cubic-min-zero minimax, schlick, power-4, log-exp of accuracy 5 and 9]. Of a scene with
    /// measured materials, of several forms: `paper`, `half`, `bivariate`, each with keys as in `half:images=8:size=64`, and `fit`
    /// [default: paper of 4 and of 6 images, half, bivariate, fit]
    #[arg(long, value_name = "CORES", num_args = 0..=1, require_equals = true, value_delimiter = ',', default_missing_value = "", conflicts_with = "method")]
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
    #[arg(long, value_name = "SPEC", conflicts_with = "compare")]
    core: Option<PathBuf>,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,

    #[command(flatten)]
    fields: SpecFields,
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
    let measured = scene.is_measured();
    // Wrong specs are named before the work begins.
    if let Some(compared) = &arguments.compare {
        if measured {
            return compare_forms(arguments, &scene, compared, piped);
        }
        let compared =
            if compared.iter().all(String::is_empty) { COMPARED.map(str::to_owned).to_vec() } else { compared.clone() };
        let cores: Vec<Chosen> =
            compared.iter().map(|entry| compared_core(entry, arguments, &scene)).collect::<Result<_, _>>()?;
        return compare(arguments, &scene, &cores, piped);
    }
    let names_core = arguments.core.is_some() || arguments.fields != SpecFields::default();
    if names_core && !scene.has_highlights() {
        return Err(Error::input(
            "a core is given, and all objects of the scene are drawn by a reflectance",
            "leave the core out, or give the materials shading = \"classical\"",
        ));
    }
    let core = match (arguments.only, &arguments.exr) {
        (Only::Exact, None) => None,
        _ if measured && !names_core => None,
        _ => Some(the_core(arguments, &scene)?),
    };

    let mut clock = Instant::now();
    let mut lap = || std::mem::replace(&mut clock, Instant::now()).elapsed().as_secs_f64();
    let tracer = Tracer::new(&scene);
    let frame = trace(&tracer, &scene);
    let traced = lap();
    // A scene without measured materials looks the same in both.
    let bases = if measured {
        shaded(&tracer, &scene, &frame, &[&scene.exact_looks()?, &scene.own_looks()?])
    } else {
        Vec::new()
    };
    let [exact_base, own_base] = [0, 1].map(|looks| bases.get(looks).unwrap_or(&frame.base));
    let lobes = Exact.of(&scene, &frame)?;
    let exact_channels = frame.channels(&scene, exact_base, &lobes);
    let exact = frame.codes(scene.channel_bits, &exact_channels);
    let mut seconds = Seconds { trace: traced, exact: lap(), core: None, files: 0.0 };
    let own = if core.is_some() || measured && (arguments.only != Only::Exact || arguments.exr.is_some()) {
        let lobes = match &core {
            Some(core) => highlights(core, arguments.through, &scene, &frame)?,
            None => lobes,
        };
        let channels = frame.channels(&scene, own_base, &lobes);
        let picture = frame.codes(scene.channel_bits, &channels);
        let difference = Difference::of(&exact, &picture);
        let psnr = reflectance::psnr(&frame, &exact_channels, &channels);
        seconds.core = core.is_some().then(&mut lap);
        Some(Own { design: core.as_ref().map(|core| &core.design), picture, difference, psnr })
    } else {
        None
    };

    // Without a budget of its own, a picture through images is only measured.
    let judged = !measured || scene.has_budget;
    let missed = own.as_ref().filter(|_| judged).map(|own| missed(&scene, &own.difference)).unwrap_or_default();
    let mut verdict = match (judged, missed.is_empty()) {
        (false, _) => "no budget is given".to_owned(),
        (true, true) => format!("within the budget: {}", budget_text(&scene)),
        (true, false) => missed.join("; "),
    };
    let materials = if measured { materials_of(&scene)? } else { Vec::new() };
    if let (true, Some(own)) = (measured, &own) {
        verdict = format!("{}; {verdict}", linear_text(own.psnr));
    }
    let mut panels = Value::Null;
    let bytes = match (arguments.only, &own) {
        (Only::All, Some(Own { design, picture, difference, .. })) => {
            let core = design.iter().map(|design| format!("core {}", core_text(design)));
            let drawn = materials.iter().map(MaterialText::to_string);
            let lines: Vec<String> = [scene_text(&scene, &frame)].into_iter().chain(core).chain(drawn).collect();
            let what = if measured { "through images" } else { "core" };
            let Sheet { pixels, panels: places } =
                sheet::triptych(&frame, [&exact, picture], what, difference, &scene.name, &lines, &verdict);
            panels = json!(places);
            pixels.png()
        }
        (Only::Core, Some(own)) => own.picture.pixels().png(),
        (Only::Difference, Some(own)) => sheet::heat_map(&frame, &own.difference, 8).png(),
        _ => exact.pixels().png(),
    };
    // Both files are made before one is written.
    let exr = match (&arguments.exr, &own) {
        (Some(path), Some(own)) => Some((path, picture::exr(&exact, &own.picture)?)),
        _ => None,
    };
    write_to(&arguments.out, &bytes)?;
    if let Some((path, bytes)) = &exr {
        write_to(path, bytes)?;
    }
    seconds.files = lap();

    if arguments.json {
        let core = own.as_ref().and_then(|own| Some((own.design?, &own.difference))).map(|(design, difference)| {
            json!({
                "name": design.spec.name,
                "digest": design.spec.digest(),
                "flags": design.spec.flags().join(" "),
                "latency": design.schedule.latency,
                "through": arguments.through,
                "difference": difference,
            })
        });
        let images = own
            .as_ref()
            .filter(|_| measured)
            .map(|own| json!({ "materials": materials, "psnr": own.psnr, "difference": own.difference }));
        say_json(&json!({
            "scene": scene.name,
            "width": frame.width,
            "height": frame.height,
            "channel_bits": scene.channel_bits,
            "samples": samples(&frame),
            "core": core,
            "images": images,
            "budget": budget_json(&scene),
            "kept": own.as_ref().filter(|_| judged).map(|_| missed.is_empty()),
            "missed": missed,
            "panels": panels,
            "seconds": seconds,
        }));
    } else if !piped {
        say(format!("{}: {}", scene.name, scene_text(&scene, &frame)));
        materials.iter().for_each(|material| say(material.to_string()));
        if let Some(Own { design, difference, .. }) = &own {
            design.iter().for_each(|design| say(format!("core {}", core_text(design))));
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
    let frame = trace(&Tracer::new(scene), scene);
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
    let classical = scene.objects.iter().filter(|object| scene.reflectance(object.material).is_none());
    let mut all: Vec<f64> = classical.map(|object| scene.materials[object.material].shininess).collect();
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
fn trace(tracer: &Tracer, scene: &Scene) -> Frame {
    let bar = progress::bar("rows traced", scene.height.into());
    let frame = Frame::trace(tracer, scene, &|| bar.inc(1));
    bar.finish_and_clear();
    frame
}

/// The picture before its highlights, with its measured materials in each of these looks.
fn shaded(tracer: &Tracer, scene: &Scene, frame: &Frame, looks: &[&Looks]) -> Vec<Vec<Colour>> {
    let bar = progress::bar("rows shaded", scene.height.into());
    let bases = reflectance::bases(tracer, scene, frame, looks, &|| bar.inc(1));
    bar.finish_and_clear();
    bases
}

/// How a measured material is drawn, for people and programs.
#[derive(Serialize)]
struct MaterialText {
    name: String,
    reflectance: String,
    shading: Shading,
    form: Option<String>,
    kib: Option<f64>,
    viewer: Viewer,
    exposure: f64,
}

impl std::fmt::Display for MaterialText {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { name, reflectance, form, kib, viewer, exposure, .. } = self;
        write!(f, "material {name}: {reflectance}, exposure {exposure:.4}, ")?;
        match form.as_ref().zip(*kib) {
            None => write!(f, "evaluated exactly"),
            Some((form, kib)) => {
                let viewer = if *viewer == Viewer::Axis { ", the viewer along the axis" } else { "" };
                write!(f, "drawn through {form}, {} KiB{viewer}", kib_text(kib))
            }
        }
    }
}

fn kib_text(kib: f64) -> String {
    if kib < 10.0 { format!("{kib:.2}") } else { format!("{kib:.0}") }
}

fn materials_of(scene: &Scene) -> Result<Vec<MaterialText>, Error> {
    let text = |(name, measured): (&str, &std::sync::Arc<Measured>)| {
        let form = (measured.shading == Shading::ImageBased).then(|| measured.form()).transpose()?;
        Ok(MaterialText {
            name: name.to_owned(),
            reflectance: measured.name.clone(),
            shading: measured.shading,
            form: form.map(|form| form.spec.to_string()),
            kib: form.map(|form| form.kib()),
            viewer: measured.viewer,
            exposure: measured.exposure,
        })
    };
    scene.measured().map(text).collect()
}

/// The ratio on linear values, over the pixels that show objects, as reflectances are judged.
fn linear_text(psnr: Option<f64>) -> String {
    psnr.map_or_else(
        || "the same picture".to_owned(),
        |psnr| format!("PSNR {psnr:.1} dB on linear values of the objects"),
    )
}

/// A picture beside the exact one.
struct Own<'a> {
    design: Option<&'a Design>,
    picture: Picture,
    difference: Difference,
    /// On linear values, over objects.
    psnr: Option<f64>,
}

/// The contact sheet of forms.
fn compare_forms(arguments: &Arguments, scene: &Scene, compared: &[String], piped: bool) -> Result<Verdict, Error> {
    if arguments.synth || arguments.family.is_some() || arguments.fields != SpecFields::default() {
        return Err(Error::input(
            "keys of a core are given, and the scene's measured materials are compared by forms",
            "leave --synth, --family and the keys of a core out",
        ));
    }
    let given: Vec<&str> = if compared.iter().all(String::is_empty) {
        Compared::DEFAULT.to_vec()
    } else {
        compared.iter().map(String::as_str).collect()
    };
    let all: Vec<Compared> = given.into_iter().map(Compared::parse).collect::<Result<_, _>>()?;
    let bar = progress::bar("forms made", all.len() as u64);
    let mut looks = vec![scene.exact_looks()?];
    for compared in &all {
        looks.push(scene.compared_looks(compared)?);
        bar.inc(1);
    }
    bar.finish_and_clear();
    let tracer = Tracer::new(scene);
    let frame = trace(&tracer, scene);
    let lobes = Exact.of(scene, &frame)?;
    let bases = shaded(&tracer, scene, &frame, &looks.iter().collect::<Vec<_>>());
    let channels: Vec<Vec<Colour>> = bases.iter().map(|base| frame.channels(scene, base, &lobes)).collect();
    let exact = frame.codes(scene.channel_bits, &channels[0]);
    let mut cells = Vec::new();
    let mut list = Vec::new();
    for (looks, own) in looks.iter().zip(&channels).skip(1) {
        let picture = frame.codes(scene.channel_bits, own);
        let difference = Difference::of(&exact, &picture);
        let psnr = reflectance::psnr(&frame, &channels[0], own);
        let kib = looks.kib.unwrap_or_default();
        list.push(json!({ "name": looks.name, "kib": kib, "psnr": psnr, "difference": difference }));
        let (lines, verdict) = (vec![format!("{} KiB", kib_text(kib))], linear_text(psnr));
        cells.push(Cell { name: looks.name.clone(), picture, difference, lines, verdict });
    }
    let materials = materials_of(scene)?;
    let of_materials = materials.iter().map(|material| format!("{}: {}", material.name, material.reflectance));
    let lines: Vec<String> = [scene_text(scene, &frame)].into_iter().chain(of_materials).collect();
    let Sheet { pixels, panels } = sheet::contact(&frame, &exact, &cells, &scene.name, &lines);
    write_to(&arguments.out, &pixels.png())?;
    if arguments.json {
        say_json(&json!({ "scene": scene.name, "materials": materials, "forms": list, "panels": panels }));
    } else if !piped {
        say(format!("{}: {}", scene.name, lines.join("; ")));
        for Cell { name, difference, lines, verdict, .. } in &cells {
            let [most, mean, _, off] = sheet::figures(difference);
            say(format!("{name}: {}; {verdict}; {most}, {mean}, {off}", lines.join(", ")));
        }
        say(arguments.out.display().to_string());
    }
    Ok(Verdict::Done)
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
    let lights = counted(scene.lights.len() as u64, "light");
    let lobes = if scene.has_highlights() {
        format!("{}, {lights}, {} samples", crate::explore::sweep::word(&scene.model), samples(frame))
    } else {
        lights
    };
    format!("{} × {} pixels, {} bits a channel, {lobes}", frame.width, frame.height, scene.channel_bits)
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
