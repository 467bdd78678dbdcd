use miette::SourceCode;
use proptest::prelude::*;

use super::*;
use crate::emit::rom::RomFormat;
use crate::fixed::Format;
use crate::fixed::{Field, Table};
use crate::spec::Shininess;

const NAMES: [&str; 4] = ["first", "second", "third", "fourth"];

fn set() -> impl Strategy<Value = Shininess> {
    prop_oneof![
        (1u32..200, 0u32..40).prop_map(|(first, more)| Shininess::Range(first, first + more)),
        prop::collection::vec(1.0..1000.0f64, 1..20).prop_map(Shininess::List),
    ]
}

fn field_format() -> impl Strategy<Value = Format> {
    // The wide ones take more than 64 bits.
    let bits = prop_oneof![6 => 2i32..=34, 1 => 2i32..=100, 1 => Just(1)];
    (any::<bool>(), bits, -20i32..=20).prop_map(|(signed, bits, int_bits)| Format {
        signed,
        int_bits,
        frac_bits: bits - int_bits,
    })
}

/// Tables of words of 1 to 140 bits.
fn table() -> impl Strategy<Value = Table> {
    (set(), prop::collection::vec(field_format(), 1..=NAMES.len())).prop_flat_map(|(set, mut formats)| {
        while formats.iter().map(|format| format.width()).sum::<u32>() > 140 {
            formats.pop();
        }
        let values = prop::collection::vec((any::<i128>(), -1e3..1e3f64), set.rows() * formats.len());
        values.prop_map(move |values| {
            let columns = formats.iter().zip(NAMES).zip(values.chunks(set.rows()));
            let fields = columns.map(|((&format, name), column)| Field {
                name,
                meaning: "coefficient",
                format,
                codes: column.iter().map(|(code, _)| format.wrap(*code)).collect(),
                reals: column.iter().map(|(_, real)| *real).collect(),
            });
            set.rom(fields.collect(), 0)
        })
    })
}

fn format() -> impl Strategy<Value = RomFormat> {
    prop::sample::select(RomFormat::ALL.to_vec())
}

fn written(table: &Table, format: RomFormat) -> Vec<u8> {
    write(table, format, "lobe", "0123abcd", "brdfgen rom --name lobe")
}

fn read_for(table: &Table, bytes: &[u8], format: RomFormat) -> Result<RomImage, crate::platform::error::Error> {
    read(bytes, format, "file", table.word_bits())
}

/// Whether the report of an error can show the place that it names.
fn place_is_shown(error: &crate::platform::error::Error) -> bool {
    match error {
        crate::platform::error::Error::Text { text, at, .. } => text.read_span(at, 1, 1).is_ok(),
        _ => true,
    }
}

/// The words of a text, or what its error says.
fn words(text: &str, format: RomFormat, bits: u32) -> Result<Vec<u32>, String> {
    let image = read(text.as_bytes(), format, "file", bits).map_err(|error| error.to_string())?;
    Ok(image.words.iter().map(|word| word.try_into().expect("short words")).collect())
}

fn refused(text: &str, format: RomFormat, bits: u32) -> String {
    words(text, format, bits).expect_err("must be refused")
}

/// A table of two fields of four and eight bits for the shininesses 2 to 4.
fn small_table() -> Table {
    let field = |name, format: Format, codes: [i128; 3]| Field {
        name,
        meaning: "coefficient",
        format,
        codes: codes.to_vec(),
        reals: codes.iter().map(|&code| format.value(code)).collect(),
    };
    let fields =
        vec![field("high", Format::unsigned(0, 4), [1, 2, 3]), field("low", Format::signed(3, 4), [-1, 0x7f, 0])];
    Shininess::Range(10, 12).rom(fields, 0)
}

proptest! {
    #[test]
    fn what_is_written_is_read_back(table in table(), format in format()) {
        let bytes = written(&table, format);
        let image = read_for(&table, &bytes, format).expect("a file of ours");
        prop_assert_eq!(&image.words, &table.words());
        prop_assert_eq!(first_difference(&table, &image), None);
        if format != RomFormat::Bin {
            prop_assert!(bytes.is_ascii() && bytes.ends_with(b"\n") && !bytes.contains(&b'\r'));
        }
        if format == RomFormat::Csv {
            prop_assert_eq!(image.codes.len(), table.fields.len());
        }
        let longest = String::from_utf8_lossy(&bytes).lines().map(str::len).max();
        prop_assert!(format != RomFormat::Vhdl || longest <= Some(100));
    }

    #[test]
    fn one_wrong_bit_is_found(
        table in table(),
        format in format(),
        row in any::<prop::sample::Index>(),
        field in any::<prop::sample::Index>(),
        bit in any::<prop::sample::Index>(),
    ) {
        let (row, field) = (row.index(table.rows()), field.index(table.fields.len()));
        // Rows that no address selects do not exist: every row has one.
        let address = (0..table.depth()).find(|&address| table.row_of_address(address) == row).expect("an address");
        let mut wrong = table.clone();
        let kept = wrong.fields[field].format;
        let flipped = wrong.fields[field].codes[row] ^ (1 << bit.index(kept.width() as usize));
        wrong.fields[field].codes[row] = kept.wrap(flipped);
        let image = read_for(&table, &written(&wrong, format), format).expect("a file of ours");
        let difference = first_difference(&table, &image).expect("one bit differs");
        prop_assert_eq!(difference.address, address);
        prop_assert_eq!(difference.key, Some(("shininess", table.keys[row])));
        prop_assert_eq!(difference.field, Some(table.fields[field].name));
        prop_assert_eq!(difference.codes, Some((table.fields[field].codes[row], wrong.fields[field].codes[row])));
        prop_assert_eq!((difference.expected, difference.found), (Some(table.word(address)), Some(wrong.word(address))));
    }

    #[test]
    fn a_truncated_file_is_noticed(table in table(), format in format(), at in any::<prop::sample::Index>()) {
        let bytes = written(&table, format);
        let (kept, lost) = bytes.split_at(at.index(bytes.len()));
        // Without its last line feed a text is still complete.
        if format == RomFormat::Bin || !lost.trim_ascii().is_empty() {
            let noticed = match read_for(&table, kept, format) {
                Ok(image) => first_difference(&table, &image).is_some(),
                Err(_) => true,
            };
            prop_assert!(noticed);
        }
    }

    #[test]
    fn a_damaged_file_is_no_panic(
        table in table(),
        format in format(),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>(), 0u8..3), 1..6),
    ) {
        let mut bytes = written(&table, format);
        for (at, byte, kind) in changes {
            // A small table's file is long enough for all of them.
            let at = at.index(bytes.len());
            match kind {
                0 => bytes[at] = byte,
                1 => bytes.insert(at, byte),
                _ => bytes.truncate(at.max(1)),
            }
        }
        match read_for(&table, &bytes, format) {
            Ok(image) => drop(first_difference(&table, &image).map(|difference| difference.to_string())),
            Err(error) => prop_assert!(place_is_shown(&error)),
        }
    }

    #[test]
    fn arbitrary_bytes_are_no_panic(bytes in prop::collection::vec(any::<u8>(), 0..300), bits in 0u32..150) {
        for format in RomFormat::ALL {
            let shown = read(&bytes, format, "file", bits).err().is_none_or(|error| place_is_shown(&error));
            prop_assert!(shown);
        }
    }

    #[test]
    fn arbitrary_syntax_is_no_panic(
        parts in prop::collection::vec(
            prop::sample::select(vec![
                "0", "1f", "-", "@", ",", ";", ":", "..", "=", "=>", "(", ")", "{", "}", "[", "]", "\"01\"", "x", "\"", "%",
                "//", "/*", "*/", "--", "\n", " ", "#", "BEGIN", "END", "CONTENT", "DEPTH", "WIDTH", "é", "\u{feff}",
                ":= (", "= {", "address,word\n", "memory_initialization_radix=16;", "memory_initialization_vector=",
                "DEPTH=2;WIDTH=8;CONTENT BEGIN", "ffffffffffffffffffff", ":00000001FF", ":02000004FFFFFC",
            ]),
            0..30,
        ),
        bits in 0u32..150,
    ) {
        for format in RomFormat::ALL {
            let image = read(parts.concat().as_bytes(), format, "file", bits);
            prop_assert!(image.err().is_none_or(|error| place_is_shown(&error)));
        }
    }
}

#[test]
fn names_lead_to_formats() {
    for format in RomFormat::ALL {
        let name = format.file_name("lobe", &small_table());
        assert_eq!(RomFormat::of_file(name.as_ref()).expect("a name of ours"), format, "{name}");
    }
    assert!(RomFormat::of_file("lobe.txt".as_ref()).is_err() && RomFormat::of_file("lobe".as_ref()).is_err());
}

#[test]
fn the_heading_says_what_the_file_is() {
    let text = String::from_utf8(written(&small_table(), RomFormat::Mem)).expect("ASCII");
    let expected = "\
// ROM of the core lobe: words for $readmemh.
// Made by `brdfgen rom --name lobe`.
// spec 0123abcd
// 4 words of 12 bits, one for each address. Layout of a word:
//   [11:8]  high  UQ0.4  coefficient
//   [7:0]   low   Q3.4   coefficient
1ff
27f
300
300
";
    assert_eq!(text, expected);
}

#[test]
fn a_deep_rom_passes_64_kib() {
    let codes: Vec<i128> = (0..40_000).map(|row| row * 7 % 65_536).collect();
    let reals = codes.iter().map(|&code| code as f64).collect();
    let field = Field { name: "only", meaning: "", format: Format::unsigned(17, 0), codes, reals };
    let table = Shininess::Range(1, 40_000).rom(vec![field], 0);
    for format in RomFormat::ALL {
        let image = read_for(&table, &written(&table, format), format).expect("a file of ours");
        assert_eq!(first_difference(&table, &image), None, "{format:?}");
    }
}

#[test]
fn differences_are_one_sentence() {
    let table = small_table();
    let sentence = |words: &[u32]| {
        let words = words.iter().map(|&word| BigUint::from(word)).collect();
        first_difference(&table, &RomImage { words, kind: None, width: None, codes: Vec::new() })
            .map(|found| found.to_string())
    };
    let right = [0x1ff, 0x27f, 0x300, 0x300];
    assert_eq!(sentence(&right), None);
    assert_eq!(
        sentence(&[0x1ff, 0x27e, 0x300, 0x301]).as_deref(),
        Some(
            "address 1 (shininess 11): the word is 0x27e and should be 0x27f; the first field that differs is low, with \
             the code 126 in place of 127"
        )
    );
    assert_eq!(
        sentence(&right[..3]).as_deref(),
        Some("address 3 (shininess 12): the file ends before this word, 0x300")
    );
    assert_eq!(
        sentence(&[0x1ff, 0x27f, 0x300, 0x300, 5]).as_deref(),
        Some("address 4: the file has the word 0x005 beyond the last address, 3")
    );
    let csv = String::from_utf8(written(&table, RomFormat::Csv)).expect("ASCII").replacen(",-1,", ",-2,", 1);
    let image = read_for(&table, csv.as_bytes(), RomFormat::Csv).expect("a correct file");
    assert_eq!(
        first_difference(&table, &image).expect("a wrong code").to_string(),
        "address 0 (shininess 10): the word 0x1ff is right but the column low_code beside it has -2 in place of -1"
    );
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
fn coe_of_other_tools() {
    let text = "; a comment\nMemory_Initialization_Radix = 2 ;\n;another\nmemory_initialization_vector = 01 10,\n; inside\n11\n;\n";
    assert_eq!(words(text, RomFormat::Coe, 8), Ok(vec![1, 2, 3]));
    let vector = "memory_initialization_radix=10;\nmemory_initialization_vector=1,2";
    assert_eq!(words(&format!("{vector}55;"), RomFormat::Coe, 8), Ok(vec![1, 255]));
    assert_eq!(refused(&format!("{vector}56;"), RomFormat::Coe, 8), "`256` is too wide");
    assert_eq!(refused(vector, RomFormat::Coe, 8), "the file ends where `,` or `;` is expected");
    assert_eq!(refused(&vector.replace("10", "7"), RomFormat::Coe, 8), "the radix `7` is not allowed");
}

/// By AMD UG896: text behind a semicolon is a comment, keywords are in any case, and those behind the vector are not read.
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
        Err("the file ends where memory_initialization_radix or memory_initialization_vector is expected".to_owned())
    );
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
fn xilinx_mif_is_told_by_its_digits() {
    let words = |text: &str| words(text, RomFormat::Mif, 4);
    assert_eq!(words("0001\n1010\r\n\n1111"), Ok(vec![1, 10, 15]));
    assert_eq!(words("0001\n101\n"), Err("this word has 3 binary digits".to_owned()));
    assert_eq!(words("0001\n10100\n"), Err("`10100` is too wide".to_owned()));
    assert_eq!(words("0001\n0201\n"), Err("`0201` is not a number of radix 2".to_owned()));
}

#[test]
fn hex_files_of_three_kinds_are_told_apart() {
    let quartus = ":020000000102FB\n:020001000304F6\n:00000001FF\n";
    let kind = |text: &str, format, bits| {
        let image = read(text.as_bytes(), format, "file", bits).expect("a file of this kind");
        (image.words.iter().map(|word| u32::try_from(word).expect("short words")).collect::<Vec<u32>>(), image.kind)
    };
    for format in [RomFormat::Hex, RomFormat::QuartusHex] {
        let (words, kind) = kind(quartus, format, 16);
        assert_eq!((words, kind), (vec![0x102, 0x304], Some("Quartus' kind, whose addresses count words")));
    }
    // Bytes are the same in both.
    let bytes = ":020000000102FB\n:00000001FF\n";
    assert_eq!(kind(bytes, RomFormat::Hex, 8), (vec![1, 2], None));
    assert_eq!(kind(bytes, RomFormat::QuartusHex, 8).0, [1, 2]);
    assert_eq!(kind("// words\n0001 @1 0002\n", RomFormat::Hex, 16), (vec![1, 2], Some("text for $readmemh")));
    assert_eq!(
        refused("no hex\n", RomFormat::Hex, 16),
        "this is not an Intel HEX record, and no text for $readmemh: `no` is not a number of radix 16"
    );
    assert_eq!(refused(quartus, RomFormat::Mem, 16), "this is an Intel HEX record, and no text for $readmemh");
    assert_eq!(refused(quartus, RomFormat::QuartusHex, 24), "the 2 bytes of this record are not whole words");
    assert_eq!(refused(quartus, RomFormat::QuartusHex, 9), "the word 0x304 is too wide");
    assert_eq!(refused(":00000001FF\n", RomFormat::QuartusHex, 9), "the file has no words");
}

/// What editors and check-outs do to a text changes no word of any format.
#[test]
fn byte_order_marks_and_line_ends_are_read_over() {
    let table = small_table();
    for format in RomFormat::ALL.into_iter().filter(|&format| format != RomFormat::Bin) {
        let text = String::from_utf8(written(&table, format)).expect("ASCII");
        for changed in [
            format!("\u{feff}{text}"),
            text.replace('\n', "\r\n"),
            text.replace('\n', "\r"),
            format!("\u{feff}{}", text.replace('\n', "\r\n")),
        ] {
            let image = read_for(&table, changed.as_bytes(), format).expect("the same text");
            assert_eq!(first_difference(&table, &image), None, "{format:?}");
        }
        let wide: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
        let refused = read_for(&table, &wide, format).expect_err("UTF-16").to_string();
        assert_eq!(refused, "file is UTF-16 text", "{format:?}");
    }
}

#[test]
fn files_are_known_by_their_names() {
    let named = |name: &str| RomFormat::of_file(name.as_ref());
    for (name, format) in [
        ("a.MEM", RomFormat::Mem),
        ("a.vmem", RomFormat::Mem),
        ("a_plain.mem", RomFormat::MemPlain),
        ("a.hex", RomFormat::Hex),
        ("a_quartus.hex", RomFormat::QuartusHex),
        ("a.vhdl", RomFormat::Vhdl),
        ("a.h", RomFormat::C),
    ] {
        assert_eq!(named(name).expect(name), format, "{name}");
    }
    let Err(crate::platform::error::Error::Input { what, allowed }) = named("a.dat") else { panic!("it says nothing") };
    assert_eq!(what, "a.dat: the name does not say which ROM format this is");
    assert!(allowed.contains("--format") && allowed.contains(".mem, .vmem"), "{allowed}");
}

#[test]
fn plain_words_are_all_that_a_plain_file_has() {
    assert_eq!(written(&small_table(), RomFormat::MemPlain), b"1ff\n27f\n300\n300\n");
    assert_eq!(
        written(&small_table(), RomFormat::QuartusHex),
        b":0200000001FFFE\n:02000100027F7C\n:020002000300F9\n:020003000300F8\n:00000001FF\n"
    );
}

#[test]
fn mif_of_other_tools() {
    let settings = "% a\ncomment % width=8; depth=8; address_radix=uns; data_radix=dec;\ncontent\nbegin\n";
    let text = format!("{settings}[0..3] : 1 -1; -- a range\n4 : 5 6 7;7:-128;\nEND;");
    assert_eq!(words(&text, RomFormat::Mif, 8), Ok(vec![1, 255, 1, 255, 5, 6, 7, 128]));
    let content = |lines: &str| refused(&format!("{settings}{lines} END;"), RomFormat::Mif, 8);
    assert_eq!(content("[0..7]:1; 7:2;"), "a second word for the address 7");
    assert_eq!(content("[0..8]:1;"), "this word's address, 8, is out of range");
    assert_eq!(content("[0..6]:1;"), "there is no word for the address 7: the file says that it has 8 words");
    assert_eq!(content("[0..7]:-129;"), "`-129` is out of range");
    assert_eq!(refused(settings, RomFormat::Mif, 9), "the file states words of 8 bits");
    assert_eq!(refused("WIDTH=8; CONTENT BEGIN 0:1; END;", RomFormat::Mif, 8), "DEPTH is not given before CONTENT");
}

#[test]
fn vhdl_of_other_tools() {
    let package =
        |words: &str| format!("package p is\n constant N : positive := 2;\n constant C : t := ({words});\nend;");
    let text = package(
        "x\"0F\", -- first\n 1 => 8x\"1_1\", 3 => \"0000\" & b\"0011\", 2 => 2x\"1\" & \"0\" & UX\"1\" & o\"0\"",
    );
    let text = text.replace("o\"0\"", "\"0\"");
    assert_eq!(words(&text, RomFormat::Vhdl, 8), Ok(vec![15, 17, 0b0100_0010, 3]));
    assert_eq!(refused(&package("\"0101\""), RomFormat::Vhdl, 8), "the word has 4 bits");
    assert_eq!(refused(&package("x\"0f\" & \"1\""), RomFormat::Vhdl, 8), "the word has more than 8 bits");
    assert_eq!(refused(&package("\"0000000X\""), RomFormat::Vhdl, 8), "`0000000X` is not a number of radix 2");
    assert_eq!(
        refused("package p is end;", RomFormat::Vhdl, 8),
        "the file has no constant array, which begins with `:= (`"
    );
}

#[test]
fn c_of_other_tools() {
    let text = "#pragma once\nunsigned t[] = { 0x1F, 31u, 0b11, 017L };";
    assert_eq!(words(text, RomFormat::C, 8), Ok(vec![31, 31, 3, 15]));
    assert_eq!(words("int t[N][2]={{1,0,},{0xFFFFFFFF,0}};", RomFormat::C, 40), Ok(vec![1, u32::MAX]));
    assert_eq!(refused("int t[]={{1,1}};", RomFormat::C, 32), "the word 0x100000001 is too wide");
    assert_eq!(
        refused("int t[3]={1,2};", RomFormat::C, 8),
        "there is no word for the address 2: the file says that it has 3 words"
    );
    assert_eq!(refused("int t[1]={1,2};", RomFormat::C, 8), "this word's address, 1, is out of range");
}

#[test]
fn csv_of_other_tools() {
    let text = "\"address\",note,word\r\n1,b,0X1f\r\n0,\"a\",2\r\n";
    assert_eq!(words(text, RomFormat::Csv, 8), Ok(vec![2, 31]));
    assert_eq!(refused("address,word\n0\n", RomFormat::Csv, 8), "the number of cells in this row is 1");
    assert_eq!(
        refused("address;word\n0;1\n", RomFormat::Csv, 8),
        "columns are separated by commas and this has semicolons"
    );
    assert_eq!(refused("address,a_real,word\n0,1e999,1\n", RomFormat::Csv, 8), "`1e999` is not a finite number");
    assert_eq!(refused("address\n0\n", RomFormat::Csv, 8), "the header row has not one column `word`");
    assert_eq!(refused("address,a_code,word\n0,1.5,1\n", RomFormat::Csv, 8), "`1.5` is not an integer");
}

#[test]
fn whole_bytes_of_other_tools() {
    let hex = ":020000021000EC\n:020000040000FA\r\n:0400000001020304F2\n\n:00000001FF\n";
    assert_eq!(words(hex, RomFormat::Hex, 16), Ok(vec![0x201, 0x403]));
    assert_eq!(refused(hex, RomFormat::Hex, 10), "the word 0x403 is too wide");
    assert_eq!(refused(hex, RomFormat::Hex, 24), "the word at the address 1 has only 1 of its 3 bytes");
    assert_eq!(
        refused(&hex.replace("F2", "F3"), RomFormat::Hex, 16),
        "the checksum of this record is F3 and should be F2"
    );
    let raw = |bytes: &[u8], bits| read(bytes, RomFormat::Bin, "f.bin", bits).map_err(|error| error.to_string());
    assert_eq!(raw(&[1, 2, 3], 16), Err("f.bin: 3 bytes are not a whole number of words".to_owned()));
    assert_eq!(raw(&[1, 2, 3, 4], 10), Err("f.bin: the word 0x403 at the address 1, byte 2, is too wide".to_owned()));
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

#[test]
fn every_truncation_of_a_small_text_is_noticed() {
    let mut table = small_table();
    // The value of this last word does not tell how many of its digits are left.
    table.fields[0].codes[2] = 0;
    for format in RomFormat::ALL.into_iter().filter(|&format| format != RomFormat::Bin) {
        let bytes = written(&table, format);
        for kept in 0..bytes.trim_ascii_end().len() {
            let image = read_for(&table, &bytes[..kept], format);
            assert!(image.is_err() || image.is_ok_and(|i| first_difference(&table, &i).is_some()), "{format:?} {kept}");
        }
    }
}
