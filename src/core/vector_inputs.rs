//! Inputs of an image-based block that is told of a light by the vector towards it: what a record would say directly
//! is sought through that vector, and the normal in the frame that follows from it.

use rayon::prelude::*;

use super::ImageDesign;
use crate::block::image::{ImageForm, LightRecord};
use crate::fixed::exp2;
use crate::reflectance::{Light, Vector};

/// Codes of l_z on either side of the computed one among which a weight of the bands is sought.
const NEAR: i64 = 8;
/// What l_x and l_y are at most, where their direction alone counts: below 2, so that n·l is great.
const LONG: f64 = 1.9;
/// The parts that a range of normals is tried in.
const TRIED: i32 = 96;

impl ImageDesign<'_> {
    /// The record of a light in this direction, with an intensity of 0.
    fn record_towards(self, l: &[i64; 3]) -> LightRecord {
        self.model().record(&[&l[..], &[0; 3]].concat())
    }

    /// The codes of a vector, each within its port.
    fn kept(self, v: [f64; 3]) -> [i64; 3] {
        let format = self.of.image.vector();
        v.map(|value| self.block.component(value).clamp(format.min_code() as i64, format.max_code() as i64))
    }

    /// The vector to a light at a place among the bands, in parts of a weight's last bit, at the azimuth 0.
    fn vector_at(self, place: u64) -> [i64; 3] {
        let parts = 1u64 << self.of.image.weight_bits;
        let (band, weight) = ((place / parts) as usize, place % parts);
        let angles = self.of.image.band_angles();
        let next = (band + 1).min(angles.len() - 1);
        let part = weight as f64 / parts as f64;
        // The part of the way at which the next band has this weight.
        let [own, of_next] = [band, next].map(|band| self.block.texels().weight(band));
        let (a, b) = (part * own, (1.0 - part) * of_next);
        let t = if a + b > 0.0 { a / (a + b) } else { part };
        let l = self.block.vector(Light::new(angles[band] * (1.0 - t) + angles[next] * t, 0.0).direction());
        let odd = if band.is_multiple_of(2) { weight } else { parts - weight } as i64;
        let is_there = |l: &[i64; 3]| {
            let record = self.record_towards(l);
            record.band == band as i64 && record.blend == odd
        };
        let nearest = (0..=2 * NEAR).map(|step| if step % 2 == 0 { step / 2 } else { -(step + 1) / 2 });
        let others = nearest.map(|by| [l[0], l[1], l[2] + by]);
        others.into_iter().find(is_there).unwrap_or(l)
    }

    /// A normal that lies at these places, from the first texel, within a band of the record of a light, and which is
    /// seen and lit where there is such a one.
    fn normal_at(self, l: Vector, record: &LightRecord, places: &[f64]) -> [i64; 3] {
        let image = &self.of.image;
        let frame: Vec<f64> =
            record.frame.iter().map(|&code| code as f64 * exp2(-(image.vector_fraction as i32))).collect();
        let candidates: Vec<Vector> = match image.form {
            ImageForm::Bivariate { octaves } => {
                // Around h, a little further than it is, so that it is not below when it is rounded.
                let apart = libm::sqrt(2.0 * image.versine_at(octaves, places[0])) + exp2(-16);
                let h = Vector::new(frame[0], frame[1], frame[2]);
                let x = Vector::new(h.z, 0.0, -h.x).try_normalize(1e-9).unwrap_or(Vector::x());
                let y = x.cross(&h).try_normalize(1e-9).unwrap_or(Vector::y());
                let around = (0..TRIED).map(|step| f64::from(step) / f64::from(TRIED) * std::f64::consts::TAU);
                around.map(|angle| h + (x * libm::cos(angle) + y * libm::sin(angle)) * apart).collect()
            }
            ImageForm::Half { .. } | ImageForm::Paper { .. } | ImageForm::Matcap => {
                let across = |place: f64| (2.0 * place + 1.0) / f64::from(image.size) - 1.0;
                let (u, v) = (Vector::new(frame[0], frame[1], frame[2]), Vector::new(frame[3], frame[4], 0.0));
                let h = u.cross(&v);
                let at = u * across(places[1]) + v * across(places[0]);
                (0..=2 * TRIED).map(|step| at + h * (2.0 * f64::from(step) / f64::from(TRIED) - 2.0)).collect()
            }
        };
        // As bright as it can be, for what n·l 2^shift holds; a normal whose component is out of range is at another
        // place.
        let most = exp2(self.block.widths().lit_int - record.shift.unwrap_or(0) as i32).min(1.0);
        let lit = |n: &Vector| {
            let fits = n.iter().all(|component| component.abs() < 2.0) && n.z > 1e-3;
            let lit = n.dot(&l);
            if fits && lit < most { lit } else { -1.0 }
        };
        let best = candidates.into_iter().max_by(|a, b| lit(a).total_cmp(&lit(b))).expect("there are candidates");
        self.kept([best.x, best.y, best.z])
    }

    /// [`ImageDesign::at_texels`] without an intensity.
    pub(super) fn towards_texels_by_vector(self, places: &[u64]) -> Vec<i64> {
        let image = &self.of.image;
        let parts = exp2(image.weight_bits as i32);
        let mut l = self.vector_at(places[0]);
        if let ImageForm::Half { .. } = image.form {
            // The record goes by the direction of both alone.
            l[0] = self.block.component(LONG);
        }
        let inner: Vec<f64> = places[1..].iter().map(|&place| place as f64 / parts).collect();
        let n = self.normal_at(self.real(l), &self.record_towards(&l), &inner);
        self.sample(n, l)
    }

    fn real(self, l: [i64; 3]) -> Vector {
        Vector::from(l.map(|code| code as f64 * exp2(-(self.of.image.vector_fraction as i32))))
    }

    /// A normal and a first light without an intensity.
    fn sample(self, n: [i64; 3], l: [i64; 3]) -> Vec<i64> {
        let real = n.map(|code| code as f64 * exp2(-(self.of.image.vector_fraction as i32)));
        self.first_light(real, [&l[..], &[0; 3]].concat())
    }

    /// Samples of a light at a place where texels differ, which is another one for another number, each where every
    /// channel is about to take its next code and where it just has.
    fn shown_by(self, l: &Vector, number: usize) -> Vec<Vec<i64>> {
        let image = &self.of.image;
        let l = self.kept([l.x, l.y, l.z]);
        let record = self.record_towards(&l);
        let size = f64::from(image.size);
        // Not at the middle, where a turn moves nothing; not at the same place for neighbouring rows.
        let beside = 0.12 + 0.03 * (number % 5) as f64;
        let sign = if number.is_multiple_of(2) { 1.0 } else { -1.0 };
        let inner = match image.form {
            ImageForm::Bivariate { .. } => vec![size * (0.3 + 0.06 * (number % 7) as f64)],
            ImageForm::Half { .. } | ImageForm::Paper { .. } | ImageForm::Matcap => {
                vec![size * (0.5 + sign * beside), size * (0.5 - sign * beside * 0.7)]
            }
        };
        let n = self.normal_at(self.real(l), &record, &inner);
        let mut codes = self.sample(n, l);
        self.tune_gain(&mut codes, 6);
        // A last bit of a word shows where a place is about to be another.
        let along: &[usize] = if image.extents().len() == 2 { &[number % 2] } else { &[0, 1] };
        let beside =
            along.iter().flat_map(|&axis| self.place_steps(&codes, axis)).flat_map(|codes| self.steps_of(codes));
        beside.collect()
    }

    /// A sample whose normal's component along an axis is the last code before a place among the texels becomes another
    /// one, and the one with the next code; where none does near by, the sample itself.
    fn place_steps(self, codes: &[i64], axis: usize) -> Vec<Vec<i64>> {
        let places = |codes: &[i64]| -> Vec<i128> {
            let inputs: Vec<i128> = codes.iter().copied().map(i128::from).collect();
            let values = self.function().values(self.tables(), &inputs);
            // Those of the first light.
            let count = self.joints.places.len() / self.of.image.lights as usize;
            self.joints.places[..count].iter().flat_map(|joint| joint.results()).map(|id| values[id]).collect()
        };
        let at = |by: i64| {
            let mut moved = codes.to_vec();
            moved[axis] += by;
            moved
        };
        let most = self.of.image.vector().max_code() as i64;
        let (mut low, mut high) = (0, (1 << self.of.image.vector_fraction) / i64::from(self.of.image.size));
        let own = places(codes);
        if codes[axis] + high > most || places(&at(high)) == own {
            return vec![codes.to_vec()];
        }
        while high - low > 1 {
            let middle = (low + high) / 2;
            if places(&at(middle)) == own { low = middle } else { high = middle }
        }
        vec![at(low), at(high)]
    }

    /// Samples at every row of the tables of the front end.
    #[must_use]
    pub fn at_front_end_rows(self) -> Vec<Vec<i64>> {
        let Some(rows) = self.block.front_end_rows() else { return Vec::new() };
        let part = |number: usize| 0.3 + 0.6 * ((number * 5) % 8) as f64 / 8.0;
        let gamma = |number: usize| (67.0 * number as f64).to_radians();
        let at = |z: f64, number: usize| {
            let across = libm::sqrt((1.0 - z * z).max(0.0));
            Vector::new(across * libm::cos(gamma(number)), across * libm::sin(gamma(number)), z)
        };
        let within = |[from, to]: [f64; 2], number: usize| from + (to - from) * part(number);
        let numbered = |rows: Vec<[f64; 2]>| rows.into_iter().enumerate();
        let by_cosine = numbered(rows.cosines).map(|(number, ends)| at(within(ends, number), number));
        let by_angle =
            numbered(rows.angles).map(|(number, ends)| at(libm::cos(within(ends, number).to_radians()), number));
        let by_azimuth = numbered(rows.across).flat_map(|(number, ends)| {
            // Another exponent for each row.
            [number, number + 3].map(|number| {
                let square = within(ends, number) * exp2(-2 * (number % rows.exponents) as i32);
                at(libm::sqrt(1.0 - square), number)
            })
        });
        let all: Vec<Vector> = by_cosine.chain(by_angle).chain(by_azimuth).collect();
        let shown = |(number, l): (usize, &Vector)| self.shown_by(l, number);
        all.par_iter().enumerate().flat_map_iter(shown).collect()
    }
}
