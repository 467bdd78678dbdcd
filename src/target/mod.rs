//! The families of FPGAs, one file each: what a family is called, what it has, which tools serve it and how its cells
//! count. All else asks the list here; only this module tells families apart.

mod cyclonev;
mod ecp5;
mod gowin;
mod ice40;
mod nexus;
mod xc7;

use std::collections::BTreeMap;
use std::ops::Deref;

use clap::ValueEnum;
use clap::builder::PossibleValue;
use serde::{Deserialize, Serialize};
use serde_json::Value;

pub use ecp5::pack::{Packed, REVISION as PACK_REVISION, pack};

use crate::platform::error::Error;
use crate::platform::tool::Tool;

/// Makes the list of families: a family's name as a type, and the file that describes it.
macro_rules! families {
    ($($family:ident: $file:ident,)*) => {
        /// A family of FPGAs; it stands for its [`Description`].
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
        #[serde(rename_all = "lowercase")]
        #[allow(missing_docs)]
        pub enum Family {
            /// The first is meant where none is named.
            #[default]
            $($family,)*
        }

        impl Family {
            /// All of them, in the order in which they are listed and sorted.
            pub const ALL: &'static [Self] = &[$(Self::$family,)*];

            /// What it is.
            #[must_use]
            pub const fn description(self) -> &'static Description {
                match self {
                    $(Self::$family => &$file::FAMILY,)*
                }
            }
        }
    };
}

families! {
    Ecp5: ecp5,
    Ice40: ice40,
    Gowin: gowin,
    Xc7: xc7,
    Nexus: nexus,
    CycloneV: cyclonev,
}

/// What a family is, has and is served by.
#[derive(Debug)]
pub struct Description {
    /// Its name as the user spells it and files hold it: that of its entry in the list, in lower case.
    pub name: &'static str,
    /// Its name in headings.
    pub title: &'static str,
    /// The device in a few words, for a list of families.
    pub brief: &'static str,
    /// What a user has to know of it: a sentence without a stop.
    pub about: &'static str,
    /// The device, its package and its speed grade.
    pub device: &'static str,
    /// Yosys' command, with its options.
    pub yosys: &'static str,
    /// An option more where the core alone is synthesised, which has no pads.
    pub padless: &'static str,
    /// How its cells count.
    pub cells: Cells,
    /// Its DSP blocks.
    pub dsp: Dsp,
    /// Its block RAMs.
    pub bram: Bram,
    /// How a core is placed; `None` where only cells are counted.
    pub placement: Option<Placement>,
    /// How registers are moved into the blocks, where Yosys leaves them outside.
    pub pack: Option<Pack>,
    /// Models of the cells, with which a netlist is simulated.
    pub models: Option<Models>,
}

/// Types of cells, with what one counts as. A type that ends in `*` stands for all that begin so; the first that fits a
/// cell counts.
pub type Kinds = &'static [(&'static str, u32)];

/// Which cells count as what.
#[derive(Debug)]
pub struct Cells {
    /// Look-up tables, shift registers made of one included.
    pub lut: Kinds,
    /// Cells of carry chains.
    pub carry: Kinds,
    /// What other cells take of look-up tables.
    pub used_up: Kinds,
    /// Flip-flops.
    pub ff: Kinds,
    /// Multipliers, in parts of a DSP block ([`Dsp::parts`]).
    pub dsp: Kinds,
    /// Block RAMs.
    pub bram: Kinds,
}

/// What Yosys makes of multiplications, as the family's script calls `mul2dsp`.
#[derive(Debug)]
pub struct Dsp {
    /// The operands that a multiplier takes, wider first, and the parts of a block that it is, smaller ones first: the
    /// first that holds a product is taken, the last for parts of one that is wider.
    pub shapes: &'static [([u32; 2], u32)],
    /// The parts that a block is counted in.
    pub parts: u32,
    /// The bits that a sign takes of an unsigned operand.
    pub sign_bits: u32,
    /// The fewest bits of an operand that goes into a block.
    pub least_operand: u32,
    /// The fewest bits of a product that goes into a block.
    pub least_product: u32,
}

/// What Yosys makes of memories, as the family's script calls `memory_libmap`.
#[derive(Debug)]
pub struct Bram {
    /// The words and the bits of a word that a block can have, the shallowest last.
    pub shapes: &'static [(u32, u32)],
    /// The bits of a memory in LUTs that cost as much as a block: more of them go into a block. A bit in LUTs costs
    /// 1/16, a block what its library says.
    pub worth: u32,
    /// The registers of a word that a block has inside.
    pub registers: u32,
}

/// How nextpnr places a core.
#[derive(Debug)]
pub struct Placement {
    /// The programs that do it: the first that is installed.
    pub tools: &'static [Tool],
    /// The clock that is asked for unless another is wanted, in MHz.
    pub target_mhz: f64,
    /// The device, and how it is to be placed.
    pub arguments: &'static [&'static str],
    /// Whether the core stands between two shift registers, as it has more ports than the device has pins.
    pub shell: bool,
    /// Files beside the netlist: names and texts.
    pub files: &'static [(&'static str, &'static str)],
}

/// How registers are moved into blocks.
#[derive(Debug)]
pub struct Pack {
    /// What Yosys does for it before it maps flip-flops.
    pub before_ffs: &'static str,
    /// What is done to a module of the netlist.
    pub run: fn(&mut Value, &str) -> Result<Packed, Error>,
}

/// Models of cells.
#[derive(Debug)]
pub struct Models {
    /// Their Verilog.
    pub verilog: &'static str,
    /// What a run with them is called.
    pub mode: &'static str,
}

/// The shapes that Yosys knows of a block RAM of 18 kbit.
const SHAPES_OF_18_KBIT: &[(u32, u32)] = &[(16_384, 1), (8192, 2), (4096, 4), (2048, 9), (1024, 18), (512, 36)];

impl Deref for Family {
    type Target = Description;

    fn deref(&self) -> &'static Description {
        self.description()
    }
}

impl ValueEnum for Family {
    fn value_variants<'a>() -> &'a [Self] {
        Self::ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        Some(PossibleValue::new(self.name).help(self.about))
    }
}

impl Family {
    /// The clock that a placement is asked for unless another is wanted, in MHz; 150 where nothing is placed and nobody
    /// asks.
    #[must_use]
    pub fn target_mhz(self) -> f64 {
        self.placement.as_ref().map_or(150.0, |placement| placement.target_mhz)
    }

    /// The names of those that are so, in the order of the list.
    pub fn names(is: impl Fn(&Description) -> bool) -> Vec<&'static str> {
        Self::ALL.iter().filter(|family| is(family)).map(|family| family.description().name).collect()
    }
}

/// How many cells count as one of these.
#[must_use]
pub fn count(kinds: Kinds, cells: &BTreeMap<String, u32>) -> u32 {
    let fits =
        |kind: &str, pattern: &str| pattern.strip_suffix('*').map_or(kind == pattern, |start| kind.starts_with(start));
    let weight = |kind: &str| kinds.iter().find(|(pattern, _)| fits(kind, pattern)).map_or(0, |&(_, weight)| weight);
    cells.iter().map(|(kind, count)| count * weight(kind)).sum()
}

impl Dsp {
    /// The widest operands of a multiplier, the wider first.
    #[must_use]
    pub fn widest(&self) -> [u32; 2] {
        self.largest().0
    }

    /// The widest operands of one sign, the wider first.
    #[must_use]
    pub fn operands(&self, signed: bool) -> [u32; 2] {
        self.widest().map(|bits| bits - if signed { 0 } else { self.sign_bits })
    }

    fn largest(&self) -> &([u32; 2], u32) {
        self.shapes.last().expect("a family has multipliers")
    }

    /// The multipliers of a product of operands of so many bits, the wider first, and the parts of a block that they
    /// are together.
    #[must_use]
    pub fn multipliers(&self, operands: [u32; 2], signed: bool) -> [u32; 2] {
        let [wide, narrow] = operands;
        if narrow < self.least_operand || wide + narrow < self.least_product {
            return [0, 0];
        }
        let [a, b] = operands.map(|bits| bits + if signed { 0 } else { self.sign_bits });
        let holds = |&&([widest, other], _): &&([u32; 2], u32)| a <= widest && b <= other;
        let &(widest, parts) = self.shapes.iter().find(holds).unwrap_or_else(|| self.largest());
        // What is left over by whole parts is a part of its own, unless it is too narrow for a block.
        let split = |bits: u32, most: u32| {
            if bits <= most {
                return 1;
            }
            let whole = (bits - 1 - self.sign_bits) / (most - self.sign_bits);
            whole + u32::from(bits - whole * (most - self.sign_bits) >= self.least_operand)
        };
        let count = split(a, widest[0]) * split(b, widest[1]);
        [count, count * parts]
    }
}

impl Bram {
    /// The blocks of a memory that is read through a register; 0 where look-up tables are cheaper.
    #[must_use]
    pub fn blocks(&self, words: u32, bits: u32) -> u32 {
        let needed = self.shapes.iter().map(|&(most, word)| words.div_ceil(most) * bits.div_ceil(word)).min();
        needed.filter(|&needed| needed * self.worth < words * bits).unwrap_or(0)
    }
}

/// What cores are made for before their family is known: a core's text, with its registers, is one for all families.
const COMMON: &Description = &ecp5::FAMILY;
/// A memory of more bits than these is expected to become a block RAM.
pub const MOST_LOGIC_BITS: u64 = COMMON.bram.worth as u64;
/// So is one with as wide an address, which other tools may put into a block.
const BLOCK_ADDRESS_BITS: u32 = 7;
/// The registers of its word that a block RAM has inside.
pub const BLOCK_REGISTERS: u32 = COMMON.bram.registers;
/// The address of the shallowest block RAM.
pub const BLOCK_RAM_ADDRESS_BITS: u32 = COMMON.bram.shapes[COMMON.bram.shapes.len() - 1].0.ilog2();
/// What a DSP block and a block RAM count as, in LUTs.
pub const LUTS_OF_A_BLOCK: [u32; 2] = ecp5::LUTS_OF_A_BLOCK;

/// Whether a memory is expected to become a block RAM, with some family's tools.
#[must_use]
pub fn is_block(address_bits: u32, word_bits: u32) -> bool {
    address_bits >= BLOCK_ADDRESS_BITS || u64::from(word_bits) << address_bits > MOST_LOGIC_BITS
}

/// A build of nextpnr for the family `purpose` ends with.
const fn nextpnr(program: &'static str, package: &'static str, pypi: &'static str, purpose: &'static str) -> Tool {
    Tool { program, version_flag: "--version", package, pypi, purpose }
}
