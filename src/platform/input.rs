//! Reading the user's files: no more of them than a file of their kind can have, and their text as other programs write
//! it.
//!
//! Editors, spreadsheets and check-outs put a byte order mark in front, end lines with CR LF or CR, save UTF-16, or
//! separate columns by semicolons. What has one meaning is read; what has not is named for what it is.

use std::borrow::Cow;
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::platform::error::{Error, refuse};

/// The largest file of text, such as a spec, golden vectors, a ROM file or results, in bytes.
pub const MAX_TEXT: u64 = 64 << 20;
/// The largest mesh, in bytes.
pub const MAX_MESH: u64 = 1 << 30;

/// What UTF-8 text may begin with.
const BYTE_ORDER_MARK: char = '\u{feff}';

/// The files that were read.
static READ: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// The files that were read so far, for [`crate::platform::paths::Paths`].
#[must_use]
pub fn were_read() -> Vec<PathBuf> {
    READ.lock().unwrap_or_else(PoisonError::into_inner).clone()
}

/// Opens a file for reading.
///
/// # Errors
/// If the system refuses.
pub fn open(path: &Path) -> Result<File, Error> {
    READ.lock().unwrap_or_else(PoisonError::into_inner).push(path.to_owned());
    File::open(path).map_err(|error| Error::io("cannot read", path, error))
}

/// The bytes of a file of at most `most` bytes. A device or a pipe that gives more is not read to its end.
///
/// # Errors
/// If the system refuses, or the file is larger.
pub fn read(path: &Path, most: u64) -> Result<Vec<u8>, Error> {
    let failed = |error| Error::io("cannot read", path, error);
    let mut bytes = Vec::new();
    open(path)?.take(most + 1).read_to_end(&mut bytes).map_err(failed)?;
    refuse!(
        bytes.len() as u64 > most,
        format!("{} is larger than {} MiB", path.display(), most >> 20),
        "a file of this kind is much smaller: give another one"
    );
    Ok(bytes)
}

/// The text of a file of at most [`MAX_TEXT`] bytes, as [`plain`] has it; `allowed` says what the file should be.
///
/// # Errors
/// As [`read`]; a file that is not UTF-8, with what it is instead where that can be told.
pub fn read_text(path: &Path, allowed: &str) -> Result<String, Error> {
    let bytes = read(path, MAX_TEXT)?;
    let name = path.display().to_string();
    refuse_wide_text(&bytes, &name)?;
    let text = String::from_utf8(bytes).map_err(|_| Error::input(format!("{name} is not UTF-8 text"), allowed))?;
    Ok(match plain(&text) {
        Cow::Borrowed(same) if same.len() == text.len() => text,
        plain => plain.into_owned(),
    })
}

/// The same text without a byte order mark in front, and with LF for CR LF and for CR.
#[must_use]
pub fn plain(text: &str) -> Cow<'_, str> {
    let text = text.strip_prefix(BYTE_ORDER_MARK).unwrap_or(text);
    if !text.contains('\r') {
        return Cow::Borrowed(text);
    }
    Cow::Owned(text.replace("\r\n", "\n").replace('\r', "\n"))
}

/// Refuses the bytes of a text of 16 or 32 bits a character, which `name` names: by its byte order mark, or as every
/// other byte of its first characters is 0.
///
/// # Errors
/// Says that it is such a text.
pub fn refuse_wide_text(bytes: &[u8], name: &str) -> Result<(), Error> {
    let of_ascii = |zeros: [bool; 2]| {
        let pairs = bytes.chunks_exact(2).take(4);
        bytes.len() >= 8 && pairs.into_iter().all(|pair| [pair[0] == 0, pair[1] == 0] == zeros)
    };
    let what = match bytes {
        [0xff, 0xfe, 0, 0, ..] | [0, 0, 0xfe, 0xff, ..] => "UTF-32",
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => "UTF-16",
        _ if of_ascii([false, true]) || of_ascii([true, false]) => "UTF-16",
        _ => return Ok(()),
    };
    Err(Error::input(format!("{name} is {what} text"), "save it as UTF-8"))
}

/// Refuses a table whose columns are not separated by commas, as its heading shows; `file` names it in messages.
///
/// # Errors
/// Says what they are separated by.
pub fn check_separator(text: &str, file: &str) -> Result<(), Error> {
    let Some(heading) = text.lines().find(|line| !line.trim().is_empty()) else { return Ok(()) };
    let count = |separator: char| heading.matches(separator).count();
    let Some((_, name)) =
        [(';', "semicolons"), ('\t', "tabs"), ('|', "bars")].into_iter().find(|&(other, _)| count(other) > count(','))
    else {
        return Ok(());
    };
    let at = heading.as_ptr() as usize - text.as_ptr() as usize;
    Err(Error::text(
        format!("columns are separated by commas and this has {name}"),
        "save it with commas between the columns and points in the numbers; a spreadsheet has this in its export or \
         region settings",
        file,
        text,
        (at, heading.len()),
    ))
}

/// Refuses a TOML text that holds a number which is none: `inf`, `nan`, or one beyond what 64 bits hold. What is wrong
/// otherwise is left to whoever reads the text. `file` names it in messages.
///
/// # Errors
/// Names the first such number, with its place.
pub fn check_toml_numbers(text: &str, file: &str) -> Result<(), Error> {
    let Ok(table) = DeTable::parse(text) else { return Ok(()) };
    let Some(span) = not_finite(table.get_ref()) else { return Ok(()) };
    Err(Error::text(
        format!("{} is no number that can be used", &text[span.clone()]),
        "a decimal number, as in 12.5 or 1e-3, of at most 1.8e308",
        file,
        text,
        (span.start, span.len()),
    ))
}

/// The place of the first number of a table that is not finite.
fn not_finite(table: &DeTable<'_>) -> Option<std::ops::Range<usize>> {
    table.iter().filter_map(|(_, value)| not_finite_in(value)).min_by_key(|span| span.start)
}

fn not_finite_in(value: &Spanned<DeValue<'_>>) -> Option<std::ops::Range<usize>> {
    match value.get_ref() {
        DeValue::Float(float) => {
            let finite = float.as_str().replace('_', "").parse::<f64>().is_ok_and(f64::is_finite);
            (!finite).then(|| value.span())
        }
        DeValue::Array(values) => values.iter().find_map(not_finite_in),
        DeValue::Table(table) => not_finite(table),
        _ => None,
    }
}
