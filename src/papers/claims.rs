//! The list of claims that are measured on lobes, and what measuring them shares.

use super::method::{PaperMethod, Pieces};
use super::survey::{MOST, SurveyRow};
use super::{Claim, Figure, Unit, cubic, images, quadratic};
use crate::core::Design;
use crate::platform::error::Error;
use crate::spec::SpecFields;

/// An error below which two results of the same thing are rounding apart: no ratio is taken of it.
pub(super) const ROUNDING: f64 = 1e-9;

pub(super) fn percent(name: &'static str, fraction: f64) -> Figure {
    Figure { name, value: 100.0 * fraction, unit: Unit::Percent }
}

pub(super) fn times(name: &'static str, value: f64) -> Figure {
    Figure { name, value, unit: Unit::Times }
}

pub(super) fn count(name: &'static str, number: usize) -> Figure {
    Figure { name, value: number as f64, unit: Unit::Count }
}

pub(super) fn value(name: &'static str, value: f64) -> Figure {
    Figure { name, value, unit: Unit::Value }
}

/// The largest of `f` for n up to `most`.
pub(super) fn most(rows: &[SurveyRow], most: usize, f: impl Fn(&SurveyRow) -> f64) -> f64 {
    rows[..most].iter().map(f).fold(0.0, f64::max)
}

pub(super) fn shininesses() -> impl Iterator<Item = f64> {
    (1..=MOST).map(|n| n as f64)
}

/// The shininesses of 1..=1000 where `f` holds.
pub(super) fn those(f: impl Fn(f64) -> Result<bool, Error>) -> Result<Vec<f64>, Error> {
    let mut found = Vec::new();
    for n in shininesses() {
        if f(n)? {
            found.push(n);
        }
    }
    Ok(found)
}

/// The number of shininesses of 1..=1000 where `f` holds.
pub(super) fn how_many(f: impl Fn(f64) -> Result<bool, Error>) -> Result<usize, Error> {
    Ok(those(f)?.len())
}

/// Real shininesses between the small integers, where a method's behaviour changes most: 1 to 16 by 64ths.
pub(super) fn real_shininesses() -> impl Iterator<Item = f64> {
    (64..=16 * 64).map(|step| f64::from(step) / 64.0)
}

/// The largest of an error of a method's lobes for the real shininesses.
pub(super) fn most_real(method: PaperMethod, error: impl Fn(&Pieces) -> f64) -> Result<f64, Error> {
    real_shininesses().try_fold(0.0, |worst: f64, n| Ok(worst.max(error(&method.lobe(n)?))))
}

/// A core that is small to build, for counting its operations.
pub(super) fn datapath(method: &str, form: &str) -> Result<Design, Error> {
    let text = format!("method = '{method}'\nform = '{form}'\nshininess = [25]");
    Design::new(SpecFields::parse(&text, "claims")?.resolve()?)
}

/// All claims, from the rows of [`survey`](super::survey()).
///
/// # Errors
/// None for the papers' parameters.
pub fn claims(rows: &[SurveyRow]) -> Result<Vec<Claim>, Error> {
    let mut claims = vec![
        quadratic::quadratic_error(rows)?,
        quadratic::quadratic_printed_angle()?,
        quadratic::quadratic_periphery()?,
        quadratic::quadratic_block()?,
        quadratic::schlick(rows),
        quadratic::chord(),
        quadratic::taylor(rows)?,
        quadratic::cos_k(rows),
        cubic::cubic_relative(rows)?,
        cubic::cubic_absolute(rows)?,
        cubic::schlick_relative(rows),
        cubic::schlick_absolute(rows),
        cubic::closed_form()?,
        cubic::cubic_rises()?,
        cubic::cubic_negative()?,
    ];
    claims.extend(cubic::tail(rows));
    claims.extend([
        cubic::tail_closed_form()?,
        cubic::tail_against_schlick(rows),
        cubic::tail_falls()?,
        cubic::three_point_negative()?,
        cubic::three_point_levels()?,
        cubic::three_point_closed_form(),
        cubic::operations()?,
        cubic::extrema()?,
        cubic::min_zero()?,
    ]);
    claims.extend(images::claims()?);
    Ok(claims)
}
