//! The power from a table.

use crate::fixed::wide::{self, Wide};
use crate::method::Inputs;

/// The entry of the shininess and of the cell that the versine lies in; 0 at x = 0.
pub(in crate::method) fn tabulated(inputs: &Inputs, table_bits: u32) -> Wide {
    if inputs.x == 0 {
        return Wide::ZERO;
    }
    let cell = wide::to_code(Wide::ONE - inputs.x, table_bits) as usize;
    inputs.entry("power_table", (inputs.row << table_bits) + cell, "y")
}
