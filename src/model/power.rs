//! The lobes that end in a power by squarings.

use super::Inputs;
use crate::fixed::wide::{self, Wide};
use crate::spec::{CoreSpec, Method, Shininess};

/// `p = u (A - a u)` in the scaled versine, or `None` where the lobe has ended.
fn inner(inputs: &Inputs) -> Option<Wide> {
    let u = Wide::ONE - inputs.x;
    let v = u << inputs.shift();
    let cut = inputs.optional("cut");
    // An inner line ends at its zero, before v = 2; a parabola at its threshold, or nowhere.
    if cut.is_some_and(|cut| u > cut) || (inputs.optional("a").is_none() && v >= 2) {
        return None;
    }
    let v = inputs.floor(v, "v");
    let slope = match inputs.optional("a") {
        Some(_) => inputs.coefficient("big_a") - inputs.floor(inputs.coefficient("a") * v, "A"),
        None => inputs.coefficient("big_a"),
    };
    Some(v * slope)
}

/// `1 - p`, or `None` from p = 1 on.
fn base(inputs: &Inputs, p: Wide) -> Option<Wide> {
    let p = inputs.floor(p, "p").max(Wide::ZERO);
    (p < 1).then(|| Wide::ONE - p)
}

/// `x (1 - K u)^2`.
pub(super) fn min_zero(inputs: &Inputs) -> Wide {
    let Some(base) = inner(inputs).and_then(|p| base(inputs, p)) else { return Wide::ZERO };
    let square = inputs.floor(inputs.power(base, 2), "s");
    inputs.floor(inputs.x, "x") * square + inputs.half_ulp
}

/// `(1 - u (A - a u))^k` with the ROM's coefficients.
pub(super) fn rom(inputs: &Inputs, method: Method) -> Wide {
    powered(inputs, inner(inputs), method)
}

/// `(1 - n u / k)^k`, with n from the port where that holds n itself.
pub(super) fn lyon(inputs: &Inputs, spec: &CoreSpec) -> Wide {
    let p = match spec.shininess {
        Shininess::Range(..) | Shininess::Fixed { .. } => {
            let log2_k = spec.method.power().map_or(0, u32::trailing_zeros);
            let n = wide::from_code(inputs.n.into(), spec.shininess.frac_bits());
            Some(((Wide::ONE - inputs.x) * n) >> log2_k)
        }
        _ => inner(inputs),
    };
    powered(inputs, p, spec.method)
}

fn powered(inputs: &Inputs, p: Option<Wide>, method: Method) -> Wide {
    let Some(base) = p.and_then(|p| base(inputs, p)) else { return Wide::ZERO };
    let power = inputs.power(base, method.power().unwrap_or(1));
    inputs.lit((power + inputs.half_ulp).min(Wide::ONE))
}
