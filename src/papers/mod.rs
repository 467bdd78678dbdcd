//! The papers' claims, measured.
//!
//! Q is "Quadratic approximation of BRDF"; C7 is "Approximation of Bidirectional Reflectance Distribution Function with
//! 3-Degree Polynomial" (IEEE, 2007); C21 is "Approximation of classical distributive functions using a cubic
//! polynomial" (2021); IB is "Image-based BRDF Representation", of another method: [`images`].
//!
//! Everything is measured on the real-valued lobes of [`crate::lobe`], at every integer shininess of a claim's range
//! and up to 1000. Errors are the largest over the cosines in question, to at least four digits: see [`SurveyRow`].

mod claims;
mod cos_k;
mod cubic;
mod figures;
pub mod images;
mod measure;
mod method;
mod quadratic;
mod record;
mod survey;
mod taylor;

pub use claims::claims;
pub use cos_k::CosK;
pub use figures::{TABLES, files};
pub use method::{PaperMethod, Pieces};
pub use record::{Difference, HEADER, Recorded};
pub use survey::{Errors, SurveyRow, survey};
pub use taylor::{Taylor, TaylorSeries};

use std::sync::LazyLock;

use serde::Serialize;

/// The number of shininesses that [`survey()`] measures.
pub const SHININESSES: u64 = survey::MOST as u64;

/// A claim of a paper and what was measured of it.
#[derive(Clone, Debug, Serialize)]
pub struct Claim {
    /// A short name, unique.
    pub id: &'static str,
    /// The paper and the place.
    pub source: &'static str,
    /// The claim in one sentence.
    pub text: &'static str,
    /// The figure claimed, or what stands for it.
    pub claimed: &'static str,
    /// What was measured.
    pub measured: Vec<Figure>,
    /// What follows.
    pub verdict: Finding,
}

/// What the papers claim: of each claim its name, what is claimed, where, and the sentence.
static CLAIMED: LazyLock<Vec<[String; 4]>> = LazyLock::new(|| {
    let table = csv::Reader::from_reader(include_str!("data/claims.csv").as_bytes());
    table.into_deserialize().collect::<Result<_, _>>().expect("a table of four columns")
});

impl Claim {
    /// What was measured of the claim of this name, which the table has.
    fn of(id: &str, measured: Vec<Figure>, verdict: Finding) -> Self {
        let row = CLAIMED.iter().find(|row| row[0] == id).expect("a claim of the table");
        let [id, claimed, source, text] = row.each_ref().map(String::as_str);
        Self { id, source, text, claimed, measured, verdict }
    }
}

/// A measured figure.
#[derive(Clone, Debug, Serialize)]
pub struct Figure {
    /// What it is: unique in its claim, without commas.
    pub name: &'static str,
    /// The value, in the unit.
    pub value: f64,
    /// The unit.
    pub unit: Unit,
}

/// The unit of a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Unit {
    /// Hundredths: of x^n for a relative error, of the lobe's peak for an absolute one.
    Percent,
    /// A ratio.
    Times,
    /// A number of things, exact.
    Count,
    /// A value of the lobe, whose peak is 1.
    Value,
    /// A signal-to-noise ratio.
    Decibel,
}

/// What the measurement says of a claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Finding {
    /// It is so.
    Holds,
    /// It is not.
    DoesNotHold,
    /// It is so under this condition.
    Only(String),
}

impl Finding {
    fn of(holds: bool) -> Self {
        if holds { Self::Holds } else { Self::DoesNotHold }
    }
}

impl std::fmt::Display for Finding {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Holds => f.write_str("holds"),
            Self::DoesNotHold => f.write_str("does not hold"),
            Self::Only(condition) => write!(f, "holds only {condition}"),
        }
    }
}

impl Serialize for Finding {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl Figure {
    /// The value to four significant digits, without the unit; a count is exact.
    #[must_use]
    pub fn digits(&self) -> String {
        if self.unit == Unit::Count { format!("{}", self.value) } else { significant(self.value) }
    }
}

impl std::fmt::Display for Figure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let unit = match self.unit {
            Unit::Percent => " %",
            Unit::Times => "x",
            Unit::Count | Unit::Value => "",
            Unit::Decibel => " dB",
        };
        write!(f, "{}{unit}", self.digits())
    }
}

/// Four significant digits, without an exponent.
fn significant(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let rounded: f64 = format!("{value:.3e}").parse().expect("its own digits");
    let exponent = libm::floor(libm::log10(rounded.abs())) as i32;
    format!("{rounded:.*}", usize::try_from(3 - exponent).unwrap_or(0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_significant_digits() {
        for (value, text) in [
            (0.0, "0"),
            (0.688_94, "0.6889"),
            (16.6449, "16.64"),
            (-0.003_071_4, "-0.003071"),
            (12_345.6, "12350"),
            (9.9999, "10.00"),
            (1000.0, "1000"),
        ] {
            assert_eq!(significant(value), text);
        }
    }
}
