//! A picture as the lobes that it asks for, and with their values as codes of its channels.

use super::Scene;
use crate::spec::Colour;

/// The material of a pixel that shows no object.
pub const BACKGROUND: u16 = u16::MAX;

/// A picture before its highlights: what each pixel shows, and which lobes it asks for.
///
/// A channel is `base + sum over the lights of k_s I x^n`, in units of full scale, taken into [0, 1] and rounded to the nearest code.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Pixels a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// The number of lights.
    pub lights: usize,
    /// The material of each pixel, row by row from the top, as its place in [`Scene::materials`]; [`BACKGROUND`] where there is none.
    pub material: Vec<u16>,
    /// Ambient and diffuse light of each pixel in units of full scale, 0 or more; of the background its colour.
    pub base: Vec<Colour>,
    /// The versine `u = 1 - x` of the highlight for each pixel and, within it, each light: 0 to 2, above 1 where the cosine x is
    /// negative; NaN where the light gives no highlight: it is behind the surface or in shadow, or there is no object.
    pub versine: Vec<f64>,
}

/// A picture as it leaves the shader: codes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Pixels a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Bits of a channel; full scale is `2^bits - 1`.
    pub channel_bits: u32,
    /// Red, green and blue of each pixel, row by row from the top.
    pub codes: Vec<[u16; 3]>,
}

impl Frame {
    /// The picture with these values of the lobes, one a pixel and light, each 0 to 1; those of NaN versines are not looked at.
    #[must_use]
    pub fn picture(&self, scene: &Scene, highlights: &[f64]) -> Picture {
        let full = f64::from((1u32 << scene.channel_bits) - 1);
        let weights: Vec<Vec<Colour>> =
            (0..scene.materials.len()).map(|m| (0..self.lights).map(|l| scene.specular(m, l)).collect()).collect();
        let pixel = |index: usize| {
            let mut sum = self.base[index];
            if self.material[index] != BACKGROUND {
                let of_material = &weights[usize::from(self.material[index])];
                for (light, weight) in of_material.iter().enumerate() {
                    let sample = index * self.lights + light;
                    if !self.versine[sample].is_nan() {
                        sum = [0, 1, 2].map(|c| sum[c] + weight[c] * highlights[sample]);
                    }
                }
            }
            sum.map(|channel| libm::round(channel.clamp(0.0, 1.0) * full) as u16)
        };
        use rayon::prelude::*;
        let codes = (0..self.material.len()).into_par_iter().map(pixel).collect();
        Picture { width: self.width, height: self.height, channel_bits: scene.channel_bits, codes }
    }
}

impl Scene {
    /// `k_s I` of a material under a light, a channel: what its highlight is multiplied by.
    #[must_use]
    pub fn specular(&self, material: usize, light: usize) -> Colour {
        let surface = self.materials[material].surface();
        [0, 1, 2].map(|c| surface.specular[c] * self.lights[light].colour[c])
    }
}
