//! The lobes that end in a power by squarings.

use crate::fixed::wide::Wide;
use crate::method::{Inputs, width};

/// `p = u (A - a u)` in the scaled versine, or `None` where the lobe has ended.
fn inner(inputs: &Inputs) -> Option<Wide> {
    let u = Wide::ONE - inputs.x;
    let v = u << inputs.shift();
    let cut = inputs.optional("cut");
    // An inner line ends at its zero, before v = 2; a parabola at its threshold, or nowhere.
    if cut.is_some_and(|cut| u > cut) || (inputs.optional("a").is_none() && v >= 2) {
        return None;
    }
    let v = inputs.floor(v, width::V);
    let slope = match inputs.optional("a") {
        Some(_) => inputs.coefficient("big_a") - inputs.floor(inputs.coefficient("a") * v, width::BIG_A),
        None => inputs.coefficient("big_a"),
    };
    Some(v * slope)
}

/// `1 - p`, or `None` from p = 1 on.
fn base(inputs: &Inputs, p: Wide) -> Option<Wide> {
    let p = inputs.floor(p, width::P).max(Wide::ZERO);
    (p < 1).then(|| Wide::ONE - p)
}

/// `x (1 - K u)^2`.
pub(in crate::method) fn min_zero(inputs: &Inputs) -> Wide {
    let Some(base) = inner(inputs).and_then(|p| base(inputs, p)) else { return Wide::ZERO };
    let square = inputs.floor(inputs.power(base, 2), width::S);
    inputs.floor(inputs.x, width::X) * square + inputs.half_ulp
}

/// `(1 - u (A - a u))^k` with the ROM's coefficients.
pub(in crate::method) fn rom(inputs: &Inputs, power: u32) -> Wide {
    powered(inputs, inner(inputs), power)
}

/// `(1 - n u / k)^k`, with n from the port where that holds n itself.
pub(in crate::method) fn lyon(inputs: &Inputs, power: u32) -> Wide {
    let p = match inputs.port_shininess() {
        Some(n) => Some(((Wide::ONE - inputs.x) * n) >> power.trailing_zeros()),
        None => inner(inputs),
    };
    powered(inputs, p, power)
}

fn powered(inputs: &Inputs, p: Option<Wide>, power: u32) -> Wide {
    let Some(base) = p.and_then(|p| base(inputs, p)) else { return Wide::ZERO };
    let power = inputs.power(base, power);
    inputs.lit((power + inputs.half_ulp).min(Wide::ONE))
}
