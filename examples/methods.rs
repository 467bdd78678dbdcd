//! Compares the methods: `cargo run --release --example methods -- [--yosys]` writes docs/methods.md and docs/methods.csv.
//!
//! Every figure is of the bit-exact arithmetic; with `--yosys` the cells of each core are counted as well.

use std::error::Error;
use std::fmt::Write;
use std::path::Path;
use std::process::Command;

use brdfgen::design::Design;
use brdfgen::hdl::{self, Texts};
use brdfgen::package;
use brdfgen::spec::{Language, SpecFields};
use rayon::prelude::*;

/// What is compared: a name for the table, and the spec's lines.
const METHODS: [(&str, &str); 34] = [
    ("quadratic", "method = 'quadratic'"),
    ("quadratic, minimax", "method = 'quadratic'\ncoefficients = 'minimax'"),
    ("quadratic, paper form", "method = 'quadratic'\nform = 'paper'"),
    ("cubic", "method = 'cubic'"),
    ("cubic, Q = 0.6", "method = 'cubic'\nq = 0.6"),
    ("cubic, minimax", "method = 'cubic'\ncoefficients = 'minimax'"),
    ("cubic, minimax max-abs:0.5", "method = 'cubic'\ncoefficients = 'minimax'\nobjective = 'max-abs:0.5'"),
    ("cubic, paper form", "method = 'cubic'\nform = 'paper'"),
    ("cubic, held tail", "method = 'cubic'\ntail = 'hold'"),
    ("cubic, held tail, minimax", "method = 'cubic'\ntail = 'hold'\ncoefficients = 'minimax'"),
    ("cubic-three-point", "method = 'cubic-three-point'"),
    ("cubic-three-point, held tail", "method = 'cubic-three-point'\ntail = 'hold'"),
    ("cubic-min-zero", "method = 'cubic-min-zero'"),
    ("cubic-min-zero, minimax", "method = 'cubic-min-zero'\ncoefficients = 'minimax'"),
    ("cubic-rational, digit", "method = 'cubic-rational'\ndivider = 'digit'"),
    ("cubic-rational, reciprocal", "method = 'cubic-rational'\ndivider = 'reciprocal'"),
    ("schlick, digit", "method = 'schlick'\ndivider = 'digit'"),
    ("schlick, reciprocal", "method = 'schlick'\ndivider = 'reciprocal'"),
    ("lyon-2", "method = 'lyon-2'"),
    ("lyon-4", "method = 'lyon-4'"),
    ("lyon-8", "method = 'lyon-8'"),
    ("power-2, linear", "method = 'power-2'\ninside = 'linear'"),
    ("power-4, linear", "method = 'power-4'\ninside = 'linear'"),
    ("power-8, linear", "method = 'power-8'\ninside = 'linear'"),
    ("power-2, quadratic", "method = 'power-2'"),
    ("power-4, quadratic", "method = 'power-4'"),
    ("power-8, quadratic", "method = 'power-8'"),
    ("segmented-2", "method = 'segmented-2'"),
    ("segmented-4", "method = 'segmented-4'"),
    ("segmented-8", "method = 'segmented-8'"),
    ("log-exp", "method = 'log-exp'"),
    ("quadratic, in_n with 3 fraction bits", "method = 'quadratic'\nshininess_fraction = 3"),
    ("cubic, in_n with 3 fraction bits", "method = 'cubic'\nshininess_fraction = 3"),
    ("power-4, in_n with 3 fraction bits", "method = 'power-4'\nshininess_fraction = 3"),
];

/// The shininesses at which errors are measured.
const MEASURED: [u32; 3] = [10, 100, 1000];
/// Output fraction bits of the synthesised cores.
const SYNTHESISED: [u32; 3] = [8, 12, 16];
/// The cells that are counted.
const CELLS: [&str; 5] = ["LUT4", "CCU2C", "TRELLIS_FF", "MULT18X18D", "DP16KD"];

fn design(method: &str, output_fraction: u32) -> Result<Design, brdfgen::error::Error> {
    let text = format!("{method}\nshininess = '1..=1000'\ninput_fraction = 16\noutput_fraction = {output_fraction}");
    Design::new(SpecFields::parse(&text, "method")?.resolve()?)
}

/// What is measured over every cosine in [0, 1] for one shininess.
struct Errors {
    max_abs: f64,
    max_rel_epicentre: f64,
    rms: f64,
    breaks: usize,
    negative: usize,
    seam: f64,
    jump: f64,
}

impl Errors {
    fn of(design: &Design, n: u32) -> Self {
        let (set, format) = (&design.spec.shininess, design.output_format());
        let index = n << set.frac_bits();
        let row = set.row_of_index(index);
        let codes = 1i64 << design.spec.input_fraction;
        let mut outputs = vec![0u32; codes as usize + 1];
        design.evaluator().evaluate(index, 0, 1, &mut outputs);
        let lobe = &design.lobes()[row];
        let hardware: Vec<f64> = outputs.iter().map(|&code| format.value(code.into())).collect();
        let method: Vec<f64> = (0..=codes).map(|code| lobe.at(design.versine(code))).collect();
        let exact: Vec<f64> = (0..=codes).map(|code| design.exact(row, code)).collect();
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
            breaks: hardware.windows(2).filter(|pair| pair[1] < pair[0]).count(),
            negative: hardware.iter().filter(|&&value| value < 0.0).count(),
            seam: beyond(&method),
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
        let multipliers: Vec<String> = design.graph().multipliers().iter().map(|(a, b)| format!("{a}x{b}")).collect();
        Self {
            rom_bits: design.tables().iter().map(brdfgen::rom::Table::bits).sum(),
            multipliers: if multipliers.is_empty() { "none".to_owned() } else { multipliers.join(" ") },
            latency: design.schedule.latency,
            errors: MEASURED.iter().map(|&n| Errors::of(design, n)).collect(),
        }
    }
}

/// Yosys' version, or `None` if it is not there.
fn yosys_version() -> Option<String> {
    let output = Command::new("yosys").arg("-V").output().ok().filter(|output| output.status.success())?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    Some(text.split_ascii_whitespace().take(2).collect::<Vec<_>>().join(" "))
}

/// The cells that `yosys synth_ecp5` makes of a core's Verilog, in the order of [`CELLS`].
fn synthesised(design: &Design) -> Result<Vec<u32>, String> {
    let name = design.spec.name.clone();
    let texts = Texts {
        name: name.clone(),
        header: Vec::new(),
        ports: design.ports(),
        rom_files: Vec::new(),
        writes: Vec::new(),
    };
    let scratch = tempfile::tempdir().map_err(|error| error.to_string())?;
    let text = hdl::backend(Language::Verilog).emit(&design.layout(), &texts).map_err(|error| error.to_string())?;
    package::write_file(&scratch.path().join("core.v"), text.as_bytes()).map_err(|error| error.to_string())?;
    let script = format!("read_verilog core.v; synth_ecp5 -top {name}; stat");
    let output = Command::new("yosys").current_dir(scratch.path()).args(["-p", &script]).output();
    let output = output.map_err(|error| error.to_string())?;
    if !output.status.success() {
        return Err(format!("yosys fails on {name}: {}", String::from_utf8_lossy(&output.stderr)));
    }
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let report = text.rsplit("Printing statistics").next().unwrap_or_default();
    let count = |cell: &&str| {
        let line = report.lines().find(|line| line.split_ascii_whitespace().any(|word| word == *cell));
        line.and_then(|line| line.split_ascii_whitespace().find_map(|word| word.parse().ok())).unwrap_or(0)
    };
    Ok(CELLS.iter().map(count).collect())
}

const ABOUT: &str = "\
# The methods, measured

Written by `cargo run --release --example methods -- --yosys`; the same figures are in methods.csv. All cores serve the integers n = 1 to 1000
(the last ones also eighths between them) and have F = G = 16 fraction bits, except where another G is given.

The errors are those of the bit-exact evaluator, which the tests hold equal to the reference model, at n = 10, 100 and 1000, over every code of
the cosine in [0, 1], 65537 of them, against x^n:

- *max abs*: the largest |y - x^n|; *rel*: the largest |y - x^n| / x^n where x^n >= 1/2; *RMS*: the root of the mean of (y - x^n)^2.
- *falls*: the pairs of adjacent codes at which the output falls as the cosine rises. *negative*: the codes with a result below 0;
  the output's format has none.
- *seam*: over all pairs of adjacent codes, and so also at the cusp, at the cut and at the bounds of segments, the most by which the core's step
  |y(i+1) - y(i)| exceeds that of the real-valued method there, in ulps of the output: what the hardware adds to a seam. Steps of
  one ulp where the method hardly moves make it up to 1, rounding up to 2.
- *jump*: the same against x^n in place of the method: the largest discontinuity that the method has, as one sees it. A held tail has
  it between the codes 0 and 1, as the result is 0 at x = 0.

Multipliers are given by the widths of their operands, ROM bits as the depth of each memory times its word.
";

fn sig(value: f64) -> String {
    format!("{value:.3e}")
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let with_yosys = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => false,
        ["--yosys"] => true,
        _ => return Err("usage: methods [--yosys]".into()),
    };
    let mut refused = Vec::new();
    let mut entries = Vec::new();
    for (name, method) in METHODS {
        match design(method, 16) {
            Ok(design) => entries.push((name, method, Entry::of(&design))),
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
    for (name, _, entry) in &entries {
        writeln!(text, "| {name} | {} | {} | {} |", entry.rom_bits, entry.multipliers, entry.latency)?;
        write!(csv, "\"{name}\",{},{},{}", entry.rom_bits, entry.multipliers, entry.latency)?;
        for e in &entry.errors {
            let (abs, rel, rms) = (sig(e.max_abs), sig(e.max_rel_epicentre), sig(e.rms));
            write!(csv, ",{abs},{rel},{rms},{},{},{:.2},{:.2}", e.breaks, e.negative, e.seam, e.jump)?;
        }
        csv += "\n";
    }
    for (place, n) in MEASURED.iter().enumerate() {
        write!(text, "\n## n = {n}\n\n")?;
        text += "| method | max abs | rel | RMS | falls | negative | seam | jump |\n";
        text += "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";
        for (name, _, entry) in &entries {
            let e = &entry.errors[place];
            let (abs, rel, rms) = (sig(e.max_abs), sig(e.max_rel_epicentre), sig(e.rms));
            let (breaks, negative) = (e.breaks, e.negative);
            writeln!(
                text,
                "| {name} | {abs} | {rel} | {rms} | {breaks} | {negative} | {:.2} | {:.1} |",
                e.seam, e.jump
            )?;
        }
    }

    if with_yosys {
        if let Some(version) = yosys_version() {
            text += &cells(&entries, &version)?;
        } else {
            eprintln!("yosys is not installed (apt-get install yosys): the cells are left out");
        }
    }
    package::write_file(Path::new("docs/methods.md"), text.as_bytes())?;
    package::write_file(Path::new("docs/methods.csv"), csv.as_bytes())?;
    Ok(())
}

/// The chapter on cells; two runs of Yosys at a time.
fn cells(entries: &[(&str, &str, Entry)], version: &str) -> Result<String, Box<dyn Error>> {
    let jobs: Vec<(&str, &str, u32)> =
        entries.iter().flat_map(|&(name, method, _)| SYNTHESISED.map(|g| (name, method, g))).collect();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build()?;
    let counted: Vec<Result<Vec<u32>, String>> = pool.install(|| {
        let one =
            |&(_, method, g): &(&str, &str, u32)| synthesised(&design(method, g).map_err(|error| error.to_string())?);
        jobs.par_iter().map(one).collect()
    });
    let mut text = format!("\n## Cells on ECP5\n\n`synth_ecp5` of {version}, before placement, F = 16.\n\n");
    writeln!(text, "| method | G | {} |", CELLS.join(" | "))?;
    writeln!(text, "| --- | ---: |{}", " ---: |".repeat(CELLS.len()))?;
    for ((name, _, g), counts) in jobs.iter().zip(counted) {
        let counts: Vec<String> = counts?.iter().map(u32::to_string).collect();
        writeln!(text, "| {name} | {g} | {} |", counts.join(" | "))?;
    }
    Ok(text)
}
