//! Random numbers that are the same on every machine.

use rand_core::Rng as _;
use rand_pcg::Pcg64;

/// A generator with a fixed seed, so that what is drawn from it is the same on every machine.
#[derive(Clone, Debug)]
pub struct Rng(Pcg64);

impl Rng {
    /// The stream of this number, of the project's one seed.
    #[must_use]
    pub fn new(stream: u64) -> Self {
        Self(Pcg64::new(0x6272_6466_6765_6e00, stream.into()))
    }

    /// A whole number from 0 up to below `bound`.
    pub fn below(&mut self, bound: u64) -> u64 {
        // The high product half: even to 2^-40 for the small bounds here.
        ((u128::from(self.0.next_u64()) * u128::from(bound)) >> 64) as u64
    }

    /// A real number from 0 up to below 1, a multiple of 2^-53.
    pub fn unit(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 * super::exp2(-53)
    }
}
