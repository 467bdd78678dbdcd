//! `brdfgen mutate`.

use std::path::PathBuf;
use std::time::Instant;

use clap::Args;
use serde::Serialize;
use serde_json::json;

use super::source::{OnDisk, Source, read_golden};
use super::{Verdict, progress, say, say_json};
use crate::emit::package::rtl_path;
use crate::platform::error::{Error, refuse};
use crate::spec::{Language, RomStyle};
use crate::verify::cosim::{Job, Vectors};
use crate::verify::faults::{self, Mutant, Outcome, Tally};
use crate::verify::formal::netlist::{self, NetlistMutant};

#[derive(Args)]
pub(super) struct Arguments {
    /// Golden vectors [default: the core's own]
    #[arg(long, value_name = "FILE")]
    golden: Option<PathBuf>,

    /// At most so many of the mutants of the operations, registers and memories, evenly spread
    #[arg(long = "source", value_name = "N", default_value_t = usize::MAX, hide_default_value = true)]
    most: usize,

    /// So many mutants of the netlist of the core's Verilog as well, by Yosys and Verilator; its memories must be in
    /// its text
    #[arg(long, value_name = "N", default_value_t = 0, hide_default_value = true)]
    netlist: u32,

    /// Which words of the memories get a wrong bit, and which mutants of the netlist are taken
    #[arg(long, default_value_t = 0)]
    seed: u32,

    /// Print every mutant and what became of it
    #[arg(long)]
    list: bool,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,

    #[command(flatten)]
    source: Source,
}

pub(super) fn run(arguments: &Arguments) -> Result<Verdict, Error> {
    let start = Instant::now();
    let core = OnDisk::of(&arguments.source, arguments.source.design()?)?;
    let design = &core.design;
    let named = arguments.golden.as_ref().map(|path| read_golden(design, path)).transpose()?;
    let golden = named.as_ref().unwrap_or(&core.golden);
    let all = faults::mutants(design, arguments.seed);
    let step = all.len().div_ceil(arguments.most.max(1)).max(1);
    let mutants: Vec<Mutant> = all.into_iter().step_by(step).collect();
    let bar = progress::bar("mutants", mutants.len() as u64);
    let vectors = Vectors::of(design, golden);
    let outcomes = faults::outcomes(design, &mutants, &golden.vectors(), &|defect| {
        let detected = vectors.detect(defect);
        bar.inc(1);
        detected
    });
    bar.finish_and_clear();
    let row = |(mutant, outcome): (Mutant, Outcome)| MutantRow { kind: mutant.kind.name(), what: mutant.what, outcome };
    let mut sorts = vec![("source", mutants.into_iter().zip(outcomes).map(row).collect::<Vec<MutantRow>>())];
    if arguments.netlist > 0 {
        let spinner = progress::spinner("mutants of the netlist".to_owned());
        let row = |mutant: NetlistMutant| MutantRow { kind: "netlist", what: mutant.what, outcome: mutant.outcome };
        let found = netlist::outcomes(design, &verilog(&core.job())?, golden, arguments.netlist, arguments.seed)?;
        sorts.push(("netlist", found.into_iter().map(row).collect()));
        spinner.finish_and_clear();
    }
    let tallies: Vec<(&str, Tally)> =
        sorts.iter().map(|(sort, rows)| (*sort, Tally::of(rows.iter().map(|row| &row.outcome)))).collect();
    let name = &design.spec.name;
    let shown = sorts.iter().flat_map(|(_, rows)| rows).filter(|row| arguments.list || !is_settled(&row.outcome));
    if arguments.json {
        let of: serde_json::Map<_, _> =
            tallies.iter().map(|(sort, tally)| ((*sort).to_owned(), json!(tally))).collect();
        let list: Vec<_> = shown.collect();
        say_json(&json!({ "core": name, "tallies": of, "mutants": list }));
    } else {
        for MutantRow { kind, what, outcome } in shown {
            let end = match outcome {
                Outcome::Detected { by } => format!("killed: {by}"),
                Outcome::Equivalent { proof } => format!("equivalent: {proof}"),
                Outcome::Survived { input } => format!("SURVIVES; shown by {input}"),
                Outcome::Undecided { tried } => format!("not decided by {tried}"),
            };
            say(format!("{kind}: {what}: {end}"));
        }
        for (sort, tally) in &tallies {
            say(format!(
                "{name}, {sort}: {} mutants, {} killed, {} equivalent, {} survivors, {} not decided",
                tally.mutants, tally.detected, tally.equivalent, tally.survivors, tally.undecided
            ));
        }
        say(format!("{:.1} s", start.elapsed().as_secs_f64()));
    }
    Ok(Verdict::of(tallies.iter().all(|(_, tally)| tally.survivors == 0)))
}

/// A mutant, for printing.
#[derive(Serialize)]
struct MutantRow {
    kind: &'static str,
    what: String,
    #[serde(flatten)]
    outcome: Outcome,
}

/// The Verilog of a core on disk.
fn verilog(&Job { design, directory, .. }: &Job) -> Result<Vec<u8>, Error> {
    refuse!(
        !design.spec.languages.contains(&Language::Verilog) || design.spec.rom == RomStyle::File,
        format!("the core {} has no Verilog with its memories in the text", design.spec.name),
        "leave --netlist out, or generate the core with Verilog and an inline ROM"
    );
    let path = directory.join(rtl_path(design, Language::Verilog));
    std::fs::read(&path).map_err(|error| Error::io("cannot read", &path, error))
}

/// Whether there is nothing to be done about a mutant.
fn is_settled(outcome: &Outcome) -> bool {
    matches!(outcome, Outcome::Detected { .. } | Outcome::Equivalent { .. })
}
