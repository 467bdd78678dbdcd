//! `schlick`: `x/(1 + (n-1)u)`, of C. Schlick, Graphics Gems IV, 1994: the comparator of all three papers.

mod datapath;
mod lobe;
mod model;

use std::sync::Arc;

use super::divide::Divider;
use super::{About, Inputs, Interface, Method, Options, Use, Variant};
use crate::datapath::Architecture;
use crate::fixed::wide::Wide;
use crate::platform::error::Error;

pub use lobe::Schlick;

/// The method.
pub static METHODS: [About; 1] = [About {
    options: &["divider"],
    computes_with_shininess: true,
    is_baseline: true,
    variants: &[
        Variant::new("digit", "divider = 'digit'", &[Use::Table, Use::Smallest, Use::Bench]),
        Variant::new("reciprocal", "divider = 'reciprocal'", &[Use::Table, Use::Smallest]),
    ],
    ..About::new("schlick", "x/(1 + (n-1)u)", "x/(1 + (n-1)u)", |_, options| {
        Ok(Arc::new(Configured { divider: options.divider.unwrap_or(Divider::Digit) }))
    })
}];

#[derive(Debug)]
struct Configured {
    divider: Divider,
}

impl Method for Configured {
    fn options(&self) -> Options {
        Options { divider: Some(self.divider), ..Options::default() }
    }

    fn architecture<'a>(&'a self, interface: &'a Interface) -> Result<Box<dyn Architecture + 'a>, Error> {
        Ok(Box::new(datapath::Schlick::new(interface, self.divider)?))
    }

    fn model(&self, inputs: &Inputs) -> Wide {
        model::schlick(inputs, self.divider)
    }
}
