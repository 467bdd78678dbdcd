//! The texels of an image-based block and the memories that they lie in.

use super::{Image, ImageForm};
use crate::block::CHANNELS;
use crate::fixed::{Field, Format, Table, exp2, interned};
use crate::reflectance::paper::{self, Border};
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

/// Samples of a reflectance times an exposure, where the texels lie.
pub(super) fn samples(image: &Image, reflectance: &dyn Reflectance, exposure: f64) -> Samples {
    let size = image.size as usize;
    match &image.form {
        &ImageForm::Bivariate { octaves } => {
            let axis = OctaveAxis { size: image.size, octave_bits: image.octave_bits(octaves) };
            let angle = |column| libm::acos(1.0 - axis.versine(column));
            let angles: Vec<f64> = (0..image.size).map(angle).collect();
            bivariate::samples_at(reflectance, &angles, size, exposure)
        }
        ImageForm::Half { .. } => half::samples(reflectance, &image.band_angles(), size, exposure),
        ImageForm::Paper { angles } => paper::samples(reflectance, angles, size, Border::ExtendX, exposure),
        // A picture of it, lit from the viewer.
        ImageForm::Matcap => paper::samples(reflectance, &[0.0], size, Border::Extend, exposure),
    }
}

/// Samples of all bands: an image that is there twice, [`Image::band_angles`], is sampled once.
pub(super) fn of_all_bands(image: &Image, mut samples: Samples) -> Samples {
    if let ImageForm::Paper { angles } = &image.form {
        let layer = samples.width * samples.height;
        let missing = image.band_angles().len() - angles.len();
        samples.data.extend_from_within(samples.data.len() - missing * layer..);
    }
    samples
}

/// The texels of samples: bands of the roots of their values, each with its cap.
pub(super) fn encoded(image: &Image, samples: &Samples) -> Texels {
    let (scale, cap) = match image.form {
        ImageForm::Bivariate { .. } => (Scale::Row, None),
        ImageForm::Half { .. } | ImageForm::Paper { .. } => (Scale::Layer, None),
        // What a display shows.
        ImageForm::Matcap => (Scale::Layer, Some(1.0)),
    };
    Texels::encode(samples, Texel::Sqrt(image.texel_bits, cap), scale)
}

/// The codes of a texel's channels.
pub(super) fn codes(image: &Image, texels: &Texels, place: usize) -> [i128; 3] {
    let full = ((1u32 << image.texel_bits) - 1) as f32;
    [0, 1, 2].map(|channel| (texels.codes()[place][channel] * full).round() as i128)
}

/// The name of the memory of a light, counted from 0, that holds the texels of these parities of their places, the
/// outermost first.
fn memory(light: usize, parities: &[usize]) -> &'static str {
    let words: Vec<&str> = parities.iter().map(|&odd| ["even", "odd"][odd]).collect();
    interned(format!("texels_{}_{}", light + 1, words.join("_")))
}

/// The names of the fields of that memory.
pub(super) fn fields(light: usize, parities: &[usize]) -> [&'static str; 3] {
    CHANNELS.map(|channel| interned(format!("{}_{channel}", memory(light, parities))))
}

/// All parities of places in so many directions, those of the innermost changing fastest.
pub(super) fn parities(directions: usize) -> Vec<Vec<usize>> {
    (0..1usize << directions).map(|bits| (0..directions).rev().map(|place| bits >> place & 1).collect()).collect()
}

/// The memories of all lights, of each in the order of [`parities`]: all texels that are blended lie in memories of
/// their own, and are read in one clock.
pub(super) fn banks(image: &Image, texels: &Texels) -> Vec<Table> {
    let extents: Vec<usize> = image.extents().iter().map(|&extent| extent as usize).collect();
    let steps = exp2(image.texel_bits as i32);
    let bank = |parities: &Vec<usize>| {
        // The place of the texel at an address: in each direction twice its part of the address, and the parity.
        let place = |address: usize| {
            let mut rest = address;
            let mut inner = 1;
            extents.iter().zip(parities).rev().fold(0, |place, (extent, parity)| {
                let own = 2 * (rest % (extent / 2)) + parity;
                rest /= extent / 2;
                let place = place + own * inner;
                inner *= extent;
                place
            })
        };
        let count: usize = extents.iter().map(|extent| extent / 2).product();
        let names = fields(0, parities);
        let words: Vec<[i128; 3]> = (0..count).map(|address| codes(image, texels, place(address))).collect();
        let field = |channel: usize| -> Field {
            let codes: Vec<i128> = words.iter().map(|word| word[channel]).collect();
            Field {
                name: names[channel],
                meaning: ["red", "green", "blue"][channel],
                // Not as narrow as these texels would allow: others may be written.
                format: Format::unsigned(0, image.texel_bits as i32),
                reals: codes.iter().map(|&code| code as f64 / steps).collect(),
                codes,
            }
        };
        let keys = (0..count).map(|address| address as f64).collect();
        Table::listed(memory(0, parities), Table::TEXEL, keys, (0..3).map(field).collect())
    };
    let parities = parities(extents.len());
    let first: Vec<Table> = parities.iter().map(bank).collect();
    let of_light = |light: usize| {
        first.iter().zip(&parities).map(move |(table, parities)| {
            let mut table = table.clone().named(memory(light, parities));
            table.fields.iter_mut().zip(fields(light, parities)).for_each(|(field, name)| field.name = name);
            table
        })
    };
    (0..image.look_ups()).flat_map(of_light).collect()
}
