//! Values held within bounds, flags and what they choose.

use super::{Bound, Builder, HighBits};
use crate::datapath::graph::{NodeId, Op};
use crate::fixed::{Format, Interval, exp2};

impl Builder<'_> {
    /// `a`, not negative, or `2^weight` if that is less.
    pub fn at_most(&mut self, a: NodeId, weight: i32, name: &str, comment: &str) -> NodeId {
        let Format { int_bits, frac_bits, .. } = self.format(a);
        if int_bits <= weight {
            return a;
        }
        let (high, format) = (1 << (weight + frac_bits), Format::unsigned(weight + 1, frac_bits));
        self.within(a, [0, high], format, [0.0, exp2(weight)], name, comment)
    }

    /// `a` clamped to [0, 1], as `UQ1.f`.
    pub fn clamp_to_unit(&mut self, a: NodeId, name: &str, comment: &str) -> NodeId {
        let unit = Format::unsigned(1, self.format(a).frac_bits);
        self.within(a, [0, 1 << unit.frac_bits], unit, [0.0, 1.0], name, comment)
    }

    /// `a`, or 0 where it is below.
    pub fn at_least_zero(&mut self, a: NodeId, name: &str, comment: &str) -> NodeId {
        let positive = Format { signed: false, ..self.format(a) };
        self.within(a, [0, positive.max_code()], positive, [0.0, f64::INFINITY], name, comment)
    }

    /// `a` clamped to the codes `low..=high` of its own fraction bits, in the narrowest format that holds these; `low`
    /// is 0 or negative. `low` below 0 needs a signed `a`.
    pub fn clamp(&mut self, a: NodeId, low: i128, high: i128, name: &str, comment: &str) -> NodeId {
        let format = Format::holding(low, high, self.format(a).frac_bits);
        self.within(a, [low, high], format, [format.value(low), format.value(high)], name, comment)
    }

    /// `a` clamped to these codes, in a format that holds them, and so into a range of reals.
    fn within(
        &mut self,
        a: NodeId,
        [low, high]: [i128; 2],
        format: Format,
        [least, most]: [f64; 2],
        name: &str,
        comment: &str,
    ) -> NodeId {
        let bounds = self.mapped(a, |bound| Bound { range: bound.range.clip(least, most), ..bound });
        self.push(Op::Clamp { low, high }, &[a], format, name, comment.to_owned(), bounds)
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
        let high = self.cast(a, high, HighBits::Unused, &format!("{name}_bits"), comment);
        Some(if self.format(high).width() == 1 { high } else { self.flag(Op::NonZero, &[high], name, comment) })
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
            self.cast(id, format, HighBits::Unused, &name, "in the wider of two formats")
        });
        self.push(Op::Select, &[flag, a, b], format, name, comment.to_owned(), bounds)
    }

    /// 0 where the flag is 1, else `a`. Where the flag is 1 either the real value is 0, which is exact, or the
    /// hardware's p has reached 1, and then the real value `x (1 - p)` is positive by the error of p at most, which the
    /// bound of `a` holds.
    pub fn zero_if(&mut self, flag: Option<NodeId>, a: NodeId, name: &str, comment: &str) -> NodeId {
        let Some(flag) = flag else { return a };
        let bounds = self.mapped(a, |Bound { range, error, grid }| {
            let [range, error] = [range, error].map(|interval| interval.hull(Interval::ZERO));
            Bound { range, error, grid }
        });
        self.push(Op::ZeroIf, &[flag, a], self.format(a), name, comment.to_owned(), bounds)
    }
}
