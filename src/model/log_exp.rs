//! The power `x^n` as `2^(-n L)`, `L = -log2 x`.

use super::Inputs;
use crate::fixed::wide::{self, Wide};
use crate::spec::{CoreSpec, Shininess};

/// With an accuracy of A bits: `z = (n u) κ(x)` and `y = 2^-z`, both functions from their tables.
pub(super) fn coarse(inputs: &Inputs, spec: &CoreSpec, accuracy: u32) -> Wide {
    let n = shininess(inputs, spec);
    let x = inputs.x;
    if x == 0 {
        return Wide::ZERO;
    }
    if n == 1 && inputs.widths.get("one") == 1 {
        return wide::floor_to(x, spec.output_fraction);
    }
    let v = inputs.floor(n * inputs.floor(Wide::ONE - x, "u"), "v");
    // From here on x^n is below 2^-(A + 1/2).
    let mut bound = 1u32;
    while f64::from(bound) * std::f64::consts::LOG2_E <= f64::from(accuracy) + 0.5 {
        bound *= 2;
    }
    if v >= bound {
        return Wide::ZERO;
    }
    // x = 1 has no entry; there u = 0.
    let ratio =
        if x == 1 { Wide::ZERO } else { interpolated(inputs, &COARSE_LOG, x, inputs.widths.get("k") as u32 + 2) };
    let z = inputs.floor(v * ratio, "z");
    if z >= (accuracy + 1).next_power_of_two() {
        return Wide::ZERO;
    }
    let power = interpolated(inputs, &EXP, z.frac(), 64) >> z.to_num::<u32>();
    wide::floor_to(inputs.floor(power, "e"), spec.output_fraction)
}

/// n: the port's, or the ROM's.
fn shininess(inputs: &Inputs, spec: &CoreSpec) -> Wide {
    match spec.shininess {
        Shininess::Range(..) | Shininess::Fixed { .. } => wide::from_code(inputs.n.into(), spec.shininess.frac_bits()),
        Shininess::List(_) | Shininess::Materials(_) => inputs.coefficient("n"),
    }
}

/// x is taken apart into `2^-e m`; then `z = n e + n (1 - m) κ(m)` and `y = 2^-z`, both functions from their tables.
pub(super) fn evaluate(inputs: &Inputs, spec: &CoreSpec) -> Wide {
    let output_fraction = spec.output_fraction;
    let (least, _) = spec.shininess.ends();
    let n = shininess(inputs, spec);
    let x = inputs.x;
    let half = Wide::ONE >> 1;
    if n == 1 && inputs.fine_input {
        return wide::floor_to(x + inputs.half_ulp, output_fraction);
    }
    // From z = G + 1 on the power is half an ulp at most; so it is below this cosine, even for the least shininess.
    let negligible = f64::from(output_fraction + 1);
    let octaves = (negligible / least).ceil() as u32;
    if x == 0 || (octaves < 64 && x < Wide::ONE >> octaves) {
        return Wide::ZERO;
    }
    let (mut m, mut e) = (x, 0u32);
    while m < half {
        m <<= 1;
        e += 1;
    }
    let v = inputs.floor(n * inputs.floor(Wide::ONE - m, "u"), "v");
    let mut bound = 1u32;
    while f64::from(bound) * std::f64::consts::LOG2_E < negligible {
        bound *= 2;
    }
    let limit = (output_fraction + 1).next_power_of_two();
    if v >= bound {
        return Wide::ZERO;
    }
    let product =
        if m == 1 { Wide::ZERO } else { v * interpolated(inputs, &LOG, m - half, inputs.widths.get("k") as u32 + 1) };
    let steps = n.min(Wide::from_num(limit)) * Wide::from_num(e);
    let z = inputs.floor(steps + inputs.floor(product, "z"), "z");
    if z >= limit {
        return Wide::ZERO;
    }
    let power = interpolated(inputs, &EXP, z.frac(), 64) >> z.to_num::<u32>();
    wide::floor_to(inputs.floor(power, "e") + inputs.half_ulp, output_fraction)
}

/// A function table: its memory and the fields of it, the names of its widths, and the span of its arguments, `2^-domain`.
struct Function {
    memory: &'static str,
    base: &'static str,
    slope: &'static str,
    address: &'static str,
    value: &'static str,
    domain: u32,
}

const LOG: Function =
    Function { memory: "log_table", base: "log_base", slope: "log_slope", address: "log", value: "k", domain: 1 };
const COARSE_LOG: Function = Function { domain: 0, ..LOG };
const EXP: Function =
    Function { memory: "exp_table", base: "exp_base", slope: "exp_slope", address: "exp", value: "e", domain: 0 };

/// A function at `argument`, counted from where its arguments start: the entry's base less its slope times the distance from the entry's
/// start, that distance rounded down to `cut` bits and the product to the value's width.
fn interpolated(inputs: &Inputs, of: &Function, argument: Wide, cut: u32) -> Wide {
    let address_bits = inputs.widths.get(of.address) as u32;
    let entry = wide::to_code(argument << of.domain, address_bits);
    let distance = argument - (wide::from_code(entry, address_bits) >> of.domain);
    let word = |field: &str| inputs.entry(of.memory, entry as usize, field);
    let has_slope = inputs.memory(of.memory).find(of.slope).is_some();
    let slope = if has_slope { word(of.slope) } else { Wide::ZERO };
    word(of.base) - inputs.floor(slope * wide::floor_to(distance, cut), of.value)
}
