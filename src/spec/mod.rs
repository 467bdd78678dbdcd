//! What the user asked for: TOML and flags, merged into one validated [`CoreSpec`].
//!
//! [`SpecFields`] is what was written, every part optional; [`SpecFields::resolve`] fills in the defaults and
//! checks every value once. Nothing behind [`CoreSpec`] checks again.

mod fields;
mod flags;
mod image;
mod image_size;
mod name;
mod port_codes;
mod reference;
mod reflectance;
mod resolve;

use std::path::Path;
use std::str::FromStr;

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

pub use crate::block::image::{FrontEnd, ImageSource, ImageSpec, TexelMemory};
pub use crate::block::lights::LightSource;
pub(crate) use crate::block::shader::unit;
pub use crate::block::shader::{
    CHANNEL_BITS, Cosine, Front, LIGHTS, LightColours, Model, Shader, ShaderFields, Surface, VECTOR_FRACTION,
};
pub use crate::block::{Block, BlockKind, LobeSpec};
pub use crate::datapath::products::DspBlocks;
pub use crate::datapath::schedule::{PIPELINE_DEPTH, Pipeline};
pub use crate::fit::Inside;
pub use crate::method::cubic::Tail;
pub use crate::method::divide::Divider;
pub use crate::method::log_exp::Memory;
pub use crate::method::{
    Coefficients, Colour, Configured, Form, INPUT_FRACTION, InputRange, Interface, MAX_ROWS, Material, MethodName,
    OUTPUT_FRACTION, Operand, Shininess,
};
pub use fields::SpecFields;
pub(crate) use fields::{suggest, toml_error};
pub use image::ImageFormName;
pub(crate) use name::check_name;
pub use port_codes::PortCodes;
pub use reference::reference;
pub use reflectance::{DIRECTORY as REFLECTANCE_DIRECTORY, Parameters, ReflectanceFields};
pub(crate) use reflectance::{Named, Written, check_exposure};

use crate::emit::rom::RomFormat;
use crate::platform::error::Error;

/// Fraction bits of a fixed-point shininess that are allowed.
pub const SHININESS_FRACTION: std::ops::RangeInclusive<u32> = 0..=10;

/// Bits of `tuser` that are allowed; the first is the default.
pub const TUSER_BITS: std::ops::RangeInclusive<u32> = 1..=64;

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

/// A core, every default resolved and every value checked.
///
/// ```
/// let spec: brdfgen::Spec = "method = 'cubic'\nshininess = '1..=1000'\ninput_fraction = 12".parse()?;
/// assert_eq!(spec.name, "cubic");
/// assert_eq!(spec.to_toml().parse::<brdfgen::Spec>()?, spec);
/// assert_eq!(spec.row_of(5.0)?, 4);
/// # Ok::<(), brdfgen::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct CoreSpec {
    /// The name of the core, its module and its files.
    pub name: String,
    /// What the core is.
    pub block: Block,
    /// Where the HDL finds the coefficients.
    pub rom: RomStyle,
    /// Enabled clocks from a texel's address to the texel where an image-based block's texels lie outside of the core.
    pub texel_latency: Option<u32>,
    /// Whether an image-based block holds two sets of texels, of which the one that is not looked up is written.
    pub swap: bool,
    /// The ROM files that are written beside the HDL; always holds [`RomFormat::Mem`].
    pub rom_formats: Vec<RomFormat>,
    /// The pipeline's depth.
    pub pipeline: Pipeline,
    /// What products that are wider than a DSP block are built of.
    pub dsp: DspBlocks,
    /// The languages that are written.
    pub languages: Vec<Language>,
    /// The types of the VHDL's ports.
    pub vhdl_ports: VhdlPorts,
    /// The bits of `tuser`, 1 to 64, if a wrapper with AXI4-Stream interfaces is written around the core.
    pub axi_stream: Option<u32>,
    /// Where lights in sequence come from, if they do.
    pub light_source: LightSource,
    /// The codes of the lights of a table that is not written, of one light's ports each.
    pub light_records: PortCodes,
    /// Inputs that the golden vectors hold besides those that are chosen for them.
    pub golden_inputs: PortCodes,
}

impl FromStr for CoreSpec {
    type Err = Error;

    /// Reads TOML text.
    fn from_str(text: &str) -> Result<Self, Error> {
        SpecFields::parse(text, "the spec")?.resolve()
    }
}

impl CoreSpec {
    /// The language of the core's text that is compiled to a program: Verilog, or VHDL where it has no Verilog.
    #[must_use]
    pub(crate) fn compiled_language(&self) -> Language {
        if self.languages.contains(&Language::Verilog) { Language::Verilog } else { Language::Vhdl }
    }

    /// Reads a TOML file, or the one in a generated core's directory.
    ///
    /// # Errors
    /// A file that cannot be read, text that is no spec, or a value that is not allowed.
    pub fn read(path: &Path) -> Result<Self, Error> {
        SpecFields::read(path)?.resolve()
    }

    /// The spec as written to `core.toml`: every default resolved.
    #[must_use]
    pub fn to_toml(&self) -> String {
        SpecFields::from_spec(self).to_toml()
    }

    /// The first 16 hexadecimal digits of the SHA-256 of [`CoreSpec::to_toml`].
    #[must_use]
    pub fn digest(&self) -> String {
        hex(&Sha256::digest(self.to_toml()))[..16].to_owned()
    }

    /// The place of a lobe's shininess among those of the core.
    ///
    /// # Errors
    /// Another block, or a shininess that the core does not have.
    pub fn row_of(&self, n: f64) -> Result<usize, Error> {
        let Block::Lobe(LobeSpec { interface, .. }) = &self.block else {
            let has = if self.block.has_lobe() { "materials and " } else { "" };
            return Err(Error::input(
                format!("the core {} is {}, which has {has}no shininess", self.name, self.block.kind().noun()),
                "ask a lobe",
            ));
        };
        let set = &interface.shininess;
        set.values().iter().position(|&own| own == n).ok_or_else(|| {
            let all = if set.rows() > 20 { format!("{} of them", set.rows()) } else { set.to_string() };
            Error::input(format!("the core has no shininess {n}"), format!("it has {all}"))
        })
    }

    /// The flags that differ from the defaults, each with its value: `--key value`. No flag gives a material's colours,
    /// and the file of a reflectance is the core's own directory.
    #[must_use]
    pub fn flags(&self) -> Vec<String> {
        SpecFields::from_spec(self).flags()
    }

    /// The command that generates this core: the flags that differ from the defaults, or `core.toml` itself
    /// where they would fill more than a line or a part of the core is made of its own files.
    #[must_use]
    pub fn command(&self) -> String {
        let command = format!("brdfgen generate {}", self.flags().join(" "));
        // No flag gives a material's colours.
        let beyond_flags = match &self.block {
            Block::Shader(
                LobeSpec { interface: Interface { shininess: Shininess::Materials(materials), .. }, .. },
                _,
            ) => materials.iter().any(|material| !material.is_plain()),
            Block::Image(image) => image.source.model().is_none(),
            _ => false,
        };
        if command.len() <= 88 && !beyond_flags { command } else { "brdfgen generate core.toml".to_owned() }
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
