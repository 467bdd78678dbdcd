//! `brdfgen stability`.

use std::path::PathBuf;

use clap::Args;
use serde_json::json;

use super::source::Source;
use super::{Verdict, progress, say, say_json};
use crate::core::{BlockDesign, Design};
use crate::emit::package;
use crate::platform::error::{Error, refuse};
use crate::platform::paths::Paths;
use crate::spec::MethodName;
use crate::verify::stability::document::{self, Study};
use crate::verify::stability::inspect::{Inspection, Signal};
use crate::verify::stability::sampled::SampledInspection;
use crate::verify::stability::study::{self, Axis, Entry, Extent};
use crate::verify::stability::{EXTREMES, conditioning, quantisation};

#[derive(Args)]
pub(super) struct Arguments {
    /// Without a core: only the study's cores of this axis; may be given several times [default: all]
    #[arg(long, value_enum)]
    axis: Vec<Axis>,

    /// Without a core: only these methods of the study; may be given several times [default: all]
    #[arg(long, value_enum, value_name = "METHOD")]
    only: Vec<MethodName>,

    /// Without a core: formats of 12 bits and every fourth value, for a check in minutes
    #[arg(long)]
    quick: bool,

    /// Directory for stability.md and cores.csv of the study: a new or empty one, or one of an earlier study
    /// [default: nothing is written]
    #[arg(long, short, value_name = "DIR")]
    out: Option<PathBuf>,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,

    #[command(flatten)]
    source: Source,
}

/// Bits of the vectors in the study's front ends.
const VECTOR_BITS: [u32; 4] = [10, 12, 14, 16];

pub(super) fn run(arguments: &Arguments) -> Result<Verdict, Error> {
    if arguments.source.is_given() {
        refuse!(
            !arguments.axis.is_empty() || !arguments.only.is_empty() || arguments.quick || arguments.out.is_some(),
            "--axis, --only, --quick and --out are of the study, and a core is given",
            "leave them out to inspect the core, or leave the core out for the study"
        );
        return one(arguments);
    }
    if let Some(directory) = &arguments.out {
        package::check_target_of(document::STUDY, directory)?;
        Paths::new().writes_in("--out", directory, document::FILES).check()?;
    }
    let axes = match arguments.axis.as_slice() {
        [] => vec![Axis::Shininess, Axis::Level, Axis::Input, Axis::Output],
        axes => axes.to_vec(),
    };
    let methods = if arguments.only.is_empty() { study::methods() } else { arguments.only.clone() };
    let extent = if arguments.quick { Extent::Quick } else { Extent::Whole };
    let cases: Vec<_> = axes.into_iter().flat_map(|axis| study::cases(axis, &methods, extent)).collect();
    let bar = progress::bar("inspecting cores", cases.len() as u64);
    let mut entries = Vec::new();
    for case in &cases {
        // Each case runs its rows in parallel.
        entries.push(case.inspect());
        bar.inc(1);
    }
    bar.finish_and_clear();
    let fronts =
        [32.0, 1000.0, 65536.0].into_iter().flat_map(|n| VECTOR_BITS.map(|bits| quantisation::front_end(n, bits)));
    let study = Study { conditioning: conditioning::measure(&EXTREMES)?, front_ends: fronts.collect(), entries };
    if let Some(directory) = &arguments.out {
        package::write_directory_of(document::STUDY, directory, &document::files(&study)?)?;
    }
    let broken: Vec<String> = study.entries.iter().flat_map(broken_of).collect();
    if arguments.json {
        let Study { conditioning, front_ends, entries } = &study;
        say_json(
            &json!({ "cores": entries, "conditioning": conditioning, "front_ends": front_ends, "broken": broken }),
        );
    } else {
        for Entry { case, refused, found } in &study.entries {
            let what = format!("{}, {}", case.method, case.value);
            match (found, refused) {
                (Some(found), _) => say(format!("{what}: {}", summary(found))),
                (None, reason) => say(format!("{what}: refused, {}", reason.as_deref().unwrap_or_default())),
            }
        }
        broken.iter().for_each(say);
        let found = study.entries.iter().filter_map(|entry| entry.found.as_ref());
        let inputs: u64 = found.map(|found| found.inputs).sum();
        say(format!("{} cores, {inputs} inputs, {} broken promises", study.entries.len(), broken.len()));
    }
    Ok(Verdict::of(broken.is_empty()))
}

fn broken_of(entry: &Entry) -> Vec<String> {
    let of = |found: &Inspection| {
        let head = format!("{}, {}", entry.case.method, entry.case.value);
        found.broken().into_iter().map(|what| format!("FAIL {head}: {what}")).collect()
    };
    entry.found.as_ref().map(of).unwrap_or_default()
}

fn one(arguments: &Arguments) -> Result<Verdict, Error> {
    let design = arguments.source.design()?;
    let lobe = match design.block() {
        BlockDesign::Lobe(lobe) => lobe,
        _ => return one_sampled(arguments, &design),
    };
    let spinner = progress::spinner("every input".to_owned());
    let found = Inspection::of(lobe);
    spinner.finish_and_clear();
    let broken = found.broken();
    if arguments.json {
        say_json(&json!({ "core": found, "broken": broken }));
        return Ok(Verdict::of(broken.is_empty()));
    }
    say(format!("{}: {} rows, {} inputs", found.core, found.rows, found.inputs));
    say(format!("  ranges        {}, in {} blocks of inputs", proof(&found.overflows, &found.undecided), found.blocks));
    say(format!("  wide registers {} results differ", found.wide_differences));
    say_signals(&found.largest, &found.widest);
    for narrowed in lobe.narrowed {
        say(format!("  narrowed      {} {} -> {}", narrowed.name, narrowed.from, narrowed.to));
    }
    let [low, high] = found.measured_ulps;
    say(format!(
        "  error         {low:.3}..{high:.3} ulps, proved within {:.3}..{:.3}",
        found.proved_ulps[0], found.proved_ulps[1]
    ));
    say(format!(
        "  ends          {} at x = 0, 1 - {} ulps at x = 1, {} results above 1",
        found.at_zero, found.below_one, found.above_one
    ));
    for (what, worst) in [("largest fall ", found.max_decrease), ("largest seam ", found.max_step_error)] {
        match worst.ulps {
            0.0 => say(format!("  {what} none")),
            ulps => say(format!("  {what} {ulps:.3} ulps at n = {}, x = {}", worst.shininess, worst.cosine)),
        }
    }
    for place in &found.places {
        say(format!("  at {:<13} {:.3} ulps off x^n at most (n = {})", place.name, place.ulps, place.shininess));
    }
    broken.iter().for_each(|what| say(format!("FAIL {what}")));
    Ok(Verdict::of(broken.is_empty()))
}

fn proof(overflows: &[String], undecided: &[String]) -> &'static str {
    if overflows.is_empty() && undecided.is_empty() { "proved that no needed value overflows" } else { "NOT SAFE" }
}

fn say_signals(largest: &Signal, widest: &Signal) {
    for (what, signal) in [("largest value", largest), ("widest value ", widest)] {
        say(format!("  {what} {} {}, up to {}", signal.name, signal.format, signal.largest));
    }
}

fn one_sampled(arguments: &Arguments, design: &Design) -> Result<Verdict, Error> {
    let spinner = progress::spinner("the core's parts".to_owned());
    let found = SampledInspection::of(design);
    spinner.finish_and_clear();
    let broken = found.broken();
    if arguments.json {
        say_json(&json!({ "core": found, "broken": broken }));
        return Ok(Verdict::of(broken.is_empty()));
    }
    let what = match design.block() {
        BlockDesign::Shader(shader) => {
            format!("{} materials, {} lights", shader.materials().len(), shader.shader.lights)
        }
        _ => "an image-based block".to_owned(),
    };
    say(format!("{}: {what}; too many inputs to run all", found.core));
    say(format!("  ranges        {}, part by part", proof(&found.overflows, &found.undecided)));
    for part in &found.parts {
        say(format!("    {:<22} {} blocks of inputs", part.name, part.blocks));
    }
    say(format!("  wide registers {} results differ, of {} inputs run", found.wide_differences, found.samples));
    say_signals(&found.largest, &found.widest);
    broken.iter().for_each(|what| say(format!("FAIL {what}")));
    Ok(Verdict::of(broken.is_empty()))
}

fn summary(found: &Inspection) -> String {
    format!(
        "{} inputs, error {:.2}..{:.2} ulps, largest value {:.4} ({}), fall {:.2}, seam {:.2} ulps{}",
        found.inputs,
        found.measured_ulps[0],
        found.measured_ulps[1],
        found.largest.largest,
        found.largest.name,
        found.max_decrease.ulps,
        found.max_step_error.ulps,
        if found.broken().is_empty() { "" } else { ", BROKEN" },
    )
}
