//! The sequencer around a core that takes the lights of a sample in sequence: it adds up what the core gives for each
//! clock's lights until the sample's last, and rounds the sum to codes once.
//!
//! The core itself keeps nothing from one clock to the next, so that all that is proved and measured of a core is of
//! this one too; what remembers is here, in one adder and one register a channel.

use askama::Template;

use super::{Declaration, Port, Texts, names, render, verilog, vhdl};
use crate::block::CHANNELS;
use crate::block::lights::Sums;
use crate::core::{Direction, Role};
use crate::fixed::Format;
use crate::platform::error::Error;
use crate::spec::{Language, VhdlPorts};

/// A port of the core that a signal is connected to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Connected {
    /// Its name, and the signal's.
    pub name: String,
    /// Its bits, or none if it is a bit and no vector.
    pub bits: Option<u32>,
    /// Whether its codes have a sign.
    pub signed: bool,
}

impl Connected {
    pub(super) fn of(port: &Port) -> Self {
        let signed = port.format.is_some_and(|format| format.signed);
        Self { name: port.name.clone(), bits: port.format.map(Format::width), signed }
    }

    /// The type of the port in VHDL, of a core with these texts.
    pub(super) fn vhdl(&self, core: &Texts) -> String {
        let vector = core.vhdl_ports.vector(if self.signed { "signed" } else { "unsigned" });
        self.bits.map_or("std_logic".to_owned(), |bits| format!("{vector}({} downto 0)", bits - 1))
    }

    /// 0 as its value in VHDL.
    pub(super) fn vhdl_zero(&self) -> &'static str {
        if self.bits.is_some() { "(others => '0')" } else { "'0'" }
    }

    /// Its bits in Verilog, `[high:0]`, and a space.
    #[must_use]
    pub fn range(&self) -> String {
        self.bits.map_or(String::new(), |bits| format!("[{}:0] ", bits - 1))
    }

    /// Its highest bit.
    fn high(&self) -> u32 {
        self.bits.map_or(0, |bits| bits - 1)
    }
}

/// A core's sequencer.
#[derive(Clone, Debug)]
pub struct Sequencer {
    /// Its name: that of the core and `_lights`.
    pub name: String,
    /// The lines of the header comment, without a comment marker.
    pub header: Vec<String>,
    /// Its ports, in the order of their declaration.
    pub ports: Vec<Port>,
    /// What comes out of the core.
    pub sums: Sums,
    /// The core's latency.
    pub core_latency: u32,
    /// Its own from a sample's last lights on, that of the core included.
    pub latency: u32,
    inputs: Vec<Connected>,
    outputs: Vec<Connected>,
    /// The addresses in memories outside of the core.
    addresses: Vec<Connected>,
}

/// A channel in the templates.
struct Channel {
    c: char,
    /// The ambient light in the sum's bits, in Verilog and in VHDL, if there is any.
    ambient: String,
    vhdl_ambient: String,
    /// The code as the port takes it, in VHDL.
    vhdl_code: String,
}

impl Sequencer {
    /// The sequencer with these ports around a core with those, without a header.
    #[must_use]
    pub fn new(name: String, core: &Texts, ports: Vec<Port>, sums: Sums, [core_latency, latency]: [u32; 2]) -> Self {
        let outputs = core.ports.iter().filter(|port| port.carries(Direction::Out));
        // Those of memories as well.
        let is_input = |port: &&Port| port.role.name().is_none() && port.role.direction() == Direction::In;
        let inputs = core.ports.iter().filter(is_input);
        let addresses = core.ports.iter().filter(|port| port.role == Role::Address);
        Self {
            name,
            header: Vec::new(),
            ports,
            sums,
            core_latency,
            latency,
            inputs: inputs.map(Connected::of).collect(),
            outputs: outputs.map(Connected::of).collect(),
            addresses: addresses.map(Connected::of).collect(),
        }
    }

    /// The ports of the core that are its own, but for clock, reset, enable and valid.
    #[must_use]
    pub fn driven(&self) -> &[Connected] {
        &self.inputs
    }

    /// Those that are its own as well.
    #[must_use]
    pub fn shared(&self) -> Vec<&Connected> {
        self.inputs.iter().filter(|port| port.name != Role::IN_SET).collect()
    }

    /// Whether it changes the set of texels that the core looks samples up in.
    #[must_use]
    pub fn swaps(&self) -> bool {
        self.inputs.iter().any(|port| port.name == Role::IN_SET)
    }

    /// The ports that lead through it from the core.
    #[must_use]
    pub fn addresses(&self) -> &[Connected] {
        &self.addresses
    }

    /// What comes out of the core, but for its valid.
    #[must_use]
    pub fn core_outputs(&self) -> &[Connected] {
        &self.outputs
    }

    fn channels(&self, core: &Texts) -> [Channel; 3] {
        let Sums { frac_bits, ambient, .. } = self.sums;
        CHANNELS.map(|c| {
            let (ambient, vhdl_ambient) = match ambient.map(|bits| frac_bits - bits) {
                None => Default::default(),
                Some(0) => (format!("{{1'b0, ambient_{c}}}"), format!("'0' & ambient_{c}")),
                Some(zeros) => (
                    format!("{{1'b0, ambient_{c}, {zeros}'d0}}"),
                    format!("'0' & ambient_{c} & ({} downto 0 => '0')", zeros - 1),
                ),
            };
            let vhdl_code = match core.vhdl_ports {
                VhdlPorts::Numeric => format!("code_{c}"),
                VhdlPorts::StdLogic => format!("std_logic_vector(code_{c})"),
            };
            Channel { c, ambient, vhdl_ambient, vhdl_code }
        })
    }

    /// A name of the core's ports, followed by spaces up to the length of the longest.
    fn padded(&self, name: &str) -> String {
        let width = self
            .inputs
            .iter()
            .chain(&self.outputs)
            .chain(&self.addresses)
            .map(|port| port.name.len())
            .fold("out_valid".len(), usize::max);
        format!("{name:<width$}")
    }

    /// The text of the sequencer in a language; `core` are the core's.
    ///
    /// # Errors
    /// If the template cannot be filled in.
    pub fn emit(&self, language: Language, core: &Texts) -> Result<String, Error> {
        let (f, bits, channels) = (self.sums.frac_bits, self.sums.channel_bits, self.channels(core));
        let text = match language {
            Language::Verilog => {
                let ports = verilog::declarations(&self.ports);
                render(&VerilogSequencer { sequencer: self, core, ports, channels, f, bits })
            }
            Language::Vhdl => {
                let ports = vhdl::declarations(&self.ports, core.vhdl_ports);
                render(&VhdlSequencer { sequencer: self, core, ports, channels, f, bits })
            }
        };
        names::checked(language, &core.name, text?)
    }
}

#[derive(Template)]
#[template(path = "verilog/lights.v", escape = "none")]
struct VerilogSequencer<'a> {
    sequencer: &'a Sequencer,
    core: &'a Texts,
    ports: Vec<Declaration>,
    channels: [Channel; 3],
    f: u32,
    bits: u32,
}

#[derive(Template)]
#[template(path = "vhdl/lights.vhd", escape = "none")]
struct VhdlSequencer<'a> {
    sequencer: &'a Sequencer,
    core: &'a Texts,
    ports: Vec<Declaration>,
    channels: [Channel; 3],
    f: u32,
    bits: u32,
}
