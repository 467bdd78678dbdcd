//! Sine and cosine of angles in integers alone, with one table: what a driver without floating point computes, bit for
//! bit.
//!
//! An angle is a number of 2^-64 turns, which wraps as 64 bits do; a sine is a number of 2^-62. The nearest of the
//! table's steps of a 256th of a turn is left by at most 0.0123 rad, whose sine and cosine are the first terms of their
//! series: the terms that are left out are below 2^-47.

use std::f64::consts::FRAC_PI_2;
use std::sync::LazyLock;

use super::exp2;

/// Fraction bits of sines.
pub const FRACTION: u32 = 62;
/// 1.0.
pub const ONE: u64 = 1 << FRACTION;
/// Half a turn.
pub const HALF: u64 = 1 << 63;
/// Steps of the table in a quarter turn.
const STEPS: usize = 64;
/// Bits of an angle below a step.
pub const STEP_BITS: u32 = 56;
/// Fraction bits of [`HALF_PI`].
pub const HALF_PI_BITS: u32 = 60;

/// The sine of every step from 0 to a quarter turn.
pub static SINES: LazyLock<[u64; STEPS + 1]> = LazyLock::new(|| {
    let sine = |step: usize| libm::sin(step as f64 / STEPS as f64 * FRAC_PI_2) * exp2(FRACTION as i32);
    std::array::from_fn(|step| if step == STEPS { ONE } else { sine(step) as u64 })
});

/// π/2, rounded down to [`HALF_PI_BITS`]: what 2^-64 turns are multiplied by for 2^-62 rad.
pub const HALF_PI: u64 = (FRAC_PI_2 * (1u64 << HALF_PI_BITS) as f64) as u64;

/// a b 2^-bits, rounded down; it must fit.
#[must_use]
pub fn product(a: u64, b: u64, bits: u32) -> u64 {
    ((u128::from(a) * u128::from(b)) >> bits) as u64
}

/// The product of two sines, rounded towards 0.
#[must_use]
pub fn times(a: i64, b: i64) -> i64 {
    let magnitude = product(a.unsigned_abs(), b.unsigned_abs(), FRACTION) as i64;
    if (a < 0) == (b < 0) { magnitude } else { -magnitude }
}

/// Sine and cosine of an angle, exact at multiples of a quarter turn.
#[must_use]
pub fn sine_cosine(angle: u64) -> [i64; 2] {
    let part = angle & (ONE - 1);
    let step = (part + (1 << (STEP_BITS - 1))) >> STEP_BITS;
    let at = step << STEP_BITS;
    let is_past = part >= at;
    let x = product(if is_past { part - at } else { at - part }, HALF_PI, HALF_PI_BITS);
    let square = product(x, x, FRACTION);
    let cube = product(square, x, FRACTION);
    let sine = x - cube / 6 + product(cube, square, FRACTION) / 120;
    let cosine = ONE - square / 2 + product(square, square, FRACTION) / 24;
    let [of_step, across] = [SINES[step as usize], SINES[STEPS - step as usize]];
    let [along, aside] = [product(of_step, sine, FRACTION), product(across, sine, FRACTION)];
    let [s, c] = [product(of_step, cosine, FRACTION), product(across, cosine, FRACTION)];
    let [s, c] = if is_past { [s + aside, c - along] } else { [s - aside, c + along] }.map(|value| value as i64);
    match angle >> FRACTION {
        0 => [s, c],
        1 => [c, -s],
        2 => [-s, -c],
        _ => [-c, s],
    }
}

/// The code of a sine with so many fraction bits: the nearest, halves away from 0.
#[must_use]
pub fn code(sine: i64, frac_bits: u32) -> i64 {
    let dropped = FRACTION - frac_bits;
    let magnitude = ((sine.unsigned_abs() + (1 << (dropped - 1))) >> dropped) as i64;
    if sine < 0 { -magnitude } else { magnitude }
}

/// An angle in degrees, which may be any finite number, to 2^-53 of itself.
#[must_use]
pub fn of_degrees(degrees: f64) -> u64 {
    let turns = (degrees % 360.0).abs() / 360.0;
    let angle = (turns * exp2(64)) as u64;
    if degrees < 0.0 { angle.wrapping_neg() } else { angle }
}
