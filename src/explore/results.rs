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

#[cfg(test)]
pub(super) mod tests {
    use std::collections::BTreeMap;

    use super::super::{Estimate, Shape};
    use super::*;
    use crate::spec::SpecFields;
    use crate::synth::{Resources, Synthesis, Tools};
    use crate::target::Family;

    /// A point with the given spec, error and costs.
    pub(in crate::explore) fn point(id: &str, max_abs: f64, [lut, dsp, bram, latency]: [u32; 4], mhz: f64) -> Point {
        let spec = SpecFields::parse("method = 'power-4'\n[[material]]\nname = 'a, \"b\"'\nshininess = 5.5", "spec")
            .and_then(SpecFields::resolve)
            .unwrap();
        let tools = Tools { yosys: "Yosys 0.70, one".to_owned(), nextpnr: Some("nextpnr-ecp5 0.11".to_owned()) };
        let cells = BTreeMap::from([("LUT4".to_owned(), lut), ("TRELLIS_FF".to_owned(), 90)]);
        Point {
            id: id.to_owned(),
            name: format!("power-4 {id}"),
            family: Family::Ecp5,
            method: "power-4".to_owned(),
            coefficients: "minimax".to_owned(),
            variant: "inside=linear".to_owned(),
            baseline: false,
            shininess: "1 material".to_owned(),
            rows: 1,
            input_fraction: 16,
            output_fraction: 16,
            pipeline: "auto".to_owned(),
            max_abs,
            max_rel: 0.1 + 0.2,
            rms: max_abs / 3.0,
            worst_n: 5.5,
            worst_x: 0.987_654_321,
            checked: "exhaustive".to_owned(),
            bound: 1.4e-5,
            rom_bits: 100,
            latency,
            shape: Shape {
                multipliers: vec!["18x17".parse().unwrap(), "19x12s".parse().unwrap()],
                memories: vec!["1024x24r".parse().unwrap(), "16x9".parse().unwrap()],
                adder_bits: 40,
                mux_bits: 30,
                shift_bits: 20,
                register_bits: 200,
            },
            synthesis: Some(Synthesis {
                family: Family::Ecp5,
                device: "LFE5U-85F".to_owned(),
                tools: tools.clone(),
                resources: Resources { lut, carry: 0, lut_total: lut, ff: 90, dsp, bram, cells },
                timing: Some(Timing {
                    target_mhz: 150.0,
                    mhz: vec![mhz - 1.0, mhz, mhz + 1.1],
                    min_mhz: mhz - 1.0,
                    median_mhz: mhz,
                    max_mhz: mhz + 1.1,
                    limits: Vec::new(),
                }),
                latency_clocks: latency,
                latency_ns: Some(1000.0 * f64::from(latency) / mhz),
                results_per_second: Some(mhz * 1e6),
            }),
            estimate: Some(Estimate { tools, points: 9, lut: lut + 1, ff: 91, dsp, bram, mhz: None }),
            failure: None,
            spec: spec.to_toml(),
        }
    }

    #[test]
    fn points_survive_csv_and_json() {
        let bare = Point {
            synthesis: None,
            estimate: None,
            failure: Some("no, \"none\"\nat all".to_owned()),
            ..point("b", 0.0, [1, 0, 0, 3], 100.0)
        };
        let results = Results::new(vec![bare, point("a", 0.1, [100, 2, 0, 7], 151.3)]);
        assert_eq!(results.points()[0].id, "a");
        let csv = results.to_csv();
        assert_eq!(csv.lines().count(), 4, "a line a point but for the failure's own line break\n{csv}");
        assert_eq!(Results::from_csv(&csv, "a.csv").unwrap(), results);
        assert_eq!(Results::from_json(&results.to_json(), "a.json").unwrap(), results);
    }

    #[test]
    fn wrong_files_are_named_with_the_line() {
        let csv = Results::new(vec![point("a", 0.1, [100, 2, 0, 7], 151.3)]).to_csv();
        for (text, expected) in [
            (csv.replacen("ecp5", "ecp9", 1), "ecp9"),
            (csv.replacen("TRELLIS_FF=90", "TRELLIS_FF", 1), "not CELL=COUNT"),
            (csv.replacen("name", "nom", 1), "missing field"),
            (csv.replacen("power-4\"", "power-5\"", 1), "power-5"),
            (String::new(), "a.csv, line 1: there is no line of headings"),
            (
                csv.replacen(",16,16,auto,", ",16,auto,", 1),
                "a.csv, line 2: it has 53 fields, where the headings are 54",
            ),
            (csv.replacen("exhaustive,0.000014", "exhaustive,x", 1), "a.csv, line 2: bound: \"x\" is no number"),
            (csv.replacen(",16,16,auto,0.1,", ",16,16,auto,NaN,", 1), "a.csv, line 2: the point a says max_abs is NaN"),
            (csv.replacen(",16,16,auto,0.1,", ",16,16,auto,-1,", 1), "the point a says max_abs is -1"),
            (
                csv.replacen(",16,16,auto,0.1,", ",16,16,auto,1e999,", 1),
                "the point a says max_abs is inf, where a finite",
            ),
            (csv.replacen("5.5,0.987654321", "-1,0.987654321", 1), "says worst_n is -1, where a finite number of 0"),
            (csv.replacen("5.5,0.987654321", "5.5,9e875", 1), "says worst_x is inf, where a finite number is needed"),
            (
                csv.replacen(",100,100,0,90,", ",100,-1,0,90,", 1),
                "line 2: lut: \"-1\" is no count, a whole number from 0",
            ),
            (csv.replacen(",100,100,0,90,", ",100,1.5,0,90,", 1), "line 2: lut: \"1.5\" is no count"),
            (csv.replacen(",100,100,0,90,", ",100,,0,90,", 1), "line 2: the synthesis has no lut, and has the rest"),
            (
                csv.replacen(",150.3,151.3,152.4", ",150.3,,152.4", 1),
                "line 2: the placement has no median_mhz, and has",
            ),
            (
                csv.replacen(",150.3,151.3,152.4", ",0,0,0", 1),
                "says min_mhz is 0, where a finite number above 0 is needed",
            ),
            (csv.replacen(",150.3,151.3,152.4", ",150.3,-0.0,152.4", 1), "says median_mhz is -0, where"),
            (csv.replacen(",150.3,151.3,152.4", ",150.3,149,152.4", 1), "150.3, 149 and 152.4, out of order"),
            (csv.replacen("150.3 151.3 152.4", "150.3 inf 152.4", 1), "says mhz_by_seed is inf"),
            (csv.replace(',', ";"), "columns are separated by commas and this has semicolons"),
            (
                csv.clone() + "\n\n" + csv.lines().nth(1).unwrap_or_default(),
                "a.csv, line 5: the point a is there twice",
            ),
            (
                csv.replace('\n', "\r\n") + csv.lines().nth(1).unwrap_or_default(),
                "a.csv, line 3: the point a is there twice",
            ),
        ] {
            let error = Results::from_csv(&text, "a.csv").expect_err(expected);
            assert!(error.to_string().contains(expected), "{error}, expected: {expected}");
        }
        assert!(Results::from_json("[{}]", "a.json").is_err());
        let json = Results::new(vec![point("a", 0.1, [100, 2, 0, 7], 151.3)]).to_json();
        for (from, to, expected) in [
            ("\"median_mhz\": 151.3", "\"median_mhz\": 0", "a.json: the point a says median_mhz is 0, where"),
            ("\"median_mhz\": 151.3", "\"median_mhz\": 1e999", "number out of range"),
            ("\"lut\": 100", "\"lut\": -1", "invalid value: integer `-1`"),
            ("\"max_abs\": 0.1", "\"max_abs\": null", "invalid type: null"),
        ] {
            let changed = json.replacen(from, to, 1);
            assert_ne!(changed, json, "{from}");
            let error = Results::from_json(&changed, "a.json").expect_err(expected);
            assert!(error.to_string().contains(expected), "{error}, expected: {expected}");
        }
        assert!(Results::read(Path::new("results.xml")).unwrap_err().to_string().contains("unknown kind"));
    }

    #[test]
    fn the_built_in_points_are_read() {
        assert!(Results::built_in().is_ok());
    }
}
