use miette::SourceCode;
use proptest::prelude::*;

use super::*;
use crate::number::Format;
use crate::rom::{Field, RomFormat, Table};
use crate::spec::Shininess;

const NAMES: [&str; 4] = ["first", "second", "third", "fourth"];
const TEXT_FORMATS: [RomFormat; 7] =
    [RomFormat::Mem, RomFormat::Hex, RomFormat::Coe, RomFormat::Mif, RomFormat::Vhdl, RomFormat::C, RomFormat::Csv];

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
            Table::new(&set, fields.collect(), 0)
        })
    })
}

fn format() -> impl Strategy<Value = RomFormat> {
    prop::sample::select(RomFormat::ALL.to_vec())
}

fn written(table: &Table, format: RomFormat) -> Vec<u8> {
    write(table, format, "lobe", "0123abcd", "brdfgen rom --name lobe")
}

fn read_for(table: &Table, bytes: &[u8], format: RomFormat) -> Result<RomImage, crate::error::Error> {
    read(bytes, format, "file", table.word_bits())
}

/// Whether the report of an error can show the place that it names.
fn place_is_shown(error: &crate::error::Error) -> bool {
    match error {
        crate::error::Error::Text { text, at, .. } => text.read_span(at, 1, 1).is_ok(),
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
    Table::new(&Shininess::Range(10, 12), fields, 0)
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
    let table = Table::new(&Shininess::Range(1, 40_000), vec![field], 0);
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
        first_difference(&table, &RomImage { words, width: None, codes: Vec::new() }).map(|found| found.to_string())
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
    assert_eq!(refused("1 xx 2\n", RomFormat::Mem, 8), "`xx` is not a number of radix 16");
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
    assert_eq!(refused(&vector.replace("10", "8"), RomFormat::Coe, 8), "the radix `8` is not allowed");
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
        Err(crate::error::Error::Text { at, text, .. }) => {
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
    for format in TEXT_FORMATS {
        let bytes = written(&table, format);
        for kept in 0..bytes.trim_ascii_end().len() {
            let image = read_for(&table, &bytes[..kept], format);
            assert!(image.is_err() || image.is_ok_and(|i| first_difference(&table, &i).is_some()), "{format:?} {kept}");
        }
    }
}
