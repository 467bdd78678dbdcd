//! The pipeline, clock by clock.

use super::graph::{Graph, Op};
use super::schedule::Schedule;
use crate::rom::Table;

/// The levels at the input ports before a rising edge.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Inputs {
    /// Synchronous reset: clears the valid chain, whatever `ce` is.
    pub rst: bool,
    /// Clock enable: without it nothing but the reset acts.
    pub ce: bool,
    /// The operands are to be taken.
    pub in_valid: bool,
    /// The codes of the input ports, in the graph's order.
    pub codes: Vec<i128>,
}

/// The levels at the output ports after a rising edge.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Outputs {
    /// The result is one.
    pub out_valid: bool,
    /// The codes of the output ports, in the graph's order.
    pub codes: Vec<i128>,
}

/// A cycle-accurate simulation of a scheduled graph, with the same registers as the HDL.
#[derive(Clone, Debug)]
pub struct Simulation<'a> {
    graph: &'a Graph,
    schedule: &'a Schedule,
    tables: &'a [Table],
    /// `registers[id][i]`: node `id`'s value as seen in stage `schedule.stage[id] + 1 + i`.
    registers: Vec<Vec<i128>>,
    valid: Vec<bool>,
}

impl<'a> Simulation<'a> {
    /// All registers 0.
    #[must_use]
    pub fn new(graph: &'a Graph, schedule: &'a Schedule, tables: &'a [Table]) -> Self {
        let registers =
            (0..graph.nodes.len()).map(|id| vec![0; (schedule.last_use[id] - schedule.stage[id]) as usize]).collect();
        Self { graph, schedule, tables, registers, valid: vec![false; schedule.latency as usize] }
    }

    /// One rising edge.
    pub fn clock(&mut self, inputs: &Inputs) -> Outputs {
        if inputs.ce {
            let values = self.settle(inputs);
            for (registers, value) in self.registers.iter_mut().zip(values) {
                if !registers.is_empty() {
                    registers.rotate_right(1);
                    registers[0] = value;
                }
            }
            self.valid.rotate_right(1);
            self.valid[0] = inputs.in_valid;
        }
        if inputs.rst {
            self.valid.fill(false);
        }
        let code = |&(_, output): &(String, usize)| self.registers[output].last().copied().unwrap_or_default();
        Outputs {
            out_valid: self.valid.last().copied().unwrap_or_default(),
            codes: self.graph.outputs.iter().map(code).collect(),
        }
    }

    /// The combinational value of every node in its stage.
    fn settle(&self, inputs: &Inputs) -> Vec<i128> {
        let mut values: Vec<i128> = Vec::with_capacity(self.graph.nodes.len());
        for (id, node) in self.graph.nodes.iter().enumerate() {
            let args: Vec<i128> = node
                .args
                .iter()
                .map(|&arg| match self.schedule.stage[id] - self.schedule.stage[arg] {
                    0 => values[arg],
                    _ if matches!(self.graph.nodes[arg].op, Op::Constant(_)) => values[arg],
                    crossed => self.registers[arg][crossed as usize - 1],
                })
                .collect();
            let value = match node.op {
                Op::Input => inputs.codes.get(self.graph.port(id)).copied().unwrap_or_default(),
                Op::Field { memory, field } => self.tables[memory].code_at(field, args[0] as usize),
                _ => self.graph.apply(id, &args),
            };
            values.push(value);
        }
        values
    }
}
