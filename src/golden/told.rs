//! Vectors that tell a core from its mutants.

use rayon::prelude::*;

use super::{Vector, greedy};
use crate::datapath::fault::{Block, Defect, Fault, Hunt, Probe};
use crate::datapath::mutants::mutants;
use crate::design::Design;

/// What fills a block with the next candidates of a task; false at the end.
pub(super) type Candidates<'a> = Box<dyn FnMut(&mut Block) -> bool + 'a>;

/// Notes an input that shows each fault, the first there is.
struct First<'a> {
    candidates: Candidates<'a>,
    shown: Vec<Option<Vec<i64>>>,
}

impl Hunt for First<'_> {
    fn next(&mut self, block: &mut Block) -> bool {
        (self.candidates)(block)
    }

    fn shown(&mut self, place: usize, lanes: u64, block: &Block) -> bool {
        self.shown[place] = Some(block.inputs(lanes.trailing_zeros() as usize));
        false
    }
}

/// Notes which inputs show which faults.
struct All<'a> {
    inputs: std::slice::Chunks<'a, Vec<i64>>,
    done: usize,
    tells: Vec<Vec<bool>>,
}

impl Hunt for All<'_> {
    fn next(&mut self, block: &mut Block) -> bool {
        self.done += block.count;
        block.count = 0;
        let Some(inputs) = self.inputs.next() else { return false };
        inputs.iter().for_each(|inputs| block.push(inputs));
        true
    }

    fn shown(&mut self, place: usize, lanes: u64, block: &Block) -> bool {
        for lane in (0..block.count).filter(|lane| lanes >> lane & 1 == 1) {
            self.tells[place][self.done + lane] = true;
        }
        true
    }
}

/// The fewest inputs that a greedy search finds to tell the core from each mutant of its operations that the vectors `known` do not show,
/// as far as any candidate of so many tasks shows it.
pub(super) fn telling<'a>(
    design: &'a Design,
    known: &[&Vector],
    tasks: u64,
    candidates: &(dyn Fn(u64) -> Candidates<'a> + Sync),
) -> Vec<Vec<i64>> {
    let probe = Probe::new(design.graph(), design.tables());
    let value = |defect: Defect| if let Defect::Value(fault) = defect { Some(fault) } else { None };
    let list = mutants(design.graph(), &design.schedule);
    let faults: Vec<Fault> = list.into_iter().filter_map(|mutant| value(mutant.defect)).collect();
    let first = |faults: &[&Fault], candidates: Candidates| {
        let mut hunt = First { candidates, shown: vec![None; faults.len()] };
        probe.run(faults, &mut hunt);
        hunt.shown
    };

    let mut blocks = known.chunks(Block::LANES);
    let vectors = Box::new(move |block: &mut Block| {
        block.count = 0;
        blocks.next().into_iter().flatten().for_each(|vector| block.push(&vector.inputs));
        block.count > 0
    });
    let all: Vec<&Fault> = faults.iter().collect();
    let told = first(&all, vectors);
    let open: Vec<&Fault> =
        all.into_iter().zip(told).filter(|(_, told)| told.is_none()).map(|(fault, _)| fault).collect();

    let found: Vec<Vec<Option<Vec<i64>>>> =
        (0..tasks).into_par_iter().map(|task| first(&open, candidates(task))).collect();
    let mut pool: Vec<Vec<i64>> = found.into_iter().flatten().flatten().collect();
    pool.sort_unstable();
    pool.dedup();
    let mut hunt = All { inputs: pool.chunks(Block::LANES), done: 0, tells: vec![vec![false; pool.len()]; open.len()] };
    probe.run(&open, &mut hunt);
    let tells = hunt.tells;
    greedy(pool.len(), &tells).into_iter().map(|place| pool[place].clone()).collect()
}
