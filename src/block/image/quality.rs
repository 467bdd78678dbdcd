//! How well an image-based block meets a reflectance.

use rayon::prelude::*;

use super::ImageBlock;
use crate::reflectance::measure::{self, Quality, Sphere};
use crate::reflectance::{Form, Light, Reflectance, Vector};

/// The degrees between two angles of the light.
pub const STEP: f64 = 5.0;
/// Pixels along a side of a picture.
pub const SIZE: usize = 48;
/// The same of a picture of a matcap, at most: its detail is much finer than that of a reflectance.
pub const MATCAP_SIZE: usize = 512;
/// The degrees of azimuth that a light stands at for each of its polar angle: none of the frame's axes is favoured.
const TURN: f64 = 3.0;

/// What pictures of a block miss, each value kept from 0 to 1.
#[derive(Clone, Debug)]
pub struct SphereError {
    /// Their ratios.
    pub quality: Quality,
    /// The greatest difference of a channel.
    pub greatest: f64,
}

/// The light at a polar angle.
#[must_use]
pub fn turned(phi: f64) -> Light {
    Light::new(phi, TURN * phi)
}

/// The greatest difference of a channel, the exact one kept from 0 to 1.
fn greatest(exact: &[[f32; 3]], own: &[[f32; 3]]) -> f64 {
    let apart = |(own, exact): (&f32, &f32)| f64::from((own - exact.clamp(0.0, 1.0)).abs());
    own.as_flattened().iter().zip(exact.as_flattened()).map(apart).fold(0.0, f64::max)
}

impl ImageBlock {
    /// The codes of the channels of a sample of one clock.
    #[must_use]
    pub fn shown(&self, inputs: &[i64]) -> Vec<i64> {
        let outputs = self.model().evaluate(inputs);
        self.sums().map_or_else(|| outputs.clone(), |sums| sums.codes([outputs.as_slice()]))
    }

    /// How well its picture of a sphere meets that of a matcap times an exposure, in as many pixels as the matcap has,
    /// up to [`MATCAP_SIZE`] along a side.
    #[must_use]
    pub fn matcap_error(&self, form: &Form, exposure: f64) -> SphereError {
        let sphere = Sphere::new(form.spec.size.min(MATCAP_SIZE));
        let full = self.image().full_scale() as f64;
        let light = Light::new(0.0, 0.0);
        let own = |&n: &Vector| {
            let codes = self.shown(&self.inputs(n, &[]));
            [0, 1, 2].map(|channel| (codes[channel] as f64 / full) as f32)
        };
        let exact = |&n: &Vector| form.at(light, n).map(|value| (value * exposure) as f32);
        let pixels: Vec<_> = sphere.normals.par_iter().map(|n| (own(n), exact(n))).collect();
        let (own, exact): (Vec<_>, Vec<_>) = pixels.into_iter().unzip();
        SphereError { quality: Quality::of(vec![(0.0, measure::psnr(&exact, &own))]), greatest: greatest(&exact, &own) }
    }

    /// How well its pictures of a sphere, with one light of intensity 1, meet those of a reflectance times an exposure.
    #[must_use]
    pub fn quality(&self, reflectance: &dyn Reflectance, exposure: f64) -> Quality {
        self.sphere_error(reflectance, exposure).quality
    }

    /// As [`ImageBlock::quality`], with the greatest error.
    #[must_use]
    pub fn sphere_error(&self, reflectance: &dyn Reflectance, exposure: f64) -> SphereError {
        let sphere = Sphere::new(SIZE);
        let full = self.image().full_scale() as f64;
        let of_angle = |&phi: &f64| {
            let light = turned(phi);
            let mut inputs = self.inputs(Vector::z(), &[(light, [1.0; 3])]);
            let shown = |&n: &Vector| {
                inputs[..3].copy_from_slice(&self.vector(n));
                let codes = self.shown(&inputs);
                [0, 1, 2].map(|channel| (codes[channel] as f64 / full) as f32)
            };
            let own: Vec<[f32; 3]> = sphere.normals.iter().map(shown).collect();
            let exact = sphere.exact(reflectance, light, exposure);
            ((phi, measure::psnr(&exact, &own)), greatest(&exact, &own))
        };
        let of_angles: Vec<_> = measure::angles(STEP).par_iter().map(of_angle).collect();
        let greatest = of_angles.iter().map(|&(_, greatest)| greatest).fold(0.0, f64::max);
        SphereError { quality: Quality::of(of_angles.into_iter().map(|(ratio, _)| ratio).collect()), greatest }
    }
}
