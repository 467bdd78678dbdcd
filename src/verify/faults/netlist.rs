//! Mutants of the netlist of a core's Verilog: a bit of a cell's port inverted, constant, or inverted by another bit of the cell.
//!
//! What the vectors do not kill is decided. A mistake in what a cell computes or a register takes is a function of an input's values: it is
//! the core's or not, which is proved, or all inputs are run through it. A mistake in a register's clock, enable or reset
//! depends on what came before, so random clocks are run through it, and the last inputs are reduced to those that are needed to show it.

use std::sync::LazyLock;

use rayon::prelude::*;

use super::Fate;
use crate::core::Design;
use crate::core::Direction;
use crate::core::edges::varied;
use crate::fixed::Dice;
use crate::platform::error::Error;
use crate::synth::{Listed, Mutated, mutated, mutated_by};
use crate::verify::cosim::{AtRandom, Found, Mutants};
use crate::verify::formal::{self, Told};
use crate::verify::golden::{Golden, Vector};

/// Random clocks of the control inputs.
const CLOCKS: u32 = 1 << 20;
/// Samples of a shader.
const SAMPLES: usize = 1 << 18;
/// All inputs are run in the simulator, one after the other, where the ports have so many bits at most.
const MOST_BITS: u32 = 22;

/// A mutant of a netlist, and what became of it.
#[derive(Clone, Debug)]
pub struct NetlistMutant {
    /// The mode, the cell, its port and bit, as Yosys names them.
    pub what: String,
    /// What became of it.
    pub fate: Fate,
}

/// So many mutants of a core's Verilog, drawn by `seed`, under golden vectors.
///
/// # Errors
/// A tool that is missing or fails, or a harness that finds the netlist wrong without a mutant.
pub fn fates(
    design: &Design,
    verilog: &[u8],
    golden: &Golden,
    count: u32,
    seed: u32,
) -> Result<Vec<NetlistMutant>, Error> {
    let top = &design.spec.name;
    let Mutated { verilog: netlist, mutants: list } = mutated(top, verilog, count, seed)?;
    let mutants = Mutants::of(design, &netlist)?;
    let found = mutants.golden(golden, list.len() as u32 + 1)?;
    if found[0] != Found::Not {
        return Err(Error::ToolFailed {
            tool: "the netlist without a mutant".to_owned(),
            what: format!("differs from the golden vectors: {:?}", found[0]),
            output: String::new(),
        });
    }
    let functions: Vec<usize> =
        (0..list.len()).filter(|&place| found[place + 1] == Found::Not && !list[place].is_control).collect();
    let mut told: Vec<Option<Told>> = vec![None; list.len()];
    if !functions.is_empty() {
        let chosen: Vec<&Listed> = functions.iter().map(|&place| &list[place]).collect();
        let numbers: Vec<u32> = functions.iter().map(|&place| place as u32 + 1).collect();
        let answers = formal::told(design, &mutated_by(top, verilog, &chosen)?, &numbers)?;
        functions.into_iter().zip(answers).for_each(|(place, answer)| told[place] = Some(answer));
    }
    let samples = LazyLock::new(|| samples(design));
    let fate = |(place, (listed, told)): (usize, (Listed, Option<Told>))| {
        let fate = match found[place + 1] {
            Found::ByReset => Fate::Killed { by: "the reset".to_owned() },
            Found::ByVector(number) => Fate::Killed { by: format!("vector {number}") },
            Found::Not => decided(design, &mutants, &samples, place as u32 + 1, told)?,
        };
        Ok(NetlistMutant { what: listed.what, fate })
    };
    list.into_par_iter().zip(told).enumerate().map(fate).collect()
}

/// What becomes of a mutant that the vectors do not kill, given what was told of it as a function.
fn decided(
    design: &Design,
    mutants: &Mutants,
    samples: &LazyLock<Vec<Vector>, impl FnOnce() -> Vec<Vector>>,
    mutant: u32,
    told: Option<Told>,
) -> Result<Fate, Error> {
    let survives = |inputs: &[Vec<i64>]| Fate::Survives { input: inputs_text(design, inputs) };
    let mut tried = Vec::new();
    let is_function = matches!(told, Some(Told::Open(_) | Told::Other(_)));
    match told {
        Some(Told::Same(proof)) => return Ok(Fate::Equivalent { proof }),
        // What the simulator does not show may hang on a bit that the netlist leaves undefined.
        Some(Told::Other(codes)) if mutants.show(mutant, std::slice::from_ref(&codes))? => {
            return Ok(survives(&[codes]));
        }
        Some(Told::Other(codes)) => tried.push(format!("a proof, which {} refutes", inputs_text(design, &[codes]))),
        Some(Told::Open(why) | Told::Unfit(why)) => tried.push(format!("a proof ({why})")),
        Some(Told::Refuted) => tried.push("a proof, which ABC refutes".to_owned()),
        None => {}
    }
    let bits: u32 = design.numbers(Direction::In).iter().map(|(_, format)| format.width()).sum();
    // Run one a clock, they say nothing of what a register does when it should wait.
    if is_function && bits <= MOST_BITS {
        let words = if design.write_ports().is_empty() { "" } else { " with the words that the memory comes up with" };
        return Ok(match mutants.every(mutant, 0, 1 << bits)? {
            Some(place) => survives(&[mutants.inputs_at(place)]),
            None => Fate::Equivalent { proof: format!("none of all 2^{bits} inputs, one a clock, shows it{words}") },
        });
    }
    if design.spec.block.shader().is_some() {
        if let Some(place) = mutants.first_of(mutant, samples)? {
            // It is one that is on its way through the core then.
            let first = place.saturating_sub(design.schedule.latency as usize + 1);
            let recent: Vec<Vec<i64>> = samples[first..=place].iter().map(|vector| vector.inputs.clone()).collect();
            let needed = reduced(mutants, mutant, recent.clone())?;
            return Ok(survives(&needed.unwrap_or(recent)));
        }
        tried.push(format!("{SAMPLES} samples"));
    }
    if let Some(AtRandom { clock, recent }) = mutants.at_random(mutant, CLOCKS)? {
        return Ok(match reduced(mutants, mutant, recent)? {
            Some(inputs) => survives(&inputs),
            None => Fate::Survives { input: format!("random inputs, ce, in_valid and rst, at clock {clock}") },
        });
    }
    tried.push(format!("{CLOCKS} random clocks"));
    Ok(Fate::Undecided { tried: tried.join(" and ") })
}

/// Inputs of a shader as vectors: of random codes, hardly any sees a highlight.
fn samples(design: &Design) -> Vec<Vector> {
    let Some(shader) = design.spec.block.shader() else { return Vec::new() };
    let mut dice = Dice::new(7 << 40);
    let inputs: Vec<Vec<i64>> = (0..SAMPLES).map(|_| varied(design, shader, &mut dice)).collect();
    let vector = |inputs: Vec<i64>| Vector { outputs: design.evaluate(&inputs), inputs, idle: 0, stall: 0 };
    inputs.into_par_iter().map(vector).collect()
}

/// An input that shows a mutant as a vector, if one of these does; else as few of them, in their order, as show it; `None` if not even all do.
fn reduced(mutants: &Mutants, mutant: u32, recent: Vec<Vec<i64>>) -> Result<Option<Vec<Vec<i64>>>, Error> {
    for inputs in recent.iter().rev() {
        if mutants.show(mutant, std::slice::from_ref(inputs))? {
            return Ok(Some(vec![inputs.clone()]));
        }
    }
    if !mutants.show(mutant, &recent)? {
        return Ok(None);
    }
    let (mut kept, mut place) = (recent, 0);
    while place < kept.len() {
        let mut fewer = kept.clone();
        fewer.remove(place);
        if mutants.show(mutant, &fewer)? {
            kept = fewer;
        } else {
            place += 1;
        }
    }
    Ok(Some(kept))
}

/// Inputs with the names of the ports, for people.
fn inputs_text(design: &Design, inputs: &[Vec<i64>]) -> String {
    let ports = design.numbers(Direction::In);
    let text = |codes: &Vec<i64>| {
        let codes: Vec<String> = ports.iter().zip(codes).map(|((port, _), code)| format!("{port} {code}")).collect();
        codes.join(", ")
    };
    inputs.iter().map(text).collect::<Vec<_>>().join(", then ")
}
