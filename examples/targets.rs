//! Writes `docs/targets.md`: at each error from 2^-3 to 2^-14 the cheapest core of the project's own methods beside the
//! cheapest baseline, from the measured points that come with the program:
//! `cargo run --release --example targets -- docs`.

use std::error::Error;
use std::fmt::Write;
use std::path::Path;

use brdfgen::explore::{Cost, Point, Results};
use brdfgen::target::Family;

/// What an LFE5U-85F has: LUTs, DSP blocks, block RAMs (Lattice FPGA-DS-02012, ECP5 family data sheet).
const DEVICE: [f64; 3] = [83_640.0, 156.0, 208.0];
/// The clock that is asked for, in MHz.
const CLOCK: f64 = 150.0;
const GENERAL: &str = "1..=1000";

/// The part of the device that a core takes: what it takes of each kind of block, added up.
fn share(cost: &Cost) -> f64 {
    let taken = [cost.lut, cost.dsp, cost.bram];
    taken.iter().zip(DEVICE).map(|(&taken, has)| f64::from(taken) / has).sum()
}

/// The placed points of a set with 16 bits in and out.
fn candidates<'r>(results: &'r Results, set: &str) -> Vec<(&'r Point, Cost)> {
    let of_set = |point: &&Point| {
        point.family == Family::Ecp5
            && point.shininess == set
            && point.input_fraction == 16
            && point.output_fraction == 16
    };
    let points = results.points().iter().filter(of_set);
    let costed = points.filter_map(|point| Some((point, point.cost()?)));
    costed.filter(|(_, cost)| cost.mhz.is_some()).collect()
}

fn cheapest<'a, 'r>(
    points: &'a [(&'r Point, Cost)],
    error: f64,
    baseline: bool,
    fits: impl Fn(&Point, &Cost) -> bool,
) -> Option<&'a (&'r Point, Cost)> {
    let meets =
        |(point, cost): &&(&Point, Cost)| point.max_abs <= error && point.baseline == baseline && fits(point, cost);
    points.iter().filter(meets).min_by(|a, b| share(&a.1).total_cmp(&share(&b.1)))
}

fn at_clock(cost: &Cost) -> bool {
    cost.mhz.is_some_and(|mhz| mhz >= CLOCK)
}

fn cells(found: Option<&(&Point, Cost)>) -> String {
    found.map_or_else(
        || "none | | | | | | |".to_owned(),
        |(point, cost)| {
            let mhz = cost.mhz.unwrap_or_default();
            let [lut4, carry] = point.synthesis.as_ref().map_or([0; 2], |s| [s.resources.lut, s.resources.carry]);
            format!(
                "{} | {:.2e} | {} ({lut4} + 2 x {carry}) | {} | {} | {:.0} | {} | {:.2} |",
                point.name,
                point.max_abs,
                cost.lut,
                cost.dsp,
                cost.bram,
                mhz,
                cost.latency,
                100.0 * share(cost)
            )
        },
    )
}

const HEAD: &str = "| error | core | its error | LUT (LUT4 + 2 x carry cell) | DSP | block RAM | MHz | clocks | % of \
 the device |\n\
                    | --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";

fn text(results: &Results) -> Result<String, Box<dyn Error>> {
    let general = candidates(results, GENERAL);
    let materials = candidates(results, "8 values");
    let tools = general.first().and_then(|(point, _)| point.tools()).ok_or("no measured core")?;
    let mut text = format!(
        "# What an error costs\n\n\
         Made from `docs/trade.csv` by `cargo run --release --example targets -- docs`: ECP5-85k, speed grade 6, n = \
         {GENERAL} at run time, 16\n\
         fraction bits in and out, one result a clock, at least {CLOCK} MHz as the median over three seeds. The error \
         is the largest\n\
         |core - x^n| over every n and every cosine code. The cheapest core is the one that takes the least of an \
         LFE5U-85F: its parts of\n\
         the LUTs, the DSP blocks and the block RAMs added up. {}; {}.\n\n\
         ## The cheapest core and the cheapest baseline\n\n{HEAD}",
        tools.yosys,
        tools.nextpnr.as_deref().unwrap_or("not placed"),
    );
    for bits in 3..=14 {
        let error = 0.5f64.powi(bits);
        for (what, baseline) in [("", false), ("baseline: ", true)] {
            let found = cheapest(&general, error, baseline, |_, cost| baseline || at_clock(cost));
            writeln!(
                text,
                "| {} | {what}{}",
                if baseline { String::new() } else { format!("2^-{bits}") },
                cells(found)
            )?;
        }
    }
    writeln!(
        text,
        "\n## Constraints\n\n| constraints | met by | its error | LUT (LUT4 + 2 x carry cell) | DSP | block RAM | \
         MHz | clocks | % of the device |"
    )?;
    writeln!(text, "| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |")?;
    let most = u32::MAX;
    for (bits, dsp, bram, lut) in [(5, 2, 0, 120), (7, 2, 0, 250), (9, 2, 1, most), (11, 2, 2, most), (14, 3, 2, 250)] {
        let fits = |point: &Point, cost: &Cost| {
            let lut4 = point.synthesis.as_ref().map_or(most, |synthesis| synthesis.resources.lut);
            cost.dsp <= dsp && cost.bram <= bram && lut4 <= lut && at_clock(cost)
        };
        let luts = if lut == most { String::new() } else { format!(", {lut} LUT4") };
        let found = cheapest(&general, 0.5f64.powi(bits), false, fits);
        writeln!(text, "| 2^-{bits}: {dsp} DSP, {bram} block RAM{luts} | {}", cells(found))?;
    }
    write!(
        text,
        "\n## A scene of eight materials\n\nn = 5, 10, 20, 40, 80, 160, 320, 640, against the general core of the same \
         error.\n\n{HEAD}"
    )?;
    for bits in [3, 5, 7, 9, 11, 14] {
        let error = 0.5f64.powi(bits);
        writeln!(
            text,
            "| 2^-{bits} | {}",
            cells(cheapest(&materials, error, false, |_, cost| cost.bram == 0 && at_clock(cost)))
        )?;
        writeln!(text, "| | general: {}", cells(cheapest(&general, error, false, |_, cost| at_clock(cost))))?;
    }
    Ok(text)
}

fn main() -> Result<(), Box<dyn Error>> {
    let directory = std::env::args().nth(1).ok_or("give a directory")?;
    std::fs::write(Path::new(&directory).join("targets.md"), text(&Results::built_in()?)?)?;
    Ok(())
}
