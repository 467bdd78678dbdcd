//! The recorded values, and the comparison with them.

use serde::Serialize;

use super::{Claim, Unit, significant};
use crate::platform::error::{Error, refuse};
use crate::platform::input;

/// How a table of measured values begins; further columns may follow.
pub const HEADER: &str = "claim,figure,measured";

/// The values as measured once, to four digits.
const BUILT_IN: &str = include_str!("recorded.csv");

/// Measured values by claim and figure.
#[derive(Clone, Debug, PartialEq)]
pub struct Recorded {
    rows: Vec<(String, String, f64)>,
}

/// A figure that is not as recorded.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Difference {
    /// The claim.
    pub claim: String,
    /// The figure.
    pub figure: String,
    /// What was measured, if the claim has such a figure.
    pub measured: Option<f64>,
    /// What is recorded, if anything is.
    pub recorded: Option<f64>,
}

impl std::fmt::Display for Difference {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let text = |value: Option<f64>| value.map_or_else(|| "nothing".to_owned(), significant);
        let (measured, recorded) = (text(self.measured), text(self.recorded));
        write!(f, "{}: {}: measured {measured}, recorded {recorded}", self.claim, self.figure)
    }
}

impl Recorded {
    /// The values that come with the program.
    ///
    /// # Errors
    /// None: a test reads them.
    pub fn built_in() -> Result<Self, Error> {
        Self::parse(BUILT_IN, "src/claims/recorded.csv")
    }

    /// Reads a table: the header [`HEADER`], then a line for each figure. Columns after the third are not read, so that
    /// the `claims.csv` of an earlier run is such a table.
    ///
    /// # Errors
    /// A text that is no such table; says which line of `file` is wrong.
    pub fn parse(text: &str, file: &str) -> Result<Self, Error> {
        input::check_separator(text, file)?;
        let (mut rows, mut offset) = (Vec::new(), 0);
        for (number, whole) in text.split_inclusive('\n').enumerate() {
            let line = whole.trim_end();
            let wrong = |what: &str, allowed: &str| Error::text(what, allowed, file, text, (offset, line.len()));
            if number == 0 {
                if !line.starts_with(HEADER) {
                    return Err(wrong(
                        "not a table of measured claims",
                        "its first line begins with claim,figure,measured",
                    ));
                }
            } else if !line.is_empty() {
                let mut fields = line.splitn(4, ',');
                let (Some(claim), Some(figure), Some(value)) = (fields.next(), fields.next(), fields.next()) else {
                    return Err(wrong("too few columns", "claim, figure and measured value, with commas between"));
                };
                let value = value.parse::<f64>().ok().filter(|value| value.is_finite());
                let Some(value) = value else {
                    return Err(wrong("the measured value is no finite number", "a decimal number such as 0.6889"));
                };
                rows.push((claim.to_owned(), figure.to_owned(), value));
            }
            offset += whole.len();
        }
        refuse!(offset == 0, format!("{file} is empty"), "a table that begins with claim,figure,measured");
        Ok(Self { rows })
    }

    /// The recorded value of a figure.
    #[must_use]
    pub fn value(&self, claim: &str, figure: &str) -> Option<f64> {
        self.rows.iter().find(|(c, f, _)| c == claim && f == figure).map(|&(_, _, value)| value)
    }

    /// The figures that are not as recorded, to three digits; then those recorded and not measured.
    #[must_use]
    pub fn differences(&self, claims: &[Claim]) -> Vec<Difference> {
        let mut found = Vec::new();
        for claim in claims {
            for figure in &claim.measured {
                let recorded = self.value(claim.id, figure.name);
                if !recorded.is_some_and(|recorded| agrees(figure.value, recorded, figure.unit)) {
                    let (claim, figure_name) = (claim.id.to_owned(), figure.name.to_owned());
                    found.push(Difference { claim, figure: figure_name, measured: Some(figure.value), recorded });
                }
            }
        }
        let measured = |id: &str, name: &str| {
            claims.iter().any(|claim| claim.id == id && claim.measured.iter().any(|figure| figure.name == name))
        };
        for (claim, figure, value) in self.rows.iter().filter(|(claim, figure, _)| !measured(claim, figure)) {
            let (claim, figure) = (claim.clone(), figure.clone());
            found.push(Difference { claim, figure, measured: None, recorded: Some(*value) });
        }
        found
    }
}

/// Whether a value is within half a unit of the third digit of the recorded one; a count or a zero exactly.
fn agrees(measured: f64, recorded: f64, unit: Unit) -> bool {
    if unit == Unit::Count || recorded == 0.0 {
        return measured == recorded;
    }
    let third = libm::exp10(libm::floor(libm::log10(recorded.abs())) - 2.0);
    (measured - recorded).abs() <= 0.5 * third
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_digits() {
        let percent = |measured, recorded| agrees(measured, recorded, Unit::Percent);
        assert!(percent(0.6889, 0.6891) && percent(0.6893, 0.6889) && !percent(0.6895, 0.6889));
        assert!(percent(-196.4, -196.3) && !percent(-197.0, -196.3) && !percent(196.3, -196.3));
        assert!(percent(0.0, 0.0) && !percent(1e-12, 0.0) && !percent(0.0, 1e-12));
        assert!(agrees(998.0, 998.0, Unit::Count) && !agrees(997.0, 998.0, Unit::Count));
    }
}
