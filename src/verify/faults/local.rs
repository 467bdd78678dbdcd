//! Proofs that a change of an operation does not show, from a part of the graph.
//!
//! - A bit that is the same for all inputs may be stuck at what it is.
//! - A value that changes in its lowest bits only, which are dropped behind before anything but them depends on them,
//!   may; likewise in its highest.
//! - *Cuts*: the values of a few nodes, few together, are taken as free, and if none of them lets the change show in
//!   anything that is computed from them alone and read by the rest, no input does.
//!
//! The values that a node may take come from the interval analysis of the graph, row by row.

use rayon::prelude::*;

use super::domain::{Domain, first_detected};
use crate::core::Design;
use crate::datapath::fault::{Change, Fault};
use crate::datapath::graph::{Graph, Node, NodeId, Op};
use crate::datapath::range::{Analysis, Span};
use crate::fixed::Table;

/// The most values of a cut of a shader, as a power of two, and of a lobe, all of whose inputs can be run for all
/// mutants at once.
const MOST_CUT_BITS: u32 = 22;
const MOST_LOBE_CUT_BITS: u32 = 14;

/// What is known of a graph's values.
pub(super) struct Local<'a> {
    graph: &'a Graph,
    tables: &'a [Table],
    most_bits: u32,
    /// The codes that each node may have.
    spans: Vec<Span>,
    /// For each node a number of last bits that are always 0.
    zeros: Vec<u32>,
}

impl<'a> Local<'a> {
    pub(super) fn of(design: &'a Design) -> Self {
        let (graph, tables) = (design.graph(), design.tables());
        let analysis = Analysis::new(graph, tables);
        let rows: Vec<Vec<Span>> = design.regions().par_iter().map(|region| analysis.codes(region)).collect();
        let hull = |id: NodeId| rows.iter().map(|row| row[id]).reduce(Span::hull).expect("a row");
        let most_bits = if design.is_sampled() { MOST_CUT_BITS } else { MOST_LOBE_CUT_BITS };
        Self { graph, tables, most_bits, spans: (0..graph.nodes.len()).map(hull).collect(), zeros: zeros(graph) }
    }

    /// Why a change does not show, if that is found.
    pub(super) fn proof(&self, fault: &Fault) -> Option<String> {
        self.by_constant_bit(fault)
            .or_else(|| self.by_dropped_bits(fault))
            .or_else(|| self.by_lost_bits(fault))
            .or_else(|| self.by_own_value(fault))
            .or_else(|| self.by_values_before(fault))
    }

    fn by_constant_bit(&self, fault: &Fault) -> Option<String> {
        let Change::Stuck { bit, high } = fault.change else { return None };
        let Span { low, high: top } = self.spans[fault.node];
        let is_so = low >> bit == top >> bit && (low >> bit & 1 == 1) == high;
        is_so.then(|| format!("the value lies between {low} and {top}"))
    }

    /// What a change makes of the results that it changes, where these are few: the right one and the wrong one.
    fn pairs(&self, fault: &Fault) -> Option<Vec<[i128; 2]>> {
        let Change::Instead { op: Op::Clamp { low, high }, args } = &fault.change else { return None };
        let node = &self.graph.nodes[fault.node];
        let Op::Clamp { low: right_low, high: right_high } = node.op else { return None };
        let from = self.spans[node.args[0]];
        let near = |bound: i128| (-1..=1).map(move |by| bound + by);
        let codes = near(right_low).chain(near(right_high)).chain([from.low, from.high]);
        let codes = codes.filter(|&code| *args == node.args && from.contains(code));
        let pair = |code: i128| [code.clamp(right_low, right_high), node.format.wrap(code.clamp(*low, *high))];
        let mut pairs: Vec<[i128; 2]> = codes.map(pair).filter(|[right, wrong]| right != wrong).collect();
        pairs.sort_unstable();
        pairs.dedup();
        (*args == node.args).then_some(pairs)
    }

    /// The lowest bits in which a change may change its node's value.
    fn changed_bits(&self, fault: &Fault) -> Option<u32> {
        match fault.change {
            Change::Stuck { bit, .. } | Change::Flipped { bit } => Some(bit + 1),
            _ => self.pairs(fault)?.iter().map(|[right, wrong]| i128::BITS - (right ^ wrong).leading_zeros()).max(),
        }
    }

    fn by_dropped_bits(&self, fault: &Fault) -> Option<String> {
        let nodes = &self.graph.nodes;
        let most = self.changed_bits(fault)?;
        // For each node the lowest bits in which it may be another.
        let mut differs = vec![0u32; nodes.len()];
        differs[fault.node] = most;
        for (id, node) in nodes.iter().enumerate().skip(fault.node) {
            if id > fault.node && node.args.iter().any(|&arg| differs[arg] > 0) {
                differs[id] = self.passed_on(node, &differs)?;
            }
            // A sign that changes changes every bit above it.
            if node.format.signed && differs[id] >= node.format.width() {
                return None;
            }
            if differs[id] > 0 && self.graph.is_output(id) {
                return None;
            }
        }
        Some(format!("only its last {most} bits change, and these are dropped"))
    }

    /// The lowest bits in which a node's value may differ, given those of its arguments; `None` if that may be all.
    fn passed_on(&self, node: &Node, differs: &[u32]) -> Option<u32> {
        let arg = |place: usize| differs[node.args[place]];
        let zeros = |place: usize| self.zeros[node.args[place]];
        let shift = |place: usize| node.format.frac_bits - self.graph.nodes[node.args[place]].format.frac_bits;
        let up = |place: usize| shift(place).max(0) as u32;
        match node.op {
            Op::Scale => Some(arg(0)),
            Op::Cast => Some(arg(0).saturating_add_signed(shift(0)) * u32::from(arg(0) > 0)),
            // What is 0 in these bits adds no carry.
            Op::Add | Op::Sub if arg(1) == 0 => {
                let bits = arg(0) + up(0);
                (zeros(1) + up(1) >= bits).then_some(bits)
            }
            Op::Add if arg(0) == 0 => {
                let bits = arg(1) + up(1);
                (zeros(0) + up(0) >= bits).then_some(bits)
            }
            Op::Clamp { low, high } => {
                let is_multiple = |bound: i128| arg(0) < i128::BITS && bound & ((1 << arg(0)) - 1) == 0;
                (is_multiple(low) && is_multiple(high)).then_some(arg(0))
            }
            Op::ZeroIf if arg(0) == 0 => Some(arg(1)),
            Op::Select if arg(0) == 0 => Some(arg(1).max(arg(2))),
            _ => None,
        }
    }

    /// Of sums, differences and products only so many of the lowest bits depend on as many of the operands'.
    fn by_lost_bits(&self, fault: &Fault) -> Option<String> {
        let nodes = &self.graph.nodes;
        let (Change::Stuck { bit, .. } | Change::Flipped { bit }) = fault.change else { return None };
        // For each node the lowest bits that are right; all of them where there is nothing.
        let mut right: Vec<Option<u32>> = vec![None; nodes.len()];
        right[fault.node] = Some(bit);
        for (id, node) in nodes.iter().enumerate().skip(fault.node) {
            if id > fault.node && node.args.iter().any(|&arg| right[arg].is_some()) {
                let aligned = |place: usize| {
                    let arg = node.args[place];
                    let shift = node.format.frac_bits - nodes[arg].format.frac_bits;
                    right[arg].map(|bits| bits.saturating_add_signed(shift))
                };
                let all = (0..node.args.len()).filter_map(aligned).min();
                let bits = match node.op {
                    Op::Add | Op::Sub | Op::Cast => all?,
                    Op::Mul | Op::Scale => node.args.iter().filter_map(|&arg| right[arg]).min()?,
                    _ => return None,
                };
                right[id] = Some(bits).filter(|&bits| bits < node.format.width());
            }
            if right[id].is_some() && self.graph.is_output(id) {
                return None;
            }
        }
        Some(format!("no sum behind has room for bit {bit}"))
    }

    /// From every value of the node itself, or every one that changes, alone and with one other.
    fn by_own_value(&self, fault: &Fault) -> Option<String> {
        let (graph, copy) = self.graph.with_copy(fault.node, |_| true);
        let moved = |id: NodeId| if id > fault.node { id + 1 } else { id };
        let node = fault.node;
        let changes: Vec<(Span, Change)> = match &fault.change {
            change @ (Change::Stuck { .. } | Change::Flipped { .. } | Change::Offset(_)) => {
                vec![(self.spans[node], change.clone())]
            }
            _ => {
                let pairs = self.pairs(fault)?;
                pairs.into_iter().map(|[right, wrong]| (Span::point(right), Change::Offset(wrong - right))).collect()
            }
        };
        let values = changes.iter().map(|(span, _)| span.count()).max()?;
        let is_free = |&id: &NodeId| id != node && !self.spans[id].is_point();
        let behind = behind(self.graph, node);
        let others = (0..behind.len()).filter(|id| is_free(id) && !behind[*id]);
        let mut cuts: Vec<Vec<NodeId>> = vec![vec![]];
        cuts.extend(others.map(|id| vec![id]));
        let first = self.graph.index();
        cuts.extend(cuts.clone().into_iter().skip(1).filter(|cut| cut[0] != first).map(|cut| vec![first, cut[0]]));
        self.sort(&mut cuts, values);
        cuts.into_iter().find_map(|others| {
            let mut cut = vec![node];
            cut.extend(others.iter().map(|&id| moved(id)));
            let same = changes.iter().all(|(span, change)| {
                let fault = Fault { node: copy, change: change.clone() };
                let mut spans = vec![*span];
                spans.extend(others.iter().map(|&id| self.spans[id]));
                self.is_same(&graph, &cut, &spans, &fault)
            });
            same.then(|| self.said(std::iter::once(node).chain(others)))
        })
    }

    /// From every value of one or two nodes before it.
    fn by_values_before(&self, fault: &Fault) -> Option<String> {
        let graph = self.graph;
        let mut above = vec![false; graph.nodes.len()];
        above[fault.node] = true;
        if let Change::Instead { args, .. } = &fault.change {
            args.iter().for_each(|&arg| above[arg] = true);
        }
        for id in (0..=fault.node).rev() {
            if above[id] {
                graph.nodes[id].args.iter().for_each(|&arg| above[arg] = true);
            }
        }
        let is_free = |id: NodeId| !self.spans[id].is_point();
        let own = graph.nodes[fault.node].args.iter().copied().filter(|&arg| is_free(arg)).collect();
        let mut cuts: Vec<Vec<NodeId>> = vec![own];
        // What the first port selects goes with any other value, as a lobe's shininess does.
        let index = graph.index();
        let others = (0..fault.node).filter(|&id| above[id] && is_free(id) && id != index);
        cuts.push(vec![index]);
        cuts.extend(others.clone().map(|id| vec![id]));
        cuts.extend(others.map(|id| vec![index, id]));
        cuts.retain(|cut| !cut.is_empty());
        self.sort(&mut cuts, 1);
        cuts.into_iter().find_map(|mut cut| {
            cut.sort_unstable();
            cut.dedup();
            let spans: Vec<Span> = cut.iter().map(|&id| self.spans[id]).collect();
            self.is_same(graph, &cut, &spans, fault).then(|| self.said(cut))
        })
    }

    fn said(&self, cut: impl IntoIterator<Item = NodeId>) -> String {
        let names: Vec<&str> = cut.into_iter().map(|id| self.graph.nodes[id].name.as_str()).collect();
        format!("no value of {} shows it", names.join(" and "))
    }

    /// Leaves out cuts with too many values, with `values` of another node beside, and puts those with few first.
    fn sort(&self, cuts: &mut Vec<Vec<NodeId>>, values: u128) {
        let count = |cut: &Vec<NodeId>| {
            cut.iter().map(|&id| self.spans[id].count()).fold(values, |count, other| count.saturating_mul(other))
        };
        cuts.retain(|cut| count(cut) <= 1 << self.most_bits);
        cuts.sort_by_key(count);
    }

    /// Whether a fault shows for no values, within these spans, of the nodes of a cut, or of these and the flags that
    /// choose what is read of what they decide.
    fn is_same(&self, graph: &Graph, cut: &[NodeId], spans: &[Span], fault: &Fault) -> bool {
        let is_narrow = |span: &Span| i64::try_from(span.low).is_ok() && i64::try_from(span.high).is_ok();
        let shows = |cut: &[NodeId], spans: &[Span]| {
            let (part, moved) = part_behind(graph, cut, fault)?;
            let domain = Domain::of(spans.to_vec());
            let total = domain.count().filter(|&total| total <= 1 << self.most_bits && spans.iter().all(is_narrow))?;
            Some(first_detected(&part, self.tables, &domain, total, &[&moved])[0].is_some())
        };
        match shows(cut, spans) {
            None => false,
            Some(false) => true,
            Some(true) => {
                let (inside, behind) = (inside(graph, cut), behind(graph, fault.node));
                let gate = |node: &Node| {
                    let flag = matches!(node.op, Op::ZeroIf | Op::Select).then(|| node.args[0])?;
                    let chooses = node.args[1..].iter().any(|&arg| inside[arg]);
                    (chooses && !inside[flag] && !behind[flag]).then_some(flag)
                };
                let mut gates: Vec<NodeId> = graph.nodes.iter().filter_map(gate).collect();
                gates.sort_unstable();
                gates.dedup();
                let with_gates = [cut, &gates].concat();
                let flags = std::iter::repeat_n(Span { low: 0, high: 1 }, gates.len());
                let spans: Vec<Span> = spans.iter().copied().chain(flags).collect();
                !gates.is_empty() && shows(&with_gates, &spans) == Some(false)
            }
        }
    }
}

/// For each node a number of last bits that are 0 whatever the inputs are.
fn zeros(graph: &Graph) -> Vec<u32> {
    let mut zeros: Vec<u32> = Vec::with_capacity(graph.nodes.len());
    for node in &graph.nodes {
        let arg = |place: usize| zeros[node.args[place]];
        let shift = |place: usize| node.format.frac_bits - graph.nodes[node.args[place]].format.frac_bits;
        let aligned = |place: usize| arg(place).saturating_add_signed(shift(place));
        let width = node.format.width();
        let found = match node.op {
            Op::Constant(code) => code.trailing_zeros(),
            Op::Clamp { low, high } => arg(0).min(low.trailing_zeros()).min(high.trailing_zeros()),
            Op::Add | Op::Sub => aligned(0).min(aligned(1)),
            Op::Mul => arg(0) + arg(1),
            Op::ShiftLeft | Op::Scale => arg(0),
            Op::Cast => aligned(0),
            Op::Select => arg(1).min(arg(2)),
            Op::ZeroIf => arg(1),
            _ => 0,
        };
        zeros.push(found.min(width));
    }
    zeros
}

/// Which nodes depend on a node, itself included.
fn behind(graph: &Graph, node: NodeId) -> Vec<bool> {
    let mut behind = vec![false; graph.nodes.len()];
    for id in node..behind.len() {
        behind[id] = id == node || graph.nodes[id].args.iter().any(|&arg| behind[arg]);
    }
    behind
}

/// Which nodes some nodes alone decide.
fn inside(graph: &Graph, cut: &[NodeId]) -> Vec<bool> {
    let mut inside = vec![false; graph.nodes.len()];
    for (id, node) in graph.nodes.iter().enumerate() {
        inside[id] = cut.contains(&id) || (node.op != Op::Input && node.args.iter().all(|&arg| inside[arg]));
    }
    inside
}

/// The part of a graph that some nodes alone decide, these as ports in their order, what the rest reads of it as
/// outputs, with a fault in it; `None` if the fault is not in it.
fn part_behind(graph: &Graph, cut: &[NodeId], fault: &Fault) -> Option<(Graph, Fault)> {
    let inside = inside(graph, cut);
    let args: &[NodeId] = if let Change::Instead { args, .. } = &fault.change { args } else { &[] };
    if cut.contains(&fault.node) || !inside[fault.node] || !args.iter().all(|&arg| inside[arg]) {
        return None;
    }
    let mut place = vec![0; graph.nodes.len()];
    let mut nodes: Vec<Node> = Vec::new();
    for (id, node) in graph.nodes.iter().enumerate().filter(|(id, _)| inside[*id]) {
        place[id] = nodes.len();
        nodes.push(if cut.contains(&id) {
            Node { op: Op::Input, args: Vec::new(), ..node.clone() }
        } else {
            Node { args: node.args.iter().map(|&arg| place[arg]).collect(), ..node.clone() }
        });
    }
    let mut read_outside: Vec<bool> = (0..graph.nodes.len()).map(|id| graph.is_output(id)).collect();
    for (_, node) in graph.nodes.iter().enumerate().filter(|(id, _)| !inside[*id]) {
        node.args.iter().for_each(|&arg| read_outside[arg] = true);
    }
    let outputs = (0..graph.nodes.len()).filter(|&id| inside[id] && read_outside[id]);
    let outputs = outputs.map(|id| (graph.nodes[id].name.clone(), place[id])).collect();
    let inputs = cut.iter().map(|&id| place[id]).collect();
    let change = match &fault.change {
        Change::Instead { op, args } => Change::Instead { op: *op, args: args.iter().map(|&arg| place[arg]).collect() },
        other => other.clone(),
    };
    Some((Graph { nodes, inputs, outputs }, Fault { node: place[fault.node], change }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spec::SpecFields;
    use crate::verify::faults::mutants;

    const SPECS: [&str; 3] = [
        "method = \"quadratic\"\nshininess = \"1..=15\"\ninput_fraction = 8\noutput_fraction = 8\n",
        "method = \"cubic\"\nshininess = \"1..=15\"\ninput_fraction = 8\noutput_fraction = 8\n",
        "method = \"schlick\"\nshininess = \"1..=15\"\ninput_fraction = 8\noutput_fraction = 8\n",
    ];

    fn faults(design: &Design) -> Vec<Fault> {
        mutants(design, 0).iter().filter_map(|mutant| mutant.defect.fault().cloned()).collect()
    }

    /// The faults that are proved not to show, with the proof, and which of these show for some input.
    fn proved(design: &Design, local: &Local) -> (Vec<String>, usize) {
        let faults = faults(design);
        let proofs: Vec<(&Fault, String)> = faults.iter().filter_map(|f| Some((f, local.proof(f)?))).collect();
        let list: Vec<&Fault> = proofs.iter().map(|(fault, _)| *fault).collect();
        let inputs = Domain::whole(design.graph());
        let total = inputs.count().expect("few inputs");
        let shown = first_detected(design.graph(), design.tables(), &inputs, total, &list);
        (proofs.into_iter().map(|(_, proof)| proof).collect(), shown.iter().flatten().count())
    }

    #[test]
    fn what_is_proved_shows_for_no_input() {
        let mut all = Vec::new();
        for spec in SPECS {
            let spec = SpecFields::parse(spec, "test").and_then(SpecFields::resolve).expect("a spec");
            let design = Design::new(spec).expect("a design");
            let mut local = Local::of(&design);
            let (proofs, wrong) = proved(&design, &local);
            assert_eq!(wrong, 0);
            all.extend(proofs);
            // With values that a node does take left out, proofs are wrong, and that is seen.
            for span in &mut local.spans {
                span.high = span.low + (span.high - span.low) / 2;
            }
            assert!(proved(&design, &local).1 > 0);
        }
        for rule in ["the value lies between", "these are dropped", "no value of"] {
            assert!(all.iter().any(|proof| proof.contains(rule)), "{rule}");
        }
    }

    /// A small signed value and one with zeros in its place, of whose sum its bits are dropped: its sign is not.
    #[test]
    fn a_sign_is_not_dropped() {
        use crate::fixed::Format;
        let node = |op, args: &[NodeId], format, name: &str| Node {
            op,
            args: args.to_vec(),
            format,
            name: name.to_owned(),
            comment: String::new(),
        };
        let nodes = vec![
            node(Op::Input, &[], Format::signed(0, 4), "small"),
            node(Op::Constant(32), &[], Format::unsigned(2, 4), "two"),
            node(Op::Add, &[0, 1], Format::signed(3, 4), "sum"),
            node(Op::Cast, &[2], Format::signed(3, -1), "cut"),
        ];
        let graph = Graph { nodes, inputs: vec![0], outputs: vec![("out".to_owned(), 3)] };
        let spans = graph.nodes.iter().map(|node| Span::of(node.format)).collect();
        let zeros = zeros(&graph);
        let local = Local { graph: &graph, tables: &[], most_bits: 8, spans, zeros };
        let stuck = |bit| Fault { node: 0, change: Change::Stuck { bit, high: true } };
        assert!(local.by_dropped_bits(&stuck(3)).is_some());
        assert_eq!(local.proof(&stuck(4)), None);
    }

    /// A product of which only the lower half is read, and sums of which the last bits are dropped.
    #[test]
    fn bits_that_nobody_reads_are_found() {
        let node = |op, args: &[NodeId], width, frac_bits, name: &str| Node {
            op,
            args: args.to_vec(),
            format: crate::fixed::Format::unsigned(width - frac_bits, frac_bits),
            name: name.to_owned(),
            comment: String::new(),
        };
        let nodes = vec![
            node(Op::Input, &[], 4, 2, "a"),
            node(Op::Input, &[], 4, 2, "b"),
            node(Op::Mul, &[0, 1], 8, 4, "product"),
            node(Op::Constant(8), &[], 4, 4, "half"),
            node(Op::Add, &[2, 3], 6, 4, "sum"),
            node(Op::Cast, &[4], 3, 1, "cut"),
        ];
        let graph = Graph { nodes, inputs: vec![0, 1], outputs: vec![("out".to_owned(), 5)] };
        let spans = graph.nodes.iter().map(|node| Span::of(node.format)).collect();
        let zeros = zeros(&graph);
        assert_eq!(zeros[3], 3);
        let local = Local { graph: &graph, tables: &[], most_bits: 8, spans, zeros };
        let stuck = |node, bit| Fault { node, change: Change::Stuck { bit, high: true } };
        for (fault, rule) in [
            (stuck(2, 2), "only its last 3 bits"),
            (stuck(4, 2), "only its last 3 bits"),
            (stuck(2, 6), "no sum behind"),
            (stuck(2, 7), "no sum behind"),
        ] {
            assert!(local.proof(&fault).is_some_and(|proof| proof.contains(rule)), "{fault:?}");
        }
        // Bit 3 is added to a 1 and carries; bit 5 is the highest of the cut.
        for fault in [stuck(2, 3), stuck(2, 5), stuck(4, 3), stuck(5, 0)] {
            assert_eq!(local.proof(&fault), None, "{fault:?}");
        }
    }
}
