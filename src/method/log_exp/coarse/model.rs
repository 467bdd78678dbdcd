//! The power `x^n` as `2^(-n L)` with an accuracy.

use super::super::model::{EXP, Function, LOG, interpolated};
use super::ONE;
use crate::fixed::wide::{self, Wide};
use crate::method::{Inputs, width};

const COARSE_LOG: Function = Function { domain: 0, ..LOG };

/// With an accuracy of A bits: `z = (n u) κ(x)` and `y = 2^-z`, both functions from their tables.
pub(in crate::method) fn evaluate(inputs: &Inputs, accuracy: u32) -> Wide {
    let n = inputs.shininess();
    let x = inputs.x;
    if x == 0 {
        return Wide::ZERO;
    }
    // The tables miss 1 by their error.
    if x == 1 && inputs.interface.monotone {
        return Wide::ONE;
    }
    if n == 1 && inputs.widths[ONE] == 1 {
        return wide::floor_to(x, inputs.interface.output_fraction);
    }
    let v = inputs.floor(n * inputs.floor(Wide::ONE - x, width::U), width::V);
    // From here on x^n is below 2^-(A + 1/2).
    let mut bound = 1u32;
    while f64::from(bound) * std::f64::consts::LOG2_E <= f64::from(accuracy) + 0.5 {
        bound *= 2;
    }
    if v >= bound {
        return Wide::ZERO;
    }
    // x = 1 has no entry; there u = 0.
    let ratio =
        if x == 1 { Wide::ZERO } else { interpolated(inputs, &COARSE_LOG, x, inputs.widths[width::K] as u32 + 2) };
    let z = inputs.floor(v * ratio, width::Z);
    if z >= (accuracy + 1).next_power_of_two() {
        return Wide::ZERO;
    }
    let power = interpolated(inputs, &EXP, z.frac(), 64) >> z.to_num::<u32>();
    wide::floor_to(inputs.floor(power, width::E), inputs.interface.output_fraction)
}
