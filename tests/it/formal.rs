//! The proof that the texts of a core are the same circuit: it goes through for what the generator writes, and for no
//! text with a fault.
//!
//! Needs ghdl and yosys with yosys-abc; `test.sh` installs them.

use std::sync::Mutex;

use brdfgen::spec::Language;
use brdfgen::verify::formal::{self, Proof, ProofStatus, Step};
use rayon::prelude::*;

use crate::common::Scratch;
use crate::common::core::Generated;

/// A fault: a language, a text of its HDL, and what takes its place.
type Fault = (Language, &'static str, &'static str);

/// What is proved of a core, with faults in its texts.
fn proofs_of(core: &Generated, faults: &[Fault]) -> Vec<Proof> {
    let directory = core.on_disk();
    for (language, from, to) in faults {
        let file = directory.rtl(*language);
        let text = std::fs::read_to_string(&file).expect("text");
        assert_eq!(text.matches(from).count(), 1, "`{from}` in\n{text}");
        std::fs::write(file, text.replace(from, to)).expect("written");
    }
    // Each claim is told of before and after it is looked at.
    let told = Mutex::new(Vec::new());
    let tell = |step: Step| match step {
        Step::Begun(claim) => told.lock().expect("whole").push(claim.to_owned()),
        Step::Ended(proof) => assert_eq!(told.lock().expect("whole").last(), Some(&proof.claim)),
    };
    let proofs = formal::equivalence(&core.design, directory.path(), &core.golden, 60, &tell).expect("the tools work");
    assert_eq!(told.into_inner().expect("whole").len(), proofs.len());
    proofs
}

/// The verdict on the claim that begins so.
fn of(proofs: &[Proof], claim: &str) -> ProofStatus {
    proofs.iter().find(|proof| proof.claim.starts_with(claim)).unwrap_or_else(|| panic!("{claim}: {proofs:?}")).verdict
}

const CUBIC: &str = "method = 'cubic'\nshininess = '1..=16'\ninput_fraction = 8\noutput_fraction = 8\npipeline = 4";
const WRITABLE: &str =
    "method = 'cubic-min-zero'\nshininess = '1..=16'\ninput_fraction = 8\noutput_fraction = 8\nrom = 'writable'";
/// With a rust-hdl kernel.
const KERNEL: &str = "method = 'quadratic'\nshininess = '1..=1000'";

#[test]
fn what_the_generator_writes_is_proved() {
    let specs = [
        (CUBIC, 3),
        (WRITABLE, 3),
        (KERNEL, 3 + 2 * usize::from(cfg!(feature = "kernel"))),
        ("method = 'quadratic'\nshininess = '1..=16'\ninput_fraction = 8\noutput_fraction = 8\nrom = 'file'", 3),
        // Its VHDL has constants of more than 32 bits.
        (
            "block = 'shader'\nmethod = 'quadratic'\nmaterial = [{ name = 'a', shininess = 9 }]\n[shader]\nmodel = \
             'blinn'",
            3,
        ),
    ];
    specs.par_iter().for_each(|(spec, claims)| {
        let proofs = proofs_of(&Generated::new(spec), &[]);
        assert!(proofs.len() >= *claims, "{spec}: {proofs:?}");
        assert!(proofs.iter().all(|proof| proof.verdict == ProofStatus::Proved), "{spec}: {proofs:?}");
    });
}

#[test]
fn another_function_in_one_text_is_refuted() {
    let core = Generated::new(CUBIC);
    let faults: &[Fault] = &[
        // A bit of a word of the ROM: in the threshold, in the shift.
        (Language::Verilog, "30'h3df5332f;", "30'h3df5332e;"),
        (Language::Vhdl, "x\"3df5332f\"", "x\"3df5322f\""),
        // Rounded to nearest instead of down.
        (Language::Verilog, "p_2 = vq_2[17:8];", "p_2 = vq_2[17:8] + {9'd0, vq_2[7]};"),
        (Language::Vhdl, "p_2 <= vq_2(17 downto 8);", "p_2 <= vq_2(17 downto 8) + vq_2(7 downto 7);"),
        // Wrong where the versine is the threshold only.
        (Language::Verilog, "u_1 > {1'd0, cut_1}", "u_1 >= {1'd0, cut_1}"),
        (Language::Vhdl, "u_1 > cut_1", "u_1 >= cut_1"),
        // Wrong for one result.
        (Language::Verilog, "out_spec  = y_4;", "out_spec  = y_4 ^ (y_4 == 9'd77);"),
    ];
    faults.par_iter().for_each(|fault| {
        let proofs = proofs_of(&core, &[*fault]);
        assert_eq!(of(&proofs, "Verilog = VHDL"), ProofStatus::Refuted, "{fault:?}: {proofs:?}");
    });
}

#[test]
fn a_text_that_is_no_pipeline_is_refuted() {
    let core = Generated::new(CUBIC);
    let faults: &[Fault] = &[
        // A register is dropped.
        (Language::Verilog, "x_2 <= x_1;", "x_2 <= x_0;"),
        (Language::Vhdl, "x_2 <= x_1;", "x_2 <= x_0;"),
        // ce is ignored.
        (Language::Verilog, "if (ce) begin\n            y_4", "if (1'b1) begin\n            y_4"),
        (Language::Vhdl, "if ce = '1' then\n                y_4", "if true then\n                y_4"),
        // rst is ignored.
        (Language::Verilog, "if (rst) begin", "if (1'b0) begin"),
        (Language::Vhdl, "if rst = '1' then", "if false then"),
        // The valid chain is short.
        (Language::Verilog, "out_valid = valid[4];", "out_valid = valid[3];"),
        (Language::Vhdl, "out_valid <= valid(4);", "out_valid <= valid(3);"),
    ];
    faults.par_iter().for_each(|fault| {
        let proofs = proofs_of(&core, &[*fault]);
        let claim = format!("{} is a pipeline", fault.0);
        assert_eq!(of(&proofs, &claim), ProofStatus::Refuted, "{fault:?}: {proofs:?}");
        assert!(!proofs.iter().any(|proof| proof.claim == "Verilog = VHDL"), "{fault:?}: {proofs:?}");
    });
}

#[test]
fn the_same_fault_in_both_texts_is_another_core() {
    let both =
        [(Language::Verilog, "30'h3df5332f;", "30'h3df5332e;"), (Language::Vhdl, "x\"3df5332f\"", "x\"3df5332e\"")];
    let proofs = proofs_of(&Generated::new(CUBIC), &both);
    assert_eq!(of(&proofs, "Verilog = VHDL"), ProofStatus::Proved, "{proofs:?}");
    for language in [Language::Verilog, Language::Vhdl] {
        assert_eq!(of(&proofs, &format!("{language} is a pipeline")), ProofStatus::Refuted, "{proofs:?}");
    }
}

#[test]
fn a_memory_that_is_written_otherwise_is_refuted() {
    let core = Generated::new(WRITABLE);
    let faults: &[Fault] = &[
        (Language::Verilog, "if (wr_en) rom", "if (1'b1) rom"),
        (Language::Verilog, "rom[wr_addr] <= wr_data;", "rom[wr_addr] <= wr_data ^ 1'b1;"),
        (Language::Verilog, "rom[wr_addr] <=", "rom[~wr_addr] <="),
        (Language::Vhdl, "if wr_en = '1' then", "if wr_en = '0' then"),
        (Language::Vhdl, "rom(to_integer(wr_addr)) <=", "rom(to_integer(not wr_addr)) <="),
    ];
    faults.par_iter().for_each(|fault| {
        let proofs = proofs_of(&core, &[*fault]);
        assert_eq!(of(&proofs, "Verilog = VHDL"), ProofStatus::Refuted, "{fault:?}: {proofs:?}");
    });
}

#[cfg(feature = "kernel")]
#[test]
fn a_fault_is_found_in_comparison_with_the_kernel() {
    // Wrong for one result.
    let fault = (Language::Verilog, "out_spec  = y_8;", "out_spec  = y_8 ^ (y_8 == 17'd7777);");
    let proofs = proofs_of(&Generated::new(KERNEL), &[fault]);
    assert_eq!(of(&proofs, "Verilog = rust-hdl"), ProofStatus::Refuted, "{proofs:?}");
    assert_eq!(of(&proofs, "Verilog = VHDL"), ProofStatus::Refuted, "{proofs:?}");
}

#[test]
fn the_command_says_each_claim_and_ends_with_the_verdict() {
    let scratch = Scratch::new();
    let generate =
        "generate --method cubic --shininess 1..=16 --input-fraction 8 --output-fraction 8 --pipeline 4 --out core";
    scratch.run(generate).ends_with(0);
    let run = scratch.run("formal core").ends_with(0);
    assert_eq!(run.stdout.matches("PROVED").count(), 3, "{}", run.stdout);
    let file = scratch.path("core/rtl/cubic.v");
    let text = std::fs::read_to_string(&file).expect("text");
    std::fs::write(&file, text.replace("u_1 > {1'd0, cut_1}", "u_1 >= {1'd0, cut_1}")).expect("written");
    let run = scratch.run("formal core --allow-open").ends_with(1);
    assert!(run.stdout.contains("REFUTED Verilog = VHDL"), "{}", run.stdout);
}
