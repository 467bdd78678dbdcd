//! Mutants of the netlist of a core's Verilog: a bit of a cell's port inverted, constant, or inverted by another bit of the cell.

use rayon::prelude::*;

use super::Fate;
use crate::cosim::{Found, Mutants};
use crate::design::Design;
use crate::error::Error;
use crate::golden::Golden;
use crate::hdl::Direction;
use crate::synth::{Mutated, mutated};

/// Random clocks of the control inputs.
const CLOCKS: u32 = 1 << 20;
/// All inputs are run where the ports have so many bits at most.
const MOST_BITS: u32 = 28;

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
    let Mutated { verilog, mutants: list } = mutated(&design.spec.name, verilog, count, seed)?;
    let mutants = Mutants::of(design, &verilog)?;
    let found = mutants.golden(golden, list.len() as u32 + 1)?;
    if found[0] != Found::Not {
        return Err(Error::ToolFailed {
            tool: "the netlist without a mutant".to_owned(),
            what: format!("differs from the golden vectors: {:?}", found[0]),
            output: String::new(),
        });
    }
    let fate = |(place, what): (usize, String)| {
        let fate = match found[place + 1] {
            Found::ByReset => Fate::Killed { by: "the reset".to_owned() },
            Found::ByVector(number) => Fate::Killed { by: format!("vector {number}") },
            Found::Not => decided(design, &mutants, place as u32 + 1, &what)?,
        };
        Ok(NetlistMutant { what, fate })
    };
    list.into_par_iter().enumerate().map(fate).collect()
}

/// What all inputs, one a clock, and then random ones with pauses say of a mutant that the vectors do not kill.
fn decided(design: &Design, mutants: &Mutants, mutant: u32, what: &str) -> Result<Fate, Error> {
    let ports = design.numbers(Direction::In);
    if let Some(clock) = mutants.at_random(mutant, CLOCKS)? {
        return Ok(Fate::Survives { input: format!("random inputs, ce, in_valid and rst, at clock {clock}") });
    }
    let bits: u32 = ports.iter().map(|(_, format)| format.width()).sum();
    let random = format!("{CLOCKS} random clocks");
    if bits > MOST_BITS {
        return Ok(Fate::Undecided { tried: random });
    }
    if let Some(place) = mutants.every(mutant, 0, 1 << bits)? {
        let codes = mutants.inputs_at(place);
        let text: Vec<String> = ports.iter().zip(codes).map(|((port, _), code)| format!("{port} {code}")).collect();
        return Ok(Fate::Survives { input: text.join(", ") });
    }
    // What a register does without its enable or its clock is no function of the inputs.
    let is_control = ["port EN ", "port CLK ", "port SRST ", "port ARST "].iter().any(|port| what.contains(port));
    Ok(if is_control {
        Fate::Undecided { tried: format!("all 2^{bits} inputs, one a clock, and {random}") }
    } else {
        Fate::Equivalent { proof: format!("none of all 2^{bits} inputs, one a clock, shows it") }
    })
}
