//! One core for one family, with its error and its cost.

use serde::{Deserialize, Serialize};

use crate::synth::{Family, Synthesis, Tools};

/// One core for one family: a row of the results.
///
/// Errors are those of the bit-exact arithmetic against `x^n`, as parts of 1, over the inputs that `checked` says.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Point {
    /// 16 hexadecimal digits that stand for the spec and the family.
    pub id: String,
    /// A short name for people, such as `power-4 G16`.
    pub name: String,
    /// What the core is built for.
    pub family: Family,
    /// The method, as it is written in a spec.
    pub method: String,
    /// Where the coefficients come from: `paper`, `minimax`, or nothing for a method that has none.
    pub coefficients: String,
    /// The other keys of the spec that differ from the method's defaults: `key=value key=value`.
    pub variant: String,
    /// Whether the method is there to be compared with: it is none of the project's own.
    pub baseline: bool,
    /// The shininesses served: `1..=1000`, `8 values` or `8 materials`.
    pub shininess: String,
    /// How many they are.
    pub rows: u32,
    /// F: fraction bits of the input.
    pub input_fraction: u32,
    /// G: fraction bits of the output.
    pub output_fraction: u32,
    /// The pipeline, as it is written in a spec: a depth or `auto`.
    pub pipeline: String,
    /// The largest |result - x^n|.
    pub max_abs: f64,
    /// The largest |result - x^n| / x^n where x^n >= 1/2.
    pub max_rel: f64,
    /// The root of the mean square of result - x^n.
    pub rms: f64,
    /// The shininess at which the error is `max_abs`.
    pub worst_n: f64,
    /// The cosine at which the error is `max_abs`.
    pub worst_x: f64,
    /// Over which inputs: `exhaustive` (every shininess, every code of the operand in [0, 1]), or `subset: ` and which.
    pub checked: String,
    /// The proved bound of |result - real-valued method| over every input.
    pub bound: f64,
    /// The bits of all memories.
    pub rom_bits: u64,
    /// Clocks from input to output.
    pub latency: u32,
    /// What the tools made of it.
    pub synthesis: Option<Synthesis>,
    /// What the cost model says of it.
    pub estimate: Option<Estimate>,
    /// Why there is no error or no cost; the figures that are missing are 0.
    pub failure: Option<String>,
    /// The spec, every default resolved, as TOML.
    pub spec: String,
}

/// What a cost model says of a core.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Estimate {
    /// The tools whose results the model follows.
    pub tools: Tools,
    /// The number of measured points that it was fitted to.
    pub points: u32,
    /// LUTs that are used up, as [`crate::synth::Resources::lut_total`].
    pub lut: u32,
    /// Flip-flops.
    pub ff: u32,
    /// DSP blocks.
    pub dsp: u32,
    /// Block RAMs.
    pub bram: u32,
    /// The frequency in MHz, where the points that it was fitted to have one.
    pub mhz: Option<f64>,
}

/// What a core takes, measured or estimated.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Cost {
    /// LUTs that are used up, carry chains counted: [`crate::synth::Resources::lut_total`].
    pub lut: u32,
    /// Flip-flops.
    pub ff: u32,
    /// DSP blocks.
    pub dsp: u32,
    /// Block RAMs.
    pub bram: u32,
    /// Clocks from input to output.
    pub latency: u32,
    /// The median frequency in MHz over the seeds, or an estimate of it; none of a core that was not placed.
    pub mhz: Option<f64>,
    /// Whether the figures come from a model and not from the tools.
    pub estimated: bool,
}

impl Point {
    /// What the core takes: as measured, or else as estimated; none of a point that failed.
    #[must_use]
    pub fn cost(&self) -> Option<Cost> {
        let latency = self.latency;
        if let (Some(synthesis), None) = (&self.synthesis, &self.failure) {
            let resources = &synthesis.resources;
            return Some(Cost {
                lut: resources.lut_total,
                ff: resources.ff,
                dsp: resources.dsp,
                bram: resources.bram,
                latency,
                mhz: synthesis.timing.as_ref().map(|timing| timing.median_mhz),
                estimated: false,
            });
        }
        let estimate = self.estimate.as_ref().filter(|_| self.failure.is_none())?;
        let &Estimate { lut, ff, dsp, bram, mhz, .. } = estimate;
        Some(Cost { lut, ff, dsp, bram, latency, mhz, estimated: true })
    }

    /// The tools whose figures these are.
    #[must_use]
    pub fn tools(&self) -> Option<&Tools> {
        let synthesis = self.synthesis.as_ref().map(|synthesis| &synthesis.tools);
        synthesis.or_else(|| self.estimate.as_ref().map(|estimate| &estimate.tools))
    }
}
