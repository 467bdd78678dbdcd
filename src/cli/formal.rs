//! `brdfgen formal`.

use clap::Args;
use serde_json::json;

use super::source::Source;
use super::{Verdict, say, say_json};
use crate::error::Error;
use crate::formal::{self, Proof};

#[derive(Args)]
pub(super) struct Arguments {
    #[command(flatten)]
    source: Source,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<Verdict, Error> {
    let design = arguments.source.design()?;
    let proofs: Vec<Proof> = Vec::new();
    let passed = !proofs.is_empty() && proofs.iter().all(|proof| proof.verdict == formal::Verdict::Proved);
    if arguments.json {
        say_json(&json!({ "core": design.spec.name, "passed": passed, "proofs": proofs }));
    } else {
        proofs.iter().for_each(say_proof);
    }
    Ok(Verdict::of(passed))
}

/// Prints what came of a proof.
fn say_proof(proof: &Proof) {
    let verdict = match proof.verdict {
        formal::Verdict::Proved => "PROVED",
        formal::Verdict::Refuted => "REFUTED",
        formal::Verdict::Open => "OPEN",
    };
    say(format!("{verdict} {}, {:.1} s", proof.claim, proof.seconds));
    for line in &proof.why {
        say(format!("  {line}"));
    }
}
