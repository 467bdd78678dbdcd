//! What holds of every format.

mod bin;
mod c;
mod coe;
mod csv;
mod hex;
mod mem;
mod mif;
mod vhdl;

use brdfgen::emit::rom::*;
use brdfgen::fixed::Format;
use brdfgen::fixed::{Field, Table};
use brdfgen::platform::error::Error;
use miette::SourceCode;
use num_bigint::BigUint;
use proptest::prelude::*;

const NAMES: [&str; 4] = ["first", "second", "third", "fourth"];

/// A coefficient ROM with a row for each shininess.
fn rom(keys: Vec<f64>, fields: Vec<Field>) -> Table {
    Table::listed(Table::COEFFICIENTS, "shininess", keys, fields)
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
    let keys = prop::collection::vec(1.0..1000.0f64, 1..40);
    (keys, prop::collection::vec(field_format(), 1..=NAMES.len())).prop_flat_map(|(keys, mut formats)| {
        while formats.iter().map(|format| format.width()).sum::<u32>() > 140 {
            formats.pop();
        }
        let values = prop::collection::vec((any::<i128>(), -1e3..1e3f64), keys.len() * formats.len());
        values.prop_map(move |values| {
            let columns = formats.iter().zip(NAMES).zip(values.chunks(keys.len()));
            let fields = columns.map(|((&format, name), column)| Field {
                name,
                meaning: "coefficient",
                format,
                codes: column.iter().map(|(code, _)| format.wrap(*code)).collect(),
                reals: column.iter().map(|(_, real)| *real).collect(),
            });
            rom(keys.clone(), fields.collect())
        })
    })
}

fn format() -> impl Strategy<Value = RomFormat> {
    prop::sample::select(RomFormat::ALL.to_vec())
}

pub(super) fn written(table: &Table, format: RomFormat) -> Vec<u8> {
    write(table, format, "lobe", "0123abcd", "brdfgen rom --name lobe")
}

fn read_for(table: &Table, bytes: &[u8], format: RomFormat) -> Result<RomImage, Error> {
    read(bytes, format, "file", table.word_bits())
}

/// Whether the report of an error can show the place that it names.
fn place_is_shown(error: &Error) -> bool {
    match error {
        Error::Text { text, at, .. } => text.read_span(at, 1, 1).is_ok(),
        _ => true,
    }
}

/// The words of a text, or what its error says.
pub(super) fn words(text: &str, format: RomFormat, bits: u32) -> Result<Vec<u32>, String> {
    let image = read(text.as_bytes(), format, "file", bits).map_err(|error| error.to_string())?;
    Ok(image.words.iter().map(|word| word.try_into().expect("short words")).collect())
}

pub(super) fn refused(text: &str, format: RomFormat, bits: u32) -> String {
    words(text, format, bits).expect_err("must be refused")
}

/// A table of two fields of four and eight bits for the shininesses 2 to 4.
pub(super) fn small_table() -> Table {
    let field = |name, format: Format, codes: [i128; 3]| Field {
        name,
        meaning: "coefficient",
        format,
        codes: codes.to_vec(),
        reals: codes.iter().map(|&code| format.value(code)).collect(),
    };
    let fields =
        vec![field("high", Format::unsigned(0, 4), [1, 2, 3]), field("low", Format::signed(3, 4), [-1, 0x7f, 0])];
    rom(vec![10.0, 11.0, 12.0], fields)
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
        prop_assert_eq!(difference.expected, Some(table.word(address)));
        prop_assert_eq!(difference.found, Some(wrong.word(address)));
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
                "0", "1f", "-", "@", ",", ";", ":", "..", "=", "=>", "(", ")", "{", "}", "[", "]", "\"01\"", "x", "\"",
                "%", "//", "/*", "*/", "--", "\n", " ", "#", "BEGIN", "END", "CONTENT", "DEPTH", "WIDTH", "é",
                "\u{feff}", ":= (",
                "= {", "address,word\n", "memory_initialization_radix=16;", "memory_initialization_vector=",
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
fn a_deep_rom_passes_64_kib() {
    let codes: Vec<i128> = (0..40_000).map(|row| row * 7 % 65_536).collect();
    let reals = codes.iter().map(|&code| code as f64).collect();
    let field = Field { name: "only", meaning: "", format: Format::unsigned(17, 0), codes, reals };
    let table = rom((1..=40_000).map(f64::from).collect(), vec![field]);
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
            "address 1 (shininess 11): the word is 0x27e and should be 0x27f; the first field that differs is low, \
             with the code 126 in place of 127"
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
    let Err(Error::Input { what, allowed }) = named("a.dat") else { panic!("it says nothing") };
    assert_eq!(what, "a.dat: the name does not say which ROM format this is");
    assert!(allowed.contains("--format") && allowed.contains(".mem, .vmem"), "{allowed}");
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
