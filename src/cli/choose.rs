//! `brdfgen choose`, and the flags that `brdfgen generate --max-error` has in common with it.

use std::path::PathBuf;

use clap::Args;

use super::{Verdict, say, say_json};
use crate::explore::choose::{Candidate, Choice, Constraints, NearMiss};
use crate::explore::{Cost, MaxError, Objective, Results};
use crate::platform::error::Error;
use crate::platform::paths::Paths;
use crate::spec::{BlockKind, Coefficients, MethodName, Operand, Shininess, SpecFields};
use crate::target::Family;

#[derive(Args)]
pub(super) struct Arguments {
    /// The largest |result - x^n| that is allowed: 0.01, 1% or 2^-7
    #[arg(long, value_name = "ERROR")]
    max_error: MaxError,

    /// What is to be least; of equals the others, in the order LUTs, DSPs, block RAMs, clocks (for dsp and bram these
    /// two come first)
    #[arg(long, visible_alias = "goal", value_enum, value_name = "COST", default_value = "lut")]
    objective: Objective,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,

    #[command(flatten)]
    constraints: ConstraintFlags,

    #[command(flatten)]
    keys: Keys,
}

/// Keys of the spec that the core must have.
#[derive(Args, Clone)]
#[command(next_help_heading = "Core")]
pub(super) struct Keys {
    /// Shininesses served: a range of integers, or a list of real numbers; a core for a range serves the ranges in it
    /// [default: 1..=1000]
    #[arg(long)]
    shininess: Option<Shininess>,

    /// Only this method
    #[arg(long, value_enum)]
    method: Option<MethodName>,

    /// Only these coefficients
    #[arg(long, value_enum)]
    coefficients: Option<Coefficients>,

    /// Only with so many fraction bits of the input
    #[arg(long, value_name = "F")]
    input_fraction: Option<u32>,

    /// Only with so many fraction bits of the output
    #[arg(long, value_name = "G")]
    output_fraction: Option<u32>,

    /// Only with this operand
    #[arg(long, value_enum)]
    operand: Option<Operand>,
}

/// What is asked of a core beside its error and what is to be least.
#[derive(Args)]
#[command(next_help_heading = "Choice")]
pub(super) struct ConstraintFlags {
    /// The family of FPGAs that the core is for [default: ecp5]
    #[arg(long, value_enum)]
    family: Option<Family>,

    /// The least median frequency in MHz
    #[arg(long, value_name = "MHZ")]
    min_mhz: Option<f64>,

    /// The most LUTs, carry chains counted
    #[arg(long, value_name = "COUNT")]
    max_lut: Option<u32>,

    /// The most DSP blocks
    #[arg(long, value_name = "COUNT")]
    max_dsp: Option<u32>,

    /// The most block RAMs
    #[arg(long, value_name = "COUNT")]
    max_bram: Option<u32>,

    /// The most clocks from input to output
    #[arg(long, value_name = "CLOCKS")]
    max_latency: Option<u32>,

    /// Choose among the points of this file, a .db, .csv or .json of explore [default: those that come with the
    /// program]
    #[arg(long, value_name = "FILE")]
    results: Option<PathBuf>,

    /// Consider baselines too; those of a named --method are in any case
    #[arg(long)]
    baselines: bool,
}

impl Keys {
    /// As keys of a spec.
    pub(super) fn fields(&self) -> SpecFields {
        let Self { shininess, method, coefficients, input_fraction, output_fraction, operand } = self.clone();
        let none = SpecFields::default();
        SpecFields { shininess, method, coefficients, input_fraction, output_fraction, operand, ..none }
    }
}

impl ConstraintFlags {
    /// Whether none of them is given.
    pub(super) fn is_empty(&self) -> bool {
        self.results.is_none() && !self.constrains()
    }

    /// Whether any of them is given that says what is asked of the core, and not only of which results.
    pub(super) fn constrains(&self) -> bool {
        let Self { family, min_mhz, max_lut, max_dsp, max_bram, max_latency, results: _, baselines } = self;
        family.is_some()
            || min_mhz.is_some()
            || [max_lut, max_dsp, max_bram, max_latency].iter().any(|limit| limit.is_some())
            || *baselines
    }

    /// What is asked for, an error of at most this among it, of a core with these keys.
    pub(super) fn with_error(
        &self,
        max_error: MaxError,
        objective: Objective,
        keys: SpecFields,
    ) -> Result<Constraints, Error> {
        if keys.block == Some(BlockKind::Image) {
            let what = "only a core with a lobe is chosen by its error, and an image-based block is asked for";
            return Err(Error::input(what, "give --max-picture-error or --min-psnr in place of --max-error"));
        }
        if let Some(mhz) = self.min_mhz.filter(|mhz| !(mhz.is_finite() && *mhz > 0.0)) {
            return Err(Error::input(format!("a frequency of {mhz} MHz is not allowed"), "more than 0 is"));
        }
        let shininess = match (&keys.shininess, &keys.material) {
            (Some(set), _) => set.clone(),
            (None, Some(materials)) => Shininess::Materials(materials.clone()),
            (None, None) => Shininess::Range(1, 1000),
        };
        let limits = Objective::ALL.into_iter().zip([self.max_lut, self.max_dsp, self.max_bram, self.max_latency]);
        Ok(Constraints {
            max_error,
            family: self.family.unwrap_or_default(),
            min_mhz: self.min_mhz,
            objective,
            limits: limits.filter_map(|(objective, most)| Some((objective, most?))).collect(),
            shininess,
            keys,
            baselines: self.baselines,
        })
    }

    /// The paths of a command that chooses.
    pub(super) fn paths(&self) -> Paths {
        self.results.iter().fold(Paths::new(), |paths, path| paths.reads("--results", path))
    }

    /// The points that are chosen among.
    pub(super) fn results(&self) -> Result<Results, Error> {
        self.results.as_deref().map_or_else(Results::built_in, Results::read)
    }
}

pub(super) fn run(arguments: &Arguments) -> Result<Verdict, Error> {
    let constraints =
        arguments.constraints.with_error(arguments.max_error, arguments.objective, arguments.keys.fields())?;
    let choice = constraints.choose(&arguments.constraints.results()?)?;
    if arguments.json {
        say_json(&choice);
    } else {
        describe(&constraints, &choice).iter().for_each(say);
        if let Some(chosen) = &choice.chosen {
            // In full, however long: there is no core.toml yet.
            let flags = constraints.spec_of(chosen)?.resolve()?.flags().join(" ");
            say(format!("  made by: brdfgen generate {flags} --out DIR"));
        }
    }
    Ok(Verdict::of(choice.chosen.is_some()))
}

/// An error as a percentage and as a power of two.
pub(super) fn error_text(value: f64) -> String {
    if value == 0.0 {
        return "nothing".to_owned();
    }
    // Three significant digits of what is very small.
    let percent = match 100.0 * value {
        percent if percent < 0.001 => format!("{percent:.2e}"),
        percent => format!("{percent:.3}"),
    };
    format!("{percent} % (2^{:.2})", libm::log2(value))
}

/// All that a core must meet, in words.
fn constraints_text(constraints: &Constraints) -> String {
    let limits = constraints.limits.iter().map(|(objective, most)| format!("at most {}", objective.counted(*most)));
    let mhz = constraints.min_mhz.map(|mhz| format!("at least {mhz} MHz"));
    let error = format!("an error of at most {}", error_text(constraints.max_error.0));
    std::iter::once(error).chain(mhz).chain(limits).collect::<Vec<_>>().join(", ")
}

pub(super) fn cost_text(cost: &Cost) -> String {
    let mhz = cost.mhz_text(1);
    let Cost { lut, ff, dsp, bram, latency, .. } = cost;
    let source = if cost.estimated { ", estimated" } else { "" };
    format!("{lut} LUT, {ff} FF, {dsp} DSP, {bram} block RAM, {latency} clocks, {mhz}{source}")
}

fn core_text(Candidate { point, cost }: &Candidate) -> String {
    let checked = if point.checked == "exhaustive" { String::new() } else { format!(", over a {}", point.checked) };
    format!("{}: error {}{checked}; {}", point.name, error_text(point.max_abs), cost_text(cost))
}

/// The choice for people: a line a thing.
pub(super) fn describe(constraints: &Constraints, choice: &Choice) -> Vec<String> {
    let Choice { chosen, misses, considered, meeting, tools } = choice;
    let mut lines = Vec::new();
    match chosen {
        Some(chosen) => lines.push(core_text(chosen)),
        None => lines.push(format!("no core meets the constraints: {}", constraints_text(constraints))),
    }
    lines.push(format!("  {meeting} of the {considered} cores considered meet the constraints"));
    if !misses.is_empty() {
        lines.push("nearest misses:".to_owned());
        let miss = |miss: &NearMiss<Candidate>| format!("  {}: {}", core_text(&miss.core), miss.why.join(", "));
        lines.extend(misses.iter().map(miss));
    }
    let nextpnr = tools.nextpnr.as_ref().map(|version| format!(" and {version}")).unwrap_or_default();
    lines.push(format!("figures by {}{nextpnr}; other versions give others", tools.yosys));
    lines
}
