//! Faults in a core: which there are, which inputs detect them, and what becomes of those that nothing detects.
//!
//! - [`mutants()`]: the mutants of a core: of its operations, its memories' words, its pipeline registers and its valid
//!   chain;
//! - [`simulation`]: many faults of a graph on many inputs at a time;
//! - `registers`: mistakes in pipeline registers on many inputs at a time;
//! - [`decide()`]: what is found out of a mutant that vectors do not detect: an input that would, or a proof that there
//!   is none;
//! - `local`: such proofs from a part of the graph; `domain`: all inputs of a graph or of a part of it;
//! - [`Outcome`]: what became of a fault, here and wherever else one is injected.
//!
//! What checks a core stands above and uses this: [`golden`](super::golden) vectors are chosen so that they detect the
//! mutants, [`cosim`](super::cosim) runs them on mutants and on a netlist that has some, [`formal`](super::formal)
//! decides these and tries its own proofs on circuits with injected faults.

mod decide;
mod domain;
mod local;
mod mutants;
mod outcome;
mod registers;
pub mod simulation;

pub use decide::{decide, outcomes};
pub(crate) use mutants::defects;
pub use mutants::{Kind, Mutant, mutants};
pub use outcome::{Outcome, Tally};
pub(crate) use registers::{RegisterSimulation, Shown};

use crate::core::{Design, Direction};

/// Values of a register that are tried in the place of any other.
pub(crate) const MOST_VALUES: usize = 16;

/// Inputs with the names of the ports, for people.
pub(crate) fn inputs_text(design: &Design, codes: &[i64]) -> String {
    let ports = design.numbers(Direction::In);
    ports.iter().zip(codes).map(|((port, _), code)| format!("{port} {code}")).collect::<Vec<_>>().join(", ")
}
