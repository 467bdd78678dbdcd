//! The golden vectors of a core as data: what they hold, their file's text, and what a core whose memories can be
//! written gives for them with other words. Which inputs become vectors is chosen in [`crate::verify::golden`].

use std::collections::BTreeMap;
use std::fmt::Write;

use serde::Serialize;

use super::{BlockDesign, Design, Direction};
use crate::datapath::simulate::Inputs;
use crate::fixed::{Format, Rng, Table};
use crate::platform::error::Error;
use crate::spec::Block;

/// The codes at the inputs, those expected at the outputs, and the pauses before.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Vector {
    /// The codes of the input ports, in their order, as numbers (negative for negative cosines).
    pub inputs: Vec<i64>,
    /// The codes of the output ports, in their order.
    pub outputs: Vec<i64>,
    /// Enabled clocks without a valid input before this one.
    pub idle: u32,
    /// Clocks with `ce` low while this one waits.
    pub stall: u32,
}

impl Vector {
    /// The levels at the input ports clock by clock: during the pauses, with the codes inverted, and then when it goes
    /// in.
    pub(crate) fn clocks(&self, ports: &[(&str, Format)]) -> impl Iterator<Item = Inputs> {
        let codes: Vec<i128> = self.inputs.iter().copied().map(i128::from).collect();
        let inverted = codes.iter().zip(ports).map(|(&code, (_, format))| format.wrap(!code)).collect();
        let idle = Inputs { rst: false, ce: true, in_valid: false, codes: inverted };
        let stalled = Inputs { ce: false, in_valid: true, ..idle.clone() };
        let taken = Inputs { in_valid: true, codes, ..idle.clone() };
        let pauses = std::iter::repeat_n(idle, self.idle as usize);
        pauses.chain(std::iter::repeat_n(stalled, self.stall as usize)).chain(std::iter::once(taken))
    }
}

/// The levels at the input ports clock by clock while vectors run, until all results are out.
pub(crate) fn clocks(design: &Design, vectors: &[&Vector]) -> Vec<Inputs> {
    let ports = design.numbers(Direction::In);
    let taken = vectors.iter().flat_map(|vector| vector.clocks(&ports));
    taken.chain(idle(design)).collect()
}

/// Clocks without an operand, as many as a result takes.
pub(crate) fn idle(design: &Design) -> impl Iterator<Item = Inputs> {
    std::iter::repeat_n(Inputs { ce: true, ..Inputs::default() }, design.schedule.latency as usize)
}

/// The digest of one shininess.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct RowDigest {
    /// The code of the first input port, `in_n` or `in_material`; of an image-based block the stream.
    pub index: u32,
    /// XXH3-64 of the outputs, each as four little-endian bytes: for all operand codes, the least first, or for the
    /// samples of a stream.
    pub digest: u64,
}

/// The golden vectors of a core.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Golden {
    /// The core's name.
    pub core: String,
    /// The digest of its spec.
    pub spec_digest: String,
    /// The vectors, in groups with a heading.
    pub groups: Vec<(String, Vec<Vector>)>,
    /// The digests.
    pub digests: Vec<RowDigest>,
}

/// The most outputs that the digests of a file cover; with more, only evenly spaced rows have one.
const MOST_OUTPUTS: u64 = 1 << 30;

/// The same for the samples of a shader's streams.
const MOST_SAMPLES: u64 = 1 << 20;

/// The stream of random numbers that samples through a table of lights are drawn from.
const SAMPLES: u64 = 1 << 40;

/// The streams of an image-based block.
const IMAGE_STREAMS: usize = 4;

/// Samples of a stream.
pub(crate) const STREAM: u64 = 1 << 13;

/// The rows that have a digest: all, or evenly spaced ones where all would take too long.
pub(crate) fn digest_rows(design: &Design) -> Vec<usize> {
    let (rows, step) = match design.block() {
        BlockDesign::Lobe(lobe) => {
            let rows = lobe.interface.shininess.rows();
            (rows, ((rows as u64) << lobe.operand_format().width()).div_ceil(MOST_OUTPUTS).max(1))
        }
        BlockDesign::Shader(shader) => {
            let rows = shader.materials().len();
            (rows, (rows as u64 * STREAM).div_ceil(MOST_SAMPLES))
        }
        BlockDesign::Image(_) => (IMAGE_STREAMS, 1),
    };
    (0..rows).step_by(step as usize).collect()
}

const ALLOWED: &str = "a golden file holds `v` lines (the codes of the inputs and of the outputs in hexadecimal; \
                       idle, stall in decimal), `d` lines (the first input's code, digest), one `c` line (the number \
                       of vectors) and comments that begin with `#`";

impl Golden {
    /// All vectors, in order.
    #[must_use]
    pub fn vectors(&self) -> Vec<&Vector> {
        self.groups.iter().flat_map(|(_, vectors)| vectors).collect()
    }

    /// The file's text.
    #[must_use]
    pub fn to_text(&self, design: &Design) -> String {
        let digits = |format: Format| format.width().div_ceil(4) as usize;
        let (inputs, outputs) = (design.numbers(Direction::In), design.numbers(Direction::Out));
        let numbers = [&inputs[..], &outputs].concat();
        let ports: Vec<String> = numbers
            .iter()
            .map(|(name, format)| format!("{name} ({format}{})", if format.signed { ", two's complement" } else { "" }))
            .collect();
        let count: usize = self.groups.iter().map(|(_, vectors)| vectors.len()).sum();
        let mut text = format!(
            "# brdfgen golden vectors\n\
             # core {}\n\
             # spec {}\n\
             # v {} in hexadecimal; in decimal: idle, the\n\
             #   clocks without a valid input before the vector; stall, the clocks with ce low while it waits\n\
             c {count}\n",
            self.core,
            self.spec_digest,
            ports.join(", "),
        );
        for (heading, vectors) in &self.groups {
            let _ = writeln!(text, "# {heading}");
            vectors.iter().for_each(|vector| text += &line(vector, &numbers));
        }
        let (index, index_format) = inputs[0];
        let ni = digits(index_format);
        let shown: Vec<&str> = outputs.iter().map(|&(name, _)| name).collect();
        let over = match design.spec.block {
            Block::Lobe(_) => format!("all {} codes of {}, the least first", 1u64 << inputs[1].1.width(), inputs[1].0),
            Block::Shader(..) => format!("the {STREAM} samples of its stream"),
            Block::Image(_) => format!("the {STREAM} samples of this stream"),
        };
        let index = if matches!(design.spec.block, Block::Image(_)) { "stream" } else { index };
        let _ = writeln!(text, "# d {index}, XXH3-64 over {} for {over}, 4 little-endian bytes each", shown.join(", "));
        for d in &self.digests {
            let _ = writeln!(text, "d {:0ni$x} {:016x}", d.index, d.digest);
        }
        text
    }
}

/// What goes through a table of lights that is not written: the words that a sample is of, its other inputs, and its
/// codes.
///
/// For each golden vector there is one with the same normal and the same pauses: of a word or a few, the first of all
/// words.
#[must_use]
pub fn samples(design: &Design, golden: &Golden) -> Vec<Vector> {
    let Some(words) = design.light_words() else { return Vec::new() };
    let mut rng = Rng::new(SAMPLES);
    let depth = words.len() as u64;
    let of_sample = design.numbers(Direction::In).len() - design.light_inputs().len();
    let sample = |(number, vector): (usize, &Vector)| {
        let begin = rng.below(depth);
        let more = match (number, rng.below(3)) {
            (0, _) => depth - 1,
            (_, 0) => rng.below(depth.min(8)),
            _ => 0,
        };
        let ends = [begin, (begin + more) % depth].map(|word| word as i64);
        let inputs = [&ends[..], &vector.inputs[..of_sample]].concat();
        let outputs = sample_codes(design, &words, &inputs, |inputs| design.evaluate(inputs));
        Vector { inputs, outputs, ..*vector }
    };
    golden.vectors().into_iter().enumerate().map(sample).collect()
}

/// The codes of a sample through a table of these words, by what the core gives at each of its own.
fn sample_codes(design: &Design, words: &[Vec<i64>], inputs: &[i64], core: impl Fn(&[i64]) -> Vec<i64>) -> Vec<i64> {
    let depth = words.len();
    let [begin, end] = [inputs[0] as usize, inputs[1] as usize];
    let count = (end + depth - begin) % depth + 1;
    let clocks = (0..count).map(|word| core(&[&inputs[2..], &words[(begin + word) % depth]].concat()));
    design.sample_of(&clocks.collect::<Vec<_>>())
}

/// Some of these samples with the codes that come of [`complemented_tables`], as [`complemented`] has it for vectors.
#[must_use]
pub fn complemented_samples(design: &Design, samples: &[Vector]) -> Vec<Vector> {
    if design.write_ports().is_empty() {
        return Vec::new();
    }
    let (tables, graph) = (complemented_tables(design), design.graph());
    let words = design.light_words().unwrap_or_default();
    let other = |sample: &Vector| {
        let outputs = sample_codes(design, &words, &sample.inputs, |inputs| graph.results(&tables, inputs));
        Vector { inputs: sample.inputs.clone(), outputs, idle: 0, stall: 0 }
    };
    let step = samples.len().div_ceil(MOST_COMPLEMENTED * 8).max(1);
    let both = samples.iter().step_by(step).map(|sample| (sample, other(sample)));
    both.filter(|(sample, other)| sample.outputs != other.outputs)
        .map(|(_, other)| other)
        .take(MOST_COMPLEMENTED)
        .collect()
}

/// The text of a file with such samples, which the benches read as they do golden vectors.
#[must_use]
pub fn samples_text(design: &Design, samples: &[Vector]) -> String {
    let ports = design.whole_ports();
    let numbers = ports
        .iter()
        .filter_map(|port| Some((port, port.format?)))
        .filter(|(port, _)| port.carries(Direction::In) || port.carries(Direction::Out));
    let numbers: Vec<(&str, Format)> = numbers.map(|(port, format)| (port.name.as_str(), format)).collect();
    let names: Vec<&str> = numbers.iter().map(|(name, _)| *name).collect();
    let mut text = format!(
        "# brdfgen samples through the table of lights\n# core {}\n# spec {}\n# v {} in hexadecimal; in decimal: idle, \
         stall\nc {}\n",
        design.spec.name,
        design.spec.digest(),
        names.join(", "),
        samples.len(),
    );
    samples.iter().for_each(|sample| text += &line(sample, &numbers));
    text
}

/// The line of a vector with these ports.
fn line(vector: &Vector, ports: &[(&str, Format)]) -> String {
    let mut line = String::from("v");
    for (&(_, format), &code) in ports.iter().zip(vector.inputs.iter().chain(&vector.outputs)) {
        let _ = write!(line, " {:0digits$x}", format.bits(code.into()), digits = format.width().div_ceil(4) as usize);
    }
    let _ = writeln!(line, " {} {}", vector.idle, vector.stall);
    line
}

/// The codes that hexadecimal words are at these ports, as numbers.
fn codes_of(words: &[&str], ports: &[(&str, Format)], wrong: impl Fn(String) -> Error) -> Result<Vec<i64>, Error> {
    let code = |(word, &(_, format)): (&&str, &(&str, Format))| {
        let code = u64::from_str_radix(word, 16).ok().filter(|&code| code >> format.width() == 0);
        let width = format.width();
        code.map(|code| format.wrap(code.into()) as i64)
            .ok_or_else(|| wrong(format!("`{word}` is not a {width}-bit code")))
    };
    words.iter().zip(ports).map(code).collect()
}

/// Reads a golden file of a design; `file` names it in messages.
///
/// # Errors
/// Text that is no golden file, one of another core or spec, a malformed line, a count that does not match.
pub fn parse(design: &Design, text: &str, file: &str) -> Result<Golden, Error> {
    let (inputs, outputs) = (design.numbers(Direction::In), design.numbers(Direction::Out));
    let ports = inputs.len() + outputs.len();
    let mut golden = Golden::default();
    let whole = |what: String, allowed: &str| Error::input(format!("{file}: {what}"), allowed);
    let (core, spec) = (&design.spec.name, design.spec.digest());
    let of_another = |its_core: &str, its_spec: &str| {
        whole(
            format!("these are the vectors of core {its_core} with spec {its_spec}"),
            &format!("vectors of core {core} with spec {spec} are wanted; `brdfgen golden` makes them"),
        )
    };
    // First, as the codes of another core may not fit this one's ports.
    let stated = |key: &str| text.lines().find_map(|line| line.strip_prefix(key)).map(str::trim);
    if let (Some(its_core), Some(its_spec)) = (stated("# core "), stated("# spec "))
        && (its_core, its_spec) != (core.as_str(), spec.as_str())
    {
        return Err(of_another(its_core, its_spec));
    }
    let mut declared = None;
    let mut offset = 0;
    for line in text.split_inclusive('\n') {
        let start = offset;
        offset += line.len();
        let line = line.trim_end();
        let wrong = |what: String| Error::text(what, ALLOWED, file, text, (start, line.len()));
        match line.split_ascii_whitespace().collect::<Vec<_>>().as_slice() {
            [] => {}
            ["#", "core", name] => golden.core = (*name).to_owned(),
            ["#", "spec", digest] => golden.spec_digest = (*digest).to_owned(),
            ["#", rest @ ..] => golden.groups.push((rest.join(" "), Vec::new())),
            ["c", count] => {
                declared = Some(count.parse::<usize>().map_err(|_| wrong(format!("`{count}` is not a count")))?);
            }
            ["v", codes @ .., idle, stall] if codes.len() == ports => {
                let (given, expected) = codes.split_at(inputs.len());
                let (inputs, outputs) = (codes_of(given, &inputs, wrong)?, codes_of(expected, &outputs, wrong)?);
                let clocks =
                    |word: &str| word.parse().map_err(|_| wrong(format!("`{word}` is not a number of clocks")));
                let vector = Vector { inputs, outputs, idle: clocks(idle)?, stall: clocks(stall)? };
                match golden.groups.last_mut() {
                    Some((_, vectors)) => vectors.push(vector),
                    None => golden.groups.push((String::new(), vec![vector])),
                }
            }
            ["d", n, digest] => {
                let whole = digest.len() == 16;
                let parsed =
                    u32::from_str_radix(n, 16).ok().zip(u64::from_str_radix(digest, 16).ok()).filter(|_| whole);
                let (index, digest) = parsed.ok_or_else(|| wrong("the digest line is malformed".to_owned()))?;
                golden.digests.push(RowDigest { index, digest });
            }
            _ => return Err(wrong("this line is malformed".to_owned())),
        }
    }
    let found = golden.vectors().len();
    match declared {
        None => return Err(whole("this is no golden file: it has no `c` line".to_owned(), ALLOWED)),
        Some(declared) if declared != found => {
            return Err(whole(
                format!("{declared} vectors are announced and {found} are there"),
                "the file is truncated or edited",
            ));
        }
        Some(_) => {}
    }
    if (&golden.core, &golden.spec_digest) != (core, &spec) {
        return Err(of_another(&golden.core, &golden.spec_digest));
    }
    let digests = digest_rows(design).len();
    if golden.digests.len() != digests {
        return Err(whole(
            format!("{digests} digests are wanted and {} are there", golden.digests.len()),
            "the file is truncated or edited",
        ));
    }
    Ok(golden)
}

/// Vectors that are tried with other words; as many shininesses.
const MOST_COMPLEMENTED: usize = 64;

/// A memory of a design that can be written, with every bit of every word inverted; any other as it is.
#[must_use]
pub fn complemented_tables(design: &Design) -> Vec<Table> {
    let ports = design.write_ports();
    let written = |memory: usize| ports.iter().any(|port| port.memory == memory);
    let tables = design.tables().iter().enumerate();
    tables.map(|(memory, table)| if written(memory) { table.complemented() } else { table.clone() }).collect()
}

/// Some inputs of the golden vectors, at evenly spaced codes of the first port, with the outputs that the core gives
/// for them when [`complemented_tables`] are in its memories. They are such as differ from the golden outputs, as far
/// as there are any, so that a core that was not written to does not pass. None for a core that cannot be written.
///
/// The inverted words are far outside what the error analysis is about: what they give is a number all the same, since
/// every operation takes its result modulo its format's width.
#[must_use]
pub fn complemented(design: &Design, golden: &Golden) -> Vec<Vector> {
    if design.write_ports().is_empty() {
        return Vec::new();
    }
    let tables = complemented_tables(design);
    let graph = design.graph();
    // For each code of the first port those that differ, or all if none does.
    let mut of_index: BTreeMap<i64, (bool, Vec<Vector>)> = BTreeMap::new();
    for vector in golden.vectors() {
        let outputs = graph.results(&tables, &vector.inputs);
        let differs = outputs != vector.outputs;
        let (known, vectors) = of_index.entry(vector.inputs[0]).or_default();
        if differs && !*known {
            *known = true;
            vectors.clear();
        }
        if differs || !*known {
            vectors.push(Vector { inputs: vector.inputs.clone(), outputs, idle: 0, stall: 0 });
        }
    }
    if of_index.values().any(|&(differs, _)| differs) {
        of_index.retain(|_, (differs, _)| *differs);
    }
    let step = of_index.len().div_ceil(MOST_COMPLEMENTED).max(1);
    // The middle one is neither at the start of the lobe nor far beyond its end.
    of_index.into_values().step_by(step).map(|(_, mut vectors)| vectors.swap_remove(vectors.len() / 2)).collect()
}
