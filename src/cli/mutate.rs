//! `brdfgen mutate`.

use std::path::PathBuf;
use std::time::Instant;

use clap::Args;
use serde_json::json;

use super::source::{OnDisk, Source, read_golden};
use super::{Verdict, progress, say, say_json};
use crate::error::Error;
use crate::mutate::{Fate, Mutant, Tally, source};

#[derive(Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    source: Source,

    /// Golden vectors [default: the core's own]
    #[arg(long, value_name = "FILE")]
    golden: Option<PathBuf>,

    /// At most so many of the mutants of the operations, registers and memories, evenly spread
    #[arg(long = "source", value_name = "N", default_value_t = usize::MAX, hide_default_value = true)]
    most: usize,

    /// Which words of the memories get a wrong bit
    #[arg(long, default_value_t = 0)]
    seed: u64,

    /// Print every mutant and what became of it
    #[arg(long)]
    list: bool,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<Verdict, Error> {
    let start = Instant::now();
    let design = arguments.source.design()?;
    let golden = match &arguments.golden {
        Some(path) => read_golden(&design, path)?,
        None => OnDisk::of(&arguments.source, &design)?.golden,
    };
    let all = source::mutants(&design, arguments.seed);
    let step = all.len().div_ceil(arguments.most.max(1)).max(1);
    let mutants: Vec<Mutant> = all.into_iter().step_by(step).collect();
    let bar = progress::bar("mutants", mutants.len() as u64);
    let fates = source::fates(&design, &golden, &mutants, &|| bar.inc(1));
    bar.finish_and_clear();
    let tally = Tally::of(&fates);
    let name = &design.spec.name;
    let seconds = start.elapsed().as_secs_f64();
    if arguments.json {
        let of = |(mutant, fate): (&Mutant, &Fate)| {
            let mut value = json!(fate);
            value["kind"] = json!(mutant.kind);
            value["what"] = json!(mutant.what);
            value
        };
        let shown = mutants.iter().zip(&fates);
        let shown = shown.filter(|(_, fate)| arguments.list || !is_settled(fate));
        let list: Vec<_> = shown.map(of).collect();
        say_json(&json!({ "core": name, "source": tally, "mutants": list }));
    } else {
        for (mutant, fate) in mutants.iter().zip(&fates).filter(|(_, fate)| arguments.list || !is_settled(fate)) {
            let end = match fate {
                Fate::Killed { by } => format!("killed: {by}"),
                Fate::Equivalent { proof } => format!("equivalent: {proof}"),
                Fate::Survives { input } => format!("SURVIVES; shown by {input}"),
                Fate::Undecided { tried } => format!("not decided by {tried}"),
            };
            say(format!("{}: {}: {end}", mutant.kind.name(), mutant.what));
        }
        say(format!(
            "{name}: {} mutants, {} killed, {} equivalent, {} survivors, {} not decided, {seconds:.1} s",
            tally.mutants, tally.killed, tally.equivalent, tally.survivors, tally.undecided
        ));
    }
    Ok(Verdict::of(tally.survivors == 0))
}

/// Whether there is nothing to be done about a mutant.
fn is_settled(fate: &Fate) -> bool {
    matches!(fate, Fate::Killed { .. } | Fate::Equivalent { .. })
}
