//! The texels of an image-based block and the memories that they lie in.

use super::{Image, ImageForm};
use crate::fixed::{Field, Table, exp2, interned};
use crate::method::polynomial::datapath::rounded_field;
use crate::reflectance::texels::{Samples, Scale, Texel, Texels};
use crate::reflectance::{Reflectance, bivariate, half};

/// Where the columns of texels lie on the versine u = 1 - n·h: as the codes of a floating-point number without a sign,
/// so that a highlight's middle has many and its rim few, and an address is a normalisation and no function.
///
/// With 2^m columns an octave the code c = e 2^m + k stands for `(1 + k 2^-m) 2^(e - E)`, E the number of octaves, and
/// below the first of them (e = 0) for `k 2^-m 2^(1 - E)`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OctaveAxis {
    /// Columns.
    pub size: u32,
    /// m.
    pub octave_bits: u32,
}

impl OctaveAxis {
    /// The versine of a column.
    #[must_use]
    pub fn versine(self, column: u32) -> f64 {
        let (exponent, rest) = (column >> self.octave_bits, column & ((1 << self.octave_bits) - 1));
        let octaves = (self.size >> self.octave_bits) as i32;
        let part = f64::from(rest) / f64::from(1u32 << self.octave_bits);
        match exponent {
            0 => part * exp2(1 - octaves),
            _ => (1.0 + part) * exp2(exponent as i32 - octaves),
        }
    }
}

/// Red, green and blue in names.
const CHANNELS: [&str; 3] = ["r", "g", "b"];

/// Texels in memories by the parities of their places, so that all that are blended are read in one clock.
#[derive(Clone, Debug)]
pub struct Banks {
    /// The texels: bands, each with its cap.
    pub texels: Texels,
}

impl Banks {
    /// The texels of a reflectance.
    #[must_use]
    pub fn of(image: &Image, reflectance: &dyn Reflectance, exposure: f64) -> Self {
        let size = image.size as usize;
        let texel = Texel::Sqrt(image.texel_bits, None);
        let (samples, scale): (Samples, Scale) = match image.form {
            ImageForm::Bivariate { octave_bits } => {
                let axis = OctaveAxis { size: image.size, octave_bits };
                let angle = |column| libm::acos(1.0 - axis.versine(column));
                let angles: Vec<f64> = (0..image.size).map(angle).collect();
                (bivariate::samples_at(reflectance, &angles, size, exposure), Scale::Row)
            }
            ImageForm::Half { .. } => (half::samples(reflectance, &image.bands(), size, exposure), Scale::Layer),
        };
        Self { texels: Texels::encode(&samples, texel, scale) }
    }

    /// The name of the memory of a light, counted from 0, that holds the texels of these parities of their places, the
    /// outermost first.
    #[must_use]
    pub fn memory(light: usize, parities: &[usize]) -> &'static str {
        let words: Vec<&str> = parities.iter().map(|&odd| ["even", "odd"][odd]).collect();
        interned(format!("texels_{}_{}", light + 1, words.join("_")))
    }

    /// The names of the fields of that memory.
    #[must_use]
    pub fn fields(light: usize, parities: &[usize]) -> [&'static str; 3] {
        CHANNELS.map(|channel| interned(format!("{}_{channel}", Self::memory(light, parities))))
    }

    /// All parities of places in so many directions, those of the innermost changing fastest.
    #[must_use]
    pub fn parities(directions: usize) -> Vec<Vec<usize>> {
        (0..1usize << directions).map(|bits| (0..directions).rev().map(|place| bits >> place & 1).collect()).collect()
    }

    /// The memories of a light, in the order of [`Banks::parities`].
    #[must_use]
    pub fn tables(&self, image: &Image, light: usize) -> Vec<Table> {
        let extents: Vec<usize> = image.extents().iter().map(|&extent| extent as usize).collect();
        // A code c of b bits stands here for c 2^-b, and for c/(2^b - 1) of the root of the cap.
        let (full, steps) = (((1u32 << image.texel_bits) - 1) as f32, exp2(image.texel_bits as i32));
        let bank = |parities: Vec<usize>| {
            let lies_in = |&place: &usize| {
                let mut rest = place;
                extents.iter().zip(&parities).rev().all(|(extent, parity)| {
                    let own = rest % extent % 2 == *parity;
                    rest /= extent;
                    own
                })
            };
            let places: Vec<usize> = (0..self.texels.codes().len()).filter(lies_in).collect();
            let names = Self::fields(light, &parities);
            let field = |channel: usize| -> Field {
                let code = |&place: &usize| f64::from((self.texels.codes()[place][channel] * full).round()) / steps;
                let reals = places.iter().map(code).collect();
                rounded_field(names[channel], ["red", "green", "blue"][channel], image.texel_bits as i32, reals)
            };
            let keys = (0..places.len()).map(|place| place as f64).collect();
            Table::listed(Self::memory(light, &parities), "entry", keys, (0..3).map(field).collect())
        };
        Self::parities(extents.len()).into_iter().map(bank).collect()
    }
}
