//! The segmented lobe: `x (c - u (A - a u))` with other coefficients on each segment of the versine.

use super::Fit;
use super::minimax::{self, Best, Piece, Pieces, Shape};
use super::target::{DEEP, Objective, Target, versine};
use crate::lobe::{check_shininess, exact};
use crate::platform::error::{Error, refuse};

/// The coefficients of `x (c - u (A - a u))` on one segment, the value clamped to [0, 1].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// The constant: 1 in a first segment that is exact at x = 1.
    pub c: f64,
    /// The linear coefficient, of the order of n.
    pub big_a: f64,
    /// The quadratic coefficient, of the order of n^2.
    pub a: f64,
}

impl Segment {
    /// `[c, A / n, a / n^2]`, the coefficients in the scaled versine `s = n u`: of the order of 1 for every n.
    #[must_use]
    pub fn scaled(&self, n: f64) -> [f64; 3] {
        [self.c, self.big_a / n, self.a / (n * n)]
    }
}

/// What a segmented lobe keeps at the cost of its error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Constraint {
    /// Nothing: at its top, x = 1, it is 1 less the error, and where it is nearly 0 it may rise with the versine.
    None,
    /// It is exactly 1 at its top: c = 1 in the first segment.
    Peak,
    /// It nowhere rises with the versine: the inner parabola `c - u (A - a u)` does not where it is above 0, and ends
    /// no lower than the power, where the next segment may begin.
    Falling,
    /// As [`Constraint::Falling`] for the last segment: 0 comes next.
    FallingLast,
}

impl Constraint {
    /// What it is for a segment that starts at this versine, of a lobe for which it is this.
    #[must_use]
    pub fn of_segment(self, low: f64, is_last: bool) -> Self {
        match self {
            Self::Peak if low > 0.0 => Self::None,
            Self::Falling if is_last => Self::FallingLast,
            own => own,
        }
    }
}

/// The best coefficients on the segment `u_low..=u_high` for the shininess `n` under a constraint; that of an exact
/// peak is for the first segment.
///
/// Where the objective counts errors only down to a level, and at least half the segment lies above it, only that part
/// is fitted. Otherwise all of it is, with the level's weight past the level, lest the coefficients grow without use.
/// The reported error is that of the part that counts: 0 if none does.
///
/// # Errors
/// A shininess outside 1..=2^20, an objective with a level or a power out of its range, or bounds that are not
/// `0 <= u_low < u_high <= 1`, with `u_low = 0` for an exact peak.
pub fn fit_segment(
    n: f64,
    u_low: f64,
    u_high: f64,
    constraint: Constraint,
    objective: &Objective,
) -> Result<Fit<Segment>, Error> {
    check_shininess(n)?;
    objective.check()?;
    refuse!(
        !(0.0 <= u_low && u_low < u_high && u_high <= 1.0) || (constraint == Constraint::Peak && u_low != 0.0),
        format!("{u_low} to {u_high} is no segment of the versine"),
        "a segment has bounds 0 <= low < high <= 1, and one with an exact peak starts at 0"
    );
    Ok(segment(n, u_low, u_high, constraint, objective))
}

/// The end `s_end = n u_S` for which `segments` equal segments of `s = n u` from 0 on, and 0 past the last, have the
/// least error.
///
/// A longer range makes the segments worse and the drop to 0 past them better; at the best end both are equal (or
/// `s_end = n`, the whole range, if the segments are exact). For an objective with a level it is the level's place,
/// since past it nothing counts.
///
/// # Errors
/// As [`fit_segment`], and a number of segments outside 1..=256.
pub fn segment_end(n: f64, segments: u32, constraint: Constraint, objective: &Objective) -> Result<Fit<f64>, Error> {
    check(n, segments, objective)?;
    let within = |s_end: f64| {
        let bound = |i: u32| (s_end / n * f64::from(i) / f64::from(segments)).min(1.0);
        (0..segments)
            .map(|i| {
                segment(n, bound(i), bound(i + 1), constraint.of_segment(bound(i), i + 1 == segments), objective).error
            })
            .fold(0.0_f64, f64::max)
    };
    let reach = objective.reach(n);
    if reach < 1.0 {
        return Ok(Fit { coefficients: n * reach, error: within(n * reach) });
    }
    let drop = |s_end: f64| {
        let value = exact(n, s_end / n);
        value * objective.weight(value)
    };
    let whole = within(n);
    if whole < 1e-14 {
        return Ok(Fit { coefficients: n, error: whole });
    }
    let mut best = Fit { coefficients: n, error: whole };
    root(0.1, DEEP.min(n), |s_end| {
        let (inside, past) = (within(s_end), drop(s_end));
        if inside.max(past) < best.error {
            best = Fit { coefficients: s_end, error: inside.max(past) };
        }
        log_ratio(inside, past)
    });
    Ok(best)
}

/// The bounds `u_1 < ... < u_S` (from `u_0 = 0` on) for which `segments` segments, and 0 past the last, have the least
/// error.
///
/// At the best bounds all segments and the drop to 0 have the same error. At n = 1000, that is half the largest error
/// of equal segments for S = 2, and a ninth for S = 8. In `s = n u` the bounds hardly depend on n where n is large.
///
/// # Errors
/// As [`segment_end`].
pub fn segment_bounds(
    n: f64,
    segments: u32,
    constraint: Constraint,
    objective: &Objective,
) -> Result<Fit<Vec<f64>>, Error> {
    check(n, segments, objective)?;
    let even = segment_end(n, segments, constraint, objective)?;
    let end = even.coefficients / n;
    let mut best = Fit {
        coefficients: (1..=segments).map(|i| end * f64::from(i) / f64::from(segments)).collect::<Vec<_>>(),
        error: even.error,
    };
    if best.error < 1e-14 {
        return Ok(best);
    }
    // For a given error: all segments but the last as long as it allows, and the end where the drop has it. The last
    // segment's error then tells whether the given one was too small.
    let reach = objective.reach(n);
    root(libm::log(even.error / f64::from(2 * segments)), libm::log(even.error), |log_error| {
        let error = libm::exp(log_error);
        let end = if reach < 1.0 { reach } else { versine(n, -libm::log(objective.unweighted(error))) };
        let mut bounds = Vec::with_capacity(segments as usize);
        let mut low = 0.0;
        for _ in 1..segments {
            low = longest(n, low, end, error, constraint, objective);
            bounds.push(low);
        }
        if low >= end {
            return 1.0;
        }
        let last = segment(n, low, end, constraint.of_segment(low, true), objective).error;
        bounds.push(end);
        if last.max(error) < best.error {
            best = Fit { coefficients: bounds, error: last.max(error) };
        }
        log_ratio(error, last)
    });
    Ok(best)
}

/// Where the segment from `low` on has the given error; `limit` if it has less there. By the secant method on
/// logarithms, as the error grows about as the third power of the length.
fn longest(n: f64, low: f64, limit: f64, error: f64, constraint: Constraint, objective: &Objective) -> f64 {
    let most = limit - low;
    if most <= 0.0 {
        return limit;
    }
    let mut power = 3.0;
    // The error of the best parabola: x^n is about e^-s.
    let guess = libm::cbrt(192.0 * error / exact(n, low));
    let mut length = (guess.min(3.0) / n).min(most);
    let mut before: Option<(f64, f64)> = None;
    for _ in 0..20 {
        let ratio = log_ratio(segment(n, low, low + length, constraint.of_segment(low, false), objective).error, error);
        if ratio.abs() < 1e-7 || (length == most && ratio < 0.0) {
            break;
        }
        if let Some((other, ratio_there)) = before
            && other != length
        {
            power = ((ratio - ratio_there) / libm::log(length / other)).clamp(0.5, 6.0);
        }
        before = Some((length, ratio));
        length = (length * libm::exp(-ratio / power)).min(most);
    }
    low + length
}

/// The logarithm of a ratio of errors; an error of 0 counts as a tiny one.
fn log_ratio(error: f64, other: f64) -> f64 {
    libm::log(error.max(1e-300)) - libm::log(other.max(1e-300))
}

/// Looks at an increasing function ever nearer to its zero, by regula falsi in Illinois' form. The zero lies between
/// the two bounds, or else below.
fn root(mut low: f64, mut high: f64, mut function: impl FnMut(f64) -> f64) {
    let (mut at_low, mut at_high) = (function(low), function(high));
    for _ in 0..8 {
        if at_low <= 0.0 {
            break;
        }
        (low, high, at_high) = (2.0 * low - high, low, at_low);
        at_low = function(low);
    }
    for _ in 0..60 {
        let middle = (low * at_high - high * at_low) / (at_high - at_low);
        let value = function(middle);
        if value.abs() < 1e-6 || high - low < 1e-12 {
            break;
        }
        if value < 0.0 {
            (low, at_low, at_high) = (middle, value, 0.5 * at_high);
        } else {
            (high, at_high, at_low) = (middle, value, 0.5 * at_low);
        }
    }
}

fn check(n: f64, segments: u32, objective: &Objective) -> Result<(), Error> {
    check_shininess(n)?;
    objective.check()?;
    if (1..=256).contains(&segments) {
        return Ok(());
    }
    Err(Error::input(format!("{segments} segments are out of range"), "there are 1 to 256 segments"))
}

/// A segment in its own coordinate `w = (u - origin) / unit`: `x (k_0 + k_1 w + k_2 w^2)`, with `k_0 = 1` if only two
/// are free.
struct Local {
    low: f64,
    high: f64,
    origin: f64,
    unit: f64,
}

impl Local {
    fn polynomial<const D: usize>(p: &[f64; D]) -> [f64; 3] {
        if D == 2 { [1.0, p[0], p[1]] } else { [p[0], p[1], p[2]] }
    }

    fn inside<const D: usize>(&self, p: &[f64; D], u: f64) -> f64 {
        let [k_0, k_1, k_2] = Self::polynomial(p);
        let w = (u - self.origin) / self.unit;
        k_0 + w * (k_1 + w * k_2)
    }

    /// Whether the inner parabola rises before this versine, where it is above 0.
    fn rises_before(&self, p: &[f64; 3], u: f64) -> bool {
        let [_, k_1, k_2] = p;
        k_1 + 2.0 * k_2 * (u - self.origin) / self.unit > 0.0 && self.inside(p, u) > 0.0
    }

    fn segment<const D: usize>(&self, p: &[f64; D]) -> Segment {
        let [k_0, k_1, k_2] = Self::polynomial(p);
        let (linear, square, origin) = (k_1 / self.unit, k_2 / (self.unit * self.unit), self.origin);
        Segment { c: k_0 - origin * (linear - origin * square), big_a: 2.0 * square * origin - linear, a: square }
    }
}

impl<const D: usize> Shape<D> for Local {
    fn pieces(&self, p: &[f64; D]) -> Pieces {
        let [k_0, k_1, k_2] = Self::polynomial(p);
        // The two zeros, in the form without cancellation; where there is none they are infinite or no numbers.
        let half = -0.5 * (k_1 + libm::sqrt(k_1 * k_1 - 4.0 * k_2 * k_0).copysign(k_1));
        let zeros = [half / k_2, k_0 / half].map(|w| self.origin + self.unit * w);
        let ordered = if zeros[0] <= zeros[1] { zeros } else { [zeros[1], zeros[0]] };
        let inner = ordered.map(|zero| if self.low < zero && zero < self.high { zero } else { f64::NAN });
        let piece = |from: f64, to: f64| {
            if self.inside(p, 0.5 * (from + to)) > 0.0 { Piece::Formula } else { Piece::Constant(0.0) }
        };
        match inner.map(f64::is_nan) {
            [true, true] => Pieces::one(piece(self.low, self.high)),
            [false, false] => Pieces::one(piece(self.low, inner[0]))
                .then(inner[0], piece(inner[0], inner[1]))
                .then(inner[1], piece(inner[1], self.high)),
            [first_outside, _] => {
                let zero = inner[usize::from(first_outside)];
                Pieces::one(piece(self.low, zero)).then(zero, piece(zero, self.high))
            }
        }
    }

    fn formula(&self, p: &[f64; D], u: f64) -> f64 {
        ((1.0 - u) * self.inside(p, u)).min(1.0)
    }
}

/// A segment whose inner parabola has its vertex at the segment's end: `x (k_0 + k_1 w^2)` with `w` falling from 1 at
/// its start to 0; with one free coefficient k_0 is `least`.
struct Ending {
    low: f64,
    high: f64,
    least: f64,
}

impl Ending {
    fn versine(&self, w: f64) -> f64 {
        self.high - w * (self.high - self.low)
    }

    fn parabola<const D: usize>(&self, p: &[f64; D]) -> [f64; 2] {
        if D == 1 { [self.least, p[0]] } else { [p[0], p[1]] }
    }

    fn segment(&self, &[k_0, k_1]: &[f64; 2]) -> Segment {
        let length = self.high - self.low;
        let square = k_1 / (length * length);
        Segment { c: k_0 + square * self.high * self.high, big_a: 2.0 * square * self.high, a: square }
    }
}

impl<const D: usize> Shape<D> for Ending {
    fn pieces(&self, p: &[f64; D]) -> Pieces {
        let [k_0, k_1] = self.parabola(p);
        let zero = self.versine(libm::sqrt(-k_0 / k_1));
        if k_0 < 0.0 && self.low < zero && zero < self.high {
            return Pieces::one(Piece::Formula).then(zero, Piece::Constant(0.0));
        }
        Pieces::one(if k_0 + k_1 > 0.0 { Piece::Formula } else { Piece::Constant(0.0) })
    }

    fn formula(&self, p: &[f64; D], u: f64) -> f64 {
        let [k_0, k_1] = self.parabola(p);
        let w = (self.high - u) / (self.high - self.low);
        ((1.0 - u) * (k_0 + k_1 * w * w)).min(1.0)
    }
}

/// What the best parabola is off by where it meets the power.
const ROUNDING: f64 = 1e-12;

/// A segment whose inner parabola meets the power at both ends: `x (chord + k (1 - w^2))`, `w` from -1 to 1.
struct Meeting {
    low: f64,
    high: f64,
    ends: [f64; 2],
}

impl Meeting {
    fn segment(&self, [k]: [f64; 1]) -> Segment {
        let [middle, half] = [0.5 * (self.low + self.high), 0.5 * (self.high - self.low)];
        let [level, slope] = [0.5 * (self.ends[0] + self.ends[1]), 0.5 * (self.ends[1] - self.ends[0]) / half];
        let square = -k / (half * half);
        Segment { c: level + k - middle * (slope - middle * square), big_a: 2.0 * square * middle - slope, a: square }
    }
}

impl Shape<1> for Meeting {
    fn pieces(&self, _: &[f64; 1]) -> Pieces {
        Pieces::one(Piece::Formula)
    }

    fn formula(&self, &[k]: &[f64; 1], u: f64) -> f64 {
        let w = (2.0 * u - self.low - self.high) / (self.high - self.low);
        let [first, last] = self.ends;
        let inside = 0.5 * (first * (1.0 - w) + last * (1.0 + w)) + k * (1.0 - w * w);
        ((1.0 - u) * inside.max(0.0)).min(1.0)
    }
}

/// [`fit_segment`] with arguments known to be good.
fn segment(n: f64, low: f64, high: f64, constraint: Constraint, objective: &Objective) -> Fit<Segment> {
    let m = n - 1.0;
    if m == 0.0 || m == 1.0 || m == 2.0 {
        return Fit { coefficients: Segment { c: 1.0, big_a: m, a: 0.5 * m * (m - 1.0) }, error: 0.0 };
    }
    let reach = objective.reach(n);
    let partly = reach < high;
    let all = reach < 0.5 * (low + high);
    let top = if partly && !all { reach } else { high };
    let target = Target::interval(n, low, top, objective);
    let wanted = |u: f64| libm::exp(m * libm::log1p(-u));
    let error_where_it_counts = |error: f64, fitted: &dyn Fn(&Target) -> f64| match (partly && all, low < reach) {
        (false, _) => error,
        (true, true) => fitted(&Target::interval(n, low, reach, objective)),
        (true, false) => 0.0,
    };
    // The starts interpolate: at the top and two further points, or at the zeros of Chebyshev's cubic polynomial.
    if constraint == Constraint::Peak {
        let local = Local { low, high: top, origin: 0.0, unit: top };
        let slope = |w: f64| (wanted(top * w) - 1.0) / w;
        let (w_1, w_2) = (0.4, 0.9);
        let square = (slope(w_2) - slope(w_1)) / (w_2 - w_1);
        let start = [slope(w_1) - w_1 * square, square];
        let Best { p, error } = minimax::minimise(&local, &target, [start].into_iter(), 1);
        let error = error_where_it_counts(error, &|part| minimax::largest_error(&local, part, &p));
        return Fit { coefficients: Segment { c: 1.0, ..local.segment(&p) }, error };
    }
    let local = Local { low, high: top, origin: 0.5 * (low + top), unit: 0.5 * (top - low) };
    let node = libm::sqrt(0.75);
    let [left, middle, right] = [-node, 0.0, node].map(|w| wanted(local.origin + local.unit * w));
    let start = [middle, 0.5 * (right - left) / node, (0.5 * (right + left) - middle) / (node * node)];
    let Best { p, error } = minimax::minimise(&local, &target, [start].into_iter(), 1);
    let is_falling = matches!(constraint, Constraint::Falling | Constraint::FallingLast);
    // For n between 2 and 3 the best parabola is above the power where it begins and below it where it ends, so that
    // one would rise from a segment to the next: there it meets the power at both ends.
    let (begins, ends) = (local.inside(&p, low) - wanted(low), local.inside(&p, high) - wanted(high));
    if is_falling
        && !partly
        && (begins > ROUNDING && low > 0.0 || ends < -ROUNDING && constraint == Constraint::Falling)
    {
        let meeting = Meeting { low, high, ends: [wanted(low), wanted(high)] };
        let middle = wanted(0.5 * (low + high)) - 0.5 * (wanted(low) + wanted(high));
        let Best { p, error } = minimax::minimise(&meeting, &target, [[middle]].into_iter(), 1);
        return Fit { coefficients: meeting.segment(p), error };
    }
    if is_falling && local.rises_before(&p, high) {
        // The least error under the constraint is where it binds: the parabola's vertex is the segment's end.
        let ending = Ending { low, high, least: wanted(high) };
        let at = |w: f64| wanted(ending.versine(w));
        let (w_1, w_2) = (0.9, 0.3);
        let square = (at(w_1) - at(w_2)) / (w_1 * w_1 - w_2 * w_2);
        let start = [at(w_1) - w_1 * w_1 * square, square];
        let Best { mut p, .. } = minimax::minimise(&ending, &target, [start].into_iter(), 1);
        if constraint == Constraint::Falling && p[0] < ending.least {
            let least = minimax::minimise(&ending, &target, [[at(1.0) - ending.least]].into_iter(), 1);
            p = [ending.least, least.p[0]];
        }
        let all = minimax::largest_error(&ending, &target, &p);
        let error = error_where_it_counts(all, &|part| minimax::largest_error(&ending, part, &p));
        return Fit { coefficients: ending.segment(&p), error };
    }
    let error = error_where_it_counts(error, &|part| minimax::largest_error(&local, part, &p));
    Fit { coefficients: local.segment(&p), error }
}
