//! The lobe `x / (1 + (n-1) u)`.

use crate::fixed::Table;
use crate::fixed::wide::{self, Wide};
use crate::method::divide::Divider;
use crate::method::divide::model as divide;
use crate::method::{Inputs, Shininess};

/// `den = 1 + (n-1) u`, `y = x / den`.
pub(in crate::method) fn schlick(inputs: &Inputs, divider: Divider) -> Wide {
    let set = &inputs.interface.shininess;
    let less_one = match set {
        Shininess::Range(..) | Shininess::Fixed { .. } => wide::from_code(inputs.n.into(), set.frac_bits()) - Wide::ONE,
        Shininess::List(_) | Shininess::Materials(_) => inputs.entry(Table::COEFFICIENTS, inputs.row, "n1"),
    };
    let u = inputs.floor(Wide::ONE - inputs.x, "u");
    let den = Wide::ONE + inputs.floor(less_one * u, "den");
    divide::rounded(inputs, divider, inputs.floor(inputs.x, "num"), den)
}
