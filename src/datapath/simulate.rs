//! The pipeline, clock by clock.

use std::collections::HashMap;

use num_bigint::BigUint;

use super::fault::{Change, Defect, Fault, Registered, Timing};
use super::graph::{Graph, NodeId, Op};
use super::schedule::Schedule;
use crate::fixed::Table;

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
    /// Words that are others than the tables say, by memory and address: the codes of their fields. Memories are large,
    /// and simulations many.
    written: HashMap<(usize, usize), Vec<i128>>,
    /// `registers[id][i]`: node `id`'s value as seen in stage `schedule.stage[id] + 1 + i`.
    registers: Vec<Vec<i128>>,
    valid: Vec<bool>,
    defect: Option<&'a Defect>,
}

impl<'a> Simulation<'a> {
    /// All registers 0, and the memories as the tables say.
    #[must_use]
    pub fn new(graph: &'a Graph, schedule: &'a Schedule, tables: &'a [Table]) -> Self {
        let registers =
            (0..graph.nodes.len()).map(|id| vec![0; (schedule.last_use[id] - schedule.stage[id]) as usize]).collect();
        let valid = vec![false; schedule.latency as usize];
        Self { graph, schedule, tables, written: HashMap::new(), registers, valid, defect: None }
    }

    /// The same core with something wrong in it.
    ///
    /// # Panics
    /// If it is in a register that the core does not have, or the valid chain is to be shorter than one stage.
    #[must_use]
    pub fn with(mut self, defect: &'a Defect) -> Self {
        match defect {
            Defect::Timing(Timing::Register { node, register, what }) => {
                assert!(*register < self.registers[*node].len(), "no register {register} of node {node}");
                match what {
                    Registered::Missing => drop(self.registers[*node].pop()),
                    Registered::Doubled => self.registers[*node].push(0),
                    Registered::FreeRunning => {}
                }
            }
            Defect::Timing(Timing::ValidEarly) => drop(self.valid.pop().expect("a stage")),
            Defect::Timing(Timing::ValidLate) => self.valid.push(false),
            // A memory that is written loses it.
            Defect::Value(Fault { node, change: Change::Word { address, bit } }) => {
                if let Op::Field { memory, field } = self.graph.nodes[*node].op {
                    let table = &self.tables[memory];
                    let mut word: Vec<i128> =
                        (0..table.fields.len()).map(|field| table.code_at(field, *address)).collect();
                    word[field] = self.graph.nodes[*node].format.wrap(word[field] ^ (1 << bit));
                    self.written.insert((memory, *address), word);
                }
            }
            _ => {}
        }
        self.defect = Some(defect);
        self
    }

    fn timing(&self) -> Option<Timing> {
        match self.defect {
            Some(Defect::Timing(timing)) => Some(*timing),
            _ => None,
        }
    }

    fn fault(&self, id: NodeId) -> Option<&'a Fault> {
        self.defect.and_then(Defect::fault).filter(|fault| fault.node == id)
    }

    /// The register from which a stage reads a node, by how many stages later it is than the node's; none where it
    /// reads the node itself.
    fn place(&self, id: NodeId, crossed: usize) -> Option<usize> {
        match self.timing() {
            Some(Timing::Register { node, register, what }) if node == id && crossed > register => match what {
                Registered::Missing => (crossed - 1).checked_sub(1),
                Registered::Doubled => Some(crossed),
                Registered::FreeRunning => Some(crossed - 1),
            },
            _ => crossed.checked_sub(1),
        }
    }

    /// One rising edge.
    pub fn clock(&mut self, inputs: &Inputs) -> Outputs {
        self.clock_writing(inputs, &[])
    }

    /// One rising edge at which words are written, whatever `ce` and `rst` are. What is read at this edge from an
    /// address that is written at it is the old word here; hardware promises nothing.
    ///
    /// # Panics
    /// If a memory or an address does not exist.
    pub fn clock_writing(&mut self, inputs: &Inputs, writes: &[Write]) -> Outputs {
        let outputs = self.advance(inputs);
        for Write { memory, address, word } in writes {
            let table = &self.tables[*memory];
            assert!(*address < table.depth(), "no address {address} in memory {memory}");
            self.written.insert((*memory, *address), table.codes_of(word));
        }
        outputs
    }

    fn advance(&mut self, inputs: &Inputs) -> Outputs {
        let timing = self.timing();
        if inputs.ce {
            let values = self.settle(inputs);
            for (registers, value) in self.registers.iter_mut().zip(values) {
                if !registers.is_empty() {
                    registers.rotate_right(1);
                    registers[0] = value;
                }
            }
        } else if let Some(Timing::Register { node, register, what: Registered::FreeRunning }) = timing {
            let value = if register == 0 { self.settle(inputs)[node] } else { self.registers[node][register - 1] };
            self.registers[node][register] = value;
        }
        if (inputs.ce || timing == Some(Timing::ValidFreeRunning)) && !self.valid.is_empty() {
            self.valid.rotate_right(1);
            self.valid[0] = inputs.in_valid || timing == Some(Timing::ValidAlways);
        }
        match timing {
            _ if !inputs.rst => {}
            Some(Timing::ResetIgnored) => {}
            Some(Timing::ResetNeedsEnable) if !inputs.ce => {}
            Some(Timing::ResetOfLastStage) => self.valid.last_mut().into_iter().for_each(|valid| *valid = false),
            _ => self.valid.fill(false),
        }
        let code = |&(_, output): &(String, usize)| {
            let crossed = self.schedule.latency - self.schedule.stage[output];
            match self.place(output, crossed as usize) {
                Some(place) => self.registers[output][place],
                // Without its only register the output is what the stage before gives after the edge.
                None => self.settle(inputs)[output],
            }
        };
        let out_valid = self.valid.last().copied().unwrap_or(inputs.in_valid);
        Outputs {
            out_valid: out_valid != (timing == Some(Timing::ValidInverted)),
            codes: self.graph.outputs.iter().map(code).collect(),
        }
    }

    /// The combinational value of every node in its stage.
    fn settle(&self, inputs: &Inputs) -> Vec<i128> {
        let mut values: Vec<i128> = Vec::with_capacity(self.graph.nodes.len());
        let mut args: Vec<i128> = Vec::new();
        for (id, own) in self.graph.nodes.iter().enumerate() {
            let fault = self.fault(id);
            let changed = fault.map(|fault| fault.operation(self.graph));
            let node = changed.as_ref().unwrap_or(own);
            args.clear();
            args.extend(node.args.iter().map(|&arg| {
                if matches!(self.graph.nodes[arg].op, Op::Constant(_)) {
                    return values[arg];
                }
                let crossed = self.schedule.stage[id] - self.schedule.stage[arg];
                self.place(arg, crossed as usize).map_or(values[arg], |place| self.registers[arg][place])
            }));
            let right = match node.op {
                Op::Input => inputs.codes.get(self.graph.port(id)).copied().unwrap_or_default(),
                // A fault in the address may leave it wider than the memory is deep.
                Op::Field { memory, field } => {
                    let table = &self.tables[memory];
                    let address = args[0] as i64 + fault.map_or(0, Fault::words_on);
                    let address = address as usize & (table.depth() - 1);
                    match self.written.get(&(memory, address)) {
                        Some(word) => word[field],
                        None => table.code_at(field, address),
                    }
                }
                _ => self.graph.apply_node(node, &args),
            };
            let injected = fault.filter(|fault| !matches!(fault.change, Change::Word { .. }));
            values.push(injected.map_or(right, |fault| fault.code(self.graph, &args, right)));
        }
        values
    }
}
