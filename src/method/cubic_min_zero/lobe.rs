//! The cubic lobe whose minimum is zero, x((1 - K u)+)^2, of "Approximation of classical distributive functions using a
//! cubic polynomial" (2021).

use crate::method::cubic::check_level;

use crate::lobe::{Lobe, check_shininess};
use crate::platform::error::Error;

/// `x max(0, 1 - K u)^2`, `u = 1 - x`.
///
/// The cubic through (0, 0), (1, 1) and (t, Q), `t = Q^(1/n)`, with a minimum of value 0: the paper replaces the fourth
/// equation of its three-point system by this and gives no solution. A double zero leaves one unknown,
/// `K = (1 - sqrt(Q/t)) / (1 - t)`; the other root of the square has its zero above t, inside the epicentre, and is
/// rejected. Below its zero the cubic would rise again, so it is 0 there. For n < 3 the zero lies at x <= 0
/// and nothing is cut (for Q = 1/2; K(3) = 1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MinZero {
    /// The coefficient: 0 for n = 1, then rising to `(1 - sqrt Q) / -ln Q * n`, which is 0.42256 n for Q = 1/2.
    pub k: f64,
}

impl MinZero {
    /// The coefficient for the shininess `n` and the level `q`, with a relative error below 1e-14.
    ///
    /// `Q/t = Q^(1 - 1/n)`, so that both differences from 1 are values of `expm1` and nothing cancels.
    ///
    /// # Errors
    /// See [`check_shininess`]; a level outside 0.05..=0.95.
    pub fn new(n: f64, q: f64) -> Result<Self, Error> {
        check_shininess(n)?;
        check_level(q)?;
        let log_q = libm::log(q);
        Ok(Self { k: libm::expm1(0.5 * log_q * ((n - 1.0) / n)) / libm::expm1(log_q / n) })
    }

    /// The versine from which the lobe is 0: `1/K`, and at most 1.
    #[must_use]
    pub fn zero(&self) -> f64 {
        if self.k > 1.0 { 1.0 / self.k } else { 1.0 }
    }
}

impl Lobe for MinZero {
    fn at(&self, u: f64) -> f64 {
        let root = (1.0 - self.k * u).max(0.0);
        (1.0 - u) * (root * root)
    }
}
