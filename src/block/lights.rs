//! The lights of a sample, clock by clock.
//!
//! Of a core that takes lights in sequence comes at every clock what the lights of that clock give: a sum a channel
//! that is not yet rounded to a code, and kept at 1.0, above which every code is full scale. A sequencer around the
//! core adds these sums up until the sample's last, and rounds once. Nothing that is added is negative, so that a sum
//! which is kept at 1.0 at every step ends where one does that is kept there at its end.

use std::ops::RangeInclusive;

use clap::ValueEnum;
use serde::{Deserialize, Serialize};

/// Lights of a sample that roundings may be sized for.
pub const MOST_LIGHTS: RangeInclusive<u32> = 1..=1024;
/// Lights of a sample that roundings are sized for, unless it is said otherwise.
pub const DEFAULT_MOST_LIGHTS: u32 = 64;

/// Where the lights of a sample come from that are taken in sequence.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum LightSource {
    /// From ports, a clock's at once.
    #[default]
    Port,
    /// From a table in the core that is written through a port.
    Table,
    /// From a table in the core that holds what the spec gives.
    Rom,
}

/// What comes out of a core that takes lights in sequence: `out_sum_r`, `out_sum_g` and `out_sum_b`, UQ1 with these
/// fraction bits, and where there is ambient light `out_ambient_r`, `out_ambient_g` and `out_ambient_b` behind them,
/// which go into the sum of a sample once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sums {
    /// Fraction bits of the sums.
    pub frac_bits: u32,
    /// Fraction bits of the ambient light, not more than those of the sums.
    pub ambient: Option<u32>,
    /// Bits of a channel's code, fewer than the sums have behind the point.
    pub channel_bits: u32,
}

impl Sums {
    /// The fraction bits of terms that are rounded down, so many in a sample: their roundings together stay below an
    /// eighth of a code.
    pub(super) fn term_bits(channel_bits: u32, terms: u32) -> i32 {
        channel_bits as i32 + 3 + libm::ilogb(f64::from(2 * terms - 1))
    }

    /// The codes of the channels of a sample from what the core gives at each of its clocks, the first one's ambient
    /// light included.
    #[must_use]
    pub fn codes<'a>(&self, clocks: impl IntoIterator<Item = &'a [i64]>) -> Vec<i64> {
        let mut totals = [0; 3];
        for (clock, outputs) in clocks.into_iter().enumerate() {
            for (channel, total) in totals.iter_mut().enumerate() {
                *total += outputs[channel];
                if let (0, Some(bits)) = (clock, self.ambient) {
                    *total += outputs[3 + channel] << (self.frac_bits - bits);
                }
            }
        }
        let code = |total: i64| (total + self.half_code()) >> (self.frac_bits - self.channel_bits);
        totals.map(|total| code(total).min(self.full_scale())).to_vec()
    }

    /// Half a code, in units of a sum's last bit.
    #[must_use]
    pub fn half_code(&self) -> i64 {
        1 << (self.frac_bits - self.channel_bits - 1)
    }

    /// The greatest code of a channel.
    #[must_use]
    pub fn full_scale(&self) -> i64 {
        (1 << self.channel_bits) - 1
    }
}
