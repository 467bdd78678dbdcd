//! `brdfgen render`.

use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::time::Instant;

use clap::Args;
use serde::Serialize;
use serde_json::{Value, json};

use super::scene::costing;
use super::source::{read_scene, reads_core};
use super::{Verdict, progress, say, say_json, write_to};
use crate::platform::error::{Error, refuse};
use crate::platform::paths::Paths;
use crate::scene::cores::{self, PictureCore, Through};
use crate::scene::drawing::{self, Drawing, Drawn, Only, Own, scene_text};
use crate::scene::image_core;
use crate::scene::reflectance::{Compared, Looks};
use crate::scene::require::MARGIN;
use crate::scene::sheet::{self, Cell, Panel, Sheet};
use crate::scene::{Difference, Exact, Frame, Highlights, Scene, Tracer};
use crate::spec::{BlockKind, Colour, SpecFields};
use crate::target::Family;

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

    /// What the PNG file shows: the three pictures side by side with their figures, or one of them alone, pixel for
    /// pixel
    #[arg(long, value_enum, default_value = "all", conflicts_with = "compare")]
    only: Only,

    /// Write the pictures as OpenEXR too, in the layers exact, core and difference (in output steps)
    #[arg(long, value_name = "FILE.exr", conflicts_with = "compare")]
    exr: Option<PathBuf>,

    /// How the core's part of the picture is computed: by its bit-exact model, or by the core itself
    ///
    /// Verilator compiles the core, an image-based one with its sequencer, and it is given every sample of the picture.
    #[arg(long, value_enum, default_value = "model")]
    through: Through,

    /// The size of the picture in pixels [default: the scene's]
    #[arg(long, value_name = "WxH")]
    size: Option<Size>,

    /// Make a contact sheet of several cores: methods, each with keys if need be, as in `cubic,log-exp:accuracy=9`,
    /// spec files or core directories; of a scene with measured materials forms, as in `half:images=8`, and `fit`
    ///
    /// By default: quadratic, cubic, cubic-min-zero minimax, schlick, power-4, log-exp of accuracy 5 and 9; of a scene
    /// with measured materials paper of 4 and of 6 images, half, bivariate, fit.
    #[arg(long, value_name = "CORES", num_args = 0..=1, require_equals = true, value_delimiter = ',')]
    #[arg(default_missing_value = "", conflicts_with = "method")]
    compare: Option<Vec<String>>,

    /// Where a core is to be chosen: move the camera and each light by so many degrees too, 0 to 45 [default: 5]
    #[arg(long, value_name = "DEGREES", allow_negative_numbers = true)]
    #[arg(conflicts_with_all = ["compare", "core", "method"])]
    margin: Option<f64>,

    /// Costs by synthesis and placement instead of the cost model, where a core is to be chosen and with --compare
    #[arg(long, conflicts_with_all = ["core", "method"])]
    synth: bool,

    /// With --compare: the family of FPGAs that the costs are for [default: the scene's]
    #[arg(long, value_enum, requires = "compare")]
    family: Option<Family>,

    /// The core: a spec file, or the directory of a generated core; flags win over it. A lobe draws the highlights, an
    /// image-based block the materials that it is made of. Without it, --method and --block image: the cheapest lobe
    /// that keeps the scene's budget, or where materials have a reflectance none
    #[arg(long, value_name = "SPEC", conflicts_with = "compare")]
    core: Option<PathBuf>,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,

    #[command(flatten)]
    fields: SpecFields,
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

impl Seconds {
    /// The seconds since `clock`, which starts again.
    fn since(clock: &mut Instant) -> f64 {
        std::mem::replace(clock, Instant::now()).elapsed().as_secs_f64()
    }
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
    match &arguments.compare {
        Some(compared) if scene.is_measured() => compare_forms(arguments, &scene, compared, piped),
        Some(compared) => compare_cores(arguments, &scene, compared, piped),
        None => draw(arguments, &scene, piped),
    }
}

/// Draws the scene exactly and through one core, or through images.
fn draw(arguments: &Arguments, scene: &Scene, piped: bool) -> Result<Verdict, Error> {
    // Wrong specs are named before the work begins.
    let core = core_of(arguments, scene)?;
    let measured = scene.is_measured();
    let mut clock = Instant::now();
    // A scene without measured materials looks the same in both.
    let through = core.as_ref().map_or(&[][..], |core| &core.materials);
    let looks = if measured { vec![scene.exact_looks()?, scene.own_looks_but(through)?] } else { Vec::new() };
    let tracer = Tracer::new(scene);
    let (frame, bases) = trace(&tracer, scene, &looks);
    let mut seconds = Seconds { trace: Seconds::since(&mut clock), exact: 0.0, core: None, files: 0.0 };
    let [exact_base, own_base] = [0, 1].map(|looks| bases.get(looks).unwrap_or(&frame.base));
    let lobes = Exact.of(scene, &frame)?;
    let exact = Drawn::of(scene, &frame, exact_base, &lobes);
    seconds.exact = Seconds::since(&mut clock);
    let own = if core.is_some() || measured && (arguments.only != Only::Exact || arguments.exr.is_some()) {
        let own = match &core {
            Some(core) if core.is_image() => {
                let base = imaged(core, arguments.through, scene, (&tracer, &frame), own_base)?;
                Drawn::of(scene, &frame, &base, &lobes)
            }
            Some(core) => {
                let lobes = highlights(core, arguments.through, scene, &frame)?;
                Drawn::of(scene, &frame, own_base, &lobes)
            }
            None => Drawn::of(scene, &frame, own_base, &lobes),
        };
        let own = Own::of(&frame, &exact, own);
        seconds.core = core.is_some().then(|| Seconds::since(&mut clock));
        Some(own)
    } else {
        None
    };

    let drawing = Drawing::of(scene, &frame, exact.picture, core.as_ref(), own)?;
    let (bytes, panels) = drawing.png(arguments.only);
    // Both files are made before one is written.
    let exr = match &arguments.exr {
        Some(path) => drawing.exr()?.map(|bytes| (path, bytes)),
        None => None,
    };
    write_to(&arguments.out, &bytes)?;
    if let Some((path, bytes)) = &exr {
        write_to(path, bytes)?;
    }
    seconds.files = Seconds::since(&mut clock);
    if arguments.json {
        say_json(&json_of(arguments, (scene, &frame), &drawing, panels.as_deref(), &seconds));
    } else if !piped {
        describe(arguments, (scene, &frame), &drawing, &seconds);
    }
    Ok(Verdict::of(drawing.missed.is_none_or(|missed| missed.is_empty())))
}

/// A picture and how it came to be, for programs.
fn json_of(
    arguments: &Arguments,
    (scene, frame): (&Scene, &Frame),
    drawing: &Drawing<'_>,
    panels: Option<&[Panel]>,
    seconds: &Seconds,
) -> Value {
    let core = drawing.own.as_ref().zip(drawing.design).map(|(own, design)| {
        json!({
            "name": design.spec.name,
            "digest": design.spec.digest(),
            "flags": design.spec.flags().join(" "),
            "latency": design.whole_latency(),
            "through": arguments.through,
            "difference": own.difference,
        })
    });
    let images = drawing.own.as_ref().filter(|_| scene.is_measured());
    let images =
        images.map(|own| json!({ "materials": drawing.materials, "psnr": own.psnr, "difference": own.difference }));
    json!({
        "scene": scene.name,
        "width": frame.width,
        "height": frame.height,
        "channel_bits": scene.channel_bits,
        "samples": frame.samples(),
        "core": core,
        "images": images,
        "budget": budget_json(scene),
        "kept": drawing.missed.as_ref().map(Vec::is_empty),
        "missed": drawing.missed.as_deref().unwrap_or_default(),
        "panels": panels,
        "seconds": seconds,
    })
}

/// Says what was drawn.
fn describe(arguments: &Arguments, (scene, frame): (&Scene, &Frame), drawing: &Drawing<'_>, seconds: &Seconds) {
    say(format!("{}: {}", scene.name, scene_text(scene, frame)));
    drawing.materials.iter().for_each(|material| say(material.to_string()));
    if let Some(Own { difference, .. }) = &drawing.own {
        drawing.design.iter().for_each(|design| say(cores::text(design)));
        say(format!("  {}", sheet::figures(difference).join(", ")));
        say(format!("  pixels by the steps that they are off: {}", histogram(difference)));
        say(format!("  {}", drawing.verdict));
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

/// The contact sheet of cores.
fn compare_cores(arguments: &Arguments, scene: &Scene, compared: &[String], piped: bool) -> Result<Verdict, Error> {
    // Wrong specs are named before the work begins.
    let cores: Vec<PictureCore> = entries(compared, &COMPARED)
        .map(|entry| PictureCore::named(scene, entry, arguments.fields.clone()))
        .collect::<Result<_, _>>()?;
    let family = arguments.family.unwrap_or(scene.core.family);
    let costing = costing(arguments.synth)?;
    let (frame, _) = trace(&Tracer::new(scene), scene, &[]);
    let exact = frame.picture(scene, &Exact.of(scene, &frame)?);
    let bar = progress::bar("cores", cores.len() as u64);
    let mut cells = Vec::new();
    let mut list = Vec::new();
    for core in &cores {
        let own = frame.picture(scene, &highlights(core, arguments.through, scene, &frame)?);
        let cost = costing.cost(&core.design, family)?;
        let (cell, kept) = drawing::cell_of_core(scene, &exact, &core.design, own, &cost);
        list.push(json!({
            "name": cell.name,
            "flags": core.design.spec.flags().join(" "),
            "cost": cost,
            "difference": cell.difference,
            "kept": kept,
        }));
        cells.push(cell);
        bar.inc(1);
    }
    bar.finish_and_clear();
    let source = if arguments.synth { "measured" } else { "estimated" };
    let shininesses = scene.shininesses().iter().map(f64::to_string).collect::<Vec<_>>().join(", ");
    let lines = [
        scene_text(scene, &frame),
        format!("shininess {shininesses}; budget: {}", drawing::budget_text(scene)),
        format!("cost for {}, {source}", family.name),
    ];
    let Sheet { pixels, panels } = sheet::contact(&frame, &exact, &cells, &scene.name, &lines);
    write_to(&arguments.out, &pixels.png())?;
    if arguments.json {
        say_json(&json!({
            "scene": scene.name,
            "width": frame.width,
            "height": frame.height,
            "channel_bits": scene.channel_bits,
            "samples": frame.samples(),
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

/// The contact sheet of forms.
fn compare_forms(arguments: &Arguments, scene: &Scene, compared: &[String], piped: bool) -> Result<Verdict, Error> {
    refuse!(
        arguments.synth || arguments.family.is_some() || arguments.fields != SpecFields::default(),
        "keys of a core are given, and the scene's measured materials are compared by forms",
        "leave --synth, --family and the keys of a core out"
    );
    let all: Vec<Compared> = entries(compared, &Compared::DEFAULT).map(Compared::parse).collect::<Result<_, _>>()?;
    let bar = progress::bar("forms made", all.len() as u64);
    let mut looks = vec![scene.exact_looks()?];
    for compared in &all {
        looks.push(scene.compared_looks(compared)?);
        bar.inc(1);
    }
    bar.finish_and_clear();
    let (frame, bases) = trace(&Tracer::new(scene), scene, &looks);
    let lobes = Exact.of(scene, &frame)?;
    let mut drawn = bases.iter().map(|base| Drawn::of(scene, &frame, base, &lobes));
    let exact = drawn.next().expect("the exact look is the first");
    let mut cells = Vec::new();
    let mut list = Vec::new();
    for (looks, drawn) in looks.iter().skip(1).zip(drawn) {
        let own = Own::of(&frame, &exact, drawn);
        let kib = looks.kib.unwrap_or_default();
        list.push(json!({ "name": looks.name, "kib": kib, "psnr": own.psnr, "difference": own.difference }));
        cells.push(own.cell_of_form(looks));
    }
    let materials = drawing::materials_of(scene, None)?;
    let of_materials = materials.iter().map(|material| format!("{}: {}", material.name, material.reflectance));
    let lines: Vec<String> = [scene_text(scene, &frame)].into_iter().chain(of_materials).collect();
    let Sheet { pixels, panels } = sheet::contact(&frame, &exact.picture, &cells, &scene.name, &lines);
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

/// What is compared: what is named, or these where nothing is.
fn entries<'a>(named: &'a [String], otherwise: &'a [&'a str]) -> impl Iterator<Item = &'a str> {
    let none = named.iter().all(String::is_empty);
    let named = named.iter().map(String::as_str).filter(move |_| !none);
    named.chain(otherwise.iter().copied().filter(move |_| none))
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

/// The core that the arguments name, or that the scene needs; none where no picture is drawn through one.
fn core_of(arguments: &Arguments, scene: &Scene) -> Result<Option<PictureCore>, Error> {
    let keys = arguments.fields.clone();
    let is_named = arguments.core.is_some() || keys != SpecFields::default();
    if arguments.only == Only::Exact && arguments.exr.is_none() || scene.is_measured() && !is_named {
        return Ok(None);
    }
    let core = match &arguments.core {
        Some(path) => PictureCore::of_file(scene, path, keys)?,
        None if keys.method.is_some() || keys.block == Some(BlockKind::Image) => PictureCore::of_keys(scene, keys)?,
        None => {
            let bar = progress::bar("rendering", 1);
            let (margin, costing) = (arguments.margin.unwrap_or(MARGIN), costing(arguments.synth)?);
            let core = PictureCore::needed(scene, margin, &costing, &keys, &progress::steps(&bar))?;
            bar.finish_and_clear();
            core
        }
    };
    Ok(Some(core))
}

/// The picture before its highlights, and with its measured materials in each of these looks.
fn trace(tracer: &Tracer, scene: &Scene, looks: &[Looks]) -> (Frame, Vec<Vec<Colour>>) {
    let bar = progress::bar("rows traced", scene.height.into());
    let traced = Frame::with_looks(tracer, scene, looks, &|| bar.inc(1));
    bar.finish_and_clear();
    traced
}

/// The picture before its highlights with the materials of an image-based core drawn through it.
fn imaged(
    core: &PictureCore,
    through: Through,
    scene: &Scene,
    (tracer, frame): (&Tracer, &Frame),
    base: &[Colour],
) -> Result<Vec<Colour>, Error> {
    let samples = frame.material.iter().filter(|material| core.materials.contains(&usize::from(**material))).count();
    let bar = match through {
        Through::Model => progress::bar("rows through the core's model", scene.height.into()),
        Through::Verilator => progress::bar("samples through the compiled core", samples as u64),
    };
    let codes = core.imaged(through, scene, tracer, &|done| bar.set_position(done))?;
    bar.finish_and_clear();
    Ok(image_core::added(base, &codes, scene.channel_bits))
}

/// The core's highlights.
fn highlights(core: &PictureCore, through: Through, scene: &Scene, frame: &Frame) -> Result<Vec<f64>, Error> {
    let of_samples = || progress::bar("samples through the compiled core", frame.samples());
    let bar = (through == Through::Verilator).then(of_samples);
    let highlights = core.highlights(through, scene, frame, &|done| bar.iter().for_each(|bar| bar.set_position(done)));
    bar.iter().for_each(|bar| bar.finish_and_clear());
    highlights
}

fn budget_json(scene: &Scene) -> Value {
    let (max_steps, min_psnr) = scene.budget.limits();
    json!({ "max_steps": max_steps, "min_psnr": min_psnr })
}

/// The pixels off by 0, 1, 2 and so on; long lists with their greatest only.
fn histogram(difference: &Difference) -> String {
    const LISTED: usize = 12;
    let listed = difference.pixels.iter().take(LISTED).enumerate().map(|(steps, count)| format!("{steps}: {count}"));
    let more: u64 = difference.pixels.iter().skip(LISTED).sum();
    let more = (more > 0).then(|| format!("more: {more}"));
    listed.chain(more).collect::<Vec<_>>().join(", ")
}
