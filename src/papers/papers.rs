//! The list of claims, each with how it is measured.

use super::measure::{grid, largest, rises, versine_at};
use super::method::{LEVEL, Method, Pieces, three_point};
use super::survey::{Errors, MOST, QUADRATIC_LEVEL, Row, TAIL_BANDS};
use super::{Claim, Figure, Unit, Verdict, images};
use crate::core::Design;
use crate::lobe::{Lobe, exact};
use crate::method::cubic::Cubic;
use crate::method::cubic_min_zero::MinZero;
use crate::method::cubic_rational::CubicRational;
use crate::method::quadratic::Quadratic;
use crate::papers::Taylor;
use crate::papers::TaylorSeries;
use crate::platform::error::Error;
use crate::spec::SpecFields;

/// An error below which two results of the same thing are rounding apart: no ratio is taken of it.
const ROUNDING: f64 = 1e-9;

fn percent(name: &'static str, fraction: f64) -> Figure {
    Figure { name, value: 100.0 * fraction, unit: Unit::Percent }
}

fn times(name: &'static str, value: f64) -> Figure {
    Figure { name, value, unit: Unit::Times }
}

fn count(name: &'static str, number: usize) -> Figure {
    Figure { name, value: number as f64, unit: Unit::Count }
}

fn value(name: &'static str, value: f64) -> Figure {
    Figure { name, value, unit: Unit::Value }
}

/// The largest of `f` for n up to `most`.
fn most(rows: &[Row], most: usize, f: impl Fn(&Row) -> f64) -> f64 {
    rows[..most].iter().map(f).fold(0.0, f64::max)
}

/// The first n where `f` holds, or one past the last.
fn first(rows: &[Row], f: impl Fn(&Row) -> bool) -> usize {
    rows.iter().find(|row| f(row)).map_or(MOST + 1, |row| row.n)
}

fn shininesses() -> impl Iterator<Item = f64> {
    (1..=MOST).map(|n| n as f64)
}

/// The shininesses of 1..=1000 where `f` holds.
fn those(f: impl Fn(f64) -> Result<bool, Error>) -> Result<Vec<f64>, Error> {
    let mut found = Vec::new();
    for n in shininesses() {
        if f(n)? {
            found.push(n);
        }
    }
    Ok(found)
}

/// The number of shininesses of 1..=1000 where `f` holds.
fn how_many(f: impl Fn(f64) -> Result<bool, Error>) -> Result<usize, Error> {
    Ok(those(f)?.len())
}

/// Real shininesses between the small integers, where a method's behaviour changes most: 1 to 16 by 64ths.
fn real_shininesses() -> impl Iterator<Item = f64> {
    (64..=16 * 64).map(|step| f64::from(step) / 64.0)
}

/// The largest of an error of a method's lobes for the real shininesses.
fn most_real(method: Method, error: impl Fn(&Pieces) -> f64) -> Result<f64, Error> {
    real_shininesses().try_fold(0.0, |worst: f64, n| Ok(worst.max(error(&method.lobe(n)?))))
}

/// The cubic as printed, neither cut nor clamped.
fn uncut(cubic: &Cubic) -> impl Fn(f64) -> f64 + use<> {
    let Cubic { a, big_a } = *cubic;
    move |u| (1.0 - u) * (1.0 - u * (big_a - a * u))
}

/// The least value of the uncut cubic over the cosines in [0, 1].
fn least(n: f64, cubic: &Cubic) -> f64 {
    let f = uncut(cubic);
    -largest(n, (0.0, 1.0), None, |u| -f(u))
}

/// All claims, from the rows of [`survey`](super::survey()).
///
/// # Errors
/// None for the papers' parameters.
pub fn claims(rows: &[Row]) -> Result<Vec<Claim>, Error> {
    let mut claims = vec![
        quadratic_error(rows)?,
        quadratic_printed_angle()?,
        quadratic_periphery()?,
        quadratic_block()?,
        schlick(rows),
        chord(),
        taylor(rows)?,
        cos_k(rows),
        cubic_relative(rows)?,
        cubic_absolute(rows)?,
        schlick_relative(rows),
        schlick_absolute(rows),
        closed_form()?,
        cubic_rises()?,
        cubic_negative()?,
    ];
    claims.extend(tail(rows));
    claims.extend([
        tail_closed_form()?,
        tail_against_schlick(rows),
        tail_falls()?,
        three_point_negative()?,
        three_point_levels()?,
        three_point_closed_form(),
        operations()?,
        extrema()?,
        min_zero()?,
    ]);
    claims.extend(images::claims()?);
    Ok(claims)
}

fn quadratic_error(rows: &[Row]) -> Result<Claim, Error> {
    let (claimed, all) = (most(rows, 512, |row| row.quadratic), most(rows, MOST, |row| row.quadratic));
    let real = most_real(Method::Quadratic, |pieces| pieces.relative(1.0, QUADRATIC_LEVEL))?;
    Ok(Claim {
        id: "quadratic-error",
        source: "Q, text before the conclusions; fig. 3",
        text: "The relative error is at most 4 % where x^n >= 0.56, for n in [1; 512].",
        claimed: "4 %",
        measured: vec![
            percent("relative; n <= 512", claimed),
            percent("relative; n <= 1000", all),
            percent("relative; real n <= 16 by 64ths", real),
        ],
        verdict: Verdict::of(claimed.max(real) <= 0.04),
    })
}

/// `max(0, x (1 - a u))` through the power's point at γ = arctan(1/(n-1)), as the text layer prints eq. 7.
fn quadratic_printed_angle() -> Result<Claim, Error> {
    let mut worst = 0.0f64;
    for n in shininesses().skip(1).take(511) {
        let t = (n - 1.0) / libm::sqrt(1.0 + (n - 1.0) * (n - 1.0));
        let lobe = Quadratic { a: (1.0 - libm::pow(t, n - 1.0)) / (1.0 - t) };
        let range = (0.0, versine_at(n, QUADRATIC_LEVEL));
        worst = worst.max(largest(n, range, Some(lobe.zero()), |u| (lobe.at(u) / exact(n, u) - 1.0).abs()));
    }
    Ok(Claim {
        id: "quadratic-angle",
        source: "Q, the inflection and eq. 7, as its text layer has them",
        text: "The inflection lies at arctan(1/(n-1)); the coefficient taken there has the claimed error.",
        claimed: "4 %",
        measured: vec![percent("relative; n = 2 to 512", worst)],
        verdict: if worst <= 0.04 { Verdict::Holds } else { Verdict::Only("with arctan(1/sqrt(n-1))".to_owned()) },
    })
}

fn quadratic_periphery() -> Result<Claim, Error> {
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
    Ok(Claim {
        id: "quadratic-periphery",
        source: "Q, the new model, first paragraph",
        text: "Outside the epicentre the model's intensity falls monotonically, as it must.",
        claimed: "0 rises",
        measured: vec![
            count("n of 1000 that rise; as printed", rising),
            value("least value; as printed; n = 1000", -largest(1000.0, (0.0, 1.0), None, |u| -f(u))),
            count("n of 1000 that rise; cut at 0", cut),
        ],
        verdict: match (rising, cut) {
            (0, _) => Verdict::Holds,
            (_, 0) => Verdict::Only("for the lobe cut at 0".to_owned()),
            _ => Verdict::DoesNotHold,
        },
    })
}

/// A core that is small to build, for counting its operations.
fn datapath(method: &str, form: &str) -> Result<Design, Error> {
    let text = format!("method = '{method}'\nform = '{form}'\nshininess = [25]");
    Design::new(SpecFields::parse(&text, "claims")?.resolve()?)
}

fn quadratic_block() -> Result<Claim, Error> {
    let (printed, ours) = (datapath("quadratic", "paper")?, datapath("quadratic", "stable")?);
    let multipliers = printed.graph().multipliers().len();
    Ok(Claim {
        id: "quadratic-block",
        source: "Q, fig. 1 and its description",
        text: "The block has two multipliers.",
        claimed: "2",
        measured: vec![
            count("multipliers of the printed form", multipliers),
            count("multipliers of x(1 - a u)", ours.graph().multipliers().len()),
        ],
        verdict: Verdict::of(multipliers == 2),
    })
}

fn schlick(rows: &[Row]) -> Claim {
    let inside = most(rows, MOST, |row| row.of(Method::Schlick).absolute_epicentre);
    let outside = most(rows, MOST, |row| row.of(Method::Schlick).absolute_tail);
    Claim {
        id: "schlick-epicentre",
        source: "Q, C7, existing approaches",
        text: "Schlick's lobe is satisfactory only on the epicentre; beyond it there is a considerable discrepancy.",
        claimed: "larger beyond",
        measured: vec![
            percent("absolute; on the epicentre; n <= 1000", inside),
            percent("absolute; beyond; n <= 1000", outside),
        ],
        verdict: Verdict::of(outside > inside),
    }
}

fn chord() -> Claim {
    // cos^n of the chord D = 2 sin(γ/2) against cos^n of the angle γ.
    let change = |n: f64| {
        largest(n, (0.0, 1.0), None, |u| (libm::pow(libm::cos(libm::sqrt(2.0 * u)).max(0.0), n) - exact(n, u)).abs())
    };
    let (wide, narrow) = (change(1.0), change(1000.0));
    Claim {
        id: "chord",
        source: "Q, C7, existing approaches (of Lyon)",
        text: "The chord in place of the angle has little influence only for small angles.",
        claimed: "little if small",
        measured: vec![
            percent("change of x^n; n = 1; all angles", wide),
            percent("change of x^n; n = 1000; all angles", narrow),
        ],
        verdict: Verdict::of(narrow < 0.1 * wide),
    }
}

fn taylor(rows: &[Row]) -> Result<Claim, Error> {
    let chord = Method::Taylor(TaylorSeries::Chord);
    let inside = most(rows, MOST, |row| row.of(chord).absolute_epicentre);
    let cubic = most(rows, MOST, |row| row.of(Method::Cubic).absolute_epicentre);
    Ok(Claim {
        id: "taylor",
        source: "Q, C7, existing approaches (of Lyon)",
        text: "Three terms of the Taylor series in the chord do not approximate x^n with the necessary accuracy.",
        claimed: "worse",
        measured: vec![
            percent("three terms; absolute; on the epicentre; n <= 1000", inside),
            percent("the cubic; absolute; on the epicentre; n <= 1000", cubic),
            value("sum of three terms at 90 degrees; n = 1000", Taylor::new(1000.0, TaylorSeries::Chord)?.sum(1.0)),
        ],
        verdict: Verdict::of(inside > cubic),
    })
}

fn cos_k(rows: &[Row]) -> Claim {
    // Below n = k the angle is stretched, which nobody proposes.
    let of =
        |method: Method, k: u32| most(&rows[k as usize - 1..], MOST + 1 - k as usize, |row| row.of(method).absolute);
    let [two, four, eight] = [2, 4, 8].map(|k| of(Method::CosK(k), k));
    let lyon = [2, 4, 8].map(|k| of(Method::Lyon(k), k));
    let schlick = of(Method::Schlick, 1);
    Claim {
        id: "cos-k",
        source: "Q, C7, existing approaches",
        text: "cos^k(sqrt(n/k) γ), n >= k, is sufficiently accurate: better than Schlick's and Lyon's lobes.",
        claimed: "better",
        measured: vec![
            percent("k = 2; absolute; all angles; n <= 1000", two),
            percent("k = 4; absolute; all angles; n <= 1000", four),
            percent("k = 8; absolute; all angles; n <= 1000", eight),
            percent("Lyon with k = 2; absolute; all angles; n <= 1000", lyon[0]),
            percent("Lyon with k = 4; absolute; all angles; n <= 1000", lyon[1]),
            percent("Lyon with k = 8; absolute; all angles; n <= 1000", lyon[2]),
            percent("Schlick; absolute; all angles; n <= 1000", schlick),
        ],
        verdict: Verdict::of(two.max(four).max(eight) < schlick && two < lyon[0] && four < lyon[1] && eight < lyon[2]),
    }
}

/// The claimed bound of the cubic's error.
const CUBIC_BOUND: f64 = 0.0067;

fn cubic_relative(rows: &[Row]) -> Result<Claim, Error> {
    let relative = |row: &Row| row.of(Method::Cubic).relative_epicentre;
    let (claimed, over) = (most(rows, 256, relative), first(rows, |row| relative(row) > CUBIC_BOUND));
    let real = most_real(Method::Cubic, |pieces| pieces.relative(1.0, LEVEL))?;
    Ok(Claim {
        id: "cubic-relative",
        source: "C7, fig. 2 and the sentence above it, read as a relative error",
        text: "The relative error on the epicentre is at most 0.67 % for every n in [1; 256].",
        claimed: "0.67 %",
        measured: vec![
            percent("relative; n <= 256", claimed),
            percent("relative; n <= 1000", most(rows, MOST, relative)),
            percent("relative; real n <= 16 by 64ths", real),
            count("first n over 0.67 %", over),
        ],
        verdict: match (over > 256, real <= CUBIC_BOUND) {
            (true, true) => Verdict::Holds,
            (false, true) => Verdict::Only(format!("for n < {over}")),
            (_, false) => Verdict::DoesNotHold,
        },
    })
}

fn cubic_absolute(rows: &[Row]) -> Result<Claim, Error> {
    let absolute = |row: &Row| row.of(Method::Cubic).absolute_epicentre;
    let all = most(rows, MOST, absolute);
    let real = most_real(Method::Cubic, |pieces| pieces.absolute(1.0, LEVEL))?;
    Ok(Claim {
        id: "cubic-absolute",
        source: "C21, fig. 1 and the sentence above it; C7, fig. 2, read as an absolute error",
        text: "The absolute error on the epicentre is at most 0.67 %.",
        claimed: "0.67 %",
        measured: vec![
            percent("absolute; n <= 256", most(rows, 256, absolute)),
            percent("absolute; n <= 1000", all),
            percent("absolute; real n <= 16 by 64ths", real),
        ],
        verdict: Verdict::of(all.max(real) <= CUBIC_BOUND),
    })
}

/// Schlick's largest error by the cubic's, on the epicentre for n in [1; 256], and the least such ratio of any one n.
fn ratios(rows: &[Row], error: impl Fn(Errors) -> f64) -> (f64, f64) {
    let of = |row: &Row, method| error(row.of(method));
    let worst = most(rows, 256, |row| of(row, Method::Schlick)) / most(rows, 256, |row| of(row, Method::Cubic));
    let single = rows[..256].iter().filter(|row| of(row, Method::Cubic) > ROUNDING);
    let least = single.map(|row| of(row, Method::Schlick) / of(row, Method::Cubic)).fold(f64::INFINITY, f64::min);
    (worst, least)
}

fn schlick_relative(rows: &[Row]) -> Claim {
    let (worst, least) = ratios(rows, |errors| errors.relative_epicentre);
    Claim {
        id: "schlick-relative",
        source: "C7, below fig. 2",
        text: "Against Schlick's lobe the relative error is smaller by more than 17 times, for n in [1; 256].",
        claimed: "17x",
        measured: vec![times("largest by largest error", worst), times("least of any n", least)],
        verdict: Verdict::of(worst.min(least) > 17.0),
    }
}

fn schlick_absolute(rows: &[Row]) -> Claim {
    let (worst, least) = ratios(rows, |errors| errors.absolute_epicentre);
    Claim {
        id: "schlick-absolute",
        source: "C21, below fig. 1",
        text: "Against Schlick's lobe the (absolute) error is smaller by more than 17 times.",
        claimed: "17x",
        measured: vec![times("largest by largest error; n <= 256", worst), times("least of any n <= 256", least)],
        verdict: Verdict::of(worst.min(least) > 17.0),
    }
}

/// The printed a and b with q = 2^(-1/n); both papers' text has b's terms in another order.
fn printed_cubic(n: f64) -> (f64, f64) {
    let q = libm::exp2(-1.0 / n);
    let below = 2.0 * (q - 1.0) * (q - 1.0) * q * q;
    (((q - 1.0) * (2.0 * q + n) + 1.0) / below, -(q * q * (4.0 * q - 3.0) + n * (q * q - 1.0) + 1.0) / below)
}

fn closed_form() -> Result<Claim, Error> {
    let agreeing = how_many(|n| {
        let ((a, b), cubic) = (printed_cubic(n), Cubic::new(n, LEVEL)?);
        let [a_true, b_true, _] = cubic.printed();
        // The printed numerators cancel to about 1e-12 of their result; near n = 2 the result is 0.
        let close = |got: f64, expected: f64| (got - expected).abs() <= 1e-9 * expected.abs().max(1.0);
        Ok(close(a, a_true) && close(b, b_true))
    })?;
    Ok(Claim {
        id: "cubic-closed-form",
        source: "C7, C21, the solution for Q = 0.5",
        text: "The closed forms of a and b solve the cubic's system.",
        claimed: "all n",
        measured: vec![count("n of 1000 that agree", agreeing)],
        verdict: Verdict::of(agreeing == MOST),
    })
}

fn cubic_rises() -> Result<Claim, Error> {
    let rising = those(|n| {
        let f = uncut(&Cubic::new(n, LEVEL)?);
        Ok(rises(n, (0.0, 1.0), f))
    })?;
    let past_cut = |n: f64| -> Result<f64, Error> {
        let cubic = Cubic::new(n, LEVEL)?;
        Ok(largest(n, (cubic.cut().unwrap_or(1.0), 1.0), None, uncut(&cubic)))
    };
    Ok(Claim {
        id: "cubic-rises",
        source: "C7, fig. 1 and the paragraph above it",
        text: "The cubic cannot be used for the fading area: the specular term increases there instead of fading.",
        claimed: "increases",
        measured: vec![
            count("n of 1000 that rise", rising.len()),
            value("largest value past the minimum; n = 25", past_cut(25.0)?),
            value("largest value past the minimum; n = 256", past_cut(256.0)?),
            value("largest value past the minimum; n = 1000", past_cut(1000.0)?),
        ],
        // x^1 to x^3 are of the cubic's own degree.
        verdict: match rising.first() {
            Some(&n) if n > 1.0 => Verdict::Only(format!("for n >= {n}")),
            first => Verdict::of(first.is_some()),
        },
    })
}

/// The least value of a family of cubics over the shininesses, and those where it is negative.
fn dips(
    shininesses: impl Iterator<Item = f64>,
    of: impl Fn(f64) -> Result<Cubic, Error>,
) -> Result<(f64, Vec<f64>), Error> {
    let (mut lowest, mut negative) = (0.0f64, Vec::new());
    for n in shininesses {
        let value = least(n, &of(n)?);
        if value < -ROUNDING {
            negative.push(n);
            lowest = lowest.min(value);
        }
    }
    Ok((lowest, negative))
}

/// The integers around the shininesses where a cubic is negative.
fn between(negative: &[f64]) -> String {
    let fold = |f: fn(f64, f64) -> f64, start| negative.iter().copied().fold(start, f);
    let (low, high) = (fold(f64::min, f64::INFINITY), fold(f64::max, f64::NEG_INFINITY));
    format!("{} < n < {}", libm::floor(low), libm::ceil(high))
}

fn cubic_negative() -> Result<Claim, Error> {
    let of = |n| Cubic::new(n, LEVEL);
    let (integer, offenders) = dips(shininesses(), of)?;
    let (real, negative) = dips(real_shininesses(), of)?;
    Ok(Claim {
        id: "cubic-negative",
        source: "C7, fig. 3; C21, above fig. 3",
        text: "The cubic at times takes negative values, and has to be cut off.",
        claimed: "below 0",
        measured: vec![
            count("n of 1000 with negative values", offenders.len()),
            value("least value; integer n <= 1000", integer),
            value("least value; real n <= 16 by 64ths", real),
        ],
        verdict: match (offenders.is_empty(), negative.is_empty()) {
            (false, _) => Verdict::Holds,
            (true, false) => Verdict::Only(format!("for real {}", between(&negative))),
            (true, true) => Verdict::DoesNotHold,
        },
    })
}

fn tail(rows: &[Row]) -> Vec<Claim> {
    const IDS: [&str; 3] = ["tail-0.42", "tail-0.37", "tail-0.27"];
    const TEXTS: [&str; 3] = [
        "The rational tail's relative error is at most 1 % where 0.42 < f < 0.5.",
        "The rational tail's relative error is at most 3 % where 0.37 < f < 0.42.",
        "The rational tail's relative error is at most 10 % where 0.27 < f < 0.37.",
    ];
    const CLAIMED: [(&str, f64); 3] = [("1 %", 0.01), ("3 %", 0.03), ("10 %", 0.1)];
    (0..TAIL_BANDS.len())
        .map(|band| {
            let (claimed, bound) = CLAIMED[band];
            let over = first(rows, |row| row.tail[band] > bound);
            Claim {
                id: IDS[band],
                source: "C7, below fig. 4; C21, above fig. 3",
                text: TEXTS[band],
                claimed,
                measured: vec![
                    percent("f the power; n = 25", rows[24].tail[band]),
                    percent("f the power; n <= 1000", most(rows, MOST, |row| row.tail[band])),
                    percent(
                        "f the tail; error relative to it; n <= 1000",
                        most(rows, MOST, |row| row.tail_by_itself[band]),
                    ),
                    count("first n over the claim; f the power", over),
                ],
                verdict: if over > MOST { Verdict::Holds } else { Verdict::Only(format!("for n < {over}")) },
            }
        })
        .collect()
}

fn tail_closed_form() -> Result<Claim, Error> {
    let agreeing = how_many(|n| {
        // The papers' x / (a - b x) is x / (d + b u) with d = a - b.
        let (tail, t) = (CubicRational::new(n, LEVEL)?, libm::exp2(-1.0 / n));
        let (a, b) = (4.0 * n * libm::pow(t, n + 1.0), 4.0 * n * libm::pow(t, n) - 2.0);
        Ok((tail.d - (a - b)).abs() < ROUNDING && (tail.b - b).abs() < ROUNDING * n)
    })?;
    Ok(Claim {
        id: "tail-closed-form",
        source: "C7, C21, the solution of the tail's system",
        text: "a = 4 n cos^(n+1) t and b = 4 n cos^n t - 2 give the power's value and slope at its cusp.",
        claimed: "all n",
        measured: vec![count("n of 1000 that agree", agreeing)],
        verdict: Verdict::of(agreeing == MOST),
    })
}

/// The ratio is 2 at every n, because the tail is `Q S(x/t)` with S Schlick's lobe (see [`CubicRational`]) and x^n is
/// `Q (x/t)^n`: its error is half of Schlick's over all angles.
fn tail_against_schlick(rows: &[Row]) -> Claim {
    let tail = |row: &Row, method: Method| row.of(method).absolute_tail;
    let (ours, schlick) =
        (most(rows, MOST, |row| tail(row, Method::CubicRational)), most(rows, MOST, |row| tail(row, Method::Schlick)));
    Claim {
        id: "tail-schlick",
        source: "C7, conclusions",
        text: "Against Schlick's lobe the error in the fading area is reduced considerably as well.",
        claimed: "smaller",
        measured: vec![
            percent("cubic with tail; absolute; beyond the epicentre; n <= 1000", ours),
            percent("Schlick; absolute; beyond the epicentre; n <= 1000", schlick),
            times("ratio", schlick / ours),
        ],
        verdict: Verdict::of(ours < schlick),
    }
}

fn tail_falls() -> Result<Claim, Error> {
    let rising = how_many(|n| {
        let pieces = Method::CubicRational.lobe(n)?;
        Ok(rises(n, (0.0, 1.0), |u| pieces.lobe.at(u)))
    })?;
    Ok(Claim {
        id: "tail-falls",
        source: "C7, abstract",
        text: "The second function assures that the whole falls monotonically.",
        claimed: "0 rises",
        measured: vec![count("n of 1000 that rise", rising)],
        verdict: Verdict::of(rising == 0),
    })
}

fn three_point_negative() -> Result<Claim, Error> {
    let (integer, offenders) = dips(shininesses(), three_point)?;
    let (real, negative) = dips(real_shininesses(), three_point)?;
    Ok(Claim {
        id: "three-point-zero",
        source: "C21, below the three-point solution",
        text: "With Q = 0.5 and G = 1/18 the three-point cubic does not cross the axis in the fading area.",
        claimed: "not below 0",
        measured: vec![
            count("n of 1000 with negative values", offenders.len()),
            value("least value; integer n <= 1000", integer),
            value("least value; real n <= 16 by 64ths", real),
        ],
        verdict: match (offenders.is_empty(), negative.is_empty()) {
            (true, true) => Verdict::Holds,
            (true, false) => Verdict::Only(format!("for integer n; not for real {}", between(&negative))),
            (false, _) => Verdict::DoesNotHold,
        },
    })
}

fn three_point_levels() -> Result<Claim, Error> {
    let crosses = |divisor: usize| -> Result<bool, Error> {
        let of = |n| Cubic::three_point(n, LEVEL, 1.0 / divisor as f64);
        Ok(!dips(shininesses(), of)?.1.is_empty())
    };
    // A lower level brings the minimum down: the first that crosses ends the search.
    let mut last = 2;
    while last < 64 && !crosses(last + 1)? {
        last += 1;
    }
    Ok(Claim {
        id: "three-point-levels",
        source: "C21, below the three-point solution",
        text: "G = 1/18 is the optimal level for Q = 0.5: the lowest G = 1/m without a crossing of the axis.",
        claimed: "18",
        measured: vec![count("largest m without a crossing; n <= 1000", last)],
        verdict: Verdict::of(last == 18),
    })
}

fn three_point_closed_form() -> Claim {
    let n = 25.0;
    let (q, g) = (Cubic::THREE_POINT_Q, Cubic::THREE_POINT_G);
    let (r, l) = (libm::pow(q, 1.0 / n), libm::pow(g, 1.0 / n));
    let below = l * l * l * (1.0 - r * r) + l * l * (r * r * r - 1.0) - r * r * (r - 1.0);
    let a = (l * l * (q - 1.0) + g * (1.0 - r * r) + r * r - q) / below;
    let b = (l * l * l * (q - 1.0) + g * (1.0 - r * r * r) - q + r * r * r) / below;
    let c = (l * l * (q - r * r) + l * l * (r * r * r - libm::pow(r, n)) + g * r * r * (1.0 - r)) / below;
    Claim {
        id: "three-point-closed-form",
        source: "C21, the three-point solution",
        text: "The closed forms of a, b and c solve the three-point system, so that a + b + c = 1.",
        claimed: "1",
        measured: vec![value("a + b + c as printed; n = 25", a + b + c)],
        verdict: Verdict::of((a + b + c - 1.0).abs() < ROUNDING),
    }
}

fn operations() -> Result<Claim, Error> {
    let (printed, ours) = (datapath("cubic", "paper")?, datapath("cubic", "stable")?);
    let (five, three) = (printed.graph().multipliers().len(), ours.graph().multipliers().len());
    Ok(Claim {
        id: "three-point-operations",
        source: "C21, below the three-point solution",
        text: "Hardware has to make five multiplications.",
        claimed: "5",
        measured: vec![count("multiplications as printed", five), count("multiplications of x(1 - u(A - a u))", three)],
        verdict: if five == 5 { Verdict::Only("as printed; fewer suffice".to_owned()) } else { Verdict::DoesNotHold },
    })
}

/// The number of points in 0..90 degrees where the derivative by the angle is 0 and changes its sign: the peak, and the zeros
/// of the derivative by u, `-(1+A) + 2 (A+a) u - 3 a u^2`, for u in (0, 1).
fn extrema_of(cubic: &Cubic) -> usize {
    let Cubic { a, big_a } = *cubic;
    let slope = |u: f64| -(1.0 + big_a) + u * (2.0 * (big_a + a) - 3.0 * a * u);
    let slopes: Vec<f64> = grid(big_a.max(1.0), 0.0, 1.0)[1..].iter().map(|&u| slope(u)).collect();
    // A double zero at u = 1, as of x^3, may leave its rounding there.
    let sign = |v: f64| v > ROUNDING * (1.0 + big_a.abs());
    1 + slopes.windows(2).filter(|pair| sign(pair[0]) != sign(pair[1])).count()
}

fn extrema() -> Result<Claim, Error> {
    let through_one = |number: usize| how_many(|n| Ok(extrema_of(&Cubic::new(n, LEVEL)?) == number));
    let through_two = |number: usize| how_many(|n| Ok(extrema_of(&three_point(n)?) == number));
    let (cubic, two) = (through_one(2)?, through_two(2)?);
    let thousand = three_point(1000.0)?;
    Ok(Claim {
        id: "extrema",
        source: "C21, below the three-point solution",
        text: "The cubic has two extrema: a maximum at γ = 0 and a minimum.",
        claimed: "2",
        measured: vec![
            count("n of 1000 with two; cubic", cubic),
            count("n of 1000 with two; three-point cubic", two),
            count("n of 1000 with a second maximum; cubic", through_one(3)?),
            count("n of 1000 with a second maximum; three-point cubic", through_two(3)?),
            value("the second maximum; three-point cubic; n = 1000", {
                largest(1000.0, (thousand.cut().unwrap_or(1.0), 1.0), None, uncut(&thousand))
            }),
        ],
        verdict: Verdict::of(cubic == MOST && two == MOST),
    })
}

fn min_zero() -> Result<Claim, Error> {
    let raw = |n: f64| -> Result<(MinZero, Cubic), Error> {
        let lobe = MinZero::new(n, LEVEL)?;
        Ok((lobe, Cubic { a: lobe.k * lobe.k, big_a: 2.0 * lobe.k }))
    };
    let (mut lowest, mut worst) = (0.0f64, 0.0f64);
    for n in shininesses() {
        let (_, cubic) = raw(n)?;
        let value = least(n, &cubic);
        lowest = if value < -ROUNDING { lowest.min(value) } else { lowest };
        worst = worst.max(Method::MinZero.lobe(n)?.absolute(1.0, 0.0));
    }
    let (lobe, cubic) = raw(1000.0)?;
    Ok(Claim {
        id: "min-zero",
        source: "C21, above fig. 3",
        text: "With its minimum set to zero the cubic is an approximation that is not negative.",
        claimed: "0",
        measured: vec![
            value("least value; n <= 1000", lowest),
            percent("absolute; all angles; cut at its zero; n <= 1000", worst),
            value("largest value past its zero; not cut; n = 1000", {
                largest(1000.0, (lobe.zero(), 1.0), None, uncut(&cubic))
            }),
        ],
        verdict: if lowest == 0.0 {
            Verdict::Only("cut past its minimum, where it rises".to_owned())
        } else {
            Verdict::DoesNotHold
        },
    })
}
