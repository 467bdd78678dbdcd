//! The table of software speed that `cargo bench --bench ratios` writes.

use serde::Deserialize;

use crate::error::Error;

/// Measured times of software, in groups of which all members were measured in turns.
#[derive(Clone, Debug, Default)]
pub struct Speed {
    /// The lines, in the file's order.
    pub(super) rows: Vec<Row>,
}

/// A line of the table.
#[derive(Clone, Debug, Deserialize)]
pub(super) struct Row {
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
    /// Text that is no such table, with the line.
    pub fn from_csv(text: &str, file: &str) -> Result<Self, Error> {
        let rows: Result<Vec<Row>, csv::Error> = csv::Reader::from_reader(text.as_bytes()).deserialize().collect();
        let rows = rows.map_err(|error| {
            let at = error.position().map_or(0, |position| position.byte() as usize).min(text.len());
            let length = text[at..].lines().next().map_or(0, str::len);
            Error::text(
                error.to_string(),
                "the table that `cargo bench --bench ratios` writes",
                file,
                text,
                (at, length),
            )
        })?;
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
    fn times_are_readable() {
        assert_eq!([0.5, 1.5e3, 2e6, 3.25e9].map(time), ["0.50 ns", "1.50 µs", "2.00 ms", "3.25 s"]);
    }
}
