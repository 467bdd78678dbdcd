//! Memory against error for one material: every form, number of images, size and kind of texel, and the fitted
//! classical materials.

use rayon::prelude::*;
use serde::Serialize;

use super::classical::{self, Cosine, Fit, MOST_LOBES};
use super::form::{FormKind, FormSpec};
use super::measure::{self, Judge, Quality};
use super::texels::Texel;
use super::{Reflectance, paper};
use crate::platform::error::Error;

/// What is compared.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Point {
    /// `paper`, `half`, `bivariate`, `blinn` or `phong`.
    pub form: &'static str,
    /// Images or slices; highlights of a classical material.
    pub images: usize,
    /// Texels along a side; 0 of a classical material.
    pub size: usize,
    /// How texels are stored; empty for a classical material.
    pub texel: String,
    /// The memory in KiB.
    pub kib: f64,
    /// The mean ratio in dB over all angles of the light.
    pub mean: f64,
    /// The least ratio in dB.
    pub worst: f64,
    /// The angle of it in degrees.
    pub worst_phi: f64,
    /// Whether no other point has both less memory and a better mean.
    pub front: bool,
}

impl Point {
    fn of(form: &'static str, images: usize, size: usize, texel: String, kib: f64, quality: &Quality) -> Self {
        let Quality { mean, worst, worst_phi, .. } = *quality;
        Self { form, images, size, texel, kib, mean, worst, worst_phi, front: false }
    }

    /// What it is, in a few words.
    #[must_use]
    pub fn name(&self) -> String {
        let Self { form, images, size, texel, .. } = self;
        match (*form, *images) {
            ("bivariate", _) => format!("bivariate {size}² {texel}"),
            (_, images) if *size > 0 => format!("{form} {images}×{size}² {texel}"),
            (_, 1) => format!("{form} cos^n, 1 lobe"),
            (_, lobes) => format!("{form} cos^n, {lobes} lobes"),
        }
    }
}

/// Pixels along a side of the spheres that are compared.
const PIXELS: usize = 64;
/// The step of the light's angle in degrees.
const STEP: f64 = 2.5;

/// Forms, numbers of images, sizes and texels. Samples are made once for all texels.
fn shapes() -> Vec<(FormSpec, Vec<Texel>)> {
    let mut shapes = Vec::new();
    for images in [4, 6, 12] {
        for size in [32, 64, 128, 256, 512] {
            let texels = vec![Texel::Packed565, Texel::Linear(8), Texel::Sqrt(8, None), Texel::Float];
            shapes.push((FormSpec::sized(FormKind::Paper, images, size, Texel::Float), texels));
        }
    }
    for images in [4, 8, 16, 32] {
        for size in [8, 16, 32, 64, 128] {
            let texels = vec![Texel::Packed565, Texel::Sqrt(6, None), Texel::Sqrt(8, None), Texel::Float];
            shapes.push((FormSpec::sized(FormKind::Half, images, size, Texel::Float), texels));
        }
    }
    for size in [8, 16, 32, 64, 90] {
        let texels = vec![Texel::Packed565, Texel::Sqrt(6, None), Texel::Sqrt(8, None), Texel::Float];
        shapes.push((FormSpec::sized(FormKind::Bivariate, 1, size, Texel::Float), texels));
    }
    shapes
}

/// How often [`trade`] says that a step is done.
#[must_use]
pub fn steps() -> u64 {
    shapes().len() as u64 + 2 * MOST_LOBES as u64
}

/// Measures them all, in order of their memory. `done` is called after each of the steps, [`steps`] of them.
///
/// # Errors
/// A sample that does not fit 32 bits at this exposure.
pub fn trade(reflectance: &dyn Reflectance, exposure: f64, done: &(dyn Fn() + Sync)) -> Result<Vec<Point>, Error> {
    let judge = Judge::new(reflectance, exposure, &measure::angles(STEP), PIXELS);
    let shape = |(spec, texels): (FormSpec, Vec<Texel>)| {
        let samples = spec.samples(reflectance, exposure)?;
        let point = |texel: Texel| {
            let mut spec = FormSpec { texel, ..spec.clone() };
            // Large texels would leave the rim's black within reach of the shortened normals.
            if spec.kind == FormKind::Paper {
                spec.options = paper::Options::default();
            }
            let form = spec.encode(&samples, exposure);
            let name = spec.kind.name();
            Point::of(name, spec.angles.len(), spec.size, texel.to_string(), form.kib(), &judge.quality(&form))
        };
        let points: Vec<Point> = texels.into_iter().map(point).collect();
        done();
        Ok(points)
    };
    let all: Vec<Vec<Point>> = shapes().into_par_iter().map(shape).collect::<Result<_, Error>>()?;
    let mut points = all.concat();
    for cosine in [Cosine::Blinn, Cosine::Phong] {
        for lobes in 1..=MOST_LOBES {
            let Fit { material, .. } = classical::fit(reflectance, cosine, lobes, exposure, &|| ())?;
            let quality = judge.quality_of(|sphere, light| material.picture(sphere, light));
            let name = if cosine == Cosine::Blinn { "blinn" } else { "phong" };
            points.push(Point::of(name, lobes, 0, String::new(), material.kib(), &quality));
            done();
        }
    }
    points.sort_by(|a, b| a.kib.total_cmp(&b.kib).then(b.mean.total_cmp(&a.mean)));
    let mut best = f64::NEG_INFINITY;
    for point in &mut points {
        point.front = point.mean > best;
        best = best.max(point.mean);
    }
    Ok(points)
}

/// The points as CSV.
///
/// # Errors
/// None for points that were measured.
pub fn csv(points: &[Point]) -> Result<Vec<u8>, Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let failed = || Error::input("the results cannot be written as CSV", "another file");
    points.iter().try_for_each(|point| writer.serialize(point)).map_err(|_| failed())?;
    writer.into_inner().map_err(|_| failed())
}

/// The point that takes the least memory with a mean ratio of at least `min_psnr`; without it, the one with the
/// best mean. Of those that take at most `max_kib`. None if there is none.
#[must_use]
pub fn choose(points: &[Point], max_kib: Option<f64>, min_psnr: Option<f64>) -> Option<&Point> {
    let within = points.iter().filter(|point| max_kib.is_none_or(|most| point.kib <= most));
    match min_psnr {
        Some(least) => within
            .filter(|point| point.mean >= least)
            .min_by(|a, b| a.kib.total_cmp(&b.kib).then(b.mean.total_cmp(&a.mean))),
        None => within.max_by(|a, b| a.mean.total_cmp(&b.mean).then(b.kib.total_cmp(&a.kib))),
    }
}
