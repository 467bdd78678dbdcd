//! Scenes through image-based cores: the bit-exact model against pixels that are computed here, the compiled core with
//! its sequencer against the model, and the choice of such a core for a scene.
//!
//! Needs verilator; `test.sh` installs it.

use std::path::Path;

use brdfgen::block::image::quality::SphereError;
use brdfgen::core::{BlockDesign, Design};
use brdfgen::reflectance::vector::seen_from;
use brdfgen::reflectance::{Light, Vector};
use brdfgen::scene::{LightKind, Scene};
use brdfgen::spec::{Block, ImageSource, ImageSpec, SpecFields};
use resvg::tiny_skia::Pixmap;
use serde_json::Value;

use crate::common::{Scratch, pixels};

/// A sphere of a measured material under a distant and a near light; `{}` is what else its reflectance's table says.
fn sphere(keys: &str) -> String {
    format!(
        "width = 48\nheight = 40\n[camera]\nposition = [0.5, 0.8, 4.0]\n[[material]]\nname = \"own\"\n\
         [material.reflectance]\nmodel = \"ggx\"\nexposure = 1.5\n{keys}\n\
         [[light]]\ndirection = [1.0, 1.0, 0.4]\ncolour = [1.0, 0.5, 0.25]\n\
         [[light]]\nposition = [-1.2, 1.5, 2.0]\nintensity = 0.5\n[[object]]\nkind = \"sphere\"\nmaterial = \"own\"\n"
    )
}

/// The keys of a small core.
const SMALL: &str = "--block image --image-form bivariate --image-size 16 --octaves 4";

/// Normal, direction to the viewer and to each light of a pixel of the unit sphere.
fn geometry(scene: &Scene, way: [f64; 3]) -> Option<(Vector, Vector, Vec<Vector>)> {
    let (eye, way) = (Vector::from(scene.camera.position), Vector::from(way).normalize());
    let b = eye.dot(&way);
    let root = b * b - eye.dot(&eye) + 1.0;
    let n = eye + way * (-b - root.max(0.0).sqrt());
    let l = |light: &brdfgen::scene::Light| match light.kind {
        LightKind::Directional(way) => Vector::from(way),
        LightKind::Point(place) => (Vector::from(place) - n).normalize(),
    };
    (root >= 0.0).then(|| (n, -way, scene.lights.iter().map(l).collect()))
}

#[test]
fn a_picture_through_a_core_is_that_of_its_sums() {
    for viewer in ["pixel", "axis"] {
        let scratch = Scratch::new();
        let text = sphere(&format!("viewer = \"{viewer}\""));
        scratch.write("own.toml", &text);
        scratch.run(&format!("render own.toml {SMALL} --only core --out p.png")).succeeds();
        let own = pixels(&scratch.read("p.png"));
        let scene = Scene::parse(&text, "own.toml", Path::new("")).unwrap();
        let spec = "block = 'image'\nimage_form = 'bivariate'\nimage_size = 16\noctaves = 4\n[reflectance]\n\
                    model = 'ggx'\nexposure = 1.5\n";
        let design = Design::new(SpecFields::parse(spec, "own").unwrap().resolve().unwrap()).unwrap();
        let BlockDesign::Image(image) = design.block() else { panic!("an image-based block") };
        let sums = design.sums().unwrap();
        let axes = scene.camera.axes().map(Vector::from);
        let turned = |a: Vector| Vector::new(a.dot(&axes[0]), a.dot(&axes[1]), -a.dot(&axes[2]));
        let ways = (0..scene.height).flat_map(|row| scene.camera.row(scene.width, scene.height, row));
        let (mut same, mut checked, mut lit) = (0, 0, 0);
        for (pixel, way) in own.iter().zip(ways) {
            let Some((n, v, lights)) = geometry(&scene, way) else {
                assert_eq!(*pixel, [0; 3]);
                continue;
            };
            if n.dot(&v) < 0.02 {
                continue;
            }
            let mut totals = [0; 3];
            for (l, light) in lights.into_iter().zip(&scene.lights) {
                let (at, n) = match viewer {
                    "pixel" => seen_from(l, v, n),
                    _ => (Light::towards(turned(l)), turned(n)),
                };
                let outputs = design.evaluate(&image.inputs(n, &[(at, light.colour)]));
                (0..3).for_each(|c| totals[c] += outputs[c]);
            }
            let shift = sums.frac_bits - 8;
            let wanted = totals.map(|total| ((total + (1 << (shift - 1))) >> shift).min(255));
            // A normal's last bit may be another here.
            assert!((0..3).all(|c| (pixel[c] - wanted[c]).abs() <= 1), "{viewer}: {pixel:?} {wanted:?}");
            same += usize::from(*pixel == wanted);
            checked += 1;
            lit += usize::from(wanted[0] > 20);
        }
        assert!(lit > 150 && same * 100 > checked * 99, "{viewer}: {same} of {checked}, {lit} lit");
    }
}

/// A sphere and a classical plane under three lights, with shadows; one light from behind.
const SHADOWS: &str = "width = 40\nheight = 32\nshadows = true\nambient = [0.2, 0.2, 0.2]\n[camera]\n\
    position = [0.5, 1.4, 4.0]\n[[material]]\nname = \"own\"\nk_a = 0.3\n[material.reflectance]\n\
    model = \"gold-paint\"\n[[material]]\nname = \"floor\"\nshininess = 12.0\n\
    [[light]]\ndirection = [1.0, 1.0, 0.4]\n[[light]]\nposition = [-1.2, 2.5, 2.0]\n\
    [[light]]\ndirection = [0.1, 0.3, -1.0]\n[[object]]\nkind = \"sphere\"\nmaterial = \"own\"\n\
    [[object]]\nkind = \"plane\"\nmaterial = \"floor\"\npoint = [0.0, -1.0, 0.0]\n";

#[test]
fn the_compiled_core_and_its_sequencer_give_the_models_picture() {
    let scratch = Scratch::new();
    scratch.write("own.toml", SHADOWS);
    let core = "--reflectance gold-paint --lights-a-clock 2 --languages verilog";
    scratch.run(&format!("generate {SMALL} {core} --name own --out own")).succeeds();
    let render = |through: &str| {
        let (picture, json) = scratch.rendered("own.toml --core own", through);
        assert!(json["images"]["psnr"].as_f64().unwrap() > 30.0, "{json}");
        picture
    };
    let model = render("model");
    assert!(pixels(&model).iter().filter(|pixel| pixel[0] > 100).count() > 100);
    assert_eq!(render("verilator"), model);
    // All texels of a memory with their last bits flipped.
    let rom = "own/rom/own_texels_1_even_odd.mem";
    let text = scratch.text(rom);
    let flipped = |line: &str| match u64::from_str_radix(line.trim(), 16) {
        Ok(word) => format!("{:0width$x}\n", word ^ 0x040404, width = line.trim().len()),
        Err(_) => format!("{line}\n"),
    };
    let other: String = text.lines().map(flipped).collect();
    assert_ne!(other, text);
    scratch.write(rom, &other);
    assert_ne!(render("verilator"), model);
    assert_eq!(render("model"), model);
}

#[test]
fn a_core_that_does_not_fit_the_scene_is_refused() {
    let scratch = Scratch::new();
    scratch.write("own.toml", sphere(""));
    let other = sphere("").replace("\"ggx\"", "\"gold-paint\"").replace("\"own\"", "\"other\"");
    let both = sphere("") + &other[other.find("[[material]]").unwrap()..];
    scratch.write("both.toml", both);
    scratch.write(
        "plain.toml",
        "[camera]\nposition = [0.0, 0.0, 4.0]\n[[material]]\nname = \"a\"\nshininess = 8.0\n\
         [[light]]\ndirection = [1.0, 1.0, 1.0]\n[[object]]\nkind = \"sphere\"\nmaterial = \"a\"\n",
    );
    let out = "--out p.png";
    let cases: [(String, &[&str]); 7] = [
        (
            format!("render own.toml {SMALL} --reflectance gold-paint {out}"),
            &["made of ward", "no material of the scene is: own (ggx", "another reflectance"],
        ),
        (
            format!("render own.toml {SMALL} --reflectance ggx --exposure 2 {out}"),
            &["own (ggx", "its exposure is 1.5, and the core's 2"],
        ),
        (
            format!("render own.toml {SMALL} --output-bits 10 {out}"),
            &["10 bits a channel, and the scene 8", "channel_bits = 10 in the scene"],
        ),
        (format!("render plain.toml {SMALL} --reflectance ggx {out}"), &["no material with a reflectance"]),
        (format!("render both.toml {SMALL} {out}"), &["no reflectance is given"]),
        (format!("render own.toml --method cubic {out}"), &["the core is a lobe", "give an image-based core"]),
        (format!("render own.toml --block shader {out}"), &["none asks for a lobe"]),
    ];
    for (line, words) in &cases {
        scratch.refused(line, words);
    }
    assert!(!scratch.path("p.png").exists());
}

#[test]
fn the_cheapest_core_that_keeps_the_budget_is_chosen() {
    let scratch = Scratch::new();
    scratch.write("own.toml", sphere("") + "[budget]\nmin_psnr = 40.0\n");
    let narrow = "--block image --image-form bivariate --octaves 8 --margin 2";
    let json = scratch.run(&format!("scene inspect own.toml {narrow} --json")).succeeds().json();
    let choice = &json["choice"];
    let all = choice["candidates"].as_array().unwrap();
    // Four sizes of two bits, and the shader.
    assert_eq!(all.len(), 9, "{choice}");
    assert_eq!(all.iter().filter(|one| one["fitted"] == true).count(), 1);
    let place = choice["chosen"].as_u64().unwrap() as usize;
    let area = |one: &Value| {
        let of = |key: &str| one["cost"][key].as_u64().unwrap();
        of("lut") + 536 * of("dsp") + 402 * of("bram")
    };
    assert!(all.is_sorted_by_key(area));
    assert!(all[..place].iter().all(|one| one["fitted"] == true || one["missed"] != Value::Array(Vec::new())));
    assert_eq!(all[place]["missed"], Value::Array(Vec::new()));
    for error in choice["verified"].as_array().unwrap() {
        assert!(error["psnr"].as_f64().unwrap() >= 40.0, "{choice}");
    }
    // What a candidate misses is what its picture misses.
    let line = format!("render own.toml {} --json --out p.png", all[place]["flags"].as_str().unwrap());
    let picture = scratch.run(&line).succeeds().json();
    assert_eq!(picture["kept"], true);
    assert_eq!(picture["core"]["difference"]["max_steps"], choice["verified"][0]["max_steps"]);

    scratch
        .run(&format!("generate own.toml {narrow} --out own"))
        .succeeds()
        .says(&["chosen: bivariate", "files in own"]);
    assert_eq!(scratch.text("own/scene.json").matches("\"fitted\": true").count(), 1);
    assert!(scratch.text("own/scene.md").contains("fitted cos^n shader"));
    assert!(Pixmap::decode_png(&scratch.read("own/scene.png")).unwrap().height() > 200);
    scratch.run("generate own --check --out own").succeeds();
    scratch.run("render own.toml --core own --out q.png").succeeds().says(&["through the core own"]);
}

#[test]
fn what_no_core_can_be_chosen_for_is_said() {
    let scratch = Scratch::new();
    let keeps = "[budget]\nmin_psnr = 99.0\n";
    scratch.write("own.toml", sphere("") + keeps);
    scratch.write("none.toml", sphere(""));
    scratch
        .write("both.toml", SHADOWS.replace("\nshininess = 12.0", "\n[material.reflectance]\nmodel = \"ggx\"") + keeps);
    let image = "--block image --image-form bivariate --image-size 8 --margin 0";
    scratch.refused(&format!("generate none.toml {image} --out o"), &["none has no budget", "min_psnr"]);
    scratch.refused(&format!("generate both.toml {image} --out o"), &["own, floor", "--for-material"]);
    scratch.refused(&format!("generate both.toml {image} --for-material x --out o"), &["no material x", "own, floor"]);
    scratch.refused(&format!("generate own.toml {image} --output-bits 10 --out o"), &["8 bits a channel"]);
    scratch.refused(&format!("generate own.toml {image} --exposure 2 --out o"), &["its own reflectance"]);
    for limit in ["--min-psnr 30", "--max-picture-error 0.1"] {
        scratch.refused(&format!("generate own.toml {image} {limit} --out o"), &["for a block of its own", "[budget]"]);
    }
    scratch.refused(&format!("generate own.toml {image} --method cubic --out o"), &["method"]);
    scratch.refused(
        "generate --block image --reflectance ggx --for-material x --out o",
        &["--for-material are for scenes"],
    );
    scratch.refused("scene inspect own.toml --for-material own", &["--for-material is given", "--block image"]);
    let miss = scratch.run(&format!("generate own.toml {image} --out o")).ends_with(1);
    assert!(miss.stderr.contains("no image-based core keeps a PSNR of at least 99 dB"), "{}", miss.stderr);
    assert!(!scratch.path("o").exists());
}

#[test]
fn sizes_follow_from_what_pictures_may_miss() {
    let own = |keys: &str| {
        let text = format!("block = 'image'\n{keys}\n[reflectance]\nmodel = 'ggx'\nparameters = {{ alpha = 0.5 }}\n");
        SpecFields::parse(&text, "own").unwrap().resolve().map_err(|error| error.to_string())
    };
    let form = "image_form = 'bivariate'\noctaves = 8";
    let spec = own(&format!("{form}\nmin_psnr = 44.0")).unwrap();
    let Block::Image(ImageSpec { image, .. }) = &spec.block else { panic!("an image-based block") };
    let bits = |size: u32, bits: u32| size * size * bits;
    // It reaches the ratio, and none that is smaller does.
    let error = |size: u32, bits: u32| {
        let keys = format!("{form}\nimage_size = {size}\ntexel_bits = {bits}");
        let design = Design::new(own(&keys).unwrap()).unwrap();
        let BlockDesign::Image(image) = design.block() else { panic!("an image-based block") };
        let Block::Image(ImageSpec { source: ImageSource::Model(model), .. }) = &design.spec.block else {
            panic!("a model")
        };
        image.block.sphere_error(model, image.of.exposure)
    };
    assert!(error(image.size, image.texel_bits).quality.mean >= 44.0);
    let SphereError { quality: reached, greatest } = error(16, 10);
    let budgets = [(44.0, 1.0), (0.0, greatest), (reached.mean, greatest)];
    let keys = [
        "min_psnr = 44.0".to_owned(),
        format!("max_error = {greatest:?}"),
        format!("min_psnr = {:?}\nmax_error = {greatest:?}", reached.mean),
    ];
    for ((least, most), keys) in budgets.into_iter().zip(keys) {
        let spec = own(&format!("{form}\n{keys}")).unwrap();
        let Block::Image(ImageSpec { image, .. }) = &spec.block else { panic!("an image-based block") };
        let keeps = |size, bits| {
            let SphereError { quality, greatest } = error(size, bits);
            quality.mean >= least && greatest <= most
        };
        assert!(keeps(image.size, image.texel_bits), "{keys}: {image}");
        for size in [8, 16, 32, 64] {
            for texel_bits in 4..=10 {
                if bits(size, texel_bits) < bits(image.size, image.texel_bits) {
                    // More bits may by chance miss what fewer keep: such a size is passed over.
                    assert!(!keeps(size, texel_bits) || !keeps(size, 10), "{keys}: {image}, {size} {texel_bits}");
                }
            }
        }
    }
    // What is given stays; the spec of the core says its sizes.
    let spec = own(&format!("{form}\nmin_psnr = 30.0\nimage_size = 32")).unwrap();
    let text = SpecFields::from_spec(&spec);
    assert_eq!((text.image_size, text.texel_bits, text.min_psnr), (Some(32), Some(4), None));
    let nearest = own(&format!("{form}\nmin_psnr = 90.0\nmax_error = 0.5\nimage_size = 8")).unwrap_err();
    assert!(
        nearest.contains("keeps min_psnr = 90 and max_error = 0.5") && nearest.contains("bivariate 8², 10 bits, has"),
        "{nearest}"
    );
    assert!(own("min_psnr = -1.0").unwrap_err().contains("out of range"));
    assert!(own("max_error = 1.0").unwrap_err().contains("max_error = 1 is out of range"));
}
