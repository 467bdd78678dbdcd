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
