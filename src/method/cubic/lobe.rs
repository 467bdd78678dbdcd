//! The cubic lobe x(1 - u(A - a u)) of "Approximation of Bidirectional Reflectance Distribution
//! Function with 3-Degree Polynomial" (IEEE, 2007) and of its 2021 successor, which frees the level Q.

use crate::lobe::{Lobe, check_shininess};
use crate::platform::error::Error;

/// `x (1 - u (A - a u))` up to its cut, 0 past it, kept inside [0, 1]; `u = 1 - x`.
///
/// The cubic `a x^3 + b x^2 + c x` passes through (0, 0) and (1, 1) and has the value and the slope of x^n at the point
/// `t = Q^(1/n)` where x^n = Q (2007: eqs. 2 to 8 with Q = 1/2; 2021: free Q). Here `A = 2a + b`. With `h = Q/t`,
/// `h' = (n-1) Q / t^2` and `u_t = 1 - t`: `a = (1 - h - h' u_t) / u_t^2` and `A = h' + 2 a u_t`.
///
/// Past the epicentre the cubic *rises* again, into the ten-thousands at n = 1000, so that a clamp at 0 is
/// no help: it is cut to 0 beyond the minimum of its inner parabola, `u > A / (2a)`. Only for non-integer
/// n between 2 and 3 does it fall below 0 before that (by 0.003 at most for Q = 1/2); there it is clamped.
/// Misprints of the 2007 paper: n is said to run from 0 to 1 where 1000 is meant, and the cubic is said
/// to take negative values, which it does for no integer n.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cubic {
    /// The papers' `a`: negative for 1 < n < 2, 0 at n = 1 and n = 2, then positive, about 0.319 n^2 for Q = 1/2.
    pub a: f64,
    /// `2a + b` of the papers' `a` and `b`: about 0.942 n for Q = 1/2.
    pub big_a: f64,
}

/// Nodes and weights of the 16-point Gauss-Legendre rule on [-1, 1], the positive half (A&S, table 25.4).
const GAUSS_16: [(f64, f64); 8] = [
    (0.095_012_509_837_637_44, 0.189_450_610_455_068_5),
    (0.281_603_550_779_258_9, 0.182_603_415_044_923_6),
    (0.458_016_777_657_227_4, 0.169_156_519_395_002_54),
    (0.617_876_244_402_643_7, 0.149_595_988_816_576_73),
    (0.755_404_408_355_003, 0.124_628_971_255_533_87),
    (0.865_631_202_387_831_7, 0.095_158_511_682_492_78),
    (0.944_575_023_073_232_6, 0.062_253_523_938_647_894),
    (0.989_400_934_991_649_9, 0.027_152_459_411_754_095),
];

/// The integral of `integrand` from `from` to `to` by 16 Gauss points.
pub(in crate::method) fn integral(from: f64, to: f64, integrand: impl Fn(f64) -> f64) -> f64 {
    let half = 0.5 * (to - from);
    let at = |z: f64| integrand(from + half * (1.0 + z));
    let sum: f64 = GAUSS_16.iter().map(|&(z, w)| w * (at(-z) + at(z))).sum();
    half * sum
}

/// Refuses a level at which the cubic's family is not meant to touch the power.
pub(in crate::method) fn check_level(q: f64) -> Result<(), Error> {
    if (0.05..=0.95).contains(&q) {
        return Ok(());
    }
    Err(Error::input(
        format!("level q = {q} is out of range"),
        "q is the lobe's value at the cubic's point of contact, from 0.05 to 0.95",
    ))
}

impl Cubic {
    /// The coefficients for the shininess `n` and the level `q` in (0, 1).
    ///
    /// As printed, `1 - h - h' u_t` cancels wholly near n = 1, near n = 2 and for q near 1. It is the Taylor remainder
    /// of `x^(n-1)` about t, so with `x = e^-y`, `L = -ln t` it equals
    /// `(n-1)(n-2) * integral over 0..L of (1 - e^-y) e^-(n-2)y dy`: a positive, entire integrand, which 16 Gauss
    /// points integrate to rounding error. The relative error of `a` is below 1e-13. So is that of `A`, except for n
    /// below 2 with q below 0.3: there A has a zero, and 1e-13 is relative to the larger of its two terms.
    ///
    /// # Errors
    /// A shininess that [`check_shininess`] refuses, or a level outside 0.05..=0.95.
    pub fn new(n: f64, q: f64) -> Result<Self, Error> {
        check_shininess(n)?;
        check_level(q)?;
        if n == 1.0 {
            return Ok(Self { a: 0.0, big_a: 0.0 });
        }
        let log_q = libm::log(q);
        let length = -log_q / n;
        let u_t = -libm::expm1(-length);
        let integrand = |y: f64| -libm::expm1(-y) * libm::exp(-(n - 2.0) * y);
        let a = (n - 1.0) * (n - 2.0) * integral(0.0, length, integrand) / (u_t * u_t);
        let slope = (n - 1.0) * libm::exp(log_q + 2.0 * length);
        Ok(Self { a, big_a: slope + 2.0 * a * u_t })
    }

    /// The versine beyond which the lobe is cut to 0: `A / (2a)` where the inner parabola has its minimum
    /// there and inside [0, 1).
    #[must_use]
    pub fn cut(&self) -> Option<f64> {
        let minimum = self.big_a / (2.0 * self.a);
        (self.a > 0.0 && minimum < 1.0).then_some(minimum)
    }

    /// The versine in (0, 1) of the cubic's own minimum, where it is held if not cut: the smaller zero of its
    /// derivative `-(3a u^2 - 2(A + a) u + (1 + A))`.
    #[must_use]
    pub fn minimum(&self) -> Option<f64> {
        let half = self.big_a + self.a;
        let minimum = (1.0 + self.big_a) / (half + libm::sqrt(half * half - 3.0 * self.a * (1.0 + self.big_a)));
        (0.0 < minimum && minimum < 1.0).then_some(minimum)
    }

    /// `x (1 - u (A - a u))`, wherever it goes.
    #[must_use]
    pub fn formula(&self, u: f64) -> f64 {
        (1.0 - u) * (1.0 - u * (self.big_a - self.a * u))
    }

    /// The printed `(a, b, c)` of `a x^3 + b x^2 + c x`.
    #[must_use]
    pub fn printed(&self) -> [f64; 3] {
        [self.a, self.big_a - 2.0 * self.a, 1.0 - self.big_a + self.a]
    }
}

impl Lobe for Cubic {
    fn at(&self, u: f64) -> f64 {
        if self.cut().is_some_and(|cut| u > cut) {
            return 0.0;
        }
        self.formula(u).clamp(0.0, 1.0)
    }
}
