//! Inputs of an image-based block.

use super::edges::inverse;
use super::sample::{cross, normalised, plus, random_codes, random_direction};
use super::{Direction, ImageDesign};
use crate::block::image::{FrontEnd, Image, ImageForm, LightJoints};
use crate::fixed::{Rng, exp2};
use crate::reflectance::{Light, Rgb, Vector};

fn vector([x, y, z]: [f64; 3]) -> Vector {
    Vector::new(x, y, z)
}

/// A direction that the viewer sees.
fn visible(rng: &mut Rng) -> [f64; 3] {
    let [x, y, z] = random_direction(rng);
    [x, y, z.abs()]
}

/// 2 to the power of minus a random number below `most`.
fn small(most: u64, rng: &mut Rng) -> f64 {
    exp2(-(rng.below(most) as i32))
}

/// -1 over an odd number, modulo a power of two.
fn opposite(odd: i64, bits: u32) -> i64 {
    inverse(odd, bits).wrapping_neg() & ((1 << bits) - 1)
}

/// The places of a light's ports among its own.
struct LightPlaces {
    /// Of the z of its direction.
    z: Option<usize>,
    /// Those of its record; none where that is computed.
    record: Option<RecordPlaces>,
    /// Of what its brightness follows: the gain, or the intensity.
    gain: usize,
}

/// Those of a record.
struct RecordPlaces {
    frame: usize,
    band: usize,
    blend: usize,
    shift: Option<usize>,
}

impl LightPlaces {
    fn shift(&self) -> Option<usize> {
        self.record.as_ref().and_then(|record| record.shift)
    }

    /// Those of a record that is told.
    fn told(self) -> RecordPlaces {
        self.record.expect("a record that is told")
    }
}

impl ImageDesign<'_> {
    fn light_places(self) -> LightPlaces {
        let z = self.of.image.has_incidence().then_some(2);
        let frame = z.map_or(0, |z| z + 1);
        if self.of.image.front_end == FrontEnd::Vector {
            return LightPlaces { z, record: None, gain: frame };
        }
        let band = frame + self.of.image.frame().iter().map(|(_, axes)| axes.len()).sum::<usize>();
        let shift = band + 2 + if self.of.image.has_turns() { 3 } else { 0 };
        let has_shift = self.block.widths().shift > 0;
        let record = RecordPlaces { frame, band, blend: band + 1, shift: has_shift.then_some(shift) };
        LightPlaces { z, record: Some(record), gain: shift + usize::from(has_shift) }
    }

    /// The greatest code of the ports of a gain, or that of an intensity of 1.
    fn brightest(self) -> i64 {
        match self.of.image.front_end {
            FrontEnd::Record => self.block.widths().gain_format().max_code() as i64,
            FrontEnd::Vector => 1 << self.block.widths().gain,
        }
    }

    /// A random sample: any normal that is seen, half of the lights anywhere and the others where the normal is near
    /// the half vector or the light near the horizon.
    #[must_use]
    pub fn random(self, rng: &mut Rng) -> Vec<i64> {
        let n = visible(rng);
        if !self.of.image.has_lights() {
            return self.inputs(vector(n), &[]);
        }
        let lights: Vec<(Light, Rgb)> = (0..self.of.image.lights)
            .map(|_| {
                let anywhere = random_direction(rng);
                let l = match rng.below(6) {
                    0..3 => anywhere,
                    // n halfway between the light and the viewer, or nearly.
                    3 | 4 => {
                        let half = normalised(plus(n, anywhere, small(12, rng)));
                        plus(half.map(|c| 2.0 * half[2] * c), [0.0, 0.0, 1.0], -1.0)
                    }
                    _ => {
                        let across = normalised(cross(n, anywhere));
                        let sign = if rng.below(2) == 0 { 1.0 } else { -1.0 };
                        normalised(plus(across, n, sign * small(16, rng)))
                    }
                };
                let intensity = match rng.below(4) {
                    0 => [1.0; 3],
                    1 => [rng.unit() * small(8, rng); 3],
                    _ => [rng.unit(), rng.unit(), rng.unit()],
                };
                (Light::towards(vector(l)), intensity)
            })
            .collect();
        self.inputs(vector(n), &lights)
    }

    /// Codes that lead to a place among the texels, in parts of a weight's last bit from the first of each direction,
    /// the band's outermost; with a great gain for which no channel is at full scale. No unit vector need be there.
    #[must_use]
    pub fn at_texels(self, places: &[u64]) -> Vec<i64> {
        if !self.of.image.has_lights() {
            return self.at_place([places[1], places[0]]);
        }
        let (mut codes, gain) = self.towards_texels(places);
        self.tune_gain(&mut codes, gain);
        codes
    }

    /// The same, where every channel is about to take its next code, and where it just has.
    #[must_use]
    pub fn at_steps(self, places: &[u64]) -> [Vec<i64>; 2] {
        self.steps_of(self.at_texels(places))
    }

    /// Of the form paper a turn by an angle from -1 to 1 right angles to the image of this number, beside the place
    /// where its texels differ most in a row, where every channel is about to take its next code and where it just has.
    /// `rest` is 1 - y², and with it the row of the table of reciprocal roots; without one y is where that place is.
    #[must_use]
    pub fn at_turn(self, angle: f64, band: usize, rest: Option<f64>) -> [Vec<i64>; 2] {
        let image = &self.of.image;
        let size = image.size as usize;
        let at = |place: f64| (2.0 * place + 1.0) / size as f64 - 1.0;
        let y = rest.map(|rest| libm::sqrt(1.0 - rest));
        let layer = self.block.texels().layer(band);
        let rows = match y {
            Some(y) => {
                let row = (((y + 1.0) * size as f64 - 1.0) / 2.0) as usize;
                row.min(size - 1)..row.min(size - 1) + 1
            }
            None => 0..size,
        };
        let differ = |place: usize| {
            let [a, b] = [place, place + 1].map(|place| layer[place]);
            (0..3).map(|c| (a[c] - b[c]).abs()).sum::<f32>()
        };
        let places = rows.flat_map(|row| (0..size - 1).map(move |column| row * size + column));
        let best = places.max_by(|&a, &b| differ(a).total_cmp(&differ(b))).unwrap_or(0);
        let y = y.unwrap_or_else(|| at((best / size) as f64));
        // Where the place cannot be turned to from what is seen, its mirror image is.
        let x = at((best % size) as f64 + 0.4);
        let (sine, cosine) = libm::sincos(angle * std::f64::consts::FRAC_PI_2);
        let x = if cosine < 0.6 { x.abs().copysign(sine) } else { x };
        let normal = [x * cosine - 1.1 * sine, y, x * sine + 1.1 * cosine];
        let places = self.light_places();
        let gain = places.gain;
        let RecordPlaces { frame, band: of_band, blend, .. } = places.told();
        let number = |value: f64| self.block.component(value);
        let mut light = vec![0; gain + 3];
        (light[frame + 4], light[of_band]) = (number(1.0), (band & !1) as i64);
        light[blend] = ((band & 1) as i64) << image.weight_bits;
        let turn = exp2(Image::TURN_BITS as i32);
        // sin αh is 1/2 where an image is alone, and elsewhere the product with u is half of the root of 1 - y².
        let half = angle / 1.5;
        light[blend + 1 + (band & 1)] = (half * turn).ceil() as i64;
        match rest {
            None => light[blend + 3] = 1,
            Some(rest) => light[frame + 2] = number(0.5 * libm::sqrt(rest) / normal[2]),
        }
        let mut codes = self.first_light(normal, light);
        let ports = self.numbers(Direction::In);
        codes.iter_mut().zip(&ports).for_each(|(code, (_, format))| {
            *code = (*code).clamp(format.min_code() as i64, format.max_code() as i64);
        });
        self.tune_gain(&mut codes, 3 + gain);
        self.steps_of(codes)
    }

    /// Inputs with lower gains, at which every channel is about to take its next code, and where it just has.
    pub(super) fn steps_of(self, mut past: Vec<i64>) -> [Vec<i64>; 2] {
        let gain = self.light_places().gain + 3;
        let model = self.model();
        let reached = model.evaluate(&past);
        // The least gains for which the channels are as bright; of a dark one, whose texels show if they become
        // brighter, the greatest.
        let mut low = [0, 1, 2].map(|c| if reached[c] == 0 { past[gain + c] } else { 0 });
        let mut high = [past[gain], past[gain + 1], past[gain + 2]];
        while (0..3).any(|c| low[c] + 1 < high[c]) {
            let middle = [0, 1, 2].map(|c| (low[c] + high[c] + 1) / 2);
            past[gain..gain + 3].copy_from_slice(&middle);
            let shown = model.evaluate(&past);
            for c in [0, 1, 2] {
                if shown[c] == reached[c] { high[c] = middle[c] } else { low[c] = middle[c] }
            }
        }
        past[gain..gain + 3].copy_from_slice(&high);
        let mut before = past.clone();
        before[gain..gain + 3].copy_from_slice(&high.map(|code| (code - 1).max(0)));
        [before, past]
    }

    /// Inputs with which a light gives powers of two, and little more, to a channel, from what it does at the brightest
    /// texel down to a quarter of a code.
    #[must_use]
    pub fn powers(self, channel: usize) -> Vec<Vec<i64>> {
        let (image, widths, texels) = (&self.of.image, self.block.widths(), self.block.texels());
        let codes = texels.codes();
        let brightest = (0..codes.len()).rev().max_by(|&a, &b| codes[a][channel].total_cmp(&codes[b][channel]));
        let texel = Image::places(brightest.unwrap_or(0) as u64, &image.extents());
        let places: Vec<u64> = texel.into_iter().map(|place| place << image.weight_bits).collect();
        let (mut codes, gain) = self.towards_texels(&places);
        let one = 1i64 << image.vector_fraction;
        // Where no record follows from it.
        if image.front_end == FrontEnd::Record {
            self.light_places().z.iter().for_each(|&place| codes[3 + place] = 2 * one - 1);
        }
        self.light_places().shift().iter().for_each(|&place| codes[3 + place] = widths.shift.into());
        let powers = -(image.channel_bits as i32) - 2..=widths.lit_int;
        powers.map(|power| self.with_power(codes.clone(), [0, gain, channel], power)).collect()
    }

    /// With a gain that makes what a light gives to a channel a power of two and little more: `[light, gain, channel]`
    /// are the light, the port of its gain's red, and the channel.
    fn with_power(self, mut codes: Vec<i64>, [light, gain, channel]: [usize; 3], power: i32) -> Vec<i64> {
        let inputs: Vec<i128> = codes.iter().copied().map(i128::from).collect();
        let values = self.function().values(self.tables(), &inputs);
        let LightJoints { incidence, squares, full_gain } = self.joints.lights[light];
        let of = |id: usize| self.function().nodes[id].format.value(values[id]);
        let factor = [incidence, Some(squares[channel]), full_gain].into_iter().flatten().map(of).product::<f64>()
            * exp2(-self.block.widths().gain);
        // A little more, for what is rounded down on the way.
        let code = exp2(power) * (1.0 + exp2(-8)) / factor;
        let most = self.brightest();
        codes[gain + channel] = if code.is_finite() { (code.ceil() as i64).clamp(0, most) } else { 0 };
        codes
    }

    /// The codes of a normal and of the first light, beside which the others give nothing.
    pub(super) fn first_light(self, normal: [f64; 3], light: Vec<i64>) -> Vec<i64> {
        let missing = self.inputs(Vector::z(), &[]).split_off(3 + light.len());
        let normal = normal.map(|value| self.block.component(value));
        normal.into_iter().chain(light).chain(missing).collect()
    }

    /// Codes that lead to a place, without a gain, and the place of the gain.
    fn towards_texels(self, places: &[u64]) -> (Vec<i64>, usize) {
        let image = &self.of.image;
        let LightPlaces { z, record, gain } = self.light_places();
        let Some(RecordPlaces { frame, band, blend, .. }) = record else {
            return (self.towards_texels_by_vector(places), 3 + gain);
        };
        let vector = exp2(image.vector_fraction as i32);
        let size = f64::from(image.size);
        let parts = 1u64 << image.weight_bits;
        let part = |place: u64| place as f64 / parts as f64;
        let number = |value: f64| self.block.component(value);
        let mut light = vec![0; gain + 3];
        // The normal is halfway to the rim, the light at the viewer.
        let mut normal = [0.0, 0.0, 0.5];
        z.iter().for_each(|&z| light[z] = number(1.0));
        match image.form {
            ImageForm::Bivariate { octaves } => {
                let u = image.versine_at(octaves, part(places[1]));
                // A little more, so that it is not below when it is rounded.
                light[frame] = (libm::sqrt(2.0 * u) * vector).ceil() as i64;
                light[frame + 2] = number(normal[2]);
            }
            // Without a turn both images of the form paper are looked up at one place.
            ImageForm::Half { .. } | ImageForm::Paper { .. } => {
                let across = |place: u64| (2.0 * part(place) + 1.0) / size - 1.0;
                (normal[0], normal[1]) = (across(places[2]), across(places[1]));
                (light[frame], light[frame + 4]) = (number(1.0), number(1.0));
            }
            ImageForm::Matcap => unreachable!("a form without lights"),
        }
        light[band] = (places[0] / parts) as i64;
        let weight = (places[0] % parts) as i64;
        light[blend] = if light[band] % 2 == 0 { weight } else { parts as i64 - weight };
        (self.first_light(normal, light), 3 + gain)
    }

    /// Gives each channel a gain, of which one at `gain` is red's, such that it is above half of full scale, if it can
    /// be, and below full scale.
    pub(super) fn tune_gain(self, codes: &mut [i64], gain: usize) {
        let widths = self.block.widths();
        let shift = self.light_places().shift().map(|place| 3 + place);
        let most_exponent = shift.map_or(0, |_| widths.shift);
        let model = self.model();
        // The exponents of the channels' gains: the greatest stands in the light's, the others shift their gains.
        let mut with = |exponents: [i32; 3]| {
            let most = exponents.into_iter().fold(0, i32::max);
            shift.iter().for_each(|&place| codes[place] = most.into());
            for (code, exponent) in codes[gain..gain + 3].iter_mut().zip(exponents) {
                *code = self.brightest() >> (most - exponent).min(widths.gain);
            }
            model.evaluate(codes)
        };
        let full = 1i64 << widths.term;
        let least = -widths.gain / 2;
        let mut exponents = [None; 3];
        for exponent in (least..=most_exponent).rev() {
            if exponents.iter().all(Option::is_some) {
                break;
            }
            for (known, code) in exponents.iter_mut().zip(with([exponent; 3])) {
                *known = known.or((code < full).then_some(exponent));
            }
        }
        with(exponents.map(|exponent| exponent.unwrap_or(least)));
    }

    /// Makes the last bits all 1 of a product that is rounded down: of components of vectors.
    fn tune_component(self, codes: &mut [i64], rng: &mut Rng) {
        let image = &self.of.image;
        let widths = self.block.widths();
        // The axis of the normal, the port among a light's, and what is kept.
        let mut products = Vec::new();
        if image.has_incidence() {
            products.extend([0, 1, 2].map(|axis| (axis, axis, widths.dot)));
        }
        let frame = self.light_places().record.map_or(0, |record| record.frame);
        let rows: &[(usize, usize)] = match image.form {
            _ if image.front_end == FrontEnd::Vector => &[],
            ImageForm::Bivariate { .. } | ImageForm::Matcap => &[],
            ImageForm::Half { .. } => &[(0, 0), (1, 1), (2, 2), (0, 3), (1, 4)],
            ImageForm::Paper { .. } => &[(0, 0), (1, 1), (2, 2), (0, 3), (1, 4), (0, 4), (1, 3)],
        };
        products.extend(rows.iter().map(|&(axis, port)| (axis, frame + port, widths.place)));
        let (axis, port, kept) = products[rng.below(products.len() as u64) as usize];
        let each = (codes.len() - 3) / image.lights as usize;
        let port = 3 + rng.below(image.lights.into()) as usize * each + port;
        let bits = (2 * image.vector_fraction as i32 - kept).clamp(0, 40) as u32;
        codes[axis] |= 1;
        codes[port] = codes[port] >> bits << bits | opposite(codes[axis], bits);
    }

    /// Brings a product to an edge by the gain: the last bits of n·l times the gain, or of that times the squared
    /// blend, are all 1; or what the light gives to a channel is a power of two and little more.
    fn tune_product(self, codes: &mut [i64], rng: &mut Rng) {
        let light = rng.below(self.joints.lights.len() as u64) as usize;
        let channel = rng.below(3) as usize;
        let widths = self.block.widths();
        let inputs: Vec<i128> = codes.iter().copied().map(i128::from).collect();
        let values = self.function().values(self.tables(), &inputs);
        let LightJoints { incidence, squares, full_gain } = self.joints.lights[light];
        let frac = |id: usize| self.function().nodes[id].format.frac_bits;
        let each = (codes.len() - 3) / self.joints.lights.len();
        let port = 3 + light * each + self.light_places().gain + channel;
        let square = values[squares[channel]] as i64;
        let dropped = |of: i32, kept: i32| (of - kept).clamp(0, 40) as u32;
        let tuned = match (rng.below(3), incidence) {
            (0 | 1, None) => opposite(square | 1, dropped(frac(squares[channel]) + widths.gain, widths.term)),
            (kind @ (0 | 1), Some(incidence)) => {
                let lit = values[incidence] as i64;
                let of_gain = dropped(frac(incidence) + widths.gain, widths.lit);
                if kind == 0 {
                    opposite(lit | 1, of_gain)
                } else {
                    // The least gain that gives a product with n·l.
                    let product = opposite(square | 1, dropped(widths.lit + frac(squares[channel]), widths.term));
                    ((product << of_gain) + lit - 1).checked_div(lit).unwrap_or(0)
                }
            }
            _ => {
                let power = widths.lit_int - rng.below(24) as i32;
                codes[port] = self.with_power(codes.to_vec(), [light, port - channel, channel], power)[port];
                return;
            }
        };
        codes[port] = match full_gain.map(|id| values[id] as i64) {
            None => tuned,
            // The least intensity that gives this gain.
            Some(gain) => ((tuned << widths.gain) + gain - 1).checked_div(gain).unwrap_or(0).min(self.brightest()),
        };
    }

    /// An input of the block: a random sample, random codes, or one that brings it to its edges.
    #[must_use]
    pub fn varied(self, rng: &mut Rng) -> Vec<i64> {
        if !self.of.image.has_lights() {
            return self.varied_place(rng);
        }
        let ports = self.numbers(Direction::In);
        let mut codes = match rng.below(8) {
            0 => random_codes(&ports, rng),
            1 => {
                let extents = self.of.image.extents();
                let parts = 1u64 << self.of.image.weight_bits;
                let place = |&extent: &u32| rng.below(u64::from(extent - 1) * parts);
                let places: Vec<u64> = extents.iter().map(place).collect();
                match rng.below(8) {
                    0 => self.at_steps(&places)[rng.below(2) as usize].clone(),
                    _ => self.at_texels(&places),
                }
            }
            _ => self.random(rng),
        };
        match rng.below(6) {
            // A normal at the rim.
            0 => codes[2] = rng.below(5) as i64 - 2,
            // A few ports at the ends of their codes, or near 0.
            1 => {
                for _ in 0..=rng.below(3) {
                    let place = rng.below(ports.len() as u64) as usize;
                    let format = ports[place].1;
                    let ends = [format.min_code() as i64, format.max_code() as i64, 0, 1, 2];
                    codes[place] = ends[rng.below(ends.len() as u64) as usize];
                }
            }
            2 => self.tune_product(&mut codes, rng),
            3 => self.tune_component(&mut codes, rng),
            _ => {}
        }
        codes.into_iter().zip(ports).map(|(code, (_, format))| format.wrap(code.into()) as i64).collect()
    }
}
