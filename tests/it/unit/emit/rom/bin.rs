use brdfgen::emit::rom::{RomFormat, read};

#[test]
fn whole_bytes_of_other_tools() {
    let raw = |bytes: &[u8], bits| read(bytes, RomFormat::Bin, "f.bin", bits).map_err(|error| error.to_string());
    assert_eq!(raw(&[1, 2, 3], 16), Err("f.bin: 3 bytes are not a whole number of words".to_owned()));
    assert_eq!(raw(&[1, 2, 3, 4], 10), Err("f.bin: the word 0x403 at the address 1, byte 2, is too wide".to_owned()));
}
