//! The datasheet of a core.

use askama::Template;

use super::{Part, counted};
use crate::block::image::{FrontEnd, Image, ImageForm};
use crate::block::shader::datapath::COLOURS;
use crate::core::{
    Account, BlockDesign, Design, ImageDesign, ImageError, LobeDesign, Measured, OtherForm, ShaderDesign, ShaderError,
    WritePort,
};
use crate::datapath::products::WideProduct;
use crate::emit::{Axis, ExternalMemory, LightFunction, LightTable, Sequencer, markdown, render};
use crate::fixed::{Field, Table};
use crate::method::Falls;
use crate::platform::error::Error;
use crate::reflectance::directory;
use crate::spec::{
    Block, Colour, CoreSpec, Cosine, DspBlocks, Form, ImageSource, ImageSpec, LightColours, LobeSpec, Material,
    REFLECTANCE_DIRECTORY, RomStyle, Shader, Shininess, Tail,
};

/// What the core is, in a line.
pub(crate) fn title(spec: &CoreSpec) -> String {
    match &spec.block {
        Block::Lobe(lobe) => lobe_text(lobe),
        Block::Shader(lobe, shader) => {
            let of = match shader.cosine {
                Cosine::Mirror => "Phong",
                Cosine::Half | Cosine::Sqrt => "Blinn",
            };
            let lights = counted(shader.lights, "light");
            format!(
                "{of} shader, {lights}{}, {}, {} bits a channel",
                if shader.most_lights.is_some() { " a clock" } else { "" },
                counted(lobe.interface.shininess.rows() as u64, "material"),
                shader.channel_bits
            )
        }
        Block::Image(ImageSpec { image, source, .. }) => {
            let (size, lights) = (image.size, counted(image.lights, "light"));
            let form = match &image.form {
                ImageForm::Half { slices } => format!("half, {slices} slices of {size} x {size} texels"),
                ImageForm::Bivariate { .. } => format!("bivariate, {size} x {size} texels"),
                ImageForm::Matcap => {
                    return format!("matcap of {size} x {size} texels, {} bits a channel", image.channel_bits);
                }
                ImageForm::Paper { angles } => {
                    format!("paper, {} of {size} x {size} texels", counted(angles.len() as u64, "sphere image"))
                }
            };
            format!(
                "image-based block of {} ({form}), {lights} a clock, {} bits a channel",
                source.model().map_or("a measured reflectance", |model| model.family().name()),
                image.channel_bits
            )
        }
    }
}

/// What the bound of the error is below, in words.
fn allowed(spec: &LobeSpec) -> String {
    match spec.method.options().accuracy {
        None => "1 ulp: the core is faithful".to_owned(),
        Some(bits) => {
            format!("{} ulps, the 2^-{bits} that was asked for", 1u32 << (spec.interface.output_fraction - bits))
        }
    }
}

/// What the lobe is, in a line.
fn lobe_text(spec: &LobeSpec) -> String {
    let mut text = format!("specular lobe x^n as {}", spec.method.about().formula);
    if let Some(tail) = spec.method.options().tail {
        text += match tail {
            Tail::Cut => ", cut",
            Tail::Hold => ", held",
        };
    }
    text += &match spec.interface.shininess {
        Shininess::Range(first, last) | Shininess::Fixed { first, last, .. } => format!(", n = {first} to {last}"),
        _ => format!(", {} shininesses", spec.interface.shininess.rows()),
    };
    if spec.method.about().has("form") {
        text += &format!(", {} form", form_text(spec.method.form()));
    }
    if spec.is_fitted() {
        text += ", minimax";
    }
    text
}

fn form_text(form: Form) -> &'static str {
    match form {
        Form::Stable => "stable",
        Form::Paper => "paper",
    }
}

/// `low..high` with signs, for errors in ulps.
#[must_use]
pub fn interval_text([low, high]: [f64; 2]) -> String {
    // Adding 0 takes the sign off a zero.
    format!("{:+.3}..{:+.3}", low + 0.0, high + 0.0)
}

/// The most characters of a line in the head of a file, behind the comment's sign.
const HEAD_LINE: usize = 97;

/// The error, a line each.
pub(super) fn error_lines(design: &Design, account: &Account) -> Vec<String> {
    match account {
        Account::Lobe { measured, .. } => {
            let proved = interval_text(design.lobe().budget.proved_ulps);
            let proved = format!("Error against the real-valued method, in ulps of out_spec: proved within {proved}.");
            let order = lines(&monotone_text(design.lobe().falls));
            [proved].into_iter().chain(measured_lines(measured)).chain(order).collect()
        }
        Account::Shader(error) => vec![
            format!("Error against the exact shader, in codes of a channel, over {} samples:", error.samples),
            format!("  {}, root mean square {:.3}.", interval_text(error.whole.codes), error.whole.rms),
        ],
        Account::Image(error) if design.sums().is_none() => {
            vec![format!("A picture of a sphere against {}: {:.1} dB.", error.exact(), error.quality.mean)]
        }
        Account::Image(error) => vec![
            format!("Pictures of a sphere against {}, lit from {} angles:", error.exact(), error.angles),
            format!("  {:.1} dB in the mean, {:.1} dB at the worst angle.", error.quality.mean, error.quality.worst),
        ],
    }
}

/// A sentence in lines as the head of a file has them, those behind the first a little further in.
fn lines(sentence: &str) -> Vec<String> {
    let options = textwrap::Options::new(HEAD_LINE)
        .subsequent_indent("  ")
        .wrap_algorithm(textwrap::WrapAlgorithm::FirstFit)
        .word_separator(textwrap::WordSeparator::AsciiSpace)
        .word_splitter(textwrap::WordSplitter::NoHyphenation);
    textwrap::wrap(sentence, options).into_iter().map(std::borrow::Cow::into_owned).collect()
}

fn measured_lines(measured: &Measured) -> Vec<String> {
    let sweep = &measured.sweep;
    let inputs = if sweep.exhaustive {
        format!("all {} inputs in [0, 1]", sweep.inputs)
    } else {
        format!("{} evenly spaced inputs", sweep.inputs)
    };
    vec![
        format!("  measured {} over {inputs}.", interval_text(measured.ulps)),
        "Error against x^n itself, measured over the same inputs:".to_owned(),
        format!(
            "  {} absolute, {} where x^n >= 1/2, {} relative there.",
            percent_text(measured.max_abs),
            percent_text(measured.max_abs_epicentre),
            percent_text(measured.max_rel_epicentre)
        ),
    ]
}

/// What is known of the order of a lobe's outputs.
#[must_use]
pub fn monotone_text(falls: &Falls) -> String {
    let Falls { pairs, exhaustive, count, most_ulps, worst: [n, cosine] } = falls;
    let of = if *exhaustive { format!("all {pairs}") } else { format!("{pairs} chosen") };
    match (count, exhaustive) {
        (0, true) => {
            format!("As the cosine rises, the output never falls: proved by running {of} pairs of neighbouring inputs.")
        }
        (0, false) => format!("As the cosine rises, the output falls at none of {of} pairs of neighbouring inputs."),
        _ => format!(
            "As the cosine rises, the output falls at {count} of {of} pairs of neighbouring inputs, by {most_ulps} ulp \
             at most (n = {n}, x = {cosine:.6})."
        ),
    }
}

/// A share as a percentage, with more digits where it is small.
#[must_use]
pub fn percent_text(value: f64) -> String {
    let digits = if value < 0.001 { 5 } else { 3 };
    format!("{:.digits$} %", 100.0 * value)
}

/// How a memory is written.
struct Load {
    memory: &'static str,
    enable: String,
    address: String,
    data: String,
    file: String,
    /// The fields with the least and the greatest code of the generated words.
    ranges: Vec<(&'static str, i128, i128)>,
}

impl Load {
    fn of(design: &Design, port: WritePort) -> Self {
        let table = &design.tables()[port.memory];
        let range = |field: &Field| {
            let codes = || field.codes.iter().copied();
            (field.name, codes().min().unwrap_or(0), codes().max().unwrap_or(0))
        };
        Self {
            memory: table.name,
            enable: port.enable.name,
            address: port.address.name,
            data: port.data.name,
            file: super::rom_path(design, table, super::read_format(&design.spec)),
            ranges: table.fields.iter().map(range).collect(),
        }
    }
}

struct FormRow {
    form: &'static str,
    multipliers: String,
    multiplier_bits: u32,
    rom: String,
    registers: u32,
    latency: u32,
    proved: String,
    wide_products: String,
}

impl FormRow {
    fn of(design: &Design) -> Self {
        let multipliers = design.function().multipliers();
        Self {
            form: match design.block() {
                BlockDesign::Lobe(lobe) | BlockDesign::Shader(ShaderDesign { lobe, .. }) => {
                    form_text(lobe.method.form())
                }
                BlockDesign::Image(_) => "",
            },
            multipliers: multipliers.iter().map(|(a, b)| format!("{a}x{b}")).collect::<Vec<_>>().join(", "),
            multiplier_bits: multipliers.iter().map(|(a, b)| a * b).sum(),
            rom: if design.tables().is_empty() {
                "none".to_owned()
            } else {
                let size = |table: &Table| format!("{} x {} = {}", table.depth(), table.word_bits(), table.bits());
                design.tables().iter().map(size).collect::<Vec<_>>().join(", ")
            },
            registers: design.register_bits(),
            latency: design.schedule.latency,
            proved: match design.block() {
                BlockDesign::Lobe(lobe) => interval_text(lobe.budget.proved_ulps),
                _ => String::new(),
            },
            wide_products: wide_products_text(design),
        }
    }
}

/// The products that no DSP block holds, and how they are built; nothing where there are none.
fn wide_products_text(design: &Design) -> String {
    let DspBlocks::Of(family) = design.spec.dsp else { return String::new() };
    let built = |wide: &WideProduct| {
        let parts: Vec<String> = wide.parts(design.graph()).map(|[a, b]| format!("{a}x{b}")).collect();
        let ([a, b], clocks) = (wide.operands, wide.clocks(&design.schedule));
        let name = &design.graph().nodes[wide.node].name;
        format!("`{name}` ({a}x{b}) of {}, in {clocks} clock{}", parts.join(", "), if clocks == 1 { "" } else { "s" })
    };
    let all: Vec<String> = design.wide_products.iter().map(built).collect();
    if all.is_empty() {
        return String::new();
    }
    format!("Products that no DSP block of {} holds are sums of some that one does: {}.", family.title, all.join("; "))
}

#[derive(Template)]
#[template(path = "package/datasheet.md", escape = "none")]
struct Datasheet<'a> {
    design: LobeDesign<'a>,
    spec: &'a CoreSpec,
    title: String,
    command: String,
    both_forms: bool,
    rom_file: bool,
    loads: Vec<Load>,
    /// Whether a memory that can be written is read without a register.
    asynchronous: bool,
    /// Whether a row serves the shininesses up to the next row, too.
    interpolated: bool,
    rows: Vec<(usize, String, String)>,
    /// What the bound is below.
    allowed: String,
    measured: &'a Measured,
    forms: Vec<FormRow>,
    other_failed: Option<&'a String>,
    axis: Option<Axis>,
    files: Vec<(String, &'static str)>,
}

fn files(design: &Design) -> Vec<(String, &'static str)> {
    let spec = &design.spec;
    let mut files: Vec<(String, &'static str)> = vec![
        ("core.toml".to_owned(), "the spec, every default resolved"),
        ("manifest.json".to_owned(), "this datasheet for programs, with a digest of every file"),
    ];
    for &language in &spec.languages {
        for part in Part::of(design) {
            let [text, bench] = match part {
                Part::Core => ["the core", "its self-checking test bench; run it in this directory"],
                Part::Lights => ["its sequencer", "the sequencer's test bench, likewise"],
                Part::Table => ["its table of lights", "the table's test bench, likewise"],
                Part::Axis => ["its wrapper with AXI4-Stream interfaces", "the wrapper's test bench, likewise"],
            };
            files.push((part.rtl_path(design, language), text));
            files.push((part.bench_path(design, language), bench));
        }
    }
    if let Some(memory) = super::external_memory(design) {
        let what = "a model of the memory outside of the core, for the benches";
        files.extend(spec.languages.iter().map(|&language| (super::memory_path(&memory, language), what)));
    }
    for table in design.tables() {
        let what = match table.name {
            Table::COEFFICIENTS => "the coefficient ROM",
            COLOURS => "the materials' colours",
            _ if table.key == Table::TEXEL => "texels",
            _ => "a function table",
        };
        for &format in &spec.rom_formats {
            files.push((super::rom_path(design, table, format), what));
        }
    }
    if let Block::Image(of) = &spec.block
        && of.image.has_lights()
    {
        let [header, source] = LightFunction::paths(&spec.name);
        files.push((header, "light records for drivers: the C function's header"));
        files.push((source, "its source, C99"));
    }
    files.push((super::golden_path(design), "golden vectors and digests"));
    if design.light_words().is_some() {
        files.push((super::samples_path(design), "samples through the table of lights"));
    }
    if let Block::Image(ImageSpec { source: ImageSource::Samples(_), .. }) = &spec.block {
        let index = format!("{REFLECTANCE_DIRECTORY}/{}", directory::INDEX);
        files.push((index, "the samples that the texels are made of, with their images beside it"));
    }
    files.push(("files.f".to_owned(), "the source, for a simulator's -f option"));
    files
}

#[derive(Template)]
#[template(path = "package/shader.md", escape = "none")]
struct ShaderSheet<'a> {
    design: ShaderDesign<'a>,
    spec: &'a CoreSpec,
    title: String,
    command: String,
    shader: &'a Shader,
    materials: &'a [Material],
    light_colours: String,
    cosine: &'static str,
    lobe: String,
    dot_bits: i32,
    error: &'a ShaderError,
    rom_file: bool,
    cost: FormRow,
    sequencer: Option<Sequencer>,
    table: Option<LightTable>,
    /// Lights that its roundings are sized for.
    most_lights: u32,
    axis: Option<Axis>,
    files: Vec<(String, &'static str)>,
}

fn colour_text(colour: Colour) -> String {
    colour.map(|channel| format!("{channel:.3}")).join(" ")
}

/// How the templates write figures and names.
mod filters {
    use askama::{Result, Values, filter_fn};

    #[filter_fn]
    pub(super) fn ulps(interval: &[f64; 2], _: &dyn Values) -> Result<String> {
        Ok(super::interval_text(*interval))
    }

    #[filter_fn]
    pub(super) fn monotone(falls: &super::Falls, _: &dyn Values) -> Result<String> {
        Ok(super::monotone_text(falls))
    }

    #[filter_fn]
    pub(super) fn percent(value: &f64, _: &dyn Values) -> Result<String> {
        Ok(super::percent_text(*value))
    }

    #[filter_fn]
    pub(super) fn colour(colour: &[f64; 3], _: &dyn Values) -> Result<String> {
        Ok(super::colour_text(*colour))
    }

    #[filter_fn]
    pub(super) fn plain(name: &str, _: &dyn Values) -> Result<String> {
        Ok(super::markdown::text(name))
    }
}

/// The text of a shader's datasheet.
pub(super) fn shader_sheet(design: ShaderDesign<'_>, error: &ShaderError) -> Result<String, Error> {
    let ShaderDesign { lobe, shader, .. } = design;
    let spec = &design.spec;
    render(&ShaderSheet {
        design,
        spec,
        title: title(spec),
        command: markdown::code(&spec.command()),
        shader,
        materials: design.materials(),
        light_colours: match &shader.light_colours {
            LightColours::Ports if shader.most_lights.is_some() => "in sequence, their colours from ports".to_owned(),
            LightColours::Ports => format!("{}, their colours from ports", shader.lights),
            LightColours::Fixed(colours) => {
                let texts: Vec<String> = colours.iter().map(|&colour| colour_text(colour)).collect();
                format!("{}, multiplied into the ROM", texts.join("; "))
            }
        },
        cosine: match shader.cosine {
            Cosine::Mirror => "x = 2 (N.L)(N.V) - L.V, taken into [0, 1].",
            Cosine::Half => "x = 1 - u with the versine u = |N - H|^2 / 2, taken into [0, 1].",
            Cosine::Sqrt => "x = (N.L + N.V) / sqrt(2 + 2 L.V), taken into [0, 1].",
        },
        lobe: lobe_text(spec.block.lobe()),
        dot_bits: shader.widths(lobe.interface).dot,
        error,
        rom_file: spec.rom == RomStyle::File,
        cost: FormRow::of(&design),
        sequencer: super::sequencer(&design),
        table: super::light_table(&design),
        most_lights: shader.most_lights.unwrap_or_default(),
        axis: super::axis(&design),
        files: files(&design),
    })
}

#[derive(Template)]
#[template(path = "package/image.md", escape = "none")]
struct ImageSheet<'a> {
    design: ImageDesign<'a>,
    spec: &'a CoreSpec,
    title: String,
    command: String,
    image: &'a Image,
    /// Whether the core makes the records of lights itself.
    is_vector: bool,
    model: Option<String>,
    exposure: f64,
    /// The codes of a texel's channel.
    steps: u32,
    bands: Vec<(usize, String, String)>,
    texel_memories: Vec<&'a Table>,
    error: &'a ImageError,
    rom_file: bool,
    loads: Vec<Load>,
    /// The memory outside of the core.
    external: Option<ExternalMemory>,
    cost: FormRow,
    sequencer: Option<Sequencer>,
    table: Option<LightTable>,
    /// Lights that its roundings are sized for.
    most_lights: u32,
    axis: Option<Axis>,
    files: Vec<(String, &'static str)>,
}

/// The text of an image-based block's datasheet.
pub(super) fn image_sheet(design: ImageDesign<'_>, error: &ImageError) -> Result<String, Error> {
    let (spec, ImageSpec { image, source, exposure }) = (&design.spec, design.of);
    let caps = design.block.texels().caps();
    let band = |(number, (angle, cap)): (usize, (f64, &f64))| (number, format!("{angle:.2}"), format!("{cap:.5}"));
    render(&ImageSheet {
        design,
        spec,
        title: title(spec),
        command: markdown::code(&spec.command()),
        image,
        is_vector: image.front_end == FrontEnd::Vector,
        model: source.model().map(ToString::to_string),
        exposure: *exposure,
        steps: 1 << image.texel_bits,
        bands: image.band_angles().into_iter().zip(caps).enumerate().map(band).collect(),
        texel_memories: design.core().tables().iter().filter(|memory| memory.holds_texels()).collect(),
        error,
        rom_file: spec.rom == RomStyle::File,
        loads: design.write_ports().into_iter().map(|port| Load::of(&design, port)).collect(),
        external: super::external_memory(&design),
        cost: FormRow::of(&design),
        sequencer: super::sequencer(&design),
        table: super::light_table(&design),
        most_lights: image.most_lights,
        axis: super::axis(&design),
        files: files(&design),
    })
}

/// The text of a lobe's datasheet; `other` is the core in the other form, or why it cannot be built, where the method
/// has two forms.
pub(super) fn datasheet(
    design: LobeDesign<'_>,
    measured: &Measured,
    other: Option<&OtherForm>,
) -> Result<String, Error> {
    let (spec, core) = (&design.spec, design.core());
    let forms: Vec<FormRow> =
        std::iter::once(core).chain(other.and_then(|other| other.as_deref().ok())).map(FormRow::of).collect();
    let other_failed = other.and_then(|other| other.as_ref().err());
    let rows = match &design.interface.shininess {
        Shininess::Range(..) | Shininess::Fixed { .. } => Vec::new(),
        Shininess::List(list) => {
            list.iter().enumerate().map(|(index, n)| (index, String::new(), n.to_string())).collect()
        }
        Shininess::Materials(materials) => {
            let row = |(index, m): (usize, &Material)| (index, markdown::text(&m.name), m.shininess.to_string());
            materials.iter().enumerate().map(row).collect()
        }
    };
    render(&Datasheet {
        design,
        spec,
        title: title(spec),
        command: markdown::code(&spec.command()),
        both_forms: forms.len() > 1 || other_failed.is_some(),
        rom_file: spec.rom == RomStyle::File,
        loads: design.write_ports().into_iter().map(|port| Load::of(core, port)).collect(),
        asynchronous: design.write_ports().iter().any(|port| {
            let read = design.layout().read(port.memory);
            read.is_some_and(|read| read.registers == 0)
        }),
        interpolated: matches!(design.interface.shininess, Shininess::Fixed { .. }),
        rows,
        allowed: allowed(spec.block.lobe()),
        measured,
        forms,
        other_failed,
        axis: super::axis(core),
        files: files(core),
    })
}
