//! The forms against the worked points of the reference file, against the targets of their quality, and at the
//! extremes.

use std::sync::OnceLock;

use brdfgen::reflectance::form::{FormKind, FormSpec};
use brdfgen::reflectance::measure::{self, Judge};
use brdfgen::reflectance::table::PHI_D;
use brdfgen::reflectance::*;

use super::samples::{random, upper};

/// The 400 points of the paper's form: each step and the result of 512² floating-point images.
#[test]
fn the_papers_form_meets_the_worked_points() {
    let mut reader = csv::Reader::from_reader(&include_bytes!("../../../data/image_based.csv")[..]);
    let records: Vec<csv::StringRecord> = reader.records().map(|record| record.unwrap()).collect();
    assert_eq!(records.len(), 400);
    let mut most = 0.0f64;
    for (name, images) in [("blinnphong", 4), ("blinnphong", 6), ("ggx", 4), ("ggx", 6)] {
        let model = Model::named(name).unwrap();
        let own: Vec<_> = records.iter().filter(|r| &r[0] == name && r[1] == images.to_string()).collect();
        let exposure: f64 = own[0][7].parse().unwrap();
        let form = FormSpec::sized(FormKind::Paper, images, 512, Texel::Float).build(&model, exposure).unwrap();
        assert_eq!(own.len(), 100);
        for record in own {
            let number = |column: usize| record[column].parse::<f64>().unwrap();
            let light = Light::new(number(2), number(3));
            let n = Vector::new(number(4), number(5), number(6));
            let steps = form.steps(light, n).unwrap();
            let near =
                |own: f64, column: usize| assert!((own - number(column)).abs() < 1e-7, "{column}: {own} {record:?}");
            near(steps.k, 8);
            (0..3).for_each(|axis| near(steps.first[axis], 9 + axis));
            match steps.second {
                Some(second) => (0..3).for_each(|axis| near(second[axis], 12 + axis)),
                None => assert!(number(12).is_nan()),
            }
            near(steps.t, 15);
            let value = form.at(light, n);
            (0..3).for_each(|c| most = most.max((value[c] - number(16 + c)).abs()));
        }
    }
    assert!(most < 2e-6, "{most:e}");
}

/// Tables of 90 × 90 × 180 made from the models, as the targets are measured on, with their exact pictures.
fn judged(name: &'static str) -> &'static (Table, Judge) {
    static GGX: OnceLock<(Table, Judge)> = OnceLock::new();
    static BLINN_PHONG: OnceLock<(Table, Judge)> = OnceLock::new();
    let made = || {
        let table = Table::sampled(&Model::named(name).unwrap(), PHI_D).unwrap();
        let judge = Judge::new(&table, measure::exposure(&table), &measure::angles(5.0), 200);
        (table, judge)
    };
    if name == "ggx" { GGX.get_or_init(made) } else { BLINN_PHONG.get_or_init(made) }
}

fn quality(name: &'static str, spec: &FormSpec) -> measure::Quality {
    let (table, judge) = judged(name);
    let quality = judge.quality(&spec.build(table, judge.exposure).unwrap());
    println!("{name} {spec}: mean {:.2}, worst {:.2} at {}", quality.mean, quality.worst, quality.worst_phi);
    quality
}

#[test]
fn forms_are_as_good_as_they_should_be() {
    let spec = |kind, images, size, texel: &str| FormSpec::sized(kind, images, size, texel.parse().unwrap());
    let paper = quality("ggx", &spec(FormKind::Paper, 6, 512, "float"));
    assert!(paper.mean_within(0.0..=150.0) >= 38.9, "{paper:?}");
    let half = quality("ggx", &spec(FormKind::Half, 16, 32, "sqrt:8"));
    assert!(half.mean >= 49.5 && half.worst >= 43.0, "{half:?}");
    assert!(quality("ggx", &spec(FormKind::Half, 16, 64, "sqrt:8")).mean >= 53.0);
    assert!(quality("ggx", &spec(FormKind::Bivariate, 1, 32, "sqrt:8")).mean >= 44.0);
    assert!(quality("blinnphong", &spec(FormKind::Half, 16, 32, "sqrt:8")).mean >= 52.5);
}

/// What single precision in bulk and double precision one by one give is the same, for every form and option.
#[test]
fn many_normals_at_once_are_as_one_by_one() {
    let model = Model::named("ggx").unwrap();
    let mut random = random(31);
    let normals: Vec<Vector> = (0..501).map(|_| upper(&mut random)).collect();
    let single: [Vec<f32>; 3] = [0, 1, 2].map(|axis| normals.iter().map(|n| n[axis] as f32).collect());
    let single = [&single[0][..], &single[1][..], &single[2][..]];
    for kind in FormKind::MADE {
        for texel in ["float", "sqrt:8"] {
            for (border, behind) in [("shrink:0.995", "rim"), ("extend", "literal"), ("shrink:0.99", "skip")] {
                let mut spec = FormSpec::sized(kind, 5, 24, texel.parse().unwrap());
                spec.options.border = border.parse().unwrap();
                spec.options.behind = behind.parse().unwrap();
                let form = spec.build(&model, 1.0).unwrap();
                for light in [Light::new(0.0, 0.0), Light::new(61.0, 200.0), Light::new(173.0, 33.0)] {
                    let record = form.record(light);
                    let mut out = vec![[1.0f32; 3]; normals.len()];
                    form.add(&record, 0.5, single, &mut out);
                    for (own, &n) in out.iter().zip(&normals) {
                        let wanted = form.at(light, n);
                        for c in 0..3 {
                            let off = (f64::from(own[c]) - 1.0 - 0.5 * wanted[c]).abs();
                            assert!(off < 2e-4 * (1.0 + wanted[c]), "{spec} {light:?} {n:?} {own:?} {wanted:?}");
                        }
                    }
                    // However they are cut.
                    let mut cut = vec![[1.0f32; 3]; normals.len()];
                    for start in (0..normals.len()).step_by(37) {
                        let end = (start + 37).min(normals.len());
                        form.add(&record, 0.5, single.map(|axis| &axis[start..end]), &mut cut[start..end]);
                    }
                    assert_eq!(out, cut);
                }
            }
        }
    }
}

/// A reflectance of which one cell is enormous and all others are black.
fn spike() -> Table {
    let shape = [90, 90, 180];
    let mut cells = vec![[0.0f32; 3]; 90 * 90 * 180];
    cells[90 + 180 * (30 + 90 * 12)] = [1e6; 3];
    Table::new(shape, cells, "spike").unwrap()
}

/// Where the forms and their limits are undefined or degenerate: everything is finite and not negative, in both ways of
/// looking up.
#[test]
fn extremes_are_finite_and_have_their_limits() {
    let with = |name: &str, key: &str, value: &str| {
        let mut model = Model::named(name).unwrap();
        model.set(key, value).unwrap();
        model
    };
    let black = Table::new([90, 90, 180], vec![[0.0; 3]; 90 * 90 * 180], "black").unwrap();
    let spike = spike();
    let (mirror, sharp) = (with("ggx", "alpha", "0.001"), with("blinnphong", "n", "65536"));
    let lambert = Model::named("lambert").unwrap();
    let reflectances: [(&str, &dyn Reflectance); 5] =
        [("black", &black), ("spike", &spike), ("mirror", &mirror), ("sharp", &sharp), ("lambert", &lambert)];
    let mut normals = vec![
        Vector::z(),
        -Vector::z(),
        Vector::x(),
        -Vector::x(),
        Vector::y(),
        -Vector::y(),
        Vector::new(0.6, 0.0, 0.8),
        Vector::new(1e-9, -1.0, 1e-9).normalize(),
    ];
    for phi in [20.0, 75.0, 150.0] {
        // On the terminator, and a hair to either side.
        normals.extend([-90.0, -90.0 + 1e-6, -90.0 - 1e-6].map(|off| Light::new(phi + off, 0.0).direction()));
        normals.push(Light::new(0.5 * phi, 0.0).direction());
    }
    for (name, reflectance) in reflectances {
        for (kind, images, size) in [
            (FormKind::Paper, 1, 2),
            (FormKind::Paper, 4, 64),
            (FormKind::Half, 1, 2),
            (FormKind::Half, 16, 32),
            (FormKind::Bivariate, 1, 2),
            (FormKind::Bivariate, 1, 32),
        ] {
            for texel in ["float", "linear:8", "sqrt:8", "sqrt:1", "565"] {
                let spec = FormSpec::sized(kind, images, size, texel.parse().unwrap());
                let form = spec.build(reflectance, 2.0).unwrap();
                for phi in [0.0, 1e-9, 20.0, 45.0, 75.0, 90.0, 135.0, 150.0, 176.0, 179.999_999, 180.0] {
                    let light = Light::new(phi, 123.0);
                    let record = form.record(light);
                    for &n in &normals {
                        let n = vector::about_z(n, vector::sine_cosine(123.0));
                        let value = form.at(light, n);
                        let single = [0, 1, 2].map(|axis| [n[axis] as f32]);
                        let mut many = [[0.0f32; 3]];
                        form.add(&record, 1.0, [&single[0], &single[1], &single[2]], &mut many);
                        let fine = |v: f64| v.is_finite() && v >= 0.0;
                        let values = value.into_iter().chain(many[0].map(f64::from));
                        assert!(values.clone().all(fine), "{name} {spec} {phi} {n:?}: {value:?} {many:?}");
                        if name == "black" || kind != FormKind::Paper && (phi == 180.0 || n.z <= 0.0) {
                            assert!(values.clone().all(|v| v == 0.0), "{name} {spec} {phi} {n:?}: {value:?}");
                        }
                        if kind != FormKind::Paper && n.dot(&light.direction()) <= 0.0 {
                            assert_eq!(value, [0.0; 3]);
                        }
                    }
                }
            }
        }
    }
}

/// Even a single slice of 2² floating-point texels is exact, up to the horizon.
#[test]
fn a_matt_material_is_exact() {
    let lambert = Model::named("lambert").unwrap();
    let form = FormSpec::sized(FormKind::Half, 1, 2, Texel::Float).build(&lambert, 2.0).unwrap();
    for phi in [0.0, 60.0, 179.0] {
        let (light, n) = (Light::new(phi, 40.0), Light::new(89.5, 40.0).direction());
        let exact = lambert.radiance(light, n, 2.0);
        assert!((form.at(light, n)[1] - exact[1]).abs() < 1e-6, "{phi}");
    }
}

/// The limit from beside it, for every azimuth.
#[test]
fn light_from_the_viewer_is_met() {
    let model = Model::named("ggx").unwrap();
    let n = Vector::new(0.1, 0.2, 0.97).normalize();
    for kind in FormKind::MADE {
        let form = FormSpec::of(kind).build(&model, 1.0).unwrap();
        let exact = model.radiance(Light::new(0.0, 0.0), n, 1.0);
        for gamma in [0.0, 77.0, 291.0] {
            let (at, beside) = (form.at(Light::new(0.0, gamma), n), form.at(Light::new(1e-7, gamma), n));
            assert!((0..3).all(|c| (at[c] - beside[c]).abs() < 1e-3), "{kind:?} {gamma}: {at:?} {beside:?}");
            assert!(
                (0..3).all(|c| (at[c] - exact[c]).abs() < 0.05 * exact[c] + 0.01),
                "{kind:?} {gamma}: {at:?} {exact:?}"
            );
        }
    }
}

#[test]
fn wrong_shapes_are_refused() {
    let said = |kind: FormKind, images: &str, size: usize| {
        let mut spec = FormSpec::of(kind);
        spec.size = size;
        let error = spec.set_images(images).and_then(|()| spec.check()).err();
        error.map(|error| error.to_string()).unwrap_or_default()
    };
    assert_eq!(said(FormKind::Paper, "0,45,90,135", 512), "");
    assert_eq!(said(FormKind::Paper, "6", 512), "");
    assert!(said(FormKind::Paper, "0,45,40", 512).contains("the angles 0, 45, 40 do not ascend"));
    assert!(said(FormKind::Paper, "0,45,45", 512).contains("do not ascend"));
    assert!(said(FormKind::Paper, "0,181", 512).contains("the angle 181° is out of range"));
    assert!(said(FormKind::Paper, "-1,20", 512).contains("the angle -1° is out of range"));
    assert!(said(FormKind::Paper, "nan,20", 512).contains("out of range"));
    assert!(said(FormKind::Half, "0,179", 32).contains("179° is out of range"));
    for images in ["0", "361", "4294967296", "a,b", ""] {
        assert!(said(FormKind::Paper, images, 512).contains("images `"), "{images}");
    }
    for size in [0, 1, 4097, 1_000_000] {
        assert!(said(FormKind::Paper, "4", size).contains(&format!("the size {size} is out of range")));
    }
    assert!(said(FormKind::Paper, "180", 2048).contains("too many"));
    let angles = |kind: FormKind, images: &str| {
        let mut spec = FormSpec::of(kind);
        spec.set_images(images).unwrap();
        spec.angles
    };
    assert_eq!(angles(FormKind::Paper, "4"), [0.0, 45.0, 90.0, 135.0]);
    assert_eq!(angles(FormKind::Paper, "6"), [0.0, 30.0, 60.0, 90.0, 120.0, 150.0]);
    assert_eq!(angles(FormKind::Half, "3"), [0.0, 88.0, 176.0]);
    assert_eq!(angles(FormKind::Half, "1"), [0.0]);
    assert_eq!(angles(FormKind::Paper, "7.5,"), [7.5]);
}
