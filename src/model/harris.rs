//! The power as `2^(-n L)` from two tables.

use super::Inputs;
use crate::fixed::wide::{self, Wide};
use crate::spec::{CoreSpec, Shininess};

/// `z = n L`, L from its cell; `y = 2^-z`, the fraction's part from its cell and the rest a shift, which rounds down; rounded to nearest.
pub(super) fn harris(inputs: &Inputs, spec: &CoreSpec) -> Wide {
    let n = match spec.shininess {
        Shininess::Range(..) | Shininess::Fixed { .. } => wide::from_code(inputs.n.into(), spec.shininess.frac_bits()),
        Shininess::List(_) | Shininess::Materials(_) => inputs.coefficient("n"),
    };
    let u = Wide::ONE - inputs.x;
    if u == 1 {
        return Wide::ZERO;
    }
    let cells = 1usize << spec.log_bits;
    let octaves = inputs.memory("log_table").rows() / cells;
    let log = (0..octaves).find(|&octave| (u << octave as u32) >= Wide::ONE >> 1).map_or(Wide::ZERO, |octave| {
        let within = (u << (octave as u32 + 1)) - Wide::ONE;
        inputs.entry("log_table", octave * cells + wide::to_code(within, spec.log_bits) as usize, "log")
    });
    let z = n * log;
    if z >= (spec.output_fraction + 1).next_power_of_two() {
        return Wide::ZERO;
    }
    let power = inputs.entry("exp_table", wide::to_code(z.frac(), spec.exp_bits) as usize, "exp");
    inputs.floor(power >> z.to_num::<u32>(), "e") + inputs.half_ulp
}
