//! What must not outlive a run: its temporary files and directories, and the programs that it started.
//!
//! Temporary things have names that nothing else has, `brdfgen-XXXXXX.tmp` or `.brdfgen-XXXXXX.tmp`, and are locked
//! while their owner lives. They go away with what holds them, and at SIGINT, SIGTERM and SIGHUP
//! ([`clean_on_signals`]). A run that is killed outright leaves them behind without their lock; the next run that makes
//! something in the same directory removes them.

use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Child, Command};
use std::sync::{Mutex, MutexGuard, PoisonError};

use tempfile::{Builder, NamedTempFile, TempDir};

/// How the names of temporary things begin; a dot before it hides those that lie among the user's files.
const PREFIX: &str = "brdfgen-";
const HIDDEN: &str = ".brdfgen-";
const SUFFIX: &str = ".tmp";
/// Characters between the two.
const RANDOM: usize = 6;

/// What there is now.
struct Live {
    /// Process groups, by the number of their first process.
    groups: BTreeSet<u32>,
    directories: BTreeSet<PathBuf>,
    files: BTreeSet<PathBuf>,
    /// Directories in which the leftovers of killed runs were looked for.
    swept: BTreeSet<PathBuf>,
}

static LIVE: Mutex<Live> = Mutex::new(Live {
    groups: BTreeSet::new(),
    directories: BTreeSet::new(),
    files: BTreeSet::new(),
    swept: BTreeSet::new(),
});

fn live() -> MutexGuard<'static, Live> {
    LIVE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A directory that goes away with this value.
#[derive(Debug)]
pub struct Folder {
    directory: TempDir,
    /// Holds the lock.
    _lock: Option<File>,
}

impl Folder {
    /// A new directory in the system's temporary one.
    ///
    /// # Errors
    /// If the system refuses.
    pub fn new() -> io::Result<Self> {
        Self::new_at(&std::env::temp_dir())
    }

    /// A new directory in `parent`, which must be there and is a temporary one.
    ///
    /// # Errors
    /// If the system refuses.
    pub fn new_at(parent: &Path) -> io::Result<Self> {
        Self::named(PREFIX, parent)
    }

    /// A new hidden directory in `parent`, which must be there.
    ///
    /// # Errors
    /// If the system refuses.
    pub fn new_in(parent: &Path) -> io::Result<Self> {
        Self::named(HIDDEN, parent)
    }

    fn named(prefix: &str, parent: &Path) -> io::Result<Self> {
        // A relative directory would be another one for the programs that are started elsewhere.
        let parent = std::path::absolute(parent)?;
        sweep(&parent);
        loop {
            let directory = {
                let mut live = live();
                let made = Builder::new().prefix(prefix).suffix(SUFFIX).rand_bytes(RANDOM).tempdir_in(&parent)?;
                live.directories.insert(made.path().to_owned());
                made
            };
            match owned(directory.path()) {
                Some(lock) => return Ok(Self { directory, _lock: lock }),
                None => _ = live().directories.remove(directory.path()),
            }
        }
    }

    /// Its path.
    #[must_use]
    pub fn path(&self) -> &Path {
        self.directory.path()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        // Removed here, as the field's own removal would come after it is no longer known.
        let _ = fs::remove_dir_all(self.directory.path());
        live().directories.remove(self.directory.path());
    }
}

/// A file that goes away with this value, unless it is given its final name.
#[derive(Debug)]
pub struct Draft(Option<NamedTempFile>);

impl Draft {
    /// A new hidden file in `parent`, which must be there.
    ///
    /// # Errors
    /// If the system refuses.
    pub fn new_in(parent: &Path) -> io::Result<Self> {
        let parent = std::path::absolute(parent)?;
        sweep(&parent);
        loop {
            let file = {
                let mut live = live();
                let made = Builder::new().prefix(HIDDEN).suffix(SUFFIX).rand_bytes(RANDOM).tempfile_in(&parent)?;
                live.files.insert(made.path().to_owned());
                made
            };
            // Its own handle holds the lock.
            let locked = file.as_file().lock();
            if locked.is_err() || same(file.as_file(), file.path()) {
                return Ok(Self(Some(file)));
            }
            live().files.remove(file.path());
        }
    }

    fn inner(&self) -> &NamedTempFile {
        self.0.as_ref().expect("a file until it is kept or dropped")
    }

    /// Its path.
    #[must_use]
    pub fn path(&self) -> &Path {
        self.inner().path()
    }

    /// The file.
    #[must_use]
    pub fn file(&self) -> &File {
        self.inner().as_file()
    }

    /// Gives it its final name, in the place of what has this name.
    ///
    /// # Errors
    /// If the system refuses.
    pub fn keep_as(mut self, path: &Path) -> io::Result<()> {
        let file = self.0.take().expect("a file until it is kept or dropped");
        let own = file.path().to_owned();
        let kept = file.persist(path).map(drop).map_err(|error| error.error);
        live().files.remove(&own);
        kept
    }
}

impl Drop for Draft {
    fn drop(&mut self) {
        if let Some(file) = self.0.take() {
            let path = file.path().to_owned();
            drop(file);
            live().files.remove(&path);
        }
    }
}

/// The lock of a new directory, none on a file system that has no locks; nothing if another run has taken the directory
/// for a leftover and removed it before it was locked.
#[cfg(unix)]
fn owned(directory: &Path) -> Option<Option<File>> {
    let file = File::open(directory).ok()?;
    match file.lock() {
        Err(_) => Some(None),
        Ok(()) => same(&file, directory).then_some(Some(file)),
    }
}

#[cfg(not(unix))]
fn owned(_: &Path) -> Option<Option<File>> {
    Some(None)
}

/// Whether the open file is the one that has the path.
#[cfg(unix)]
fn same(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let id = |metadata: fs::Metadata| (metadata.dev(), metadata.ino());
    file.metadata().ok().map(id).is_some_and(|open| fs::symlink_metadata(path).ok().map(id) == Some(open))
}

#[cfg(not(unix))]
fn same(_: &File, _: &Path) -> bool {
    true
}

/// Removes from a directory what killed runs left there; once for each directory. What cannot be removed stays.
pub fn sweep(directory: &Path) {
    let Ok(directory) = std::path::absolute(directory) else { return };
    if !live().swept.insert(directory.clone()) {
        return;
    }
    let Ok(entries) = fs::read_dir(directory) else { return };
    for entry in entries.flatten().filter(|entry| is_temporary(&entry.file_name())) {
        remove_leftover(&entry.path());
    }
}

/// Whether a name is that of a temporary file or directory of ours.
#[must_use]
pub fn is_temporary(name: &OsStr) -> bool {
    let name = name.to_string_lossy();
    let middle =
        name.strip_prefix('.').unwrap_or(&name).strip_prefix(PREFIX).and_then(|rest| rest.strip_suffix(SUFFIX));
    middle.is_some_and(|middle| middle.len() == RANDOM && middle.bytes().all(|byte| byte.is_ascii_alphanumeric()))
}

/// Removes a temporary file or directory of this user that nobody holds the lock of.
#[cfg(unix)]
fn remove_leftover(path: &Path) {
    use std::os::unix::fs::MetadataExt;

    use rustix::fs::{Mode, OFlags, open};

    let own = |metadata: &fs::Metadata| metadata.uid() == rustix::process::geteuid().as_raw();
    let Some(metadata) = fs::symlink_metadata(path).ok().filter(own) else { return };
    // Neither through a link nor waiting for a pipe's other end: the temporary folder is everybody's.
    let flags = OFlags::RDONLY | OFlags::NOFOLLOW | OFlags::NONBLOCK | OFlags::CLOEXEC;
    let Ok(file) = open(path, flags, Mode::empty()).map(File::from) else { return };
    if file.try_lock().is_ok() && same(&file, path) {
        let _ = if metadata.is_dir() { fs::remove_dir_all(path) } else { fs::remove_file(path) };
    }
}

#[cfg(not(unix))]
fn remove_leftover(_: &Path) {}

/// Processes that were started together, the first of them and all that it starts.
#[derive(Debug)]
pub(crate) struct Group(u32);

impl Group {
    /// Starts a program in a group of its own.
    pub(crate) fn spawn(command: &mut Command) -> io::Result<(Self, Child)> {
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(command, 0);
        // Under the lock, so that a signal finds every program that is there.
        let mut live = live();
        let child = command.spawn()?;
        live.groups.insert(child.id());
        Ok((Self(child.id()), child))
    }

    /// Its number.
    pub(crate) fn id(&self) -> u32 {
        self.0
    }
}

impl Drop for Group {
    fn drop(&mut self) {
        live().groups.remove(&self.0);
    }
}

/// Ends all processes of a group at once.
#[cfg(unix)]
pub(crate) fn kill_group(group: u32) {
    use rustix::process::{Pid, Signal, kill_process_group};
    if let Some(group) = i32::try_from(group).ok().and_then(Pid::from_raw) {
        let _ = kill_process_group(group, Signal::KILL);
    }
}

#[cfg(not(unix))]
pub(crate) fn kill_group(_: u32) {}

/// From now on SIGINT, SIGTERM and SIGHUP end the programs that were started and remove what is temporary, before they
/// end this one as they always do. A signal that is ignored, as under `nohup`, stays ignored. A file that grows beyond
/// the size that the user is allowed (`ulimit -f`) is an error of writing, and no longer the end of the program.
#[cfg(unix)]
pub fn clean_on_signals() {
    use std::time::Duration;

    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM, SIGXFSZ};
    use signal_hook::iterator::Signals;

    let ignored = ignored_signals();
    let heeded = [SIGINT, SIGTERM, SIGHUP].into_iter().filter(|signal| ignored >> (signal - 1) & 1 == 0);
    // Without a thread or a handler the signals do what they do to every program.
    let Ok(mut signals) = Signals::new(heeded.chain([SIGXFSZ])) else { return };
    let wait = move || {
        let Some(signal) = signals.forever().find(|signal| *signal != SIGXFSZ) else { return };
        // Held to the end: nothing new is started or made.
        let live = live();
        live.groups.iter().copied().for_each(kill_group);
        for file in &live.files {
            let _ = fs::remove_file(file);
        }
        // A program that has been told to end may still write for a moment.
        for _ in 0..100 {
            let left = live.directories.iter().filter(|path| fs::remove_dir_all(path).is_err() && path.exists());
            if left.count() == 0 {
                break;
            }
            std::thread::sleep(Duration::from_millis(10));
        }
        let _ = signal_hook::low_level::emulate_default_handler(signal);
        std::process::exit(128 + signal);
    };
    let _ = std::thread::Builder::new().name("signals".to_owned()).spawn(wait);
}

/// Does nothing where there are no signals.
#[cfg(not(unix))]
pub fn clean_on_signals() {}

/// The signals that are ignored, a bit each, the lowest for signal 1; none where the system does not tell.
#[cfg(unix)]
fn ignored_signals() -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_our_own_names_are_temporary() {
        for name in ["brdfgen-aB3xYz.tmp", ".brdfgen-000000.tmp"] {
            assert!(is_temporary(OsStr::new(name)), "{name}");
        }
        for name in ["brdfgen-results", "brdfgen-aB3xYz", "brdfgen-a.tmp", "brdfgen-aB3-Yz.tmp", "x.brdfgen-aB3xYz.tmp"]
        {
            assert!(!is_temporary(OsStr::new(name)), "{name}");
        }
    }

    #[test]
    fn what_a_dead_run_left_goes_and_what_a_live_one_has_stays() {
        let parent = tempfile::tempdir().unwrap();
        let dead = [parent.path().join("brdfgen-dead00.tmp"), parent.path().join(".brdfgen-dead01.tmp")];
        fs::create_dir(&dead[0]).unwrap();
        fs::write(dead[0].join("file"), "left").unwrap();
        fs::write(&dead[1], "left").unwrap();
        let other = parent.path().join("brdfgen-mine");
        fs::create_dir(&other).unwrap();
        // Of another run that lives: locked, by a handle that this one does not know.
        let live = parent.path().join(".brdfgen-live00.tmp");
        fs::create_dir(&live).unwrap();
        let handle = File::open(&live).unwrap();
        handle.lock().unwrap();
        let made = Folder::new_in(parent.path()).unwrap();
        assert!(dead.iter().all(|path| !path.exists()), "the leftovers are gone");
        assert!(other.exists() && live.exists() && made.path().exists());
        let path = made.path().to_owned();
        drop(made);
        assert!(!path.exists());
        // Each directory is looked through once; forgotten, the lock's end shows.
        super::live().swept.clear();
        sweep(parent.path());
        assert!(live.exists());
        drop(handle);
        super::live().swept.clear();
        sweep(parent.path());
        assert!(!live.exists() && other.exists());
    }
}
