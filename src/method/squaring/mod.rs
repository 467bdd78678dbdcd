//! `squaring`: `x^n` by repeated squaring, for shininesses that are powers of two.

mod datapath;
mod model;

use std::sync::Arc;

use super::{About, Inputs, Interface, Method, Use, Variant};
use crate::datapath::Architecture;
use crate::fixed::wide::Wide;
use crate::platform::error::Error;

/// The method.
pub static METHODS: [About; 1] = [About {
    powers_of_two: true,
    is_baseline: true,
    variants: &[Variant::new("", "", &[Use::Smallest])],
    ..About::new(
        "squaring",
        "x squared log2 n times, for shininesses that are powers of two",
        "x^n by log2 n squarings",
        |_, _| Ok(Arc::new(Configured)),
    )
}];

#[derive(Debug)]
struct Configured;

impl Method for Configured {
    fn architecture<'a>(&'a self, interface: &'a Interface) -> Result<Box<dyn Architecture + 'a>, Error> {
        Ok(Box::new(datapath::Squaring::new(interface)?))
    }

    fn model(&self, inputs: &Inputs) -> Wide {
        model::squaring(inputs)
    }
}
