//! The classical material that is nearest to a reflectance: I = kd n·l + Σ ks x^n, with x = n·h (Blinn) or r·v (Phong),
//! as a cos^n core computes it.

use rayon::prelude::*;
use serde::Serialize;

use super::measure::{Judge, Quality, Sphere};
use super::vector::{Light, Vector};
use super::{Reflectance, Rgb};
use crate::platform::error::{Error, refuse};

/// What the highlight is a power of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Cosine {
    /// n·h.
    Blinn,
    /// r·v, with r the mirrored direction of the light.
    Phong,
}

impl Cosine {
    fn of(self, light: Light, n: Vector) -> f64 {
        let l = light.direction();
        match self {
            Self::Blinn => n.dot(&(l + Vector::z()).try_normalize(1e-12).unwrap_or(Vector::z())),
            Self::Phong => 2.0 * n.dot(&l) * n.z - l.z,
        }
        .clamp(0.0, 1.0)
    }
}

/// A highlight.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Lobe {
    /// Its colour at the middle, with the exposure in it.
    pub ks: Rgb,
    /// The shininess.
    pub n: f64,
}

/// A classical material.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Classical {
    /// What the highlights are powers of.
    pub cosine: Cosine,
    /// The diffuse colour, with the exposure in it.
    pub kd: Rgb,
    /// The highlights, the widest first.
    pub lobes: Vec<Lobe>,
}

/// A fitted material and how near it is.
#[derive(Clone, Debug, Serialize)]
pub struct Fit {
    /// The material.
    pub material: Classical,
    /// The exposure that its colours have in them.
    pub exposure: f64,
    /// Over the angles of the light.
    pub quality: Quality,
    /// The largest difference of a channel, in steps of 8 bits.
    pub max_steps: u32,
    /// The mean difference.
    pub mean_steps: f64,
}

/// The most highlights.
pub const MOST_LOBES: usize = 3;
/// Shininesses that are tried.
const SHININESS: [f64; 2] = [1.0, 65536.0];
/// Pixels along a side of the spheres that are fitted, and those that the result is measured on.
const FITTED: usize = 36;
const MEASURED: usize = 128;
/// Bytes of a highlight and of the diffuse colour in a core's memory: three colours and a shininess of two bytes each.
const LOBE_BYTES: f64 = 8.0;

impl Classical {
    /// The radiance of a normal.
    #[must_use]
    pub fn at(&self, light: Light, n: Vector) -> Rgb {
        let cosine = n.dot(&light.direction());
        if cosine <= 0.0 || n.z <= 0.0 {
            return [0.0; 3];
        }
        let x = self.cosine.of(light, n);
        let mut sum = self.kd.map(|kd| kd * cosine);
        for Lobe { ks, n } in &self.lobes {
            let power = libm::pow(x, *n);
            (0..3).for_each(|c| sum[c] += ks[c] * power);
        }
        sum
    }

    /// The memory that its numbers take, in KiB.
    #[must_use]
    pub fn kib(&self) -> f64 {
        (LOBE_BYTES * self.lobes.len() as f64 + 6.0) / 1024.0
    }

    /// The picture of the sphere.
    #[must_use]
    pub fn picture(&self, sphere: &Sphere, light: Light) -> Vec<[f32; 3]> {
        sphere.normals.iter().map(|&n| self.at(light, n).map(|value| value as f32)).collect()
    }
}

/// The lit pixels of all pictures: what they show, and what a material is made of.
struct Data {
    /// n·l.
    diffuse: Vec<f64>,
    x: Vec<f64>,
    /// What is seen, from 0 to 1.
    target: Vec<Rgb>,
}

/// Numbers of a material's channels: kd, then ks of each highlight.
type Weights = [f64; 1 + MOST_LOBES];

impl Data {
    /// The best weights of the channels for these shininesses, and the sum of the squares that is left. What is at full
    /// scale in both pictures is no difference: so weights and clipped pixels are found in turns.
    fn solve(&self, shininess: &[f64]) -> ([Weights; 3], f64) {
        let count = 1 + shininess.len();
        let rows: Vec<Weights> = (0..self.x.len())
            .map(|pixel| {
                let mut row = [0.0; 1 + MOST_LOBES];
                row[0] = self.diffuse[pixel];
                shininess.iter().enumerate().for_each(|(lobe, &n)| row[1 + lobe] = libm::pow(self.x[pixel], n));
                row
            })
            .collect();
        let mut weights = [[0.0; 1 + MOST_LOBES]; 3];
        let mut left = 0.0;
        for (c, own) in weights.iter_mut().enumerate() {
            let value = |own: &Weights, row: &Weights| (0..count).map(|i| own[i] * row[i]).sum::<f64>();
            let mut best = f64::INFINITY;
            let mut trial = *own;
            for turn in 0..12 {
                let mut gram = [[0.0; 1 + MOST_LOBES]; 1 + MOST_LOBES];
                let mut moment = [0.0; 1 + MOST_LOBES];
                for (row, target) in rows.iter().zip(&self.target) {
                    if turn > 0 && target[c] >= 1.0 && value(&trial, row) >= 1.0 {
                        continue;
                    }
                    for i in 0..count {
                        moment[i] += row[i] * target[c];
                        (0..=i).for_each(|j| gram[i][j] += row[i] * row[j]);
                    }
                }
                trial = not_negative(&gram, &moment, count);
                let square = |(row, target): (&Weights, &Rgb)| {
                    let off = value(&trial, row).min(1.0) - target[c];
                    off * off
                };
                let sum: f64 = rows.iter().zip(&self.target).map(square).sum();
                if sum >= best {
                    break;
                }
                (best, *own) = (sum, trial);
            }
            left += best;
        }
        (weights, left)
    }
}

/// The weights of at least 0 that solve the normal equations best: the best over all choices of those above 0.
fn not_negative(gram: &[Weights; 1 + MOST_LOBES], moment: &Weights, count: usize) -> Weights {
    let mut best = ([0.0; 1 + MOST_LOBES], 0.0);
    for chosen in 1u32..1 << count {
        let index: Vec<usize> = (0..count).filter(|i| chosen >> i & 1 == 1).collect();
        let entry = |i: usize, j: usize| gram[i.max(j)][i.min(j)];
        let matrix = nalgebra::DMatrix::from_fn(index.len(), index.len(), |i, j| entry(index[i], index[j]));
        let right = nalgebra::DVector::from_fn(index.len(), |i, _| moment[index[i]]);
        let Some(solved) = matrix.cholesky().map(|factors| factors.solve(&right)) else { continue };
        if !solved.iter().all(|weight| *weight >= 0.0 && weight.is_finite()) {
            continue;
        }
        let gain = solved.dot(&right);
        if gain > best.1 {
            let mut weights = [0.0; 1 + MOST_LOBES];
            index.iter().zip(solved.iter()).for_each(|(&i, &weight)| weights[i] = weight);
            best = (weights, gain);
        }
    }
    best.0
}

/// Fits a classical material with so many highlights, 1 to 3, to pictures of the sphere at all angles of the light, as
/// the eye sees them: linear and cut off at full scale. `done` is called after each of the steps, [`steps`] of them.
///
/// # Errors
/// A number of highlights out of range.
pub fn fit(
    reflectance: &dyn Reflectance,
    cosine: Cosine,
    lobes: usize,
    exposure: f64,
    done: &(dyn Fn() + Sync),
) -> Result<Fit, Error> {
    refuse!(
        !(1..=MOST_LOBES).contains(&lobes),
        format!("{lobes} lobes"),
        format!("a classical material has 1 to {MOST_LOBES} of them")
    );
    let judge = Judge::new(reflectance, exposure, &super::measure::angles(15.0), FITTED);
    let mut data = Data { diffuse: Vec::new(), x: Vec::new(), target: Vec::new() };
    for (phi, picture) in judge.exact() {
        let light = Light::new(*phi, 0.0);
        for (&n, seen) in judge.sphere().normals.iter().zip(picture) {
            let diffuse = n.dot(&light.direction());
            if diffuse > 0.0 {
                data.diffuse.push(diffuse);
                data.x.push(cosine.of(light, n));
                data.target.push(seen.map(|value| f64::from(value).clamp(0.0, 1.0)));
            }
        }
    }
    let mut shininess: Vec<f64> = Vec::new();
    for lobe in 0..lobes {
        shininess.push(SHININESS[0]);
        search(&data, &mut shininess, lobe, 1.0, done);
        // The earlier ones make room.
        for other in (0..=lobe).filter(|_| lobe > 0) {
            search(&data, &mut shininess, other, 1.0, done);
        }
    }
    for round in 1..=ROUNDS {
        for lobe in 0..lobes {
            search(&data, &mut shininess, lobe, libm::pow(0.15, round as f64), done);
        }
    }
    shininess.sort_by(f64::total_cmp);
    let (weights, _) = data.solve(&shininess);
    let lobe = |(place, &n): (usize, &f64)| Lobe { ks: [0, 1, 2].map(|c| weights[c][1 + place]), n };
    let material = Classical {
        cosine,
        kd: [0, 1, 2].map(|c| weights[c][0]),
        lobes: shininess.iter().enumerate().map(lobe).collect(),
    };
    let judge = Judge::new(reflectance, exposure, &super::measure::angles(5.0), MEASURED);
    let draw = |sphere: &Sphere, light: Light| material.picture(sphere, light);
    let (max_steps, mean_steps) = judge.steps_of(draw);
    let quality = judge.quality_of(draw);
    Ok(Fit { material, exposure, quality, max_steps, mean_steps })
}

/// Rounds of refinement.
const ROUNDS: usize = 3;

/// How often [`fit`] says that a step is done.
#[must_use]
pub fn steps(lobes: usize) -> u64 {
    let first: usize = (0..lobes).map(|lobe| if lobe == 0 { 1 } else { lobe + 2 }).sum();
    (first + ROUNDS * lobes) as u64
}

/// Chooses the best shininess of one highlight: over the whole range, or `part` of its logarithm around the present
/// one.
fn search(data: &Data, shininess: &mut [f64], lobe: usize, part: f64, done: &(dyn Fn() + Sync)) {
    const TRIED: usize = 24;
    let [low, high] = SHININESS.map(libm::log);
    let middle = if part < 1.0 { libm::log(shininess[lobe]) } else { 0.5 * (low + high) };
    let width = part * (high - low);
    let tried = |step: usize| {
        let place = middle + width * (step as f64 / (TRIED - 1) as f64 - 0.5);
        let mut trial = shininess.to_vec();
        // Three digits are enough, and print well.
        let n = libm::exp(place.clamp(low, high));
        let unit = libm::pow(10.0, libm::floor(libm::log10(n)) - 3.0);
        trial[lobe] = (libm::round(n / unit) * unit).clamp(SHININESS[0], SHININESS[1]);
        (data.solve(&trial).1, trial[lobe])
    };
    let now = (data.solve(shininess).1, shininess[lobe]);
    let all: Vec<(f64, f64)> = (0..TRIED).into_par_iter().map(tried).collect();
    let best = all.into_iter().fold(now, |best, one| if one.0 < best.0 { one } else { best });
    shininess[lobe] = best.1;
    done();
}
