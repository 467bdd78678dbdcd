//! `quadratic`: `max(0, x(1 - a u))`, of "Quadratic approximation of BRDF".

mod datapath;
mod lobe;
mod model;

use std::sync::Arc;

use super::{About, Coefficients, Form, Inputs, Interface, Method, Options, Source, Use, Variant};
use crate::datapath::Architecture;
use crate::fit::{self, Fit, Inside, Objective};
use crate::fixed::wide::Wide;
use crate::platform::error::Error;

pub use lobe::Quadratic;

/// The method.
pub static METHODS: [About; 1] = [About {
    options: &["form"],
    coefficients: &[Coefficients::Paper, Coefficients::Minimax],
    interpolates: true,
    variants: &[
        Variant::new("", "", &[Use::Table, Use::Exactness, Use::Bench]),
        Variant::new("minimax", "coefficients = 'minimax'", &[Use::Table, Use::Exactness]),
        Variant::new("paper form", "form = 'paper'", &[Use::Table, Use::Exactness]),
        Variant::new("in_n with 3 fraction bits", "shininess_fraction = 3", &[Use::Table]),
    ],
    ..About::new("quadratic", "x(1 - a u), clamped at 0", "max(0, x(1 - a u))", |about, options| {
        Ok(Arc::new(Configured { form: options.form.unwrap_or(Form::Stable), source: options.source(about) }))
    })
}];

/// The best `(x (1 - a u))⁺` for the shininess `n`.
///
/// # Errors
/// A shininess outside 1..=2^20, or an objective with a level or a power out of its range.
pub fn fit(n: f64, objective: &Objective) -> Result<Fit<Quadratic>, Error> {
    let shape = fit::Family { cosine: true, power: 1, hold: false };
    Ok(fit::best(n, &shape, Inside::Linear, objective)?.map(|fit| Quadratic { a: fit.big_a }))
}

#[derive(Debug)]
struct Configured {
    form: Form,
    source: Source,
}

impl Method for Configured {
    fn options(&self) -> Options {
        Options { form: Some(self.form), ..self.source.options() }
    }

    fn check(&self, interface: &Interface) -> Result<(), Error> {
        self.form.check(interface)
    }

    fn architecture<'a>(&'a self, interface: &'a Interface) -> Result<Box<dyn Architecture + 'a>, Error> {
        let lobes = self.source.rows(interface, Quadratic::new, fit)?;
        Ok(match self.form {
            Form::Stable => Box::new(datapath::Stable { interface, lobes }),
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
