//! `cubic-three-point`: the cubic's shape through two points of the lobe, of the paper of 2021.

mod lobe;

use std::sync::Arc;

use super::cubic::{self, Cubic, Tail};
use super::{About, Coefficients, Inputs, Interface, Method, Options, Source, rows};
use crate::datapath::Architecture;
use crate::fixed::wide::Wide;
use crate::platform::error::Error;

/// The method.
pub static METHODS: [About; 1] = [About {
    name: "cubic-three-point",
    help: "The cubic's shape through two points of the lobe",
    formula: cubic::FORMULA,
    core_name: None,
    options: &["q", "g", "tail"],
    coefficients: &[Coefficients::Paper, Coefficients::Minimax],
    interpolates: false,
    computes_with_shininess: false,
    powers_of_two: false,
    is_baseline: false,
    configure: |about, options| {
        let (q, g) = (options.q.unwrap_or(Cubic::THREE_POINT_Q), options.g.unwrap_or(Cubic::THREE_POINT_G));
        cubic::check_level(q)?;
        if !(0.001..q).contains(&g) {
            return Err(Error::input(
                format!("level g = {g} is out of range"),
                "g is the lobe's value at the three-point cubic's second point, from 0.001 up to below q",
            ));
        }
        Ok(Arc::new(Configured { tail: options.tail.unwrap_or(Tail::Cut), q, g, source: options.source(about) }))
    },
}];

#[derive(Debug)]
struct Configured {
    tail: Tail,
    q: f64,
    g: f64,
    source: Source,
}

impl Method for Configured {
    fn about(&self) -> &'static About {
        &METHODS[0]
    }

    fn options(&self) -> Options {
        let q = (self.source == Source::Paper).then_some(self.q);
        Options { q, g: Some(self.g), tail: Some(self.tail), ..self.source.options() }
    }

    fn architecture<'a>(&'a self, interface: &'a Interface) -> Result<Box<dyn Architecture + 'a>, Error> {
        let lobes = rows::each(interface, |n| match self.source {
            Source::Paper => Cubic::three_point(n, self.q, self.g),
            Source::Fitted(objective) => cubic::fit(n, self.tail, &objective).map(|fit| fit.coefficients),
        })?;
        Ok(Box::new(cubic::datapath::Stable::new(interface, self.tail, lobes)))
    }

    fn model(&self, inputs: &Inputs) -> Wide {
        cubic::model::stable(inputs)
    }
}
