//! The lobes that are one formula: `x^e ((1 - u (A - a u))⁺)^k`, left where it would rise again.

use serde::{Deserialize, Serialize};

use super::Fit;
use super::minimax::{self, Best, Piece, Pieces, Shape};
use super::target::{DEEP, Objective, Target, versine};
use crate::lobe::check_shininess;
use crate::platform::error::Error;

/// The inside `1 - u (A - a u)` of a power.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Power {
    /// The linear coefficient, about n / k.
    pub big_a: f64,
    /// The quadratic coefficient, about (n / k)^2 / 2 and less; 0 for a linear inside.
    pub a: f64,
}

/// The polynomial inside a power.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Inside {
    /// 1 - A u.
    Linear,
    /// 1 - u(A - a u).
    Quadratic,
}

/// A member of the family.
#[derive(Clone, Copy, Debug)]
pub struct Family {
    /// Whether there is a factor x.
    pub cosine: bool,
    /// k, a power of two.
    pub power: u32,
    /// Whether the lobe is held rather than cut where it would rise.
    pub hold: bool,
}

/// A form with scaled coefficients: `A unit` and, if there are two, `a unit^2`.
struct Scaled<'a> {
    form: &'a Family,
    unit: f64,
}

impl Scaled<'_> {
    fn coefficients<const D: usize>(&self, p: &[f64; D]) -> Power {
        Power { big_a: p[0] / self.unit, a: if D == 2 { p[1] / (self.unit * self.unit) } else { 0.0 } }
    }
}

impl<const D: usize> Shape<D> for Scaled<'_> {
    fn pieces(&self, p: &[f64; D]) -> Pieces {
        let Power { big_a, a } = self.coefficients(p);
        let whole = Pieces::one(Piece::Formula);
        let root = libm::sqrt(big_a * big_a - 4.0 * a);
        // The first zero; with no real root the comparison is false.
        let zero = 2.0 / (big_a + root);
        if zero > 0.0 {
            return if zero < 1.0 { whole.then(zero, Piece::Constant(0.0)) } else { whole };
        }
        if self.form.hold {
            // The zeros of the derivative -(3a u^2 - 2 (A + a) u + (1 + A)).
            let half = big_a + a;
            let minimum = (1.0 + big_a) / (half + libm::sqrt(half * half - 3.0 * a * (1.0 + big_a)));
            return if 0.0 < minimum && minimum < 1.0 {
                whole.then(minimum, Piece::Constant(self.formula(p, minimum)))
            } else {
                whole
            };
        }
        let vertex = big_a / (2.0 * a);
        if a <= 0.0 || vertex >= 1.0 {
            whole
        } else if vertex <= 0.0 {
            Pieces::one(Piece::Constant(0.0))
        } else {
            whole.then(vertex, Piece::Constant(0.0))
        }
    }

    fn formula(&self, p: &[f64; D], u: f64) -> f64 {
        let Power { big_a, a } = self.coefficients(p);
        let mut value = 1.0 - u * (big_a - a * u);
        let mut power = 1;
        while power < self.form.power {
            value *= value;
            power *= 2;
        }
        if self.form.cosine { value * (1.0 - u) } else { value }.min(1.0)
    }
}

/// Depths `-ln f` at which the starts interpolate, where the objective counts all f.
const DEPTHS: [f64; 13] = [0.05, 0.15, 0.35, 0.7, 1.05, 1.4, 1.9, 2.5, 3.2, 3.9, 4.6, 5.8, 7.0];

/// The best inside of a member of the family for the shininess `n`.
///
/// # Errors
/// A shininess outside 1..=2^20, or an objective with a level or a power out of its range.
pub fn best(n: f64, form: &Family, inside: Inside, objective: &Objective) -> Result<Fit<Power>, Error> {
    check_shininess(n)?;
    objective.check()?;
    // What the inside has to approximate: x^m.
    let m = (n - if form.cosine { 1.0 } else { 0.0 }) / f64::from(form.power);
    if m == 0.0 || m == 1.0 || (m == 2.0 && inside == Inside::Quadratic) {
        return Ok(Fit { coefficients: Power { big_a: m, a: 0.5 * m * (m - 1.0) }, error: 0.0 });
    }
    let fit = |objective: &Objective| match inside {
        Inside::Linear => {
            search(n, m, form, objective, |slopes, unit| slopes.iter().map(|&(_, slope)| [slope * unit]).collect())
        }
        Inside::Quadratic => search(n, m, form, objective, |slopes: &[(f64, f64)], unit| {
            let pairs = slopes
                .iter()
                .enumerate()
                .flat_map(|(i, &first)| slopes[i + 1..].iter().map(move |&second| (first, second)));
            let starts = pairs.flat_map(|((u, slope), (v, other)): ((f64, f64), (f64, f64))| {
                // Through both points; and through the first, with the minimum at the second, which is where a lobe is
                // cut.
                let a = (slope - other) / (v - u);
                let cut = slope / (2.0 * v - u);
                [(slope + a * u, a), (2.0 * v * cut, cut)]
            });
            starts.map(|(big_a, a)| [big_a * unit, a * unit * unit]).collect()
        }),
    };
    let found = fit(objective);
    if let Objective::MaxRel { level } = *objective
        && found.error > 1.0 - 1e-9
    {
        // Every zero above the level makes a relative error of 1, so that the objective leaves the coefficients open.
        let closest = fit(&Objective::MaxAbsLevel { level });
        let target = Target::whole(n, objective);
        let shape = Scaled { form, unit: 1.0 };
        let Power { big_a, a } = closest.coefficients;
        let error = minimax::largest_error(&shape, &target, &[big_a, a]);
        if error <= found.error.max(1.0) {
            return Ok(Fit { coefficients: closest.coefficients, error });
        }
    }
    Ok(found)
}

/// Fits from starts that a function makes of the slopes `(1 - x^m) / u` at some versines.
fn search<const D: usize>(
    n: f64,
    m: f64,
    form: &Family,
    objective: &Objective,
    starts: impl Fn(&[(f64, f64)], f64) -> Vec<[f64; D]>,
) -> Fit<Power> {
    let depths = match *objective {
        Objective::MaxAbs | Objective::Weighted { .. } => DEPTHS,
        Objective::MaxAbsLevel { level } | Objective::MaxRel { level } => {
            let deepest = (-libm::log(level)).min(DEEP);
            std::array::from_fn(|i| deepest * (i as f64 + 0.5) / 12.5)
        }
    };
    let slopes = depths.map(|depth| {
        let u = versine(n, depth);
        (u, -libm::expm1(-depth * (m / n)) / u)
    });
    let unit = versine(n, depths[4]);
    let shape = Scaled { form, unit };
    let target = Target::whole(n, objective);
    let Best { p, error } = minimax::minimise(&shape, &target, starts(&slopes, unit).into_iter(), 3);
    Fit { coefficients: shape.coefficients(&p), error }
}
