//! Builds a graph and bounds every value's range and error, row by row.
//!
//! The analysis is an abstract interpretation with intervals. For every ROM row it follows, next to
//! the range of each hardware value, the interval of its *error*: the hardware value minus the real value
//! that the formula with the quantised coefficients has there. Sums add errors, a product obeys
//! `a'b' - ab = a (b' - b) + b' (a' - a)`, and dropping bits adds `[-(2^-f - 2^-g), 0]`, where `g` is the number
//! of fraction bits that the value really has in this row. The inputs range over the row's *active*
//! interval only, the versines from 0 to where the lobe is 0 for good; past it a flag forces the result to 0,
//! and values there may wrap.

use super::graph::{Graph, Node, NodeId, Op};
use crate::number::{Format, Interval};
use crate::rom::Table;
use crate::spec::{CoreSpec, Operand, Shininess};

/// What is known of a value in one row.
#[derive(Clone, Copy, Debug)]
pub struct Bound {
    /// The hardware value.
    pub range: Interval,
    /// Hardware minus real.
    pub error: Interval,
    /// The value is a multiple of `2^-grid`.
    pub grid: i32,
}

/// No value of a graph is wider than this, so that products of two fit the 128-bit arithmetic here.
const MAX_BITS: i32 = 126;

/// What rounding a multiple of `2^-grid` down to `frac_bits` fraction bits adds to it.
fn floor_loss(grid: i32, frac_bits: i32) -> Interval {
    if grid <= frac_bits {
        return Interval::ZERO;
    }
    Interval::new(crate::number::exp2(-grid) - crate::number::exp2(-frac_bits), 0.0)
}

/// A graph under construction.
#[derive(Debug)]
pub struct Builder<'a> {
    table: &'a Table,
    nodes: Vec<Node>,
    bounds: Vec<Vec<Bound>>,
    fits: bool,
}

impl<'a> Builder<'a> {
    /// An empty graph over the rows of `table`.
    #[must_use]
    pub fn new(table: &'a Table) -> Self {
        Self { table, nodes: Vec::new(), bounds: Vec::new(), fits: true }
    }

    /// The format of a node.
    #[must_use]
    pub fn format(&self, id: NodeId) -> Format {
        self.nodes[id].format
    }

    /// The bounds of a node, one a row.
    #[must_use]
    pub fn bounds(&self, id: NodeId) -> &[Bound] {
        &self.bounds[id]
    }

    /// The finished graph, or `None` if a value left its format.
    #[must_use]
    pub fn finish(self, output: NodeId) -> Option<Graph> {
        self.fits.then_some(Graph { nodes: self.nodes, output })
    }

    fn push(
        &mut self,
        op: Op,
        args: &[NodeId],
        format: Format,
        name: &str,
        comment: String,
        bounds: Vec<Bound>,
    ) -> NodeId {
        self.fits &= (1..=MAX_BITS).contains(&(format.int_bits + format.frac_bits));
        self.nodes.push(Node { op, args: args.to_vec(), format, name: name.to_owned(), comment });
        self.bounds.push(bounds);
        self.nodes.len() - 1
    }

    fn per_row(&self, bound: impl Fn(usize) -> Bound) -> Vec<Bound> {
        (0..self.table.rows()).map(bound).collect()
    }

    /// The narrowest format with these fraction bits that holds the ranges of all rows.
    fn holding(&mut self, bounds: &[Bound], frac_bits: i32) -> Format {
        let low = bounds.iter().map(|b| b.range.low).fold(f64::INFINITY, f64::min);
        let high = bounds.iter().map(|b| b.range.high).fold(f64::NEG_INFINITY, f64::max);
        let scale = crate::number::exp2(frac_bits);
        if low.abs().max(high.abs()) * scale > crate::number::exp2(MAX_BITS) {
            self.fits = false;
            return Format::unsigned(1, frac_bits);
        }
        // Values are multiples of the last bit's weight: the ends round inwards.
        let (low, high) = ((low * scale).ceil() as i128, (high * scale).floor() as i128);
        Format::holding(low, high.max(low), frac_bits)
    }

    /// The ports, taken into the domain: the cosine x and the versine u, both `UQ1.F`, u of each row from 0 to
    /// `active` of the row. Returns `(x, u)`.
    pub fn inputs(&mut self, spec: &CoreSpec, active: &[f64]) -> (NodeId, NodeId) {
        let f = spec.input_fraction as i32;
        let one = 1i128 << f;
        let unit = Format::unsigned(1, f);
        let versine =
            self.per_row(|row| Bound { range: Interval::new(0.0, active[row]), error: Interval::ZERO, grid: f });
        let cosine =
            self.per_row(|row| Bound { range: Interval::new(1.0 - active[row], 1.0), error: Interval::ZERO, grid: f });
        let clamp = Op::Clamp { low: 0, high: one };
        match spec.operand {
            Operand::Cos => {
                let port = self.push(Op::Operand, &[], Format::signed(1, f), "in_cos", String::new(), cosine.clone());
                let comment = "x = in_cos taken into [0, 1]: back-facing gives 0".to_owned();
                let x = self.push(clamp, &[port], unit, "x", comment, cosine);
                let one = self.constant(one, unit, "one");
                let u = self.push(Op::Sub, &[one, x], unit, "u", "u = 1 - x, the versine".to_owned(), versine);
                (x, u)
            }
            Operand::Versine => {
                let port = self.push(Op::Operand, &[], unit, "in_ver", String::new(), versine.clone());
                let comment = "u = in_ver taken into [0, 1]: back-facing gives u = 1".to_owned();
                let u = self.push(clamp, &[port], unit, "u", comment, versine);
                let one = self.constant(one, unit, "one");
                let x = self.push(Op::Sub, &[one, u], unit, "x", "x = 1 - u, the cosine".to_owned(), cosine);
                (x, u)
            }
        }
    }

    /// The ROM's address, from the port `in_n`.
    pub fn address(&mut self, set: &Shininess) -> NodeId {
        let index_format = Format::unsigned(set.index_bits() as i32, 0);
        let bound = |low: u32, high: u32| Bound {
            range: Interval::new(f64::from(low), f64::from(high)),
            error: Interval::ZERO,
            grid: 0,
        };
        let (first, last) = (set.index_of_row(0), set.index_of_row(set.rows() - 1));
        let all = vec![bound(first, last); self.table.rows()];
        let port = self.push(Op::Index, &[], index_format, "in_n", String::new(), all.clone());
        if self.table.first_index == 0 {
            return port;
        }
        let clamp = Op::Clamp { low: first.into(), high: last.into() };
        let clamped = self.push(clamp, &[port], index_format, "n", "in_n taken into the range".to_owned(), all);
        let offset = self.constant(first.into(), index_format, "first");
        let bounds = vec![bound(0, last - first); self.table.rows()];
        let format = Format::unsigned(self.table.address_bits as i32, 0);
        self.push(Op::Sub, &[clamped, offset], format, "address", "n minus the first of the range".to_owned(), bounds)
    }

    /// The named field of the ROM word.
    pub fn field(&mut self, address: NodeId, name: &'static str) -> NodeId {
        let index = self.table.fields.iter().position(|f| f.name == name).expect("a field of this method");
        let field = &self.table.fields[index];
        let bounds = self.per_row(|row| {
            let code = field.codes[row];
            let spare = if code == 0 { 1 << 20 } else { code.trailing_zeros() as i32 };
            Bound {
                range: Interval::point(field.format.value(code)),
                error: Interval::ZERO,
                grid: field.format.frac_bits - spare,
            }
        });
        self.push(Op::Field(index), &[address], field.format, name, field.meaning.to_owned(), bounds)
    }

    /// A constant.
    pub fn constant(&mut self, code: i128, format: Format, name: &str) -> NodeId {
        let value = format.value(code);
        let grid = format.frac_bits - code.trailing_zeros() as i32;
        let bound = Bound { range: Interval::point(value), error: Interval::ZERO, grid };
        self.push(Op::Constant(code), &[], format, name, String::new(), vec![bound; self.table.rows()])
    }

    /// Half of the weight of the last of `frac_bits` fraction bits.
    pub fn half_ulp(&mut self, frac_bits: i32) -> NodeId {
        self.constant(1, Format::unsigned(-frac_bits, frac_bits + 1), "half")
    }

    /// `a` plus half of the weight of its `frac_bits`th fraction bit, which makes the rounding down that follows one to
    /// nearest. The constant counts as an error until then.
    pub fn add_half(&mut self, a: NodeId, frac_bits: i32, name: &str) -> NodeId {
        let half = self.half_ulp(frac_bits);
        let sum = self.add(a, half, name, "plus half an output ulp: the result is rounded to nearest");
        let added = self.bounds[half][0].range;
        for bound in &mut self.bounds[sum] {
            bound.error = bound.error + added;
        }
        sum
    }

    fn sum(&mut self, op: Op, [a, b]: [NodeId; 2], name: &str, comment: &str, sign: f64) -> NodeId {
        let signed = |i: Interval| if sign < 0.0 { -i } else { i };
        let bounds = self.per_row(|row| {
            let (a, b) = (self.bounds[a][row], self.bounds[b][row]);
            Bound { range: a.range + signed(b.range), error: a.error + signed(b.error), grid: a.grid.max(b.grid) }
        });
        let frac = self.format(a).frac_bits.max(self.format(b).frac_bits);
        let format = self.holding(&bounds, frac);
        self.push(op, &[a, b], format, name, comment.to_owned(), bounds)
    }

    /// `a + b`, exact.
    pub fn add(&mut self, a: NodeId, b: NodeId, name: &str, comment: &str) -> NodeId {
        self.sum(Op::Add, [a, b], name, comment, 1.0)
    }

    /// `a - b`, exact.
    pub fn sub(&mut self, a: NodeId, b: NodeId, name: &str, comment: &str) -> NodeId {
        self.sum(Op::Sub, [a, b], name, comment, -1.0)
    }

    /// The lobe `x (1 - p)` as `x - t`, where `t` is `x p` rounded down to `frac_bits`.
    ///
    /// The plain rule for differences would take x and t for independent. With `t = x_hw p_hw + e_t` the error is
    /// `(1 - p) e_x - x_hw e_p - e_t`, and the range is that of `x_hw (1 - p_hw) - e_t`. Where p is an unsigned
    /// fraction, t never exceeds x, whatever the inputs. With `half`, a constant is added to x that makes a later rounding
    /// down one to nearest; it counts as an error until then.
    pub fn complement(&mut self, x: NodeId, p: NodeId, frac_bits: i32, half: Option<NodeId>, name: &str) -> NodeId {
        let product = self.mul(x, p, "xp", "x p");
        let whole = self.format(product);
        let proper = !self.format(p).signed && self.format(p).int_bits <= 0;
        // x p < 1 where p < 1, so that the integer bit of the product is idle.
        let t = Format { int_bits: if proper { 0 } else { whole.int_bits }, frac_bits, ..whole };
        let t = self.cast(product, t, proper, "t", "t = x p, rounded down");
        let one = Interval::point(1.0);
        let added = half.map_or(Interval::ZERO, |half| self.bounds[half][0].range);
        let bounds = self.per_row(|row| {
            let (x, p) = (self.bounds[x][row], self.bounds[p][row]);
            let lost = floor_loss(x.grid + p.grid, frac_bits);
            let range = x.range * (one - p.range) - lost;
            Bound {
                range: added + if proper { range.clip(0.0, 1.0) } else { range },
                error: added + (one - (p.range - p.error)) * x.error - x.range * p.error - lost,
                grid: x.grid.max(frac_bits).max(half.map_or(0, |half| self.format(half).frac_bits)),
            }
        });
        let minuend = match half {
            Some(half) => self.add(x, half, "x_half", "x + half an output ulp: the result is rounded to nearest"),
            None => x,
        };
        let frac = self.format(minuend).frac_bits.max(frac_bits);
        let format = if proper { Format::unsigned(1, frac) } else { self.holding(&bounds, frac) };
        self.push(Op::Sub, &[minuend, t], format, name, "x - t = x (1 - p)".to_owned(), bounds)
    }

    /// `a b`, exact; an unsigned operand beside a signed one gets a sign bit.
    pub fn mul(&mut self, a: NodeId, b: NodeId, name: &str, comment: &str) -> NodeId {
        let signed = self.format(a).signed || self.format(b).signed;
        let [a, b] = [a, b].map(|id| if signed { self.with_sign(id) } else { id });
        let bounds = self.per_row(|row| {
            let (a, b) = (self.bounds[a][row], self.bounds[b][row]);
            let ideal_a = a.range - a.error;
            Bound { range: a.range * b.range, error: ideal_a * b.error + b.range * a.error, grid: a.grid + b.grid }
        });
        let (fa, fb) = (self.format(a), self.format(b));
        let format = Format {
            signed,
            // The product of two most negative numbers needs one bit more than the counts add up to.
            int_bits: fa.int_bits + fb.int_bits + i32::from(signed),
            frac_bits: fa.frac_bits + fb.frac_bits,
        };
        self.push(Op::Mul, &[a, b], format, name, comment.to_owned(), bounds)
    }

    fn with_sign(&mut self, id: NodeId) -> NodeId {
        let format = self.format(id);
        if format.signed {
            return id;
        }
        let name = format!("{}_signed", self.nodes[id].name);
        if let Some(known) = self.nodes.iter().position(|node| node.name == name) {
            return known;
        }
        let bounds = self.bounds[id].clone();
        let comment = "a sign bit for the signed product".to_owned();
        self.push(Op::Cast, &[id], Format { signed: true, ..format }, &name, comment, bounds)
    }

    /// `a` times `2^shifts[row]`: a shift by the ROM field `amount` plus `base`, or by `base` alone.
    pub fn scale(
        &mut self,
        a: NodeId,
        amount: Option<NodeId>,
        base: i32,
        shifts: &[i32],
        name: &str,
        comment: &str,
    ) -> NodeId {
        let from = self.format(a);
        let bounds = self.per_row(|row| {
            let bound = self.bounds[a][row];
            Bound {
                range: bound.range.scale(shifts[row]),
                error: bound.error.scale(shifts[row]),
                grid: bound.grid - shifts[row],
            }
        });
        let most = shifts.iter().copied().max().unwrap_or(base);
        let format = Format { int_bits: from.int_bits + most, frac_bits: from.frac_bits - base, ..from };
        match amount {
            Some(amount) => self.push(Op::ShiftLeft, &[a, amount], format, name, comment.to_owned(), bounds),
            None => self.push(Op::Scale, &[a], format, name, comment.to_owned(), bounds),
        }
    }

    /// `a` with `format`'s bits only: low bits are dropped, and high bits where the caller guards them with a
    /// flag (`guarded`) or the analysis shows that they are never used.
    pub fn cast(&mut self, a: NodeId, format: Format, guarded: bool, name: &str, comment: &str) -> NodeId {
        // A number far below the last bit that is kept still takes one bit.
        let format = Format { int_bits: format.int_bits.max(1 - format.frac_bits), ..format };
        if self.format(a) == format {
            return a;
        }
        let lsb = format.lsb();
        let (least, most) = (format.value(format.min_code()), format.value(format.max_code()));
        let mut fits = true;
        let bounds = self.per_row(|row| {
            let bound = self.bounds[a][row];
            let lost = floor_loss(bound.grid, format.frac_bits);
            // Rounding down is monotone, so it may be done to the ends.
            let range = if bound.grid > format.frac_bits {
                // Values are multiples of 2^-grid: the ends round inwards to one first.
                let grid = crate::number::exp2(-bound.grid);
                let (low, high) = ((bound.range.low / grid).ceil() * grid, (bound.range.high / grid).floor() * grid);
                let down = |end: f64| (end / lsb).floor() * lsb;
                Interval::new(down(low), down(high.max(low)))
            } else {
                bound.range
            };
            Bound {
                range: if guarded { range.clip(least, most) } else { range },
                error: bound.error + lost,
                grid: bound.grid.min(format.frac_bits),
            }
        });
        // The range is of reals; its outward rounding may lie within one step of the format's ends.
        if !guarded {
            fits = bounds.iter().all(|b| least - lsb < b.range.low && b.range.high < most + lsb);
        }
        self.fits &= fits;
        self.push(Op::Cast, &[a], format, name, comment.to_owned(), bounds)
    }

    /// `a` rounded down to `frac_bits`, in the narrowest format that holds it over the active interval; past that
    /// it wraps.
    pub fn floor(&mut self, a: NodeId, frac_bits: i32, name: &str, comment: &str) -> NodeId {
        let format = self.format(a);
        if format.frac_bits <= frac_bits {
            return a;
        }
        let rounded = self.cast(a, Format { frac_bits, ..format }, false, name, comment);
        let bounds = self.bounds[rounded].clone();
        self.nodes[rounded].format = self.holding(&bounds, frac_bits);
        rounded
    }

    /// `a` taken into [0, 1], as `UQ1.f`.
    pub fn clamp_to_unit(&mut self, a: NodeId, name: &str, comment: &str) -> NodeId {
        let format = self.format(a);
        let one = 1i128 << format.frac_bits;
        let bounds = self.per_row(|row| {
            let bound = self.bounds[a][row];
            Bound { range: bound.range.clip(0.0, 1.0), ..bound }
        });
        let unit = Format::unsigned(1, format.frac_bits);
        self.push(Op::Clamp { low: 0, high: one }, &[a], unit, name, comment.to_owned(), bounds)
    }

    fn flag(&mut self, op: Op, args: &[NodeId], name: &str, comment: &str) -> NodeId {
        let bound = Bound { range: Interval::UNIT, error: Interval::ZERO, grid: 0 };
        self.push(op, args, Format::FLAG, name, comment.to_owned(), vec![bound; self.table.rows()])
    }

    /// 1 if `a`, not negative, has a bit of weight `2^weight` or more; `None` if its format has no such bit.
    pub fn reaches(&mut self, a: NodeId, weight: i32, name: &str, comment: &str) -> Option<NodeId> {
        let format = self.format(a);
        if format.int_bits <= weight {
            return None;
        }
        let high = Format::unsigned(format.int_bits, -weight);
        let high = self.cast(a, high, false, &format!("{name}_bits"), comment);
        if self.format(high).width() == 1 {
            return Some(high);
        }
        Some(self.flag(Op::NonZero, &[high], name, comment))
    }

    /// 1 if `a > b`.
    pub fn greater(&mut self, a: NodeId, b: NodeId, name: &str, comment: &str) -> NodeId {
        debug_assert_eq!(self.format(a).frac_bits, self.format(b).frac_bits);
        self.flag(Op::Greater, &[a, b], name, comment)
    }

    /// 1 if any of the flags is; `None` if there are none.
    pub fn any(&mut self, flags: &[Option<NodeId>], name: &str, comment: &str) -> Option<NodeId> {
        flags.iter().flatten().copied().reduce(|a, b| self.flag(Op::Or, &[a, b], name, comment))
    }

    /// 0 where the flag is 1, else `a`. The error bound stays: where the flag is 1 either the real value is 0, or the hardware's p has
    /// reached 1, and then the real value `x (1 - p)` is positive by the error of p at most, which the bound holds.
    pub fn zero_if(&mut self, flag: Option<NodeId>, a: NodeId, name: &str, comment: &str) -> NodeId {
        let Some(flag) = flag else { return a };
        let bounds = self.per_row(|row| {
            let bound = self.bounds[a][row];
            Bound { range: bound.range.hull(Interval::ZERO), ..bound }
        });
        let format = self.format(a);
        self.push(Op::ZeroIf, &[flag, a], format, name, comment.to_owned(), bounds)
    }
}
