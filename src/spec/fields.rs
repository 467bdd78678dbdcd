//! The spec as it is written, in TOML or as flags.

use std::path::Path;

use super::{
    BlockKind, Coefficients, Divider, DspBlocks, Form, FrontEnd, ImageFormName, InputRange, Inside, Language,
    LightSource, Material, Memory, MethodName, Operand, Pipeline, PortCodes, ReflectanceFields, RomStyle, ShaderFields,
    Shininess, Tail, TexelMemory, VhdlPorts,
};
use crate::emit::rom::RomFormat;
use crate::fit::Objective;
use crate::method::keys::{Fields, keys};
use crate::method::{Options, method_keys};
use crate::platform::error::Error;
use crate::platform::input;

method_keys! { keys! {
    /// A spec as written: a key of the TOML file and a flag each. A flag wins over the file.
    #[command(next_help_heading = "Core")]
    SpecFields:

    /// Name of the core, its module and its files [default: method and form]
    name: String,

    /// What the core is [default: lobe]
    block: BlockKind,

    /// How the lobe is approximated
    method: MethodName,
} {
    /// Shininesses served: a range of integers, 1..=1000, or a list of real numbers, 5,12.5,80
    #[arg(conflicts_with = "material")]
    shininess: Shininess where "lobes",

    /// Fraction bits of the port in_n, for a range: real shininesses between the integers, 0 to 10 [default: 0]
    #[arg(value_name = "R")]
    shininess_fraction: u32 where "ranges of shininesses",

    /// Fraction bits F of the input, 4 to 24 [default: 16]
    #[arg(value_name = "F")]
    input_fraction: u32,

    /// Fraction bits G of the output, 4 to 20 [default: 16]
    #[arg(value_name = "G")]
    output_fraction: u32,

    /// What the core is given [default: cos]
    operand: Operand where "lobes",

    /// Codes of the operand that the core may be given: any, or those in [0, 1], which spares it the limits at both
    /// ends [default: any]
    #[arg(value_name = "RANGE")]
    input_range: InputRange where "lobes",

    /// Whether the lobe's output never falls as the cosine rises, for every shininess [default: true]
    #[arg(value_name = "true|false", num_args = 0..=1, require_equals = true, default_missing_value = "true")]
    monotone: bool where "lobes and shaders",

    /// Where the HDL finds the coefficients [default: inline]
    rom: RomStyle,

    /// ROM files written beside the HDL; mem is always written [default: mem]
    #[arg(value_delimiter = ',', value_name = "FORMATS")]
    rom_formats: Vec<RomFormat>,

    /// Registers between input and output, 1 to 64, or auto [default: auto]
    #[arg(value_name = "DEPTH|auto")]
    pipeline: Pipeline,

    /// Family of whose DSP blocks products that are wider than one are built, with registers between them; or none:
    /// each is one multiplication [default: ecp5]
    #[arg(value_name = "FAMILY|none")]
    dsp: DspBlocks,

    /// Languages written [default: verilog,vhdl]
    #[arg(value_delimiter = ',')]
    languages: Vec<Language>,

    /// Types of the VHDL's ports: numeric (unsigned and signed), or std-logic (std_logic_vector, as Vivado's block
    /// designs need them) [default: numeric]
    #[arg(value_name = "TYPES")]
    vhdl_ports: VhdlPorts where "cores with VHDL",

    /// Write a wrapper with AXI4-Stream interfaces around the core as well
    #[arg(value_name = "true|false", num_args = 0..=1, require_equals = true, default_missing_value = "true")]
    axi_stream: bool,

    /// Bits of tuser of the AXI4-Stream interfaces, 1 to 64 [default: 1]
    #[arg(value_name = "BITS")]
    tuser_bits: u32 where "cores with AXI4-Stream interfaces",

    /// Inputs for the golden vectors besides those that are chosen: the codes of the input ports in order,
    /// CODE,CODE;CODE,CODE
    #[arg(value_name = "INPUTS")]
    golden_inputs: PortCodes,

    /// What is stored of the reflectance [default: half]
    #[arg(help_heading = "Image-based block")]
    image_form: ImageFormName where "image-based blocks",

    /// Slices of the form half, a power of two from 4 to 64, or images of the form paper, 1 to 32, at steps of
    /// 180/COUNT degrees [default: 16 slices, 6 images]
    #[arg(help_heading = "Image-based block", value_name = "COUNT")]
    images: u32 where "image-based blocks",

    /// Angles of the light in degrees that the images of the form paper are lit from, ascending, ANGLE,ANGLE
    #[arg(help_heading = "Image-based block", value_name = "ANGLES", value_delimiter = ',')]
    angles: Vec<f64> where "image-based blocks",

    /// Octaves of 1 - n.h that have columns of their own in the form bivariate, a power of two from 2 to 16 [default:
    /// 8]
    #[arg(help_heading = "Image-based block", value_name = "COUNT")]
    octaves: u32 where "image-based blocks",

    /// Texels along a side, a power of two from 8 to 512 [default: 64 for matcap, else 32]
    #[arg(help_heading = "Image-based block", value_name = "TEXELS")]
    image_size: u32 where "image-based blocks",

    /// Bits of a texel's channel, 4 to 10; texels are codes of square roots [default: 8]
    #[arg(help_heading = "Image-based block", value_name = "BITS")]
    texel_bits: u32 where "image-based blocks",

    /// The least mean PSNR in dB of the block's pictures of a sphere against the reflectance, for 34 angles of a light:
    /// images, image_size and texel_bits that are not given are the smallest that reach it
    #[arg(help_heading = "Image-based block", value_name = "DB")]
    min_psnr: f64 where "image-based blocks",

    /// The greatest error of a channel, in parts of full scale, in these pictures: as min_psnr, and with it if both are
    /// given
    #[arg(help_heading = "Image-based block", value_name = "ERROR", long = "max-picture-error")]
    max_error: f64 where "image-based blocks" => "max-picture-error",

    /// Bits of the weights that texels are blended with, 3 to 8 [default: 6 for paper, else 5]
    #[arg(help_heading = "Image-based block", value_name = "BITS")]
    weight_bits: u32 where "image-based blocks",

    /// Multipliers that texels are blended with, those of the widest codes: the other blends are sums of texels, chosen
    /// by the weights' bits [default: for codes of more than 14 bits]
    #[arg(help_heading = "Image-based block", value_name = "COUNT")]
    blend_multipliers: u32 where "image-based blocks",

    /// Bits of a vector's component, 10 to 22, of which two are before the point [default: 18]
    #[arg(help_heading = "Image-based block", value_name = "BITS")]
    vector_bits: u32 where "image-based blocks",

    /// What the core is told of a light: its record, or the unit vector towards it and its intensity, of which it makes
    /// the record itself, in the forms half and bivariate [default: record]
    #[arg(help_heading = "Image-based block", value_name = "record|vector")]
    front_end: FrontEnd where "image-based blocks",

    /// Bits of an output channel: 8, 10 or 12 [default: 8]
    #[arg(help_heading = "Image-based block", value_name = "BITS")]
    output_bits: u32 where "image-based blocks",

    /// Take the lights of a sample in sequence, so many a clock, 1 to 8, until in_last [default: 1 in image-based
    /// blocks]
    #[arg(value_name = "LIGHTS")]
    lights_a_clock: u32 where "shaders and image-based blocks",

    /// Lights in sequence that the roundings of a sample are sized for, 1 to 1024; more may come [default: 64]
    #[arg(value_name = "LIGHTS")]
    most_lights: u32 where "shaders and image-based blocks",

    /// Where lights in sequence come from: ports, a table of most_lights in the core that is written, or one that is
    /// not, with light_records [default: port]
    #[arg(value_name = "port|table|rom")]
    light_source: LightSource where "shaders and image-based blocks",

    /// The lights of light_source = rom, in order: the codes of a light's ports, CODE,CODE;CODE,CODE, as `brdfgen image
    /// lights` has them
    #[arg(value_name = "RECORDS")]
    light_records: PortCodes where "shaders and image-based blocks",

    /// Where the texels lie [default: rom]
    #[arg(help_heading = "Image-based block")]
    texels: TexelMemory where "image-based blocks",

    /// Enabled clocks from the address of an external texel at the core's ports to the texel there, 1 to 32 [default:
    /// 2]
    #[arg(help_heading = "Image-based block", value_name = "CLOCKS")]
    texel_latency: u32 where "image-based blocks",

    /// Hold two sets of writable texels: samples are looked up in the one until one of them ends with swap
    #[arg(help_heading = "Image-based block", value_name = "true|false", num_args = 0..=1, require_equals = true)]
    #[arg(default_missing_value = "true")]
    swap: bool where "image-based blocks",

    /// A named material, NAME=SHININESS; repeat for more. `in_n` is their index
    #[arg(value_name = "NAME=SHININESS")]
    material: Vec<Material>,

    +
    /// What reflects, for an image-based block.
    #[command(flatten)]
    #[serde(default, skip_serializing_if = "ReflectanceFields::is_empty")]
    reflectance: ReflectanceFields,

    +
    /// What a shader has beyond its lobe.
    #[command(flatten)]
    #[serde(default, skip_serializing_if = "ShaderFields::is_empty")]
    shader: ShaderFields,
} }

/// The options of the methods among the fields, and back.
macro_rules! options {
    ($( $(#[$of_key:meta])* $key:ident: $Value:ty $(as $called:literal)? $(where $applies:literal)?, )*) => {
        impl SpecFields {
            pub(super) fn options(&self) -> Options {
                Options { $($key: self.$key),* }
            }

            pub(super) fn with_options(self, options: Options) -> Self {
                Self { $($key: options.$key,)* ..self }
            }
        }
    };
}
method_keys! { options! {} }

impl SpecFields {
    /// Reads a TOML file, or the one in a generated core's directory. The path of a reflectance's file starts from
    /// where that file is.
    ///
    /// # Errors
    /// An unreadable file, text that is not TOML, an unknown key (with the nearest known one) or a value
    /// of the wrong kind, with its place.
    pub fn read(path: &Path) -> Result<Self, Error> {
        let inside = path.join("core.toml");
        let path = if path.is_dir() { &inside } else { path };
        let text = input::read_text(path, "a spec is a TOML file")?;
        let fields = Self::parse(&text, &path.display().to_string())?;
        let directory = path.parent().unwrap_or(Path::new(""));
        Ok(Self { reflectance: fields.reflectance.within(directory)?, ..fields })
    }

    /// Reads TOML text; `file` names it in messages.
    ///
    /// # Errors
    /// As [`SpecFields::read`].
    pub fn parse(text: &str, file: &str) -> Result<Self, Error> {
        toml::from_str(text).map_err(|error| {
            toml_error(&error, &[], "see `brdfgen generate --help` for the keys and values", file, text)
        })
    }

    /// These fields, and where one is missing the other's.
    #[must_use]
    pub fn or(self, other: Self) -> Self {
        // The two ways to give the set exclude each other, so one given here hides both of the other's.
        let is_set = self.shininess.is_some() || self.material.is_some();
        let mut other = if is_set { Self { shininess: None, material: None, ..other } } else { other };
        if self.reflectance.replaces(&other.reflectance) {
            other.reflectance = ReflectanceFields::default();
        }
        self.or_each(other)
    }

    /// The fields as TOML text.
    ///
    /// # Panics
    /// Never: every field has a TOML form.
    #[must_use]
    pub fn to_toml(&self) -> String {
        toml::to_string(self).expect("every field has a TOML form")
    }
}

/// What is wrong with TOML text, with its place: an unknown key with the nearest of those that the parser or `more`
/// knows, or what the parser says with `help`.
pub(crate) fn toml_error(error: &toml::de::Error, more: &[&str], help: &str, file: &str, text: &str) -> Error {
    let span = error.span().unwrap_or(0..0);
    let (what, allowed) = match error.message().strip_prefix("unknown field `").and_then(|rest| rest.split_once('`')) {
        Some((key, rest)) => {
            let known = rest.split('`').skip(1).step_by(2).chain(more.iter().copied());
            (format!("unknown key `{key}`"), suggest("keys", key, known))
        }
        None => (error.message().to_owned(), help.to_owned()),
    };
    Error::text(what, allowed, file, text, (span.start, span.len()))
}

/// "did you mean ...?" where a known name is near, and the list of all of them; `what` they are, in the plural.
pub(crate) fn suggest<'a>(what: &str, name: &str, known: impl Iterator<Item = &'a str>) -> String {
    let known: Vec<&str> = known.collect();
    let nearest = known.iter().max_by(|a, b| strsim::jaro_winkler(name, a).total_cmp(&strsim::jaro_winkler(name, b)));
    match nearest.filter(|near| strsim::jaro_winkler(name, near) > 0.7) {
        Some(near) => format!("did you mean `{near}`? The {what} are {}", known.join(", ")),
        None => format!("the {what} are {}", known.join(", ")),
    }
}
