use std::f64::consts::PI;

use brdfgen::reflectance::measure::*;
use brdfgen::reflectance::vector::Light;

use super::samples::Flat;

#[test]
fn the_ratio_is_that_of_linear_clipped_values() {
    let exact = vec![[0.5f32, 2.0, 0.0]; 10];
    assert_eq!(psnr(&exact, &exact), 150.0);
    // Above 1 nothing is seen.
    assert_eq!(psnr(&exact, &[[0.5, 7.0, -1.0]; 10]), 150.0);
    let off = psnr(&exact, &[[0.6, 2.0, 0.0]; 10]);
    assert!((off - 10.0 * (3.0f64 / 0.01).log10()).abs() < 1e-5, "{off}");
}

#[test]
fn the_exposure_is_that_of_a_percentile() {
    // Of a matt sphere: the fraction of the disc with n·l above c is known; 10 % of it is brighter than P.
    let e = exposure(&Flat([1.0 / PI, 0.5 / PI, 0.0]));
    let bright = |c: f64| {
        let sphere = Sphere::new(400);
        let l = Light::new(45.0, 0.0).direction();
        sphere.normals.iter().filter(|n| n.dot(&l) > c).count() as f64 / sphere.normals.len() as f64
    };
    assert!((bright(0.6 * PI / e) - 0.1).abs() < 2e-3, "{e}");
    assert_eq!(exposure(&Flat([0.0; 3])), 1.0);
}

#[test]
fn angles_are_those_of_the_measure() {
    let five = angles(5.0);
    assert_eq!((five.len(), five[0], five[33]), (34, 2.5, 167.5));
    let all = angles(2.5);
    assert_eq!((all.len(), all[66]), (67, 167.5));
    let quality = Quality::of(vec![(2.5, 40.0), (7.5, 30.0), (12.5, 50.0)]);
    assert_eq!((quality.mean, quality.worst, quality.worst_phi), (40.0, 30.0, 7.5));
    assert_eq!(quality.mean_within(0.0..=10.0), 35.0);
}
