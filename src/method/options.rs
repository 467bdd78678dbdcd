//! The options of the methods as a spec writes them.

use clap::ValueEnum;
use serde::{Deserialize, Serialize};

use super::cubic::{Tail, check_level};
use super::divide::Divider;
use super::log_exp::Memory;
use super::{About, Interface};
use crate::fit::{Inside, Objective};
use crate::platform::error::Error;

/// How the polynomial is evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Form {
    /// In the versine, scaled per shininess: narrow and well conditioned.
    Stable,
    /// In powers of the cosine, as the papers print it.
    Paper,
}

impl Form {
    /// Refuses shininesses between which the form does not interpolate.
    pub(super) fn check(self, interface: &Interface) -> Result<(), Error> {
        if self == Self::Stable || interface.shininess.frac_bits() == 0 {
            return Ok(());
        }
        Err(Error::input(
            "the paper form takes no shininess between the integers of a range",
            "leave shininess_fraction out, or use --form stable, which interpolates its coefficients",
        ))
    }
}

/// Where the coefficients come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Coefficients {
    /// The papers' closed forms.
    Paper,
    /// Fitted to x^n for the least of an objective, then to the ROM words.
    Minimax,
}

/// Where a method's coefficients come from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Source {
    /// The papers' closed forms.
    Paper,
    /// They make this objective least.
    Fitted(Objective),
}

impl Source {
    /// The level q, which only the papers' coefficients depend on.
    pub(super) fn level(self, q: f64) -> Option<f64> {
        (self == Self::Paper).then_some(q)
    }

    /// The options that say so.
    #[must_use]
    pub fn options(self) -> Options {
        let (coefficients, objective) = match self {
            Self::Paper => (Coefficients::Paper, None),
            Self::Fitted(objective) => (Coefficients::Minimax, Some(objective)),
        };
        Options { coefficients: Some(coefficients), objective, ..Options::default() }
    }
}

/// The options of all methods, each by the key of a spec.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Options {
    /// How the polynomial is evaluated; every method has the stable form.
    pub form: Option<Form>,
    /// Where the coefficients come from.
    pub coefficients: Option<Coefficients>,
    /// What fitted coefficients make least.
    pub objective: Option<Objective>,
    /// The level Q of the cubic's point of contact.
    pub q: Option<f64>,
    /// The level G of the three-point cubic's second point.
    pub g: Option<f64>,
    /// What the cubic is past its minimum.
    pub tail: Option<Tail>,
    /// The polynomial inside a power.
    pub inside: Option<Inside>,
    /// A of a core that is only as accurate as `2^-A`; `None`: below one ulp of the output.
    pub accuracy: Option<u32>,
    /// Where the tables of such a core are meant to lie.
    pub memory: Option<Memory>,
    /// How the core divides.
    pub divider: Option<Divider>,
    /// Address bits of the versine in the method table.
    pub table_bits: Option<u32>,
    /// Address bits of the logarithm's table in the method harris, within an octave of the versine.
    pub log_bits: Option<u32>,
    /// Address bits of the exponential's table in the method harris.
    pub exp_bits: Option<u32>,
}

impl Options {
    /// Refuses an option that the method does not have: a mistake, not something to pass over.
    pub(super) fn check(&self, about: &About) -> Result<(), Error> {
        let paper_form = self.form == Some(Form::Paper);
        for (key, what, given) in [
            ("form", "paper form", paper_form),
            ("q", "level q", self.q.is_some()),
            ("g", "level g", self.g.is_some()),
            ("tail", "choice of tail", self.tail.is_some()),
            ("inside", "choice of inside", self.inside.is_some()),
            ("accuracy", "accuracy", self.accuracy.is_some()),
            ("divider", "divider", self.divider.is_some()),
            ("table_bits", "table_bits", self.table_bits.is_some()),
            ("log_bits", "log_bits", self.log_bits.is_some()),
            ("exp_bits", "exp_bits", self.exp_bits.is_some()),
        ] {
            refuse(about, what, given && !about.has(key))?;
        }
        refuse(about, "choice of memory without an accuracy", self.memory.is_some() && self.accuracy.is_none())?;
        let coefficients = match (self.coefficients, about.coefficients) {
            (None, allowed) => allowed.first().copied().unwrap_or(Coefficients::Paper),
            (Some(wanted), allowed) if allowed.contains(&wanted) => wanted,
            (Some(wanted), allowed) => {
                let allowed: Vec<String> = allowed.iter().map(word).collect();
                return Err(Error::input(
                    format!("the method {} has no {} coefficients", about.name, word(&wanted)),
                    if allowed.is_empty() { "it has no coefficients".to_owned() } else { allowed.join(", ") },
                ));
            }
        };
        let fitted = coefficients == Coefficients::Minimax && !about.coefficients.is_empty();
        refuse(about, "level q with fitted coefficients", self.q.is_some() && fitted)?;
        refuse(about, "objective without fitted coefficients", self.objective.is_some() && !fitted)?;
        self.objective.unwrap_or_default().check()?;
        if paper_form && fitted {
            return Err(Error::input("the paper form has the paper's coefficients", "use --form stable with minimax"));
        }
        Ok(())
    }

    /// The level q, or the one that it is unless given; in range.
    pub(super) fn level(&self, default: f64) -> Result<f64, Error> {
        let q = self.q.unwrap_or(default);
        check_level(q).map(|()| q)
    }

    /// Where the coefficients of a method come from that has any.
    #[must_use]
    pub fn source(&self, about: &About) -> Source {
        match self.coefficients.or(about.coefficients.first().copied()) {
            Some(Coefficients::Minimax) => Source::Fitted(self.objective.unwrap_or_default()),
            _ => Source::Paper,
        }
    }
}

fn refuse(about: &About, what: &str, given: bool) -> Result<(), Error> {
    if !given {
        return Ok(());
    }
    Err(Error::input(format!("the method {} has no {what}", about.name), format!("leave {what} out")))
}

/// The word that a value is written with, on the command line as in TOML.
pub(crate) fn word<T: ValueEnum>(value: &T) -> String {
    value.to_possible_value().map(|value| value.get_name().to_owned()).unwrap_or_default()
}

/// A whole number that is in its range; `what` it is.
pub(crate) fn within(what: &str, value: u32, allowed: std::ops::RangeInclusive<u32>) -> Result<u32, Error> {
    if allowed.contains(&value) {
        return Ok(value);
    }
    Err(Error::input(
        format!("{what} = {value} is out of range"),
        format!("{what} is a whole number from {} to {}", allowed.start(), allowed.end()),
    ))
}
