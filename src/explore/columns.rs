//! Points as the lines of a CSV table.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::{Estimate, Point, Shape};
use crate::platform::error::Error;
use crate::platform::input;
use crate::spec::SpecFields;
use crate::synth::{Resources, Synthesis, Timing, Tools};
use crate::target::Family;

/// The table of points.
pub(super) fn write(points: &[Point]) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for point in points {
        writer.serialize(PointRow::of(point)).expect("a row of plain values");
    }
    String::from_utf8(writer.into_inner().expect("a buffer takes all")).expect("CSV of text is text")
}

/// The points of a table, and the line of each.
pub(super) fn read(text: &str, file: &str) -> Result<(Vec<Point>, Vec<usize>), Error> {
    input::check_separator(text, file)?;
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    // A line is longer than a screen: its number says more than its text.
    let wrong = |what: String, line: usize| {
        Error::input(format!("{file}, line {line}: {what}"), "results of `brdfgen explore` as CSV")
    };
    let heads = reader.headers().map_err(|error| wrong(error.to_string(), 1))?.clone();
    if heads.is_empty() {
        return Err(wrong("there is no line of headings".to_owned(), 1));
    }
    let (mut points, mut lines) = (Vec::new(), Vec::new());
    let line_of = |position: Option<&csv::Position>| line_at(text, position.map_or(0, |at| at.byte() as usize));
    for record in reader.records() {
        let record = record.map_err(|error| {
            let line = line_of(error.position());
            let what = match error.kind() {
                csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
                    format!("it has {len} fields, where the headings are {expected_len}")
                }
                _ => error.to_string(),
            };
            wrong(what, line)
        })?;
        let line = line_of(record.position());
        let row: PointRow =
            record.deserialize(Some(&heads)).map_err(|error| wrong(misread(&error, &record, &heads), line))?;
        points.push(row.point().map_err(|what| wrong(what, line))?);
        lines.push(line);
    }
    Ok((points, lines))
}

/// Why a line is no point, and in which column.
fn misread(error: &csv::Error, record: &csv::StringRecord, heads: &csv::StringRecord) -> String {
    let csv::ErrorKind::Deserialize { err, .. } = error.kind() else { return error.to_string() };
    let at = err.field().map(|field| field as usize);
    let value = at.and_then(|at| record.get(at)).unwrap_or_default();
    let what = match err.kind() {
        csv::DeserializeErrorKind::ParseInt(_) if value.is_empty() => "a count is missing".to_owned(),
        csv::DeserializeErrorKind::ParseFloat(_) if value.is_empty() => "a number is missing".to_owned(),
        csv::DeserializeErrorKind::ParseInt(_) => {
            format!("{value:?} is no count, a whole number from 0 of at most 32 bits")
        }
        csv::DeserializeErrorKind::ParseFloat(_) => format!("{value:?} is no number"),
        kind => kind.to_string(),
    };
    match at.and_then(|at| heads.get(at)) {
        Some(column) => format!("{column}: {what}"),
        None => what,
    }
}

/// A struct with the fields that a point and its row have alike taken from the other, and with its own.
macro_rules! same_fields {
    ($kind:ident of $from:ident, $($own:tt)*) => {
        $kind {
            id: $from.id,
            name: $from.name,
            family: $from.family,
            method: $from.method,
            coefficients: $from.coefficients,
            variant: $from.variant,
            baseline: $from.baseline,
            shininess: $from.shininess,
            rows: $from.rows,
            input_fraction: $from.input_fraction,
            output_fraction: $from.output_fraction,
            pipeline: $from.pipeline,
            max_abs: $from.max_abs,
            max_rel: $from.max_rel,
            rms: $from.rms,
            worst_n: $from.worst_n,
            worst_x: $from.worst_x,
            checked: $from.checked,
            bound: $from.bound,
            rom_bits: $from.rom_bits,
            latency: $from.latency,
            $($own)*
        }
    };
}

/// Figures that are all there, or all missing; says which are missing where others are there.
fn all_or_none<T, const N: usize>(what: &str, figures: [(&str, Option<T>); N]) -> Result<Option<[T; N]>, String> {
    let missing: Vec<&str> = figures.iter().filter(|(_, value)| value.is_none()).map(|(name, _)| *name).collect();
    if missing.is_empty() {
        return Ok(Some(figures.map(|(_, value)| value.expect("none is missing"))));
    }
    if missing.len() == N { Ok(None) } else { Err(format!("{what} has no {}, and has the rest", missing.join(", "))) }
}

/// A point as a line of the table.
#[derive(Debug, Serialize, Deserialize)]
struct PointRow {
    id: String,
    name: String,
    family: Family,
    method: String,
    coefficients: String,
    variant: String,
    baseline: bool,
    shininess: String,
    rows: u32,
    input_fraction: u32,
    output_fraction: u32,
    pipeline: String,
    max_abs: f64,
    max_rel: f64,
    rms: f64,
    worst_n: f64,
    worst_x: f64,
    checked: String,
    bound: f64,
    rom_bits: u64,
    latency: u32,
    multipliers: String,
    memories: String,
    adder_bits: u32,
    mux_bits: u32,
    shift_bits: u32,
    register_bits: u32,
    lut_total: Option<u32>,
    lut: Option<u32>,
    carry: Option<u32>,
    ff: Option<u32>,
    dsp: Option<u32>,
    bram: Option<u32>,
    min_mhz: Option<f64>,
    median_mhz: Option<f64>,
    max_mhz: Option<f64>,
    mhz_by_seed: String,
    target_mhz: Option<f64>,
    latency_ns: Option<f64>,
    results_per_second: Option<f64>,
    device: String,
    yosys: String,
    nextpnr: String,
    cells: String,
    estimated_lut: Option<u32>,
    estimated_ff: Option<u32>,
    estimated_dsp: Option<u32>,
    estimated_bram: Option<u32>,
    estimated_mhz: Option<f64>,
    estimated_from: Option<u32>,
    estimated_yosys: String,
    estimated_nextpnr: String,
    failure: String,
    spec: String,
}

/// Words with spaces between.
fn words(items: impl Iterator<Item = String>) -> String {
    items.collect::<Vec<_>>().join(" ")
}

/// What words with spaces between say.
fn parsed<T: std::str::FromStr<Err = String>>(text: &str) -> Result<Vec<T>, String> {
    text.split_ascii_whitespace().map(str::parse).collect()
}

impl PointRow {
    fn of(point: &Point) -> Self {
        let synthesis = point.synthesis.as_ref();
        let resources = synthesis.map(|synthesis| &synthesis.resources);
        let timing = synthesis.and_then(|synthesis| synthesis.timing.as_ref());
        let estimate = point.estimate.as_ref();
        let count = |of: fn(&Resources) -> u32| resources.map(of);
        let mhz = |of: fn(&Timing) -> f64| timing.map(of);
        let guess = |of: fn(&Estimate) -> u32| estimate.map(of);
        let tool = |tools: Option<&Tools>| -> [String; 2] {
            tools.map(|t| [t.yosys.clone(), t.nextpnr.clone().unwrap_or_default()]).unwrap_or_default()
        };
        let [yosys, nextpnr] = tool(synthesis.map(|synthesis| &synthesis.tools));
        let [estimated_yosys, estimated_nextpnr] = tool(estimate.map(|estimate| &estimate.tools));
        let point = point.clone();
        same_fields!(PointRow of point,
            multipliers: words(point.shape.multipliers.iter().map(ToString::to_string)),
            memories: words(point.shape.memories.iter().map(ToString::to_string)),
            adder_bits: point.shape.adder_bits,
            mux_bits: point.shape.mux_bits,
            shift_bits: point.shape.shift_bits,
            register_bits: point.shape.register_bits,
            lut_total: count(|resources| resources.lut_total),
            lut: count(|resources| resources.lut),
            carry: count(|resources| resources.carry),
            ff: count(|resources| resources.ff),
            dsp: count(|resources| resources.dsp),
            bram: count(|resources| resources.bram),
            min_mhz: mhz(|timing| timing.min_mhz),
            median_mhz: mhz(|timing| timing.median_mhz),
            max_mhz: mhz(|timing| timing.max_mhz),
            mhz_by_seed: words(timing.iter().flat_map(|timing| &timing.mhz).map(f64::to_string)),
            target_mhz: mhz(|timing| timing.target_mhz),
            latency_ns: synthesis.and_then(|synthesis| synthesis.latency_ns),
            results_per_second: synthesis.and_then(|synthesis| synthesis.results_per_second),
            device: synthesis.map(|synthesis| synthesis.device.clone()).unwrap_or_default(),
            yosys,
            nextpnr,
            cells: words(resources.iter().flat_map(|r| &r.cells).map(|(cell, count)| format!("{cell}={count}"))),
            estimated_lut: guess(|estimate| estimate.lut),
            estimated_ff: guess(|estimate| estimate.ff),
            estimated_dsp: guess(|estimate| estimate.dsp),
            estimated_bram: guess(|estimate| estimate.bram),
            estimated_mhz: estimate.and_then(|estimate| estimate.mhz),
            estimated_from: guess(|estimate| estimate.points),
            estimated_yosys,
            estimated_nextpnr,
            failure: point.failure.unwrap_or_default(),
            spec: inline(&point.spec),
        )
    }

    fn point(self) -> Result<Point, String> {
        let (synthesis, estimate) = (self.synthesis()?, self.estimate()?);
        let shape = Shape {
            multipliers: parsed(&self.multipliers)?,
            memories: parsed(&self.memories)?,
            adder_bits: self.adder_bits,
            mux_bits: self.mux_bits,
            shift_bits: self.shift_bits,
            register_bits: self.register_bits,
        };
        let (failure, spec) = (filled(&self.failure), outlined(&self.spec)?);
        Ok(same_fields!(Point of self, shape, synthesis, estimate, failure, spec))
    }

    fn timing(&self) -> Result<Option<Timing>, String> {
        let figures = [
            ("target_mhz", self.target_mhz),
            ("min_mhz", self.min_mhz),
            ("median_mhz", self.median_mhz),
            ("max_mhz", self.max_mhz),
        ];
        let Some([target_mhz, min_mhz, median_mhz, max_mhz]) = all_or_none("the placement", figures)? else {
            return Ok(None);
        };
        let mhz: Result<Vec<f64>, _> = self.mhz_by_seed.split_ascii_whitespace().map(str::parse).collect();
        let mhz = mhz.map_err(|_| format!("mhz_by_seed is {:?}, not numbers", self.mhz_by_seed))?;
        Ok(Some(Timing { target_mhz, mhz, min_mhz, median_mhz, max_mhz, limits: Vec::new() }))
    }

    fn synthesis(&self) -> Result<Option<Synthesis>, String> {
        let timing = self.timing()?;
        let figures = [
            ("lut_total", self.lut_total),
            ("lut", self.lut),
            ("carry", self.carry),
            ("ff", self.ff),
            ("dsp", self.dsp),
            ("bram", self.bram),
        ];
        let Some([lut_total, lut, carry, ff, dsp, bram]) = all_or_none("the synthesis", figures)? else {
            let unfit = "the placement has a clock, and the synthesis no cells";
            return if timing.is_some() { Err(unfit.to_owned()) } else { Ok(None) };
        };
        let cell = |word: &str| {
            let (name, count) = word.split_once('=')?;
            Some((name.to_owned(), count.parse().ok()?))
        };
        let cells: Option<BTreeMap<String, u32>> = self.cells.split_ascii_whitespace().map(cell).collect();
        let cells = cells.ok_or_else(|| format!("cells is {:?}, not CELL=COUNT", self.cells))?;
        Ok(Some(Synthesis {
            family: self.family,
            device: self.device.clone(),
            tools: tools(&self.yosys, &self.nextpnr),
            resources: Resources { lut, carry, lut_total, ff, dsp, bram, cells },
            timing,
            latency_clocks: self.latency,
            latency_ns: self.latency_ns,
            results_per_second: self.results_per_second,
        }))
    }

    fn estimate(&self) -> Result<Option<Estimate>, String> {
        let figures = [
            ("estimated_from", self.estimated_from),
            ("estimated_lut", self.estimated_lut),
            ("estimated_ff", self.estimated_ff),
            ("estimated_dsp", self.estimated_dsp),
            ("estimated_bram", self.estimated_bram),
        ];
        let figures = all_or_none("the estimate", figures)?;
        Ok(figures.map(|[points, lut, ff, dsp, bram]| Estimate {
            tools: tools(&self.estimated_yosys, &self.estimated_nextpnr),
            points,
            lut,
            ff,
            dsp,
            bram,
            mhz: self.estimated_mhz,
        }))
    }
}

fn filled(text: &str) -> Option<String> {
    (!text.is_empty()).then(|| text.to_owned())
}

fn tools(yosys: &str, nextpnr: &str) -> Tools {
    Tools { yosys: yosys.to_owned(), nextpnr: filled(nextpnr) }
}

/// A spec on one line: as a TOML inline table.
fn inline(spec: &str) -> String {
    let table: toml::Table = spec.parse().expect("a point holds the TOML of its spec");
    toml::Value::Table(table).to_string()
}

/// The spec of an inline table, as a file has it.
fn outlined(line: &str) -> Result<String, String> {
    #[derive(Deserialize)]
    struct Line {
        spec: SpecFields,
    }
    let line: Line = toml::from_str(&format!("spec = {line}")).map_err(|error| error.message().to_owned())?;
    Ok(line.spec.to_toml())
}

/// The number of the line that a record begins on whose position is a byte, before the line breaks that the reader
/// passes over.
fn line_at(text: &str, byte: usize) -> usize {
    let bytes = text.as_bytes();
    let begin =
        bytes.iter().skip(byte).position(|byte| !b"\r\n".contains(byte)).map_or(bytes.len(), |more| byte + more);
    text.get(..begin).map_or(1, |before| input::plain(before).matches('\n').count() + 1)
}
