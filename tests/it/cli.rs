//! The built program, from the outside: what it refuses, what it writes, what it says and how it ends.

use std::ffi::OsString;
use std::fs;
use std::path::Path;

use ihex::Record;
use proptest::prelude::*;
use quick_junit::{Report, TestCaseStatus};
use serde_json::json;
use sha2::{Digest, Sha256};

use crate::common::{Scratch, Tree};

/// A small core: three rows, every one of its 1024 operand codes quickly run through.
const SMALL: &str = "--method quadratic --shininess 1,5,20.5 --input-fraction 8 --output-fraction 8";
/// The same spec as TOML.
const SMALL_TOML: &str = "method = \"quadratic\"\nshininess = [1, 5, 20.5]\ninput_fraction = 8\noutput_fraction = 8\n";
/// Another method, a range and the other operand.
const CUBIC: &str = "--method cubic --shininess 3..=9 --input-fraction 8 --output-fraction 8 --operand versine";

/// A directory with the small core in `core`.
fn with_core() -> Scratch {
    let scratch = Scratch::new();
    scratch.run(&format!("generate {SMALL} --out core")).succeeds();
    scratch
}

/// `text` with the first occurrence of `from`, which must be there, replaced.
#[track_caller]
fn replaced(text: &str, from: &str, to: &str) -> String {
    assert!(text.contains(from), "`{from}` is not in\n{text}");
    text.replacen(from, to, 1)
}

// Bad input

#[test]
fn wrong_values_of_flags_are_named_with_what_is_allowed() {
    let scratch = Scratch::new();
    let set = |set: &str| format!("--method quadratic --shininess {set}");
    let with = |flags: &str| format!("--method cubic --shininess 5 {flags}");
    for (flags, words) in [
        (set("0.5"), &["shininess 0.5 is out of range", "from 1 to"][..]),
        (set("0"), &["shininess 0 is out of range", "from 1 to"]),
        (set("0..=5"), &["shininess 0 is out of range", "from 1 to"]),
        (set("3,0.99"), &["shininess 0.99 is out of range", "from 1 to"]),
        (set("nan"), &["shininess NaN is out of range", "from 1 to"]),
        (set("3,NaN"), &["shininess NaN is out of range", "from 1 to"]),
        (set("inf"), &["shininess inf is out of range", "from 1 to"]),
        (set("1..=1000000000"), &["1000000000 shininesses", "1 to 65536"]),
        (set("1..=4294967295"), &["4294967295 shininesses", "1 to 65536"]),
        (set("9..=2"), &["range 9..=2 is empty", "smaller end first"]),
        (set("1..9"), &["`1..9`", "1..=1000"]),
        (set("bright"), &["`bright` is not a number", "1..=1000"]),
        (set("5,,6"), &["--shininess", "is not a number", "5,12.5,80"]),
        ("--method quadratic".to_owned(), &["no shininess", "--shininess"]),
        ("--shininess 5".to_owned(), &["no method", "--method quadratic"]),
        ("--method linear --shininess 5".to_owned(), &["'linear'", "--method", "quadratic, cubic"]),
        (with("--input-fraction 0"), &["input_fraction = 0", "from 4 to 24"]),
        (with("--input-fraction 200"), &["input_fraction = 200", "from 4 to 24"]),
        (with("--output-fraction 0"), &["output_fraction = 0", "from 4 to 20"]),
        (with("--output-fraction 200"), &["output_fraction = 200", "from 4 to 20"]),
        (with("--input-fraction wide"), &["'wide'", "--input-fraction"]),
        (with("--pipeline 0"), &["pipeline = 0", "from 1 to 64"]),
        (with("--pipeline 99"), &["pipeline = 99", "from 1 to 64"]),
        (with("--pipeline deep"), &["`deep`", "--pipeline", "auto"]),
        (with("--q 0"), &["level q = 0", "from 0.05 to 0.95"]),
        (with("--q 0.96"), &["level q = 0.96", "from 0.05 to 0.95"]),
        (with("--q NaN"), &["level q = NaN", "from 0.05 to 0.95"]),
        ("--method quadratic --shininess 5 --q 0.7".to_owned(), &["quadratic has no level q", "leave level q out"]),
        (with("--material a=5"), &["--material", "--shininess", "cannot be used with"]),
        ("--method cubic --material brass".to_owned(), &["'brass'", "NAME=SHININESS", "brass=51.2"]),
        ("--method cubic --material brass=shiny".to_owned(), &["brass=shiny", "`shiny` is not a number"]),
        ("--method cubic --material a=3 --material brass=0.5".to_owned(), &["brass", "shininess 0.5", "from 1 to"]),
        ("--method cubic --material =5".to_owned(), &["material name", "printable ASCII"]),
        ("--method cubic --material é=5".to_owned(), &["material name", "printable ASCII"]),
        (with("--name module"), &["the name `module`", "no reserved word"]),
        (with("--name ../up"), &["the name `../up`", "lower-case letters"]),
        (with("--languages chisel"), &["'chisel'", "verilog, vhdl"]),
        (with("--rom-formats txt"), &["'txt'", "mem, hex, coe"]),
        ("--method squaring --shininess 2,3".to_owned(), &["shininess 3 is not a power of two", "1,2,4,8,16"]),
        ("--method table --shininess 1..=1000 --table-bits 9".to_owned(), &["too large", "table_bits is at most 7"]),
        ("--method harris --shininess 5 --exp-bits 15".to_owned(), &["exp_bits = 15", "from 2 to 14"]),
        (with("--log-bits 5"), &["cubic has no log_bits", "leave log_bits out"]),
        (with("--shine 5"), &["--shine"]),
        (with("--wrong"), &["unexpected argument '--wrong'"]),
    ] {
        scratch.refused(&format!("generate {flags} --out core"), words);
    }
}

#[test]
fn wrong_values_in_a_spec_file_are_named_with_their_place() {
    let scratch = Scratch::new();
    let with = |line: &str| format!("method = \"cubic\"\nshininess = [5]\n{line}\n");
    let set = |set: &str| format!("method = \"quadratic\"\nshininess = {set}\n");
    for (text, words) in [
        (with("inputfraction = 8"), &["`inputfraction`", "did you mean `input_fraction`?", "spec.toml:3:1"][..]),
        (with("[[material]]\nshine = 2"), &["`shine`", "did you mean `shininess`?", "spec.toml:4:1"]),
        (with("colour = 8"), &["`colour`", "keys are name, block, method", "spec.toml:3:1"]),
        (with("input_fraction = \"eight\""), &["\"eight\"", "spec.toml:3:18"]),
        (with("input_fraction = 8.5"), &["8.5", "spec.toml:3:18"]),
        (with("input_fraction = -1"), &["-1", "spec.toml:3:18"]),
        (with("input_fraction = 200"), &["input_fraction = 200", "from 4 to 24"]),
        (with("output_fraction = 0"), &["output_fraction = 0", "from 4 to 20"]),
        (with("operand = \"sine\""), &["`sine`", "`cos` or `versine`", "spec.toml:3:11"]),
        (with("languages = \"vhdl\""), &["spec.toml:3:13", "sequence"]),
        (with("languages = []"), &["no language", "verilog, vhdl or both"]),
        (with("pipeline = true"), &["number of registers or \"auto\"", "spec.toml:3:12"]),
        (with("q = 1.5"), &["level q = 1.5", "from 0.05 to 0.95"]),
        (with("q = nan"), &["level q = NaN", "from 0.05 to 0.95"]),
        (with("[[material]]\nname = \"a\"\nshininess = 2"), &["both shininess and materials", "one of the two"]),
        (with("method = \"cubic\""), &["duplicate key", "spec.toml:3:1"]),
        (with("q = "), &["spec.toml:3"]),
        (set("[0.5]"), &["shininess 0.5 is out of range", "from 1 to"]),
        (set("[3, nan]"), &["shininess NaN is out of range", "from 1 to"]),
        (set("nan"), &["shininess NaN is out of range", "from 1 to"]),
        (set("-inf"), &["shininess -inf is out of range", "from 1 to"]),
        (set("\"1..=1000000000\""), &["1000000000 shininesses", "1 to 65536"]),
        (set(&format!("[{}]", "2,".repeat(65_537))), &["65537 shininesses", "1 to 65536"]),
        (set("\"9..=2\""), &["range 9..=2 is empty", "smaller end first"]),
        (set("[]"), &["0 shininesses", "1 to 65536"]),
        (set("[5, \"a\"]"), &["range of integers", "list", "spec.toml:2:13"]),
        (set("true"), &["range of integers", "list", "spec.toml:2:13"]),
        ("method = \"cubic\"\nmaterial = []".to_owned(), &["0 shininesses", "1 to 65536"]),
        (
            "method = \"cubic\"\n[[material]]\nname = \"brass\"\nshininess = 0.5".to_owned(),
            &["brass", "shininess 0.5", "from 1 to"],
        ),
        (
            "method = \"cubic\"\n[[material]]\nname = \"brass\"".to_owned(),
            &["missing field `shininess`", "spec.toml:2"],
        ),
        ("method = \"quadratic".to_owned(), &["spec.toml:1:20"]),
        (String::new(), &["no method", "--method quadratic"]),
    ] {
        scratch.write("spec.toml", &text);
        scratch.refused("generate spec.toml --out core", words);
    }
}

#[test]
fn a_spec_that_cannot_be_read_is_named() {
    let scratch = Scratch::new();
    scratch.refused("generate missing.toml --out core", &["cannot read missing.toml", "No such file"]);
    scratch.write("binary.toml", b"method = \"\xff\xfe\"");
    scratch.refused("generate binary.toml --out core", &["binary.toml is not UTF-8 text", "TOML"]);
    fs::create_dir(scratch.path("empty")).unwrap();
    scratch.refused("generate empty --out core", &["cannot read empty", "core.toml"]);
    for command in ["rom", "golden --out -", "cosim", "eval -n 5 -x 0.5"] {
        scratch.refused(&format!("{command} missing.toml"), &["cannot read missing.toml"]);
    }
}

#[test]
fn the_systems_answer_is_given_once_and_a_long_path_is_whole() {
    let scratch = Scratch::new();
    let path = "a-long-name/".repeat(20) + "spec.toml";
    let run = scratch.run(&format!("generate {path} --out core")).refuses(&["No such file"]);
    assert_eq!(run.stderr.matches("os error").count(), 1, "{}", run.stderr);
    assert!(run.stderr.contains(&path), "{}", run.stderr);
}

#[test]
fn directories_that_cannot_be_written_are_named() {
    let scratch = with_core();
    scratch.write("file", "a regular file");
    let mut places = vec!["file/below", "file"];
    if cfg!(target_os = "linux") {
        // There no directory can be made, whoever tries.
        places.push("/proc/brdfgen-test");
    }
    for place in places {
        scratch.refused(&format!("generate {SMALL} --out {place}"), &[place, "cannot"]);
        scratch.refused(&format!("generate {SMALL} --json --out {place}"), &[place, "cannot"]);
        scratch.refused(&format!("rom core --format mem --out {place}"), &[place, "cannot write"]);
    }
    for place in ["file/below.vec", "core"] {
        scratch.refused(&format!("golden core --out {place}"), &[place, "cannot write"]);
        scratch.refused(&format!("cosim core --junit {place}"), &[place, "cannot write"]);
    }
}

#[test]
fn a_directory_that_is_not_a_core_is_left_alone() {
    let scratch = Scratch::new();
    scratch.write("mine/notes.txt", "do not touch");
    scratch.refused(&format!("generate {SMALL} --out mine"), &["mine is not empty", "new or empty directory"]);
    scratch.write("own/core.toml", SMALL_TOML);
    scratch.write("own/rtl/quadratic.v", "module quadratic; endmodule");
    scratch.refused("generate own --out own", &["own is not empty", "new or empty directory"]);
}

#[test]
fn rom_refuses_what_is_no_rom_file() {
    let scratch = with_core();
    let text = scratch.text("core/rom/quadratic.mem");
    scratch.write("cut.mem", text.trim_end().strip_suffix(char::is_alphanumeric).unwrap());
    scratch.refused("rom core --check cut.mem", &["cut.mem:", "ends within a word", "3 digits", "line feed"]);
    scratch.write("heading.mem", &text[..text.find("UQ").unwrap()]);
    scratch.refused("rom core --check heading.mem", &["heading.mem", "no words", "hexadecimal words"]);
    scratch.write("wide.mem", replaced(&text, "\n000\n", "\n7ff\n"));
    scratch.refused("rom core --check wide.mem", &["wide.mem:7:1", "`7ff` is too wide", "10 bits"]);
    scratch.write("letters.mem", replaced(&text, "\n000\n", "\n0xz\n"));
    scratch.refused("rom core --check letters.mem", &["letters.mem:7:1", "`0xz`", "radix 16"]);
    scratch.write("empty.mem", "");
    scratch.refused("rom core --check empty.mem", &["empty.mem", "no words"]);
    scratch.refused("rom core --check missing.mem", &["cannot read missing.mem"]);
    scratch.refused("rom core --check core/core.toml", &["core/core.toml", "--format", ".mem, .vmem, .memh, .hex"]);
    scratch.refused("rom core --out -", &["several formats", "--format"]);
    scratch.refused("rom core --format mem,coe --out -", &["several formats", "--format"]);
    scratch.refused("rom core --format txt", &["'txt'", "mem, hex, coe"]);
    scratch.refused("rom core --check core/rom/quadratic.mem --out rom", &["--check", "--out"]);
    scratch.refused("rom core --check core/rom/quadratic.mem --format mem,coe", &["one format", "--format"]);
    scratch.refused("rom core --memory-name lut --out -", &["no memory lut", "it has rom"]);
    let wide: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
    scratch.write("wide.mem", wide);
    scratch.refused("rom core --check wide.mem", &["wide.mem is UTF-16 text", "save it as UTF-8"]);
    scratch.write("excel.csv", "\u{feff}address;a_real;word\n0;0,5;0x1\n");
    scratch.refused("rom core --check excel.csv", &["columns are separated by commas and this has semicolons"]);
}

/// What vendors' tools and other generators write of the same words, as their manuals have it.
#[test]
fn rom_reads_what_other_tools_write() {
    let scratch = with_core();
    let ours = scratch.text("core/rom/quadratic.mem");
    let words: Vec<&str> = ours.lines().filter(|line| !line.starts_with("//")).collect();
    let bits = 10;
    let value = |word: &str| u32::from_str_radix(word, 16).unwrap();
    let lines = words.join("\n");
    let binary: Vec<String> = words.iter().map(|word| format!("{:0bits$b}", value(word))).collect();
    let record = |(address, word): (usize, &&str)| {
        let value = (value(word) as u16).to_be_bytes().to_vec();
        Record::Data { offset: address as u16, value }.to_record_string().unwrap() + "\n"
    };
    let quartus: String = words.iter().enumerate().map(record).collect::<String>() + ":00000001FF\n";
    let ug896 = format!(
        "MEMORY_INITIALIZATION_RADIX = 16 ; hex\nMEMORY_INITIALIZATION_VECTOR = {}; all\nDEPTH = 4;",
        words.join(", ")
    );
    let lattice =
        format!("#Format=Hex\n#Depth={}\n#Width={bits}\n#AddrRadix=3\n#DataRadix=3\n#Data\n{lines}\n", words.len());
    for (name, text, flags, kind) in [
        ("a.coe", ug896, "", ""),
        ("a.hex", quartus.clone(), "", " (Quartus' kind, whose addresses count words)"),
        ("q.hex", quartus, "--format quartus-hex", " (Quartus' kind, whose addresses count words)"),
        ("a.mif", binary.join("\n"), "", " (Xilinx' kind)"),
        ("a.mem", lattice, "", " (with Lattice's header)"),
        ("r.hex", format!("{lines}\n"), "", " (text for $readmemh)"),
        ("a.vmem", format!("\u{feff}@0 {lines}\r\n"), "", ""),
        ("a.txt", lines.replace('\n', " /* next */ "), "--format mem", ""),
    ] {
        scratch.write(name, &text);
        let right = format!("{name}{kind}: all {} words are as they should be", words.len());
        scratch.run(&format!("rom core --check {name} {flags}")).succeeds().says(&[&right]);
    }
    scratch.refused("rom core --check a.txt", &["a.txt", "--format"]);
}

#[test]
fn rom_writes_and_checks_one_memory_of_several() {
    let scratch = Scratch::new();
    scratch.run("generate --method harris --shininess 5 --log-bits 4 --exp-bits 5 --input-fraction 8 --output-fraction 8 --name le --out le").succeeds();
    let json = scratch.run("rom le --json --out rom").succeeds().json();
    let memories: Vec<String> =
        json["memories"].as_array().unwrap().iter().map(|memory| memory["name"].as_str().unwrap().to_owned()).collect();
    assert!(memories.len() > 1, "{memories:?}");
    scratch.refused("rom le --format mem --out -", &["memories", "--memory-name"]);
    for memory in &memories {
        let run = scratch.run(&format!("rom le --memory-name {memory} --format mem-plain --out -")).succeeds();
        // Whichever memory the words are of is found, and named.
        scratch.write("words.mem", &run.stdout);
        let named = format!("of the memory {memory} are as they should be");
        scratch.run("rom le --check words.mem").succeeds().says(&[&named]);
        scratch.run(&format!("rom le --check words.mem --memory-name {memory}")).succeeds();
        let wrong = if run.stdout.starts_with('0') { "1" } else { "0" }.to_owned() + &run.stdout[1..];
        scratch.write("wrong.mem", wrong);
        let named = format!("as the words of the memory {memory}: address 0");
        scratch.run("rom le --check wrong.mem").ends_with(1).says(&[&named]);
    }
    let [first, second, ..] = memories.as_slice() else { panic!("{memories:?}") };
    let run = scratch.run(&format!("rom le --memory-name {second} --format mem --out -")).succeeds();
    scratch.write("second.mem", &run.stdout);
    let other = scratch.run(&format!("rom le --check second.mem --memory-name {first}"));
    assert!(other.code == 1 || other.code == 2, "{}", other.stdout);
}

/// A core whose HDL reads its ROM from a file reads the one without comments, where the spec asks for it.
#[test]
fn the_rom_file_of_the_hdl_has_no_comments_on_wish() {
    let scratch = Scratch::new();
    scratch.run(&format!("generate {SMALL} --rom file --rom-formats mem-plain --out core")).succeeds();
    for source in ["core/rtl/quadratic.v", "core/rtl/quadratic.vhd"] {
        assert!(scratch.text(source).contains("\"rom/quadratic_plain.mem\""), "{source}");
    }
    assert!(
        scratch
            .text("core/rom/quadratic_plain.mem")
            .lines()
            .all(|line| line.bytes().all(|digit| digit.is_ascii_hexdigit()))
    );
    assert!(scratch.path("core/rom/quadratic.mem").exists());
}

#[test]
fn a_check_out_with_other_line_ends_is_told_once() {
    let scratch = with_core();
    let files = scratch.files("core");
    for file in &files {
        let path = format!("core/{file}");
        scratch.write(&path, scratch.text(&path).replace('\n', "\r\n"));
    }
    let run = scratch.run("generate core --check --out core").ends_with(1);
    let run = run.says(&["and 9 more differ in their line ends only", ".gitattributes", "0 of 10 files"]);
    assert_eq!(run.stdout.lines().count(), 2, "{}", run.stdout);
    let json = scratch.run("generate core --check --json --out core").ends_with(1).json();
    assert_eq!(json["differ"], json["differ_in_line_ends_only"]);
    // All that reads them still does.
    scratch.run("cosim core").succeeds();
    scratch.run("golden core --check core/golden/quadratic.vec").succeeds();
    scratch.run("rom core --check core/rom/quadratic.mem").succeeds();
    scratch.write("core/files.f", "rtl/other.v\r\n");
    let run = scratch.run("generate core --check --out core").ends_with(1);
    run.says(&["core/files.f differs\n", "and 8 more differ in their line ends only"]);
}

#[test]
fn text_with_a_byte_order_mark_is_read_by_every_reader() {
    let scratch = with_core();
    let marked =
        |from: &str, to: &str| scratch.write(to, format!("\u{feff}{}", scratch.text(from)).replace('\n', "\r\n"));
    scratch.write("spec.toml", SMALL_TOML);
    marked("spec.toml", "marked.toml");
    scratch.run("generate marked.toml --out marked").succeeds();
    assert_eq!(scratch.tree("marked/rtl"), scratch.tree("core/rtl"));
    marked("core/golden/quadratic.vec", "marked.vec");
    scratch.run("golden core --check marked.vec").succeeds();
    marked("core/rom/quadratic.mem", "marked.mem");
    scratch.run("rom core --check marked.mem").succeeds();
    scratch.write("wide.toml", SMALL_TOML.encode_utf16().flat_map(u16::to_be_bytes).collect::<Vec<u8>>());
    scratch.refused("generate wide.toml --out wide", &["wide.toml is UTF-16 text", "save it as UTF-8"]);
}

/// No command writes over what it reads, by whatever name, nor two things into one file.
#[test]
fn nothing_is_written_over_what_is_read() {
    let scratch = with_core();
    scratch.write("spec.toml", SMALL_TOML);
    scratch.write(
        "sweep.toml",
        "[[sweep]]\nmethod = 'quadratic'\nshininess = '1..=3'\ninput_fraction = 8\noutput_fraction = 8\n",
    );
    fs::copy(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/trade.csv"), scratch.path("fit.csv")).unwrap();
    scratch.write(
        "scene.toml",
        "width = 4\nheight = 4\n[camera]\nposition = [0, 0, 5]\n[[material]]\nname = 'a'\nshininess = 5\n[[light]]\n\
         direction = [0, 0, 1]\n[[object]]\nkind = 'mesh'\nmaterial = 'a'\nfile = 'mesh.obj'\n",
    );
    scratch.write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    fs::hard_link(scratch.path("sweep.toml"), scratch.path("hard.toml")).unwrap();
    let mut lines = vec![
        ("synth spec.toml --out spec.toml", ["SPEC", "spec.toml"]),
        ("synth core --out core/core.toml", ["SPEC", "core/core.toml"]),
        ("golden spec.toml --out ./spec.toml", ["SPEC", "spec.toml"]),
        ("golden core --out core/../core/core.toml", ["SPEC", "core/core.toml"]),
        ("cosim core --junit core/golden/quadratic.vec", ["SPEC", "golden/quadratic.vec"]),
        ("cosim core --junit core/rtl/quadratic.v", ["SPEC", "rtl/quadratic.v"]),
        ("cosim spec.toml --junit spec.toml", ["SPEC", "spec.toml"]),
        ("explore sweep.toml --estimate --results a.db --csv sweep.toml", ["SWEEP.toml", "sweep.toml"]),
        ("explore sweep.toml --estimate --results a.db --json hard.toml", ["SWEEP.toml", "hard.toml"]),
        ("explore sweep.toml --estimate --results sweep.toml", ["SWEEP.toml", "--results"]),
        ("explore sweep.toml --estimate --results a.db --csv a.db", ["--results", "--csv"]),
        ("explore sweep.toml --estimate --results a.db --csv a.db-journal", ["--results", "--csv"]),
        ("explore sweep.toml --estimate --results a.db --csv b --json ./b", ["--csv", "--json"]),
        ("explore sweep.toml --estimate --results a.db --csv - --json -", ["--csv", "--json"]),
        ("explore sweep.toml --estimate --fit-from fit.csv --results a.db --csv fit.csv", ["--fit-from", "fit.csv"]),
        ("explore sweep.toml --estimate --fit-from fit.csv --results fit.csv", ["--fit-from", "fit.csv"]),
        ("explore merge fit.csv --out fit.csv", ["FILE.db", "fit.csv"]),
        ("render scene.toml --only exact --out scene.toml", ["--out", "scene.toml"]),
        ("render scene.toml --only exact --out mesh.obj", ["--out", "mesh.obj"]),
        ("render scene.toml --core spec.toml --out p.png --exr spec.toml", ["--exr", "the core"]),
        ("render scene.toml --core core --out core/core.toml", ["--out", "the core"]),
        ("render scene.toml --compare=spec.toml --out spec.toml", ["--out", "the core"]),
        ("render scene.toml --method cubic --out p --exr ./p", ["--out", "--exr"]),
        ("report --results fit.csv --out fit.csv.html --scene fit.csv.html", ["--out", "--scene"]),
        ("report --speed page.html --out page.html", ["--out", "--speed"]),
    ];
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("sweep.toml", scratch.path("soft.toml")).unwrap();
        std::os::unix::fs::symlink("core", scratch.path("link")).unwrap();
        lines.push(("explore sweep.toml --estimate --results a.db --csv soft.toml", ["SWEEP.toml", "soft.toml"]));
        lines.push(("synth link --out core/core.toml", ["SPEC", "core/core.toml"]));
    }
    for (line, words) in lines {
        scratch.refused(line, &words);
    }
    // The claims' table of an earlier run is read and would be replaced.
    scratch.write(
        "claims/claims.csv",
        fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join("src/papers/recorded.csv")).unwrap(),
    );
    scratch.refused("claims --recorded claims/claims.csv --out claims", &["--out", "claims/claims.csv"]);
    // A spec or results among a core's own files; what renews the core from its own spec is none.
    scratch.run("generate core --out core").succeeds();
    scratch.run("generate core/core.toml --out ./core").succeeds();
    fs::copy(scratch.path("spec.toml"), scratch.path("core/README.md")).unwrap();
    scratch.refused("generate core/README.md --out core", &["--out", "SPEC", "README.md"]);
    fs::create_dir(scratch.path("rom")).unwrap();
    fs::copy(scratch.path("spec.toml"), scratch.path("rom/quadratic.mem")).unwrap();
    scratch.refused("rom rom/quadratic.mem --format mem", &["--out", "SPEC", "rom/quadratic.mem"]);
    // Streams hold nothing that could be lost.
    scratch.run("explore sweep.toml --estimate --results a.db --csv /dev/null --json /dev/null").succeeds();
    scratch.run("golden core --out core/golden/quadratic.vec").succeeds();
    scratch.run("cosim core --junit core/junit.xml").succeeds();
    scratch.run("cosim core --junit core/junit.xml").succeeds();
}

#[test]
fn golden_refuses_the_vectors_of_another_core_and_says_whose_they_are() {
    let scratch = with_core();
    scratch.run("golden core --name other --out other.vec").succeeds();
    scratch.refused("golden core --check other.vec", &["other.vec", "core other", "core quadratic", "are wanted"]);
    for flags in ["--pipeline 3", "--input-fraction 12", "--shininess 7", "--output-fraction 4"] {
        scratch.run(&format!("golden core {flags} --out spec.vec")).succeeds();
        let words = ["spec.vec", "vectors of core quadratic with spec", "are wanted"];
        scratch.refused("golden core --check spec.vec", &words);
        fs::copy(scratch.path("spec.vec"), scratch.path("core/golden/quadratic.vec")).unwrap();
        scratch.refused("cosim core", &["vectors of core quadratic with spec", "are wanted"]);
    }
}

#[test]
fn golden_refuses_what_is_no_golden_file() {
    let scratch = with_core();
    let text = scratch.text("core/golden/quadratic.vec");
    let lines: Vec<&str> = text.split_inclusive('\n').collect();
    let (vectors, digests) = (lines.len() / 2, lines.len() - 1);
    scratch.write("vectors.vec", lines[..vectors].concat());
    scratch.refused("golden core --check vectors.vec", &["vectors.vec", "announced", "truncated"]);
    scratch.write("digests.vec", lines[..digests].concat());
    scratch.refused("golden core --check digests.vec", &["digests.vec", "3 digests", "2 are there", "truncated"]);
    scratch.write("digit.vec", &text[..text.len() - 3]);
    scratch
        .refused("golden core --check digit.vec", &[&format!("digit.vec:{}:1", lines.len()), "malformed", "`d` lines"]);
    scratch.write("line.vec", replaced(&text, "\nv 0 200 ", "\nv 0 "));
    scratch.refused("golden core --check line.vec", &["line.vec:8:1", "malformed", "`v` lines"]);
    scratch.write("code.vec", replaced(&text, "\nv 0 200 ", "\nv 0 fff "));
    scratch.refused("golden core --check code.vec", &["code.vec:8:1", "`fff` is not a 10-bit code"]);
    scratch.write("binary.vec", b"# \xff");
    scratch.refused("golden core --check binary.vec", &["binary.vec is not UTF-8 text", "ASCII"]);
    scratch.write("empty.vec", "");
    scratch.refused("golden core --check empty.vec", &["empty.vec", "no golden file", "`c` line"]);
    scratch.refused("golden core --check core/rom/quadratic.mem", &["quadratic.mem:1:1", "malformed"]);
    scratch.refused("golden core --check missing.vec", &["cannot read missing.vec"]);
    fs::remove_file(scratch.path("core/golden/quadratic.vec")).unwrap();
    scratch.refused("cosim core", &["cannot read core/golden/quadratic.vec"]);
}

#[test]
fn eval_refuses_what_the_core_cannot_be_given() {
    let scratch = with_core();
    scratch.refused("eval core -n 6 -x 0.5", &["no shininess 6", "1,5,20.5"]);
    scratch.refused("eval core -n NaN -x 0.5", &["no shininess NaN", "1,5,20.5"]);
    scratch.refused("eval --method cubic --shininess 1..=99 -n 100 -x 0.5", &["no shininess 100", "99 of them"]);
    scratch.refused("eval core -n 5 -x 2", &["in_cos = 2 does not fit Q1.8", "-2 to 1.99609375"]);
    scratch.refused("eval core -n 5 -x -2.01", &["in_cos = -2.01 does not fit Q1.8", "-2 to 1.99609375"]);
    scratch.refused("eval core -n 5 -x NaN", &["in_cos = NaN does not fit Q1.8", "-2 to 1.99609375"]);
    scratch.refused("eval core -n 5 -x bright", &["'bright'", "--x"]);
    scratch.refused(&format!("eval {CUBIC} -n 5 -x 1.5"), &["in_ver = -0.5 does not fit UQ1.8", "0 to 1.99609375"]);
    scratch.refused("eval core -n 5", &["required", "--x"]);
}

#[test]
fn cosim_refuses_what_cannot_be_simulated() {
    let scratch = with_core();
    scratch.refused("cosim core --sim modelsim", &["'modelsim'", "--sim", "builtin, icarus, verilator, ghdl, all"]);
    scratch.refused("cosim core --exhaustive --sim builtin", &["--exhaustive", "--sim builtin", "--sim verilator"]);
    scratch.refused("cosim core --exhaustive", &["--exhaustive", "--sim builtin", "--sim verilator"]);
    scratch.refused("cosim core --exhaustive --sim icarus", &["--exhaustive", "--sim icarus", "--sim verilator"]);
    scratch.run(&format!("generate {SMALL} --languages verilog --out verilog")).succeeds();
    scratch.refused("cosim verilog --sim ghdl", &["no VHDL", "generate it with that language"]);
    scratch.refused("cosim verilog --sim ghdl --exhaustive", &["no VHDL", "generate it with that language"]);
}

#[test]
fn a_command_that_is_not_known_is_refused() {
    let scratch = Scratch::new();
    scratch.refused("generat", &["'generat'", "generate"]);
    scratch.refused(&format!("generate {SMALL}"), &["--out <DIR>"]);
    scratch.refused("doctor --wrong", &["unexpected argument '--wrong'"]);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(24) })]

    #[test]
    fn any_bytes_are_refused_in_words(bytes in prop::collection::vec(any::<u8>(), 0..200), keep in 0usize..400) {
        let scratch = Scratch::new();
        scratch.write("spec.toml", SMALL_TOML);
        let mut spec = SMALL_TOML.as_bytes()[..keep.min(SMALL_TOML.len() - 1)].to_vec();
        spec.extend_from_slice(&bytes);
        spec.push(b'=');
        scratch.write("wrong.toml", spec);
        scratch.run("generate wrong.toml --out core").refuses(&[]);
        for format in ["mem", "hex", "coe", "mif", "vhd", "h", "csv"] {
            let file = format!("wrong.{format}");
            scratch.write(&file, [b"(", bytes.as_slice()].concat());
            scratch.run(&format!("rom spec.toml --check {file}")).refuses(&[]);
        }
        scratch.write("wrong.vec", [b"w", bytes.as_slice()].concat());
        scratch.run("golden spec.toml --check wrong.vec").refuses(&[]);
        prop_assert!(!scratch.path("core").exists());
    }

    #[test]
    fn a_file_that_was_cut_never_passes(cut in 2usize..20_000) {
        let scratch = with_core();
        for (command, file) in [("golden", "core/golden/quadratic.vec"), ("rom", "core/rom/quadratic.mem")] {
            let whole = scratch.read(file);
            let cut = 2 + cut % (whole.len() - 2);
            scratch.write(file, &whole[..whole.len() - cut]);
            let run = scratch.run(&format!("{command} core --check {file}"));
            let allowed = if command == "golden" { 2..=2 } else { 1..=2 };
            prop_assert!(allowed.contains(&run.code), "{command} ends with {}: {}", run.code, run.stdout + &run.stderr);
            prop_assert!(run.stdout.len() + run.stderr.len() > 0);
        }
    }
}

#[test]
fn extreme_specs_make_a_core_or_are_refused() {
    let scratch = Scratch::new();
    for method in ["quadratic", "cubic", "cubic --q 0.05", "quadratic --form paper", "cubic --form paper"] {
        for set in ["1", "1..=2", "1..=3", "1,1,1", "1.0000001", "2", "1048576", "1,1048576", "65535..=65537"] {
            for (input, output) in [(4, 4), (4, 16), (8, 8)] {
                let widths = format!("--input-fraction {input} --output-fraction {output}");
                let line = format!("generate --method {method} --shininess {set} {widths} --out core");
                println!("brdfgen {line}");
                let run = scratch.run(&line);
                if run.code == 0 {
                    run.says(&["PASS builtin"]);
                    fs::remove_dir_all(scratch.path("core")).unwrap();
                } else {
                    run.refuses(&["more than 126 bits", "fewer fraction bits"]);
                    assert!(!scratch.path("core").exists());
                }
            }
        }
    }
}

// Generating

#[test]
fn generate_writes_these_files_and_says_that_the_simulation_passed() {
    let scratch = Scratch::new();
    let run = scratch.run(&format!("generate {SMALL} --out core")).succeeds();
    let run = run.says(&["quadratic: Q1.8 -> UQ1.8", "PASS builtin", " 0 mismatches", "10 files in core"]);
    assert!(run.stdout.contains("error against x^n"));
    let expected = [
        "README.md",
        "core.toml",
        "files.f",
        "golden/quadratic.vec",
        "manifest.json",
        "rom/quadratic.mem",
        "rtl/quadratic.v",
        "rtl/quadratic.vhd",
        "tb/quadratic_tb.v",
        "tb/quadratic_tb.vhd",
    ];
    assert_eq!(scratch.files("core"), expected);
    assert_eq!(scratch.files(""), expected.map(|file| format!("core/{file}")), "nothing beside the core");
    assert_eq!(scratch.text("core/files.f"), "rtl/quadratic.v\n");
}

#[test]
fn generate_fills_an_existing_empty_directory() {
    let scratch = Scratch::new();
    scratch.run(&format!("generate {SMALL} --out new/core/")).succeeds();
    fs::create_dir(scratch.path("empty")).unwrap();
    scratch.run(&format!("generate {SMALL} --out empty")).succeeds();
    assert_eq!(scratch.tree("empty"), scratch.tree("new/core"));
    let here = Scratch::new();
    here.run(&format!("generate {SMALL} --out .")).succeeds();
    assert_eq!(here.tree(""), scratch.tree("new/core"));
}

#[cfg(unix)]
#[test]
fn generate_follows_a_link_to_an_empty_directory() {
    let scratch = Scratch::new();
    fs::create_dir(scratch.path("real")).unwrap();
    std::os::unix::fs::symlink("real", scratch.path("link")).unwrap();
    scratch.run(&format!("generate {SMALL} --out link")).succeeds();
    assert_eq!(scratch.files("real").len(), 10);
    assert!(scratch.path("link").is_symlink());
}

#[test]
fn a_core_is_made_again_from_its_own_spec() {
    let scratch = Scratch::new();
    let materials =
        "--method quadratic --input-fraction 8 --material old_brass=9.5 --material gold=80 --rom file --name gloss";
    for (index, flags) in [SMALL, CUBIC, materials].iter().enumerate() {
        let (first, second, third) = (format!("a{index}"), format!("b{index}"), format!("c{index}"));
        scratch.run(&format!("generate {flags} --out {first}")).succeeds();
        scratch.run(&format!("generate {first}/core.toml --out {second}")).succeeds();
        assert_eq!(scratch.tree(&first), scratch.tree(&second));
        scratch.run(&format!("generate {first} --out {third}")).succeeds();
        assert_eq!(scratch.tree(&first), scratch.tree(&third));
        scratch.run(&format!("generate {first} --out {first}")).succeeds();
        assert_eq!(scratch.tree(&first), scratch.tree(&third));
    }
}

#[test]
fn flags_and_a_spec_file_give_the_same_bytes() {
    let scratch = with_core();
    scratch.write("spec.toml", SMALL_TOML);
    scratch.run("generate spec.toml --out toml").succeeds();
    assert_eq!(scratch.tree("toml"), scratch.tree("core"));
    scratch.write("other.toml", replaced(SMALL_TOML, "[1, 5, 20.5]", "\"2..=3\"") + "languages = [\"vhdl\"]\n");
    let line = "generate other.toml --shininess 1,5,20.5 --languages vhdl,verilog --out both";
    scratch.run(line).succeeds();
    assert_eq!(scratch.tree("both"), scratch.tree("core"), "a flag wins over the file");
}

#[test]
fn the_bytes_do_not_depend_on_the_machine() {
    let scratch = with_core();
    for (threads, zone, locale) in [("1", "Asia/Tokyo", "C"), ("3", "America/New_York", "de_DE.UTF-8")] {
        let elsewhere = Scratch::new();
        let mut command = elsewhere.command();
        command.env_clear().env("RAYON_NUM_THREADS", threads).env("TZ", zone).env("LC_ALL", locale);
        command.env("HOSTNAME", "another-host").env("USER", "someone-else").env("HOME", elsewhere.path("home"));
        command.args(["generate", "--out", "deeper/core"]).args(SMALL.split(' ')).assert().success();
        assert_eq!(elsewhere.tree("deeper/core"), scratch.tree("core"), "{threads} threads");
    }
}

#[test]
fn no_file_tells_where_or_when_it_was_made() {
    let scratch = with_core();
    scratch.run("rom core --out core/rom").succeeds();
    let mut secrets = vec![scratch.path("").to_str().unwrap().trim_end_matches('/').to_owned(), "/tmp".to_owned()];
    let name = scratch.path("").file_name().map(|name| name.to_str().unwrap().to_owned());
    secrets.extend(name);
    // A short name could be part of an ordinary word.
    let host = fs::read_to_string("/proc/sys/kernel/hostname").unwrap_or_default().trim().to_owned();
    secrets.extend((host.len() > 7).then_some(host));
    for (path, content) in scratch.tree("core") {
        let Some(content) = content else { continue };
        let text = String::from_utf8_lossy(&content);
        for secret in &secrets {
            assert!(!text.contains(secret), "{} holds {secret}", path.display());
        }
        let time = ["dddd-dd-dd", "dddd/dd/dd", "dd:dd:dd"].iter().find_map(|shape| first_like(&text, shape));
        assert_eq!(time, None, "{}", path.display());
    }
}

/// The first part of `text` that is like `shape`, where `d` stands for a digit.
fn first_like(text: &str, shape: &str) -> Option<String> {
    let like = |window: &[u8]| {
        let fits = |(c, s): (&u8, u8)| if s == b'd' { c.is_ascii_digit() } else { *c == s };
        window.iter().zip(shape.bytes()).all(fits)
    };
    let found = text.as_bytes().windows(shape.len()).find(|window| like(window))?;
    Some(String::from_utf8_lossy(found).into_owned())
}

#[test]
fn the_manifest_has_the_digest_of_every_other_file() {
    let scratch = Scratch::new();
    scratch.run(&format!("generate {CUBIC} --rom-formats coe,mif,bin --out core")).succeeds();
    let manifest: serde_json::Value = serde_json::from_slice(&scratch.read("core/manifest.json")).unwrap();
    let stated = manifest["files_sha256"].as_object().unwrap();
    let mut files = scratch.files("core");
    files.retain(|file| file != "manifest.json");
    assert_eq!(files.len(), 12);
    let mut named: Vec<&String> = stated.keys().collect();
    named.sort();
    assert_eq!(named, files.iter().collect::<Vec<_>>());
    for file in files {
        let digest = Sha256::digest(scratch.read(format!("core/{file}")));
        let digits: String = digest.iter().map(|byte| format!("{byte:02x}")).collect();
        assert_eq!(stated[&file], digits, "{file}");
    }
}

#[test]
fn regenerating_removes_what_the_core_no_longer_has_and_nothing_else() {
    let scratch = with_core();
    scratch.write("core/rtl/my_wrapper.v", "module my_wrapper; endmodule\n");
    scratch.write("core/notes/todo.txt", "mine");
    scratch.run("generate core --languages vhdl --out core").succeeds();
    let files = scratch.files("core");
    for gone in ["rtl/quadratic.v", "tb/quadratic_tb.v"] {
        assert!(!files.contains(&gone.to_owned()), "{gone} is stale");
    }
    assert_eq!(scratch.text("core/rtl/my_wrapper.v"), "module my_wrapper; endmodule\n");
    assert_eq!(scratch.text("core/notes/todo.txt"), "mine");
    scratch.run("generate core --out fresh").succeeds();
    let fresh = scratch.tree("fresh");
    assert!(fresh.iter().all(|entry| scratch.tree("core").get(entry.0) == Some(entry.1)));
    assert_eq!(files.len(), scratch.files("fresh").len() + 2);

    scratch.run("generate core --name renamed --out core").succeeds();
    let old = scratch.files("core").into_iter().filter(|file| file.contains("quadratic"));
    assert_eq!(old.collect::<Vec<_>>(), Vec::<String>::new());
}

#[test]
fn a_manifest_cannot_make_generate_remove_files_elsewhere() {
    let scratch = with_core();
    scratch.write("precious.txt", "outside");
    let mut manifest: serde_json::Value = serde_json::from_slice(&scratch.read("core/manifest.json")).unwrap();
    let listed = manifest["files_sha256"].as_object_mut().unwrap();
    for path in ["../precious.txt".to_owned(), scratch.path("precious.txt").to_str().unwrap().to_owned()] {
        listed.insert(path, json!("0"));
    }
    scratch.write("core/manifest.json", manifest.to_string());
    scratch.run("generate core --languages vhdl --out core").succeeds();
    assert_eq!(scratch.text("precious.txt"), "outside");
}

#[test]
fn generate_check_finds_what_is_not_fresh_and_writes_nothing() {
    let scratch = with_core();
    scratch.run("generate core --check --out core").succeeds().says(&["10 of 10 files"]);
    scratch.run("generate core --check --out missing").ends_with(1).says(&["missing/core.toml is missing", "0 of 10"]);
    assert!(!scratch.path("missing").exists());
    let text = scratch.text("core/rtl/quadratic.v");
    scratch.write("core/rtl/quadratic.v", text + " ");
    fs::remove_file(scratch.path("core/files.f")).unwrap();
    let before = scratch.tree("");
    let run = scratch.run("generate core --check --out core").ends_with(1);
    let run = run.says(&["core/rtl/quadratic.v differs", "core/files.f is missing", "8 of 10 files"]);
    assert_eq!(run.stdout.matches("differs").count(), 1);
    let run = scratch.run("generate core --check --json --out core").ends_with(1);
    assert_eq!(
        run.json(),
        json!({ "checked": 10, "differ": ["rtl/quadratic.v", "files.f"], "differ_in_line_ends_only": [] })
    );
    assert_eq!(scratch.tree(""), before);
}

#[test]
fn every_command_can_answer_in_json() {
    let scratch = Scratch::new();
    let json = |line: &str| scratch.run(line).succeeds().json();
    let generated = json(&format!("generate {SMALL} --json --out core"));
    assert_eq!((&generated["passed"], &generated["name"]), (&json!(true), &json!("quadratic")));
    let mut files: Vec<String> = serde_json::from_value(generated["files"].clone()).unwrap();
    files.sort();
    assert_eq!(files, scratch.files("core"));
    assert_eq!(json("generate core --json --check --out core")["differ"], json!([]));
    assert_eq!(json("rom core --json")["files"].as_array().map(Vec::len), Some(10));
    assert_eq!(json("rom core --json --check rom/quadratic.coe")["first_difference"], json!(null));
    assert_eq!(json("golden core --json")["file"], json!("golden/quadratic.vec"));
    assert_eq!(json("golden core --json --check golden/quadratic.vec")["differences"], json!(0));
    assert_eq!(json("cosim core --json")["passed"], json!(true));
    assert_eq!(json("eval core --json -n 5 -x 1")["model"], json!(1.0));
    assert!(json("doctor --json")["tools"].as_array().is_some_and(|tools| !tools.is_empty()));
}

// Golden vectors

#[test]
fn golden_writes_the_file_of_the_core() {
    let scratch = with_core();
    let expected = scratch.read("core/golden/quadratic.vec");
    scratch.run("golden core").succeeds().says(&["vectors and 3 digests in golden/quadratic.vec"]);
    assert_eq!(scratch.read("golden/quadratic.vec"), expected);
    scratch.run(&format!("golden {SMALL} --out flags.vec")).succeeds();
    assert_eq!(scratch.read("flags.vec"), expected);
    assert_eq!(scratch.run("golden core --out -").succeeds().stdout.as_bytes(), expected);
    scratch.run("golden core --check golden/quadratic.vec").succeeds().says(&["3 digests, 0 differences"]);
}

/// The small core's golden file with the output of the vector for n = 5 and x = 1 changed from 1.0.
fn with_wrong_output(scratch: &Scratch) -> String {
    replaced(&scratch.text("core/golden/quadratic.vec"), "\nv 1 100 100 ", "\nv 1 100 101 ")
}

#[test]
fn golden_check_names_a_wrong_output_and_a_wrong_digest() {
    let scratch = with_core();
    scratch.write("output.vec", with_wrong_output(&scratch));
    let run = scratch.run("golden core --check output.vec").ends_with(1);
    run.says(&["in_n = 1 (n = 5), in_cos = 256 (1): expected 256, got 257", "output.vec", "1 differences"]);
    let first = &scratch.run("golden core --json --check output.vec").ends_with(1).json()["first"][0];
    let operand = json!({ "port": "in_cos", "code": 256, "value": 1.0 });
    assert_eq!((&first["selected"], &first["inputs"][1]), (&json!("n = 5"), &operand));
    assert_eq!((&first["expected"], &first["got"]), (&json!([256]), &json!([257])));

    let text = scratch.text("core/golden/quadratic.vec");
    let line = text.lines().find(|line| line.starts_with("d 2 ")).unwrap();
    let last = if line.ends_with('0') { '1' } else { '0' };
    scratch.write("digest.vec", replaced(&text, line, &format!("{}{last}", &line[..line.len() - 1])));
    let run = scratch.run("golden core --check digest.vec").ends_with(1);
    run.says(&["digest of in_n = 2: expected", "got", "1 differences"]);

    scratch.write("pause.vec", replaced(&text, "\nv 0 200 000 0 0\n", "\nv 0 200 000 1 0\n"));
    scratch.run("golden core --check pause.vec").ends_with(1).says(&["vector 1: expected", "idle 1"]);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(16) })]

    #[test]
    fn golden_check_finds_any_changed_output(place in any::<prop::sample::Index>(), flip in 1u32..256) {
        let scratch = with_core();
        let text = scratch.text("core/golden/quadratic.vec");
        let vectors: Vec<&str> = text.lines().filter(|line| line.starts_with("v ")).collect();
        let line = *place.get(&vectors);
        let mut words: Vec<String> = line.split(' ').map(str::to_owned).collect();
        let output = u32::from_str_radix(&words[3], 16).unwrap();
        words[3] = format!("{:03x}", output ^ flip);
        scratch.write("wrong.vec", replaced(&text, line, &words.join(" ")));
        let run = scratch.run("golden core --check wrong.vec").ends_with(1);
        run.says(&[&format!("expected {output}, got {}", output ^ flip), "1 differences"]);
    }
}

// ROM files

/// The files that `rom` writes for the small core.
const ROM_FILES: [&str; 10] = [
    "quadratic.bin",
    "quadratic.coe",
    "quadratic.csv",
    "quadratic.hex",
    "quadratic.mem",
    "quadratic.mif",
    "quadratic_plain.mem",
    "quadratic_quartus.hex",
    "quadratic_rom.h",
    "quadratic_rom_pkg.vhd",
];

#[test]
fn rom_writes_every_format_and_reads_each_back() {
    let scratch = with_core();
    let run = scratch.run("rom core").succeeds();
    assert_eq!(scratch.files("rom"), ROM_FILES);
    let run = ROM_FILES.iter().fold(run, |run, file| run.says(&[&format!("rom/{file}")]));
    assert_eq!(run.stdout.lines().count(), ROM_FILES.len());
    for file in ROM_FILES {
        scratch.run(&format!("rom core --check rom/{file}")).succeeds().says(&[file, "all 4 words"]);
    }
    assert_eq!(scratch.read("rom/quadratic.mem"), scratch.read("core/rom/quadratic.mem"));
    scratch
        .run(&format!("generate {SMALL} --rom-formats hex,coe,mif,vhdl,c,csv,bin,quartus-hex,mem-plain --out full"))
        .succeeds();
    scratch.run("rom full --out again").succeeds();
    assert_eq!(scratch.tree("full/rom"), scratch.tree("again"));
    scratch.run("rom core --format coe,bin --out two").succeeds();
    assert_eq!(scratch.files("two"), ["quadratic.bin", "quadratic.coe"]);
}

#[test]
fn rom_writes_one_format_to_standard_output() {
    let scratch = with_core();
    scratch.run("rom core").succeeds();
    for (format, file) in [("mem", "quadratic.mem"), ("c", "quadratic_rom.h"), ("csv", "quadratic.csv")] {
        let before = scratch.tree("");
        let run = scratch.run(&format!("rom core --format {format} --out -")).succeeds();
        assert_eq!(run.stdout, scratch.text(format!("rom/{file}")));
        assert_eq!(scratch.tree(""), before);
    }
}

/// A ROM file of the small core with the last bit of the word at address 1 changed.
fn with_wrong_word(file: &str, bytes: &[u8], word: u64) -> Vec<u8> {
    let wrong = word ^ 1;
    let text = String::from_utf8_lossy(bytes);
    let hexadecimal = |before: &str, after: &str| {
        replaced(&text, &format!("{before}{word:03x}{after}"), &format!("{before}{wrong:03x}{after}")).into_bytes()
    };
    match file.rsplit_once('.').unwrap().1 {
        "mem" => hexadecimal("\n", "\n"),
        "coe" => hexadecimal("\n", ",\n"),
        "mif" => hexadecimal("1 : ", ";\n"),
        "h" => hexadecimal("0x", "u,"),
        "csv" => hexadecimal(",0x", "\n"),
        "vhd" => replaced(&text, &format!("1 => \"{word:010b}\""), &format!("1 => \"{wrong:010b}\"")).into_bytes(),
        "bin" => {
            let mut bytes = bytes.to_vec();
            bytes[2] ^= 1;
            bytes
        }
        "hex" => {
            // Quartus has a word a record, the last byte of it last.
            let by_words = file.ends_with("_quartus.hex");
            let changed = |line: &str| {
                let mut record = Record::from_record_string(line).unwrap();
                match &mut record {
                    Record::Data { offset: 1, value } if by_words => value[1] ^= 1,
                    Record::Data { value, .. } if !by_words => value[2] ^= 1,
                    _ => {}
                }
                record.to_record_string().unwrap() + "\n"
            };
            text.lines().map(changed).collect::<String>().into_bytes()
        }
        other => unreachable!("{other} is no format"),
    }
}

#[test]
fn rom_check_names_the_address_of_a_changed_word_in_each_format() {
    let scratch = with_core();
    scratch.run("rom core").succeeds();
    let text = scratch.text("rom/quadratic.mem");
    let words: Vec<&str> = text.lines().filter(|line| !line.starts_with("//")).collect();
    let word = u64::from_str_radix(words[1], 16).unwrap();
    assert_eq!(words.iter().filter(|other| **other == words[1]).count(), 1);
    let told = format!("address 1 (shininess 5): the word is 0x{:03x} and should be 0x{word:03x}", word ^ 1);
    for file in ROM_FILES {
        let path = format!("wrong/{file}");
        scratch.write(&path, with_wrong_word(file, &scratch.read(format!("rom/{file}")), word));
        scratch.run(&format!("rom core --check {path}")).ends_with(1).says(&[&path, &told]);
        let run = scratch.run(&format!("rom core --json --check {path}")).ends_with(1);
        assert!(run.json()["first_difference"].as_str().is_some_and(|text| text.starts_with(&told)), "{path}");
    }
}

#[test]
fn rom_check_names_the_first_missing_and_the_first_surplus_word() {
    let scratch = with_core();
    let text = scratch.text("core/rom/quadratic.mem");
    let last = text.lines().last().unwrap().len() + 1;
    scratch.write("short.mem", &text[..text.len() - last]);
    scratch.run("rom core --check short.mem").ends_with(1).says(&["address 3", "ends before this word"]);
    scratch.write("long.mem", text + "000\n");
    scratch.run("rom core --check long.mem").ends_with(1).says(&["address 4", "beyond the last address, 3"]);
}

// Evaluating

#[test]
fn eval_is_faithful_and_consistent() {
    let scratch = Scratch::new();
    let ulp = 1.0 / 256.0;
    for (flags, operand, shininesses) in [(SMALL, "in_cos", [1.0, 5.0, 20.5]), (CUBIC, "in_ver", [3.0, 4.0, 9.0])] {
        for n in shininesses {
            for x in [-0.75, -0.25, 0.0, 0.25, 0.5, 0.9, 0.96875, 0.99, 1.0] {
                let line = format!("eval {flags} --json -n {n} -x {x}");
                let answer = scratch.run(&line).succeeds().json();
                let number = |key: &str| answer[key].as_f64().unwrap_or_else(|| panic!("{line}: {key}"));
                let (exact, method, model) = (number("exact"), number("method"), number("model"));
                let clamped = f64::max(x, 0.0);
                assert_eq!(number("n"), n);
                assert!((number("x") - clamped).abs() <= ulp / 2.0, "{line}");
                assert!((exact - number("x").powf(n)).abs() < 1e-12, "{line}");
                assert!((model - method).abs() < ulp, "{line}: {model} is not faithful to {method}");
                assert_eq!(model, number("out_spec") * ulp, "{line}");
                assert!((number("model_minus_method_ulps") - (model - method) / ulp).abs() < 1e-6, "{line}");
                assert!((number("model_minus_exact") - (model - exact)).abs() < 1e-12, "{line}");
                let given = if operand == "in_cos" { x } else { 1.0 - x };
                assert_eq!(number(operand), (given / ulp).round(), "{line}");
                if x <= 0.0 {
                    assert_eq!((exact, method, model), (0.0, 0.0, 0.0), "{line}");
                }
                if x == 1.0 {
                    assert_eq!((exact, method, model), (1.0, 1.0, 1.0), "{line}");
                }
            }
        }
    }
}

#[test]
fn eval_says_the_same_in_words() {
    let scratch = with_core();
    let run = scratch.run("eval core -n 5 -x 1").succeeds();
    run.says(&["n = 5, x = 1 (in_n = 1, in_cos = 256)", "exact   1.000000000", "method  1.000000000"])
        .says(&["model   1.000000000", "(out_spec = 256)"]);
    let run = scratch.run("eval core -n 20.5 -x -0.5").succeeds();
    run.says(&["n = 20.5, x = 0 (in_n = 2, in_cos = -128)", "model   0.000000000", "(out_spec = 0)"]);
    let answer = scratch.run("eval core --json -n 5 -x 0.9").succeeds().json();
    let decimals = |key: &str| format!("{:.9}", answer[key].as_f64().unwrap());
    let run = scratch.run("eval core -n 5 -x 0.9").succeeds();
    run.says(&["exact", "method", "model", "ulp from the method"]).says(&[
        &decimals("exact"),
        &decimals("method"),
        &decimals("model"),
    ]);
}

// Tools and simulators

/// An empty directory, to be the only one in which programs are looked for.
fn no_programs(scratch: &Scratch) -> std::path::PathBuf {
    let path = scratch.path("no-programs");
    fs::create_dir(&path).unwrap();
    path
}

#[test]
fn doctor_names_each_missing_tool_and_its_package() {
    let scratch = Scratch::new();
    let path = no_programs(&scratch);
    let tools = [
        ("iverilog", "iverilog"),
        ("vvp", "iverilog"),
        ("verilator", "verilator"),
        ("ghdl", "ghdl"),
        ("g++", "g++"),
        ("make", "make"),
    ];
    let run = scratch.run_with_path(&path, "doctor").succeeds();
    for (program, package) in tools {
        let line = run.stdout.lines().find(|line| line.split_whitespace().nth(1) == Some(program));
        let line = line.unwrap_or_else(|| panic!("{program} is not in\n{}", run.stdout));
        assert!(line.starts_with("missing ") && line.contains(&format!("apt-get install {package} ")), "{line}");
    }
    let answer = scratch.run_with_path(&path, "doctor --json").succeeds().json();
    for (program, package) in tools {
        let of_it = |tool: &&serde_json::Value| tool["program"] == program;
        let tool = answer["tools"].as_array().unwrap().iter().find(of_it).unwrap();
        assert_eq!((&tool["debian_package"], &tool["version"]), (&json!(package), &json!(null)));
    }
}

#[test]
fn a_missing_simulator_is_named_with_its_package() {
    let scratch = with_core();
    let path = no_programs(&scratch);
    let before = scratch.tree("");
    for (options, package) in [
        ("--sim icarus", "iverilog"),
        ("--sim verilator", "verilator"),
        ("--sim ghdl", "ghdl"),
        ("--sim all", "iverilog"),
        ("--sim verilator --exhaustive", "verilator"),
        ("--sim ghdl --exhaustive", "ghdl"),
        ("--sim icarus --json", "iverilog"),
    ] {
        let run = scratch.run_with_path(&path, &format!("cosim core {options}"));
        run.refuses(&["not installed", &format!("apt-get install {package}")]);
    }
    assert_eq!(scratch.tree(""), before);
}

#[test]
fn generating_and_the_builtin_simulation_need_no_other_program() {
    let scratch = Scratch::new();
    let path = no_programs(&scratch);
    scratch.run_with_path(&path, &format!("generate {SMALL} --out core")).succeeds();
    let run = scratch.run_with_path(&path, "cosim core --sim builtin").succeeds();
    assert_eq!(run.says(&["PASS model", "PASS builtin"]).stdout.lines().count(), 2);
    scratch.run_with_path(&path, &format!("cosim {CUBIC}")).succeeds().says(&["PASS model", "PASS builtin"]);
}

fn junit(scratch: &Scratch, path: &str) -> Report {
    Report::deserialize_from_str(&scratch.text(path)).unwrap()
}

#[test]
fn cosim_reports_to_junit() {
    let scratch = with_core();
    scratch.run("cosim core --junit reports/pass.xml").succeeds();
    let report = junit(&scratch, "reports/pass.xml");
    assert_eq!((report.tests, report.failures, report.errors), (2, 0, 0));
    assert_eq!(report.test_suites[0].name.as_str(), "quadratic");
    let names: Vec<&str> = report.test_suites[0].test_cases.iter().map(|case| case.name.as_str()).collect();
    assert!(names[0].starts_with("model: ") && names[1].starts_with("builtin ("), "{names:?}");
    assert!(report.test_suites[0].test_cases.iter().all(|case| matches!(case.status, TestCaseStatus::Success { .. })));

    scratch.write("core/golden/quadratic.vec", with_wrong_output(&scratch));
    let run = scratch.run("cosim core --junit reports/fail.xml").ends_with(1);
    run.says(&["FAIL model", "FAIL builtin", "expected 256, got 257", "expected 257, got 256"]);
    let text = scratch.text("reports/fail.xml");
    assert_eq!((text.matches("<testcase ").count(), text.matches("<failure ").count()), (2, 2), "{text}");
    let report = junit(&scratch, "reports/fail.xml");
    assert_eq!((report.tests, report.failures, report.errors), (2, 2, 0));
    for case in &report.test_suites[0].test_cases {
        let TestCaseStatus::NonSuccess { message, description, .. } = &case.status else {
            panic!("{} is not a failure", case.name.as_str());
        };
        assert_eq!(message.as_ref().map(|text| text.as_str()), Some("1 mismatches"));
        assert!(description.as_ref().is_some_and(|text| text.as_str().contains("expected 25")));
    }
    let run = scratch.run("cosim core --json").ends_with(1);
    assert_eq!(run.json()["passed"], json!(false));
    assert_eq!(run.json()["simulations"][1]["mismatches"], json!(1));
}

#[cfg(unix)]
#[test]
fn a_simulator_that_gives_no_verdict_is_not_believed() {
    use std::os::unix::fs::PermissionsExt;
    let scratch = with_core();
    for program in ["iverilog", "vvp"] {
        let path = format!("silent/{program}");
        scratch.write(&path, "#!/bin/sh\nexit 0\n");
        fs::set_permissions(scratch.path(path), fs::Permissions::from_mode(0o755)).unwrap();
    }
    let run = scratch.run_with_path(&scratch.path("silent"), "cosim core --sim icarus --junit report.xml");
    run.ends_with(1).says(&["PASS model", "FAIL icarus: 0 of", "no verdict"]);
    assert_eq!(junit(&scratch, "report.xml").failures, 1);
}

// Paths

/// The arguments of a line, with `@` for a path.
fn with_path(line: &str, path: &Path) -> Vec<OsString> {
    let word = |word: &str| match word.strip_prefix('@') {
        Some("") => path.into(),
        Some(inside) => path.join(inside.trim_start_matches('/')).into(),
        None => word.into(),
    };
    line.split(' ').map(word).collect()
}

fn every_command_works_at(path: &Path) {
    let scratch = with_core();
    let expected: Tree = scratch.tree("core");
    let run = |line: &str| scratch.run_each(with_path(line, path)).succeeds();
    run(&format!("generate {SMALL} --out @"));
    assert_eq!(scratch.tree(path), expected);
    run("generate @ --check --out @");
    run("generate @/core.toml --out @");
    run("rom @ --out @/rom");
    run("rom @ --check @/rom/quadratic.hex");
    run("golden @ --out @/golden/quadratic.vec");
    run("golden @ --check @/golden/quadratic.vec");
    run("cosim @ --junit @/report.xml");
    run("eval @ -n 5 -x 0.5");
    assert_eq!(scratch.read(path.join("golden/quadratic.vec")), scratch.read("core/golden/quadratic.vec"));
    for (sim, package) in [("icarus", "iverilog"), ("ghdl", "ghdl")] {
        let run = scratch.run_each(with_path(&format!("cosim @ --sim {sim}"), path));
        if run.code == 2 {
            run.refuses(&["not installed", &format!("apt-get install {package}")]);
        } else {
            run.succeeds().says(&["PASS model", &format!("PASS {sim}")]);
        }
    }
}

#[test]
fn paths_with_spaces_and_quotes_work() {
    every_command_works_at(Path::new("two words/it's a \"core\""));
}

#[test]
fn paths_with_other_scripts_work() {
    every_command_works_at(Path::new("серце/Блінна – φωτεινότητα 光"));
}

#[cfg(target_os = "linux")]
#[test]
fn paths_that_are_not_utf8_work() {
    use std::os::unix::ffi::OsStrExt;
    every_command_works_at(Path::new(std::ffi::OsStr::from_bytes(b"latin-\xe9/core")));
}
