//! Normalising: leading zeros counted and shifted out, a power of two at a time.

use super::builder::{Bound, Builder, HighBits};
use super::graph::NodeId;
use crate::fixed::{Interval, exp2};

/// A normalised value.
#[derive(Clone, Debug)]
pub struct Normalised {
    /// The value, shifted to the left.
    pub value: NodeId,
    /// The steps, the largest shift first: by how many bits, and a flag that is 0 where the step was taken. The shift
    /// is the sum of the steps taken.
    pub steps: Vec<(i32, NodeId)>,
}

impl Builder<'_> {
    /// `a`, not negative and below `2^(weight + 1)` or an exact `2^(weight + 1)`, shifted to the left until it is at
    /// least `2^weight`, by `most` bits or the next number of the form `2^k - 1`.
    ///
    /// The bounds take the result for at least `2^weight`: the caller flags an `a` below `2^(weight - most)`.
    pub fn normalise(&mut self, a: NodeId, weight: i32, most: i32, name: &str) -> Normalised {
        let format = self.format(a);
        let mut value = a;
        let mut steps = Vec::new();
        for power in (0..i32::BITS - most.leading_zeros()).rev() {
            let shift = 1 << power;
            let flag = format!("{name}_above_{shift}");
            let comment = format!("a bit of weight 2^{} or more is set", weight - shift + 1);
            let Some(above) = self.reaches(value, weight - shift + 1, &flag, &comment) else { continue };
            let count = self.cases().len();
            let moved = self.scale(value, None, shift, &vec![shift; count], &format!("{name}_by_{shift}"), "shifted");
            let moved =
                self.cast(moved, format, HighBits::Guarded, &format!("{name}_moved_{shift}"), "the high bits are 0");
            let comment = format!("shifted to the left by {shift} where that loses no bit");
            value = self.select(above, [value, moved], |_| None, &format!("{name}_{shift}"), &comment);
            steps.push((shift, above));
        }
        if !steps.is_empty() {
            let low = exp2(weight);
            let bounds: Vec<Bound> = self.bounds(value).to_vec();
            let normal = |bound: Bound| Bound {
                range: Interval::new(low, bound.range.high.clamp(low, exp2(weight + 1))),
                ..bound
            };
            self.assume(value, bounds.into_iter().map(normal).collect());
        }
        Normalised { value, steps }
    }
}
