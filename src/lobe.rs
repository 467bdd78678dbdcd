//! The lobe itself, x^n, as a real number, and what its approximations have in common.
//!
//! Everything is a function of the versine `u = 1 - x` of the cosine `x`, because near the highlight `u` is the small
//! quantity that keeps its precision. Nothing here knows of bits. The elementary functions come from the crate `libm`,
//! which is plain IEEE arithmetic: the same coefficients, and so the same ROM words, on every machine.

use crate::platform::error::Error;

/// The largest shininess that brdfgen takes.
pub const MAX_SHININESS: f64 = 1_048_576.0;

/// `x^n` at the versine `u = 1 - x` in [0, 1], for `n > 0`.
///
/// Relative error below `(2 + n |ln x|) * 2^-52`, by the conditioning of the exponential.
#[must_use]
pub fn exact(n: f64, u: f64) -> f64 {
    if u >= 1.0 { 0.0 } else { libm::exp(n * libm::log1p(-u)) }
}

/// The angle of a versine in [0, 1], in degrees.
#[must_use]
pub fn degrees(u: f64) -> f64 {
    (2.0 * libm::asin(libm::sqrt(0.5 * u))).to_degrees()
}

/// The versine of an angle in degrees.
#[must_use]
pub fn versine(degrees: f64) -> f64 {
    let half = libm::sin(0.5 * degrees.to_radians());
    2.0 * half * half
}

/// A method's real-valued lobe for one shininess.
pub trait Lobe: std::fmt::Debug + Send + Sync {
    /// The value in [0, 1] at the versine `u` in [0, 1].
    fn at(&self, u: f64) -> f64;
}

/// Refuses a shininess outside 1..=[`MAX_SHININESS`].
///
/// # Errors
/// Says what was given and what is allowed. Below 1 the power x^n has no inflection in (0, 1), so that
/// the quadratic's coefficient is not defined, and it is concave, so that there is no highlight.
pub fn check_shininess(n: f64) -> Result<(), Error> {
    if (1.0..=MAX_SHININESS).contains(&n) {
        return Ok(());
    }
    Err(Error::input(
        format!("shininess {n} is out of range"),
        format!("a shininess is a real number from 1 to {MAX_SHININESS}; below 1 the lobe has no inflection to fit"),
    ))
}
