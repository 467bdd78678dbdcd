//! VHDL packages.

use std::fmt::Write as _;

use num_bigint::BigUint;

use super::source::{Comments, Cursor, Kind, Source, Span, Token, Words, image, shown};
use super::writing::{Writing, line};
use super::{FileFormat, MAX_DEPTH, RomImage};
use crate::platform::error::Error;

pub(super) const VHDL: FileFormat = FileFormat {
    about: "VHDL package with the words as a constant: NAME_rom_pkg.vhd",
    suffix: "_rom_pkg.vhd",
    extensions: &["vhd", "vhdl"],
    allowed: "the words stand in a constant array of bit strings, as in := (0 => \"0101\", 1 => x\"a\"); and the \
              package ends with `end`",
    is_text: true,
    read,
    write,
};

/// The bits of a VHDL string literal: with the name of its address it stays within 100 columns.
const LITERAL_BITS: usize = 80;

fn write(of: &Writing<'_>) -> Vec<u8> {
    let Writing { table, core, .. } = *of;
    let (word_bits, last) = (table.word_bits(), table.depth() - 1);
    let mut text = format!(
        "library ieee;\nuse ieee.std_logic_1164.all;\n\npackage {core}_rom_pkg is\n  \
           subtype rom_word_t is std_logic_vector({} downto 0);\n  \
           type rom_words_t is array (natural range 0 to {last}) of rom_word_t;\n  \
           constant ROM_WORDS : rom_words_t := (\n",
        word_bits - 1
    );
    for address in 0..=last {
        let bits = format!("{:0width$b}", table.word(address), width = word_bits as usize);
        // Binary digits are ASCII, so that any cut is one between characters.
        let mut rest = bits.as_str();
        let mut literals = Vec::new();
        while !rest.is_empty() {
            let (literal, after) = rest.split_at(rest.len().min(LITERAL_BITS));
            literals.push(format!("\"{literal}\""));
            rest = after;
        }
        let comma = if address == last { "" } else { "," };
        line!(text, "    {address} => {}{comma}", literals.join(" &\n      "));
    }
    line!(text, "  );\nend package {core}_rom_pkg;");
    of.headed("--", "VHDL-2008 package", &text)
}

fn read(source: &Source<'_>) -> Result<RomImage, Error> {
    let mut cursor = source.tokens(&Comments::of("--", ("/*", "*/")))?;
    let begins = |three: &[Token<'_>]| three.iter().zip([":", "=", "("]).all(|(token, symbol)| token.is_symbol(symbol));
    let Some(array) = cursor.tokens.windows(3).position(begins) else {
        return Err(source.cut_off("the file has no constant array, which begins with `:= (`"));
    };
    cursor.next = array + 3;
    let mut words = Words::new(source);
    let mut address = 0;
    loop {
        let is_choice =
            cursor.peek(1).is_some_and(|t| t.is_symbol("=")) && cursor.peek(2).is_some_and(|t| t.is_symbol(">"));
        if is_choice {
            let token = cursor.expect_word("an address")?;
            address = source.address(token.text, 10, token.span)?;
            cursor.next += 2;
        }
        let (word, span) = read_bit_string(source, &mut cursor)?;
        words.place(address, word, span, MAX_DEPTH)?;
        address += 1;
        if cursor.take_symbol(")") {
            break;
        }
        if !cursor.take_symbol(",") {
            return Err(cursor.unexpected("`,` or `)`"));
        }
    }
    cursor.expect_symbol(";")?;
    // What follows is not read, but a package without its end has been cut off.
    let ends = cursor.tokens[cursor.next..].iter().any(|token| token.is_word("end"));
    if !ends || !cursor.tokens.last().is_some_and(|token| token.is_symbol(";")) {
        return Err(source.cut_off("the file ends before the end of the package"));
    }
    Ok(RomImage { width: Some(source.word_bits), ..image(words.finish(None)?) })
}

/// One word: bit string literals, joined with `&`, that together have as many bits as the word.
fn read_bit_string(source: &Source<'_>, cursor: &mut Cursor<'_>) -> Result<(BigUint, Span), Error> {
    let mut word = BigUint::ZERO;
    let mut bits = 0;
    let begin = cursor.next;
    loop {
        let prefix = cursor.peek(0).filter(|token| token.kind == Kind::Word);
        cursor.next += usize::from(prefix.is_some());
        let Some(literal) = cursor.peek(0).filter(|token| token.kind == Kind::Quoted) else {
            cursor.next -= usize::from(prefix.is_some());
            return Err(cursor.unexpected("a bit string such as \"0101\""));
        };
        cursor.next += 1;
        let (size, base) = match prefix {
            Some(prefix) => bit_string_prefix(source, prefix)?,
            None => (None, 1),
        };
        let digits = literal.text.bytes().filter(|&c| c != b'_').count() as u64;
        let length = size.map_or(digits * u64::from(base), u64::from);
        bits += length;
        if bits > u64::from(source.word_bits) {
            break;
        }
        let inner = (literal.span.0 + 1, literal.text.len());
        // Narrower than a word, as has just been seen.
        word = (word << length) | source.number(literal.text, 1 << base, length as u32, inner)?;
        if !cursor.take_symbol("&") {
            break;
        }
    }
    let span = cursor.span_from(begin);
    if bits != u64::from(source.word_bits) {
        let what = if bits < u64::from(source.word_bits) {
            format!("the word has {bits} bits")
        } else {
            format!("the word has more than {} bits", source.word_bits)
        };
        return Err(source.wrong_width(what, span));
    }
    Ok((word, span))
}

/// The size, if there is one, and the bits of a digit of a literal such as `x"1f"` or `22ux"1f"`.
fn bit_string_prefix(source: &Source<'_>, prefix: Token<'_>) -> Result<(Option<u32>, u32), Error> {
    let wrong = || {
        let what = format!("{} does not begin a bit string", shown(prefix.text));
        source.error(
            what,
            "a bit string is written \"0101\", b\"0101\", o\"17\", x\"1f\" or with its size, 22x\"1f\"",
            prefix.span,
        )
    };
    let (size, base) = prefix.text.split_at(prefix.text.bytes().take_while(u8::is_ascii_digit).count());
    let size = if size.is_empty() { None } else { Some(size.parse().map_err(|_| wrong())?) };
    let base = match base.to_ascii_lowercase().as_str() {
        "b" | "ub" => 1,
        "o" | "uo" => 3,
        "x" | "ux" => 4,
        _ => return Err(wrong()),
    };
    Ok((size, base))
}
