//! Vectors, lights as angles, and the angles about the half vector.

use std::f64::consts::PI;

use libm::{atan2, cos, sin, sqrt};

/// A direction, as a rule of length 1.
pub type Vector = nalgebra::Vector3<f64>;

/// A directional light as the camera sees it: its polar angle φ from the direction to the viewer and its azimuth γ
/// about it, in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// From 0 (behind the viewer) to 180 degrees (behind the object).
    pub phi: f64,
    /// From +X towards +Y, in degrees; any number.
    pub gamma: f64,
}

impl Light {
    /// The light at these angles in degrees.
    #[must_use]
    pub fn new(phi: f64, gamma: f64) -> Self {
        Self { phi, gamma }
    }

    /// The light in a direction, which need not have the length 1, for a viewer at +Z. Along ±Z, where γ is undefined,
    /// it is 0.
    #[must_use]
    pub fn towards(direction: Vector) -> Self {
        let across = sqrt(direction.x * direction.x + direction.y * direction.y);
        let phi = atan2(across, direction.z).to_degrees();
        let gamma = if across > 0.0 { atan2(direction.y, direction.x).to_degrees() } else { 0.0 };
        Self { phi, gamma }
    }

    /// The unit vector to the light.
    #[must_use]
    pub fn direction(self) -> Vector {
        let [sine, cosine] = sine_cosine(self.phi);
        let [gamma_sine, gamma_cosine] = sine_cosine(self.gamma);
        Vector::new(sine * gamma_cosine, sine * gamma_sine, cosine)
    }
}

/// A light and a normal as a viewer in the direction `v` sees them: turned so that `v` is +Z, as the forms have it. For
/// a perspective camera, or a viewer that is not at +Z; all three are unit vectors in one frame.
#[must_use]
pub fn seen_from(l: Vector, v: Vector, n: Vector) -> (Light, Vector) {
    // An axis across v that is well away from it; γ does not depend on which.
    let other = if v.x.abs() < 0.7 { Vector::x() } else { Vector::y() };
    let y = v.cross(&other).normalize();
    let x = y.cross(&v);
    let turned = |a: Vector| Vector::new(a.dot(&x), a.dot(&y), a.dot(&v));
    (Light::towards(turned(l)), turned(n))
}

/// Sine and cosine of an angle in degrees, exact at multiples of 90.
#[must_use]
pub fn sine_cosine(degrees: f64) -> [f64; 2] {
    if degrees % 90.0 == 0.0 {
        return match (degrees / 90.0).rem_euclid(4.0) as u8 {
            0 => [0.0, 1.0],
            1 => [1.0, 0.0],
            2 => [0.0, -1.0],
            _ => [-1.0, 0.0],
        };
    }
    let radians = degrees.to_radians();
    [sin(radians), cos(radians)]
}

/// The rotation about Y: (x cos a + z sin a, y, z cos a - x sin a), of sine and cosine of a.
#[must_use]
pub fn about_y(n: Vector, [sine, cosine]: [f64; 2]) -> Vector {
    Vector::new(n.x * cosine + n.z * sine, n.y, n.z * cosine - n.x * sine)
}

/// The rotation about Z: (x cos a - y sin a, x sin a + y cos a, z), of sine and cosine of a.
#[must_use]
pub fn about_z(n: Vector, [sine, cosine]: [f64; 2]) -> Vector {
    Vector::new(n.x * cosine - n.y * sine, n.x * sine + n.y * cosine, n.z)
}

/// The angles of a pair of directions about their half vector, in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angles {
    /// Between the normal and the half vector, 0 to π/2.
    pub theta_h: f64,
    /// Between the half vector and either direction, 0 to π/2.
    pub theta_d: f64,
    /// The azimuth of the light about the half vector, 0 to 2π; 0 is opposite to the normal. 0 where it is undefined.
    pub phi_d: f64,
}

impl Angles {
    /// Those of unit vectors to the light, to the viewer and along the normal; none where light and viewer are
    /// opposite.
    #[must_use]
    pub fn of(l: Vector, v: Vector, n: Vector) -> Option<Self> {
        let sum = l + v;
        let length = sum.norm();
        if length < 1e-12 {
            return None;
        }
        let h = sum / length;
        // Arcus tangents of two lengths: an arcus cosine has half of the digits near 0, where sharp highlights are.
        let across = n.cross(&h);
        let along = n.dot(&h);
        let theta_h = atan2(across.norm(), along).min(0.5 * PI);
        let theta_d = atan2((l - v).norm(), length);
        // The axes of the frame of the half vector that the tables' authors use, both times sin θh.
        let (y, x) = (l.dot(&across), along * l.dot(&h) - l.dot(&n));
        let phi_d = if x == 0.0 && y == 0.0 { 0.0 } else { atan2(y, x) };
        Some(Self { theta_h, theta_d, phi_d: if phi_d < 0.0 { phi_d + 2.0 * PI } else { phi_d } })
    }

    /// Light and viewer of these angles in the frame with the half vector along Z, and the normal in it.
    #[must_use]
    pub fn vectors(self) -> [Vector; 3] {
        let (sine, cosine) = (sin(self.theta_d), cos(self.theta_d));
        let l = Vector::new(sine * cos(self.phi_d), sine * sin(self.phi_d), cosine);
        let v = Vector::new(-l.x, -l.y, l.z);
        [l, v, Vector::new(-sin(self.theta_h), 0.0, cos(self.theta_h))]
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use rand_core::{Rng, SeedableRng};
    use rand_pcg::Pcg64;

    /// Numbers from 0 to 1, the same in every run.
    pub(crate) fn random(seed: u64) -> impl FnMut() -> f64 {
        let mut random = Pcg64::seed_from_u64(seed);
        move || (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A direction of the upper half of the sphere.
    pub(crate) fn upper(random: &mut impl FnMut() -> f64) -> Vector {
        let (z, a) = (random(), 2.0 * PI * random());
        let r = (1.0 - z * z).sqrt();
        Vector::new(r * a.cos(), r * a.sin(), z)
    }

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
}
