//! How well an image-based block meets a reflectance.

use rayon::prelude::*;

use super::ImageBlock;
use crate::reflectance::measure::{self, Quality, Sphere};
use crate::reflectance::{Light, Reflectance, Vector};

/// The degrees between two angles of the light.
pub const STEP: f64 = 5.0;
/// Pixels along a side of a picture.
pub const SIZE: usize = 48;
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

impl ImageBlock {
    /// The codes of the channels of a sample whose lights are those of one clock.
    #[must_use]
    pub fn shown(&self, inputs: &[i64]) -> Vec<i64> {
        self.sums().codes([self.model().evaluate(inputs).as_slice()])
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
            let apart = |(own, exact): (&f32, &f32)| f64::from((own - exact.clamp(0.0, 1.0)).abs());
            let greatest = own.as_flattened().iter().zip(exact.as_flattened()).map(apart).fold(0.0, f64::max);
            ((phi, measure::psnr(&exact, &own)), greatest)
        };
        let of_angles: Vec<_> = measure::angles(STEP).par_iter().map(of_angle).collect();
        let greatest = of_angles.iter().map(|&(_, greatest)| greatest).fold(0.0, f64::max);
        SphereError { quality: Quality::of(of_angles.into_iter().map(|(ratio, _)| ratio).collect()), greatest }
    }
}
