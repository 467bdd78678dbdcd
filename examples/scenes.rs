//! Writes `docs/scenes.md` and `docs/scenes/*.png`: for each scene in `scenes/` its core beside the cheapest core for
//! 1..=1000 that is as exact, both synthesised and placed, and the pictures:
//! `cargo run --release --example scenes -- docs`.

use std::error::Error;
use std::fmt::Write;
use std::path::Path;

use brdfgen::core::Design;
use brdfgen::explore::choose::Constraints;
use brdfgen::explore::run::Costing;
use brdfgen::explore::{Cost, MaxError, Model, Results};
use brdfgen::scene::choice::Search;
use brdfgen::scene::document::{psnr_text, saving_text};
use brdfgen::scene::simplify::simplifications;
use brdfgen::scene::{CoreModel, Difference, Exact, Frame, Highlights, Picture, Requirements, Scene, sheet};
use brdfgen::spec::{Shininess, SpecFields};
use brdfgen::synth::{self, Options};

const SCENES: [&str; 5] = ["sphere", "shininess", "teapot", "bunny", "extremes"];
/// The degrees by which camera and lights are moved, as `brdfgen generate` does.
const MARGIN: f64 = 5.0;
/// The shininesses of a core that no scene is known for.
const GENERAL: Shininess = Shininess::Range(1, 1000);

/// A scene's picture through a core, and how far it is off.
fn drawn(
    scene: &Scene,
    frame: &Frame,
    exact: &Picture,
    core: &Design,
) -> Result<(Picture, Difference), Box<dyn Error>> {
    let own = frame.picture(scene, &CoreModel::new(core)?.of(scene, frame)?);
    let difference = Difference::of(exact, &own);
    Ok((own, difference))
}

fn row(name: &str, core: &str, rom_bits: u64, cost: &Cost, difference: &Difference) -> String {
    format!(
        "| {name} | {core} | {rom_bits} | {} | {} | {} | {:.0} | {} | {} | {} |\n",
        cost.lut,
        cost.dsp,
        cost.bram,
        cost.mhz.unwrap_or_default(),
        cost.latency,
        difference.max_steps,
        psnr_text(difference.psnr),
    )
}

/// The lines of a scene in the table, and what its core leaves out; its pictures are written into a directory.
fn of_scene(name: &str, results: &Results, pictures: &Path) -> Result<[String; 2], Box<dyn Error>> {
    let scene = Scene::read(Path::new(&format!("scenes/{name}.toml")))?;
    let requirements = Requirements::of(&scene, MARGIN, &|_, _| {})?;
    let costing = Costing::Estimate(Model::fit(results)?);
    let search = Search::new(&scene, &requirements, &costing, &SpecFields::default())?;
    let chosen = search.choose(&|_, _, _| {})?.chosen.ok_or("no core keeps the budget")?;
    let design = Design::new(chosen.spec()?.resolve()?)?;
    search.verified(&design)?;
    let placed = synth::synthesise(
        &design,
        &Options { seeds: 3, cache: Some(synth::default_cache()), ..Options::new(scene.core.family) },
    )?;
    let point = brdfgen::explore::Point { synthesis: Some(placed), estimate: None, ..chosen.candidate.point.clone() };
    let cost = point.cost().ok_or("no cost")?;

    let frame = Frame::render(&scene, &|| {});
    let exact = frame.picture(&scene, &Exact.of(&scene, &frame)?);
    let (own, difference) = drawn(&scene, &frame, &exact, &design)?;
    let mut table = row(name, &point.name, point.rom_bits, &cost, &difference);
    let constraints = Constraints {
        max_error: MaxError(point.max_abs),
        family: scene.core.family,
        min_mhz: None,
        objective: scene.core.objective,
        limits: Vec::new(),
        shininess: GENERAL,
        keys: SpecFields::default(),
        baselines: false,
    };
    match constraints.choose(results)?.chosen {
        Some(general) => {
            let core = Design::new(constraints.spec_of(&general)?.resolve()?)?;
            let (_, difference) = drawn(&scene, &frame, &exact, &core)?;
            let of = format!("{} n=1..1000", general.point.name);
            table += &row("", &of, general.point.rom_bits, &general.cost, &difference);
        }
        None => table += "| | none for 1..=1000 | | | | | | | | |\n",
    }
    let mut left_out = format!("\n## {name}\n\n![{name}: exact, core, difference](scenes/{name}.png)\n\n");
    for one in simplifications(&scene, &requirements, &search, &chosen)?.iter().filter(|one| one.applies) {
        let saves = one.saves.as_ref().map(|saving| format!(" Saves {}.", saving_text(saving))).unwrap_or_default();
        writeln!(left_out, "- {}: {}.{saves}", one.what, one.reason)?;
    }
    let lines = [format!("core {}", point.name)];
    let page = sheet::triptych(&frame, [&exact, &own], "core", &difference, name, &lines, "");
    std::fs::write(pictures.join(format!("{name}.png")), page.pixels.png())?;
    Ok([table, left_out])
}

fn main() -> Result<(), Box<dyn Error>> {
    let directory = std::env::args().nth(1).ok_or("name the directory of scenes.md")?;
    let pictures = Path::new(&directory).join("scenes");
    std::fs::create_dir_all(&pictures)?;
    let results = Results::built_in()?;
    let mut text = String::from(
        "# What a scene requires\n\n\
         For each scene in `scenes/` the core that `brdfgen generate` chooses for it, beside the cheapest core of the \
         measured ones for every integer\n\
         shininess from 1 to 1000 whose largest error is no greater; cheapest in LUTs, a DSP block counting as 536 and \
         a block RAM as 402. Both are synthesised and placed for ECP5 (the median of three seeds), and both draw the\n\
         scene through their bit-exact models; the error is that of the picture against the exact one, in output \
         steps.\n\
         Written by `cargo run --release --example scenes -- docs`.\n\n\
         | scene | core | ROM bits | LUT | DSP | block RAM | MHz | clocks | steps off | PSNR |\n\
         | --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n",
    );
    let mut details = String::from(
        "\nWhat each core leaves out; the savings are estimates by the cost model, each of that one thing.\n",
    );
    for name in SCENES {
        let [table, left_out] = of_scene(name, &results, &pictures)?;
        text += &table;
        details += &left_out;
    }
    std::fs::write(Path::new(&directory).join("scenes.md"), text + &details)?;
    Ok(())
}
