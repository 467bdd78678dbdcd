//! The lobes that are a polynomial up to some versine and constant past it.

use crate::lobe::Lobe;

/// `x^e ((c - u (A - a u))⁺)^k` for `u <= end`, with e = 0 or 1 and k = 1, 2, 4 or 8, and a constant past the end; kept
/// inside [0, 1], and 0 at x = 0, where a surface faces away.
///
/// With the coefficients of a ROM's words it is what a core with fitted coefficients computes but for its roundings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polynomial {
    /// Whether there is a factor x.
    pub cosine: bool,
    /// k.
    pub power: u32,
    /// The constant coefficient, 1 for all but the later segments of a segmented lobe.
    pub c: f64,
    /// A.
    pub big_a: f64,
    /// a.
    pub a: f64,
    /// The last versine of the polynomial.
    pub end: f64,
    /// The value past the end.
    pub past: f64,
}

impl Lobe for Polynomial {
    fn at(&self, u: f64) -> f64 {
        if u >= 1.0 {
            return 0.0;
        }
        if u > self.end {
            return self.past;
        }
        let mut value = (self.c - u * (self.big_a - self.a * u)).max(0.0);
        for _ in 0..self.power.trailing_zeros() {
            value *= value;
        }
        (if self.cosine { (1.0 - u) * value } else { value }).min(1.0)
    }
}
