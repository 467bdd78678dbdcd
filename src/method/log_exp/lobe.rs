//! The power itself, and the functions by which a logarithm and an exponential compute it.

use crate::lobe::{Lobe, check_shininess, exact};
use crate::platform::error::Error;

/// `x^n`, which is `2^(-n L)` with `L = -log2 x` (Harris, "An Exponentiation Unit for an OpenGL Lighting Engine", IEEE
/// Trans. Computers 53(3), 2004).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LogExp {
    /// The shininess.
    pub n: f64,
}

impl LogExp {
    /// The power for the shininess `n`.
    ///
    /// # Errors
    /// See [`check_shininess`].
    pub fn new(n: f64) -> Result<Self, Error> {
        check_shininess(n)?;
        Ok(Self { n })
    }
}

impl Lobe for LogExp {
    fn at(&self, u: f64) -> f64 {
        // x^n is at most e^(-n u): below e^-60 it is nothing beside any output's last bit.
        if self.n * u > 60.0 { 0.0 } else { exact(self.n, u) }
    }
}

/// `-log2(m) / (1 - m)` for m in (0, 1]: convex and falling, 2 at m = 1/2 and `log2 e` at m = 1.
///
/// With it `-log2 m = (1 - m) log_ratio(m)` keeps its relative accuracy where m is near 1 and a large shininess needs
/// it.
#[must_use]
pub fn log_ratio(m: f64) -> f64 {
    let w = 1.0 - m;
    if w == 0.0 { std::f64::consts::LOG2_E } else { -libm::log1p(-w) / w * std::f64::consts::LOG2_E }
}

/// A bound of the second derivative of [`log_ratio`] over [1/2, 1]: it falls from 4.459 to 0.962 there, being
/// `log2 e` times the sum of `k (k-1) / (k+1) (1-m)^(k-2)`.
pub const LOG_RATIO_CURVATURE: f64 = 4.5;

/// A bound of the second derivative of `2^-f` for f >= 0: the square of ln 2.
pub const EXP_CURVATURE: f64 = 0.4805;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curvature_bounds_hold_and_are_near() {
        let second = |f: &dyn Fn(f64) -> f64, at: f64| {
            let h = 1e-4;
            (f(at - h) - 2.0 * f(at) + f(at + h)) / (h * h)
        };
        let mut largest = 0.0f64;
        for step in 0..=50 {
            let m = 0.5 + 0.0099 * f64::from(step);
            let curvature = second(&log_ratio, m);
            assert!(0.9 < curvature && curvature < LOG_RATIO_CURVATURE, "m = {m}: {curvature}");
            largest = largest.max(curvature);
        }
        assert!(largest > 4.4);
        let power = |f: f64| libm::exp2(-f);
        assert!(second(&power, 0.0) < EXP_CURVATURE && second(&power, 0.0) > 0.48);
    }
}
