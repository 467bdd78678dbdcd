//! From a scheduled datapath to Verilog and VHDL.
//!
//! [`Layout`] says, for both languages at once, what stands in which pipeline stage and under which name; a
//! [`Backend`] writes one expression an operation in its language; the templates in `templates/` arrange them. No
//! arithmetic is decided here: formats and operations come from the datapath.

mod axis;
mod layout;
mod names;
mod testbench;
mod verilog;
mod vhdl;

pub use axis::{Axis, AxisPort, Lane, Packing};
pub use layout::Layout;
pub use testbench::test_bench;

use crate::error::Error;
use crate::number::Format;
use crate::rom::Table;
use crate::spec::{Language, VhdlPorts};

/// What the text of a core needs besides its layout.
#[derive(Clone, Debug)]
pub struct Texts {
    /// The core's name.
    pub name: String,
    /// The lines of the header comment, without a comment marker.
    pub header: Vec<String>,
    /// The ports, in the order of their declaration.
    pub ports: Vec<Port>,
    /// The types of the ports in VHDL.
    pub vhdl_ports: VhdlPorts,
    /// The files that memories are read from, if they are read from files.
    pub rom_files: Vec<RomFile>,
    /// The ports through which memories are written, if they are, each with the file of the memory's words; all of them are among `ports`.
    pub writes: Vec<(WritePort, RomFile)>,
}

/// The ports through which a memory is written at run time.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WritePort {
    /// The memory's place among the tables of the datapath.
    pub memory: usize,
    /// 1 bit: the word is written at the rising edge of clk.
    pub enable: Port,
    /// The address.
    pub address: Port,
    /// The word.
    pub data: Port,
}

impl WritePort {
    /// The write port of a memory: `wr_en`, `wr_addr` and `wr_data` for the coefficients, with the memory's name behind `wr` for another.
    #[must_use]
    pub fn of(memory: usize, table: &Table) -> Self {
        let (prefix, what) = match table.name {
            Table::COEFFICIENTS => ("wr".to_owned(), "the coefficient memory".to_owned()),
            name => (format!("wr_{name}"), format!("the memory {name}")),
        };
        let port = |suffix: &str, format, meaning: String| Port {
            name: format!("{prefix}_{suffix}"),
            direction: Direction::In,
            format,
            meaning,
        };
        let unsigned = |bits: u32| Some(Format::unsigned(bits as i32, 0));
        Self {
            memory,
            enable: port("en", None, format!("write enable: takes {prefix}_data into {what}, whatever ce and rst are")),
            address: port("addr", unsigned(table.address_bits), "address of the word that is written".to_owned()),
            data: port("data", unsigned(table.word_bits()), format!("word for {what}; layout as in its files")),
        }
    }

    /// The three ports, in the order of their declaration.
    #[must_use]
    pub fn ports(&self) -> [&Port; 3] {
        [&self.enable, &self.address, &self.data]
    }
}

/// Which way a port leads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Into the core.
    In,
    /// Out of the core.
    Out,
}

impl Direction {
    /// The word for it in both languages.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::In => "in",
            Self::Out => "out",
        }
    }
}

/// A port of a core.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Port {
    /// Its name.
    pub name: String,
    /// Which way it leads.
    pub direction: Direction,
    /// The format of its codes; `None` for clock, reset, enable and the valid flags, which are a bit that is no number.
    pub format: Option<Format>,
    /// What it is for, as the end of a sentence.
    pub meaning: String,
}

impl Port {
    /// Its format, as a port table says it.
    #[must_use]
    pub fn format_text(&self) -> String {
        self.format.map_or("1 bit".to_owned(), |format| format.to_string())
    }

    /// What a comment in front of its declaration says.
    fn comment(&self) -> String {
        self.format.map_or_else(|| self.meaning.clone(), |format| format!("{format}: {}", self.meaning))
    }
}

/// A file that a memory is read from.
#[derive(Clone, Debug)]
pub struct RomFile {
    /// The memory's name.
    pub memory: &'static str,
    /// The name of the parameter or generic that holds the path.
    pub parameter: String,
    /// The path, relative to the core's directory.
    pub path: String,
}

impl Texts {
    /// The file of a memory, if it is read from one.
    #[must_use]
    pub fn rom_file(&self, memory: &str) -> Option<&RomFile> {
        self.rom_files.iter().find(|file| file.memory == memory)
    }

    /// The ports through which a memory is written, if it is; by its place among the tables.
    #[must_use]
    pub fn write_port(&self, memory: usize) -> Option<&WritePort> {
        self.writes.iter().map(|(port, _)| port).find(|port| port.memory == memory)
    }
}

/// A way to write a core.
pub trait Backend {
    /// The text of the core.
    ///
    /// # Errors
    /// If the template cannot be filled in.
    fn emit(&self, layout: &Layout, texts: &Texts) -> Result<String, Error>;
}

/// The backend for a language.
#[must_use]
pub fn backend(language: Language) -> Box<dyn Backend> {
    match language {
        Language::Verilog => Box::new(verilog::Verilog),
        Language::Vhdl => Box::new(vhdl::Vhdl),
    }
}

/// A port's declaration in one of the languages, and the comment in front of it.
struct Declaration {
    comment: String,
    declaration: String,
}

/// The longest line of generated text.
const LINE: usize = 100;

/// An expression behind `before` characters of its line: on the same line if it fits, else on the next.
fn continued(before: usize, expression: &str) -> String {
    let first = expression.lines().next().unwrap_or_default();
    if before + first.len() + 2 <= LINE { format!(" {expression}") } else { format!("\n        {expression}") }
}

/// The text of a filled-in template, without blank lines before it and with one newline at its end.
///
/// # Errors
/// If the template cannot be filled in.
pub fn render(template: &impl askama::Template) -> Result<String, Error> {
    let text = template.render().map_err(|error| Error::ToolFailed {
        tool: "the template engine".to_owned(),
        what: error.to_string(),
        output: String::new(),
    })?;
    Ok(text.trim().to_owned() + "\n")
}
