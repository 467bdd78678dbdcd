//! What is wrong is named, with what is allowed, and nothing is written.

use super::*;

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
    scratch
        .run(
            "generate --method harris --shininess 5 --log-bits 4 --exp-bits 5 --input-fraction 8 --output-fraction \
     8 --name le --out le",
        )
        .succeeds();
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
