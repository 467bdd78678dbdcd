//! Mistakes in pipeline registers on many inputs at a time.
//!
//! Such a mistake puts the value of one clock in the place of another's and does nothing else: behind a register that
//! is left out everything sees the next enabled clock's value, behind a doubled one that of the clock before, and
//! behind one that runs free the next one's where the clock was disabled while the value was in it. So no pipeline has
//! to be simulated: what reads the node from behind the register on is computed again with the other value.

use multiversion::multiversion;
use rayon::prelude::*;

use super::simulation::{FaultSimulation, Pending, operate, unlike};
use crate::core::Design;
use crate::datapath::evaluate::{LANES, Lane};
use crate::datapath::fault::{Defect, Registered, Timing};
use crate::datapath::graph::{NodeId, Op};
use crate::datapath::simulate::Inputs;

/// What is taken in at an enabled clock.
#[derive(Clone, Debug)]
struct Taken {
    codes: Vec<i64>,
    valid: bool,
    /// The codes at the ports while the clock was disabled before, if it was.
    paused: Option<Vec<i64>>,
}

/// What shows a defect.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shown {
    /// This result is the first that is another.
    By(usize),
    /// No result is another.
    Never,
    /// It is none that [`RegisterSimulation`] covers.
    NotCovered,
}

/// A register with a mistake.
#[derive(Clone, Copy, Debug)]
struct Mistake {
    node: NodeId,
    register: usize,
    what: Registered,
}

/// Finds out which mistakes in registers a sequence of levels at the ports shows.
#[derive(Clone, Debug)]
pub(crate) struct RegisterSimulation<'a> {
    design: &'a Design,
    /// The simulation of faults in the same graph.
    pub(super) simulation: FaultSimulation<'a>,
}

impl<'a> RegisterSimulation<'a> {
    /// Prepares a design.
    #[must_use]
    pub(crate) fn new(design: &'a Design) -> Self {
        Self { design, simulation: FaultSimulation::new(design.graph(), design.tables()) }
    }

    /// The mistake of a defect that this simulation covers: one in a register, but for the only register of an output
    /// being left out, which then changes with the ports.
    fn mistake(&self, defect: &Defect) -> Option<Mistake> {
        let &Defect::Timing(Timing::Register { node, register, what }) = defect else { return None };
        let schedule = &self.design.schedule;
        let is_seen = self.design.graph().is_output(node) && schedule.latency - schedule.stage[node] == 1;
        (what != Registered::Missing || !is_seen).then_some(Mistake { node, register, what })
    }

    /// Of each defect which result, counted from 0, shows it first while levels are at the ports clock by clock, from
    /// when the core comes up and without a reset.
    #[must_use]
    pub(crate) fn shown(&self, inputs: &[Inputs], defects: &[&Defect]) -> Vec<Shown> {
        let mistakes: Vec<Option<Mistake>> = defects.iter().map(|defect| self.mistake(defect)).collect();
        let covered: Vec<Mistake> = mistakes.iter().flatten().copied().collect();
        let taken = self.taken(inputs);
        let each = covered.len().div_ceil(4 * rayon::current_num_threads()).max(1);
        let of_some = |some: &[Mistake]| {
            if self.simulation.is_narrow() { run_narrow(self, &taken, some) } else { run::<i128>(self, &taken, some) }
        };
        let mut shown = covered.par_chunks(each).flat_map_iter(of_some).collect::<Vec<Option<usize>>>().into_iter();
        let result = |clock: usize| taken[..clock].iter().filter(|taken| taken.valid).count();
        let of_mistake = |mistake: Option<Mistake>| match mistake.map(|_| shown.next().flatten()) {
            None => Shown::NotCovered,
            Some(None) => Shown::Never,
            Some(Some(clock)) => Shown::By(result(clock)),
        };
        mistakes.into_iter().map(of_mistake).collect()
    }

    fn taken(&self, inputs: &[Inputs]) -> Vec<Taken> {
        let ports = self.design.graph().inputs.len();
        let code = |inputs: &Inputs, port: usize| inputs.codes.get(port).copied().unwrap_or_default() as i64;
        let (mut taken, mut paused) = (Vec::new(), None);
        for inputs in inputs {
            let codes = (0..ports).map(|port| code(inputs, port)).collect();
            if inputs.ce {
                taken.push(Taken { codes, valid: inputs.in_valid, paused: paused.take() });
            } else {
                paused = Some(codes);
            }
        }
        taken
    }
}

#[multiversion(targets("x86_64+avx2", "aarch64+neon"))]
fn run_narrow(registers: &RegisterSimulation, taken: &[Taken], mistakes: &[Mistake]) -> Vec<Option<usize>> {
    run::<i64>(registers, taken, mistakes)
}

/// The clocks of a block that count: beside the first and the last stand their neighbours.
const COUNTED: usize = LANES - 2;

#[inline(always)]
fn run<L: Lane>(registers: &RegisterSimulation, taken: &[Taken], mistakes: &[Mistake]) -> Vec<Option<usize>> {
    let mut shown = vec![None; mistakes.len()];
    let mut open: Vec<usize> = (0..mistakes.len()).collect();
    let mut block = Block::<L>::new(registers, taken);
    for first in (0..taken.len()).step_by(COUNTED) {
        if open.is_empty() {
            break;
        }
        block.take(first);
        open.retain(|&place| {
            let lanes = block.shows(mistakes[place]);
            // The first clock that counts is in the second lane.
            shown[place] = (lanes != 0).then(|| first + lanes.trailing_zeros() as usize - 1);
            lanes == 0
        });
    }
    shown
}

/// The values of all nodes at some clocks.
struct Block<'a, L> {
    registers: &'a RegisterSimulation<'a>,
    taken: &'a [Taken],
    /// The place of the first clock that counts; it is in the second lane.
    first: usize,
    /// The clocks whose results count, a bit each.
    counted: u64,
    /// A column for each node, and one that stands for a node behind the register with the mistake.
    values: Vec<[L; LANES]>,
    /// The same of the nodes of the first stage while the clock is disabled before.
    paused: Vec<[L; LANES]>,
    /// What the mistake has changed, with the values without it.
    kept: Vec<(NodeId, [L; LANES])>,
    pending: Pending,
}

impl<'a, L: Lane> Block<'a, L> {
    fn new(registers: &'a RegisterSimulation, taken: &'a [Taken]) -> Self {
        let paused = registers.simulation.at_rest();
        let pending = Pending::of(paused.len());
        let values = [&paused[..], &[[L::zero(); LANES]]].concat();
        Self { registers, taken, first: 0, counted: 0, values, paused, kept: Vec::new(), pending }
    }

    /// The clock in a lane, if there is one.
    fn clock(&self, lane: usize) -> Option<&'a Taken> {
        (self.first + lane).checked_sub(1).and_then(|place| self.taken.get(place))
    }

    /// Goes on to the clocks from a place on.
    #[inline(always)]
    fn take(&mut self, first: usize) {
        let (graph, stage) = (self.registers.design.graph(), &self.registers.design.schedule.stage);
        self.first = first;
        self.counted = 0;
        for lane in 0..LANES {
            let clock = self.clock(lane);
            let counts = (1..=COUNTED).contains(&lane) && clock.is_some_and(|clock| clock.valid);
            self.counted |= u64::from(counts) << lane;
            for (port, &node) in graph.inputs.iter().enumerate() {
                let code = |codes: Option<&Vec<i64>>| L::from_code(codes.map_or(0, |codes| codes[port]).into());
                self.values[node][lane] = code(clock.map(|clock| &clock.codes));
                self.paused[node][lane] = code(clock.and_then(|clock| clock.paused.as_ref()));
            }
        }
        for (id, node) in graph.nodes.iter().enumerate() {
            if matches!(node.op, Op::Input | Op::Constant(_)) {
                continue;
            }
            let simulation = &self.registers.simulation;
            let mut result = [L::zero(); LANES];
            operate(simulation, id, node, |arg| node.args[arg], 0, &self.values, &mut result);
            if stage[id] == 0 && first == 0 {
                // Registers come up with 0: that is in front of the first clock's values.
                result[0] = L::zero();
            }
            self.values[id] = result;
            if stage[id] == 0 {
                operate(simulation, id, node, |arg| node.args[arg], 0, &self.paused, &mut result);
                self.paused[id] = result;
            }
        }
    }

    /// The node's values as they are seen from behind the register on.
    #[inline(always)]
    fn seen(&self, Mistake { node, register, what }: Mistake) -> [L; LANES] {
        let own = &self.values[node];
        let mut seen = *own;
        let stage = self.registers.design.schedule.stage[node] as usize;
        for lane in 1..=COUNTED {
            match what {
                Registered::Missing => seen[lane] = own[lane + 1],
                Registered::Doubled => seen[lane] = own[lane - 1],
                Registered::FreeRunning => {
                    // While it was in the register, this one was about to be taken.
                    let next = self.clock(lane + stage + register + 1);
                    if next.is_some_and(|next| next.paused.is_some()) {
                        let at_ports = stage + register == 0;
                        seen[lane] = if at_ports { self.paused[node][lane + 1] } else { own[lane + 1] };
                    }
                }
            }
        }
        seen
    }

    /// The lanes with a result that counts and is another with the mistake.
    #[inline(always)]
    fn shows(&mut self, mistake: Mistake) -> u64 {
        let Mistake { node, register, .. } = mistake;
        let (graph, stage) = (self.registers.design.graph(), &self.registers.design.schedule.stage);
        let seen = self.seen(mistake);
        if seen == self.values[node] {
            return 0;
        }
        // The column behind those of the nodes.
        let behind = graph.nodes.len();
        self.values[behind] = seen;
        let is_behind = |id: NodeId| stage[id] > stage[node] + register as u32;
        let simulation = &self.registers.simulation;
        simulation.readers(node).iter().filter(|&&id| is_behind(id)).for_each(|&id| self.pending.insert(&[id]));
        while let Some(id) = self.pending.take() {
            let own = &graph.nodes[id];
            let mut result = self.values[id];
            let arg = |arg: usize| if is_behind(id) && own.args[arg] == node { behind } else { own.args[arg] };
            operate(simulation, id, own, arg, 0, &self.values, &mut result);
            if result != self.values[id] {
                self.kept.push((id, std::mem::replace(&mut self.values[id], result)));
                self.pending.insert(simulation.readers(id));
            }
        }
        // An output is read from behind its last register.
        let mut lanes = if graph.is_output(node) { unlike(&seen, &self.values[node]) } else { 0 };
        for (id, right) in self.kept.drain(..) {
            if graph.is_output(id) {
                lanes |= unlike(&right, &self.values[id]);
            }
            self.values[id] = right;
        }
        lanes & self.counted
    }
}
