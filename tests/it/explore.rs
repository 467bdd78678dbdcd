//! Sweeps, the choice among their points, and what happens when they are interrupted, through the program itself.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

use brdfgen::explore::store::Earlier;
use brdfgen::explore::{Point, Results, Store};
use serde_json::Value;

/// A sweep of many cores, each of which takes some hundredths of a second: 2 x 13 x 2.
const SWEEP: &str = "
[[sweep]]
method = ['cubic', 'quadratic']
coefficients = 'minimax'
shininess = '1..=200'
input_fraction = [13, 14]
output_fraction = [6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18]
";
const CORES: usize = 52;

fn brdfgen(directory: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_brdfgen"))
        .current_dir(directory)
        .args(arguments)
        .output()
        .expect("the program runs")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// What a run that ends with this exit code prints.
fn prints(directory: &Path, arguments: &[&str], code: i32) -> String {
    let output = brdfgen(directory, arguments);
    let all = text(&output.stdout) + &text(&output.stderr);
    assert_eq!(output.status.code(), Some(code), "{arguments:?}\n{all}");
    all
}

/// A directory with the sweep in it.
fn scratch() -> tempfile::TempDir {
    let scratch = tempfile::tempdir().unwrap();
    std::fs::write(scratch.path().join("sweep.toml"), SWEEP).unwrap();
    scratch
}

/// Says so past the test harness, which keeps what a passing test prints with `eprintln`.
fn did_not_run(why: &str) {
    use std::io::Write;
    let _ = writeln!(std::io::stderr(), "DID NOT RUN: {why}");
}

fn points(path: &Path) -> Vec<Point> {
    Results::read(path).unwrap().points().to_vec()
}

#[test]
fn a_run_that_was_killed_goes_on_where_it_was() {
    let scratch = scratch();
    let at = scratch.path();
    let run = ["explore", "sweep.toml", "--estimate", "--jobs", "2", "--results", "killed.db"];
    let mut child = Command::new(env!("CARGO_BIN_EXE_brdfgen"))
        .current_dir(at)
        .args(run)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    // Until a few points are there; they are seen from outside as soon as they are finished.
    let path = at.join("killed.db");
    let start = Instant::now();
    let seen = loop {
        let seen =
            if path.exists() { Store::open_to_read(&path).and_then(|s| s.known()).map_or(0, |k| k.len()) } else { 0 };
        if seen >= 3 || start.elapsed() > Duration::from_secs(120) {
            break seen;
        }
        std::thread::sleep(Duration::from_millis(5));
    };
    // SIGKILL: the program has no chance to tidy up.
    child.kill().unwrap();
    let status = child.wait().unwrap();
    assert!(!status.success(), "the run ended before it was killed: the sweep is too small for this test");
    let before: BTreeMap<String, Point> = points(&path).into_iter().map(|point| (point.id.clone(), point)).collect();
    assert!(seen >= 3 && before.len() >= seen && before.len() < CORES, "{seen} seen, {} there", before.len());

    let said = prints(at, &run, 0);
    let expected = format!("{} points made, {} were there, 0 failed", CORES - before.len(), before.len());
    assert!(said.contains(&expected), "{said}\nexpected: {expected}");
    let after = points(&path);
    assert_eq!(after.len(), CORES);
    // And what was there is as it was, and the whole as if nothing had happened.
    for point in after.iter().filter(|point| before.contains_key(&point.id)) {
        assert_eq!(before[&point.id], *point);
    }
    prints(at, &["explore", "sweep.toml", "--estimate", "--results", "whole.db"], 0);
    assert_eq!(points(&at.join("whole.db")), after);
}

#[test]
fn shards_joined_are_the_whole() {
    let scratch = scratch();
    let at = scratch.path();
    let narrow = ["--output-fraction", "8,12,16", "--input-fraction", "10"];
    let explore = |more: &[&str]| {
        let base = ["explore", "sweep.toml", "--estimate"];
        prints(at, &[&base[..], &narrow, more].concat(), 0)
    };
    explore(&["--results", "whole.db", "--csv", "whole.csv", "--json", "whole.json"]);
    for shard in ["1/3", "2/3", "3/3"] {
        explore(&["--shard", shard, "--results", &format!("{}.db", &shard[..1])]);
    }
    let said = prints(at, &["explore", "merge", "1.db", "2.db", "3.db", "--out", "joined.db"], 0);
    assert!(said.contains("6 points in joined.db"), "{said}");
    let whole = points(&at.join("whole.db"));
    assert_eq!(points(&at.join("joined.db")), whole);
    assert_eq!(points(&at.join("whole.csv")), whole);
    assert_eq!(points(&at.join("whole.json")), whole);
    assert!([1, 2, 3].iter().all(|part| points(&at.join(format!("{part}.db"))).len() == 2));
    // A part twice is no matter, and a target that is there is left alone.
    prints(at, &["explore", "merge", "1.db", "2.db", "1.db", "--out", "some.db"], 0);
    assert_eq!(points(&at.join("some.db")).len(), 4);
    let said = prints(at, &["explore", "merge", "1.db", "--out", "some.db"], 2);
    assert!(said.contains("some.db is there already"), "{said}");

    // The same point told in two ways.
    let provenance = Store::open_to_read(&at.join("1.db")).unwrap().provenance().unwrap().unwrap();
    let mut changed = points(&at.join("1.db"))[0].clone();
    changed.max_abs *= 2.0;
    Store::open(&at.join("other.db"), &provenance, Earlier::Kept).unwrap().put(&changed).unwrap();
    let said = prints(at, &["explore", "merge", "1.db", "other.db", "--out", "two.db"], 2);
    assert!(said.contains(&format!("tell the point {} differently", changed.id)), "{said}");
    assert!(!at.join("two.db").exists());
}

#[test]
fn figures_of_two_versions_are_never_mixed() {
    let scratch = scratch();
    let at = scratch.path();
    let run = ["explore", "sweep.toml", "--estimate", "--shard", "1/20", "--results", "a.db"];
    prints(at, &run, 0);
    let mut provenance = Store::open_to_read(&at.join("a.db")).unwrap().provenance().unwrap().unwrap();
    let tools = provenance.tools.get_mut("ecp5").unwrap();
    tools.yosys = "Yosys 0.99".to_owned();
    let refused = |error: brdfgen::platform::error::Error| error.to_string();
    let error = refused(Store::open(&at.join("a.db"), &provenance, Earlier::Kept).unwrap_err());
    assert!(error.contains("of Yosys 0") && error.contains("and of Yosys 0.99"), "{error}");
    // A family's own nextpnr counts as well, but not that of another family.
    let mut other = Store::open_to_read(&at.join("a.db")).unwrap().provenance().unwrap().unwrap();
    let ecp5 = other.tools.remove("ecp5").unwrap();
    let nextpnr = Some("nextpnr-ice40 9".to_owned());
    other.tools.insert("ice40".to_owned(), brdfgen::synth::Tools { nextpnr: nextpnr.clone(), ..ecp5.clone() });
    Store::open(&at.join("a.db"), &other, Earlier::Kept).unwrap();
    other.tools.insert("ecp5".to_owned(), brdfgen::synth::Tools { nextpnr, ..ecp5 });
    assert!(Store::open(&at.join("a.db"), &other, Earlier::Kept).is_err());

    let held = points(&at.join("a.db")).len();
    drop(Store::open(&at.join("b.db"), &provenance, Earlier::Kept).unwrap());
    let said = prints(at, &["explore", "merge", "a.db", "b.db", "--out", "c.db"], 2);
    assert!(said.contains("the merged results would hold figures of Yosys"), "{said}");
    // The program refuses a file of the other version, and takes it anew if told so.
    let run = ["explore", "sweep.toml", "--estimate", "--shard", "1/20", "--results", "b.db"];
    let said = prints(at, &run, 2);
    assert!(said.contains("b.db: the results would hold figures") && said.contains("--fresh"), "{said}");
    prints(at, &[&run[..], &["--fresh"]].concat(), 0);
    assert_eq!(points(&at.join("b.db")).len(), held);
}

/// Any synthesis, even of the least core; the cells need no placement.
#[test]
fn cores_are_synthesised_and_failures_kept_until_they_are_tried_again() {
    if Command::new("yosys").arg("-V").output().is_err() {
        did_not_run("there is no yosys here, so no core was synthesised");
        return;
    }
    let scratch = scratch();
    let at = scratch.path();
    let cache = at.join("cache").display().to_string();
    let base = [
        "explore",
        "--method",
        "quadratic,lyon-2",
        "--shininess",
        "1..=7",
        "--input-fraction",
        "8",
        "--output-fraction",
        "6",
        "--no-place",
        "--yosys",
        "yosys",
        "--cache",
        &cache,
        "--results",
        "a.db",
    ];
    // lyon-2 has no memory that could be written: that it is no core is told, and is no failure.
    let said = prints(at, &[&base[..], &["--axis", "rom=inline,writable", "--csv", "a.csv"]].concat(), 0);
    assert!(
        said.contains("4 points made, 0 were there, 0 failed") && said.contains("1 of those made are no cores"),
        "{said}"
    );
    let (made, no_core): (Vec<Point>, Vec<Point>) =
        points(&at.join("a.csv")).into_iter().partition(|point| point.failure.is_none());
    assert_eq!((made.len(), no_core.len(), no_core[0].variant.as_str()), (3, 1, "rom=writable"));
    assert!(no_core[0].failure.as_ref().unwrap().contains("no coefficient memory") && no_core[0].cost().is_none());
    for point in &made {
        let cost = point.cost().unwrap();
        assert!(cost.lut > 0 && cost.mhz.is_none() && !cost.estimated, "{point:?}");
        assert_eq!((point.checked.as_str(), point.rows), ("exhaustive", 7));
        assert!(point.max_abs > 0.0 && point.bound > 0.0 && point.bound < 1.0 / 32.0, "{point:?}");
    }
    // A failure is kept, told, and tried again on demand only.
    let mut store = Store::open_to_read(&at.join("a.db")).unwrap();
    let broken = Point { failure: Some("the disk was full".to_owned()), synthesis: None, ..made[0].clone() };
    store.put(&broken).unwrap();
    drop(store);
    let again = [&base[..], &["--axis", "rom=inline,writable"]].concat();
    let said = prints(at, &again, 1);
    assert!(said.contains("0 points made, 4 were there") && said.contains("1 of those"), "{said}");
    let said = prints(at, &[&again[..], &["--retry-failed"]].concat(), 0);
    assert!(said.contains("1 points made, 3 were there, 0 failed"), "{said}");
    assert_eq!(points(&at.join("a.db")), points(&at.join("a.csv")));
    // Placements are another kind of figure.
    let estimated = ["explore", "--method", "quadratic", "--estimate", "--results", "a.db"];
    assert!(prints(at, &estimated, 2).contains("synthesis without placement and of estimates"));
}

#[test]
fn the_cheapest_core_is_chosen_and_built() {
    let scratch = scratch();
    let at = scratch.path();
    let said = prints(at, &["choose", "--max-error", "0.2", "--json"], 0);
    let choice: Value = serde_json::from_str(&said).unwrap();
    let chosen = &choice["chosen"];
    assert!(chosen["point"]["max_abs"].as_f64().unwrap() <= 0.2);
    // Against the data itself: nothing that meets the constraints has fewer LUTs.
    let cheapest = Results::built_in().unwrap();
    let meets = |point: &&Point| {
        point.family == brdfgen::target::Family::Ecp5
            && !point.baseline
            && point.max_abs <= 0.2
            && point.shininess == "1..=1000"
    };
    let least = cheapest.points().iter().filter(meets).filter_map(Point::cost).map(|cost| cost.lut).min().unwrap();
    assert_eq!(chosen["cost"]["lut"], least);
    for miss in choice["misses"].as_array().unwrap() {
        assert!(miss["point"]["max_abs"].as_f64().unwrap() > 0.2 && miss["octaves"].as_f64().unwrap() > 0.0);
        assert!(miss["why"][0].as_str().unwrap().contains("times what is unmet"));
    }
    let said = prints(at, &["choose", "--max-error", "2^-30", "--min-mhz", "500", "--max-dsp", "3"], 1);
    let unmet =
        "no core meets the constraints: an error of at most 9.31e-8 % (2^-30.00), at least 500 MHz, at most 3 DSPs";
    assert!(said.contains(unmet) && said.contains("nearest misses:"), "{said}");

    let said = prints(
        at,
        &["generate", "--max-error", "20%", "--name", "chosen", "--shininess", "1..=100", "--out", "core"],
        0,
    );
    assert!(said.contains("cores considered meet the constraints"), "{said}");
    let toml = std::fs::read_to_string(at.join("core/core.toml")).unwrap();
    assert!(toml.contains("shininess = \"1..=100\"") && toml.contains("name = \"chosen\""), "{toml}");
    let method = format!("method = {}", chosen["point"]["method"]);
    assert!(toml.contains(&method), "{toml}\nexpected: {method}");
    assert!(prints(at, &["generate", "--max-error", "2^-30", "--out", "none"], 1).contains("no core meets"));
    let none = brdfgen(at, &["generate", "--max-error", "2^-30", "--out", "none", "--json"]);
    let choice: Value = serde_json::from_slice(&none.stdout).unwrap();
    assert!(choice["chosen"].is_null() && choice["misses"].as_array().unwrap().len() == 3, "{choice}");

    // Figures of a version whose core took fewer clocks: that is told, and no core that is too slow is built.
    let mut point: Point = serde_json::from_value(chosen["point"].clone()).unwrap();
    let latency =
        brdfgen::core::Design::new(brdfgen::spec::SpecFields::parse(&point.spec, "spec").unwrap().resolve().unwrap());
    point.latency = latency.unwrap().schedule.latency - 1;
    let promised = point.latency.to_string();
    std::fs::write(at.join("old.json"), Results::new(vec![point]).to_json()).unwrap();
    let old = ["generate", "--max-error", "20%", "--results", "old.json", "--out", "old"];
    let said = prints(at, &[&old[..], &["--max-latency", &promised]].concat(), 1);
    assert!(said.contains(&format!("where the results say {promised}")) && !at.join("old").exists(), "{said}");
    prints(at, &[&old[..], &["--shininess", "1..=16"]].concat(), 0);
    assert!(!at.join("none").exists());
}

#[test]
fn bad_input_is_named() {
    let scratch = scratch();
    let at = scratch.path();
    std::fs::write(
        at.join("no.db"),
        "this is no database, but it is long enough to look like one to whoever reads its head only",
    )
    .unwrap();
    std::fs::write(at.join("bad.toml"), "[[sweep]]\nmethod = ['cubic', 'qubic']\n").unwrap();
    std::fs::write(at.join("bad.csv"), "id,name\n1,2\n").unwrap();
    std::fs::write(at.join("empty.csv"), "").unwrap();
    std::fs::write(at.join("twice.toml"), "[[sweep]]\nmethod = 'cubic'\noutput_fraction = 8\noutput_fraction = 6\n")
        .unwrap();
    std::fs::write(at.join("excel.csv"), "\u{feff}id;name\r\n1;2,5\r\n").unwrap();
    let trade = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/trade.csv")).unwrap();
    let mut reader = csv::Reader::from_reader(trade.as_bytes());
    let heads = reader.headers().unwrap().clone();
    let column = heads.iter().position(|head| head == "min_mhz").unwrap();
    let row = reader.records().map(Result::unwrap).find(|row| !row[column].is_empty()).unwrap();
    let mut writer = csv::Writer::from_path(at.join("zero.csv")).unwrap();
    writer.write_record(&heads).unwrap();
    writer.write_record(row.iter().enumerate().map(|(place, cell)| if place == column { "0" } else { cell })).unwrap();
    writer.flush().unwrap();
    std::fs::create_dir(at.join("folder.db")).unwrap();
    let results = ["--results", "a.db"];
    for (arguments, expected) in [
        (vec!["explore", "sweep.toml"], "--results"),
        (vec!["explore", "none.toml", "--results", "a.db"], "cannot read none.toml"),
        (vec!["explore", "bad.toml", "--results", "a.db"], "bad.toml:2"),
        (vec!["explore", "sweep.toml", "--estimate", "--results", "no.db"], "no.db is no results file"),
        (vec!["explore", "sweep.toml", "--estimate", "--results", "none/a.db"], "cannot open none/a.db"),
        (vec!["explore", "--method", "qubic", results[0], results[1]], "qubic"),
        (vec!["explore", "--axis", "inside", results[0], results[1]], "the axis `inside` has no value"),
        (
            vec!["explore", "--output-fraction", "8", "--axis", "output-fraction=6", results[0], results[1]],
            "the axis output_fraction is given twice",
        ),
        (vec!["explore", "--axis", "q=0.5", "--axis", "q=0.6", results[0], results[1]], "the axis q is given twice"),
        (vec!["explore", "--method", "cubic", "--axis", "q=inf", results[0], results[1]], "no number that can be used"),
        (vec!["explore", "twice.toml", results[0], results[1]], "duplicate key"),
        (vec!["choose", "--max-error", "1%", "--results", "excel.csv"], "commas and this has semicolons"),
        (vec!["choose", "--max-error", "1%", "--results", "zero.csv"], "zero.csv, line 2: the point"),
        (vec!["explore", "--axis", "insides=linear", results[0], results[1]], "did you mean `inside`"),
        (vec!["explore", "sweep.toml", "--shard", "3/2", results[0], results[1]], "I from 1 to N"),
        (vec!["explore", "sweep.toml", "--jobs", "0", results[0], results[1]], "--jobs"),
        (vec!["explore", "sweep.toml", "--seeds", "0", results[0], results[1]], "0 seeds"),
        (vec!["explore", "sweep.toml", "--estimate", "--seeds", "2", results[0], results[1]], "--seeds"),
        (vec!["explore", "sweep.toml", "--estimate", "--fit-from", "bad.csv", results[0], results[1]], "missing field"),
        (vec!["explore", "merge", "a.db", "--out", "b.db"], "cannot read a.db"),
        (vec!["explore", "merge", "no.db", "--out", "b.db"], "no.db is no results file"),
        (vec!["choose"], "--max-error"),
        (
            vec!["choose", "--max-error", "1%", "--results", "empty.csv"],
            "empty.csv, line 1: there is no line of headings",
        ),
        (vec!["choose", "--max-error", "1%", "--results", "folder.db"], "folder.db is no results file"),
        (vec!["choose", "--max-error", "1%", "--results", "none.db"], "cannot read none.db: No such file"),
        (vec!["choose", "--max-error", "200%"], "above 0 and at most 1"),
        (vec!["choose", "--max-error", "1%", "--results", "a.xml"], "unknown kind of results"),
        (vec!["choose", "--max-error", "1%", "--min-mhz", "nan"], "NaN MHz is not allowed"),
        (vec!["choose", "--max-error", "1%", "--shininess", "3,4"], "serves the shininess 3,4"),
        (vec!["generate", "--method", "cubic", "--shininess", "3", "--min-mhz", "100", "--out", "x"], "--max-error"),
    ] {
        let said = prints(at, &arguments, 2);
        assert!(said.contains(expected), "{arguments:?}\n{said}\nexpected: {expected}");
    }
    assert!(!at.join("a.db").exists(), "a refused run leaves nothing behind");
}

/// Whoever reads an output may go away before its end, as `head` does: that is no error, and changes no exit code.
#[test]
fn a_reader_that_goes_away_changes_nothing() {
    let scratch = scratch();
    let gone = |arguments: &[&str]| {
        let mut child = Command::new(env!("CARGO_BIN_EXE_brdfgen"))
            .current_dir(scratch.path())
            .args(arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop((child.stdout.take(), child.stderr.take()));
        child.wait().unwrap().code()
    };
    let run = ["explore", "sweep.toml", "--estimate", "--shard", "1/52", "--results", "a.db", "--csv", "-"];
    assert_eq!(gone(&run), Some(0));
    assert_eq!(gone(&["choose", "--max-error", "1%", "--results", "none.db"]), Some(2));
    assert_eq!(gone(&["generate", "--max-error", "2^-30", "--out", "none"]), Some(1));
}

/// What `choose` says makes the core does make it, however many flags that takes.
#[test]
fn the_command_of_a_chosen_core_makes_it() {
    let scratch = scratch();
    let at = scratch.path();
    let axes = "--method quadratic --coefficients minimax --shininess 1..=16 --input-fraction 8 --output-fraction 8 \
     --pipeline 6";
    let run: Vec<&str> = ["explore", "--estimate", "--results", "a.db"].into_iter().chain(axes.split(' ')).collect();
    prints(at, &run, 0);
    let said = prints(at, &["choose", "--results", "a.db", "--max-error", "50%", "--shininess", "1..=16"], 0);
    let command = said.lines().find_map(|line| line.trim().strip_prefix("made by: brdfgen ")).expect(&said);
    let arguments: Vec<&str> = command.split(' ').map(|word| if word == "DIR" { "core" } else { word }).collect();
    prints(at, &arguments, 0);
    let toml = std::fs::read_to_string(at.join("core/core.toml")).unwrap();
    let own = brdfgen::spec::SpecFields::parse(&toml, "core.toml").unwrap().resolve().unwrap();
    assert_eq!(own.to_toml(), points(&at.join("a.db"))[0].spec);
}

#[test]
fn the_list_of_cores_is_printed_wherever_results_go() {
    let scratch = scratch();
    let list = ["explore", "sweep.toml", "--list", "--output-fraction", "8", "--input-fraction", "13"];
    for more in [&[][..], &["--csv", "-"], &["--json", "-"]] {
        let said = prints(scratch.path(), &[&list[..], more].concat(), 0);
        assert_eq!(said.lines().filter(|line| line.contains(" ecp5 ")).count(), 2, "{said}");
    }
}

/// The job array of docs/explore.slurm, on whatever cluster answers here.
#[test]
fn a_job_array_makes_the_whole() {
    let answers = Command::new("scontrol").arg("ping").output().is_ok_and(|output| text(&output.stdout).contains("UP"));
    if !answers {
        did_not_run(
            "no Slurm controller answers here, so docs/explore.slurm was not tried (its head says how to start one)",
        );
        return;
    }
    let scratch = scratch();
    let at = scratch.path();
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/explore.slurm");
    let submitted = Command::new("sbatch")
        .current_dir(at)
        .env("BRDFGEN", env!("CARGO_BIN_EXE_brdfgen"))
        .args(["--wait", "--array=1-2"])
        .arg(script)
        .args(["sweep.toml", "results", "--estimate", "--output-fraction", "8,9"])
        .output()
        .unwrap();
    assert!(submitted.status.success(), "{}{}", text(&submitted.stdout), text(&submitted.stderr));
    let parts = ["results/shard-1-of-2.db", "results/shard-2-of-2.db"];
    prints(at, &["explore", "merge", parts[0], parts[1], "--out", "joined.db"], 0);
    prints(at, &["explore", "sweep.toml", "--estimate", "--output-fraction", "8,9", "--results", "whole.db"], 0);
    assert_eq!(points(&at.join("joined.db")), points(&at.join("whole.db")));
    assert_eq!(points(&at.join("whole.db")).len(), 8);
}
