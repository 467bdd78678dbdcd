//! From a scheduled datapath to Verilog and VHDL.
//!
//! [`Layout`] says, for both languages at once, what stands in which pipeline stage and under which name; a
//! [`Backend`] writes one expression an operation in its language; the templates in `templates/` arrange them. No
//! arithmetic is decided here: formats and operations come from the datapath.

mod axis;
mod c;
mod external;
mod light_table;
pub(crate) mod markdown;
mod names;
pub mod package;
pub mod rom;
mod sequencer;
mod testbench;
mod verilog;
mod vhdl;

pub use axis::{Axis, AxisPort, Lane, Packing};
pub use c::LightFunction;
pub use external::{ExternalMemory, ExternalPart};
pub use light_table::LightTable;
pub use sequencer::{Connected, Sequencer};
pub use testbench::{Wrapper, test_bench};

use crate::core::{Direction, Layout, Port, ReadPort, Role, WritePort};
use crate::platform::error::Error;
use crate::spec::{Language, MAX_ROWS, VhdlPorts};

// A file holds the largest table that a spec can ask for.
const _: () = assert!(MAX_ROWS <= rom::MAX_DEPTH);

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
    /// The ports through which memories are written, if they are, each with the file of the memory's words; all of them
    /// are among `ports`.
    pub writes: Vec<(WritePort, RomFile)>,
    /// The sets of words of the memories that are written.
    pub sets: u32,
    /// The ports through which memories outside of the core are read; all of them are among `ports`.
    pub reads: Vec<ReadPort>,
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

    /// The sets of words that a memory holds; by its place among the tables.
    #[must_use]
    pub fn sets_of(&self, memory: usize) -> u32 {
        if self.write_port(memory).is_some() { self.sets } else { 1 }
    }

    /// The last stage in which a set of words is chosen; none where there is one set.
    fn last_set_stage(&self, layout: &Layout) -> Option<u32> {
        let chosen = self.writes.iter().filter(|_| self.sets > 1);
        chosen.filter_map(|(port, _)| Some(layout.read(port.memory)?.stage)).max()
    }

    /// The ports through which a memory outside of the core is read; by its place among the tables.
    #[must_use]
    pub fn read_port(&self, memory: usize) -> Option<&ReadPort> {
        self.reads.iter().find(|port| port.memory == memory)
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
