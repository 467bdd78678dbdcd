//! Fixed-point formats, intervals and the wide fixed-point type of the model.
//!
//! A number is an integer (its *code*) times the weight of its last bit. [`Format`] says how wide the integer is and
//! where the binary point lies; [`Interval`] bounds real values and errors with outward rounding; [`Table`] holds the
//! words of a memory; [`Rng`] draws reproducible random numbers; [`wide`] holds the arithmetic of the reference model
//! on the crate `fixed`, [`turn`] sines in integers.

mod format;
mod interval;
mod rng;
mod table;
pub mod turn;
pub mod wide;
mod widths;

pub use format::Format;
pub use interval::Interval;
pub use rng::Rng;
pub use table::{Field, Table, interned};
pub use widths::{Width, Widths};

/// `2^exponent` as an exact `f64`; `exponent` must lie in -1022..=1023.
#[must_use]
pub fn exp2(exponent: i32) -> f64 {
    debug_assert!((-1022..=1023).contains(&exponent));
    f64::from_bits(((exponent + 1023) as u64) << 52)
}
