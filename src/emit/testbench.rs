//! The self-checking test benches.

use askama::Template;

use super::{
    Axis, Direction, ExternalMemory, Lane, Layout, LightTable, Port, RomFile, Sequencer, Texts, WritePort, names,
    render,
};
use crate::block::CHANNELS;
use crate::block::lights::Sums;
use crate::core::golden::Vector;
use crate::core::{FIRST_WORD, LAST_WORD, Role};
use crate::platform::error::Error;
use crate::spec::{Language, VhdlPorts};

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

    /// The numeric type of its codes in VHDL.
    fn sign(&self) -> &'static str {
        if self.signed { "signed" } else { "unsigned" }
    }
}

/// The write port of a memory, as the benches see it.
struct BenchWrite<'a> {
    memory: &'a str,
    depth: usize,
    /// The sets of so many words that it holds.
    sets: u32,
    enable: &'a str,
    address: &'a str,
    address_bits: u32,
    data: &'a str,
    data_bits: u32,
    /// Bits of the hexadecimal digits that hold a word.
    digit_bits: u32,
    file: &'a RomFile,
}

impl<'a> BenchWrite<'a> {
    fn of((port, file): &'a (WritePort, RomFile), sets: u32, layout: &Layout<'a>) -> Self {
        let table = &layout.datapath.tables[port.memory];
        Self {
            memory: table.name,
            depth: table.depth(),
            sets,
            enable: &port.enable.name,
            address: &port.address.name,
            address_bits: table.address_bits + sets.ilog2(),
            data: &port.data.name,
            data_bits: table.word_bits(),
            digit_bits: table.word_bits().next_multiple_of(4),
            file,
        }
    }

    /// Bits of an address in a set.
    fn own_bits(&self) -> u32 {
        self.address_bits - self.sets.ilog2()
    }

    /// The parts of a word that a random number fills each.
    fn parts(&self) -> Vec<RandomPart> {
        RandomPart::of(self.data_bits)
    }
}

/// A table of lights, as the benches see it.
struct BenchTable<'a> {
    depth: u32,
    address_bits: u32,
    word_bits: u32,
    lanes: &'a [Lane],
    /// Whether it is written; else it holds what it comes up with.
    is_written: bool,
    /// Enabled clocks from a sample to its codes, besides one for each word.
    behind: u32,
}

impl<'a> BenchTable<'a> {
    fn of(table: &'a LightTable) -> Self {
        let (depth, address_bits, word_bits) = (table.depth, table.address_bits, table.word_bits());
        let (lanes, is_written) = (&table.record.lanes[..], table.words.is_none());
        Self { depth, address_bits, word_bits, lanes, is_written, behind: table.latency - 1 }
    }

    /// The parts of a word that a random number fills each.
    fn parts(&self) -> Vec<RandomPart> {
        RandomPart::of(self.word_bits)
    }

    /// Bits of an integer beside an address.
    fn spare(&self) -> u32 {
        32 - self.address_bits
    }

    /// Bits of the number of words of a sample, at most half the table's.
    fn length_bits(&self) -> u32 {
        (self.address_bits - 1).min(3)
    }
}

/// What a bench is of.
#[derive(Clone, Copy, Debug)]
pub enum Wrapper<'a> {
    /// The core.
    None,
    /// Its sequencer.
    Sequencer(&'a Sequencer),
    /// Its table of lights.
    Table(&'a LightTable),
    /// Its wrapper with AXI4-Stream interfaces, around the sequencer or the table of lights if it has one.
    Axis(&'a Axis, Option<&'a Sequencer>, Option<&'a LightTable>),
}

/// Bits of a vector that a random number of 32 bits fills, or its low bits do.
pub(super) struct RandomPart {
    pub(super) high: u32,
    pub(super) low: u32,
}

impl RandomPart {
    /// The parts of a vector, from the lowest on.
    pub(super) fn of(bits: u32) -> Vec<Self> {
        (0..bits).step_by(32).map(|low| Self { high: (low + 31).min(bits - 1), low }).collect()
    }

    /// The highest bit of the random number that is taken.
    pub(super) fn top(&self) -> u32 {
        self.high - self.low
    }
}

/// What the templates of both languages need.
struct Bench<'a> {
    name: &'a str,
    header: &'a [String],
    /// The files that the core reads.
    rom_files: &'a [RomFile],
    /// The memories that the bench writes.
    writes: Vec<BenchWrite<'a>>,
    /// The memory outside of the core, if there is one.
    memory: Option<&'a ExternalMemory>,
    /// The codes of the ports of vectors for memories that hold the words' complements, as hexadecimal literals.
    complemented: Vec<String>,
    golden: &'a str,
    vhdl_ports: VhdlPorts,
    inputs: Vec<BenchPort<'a>>,
    /// The outputs of the vectors.
    outputs: Vec<BenchPort<'a>>,
    /// The outputs of what is tested: the same, or what its sequencer makes of them.
    results: Vec<BenchPort<'a>>,
    /// What of a vector the sequencer adds up, if there is one.
    sums: Option<Sums>,
    /// The table of lights, if there is one.
    table: Option<BenchTable<'a>>,
    /// Whether it waits before a vector as long as the file says.
    waits: bool,
    /// Characters that a line with a vector has at most, its end included.
    line_bytes: u32,
    latency: u32,
}

impl Bench<'_> {
    /// The memories that are written from files of which the core itself knows nothing.
    fn written_files(&self) -> &[BenchWrite<'_>] {
        if self.rom_files.is_empty() { &self.writes } else { &[] }
    }

    /// What reads files beside the core: the memory outside.
    fn memory_files(&self) -> Vec<&RomFile> {
        self.memory.iter().flat_map(|memory| memory.parts.iter().map(|part| &part.file)).collect()
    }

    /// Whether the set of texels is changed by samples, and not chosen at each clock.
    fn swaps(&self) -> bool {
        self.has_sets() && (self.sums.is_some() || self.table.is_some())
    }

    /// Whether there are two sets of texels.
    fn has_sets(&self) -> bool {
        self.writes.iter().any(|write| write.sets > 1)
    }

    /// The inputs and then the outputs.
    fn numbers(&self) -> impl Iterator<Item = &BenchPort<'_>> {
        self.inputs.iter().chain(&self.outputs)
    }

    /// The inputs and what is compared.
    fn shown(&self) -> impl Iterator<Item = &BenchPort<'_>> {
        self.inputs.iter().chain(&self.results)
    }

    /// All of them, once each.
    fn words(&self) -> impl Iterator<Item = &BenchPort<'_>> {
        self.numbers().chain(self.results.iter().filter(|_| self.sums.is_some()))
    }

    /// The inputs of a vector that what is tested has.
    fn driven_inputs(&self) -> impl Iterator<Item = &BenchPort<'_>> {
        let in_word = |port: &&BenchPort| {
            self.table.as_ref().is_some_and(|table| table.lanes.iter().any(|lane| lane.port.name == port.name))
        };
        self.inputs.iter().filter(move |port| !in_word(port))
    }

    /// The table of lights, if the bench writes it.
    fn written_table(&self) -> Option<&BenchTable<'_>> {
        self.table.as_ref().filter(|table| table.is_written)
    }

    /// Whether a sample is of several vectors, as it is of a sequencer whose lights come from ports.
    fn counts_lights(&self) -> bool {
        self.sums.is_some() && self.table.is_none()
    }

    /// So many vectors, of which a sequencer's sample has some and another one.
    fn lights(&self, number: &'static str) -> &'static str {
        if self.counts_lights() { number } else { "1" }
    }

    /// Clocks without a beat after which a wrapper is stuck: all words of the table may be a sample's.
    fn patience(&self) -> u32 {
        2000 + self.table.as_ref().map_or(0, |table| table.depth)
    }

    /// Whether what is offered in a lane is where the bench has written the sample's lights, and not in the vector:
    /// then the number of the word in Verilog and in VHDL.
    fn written_word(&self, lane: &Lane) -> Option<[&'static str; 2]> {
        match lane.port.name.as_str() {
            _ if self.written_table().is_none() => None,
            FIRST_WORD => Some(["begins_at", "begins_at"]),
            LAST_WORD => Some(["written", "begins_at + words - 1"]),
            _ => None,
        }
    }

    /// What is offered in a lane for the vector that was read last, in Verilog.
    fn offered(&self, lane: &Lane) -> String {
        if lane.port.role == Role::Swap {
            return "swap".to_owned();
        }
        let of_table = self.written_word(lane).map(|[word, _]| format!("{word}[{}:0]", lane.bits - 1));
        of_table.unwrap_or_else(|| format!("file_{}", lane.port.name))
    }

    /// The same in VHDL.
    fn vhdl_offered(&self, lane: &Lane) -> String {
        if lane.port.role == Role::Swap {
            return "swap".to_owned();
        }
        let of_table = self.written_word(lane);
        of_table.map_or_else(
            || format!("file_{}", lane.port.name),
            |[_, word]| format!("std_logic_vector(to_unsigned({word}, {}))", lane.bits),
        )
    }

    /// The type of a port of the core in VHDL.
    fn vector(&self, sign: &'static str) -> &'static str {
        self.vhdl_ports.vector(sign)
    }

    /// Bits as a port of the core takes them in VHDL.
    fn driven(&self, sign: &str, bits: &str) -> String {
        self.vhdl_ports.from_bits(sign, bits)
    }

    /// A name, followed by spaces up to the length of the longest port's.
    fn padded(&self, name: &str) -> String {
        let width = self.words().map(|port| port.name.len()).fold("out_valid".len(), usize::max);
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

#[derive(Template)]
#[template(path = "testbench/axis_tb.v", escape = "none")]
struct VerilogAxisBench<'a> {
    bench: &'a Bench<'a>,
    axis: &'a Axis,
}

#[derive(Template)]
#[template(path = "testbench/axis_tb.vhd", escape = "none")]
struct VhdlAxisBench<'a> {
    bench: &'a Bench<'a>,
    axis: &'a Axis,
}

/// The codes of a vector's inputs and outputs as literals of the ports' widths.
fn literals(language: Language, ports: &[&BenchPort], vector: &Vector) -> String {
    let literal = |(port, &code): (&&BenchPort, &i64)| {
        let (bits, digits) = (port.bits, port.digits as usize);
        // A port is at most 32 bits wide.
        let code = code as u64 & ((1 << bits) - 1);
        match language {
            Language::Verilog => format!("{bits}'h{code:0digits$x}"),
            Language::Vhdl => format!("{bits}x\"{code:0digits$x}\""),
        }
    };
    let codes = vector.inputs.iter().chain(&vector.outputs);
    ports.iter().zip(codes).map(literal).collect::<Vec<_>>().join(", ")
}

/// The test bench of a core in a language; `golden` is the path of its vectors, relative to the core's directory. For a
/// core whose memories can be written, `complemented` are some vectors with the outputs for the words' complements;
/// `memory` is what a core reads outside of it.
///
/// # Errors
/// If the template cannot be filled in.
pub fn test_bench(
    language: Language,
    layout: &Layout,
    texts: &Texts,
    golden: &str,
    complemented: &[Vector],
    wrapper: Wrapper,
    memory: Option<&ExternalMemory>,
) -> Result<String, Error> {
    let (sequencer, table, axis) = match wrapper {
        Wrapper::None => (None, None, None),
        Wrapper::Sequencer(sequencer) => (Some(sequencer), None, None),
        Wrapper::Table(table) => (Some(&table.sequencer), Some(table), None),
        Wrapper::Axis(axis, sequencer, table) => (sequencer, table, Some(axis)),
    };
    // What goes through a table that is not written is compared as it is.
    let sequencer = sequencer.filter(|_| table.is_none_or(|table| table.words.is_none()));
    let (name, header) = match (table, sequencer) {
        (Some(LightTable { name, header, .. }), _) | (None, Some(Sequencer { name, header, .. })) => (name, header),
        (None, None) => (&texts.name, &texts.header),
    };
    let latency = match (table, sequencer) {
        // As long as a sample may be under way, and the clock at which it is looked at.
        (Some(table), _) => table.depth + table.latency,
        (None, Some(sequencer)) => sequencer.latency,
        (None, None) => layout.schedule.latency,
    };
    let own = table.filter(|table| table.words.is_some()).map_or(&texts.ports, |table| &table.ports);
    let whole = sequencer.map_or(own, |sequencer| &sequencer.ports);
    let results = whole.iter().filter(|port| port.carries(Direction::Out)).filter_map(BenchPort::of).collect();
    let numbers = |direction: Direction| -> Vec<BenchPort> {
        own.iter().filter(|port| port.carries(direction)).filter_map(BenchPort::of).collect()
    };
    let (inputs, outputs) = (numbers(Direction::In), numbers(Direction::Out));
    let numbers: Vec<&BenchPort> = inputs.iter().chain(&outputs).collect();
    let complemented = complemented.iter().map(|vector| literals(language, &numbers, vector)).collect();
    let write = |write| BenchWrite::of(write, texts.sets, layout);
    let digits: u32 = inputs.iter().chain(&outputs).map(|port| 1 + port.digits).sum();
    let bench = &Bench {
        name,
        header,
        rom_files: &texts.rom_files,
        writes: texts.writes.iter().map(write).collect(),
        memory,
        complemented,
        golden,
        vhdl_ports: texts.vhdl_ports,
        inputs,
        outputs,
        results,
        sums: sequencer.map(|sequencer| sequencer.sums),
        table: table.map(BenchTable::of),
        // The letter, the codes, two numbers of nine digits, the end of the line, and one to notice that it is longer.
        line_bytes: (1 + digits + 20 + 2 + 1).next_multiple_of(8),
        waits: axis.is_none(),
        latency,
    };
    let text = match (language, axis) {
        (Language::Verilog, None) => render(&VerilogBench { bench }),
        (Language::Vhdl, None) => render(&VhdlBench { bench }),
        (Language::Verilog, Some(axis)) => render(&VerilogAxisBench { bench, axis }),
        (Language::Vhdl, Some(axis)) => render(&VhdlAxisBench { bench, axis }),
    };
    names::checked(language, &texts.name, text?)
}
