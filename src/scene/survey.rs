//! Where on their lobes a picture's samples lie, material by material.

use serde::Serialize;

use super::frame::BACKGROUND;
use super::{Frame, Scene};
use crate::lobe;

/// Bins of [`Spread::scaled`].
pub const SCALED_BINS: usize = 64;
/// Bins of `s = n u` to 1.
const BINS_OF_ONE: f64 = 4.0;
/// Bins of [`Spread::degrees`], of 2 degrees each.
pub const DEGREE_BINS: usize = 90;

/// How many samples there are of each kind. A sample is a pixel of an object under one light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Counts {
    /// All of them.
    pub samples: u64,
    /// Those of materials that have no highlight: k_s times every light is 0.
    pub matte: u64,
    /// Of the rest, those that the light does not reach: it is behind the surface or in shadow.
    pub dark: u64,
    /// Those with a negative cosine, whose highlight is 0.
    pub negative: u64,
    /// Those on the epicentre: `x^n >= 1/2`.
    pub epicentre: u64,
    /// Those below it whose highlight is half an output step or more.
    pub visible_tail: u64,
    /// Those below it whose highlight is less.
    pub invisible_tail: u64,
}

impl Counts {
    fn add(&mut self, other: &Self) {
        let Self { samples, matte, dark, negative, epicentre, visible_tail, invisible_tail } = other;
        self.samples += samples;
        self.matte += matte;
        self.dark += dark;
        self.negative += negative;
        self.epicentre += epicentre;
        self.visible_tail += visible_tail;
        self.invisible_tail += invisible_tail;
    }

    /// Those that ask for a lobe: lit, of a material with a highlight.
    #[must_use]
    pub fn lit(&self) -> u64 {
        self.negative + self.epicentre + self.visible_tail + self.invisible_tail
    }

    /// The sum of two.
    #[must_use]
    pub fn and(mut self, other: &Self) -> Self {
        self.add(other);
        self
    }
}

/// How the cosines of a material's highlights are distributed, over base and moved pictures.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Spread {
    /// How many lie in each quarter of `s = n (1 - x)`, from 0; the last bin holds all beyond.
    pub scaled: Vec<u64>,
    /// How many lie in each 2 degrees of the angle whose cosine is x, from 0 to 180.
    pub degrees: Vec<u64>,
}

/// What a frame's samples are, material by material.
#[derive(Clone)]
pub(super) struct Survey {
    pub counts: Vec<Counts>,
    pub least: Vec<f64>,
    pub spreads: Vec<Spread>,
    pub saturated: u64,
}

impl Survey {
    pub(super) fn new(materials: usize) -> Self {
        let spread = Spread { scaled: vec![0; SCALED_BINS], degrees: vec![0; DEGREE_BINS] };
        Self {
            counts: vec![Counts::default(); materials],
            least: vec![f64::INFINITY; materials],
            spreads: vec![spread; materials],
            saturated: 0,
        }
    }

    pub(super) fn of(scene: &Scene, frame: &Frame) -> Self {
        let full = scene.full_scale();
        let lights = frame.lights;
        let weights = frame.weights(scene);
        let strength = |material: usize, light: usize| weights[material][light].into_iter().fold(0.0, f64::max);
        let mut survey = Self::new(scene.materials.len());
        for (pixel, &material) in frame.material.iter().enumerate() {
            let mut sum = frame.base[pixel];
            if material == BACKGROUND {
                continue;
            }
            let material = usize::from(material);
            let n = scene.materials[material].shininess;
            let matte = (0..lights).all(|light| strength(material, light) == 0.0);
            let counts = &mut survey.counts[material];
            for (light, &versine) in frame.versine[pixel * lights..][..lights].iter().enumerate() {
                counts.samples += 1;
                if matte {
                    counts.matte += 1;
                    continue;
                }
                if versine.is_nan() {
                    counts.dark += 1;
                    continue;
                }
                let spread = &mut survey.spreads[material];
                spread.scaled[((n * versine * BINS_OF_ONE) as usize).min(SCALED_BINS - 1)] += 1;
                let degrees = lobe::degrees(versine.min(2.0));
                spread.degrees[((degrees * DEGREE_BINS as f64 / 180.0) as usize).min(DEGREE_BINS - 1)] += 1;
                survey.least[material] = survey.least[material].min(1.0 - versine);
                if versine > 1.0 {
                    counts.negative += 1;
                    continue;
                }
                let value = lobe::exact(n, versine);
                let steps = strength(material, light) * value * full;
                *(match value {
                    value if value >= 0.5 => &mut counts.epicentre,
                    _ if steps >= 0.5 => &mut counts.visible_tail,
                    _ => &mut counts.invisible_tail,
                }) += 1;
                sum = [0, 1, 2].map(|c| sum[c] + weights[material][light][c] * value);
            }
            survey.saturated += u64::from(sum.iter().any(|&channel| channel > 1.0));
        }
        survey
    }

    pub(super) fn and(mut self, other: &Self) -> Self {
        for (material, counts) in other.counts.iter().enumerate() {
            self.counts[material].add(counts);
            self.least[material] = self.least[material].min(other.least[material]);
            let (own, other) = (&mut self.spreads[material], &other.spreads[material]);
            own.scaled.iter_mut().zip(&other.scaled).for_each(|(own, other)| *own += other);
            own.degrees.iter_mut().zip(&other.degrees).for_each(|(own, other)| *own += other);
        }
        self.saturated += other.saturated;
        self
    }
}
