//! The power from a table.

use super::Inputs;
use crate::fixed::wide::{self, Wide};
use crate::spec::CoreSpec;

/// The entry of the shininess and of the cell that the versine lies in; 0 at x = 0.
pub(super) fn tabulated(inputs: &Inputs, spec: &CoreSpec) -> Wide {
    if inputs.x == 0 {
        return Wide::ZERO;
    }
    let cell = wide::to_code(Wide::ONE - inputs.x, spec.table_bits) as usize;
    inputs.entry("power_table", (inputs.row << spec.table_bits) + cell, "y")
}
