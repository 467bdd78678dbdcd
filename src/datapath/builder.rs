//! Builds a graph and bounds every value's range and error, row by row.
//!
//! The analysis is an abstract interpretation with intervals. It goes case by case: a case is a row of the coefficient ROM, or a
//! part of one, such as a segment. For every case it follows, next to the range of each hardware value, the interval of its
//! *error*: the hardware value minus the real value that the formula with the quantised coefficients has there. Sums add errors, a
//! product obeys `a'b' - ab = a (b' - b) + b' (a' - a)`, and dropping bits adds `[-(2^-f - 2^-g), 0]`, where `g` is the number
//! of fraction bits that the value really has in this case. The inputs range over the case's *active*
//! interval only, as a rule the versines from 0 to where the lobe is 0 for good; past it a flag forces the result,
//! and values there may wrap.

use super::graph::{Graph, Node, NodeId, Op};
use crate::fixed::{Format, Interval, Table};

/// What is known of a value in one case.
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
    Interval::new(crate::fixed::exp2(-grid) - crate::fixed::exp2(-frac_bits), 0.0)
}

/// A case of the analysis.
#[derive(Clone, Debug)]
pub struct Case {
    /// The versines of the case.
    pub active: Interval,
    /// The shininess; the largest of the set where the case holds several.
    pub shininess: f64,
    /// The row that the case reads of each memory, by the memories' numbers; `None` where it may read any.
    pub rows: Vec<Option<usize>>,
}

impl Case {
    /// One case a row of a coefficient ROM, with the versines from 0 to each row's end.
    #[must_use]
    pub fn of_rows(table: &Table, ends: &[f64]) -> Vec<Self> {
        let case = |(row, &end): (usize, &f64)| Self {
            active: Interval::new(0.0, end),
            shininess: table.keys[row],
            rows: vec![Some(row)],
        };
        ends.iter().enumerate().map(case).collect()
    }
}

/// A graph under construction.
#[derive(Debug)]
pub struct Builder<'a> {
    pub(crate) tables: &'a [Table],
    pub(crate) cases: Vec<Case>,
    pub(crate) nodes: Vec<Node>,
    bounds: Vec<Vec<Bound>>,
    pub(crate) inputs: Vec<NodeId>,
    fits: bool,
}

impl<'a> Builder<'a> {
    /// An empty graph with these memories, analysed for these cases.
    #[must_use]
    pub fn new(tables: &'a [Table], cases: Vec<Case>) -> Self {
        Self { tables, cases, nodes: Vec::new(), bounds: Vec::new(), inputs: Vec::new(), fits: true }
    }

    /// The cases.
    #[must_use]
    pub fn cases(&self) -> &[Case] {
        &self.cases
    }

    /// A memory.
    #[must_use]
    pub fn table(&self, memory: usize) -> &'a Table {
        &self.tables[memory]
    }

    /// The format of a node.
    #[must_use]
    pub fn format(&self, id: NodeId) -> Format {
        self.nodes[id].format
    }

    /// The bounds of a node, one a case.
    #[must_use]
    pub fn bounds(&self, id: NodeId) -> &[Bound] {
        &self.bounds[id]
    }

    /// Replaces what the analysis knows of a node by what the caller has proved: tighter bounds, case by case, from a relation
    /// between values that intervals do not see.
    pub fn assume(&mut self, id: NodeId, bounds: Vec<Bound>) {
        debug_assert_eq!(bounds.len(), self.cases.len());
        self.bounds[id] = bounds;
    }

    /// The finished graph with its output ports, without the nodes that no output needs (a lobe may do without x or without
    /// u), or `None` if a value left its format. `kept` are nodes that an output needs: each is given its
    /// place in the graph.
    #[must_use]
    pub fn finish<'k>(
        self,
        outputs: &[(&str, NodeId)],
        kept: impl IntoIterator<Item = &'k mut NodeId>,
    ) -> Option<Graph> {
        let mut needed = vec![false; self.nodes.len()];
        for id in outputs.iter().map(|&(_, node)| node).chain(self.inputs.iter().copied()) {
            needed[id] = true;
        }
        // Arguments come before results.
        for (id, node) in self.nodes.iter().enumerate().rev() {
            if needed[id] {
                node.args.iter().for_each(|&arg| needed[arg] = true);
            }
        }
        // The place of each node among those that stay.
        let place: Vec<NodeId> = needed
            .iter()
            .scan(0, |next, &needed| {
                let place = *next;
                *next += usize::from(needed);
                Some(place)
            })
            .collect();
        let stays = self.nodes.into_iter().zip(&needed).filter(|(_, needed)| **needed);
        let moved = |node: Node| Node { args: node.args.iter().map(|&arg| place[arg]).collect(), ..node };
        let nodes = stays.map(|(node, _)| moved(node)).collect();
        let inputs = self.inputs.into_iter().map(|input| place[input]).collect();
        kept.into_iter().for_each(|node| *node = place[*node]);
        let outputs = outputs.iter().map(|&(name, node)| (name.to_owned(), place[node])).collect();
        self.fits.then_some(Graph { nodes, inputs, outputs })
    }

    /// A node with the bounds of its value, one a case. Bounds that nothing asks for may be left out.
    pub(crate) fn push(
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

    /// A bound for each case.
    pub(crate) fn per_case(&self, bound: impl Fn(usize) -> Bound) -> Vec<Bound> {
        (0..self.cases.len()).map(bound).collect()
    }

    /// The narrowest format with these fraction bits that holds the ranges of all cases.
    fn holding(&mut self, bounds: &[Bound], frac_bits: i32) -> Format {
        let low = bounds.iter().map(|b| b.range.low).fold(f64::INFINITY, f64::min);
        let high = bounds.iter().map(|b| b.range.high).fold(f64::NEG_INFINITY, f64::max);
        let scale = crate::fixed::exp2(frac_bits);
        if low.abs().max(high.abs()) * scale > crate::fixed::exp2(MAX_BITS) {
            self.fits = false;
            return Format::unsigned(1, frac_bits);
        }
        // Values are multiples of the last bit's weight: the ends round inwards.
        let (low, high) = ((low * scale).ceil() as i128, (high * scale).floor() as i128);
        Format::holding(low, high.max(low), frac_bits)
    }

    /// An input port; `bound` says what is known of its codes in each case.
    pub fn input(&mut self, format: Format, name: &str, bound: impl Fn(&Case) -> Bound) -> NodeId {
        let bounds = self.cases.iter().map(bound).collect();
        let id = self.push(Op::Input, &[], format, name, String::new(), bounds);
        self.inputs.push(id);
        id
    }

    /// A whole index of the set as the address in a memory whose rows begin at the set's first.
    pub(crate) fn offset_from_first(&mut self, index: NodeId, memory: usize) -> NodeId {
        let table = &self.tables[memory];
        let (first, address_bits, last) = (table.first_index, table.address_bits, table.rows() as u32 - 1);
        if first == 0 {
            return index;
        }
        let first = self.constant(first.into(), self.format(index), "first");
        let bounds = vec![Self::whole(0, last); self.cases.len()];
        let format = Format::unsigned(address_bits as i32, 0);
        self.push(Op::Sub, &[index, first], format, "address", "n minus the first of the range".to_owned(), bounds)
    }

    /// The address of a part of a row, for the memory `memory`: the row's address and the part's number side by side.
    pub fn part_address(&mut self, address: NodeId, part: NodeId, memory: usize) -> NodeId {
        let bits = self.format(part).width() as i32;
        let shifts = vec![bits; self.cases.len()];
        let base = self.scale(address, None, bits, &shifts, "address_of_parts", "the address of the row's first part");
        let format = Format::unsigned(self.tables[memory].address_bits as i32, 0);
        let bounds = vec![Self::whole(0, (1 << format.width()) - 1); self.cases.len()];
        self.push(Op::Add, &[base, part], format, "part_address", "the address of the part".to_owned(), bounds)
    }

    /// Replaces what the analysis knows of a node as [`Builder::assume`] does, and its format by the narrowest that holds it.
    pub fn narrow(&mut self, id: NodeId, bounds: Vec<Bound>) {
        let frac_bits = self.format(id).frac_bits;
        self.nodes[id].format = self.holding(&bounds, frac_bits);
        self.assume(id, bounds);
    }

    pub(crate) fn whole(low: u32, high: u32) -> Bound {
        Bound { range: Interval::new(f64::from(low), f64::from(high)), error: Interval::ZERO, grid: 0 }
    }

    /// The named field of a memory's word; a field that is read already is not read again.
    pub fn field(&mut self, memory: usize, address: NodeId, name: &'static str) -> NodeId {
        let tables = self.tables;
        let (index, field) = tables[memory]
            .fields
            .iter()
            .enumerate()
            .find(|(_, field)| field.name == name)
            .expect("a field of this method");
        let of_row = |row: usize| {
            let code = field.codes[row];
            let spare = if code == 0 { 1 << 20 } else { code.trailing_zeros() as i32 };
            Bound {
                range: Interval::point(field.format.value(code)),
                error: Interval::ZERO,
                grid: field.format.frac_bits - spare,
            }
        };
        let any = (0..tables[memory].rows()).map(of_row).reduce(|a, b| Bound {
            range: a.range.hull(b.range),
            error: Interval::ZERO,
            grid: a.grid.max(b.grid),
        });
        let bounds = self.per_case(|case| match self.cases[case].rows[memory] {
            Some(row) => of_row(row),
            None => any.expect("a memory has rows"),
        });
        let op = Op::Field { memory, field: index };
        if let Some(known) = self.nodes.iter().position(|node| node.op == op && node.args == [address]) {
            return known;
        }
        self.push(op, &[address], field.format, name, field.meaning.to_owned(), bounds)
    }

    /// A constant.
    pub fn constant(&mut self, code: i128, format: Format, name: &str) -> NodeId {
        let value = format.value(code);
        let grid = if code == 0 { -(1 << 20) } else { format.frac_bits - code.trailing_zeros() as i32 };
        let bound = Bound { range: Interval::point(value), error: Interval::ZERO, grid };
        self.push(Op::Constant(code), &[], format, name, String::new(), vec![bound; self.cases.len()])
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
        let bounds = self.per_case(|case| {
            let (a, b) = (self.bounds[a][case], self.bounds[b][case]);
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
        let bounds = self.per_case(|case| {
            let (x, p) = (self.bounds[x][case], self.bounds[p][case]);
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
        let bounds = self.per_case(|case| {
            let (a, b) = (self.bounds[a][case], self.bounds[b][case]);
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

    /// `a b`, exact, as a sum of `b` shifted for every bit of `a`, which has few; neither is signed.
    pub fn mul_by_bits(&mut self, a: NodeId, b: NodeId, name: &str, comment: &str) -> NodeId {
        let format = self.format(a);
        let count = self.cases.len();
        let mut sum: Option<NodeId> = None;
        for weight in -format.frac_bits..format.int_bits {
            let place = weight + format.frac_bits;
            let bit = Format::unsigned(weight + 1, -weight);
            let bit = self.cast(a, bit, true, &format!("{name}_bit_{place}"), "a bit of the slope");
            let clear = self.not(bit, &format!("{name}_without_{place}"), "the bit is 0");
            let scaled = self.scale(b, None, weight, &vec![weight; count], &format!("{name}_by_{place}"), "shifted");
            let term = self.zero_if(Some(clear), scaled, &format!("{name}_term_{place}"), "0 where the bit is 0");
            sum = Some(match sum {
                None => term,
                Some(sum) => self.add(sum, term, &format!("{name}_to_{place}"), comment),
            });
        }
        let product = sum.expect("a number has bits");
        let bounds = self.per_case(|case| {
            let (a, b) = (self.bounds[a][case], self.bounds[b][case]);
            Bound { range: a.range * b.range, error: Interval::ZERO, grid: a.grid + b.grid }
        });
        self.assume(product, bounds);
        product
    }

    fn with_sign(&mut self, id: NodeId) -> NodeId {
        let format = self.format(id);
        if format.signed {
            return id;
        }
        let signed = Format { signed: true, ..format };
        let is_known = |node: &Node| node.op == Op::Cast && node.args == [id] && node.format == signed;
        if let Some(known) = self.nodes.iter().position(is_known) {
            return known;
        }
        let (name, bounds) = (format!("{}_signed", self.nodes[id].name), self.bounds[id].clone());
        self.push(Op::Cast, &[id], signed, &name, "a sign bit for the signed product".to_owned(), bounds)
    }

    /// `a` times `2^shifts[case]`: a shift by the ROM field `amount` plus `base`, or by `base` alone.
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
        let bounds = self.per_case(|case| {
            let bound = self.bounds[a][case];
            Bound {
                range: bound.range.scale(shifts[case]),
                error: bound.error.scale(shifts[case]),
                grid: bound.grid - shifts[case],
            }
        });
        let most = shifts.iter().copied().max().unwrap_or(base);
        let format = Format { int_bits: from.int_bits + most, frac_bits: from.frac_bits - base, ..from };
        match amount {
            Some(amount) => self.push(Op::ShiftLeft, &[a, amount], format, name, comment.to_owned(), bounds),
            None => self.push(Op::Scale, &[a], format, name, comment.to_owned(), bounds),
        }
    }

    /// `a` times `2^-amount`, rounded down to the fraction bits of `a`; `amount` is an integer without error, not negative.
    pub fn shift_right(&mut self, a: NodeId, amount: NodeId, name: &str, comment: &str) -> NodeId {
        let format = self.format(a);
        let bounds = self.per_case(|case| {
            let (a, amount) = (self.bounds[a][case], self.bounds[amount][case].range);
            let (least, most) = (amount.low as i32, amount.high as i32);
            let hull = |interval: Interval| interval.scale(-least).hull(interval.scale(-most));
            let lost = floor_loss(a.grid + most, format.frac_bits);
            Bound { range: hull(a.range) + lost, error: hull(a.error) + lost, grid: format.frac_bits }
        });
        self.push(Op::ShiftRight, &[a, amount], format, name, comment.to_owned(), bounds)
    }

    /// `a`, not negative, or `2^weight` if that is less.
    pub fn at_most(&mut self, a: NodeId, weight: i32, name: &str, comment: &str) -> NodeId {
        let format = self.format(a);
        if format.int_bits <= weight {
            return a;
        }
        let high = 1i128 << (weight + format.frac_bits);
        let bounds = self.per_case(|case| {
            let bound = self.bounds[a][case];
            Bound { range: bound.range.clip(0.0, crate::fixed::exp2(weight)), ..bound }
        });
        let format = Format::unsigned(weight + 1, format.frac_bits);
        self.push(Op::Clamp { low: 0, high }, &[a], format, name, comment.to_owned(), bounds)
    }

    /// `a` with `format`'s bits only: low bits are dropped, and high bits where the caller guards them with a
    /// flag (`guarded`) or the analysis shows that they are never used.
    pub fn cast(&mut self, a: NodeId, format: Format, guarded: bool, name: &str, comment: &str) -> NodeId {
        let empty = format.int_bits + format.frac_bits <= 0;
        // A number far below the last bit that is kept still takes one bit.
        let format = Format { int_bits: format.int_bits.max(1 - format.frac_bits), ..format };
        if guarded && empty && !format.signed {
            // None of the bits that are wanted is left: the bit that the format has now is not one of them.
            return self.constant(0, format, name);
        }
        if self.format(a) == format {
            return a;
        }
        let lsb = format.lsb();
        let (least, most) = (format.value(format.min_code()), format.value(format.max_code()));
        let mut fits = true;
        let bounds = self.per_case(|case| {
            let bound = self.bounds[a][case];
            let lost = floor_loss(bound.grid, format.frac_bits);
            // Rounding down is monotone, so it may be done to the ends.
            let range = if bound.grid > format.frac_bits {
                // Values are multiples of 2^-grid: the ends round inwards to one first.
                let grid = crate::fixed::exp2(-bound.grid);
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
        let bounds = self.per_case(|case| {
            let bound = self.bounds[a][case];
            Bound { range: bound.range.clip(0.0, 1.0), ..bound }
        });
        let unit = Format::unsigned(1, format.frac_bits);
        self.push(Op::Clamp { low: 0, high: one }, &[a], unit, name, comment.to_owned(), bounds)
    }

    /// `a`, or 0 where it is below.
    pub fn at_least_zero(&mut self, a: NodeId, name: &str, comment: &str) -> NodeId {
        let format = self.format(a);
        let bounds = self.per_case(|case| {
            let bound = self.bounds[a][case];
            Bound { range: bound.range.clip(0.0, f64::INFINITY), ..bound }
        });
        let positive = Format { signed: false, ..format };
        let clamp = Op::Clamp { low: 0, high: positive.max_code() };
        self.push(clamp, &[a], positive, name, comment.to_owned(), bounds)
    }

    pub(crate) fn flag(&mut self, op: Op, args: &[NodeId], name: &str, comment: &str) -> NodeId {
        let bound = Bound { range: Interval::UNIT, error: Interval::ZERO, grid: 0 };
        self.push(op, args, Format::FLAG, name, comment.to_owned(), vec![bound; self.cases.len()])
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
        let flags: Vec<NodeId> = flags.iter().flatten().copied().collect();
        let mut any = *flags.first()?;
        for (place, &flag) in flags.iter().enumerate().skip(1) {
            let last = place + 1 == flags.len();
            let name = if last { name.to_owned() } else { format!("{name}_of_{}", place + 1) };
            any = self.flag(Op::Or, &[any, flag], &name, comment);
        }
        Some(any)
    }

    /// 1 if the flag is 0.
    pub fn not(&mut self, flag: NodeId, name: &str, comment: &str) -> NodeId {
        self.flag(Op::Not, &[flag], name, comment)
    }

    /// `a` where the flag is 1, else `b`, in a format that holds both; `chosen` says in which cases the flag is known.
    pub fn select(
        &mut self,
        flag: NodeId,
        [a, b]: [NodeId; 2],
        chosen: impl Fn(usize) -> Option<bool>,
        name: &str,
        comment: &str,
    ) -> NodeId {
        let bounds = self.per_case(|case| {
            let (a, b) = (self.bounds[a][case], self.bounds[b][case]);
            match chosen(case) {
                Some(true) => a,
                Some(false) => b,
                None => Bound { range: a.range.hull(b.range), error: a.error.hull(b.error), grid: a.grid.max(b.grid) },
            }
        });
        let (fa, fb) = (self.format(a), self.format(b));
        let signed = fa.signed || fb.signed;
        let format =
            Format { signed, int_bits: fa.int_bits.max(fb.int_bits), frac_bits: fa.frac_bits.max(fb.frac_bits) };
        let [a, b] = [a, b].map(|id| {
            let name = format!("{}_wide", self.nodes[id].name);
            self.cast(id, format, false, &name, "in the wider of two formats")
        });
        self.push(Op::Select, &[flag, a, b], format, name, comment.to_owned(), bounds)
    }

    /// 0 where the flag is 1, else `a`. The error bound stays: where the flag is 1 either the real value is 0, or the hardware's p has
    /// reached 1, and then the real value `x (1 - p)` is positive by the error of p at most, which the bound holds.
    pub fn zero_if(&mut self, flag: Option<NodeId>, a: NodeId, name: &str, comment: &str) -> NodeId {
        let Some(flag) = flag else { return a };
        let bounds = self.per_case(|case| {
            let bound = self.bounds[a][case];
            Bound { range: bound.range.hull(Interval::ZERO), ..bound }
        });
        let format = self.format(a);
        self.push(Op::ZeroIf, &[flag, a], format, name, comment.to_owned(), bounds)
    }

    /// `a` taken into the codes `low..=high` of its own fraction bits, in the narrowest format that holds these; `low` is 0 or
    /// negative. `low` below 0 needs a signed `a`.
    pub fn clamp(&mut self, a: NodeId, low: i128, high: i128, name: &str, comment: &str) -> NodeId {
        let frac = self.format(a).frac_bits;
        let format = Format::holding(low, high, frac);
        let (least, most) = (format.value(low), format.value(high));
        let bounds = self.per_case(|case| {
            let bound = self.bounds[a][case];
            Bound { range: bound.range.clip(least, most), ..bound }
        });
        self.push(Op::Clamp { low, high }, &[a], format, name, comment.to_owned(), bounds)
    }

    /// Takes over another graph's operations up to its output, and returns that. `given` says which of its nodes are nodes here
    /// already; `memories` which memory here each of its own is. A field that is read here already is not read again. The new
    /// nodes' names begin with `prefix`.
    ///
    /// The graph has its own analysis: here its values are only known to fit their formats, and its errors are not followed.
    pub fn graft(&mut self, graph: &Graph, memories: &[usize], given: &[(NodeId, NodeId)], prefix: &str) -> NodeId {
        let mut here: Vec<Option<NodeId>> = vec![None; graph.nodes.len()];
        for &(there, known) in given {
            here[there] = Some(known);
        }
        let mut needed = vec![false; graph.nodes.len()];
        needed[graph.output()] = true;
        for id in (0..graph.nodes.len()).rev().filter(|&id| here[id].is_none()) {
            if needed[id] {
                graph.nodes[id].args.iter().for_each(|&arg| needed[arg] = true);
            }
        }
        for (id, node) in graph.nodes.iter().enumerate() {
            if here[id].is_some() || !needed[id] {
                continue;
            }
            let args: Vec<NodeId> = node.args.iter().map(|&arg| here[arg].expect("arguments come first")).collect();
            let op = match node.op {
                Op::Field { memory, field } => Op::Field { memory: memories[memory], field },
                op => op,
            };
            let is_read = |known: &Node| matches!(op, Op::Field { .. }) && known.op == op && known.args == args;
            if let Some(known) = self.nodes.iter().position(is_read) {
                here[id] = Some(known);
                continue;
            }
            let format = node.format;
            let range = Interval::new(format.value(format.min_code()), format.value(format.max_code()));
            let bound = Bound { range, error: Interval::ZERO, grid: format.frac_bits };
            let bounds = vec![bound; self.cases.len()];
            let name = format!("{prefix}_{}", node.name);
            here[id] = Some(self.push(op, &args, format, &name, node.comment.clone(), bounds));
        }
        here[graph.output()].expect("the output is needed")
    }
}
