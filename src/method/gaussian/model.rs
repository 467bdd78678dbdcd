//! The spherical Gaussian, as `2^-z` with `z = n u log2 e`.

use crate::fixed::exp2;
use crate::fixed::wide::{self, Wide};
use crate::method::log_exp::model::{EXP, interpolated};
use crate::method::{Inputs, width};

/// `v = n u`, `z = v log2 e`, `y = 2^-z`: the fraction of z through the table, its integer part a shift; rounded to
/// nearest.
pub(super) fn gaussian(inputs: &Inputs) -> Wide {
    let output_fraction = inputs.interface.output_fraction;
    if inputs.x == 0 {
        return Wide::ZERO;
    }
    let v = inputs.floor(inputs.shininess() * inputs.floor(Wide::ONE - inputs.x, width::U), width::V);
    // From z = G + 1 on the result is half an ulp at most: certainly from this v on, and from this z on.
    let negligible = f64::from(output_fraction + 1);
    let mut bound = 1u32;
    while f64::from(bound) * std::f64::consts::LOG2_E < negligible {
        bound *= 2;
    }
    if v >= bound {
        return Wide::ZERO;
    }
    let bits = inputs.widths[width::K];
    let log2_e = wide::from_code(libm::rint(std::f64::consts::LOG2_E * exp2(bits)) as i128, bits as u32);
    let z = inputs.floor(v * log2_e, width::Z);
    if z >= (output_fraction + 1).next_power_of_two() {
        return Wide::ZERO;
    }
    let power = interpolated(inputs, &EXP, z.frac(), 64) >> z.to_num::<u32>();
    wide::floor_to(inputs.floor(power, width::E) + inputs.half_ulp, output_fraction)
}
