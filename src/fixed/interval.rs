//! Closed intervals of reals with outward rounding.

use std::ops::{Add, Mul, Neg, Sub};

/// `[low, high]`. Every operation rounds outwards, so that the result holds the exact one.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Interval {
    /// The lower end.
    pub low: f64,
    /// The upper end.
    pub high: f64,
}

impl Interval {
    /// `[0, 0]`.
    pub const ZERO: Self = Self { low: 0.0, high: 0.0 };
    /// `[0, 1]`.
    pub const UNIT: Self = Self { low: 0.0, high: 1.0 };

    /// `[low, high]`; the ends must be ordered.
    #[must_use]
    pub fn new(low: f64, high: f64) -> Self {
        debug_assert!(low <= high, "[{low}, {high}]");
        Self { low, high }
    }

    /// `[value, value]`.
    #[must_use]
    pub fn point(value: f64) -> Self {
        Self { low: value, high: value }
    }

    /// The smallest interval that holds both.
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The part inside `[low, high]`; an interval wholly outside becomes the nearer end.
    #[must_use]
    pub fn clip(self, low: f64, high: f64) -> Self {
        Self { low: self.low.clamp(low, high), high: self.high.clamp(low, high) }
    }

    /// Times `2^exponent`, exactly.
    #[must_use]
    pub fn scale(self, exponent: i32) -> Self {
        let factor = super::exp2(exponent);
        Self { low: self.low * factor, high: self.high * factor }
    }

    /// The largest magnitude.
    #[must_use]
    pub fn magnitude(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    // An exact zero stays one: it stands for "no error", and most sums in an analysis add one.
    fn outward(low: f64, high: f64) -> Self {
        let down = |v: f64| if v == 0.0 { v } else { v.next_down() };
        let up = |v: f64| if v == 0.0 { v } else { v.next_up() };
        Self { low: down(low), high: up(high) }
    }
}

impl Add for Interval {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        if self == Self::ZERO {
            return other;
        }
        if other == Self::ZERO {
            return self;
        }
        Self::outward(self.low + other.low, self.high + other.high)
    }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        if self == Self::ZERO || other == Self::ZERO {
            return Self::ZERO;
        }
        let products = [self.low * other.low, self.low * other.high, self.high * other.low, self.high * other.high];
        Self::outward(
            products.iter().copied().fold(f64::INFINITY, f64::min),
            products.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        )
    }
}
