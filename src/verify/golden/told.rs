//! Vectors that tell a core from its mutants.
//!
//! What a mutant of an operation computes is told by an input; a mistake in a pipeline register by two inputs, one behind the other, of which
//! one has in this register what changes the other's result, and with clocks without `ce` between them.

use std::collections::BTreeMap;

use rayon::prelude::*;

use super::{Vector, greedy};
use crate::core::Design;
use crate::core::Direction;
use crate::datapath::fault::{Block, Change, Defect, Fault, Hunt, Probe, Timing, with_copy};
use crate::datapath::graph::{NodeId, Op};
use crate::datapath::mutants::mutants;
use crate::datapath::simulate::{Inputs, Outputs, Simulation};

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

/// Tasks that are spent on the mutants of a node that nothing was seen to show.
const TASKS_OF_MUTE: u64 = 2;

/// For each node whether no output ever shows it: neither the ends of its format nor 0 in its place, nor its inverted sign, change a result, for
/// any of the vectors `known` and the candidates of the first task. Such are the nodes of a channel that is always full or black, or of a
/// highlight that is multiplied by 0: mutants of them would be sought among all candidates, in vain.
fn mute(design: &Design, known: &[&Vector], mut candidates: Candidates) -> Vec<bool> {
    let graph = design.graph();
    let of_node = |node: NodeId| {
        let format = graph.nodes[node].format;
        let held = |code: i128| Change::Instead { op: Op::Constant(code), args: Vec::new() };
        let changes =
            [held(format.min_code()), held(format.max_code()), held(0), Change::Flipped { bit: format.width() - 1 }];
        changes.into_iter().map(move |change| Fault { node, change })
    };
    let faults: Vec<Fault> =
        (0..graph.nodes.len()).filter(|&node| graph.nodes[node].format.width() > 0).flat_map(of_node).collect();
    let mut vectors = known.chunks(Block::LANES);
    let both = Box::new(move |block: &mut Block| {
        block.count = 0;
        match vectors.next() {
            Some(some) => some.iter().for_each(|vector| block.push(&vector.inputs)),
            None => return candidates(block),
        }
        true
    });
    let mut hunt = First { candidates: both, shown: vec![None; faults.len()] };
    Probe::new(graph, design.tables()).run(&faults.iter().collect::<Vec<_>>(), &mut hunt);
    let mut mute = vec![true; graph.nodes.len()];
    for (fault, shown) in faults.iter().zip(&hunt.shown) {
        mute[fault.node] &= shown.is_none();
    }
    mute
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

    let mute = if open.is_empty() { Vec::new() } else { mute(design, known, candidates(0)) };
    let seen: Vec<&Fault> = open.iter().copied().filter(|fault| !mute[fault.node]).collect();
    let of_task = |task: u64| first(if task < TASKS_OF_MUTE { &open } else { &seen }, candidates(task));
    let found: Vec<Vec<Option<Vec<i64>>>> = (0..tasks).into_par_iter().map(of_task).collect();
    let mut pool: Vec<Vec<i64>> = found.into_iter().flatten().flatten().collect();
    pool.sort_unstable();
    pool.dedup();
    let mut hunt = All { inputs: pool.chunks(Block::LANES), done: 0, tells: vec![vec![false; pool.len()]; open.len()] };
    probe.run(&open, &mut hunt);
    let tells = hunt.tells;
    greedy(pool.len(), &tells).into_iter().map(|place| pool[place].clone()).collect()
}

/// Values of a register that are tried in the place of any other.
const MOST_VALUES: usize = 16;

/// Vectors, with pauses, that tell the core from each mutant of its registers that the vectors `known` do not show, as far as one is found.
pub(super) fn pausing<'a>(
    design: &'a Design,
    known: &[&Vector],
    candidates: &(dyn Fn(u64) -> Candidates<'a> + Sync),
) -> Vec<Vector> {
    let registers: Vec<Defect> = mutants(design.graph(), &design.schedule)
        .into_iter()
        .map(|mutant| mutant.defect)
        .filter(|defect| matches!(defect, Defect::Timing(Timing::Register { .. })))
        .collect();
    let clocks = Clocks::of(design, known);
    let mut open: Vec<&Defect> = registers.par_iter().filter(|defect| !clocks.tell(design, defect)).collect();
    let mut chosen = Vec::new();
    if open.is_empty() {
        return chosen;
    }
    let mute = mute(design, known, candidates(0));
    open.retain(|defect| node_of(defect).is_some_and(|node| !mute[node]));
    let mut inputs: Vec<Vec<i64>> = known.iter().map(|vector| vector.inputs.clone()).collect();
    let (mut more, mut block) = (candidates(0), Block::new(design.graph().inputs.len()));
    while more(&mut block) {
        inputs.extend((0..block.count).map(|lane| block.inputs(lane)));
    }
    let nodes: Vec<NodeId> = open.iter().filter_map(|defect| node_of(defect)).collect();
    let values = values(design, &inputs, &nodes);
    while let Some(defect) = open.first() {
        let Defect::Timing(Timing::Register { node, register, .. }) = **defect else { return chosen };
        let pattern = pair(design, &inputs, &values[&node], node, register).map(|pair| pattern(design, &pair));
        let Some(pattern) = pattern else {
            open.remove(0);
            continue;
        };
        let clocks = Clocks::of(design, &pattern.iter().collect::<Vec<_>>());
        let before = open.len();
        open.retain(|defect| !clocks.tell(design, defect));
        if open.len() < before {
            chosen.extend(pattern);
        } else {
            open.remove(0);
        }
    }
    chosen
}

fn node_of(defect: &Defect) -> Option<NodeId> {
    if let Defect::Timing(Timing::Register { node, .. }) = defect { Some(*node) } else { None }
}

/// Some values of nodes, each with the place of the first of the inputs that gives it.
fn values(design: &Design, inputs: &[Vec<i64>], nodes: &[NodeId]) -> BTreeMap<NodeId, BTreeMap<i128, usize>> {
    const CHUNK: usize = 1024;
    let of_chunk = |(chunk, inputs): (usize, &[Vec<i64>])| {
        let mut found: BTreeMap<NodeId, BTreeMap<i128, usize>> = BTreeMap::new();
        for (place, inputs) in inputs.iter().enumerate() {
            let codes: Vec<i128> = inputs.iter().copied().map(i128::from).collect();
            let values = design.graph().values(design.tables(), &codes);
            for &node in nodes {
                let known = found.entry(node).or_default();
                if known.len() < MOST_VALUES {
                    known.entry(values[node]).or_insert(CHUNK * chunk + place);
                }
            }
        }
        found
    };
    let chunks: Vec<_> = inputs.par_chunks(CHUNK).enumerate().map(of_chunk).collect();
    let mut all: BTreeMap<NodeId, BTreeMap<i128, usize>> = BTreeMap::new();
    for (node, values) in chunks.into_iter().flatten() {
        let known = all.entry(node).or_default();
        for (value, place) in values {
            if known.len() < MOST_VALUES {
                known.entry(value).or_insert(place);
            }
        }
    }
    all
}

/// An input and another, of which a register may hold the value in the place of the first's, so that it shows.
fn pair(
    design: &Design,
    inputs: &[Vec<i64>],
    values: &BTreeMap<i128, usize>,
    node: NodeId,
    register: usize,
) -> Option<[Vec<i64>; 2]> {
    let (graph, copy) = with_copy(design.graph(), &design.schedule, node, register);
    let held =
        |&code: &i128| Fault { node: copy, change: Change::Instead { op: Op::Constant(code), args: Vec::new() } };
    let faults: Vec<Fault> = values.keys().map(held).collect();
    let mut blocks = inputs.chunks(Block::LANES);
    let candidates = Box::new(move |block: &mut Block| {
        block.count = 0;
        blocks.next().into_iter().flatten().for_each(|inputs| block.push(inputs));
        block.count > 0
    });
    let mut hunt = First { candidates, shown: vec![None; faults.len()] };
    Probe::new(&graph, design.tables()).run(&faults.iter().collect::<Vec<_>>(), &mut hunt);
    hunt.shown.into_iter().zip(values.values()).find_map(|(shown, &other)| Some([shown?, inputs[other].clone()]))
}

/// One input between two of the other, then with the clock disabled once while it is in each stage, and at last, since the inputs are
/// inverted while the clock is disabled, in front of the inverted other.
fn pattern(design: &Design, [one, other]: &[Vec<i64>; 2]) -> Vec<Vector> {
    let ports = design.numbers(Direction::In);
    let inverted: Vec<i64> =
        other.iter().zip(&ports).map(|(&code, (_, format))| format.wrap(!i128::from(code)) as i64).collect();
    let vector =
        |inputs: &Vec<i64>, stall| Vector { inputs: inputs.clone(), outputs: design.evaluate(inputs), idle: 0, stall };
    let mut pattern = vec![vector(other, 0), vector(one, 0)];
    pattern.extend((0..design.schedule.latency).map(|_| vector(other, 1)));
    pattern.extend([vector(one, 0), vector(&inverted, 1), vector(other, 0)]);
    pattern
}

/// The levels at the ports, clock by clock, while vectors run.
struct Clocks {
    inputs: Vec<Inputs>,
    right: Vec<Outputs>,
}

impl Clocks {
    fn of(design: &Design, vectors: &[&Vector]) -> Self {
        let ports = design.numbers(Direction::In);
        let mut inputs = Vec::new();
        for vector in vectors {
            let codes: Vec<i128> = vector.inputs.iter().copied().map(i128::from).collect();
            let garbage = codes.iter().zip(&ports).map(|(&code, (_, format))| format.wrap(!code)).collect();
            let garbage = Inputs { rst: false, ce: true, in_valid: false, codes: garbage };
            inputs.extend((0..vector.idle).map(|_| garbage.clone()));
            inputs.extend((0..vector.stall).map(|_| Inputs { ce: false, in_valid: true, ..garbage.clone() }));
            inputs.push(Inputs { in_valid: true, codes, ..garbage });
        }
        inputs.extend((0..design.schedule.latency).map(|_| Inputs { ce: true, ..Inputs::default() }));
        let mut core = Simulation::new(design.graph(), &design.schedule, design.tables());
        let right = inputs.iter().map(|inputs| core.clock(inputs)).collect();
        Self { inputs, right }
    }

    /// Whether a core with a defect does something else.
    fn tell(&self, design: &Design, defect: &Defect) -> bool {
        let mut core = Simulation::new(design.graph(), &design.schedule, design.tables()).with(defect);
        let same = |(inputs, right): (&Inputs, &Outputs)| {
            let got = core.clock(inputs);
            got.out_valid == right.out_valid && (!got.out_valid || got.codes == right.codes)
        };
        !self.inputs.iter().zip(&self.right).all(same)
    }
}
