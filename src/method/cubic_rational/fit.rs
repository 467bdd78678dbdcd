//! The cubic with a rational tail.

use crate::fit::{Fit, Objective};
use crate::lobe;
use crate::method::cubic::{self, Tail};
use crate::method::cubic_rational::CubicRational;
use crate::platform::error::Error;

/// The level of the point at which the tail takes over: x^n there.
const LEVEL: f64 = 0.5;
/// Places in the tail, evenly spaced in the logarithm of the depth `-n ln x`.
const PLACES: usize = 400;
/// The depth past which the power is nothing.
const DEEPEST: f64 = 40.0;
/// Steps of the search for b, each of which leaves 0.618 of its interval.
const STEPS: usize = 60;

/// The best cubic down to x^n = 1/2 for the shininess `n`, and past it the best tail `x / (d + b u)` that goes on from
/// its value there, which it takes to be 1/2 at most.
///
/// One unknown is left, b: at each u the tail falls with it, so that its largest error has one minimum, which a golden
/// section finds.
///
/// # Errors
/// As [`crate::method::quadratic::fit`].
pub fn fit(n: f64, objective: &Objective) -> Result<Fit<CubicRational>, Error> {
    let paper = CubicRational::new(n, LEVEL)?;
    let head = match *objective {
        Objective::MaxRel { level } => Objective::MaxRel { level: level.max(LEVEL) },
        Objective::MaxAbsLevel { level } => Objective::MaxAbsLevel { level: level.max(LEVEL) },
        Objective::MaxAbs | Objective::Weighted { .. } => Objective::MaxAbsLevel { level: LEVEL },
    };
    let head = cubic::fit(n, Tail::Cut, &head)?;
    if n == 1.0 {
        return Ok(Fit { coefficients: paper, error: 0.0 });
    }
    let value = head.coefficients.formula(paper.cusp).clamp(0.5 * LEVEL, LEVEL);
    let start = (1.0 - paper.cusp) / value;
    let first = -libm::log(LEVEL);
    let ratio = libm::log(DEEPEST.max(n) / first) / (PLACES - 1) as f64;
    let places: Vec<f64> = (0..PLACES)
        .map(|place| -libm::expm1(-first * libm::exp(ratio * place as f64) / n))
        .filter(|&u| objective.counts(lobe::exact(n, u)))
        .collect();
    let error = |b: f64| {
        let at = |&u: &f64| {
            let power = lobe::exact(n, u);
            ((1.0 - u) / (start + b * (u - paper.cusp)) - power).abs() * objective.weight(power)
        };
        places.iter().map(at).fold(0.0, f64::max)
    };
    let golden = (libm::sqrt(5.0) - 1.0) / 2.0;
    let (mut low, mut high) = (0.5 * paper.b, 4.0 * paper.b);
    for _ in 0..STEPS {
        let (left, right) = (high - golden * (high - low), low + golden * (high - low));
        if error(left) <= error(right) { high = right } else { low = left }
    }
    // With nothing of the tail to fit, its paper's slope stays.
    let b = if places.is_empty() { paper.b } else { 0.5 * (low + high) };
    let coefficients = CubicRational { cubic: head.coefficients, b, d: start - b * paper.cusp, cusp: paper.cusp };
    Ok(Fit { coefficients, error: head.error.max(error(b)) })
}
