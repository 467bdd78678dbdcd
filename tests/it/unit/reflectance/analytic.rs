use std::f64::consts::PI;

use brdfgen::platform::error::Error;
use brdfgen::reflectance::Reflectance;
use brdfgen::reflectance::analytic::*;
use brdfgen::reflectance::info::albedo;
use brdfgen::reflectance::vector::Vector;
use brdfgen::reflectance::vector::{Light, about_y, sine_cosine};

use super::samples::{random, upper};

fn with(name: &str, changes: &[(&str, &str)]) -> Model {
    let mut model = Model::named(name).unwrap();
    changes.iter().for_each(|(key, value)| model.set(key, value).unwrap());
    model
}

/// Every family in both norms, smooth and rough, and every preset.
fn all() -> Vec<Model> {
    let mut models = Vec::new();
    for family in Family::ALL {
        for value in ["0.02", "0.3", "1"] {
            for norm in ["published", "conserving"] {
                let mut model = Model::of(family);
                for parameter in family.parameters() {
                    match parameter.name {
                        "alpha" | "m" => model.set(parameter.name, value).unwrap(),
                        "n" => {
                            let n = match value {
                                "0.02" => "2000",
                                "1" => "0",
                                _ => "30",
                            };
                            model.set("n", n).unwrap();
                        }
                        _ => {}
                    }
                }
                if family.has_norms() {
                    model.set("norm", norm).unwrap();
                }
                models.push(model);
            }
        }
    }
    models.extend(Model::presets().map(|name| Model::named(name).unwrap()));
    models
}

#[test]
fn light_and_viewer_can_be_exchanged_and_turned() {
    let mut random = random(11);
    for model in all() {
        for _ in 0..100 {
            let (l, v, turn) = (upper(&mut random), upper(&mut random), 360.0 * random());
            let value = model.at(l, v, Vector::z());
            assert!(value.iter().all(|f| f.is_finite() && *f >= 0.0), "{model} {value:?}");
            let turned = |a: Vector| about_y(a, sine_cosine(turn));
            for other in [model.at(v, l, Vector::z()), model.at(turned(l), turned(v), turned(Vector::z()))] {
                assert!(
                    (0..3).all(|c| (other[c] - value[c]).abs() <= 1e-9 * value[c] + 1e-12),
                    "{model}: {value:?} {other:?}"
                );
            }
        }
    }
}

/// White furnace: no more light leaves than comes in, where the factors are at most 1 together.
#[test]
fn no_model_makes_light() {
    let specular = |family: Family, rough: &str, norm: &str| {
        let mut model = Model::of(family);
        let rough_n = match rough {
            "0.02" => "5000",
            "0.2" => "50",
            _ => "1",
        };
        for Parameter { name, .. } in family.parameters() {
            model
                .set(
                    name,
                    match *name {
                        "kd" => "0",
                        "ks" | "f0" | "f90" => "1",
                        "power" => "5",
                        "n" => rough_n,
                        _ => rough,
                    },
                )
                .unwrap();
        }
        if family.has_norms() {
            model.set("norm", norm).unwrap();
        }
        model
    };
    let mut largest = Vec::new();
    for family in Family::ALL {
        for rough in ["0.02", "0.2", "0.6"] {
            for norm in ["published", "conserving"] {
                let model = specular(family, rough, norm);
                let most = [0.0, 30.0, 60.0, 75.0, 85.0, 89.0]
                    .map(|theta| albedo(&model, theta)[0])
                    .into_iter()
                    .fold(0.0, f64::max);
                largest.push((model, most));
            }
        }
    }
    for (model, most) in &largest {
        let breaks =
            model.norm() == Norm::Published && matches!(model.family(), Family::BlinnPhong | Family::CookTorrance);
        if !breaks {
            assert!(*most <= 1.002, "{model}: {most}");
        }
    }
    // What the printed forms give: four times too much.
    for family in [Family::BlinnPhong, Family::CookTorrance] {
        let model = specular(family, "0.02", "published");
        let most = albedo(&model, 0.0)[0];
        assert!((most - 4.0).abs() < 0.02, "{model}: {most}");
        let model = specular(family, "0.02", "conserving");
        assert!((albedo(&model, 0.0)[0] - 1.0).abs() < 0.005);
    }
    // Diffuse parts, and the presets.
    for model in [with("lambert", &[("kd", "1")]), with("ashikhmin-shirley", &[("kd", "1"), ("f0", "0.2")])]
        .into_iter()
        .chain(Model::presets().map(|name| Model::named(name).unwrap()))
    {
        for theta in [0.0, 40.0, 70.0, 85.0] {
            let share = albedo(&model, theta);
            assert!(share.iter().all(|&share| share > 0.0 && share <= 1.003), "{model} at {theta}: {share:?}");
        }
    }
    assert!((albedo(&with("lambert", &[("kd", "0.7,0.5,0.1")]), 33.0)[1] - 0.5).abs() < 1e-3);
}

/// The two materials of the reference file, whose exact radiances it has.
#[test]
fn reference_materials_are_met() {
    let models = [Model::named("blinnphong").unwrap(), Model::named("ggx").unwrap()];
    let mut reader = csv::Reader::from_reader(&include_bytes!("../../../data/image_based.csv")[..]);
    let mut count = 0;
    for record in reader.records() {
        let record = record.unwrap();
        let number = |column: usize| record[column].parse::<f64>().unwrap();
        let model = &models[usize::from(&record[0] == "ggx")];
        let n = Vector::new(number(4), number(5), number(6));
        let own = model.radiance(Light::new(number(2), number(3)), n, number(7));
        for c in 0..3 {
            assert!((own[c] - number(19 + c)).abs() < 1e-7 * (1.0 + own[c]), "{record:?}: {own:?}");
        }
        count += 1;
    }
    assert_eq!(count, 400);
}

#[test]
fn extremes_stay_finite() {
    for (name, changes) in [
        ("ggx", [("alpha", "0.001")]),
        ("ward", [("alpha", "0.001")]),
        ("cook-torrance", [("m", "0.001")]),
        ("blinnphong", [("n", "65536")]),
        ("ashikhmin-shirley", [("n", "65536")]),
    ] {
        let mut model = with(name, &changes);
        for norm in ["published", "conserving"] {
            if model.family().has_norms() {
                model.set("norm", norm).unwrap();
            }
            for (theta_l, theta_v) in
                [(0.0, 0.0), (89.999_999, -89.999_999), (89.999_999, 89.999_999), (45.0, -45.0), (89.9, 0.0)]
            {
                let at = |theta: f64| about_y(Vector::z(), sine_cosine(theta));
                let value = model.at(at(theta_l), at(theta_v), Vector::z());
                assert!(value.iter().all(|f| f.is_finite() && *f >= 0.0), "{model} {theta_l} {theta_v}: {value:?}");
            }
        }
    }
    // The mirror's direction of a smooth surface: the limit of the formula.
    let peak = with("blinnphong", &[("n", "65536"), ("kd", "0")]).at(Vector::z(), Vector::z(), Vector::z())[0];
    assert!((peak - 0.04 * 65538.0 / (2.0 * PI)).abs() < 1e-9 * peak);
    let peak =
        with("ggx", &[("alpha", "0.001"), ("kd", "0"), ("f0", "1")]).at(Vector::z(), Vector::z(), Vector::z())[0];
    assert!((peak - 0.25e6 / PI).abs() < 1e-6 * peak, "{peak}");
}

#[test]
fn wrong_parameters_are_named() {
    let said = |name: &str, key: &str, value: &str| {
        let error = Model::named(name).and_then(|mut model| model.set(key, value)).unwrap_err();
        let Error::Input { what, allowed } = error else { panic!("{error}") };
        format!("{what} / {allowed}")
    };
    assert!(said("phong", "n", "5").contains("no reflectance model `phong` / models: lambert, blinnphong"));
    assert!(said("phong", "n", "5").contains("gold-paint"));
    assert!(
        said("ggx", "roughness", "0.1")
            .contains("ggx: there is no parameter `roughness` / it has kd, f0, f90, alpha, power")
    );
    assert!(said("ggx", "norm", "published").contains("no parameter `norm`"));
    assert!(said("ggx", "alpha", "0").contains("alpha = 0 is out of range / alpha, the roughness, is from 0.001 to 1"));
    assert!(said("ggx", "alpha", "nan").contains("out of range"));
    assert!(said("ggx", "alpha", "0.1,0.2,0.3").contains("is one number"));
    assert!(said("ggx", "kd", "0.1,0.2").contains("red,green,blue"));
    assert!(said("ggx", "kd", "0.1,x,0.2,0.3").contains("red,green,blue"));
    assert!(said("ggx", "kd", "0.1,0.2,1.5").contains("out of range"));
    assert!(said("ward", "norm", "other").contains("`published` or `conserving`"));
    let model = with("gold-paint", &[("kd", "0.1")]);
    assert_eq!(model.to_string(), "ward kd=0.1,0.1,0.1 ks=0.38,0.27,0.09 alpha=0.2 norm=conserving");
    assert_eq!(model.value("alpha"), [0.2; 3]);
    assert_eq!(Model::named("blinn-phong").unwrap(), Model::named("blinnphong").unwrap());
}
