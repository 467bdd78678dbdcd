//! The ports of a core.

use crate::fixed::{Format, Table};

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
    /// The write port of a memory of so many sets of words: `wr_en`, `wr_addr` and `wr_data` for the coefficients, with
    /// the memory's name behind `wr` for another.
    #[must_use]
    pub fn of(memory: usize, table: &Table, sets: u32) -> Self {
        let (prefix, what) = match table.name {
            Table::COEFFICIENTS => ("wr".to_owned(), "the coefficient memory".to_owned()),
            name => (format!("wr_{name}"), format!("the memory {name}")),
        };
        let port = |suffix: &str, format, meaning: String| Port {
            name: format!("{prefix}_{suffix}"),
            role: Role::Write,
            format,
            meaning,
        };
        let address = match sets {
            1 => "address of the word that is written",
            _ => "address of the word that is written, the set in the leading bit",
        };
        let unsigned = |bits: u32| Some(Format::unsigned(bits as i32, 0));
        Self {
            memory,
            enable: port("en", None, format!("write enable: takes {prefix}_data into {what}, whatever ce and rst are")),
            address: port("addr", unsigned(table.address_bits + sets.ilog2()), address.to_owned()),
            data: port("data", unsigned(table.word_bits()), format!("word for {what}; layout as in its files")),
        }
    }

    /// The three ports, in the order of their declaration.
    #[must_use]
    pub fn ports(&self) -> [&Port; 3] {
        [&self.enable, &self.address, &self.data]
    }
}

/// The ports through which a memory outside of the core is read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReadPort {
    /// The memory's place among the tables of the datapath.
    pub memory: usize,
    /// The address, from a register.
    pub address: Port,
    /// The word, into a register.
    pub data: Port,
}

impl ReadPort {
    /// The read port of a memory whose words come so many enabled clocks behind their addresses.
    #[must_use]
    pub fn of(memory: usize, table: &Table, clocks: u32) -> Self {
        let name = table.name;
        let port = |suffix: &str, role, bits: u32, meaning: String| Port {
            name: format!("{name}_{suffix}"),
            role,
            format: Some(Format::unsigned(bits as i32, 0)),
            meaning,
        };
        let later = if clocks == 1 { "clock".to_owned() } else { format!("{clocks} clocks") };
        let word = format!("word at {name}_addr, the enabled {later} later; layout as in its files");
        Self {
            memory,
            address: port("addr", Role::Address, table.address_bits, format!("address in the memory {name}")),
            data: port("data", Role::Word, table.word_bits(), word),
        }
    }

    /// Both ports, in the order of their declaration.
    #[must_use]
    pub fn ports(&self) -> [&Port; 2] {
        [&self.address, &self.data]
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

/// What a port is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// The clock.
    Clock,
    /// The reset.
    Reset,
    /// The clock enable.
    Enable,
    /// Whether the inputs are to be taken.
    InValid,
    /// Whether the inputs are a sample's last.
    InLast,
    /// Whether the inputs are taken if they are to be.
    InReady,
    /// What selects the shininess or the material.
    Index,
    /// What the result is computed from.
    Operand,
    /// A part of a memory's write port.
    Write,
    /// Which set of texels is looked up.
    Set,
    /// Whether a sample is the last that is looked up in the one set of texels.
    Swap,
    /// The set of texels that samples which are taken are looked up in.
    SetShown,
    /// The address in a memory outside of the core.
    Address,
    /// The word of a memory outside of the core.
    Word,
    /// Whether the outputs are a result.
    OutValid,
    /// A result.
    Result,
}

impl Role {
    /// The port of a core with two sets of texels that says which is looked up.
    pub(crate) const IN_SET: &str = "in_set";
    /// Those of which every core has one port, with its name.
    pub(super) const NAMED: [(Self, &str); 5] = [
        (Self::Clock, "clk"),
        (Self::Reset, "rst"),
        (Self::Enable, "ce"),
        (Self::InValid, "in_valid"),
        (Self::OutValid, "out_valid"),
    ];

    /// The name that its port has in every core, if it has one.
    #[must_use]
    pub fn name(self) -> Option<&'static str> {
        Self::NAMED.into_iter().find(|(role, _)| *role == self).map(|(_, name)| name)
    }

    /// The role of a port of this name, where every core has one.
    #[must_use]
    pub fn of(name: &str) -> Option<Self> {
        Self::NAMED.into_iter().find(|(_, known)| *known == name).map(|(role, _)| role)
    }

    /// Which way its ports lead.
    #[must_use]
    pub fn direction(self) -> Direction {
        if matches!(self, Self::InReady | Self::OutValid | Self::Result | Self::Address | Self::SetShown) {
            Direction::Out
        } else {
            Direction::In
        }
    }
}

/// A port of a core.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Port {
    /// Its name.
    pub name: String,
    /// What it is for; that says which way it leads.
    pub role: Role,
    /// The format of its codes; `None` for clock, reset, enable and the valid flags, which are a bit that is no number.
    pub format: Option<Format>,
    /// What it is for, as the end of a sentence.
    pub meaning: String,
}

impl Port {
    /// Whether it carries a number of a vector in this direction, as no memory's port does.
    #[must_use]
    pub fn carries(&self, direction: Direction) -> bool {
        matches!(self.role, Role::Index | Role::Operand | Role::Result) && self.role.direction() == direction
    }

    /// Whether it is of a memory, written or outside of the core, whatever samples come.
    #[must_use]
    pub fn is_memory(&self) -> bool {
        matches!(self.role, Role::Write | Role::Address | Role::Word | Role::SetShown)
    }

    /// Its format, as a port table says it.
    #[must_use]
    pub fn format_text(&self) -> String {
        self.format.map_or("1 bit".to_owned(), |format| format.to_string())
    }

    /// What a comment in front of its declaration says.
    pub(crate) fn comment(&self) -> String {
        self.format.map_or_else(|| self.meaning.clone(), |format| format!("{format}: {}", self.meaning))
    }
}
