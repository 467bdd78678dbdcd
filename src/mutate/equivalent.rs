//! What is found out of mutants that no golden vector tells from the core.
//!
//! A change of what is computed is decided by running inputs through the graph with the change in it: all of them, where the ports are
//! narrow enough. Before that, and for a shader instead, *cuts* are tried: the values of a few nodes, narrow together, are taken as free,
//! and if no value of them lets the change show in anything that is computed from them alone and read by the rest, no input does.
//!
//! A change of a pipeline register puts the value of one input in the place of another's. It is decided the same way, for the few values
//! that a register that survives can hold.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU64, Ordering};

use rayon::prelude::*;

use crate::datapath::evaluate::Evaluator;
use crate::datapath::fault::{Block, Change, Defect, Fault, Hunt, Probe, Registered, Timing, with_copy};
use crate::datapath::graph::{Graph, Node, NodeId, Op};
use crate::design::Design;
use crate::design::sample::{Sample, random_codes};
use crate::golden::all_codes;
use crate::hdl::Direction;
use crate::number::Dice;
use crate::rom::Table;
use crate::spec::Shader;

/// Ports of more bits than these together are not run through all their codes.
const MOST_BITS: u32 = 34;
/// The same for a cut of a shader, and of a lobe, all of whose inputs can be run for all mutants at once.
const MOST_CUT_BITS: u32 = 20;
const MOST_LOBE_CUT_BITS: u32 = 14;
/// Values of a register that are tried in the place of any other.
const MOST_VALUES: usize = 16;
/// Inputs that one task runs.
const CHUNK_BITS: u32 = 16;
/// Samples of a shader, half of them random codes.
const SAMPLES: u64 = 1 << 20;

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
    let mut decisions: Vec<Option<Decision>> = defects.par_iter().map(|defect| locally(design, defect)).collect();
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
                None => Decision::Open { tried: format!("{SAMPLES} samples and every cut of {MOST_CUT_BITS} bits") },
            });
        }
    } else if bits(graph) <= MOST_BITS {
        for ((place, _), index) in left.iter().zip(first_shown(graph, tables, &faults)) {
            decisions[*place] = Some(match index {
                Some(index) => Decision::Differs { input: input_text(design, &inputs_at(graph, index)) },
                None => Decision::Same { proof: format!("none of all 2^{} inputs shows it", bits(graph)) },
            });
        }
        for (decision, defect) in decisions.iter_mut().zip(defects) {
            if let Defect::Timing(Timing::Register { node, register, what }) = defect {
                *decision = Some(of_register(design, *node, *register, *what));
            }
        }
    }
    let open = || Decision::Open { tried: "nothing but the vectors".to_owned() };
    decisions.into_iter().map(|decision| decision.unwrap_or_else(open)).collect()
}

/// The bits of all ports.
fn bits(graph: &Graph) -> u32 {
    graph.inputs.iter().map(|&id| graph.nodes[id].format.width()).sum()
}

/// The codes of the ports at a place among all inputs: their bits side by side, the first port's the most significant.
fn inputs_at(graph: &Graph, index: u64) -> Vec<i64> {
    let mut rest = bits(graph);
    let code = |&id: &NodeId| {
        let format = graph.nodes[id].format;
        rest -= format.width();
        format.wrap(i128::from(index >> rest)) as i64
    };
    graph.inputs.iter().map(code).collect()
}

fn input_text(design: &Design, codes: &[i64]) -> String {
    let ports = design.numbers(Direction::In);
    ports.iter().zip(codes).map(|((port, _), code)| format!("{port} {code}")).collect::<Vec<_>>().join(", ")
}

/// Some of all inputs, in order; what shows a fault is noted, the first of all tasks' wins.
struct Every<'a> {
    graph: &'a Graph,
    next: u64,
    end: u64,
    first: &'a [AtomicU64],
    /// The places of the faults that this task hunts.
    places: &'a [usize],
}

impl Hunt for Every<'_> {
    fn next(&mut self, block: &mut Block) -> bool {
        if self.next >= self.end {
            return false;
        }
        block.count = (self.end - self.next).min(Block::LANES as u64) as usize;
        let mut rest = bits(self.graph);
        for (&id, port) in self.graph.inputs.iter().zip(&mut block.ports) {
            let format = self.graph.nodes[id].format;
            rest -= format.width();
            for (lane, code) in port.iter_mut().enumerate() {
                *code = format.wrap(i128::from((self.next + lane as u64) >> rest)) as i64;
            }
        }
        self.next += block.count as u64;
        true
    }

    fn shown(&mut self, place: usize, lanes: u64, block: &Block) -> bool {
        let index = self.next - block.count as u64 + u64::from(lanes.trailing_zeros());
        self.first[self.places[place]].fetch_min(index, Ordering::Relaxed);
        false
    }
}

/// For each fault the place of the first input of all that shows it.
fn first_shown(graph: &Graph, tables: &[Table], faults: &[&Fault]) -> Vec<Option<u64>> {
    let probe = Probe::new(graph, tables);
    let first: Vec<AtomicU64> = faults.iter().map(|_| AtomicU64::new(u64::MAX)).collect();
    let total = 1u64 << bits(graph);
    let chunks = total.div_ceil(1 << CHUNK_BITS);
    (0..chunks).into_par_iter().for_each(|chunk| {
        let start = chunk << CHUNK_BITS;
        let open = |&place: &usize| first[place].load(Ordering::Relaxed) > start;
        let places: Vec<usize> = (0..faults.len()).filter(open).collect();
        let hunted: Vec<&Fault> = places.iter().map(|&place| faults[place]).collect();
        let end = (start + (1 << CHUNK_BITS)).min(total);
        probe.run(&hunted, &mut Every { graph, next: start, end, first: &first, places: &places });
    });
    first.into_iter().map(AtomicU64::into_inner).map(|index| (index != u64::MAX).then_some(index)).collect()
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
        let ports = self.design.numbers(Direction::In);
        block.count = 0;
        while self.left > 0 && block.count < Block::LANES {
            let row = self.dice.below(self.design.spec.shininess.rows() as u64) as u32;
            let n = self.design.spec.shininess.value(row as usize);
            let codes = match self.left % 2 {
                0 => Sample::random(self.shader, row, n, &mut self.dice).codes(self.shader),
                _ => random_codes(&ports, &mut self.dice),
            };
            block.push(&codes);
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
    let tasks = SAMPLES >> CHUNK_BITS;
    let task = |task: u64| {
        let dice = Dice::new((4 << 40) + task);
        let mut samples = Samples { design, shader, dice, left: 1 << CHUNK_BITS, shown: vec![None; faults.len()] };
        probe.run(faults, &mut samples);
        samples.shown
    };
    let all: Vec<Vec<Option<Vec<i64>>>> = (0..tasks).into_par_iter().map(task).collect();
    (0..faults.len()).map(|fault| all.iter().find_map(|shown| shown[fault].clone())).collect()
}

/// A proof from a cut that a change does not show.
fn locally(design: &Design, defect: &Defect) -> Option<Decision> {
    let Defect::Value(fault) = defect else { return None };
    let graph = design.graph();
    let width = |id: NodeId| graph.nodes[id].format.width();
    let is_constant = |id: NodeId| matches!(graph.nodes[id].op, Op::Constant(_));
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
    let most = if design.spec.block.shader().is_some() { MOST_CUT_BITS } else { MOST_LOBE_CUT_BITS };
    let mut cuts: Vec<Vec<NodeId>> = Vec::new();
    let own: Vec<NodeId> = graph.nodes[fault.node].args.iter().copied().filter(|&arg| !is_constant(arg)).collect();
    cuts.push(own);
    // What the first port selects goes with any other value, as a lobe's shininess does.
    let index = graph.index();
    let others = (0..fault.node).filter(|&id| above[id] && !is_constant(id) && id != index);
    cuts.push(vec![index]);
    cuts.extend(others.clone().map(|id| vec![id]));
    cuts.extend(others.map(|id| vec![index, id]));
    cuts.retain(|cut| !cut.is_empty() && cut.iter().map(|&id| width(id)).sum::<u32>() <= most);
    cuts.sort_by_key(|cut| cut.iter().map(|&id| width(id)).sum::<u32>());
    cuts.into_iter().find_map(|mut cut| {
        cut.sort_unstable();
        cut.dedup();
        let (part, moved) = part_behind(graph, &cut, fault)?;
        let shown = first_shown(&part, design.tables(), &[&moved]);
        let names: Vec<&str> = cut.iter().map(|&id| graph.nodes[id].name.as_str()).collect();
        let proof = format!("no value of {} shows it", names.join(" and "));
        shown[0].is_none().then_some(Decision::Same { proof })
    })
}

/// The part of a graph that some nodes alone decide, these as ports, what the rest reads of it as outputs, with a fault in it; `None` if the
/// fault is not in it.
fn part_behind(graph: &Graph, cut: &[NodeId], fault: &Fault) -> Option<(Graph, Fault)> {
    let mut inside = vec![false; graph.nodes.len()];
    for (id, node) in graph.nodes.iter().enumerate() {
        inside[id] = cut.contains(&id) || (node.op != Op::Input && node.args.iter().all(|&arg| inside[arg]));
    }
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
    let read_outside = |id: NodeId| {
        graph.is_output(id)
            || graph.nodes.iter().enumerate().any(|(user, node)| !inside[user] && node.args.contains(&id))
    };
    let outputs = (0..graph.nodes.len()).filter(|&id| inside[id] && read_outside(id));
    let outputs = outputs.map(|id| (graph.nodes[id].name.clone(), place[id])).collect();
    let inputs = cut.iter().map(|&id| place[id]).collect();
    let change = match &fault.change {
        Change::Instead { op, args } => Change::Instead { op: *op, args: args.iter().map(|&arg| place[arg]).collect() },
        other => other.clone(),
    };
    Some((Graph { nodes, inputs, outputs }, Fault { node: place[fault.node], change }))
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
            let at = (index << design.operand_format().width()) | ((first + place as i64) as u64 & (count - 1));
            found.entry(code).or_insert(at);
        }
        if found.len() > MOST_VALUES || graph.nodes[node].format.width() > u32::BITS {
            return None;
        }
    }
    Some(found)
}

/// Whether it shows when a register of a node holds the value of the input before or behind the right one.
fn of_register(design: &Design, node: NodeId, register: usize, what: Registered) -> Decision {
    let graph = design.graph();
    let Some(values) = values(design, node) else {
        return Decision::Open { tried: format!("more than {MOST_VALUES} values of the register are too many") };
    };
    let (copied, copy) = with_copy(graph, &design.schedule, node, register);
    let held =
        |&code: &i128| Fault { node: copy, change: Change::Instead { op: Op::Constant(code), args: Vec::new() } };
    let faults: Vec<Fault> = values.keys().map(held).collect();
    let faults: Vec<&Fault> = faults.iter().collect();
    let shown = first_shown(&copied, design.tables(), &faults);
    let text = |index: u64| input_text(design, &inputs_at(graph, index));
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
            proof: format!("at none of all 2^{} inputs does another of its {} values show", bits(graph), values.len()),
        },
    }
}
