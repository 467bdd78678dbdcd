//! Sums, products, shifts and casts, each with its range and error.

use super::{Bound, Builder, HighBits};
use crate::datapath::graph::{Node, NodeId, Op};
use crate::fixed::{Format, Interval, exp2};

/// What rounding a multiple of `2^-grid` down to `frac_bits` fraction bits adds to it.
fn floor_loss(grid: i32, frac_bits: i32) -> Interval {
    if grid <= frac_bits {
        return Interval::ZERO;
    }
    Interval::new(exp2(-grid) - exp2(-frac_bits), 0.0)
}

impl Builder<'_> {
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
    /// fraction, t never exceeds x, whatever the inputs. With `half`, a constant is added to x that makes a later
    /// rounding down one to nearest; it counts as an error until then.
    pub fn complement(&mut self, x: NodeId, p: NodeId, frac_bits: i32, half: Option<NodeId>, name: &str) -> NodeId {
        let product = self.mul(x, p, "xp", "x p");
        let whole = self.format(product);
        let proper = !self.format(p).signed && self.format(p).int_bits <= 0;
        // x p < 1 where p < 1, so that the integer bit of the product is idle.
        let t = Format { int_bits: if proper { 0 } else { whole.int_bits }, frac_bits, ..whole };
        let high = if proper { HighBits::Guarded } else { HighBits::Unused };
        let t = self.cast(product, t, high, "t", "t = x p, rounded down");
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
        let format = Format::product([self.format(a), self.format(b)]);
        self.push(Op::Mul, &[a, b], format, name, comment.to_owned(), bounds)
    }

    /// The bit of weight `2^weight` of `a`.
    pub fn bit(&mut self, a: NodeId, weight: i32, name: &str, comment: &str) -> NodeId {
        self.cast(a, Format::unsigned(weight + 1, -weight), HighBits::Guarded, name, comment)
    }

    /// `a b`, exact, as a sum of `b` shifted for every bit of `a`, which has few; neither is signed.
    pub fn mul_by_bits(&mut self, a: NodeId, b: NodeId, name: &str, comment: &str) -> NodeId {
        let format = self.format(a);
        let count = self.cases.len();
        let mut sum: Option<NodeId> = None;
        for weight in -format.frac_bits..format.int_bits {
            let place = weight + format.frac_bits;
            let bit = self.bit(a, weight, &format!("{name}_bit_{place}"), "a bit of the slope");
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

    /// `a + (c - a) t` of two numbers of one format that have no sign, exact, without a multiplier.
    ///
    /// In parts of t's last bit t is the number of the first of `bits` plus `Σ 2^i` times the others, the lowest first:
    /// of t = 1 all are 1. The blend is the sum of `c` where a bit is 1 and `a` where it is 0, each as often.
    pub fn blend_by_bits(&mut self, of: [NodeId; 2], bits: &[NodeId], name: &str, comment: &str) -> NodeId {
        let [a, c] = of;
        let parts = bits.len() as i32 - 1;
        let count = self.cases.len();
        let mut terms: Vec<NodeId> = Vec::new();
        for (place, &bit) in bits.iter().enumerate() {
            let which = if place == 0 { "first".to_owned() } else { (place - 1).to_string() };
            let either = self.select(bit, [c, a], |_| None, &format!("{name}_either_{which}"), "either of both");
            let weight = (place as i32 - 1).max(0) - parts;
            let shifts = vec![weight; count];
            terms.push(self.scale(either, None, weight, &shifts, &format!("{name}_by_{which}"), "shifted"));
        }
        // Neighbours first, so that sums are narrow and few follow each other.
        let mut level = 0;
        while terms.len() > 1 {
            level += 1;
            let last = terms.len() == 2;
            let mut two = |(number, two): (usize, &[NodeId])| match *two {
                [a, c] if last => self.add(a, c, name, comment),
                [a, c] => self.add(a, c, &format!("{name}_sum_{level}_{number}"), "the sum of two"),
                _ => two[0],
            };
            terms = terms.chunks(2).enumerate().map(&mut two).collect();
        }
        terms[0]
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
        let (op, args) = amount.map_or((Op::Scale, vec![a]), |amount| (Op::ShiftLeft, vec![a, amount]));
        self.push(op, &args, format, name, comment.to_owned(), bounds)
    }

    /// `a` times `2^-amount`, rounded down to the fraction bits of `a`; `amount` is an integer without error, not
    /// negative.
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

    /// `a` with `format`'s bits only: low bits are dropped, and high bits as `high` says.
    pub fn cast(&mut self, a: NodeId, format: Format, high: HighBits, name: &str, comment: &str) -> NodeId {
        let guarded = high == HighBits::Guarded;
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
        let bounds = self.mapped(a, |bound| {
            let lost = floor_loss(bound.grid, format.frac_bits);
            // Rounding down is monotone, so it may be done to the ends.
            let range = if bound.grid > format.frac_bits {
                // Values are multiples of 2^-grid: the ends round inwards to one first.
                let grid = exp2(-bound.grid);
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
        self.fits &= guarded || bounds.iter().all(|b| least - lsb < b.range.low && b.range.high < most + lsb);
        self.push(Op::Cast, &[a], format, name, comment.to_owned(), bounds)
    }

    /// `a` rounded down to `frac_bits`, in the narrowest format that holds it over the active interval; past that
    /// it wraps.
    pub fn floor(&mut self, a: NodeId, frac_bits: i32, name: &str, comment: &str) -> NodeId {
        let format = self.format(a);
        if format.frac_bits <= frac_bits {
            return a;
        }
        let rounded = self.cast(a, Format { frac_bits, ..format }, HighBits::Unused, name, comment);
        self.narrow(rounded, self.bounds[rounded].clone());
        rounded
    }
}
