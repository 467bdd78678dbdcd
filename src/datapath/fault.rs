//! Faults planted in a core, to see whether a check finds them.
//!
//! A [`Fault`] changes the function of one operation; [`Probe`] says for many inputs at a time whether an output shows it. A [`Timing`]
//! changes a pipeline register or the valid chain: only the [simulation](super::simulate) shows it, clock by clock. Both are a
//! [`Defect`].

use std::ops::Range;

use multiversion::multiversion;

use super::evaluate::{Arg, LANES, Lane, codes_by_address, is_narrow, step, wrap};
use super::graph::{Graph, Node, NodeId, Op};
use super::schedule::Schedule;
use crate::fixed::Table;

/// What a fault does to the value of a node. Every result is taken modulo the width of the node's format.
#[derive(Clone, Debug, PartialEq)]
pub enum Change {
    /// A bit, from 0 for the least significant, that is always 0 or always 1.
    Stuck {
        /// Which bit.
        bit: u32,
        /// Always 1.
        high: bool,
    },
    /// A bit that is inverted.
    Flipped {
        /// Which bit.
        bit: u32,
    },
    /// So many codes more.
    Offset(i128),
    /// Bits dropped by a cast or a shift to the right round to the nearest code, halves up, in place of down.
    Nearest,
    /// Bits dropped by a cast or a shift to the right round up.
    Up,
    /// A comparison that holds for equal arguments too.
    OrEqual,
    /// Another operation on other arguments, which come before the node; the format stays.
    Instead {
        /// The operation.
        op: Op,
        /// The arguments.
        args: Vec<NodeId>,
    },
    /// A field of a memory read so many words further on, past the last word from the first again.
    Address(i64),
    /// A bit of a field's word at one address that is inverted when the memory comes up.
    Word {
        /// The address.
        address: usize,
        /// Which bit of the field.
        bit: u32,
    },
}

/// A change of one operation.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// The node whose value is changed.
    pub node: NodeId,
    /// How.
    pub change: Change,
}

impl Fault {
    /// The node's operation and arguments with the fault in it.
    pub(super) fn operation(&self, graph: &Graph) -> Node {
        let node = &graph.nodes[self.node];
        match &self.change {
            Change::Instead { op, args } => Node { op: *op, args: args.clone(), ..node.clone() },
            _ => node.clone(),
        }
    }

    /// How many words further on the node reads.
    pub(super) fn words_on(&self) -> i64 {
        if let Change::Address(by) = self.change { by } else { 0 }
    }

    /// The node's code, given the code that its operation gives for the arguments' codes.
    pub(super) fn code(&self, graph: &Graph, args: &[i128], right: i128) -> i128 {
        let node = &graph.nodes[self.node];
        let mut result = [right];
        alter(&self.change, graph, node, |arg| &args[arg..=arg], &mut result);
        node.format.wrap(result[0])
    }
}

/// The bits that a cast or a shift by `amount` drops.
fn dropped<L: Lane>(graph: &Graph, node: &Node, amount: Option<L>) -> usize {
    let bits = match amount {
        Some(amount) => i64::from(amount.to_output()),
        None => i64::from(graph.nodes[node.args[0]].format.frac_bits - node.format.frac_bits),
    };
    bits.clamp(0, i64::from(2 * L::HALF) - 2) as usize
}

/// Changes values in place; [`Change::Instead`] and [`Change::Address`] are not done here but in place of the operation.
#[inline(always)]
fn alter<'a, L: Lane + 'a>(
    change: &Change,
    graph: &Graph,
    node: &Node,
    arg: impl Fn(usize) -> &'a [L],
    result: &mut [L],
) {
    match change {
        Change::Stuck { bit, high } => {
            let mask = L::one() << *bit as usize;
            for value in result {
                *value = if *high { *value | mask } else { *value & !mask };
            }
        }
        Change::Flipped { bit } => {
            let mask = L::one() << *bit as usize;
            for value in result {
                *value = *value ^ mask;
            }
        }
        Change::Offset(by) => {
            let by = L::from_code(*by);
            for value in result {
                *value = value.wrapping_add(&by);
            }
        }
        Change::Nearest | Change::Up => {
            let shifts = matches!(node.op, Op::ShiftRight).then(|| arg(1));
            for (lane, (value, &from)) in result.iter_mut().zip(arg(0)).enumerate() {
                let bits = dropped(graph, node, shifts.map(|shifts| shifts[lane]));
                let rest = from & ((L::one() << bits).wrapping_sub(&L::one()));
                let up = match change {
                    Change::Up => rest != L::zero(),
                    _ => bits > 0 && rest >> (bits - 1) != L::zero(),
                };
                *value = if up { value.wrapping_add(&L::one()) } else { *value };
            }
        }
        Change::OrEqual => {
            for ((value, a), b) in result.iter_mut().zip(arg(0)).zip(arg(1)) {
                *value = if a == b { L::one() } else { *value };
            }
        }
        Change::Word { address, bit } => {
            let mask = L::one() << *bit as usize;
            for (value, at) in result.iter_mut().zip(arg(0)) {
                *value = if at.to_code() as usize == *address { *value ^ mask } else { *value };
            }
        }
        Change::Address(_) | Change::Instead { .. } => {}
    }
}

/// A change of a node's pipeline register; the registers count from 0 at the end of the stage in which the node is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Registered {
    /// It is left out: whoever reads its output or a later register's has the value a clock early.
    Missing,
    /// There is one more behind it: whoever reads its output or a later register's has the value a clock late.
    Doubled,
    /// It takes its input at every clock, whatever `ce` is.
    FreeRunning,
}

/// A change that only time shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Timing {
    /// Of a pipeline register.
    Register {
        /// The node whose value it holds.
        node: NodeId,
        /// Which of its registers.
        register: usize,
        /// How.
        what: Registered,
    },
    /// The valid chain takes `in_valid` at every clock, whatever `ce` is.
    ValidFreeRunning,
    /// `out_valid` comes a clock early.
    ValidEarly,
    /// `out_valid` comes a clock late.
    ValidLate,
    /// `out_valid` is inverted.
    ValidInverted,
    /// The valid chain takes 1, whatever `in_valid` is.
    ValidAlways,
    /// The reset does nothing.
    ResetIgnored,
    /// The reset acts only while `ce` is 1.
    ResetNeedsEnable,
    /// The reset clears only the last stage of the valid chain.
    ResetOfLastStage,
}

/// The graph with a copy of a node, which is read from behind one of its registers on: what a mistake in that register can change.
#[must_use]
pub fn with_copy(graph: &Graph, schedule: &Schedule, node: NodeId, register: usize) -> (Graph, NodeId) {
    graph.with_copy(node, |id| schedule.stage[id] > schedule.stage[node] + register as u32)
}

/// Something wrong with a core.
#[derive(Clone, Debug, PartialEq)]
pub enum Defect {
    /// With what it computes.
    Value(Fault),
    /// With when.
    Timing(Timing),
}

/// Inputs side by side.
#[derive(Clone, Debug)]
pub struct Block {
    /// The codes of each input port, in the graph's order.
    pub ports: Vec<[i64; LANES]>,
    /// How many of them count, from the first.
    pub count: usize,
}

impl Block {
    /// The most inputs of a block.
    pub const LANES: usize = LANES;

    /// No inputs, for a graph with so many ports.
    #[must_use]
    pub fn new(ports: usize) -> Self {
        Self { ports: vec![[0; LANES]; ports], count: 0 }
    }

    /// One more.
    ///
    /// # Panics
    /// If there are 64 already.
    pub fn push(&mut self, inputs: &[i64]) {
        for (port, &code) in self.ports.iter_mut().zip(inputs) {
            port[self.count..].fill(code);
        }
        self.count += 1;
    }

    /// The codes at one of them.
    #[must_use]
    pub fn inputs(&self, lane: usize) -> Vec<i64> {
        self.ports.iter().map(|port| port[lane]).collect()
    }
}

/// What finds out which inputs show which faults.
#[derive(Clone, Debug)]
pub struct Probe<'a> {
    graph: &'a Graph,
    /// The codes by address of each field.
    looked_up: Vec<Vec<i128>>,
    /// Whether a node reads a port itself.
    reads_port: Vec<bool>,
    /// Whether a node or one that depends on it does.
    leads_to_port: Vec<bool>,
    /// The bits of each node that any reader takes.
    read: Vec<Range<u32>>,
    narrow: bool,
}

/// What a run of a probe asks for and gives.
pub trait Hunt {
    /// Fills the block with the next inputs; false if there are no more.
    fn next(&mut self, block: &mut Block) -> bool;

    /// Some inputs of the block, a bit each, show the fault of this place. False if nothing more is to be told of it.
    fn shown(&mut self, place: usize, lanes: u64, block: &Block) -> bool;
}

impl<'a> Probe<'a> {
    /// Prepares a graph.
    #[must_use]
    pub fn new(graph: &'a Graph, tables: &[Table]) -> Self {
        let is_port = |&id: &NodeId| graph.nodes[id].op == Op::Input;
        let reads_port: Vec<bool> =
            graph.nodes.iter().map(|node| node.op == Op::Input || node.args.iter().any(is_port)).collect();
        let mut leads_to_port = reads_port.clone();
        for (id, node) in graph.nodes.iter().enumerate().rev() {
            if leads_to_port[id] {
                node.args.iter().for_each(|&arg| leads_to_port[arg] = true);
            }
        }
        let looked_up = graph.nodes.iter().map(|node| codes_by_address(node, tables)).collect();
        let read = read_bits(graph);
        Self { graph, looked_up, reads_port, leads_to_port, read, narrow: is_narrow(graph) }
    }

    /// Looks, in every block of the hunt's inputs, for every fault that is still hunted.
    pub fn run(&self, faults: &[&Fault], hunt: &mut dyn Hunt) {
        if self.narrow {
            hunt_narrow(self, faults, hunt);
        } else {
            hunt_in::<i128>(self, faults, hunt);
        }
    }

    /// Whether a fault may show where nothing but the ports' codes differs from inputs at which it does not.
    fn sees_port(&self, fault: &Fault) -> bool {
        let reads = |args: &[NodeId]| args.iter().any(|&arg| self.graph.nodes[arg].op == Op::Input);
        self.leads_to_port[fault.node] || matches!(&fault.change, Change::Instead { args, .. } if reads(args))
    }
}

/// The bits of each node that any reader takes: a cast drops low and high ones.
fn read_bits(graph: &Graph) -> Vec<Range<u32>> {
    let mut read: Vec<Option<Range<u32>>> = vec![None; graph.nodes.len()];
    let mut add = |id: NodeId, bits: Range<u32>| {
        read[id] = Some(match read[id].take() {
            Some(known) => known.start.min(bits.start)..known.end.max(bits.end),
            None => bits,
        });
    };
    for node in &graph.nodes {
        for &arg in &node.args {
            let dropped = graph.nodes[arg].format.frac_bits - node.format.frac_bits;
            add(
                arg,
                match (node.op, u32::try_from(dropped)) {
                    (Op::Cast, Ok(dropped)) => dropped..dropped + node.format.width(),
                    _ => 0..u32::MAX,
                },
            );
        }
    }
    graph.outputs.iter().for_each(|&(_, id)| add(id, 0..u32::MAX));
    read.into_iter().map(Option::unwrap_or_default).collect()
}

#[multiversion(targets("x86_64+avx2", "aarch64+neon"))]
fn hunt_narrow(probe: &Probe, faults: &[&Fault], hunt: &mut dyn Hunt) {
    hunt_in::<i64>(probe, faults, hunt);
}

/// A node's column, by the operation that it has or another in its place; a field is read so many words on.
#[inline(always)]
fn compute<L: Lane>(
    probe: &Probe,
    id: NodeId,
    node: &Node,
    words_on: i64,
    columns: &[[L; LANES]],
    result: &mut [L; LANES],
) {
    // A fault may be in a constant: it has a column like any other node.
    let arg = |index: usize| Arg::Column(node.args[index]);
    match node.op {
        Op::Constant(code) => result.fill(L::from_code(code)),
        Op::Field { .. } => {
            let codes = &probe.looked_up[id];
            for (value, address) in result.iter_mut().zip(&columns[node.args[0]]) {
                // A fault in the address may leave it wider than the memory is deep.
                *value = L::from_code(codes[(address.to_code() as i64 + words_on) as usize & (codes.len() - 1)]);
            }
        }
        _ => {
            step(probe.graph, node, &[], arg, columns, result);
            // Faults lead values out of the ranges that let other operations do without.
            wrap(result, node.format);
        }
    }
}

#[inline(always)]
fn hunt_in<L: Lane>(probe: &Probe, faults: &[&Fault], hunt: &mut dyn Hunt) {
    let graph = probe.graph;
    let nodes = &graph.nodes;
    let mut columns = vec![[L::zero(); LANES]; nodes.len()];
    for (column, node) in columns.iter_mut().zip(nodes) {
        if let Op::Constant(code) = node.op {
            column.fill(L::from_code(node.format.wrap(code)));
        }
    }
    let operations: Vec<Node> = faults.iter().map(|fault| fault.operation(graph)).collect();
    let sees_port: Vec<bool> = faults.iter().map(|fault| probe.sees_port(fault)).collect();
    // What changes a bit that nothing reads never shows.
    let is_read = |&place: &usize| match faults[place] {
        Fault { node, change: Change::Stuck { bit, .. } | Change::Flipped { bit } } => probe.read[*node].contains(bit),
        _ => true,
    };
    let mut hunted: Vec<usize> = (0..faults.len()).filter(is_read).collect();
    let mut first = true;
    let mut kept: Vec<(NodeId, [L; LANES])> = Vec::new();
    let mut differs = vec![false; nodes.len()];
    let mut block = Block::new(graph.inputs.len());
    // For each node the bits that are 1 in any and in every lane, and in which block: most stuck bits are seen to be as they should at once.
    let mut ends = vec![(0u64, L::zero(), L::zero()); nodes.len()];
    let mut number = 0;
    while !hunted.is_empty() && hunt.next(&mut block) {
        for (&port, codes) in graph.inputs.iter().zip(&block.ports) {
            for (value, &code) in columns[port].iter_mut().zip(codes) {
                *value = L::from_code(code.into());
            }
        }
        number += 1;
        // As long as nothing that reads a port has changed, nothing else has.
        let mut changed = first;
        first = false;
        let lanes = if block.count < LANES { (1u64 << block.count) - 1 } else { u64::MAX };
        // First without a fault, then with each: one loop, as what it calls becomes part of it.
        let mut done = 0;
        let mut pass = None;
        loop {
            let fault = pass.map(|place: usize| faults[place]);
            let mut shown = 0u64;
            let seen = match fault {
                None => true,
                Some(_) if !changed && !sees_port[pass.unwrap_or_default()] => false,
                Some(Fault { node, change: Change::Stuck { bit, high } }) => {
                    let id = *node;
                    if ends[id].0 != number {
                        let both = |(any, every), &value: &L| (any | value, every & value);
                        let (any, every) = columns[id].iter().fold((L::zero(), !L::zero()), both);
                        ends[id] = (number, any, every);
                    }
                    let (_, any, every) = ends[id];
                    let is_so = if *high { every } else { !any };
                    is_so >> *bit as usize & L::one() == L::zero()
                }
                Some(_) => true,
            };
            if seen {
                let begin = fault.map_or(0, |fault| fault.node);
                for (id, own) in nodes.iter().enumerate().skip(begin) {
                    let here = fault.filter(|fault| fault.node == id);
                    let computed = match fault {
                        None => !matches!(own.op, Op::Input | Op::Constant(_)) && (changed || probe.reads_port[id]),
                        Some(_) => here.is_some() || own.args.iter().any(|&arg| differs[arg]),
                    };
                    if !computed {
                        continue;
                    }
                    let instead =
                        here.is_none_or(|fault| matches!(fault.change, Change::Instead { .. } | Change::Address(_)));
                    let mut result = columns[id];
                    if instead {
                        let node = if here.is_some() { &operations[pass.unwrap_or_default()] } else { own };
                        compute(probe, id, node, here.map_or(0, Fault::words_on), &columns[..id], &mut result);
                    } else if let Some(fault) = here {
                        alter(&fault.change, graph, own, |arg| &columns[own.args[arg]][..], &mut result);
                        wrap(&mut result, own.format);
                    }
                    if fault.is_none() {
                        changed |= probe.reads_port[id] && result != columns[id];
                        columns[id] = result;
                    } else if result != columns[id] {
                        kept.push((id, std::mem::replace(&mut columns[id], result)));
                        differs[id] = true;
                    } else if here.is_some() {
                        break;
                    }
                }
            }
            for (id, right) in kept.drain(..) {
                if graph.is_output(id) {
                    for lane in 0..LANES {
                        shown |= u64::from(columns[id][lane] != right[lane]) << lane;
                    }
                }
                columns[id] = right;
                differs[id] = false;
            }
            if let Some(place) = pass {
                if shown & lanes != 0 && !hunt.shown(place, shown & lanes, &block) {
                    hunted.remove(done);
                } else {
                    done += 1;
                }
            }
            let Some(&next) = hunted.get(done) else { break };
            pass = Some(next);
        }
    }
}
