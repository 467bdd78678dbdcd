//! The quotient of two numbers.

use crate::fixed::wide::{self, Wide};
use crate::method::divide::{Divider, INDEX, R};
use crate::method::{Inputs, width};

/// `num / den` for `den >= 1`, plus half an output ulp: rounding that down is rounding the quotient to nearest.
pub(in crate::method) fn rounded(inputs: &Inputs, divider: Divider, num: Wide, den: Wide) -> Wide {
    let quotient = match divider {
        Divider::Digit => num / den,
        Divider::Reciprocal => {
            let exponent = den.int_log2() as u32;
            (num * reciprocal(inputs, den >> exponent)) >> exponent
        }
    };
    wide::floor_to(quotient, inputs.interface.output_fraction + 1) + inputs.half_ulp
}

/// `1/m` for m in [1, 2), as the table and its slopes give it.
fn reciprocal(inputs: &Inputs, m: Wide) -> Wide {
    let fraction = inputs.floor(m, width::M) - Wide::ONE;
    let start = inputs.floor(fraction, INDEX);
    let entry = (start << inputs.widths[INDEX] as u32).to_num::<usize>();
    let fall = inputs.entry("reciprocal", entry, "slope") * (fraction - start);
    inputs.entry("reciprocal", entry, "seed") - inputs.floor(fall, R)
}
