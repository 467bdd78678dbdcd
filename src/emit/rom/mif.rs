//! Intel's memory initialization files, and Xilinx' of the same name.

use std::fmt::Write as _;

use num_bigint::BigUint;

use super::source::{Comments, Cursor, Source, Span, Words, image, lines, shown};
use super::writing::{Writing, line, word_digits};
use super::{FileFormat, MAX_DEPTH, RomImage};
use crate::platform::error::Error;

pub(super) const MIF: FileFormat = FileFormat {
    about: "Intel memory initialization file: NAME.mif",
    suffix: ".mif",
    extensions: &["mif"],
    allowed: "Intel's .mif file has DEPTH, WIDTH, ADDRESS_RADIX and DATA_RADIX, each as in DEPTH = 256; then CONTENT \
              BEGIN, lines such as 0 : 1f; or [0..3] : 1f; and END; Xilinx' has a word of binary digits a line",
    is_text: true,
    read,
    write,
};

fn write(of: &Writing<'_>) -> Vec<u8> {
    let table = of.table;
    let (depth, width) = (table.depth(), table.word_bits());
    let mut text =
        format!("DEPTH = {depth};\nWIDTH = {width};\nADDRESS_RADIX = HEX;\nDATA_RADIX = HEX;\nCONTENT BEGIN\n");
    let digits = word_digits(table.address_bits);
    for (address, word) in of.hex_words().enumerate() {
        line!(text, "  {address:0digits$x} : {word};");
    }
    text += "END;\n";
    of.headed("--", "Intel memory initialization file", &text)
}

/// The settings in front of a .mif file's words.
#[derive(Default)]
struct Settings {
    depth: Option<usize>,
    width: Option<u32>,
    address_radix: Option<Radix>,
    data_radix: Option<Radix>,
}

#[derive(Clone, Copy)]
struct Radix {
    radix: u32,
    signed: bool,
}

impl Radix {
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

fn read(source: &Source<'_>) -> Result<RomImage, Error> {
    if lines(&source.text, &[]).next().is_some_and(|(line, _)| line.bytes().all(|digit| matches!(digit, b'0' | b'1'))) {
        return read_xilinx(source);
    }
    let mut cursor = source.tokens(&Comments::of("--", ("%", "%")))?;
    let settings = read_settings(source, &mut cursor)?;
    let begin = cursor.expect_word("BEGIN")?;
    if !begin.is_word("BEGIN") {
        cursor.next -= 1;
        return Err(cursor.unexpected("BEGIN"));
    }
    let missing = |name: &str| source.wrong(format!("{name} is not given before CONTENT"), begin.span);
    let depth = settings.depth.ok_or_else(|| missing("DEPTH"))?;
    let width = settings.width.ok_or_else(|| missing("WIDTH"))?;
    // Quartus takes hexadecimal for a radix that is not given.
    let hexadecimal = Radix { radix: 16, signed: false };
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
        let (first, last) = read_addresses(source, &mut cursor, address_radix)?;
        cursor.expect_symbol(":")?;
        let mut line = Vec::new();
        while line.is_empty() || !cursor.take_symbol(";") {
            line.push(read_word(source, &mut cursor, data_radix)?);
        }
        // A range repeats its words up to its end; a single address begins a run of them.
        let count = last.map_or(line.len(), |last| last - first + 1);
        for (address, (word, span)) in (first..first + count).zip(line.iter().cycle()) {
            words.place(address, word.clone(), *span, depth)?;
        }
    }
}

/// Xilinx' kind, which its core generators write for simulation: a line of binary digits for each word, as many as it
/// has bits.
fn read_xilinx(source: &Source<'_>) -> Result<RomImage, Error> {
    let mut words = Words::new(source);
    for (address, (line, span)) in lines(&source.text, &[]).enumerate() {
        let word = source.word(line, 2, span)?;
        if line.len() != source.word_bits as usize {
            let what = format!("this word has {} binary digits", line.len());
            return Err(source.wrong_width(what, span));
        }
        words.place(address, word, span, MAX_DEPTH)?;
    }
    Ok(RomImage { kind: Some("Xilinx' kind"), width: Some(source.word_bits), ..image(words.finish(None)?) })
}

fn read_settings(source: &Source<'_>, cursor: &mut Cursor<'_>) -> Result<Settings, Error> {
    let mut settings = Settings::default();
    loop {
        let key = cursor.expect_word("a setting or CONTENT")?;
        if key.is_word("CONTENT") {
            return Ok(settings);
        }
        cursor.expect_symbol("=")?;
        let value = cursor.expect_word("a value")?;
        let radix = || {
            let what = format!("the radix {} is not known", shown(value.text));
            Radix::of_name(value.text)
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
                source.check_width(number(usize::MAX)?, value.span)?;
                settings.width = Some(source.word_bits);
            }
            "ADDRESS_RADIX" => settings.address_radix = Some(radix()?),
            "DATA_RADIX" => settings.data_radix = Some(radix()?),
            _ => {
                let what = format!("{} is not a setting of a .mif file", shown(key.text));
                return Err(source.wrong(what, key.span));
            }
        }
        cursor.expect_symbol(";")?;
    }
}

/// One address, or the first and the last of a range such as `[0..3]`.
fn read_addresses(source: &Source<'_>, cursor: &mut Cursor<'_>, radix: u32) -> Result<(usize, Option<usize>), Error> {
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

fn read_word(source: &Source<'_>, cursor: &mut Cursor<'_>, radix: Radix) -> Result<(BigUint, Span), Error> {
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
