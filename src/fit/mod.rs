//! Minimax coefficients: for one shininess n, the coefficients of a lobe's shape that make its largest error against
//! x^n as small as the shape allows.
//!
//! All coefficients are real numbers here. Their rounding to ROM words belongs to whoever knows the formats.
//!
//! The papers take their coefficients from interpolation (see [`crate::lobe`]). Here the largest error itself is
//! minimised, by the sequence of linear programs of K. Madsen, "An algorithm for minimax solution of overdetermined
//! systems of non-linear equations", J. Inst. Maths Applics 16 (1975), which near the optimum is Remez' exchange with
//! Newton's rate: see the module `minimax`. All shapes but the segments are one family, `x^e ((1 - u (A - a u))⁺)^k`,
//! which is left where it would rise again. The problem has several local minima, so the descent starts from several
//! interpolations.

mod family;
mod minimax;
mod segments;
mod target;

pub use family::{Family, Inside, Power, best};
pub use segments::{Constraint, Segment, fit_segment, segment_bounds, segment_end};
pub use target::Objective;

/// Coefficients and how good they are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit<T> {
    /// The coefficients.
    pub coefficients: T,
    /// The value of the objective that they reach, true to at least 4 digits (where it is above 1e-12): 0.01 is 1 %.
    pub error: f64,
}

impl<T> Fit<T> {
    /// The same with other coefficients made of these.
    pub fn map<U>(self, of: impl FnOnce(T) -> U) -> Fit<U> {
        Fit { coefficients: of(self.coefficients), error: self.error }
    }
}
