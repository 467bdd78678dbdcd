//! Intel HEX: addresses of bytes, or of words as Quartus has them.

use ihex::{ReaderError, Record};
use num_bigint::BigUint;

use super::mem::MEM;
use super::source::{Source, Span, Words, image, lines};
use super::writing::{Writing, word_bytes};
use super::{FileFormat, MAX_DEPTH, RomImage};
use crate::platform::error::Error;

pub(super) const HEX: FileFormat = FileFormat {
    about: "Intel HEX with byte addresses, each word in whole little-endian bytes: NAME.hex; for Quartus see \
     quartus-hex",
    suffix: ".hex",
    extensions: &["hex", "ihex", "ihx"],
    allowed: "an Intel HEX file has one record a line, as in :0300300002337A1E, and ends with :00000001FF; its \
              addresses count bytes, or words as Quartus writes them",
    is_text: true,
    read,
    write,
};

pub(super) const QUARTUS_HEX: FileFormat = FileFormat {
    about: "Quartus' .hex, Intel HEX whose addresses count words, each in whole big-endian bytes: NAME_quartus.hex",
    suffix: "_quartus.hex",
    extensions: &[],
    allowed: "Quartus' .hex has one word a record, as in :03000200100001EA, and ends with :00000001FF; its addresses \
     count words",
    is_text: true,
    read: read_quartus,
    write: write_quartus,
};

/// The data bytes of a record: what most tools write and every tool reads.
const HEX_RECORD_BYTES: usize = 16;

fn write(of: &Writing<'_>) -> Vec<u8> {
    let mut records = Vec::new();
    for (position, data) in of.byte_words().flatten().collect::<Vec<u8>>().chunks(HEX_RECORD_BYTES).enumerate() {
        let address = position * HEX_RECORD_BYTES;
        let (high, low) = ((address >> 16) as u16, address as u16);
        if low == 0 && high > 0 {
            records.push(Record::ExtendedLinearAddress(high));
        }
        records.push(Record::Data { offset: low, value: data.to_vec() });
    }
    record_lines(records)
}

/// One record a word, as Quartus' memory editor writes them. The deepest ROM has an address of 16 bits for each of its
/// words.
fn write_quartus(of: &Writing<'_>) -> Vec<u8> {
    let record = |(address, mut value): (usize, Vec<u8>)| {
        value.reverse();
        Record::Data { offset: address as u16, value }
    };
    record_lines(of.byte_words().enumerate().map(record).collect())
}

/// The records and the one that ends a file, a line each.
fn record_lines(mut records: Vec<Record>) -> Vec<u8> {
    records.push(Record::EndOfFile);
    let line = |record: Record| record.to_record_string().expect("a record of at most 255 bytes can be written") + "\n";
    records.into_iter().map(line).collect::<String>().into_bytes()
}

/// The records' data with their addresses, which have their extensions added, and their places. An extension by segment
/// counts as 16, one that is linear as 65,536.
struct Records(Vec<(usize, Vec<u8>, Span)>);

impl Records {
    fn of(source: &Source<'_>) -> Result<Self, Error> {
        let mut records = Vec::new();
        let mut base = 0;
        let mut ended = false;
        for (record, span) in lines(&source.text, &[]) {
            if ended {
                return Err(source.wrong("a line stands after the end-of-file record", span));
            }
            let record: Record = record.parse().map_err(|wrong| {
                let what = match wrong {
                    // The crate's own text has the two the other way round.
                    ReaderError::ChecksumMismatch(right, given) => {
                        format!("the checksum of this record is {given:02X} and should be {right:02X}")
                    }
                    other => format!("this is not an Intel HEX record: {other}"),
                };
                source.wrong(what, span)
            })?;
            match record {
                Record::Data { offset, value } => records.push((base + usize::from(offset), value, span)),
                Record::ExtendedSegmentAddress(segment) => base = usize::from(segment) << 4,
                Record::ExtendedLinearAddress(high) => base = usize::from(high) << 16,
                Record::EndOfFile => ended = true,
                // Where a processor would start.
                Record::StartSegmentAddress { .. } | Record::StartLinearAddress(_) => {}
            }
        }
        if !ended {
            return Err(source.cut_off("the file ends without an end-of-file record"));
        }
        Ok(Self(records))
    }

    /// Whether the addresses can only be those of words: each record begins as many words behind the one before as that
    /// has.
    fn count_words(&self, word_bytes: usize) -> bool {
        let whole = self.0.iter().all(|(_, value, _)| value.len() % word_bytes == 0);
        let next = |two: &[(usize, Vec<u8>, Span)]| two[0].0 + two[0].1.len() / word_bytes == two[1].0;
        word_bytes > 1 && whole && self.0.len() > 1 && self.0.windows(2).all(next)
    }
}

/// Intel HEX: the addresses are those of bytes. Quartus' kind is told by its records, and text for `$readmemh`, which
/// goes under the same name, by the colon that it does not begin with.
fn read(source: &Source<'_>) -> Result<RomImage, Error> {
    if !source.text.trim_start().is_empty() && !source.text.trim_start().starts_with(':') {
        let text = (MEM.read)(&Source { text: source.text.clone(), allowed: MEM.allowed, ..*source });
        return text.map(|image| RomImage { kind: Some("text for $readmemh"), ..image }).map_err(|error| match error {
            Error::Text { what, text, at, .. } => Error::Text {
                what: format!("this is not an Intel HEX record, and no text for $readmemh: {what}"),
                allowed: source.allowed.to_owned(),
                text,
                at,
            },
            other => other,
        });
    }
    let word_bytes = word_bytes(source.word_bits);
    let records = Records::of(source)?;
    if records.count_words(word_bytes) {
        return words_by_address(source, &records);
    }
    let mut bytes: Vec<Option<(u8, Span)>> = Vec::new();
    for (first, value, span) in records.0 {
        for (byte, address) in value.into_iter().zip(first..) {
            if address >= MAX_DEPTH * word_bytes {
                let what = format!("the byte address 0x{address:x} is out of range");
                let allowed = format!("a ROM has at most {MAX_DEPTH} words, here of {word_bytes} bytes");
                return Err(source.error(what, allowed, span));
            }
            if address >= bytes.len() {
                bytes.resize(address + 1, None);
            }
            if bytes[address].replace((byte, span)).is_some() {
                let what = format!("a second byte for the byte address 0x{address:x}");
                return Err(source.error(what, "each byte is given once; in Quartus' .hex, each word", span));
            }
        }
    }
    if bytes.is_empty() {
        return Err(source.cut_off("the file has no words"));
    }
    let words = bytes.chunks(word_bytes).enumerate().map(|(address, bytes)| hex_word(source, address, bytes));
    words.collect::<Result<_, _>>().map(image)
}

/// Quartus' kind: the addresses are those of words, whose bytes are the most significant first.
fn read_quartus(source: &Source<'_>) -> Result<RomImage, Error> {
    words_by_address(source, &Records::of(source)?)
}

fn words_by_address(source: &Source<'_>, records: &Records) -> Result<RomImage, Error> {
    let word_bytes = word_bytes(source.word_bits);
    let mut words = Words::new(source);
    for (first, value, span) in &records.0 {
        if value.len() % word_bytes != 0 {
            let what = format!("the {} bytes of this record are not whole words", value.len());
            return Err(source.error(
                what,
                format!("a word of {} bits has {word_bytes} bytes", source.word_bits),
                *span,
            ));
        }
        for (address, bytes) in (*first..).zip(value.chunks(word_bytes)) {
            let word = BigUint::from_bytes_be(bytes);
            source.refuse_wide(&word, *span)?;
            words.place(address, word, *span, MAX_DEPTH)?;
        }
    }
    Ok(RomImage { kind: Some("Quartus' kind, whose addresses count words"), ..image(words.finish(None)?) })
}

/// The word of the given bytes, all of which must be there.
fn hex_word(source: &Source<'_>, address: usize, bytes: &[Option<(u8, Span)>]) -> Result<BigUint, Error> {
    let given: Vec<(u8, Span)> = bytes.iter().copied().flatten().collect();
    let word_bytes = word_bytes(source.word_bits);
    // A word without any byte has no record to point at.
    let span = given.last().map_or((source.text.len(), 0), |(_, span)| *span);
    if given.len() < word_bytes {
        let what = format!("the word at the address {address} has only {} of its {word_bytes} bytes", given.len());
        return Err(source.error(what, "every word is complete, from the address 0 to the last", span));
    }
    let word = BigUint::from_bytes_le(&given.iter().map(|(byte, _)| *byte).collect::<Vec<u8>>());
    source.refuse_wide(&word, span)?;
    Ok(word)
}
