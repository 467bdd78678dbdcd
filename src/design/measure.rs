//! The error, measured on the bit-exact arithmetic.

use rayon::prelude::*;
use serde::Serialize;

use super::Design;
use crate::lobe;

/// The most inputs that a measurement evaluates: about a second on two cores.
const MOST_INPUTS: u64 = 1 << 27;

/// Which inputs a measurement goes over: every shininess, and the cosines in [0, 1].
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Sweep {
    /// Every `step`th versine code is taken.
    pub step: u64,
    /// Every `row_step`th row is taken.
    pub row_step: u64,
    /// How many inputs that makes.
    pub inputs: u64,
    /// Whether that is all of them.
    pub exhaustive: bool,
}

impl Sweep {
    fn of(design: &Design) -> Self {
        let codes = (1u64 << design.spec.input_fraction) + 1;
        let rows = design.spec.shininess.rows() as u64;
        // Rows are thinned only when a thousand versines each would still be too many.
        let step = (codes * rows).div_ceil(MOST_INPUTS).min(codes.div_ceil(1024)).max(1);
        let row_step = (codes.div_ceil(step) * rows).div_ceil(MOST_INPUTS).max(1);
        let inputs = codes.div_ceil(step) * rows.div_ceil(row_step);
        Self { step, row_step, inputs, exhaustive: step == 1 && row_step == 1 }
    }
}

/// What was measured.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Measured {
    /// Over which inputs.
    pub sweep: Sweep,
    /// The least and the greatest `hardware - method` in output ulps.
    pub ulps: [f64; 2],
    /// The largest |hardware - x^n|.
    pub max_abs: f64,
    /// The largest |hardware - x^n| where x^n >= 1/2.
    pub max_abs_epicentre: f64,
    /// The largest |hardware - x^n| / x^n where x^n >= 1/2.
    pub max_rel_epicentre: f64,
    /// The root of the mean square of hardware - x^n over the cosines, averaged over the rows.
    pub rms: f64,
}

impl Measured {
    const NONE: [f64; 7] = [0.0; 7];

    /// Measures a design.
    #[must_use]
    pub fn of(design: &Design) -> Self {
        let sweep = Sweep::of(design);
        let lobes = design.lobes();
        let shininess = design.spec.shininess.values();
        let scale = crate::number::exp2(design.spec.output_fraction as i32);
        let codes = (1i64 << design.spec.input_fraction) + 1;
        let step = sweep.step as usize;
        let evaluator = design.evaluator();
        let logs: Vec<f64> = (0..codes)
            .step_by(step)
            .map(|code| libm::log1p(-design.versine(design.operand_of_versine(code))))
            .collect();

        let row = |row: usize| {
            let index = design.spec.shininess.index_of_row(row);
            let mut total = Self::NONE;
            let mut square = 0.0;
            let mut outputs = vec![0u32; 4096];
            let mut code = 0i64;
            while code < codes {
                let count = (outputs.len() as i64).min((codes - code + step as i64 - 1) / step as i64) as usize;
                // The operand's codes rise or fall with the versine's; the evaluator goes upwards.
                let end = code + ((count - 1) * step) as i64;
                let first = design.operand_of_versine(code).min(design.operand_of_versine(end));
                evaluator.evaluate(index, first, step as i64, &mut outputs[..count]);
                for (offset, &output) in outputs[..count].iter().enumerate() {
                    let operand = first + (offset * step) as i64;
                    let u = design.versine(operand);
                    let hardware = f64::from(output) / scale;
                    let error = hardware * scale - lobes[row].at(u) * scale;
                    let log = logs[design.operand_of_versine(operand) as usize / step] * shininess[row];
                    // Below e^-40 the power is nothing beside an ulp.
                    let exact = if log < -40.0 { 0.0 } else { libm::exp(log) };
                    let off = (hardware - exact).abs();
                    total[0] = total[0].min(error);
                    total[1] = total[1].max(error);
                    total[2] = total[2].max(off);
                    if exact >= 0.5 {
                        total[3] = total[3].max(off);
                        total[4] = total[4].max(off / exact);
                    }
                    square += off * off;
                }
                code += (count * step) as i64;
            }
            total[5] = square;
            total[6] = 1.0;
            total
        };
        let rows: Vec<usize> = (0..design.spec.shininess.rows()).step_by(sweep.row_step as usize).collect();
        let parts: Vec<[f64; 7]> = rows.into_par_iter().map(row).collect();
        // In order, so that the sum is the same on every machine.
        let total = parts.into_iter().fold(Self::NONE, |a, b| {
            [a[0].min(b[0]), a[1].max(b[1]), a[2].max(b[2]), a[3].max(b[3]), a[4].max(b[4]), a[5] + b[5], a[6] + b[6]]
        });
        Self {
            sweep,
            ulps: [total[0], total[1]],
            max_abs: total[2],
            max_abs_epicentre: total[3],
            max_rel_epicentre: total[4],
            rms: (total[5] / sweep.inputs as f64).sqrt(),
        }
    }
}

/// The exact lobe at an operand code.
impl Design {
    /// `x^n` for a row at an operand code.
    #[must_use]
    pub fn exact(&self, row: usize, operand: i64) -> f64 {
        lobe::exact(self.spec.shininess.value(row), self.versine(operand))
    }
}
