//! What the writers share: the heading of formats with comments, and the words as digits and as bytes.

use std::fmt::Write as _;

use num_bigint::BigUint;

use super::{Field, Table};

/// Writes one formatted line to a string.
macro_rules! line {
    ($text:expr, $($argument:tt)*) => {
        writeln!($text, $($argument)*).expect("a string takes all text")
    };
}
pub(super) use line;

/// What is written.
pub(super) struct Writing<'a> {
    /// The memory.
    pub table: &'a Table,
    /// The name that the file's own names begin with.
    pub core: &'a str,
    /// The digest of the spec.
    pub digest: &'a str,
    /// The command that makes the file.
    pub command: &'a str,
}

impl Writing<'_> {
    /// The heading, each line behind `comment`, and the text below it.
    pub fn headed(&self, comment: &str, what: &str, text: &str) -> Vec<u8> {
        let table = self.table;
        let mut heading = String::new();
        let word_bits = table.word_bits();
        line!(heading, "{comment} ROM of the core {}: {what}.", printable(self.core));
        // Quoted, so that no command can end the line in a backslash, which would continue a C comment.
        line!(heading, "{comment} Made by `{}`.", printable(self.command));
        line!(heading, "{comment} spec {}", printable(self.digest));
        line!(
            heading,
            "{comment} {} words of {word_bits} bits, one for each address. Layout of a word:",
            table.depth()
        );
        let row = |(position, field): (usize, &Field)| {
            let low = table.field_low_bit(position);
            let bits = format!("[{}:{low}]", low + field.format.width() - 1);
            [bits, field.name.to_owned(), field.format.to_string()]
        };
        let rows: Vec<[String; 3]> = table.fields.iter().enumerate().map(row).collect();
        let column = |i: usize| rows.iter().map(|row| row[i].len()).max().unwrap_or(0);
        let [bits_width, name_width, format_width] = [column(0), column(1), column(2)];
        for ([bits, name, format], field) in rows.iter().zip(&table.fields) {
            let meaning = printable(field.meaning);
            line!(heading, "{comment}   {bits:<bits_width$}  {name:<name_width$}  {format:<format_width$}  {meaning}");
        }
        (heading + text).into_bytes()
    }

    /// The words by address, in hexadecimal digits of one length.
    pub fn hex_words(&self) -> impl Iterator<Item = String> {
        let digits = word_digits(self.table.word_bits());
        (0..self.table.depth()).map(move |address| format!("{:0digits$x}", self.table.word(address)))
    }

    /// The words by address, each in whole bytes, the least significant first.
    pub fn byte_words(&self) -> impl Iterator<Item = Vec<u8>> {
        let bytes = word_bytes(self.table.word_bits());
        self.table.words().into_iter().map(move |word: BigUint| {
            let mut word = word.to_bytes_le();
            word.resize(bytes, 0);
            word
        })
    }
}

/// The number of bytes that a word takes in the formats that hold whole bytes.
pub(super) fn word_bytes(word_bits: u32) -> usize {
    word_bits.div_ceil(8).max(1) as usize
}

/// The number of hexadecimal digits of a word.
pub(super) fn word_digits(word_bits: u32) -> usize {
    word_bits.div_ceil(4).max(1) as usize
}

/// Text for a comment: every file is ASCII and a comment is one line.
fn printable(text: &str) -> String {
    text.chars().map(|c| if c == ' ' || c.is_ascii_graphic() { c } else { '?' }).collect()
}
