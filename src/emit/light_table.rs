//! The table of lights in front of a sequencer: records that a host writes, or that the spec gives, of which every
//! sample goes through a range.
//!
//! A sample names the first and the last word of its lights, so that a host writes the next frame's lights to one part
//! of the table while samples still read another, and a new range takes effect with the sample that names it.

use askama::Template;

use super::axis::{Lane, Packing};
use super::{Connected, Declaration, Port, Sequencer, Texts, names, render, verilog, vhdl};
use crate::core::{Direction, Role};
use crate::platform::error::Error;
use crate::spec::Language;

/// A table of lights and the sequencer behind it.
#[derive(Clone, Debug)]
pub struct LightTable {
    /// Its name: that of the core and `_table`.
    pub name: String,
    /// The lines of the header comment, without a comment marker.
    pub header: Vec<String>,
    /// Its ports, in the order of their declaration.
    pub ports: Vec<Port>,
    /// The sequencer behind it.
    pub sequencer: Sequencer,
    /// The words.
    pub depth: u32,
    /// Enabled clocks from a sample of one word to its codes.
    pub latency: u32,
    /// The codes that its words hold, if it is not written.
    pub words: Option<Vec<Vec<i64>>>,
    /// The lights of a word that it holds.
    lights_a_word: usize,
    /// Bits of a word's address.
    pub address_bits: u32,
    /// The place of each port of the sequencer's lights in a word.
    pub record: Packing,
    /// The ports of a sample that are no light's.
    pub sample: Vec<Connected>,
    /// The ports of other memories.
    passed: Vec<String>,
}

impl LightTable {
    /// The table with these ports, of so many words, in front of a sequencer, without a header; it is written, or holds
    /// these words of so many lights each.
    #[must_use]
    pub fn new(
        name: String,
        core: &Texts,
        ports: Vec<Port>,
        sequencer: Sequencer,
        [depth, latency]: [u32; 2],
        words: Option<(Vec<Vec<i64>>, usize)>,
    ) -> Self {
        let is_own = |port: &&Port| ports.iter().any(|own| own.name == port.name);
        let inputs = || core.ports.iter().filter(|port| port.carries(Direction::In));
        let passed = sequencer.ports.iter().filter(|port| port.is_memory());
        let swap = ports.iter().filter(|port| port.role == Role::Swap);
        Self {
            name,
            header: Vec::new(),
            depth,
            latency,
            lights_a_word: words.as_ref().map_or(0, |(_, lights)| *lights),
            words: words.map(|(words, _)| words),
            address_bits: depth.ilog2(),
            record: Packing::of(inputs().filter(|port| !is_own(port))),
            sample: inputs().filter(is_own).chain(swap).map(Connected::of).collect(),
            passed: passed.map(|port| port.name.clone()).collect(),
            sequencer,
            ports,
        }
    }

    /// Bits of a word.
    #[must_use]
    pub fn word_bits(&self) -> u32 {
        self.record.bits
    }

    /// A word with these codes at the first of its ports, and 0 at the others, in hexadecimal.
    #[must_use]
    pub fn word(&self, codes: &[i64]) -> String {
        let digits = self.word_bits().div_ceil(4) as usize;
        format!("{:0digits$x}", self.record.word(codes))
    }

    /// The words that it holds, each as literals of a clock's lights, the last light first; none if it is written.
    fn literals(&self, language: Language) -> Vec<Vec<String>> {
        let words = self.words.as_deref().unwrap_or_default();
        let a_clock = self.lights_a_word;
        let literal = |codes: &[i64], lanes: &[Lane]| {
            let bits: u32 = lanes.iter().map(|lane| lane.bits).sum();
            let packed = Packing::of(lanes.iter().map(|lane| &lane.port)).word(codes);
            let digits = bits.div_ceil(4) as usize;
            match language {
                Language::Verilog => format!("{bits}'h{packed:0digits$x}"),
                Language::Vhdl => format!("{bits}x\"{packed:0digits$x}\""),
            }
        };
        let of_word = |codes: &Vec<i64>| {
            let each = codes.len() / a_clock;
            codes
                .chunks(each)
                .zip(self.record.lanes.chunks(each))
                .rev()
                .map(|(codes, lanes)| literal(codes, lanes))
                .collect()
        };
        words.iter().map(of_word).collect()
    }

    /// A name of the sequencer's ports, followed by spaces up to the length of the longest.
    fn padded(&self, name: &str) -> String {
        let lanes = self.record.lanes.iter().map(|lane| lane.port.name.len());
        let width = lanes.chain(self.passed.iter().map(String::len)).fold("out_valid".len(), usize::max);
        format!("{name:<width$}")
    }

    /// The address that is written, as a number in VHDL.
    fn vhdl_address(&self, core: &Texts) -> &'static str {
        if core.vhdl_ports.vector("unsigned") == "unsigned" { "lights_addr" } else { "unsigned(lights_addr)" }
    }

    /// Its inputs but for clock, reset, enable and valid.
    #[must_use]
    pub fn inputs(&self) -> Vec<Connected> {
        let own = |port: &&Port| port.role.name().is_none() && port.role.direction() == Direction::In;
        self.ports.iter().filter(own).map(Connected::of).collect()
    }

    /// The text of the table in a language; `core` are the core's.
    ///
    /// # Errors
    /// If the template cannot be filled in.
    pub fn emit(&self, language: Language, core: &Texts) -> Result<String, Error> {
        let text = match language {
            Language::Verilog => {
                let ports = verilog::declarations(&self.ports);
                render(&VerilogTable { table: self, core, ports, words: self.literals(language) })
            }
            Language::Vhdl => {
                let ports = vhdl::declarations(&self.ports, core.vhdl_ports);
                render(&VhdlTable { table: self, core, ports, words: self.literals(language) })
            }
        };
        names::checked(language, &core.name, text?)
    }
}

#[derive(Template)]
#[template(path = "verilog/table.v", escape = "none")]
struct VerilogTable<'a> {
    table: &'a LightTable,
    core: &'a Texts,
    ports: Vec<Declaration>,
    /// The literals of each word of a table that is not written.
    words: Vec<Vec<String>>,
}

#[derive(Template)]
#[template(path = "vhdl/table.vhd", escape = "none")]
struct VhdlTable<'a> {
    table: &'a LightTable,
    core: &'a Texts,
    ports: Vec<Declaration>,
    /// The literals of each word of a table that is not written.
    words: Vec<Vec<String>>,
}
