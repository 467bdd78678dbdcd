//! The files that hold a ROM: written from a [`Table`], read back into a [`RomImage`], compared.

mod difference;
mod formats;
mod read;
mod source;
#[cfg(test)]
mod tests;
mod write;

pub use difference::{Difference, equal_words, first_difference};
pub use formats::RomFormat;
pub use read::read;
pub use write::write;

use num_bigint::BigUint;

use crate::spec::MAX_ROWS;

/// The most words that a ROM file may hold: as many as the largest table has.
pub const MAX_DEPTH: usize = MAX_ROWS.next_power_of_two();

/// What a ROM file holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RomImage {
    /// Every word, by address.
    pub words: Vec<BigUint>,
    /// Whose kind of the format it is, where there are several, such as "with Lattice's header".
    pub kind: Option<&'static str>,
    /// The width of a word, if the format states it.
    pub width: Option<u32>,
    /// The codes of each field by address, if the format has them beside the words: only a CSV file does.
    pub codes: Vec<(String, Vec<i128>)>,
}

/// The number of bytes that a word takes in the formats that hold whole bytes.
fn word_bytes(word_bits: u32) -> usize {
    word_bits.div_ceil(8).max(1) as usize
}

/// The number of hexadecimal digits of a word.
fn word_digits(word_bits: u32) -> usize {
    word_bits.div_ceil(4).max(1) as usize
}
