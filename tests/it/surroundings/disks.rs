//! Disks that fill, runs that are killed, and runs at once.

use super::*;

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

const SWEEP: &str = "explore --method quadratic,cubic,lyon-4 --output-fraction 8,9,10 --input-fraction 10,12 \
 --shininess 1..=40 --estimate --jobs 1";

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

// External programs
