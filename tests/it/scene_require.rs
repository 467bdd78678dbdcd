//! What scenes require, and the cores that are chosen for them.

use std::path::Path;

use brdfgen::core::Design;
use brdfgen::explore::choose::Ranking;
use brdfgen::explore::run::Costing;
use brdfgen::explore::{Model, Results};
use brdfgen::scene::choice::{SceneCore, Search};
use brdfgen::scene::simplify::simplifications;
use brdfgen::scene::survey::DEGREE_BINS;
use brdfgen::scene::{Requirements, Scene};
use brdfgen::spec::SpecFields;

use crate::common::Scratch;

/// A sphere with the light behind the camera, which is so far away that its rays are parallel.
fn lone(model: &str, n: f64, more: &str) -> String {
    format!(
        "name = 'lone'\nmodel = '{model}'\nwidth = 200\nheight = 200\n{more}\n\
         [camera]\nposition = [0.0, 0.0, 4000.0]\nfield_of_view = 0.03\n\
         [[light]]\ndirection = [0.0, 0.0, 1.0]\n\
         [[material]]\nname = 'clay'\nshininess = {n}\nk_a = 0.2\nk_d = 0.4\nk_s = 0.4\n\
         [[object]]\nkind = 'sphere'\nmaterial = 'clay'\ncentre = [0.0, 0.0, 0.0]\nradius = 1.0\n"
    )
}

/// Three materials, two of the same shininess, and one on an object that another hides.
const HIDDEN: &str = "\
    name = 'hidden'\nmodel = 'phong'\nwidth = 96\nheight = 72\n\
    [camera]\nposition = [0.0, 0.0, 10.0]\nfield_of_view = 30.0\n\
    [[light]]\ndirection = [0.3, 0.4, 1.0]\n\
    [[material]]\nname = 'front'\nshininess = 20.0\nk_s = 0.5\n\
    [[material]]\nname = 'back'\nshininess = 55.5\nk_s = 0.5\n\
    [[material]]\nname = 'side'\nshininess = 20.0\nk_s = 0.3\n\
    [[material]]\nname = 'matte'\nshininess = 300.0\nk_s = 0.0\n\
    [[material]]\nname = 'nowhere'\nshininess = 77.0\nk_s = 0.5\n\
    [[object]]\nkind = 'sphere'\nmaterial = 'front'\ncentre = [0.0, 0.0, 0.0]\nradius = 1.0\n\
    [[object]]\nkind = 'sphere'\nmaterial = 'back'\ncentre = [0.0, 0.0, -4.0]\nradius = 0.3\n\
    [[object]]\nkind = 'sphere'\nmaterial = 'side'\ncentre = [1.8, 0.0, 0.0]\nradius = 0.6\n\
    [[object]]\nkind = 'sphere'\nmaterial = 'matte'\ncentre = [-1.8, 0.0, 0.0]\nradius = 0.6\n";

fn scene(text: &str) -> Scene {
    Scene::parse(text, "scene.toml", Path::new("")).unwrap()
}

fn required(scene: &Scene, margin: f64) -> Requirements {
    Requirements::of(scene, margin, &|_, _| {}).unwrap()
}

fn estimates() -> Costing {
    Costing::Estimate(Model::fit(&Results::built_in().unwrap()).unwrap())
}

fn keys(text: &str) -> SpecFields {
    SpecFields::parse(text, "keys").unwrap()
}

#[test]
fn the_cosines_of_a_sphere_are_distributed_as_its_geometry_says() {
    // On the disc that is seen, the part within the angle a of the middle is sin^2 a. Blinn's cosine is that of a here,
    // Phong's of 2 a.
    for (model, times) in [("blinn", 1.0), ("phong", 2.0)] {
        let n = 10.0f64;
        let found = required(&scene(&lone(model, n, "")), 0.0);
        let counts = found.base;
        let all = counts.lit() as f64;
        assert!(all > 20_000.0 && counts.dark < 100, "{counts:?}");
        let spread = &found.materials[0].spread;
        assert_eq!(spread.degrees.iter().sum::<u64>(), counts.lit());
        assert_eq!(spread.scaled.iter().sum::<u64>(), counts.lit());
        let mut within = 0u64;
        for (bin, count) in spread.degrees.iter().enumerate() {
            within += count;
            let angle =
                ((bin + 1) as f64 * 180.0 / DEGREE_BINS as f64 / times).to_radians().min(std::f64::consts::FRAC_PI_2);
            let expected = angle.sin().powi(2);
            assert!(
                (within as f64 / all - expected).abs() < 0.006,
                "{model} {bin}: {} {expected}",
                within as f64 / all
            );
        }
        let within = |cosine: f64| ((cosine.acos() / times).sin()).powi(2);
        let epicentre = within(2f64.powf(-1.0 / n));
        assert!((counts.epicentre as f64 / all - epicentre).abs() < 0.006, "{counts:?} {epicentre}");
        let visible = within((0.5f64 / (0.4 * 255.0)).powf(1.0 / n)) - epicentre;
        assert!((counts.visible_tail as f64 / all - visible).abs() < 0.006, "{counts:?} {visible}");
        let negative = counts.negative as f64 / all;
        let expected = if model == "phong" { 0.5 } else { 0.0 };
        assert!((negative - expected).abs() < 0.006, "{negative}");
        assert!((found.invisible_below.unwrap() - 0.5 / 102.0).abs() < 1e-12);
    }
}

#[test]
fn only_phong_has_negative_cosines_on_a_convex_body() {
    // With N.L and N.V above 0, Phong's 2 (N.L)(N.V) - L.V is negative somewhere unless the light comes from behind.
    for (direction, behind) in [("[1.0, 0.2, 0.1]", false), ("[0.0, 1.0, -0.8]", true), ("[-0.5, -0.5, 1.0]", false)] {
        let of = |model: &str| {
            let text = lone(model, 30.0, "").replace("[0.0, 0.0, 1.0]", direction);
            required(&scene(&text), 5.0)
        };
        let (blinn, phong) = (of("blinn"), of("phong"));
        assert!(blinn.stays_in_range() && blinn.least_cosine.unwrap() >= 0.0, "{direction}");
        assert_eq!((phong.stays_in_range(), phong.least_cosine.unwrap() < 0.0), (behind, !behind), "{direction}");
        assert_eq!((phong.base.negative == 0, phong.moved.negative == 0), (behind, behind), "{direction}");
    }
}

#[test]
fn a_row_is_needed_by_what_is_lit_and_the_margin_brings_more_into_view() {
    let scene = scene(HIDDEN);
    let rows = |found: &Requirements| -> Vec<(String, f64)> {
        found.rows.iter().map(|row| (row.name.clone(), row.shininess)).collect()
    };
    let still = required(&scene, 0.0);
    assert_eq!(rows(&still), [("front+side".to_owned(), 20.0)]);
    assert_eq!(still.materials.iter().map(|need| need.row).collect::<Vec<_>>(), [Some(0), None, Some(0), None, None]);
    assert_eq!(still.materials.iter().map(|need| need.used).collect::<Vec<_>>(), [true, true, true, true, false]);
    assert!(still.base.matte > 0 && still.materials[3].base.lit() == 0);
    assert_eq!(still.pictures, ["base"]);
    let moved = required(&scene, 30.0);
    assert_eq!(rows(&moved), [("front+side".to_owned(), 20.0), ("back".to_owned(), 55.5)]);
    assert_eq!(moved.materials[1].base.lit(), 0);
    assert!(moved.materials[1].moved.lit() > 0);
    assert_eq!(moved.base, still.base);
    assert!(
        Requirements::of(&scene, 46.0, &|_, _| {}).is_err() && Requirements::of(&scene, f64::NAN, &|_, _| {}).is_err()
    );
}

#[test]
fn saturation_is_found_where_the_channels_exceed_full_scale() {
    let dim = required(&scene(&lone("phong", 20.0, "ambient = [0.1, 0.1, 0.1]")), 2.0);
    assert_eq!(dim.saturated, [0, 0]);
    let bright = lone("phong", 20.0, "ambient = [1.0, 1.0, 1.0]").replace("k_a = 0.2", "k_a = 0.4");
    let found = required(&scene(&bright), 2.0);
    // 0.4 + 0.4 cos a + 0.4 cos^20 2a > 1 up to an angle a of 13.4 degrees, on the part sin^2 a of the disc.
    let within = (0..900).map(|tenth| f64::from(tenth) / 10.0).take_while(|degrees| {
        let angle = degrees.to_radians();
        0.4 + 0.4 * angle.cos() + 0.4 * (2.0 * angle).cos().powi(20) > 1.0
    });
    let part = within.last().unwrap().to_radians().sin().powi(2);
    let own = found.saturated[0] as f64 / found.base.samples as f64;
    assert!((own - part).abs() < 0.003, "{own} {part}");
    assert!(found.saturated[1] > 0);
}

/// By counting alone: the cheapest of the cores that keep the budget.
fn by_hand<'a>(scene: &Scene, all: &'a [SceneCore]) -> Option<&'a SceneCore> {
    let allowed = scene.budget.max_steps.unwrap();
    let keeps = |core: &&SceneCore| u32::from(core.base.max_steps.max(core.moved.max_steps)) <= allowed;
    all.iter().filter(keeps).min_by(|a, b| {
        let costs = |core: &SceneCore| {
            let cost = &core.candidate.cost;
            [cost.lut + 536 * cost.dsp + 402 * cost.bram, cost.dsp, cost.bram, cost.latency, cost.ff]
        };
        let worst = |core: &SceneCore| core.base.mean_square.max(core.moved.mean_square);
        costs(a).cmp(&costs(b)).then(worst(a).total_cmp(&worst(b)))
    })
}

#[test]
fn the_chosen_core_is_the_cheapest_that_keeps_the_budget_and_its_widths_are_needed() {
    let scene = scene(HIDDEN);
    let found = required(&scene, 5.0);
    let costing = estimates();
    let search = Search::new(&scene, &found, &costing, &SpecFields::default()).unwrap();
    let all = search.candidates(&|_, _| {});
    let choice = search.choose(&|_, _, _| {}).unwrap();
    let chosen = choice.chosen.as_ref().unwrap();
    assert_eq!(by_hand(&scene, &all).unwrap(), chosen);
    assert_eq!(choice.considered, all.len());
    let Ranking { meeting, misses } = search.ranked(all.clone(), None);
    assert_eq!((meeting.len(), &meeting[0]), (choice.meeting, chosen));
    assert!(misses.iter().all(|miss| miss.octaves > 0.0 && !miss.why.is_empty()));
    assert!(choice.runner_ups.len() >= 5, "{}", choice.runner_ups.len());
    assert!(choice.runner_ups.iter().all(|one| one.core != *chosen && !one.why.is_empty()));
    // No view may be worse than the bound, so neither is any of these.
    for core in &all {
        let worst = core.base.max_steps.max(core.moved.max_steps);
        assert!(
            u32::from(worst) <= core.guaranteed_steps(),
            "{} {worst} {}",
            core.candidate.point.name,
            core.guarantee
        );
    }

    // The pictures through the model are those that it was chosen by.
    let design = Design::new(chosen.spec().unwrap().resolve().unwrap()).unwrap();
    let verified = search.verified(&design).unwrap();
    assert_eq!(verified.samples, found.base.lit() + found.moved.lit() + shadowless_matte(&scene, &found));
    assert_eq!(verified.base.max_steps, chosen.base.max_steps);
    assert_eq!(verified.base.pixels.iter().skip(1).sum::<u64>(), chosen.base.pixels_off);
    let psnr = |psnr: Option<f64>| psnr.unwrap_or(999.0);
    assert!((psnr(verified.base.psnr) - psnr(chosen.base.psnr)).abs() < 1e-9);
    assert_eq!(verified.moved.max_steps, chosen.moved.max_steps);

    // What is undone costs at least as much in ROM or in logic, and what was cut is needed: with a bit less, no core
    // keeps the budget.
    let list = simplifications(&scene, &found, &search, chosen).unwrap();
    let materials = &list[0];
    let saving = materials.saves.unwrap();
    // A core for every shininess may do with smaller tables, and more logic behind them.
    let is_dearer = saving.without_rom_bits >= saving.with_rom_bits || saving.without.lut >= saving.with.lut;
    assert!(materials.applies && is_dearer, "{saving:?}");
    let fewest = found.input_fraction.measured.unwrap();
    let method = chosen.spec().unwrap();
    for narrow in [fewest - 1, fewest - 2] {
        let keys = SpecFields {
            method: method.method,
            coefficients: method.coefficients,
            input_fraction: Some(narrow),
            ..SpecFields::default()
        };
        let search = Search::new(&scene, &found, &costing, &keys).unwrap();
        let narrowed = search.choose(&|_, _, _| {}).unwrap();
        assert!(narrowed.chosen.is_none() && !narrowed.misses.is_empty(), "F = {narrow}");
        assert!(narrowed.misses[0].why[0].contains("is off by"), "{:?}", narrowed.misses[0].why);
    }
}

/// The samples of materials without a highlight that a light reaches: the model computes them too.
fn shadowless_matte(scene: &Scene, found: &Requirements) -> u64 {
    let frame = brdfgen::scene::Frame::render(scene, &|| {});
    let matte = |sample: usize| found.materials[usize::from(frame.material[sample / frame.lights])].peak_steps == 0.0;
    (0..frame.versine.len()).filter(|&sample| !frame.versine[sample].is_nan() && matte(sample)).count() as u64
}

#[test]
fn keys_narrow_the_choice_and_a_port_for_0_to_1_is_chosen_where_it_may() {
    let costing = estimates();
    for (model, unit) in [("blinn", true), ("phong", false)] {
        let scene = scene(&lone(model, 40.0, "").replace("200", "60"));
        let found = required(&scene, 5.0);
        let fields = keys("method = 'segmented-4'\npipeline = 9");
        let search = Search::new(&scene, &found, &costing, &fields).unwrap();
        let chosen = search.choose(&|_, _, _| {}).unwrap().chosen.unwrap();
        let spec = chosen.spec().unwrap();
        assert_eq!((spec.method, spec.pipeline), (fields.method, fields.pipeline));
        assert_eq!(spec.name.as_deref(), Some("lone"));
        let resolved = spec.clone().resolve().unwrap();
        assert_eq!(resolved.block.lobe().interface.input_range == brdfgen::spec::InputRange::Unit, unit);
        let list = simplifications(&scene, &found, &search, &chosen).unwrap();
        let range = list.iter().find(|one| one.what == "no negative cosines").unwrap();
        assert_eq!((range.applies, range.saves.is_some()), (unit, unit), "{}", range.reason);
        let refused = Search::new(&scene, &found, &costing, &keys("method = 'cubic'\nshininess = '1..=9'"));
        assert!(refused.err().unwrap().to_string().contains("serves the shininesses of the scene"));
    }
}

#[test]
fn a_scene_becomes_a_core_with_its_documents_the_same_on_any_number_of_threads() {
    let scratch = Scratch::new();
    scratch.write("hidden.toml", format!("{HIDDEN}[core]\nmethod = 'segmented-4'\n"));
    let run = |threads: &str, out: &str| {
        let line = ["generate", "hidden.toml", "--margin", "3", "--out", out];
        let output = scratch.command().env("RAYON_NUM_THREADS", threads).args(line).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).unwrap()
    };
    let said = run("1", "one");
    run("4", "four");
    assert_eq!(scratch.tree("one"), scratch.tree("four"));
    for words in ["left out:", "only the scene's materials", "runners-up ", "any other view"] {
        assert!(said.contains(words), "{words}\n{said}");
    }
    scratch.run("generate hidden.toml --margin 3 --out one --check").succeeds();
    scratch.run("cosim one --sim builtin").succeeds();
    let json: serde_json::Value = serde_json::from_str(&scratch.text("one/scene.json")).unwrap();
    assert_eq!((&json["port"], &json["materials"][0]["code"]), (&"in_n".into(), &0.into()));
    assert_eq!(json["materials"][1]["modelled"], false);
    assert_eq!(json["through_the_model"]["base"]["max_steps"], 1);
    let sheet = scratch.text("one/scene.md");
    assert!(sheet.contains("| front | 20 | 0 |") && sheet.contains("not modelled"), "{sheet}");
    // Made again from its directory, the core keeps the documents of its scene.
    scratch.run("generate one --out one --check").succeeds();
    scratch.run("generate one --out one").succeeds();
    scratch.run("generate one --out again").succeeds();
    assert_eq!((scratch.text("one/scene.md"), scratch.tree("again")), (sheet, scratch.tree("one")));
    // What depends on the margin is in the documents.
    scratch.run("generate hidden.toml --margin 2 --out one --check").ends_with(1);
    // Every other command wants a core.
    scratch
        .run("eval hidden.toml --n 20 --x 0.5")
        .refuses(&["hidden.toml is a scene", "brdfgen generate hidden.toml --out DIR"]);
    scratch.refused("generate hidden.toml --max-error 1% --out other", &["a scene says itself"]);
    scratch.refused(
        "generate --method cubic --shininess 5 --margin 3 --out other",
        &["--margin, --synth and --for-material are for scenes"],
    );
    scratch.refused("generate hidden.toml --margin 90 --out other", &["a margin of 90 degrees is out of range"]);
}

#[test]
fn a_budget_that_no_core_keeps_ends_with_the_nearest_misses() {
    let scratch = Scratch::new();
    scratch.write("strict.toml", format!("{HIDDEN}[core]\nmethod = 'quadratic'\n[budget]\nmax_steps = 0\n"));
    let before = scratch.tree("");
    let run = scratch.run("generate strict.toml --out core").ends_with(1);
    assert!(run.stderr.contains("no core keeps an error of at most 0 steps"), "{}", run.stderr);
    assert!(run.stderr.contains("nearest misses ") && run.stderr.contains("where 0 are allowed"), "{}", run.stderr);
    assert_eq!(scratch.tree(""), before);
    let json = scratch.run("scene inspect strict.toml --json").ends_with(1).json();
    assert!(json["choice"]["chosen"].is_null() && json["choice"]["misses"][0]["octaves"].as_f64().unwrap() > 0.0);
    let dark = HIDDEN.replace("k_s = 0.5", "k_s = 0.0").replace("k_s = 0.3", "k_s = 0.0");
    scratch.write("dark.toml", dark);
    scratch.run("scene inspect dark.toml").refuses(&["needs no core"]);
}

#[test]
fn one_of_a_thing_is_singular_and_what_is_not_there_is_not_named() {
    let scratch = Scratch::new();
    let small =
        lone("phong", 10.5, "shadows = false").replace("200", "40").replace("shininess = 10.5", "roughness = 0.4");
    scratch.write("lone.toml", &small);
    let said = scratch.run("scene inspect lone.toml --margin 0").succeeds().stdout;
    for words in ["1 light; no moved pictures", "  10.5  ", "n=1 material:", "1 step at most"] {
        assert!(said.contains(words), "{words}\n{said}");
    }
    for words in [" 1 steps", "=1 materials", " 1 lights", "10.4999", " 1 DSPs", " 1 LUTs"] {
        assert!(!said.contains(words), "{words}\n{said}");
    }
    // A frequency that no core reaches is no fault of the budget.
    scratch.write("fast.toml", format!("{small}[core]\nmin_mhz = 1000.0\n"));
    let said = scratch.run("scene inspect fast.toml").ends_with(1).stdout;
    assert!(said.contains("no core keeps an error of at most 1 step at 1000 MHz or more"), "{said}");
    // What is no scene is told apart, and a margin below 0 is no flag.
    scratch.write("spec.toml", "method = 'cubic'\n");
    scratch.run("scene inspect spec.toml").refuses(&["spec.toml is the spec of a core, and no scene"]);
    scratch.run("scene inspect lone.toml --margin -1").refuses(&["a margin of -1 degrees is out of range"]);
    scratch.run_each(["scene", "inspect", "."]).refuses(&[". is a directory, and no scene"]);
}

/// Where a view may meet the whole lobe however few points of it the pictures show, no channel is off by more than the
/// whole highlight.
#[test]
fn no_view_is_off_by_more_than_the_highlight() {
    let scene = scene(&lone("phong", 1000.0, "").replace("= 200", "= 1"));
    let needs = required(&scene, 0.0);
    let costing = estimates();
    let search = Search::new(&scene, &needs, &costing, &keys("method = 'quadratic'\ninput_fraction = 4")).unwrap();
    let all = search.candidates(&|_, _| {});
    assert!(!all.is_empty());
    for core in all {
        assert!(core.guarantee > 50.0 && core.guarantee <= needs.materials[0].peak_steps + 1e-9, "{}", core.guarantee);
    }
}
