//! Writing a table to each format.

use std::fmt::Write as _;

use ihex::Record;
use num_bigint::BigUint;

use super::{RomFormat, word_bytes, word_digits};
use crate::fixed::Table;

/// The data bytes of a record: what most tools write and every tool reads.
const HEX_RECORD_BYTES: usize = 16;
/// The bits of a VHDL string literal: with the name of its address it stays within 100 columns.
const VHDL_LITERAL_BITS: usize = 80;

/// What is written.
pub(super) struct Writing<'a> {
    table: &'a Table,
    core: &'a str,
    digest: &'a str,
    command: &'a str,
}

/// The content of a ROM file: ASCII lines that each end in LF, except for the raw words of [`RomFormat::Bin`].
///
/// Formats with comments begin with what the file is, the command that made it, the digest of its
/// specification and the layout of the word.
#[must_use]
pub fn write(table: &Table, format: RomFormat, core: &str, digest: &str, command: &str) -> Vec<u8> {
    (format.sheet().write)(&Writing { table, core, digest, command })
}

impl Writing<'_> {
    /// The heading and the text below it.
    fn headed(&self, comment: &str, what: &str, text: &str) -> Vec<u8> {
        (heading(self.table, comment, what, self.core, self.digest, self.command) + text).into_bytes()
    }
}

pub(super) fn mem(of: &Writing<'_>) -> Vec<u8> {
    of.headed("//", "words for $readmemh", &mem_words(of.table))
}

pub(super) fn mem_plain(of: &Writing<'_>) -> Vec<u8> {
    mem_words(of.table).into_bytes()
}

pub(super) fn coe(of: &Writing<'_>) -> Vec<u8> {
    of.headed(";", "Xilinx coefficient file", &coe_words(of.table))
}

pub(super) fn mif(of: &Writing<'_>) -> Vec<u8> {
    of.headed("--", "Intel memory initialization file", &mif_words(of.table))
}

pub(super) fn vhdl(of: &Writing<'_>) -> Vec<u8> {
    of.headed("--", "VHDL-2008 package", &vhdl_package(of.table, of.core))
}

pub(super) fn c(of: &Writing<'_>) -> Vec<u8> {
    of.headed("//", "C header", &c_header(of.table, of.core))
}

/// Writes one formatted line to a string.
macro_rules! line {
    ($text:expr, $($argument:tt)*) => {
        writeln!($text, $($argument)*).expect("a string takes all text")
    };
}

fn heading(table: &Table, comment: &str, what: &str, core: &str, digest: &str, command: &str) -> String {
    let mut text = String::new();
    let word_bits = table.word_bits();
    line!(text, "{comment} ROM of the core {}: {what}.", printable(core));
    // Quoted, so that no command can end the line in a backslash, which would continue a C comment.
    line!(text, "{comment} Made by `{}`.", printable(command));
    line!(text, "{comment} spec {}", printable(digest));
    line!(text, "{comment} {} words of {word_bits} bits, one for each address. Layout of a word:", table.depth());
    let rows: Vec<[String; 3]> = (0..table.fields.len())
        .map(|position| {
            let field = &table.fields[position];
            let low = table.field_low_bit(position);
            let bits = format!("[{}:{low}]", low + field.format.width() - 1);
            [bits, field.name.to_owned(), field.format.to_string()]
        })
        .collect();
    let column = |i: usize| rows.iter().map(|row| row[i].len()).max().unwrap_or(0);
    let [bits_width, name_width, format_width] = [column(0), column(1), column(2)];
    for ([bits, name, format], field) in rows.iter().zip(&table.fields) {
        let meaning = printable(field.meaning);
        line!(text, "{comment}   {bits:<bits_width$}  {name:<name_width$}  {format:<format_width$}  {meaning}");
    }
    text
}

/// Text for a comment: every file is ASCII and a comment is one line.
fn printable(text: &str) -> String {
    text.chars().map(|c| if c == ' ' || c.is_ascii_graphic() { c } else { '?' }).collect()
}

fn hex_words(table: &Table) -> impl Iterator<Item = String> {
    let digits = word_digits(table.word_bits());
    (0..table.depth()).map(move |address| format!("{:0digits$x}", table.word(address)))
}

fn mem_words(table: &Table) -> String {
    hex_words(table).fold(String::new(), |text, word| text + &word + "\n")
}

fn coe_words(table: &Table) -> String {
    let words: Vec<String> = hex_words(table).collect();
    format!("memory_initialization_radix=16;\nmemory_initialization_vector=\n{};\n", words.join(",\n"))
}

fn mif_words(table: &Table) -> String {
    let mut text = String::new();
    line!(text, "DEPTH = {};", table.depth());
    line!(text, "WIDTH = {};", table.word_bits());
    line!(text, "ADDRESS_RADIX = HEX;");
    line!(text, "DATA_RADIX = HEX;");
    line!(text, "CONTENT BEGIN");
    let digits = word_digits(table.address_bits);
    for (address, word) in hex_words(table).enumerate() {
        line!(text, "  {address:0digits$x} : {word};");
    }
    line!(text, "END;");
    text
}

fn vhdl_package(table: &Table, core: &str) -> String {
    let mut text = String::new();
    let word_bits = table.word_bits();
    let last = table.depth() - 1;
    line!(text, "library ieee;");
    line!(text, "use ieee.std_logic_1164.all;");
    line!(text, "");
    line!(text, "package {core}_rom_pkg is");
    line!(text, "  subtype rom_word_t is std_logic_vector({} downto 0);", word_bits - 1);
    line!(text, "  type rom_words_t is array (natural range 0 to {last}) of rom_word_t;");
    line!(text, "  constant ROM_WORDS : rom_words_t := (");
    for address in 0..=last {
        let bits = format!("{:0width$b}", table.word(address), width = word_bits as usize);
        // Binary digits are ASCII, so that any cut is one between characters.
        let mut rest = bits.as_str();
        let mut literals = Vec::new();
        while !rest.is_empty() {
            let (literal, after) = rest.split_at(rest.len().min(VHDL_LITERAL_BITS));
            literals.push(format!("\"{literal}\""));
            rest = after;
        }
        let comma = if address == last { "" } else { "," };
        line!(text, "    {address} => {}{comma}", literals.join(" &\n      "));
    }
    line!(text, "  );");
    line!(text, "end package {core}_rom_pkg;");
    text
}

fn c_header(table: &Table, core: &str) -> String {
    let mut text = String::new();
    let word_bits = table.word_bits();
    let depth = table.depth();
    let upper = core.to_ascii_uppercase();
    let guard = format!("{upper}_ROM_H");
    line!(text, "#ifndef {guard}");
    line!(text, "#define {guard}");
    line!(text, "");
    line!(text, "#include <stdint.h>");
    line!(text, "");
    line!(text, "#define {upper}_ROM_DEPTH {depth}");
    line!(text, "#define {upper}_ROM_WORD_BITS {word_bits}");
    line!(text, "");
    if word_bits > 64 {
        let limbs = word_bits.div_ceil(32) as usize;
        line!(text, "// Each word as {limbs} limbs of 32 bits, the least significant first.");
        line!(text, "static const uint32_t {core}_rom[{depth}][{limbs}] = {{");
        for word in table.words() {
            let mut digits = word.to_u32_digits();
            digits.resize(limbs, 0);
            let digits: Vec<String> = digits.iter().map(|limb| format!("0x{limb:08x}u")).collect();
            line!(text, "    {{{}}},", digits.join(", "));
        }
    } else {
        let (bits, suffix) = match word_bits {
            0..=8 => (8, "u"),
            9..=16 => (16, "u"),
            17..=32 => (32, "u"),
            _ => (64, "ull"),
        };
        line!(text, "static const uint{bits}_t {core}_rom[{depth}] = {{");
        for word in hex_words(table) {
            line!(text, "    0x{word}{suffix},");
        }
    }
    line!(text, "}};");
    line!(text, "");
    line!(text, "#endif");
    text
}

/// The columns address, shininess, the real value and the code of each field, and the word.
///
/// The word is written with `0x`, so that a spreadsheet does not take 00e5 for a decimal number.
pub(super) fn csv(of: &Writing<'_>) -> Vec<u8> {
    let table = of.table;
    let mut text = format!("address,{}", table.key);
    for field in &table.fields {
        write!(text, ",{0}_real,{0}_code", field.name).expect("a string takes all text");
    }
    line!(text, ",word");
    for (address, word) in hex_words(table).enumerate() {
        let row = table.row_of_address(address);
        write!(text, "{address},{}", table.keys[row]).expect("a string takes all text");
        for field in &table.fields {
            // `{:?}` is the shortest text that reads back as the same number, with an exponent where that is shorter.
            write!(text, ",{:?},{}", field.reals[row], field.codes[row]).expect("a string takes all text");
        }
        line!(text, ",0x{word}");
    }
    text.into_bytes()
}

pub(super) fn bin(of: &Writing<'_>) -> Vec<u8> {
    raw_bytes(of.table)
}

fn raw_bytes(table: &Table) -> Vec<u8> {
    let bytes = word_bytes(table.word_bits());
    let little_endian = |word: BigUint| {
        let mut word = word.to_bytes_le();
        word.resize(bytes, 0);
        word
    };
    table.words().into_iter().flat_map(little_endian).collect()
}

pub(super) fn hex(of: &Writing<'_>) -> Vec<u8> {
    let mut records = Vec::new();
    for (position, data) in raw_bytes(of.table).chunks(HEX_RECORD_BYTES).enumerate() {
        let address = position * HEX_RECORD_BYTES;
        let (high, low) = ((address >> 16) as u16, address as u16);
        if low == 0 && high > 0 {
            records.push(Record::ExtendedLinearAddress(high));
        }
        records.push(Record::Data { offset: low, value: data.to_vec() });
    }
    record_lines(records)
}

/// One record a word, as Quartus' memory editor writes them. The deepest ROM has an address of 16 bits for each of its words.
pub(super) fn quartus_hex(of: &Writing<'_>) -> Vec<u8> {
    let bytes = word_bytes(of.table.word_bits());
    let record = |(address, word): (usize, BigUint)| {
        let mut value = word.to_bytes_le();
        value.resize(bytes, 0);
        value.reverse();
        Record::Data { offset: address as u16, value }
    };
    record_lines(of.table.words().into_iter().enumerate().map(record).collect())
}

/// The records and the one that ends a file, a line each.
fn record_lines(mut records: Vec<Record>) -> Vec<u8> {
    records.push(Record::EndOfFile);
    let line = |record: Record| record.to_record_string().expect("a record of at most 255 bytes can be written") + "\n";
    records.into_iter().map(line).collect::<String>().into_bytes()
}
