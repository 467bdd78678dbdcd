//! What stands in which pipeline stage, and under which name.

use crate::datapath::Datapath;
use crate::datapath::graph::{Node, NodeId, Op};
use crate::datapath::schedule::Schedule;
use crate::number::Format;

/// A register between two stages.
#[derive(Clone, Copy, Debug)]
pub struct Register {
    /// The node whose value it holds.
    pub node: NodeId,
    /// The stage that it ends.
    pub stage: u32,
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
            Op::Or => node.args.contains(&id),
            Op::ZeroIf => node.args[0] == id,
            _ => false,
        };
        matches!(self.nodes()[id].op, Op::NonZero | Op::Greater | Op::Or) || self.nodes().iter().any(used_as_flag)
    }

    /// The name of a node's value in a stage: ports keep theirs in stage 0.
    #[must_use]
    pub fn name(&self, id: NodeId, stage: u32) -> String {
        let node = &self.nodes()[id];
        if stage == 0 && matches!(node.op, Op::Index | Op::Operand) {
            return node.name.clone();
        }
        format!("{}_{stage}", node.name)
    }

    /// The stage in which the ROM is read.
    #[must_use]
    pub fn rom_stage(&self) -> u32 {
        let fields = self.nodes().iter().zip(&self.schedule.stage).filter(|(node, _)| matches!(node.op, Op::Field(_)));
        fields.map(|(_, &stage)| stage).min().unwrap_or(0)
    }

    /// The name of the ROM's address.
    #[must_use]
    pub fn address(&self) -> (String, Format) {
        let field = self.nodes().iter().find(|node| matches!(node.op, Op::Field(_)));
        let id = field.map_or_else(|| self.datapath.graph.index(), |field| field.args[0]);
        (self.name(id, self.rom_stage()), self.nodes()[id].format)
    }

    /// Whether the ROM's word goes into a register, as a block RAM requires, before any field of it is used.
    #[must_use]
    pub fn rom_is_registered(&self) -> bool {
        let stage = self.rom_stage();
        !self.nodes().iter().enumerate().any(|(id, node)| {
            self.schedule.stage[id] == stage
                && node.args.iter().any(|&arg| matches!(self.nodes()[arg].op, Op::Field(_)))
        })
    }

    /// The stage from which on the fields can be taken out of the ROM's word.
    #[must_use]
    pub fn field_stage(&self) -> u32 {
        self.rom_stage() + u32::from(self.rom_is_registered())
    }

    /// The nodes that are computed in a stage, in order: no ports, no literals; a field where its word is there.
    #[must_use]
    pub fn computed(&self, stage: u32) -> Vec<NodeId> {
        let own = |id: NodeId| match self.nodes()[id].op {
            Op::Index | Op::Operand | Op::Constant(_) => false,
            Op::Field(_) => stage == self.field_stage(),
            _ => self.schedule.stage[id] == stage,
        };
        (0..self.nodes().len()).filter(|&id| own(id)).collect()
    }

    /// The registers at the end of a stage, in order.
    #[must_use]
    pub fn registers(&self, stage: u32) -> Vec<Register> {
        let first = |id: NodeId| match self.nodes()[id].op {
            Op::Field(_) => self.field_stage(),
            _ => self.schedule.stage[id],
        };
        let crosses = |id: NodeId| first(id) <= stage && stage < self.schedule.last_use[id] && !self.is_literal(id);
        (0..self.nodes().len()).filter(|&id| crosses(id)).map(|node| Register { node, stage }).collect()
    }

    /// The bits of a node's value that nothing uses in the last stage it reaches, as `(high, low)`, most significant first.
    /// In every earlier stage the whole value goes into a register.
    #[must_use]
    pub fn unused_bits(&self, id: NodeId) -> Vec<(u32, u32)> {
        let format = self.nodes()[id].format;
        let width = format.width();
        let mut used = vec![id == self.datapath.graph.output; width as usize];
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
                Op::Clamp { .. } | Op::Add | Op::Sub | Op::Mul | Op::ShiftLeft | Op::Greater | Op::ZeroIf
            )
        };
        let mut parts: Vec<String> = Vec::new();
        if stage == self.rom_stage() {
            parts.push("read the ROM".to_owned());
        }
        parts.extend(self.computed(stage).iter().filter(|id| main(id)).map(|&id| self.nodes()[id].name.clone()));
        if parts.is_empty() { "registers only".to_owned() } else { parts.join(", ") }
    }
}
