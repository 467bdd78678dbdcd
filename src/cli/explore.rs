//! `brdfgen explore`.

use std::path::{Path, PathBuf};

use clap::{Args, Subcommand};
use serde_json::json;

use super::{Verdict, progress, say, say_json, warn, write_to};
use crate::explore::run::{self, Costing, Failed, Flow, Summary};
use crate::explore::store::Earlier;
use crate::explore::sweep::{Axes, Plan, Shard};
use crate::explore::{Model, Point, Results, Store, Sweep};
use crate::method::word;
use crate::platform::error::Error;
use crate::platform::input;
use crate::platform::paths::Paths;
use crate::synth;
use crate::target::Family;

#[derive(Args)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub(super) struct Arguments {
    #[command(subcommand)]
    command: Option<Command>,

    #[command(flatten)]
    explore: Explore,
}

#[derive(Subcommand)]
enum Command {
    /// Join the results of shards
    Merge(Merge),
}

#[derive(Args)]
struct Merge {
    /// The results files of the shards
    #[arg(required = true, value_name = "FILE.db")]
    parts: Vec<PathBuf>,

    /// The joined results, a new file
    #[arg(long, short, value_name = "FILE.db")]
    out: PathBuf,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,
}

#[derive(Args)]
struct Explore {
    /// A sweep file; axes given as flags win over it
    ///
    /// It has [[sweep]] blocks of spec keys, each with a value or a list of values
    #[arg(value_name = "SWEEP.toml")]
    path: Option<PathBuf>,

    /// Where the points are kept, each as soon as it is finished; a file that is there is gone on with
    #[arg(long, required_unless_present = "list", value_name = "FILE.db")]
    results: Option<PathBuf>,

    /// Cost by a cost model instead of synthesis
    #[arg(long)]
    estimate: bool,

    /// Points worked on at a time [default: the number of processors]
    #[arg(long, short, value_name = "J")]
    jobs: Option<std::num::NonZeroUsize>,

    /// Only every Nth core by id, from the Ith: the parts 1/N to N/N make the whole
    #[arg(long, value_name = "I/N")]
    shard: Option<Shard>,

    /// Try points again that failed in an earlier run
    #[arg(long)]
    retry_failed: bool,

    /// Delete what the results file holds first
    #[arg(long)]
    fresh: bool,

    /// List the cores of the sweep and run nothing
    #[arg(long)]
    list: bool,

    /// Write all points of the results file as CSV; - is standard output
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,

    /// Write all points of the results file as JSON; - is standard output
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,

    #[command(flatten)]
    axes: AxisFlags,

    #[command(flatten)]
    costs: CostFlags,
}

/// How costs are found.
#[derive(Args)]
#[command(next_help_heading = super::help::COSTS)]
struct CostFlags {
    /// Measured points that the cost model is fitted to: a .db, .csv or .json file [default: those that come with the
    /// program]
    #[arg(long, requires = "estimate", value_name = "FILE")]
    fit_from: Option<PathBuf>,

    /// How many seeds a core is placed with
    #[arg(long, default_value_t = 3, value_name = "K", conflicts_with = "estimate")]
    seeds: u32,

    /// The clock that a placement is asked for [default: the family's, as in synth]
    #[arg(long, value_name = "MHZ", conflicts_with = "estimate")]
    target_mhz: Option<f64>,

    /// Count the cells, and place nothing
    #[arg(long, conflicts_with = "estimate")]
    no_place: bool,

    /// Leave registers outside of ECP5's multipliers and block RAMs, as Yosys does
    #[arg(long, conflicts_with = "estimate")]
    no_pack: bool,

    /// The Yosys to use, as in synth
    #[arg(long, value_name = "PROGRAM", conflicts_with = "estimate")]
    yosys: Option<String>,

    /// Where netlists and placements are kept, as in synth
    #[arg(long, value_name = "DIR", conflicts_with = "estimate")]
    cache: Option<PathBuf>,
}

impl CostFlags {
    fn costing(self, estimate: bool, tell: &dyn Fn(String)) -> Result<Costing, Error> {
        if !estimate {
            return Ok(Costing::Synthesis(Flow {
                seeds: self.seeds,
                target_mhz: self.target_mhz,
                place: !self.no_place,
                pack: !self.no_pack,
                yosys: self.yosys,
                cache: Some(self.cache.unwrap_or_else(synth::default_cache)),
            }));
        }
        let model = Model::fit(&self.fit_from.as_deref().map_or_else(Results::built_in, Results::read)?)?;
        accuracy(&model).into_iter().for_each(tell);
        Ok(Costing::Estimate(model))
    }
}

/// The axes that have a flag of their own; a list is an axis, and `default` leaves the key out.
#[derive(Args)]
#[command(next_help_heading = "Axes (comma-separated; `default` leaves the key out)")]
struct AxisFlags {
    /// Methods [default: all]
    #[arg(long, value_delimiter = ',', value_name = "METHODS")]
    method: Vec<String>,

    /// Where the coefficients come from: paper, minimax
    #[arg(long, value_delimiter = ',', value_name = "KINDS")]
    coefficients: Vec<String>,

    /// Output fraction bits
    #[arg(long, value_delimiter = ',', value_name = "G")]
    output_fraction: Vec<String>,

    /// Input fraction bits
    #[arg(long, value_delimiter = ',', value_name = "F")]
    input_fraction: Vec<String>,

    /// Pipeline depths, or auto
    #[arg(long, value_delimiter = ',', value_name = "DEPTHS")]
    pipeline: Vec<String>,

    /// Sets of shininesses, separated by semicolons or given repeatedly: 1..=1000;5,12.5,80 [default: 1..=1000]
    #[arg(long, value_delimiter = ';', value_name = "SETS")]
    shininess: Vec<String>,

    #[arg(long, value_delimiter = ',', value_name = "FAMILIES", help = families())]
    family: Vec<String>,

    /// Any other key of a spec with its values, as in inside=linear,quadratic; repeat for more
    #[arg(long, value_name = "KEY=VALUES")]
    axis: Vec<String>,
}

fn families() -> String {
    format!("Families: {} [default: {}]", Family::names(|_| true).join(", "), Family::default().name)
}

impl AxisFlags {
    fn axes(&self) -> Result<Axes, Error> {
        let mut axes = Axes::default();
        for (key, values) in [
            ("method", &self.method),
            ("coefficients", &self.coefficients),
            ("output_fraction", &self.output_fraction),
            ("input_fraction", &self.input_fraction),
            ("pipeline", &self.pipeline),
            ("family", &self.family),
        ] {
            if !values.is_empty() {
                axes.set_written(key, values)?;
            }
        }
        if !self.shininess.is_empty() {
            axes.set_sets(&self.shininess)?;
        }
        for axis in &self.axis {
            let (key, values) = axis.split_once('=').ok_or_else(|| {
                Error::input(
                    format!("the axis `{axis}` has no value"),
                    "write KEY=VALUES, as in inside=linear,quadratic",
                )
            })?;
            let values: Vec<String> = values.split(',').map(str::to_owned).collect();
            axes.set_written(&key.replace('-', "_"), &values)?;
        }
        Ok(axes)
    }
}

pub(super) fn run(arguments: Arguments) -> Result<Verdict, Error> {
    match arguments.command {
        Some(Command::Merge(merge)) => self::merge(&merge),
        None => explore(arguments.explore),
    }
}

fn merge(arguments: &Merge) -> Result<Verdict, Error> {
    let paths = arguments.parts.iter().fold(Paths::new(), |paths, part| paths.reads("FILE.db", part));
    paths.writes("--out", &arguments.out).check()?;
    let count = Store::merge(&arguments.parts, &arguments.out)?;
    if arguments.json {
        say_json(&json!({ "out": arguments.out.display().to_string(), "points": count }));
    } else {
        say(format!("{count} points in {}", arguments.out.display()));
    }
    Ok(Verdict::Done)
}

fn explore(arguments: Explore) -> Result<Verdict, Error> {
    let axes = arguments.axes.axes()?;
    let sweep = match &arguments.path {
        None => Sweep::of(axes),
        Some(path) => {
            let text = input::read_text(path, "a sweep is a TOML file")?;
            Sweep::parse(&text, &path.display().to_string())?.with(&axes)
        }
    };
    let paths = [("SWEEP.toml", &arguments.path), ("--fit-from", &arguments.costs.fit_from)];
    let paths = paths
        .into_iter()
        .fold(Paths::new(), |paths, (what, path)| path.iter().fold(paths, |paths, path| paths.reads(what, path)));
    let stores = arguments.results.iter().flat_map(|path| store_files(path));
    stores
        .fold(paths, |paths, file| paths.writes("--results", file))
        .may_write("--csv", arguments.csv.as_ref())
        .may_write("--json", arguments.json.as_ref())
        .check()?;
    let plan = sweep.expand()?;
    // Where a result goes to standard output, the account of the run goes nowhere.
    let quiet = [&arguments.csv, &arguments.json].iter().any(|path| path.as_deref() == Some(Path::new("-")));
    let tell = |text: String| {
        if !quiet {
            say(text);
        }
    };
    describe(&plan).into_iter().for_each(tell);
    let total = plan.cores.len();
    let cores = arguments.shard.map_or_else(|| plan.cores.clone(), |shard| shard.of(plan.cores.clone()));
    if let Some(Shard { index, of }) = arguments.shard {
        tell(format!("shard {index} of {of}: {} of {total} cores", cores.len()));
    }
    if arguments.list {
        for core in &cores {
            let point = Point::unmeasured(core);
            say(format!("{} {} {}", point.id, word(&point.family), point.name));
        }
        return Ok(Verdict::Done);
    }
    let Some(path) = &arguments.results else {
        return Err(Error::input("no results file is given", "--results FILE.db"));
    };

    let costing = arguments.costs.costing(arguments.estimate, &tell)?;
    let earlier = if arguments.fresh { Earlier::Deleted } else { Earlier::Kept };
    let mut store = Store::open(path, &costing.provenance(&cores)?, earlier)?;
    let jobs = arguments.jobs.or_else(|| std::thread::available_parallelism().ok()).map_or(1, usize::from);
    let bar = progress::bar("exploring", cores.len() as u64);
    let progress = |_: usize, wanted: usize, point: &Point| {
        bar.set_length(wanted as u64);
        bar.inc(1);
        if let Some(failure) = &point.failure {
            let first = failure.lines().next().unwrap_or_default();
            bar.suspend(|| warn(format!("{} {}: {first}", point.id, point.name)));
        }
    };
    let failed = if arguments.retry_failed { Failed::Retry } else { Failed::Keep };
    let summary = run::run(&cores, &costing, &mut store, jobs, failed, &progress)?;
    bar.finish_and_clear();
    let results = store.results()?;
    if let Some(path) = &arguments.csv {
        write_to(path, results.to_csv().as_bytes())?;
    }
    if let Some(path) = &arguments.json {
        write_to(path, results.to_json().as_bytes())?;
    }
    let Summary { kept, made, no_core, failed, failed_before } = summary;
    tell(format!(
        "{made} points made, {kept} were there, {failed} failed; {} in {}",
        results.points().len(),
        path.display()
    ));
    if no_core > 0 {
        tell(format!("{no_core} of those made are no cores: they cannot be built"));
    }
    if failed_before > 0 {
        tell(format!("{failed_before} of those that were there have failed before: --retry-failed tries them again"));
    }
    Ok(Verdict::of(failed == 0 && failed_before == 0))
}

/// A results file, and what SQLite has beside it while it writes.
fn store_files(path: &Path) -> [PathBuf; 4] {
    ["", "-journal", "-wal", "-shm"].map(|end| {
        let mut name = path.as_os_str().to_owned();
        name.push(end);
        name.into()
    })
}

/// What a plan holds, and what it leaves out.
fn describe(plan: &Plan) -> Vec<String> {
    let Plan { cores, combinations, repeated, invalid } = plan;
    let wrong: usize = invalid.values().sum();
    let mut lines = vec![format!(
        "{combinations} combinations: {} cores, {repeated} the same as another, {wrong} not valid",
        cores.len()
    )];
    lines.extend(invalid.iter().map(|(why, count)| format!("  {count} not valid: {why}")));
    lines
}

/// How far a cost model is off.
fn accuracy(model: &Model) -> Vec<String> {
    let mut lines = Vec::new();
    for (family, model) in model.families() {
        lines.push(format!("cost model for {family}, fitted to {} points of {}:", model.points, model.tools.yosys));
        for accuracy in &model.accuracy {
            lines.push(format!(
                "  {:<4} off by {:.1} % in the median, {:.1} % at worst ({}), each of {} points estimated from the \
                 others",
                accuracy.what,
                100.0 * accuracy.median,
                100.0 * accuracy.worst,
                accuracy.at,
                accuracy.points
            ));
        }
    }
    lines
}
