//! What the user asked for: TOML and flags, merged into one validated [`CoreSpec`].
//!
//! [`SpecFields`] is what was written, every part optional; [`SpecFields::resolve`] fills in the defaults and
//! checks every value once. Nothing behind [`CoreSpec`] checks again.

mod fields;
mod golden_inputs;
mod method;
mod shader;
mod shininess;
mod widths;

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

pub use fields::SpecFields;
pub(crate) use fields::{check_name, suggest, toml_error};
pub use golden_inputs::GoldenInputs;
pub use method::{Coefficients, Divider, Form, Inside, Memory, Method, Tail};
pub(crate) use shader::unit;
pub use shader::{
    Block, BlockKind, CHANNEL_BITS, Colour, Cosine, Front, LIGHTS, LightColours, Model, Shader, ShaderFields, Surface,
    VECTOR_FRACTION,
};
pub use shininess::{MAX_ROWS, Material, Shininess};
pub use widths::Widths;

use crate::fit::Objective;
use crate::emit::rom::RomFormat;

/// Input fraction bits that are allowed.
pub const INPUT_FRACTION: std::ops::RangeInclusive<u32> = 4..=24;
/// Output fraction bits that are allowed.
pub const OUTPUT_FRACTION: std::ops::RangeInclusive<u32> = 4..=20;
/// The accuracies, in bits, that may be asked for.
pub const ACCURACY: std::ops::RangeInclusive<u32> = 3..=15;
/// Input fraction bits with which one may be: the proof goes over every input code.
pub const ACCURACY_INPUT_FRACTION: std::ops::RangeInclusive<u32> = 8..=20;
/// Fraction bits of a fixed-point shininess that are allowed.
pub const SHININESS_FRACTION: std::ops::RangeInclusive<u32> = 0..=10;
/// Pipeline depths that are allowed.
pub const PIPELINE_DEPTH: std::ops::RangeInclusive<u32> = 1..=64;

/// Bits of `tuser` that are allowed; the first is the default.
pub const TUSER_BITS: std::ops::RangeInclusive<u32> = 1..=64;

/// Address bits of the versine in [`Method::Table`] that are allowed.
pub const TABLE_BITS: std::ops::RangeInclusive<u32> = 2..=14;
/// Address bits of the logarithm's table in [`Method::Harris`] that are allowed, within an octave of the versine.
pub const LOG_BITS: std::ops::RangeInclusive<u32> = 2..=12;
/// Address bits of the exponential's table in [`Method::Harris`] that are allowed.
pub const EXP_BITS: std::ops::RangeInclusive<u32> = 2..=14;

/// What the core is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Operand {
    /// The cosine x, signed Q1.F.
    Cos,
    /// The versine u = 1 - x, unsigned UQ1.F.
    Versine,
}

/// Which codes of the operand's port the core may be given.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum InputRange {
    /// Any: a cosine is signed, Q1.F, and what lies outside [0, 1] is taken to the nearer end.
    Any,
    /// Those in [0, 1]: the port is unsigned, UQ1.F, and nothing is compared. A code above 1 counts as what it is above 1.
    Unit,
}

/// Where the HDL finds the coefficients.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum RomStyle {
    /// In the source.
    Inline,
    /// In a file that is read at elaboration.
    File,
    /// In the source, as the first content of a RAM with a write port.
    Writable,
}

/// A hardware description language.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Language {
    /// Verilog-2005.
    Verilog,
    /// VHDL-2008.
    Vhdl,
}

impl std::fmt::Display for Language {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Verilog => "Verilog",
            Self::Vhdl => "VHDL",
        })
    }
}

/// The types of the vectors among the ports of the VHDL.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum VhdlPorts {
    /// `unsigned` and `signed` of `ieee.numeric_std`.
    #[default]
    Numeric,
    /// `std_logic_vector`, the only vectors that block designs take.
    StdLogic,
}

impl VhdlPorts {
    /// The type of a port whose codes are of the numeric type `sign`.
    #[must_use]
    pub fn vector(self, sign: &'static str) -> &'static str {
        match self {
            Self::Numeric => sign,
            Self::StdLogic => "std_logic_vector",
        }
    }

    /// An expression of the type `std_logic_vector` as a port whose codes are of the numeric type `sign` takes it.
    #[must_use]
    pub fn from_bits(self, sign: &str, bits: &str) -> String {
        match self {
            Self::Numeric => format!("{sign}({bits})"),
            Self::StdLogic => bits.to_owned(),
        }
    }
}

/// How many registers lie between input and output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pipeline {
    /// Registers before and after each multiplier and two behind the ROM.
    Auto,
    /// As many as this.
    Depth(u32),
}

/// A core, every default resolved and every value checked.
#[derive(Clone, Debug, PartialEq)]
pub struct CoreSpec {
    /// The name of the core, its module and its files.
    pub name: String,
    /// What the core is: the lobe that the other keys describe, or a shader around it.
    pub block: Block,
    /// The method.
    pub method: Method,
    /// The form in which it is evaluated.
    pub form: Form,
    /// The level Q of the cubic's point of contact, where the method has one ([`Method::has_level`]).
    pub q: f64,
    /// The level G of the three-point cubic's second point.
    pub g: f64,
    /// What the cubic is past its minimum ([`Method::has_tail`]).
    pub tail: Tail,
    /// The polynomial inside a power ([`Method::has_inside`]).
    pub inside: Inside,
    /// A of a core that is only as accurate as `2^-A` ([`Method::has_accuracy`]); `None`: below one ulp of the output.
    pub accuracy: Option<u32>,
    /// Where its tables are meant to lie.
    pub memory: Memory,
    /// How the core divides ([`Method::divides`]).
    pub divider: Divider,
    /// Address bits of the versine in [`Method::Table`].
    pub table_bits: u32,
    /// Address bits of the logarithm's table in [`Method::Harris`], within an octave of the versine.
    pub log_bits: u32,
    /// Address bits of the exponential's table in [`Method::Harris`].
    pub exp_bits: u32,
    /// Where the coefficients come from ([`Method::coefficients`]).
    pub coefficients: Coefficients,
    /// What fitted coefficients make least.
    pub objective: Objective,
    /// The shininesses that the core serves.
    pub shininess: Shininess,
    /// F: fraction bits of the input.
    pub input_fraction: u32,
    /// G: fraction bits of the output.
    pub output_fraction: u32,
    /// What the core is given.
    pub operand: Operand,
    /// Which codes of it the core may be given.
    pub input_range: InputRange,
    /// Where the HDL finds the coefficients.
    pub rom: RomStyle,
    /// The ROM files that are written beside the HDL; always holds [`RomFormat::Mem`].
    pub rom_formats: Vec<RomFormat>,
    /// The pipeline's depth.
    pub pipeline: Pipeline,
    /// The languages that are written.
    pub languages: Vec<Language>,
    /// The types of the VHDL's ports.
    pub vhdl_ports: VhdlPorts,
    /// The bits of `tuser`, 1 to 64, if a wrapper with AXI4-Stream interfaces is written around the core.
    pub axi_stream: Option<u32>,
    /// Inputs that the golden vectors hold besides those that are chosen for them.
    pub golden_inputs: GoldenInputs,
}

impl CoreSpec {
    /// The spec as written to `core.toml`: every default resolved.
    #[must_use]
    pub fn to_toml(&self) -> String {
        SpecFields::from_spec(self).to_toml()
    }

    /// Whether the coefficients are fitted.
    #[must_use]
    pub fn is_fitted(&self) -> bool {
        self.coefficients == Coefficients::Minimax && !self.method.coefficients().is_empty()
    }

    /// The first 16 hexadecimal digits of the SHA-256 of [`CoreSpec::to_toml`].
    #[must_use]
    pub fn digest(&self) -> String {
        hex(&Sha256::digest(self.to_toml()))[..16].to_owned()
    }

    /// The flags that differ from the defaults, each with its value: `--key value`. No flag gives a material's colours.
    #[must_use]
    pub fn flags(&self) -> Vec<String> {
        SpecFields::from_spec(self).flags()
    }

    /// The command that generates this core: the flags that differ from the defaults, or `core.toml` itself
    /// where they would fill more than a line.
    #[must_use]
    pub fn command(&self) -> String {
        let command = format!("brdfgen generate {}", self.flags().join(" "));
        // No flag gives a material's colours.
        let coloured = match (&self.shininess, self.block.shader()) {
            (Shininess::Materials(materials), Some(_)) => materials.iter().any(|material| !material.is_plain()),
            _ => false,
        };
        if command.len() <= 88 && !coloured { command } else { "brdfgen generate core.toml".to_owned() }
    }
}

/// Lower-case hexadecimal digits of `bytes`.
#[must_use]
pub fn hex(bytes: &[u8]) -> String {
    use std::fmt::Write;
    bytes.iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}
