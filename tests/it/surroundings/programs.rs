//! Programs that hang, crash or lie, and paths that are hard to write.

use super::*;

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
    let netlist = "case \"$1\" in -V) echo 'Yosys 0.99 (fake)';; *) echo \
     '{\"modules\":{\"quadratic\":{\"cells\":{}}}}' >placed.json;; esac";
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
