//! Many faults of a graph on many inputs at a time: which inputs detect which.

use std::ops::Range;

use multiversion::multiversion;

use crate::core::Design;
use crate::datapath::evaluate::{Arg, LANES, Lane, codes_by_address, is_narrow, step, wrap};
use crate::datapath::fault::{Change, Fault, alter};
use crate::datapath::graph::{Graph, Node, NodeId, Op};
use crate::fixed::Table;

/// Inputs side by side.
#[derive(Clone, Debug)]
pub struct Block {
    /// The codes of each input port, in the graph's order.
    pub ports: Vec<[i64; LANES]>,
    /// How many of them count, from the first.
    pub count: usize,
    /// How many inputs the blocks before it had.
    pub before: u64,
}

impl Block {
    /// The most inputs of a block.
    pub const LANES: usize = LANES;

    /// No inputs, for a graph with so many ports.
    #[must_use]
    pub fn new(ports: usize) -> Self {
        Self { ports: vec![[0; LANES]; ports], count: 0, before: 0 }
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

/// What fills a block with the next inputs; false if there are no more.
pub type Next<'a> = dyn FnMut(&mut Block) -> bool + 'a;

/// What is given a fault's place and, a bit each, the inputs of a block that detect it; false if nothing more is to be
/// found out of it.
pub type Detected<'a> = dyn FnMut(usize, u64, &Block) -> bool + 'a;

/// Fills blocks with inputs, in order.
#[must_use]
pub fn blocks<'a>(mut inputs: impl Iterator<Item: AsRef<[i64]>> + 'a) -> Box<Next<'a>> {
    Box::new(move |block| {
        block.count = 0;
        inputs.by_ref().take(LANES).for_each(|inputs| block.push(inputs.as_ref()));
        block.count > 0
    })
}

/// The graph of a design with a copy of a node, which is read from behind one of its registers on, and the copy holding
/// each of some values: what a mistake in that register, which puts the value of one input in the place of another's,
/// can change.
pub(crate) fn held_in_register(
    design: &Design,
    node: NodeId,
    register: usize,
    values: impl Iterator<Item = i128>,
) -> (Graph, Vec<Fault>) {
    let stage = &design.schedule.stage;
    let (graph, copy) = design.graph().with_copy(node, |id| stage[id] > stage[node] + register as u32);
    (graph, values.map(|code| Fault { node: copy, change: Change::constant(code) }).collect())
}

/// Finds out which inputs detect which faults: what differs from the graph is computed again for each, and nothing
/// else.
#[derive(Clone, Debug)]
pub struct FaultSimulation<'a> {
    graph: &'a Graph,
    /// The codes by address of each field.
    looked_up: Vec<Vec<i128>>,
    /// The nodes that read each.
    readers: Vec<Vec<NodeId>>,
    /// Whether a node reads a port itself.
    reads_port: Vec<bool>,
    /// Whether a node or one that depends on it does.
    leads_to_port: Vec<bool>,
    /// The bits of each node that any reader takes.
    read: Vec<Range<u32>>,
    narrow: bool,
}

impl<'a> FaultSimulation<'a> {
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
        let mut readers = vec![Vec::new(); graph.nodes.len()];
        for (id, node) in graph.nodes.iter().enumerate() {
            node.args.iter().for_each(|&arg| readers[arg].push(id));
        }
        let looked_up = graph.nodes.iter().map(|node| codes_by_address(node, tables)).collect();
        let read = read_bits(graph);
        Self { graph, looked_up, readers, reads_port, leads_to_port, read, narrow: is_narrow(graph) }
    }

    /// The nodes that read a node.
    pub(super) fn readers(&self, node: NodeId) -> &[NodeId] {
        &self.readers[node]
    }

    /// Whether 64 bits are enough for every operation.
    pub(super) fn is_narrow(&self) -> bool {
        self.narrow
    }

    /// A column for each node: 0, or its constant.
    pub(super) fn at_rest<L: Lane>(&self) -> Vec<[L; LANES]> {
        let column = |node: &Node| match node.op {
            Op::Constant(code) => [L::from_code(node.format.wrap(code)); LANES],
            _ => [L::zero(); LANES],
        };
        self.graph.nodes.iter().map(column).collect()
    }

    /// Looks, in every block of inputs, for every fault of which there is still something to be found out.
    pub fn run(&self, faults: &[&Fault], next: &mut Next, detected: &mut Detected) {
        if self.narrow {
            run_narrow(self, faults, next, detected);
        } else {
            run::<i128>(self, faults, next, detected);
        }
    }

    /// For each fault the first of the inputs that detects it, if any does.
    pub fn first(&self, faults: &[&Fault], next: &mut Next) -> Vec<Option<Vec<i64>>> {
        let mut first = vec![None; faults.len()];
        self.run(faults, next, &mut |place, lanes, block| {
            first[place] = Some(block.inputs(lanes.trailing_zeros() as usize));
            false
        });
        first
    }

    /// Whether a fault may show where nothing but the ports' codes differs from inputs at which it does not.
    fn sees_port(&self, fault: &Fault) -> bool {
        let reads = |args: &[NodeId]| args.iter().any(|&arg| self.graph.nodes[arg].op == Op::Input);
        self.leads_to_port[fault.node] || matches!(&fault.change, Change::Instead { args, .. } if reads(args))
    }

    /// Whether anything reads what a fault changes: what changes a bit that nothing reads never shows.
    fn is_read(&self, fault: &Fault) -> bool {
        match &fault.change {
            Change::Stuck { bit, .. } | Change::Flipped { bit } => self.read[fault.node].contains(bit),
            _ => true,
        }
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
fn run_narrow(simulation: &FaultSimulation, faults: &[&Fault], next: &mut Next, detected: &mut Detected) {
    run::<i64>(simulation, faults, next, detected);
}

#[inline(always)]
fn run<L: Lane>(simulation: &FaultSimulation, faults: &[&Fault], next: &mut Next, detected: &mut Detected) {
    let mut open: Vec<usize> = (0..faults.len()).filter(|&place| simulation.is_read(faults[place])).collect();
    let mut columns = Columns::<L>::of(simulation, faults);
    let mut block = Block::new(simulation.graph.inputs.len());
    let mut before = 0;
    while !open.is_empty() && next(&mut block) {
        block.before = before;
        before += block.count as u64;
        columns.take(&block);
        let counted = if block.count < LANES { (1u64 << block.count) - 1 } else { u64::MAX };
        // First without a fault, then with each: one loop, as what it calls becomes part of it.
        let (mut seen, mut left, mut place) = (0, 0, None);
        loop {
            if place.is_none_or(|place| columns.may_change(place)) {
                columns.compute(place);
            }
            let lanes = columns.restore() & counted;
            if let Some(place) = place
                && (lanes == 0 || detected(place, lanes, &block))
            {
                open[left] = place;
                left += 1;
            }
            let Some(&next) = open.get(seen) else { break };
            seen += 1;
            place = Some(next);
        }
        open.truncate(left);
    }
}

/// Nodes whose arguments have changed, of which the first is taken out first.
#[derive(Clone, Debug)]
pub(super) struct Pending {
    /// A bit for each node.
    words: Vec<u64>,
    /// The first word that is not 0, or one before it.
    first: usize,
}

impl Pending {
    pub(super) fn of(nodes: usize) -> Self {
        Self { words: vec![0; nodes.div_ceil(64)], first: 0 }
    }

    /// Puts nodes in that come behind all which were taken out since none was left.
    #[inline(always)]
    pub(super) fn insert(&mut self, nodes: &[NodeId]) {
        nodes.iter().for_each(|&node| self.words[node / 64] |= 1 << (node % 64));
    }

    /// The first node, no longer in.
    #[inline(always)]
    pub(super) fn take(&mut self) -> Option<NodeId> {
        while self.words.get(self.first) == Some(&0) {
            self.first += 1;
        }
        let Some(word) = self.words.get_mut(self.first) else {
            self.first = 0;
            return None;
        };
        let bit = word.trailing_zeros() as usize;
        *word &= *word - 1;
        Some(self.first * 64 + bit)
    }
}

/// The values of all nodes for a block of inputs.
struct Columns<'a, L> {
    simulation: &'a FaultSimulation<'a>,
    faults: &'a [&'a Fault],
    /// The node of each fault, with the fault in it.
    operations: Vec<Node>,
    sees_port: Vec<bool>,
    values: Vec<[L; LANES]>,
    /// The block's number, from 1.
    number: u64,
    /// Whether a node that reads a port has changed since the last block: as long as none has, nothing else has.
    changed: bool,
    /// What a fault has changed, with the values without it.
    kept: Vec<(NodeId, [L; LANES])>,
    pending: Pending,
    /// For each node the bits that are 1 in any and in every lane, and in which block: most stuck bits are seen to be
    /// as they should at once.
    ends: Vec<(u64, L, L)>,
}

impl<'a, L: Lane> Columns<'a, L> {
    fn of(simulation: &'a FaultSimulation, faults: &'a [&Fault]) -> Self {
        let nodes = &simulation.graph.nodes;
        Self {
            simulation,
            faults,
            operations: faults.iter().map(|fault| fault.operation(simulation.graph)).collect(),
            sees_port: faults.iter().map(|fault| simulation.sees_port(fault)).collect(),
            values: simulation.at_rest(),
            number: 0,
            changed: false,
            kept: Vec::new(),
            pending: Pending::of(nodes.len()),
            ends: vec![(0, L::zero(), L::zero()); nodes.len()],
        }
    }

    /// Puts a block's codes at the ports.
    #[inline(always)]
    fn take(&mut self, block: &Block) {
        for (&port, codes) in self.simulation.graph.inputs.iter().zip(&block.ports) {
            for (value, &code) in self.values[port].iter_mut().zip(codes) {
                *value = L::from_code(code.into());
            }
        }
        self.number += 1;
        self.changed = self.number == 1;
    }

    /// Whether a fault may change anything that it did not in the block before; at its own node, where that is seen at
    /// once.
    #[inline(always)]
    fn may_change(&mut self, place: usize) -> bool {
        if !self.changed && !self.sees_port[place] {
            return false;
        }
        let &Fault { node: id, change: Change::Stuck { bit, high } } = self.faults[place] else { return true };
        if self.ends[id].0 != self.number {
            let both = |(any, every), &value: &L| (any | value, every & value);
            let (any, every) = self.values[id].iter().fold((L::zero(), !L::zero()), both);
            self.ends[id] = (self.number, any, every);
        }
        let (_, any, every) = self.ends[id];
        let is_so = if high { every } else { !any };
        is_so >> bit as usize & L::one() == L::zero()
    }

    /// Computes what follows from the ports' codes, or from the fault at a place.
    #[inline(always)]
    fn compute(&mut self, place: Option<usize>) {
        let (simulation, graph) = (self.simulation, self.simulation.graph);
        let fault = place.map(|place| self.faults[place]);
        let mut next = fault.map_or(0, |fault| fault.node);
        while let Some(own) = graph.nodes.get(next) {
            let id = next;
            let here = fault.filter(|fault| fault.node == id);
            let reads_port = simulation.reads_port[id];
            let is_given = matches!(own.op, Op::Input | Op::Constant(_));
            if fault.is_some() || !is_given && (self.changed || reads_port) {
                let mut result = self.values[id];
                match here {
                    Some(fault) if !matches!(fault.change, Change::Instead { .. } | Change::Address(_)) => {
                        alter(&fault.change, graph, own, |arg| &self.values[own.args[arg]][..], &mut result);
                        wrap(&mut result, own.format);
                    }
                    _ => {
                        let node = if here.is_some() { &self.operations[place.unwrap_or_default()] } else { own };
                        let words_on = here.map_or(0, Fault::words_on);
                        operate(simulation, id, node, |arg| node.args[arg], words_on, &self.values[..id], &mut result);
                    }
                }
                let differs = result != self.values[id];
                if fault.is_none() {
                    self.changed |= reads_port && differs;
                    self.values[id] = result;
                } else if differs {
                    self.kept.push((id, std::mem::replace(&mut self.values[id], result)));
                    self.pending.insert(simulation.readers(id));
                }
            }
            next = match fault {
                None => id + 1,
                Some(_) => self.pending.take().unwrap_or(graph.nodes.len()),
            };
        }
    }

    /// Takes a fault out again, and returns the inputs for which an output was another.
    #[inline(always)]
    fn restore(&mut self) -> u64 {
        let mut detecting = 0;
        for (id, right) in self.kept.drain(..) {
            if self.simulation.graph.is_output(id) {
                detecting |= unlike(&right, &self.values[id]);
            }
            self.values[id] = right;
        }
        detecting
    }
}

/// The lanes in which columns differ, a bit each.
#[inline(always)]
pub(super) fn unlike<L: Lane>(a: &[L; LANES], b: &[L; LANES]) -> u64 {
    a.iter().zip(b).enumerate().fold(0, |lanes, (lane, (a, b))| lanes | u64::from(a != b) << lane)
}

/// A node's column, by the operation that it has or another in its place, of the columns that `column` says of its
/// arguments; a field is read so many words on.
#[inline(always)]
pub(super) fn operate<L: Lane>(
    simulation: &FaultSimulation,
    id: NodeId,
    node: &Node,
    column: impl Fn(usize) -> NodeId,
    words_on: i64,
    columns: &[[L; LANES]],
    result: &mut [L; LANES],
) {
    // A fault may be in a constant: it has a column like any other node.
    let arg = |index: usize| Arg::Column(column(index));
    match node.op {
        Op::Constant(code) => result.fill(L::from_code(code)),
        Op::Field { .. } => {
            let codes = &simulation.looked_up[id];
            for (value, address) in result.iter_mut().zip(&columns[column(0)]) {
                // A fault in the address may leave it wider than the memory is deep.
                *value = L::from_code(codes[(address.to_code() as i64 + words_on) as usize & (codes.len() - 1)]);
            }
        }
        _ => {
            step(simulation.graph, node, &[], arg, columns, result);
            // Faults lead values out of the ranges that let other operations do without.
            wrap(result, node.format);
        }
    }
}
