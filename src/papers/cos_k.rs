//! The lobe cos^k(sqrt(n/k) γ) of O. Romanyuk and A. Chornyi, 2004 (the papers' reference 4).

use crate::lobe::{Lobe, check_shininess};
use crate::method::lyon::{check_outer_power, squarings};
use crate::platform::error::Error;

/// `cos^k(sqrt(n/k) arccos x)` for k = 2, 4 or 8, and 0 past its first zero. A comparator in software only: hardware
/// would need the arc cosine, which is why the papers reject it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CosK {
    /// The shininess.
    pub n: f64,
    /// The outer power: 2, 4 or 8.
    pub k: u32,
}

impl CosK {
    /// The lobe for the shininess `n` and the outer power `k`.
    ///
    /// # Errors
    /// See [`check_shininess`]; a `k` other than 2, 4 and 8.
    pub fn new(n: f64, k: u32) -> Result<Self, Error> {
        check_shininess(n)?;
        check_outer_power(k)?;
        Ok(Self { n, k })
    }
}

impl Lobe for CosK {
    fn at(&self, u: f64) -> f64 {
        // arccos x without the cancellation of 1 - x.
        let angle = 2.0 * libm::asin(libm::sqrt(0.5 * u));
        let scaled = libm::sqrt(self.n / f64::from(self.k)) * angle;
        if scaled >= core::f64::consts::FRAC_PI_2 { 0.0 } else { squarings(libm::cos(scaled).max(0.0), self.k) }
    }
}
