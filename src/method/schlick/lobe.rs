//! The lobe x/(n - n x + x) of C. Schlick, "A Fast Alternative to Phong's Specular Model", Graphics Gems IV, 1994.

use crate::lobe::{Lobe, check_shininess};
use crate::platform::error::Error;

/// `x / (1 + (n-1) u)`, `u = 1 - x`: Schlick's `x / (n - n x + x)`, with the denominator as a sum of positive terms.
///
/// It has the power's value and slope at x = 1 and no coefficient but n. All three papers compare themselves with it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Schlick {
    /// The shininess.
    pub n: f64,
}

impl Schlick {
    /// The lobe for the shininess `n`.
    ///
    /// # Errors
    /// See [`check_shininess`].
    pub fn new(n: f64) -> Result<Self, Error> {
        check_shininess(n)?;
        Ok(Self { n })
    }
}

impl Lobe for Schlick {
    fn at(&self, u: f64) -> f64 {
        (1.0 - u) / (1.0 + (self.n - 1.0) * u)
    }
}
