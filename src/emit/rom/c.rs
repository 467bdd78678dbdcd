//! C headers.

use std::fmt::Write as _;

use num_bigint::BigUint;

use super::source::{Comments, Cursor, Source, Span, Token, Words, image};
use super::writing::{Writing, line};
use super::{FileFormat, MAX_DEPTH, RomImage};
use crate::platform::error::Error;

pub(super) const C: FileFormat = FileFormat {
    about: "C header with the words as an array: NAME_rom.h",
    suffix: "_rom.h",
    extensions: &["h"],
    allowed: "the words stand in an array of integers or of limbs of 32 bits, as in = {0x1f, 0x2e}; or = {{1, 2}, {3, \
     4}};",
    is_text: true,
    read,
    write,
};

fn write(of: &Writing<'_>) -> Vec<u8> {
    let Writing { table, core, .. } = *of;
    let (word_bits, depth) = (table.word_bits(), table.depth());
    let upper = core.to_ascii_uppercase();
    let mut text = format!(
        "#ifndef {upper}_ROM_H\n#define {upper}_ROM_H\n\n#include <stdint.h>\n\n\
         #define {upper}_ROM_DEPTH {depth}\n#define {upper}_ROM_WORD_BITS {word_bits}\n\n"
    );
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
        for word in of.hex_words() {
            line!(text, "    0x{word}{suffix},");
        }
    }
    text += "};\n\n#endif\n";
    of.headed("//", "C header", &text)
}

fn read(source: &Source<'_>) -> Result<RomImage, Error> {
    let mut cursor = source.tokens(&Comments::of("//", ("/*", "*/")))?;
    let begins = |two: &[Token<'_>]| two[0].is_symbol("=") && two[1].is_symbol("{");
    let Some(array) = cursor.tokens.windows(2).position(begins) else {
        return Err(source.cut_off("the file has no array, which begins with `= {`"));
    };
    let depth = array_depth(&cursor.tokens[..array]);
    cursor.next = array + 2;
    let mut words = Words::new(source);
    let mut address = 0;
    while !cursor.take_symbol("}") {
        let (word, span) = if cursor.take_symbol("{") {
            read_limbs(source, &mut cursor)?
        } else {
            read_integer(source, &mut cursor, source.word_bits)?
        };
        words.place(address, word, span, depth.unwrap_or(MAX_DEPTH).min(MAX_DEPTH))?;
        address += 1;
        if !cursor.take_symbol(",") && !cursor.peek(0).is_some_and(|token| token.is_symbol("}")) {
            return Err(cursor.unexpected("`,` or `}`"));
        }
    }
    cursor.expect_symbol(";")?;
    // What follows is not read, but a header without the end of its guard has been cut off.
    let directives = |names: &[&str]| {
        let is_one = |two: &&[Token<'_>]| two[0].is_symbol("#") && names.contains(&two[1].text);
        cursor.tokens.windows(2).filter(is_one).count()
    };
    if directives(&["if", "ifdef", "ifndef"]) > directives(&["endif"]) {
        return Err(source.cut_off("the file ends before the #endif of its include guard"));
    }
    words.finish(depth).map(image)
}

/// The number in the first brackets of a declarator, if it is a plain one.
fn array_depth(declarator: &[Token<'_>]) -> Option<usize> {
    let mut depth = None;
    let mut rest = declarator;
    while let [before @ .., open, size, close] = rest
        && open.is_symbol("[")
        && close.is_symbol("]")
    {
        depth = size.text.parse().ok();
        rest = before;
    }
    depth
}

/// The limbs of 32 bits of one word up to the closing brace, the least significant first.
fn read_limbs(source: &Source<'_>, cursor: &mut Cursor<'_>) -> Result<(BigUint, Span), Error> {
    let begin = cursor.next - 1;
    let mut limbs = Vec::new();
    loop {
        let (limb, _) = read_integer(source, cursor, 32)?;
        limbs.push(limb.to_u32_digits().first().copied().unwrap_or(0));
        let comma = cursor.take_symbol(",");
        if cursor.take_symbol("}") {
            break;
        }
        if !comma {
            return Err(cursor.unexpected("`,` or `}`"));
        }
    }
    let span = cursor.span_from(begin);
    let word = BigUint::new(limbs);
    source.refuse_wide(&word, span)?;
    Ok((word, span))
}

fn read_integer(source: &Source<'_>, cursor: &mut Cursor<'_>, bits: u32) -> Result<(BigUint, Span), Error> {
    let token = cursor.expect_word("an integer")?;
    let digits = token.text.trim_end_matches(['u', 'U', 'l', 'L']);
    let lower = digits.to_ascii_lowercase();
    let (digits, radix) = if let Some(digits) = lower.strip_prefix("0x") {
        (digits, 16)
    } else if let Some(digits) = lower.strip_prefix("0b") {
        (digits, 2)
    } else if lower.starts_with('0') {
        (lower.as_str(), 8)
    } else {
        (lower.as_str(), 10)
    };
    Ok((source.number(digits, radix, bits, token.span)?, token.span))
}
