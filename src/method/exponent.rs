//! The shininess as a number that a core computes with: from the port, or from a ROM where the port is an index; and
//! what an error of the exponent does to a power of two.

use crate::datapath::Parameter;
use crate::datapath::builder::Builder;
use crate::datapath::graph::NodeId;
use crate::fixed::{Interval, Table, Widths, exp2};
use crate::lobe;
use crate::method::polynomial::datapath::rounded_field;
use crate::method::{Interface, Shininess, width};
use crate::platform::error::Error;

const LN_2: f64 = std::f64::consts::LN_2;

/// More fraction bits than this no shininess needs: the error that is left counts 2^-25 at most.
const MOST_FRACTION_BITS: i32 = 24;

/// Fraction bits that hold every shininess of a list exactly, if [`MOST_FRACTION_BITS`] do, and else those; 0 for a
/// range.
pub(in crate::method) fn exact_bits(set: &Shininess) -> i32 {
    if set.is_at_port() {
        return 0;
    }
    let exact = |n: f64, bits: i32| libm::trunc(n * exp2(bits)) == n * exp2(bits);
    let needed = |n: f64| (0..MOST_FRACTION_BITS).find(|&bits| exact(n, bits)).unwrap_or(MOST_FRACTION_BITS);
    set.values().into_iter().map(needed).max().unwrap_or_default()
}

/// The exponent n.
#[derive(Debug)]
pub(in crate::method) struct Exponent<'a> {
    set: &'a Shininess,
    /// The least n of the set.
    pub least: f64,
    /// The largest n of the set.
    pub largest: f64,
    /// Fraction bits that hold every shininess of a list exactly, if [`MOST_FRACTION_BITS`] do.
    exact_bits: i32,
}

impl<'a> Exponent<'a> {
    /// The shininesses of an interface.
    ///
    /// # Errors
    /// A shininess that the methods refuse.
    pub fn new(interface: &'a Interface) -> Result<Self, Error> {
        let (least, largest) = interface.shininess.ends();
        lobe::check_shininess(least)?;
        lobe::check_shininess(largest)?;
        Ok(Self { set: &interface.shininess, least, largest, exact_bits: exact_bits(&interface.shininess) })
    }

    /// Whether n is read from a ROM: the port is an index.
    pub fn is_read(&self) -> bool {
        !self.set.is_at_port()
    }

    /// Integer bits of n.
    pub fn int_bits(&self) -> i32 {
        libm::ilogb(self.largest) + 1
    }

    /// Fraction bits of n.
    pub fn frac_bits(&self, widths: &Widths) -> i32 {
        if self.is_read() { widths[width::N] } else { self.set.frac_bits() as i32 }
    }

    /// The width of n in its ROM, for a result with `precision` fraction bits.
    pub fn parameter(&self, precision: i32) -> Option<Parameter> {
        let low = (precision - libm::ilogb(self.least)).max(0);
        self.is_read().then(|| Parameter::new(width::N, "shininess n", low..=low + 4).up_to(self.exact_bits))
    }

    /// The ROM of n with these fraction bits, if n is read from one.
    pub fn table(&self, bits: i32) -> Option<Table> {
        let field = || rounded_field("n", "the shininess", bits, self.set.values());
        self.is_read().then(|| self.set.rom(vec![field()], 0))
    }

    /// n as a number.
    pub fn node(&self, b: &mut Builder, tables: &[Table]) -> NodeId {
        if self.is_read() {
            let memory = tables.iter().position(|table| table.name == Table::COEFFICIENTS).unwrap_or_default();
            let address = b.address(self.set, memory);
            return b.field(memory, address, "n");
        }
        let port = b.index(self.set);
        b.clamped_index(self.set, port)
    }

    /// Half of the most that rounding u, v and z down lowers z by where the result is near 1, u having `input_bits`
    /// before: the exponential's table makes up for it.
    pub fn lift(&self, input_bits: i32, widths: &Widths) -> f64 {
        let (u, v, z) = (widths[width::U], widths[width::V], widths[width::Z]);
        let lost = |from: i32, to: i32| (exp2(-to) - exp2(-from)).max(0.0);
        let of_v = self.largest * lost(input_bits, u) + lost(self.frac_bits(widths) + u, v);
        0.5 * (std::f64::consts::LOG2_E * of_v + lost(v + widths[width::K], z))
    }

    /// The range of `(n' - n) / n'` over the set, n' being what the ROM has in place of n.
    pub fn relative_error(&self, tables: &[Table]) -> Interval {
        let Some(table) = tables.iter().find(|table| table.name == Table::COEFFICIENTS) else { return Interval::ZERO };
        let n = table.field("n");
        let ratio = |row| Interval::point(n.rounding(row) / n.value(row));
        (0..table.rows()).map(ratio).reduce(Interval::hull).unwrap_or(Interval::ZERO)
    }
}

/// What such a relative error of n does to `2^-z`, z in `level`: with n' in place of n, the real z is
/// `z - z (n' - n)/n'`, so that `y' - y = y' (1 - 2^(z (n' - n)/n'))`.
pub(in crate::method) fn error_of_exponent(level: Interval, relative: Interval) -> Interval {
    if relative == Interval::ZERO {
        return Interval::ZERO;
    }
    let real = Interval::new(libm::exp2(-level.high), libm::exp2(-level.low));
    -(real * power_less_one(-(level * relative)))
}

/// `2^-[a] - 1` over an interval.
pub(in crate::method) fn power_less_one(exponent: Interval) -> Interval {
    let at = |z: f64| libm::expm1(-LN_2 * z);
    Interval::new(at(exponent.high), at(exponent.low))
}
