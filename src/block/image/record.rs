//! What a core is told of a light.

use super::{Image, ImageBlock, ImageForm, turn};
use crate::block::shader::unit as check_unit;
use crate::fixed::exp2;
use crate::platform::error::Error;
use crate::reflectance::texels::{Pair, pair};
use crate::reflectance::vector::{Light, Vector, sine_cosine};

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
    /// What the squared blend and n·l are multiplied by, a channel each: a fraction times two to the power of the
    /// shift.
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

/// The shift that makes a fraction of a gain.
pub(super) fn shift(gain: f64) -> i32 {
    (0..=1023).find(|&shift| gain < exp2(shift)).unwrap_or_default()
}

impl ImageBlock {
    /// The record of a light of an intensity a channel.
    ///
    /// # Errors
    /// An intensity that is not from 0 to 1.
    pub fn record(&self, light: Light, intensity: [f64; 3]) -> Result<LightRecord, Error> {
        check_unit("intensity", &intensity)?;
        let Self { image, widths, texels, .. } = self;
        let nearest = |value: f64, frac_bits: i32| libm::round(value * exp2(frac_bits)) as i64;
        let component = |value: f64| nearest(value, image.vector_fraction as i32);
        let direction = light.direction();
        let (band, t) = bands(pair(&image.band_angles(), light.phi));
        let [own, next] = texels.weights([band, band + 1], t);
        let weight = own + next;
        let next = if weight > 0.0 { next / weight } else { 0.0 };
        // The odd band is the next one of an even band, and an odd band itself.
        let odd = if band.is_multiple_of(2) { next } else { 1.0 - next };
        // Behind the object nothing that is seen is lit.
        let gain = if light.phi < 180.0 { gain(image, weight) } else { 0.0 };
        let gains = intensity.map(|intensity| gain * intensity);
        let shift = shift(gains.into_iter().fold(0.0, f64::max)).min(widths.shift);
        let most = (1i64 << widths.gain) - 1;
        Ok(LightRecord {
            direction: image.has_incidence().then(|| [direction.x, direction.y, direction.z].map(component)),
            frame: frame(image, light).into_iter().map(component).collect(),
            band: band as i64,
            blend: nearest(odd, image.weight_bits as i32),
            turns: turns(image, light.phi).map(|Turns { halves, alone }| {
                let [even, odd] = halves.map(|half| nearest(half, turn::ANGLE));
                [even, odd, alone.into()]
            }),
            shift: (widths.shift > 0).then_some(shift.into()),
            // A gain just below a power of two is rounded up to it.
            gain: gains.map(|gain| nearest(gain, widths.gain - shift).min(most)),
        })
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
