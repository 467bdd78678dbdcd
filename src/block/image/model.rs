//! The image-based block in bits, from its formula.

use super::texels::code;
use super::{Image, ImageForm, ImageWidths};
use crate::fixed::wide::{self, Wide};
use crate::reflectance::texels::Texels;

/// The function of an image-based core.
#[derive(Clone, Debug)]
pub struct ImageModel<'a> {
    image: &'a Image,
    widths: ImageWidths,
    texels: &'a Texels,
}

/// A place between two texels: the number of the first, and the weight of the next.
type Place = (usize, Wide);

impl<'a> ImageModel<'a> {
    pub(super) fn new(image: &'a Image, widths: ImageWidths, texels: &'a Texels) -> Self {
        Self { image, widths, texels }
    }

    /// The codes of `out_sum_r`, `out_sum_g` and `out_sum_b` for the codes of the input ports in their order.
    #[must_use]
    pub fn evaluate(&self, inputs: &[i64]) -> Vec<i64> {
        let (normal, lights) = inputs.split_at(3);
        let mut sums = [Wide::ZERO; 3];
        for light in lights.chunks(lights.len() / self.image.lights as usize) {
            let terms = self.light(normal, light);
            (0..3).for_each(|c| sums[c] += terms[c]);
        }
        sums.map(|sum| wide::to_code(sum.min(Wide::ONE), self.widths.term as u32) as i64).to_vec()
    }

    /// The scalar product of vectors of these codes, of products that are rounded down to so many fraction bits.
    fn product(&self, a: &[i64], b: &[i64], bits: i32) -> Wide {
        let number = |code: i64| wide::from_code(code.into(), self.image.vector_fraction);
        let product = |a: i64, b: i64| wide::floor_to(number(a) * number(b), bits as u32);
        a.iter().zip(b).fold(Wide::ZERO, |sum, (&a, &b)| sum + product(a, b))
    }

    /// The column of |n - h|²/2 as a floating-point number with a place behind the last.
    fn octave_column(&self, normal: &[i64], half: &[i64], octaves: u32) -> Place {
        let (weight_bits, octave_bits) = (self.image.weight_bits, self.image.octave_bits(octaves));
        let most = 1i64 << (self.image.vector_fraction + 1);
        let apart: Vec<i64> = normal.iter().zip(half).map(|(n, h)| (n - h).clamp(-most, most - 1)).collect();
        let u = wide::floor_to(self.product(&apart, &apart, self.widths.place) / 2, self.image.versine_bits(octaves));
        let u = u.min(Wide::ONE - wide::from_code(1, octave_bits + 1));
        let exponent = (1..octaves).rev().find(|&e| u >= wide::from_code(1, octaves - e)).unwrap_or(0);
        let rest = match exponent {
            0 => u << (octaves - 1),
            e => (u << (octaves - e)) - Wide::ONE,
        };
        let within = wide::to_code(rest, octave_bits + weight_bits) as usize;
        let place = within + ((exponent as usize) << (octave_bits + weight_bits));
        (place >> weight_bits, self.weight(place))
    }

    /// The weight that the last bits of a place are.
    fn weight(&self, place: usize) -> Wide {
        let bits = self.image.weight_bits;
        wide::from_code((place & ((1 << bits) - 1)) as i128, bits)
    }

    /// Where a vector lies along an axis of a slice, whose texels have their centres at (i + 1/2)/size of -1 to 1: to
    /// the nearest weight, between the outermost centres.
    fn across(&self, normal: &[i64], axis: &[i64]) -> Place {
        let bits = self.image.weight_bits;
        let last = Wide::from_num(self.image.size - 1);
        let place = (self.product(normal, axis, self.widths.place) * i128::from(self.image.size) + last) / 2;
        let place = wide::floor_to(place + wide::from_code(1, bits + 1), bits).clamp(Wide::ZERO, last);
        let place = wide::to_code(place, bits) as usize;
        (place >> bits, self.weight(place))
    }

    /// The blend of the texels about a place in all directions.
    fn blend(&self, channel: usize, places: &[Place], extents: &[u32], before: usize) -> Wide {
        let Some((&(place, weight), rest)) = places.split_first() else {
            return wide::from_code(code(self.image, self.texels, before, channel), self.image.texel_bits);
        };
        let extent = extents[0] as usize;
        // Beside the last one, which is odd, stands the one before it.
        let next = if place + 1 < extent { place + 1 } else { place - 1 };
        let [a, b] = [place, next].map(|place| self.blend(channel, rest, &extents[1..], before * extent + place));
        a + (b - a) * weight
    }

    /// What a light gives to the channels.
    fn light(&self, normal: &[i64], light: &[i64]) -> [Wide; 3] {
        let f = self.image.vector_fraction;
        let floor = |value: Wide, bits: i32| wide::floor_to(value, bits as u32);
        let ImageWidths { dot, lit, shift: most_shift, .. } = self.widths;
        let nl = floor(self.product(normal, &light[..3], dot), lit + most_shift);
        let nl = nl.clamp(Wide::ZERO, Wide::ONE - wide::from_code(1, ((lit + most_shift) as u32).min(2 * f)));
        if normal[2] <= 0 {
            return [Wide::ZERO; 3];
        }
        let extents = self.image.extents();
        let (inner, rest): (Vec<Place>, &[i64]) = match self.image.form {
            ImageForm::Bivariate { octaves } => (vec![self.octave_column(normal, &light[3..6], octaves)], &light[6..]),
            ImageForm::Half { .. } => {
                (vec![self.across(&normal[..2], &light[6..8]), self.across(normal, &light[3..6])], &light[8..])
            }
        };
        let band = (rest[0] as usize) % extents[0] as usize;
        let odd = wide::from_code(rest[1].into(), self.image.weight_bits).min(Wide::ONE);
        let t = if band.is_multiple_of(2) { odd } else { Wide::ONE - odd };
        let places = [vec![(band, t)], inner].concat();
        // n·l 2^shift, within its format.
        let ImageWidths { lit_int, gain: gain_bits, code, square, term, .. } = self.widths;
        let (shift, gains) = if most_shift == 0 { (0, &rest[2..]) } else { (rest[2], &rest[3..]) };
        let most = (Wide::ONE << lit_int) - wide::from_code(1, (lit as u32).min(2 * f));
        let lit_up = floor(nl << (shift as i32).min(most_shift), lit).min(most);
        [0, 1, 2].map(|channel| {
            let code = floor(self.blend(channel, &places, &extents, 0), code);
            let reflected = floor(lit_up * floor(code * code, square), lit);
            floor(reflected * wide::from_code(gains[channel].into(), gain_bits as u32), term)
        })
    }
}
