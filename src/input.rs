//! Reading the user's files, no more of them than a file of their kind can have.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use crate::error::Error;

/// The largest file of text, such as a spec, golden vectors, a ROM file or results, in bytes.
pub const MAX_TEXT: u64 = 64 << 20;
/// The largest mesh, in bytes.
pub const MAX_MESH: u64 = 1 << 30;

/// The bytes of a file of at most `most` bytes. A device or a pipe that gives more is not read to its end.
///
/// # Errors
/// If the system refuses, or the file is larger.
pub fn read(path: &Path, most: u64) -> Result<Vec<u8>, Error> {
    let failed = |error| Error::io("cannot read", path, error);
    let mut bytes = Vec::new();
    File::open(path).map_err(failed)?.take(most + 1).read_to_end(&mut bytes).map_err(failed)?;
    if bytes.len() as u64 > most {
        return Err(Error::input(
            format!("{} is larger than {} MiB", path.display(), most >> 20),
            "a file of this kind is much smaller: give another one",
        ));
    }
    Ok(bytes)
}

/// The text of a file of at most [`MAX_TEXT`] bytes; `allowed` says what the file should be.
///
/// # Errors
/// As [`read`]; a file that is not UTF-8.
pub fn read_text(path: &Path, allowed: &str) -> Result<String, Error> {
    String::from_utf8(read(path, MAX_TEXT)?)
        .map_err(|_| Error::input(format!("{} is not UTF-8 text", path.display()), allowed))
}
