//! The coefficients against high precision and against the systems of equations that define them.

use astro_float::{BigFloat, Consts, RoundingMode};
use brdfgen::lobe::{Cubic, Lobe, Quadratic, exact};
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
}

fn relative(got: f64, expected: f64) -> f64 {
    if got == expected { 0.0 } else { ((got - expected) / expected).abs() }
}

/// `tests/data/coefficients.csv`: n = 1..=1000 at Q = 1/2, computed at 50 digits.
#[test]
fn coefficients_agree_with_the_stored_table() {
    let mut rows = 0;
    for line in include_str!("data/coefficients.csv").lines().skip(1) {
        let values: Vec<f64> = line.split(',').map(|v| v.parse().expect("a number")).collect();
        let (quadratic, cubic) = (Quadratic::new(values[0]).unwrap(), Cubic::new(values[0], 0.5).unwrap());
        assert!(relative(quadratic.a, values[1]) < 1e-13, "a({}) = {}", values[0], quadratic.a);
        assert!(relative(cubic.a, values[2]) < 1e-13, "cubic a({}) = {}", values[0], cubic.a);
        assert!(relative(cubic.big_a, values[3]) < 1e-13, "cubic A({}) = {}", values[0], cubic.big_a);
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

    #[test]
    fn lobes_stay_inside_the_unit_interval(n in 1.0f64..2000.0, q in 0.05f64..0.95, u in 0.0f64..=1.0) {
        for value in [Quadratic::new(n).unwrap().at(u), Cubic::new(n, q).unwrap().at(u), exact(n, u)] {
            prop_assert!((0.0..=1.0).contains(&value), "{value}");
        }
    }
}
