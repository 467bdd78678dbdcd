//! Mutants of what a core is made from, simulated in this process.

use rayon::prelude::*;

use super::Fate;
use super::equivalent::{self, Decision};
use crate::core::Design;
use crate::datapath::fault::{Change, Defect, Fault};
use crate::datapath::graph::Op;
use crate::datapath::mutants::{self, Kind, Mutant};
use crate::fixed::Dice;
use crate::verify::cosim::Vectors;
use crate::verify::golden::Golden;

/// Words of each field of a memory that have a bit inverted.
const WORDS: usize = 16;

/// Every mutant of a design; `seed` says which words of a memory have an inverted bit.
#[must_use]
pub fn mutants(design: &Design, seed: u32) -> Vec<Mutant> {
    let graph = design.graph();
    let mut mutants = mutants::mutants(graph, &design.schedule);
    let mut dice = Dice::new((3 << 40) + u64::from(seed));
    for (id, node) in graph.nodes.iter().enumerate() {
        let Op::Field { memory, .. } = node.op else { continue };
        for _ in 0..WORDS {
            let address = dice.below(design.tables()[memory].depth() as u64) as usize;
            let bit = dice.below(node.format.width().into()) as u32;
            let what = format!("{}: bit {bit} of the word at {address} inverted", node.name);
            let defect = Defect::Value(Fault { node: id, change: Change::Word { address, bit } });
            mutants.push(Mutant { kind: Kind::Word, what, defect });
        }
    }
    mutants
}

/// What becomes of mutants of a design under golden vectors, in their order; `progress` is told of each that is run.
#[must_use]
pub fn fates(design: &Design, golden: &Golden, mutants: &[Mutant], progress: &(dyn Fn() + Sync)) -> Vec<Fate> {
    let vectors = Vectors::of(design, golden);
    let kill = |mutant: &Mutant| {
        let killed = vectors.kill(&mutant.defect);
        progress();
        killed
    };
    let killed: Vec<Option<String>> = mutants.par_iter().map(kill).collect();
    let left: Vec<&Defect> =
        mutants.iter().zip(&killed).filter(|(_, killed)| killed.is_none()).map(|(mutant, _)| &mutant.defect).collect();
    let mut decisions = equivalent::decide(design, &left).into_iter();
    let fate = |killed: Option<String>| match killed {
        Some(by) => Fate::Killed { by },
        None => match decisions.next().expect("a decision for each mutant that is left") {
            Decision::Same { proof } => Fate::Equivalent { proof },
            Decision::Differs { input } => Fate::Survives { input },
            Decision::Open { tried } => Fate::Undecided { tried },
        },
    };
    killed.into_iter().map(fate).collect()
}
