//! The pipeline, clock by clock.

use num_bigint::BigUint;

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

/// A word at a memory's write port before a rising edge, the port enabled.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Write {
    /// The memory's place among the tables.
    pub memory: usize,
    /// The address, below the memory's depth.
    pub address: usize,
    /// The word.
    pub word: BigUint,
}

/// A cycle-accurate simulation of a scheduled graph, with the same registers as the HDL.
#[derive(Clone, Debug)]
pub struct Simulation<'a> {
    graph: &'a Graph,
    schedule: &'a Schedule,
    tables: &'a [Table],
    /// `contents[memory][address]`: the codes of the word's fields.
    contents: Vec<Vec<Vec<i128>>>,
    /// `registers[id][i]`: node `id`'s value as seen in stage `schedule.stage[id] + 1 + i`.
    registers: Vec<Vec<i128>>,
    valid: Vec<bool>,
}

impl<'a> Simulation<'a> {
    /// All registers 0, and the memories as the tables say.
    #[must_use]
    pub fn new(graph: &'a Graph, schedule: &'a Schedule, tables: &'a [Table]) -> Self {
        let registers =
            (0..graph.nodes.len()).map(|id| vec![0; (schedule.last_use[id] - schedule.stage[id]) as usize]).collect();
        let word =
            |table: &Table, address| (0..table.fields.len()).map(|field| table.code_at(field, address)).collect();
        let words = |table: &Table| (0..table.depth()).map(|address| word(table, address)).collect();
        let contents = tables.iter().map(words).collect();
        Self { graph, schedule, tables, contents, registers, valid: vec![false; schedule.latency as usize] }
    }

    /// One rising edge.
    pub fn clock(&mut self, inputs: &Inputs) -> Outputs {
        self.clock_writing(inputs, &[])
    }

    /// One rising edge at which words are written, whatever `ce` and `rst` are. What is read at this edge from an address that is
    /// written at it is the old word here; hardware promises nothing.
    ///
    /// # Panics
    /// If a memory or an address does not exist.
    pub fn clock_writing(&mut self, inputs: &Inputs, writes: &[Write]) -> Outputs {
        let outputs = self.advance(inputs);
        for Write { memory, address, word } in writes {
            self.contents[*memory][*address] = self.tables[*memory].codes_of(word);
        }
        outputs
    }

    fn advance(&mut self, inputs: &Inputs) -> Outputs {
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
                Op::Field { memory, field } => self.contents[memory][args[0] as usize][field],
                _ => self.graph.apply(id, &args),
            };
            values.push(value);
        }
        values
    }
}
