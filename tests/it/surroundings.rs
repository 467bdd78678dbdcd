//! What happens around the program: disks that are full, runs that are killed, runs at the same time, external programs
//! that hang, crash or lie, paths that are hard to write.
//!
//! Needs iverilog, verilator and ghdl; `test.sh` installs them.
#![cfg(unix)]

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

/// Every command that writes, and how a message of it begins.
const WRITERS: &[&str] = &[
    "generate --method cubic --shininess 3..=9 --input-fraction 8 --output-fraction 8 --out new",
    "golden core --out new.vec",
    "rom core --out new",
    "cosim core --junit new.xml",
    "synth core --no-cache --out new.txt",
    "render scene.toml --core core --out new.png",
    "render scene.toml --core core --out new.exr",
    "explore --method quadratic --output-fraction 8 --input-fraction 8 --shininess 1..=9 --estimate --results new.db",
    "claims --out new",
    "report --out new.html --plots new",
];

#[test]
fn a_full_disk_is_one_message_and_leaves_nothing_behind() {
    let scratch = with_scene();
    let before = scratch.tree("");
    for line in WRITERS {
        println!("{line}");
        limited(&scratch, 0, line).ends_with(2).refuses_in_one_message();
        let mut after = scratch.tree("");
        // An empty folder, and an empty results file, look like nothing whole.
        after.retain(|path, content| {
            before.contains_key(path) || content.as_ref().is_some_and(|bytes| !bytes.is_empty())
        });
        assert_eq!(after, before, "{line}");
        for name in ["new", "new.db"] {
            let _ = fs::remove_dir_all(scratch.path(name)).or_else(|_| fs::remove_file(scratch.path(name)));
        }
    }
}

/// The disk is full after the first file, after the second, and so on: files of a core are of many sizes.
#[test]
fn a_disk_that_becomes_full_leaves_the_core_that_was_there() {
    let scratch = Scratch::new();
    scratch.run(&format!("generate {OTHER} --out new")).succeeds();
    let wanted = scratch.tree("new");
    scratch.run(&format!("generate {ONE} --out core")).succeeds();
    let old = scratch.tree("core");
    let sizes = |tree: &Tree| tree.values().flatten().map(Vec::len).collect::<Vec<_>>();
    let most = *sizes(&wanted).iter().max().unwrap() as u32 / 512 + 1;
    let mut failed = 0;
    for blocks in (0..most).step_by(4).chain([most]) {
        let run = limited(&scratch, blocks, &format!("generate {OTHER} --out core"));
        if run.code == 0 {
            assert_eq!(scratch.tree("core"), wanted);
            break;
        }
        run.ends_with(2).refuses_in_one_message();
        assert_eq!(scratch.tree("core"), old, "after {blocks} blocks");
        let new = limited(&scratch, blocks, &format!("generate {OTHER} --out fresh/core"));
        new.ends_with(2);
        assert!(!scratch.path("fresh/core").exists() && leftovers(&scratch.path("")).is_empty());
        failed += 1;
    }
    assert!(failed > 3, "the disk was full {failed} times only");
    assert_eq!(scratch.tree("core"), wanted);
}

impl Run {
    /// Requires a message of one fault.
    #[track_caller]
    fn refuses_in_one_message(self) -> Self {
        assert_eq!(self.stderr.lines().filter(|line| line.trim_start().starts_with('×')).count(), 1, "{}", self.stderr);
        self
    }
}

#[test]
fn a_device_is_written_to_and_not_replaced() {
    let scratch = Scratch::new();
    scratch.run(&format!("generate {ONE} --out core")).succeeds();
    for line in ["golden core --out /dev/full", "cosim core --junit /dev/full"] {
        scratch.run(line).ends_with(2).refuses_in_one_message();
    }
    scratch.run("golden core --out /dev/null").succeeds();
    for device in ["/dev/full", "/dev/null"] {
        assert!(fs::metadata(device).unwrap().file_type().is_char_device(), "{device}");
    }
    // A link is followed.
    scratch.write("real.vec", "");
    symlink("real.vec", scratch.path("link.vec")).unwrap();
    scratch.run("golden core --out link.vec").succeeds();
    assert!(fs::symlink_metadata(scratch.path("link.vec")).unwrap().is_symlink());
    assert_eq!(scratch.read("real.vec"), scratch.read("core/golden/quadratic.vec"));
}

#[test]
fn a_full_disk_behind_standard_output_is_told_and_a_reader_that_goes_away_is_not() {
    let scratch = with_scene();
    for line in ["golden core --out -", "eval core -n 32 -x 0.5", "explore --list --method quadratic", "doctor"] {
        let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let output = program(&scratch, line).stdout(full).stderr(Stdio::piped()).output().unwrap();
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{line}\n{text}");
        assert!(text.contains("cannot write to standard output") && !text.contains("panicked"), "{line}\n{text}");

        let mut child = program(&scratch, line).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        let mut pipe = child.stdout.take().unwrap();
        let mut first = [0];
        pipe.read_exact(&mut first).unwrap();
        drop(pipe);
        let output = child.wait_with_output().unwrap();
        assert_eq!((output.status.code(), output.stderr.len()), (Some(0), 0), "{line}: {output:?}");
    }
}

/// A path below a file: nobody can write there, root included.
#[test]
fn what_cannot_be_written_is_named_by_every_command() {
    let scratch = with_scene();
    let before = scratch.tree("");
    for line in WRITERS.iter().filter(|line| !line.starts_with("explore")) {
        println!("{line}");
        let line = line.replace(" new", " scene.toml/new");
        scratch.run(&line).ends_with(2).refuses_in_one_message();
        assert_eq!(scratch.tree(""), before, "{line}");
    }
}

// Killed runs

/// Requires that a core's directory has no manifest, or one that all its files agree with.
#[track_caller]
fn is_whole_or_has_no_manifest(directory: &Path) -> bool {
    let Ok(text) = fs::read_to_string(directory.join("manifest.json")) else { return false };
    let manifest: serde_json::Value = serde_json::from_str(&text).expect("a manifest is whole");
    for (path, digest) in manifest["files_sha256"].as_object().unwrap() {
        let bytes = fs::read(directory.join(path)).unwrap_or_else(|error| panic!("{path}: {error}"));
        let found: String = Sha256::digest(&bytes).iter().map(|byte| format!("{byte:02x}")).collect();
        assert_eq!(digest, &found, "{path} is not what the manifest says");
    }
    true
}

/// Runs the program, and kills it when `when` says so or when it has ended.
fn kill_when(mut command: Command, when: impl Fn() -> bool) -> ExitStatus {
    let mut child = command.spawn().unwrap();
    while child.try_wait().unwrap().is_none() && !when() {
        std::hint::spin_loop();
    }
    let _ = child.kill();
    child.wait().unwrap()
}

/// Kills at the moment of the first trace of the writing and a little later each time, so that every stage is met.
#[test]
fn a_generate_that_is_killed_leaves_nothing_that_looks_whole_and_is_finished_by_the_next() {
    let scratch = Scratch::new();
    for (name, line) in [("one", ONE), ("other", OTHER)] {
        scratch.run(&format!("generate {line} --out {name}")).succeeds();
    }
    let trees = [scratch.tree("one"), scratch.tree("other")];
    let core = scratch.path("core");
    let (mut broken, mut killed) = (0, 0);
    for round in 0..24u32 {
        let (line, wanted) = if round % 2 == 0 { (ONE, &trees[0]) } else { (OTHER, &trees[1]) };
        if round % 8 == 0 {
            let _ = fs::remove_dir_all(&core);
        }
        let begun = || !leftovers(&scratch.path("")).is_empty();
        let more = Duration::from_micros(u64::from(round / 2) * 150);
        let seen = std::cell::Cell::new(None::<Instant>);
        let when = || {
            if seen.get().is_none() && begun() {
                seen.set(Some(Instant::now()));
            }
            seen.get().is_some_and(|seen| seen.elapsed() >= more)
        };
        let status = kill_when(program(&scratch, &format!("generate {line} --out core")), when);
        killed += u32::from(status.signal() == Some(9));
        let exists = core.exists();
        broken += u32::from(exists && !is_whole_or_has_no_manifest(&core));
        scratch.run(&format!("generate {line} --out core")).succeeds();
        assert_eq!(scratch.tree("core"), *wanted, "round {round}");
        assert_eq!(leftovers(&scratch.path("")), Vec::<String>::new(), "round {round}");
    }
    println!("{killed} killed, {broken} directories without a manifest");
    assert!(killed > 0, "no run was killed in time");
}

/// Every state that a killed run can leave a directory in: the list of files, temporary files, the manifest gone, the
/// first k files new.
#[test]
fn every_state_of_an_interrupted_writing_is_finished() {
    let scratch = Scratch::new();
    for (name, line) in [("one", ONE), ("other", OTHER)] {
        scratch.run(&format!("generate {line} --out {name}")).succeeds();
    }
    let (old, new) = (scratch.tree("one"), scratch.tree("other"));
    let files = |tree: &Tree| -> BTreeMap<PathBuf, Vec<u8>> {
        tree.iter().filter_map(|(path, content)| Some((path.clone(), content.clone()?))).collect()
    };
    let (old_files, new_files) = (files(&old), files(&new));
    let known: std::collections::BTreeSet<&PathBuf> = old_files.keys().chain(new_files.keys()).collect();
    let list = serde_json::to_string(&known).unwrap();
    for state in (0..=new_files.len()).step_by(3) {
        // Into an empty directory, or over the old core; the third run is the same as the second, or makes the old
        // core.
        for (over, line, wanted) in [(false, OTHER, &new), (true, OTHER, &new), (true, ONE, &old)] {
            let _ = fs::remove_dir_all(scratch.path("core"));
            for (path, bytes) in old_files.iter().filter(|(path, _)| over && path.as_os_str() != "manifest.json") {
                scratch.write(Path::new("core").join(path), bytes);
            }
            scratch.write("core/.brdfgen-unfinished.json", &list);
            scratch.write("core/rtl/.brdfgen-aBcDe0.tmp", "module");
            for (path, bytes) in new_files.iter().filter(|(path, _)| path.as_os_str() != "manifest.json").take(state) {
                scratch.write(Path::new("core").join(path), bytes);
            }
            scratch.run(&format!("generate {line} --out core")).succeeds();
            assert_eq!(files(&scratch.tree("core")), files(wanted), "{state} files, over a core: {over}");
        }
    }
    // An empty directory whose list was not yet there.
    scratch.write("empty/.brdfgen-aBcDe1.tmp", "[");
    scratch.run(&format!("generate {ONE} --out empty")).succeeds();
    assert_eq!(scratch.tree("empty"), old);
    // Somebody else's directory does not become ours by a list that is none.
    scratch.write("theirs/.brdfgen-unfinished.json", "{}");
    scratch.refused(&format!("generate {ONE} --out theirs"), &["is not empty"]);
    // And a list names nothing elsewhere.
    scratch.write("evil/.brdfgen-unfinished.json", "[\"../precious\", \"/precious\", \"gone\"]");
    scratch.write("evil/gone", "");
    scratch.write("precious", "mine");
    scratch.run(&format!("generate {ONE} --out evil")).succeeds();
    assert_eq!((scratch.text("precious").as_str(), scratch.path("evil/gone").exists()), ("mine", false));
}

#[test]
fn other_commands_that_are_killed_leave_no_partial_file() {
    let scratch = with_scene();
    let lines = [
        ("golden core --out out/new.vec", "new.vec"),
        ("render scene.toml --core core --out out/new.png", "new.png"),
        ("render scene.toml --core core --out out/new.exr", "new.exr"),
        ("rom core --format mif --out out", "quadratic.mif"),
    ];
    for (line, name) in lines {
        fs::create_dir(scratch.path("out")).unwrap();
        let start = Instant::now();
        scratch.run(line).succeeds();
        let whole = start.elapsed();
        let wanted = scratch.tree("out");
        assert!(wanted.contains_key(Path::new(name)), "{wanted:?}");
        for part in 1..=8u32 {
            fs::remove_dir_all(scratch.path("out")).unwrap();
            fs::create_dir(scratch.path("out")).unwrap();
            let start = Instant::now();
            // The later ones wait for the file that is being written.
            let written = || part > 4 && !leftovers(&scratch.path("out")).is_empty();
            kill_when(program(&scratch, line), || written() || start.elapsed() > whole * part / 6);
            for (path, content) in scratch.tree("out") {
                let is_temporary = path.to_string_lossy().starts_with(".brdfgen-");
                assert!(is_temporary || content == wanted[&path], "{line}: {} is partial", path.display());
            }
            scratch.run(line).succeeds();
            assert_eq!(scratch.tree("out"), wanted, "{line}");
        }
        fs::remove_dir_all(scratch.path("out")).unwrap();
    }
}

// Runs at the same time

#[test]
fn runs_at_once_into_one_directory_leave_one_of_the_cores() {
    let scratch = Scratch::new();
    for (name, line) in [("one", ONE), ("other", OTHER)] {
        scratch.run(&format!("generate {line} --out {name}")).succeeds();
    }
    let trees = [scratch.tree("one"), scratch.tree("other")];
    for round in 0..6 {
        if round % 3 == 0 {
            let _ = fs::remove_dir_all(scratch.path("core"));
        }
        let start = |line: &str| program(&scratch, &format!("generate {line} --out core")).spawn().unwrap();
        let runs: Vec<Child> = [ONE, OTHER, ONE, OTHER].map(start).into();
        for mut run in runs {
            assert_eq!(run.wait().unwrap().code(), Some(0));
        }
        let found = scratch.tree("core");
        let is =
            |wanted: &Tree| found.iter().filter(|(_, c)| c.is_some()).eq(wanted.iter().filter(|(_, c)| c.is_some()));
        assert!(trees.iter().any(is), "round {round}: neither of the two: {:?}", found.keys());
        assert!(is_whole_or_has_no_manifest(&scratch.path("core")));
    }
}

const SWEEP: &str = "explore --method quadratic,cubic,lyon-4 --output-fraction 8,9,10 --input-fraction 10,12 --shininess 1..=40 --estimate --jobs 1";

#[test]
fn two_explorations_share_a_results_file_but_none_is_emptied_under_another() {
    let scratch = Scratch::new();
    let mut runs = [0, 1].map(|_| program(&scratch, &format!("{SWEEP} --results both.db")).spawn().unwrap());
    for run in &mut runs {
        assert_eq!(run.wait().unwrap().code(), Some(0));
    }
    scratch.run(&format!("{SWEEP} --results one.db --csv one.csv")).succeeds();
    scratch.run(&format!("{SWEEP} --results both.db --csv both.csv")).succeeds().says(&["0 points made"]);
    assert_eq!(scratch.text("one.csv"), scratch.text("both.csv"));

    // A run that works with the file holds it, as this does.
    let held = fs::File::open(scratch.path("both.db")).unwrap();
    held.lock_shared().unwrap();
    let before = scratch.read("both.db");
    scratch.run(&format!("{SWEEP} --results both.db --fresh")).refuses_in_words(&["another run", "both.db", "--fresh"]);
    assert_eq!(scratch.read("both.db"), before);
    scratch.run(&format!("{SWEEP} --results both.db")).succeeds();
    drop(held);
    scratch.run(&format!("{SWEEP} --results both.db --fresh")).succeeds().says(&["18 points made"]);
}

impl Run {
    #[track_caller]
    fn refuses_in_words(self, words: &[&str]) -> Self {
        let run = self.ends_with(2).refuses_in_one_message();
        for word in words {
            assert!(run.stderr.contains(word), "`{word}` is not in\n{}", run.stderr);
        }
        run
    }
}

// External programs

/// Puts shell scripts into a directory for programs.
fn fake(scratch: &Scratch, programs: &[(&str, &str)]) -> PathBuf {
    let directory = scratch.path("fake");
    let _ = fs::remove_dir_all(&directory);
    for (name, script) in programs {
        let path = format!("fake/{name}");
        scratch.write(&path, format!("#!/bin/sh\n{script}\n"));
        fs::set_permissions(scratch.path(path), fs::Permissions::from_mode(0o755)).unwrap();
    }
    directory
}

/// Runs the program with the fake programs before the system's.
fn with_fakes(scratch: &Scratch, programs: &[(&str, &str)], line: &str) -> Run {
    let directory = fake(scratch, programs);
    let mut path = directory.into_os_string();
    path.push(":/usr/bin:/bin");
    let output = scratch.command().env("PATH", path).args(line.split_whitespace()).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8_lossy(&bytes).into_owned();
    let code = output.status.code().unwrap_or_else(|| panic!("{line}: {}", output.status));
    Run { code, stdout: text(output.stdout), stderr: text(output.stderr) }
}

fn is_alive(pid: &str) -> bool {
    let pid = Pid::from_raw(pid.trim().parse().unwrap()).unwrap();
    // A process that nobody waits for any more may stay as a zombie, in a container without an init.
    let stat = fs::read_to_string(format!("/proc/{}/stat", pid.as_raw_nonzero())).unwrap_or_default();
    test_kill_process(pid).is_ok() && !stat.rsplit(')').next().unwrap_or_default().trim_start().starts_with('Z')
}

/// A program that starts another, tells its number, and waits for ever.
const HANGS: &str = "sleep 1000 & echo $! >\"$PIDS/$$\"; wait";

const YOSYS: &str = "case \"$1\" in -V) echo 'Yosys 0.99 (fake)';; *) HANG;; esac";

#[test]
fn a_program_that_hangs_is_stopped_with_all_that_it_started() {
    let scratch = Scratch::new();
    scratch.run(&format!("generate {ONE} --out core")).succeeds();
    fs::create_dir(scratch.path("pids")).unwrap();
    let hangs = HANGS.replace("$PIDS", scratch.path("pids").to_str().unwrap());
    let yosys = YOSYS.replace("HANG", &hangs);
    // A netlist of the core, for the program after it.
    let netlist = "case \"$1\" in -V) echo 'Yosys 0.99 (fake)';; *) echo '{\"modules\":{\"quadratic\":{\"cells\":{}}}}' >placed.json;; esac";
    let place = format!("case \"$1\" in --version) echo 'nextpnr 9';; *) {hangs};; esac");
    let silent = format!("exit 0;{hangs}");
    let makes = "while [ \"$1\" != -o ]; do shift; done; : >\"$2\"";
    for (programs, line, who) in [
        (vec![("iverilog", hangs.as_str())], "cosim core --sim icarus", "iverilog"),
        (vec![("iverilog", makes), ("vvp", &hangs)], "cosim core --sim icarus", "vvp"),
        (vec![("verilator", &hangs)], "cosim core --sim verilator", "verilator"),
        (vec![("ghdl", &hangs)], "cosim core --sim ghdl", "ghdl"),
        (vec![("ghdl", &hangs)], "cosim core --sim ghdl --exhaustive", "ghdl"),
        (vec![("yosys", &yosys), ("ghdl", &silent)], "synth core --yosys yosys --no-cache --no-place", "yosys"),
        (
            vec![("yosys", netlist), ("nextpnr-ecp5", &place)],
            "synth core --yosys yosys --no-cache --no-pack",
            "nextpnr-ecp5",
        ),
    ] {
        let start = Instant::now();
        let run = with_fakes(&scratch, &programs, &format!("{line} --time-limit 1"));
        run.refuses_in_words(&[&format!("{who} was stopped"), "within 1 s", "--time-limit"]);
        assert!(start.elapsed() < Duration::from_secs(60), "{line}");
        let started: Vec<PathBuf> =
            fs::read_dir(scratch.path("pids")).unwrap().map(|entry| entry.unwrap().path()).collect();
        assert!(!started.is_empty(), "{who} was not started");
        for path in started {
            let pid = fs::read_to_string(&path).unwrap();
            wait_until(&format!("the end of what {who} started"), || !is_alive(&pid));
            fs::remove_file(path).unwrap();
        }
    }
}

/// What a bench prints at its end, of `$1` vectors.
const VERDICT: &str = "brdfgen: quadratic: ";

#[test]
fn programs_that_crash_or_lie_are_not_believed() {
    let scratch = Scratch::new();
    scratch.run(&format!("generate {ONE} --out core")).succeeds();
    let vectors = brdfgen_vectors(&scratch);
    let whole = format!("echo '{VERDICT}{vectors} vectors compared, 0 mismatches: PASS'");
    let makes = "while [ \"$1\" != -o ]; do shift; done; : >\"$2\"";
    let icarus = |vvp: &str| with_fakes(&scratch, &[("iverilog", makes), ("vvp", vvp)], "cosim core --sim icarus");
    // The lie itself is well-formed: alone it passes, which shows that what follows fails for what is added.
    icarus(&whole).ends_with(0).says(&["PASS icarus"]);
    for (what, vvp) in [
        ("silent", "exit 0".to_owned()),
        ("killed by a signal", "kill -SEGV $$".to_owned()),
        ("a signal after the verdict", format!("{whole}; kill -ABRT $$")),
        ("a status after the verdict", format!("{whole}; exit 3")),
        ("fewer vectors", format!("echo '{VERDICT}{} vectors compared, 0 mismatches: PASS'", vectors - 1)),
        ("more vectors", format!("echo '{VERDICT}{} vectors compared, 0 mismatches: PASS'", vectors + 1)),
        ("none", format!("echo '{VERDICT}0 vectors compared, 0 mismatches: PASS'")),
        ("a mismatch that passes", format!("echo '{VERDICT}{vectors} vectors compared, 1 mismatches: PASS'")),
        ("a failure without a mismatch", format!("echo '{VERDICT}{vectors} vectors compared, 0 mismatches: FAIL'")),
        ("numbers that are none", format!("echo '{VERDICT}all vectors compared, no mismatches: PASS'")),
        (
            "a number beyond all",
            format!("echo '{VERDICT}99999999999999999999999 vectors compared, 0 mismatches: PASS'"),
        ),
        ("another core's verdict", whole.replace("quadratic", "quadratic2")),
        ("half a verdict", format!("printf '{VERDICT}{vectors} vectors compared, 0 mis'")),
        ("bytes", "head -c 100000 /dev/urandom".to_owned()),
        (
            "a verdict that is taken back",
            format!("{whole}; echo '{VERDICT}{vectors} vectors compared, 2 mismatches: FAIL'; exit 1"),
        ),
    ] {
        let run = icarus(&vvp);
        assert_eq!(run.code, 1, "{what}\n{}{}", run.stdout, run.stderr);
        assert!(run.stdout.contains("PASS model") && run.stdout.contains("FAIL icarus"), "{what}\n{}", run.stdout);
        assert!(!run.stderr.contains("panicked"), "{what}\n{}", run.stderr);
    }
    icarus("kill -SEGV $$").says(&["signal: 11"]);
    with_fakes(&scratch, &[("iverilog", "kill -SEGV $$")], "cosim core --sim icarus")
        .ends_with(1)
        .says(&["signal: 11"]);
    with_fakes(&scratch, &[("iverilog", "exit 0")], "cosim core --sim icarus").ends_with(1);
    for script in ["exit 0", "kill -SEGV $$", "head -c 100000 /dev/urandom", "head -c 100000 /dev/urandom; exit 1"] {
        for (program, line) in [("ghdl", "--sim ghdl"), ("verilator", "--sim verilator")] {
            let run = with_fakes(&scratch, &[(program, script)], &format!("cosim core {line}"));
            assert!(run.code == 1 || run.code == 2, "{program}: {script}\n{}", run.stdout);
            assert!(!run.stderr.contains("panicked"), "{program}: {script}\n{}", run.stderr);
            let run = with_fakes(&scratch, &[(program, script)], &format!("cosim core {line} --exhaustive"));
            assert!(run.code == 1 || run.code == 2, "{program}: {script}\n{}", run.stdout);
            assert!(!run.stderr.contains("panicked"), "{program}: {script}\n{}", run.stderr);
        }
    }
}

/// How many vectors the core has.
fn brdfgen_vectors(scratch: &Scratch) -> u64 {
    let answer = scratch.run("golden core --check core/golden/quadratic.vec --json").succeeds().json();
    answer["vectors"].as_u64().unwrap()
}

#[test]
fn a_program_that_prints_without_end_is_stopped() {
    let scratch = Scratch::new();
    scratch.run(&format!("generate {ONE} --out core")).succeeds();
    for script in ["exec yes rubbish", "exec yes rubbish >&2", "exec cat /dev/zero"] {
        let run = with_fakes(&scratch, &[("iverilog", script)], "cosim core --sim icarus");
        run.refuses_in_words(&["iverilog failed", "more than 64 MiB"]);
    }
}

#[test]
fn synthesis_that_crashes_or_lies_is_not_believed() {
    let scratch = Scratch::new();
    scratch.run(&format!("generate {ONE} --out core")).succeeds();
    let yosys = |work: &str| format!("case \"$1\" in -V) echo 'Yosys 0.99 (fake)';; *) {work};; esac");
    let nextpnr = |work: &str| format!("case \"$1\" in --version) echo 'nextpnr 9';; *) {work};; esac");
    let netlist = "echo '{\"modules\":{\"quadratic\":{\"cells\":{}}}}' >placed.json";
    for (work, words) in [
        ("exit 0", "wrote no placed.json"),
        ("kill -SEGV $$", "signal: 11"),
        ("exit 3", "exit status: 3"),
        ("head -c 5000 /dev/urandom >placed.json", "not whole"),
        ("echo '{\"modules\":{' >placed.json", "not whole"),
        ("echo '{\"modules\":7}' >placed.json", "no modules"),
        ("echo '{\"modules\":{}}' >placed.json", "quadratic"),
        ("mkdir placed.json", "placed.json"),
    ] {
        let script = yosys(work);
        let run =
            with_fakes(&scratch, &[("yosys", &script)], "synth core --yosys yosys --no-cache --no-place --no-pack");
        run.refuses_in_words(&["yosys failed", words]);
    }
    let right = yosys(netlist);
    for (work, words) in [
        ("exit 0", "wrote no report.json"),
        ("kill -SEGV $$", "signal: 11"),
        ("head -c 5000 /dev/urandom >report.json", "not whole"),
        ("echo '{}' >report.json", "no clocks"),
        ("echo '{\"fmax\":{\"clk\":{\"achieved\":-1}}}' >report.json", "reaches"),
        ("echo '{\"fmax\":{\"clk\":{\"achieved\":1e999}}}' >report.json", "not whole"),
    ] {
        let place = nextpnr(work);
        let run = with_fakes(
            &scratch,
            &[("yosys", &right), ("nextpnr-ecp5", &place)],
            "synth core --yosys yosys --no-cache --no-pack --seeds 1",
        );
        run.refuses_in_words(&["failed", words]);
    }
}

// Signals

#[test]
fn a_signal_ends_what_was_started_and_removes_what_is_temporary() {
    let scratch = Scratch::new();
    scratch.run(&format!("generate {ONE} --out core")).succeeds();
    fs::create_dir(scratch.path("pids")).unwrap();
    let hangs = HANGS.replace("$PIDS", scratch.path("pids").to_str().unwrap());
    let mut path = fake(&scratch, &[("iverilog", &hangs)]).into_os_string();
    path.push(":/usr/bin:/bin");
    let temporary = scratch.path("temporary");
    fs::create_dir(&temporary).unwrap();
    let count = || fs::read_dir(&temporary).unwrap().count();
    let start = || {
        let mut command = program(&scratch, "cosim core --sim icarus");
        let child = command.env("PATH", &path).env("TMPDIR", &temporary).spawn().unwrap();
        wait_until("a simulator", || {
            let mut pids = fs::read_dir(scratch.path("pids")).unwrap().flatten();
            pids.any(|entry| fs::read_to_string(entry.path()).is_ok_and(|text| text.ends_with('\n')))
        });
        child
    };
    let pid = || {
        let entry = fs::read_dir(scratch.path("pids")).unwrap().next().unwrap().unwrap();
        let pid = fs::read_to_string(entry.path()).unwrap();
        fs::remove_file(entry.path()).unwrap();
        pid
    };
    // A signal that is ignored here, as SIGHUP is under `nohup`, is ignored by what is started here.
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let ignored = ignored.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0);
    let heeded = |signal: &Signal| ignored >> (signal.as_raw() - 1) & 1 == 0;
    for signal in [Signal::TERM, Signal::INT, Signal::HUP].into_iter().filter(heeded) {
        let mut child = start();
        let started = pid();
        assert!(is_alive(&started) && count() == 1, "{signal:?}");
        kill_process(Pid::from_child(&child), signal).unwrap();
        let status = child.wait().unwrap();
        assert_eq!(status.signal(), Some(signal.as_raw()), "it ends as a program ends at this signal: {status}");
        assert_eq!(count(), 0, "{signal:?}");
        wait_until("the simulator's end", || !is_alive(&started));
    }

    // SIGKILL leaves things behind; the next run removes them, and not those of a run that lives.
    let mut killed = start();
    let orphan = pid();
    killed.kill().unwrap();
    killed.wait().unwrap();
    assert_eq!(count(), 1);
    let mut living = start();
    let started = pid();
    assert_eq!(count(), 1, "the living run has removed what the killed one left");
    scratch.write("temporary/brdfgen-mine", "the user's own");
    let output = program(&scratch, "cosim core --sim ghdl").env("TMPDIR", &temporary).output().unwrap();
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(count(), 2, "the living run's directory and the user's own file are there");
    assert!(living.try_wait().unwrap().is_none());
    kill_process(Pid::from_child(&living), Signal::TERM).unwrap();
    living.wait().unwrap();
    assert_eq!(count(), 1);
    wait_until("the simulator's end", || !is_alive(&started));
    // What the killed run started is nobody's any more.
    let orphan = Pid::from_raw(orphan.trim().parse().unwrap()).unwrap();
    let _ = kill_process(orphan, Signal::KILL);
}

#[test]
fn a_signal_that_is_ignored_stays_ignored() {
    let scratch = Scratch::new();
    scratch.run(&format!("generate {ONE} --out core")).succeeds();
    fs::create_dir(scratch.path("pids")).unwrap();
    let hangs = HANGS.replace("$PIDS", scratch.path("pids").to_str().unwrap());
    let mut path = fake(&scratch, &[("iverilog", &hangs)]).into_os_string();
    path.push(":/usr/bin:/bin");
    // As nohup does.
    let script = "trap '' HUP; exec \"$0\" cosim core --sim icarus --time-limit 2";
    let mut command = Command::new("/bin/sh");
    command.current_dir(scratch.path("")).env("PATH", &path).args(["-c", script, env!("CARGO_BIN_EXE_brdfgen")]);
    let mut child = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
    wait_until("a simulator", || fs::read_dir(scratch.path("pids")).unwrap().count() > 0);
    kill_process(Pid::from_child(&child), Signal::HUP).unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(2), "it goes on until its simulator's time is over");
}

// Paths

/// Names that a shell, a Makefile, a Tcl script or a library file could misread.
fn hard_names() -> Vec<OsString> {
    let names: [&[u8]; 4] =
        [b"two words", b"it's \"so\" $HOME `x` #1 & (2);", b"latin-\xe9\xff", "φωτεινότητα 光".as_bytes()];
    names.iter().map(|name| OsStr::from_bytes(name).to_owned()).collect()
}

#[test]
fn simulators_work_at_any_path_and_with_any_temporary_folder() {
    for name in hard_names() {
        let scratch = Scratch::new();
        let core = scratch.path(&name).join("core");
        let temporary = scratch.path(&name).join("temporary");
        let mut generate: Vec<OsString> =
            ["generate"].iter().chain(&ONE.split(' ').collect::<Vec<_>>()).map(Into::into).collect();
        generate.extend([OsString::from("--out"), core.clone().into()]);
        scratch.run_each(&generate).succeeds();
        fs::create_dir(&temporary).unwrap();
        // Verilator takes ten seconds: once each for the two names that Make minds most.
        let sims =
            if name.as_bytes().contains(&b' ') { "builtin icarus ghdl verilator" } else { "builtin icarus ghdl" };
        for sim in sims.split(' ') {
            let mut command = scratch.command();
            command.env("TMPDIR", &temporary).arg("cosim").arg(&core).args(["--sim", sim]);
            let output = command.output().unwrap();
            let text =
                format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
            assert_eq!(output.status.code(), Some(0), "{name:?} {sim}\n{text}");
            assert_eq!(fs::read_dir(&temporary).unwrap().count(), 0, "{name:?} {sim}");
        }
    }
}

#[test]
fn other_commands_work_at_any_path() {
    let scratch = with_scene();
    for name in hard_names() {
        let at = |inside: &str| scratch.path(&name).join(inside).into_os_string();
        let run = |words: &[&OsStr]| scratch.run_each(words).succeeds();
        let word = OsStr::new;
        fs::create_dir(scratch.path(&name)).unwrap();
        fs::copy(scratch.path("scene.toml"), at("scene.toml")).unwrap();
        let sweep =
            "[[sweep]]\nmethod = [\"quadratic\"]\nshininess = \"1..=9\"\noutput_fraction = 8\ninput_fraction = 8\n";
        fs::write(at("sweep.toml"), sweep).unwrap();
        run(&[word("scene"), word("inspect"), &at("scene.toml")]);
        run(&[word("render"), &at("scene.toml"), word("--core"), word("core"), word("--out"), &at("picture.png")]);
        run(&[word("render"), &at("scene.toml"), word("--core"), word("core"), word("--out"), &at("picture.exr")]);
        let (results, csv, json) = (at("results.db"), at("r.csv"), at("r.json"));
        run(&[
            word("explore"),
            &at("sweep.toml"),
            word("--estimate"),
            word("--results"),
            &results,
            word("--csv"),
            &csv,
            word("--json"),
            &json,
        ]);
        for results in [&results, &csv, &json] {
            run(&[
                word("choose"),
                word("--results"),
                results,
                word("--max-error"),
                word("0.3"),
                word("--shininess"),
                word("1..=9"),
            ]);
        }
        let answer = run(&[word("golden"), word("core"), word("--out"), &at("g.vec"), word("--json")]).json();
        assert!(answer["file"].as_str().unwrap().ends_with("g.vec"));
        for made in ["picture.png", "picture.exr", "g.vec"] {
            assert!(Path::new(&at(made)).metadata().unwrap().len() > 100, "{made}");
        }
    }
}
