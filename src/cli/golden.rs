//! `brdfgen golden`.

use std::path::PathBuf;

use clap::Args;
use serde_json::json;

use super::source::{Source, read_golden};
use super::{Verdict, say, say_json, write_to};
use crate::platform::error::Error;
use crate::verify::cosim::LISTED;
use crate::verify::golden::{Golden, differences};

#[derive(Args)]
pub(super) struct Arguments {
    /// File to write; - is standard output [default: golden/NAME.vec]
    #[arg(long, short, value_name = "FILE", conflicts_with = "check")]
    out: Option<PathBuf>,

    /// Compare a golden file with the model; exit 1 and list the first differences if there are any
    #[arg(long, value_name = "FILE")]
    check: Option<PathBuf>,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,

    #[command(flatten)]
    source: Source,
}

pub(super) fn run(arguments: Arguments) -> Result<Verdict, Error> {
    let design = arguments.source.design()?;
    if let Some(path) = &arguments.check {
        let got = read_golden(&design, path)?;
        let expected = Golden::of(&design);
        let found = differences(&design, &expected, &got);
        let (vectors, digests) = (expected.vectors().len(), expected.digests.len());
        if arguments.json {
            let first: Vec<_> = found.iter().take(LISTED).collect();
            say_json(&json!({ "vectors": vectors, "digests": digests, "differences": found.len(), "first": first }));
        } else {
            for difference in found.iter().take(LISTED) {
                say(difference.to_string());
            }
            say(format!("{}: {vectors} vectors and {digests} digests, {} differences", path.display(), found.len()));
        }
        return Ok(Verdict::of(found.is_empty()));
    }
    let path = arguments.out.unwrap_or_else(|| PathBuf::from(crate::emit::package::golden_path(&design)));
    arguments.source.paths().writes("--out", &path).check()?;
    let golden = Golden::of(&design);
    write_to(&path, golden.to_text(&design).as_bytes())?;
    if arguments.json && path.as_os_str() != "-" {
        let (vectors, digests) = (golden.vectors().len(), golden.digests.len());
        say_json(&json!({ "file": path.display().to_string(), "vectors": vectors, "digests": digests }));
    } else if path.as_os_str() != "-" {
        say(format!("{} vectors and {} digests in {}", golden.vectors().len(), golden.digests.len(), path.display()));
    }
    Ok(Verdict::Done)
}
