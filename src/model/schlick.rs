//! The lobe `x / (1 + (n-1) u)`.

use super::{Inputs, divide};
use crate::fixed::wide::{self, Wide};
use crate::emit::rom::Table;
use crate::spec::Shininess;

/// `den = 1 + (n-1) u`, `y = x / den`.
pub(super) fn schlick(inputs: &Inputs) -> Wide {
    let set = &inputs.spec.shininess;
    let less_one = match set {
        Shininess::Range(..) | Shininess::Fixed { .. } => wide::from_code(inputs.n.into(), set.frac_bits()) - Wide::ONE,
        Shininess::List(_) | Shininess::Materials(_) => inputs.entry(Table::COEFFICIENTS, inputs.row, "n1"),
    };
    let u = inputs.floor(Wide::ONE - inputs.x, "u");
    let den = Wide::ONE + inputs.floor(less_one * u, "den");
    divide::rounded(inputs, inputs.floor(inputs.x, "num"), den)
}
