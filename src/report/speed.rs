//! The table of software speed that `cargo bench --bench ratios` writes.

use serde::Deserialize;

use crate::platform::error::Error;
use crate::platform::input;

/// Measured times of software, in groups of which all members were measured in turns.
#[derive(Clone, Debug, Default)]
pub struct Speed {
    /// The lines, in the file's order.
    pub(super) rows: Vec<SpeedRow>,
}

/// A line of the table.
#[derive(Clone, Debug, Deserialize)]
pub(super) struct SpeedRow {
    pub(super) group: String,
    pub(super) name: String,
    /// Nanoseconds for one: the least, the median and the greatest of the rounds.
    pub(super) ns_least: f64,
    pub(super) ns_median: f64,
    pub(super) ns_most: f64,
    /// The median of the rounds' ratios of the reference's time to this one's.
    pub(super) times_as_fast: f64,
    pub(super) reference: String,
    pub(super) tool: String,
    pub(super) machine: String,
}

/// The table that comes with the program.
const BUILT_IN: &str = include_str!("../../docs/speed.csv");

impl Speed {
    /// The table that comes with the program.
    ///
    /// # Errors
    /// None: a test reads it.
    pub fn built_in() -> Result<Self, Error> {
        Self::from_csv(BUILT_IN, "docs/speed.csv")
    }

    /// Reads such a table; `file` names it in messages.
    ///
    /// # Errors
    /// Text that is no such table, or a time or ratio that is no finite number above 0, with the line.
    pub fn from_csv(text: &str, file: &str) -> Result<Self, Error> {
        const ALLOWED: &str = "the table that `cargo bench --bench ratios` writes";
        input::check_separator(text, file)?;
        let wrong = |what: String, at: usize| {
            let at = at.min(text.len());
            // The reader's place is before the line breaks that it passes over.
            let at = at + text[at..].len() - text[at..].trim_start_matches(['\r', '\n']).len();
            let length = text[at..].lines().next().map_or(0, str::len);
            Error::text(what, ALLOWED, file, text, (at, length))
        };
        let byte = |position: Option<&csv::Position>| position.map_or(0, |position| position.byte() as usize);
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let heads = reader.headers().map_err(|error| wrong(error.to_string(), 0))?.clone();
        let mut rows = Vec::new();
        for record in reader.records() {
            let record = record.map_err(|error| wrong(error.to_string(), byte(error.position())))?;
            let at = byte(record.position());
            let row: SpeedRow = record.deserialize(Some(&heads)).map_err(|error| wrong(error.to_string(), at))?;
            let figures = [
                ("ns_least", row.ns_least),
                ("ns_median", row.ns_median),
                ("ns_most", row.ns_most),
                ("times_as_fast", row.times_as_fast),
            ];
            if let Some((what, value)) = figures.into_iter().find(|(_, value)| !(value.is_finite() && *value > 0.0)) {
                return Err(wrong(format!("{what} is {value}, where a finite number above 0 is needed"), at));
            }
            rows.push(row);
        }
        Ok(Self { rows })
    }
}

/// A time in a unit that leaves it readable.
pub(super) fn time(ns: f64) -> String {
    match ns {
        ..1e3 => format!("{ns:.2} ns"),
        ..1e6 => format!("{:.2} µs", ns / 1e3),
        ..1e9 => format!("{:.2} ms", ns / 1e6),
        _ => format!("{:.2} s", ns / 1e9),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_built_in_table_is_read() {
        let speed = Speed::built_in().unwrap();
        assert!(speed.rows.iter().any(|row| row.reference == "std powf" && row.name == "quadratic"));
        assert!(
            speed
                .rows
                .iter()
                .all(|row| 0.0 < row.ns_least && row.ns_least <= row.ns_median && row.ns_median <= row.ns_most)
        );
    }

    #[test]
    fn another_table_is_refused() {
        assert!(Speed::from_csv("a,b\n1,2\n", "x.csv").is_err());
        let wrong = BUILT_IN.replacen("e0", "f0", 1);
        let wrong = if wrong == BUILT_IN { BUILT_IN.replacen("e1", "f1", 1) } else { wrong };
        assert!(Speed::from_csv(&wrong, "x.csv").is_err());
    }

    #[test]
    fn times_that_cannot_be_are_refused_with_their_line() {
        let head = BUILT_IN.lines().next().unwrap();
        let row = |figures: &str| format!("{head}\n\na,b,{figures},c,d,e\n");
        assert!(Speed::from_csv(&row("1,2,3,0.5"), "x.csv").is_ok());
        for (figures, expected) in [
            ("0,2,3,0.5", "ns_least is 0, where a finite number above 0 is needed"),
            ("1,-2,3,0.5", "ns_median is -2, where"),
            ("1,2,1e999,0.5", "ns_most is inf, where"),
            ("1,2,3,nan", "times_as_fast is NaN, where"),
        ] {
            match Speed::from_csv(&row(figures), "x.csv").unwrap_err() {
                Error::Text { what, at, text, .. } => {
                    assert!(what.starts_with(expected), "{what}");
                    assert!(text.inner()[at.offset()..].starts_with("a,b,"), "{what}");
                }
                other => panic!("{other}"),
            }
        }
        let error = Speed::from_csv(&BUILT_IN.replace(',', ";"), "x.csv").unwrap_err();
        assert!(error.to_string().contains("this has semicolons"), "{error}");
    }

    #[test]
    fn times_are_readable() {
        assert_eq!([0.5, 1.5e3, 2e6, 3.25e9].map(time), ["0.50 ns", "1.50 µs", "2.00 ms", "3.25 s"]);
    }
}
