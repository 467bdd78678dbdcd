use brdfgen::emit::rom::{RomFormat, read};

use super::{refused, small_table, words, written};

#[test]
fn quartus_has_a_record_a_word() {
    assert_eq!(
        written(&small_table(), RomFormat::QuartusHex),
        b":0200000001FFFE\n:02000100027F7C\n:020002000300F9\n:020003000300F8\n:00000001FF\n"
    );
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
}
