//! Truncated Taylor series of the power, as the papers describe R. F. Lyon's method.

use crate::lobe::{Lobe, check_shininess};
use crate::platform::error::Error;

/// Which series of cos^n is truncated, and where.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TaylorSeries {
    /// Three terms in the angle, with the chord D in the angle's place, as the papers have it:
    /// `1 - n D^2/2 + n(3n-2) D^4/24 = 1 - n u + n(3n-2) u^2/6`.
    Chord,
    /// Three terms in the versine: `1 - n u + n(n-1) u^2/2`.
    Versine3,
    /// Four terms in the versine: `1 - n u + n(n-1) u^2/2 - n(n-1)(n-2) u^3/6`.
    Versine4,
}

/// A truncated Taylor series of x^n about x = 1. A comparator in software only.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Taylor {
    /// The shininess.
    pub n: f64,
    /// The series.
    pub series: TaylorSeries,
}

impl Taylor {
    /// The lobe for the shininess `n`.
    ///
    /// # Errors
    /// See [`check_shininess`].
    pub fn new(n: f64, series: TaylorSeries) -> Result<Self, Error> {
        check_shininess(n)?;
        Ok(Self { n, series })
    }

    /// The sum of the series, which leaves [0, 1] where it has ceased to be an approximation: at u = 1 it is of the
    /// order of `n^2/2`, or of `-n^3/6` with four terms.
    #[must_use]
    pub fn sum(&self, u: f64) -> f64 {
        let n = self.n;
        let (second, third) = match self.series {
            TaylorSeries::Chord => (n * (3.0 * n - 2.0) / 6.0, 0.0),
            TaylorSeries::Versine3 => (n * (n - 1.0) / 2.0, 0.0),
            TaylorSeries::Versine4 => (n * (n - 1.0) / 2.0, n * (n - 1.0) * (n - 2.0) / 6.0),
        };
        1.0 - u * (n - u * (second - u * third))
    }
}

impl Lobe for Taylor {
    /// [`Taylor::sum`] clamped to [0, 1]: 1 where three terms have risen past it, 0 where four have fallen below.
    fn at(&self, u: f64) -> f64 {
        self.sum(u).clamp(0.0, 1.0)
    }
}
