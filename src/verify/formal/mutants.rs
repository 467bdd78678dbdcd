//! Which mutants of a core's netlist are the same circuit as the core, and inputs that tell the others from it.
//!
//! A netlist with an input `mutant` is the core where that is 0. For any other number it must be a pipeline as well, as in
//! [`super::equivalence`], with the same registers; then the two are compared stage by stage, cut at all registers that are the same in random
//! runs, then by running every value of the inputs through all circuits that are left at once, and where there are too many of these as
//! functions from the inputs to the outputs.

use rayon::prelude::*;

use super::abc::Answer;
use super::circuit::{Circuit, Unfit};
use super::equivalence::{Comparison, Method, Pipeline, first_shown};
use crate::core::Design;
use crate::core::Direction;
use crate::platform::error::Error;
use crate::synth::yosys::Yosys;

/// The most that the solver may take at once, in seconds.
const SECONDS: u32 = 5;

/// What is found out of a mutant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Told {
    /// It is the same circuit: how that is proved.
    Same(String),
    /// It is another: the codes of the input ports, in order, for which it gives something else.
    Other(Vec<i64>),
    /// It is a pipeline as the core is; whether it is the same was not found out: what was tried.
    Open(String),
    /// It is a pipeline, and another one; what shows it is not known, or is what a memory is given.
    Refuted,
    /// It is no pipeline, or not known to be one, so that it may depend on what came before: why.
    Unfit(Unfit),
}

/// What is found out of mutants of a core's netlist, by their numbers. The netlist, with the input `mutant`, holds no other mutants.
///
/// # Errors
/// A tool that is not installed or does not do its work.
pub(crate) fn told(design: &Design, netlist: &[u8], mutants: &[u32]) -> Result<Vec<Told>, Error> {
    let all = |why: Unfit| Ok(vec![Told::Unfit(why); mutants.len()]);
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
        Ok(side) => Ok(is_same_by_stages(&core, side)?.then(|| Told::Same("stage by stage".to_owned()))),
        Err(why) => Ok(Some(Told::Unfit(why.clone()))),
    };
    let mut told = sides.par_iter().map(by_stages).collect::<Result<Vec<Option<Told>>, Error>>()?;
    let left: Vec<usize> = (0..told.len()).filter(|&place| told[place].is_none()).collect();
    let others: Vec<&Pipeline> = left.iter().filter_map(|&place| sides[place].as_ref().ok()).collect();
    let ports = design.numbers(Direction::In);
    if let Some(shown) = first_shown(&core, &others) {
        let bits: u32 = ports.iter().map(|(_, format)| format.width()).sum();
        for (place, codes) in left.into_iter().zip(shown) {
            told[place] = Some(match codes {
                None => Told::Same(format!("none of all 2^{bits} inputs shows it")),
                Some(codes) => {
                    let code = |(name, format): &(&str, crate::fixed::Format)| {
                        format.wrap(codes.get(*name).copied().unwrap_or_default().into()) as i64
                    };
                    Told::Other(ports.iter().map(code).collect())
                }
            });
        }
    } else {
        let whole = |side: &&Pipeline| as_a_whole(&core, side);
        let answers = others.par_iter().map(whole).collect::<Result<Vec<Told>, Error>>()?;
        left.into_iter().zip(answers).for_each(|(place, answer)| told[place] = Some(answer));
    }
    Ok(told.into_iter().map(|told| told.expect("each was asked for")).collect())
}

fn is_same_by_stages(core: &Pipeline, side: &Pipeline) -> Result<bool, Error> {
    let Ok(comparison) = Comparison::new(core, side) else { return Ok(false) };
    let registers = core.circuit.registers().map(|(place, _)| [place, place]).collect();
    let stages = Method::Stages(comparison.confirmed(registers));
    Ok(comparison.ask(&stages, false, SECONDS)?.answer == Answer::Equal)
}

fn as_a_whole(core: &Pipeline, side: &Pipeline) -> Result<Told, Error> {
    let Ok(comparison) = Comparison::new(core, side) else { return Ok(Told::Refuted) };
    Ok(match comparison.ask(&Method::Whole, false, SECONDS)?.answer {
        Answer::Equal => Told::Same("from the inputs to the outputs, by ABC".to_owned()),
        Answer::Different => Told::Refuted,
        Answer::Unknown => Told::Open(format!("ABC within {SECONDS} s")),
    })
}
