//! The wrapper that gives a core AXI4-Stream interfaces.
//!
//! A beat of the stream is one set of the core's inputs, and later one of its outputs: `tdata` packs the ports that
//! carry numbers side by side from its lowest bit on, in the order of their declaration, and is filled up to whole
//! bytes as AXI4-Stream requires (Arm IHI 0051, section 2.1). `tlast` and `tuser` are carried beside the pipeline.
//!
//! # Skid buffer or credit
//!
//! A pipeline can take back-pressure in two ways.
//!
//! - *Credit*: the pipeline runs freely into a FIFO that holds as many beats as are in flight, and the source is let in
//!   only while there is room for what is under way. No clock enable is needed. But the FIFO holds a result for every
//!   stage (14 words for a shader), with its counters and its own clock of latency or more.
//! - *Enable and skid buffer*: the pipeline is frozen when the sink does not take what is at its end. The cores have a
//!   clock enable for that, so that nothing but the freezing itself costs anything.
//!
//! So it is the enable. Driven by `m_axis_tready` itself, it would be a path from another block's logic to every
//! register of the core, and on to the source. It is a register instead, and with it `s_axis_tready`, which therefore
//! falls a clock late: the pipeline makes one more step, and the beat that would be lost by it waits in one more
//! register, the skid register.
//!
//! That register stands behind the core and not in front of it, where it would do as well: results are narrower than
//! operands (24 bits against 218 for a shader of two lights), and no multiplexer stands before the core's first stage.
//! What the sink sees is one multiplexer behind registers.
//!
//! The enable is 1 at every clock that follows one at which the sink was ready or nothing was at the pipeline's end. So
//! one beat a clock passes, no stall leaves a bubble behind, and bubbles at the pipeline's end give way while the sink
//! is not ready.
//!
//! # Tables of lights
//!
//! A sample stays in front of a table of lights for as many clocks as it has words, so that `s_axis_tready` is low
//! until the last of them is read: it is the enable and what the table says, both from registers. `tlast` and `tuser`
//! need no queue, as samples leave in the order in which they came, each a latency behind its last word: in front they
//! stay with the sample, and from there on they go with each of its words.

use askama::Template;
use num_bigint::BigUint;

use super::testbench::RandomPart;
use super::{Direction, Port, Role, Texts, names, render};
use crate::core::{FIRST_WORD, LAST_WORD};
use crate::fixed::Format;
use crate::platform::error::Error;
use crate::spec::Language;

/// The port that shows the enable of the core to a memory outside of it.
pub(super) const MEMORY_ENABLE: &str = "texels_ce";

/// `high:low`, or the bit if it is one.
fn range(low: u32, bits: u32) -> String {
    if bits == 1 { low.to_string() } else { format!("{}:{low}", low + bits - 1) }
}

/// The place of a core's port in `tdata`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Lane {
    /// The port.
    pub port: Port,
    /// Its lowest bit in `tdata`.
    pub low: u32,
    /// Its bits.
    pub bits: u32,
}

impl Lane {
    /// The bits of `tdata` that it takes, `high:low`, or the one.
    #[must_use]
    pub fn range(&self) -> String {
        range(self.low, self.bits)
    }

    /// The same in VHDL.
    #[must_use]
    pub fn downto(&self) -> String {
        format!("{} downto {}", self.low + self.bits - 1, self.low)
    }

    /// The type of its codes in VHDL.
    #[must_use]
    pub fn sign(&self) -> &'static str {
        if self.port.format.is_some_and(|format| format.signed) { "signed" } else { "unsigned" }
    }

    /// The type of its port with the bits, in VHDL.
    fn kind(&self, texts: &Texts) -> String {
        let vector = texts.vhdl_ports.vector(self.sign());
        format!("{vector}({} downto 0)", self.bits - 1)
    }

    /// Its bits of a word, of the type of its port, in VHDL.
    pub(super) fn of_bits(&self, word: &str, texts: &Texts) -> String {
        match self.port.format {
            Some(_) => texts.vhdl_ports.from_bits(self.sign(), &format!("{word}({})", self.downto())),
            None => format!("{word}({})", self.low),
        }
    }
}

/// What `tdata` of one side holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Packing {
    /// The ports, the one in the lowest bits first; there is nothing between them.
    pub lanes: Vec<Lane>,
    /// The bits that they take together.
    pub bits: u32,
}

impl Packing {
    pub(super) fn of<'a>(ports: impl Iterator<Item = &'a Port>) -> Self {
        let mut bits = 0;
        let lane = |port: &Port| {
            let (low, width) = (bits, port.format.map_or(1, Format::width));
            bits += width;
            Lane { port: port.clone(), low, bits: width }
        };
        let lanes = ports.map(lane).collect();
        Self { lanes, bits }
    }

    /// These codes where the ports lie, those of the first ports if there are fewer.
    pub(super) fn word(&self, codes: &[i64]) -> BigUint {
        let placed = self.lanes.iter().zip(codes).filter_map(|(lane, &code)| {
            let bits = lane.port.format?.bits(code.into());
            Some(BigUint::from(bits) << lane.low)
        });
        placed.fold(BigUint::ZERO, |word, field| word | field)
    }

    /// The bits of `tdata`: whole bytes.
    #[must_use]
    pub fn tdata_bits(&self) -> u32 {
        self.bits.next_multiple_of(8)
    }

    /// The bits at the top of `tdata` that hold nothing, `high:low`, or the one.
    #[must_use]
    pub fn padding_range(&self) -> String {
        range(self.bits, self.padding())
    }

    /// The number of bits at the top of `tdata` that hold nothing.
    #[must_use]
    pub fn padding(&self) -> u32 {
        self.tdata_bits() - self.bits
    }
}

/// A port of the wrapper.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AxisPort {
    /// Its name.
    pub name: String,
    /// Which way it leads.
    pub direction: Direction,
    /// Its bits if it is a vector, else `None`.
    pub bits: Option<u32>,
    /// What it is for, as the end of a sentence.
    pub meaning: String,
    /// Whether it is of a memory of the core.
    pub is_memory: bool,
}

/// A core's wrapper.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Axis {
    /// Its name: that of the core and `_axis`.
    pub name: String,
    /// The lines of the header comment, without a comment marker.
    pub header: Vec<String>,
    /// What `s_axis_tdata` holds.
    pub inputs: Packing,
    /// What `m_axis_tdata` holds; its padding is 0.
    pub outputs: Packing,
    /// The ports of the core's memories, which are the wrapper's, too.
    pub memories: Vec<Port>,
    /// The bits of `tuser`.
    pub tuser_bits: u32,
    /// The core's latency, and the wrapper's, in clocks at which nothing waits; of a sample of one word.
    pub latency: u32,
    /// Whether what it is around takes the lights of a sample in sequence: `tlast` ends a sample, and a result is a
    /// packet of its own.
    pub sequenced: bool,
    /// The places of a sample's first and last word where it is around a table of lights: a beat is a sample, and the
    /// table says when it takes one.
    pub words: Option<[Lane; 2]>,
}

impl Axis {
    /// The wrapper `name` around what has these texts, without a header.
    #[must_use]
    pub fn of(name: String, texts: &Texts, latency: u32, tuser_bits: u32) -> Self {
        let memories = texts.ports.iter().filter(|port| port.is_memory()).cloned().collect();
        let packed = |direction: Direction| {
            let is_packed =
                move |port: &&Port| port.carries(direction) || (port.role == Role::Swap && direction == Direction::In);
            Packing::of(texts.ports.iter().filter(is_packed))
        };
        let inputs = packed(Direction::In);
        let lane = |name: &str| inputs.lanes.iter().find(|lane| lane.port.name == name).cloned();
        Self {
            name,
            header: Vec::new(),
            words: lane(FIRST_WORD).zip(lane(LAST_WORD)).map(Into::into),
            inputs,
            outputs: packed(Direction::Out),
            memories,
            tuser_bits,
            latency,
            sequenced: texts.ports.iter().any(|port| port.role == Role::InLast),
        }
    }

    /// Whether a beat is a sample that a table of lights takes.
    #[must_use]
    pub fn takes_samples(&self) -> bool {
        self.words.is_some()
    }

    /// The ports, in the order of their declaration.
    #[must_use]
    pub fn ports(&self) -> Vec<AxisPort> {
        let port = |name: &str, direction, bits, meaning: &str| AxisPort {
            name: name.to_owned(),
            direction,
            bits,
            meaning: meaning.to_owned(),
            is_memory: false,
        };
        let (input, output) = (Direction::In, Direction::Out);
        let [tlast, shown_tlast, shown_tuser] = if self.sequenced {
            [
                "with the lights of this beat the sample ends",
                "1: a beat is a sample",
                "as it came with the sample's last beat",
            ]
        } else {
            ["goes with the beat", "as it came with the beat", "as it came with the beat"]
        };
        let tready = if self.takes_samples() {
            "the beat is taken; from registers"
        } else {
            "the beat is taken; from a register"
        };
        let mut ports = vec![
            port("aclk", input, None, "clock; everything happens on its rising edge"),
            port("aresetn", input, None, "synchronous reset, active low: every beat under way is dropped"),
            port("s_axis_tdata", input, Some(self.inputs.tdata_bits()), "the core's inputs, packed"),
            port("s_axis_tvalid", input, None, "a beat is offered"),
            port("s_axis_tready", output, None, tready),
            port("s_axis_tlast", input, None, tlast),
            port("s_axis_tuser", input, Some(self.tuser_bits), "goes with the beat"),
        ];
        let of_memory = |port: &Port| AxisPort {
            name: port.name.clone(),
            direction: port.role.direction(),
            bits: port.format.map(Format::width),
            meaning: port.meaning.replace("ce and rst are", "the stream does"),
            is_memory: true,
        };
        if self.reads_outside() {
            ports.push(port(MEMORY_ENABLE, output, None, "clock enable of the memory outside: 0 freezes it"));
        }
        ports.extend(self.memories.iter().map(of_memory));
        ports.extend([
            port("m_axis_tdata", output, Some(self.outputs.tdata_bits()), "the core's outputs, packed"),
            port("m_axis_tvalid", output, None, "a beat is there; it stays until it is taken"),
            port("m_axis_tready", input, None, "the beat is taken"),
            port("m_axis_tlast", output, None, shown_tlast),
            port("m_axis_tuser", output, Some(self.tuser_bits), shown_tuser),
        ]);
        ports
    }

    /// Whether the core reads a memory outside of it.
    #[must_use]
    pub fn reads_outside(&self) -> bool {
        self.memories.iter().any(|port| port.role == Role::Address)
    }

    /// The inputs of memories with their bits.
    #[must_use]
    pub fn memory_inputs(&self) -> Vec<(&str, u32)> {
        let inputs = self.memories.iter().filter(|port| port.role.direction() == Direction::In);
        inputs.map(|port| (port.name.as_str(), port.format.map_or(1, Format::width))).collect()
    }

    /// The bits of tuser for every stage.
    fn user_bits(&self) -> u32 {
        self.tuser_bits * self.latency
    }

    /// The lowest bit of the last stage among them.
    fn user_low(&self) -> u32 {
        self.tuser_bits * (self.latency - 1)
    }

    /// The bits of the first stage among them, in Verilog.
    fn newest_user(&self) -> String {
        range(0, self.tuser_bits)
    }

    /// The bits of the last stage among them, in Verilog.
    fn oldest_user(&self) -> String {
        range(self.user_low(), self.tuser_bits)
    }

    /// The bits of tuser in a beat, in Verilog.
    fn shown_user(&self) -> String {
        range(self.outputs.bits + 1, self.tuser_bits)
    }

    /// The bits of a beat of results, from the lowest on: the outputs, tlast, tuser.
    #[must_use]
    pub fn beat_bits(&self) -> u32 {
        self.outputs.bits + 1 + self.tuser_bits
    }

    /// The bits of a beat with the padding of tdata.
    pub(super) fn wide_beat_bits(&self) -> u32 {
        self.outputs.tdata_bits() + 1 + self.tuser_bits
    }

    /// The words of the sample that is offered, in Verilog; only of a wrapper whose beats are samples.
    pub(super) fn words_of_beat(&self) -> String {
        self.words.as_ref().map_or(String::new(), |[first, last]| {
            let [first_bits, last_bits] = [first, last].map(|lane| format!("s_axis_tdata[{}]", lane.range()));
            format!("{{{}'d0, {last_bits} - {first_bits}}} + 1", 32 - first.bits)
        })
    }

    /// The same in VHDL.
    pub(super) fn vhdl_words_of_beat(&self) -> String {
        self.words.as_ref().map_or(String::new(), |lanes| {
            let [first, last] = lanes.each_ref().map(|lane| format!("unsigned(s_axis_tdata({}))", lane.downto()));
            format!("to_integer({last} - {first}) + 1")
        })
    }

    /// The parts of s_axis_tdata that a random number fills each.
    pub(super) fn input_parts(&self) -> Vec<RandomPart> {
        RandomPart::of(self.inputs.tdata_bits())
    }

    /// The same of s_axis_tuser.
    pub(super) fn user_parts(&self) -> Vec<RandomPart> {
        RandomPart::of(self.tuser_bits)
    }

    /// A name of the core's ports, followed by spaces up to the length of the longest.
    fn padded(&self, name: &str) -> String {
        let lanes = self.inputs.lanes.iter().chain(&self.outputs.lanes).map(|lane| &lane.port);
        let width = lanes.chain(&self.memories).map(|port| port.name.len()).fold("out_valid".len(), usize::max);
        format!("{name:<width$}")
    }

    /// The text of the wrapper in a language; `texts` are the core's.
    ///
    /// # Errors
    /// If the template cannot be filled in.
    pub fn emit(&self, language: Language, texts: &Texts) -> Result<String, Error> {
        let ports = self.ports();
        let text = match language {
            Language::Verilog => {
                let range = |port: &AxisPort| port.bits.map_or(String::new(), |bits| format!("[{}:0]", bits - 1));
                let width = ports.iter().map(|port| range(port).len()).max().unwrap_or(0);
                let declaration = |port: &AxisPort| {
                    let direction = match port.direction {
                        Direction::In => "input  wire",
                        Direction::Out => "output wire",
                    };
                    (port.meaning.clone(), format!("{direction} {:<width$} {}", range(port), port.name))
                };
                render(&VerilogAxis { axis: self, texts, ports: ports.iter().map(declaration).collect() })
            }
            Language::Vhdl => {
                let width = ports.iter().map(|port| port.name.len()).max().unwrap_or(0);
                let declaration = |port: &AxisPort| {
                    let vector = if port.is_memory { texts.vhdl_ports.vector("unsigned") } else { "std_logic_vector" };
                    let kind =
                        port.bits.map_or("std_logic".to_owned(), |bits| format!("{vector}({} downto 0)", bits - 1));
                    (port.meaning.clone(), format!("{:<width$} : {:<3} {kind}", port.name, port.direction.word()))
                };
                render(&VhdlAxis { axis: self, texts, ports: ports.iter().map(declaration).collect() })
            }
        };
        names::checked(language, &texts.name, text?)
    }
}

#[derive(Template)]
#[template(path = "verilog/axis.v", escape = "none")]
struct VerilogAxis<'a> {
    axis: &'a Axis,
    texts: &'a Texts,
    /// A comment and a declaration each.
    ports: Vec<(String, String)>,
}

#[derive(Template)]
#[template(path = "vhdl/axis.vhd", escape = "none")]
struct VhdlAxis<'a> {
    axis: &'a Axis,
    texts: &'a Texts,
    /// A comment and a declaration each.
    ports: Vec<(String, String)>,
}
