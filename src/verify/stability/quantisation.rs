//! What the rounding of the input alone costs, whatever the core, and what the versine saves of it.

use libm::{cos, sin, sqrt};
use rayon::prelude::*;
use serde::Serialize;

use crate::fixed::{Rng, exp2};
use crate::lobe::exact;

/// The largest move of `x^n` where the cosine is rounded to nearest with `fraction` bits: `1 - (1 - 2^-(F+1))^n`, at
/// the top of the lobe, where it is steepest for every n of at least 1.
#[must_use]
pub fn of_cosine(shininess: f64, fraction: u32) -> f64 {
    1.0 - exact(shininess, exp2(-(fraction as i32) - 1))
}

/// The largest error of `x^n` that a front end with vectors of `bits` fraction bits makes, in two ways.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct FrontEnd {
    /// The shininess.
    pub shininess: f64,
    /// Fraction bits of the vectors' components.
    pub bits: u32,
    /// With the cosine as the scalar product N·H.
    pub cosine: f64,
    /// With the versine as |N - H|²/2.
    pub versine: f64,
}

/// Pairs of vectors that are tried.
const PAIRS: u64 = 20_000;

/// Measures a front end on pairs of unit vectors, spread over the sphere, whose angles cover the lobe down to `x^n` =
/// 1/1000. Both ways get the same rounded vectors and compute without rounding, so that only the vectors' rounding
/// shows.
#[must_use]
pub fn front_end(shininess: f64, bits: u32) -> FrontEnd {
    let widest = libm::acos(libm::exp(libm::log(1e-3) / shininess));
    let pair = |place: u64| {
        let mut rng = Rng::new(place);
        let mut unit = || rng.below(1 << 30) as f64 * exp2(-30);
        let (z, turn, around, angle) = (2.0 * unit() - 1.0, unit(), unit(), widest * unit());
        let turn = 2.0 * std::f64::consts::PI * turn;
        let flat = sqrt((1.0 - z * z).max(0.0));
        let normal = [flat * cos(turn), flat * sin(turn), z];
        // Two vectors across the normal, and the half vector at the angle from it.
        let across = [-sin(turn), cos(turn), 0.0];
        let third = [-z * cos(turn), -z * sin(turn), flat];
        let around = 2.0 * std::f64::consts::PI * around;
        let half: [f64; 3] = std::array::from_fn(|axis| {
            cos(angle) * normal[axis] + sin(angle) * (cos(around) * across[axis] + sin(around) * third[axis])
        });
        let rounded = |vector: [f64; 3]| vector.map(|c| libm::round(c * exp2(bits as i32)) * exp2(-(bits as i32)));
        let (n, h) = (rounded(normal), rounded(half));
        let sine = sin(0.5 * angle);
        let ideal = exact(shininess, 2.0 * sine * sine);
        let product: f64 = (0..3).map(|axis| n[axis] * h[axis]).sum();
        let apart: f64 = (0..3).map(|axis| (n[axis] - h[axis]) * (n[axis] - h[axis])).sum();
        let error = |versine: f64| (exact(shininess, versine.clamp(0.0, 1.0)) - ideal).abs();
        [error(1.0 - product), error(0.5 * apart)]
    };
    let worst = (0..PAIRS).into_par_iter().map(pair).reduce(|| [0.0; 2], |a, b| [a[0].max(b[0]), a[1].max(b[1])]);
    FrontEnd { shininess, bits, cosine: worst[0], versine: worst[1] }
}
