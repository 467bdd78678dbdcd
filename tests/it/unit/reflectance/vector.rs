use brdfgen::reflectance::vector::*;

use super::samples::{random, upper};

#[test]
fn angles_lead_back_to_their_vectors() {
    let mut random = random(1);
    for _ in 0..2000 {
        let (l, v, n) = (upper(&mut random), upper(&mut random), Vector::z());
        let angles = Angles::of(l, v, n).unwrap();
        let [l2, v2, n2] = angles.vectors();
        // Scalar products do not depend on the frame; the determinant tells the two turns of φd apart.
        for (a, b) in [(l.dot(&n), l2.dot(&n2)), (v.dot(&n), v2.dot(&n2)), (l.dot(&v), l2.dot(&v2))] {
            assert!((a - b).abs() < 1e-12, "{a} {b} {angles:?}");
        }
        assert!((l.cross(&v).dot(&n) - l2.cross(&v2).dot(&n2)).abs() < 1e-12);
    }
}

#[test]
fn angles_have_limits_where_they_are_undefined() {
    let l = Light::new(40.0, 10.0).direction();
    let same = Angles::of(l, l, Vector::z()).unwrap();
    assert!(same.theta_d == 0.0 && (same.theta_h - 40f64.to_radians()).abs() < 1e-12);
    let mirror = Angles::of(l, Vector::new(-l.x, -l.y, l.z), Vector::z()).unwrap();
    assert!(mirror.theta_h < 1e-12 && (mirror.theta_d - 40f64.to_radians()).abs() < 1e-12);
    assert_eq!(Angles::of(l, -l, Vector::z()), None);
}

#[test]
fn another_viewer_sees_the_same_geometry() {
    let mut random = random(7);
    for _ in 0..500 {
        let (l, v, n) = (upper(&mut random), upper(&mut random), upper(&mut random));
        let (light, m) = seen_from(l, v, n);
        let k = light.direction();
        for (a, b) in [(l.dot(&n), k.dot(&m)), (v.dot(&n), m.z), (l.dot(&v), k.z)] {
            assert!((a - b).abs() < 1e-12, "{a} {b}");
        }
        assert!((l.cross(&v).dot(&n) - k.cross(&Vector::z()).dot(&m)).abs() < 1e-12);
    }
}

#[test]
fn lights_and_directions_agree() {
    for (phi, gamma) in [(0.0, 0.0), (30.0, 270.0), (90.0, 45.0), (179.0, 12.0), (180.0, 0.0)] {
        let light = Light::new(phi, gamma);
        let again = Light::towards(light.direction() * 3.0);
        assert!((again.phi - phi).abs() < 1e-9, "{again:?}");
        assert!((again.gamma - gamma).rem_euclid(360.0).min((gamma - again.gamma).rem_euclid(360.0)) < 1e-9);
    }
    assert_eq!(Light::new(180.0, 0.0).direction(), Vector::new(0.0, 0.0, -1.0));
    // A light turned back by γ lies in the plane y = 0.
    let turned = about_z(Light::new(70.0, 25.0).direction(), sine_cosine(-25.0));
    assert!((turned - Light::new(70.0, 0.0).direction()).norm() < 1e-15);
    let half = about_y(Light::new(70.0, 0.0).direction(), sine_cosine(-35.0));
    assert!((half - Light::new(35.0, 0.0).direction()).norm() < 1e-15);
}
