//! The generated HDL in external simulators: right cores pass, broken ones fail, linters are silent.
//!
//! Needs iverilog, verilator, ghdl and yosys; `test.sh` installs them.

use brdfgen::emit::package;
use brdfgen::spec::Language;
use brdfgen::verify::cosim::{self, Job, Sim};
use rayon::prelude::*;

use crate::common;
use crate::common::core::{Generated, OnDisk, ecp5_cells, silent};

/// Specs that reach every construct of the templates.
const SPECS: &[&str] = &[
    "method = 'quadratic'\nshininess = '1..=1000'",
    "method = 'cubic'\nshininess = '1..=1000'",
    "method = 'quadratic'\nform = 'paper'\nshininess = '1..=1000'",
    "method = 'cubic'\nform = 'paper'\nshininess = '1..=1000'",
    "method = 'quadratic'\nshininess = '1..=100'\noperand = 'versine'",
    "method = 'cubic'\nshininess = '1..=100'\noperand = 'versine'\noutput_fraction = 10",
    // Signed coefficients, and results that must be clamped to [0, 1].
    "method = 'cubic'\nshininess = [1.1, 1.5, 1.9, 2, 2.5]",
    "method = 'cubic'\nform = 'paper'\nshininess = [1.1, 1.5, 1.9, 2, 2.5]",
    "method = 'cubic'\nshininess = [1.001, 1.5]\nq = 0.05",
    // One row: no shifter, one-bit fields.
    "method = 'quadratic'\nshininess = [50]",
    "method = 'cubic'\nshininess = [50]",
    "method = 'quadratic'\nshininess = [1]",
    "method = 'cubic'\nshininess = [1]",
    "method = 'cubic'\nshininess = [2]",
    // A wired shift beside a ROM one, a clamped address, materials.
    "method = 'quadratic'\nshininess = '900..=1000'",
    "method = 'cubic'\nmaterial = [{ name = 'gold', shininess = 51.2 }, { name = 'plastic', shininess = 32 }]\nrom = \
     'file'",
    "method = 'quadratic'\nshininess = '1..=1000'\nrom = 'file'",
    // A ROM file without comments.
    "method = 'quadratic'\nshininess = '1..=20'\nrom = 'file'\nrom_formats = ['mem-plain']",
    // A wired shift that leaves of the versine less than a bit, or nothing.
    "method = 'cubic'\nshininess = '512..=1000'\ninput_fraction = 8\noutput_fraction = 8",
    "method = 'quadratic'\nshininess = '1000..=1000'\ninput_fraction = 8\noutput_fraction = 8",
    "method = 'cubic'\nshininess = [1000000]\ninput_fraction = 4\noutput_fraction = 4",
    // Pipelines from one register to many.
    "method = 'quadratic'\nshininess = '1..=64'\npipeline = 1",
    "method = 'quadratic'\nshininess = '1..=64'\npipeline = 2",
    "method = 'cubic'\nshininess = '1..=64'\npipeline = 3",
    "method = 'cubic'\nshininess = '1..=64'\npipeline = 1\nrom = 'file'",
    "method = 'cubic'\nshininess = '1..=64'\npipeline = 14",
    "method = 'cubic'\nform = 'paper'\nshininess = '1..=64'\npipeline = 12",
    // Narrow and wide.
    "method = 'quadratic'\nshininess = '1..=60'\ninput_fraction = 24\noutput_fraction = 20",
    "method = 'cubic'\nshininess = '1..=300'\ninput_fraction = 4\noutput_fraction = 4",
    "method = 'cubic'\nshininess = '1..=100'\ninput_fraction = 8\noutput_fraction = 20",
    "method = 'cubic'\nform = 'paper'\nshininess = [3.5, 900000]\ninput_fraction = 18\noutput_fraction = 12",
    // Powers, n from the port and a core without a ROM, coefficients between two rows, a held tail.
    "method = 'power-4'\nshininess = '1..=200'",
    "method = 'power-8'\ninside = 'linear'\nshininess = [1, 2.5, 8, 300]\noperand = 'versine'\ninput_fraction = 12",
    "method = 'lyon-4'\nshininess = '1..=1000'",
    "method = 'lyon-8'\nshininess = '5..=40'\nshininess_fraction = 3\noperand = 'versine'\noutput_fraction = 10",
    "method = 'lyon-2'\nshininess = [2.5]\nrom = 'file'\npipeline = 9",
    "method = 'lyon-2'\nshininess = '3..=9'\nrom = 'file'\npipeline = 1",
    "method = 'cubic-min-zero'\nshininess = '2..=90'\nshininess_fraction = 4\ninput_fraction = 18",
    "method = 'cubic'\ntail = 'hold'\nshininess = '1..=100'",
    "method = 'cubic-three-point'\ntail = 'hold'\nshininess = [1.2, 2.5, 70]\ninput_fraction = 9\noutput_fraction = 11",
    "method = 'cubic'\ncoefficients = 'minimax'\nshininess = '1..=64'\nshininess_fraction = 2\npipeline = 5",
    // The power with constants in its tables, with slopes of a few bits, with multipliers; n = 1 by a way of its own or
    // not.
    "method = 'log-exp'\naccuracy = 4\nshininess = '1..=1000'",
    "method = 'log-exp'\naccuracy = 9\nshininess = '1..=300'\ninput_fraction = 14\noutput_fraction = 12",
    "method = 'log-exp'\naccuracy = 12\nshininess = [1, 2.5, 640]\noperand = 'versine'\nmemory = 'block'\nrom = 'file'",
    "method = 'log-exp'\naccuracy = 6\nshininess = '2..=40'\nshininess_fraction = 3\ninput_fraction = 10\npipeline = 1",
    // Baselines: powers selected from a chain.
    "method = 'squaring'\nshininess = [1, 2, 8, 16, 64, 512]",
    "method = 'harris'\nshininess = '1..=200'\nlog_bits = 4\nexp_bits = 5\ninput_fraction = 12",
    "method = 'harris'\nshininess = [1, 2.5, 900]\nlog_bits = 3\nexp_bits = 6\noperand = 'versine'\nrom = 'file'",
    "method = 'table'\nshininess = '3..=40'\ntable_bits = 5\noutput_fraction = 9",
    "method = 'table'\nshininess = [20]\ntable_bits = 6\noperand = 'versine'\nrom = 'file'\npipeline = 1",
    "method = 'squaring'\nshininess = [32]\noperand = 'versine'\ninput_fraction = 10\npipeline = 2",
];

#[test]
fn every_construct_passes_in_icarus_and_ghdl_and_lints_clean() {
    SPECS.par_iter().enumerate().for_each(|(place, spec)| {
        let core = OnDisk::new(spec);
        // The VHDL of the others is analysed below, and run with `./test.sh --all`.
        let ghdl = (common::all() || place % 2 == 0).then_some(Sim::Ghdl);
        for sim in [Sim::Builtin, Sim::Icarus].into_iter().chain(ghdl) {
            let outcome = core.run(sim);
            assert!(outcome.passed(), "{spec}\n{outcome:?}");
            assert_eq!(outcome.vectors, core.golden.vectors().len() as u64);
        }
        let name = &core.design.spec.name;
        let (verilog, vhdl) = (format!("rtl/{name}.v"), format!("rtl/{name}.vhd"));
        let (bench, vhdl_bench) = (format!("tb/{name}_tb.v"), format!("tb/{name}_tb.vhd"));
        let work = core.beside("work");
        std::fs::create_dir(&work).expect("a directory");
        let workdir = format!("--workdir={}", work.display());
        let out = work.join("out").display().to_string();
        let path = core.path();
        silent(path, "verilator", &["--lint-only", "-Wall", &verilog], spec);
        silent(path, "iverilog", &["-Wall", "-g2005", "-o", &out, &verilog], spec);
        silent(path, "iverilog", &["-Wall", "-g2005", "-o", &out, &verilog, &bench], spec);
        silent(path, "ghdl", &["-a", "--std=08", &workdir, &vhdl, &vhdl_bench], spec);
        for file in [verilog, vhdl, bench, vhdl_bench] {
            let text = std::fs::read_to_string(path.join(&file)).expect("text");
            assert!(text.is_ascii() && text.ends_with('\n') && !text.contains(['\t', '\r']), "{file} of {spec}");
            let long = text.lines().find(|line| line.len() > 100 || line.ends_with(' '));
            assert_eq!(long, None, "{file} of {spec}");
        }
    });
}

#[test]
fn the_bench_passes_in_verilator() {
    for spec in [SPECS[4], SPECS[6]] {
        let outcome = OnDisk::new(spec).run(Sim::Verilator);
        assert!(outcome.passed(), "{spec}\n{outcome:?}");
    }
}

/// A fault: a text of the HDL, and what takes its place.
type Fault = (&'static str, &'static str, &'static str);

/// Coefficient, rounding, pipeline, clock enable, reset, saturation, flags: one fault each.
const VERILOG_FAULTS: &[Fault] = &[
    ("last bit of a coefficient", "10'd33: rom_1 <= 22'h32ee65;", "10'd33: rom_1 <= 22'h32ee75;"),
    ("first bit of a coefficient", "10'd500: rom_1 <= 22'h3", "10'd500: rom_1 <= 22'h1"),
    ("a row read from its neighbour", "case (in_n)", "case (in_n ^ 10'd1)"),
    ("result rounded up", "y_exact_7[18:2];", "y_exact_7[18:2] + {16'd0, |y_exact_7[1:0]};"),
    ("product rounded up", "xp_6[32:15];", "xp_6[32:15] + {17'd0, xp_6[14]};"),
    ("p rounded to nearest", "av_5[32:16];", "av_5[32:16] + {16'd0, av_5[15]};"),
    ("a missing pipeline register", "x_6 * p_6", "x_5 * p_6"),
    ("a missing register of a flag", "beyond_6 | p_above_bits_6", "beyond_5 | p_above_bits_6"),
    (
        "an additional register",
        "assign out_valid = valid[8];",
        "reg late; always @(posedge clk) if (ce) late <= valid[8]; assign out_valid = late;",
    ),
    ("valid a clock early", "assign out_valid = valid[8];", "assign out_valid = valid[7];"),
    ("ce ignored by the valid chain", "end else if (ce) begin", "end else begin"),
    (
        "ce ignored by the result",
        "        if (ce) begin\n            y_8 <= y_7;",
        "        begin\n            y_8 <= y_7;",
    ),
    (
        "ce ignored by an early register",
        "        if (ce) begin\n            x_2 <= x_1;",
        "        begin\n            x_2 <= x_1;",
    ),
    (
        "ce ignored by the ROM",
        "        if (ce) begin\n            case (in_n)",
        "        begin\n            case (in_n)",
    ),
    ("reset ignored", "if (rst) begin", "if (1'b0) begin"),
    ("reset gated by ce", "if (rst) begin", "if (rst && ce) begin"),
    ("negative cosines not stopped", "in_cos[17] ? 17'h00000 :", "1'b0 ? 17'h00000 :"),
    ("cosines above 1 not saturated", "(|in_cos[16]) ? 17'h10000 :", "1'b0 ? 17'h10000 :"),
    ("versine off by an ulp", "17'h10000 - x_0", "17'h0ffff - x_0"),
    ("shift off by one", "<< k_3", "<< (k_3 + 4'd1)"),
    ("one flag lost", "beyond_6 | p_above_bits_6", "p_above_bits_6"),
    ("other flag lost", "beyond_6 | p_above_bits_6", "beyond_6"),
    ("operands swapped", "{x_7, 2'd0} - {1'd0, t_7}", "{1'd0, t_7} - {x_7, 2'd0}"),
    ("a stuck bit", "assign out_spec  = y_8;", "assign out_spec  = y_8 | 17'd1;"),
    ("an unknown bit", "assign out_spec  = y_8;", "assign out_spec  = {y_8[16:1], 1'bx};"),
];

const VHDL_FAULTS: &[Fault] = &[
    ("last bit of a coefficient", "33 => x\"32ee65\"", "33 => x\"32ee75\""),
    ("result rounded up", "y_exact_7(18 downto 2);", "y_exact_7(18 downto 2) + 1;"),
    ("a missing pipeline register", "x_6 * p_6", "x_5 * p_6"),
    ("valid a clock early", "out_valid <= valid(8);", "out_valid <= valid(7);"),
    ("ce ignored by the valid chain", "elsif ce = '1' then", "else"),
    ("reset ignored", "if rst = '1' then", "if false then"),
    ("reset gated by ce", "if rst = '1' then", "if rst = '1' and ce = '1' then"),
    ("negative cosines not stopped", "(others => '0') when in_cos(17) = '1' else", "(others => '0') when false else"),
    ("one flag lost", "beyond_6 or p_above_bits_6", "p_above_bits_6"),
    ("an unknown result", "out_spec  <= y_8;", "out_spec  <= (others => 'X');"),
];

/// The same of a core that ends in a power, with a threshold and signed coefficients.
const POWER: &str = "method = 'power-4'\nshininess = '1..=1000'";

const POWER_VERILOG_FAULTS: &[Fault] = &[
    ("last bit of a", "10'd33: rom_1 <= 58'h203fe8588c42e9e;", "10'd33: rom_1 <= 58'h203fe8588d42e9e;"),
    ("last bit of A", "10'd33: rom_1 <= 58'h203fe8588c42e9e;", "10'd33: rom_1 <= 58'h203fec588c42e9e;"),
    ("last bit of the cut", "10'd33: rom_1 <= 58'h203fe8588c42e9e;", "10'd33: rom_1 <= 58'h203fe8588c42e9f;"),
    ("a without its sign", "$signed(a_5) * $signed(v_signed_low", "$signed({1'b0, a_5[16:0]}) * $signed(v_signed_low"),
    ("shift off by one", "<< k_3", "<< (k_3 + 4'd1)"),
    ("cut an ulp early", "u_3 > {1'd0, cut_3}", "u_3 >= {1'd0, cut_3}"),
    ("difference swapped", "big_a_6 - r_6", "r_6 - big_a_6"),
    ("a missing register of the versine", "v_8 * q_low_8", "v_7 * q_low_8"),
    ("a missing register of the square", "w2_cut_low_14 * w2_cut_low_14", "w2_cut_low_14 * w2_cut_low_13"),
    ("square rounded up", "w2_12[40:21];", "w2_12[40:21] + {19'd0, w2_12[20]};"),
    ("a part of a product lost", "{2'd0, vq_low_9} + {vq_high_9, 18'd0}", "{2'd0, vq_low_9}"),
    ("a part of a product a clock early", "vq_high_9 <= vq_high_8;", "vq_high_9 <= v_7 * q_high_7;"),
    ("the mixed products of a square once", "{2'd0, w2_twice_12, 19'd0}", "{3'd0, w2_twice_12, 18'd0}"),
    ("result cut, not rounded", "39'h0000200000", "39'h0000000000"),
    ("the cut's flag lost", "past_cut_9 | p_above_9", "p_above_9"),
];

const POWER_VHDL_FAULTS: &[Fault] = &[
    ("last bit of A", "33 => x\"203fe85\"", "33 => x\"203fec5\""),
    ("a missing register of the square", "w2_cut_low_14 * w2_cut_low_14", "w2_cut_low_14 * w2_cut_low_13"),
    ("the cut's flag lost", "past_cut_9 or p_above_9", "p_above_9"),
];

/// The golden vectors notice each fault, in every simulator that reads the language.
#[test]
fn broken_cores_fail() {
    assert_faults_are_noticed(SPECS[0], VERILOG_FAULTS, VHDL_FAULTS);
    assert_faults_are_noticed(POWER, POWER_VERILOG_FAULTS, POWER_VHDL_FAULTS);
}

fn assert_faults_are_noticed(spec: &str, verilog: &[Fault], vhdl: &[Fault]) {
    let right = Generated::new(spec);
    for (language, sim, faults) in [(Language::Verilog, Sim::Icarus, verilog), (Language::Vhdl, Sim::Ghdl, vhdl)] {
        faults.par_iter().for_each(|&fault| {
            let what = fault.0;
            let outcome = right.with_fault(language, fault).run(sim);
            assert!(!outcome.passed(), "{what} goes unnoticed: {outcome:?}");
            assert!(outcome.vectors > 0, "{what}: the bench did not run: {outcome:?}");
            let place = outcome.first.first().expect("a difference");
            assert!(place.contains("expected") || place.contains("out_valid"), "{what}: where? {place}");
        });
    }
}

/// The same core in rust-hdl's Verilog, under the bench of the template's.
#[cfg(feature = "kernel")]
#[test]
fn the_kernels_verilog_passes_the_same_bench() {
    use brdfgen::verify::kernel;
    for method in ["quadratic", "cubic"] {
        for (bits, set) in [(16, "1..=1000"), (12, "1..=256"), (8, "1..=64")] {
            let core = OnDisk::new(&format!(
                "method = '{method}'\nshininess = '{set}'\ninput_fraction = {bits}\noutput_fraction = {bits}"
            ));
            let kernel = kernel::of_design(&core.design).expect("a kernel of these widths");
            assert_eq!(kernel.latency(), core.design.schedule.latency);
            let wrapper = format!(
                "`timescale 1ns / 1ps\nmodule {method} (input wire clk, input wire rst, input wire ce, input wire \
                 in_valid,\n\
                 input wire [{}:0] in_n, input wire [{}:0] in_cos, output wire out_valid, output wire [{}:0] \
                 out_spec);\n\
                 top core (.clock(clk), .rst(rst), .ce(ce), .in_valid(in_valid), .in_n(in_n), .in_cos(in_cos),\n\
                 .out_valid(out_valid), .out_spec(out_spec));\nendmodule\n",
                core.design.lobe().index_format().width() - 1,
                core.design.lobe().operand_format().width() - 1,
                core.design.lobe().output_format().width() - 1,
            );
            std::fs::write(core.rtl(Language::Verilog), wrapper + &kernel.verilog()).expect("written");
            let outcome = core.run(Sim::Icarus);
            assert!(outcome.passed(), "{method} {bits}: {outcome:?}");
        }
    }
}

#[test]
fn a_simulator_is_not_believed_on_its_word() {
    let core = OnDisk::new("method = 'quadratic'\nshininess = [3, 9]\ninput_fraction = 8\noutput_fraction = 8");
    let bench = core.path().join(package::bench_path(&core.design, Language::Verilog));
    for (what, text) in [
        ("no verdict", "module quadratic_tb; initial $display(\"all good\"); endmodule"),
        (
            "no vectors",
            "module quadratic_tb; initial $display(\"brdfgen: quadratic: 0 vectors compared, 0 mismatches: PASS\"); \
             endmodule",
        ),
        (
            "too few",
            "module quadratic_tb; initial $display(\"brdfgen: quadratic: 7 vectors compared, 0 mismatches: PASS\"); \
             endmodule",
        ),
        ("does not compile", "module quadratic_tb; initial $display(; endmodule"),
    ] {
        std::fs::write(&bench, text).expect("written");
        assert!(!core.run(Sim::Icarus).passed(), "{what}");
    }
}

#[test]
fn a_missing_or_cut_golden_file_fails_in_every_bench() {
    let spec = "method = 'quadratic'\nshininess = [3, 9]\ninput_fraction = 8\noutput_fraction = 8";
    for sim in [Sim::Icarus, Sim::Ghdl] {
        let core = OnDisk::new(spec);
        let file = core.path().join(package::golden_path(&core.design));
        let text = std::fs::read_to_string(&file).expect("vectors");
        let cut: String = text.lines().take(60).map(|line| format!("{line}\n")).collect();
        std::fs::write(&file, cut).expect("written");
        assert!(!core.run(sim).passed(), "{sim:?}: cut");
        std::fs::write(&file, "").expect("written");
        assert!(!core.run(sim).passed(), "{sim:?}: empty");
        std::fs::remove_file(&file).expect("removed");
        assert!(!core.run(sim).passed(), "{sim:?}: missing");
    }
}

/// Every input through Verilator, in both languages; and a fault that only one input of 2^18 shows.
/// What an editor or a check-out does to the vectors changes none of them.
#[test]
fn vectors_with_a_byte_order_mark_and_cr_lf_are_read_by_every_bench() {
    let core = OnDisk::new("method = 'quadratic'\nshininess = '1..=20'\ninput_fraction = 8\noutput_fraction = 8");
    let path = core.path().join(package::golden_path(&core.design));
    let text = std::fs::read_to_string(&path).expect("the vectors");
    // Without comments the count is what the mark stands before.
    let bare: String = text.lines().filter(|line| !line.starts_with('#')).map(|line| format!("{line}\n")).collect();
    for text in [text, bare] {
        for changed in
            [format!("\u{feff}{text}"), text.replace('\n', "\r\n"), format!("\u{feff}{text}").replace('\n', "\r\n")]
        {
            std::fs::write(&path, changed).expect("written");
            for sim in [Sim::Icarus, Sim::Ghdl] {
                let outcome = core.run(sim);
                assert!(outcome.passed(), "{sim:?}: {outcome:?}");
            }
        }
    }
}

#[test]
fn exhaustive_runs_compare_every_input() {
    let core = OnDisk::new("method = 'cubic'\nshininess = '1..=100'\ninput_fraction = 10\noutput_fraction = 12");
    let path = core.path();
    let job = Job { design: &core.design, golden: &core.golden, directory: path };
    for language in [Language::Verilog, Language::Vhdl] {
        let outcome = cosim::exhaustive(job.design.lobe(), job.directory, language, &|_, _| {}).expect("it runs");
        assert!(outcome.passed() && outcome.vectors == 100 << 12, "{outcome:?}");
    }
    let with_file =
        OnDisk::new("method = 'quadratic'\nshininess = '2..=9'\ninput_fraction = 7\noutput_fraction = 7\nrom = 'file'");
    let with_file_path = with_file.path();
    let file_job = Job { design: &with_file.design, golden: &with_file.golden, directory: with_file_path };
    for language in [Language::Verilog, Language::Vhdl] {
        let outcome =
            cosim::exhaustive(file_job.design.lobe(), file_job.directory, language, &|_, _| {}).expect("it runs");
        assert!(outcome.passed() && outcome.vectors == 8 << 9, "{outcome:?}");
    }
    let file = core.rtl(Language::Verilog);
    let text = std::fs::read_to_string(&file).expect("HDL");
    let output = text.lines().find(|line| line.contains("assign out_spec")).expect("the output");
    let faulty = "reg [9:0] hit; always @(posedge clk) hit <= {hit[8:0], in_n == 7'd77 && in_cos == 12'd1001};\n";
    let faulty = format!(
        "{faulty}{}",
        output.replace(';', &format!(" ^ {{12'd0, hit[{}]}};", core.design.schedule.latency - 1))
    );
    std::fs::write(&file, text.replace(output, &faulty)).expect("written");
    let outcome = cosim::exhaustive(job.design.lobe(), job.directory, Language::Verilog, &|_, _| {}).expect("it runs");
    std::fs::write(core.rtl(Language::Vhdl), "entity cubic is").expect("written");
    let broken = cosim::exhaustive(job.design.lobe(), job.directory, Language::Vhdl, &|_, _| {}).expect("an outcome");
    assert!(!broken.passed() && broken.first[0].contains("does not compile"), "{broken:?}");
    assert!(outcome.mismatches == 1 && outcome.first[0].contains("in_n 77, operand 1001"), "{outcome:?}");
}

/// Yosys infers DSP blocks and block RAM from the Verilog: the multipliers of up to 18 bits take one each.
#[test]
fn yosys_infers_dsp_blocks_and_block_ram() {
    for (spec, name, least_dsp, most_dsp) in [(SPECS[0], "quadratic", 2, 2), (SPECS[1], "cubic", 3, 4)] {
        let core = OnDisk::new(spec);
        for source in core.as_verilog() {
            let count = ecp5_cells(&source, name);
            let (dsp, ram) = (count("MULT18X18D"), count("DP16KD"));
            println!(
                "{name} {}: LUT4 {} FF {} DSP {dsp} BRAM {ram}",
                source.display(),
                count("LUT4"),
                count("TRELLIS_FF")
            );
            assert!((least_dsp..=most_dsp).contains(&dsp), "{name}: {dsp} DSP blocks");
            assert!((1..=4).contains(&ram), "{name}: {ram} block RAMs");
        }
    }
}
