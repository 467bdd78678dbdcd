//! Inputs of an image-based block of the form matcap: x and y of a normal.

use super::sample::random_codes;
use super::{Direction, ImageDesign};
use crate::fixed::{Rng, exp2};

impl ImageDesign<'_> {
    /// The code of a component that leads to a place along a side, in parts of a weight's last bit from the first
    /// texel's centre, exactly.
    fn component_at(self, place: u64) -> i64 {
        let image = &self.of.image;
        let texels = place as f64 * exp2(-(image.weight_bits as i32));
        self.block.component((2.0 * texels + 1.0) / f64::from(image.size) - 1.0)
    }

    /// The codes of x and y that lead to places along the sides.
    pub(super) fn at_place(self, places: [u64; 2]) -> Vec<i64> {
        places.map(|place| self.component_at(place)).to_vec()
    }

    /// An input of the block: any codes, a normal that is seen, or one where a place is rounded up or no longer, at a
    /// texel or anywhere between.
    pub(super) fn varied_place(self, rng: &mut Rng) -> Vec<i64> {
        let image = &self.of.image;
        let ports = self.numbers(Direction::In);
        let parts = 1u64 << image.weight_bits;
        // From one place to the next, in codes.
        let step = self.component_at(1) - self.component_at(0);
        let component = |rng: &mut Rng| {
            let texel = rng.below(image.size.into()) * parts;
            let place = texel + if rng.below(2) == 0 { 0 } else { rng.below(parts) };
            let edge = match rng.below(3) {
                0 => 0,
                // Half of a step up to the next place, or just not.
                _ => step / 2 - rng.below(3) as i64,
            };
            self.component_at(place) + edge
        };
        let mut codes = match rng.below(4) {
            0 => random_codes(&ports, rng),
            1 => self.random(rng),
            _ => vec![component(rng), component(rng)],
        };
        if rng.below(8) == 0 {
            // One of both at an end of its codes, or about 0.
            let place = rng.below(2) as usize;
            let format = ports[place].1;
            let ends = [format.min_code() as i64, format.max_code() as i64, -1, 0, 1];
            codes[place] = ends[rng.below(ends.len() as u64) as usize];
        }
        codes.into_iter().zip(ports).map(|(code, (_, format))| format.wrap(code.into()) as i64).collect()
    }
}
