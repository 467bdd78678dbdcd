//! `log-exp`: `2^(-n L(x))`, `L = -log2 x`, from small tables, after D. Harris, IEEE Trans. Computers 53(3), 2004; with
//! an accuracy a smaller core, in `coarse`.

pub(super) mod chords;
mod coarse;
pub(super) mod datapath;
mod lobe;
pub(super) mod model;

use std::sync::Arc;

use super::{About, Inputs, Interface, Method, Options, Use, Variant, within};
use crate::datapath::Architecture;
use crate::fixed::Width;
use crate::fixed::wide::Wide;
use crate::platform::error::Error;

pub use coarse::{ACCURACY, ACCURACY_INPUT_FRACTION, Memory};
pub(super) use datapath::{EXP_TABLE, LOG_TABLE};
pub use lobe::{EXP_CURVATURE, LOG_RATIO_CURVATURE, LogExp, log_ratio};

/// The method.
pub static METHODS: [About; 1] = [About {
    options: &["accuracy", "memory"],
    computes_with_shininess: true,
    variants: &[
        Variant::new("", "", &[Use::Table, Use::Smallest, Use::Bench]),
        Variant::new("to 2^-5", "accuracy = 5", &[Use::Table]),
        Variant::new("to 2^-7", "accuracy = 7", &[Use::Table]),
        Variant::new("to 2^-9", "accuracy = 9", &[Use::Table]),
        Variant::new("to 2^-11", "accuracy = 11", &[Use::Table]),
        Variant::new("to 2^-14", "accuracy = 14", &[Use::Table]),
        Variant::new("to 2^-3", "accuracy = 3", &[Use::Smallest]),
        Variant::new("to 2^-3, block memory", "accuracy = 3\nmemory = 'block'", &[Use::Smallest]),
    ],
    ..About::new(
        "log-exp",
        "2^(-n L(x)) with L = -log2 x, from small tables",
        "2^(-n L(x)), L = -log2 x",
        |_, options| {
            let coarse = |bits| (bits, options.memory.unwrap_or(Memory::Auto));
            Ok(Arc::new(Configured { coarse: options.accuracy.map(coarse) }))
        },
    )
}];

/// Bits of the address of the logarithm's table.
const LOG_ADDRESS: Width = Width("log");
/// The same of the exponential's.
pub(super) const EXP_ADDRESS: Width = Width("exp");

#[derive(Debug)]
struct Configured {
    /// The accuracy in bits and where the tables are meant to lie; `None`: below one ulp of the output.
    coarse: Option<(u32, Memory)>,
}

impl Method for Configured {
    fn options(&self) -> Options {
        let (accuracy, memory) = self.coarse.unzip();
        Options { accuracy, memory, ..Options::default() }
    }

    fn check(&self, interface: &Interface) -> Result<(), Error> {
        let Some((bits, _)) = self.coarse else { return Ok(()) };
        within("accuracy", bits, *ACCURACY.start()..=(*ACCURACY.end()).min(interface.output_fraction - 1))?;
        let what = "input_fraction of a core with an accuracy";
        within(what, interface.input_fraction, ACCURACY_INPUT_FRACTION).map(|_| ())
    }

    fn architecture<'a>(&'a self, interface: &'a Interface) -> Result<Box<dyn Architecture + 'a>, Error> {
        Ok(match self.coarse {
            None => Box::new(datapath::LogExp::new(interface)?),
            Some((bits, memory)) => Box::new(coarse::datapath::Coarse::new(interface, bits, memory)?),
        })
    }

    fn model(&self, inputs: &Inputs) -> Wide {
        match self.coarse {
            None => model::evaluate(inputs),
            Some((bits, _)) => coarse::model::evaluate(inputs, bits),
        }
    }
}
