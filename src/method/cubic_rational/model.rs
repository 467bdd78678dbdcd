//! The cubic lobe with the rational tail `x / (d + b u)`.

use crate::fixed::wide::Wide;
use crate::method::cubic::model as cubic;
use crate::method::divide::Divider;
use crate::method::divide::model as divide;
use crate::method::{Inputs, width};

/// The cubic up to the last versine that is its own; past it `y = x / (d + b u)`.
pub(in crate::method) fn cubic_rational(inputs: &Inputs, divider: Divider) -> Wide {
    let u = Wide::ONE - inputs.x;
    if u <= inputs.coefficient("cut") {
        return cubic::stable(inputs);
    }
    let den = inputs.coefficient("d") + inputs.floor(inputs.coefficient("b") * u, width::DEN);
    divide::rounded(inputs, divider, inputs.floor(inputs.x, width::NUM), den)
}
