//! `cubic-min-zero`: `x max(0, 1 - K u)^2`, the cubic whose minimum is zero, of the paper of 2021.

mod lobe;

use std::sync::Arc;

use super::{About, Coefficients, Inputs, Interface, Method, Options, Source, Use, Variant, cubic, powers};
use crate::datapath::Architecture;
use crate::fit::{self, Fit, Inside, Objective, Power};
use crate::fixed::wide::Wide;
use crate::platform::error::Error;

pub use lobe::MinZero;

/// The method.
pub static METHODS: [About; 1] = [About {
    options: &["q"],
    coefficients: &[Coefficients::Paper, Coefficients::Minimax],
    interpolates: true,
    variants: &[
        Variant::new("", "", &[Use::Table, Use::Exactness]),
        Variant::new("minimax", "coefficients = 'minimax'", &[Use::Table, Use::Exactness]),
    ],
    ..About::new("cubic-min-zero", "x(1 - K u)^2, 0 past its zero", "x max(0, 1 - K u)^2", |about, options| {
        let q = options.level(cubic::LEVEL)?;
        Ok(Arc::new(Configured { q, source: options.source(about) }))
    })
}];

/// The best K of the cubic `x ((1 - K u)⁺)^2` for the shininess `n`: 0 for n = 1, about 0.45 n.
///
/// # Errors
/// As [`super::quadratic::fit`].
pub fn fit(n: f64, objective: &Objective) -> Result<Fit<f64>, Error> {
    let shape = fit::Family { cosine: true, power: 2, hold: false };
    Ok(fit::best(n, &shape, Inside::Linear, objective)?.map(|fit| fit.big_a))
}

#[derive(Debug)]
struct Configured {
    q: f64,
    source: Source,
}

impl Method for Configured {
    fn options(&self) -> Options {
        Options { q: self.source.level(self.q), ..self.source.options() }
    }

    fn architecture<'a>(&'a self, interface: &'a Interface) -> Result<Box<dyn Architecture + 'a>, Error> {
        let ks = self.source.rows(interface, |n| Ok(MinZero::new(n, self.q)?.k), fit)?;
        let rows = ks.into_iter().map(|k| Power { big_a: k, a: 0.0 }).collect();
        Ok(Box::new(powers::datapath::Rom { interface, rows, linear: true, cosine: true, power: 2 }))
    }

    fn model(&self, inputs: &Inputs) -> Wide {
        powers::model::min_zero(inputs)
    }
}
