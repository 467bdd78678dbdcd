//! The quadratic lobe x(1 - a u) of "Quadratic approximation of BRDF" (Vinnytsia).

use crate::lobe::{Lobe, check_shininess};
use crate::platform::error::Error;

/// `max(0, x (1 - a u))`, `u = 1 - x`: the paper's `a x^2 + (1 - a) x` (its eqs. 1 and 4), factored.
///
/// The parabola passes through (0, 0) and (1, 1) and meets x^n at its inflection (eqs. 5 and 6):
/// `t = sqrt(1 - 1/n)`, `a = (1 - t^(n-1)) / (1 - t)`. Misprint: the paper's text gives the inflection
/// at `γ = arctan(1/(n-1))` and uses it in eq. 7; it is `arctan(1/sqrt(n-1))`, the root is lost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quadratic {
    /// The coefficient: 0 for n = 1, then rising to `2 (1 - e^(-1/2)) n = 0.78694 n`.
    pub a: f64,
}

impl Quadratic {
    /// The coefficient for the shininess `n`, with a relative error below 1e-13.
    ///
    /// `1 - t` is computed as `(1/n) / (1 + t)`, and `1 - t^(n-1)` by `expm1`, with the logarithm of
    /// `1 - 1/n = (n-1)/n` taken in the form that is exact where it is small: nothing cancels.
    ///
    /// # Errors
    /// See [`check_shininess`].
    pub fn new(n: f64) -> Result<Self, Error> {
        check_shininess(n)?;
        if n == 1.0 {
            return Ok(Self { a: 0.0 });
        }
        let log = if n < 2.0 { libm::log((n - 1.0) / n) } else { libm::log1p(-1.0 / n) };
        let t = libm::sqrt((n - 1.0) / n);
        Ok(Self { a: -libm::expm1(0.5 * (n - 1.0) * log) * n * (1.0 + t) })
    }

    /// The versine from which the lobe is 0: `1/a`, and at most 1.
    #[must_use]
    pub fn zero(&self) -> f64 {
        if self.a > 1.0 { 1.0 / self.a } else { 1.0 }
    }
}

impl Lobe for Quadratic {
    fn at(&self, u: f64) -> f64 {
        ((1.0 - u) * (1.0 - self.a * u)).max(0.0)
    }
}
