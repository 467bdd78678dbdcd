//! What the blocks around and beside a lobe are built of.

use super::CHANNELS;
use crate::datapath::builder::{Builder, HighBits};
use crate::datapath::graph::NodeId;
use crate::fixed::Format;

/// The components of vectors in names.
pub(super) const AXES: [char; 3] = ['x', 'y', 'z'];

/// The outputs of a core that gives codes of channels.
pub(super) const CODES: [&str; 3] = ["out_r", "out_g", "out_b"];
/// The outputs of a core that takes lights in sequence.
pub(super) const SUMS: [&str; 3] = ["out_sum_r", "out_sum_g", "out_sum_b"];
/// The same of the ambient light.
pub(super) const AMBIENTS: [&str; 3] = ["out_ambient_r", "out_ambient_g", "out_ambient_b"];

/// A scalar product of vectors of two or three components: exact, or the sum of products that are rounded down to so
/// many fraction bits.
pub(super) fn dot(b: &mut Builder, a: &[NodeId], c: &[NodeId], bits: Option<i32>, name: &str, what: &str) -> NodeId {
    let components = a.iter().zip(c).zip(AXES);
    let product = |((&a, &c), axis): ((&NodeId, &NodeId), char)| match bits {
        None => b.mul(a, c, &format!("{name}_{axis}"), what),
        Some(bits) => {
            let product = b.mul(a, c, &format!("{name}_{axis}_exact"), what);
            b.floor(product, bits, &format!("{name}_{axis}"), "rounded down")
        }
    };
    let products: Vec<NodeId> = components.map(product).collect();
    let mut sum = products[0];
    for (&product, axes) in products[1..].iter().zip(["xy", "xyz"]) {
        sum = b.add(sum, product, &format!("{name}_{axes}"), what);
    }
    sum
}

/// What the lights of a clock give to a channel: a sum of so many fraction bits, kept at 1.0.
pub(super) fn channel_sum(b: &mut Builder, sum: NodeId, channel: usize, bits: i32) -> NodeId {
    let c = CHANNELS[channel];
    let int_bits = b.format(sum).int_bits;
    let format = Format::unsigned(int_bits.max(1), bits);
    let sum = b.cast(sum, format, HighBits::Unused, &format!("sum_wide_{c}"), "with all bits of a sum");
    // Without a bit before the point it is below 1.0.
    if int_bits < 1 { sum } else { b.clamp_to_unit(sum, &format!("sum_{c}"), "kept at 1.0") }
}

/// The nearest code of a channel to a sum in which full scale is the greatest code, `1 - 2^-bits`; at most full scale.
pub(super) fn channel_code(b: &mut Builder, sum: NodeId, channel: usize, bits: u32) -> NodeId {
    let (c, full) = (CHANNELS[channel], (1 << bits) - 1);
    let bits = bits as i32;
    let half = b.half_ulp(bits);
    let sum = b.add(sum, half, &format!("sum_half_{c}"), "plus half a code");
    let code = b.floor(sum, bits, &format!("cut_{c}"), "rounded to the nearest code");
    // A sum that rounds to full scale at most has no bits for more.
    let code = match b.format(code).max_code() > full {
        true => b.clamp(code, 0, full, &format!("kept_{c}"), "at most full scale"),
        false => code,
    };
    b.scale(code, None, bits, &[bits], &format!("code_{c}"), "as a whole number")
}
