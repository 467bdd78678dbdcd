//! The lobe of R. F. Lyon, "Phong Shading Reformulation for Hardware Renderer Simplification", Apple Technical Report
//! 43, 1993.

use crate::lobe::{Lobe, check_shininess};
use crate::platform::error::Error;

/// `max(0, 1 - n u / k)^k` for k = 2, 4 or 8: squarings of a line in `u = D^2/2`, D being the chord between the unit
/// vectors.
///
/// The papers describe it as a Taylor series in the chord of which three terms are kept; that is
/// [`Taylor`](crate::papers::Taylor). What Lyon builds is this limit of `(1 - n u / k)^k` towards `e^(-n u)`, stopped
/// at a small k. For n < k nothing is cut, and the value at x = 0 is `(1 - n/k)^k` and not 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lyon {
    /// The shininess.
    pub n: f64,
    /// The outer power: 2, 4 or 8.
    pub k: u32,
}

impl Lyon {
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

/// Refuses an outer power that is not one to three squarings.
pub(crate) fn check_outer_power(k: u32) -> Result<(), Error> {
    if [2, 4, 8].contains(&k) {
        return Ok(());
    }
    Err(Error::input(format!("outer power k = {k} is not one of the method's"), "k is 2, 4 or 8"))
}

/// `base^k` by squarings, for k = 2, 4 or 8.
pub(crate) fn squarings(base: f64, k: u32) -> f64 {
    (0..k.trailing_zeros()).fold(base, |value, _| value * value)
}

impl Lobe for Lyon {
    fn at(&self, u: f64) -> f64 {
        squarings((1.0 - self.n * u / f64::from(self.k)).max(0.0), self.k)
    }
}
