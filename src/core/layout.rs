//! What stands in which pipeline stage, and under which name.

use std::collections::HashSet;

use super::{ReadPort, Role, WritePort};
use crate::datapath::Datapath;
use crate::datapath::graph::{Node, NodeId, Op};
use crate::datapath::schedule::Schedule;
use crate::fixed::Table;

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
    /// Registers between the address and the word: one where the word goes into a register, as a block RAM requires,
    /// before any field of it is used; of a memory outside of the core its own and the one that takes the word.
    pub registers: u32,
    /// The name of the word.
    pub word: String,
}

/// A datapath with its schedule, as the backends need it.
#[derive(Clone, Debug)]
pub struct Layout<'a> {
    /// Operations and ROM.
    pub datapath: &'a Datapath,
    /// Stages.
    pub schedule: &'a Schedule,
    /// What each node's values are called, up to the stage.
    names: Vec<String>,
    /// Whether an input has a name of its own in stage 0, and not that of its port.
    apart: bool,
}

impl<'a> Layout<'a> {
    /// The layout of a core of this name. Values that would bear one name in the text, in either language, are told
    /// apart here; so are those that would bear the core's.
    #[must_use]
    pub fn new(core: &str, datapath: &'a Datapath, schedule: &'a Schedule) -> Self {
        let mut layout = Self { datapath, schedule, names: Vec::new(), apart: false };
        let mut taken = layout.fixed_names(core);
        for (id, node) in layout.nodes().iter().enumerate() {
            // In VHDL the case of letters makes no difference. No name of a value differs from another by its case
            // alone.
            let free = |name: &String| layout.stage_names(id, name).iter().all(|name| !taken.contains(name));
            let others = (2..).map(|version| format!("{}_v{version}", node.name));
            let name = std::iter::once(node.name.clone()).chain(others).find(free).unwrap_or_default();
            taken.extend(layout.stage_names(id, &name));
            layout.names.push(name);
        }
        layout
    }

    /// This layout with names for the inputs in stage 0 that are not their ports'.
    pub(crate) fn with_inputs_apart(&self) -> Self {
        Self { apart: true, ..self.clone() }
    }

    /// What the text declares besides the values of nodes, in lower case.
    fn fixed_names(&self, core: &str) -> HashSet<String> {
        let graph = &self.datapath.graph;
        let inputs = graph.inputs.iter().map(|&id| self.nodes()[id].name.as_str());
        let outputs = graph.outputs.iter().map(|(name, _)| name.as_str());
        let fixed =
            Role::NAMED.into_iter().map(|(_, name)| name).chain(["valid", "unused", "sets", Role::IN_SET, core]);
        let mut names: HashSet<String> = fixed.chain(inputs).chain(outputs).map(str::to_ascii_lowercase).collect();
        for (memory, table) in self.datapath.tables.iter().enumerate() {
            let name = table.name;
            names.extend(self.read(memory).map(|read| read.word));
            names.extend(WritePort::of(memory, table, 1).ports().map(|port| port.name.clone()));
            names.extend(ReadPort::of(memory, table, 1).ports().map(|port| port.name.clone()));
            names.extend([name.to_owned(), format!("{name}_t"), format!("{name}_file")]);
            names.extend(["read", "initial"].map(|verb| format!("{verb}_{name}")));
            let words = (0..table.word_bits().div_ceil(32)).map(|chunk| format!("{name}_words_{chunk}"));
            names.extend(words.flat_map(|words| [format!("{words}_t"), words]));
        }
        names
    }

    /// The names that a node's values have in the stages that they reach, if they are called so; none of a literal.
    fn stage_names(&self, id: NodeId, name: &str) -> Vec<String> {
        if self.is_literal(id) {
            return Vec::new();
        }
        let first = self.first_stage(id);
        (first..=self.schedule.last_use[id].max(first)).map(|stage| format!("{name}_{stage}")).collect()
    }

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
        if stage == 0 && node.op == Op::Input && !self.apart {
            return node.name.clone();
        }
        format!("{}_{stage}", self.names[id])
    }

    /// The outputs that carry numbers, each with the name of what it shows; the ports' names followed by spaces to one
    /// length.
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
        let registers = self.schedule.external.registers(memory).unwrap_or(registered.into());
        let name = self.datapath.tables[memory].name;
        Some(Read {
            address: self.nodes()[first].args[0],
            stage,
            registers,
            word: format!("{name}_{}", stage + registers),
        })
    }

    /// The stage from which on a node's value is there: a field's where it can be taken out of its memory's word.
    fn first_stage(&self, id: NodeId) -> u32 {
        match self.nodes()[id].op {
            Op::Field { memory, .. } => self.read(memory).map_or(0, |read| read.stage + read.registers),
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

    /// What the comparison `a > b` gives whatever the values are, where their widths alone decide it: a constant at or
    /// past the end of what the other side holds.
    #[must_use]
    pub fn decided(&self, a: NodeId, b: NodeId) -> Option<bool> {
        let codes = |id: NodeId| match self.nodes()[id].op {
            Op::Constant(code) => (code, code),
            _ => (self.nodes()[id].format.min_code(), self.nodes()[id].format.max_code()),
        };
        let ((least, most), (other_least, other_most)) = (codes(a), codes(b));
        if least > other_most {
            Some(true)
        } else if most <= other_least {
            Some(false)
        } else {
            None
        }
    }

    /// Whether a node's value depends on none of its arguments, as the widths say.
    fn is_decided(&self, node: &Node) -> bool {
        node.op == Op::Greater && self.decided(node.args[0], node.args[1]).is_some()
    }

    /// The bits of a node's value that nothing uses in the last stage it reaches, as `(high, low)`, most significant
    /// first. In every earlier stage the whole value goes into a register.
    #[must_use]
    pub fn unused_bits(&self, id: NodeId) -> Vec<(u32, u32)> {
        let format = self.nodes()[id].format;
        let width = format.width();
        let mut used = vec![self.datapath.graph.is_output(id); width as usize];
        for (user, node) in self.nodes().iter().enumerate() {
            let reads = node.args.contains(&id) && self.schedule.stage[user] == self.schedule.last_use[id];
            if !reads || self.is_decided(node) {
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
