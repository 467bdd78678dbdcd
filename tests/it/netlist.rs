//! The netlist that `synth` makes of a core for ECP5, with registers moved into its blocks, runs the core's golden
//! vectors; a netlist with a mistake does not.
//!
//! Needs pyosys and iverilog; `test.sh` installs them.

use brdfgen::core::{Account, Design, Direction};
use brdfgen::emit::package;
use brdfgen::spec::SpecFields;
use brdfgen::synth::{self, Options};
use brdfgen::target::Family;
use brdfgen::verify::cosim::{self, Job};
use brdfgen::verify::golden::{Golden, Vector, all_codes};
use rayon::prelude::*;

use crate::common::Scratch;

/// Multipliers, one-clock tables in logic, carry chains.
const LOGIC: &str = "method = \"quadratic\"\nshininess = \"1,5,20\"\ninput_fraction = 8\noutput_fraction = 8\n";
/// The coefficients in a block RAM.
const BLOCK: &str = "method = \"quadratic\"\nshininess = \"1..=255\"\ninput_fraction = 10\noutput_fraction = 8\n";

/// A memory of several block RAMs with multiplexers behind them.
const DEEP: &str = "method = \"harris\"\nlog_bits = 9\nexp_bits = 6\nshininess = \"1,5,20\"\noutput_fraction = 8\n";

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
        self.passes_with("core", &self.golden, netlist)
    }

    /// With other golden vectors, those of the core in another directory.
    fn passes_with(&self, directory: &str, golden: &Golden, netlist: &str) -> (bool, String) {
        let directory = self.scratch.path(directory);
        let job = Job { design: &self.design, golden, directory: &directory };
        let models = Family::Ecp5.description().models.as_ref().expect("models");
        let outcome = cosim::netlist(&job, models, netlist.as_bytes()).expect("Icarus runs");
        assert_eq!(outcome.expected_vectors, golden.vectors().len() as u64);
        (outcome.passed(), outcome.first.join("\n"))
    }

    /// Every input as a vector, and the core with them in the directory `every`.
    fn every(&self) -> Golden {
        let ports = self.design.numbers(Direction::In);
        let [(first, firsts), (second, seconds)] = [0, 1].map(|port| all_codes(ports[port].1));
        let inputs = (0..firsts * seconds)
            .map(|place| vec![first + (place / seconds) as i64, second + (place % seconds) as i64]);
        let vector = |inputs: Vec<i64>| Vector { outputs: self.design.evaluate(&inputs), inputs, idle: 0, stall: 0 };
        let groups = vec![("all".to_owned(), inputs.map(vector).collect())];
        let golden = Golden { groups, ..self.golden.clone() };
        let files = package::files(&self.design, &Account::of(&self.design), &golden).expect("files");
        package::write_directory(&self.scratch.path("every"), &files).expect("written");
        golden
    }

    /// Inverts single bits of the 16-bit tables that stand behind `words` in the netlist, one of every `step`, and says
    /// how many there are and how many the golden vectors find; what they miss, no input shows.
    fn bits_of_tables(&self, words: &[&str], step: usize) -> [usize; 2] {
        let found = words.iter().flat_map(|word| self.netlist.match_indices(word)).map(|(at, word)| at + word.len());
        let bits: Vec<(usize, u32)> = found.flat_map(|at| (0..16).map(move |bit| (at, bit))).step_by(step).collect();
        let every = self.every();
        let (passed, said) = self.passes_with("every", &every, &self.netlist);
        assert!(passed, "{said}");
        let caught = bits.par_iter().filter(|&&(at, bit)| {
            let mut wrong = self.netlist.clone();
            let word = u16::from_str_radix(&wrong[at..at + 4], 16).expect("four digits");
            wrong.replace_range(at..at + 4, &format!("{:04x}", word ^ 1 << bit));
            let caught = !self.passes(&wrong).0;
            if !caught {
                let (passed, said) = self.passes_with("every", &every, &wrong);
                assert!(passed, "bit {bit} of the table at {at} is found by all inputs and not by the vectors: {said}");
            }
            caught
        });
        [bits.len(), caught.count()]
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
    core.fails(".REG_OUTPUT_CLK(\"CLK0\")", ".REG_OUTPUT_CLK(\"NONE\")", "expected");
}

/// Some combinations of a table's inputs never come, so that a wrong bit there shows for no input; any other the
/// vectors find.
#[test]
fn single_bits_of_tables_are_found_wherever_an_input_shows_them() {
    let core = Core::new(LOGIC);
    let lut = core.bits_of_tables(&[".INIT(16'h"], 41);
    // Of a carry's inputs two are constants as a rule: a quarter of the bits can come.
    let carry = core.bits_of_tables(&[".INIT0(16'h", ".INIT1(16'h"], 35);
    println!("of the bits of LUT4 and of CCU2C [looked at, found]: {lut:?} {carry:?}");
    assert!(lut[0] > 10 && 3 * lut[1] > lut[0] && carry[0] >= 10 && 8 * carry[1] > carry[0], "{lut:?} {carry:?}");
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

/// The registers behind the multiplexers of a deep memory are in front of them, inside the RAMs: the netlist runs the
/// vectors, and does not where one of them is missing.
#[test]
fn registers_behind_multiplexers_are_in_the_block_rams() {
    let core = Core::new(DEEP);
    let (passed, said) = core.passes(&core.netlist);
    assert!(passed, "{said}");
    let inside = "\"OUTREG\"";
    let rams = core.netlist.matches("DP16KD #(").count();
    assert!(rams > 4 && core.netlist.matches(inside).count() >= rams, "{rams} block RAMs");
    let without = core.netlist.replacen(inside, "\"NOREG\"", 1);
    assert!(!core.passes(&without).0, "a missing register is not noticed");
}
