//! `cubic-rational`: the cubic up to the cusp and `x/(d + b u)` past it, of the papers of 2007 and 2021.

mod datapath;
mod fit;
mod lobe;
mod model;

use std::sync::Arc;

use super::divide::Divider;
use super::{About, Coefficients, Inputs, Interface, Method, Options, Source, cubic, rows};
use crate::datapath::Architecture;
use crate::fixed::wide::Wide;
use crate::platform::error::Error;

pub use fit::fit;
pub use lobe::CubicRational;

/// The method.
pub static METHODS: [About; 1] = [About {
    name: "cubic-rational",
    help: "The cubic up to the cusp, x/(d + b u) past it",
    formula: "x(1 - u(A - a u)) to the cusp, x/(d + b u) past it",
    core_name: None,
    options: &["q", "divider"],
    coefficients: &[Coefficients::Paper, Coefficients::Minimax],
    interpolates: false,
    computes_with_shininess: false,
    powers_of_two: false,
    is_baseline: false,
    configure: |about, options| {
        let q = options.q.unwrap_or(cubic::LEVEL);
        cubic::check_level(q)?;
        let divider = options.divider.unwrap_or(Divider::Digit);
        Ok(Arc::new(Configured { q, divider, source: options.source(about) }))
    },
}];

#[derive(Debug)]
struct Configured {
    q: f64,
    divider: Divider,
    source: Source,
}

impl Method for Configured {
    fn about(&self) -> &'static About {
        &METHODS[0]
    }

    fn options(&self) -> Options {
        let q = (self.source == Source::Paper).then_some(self.q);
        Options { q, divider: Some(self.divider), ..self.source.options() }
    }

    fn architecture<'a>(&'a self, interface: &'a Interface) -> Result<Box<dyn Architecture + 'a>, Error> {
        let lobes = rows::each(interface, |n| match self.source {
            Source::Paper => CubicRational::new(n, self.q),
            Source::Fitted(objective) => fit(n, &objective).map(|fit| fit.coefficients),
        })?;
        Ok(Box::new(datapath::Rational::new(interface, self.divider, self.q, lobes)))
    }

    fn model(&self, inputs: &Inputs) -> Wide {
        model::cubic_rational(inputs, self.divider)
    }
}
