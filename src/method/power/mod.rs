//! `power-2`, `power-4`, `power-8`: `max(0, 1 - u(A - a u))^k`, Lyon's shape with fitted coefficients.

use std::sync::Arc;

use super::{About, Coefficients, Configure, Inputs, Interface, Method, Options, Source, Use, Variant, powers, rows};
use crate::datapath::Architecture;
use crate::fit::{self, Fit, Inside, Objective, Power};
use crate::fixed::wide::Wide;
use crate::platform::error::Error;

/// The method with each k.
pub static METHODS: [About; 3] = [
    about(
        "power-2",
        "(1 - u(A - a u))^2 with fitted coefficients",
        "max(0, 1 - u(A - a u))^2",
        &VARIANTS_2,
        |_, options| Ok(configured(options, 2)),
    ),
    about(
        "power-4",
        "(1 - u(A - a u))^4 with fitted coefficients",
        "max(0, 1 - u(A - a u))^4",
        &VARIANTS_4,
        |_, options| Ok(configured(options, 4)),
    ),
    about(
        "power-8",
        "(1 - u(A - a u))^8 with fitted coefficients",
        "max(0, 1 - u(A - a u))^8",
        &VARIANTS_8,
        |_, options| Ok(configured(options, 8)),
    ),
];

const VARIANTS_2: [Variant; 3] = [
    Variant::new("quadratic", "", &[Use::Table, Use::Exactness]),
    Variant::new("linear", "inside = 'linear'", &[Use::Table]),
    Variant::new("linear, max-abs:0.1", "inside = 'linear'\nobjective = 'max-abs:0.1'", &[Use::Exactness]),
];

const VARIANTS_4: [Variant; 4] = [
    Variant::new("quadratic", "", &[Use::Table, Use::Bench]),
    Variant::new("quadratic, weighted:0.5", "objective = 'weighted:0.5'", &[Use::Exactness]),
    Variant::new("linear", "inside = 'linear'", &[Use::Table, Use::Exactness]),
    Variant::new("in_n with 3 fraction bits", "shininess_fraction = 3", &[Use::Table]),
];

const VARIANTS_8: [Variant; 2] = [
    Variant::new("quadratic", "", &[Use::Table, Use::Exactness]),
    Variant::new("linear", "inside = 'linear'", &[Use::Table, Use::Exactness]),
];

const fn about(
    name: &'static str,
    help: &'static str,
    formula: &'static str,
    variants: &'static [Variant],
    configure: Configure,
) -> About {
    About {
        options: &["inside"],
        coefficients: &[Coefficients::Minimax],
        interpolates: true,
        variants,
        ..About::new(name, help, formula, configure)
    }
}

fn configured(options: &Options, k: u32) -> Arc<dyn Method> {
    let (inside, objective) = (options.inside.unwrap_or(Inside::Quadratic), options.objective.unwrap_or_default());
    Arc::new(Configured { k, inside, objective })
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
    k: u32,
    inside: Inside,
    objective: Objective,
}

impl Method for Configured {
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
