//! What stands in which pipeline stage, and under which name.

use crate::datapath::Datapath;
use crate::datapath::graph::{Node, NodeId, Op};
use crate::datapath::schedule::Schedule;
use crate::rom::Table;

/// A register between two stages.
#[derive(Clone, Copy, Debug)]
pub struct Register {
    /// The node whose value it holds.
    pub node: NodeId,
    /// The stage that it ends.
    pub stage: u32,
}

/// How a memory is read.
#[derive(Clone, Debug)]
pub struct Read {
    /// The node that is its address.
    pub address: NodeId,
    /// The stage of the address.
    pub stage: u32,
    /// Whether the word goes into a register, as a block RAM requires, before any field of it is used.
    pub registered: bool,
    /// The name of the word.
    pub word: String,
}

/// A datapath with its schedule, as the backends need it.
#[derive(Clone, Copy, Debug)]
pub struct Layout<'a> {
    /// Operations and ROM.
    pub datapath: &'a Datapath,
    /// Stages.
    pub schedule: &'a Schedule,
}

impl<'a> Layout<'a> {
    /// The nodes.
    #[must_use]
    pub fn nodes(&self) -> &'a [Node] {
        &self.datapath.graph.nodes
    }

    /// Whether the node is a literal in the text.
    #[must_use]
    pub fn is_literal(&self, id: NodeId) -> bool {
        matches!(self.nodes()[id].op, Op::Constant(_))
    }

    /// Whether a node's value is a single yes or no, used as such.
    #[must_use]
    pub fn is_flag(&self, id: NodeId) -> bool {
        let used_as_flag = |node: &Node| match node.op {
            Op::Or | Op::Not => node.args.contains(&id),
            Op::ZeroIf | Op::Select => node.args[0] == id,
            _ => false,
        };
        matches!(self.nodes()[id].op, Op::NonZero | Op::Greater | Op::Or | Op::Not)
            || self.nodes().iter().any(used_as_flag)
    }

    /// The name of a node's value in a stage: ports keep theirs in stage 0.
    #[must_use]
    pub fn name(&self, id: NodeId, stage: u32) -> String {
        let node = &self.nodes()[id];
        if stage == 0 && node.op == Op::Input {
            return node.name.clone();
        }
        format!("{}_{stage}", node.name)
    }

    /// The outputs that carry numbers, each with the name of what it shows; the ports' names followed by spaces to one length.
    #[must_use]
    pub fn shown(&self) -> Vec<(String, String)> {
        let shown =
            |(port, node): &(String, NodeId)| (self.padded_output(port), self.name(*node, self.schedule.latency));
        self.datapath.graph.outputs.iter().map(shown).collect()
    }

    /// An output's name, followed by spaces to the length of the longest of all outputs.
    #[must_use]
    pub fn padded_output(&self, name: &str) -> String {
        let width = self.datapath.graph.outputs.iter().map(|(port, _)| port.len()).fold("out_valid".len(), usize::max);
        format!("{name:<width$}")
    }

    /// How a memory is read, by its place among the datapath's tables; `None` if nothing reads it.
    #[must_use]
    pub fn read(&self, memory: usize) -> Option<Read> {
        let is_field = |id: NodeId| matches!(self.nodes()[id].op, Op::Field { memory: of, .. } if of == memory);
        let first = (0..self.nodes().len()).find(|&id| is_field(id))?;
        let stage = self.schedule.stage[first];
        let used_at_once =
            |(id, node): (usize, &Node)| self.schedule.stage[id] == stage && node.args.iter().any(|&arg| is_field(arg));
        let shown_at_once =
            self.datapath.graph.outputs.iter().any(|&(_, id)| is_field(id)) && self.schedule.latency == stage;
        let registered = !self.nodes().iter().enumerate().any(used_at_once) && !shown_at_once;
        let name = self.datapath.tables[memory].name;
        Some(Read {
            address: self.nodes()[first].args[0],
            stage,
            registered,
            word: format!("{name}_{}", stage + u32::from(registered)),
        })
    }

    /// The stage from which on a node's value is there: a field's where it can be taken out of its memory's word.
    fn first_stage(&self, id: NodeId) -> u32 {
        match self.nodes()[id].op {
            Op::Field { memory, .. } => self.read(memory).map_or(0, |read| read.stage + u32::from(read.registered)),
            _ => self.schedule.stage[id],
        }
    }

    /// The nodes that are computed in a stage, in order: no ports, no literals; a field where its word is there.
    #[must_use]
    pub fn computed(&self, stage: u32) -> Vec<NodeId> {
        let own = |id: NodeId| match self.nodes()[id].op {
            Op::Input | Op::Constant(_) => false,
            _ => self.first_stage(id) == stage,
        };
        (0..self.nodes().len()).filter(|&id| own(id)).collect()
    }

    /// The registers at the end of a stage, in order.
    #[must_use]
    pub fn registers(&self, stage: u32) -> Vec<Register> {
        let crosses =
            |id: NodeId| self.first_stage(id) <= stage && stage < self.schedule.last_use[id] && !self.is_literal(id);
        (0..self.nodes().len()).filter(|&id| crosses(id)).map(|node| Register { node, stage }).collect()
    }

    /// The bits of a node's value that nothing uses in the last stage it reaches, as `(high, low)`, most significant first.
    /// In every earlier stage the whole value goes into a register.
    #[must_use]
    pub fn unused_bits(&self, id: NodeId) -> Vec<(u32, u32)> {
        let format = self.nodes()[id].format;
        let width = format.width();
        let mut used = vec![self.datapath.graph.is_output(id); width as usize];
        for (user, node) in self.nodes().iter().enumerate() {
            if !node.args.contains(&id) || self.schedule.stage[user] != self.schedule.last_use[id] {
                continue;
            }
            let padding = (node.format.frac_bits - format.frac_bits).max(0) as u32;
            let (low, high) = match node.op {
                Op::Cast => {
                    let low = (format.frac_bits - node.format.frac_bits).max(0) as u32;
                    (low, low + node.format.width().saturating_sub(padding))
                }
                // A result narrower than its operands needs their low bits only.
                Op::Add | Op::Sub => (0, node.format.width().saturating_sub(padding)),
                Op::ShiftLeft if node.args[1] != id => (0, node.format.width()),
                _ => (0, width),
            };
            used[low.min(width) as usize..high.min(width) as usize].fill(true);
        }
        let mut ranges: Vec<(u32, u32)> = Vec::new();
        for bit in (0..width).rev().filter(|&bit| !used[bit as usize]) {
            match ranges.last_mut() {
                Some((_, low)) if *low == bit + 1 => *low = bit,
                _ => ranges.push((bit, bit)),
            }
        }
        ranges
    }

    /// What a stage does, for its heading: its longest-named results.
    #[must_use]
    pub fn heading(&self, stage: u32) -> String {
        let main = |id: &NodeId| {
            matches!(
                self.nodes()[*id].op,
                Op::Clamp { .. }
                    | Op::Add
                    | Op::Sub
                    | Op::Mul
                    | Op::ShiftLeft
                    | Op::ShiftRight
                    | Op::Greater
                    | Op::Select
                    | Op::ZeroIf
            )
        };
        let mut parts: Vec<String> = Vec::new();
        for (memory, table) in self.datapath.tables.iter().enumerate() {
            if self.read(memory).is_some_and(|read| read.stage == stage) {
                let name = if table.name == Table::COEFFICIENTS { "the ROM" } else { table.name };
                parts.push(format!("read {name}"));
            }
        }
        parts.extend(self.computed(stage).iter().filter(|id| main(id)).map(|&id| self.nodes()[id].name.clone()));
        // A line of the HDL holds so many.
        const MOST: usize = 60;
        let mut length = 0;
        let fitting = parts.iter().take_while(|part| {
            length += part.len() + 2;
            length <= MOST
        });
        let shown = fitting.count();
        match parts.len() - shown {
            _ if parts.is_empty() => "registers only".to_owned(),
            0 => parts.join(", "),
            more => format!("{} and {more} more", parts[..shown].join(", ")),
        }
    }
}
