//! What the polynomial lobes share: rounding coefficients, and the way from p to `x (1 - p)`.

use super::builder::Builder;
use super::graph::NodeId;
use super::{CaseError, Datapath, Description};
use crate::number::{Format, Interval, exp2};
use crate::rom::{Field, Table};
use crate::spec::{CoreSpec, Widths};

/// The nearest integer code of `value` at `frac_bits` fraction bits, halves away from zero.
pub(super) fn nearest_code(value: f64, frac_bits: i32) -> i128 {
    libm::round(value * exp2(frac_bits)) as i128
}

/// A ROM field in the narrowest format that holds all codes.
pub(super) fn field(
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

/// The scaling of each row by `2^k`: what all rows share is wired, the rest is a ROM field and a shifter.
#[derive(Clone, Debug)]
pub(super) struct Scaling {
    /// k of each row.
    pub k: Vec<i32>,
}

impl Scaling {
    /// `k = floor(log2 c) + 1` for each leading coefficient c, and at least 0: then `c 2^-k` lies in [1/2, 1) for c of at
    /// least 1/2, also after rounding to `frac_bits`, and `v = u 2^k` below 2 wherever `c u < 1`.
    pub fn of(leading: impl Iterator<Item = f64>, frac_bits: i32) -> Self {
        let exponent = |c: f64| {
            let k = if c == 0.0 { 0 } else { (libm::ilogb(c.abs()) + 1).max(0) };
            k + i32::from(nearest_code(c.abs() * exp2(-k), frac_bits) >= 1 << frac_bits)
        };
        Self { k: leading.map(exponent).collect() }
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
pub(super) fn stable_description(formula: &str, spec: &CoreSpec, tables: &[Table]) -> Description {
    let wired = match tables[0].shared_shift {
        0 => String::new(),
        shift => format!(" ({shift} of k is wired, the rest is the ROM's field k)"),
    };
    let rounding = if spec.input_fraction > spec.output_fraction {
        "The result is rounded to nearest."
    } else {
        "The result is rounded down; the datapath's own roundings lift it about as much."
    };
    Description {
        formula: formula.to_owned(),
        evaluation: format!(
            "It is evaluated in the scaled versine v = u 2^k, k chosen for each shininess so that the leading coefficient times 2^-k\n\
             lies in [1/2, 1){wired}. So every operand of a multiplication is of the order of one, and few bits suffice.\n\
             {rounding}"
        ),
    }
}

/// `end` or the largest versine below 1, whichever is less. At u = 1 the cosine is 0, and so is the result, whatever p is: no
/// format needs to hold what is computed there.
pub(super) fn below_one(spec: &CoreSpec, end: f64) -> f64 {
    end.min(1.0 - exp2(-(spec.input_fraction as i32)))
}

/// From the exact p to the output: `x (1 - p)` with p cut to `UQ0.p`, 0 where `zero` or `p >= 1`.
pub(super) fn output_of_p(
    b: &mut Builder,
    spec: &CoreSpec,
    widths: &Widths,
    x: NodeId,
    p_exact: NodeId,
    zero: Option<NodeId>,
) -> NodeId {
    let g = spec.output_fraction as i32;
    let x = b.floor(x, widths.get("x"), "x_cut", "x, rounded down");
    // With an input coarser than the output's ulp the floors of p and t lift the result about as much as the last floor
    // lowers it; a finer input gains no lift, and the result is rounded to nearest.
    let half = (spec.input_fraction > spec.output_fraction).then(|| b.half_ulp(g));
    if b.format(p_exact).signed {
        // A coefficient is negative, as it is for n below 2: p may be below 0 or above 1, and so may the result.
        let p = b.floor(p_exact, widths.get("p"), "p", "p, rounded down");
        let y = b.complement(x, p, widths.get("t"), half, "y_exact");
        let y = b.floor(y, g, "y_cut", "rounded down to the output's bits");
        let y = pad(b, y, g);
        let y = b.clamp_to_unit(y, "y_unit", "taken into [0, 1]");
        return b.zero_if(zero, y, "y", "y, 0 past the cut");
    }
    let above = b.reaches(p_exact, 0, "p_above", "the integer bits of p: the lobe is 0 from p = 1 on");
    let p = b.cast(p_exact, Format::unsigned(0, widths.get("p")), true, "p", "p, rounded down");
    let zero = b.any(&[zero, above], "zero", "the result is 0");
    let y = b.complement(x, p, widths.get("t"), half, "y_exact");
    let y = b.cast(y, Format::unsigned(1, g), false, "y_cut", "rounded down to the output's bits");
    b.zero_if(zero, y, "y", "y, 0 where the lobe has ended")
}

/// `a` with at least `frac_bits` fraction bits.
pub(super) fn pad(b: &mut Builder, a: NodeId, frac_bits: i32) -> NodeId {
    let format = b.format(a);
    if format.frac_bits >= frac_bits {
        return a;
    }
    b.cast(a, Format { frac_bits, ..format }, false, "y_padded", "with zeros")
}

/// The finished datapath; `coefficients` bounds, case by case, what rounding the coefficients adds to the result.
pub(super) fn finish(
    b: Builder,
    spec: &CoreSpec,
    tables: &[Table],
    output: NodeId,
    coefficients: impl Fn(usize) -> Interval,
) -> Option<Datapath> {
    let ulps = spec.output_fraction as i32;
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
    Some(Datapath { graph: b.finish(&[("out_spec", output)])?, tables: tables.to_vec(), errors })
}
