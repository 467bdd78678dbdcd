//! Files on disk: whole or not at all.

use std::collections::BTreeSet;
use std::fs;
#[cfg(unix)]
use std::fs::TryLockError;
use std::io::Write;
use std::path::Path;
use std::time::{Duration, Instant};

use super::File;
use crate::platform::error::Error;
use crate::platform::input;
use crate::platform::transient::{self, Draft, Folder};

/// How the `core.toml` of a generated core begins.
pub const GENERATED_MARK: &str = "# brdfgen core";

/// A kind of directory that brdfgen writes, and may replace the files of.
#[derive(Clone, Copy, Debug)]
pub struct Kind {
    /// What such a directory is called in a message, with an article.
    pub what: &'static str,
    /// The file by which it is known.
    pub file: &'static str,
    /// How that file begins.
    pub mark: &'static str,
}

/// The list of a core's other files with their digests.
const MANIFEST: &str = "manifest.json";
/// The list of files that is there while a directory is being written.
const UNFINISHED: &str = ".brdfgen-unfinished.json";

const CORE: Kind = Kind { what: "a generated core", file: "core.toml", mark: GENERATED_MARK };

/// Refuses a directory that is neither new, nor empty, nor a core of ours.
///
/// # Errors
/// Says what is in the way.
pub fn check_target(directory: &Path) -> Result<(), Error> {
    check_target_of(CORE, directory)
}

/// Refuses a directory that is neither new, nor empty, nor of this kind.
///
/// # Errors
/// Says what is in the way.
pub fn check_target_of(kind: Kind, directory: &Path) -> Result<(), Error> {
    let entries = match fs::read_dir(directory) {
        Ok(entries) => entries,
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(()),
        Err(error) => return Err(Error::io("cannot use", directory, error)),
    };
    // What a run that was killed, or that is about to begin, has there is not the user's.
    let entries = entries.flatten().filter(|entry| !transient::is_temporary(&entry.file_name())).count();
    let is_ours = || fs::read(directory.join(kind.file)).is_ok_and(|bytes| bytes.starts_with(kind.mark.as_bytes()));
    // Asked twice: another run may end its writing between the two questions.
    if entries == 0 || is_ours() || !unfinished(directory).is_empty() || is_ours() {
        return Ok(());
    }
    Err(Error::input(
        format!("{} is not empty and not {}", directory.display(), kind.what),
        "give a new or empty directory, or one that brdfgen wrote",
    ))
}

/// Writes a file under a temporary name in the same directory, and renames it: a reader sees the old content or
/// the new, never a part. A link is followed; a device or a pipe is written to.
///
/// # Errors
/// If the system refuses.
pub fn write_file(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    let failed = |error| Error::io("cannot write", path, error);
    // A rename would put a file in the place of `/dev/null`.
    if fs::metadata(path).is_ok_and(|there| !there.is_file() && !there.is_dir()) {
        let mut file = fs::OpenOptions::new().write(true).open(path).map_err(failed)?;
        return file.write_all(bytes).map_err(failed);
    }
    let real = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    draft(&real, bytes).and_then(|draft| draft.keep_as(&real)).map_err(failed)
}

/// A file's content under a temporary name in the directory where it is to be.
fn draft(path: &Path, bytes: &[u8]) -> std::io::Result<Draft> {
    let parent = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    fs::create_dir_all(parent)?;
    let draft = Draft::new_in(parent)?;
    draft.file().write_all(bytes)?;
    make_readable(draft.path())?;
    Ok(draft)
}

/// Temporary files and directories are made for their owner only; the results are for all.
#[cfg(unix)]
fn make_readable(path: &Path) -> std::io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    let mode = if path.is_dir() { 0o755 } else { 0o644 };
    fs::set_permissions(path, fs::Permissions::from_mode(mode))
}

#[cfg(not(unix))]
fn make_readable(_: &Path) -> std::io::Result<()> {
    Ok(())
}

/// Writes a core's directory. A new one appears whole, by a rename. In an existing one each file is replaced whole,
/// once all are on the disk under temporary names; its `manifest.json` goes first and comes last, so that an
/// interrupted run leaves a directory without one, and a list of files from which the next run finishes the work. Of
/// several runs at once one writes after the other.
///
/// # Errors
/// If the directory is somebody else's (see [`check_target`]), another run does not end its writing, or the system
/// refuses.
pub fn write_directory(directory: &Path, files: &[File]) -> Result<(), Error> {
    write_directory_of(CORE, directory, files)
}

/// Writes a directory of another kind in the same way.
///
/// # Errors
/// If the directory is somebody else's (see [`check_target_of`]), another run does not end its writing, or the system
/// refuses.
pub fn write_directory_of(kind: Kind, directory: &Path, files: &[File]) -> Result<(), Error> {
    check_target_of(kind, directory)?;
    let failed = |error| Error::io("cannot write", directory, error);
    if directory.exists() {
        return replace(kind, directory, files);
    }
    // `canonicalize` needs the directory to be there, and its parent is what the temporary one must share.
    let absolute = std::path::absolute(directory).map_err(failed)?;
    let parent = absolute.parent().unwrap_or(&absolute);
    fs::create_dir_all(parent).map_err(failed)?;
    let staging = Folder::new_in(parent).map_err(failed)?;
    for file in files {
        let path = staging.path().join(&file.path);
        draft(&path, &file.bytes).and_then(|draft| draft.keep_as(&path)).map_err(failed)?;
    }
    make_readable(staging.path()).map_err(failed)?;
    match fs::rename(staging.path(), directory) {
        // Another run was faster.
        Err(_) if directory.is_dir() => replace(kind, directory, files),
        renamed => renamed.map_err(failed),
    }
}

/// The longest that a run waits for another one that writes into the same directory.
const PATIENCE: Duration = Duration::from_secs(30);

/// The lock of a directory; nothing on a file system without locks.
#[cfg(unix)]
fn lock(directory: &Path) -> Result<Option<fs::File>, Error> {
    let file = fs::File::open(directory).map_err(|error| Error::io("cannot use", directory, error))?;
    let start = Instant::now();
    loop {
        match file.try_lock() {
            Ok(()) => return Ok(Some(file)),
            Err(TryLockError::Error(_)) => return Ok(None),
            Err(TryLockError::WouldBlock) if start.elapsed() < PATIENCE => {
                std::thread::sleep(Duration::from_millis(20))
            }
            Err(TryLockError::WouldBlock) => {
                return Err(Error::input(
                    format!("another process has kept {} locked for {} s", directory.display(), PATIENCE.as_secs()),
                    "one run at a time writes into a directory: give another one, or wait for its end",
                ));
            }
        }
    }
}

#[cfg(not(unix))]
fn lock(_: &Path) -> Result<Option<fs::File>, Error> {
    Ok(None)
}

fn replace(kind: Kind, directory: &Path, files: &[File]) -> Result<(), Error> {
    let _lock = lock(directory)?;
    check_target_of(kind, directory)?;
    let manifest = directory.join(MANIFEST);
    let mut known: BTreeSet<String> = listed(&manifest).into_iter().chain(unfinished(directory)).collect();
    let stale: Vec<String> =
        known.iter().filter(|path| files.iter().all(|file| file.path != **path)).cloned().collect();
    known.extend(files.iter().map(|file| file.path.clone()));
    for path in &known {
        // What a run that was killed while it wrote there left.
        directory.join(path).parent().into_iter().for_each(transient::sweep);
    }
    let failed = |path: &Path| {
        let path = path.to_owned();
        move |error| Error::io("cannot write", &path, error)
    };
    // Before anything else, so that whatever is found here after a run that was killed is known to be ours.
    let list = directory.join(UNFINISHED);
    write_file(&list, serde_json::to_string(&known).expect("JSON of plain values").as_bytes())?;
    let drafted = files.iter().map(|file| {
        let path = directory.join(&file.path);
        draft(&path, &file.bytes).map(|draft| (draft, path.clone())).map_err(failed(&path))
    });
    let mut drafts: Vec<_> = drafted.collect::<Result<_, _>>().inspect_err(|_| {
        // All is as it was.
        if manifest.exists() {
            let _ = fs::remove_file(&list);
        }
    })?;
    let remove = |path: &Path| match fs::remove_file(path) {
        Err(error) if error.kind() != std::io::ErrorKind::NotFound => Err(Error::io("cannot remove", path, error)),
        _ => Ok(()),
    };
    remove(&manifest)?;
    for path in stale.iter().map(|path| directory.join(path)).filter(|path| path.is_file()) {
        remove(&path)?;
    }
    // The manifest last.
    drafts.sort_by_key(|(_, path)| *path == manifest);
    for (draft, path) in drafts {
        draft.keep_as(&path).map_err(failed(&path))?;
    }
    remove(&list)
}

/// What is wrong with a file on disk.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stale {
    /// It is not there.
    Missing,
    /// It is another text.
    Differs,
    /// It is the same text with other line ends, or a byte order mark.
    LineEnds,
}

/// The files that are not in the directory as they should be, by their paths.
#[must_use]
pub fn stale<'a>(directory: &Path, files: &'a [File]) -> Vec<(&'a str, Stale)> {
    let lines = |bytes: &[u8]| str::from_utf8(bytes).map(|text| input::plain(text).into_owned()).ok();
    let wrong = |file: &File| match fs::read(directory.join(&file.path)) {
        Err(_) => Some(Stale::Missing),
        Ok(there) if there == file.bytes => None,
        Ok(there) if lines(&there).is_some_and(|text| Some(text) == lines(&file.bytes)) => Some(Stale::LineEnds),
        Ok(_) => Some(Stale::Differs),
    };
    files.iter().filter_map(|file| Some((file.path.as_str(), wrong(file)?))).collect()
}

/// The files of a generated core on disk, as its manifest lists them, and the manifest itself.
#[must_use]
pub fn core_files(directory: &Path) -> Vec<String> {
    let mut files = listed(&directory.join(MANIFEST));
    files.extend([CORE.file.to_owned(), MANIFEST.to_owned()]);
    files
}

/// The paths of all files that an unfinished writing was about, old and new.
fn unfinished(directory: &Path) -> Vec<String> {
    let bytes = fs::read(directory.join(UNFINISHED)).unwrap_or_default();
    let paths: Vec<String> = serde_json::from_slice(&bytes).unwrap_or_default();
    paths.into_iter().filter(|path| is_inside(path)).collect()
}

/// The files that a manifest lists; none if it is not there or is not one.
fn listed(manifest: &Path) -> Vec<String> {
    let text = fs::read_to_string(manifest).unwrap_or_default();
    let Ok(value) = serde_json::from_str::<serde_json::Value>(&text) else { return Vec::new() };
    let Some(known) = value["files_sha256"].as_object() else { return Vec::new() };
    known.keys().filter(|path| is_inside(path)).cloned().collect()
}

/// Whether a path stays in the directory that it is relative to: a list is a file like any other, and nothing outside
/// the directory is touched on its word.
fn is_inside(path: &str) -> bool {
    Path::new(path).components().all(|part| matches!(part, std::path::Component::Normal(_)))
}
