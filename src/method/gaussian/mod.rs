//! `gaussian`: `e^(-n u)`, the spherical Gaussian of renderers (J. Wang et al., "All-Frequency Rendering of Dynamic,
//! Spatially-Varying Reflectance", ACM Trans. Graphics 28(5), 2009), which is off from x^n by 0.27/n at most for a
//! large n.

mod datapath;
mod lobe;
mod model;

use std::sync::Arc;

use super::{About, Inputs, Interface, Method, Use, Variant};
use crate::datapath::Architecture;
use crate::fixed::wide::Wide;
use crate::platform::error::Error;

pub use lobe::Gaussian;

/// The method.
pub static METHODS: [About; 1] = [About {
    computes_with_shininess: true,
    is_baseline: true,
    variants: &[Variant::new("", "", &[Use::Table, Use::Exactness])],
    ..About::new("gaussian", "e^(-n u), the spherical Gaussian, from one small table", "e^(-n u)", |_, _| {
        Ok(Arc::new(Configured))
    })
}];

#[derive(Debug)]
struct Configured;

impl Method for Configured {
    fn architecture<'a>(&'a self, interface: &'a Interface) -> Result<Box<dyn Architecture + 'a>, Error> {
        Ok(Box::new(datapath::Exponential::new(interface)?))
    }

    fn model(&self, inputs: &Inputs) -> Wide {
        model::gaussian(inputs)
    }
}
