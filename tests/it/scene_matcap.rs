//! Scenes with a matcap through image-based cores of that form: the model against pixels that are computed here, the
//! compiled core against the model, and the choice of a size.
//!
//! Needs verilator; `test.sh` installs it.

use std::path::Path;

use brdfgen::core::{BlockDesign, Design};
use brdfgen::reflectance::Vector;
use brdfgen::scene::Scene;
use brdfgen::spec::SpecFields;

use crate::common::matcap::{picture, studio};
use crate::common::{Scratch, pixels};

/// A sphere that is a matcap and a classical plane under two lights of colours that are not the picture's.
const SCENE: &str = "width = 48\nheight = 40\nshadows = true\nambient = [0, 0, 0]\n[camera]\n\
    position = [0.5, 0.8, 4.0]\n[budget]\nmin_psnr = 26.0\n[[material]]\nname = \"clay\"\nk_a = 0.0\n\
    [material.reflectance]\nfile = \"ball.png\"\n[[material]]\nname = \"floor\"\nshininess = 12.0\n\
    [[light]]\ndirection = [1.0, 1.0, 0.4]\ncolour = [0.1, 0.2, 0.1]\n[[light]]\ndirection = [0.1, 0.3, -1.0]\n\
    [[object]]\nkind = \"sphere\"\nmaterial = \"clay\"\n\
    [[object]]\nkind = \"plane\"\nmaterial = \"floor\"\npoint = [0.0, -1.0, 0.0]\n";

fn with_scene() -> Scratch {
    let scratch = Scratch::new();
    scratch.write("ball.png", picture(128, studio));
    scratch.write("own.toml", SCENE);
    scratch
}

#[test]
fn a_matcap_of_a_scene_is_drawn_through_its_core() {
    let scratch = with_scene();
    let core = "--block image --image-form matcap --image-size 32 --languages verilog --name clay";
    scratch.run(&format!("generate {core} --reflectance-file ball.png --out clay")).succeeds();
    let render = |keys: &str| {
        scratch.run(&format!("render own.toml {keys} --only core --out p.png")).succeeds();
        scratch.read("p.png")
    };
    let model = render("--core clay");
    assert_eq!(render("--core clay --through verilator"), model);
    // The form is the material's own.
    assert_eq!(render("--block image --image-size 32"), model);

    let scene = Scene::parse(SCENE, "own.toml", &scratch.path("")).expect("a scene");
    let design = Design::new(SpecFields::read(&scratch.path("clay")).and_then(SpecFields::resolve).expect("a spec"));
    let design = design.expect("a core");
    let BlockDesign::Image(image) = design.block() else { panic!("an image-based block") };
    let axes = scene.camera.axes().map(Vector::from);
    let ways = (0..scene.height).flat_map(|row| scene.camera.row(scene.width, scene.height, row));
    let eye = Vector::from(scene.camera.position);
    let (mut checked, mut same) = (0, 0);
    for (pixel, way) in pixels(&model).into_iter().zip(ways) {
        let way = Vector::from(way).normalize();
        let b = eye.dot(&way);
        let root = b * b - eye.dot(&eye) + 1.0;
        let n = eye + way * (-b - root.max(0.0).sqrt());
        if root < 0.0 || n.dot(&-way) < 0.02 {
            continue;
        }
        let turned = Vector::new(n.dot(&axes[0]), n.dot(&axes[1]), -n.dot(&axes[2]));
        let wanted = design.evaluate(&image.inputs(turned, &[]));
        // A normal's last bit may be another here.
        assert!((0..3).all(|c| (pixel[c] - wanted[c]).abs() <= 2), "{pixel:?} {wanted:?}");
        checked += 1;
        same += usize::from(pixel[..] == wanted[..]);
    }
    assert!(checked > 300 && same * 100 > checked * 98, "{same} of {checked}");
}

#[test]
fn the_size_of_a_scenes_matcap_is_chosen() {
    let scratch = with_scene();
    let run = scratch.run("generate own.toml --block image --out clay").succeeds();
    assert!(!run.stdout.contains("cos^n"), "{}", run.stdout);
    let spec = scratch.text("clay/core.toml");
    assert!(spec.contains("image_form = \"matcap\"") && !spec.contains("most_lights"), "{spec}");
    assert!(scratch.text("clay/scene.md").contains("its light is in the picture"));
    scratch.run("generate clay --check --out clay").succeeds();
    scratch.run("render own.toml --core clay --out p.png").succeeds().says(&["through the core"]);
    // Sizes go as far as the picture.
    let json = scratch.run("scene inspect own.toml --block image --texel-bits 8 --json").succeeds().json();
    let candidates = json["choice"]["candidates"].as_array().expect("candidates");
    let names: Vec<&str> = candidates.iter().filter_map(|one| one["name"].as_str()).collect();
    assert_eq!(names, ["matcap 16², 8 bits", "matcap 32², 8 bits", "matcap 64², 8 bits", "matcap 128², 8 bits"]);
    let json = scratch.run("scene inspect own.toml --block image --image-size 64 --json").succeeds().json();
    assert_eq!(json["choice"]["candidates"].as_array().expect("candidates").len(), 2);
}

#[test]
fn what_does_not_fit_a_scenes_matcap_is_refused() {
    let scratch = with_scene();
    let ggx = SCENE.replace("file = \"ball.png\"", "model = \"ggx\"");
    scratch.write("ggx.toml", &ggx);
    scratch.write("other.png", picture(128, |x, _| [0.5 + 0.5 * x; 3]));
    let matcap = "generate --block image --image-form matcap --image-size 16 --reflectance-file";
    scratch.run(&format!("{matcap} ball.png --out clay")).succeeds();
    scratch.run(&format!("{matcap} other.png --out other")).succeeds();
    scratch.run("generate --block image --image-form bivariate --image-size 8 --reflectance ggx --out ggx").succeeds();
    for (line, words) in [
        ("render own.toml --core other --out p.png", "other images"),
        ("render own.toml --core ggx --out p.png", "other images"),
        ("render ggx.toml --core clay --out p.png", "a reflectance, and the core is a matcap"),
        ("render own.toml --block image --image-form half --out p.png", "use --image-form matcap"),
        (
            "generate own.toml --block image --image-form half --out no",
            "given for the material clay, which is a matcap",
        ),
        ("generate ggx.toml --block image --image-form matcap --out no", "a reflectance and no matcap"),
        ("generate own.toml --block image --image-size 256 --out no", "image_size = 256 is more than the 128 × 128"),
        ("generate own.toml --block image --lights-a-clock 2 --out no", "lights_a_clock is given for a matcap"),
    ] {
        scratch.refused(line, &[words]);
    }
    assert!(Scene::parse(&ggx, "ggx.toml", Path::new("")).is_ok());
}
