//! What the commands on a core answer: golden, rom, eval, cosim and doctor.

use super::*;

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
