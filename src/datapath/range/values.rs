//! What the nodes take in a block of inputs.

use super::relations::{Blend, Complement, Factor, Restoring};
use super::{Analysis, Block, Region, Span};
use crate::datapath::graph::{Node, NodeId, Op};
use crate::fixed::Format;

impl Analysis<'_> {
    /// What a node takes, given what its arguments do.
    pub(super) fn value(&self, id: NodeId, inputs: &Region, block: &Block) -> Span {
        self.ports[id].map_or_else(|| self.exact(id, &self.graph.nodes[id], block), |port| inputs[port])
    }

    /// Follows a block of inputs through the operations.
    pub(super) fn look(&self, inputs: &Region, block: &mut Block) {
        for &id in &self.nodes {
            let node = &self.graph.nodes[id];
            let mut exact = self.value(id, inputs, block);
            if self.guarded[id] {
                exact = exact.map(|code| code.max(0));
            }
            if let (Some(step), false) = (self.restoring[id], exact.is_point()) {
                block.restores[id] = self.restores(step, block);
                if block.restores[id] {
                    exact = exact.up_to(self.aligned(step.divisor, node.format, block).high);
                }
            }
            if let (Some(trial), false) = (self.kept[id], exact.is_point()) {
                let divisor = self.restoring[trial].expect("a step").divisor;
                // Below the divisor by a last bit of the finer at least.
                exact = exact.up_to(self.aligned(divisor, node.format, block).high);
            }
            block.exact[id] = exact;
            block.codes[id] = wrapped(exact, node.format);
            block.needed[id] = false;
        }
        self.results.iter().for_each(|&result| block.needed[result] = true);
        for &id in self.nodes.iter().rev() {
            if !block.needed[id] || self.ports[id].is_some() {
                continue;
            }
            let node = &self.graph.nodes[id];
            let flag = |place: usize| block.codes[node.args[place]];
            let (no, yes) = (Span::point(0), Span::point(1));
            let unused = match node.op {
                Op::ZeroIf | Op::Or if flag(0) == yes => Some(1),
                Op::Or if flag(1) == yes => Some(0),
                Op::Select if flag(0) == yes => Some(2),
                Op::Select if flag(0) == no => Some(1),
                // A product with 0 is 0, whatever the other factor is.
                Op::Mul if flag(0) == no => Some(1),
                Op::Mul if flag(1) == no => Some(0),
                _ => None,
            };
            for (place, &arg) in node.args.iter().enumerate() {
                block.needed[arg] |= Some(place) != unused;
            }
        }
    }

    /// The codes of a node with as many fraction bits as a format has, which are no fewer.
    fn aligned(&self, id: NodeId, format: Format, block: &Block) -> Span {
        block.codes[id].map(|code| code << (format.frac_bits - self.graph.nodes[id].format.frac_bits))
    }

    /// Whether r is at most d in a step: it was in the step before, or the whole block says so.
    fn restores(&self, step: Restoring, block: &Block) -> bool {
        if step.before.is_some_and(|before| block.restores[before]) {
            return true;
        }
        let [doubled, divisor] = [step.doubled, step.divisor].map(|id| self.graph.nodes[id].format);
        let finer = if doubled.frac_bits > divisor.frac_bits { doubled } else { divisor };
        self.aligned(step.doubled, finer, block).high <= 2 * self.aligned(step.divisor, finer, block).low
    }

    /// The exact values of a node, given its arguments' codes.
    fn exact(&self, id: NodeId, node: &Node, block: &Block) -> Span {
        let arg = |place: usize| block.codes[node.args[place]];
        let frac = |place: usize| self.graph.nodes[node.args[place]].format.frac_bits;
        let aligned = |place: usize| arg(place).map(|code| code << (node.format.frac_bits - frac(place)));
        let flag = |known: Option<bool>| match known {
            Some(known) => Span::point(known.into()),
            None => Span { low: 0, high: 1 },
        };
        match node.op {
            Op::Input => panic!("{} is no port of the part", node.name),
            Op::Field { .. } => self.extremes[id].as_ref().expect("a field has extremes").over(arg(0)),
            Op::Constant(code) => Span::point(code),
            Op::Clamp { low, high } => arg(0).map(|code| code.clamp(low, high)),
            Op::Add => {
                let (a, b) = (aligned(0), aligned(1));
                let plain = Span { low: a.low + b.low, high: a.high + b.high };
                let between = self.blends[id].and_then(|blend| self.between(node, blend, block));
                between.map_or(plain, |between| Span {
                    low: plain.low.max(between.low),
                    high: plain.high.min(between.high),
                })
            }
            Op::Sub => {
                let (a, b) = (aligned(0), aligned(1));
                let plain = Span { low: a.low - b.high, high: a.high - b.low };
                let related = self.complements[id].and_then(|complement| self.related(node, complement, block));
                related.map_or(plain, |related| Span {
                    low: plain.low.max(related.low),
                    high: plain.high.min(related.high),
                })
            }
            Op::Mul if node.args[0] == node.args[1] => {
                let a = arg(0);
                let squares = a.map(|code| code * code);
                let least = if a.contains(0) { 0 } else { squares.low.min(squares.high) };
                Span { low: least, high: squares.low.max(squares.high) }
            }
            Op::Mul => arg(0).times(arg(1)),
            Op::ShiftLeft => {
                let (a, by) = (arg(0), arg(1));
                a.map(|code| code << by.low).hull(a.map(|code| code << by.high))
            }
            Op::ShiftRight => {
                let (a, by) = (arg(0), arg(1));
                let shifted = |by: i128| a.map(|code| code >> by.min(127));
                shifted(by.low).hull(shifted(by.high))
            }
            Op::Cast if node.format.frac_bits >= frac(0) => aligned(0),
            Op::Cast => arg(0).map(|code| code >> (frac(0) - node.format.frac_bits)),
            Op::Scale => arg(0),
            Op::NonZero => flag(match arg(0) {
                span if span == Span::point(0) => Some(false),
                span if !span.contains(0) => Some(true),
                _ => None,
            }),
            Op::Greater => {
                let (a, b) = (arg(0), arg(1));
                flag(if a.low > b.high {
                    Some(true)
                } else if a.high <= b.low {
                    Some(false)
                } else {
                    None
                })
            }
            Op::Or => {
                let (a, b) = (arg(0), arg(1));
                Span { low: a.low.max(b.low), high: a.high.max(b.high) }
            }
            Op::Not => Span { low: 1 - arg(0).high, high: 1 - arg(0).low },
            Op::Select => match arg(0) {
                span if span == Span::point(1) => arg(1),
                span if span == Span::point(0) => arg(2),
                _ => arg(1).hull(arg(2)),
            },
            Op::ZeroIf => match arg(0) {
                span if span == Span::point(1) => Span::point(0),
                span if span == Span::point(0) => arg(1),
                _ => arg(1).hull(Span::point(0)),
            },
        }
    }

    /// What lies between a and c, where nothing of `a + (c - a) t` is taken modulo a width and t is in [0, 1].
    fn between(&self, node: &Node, Blend { a, c, apart, t, part }: Blend, block: &Block) -> Option<Span> {
        let one = 1i128.checked_shl(self.graph.nodes[t].format.frac_bits.try_into().ok()?)?;
        let untouched = |id: NodeId| block.exact[id].fits(self.graph.nodes[id].format);
        let is_one = untouched(apart) && untouched(part) && Span { low: 0, high: one }.holds(block.codes[t]);
        is_one.then(|| self.aligned(a, node.format, block).hull(self.aligned(c, node.format, block)))
    }

    /// `x + c - floor(x p) = x (1 - p) + c + (x p - floor(x p))`, where nothing of it is taken modulo a width; in units
    /// of the node's last bit.
    fn related(&self, node: &Node, complement: Complement, block: &Block) -> Option<Span> {
        let format = |id: NodeId| self.graph.nodes[id].format;
        let Complement { product, x, p, floor, added } = complement;
        let untouched = |id: NodeId| block.exact[id].fits(format(id));
        if ![product, floor, node.args[0]].into_iter().all(untouched) {
            return None;
        }
        // All in units of the product's last bit.
        let unit = format(product).frac_bits;
        let rest = match p {
            Factor::Node(p) => {
                let one = 1i128.checked_shl(format(p).frac_bits.try_into().ok()?)?;
                Span { low: one - block.codes[p].high, high: one - block.codes[p].low }
            }
            Factor::Power(down) => Span::point(1i128.checked_shl(down)? - 1),
        };
        let product = block.codes[x].times(rest);
        let lost = (1i128 << (unit - format(floor).frac_bits).max(0)) - 1;
        let shift = unit - node.format.frac_bits;
        if shift < 0 {
            return None;
        }
        let constant = match added {
            Some(id) => block.codes[id].low << (unit - format(id).frac_bits),
            None => 0,
        };
        let (low, high) = (product.low + constant, product.high + constant + lost);
        // The value is a multiple of the node's last bit: the ends round inwards.
        let last = (1i128 << shift) - 1;
        Some(Span { low: (low + last) >> shift, high: high >> shift })
    }
}

/// What hardware keeps of a span of exact values.
pub(super) fn wrapped(exact: Span, format: Format) -> Span {
    if exact.fits(format) {
        return exact;
    }
    let codes = exact.map(|code| format.wrap(code));
    // Within one period of the wrapping the order stays.
    if exact.count() <= 1 << format.width() && codes.low <= codes.high {
        return codes;
    }
    Span { low: format.min_code(), high: format.max_code() }
}
