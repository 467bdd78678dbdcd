//! The error, measured on the bit-exact arithmetic.

use rayon::prelude::*;
use serde::Serialize;

use super::LobeDesign;

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
    fn of(lobe: LobeDesign<'_>) -> Self {
        let codes = (1u64 << lobe.interface.input_fraction) + 1;
        let rows = lobe.interface.shininess.rows() as u64;
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
    /// Where it is that large: the shininess and the versine; of equals the first shininess.
    #[serde(skip)]
    pub worst: [f64; 2],
    /// The largest |hardware - x^n| where x^n >= 1/2.
    pub max_abs_epicentre: f64,
    /// The largest |hardware - x^n| / x^n where x^n >= 1/2.
    pub max_rel_epicentre: f64,
    /// The root of the mean square of hardware - x^n over the cosines, averaged over the rows.
    pub rms: f64,
}

/// Below this a difference may be the rounding of exponential and logarithm.
const ROUNDED: f64 = 1e-14;

/// `x^n` of a versine with so many fraction bits, where a double holds it: of a small whole n.
fn exact_power(n: f64, versine: f64, frac_bits: u32) -> Option<f64> {
    let holds = n.fract() == 0.0 && n * f64::from(frac_bits) <= f64::from(f64::MANTISSA_DIGITS);
    holds.then(|| (0..n as u32).fold(1.0, |power, _| power * (1.0 - versine)))
}

impl Measured {
    const NONE: [f64; 7] = [0.0; 7];

    /// Measures a lobe.
    #[must_use]
    pub fn of(lobe: LobeDesign<'_>) -> Self {
        Self::with_rows(lobe).0
    }

    /// As [`Measured::of`], with the largest |hardware - x^n| of each row that was measured, in order.
    #[must_use]
    pub fn with_rows(lobe: LobeDesign<'_>) -> (Self, Vec<f64>) {
        let sweep = Sweep::of(lobe);
        let lobes = lobe.lobes;
        let shininess = lobe.interface.shininess.values();
        let scale = crate::fixed::exp2(lobe.interface.output_fraction as i32);
        let codes = (1i64 << lobe.interface.input_fraction) + 1;
        let step = sweep.step as usize;
        let evaluator = lobe.evaluator();
        let logs: Vec<f64> =
            (0..codes).step_by(step).map(|code| libm::log1p(-lobe.versine(lobe.operand_of_versine(code)))).collect();

        let row = |row: usize| -> ([f64; 7], [f64; 2]) {
            let mut worst = [shininess[row], 0.0];
            let index = lobe.interface.shininess.index_of_row(row);
            let mut total = Self::NONE;
            let mut square = 0.0;
            let mut outputs = vec![0u32; 4096];
            let mut code = 0i64;
            while code < codes {
                let count = (outputs.len() as i64).min((codes - code + step as i64 - 1) / step as i64) as usize;
                // The operand's codes rise or fall with the versine's; the evaluator goes upwards.
                let end = code + ((count - 1) * step) as i64;
                let first = lobe.operand_of_versine(code).min(lobe.operand_of_versine(end));
                evaluator.evaluate(index, first, step as i64, &mut outputs[..count]);
                for (offset, &output) in outputs[..count].iter().enumerate() {
                    let operand = first + (offset * step) as i64;
                    let u = lobe.versine(operand);
                    let hardware = f64::from(output) / scale;
                    let error = hardware * scale - lobes[row].at(u) * scale;
                    let log = logs[lobe.operand_of_versine(operand) as usize / step] * shininess[row];
                    // Below e^-40 the power is nothing beside an ulp.
                    let exact = if log < -40.0 { 0.0 } else { libm::exp(log) };
                    let mut off = (hardware - exact).abs();
                    // Exponential and logarithm round; where the power itself does not, the difference has no such
                    // rest.
                    if off < ROUNDED
                        && let Some(power) = exact_power(shininess[row], u, lobe.interface.input_fraction)
                    {
                        off = (hardware - power).abs();
                    }
                    total[0] = total[0].min(error);
                    total[1] = total[1].max(error);
                    if off > total[2] {
                        (total[2], worst[1]) = (off, u);
                    }
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
            (total, worst)
        };
        let rows: Vec<usize> = (0..lobe.interface.shininess.rows()).step_by(sweep.row_step as usize).collect();
        let parts: Vec<([f64; 7], [f64; 2])> = rows.into_par_iter().map(row).collect();
        let by_row = parts.iter().map(|(part, _)| part[2]).collect();
        // In order, so that the sum is the same on every machine.
        let (total, worst) = parts.into_iter().fold((Self::NONE, [shininess[0], 0.0]), |(a, worst), (b, at)| {
            let worst = if b[2] > a[2] { at } else { worst };
            let [low, high, abs, near, relative] =
                [a[0].min(b[0]), a[1].max(b[1]), a[2].max(b[2]), a[3].max(b[3]), a[4].max(b[4])];
            ([low, high, abs, near, relative, a[5] + b[5], a[6] + b[6]], worst)
        });
        let measured = Self {
            sweep,
            ulps: [total[0], total[1]],
            max_abs: total[2],
            worst,
            max_abs_epicentre: total[3],
            max_rel_epicentre: total[4],
            rms: (total[5] / sweep.inputs as f64).sqrt(),
        };
        (measured, by_row)
    }
}
