//! `segmented-2`, `segmented-4`, `segmented-8`: `x(c - u(A - a u))` by segments of `n u`: the cubic's datapath, a row
//! per segment.

mod datapath;
mod lobe;
mod model;

use std::sync::Arc;

use super::{About, Coefficients, Configure, Inputs, Interface, Method, Options, Source, Use, Variant};
use crate::datapath::Architecture;
use crate::fit::Objective;
use crate::fixed::wide::Wide;
use crate::platform::error::Error;

pub use lobe::Segmented;

/// The method with each number of segments.
pub static METHODS: [About; 3] = [
    about("segmented-2", "x(c - u(A - a u)) in 2 segments", &[FITTED], |_, options| Ok(configured(options, 2))),
    about("segmented-4", "x(c - u(A - a u)) in 4 segments", &[TIMED, WEIGHTED], |_, options| {
        Ok(configured(options, 4))
    }),
    about("segmented-8", "x(c - u(A - a u)) in 8 segments", &[FITTED], |_, options| Ok(configured(options, 8))),
];

const FITTED: Variant = Variant::new("", "", &[Use::Table, Use::Exactness]);
const TIMED: Variant = Variant::new("", "", &[Use::Table, Use::Bench]);
const WEIGHTED: Variant = Variant::new("weighted:-0.3", "objective = 'weighted:-0.3'", &[Use::Exactness]);

const fn about(name: &'static str, formula: &'static str, variants: &'static [Variant], configure: Configure) -> About {
    About { coefficients: &[Coefficients::Minimax], variants, ..About::new(name, formula, formula, configure) }
}

fn configured(options: &Options, segments: u32) -> Arc<dyn Method> {
    Arc::new(Configured { segments, objective: options.objective.unwrap_or_default() })
}

#[derive(Debug)]
struct Configured {
    segments: u32,
    objective: Objective,
}

impl Method for Configured {
    fn options(&self) -> Options {
        Source::Fitted(self.objective).options()
    }

    fn architecture<'a>(&'a self, interface: &'a Interface) -> Result<Box<dyn Architecture + 'a>, Error> {
        Ok(Box::new(datapath::Segments::new(interface, self.segments, &self.objective)?))
    }

    fn model(&self, inputs: &Inputs) -> Wide {
        model::segmented(inputs)
    }
}
