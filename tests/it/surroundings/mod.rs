//! What happens around the program: disks that are full, runs that are killed, runs at the same time, external programs
//! that hang, crash or lie, paths that are hard to write.
//!
//! Needs iverilog, verilator and ghdl; `test.sh` installs them.
#![cfg(unix)]

mod disks;
mod programs;

use std::collections::BTreeMap;
use std::ffi::{OsStr, OsString};
use std::fs;
use std::io::Read;
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};
use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

use rustix::process::{Pid, Signal, kill_process, test_kill_process};
use sha2::{Digest, Sha256};

use crate::common::{Run, Scratch, Tree};

/// Two cores with other files: one has a ROM in a file for its benches, the other another name and widths.
const ONE: &str = "--method quadratic --shininess 1,5,20.5 --input-fraction 8 --output-fraction 8";
const OTHER: &str =
    "--method cubic --shininess 3..=9 --input-fraction 8 --output-fraction 8 --operand versine --languages verilog";

/// Longer than any of these tests takes on a slow machine.
const PATIENCE: Duration = Duration::from_secs(100);

/// Waits until something is so.
#[track_caller]
fn wait_until(what: &str, is_so: impl Fn() -> bool) {
    let start = Instant::now();
    while !is_so() {
        assert!(start.elapsed() < PATIENCE, "{what} did not come about");
        std::thread::sleep(Duration::from_millis(5));
    }
}

/// The names of what is in a directory that a run should have removed.
fn leftovers(directory: &Path) -> Vec<String> {
    let mut found = Vec::new();
    let mut open = vec![directory.to_owned()];
    while let Some(directory) = open.pop() {
        for entry in fs::read_dir(&directory).unwrap().flatten() {
            let name = entry.file_name().to_string_lossy().into_owned();
            if name.contains("brdfgen-") && (name.ends_with(".tmp") || name.ends_with("unfinished.json")) {
                found.push(name);
            } else if entry.file_type().unwrap().is_dir() {
                open.push(entry.path());
            }
        }
    }
    found
}

/// The program with these words as its arguments, not yet started.
fn program(scratch: &Scratch, line: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_brdfgen"));
    command.current_dir(scratch.path("")).args(line.split_whitespace());
    command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command
}

// Full disks

/// Runs the program with files limited to `blocks` of 512 bytes: writing more fails as on a full disk, for any user.
fn limited(scratch: &Scratch, blocks: u32, line: &str) -> Run {
    let script = format!("ulimit -f {blocks}; exec \"$0\" {line}");
    let mut command = Command::new("/bin/sh");
    command.current_dir(scratch.path("")).args(["-c", &script, env!("CARGO_BIN_EXE_brdfgen")]);
    let output = command.output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    let code = output.status.code().unwrap_or_else(|| panic!("{line}: {}", output.status));
    Run { code, stdout: text(output.stdout), stderr: text(output.stderr) }
}

/// A scene of a few pixels, and a core for it.
fn with_scene() -> Scratch {
    let scratch = Scratch::new();
    let sphere = fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/sphere.toml")).unwrap();
    let small = sphere
        .replace("width = 640", "width = 64")
        .replace("height = 480", "height = 48")
        .replace("max_steps = 1", "max_steps = 255");
    assert_ne!(small, sphere);
    scratch.write("scene.toml", small);
    scratch
        .run("generate --method quadratic --shininess 32 --input-fraction 12 --output-fraction 8 --out core")
        .succeeds();
    scratch
}

impl Run {
    /// Requires a message of one fault.
    #[track_caller]
    fn refuses_in_one_message(self) -> Self {
        assert_eq!(self.stderr.lines().filter(|line| line.trim_start().starts_with('×')).count(), 1, "{}", self.stderr);
        self
    }

    #[track_caller]
    fn refuses_in_words(self, words: &[&str]) -> Self {
        let run = self.ends_with(2).refuses_in_one_message();
        for word in words {
            assert!(run.stderr.contains(word), "`{word}` is not in\n{}", run.stderr);
        }
        run
    }
}
