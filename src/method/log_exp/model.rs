//! The power `x^n` as `2^(-n L)`, `L = -log2 x`.

use super::{EXP_ADDRESS, LOG_ADDRESS};
use crate::fixed::Width;
use crate::fixed::wide::{self, Wide};
use crate::method::{Inputs, width};

/// x is taken apart into `2^-e m`; then `z = n e + n (1 - m) κ(m)` and `y = 2^-z`, both functions from their tables.
pub(in crate::method) fn evaluate(inputs: &Inputs) -> Wide {
    let output_fraction = inputs.interface.output_fraction;
    let (least, _) = inputs.interface.shininess.ends();
    let n = inputs.shininess();
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
    let v = inputs.floor(n * inputs.floor(Wide::ONE - m, width::U), width::V);
    let [bound, limit] = limits(output_fraction);
    if v >= bound {
        return Wide::ZERO;
    }
    let product =
        if m == 1 { Wide::ZERO } else { v * interpolated(inputs, &LOG, m - half, inputs.widths[width::K] as u32 + 1) };
    let steps = n.min(Wide::from_num(limit)) * Wide::from_num(e);
    let z = inputs.floor(steps + inputs.floor(product, width::Z), width::Z);
    rounded_power(inputs, z)
}

/// Powers of two from which on v and z, `z >= v log2 e`, give a result of half an ulp at most: z is G + 1 there at
/// least.
pub(in crate::method) fn limits(output_fraction: u32) -> [u32; 2] {
    let mut v = 1u32;
    while f64::from(v) * std::f64::consts::LOG2_E < f64::from(output_fraction + 1) {
        v *= 2;
    }
    [v, (output_fraction + 1).next_power_of_two()]
}

/// `2^-z` rounded to nearest, 0 from the limit of z on: the fraction of z through the table, its integer part a shift.
pub(in crate::method) fn rounded_power(inputs: &Inputs, z: Wide) -> Wide {
    let output_fraction = inputs.interface.output_fraction;
    let [_, limit] = limits(output_fraction);
    if z >= limit {
        return Wide::ZERO;
    }
    let power = interpolated(inputs, &EXP, z.frac(), 64) >> z.to_num::<u32>();
    wide::floor_to(inputs.floor(power, width::E) + inputs.half_ulp, output_fraction)
}

/// A function table: its memory, the fields of it, base and slope, its widths, address and value, and the span of its
/// arguments, `2^-domain`.
pub(super) struct Function {
    pub(super) memory: &'static str,
    pub(super) fields: [&'static str; 2],
    pub(super) widths: [Width; 2],
    pub(super) domain: u32,
}

pub(super) const LOG: Function =
    Function { memory: "log_table", fields: ["log_base", "log_slope"], widths: [LOG_ADDRESS, width::K], domain: 1 };
pub(super) const EXP: Function =
    Function { memory: "exp_table", fields: ["exp_base", "exp_slope"], widths: [EXP_ADDRESS, width::E], domain: 0 };

/// A function at `argument`, counted from where its arguments start: the entry's base less its slope times the distance
/// from the entry's start, that distance rounded down to `cut` bits and the product to the value's width.
pub(super) fn interpolated(inputs: &Inputs, of: &Function, argument: Wide, cut: u32) -> Wide {
    let ([base, slope], [address, value]) = (of.fields, of.widths);
    let address_bits = inputs.widths[address] as u32;
    let entry = wide::to_code(argument << of.domain, address_bits);
    let distance = argument - (wide::from_code(entry, address_bits) >> of.domain);
    let word = |field: &str| inputs.entry(of.memory, entry as usize, field);
    let has_slope = inputs.memory(of.memory).find(slope).is_some();
    let slope = if has_slope { word(slope) } else { Wide::ZERO };
    word(base) - inputs.floor(slope * wide::floor_to(distance, cut), value)
}
