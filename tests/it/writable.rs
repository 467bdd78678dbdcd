//! Cores whose coefficients can be written: the words that they come up with and the words that are loaded, in
//! simulators and in synthesis.
//!
//! Needs iverilog, verilator, ghdl and yosys; `test.sh` installs them.

use std::process::Command;

use brdfgen::core::{Design, Role};
use brdfgen::datapath::simulate::{Inputs, Simulation, Write};
use brdfgen::emit::package;
use brdfgen::emit::rom::RomFormat;
use brdfgen::spec::{Language, RomStyle};
use brdfgen::verify::cosim::{self, Job, Sim};
use brdfgen::verify::golden::{self, Golden};
use rayon::prelude::*;

use crate::common::core::{Generated, design, ecp5_cells, resolved, silent};

const SPECS: &[&str] = &[
    "method = 'quadratic'\nshininess = '1..=1000'\nrom = 'writable'",
    "method = 'cubic'\nshininess = '1..=300'\nrom = 'writable'",
    "method = 'segmented-2'\nshininess = '1..=200'\nrom = 'writable'",
    "method = 'power-2'\nshininess = '1..=200'\nrom = 'writable'",
    // Read without a register, a single row, an address that is computed, signed fields.
    "method = 'quadratic'\nshininess = '1..=64'\npipeline = 1\nrom = 'writable'",
    "method = 'cubic'\nshininess = [50]\nrom = 'writable'",
    "method = 'quadratic'\nshininess = '900..=1000'\nrom = 'writable'",
    "method = 'cubic'\nshininess = [1.1, 1.5, 1.9, 2, 2.5]\nrom = 'writable'",
    "method = 'quadratic'\nshininess = '1..=64'\nshininess_fraction = 3\nrom = 'writable'",
];

#[test]
fn writable_cores_pass_everywhere_lint_clean_and_equal_the_rom_core() {
    SPECS.par_iter().for_each(|spec| {
        let generated = Generated::new(spec);
        let core = generated.on_disk();
        for sim in [Sim::Builtin, Sim::Icarus, Sim::Ghdl] {
            let outcome = core.run(sim);
            assert!(outcome.passed(), "{spec}\n{outcome:?}");
            assert_eq!(outcome.vectors, core.golden.vectors().len() as u64);
        }
        let with_rom = design(&spec.replace("rom = 'writable'", ""));
        assert_eq!(with_rom.schedule, core.design.schedule, "{spec}");
        let rom_golden = Golden::of(&with_rom);
        assert_eq!(rom_golden.groups, core.golden.groups, "{spec}");
        assert_eq!(rom_golden.digests, core.golden.digests, "{spec}");
        assert!(with_rom.ports().iter().all(|port| port.role != Role::Write));

        let name = &core.design.spec.name;
        let (verilog, vhdl) = (format!("rtl/{name}.v"), format!("rtl/{name}.vhd"));
        let (bench, vhdl_bench) = (format!("tb/{name}_tb.v"), format!("tb/{name}_tb.vhd"));
        let work = core.beside("work");
        std::fs::create_dir(&work).expect("a directory");
        let workdir = format!("--workdir={}", work.display());
        let out = work.join("out").display().to_string();
        let path = core.path();
        silent(path, "verilator", &["--lint-only", "-Wall", &verilog], spec);
        silent(path, "iverilog", &["-Wall", "-g2005", "-o", &out, &verilog, &bench], spec);
        silent(path, "ghdl", &["-a", "--std=08", &workdir, &vhdl, &vhdl_bench], spec);
        for file in [verilog, vhdl, bench, vhdl_bench] {
            let text = generated.text(&file);
            assert!(text.is_ascii() && text.ends_with('\n') && !text.contains(['\t', '\r']), "{file} of {spec}");
            let long = text.lines().find(|line| line.len() > 100 || line.ends_with(' '));
            assert_eq!(long, None, "{file} of {spec}");
        }
    });
}

#[test]
fn the_bench_passes_in_verilator() {
    let outcome = Generated::new(SPECS[2]).on_disk().run(Sim::Verilator);
    assert!(outcome.passed(), "{outcome:?}");
}

/// Complemented words show: the vectors of the loading test are some, and each differs from the golden one.
#[test]
fn every_vector_of_the_loading_test_differs_from_the_golden_one() {
    for spec in SPECS {
        let design = design(spec);
        let golden = Golden::of(&design);
        let others = golden::complemented(&design, &golden);
        assert!(!others.is_empty() && others.len() <= 64, "{spec}: {}", others.len());
        for other in &others {
            assert_ne!(design.evaluate(&other.inputs), other.outputs, "{spec}: {:?}", other.inputs);
        }
        for (table, inverted) in design.tables().iter().zip(golden::complemented_tables(&design)) {
            let ones = (num_bigint::BigUint::from(1u8) << table.word_bits()) - 1u8;
            assert!(table.words().iter().zip(inverted.words()).all(|(word, other)| word + other == ones), "{spec}");
            for (address, word) in table.words().iter().enumerate() {
                let codes: Vec<i128> = (0..table.fields.len()).map(|field| table.code_at(field, address)).collect();
                assert_eq!(table.codes_of(word), codes, "{spec}");
            }
        }
    }
}

/// The words of another set, loaded into a core of the same datapath, make it the other core; and only with the same
/// digest.
#[test]
fn the_words_of_a_core_with_the_same_digest_make_it_that_core() {
    let spec = |q: f64, last: u32| {
        design(&format!(
            "method = 'cubic'\nshininess = '1..={last}'\nq = {q}\ninput_fraction = 10\noutput_fraction = 10\nrom = \
             'writable'"
        ))
    };
    let (core, other) = (spec(0.5, 100), spec(0.51, 100));
    assert_eq!(core.datapath_digest(), other.datapath_digest());
    assert_ne!(core.tables(), other.tables());
    assert_ne!(core.datapath_digest(), spec(0.5, 400).datapath_digest());
    let mut simulation = Simulation::new(core.graph(), &core.schedule, core.tables());
    let words = other.tables()[0].words();
    for (address, word) in words.into_iter().enumerate() {
        simulation.clock_writing(&Inputs::default(), &[Write { memory: 0, address, word }]);
    }
    let mut differ = 0;
    for n in [1u32, 7, 50, 100] {
        for cos in (0..=1024).step_by(17) {
            let codes = vec![i128::from(n), cos];
            let inputs = Inputs { ce: true, in_valid: true, codes, ..Inputs::default() };
            let outputs = (0..core.schedule.latency).map(|_| simulation.clock(&inputs)).last().expect("a clock");
            let inputs = [n.into(), cos as i64];
            assert_eq!(outputs.codes, [i128::from(other.evaluate(&inputs)[0])], "{inputs:?}");
            differ += u32::from(core.evaluate(&inputs) != other.evaluate(&inputs));
        }
    }
    assert!(differ > 0, "the two cores are told apart");
}

/// A fault: what it is, a text of the HDL, and what takes its place.
type Fault = (&'static str, &'static str, &'static str);

const VERILOG_FAULTS: &[Fault] = &[
    ("write ignored", "if (wr_en) rom", "if (1'b0) rom"),
    ("enable ignored", "if (wr_en) rom", "if (1'b1) rom"),
    ("enable inverted", "if (wr_en) rom", "if (!wr_en) rom"),
    ("write gated by ce", "if (wr_en) rom", "if (wr_en && ce) rom"),
    ("write gated by rst", "if (wr_en) rom", "if (wr_en && !rst) rom"),
    ("address bit inverted", "rom[wr_addr] <=", "rom[wr_addr ^ 10'd4] <="),
    ("address bit stuck", "rom[wr_addr] <=", "rom[wr_addr & 10'h1ff] <="),
    ("data bits swapped", "<= wr_data;", "<= {wr_data[21:2], wr_data[0], wr_data[1]};"),
    ("data bit stuck", "<= wr_data;", "<= wr_data & 22'h3fffef;"),
    ("a word that the core comes up with", "rom[33] = 22'h32ee65;", "rom[33] = 22'h32ee75;"),
    ("half that cannot be written", "if (wr_en) rom", "if (wr_en && !wr_addr[9]) rom"),
    ("written to the word read", "rom[wr_addr] <=", "rom[in_n] <="),
];

const VHDL_FAULTS: &[Fault] = &[
    ("write ignored", "if wr_en = '1' then", "if false then"),
    ("enable inverted", "if wr_en = '1' then", "if wr_en = '0' then"),
    ("write gated by ce", "if wr_en = '1' then", "if wr_en = '1' and ce = '1' then"),
    ("address bit inverted", "rom(to_integer(wr_addr)) <=", "rom(to_integer(wr_addr xor \"0000000100\")) <="),
    (
        "data bits swapped",
        "<= std_logic_vector(wr_data);",
        "<= std_logic_vector(wr_data(21 downto 2)) & wr_data(0) & wr_data(1);",
    ),
    ("a word that the core comes up with", "33 => x\"32ee65\"", "33 => x\"32ee75\""),
];

/// Faults of the second memory's write port.
const SCALE_FAULTS: &[Fault] = &[
    ("write ignored", "if (wr_scale_en) scale", "if (1'b0) scale"),
    ("written together with the coefficients", "if (wr_scale_en) scale", "if (wr_en) scale"),
];

#[test]
fn broken_write_ports_fail() {
    let (quadratic, segmented) = (Generated::new(SPECS[0]), Generated::new(SPECS[2]));
    for (right, language, sim, faults) in [
        (&quadratic, Language::Verilog, Sim::Icarus, VERILOG_FAULTS),
        (&quadratic, Language::Vhdl, Sim::Ghdl, VHDL_FAULTS),
        (&segmented, Language::Verilog, Sim::Icarus, SCALE_FAULTS),
    ] {
        faults.par_iter().for_each(|&fault| {
            let what = fault.0;
            let outcome = right.with_fault(language, fault).run(sim);
            assert!(!outcome.passed(), "{what} goes unnoticed: {outcome:?}");
            assert!(outcome.mismatches > 0, "{what}: the bench compared nothing: {outcome:?}");
        });
    }
}

/// A bench without its words, or with a wrong one, fails.
#[test]
fn the_bench_loads_the_words_of_the_file() {
    let generated = Generated::new("method = 'quadratic'\nshininess = '1..=60'\nrom = 'writable'");
    for sim in [Sim::Icarus, Sim::Ghdl] {
        let core = generated.on_disk();
        let file = core.path().join(package::rom_path(&core.design, &core.design.tables()[0], RomFormat::Mem));
        let text = std::fs::read_to_string(&file).expect("words");
        let mut lines: Vec<&str> = text.lines().collect();
        lines.pop();
        std::fs::write(&file, lines.join("\n") + "\n").expect("written");
        assert!(!core.run(sim).passed(), "{sim:?}: cut");
        let last = text.lines().last().expect("a word");
        let wrong: String = last.chars().map(|digit| if digit == '0' { '1' } else { '0' }).collect();
        std::fs::write(&file, lines.join("\n") + "\n" + &wrong + "\n").expect("written");
        assert!(core.run(sim).mismatches > 0, "{sim:?}: another word");
        std::fs::remove_file(&file).expect("removed");
        assert!(!core.run(sim).passed(), "{sim:?}: missing");
    }
}

#[test]
fn exhaustive_runs_leave_the_memories_alone() {
    let spec = "method = 'quadratic'\nshininess = '2..=9'\ninput_fraction = 7\noutput_fraction = 7\nrom = 'writable'";
    let core = Generated::new(spec).on_disk();
    let path = core.path();
    let job = Job { design: &core.design, golden: &core.golden, directory: path };
    let outcome = cosim::exhaustive(job.design.lobe(), job.directory, Language::Vhdl, &|_, _| {}).expect("it runs");
    assert!(outcome.passed() && outcome.vectors == 8 << 9, "{outcome:?}");
}

/// Yosys makes block RAM of the memory, from both languages; with no logic about it from the Verilog.
#[test]
fn yosys_infers_block_ram() {
    for (spec, name) in
        [(SPECS[0], "quadratic"), ("method = 'segmented-2'\nshininess = '1..=1000'\nrom = 'writable'", "segmented_2")]
    {
        let core = Generated::new(spec).on_disk();
        for source in core.as_verilog() {
            let count = ecp5_cells(&source, name);
            let (ram, luts, ffs) = (count("DP16KD"), count("LUT4"), count("TRELLIS_FF"));
            println!("{name} {}: LUT4 {luts} FF {ffs} DSP {} BRAM {ram}", source.display(), count("MULT18X18D"));
            let bits: usize = core.design.tables().iter().map(brdfgen::fixed::Table::bits).sum();
            assert!(ram > 0 && ram as usize <= 2 + bits.div_ceil(16 << 10) * 2, "{name}: {ram} block RAMs");
            assert_eq!(count("TRELLIS_DPR16X4"), 0, "{name}: no memory of LUTs");
        }
    }
}

#[test]
fn a_method_without_coefficients_is_refused() {
    for method in ["lyon-2", "schlick"] {
        let spec = resolved(&format!("method = '{method}'\nshininess = '1..=100'\nrom = 'writable'"));
        let error = Design::new(spec).expect_err(method).to_string();
        assert!(error.contains("no coefficient memory"), "{error}");
        let scratch = tempfile::tempdir().expect("a directory");
        let out = scratch.path().join("core");
        let run = Command::new(env!("CARGO_BIN_EXE_brdfgen"))
            .args(["generate", "--method", method, "--shininess", "1..=100", "--rom", "writable", "--out"])
            .arg(&out)
            .output()
            .expect("brdfgen");
        assert_eq!(run.status.code(), Some(2), "{method}");
        let message = String::from_utf8_lossy(&run.stderr).into_owned();
        assert!(message.contains("no coefficient memory"), "{message}");
        assert!(!out.exists());
    }
}

#[test]
fn the_choice_survives_toml_and_flags_and_is_described() {
    let generated = Generated::new("method = 'segmented-2'\nshininess = '1..=64'\nrom = 'writable'");
    let spec = &generated.design.spec;
    assert_eq!(spec.rom, RomStyle::Writable);
    assert_eq!(&resolved(&spec.to_toml()), spec);
    assert!(spec.command().contains("--rom writable"), "{}", spec.command());
    let names: Vec<String> = generated.design.ports().into_iter().map(|port| port.name).collect();
    let expected = [
        "clk",
        "rst",
        "ce",
        "in_valid",
        "in_n",
        "in_cos",
        "wr_scale_en",
        "wr_scale_addr",
        "wr_scale_data",
        "wr_en",
        "wr_addr",
        "wr_data",
        "out_valid",
        "out_spec",
    ];
    assert_eq!(names, expected);
    let manifest: serde_json::Value = serde_json::from_str(&generated.text("manifest.json")).expect("JSON");
    assert_eq!(manifest["loading"]["datapath"], generated.design.datapath_digest());
    assert_eq!(manifest["loading"]["memories"][1]["file"], "rom/segmented_2.mem");
    let sheet = generated.text("README.md");
    assert!(sheet.contains("### Loading") && sheet.contains("`wr_scale_en`, `wr_scale_addr`, `wr_scale_data`"));
    let plain = Generated::new("method = 'segmented-2'\nshininess = '1..=64'");
    assert!(!plain.text("README.md").contains("Loading") && !plain.text("manifest.json").contains("loading"));
}
