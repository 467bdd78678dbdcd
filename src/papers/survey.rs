//! What is measured of every method at every shininess from 1 to 1000.

use rayon::prelude::*;

use super::measure::largest;
use super::method::{LEVEL, PaperMethod};
use crate::lobe::{Lobe, exact};
use crate::method::cubic_rational::CubicRational;
use crate::platform::error::Error;

/// The largest shininess of the papers' tables.
pub const MOST: usize = 1000;
/// The lower end of the range in which the quadratic's error is claimed.
pub const QUADRATIC_LEVEL: f64 = 0.56;
/// The ranges of the tail's claims, the higher level first.
pub const TAIL_BANDS: [(f64, f64); 3] = [(0.5, 0.42), (0.42, 0.37), (0.37, 0.27)];

/// The errors of one method at one shininess.
#[derive(Clone, Copy, Debug)]
pub struct Errors {
    /// The largest absolute error over all cosines in [0, 1].
    pub absolute: f64,
    /// The same on the epicentre, where x^n >= 1/2.
    pub absolute_epicentre: f64,
    /// The same outside the epicentre.
    pub absolute_tail: f64,
    /// The largest error relative to x^n on the epicentre.
    pub relative_epicentre: f64,
}

/// Everything measured at one shininess.
#[derive(Clone, Debug)]
pub struct SurveyRow {
    /// The shininess.
    pub n: usize,
    /// One for each of [`PaperMethod::ALL`].
    pub errors: Vec<Errors>,
    /// The quadratic's largest relative error where x^n >= 0.56.
    pub quadratic: f64,
    /// The rational tail's largest relative error where x^n lies in 0.42..0.5, 0.37..0.42 and 0.27..0.37.
    pub tail: [f64; 3],
    /// The same where the bands are levels of the tail itself, and the error is relative to the tail.
    pub tail_by_itself: [f64; 3],
}

impl SurveyRow {
    /// The errors of a method.
    #[must_use]
    pub fn of(&self, method: PaperMethod) -> Errors {
        let place = PaperMethod::ALL.iter().position(|&m| m == method).expect("the table has every method");
        self.errors[place]
    }

    fn measure(n: usize) -> Result<Self, Error> {
        let shininess = n as f64;
        let errors = PaperMethod::ALL.into_iter().map(|method| {
            let pieces = method.lobe(shininess)?;
            let (epicentre, tail) = (pieces.absolute(1.0, LEVEL), pieces.absolute(LEVEL, 0.0));
            Ok(Errors {
                absolute: epicentre.max(tail),
                absolute_epicentre: epicentre,
                absolute_tail: tail,
                relative_epicentre: pieces.relative(1.0, LEVEL),
            })
        });
        let rational = PaperMethod::CubicRational.lobe(shininess)?;
        // Past the cusp only, where the tail alone speaks: the step between the pieces is at the band's end.
        let tail = TAIL_BANDS.map(|(high, low)| rational.relative(high, low));
        let g = CubicRational::new(shininess, LEVEL)?;
        let tail_by_itself = TAIL_BANDS.map(|(high, low)| {
            let range = (tail_versine(&g, high), tail_versine(&g, low));
            largest(shininess, range, None, |u| (1.0 - exact(shininess, u) / g.at(u)).abs())
        });
        Ok(Self {
            n,
            errors: errors.collect::<Result<_, Error>>()?,
            quadratic: PaperMethod::Quadratic.lobe(shininess)?.relative(1.0, QUADRATIC_LEVEL),
            tail,
            tail_by_itself,
        })
    }
}

/// The versine where the tail `(1 - u) / (d + b u)` has the value `level`.
fn tail_versine(g: &CubicRational, level: f64) -> f64 {
    (1.0 - level * g.d) / (1.0 + level * g.b)
}

/// Measures n = 1 to 1000; `done` is called after each.
///
/// # Errors
/// None for these shininesses.
pub fn survey(done: &(dyn Fn() + Sync)) -> Result<Vec<SurveyRow>, Error> {
    (1..=MOST)
        .into_par_iter()
        .map(|n| {
            let row = SurveyRow::measure(n);
            done();
            row
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::measure::versine_at;
    use super::*;

    #[test]
    fn the_tails_levels_are_its_values() {
        let g = CubicRational::new(40.0, LEVEL).unwrap();
        for level in [0.5, 0.42, 0.27] {
            assert!((g.at(tail_versine(&g, level).max(g.cusp)) - level).abs() < 1e-13);
        }
        assert!((tail_versine(&g, LEVEL) - versine_at(40.0, LEVEL)).abs() < 1e-15);
    }
}
