//! Mutants of a core: is every one that computes something else killed by the core's golden vectors?
//!
//! - [`source`]: mutants of the operations, the memories' words, the pipeline registers and the valid chain, simulated in this process;
//! - [`netlist`]: mutants of the Verilog's netlist by Yosys, simulated by Verilator;
//! - [`equivalent`]: what is found out of a mutant that the vectors do not kill: an input that would, or a proof that there is none;
//! - `local`: such proofs from a part of the graph.

pub mod equivalent;
mod local;
pub mod netlist;
pub mod source;

use serde::Serialize;

/// What became of a mutant.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "fate", rename_all = "kebab-case")]
pub enum Fate {
    /// The golden vectors tell it from the core; the first thing that they do not expect.
    Killed {
        /// What the mutant did.
        by: String,
    },
    /// It computes what the core computes.
    Equivalent {
        /// How that is proved.
        proof: String,
    },
    /// It computes something else, and no golden vector shows it.
    Survives {
        /// What would show it.
        input: String,
    },
    /// No golden vector shows it, and it is neither proved nor refuted that it computes what the core computes.
    Undecided {
        /// What was tried.
        tried: String,
    },
}

/// How many mutants came to which end.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Tally {
    /// All.
    pub mutants: usize,
    /// Killed by the golden vectors.
    pub killed: usize,
    /// Proved equivalent.
    pub equivalent: usize,
    /// Not killed, though not equivalent.
    pub survivors: usize,
    /// Not killed, and not known to be one or the other.
    pub undecided: usize,
}

impl Tally {
    /// Counts.
    #[must_use]
    pub fn of<'a>(fates: impl IntoIterator<Item = &'a Fate>) -> Self {
        let mut tally = Self::default();
        for fate in fates {
            tally.mutants += 1;
            *match fate {
                Fate::Killed { .. } => &mut tally.killed,
                Fate::Equivalent { .. } => &mut tally.equivalent,
                Fate::Survives { .. } => &mut tally.survivors,
                Fate::Undecided { .. } => &mut tally.undecided,
            } += 1;
        }
        tally
    }
}
