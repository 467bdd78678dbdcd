use brdfgen::emit::rom::{RomFormat, read};

use super::{refused, small_table, words, written};

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
        Err(brdfgen::platform::error::Error::Text { at, text, .. }) => {
            assert_eq!((at.offset(), at.len(), text.name()), (6, 2, "rom.mem"));
        }
        other => panic!("{other:?}"),
    }
}
