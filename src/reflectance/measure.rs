//! Pictures of the sphere, the exposure, and the signal-to-noise ratio of a form.

use libm::{log10, sqrt};
use rayon::prelude::*;
use serde::Serialize;

use super::vector::{Light, Vector};
use super::{Form, Reflectance};

/// The visible half of the unit sphere as a square picture has it: a normal for each pixel whose centre lies inside the
/// disc.
#[derive(Clone, Debug)]
pub struct Sphere {
    /// The normals, row by row from the bottom.
    pub normals: Vec<Vector>,
    /// Their coordinates in single precision, one after the other.
    single: [Vec<f32>; 3],
}

impl Sphere {
    /// A picture of so many pixels along a side.
    #[must_use]
    pub fn new(size: usize) -> Self {
        let at = |place: usize| (2 * place + 1) as f64 / size as f64 - 1.0;
        let pixels = (0..size).flat_map(|row| (0..size).map(move |column| (at(column), at(row))));
        let inside = pixels.filter(|(x, y)| x * x + y * y < 1.0);
        let normals: Vec<Vector> = inside.map(|(x, y)| Vector::new(x, y, sqrt(1.0 - x * x - y * y))).collect();
        let single = [0, 1, 2].map(|axis| normals.iter().map(|n| n[axis] as f32).collect());
        Self { normals, single }
    }

    /// The coordinates of the normals in single precision.
    #[must_use]
    pub fn coordinates(&self) -> [&[f32]; 3] {
        [&self.single[0], &self.single[1], &self.single[2]]
    }

    /// The exact radiance of each pixel.
    #[must_use]
    pub fn exact(&self, reflectance: &dyn Reflectance, light: Light, exposure: f64) -> Vec<[f32; 3]> {
        self.normals.iter().map(|&n| reflectance.radiance(light, n, exposure).map(|value| value as f32)).collect()
    }

    /// The radiance of each pixel as a form has it.
    #[must_use]
    pub fn through(&self, form: &Form, light: Light) -> Vec<[f32; 3]> {
        let mut out = vec![[0.0; 3]; self.normals.len()];
        form.add(&form.record(light), 1.0, self.coordinates(), &mut out);
        out
    }
}

/// The pixels along a side of the sphere that an exposure is measured on.
const EXPOSURE_SIZE: usize = 256;

/// The exposure that makes a material's sphere bright enough: E = 0.6/P, with P the 90th percentile over all visible
/// pixels, unlit ones too, of the largest channel of f max(n·l, 0) at φ = 45°. 1 where P vanishes.
#[must_use]
pub fn exposure(reflectance: &dyn Reflectance) -> f64 {
    let light = Light::new(45.0, 0.0);
    let sphere = Sphere::new(EXPOSURE_SIZE);
    let largest = |&n: &Vector| reflectance.radiance(light, n, 1.0).into_iter().fold(0.0, f64::max);
    let mut values: Vec<f64> = sphere.normals.par_iter().map(largest).collect();
    values.sort_by(f64::total_cmp);
    // Between the two nearest ranks.
    let rank = 0.9 * (values.len() - 1) as f64;
    let (low, part) = (rank as usize, rank.fract());
    let p = values[low] * (1.0 - part) + values[(low + 1).min(values.len() - 1)] * part;
    if p > 1e-9 { 0.6 / p } else { 1.0 }
}

/// The ratio in dB at which pictures count as the same: no texels here are that exact.
const SAME: f64 = 150.0;

/// The peak signal-to-noise ratio of two pictures in dB, on linear values from 0 to 1; values outside are taken to the
/// nearest end. At most 150.
#[must_use]
pub fn psnr(exact: &[[f32; 3]], other: &[[f32; 3]]) -> f64 {
    let double = |(a, b): (&f32, &f32)| (f64::from(*a), f64::from(*b));
    ratio(exact.as_flattened().iter().zip(other.as_flattened()).map(double)).map_or(SAME, |ratio| ratio.min(SAME))
}

/// The peak signal-to-noise ratio of pairs of linear values in dB, each taken to the nearest end of 0 to 1; none where
/// they are the same or there is none.
#[must_use]
pub fn ratio(pairs: impl Iterator<Item = (f64, f64)>) -> Option<f64> {
    let (mut sum, mut count) = (0.0, 0u64);
    for (a, b) in pairs {
        let off = a.clamp(0.0, 1.0) - b.clamp(0.0, 1.0);
        sum += off * off;
        count += 1;
    }
    (sum > 0.0).then(|| -10.0 * log10(sum / count as f64))
}

/// The angles of the light that a form is judged at: 2.5 degrees, and from there in steps to 167.5 degrees.
#[must_use]
pub fn angles(step: f64) -> Vec<f64> {
    let count = ((167.5 - 2.5) / step + 1e-9) as usize + 1;
    (0..count).map(|i| 2.5 + step * i as f64).collect()
}

/// How well pictures are met over the angles of the light.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Quality {
    /// The mean of the angles' ratios in dB.
    pub mean: f64,
    /// The least of them.
    pub worst: f64,
    /// The angle in degrees where it is.
    pub worst_phi: f64,
    /// The ratio in dB at each angle.
    #[serde(skip)]
    pub each: Vec<(f64, f64)>,
}

impl Quality {
    /// The quality of ratios at angles.
    ///
    /// # Panics
    /// If there is none.
    #[must_use]
    pub fn of(each: Vec<(f64, f64)>) -> Self {
        let mean = each.iter().map(|(_, db)| db).sum::<f64>() / each.len() as f64;
        let (worst_phi, worst) = each.iter().copied().min_by(|a, b| a.1.total_cmp(&b.1)).expect("an angle");
        Self { mean, worst, worst_phi, each }
    }

    /// The mean over the angles that lie in a range.
    #[must_use]
    pub fn mean_within(&self, range: std::ops::RangeInclusive<f64>) -> f64 {
        let within: Vec<f64> = self.each.iter().filter(|(phi, _)| range.contains(phi)).map(|(_, db)| *db).collect();
        within.iter().sum::<f64>() / within.len() as f64
    }
}

/// The exact pictures of a reflectance, with which any number of forms can be compared.
#[derive(Clone, Debug)]
pub struct Judge {
    /// The exposure of all pictures.
    pub exposure: f64,
    sphere: Sphere,
    exact: Vec<(f64, Vec<[f32; 3]>)>,
}

impl Judge {
    /// Draws the exact pictures of so many pixels along a side at these angles.
    #[must_use]
    pub fn new(reflectance: &dyn Reflectance, exposure: f64, angles: &[f64], size: usize) -> Self {
        let sphere = Sphere::new(size);
        let draw = |&phi: &f64| (phi, sphere.exact(reflectance, Light::new(phi, 0.0), exposure));
        let exact = angles.par_iter().map(draw).collect();
        Self { exposure, sphere, exact }
    }

    /// The quality of a form.
    #[must_use]
    pub fn quality(&self, form: &Form) -> Quality {
        self.quality_of(|sphere, light| sphere.through(form, light))
    }

    /// The quality of whatever draws pictures.
    #[must_use]
    pub fn quality_of(&self, draw: impl Fn(&Sphere, Light) -> Vec<[f32; 3]> + Sync) -> Quality {
        let ratio =
            |(phi, exact): &(f64, Vec<[f32; 3]>)| (*phi, psnr(exact, &draw(&self.sphere, Light::new(*phi, 0.0))));
        Quality::of(self.exact.par_iter().map(ratio).collect())
    }

    /// The largest and the mean difference of pictures in steps of 8 bits.
    #[must_use]
    pub fn steps_of(&self, draw: impl Fn(&Sphere, Light) -> Vec<[f32; 3]> + Sync) -> (u32, f64) {
        let code = |value: f32| (value.clamp(0.0, 1.0) * 255.0).round() as i32;
        let off = |(phi, exact): &(f64, Vec<[f32; 3]>)| {
            let own = draw(&self.sphere, Light::new(*phi, 0.0));
            let pairs = exact.as_flattened().iter().zip(own.as_flattened());
            pairs.fold((0, 0u64), |(most, sum), (&a, &b)| {
                let off = code(a).abs_diff(code(b));
                (most.max(off), sum + u64::from(off))
            })
        };
        let all: Vec<(u32, u64)> = self.exact.par_iter().map(off).collect();
        let most = all.iter().map(|(most, _)| *most).max().unwrap_or(0);
        let count = 3 * self.sphere.normals.len() * self.exact.len();
        (most, all.iter().map(|(_, sum)| *sum).sum::<u64>() as f64 / count as f64)
    }

    /// The sphere of all pictures.
    #[must_use]
    pub fn sphere(&self) -> &Sphere {
        &self.sphere
    }

    /// The exact pictures with their angles.
    #[must_use]
    pub fn exact(&self) -> &[(f64, Vec<[f32; 3]>)] {
        &self.exact
    }
}
