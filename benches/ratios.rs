//! What software costs, as ratios: every contender of a group runs in every round, one after the other, and the ratio
//! is taken within the round, so that whatever else the machine does meets all alike. Medians over the rounds are
//! reported.
//!
//! `cargo bench --bench ratios` prints the table; `cargo bench --bench ratios -- --out docs` also writes speed.csv and
//! speed.md there. Run as a test (without `--bench`), it goes through everything once and measures nothing.

use std::error::Error;
use std::fmt::Write;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};

use brdfgen::core::{Account, Design};
use brdfgen::datapath::simulate::{Inputs, Simulation};
use brdfgen::emit::package;
use brdfgen::fit::{self, Constraint, Objective};
use brdfgen::lobe::Lobe;
use brdfgen::method::cubic::Cubic;
use brdfgen::method::cubic_min_zero::MinZero;
use brdfgen::method::cubic_rational::CubicRational;
use brdfgen::method::log_exp::LogExp;
use brdfgen::method::lyon::Lyon;
use brdfgen::method::polynomial::Polynomial;
use brdfgen::method::quadratic::Quadratic;
use brdfgen::method::schlick::Schlick;
use brdfgen::method::segmented::Segmented;
use brdfgen::method::{Use, variants};
use brdfgen::papers::{CosK, Taylor, TaylorSeries};
use brdfgen::platform::tool;
use brdfgen::spec::{Inside, Language, SpecFields};
use brdfgen::verify::cosim::{self, Job, Sim};
use brdfgen::verify::golden::Golden;

type Result<T> = std::result::Result<T, Box<dyn Error>>;

/// Cosines of an array: those from 15/16 up, the highlight, where a power has no short cut.
const COSINES: usize = 4096;
/// The code of the least of them, of 16 fraction bits.
const FIRST: i64 = (1 << 16) - COSINES as i64 + 1;
/// The level at which the papers' cubics meet the power.
const LEVEL: f64 = 0.5;

/// The shininesses: 16, spread over 1..=1000.
fn shininesses() -> impl Iterator<Item = u32> {
    (0..16).map(|step| 1 + step * 66)
}

/// How long to measure.
#[derive(Clone, Copy)]
struct Effort {
    rounds: usize,
    /// The least time of a contender in a round.
    slice: Duration,
}

/// One of a group: a call computes some results and says how many.
struct Contender<'a> {
    name: String,
    run: Box<dyn FnMut() -> u64 + 'a>,
}

fn contender<'a>(name: impl Into<String>, run: impl FnMut() -> u64 + 'a) -> Contender<'a> {
    Contender { name: name.into(), run: Box::new(run) }
}

/// A line of the table.
struct Row {
    group: &'static str,
    name: String,
    /// Nanoseconds for one result: the least, the median and the greatest of the rounds.
    ns: [f64; 3],
    /// The median of the rounds' ratios of the reference's time to this one's.
    times_as_fast: f64,
    reference: String,
    /// The program that it ran, with its version.
    tool: String,
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    let middle = values.len() / 2;
    if values.len() % 2 == 1 { values[middle] } else { 0.5 * (values[middle - 1] + values[middle]) }
}

/// Nanoseconds for one result of a contender in each round: `times[round][contender]`.
fn measured(effort: Effort, contenders: &mut [Contender]) -> Vec<Vec<f64>> {
    // The first call warms caches and tells how many calls fill a slice.
    let calls: Vec<u32> = contenders
        .iter_mut()
        .map(|contender| {
            let start = Instant::now();
            (contender.run)();
            let once = start.elapsed().max(Duration::from_nanos(100));
            effort.slice.div_duration_f64(once).ceil().clamp(1.0, 1e6) as u32
        })
        .collect();
    let round = |_| {
        let time = |(contender, &calls): (&mut Contender, &u32)| {
            let start = Instant::now();
            let results: u64 = (0..calls).map(|_| (contender.run)()).sum();
            start.elapsed().as_secs_f64() * 1e9 / results as f64
        };
        contenders.iter_mut().zip(&calls).map(time).collect()
    };
    (0..effort.rounds).map(round).collect()
}

/// A group's lines, of the times of each round; the first contender is the reference.
fn rows(group: &'static str, names: &[(String, String)], times: &[Vec<f64>]) -> Vec<Row> {
    let row = |(place, (name, tool)): (usize, &(String, String))| {
        let mut own: Vec<f64> = times.iter().map(|round| round[place]).collect();
        own.sort_by(f64::total_cmp);
        Row {
            group,
            name: name.clone(),
            ns: [own[0], median(own.clone()), own[own.len() - 1]],
            times_as_fast: median(times.iter().map(|round| round[0] / round[place]).collect()),
            reference: names[0].0.clone(),
            tool: tool.clone(),
        }
    };
    names.iter().enumerate().map(row).collect()
}

fn compared(group: &'static str, effort: Effort, mut contenders: Vec<Contender>) -> Vec<Row> {
    eprintln!("{group}");
    let times = measured(effort, &mut contenders);
    let names: Vec<_> = contenders.iter().map(|contender| (contender.name.clone(), String::new())).collect();
    rows(group, &names, &times)
}

/// All cosines for every shininess through a function of both, which is compiled for its type.
fn powers<'a>(name: &str, xs: &'a [f64], f: impl Fn(f64, f64) -> f64 + 'a) -> Contender<'a> {
    let mut out = vec![0.0; xs.len()];
    contender(name, move || {
        for n in shininesses() {
            let n = f64::from(black_box(n));
            for (out, &x) in out.iter_mut().zip(xs) {
                *out = f(x, n);
            }
            black_box(&mut out);
        }
        16 * xs.len() as u64
    })
}

/// The same through a method's lobes, whose coefficients are made beforehand.
fn lobes<'a, L: Lobe + 'a>(
    name: &str,
    xs: &'a [f64],
    lobe: impl Fn(f64) -> std::result::Result<L, brdfgen::platform::error::Error>,
) -> Result<Contender<'a>> {
    let lobes = shininesses().map(|n| lobe(n.into())).collect::<std::result::Result<Vec<L>, _>>()?;
    let mut out = vec![0.0; xs.len()];
    Ok(contender(name, move || {
        for lobe in &lobes {
            let lobe = black_box(lobe);
            for (out, &x) in out.iter_mut().zip(xs) {
                *out = lobe.at(1.0 - x);
            }
            black_box(&mut out);
        }
        16 * xs.len() as u64
    }))
}

/// The real-valued lobe of a `power` method.
fn fitted_power(n: f64, k: u32) -> std::result::Result<Polynomial, brdfgen::platform::error::Error> {
    let fit::Power { big_a, a } =
        brdfgen::method::power::fit(n, k, Inside::Quadratic, &Objective::MaxAbs)?.coefficients;
    let end = if a > 0.0 { (big_a / (2.0 * a)).min(1.0) } else { 1.0 };
    Ok(Polynomial { cosine: false, power: k, c: 1.0, big_a, a, end, past: 0.0 })
}

/// The real-valued lobe of a `segmented` method.
fn fitted_segments(n: f64, segments: u32) -> std::result::Result<Segmented, brdfgen::platform::error::Error> {
    let ends = fit::segment_bounds(n, segments, Constraint::Peak, &Objective::MaxAbs)?.coefficients;
    let mut pieces = Vec::new();
    let mut low = 0.0;
    for end in ends {
        let constraint = Constraint::Peak.of_segment(low, false);
        let fit::Segment { c, big_a, a } = fit::fit_segment(n, low, end, constraint, &Objective::MaxAbs)?.coefficients;
        pieces.push(Polynomial { cosine: true, power: 1, c, big_a, a, end, past: 0.0 });
        low = end;
    }
    Ok(Segmented { pieces })
}

/// The f64 forms of all methods against `powf`.
fn real_valued(effort: Effort) -> Result<Vec<Row>> {
    let xs: Vec<f64> = (0..COSINES).map(|i| (FIRST + i as i64) as f64 / 65536.0).collect();
    let xs = &xs[..];
    let mut contenders = vec![
        powers("std powf", xs, f64::powf),
        powers("libm pow", xs, libm::pow),
        powers("std powi (repeated squaring)", xs, |x, n| x.powi(n as i32)),
        lobes("log-exp (libm exp of n times log1p)", xs, LogExp::new)?,
        lobes("quadratic", xs, Quadratic::new)?,
        lobes("cubic", xs, |n| Cubic::new(n, LEVEL))?,
        lobes("cubic-rational", xs, |n| CubicRational::new(n, LEVEL))?,
        lobes("cubic-three-point", xs, |n| Cubic::three_point(n, Cubic::THREE_POINT_Q, Cubic::THREE_POINT_G))?,
        lobes("cubic-min-zero", xs, |n| MinZero::new(n, LEVEL))?,
        lobes("schlick", xs, Schlick::new)?,
        lobes("taylor-3", xs, |n| Taylor::new(n, TaylorSeries::Versine3))?,
    ];
    for k in [2, 4, 8] {
        contenders.push(lobes(&format!("lyon-{k}"), xs, |n| Lyon::new(n, k))?);
    }
    for k in [2, 4, 8] {
        contenders.push(lobes(&format!("cos-{k}"), xs, |n| CosK::new(n, k))?);
    }
    for k in [2, 4, 8] {
        contenders.push(lobes(&format!("power-{k}"), xs, |n| fitted_power(n, k))?);
    }
    for segments in [2, 4, 8] {
        contenders.push(lobes(&format!("segmented-{segments}"), xs, |n| fitted_segments(n, segments))?);
    }
    Ok(compared("f64, one value of the lobe", effort, contenders))
}

fn design(text: &str) -> Result<Design> {
    Ok(Design::new(SpecFields::parse(text, "bench")?.resolve()?)?)
}

/// The methods whose cores are timed, and their specs.
fn cores() -> impl Iterator<Item = (&'static str, String)> {
    variants(Use::Bench).map(|(about, variant)| (about.name, variant.spec(about) + "\nshininess = '1..=1000'"))
}

/// The bit-exact arithmetic, in its forms, against `powf`.
fn bit_exact(effort: Effort) -> Result<Vec<Row>> {
    let xs: Vec<f64> = (0..COSINES).map(|i| (FIRST + i as i64) as f64 / 65536.0).collect();
    let designs = cores().map(|(_, text)| design(&text)).collect::<Result<Vec<Design>>>()?;
    let mut contenders = vec![powers("std powf (f64)", &xs, f64::powf)];
    for design in &designs {
        let name = design.spec.name.replace('_', "-");
        let (model, evaluator) = (design.lobe().model(), design.evaluator());
        let set = &design.lobe().interface.shininess;
        let mut out = vec![0u32; COSINES];
        contenders.push(contender(format!("{name}: evaluator, vectorised"), move || {
            for n in shininesses() {
                evaluator.evaluate(black_box(set.index_of_row(n as usize - 1)), FIRST, 1, &mut out);
                black_box(&mut out);
            }
            16 * COSINES as u64
        }));
        contenders.push(contender(format!("{name}: bit-exact model"), move || {
            for n in shininesses() {
                let index = black_box(set.index_of_row(n as usize - 1));
                for x in (0..COSINES as i64).step_by(64) {
                    black_box(model.evaluate(index, FIRST + x));
                }
            }
            16 * (COSINES as u64).div_ceil(64)
        }));
        contenders.push(contender(format!("{name}: graph, scalar"), move || {
            for n in shininesses() {
                let index = black_box(set.index_of_row(n as usize - 1));
                for x in (0..COSINES as i64).step_by(64) {
                    black_box(design.graph().values(design.tables(), &[index.into(), (FIRST + x).into()]));
                }
            }
            16 * (COSINES as u64).div_ceil(64)
        }));
        let mut simulation = Simulation::new(design.graph(), &design.schedule, design.tables());
        contenders.push(contender(format!("{name}: pipeline, clock by clock"), move || {
            for n in shininesses() {
                let index = set.index_of_row(n as usize - 1);
                for x in (0..COSINES as i64).step_by(64) {
                    let codes = vec![index.into(), (FIRST + x).into()];
                    black_box(simulation.clock(&Inputs { rst: false, ce: true, in_valid: true, codes }));
                }
            }
            16 * (COSINES as u64).div_ceil(64)
        }));
        #[cfg(feature = "kernel")]
        if let Some(mut kernel) = brdfgen::verify::kernel::of_design(design) {
            contenders.push(contender(format!("{name}: rust-hdl kernel, clock by clock"), move || {
                for n in shininesses() {
                    let index = u64::from(set.index_of_row(n as usize - 1));
                    for x in (0..COSINES as i64).step_by(64) {
                        black_box(kernel.clock(false, true, true, index, (FIRST + x) as u64));
                    }
                }
                16 * (COSINES as u64).div_ceil(64)
            }));
        }
    }
    Ok(compared("bit-exact, one result of the 16-bit core", effort, contenders))
}

/// Choosing widths, coefficients and schedule of a core, and its files.
fn generation(effort: Effort) -> Result<Vec<Row>> {
    let mut contenders = Vec::new();
    for (method, text) in cores() {
        design(&text)?;
        contenders.push(contender(method, move || {
            black_box(design(black_box(&text)).expect("the same as before"));
            1
        }));
    }
    Ok(compared("generation, the design of one core for n = 1..=1000", effort, contenders))
}

/// How many times over the long run has the golden vectors of the short one.
const COPIES: usize = 16;

/// Vectors through each simulator that is installed: what one more costs, and what a whole run of the golden vectors
/// costs.
///
/// The first is the difference of the times of a run of the golden vectors and one of them [`COPIES`] times over, which
/// take turns. Verilator's runs are nearly all compiling, so that the difference would be noise: there it is every
/// input of a core with fewer shininesses, compiled beforehand.
fn simulators(rounds: usize) -> Result<Vec<Row>> {
    eprintln!("simulators");
    let core = design("method = 'quadratic'\nshininess = '1..=1000'")?;
    let short = Golden::of(&core);
    let mut long = short.clone();
    long.groups = (0..COPIES).flat_map(|_| short.groups.clone()).collect();
    let more = (long.vectors().len() - short.vectors().len()) as f64;
    let small = design("method = 'quadratic'\nshininess = '1..=64'")?;
    let small_golden = Golden::of(&small);
    let scratch = tempfile::tempdir()?;
    let put = |name: &str, design: &Design, golden: &Golden| -> Result<PathBuf> {
        let directory = scratch.path().join(name);
        package::write_directory(&directory, &package::files(design, &Account::of(design), golden)?)?;
        Ok(directory)
    };
    let (short_directory, long_directory) = (put("short", &core, &short)?, put("long", &core, &long)?);
    let small_directory = put("small", &small, &small_golden)?;
    let mut sims = vec![(Sim::Builtin, cosim::builtin_engine(&core).name().to_owned(), String::new())];
    for (sim, name, tools) in [
        (Sim::Icarus, "icarus", &[tool::IVERILOG, tool::VVP][..]),
        (Sim::Verilator, "verilator", &[tool::VERILATOR, tool::CXX, tool::MAKE]),
        (Sim::Ghdl, "ghdl", &[tool::GHDL]),
    ] {
        match tools.iter().map(|tool| tool.version().ok_or(tool)).collect::<std::result::Result<Vec<_>, _>>() {
            Ok(versions) => sims.push((sim, name.to_owned(), versions[0].clone())),
            Err(missing) => {
                eprintln!("not measured: {name}: {} is not installed (package {})", missing.program, missing.package);
            }
        }
    }
    let passed = |outcome: cosim::Outcome| -> Result<f64> {
        if outcome.passed() { Ok(outcome.seconds * 1e9) } else { Err(format!("does not pass: {outcome:?}").into()) }
    };
    let every_input = || -> Result<f64> {
        let outcome = cosim::exhaustive(small.lobe(), &small_directory, Language::Verilog, &|_, _| ())?;
        let inputs = outcome.vectors as f64;
        Ok(passed(outcome)? / inputs)
    };
    if sims.iter().any(|(sim, ..)| *sim == Sim::Verilator) {
        every_input()?;
    }
    let (mut vectors, mut runs) = (Vec::new(), Vec::new());
    for _ in 0..rounds {
        let (mut vector, mut run) = (Vec::new(), Vec::new());
        for (sim, ..) in &sims {
            let golden = |golden, directory| {
                cosim::golden(*sim, &Job { design: &core, golden, directory }).map_err(Box::from).and_then(passed)
            };
            let once = golden(&short, &short_directory)?;
            run.push(once);
            vector.push(match sim {
                Sim::Verilator => every_input()?,
                _ => (golden(&long, &long_directory)? - once) / more,
            });
        }
        vectors.push(vector);
        runs.push(run);
    }
    let names = |verilator: &str| -> Vec<(String, String)> {
        let name = |(sim, name, version): &(Sim, String, String)| {
            let more = if *sim == Sim::Verilator { verilator } else { "" };
            (format!("{name}{more}"), version.clone())
        };
        sims.iter().map(name).collect()
    };
    let mut table = rows("simulators, one vector", &names(", every input, compiled before"), &vectors);
    table.extend(rows("simulators, one run of the golden vectors, compiling included", &names(""), &runs));
    Ok(table)
}

/// The processor's name and how many threads it runs, the compiler, and this program's version.
fn machine() -> String {
    let cpus = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = cpus.lines().find_map(|line| line.strip_prefix("model name")?.split_once(": ").map(|(_, name)| name));
    let threads = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
    let rustc = Command::new(rustc).arg("--version").output().map(|output| output.stdout).unwrap_or_default();
    let rustc = String::from_utf8_lossy(&rustc).trim().to_owned();
    format!(
        "{}, {threads} threads; {rustc}; brdfgen {}",
        name.unwrap_or("unknown processor"),
        env!("CARGO_PKG_VERSION")
    )
}

fn quoted(text: &str) -> String {
    if text.contains([',', '"']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.to_owned() }
}

fn csv(rows: &[Row], machine: &str) -> String {
    let mut text = "group,name,ns_least,ns_median,ns_most,times_as_fast,reference,tool,machine\n".to_owned();
    for Row { group, name, ns, times_as_fast, reference, tool } in rows {
        let [least, middle, most] = ns.map(|ns| format!("{ns:.4e}"));
        let [group, name, reference, tool, machine] = [*group, name.as_str(), reference, tool, machine].map(quoted);
        let _ =
            writeln!(text, "{group},{name},{least},{middle},{most},{times_as_fast:.4e},{reference},{tool},{machine}");
    }
    text
}

/// A time in a unit that leaves it readable.
fn time(ns: f64) -> String {
    match ns {
        ..1e3 => format!("{ns:.3} ns"),
        ..1e6 => format!("{:.3} µs", ns / 1e3),
        ..1e9 => format!("{:.3} ms", ns / 1e6),
        _ => format!("{:.3} s", ns / 1e9),
    }
}

fn markdown(rows: &[Row], machine: &str) -> String {
    let mut text = format!(
        "# Software speed\n\n\
         Written by `cargo bench --bench ratios -- --out docs`; the same figures are in speed.csv. {machine}.\n\n\
         Within a group all ran in turns, round by round. A time is the median of the rounds, with the least and the \
         greatest; *times as fast* is the median of the rounds' own ratios to the group's first line. The values of \
         the f64 and bit-exact groups are those of {COSINES} cosines from 15/16 up for each of 16 shininesses spread \
         over 1 to 1000 (the slow forms take every 64th); the f64 lobes have their coefficients from beforehand, as a \
         shader has for a material.\n"
    );
    for group in rows.chunk_by(|a, b| a.group == b.group) {
        let _ = write!(
            text,
            "\n## {}\n\n| | time | least to greatest | times as fast |\n| --- | ---: | ---: | ---: |\n",
            group[0].group
        );
        for Row { name, ns: [least, middle, most], times_as_fast, tool, .. } in group {
            let name = if tool.is_empty() { name.clone() } else { format!("{name} ({tool})") };
            let (least, middle, most) = (time(*least), time(*middle), time(*most));
            // Three digits, whatever the size.
            let times_as_fast: f64 = format!("{times_as_fast:.2e}").parse().unwrap_or(*times_as_fast);
            let _ = writeln!(text, "| {name} | {middle} | {least} to {most} | {times_as_fast} |");
        }
    }
    text
}

fn main() -> Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let directory =
        arguments.iter().position(|argument| argument == "--out").and_then(|place| arguments.get(place + 1));
    // Cargo runs a benchmark from the package's directory.
    let directory = directory.map(PathBuf::from);
    if !arguments.iter().any(|argument| argument == "--bench") {
        let once = Effort { rounds: 1, slice: Duration::ZERO };
        real_valued(once)?;
        bit_exact(once)?;
        return Ok(());
    }
    // Many short rounds: what the machine does beside this then hardly moves the medians of the ratios.
    let effort = Effort { rounds: 101, slice: Duration::from_millis(1) };
    let mut table = real_valued(effort)?;
    table.extend(bit_exact(effort)?);
    table.extend(generation(Effort { rounds: 5, slice: Duration::ZERO })?);
    table.extend(simulators(5)?);
    let machine = machine();
    print!("{}", markdown(&table, &machine));
    if let Some(directory) = directory {
        let write = |name: &str, text: String| package::write_file(&Path::new(&directory).join(name), text.as_bytes());
        write("speed.csv", csv(&table, &machine))?;
        write("speed.md", markdown(&table, &machine))?;
    }
    Ok(())
}
