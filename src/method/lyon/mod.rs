//! `lyon-2`, `lyon-4`, `lyon-8`: `max(0, 1 - n u/k)^k`, of R. F. Lyon, Apple Technical Report 43, 1993.

mod lobe;

use std::sync::Arc;

use super::{About, Configure, Inputs, Interface, Method, Use, Variant, powers, rows};
use crate::datapath::Architecture;
use crate::fit::Power;
use crate::fixed::wide::Wide;
use crate::platform::error::Error;

pub use lobe::Lyon;
pub(crate) use lobe::{check_outer_power, squarings};

/// The method with each k.
pub static METHODS: [About; 3] = [
    about("lyon-2", "(1 - n u/2)^2, 0 past its zero", "max(0, 1 - n u/2)^2", |_, _| Ok(Arc::new(Configured { k: 2 }))),
    about("lyon-4", "(1 - n u/4)^4, 0 past its zero", "max(0, 1 - n u/4)^4", |_, _| Ok(Arc::new(Configured { k: 4 }))),
    about("lyon-8", "(1 - n u/8)^8, 0 past its zero", "max(0, 1 - n u/8)^8", |_, _| Ok(Arc::new(Configured { k: 8 }))),
];

const VARIANTS: [Variant; 1] = [Variant::new("", "", &[Use::Table, Use::Exactness])];

const fn about(name: &'static str, help: &'static str, formula: &'static str, configure: Configure) -> About {
    About {
        computes_with_shininess: true,
        is_baseline: true,
        variants: &VARIANTS,
        ..About::new(name, help, formula, configure)
    }
}

#[derive(Debug)]
struct Configured {
    k: u32,
}

impl Method for Configured {
    fn architecture<'a>(&'a self, interface: &'a Interface) -> Result<Box<dyn Architecture + 'a>, Error> {
        if interface.shininess.is_at_port() {
            return Ok(Box::new(powers::datapath::Port { interface, power: self.k }));
        }
        let rows = rows::each(interface, |n| Ok(Power { big_a: n / f64::from(self.k), a: 0.0 }))?;
        Ok(Box::new(powers::datapath::Rom { interface, rows, linear: true, cosine: false, power: self.k }))
    }

    fn model(&self, inputs: &Inputs) -> Wide {
        powers::model::lyon(inputs, self.k)
    }
}
