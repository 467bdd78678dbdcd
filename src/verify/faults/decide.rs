//! What becomes of mutants: what vectors do not detect is decided.
//!
//! A change of what is computed is decided by running inputs through the graph with the change in it: all of them,
//! where the ports are narrow enough. Before that, and for cores that are no lobes instead, a proof is sought in a part
//! of the graph.
//!
//! A change of a pipeline register puts the value of one input in the place of another's. It is decided the same way,
//! for the few values that a register that survives can hold.

use std::collections::BTreeMap;

use rayon::prelude::*;

use super::domain::{Domain, first_detected};
use super::local::Local;
use super::mutants::Mutant;
use super::registers::{RegisterSimulation, Shown};
use super::simulation::{FaultSimulation, blocks, held_in_register};
use super::{MOST_VALUES, Outcome, inputs_text};
use crate::core::Design;
use crate::core::golden::{Vector, clocks, idle};
use crate::datapath::evaluate::Evaluator;
use crate::datapath::fault::{Defect, Fault, Registered, Timing};
use crate::datapath::graph::{Graph, NodeId};
use crate::datapath::simulate::Inputs;
use crate::fixed::Rng;

/// Ports of more codes than these together are not run through all of them.
const MOST_INPUTS: u64 = 1 << 34;
/// Inputs that are sampled, and those of one task.
const SAMPLES: u64 = 1 << 20;
const OF_TASK: u64 = 1 << 16;

/// What becomes of mutants of a design, in their order. `detect` says what is seen of a defect by golden vectors, if
/// anything is.
#[must_use]
pub fn outcomes(
    design: &Design,
    mutants: &[Mutant],
    vectors: &[&Vector],
    detect: &(dyn Fn(&Defect) -> Option<String> + Sync),
) -> Vec<Outcome> {
    let known = known(design, mutants, vectors);
    let seen = |(mutant, known): (&Mutant, Option<Option<String>>)| known.unwrap_or_else(|| detect(&mutant.defect));
    let detected: Vec<Option<String>> = mutants.par_iter().zip(known).map(seen).collect();
    let left = mutants.iter().zip(&detected).filter(|(_, detected)| detected.is_none());
    let mut decided = decide(design, &left.map(|(mutant, _)| &mutant.defect).collect::<Vec<_>>()).into_iter();
    let outcome = |detected: Option<String>| match detected {
        Some(by) => Outcome::Detected { by },
        None => decided.next().expect("each mutant that is left is decided"),
    };
    detected.into_iter().map(outcome).collect()
}

/// What vectors show of each mutant of which that is known without a simulation of the pipeline: of a change of an
/// operation that changes no result nothing, if the words of memories stay; of a mistake in a register the result that
/// is another.
fn known(design: &Design, mutants: &[Mutant], vectors: &[&Vector]) -> Vec<Option<Option<String>>> {
    let mut known = vec![None; mutants.len()];
    let registers = RegisterSimulation::new(design);
    if design.write_ports().is_empty() {
        let of_operation = |(place, mutant): (usize, &Mutant)| Some((place, mutant.defect.fault()?.clone()));
        let (places, faults): (Vec<usize>, Vec<Fault>) = mutants.iter().enumerate().filter_map(of_operation).unzip();
        let mut inputs = blocks(vectors.iter().map(|vector| &vector.inputs));
        let first = registers.simulation.first(&faults.iter().collect::<Vec<_>>(), &mut *inputs);
        places
            .into_iter()
            .zip(first)
            .filter(|(_, first)| first.is_none())
            .for_each(|(place, _)| known[place] = Some(None));
    }
    let defects: Vec<&Defect> = mutants.iter().map(|mutant| &mutant.defect).collect();
    // As after a reset.
    let inputs: Vec<Inputs> = idle(design).chain(clocks(design, vectors)).collect();
    for (known, shown) in known.iter_mut().zip(registers.shown(&inputs, &defects)) {
        if let Shown::By(vector) = shown {
            *known = Some(Some(format!("vector {}: another result", vector + 1)));
        }
    }
    known
}

/// What is found out of mutants of a design that no vector detects, in their order.
#[must_use]
pub fn decide(design: &Design, defects: &[&Defect]) -> Vec<Outcome> {
    let (graph, tables) = (design.graph(), design.tables());
    let local = Local::of(design);
    let proof = |defect: &&Defect| local.proof(defect.fault()?).map(|proof| Outcome::Equivalent { proof });
    let mut outcomes: Vec<Option<Outcome>> = defects.par_iter().map(proof).collect();
    let open = |&place: &usize| outcomes[place].is_none();
    let left: Vec<(usize, &Fault)> =
        (0..defects.len()).filter(open).filter_map(|place| Some((place, defects[place].fault()?))).collect();
    let faults: Vec<&Fault> = left.iter().map(|(_, fault)| *fault).collect();
    let inputs = Domain::whole(graph);
    if design.is_sampled() {
        for ((place, _), inputs) in left.iter().zip(sampled(design, &faults)) {
            outcomes[*place] = Some(match inputs {
                Some(inputs) => Outcome::Survived { input: inputs_text(design, &inputs) },
                None => Outcome::Undecided { tried: format!("{SAMPLES} inputs and every part of the graph") },
            });
        }
    } else if let Some(total) = inputs.count().filter(|&total| total <= MOST_INPUTS) {
        for ((place, _), index) in left.iter().zip(first_detected(graph, tables, &inputs, total, &faults)) {
            outcomes[*place] = Some(match index {
                Some(index) => Outcome::Survived { input: inputs_text(design, &inputs.at(index)) },
                None => Outcome::Equivalent { proof: format!("none of all {total} inputs shows it") },
            });
        }
        for (outcome, defect) in outcomes.iter_mut().zip(defects) {
            if let Defect::Timing(Timing::Register { node, register, what }) = defect {
                *outcome = Some(of_register(design, &inputs, total, *node, *register, *what));
            }
        }
    }
    let open = || Outcome::Undecided { tried: "nothing but the vectors".to_owned() };
    outcomes.into_iter().map(|outcome| outcome.unwrap_or_else(open)).collect()
}

/// For each fault an input that shows it, if there is one among many samples.
fn sampled(design: &Design, faults: &[&Fault]) -> Vec<Option<Vec<i64>>> {
    let simulation = FaultSimulation::new(design.graph(), design.tables());
    let tasks = SAMPLES / OF_TASK;
    let task = |task: u64| {
        let mut rng = Rng::new((4 << 40) + task);
        simulation.first(faults, &mut *blocks((0..OF_TASK).map(|_| design.varied(&mut rng))))
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
    let [index, operand] = [graph.index(), graph.operand()].map(|port| graph.nodes[port].format);
    let (first, count) = (operand.min_code() as i64, 1u64 << operand.width());
    let mut codes = vec![0u32; count as usize];
    for index in 0..1u64 << index.width() {
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
) -> Outcome {
    let Some(values) = values(design, node) else {
        return Outcome::Undecided { tried: format!("more than {MOST_VALUES} values of the register are too many") };
    };
    let (graph, faults) = held_in_register(design, node, register, values.keys().copied());
    let faults: Vec<&Fault> = faults.iter().collect();
    let shown = first_detected(&graph, design.tables(), inputs, total, &faults);
    let text = |index: u64| inputs_text(design, &inputs.at(index));
    let pair = shown.into_iter().zip(values.values()).find_map(|(shown, &other)| Some((shown?, other)));
    match pair {
        Some((index, other)) => {
            let order = match what {
                Registered::Missing => "then",
                Registered::Doubled => "after",
                Registered::FreeRunning => "then, after a clock without ce,",
            };
            Outcome::Survived { input: format!("{} {order} {}", text(index), text(other)) }
        }
        None => Outcome::Equivalent {
            proof: format!("at none of all {total} inputs does another of its {} values show", values.len()),
        },
    }
}
