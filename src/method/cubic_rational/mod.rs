//! `cubic-rational`: the cubic up to the cusp and `x/(d + b u)` past it, of the papers of 2007 and 2021.

mod datapath;
mod fit;
mod lobe;
mod model;

use std::sync::Arc;

use super::divide::Divider;
use super::{About, Coefficients, Inputs, Interface, Method, Options, Source, Use, Variant, cubic};
use crate::datapath::Architecture;
use crate::fixed::wide::Wide;
use crate::platform::error::Error;

pub use fit::fit;
pub use lobe::CubicRational;

/// The method.
pub static METHODS: [About; 1] = [About {
    options: &["q", "divider"],
    coefficients: &[Coefficients::Paper, Coefficients::Minimax],
    variants: &[
        Variant::new("digit", "divider = 'digit'", &[Use::Table, Use::Smallest, Use::Bench]),
        Variant::new("reciprocal", "divider = 'reciprocal'", &[Use::Table, Use::Smallest]),
    ],
    ..About::new(
        "cubic-rational",
        "The cubic up to the cusp, x/(d + b u) past it",
        "x(1 - u(A - a u)) to the cusp, x/(d + b u) past it",
        |about, options| {
            let q = options.level(cubic::LEVEL)?;
            let divider = options.divider.unwrap_or(Divider::Digit);
            Ok(Arc::new(Configured { q, divider, source: options.source(about) }))
        },
    )
}];

#[derive(Debug)]
struct Configured {
    q: f64,
    divider: Divider,
    source: Source,
}

impl Method for Configured {
    fn options(&self) -> Options {
        Options { q: self.source.level(self.q), divider: Some(self.divider), ..self.source.options() }
    }

    fn architecture<'a>(&'a self, interface: &'a Interface) -> Result<Box<dyn Architecture + 'a>, Error> {
        let lobes = self.source.rows(interface, |n| CubicRational::new(n, self.q), fit)?;
        Ok(Box::new(datapath::Rational::new(interface, self.divider, self.q, lobes)))
    }

    fn model(&self, inputs: &Inputs) -> Wide {
        model::cubic_rational(inputs, self.divider)
    }
}
