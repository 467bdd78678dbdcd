//! The study as a chapter and as tables.

use askama::Template;

use super::conditioning::Conditioning;
use super::inspect::Inspection;
use super::quantisation::{FrontEnd, of_cosine};
use super::study::{Axis, Case, Entry};
use crate::emit::package::{File, Kind};
use crate::platform::error::Error;

/// The first line of `cores.csv`.
const HEADER: &str = "axis,value,method,refused,rows,inputs,blocks,overflows,undecided,wide_differences,largest_signal,\
                      largest_value,widest_signal,widest_format,narrowed_bits,measured_low_ulps,measured_high_ulps,\
                      proved_low_ulps,proved_high_ulps,max_abs,below_one,at_zero,above_one,outside_differences,falls,\
                      fall_ulps,fall_shininess,fall_cosine,seam_ulps,seam_shininess,seam_cosine";

/// The names of a study's files.
pub const FILES: [&str; 2] = ["stability.md", "cores.csv"];
/// The directory of a study's files.
pub const STUDY: Kind = Kind { what: "a study of stability", file: "cores.csv", mark: HEADER };

/// Everything that a study found.
#[derive(Clone, Debug)]
pub struct Study {
    /// The forms' conditions.
    pub conditioning: Vec<Conditioning>,
    /// Front ends with cosine and versine.
    pub front_ends: Vec<FrontEnd>,
    /// The cores.
    pub entries: Vec<Entry>,
}

/// Shininesses of the table of what rounding the input costs.
const SHININESSES: [f64; 6] = [1.0, 10.0, 100.0, 1000.0, 4096.0, 65536.0];

/// A line of the chapter's table of cores: all of an axis of a method together.
struct Line {
    method: String,
    cores: usize,
    refused: usize,
    inputs: u64,
    overflows: usize,
    wide_differences: u64,
    largest: String,
    widest: String,
    narrowed: u32,
    ulps: String,
    below_one: i64,
    max_decrease: String,
    max_step_error: String,
}

struct Section {
    title: &'static str,
    about: &'static str,
    lines: Vec<Line>,
}

#[derive(Template)]
#[template(path = "report/stability.md", escape = "none")]
struct Chapter {
    sections: Vec<Section>,
    conditioning: Vec<[String; 7]>,
    rounding: Vec<Vec<String>>,
    fractions: Vec<u32>,
    front_ends: Vec<[String; 4]>,
    places: Vec<[String; 5]>,
    refused: Vec<[String; 3]>,
    findings: Vec<String>,
    broken: Vec<String>,
    cores: usize,
    inputs: String,
}

/// Digits in groups of three.
fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let groups: Vec<&str> =
        digits.as_bytes().rchunks(3).rev().map(|group| std::str::from_utf8(group).unwrap_or_default()).collect();
    groups.join(",")
}

fn ulps(worst: &super::inspect::Worst) -> String {
    if worst.ulps == 0.0 {
        return "0".to_owned();
    }
    format!("{:.2} (n = {}, x = {:.6})", worst.ulps, worst.shininess, worst.cosine)
}

fn line(method: &str, entries: &[&Entry]) -> Line {
    let found: Vec<&Inspection> = entries.iter().filter_map(|entry| entry.found.as_ref()).collect();
    let greatest = |key: &dyn Fn(&Inspection) -> f64| {
        found.iter().copied().reduce(|best, other| if key(other) > key(best) { other } else { best })
    };
    let largest = greatest(&|of| of.largest.largest);
    let widest = greatest(&|of| f64::from(of.widest.width));
    let low = found.iter().map(|of| of.measured_ulps[0]).fold(0.0, f64::min);
    let high = found.iter().map(|of| of.measured_ulps[1]).fold(0.0, f64::max);
    Line {
        method: method.to_owned(),
        cores: found.len(),
        refused: entries.len() - found.len(),
        inputs: found.iter().map(|of| of.inputs).sum(),
        overflows: found.iter().map(|of| of.overflows.len() + of.undecided.len()).sum(),
        wide_differences: found.iter().map(|of| of.wide_differences).sum(),
        largest: largest.map_or(String::new(), |of| format!("{:.6} ({})", of.largest.largest, of.largest.name)),
        widest: widest.map_or(String::new(), |of| format!("{} ({})", of.widest.format, of.widest.name)),
        narrowed: found.iter().map(|of| of.narrowed_bits).sum(),
        ulps: format!("{low:.2}..{high:.2}"),
        below_one: found.iter().map(|of| of.below_one).max().unwrap_or(0),
        max_decrease: greatest(&|of| of.max_decrease.ulps).map_or(String::new(), |of| ulps(&of.max_decrease)),
        max_step_error: greatest(&|of| of.max_step_error.ulps).map_or(String::new(), |of| ulps(&of.max_step_error)),
    }
}

fn sections(entries: &[Entry]) -> Vec<Section> {
    let about = |axis: Axis| match axis {
        Axis::Shininess => (
            "Shininesses at and near 1, 2 and 3, 1000, 4096 and 65536",
            "Every method with its forms, both operands; 16 bits in and out.",
        ),
        Axis::Level => ("Every level Q from 0.05 to 0.95", "The methods with a level, at the same shininesses."),
        Axis::Input => (
            "Input fractions from 8 to 24",
            "n = 1, 1.001, 2, 3, 1000 and 65536; with more than 22 fraction bits, where a shininess has millions of \
             inputs, 1000 and 65536 only, but every input of these.",
        ),
        Axis::Output => ("Output fractions from 4 to 20", "n = 1, 1.001, 2, 3, 1000 and 65536."),
    };
    let axes = [Axis::Shininess, Axis::Level, Axis::Input, Axis::Output];
    let section = |axis: Axis| {
        let of_axis: Vec<&Entry> = entries.iter().filter(|entry| entry.case.axis == axis).collect();
        let mut methods: Vec<&str> = of_axis.iter().map(|entry| entry.case.method.as_str()).collect();
        methods.dedup();
        let mut seen: Vec<&str> = Vec::new();
        methods.retain(|method| {
            let new = !seen.contains(method);
            seen.push(method);
            new
        });
        let lines = methods.into_iter().map(|method| {
            let own: Vec<&Entry> = of_axis.iter().copied().filter(|entry| entry.case.method == method).collect();
            line(method, &own)
        });
        let (title, about) = about(axis);
        Section { title, about, lines: lines.collect() }
    };
    axes.into_iter().map(section).filter(|section| !section.lines.is_empty()).collect()
}

fn bits(bits: Option<i32>) -> String {
    bits.map_or("more than 62".to_owned(), |bits| bits.to_string())
}

fn chapter(study: &Study) -> Chapter {
    let fractions = vec![8, 12, 16, 20, 24];
    let conditioning = study.conditioning.iter().map(|of| {
        let [printed_low, printed_high] = of.printed_bits.map(bits);
        let [built_low, built_high] = of.built_bits.map(bits);
        let form = if of.degree == 2 { "quadratic" } else { "cubic" };
        let condition = format!("{:.4}", of.condition);
        [of.shininess.to_string(), form.to_owned(), condition, printed_low, built_low, printed_high, built_high]
    });
    let rounding = SHININESSES.iter().map(|&n| {
        let cells = fractions.iter().map(|&fraction| format!("{:.3e}", of_cosine(n, fraction)));
        std::iter::once(n.to_string()).chain(cells).collect()
    });
    let front_ends = study.front_ends.iter().map(|of| {
        [of.shininess.to_string(), of.bits.to_string(), format!("{:.3e}", of.cosine), format!("{:.3e}", of.versine)]
    });
    let found = || study.entries.iter().filter_map(|entry| Some((&entry.case, entry.found.as_ref()?)));
    // The worst of the stable forms at each place, over the cores of the first axis.
    let mut places: Vec<[String; 5]> = Vec::new();
    let of_axis: Vec<_> = found().filter(|(case, _)| case.axis == Axis::Shininess && case.value == "cosine").collect();
    for (case, of) in &of_axis {
        let worst = |names: &[&str]| {
            of.places.iter().filter(|place| names.contains(&place.name)).map(|place| place.ulps).fold(0.0, f64::max)
        };
        places.push([
            case.method.clone(),
            format!("{:.2}", worst(&["x = 0", "1 ulp"])),
            format!("{:.2}", worst(&["cusp - 1 ulp", "cusp", "cusp + 1 ulp"])),
            format!("{:.2}", worst(&["end - 1 ulp", "end", "end + 1 ulp"])),
            format!("{:.2}", worst(&["1 - 1 ulp", "x = 1"])),
        ]);
    }
    let refused = study
        .entries
        .iter()
        .filter_map(|entry| Some([entry.case.method.clone(), entry.case.value.clone(), entry.refused.clone()?]));
    let broken = found().flat_map(|(case, of)| {
        of.broken().into_iter().map(move |what| format!("{} ({}): {what}", case.method, case.value))
    });
    Chapter {
        sections: sections(&study.entries),
        conditioning: conditioning.collect(),
        rounding: rounding.collect(),
        fractions: fractions.clone(),
        front_ends: front_ends.collect(),
        places,
        refused: refused.collect(),
        findings: findings(study),
        broken: broken.collect(),
        cores: found().count(),
        inputs: grouped(found().map(|(_, of)| of.inputs).sum()),
    }
}

/// Whether a core is of a printed form.
fn is_printed(entry: &Entry) -> bool {
    entry.case.method.ends_with("printed form")
}

/// The cores of the printed forms, or the others, with what was found of each.
fn found(study: &Study, printed: bool) -> impl Iterator<Item = (&Case, &Inspection)> {
    let of = study.entries.iter().filter(move |entry| is_printed(entry) == printed);
    of.filter_map(|entry| Some((&entry.case, entry.found.as_ref()?)))
}

/// What matters most of the registers.
fn registers(study: &Study) -> String {
    let all: Vec<&Inspection> = study.entries.iter().filter_map(|entry| entry.found.as_ref()).collect();
    let overflows: usize = all.iter().map(|of| of.overflows.len() + of.undecided.len()).sum();
    let differences: u64 = all.iter().map(|of| of.wide_differences).sum();
    let outside: u64 = all.iter().map(|of| of.outside_differences).sum();
    match (overflows, differences, outside) {
        (0, 0, 0) => "**Registers.** It is proved of every core that no value overflows where the result depends on \
                      it; no result is another one with wide registers; every input beyond the ends of [0, 1] gives \
                      the end's result."
            .to_owned(),
        _ => format!(
            "**Registers.** {overflows} values overflow or are not proved to stay in their registers; {differences} \
             results differ with wide registers; {outside} inputs beyond the ends of [0, 1] give another result than \
             the end."
        ),
    }
}

/// What matters most, a sentence or two each.
fn findings(study: &Study) -> Vec<String> {
    let mut findings = vec![registers(study)];
    let found = |printed| found(study, printed);
    for of in study.conditioning.iter().filter(|of| of.degree == 3 && [1000.0, 65536.0].contains(&of.shininess)) {
        findings.push(format!(
            "**Cancellation, n = {}.** The terms of the printed cubic add up to {:.3e} times its value: for 2^-12 it \
             needs {} fraction bits in \
             every register, for 2^-16 {}. The form that is built needs {} and {}.",
            of.shininess,
            of.condition,
            bits(of.printed_bits[0]),
            bits(of.printed_bits[1]),
            bits(of.built_bits[0]),
            bits(of.built_bits[1]),
        ));
    }
    for (printed, form) in [(true, "the printed forms"), (false, "the other forms and methods")] {
        let worst = found(printed)
            .reduce(|best, other| if other.1.max_decrease.ulps > best.1.max_decrease.ulps { other } else { best });
        let falling = found(printed).filter(|(_, of)| of.max_decrease.ulps > 0.0).count();
        let steeply = found(printed).filter(|(_, of)| of.max_decrease.ulps > 1.0).count();
        let Some((case, of)) = worst else { continue };
        let largest = match of.max_decrease.ulps {
            0.0 => String::new(),
            _ => format!(" The largest fall is of {} ({}, {}).", ulps(&of.max_decrease), case.method, case.value),
        };
        findings.push(format!(
            "**Monotone.** Of {} cores of {form}, {falling} fall anywhere as the cosine rises, {steeply} of them by \
             more than one ulp.{largest}",
            found(printed).count(),
        ));
    }
    // Where every method is at the same shininesses and formats.
    let alike = || found(false).filter(|(case, _)| case.axis == Axis::Shininess && case.value == "cosine");
    let by = |wins: fn(f64, f64) -> bool| {
        alike().reduce(
            |best, other| if wins(other.1.max_step_error.ulps, best.1.max_step_error.ulps) { other } else { best },
        )
    };
    if let (Some((least, low)), Some((most, high))) = (by(|a, b| a < b), by(|a, b| a > b)) {
        findings.push(format!(
            "**Seams.** With the same shininesses and formats the largest seam is from {} ({}) to {} ulps ({}): cuts, \
             bounds of segments and lobes a few inputs wide are the methods' own; hardware adds what the column of the \
             error says.",
            ulps(&low.max_step_error),
            least.method,
            ulps(&high.max_step_error),
            most.method,
        ));
    }
    let mut inexact: Vec<&str> = found(false)
        .chain(found(true))
        .filter(|(_, of)| of.below_one > 0)
        .map(|(case, _)| case.method.as_str())
        .collect();
    inexact.sort_unstable();
    inexact.dedup();
    findings.push(match inexact.as_slice() {
        [] => "**The ends.** Every core gives exactly 1 at x = 1.".to_owned(),
        some => format!("**The ends.** All give exactly 1 at x = 1 but some cores of: {}.", some.join(", ")),
    });
    let refused = study.entries.iter().filter(|entry| entry.refused.is_some()).count();
    findings.push(match refused {
        0 => "**Refused.** No core is refused.".to_owned(),
        count => format!("**Refused.** There is no core for {count} of the specs; the reasons are listed below."),
    });
    let saved = study.front_ends.iter().filter(|of| of.bits == 16 && of.shininess >= 1000.0);
    findings.extend(saved.map(|of| {
        format!(
            "**The input, n = {}.** Vectors of 16 fraction bits make an error of {:.3} through N·H and of {:.2e} \
             through |N - H|²/2.",
            of.shininess, of.cosine, of.versine
        )
    }));
    findings
}

fn cores_table(entries: &[Entry]) -> Result<Vec<u8>, csv::Error> {
    let mut table = csv::Writer::from_writer(Vec::new());
    table.write_record(HEADER.split(','))?;
    let columns = HEADER.split(',').count();
    for Entry { case, refused, found } in entries {
        let mut row = vec![case.axis.name().to_owned(), case.value.clone(), case.method.clone()];
        row.push(refused.clone().unwrap_or_default());
        if let Some(of) = found {
            let number = |value: f64| format!("{value:.6}");
            row.extend([of.rows.to_string(), of.inputs.to_string(), of.blocks.to_string()]);
            row.extend([of.overflows.len().to_string(), of.undecided.len().to_string()]);
            row.extend([of.wide_differences.to_string(), of.largest.name.clone(), number(of.largest.largest)]);
            row.extend([of.widest.name.clone(), of.widest.format.clone(), of.narrowed_bits.to_string()]);
            row.extend(of.measured_ulps.map(number));
            row.extend(of.proved_ulps.map(number));
            row.extend([number(of.max_abs), of.below_one.to_string(), of.at_zero.to_string()]);
            row.extend([of.above_one.to_string(), of.outside_differences.to_string(), of.decreases.to_string()]);
            for worst in [of.max_decrease, of.max_step_error] {
                row.extend([number(worst.ulps), worst.shininess.to_string(), number(worst.cosine)]);
            }
        }
        row.resize(columns, String::new());
        table.write_record(row)?;
    }
    table.into_inner().map_err(|error| error.into_error().into())
}

/// The study's files: the chapter `stability.md`, and `cores.csv`, a row for each core.
///
/// # Errors
/// If a template cannot be filled in.
pub fn files(study: &Study) -> Result<Vec<File>, Error> {
    let failed = |error: String| Error::input(error, "the study cannot be written");
    let text = chapter(study).render().map_err(|error| failed(error.to_string()))?;
    let table = cores_table(&study.entries).map_err(|error| failed(error.to_string()))?;
    Ok(vec![
        File { path: FILES[0].to_owned(), bytes: (text.trim_end().to_owned() + "\n").into_bytes() },
        File { path: FILES[1].to_owned(), bytes: table },
    ])
}
