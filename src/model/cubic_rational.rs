//! The cubic lobe with the rational tail `x / (d + b u)`.

use super::{Inputs, cubic, divide};
use crate::fixed::wide::Wide;

/// The cubic up to the last versine that is its own; past it `y = x / (d + b u)`.
pub(super) fn cubic_rational(inputs: &Inputs) -> Wide {
    let u = Wide::ONE - inputs.x;
    if u <= inputs.coefficient("cut") {
        return cubic::stable(inputs);
    }
    let den = inputs.coefficient("d") + inputs.floor(inputs.coefficient("b") * u, "den");
    divide::rounded(inputs, inputs.floor(inputs.x, "num"), den)
}
