//! What a core whose memories can be written computes when they hold other words.

use std::collections::BTreeMap;

use super::{Golden, Vector};
use crate::core::Design;
use crate::fixed::Table;

/// Vectors that are tried with other words; as many shininesses.
const MOST: usize = 64;

/// A memory of a design that can be written, with every bit of every word inverted; any other as it is.
#[must_use]
pub fn complemented_tables(design: &Design) -> Vec<Table> {
    let ports = design.write_ports();
    let written = |memory: usize| ports.iter().any(|port| port.memory == memory);
    let tables = design.tables().iter().enumerate();
    tables.map(|(memory, table)| if written(memory) { table.complemented() } else { table.clone() }).collect()
}

/// Some inputs of the golden vectors, at evenly spaced codes of the first port, with the outputs that the core gives for them when
/// [`complemented_tables`] are in its memories. They are such as differ from the golden outputs, as far as there are any, so that a core
/// that was not written to does not pass. None for a core that cannot be written.
///
/// The inverted words are far outside what the error analysis is about: what they give is a number all the same, since every operation
/// takes its result modulo its format's width.
#[must_use]
pub fn complemented(design: &Design, golden: &Golden) -> Vec<Vector> {
    if design.write_ports().is_empty() {
        return Vec::new();
    }
    let tables = complemented_tables(design);
    let graph = design.graph();
    // For each code of the first port those that differ, or all if none does.
    let mut of_index: BTreeMap<i64, (bool, Vec<Vector>)> = BTreeMap::new();
    for vector in golden.vectors() {
        let inputs: Vec<i128> = vector.inputs.iter().copied().map(i128::from).collect();
        let values = graph.values(&tables, &inputs);
        let outputs: Vec<i64> = graph.outputs.iter().map(|&(_, id)| values[id] as i64).collect();
        let differs = outputs != vector.outputs;
        let (known, vectors) = of_index.entry(vector.inputs[0]).or_default();
        if differs && !*known {
            *known = true;
            vectors.clear();
        }
        if differs || !*known {
            vectors.push(Vector { inputs: vector.inputs.clone(), outputs, idle: 0, stall: 0 });
        }
    }
    if of_index.values().any(|&(differs, _)| differs) {
        of_index.retain(|_, (differs, _)| *differs);
    }
    let step = of_index.len().div_ceil(MOST).max(1);
    // The middle one is neither at the start of the lobe nor far beyond its end.
    of_index.into_values().step_by(step).map(|(_, mut vectors)| vectors.swap_remove(vectors.len() / 2)).collect()
}
