//! Mutants of the netlist of a core's Verilog: a bit of a cell's port inverted, constant, or inverted by another bit of
//! the cell.
//!
//! What the vectors do not detect is decided. A mistake in what a cell computes or a register takes is a function of an
//! input's values: it is the core's or not, which is proved, or all inputs are run through it. A mistake in a
//! register's clock, enable or reset depends on what came before, so random clocks are run through it, and the last
//! inputs are reduced to those that are needed to show it.
//!
//! The netlist has an input `mutant` and is the core where that is 0. For the proof that a mutant is the core, it must
//! be a pipeline as well, as in `equivalence`, with the same registers; then the two are compared stage by
//! stage, cut at all registers that are the same in random runs, then by running every value of the inputs through all
//! circuits that are left at once, and where there are too many of these as functions from the inputs to the outputs.

use std::sync::LazyLock;

use rayon::prelude::*;

use super::abc::Answer;
use super::circuit::{Circuit, Unfit};
use super::equivalence::{Comparison, Results, Technique};
use super::pipeline::{Pipeline, first_shown};
use crate::core::{Design, Direction};
use crate::fixed::{Format, Rng};
use crate::platform::error::Error;
use crate::synth::yosys::Yosys;
use crate::synth::{Listed, Mutated, mutated, mutated_by};
use crate::verify::cosim::{AtRandom, Mutants};
use crate::verify::faults::{Outcome, inputs_text};
use crate::verify::golden::{Golden, Vector};

/// The most that the solver may take at once, in seconds.
const SECONDS: u32 = 5;
/// Random clocks of the control inputs.
const CLOCKS: u32 = 1 << 20;
/// Samples of a core that has too many inputs to run through.
const SAMPLES: usize = 1 << 18;
/// All inputs are run in the simulator, one after the other, where the ports have so many bits at most.
const MOST_BITS: u32 = 22;

/// A mutant of a netlist, and what became of it.
#[derive(Clone, Debug)]
pub struct NetlistMutant {
    /// The mode, the cell, its port and bit, as Yosys names them.
    pub what: String,
    /// What became of it.
    pub outcome: Outcome,
}

/// So many mutants of a core's Verilog, drawn by `seed`, under golden vectors.
///
/// # Errors
/// A tool that is missing or fails, or a harness that finds the netlist wrong without a mutant.
pub fn outcomes(
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
    if let Some(found) = found[0] {
        return Err(Error::ToolFailed {
            tool: "the netlist without a mutant".to_owned(),
            what: format!("differs from the golden vectors: {found:?}"),
            output: String::new(),
        });
    }
    let functions: Vec<usize> =
        (0..list.len()).filter(|&place| found[place + 1].is_none() && !list[place].is_control).collect();
    let mut proofs: Vec<Option<Proof>> = vec![None; list.len()];
    if !functions.is_empty() {
        let chosen: Vec<&Listed> = functions.iter().map(|&place| &list[place]).collect();
        let numbers: Vec<u32> = functions.iter().map(|&place| place as u32 + 1).collect();
        let proved = prove(design, &mutated_by(top, verilog, &chosen)?, &numbers)?;
        functions.into_iter().zip(proved).for_each(|(place, proof)| proofs[place] = Some(proof));
    }
    let samples = LazyLock::new(|| samples(design));
    let outcome = |(place, (listed, proof)): (usize, (Listed, Option<Proof>))| {
        let outcome = match found[place + 1] {
            Some(by) => Outcome::Detected { by: by.to_string() },
            None => decided(design, &mutants, &samples, place as u32 + 1, proof)?,
        };
        Ok(NetlistMutant { what: listed.what, outcome })
    };
    list.into_par_iter().zip(proofs).enumerate().map(outcome).collect()
}

/// What becomes of a mutant that the vectors do not detect, given what is proved of it as a function.
fn decided(
    design: &Design,
    mutants: &Mutants,
    samples: &LazyLock<Vec<Vector>, impl FnOnce() -> Vec<Vector>>,
    mutant: u32,
    proof: Option<Proof>,
) -> Result<Outcome, Error> {
    let survives = |inputs: &[Vec<i64>]| Outcome::Survived { input: sequence_text(design, inputs) };
    let mut tried = Vec::new();
    let mut is_function = false;
    match proof {
        Some(Proof::Same(proof)) => return Ok(Outcome::Equivalent { proof }),
        // What the simulator does not show may hang on a bit that the netlist leaves undefined.
        Some(Proof::Refuted(codes)) if mutants.show(mutant, std::slice::from_ref(&codes))? => {
            return Ok(survives(&[codes]));
        }
        Some(Proof::Refuted(codes)) => {
            is_function = true;
            tried.push(format!("a proof, which {} refutes", inputs_text(design, &codes)));
        }
        Some(Proof::Open { why, is_pipeline }) => {
            is_function = is_pipeline;
            tried.push(format!("a proof{why}"));
        }
        None => {}
    }
    let bits: u32 = design.numbers(Direction::In).iter().map(|(_, format)| format.width()).sum();
    // Run one a clock, they say nothing of what a register does when it should wait.
    if is_function && bits <= MOST_BITS {
        let words = if design.write_ports().is_empty() { "" } else { " with the words that the memory comes up with" };
        return Ok(match mutants.every(mutant, 0, 1 << bits)? {
            Some(place) => survives(&[mutants.inputs_at(place)]),
            None => Outcome::Equivalent { proof: format!("none of all 2^{bits} inputs, one a clock, shows it{words}") },
        });
    }
    if design.is_sampled() {
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
            None => Outcome::Survived { input: format!("random inputs, ce, in_valid and rst, at clock {clock}") },
        });
    }
    tried.push(format!("{CLOCKS} random clocks"));
    Ok(Outcome::Undecided { tried: tried.join(" and ") })
}

/// Inputs as vectors: of random codes, hardly any sees a highlight.
fn samples(design: &Design) -> Vec<Vector> {
    let mut rng = Rng::new(7 << 40);
    let inputs: Vec<Vec<i64>> = (0..SAMPLES).map(|_| design.varied(&mut rng)).collect();
    let vector = |inputs: Vec<i64>| Vector { outputs: design.evaluate(&inputs), inputs, idle: 0, stall: 0 };
    inputs.into_par_iter().map(vector).collect()
}

/// An input that shows a mutant as a vector, if one of these does; else as few of them, in their order, as show it;
/// `None` if not even all do.
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

/// Inputs one behind the other, with the names of the ports, for people.
fn sequence_text(design: &Design, inputs: &[Vec<i64>]) -> String {
    inputs.iter().map(|codes| inputs_text(design, codes)).collect::<Vec<_>>().join(", then ")
}

/// What is proved of a mutant as a function.
#[derive(Clone, Debug)]
enum Proof {
    /// It is the same circuit: how that is proved.
    Same(String),
    /// It is another: the codes of the input ports, in order, for which it gives something else.
    Refuted(Vec<i64>),
    /// Neither is known, or nothing that shows the difference: why, behind "a proof".
    Open {
        why: String,
        /// It is a pipeline as the core is: unless it is one, what it gives may depend on what came before.
        is_pipeline: bool,
    },
}

impl From<Unfit> for Proof {
    fn from(why: Unfit) -> Self {
        Self::Open { why: format!(" ({why})"), is_pipeline: false }
    }
}

/// What is proved of mutants of a core's netlist, by their numbers. The netlist, with the input `mutant`, holds no
/// other mutants. Errors: a tool that is not installed or does not do its work.
fn prove(design: &Design, netlist: &[u8], mutants: &[u32]) -> Result<Vec<Proof>, Error> {
    let all = |why: Unfit| Ok(vec![Proof::from(why); mutants.len()]);
    let circuit = match Circuit::read_netlist(&Yosys::find(None)?, &design.spec.name, netlist)? {
        Ok(circuit) => circuit,
        Err(why) => return all(why),
    };
    let side = |mutant: u32| Pipeline::of(circuit.with("mutant", mutant), design.schedule.latency);
    let core = match side(0) {
        Ok(core) => core,
        Err(why) => return all(why),
    };
    let sides: Vec<Result<Pipeline, Unfit>> = mutants.par_iter().map(|&mutant| side(mutant)).collect();
    let by_stages = |side: &Result<Pipeline, Unfit>| match side {
        Ok(side) => Ok(is_same_by_stages(&core, side)?.then(|| Proof::Same("stage by stage".to_owned()))),
        Err(why) => Ok(Some(Proof::from(why.clone()))),
    };
    let mut proofs = sides.par_iter().map(by_stages).collect::<Result<Vec<Option<Proof>>, Error>>()?;
    let left: Vec<usize> = (0..proofs.len()).filter(|&place| proofs[place].is_none()).collect();
    let others: Vec<&Pipeline> = left.iter().filter_map(|&place| sides[place].as_ref().ok()).collect();
    let ports = design.numbers(Direction::In);
    if let Some(shown) = first_shown(&core, &others) {
        let bits: u32 = ports.iter().map(|(_, format)| format.width()).sum();
        for (place, codes) in left.into_iter().zip(shown) {
            proofs[place] = Some(match codes {
                None => Proof::Same(format!("none of all 2^{bits} inputs shows it")),
                Some(codes) => {
                    let code = |(name, format): &(&str, Format)| {
                        format.wrap(codes.get(*name).copied().unwrap_or_default().into()) as i64
                    };
                    Proof::Refuted(ports.iter().map(code).collect())
                }
            });
        }
    } else {
        let whole = |side: &&Pipeline| as_a_whole(&core, side);
        let answers = others.par_iter().map(whole).collect::<Result<Vec<Proof>, Error>>()?;
        left.into_iter().zip(answers).for_each(|(place, answer)| proofs[place] = Some(answer));
    }
    Ok(proofs.into_iter().map(|proof| proof.expect("each was asked for")).collect())
}

fn is_same_by_stages(core: &Pipeline, side: &Pipeline) -> Result<bool, Error> {
    let Ok(comparison) = Comparison::new(core, side) else { return Ok(false) };
    let registers = core.circuit.registers().map(|(place, _)| [place, place]).collect();
    let stages = Technique::Stages(comparison.confirmed(registers));
    Ok(comparison.ask(&stages, Results::Own, SECONDS)?.answer == Answer::Equal)
}

fn as_a_whole(core: &Pipeline, side: &Pipeline) -> Result<Proof, Error> {
    // What shows it is not known, or is what a memory is given.
    let refuted = || Proof::Open { why: ", which ABC refutes".to_owned(), is_pipeline: false };
    let Ok(comparison) = Comparison::new(core, side) else { return Ok(refuted()) };
    Ok(match comparison.ask(&Technique::Whole, Results::Own, SECONDS)?.answer {
        Answer::Equal => Proof::Same("from the inputs to the outputs, by ABC".to_owned()),
        Answer::Different => refuted(),
        Answer::Unknown => Proof::Open { why: format!(" (ABC within {SECONDS} s)"), is_pipeline: true },
    })
}
