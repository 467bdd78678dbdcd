//! Which files a command reads and writes. Nothing is written over what is read, and no two things into one file: every
//! command names its files here before it writes the first.
//!
//! Files are compared as the system knows them: through links of both kinds, `.` and `..`, and for those that are not
//! there yet by the directory that they will be in.

use std::ffi::OsString;
use std::fs;
use std::path::{Component, Path, PathBuf};

use crate::platform::error::Error;
use crate::platform::input;

/// Standard output, where a path can be a file.
const STANDARD: &str = "-";

/// The files of a command.
#[derive(Clone, Debug, Default)]
pub struct Paths {
    read: Vec<Named>,
    written: Vec<Named>,
}

/// A path and what it is called in a message.
#[derive(Clone, Debug)]
struct Named {
    what: String,
    path: PathBuf,
}

impl Paths {
    /// Those that were read so far by [`input::read`].
    #[must_use]
    pub fn new() -> Self {
        let named = |path| Named { what: String::new(), path };
        Self { read: input::were_read().into_iter().map(named).collect(), written: Vec::new() }
    }

    /// With a file that is read, or is going to be; `what` is the flag that names it.
    #[must_use]
    pub fn reads(mut self, what: &str, path: impl Into<PathBuf>) -> Self {
        self.read.push(Named { what: what.to_owned(), path: path.into() });
        self
    }

    /// With a file that is going to be written; `what` is the flag that names it.
    #[must_use]
    pub fn writes(mut self, what: &str, path: impl Into<PathBuf>) -> Self {
        self.written.push(Named { what: what.to_owned(), path: path.into() });
        self
    }

    /// As [`Paths::writes`], where the user has named one.
    #[must_use]
    pub fn may_write(self, what: &str, path: Option<&PathBuf>) -> Self {
        match path {
            Some(path) => self.writes(what, path),
            None => self,
        }
    }

    /// As [`Paths::writes`], for files in a directory.
    #[must_use]
    pub fn writes_in<'a>(self, what: &str, directory: &Path, files: impl IntoIterator<Item = &'a str>) -> Self {
        files.into_iter().fold(self, |paths, file| paths.writes(what, directory.join(file)))
    }

    /// Those of both.
    #[must_use]
    pub fn joined(mut self, other: Self) -> Self {
        self.read.extend(other.read);
        self.written.extend(other.written);
        self
    }

    /// Without this file among those that are read: it is one that the command is there to renew.
    #[must_use]
    pub fn renewing(mut self, path: &Path) -> Self {
        let renewed = Place::of(path);
        self.read.retain(|read| !Place::of(&read.path).is(&renewed));
        self
    }

    /// Nothing is written yet: the last chance to refuse.
    ///
    /// # Errors
    /// A file that would be written and is read, or would be written twice, with both names; two things for standard
    /// output.
    pub fn check(&self) -> Result<(), Error> {
        let standard: Vec<&str> = self
            .written
            .iter()
            .filter(|file| file.path.as_os_str() == STANDARD)
            .map(|file| file.what.as_str())
            .collect();
        if let [one, other, ..] = *standard {
            return Err(Error::input(
                format!("{one} and {other} both go to standard output"),
                "it cannot take two things: write one of them to a file",
            ));
        }
        let placed = |files: &[Named]| -> Vec<(Named, Place)> {
            files
                .iter()
                .filter(|file| !is_stream(&file.path))
                .map(|file| (file.clone(), Place::of(&file.path)))
                .collect()
        };
        let (read, written) = (placed(&self.read), placed(&self.written));
        for (number, (file, place)) in written.iter().enumerate() {
            let same = read.iter().filter(|(_, other)| other.is(place));
            // A file may be known as one that was read and by its flag, which says more.
            if let Some((input, _)) = same.max_by_key(|(input, _)| !input.what.is_empty()) {
                let what = if input.what.is_empty() { String::new() } else { format!(" ({})", input.what) };
                return Err(Error::input(
                    format!(
                        "{} would write {} over {}{what}, which is read",
                        file.what,
                        file.path.display(),
                        input.path.display()
                    ),
                    "name another file: nothing is written over what is read",
                ));
            }
            let before = &written[..number];
            if let Some((other, _)) = before.iter().find(|(_, other)| other.is(place)) {
                return Err(Error::input(
                    format!(
                        "{} and {} are one file: {} and {}",
                        other.what,
                        file.what,
                        other.path.display(),
                        file.path.display()
                    ),
                    "give each a file of its own",
                ));
            }
            let within = |a: &Place, b: &Place| a.path != b.path && a.path.starts_with(&b.path);
            if let Some((other, _)) = before.iter().find(|(_, other)| within(other, place) || within(place, other)) {
                return Err(Error::input(
                    format!(
                        "{} and {} cannot both be: one of {} and {} is a file, and a directory to the other",
                        other.what,
                        file.what,
                        other.path.display(),
                        file.path.display()
                    ),
                    "give each a place of its own",
                ));
            }
        }
        Ok(())
    }
}

/// Whether a path is standard output, a device or a pipe, which hold nothing that could be lost.
fn is_stream(path: &Path) -> bool {
    let is_device = fs::metadata(path).is_ok_and(|there| !there.is_file() && !there.is_dir());
    path.as_os_str() == STANDARD || path.starts_with("/dev") || is_device
}

/// Where a file is or will be.
#[derive(Clone, Debug)]
struct Place {
    path: PathBuf,
    /// The device and the number of a file that is there: links of a file share them.
    file: Option<(u64, u64)>,
}

impl Place {
    fn of(path: &Path) -> Self {
        Self { path: canonical(path, 40), file: identity(path) }
    }

    fn is(&self, other: &Self) -> bool {
        self.path == other.path || self.file.is_some() && self.file == other.file
    }
}

#[cfg(unix)]
fn identity(path: &Path) -> Option<(u64, u64)> {
    use std::os::unix::fs::MetadataExt;
    fs::metadata(path).ok().map(|there| (there.dev(), there.ino()))
}

#[cfg(not(unix))]
fn identity(_: &Path) -> Option<(u64, u64)> {
    None
}

/// A path without links, `.` and `..`, as far as it leads to something; what is not there yet is appended. At most so
/// many links to what is not there are followed.
fn canonical(path: &Path, links: u32) -> PathBuf {
    let absolute = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    if let Ok(there) = fs::canonicalize(&absolute) {
        return there;
    }
    if let (Ok(target), Some(parent), 1..) = (fs::read_link(&absolute), absolute.parent(), links) {
        return canonical(&parent.join(target), links - 1);
    }
    let last: Option<OsString> = match absolute.components().next_back() {
        Some(Component::Normal(name)) => Some(name.to_owned()),
        _ => None,
    };
    match (absolute.parent(), last) {
        (Some(parent), Some(name)) => canonical(parent, links).join(name),
        // `..` of a directory that is not there.
        (Some(parent), None) => canonical(parent, links).parent().map_or_else(|| absolute.clone(), Path::to_owned),
        _ => absolute,
    }
}
