//! `brdfgen formal`.

use clap::Args;
use serde_json::json;

use super::source::{OnDisk, Source};
use super::{Verdict, progress, say, say_json};
use crate::emit::package::Part;
use crate::platform::error::Error;
use crate::verify::cosim::Job;
use crate::verify::formal::{self, Proof, Step};

#[derive(Args)]
pub(super) struct Arguments {
    /// The most seconds that the solver may take at once
    #[arg(long, value_name = "S", default_value_t = 20, value_parser = clap::value_parser!(u32).range(1..))]
    solver_limit: u32,

    /// End with exit code 0 although a claim is open, that is, neither proved nor refuted; without this it is 1, as for
    /// a refuted one
    #[arg(long)]
    allow_open: bool,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,

    #[command(flatten)]
    source: Source,
}

pub(super) fn run(arguments: &Arguments) -> Result<Verdict, Error> {
    let core = OnDisk::of(&arguments.source, arguments.source.design()?)?;
    let Job { design, golden, directory } = core.job();
    let spinner = progress::spinner("formal".to_owned());
    let tell = |step: Step| match step {
        Step::Begun(claim) => spinner.set_message(claim.to_owned()),
        Step::Ended(_) if arguments.json => {}
        Step::Ended(proof) => spinner.suspend(|| say_proof(proof)),
    };
    let mut proofs = formal::equivalence(design, directory, golden, arguments.solver_limit, &tell)?;
    proofs.extend(formal::around(design, &Part::of(design), directory, &tell)?);
    spinner.finish_and_clear();
    let all = |passes: &dyn Fn(formal::ProofStatus) -> bool| proofs.iter().all(|proof| passes(proof.verdict));
    if arguments.json {
        let passed = all(&|verdict| verdict == formal::ProofStatus::Proved);
        say_json(&json!({ "core": design.spec.name, "passed": passed, "proofs": proofs }));
    }
    Ok(Verdict::of(all(&|verdict| match verdict {
        formal::ProofStatus::Proved => true,
        formal::ProofStatus::Open => arguments.allow_open,
        formal::ProofStatus::Refuted => false,
    })))
}

/// Prints what came of a proof.
fn say_proof(proof: &Proof) {
    let verdict = match proof.verdict {
        formal::ProofStatus::Proved => "PROVED",
        formal::ProofStatus::Refuted => "REFUTED",
        formal::ProofStatus::Open => "OPEN",
    };
    say(format!("{verdict} {}: {}, {:.1} s", proof.claim, proof.how, proof.seconds));
}
