//! Reading each format: what [`write`](super::write()) writes, and what other tools write within reason.

use std::collections::BTreeMap;

use ihex::{ReaderError, Record};
use num_bigint::BigUint;

pub(super) use super::source::Source;
use super::source::{Comments, Cursor, Kind, Span, Token, Words, shown};
use super::{MAX_DEPTH, RomFormat, RomImage, word_bytes};
use crate::platform::error::Error;
use crate::platform::input;

/// Reads a ROM file. `expected_bits` is the width of the words that it should hold, `file` its name for messages.
///
/// # Errors
/// Says what is wrong, where, and what is allowed: the text is not of the format or is cut off, a word is wider
/// than `expected_bits` or the format states another width, an address is out of range, twice there or missing.
pub fn read(bytes: &[u8], format: RomFormat, file: &str, expected_bits: u32) -> Result<RomImage, Error> {
    let sheet = format.sheet();
    if sheet.is_text {
        input::refuse_wide_text(bytes, file)?;
    }
    (sheet.read)(&Source::new(bytes, file, sheet.allowed, expected_bits))
}

fn image(words: Vec<BigUint>) -> RomImage {
    RomImage { words, kind: None, width: None, codes: Vec::new() }
}

/// What `$readmemh` takes (IEEE 1364-2005, 17.2.9), or Lattice's kind where the file begins with its header.
pub(super) fn mem(source: &Source<'_>) -> Result<RomImage, Error> {
    if source.text.trim_start().starts_with('#') {
        return lattice_mem(source);
    }
    let mut cursor = source.tokens(&Comments { line: Some("//"), behind: None, block: Some(("/*", "*/")) })?;
    let mut words = Words::new(source);
    let mut address = 0;
    let mut digit_counts = Vec::new();
    let mut last = (0, 0);
    while let Some(next) = cursor.peek(0) {
        if next.is_symbol(":") && digit_counts.is_empty() {
            let allowed = "give it with --format hex or quartus-hex, or a name that ends in .hex";
            return Err(source.error("this is an Intel HEX record, and no text for $readmemh", allowed, next.span));
        }
        if cursor.take_symbol("@") {
            let token = cursor.expect_word("a hexadecimal address")?;
            address = source.address(token.text, 16, token.span)?;
            if cursor.peek(0).is_none() {
                return Err(cursor.unexpected("a word for that address"));
            }
            continue;
        }
        let token = cursor.expect_word("a hexadecimal word")?;
        let unknown = |digit: u8| b"xXzZ".contains(&digit);
        let prefixed = token.text.starts_with("0x") || token.text.starts_with("0X");
        if !prefixed
            && token.text.bytes().all(|digit| digit.is_ascii_hexdigit() || digit == b'_' || unknown(digit))
            && token.text.bytes().any(unknown)
        {
            let what = format!("{} has digits without a value", shown(token.text));
            return Err(source.error(what, "every bit of a ROM is 0 or 1, and none is x or z", token.span));
        }
        words.place(address, source.word(token.text, 16, token.span)?, token.span, MAX_DEPTH)?;
        address += 1;
        last = token.span;
        digit_counts.push(token.text.len());
    }
    source.refuse_cut_word(last, &digit_counts)?;
    words.finish(None).map(image)
}

/// The non-empty lines of a text without what follows one of the comments' beginnings, with their places.
fn lines<'s>(text: &'s str, comments: &'static [&'static str]) -> impl Iterator<Item = (&'s str, Span)> {
    let offset = |part: &str| part.as_ptr() as usize - text.as_ptr() as usize;
    let bare = move |line: &'s str| {
        let end = comments.iter().filter_map(|comment| line.find(*comment)).min().unwrap_or(line.len());
        line[..end].trim()
    };
    text.lines().map(bare).filter(|line| !line.is_empty()).map(move |line| (line, (offset(line), line.len())))
}

/// Lattice's memory file: a header from `#Format=` to `#Data`, then a word a line, in hexadecimal or binary; or `ADDRESS: WORD WORD`, all
/// in hexadecimal. Comments begin with `#` or `//`; a word that is not given is 0.
fn lattice_mem(source: &Source<'_>) -> Result<RomImage, Error> {
    let (mut form, mut depth, mut stated_width) = (None, None, None);
    let mut data = None;
    for (line, span) in lines(&source.text, &[]) {
        let wrong = |what: String| source.error(what, source.allowed, span);
        let Some(setting) = line.strip_prefix('#') else {
            return Err(wrong(format!(
                "{} stands where a line of Lattice's header is expected, up to #Data",
                shown(line)
            )));
        };
        let (key, value) = setting.split_once('=').unwrap_or((setting, ""));
        let (key, value) = (key.trim().to_ascii_lowercase(), value.trim());
        let number = || value.parse::<u32>().map_err(|_| wrong(format!("{} is not a number", shown(value))));
        match key.as_str() {
            "format" => {
                form = Some(match value.to_ascii_lowercase().as_str() {
                    "hex" => (16, false),
                    "bin" => (2, false),
                    "addrhex" => (16, true),
                    _ => return Err(wrong(format!("the format {} is not Bin, Hex or AddrHex", shown(value)))),
                });
            }
            "depth" => {
                let stated = number()? as usize;
                if !(1..=MAX_DEPTH).contains(&stated) {
                    return Err(wrong(format!("the file states {stated} words, where 1 to {MAX_DEPTH} are allowed")));
                }
                depth = Some(stated);
            }
            "width" => {
                let width = number()?;
                if width != source.word_bits {
                    let allowed = format!("the words of this ROM have {} bits", source.word_bits);
                    return Err(source.error(format!("the file states words of {width} bits"), allowed, span));
                }
                stated_width = Some(width);
            }
            // How Lattice's tools show them; the data are as the format says.
            "addrradix" | "dataradix" => drop(number()?),
            "data" => {
                data = Some(span.0 + span.1);
                break;
            }
            _ => return Err(wrong(format!("{} is no line of Lattice's header", shown(line)))),
        }
    }
    let missing = |what: &str| source.cut_off(format!("{what} is not given in Lattice's header"));
    let data = data.ok_or_else(|| missing("#Data"))?;
    let (radix, addressed) = form.ok_or_else(|| missing("#Format"))?;
    let depth = depth.ok_or_else(|| missing("#Depth"))?;
    let width = stated_width.ok_or_else(|| missing("#Width"))?;
    let mut words = Words::new(source);
    let mut address = 0;
    let mut digit_counts = Vec::new();
    let mut last = (0, 0);
    for (line, (at, _)) in lines(&source.text[data..], &["#", "//"]) {
        let offset = |part: &str| data + at + (part.as_ptr() as usize - line.as_ptr() as usize);
        let mut rest = line;
        if addressed {
            let Some((before, after)) = line.split_once(':') else {
                return Err(source.error("there is no address and colon", source.allowed, (data + at, line.len())));
            };
            let before = before.trim_end();
            address = source.address(before, 16, (offset(before), before.len()))?;
            rest = after;
        }
        for (number, word) in rest.split_ascii_whitespace().enumerate() {
            let span = (offset(word), word.len());
            if number > 0 && !addressed {
                return Err(source.error(
                    "a second word in a line",
                    "Lattice's formats Hex and Bin have a word a line",
                    span,
                ));
            }
            words.place(address, source.word(word, radix, span)?, span, depth)?;
            address += 1;
            digit_counts.push(word.len());
            last = span;
        }
    }
    source.refuse_cut_word(last, &digit_counts)?;
    // What is not addressed is 0; where words are not addressed, a missing one has been cut off.
    let words = if addressed { words.filled(depth) } else { words.finish(Some(depth))? };
    Ok(RomImage { kind: Some("with Lattice's header"), width: Some(width), ..image(words) })
}

/// Settings and words as AMD UG896 has them: `KEYWORD = VALUE ;`, with the text behind each semicolon a comment up to the end of its line.
/// Keywords are in any case; `memory_initialization_vector` is the last one, and what follows is not read.
pub(super) fn coe(source: &Source<'_>) -> Result<RomImage, Error> {
    let mut cursor = source.tokens(&Comments { line: None, behind: Some(';'), block: None })?;
    let mut radix = None;
    loop {
        while cursor.take_symbol(";") {}
        let key = cursor.expect_word("memory_initialization_radix or memory_initialization_vector")?;
        cursor.expect_symbol("=")?;
        if key.is_word("memory_initialization_radix") || key.is_word("radix") {
            let value = cursor.expect_word("a radix")?;
            radix = Some(match value.text {
                "2" => 2,
                "8" => 8,
                "10" => 10,
                "16" => 16,
                other => {
                    return Err(source.error(
                        format!("the radix {} is not allowed", shown(other)),
                        source.allowed,
                        value.span,
                    ));
                }
            });
            cursor.expect_symbol(";")?;
        } else if key.is_word("memory_initialization_vector") {
            let Some(radix) = radix else {
                let what = "memory_initialization_radix must stand before the words";
                return Err(source.error(what, source.allowed, key.span));
            };
            return coe_vector(source, &mut cursor, radix).map(image);
        } else if key.is_word("coefdata") || key.is_word("pattern") || key.is_word("branch_length_vector") {
            let what = format!("{} is for filters and other cores, and this is a memory", shown(key.text));
            return Err(source.error(what, source.allowed, key.span));
        } else {
            let what = format!("{} is not a setting of a .coe file", shown(key.text));
            return Err(source.error(what, source.allowed, key.span));
        }
    }
}

/// Words with commas or white space between them, ended by a semicolon.
fn coe_vector(source: &Source<'_>, cursor: &mut Cursor<'_>, radix: u32) -> Result<Vec<BigUint>, Error> {
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

/// The settings in front of a .mif file's words.
#[derive(Default)]
struct MifSettings {
    depth: Option<usize>,
    width: Option<u32>,
    address_radix: Option<MifRadix>,
    data_radix: Option<MifRadix>,
}

#[derive(Clone, Copy)]
struct MifRadix {
    radix: u32,
    signed: bool,
}

impl MifRadix {
    fn of_name(name: &str) -> Option<Self> {
        let (radix, signed) = match name.to_ascii_uppercase().as_str() {
            "BIN" => (2, false),
            "OCT" => (8, false),
            "UNS" => (10, false),
            "DEC" => (10, true),
            "HEX" => (16, false),
            _ => return None,
        };
        Some(Self { radix, signed })
    }
}

pub(super) fn mif(source: &Source<'_>) -> Result<RomImage, Error> {
    if lines(&source.text, &[]).next().is_some_and(|(line, _)| line.bytes().all(|digit| matches!(digit, b'0' | b'1'))) {
        return xilinx_mif(source);
    }
    let mut cursor = source.tokens(&Comments { line: Some("--"), behind: None, block: Some(("%", "%")) })?;
    let settings = read_mif_settings(source, &mut cursor)?;
    let begin = cursor.expect_word("BEGIN")?;
    if !begin.is_word("BEGIN") {
        cursor.next -= 1;
        return Err(cursor.unexpected("BEGIN"));
    }
    let missing = |name: &str| source.error(format!("{name} is not given before CONTENT"), source.allowed, begin.span);
    let depth = settings.depth.ok_or_else(|| missing("DEPTH"))?;
    let width = settings.width.ok_or_else(|| missing("WIDTH"))?;
    // Quartus takes hexadecimal for a radix that is not given.
    let hexadecimal = MifRadix { radix: 16, signed: false };
    let address_radix = settings.address_radix.unwrap_or(hexadecimal).radix;
    let data_radix = settings.data_radix.unwrap_or(hexadecimal);

    let mut words = Words::new(source);
    loop {
        // Only `END` with its semicolon: in hexadecimal it could not be an address, as N is no digit.
        if cursor.peek(0).is_some_and(|token| token.is_word("END")) {
            cursor.next += 1;
            cursor.expect_symbol(";")?;
            cursor.expect_end()?;
            return Ok(RomImage { width: Some(width), ..image(words.finish(Some(depth))?) });
        }
        let (first, last) = read_mif_addresses(source, &mut cursor, address_radix)?;
        cursor.expect_symbol(":")?;
        let mut line = Vec::new();
        while line.is_empty() || !cursor.take_symbol(";") {
            line.push(read_mif_word(source, &mut cursor, data_radix)?);
        }
        // A range repeats its words up to its end; a single address begins a run of them.
        let count = last.map_or(line.len(), |last| last - first + 1);
        for (address, (word, span)) in (first..first + count).zip(line.iter().cycle()) {
            words.place(address, word.clone(), *span, depth)?;
        }
    }
}

/// Xilinx' kind, which its core generators write for simulation: a line of binary digits for each word, as many as it has bits.
fn xilinx_mif(source: &Source<'_>) -> Result<RomImage, Error> {
    let mut words = Words::new(source);
    for (address, (line, span)) in lines(&source.text, &[]).enumerate() {
        let word = source.word(line, 2, span)?;
        if line.len() != source.word_bits as usize {
            let what = format!("this word has {} binary digits", line.len());
            return Err(source.error(what, format!("the words of this ROM have {} bits", source.word_bits), span));
        }
        words.place(address, word, span, MAX_DEPTH)?;
    }
    Ok(RomImage { kind: Some("Xilinx' kind"), width: Some(source.word_bits), ..image(words.finish(None)?) })
}

fn read_mif_settings(source: &Source<'_>, cursor: &mut Cursor<'_>) -> Result<MifSettings, Error> {
    let mut settings = MifSettings::default();
    loop {
        let key = cursor.expect_word("a setting or CONTENT")?;
        if key.is_word("CONTENT") {
            return Ok(settings);
        }
        cursor.expect_symbol("=")?;
        let value = cursor.expect_word("a value")?;
        let radix = || {
            let what = format!("the radix {} is not known", shown(value.text));
            MifRadix::of_name(value.text)
                .ok_or_else(|| source.error(what, "a radix is BIN, OCT, DEC, UNS or HEX", value.span))
        };
        let number = |most: usize| {
            let number = usize::try_from(source.number(value.text, 10, 32, value.span)?).unwrap_or(usize::MAX);
            if (1..=most).contains(&number) {
                return Ok(number);
            }
            let what = format!("{} is {number}", key.text.to_ascii_uppercase());
            Err(source.error(what, format!("it is a number from 1 to {most}"), value.span))
        };
        match key.text.to_ascii_uppercase().as_str() {
            "DEPTH" => settings.depth = Some(number(MAX_DEPTH)?),
            "WIDTH" => {
                let width = number(usize::MAX)?;
                if width != source.word_bits as usize {
                    let what = format!("the file states words of {width} bits");
                    let allowed = format!("the words of this ROM have {} bits", source.word_bits);
                    return Err(source.error(what, allowed, value.span));
                }
                settings.width = Some(source.word_bits);
            }
            "ADDRESS_RADIX" => settings.address_radix = Some(radix()?),
            "DATA_RADIX" => settings.data_radix = Some(radix()?),
            _ => {
                let what = format!("{} is not a setting of a .mif file", shown(key.text));
                return Err(source.error(what, source.allowed, key.span));
            }
        }
        cursor.expect_symbol(";")?;
    }
}

/// One address, or the first and the last of a range such as `[0..3]`.
fn read_mif_addresses(
    source: &Source<'_>,
    cursor: &mut Cursor<'_>,
    radix: u32,
) -> Result<(usize, Option<usize>), Error> {
    let is_range = cursor.take_symbol("[");
    let token = cursor.expect_word("an address or END")?;
    let first = source.address(token.text, radix, token.span)?;
    if !is_range {
        return Ok((first, None));
    }
    cursor.expect_symbol(".")?;
    cursor.expect_symbol(".")?;
    let token = cursor.expect_word("an address")?;
    let last = source.address(token.text, radix, token.span)?;
    cursor.expect_symbol("]")?;
    if last < first {
        let what = format!("the range from {first} to {last} is empty");
        return Err(source.error(what, "write the smaller address first", token.span));
    }
    Ok((first, Some(last)))
}

fn read_mif_word(source: &Source<'_>, cursor: &mut Cursor<'_>, radix: MifRadix) -> Result<(BigUint, Span), Error> {
    let negative = radix.signed && cursor.take_symbol("-");
    let token = cursor.expect_word("a word or `;`")?;
    let magnitude = source.word(token.text, radix.radix, token.span)?;
    if !negative {
        return Ok((magnitude, token.span));
    }
    let modulus = BigUint::from(1u8) << source.word_bits;
    if &magnitude + &magnitude > modulus {
        let what = format!("{} is out of range", shown(&format!("-{}", token.text)));
        return Err(source.error(
            what,
            format!("a word has {} bits in two's complement", source.word_bits),
            token.span,
        ));
    }
    Ok(((&modulus - magnitude) % &modulus, token.span))
}

pub(super) fn vhdl(source: &Source<'_>) -> Result<RomImage, Error> {
    let mut cursor = source.tokens(&Comments { line: Some("--"), behind: None, block: Some(("/*", "*/")) })?;
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
    let start = cursor.tokens[begin].span.0;
    let span = (start, cursor.tokens[cursor.next - 1].end() - start);
    if bits != u64::from(source.word_bits) {
        let what = if bits < u64::from(source.word_bits) {
            format!("the word has {bits} bits")
        } else {
            format!("the word has more than {} bits", source.word_bits)
        };
        return Err(source.error(what, format!("the words of this ROM have {} bits", source.word_bits), span));
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

pub(super) fn c(source: &Source<'_>) -> Result<RomImage, Error> {
    let mut cursor = source.tokens(&Comments { line: Some("//"), behind: None, block: Some(("/*", "*/")) })?;
    let begins = |two: &[Token<'_>]| two[0].is_symbol("=") && two[1].is_symbol("{");
    let Some(array) = cursor.tokens.windows(2).position(begins) else {
        return Err(source.cut_off("the file has no array, which begins with `= {`"));
    };
    let depth = c_array_depth(&cursor.tokens[..array]);
    cursor.next = array + 2;
    let mut words = Words::new(source);
    let mut address = 0;
    while !cursor.take_symbol("}") {
        let (word, span) = if cursor.take_symbol("{") {
            read_c_limbs(source, &mut cursor)?
        } else {
            read_c_integer(source, &mut cursor, source.word_bits)?
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
fn c_array_depth(declarator: &[Token<'_>]) -> Option<usize> {
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
fn read_c_limbs(source: &Source<'_>, cursor: &mut Cursor<'_>) -> Result<(BigUint, Span), Error> {
    let begin = cursor.next - 1;
    let mut limbs = Vec::new();
    loop {
        let (limb, _) = read_c_integer(source, cursor, 32)?;
        limbs.push(limb.to_u32_digits().first().copied().unwrap_or(0));
        let comma = cursor.take_symbol(",");
        if cursor.take_symbol("}") {
            break;
        }
        if !comma {
            return Err(cursor.unexpected("`,` or `}`"));
        }
    }
    let start = cursor.tokens[begin].span.0;
    let span = (start, cursor.tokens[cursor.next - 1].end() - start);
    let word = BigUint::new(limbs);
    refuse_wide(source, &word, span)?;
    Ok((word, span))
}

fn read_c_integer(source: &Source<'_>, cursor: &mut Cursor<'_>, bits: u32) -> Result<(BigUint, Span), Error> {
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

fn refuse_wide(source: &Source<'_>, word: &BigUint, span: Span) -> Result<(), Error> {
    if word.bits() <= u64::from(source.word_bits) {
        return Ok(());
    }
    let what = format!("the word 0x{word:x} is too wide");
    Err(source.error(what, format!("the words of this ROM have {} bits", source.word_bits), span))
}

/// What a column of a .csv file holds.
enum Column<'s> {
    Address,
    Word,
    Code(&'s str),
    /// A number that nothing is compared with.
    Real,
    Other,
}

pub(super) fn csv(source: &Source<'_>) -> Result<RomImage, Error> {
    input::check_separator(&source.text, source.file)?;
    let mut rows = csv_rows(&source.text);
    let Some(header) = rows.next() else {
        return Err(source.cut_off("the file has no header row"));
    };
    let columns: Vec<Column<'_>> = header
        .iter()
        .map(|(name, _)| match *name {
            "address" => Column::Address,
            "word" => Column::Word,
            "shininess" | "entry" => Column::Real,
            name => match (name.strip_suffix("_code"), name.strip_suffix("_real")) {
                (Some(field), _) => Column::Code(field),
                (_, Some(_)) => Column::Real,
                _ => Column::Other,
            },
        })
        .collect();
    let only_one = |name: &str| header.iter().filter(|(cell, _)| *cell == name).count() == 1;
    if let Some(name) = ["address", "word"].into_iter().find(|name| !only_one(name)) {
        let what = format!("the header row has not one column `{name}`");
        return Err(source.error(what, source.allowed, row_span(&header)));
    }

    let mut words = Words::new(source);
    let mut codes_by_address = BTreeMap::new();
    let mut digit_counts = Vec::new();
    let mut last = (0, 0);
    for row in rows {
        if row.len() != columns.len() {
            let what = format!("the number of cells in this row is {}", row.len());
            let allowed = format!("the header row names {} columns", columns.len());
            return Err(source.error(what, allowed, row_span(&row)));
        }
        let mut address = 0;
        let mut word = (BigUint::ZERO, (0, 0));
        let mut codes: Vec<i128> = Vec::new();
        for (column, &(cell, span)) in columns.iter().zip(&row) {
            let not_a = |kind: &str| source.error(format!("{} is not {kind}", shown(cell)), source.allowed, span);
            match column {
                Column::Address => address = source.address(cell, 10, span)?,
                Column::Word => {
                    let digits = cell.strip_prefix("0x").or_else(|| cell.strip_prefix("0X")).unwrap_or(cell);
                    word = (source.word(digits, 16, span)?, span);
                    last = span;
                    digit_counts.push(digits.len());
                }
                Column::Code(_) => codes.push(cell.parse().map_err(|_| not_a("an integer"))?),
                Column::Real => {
                    cell.parse::<f64>().ok().filter(|real| real.is_finite()).ok_or_else(|| not_a("a finite number"))?;
                }
                Column::Other => {}
            }
        }
        words.place(address, word.0, word.1, MAX_DEPTH)?;
        codes_by_address.insert(address, codes);
    }
    source.refuse_cut_word(last, &digit_counts)?;
    let fields = columns.iter().filter_map(|column| if let Column::Code(field) = column { Some(*field) } else { None });
    let codes = fields.enumerate().map(|(position, field)| {
        let codes = codes_by_address.values().map(|codes: &Vec<i128>| codes[position]).collect();
        (field.to_owned(), codes)
    });
    Ok(RomImage { codes: codes.collect(), ..image(words.finish(None)?) })
}

/// A row's cells with their places.
type CsvRow<'s> = Vec<(&'s str, Span)>;

/// The rows that are not blank. A cell may stand in double quotes, but not hold a comma.
fn csv_rows(text: &str) -> impl Iterator<Item = CsvRow<'_>> {
    let offset = |part: &str| part.as_ptr() as usize - text.as_ptr() as usize;
    text.lines().filter(|line| !line.trim().is_empty()).map(move |line| {
        let cells = line.split(',').map(|cell| {
            let cell = cell.trim();
            let inner = cell.strip_prefix('"').and_then(|cell| cell.strip_suffix('"')).unwrap_or(cell);
            (inner, (offset(inner), inner.len()))
        });
        cells.collect()
    })
}

fn row_span(row: &CsvRow<'_>) -> Span {
    match (row.first(), row.last()) {
        (Some((_, first)), Some((_, last))) => (first.0, last.0 + last.1 - first.0),
        _ => (0, 0),
    }
}

pub(super) fn bin(source: &Source<'_>) -> Result<RomImage, Error> {
    let Source { bytes, file, word_bits, .. } = *source;
    let word_bytes = word_bytes(word_bits);
    let allowed = format!("a .bin file of this ROM has {word_bytes} bytes for each word of {word_bits} bits");
    if bytes.is_empty() || !bytes.len().is_multiple_of(word_bytes) {
        let what = format!("{file}: {} bytes are not a whole number of words", bytes.len());
        return Err(Error::input(what, allowed));
    }
    if bytes.len() / word_bytes > MAX_DEPTH {
        let what = format!("{file}: it has {} words", bytes.len() / word_bytes);
        return Err(Error::input(what, format!("a ROM has at most {MAX_DEPTH} words")));
    }
    let words: Vec<BigUint> = bytes.chunks(word_bytes).map(BigUint::from_bytes_le).collect();
    if let Some(address) = words.iter().position(|word| word.bits() > u64::from(word_bits)) {
        let what = format!(
            "{file}: the word 0x{:x} at the address {address}, byte {}, is too wide",
            words[address],
            address * word_bytes
        );
        return Err(Error::input(what, allowed));
    }
    Ok(image(words))
}

/// The records' data with their addresses, which have their extensions added, and their places. An extension by segment counts as 16, one
/// that is linear as 65,536.
struct Records(Vec<(usize, Vec<u8>, Span)>);

impl Records {
    fn of(source: &Source<'_>) -> Result<Self, Error> {
        let mut records = Vec::new();
        let mut base = 0;
        let mut ended = false;
        for (record, span) in lines(&source.text, &[]) {
            if ended {
                return Err(source.error("a line stands after the end-of-file record", source.allowed, span));
            }
            let record: Record = record.parse().map_err(|wrong| {
                let what = match wrong {
                    // The crate's own text has the two the other way round.
                    ReaderError::ChecksumMismatch(right, given) => {
                        format!("the checksum of this record is {given:02X} and should be {right:02X}")
                    }
                    other => format!("this is not an Intel HEX record: {other}"),
                };
                source.error(what, source.allowed, span)
            })?;
            match record {
                Record::Data { offset, value } => records.push((base + usize::from(offset), value, span)),
                Record::ExtendedSegmentAddress(segment) => base = usize::from(segment) << 4,
                Record::ExtendedLinearAddress(high) => base = usize::from(high) << 16,
                Record::EndOfFile => ended = true,
                // Where a processor would start.
                Record::StartSegmentAddress { .. } | Record::StartLinearAddress(_) => {}
            }
        }
        if !ended {
            return Err(source.cut_off("the file ends without an end-of-file record"));
        }
        Ok(Self(records))
    }

    /// Whether the addresses can only be those of words: each record begins as many words behind the one before as that has.
    fn count_words(&self, word_bytes: usize) -> bool {
        let whole = self.0.iter().all(|(_, value, _)| value.len() % word_bytes == 0);
        let next = |two: &[(usize, Vec<u8>, Span)]| two[0].0 + two[0].1.len() / word_bytes == two[1].0;
        word_bytes > 1 && whole && self.0.len() > 1 && self.0.windows(2).all(next)
    }
}

/// Intel HEX: the addresses are those of bytes. Quartus' kind is told by its records, and text for `$readmemh`, which goes under the same
/// name, by the colon that it does not begin with.
pub(super) fn hex(source: &Source<'_>) -> Result<RomImage, Error> {
    if !source.text.trim_start().is_empty() && !source.text.trim_start().starts_with(':') {
        let allowed = RomFormat::Mem.sheet().allowed;
        let text = mem(&Source { text: source.text.clone(), allowed, ..*source });
        return text.map(|image| RomImage { kind: Some("text for $readmemh"), ..image }).map_err(|error| match error {
            Error::Text { what, text, at, .. } => Error::Text {
                what: format!("this is not an Intel HEX record, and no text for $readmemh: {what}"),
                allowed: source.allowed.to_owned(),
                text,
                at,
            },
            other => other,
        });
    }
    let word_bytes = word_bytes(source.word_bits);
    let records = Records::of(source)?;
    if records.count_words(word_bytes) {
        return words_by_address(source, &records);
    }
    let mut bytes: Vec<Option<(u8, Span)>> = Vec::new();
    for (first, value, span) in records.0 {
        for (byte, address) in value.into_iter().zip(first..) {
            if address >= MAX_DEPTH * word_bytes {
                let what = format!("the byte address 0x{address:x} is out of range");
                let allowed = format!("a ROM has at most {MAX_DEPTH} words, here of {word_bytes} bytes");
                return Err(source.error(what, allowed, span));
            }
            if address >= bytes.len() {
                bytes.resize(address + 1, None);
            }
            if bytes[address].replace((byte, span)).is_some() {
                let what = format!("a second byte for the byte address 0x{address:x}");
                return Err(source.error(what, "each byte is given once; in Quartus' .hex, each word", span));
            }
        }
    }
    if bytes.is_empty() {
        return Err(source.cut_off("the file has no words"));
    }
    let words = bytes.chunks(word_bytes).enumerate().map(|(address, bytes)| hex_word(source, address, bytes));
    words.collect::<Result<_, _>>().map(image)
}

/// Quartus' kind: the addresses are those of words, whose bytes are the most significant first.
pub(super) fn quartus_hex(source: &Source<'_>) -> Result<RomImage, Error> {
    words_by_address(source, &Records::of(source)?)
}

fn words_by_address(source: &Source<'_>, records: &Records) -> Result<RomImage, Error> {
    let word_bytes = word_bytes(source.word_bits);
    let mut words = Words::new(source);
    for (first, value, span) in &records.0 {
        if value.len() % word_bytes != 0 {
            let what = format!("the {} bytes of this record are not whole words", value.len());
            return Err(source.error(
                what,
                format!("a word of {} bits has {word_bytes} bytes", source.word_bits),
                *span,
            ));
        }
        for (address, bytes) in (*first..).zip(value.chunks(word_bytes)) {
            let word = BigUint::from_bytes_be(bytes);
            refuse_wide(source, &word, *span)?;
            words.place(address, word, *span, MAX_DEPTH)?;
        }
    }
    Ok(RomImage { kind: Some("Quartus' kind, whose addresses count words"), ..image(words.finish(None)?) })
}

/// The word of the given bytes, all of which must be there.
fn hex_word(source: &Source<'_>, address: usize, bytes: &[Option<(u8, Span)>]) -> Result<BigUint, Error> {
    let given: Vec<(u8, Span)> = bytes.iter().copied().flatten().collect();
    let word_bytes = word_bytes(source.word_bits);
    // A word without any byte has no record to point at.
    let span = given.last().map_or((source.text.len(), 0), |(_, span)| *span);
    if given.len() < word_bytes {
        let what = format!("the word at the address {address} has only {} of its {word_bytes} bytes", given.len());
        return Err(source.error(what, "every word is complete, from the address 0 to the last", span));
    }
    let word = BigUint::from_bytes_le(&given.iter().map(|(byte, _)| *byte).collect::<Vec<u8>>());
    refuse_wide(source, &word, span)?;
    Ok(word)
}
