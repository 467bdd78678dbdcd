//! The coefficients against high precision and against the systems of equations that define them.

use astro_float::{BigFloat, Consts, RoundingMode};
use brdfgen::lobe::{Lobe, exact};
use brdfgen::method::cubic::Cubic;
use brdfgen::method::cubic_min_zero::MinZero;
use brdfgen::method::cubic_rational::CubicRational;
use brdfgen::method::lyon::Lyon;
use brdfgen::method::quadratic::Quadratic;
use brdfgen::method::schlick::Schlick;
use brdfgen::papers::{CosK, Taylor, TaylorSeries};
use proptest::prelude::*;

/// Bits of the reference arithmetic: enough to lose sixty to cancellation and still have a hundred.
const BITS: usize = 320;
const ROUND: RoundingMode = RoundingMode::ToEven;

/// A number of [`BITS`] bits with the arithmetic that the printed formulas need.
#[derive(Clone)]
struct Big(BigFloat);

impl Big {
    fn new(value: f64) -> Self {
        Self(BigFloat::from_f64(value, BITS))
    }
    fn add(&self, other: &Self) -> Self {
        Self(self.0.add(&other.0, BITS, ROUND))
    }
    fn sub(&self, other: &Self) -> Self {
        Self(self.0.sub(&other.0, BITS, ROUND))
    }
    fn mul(&self, other: &Self) -> Self {
        Self(self.0.mul(&other.0, BITS, ROUND))
    }
    fn div(&self, other: &Self) -> Self {
        Self(self.0.div(&other.0, BITS, ROUND))
    }
    fn sqrt(&self) -> Self {
        Self(self.0.sqrt(BITS, ROUND))
    }
    fn pow(&self, exponent: &Self, consts: &mut Consts) -> Self {
        Self(self.0.pow(&exponent.0, BITS, ROUND, consts))
    }
    /// The nearest double, by the decimal digits: the library has no direct way.
    fn to_f64(&self) -> f64 {
        self.0.to_string().parse().expect("a decimal number")
    }
}

struct Reference {
    one: Big,
    consts: Consts,
}

impl Reference {
    fn new() -> Self {
        Self { one: Big::new(1.0), consts: Consts::new().expect("memory for constants") }
    }

    /// a = (1 - t^(n-1)) / (1 - t), t = sqrt(1 - 1/n).
    fn quadratic(&mut self, n: f64) -> f64 {
        let n = Big::new(n);
        let t = self.one.sub(&self.one.div(&n)).sqrt();
        let power = t.pow(&n.sub(&self.one), &mut self.consts);
        self.one.sub(&power).div(&self.one.sub(&t)).to_f64()
    }

    /// (a, A, the larger of A's two terms) from the printed system.
    fn cubic(&mut self, n: f64, q: f64) -> [f64; 3] {
        let (n, q, two) = (Big::new(n), Big::new(q), Big::new(2.0));
        let t = q.pow(&self.one.div(&n), &mut self.consts);
        let u = self.one.sub(&t);
        let h = q.div(&t);
        let slope = n.sub(&self.one).mul(&q).div(&t.mul(&t));
        let a = self.one.sub(&h).sub(&slope.mul(&u)).div(&u.mul(&u));
        let second = two.mul(&a).mul(&u);
        [a.to_f64(), slope.add(&second).to_f64(), slope.to_f64().abs().max(second.to_f64().abs())]
    }

    /// (a, A, the larger of A's two terms) from a = (s(r) - s(l))/(r - l), A = s(r) + a(1 - r).
    fn three_point(&mut self, n: f64, q: f64, g: f64) -> [f64; 3] {
        let inverse = self.one.div(&Big::new(n));
        let mut point = |v: f64| {
            let v = Big::new(v);
            let p = v.pow(&inverse, &mut self.consts);
            (self.one.sub(&v.div(&p)).div(&self.one.sub(&p)), p)
        };
        let ((s_r, r), (s_l, l)) = (point(q), point(g));
        let a = s_r.sub(&s_l).div(&r.sub(&l));
        let second = a.mul(&self.one.sub(&r));
        [a.to_f64(), s_r.add(&second).to_f64(), s_r.to_f64().abs().max(second.to_f64().abs())]
    }

    /// K = (1 - sqrt(q/t))/(1 - t).
    fn min_zero(&mut self, n: f64, q: f64) -> f64 {
        let (n, q) = (Big::new(n), Big::new(q));
        let t = q.pow(&self.one.div(&n), &mut self.consts);
        self.one.sub(&q.div(&t).sqrt()).div(&self.one.sub(&t)).to_f64()
    }

    /// (b, d, 1 - t) from the tail's system: with v = d + b (1-t), t/v = q and (v + b t)/v^2 = n q/t.
    fn rational(&mut self, n: f64, q: f64) -> [f64; 3] {
        let (n, q) = (Big::new(n), Big::new(q));
        let t = q.pow(&self.one.div(&n), &mut self.consts);
        let u = self.one.sub(&t);
        let v = t.div(&q);
        let b = n.mul(&q).mul(&v).mul(&v).div(&t).sub(&v).div(&t);
        [b.to_f64(), v.sub(&b.mul(&u)).to_f64(), u.to_f64()]
    }
}

fn relative(got: f64, expected: f64) -> f64 {
    if got == expected { 0.0 } else { ((got - expected) / expected).abs() }
}

/// `tests/data/coefficients.csv`: n = 1..=1000 at Q = 1/2, computed at 50 digits.
#[test]
fn coefficients_agree_with_the_stored_table() {
    let mut rows = 0;
    for line in include_str!("../data/coefficients.csv").lines().skip(1) {
        let values: Vec<f64> = line.split(',').map(|v| v.parse().expect("a number")).collect();
        let (quadratic, cubic) = (Quadratic::new(values[0]).unwrap(), Cubic::new(values[0], 0.5).unwrap());
        assert!(relative(quadratic.a, values[1]) < 1e-13, "a({}) = {}", values[0], quadratic.a);
        assert!(relative(cubic.a, values[2]) < 1e-13, "cubic a({}) = {}", values[0], cubic.a);
        assert!(relative(cubic.big_a, values[3]) < 1e-13, "cubic A({}) = {}", values[0], cubic.big_a);
        let three_point = Cubic::three_point(values[0], Cubic::THREE_POINT_Q, Cubic::THREE_POINT_G).unwrap();
        assert!(relative(three_point.a, values[4]) < 1e-13, "three-point a({}) = {}", values[0], three_point.a);
        assert!(relative(three_point.big_a, values[5]) < 1e-13, "three-point A({}) = {}", values[0], three_point.big_a);
        let (min_zero, tail) = (MinZero::new(values[0], 0.5).unwrap(), CubicRational::new(values[0], 0.5).unwrap());
        assert!(relative(min_zero.k, values[6]) < 1e-14, "K({}) = {}", values[0], min_zero.k);
        assert!(relative(tail.d, values[7]) < 1e-14, "d({}) = {}", values[0], tail.d);
        assert!(tail.b == values[8], "b({}) = {}", values[0], tail.b);
        assert!(relative(tail.cusp, 1.0 - values[9]) < 1e-12, "1 - t({}) = {}", values[0], tail.cusp);
        rows += 1;
    }
    assert_eq!(rows, 1000);
}

/// Real shininesses from 1 + 1e-9 to 1e6, dense where the printed forms cancel.
fn hard_shininesses() -> Vec<f64> {
    let mut list = Vec::new();
    for exponent in -9..=0 {
        for digit in [1.0, 3.7] {
            let small = digit * 10f64.powi(exponent);
            list.extend([1.0 + small, 2.0 + small, 3.0 + small]);
            list.extend((small < 0.9).then_some([2.0 - small, 3.0 - small]).into_iter().flatten());
        }
    }
    list.extend((0..=60).map(|step| 10f64.powf(f64::from(step) / 10.0)));
    list.push(1e6);
    list.retain(|&n| n > 1.0);
    list
}

#[test]
fn quadratic_is_accurate_for_every_real_shininess() {
    let mut reference = Reference::new();
    for n in hard_shininesses() {
        let (got, expected) = (Quadratic::new(n).unwrap().a, reference.quadratic(n));
        assert!(relative(got, expected) < 1e-13, "n = {n}: {got} for {expected}");
    }
}

#[test]
fn cubic_is_accurate_for_every_real_shininess_and_level() {
    let mut reference = Reference::new();
    for q in [0.05, 0.1, 0.25, 0.2847, 0.3, 0.5, 0.6, 0.75, 0.9, 0.95] {
        for n in hard_shininesses() {
            let got = Cubic::new(n, q).unwrap();
            let [a, big_a, scale] = reference.cubic(n, q);
            if n == 2.0 {
                // An exact zero, which the reference misses by its own rounding.
                assert!(got.a == 0.0 && a.abs() < 1e-80, "n = {n}, q = {q}: a = {} for {a}", got.a);
            } else {
                assert!(relative(got.a, a) < 1e-13, "n = {n}, q = {q}: a = {} for {a}", got.a);
            }
            // A has a zero for n < 2 and some q up to 0.2847: near it its terms cancel, and their size is the measure.
            let measure = if q < 0.3 && n < 2.0 { scale } else { big_a.abs() };
            assert!((got.big_a - big_a).abs() < 1e-13 * measure, "n = {n}, q = {q}: A = {} for {big_a}", got.big_a);
        }
    }
}

#[test]
fn three_point_is_accurate_for_every_real_shininess_and_pair_of_levels() {
    let mut reference = Reference::new();
    let usual = (Cubic::THREE_POINT_Q, Cubic::THREE_POINT_G);
    for (q, g) in [usual, (0.5, 0.499_999), (0.999, 0.5), (0.95, 1e-6), (0.3, 0.01), (1e-3, 1e-6), (0.75, 0.25)] {
        for n in hard_shininesses() {
            let got = Cubic::three_point(n, q, g).unwrap();
            let [a, big_a, scale] = reference.three_point(n, q, g);
            if n == 2.0 {
                assert!(got.a == 0.0 && a.abs() < 1e-80, "n = {n}, q = {q}, g = {g}: a = {} for {a}", got.a);
            } else {
                assert!(relative(got.a, a) < 1e-13, "n = {n}, q = {q}, g = {g}: a = {} for {a}", got.a);
            }
            // A has a zero for n < 2, as the touching cubic's.
            let measure = if n < 2.0 { scale } else { big_a.abs() };
            let error = (got.big_a - big_a).abs();
            assert!(error < 1e-13 * measure, "n = {n}, q = {q}, g = {g}: A = {} for {big_a}", got.big_a);
        }
    }
}

#[test]
fn min_zero_and_tail_are_accurate_for_every_real_shininess_and_level() {
    let mut reference = Reference::new();
    for q in [0.05, 0.3, 0.367_88, 0.42, 0.5, 0.6, 0.95] {
        for n in hard_shininesses() {
            let (min_zero, expected) = (MinZero::new(n, q).unwrap(), reference.min_zero(n, q));
            assert!(relative(min_zero.k, expected) < 1e-14, "n = {n}, q = {q}: {} for {expected}", min_zero.k);
            let (tail, [b, d, cusp]) = (CubicRational::new(n, q).unwrap(), reference.rational(n, q));
            assert!(relative(tail.b, b) < 1e-14, "n = {n}, q = {q}: b = {} for {b}", tail.b);
            assert!((tail.d - d).abs() < 1e-14 / q, "n = {n}, q = {q}: d = {} for {d}", tail.d);
            assert!(relative(tail.cusp, cusp) < 1e-14, "n = {n}, q = {q}: 1 - t = {} for {cusp}", tail.cusp);
        }
    }
}

/// For q = 1/2 the tail is the papers' `x / (a - b x)`, `a = 2 n t`, `b = 2n - 2`.
#[test]
fn the_tail_is_the_papers() {
    for n in [1.0, 2.0, 7.5, 100.0, 1000.0] {
        let (tail, t) = (CubicRational::new(n, 0.5).unwrap(), libm::exp2(-1.0 / n));
        assert_eq!(tail.b, 2.0 * n - 2.0);
        assert!((tail.d + tail.b - 2.0 * n * t).abs() < 1e-12 * n, "n = {n}");
        for x in [0.0, 0.3 * t, 0.9 * t, 0.999 * t] {
            assert!(
                relative(tail.at(1.0 - x), x / (2.0 * n * t - tail.b * x)) < 1e-12 * n || x == 0.0,
                "n = {n}, x = {x}"
            );
        }
    }
    let limit = CubicRational::new(1e6, 0.5).unwrap().d;
    assert!((limit - (2.0 - 2.0 * core::f64::consts::LN_2)).abs() < 1e-6, "{limit}");
}

#[test]
fn limits_of_the_papers_variants() {
    let three_point = |n| Cubic::three_point(n, Cubic::THREE_POINT_Q, Cubic::THREE_POINT_G).unwrap();
    assert_eq!(three_point(1.0), Cubic { a: 0.0, big_a: 0.0 });
    let (two, three) = (three_point(2.0), three_point(3.0));
    assert!(two.a == 0.0 && relative(two.big_a, 1.0) < 1e-15);
    assert!(relative(three.a, 1.0) < 1e-14 && relative(three.big_a, 2.0) < 1e-14);
    assert_eq!(MinZero::new(1.0, 0.5).unwrap().k, 0.0);
    assert!(relative(MinZero::new(3.0, 0.5).unwrap().k, 1.0) < 1e-15);
    assert!((MinZero::new(1e6, 0.5).unwrap().k / 1e6 - 0.422_56).abs() < 1e-5);
    let one = CubicRational::new(1.0, 0.5).unwrap();
    assert_eq!((one.b, one.d, one.cusp), (0.0, 1.0, 0.5));
}

/// The comparators against their printed formulas, in the cosine or the angle, where these do not cancel.
#[test]
fn comparators_are_the_printed_formulas() {
    for n in [1.0, 3.0, 10.0, 37.5] {
        for u in [0.0, 1e-3, 0.02, 0.1, 0.3, 0.7, 1.0] {
            let (x, angle) = (1.0 - u, libm::acos(1.0 - u));
            let close = |got: f64, expected: f64| (got - expected).abs() < 1e-13 * n * n;
            assert!(close(Schlick::new(n).unwrap().at(u), x / (n - n * x + x)), "Schlick, n = {n}, u = {u}");
            for k in [2, 4, 8] {
                let (power, chord2) = (f64::from(k), 2.0 * u);
                let lyon = libm::pow((1.0 - n * chord2 / (2.0 * power)).max(0.0), power);
                assert!(close(Lyon::new(n, k).unwrap().at(u), lyon), "Lyon {k}, n = {n}, u = {u}");
                let scaled = libm::sqrt(n / power) * angle;
                let cos_k =
                    if scaled < core::f64::consts::FRAC_PI_2 { libm::pow(libm::cos(scaled), power) } else { 0.0 };
                assert!(close(CosK::new(n, k).unwrap().at(u), cos_k), "cos^{k}, n = {n}, u = {u}");
            }
            let chord = 1.0 - n * u + (n * n / 8.0 - n / 12.0) * 4.0 * u * u;
            let three = 1.0 - n * u + n * (n - 1.0) / 2.0 * u * u;
            let four = three - n * (n - 1.0) * (n - 2.0) / 6.0 * u * u * u;
            for (series, sum) in
                [(TaylorSeries::Chord, chord), (TaylorSeries::Versine3, three), (TaylorSeries::Versine4, four)]
            {
                let lobe = Taylor::new(n, series).unwrap();
                assert!((lobe.sum(u) - sum).abs() < 1e-14 * n * n * n, "{series:?}, n = {n}, u = {u}");
                assert_eq!(lobe.at(u), lobe.sum(u).clamp(0.0, 1.0));
            }
        }
    }
    // The order of each series: the error falls as the first term left out, u^3 or u^4; with the chord as u^2 n/6.
    for (series, order) in [(TaylorSeries::Chord, 2.0), (TaylorSeries::Versine3, 3.0), (TaylorSeries::Versine4, 4.0)] {
        let lobe = Taylor::new(10.5, series).unwrap();
        let error = |u: f64| (lobe.sum(u) - exact(10.5, u)).abs();
        let measured = libm::log2(error(2e-3) / error(1e-3));
        assert!((measured - order).abs() < 0.2, "{series:?}: order {measured}");
    }
}

#[test]
fn limits_of_0_over_0_are_exact() {
    assert_eq!(Quadratic::new(1.0).unwrap().a, 0.0);
    assert!(relative(Quadratic::new(2.0).unwrap().a, 1.0) < 1e-15);
    assert_eq!(Cubic::new(1.0, 0.5).unwrap(), Cubic { a: 0.0, big_a: 0.0 });
    let (two, three) = (Cubic::new(2.0, 0.5).unwrap(), Cubic::new(3.0, 0.5).unwrap());
    assert!(two.a == 0.0 && relative(two.big_a, 1.0) < 1e-15);
    assert!(relative(three.a, 1.0) < 1e-14 && relative(three.big_a, 2.0) < 1e-14);
    // Large n: the limits that the papers' curves tend to.
    let large = 1e6;
    assert!((Quadratic::new(large).unwrap().a / large - 0.786_94).abs() < 1e-5);
    assert!((Cubic::new(large, 0.5).unwrap().a / large / large - 0.319).abs() < 1e-3);
}

#[test]
fn the_cubic_rises_past_its_cut() {
    let cubic = Cubic::new(1000.0, 0.5).unwrap();
    let uncut = |u: f64| (1.0 - u) * (1.0 - u * (cubic.big_a - cubic.a * u));
    let cut = cubic.cut().unwrap();
    assert!(uncut(0.5) > 10_000.0, "the reason for the cut: {}", uncut(0.5));
    assert!(cubic.at(cut) > 0.0 && cubic.at(cut.next_up()) == 0.0);
    assert_eq!(Cubic::new(2.0, 0.5).unwrap().cut(), None);
}

#[test]
fn refused_parameters() {
    for n in [0.0, 0.999, -3.0, f64::NAN, f64::INFINITY, 2e6] {
        assert!(Quadratic::new(n).is_err() && Cubic::new(n, 0.5).is_err(), "n = {n}");
    }
    for q in [0.0, 0.049, 0.951, 1.0, f64::NAN] {
        assert!(Cubic::new(5.0, q).is_err(), "q = {q}");
        assert!(MinZero::new(5.0, q).is_err() && CubicRational::new(5.0, q).is_err(), "q = {q}");
    }
    for (q, g) in [(0.5, 0.5), (0.1, 0.2), (1.0, 0.5), (0.5, 0.0), (0.5, -0.1), (f64::NAN, 0.1), (0.5, f64::NAN)] {
        let message = Cubic::three_point(5.0, q, g).unwrap_err().to_string();
        assert_eq!(message, format!("levels q = {q} and g = {g} are out of range or order"));
    }
    for k in [0, 1, 3, 16] {
        assert!(Lyon::new(5.0, k).is_err() && CosK::new(5.0, k).is_err(), "k = {k}");
    }
    for n in [0.999, f64::NAN] {
        assert!(Cubic::three_point(n, 0.5, 0.1).is_err() && CubicRational::new(n, 0.5).is_err(), "n = {n}");
        assert!(MinZero::new(n, 0.5).is_err() && Schlick::new(n).is_err() && Lyon::new(n, 2).is_err(), "n = {n}");
        assert!(CosK::new(n, 2).is_err() && Taylor::new(n, TaylorSeries::Chord).is_err(), "n = {n}");
    }
}

proptest! {
    /// The constraint system of the cubic: 1 at x = 1, and value and slope of x^n at t.
    #[test]
    fn the_cubic_touches_the_power(n in 1.5f64..2000.0, q in 0.05f64..0.95) {
        let [a, b, c] = Cubic::new(n, q).unwrap().printed();
        let t = q.powf(1.0 / n);
        let size = a.abs() + b.abs() + c.abs();
        prop_assert!((a + b + c - 1.0).abs() < 1e-13 * size.max(1.0));
        prop_assert!((a * t * t * t + b * t * t + c * t - q).abs() < 1e-13 * size.max(1.0));
        let slope = 3.0 * a * t * t + 2.0 * b * t + c;
        prop_assert!((slope - n * q / t).abs() < 1e-12 * (size + n));
    }

    /// The three-point cubic meets the power at both levels; the rational tail meets it with its slope.
    #[test]
    fn variants_meet_the_power(n in 1.5f64..2000.0, q in 0.3f64..0.95, g in 0.001f64..0.25) {
        let cubic = Cubic::three_point(n, q, g).unwrap();
        for level in [q, g] {
            let u = -libm::expm1(libm::log(level) / n);
            let value = (1.0 - u) * (1.0 - u * (cubic.big_a - cubic.a * u));
            prop_assert!((value - level).abs() < 1e-10, "{value} at the level {level}");
        }
        let min_zero = MinZero::new(n, q).unwrap();
        let tail = CubicRational::new(n, q).unwrap();
        let u = tail.cusp;
        prop_assert!((min_zero.at(u) - q).abs() < 1e-13 && (tail.at(u) - q).abs() < 1e-12);
        prop_assert!((tail.at(u.next_up()) - q).abs() < 1e-12);
        // Both sides' central slope in u is that of x^n, which is -n q / t.
        let (step, slope) = (u * 1e-4, -n * q / (1.0 - u));
        prop_assert!(((tail.at(u + step) - tail.at(u - step)) / (2.0 * step) - slope).abs() < 1e-3 * slope.abs());
        prop_assert!(tail.d + tail.b * u > 0.0);
        // Past the contact it is Schlick's lobe in x/t, times q.
        let t = 1.0 - u;
        for part in [0.0, 0.5, 0.9, 0.999] {
            let schlick = q * Schlick::new(n).unwrap().at(1.0 - part);
            prop_assert!((tail.at(1.0 - part * t) - schlick).abs() < 1e-11);
        }
    }

    #[test]
    fn lobes_stay_inside_the_unit_interval(n in 1.0f64..2000.0, q in 0.05f64..0.95, u in 0.0f64..=1.0) {
        let lobes: Vec<Box<dyn Lobe>> = vec![
            Box::new(Quadratic::new(n).unwrap()),
            Box::new(Cubic::new(n, q).unwrap()),
            Box::new(Cubic::three_point(n, q, q / 9.0).unwrap()),
            Box::new(CubicRational::new(n, q).unwrap()),
            Box::new(MinZero::new(n, q).unwrap()),
            Box::new(Schlick::new(n).unwrap()),
            Box::new(Lyon::new(n, 4).unwrap()),
            Box::new(CosK::new(n, 4).unwrap()),
            Box::new(Taylor::new(n, TaylorSeries::Versine4).unwrap()),
        ];
        for value in lobes.iter().map(|lobe| lobe.at(u)).chain([exact(n, u)]) {
            prop_assert!((0.0..=1.0).contains(&value), "{value}");
        }
    }
}
