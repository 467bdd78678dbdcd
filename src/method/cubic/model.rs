//! The cubic lobe `x (1 - u (A - a u))` up to its cut.

use super::H;
use crate::fixed::wide::Wide;
use crate::method::{Inputs, width};

/// `v = u 2^k`, `q = A 2^-k - (a 4^-k) v`, `p = v q`, `y = x - x p`; 0 past the cut or from `p = 1` on.
pub(in crate::method) fn stable(inputs: &Inputs) -> Wide {
    let u = Wide::ONE - inputs.x;
    if past_cut(inputs, u) {
        return inputs.lit(inputs.optional("hold").unwrap_or(Wide::ZERO));
    }
    let v = inputs.floor(u << inputs.shift(), width::V);
    let q = inputs.coefficient("big_a") - inputs.floor(inputs.coefficient("a") * v, width::BIG_A);
    let p = v * q;
    if p >= 1 {
        return Wide::ZERO;
    }
    inputs.lobe(inputs.floor(p, width::P))
}

/// `y = a x^3 + b x^2 + c x`, rounded to nearest and clamped to [0, 1]; 0 past the cut.
pub(in crate::method) fn paper(inputs: &Inputs) -> Wide {
    let x = inputs.x;
    if past_cut(inputs, Wide::ONE - x) {
        return Wide::ZERO;
    }
    let square = inputs.floor(x * x, width::S);
    let cube = inputs.floor(square * x, H);
    let term = |name: &str, power: Wide| inputs.floor(inputs.coefficient(name) * power, width::M);
    (term("a", cube) + term("b", square) + term("c", x) + inputs.half_ulp).clamp(Wide::ZERO, Wide::ONE)
}

fn past_cut(inputs: &Inputs, u: Wide) -> bool {
    inputs.optional("cut").is_some_and(|cut| u > cut)
}
