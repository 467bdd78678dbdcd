//! The power as `2^(-n L)` from two tables.

use crate::fixed::wide::{self, Wide};
use crate::method::{Inputs, width};

/// `z = n L`, L from its cell; `y = 2^-z`, the fraction's part from its cell and the rest a shift, which rounds down;
/// rounded to nearest.
pub(in crate::method) fn harris(inputs: &Inputs, log_bits: u32, exp_bits: u32) -> Wide {
    let n = inputs.shininess();
    let u = Wide::ONE - inputs.x;
    if u == 1 {
        return Wide::ZERO;
    }
    let cells = 1usize << log_bits;
    let octaves = inputs.memory("log_table").rows() / cells;
    let log = (0..octaves).find(|&octave| (u << octave as u32) >= Wide::ONE >> 1).map_or(Wide::ZERO, |octave| {
        let within = (u << (octave as u32 + 1)) - Wide::ONE;
        inputs.entry("log_table", octave * cells + wide::to_code(within, log_bits) as usize, "log")
    });
    let z = n * log;
    if z >= (inputs.interface.output_fraction + 1).next_power_of_two() {
        return Wide::ZERO;
    }
    let power = inputs.entry("exp_table", wide::to_code(z.frac(), exp_bits) as usize, "exp");
    inputs.floor(power >> z.to_num::<u32>(), width::E) + inputs.half_ulp
}
