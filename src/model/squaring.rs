//! The power `x^n`, n a power of two, by repeated squaring.

use super::Inputs;
use crate::fixed::wide::{self, Wide};
use crate::spec::CoreSpec;

/// `log2 n` squarings, each rounded down, the earlier the finer; rounded to nearest.
pub(super) fn squaring(inputs: &Inputs, spec: &CoreSpec) -> Wide {
    let squarings = |n: f64| libm::ilogb(n) as u32;
    let (_, largest) = spec.shininess.ends();
    let (own, most) = (squarings(spec.shininess.value(inputs.row)), squarings(largest));
    let last_bits = inputs.widths.get("s") as u32;
    let power = (1..=own).fold(inputs.x, |power, level| wide::floor_to(power * power, last_bits + most - level));
    wide::floor_to(power, last_bits) + inputs.half_ulp
}
