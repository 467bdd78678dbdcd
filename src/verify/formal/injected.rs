//! Faults injected in one of two circuits that were proved the same: the proof must not go through with any of them.

use super::abc::Answer;
use super::circuit::{Bit, Part};
use super::equivalence::{Comparison, Results, Technique};
use super::pipeline::Pipeline;
use crate::core::Design;
use crate::platform::error::Error;
use crate::verify::faults::Outcome;
use crate::verify::golden::Golden;

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

/// The most words of a memory whose bits are tried where a wrong bit in the middle one shows in no result.
const MOST_WORDS: usize = 8;

/// Injects one fault after the other in the second circuit of a comparison that went through by this method, asks it
/// again, and returns each with what became of it: one that the circuit cannot have is not decided. A core whose
/// results are constants has no registers, and reads no memory. `golden` are vectors of the design: a bit of a memory
/// that the proof passes over must change no result of theirs either. Errors: if the solver does not work.
pub(super) fn check(
    comparison: &Comparison,
    method: &Technique,
    (design, golden): (&Design, &Golden),
    seconds: u32,
) -> Result<Vec<(&'static str, Outcome)>, Error> {
    let other = comparison.sides[1];
    let mut outcomes = Vec::new();
    for (what, fault) in OF_REGISTERS {
        let mut circuit = other.circuit.clone();
        let places: Vec<usize> =
            (0..circuit.parts.len()).filter(|&place| fault(&circuit.parts[place]).is_some()).collect();
        // One in the middle of the pipeline.
        let Some(&place) = places.get(places.len() / 2) else {
            outcomes.push((what, Outcome::Undecided { tried: "there is none".to_owned() }));
            continue;
        };
        circuit.parts[place] = fault(&circuit.parts[place]).expect("it has the fault");
        outcomes.push((what, outcome(Pipeline::of(circuit, other.depth).err())));
    }
    let found = |comparison: &Comparison, results: Results| -> Result<Option<String>, Error> {
        let asked = comparison.ask(method, results, seconds)?;
        Ok((asked.answer == Answer::Different).then(|| "the outputs differ".to_owned()))
    };
    outcomes.push(("one wrong result", outcome(found(comparison, Results::OneWrong)?)));
    // A bit of a word of a memory is wrong.
    let Some(memory) = other.circuit.memories.iter().position(|memory| memory.writes.is_empty()) else {
        return Ok(outcomes);
    };
    let words = &other.circuit.memories[memory].words;
    let with = |place: usize, bit: usize| {
        let mut faulty = other.clone();
        let word = &mut faulty.circuit.memories[memory].words[place];
        word[bit] = !word[bit];
        faulty
    };
    let seen = |faulty: &Pipeline| {
        found(&Comparison { sides: [comparison.sides[0], faulty], reads: comparison.reads.clone() }, Results::Own)
    };
    const WHAT: &str = "a wrong bit in a memory";
    // A result may not show the lowest bit; the highest is padding where GHDL widens the words, which a kernel's are
    // not.
    let middle = words.len() / 2;
    let bit = if matches!(method, Technique::Stages(_)) { 0 } else { words[middle].len() - 1 };
    if let by @ Some(_) = seen(&with(middle, bit))? {
        outcomes.push((WHAT, outcome(by)));
        return Ok(outcomes);
    }
    // It may be a bit that no result shows: then one that vectors show, and if there is none, none can be injected.
    let step = words.len().div_ceil(MOST_WORDS);
    let bits = std::iter::once(middle)
        .chain((0..words.len()).step_by(step))
        .flat_map(|place| (0..words[place].len()).map(move |bit| (place, bit)));
    let shown = bits.map(|(place, bit)| with(place, bit)).find(|faulty| faulty.against(design, golden).is_err());
    let none = || Outcome::Undecided { tried: "no result of the golden vectors depends on one".to_owned() };
    outcomes.push((WHAT, shown.map_or_else(|| Ok(none()), |faulty| seen(&faulty).map(outcome))?));
    Ok(outcomes)
}

/// What became of a fault that is in the circuit.
fn outcome(by: Option<String>) -> Outcome {
    match by {
        Some(by) => Outcome::Detected { by },
        None => Outcome::Survived { input: "the circuit with the fault".to_owned() },
    }
}
