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
    allowed: "a .coe file has memory_initialization_radix=2, 8, 10 or 16; then memory_initialization_vector=WORD,WORD,...; and \
              after each semicolon a comment up to the end of the line",
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

#[cfg(test)]
mod tests {
    use super::super::RomFormat;
    use super::super::tests::{refused, words};

    #[test]
    fn coe_of_other_tools() {
        let text = "; a comment\nMemory_Initialization_Radix = 2 ;\n;another\nmemory_initialization_vector = 01 10,\n; inside\n11\n;\n";
        assert_eq!(words(text, RomFormat::Coe, 8), Ok(vec![1, 2, 3]));
        let vector = "memory_initialization_radix=10;\nmemory_initialization_vector=1,2";
        assert_eq!(words(&format!("{vector}55;"), RomFormat::Coe, 8), Ok(vec![1, 255]));
        assert_eq!(refused(&format!("{vector}56;"), RomFormat::Coe, 8), "`256` is too wide");
        assert_eq!(refused(vector, RomFormat::Coe, 8), "the file ends where `,` or `;` is expected");
        assert_eq!(refused(&vector.replace("10", "7"), RomFormat::Coe, 8), "the radix `7` is not allowed");
    }

    /// By AMD UG896: text behind a semicolon is a comment, keywords are in any case, and those behind the vector are
    /// not read.
    #[test]
    fn coe_as_its_manual_has_it() {
        let words = |text: &str| words(text, RomFormat::Coe, 8);
        for text in [
            "MEMORY_INITIALIZATION_RADIX = 8 ; octal; = \"words, (\nMEMORY_INITIALIZATION_VECTOR = 1, 17, 377; the end, 5",
            "memory_initialization_radix=16; hex\nmemory_initialization_vector=\n1,\nf,\nff;\nPATTERN = 5, 6;\nany=thing \"",
            "; = \nRadix = 10 ; all of it\n\n; more\nMemory_initialization_vector = 1 15\n; a line\n255; memory_initialization_vector=7;",
            "memory_initialization_radix=2;\r\nmemory_initialization_vector=\r\n1\r\n1111\r\n11111111\r\n;\r\n",
        ] {
            assert_eq!(words(text), Ok(vec![1, 15, 255]), "{text}");
        }
        let vector = "memory_initialization_radix=16;\nmemory_initialization_vector=";
        assert_eq!(
            words(&format!("{vector}1;\n2;\n")),
            Err("`2` stands where a keyword with `=` or the end of the file is expected".to_owned())
        );
        assert_eq!(
            words("memory_initialization_vector=1;\nmemory_initialization_radix=16;"),
            Err("memory_initialization_radix must stand before the words".to_owned())
        );
        assert_eq!(
            words("radix=10;\ncoefdata=1,2;"),
            Err("`coefdata` is for filters and other cores, and this is a memory".to_owned())
        );
        assert_eq!(
            words("; only\n"),
            Err("the file ends where memory_initialization_radix or memory_initialization_vector is expected"
                .to_owned())
        );
    }
}
