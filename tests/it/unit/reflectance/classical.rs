use brdfgen::reflectance::classical::*;
use brdfgen::reflectance::vector::{Light, Vector};
use brdfgen::reflectance::{Reflectance, Rgb};

/// A classical material as a reflectance: what is fitted is found again.
struct Known(Classical);

impl Reflectance for Known {
    fn at(&self, l: Vector, v: Vector, n: Vector) -> Rgb {
        assert!((v - Vector::z()).norm() < 1e-12, "the camera's");
        let light = Light::towards(l);
        self.0.at(light, n).map(|value| value / n.dot(&l))
    }
}

#[test]
fn a_classical_material_is_found_again() {
    for cosine in [Cosine::Blinn, Cosine::Phong] {
        let lobes = vec![Lobe { ks: [0.1, 0.2, 0.0], n: 8.0 }, Lobe { ks: [0.6, 0.5, 0.4], n: 90.0 }];
        let known = Classical { cosine, kd: [0.4, 0.2, 0.3], lobes };
        let fit = fit(&Known(known.clone()), cosine, 2, 1.0, &|| ()).unwrap();
        let Classical { kd, lobes, .. } = &fit.material;
        assert!((0..3).all(|c| (kd[c] - known.kd[c]).abs() < 0.01), "{fit:?}");
        assert!((lobes[0].n / 8.0 - 1.0).abs() < 0.1 && (lobes[1].n / 90.0 - 1.0).abs() < 0.05, "{fit:?}");
        assert!(fit.quality.worst > 50.0 && fit.max_steps <= 2 && fit.mean_steps < 0.2, "{fit:?}");
    }
}

#[test]
fn every_step_is_told() {
    for lobes in 1..=MOST_LOBES {
        let count = std::sync::atomic::AtomicU64::new(0);
        let done = || {
            count.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
        };
        let model = brdfgen::reflectance::Model::named("lambert").unwrap();
        let fit = fit(&model, Cosine::Blinn, lobes, 1.0, &done).unwrap();
        assert_eq!(count.into_inner(), steps(lobes));
        assert!(fit.quality.mean > 100.0 && (fit.material.kd[0] - 0.5 / std::f64::consts::PI).abs() < 1e-3, "{fit:?}");
    }
    let model = brdfgen::reflectance::Model::named("lambert").unwrap();
    for lobes in [0, 4] {
        assert!(fit(&model, Cosine::Blinn, lobes, 1.0, &|| ()).is_err());
    }
}
