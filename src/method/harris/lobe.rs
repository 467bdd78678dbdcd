//! The power from a table of logarithms, a multiplication and a table of the exponential.

use std::sync::Arc;

use crate::fixed::exp2;
use crate::lobe::Lobe;

/// `2^-z`, `z = n L(u)`, where L is constant in each cell of the versine and `2^-f` in each cell of the fraction f of
/// z.
///
/// After D. Harris, "An Exponentiation Unit for an OpenGL Lighting Engine" (IEEE Trans. Computers 53(3), 2004): a table
/// of logarithms that is partitioned into subintervals, a multiplier, and a table of the inverse logarithm. Here the
/// subintervals are the octaves of the versine, `[2^-e, 2^(1-e))`, since it is near x = 1 that a large shininess needs
/// the logarithm; each has equally many cells. Harris makes each subinterval a bipartite table, which takes less memory
/// and an adder; here it is a plain one.
#[derive(Clone, Debug, PartialEq)]
pub struct Harris {
    /// The shininess.
    pub n: f64,
    /// The number of octaves, from [1/2, 1) down; below them L is 0.
    pub octaves: usize,
    /// L of each cell: all octaves side by side, each in order of the versine.
    pub log: Arc<[f64]>,
    /// `2^-f` of equal cells over [0, 1).
    pub exp: Arc<[f64]>,
}

impl Harris {
    /// L of a cell that reaches from one versine below 1 to another: that of the cosine midway, so that x itself, which
    /// is the lobe for n = 1, has the same error at both ends.
    #[must_use]
    pub fn logarithm(first: f64, last: f64) -> f64 {
        -libm::log1p(-0.5 * (first + last)) * std::f64::consts::LOG2_E
    }

    /// The value for a cell that reaches from one fraction to another: midway between those at its ends.
    #[must_use]
    pub fn exponential(first: f64, last: f64) -> f64 {
        0.5 * (libm::exp2(-first) + libm::exp2(-last))
    }
}

impl Lobe for Harris {
    fn at(&self, u: f64) -> f64 {
        if u >= 1.0 {
            return 0.0;
        }
        let mut octave = 0;
        while octave < self.octaves && u * exp2(octave as i32) < 0.5 {
            octave += 1;
        }
        let z = if octave == self.octaves {
            0.0
        } else {
            let cells = self.log.len() / self.octaves;
            let cell = ((2.0 * u * exp2(octave as i32) - 1.0) * cells as f64) as usize;
            self.n * self.log[octave * cells + cell]
        };
        // Past this there is nothing that any output shows.
        if z >= 64.0 {
            return 0.0;
        }
        let whole = libm::floor(z);
        self.exp[((z - whole) * self.exp.len() as f64) as usize] * exp2(-(whole as i32))
    }
}
