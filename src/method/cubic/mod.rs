//! `cubic`: `x(1 - u(A - a u))`, of the papers of 2007 and 2021.

pub(super) mod datapath;
mod lobe;
pub(super) mod model;

use std::sync::Arc;

use clap::ValueEnum;
use serde::{Deserialize, Serialize};

use super::{About, Coefficients, Form, Inputs, Interface, Method, Options, Source, Use, Variant};
use crate::datapath::Architecture;
use crate::fit::{self, Fit, Inside, Objective};
use crate::fixed::Width;
use crate::fixed::wide::Wide;
use crate::platform::error::Error;

pub use lobe::Cubic;
pub(super) use lobe::{check_level, integral};

/// The level Q unless another is given.
pub(super) const LEVEL: f64 = 0.5;

/// What the cubic is past its minimum, where the polynomial rises again.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Tail {
    /// 0.
    Cut,
    /// The minimum's value, down to the cosine 0.
    Hold,
}

/// The method.
pub static METHODS: [About; 1] = [About {
    options: &["form", "q", "tail"],
    coefficients: &[Coefficients::Paper, Coefficients::Minimax],
    interpolates: true,
    variants: &[
        Variant::new("", "", &[Use::Table, Use::Exactness, Use::Bench]),
        Variant::new("Q = 0.6", "q = 0.6", &[Use::Table]),
        Variant::new("minimax", "coefficients = 'minimax'", &[Use::Table]),
        Variant::new("minimax max-abs:0.5", "coefficients = 'minimax'\nobjective = 'max-abs:0.5'", &[Use::Table]),
        Variant::new("minimax max-rel:0.5", "coefficients = 'minimax'\nobjective = 'max-rel:0.5'", &[Use::Exactness]),
        Variant::new("paper form", "form = 'paper'", &[Use::Table, Use::Exactness]),
        Variant::new("held tail", "tail = 'hold'", &[Use::Table, Use::Exactness]),
        Variant::new("held tail, minimax", "tail = 'hold'\ncoefficients = 'minimax'", &[Use::Table, Use::Exactness]),
        Variant::new("in_n with 3 fraction bits", "shininess_fraction = 3", &[Use::Table]),
    ],
    ..About::new("cubic", "x(1 - u(A - a u)); past its minimum cut to 0 or held", FORMULA, |about, options| {
        let q = options.level(LEVEL)?;
        let (form, tail) = (options.form.unwrap_or(Form::Stable), options.tail.unwrap_or(Tail::Cut));
        Ok(Arc::new(Configured { form, tail, q, source: options.source(about) }))
    })
}];

/// The formula of the cubic lobes.
pub(super) const FORMULA: &str = "x(1 - u(A - a u))";

/// The best cubic `x (1 - u (A - a u))` with the given tail for the shininess `n`.
///
/// # Errors
/// As [`super::quadratic::fit`].
pub fn fit(n: f64, tail: Tail, objective: &Objective) -> Result<Fit<Cubic>, Error> {
    let shape = fit::Family { cosine: true, power: 1, hold: tail == Tail::Hold };
    Ok(fit::best(n, &shape, Inside::Quadratic, objective)?.map(|fit| Cubic { a: fit.a, big_a: fit.big_a }))
}

/// The width of the cosine's cube, as printed.
const H: Width = Width("h");

#[derive(Debug)]
struct Configured {
    form: Form,
    tail: Tail,
    q: f64,
    source: Source,
}

impl Method for Configured {
    fn options(&self) -> Options {
        Options { form: Some(self.form), q: self.source.level(self.q), tail: Some(self.tail), ..self.source.options() }
    }

    fn check(&self, interface: &Interface) -> Result<(), Error> {
        self.form.check(interface)
    }

    fn architecture<'a>(&'a self, interface: &'a Interface) -> Result<Box<dyn Architecture + 'a>, Error> {
        let (q, tail) = (self.q, self.tail);
        let fitted = |n, objective: &Objective| fit(n, tail, objective);
        let lobes = self.source.rows(interface, |n| Cubic::new(n, q), fitted)?;
        Ok(match self.form {
            Form::Stable => Box::new(datapath::Stable::new(interface, self.tail, lobes)),
            Form::Paper => Box::new(datapath::Paper { interface, lobes }),
        })
    }

    fn model(&self, inputs: &Inputs) -> Wide {
        match self.form {
            Form::Stable => model::stable(inputs),
            Form::Paper => model::paper(inputs),
        }
    }
}
