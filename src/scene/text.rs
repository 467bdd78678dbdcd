//! The text of meshes and their materials as other programs write it: byte order marks, the three line ends, lines that
//! go on.

use std::borrow::Cow;

use crate::platform::error::Error;

/// The bytes without the byte order mark of UTF-8; `allowed` says what the file should be.
/// Errors: UTF-16 or UTF-32, by its byte order mark or, in a text of mostly ASCII, by every second byte of its start.
pub(super) fn without_mark<'a>(bytes: &'a [u8], file: &str, allowed: &str) -> Result<&'a [u8], Error> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let start = &bytes[..bytes.len().min(64) & !1];
    let zeros = |first: usize| start.iter().skip(first).step_by(2).filter(|byte| **byte == 0).count();
    let pairs = start.len() / 2;
    let marked = bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff");
    if marked || (pairs > 1 && [0, 1].into_iter().any(|first| zeros(first) == pairs && zeros(1 - first) == 0)) {
        return Err(Error::input(format!("{file} is text in UTF-16"), format!("save it as UTF-8 or ASCII: {allowed}")));
    }
    Ok(bytes)
}

/// The first line of a text that ends its lines with LF, CR LF or CR, without its end, and what follows.
pub(super) fn first_line(text: &[u8]) -> (&[u8], &[u8]) {
    let end = text.iter().position(|byte| matches!(byte, b'\n' | b'\r')).unwrap_or(text.len());
    let rest = &text[end..];
    let rest = rest.strip_prefix(b"\r\n").or_else(|| rest.get(1..)).unwrap_or(rest);
    (&text[..end], rest)
}

/// The statements of an OBJ or MTL text, each with the number of its first line, from 1. A `\` at a line's end
/// continues it; one in a comment does not, as it is the end of a Windows path. Comments are still there
/// ([`without_comment`]).
pub(super) struct Statements<'a> {
    rest: &'a str,
    line: usize,
}

impl<'a> Statements<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Self { rest: text, line: 0 }
    }

    /// The next line of the file; none at its end.
    fn next_line(&mut self) -> Option<&'a str> {
        if self.rest.is_empty() {
            return None;
        }
        let (line, _) = first_line(self.rest.as_bytes());
        let (line, rest) = self.rest.split_at(line.len());
        self.rest = rest.strip_prefix("\r\n").or_else(|| rest.get(1..)).unwrap_or_default();
        self.line += 1;
        Some(line)
    }
}

/// What of a line is continued in the next one.
fn continued(line: &str) -> Option<&str> {
    without_comment(line).trim_end().strip_suffix('\\')
}

/// A statement without the comment behind it.
pub(super) fn without_comment(statement: &str) -> &str {
    statement.split('#').next().unwrap_or_default()
}

/// What follows a statement's first word: a name, which may have blanks in it, and `#`.
pub(super) fn name_of(statement: &str) -> &str {
    let statement = statement.trim();
    statement.split_once(char::is_whitespace).map_or("", |(_, name)| name.trim())
}

impl<'a> Iterator for Statements<'a> {
    type Item = (usize, Cow<'a, str>);

    fn next(&mut self) -> Option<Self::Item> {
        let first = self.next_line()?;
        let number = self.line;
        let Some(start) = continued(first) else { return Some((number, Cow::Borrowed(first))) };
        let mut whole = start.to_owned();
        while let Some(line) = self.next_line() {
            whole.push(' ');
            let Some(part) = continued(line) else {
                whole.push_str(line);
                break;
            };
            whole.push_str(part);
        }
        Some((number, Cow::Owned(whole)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_end_in_three_ways_and_go_on_behind_a_backslash() {
        let text = "v 1 2 3\r\nf 1 \\\r2 \\  \n\t3\r# C:\\models\\\nf 4 # C:\\\n\nf 5 \\ # on\n6 \\";
        let read: Vec<(usize, String)> =
            Statements::new(text).map(|(line, statement)| (line, statement.into_owned())).collect();
        let is: Vec<(usize, &str)> =
            vec![(1, "v 1 2 3"), (2, "f 1  2  \t3"), (5, "# C:\\models\\"), (6, "f 4 # C:\\"), (7, ""), (8, "f 5  6 ")];
        assert_eq!(read.iter().map(|(line, text)| (*line, text.as_str())).collect::<Vec<_>>(), is);
        assert_eq!(name_of("  usemtl\tMaterial #25 "), "Material #25");
        assert_eq!(name_of("usemtl"), "");
    }

    #[test]
    fn marks_are_skipped_and_other_encodings_named() {
        let utf16 = |text: &str, low: usize| -> Vec<u8> {
            text.bytes().flat_map(|byte| if low == 0 { [byte, 0] } else { [0, byte] }).collect()
        };
        assert_eq!(without_mark(b"\xef\xbb\xbfv 1", "a", "").unwrap(), b"v 1");
        assert_eq!(without_mark(b"", "a", "").unwrap(), b"");
        for bytes in [b"\xff\xfev\0".to_vec(), b"\xfe\xff\0v".to_vec(), utf16("v 1 2 3\n", 0), utf16("ply\r\n", 1)] {
            let error = without_mark(&bytes, "a.obj", "an OBJ file").unwrap_err().to_string();
            assert_eq!(error, "a.obj is text in UTF-16");
        }
    }
}
