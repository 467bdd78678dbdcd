//! Text for `$readmemh`, with comments and without, and Lattice's memory files.

use super::source::{Comments, Source, Words, image, lines, shown};
use super::writing::Writing;
use super::{FileFormat, MAX_DEPTH, RomImage};
use crate::platform::error::Error;

pub(super) const MEM: FileFormat = FileFormat {
    about: "Hexadecimal words for `$readmemh`: NAME.mem",
    suffix: ".mem",
    extensions: &["mem", "vmem", "memh"],
    allowed: "a .mem file has hexadecimal words separated by white space, @ADDRESS in hexadecimal, and // or /* */ \
              comments; or Lattice's header from #Format= to #Data and its lines",
    is_text: true,
    read,
    write: |of| of.headed("//", "words for $readmemh", &words(of)),
};

pub(super) const MEM_PLAIN: FileFormat = FileFormat {
    about: "As mem, without comments, as Vivado's synthesis wants it: NAME_plain.mem",
    suffix: "_plain.mem",
    extensions: &[],
    allowed: "a .mem file has hexadecimal words separated by white space, and @ADDRESS in hexadecimal",
    is_text: true,
    read,
    write: |of| words(of).into_bytes(),
};

fn words(of: &Writing<'_>) -> String {
    of.hex_words().fold(String::new(), |text, word| text + &word + "\n")
}

/// What `$readmemh` takes (IEEE 1364-2005, 17.2.9), or Lattice's kind where the file begins with its header.
fn read(source: &Source<'_>) -> Result<RomImage, Error> {
    if source.text.trim_start().starts_with('#') {
        return lattice(source);
    }
    let mut cursor = source.tokens(&Comments::of("//", ("/*", "*/")))?;
    let mut words = Words::new(source);
    let mut address = 0;
    while let Some(next) = cursor.peek(0) {
        if next.is_symbol(":") && words.is_empty() {
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
        let word = words.read(token.text, 16, token.span)?;
        words.place(address, word, token.span, MAX_DEPTH)?;
        address += 1;
    }
    words.finish(None).map(image)
}

/// What Lattice's header says.
struct Lattice {
    radix: u32,
    /// Whether each line begins with an address.
    addressed: bool,
    depth: usize,
    width: u32,
    /// Where its last line ends.
    end: usize,
}

impl Lattice {
    fn of(source: &Source<'_>) -> Result<Self, Error> {
        let (mut form, mut depth, mut stated_width) = (None, None, None);
        let missing = |what: &str| source.cut_off(format!("{what} is not given in Lattice's header"));
        for (line, span) in lines(&source.text, &[]) {
            let wrong = |what: String| source.wrong(what, span);
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
                        return Err(wrong(format!(
                            "the file states {stated} words, where 1 to {MAX_DEPTH} are allowed"
                        )));
                    }
                    depth = Some(stated);
                }
                "width" => {
                    let width = number()?;
                    source.check_width(width as usize, span)?;
                    stated_width = Some(width);
                }
                // How Lattice's tools show them; the data are as the format says.
                "addrradix" | "dataradix" => drop(number()?),
                "data" => {
                    let (radix, addressed) = form.ok_or_else(|| missing("#Format"))?;
                    let depth = depth.ok_or_else(|| missing("#Depth"))?;
                    let width = stated_width.ok_or_else(|| missing("#Width"))?;
                    return Ok(Self { radix, addressed, depth, width, end: span.0 + span.1 });
                }
                _ => return Err(wrong(format!("{} is no line of Lattice's header", shown(line)))),
            }
        }
        Err(missing("#Data"))
    }
}

/// Lattice's memory file: a header from `#Format=` to `#Data`, then a word a line, in hexadecimal or binary; or
/// `ADDRESS: WORD WORD`, all in hexadecimal. Comments begin with `#` or `//`; a word that is not given is 0.
fn lattice(source: &Source<'_>) -> Result<RomImage, Error> {
    let Lattice { radix, addressed, depth, width, end } = Lattice::of(source)?;
    let mut words = Words::new(source);
    let mut address = 0;
    for (line, (at, _)) in lines(&source.text[end..], &["#", "//"]) {
        let offset = |part: &str| end + at + (part.as_ptr() as usize - line.as_ptr() as usize);
        let mut rest = line;
        if addressed {
            let Some((before, after)) = line.split_once(':') else {
                return Err(source.wrong("there is no address and colon", (end + at, line.len())));
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
            let word = words.read(word, radix, span)?;
            words.place(address, word, span, depth)?;
            address += 1;
        }
    }
    // What is not addressed is 0; where words are not addressed, a missing one has been cut off.
    let words = if addressed { words.filled(depth)? } else { words.finish(Some(depth))? };
    Ok(RomImage { kind: Some("with Lattice's header"), width: Some(width), ..image(words) })
}
