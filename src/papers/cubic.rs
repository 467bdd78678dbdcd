//! The claims of C7 and C21, on the cubic, its tail and its three-point form.

use super::claims::{
    ROUNDING, count, datapath, how_many, most, most_real, percent, real_shininesses, shininesses, those, times, value,
};
use super::measure::{grid, largest, rises};
use super::method::{LEVEL, PaperMethod, three_point};
use super::survey::{Errors, MOST, SurveyRow};
use super::{Claim, Finding};
use crate::method::cubic::Cubic;
use crate::method::cubic_min_zero::MinZero;
use crate::method::cubic_rational::CubicRational;
use crate::platform::error::Error;

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

/// The first n where `f` holds, or one past the last.
fn first(rows: &[SurveyRow], f: impl Fn(&SurveyRow) -> bool) -> usize {
    rows.iter().find(|row| f(row)).map_or(MOST + 1, |row| row.n)
}

/// The claimed bound of the cubic's error.
const CUBIC_BOUND: f64 = 0.0067;

pub(super) fn cubic_relative(rows: &[SurveyRow]) -> Result<Claim, Error> {
    let relative = |row: &SurveyRow| row.of(PaperMethod::Cubic).relative_epicentre;
    let (claimed, over) = (most(rows, 256, relative), first(rows, |row| relative(row) > CUBIC_BOUND));
    let real = most_real(PaperMethod::Cubic, |pieces| pieces.relative(1.0, LEVEL))?;
    Ok(Claim::of(
        "cubic-relative",
        vec![
            percent("relative; n <= 256", claimed),
            percent("relative; n <= 1000", most(rows, MOST, relative)),
            percent("relative; real n <= 16 by 64ths", real),
            count("first n over 0.67 %", over),
        ],
        match (over > 256, real <= CUBIC_BOUND) {
            (true, true) => Finding::Holds,
            (false, true) => Finding::Only(format!("for n < {over}")),
            (_, false) => Finding::DoesNotHold,
        },
    ))
}

pub(super) fn cubic_absolute(rows: &[SurveyRow]) -> Result<Claim, Error> {
    let absolute = |row: &SurveyRow| row.of(PaperMethod::Cubic).absolute_epicentre;
    let all = most(rows, MOST, absolute);
    let real = most_real(PaperMethod::Cubic, |pieces| pieces.absolute(1.0, LEVEL))?;
    Ok(Claim::of(
        "cubic-absolute",
        vec![
            percent("absolute; n <= 256", most(rows, 256, absolute)),
            percent("absolute; n <= 1000", all),
            percent("absolute; real n <= 16 by 64ths", real),
        ],
        Finding::of(all.max(real) <= CUBIC_BOUND),
    ))
}

/// Schlick's largest error by the cubic's, on the epicentre for n in [1; 256], and the least such ratio of any one n.
fn ratios(rows: &[SurveyRow], error: impl Fn(Errors) -> f64) -> (f64, f64) {
    let of = |row: &SurveyRow, method| error(row.of(method));
    let worst =
        most(rows, 256, |row| of(row, PaperMethod::Schlick)) / most(rows, 256, |row| of(row, PaperMethod::Cubic));
    let single = rows[..256].iter().filter(|row| of(row, PaperMethod::Cubic) > ROUNDING);
    let least =
        single.map(|row| of(row, PaperMethod::Schlick) / of(row, PaperMethod::Cubic)).fold(f64::INFINITY, f64::min);
    (worst, least)
}

pub(super) fn schlick_relative(rows: &[SurveyRow]) -> Claim {
    let (worst, least) = ratios(rows, |errors| errors.relative_epicentre);
    Claim::of(
        "schlick-relative",
        vec![times("largest by largest error", worst), times("least of any n", least)],
        Finding::of(worst.min(least) > 17.0),
    )
}

pub(super) fn schlick_absolute(rows: &[SurveyRow]) -> Claim {
    let (worst, least) = ratios(rows, |errors| errors.absolute_epicentre);
    Claim::of(
        "schlick-absolute",
        vec![times("largest by largest error; n <= 256", worst), times("least of any n <= 256", least)],
        Finding::of(worst.min(least) > 17.0),
    )
}

/// The printed a and b with q = 2^(-1/n); both papers' text has b's terms in another order.
fn printed_cubic(n: f64) -> (f64, f64) {
    let q = libm::exp2(-1.0 / n);
    let below = 2.0 * (q - 1.0) * (q - 1.0) * q * q;
    (((q - 1.0) * (2.0 * q + n) + 1.0) / below, -(q * q * (4.0 * q - 3.0) + n * (q * q - 1.0) + 1.0) / below)
}

pub(super) fn closed_form() -> Result<Claim, Error> {
    let agreeing = how_many(|n| {
        let ((a, b), cubic) = (printed_cubic(n), Cubic::new(n, LEVEL)?);
        let [a_true, b_true, _] = cubic.printed();
        // The printed numerators cancel to about 1e-12 of their result; near n = 2 the result is 0.
        let close = |got: f64, expected: f64| (got - expected).abs() <= 1e-9 * expected.abs().max(1.0);
        Ok(close(a, a_true) && close(b, b_true))
    })?;
    Ok(Claim::of("cubic-closed-form", vec![count("n of 1000 that agree", agreeing)], Finding::of(agreeing == MOST)))
}

pub(super) fn cubic_rises() -> Result<Claim, Error> {
    let rising = those(|n| {
        let f = uncut(&Cubic::new(n, LEVEL)?);
        Ok(rises(n, (0.0, 1.0), f))
    })?;
    let past_cut = |n: f64| -> Result<f64, Error> {
        let cubic = Cubic::new(n, LEVEL)?;
        Ok(largest(n, (cubic.cut().unwrap_or(1.0), 1.0), None, uncut(&cubic)))
    };
    Ok(Claim::of(
        "cubic-rises",
        vec![
            count("n of 1000 that rise", rising.len()),
            value("largest value past the minimum; n = 25", past_cut(25.0)?),
            value("largest value past the minimum; n = 256", past_cut(256.0)?),
            value("largest value past the minimum; n = 1000", past_cut(1000.0)?),
        ],
        // x^1 to x^3 are of the cubic's own degree.
        match rising.first() {
            Some(&n) if n > 1.0 => Finding::Only(format!("for n >= {n}")),
            first => Finding::of(first.is_some()),
        },
    ))
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

/// A claim on where a family of cubics is negative; `finding` is told whether it is for no integer n, whether for no
/// real one, and the integers around the real ones.
fn negative(
    id: &str,
    of: impl Fn(f64) -> Result<Cubic, Error>,
    finding: impl Fn(bool, bool, &dyn Fn() -> String) -> Finding,
) -> Result<Claim, Error> {
    let (integer, offenders) = dips(shininesses(), &of)?;
    let (real, negative) = dips(real_shininesses(), &of)?;
    Ok(Claim::of(
        id,
        vec![
            count("n of 1000 with negative values", offenders.len()),
            value("least value; integer n <= 1000", integer),
            value("least value; real n <= 16 by 64ths", real),
        ],
        finding(offenders.is_empty(), negative.is_empty(), &|| between(&negative)),
    ))
}

pub(super) fn cubic_negative() -> Result<Claim, Error> {
    negative(
        "cubic-negative",
        |n| Cubic::new(n, LEVEL),
        |no_integer, no_real, between| match (no_integer, no_real) {
            (false, _) => Finding::Holds,
            (true, false) => Finding::Only(format!("for real {}", between())),
            (true, true) => Finding::DoesNotHold,
        },
    )
}

pub(super) fn tail(rows: &[SurveyRow]) -> Vec<Claim> {
    const CLAIMED: [(&str, f64); 3] = [("tail-0.42", 0.01), ("tail-0.37", 0.03), ("tail-0.27", 0.1)];
    let claim = |(band, (id, bound)): (usize, (&str, f64))| {
        let over = first(rows, |row| row.tail[band] > bound);
        Claim::of(
            id,
            vec![
                percent("f the power; n = 25", rows[24].tail[band]),
                percent("f the power; n <= 1000", most(rows, MOST, |row| row.tail[band])),
                percent(
                    "f the tail; error relative to it; n <= 1000",
                    most(rows, MOST, |row| row.tail_by_itself[band]),
                ),
                count("first n over the claim; f the power", over),
            ],
            if over > MOST { Finding::Holds } else { Finding::Only(format!("for n < {over}")) },
        )
    };
    CLAIMED.into_iter().enumerate().map(claim).collect()
}

pub(super) fn tail_closed_form() -> Result<Claim, Error> {
    let agreeing = how_many(|n| {
        // The papers' x / (a - b x) is x / (d + b u) with d = a - b.
        let (tail, t) = (CubicRational::new(n, LEVEL)?, libm::exp2(-1.0 / n));
        let (a, b) = (4.0 * n * libm::pow(t, n + 1.0), 4.0 * n * libm::pow(t, n) - 2.0);
        Ok((tail.d - (a - b)).abs() < ROUNDING && (tail.b - b).abs() < ROUNDING * n)
    })?;
    Ok(Claim::of("tail-closed-form", vec![count("n of 1000 that agree", agreeing)], Finding::of(agreeing == MOST)))
}

/// The ratio is 2 at every n, because the tail is `Q S(x/t)` with S Schlick's lobe (see [`CubicRational`]) and x^n is
/// `Q (x/t)^n`: its error is half of Schlick's over all angles.
pub(super) fn tail_against_schlick(rows: &[SurveyRow]) -> Claim {
    let tail = |row: &SurveyRow, method: PaperMethod| row.of(method).absolute_tail;
    let (ours, schlick) = (
        most(rows, MOST, |row| tail(row, PaperMethod::CubicRational)),
        most(rows, MOST, |row| tail(row, PaperMethod::Schlick)),
    );
    Claim::of(
        "tail-schlick",
        vec![
            percent("cubic with tail; absolute; beyond the epicentre; n <= 1000", ours),
            percent("Schlick; absolute; beyond the epicentre; n <= 1000", schlick),
            times("ratio", schlick / ours),
        ],
        Finding::of(ours < schlick),
    )
}

pub(super) fn tail_falls() -> Result<Claim, Error> {
    let rising = how_many(|n| {
        let pieces = PaperMethod::CubicRational.lobe(n)?;
        Ok(rises(n, (0.0, 1.0), |u| pieces.lobe.at(u)))
    })?;
    Ok(Claim::of("tail-falls", vec![count("n of 1000 that rise", rising)], Finding::of(rising == 0)))
}

pub(super) fn three_point_negative() -> Result<Claim, Error> {
    negative("three-point-zero", three_point, |no_integer, no_real, between| match (no_integer, no_real) {
        (true, true) => Finding::Holds,
        (true, false) => Finding::Only(format!("for integer n; not for real {}", between())),
        (false, _) => Finding::DoesNotHold,
    })
}

pub(super) fn three_point_levels() -> Result<Claim, Error> {
    let crosses = |divisor: usize| -> Result<bool, Error> {
        let of = |n| Cubic::three_point(n, LEVEL, 1.0 / divisor as f64);
        Ok(!dips(shininesses(), of)?.1.is_empty())
    };
    // A lower level brings the minimum down: the first that crosses ends the search.
    let mut last = 2;
    while last < 64 && !crosses(last + 1)? {
        last += 1;
    }
    Ok(Claim::of(
        "three-point-levels",
        vec![count("largest m without a crossing; n <= 1000", last)],
        Finding::of(last == 18),
    ))
}

pub(super) fn three_point_closed_form() -> Claim {
    let n = 25.0;
    let (q, g) = (Cubic::THREE_POINT_Q, Cubic::THREE_POINT_G);
    let (r, l) = (libm::pow(q, 1.0 / n), libm::pow(g, 1.0 / n));
    let below = l * l * l * (1.0 - r * r) + l * l * (r * r * r - 1.0) - r * r * (r - 1.0);
    let a = (l * l * (q - 1.0) + g * (1.0 - r * r) + r * r - q) / below;
    let b = (l * l * l * (q - 1.0) + g * (1.0 - r * r * r) - q + r * r * r) / below;
    let c = (l * l * (q - r * r) + l * l * (r * r * r - libm::pow(r, n)) + g * r * r * (1.0 - r)) / below;
    Claim::of(
        "three-point-closed-form",
        vec![value("a + b + c as printed; n = 25", a + b + c)],
        Finding::of((a + b + c - 1.0).abs() < ROUNDING),
    )
}

pub(super) fn operations() -> Result<Claim, Error> {
    let (printed, ours) = (datapath("cubic", "paper")?, datapath("cubic", "stable")?);
    let (five, three) = (printed.function().multipliers().len(), ours.function().multipliers().len());
    Ok(Claim::of(
        "three-point-operations",
        vec![count("multiplications as printed", five), count("multiplications of x(1 - u(A - a u))", three)],
        if five == 5 { Finding::Only("as printed; fewer suffice".to_owned()) } else { Finding::DoesNotHold },
    ))
}

/// The number of points in 0..90 degrees where the derivative by the angle is 0 and changes its sign: the peak, and the
/// zeros of the derivative by u, `-(1+A) + 2 (A+a) u - 3 a u^2`, for u in (0, 1).
fn extrema_of(cubic: &Cubic) -> usize {
    let Cubic { a, big_a } = *cubic;
    let slope = |u: f64| -(1.0 + big_a) + u * (2.0 * (big_a + a) - 3.0 * a * u);
    let slopes: Vec<f64> = grid(big_a.max(1.0), 0.0, 1.0)[1..].iter().map(|&u| slope(u)).collect();
    // A double zero at u = 1, as of x^3, may leave its rounding there.
    let sign = |v: f64| v > ROUNDING * (1.0 + big_a.abs());
    1 + slopes.windows(2).filter(|pair| sign(pair[0]) != sign(pair[1])).count()
}

pub(super) fn extrema() -> Result<Claim, Error> {
    let through_one = |number: usize| how_many(|n| Ok(extrema_of(&Cubic::new(n, LEVEL)?) == number));
    let through_two = |number: usize| how_many(|n| Ok(extrema_of(&three_point(n)?) == number));
    let (cubic, two) = (through_one(2)?, through_two(2)?);
    let thousand = three_point(1000.0)?;
    Ok(Claim::of(
        "extrema",
        vec![
            count("n of 1000 with two; cubic", cubic),
            count("n of 1000 with two; three-point cubic", two),
            count("n of 1000 with a second maximum; cubic", through_one(3)?),
            count("n of 1000 with a second maximum; three-point cubic", through_two(3)?),
            value("the second maximum; three-point cubic; n = 1000", {
                largest(1000.0, (thousand.cut().unwrap_or(1.0), 1.0), None, uncut(&thousand))
            }),
        ],
        Finding::of(cubic == MOST && two == MOST),
    ))
}

pub(super) fn min_zero() -> Result<Claim, Error> {
    let raw = |n: f64| -> Result<(MinZero, Cubic), Error> {
        let lobe = MinZero::new(n, LEVEL)?;
        Ok((lobe, Cubic { a: lobe.k * lobe.k, big_a: 2.0 * lobe.k }))
    };
    let (mut lowest, mut worst) = (0.0f64, 0.0f64);
    for n in shininesses() {
        let (_, cubic) = raw(n)?;
        let value = least(n, &cubic);
        lowest = if value < -ROUNDING { lowest.min(value) } else { lowest };
        worst = worst.max(PaperMethod::MinZero.lobe(n)?.absolute(1.0, 0.0));
    }
    let (lobe, cubic) = raw(1000.0)?;
    Ok(Claim::of(
        "min-zero",
        vec![
            value("least value; n <= 1000", lowest),
            percent("absolute; all angles; cut at its zero; n <= 1000", worst),
            value("largest value past its zero; not cut; n = 1000", {
                largest(1000.0, (lobe.zero(), 1.0), None, uncut(&cubic))
            }),
        ],
        if lowest == 0.0 {
            Finding::Only("cut past its minimum, where it rises".to_owned())
        } else {
            Finding::DoesNotHold
        },
    ))
}
