//! Compares the methods: `cargo run --release --example methods` writes docs/methods.md and docs/methods.csv.
//!
//! Every figure is of the bit-exact arithmetic; what the cores cost is in docs/trade.csv.

use std::error::Error;
use std::fmt::Write;
use std::path::Path;

use brdfgen::core::Design;
use brdfgen::emit::package;
use brdfgen::method::{Use, variants};
use brdfgen::spec::SpecFields;

/// The shininesses at which errors are measured.
const MEASURED: [u32; 3] = [10, 100, 1000];

fn design(method: &str) -> Result<Design, brdfgen::platform::error::Error> {
    let text = format!("{method}\nshininess = '1..=1000'\ninput_fraction = 16\noutput_fraction = 16");
    Design::new(SpecFields::parse(&text, "method")?.resolve()?)
}

/// What is measured over every cosine in [0, 1] for one shininess.
struct Errors {
    max_abs: f64,
    max_rel_epicentre: f64,
    rms: f64,
    decreases: usize,
    negative: usize,
    max_step_error_ulps: f64,
    jump: f64,
}

impl Errors {
    fn of(design: &Design, n: u32) -> Self {
        let (set, format) = (&design.lobe().interface.shininess, design.lobe().output_format());
        let index = n << set.frac_bits();
        let row = set.row_of_index(index);
        let codes = 1i64 << design.lobe().interface.input_fraction;
        let mut outputs = vec![0u32; codes as usize + 1];
        design.evaluator().evaluate(index, 0, 1, &mut outputs);
        let lobe = &design.lobe().lobes[row];
        let hardware: Vec<f64> = outputs.iter().map(|&code| format.value(code.into())).collect();
        let method: Vec<f64> = (0..=codes).map(|code| lobe.at(design.lobe().versine(code))).collect();
        let exact: Vec<f64> = (0..=codes).map(|code| design.lobe().exact(row, code)).collect();
        let off = |(a, b): (&f64, &f64)| (a - b).abs();
        let errors: Vec<f64> = hardware.iter().zip(&exact).map(off).collect();
        let relative =
            errors.iter().zip(&exact).filter(|(_, exact)| **exact >= 0.5).map(|(error, exact)| error / exact);
        let steps = |values: &[f64]| -> Vec<f64> { values.windows(2).map(|pair| (pair[1] - pair[0]).abs()).collect() };
        let beyond = |of: &[f64]| {
            let pairs = steps(&hardware).into_iter().zip(steps(of));
            pairs.map(|(own, of)| (own - of) / format.lsb()).fold(0.0, f64::max)
        };
        Self {
            max_abs: errors.iter().copied().fold(0.0, f64::max),
            max_rel_epicentre: relative.fold(0.0, f64::max),
            rms: (errors.iter().map(|error| error * error).sum::<f64>() / errors.len() as f64).sqrt(),
            decreases: hardware.windows(2).filter(|pair| pair[1] < pair[0]).count(),
            negative: hardware.iter().filter(|&&value| value < 0.0).count(),
            max_step_error_ulps: beyond(&method),
            jump: beyond(&exact),
        }
    }
}

/// A core's size and its errors at the measured shininesses.
struct Entry {
    rom_bits: usize,
    multipliers: String,
    latency: u32,
    errors: Vec<Errors>,
}

impl Entry {
    fn of(design: &Design) -> Self {
        let multipliers: Vec<String> =
            design.function().multipliers().iter().map(|(a, b)| format!("{a}x{b}")).collect();
        Self {
            rom_bits: design.tables().iter().map(brdfgen::fixed::Table::bits).sum(),
            multipliers: if multipliers.is_empty() { "none".to_owned() } else { multipliers.join(" ") },
            latency: design.schedule.latency,
            errors: MEASURED.iter().map(|&n| Errors::of(design, n)).collect(),
        }
    }
}

const ABOUT: &str = "\
# The methods, measured

Written by `cargo run --release --example methods`; the same figures are in methods.csv. All cores serve the integers \
n = 1 to 1000
(those with 3 fraction bits of in_n also eighths between them) and have F = G = 16 fraction bits. What they cost is in
[targets.md](targets.md) and trade.csv.

The errors are those of the bit-exact evaluator, which the tests hold equal to the reference model, at n = 10, 100 and \
1000, over every code of
the cosine in [0, 1], 65537 of them, against x^n:

- *max abs*: the largest |y - x^n|; *rel*: the largest |y - x^n| / x^n where x^n >= 1/2; *RMS*: the root of the mean \
of (y - x^n)^2.
- *falls*: the pairs of adjacent codes at which the output falls as the cosine rises. *negative*: the codes with a \
result below 0;
  the output's format has none.
- *seam*: over all pairs of adjacent codes, and so also at the cusp, at the cut and at the bounds of segments, the \
most by which the core's step
  |y(i+1) - y(i)| exceeds that of the real-valued method there, in ulps of the output: what the hardware adds to a \
  seam. Steps of
  one ulp where the method hardly moves make it up to 1, rounding up to 2.
- *jump*: the same against x^n in place of the method: the largest discontinuity that the method has, as one sees it. \
A held tail has
  it between the codes 0 and 1, as the result is 0 at x = 0.

Multipliers are given by the widths of their operands (those wider than a DSP block, 18x18, are built of several), \
ROM bits as the depth of each memory times its word.
";

fn sig(value: f64) -> String {
    format!("{value:.3e}")
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut refused = Vec::new();
    let mut entries = Vec::new();
    for (about, variant) in variants(Use::Table) {
        let name = variant.full_name(about);
        match design(&variant.spec(about)) {
            Ok(design) => entries.push((name, Entry::of(&design))),
            Err(error) => refused.push(format!("{name}: {error}")),
        }
    }
    if !refused.is_empty() {
        return Err(format!("no core of\n{}", refused.join("\n")).into());
    }

    let mut text = ABOUT.to_owned();
    let mut csv = "method,rom_bits,multipliers,latency".to_owned();
    for n in MEASURED {
        for what in ["max_abs", "max_rel_epicentre", "rms", "falls", "negative", "seam_ulps", "jump_ulps"] {
            write!(csv, ",{what}_{n}")?;
        }
    }
    csv += "\n";
    text += "\n| method | ROM bits | multipliers | latency |\n| --- | ---: | --- | ---: |\n";
    for (name, entry) in &entries {
        writeln!(text, "| {name} | {} | {} | {} |", entry.rom_bits, entry.multipliers, entry.latency)?;
        write!(csv, "\"{name}\",{},{},{}", entry.rom_bits, entry.multipliers, entry.latency)?;
        for e in &entry.errors {
            let (abs, rel, rms) = (sig(e.max_abs), sig(e.max_rel_epicentre), sig(e.rms));
            write!(
                csv,
                ",{abs},{rel},{rms},{},{},{:.2},{:.2}",
                e.decreases, e.negative, e.max_step_error_ulps, e.jump
            )?;
        }
        csv += "\n";
    }
    for (place, n) in MEASURED.iter().enumerate() {
        write!(text, "\n## n = {n}\n\n")?;
        text += "| method | max abs | rel | RMS | falls | negative | seam | jump |\n";
        text += "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";
        for (name, entry) in &entries {
            let e = &entry.errors[place];
            let (abs, rel, rms) = (sig(e.max_abs), sig(e.max_rel_epicentre), sig(e.rms));
            let (decreases, negative) = (e.decreases, e.negative);
            writeln!(
                text,
                "| {name} | {abs} | {rel} | {rms} | {decreases} | {negative} | {:.2} | {:.1} |",
                e.max_step_error_ulps, e.jump
            )?;
        }
    }

    package::write_file(Path::new("docs/methods.md"), text.as_bytes())?;
    package::write_file(Path::new("docs/methods.csv"), csv.as_bytes())?;
    Ok(())
}
