//! What the polynomial lobes share: rounding coefficients, and the way from p to `x (1 - p)`.

use crate::datapath::builder::{Builder, Case, HighBits};
use crate::datapath::graph::NodeId;
use crate::datapath::{CaseError, Datapath, Description};
use crate::fixed::{Field, Format, Interval, Table, Widths, exp2};
use crate::method::{Interface, Shininess, width};

/// The nearest integer code of `value` at `frac_bits` fraction bits, halves away from zero.
pub(crate) fn nearest_code(value: f64, frac_bits: i32) -> i128 {
    libm::round(value * exp2(frac_bits)) as i128
}

/// A ROM field in the narrowest format that holds all codes.
pub(crate) fn field(
    name: &'static str,
    meaning: &'static str,
    frac_bits: i32,
    codes: Vec<i128>,
    reals: Vec<f64>,
) -> Field {
    let low = codes.iter().copied().min().unwrap_or(0);
    let high = codes.iter().copied().max().unwrap_or(0);
    Field { name, meaning, format: Format::holding(low, high, frac_bits), codes, reals }
}

/// The ROM field of the codes nearest to these numbers.
pub(crate) fn rounded_field(name: &'static str, meaning: &'static str, frac_bits: i32, reals: Vec<f64>) -> Field {
    let codes = reals.iter().map(|&real| nearest_code(real, frac_bits)).collect();
    field(name, meaning, frac_bits, codes, reals)
}

/// The fields of A: at a row, and the step to the next.
pub(in crate::method) const BIG_A: [&str; 2] = ["big_a", "big_a_step"];
/// The fields of a, likewise.
pub(in crate::method) const SMALL_A: [&str; 2] = ["a", "a_step"];

/// A coefficient over a row of the ROM: of a fixed-point range, `base + f step` with f from 0 to below 1 on the way to
/// the next row; else step is 0.
#[derive(Clone, Copy, Debug)]
pub(in crate::method) struct Line {
    pub base: f64,
    pub step: f64,
}

impl Line {
    /// The lines between the values at the rows.
    pub fn through(interface: &Interface, values: &[f64]) -> Vec<Self> {
        let step = |row: usize| match interface.shininess {
            Shininess::Fixed { .. } if row + 1 < values.len() => values[row + 1] - values[row],
            _ => 0.0,
        };
        values.iter().enumerate().map(|(row, &base)| Self { base, step: step(row) }).collect()
    }

    /// The values at both ends, and so all between them.
    pub fn range(self) -> Interval {
        Interval::point(self.base).hull(Interval::point(self.base + self.step))
    }

    fn scale(self, exponent: i32) -> Self {
        Self { base: self.base * exp2(exponent), step: self.step * exp2(exponent) }
    }
}

/// A scaled coefficient as fields of the ROM: its value at the row, and where it is interpolated its step to the next.
pub(in crate::method) fn line_fields(
    interface: &Interface,
    [name, step_name]: [&'static str; 2],
    [meaning, step_meaning]: [&'static str; 2],
    frac_bits: i32,
    lines: &[Line],
) -> Vec<Field> {
    let mut fields = vec![rounded_field(name, meaning, frac_bits, lines.iter().map(|line| line.base).collect())];
    if matches!(interface.shininess, Shininess::Fixed { .. }) {
        fields.push(rounded_field(step_name, step_meaning, frac_bits, lines.iter().map(|line| line.step).collect()));
    }
    fields
}

/// A scaled coefficient of a row before and after it was rounded to words.
pub(in crate::method) fn lines_of(table: &Table, [name, step]: [&'static str; 2], row: usize) -> [Line; 2] {
    let of = |value: &dyn Fn(&Field) -> f64| {
        let column = |name: &str| table.find(name).map_or(0.0, value);
        Line { base: column(name), step: column(step) }
    };
    [of(&|field| field.reals[row]), of(&|field| field.value(row))]
}

/// What rounding added to a scaled coefficient over a row.
pub(in crate::method) fn delta_line(table: &Table, names: [&'static str; 2], row: usize) -> Line {
    let [real, word] = lines_of(table, names, row);
    Line { base: word.base - real.base, step: word.step - real.step }
}

/// The range of [`delta_line`].
pub(in crate::method) fn delta(table: &Table, names: [&'static str; 2], row: usize) -> Interval {
    delta_line(table, names, row).range()
}

/// k of a row.
pub(in crate::method) fn shift_of(table: &Table, row: usize) -> i32 {
    let own = table.find("k").map_or(0, |field| field.codes[row]);
    own as i32 + table.shared_shift as i32
}

/// The real coefficient of each shininess of the set, in order, unscaled: `power` times k is undone.
pub(in crate::method) fn real_coefficients(
    interface: &Interface,
    table: &Table,
    names: [&'static str; 2],
    power: i32,
) -> Vec<f64> {
    let of = |index: usize| {
        let (row, fraction) = interface.shininess.knot(index);
        let [line, _] = lines_of(table, names, row);
        let line = line.scale(power * shift_of(table, row));
        line.base + fraction * line.step
    };
    (0..interface.shininess.rows()).map(of).collect()
}

/// The port `in_n` as the address of the memory `memory` and, of a fixed-point range, the fraction on the way to the
/// next row.
pub(in crate::method) fn address(b: &mut Builder, interface: &Interface, memory: usize) -> (NodeId, Option<NodeId>) {
    let Shininess::Fixed { frac_bits, .. } = interface.shininess else {
        return (b.address(&interface.shininess, memory), None);
    };
    let (address, fraction) = b.split_index(&interface.shininess, frac_bits as i32, memory);
    (address, Some(fraction))
}

/// A coefficient in the graph: a field of the ROM, or `base + f step` rounded down to the field's bits.
pub(in crate::method) fn coefficient(
    b: &mut Builder,
    (address, fraction): (NodeId, Option<NodeId>),
    [name, step]: [&'static str; 2],
) -> NodeId {
    let base = b.field(0, address, name);
    let Some(fraction) = fraction else { return base };
    let step = b.field(0, address, step);
    let frac_bits = b.format(base).frac_bits;
    let product = b.mul(fraction, step, &format!("f_{name}"), "the fraction of n times the step");
    let product = b.floor(product, frac_bits, &format!("f_{name}_cut"), "rounded down");
    b.add(base, product, &format!("{name}_between"), "the coefficient between two rows")
}

/// Where the polynomial of each row is left: the last versine that it serves, in the ROM's field `cut`.
#[derive(Clone, Debug)]
pub(in crate::method) struct Ends {
    codes: Vec<i128>,
    reals: Vec<f64>,
    /// The largest code below 1, for a row that is never left: only u = 1 is greater, and there the result is 0 anyway.
    most: i128,
}

impl Ends {
    /// From each row's real end, if it has one.
    pub fn of(interface: &Interface, ends: impl Iterator<Item = Option<f64>>) -> Self {
        let one = exp2(interface.input_fraction as i32);
        let reals: Vec<f64> = ends.map(|end| end.unwrap_or(1.0)).collect();
        let codes = reals.iter().map(|end| libm::floor(end * one).min(one - 1.0) as i128).collect();
        Self { codes, reals, most: one as i128 - 1 }
    }

    /// The ROM's field; `None` where no row is left before u = 1.
    pub fn field(self, interface: &Interface) -> Option<Field> {
        let any = self.codes.iter().any(|&code| code < self.most);
        let meaning = "the largest versine of the polynomial";
        any.then(|| field("cut", meaning, interface.input_fraction as i32, self.codes, self.reals))
    }

    /// The ends as the words hold them, as versines below 1.
    pub fn in_codes(&self) -> Vec<f64> {
        self.codes.iter().map(|&code| code as f64 / (self.most + 1) as f64).collect()
    }

    /// The ends that a table's words hold, as versines below 1.
    pub fn in_words(interface: &Interface, table: &Table) -> Vec<f64> {
        let lsb = exp2(-(interface.input_fraction as i32));
        match table.find("cut") {
            Some(field) => field.codes.iter().map(|&code| code as f64 * lsb).collect(),
            None => vec![1.0 - lsb; table.rows()],
        }
    }

    /// The real ends of a table: 1 where there is none.
    pub fn in_reals(table: &Table) -> Vec<f64> {
        table.find("cut").map_or(vec![1.0; table.rows()], |cut| cut.reals.clone())
    }

    /// The flag for versines past the end, or `None` where the table has no such field.
    pub fn flag(b: &mut Builder, interface: &Interface, table: &Table, address: NodeId, u: NodeId) -> Option<NodeId> {
        table.find("cut").is_some().then(|| {
            debug_assert_eq!(b.format(u).frac_bits, interface.input_fraction as i32);
            let cut = b.field(0, address, "cut");
            b.greater(u, cut, "past_cut", "u > cut: past the polynomial's end")
        })
    }

    /// The integer bits that a versine scaled by `2^k` needs up to the ends.
    pub fn int_bits(ends: &[f64], k: &[i32]) -> i32 {
        libm::ilogb(ends.iter().zip(k).map(|(end, &k)| end * exp2(k)).fold(1.0, f64::max)) + 1
    }
}

/// The scaling of each row by `2^k`: what all rows share is wired, the rest is a ROM field and a shifter.
#[derive(Clone, Debug)]
pub(in crate::method) struct Scaling {
    /// k of each row.
    pub k: Vec<i32>,
}

impl Scaling {
    /// `k = floor(log2 c) + 1` for each leading coefficient c, and at least 0: then `c 2^-k` lies in [1/2, 1) for c of
    /// at least 1/2, also after rounding to `frac_bits`, and `v = u 2^k` below 2 wherever `c u < 1`.
    pub fn of(leading: impl Iterator<Item = f64>, frac_bits: i32) -> Self {
        let exponent = |c: f64| {
            let k = if c == 0.0 { 0 } else { (libm::ilogb(c.abs()) + 1).max(0) };
            k + i32::from(nearest_code(c.abs() * exp2(-k), frac_bits) >= 1 << frac_bits)
        };
        Self { k: leading.map(exponent).collect() }
    }

    /// The shifts of the cases, by the row of the first memory that each reads.
    pub fn over_cases(&self, cases: &[Case]) -> Self {
        Self { k: cases.iter().map(|case| self.k[case.rows[0].unwrap_or(0)]).collect() }
    }

    /// Coefficients over the rows, times `2^-(power k)`.
    pub fn lines(&self, lines: &[Line], power: i32) -> Vec<Line> {
        lines.iter().zip(&self.k).map(|(line, &k)| line.scale(-power * k)).collect()
    }

    /// The shift that all rows share.
    pub fn base(&self) -> i32 {
        self.k.iter().copied().min().unwrap_or(0)
    }

    /// The largest shift.
    pub fn most(&self) -> i32 {
        self.k.iter().copied().max().unwrap_or(0)
    }

    /// The ROM field for what the rows do not share.
    pub fn field(&self) -> Option<Field> {
        let codes: Vec<i128> = self.k.iter().map(|k| i128::from(k - self.base())).collect();
        let reals = self.k.iter().map(|&k| f64::from(k - self.base())).collect();
        (self.base() < self.most()).then(|| field("k", "shift of the versine", 0, codes, reals))
    }

    /// `u 2^k` in the graph.
    pub fn apply(&self, b: &mut Builder, address: NodeId, u: NodeId) -> NodeId {
        let amount = (self.base() < self.most()).then(|| b.field(0, address, "k"));
        let comment = match amount {
            Some(_) if self.base() > 0 => format!("u 2^(k + {})", self.base()),
            Some(_) => "u 2^k".to_owned(),
            None => format!("u 2^{}", self.base()),
        };
        b.scale(u, amount, self.base(), &self.k, "u_scaled", &comment)
    }
}

/// The formula, and how the stable form evaluates it.
pub(in crate::method) fn stable_description(formula: &str, interface: &Interface, tables: &[Table]) -> Description {
    let wired = match tables[0].shared_shift {
        0 => String::new(),
        shift => format!(" ({shift} of k is wired, the rest is the ROM's field k)"),
    };
    let rounding = if interface.input_fraction > interface.output_fraction {
        "The result is rounded to nearest."
    } else {
        "The result is rounded down; the datapath's own roundings lift it about as much."
    };
    Description {
        formula: formula.to_owned(),
        evaluation: format!(
            "It is evaluated in the scaled versine v = u 2^k, k chosen for each shininess so that the leading \
             coefficient times 2^-k\n\
             lies in [1/2, 1){wired}. So every operand of a multiplication is of the order of one, and few bits \
             suffice.\n\
             {rounding}"
        ),
    }
}

/// `end` or the largest versine below 1, whichever is less. At u = 1 the cosine is 0, and so is the result, whatever p
/// is: no format needs to hold what is computed there.
pub(in crate::method) fn below_one(interface: &Interface, end: f64) -> f64 {
    end.min(1.0 - exp2(-(interface.input_fraction as i32)))
}

/// The range of `v (big - small v)` over an interval of v.
pub(in crate::method) fn parabola(big: f64, small: f64, v: Interval) -> Interval {
    let at = |v: f64| Interval::point(v * (big - small * v));
    let vertex = big / (2.0 * small);
    let ends = at(v.low).hull(at(v.high));
    if v.low < vertex && vertex < v.high { ends.hull(at(vertex)) } else { ends }
}

/// 0 at x = 0, where a surface faces away, else `y`.
pub(in crate::method) fn lit(b: &mut Builder, u: NodeId, y: NodeId) -> NodeId {
    let dark = b.reaches(u, 0, "dark", "u = 1: the surface faces away");
    b.zero_if(dark, y, "y_lit", "y, 0 where the surface faces away")
}

/// From the exact p to the output: `x (1 - p)` with p cut to `UQ0.p`, 0 where `zero` or `p >= 1`.
pub(in crate::method) fn output_of_p(
    b: &mut Builder,
    interface: &Interface,
    widths: &Widths,
    x: NodeId,
    p_exact: NodeId,
    zero: Option<NodeId>,
) -> NodeId {
    let g = interface.output_fraction as i32;
    let x = b.floor(x, widths[width::X], "x_cut", "x, rounded down");
    // With an input coarser than the output's ulp the floors of p and t lift the result about as much as the last floor
    // lowers it; a finer input gains no lift, and the result is rounded to nearest.
    let half = (interface.input_fraction > interface.output_fraction).then(|| b.half_ulp(g));
    if b.format(p_exact).signed {
        // A coefficient is negative, as it is for n below 2: p may be below 0 or above 1, and so may the result.
        let p = b.floor(p_exact, widths[width::P], "p", "p, rounded down");
        let y = b.complement(x, p, widths[width::T], half, "y_exact");
        let y = b.floor(y, g, "y_cut", "rounded down to the output's bits");
        let y = pad(b, y, g);
        let y = b.clamp_to_unit(y, "y_unit", "taken into [0, 1]");
        return b.zero_if(zero, y, "y", "y, 0 past the cut");
    }
    let above = b.reaches(p_exact, 0, "p_above", "the integer bits of p: the lobe is 0 from p = 1 on");
    let p = b.cast(p_exact, Format::unsigned(0, widths[width::P]), HighBits::Guarded, "p", "p, rounded down");
    let zero = b.any(&[zero, above], "zero", "the result is 0");
    let y = b.complement(x, p, widths[width::T], half, "y_exact");
    let y = b.cast(y, Format::unsigned(1, g), HighBits::Unused, "y_cut", "rounded down to the output's bits");
    b.zero_if(zero, y, "y", "y, 0 where the lobe has ended")
}

/// `a` with at least `frac_bits` fraction bits.
pub(in crate::method) fn pad(b: &mut Builder, a: NodeId, frac_bits: i32) -> NodeId {
    let format = b.format(a);
    if format.frac_bits >= frac_bits {
        return a;
    }
    b.cast(a, Format { frac_bits, ..format }, HighBits::Unused, "y_padded", "with zeros")
}

/// The finished datapath; `coefficients` bounds, case by case, what rounding the coefficients adds to the result.
pub(in crate::method) fn finish(
    b: Builder,
    interface: &Interface,
    tables: &[Table],
    output: NodeId,
    coefficients: impl Fn(usize) -> Interval,
) -> Option<Datapath> {
    let ulps = interface.output_fraction as i32;
    let errors = b
        .bounds(output)
        .iter()
        .zip(b.cases())
        .enumerate()
        .map(|(case, (bound, of))| CaseError {
            shininess: of.shininess,
            coefficients: coefficients(case).scale(ulps),
            arithmetic: bound.error.scale(ulps),
        })
        .collect();
    Some(Datapath {
        graph: b.finish(&[("out_spec", output)], [])?,
        tables: tables.to_vec(),
        constants: Vec::new(),
        errors,
    })
}
