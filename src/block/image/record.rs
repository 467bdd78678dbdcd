//! What a core is told of a light.

use super::{Banks, Image, ImageForm, ImageWidths};
use crate::fixed::exp2;
use crate::reflectance::texels::pair;
use crate::reflectance::vector::{Light, Vector, sine_cosine};

/// The codes of a light's ports.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LightRecord {
    /// The direction to the light.
    pub direction: [i64; 3],
    /// The vectors of [`Image::frame`], component by component: the half vector of light and viewer, or the rows of the
    /// turn into its frame.
    pub frame: Vec<i64>,
    /// The band of texels of the light's angle.
    pub band: i64,
    /// The part of the band with an odd number in the blend of this band with the next.
    pub blend: i64,
    /// The exponent of the gain; none where all lights have 0.
    pub shift: Option<i64>,
    /// What the squared blend and n·l are multiplied by, a channel each: a fraction times two to the power of the
    /// shift.
    pub gain: [i64; 3],
}

/// The gain of a light of intensity 1 where the cap is 1: codes stand for multiples of 2^-bits here, of 1/(2^bits - 1)
/// in the texels and of 2^bits/(2^bits - 1) in the output.
pub(super) fn unit(image: &Image) -> f64 {
    let steps = exp2(image.texel_bits as i32);
    let root = steps / (steps - 1.0);
    root * root * image.full_scale() as f64 * exp2(-(image.channel_bits as i32))
}

/// The vectors of a light that the normal is multiplied by, beside its direction.
fn frame(image: &Image, light: Light) -> Vec<f64> {
    match image.form {
        ImageForm::Bivariate { .. } => {
            // Behind the object the half vector vanishes, and nothing that is seen is lit.
            let sum = light.direction() + Vector::z();
            let half = if light.phi < 180.0 { sum.normalize() } else { Vector::z() };
            vec![half.x, half.y, half.z]
        }
        // Ry(-φ/2) Rz(-γ).
        ImageForm::Half { .. } => {
            let [gs, gc] = sine_cosine(-light.gamma);
            let [hs, hc] = sine_cosine(-0.5 * light.phi);
            vec![gc * hc, -gs * hc, hs, gs, gc]
        }
    }
}

/// The band of texels of a light's polar angle in degrees, and the weight of the next: past the last band that one
/// alone is the next of the one before.
fn band(image: &Image, phi: f64) -> (usize, f64) {
    let pair = pair(&image.bands(), phi);
    match pair.second {
        Some(_) => (pair.first, pair.t),
        None if pair.first == 0 => (0, 0.0),
        None => (pair.first - 1, 1.0),
    }
}

/// What the squared blend of a light's bands and n·l are multiplied by, where its intensity is 1; and the part of the
/// next band in the blend.
fn gain_and_next(image: &Image, banks: &Banks, phi: f64) -> (f64, f64) {
    let (band, t) = band(image, phi);
    let weights = [(1.0 - t) * banks.texels.weight(band), t * banks.texels.weight(band + 1)];
    let weight = weights[0] + weights[1];
    let next = if weight > 0.0 { weights[1] / weight } else { 0.0 };
    // Behind the object nothing that is seen is lit.
    (if phi < 180.0 { weight * weight * unit(image) } else { 0.0 }, next)
}

/// The gain of a light of intensity 1.
pub(super) fn gain(image: &Image, banks: &Banks, phi: f64) -> f64 {
    gain_and_next(image, banks, phi).0
}

/// The shift that makes a fraction of a gain.
pub(super) fn shift(gain: f64) -> i32 {
    (0..).find(|&shift| gain < exp2(shift)).unwrap_or_default()
}

impl LightRecord {
    /// The record of a light of an intensity a channel, each from 0 to 1.
    #[must_use]
    pub fn new(image: &Image, widths: &ImageWidths, banks: &Banks, light: Light, intensity: [f64; 3]) -> Self {
        let nearest = |value: f64, frac_bits: i32| libm::round(value * exp2(frac_bits)) as i64;
        let component = |value: f64| nearest(value, image.vector_fraction as i32);
        let direction = light.direction();
        let (band, _) = band(image, light.phi);
        let (gain, next) = gain_and_next(image, banks, light.phi);
        // The odd band is the next one of an even band, and an odd band itself.
        let odd = if band % 2 == 0 { next } else { 1.0 - next };
        let largest = intensity.into_iter().fold(0.0, f64::max);
        let shift = shift(gain * largest).min(widths.shift);
        let most = (1i64 << widths.gain) - 1;
        Self {
            direction: [direction.x, direction.y, direction.z].map(component),
            frame: frame(image, light).into_iter().map(component).collect(),
            band: band as i64,
            blend: nearest(odd, image.weight_bits as i32),
            shift: (widths.shift > 0).then_some(shift.into()),
            gain: intensity.map(|intensity| nearest(gain * intensity, widths.gain - shift).min(most)),
        }
    }

    /// The codes in the order of the ports.
    #[must_use]
    pub fn codes(&self) -> Vec<i64> {
        let shift: Vec<i64> = self.shift.into_iter().collect();
        [&self.direction[..], &self.frame, &[self.band, self.blend], &shift, &self.gain].concat()
    }
}
