//! A model of the memory that an image-based block's texels lie in where that is outside of the core: for test benches,
//! and to close a core for the checks that look at it as a whole.

use askama::Template;

use super::vhdl::WordReader;
use super::{Declaration, Port, RomFile, Texts, names, render, verilog, vhdl};
use crate::core::ReadPort;
use crate::fixed::Table;
use crate::platform::error::Error;
use crate::spec::Language;

/// A memory outside of a core, with its words in files.
#[derive(Clone, Debug)]
pub struct ExternalMemory {
    /// The name of its module or entity: that of the core and `_memory`.
    pub name: String,
    /// The lines of the header comment, without a comment marker.
    pub header: Vec<String>,
    /// Enabled clocks from an address to its word.
    pub clocks: u32,
    /// Its parts, each with a port of the core.
    pub parts: Vec<ExternalPart>,
}

/// What a port of a core reads.
#[derive(Clone, Debug)]
pub struct ExternalPart {
    /// The core's port.
    pub port: ReadPort,
    /// The file with the words.
    pub file: RomFile,
    /// The words.
    pub depth: usize,
    /// Bits of an address.
    pub address_bits: u32,
    /// Bits of a word.
    pub bits: u32,
}

impl ExternalPart {
    /// What a port of a core reads of a table whose words are in a file.
    #[must_use]
    pub fn new(port: ReadPort, file: RomFile, table: &Table) -> Self {
        Self { port, file, depth: table.depth(), address_bits: table.address_bits, bits: table.word_bits() }
    }

    /// What reads its words in VHDL, the part of this number.
    fn reader(&self, number: &usize) -> WordReader {
        let (name, kind) = (number.to_string(), format!("words_{number}_t"));
        WordReader { name, kind, depth: self.depth, bits: self.bits, second: None }
    }
}

impl ExternalMemory {
    /// The files of its words.
    #[must_use]
    pub fn files(&self) -> Vec<RomFile> {
        self.parts.iter().map(|part| part.file.clone()).collect()
    }

    /// Its text in a language, for the core with these texts.
    ///
    /// # Errors
    /// If the template cannot be filled in.
    pub fn emit(&self, language: Language, core: &Texts) -> Result<String, Error> {
        let files = self.files();
        let text = match language {
            Language::Verilog => render(&VerilogMemory { memory: self, rom_files: &files }),
            Language::Vhdl => render(&VhdlMemory { memory: self, core, rom_files: &files }),
        };
        names::checked(language, &core.name, text?)
    }

    /// A module in Verilog of what a core with these texts or one around it is, `name`, with these ports, and of this
    /// memory: its ports are those that are no memory's outside. It is called as [`ExternalMemory::closed_name`] says.
    ///
    /// # Errors
    /// If the template cannot be filled in.
    pub fn closed(&self, name: &str, ports: &[Port]) -> Result<String, Error> {
        let is_own =
            |port: &&Port| self.parts.iter().any(|part| part.port.ports().iter().any(|own| own.name == port.name));
        let (own, shown): (Vec<&Port>, Vec<&Port>) = ports.iter().partition(is_own);
        let shown: Vec<Port> = shown.into_iter().cloned().collect();
        let own = own.into_iter().map(|port| port.name.clone()).collect();
        let declarations = verilog::declarations(&shown);
        let shown = shown.into_iter().map(|port| port.name).collect();
        render(&Closed { memory: self, name, declarations, shown, own })
    }

    /// The name of such a module.
    #[must_use]
    pub fn closed_name(name: &str) -> String {
        format!("{name}_closed")
    }

    /// The type of a vector of a core's port in VHDL.
    fn vector(core: &Texts, bits: u32) -> String {
        format!("{}({} downto 0)", core.vhdl_ports.vector("unsigned"), bits - 1)
    }
}

#[derive(Template)]
#[template(path = "testbench/memory.v", escape = "none")]
struct VerilogMemory<'a> {
    memory: &'a ExternalMemory,
    rom_files: &'a [RomFile],
}

#[derive(Template)]
#[template(path = "testbench/memory.vhd", escape = "none")]
struct VhdlMemory<'a> {
    memory: &'a ExternalMemory,
    core: &'a Texts,
    rom_files: &'a [RomFile],
}

#[derive(Template)]
#[template(path = "cosim/closed.v", escape = "none")]
struct Closed<'a> {
    memory: &'a ExternalMemory,
    name: &'a str,
    declarations: Vec<Declaration>,
    /// The ports that it has.
    shown: Vec<String>,
    /// Those that the memory is connected to.
    own: Vec<String>,
}

impl VhdlMemory<'_> {
    /// An address as a number.
    fn address(&self, part: &ExternalPart) -> String {
        vhdl::port_number(&part.port.address.name, self.core.vhdl_ports)
    }

    /// The word at the end of the way of the part of this number, counted from 1, as its port takes it.
    fn word(&self, part: &usize) -> String {
        self.core.vhdl_ports.from_bits("unsigned", &format!("way_{part}({})", self.memory.clocks))
    }
}
