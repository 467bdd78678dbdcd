//! The points of a run, written and read as CSV, JSON or SQLite.

use std::collections::BTreeSet;
use std::path::Path;

use super::{Point, Store, columns};
use crate::platform::error::Error;
use crate::platform::input;
use crate::synth::Timing;

/// The points that come with the program, as measured once; each row names the tools' versions.
const BUILT_IN: &str = include_str!("../../docs/trade.csv");

/// Points with their errors and costs.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Results(Vec<Point>);

impl Results {
    /// Results of these points, put into the order of [`Results::points`].
    #[must_use]
    pub fn new(mut points: Vec<Point>) -> Self {
        let key = |point: &Point| {
            let text = [&point.method, &point.coefficients, &point.variant, &point.shininess, &point.pipeline];
            let text = text.map(String::clone);
            (point.family, point.baseline, text, point.input_fraction, point.output_fraction, point.id.clone())
        };
        points.sort_by_cached_key(key);
        Self(points)
    }

    /// The points, by family, the project's own methods before baselines, then by the columns that tell them apart, the
    /// id last: the same points are always in the same order.
    #[must_use]
    pub fn points(&self) -> &[Point] {
        &self.0
    }

    /// The points that come with the program.
    ///
    /// # Errors
    /// None: a test reads them.
    pub fn built_in() -> Result<Self, Error> {
        Self::from_csv(BUILT_IN, "docs/trade.csv")
    }

    /// Reads a file: SQLite where its name ends in `.db`, JSON in `.json`, CSV in `.csv`.
    ///
    /// # Errors
    /// Another ending, or a file that cannot be read or is no such results.
    pub fn read(path: &Path) -> Result<Self, Error> {
        let text = || input::read_text(path, "results of `brdfgen explore` are text");
        let name = path.display().to_string();
        match path.extension().and_then(|ending| ending.to_str()) {
            Some("db") => Store::open_to_read(path)?.results(),
            Some("json") => Self::from_json(&text()?, &name),
            Some("csv") => Self::from_csv(&text()?, &name),
            _ => Err(Error::input(format!("{name}: unknown kind of results"), "results end in .db, .json or .csv")),
        }
    }

    /// The points as JSON: an array, as serde writes [`Point`].
    ///
    /// # Panics
    /// Never: every point has a JSON form.
    #[must_use]
    pub fn to_json(&self) -> String {
        serde_json::to_string_pretty(&self.0).expect("JSON of plain values") + "\n"
    }

    /// Reads what [`Results::to_json`] writes; `file` names it in messages.
    ///
    /// # Errors
    /// Text that is no such array, with the place; a point that is there twice, or a figure that cannot be one.
    pub fn from_json(text: &str, file: &str) -> Result<Self, Error> {
        let points: Vec<Point> = serde_json::from_str(text).map_err(|error| {
            let before: usize = text.split_inclusive('\n').take(error.line().saturating_sub(1)).map(str::len).sum();
            let at = (before + error.column().saturating_sub(1)).min(text.len());
            let at = (0..=at).rev().find(|&at| text.is_char_boundary(at)).unwrap_or(0);
            Error::text(error.to_string(), "results of `brdfgen explore` as JSON", file, text, (at, 0))
        })?;
        Self::checked(points, |_| file.to_owned())
    }

    /// The points as CSV, a line each: the columns of [`Point`], then those of its cost. Lists are written with spaces,
    /// the spec as a TOML inline table; what is missing is empty. The slowest paths of a placement are left out.
    ///
    /// # Panics
    /// Never: every point has a CSV form.
    #[must_use]
    pub fn to_csv(&self) -> String {
        columns::write(&self.0)
    }

    /// Reads what [`Results::to_csv`] writes; `file` names it in messages. Columns may be in any order, and there may
    /// be more.
    ///
    /// # Errors
    /// Text that is no such table, with the line (that of the headings is the first) and the column; a point that is
    /// there twice, or a figure that cannot be one.
    pub fn from_csv(text: &str, file: &str) -> Result<Self, Error> {
        let (points, lines) = columns::read(text, file)?;
        Self::checked(points, |index| format!("{file}, line {}", lines[index]))
    }

    /// Results whose figures are ones that can be compared and drawn, each core once; `place` names where the point of
    /// an index stands.
    pub(super) fn checked(points: Vec<Point>, place: impl Fn(usize) -> String) -> Result<Self, Error> {
        let mut seen = BTreeSet::new();
        for (index, point) in points.iter().enumerate() {
            let twice = (!seen.insert(&point.id)).then(|| "is there twice".to_owned());
            if let Some(what) = twice.or_else(|| wrong_figure(point)) {
                return Err(Error::input(
                    format!("{}: the point {} {what}", place(index), point.id),
                    "results of `brdfgen explore`, as it wrote them",
                ));
            }
        }
        Ok(Self::new(points))
    }
}

/// What is wrong with a point's figures, as each of them is used: errors are compared and drawn by their logarithms, a
/// frequency divides, and everything is written as JSON again, which has finite numbers only.
fn wrong_figure(point: &Point) -> Option<String> {
    let synthesis = point.synthesis.as_ref();
    let timing = synthesis.and_then(|synthesis| synthesis.timing.as_ref());
    let errors = [("max_abs", point.max_abs), ("max_rel", point.max_rel), ("rms", point.rms), ("bound", point.bound)];
    let amounts = errors.into_iter().chain([("worst_n", point.worst_n)]);
    let amounts = amounts.chain(synthesis.and_then(|synthesis| synthesis.latency_ns).map(|ns| ("latency_ns", ns)));
    let clocks = timing.into_iter().flat_map(|timing| {
        let Timing { target_mhz, mhz, min_mhz, median_mhz, max_mhz, limits: _ } = timing;
        let own = [("min_mhz", min_mhz), ("median_mhz", median_mhz), ("max_mhz", max_mhz), ("target_mhz", target_mhz)];
        own.into_iter().chain(mhz.iter().map(|mhz| ("mhz_by_seed", mhz))).map(|(what, &value)| (what, value))
    });
    let rate = synthesis.and_then(|synthesis| synthesis.results_per_second).map(|rate| ("results_per_second", rate));
    let estimate = point.estimate.as_ref().and_then(|estimate| estimate.mhz).map(|mhz| ("estimated_mhz", mhz));
    let needed = |what: &str, value: f64, needed: &str| format!("says {what} is {value}, where {needed} is needed");
    if !point.worst_x.is_finite() {
        return Some(needed("worst_x", point.worst_x, "a finite number"));
    }
    let amount = amounts.into_iter().find(|(_, value)| !(value.is_finite() && *value >= 0.0));
    let clock = clocks.chain(rate).chain(estimate).find(|(_, value)| !(value.is_finite() && *value > 0.0));
    let limits = timing.into_iter().flat_map(|timing| &timing.limits).map(|limit| [limit.logic_ns, limit.routing_ns]);
    let limit = limits.flatten().find(|ns| !ns.is_finite()).map(|ns| ("a slowest path's delay", ns));
    amount
        .map(|(what, value)| needed(what, value, "a finite number of 0 or more"))
        .or_else(|| clock.map(|(what, value)| needed(what, value, "a finite number above 0")))
        .or_else(|| limit.map(|(what, value)| needed(what, value, "a finite number")))
        .or_else(|| {
            let Timing { min_mhz, median_mhz, max_mhz, .. } = timing?;
            let ordered = min_mhz <= median_mhz && median_mhz <= max_mhz;
            (!ordered).then(|| {
                format!("says min_mhz, median_mhz and max_mhz are {min_mhz}, {median_mhz} and {max_mhz}, out of order")
            })
        })
}
