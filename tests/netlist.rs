//! The netlist that `synth` makes of a core for ECP5, with registers moved into its blocks, runs the core's golden vectors; a netlist with
//! a mistake does not.
//!
//! Needs pyosys and iverilog; `test.sh` installs them.

mod common;

use brdfgen::cosim::{self, Job};
use brdfgen::design::{Account, Design};
use brdfgen::golden::Golden;
use brdfgen::package;
use brdfgen::spec::SpecFields;
use brdfgen::synth::{self, Family, Options};
use common::Scratch;

/// Multipliers, one-clock tables in logic, carry chains.
const LOGIC: &str = "method = \"quadratic\"\nshininess = \"1,5,20\"\ninput_fraction = 8\noutput_fraction = 8\n";
/// The coefficients in a block RAM.
const BLOCK: &str = "method = \"quadratic\"\nshininess = \"1..=255\"\ninput_fraction = 10\noutput_fraction = 8\n";

/// A generated core and its netlist.
struct Core {
    scratch: Scratch,
    design: Design,
    golden: Golden,
    netlist: String,
}

impl Core {
    fn new(spec: &str) -> Self {
        let design = SpecFields::parse(spec, "test").and_then(SpecFields::resolve).and_then(Design::new).expect(spec);
        let golden = Golden::of(&design);
        let scratch = Scratch::new();
        let files = package::files(&design, &Account::of(&design), &golden).expect("files");
        package::write_directory(&scratch.path("core"), &files).expect("written");
        let netlist = synth::netlist(&design, &Options::new(Family::Ecp5)).expect("a netlist");
        Self { scratch, design, golden, netlist: String::from_utf8(netlist).expect("ASCII") }
    }

    fn passes(&self, netlist: &str) -> (bool, String) {
        let directory = self.scratch.path("core");
        let job = Job { design: &self.design, golden: &self.golden, directory: &directory };
        let outcome = cosim::netlist(&job, netlist.as_bytes()).expect("Icarus runs");
        assert_eq!(outcome.expected_vectors, self.golden.vectors().len() as u64);
        (outcome.passed(), outcome.first.join("\n"))
    }

    #[track_caller]
    fn holds(&self, cells: &[&str]) {
        for text in cells {
            assert!(self.netlist.contains(text), "no {text}");
        }
        let (passed, said) = self.passes(&self.netlist);
        assert!(passed, "{said}");
    }

    /// With the first `text` changed, the netlist fails, and what is said holds `words`.
    #[track_caller]
    fn fails(&self, text: &str, instead: &str, words: &str) {
        let wrong = self.netlist.replacen(text, instead, 1);
        assert_ne!(wrong, self.netlist, "no {text}");
        let (passed, said) = self.passes(&wrong);
        assert!(!passed && said.contains(words), "{text} -> {instead}: {said}");
    }
}

#[test]
fn multipliers_with_registers_and_tables_do_what_the_core_does() {
    let core = Core::new(LOGIC);
    core.holds(&["LUT4 #(", "CCU2C #(", ".REG_INPUTA_CLK(\"CLK0\")"]);
    // A register of an operand, and of both at once, that is not there; one of a reset that the model does not have.
    core.fails(".REG_INPUTA_CLK(\"CLK0\")", ".REG_INPUTA_CLK(\"NONE\")", "expected");
    core.fails(".REG_INPUTB_CLK(\"CLK0\")", ".REG_INPUTB_CLK(\"NONE\")", "expected");
    core.fails(".REG_INPUTA_CLK(\"CLK0\")", ".REG_INPUTA_CLK(\"CLK1\")", "MULT18X18D does not know this");
    core.fails(".REG_INPUTA_CLK(\"CLK0\")", ".REG_PIPELINE_CLK(\"CLK0\")", "REG_PIPELINE_CLK not found");
    core.fails("LUT4 #(", "LUT5 #(", "LUT5");
    core.fails(".REGSET(\"RESET\")", ".REGSET(\"KEEP\")", "TRELLIS_FF does not know this");
    // The lowest bit of tables' contents: of most, as some input combinations of a table never come.
    let places: Vec<usize> =
        core.netlist.match_indices(".INIT(16'h").map(|(place, found)| place + found.len()).collect();
    assert!(places.len() > 10, "{}", places.len());
    let chosen: Vec<usize> = places.into_iter().step_by(7).take(6).collect();
    let caught = chosen
        .iter()
        .filter(|&&place| {
            let mut wrong = core.netlist.clone();
            let word = u16::from_str_radix(&wrong[place..place + 4], 16).expect("four digits");
            wrong.replace_range(place..place + 4, &format!("{:04x}", !word));
            !core.passes(&wrong).0
        })
        .count();
    assert_eq!(caught, chosen.len());
}

#[test]
fn a_block_ram_with_an_output_register_does_what_the_core_does() {
    let core = Core::new(BLOCK);
    core.holds(&["DP16KD #(", "(\"OUTREG\")"]);
    let port = if core.netlist.contains(".REGMODE_A(\"OUTREG\")") { "A" } else { "B" };
    core.fails(&format!(".REGMODE_{port}(\"OUTREG\")"), &format!(".REGMODE_{port}(\"NOREG\")"), "");
    core.fails(&format!(".DATA_WIDTH_{port}(32'd"), &format!(".DATA_WIDTH_{port}(32'd1"), "DP16KD does not know this");
    // A bit of a word: the first rows are of no shininess.
    let start = ".INITVAL_01(320'h";
    let digits = core.netlist.find(start).expect("words") + start.len();
    let end = digits + core.netlist[digits..].find(')').expect("an end");
    let last = u8::from_str_radix(&core.netlist[end - 1..end], 16).expect("a digit") ^ 1;
    let mut wrong = core.netlist.clone();
    wrong.replace_range(end - 1..end, &format!("{last:x}"));
    let (passed, said) = core.passes(&wrong);
    assert!(!passed && said.contains("expected"), "{said}");
}

#[test]
fn other_families_have_no_models() {
    let scratch = Scratch::new();
    scratch.refused("cosim --method quadratic --shininess 5 --netlist ice40", &["--netlist ice40", "ecp5 has"]);
}
