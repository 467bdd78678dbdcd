//! The values of a picture's lobes: exact, by the bit-exact model of a core, or by the compiled core itself.

use rayon::prelude::*;

use super::{Frame, Scene};
use crate::error::Error;
use crate::lobe;

/// Something that computes `x^n`.
pub trait Highlights {
    /// The lobe of each sample of a frame, pixel by pixel and light by light, as [`Frame::versine`] has them; anything for a sample whose
    /// versine is NaN.
    ///
    /// # Errors
    /// A tool that is missing or fails.
    fn of(&self, scene: &Scene, frame: &Frame) -> Result<Vec<f64>, Error>;
}

/// `x^n` itself, in double precision; 0 where x is negative.
#[derive(Clone, Copy, Debug)]
pub struct Exact;

impl Highlights for Exact {
    fn of(&self, scene: &Scene, frame: &Frame) -> Result<Vec<f64>, Error> {
        let lights = frame.lights;
        let sample = |(index, &versine): (usize, &f64)| {
            if versine.is_nan() || versine >= 1.0 {
                return 0.0;
            }
            lobe::exact(scene.materials[usize::from(frame.material[index / lights])].shininess, versine)
        };
        Ok(frame.versine.par_iter().enumerate().map(sample).collect())
    }
}
