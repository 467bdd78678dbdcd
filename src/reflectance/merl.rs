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
    let allowed = "a MERL table begins with the counts 90, 90, 180 (or 360) as little-endian 32-bit numbers, and has \
     34992012 (or 69984012) bytes";
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
