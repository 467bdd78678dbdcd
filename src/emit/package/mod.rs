//! The core directory: its files, and how they are put on disk.

mod datasheet;
mod directory;
mod manifest;
mod part;

pub(crate) use datasheet::title;
pub use datasheet::{interval_text, monotone_text, percent_text};
pub use directory::{
    GENERATED_MARK, Kind, Stale, check_target, check_target_of, core_files, stale, write_directory, write_directory_of,
    write_file,
};

pub use part::Part;

use serde_json::json;

use crate::core::golden::{self, Golden};
use crate::core::{Account, BlockDesign, Design, Port, ReadPort, WritePort};
use crate::emit::rom::{self, RomFormat};
use crate::emit::{
    self, Axis, ExternalMemory, ExternalPart, Lane, LightFunction, LightTable, RomFile, Sequencer, Texts, Wrapper,
};
use crate::fixed::Table;
use crate::platform::error::Error;
use crate::spec::{Block, CoreSpec, ImageSource, ImageSpec, Language, REFLECTANCE_DIRECTORY, RomStyle};

/// A file of a core: its path in the core's directory, with forward slashes, and its bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// The path.
    pub path: String,
    /// The content.
    pub bytes: Vec<u8>,
}

/// The path of the golden vectors in the core's directory.
#[must_use]
pub fn golden_path(design: &Design) -> String {
    format!("golden/{}.vec", design.spec.name)
}

/// The path of the samples through a table of lights that is not written, in the core's directory.
#[must_use]
pub fn samples_path(design: &Design) -> String {
    format!("golden/{}.vec", Part::Table.name(design))
}

/// The path of a memory's file in the core's directory.
#[must_use]
pub fn rom_path(design: &Design, table: &Table, format: RomFormat) -> String {
    format!("rom/{}", format.file_name(&design.spec.name, table))
}

/// A memory's file.
#[must_use]
pub fn rom_file(design: &Design, table: &Table, format: RomFormat) -> File {
    let spec = &design.spec;
    let name = rom::memory_name(&spec.name, table);
    let bytes = rom::write(table, format, &name, &spec.digest(), &spec.command());
    File { path: rom_path(design, table, format), bytes }
}

/// The path of the HDL in the core's directory.
#[must_use]
pub fn rtl_path(design: &Design, language: Language) -> String {
    Part::Core.rtl_path(design, language)
}

/// The format of the files that a core's HDL reads: the one without comments, as Vivado's synthesis wants them (UG901),
/// where the spec asks for it.
#[must_use]
pub fn read_format(spec: &CoreSpec) -> RomFormat {
    if spec.rom_formats.contains(&RomFormat::MemPlain) { RomFormat::MemPlain } else { RomFormat::Mem }
}

/// The path of the test bench in the core's directory.
#[must_use]
pub fn bench_path(design: &Design, language: Language) -> String {
    Part::Core.bench_path(design, language)
}

/// The path of the model of a memory outside of a core, in the core's directory.
fn memory_path(memory: &ExternalMemory, language: Language) -> String {
    format!("tb/{}.{}", memory.name, extension(language))
}

/// The memory that the core reads outside of it, without a header, if it does.
#[must_use]
pub fn external_memory(design: &Design) -> Option<ExternalMemory> {
    let part = |port: ReadPort| {
        let table = &design.tables()[port.memory];
        ExternalPart::new(port, named_file(design, table), table)
    };
    let parts: Vec<ExternalPart> = design.read_ports().into_iter().map(part).collect();
    let clocks = design.schedule.external.clocks;
    let name = format!("{}_memory", design.spec.name);
    (!parts.is_empty()).then_some(ExternalMemory { name, header: Vec::new(), clocks, parts })
}

/// The text of a part of a core whose memory lies outside, in Verilog, together with that memory: what is to be added
/// to it, and the name of the module. `None` if nothing lies outside.
///
/// # Errors
/// A core that cannot be written in Verilog.
pub(crate) fn closing(design: &Design, part: Part) -> Result<Option<(String, String)>, Error> {
    let Some(memory) = external_memory(design) else { return Ok(None) };
    let (name, ports) = match part {
        Part::Core => (design.spec.name.clone(), design.ports()),
        _ => (part.name(design), design.sequencer_ports()),
    };
    let texts = texts_without_header(design);
    let text = memory.emit(Language::Verilog, &texts)? + &memory.closed(&name, &ports)?;
    Ok(Some((text, ExternalMemory::closed_name(&name))))
}

fn extension(language: Language) -> &'static str {
    match language {
        Language::Verilog => "v",
        Language::Vhdl => "vhd",
    }
}

/// What tools that read a core in one language need: the files of its memories, where it reads them from such, and last
/// one with the HDL itself and that of its sequencer and table of lights, without the comments at their heads; nothing
/// is measured for it.
///
/// # Errors
/// A core that cannot be written in the language.
pub fn sources(design: &Design, language: Language) -> Result<Vec<File>, Error> {
    let spec = &design.spec;
    let mut files = Vec::new();
    if spec.rom != RomStyle::Inline {
        files.extend(design.tables().iter().map(|table| rom_file(design, table, read_format(spec))));
    }
    let texts = texts_without_header(design);
    let mut source = emit::backend(language).emit(&design.layout(), &texts)?;
    if let Some(sequencer) = sequencer(design) {
        source += &sequencer.emit(language, &texts)?;
    }
    if let Some(table) = light_table(design) {
        source += &table.emit(language, &texts)?;
    }
    files.push(File { path: rtl_path(design, language), bytes: source.into_bytes() });
    Ok(files)
}

/// Whether the core can be written under its name: what would be found when it is written, before anything is measured.
///
/// # Errors
/// A name that the core's text uses for something else.
pub fn check_names(design: &Design) -> Result<(), Error> {
    let emit = |&language: &Language| {
        emit::backend(language).emit(&design.layout(), &texts_without_header(design)).map(|_| ())
    };
    design.spec.languages.iter().try_for_each(emit)
}

/// What the texts of a core's HDL say about it.
#[must_use]
pub fn texts(design: &Design, account: &Account) -> Texts {
    let spec = &design.spec;
    let ports = design.ports();
    let name_width = ports.iter().map(|port| port.name.len()).max().unwrap_or(0);
    let mut header = head(spec, &spec.name, &datasheet::title(spec), "core");
    header.push(String::new());
    header.extend(
        ports
            .iter()
            .filter(|port| port.format.is_some())
            .map(|port| format!("  {:<name_width$} {:<7} {}", port.name, port.format_text(), port.meaning)),
    );
    header.extend([String::new(), format!("Latency {} clocks, one result a clock.", design.schedule.latency)]);
    header.extend(datasheet::error_lines(design, account));
    Texts { header, ..texts_without_header(design) }
}

/// As [`texts`], without the comment at the head of the HDL; so nothing is measured.
#[must_use]
fn texts_without_header(design: &Design) -> Texts {
    let spec = &design.spec;
    let external = &design.schedule.external;
    let own = design.tables().iter().enumerate().filter(|(memory, _)| external.registers(*memory).is_none());
    let own = own.filter(|_| design.reads_files());
    let with_file = |port: WritePort| {
        let file = named_file(design, &design.tables()[port.memory]);
        (port, file)
    };
    let writes = design.write_ports().into_iter().map(with_file).collect();
    Texts {
        name: spec.name.clone(),
        header: Vec::new(),
        ports: design.ports(),
        vhdl_ports: spec.vhdl_ports,
        rom_files: own.map(|(_, table)| named_file(design, table)).collect(),
        writes,
        sets: design.texel_sets(),
        reads: design.read_ports(),
    }
}

/// The file that a memory's words are read from.
fn named_file(design: &Design, table: &Table) -> RomFile {
    RomFile {
        memory: table.name,
        parameter: format!("{}_FILE", table.name.to_ascii_uppercase()),
        path: rom_path(design, table, read_format(&design.spec)),
    }
}

/// The texts of what a user of the core instantiates: its table of lights, its sequencer, or itself.
fn whole_texts(design: &Design) -> Texts {
    let name = Part::whole(design).name(design);
    Texts { name, ports: design.whole_ports(), ..texts_without_header(design) }
}

/// The first lines of the comment at the head of a text; `what` it is, and what it is called.
fn head(spec: &CoreSpec, name: &str, what: &str, called: &str) -> Vec<String> {
    vec![
        format!("{name}: {what}"),
        String::new(),
        format!("Made by: {}", spec.command()),
        format!("Spec {}. Generated; the {called} is yours to use under any terms.", spec.digest()),
    ]
}

/// The core's sequencer without a header, if it takes the lights of a sample in sequence.
#[must_use]
pub fn sequencer(design: &Design) -> Option<Sequencer> {
    let sums = design.sums()?;
    let latencies = [design.schedule.latency, design.sequenced_latency()];
    let name = Part::Lights.name(design);
    Some(Sequencer::new(name, &texts_without_header(design), design.sequencer_ports(), sums, latencies))
}

fn sequencer_header(design: &Design, sequencer: &Sequencer) -> Vec<String> {
    let what = format!("the lights of a sample in sequence through the core {}", design.spec.name);
    let mut header = head(&design.spec, &sequencer.name, &what, "sequencer");
    header.push(String::new());
    let of_core = design.ports();
    let width = sequencer.ports.iter().map(|port| port.name.len()).max().unwrap_or(0);
    let line = |port: &Port| format!("  {:<width$} {:<7} {}", port.name, port.format_text(), port.meaning);
    let own = sequencer.ports.iter().filter(|port| !of_core.iter().any(|of_core| of_core.name == port.name));
    header.extend(own.map(line));
    header.extend([
        String::new(),
        format!(
            "A sample is any number of clocks' lights, the last with in_last. Latency {} clocks from",
            sequencer.latency
        ),
        "there; lights at every clock, and no pause between samples.".to_owned(),
    ]);
    header
}

/// The core's table of lights without a header, if the spec asks for one.
#[must_use]
pub fn light_table(design: &Design) -> Option<LightTable> {
    let depth = design.light_table()?;
    let (name, latency) = (Part::Table.name(design), design.whole_latency());
    let (core, ports) = (texts_without_header(design), design.table_ports(depth));
    let words = design.light_words().zip(design.lights_a_clock().map(|lights| lights as usize));
    Some(LightTable::new(name, &core, ports, sequencer(design)?, [depth, latency], words))
}

fn light_table_header(design: &Design, table: &LightTable) -> Vec<String> {
    let what = format!("a table of lights for the core {}", design.spec.name);
    let mut header = head(&design.spec, &table.name, &what, "table");
    let word = if table.words.is_none() { "lights_data" } else { "A word" };
    header.extend([String::new(), format!("{word}, {} bits:", table.word_bits())]);
    header.extend(lines_of_rows(&table.record.lanes.iter().map(|lane| lane_row(lane, "")).collect::<Vec<_>>()));
    header.extend([
        String::new(),
        "A sample takes an enabled clock for each word from in_begin to in_end; the next one follows".to_owned(),
        "at once.".to_owned(),
    ]);
    header
}

fn memory_header(design: &Design, memory: &ExternalMemory) -> Vec<String> {
    let what = format!("a model of the memory outside of the core {}, for its test benches", design.spec.name);
    let mut header = head(&design.spec, &memory.name, &what, "model");
    let clocks = memory.clocks;
    let later = if clocks == 1 { "clock".to_owned() } else { format!("{clocks} clocks") };
    header.extend([String::new(), format!("A word comes the enabled {later} behind its address.")]);
    header
}

/// What a header says of a port's place in a word: its bits, name and format, and `meaning`.
fn lane_row(lane: &Lane, meaning: &str) -> [String; 4] {
    [format!("[{}]", lane.range()), lane.port.name.clone(), lane.port.format_text(), meaning.to_owned()]
}

/// Such rows as the lines of a table.
fn lines_of_rows(rows: &[[String; 4]]) -> Vec<String> {
    let width = |column: usize| rows.iter().map(|row| row[column].len()).max().unwrap_or(0);
    let (range, name, format) = (width(0), width(1), width(2));
    let line = |row: &[String; 4]| {
        format!("  {:<range$} {:<name$} {:<format$} {}", row[0], row[1], row[2], row[3]).trim_end().to_owned()
    };
    rows.iter().map(line).collect()
}

/// The core's wrapper with AXI4-Stream interfaces without a header, if the spec asks for one.
#[must_use]
pub fn axis(design: &Design) -> Option<Axis> {
    let (name, tuser_bits) = (Part::Axis.name(design), design.spec.axi_stream?);
    Some(Axis::of(name, &whole_texts(design), design.whole_latency(), tuser_bits))
}

fn axis_header(design: &Design, axis: &Axis) -> Vec<String> {
    let what = format!("AXI4-Stream interfaces for the core {}", design.spec.name);
    let mut header = head(&design.spec, &axis.name, &what, "wrapper");
    for (name, packing, padding) in
        [("s_axis_tdata", &axis.inputs, "of no meaning"), ("m_axis_tdata", &axis.outputs, "0")]
    {
        header.extend([String::new(), format!("{name}, {} bytes:", packing.tdata_bits() / 8)]);
        let mut rows: Vec<[String; 4]> = packing.lanes.iter().map(|lane| lane_row(lane, &lane.port.meaning)).collect();
        if packing.padding() > 0 {
            rows.push([format!("[{}]", packing.padding_range()), padding.to_owned(), String::new(), String::new()]);
        }
        header.extend(lines_of_rows(&rows));
    }
    let last = if axis.sequenced {
        "s_axis_tlast ends a sample; m_axis_tuser is that of its last beat."
    } else if axis.takes_samples() {
        "tlast and tuser stay with their sample."
    } else {
        "tlast and tuser stay with their beat."
    };
    let latency = axis.latency;
    let pace = if axis.takes_samples() {
        [
            format!(
                "A sample of w words takes w clocks, and comes {} + w clocks after it was taken, also",
                latency - 1
            ),
            "behind a stall. s_axis_tready is from registers, and m_axis_tready leads to registers only.".to_owned(),
        ]
    } else {
        [
            format!(
                "Latency {latency} clocks, one beat a clock, also behind a stall. s_axis_tready is a register, and"
            ),
            "m_axis_tready leads to registers only.".to_owned(),
        ]
    };
    header.extend([String::new(), format!("{last} tkeep and tstrb are not needed: a beat is always whole.")]);
    header.extend(pace);
    header
}

/// The text of `core.toml`.
#[must_use]
pub fn spec_text(design: &Design) -> String {
    format!("{GENERATED_MARK}; `brdfgen generate core.toml --out DIR` makes it again\n{}", design.spec.to_toml())
}

/// All files of a core, `manifest.json` last.
///
/// # Errors
/// If a template cannot be filled in.
pub fn files(design: &Design, account: &Account, golden: &Golden) -> Result<Vec<File>, Error> {
    files_with(design, account, golden, Vec::new())
}

/// As [`files`], with more files of the core's.
///
/// # Errors
/// As [`files`].
pub fn files_with(design: &Design, account: &Account, golden: &Golden, others: Vec<File>) -> Result<Vec<File>, Error> {
    let spec = &design.spec;
    let layout = design.layout();
    let texts = texts(design, account);
    let golden_path = golden_path(design);
    let complemented = golden::complemented(design, golden);
    let (samples, samples_path) = (golden::samples(design, golden), samples_path(design));
    let complemented_samples = golden::complemented_samples(design, &samples);
    let (mut sequencer, mut table, mut axis) = (sequencer(design), light_table(design), axis(design));
    sequencer.iter_mut().for_each(|sequencer| sequencer.header = sequencer_header(design, sequencer));
    table.iter_mut().for_each(|table| table.header = light_table_header(design, table));
    axis.iter_mut().for_each(|axis| axis.header = axis_header(design, axis));
    let mut memory = external_memory(design);
    memory.iter_mut().for_each(|memory| memory.header = memory_header(design, memory));
    let mut files = Vec::new();
    let mut add = |path: String, bytes: Vec<u8>| files.push(File { path, bytes });

    add("core.toml".to_owned(), spec_text(design).into_bytes());
    let sheet = match (design.block(), account) {
        (BlockDesign::Shader(shader), Account::Shader(error)) => datasheet::shader_sheet(shader, error)?,
        (BlockDesign::Lobe(lobe), Account::Lobe { measured, other_form }) => {
            datasheet::datasheet(lobe, measured, other_form.as_ref())?
        }
        (BlockDesign::Image(image), Account::Image(error)) => datasheet::image_sheet(image, error)?,
        _ => unreachable!("the account is the core's"),
    };
    add("README.md".to_owned(), sheet.into_bytes());
    for &language in &spec.languages {
        let mut add_part = |part: Part, text: String, wrapper| -> Result<(), Error> {
            let (golden, complemented) = match wrapper {
                Wrapper::Table(table) | Wrapper::Axis(_, _, Some(table)) if table.words.is_some() => {
                    (&samples_path, &complemented_samples)
                }
                _ => (&golden_path, &complemented),
            };
            let bench = emit::test_bench(language, &layout, &texts, golden, complemented, wrapper, memory.as_ref())?;
            add(part.rtl_path(design, language), text.into_bytes());
            add(part.bench_path(design, language), bench.into_bytes());
            Ok(())
        };
        add_part(Part::Core, emit::backend(language).emit(&layout, &texts)?, Wrapper::None)?;
        if let Some(sequencer) = &sequencer {
            add_part(Part::Lights, sequencer.emit(language, &texts)?, Wrapper::Sequencer(sequencer))?;
        }
        if let Some(table) = &table {
            add_part(Part::Table, table.emit(language, &texts)?, Wrapper::Table(table))?;
        }
        if let Some(axis) = &axis {
            let text = axis.emit(language, &whole_texts(design))?;
            add_part(Part::Axis, text, Wrapper::Axis(axis, sequencer.as_ref(), table.as_ref()))?;
        }
        if let Some(memory) = &memory {
            add(memory_path(memory, language), memory.emit(language, &texts)?.into_bytes());
        }
    }
    light_function(design)?.into_iter().for_each(|(path, text)| add(path, text.into_bytes()));
    for table in design.tables() {
        for &format in &spec.rom_formats {
            let File { path, bytes } = rom_file(design, table, format);
            add(path, bytes);
        }
    }
    add(golden_path, golden.to_text(design).into_bytes());
    if !samples.is_empty() {
        add(samples_path, golden::samples_text(design, &samples).into_bytes());
    }
    // The option is a Verilog one: a simulator that takes the list takes one language.
    let listed = spec.languages.iter().find(|&&language| language == Language::Verilog).or(spec.languages.first());
    let parts = Part::of(design);
    let sources = |&language: &Language| parts.iter().map(move |part| part.rtl_path(design, language) + "\n");
    let list: String = listed.into_iter().flat_map(sources).collect();
    add("files.f".to_owned(), list.into_bytes());

    if let Block::Image(ImageSpec { image, source: ImageSource::Samples(samples), exposure }) = &spec.block {
        let inside = |(name, bytes)| File { path: format!("{REFLECTANCE_DIRECTORY}/{name}"), bytes };
        files.extend(samples.files(image, *exposure)?.into_iter().map(inside));
    }
    files.extend(others);
    let manifest = manifest::text(design, account, &files);
    files.push(File { path: "manifest.json".to_owned(), bytes: (manifest + "\n").into_bytes() });
    Ok(files)
}

/// The files of the C function that makes the records of lights, of a core that takes such: their paths in the core's
/// directory and their texts.
///
/// # Errors
/// A template that cannot be filled in.
pub fn light_function(design: &Design) -> Result<Vec<(String, String)>, Error> {
    let BlockDesign::Image(image) = design.block() else { return Ok(Vec::new()) };
    let spec = &design.spec;
    let Some(mut function) = LightFunction::of(image) else { return Ok(Vec::new()) };
    let what = format!("the records of lights for the core {}", spec.name);
    function.header = head(spec, &format!("{}_light", spec.name), &what, "function");
    Ok(LightFunction::paths(&spec.name).into_iter().zip(function.emit()?).collect())
}

/// A count of things in words; `one` is the word for one of them.
pub(crate) fn counted(count: impl Into<u64>, one: &str) -> String {
    let count = count.into();
    format!("{count} {one}{}", if count == 1 { "" } else { "s" })
}

/// Numbers to 9 significant digits, which is more than they mean and hides the last bits of sums.
pub(crate) fn rounded(value: serde_json::Value) -> serde_json::Value {
    match value {
        serde_json::Value::Number(number) => match number.as_f64().filter(|_| number.is_f64()) {
            Some(float) => json!(format!("{float:.8e}").parse::<f64>().unwrap_or(float)),
            None => serde_json::Value::Number(number),
        },
        serde_json::Value::Array(items) => items.into_iter().map(rounded).collect(),
        serde_json::Value::Object(map) => map.into_iter().map(|(key, value)| (key, rounded(value))).collect(),
        other => other,
    }
}
