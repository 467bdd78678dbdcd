//! Tables as files of the MERL database: three 32-bit counts (θh, θd, φd), then the planes of red, green and blue as
//! 64-bit floating-point numbers, all little-endian.
//!
//! W. Matusik, H. Pfister, M. Brand, L. McMillan, "A Data-Driven Reflectance Model", 2003.

use std::io::{ErrorKind, Read};
use std::path::Path;

use super::table::{PHI_D, PHI_D_WHOLE, THETA_D, THETA_H, Table};
use crate::platform::error::Error;
use crate::platform::input;

/// What a stored number is multiplied by to be a reflectance in 1/sr, for red, green and blue.
pub const SCALES: [f64; 3] = [1.0 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0];
/// The shapes that a file may have: φd over half the circle, which makes the table reciprocal, or all around.
pub const SHAPES: [[usize; 3]; 2] = [[THETA_H, THETA_D, PHI_D], [THETA_H, THETA_D, PHI_D_WHOLE]];
/// Bytes before the planes.
const HEADER: usize = 12;
/// What an invalid cell is written as.
const INVALID: f64 = -1.0;

fn counts(header: &[u8; HEADER], read: fn([u8; 4]) -> u32) -> Option<[usize; 3]> {
    let count = |at: usize| read([header[at], header[at + 1], header[at + 2], header[at + 3]]) as usize;
    let counts = [count(0), count(4), count(8)];
    counts.iter().all(|count| (1..=4096).contains(count)).then_some(counts)
}

/// Reads a table.
///
/// # Errors
/// If the system refuses, or the file is anything but a table of 90 × 90 × 180 or 90 × 90 × 360: what it is instead is
/// said. Values that are not finite, and tables without a valid cell.
pub fn read(path: &Path) -> Result<Table, Error> {
    read_from(input::open(path)?, &path.display().to_string(), &SHAPES)
}

/// Reads a table of one of some shapes from a stream; memory is only taken for one of them.
///
/// # Errors
/// As [`read`].
pub fn read_from(mut from: impl Read, name: &str, shapes: &[[usize; 3]]) -> Result<Table, Error> {
    let failed = |error| Error::io("cannot read", Path::new(name), error);
    let mut start = [0u8; 512];
    let got = fill(&mut from, &mut start).map_err(failed)?;
    let start = &start[..got];
    let shape = shape(start, name, shapes)?;
    let count: usize = shape.iter().product();
    let mut from = start[HEADER..].chain(from);
    let mut cells = vec![[0.0f32; 3]; count];
    let mut buffer = vec![0u8; 1 << 16];
    let mut bytes = HEADER as u64;
    for channel in 0..3 {
        let mut done = 0;
        while done < count {
            let wanted = (8 * (count - done)).min(buffer.len());
            let got = fill(&mut from, &mut buffer[..wanted]).map_err(failed)?;
            bytes += got as u64;
            if got < wanted {
                return Err(length(name, shape, &format!("has {bytes} bytes and is cut short")));
            }
            for (cell, number) in cells[done..].iter_mut().zip(buffer[..wanted].as_chunks::<8>().0) {
                cell[channel] = (f64::from_le_bytes(*number) * SCALES[channel]) as f32;
            }
            done += wanted / 8;
        }
    }
    if fill(&mut from, &mut buffer[..1]).map_err(failed)? > 0 {
        return Err(length(name, shape, "goes on after the last cell"));
    }
    Table::new(shape, cells, name)
}

/// Reads until the buffer is full or the stream ends.
fn fill(from: &mut impl Read, buffer: &mut [u8]) -> std::io::Result<usize> {
    let mut got = 0;
    while got < buffer.len() {
        match from.read(&mut buffer[got..]) {
            Ok(0) => break,
            Ok(more) => got += more,
            Err(error) if error.kind() == ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
    Ok(got)
}

/// The file's own length by its shape.
fn size(shape: [usize; 3]) -> usize {
    HEADER + 24 * shape.iter().product::<usize>()
}

fn length(name: &str, shape: [usize; 3], what: &str) -> Error {
    let [h, d, p] = shape;
    Error::input(
        format!("{name} {what}"),
        format!("a table of {h} × {d} × {p} cells has {} bytes: copy it anew", size(shape)),
    )
}

/// The shape that the beginning of a file tells; what it is if that is none of those allowed.
fn shape(start: &[u8], name: &str, shapes: &[[usize; 3]]) -> Result<[usize; 3], Error> {
    let allowed = "a MERL table begins with the counts 90, 90, 180 (or 360) as little-endian 32-bit numbers, and has 34992012 (or 69984012) bytes";
    let refused = |what: String| Err(Error::input(format!("{name} {what}"), allowed));
    if start.is_empty() {
        return refused("is empty".to_owned());
    }
    if let Some(kind) = magic(start) {
        return refused(format!("is {kind}, and no MERL table"));
    }
    let Some((header, _)) = start.split_first_chunk::<HEADER>() else {
        return refused(format!("has {} bytes, and no MERL table's beginning", start.len()));
    };
    let little = counts(header, u32::from_le_bytes);
    let big = counts(header, u32::from_be_bytes);
    match (little, big) {
        (Some(shape), _) if shapes.contains(&shape) => Ok(shape),
        (_, Some(shape)) if shapes.contains(&shape) => {
            refused("is a MERL table in big-endian order, which is none".to_owned())
        }
        _ if is_text(start) => refused("is text, and no MERL table".to_owned()),
        (Some([h, d, p]), _) => refused(format!("is a table of {h} × {d} × {p} cells")),
        _ => {
            let [h, d, p] =
                [0, 4, 8].map(|at| i32::from_le_bytes([header[at], header[at + 1], header[at + 2], header[at + 3]]));
            refused(format!("begins with the counts {h}, {d}, {p}, and is no MERL table"))
        }
    }
}

/// What the first bytes of a file say that it is, where it is of a known other kind.
#[must_use]
pub fn magic(start: &[u8]) -> Option<&'static str> {
    let kinds: [(&[u8], &str); 9] = [
        (b"tensor_file", "an RGL tensor (.bsdf), which holds f cos θ over another grid"),
        (b"\x89PNG\r\n\x1a\n", "a PNG picture"),
        (b"\x76\x2f\x31\x01", "an OpenEXR picture"),
        (b"#?RADIANCE", "a Radiance picture"),
        (b"\xff\xd8\xff", "a JPEG picture"),
        (b"PK\x03\x04", "a ZIP archive"),
        (b"\x1f\x8b", "a gzip file: unpack it first"),
        (b"\x89HDF\r\n\x1a\n", "an HDF5 file"),
        (b"<?xml", "an XML file"),
    ];
    kinds.into_iter().find(|(mark, _)| start.starts_with(mark)).map(|(_, kind)| kind)
}

fn is_text(start: &[u8]) -> bool {
    let printable = |c: char| !c.is_control() || matches!(c, '\n' | '\r' | '\t');
    // The last character may be cut.
    let text = match str::from_utf8(start) {
        Ok(text) => text,
        Err(error) if error.error_len().is_none() => str::from_utf8(&start[..error.valid_up_to()]).unwrap_or_default(),
        Err(_) => return false,
    };
    !text.is_empty() && text.chars().all(printable)
}

/// The bytes of a table as a file: invalid cells are -1.
#[must_use]
pub fn bytes(table: &Table) -> Vec<u8> {
    let shape = table.shape();
    let mut bytes = Vec::with_capacity(size(shape));
    shape.iter().for_each(|&count| bytes.extend((count as u32).to_le_bytes()));
    for channel in 0..3 {
        for (cell, value) in table.cells().iter().enumerate() {
            let stored = if table.is_valid(cell) { f64::from(value[channel]) / SCALES[channel] } else { INVALID };
            bytes.extend(stored.to_le_bytes());
        }
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::super::vector::tests::random;
    use super::*;

    const SMALL: [usize; 3] = [3, 4, 6];

    fn table() -> Table {
        let mut random = random(9);
        let cells = (0..72)
            .map(|cell| if cell % 7 == 3 { [-0.5; 3] } else { [(); 3].map(|()| (1e4 * random() * random()) as f32) })
            .collect();
        Table::new(SMALL, cells, "t").unwrap()
    }

    fn refused(bytes: &[u8]) -> String {
        read_from(bytes, "f", &[SMALL, SHAPES[0]]).unwrap_err().to_string()
    }

    #[test]
    fn what_is_written_is_read_again() {
        let table = table();
        let bytes = bytes(&table);
        assert_eq!(bytes.len(), 12 + 24 * 72);
        assert_eq!(bytes[..12], [3, 0, 0, 0, 4, 0, 0, 0, 6, 0, 0, 0]);
        let again = read_from(&bytes[..], "f", &[SMALL]).unwrap();
        assert_eq!((again.cells(), again.shape()), (table.cells(), SMALL));
        assert!((0..72).all(|cell| again.is_valid(cell) == (cell % 7 != 3)));
        assert_eq!(super::bytes(&again), bytes);
        // Stored numbers are far larger than reflectances, and each channel has its own scale.
        let stored = |at: usize| f64::from_le_bytes(bytes[12 + 8 * at..][..8].try_into().unwrap());
        let near = |a: f64, b: f64| (a - b).abs() < 1e-6 * b;
        assert!(near(stored(5) / 1500.0, table.cells()[5][0].into()));
        assert!(near(stored(72 + 5) * 1.15 / 1500.0, table.cells()[5][1].into()));
        assert!(near(stored(144 + 5) * 1.66 / 1500.0, table.cells()[5][2].into()));
        assert_eq!(stored(3), -1.0);
    }

    #[test]
    fn other_files_are_named() {
        let bytes = bytes(&table());
        assert!(
            refused(&bytes[..bytes.len() - 1]).contains(&format!("f has {} bytes and is cut short", bytes.len() - 1))
        );
        assert!(refused(&bytes[..20]).contains("cut short"));
        assert!(refused(&[&bytes[..], b"x"].concat()).contains("goes on after the last cell"));
        assert!(refused(b"").contains("is empty"));
        assert!(refused(b"abc").contains("has 3 bytes"));
        assert!(refused(b"tensor_file\0\x01\0and so on and on").contains("RGL tensor"));
        assert!(refused(&b"theta_h theta_d phi_d r g b\n".repeat(30)).contains("is text"));
        let mut big = bytes.clone();
        big[..12].as_chunks_mut::<4>().0.iter_mut().for_each(|count| count.reverse());
        assert!(refused(&big).contains("big-endian"));
        let with = |counts: [i32; 3]| {
            let mut bytes = bytes.clone();
            bytes[..12].copy_from_slice(counts.map(i32::to_le_bytes).as_flattened());
            refused(&bytes)
        };
        assert!(with([90, 90, 90]).contains("a table of 90 × 90 × 90 cells"));
        assert!(with([0, 90, 180]).contains("counts 0, 90, 180"));
        assert!(with([-1, i32::MAX, 180]).contains("counts -1, 2147483647, 180"));
        assert!(with([90, 90, 180]).contains("cut short"));
    }

    #[test]
    fn wrong_numbers_are_refused() {
        let mut bytes = bytes(&table());
        for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300] {
            bytes[12 + 8 * 40..][..8].copy_from_slice(&wrong.to_le_bytes());
            assert!(refused(&bytes).contains("θh 1, θd 2, φd 4 holds"), "{wrong}");
        }
        bytes[12..].as_chunks_mut::<8>().0.iter_mut().for_each(|number| *number = (-3.0f64).to_le_bytes());
        assert!(refused(&bytes).contains("all 72 cells are invalid"));
    }

    #[test]
    fn a_whole_table_keeps_within_its_bounds() {
        let count = 90usize * 90 * 180;
        let cells = (0..count).map(|cell| if cell % 5 == 0 { [-1.0; 3] } else { [cell as f32; 3] }).collect();
        let table = Table::new(SHAPES[0], cells, "t").unwrap();
        let bytes = bytes(&table);
        assert_eq!(bytes.len(), 34_992_012);
        let again = read_from(&bytes[..], "f", &SHAPES).unwrap();
        assert_eq!(again.valid_count(), count - count.div_ceil(5));
    }
}
