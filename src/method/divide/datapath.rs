//! Division: one quotient a clock, rounded to nearest.
//!
//! Both dividers take a numerator and a denominator with `0 <= num <= den 2^-most` and `den >= 1`, where 2^-`most`
//! bounds the quotient, and give `num / den` with G fraction bits.
//!
//! - [`Divider::Digit`]: restoring division. With the remainder `r = num 2^most` a step takes `2r - den`; where that is
//!   not negative it becomes the remainder and the digit is 1, else the remainder is 2r and the digit 0. What is
//!   gathered are the *zeros* of the quotient, because `2^-most - zeros` is then the quotient plus half an output ulp,
//!   which rounding to nearest wants: no adder of its own. The digits are those of `floor(num / den)`; for
//!   `num = den 2^-most` all of them are 1, and the rounding makes that exact.
//! - [`Divider::Reciprocal`]: with `den = m 2^e`, m in [1, 2), the quotient is `(num r) 2^-e` with
//!   `r = seed - slope d`, about 1/m, from a table that the leading fraction bits of m address; d is what follows
//!   these. One small multiplication and one of the numerator's width; a Newton step would take two beside the latter.

use crate::datapath::builder::{Bound, Builder, HighBits};
use crate::datapath::graph::{NodeId, Op};
use crate::datapath::{Parameter, multiplier_cost};
use crate::fixed::{Format, Interval, Table, Widths, exp2};
use crate::method::divide::{Divider, INDEX, R, SLOPE};
use crate::method::polynomial::datapath::{field, nearest_code};
use crate::method::width;

/// The name of the memory with the reciprocals.
const RECIPROCALS: &str = "reciprocal";

/// The inner widths of a divider for quotients with `g` fraction bits.
pub(in crate::method) fn parameters(divider: Divider, g: i32) -> Vec<Parameter> {
    match divider {
        Divider::Digit => Vec::new(),
        Divider::Reciprocal => {
            let address = (g / 2 - 1).max(1);
            vec![
                Parameter::new(width::M, "normalised denominator", g + 1..=g + 4),
                Parameter::new(INDEX, "denominator, to address the reciprocals", address..=address + 2),
                Parameter::new(R, "reciprocal", g + 1..=g + 4),
                Parameter::new(SLOPE, "slope of the reciprocal", g / 2..=g / 2 + 4),
            ]
        }
    }
}

/// A rough size in LUTs of a divider for a denominator of `int_bits` integer bits and `frac_bits` fraction bits.
pub(in crate::method) fn cost(
    divider: Divider,
    widths: &Widths,
    g: i32,
    int_bits: i32,
    frac_bits: i32,
    num_bits: i32,
) -> f64 {
    match divider {
        // A digit takes a subtraction and a selection, and registers for remainder, denominator and quotient.
        Divider::Digit => f64::from((g + 1) * (2 * (int_bits + frac_bits) + num_bits / 2)),
        Divider::Reciprocal => {
            let levels = (i32::BITS - int_bits.leading_zeros()) as i32;
            let [m, index, r, slope] = [width::M, INDEX, R, SLOPE].map(|width| widths[width]);
            // A word of a small memory takes LUTs, one of a large memory a part of a block RAM.
            let word = f64::from(r + slope) * exp2(index) / 32.0;
            f64::from(levels * (m + g)) + word + multiplier_cost(slope, m - index) + multiplier_cost(num_bits, r)
        }
    }
}

/// The memory that a divider needs, if any.
pub(in crate::method) fn table(divider: Divider, widths: &Widths) -> Option<Table> {
    (divider == Divider::Reciprocal).then(|| reciprocals(widths))
}

/// What a divider does, for a datasheet.
pub(in crate::method) fn description(divider: Divider) -> &'static str {
    match divider {
        Divider::Digit => {
            "The quotient comes from restoring division, a digit a step: exact, and then rounded to nearest. No \
             multiplier is used\n\
             for it."
        }
        Divider::Reciprocal => {
            "The denominator is normalised to m in [1, 2); 1/m comes from a table of values and slopes, is multiplied \
             by the numerator\n\
             and shifted back. The result is rounded to nearest."
        }
    }
}

/// One entry of the table of reciprocals, for m from `first` to `last`.
struct Entry {
    first: f64,
    last: f64,
    seed_bits: i32,
    slope: f64,
    /// The least and greatest of what rounding `slope d` down adds to r.
    lifted: f64,
    /// The greatest of what rounding the normalised denominator down takes from it.
    cut: f64,
}

impl Entry {
    /// Bounds of `r - 1/m'` over all m' whose rounded-down m lies in the entry.
    fn error(&self, seed: i128) -> Interval {
        let seed = seed as f64 * exp2(-self.seed_bits);
        // Concave: greatest where the slopes are equal, least at an end.
        let off = |m: f64| seed - self.slope * (m - self.first) - 1.0 / m;
        let ends = Interval::point(off(self.first)).hull(Interval::point(off(self.last)));
        let vertex = (1.0 / self.slope).sqrt();
        let top = if (self.first..=self.last).contains(&vertex) { off(vertex) } else { ends.high };
        let cut = self.cut / (self.first * self.first);
        ends.hull(Interval::point(top)) + Interval::new(0.0, self.lifted) + Interval::new(0.0, cut)
    }

    /// The code of the seed that makes the largest error least.
    fn best_seed(&self) -> i128 {
        let worst = |seed: i128| self.error(seed).magnitude();
        let start = nearest_code(1.0 / self.first, self.seed_bits);
        let off = self.error(start);
        let near = start - nearest_code((off.low + off.high) / 2.0, self.seed_bits);
        // r stays below 1, so that it has no integer bit.
        let most = (1i128 << self.seed_bits) - 1;
        let better = |a: i128, b: i128| if worst(b) < worst(a) { b } else { a };
        (near - 1..=near + 1).map(|seed| seed.min(most)).reduce(better).unwrap_or(most)
    }
}

/// The entries, in order, with the codes of their slopes.
fn entries(widths: &Widths) -> impl Iterator<Item = (Entry, i128)> {
    let [m, index, r, slope] = [width::M, INDEX, R, SLOPE].map(|width| widths[width]);
    (0..1 << index).map(move |entry| {
        let first = 1.0 + f64::from(entry) * exp2(-index);
        let last = first + exp2(-index) - exp2(-m);
        let code = nearest_code(1.0 / (first * last), slope);
        let lifted = (exp2(-r) - exp2(-slope - m)).max(0.0);
        let value = code as f64 * exp2(-slope);
        (Entry { first, last, seed_bits: r, slope: value, lifted, cut: exp2(-m) }, code)
    })
}

/// The table of reciprocals: `1/m` is about `seed - slope d`, where d is m less the entry's own.
fn reciprocals(widths: &Widths) -> Table {
    let (mut keys, mut seeds, mut slopes) = (Vec::new(), (Vec::new(), Vec::new()), (Vec::new(), Vec::new()));
    for (entry, slope) in entries(widths) {
        keys.push(entry.first);
        seeds.0.push(entry.best_seed());
        seeds.1.push(1.0 / entry.first);
        slopes.0.push(slope);
        slopes.1.push(1.0 / (entry.first * entry.last));
    }
    let fields = vec![
        field("seed", "about 1/m at the entry's least m", widths[R], seeds.0, seeds.1),
        field("slope", "how fast 1/m falls", widths[SLOPE], slopes.0, slopes.1),
    ];
    Table::listed(RECIPROCALS, "entry", keys, fields)
}

/// Bounds of `r - 1/m` over all denominators, entry by entry.
fn reciprocal_error(table: &Table, widths: &Widths) -> Interval {
    let seeds = &table.field("seed").codes;
    entries(widths)
        .zip(seeds)
        .map(|((entry, _), &seed)| entry.error(seed))
        .reduce(Interval::hull)
        .unwrap_or(Interval::ZERO)
}

impl Builder<'_> {
    /// `num / den`, rounded to nearest to `g` fraction bits, as `UQ1.g`. In every case it must hold that
    /// `0 <= num <= den 2^-most` and `den >= 1`; `memory` is the number of the reciprocals where the divider uses them.
    ///
    /// With `num` and `den` off by `e_n` and `e_d`, their quotient is off by `(e_n - y e_d) / den`, y being the real
    /// quotient; the divider's own error comes on top of that.
    pub(in crate::method) fn divide(
        &mut self,
        divider: Divider,
        widths: &Widths,
        [num, den]: [NodeId; 2],
        g: i32,
        most: i32,
        memory: usize,
    ) -> NodeId {
        let (exact, inverse_error) = match divider {
            Divider::Digit => (self.digits(num, den, g, most), Interval::ZERO),
            Divider::Reciprocal => {
                let error = reciprocal_error(self.table(memory), widths);
                (self.by_reciprocal(widths, [num, den], g, memory), error)
            }
        };
        let half = exp2(-g - 1);
        let bounds = self.per_case(|case| {
            let (num, den) = (self.bounds(num)[case], self.bounds(den)[case]);
            let real = (num.range - num.error).high / (den.range - den.error).low;
            let real = Interval::new(0.0, real.next_up().min(1.0));
            let inverse = Interval::new((1.0 / den.range.high).next_down(), (1.0 / den.range.low).next_up());
            let error = (num.error - real * den.error) * inverse;
            // The reciprocal's error is multiplied by num 2^-e, and that is the quotient times m, which is below 2.
            let quotient = (real.high + error.magnitude()).next_up();
            let weight = (num.range.high * exp2(-libm::ilogb(den.range.low.max(1.0)))).min(2.0 * quotient);
            Bound {
                range: Interval::UNIT,
                error: error + Interval::new(0.0, weight) * inverse_error + Interval::new(-half, half),
                grid: g,
            }
        });
        let y = self.cast(exact, Format::unsigned(1, g), HighBits::Unused, "quotient", "num / den, rounded to nearest");
        self.assume(y, bounds);
        y
    }

    /// A node inside the divider: its bounds are the divider's business, and nothing else uses it.
    fn inner(&mut self, op: Op, args: &[NodeId], format: Format, name: &str, comment: &str) -> NodeId {
        self.push(op, args, format, name, comment.to_owned(), Vec::new())
    }

    /// `min(floor(num / den), 2^-most - 2^-(g+1)) + 2^-(g+1)` with `g + 1` fraction bits, by restoring division.
    fn digits(&mut self, num: NodeId, den: NodeId, g: i32, most: i32) -> NodeId {
        let (whole, den_frac) = (self.format(den).int_bits, self.format(den).frac_bits);
        let from = self.format(num);
        let start = Format { int_bits: from.int_bits + most, frac_bits: from.frac_bits - most, ..from };
        let mut remainder = num;
        if most > 0 {
            remainder = self.inner(Op::Scale, &[num], start, "remainder", "the first remainder");
        }
        let mut zeros = None;
        for digit in most + 1..=g + 1 {
            let from = self.format(remainder);
            let doubled = Format { int_bits: from.int_bits + 1, frac_bits: from.frac_bits - 1, ..from };
            let doubled = self.inner(Op::Scale, &[remainder], doubled, &format!("double_{digit}"), "2 r");
            let frac_bits = self.format(doubled).frac_bits.max(den_frac);
            let trial = Format::signed(whole, frac_bits);
            let trial = self.inner(Op::Sub, &[doubled, den], trial, &format!("trial_{digit}"), "2 r - den");
            let sign = Format::unsigned(whole + 1, -whole);
            let zero = self.inner(Op::Cast, &[trial], sign, &format!("zero_{digit}"), "the digit, inverted: the sign");
            let zero = self.inner(
                Op::Scale,
                &[zero],
                Format::unsigned(1 - digit, digit),
                &format!("weighted_{digit}"),
                "as a number",
            );
            zeros = Some(match zeros {
                None => zero,
                Some(before) => {
                    let format = Format::unsigned(-most, digit);
                    self.inner(
                        Op::Add,
                        &[before, zero],
                        format,
                        &format!("zeros_{digit}"),
                        "the zeros of the quotient so far",
                    )
                }
            });
            if digit > g {
                break;
            }
            let below = self.inner(Op::Cast, &[trial], sign, &format!("below_{digit}"), "2 r < den");
            // The remainder is below den, and at most doubles.
            let rest = Format::unsigned(self.format(doubled).int_bits.min(whole), frac_bits);
            let kept = self.inner(Op::Cast, &[doubled], rest, &format!("kept_{digit}"), "2 r");
            let less = self.inner(Op::Cast, &[trial], rest, &format!("less_{digit}"), "2 r - den");
            remainder = self.inner(Op::Select, &[below, kept, less], rest, &format!("r_{digit}"), "the remainder");
        }
        let zeros = zeros.expect("a quotient has at least one digit");
        let one = self.constant(1, Format::unsigned(1 - most, most), "all");
        let format = Format::unsigned(1 - most, g + 1);
        let y = self.inner(Op::Sub, &[one, zeros], format, "quotient_half", "the quotient plus half an output ulp");
        self.unbounded(y)
    }

    /// `floor(num r 2^-e) + 2^-(g+1)` with `g + 1` fraction bits.
    fn by_reciprocal(&mut self, widths: &Widths, [num, den]: [NodeId; 2], g: i32, memory: usize) -> NodeId {
        let [m_bits, index, r_bits] = [width::M, INDEX, R].map(|width| widths[width]);
        let (m, shifts) = self.normalise_down(den, m_bits);
        let fraction = self.inner(Op::Cast, &[m], Format::unsigned(0, m_bits), "fraction", "m - 1, rounded down");
        let address = self.inner(Op::Cast, &[fraction], Format::unsigned(0, index), "entry", "the entry of the table");
        let [seed, slope] = ["seed", "slope"].map(|name| self.field(memory, address, name));
        let offset = Format::unsigned(-index, m_bits);
        let offset = self.inner(Op::Cast, &[fraction], offset, "offset", "m less the entry's least m");
        let range = Interval::new(0.0, exp2(-index) - exp2(-m_bits));
        let bounds = self.per_case(|_| Bound { range, error: Interval::ZERO, grid: m_bits });
        self.assume(offset, bounds);
        let fall = self.mul(slope, offset, "fall_exact", "slope d");
        let fall = self.floor(fall, r_bits, "fall", "slope d, rounded down");
        let inverse = self.sub(seed, fall, "inverse", "1/m = seed - slope d");
        let product = self.mul(num, inverse, "product", "num / m");
        let mut y = self.inner(Op::Cast, &[product], Format::unsigned(0, g + 1), "scaled", "num / m, rounded down");
        for (flag, shift) in shifts {
            let name = format!("scaled_{shift}");
            // What a shift leaves is rounded down, as one shift by the sum would.
            let format = self.format(y);
            let moved = Format { int_bits: -shift, frac_bits: g + 1 + shift, ..format };
            let moved = self.inner(Op::Scale, &[y], moved, &format!("{name}_moved"), "as often halved");
            let moved = self.inner(Op::Cast, &[moved], format, &format!("{name}_low"), "rounded down");
            y = self.inner(Op::Select, &[flag, moved, y], format, &name, "halved as often as the denominator was");
        }
        let half = self.constant(1, Format::unsigned(-g, g + 1), "half_ulp");
        let y = self.inner(Op::Add, &[y, half], Format::unsigned(1, g + 1), "quotient_half", "plus half an output ulp");
        self.unbounded(y)
    }

    /// `den 2^-e` in [1, 2), rounded down to no fewer than `m_bits` fraction bits, and the flags of the shifts that e
    /// consists of.
    fn normalise_down(&mut self, den: NodeId, m_bits: i32) -> (NodeId, Vec<(NodeId, i32)>) {
        let (mut m, mut shifts) = (den, Vec::new());
        while self.format(m).int_bits > 1 {
            let format = self.format(m);
            // Half of the integer bits, and no power of two less than what remains for the shifts after this one.
            let shift = 1 << (31 - (format.int_bits - 1).leading_zeros());
            let bits = Format::unsigned(format.int_bits, -shift);
            let name = format!("from_{shift}");
            let bits =
                self.inner(Op::Cast, &[m], bits, &format!("{name}_bits"), &format!("the bits from 2^{shift} on"));
            let flag = match self.format(bits).width() {
                1 => bits,
                _ => self.inner(
                    Op::NonZero,
                    &[bits],
                    Format::FLAG,
                    &name,
                    &format!("the denominator is 2^{shift} or more"),
                ),
            };
            let halved = Format { int_bits: format.int_bits - shift, frac_bits: format.frac_bits + shift, ..format };
            // Bits that the last of the shifts would drop are dropped by all.
            let rest = Format::unsigned(shift, halved.frac_bits.min(m_bits));
            let halved = self.inner(Op::Scale, &[m], halved, &format!("m_{shift}_high"), &format!("times 2^-{shift}"));
            let [high, low] = [(halved, "high_wide"), (m, "low_wide")]
                .map(|(id, part)| self.inner(Op::Cast, &[id], rest, &format!("m_{shift}_{part}"), "in one format"));
            m = self.inner(Op::Select, &[flag, high, low], rest, &format!("m_{shift}"), &format!("below 2^{shift}"));
            shifts.push((flag, shift));
        }
        (m, shifts)
    }

    /// A node whose bounds the caller states after the next operation.
    fn unbounded(&mut self, id: NodeId) -> NodeId {
        let format = self.format(id);
        let bound = Bound { range: Interval::UNIT, error: Interval::ZERO, grid: format.frac_bits };
        let bounds = self.per_case(|_| bound);
        self.assume(id, bounds);
        id
    }
}
