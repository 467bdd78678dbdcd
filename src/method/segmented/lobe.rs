//! The lobe in segments, each a cubic of its own.

use crate::lobe::Lobe;
use crate::method::polynomial::Polynomial;

/// `x (c - u (A - a u))` with the coefficients of the first piece whose end is not passed, 0 past the last.
#[derive(Clone, Debug, PartialEq)]
pub struct Segmented {
    /// The pieces, by rising [`Polynomial::end`].
    pub pieces: Vec<Polynomial>,
}

impl Lobe for Segmented {
    fn at(&self, u: f64) -> f64 {
        self.pieces.iter().find(|piece| u <= piece.end).map_or(0.0, |piece| piece.at(u))
    }
}
