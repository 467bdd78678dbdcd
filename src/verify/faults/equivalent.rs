//! What is found out of mutants that no golden vector tells from the core.
//!
//! A change of what is computed is decided by running inputs through the graph with the change in it: all of them, where the ports are
//! narrow enough. Before that, and for a shader instead, a proof is sought in a part of the graph.
//!
//! A change of a pipeline register puts the value of one input in the place of another's. It is decided the same way, for the few values
//! that a register that survives can hold.

use std::collections::BTreeMap;

use rayon::prelude::*;

use super::local::{Domain, Local, first_shown};
use crate::core::Design;
use crate::core::Direction;
use crate::core::edges::varied;
use crate::datapath::evaluate::Evaluator;
use crate::datapath::fault::{Block, Change, Defect, Fault, Hunt, Probe, Registered, Timing, with_copy};
use crate::datapath::graph::{Graph, NodeId, Op};
use crate::fixed::Dice;
use crate::spec::Shader;
use crate::verify::golden::all_codes;

/// Ports of more codes than these together are not run through all of them.
const MOST_INPUTS: u64 = 1 << 34;
/// Values of a register that are tried in the place of any other.
const MOST_VALUES: usize = 16;
/// Inputs of a shader, and those of one task.
const SAMPLES: u64 = 1 << 20;
const OF_TASK: u64 = 1 << 16;

/// What is found out of a mutant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Decision {
    /// It computes what the core computes.
    Same {
        /// Why.
        proof: String,
    },
    /// It does not.
    Differs {
        /// An input that shows it.
        input: String,
    },
    /// Nothing.
    Open {
        /// What was tried.
        tried: String,
    },
}

/// What is found out of mutants of a design, in their order.
#[must_use]
pub fn decide(design: &Design, defects: &[&Defect]) -> Vec<Decision> {
    let (graph, tables) = (design.graph(), design.tables());
    let local = Local::of(design);
    let proof = |defect: &&Defect| match defect {
        Defect::Value(fault) => local.proof(fault).map(|proof| Decision::Same { proof }),
        Defect::Timing(_) => None,
    };
    let mut decisions: Vec<Option<Decision>> = defects.par_iter().map(proof).collect();
    let inputs = Domain::whole(graph);
    let open = |decisions: &[Option<Decision>]| -> Vec<(usize, Fault)> {
        let faults = defects.iter().enumerate().filter(|(place, _)| decisions[*place].is_none());
        let value = |(place, defect): (usize, &&Defect)| match defect {
            Defect::Value(fault) => Some((place, fault.clone())),
            Defect::Timing(_) => None,
        };
        faults.filter_map(value).collect()
    };
    let left = open(&decisions);
    let faults: Vec<&Fault> = left.iter().map(|(_, fault)| fault).collect();
    if let Some(shader) = design.spec.block.shader() {
        let shown = sampled(design, shader, &faults);
        for ((place, _), inputs) in left.iter().zip(shown) {
            decisions[*place] = Some(match inputs {
                Some(inputs) => Decision::Differs { input: input_text(design, &inputs) },
                None => Decision::Open { tried: format!("{SAMPLES} inputs and every part of the graph") },
            });
        }
    } else if let Some(total) = inputs.count().filter(|&total| total <= MOST_INPUTS) {
        for ((place, _), index) in left.iter().zip(first_shown(graph, tables, &inputs, total, &faults)) {
            decisions[*place] = Some(match index {
                Some(index) => Decision::Differs { input: input_text(design, &inputs.at(index)) },
                None => Decision::Same { proof: format!("none of all {total} inputs shows it") },
            });
        }
        for (decision, defect) in decisions.iter_mut().zip(defects) {
            if let Defect::Timing(Timing::Register { node, register, what }) = defect {
                *decision = Some(of_register(design, &inputs, total, *node, *register, *what));
            }
        }
    }
    let open = || Decision::Open { tried: "nothing but the vectors".to_owned() };
    decisions.into_iter().map(|decision| decision.unwrap_or_else(open)).collect()
}

fn input_text(design: &Design, codes: &[i64]) -> String {
    let ports = design.numbers(Direction::In);
    ports.iter().zip(codes).map(|((port, _), code)| format!("{port} {code}")).collect::<Vec<_>>().join(", ")
}

/// A task's samples of a shader.
struct Samples<'a> {
    design: &'a Design,
    shader: &'a Shader,
    dice: Dice,
    left: u64,
    shown: Vec<Option<Vec<i64>>>,
}

impl Hunt for Samples<'_> {
    fn next(&mut self, block: &mut Block) -> bool {
        block.count = 0;
        while self.left > 0 && block.count < Block::LANES {
            block.push(&varied(self.design, self.shader, &mut self.dice));
            self.left -= 1;
        }
        block.count > 0
    }

    fn shown(&mut self, place: usize, lanes: u64, block: &Block) -> bool {
        self.shown[place] = Some(block.inputs(lanes.trailing_zeros() as usize));
        false
    }
}

/// For each fault an input of a shader that shows it, if there is one among many samples.
fn sampled(design: &Design, shader: &Shader, faults: &[&Fault]) -> Vec<Option<Vec<i64>>> {
    let probe = Probe::new(design.graph(), design.tables());
    let tasks = SAMPLES / OF_TASK;
    let task = |task: u64| {
        let dice = Dice::new((4 << 40) + task);
        let mut samples = Samples { design, shader, dice, left: OF_TASK, shown: vec![None; faults.len()] };
        probe.run(faults, &mut samples);
        samples.shown
    };
    let all: Vec<Vec<Option<Vec<i64>>>> = (0..tasks).into_par_iter().map(task).collect();
    (0..faults.len()).map(|fault| all.iter().find_map(|shown| shown[fault].clone())).collect()
}

/// The values of a node, each with an input that gives it; `None` if they are many.
fn values(design: &Design, node: NodeId) -> Option<BTreeMap<i128, u64>> {
    let graph = design.graph();
    let shown = Graph { outputs: vec![("value".to_owned(), node)], ..graph.clone() };
    let mut found = BTreeMap::new();
    let evaluator = Evaluator::new(&shown, design.tables());
    let (first, count) = all_codes(design.operand_format());
    let mut codes = vec![0u32; count as usize];
    for index in 0..1u64 << design.index_format().width() {
        evaluator.evaluate(index as u32, first, 1, &mut codes);
        for (place, &code) in codes.iter().enumerate() {
            let code = graph.nodes[node].format.wrap(code.into());
            found.entry(code).or_insert(index * count + place as u64);
        }
        if found.len() > MOST_VALUES || graph.nodes[node].format.width() > u32::BITS {
            return None;
        }
    }
    Some(found)
}

/// Whether it shows when a register of a node holds the value of the input before or behind the right one.
fn of_register(
    design: &Design,
    inputs: &Domain,
    total: u64,
    node: NodeId,
    register: usize,
    what: Registered,
) -> Decision {
    let graph = design.graph();
    let Some(values) = values(design, node) else {
        return Decision::Open { tried: format!("more than {MOST_VALUES} values of the register are too many") };
    };
    let (copied, copy) = with_copy(graph, &design.schedule, node, register);
    let held =
        |&code: &i128| Fault { node: copy, change: Change::Instead { op: Op::Constant(code), args: Vec::new() } };
    let faults: Vec<Fault> = values.keys().map(held).collect();
    let faults: Vec<&Fault> = faults.iter().collect();
    let shown = first_shown(&copied, design.tables(), inputs, total, &faults);
    let text = |index: u64| input_text(design, &inputs.at(index));
    let pair = shown.into_iter().zip(values.values()).find_map(|(shown, &other)| Some((shown?, other)));
    match pair {
        Some((index, other)) => {
            let order = match what {
                Registered::Missing => "then",
                Registered::Doubled => "after",
                Registered::FreeRunning => "then, after a clock without ce,",
            };
            Decision::Differs { input: format!("{} {order} {}", text(index), text(other)) }
        }
        None => Decision::Same {
            proof: format!("at none of all {total} inputs does another of its {} values show", values.len()),
        },
    }
}
