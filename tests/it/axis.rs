//! The wrapper with AXI4-Stream interfaces: it passes its benches and is proved, broken ones are found by both, linters
//! are silent.
//!
//! Needs iverilog, verilator, ghdl, yosys and Yices; `test.sh` installs them.

use std::process::Command;

use brdfgen::emit::package::{self, Part};
use brdfgen::spec::Language;
use brdfgen::verify::cosim::{self, Sim};
use brdfgen::verify::formal::{self, ProofStatus};
use rayon::prelude::*;

use crate::common::core::{Generated, OnDisk, silent};

/// The directory of a core with a fault in the wrapper.
fn broken(core: &Generated, language: Language, (what, from, to): Fault) -> OnDisk {
    let directory = core.on_disk();
    let file = Part::Axis.rtl_path(&core.design, language);
    let text = core.text(&file);
    assert_eq!(text.matches(from).count(), 1, "{what}: `{from}` in\n{text}");
    std::fs::write(directory.path().join(file), text.replace(from, to)).expect("written");
    directory
}

/// Lobes and shaders; one stage and many; ROM in the text, in a file and writable; `tuser` of one bit and of many.
const SPECS: &[&str] = &[
    "axi_stream = true\nmethod = 'quadratic'\nshininess = '1..=1000'",
    "axi_stream = true\ntuser_bits = 64\nmethod = 'cubic'\nshininess = '1..=64'\npipeline = 1\nrom = 'file'",
    "axi_stream = true\ntuser_bits = 40\nmethod = 'cubic'\nshininess = '1..=64'\nrom = 'writable'\noutput_fraction = \
     15",
    "axi_stream = true\ntuser_bits = 2\nmethod = 'schlick'\nshininess = [20]\noperand = 'versine'\ninput_fraction = 6",
    "axi_stream = true\ntuser_bits = 5\nblock = 'shader'\nmethod = 'quadratic'\nmaterial = \
     [{ name = 'a', shininess = 9 }]\n\
     [shader]\nmodel = 'blinn'\nchannel_bits = 10\nlight_colours = 'ports'",
];

#[test]
fn every_wrapper_passes_its_benches_lints_clean_and_is_proved() {
    SPECS.par_iter().for_each(|spec| {
        let core = Generated::new(spec);
        let directory = core.on_disk();
        let path = directory.path();
        for sim in [Sim::Icarus, Sim::Ghdl] {
            let outcome = cosim::around(sim, &directory.job()).expect("it runs").pop().expect("there is a wrapper");
            assert!(outcome.passed(), "{spec}\n{outcome:?}");
            assert_eq!(outcome.vectors, core.golden.vectors().len() as u64);
        }
        assert!(cosim::around(Sim::Builtin, &directory.job()).expect("an answer").is_empty());

        let name = &core.design.spec.name;
        let verilog = [format!("rtl/{name}.v"), format!("rtl/{name}_axis.v"), format!("tb/{name}_axis_tb.v")];
        let vhdl = [format!("rtl/{name}.vhd"), format!("rtl/{name}_axis.vhd"), format!("tb/{name}_axis_tb.vhd")];
        let work = directory.beside("work");
        std::fs::create_dir(&work).expect("a directory");
        let (workdir, out) = (format!("--workdir={}", work.display()), work.join("out").display().to_string());
        let top = format!("{name}_axis");
        silent(path, "verilator", &["--lint-only", "-Wall", "--top-module", &top, &verilog[0], &verilog[1]], spec);
        silent(path, "iverilog", &["-Wall", "-g2005", "-o", &out, &verilog[0], &verilog[1]], spec);
        silent(path, "iverilog", &["-Wall", "-g2005", "-o", &out, &verilog[0], &verilog[1], &verilog[2]], spec);
        silent(path, "ghdl", &["-a", "--std=08", &workdir, &vhdl[0], &vhdl[1], &vhdl[2]], spec);
        let script =
            format!("read_verilog {} {}; hierarchy -check -top {top}; proc; check -assert", verilog[0], verilog[1]);
        silent(path, "yosys", &["-q", "-p", &script], spec);
        for file in verilog[1..].iter().chain(&vhdl[1..]) {
            let text = core.text(file);
            assert!(text.is_ascii() && text.ends_with('\n') && !text.contains(['\t', '\r']), "{file} of {spec}");
            let long = text.lines().find(|line| line.len() > 100 || line.ends_with(' '));
            assert_eq!(long, None, "{file} of {spec}");
        }

        let proofs = formal::around(&core.design, &Part::of(&core.design), path, &|_| {}).expect("it runs");
        assert_eq!(proofs.len(), 2);
        assert!(proofs.iter().all(|proof| proof.verdict == ProofStatus::Proved), "{spec}\n{proofs:?}");
    });
}

/// Watches the wrapper's outputs from the first clock of its reset on, with inputs that are unknown until a beat is
/// offered.
const VERILOG_WATCH: &str = "
module watch;
    reg aclk = 1'b0, aresetn = 1'b0, valid = 1'b0, ready = 1'b1;
    integer i, unknown = 0, beats = 0;
    reg [IN-1:0] data;
    reg [USER-1:0] tag;
    wire tready, tvalid, tlast;
    wire [OUT-1:0] tdata;
    wire [USER-1:0] tuser;
    NAME_axis dut (.aclk(aclk), .aresetn(aresetn), .s_axis_tdata(data), .s_axis_tvalid(valid), .s_axis_tready(tready),
        .s_axis_tlast(valid ? 1'b1 : 1'bx), .s_axis_tuser(tag), WRITES
        .m_axis_tdata(tdata), .m_axis_tvalid(tvalid), .m_axis_tready(ready), .m_axis_tlast(tlast), \
        .m_axis_tuser(tuser));
    initial begin
        for (i = 0; i < 300; i = i + 1) begin
            aresetn = i >= 3;
            valid = i % 7 == 6;
            ready = i % 5 != 0;
            data = valid ? 0 : {IN{1'bx}};
            tag = valid ? 1 : {USER{1'bx}};
            #5;
            if (^{tready, tvalid, tlast, tdata, tuser} === 1'bx) unknown = unknown + 1;
            if (tvalid && ready) beats = beats + 1;
            aclk = 1'b1;
            #5 aclk = 1'b0;
        end
        $display(\"unknown at %0d clocks, %0d beats\", unknown, beats);
    end
endmodule
";

/// The same in VHDL.
const VHDL_WATCH: &str = "
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
entity watch is end entity;
architecture bench of watch is
    signal aclk, aresetn, valid, tlast_in, tready, tvalid, tlast : std_logic := '0';
    signal ready : std_logic := '1';
    signal data : std_logic_vector(IN - 1 downto 0) := (others => 'X');
    signal tag, tuser : std_logic_vector(USER - 1 downto 0) := (others => 'X');
    signal tdata : std_logic_vector(OUT - 1 downto 0);
begin
    dut : entity work.NAME_axis port map (
        aclk => aclk, aresetn => aresetn, s_axis_tdata => data, s_axis_tvalid => valid, s_axis_tready => tready,
        s_axis_tlast => tlast_in, s_axis_tuser => tag, WRITES
        m_axis_tdata => tdata, m_axis_tvalid => tvalid, m_axis_tready => ready, m_axis_tlast => tlast, m_axis_tuser => \
        tuser);
    process is
        variable unknown, beats : natural := 0;
    begin
        for i in 0 to 299 loop
            aresetn <= '1' when i >= 3 else '0';
            valid <= '1' when i mod 7 = 6 else '0';
            ready <= '0' when i mod 5 = 0 else '1';
            data <= (others => '0') when i mod 7 = 6 else (others => 'X');
            tlast_in <= '1' when i mod 7 = 6 else 'X';
            tag <= (others => '1') when i mod 7 = 6 else (others => 'X');
            wait for 5 ns;
            if is_x(tready & tvalid & tlast & tdata & tuser) then
                unknown := unknown + 1;
            end if;
            if tvalid = '1' and ready = '1' then
                beats := beats + 1;
            end if;
            aclk <= '1';
            wait for 5 ns;
            aclk <= '0';
        end loop;
        report \"unknown at \" & to_string(unknown) & \" clocks, \" & to_string(beats) & \" beats\";
        wait;
    end process;
end architecture;
";

#[test]
fn the_wrappers_outputs_are_known_from_reset_on() {
    // Many stages and one; `tuser` of many bits and of few; a memory that can be written.
    // A sample of one word each through a table of lights.
    let samples = "axi_stream = true\nblock = 'shader'\nmethod = 'schlick'\noutput_fraction = 10\ninput_fraction = 8\n\
                   material = [{ name = 'a', shininess = 9 }]\nlights_a_clock = 1\nlight_source = 'table'";
    let small = SMALL.replace("= 10", "= 7").replace("1..=64", "1..=8");
    let written =
        small.replace("tuser_bits = 3", "tuser_bits = 64\nrom = 'writable'").replace("pipeline = 4", "pipeline = 1");
    [small.as_str(), SPECS[3], &written, samples].par_iter().for_each(|spec| {
        let core = Generated::new(spec);
        let directory = core.on_disk();
        let path = directory.path();
        let axis = package::axis(&core.design).expect("a wrapper");
        let name = &core.design.spec.name;
        let watch = |text: &str, writes: [&str; 3]| {
            let ports = axis.memories.chunks(3).map(|ports| {
                let port = |(port, to): (&brdfgen::core::Port, &str)| to.replace("PORT", &port.name);
                ports.iter().zip(writes).map(port).collect::<String>()
            });
            text.replace("NAME", name)
                .replace("WRITES", &ports.collect::<String>())
                .replace("USER", &axis.tuser_bits.to_string())
                .replace("OUT", &axis.outputs.tdata_bits().to_string())
                .replace("IN", &axis.inputs.tdata_bits().to_string())
        };
        let said = |program: &str, arguments: &[String]| {
            let output = Command::new(program).current_dir(path).args(arguments).output().expect(program);
            let text =
                format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
            assert!(output.status.success(), "{program} on {spec}:\n{text}");
            text
        };
        let known = |text: &str| {
            let beats =
                text.split_once("unknown at 0 clocks, ").and_then(|(_, rest)| rest.split(' ').next()?.parse().ok());
            let beats: u32 = beats.unwrap_or_else(|| panic!("{spec}:\n{text}"));
            assert!((30..=45).contains(&beats), "{spec}:\n{text}");
        };

        let verilog = watch(VERILOG_WATCH, [".PORT(1'b0), ", ".PORT(0), ", ".PORT(0),"]);
        std::fs::write(path.join("watch.v"), verilog).expect("written");
        let texts = |language| Part::Axis.rtl_paths(&core.design, language);
        let with = |before: &[&str], language: Language, watch: &str| {
            let all = before.iter().map(|&word| word.to_owned()).chain(texts(language));
            all.chain([watch.to_owned()]).collect::<Vec<_>>()
        };
        let out = directory.beside("watch.vvp").display().to_string();
        said("iverilog", &with(&["-g2005", "-o", &out, "-s", "watch"], Language::Verilog, "watch.v"));
        known(&said("vvp", &["-n".to_owned(), out]));

        let vhdl = watch(VHDL_WATCH, ["PORT => '0', ", "PORT => (others => '0'), ", "PORT => (others => '0'),"]);
        std::fs::write(path.join("watch.vhd"), vhdl).expect("written");
        said("ghdl", &with(&["-a", "--std=08"], Language::Vhdl, "watch.vhd"));
        // What is unknown at the inputs is not the wrapper's.
        known(&said("ghdl", &["--elab-run", "--std=08", "watch", "--ieee-asserts=disable"].map(str::to_owned)));
    });
}

#[test]
fn the_wrapper_passes_in_verilator() {
    let core = Generated::new(SPECS[2]);
    let directory = core.on_disk();
    let outcome = cosim::around(Sim::Verilator, &directory.job()).expect("it runs").pop().expect("there is a wrapper");
    assert!(outcome.passed(), "{outcome:?}");
}

/// A fault: what it is, a text of the HDL, and what takes its place.
type Fault = (&'static str, &'static str, &'static str);

const SMALL: &str = "axi_stream = true\ntuser_bits = 3\nmethod = 'quadratic'\nshininess = '1..=64'\ninput_fraction = \
 10\n\
                     output_fraction = 10\npipeline = 4";

const VERILOG_FAULTS: &[Fault] = &[
    ("tlast a stage short", "        last[4],", "        last[3],"),
    ("tready always 1", "s_axis_tready = ready;", "s_axis_tready = 1'b1;"),
    ("output overwritten under back-pressure", "if (ready) skid <= beat;", "skid <= beat;"),
    ("skid register dropped", "skid_valid ? skid : out_valid", "out_valid"),
    ("skid register not shown", "skid_valid | out_valid;", "out_valid;"),
    ("tuser swapped", "m_axis_tuser = shown[14:12];", "m_axis_tuser = {shown[12], shown[13], shown[14]};"),
    ("tuser of the beat before", "        user[11:9],", "        user[8:6],"),
    ("ce stuck at 1", ".ce        (ready)", ".ce        (1'b1)"),
    ("tlast and tuser not held", "if (ready) begin\n            last", "begin\n            last"),
    ("reset ignored by the wrapper", "if (~aresetn) begin", "if (1'b0) begin"),
    ("reset ignored by the core", ".rst       (~aresetn)", ".rst       (1'b0)"),
    ("tready waits for the sink", "s_axis_tready = ready;", "s_axis_tready = ready & m_axis_tready;"),
    ("tvalid waits for the sink", "skid_valid | out_valid;", "(skid_valid | out_valid) & m_axis_tready;"),
    ("a bubble behind a stall", "ready <= ~waits;", "ready <= ~waits & ~skid_valid;"),
    ("every other clock only", "ready <= ~waits;", "ready <= ~waits & ~ready;"),
    ("in_valid stuck at 1", ".in_valid  (s_axis_tvalid)", ".in_valid  (1'b1)"),
    ("an operand in the wrong place", "(s_axis_tdata[18:7])", "(s_axis_tdata[19:8])"),
    ("padding that is not 0", "{5'd0, shown", "{5'd1, shown"),
];

const VHDL_FAULTS: &[Fault] = &[
    ("tlast a stage short", "& last(4)", "& last(3)"),
    ("tready always 1", "s_axis_tready <= ready;", "s_axis_tready <= '1';"),
    ("output overwritten", "if ready = '1' then\n                skid", "if true then\n                skid"),
    ("skid register dropped", "skid when skid_valid = '1' else\n             beat", "beat"),
    ("tuser swapped", "<= shown(14 downto 12);", "<= shown(12) & shown(13) & shown(14);"),
    ("ce stuck at 1", "ce        => ready", "ce        => '1'"),
    ("reset ignored by the wrapper", "if aresetn = '0' then", "if false then"),
    ("reset ignored by the core", "rst <= not aresetn;", "rst <= '0';"),
    ("a bubble behind a stall", "<= not waits;", "<= not waits and not skid_valid;"),
    ("an operand in the wrong place", "s_axis_tdata(18 downto 7)", "s_axis_tdata(19 downto 8)"),
];

#[test]
fn benches_find_broken_wrappers() {
    let core = Generated::new(SMALL);
    for (language, sim, faults) in
        [(Language::Verilog, Sim::Icarus, VERILOG_FAULTS), (Language::Vhdl, Sim::Ghdl, VHDL_FAULTS)]
    {
        faults.par_iter().for_each(|&fault| {
            let directory = broken(&core, language, fault);
            let outcome = cosim::around(sim, &directory.job()).expect("it runs").pop().expect("there is a wrapper");
            assert!(!outcome.passed() && !outcome.first[0].contains("compile"), "{language}, {}: {outcome:?}", fault.0);
        });
    }
}

#[test]
fn proofs_find_broken_wrappers() {
    let core = Generated::new(SMALL);
    for (language, faults) in [(Language::Verilog, VERILOG_FAULTS), (Language::Vhdl, VHDL_FAULTS)] {
        faults.par_iter().for_each(|&fault| {
            let directory = broken(&core, language, fault);
            let path = directory.path();
            let proofs = formal::around(&core.design, &Part::of(&core.design), path, &|_| {});
            // GHDL leaves out what has no use, so that the claims cannot be connected to it.
            let Ok(proofs) = proofs else {
                assert!(language == Language::Vhdl && fault.0 == "skid register dropped", "{}: {proofs:?}", fault.0);
                return;
            };
            for proof in &proofs {
                let expected = if proof.claim.contains(&language.to_string()) {
                    ProofStatus::Refuted
                } else {
                    ProofStatus::Proved
                };
                assert_eq!(proof.verdict, expected, "{}: {proof:?}", fault.0);
            }
        });
    }
}

/// What a core with a wrapper has more than one without: files, a section of the datasheet, a part of the manifest.
#[test]
fn the_packing_is_said_wherever_it_is_looked_for() {
    let core = Generated::new(SMALL);
    let plain = Generated::new(&SMALL.replace("axi_stream = true\ntuser_bits = 3\n", ""));
    assert_eq!(core.text("files.f"), "rtl/quadratic.v\nrtl/quadratic_axis.v\n");
    let more: Vec<&str> = core.files.iter().map(|file| file.path.as_str()).collect();
    let more: Vec<&&str> = more.iter().filter(|path| plain.files.iter().all(|file| file.path != **path)).collect();
    assert_eq!(
        more,
        [&"rtl/quadratic_axis.v", &"tb/quadratic_axis_tb.v", &"rtl/quadratic_axis.vhd", &"tb/quadratic_axis_tb.vhd"]
    );
    assert!(!plain.text("README.md").contains("axis") && !plain.text("manifest.json").contains("axi"));
    for line in ["| 6:0 | `in_n`, UQ7.0 |", "| 18:7 | `in_cos`, Q1.10 |", "| 23:19 | of no meaning |", "| 15:11 | 0 |"]
    {
        assert!(core.text("README.md").contains(line), "{line}\n{}", core.text("README.md"));
    }
    let manifest: serde_json::Value = serde_json::from_str(&core.text("manifest.json")).expect("JSON");
    assert_eq!(
        manifest["axi_stream"]["s_axis_tdata"],
        serde_json::json!({ "bits": 24, "fields": [
            { "port": "in_n", "low_bit": 0, "bits": 7 },
            { "port": "in_cos", "low_bit": 7, "bits": 12 },
        ] })
    );
    for path in ["rtl/quadratic_axis.v", "rtl/quadratic_axis.vhd"] {
        assert!(core.text(path).contains("  [18:7]  in_cos        Q1.10 cosine x;"), "{}", core.text(path));
    }
    // The core itself is the same but for the spec's digest and the command in its header.
    let body =
        |core: &Generated| core.text("rtl/quadratic.v").split_once("`timescale").map(|(_, body)| body.to_owned());
    assert_eq!(body(&core), body(&plain));
}
