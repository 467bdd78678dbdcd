use std::path::Path;

use brdfgen::core::Design;
use brdfgen::fixed::Rng;
use brdfgen::scene::frame::BACKGROUND;
use brdfgen::scene::highlight::*;
use brdfgen::scene::{Frame, Scene};
use brdfgen::spec::SpecFields;

fn design(spec: &str) -> Design {
    Design::new(SpecFields::parse(spec, "test").unwrap().resolve().unwrap()).unwrap()
}

/// A scene of three materials, and a frame of random samples of it, some of them dark.
fn scene_and_frame() -> (Scene, Frame) {
    let material = |name: &str, shininess: f64| {
        format!(
            "[[material]]\nname = {name:?}\nshininess = {shininess}\n[[object]]\nkind = \"sphere\"\nmaterial = \
             {name:?}\ncentre = [0, 0, 0]\nradius = 1\n"
        )
    };
    let text = format!(
        "[camera]\nposition = [0, 0, 5]\n[[light]]\ndirection = [0, 0, 1]\n[[light]]\ndirection = [0, 1, 1]\n{}",
        [material("a", 3.4), material("b", 40.0), material("c", 900.0)].concat()
    );
    let scene = Scene::parse(&text, "test.toml", Path::new(".")).unwrap();
    let mut rng = Rng::new(1);
    let pixels = 1000;
    let material: Vec<u16> = (0..pixels).map(|_| [0, 1, 2, BACKGROUND][rng.below(4) as usize]).collect();
    let versine = (0..2 * pixels).map(|sample| match rng.below(8) {
        0 => f64::NAN,
        _ if material[sample / 2] == BACKGROUND => f64::NAN,
        1 => [0.0, 1.0, 2.0][rng.below(3) as usize],
        2 => 2.0 * rng.unit(),
        _ => rng.unit() * rng.unit() / 50.0,
    });
    let versine = versine.collect();
    let frame = Frame { width: pixels as u32, height: 1, lights: 2, base: vec![[0.0; 3]; pixels], material, versine };
    (scene, frame)
}

#[test]
fn codes_are_the_nearest_of_the_ports() {
    let (scene, frame) = scene_and_frame();
    let of = |spec: &str| Codes::of(&design(spec), &scene, &frame);
    assert_eq!(of("method = \"cubic\"\nshininess = \"1..=1000\"").indices, [3, 40, 900]);
    assert_eq!(of("method = \"cubic\"\nshininess = [900.0, 40.0, 3.4]").indices, [2, 1, 0]);
    // Of two as near the lower; beyond the ends the end.
    assert_eq!(of("method = \"cubic\"\nshininess = [60.0, 20.0, 4.0]").indices, [2, 1, 0]);
    for operand in ["cos", "versine"] {
        let design = design(&format!(
            "method = \"cubic\"\noperand = {operand:?}\ninput_fraction = 12\nshininess = \"1..=1000\""
        ));
        let codes = Codes::of(&design, &scene, &frame);
        let format = design.lobe().operand_format();
        let mut dark = 0;
        for (sample, &u) in frame.versine.iter().enumerate() {
            if u.is_nan() {
                assert_eq!(codes.sample(&frame, sample), None);
                dark += 1;
                continue;
            }
            let (index, code) = codes.sample(&frame, sample).unwrap();
            assert_eq!(index, codes.indices[usize::from(frame.material[sample / 2])]);
            let wanted = if operand == "cos" { 1.0 - u } else { u };
            let reach = format.value(format.min_code())..=format.value(format.max_code());
            let within = wanted.clamp(*reach.start(), *reach.end());
            assert!((f64::from(code) / 4096.0 - within).abs() <= 0.5 / 4096.0, "{operand} {u}: {code}");
        }
        assert!((500..1500).contains(&dark));
    }
}

#[test]
fn the_tabulated_model_is_the_model() {
    let (scene, frame) = scene_and_frame();
    for spec in [
        "method = \"quadratic\"\nshininess = [3.4, 40.0, 900.0]",
        "method = \"cubic\"\ncoefficients = \"minimax\"\nshininess = \"1..=1000\"\noperand = \"versine\"",
    ] {
        let design = design(spec);
        let codes = Codes::of(&design, &scene, &frame);
        let values = CoreModel::new(&design).unwrap().of(&scene, &frame).unwrap();
        assert_eq!(values.len(), frame.versine.len());
        for (sample, &value) in values.iter().enumerate() {
            let Some((index, operand)) = codes.sample(&frame, sample) else { continue };
            let wanted = design.lobe().model().evaluate(index, operand.into());
            assert_eq!(value, f64::from(wanted) / 65_536.0, "{spec}, sample {sample}");
        }
    }
    let shader = design("method = \"cubic\"\nblock = \"shader\"\n[[material]]\nname = \"a\"\nshininess = 8.0");
    assert!(CoreModel::new(&shader).unwrap_err().to_string().contains("is a shader"));
}
