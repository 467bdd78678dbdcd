//! Exact fixed-point arithmetic with explicit quantisation, on the crate `fixed`.
//!
//! The formats of a core are known at run time only, and a Rust type fixes its format at compile
//! time. So the model computes in one wide type and quantises where the hardware does. A product of
//! two [`Wide`] numbers is the exact one rounded towards minus infinity at the 64th fraction bit; as the
//! hardware's quantisations are of the same direction at fewer bits, that first rounding changes nothing.

use fixed::types::I64F64;

/// 64 integer bits (sign included) and 64 fraction bits.
pub type Wide = I64F64;

/// The number `code * 2^-frac_bits`; `frac_bits` from 0 to 64.
#[must_use]
pub fn from_code(code: i128, frac_bits: u32) -> Wide {
    Wide::from_bits(code << (64 - frac_bits))
}

/// Rounds towards minus infinity to `frac_bits` fraction bits.
#[must_use]
pub fn floor_to(value: Wide, frac_bits: u32) -> Wide {
    let dropped = 64 - frac_bits;
    Wide::from_bits((value.to_bits() >> dropped) << dropped)
}

/// The code of `value` in a format with `frac_bits` fraction bits, rounded towards minus infinity.
#[must_use]
pub fn to_code(value: Wide, frac_bits: u32) -> i128 {
    value.to_bits() >> (64 - frac_bits)
}
