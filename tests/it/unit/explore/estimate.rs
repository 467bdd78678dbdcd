use brdfgen::explore::estimate::*;
use brdfgen::explore::shape::Multiplier;
use brdfgen::explore::{Point, Results, Shape};
use brdfgen::target::Family;

use super::results::point;

fn multiplier(text: &str) -> Multiplier {
    text.parse().unwrap()
}

/// Points whose costs follow the model's own form, but for one that is off.
fn made(odd: f64) -> Results {
    let made = |i: u32| {
        let shape = Shape {
            // None, one in one block, one in two.
            multipliers: [vec![], vec!["18x17"], vec!["21x17"]][(i % 3) as usize]
                .iter()
                .map(|m| multiplier(m))
                .collect(),
            memories: vec!["1024x18r".parse().unwrap()],
            adder_bits: 10 + i * 7 % 40,
            mux_bits: 5 + i * 11 % 30,
            shift_bits: i * 3 % 17,
            register_bits: 100 + i * 13 % 90,
        };
        let lut = 2 * shape.adder_bits + shape.mux_bits + shape.shift_bits + if i % 3 == 2 { 17 } else { 0 };
        let off = if i == 7 { odd } else { 1.0 };
        let costs = [(f64::from(lut) * off) as u32, i % 3, 1, 6];
        let mut point = point(&format!("p{i:02}"), 0.1, costs, if i % 3 == 2 { 140.0 } else { 180.0 });
        point.synthesis.as_mut().unwrap().resources.ff = shape.register_bits - 18;
        Point { shape, estimate: None, ..point }
    };
    Results::new((0..24).map(made).collect())
}

#[test]
fn held_out_points_are_estimated_and_the_error_is_told() {
    let model = Model::fit(&made(1.0)).unwrap();
    for accuracy in &model.of(Family::Ecp5).unwrap().accuracy {
        assert!(accuracy.worst < 0.01, "{accuracy:?}");
    }
    // A point that is off is told, and does not spoil the others.
    let model = Model::fit(&made(1.5)).unwrap();
    let lut = &model.of(Family::Ecp5).unwrap().accuracy[0];
    assert_eq!((lut.what, lut.points), ("LUT", 24));
    assert!(lut.at.ends_with("p07") && (0.25..0.4).contains(&lut.worst) && lut.median < 0.1, "{lut:?}");
    let other = made(1.0).points()[3].clone();
    let estimate = model.estimate(Family::Ecp5, &other.shape).unwrap();
    assert_eq!((estimate.dsp, estimate.bram, estimate.points), (other.cost().unwrap().dsp, 1, 24));
    assert!(model.estimate(Family::Ice40, &other.shape).unwrap_err().to_string().contains("no cost model for ice40"));
}

#[test]
fn too_few_points_and_two_versions_are_refused() {
    let mut points = made(1.0).points().to_vec();
    points.last_mut().unwrap().synthesis.as_mut().unwrap().tools.yosys = "Yosys 0.23".to_owned();
    let error = Model::fit(&Results::new(points.clone())).unwrap_err().to_string();
    assert!(error.contains("Yosys 0.23 and of Yosys 0.70"), "{error}");
    points.truncate(FEWEST - 1);
    assert!(Model::fit(&Results::new(points)).unwrap_err().to_string().contains("no family has 12"));
}
