//! The minimax fits against their own words: the errors that they promise, and that no other coefficients do better.
//! Lobes and errors are evaluated here anew, on far more points.

use brdfgen::fit::{Constraint, Fit, Inside, Objective, Segment, fit_segment, segment_bounds, segment_end};
use brdfgen::lobe::{Lobe, exact};
use brdfgen::method::cubic::{self, Cubic, Tail};
use brdfgen::method::cubic_rational::{self, CubicRational};
use brdfgen::method::quadratic::{self, Quadratic};
use brdfgen::method::{cubic_min_zero, power};
use rand_core::Rng;
use rand_pcg::Pcg64;

const SHININESSES: [f64; 13] = [1.0, 1.0001, 1.5, 2.0, 2.5, 3.0, 4.0, 7.3, 10.0, 100.0, 1000.0, 65_536.0, 1_048_576.0];

const OBJECTIVES: [Objective; 9] = [
    Objective::MaxAbs,
    Objective::MaxAbsLevel { level: 0.5 },
    Objective::MaxAbsLevel { level: 0.02 },
    Objective::MaxRel { level: 0.9 },
    Objective::MaxRel { level: 0.5 },
    Objective::MaxRel { level: 0.02 },
    Objective::Weighted { power: 1.0 },
    Objective::Weighted { power: 0.3 },
    Objective::Weighted { power: -0.5 },
];

/// A shape of one formula, with its coefficients A and a (0 where there is one only).
#[derive(Clone, Copy, Debug)]
enum Form {
    Quadratic,
    MinZero,
    Cubic(Tail),
    Power(u32, Inside),
}

const FORMS: [Form; 10] = [
    Form::Quadratic,
    Form::MinZero,
    Form::Cubic(Tail::Cut),
    Form::Cubic(Tail::Hold),
    Form::Power(2, Inside::Linear),
    Form::Power(2, Inside::Quadratic),
    Form::Power(4, Inside::Linear),
    Form::Power(4, Inside::Quadratic),
    Form::Power(8, Inside::Linear),
    Form::Power(8, Inside::Quadratic),
];

impl Form {
    fn fit(self, n: f64, objective: &Objective) -> Fit<[f64; 2]> {
        let (coefficients, error) = match self {
            Self::Quadratic => {
                let fit = quadratic::fit(n, objective).unwrap();
                ([fit.coefficients.a, 0.0], fit.error)
            }
            Self::MinZero => {
                let fit = cubic_min_zero::fit(n, objective).unwrap();
                ([fit.coefficients, 0.0], fit.error)
            }
            Self::Cubic(tail) => {
                let fit = cubic::fit(n, tail, objective).unwrap();
                ([fit.coefficients.big_a, fit.coefficients.a], fit.error)
            }
            Self::Power(k, inside) => {
                let fit = power::fit(n, k, inside, objective).unwrap();
                ([fit.coefficients.big_a, fit.coefficients.a], fit.error)
            }
        };
        Fit { coefficients, error }
    }

    fn has_two(self) -> bool {
        matches!(self, Self::Cubic(_) | Self::Power(_, Inside::Quadratic))
    }

    /// The lobe as the hardware has it.
    fn at(self, [big_a, a]: [f64; 2], u: f64) -> f64 {
        match self {
            Self::Quadratic => Quadratic { a: big_a }.at(u),
            Self::MinZero => (1.0 - u) * (1.0 - big_a * u).max(0.0).powi(2),
            Self::Cubic(Tail::Cut) => Cubic { a, big_a }.at(u),
            Self::Cubic(Tail::Hold) => {
                let value = |u: f64| (1.0 - u) * (1.0 - u * (big_a - a * u));
                // The local minimum: where the derivative -1 - A + 2 (A + a) u - 3 a u^2 goes from below 0 to above.
                let [c_0, c_1, c_2] = [-1.0 - big_a, 2.0 * (big_a + a), -3.0 * a];
                let root = (c_1 * c_1 - 4.0 * c_2 * c_0).sqrt();
                let minimum = if c_2 == 0.0 { -c_0 / c_1 } else { (-c_1 + root) / (2.0 * c_2) };
                let held = 0.0 < minimum && minimum < 1.0 && u > minimum;
                value(if held { minimum } else { u }).clamp(0.0, 1.0)
            }
            Self::Power(k, _) => {
                let past_vertex = a > 0.0 && u > big_a / (2.0 * a);
                if past_vertex { 0.0 } else { (1.0 - u * (big_a - a * u)).max(0.0).powi(k as i32) }
            }
        }
    }
}

/// A point at which an error counts: the versine, the exact lobe, the weight.
type Point = (f64, f64, f64);

fn point(n: f64, u: f64, objective: &Objective) -> Point {
    let f = exact(n, u);
    let weight = match *objective {
        Objective::MaxAbs | Objective::MaxAbsLevel { .. } => 1.0,
        Objective::MaxRel { .. } => 1.0 / f,
        Objective::Weighted { power } => f.max(1.0 / 65_536.0).powf(power),
    };
    (u, f, weight)
}

fn level(objective: &Objective) -> Option<f64> {
    match *objective {
        Objective::MaxAbsLevel { level } | Objective::MaxRel { level } => Some(level),
        _ => None,
    }
}

/// Points evenly spaced in ln f down to e^-14, which is where all features lie, with a tenth of the points for the
/// rest.
fn points(n: f64, count: u32, objective: &Objective) -> Vec<Point> {
    let depth = level(objective).map_or(14.0, |level| -level.ln());
    let mut versines: Vec<f64> =
        (0..=count).map(|i| -libm::expm1(-depth * f64::from(i) / f64::from(count) / n)).collect();
    if level(objective).is_none() {
        let last = versines[versines.len() - 1];
        versines
            .extend((1..=count / 10).map(|i| (last + (1.0 - last) * f64::from(i) / f64::from(count / 10)).min(1.0)));
    }
    versines.into_iter().map(|u| point(n, u, objective)).collect()
}

/// The largest weighted error at the points and on both sides of where the lobe goes down to 0, which it does once.
fn brute_force(lobe: impl Fn(f64) -> f64, n: f64, points: &[Point], objective: &Objective) -> f64 {
    let error = |&(u, f, weight): &Point| ((lobe(u) - f) * weight).abs();
    let mut largest = points.iter().map(error).fold(0.0, f64::max);
    let (mut above, mut zero) = (0.0, points[points.len() - 1].0);
    if lobe(zero) == 0.0 && lobe(above) > 0.0 {
        for _ in 0..100 {
            let middle = 0.5 * (above + zero);
            if lobe(middle) > 0.0 {
                above = middle;
            } else {
                zero = middle;
            }
        }
        for u in [above, zero] {
            largest = largest.max(error(&point(n, u, objective)));
        }
    }
    largest
}

fn error_at_1000(form: Form, objective: &Objective) -> f64 {
    form.fit(1000.0, objective).error
}

#[test]
fn the_targets_over_all_cosines_are_reached_at_n_1000() {
    let targets = [
        (Form::Quadratic, 0.144, 0.1425),
        (Form::MinZero, 0.0698, 0.0696),
        (Form::Cubic(Tail::Cut), 0.065, 0.0645),
        (Form::Cubic(Tail::Hold), 0.0497, 0.049),
        (Form::Power(2, Inside::Linear), 0.0699, 0.0697),
        (Form::Power(2, Inside::Quadratic), 0.0215, 0.0205),
        (Form::Power(4, Inside::Linear), 0.0335, 0.0329),
        (Form::Power(4, Inside::Quadratic), 0.0055, 0.0053),
        (Form::Power(8, Inside::Linear), 0.0161, 0.0159),
        (Form::Power(8, Inside::Quadratic), 0.0011, 0.00096),
    ];
    for (form, most, least) in targets {
        let error = error_at_1000(form, &Objective::MaxAbs);
        assert!(error <= most, "{form:?}: {error} is above {most}");
        // No lobe of the shape can do better than its optimum: an error below is a wrong report.
        assert!(error >= least, "{form:?}: {error} is too good to be true");
    }
}

#[test]
fn the_targets_on_the_epicentre_are_reached_at_n_1000() {
    let cut = Form::Cubic(Tail::Cut);
    assert!(error_at_1000(cut, &Objective::MaxAbsLevel { level: 0.5 }) <= 0.0016);
    assert!(error_at_1000(cut, &Objective::MaxRel { level: 0.5 }) <= 0.002_25);
    let square = error_at_1000(Form::Quadratic, &Objective::MaxAbsLevel { level: 0.5 });
    assert!((0.029..=0.0301).contains(&square), "{square}");
}

#[test]
fn the_reported_errors_agree_with_100_000_points() {
    for n in SHININESSES {
        for objective in OBJECTIVES {
            let points = points(n, 100_000, &objective);
            for form in FORMS {
                let fit = form.fit(n, &objective);
                let found = brute_force(|u| form.at(fit.coefficients, u), n, &points, &objective);
                let slack = 1e-4 * fit.error + 1e-12;
                assert!((found - fit.error).abs() <= slack, "{form:?} {objective:?} n = {n}: {fit:?}, but {found}");
            }
        }
    }
}

#[test]
fn no_coefficients_nearby_do_better() {
    let mut random = Pcg64::new(1, 2);
    let mut uniform = || (random.next_u64() >> 11) as f64 / f64::from(1 << 26) / f64::from(1 << 26) - 1.0;
    for n in SHININESSES {
        for objective in OBJECTIVES {
            let points = points(n, 3000, &objective);
            for form in FORMS {
                let fit = form.fit(n, &objective);
                for trial in 0..60 {
                    let size = libm::pow(10.0, -1.0 - f64::from(trial % 5));
                    let [big_a, a] = fit.coefficients;
                    let away = [
                        big_a * (1.0 + size * uniform()) + 0.01 * size * uniform(),
                        if form.has_two() { a * (1.0 + size * uniform()) + 0.01 * size * uniform() } else { 0.0 },
                    ];
                    let found = brute_force(|u| form.at(away, u), n, &points, &objective);
                    // A grid of 3000 points misses up to 1e-4 of the peaks.
                    assert!(
                        found >= fit.error * (1.0 - 1e-4) - 1e-12,
                        "{form:?} {objective:?} n = {n}: {fit:?}, but {found} at {away:?}"
                    );
                }
            }
        }
    }
}

#[test]
fn what_a_shape_can_represent_is_found_exactly() {
    for objective in OBJECTIVES {
        for (form, n, big_a, a) in [
            (Form::Quadratic, 1.0, 0.0, 0.0),
            (Form::Quadratic, 2.0, 1.0, 0.0),
            (Form::MinZero, 1.0, 0.0, 0.0),
            (Form::MinZero, 3.0, 1.0, 0.0),
            (Form::Cubic(Tail::Cut), 1.0, 0.0, 0.0),
            (Form::Cubic(Tail::Cut), 2.0, 1.0, 0.0),
            (Form::Cubic(Tail::Cut), 3.0, 2.0, 1.0),
            (Form::Cubic(Tail::Hold), 3.0, 2.0, 1.0),
            (Form::Power(2, Inside::Linear), 2.0, 1.0, 0.0),
            (Form::Power(4, Inside::Quadratic), 8.0, 2.0, 1.0),
            (Form::Power(8, Inside::Linear), 8.0, 1.0, 0.0),
        ] {
            assert_eq!(form.fit(n, &objective), Fit { coefficients: [big_a, a], error: 0.0 }, "{form:?} n = {n}");
        }
    }
    for n in [1.0, 2.0, 3.0] {
        let fit = fit_segment(n, 0.25, 0.5, Constraint::None, &Objective::MaxAbs).unwrap();
        assert_eq!((fit.coefficients.c, fit.coefficients.big_a, fit.error), (1.0, n - 1.0, 0.0));
        assert_eq!(
            segment_end(n, 4, Constraint::Peak, &Objective::MaxAbs).unwrap(),
            Fit { coefficients: n, error: 0.0 }
        );
    }
}

#[test]
fn errors_vary_smoothly_with_the_shininess() {
    for objective in OBJECTIVES {
        for form in FORMS {
            let mut before = form.fit(50.0, &objective);
            for n in 51..=1000 {
                let fit = form.fit(f64::from(n), &objective);
                let change = fit.error / before.error;
                assert!((0.999..1.05).contains(&change), "{form:?} {objective:?}: {before:?}, then {fit:?} at n = {n}");
                before = fit;
            }
        }
    }
}

/// The lobe past the level is free, but it is a lobe: no rise from the highlight on.
#[test]
fn lobes_of_an_objective_with_a_level_do_not_rise_past_it() {
    for n in [1.5, 7.3, 100.0, 65_536.0] {
        for objective in OBJECTIVES.into_iter().filter(|objective| level(objective).is_some()) {
            for form in FORMS {
                let fit = form.fit(n, &objective);
                let mut last = 1.0;
                for (u, ..) in points(n, 2000, &Objective::MaxAbs) {
                    let value = form.at(fit.coefficients, u);
                    assert!(
                        (0.0..=last).contains(&value),
                        "{form:?} {objective:?} n = {n} u = {u}: {last}, then {value}"
                    );
                    last = value;
                }
            }
        }
    }
}

fn segment_at(Segment { c, big_a, a }: Segment, u: f64) -> f64 {
    ((1.0 - u) * (c - u * (big_a - a * u))).clamp(0.0, 1.0)
}

/// Points evenly spaced in u, and others in ln f for what happens near u = 1, where errors count.
fn segment_points(n: f64, low: f64, high: f64, count: u32, objective: &Objective) -> Vec<Point> {
    let depth = |u: f64| -n * libm::log1p(-u.min(1.0 - 1e-7));
    let part = |i: u32| f64::from(i) / f64::from(count);
    let even = (0..=count).map(|i| low + (high - low) * part(i));
    let deep = (0..=count).map(|i| -libm::expm1(-(depth(low) + (depth(high) - depth(low)) * part(i)) / n));
    even.chain(deep.map(|u| u.clamp(low, high)))
        .map(|u| point(n, u, objective))
        .filter(|&(_, f, _)| level(objective).is_none_or(|level| f >= level))
        .collect()
}

fn segment_error(segment: Segment, points: &[Point]) -> f64 {
    points.iter().map(|&(u, f, weight)| ((segment_at(segment, u) - f) * weight).abs()).fold(0.0, f64::max)
}

/// The last case's end is far beyond what its neighbour would have: there the clamp at 0 is at work.
const SEGMENTS: [(f64, f64); 6] = [(0.0, 0.4), (0.0, 1.9), (0.4, 0.8), (1.5, 4.7), (5.2, 8.3), (3.0, 14.0)];

#[test]
fn segments_are_as_good_as_reported_and_none_nearby_is_better() {
    let mut random = Pcg64::new(3, 4);
    let mut uniform = || (random.next_u64() >> 11) as f64 / f64::from(1 << 26) / f64::from(1 << 26) - 1.0;
    for n in SHININESSES {
        for objective in [Objective::MaxAbs, Objective::Weighted { power: 0.5 }, Objective::Weighted { power: -0.5 }] {
            for (s_low, s_high) in SEGMENTS {
                let (low, high) = (s_low / n.max(s_high), s_high / n.max(s_high));
                let first = low == 0.0;
                let peak = if first { Constraint::Peak } else { Constraint::None };
                let fit = fit_segment(n, low, high, peak, &objective).unwrap();
                let points = segment_points(n, low, high, 10_000, &objective);
                let found = segment_error(fit.coefficients, &points);
                let about = format!("{objective:?} n = {n} s = {s_low}..{s_high}: {fit:?}");
                assert!((found - fit.error).abs() <= 1e-4 * fit.error + 1e-11, "{about}, but {found}");
                assert!(!first || fit.coefficients.c == 1.0, "{about}");
                for trial in 0..30 {
                    let size = fit.error * libm::pow(10.0, -f64::from(trial % 4));
                    let mut away = fit.coefficients;
                    away.c += if first { 0.0 } else { size * uniform() };
                    away.big_a += size * uniform() / high;
                    away.a += size * uniform() / (high * high);
                    let found = segment_error(away, &points);
                    assert!(found >= fit.error * (1.0 - 1e-4) - 1e-11, "{about}, but {found} at {away:?}");
                }
            }
        }
    }
}

#[test]
fn a_segment_counts_only_what_lies_above_the_level() {
    let n = 1000.0;
    for objective in [Objective::MaxAbsLevel { level: 0.5 }, Objective::MaxRel { level: 0.5 }] {
        // The level lies at s = 0.693: late in the first segment, early in the second, before the third.
        for (s_low, s_high, most) in [(0.4, 0.8, 1e-3), (0.6, 1.2, 3e-3), (0.8, 1.6, 0.0)] {
            let (low, high) = (s_low / n, s_high / n);
            let fit = fit_segment(n, low, high, Constraint::None, &objective).unwrap();
            let points = segment_points(n, low, high, 10_000, &objective);
            let found = segment_error(fit.coefficients, &points);
            assert!((found - fit.error).abs() <= 1e-3 * fit.error, "{fit:?}, but {found}");
            assert!(fit.error <= most, "{fit:?}");
            let [c, big_a, a] = fit.coefficients.scaled(n);
            assert!(c.abs() < 2.0 && big_a.abs() < 2.0 && a.abs() < 2.0, "{fit:?}");
        }
    }
}

/// The largest error of a whole segmented lobe with the given bounds, which is also what it is past the last.
fn segmented_error(n: f64, bounds: &[f64], constraint: Constraint, objective: &Objective) -> f64 {
    let drop = brute_force(|_| 0.0, n, &[point(n, bounds[bounds.len() - 1], objective)], objective);
    let mut low = 0.0;
    let mut largest = drop;
    for &high in bounds {
        let fit =
            fit_segment(n, low, high, constraint.of_segment(low, high == bounds[bounds.len() - 1]), objective).unwrap();
        largest = largest.max(segment_error(fit.coefficients, &segment_points(n, low, high, 10_000, objective)));
        low = high;
    }
    largest
}

#[test]
fn falling_segments_fall_within_and_where_they_meet() {
    for objective in [Objective::MaxAbs, "weighted:-0.3".parse().unwrap()] {
        for n in [1.5, 2.5, 4.0, 7.3, 41.0, 1000.0, 65536.0] {
            for segments in [1, 2, 4, 8] {
                let whole = |constraint| segment_bounds(n, segments, constraint, &objective).unwrap();
                let bounds = whole(Constraint::Falling).coefficients;
                let free = whole(Constraint::None).error;
                let mut low = 0.0;
                let mut before = f64::INFINITY;
                for (place, &high) in bounds.iter().enumerate() {
                    let constraint = Constraint::Falling.of_segment(low, place + 1 == bounds.len());
                    let Segment { c, big_a, a } =
                        fit_segment(n, low, high, constraint, &objective).unwrap().coefficients;
                    let value = |u: f64| (1.0 - u) * (c - u * (big_a - a * u)).max(0.0);
                    for step in 0..=2000 {
                        let here = value(low + (high - low) * f64::from(step) / 2000.0);
                        // The coefficients cancel by up to (n u)^2.
                        assert!(here <= before + 1e-9, "{objective:?} n = {n}, segment {place} of {segments}: {here}");
                        before = here;
                    }
                    low = high;
                }
                // What it costs: the last segment alone has to do with less.
                let grown = whole(Constraint::Falling).error / free.max(1e-14);
                assert!((1.0 - 1e-3..2.0).contains(&grown) || free < 1e-12, "n = {n}, {segments}: {grown}");
            }
        }
    }
}

#[test]
fn segmented_lobes_reach_their_targets_at_n_1000() {
    for (segments, free, exact, even) in
        [(2, 0.0092, 0.0099, 0.0201), (4, 0.0016, 0.001_63, 0.007), (8, 0.000_25, 0.000_25, 0.0021)]
    {
        for (constraint, target) in [(Constraint::None, free), (Constraint::Peak, exact)] {
            let fit = segment_bounds(1000.0, segments, constraint, &Objective::MaxAbs).unwrap();
            assert_eq!(fit.coefficients.len(), segments as usize);
            let found = segmented_error(1000.0, &fit.coefficients, constraint, &Objective::MaxAbs);
            assert!((found / fit.error - 1.0).abs() < 2e-4, "{segments} {constraint:?}: {fit:?}, but {found}");
            assert!(fit.error <= target, "{segments} {constraint:?}: {fit:?}");
            let equal = segment_end(1000.0, segments, constraint, &Objective::MaxAbs).unwrap();
            assert!(fit.error < equal.error && equal.error <= even, "{segments} {constraint:?}: {equal:?}");
        }
    }
}

#[test]
fn no_other_bounds_nearby_are_better() {
    for n in [1.5, 7.3, 1000.0] {
        for objective in [Objective::MaxAbs, Objective::Weighted { power: 0.5 }] {
            let equal = segment_end(n, 4, Constraint::Peak, &objective).unwrap();
            for stretch in [0.9, 0.999, 1.001, 1.1] {
                let end = (equal.coefficients / n * stretch).min(1.0);
                let bounds: Vec<f64> = (1..=4).map(|i| end * f64::from(i) / 4.0).collect();
                assert!(
                    segmented_error(n, &bounds, Constraint::Peak, &objective) >= equal.error * (1.0 - 1e-4),
                    "{n} {equal:?}"
                );
            }
            let best = segment_bounds(n, 4, Constraint::Peak, &objective).unwrap();
            for moved in 0..4 {
                for stretch in [0.95, 0.999, 1.001, 1.05] {
                    let mut bounds = best.coefficients.clone();
                    bounds[moved] = (bounds[moved] * stretch).min(1.0);
                    if bounds.is_sorted() {
                        let found = segmented_error(n, &bounds, Constraint::Peak, &objective);
                        assert!(found >= best.error * (1.0 - 1e-4), "{n} {best:?}, but {found} at {bounds:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn bad_arguments_are_refused() {
    let fine = Objective::MaxAbs;
    for n in [0.99, 1_048_577.0, f64::NAN] {
        assert!(quadratic::fit(n, &fine).is_err() && segment_end(n, 2, Constraint::Peak, &fine).is_err());
    }
    for objective in [
        Objective::MaxRel { level: 0.0 },
        Objective::MaxAbsLevel { level: 1.0 },
        Objective::MaxRel { level: f64::NAN },
        Objective::Weighted { power: 1.1 },
        Objective::Weighted { power: -1.0 },
    ] {
        assert!(cubic::fit(10.0, Tail::Cut, &objective).is_err(), "{objective:?}");
    }
    assert!(power::fit(10.0, 3, Inside::Linear, &fine).is_err());
    for (low, high) in [(0.5, 0.5), (-0.1, 0.5), (0.5, 1.1), (0.1, f64::NAN)] {
        assert!(fit_segment(10.0, low, high, Constraint::None, &fine).is_err(), "{low} {high}");
    }
    assert!(fit_segment(10.0, 0.1, 0.5, Constraint::Peak, &fine).is_err());
    for segments in [0, 257] {
        assert!(segment_bounds(10.0, segments, Constraint::None, &fine).is_err());
    }
}

/// The rational tail's fit reports its error, goes on from the cubic's value, and halves the paper's error.
#[test]
fn rational_tails_are_as_good_as_reported_and_none_nearby_is_better() {
    for n in SHININESSES.into_iter().filter(|&n| n > 1.0) {
        let objective = Objective::MaxAbs;
        let fit = cubic_rational::fit(n, &objective).unwrap();
        let lobe = fit.coefficients;
        let points = points(n, 100_000, &objective);
        let error = |lobe: CubicRational| brute_force(|u| lobe.at(u), n, &points, &objective);
        let paper = error(CubicRational::new(n, 0.5).unwrap());
        let own = error(lobe);
        assert!((own - fit.error).abs() < 1e-3 * fit.error + 1e-9, "n = {n}: {own} and not {}", fit.error);
        assert!(own <= paper && (n < 10.0 || own < 0.6 * paper), "n = {n}: {own}, the paper's {paper}");
        let tail = |u: f64| (1.0 - u) / (lobe.d + lobe.b * u);
        let cubic = lobe.cubic.formula(lobe.cusp);
        assert!((tail(lobe.cusp) - cubic.min(0.5)).abs() < 1e-12, "n = {n}: a step at the cusp");
        for factor in [0.99, 0.999, 1.001, 1.01] {
            let b = lobe.b * factor;
            let other = CubicRational { b, d: lobe.d + (lobe.b - b) * lobe.cusp, ..lobe };
            assert!(error(other) > own - 1e-4 * own, "n = {n}: b times {factor} is better");
        }
    }
    assert!(cubic_rational::fit(1000.0, &Objective::MaxAbs).unwrap().error < 0.0510);
    assert_eq!(cubic_rational::fit(1.0, &Objective::MaxAbs).unwrap().error, 0.0);
}
