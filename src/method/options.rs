//! The options of the methods as a spec writes them.

use clap::ValueEnum;
use serde::{Deserialize, Serialize};

use super::cubic::{Tail, check_level};
use super::divide::Divider;
use super::keys::{Fields, keys};
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

/// Hands the keys of the methods' options to the macro of another table, between the keys before and after them there.
macro_rules! method_keys {
    ($table:ident! { $($before:tt)* } $({ $($after:tt)* })?) => {
        $table! {
            $($before)*

            /// How the polynomial is evaluated [default: stable]
            form: Form where "all; the paper form: `quadratic`, `cubic`",

            /// Where the coefficients come from [default: paper, and minimax where no paper gives any]
            coefficients: Coefficients,

            /// What fitted coefficients make least: max-abs, max-abs:LEVEL or max-rel:LEVEL (where x^n is at least
            /// LEVEL), or weighted:POWER (errors times a power of x^n) [default: max-abs]
            objective: Objective where "fitted coefficients",

            /// Level of the cubic's point of contact, 0.05 to 0.95 [default: 0.5]
            q: f64 as "level q",

            /// Level of the three-point cubic's second point, above 0 and below q [default: 1/18]
            g: f64 as "level g",

            /// What the cubic is past its minimum [default: cut]
            tail: Tail as "choice of tail",

            /// The polynomial inside a power [default: quadratic]
            inside: Inside as "choice of inside",

            /// Bits A of the method log-exp: a core smaller than the faithful one, proved within 2^-A of x^n, 3 to 15
            /// and at most G - 1
            #[arg(value_name = "A")]
            accuracy: u32 as "accuracy",

            /// Where the tables of a core with an accuracy are meant to lie: they are sized for it [default: auto]
            memory: Memory where "cores with an accuracy",

            /// How the core divides [default: digit]
            divider: Divider as "divider",

            /// Address bits of the versine in the method table: each shininess has 2^BITS entries, 2 to 14 [default: 7]
            #[arg(value_name = "BITS")]
            table_bits: u32 as "table_bits",

            /// Address bits of the logarithm's table in the method harris, within an octave of the versine, 2 to 12
            /// [default: 8]
            #[arg(value_name = "BITS")]
            log_bits: u32 as "log_bits",

            /// Address bits of the exponential's table in the method harris, 2 to 14 [default: 9]
            #[arg(value_name = "BITS")]
            exp_bits: u32 as "exp_bits",

            $($($after)*)?
        }
    };
}
pub(crate) use method_keys;

method_keys! { keys! {
    /// The options of all methods, each by the key of a spec.
    Options:
} }

impl Options {
    /// Refuses an option that the method does not have: a mistake, not something to pass over.
    pub(super) fn check(&self, about: &About) -> Result<(), Error> {
        let paper_form = self.form == Some(Form::Paper);
        refuse(about, "paper form", paper_form && !about.has("form"))?;
        for (key, value) in self.values() {
            refuse(about, key.called, value.is_some() && !key.called.is_empty() && !about.has(key.name))?;
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
