//! A function table with linear interpolation, fitted to its quantised words.

use super::builder::{Bound, Builder};
use super::graph::NodeId;
use super::polynomial::{field, nearest_code};
use crate::number::{Format, Interval, exp2};
use crate::rom::Table;

/// Entries with no more arguments than this are analysed at each of them.
const FEW: i64 = 16;
/// With more, at this many pieces, and the curvature bounds what lies between.
const PIECES: i64 = 8;

/// A convex falling function over `[start, start + 2^-domain)` as `base - slope d` in `2^address_bits` equal entries, d being the
/// distance from the entry's start.
pub(super) struct Chords<'f> {
    /// The memory's name.
    pub name: &'static str,
    /// The names of its fields.
    pub fields: [&'static str; 2],
    /// What they hold.
    pub meanings: [&'static str; 2],
    /// The function.
    pub function: &'f dyn Fn(f64) -> f64,
    /// A bound of its second derivative.
    pub curvature: f64,
    /// The first argument.
    pub start: f64,
    /// The arguments span `2^-domain`.
    pub domain: i32,
    /// The number of entries is `2^address_bits`.
    pub address_bits: i32,
    /// Fraction bits of the argument.
    pub argument_bits: i32,
    /// Fraction bits of the argument that enter the product.
    pub cut_bits: i32,
    /// Fraction bits of the value, to which the product is rounded down.
    pub value_bits: i32,
    /// Every base is below `2^int_bits`.
    pub int_bits: i32,
}

impl Chords<'_> {
    /// An entry spans `2^-this`.
    fn step_bits(&self) -> i32 {
        self.domain + self.address_bits
    }

    /// An error of the slope counts `2^-step_bits` times at most.
    fn slope_bits(&self) -> i32 {
        self.value_bits - self.step_bits() + 1
    }

    fn cut_bits(&self) -> i32 {
        self.cut_bits.min(self.argument_bits)
    }

    fn first(&self, entry: usize) -> f64 {
        self.start + entry as f64 * exp2(-self.step_bits())
    }

    /// From an entry's first argument to its last; 0 where it has only one, or none.
    fn span(&self) -> f64 {
        (exp2(-self.step_bits()) - exp2(-self.argument_bits)).max(0.0)
    }

    /// The range of `-slope d`, as the hardware computes it, minus the function over an entry.
    fn shape(&self, entry: usize, slope_code: i128) -> Interval {
        let first = self.first(entry);
        let slope = slope_code as f64 * exp2(-self.slope_bits());
        // Of more entries than arguments, some serve none.
        let spare_bits = (self.argument_bits - self.step_bits()).max(0);
        let hull = |values: &mut dyn Iterator<Item = f64>| {
            values.map(Interval::point).reduce(Interval::hull).unwrap_or(Interval::ZERO)
        };
        if 1i64 << spare_bits.min(32) <= FEW {
            let value = |code: i128| {
                let product = slope_code * (code >> (self.argument_bits - self.cut_bits()));
                let dropped = self.slope_bits() + self.cut_bits() - self.value_bits;
                let product = if dropped > 0 { product >> dropped } else { product << -dropped };
                let d = code as f64 * exp2(-self.argument_bits);
                -(product as f64) * exp2(-self.value_bits) - (self.function)(first + d)
            };
            return hull(&mut (0..1i128 << spare_bits).map(value));
        }
        let piece = self.span() / PIECES as f64;
        let value = |step: i64| -slope * (step as f64 * piece) - (self.function)(first + step as f64 * piece);
        // It is concave, so that it is least at an end, and between two samples above neither by more than this.
        let bulge = self.curvature * piece * piece / 8.0;
        let cut = slope * (exp2(-self.cut_bits()) - exp2(-self.argument_bits));
        let floor = (exp2(-self.value_bits) - exp2(-self.slope_bits() - self.cut_bits())).max(0.0);
        hull(&mut (0..=PIECES).map(value)) + Interval::new(0.0, bulge + cut + floor)
    }

    /// The table: the slope of the chord, and the base that balances the error.
    pub fn table(&self) -> Table {
        let entries = 1usize << self.address_bits;
        let (mut bases, mut slopes) = ((Vec::new(), Vec::new()), (Vec::new(), Vec::new()));
        let most = (1i128 << (self.int_bits + self.value_bits)) - 1;
        for entry in 0..entries {
            let first = self.first(entry);
            let span = self.span();
            let slope = if span > 0.0 { ((self.function)(first) - (self.function)(first + span)) / span } else { 0.0 };
            let slope_code = nearest_code(slope, self.slope_bits());
            let shape = self.shape(entry, slope_code);
            let base = -0.5 * (shape.low + shape.high);
            slopes.0.push(slope_code);
            slopes.1.push(slope);
            bases.0.push(nearest_code(base, self.value_bits).min(most));
            bases.1.push(base);
        }
        let fields = vec![
            field(self.fields[0], self.meanings[0], self.value_bits, bases.0, bases.1),
            field(self.fields[1], self.meanings[1], self.slope_bits(), slopes.0, slopes.1),
        ];
        Table::listed(self.name, "entry", (0..entries).map(|entry| entry as f64).collect(), fields)
    }

    /// The range of the hardware's value minus the function's over an entry, with the words that the table has.
    pub fn error(&self, table: &Table, entry: usize) -> Interval {
        let [base, slope] = self.fields.map(|name| table.field(name));
        self.shape(entry, slope.codes[entry]) + Interval::point(base.format.value(base.codes[entry]))
    }

    /// The least value of the function over an entry.
    pub fn least(&self, entry: usize) -> f64 {
        (self.function)(self.first(entry) + self.span())
    }

    /// The value at `argument`, whose bits of the weights below `2^-domain` say where in the table it lies.
    pub fn look_up(&self, b: &mut Builder, memory: usize, argument: NodeId, value: &str, formula: &str) -> NodeId {
        let name = |part: &str| format!("{value}_{part}");
        let count = b.cases().len();
        let entry = Format::unsigned(-self.domain, self.step_bits());
        let entry = b.cast(argument, entry, true, &name("high"), "the bits that select the entry");
        let shift = self.step_bits();
        let address = b.scale(entry, None, shift, &vec![shift; count], &name("entry"), "the address in the table");
        let base = b.field(memory, address, self.fields[0]);
        let slope = b.field(memory, address, self.fields[1]);
        let d = Format::unsigned(-self.step_bits(), self.cut_bits());
        let d = b.cast(argument, d, true, &name("d"), "the distance from the entry's start");
        let whole = Bound {
            range: Interval::new(0.0, b.format(d).value(b.format(d).max_code())),
            error: Interval::ZERO,
            grid: self.cut_bits(),
        };
        b.assume(d, vec![whole; count]);
        let product = b.mul(slope, d, &name("fall"), "how far the value has fallen from the entry's start");
        let product = b.floor(product, self.value_bits, &name("step"), "rounded down");
        b.sub(base, product, value, formula)
    }

    /// An estimate of its size in LUTs, for ranking.
    pub fn cost(&self) -> f64 {
        let slope = self.value_bits - self.address_bits;
        let bits = f64::from(self.value_bits + slope) * exp2(self.address_bits);
        bits / 16.0 + super::multiplier_cost(slope, self.cut_bits() - self.step_bits()) + f64::from(self.value_bits)
    }
}
