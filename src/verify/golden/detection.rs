//! Vectors that detect mutants.
//!
//! What a mutant of an operation computes is shown by an input; a mistake in a pipeline register by two inputs, one
//! behind the other, of which one has in this register what changes the other's result, and with clocks without `ce`
//! between them.

use std::cell::Cell;
use std::collections::BTreeMap;

use rayon::prelude::*;

use super::{Vector, greedy};
use crate::core::golden::clocks;
use crate::core::{Design, Direction};
use crate::datapath::fault::{Change, Defect, Fault, Timing};
use crate::datapath::graph::NodeId;
use crate::datapath::simulate::{Inputs, Simulation};
use crate::verify::faults::simulation::{Block, FaultSimulation, Next, blocks, held_in_register};
use crate::verify::faults::{MOST_VALUES, RegisterSimulation, Shown, defects};

/// A task's candidates, block by block.
pub(super) type Candidates<'a> = Box<Next<'a>>;

/// Tasks that are spent on the mutants of a node that nothing was seen to show.
const TASKS_OF_MUTE: u64 = 2;

/// For each node whether no output ever shows it: neither the ends of its format nor 0 in its place, nor its inverted
/// sign, change a result, for any of the vectors `known` and the candidates of the first task. Such are the nodes of a
/// channel that is always full or black, or of a highlight that is multiplied by 0: mutants of them would be sought
/// among all candidates, in vain.
fn mute(design: &Design, known: &[&Vector], mut candidates: Candidates) -> Vec<bool> {
    let graph = design.graph();
    let of_node = |node: NodeId| {
        let format = graph.nodes[node].format;
        let held = [format.min_code(), format.max_code(), 0].map(Change::constant);
        held.into_iter().chain([Change::Flipped { bit: format.width() - 1 }]).map(move |change| Fault { node, change })
    };
    let faults: Vec<Fault> =
        (0..graph.nodes.len()).filter(|&node| graph.nodes[node].format.width() > 0).flat_map(of_node).collect();
    let mut vectors = blocks(known.iter().map(|vector| &vector.inputs));
    let shown = FaultSimulation::new(graph, design.tables())
        .first(&faults.iter().collect::<Vec<_>>(), &mut |block| vectors(block) || candidates(block));
    let mut mute = vec![true; graph.nodes.len()];
    for (fault, shown) in faults.iter().zip(&shown) {
        mute[fault.node] &= shown.is_none();
    }
    mute
}

/// The fewest inputs that a greedy search finds to detect each mutant of the core's operations that the vectors `known`
/// do not detect, as far as any candidate of so many tasks does.
pub(super) fn detecting<'a>(
    design: &'a Design,
    known: &[&Vector],
    tasks: u64,
    candidates: &(dyn Fn(u64) -> Candidates<'a> + Sync),
) -> Vec<Vec<i64>> {
    let simulation = FaultSimulation::new(design.graph(), design.tables());
    let faults: Vec<Fault> = defects(design).filter_map(|defect| defect.fault().cloned()).collect();
    let all: Vec<&Fault> = faults.iter().collect();
    let each = all.len().div_ceil(rayon::current_num_threads()).max(1);
    let by_known = |some: &[&Fault]| simulation.first(some, &mut *blocks(known.iter().map(|vector| &vector.inputs)));
    let detected: Vec<_> = all.par_chunks(each).flat_map_iter(by_known).collect();
    let open: Vec<&Fault> =
        all.into_iter().zip(detected).filter(|(_, by)| by.is_none()).map(|(fault, _)| fault).collect();

    let mute = if open.is_empty() { Vec::new() } else { mute(design, known, candidates(0)) };
    let seen: Vec<&Fault> = open.iter().copied().filter(|fault| !mute[fault.node]).collect();
    let of_task =
        |task: u64| simulation.first(if task < TASKS_OF_MUTE { &open } else { &seen }, &mut *candidates(task));
    let found: Vec<Vec<Option<Vec<i64>>>> = (0..tasks).into_par_iter().map(of_task).collect();
    let mut pool: Vec<Vec<i64>> = found.into_iter().flatten().flatten().collect();
    pool.sort_unstable();
    pool.dedup();
    let mut detects = vec![vec![false; pool.len()]; open.len()];
    simulation.run(&open, &mut *blocks(pool.iter()), &mut |place, lanes, block| {
        for lane in (0..block.count).filter(|lane| lanes >> lane & 1 == 1) {
            detects[place][block.before as usize + lane] = true;
        }
        true
    });
    greedy(pool.len(), &detects).into_iter().map(|place| pool[place].clone()).collect()
}

/// Vectors, with pauses, that detect each mutant of the core's registers that the vectors `known` do not detect, as far
/// as one is found.
pub(super) fn pausing<'a>(
    design: &'a Design,
    known: &[&Vector],
    candidates: &(dyn Fn(u64) -> Candidates<'a> + Sync),
) -> Vec<Vector> {
    let registers: Vec<Defect> =
        defects(design).filter(|defect| matches!(defect, Defect::Timing(Timing::Register { .. }))).collect();
    let simulation = RegisterSimulation::new(design);
    let mut open = Clocks::of(design, known).undetected(&simulation, registers.iter().collect());
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
        open = clocks.undetected(&simulation, open);
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
    let (graph, faults) = held_in_register(design, node, register, values.keys().copied());
    let faults: Vec<&Fault> = faults.iter().collect();
    let mut shown = vec![None; faults.len()];
    // The first of the values that shows counts: if the first of all does, no other is looked for any further.
    let is_decided = Cell::new(false);
    let mut block = blocks(inputs.iter());
    FaultSimulation::new(&graph, design.tables()).run(
        &faults,
        &mut |next| !is_decided.get() && block(next),
        &mut |place, lanes, block| {
            shown[place] = Some(block.inputs(lanes.trailing_zeros() as usize));
            is_decided.set(is_decided.get() || place == 0);
            false
        },
    );
    shown.into_iter().zip(values.values()).find_map(|(shown, &other)| Some([shown?, inputs[other].clone()]))
}

/// One input between two of the other, then with the clock disabled once while it is in each stage, and at last, since
/// the inputs are inverted while the clock is disabled, in front of the inverted other.
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
struct Clocks<'a> {
    design: &'a Design,
    inputs: Vec<Inputs>,
}

impl<'a> Clocks<'a> {
    fn of(design: &'a Design, vectors: &[&Vector]) -> Self {
        Self { design, inputs: clocks(design, vectors) }
    }

    /// Those of some defects of registers with which the core does nothing else.
    fn undetected<'d>(&self, simulation: &RegisterSimulation, defects: Vec<&'d Defect>) -> Vec<&'d Defect> {
        let shown = simulation.shown(&self.inputs, &defects);
        let is_open = |(defect, shown): &(&Defect, Shown)| match shown {
            Shown::By(_) => false,
            Shown::Never => true,
            Shown::NotCovered => !self.detect(defect),
        };
        defects.into_iter().zip(shown).filter(is_open).map(|(defect, _)| defect).collect()
    }

    /// Whether a core with a defect does something else, clock by clock.
    fn detect(&self, defect: &Defect) -> bool {
        let design = self.design;
        let core = || Simulation::new(design.graph(), &design.schedule, design.tables());
        let (mut right, mut wrong) = (core(), core().with(defect));
        let differs = |inputs: &Inputs| {
            let (right, got) = (right.clock(inputs), wrong.clock(inputs));
            got.out_valid != right.out_valid || got.out_valid && got.codes != right.codes
        };
        self.inputs.iter().any(differs)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::datapath::graph::Op;
    use crate::fixed::Rng;
    use crate::spec::SpecFields;

    /// Cores without a register in front of their output, with one and with several.
    const SPECS: [&str; 4] = [
        "method = \"quadratic\"\nshininess = \"1..=15\"\ninput_fraction = 8\noutput_fraction = 8\n",
        "method = \"quadratic\"\nshininess = \"1..=15\"\npipeline = 1\n",
        "method = \"schlick\"\nshininess = \"1..=15\"\ninput_fraction = 8\noutput_fraction = 8\npipeline = 9\n",
        "block = \"image\"\nimage_form = \"bivariate\"\nimage_size = 8\nreflectance = { model = \"lambert\" }\n",
    ];

    /// Both simulations find the same mistakes in registers, for vectors with pauses of all kinds.
    #[test]
    fn what_shows_is_what_a_pipeline_shows() {
        let (mut shown, mut hidden, mut covered, mut ports) = (0, 0, 0, 0);
        for text in SPECS {
            let fields = SpecFields::parse(text, "core.toml").expect("keys");
            let design = fields.resolve().and_then(Design::new).expect("a core");
            let simulation = RegisterSimulation::new(&design);
            let registers: Vec<Defect> =
                defects(&design).filter(|defect| matches!(defect, Defect::Timing(Timing::Register { .. }))).collect();
            let mut rng = Rng::new(7);
            for count in [1, 3, 70] {
                let vectors: Vec<Vector> = (0..count)
                    .map(|_| {
                        let inputs = design.varied(&mut rng);
                        let [idle, stall] = [rng.below(3), rng.below(3)].map(|clocks| clocks as u32);
                        Vector { outputs: design.evaluate(&inputs), inputs, idle, stall }
                    })
                    .collect();
                let clocks = Clocks::of(&design, &vectors.iter().collect::<Vec<_>>());
                let found = simulation.shown(&clocks.inputs, &registers.iter().collect::<Vec<_>>());
                for (defect, found) in registers.iter().zip(found) {
                    let shows = clocks.detect(defect);
                    let is_right = match found {
                        Shown::By(result) => shows && result < vectors.len(),
                        Shown::Never => !shows,
                        Shown::NotCovered => true,
                    };
                    assert!(is_right, "{text}: {defect:?}: {found:?}, and shows: {shows}");
                    covered += usize::from(found != Shown::NotCovered);
                    *if shows { &mut shown } else { &mut hidden } += 1;
                }
            }
            let is_port =
                |defect: &&Defect| node_of(defect).is_some_and(|node| design.graph().nodes[node].op == Op::Input);
            ports += registers.iter().filter(is_port).count();
        }
        assert!(shown > 500 && hidden > 500 && covered > shown && ports > 20, "{shown} {hidden} {covered} {ports}");
    }
}
