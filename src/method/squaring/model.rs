//! The power `x^n`, n a power of two, by repeated squaring.

use crate::fixed::wide::{self, Wide};
use crate::method::{Inputs, width};

/// `log2 n` squarings, each rounded down, the earlier the finer; rounded to nearest.
pub(in crate::method) fn squaring(inputs: &Inputs) -> Wide {
    let squarings = |n: f64| libm::ilogb(n) as u32;
    let (_, largest) = inputs.interface.shininess.ends();
    let (own, most) = (squarings(inputs.interface.shininess.value(inputs.row)), squarings(largest));
    let last_bits = inputs.widths[width::S] as u32;
    let power = (1..=own).fold(inputs.x, |power, level| wide::floor_to(power * power, last_bits + most - level));
    wide::floor_to(power, last_bits) + inputs.half_ulp
}
