//! `brdfgen claims`.

use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::json;

use super::{Verdict, progress, say, say_json};
use crate::emit::package::{self, Kind, counted};
use crate::papers::images::Speed;
use crate::papers::{self, Claim, HEADER, Recorded};
use crate::platform::error::Error;
use crate::platform::input;
use crate::platform::paths::Paths;

/// The directory of a run's files.
const REPORT: Kind = Kind { what: "a report of claims", file: "claims.csv", mark: HEADER };

#[derive(Args)]
pub(super) struct Arguments {
    /// Directory for claims.csv, error_against_n.csv, error_against_angle.csv and the charts (SVG and PNG): a new or
    /// empty one, or one of an earlier run [default: nothing is written]
    #[arg(long, short, value_name = "DIR")]
    out: Option<PathBuf>,

    /// Compare with the values of this table, such as the claims.csv of an earlier run, instead of those recorded in
    /// the program; exit 1 if one differs in its first three digits
    #[arg(long, value_name = "FILE")]
    recorded: Option<PathBuf>,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<Verdict, Error> {
    let recorded = match &arguments.recorded {
        None => Recorded::built_in()?,
        Some(path) => read(path)?,
    };
    if let Some(directory) = &arguments.out {
        package::check_target_of(REPORT, directory)?;
        Paths::new().writes_in("--out", directory, papers::TABLES).check()?;
    }
    let bar = progress::bar("measuring", papers::SHININESSES);
    let rows = papers::survey(&|| bar.inc(1))?;
    bar.finish_and_clear();
    let claims = papers::claims(&rows)?;
    if let Some(directory) = &arguments.out {
        let files = papers::files(&rows, &claims)?;
        Paths::new().writes_in("--out", directory, files.iter().map(|file| file.path.as_str())).check()?;
        package::write_directory_of(REPORT, directory, &files)?;
    }
    let speeds = papers::images::speeds()?;
    let differences = recorded.differences(&claims);
    if arguments.json {
        say_json(&json!({ "claims": claims, "speeds": speeds, "differences": differences }));
    } else {
        table(&claims).iter().for_each(say);
        speed_lines(&speeds).iter().for_each(say);
        for difference in &differences {
            say(difference.to_string());
        }
        let figures: usize = claims.iter().map(|claim| claim.measured.len()).sum();
        let differing = differences.len();
        say(format!("{} claims, {figures} figures, {differing} not as recorded", claims.len()));
        if let Some(directory) = &arguments.out {
            say(format!("tables and charts in {}", directory.display()));
        }
    }
    Ok(Verdict::of(differences.is_empty()))
}

/// Table I of IB with what was measured just now.
fn speed_lines(speeds: &[Speed]) -> Vec<String> {
    let heading = "images-speed (IB, table I): Another light does not make rendering notably slower. Claimed: 323 of \
                   325 and 380 of 388 frames a second with 8 lights and with 1. By rays on this processor, images of \
                   512 x 512, timed now and compared with no record:";
    let line = |Speed { mesh, lights, fps, ratio }: &Speed| {
        format!("  {mesh}, {}: {fps:.0} frames a second, {ratio:.2} of those with 1", counted(*lights as u64, "light"))
    };
    std::iter::once(heading.to_owned()).chain(speeds.iter().map(line)).chain([String::new()]).collect()
}

fn read(path: &Path) -> Result<Recorded, Error> {
    let text = input::read_text(path, "recorded values are a CSV file")?;
    Recorded::parse(&text, &path.display().to_string())
}

/// Claimed, measured and verdict, a line for each measured figure; the claim itself is on a line above.
fn table(claims: &[Claim]) -> Vec<String> {
    let width = |text: &str| text.chars().count();
    let figures = || claims.iter().flat_map(|claim| &claim.measured);
    let claimed = claims.iter().map(|claim| width(claim.claimed)).max().unwrap_or(0).max("claimed".len());
    let value = figures().map(|figure| width(&figure.to_string())).max().unwrap_or(0).max("measured".len());
    let name = figures().map(|figure| width(figure.name)).max().unwrap_or(0);
    let line = |claim: &str, number: &str, what: &str, verdict: &str| {
        format!("  {claim:claimed$} | {number:>value$}  {what:name$} | {verdict}").trim_end().to_owned()
    };
    let mut lines = vec![line("claimed", "measured", "", "verdict")];
    for claim in claims {
        lines.push(String::new());
        lines.push(format!("{} ({}): {}", claim.id, claim.source, claim.text));
        let verdict = claim.verdict.to_string();
        for (i, figure) in claim.measured.iter().enumerate() {
            let (left, right) = if i == 0 { (claim.claimed, verdict.as_str()) } else { ("", "") };
            lines.push(line(left, &figure.to_string(), figure.name, right));
        }
    }
    lines.push(String::new());
    lines
}
