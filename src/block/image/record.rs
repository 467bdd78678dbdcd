//! What a core is told of a light.
//!
//! A record is made in integers alone, from a light in fixed-point numbers and a table with a row a band, so that a
//! driver without floating point computes the same one: `model/NAME_light.c` is this file in C99. What is kept on the
//! way is so fine that a code is the nearest to its exact value but for one in millions.

use super::turn::{ANGLE, MOST_HALF};
use super::{FrontEnd, GAIN_INT, Image, ImageBlock, ImageForm, ImageWidths};
use crate::block::shader::unit as check_unit;
use crate::fixed::{exp2, turn};
use crate::platform::error::{Error, refuse};
use crate::reflectance::Rgb;
use crate::reflectance::texels::{Pair, Texels, pair};
use crate::reflectance::vector::{Light, Vector, sine_cosine};

/// A light in fixed-point numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FixedLight {
    /// The polar angle from the viewer's direction, in 2^-64 turns: 180 degrees are 2^63, and what is more is taken for
    /// that.
    pub phi: u64,
    /// The azimuth, in 2^-64 turns.
    pub gamma: u64,
    /// The intensity a channel, of which 2^63 are 1; what is more is taken for that.
    pub intensity: [u64; 3],
}

impl FixedLight {
    /// A light of an intensity a channel.
    ///
    /// # Errors
    /// An intensity that is not from 0 to 1.
    pub fn new(light: Light, intensity: [f64; 3]) -> Result<Self, Error> {
        check_unit("intensity", &intensity)?;
        let intensity = intensity.map(|part| (part * exp2(63)) as u64);
        Ok(Self { phi: turn::of_degrees(light.phi), gamma: turn::of_degrees(light.gamma), intensity })
    }
}

/// What records are made with, beside the form: a row a band, and where the binary points lie.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RecordTable {
    /// The bands, ascending.
    pub bands: Vec<RecordBand>,
    /// Fraction bits of the roots, of which each is below 2^48.
    pub root_bits: u32,
    /// Fraction bits of a gain, which is below 2^62.
    pub gain_bits: u32,
}

/// A band, as records are made with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RecordBand {
    /// Its angle, in 2^-64 turns.
    pub angle: u64,
    /// 2^116 over what lies between its angle and the next one's, rounded down; the last has none.
    pub reciprocal: u64,
    /// The root of the gain of a light of intensity 1 at its angle.
    pub root: u64,
}

impl RecordTable {
    /// Fraction bits of a reciprocal: [`RecordBand::reciprocal`] times an angle is a number of 2^-116, of which
    /// [`turn::FRACTION`] bits are kept.
    pub const RECIPROCAL_BITS: u32 = 116;

    /// The table for these texels.
    pub(super) fn new(image: &Image, widths: &ImageWidths, texels: &Texels) -> Self {
        // No gain reaches two to the power of both.
        let root_int = (widths.shift + GAIN_INT).unsigned_abs().div_ceil(2);
        let (root_bits, gain_bits) = (48 - root_int, turn::FRACTION - 2 * root_int);
        let angles: Vec<u64> = image.band_angles().into_iter().map(turn::of_degrees).collect();
        let band = |(number, &angle): (usize, &u64)| {
            let root = texels.weight(number) * libm::sqrt(unit(image));
            let apart = angles.get(number + 1).map(|next| u128::from(next - angle));
            // An image that is there twice has no light between.
            let reciprocal =
                apart.map_or(0, |apart| (1u128 << Self::RECIPROCAL_BITS).checked_div(apart).unwrap_or_default());
            debug_assert!(reciprocal < 1 << 64, "bands are more than a fifth of an arc minute apart");
            RecordBand { angle, reciprocal: reciprocal as u64, root: libm::round(root * exp2(root_bits as i32)) as u64 }
        };
        Self { bands: angles.iter().enumerate().map(band).collect(), root_bits, gain_bits }
    }

    /// The first of the two bands that are blended, and the part of the next, of which [`turn::ONE`] are 1: 0 before
    /// the first band, 1 past the last.
    fn place(&self, phi: u64) -> (usize, u64) {
        let last = self.bands.len() - 1;
        let above = self.bands.partition_point(|band| band.angle <= phi);
        let first = above.saturating_sub(1).min(last - 1);
        let RecordBand { angle, reciprocal, .. } = self.bands[first];
        let part = match above {
            0 => 0,
            _ if above > last => turn::ONE,
            _ => turn::product(phi - angle, reciprocal, Self::RECIPROCAL_BITS - turn::FRACTION),
        };
        (first, part)
    }

    /// The ports that turn the normal to the images of the form paper: [`LightRecord::turns`] at this angle, `band` the
    /// first of both.
    fn turns(&self, phi: u64, band: usize) -> [i64; 3] {
        let half = |band: usize| {
            let angle = self.bands[band].angle;
            let magnitude = (angle.abs_diff(phi) + (1 << (62 - ANGLE))) >> (63 - ANGLE);
            // One of an image without a weight may be more.
            let code = magnitude.min(MOST_HALF) as i64;
            if angle < phi { -code } else { code }
        };
        let [even, odd] = if band.is_multiple_of(2) { [band, band + 1] } else { [band + 1, band] }.map(half);
        let (first, last) = (self.bands[0].angle, self.bands[self.bands.len() - 1].angle);
        [even, odd, (phi < first || phi >= last).into()]
    }
}

/// The codes of a light's ports.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LightRecord {
    /// The direction to the light; none where the texels hold n·l.
    pub direction: Option<[i64; 3]>,
    /// The vectors of [`Image::frame`], component by component: the half vector of light and viewer, or the rows of the
    /// turn into its frame.
    pub frame: Vec<i64>,
    /// The band of texels of the light's angle.
    pub band: i64,
    /// The part of the band with an odd number in the blend of this band with the next.
    pub blend: i64,
    /// Of the form paper half of the way in right angles to the image with an even number and to that with an odd one,
    /// and 1 where a single image is looked up.
    pub turns: Option<[i64; 3]>,
    /// The exponent of the gain; none where all lights have 0.
    pub shift: Option<i64>,
    /// What the squared blend and n·l are multiplied by, a channel each: this times two to the power of
    /// the shift.
    pub gain: [i64; 3],
}

/// The gain of a light of intensity 1 where the cap is 1. A texel's code c is c 2^-b in the datapath, b its bits, and
/// stands for c/(2^b - 1) of the root of the cap; full scale of a channel of b bits is (2^b - 1) 2^-b.
pub(super) fn unit(image: &Image) -> f64 {
    let steps = exp2(image.texel_bits as i32);
    let root = steps / (steps - 1.0);
    root * root * image.full_scale() as f64 * exp2(-(image.channel_bits as i32))
}

/// The vectors of a light that the normal is multiplied by, beside its direction.
pub(super) fn frame(image: &Image, light: Light) -> Vec<f64> {
    match image.form {
        ImageForm::Bivariate { .. } => {
            // Behind the object the half vector vanishes, and nothing that is seen is lit.
            let sum = light.direction() + Vector::z();
            let half = if light.phi < 180.0 { sum.normalize() } else { Vector::z() };
            vec![half.x, half.y, half.z]
        }
        // Ry(-φ/2) Rz(-γ), of which the form paper takes the first row for sin αh, and the second for its own turn.
        ImageForm::Half { .. } | ImageForm::Paper { .. } => {
            let [gs, gc] = sine_cosine(-light.gamma);
            let [hs, hc] = sine_cosine(-0.5 * light.phi);
            vec![gc * hc, -gs * hc, hs, gs, gc]
        }
        ImageForm::Matcap => Vec::new(),
    }
}

/// The first of two neighbouring bands and the part of the next: past the last band, that one alone is the next of the
/// one before.
pub(super) fn bands(pair: Pair) -> (usize, f64) {
    match pair.second {
        Some(_) => (pair.first, pair.t),
        None if pair.first == 0 => (0, 0.0),
        None => (pair.first - 1, 1.0),
    }
}

/// The turns of a light in the form paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Turns {
    /// Half of the way to the image with an even number and to that with an odd one, in right angles.
    pub(super) halves: [f64; 2],
    /// Whether a single image is looked up.
    pub(super) alone: bool,
}

/// Those of a light's angle.
pub(super) fn turns(image: &Image, phi: f64) -> Option<Turns> {
    image.has_turns().then(|| {
        let angles = image.band_angles();
        let pair = pair(&angles, phi);
        let (band, _) = bands(pair);
        let half = |band: usize| (angles[band] - phi) / 180.0;
        let halves = if band.is_multiple_of(2) { [band, band + 1] } else { [band + 1, band] }.map(half);
        // The image that a single one is of has the whole weight; where the other is does not matter.
        Turns { halves: halves.map(|half| half.clamp(-0.5, 0.5)), alone: pair.second.is_none() }
    })
}

/// The gain of a light of intensity 1 whose bands have this weight together.
pub(super) fn gain(image: &Image, weight: f64) -> f64 {
    weight * weight * unit(image)
}

/// The shift that a gain is below two to the power of [`GAIN_INT`] with.
pub(super) fn shift(gain: f64) -> i32 {
    (0..=1023).find(|&shift| gain < exp2(shift + GAIN_INT)).unwrap_or_default()
}

/// The codes of a light's vectors beside its direction, and what else depends on the form: the one place for both.
fn frame_codes(image: &Image, phi: u64, gamma: u64) -> Vec<i64> {
    let [gamma_sine, gamma_cosine] = turn::sine_cosine(gamma);
    let [half_sine, half_cosine] = turn::sine_cosine(phi / 2);
    let components = match image.form {
        ImageForm::Bivariate { .. } if phi == turn::HALF => vec![0, 0, turn::ONE as i64],
        ImageForm::Bivariate { .. } => {
            vec![turn::times(half_sine, gamma_cosine), turn::times(half_sine, gamma_sine), half_cosine]
        }
        ImageForm::Half { .. } | ImageForm::Paper { .. } => vec![
            turn::times(gamma_cosine, half_cosine),
            turn::times(gamma_sine, half_cosine),
            -half_sine,
            -gamma_sine,
            gamma_cosine,
        ],
        ImageForm::Matcap => Vec::new(),
    };
    components.into_iter().map(|component| turn::code(component, image.vector_fraction)).collect()
}

impl ImageBlock {
    /// The record of a light of an intensity a channel.
    ///
    /// # Errors
    /// An intensity that is not from 0 to 1; the form matcap, which is told of no lights.
    pub fn record(&self, light: Light, intensity: [f64; 3]) -> Result<LightRecord, Error> {
        self.fixed_light(light, intensity).map(|light| self.fixed_record(&light))
    }

    /// A light of an intensity a channel in fixed-point numbers.
    ///
    /// # Errors
    /// The form matcap, which is told of no lights; an intensity that is not from 0 to 1.
    pub fn fixed_light(&self, light: Light, intensity: [f64; 3]) -> Result<FixedLight, Error> {
        refuse!(
            !self.image.has_lights(),
            "a core of the form matcap has no lights",
            "its light is in its picture: an image-based block of another form takes records of lights"
        );
        FixedLight::new(light, intensity)
    }

    /// The record of a light in fixed-point numbers.
    ///
    /// # Panics
    /// In the form matcap, which is told of no lights.
    #[must_use]
    pub fn fixed_record(&self, light: &FixedLight) -> LightRecord {
        let Self { image, widths, records, .. } = self;
        assert!(image.has_lights(), "a form with lights");
        let phi = light.phi.min(turn::HALF);
        let component = |sine: i64| turn::code(sine, image.vector_fraction);
        let [sine, cosine] = turn::sine_cosine(phi);
        let [gamma_sine, gamma_cosine] = turn::sine_cosine(light.gamma);
        let direction = [turn::times(sine, gamma_cosine), turn::times(sine, gamma_sine), cosine];
        let (band, t) = records.place(phi);
        let own = turn::product(turn::ONE - t, records.bands[band].root, turn::FRACTION);
        let next = turn::product(t, records.bands[band + 1].root, turn::FRACTION);
        let weight = own + next;
        // The odd band is the next one of an even band, and an odd band itself.
        let odd = if band.is_multiple_of(2) { next } else { own };
        let blend = match weight {
            // Without a weight the band itself.
            0 => {
                if band.is_multiple_of(2) {
                    0
                } else {
                    1 << image.weight_bits
                }
            }
            _ => ((odd << (image.weight_bits + 1)) + weight) / (2 * weight),
        };
        // Behind the object nothing that is seen is lit.
        let gain = match phi {
            turn::HALF => 0,
            _ => turn::product(weight, weight, 2 * records.root_bits - records.gain_bits),
        };
        let gains = light.intensity.map(|intensity| turn::product(gain, intensity.min(turn::HALF), 63));
        let greatest = gains.into_iter().fold(0, u64::max);
        let shift = (0..widths.shift).find(|&shift| greatest >> (records.gain_bits + (shift + GAIN_INT) as u32) == 0);
        let shift = shift.unwrap_or(widths.shift);
        let dropped = records.gain_bits + shift as u32 - widths.gain as u32;
        let most = widths.gain_format().max_code() as i64;
        LightRecord {
            direction: image.has_incidence().then(|| direction.map(component)),
            frame: frame_codes(image, phi, light.gamma),
            band: band as i64,
            blend: blend as i64,
            turns: image.has_turns().then(|| records.turns(phi, band)),
            shift: (widths.shift > 0).then_some(shift.into()),
            // A gain just below a power of two is rounded up to it.
            gain: gains.map(|gain| (((gain + (1 << (dropped - 1))) >> dropped) as i64).min(most)),
        }
    }

    /// What records are made with.
    #[must_use]
    pub fn record_table(&self) -> &RecordTable {
        &self.records
    }
}

impl ImageBlock {
    /// The codes of a unit vector.
    #[must_use]
    pub fn vector(&self, v: Vector) -> [i64; 3] {
        [v.x, v.y, v.z].map(|component| self.component(component))
    }

    /// The code of a vector's component.
    #[must_use]
    pub fn component(&self, value: f64) -> i64 {
        libm::round(value * exp2(self.image.vector_fraction as i32)) as i64
    }

    /// The codes of a light's ports, in their order: of its record, or of what a core is told that makes it itself.
    #[must_use]
    pub fn light_codes(&self, light: &FixedLight) -> Vec<i64> {
        let record = self.fixed_record(light);
        match self.image.front_end {
            FrontEnd::Record => record.codes(),
            FrontEnd::Vector => {
                let bits = self.widths.gain as u32;
                // To the nearest, of 2^63 parts.
                let part = |part: u64| ((part.min(turn::HALF) + (1 << (62 - bits))) >> (63 - bits)) as i64;
                record.direction.into_iter().flatten().chain(light.intensity.map(part)).collect()
            }
        }
    }

    /// The inputs of a clock: of a normal, and of the lights of that clock, of which those that are missing give
    /// nothing; in the form matcap of the normal alone.
    ///
    /// # Panics
    /// On an intensity that is not from 0 to 1.
    #[must_use]
    pub fn inputs(&self, n: Vector, lights: &[(Light, Rgb)]) -> Vec<i64> {
        let missing = (Light::new(0.0, 0.0), [0.0; 3]);
        let all = lights.iter().copied().chain(std::iter::repeat(missing));
        let records = all.take(self.image.lights as usize).flat_map(|(light, intensity)| {
            self.light_codes(&FixedLight::new(light, intensity).expect("an intensity from 0 to 1"))
        });
        self.vector(n).into_iter().take(self.image.normal_axes()).chain(records).collect()
    }

    /// The inputs of a sample, clock by clock: one clock at least, however many lights there are, and no more in the
    /// form matcap.
    ///
    /// # Panics
    /// As [`ImageBlock::inputs`].
    #[must_use]
    pub fn clocks(&self, n: Vector, lights: &[(Light, Rgb)]) -> Vec<Vec<i64>> {
        if !self.image.has_lights() {
            return vec![self.inputs(n, &[])];
        }
        let a_clock = self.image.lights as usize;
        let clocks = lights.len().div_ceil(a_clock).max(1);
        (0..clocks).map(|clock| self.inputs(n, lights.get(clock * a_clock..).unwrap_or_default())).collect()
    }
}

impl LightRecord {
    /// The codes in the order of the ports.
    #[must_use]
    pub fn codes(&self) -> Vec<i64> {
        let Self { direction, frame, band, blend, turns, shift, gain } = self;
        let direction = direction.iter().flatten();
        let rest = turns.iter().flatten().chain(shift).chain(gain);
        direction.chain(frame).chain([band, blend]).chain(rest).copied().collect()
    }
}
