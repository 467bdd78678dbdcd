//! Xilinx' coefficient files.

use num_bigint::BigUint;

use super::source::{Comments, Cursor, Kind, Source, Words, image, shown};
use super::writing::Writing;
use super::{FileFormat, MAX_DEPTH, RomImage};
use crate::platform::error::Error;

pub(super) const COE: FileFormat = FileFormat {
    about: "Xilinx coefficient file: NAME.coe",
    suffix: ".coe",
    extensions: &["coe"],
    allowed: "a .coe file has memory_initialization_radix=2, 8, 10 or 16; then \
              memory_initialization_vector=WORD,WORD,...; and after each semicolon a comment up to the end of the line",
    is_text: true,
    read,
    write,
};

fn write(of: &Writing<'_>) -> Vec<u8> {
    let words: Vec<String> = of.hex_words().collect();
    let text = format!("memory_initialization_radix=16;\nmemory_initialization_vector=\n{};\n", words.join(",\n"));
    of.headed(";", "Xilinx coefficient file", &text)
}

/// Settings and words as AMD UG896 has them: `KEYWORD = VALUE ;`, with the text behind each semicolon a comment up to
/// the end of its line. Keywords are in any case; `memory_initialization_vector` is the last one, and what follows is
/// not read.
fn read(source: &Source<'_>) -> Result<RomImage, Error> {
    let mut cursor = source.tokens(&Comments { line: None, behind: Some(';'), block: None })?;
    let mut radix = None;
    loop {
        while cursor.take_symbol(";") {}
        let key = cursor.expect_word("memory_initialization_radix or memory_initialization_vector")?;
        cursor.expect_symbol("=")?;
        if key.is_word("memory_initialization_radix") || key.is_word("radix") {
            let value = cursor.expect_word("a radix")?;
            let known = [2, 8, 10, 16].into_iter().find(|radix| radix.to_string() == value.text);
            let unknown = || source.wrong(format!("the radix {} is not allowed", shown(value.text)), value.span);
            radix = Some(known.ok_or_else(unknown)?);
            cursor.expect_symbol(";")?;
        } else if key.is_word("memory_initialization_vector") {
            let Some(radix) = radix else {
                let what = "memory_initialization_radix must stand before the words";
                return Err(source.wrong(what, key.span));
            };
            return read_vector(source, &mut cursor, radix).map(image);
        } else if key.is_word("coefdata") || key.is_word("pattern") || key.is_word("branch_length_vector") {
            let what = format!("{} is for filters and other cores, and this is a memory", shown(key.text));
            return Err(source.wrong(what, key.span));
        } else {
            let what = format!("{} is not a setting of a .coe file", shown(key.text));
            return Err(source.wrong(what, key.span));
        }
    }
}

/// Words with commas or white space between them, ended by a semicolon.
fn read_vector(source: &Source<'_>, cursor: &mut Cursor<'_>, radix: u32) -> Result<Vec<BigUint>, Error> {
    let is_keyword = |cursor: &Cursor<'_>| cursor.peek(1).is_some_and(|next| next.is_symbol("="));
    let mut words = Words::new(source);
    for address in 0.. {
        // A line that is a comment as a whole may stand among the words; one behind a word ends them.
        while is_comment_line(source, cursor) && cursor.take_symbol(";") {}
        let token = cursor.expect_word("a word")?;
        words.place(address, source.word(token.text, radix, token.span)?, token.span, MAX_DEPTH)?;
        let goes_on = |cursor: &mut Cursor<'_>| {
            let is_word = cursor.peek(0).is_some_and(|next| next.kind == Kind::Word);
            cursor.take_symbol(",") || is_word && !is_keyword(cursor)
        };
        if goes_on(cursor) {
            continue;
        }
        let comment_line = is_comment_line(source, cursor);
        if !cursor.take_symbol(";") {
            return Err(cursor.unexpected("`,` or `;`"));
        }
        while cursor.take_symbol(";") {}
        if comment_line && goes_on(cursor) {
            continue;
        }
        // What follows may be further settings, and nothing else.
        if cursor.peek(0).is_some() && !is_keyword(cursor) {
            return Err(cursor.unexpected("a keyword with `=` or the end of the file"));
        }
        break;
    }
    words.finish(None)
}

/// Whether the next token begins its line, and more stands behind it.
fn is_comment_line(source: &Source<'_>, cursor: &Cursor<'_>) -> bool {
    cursor.peek(0).is_some_and(|next| {
        let (before, after) = (&source.text[..next.span.0], &source.text[next.end()..]);
        let blank = |line: Option<&str>| line.is_none_or(|line| line.trim().is_empty());
        blank(before.rsplit('\n').next()) && !blank(after.split('\n').next())
    })
}
