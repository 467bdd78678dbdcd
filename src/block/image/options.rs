//! What an image-based block is asked with, and the widths that follow.

use std::ops::RangeInclusive;
use std::sync::Arc;

use clap::ValueEnum;
use serde::{Deserialize, Serialize};

use super::{ImageSamples, front_end, record, turn};
use crate::block::lights::{MOST_LIGHTS, Sums};
use crate::block::shader::{CHANNEL_BITS, LIGHTS, VECTOR_FRACTION};
use crate::fixed::{Format, exp2};
use crate::method::within;
use crate::platform::error::{Error, refuse};
use crate::reflectance::texels::Texels;
use crate::reflectance::{Model, bivariate, half};

/// Texels along a side that are allowed, each a power of two.
pub const SIZE: RangeInclusive<u32> = 8..=512;
/// Octaves of 1 - n·h that are allowed, each a power of two.
pub const OCTAVES: RangeInclusive<u32> = 2..=16;
/// Slices that are allowed, each a power of two.
pub const SLICES: RangeInclusive<u32> = 4..=64;
/// Sphere images of the form paper that are allowed.
pub const IMAGES: RangeInclusive<u32> = 1..=32;
/// The greatest angle between neighbouring sphere images, from the first to 0 degrees less and from the last to 180.
const MOST_APART: f64 = 90.0;
/// The least angle between neighbouring sphere images: the reciprocal that light records are made with fits 64 bits.
const LEAST_APART: f64 = 0.1;
/// Bits of a texel's channel that are allowed.
pub const TEXEL_BITS: RangeInclusive<u32> = 4..=10;
/// Fraction bits of the weights that are allowed.
pub const WEIGHT_BITS: RangeInclusive<u32> = 3..=8;
/// Clocks from the address of a texel outside of the core to the texel that are allowed.
pub const TEXEL_LATENCY: RangeInclusive<u32> = 1..=32;
/// The most texels of a block: with 8 bits a channel 24 Mbit.
const MOST_TEXELS: u64 = 1 << 20;

/// What is stored of the reflectance, and how a light finds it.
#[derive(Clone, Debug, PartialEq)]
pub enum ImageForm {
    /// Over θh and θd: a row of texels for each θd, the columns along 1 - n·h.
    Bivariate {
        /// How many octaves of 1 - n·h have columns of their own; see [`super::OctaveAxis`].
        octaves: u32,
    },
    /// Slices about the half vector, one for each angle of the light.
    Half {
        /// How many.
        slices: u32,
    },
    /// Pictures of the unit sphere, lit from a few angles; IB equations 1 to 4. What is outside of the sphere has the
    /// rim's colour beside it:
    /// [`ExtendX`](crate::reflectance::paper::Border::ExtendX).
    Paper {
        /// The light's polar angles of the images in degrees, ascending.
        angles: Vec<f64>,
    },
    /// A picture of the unit sphere with its light in it, looked up where x and y of the normal say: no light is told
    /// of, and a sample is one clock. What is brighter than 1 is 1.
    Matcap,
}

/// What an image-based block is asked with.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// What is stored.
    pub form: ImageForm,
    /// Texels along either side.
    pub size: u32,
    /// Bits of a texel's channel.
    pub texel_bits: u32,
    /// Fraction bits of the weights that texels are blended with.
    pub weight_bits: u32,
    /// Fraction bits of the vectors' components, which are signed Q1.f.
    pub vector_fraction: u32,
    /// Bits of an output channel.
    pub channel_bits: u32,
    /// Lights that are taken in a clock; 0 in the form matcap, which has none.
    pub lights: u32,
    /// Lights of a sample that the roundings are sized for, 0 in the form matcap; more may come.
    pub most_lights: u32,
    /// What the core is told of a light.
    pub front_end: FrontEnd,
    /// How many blends of two are by multipliers, those of the widest codes first, or none for those that a DSP block
    /// is worth it for; the results are the same.
    pub blend_multipliers: Option<u32>,
}

/// What an image-based core is told of a light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum FrontEnd {
    /// Its record, which the library or a driver makes.
    #[default]
    Record,
    /// The unit vector towards it and its intensity, of which the core makes the record.
    Vector,
}

/// Where the texels of an image-based block lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum TexelMemory {
    /// In memories that are read from files at elaboration.
    Rom,
    /// In memories that come up so and have a write port each.
    Writable,
    /// In memories outside of the core, whose ports show the addresses and take the texels some clocks later.
    External,
}

/// An image-based block, resolved: what it is asked with, and what reflects.
#[derive(Clone, Debug, PartialEq)]
pub struct ImageSpec {
    /// What it is asked with.
    pub image: Image,
    /// What reflects.
    pub source: ImageSource,
    /// What its reflectance is multiplied by.
    pub exposure: f64,
}

/// What the texels of an image-based block are made of.
#[derive(Clone, Debug, PartialEq)]
pub enum ImageSource {
    /// A model.
    Model(Model),
    /// Samples of a file's reflectance, times the exposure.
    Samples(Arc<ImageSamples>),
}

impl ImageSource {
    /// The model, if it is one.
    #[must_use]
    pub fn model(&self) -> Option<&Model> {
        match self {
            Self::Model(model) => Some(model),
            Self::Samples(_) => None,
        }
    }
}

/// The widths of an image-based block: fraction bits each, unless said otherwise; 0 where its form has no such value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct ImageWidths {
    /// The greatest shift of a light, the exponent of its gain.
    pub shift: i32,
    /// Integer bits of n·l 2^shift.
    pub lit_int: i32,
    /// Of the products that n·l is the sum of.
    pub dot: i32,
    /// Of the products that a place among the texels is computed from.
    pub place: i32,
    /// Of n·l 2^shift, and of its product with the square.
    pub lit: i32,
    /// Of a light's gain; see [`ImageWidths::gain_format`].
    pub gain: i32,
    /// The blended code; in the form matcap also as it is filled up.
    pub code: i32,
    /// Its square.
    pub square: i32,
    /// What a light gives to a channel.
    pub term: i32,
}

/// Bits before the point of a light's gain: one makes the greatest shift, and with it n·l, a bit narrower.
pub(super) const GAIN_INT: i32 = 1;
/// The bits of a multiplier's operand in most families.
const OPERAND: i32 = 18;

/// Fraction bits of a light's gain.
pub(super) const GAIN: i32 = OPERAND - GAIN_INT;

/// Fraction bits of codes that are blended: wider ones are rounded down, so that their difference is an operand.
pub(super) const BLENDED: i32 = OPERAND - 1;

/// A number of things that is allowed and a power of two.
fn power_of_two(what: &str, value: u32, allowed: RangeInclusive<u32>) -> Result<(), Error> {
    let (least, most) = (*allowed.start(), *allowed.end());
    within(what, value, allowed)?;
    refuse!(
        !value.is_power_of_two(),
        format!("{what} = {value} is no power of two"),
        format!("a power of two from {least} to {most}")
    );
    Ok(())
}

impl ImageWidths {
    /// Bits of a light's shift.
    #[must_use]
    pub fn shift_bits(&self) -> i32 {
        (0..).find(|&bits| self.shift < 1 << bits).unwrap_or_default()
    }

    /// The format of a light's gain, and of its intensity where the core is told that.
    #[must_use]
    pub fn gain_format(&self) -> Format {
        Format::unsigned(GAIN_INT, self.gain)
    }

    /// The widths for these texels: operands of 18 bits wherever these do.
    ///
    /// Where light and viewer are on opposite sides a reflectance is in the thousands, and n·l of what both see as
    /// small; so a light's gain has an exponent, which n·l is shifted by.
    pub(super) fn new(image: &Image, texels: &Texels) -> Self {
        let (weight, channel) = (image.weight_bits as i32, image.channel_bits as i32);
        if !image.has_lights() {
            let [shift, lit_int, dot, place, lit, gain, term] = [0; 7];
            // What is rounded down is a sixteenth of an output code at most, each time.
            let kept = channel + 5;
            return Self { shift, lit_int, dot, place, lit, gain, code: kept, square: kept, term };
        }
        // n·l of a normal that a light and the viewer see.
        let in_texels = !image.has_incidence();
        let incidence = |phi: f64| if phi > 90.0 && !in_texels { libm::sin(phi.to_radians()) } else { 1.0 };
        let (mut shift, mut lit) = (0, 1.0f64);
        let mut take = |phi: f64, of_light: i32| {
            (shift, lit) = (shift.max(of_light), lit.max(incidence(phi) * exp2(of_light)));
        };
        let angles = image.band_angles();
        let gains: Vec<f64> = (0..angles.len()).map(|band| record::gain(image, texels.weight(band))).collect();
        angles.iter().zip(&gains).for_each(|(&phi, &gain)| take(phi, record::shift(gain)));
        // Between two bands the root of the gain is a straight line: the shift changes where it crosses a power of two.
        for (angles, gains) in angles.windows(2).zip(gains.windows(2)) {
            let [first, second] = [gains[0], gains[1]].map(libm::sqrt);
            for crossed in 0..record::shift(gains[0].max(gains[1])) {
                let t = (libm::sqrt(exp2(crossed + GAIN_INT)) - first) / (second - first);
                if (0.0..=1.0).contains(&t) {
                    take(angles[0] + t * (angles[1] - angles[0]), crossed + 1);
                }
            }
        }
        if image.front_end == FrontEnd::Vector {
            front_end::shifts(image, texels).into_iter().for_each(|(phi, of_row)| take(phi, of_row));
        }
        let lit_int = (0..).find(|&bits| lit <= exp2(bits)).unwrap_or_default();
        let blends = image.extents().len() as i32;
        let lit = (OPERAND - lit_int).max(channel + 3);
        // Three roundings are below the last bit of what is kept.
        let place = match image.form {
            ImageForm::Bivariate { octaves } => image.versine_bits(octaves) as i32 + 1,
            ImageForm::Half { .. } | ImageForm::Paper { .. } | ImageForm::Matcap => weight + image.size.ilog2() as i32,
        };
        Self {
            shift,
            lit_int,
            dot: lit + shift + 2,
            place: place + 2,
            lit,
            gain: GAIN,
            code: (image.texel_bits as i32 + blends * weight).min(OPERAND),
            square: OPERAND,
            term: Sums::term_bits(image.channel_bits, image.most_lights.max(image.lights)),
        }
    }
}

/// Whether sphere images can be lit from these angles.
fn check_angles(angles: &[f64]) -> Result<(), Error> {
    within("images", angles.len() as u32, IMAGES)?;
    refuse!(
        !(angles.iter().all(|angle| (0.0..=180.0).contains(angle)) && angles.is_sorted_by(|a, b| a < b)),
        format!("the angles {angles:?} of the images do not ascend from 0 to 180 degrees"),
        "angles in degrees, each once, the least first"
    );
    if let Some(two) = angles.windows(2).find(|two| two[1] - two[0] < LEAST_APART) {
        return Err(Error::input(
            format!("the angles {} and {} of images are too near to each other", two[0], two[1]),
            format!("images at least {LEAST_APART} degrees apart"),
        ));
    }
    let all = [&[0.0], angles, &[180.0]].concat();
    if let Some(two) = all.windows(2).find(|two| two[1] - two[0] > MOST_APART) {
        return Err(Error::input(
            format!("no image is between {} and {} degrees", two[0], two[1]),
            format!("images at most {MOST_APART} degrees apart, the first and the last as near to 0 and 180 degrees"),
        ));
    }
    Ok(())
}

impl Image {
    /// Whether a block can be made of it.
    ///
    /// # Errors
    /// A value that is not allowed, weights that are finer than what they are made of, too many texels.
    pub fn check(&self) -> Result<(), Error> {
        power_of_two("image_size", self.size, SIZE)?;
        within("texel_bits", self.texel_bits, TEXEL_BITS)?;
        within("weight_bits", self.weight_bits, WEIGHT_BITS)?;
        within("vector_fraction", self.vector_fraction, VECTOR_FRACTION)?;
        if self.has_lights() {
            within("lights_a_clock", self.lights, LIGHTS)?;
            within("most_lights", self.most_lights, MOST_LIGHTS)?;
        }
        refuse!(
            !CHANNEL_BITS.contains(&self.channel_bits),
            format!("channel_bits = {} is not offered", self.channel_bits),
            "8, 10 or 12"
        );
        match &self.form {
            &ImageForm::Bivariate { octaves } => {
                power_of_two("octaves", octaves, OCTAVES)?;
                refuse!(
                    octaves > self.size,
                    format!("{octaves} octaves are more than the {} columns", self.size),
                    "fewer octaves, or a greater image_size"
                );
                let (needed, there) = (self.versine_bits(octaves), 2 * self.vector_fraction + 1);
                refuse!(
                    needed > there,
                    format!("1 - n.h is needed to 2^-{needed}, and is a multiple of 2^-{there}"),
                    "more vector_bits, or fewer octaves, columns or weight_bits"
                );
            }
            &ImageForm::Half { slices } => power_of_two("images", slices, SLICES)?,
            ImageForm::Paper { angles } => check_angles(angles)?,
            ImageForm::Matcap => {
                let needed = self.size.ilog2() - 1 + self.weight_bits;
                refuse!(
                    needed > self.vector_fraction,
                    format!(
                        "a place among {} texels is needed to 2^-{needed}, and the normal is a multiple of 2^-{}",
                        self.size, self.vector_fraction
                    ),
                    "more vector_bits, or fewer weight_bits or a smaller image_size"
                );
            }
        }
        refuse!(
            self.front_end == FrontEnd::Vector && !self.has_incidence(),
            match self.has_turns() {
                true => "front_end = vector is given for sphere images, whose lights are told by their records",
                false => "front_end = vector is given for a matcap, which is told of no lights",
            },
            "leave it out, or use --image-form half or bivariate"
        );
        if let Some(multipliers) = self.blend_multipliers {
            let blends = 3 * self.look_ups() as u32 * ((1 << self.extents().len()) - 1);
            within("blend_multipliers", multipliers, 0..=blends)?;
        }
        let texels = self.extents().iter().map(|&extent| u64::from(extent)).product::<u64>();
        refuse!(
            texels > MOST_TEXELS,
            format!("{texels} texels are too many"),
            format!("at most {MOST_TEXELS}: a smaller image_size, or fewer images")
        );
        Ok(())
    }

    /// The greatest code of a channel: full scale.
    #[must_use]
    pub fn full_scale(&self) -> i64 {
        (1 << self.channel_bits) - 1
    }

    /// The binary logarithm of the columns an octave.
    pub(super) fn octave_bits(&self, octaves: u32) -> u32 {
        (self.size / octaves).ilog2()
    }

    /// What 1 - n·h is at a place among the columns, from the first.
    pub(crate) fn versine_at(&self, octaves: u32, place: f64) -> f64 {
        let octave_bits = self.octave_bits(octaves) as i32;
        let (octave, rest) = {
            let place = place / exp2(octave_bits);
            (place.floor(), place.fract())
        };
        match octave as i32 {
            0 => rest * exp2(1 - octaves as i32),
            octave => (1.0 + rest) * exp2(octave - octaves as i32),
        }
    }

    /// The fraction bits of 1 - n·h that the least octave's weights need.
    pub(super) fn versine_bits(&self, octaves: u32) -> u32 {
        octaves - 1 + self.octave_bits(octaves) + self.weight_bits
    }

    /// The light's polar angles in degrees that the bands of texels are of: rows, or slices.
    #[must_use]
    pub fn band_angles(&self) -> Vec<f64> {
        match &self.form {
            ImageForm::Bivariate { .. } => bivariate::angles(self.size as usize),
            ImageForm::Half { slices } => half::angles(*slices as usize),
            // Memories go by pairs: of an odd number of images the last is there twice.
            ImageForm::Paper { angles } if angles.len() % 2 == 1 => [&angles[..], &angles[angles.len() - 1..]].concat(),
            ImageForm::Paper { angles } => angles.clone(),
            ImageForm::Matcap => Vec::new(),
        }
    }

    /// Whether it is told of lights: else these are in what is stored.
    #[must_use]
    pub fn has_lights(&self) -> bool {
        self.form != ImageForm::Matcap
    }

    /// How many sets of texels are read in a clock: one for each light, or one.
    #[must_use]
    pub fn look_ups(&self) -> usize {
        if self.has_lights() { self.lights as usize } else { 1 }
    }

    /// The components of the normal that it is given, x first.
    #[must_use]
    pub fn normal_axes(&self) -> usize {
        if self.has_lights() { 3 } else { 2 }
    }

    /// The shifts by which a blended code is added to itself, one behind the other, so that the greatest, 1 - 2^-b of b
    /// bits, becomes 1 to an eighth of an output code: c / (1 - 2^-b) is c (1 + 2^-b) (1 + 2^-2b) (1 + 2^-4b) and so
    /// on. Of the form matcap, whose light has no gain that does it.
    pub(super) fn fills(&self) -> impl Iterator<Item = u32> + use<> {
        let enough = self.channel_bits + 4;
        std::iter::successors(Some(self.texel_bits), |bits| Some(2 * bits)).take_while(move |&bits| bits < enough)
    }

    /// Whether the normal is turned to each of two images by itself.
    #[must_use]
    pub fn has_turns(&self) -> bool {
        matches!(self.form, ImageForm::Paper { .. })
    }

    /// Fraction bits of the ports that turn it, whose unit is a right angle.
    pub const TURN_BITS: u32 = turn::ANGLE as u32;

    /// Whether n·l is multiplied with what the texels give; else they hold it.
    #[must_use]
    pub fn has_incidence(&self) -> bool {
        !matches!(self.form, ImageForm::Paper { .. } | ImageForm::Matcap)
    }

    /// The place in each direction, the outermost first, of what comes so many behind the first where so many places
    /// lie in each direction and those of the innermost come one behind the other.
    #[must_use]
    pub fn places(number: u64, counts: &[u32]) -> Vec<u64> {
        let mut rest = number;
        let mut places: Vec<u64> = counts
            .iter()
            .rev()
            .map(|&count| {
                let place = rest % u64::from(count);
                rest /= u64::from(count);
                place
            })
            .collect();
        places.reverse();
        places
    }

    /// How many texels lie in each direction, the outermost first: the bands, and what is in one of them; of the form
    /// matcap, which has none, along y and x.
    #[must_use]
    pub fn extents(&self) -> Vec<u32> {
        match self.form {
            ImageForm::Bivariate { .. } => vec![self.size; 2],
            ImageForm::Half { slices } => vec![slices, self.size, self.size],
            ImageForm::Paper { .. } => vec![self.band_angles().len() as u32, self.size, self.size],
            ImageForm::Matcap => vec![self.size; 2],
        }
    }

    /// The bits of a place that so many lie in a direction of.
    pub(super) fn place_bits(extent: u32) -> u32 {
        extent.next_power_of_two().ilog2()
    }

    /// The vectors of a light that the normal is multiplied by, beside its direction: their names and those of their
    /// components in the ports.
    #[must_use]
    pub fn frame(&self) -> &'static [(&'static str, &'static [char])] {
        match self.form {
            ImageForm::Bivariate { .. } => &[("h", &['x', 'y', 'z'])],
            ImageForm::Half { .. } | ImageForm::Paper { .. } => &[("u", &['x', 'y', 'z']), ("v", &['x', 'y'])],
            ImageForm::Matcap => &[],
        }
    }

    /// The format of a vector's component.
    #[must_use]
    pub fn vector(&self) -> Format {
        Format::signed(1, self.vector_fraction as i32)
    }
}
