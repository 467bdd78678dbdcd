//! The cubic through three points of the power, of "Approximation of classical distributive functions using a cubic
//! polynomial" (2021).

use crate::lobe::check_shininess;
use crate::method::cubic::{Cubic, integral};
use crate::platform::error::Error;

impl Cubic {
    /// The level Q of the three-point cubic's first point in the 2021 paper.
    pub const THREE_POINT_Q: f64 = 0.5;
    /// The level G of its second point.
    pub const THREE_POINT_G: f64 = 1.0 / 18.0;

    /// The cubic through (0, 0), (1, 1), (r, q) and (l, g), `r = q^(1/n)` and `l = g^(1/n)`, which are points of x^n.
    ///
    /// With `s(p) = (1 - p^(n-1)) / (1 - p)`: `a = (s(r) - s(l)) / (r - l)` and `A = s(r) + a (1 - r)`. Below l it
    /// rises again, into the thousands, hence the cut at the minimum of its inner parabola ([`Cubic::cut`]).
    ///
    /// These differences cancel near n = 1 and n = 2 and for g near q. But `a` is the second divided difference of
    /// x^(n-1) at l, r and 1: `(n-1)(n-2)` times the integral of x^(n-3) against the linear B-spline on these knots.
    /// With x = e^-y that is a sum of two integrals of positive, entire functions, each integrated by 16 Gauss points.
    /// The relative error of `a` is below 1e-13, and so is that of `A`, except for n below 2: there A has a zero, and
    /// 1e-13 is relative to the larger of its two terms. n = 1, 2, 3 give (a, A) = (0, 0), (0, 1), (1, 2).
    ///
    /// Misprints: the paper's closed form solves a system without a linear term, with the minus of b lost, l^2 for l^3
    /// in c and r^n for Q; at n = 25 its a, b and c add up to 156 and not to 1.
    ///
    /// # Errors
    /// See [`check_shininess`]; levels that are not in the order 1e-6 <= g < q < 1.
    pub fn three_point(n: f64, q: f64, g: f64) -> Result<Self, Error> {
        check_shininess(n)?;
        if !(1e-6 <= g && g < q && q < 1.0) {
            return Err(Error::input(
                format!("levels q = {q} and g = {g} are out of range or order"),
                "the cubic passes through the lobe's values q and g: 0.000001 <= g < q < 1",
            ));
        }
        if n == 1.0 {
            return Ok(Self { a: 0.0, big_a: 0.0 });
        }
        let (near, far) = (-libm::log(q) / n, -libm::log(g) / n);
        let (u_r, u_l) = (-libm::expm1(-near), -libm::expm1(-far));
        let power = |y: f64| libm::exp(-(n - 2.0) * y);
        // The spline falls from its peak at r to 0 at 1 and at l.
        let above = integral(0.0, near, |y| -libm::expm1(-y) * power(y)) / u_r;
        let r_minus_l = -libm::exp(-near) * libm::expm1(near - far);
        let below = integral(near, far, |y| -libm::exp(-y) * libm::expm1(y - far) * power(y)) / r_minus_l;
        let a = (n - 1.0) * (n - 2.0) * (above + below) / u_l;
        let s_r = libm::expm1(-(n - 1.0) * near) / libm::expm1(-near);
        Ok(Self { a, big_a: s_r + a * u_r })
    }
}
