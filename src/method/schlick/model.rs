//! The lobe `x / (1 + (n-1) u)`.

use crate::fixed::Table;
use crate::fixed::wide::Wide;
use crate::method::divide::Divider;
use crate::method::divide::model as divide;
use crate::method::{Inputs, width};

/// `den = 1 + (n-1) u`, `y = x / den`.
pub(in crate::method) fn schlick(inputs: &Inputs, divider: Divider) -> Wide {
    let listed = || inputs.entry(Table::COEFFICIENTS, inputs.row, "n1");
    let less_one = inputs.port_shininess().map_or_else(listed, |n| n - Wide::ONE);
    let u = inputs.floor(Wide::ONE - inputs.x, width::U);
    let den = Wide::ONE + inputs.floor(less_one * u, width::DEN);
    divide::rounded(inputs, divider, inputs.floor(inputs.x, width::NUM), den)
}
