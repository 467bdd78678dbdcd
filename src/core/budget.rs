//! Where a shader's error comes from, measured.

use rayon::prelude::*;
use serde::Serialize;

use super::ShaderDesign;
use super::sample::Sample;
use crate::fixed::wide::Wide;
use crate::fixed::{Field, Rng};
use crate::lobe::exact;

/// The error of a part of the shader, in codes of a channel.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Part {
    /// Its name.
    pub name: &'static str,
    /// What is rounded or approximated in it.
    pub meaning: &'static str,
    /// The least and the greatest error.
    pub codes: [f64; 2],
    /// The root of its mean square over samples and channels.
    pub rms: f64,
}

/// The error account of a shader.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ShaderError {
    /// The samples measured.
    pub samples: u64,
    /// The parts, each switched from exact to what the hardware does with all before it switched already; they add up,
    /// sample by sample, to the whole.
    pub parts: Vec<Part>,
    /// `hardware - exact`.
    pub whole: Part,
}

const PARTS: [(&str, &str); 5] = [
    ("method", "the lobe's approximation in place of x^n"),
    ("input", "the vectors' components rounded to their ports"),
    ("front end", "scalar products and the cosine of the highlight rounded, 1/sqrt approximated"),
    ("coefficients", "the colours rounded to ROM words"),
    ("arithmetic", "the lobe's coefficients and roundings, the products' and the output's"),
];

/// Scenes of a measurement, shared out over the materials.
const SAMPLES: u64 = 1 << 18;

/// Sums over samples: least, greatest, squares; one a part and one of the whole.
type Sums = [[f64; 3]; PARTS.len() + 1];

impl ShaderError {
    /// Measures a shader over random samples that a camera may see ([`Sample::random`]).
    #[must_use]
    pub fn of(design: ShaderDesign<'_>) -> Self {
        let ShaderDesign { lobe, shader, .. } = design;
        let rows = design.materials().len();
        let step = rows.div_ceil(1 << 8);
        let measured: Vec<usize> = (0..rows).step_by(step).collect();
        let each = SAMPLES / measured.len() as u64;
        let lobes = lobe.lobes;
        let model = design.model();
        let of_row = |row: usize| {
            let mut rng = Rng::new(1 + row as u64);
            let n = lobe.interface.shininess.value(row);
            let mut sums: Sums = [[f64::INFINITY, f64::NEG_INFINITY, 0.0]; PARTS.len() + 1];
            for _ in 0..each {
                let sample = Sample::random(shader, row as u32, n, &mut rng);
                let rounded = sample.quantised(shader);
                let codes = sample.codes(shader);
                let lights = |sample: &Sample, highlight: &dyn Fn(f64) -> f64| -> Vec<(f64, f64)> {
                    // A versine of 1 gives no highlight: that of lights behind the surface is 1.
                    let of = |versine: f64| if versine >= 1.0 { 0.0 } else { highlight(versine) };
                    sample.angles(shader).iter().map(|angles| (angles.diffuse, of(angles.versine))).collect()
                };
                let power = |versine: f64| exact(n, versine);
                let method = |versine: f64| lobes[row].at(versine);
                let cosines = model.cosines(&codes);
                let in_hardware = |highlight: &dyn Fn(usize) -> f64| -> Vec<(f64, f64)> {
                    let of = |(light, cosines): (usize, &crate::block::shader::Cosines)| {
                        (cosines.diffuse.to_num::<f64>(), if cosines.lit { highlight(light) } else { 0.0 })
                    };
                    cosines.iter().enumerate().map(of).collect()
                };
                let front = in_hardware(&|light| {
                    let operand = cosines[light].operand;
                    let versine = if lobe.takes_versine() { operand } else { Wide::ONE - operand };
                    lobes[row].at(versine.to_num())
                });
                let real = |field: &Field, row: usize| field.reals[row];
                let stored = |field: &Field, row: usize| field.value(row);
                let channels = |sample: &Sample, lights: &[(f64, f64)]| sample.channels(design, lights, real);
                let hardware = design.sample_of(&[model.evaluate(&codes)]);
                let stages = [
                    channels(&sample, &lights(&sample, &power)),
                    channels(&sample, &lights(&sample, &method)),
                    channels(&rounded, &lights(&rounded, &method)),
                    channels(&rounded, &front),
                    sample.channels(design, &front, stored),
                    [0, 1, 2].map(|channel| hardware[channel] as f64),
                ];
                for channel in [0, 1, 2] {
                    let at = |stage: usize| stages[stage][channel];
                    for (part, sum) in sums.iter_mut().enumerate() {
                        let (from, to) = if part < PARTS.len() { (part, part + 1) } else { (0, PARTS.len()) };
                        let error = at(to) - at(from);
                        *sum = [sum[0].min(error), sum[1].max(error), sum[2] + error * error];
                    }
                }
            }
            sums
        };
        let by_row: Vec<Sums> = measured.into_par_iter().map(of_row).collect();
        let samples = each * by_row.len() as u64;
        // In order, so that the sums are the same on every machine.
        let part = |index: usize, (name, meaning): (&'static str, &'static str)| {
            let total =
                by_row.iter().map(|sums| sums[index]).reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1]), a[2] + b[2]]);
            let [low, high, square] = total.unwrap_or_default();
            Part { name, meaning, codes: [low, high], rms: libm::sqrt(square / (3 * samples) as f64) }
        };
        Self {
            samples,
            parts: PARTS.into_iter().enumerate().map(|(index, texts)| part(index, texts)).collect(),
            whole: part(PARTS.len(), ("whole", "hardware - exact")),
        }
    }
}
