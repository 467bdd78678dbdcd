//! What a reflectance is like: its albedo, its reciprocity.

use std::f64::consts::{FRAC_PI_2, PI};

use libm::{cos, sin};
use rand_core::{Rng, SeedableRng};
use rand_pcg::Pcg64;

use super::vector::{Vector, about_y, sine_cosine};
use super::{Reflectance, Rgb};

/// Steps of θh and of its azimuth in the integral of the albedo.
const STEPS: [usize; 2] = [400, 180];

/// The directional albedo: the part of the light that leaves, for light that comes from `theta` degrees off the normal.
/// The integral is taken over the half vector, in steps that become finer towards the normal, where highlights are.
#[must_use]
pub fn albedo(reflectance: &dyn Reflectance, theta: f64) -> Rgb {
    let v = about_y(Vector::z(), sine_cosine(theta));
    let [along, around] = STEPS;
    let mut sum = [0.0; 3];
    for step in 0..along {
        // θh = 90° u³, and its derivative.
        let u = (step as f64 + 0.5) / along as f64;
        let theta_h = FRAC_PI_2 * u * u * u;
        let area = sin(theta_h) * 3.0 * FRAC_PI_2 * u * u / along as f64 * 2.0 * PI / around as f64;
        for turn in 0..around {
            let phi = 2.0 * PI * (turn as f64 + 0.5) / around as f64;
            let h = Vector::new(sin(theta_h) * cos(phi), sin(theta_h) * sin(phi), cos(theta_h));
            let vh = v.dot(&h);
            let l = h * (2.0 * vh) - v;
            if vh > 0.0 && l.z > 0.0 {
                let f = reflectance.at(l, v, Vector::z());
                (0..3).for_each(|c| sum[c] += f[c] * l.z * 4.0 * vh * area);
            }
        }
    }
    sum
}

/// Pairs of directions that the reciprocity is measured on.
const PAIRS: usize = 20_000;

/// How far a reflectance is from reciprocal: the root mean square of f(l, v) - f(v, l) over that of f itself, on
/// directions of the upper half of the sphere. 0 for a reciprocal one.
#[must_use]
pub fn reciprocity_error(reflectance: &dyn Reflectance) -> f64 {
    let mut rng = Pcg64::seed_from_u64(1);
    let mut unit = || (rng.next_u64() >> 11) as f64 / (1u64 << 53) as f64;
    let mut direction = || {
        // Half a degree above the horizon at least, where tables are filled.
        let (z, phi) = (0.01 + 0.99 * unit(), 2.0 * PI * unit());
        let r = libm::sqrt(1.0 - z * z);
        Vector::new(r * cos(phi), r * sin(phi), z)
    };
    let (mut off, mut all) = (0.0, 0.0);
    for _ in 0..PAIRS {
        let (l, v) = (direction(), direction());
        let (one, other) = (reflectance.at(l, v, Vector::z()), reflectance.at(v, l, Vector::z()));
        for c in 0..3 {
            off += (one[c] - other[c]) * (one[c] - other[c]);
            all += one[c] * one[c];
        }
    }
    if all > 0.0 { libm::sqrt(off / all) } else { 0.0 }
}
