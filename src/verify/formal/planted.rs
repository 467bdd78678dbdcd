//! Faults planted in one of two circuits that were proved the same: the proof must not go through with any of them.

use super::abc::Answer;
use super::circuit::{Bit, Part};
use super::equivalence::{Comparison, Method, Pipeline};
use crate::core::Design;
use crate::platform::error::Error;
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

/// What came of planted faults.
#[derive(Default)]
pub(super) struct Planted {
    /// How many could be planted.
    pub planted: usize,
    /// Which of them were not found.
    pub missed: Vec<String>,
    /// Which could not be planted, and why: a core whose results are constants has no registers for them, and reads no memory.
    pub impossible: Vec<String>,
}

impl Planted {
    fn note(&mut self, what: &str, found: bool) {
        self.planted += 1;
        if !found {
            self.missed.push(what.to_owned());
        }
    }
}

/// The most words of a memory whose bits are tried where a wrong bit in the middle one shows in no result.
const MOST_WORDS: usize = 8;

/// Plants one fault after the other in the second circuit of a comparison that went through by this method, asks it again, and returns what
/// came of it. `golden` are vectors of the design: a bit of a memory that the proof passes over must change no result of theirs either.
///
/// # Errors
/// If the solver does not work.
pub(super) fn check(
    comparison: &Comparison,
    method: &Method,
    (design, golden): (&Design, &Golden),
    seconds: u32,
) -> Result<Planted, Error> {
    let other = comparison.sides[1];
    let mut planted = Planted::default();
    for (what, fault) in OF_REGISTERS {
        let mut circuit = other.circuit.clone();
        let places: Vec<usize> =
            (0..circuit.parts.len()).filter(|&place| fault(&circuit.parts[place]).is_some()).collect();
        // One in the middle of the pipeline.
        let Some(&place) = places.get(places.len() / 2) else {
            planted.impossible.push(format!("{what} (there is none)"));
            continue;
        };
        circuit.parts[place] = fault(&circuit.parts[place]).expect("it has the fault");
        planted.note(what, Pipeline::of(circuit, other.depth).is_err());
    }
    let found = |comparison: &Comparison, planted: bool| -> Result<bool, Error> {
        Ok(comparison.ask(method, planted, seconds)?.answer == Answer::Different)
    };
    planted.note("one wrong result", found(comparison, true)?);
    // A bit of a word of a memory is wrong.
    let Some(memory) = other.circuit.memories.iter().position(|memory| memory.writes.is_empty()) else {
        return Ok(planted);
    };
    let words = &other.circuit.memories[memory].words;
    let with = |place: usize, bit: usize| {
        let mut faulty = other.clone();
        let word = &mut faulty.circuit.memories[memory].words[place];
        word[bit] = !word[bit];
        faulty
    };
    let seen = |faulty: &Pipeline| -> Result<bool, Error> {
        found(&Comparison { sides: [comparison.sides[0], faulty], reads: comparison.reads.clone() }, false)
    };
    const WHAT: &str = "a wrong bit in a memory";
    // A result may not show the lowest bit; the highest is padding where GHDL widens the words, which a kernel's are not.
    let middle = words.len() / 2;
    let bit = if matches!(method, Method::Stages(_)) { 0 } else { words[middle].len() - 1 };
    if seen(&with(middle, bit))? {
        planted.note(WHAT, true);
        return Ok(planted);
    }
    // It may be a bit that no result shows: then one that vectors show, and if there is none, none can be planted.
    let step = words.len().div_ceil(MOST_WORDS);
    let bits = std::iter::once(middle)
        .chain((0..words.len()).step_by(step))
        .flat_map(|place| (0..words[place].len()).map(move |bit| (place, bit)));
    let shown = bits.map(|(place, bit)| with(place, bit)).find(|faulty| faulty.against(design, golden).is_err());
    match shown {
        Some(faulty) => planted.note(WHAT, seen(&faulty)?),
        None => planted.impossible.push(format!("{WHAT} (no result of the golden vectors depends on one)")),
    }
    Ok(planted)
}
