//! `harris`: `2^(-n L(x))` from two tables that are not interpolated, after D. Harris, IEEE Trans. Computers 53(3),
//! 2004.

mod datapath;
mod lobe;
mod model;

use std::sync::Arc;

use super::{About, Inputs, Interface, Method, Options, Use, Variant, within};
use crate::datapath::Architecture;
use crate::fixed::wide::Wide;
use crate::platform::error::Error;

pub use lobe::Harris;

/// Address bits of the logarithm's table that are allowed, within an octave of the versine.
pub const LOG_BITS: std::ops::RangeInclusive<u32> = 2..=12;
/// Address bits of the exponential's table that are allowed.
pub const EXP_BITS: std::ops::RangeInclusive<u32> = 2..=14;

/// The method.
pub static METHODS: [About; 1] = [About {
    options: &["log_bits", "exp_bits"],
    computes_with_shininess: true,
    is_baseline: true,
    variants: &[
        Variant::new("", "", &[Use::Table, Use::Smallest]),
        Variant::new("small tables", "log_bits = 2\nexp_bits = 2", &[Use::Smallest]),
    ],
    ..About::new(
        "harris",
        "2^(-n L(x)) with L from one table and 2^-f from another, neither interpolated: one multiplication",
        "2^(-n L(x)), L and 2^-f from tables",
        |_, options| {
            let log_bits = within("log_bits", options.log_bits.unwrap_or(8), LOG_BITS)?;
            let exp_bits = within("exp_bits", options.exp_bits.unwrap_or(9), EXP_BITS)?;
            Ok(Arc::new(Configured { log_bits, exp_bits }))
        },
    )
}];

#[derive(Debug)]
struct Configured {
    log_bits: u32,
    exp_bits: u32,
}

impl Method for Configured {
    fn options(&self) -> Options {
        Options { log_bits: Some(self.log_bits), exp_bits: Some(self.exp_bits), ..Options::default() }
    }

    fn architecture<'a>(&'a self, interface: &'a Interface) -> Result<Box<dyn Architecture + 'a>, Error> {
        Ok(Box::new(datapath::Harris::new(interface, self.log_bits, self.exp_bits)?))
    }

    fn model(&self, inputs: &Inputs) -> Wide {
        model::harris(inputs, self.log_bits, self.exp_bits)
    }
}
