//! The claims of Q, on its quadratic and on the lobes before it.

use super::claims::{count, datapath, how_many, most, most_real, percent, shininesses, value};
use super::measure::{largest, rises, versine_at};
use super::method::PaperMethod;
use super::survey::{MOST, QUADRATIC_LEVEL, SurveyRow};
use super::{Claim, Finding, Taylor, TaylorSeries};
use crate::lobe::{Lobe, exact};
use crate::method::quadratic::Quadratic;
use crate::platform::error::Error;

pub(super) fn quadratic_error(rows: &[SurveyRow]) -> Result<Claim, Error> {
    let (claimed, all) = (most(rows, 512, |row| row.quadratic), most(rows, MOST, |row| row.quadratic));
    let real = most_real(PaperMethod::Quadratic, |pieces| pieces.relative(1.0, QUADRATIC_LEVEL))?;
    Ok(Claim::of(
        "quadratic-error",
        vec![
            percent("relative; n <= 512", claimed),
            percent("relative; n <= 1000", all),
            percent("relative; real n <= 16 by 64ths", real),
        ],
        Finding::of(claimed.max(real) <= 0.04),
    ))
}

/// `max(0, x (1 - a u))` through the power's point at γ = arctan(1/(n-1)), as the text layer prints eq. 7.
pub(super) fn quadratic_printed_angle() -> Result<Claim, Error> {
    let mut worst = 0.0f64;
    for n in shininesses().skip(1).take(511) {
        let t = (n - 1.0) / libm::sqrt(1.0 + (n - 1.0) * (n - 1.0));
        let lobe = Quadratic { a: (1.0 - libm::pow(t, n - 1.0)) / (1.0 - t) };
        let range = (0.0, versine_at(n, QUADRATIC_LEVEL));
        worst = worst.max(largest(n, range, Some(lobe.zero()), |u| (lobe.at(u) / exact(n, u) - 1.0).abs()));
    }
    Ok(Claim::of(
        "quadratic-angle",
        vec![percent("relative; n = 2 to 512", worst)],
        if worst <= 0.04 { Finding::Holds } else { Finding::Only("with arctan(1/sqrt(n-1))".to_owned()) },
    ))
}

pub(super) fn quadratic_periphery() -> Result<Claim, Error> {
    let printed = |a: f64| move |u: f64| (1.0 - u) * (1.0 - a * u);
    let rising = how_many(|n| {
        let f = printed(Quadratic::new(n)?.a);
        Ok(rises(n, (0.0, 1.0), f))
    })?;
    let cut = how_many(|n| {
        let lobe = Quadratic::new(n)?;
        Ok(rises(n, (0.0, 1.0), |u| lobe.at(u)))
    })?;
    let f = printed(Quadratic::new(1000.0)?.a);
    Ok(Claim::of(
        "quadratic-periphery",
        vec![
            count("n of 1000 that rise; as printed", rising),
            value("least value; as printed; n = 1000", -largest(1000.0, (0.0, 1.0), None, |u| -f(u))),
            count("n of 1000 that rise; cut at 0", cut),
        ],
        match (rising, cut) {
            (0, _) => Finding::Holds,
            (_, 0) => Finding::Only("for the lobe cut at 0".to_owned()),
            _ => Finding::DoesNotHold,
        },
    ))
}

pub(super) fn quadratic_block() -> Result<Claim, Error> {
    let (printed, ours) = (datapath("quadratic", "paper")?, datapath("quadratic", "stable")?);
    let multipliers = printed.function().multipliers().len();
    Ok(Claim::of(
        "quadratic-block",
        vec![
            count("multipliers of the printed form", multipliers),
            count("multipliers of x(1 - a u)", ours.function().multipliers().len()),
        ],
        Finding::of(multipliers == 2),
    ))
}

pub(super) fn schlick(rows: &[SurveyRow]) -> Claim {
    let inside = most(rows, MOST, |row| row.of(PaperMethod::Schlick).absolute_epicentre);
    let outside = most(rows, MOST, |row| row.of(PaperMethod::Schlick).absolute_tail);
    Claim::of(
        "schlick-epicentre",
        vec![percent("absolute; on the epicentre; n <= 1000", inside), percent("absolute; beyond; n <= 1000", outside)],
        Finding::of(outside > inside),
    )
}

pub(super) fn chord() -> Claim {
    // cos^n of the chord D = 2 sin(γ/2) against cos^n of the angle γ.
    let change = |n: f64| {
        largest(n, (0.0, 1.0), None, |u| (libm::pow(libm::cos(libm::sqrt(2.0 * u)).max(0.0), n) - exact(n, u)).abs())
    };
    let (wide, narrow) = (change(1.0), change(1000.0));
    Claim::of(
        "chord",
        vec![percent("change of x^n; n = 1; all angles", wide), percent("change of x^n; n = 1000; all angles", narrow)],
        Finding::of(narrow < 0.1 * wide),
    )
}

pub(super) fn taylor(rows: &[SurveyRow]) -> Result<Claim, Error> {
    let chord = PaperMethod::Taylor(TaylorSeries::Chord);
    let inside = most(rows, MOST, |row| row.of(chord).absolute_epicentre);
    let cubic = most(rows, MOST, |row| row.of(PaperMethod::Cubic).absolute_epicentre);
    Ok(Claim::of(
        "taylor",
        vec![
            percent("three terms; absolute; on the epicentre; n <= 1000", inside),
            percent("the cubic; absolute; on the epicentre; n <= 1000", cubic),
            value("sum of three terms at 90 degrees; n = 1000", Taylor::new(1000.0, TaylorSeries::Chord)?.sum(1.0)),
        ],
        Finding::of(inside > cubic),
    ))
}

pub(super) fn cos_k(rows: &[SurveyRow]) -> Claim {
    // Below n = k the angle is stretched, which nobody proposes.
    let of = |method: PaperMethod, k: u32| {
        most(&rows[k as usize - 1..], MOST + 1 - k as usize, |row| row.of(method).absolute)
    };
    let [two, four, eight] = [2, 4, 8].map(|k| of(PaperMethod::CosK(k), k));
    let lyon = [2, 4, 8].map(|k| of(PaperMethod::Lyon(k), k));
    let schlick = of(PaperMethod::Schlick, 1);
    Claim::of(
        "cos-k",
        vec![
            percent("k = 2; absolute; all angles; n <= 1000", two),
            percent("k = 4; absolute; all angles; n <= 1000", four),
            percent("k = 8; absolute; all angles; n <= 1000", eight),
            percent("Lyon with k = 2; absolute; all angles; n <= 1000", lyon[0]),
            percent("Lyon with k = 4; absolute; all angles; n <= 1000", lyon[1]),
            percent("Lyon with k = 8; absolute; all angles; n <= 1000", lyon[2]),
            percent("Schlick; absolute; all angles; n <= 1000", schlick),
        ],
        Finding::of(two.max(four).max(eight) < schlick && two < lyon[0] && four < lyon[1] && eight < lyon[2]),
    )
}
