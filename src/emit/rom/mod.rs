//! Quantised coefficient tables and the files that hold them.

mod files;

pub use files::{Difference, MAX_DEPTH, RomFormat, RomImage, equal_words, first_difference, read, write};

use crate::fixed::Table;

/// The name that the files of a core's memory go by: the core's own for the coefficients.
#[must_use]
pub fn memory_name(core: &str, table: &Table) -> String {
    if table.name == Table::COEFFICIENTS { core.to_owned() } else { format!("{core}_{}", table.name) }
}
