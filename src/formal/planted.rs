//! Faults planted in one of two circuits that were proved the same: the proof must not go through with any of them.

use super::abc::Answer;
use super::circuit::{Bit, Part};
use super::equivalence::{Comparison, Method, Pipeline};
use crate::error::Error;

/// A part with a fault in its stead, if it can have it.
type Fault = fn(&Part) -> Option<Part>;

/// The faults of the registers: each makes the circuit no pipeline.
const OF_REGISTERS: [(&str, Fault); 3] = [
    ("a register turned into a wire", |part| match part {
        Part::Register(register) if register.reset.is_none() => {
            Some(Part::And { a: register.d, b: Bit::Constant(true), y: register.q })
        }
        _ => None,
    }),
    ("a register that ignores ce", |part| match part {
        Part::Register(register) if register.reset.is_none() => {
            Some(Part::Register(super::circuit::Register { enable: None, ..register.clone() }))
        }
        _ => None,
    }),
    ("a valid bit that ignores rst", |part| match part {
        Part::Register(register) if register.reset.is_some() => {
            Some(Part::Register(super::circuit::Register { reset: None, ..register.clone() }))
        }
        _ => None,
    }),
];

/// Plants one fault after the other in the second circuit of a comparison that went through by this method, asks it again, and returns how many there were and which
/// of them were not found.
///
/// # Errors
/// If the solver does not work.
pub(super) fn check(comparison: &Comparison, method: &Method, seconds: u32) -> Result<(usize, Vec<String>), Error> {
    let other = comparison.sides[1];
    let mut planted = 0;
    let mut missed = Vec::new();
    let mut note = |what: &str, found: bool| {
        planted += 1;
        if !found {
            missed.push(what.to_owned());
        }
    };
    for (what, fault) in OF_REGISTERS {
        let mut circuit = other.circuit.clone();
        let places: Vec<usize> =
            (0..circuit.parts.len()).filter(|&place| fault(&circuit.parts[place]).is_some()).collect();
        // One in the middle of the pipeline.
        let found = places.get(places.len() / 2).is_some_and(|&place| {
            circuit.parts[place] = fault(&circuit.parts[place]).expect("it has the fault");
            Pipeline::of(circuit, other.depth).is_err()
        });
        note(what, found);
    }
    let found = |comparison: &Comparison, planted: bool| -> Result<bool, Error> {
        Ok(comparison.ask(method, planted, seconds)?.answer == Answer::Different)
    };
    note("one wrong result", found(comparison, true)?);
    // A bit of a word of a memory is wrong.
    let memory = other.circuit.memories.iter().position(|memory| memory.writes.is_empty());
    if let Some(memory) = memory {
        let mut faulty = other.clone();
        let words = &mut faulty.circuit.memories[memory].words;
        let middle = words.len() / 2;
        // A result may not show the lowest bit; the highest is padding where GHDL widens the words, which a kernel's are not.
        let word = &mut words[middle];
        let bit = if matches!(method, Method::Stages(_)) { 0 } else { word.len() - 1 };
        word[bit] = !word[bit];
        let wrong = Comparison { sides: [comparison.sides[0], &faulty], reads: comparison.reads.clone() };
        let found = found(&wrong, false)?;
        note("a wrong bit in a memory", found);
    }
    Ok((planted, missed))
}
