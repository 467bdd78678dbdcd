//! The image-based block in real numbers, step by step towards what the hardware has.

use std::f64::consts::FRAC_PI_2;

use super::record::Turns;
use super::{FrontEnd, ImageBlock, ImageForm, LightRecord, record, turn};
use crate::fixed::exp2;
use crate::reflectance::Rgb;
use crate::reflectance::texels::pair;
use crate::reflectance::vector::{Light, Vector};

/// A light as the block is told of it, in real numbers; in the form matcap [`RealLight::none`].
#[derive(Clone, Debug, PartialEq)]
pub struct RealLight {
    direction: Vector,
    frame: Vec<f64>,
    turns: Option<Turns>,
    band: usize,
    /// The part of the next band in the blend.
    next: f64,
    /// What the squared blend, of texels from 0 to 1, and n·l are multiplied by.
    gain: Rgb,
}

impl RealLight {
    /// What stands for a light where none is told of: the picture is seen as it is.
    #[must_use]
    pub fn none() -> Self {
        Self { direction: Vector::z(), frame: Vec::new(), turns: None, band: 0, next: 0.0, gain: [1.0; 3] }
    }
}

/// Which texels are blended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RealTexels {
    /// The roots of the reflectance where the texels lie.
    Exact,
    /// Their codes.
    Stored,
}

/// Where texels are looked up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Places {
    /// Where the normal leads to.
    Exact,
    /// At the multiples of a weight's last bit that the hardware has.
    Rounded,
}

/// A place between two texels: the first, and the weight of the next.
type Place = (usize, f64);

impl ImageBlock {
    /// A light of an intensity a channel, not rounded.
    #[must_use]
    pub fn real_light(&self, light: Light, intensity: Rgb) -> RealLight {
        let pair = pair(&self.image.band_angles(), light.phi);
        let (band, t) = record::bands(pair);
        let [own, next] = self.texels.weights([band, band + 1], t);
        let weight = own + next;
        RealLight {
            direction: light.direction(),
            frame: record::frame(&self.image, light),
            turns: record::turns(&self.image, light.phi),
            band,
            next: if weight > 0.0 { next / weight } else { 0.0 },
            gain: if light.phi < 180.0 { intensity.map(|part| part * weight * weight) } else { [0.0; 3] },
        }
    }

    /// What a light's record stands for.
    #[must_use]
    pub fn light_of(&self, record: &LightRecord) -> RealLight {
        let vector = exp2(-(self.image.vector_fraction as i32));
        let [x, y, z] = record.direction.unwrap_or_default().map(|code| code as f64 * vector);
        let angle = |code: i64| code as f64 * exp2(-turn::ANGLE);
        let odd = record.blend as f64 * exp2(-(self.image.weight_bits as i32));
        let gain = exp2(record.shift.unwrap_or(0) as i32 - self.widths.gain) / record::unit(&self.image);
        RealLight {
            direction: Vector::new(x, y, z),
            frame: record.frame.iter().map(|&code| code as f64 * vector).collect(),
            turns: record.turns.map(|[even, odd, alone]| Turns { halves: [even, odd].map(angle), alone: alone != 0 }),
            band: record.band as usize,
            next: if record.band % 2 == 0 { odd } else { 1.0 - odd },
            gain: record.gain.map(|code| code as f64 * gain),
        }
    }

    /// The light that the codes of its ports tell: what a record stands for, or what follows exactly from a vector and
    /// an intensity.
    #[must_use]
    pub fn told_light(&self, light: &[i64]) -> RealLight {
        if self.image.front_end == FrontEnd::Record {
            return self.light_of(&self.model().record(light));
        }
        let (vector, gain) = (exp2(-(self.image.vector_fraction as i32)), exp2(-self.widths.gain));
        let direction = Vector::from_fn(|axis, _| light[axis] as f64 * vector);
        let intensity = [3, 4, 5].map(|place: usize| (light[place] as f64 * gain).min(1.0));
        RealLight { direction, ..self.real_light(Light::towards(direction), intensity) }
    }

    /// A scalar product that a place follows from.
    fn product(&self, a: &[f64], b: &[f64], places: Places) -> f64 {
        let products = a.iter().zip(b).map(|(a, b)| a * b);
        match places {
            Places::Exact => products.sum(),
            Places::Rounded => {
                let steps = exp2(self.widths.place);
                products.map(|product| (product * steps).floor() / steps).sum()
            }
        }
    }

    /// A place, counted from the first centre, as it is looked up: rounded down, with `half` to the nearest.
    fn place(&self, exact: f64, places: Places, half: f64) -> Place {
        let last = f64::from(self.image.size - 1);
        let steps = exp2(self.image.weight_bits as i32);
        let place = match places {
            Places::Exact => exact,
            Places::Rounded => (exact * steps + half).floor() / steps,
        };
        let place = place.clamp(0.0, last);
        let first = place.floor().min(last - 1.0);
        (first as usize, place - first)
    }

    /// Where the normal lies along x in both images of the form paper, and along y, exactly.
    fn turned(&self, [nx, ny, nz]: [f64; 3], frame: &[f64], turns: &Turns) -> ([f64; 2], f64) {
        let (across, turn) = frame.split_at(3);
        let (x, y) = (nx * turn[1] - ny * turn[0], nx * turn[0] + ny * turn[1]);
        let length = libm::hypot(x, nz);
        let distance = (nx * across[0] + ny * across[1] + nz * across[2]).abs();
        // Where the normal has no part in the plane of light and viewer no turn moves it.
        let tilt = if length > 0.0 { (distance / length).min(1.0) } else { 1.0 };
        let tilt = if turns.alone { 0.5 } else { tilt };
        let x = turns.halves.map(|half| {
            let angle = (half + half * tilt) * FRAC_PI_2;
            let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
            if x * sine > nz * cosine { f64::INFINITY.copysign(half) } else { x * cosine + nz * sine }
        });
        (x, y)
    }

    /// Where the normal lies in a band with an even number and in one with an odd number, the outermost direction
    /// first.
    fn places(&self, n: &[f64; 3], light: &RealLight, places: Places) -> Vec<[Place; 2]> {
        let frame = &light.frame;
        let size = f64::from(self.image.size);
        let between = |component: f64| [self.place((component * size + size - 1.0) / 2.0, places, 0.5); 2];
        match self.image.form {
            ImageForm::Bivariate { octaves } => {
                let apart: Vec<f64> = n.iter().zip(frame).map(|(n, h)| n - h).collect();
                let steps = exp2(self.image.octave_bits(octaves) as i32);
                let u = (self.product(&apart, &apart, places) / 2.0).min(1.0 - 0.5 / steps);
                let exponent = if u > 0.0 { (libm::ilogb(u) + octaves as i32).max(0) } else { 0 };
                let rest = match exponent {
                    0 => u * exp2(octaves as i32 - 1),
                    _ => u * exp2(octaves as i32 - exponent) - 1.0,
                };
                vec![[self.place((f64::from(exponent) + rest) * steps, places, 0.0); 2]]
            }
            ImageForm::Half { .. } => {
                let across = |axis: &[f64]| between(self.product(&n[..axis.len()], axis, places));
                vec![across(&frame[3..5]), across(&frame[..3])]
            }
            ImageForm::Matcap => vec![between(n[1]), between(n[0])],
            ImageForm::Paper { .. } => {
                let turns = light.turns.as_ref().expect("the turns of the form paper");
                if places == Places::Rounded {
                    let codes = |values: &[f64], bits: i32| -> Vec<i64> {
                        values.iter().map(|value| libm::round(value * exp2(bits)) as i64).collect()
                    };
                    let vector = self.image.vector_fraction as i32;
                    let turns = [codes(&turns.halves, turn::ANGLE), vec![turns.alone.into()]].concat();
                    let (xs, y) = self.model().turned(&codes(n, vector), &codes(frame, vector), &turns);
                    return [[y; 2], xs].map(|two| two.map(|(place, weight)| (place, weight.to_num()))).to_vec();
                }
                let (xs, y) = self.turned(*n, frame, turns);
                [[y; 2], xs].map(|two| two.map(|x| self.place((x * size + size - 1.0) / 2.0, places, 0.5))).to_vec()
            }
        }
    }

    /// A texel's channels, from 0 to 1: the roots of the reflectance over its band's cap.
    fn roots(&self, texels: RealTexels, place: usize) -> Rgb {
        match texels {
            RealTexels::Stored => [0, 1, 2].map(|channel| f64::from(self.texels.codes()[place][channel])),
            RealTexels::Exact => {
                let caps = self.texels.caps();
                let cap = caps[place / (self.samples.data.len() / caps.len())];
                let root = |sample| if cap > 0.0 { libm::sqrt((f64::from(sample) / cap).clamp(0.0, 1.0)) } else { 0.0 };
                self.samples.data[place].map(root)
            }
        }
    }

    /// The blend of the texels about a place, of which the directions before these are followed already.
    fn blend(
        &self,
        texels: RealTexels,
        places: &[[Place; 2]],
        extents: &[u32],
        before: usize,
        band: Option<usize>,
    ) -> Rgb {
        let Some((of_bands, rest)) = places.split_first() else { return self.roots(texels, before) };
        let (place, weight) = of_bands[band.unwrap_or(0) % 2];
        let extent = extents[0] as usize;
        let at = |place: usize| self.blend(texels, rest, &extents[1..], before * extent + place, band.or(Some(place)));
        let own = at(place);
        if weight == 0.0 {
            return own;
        }
        let next = at(place + 1);
        [0, 1, 2].map(|channel| own[channel] * (1.0 - weight) + next[channel] * weight)
    }

    /// What a light gives to the channels, 1 at full scale and not clamped.
    #[must_use]
    pub fn real(&self, n: Vector, light: &RealLight, texels: RealTexels, places: Places) -> Rgb {
        let incidence = if self.image.has_incidence() { n.dot(&light.direction).max(0.0) } else { 1.0 };
        let has_lights = self.image.has_lights();
        if has_lights && (n.z <= 0.0 || incidence == 0.0) {
            return [0.0; 3];
        }
        let mut all = Vec::with_capacity(3);
        if has_lights {
            all.push([(light.band, light.next); 2]);
        }
        all.extend(self.places(&[n.x, n.y, n.z], light, places));
        let roots = self.blend(texels, &all, &self.image.extents(), 0, None);
        [0, 1, 2].map(|channel| light.gain[channel] * roots[channel] * roots[channel] * incidence)
    }
}
