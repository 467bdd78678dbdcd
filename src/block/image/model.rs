//! The image-based block in bits, from its formula.

use super::texels::codes;
use super::turn::{ANGLE, ROOT, ROOT_AXIS, ROOT_OPERAND, ROOT_WEIGHT, SINE, STEPS, TILT};
use super::{BLENDED, Image, ImageForm, ImageWidths, LightRecord, OctaveAxis};
use crate::fixed::Table;
use crate::fixed::wide::{self, Wide};
use crate::reflectance::texels::Texels;

/// The function of an image-based core.
#[derive(Clone, Debug)]
pub struct ImageModel<'a> {
    pub(super) image: &'a Image,
    pub(super) widths: ImageWidths,
    texels: &'a Texels,
    /// The tables of functions of a light.
    pub(super) functions: &'a [Table],
}

/// A place between two texels: the number of the first, and the weight of the next.
pub(super) type Place = (usize, Wide);

impl<'a> ImageModel<'a> {
    pub(super) fn new(image: &'a Image, widths: ImageWidths, texels: &'a Texels, functions: &'a [Table]) -> Self {
        Self { image, widths, texels, functions }
    }

    /// The codes of `out_sum_r`, `out_sum_g` and `out_sum_b`, in the form matcap of `out_r`, `out_g` and `out_b`, for
    /// the codes of the input ports in their order.
    #[must_use]
    pub fn evaluate(&self, inputs: &[i64]) -> Vec<i64> {
        if !self.image.has_lights() {
            return self.matcap(inputs);
        }
        let (normal, lights) = inputs.split_at(3);
        let mut sums = [Wide::ZERO; 3];
        for light in lights.chunks(lights.len() / self.image.lights as usize) {
            let terms = self.light(normal, light);
            (0..3).for_each(|c| sums[c] += terms[c]);
        }
        sums.map(|sum| wide::to_code(sum.min(Wide::ONE), self.widths.term as u32) as i64).to_vec()
    }

    /// The scalar product of vectors of these codes, of products that are rounded down to so many fraction bits.
    pub(super) fn product(&self, a: &[i64], b: &[i64], bits: i32) -> Wide {
        let number = |code: i64| wide::from_code(code.into(), self.image.vector_fraction);
        let product = |a: i64, b: i64| wide::floor_to(number(a) * number(b), bits as u32);
        a.iter().zip(b).fold(Wide::ZERO, |sum, (&a, &b)| sum + product(a, b))
    }

    /// u = |n - h|²/2, at most that of the last column.
    fn versine(&self, normal: &[i64], half: &[i64], octaves: u32) -> Wide {
        let most = 1i64 << (self.image.vector_fraction + 1);
        let apart: Vec<i64> = normal.iter().zip(half).map(|(n, h)| (n - h).clamp(-most, most - 1)).collect();
        let u = wide::floor_to(self.product(&apart, &apart, self.widths.place) / 2, self.image.versine_bits(octaves));
        u.min(Wide::ONE - wide::from_code(1, self.image.octave_bits(octaves) + 1))
    }

    /// The column of u as a floating-point number with a place of so many bits behind the last.
    pub(super) fn octave_column(u: Wide, axis: OctaveAxis, weight_bits: u32) -> Place {
        let (octaves, octave_bits) = (axis.size >> axis.octave_bits, axis.octave_bits);
        let exponent = (1..octaves).rev().find(|&e| u >= wide::from_code(1, octaves - e)).unwrap_or(0);
        let rest = match exponent {
            0 => u << (octaves - 1),
            e => (u << (octaves - e)) - Wide::ONE,
        };
        let within = wide::to_code(rest, octave_bits + weight_bits) as usize;
        split(within + ((exponent as usize) << (octave_bits + weight_bits)), weight_bits)
    }

    /// Where a component lies along a side of a slice or image, whose texels have their centres at (i + 1/2)/size of -1
    /// to 1: to the nearest weight, between the outermost centres.
    fn along(&self, component: Wide) -> Place {
        let bits = self.image.weight_bits;
        let last = Wide::from_num(self.image.size - 1);
        let place = (component * i128::from(self.image.size) + last) / 2;
        let place = wide::floor_to(place + wide::from_code(1, bits + 1), bits).clamp(Wide::ZERO, last);
        split(wide::to_code(place, bits) as usize, bits)
    }

    /// A field of a function table at the row of a place, and its part of the way to the next row, which is the field
    /// behind it.
    pub(super) fn between(table: &Table, (row, weight): Place, field: usize) -> [Wide; 2] {
        let value = |field: usize| {
            let frac_bits = table.fields[field].format.frac_bits as u32;
            wide::from_code(table.fields[field].codes[row], frac_bits)
        };
        [value(field), value(field + 1) * weight]
    }

    /// Where the normal lies along x in an image with an even number and in one with an odd number, and along y in
    /// both: of the form paper.
    pub(super) fn turned(&self, normal: &[i64], frame: &[i64], turns: &[i64]) -> ([Place; 2], Place) {
        let [roots, sines, ..] = self.functions else { panic!("tables of the form paper") };
        let (across, turn) = frame.split_at(3);
        let bits = self.widths.place;
        let one = |a: i64, b: i64| self.product(&[a], &[b], bits);
        let x = (one(normal[0], turn[1]) - one(normal[1], turn[0])).clamp(-Wide::ONE, Wide::ONE);
        let y = self.product(&normal[..2], turn, bits);
        let z = wide::from_code(normal[2].into(), self.image.vector_fraction);
        let tilt = if turns[2] == 0 {
            let unit = y.clamp(-Wide::ONE, Wide::ONE);
            let rest = floor(Wide::ONE - unit * unit, ROOT_OPERAND);
            let rest = rest.min(Wide::ONE - wide::from_code(1, ROOT_OPERAND as u32));
            let [root, fall] = Self::between(roots, Self::octave_column(rest, ROOT_AXIS, ROOT_WEIGHT), 0);
            let distance = self.product(normal, across, bits).abs().min(Wide::ONE);
            floor(distance * floor(root - fall, ROOT), TILT).min(Wide::ONE)
        } else {
            Wide::ONE / 2
        };
        let last = Wide::from_num(self.image.size - 1);
        let place = |half: i64| {
            let angle = wide::from_code(half.into(), ANGLE as u32);
            let angle = angle + floor(angle * tilt, ANGLE);
            let angle = angle.clamp(-Wide::ONE, Wide::ONE - wide::from_code(1, ANGLE as u32));
            let from = wide::to_code(angle + Wide::ONE, ANGLE as u32) as usize;
            let row = split(from, (ANGLE - STEPS) as u32);
            let [sine, cosine] = [0, 2].map(|field| {
                let [at, rise] = Self::between(sines, row, field);
                floor(at + rise, SINE)
            });
            let of = |a: Wide, b: Wide| floor(a * b, bits);
            if of(x, sine) > of(z, cosine) {
                let end = if half < 0 { Wide::ZERO } else { last };
                return split(wide::to_code(end, self.image.weight_bits) as usize, self.image.weight_bits);
            }
            self.along(of(x, cosine) + of(z, sine))
        };
        ([place(turns[0]), place(turns[1])], self.along(y))
    }

    /// The blend of the texels about a place in all directions: each direction's in a band with an even number and in
    /// one with an odd number, of which the outermost is followed already where it is told.
    fn blend(&self, places: &[[Place; 2]], extents: &[u32], before: usize, band: Option<usize>) -> [Wide; 3] {
        let Some((of_bands, rest)) = places.split_first() else {
            return codes(self.image, self.texels, before).map(|code| wide::from_code(code, self.image.texel_bits));
        };
        let (place, weight) = of_bands[band.unwrap_or(0) % 2];
        let extent = extents[0] as usize;
        // Beside the last one, which is odd, stands the one before it.
        let next = if place + 1 < extent { place + 1 } else { place - 1 };
        let [a, b] = [place, next].map(|place| {
            let band = band.or(Some(place));
            self.blend(rest, &extents[1..], before * extent + place, band).map(|code| floor(code, BLENDED))
        });
        [0, 1, 2].map(|channel| a[channel] + (b[channel] - a[channel]) * weight)
    }

    /// The codes of a matcap's channels where x and y of a normal lead to.
    fn matcap(&self, normal: &[i64]) -> Vec<i64> {
        let number = |code: i64| wide::from_code(code.into(), self.image.vector_fraction);
        let places = [1, 0].map(|axis| [self.along(number(normal[axis])); 2]);
        let (extents, channel_bits) = (self.image.extents(), self.image.channel_bits);
        let ImageWidths { code, square, .. } = self.widths;
        let half = wide::from_code(1, channel_bits + 1);
        let of_channel = |blended: Wide| {
            let blended = floor(blended, code);
            let root = self.image.fills().fold(blended, |root, shift| root + floor(root >> shift, code));
            let squared = floor(root * root, square);
            // Full scale is the greatest code, and not two to the power of its bits.
            let part = squared - floor(squared >> channel_bits, square);
            wide::to_code(part + half, channel_bits) as i64
        };
        self.blend(&places, &extents, 0, None).map(of_channel).to_vec()
    }

    /// What a light gives to the channels.
    fn light(&self, normal: &[i64], light: &[i64]) -> [Wide; 3] {
        let f = self.image.vector_fraction;
        let ImageWidths { shift: most_shift, lit_int, dot, place, lit, gain: gain_bits, code, square, term } =
            self.widths;
        if normal[2] <= 0 {
            return [Wide::ZERO; 3];
        }
        let LightRecord { direction, frame, band, blend, turns, shift, gain } = self.record(light);
        let extents = self.image.extents();
        let inner: Vec<[Place; 2]> = match self.image.form {
            ImageForm::Bivariate { octaves } => {
                let axis = OctaveAxis { size: self.image.size, octave_bits: self.image.octave_bits(octaves) };
                let u = self.versine(normal, &frame, octaves);
                vec![[Self::octave_column(u, axis, self.image.weight_bits); 2]]
            }
            ImageForm::Half { .. } => {
                [self.product(&normal[..2], &frame[3..], place), self.product(normal, &frame[..3], place)]
                    .map(|component| [self.along(component); 2])
                    .to_vec()
            }
            ImageForm::Paper { .. } => {
                let (xs, y) = self.turned(normal, &frame, &turns.unwrap_or_default());
                vec![[y; 2], xs]
            }
            ImageForm::Matcap => unreachable!("a form without lights"),
        };
        let band = (band as usize).min(extents[0] as usize - 1);
        let odd = wide::from_code(blend.into(), self.image.weight_bits).min(Wide::ONE);
        let t = if band.is_multiple_of(2) { odd } else { Wide::ONE - odd };
        let places = [vec![[(band, t); 2]], inner].concat();
        let shift = (shift.unwrap_or(0) as i32).min(most_shift);
        // What is shifted comes within its format.
        let most = (Wide::ONE << lit_int) - wide::from_code(1, (lit as u32).min(2 * f));
        let lit_up = direction.map(|direction| {
            let nl = floor(self.product(normal, &direction, dot), lit + most_shift);
            let nl = nl.clamp(Wide::ZERO, Wide::ONE - wide::from_code(1, ((lit + most_shift) as u32).min(2 * f)));
            floor(nl << shift, lit).min(most)
        });
        let blended = self.blend(&places, &extents, 0, None);
        [0, 1, 2].map(|channel| {
            let code = floor(blended[channel], code);
            let squared = floor(code * code, square);
            let reflected = match lit_up {
                Some(nl) => floor(nl * squared, lit),
                None => floor(squared << shift, lit).min((Wide::ONE << lit_int) - wide::from_code(1, lit as u32)),
            };
            floor(reflected * wide::from_code(gain[channel].into(), gain_bits as u32), term)
        })
    }
}

/// A value rounded down to so many fraction bits.
pub(super) fn floor(value: Wide, bits: i32) -> Wide {
    wide::floor_to(value, bits as u32)
}

/// A place in parts of a weight's last bit: what is at or below it, and the weight of the next.
pub(super) fn split(place: usize, weight_bits: u32) -> Place {
    let part = place & ((1 << weight_bits) - 1);
    (place >> weight_bits, wide::from_code(part as i128, weight_bits))
}
