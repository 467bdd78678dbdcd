//! The whole shader of a scene: its picture by the bit-exact model against the exact picture.

mod common;

use std::path::Path;

use brdfgen::design::Design;
use brdfgen::scene::highlight::Exact;
use brdfgen::scene::trace::Tracer;
use brdfgen::scene::{Difference, Frame, Highlights, Requirements, Scene, shade};
use brdfgen::spec::{Front, ShaderFields, SpecFields};
use common::Scratch;

const SCENE: &str = "
width = 96
height = 64
shadows = true
[camera]
position = [0, 1, 6]
target = [0, 0.4, 0]
[[material]]
name = 'floor'
shininess = 4
specular = 0
[[material]]
name = 'red'
shininess = 12.5
colour = [0.9, 0.2, 0.1]
[[material]]
name = 'steel'
shininess = 300
diffuse = 0.2
specular = 0.7
[[material]]
name = 'nowhere'
shininess = 900
[[light]]
direction = [1, 2, 3]
colour = [1, 0.9, 0.8]
intensity = 0.6
[[light]]
position = [-3, 4, 2]
intensity = 0.3
[[object]]
kind = 'plane'
material = 'floor'
point = [0, -1, 0]
normal = [0, 1, 0]
[[object]]
kind = 'sphere'
material = 'red'
centre = [-1.1, 0, 0]
radius = 1
[[object]]
kind = 'sphere'
material = 'steel'
centre = [1.1, 0, 0]
radius = 1
";

fn scene(model: &str) -> Scene {
    Scene::parse(&format!("model = '{model}'\n{SCENE}"), "test.toml", Path::new(".")).unwrap()
}

fn lobe(text: &str) -> SpecFields {
    SpecFields::parse(text, "lobe").unwrap()
}

/// The shader of a scene around a lobe, its picture's difference from the exact one, and the samples that went through it.
fn through(scene: &Scene, lobe: &SpecFields, asked: &ShaderFields) -> (Design, Difference, u64) {
    let requirements = Requirements::of(scene, 0.0, &|_, _| {}).unwrap();
    let spec = shade::spec(scene, &requirements, lobe, asked).and_then(SpecFields::resolve).unwrap();
    let design = Design::new(spec).unwrap();
    let tracer = Tracer::new(scene);
    let (picture, samples) =
        shade::picture(&design, design.spec.block.shader().unwrap(), scene, &tracer, &|| {}).unwrap();
    let frame = Frame::trace(&tracer, scene, &|| {});
    let exact = frame.picture(scene, &Exact.of(scene, &frame).unwrap());
    (design, Difference::of(&exact, &picture), samples)
}

#[test]
fn the_shader_draws_the_scene_within_a_step() {
    let fine = lobe("method = 'log-exp'\ninput_fraction = 18\noutput_fraction = 12");
    for (model, front) in [("phong", None), ("blinn", Some(Front::Half)), ("blinn", Some(Front::Sqrt))] {
        let scene = scene(model);
        let asked = ShaderFields { front, vector_fraction: Some(18), ..ShaderFields::default() };
        let (design, difference, samples) = through(&scene, &fine, &asked);
        assert_eq!(design.spec.shininess.rows(), 3, "the material that no object has is left out");
        assert!(samples > 3000 && difference.max_steps <= 1, "{model} {front:?}: {samples}, {difference:?}");
        assert!(difference.pixels[0] > samples / 2, "{model} {front:?}: {:?}", difference.pixels);
    }
}

#[test]
fn what_the_lobe_and_the_vectors_lose_is_seen() {
    let scene = scene("blinn");
    let fine = lobe("method = 'log-exp'\ninput_fraction = 18\noutput_fraction = 12");
    let steps = |lobe: &SpecFields, vector_fraction: u32| {
        let asked = ShaderFields { vector_fraction: Some(vector_fraction), ..ShaderFields::default() };
        through(&scene, lobe, &asked).1.max_steps
    };
    let [well, coarse, rough] = [steps(&fine, 18), steps(&fine, 8), steps(&lobe("method = 'quadratic'"), 18)];
    assert!(
        well <= 1 && coarse > well && rough > 10,
        "{well}, with coarse vectors {coarse}, with a rough lobe {rough}"
    );
}

#[test]
fn the_scene_itself_says_what_is_in_it() {
    let scene = scene("phong");
    let requirements = Requirements::of(&scene, 0.0, &|_, _| {}).unwrap();
    let asked = ShaderFields { lights: Some(3), ..ShaderFields::default() };
    let error = shade::spec(&scene, &requirements, &lobe("method = 'quadratic'"), &asked).unwrap_err();
    assert!(error.to_string().contains("the scene says itself"), "{error}");
}

#[test]
fn a_scene_becomes_a_shader_with_its_documents() {
    let scratch = Scratch::new();
    let small = SCENE.replace("width = 96", "width = 36").replace("height = 64", "height = 24");
    scratch.write("two.toml", format!("model = 'blinn'\n{small}"));
    let run = scratch.run("generate two.toml --block shader --method power-8 --margin 2 --out made").succeeds();
    run.says(&["the shader around it: vectors of ", "samples through its bit-exact model"]);
    scratch.run("generate two.toml --block shader --method power-8 --margin 2 --out made --check").succeeds();
    let core = scratch.text("made/core.toml");
    assert!(core.contains("block = \"shader\"") && core.contains("lights = 2") && !core.contains("nowhere"), "{core}");
    let json: serde_json::Value = serde_json::from_str(&scratch.text("made/scene.json")).unwrap();
    assert_eq!(json["port"], "in_material");
    assert_eq!(json["materials"][3]["code"], serde_json::Value::Null, "an object that is not there");
    for pictures in ["base", "moved"] {
        assert!(json["shader"][pictures]["max_steps"].as_u64().unwrap() <= 1, "{}", json["shader"]);
    }
    let sheet = scratch.text("made/scene.md");
    assert!(sheet.contains("the shader of a scene") && sheet.contains("L = -N"), "{sheet}");
    scratch
        .refused("generate two.toml --lights 3 --method power-8 --out x", &["keys of a shader are given for a lobe"]);
    let lights = "generate two.toml --block shader --lights 3 --method power-8 --out x";
    scratch.refused(lights, &["the scene says itself"]);
    // Vectors this coarse cannot keep the budget.
    let coarse = "generate two.toml --block shader --vector-fraction 8 --method power-8 --out x";
    scratch.run(coarse).ends_with(1);
    assert!(!scratch.path("x").exists());
}
