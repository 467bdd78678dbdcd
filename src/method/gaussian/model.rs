//! The spherical Gaussian, as `2^-z` with `z = n u log2 e`.

use crate::fixed::exp2;
use crate::fixed::wide::{self, Wide};
use crate::method::log_exp::model::{limits, rounded_power};
use crate::method::{Inputs, width};

/// `v = n u`, `z = v log2 e`, `y = 2^-z`.
pub(super) fn gaussian(inputs: &Inputs) -> Wide {
    if inputs.x == 0 {
        return Wide::ZERO;
    }
    let v = inputs.floor(inputs.shininess() * inputs.floor(Wide::ONE - inputs.x, width::U), width::V);
    let [bound, _] = limits(inputs.interface.output_fraction);
    if v >= bound {
        return Wide::ZERO;
    }
    let bits = inputs.widths[width::K];
    let log2_e = wide::from_code(libm::rint(std::f64::consts::LOG2_E * exp2(bits)) as i128, bits as u32);
    rounded_power(inputs, inputs.floor(v * log2_e, width::Z))
}
