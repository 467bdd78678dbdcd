//! `power-2`, `power-4`, `power-8`: `max(0, 1 - u(A - a u))^k`, Lyon's shape with fitted coefficients.

use std::sync::Arc;

use super::{About, Coefficients, Inputs, Interface, Method, Options, Source, powers, rows};
use crate::datapath::Architecture;
use crate::fit::{self, Fit, Inside, Objective, Power};
use crate::fixed::wide::Wide;
use crate::platform::error::Error;

/// The method with each k.
pub static METHODS: [About; 3] = [
    about("power-2", "(1 - u(A - a u))^2 with fitted coefficients", "max(0, 1 - u(A - a u))^2", |about, options| {
        configured(about, options, 2)
    }),
    about("power-4", "(1 - u(A - a u))^4 with fitted coefficients", "max(0, 1 - u(A - a u))^4", |about, options| {
        configured(about, options, 4)
    }),
    about("power-8", "(1 - u(A - a u))^8 with fitted coefficients", "max(0, 1 - u(A - a u))^8", |about, options| {
        configured(about, options, 8)
    }),
];

const fn about(
    name: &'static str,
    help: &'static str,
    formula: &'static str,
    configure: fn(&'static About, &Options) -> Result<Arc<dyn Method>, Error>,
) -> About {
    About {
        name,
        help,
        formula,
        core_name: None,
        options: &["inside"],
        coefficients: &[Coefficients::Minimax],
        interpolates: true,
        computes_with_shininess: false,
        powers_of_two: false,
        is_baseline: false,
        configure,
    }
}

#[allow(clippy::unnecessary_wraps)]
fn configured(about: &'static About, options: &Options, k: u32) -> Result<Arc<dyn Method>, Error> {
    let (inside, objective) = (options.inside.unwrap_or(Inside::Quadratic), options.objective.unwrap_or_default());
    Ok(Arc::new(Configured { about, k, inside, objective }))
}

/// The best inside of `((1 - u (A - a u))⁺)^k` for the shininess `n`, with k = 2, 4 or 8.
///
/// The lobe is 0 from the first zero of the inside, or from its minimum if that comes first.
///
/// # Errors
/// As [`super::quadratic::fit`], and a `k` that is not 2, 4 or 8.
pub fn fit(n: f64, k: u32, inside: Inside, objective: &Objective) -> Result<Fit<Power>, Error> {
    if ![2, 4, 8].contains(&k) {
        return Err(Error::input(format!("power {k} is not supported"), "the power is 2, 4 or 8"));
    }
    fit::best(n, &fit::Family { cosine: false, power: k, hold: false }, inside, objective)
}

#[derive(Debug)]
struct Configured {
    about: &'static About,
    k: u32,
    inside: Inside,
    objective: Objective,
}

impl Method for Configured {
    fn about(&self) -> &'static About {
        self.about
    }

    fn options(&self) -> Options {
        Options { inside: Some(self.inside), ..Source::Fitted(self.objective).options() }
    }

    fn architecture<'a>(&'a self, interface: &'a Interface) -> Result<Box<dyn Architecture + 'a>, Error> {
        let rows = rows::each(interface, |n| Ok(fit(n, self.k, self.inside, &self.objective)?.coefficients))?;
        let linear = self.inside == Inside::Linear;
        Ok(Box::new(powers::datapath::Rom { interface, rows, linear, cosine: false, power: self.k }))
    }

    fn model(&self, inputs: &Inputs) -> Wide {
        powers::model::rom(inputs, self.k)
    }
}
