//! Files on disk: whole or not at all.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use super::File;
use crate::error::Error;

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
    let known = fs::read_to_string(directory.join(kind.file)).unwrap_or_default();
    if entries.count() == 0 || known.starts_with(kind.mark) {
        return Ok(());
    }
    Err(Error::input(
        format!("{} is not empty and not {}", directory.display(), kind.what),
        "give a new or empty directory, or one that brdfgen wrote",
    ))
}

/// Writes a file under a temporary name in the same directory, and renames it: a reader sees the old content or
/// the new, never a part.
///
/// # Errors
/// If the system refuses.
pub fn write_file(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    let failed = |error| Error::io("cannot write", path, error);
    let parent = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent.to_owned(),
        _ => PathBuf::from("."),
    };
    fs::create_dir_all(&parent).map_err(failed)?;
    let mut file = NamedTempFile::new_in(&parent).map_err(failed)?;
    file.write_all(bytes).map_err(failed)?;
    make_readable(file.path()).map_err(failed)?;
    file.persist(path).map_err(|error| failed(error.error))?;
    Ok(())
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

/// Writes a core's directory. A new one appears whole, by a rename. In an existing one each file is replaced whole; its
/// `manifest.json` goes first and comes last, so that an interrupted run leaves a directory without one.
///
/// # Errors
/// If the directory is somebody else's (see [`check_target`]) or the system refuses.
pub fn write_directory(directory: &Path, files: &[File]) -> Result<(), Error> {
    write_directory_of(CORE, directory, files)
}

/// Writes a directory of another kind in the same way.
///
/// # Errors
/// If the directory is somebody else's (see [`check_target_of`]) or the system refuses.
pub fn write_directory_of(kind: Kind, directory: &Path, files: &[File]) -> Result<(), Error> {
    check_target_of(kind, directory)?;
    let failed = |error| Error::io("cannot write", directory, error);
    if directory.exists() {
        return replace(directory, files);
    }
    // `canonicalize` needs the directory to be there, and its parent is what the temporary one must share.
    let absolute = std::path::absolute(directory).map_err(failed)?;
    let parent = absolute.parent().unwrap_or(&absolute);
    fs::create_dir_all(parent).map_err(failed)?;
    let staging = tempfile::Builder::new().prefix(".brdfgen-").tempdir_in(parent).map_err(failed)?;
    for file in files {
        write_file(&staging.path().join(&file.path), &file.bytes)?;
    }
    make_readable(staging.path()).map_err(failed)?;
    fs::rename(staging.path(), directory).map_err(failed)
}

fn replace(directory: &Path, files: &[File]) -> Result<(), Error> {
    let manifest = directory.join("manifest.json");
    let stale = stale_files(&manifest, files);
    if manifest.exists() {
        fs::remove_file(&manifest).map_err(|error| Error::io("cannot replace", &manifest, error))?;
    }
    for path in stale {
        let path = directory.join(path);
        if path.is_file() {
            fs::remove_file(&path).map_err(|error| Error::io("cannot remove", &path, error))?;
        }
    }
    files.iter().try_for_each(|file| write_file(&directory.join(&file.path), &file.bytes))
}

/// The files of an earlier core in this directory that the new one does not have, by the earlier manifest.
fn stale_files(manifest: &Path, files: &[File]) -> Vec<String> {
    let text = fs::read_to_string(manifest).unwrap_or_default();
    let Ok(value) = serde_json::from_str::<serde_json::Value>(&text) else { return Vec::new() };
    let Some(known) = value["files_sha256"].as_object() else { return Vec::new() };
    // A manifest is a file like any other: nothing outside the directory is touched on its word.
    let inside =
        |path: &&String| Path::new(path).components().all(|part| matches!(part, std::path::Component::Normal(_)));
    known.keys().filter(inside).filter(|path| files.iter().all(|file| file.path != **path)).cloned().collect()
}
