//! Text for `$readmemh`, with comments and without, and Lattice's memory files.

use super::source::{Comments, Source, Words, image, lines, shown};
use super::writing::Writing;
use super::{FileFormat, MAX_DEPTH, RomImage};
use crate::platform::error::Error;

pub(super) const MEM: FileFormat = FileFormat {
    about: "Hexadecimal words for `$readmemh`: NAME.mem",
    suffix: ".mem",
    extensions: &["mem", "vmem", "memh"],
    allowed: "a .mem file has hexadecimal words separated by white space, @ADDRESS in hexadecimal, and // or /* */ comments; \
              or Lattice's header from #Format= to #Data and its lines",
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

#[cfg(test)]
mod tests {
    use super::super::tests::{refused, small_table, words, written};
    use super::super::{RomFormat, read};

    #[test]
    fn the_heading_says_what_the_file_is() {
        let text = String::from_utf8(written(&small_table(), RomFormat::Mem)).expect("ASCII");
        let expected = "\
            // ROM of the core lobe: words for $readmemh.\n\
            // Made by `brdfgen rom --name lobe`.\n\
            // spec 0123abcd\n\
            // 4 words of 12 bits, one for each address. Layout of a word:\n\
            //   [11:8]  high  UQ0.4  coefficient\n\
            //   [7:0]   low   Q3.4   coefficient\n\
            1ff\n\
            27f\n\
            300\n\
            300\n";
        assert_eq!(text, expected);
    }

    #[test]
    fn plain_words_are_all_that_a_plain_file_has() {
        assert_eq!(written(&small_table(), RomFormat::MemPlain), b"1ff\n27f\n300\n300\n");
    }

    #[test]
    fn mem_of_other_tools() {
        let text = "/* a\ncomment */ @2 A_b\t0C // end\r\n@0 1 2";
        assert_eq!(words(text, RomFormat::Mem, 8), Ok(vec![1, 2, 0xab, 0xc]));
        assert_eq!(refused("1 100 2\n", RomFormat::Mem, 8), "`100` is too wide");
        assert_eq!(refused("1 xx 2\n", RomFormat::Mem, 8), "`xx` has digits without a value");
        assert_eq!(refused("1 @0 2\n", RomFormat::Mem, 8), "a second word for the address 0");
        assert_eq!(refused("1 @4 2\n", RomFormat::Mem, 8), "there is no word for the address 1; the next one is for 4");
        assert_eq!(refused("@10000 2\n", RomFormat::Mem, 8), "the address `10000` is out of range");
        assert_eq!(
            refused("0a 0b 0", RomFormat::Mem, 8),
            "the file ends within a word: it has fewer than the 2 digits of the others"
        );
        assert_eq!(refused("// none\n", RomFormat::Mem, 8), "the file has no words");
        assert_eq!(refused("0a /* 0b", RomFormat::Mem, 8), "the file ends within the comment that begins here with /*");
    }

    #[test]
    fn lattice_mem_as_its_manual_has_it() {
        let header = |form: &str| format!("#Format={form}\n#Depth=4\n#Width=8\n#AddrRadix=3\n#DataRadix=3\n#Data\n");
        let words = |text: &str| words(text, RomFormat::Mem, 8);
        assert_eq!(words(&(header("Hex") + "3B\n# a comment\n0a // another\r\n1\n\nff\n")), Ok(vec![0x3b, 10, 1, 255]));
        assert_eq!(words(&(header("bin") + "11011\n11111010 # one\n0\n1\n")), Ok(vec![27, 250, 0, 1]));
        assert_eq!(words(&(header("AddrHex") + "1:03 F3\n3: 4F # the last\n")), Ok(vec![0, 3, 0xf3, 0x4f]));
        let image = read(header("AddrHex").as_bytes(), RomFormat::Mem, "file", 8).expect("none is given");
        assert_eq!((image.words.len(), image.width, image.kind), (4, Some(8), Some("with Lattice's header")));
        for (text, expected) in [
            (header("Hex") + "1\n2\n3\n", "there is no word for the address 3: the file says that it has 4 words"),
            (header("Hex") + "1\n2\n3\n4\n5\n", "this word's address, 4, is out of range"),
            (header("Hex") + "1 2\n", "a second word in a line"),
            (header("Hex") + "100\n", "`100` is too wide"),
            (header("Bin") + "2\n", "`2` is not a number of radix 2"),
            (header("AddrHex") + "1 2\n", "there is no address and colon"),
            (header("AddrHex") + "1:2\n0:5 6\n", "a second word for the address 1"),
            (header("Oct"), "the format `Oct` is not Bin, Hex or AddrHex"),
            (header("Hex").replace("Width=8", "Width=9"), "the file states words of 9 bits"),
            (header("Hex").replace("#Depth=4\n", ""), "#Depth is not given in Lattice's header"),
            (
                header("Hex").replace("#Data\n", "") + "1\n",
                "`1` stands where a line of Lattice's header is expected, up to #Data",
            ),
            ("# a comment\n1\n".to_owned(), "`# a comment` is no line of Lattice's header"),
        ] {
            assert_eq!(words(&text), Err(expected.to_owned()), "{text}");
        }
    }

    #[test]
    fn the_place_of_an_error_is_given() {
        let text = "00\n01\nzz\n";
        match read(text.as_bytes(), RomFormat::Mem, "rom.mem", 8) {
            Err(crate::platform::error::Error::Text { at, text, .. }) => {
                assert_eq!((at.offset(), at.len(), text.name()), (6, 2, "rom.mem"));
            }
            other => panic!("{other:?}"),
        }
    }
}
