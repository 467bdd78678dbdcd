//! Formats as narrow as the ranges allow, and wider ones that show whether they are.

use super::{Analysis, Ranges, Span};
use crate::datapath::graph::{Graph, Node, NodeId, Op};
use crate::fixed::Format;

/// A value that got fewer bits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Narrowed {
    /// Its node's name.
    pub name: String,
    /// The format that the builder chose.
    pub from: Format,
    /// The format that it has now.
    pub to: Format,
}

impl Narrowed {
    /// The bits that were taken off.
    #[must_use]
    pub fn bits(&self) -> u32 {
        self.from.width() - self.to.width()
    }
}

impl Analysis<'_> {
    /// The graph with every format as narrow as the ranges allow: sums, differences, shifts and casts lose the integer
    /// bits that no needed value uses, and products those that their narrower operands leave idle. The function stays
    /// what it is for every input that `ranges` covers.
    #[must_use]
    pub fn narrowed(&self, ranges: &Ranges) -> (Graph, Vec<Narrowed>) {
        let mut graph = self.graph.clone();
        let fixed = self.fixed_formats();
        for (id, &fixed) in fixed.iter().enumerate() {
            let node = &graph.nodes[id];
            let format = |place: usize| graph.nodes[node.args[place]].format;
            let int_bits = match node.op {
                Op::Mul => Format::product([format(0), format(1)]).int_bits,
                Op::ZeroIf => format(1).int_bits,
                op if can_narrow(op) && !fixed && !ranges.undecided[id] => {
                    let span = ranges.needed[id].unwrap_or(Span::point(0)).hull(Span::point(0));
                    let bits = span.int_bits(node.format.frac_bits);
                    bits.clamp(1 - node.format.frac_bits, node.format.int_bits)
                }
                _ => node.format.int_bits,
            };
            graph.nodes[id].format.int_bits = int_bits;
        }
        let pairs = self.graph.nodes.iter().zip(&graph.nodes).filter(|(before, after)| before.format != after.format);
        let narrowed = |(before, after): (&Node, &Node)| Narrowed {
            name: after.name.clone(),
            from: before.format,
            to: after.format,
        };
        let narrowed = pairs.map(narrowed).collect();
        (graph, narrowed)
    }

    /// The graph with registers in which nothing can overflow unseen: sums, differences, products, shifts and casts get
    /// a sign and eight integer bits more, or as many as make them 62 bits wide, which are evaluated faster than more.
    /// Where no needed value leaves its format, its outputs are those of the graph itself; so running both over every
    /// input checks an analysis that found none. What casts drop on purpose, as `ranges` tells, they drop here too.
    #[must_use]
    pub fn with_spare_bits(&self, ranges: &Ranges) -> Graph {
        let mut graph = self.graph.clone();
        // An address beyond a memory would be none at all, and a flag is one bit: what makes these, through operations
        // that pass on what they get, stays.
        let mut stays = vec![false; graph.nodes.len()];
        for (id, node) in self.graph.nodes.iter().enumerate().rev() {
            let kept: &[NodeId] = match node.op {
                Op::Field { .. } | Op::Or | Op::Not => &node.args,
                Op::Scale | Op::ShiftRight | Op::Select | Op::ZeroIf if stays[id] => &node.args,
                Op::Select | Op::ZeroIf => &node.args[..1],
                _ => &[],
            };
            kept.iter().for_each(|&arg| stays[arg] = true);
        }
        // Two bits more than any value has are enough to see a carry out of it and its sign.
        let most = if graph.nodes.iter().all(|node| node.format.width() <= 59) { 61 } else { 126 };
        for (id, node) in graph.nodes.iter_mut().enumerate() {
            let widened = match node.op {
                _ if stays[id] => false,
                Op::Add | Op::Sub | Op::Mul | Op::ShiftLeft => true,
                Op::Cast => self.room[id].0 == node.format && matches!(ranges.dropped[id], None | Some(0)),
                _ => false,
            };
            if widened {
                let int_bits = (node.format.int_bits + SPARE_BITS).min(most - node.format.frac_bits);
                node.format = Format { signed: true, int_bits, ..node.format };
            }
        }
        graph
    }

    /// The nodes whose formats something else rests on: ports, addresses, operands of what only renames or shifts bits,
    /// of limits that are compared in the operand's width, and of a result that is a port.
    fn fixed_formats(&self) -> Vec<bool> {
        let graph = self.graph;
        let mut fixed: Vec<bool> = (0..graph.nodes.len()).map(|id| graph.is_output(id)).collect();
        for (id, node) in graph.nodes.iter().enumerate().rev() {
            let holds = match node.op {
                Op::Field { .. } | Op::Scale | Op::ShiftRight => true,
                Op::Clamp { low, .. } => low != 0,
                Op::ZeroIf => fixed[id],
                _ => false,
            };
            if holds {
                node.args.iter().for_each(|&arg| fixed[arg] = true);
            }
        }
        fixed
    }
}

/// What [`Analysis::with_spare_bits`] adds.
const SPARE_BITS: i32 = 8;

/// Operations whose result's format is the builder's choice.
pub(super) fn can_narrow(op: Op) -> bool {
    matches!(op, Op::Add | Op::Sub | Op::ShiftLeft | Op::Cast)
}
