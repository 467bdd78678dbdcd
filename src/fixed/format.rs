//! Fixed-point formats.

use std::fmt;

use serde::Serialize;

/// A fixed-point format, written `UQi.f` (unsigned) or `Qi.f` (two's complement).
///
/// `i` integer bits (the sign is not counted) and `f` fraction bits: an unsigned value is
/// `code * 2^-f` with `0 <= code < 2^(i+f)`; a signed one has `-2^(i+f) <= code < 2^(i+f)`.
/// Either count may be negative as long as the width is at least one bit: `UQ-1.19` holds values
/// below one half in 18 bits, `UQ3.-1` the even integers below eight in two bits.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Serialize)]
pub struct Format {
    /// Two's complement if true.
    pub signed: bool,
    /// Bits of weight one and above, the sign not counted.
    pub int_bits: i32,
    /// Bits of weight below one.
    pub frac_bits: i32,
}

impl Format {
    /// One bit that is 0 or 1.
    pub const FLAG: Self = Self::unsigned(1, 0);

    /// `UQi.f`.
    #[must_use]
    pub const fn unsigned(int_bits: i32, frac_bits: i32) -> Self {
        Self { signed: false, int_bits, frac_bits }
    }

    /// `Qi.f`.
    #[must_use]
    pub const fn signed(int_bits: i32, frac_bits: i32) -> Self {
        Self { signed: true, int_bits, frac_bits }
    }

    /// The format of the exact product of numbers of two formats of one signedness. That of two most negative ones
    /// needs one bit more than the counts add up to.
    #[must_use]
    pub const fn product([a, b]: [Self; 2]) -> Self {
        Self {
            signed: a.signed,
            int_bits: a.int_bits + b.int_bits + a.signed as i32,
            frac_bits: a.frac_bits + b.frac_bits,
        }
    }

    /// The number of bits, the sign included; 0 where the counts leave none.
    #[must_use]
    pub const fn width(self) -> u32 {
        let bits = self.int_bits + self.frac_bits + self.signed as i32;
        if bits < 0 { 0 } else { bits as u32 }
    }

    /// The smallest code; of a format that is too wide for this crate the smallest number there is.
    #[must_use]
    pub const fn min_code(self) -> i128 {
        if self.signed { -ones(self.int_bits + self.frac_bits) - 1 } else { 0 }
    }

    /// The largest code; of a format that is too wide for this crate the largest number there is.
    #[must_use]
    pub const fn max_code(self) -> i128 {
        ones(self.int_bits + self.frac_bits)
    }

    /// The weight of the last bit.
    #[must_use]
    pub fn lsb(self) -> f64 {
        super::exp2(-self.frac_bits)
    }

    /// The real value of a code.
    #[must_use]
    pub fn value(self, code: i128) -> f64 {
        code as f64 * self.lsb()
    }

    /// Takes any integer to the code that hardware of this width keeps of it (modulo `2^width`).
    #[must_use]
    pub const fn wrap(self, code: i128) -> i128 {
        if self.width() > 127 {
            return code;
        }
        let low = code & ones(self.width() as i32);
        // Of 127 bits the weight of the next one is no number of this type, but the difference is.
        if self.signed && low > self.max_code() { low.wrapping_sub(1 << self.width()) } else { low }
    }

    /// The bit pattern of a code, as an unsigned integer of [`Format::width`] bits.
    #[must_use]
    pub const fn bits(self, code: i128) -> u128 {
        if self.width() > 127 { code as u128 } else { (code & ones(self.width() as i32)) as u128 }
    }

    /// The smallest format with the given fraction bits that holds every code from `low` to `high`.
    #[must_use]
    pub fn holding(low: i128, high: i128, frac_bits: i32) -> Self {
        debug_assert!(low <= high);
        let magnitude = |code: i128| (128 - if code < 0 { !code } else { code }.leading_zeros()) as i32;
        let bits = magnitude(low).max(magnitude(high)).max(1);
        Self { signed: low < 0, int_bits: bits - frac_bits, frac_bits }
    }
}

/// A number of so many bits that are all 1: 0 of none, and the largest number there is of 127 or more. Values that turn
/// out too wide are refused once the whole datapath is known.
const fn ones(bits: i32) -> i128 {
    match bits {
        ..=0 => 0,
        1..=126 => (1 << bits) - 1,
        _ => i128::MAX,
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}Q{}.{}", if self.signed { "" } else { "U" }, self.int_bits, self.frac_bits)
    }
}
