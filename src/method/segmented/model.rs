//! The lobe in segments.

use crate::fixed::wide::{self, Wide};
use crate::method::{Inputs, width};

/// Fraction bits of what finds the segment.
const ROUGH_BITS: u32 = 9;

/// `y = x (c - u (A - a u))` with the coefficients of the segment that a rough n u finds, rounded to nearest; 0 past
/// the last. `bounds` are the ends of the segments as codes of s.
pub(in crate::method) fn segmented(inputs: &Inputs) -> Wide {
    let bounds = inputs.constants;
    let u = Wide::ONE - inputs.x;
    let scale = inputs.memory("scale");
    let shift = scale.find("k").map_or(0, |field| field.codes[inputs.row]);
    let v = u << (shift as u32 + scale.shared_shift);
    if v >= 32 {
        return Wide::ZERO;
    }
    let s = wide::to_code(wide::floor_to(v, ROUGH_BITS) * inputs.entry("scale", inputs.row, "m"), ROUGH_BITS);
    let segment = bounds.iter().filter(|&&bound| s >= bound).count();
    if segment == bounds.len() {
        return Wide::ZERO;
    }
    let coefficient = |name: &str| inputs.entry("rom", inputs.row * bounds.len() + segment, name);
    let v = inputs.floor(v, width::V);
    let q = coefficient("big_a") - inputs.floor(coefficient("a") * v, width::BIG_A);
    let d = (coefficient("c") - inputs.floor(q * v, width::C)).max(Wide::ZERO);
    (inputs.floor(inputs.x, width::X) * d + inputs.half_ulp).min(Wide::ONE)
}
