//! How many fraction bits a form's values need, measured.
//!
//! Every value of a form is computed with the same number of fraction bits, rounded down, coefficients rounded to
//! nearest: the least number with which the result stays within `2^-G` of the polynomial is what the form needs. The
//! cosine has 30 fraction bits, so that its own rounding has no part in it.

use serde::Serialize;

use crate::fixed::exp2;
use crate::lobe::Lobe;
use crate::method::cubic::Cubic;
use crate::method::quadratic::Quadratic;
use crate::platform::error::Error;

/// Fraction bits of the cosine.
const INPUT_BITS: i32 = 30;
/// Inputs over which a form is measured, evenly from u = 0 to where the polynomial ends.
const SAMPLES: i128 = 4096;
/// The most bits that are tried.
const MOST_BITS: i32 = 62;

/// What a shininess asks of the forms.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Conditioning {
    /// The shininess.
    pub shininess: f64,
    /// The polynomial's degree: 2 or 3.
    pub degree: u32,
    /// The largest sum of the printed terms' magnitudes over the result's, where the result is at least 1/2.
    pub condition: f64,
    /// Fraction bits for an error of `2^-12` and of `2^-16`, of the printed form; `None` if 62 are too few.
    pub printed_bits: [Option<i32>; 2],
    /// The same of the form that is built.
    pub built_bits: [Option<i32>; 2],
}

/// The final errors that are asked for, as exponents.
const TARGETS: [i32; 2] = [12, 16];

/// A polynomial `x (1 - u (A - a u))`; `A` is the quadratic's a where a is 0.
#[derive(Clone, Copy, Debug)]
struct Shape {
    big_a: f64,
    a: f64,
    end: f64,
    degree: u32,
}

/// Both polynomials at these shininesses.
///
/// # Errors
/// A shininess that a method refuses.
pub fn measure(shininesses: &[f64]) -> Result<Vec<Conditioning>, Error> {
    let mut all = Vec::new();
    for &n in shininesses {
        let quadratic = Quadratic::new(n)?;
        let ends = if quadratic.a > 1.0 { 1.0 / quadratic.a } else { 1.0 };
        all.push(of(n, Shape { big_a: quadratic.a, a: 0.0, end: ends, degree: 2 }, &quadratic));
        let cubic = Cubic::new(n, 0.5)?;
        all.push(of(n, Shape { big_a: cubic.big_a, a: cubic.a, end: cubic.cut().unwrap_or(1.0), degree: 3 }, &cubic));
    }
    Ok(all)
}

fn of(shininess: f64, shape: Shape, lobe: &dyn Lobe) -> Conditioning {
    let last = libm::floor(shape.end * exp2(INPUT_BITS)) as i128;
    let mut versines: Vec<i128> = (0..=SAMPLES).map(|place| place * last / SAMPLES).collect();
    versines.dedup();
    let real: Vec<f64> = versines.iter().map(|&u| lobe.at(u as f64 * exp2(-INPUT_BITS))).collect();
    let bits = |form: &dyn Fn(i128, i32) -> i128, target: i32| {
        (1..=MOST_BITS).find(|&bits| {
            let near = |(&u, &real): (&i128, &f64)| (form(u, bits) as f64 * exp2(-bits) - real).abs() <= exp2(-target);
            versines.iter().zip(&real).all(near)
        })
    };
    let condition = versines.iter().zip(&real).filter(|&(_, &real)| real >= 0.5).map(|(&u, &real)| {
        let x = 1.0 - u as f64 * exp2(-INPUT_BITS);
        let terms: f64 =
            shape.printed().iter().enumerate().map(|(power, c)| (c * libm::pow(x, power as f64 + 1.0)).abs()).sum();
        terms / real
    });
    Conditioning {
        shininess,
        degree: shape.degree,
        condition: condition.fold(1.0, f64::max),
        printed_bits: TARGETS.map(|target| bits(&|u, bits| shape.evaluate_printed(u, bits), target)),
        built_bits: TARGETS.map(|target| bits(&|u, bits| shape.evaluate_built(u, bits), target)),
    }
}

/// A code with other fraction bits, rounded down.
fn floor(code: i128, from: i32, to: i32) -> i128 {
    if to >= from { code << (to - from) } else { code >> (from - to) }
}

fn nearest(value: f64, bits: i32) -> i128 {
    libm::round(value * exp2(bits)) as i128
}

impl Shape {
    /// The coefficients of x, x^2 and x^3.
    fn printed(&self) -> [f64; 3] {
        match self.degree {
            2 => [1.0 - self.big_a, self.big_a, 0.0],
            _ => [1.0 - self.big_a + self.a, self.big_a - 2.0 * self.a, self.a],
        }
    }

    /// The sum of the powers of x, each value with `bits` fraction bits.
    fn evaluate_printed(&self, u: i128, bits: i32) -> i128 {
        let x = (1 << INPUT_BITS) - u;
        let square = floor(x * x, 2 * INPUT_BITS, bits);
        let cube = floor(square * x, bits + INPUT_BITS, bits);
        let [c, b, a] = self.printed().map(|value| nearest(value, bits));
        let term =
            |coefficient: i128, power: i128, power_bits: i32| floor(coefficient * power, bits + power_bits, bits);
        term(c, x, INPUT_BITS) + term(b, square, bits) + term(a, cube, bits)
    }

    /// `x - x p`, `p = v (A 2^-k - a 4^-k v)` with `v = u 2^k`, each value with `bits` fraction bits.
    fn evaluate_built(&self, u: i128, bits: i32) -> i128 {
        let k = (libm::ilogb(self.big_a.abs().max(1.0)) + 1).max(0);
        let x = (1 << INPUT_BITS) - u;
        let v = floor(u << k, INPUT_BITS, bits);
        let a = nearest(self.a * exp2(-2 * k), bits);
        let q = nearest(self.big_a * exp2(-k), bits) - floor(a * v, 2 * bits, bits);
        let p = floor(v * q, 2 * bits, bits);
        floor(x, INPUT_BITS, bits) - floor(x * p, INPUT_BITS + bits, bits)
    }
}
