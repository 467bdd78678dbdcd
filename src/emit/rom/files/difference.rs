//! The comparison of a file with the table that it should hold.

use std::fmt;

use num_bigint::BigUint;

use super::{RomImage, word_digits};
use crate::fixed::Table;

/// The first place where a file is not what the table says.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// The address of the word.
    pub address: usize,
    /// What the address serves, such as a shininess; none beyond the table's end.
    pub key: Option<(&'static str, f64)>,
    /// The table's word; none beyond its end.
    pub expected: Option<BigUint>,
    /// The file's word; none beyond its end.
    pub found: Option<BigUint>,
    /// The first field that differs, most significant first; none if only one side has the word.
    pub field: Option<&'static str>,
    /// The code of that field in the table and in the file.
    pub codes: Option<(i128, i128)>,
    /// The width of a word, for printing it.
    word_bits: u32,
}

/// The first address at which the file and the table differ, if any: in the word, in a code that the file has
/// beside it, or because only one of the two has a word there.
#[must_use]
pub fn first_difference(table: &Table, image: &RomImage) -> Option<Difference> {
    (0..table.depth().max(image.words.len())).find_map(|address| difference_at(table, image, address))
}

/// How many addresses have the same word in the file and in the table.
#[must_use]
pub fn equal_words(table: &Table, image: &RomImage) -> usize {
    let depth = table.depth().min(image.words.len());
    (0..depth).filter(|&address| table.word(address) == image.words[address]).count()
}

fn difference_at(table: &Table, image: &RomImage, address: usize) -> Option<Difference> {
    let row = (address < table.depth()).then(|| table.row_of_address(address));
    let mut difference = Difference {
        address,
        key: row.map(|row| (table.key, table.keys[row])),
        expected: row.map(|_| table.word(address)),
        found: image.words.get(address).cloned(),
        field: None,
        codes: None,
        word_bits: table.word_bits(),
    };
    if let (Some(row), Some(found)) = (row, &difference.found) {
        let same_word = difference.expected.as_ref() == Some(found);
        let differing = table.fields.iter().enumerate().find_map(|(position, field)| {
            let expected = field.format.wrap(field.codes[row]);
            let found = if same_word {
                let (_, codes) = image.codes.iter().find(|(name, _)| name == field.name)?;
                *codes.get(address)?
            } else {
                field.format.wrap(low_bits(&(found >> table.field_low_bit(position)), field.format.width()))
            };
            (found != expected).then_some((field.name, (expected, found)))
        });
        (difference.field, difference.codes) = differing.unzip();
        if same_word && differing.is_none() {
            return None;
        }
    }
    Some(difference)
}

/// The last `bits` bits of a word, as a code to be wrapped; `bits` is at most 127.
fn low_bits(word: &BigUint, bits: u32) -> i128 {
    let low =
        word.iter_u64_digits().take(2).enumerate().fold(0u128, |low, (i, digit)| low | u128::from(digit) << (64 * i));
    (low & ((1 << bits) - 1)) as i128
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = word_digits(self.word_bits);
        write!(f, "address {}", self.address)?;
        if let Some((key, value)) = self.key {
            write!(f, " ({key} {value})")?;
        }
        match (&self.expected, &self.found) {
            (Some(expected), Some(found)) if expected == found => {
                write!(f, ": the word 0x{found:0digits$x} is right")?;
            }
            (Some(expected), Some(found)) => {
                write!(f, ": the word is 0x{found:0digits$x} and should be 0x{expected:0digits$x}")?;
            }
            (Some(expected), None) => write!(f, ": the file ends before this word, 0x{expected:0digits$x}")?,
            (None, Some(found)) => {
                write!(f, ": the file has the word 0x{found:0digits$x} beyond the last address, {}", self.address - 1)?;
            }
            (None, None) => {}
        }
        match (self.field, self.codes) {
            (Some(field), Some((expected, found))) if self.expected == self.found => {
                write!(f, " but the column {field}_code beside it has {found} in place of {expected}")
            }
            (Some(field), Some((expected, found))) => {
                write!(f, "; the first field that differs is {field}, with the code {found} in place of {expected}")
            }
            _ => Ok(()),
        }
    }
}
