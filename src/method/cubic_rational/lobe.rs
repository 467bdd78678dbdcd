//! The cubic lobe with a rational tail, x/(d + b u), of the cubic's two papers (2007 and 2021).

use crate::method::cubic::check_level;

use crate::lobe::{Lobe, check_shininess};
use crate::method::cubic::Cubic;
use crate::platform::error::Error;

/// [`Cubic`] down to its point of contact t, and `x / (d + b u)` past it; `u = 1 - x`.
///
/// The papers' tail is `x / (a - b x)` with the value and the slope of x^n at t, where x^n = Q = 1/2: `a = 2n t` and
/// `b = 2n - 2`. For any Q in (0, 1) the same two conditions give `b = (n-1)/Q` and `d = a - b = (1 - n (1-t))/Q`, so
/// that value and slope of the whole are continuous. The denominator is `t/Q` at t and grows from there: there is no
/// pole. For Q = 1/2, `d` falls from 1 at n = 1 to `2 - 2 ln 2 = 0.6137`.
///
/// The tail is [`Schlick`](crate::method::schlick::Schlick)'s lobe S again: it equals `Q S(x/t)`, as the power is
/// `Q (x/t)^n`, so that its largest absolute error is exactly Q times Schlick's, and its relative error at the level v
/// Schlick's at `v/Q`.
///
/// Misprints: the 2007 paper's running text gives `a = 2n^n sqrt(0.5)` for `2n (0.5)^(1/n)`; in both papers the
/// derivative's second term has `(a - b cos^2(t))` below it for `(a - b cos(t))^2`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CubicRational {
    /// The epicentre's cubic.
    pub cubic: Cubic,
    /// The tail's slope in u: `(n-1)/Q`.
    pub b: f64,
    /// The tail's denominator at u = 0: `(1 - n (1-t))/Q`.
    pub d: f64,
    /// The versine `1 - t` of the point of contact, for Q = 1/2 the papers' cusp.
    pub cusp: f64,
}

impl CubicRational {
    /// The coefficients for the shininess `n` and the level `q`. The relative error is below 1e-14 for `b` and `cusp`,
    /// and for `d` relative to `1/Q`: for Q near 1/e, and only there, d may be near 0.
    ///
    /// # Errors
    /// See [`Cubic::new`].
    pub fn new(n: f64, q: f64) -> Result<Self, Error> {
        check_shininess(n)?;
        check_level(q)?;
        let cusp = -libm::expm1(libm::log(q) / n);
        Ok(Self { cubic: Cubic::new(n, q)?, b: (n - 1.0) / q, d: (1.0 - n * cusp) / q, cusp })
    }
}

impl Lobe for CubicRational {
    fn at(&self, u: f64) -> f64 {
        if u <= self.cusp { self.cubic.at(u) } else { (1.0 - u) / (self.d + self.b * u) }
    }
}
