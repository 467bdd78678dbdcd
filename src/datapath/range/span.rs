//! Stretches of codes, and those of a memory's fields over stretches of addresses.

use crate::fixed::{Format, Table};

/// The codes from one to another, both included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Span {
    /// The least.
    pub low: i128,
    /// The greatest.
    pub high: i128,
}

impl Span {
    /// One code.
    #[must_use]
    pub const fn point(code: i128) -> Self {
        Self { low: code, high: code }
    }

    /// Every code of a format.
    #[must_use]
    pub const fn of(format: Format) -> Self {
        Self { low: format.min_code(), high: format.max_code() }
    }

    /// The least span that holds both.
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// Whether every code of it is one of the format's.
    #[must_use]
    pub fn fits(self, format: Format) -> bool {
        Self::of(format).holds(self)
    }

    /// Whether all of the other span is in it.
    #[must_use]
    pub fn holds(self, other: Self) -> bool {
        self.low <= other.low && other.high <= self.high
    }

    /// Whether the code is one of it.
    #[must_use]
    pub fn contains(self, code: i128) -> bool {
        self.low <= code && code <= self.high
    }

    /// The larger of the two ends' magnitudes.
    #[must_use]
    pub fn magnitude(self) -> u128 {
        self.low.unsigned_abs().max(self.high.unsigned_abs())
    }

    /// What of it is no greater than a bound that is known to hold; all of it where nothing is, as behind a value that
    /// has left its format.
    pub(super) fn up_to(self, bound: i128) -> Self {
        if bound < self.low { self } else { Self { high: self.high.min(bound), ..self } }
    }

    pub(super) fn map(self, f: impl Fn(i128) -> i128) -> Self {
        Self { low: f(self.low), high: f(self.high) }
    }

    pub(super) fn times(self, other: Self) -> Self {
        let ends = [self.low * other.low, self.low * other.high, self.high * other.low, self.high * other.high];
        let [mut low, mut high] = [ends[0]; 2];
        for end in ends {
            (low, high) = (low.min(end), high.max(end));
        }
        Self { low, high }
    }

    /// Whether it holds one code only.
    #[must_use]
    pub fn is_point(self) -> bool {
        self.low == self.high
    }

    /// How many codes it holds.
    #[must_use]
    pub fn count(self) -> u128 {
        (self.high - self.low) as u128 + 1
    }

    pub(super) fn middle(self) -> i128 {
        self.low + (self.high - self.low) / 2
    }

    /// The integer bits, sign not counted, of the narrowest format that holds it.
    pub(super) fn int_bits(self, frac_bits: i32) -> i32 {
        Format::holding(self.low, self.high, frac_bits).int_bits
    }
}

/// The least and greatest codes of a field over any stretch of addresses.
#[derive(Clone, Debug)]
pub(super) struct Extremes {
    /// A binary tree: `nodes[leaves + i]` is the code at address `i`, `nodes[i]` the hull of `nodes[2 i]` and
    /// `nodes[2 i + 1]`.
    nodes: Vec<Span>,
}

impl Extremes {
    pub(super) fn of(table: &Table, field: usize) -> Self {
        let depth = table.depth();
        let mut nodes = vec![Span::point(0); 2 * depth];
        let texel = table.holds_texels().then(|| Span::of(table.fields[field].format));
        for address in 0..depth {
            nodes[depth + address] = texel.unwrap_or_else(|| Span::point(table.code_at(field, address)));
        }
        for place in (1..depth).rev() {
            nodes[place] = nodes[2 * place].hull(nodes[2 * place + 1]);
        }
        Self { nodes }
    }

    pub(super) fn over(&self, addresses: Span) -> Span {
        let leaves = self.nodes.len() / 2;
        let (mut low, mut high) = (leaves + addresses.low as usize, leaves + addresses.high as usize + 1);
        let mut hull = self.nodes[low];
        while low < high {
            if low % 2 == 1 {
                hull = hull.hull(self.nodes[low]);
                low += 1;
            }
            if high % 2 == 1 {
                high -= 1;
                hull = hull.hull(self.nodes[high]);
            }
            (low, high) = (low / 2, high / 2);
        }
        hull
    }
}
