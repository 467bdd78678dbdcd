//! The quadratic lobe `max(0, x (1 - a u))`.

use crate::fixed::wide::Wide;
use crate::method::{Inputs, width};

/// `v = u 2^k`, `p = (a 2^-k) v`, `y = x - x p`; 0 from `v = 2` or `p = 1` on.
pub(in crate::method) fn stable(inputs: &Inputs) -> Wide {
    let u = Wide::ONE - inputs.x;
    let v = u << inputs.shift();
    if v >= 2 {
        return Wide::ZERO;
    }
    let p = inputs.coefficient("a") * inputs.floor(v, width::V);
    if p >= 1 {
        return Wide::ZERO;
    }
    inputs.lobe(inputs.floor(p, width::P))
}

/// `y = x + a (x^2 - x)`, rounded to nearest and clamped to [0, 1].
pub(in crate::method) fn paper(inputs: &Inputs) -> Wide {
    let x = inputs.x;
    let square = inputs.floor(x * x, width::S);
    let product = inputs.floor(inputs.coefficient("a") * (square - x), width::M);
    (x + inputs.half_ulp + product).clamp(Wide::ZERO, Wide::ONE)
}
