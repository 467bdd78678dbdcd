//! `cubic-three-point`: the cubic's shape through two points of the lobe, of the paper of 2021.

mod lobe;

use std::sync::Arc;

use super::cubic::{self, Cubic, Tail};
use super::{About, Coefficients, Inputs, Interface, Method, Options, Source, Use, Variant};
use crate::datapath::Architecture;
use crate::fit::Objective;
use crate::fixed::wide::Wide;
use crate::platform::error::Error;

/// The method.
pub static METHODS: [About; 1] = [About {
    options: &["q", "g", "tail"],
    coefficients: &[Coefficients::Paper, Coefficients::Minimax],
    variants: &[
        Variant::new("", "", &[Use::Table, Use::Exactness]),
        Variant::new("held tail", "tail = 'hold'", &[Use::Table, Use::Exactness]),
    ],
    ..About::new(
        "cubic-three-point",
        "The cubic's shape through two points of the lobe",
        cubic::FORMULA,
        |about, options| {
            let (q, g) = (options.level(Cubic::THREE_POINT_Q)?, options.g.unwrap_or(Cubic::THREE_POINT_G));
            if !(0.001..q).contains(&g) {
                return Err(Error::input(
                    format!("level g = {g} is out of range"),
                    "g is the lobe's value at the three-point cubic's second point, from 0.001 up to below q",
                ));
            }
            Ok(Arc::new(Configured { tail: options.tail.unwrap_or(Tail::Cut), q, g, source: options.source(about) }))
        },
    )
}];

#[derive(Debug)]
struct Configured {
    tail: Tail,
    q: f64,
    g: f64,
    source: Source,
}

impl Method for Configured {
    fn options(&self) -> Options {
        Options { q: self.source.level(self.q), g: Some(self.g), tail: Some(self.tail), ..self.source.options() }
    }

    fn architecture<'a>(&'a self, interface: &'a Interface) -> Result<Box<dyn Architecture + 'a>, Error> {
        let (q, g, tail) = (self.q, self.g, self.tail);
        let fitted = |n, objective: &Objective| cubic::fit(n, tail, objective);
        let lobes = self.source.rows(interface, |n| Cubic::three_point(n, q, g), fitted)?;
        Ok(Box::new(cubic::datapath::Stable::new(interface, self.tail, lobes)))
    }

    fn model(&self, inputs: &Inputs) -> Wide {
        cubic::model::stable(inputs)
    }
}
