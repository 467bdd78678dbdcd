//! `table`: `x^n` from one table by n and the leading bits of the versine.

mod datapath;
mod lobe;
mod model;

use std::sync::Arc;

use super::{About, Inputs, Interface, Method, Options, Use, Variant, within};
use crate::datapath::Architecture;
use crate::fixed::wide::Wide;
use crate::platform::error::Error;

pub use lobe::Tabulated;

/// Address bits of the versine that are allowed.
pub const TABLE_BITS: std::ops::RangeInclusive<u32> = 2..=14;

/// The method.
pub static METHODS: [About; 1] = [About {
    // `table` is a word of Verilog.
    core_name: Some("lookup_table"),
    options: &["table_bits"],
    is_baseline: true,
    variants: &[Variant::new("", "", &[Use::Smallest]), Variant::new("small", "table_bits = 2", &[Use::Smallest])],
    ..About::new(
        "table",
        "x^n from one table by n and the leading bits of the versine",
        "x^n from a table",
        |_, options| {
            let table_bits = within("table_bits", options.table_bits.unwrap_or(7), TABLE_BITS)?;
            Ok(Arc::new(Configured { table_bits }))
        },
    )
}];

#[derive(Debug)]
struct Configured {
    table_bits: u32,
}

impl Method for Configured {
    fn options(&self) -> Options {
        Options { table_bits: Some(self.table_bits), ..Options::default() }
    }

    fn architecture<'a>(&'a self, interface: &'a Interface) -> Result<Box<dyn Architecture + 'a>, Error> {
        Ok(Box::new(datapath::Tabulated::new(interface, self.table_bits)?))
    }

    fn model(&self, inputs: &Inputs) -> Wide {
        model::tabulated(inputs, self.table_bits)
    }
}
