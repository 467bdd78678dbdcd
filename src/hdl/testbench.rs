//! The self-checking test benches.

use askama::Template;

use super::{Direction, Layout, Port, RomFile, Texts, render};
use crate::error::Error;
use crate::spec::Language;

/// A port that carries numbers, as the benches see it.
struct BenchPort<'a> {
    name: &'a str,
    bits: u32,
    /// Hexadecimal digits in the vector file.
    digits: u32,
    signed: bool,
    /// The bits in Verilog, `[high:0]`.
    range: String,
}

impl<'a> BenchPort<'a> {
    /// A port, if it carries numbers.
    fn of(port: &'a Port) -> Option<Self> {
        let format = port.format?;
        // The benches' random numbers and the fields that they read are of 32 bits.
        debug_assert!(format.width() <= 32, "{}", port.name);
        let bits = format.width();
        let range = format!("[{}:0]", bits - 1);
        Some(Self { name: &port.name, bits, digits: bits.div_ceil(4), signed: format.signed, range })
    }
}

/// What the templates of both languages need.
struct Bench<'a> {
    name: &'a str,
    header: &'a [String],
    rom_files: &'a [RomFile],
    golden: &'a str,
    inputs: Vec<BenchPort<'a>>,
    outputs: Vec<BenchPort<'a>>,
    /// Characters that a line with a vector has at most, its end included.
    line_bytes: u32,
    latency: u32,
}

impl Bench<'_> {
    /// The inputs and then the outputs.
    fn numbers(&self) -> impl Iterator<Item = &BenchPort<'_>> {
        self.inputs.iter().chain(&self.outputs)
    }

    /// A name, followed by spaces up to the length of the longest port's.
    fn padded(&self, name: &str) -> String {
        let width = self.numbers().map(|port| port.name.len()).fold("out_valid".len(), usize::max);
        format!("{name:<width$}")
    }

    /// A range of bits in Verilog, or nothing, followed by spaces up to the length of the longest.
    fn ranged(&self, range: &str) -> String {
        let width = self.numbers().map(|port| port.range.len()).max().unwrap_or(0);
        format!("{range:<width$}")
    }
}

#[derive(Template)]
#[template(path = "testbench/tb.v", escape = "none")]
struct VerilogBench<'a> {
    bench: &'a Bench<'a>,
}

#[derive(Template)]
#[template(path = "testbench/tb.vhd", escape = "none")]
struct VhdlBench<'a> {
    bench: &'a Bench<'a>,
}

/// The test bench of a core in a language; `golden` is the path of its vectors, relative to the core's directory.
///
/// # Errors
/// If the template cannot be filled in.
pub fn test_bench(language: Language, layout: &Layout, texts: &Texts, golden: &str) -> Result<String, Error> {
    let numbers = |direction: Direction| -> Vec<BenchPort> {
        let of = |port: &&Port| port.direction == direction;
        texts.ports.iter().filter(of).filter_map(BenchPort::of).collect()
    };
    let (inputs, outputs) = (numbers(Direction::In), numbers(Direction::Out));
    let digits: u32 = inputs.iter().chain(&outputs).map(|port| 1 + port.digits).sum();
    let bench = &Bench {
        name: &texts.name,
        header: &texts.header,
        rom_files: &texts.rom_files,
        golden,
        inputs,
        outputs,
        // The letter, the codes, two numbers of nine digits, the end of the line, and one to notice that it is longer.
        line_bytes: (1 + digits + 20 + 2 + 1).next_multiple_of(8),
        latency: layout.schedule.latency,
    };
    match language {
        Language::Verilog => render(&VerilogBench { bench }),
        Language::Vhdl => render(&VhdlBench { bench }),
    }
}
