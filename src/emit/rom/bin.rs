//! Raw words.

use num_bigint::BigUint;

use super::source::{Source, image};
use super::writing::word_bytes;
use super::{FileFormat, MAX_DEPTH, RomImage};
use crate::platform::error::Error;

pub(super) const BIN: FileFormat = FileFormat {
    about: "Raw words, each in whole little-endian bytes: NAME.bin",
    suffix: ".bin",
    extensions: &["bin"],
    allowed: "a .bin file has whole little-endian bytes for each word",
    is_text: false,
    read,
    write: |of| of.byte_words().flatten().collect(),
};

fn read(source: &Source<'_>) -> Result<RomImage, Error> {
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
