//! The values of a picture's lobes: exact, by the bit-exact model of a core, or by the compiled core itself.

use std::path::Path;

use rayon::prelude::*;

use super::slots::Slots;
use super::{Frame, Scene};
use crate::core::Design;
use crate::fixed::exp2;
use crate::lobe;
use crate::platform::error::Error;
use crate::spec::{BlockKind, Operand};
use crate::verify::cosim;

/// Something that computes `x^n`.
pub trait Highlights {
    /// The lobe of each sample of a frame, pixel by pixel and light by light, as [`Frame::versine`] has them; anything
    /// for a sample whose versine is NaN.
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

/// The codes of a core's ports that a frame's samples come to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Codes {
    /// The code of `in_n` of each material of the scene: that of the core's shininess that is nearest to the
    /// material's, of two the lower.
    pub indices: Vec<u32>,
    /// The code of the operand of each sample, as [`Frame::versine`] has them: the nearest that its port holds; 0 where
    /// the versine is NaN.
    pub operands: Vec<i32>,
}

impl Codes {
    /// The codes of a frame's samples for a lobe's core.
    #[must_use]
    pub fn of(design: &Design, scene: &Scene, frame: &Frame) -> Self {
        let values = design.lobe().interface.shininess.values();
        let nearest = |shininess: f64| {
            let away = |row: &usize| (values[*row] - shininess).abs();
            let closer = |a: &usize, b: &usize| away(a).total_cmp(&away(b)).then(values[*a].total_cmp(&values[*b]));
            design.lobe().interface.shininess.index_of_row((0..values.len()).min_by(closer).unwrap_or(0))
        };
        let indices = scene.materials.iter().map(|material| nearest(material.shininess)).collect();
        let one = exp2(design.lobe().interface.input_fraction as i32);
        let format = design.lobe().operand_format();
        let (low, high) = (format.min_code() as f64, format.max_code() as f64);
        let operand = |&versine: &f64| {
            let value = match design.lobe().interface.operand {
                Operand::Cos => 1.0 - versine,
                Operand::Versine => versine,
            };
            // Of a NaN 0.
            libm::round(value * one).clamp(low, high) as i32
        };
        Self { indices, operands: frame.versine.par_iter().map(operand).collect() }
    }

    /// The codes of `in_n` and of the operand of a sample; none where its versine is NaN.
    #[must_use]
    pub fn sample(&self, frame: &Frame, sample: usize) -> Option<(u32, i32)> {
        let material = || usize::from(frame.material[sample / frame.lights]);
        (!frame.versine[sample].is_nan()).then(|| (self.indices[material()], self.operands[sample]))
    }
}

/// The bit-exact model of a lobe's core.
#[derive(Clone, Copy, Debug)]
pub struct CoreModel<'a> {
    design: &'a Design,
}

impl<'a> CoreModel<'a> {
    /// The model of a core.
    ///
    /// # Errors
    /// A core that is no lobe.
    pub fn new(design: &'a Design) -> Result<Self, Error> {
        check_lobe(design)?;
        Ok(Self { design })
    }
}

/// Refuses a core that is no lobe.
fn check_lobe(design: &Design) -> Result<(), Error> {
    let kind = design.spec.block.kind();
    if kind == BlockKind::Lobe {
        return Ok(());
    }
    Err(Error::input(
        format!("the core {} is {}, and a picture's highlights need a lobe", design.spec.name, kind.noun()),
        "give a core without a `block`",
    ))
}

impl Highlights for CoreModel<'_> {
    fn of(&self, scene: &Scene, frame: &Frame) -> Result<Vec<f64>, Error> {
        // Each code that is asked for goes through the model once.
        let slots = Slots::of(self.design, scene, std::iter::once(frame));
        let (model, lsb) = (self.design.lobe().model(), self.design.lobe().output_format().lsb());
        let mut results = Vec::new();
        for (index, operands) in &slots.rows {
            let value = |&operand: &i64| f64::from(model.evaluate(*index, operand)) * lsb;
            results.par_extend(operands.par_iter().map(value));
        }
        Ok(slots.highlights(0, &results))
    }
}

/// A lobe's core itself, compiled by Verilator and given every sample in the frame's order, one a clock.
#[derive(Clone, Copy)]
pub struct Compiled<'a> {
    design: &'a Design,
    directory: &'a Path,
    progress: &'a dyn Fn(u64),
}

impl<'a> Compiled<'a> {
    /// The core in a directory, with its HDL, and the files of its ROM where it reads such; `progress` is told how many
    /// results have come.
    ///
    /// # Errors
    /// A core that is no lobe.
    pub fn new(design: &'a Design, directory: &'a Path, progress: &'a dyn Fn(u64)) -> Result<Self, Error> {
        check_lobe(design)?;
        Ok(Self { design, directory, progress })
    }
}

impl Highlights for Compiled<'_> {
    fn of(&self, scene: &Scene, frame: &Frame) -> Result<Vec<f64>, Error> {
        let codes = Codes::of(self.design, scene, frame);
        let inputs: Vec<(u32, i32)> =
            (0..frame.versine.len()).into_par_iter().filter_map(|sample| codes.sample(frame, sample)).collect();
        let results = cosim::stream(self.design.lobe(), self.directory, &inputs, self.progress)?;
        let lsb = self.design.lobe().output_format().lsb();
        let mut results = results.into_iter().map(|code| f64::from(code) * lsb);
        let value = |versine: &f64| if versine.is_nan() { Some(0.0) } else { results.next() };
        // As many as were asked for: `stream` sees to that.
        Ok(frame.versine.iter().map_while(value).collect())
    }
}
