//! `brdfgen formal`.

use clap::Args;
use serde_json::json;

use super::source::{OnDisk, Source};
use super::{Verdict, progress, say, say_json};
use crate::platform::error::Error;
use crate::verify::formal::{self, Proof, Step};

#[derive(Args)]
pub(super) struct Arguments {
    /// The most seconds that the solver may take at once
    #[arg(long, value_name = "S", default_value_t = 20, value_parser = clap::value_parser!(u32).range(1..))]
    solver_limit: u32,

    /// End with exit code 0 although a claim is open, that is, neither proved nor refuted; without this it is 1, as for a refuted one
    #[arg(long)]
    allow_open: bool,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,

    #[command(flatten)]
    source: Source,
}

pub(super) fn run(arguments: &Arguments) -> Result<Verdict, Error> {
    let design = arguments.source.design()?;
    let core = OnDisk::of(&arguments.source, &design)?;
    let spinner = progress::spinner("formal".to_owned());
    let tell = |step: Step| match step {
        Step::Begun(claim) => spinner.set_message(claim.to_owned()),
        Step::Ended(_) if arguments.json => {}
        Step::Ended(proof) => spinner.suspend(|| say_proof(proof)),
    };
    let mut proofs = formal::equivalence(&design, core.path(), &core.golden, arguments.solver_limit, &tell)?;
    proofs.extend(formal::stream(&design, core.path(), &tell)?);
    spinner.finish_and_clear();
    let all = |passes: &dyn Fn(formal::Verdict) -> bool| proofs.iter().all(|proof| passes(proof.verdict));
    if arguments.json {
        let passed = all(&|verdict| verdict == formal::Verdict::Proved);
        say_json(&json!({ "core": design.spec.name, "passed": passed, "proofs": proofs }));
    }
    Ok(Verdict::of(all(&|verdict| match verdict {
        formal::Verdict::Proved => true,
        formal::Verdict::Open => arguments.allow_open,
        formal::Verdict::Refuted => false,
    })))
}

/// Prints what came of a proof.
fn say_proof(proof: &Proof) {
    let verdict = match proof.verdict {
        formal::Verdict::Proved => "PROVED",
        formal::Verdict::Refuted => "REFUTED",
        formal::Verdict::Open => "OPEN",
    };
    say(format!("{verdict} {}: {}, {:.1} s", proof.claim, proof.how, proof.seconds));
}
