//! The power `2^(-n L(x))` with less accuracy than the output's last bit, and so with less hardware:
//! [`super::super::datapath`] without the normalisation.
//!
//! With u = 1 - x,
//!
//! `z = n L = n u κ(x)`, `κ(x) = -log2(x) / u`, and `y = 2^-z = 2^-f 2^-i`, `z = i + f`.
//!
//! κ is `log2 e` at x = 1, where a large shininess needs L to be relatively accurate, and smooth there: a table of few
//! constants does. It has a pole at x = 0, but there only the least shininesses give more than 0, and the error counts
//! by `n L 2^(-n L)`. Both tables are of constants, or of lines whose slope has a few bits only, so that the product is
//! a sum of shifts, or of lines with a multiplier; the search over the widths chooses.
//!
//! # The proof
//!
//! As in [`super::super::datapath`], the cases are ranges of the real z; but κ' is not bounded by its entries. It is
//! compared with κ at every code of x, and a case is charged with the codes only that lead into it, for each of the
//! set's first shininesses; for all others together, with every code up to the last that does. n = 1, which reaches the
//! pole, may get x itself by a way of its own.

use std::sync::OnceLock;

use super::super::chords::{Chords, Rises, Slopes};
use super::super::datapath::{EXP_TABLE, LOG_TABLE, exp_chords, power_of_two, times_versine, unless_one};
use super::super::{EXP_ADDRESS, LOG_ADDRESS};
use super::{Memory, ONE};
use crate::datapath::builder::{Bound, Builder, Case, HighBits};
use crate::datapath::graph::NodeId;
use crate::datapath::{Architecture, Datapath, Description, Parameter, multiplier_cost};
use crate::fixed::{Format, Interval, Table, Width, Widths, exp2};
use crate::lobe::Lobe;
use crate::method::exponent::{Exponent, error_of_exponent};
use crate::method::log_exp::log_ratio;
use crate::method::polynomial::datapath as polynomial;
use crate::method::{Interface, width};
use crate::platform::error::Error;
use crate::target::MOST_LOGIC_BITS;

const LOG2_E: f64 = std::f64::consts::LOG2_E;
const LN_2: f64 = std::f64::consts::LN_2;

/// Which of [`LOG_SLOPES`] the logarithm's table has.
const LOG_SLOPE: Width = Width("log_slope");
/// Which of [`EXP_SLOPES`] the exponential's has.
const EXP_SLOPE: Width = Width("exp_slope");

/// The slopes that the logarithm's table may have, the more costly behind: none, a few bits, or enough for a
/// multiplier.
const LOG_SLOPES: [Slopes; 7] = [
    Slopes::None,
    Slopes::Bits { int: 1, frac: 0 },
    Slopes::Bits { int: 2, frac: 0 },
    Slopes::Bits { int: 3, frac: 0 },
    Slopes::Bits { int: 3, frac: 1 },
    Slopes::Bits { int: 6, frac: 2 },
    Slopes::Bits { int: 6, frac: 4 },
];

/// As [`LOG_SLOPES`], for the exponential, whose slope lies between 0.34 and 0.7.
const EXP_SLOPES: [Slopes; 7] = [
    Slopes::None,
    Slopes::Bits { int: 0, frac: 1 },
    Slopes::Bits { int: 0, frac: 2 },
    Slopes::Bits { int: 0, frac: 3 },
    Slopes::Bits { int: 0, frac: 4 },
    Slopes::Bits { int: 0, frac: 5 },
    Slopes::Bits { int: 0, frac: 8 },
];

/// The first shininesses of the set, for which the codes that lead into a case are known one by one.
const SINGLE: usize = 4;

/// `2^(-n L(x))` to a given accuracy.
#[derive(Debug)]
pub struct Coarse<'a> {
    interface: &'a Interface,
    /// A: the error is below `2^-A`.
    accuracy: i32,
    memory: Memory,
    n: Exponent<'a>,
    /// The set's first shininesses, rising, and the next ones.
    first: Vec<f64>,
    /// See [`Self::codes`].
    codes: OnceLock<Vec<[f64; 2]>>,
}

impl<'a> Coarse<'a> {
    /// For an interface of the method `log-exp` with an accuracy of `accuracy` bits.
    ///
    /// # Errors
    /// A shininess that the method refuses.
    pub fn new(interface: &'a Interface, accuracy: u32, memory: Memory) -> Result<Self, Error> {
        let mut first = interface.shininess.values();
        first.sort_by(f64::total_cmp);
        first.dedup();
        // One more where n = 1 goes a way of its own.
        first.truncate(SINGLE + 2);
        Ok(Self {
            interface,
            accuracy: accuracy as i32,
            memory,
            n: Exponent::new(interface)?,
            first,
            codes: OnceLock::new(),
        })
    }

    fn input_bits(&self) -> i32 {
        self.interface.input_fraction as i32
    }

    /// -log2 and the log ratio of every code of x in [0, 1): each of the widths that are tried asks for all of them.
    fn codes(&self) -> &[[f64; 2]] {
        self.codes.get_or_init(|| {
            let codes = 0..1u32 << self.interface.input_fraction;
            let x = |code: u32| f64::from(code) * exp2(-self.input_bits());
            codes.map(|code| [-libm::log2(x(code)), log_ratio(x(code))]).collect()
        })
    }

    /// Both of the code x.
    fn code(&self, x: f64) -> [f64; 2] {
        self.codes()[(x * exp2(self.input_bits())) as usize]
    }

    /// Bits of the integer part of z: the result is 0 from `2^this > A` on.
    fn whole_bits(&self) -> i32 {
        libm::ilogb(f64::from(self.accuracy)) + 1
    }

    /// Integer bits of v = n u: from `v = 2^this` on, z is at least `2^this log2 e`, and the result 0.
    fn versine_int_bits(&self) -> i32 {
        (0..).find(|&bits| exp2(bits) * LOG2_E > f64::from(self.accuracy) + 0.5).unwrap_or_default()
    }

    /// Integer bits of κ: where it is larger, so is L, and even the least shininess gives nothing that counts.
    fn ratio_int_bits(&self, widths: &Widths) -> i32 {
        let most = (f64::from(self.accuracy) + 1.5) / self.served(widths)[0];
        // At x = 1/2 it is 2 already.
        (2..).find(|&bits| exp2(bits) >= most).unwrap_or_default()
    }

    /// Whether n = 1 gets x itself.
    fn bypasses(&self, widths: &Widths) -> bool {
        widths[ONE] == 1
    }

    /// The set's first shininesses that the tables serve.
    fn served<'s>(&'s self, widths: &Widths) -> &'s [f64] {
        &self.first[usize::from(self.bypasses(widths) && self.first.len() > 1)..]
    }

    /// Half an output ulp, where the result is rounded down from more bits than it has: the second table makes up for
    /// that, too.
    fn half_ulp(&self, widths: &Widths) -> f64 {
        let g = self.interface.output_fraction as i32;
        if widths[width::E] > g { exp2(-g - 1) } else { 0.0 }
    }

    /// The logarithm's table; its function is only asked for codes.
    fn log_chords<'f>(
        &self,
        widths: &Widths,
        function: &'f dyn Fn(f64) -> f64,
        weight: &'f dyn Fn(f64) -> f64,
    ) -> Chords<'f> {
        Chords {
            name: LOG_TABLE,
            fields: ["log_base", "log_slope"],
            meanings: ["log ratio at the entry's start", "how steeply the log ratio falls"],
            function,
            curvature: f64::INFINITY,
            start: 0.0,
            domain: 0,
            address_bits: widths[LOG_ADDRESS],
            argument_bits: self.input_bits(),
            cut_bits: widths[width::K] + 2,
            value_bits: widths[width::K],
            int_bits: self.ratio_int_bits(widths),
            slopes: LOG_SLOPES[widths[LOG_SLOPE] as usize],
            weight: Some(weight),
        }
    }

    /// How much a relative error of κ counts at most at x: `n L 2^(-n L) ln 2` at the worst n from `least` on, for an
    /// absolute error of κ.
    fn weight(least: f64) -> impl Fn(f64) -> f64 {
        move |x: f64| {
            let exponent = -libm::log(x) * least;
            let most = if exponent <= 1.0 { libm::exp(-1.0) } else { exponent * libm::exp(-exponent) };
            most / log_ratio(x)
        }
    }

    fn exp_chords<'f>(widths: &Widths, function: &'f dyn Fn(f64) -> f64) -> Chords<'f> {
        exp_chords(widths, EXP_SLOPES[widths[EXP_SLOPE] as usize], function)
    }

    /// An estimate of a table's size in LUTs, for ranking; infinite where the tables may not be as large.
    fn table_cost(&self, chords: &Chords) -> f64 {
        let (word, rows) = (chords.word_bits(), exp2(chords.address_bits));
        let bits = f64::from(word) * rows;
        let memory = if bits <= MOST_LOGIC_BITS as f64 {
            bits / 16.0
        } else {
            // 18 kbit: 512 words of 36 bits, 1024 of 18, 2048 of 9.
            let wide = if rows <= 512.0 { 36 } else { 18 };
            let blocks = f64::from((word + wide - 1) / wide) * (rows / 1024.0).max(1.0);
            match self.memory {
                Memory::Auto => 300.0 * blocks,
                Memory::Logic => f64::INFINITY,
                Memory::Block => 20.0 * blocks,
            }
        };
        memory + chords.interpolation_cost()
    }

    /// The ranges of the real z that the cases of the analysis are: fine where y is large. The last is a point, from
    /// which on the real result is nothing; it stands for every z above it too, as what the hardware makes of a larger
    /// one is less.
    fn levels(&self) -> Vec<Interval> {
        let past = 32 * (1 << self.whole_bits()) + 32;
        let edges: Vec<f64> = (0..=past).filter(|k| *k <= 256 || k % 8 == 0).map(|k| f64::from(k) / 32.0).collect();
        let mut levels: Vec<Interval> = edges.windows(2).map(|edge| Interval::new(edge[0], edge[1])).collect();
        levels.push(Interval::point(edges[edges.len() - 1]));
        levels
    }

    /// For each level, the range of κ'/κ - 1 over the codes of x that lead into it with any shininess that the tables
    /// serve.
    fn ratios(&self, widths: &Widths, errors: &[(f64, f64)], levels: &[Interval]) -> Vec<Interval> {
        let served = self.served(widths);
        // From x = 1 downwards, L rises.
        let relative = |&(x, error): &(f64, f64)| {
            let [log, ratio] = self.code(x);
            (log, Interval::point(error / ratio))
        };
        let codes: Vec<(f64, Interval)> = errors.iter().rev().map(relative).collect();
        let mut hulls = Vec::with_capacity(codes.len());
        let mut hull = Interval::ZERO;
        for &(_, ratio) in &codes {
            hull = hull.hull(ratio);
            hulls.push(hull);
        }
        let up_to = |log: f64| codes.partition_point(|&(of, _)| of <= log);
        let Some((&past, levels)) = levels.split_last() else { return Vec::new() };
        // From here on the hardware's z is at least the least of max(z, n L) κ'/κ.
        let least_past = codes.iter().map(|&(log, ratio)| (log * served[0]).max(past.low) * (1.0 + ratio.low));
        let least_past = least_past.fold(past.low, f64::min);
        levels
            .iter()
            .map(|level| {
                let all_others = served.get(SINGLE).map_or(Interval::ZERO, |&n| {
                    let count = up_to(level.high / n);
                    if count == 0 { Interval::ZERO } else { hulls[count - 1] }
                });
                served.iter().take(SINGLE).fold(all_others, |hull, &n| {
                    let window = codes[..up_to(level.high / n)].iter().rev();
                    window.take_while(|(log, _)| *log >= level.low / n).fold(hull, |hull, &(_, ratio)| hull.hull(ratio))
                })
            })
            .chain([Interval::new(least_past / past.low - 1.0, 0.0)])
            .collect()
    }

    /// 1 at x = 1, which the tables miss by their error, else `y`.
    fn lit_fully(b: &mut Builder, x: NodeId, y: NodeId) -> NodeId {
        let format = b.format(y);
        let Some(top) = b.reaches(x, 0, "top", "x = 1: the result is 1") else { return y };
        let one = b.constant(1 << format.frac_bits, format, "y_one");
        b.select(top, [one, y], |_| None, "y_lit", "y, 1 at x = 1")
    }

    /// The error of `v' κ'` in a case: `κ' (v' - v) + z (κ'/κ - 1)`, v' being off by what u loses, n times, and by its
    /// own rounding.
    fn product_error(&self, widths: &Widths, level: Interval, ratio: Interval) -> Interval {
        let (u, v) = (widths[width::U], widths[width::V]);
        let lost = |from: i32, to: i32| (exp2(-to) - exp2(-from)).max(0.0);
        let of_u = lost(self.input_bits(), u);
        let of_v = lost(self.n.frac_bits(widths) + u.min(self.input_bits()), v);
        // κ where the shininess n gives z: it falls with n, and n κ = z / u rises.
        let log_ratio_at = |z: f64, n: f64| {
            let below = -libm::expm1(-LN_2 * z / n);
            if below > 0.0 { z / n / below } else { LOG2_E }
        };
        let steepest = self.n.largest * log_ratio_at(level.high, self.n.largest);
        let largest = log_ratio_at(level.high, self.served(widths)[0]);
        let rounding = Interval::new(-(steepest * of_u + largest * of_v), 0.0) * (Interval::point(1.0) + ratio);
        rounding + Interval::new(0.0, level.high) * ratio
    }
}

impl Architecture for Coarse<'_> {
    fn tolerance(&self) -> f64 {
        exp2(self.interface.output_fraction as i32 - self.accuracy)
    }

    fn interacting(&self) -> &'static [&'static [Width]] {
        &[&[LOG_ADDRESS, LOG_SLOPE, ONE], &[EXP_ADDRESS, EXP_SLOPE]]
    }

    fn parameters(&self) -> Vec<Parameter> {
        let (f, g, a) = (self.input_bits(), self.interface.output_fraction as i32, self.accuracy);
        let mut parameters = Vec::new();
        let mut n_fraction = self.interface.shininess.frac_bits() as i32;
        if let Some(n) = self.n.parameter(a) {
            n_fraction = *n.range.end();
            parameters.push(n);
        }
        let may_bypass = self.n.least == 1.0 && self.n.largest > 1.0 && self.interface.shininess.frac_bits() == 0;
        let middle = a + self.n.int_bits();
        let u = Parameter::new(width::U, "versine", middle - 1..=middle + 1).up_to(f);
        let v = Parameter::new(width::V, "v = n times the versine", a..=a + 2).up_to(n_fraction + u.range.end());
        let tables = |low: i32, high: i32, cap: i32| low.clamp(2, cap)..=high.clamp(2, cap);
        parameters.extend([
            Parameter::new(
                LOG_ADDRESS,
                "table of the logarithm (bits of its address)",
                tables(a - 5, a + 2, 10.min(f - 1)),
            ),
            Parameter::new(
                LOG_SLOPE,
                "its slopes (0 none, 1 to 4 a few bits, 5 and 6 a multiplier)",
                0..=LOG_SLOPES.len() as i32 - 1,
            ),
            Parameter::new(ONE, "whether n = 1 gives x by a way of its own (1)", 0..=i32::from(may_bypass)),
            Parameter::new(EXP_ADDRESS, "table of the exponential (bits of its address)", tables(a - 5, a + 1, 10)),
            Parameter::new(
                EXP_SLOPE,
                "its slopes (0 none, 1 to 5 a few bits, 6 a multiplier)",
                0..=EXP_SLOPES.len() as i32 - 1,
            ),
            u,
            v,
            Parameter::new(width::K, "log ratio", a..=a + 2),
            Parameter::new(width::Z, "z = n L", a + 1..=a + 3),
            Parameter::new(width::E, "2^-f", a + 1..=a + 4).up_to(g + 2),
        ]);
        parameters
    }

    fn cost(&self, w: &Widths) -> f64 {
        let n_bits = self.n.int_bits() + self.n.frac_bits(w);
        let zero = |f: f64| f;
        multiplier_cost(n_bits, w[width::U])
            + multiplier_cost(self.versine_int_bits() + w[width::V], w[width::K] + self.ratio_int_bits(w))
            + self.table_cost(&self.log_chords(w, &zero, &zero))
            + self.table_cost(&Self::exp_chords(w, &zero))
            // The shifter has a multiplexer a bit and level.
            + 0.7 * f64::from(w[width::E] * self.whole_bits())
            + 0.1 * f64::from(w[width::Z] + w[width::V] + w[width::U])
            + f64::from(w[ONE] * (self.interface.output_fraction as i32 + 8))
    }

    fn tables(&self, widths: &Widths) -> Vec<Table> {
        let mut tables: Vec<Table> = self.n.table(self.n.frac_bits(widths)).into_iter().collect();
        let (lift, half) = (self.n.lift(self.input_bits(), widths), self.half_ulp(widths));
        let weight = Self::weight(self.served(widths)[0]);
        let [log, exp] = match self.interface.monotone {
            true => [Rises::Nowhere, Rises::NowhereAtOctaves],
            false => [Rises::Between; 2],
        };
        tables.push(self.log_chords(widths, &|x| self.code(x)[1], &weight).table(log));
        tables.push(Self::exp_chords(widths, &|f| libm::exp2(-f - lift) + half).table(exp));
        tables
    }

    fn description(&self, tables: &[Table]) -> Description {
        let kind = |name: &str, slope: &str| {
            let Some(table) = tables.iter().find(|table| table.name == name) else { return String::new() };
            let lines = if table.find(slope).is_some() { "lines" } else { "constants" };
            format!("{} {lines}", table.rows())
        };
        Description {
            formula: "y = x^n".to_owned(),
            evaluation: format!(
                "It is evaluated as 2^(-n L) with L = -log2 x, to within 2^-{}: n L = (n u) k, u = 1 - x, where the \
                 log ratio\n\
                 k = L / u comes from a table of {}, and so does 2^-f for the fraction f of n L, from {};\n\
                 the integer part shifts. So n is a number that the core computes with, and the relative accuracy of L \
                 near\n\
                 x = 1 is that of the versine. The result is rounded down; the second table makes up for half of it.",
                self.accuracy,
                kind(LOG_TABLE, "log_slope"),
                kind(EXP_TABLE, "exp_slope"),
            ),
        }
    }

    fn lobes(&self, _tables: &[Table]) -> Vec<Box<dyn Lobe>> {
        let lobe = |n: f64| Box::new(crate::method::log_exp::LogExp { n }) as Box<dyn Lobe>;
        self.interface.shininess.values().into_iter().map(lobe).collect()
    }

    fn build(&self, widths: &Widths, tables: Vec<Table>) -> Option<Datapath> {
        let g = self.interface.output_fraction as i32;
        let memory = |name: &str| tables.iter().position(|table| table.name == name);
        let (log_memory, exp_memory) = (memory(LOG_TABLE)?, memory(EXP_TABLE)?);
        let levels = self.levels();
        let case = Case { active: Interval::UNIT, shininess: self.n.largest, rows: vec![None; tables.len()] };
        let count = levels.len();
        let mut b = Builder::new(&tables, vec![case; levels.len()]);

        let n = self.n.node(&mut b, &tables);
        let (x, u) = b.operand(self.interface);
        let dark = b.reaches(u, 0, "dark", "u = 1: the result is 0");
        let cut = b.floor(u, widths[width::U], "u_cut", "u, rounded down");
        let int_bits = self.versine_int_bits();
        let (v, beyond) = times_versine(&mut b, widths, [n, cut], int_bits, "u");

        let weight = |_: f64| 1.0;
        let function = |x: f64| self.code(x)[1];
        let log = self.log_chords(widths, &function, &weight);
        let ratio = log.look_up(&mut b, log_memory, x, "ratio", "k = -log2(x) / u");
        let product = b.mul(v, ratio, "vk", "v k");
        let ratios = self.ratios(widths, &log.errors(&tables[log_memory]), &levels);
        let errors = (0..count).map(|case| self.product_error(widths, levels[case], ratios[case]));
        let bounds = errors.zip(b.bounds(product)).map(|(error, bound)| Bound { error, ..*bound }).collect();
        b.assume(product, bounds);
        let z = b.floor(product, widths[width::Z], "z", "z = n L, rounded down");
        let whole_bits = self.whole_bits();
        let over = b.reaches(z, whole_bits, "over", "z is past what the result can show");

        let lift = self.n.lift(self.input_bits(), widths);
        let power = |f: f64| libm::exp2(-f - lift);
        let exp = Self::exp_chords(widths, &power);
        let shifted = power_of_two(&mut b, &exp, exp_memory, z, whole_bits, lift, &levels)?;

        let y = b.cast(shifted, Format::unsigned(1, g), HighBits::Unused, "y_cut", "the output's bits");
        let zero = b.any(&[dark, beyond, over], "zero", "the result is 0");
        let mut y = b.zero_if(zero, y, "y", "y, 0 where it is past what the result can show");
        // The flags are up only where the hardware's v or z has reached these.
        let least_forced = (exp2(int_bits) * LOG2_E).min(exp2(whole_bits));
        let forced = |case: usize| {
            let (bound, level, off) = (b.bounds(y)[case], levels[case], b.bounds(z)[case].error);
            let reached = level.high + off.high.max(0.0) >= least_forced;
            let gone = Interval::new(if reached { -libm::exp2(-level.low) } else { 0.0 }, 0.0);
            Bound { error: bound.error.hull(gone), ..bound }
        };
        let bounds = (0..count).map(forced).collect();
        b.assume(y, bounds);
        if self.interface.monotone {
            y = Self::lit_fully(&mut b, x, y);
        }
        if self.bypasses(widths) {
            let rounded = b.cast(x, Format::unsigned(1, g), HighBits::Unused, "x_cut", "x with the output's bits");
            y = unless_one(&mut b, n, y, rounded);
        }
        let relative = self.n.relative_error(&tables);
        polynomial::finish(b, self.interface, &tables, y, |case| error_of_exponent(levels[case], relative))
    }
}
