//! Circuits that are pipelines: what shows that one is, and what it computes.
//!
//! A circuit is one if
//! - every register and every write port has the clock `clk`, and every register takes its input at an edge with `ce` =
//!   1 only,
//! - every path from the inputs to a net has the same number of registers, so that a net's value is a function of the
//!   inputs of one clock, and every path to an output has the pipeline's,
//! - `out_valid` is `in_valid` through registers alone, all of which `rst` zeroes whatever `ce` is; no other register
//!   is zeroed, and neither `clk`, `rst`, `ce` nor the valid bits are read by anything else.
//!
//! Two pipelines of the same depth that are the same function with their registers as wires then show the same at every
//! clock: the outputs are that function of the inputs that were taken as many enabled edges ago.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::sync::atomic::{AtomicU64, Ordering};

use rayon::prelude::*;

use super::aig::{Aig, Literal};
use super::circuit::{Bit, Circuit, Part, Register, Unfit, Write};
use crate::core::{Design, Direction, Role};
use crate::fixed::Rng;
use crate::verify::golden::{Golden, Vector};

/// The most bits of inputs whose values are all run through: a quarter of a minute for a cubic core on two cores.
pub(super) const MOST_BITS: usize = 28;

/// A circuit that is a pipeline.
#[derive(Clone, Debug)]
pub(super) struct Pipeline {
    pub(super) circuit: Circuit,
    /// Registers between the inputs and the outputs.
    pub(super) depth: u32,
    /// Registers before each part, by its place.
    pub(super) before: HashMap<usize, u32>,
}

/// What a net holds.
#[derive(Clone, Copy, PartialEq)]
enum Holds {
    Constant,
    Control,
    /// `in_valid` of so many enabled edges ago.
    Valid(u32),
    /// A function of the inputs of so many enabled edges ago.
    Data(u32),
}

/// What each net of a circuit holds.
struct Nets(Vec<Holds>);

impl Nets {
    fn of_inputs(circuit: &Circuit) -> Self {
        let mut holds = vec![Holds::Constant; circuit.nets];
        for (name, nets) in &circuit.inputs {
            for &net in nets {
                holds[net] = match Role::of(name) {
                    Some(Role::InValid) => Holds::Valid(0),
                    Some(_) => Holds::Control,
                    None => Holds::Data(0),
                };
            }
        }
        Self(holds)
    }

    fn of(&self, bit: Bit) -> Holds {
        match bit {
            Bit::Constant(_) => Holds::Constant,
            Bit::Net(net) => self.0[net],
        }
    }

    /// What logic that reads these bits gives.
    fn data(&self, bits: &[Bit]) -> Result<Holds, Unfit> {
        let mut found = Holds::Constant;
        for &bit in bits {
            match (self.of(bit), found) {
                (Holds::Constant, _) => {}
                (Holds::Control, _) => return Err("logic reads clk, rst or ce".to_owned()),
                (Holds::Valid(_), _) => return Err("logic reads a valid bit".to_owned()),
                (one, Holds::Constant) => found = one,
                (one, other) if one == other => {}
                (Holds::Data(one), Holds::Data(other)) => {
                    return Err(format!("values of {one} and of {other} clocks ago meet"));
                }
                _ => unreachable!("only data is found"),
            }
        }
        Ok(found)
    }

    /// What a register gives.
    fn behind(&self, register: &Register, [clk, rst, ce]: [Bit; 3]) -> Result<Holds, Unfit> {
        let who = || register.names.first().cloned().unwrap_or_else(|| "without a name".to_owned());
        if register.clock != clk {
            return Err(format!("the register {} has another clock than clk", who()));
        }
        if register.enable != Some(ce) {
            return Err(format!("the register {} does not wait for ce", who()));
        }
        match (self.of(register.d), register.reset) {
            (Holds::Valid(depth), Some(reset)) if reset == rst => Ok(Holds::Valid(depth + 1)),
            (Holds::Valid(_), _) => Err(format!("rst does not clear the valid bit {}", who())),
            (_, Some(_)) => Err(format!("the register {} is zeroed", who())),
            (Holds::Control, None) => Err(format!("the register {} takes clk, rst or ce", who())),
            (Holds::Data(depth), None) => Ok(Holds::Data(depth + 1)),
            (Holds::Constant, None) => Ok(Holds::Constant),
        }
    }
}

/// Checks that a circuit is a pipeline, and returns how many registers each path from an input to an output has, and
/// how many stand before each register and each memory's read, by the part's place.
fn depths(circuit: &Circuit) -> Result<(u32, HashMap<usize, u32>), Unfit> {
    let port = |role: Role| {
        let name = role.name().unwrap_or_default();
        match circuit.inputs.get(name).map(Vec::as_slice) {
            Some([net]) => Ok(Bit::Net(*net)),
            _ => Err(format!("there is no input {name} of one bit")),
        }
    };
    let control = [port(Role::Clock)?, port(Role::Reset)?, port(Role::Enable)?];
    port(Role::InValid)?;
    let mut nets = Nets::of_inputs(circuit);
    let mut before = HashMap::new();
    for (index, part) in circuit.parts.iter().enumerate() {
        let (found, crossed) = match part {
            Part::Register(register) => (nets.behind(register, control)?, 1),
            _ => (nets.data(&part.reads())?, 0),
        };
        part.drives().into_iter().for_each(|net| nets.0[net] = found);
        if let Holds::Data(depth) = found {
            before.insert(index, depth - crossed);
        }
    }
    for write in circuit.memories.iter().flat_map(|memory| &memory.writes) {
        if write.clock != control[0] {
            return Err("a write port has another clock than clk".to_owned());
        }
        if !matches!(nets.data(&write.bits())?, Holds::Data(0) | Holds::Constant) {
            return Err("a write port takes what went through registers".to_owned());
        }
    }
    let is_valid = |(name, _): &(&String, &Vec<Bit>)| Role::of(name) == Some(Role::OutValid);
    let valid = match circuit.outputs.iter().find(is_valid).map(|(_, bits)| bits.as_slice()) {
        Some([bit]) => nets.of(*bit),
        _ => return Err("there is no output out_valid of one bit".to_owned()),
    };
    let Holds::Valid(depth) = valid else { return Err("out_valid is not in_valid some clocks later".to_owned()) };
    for (name, bits) in circuit.outputs.iter().filter(|port| !is_valid(port)) {
        match nets.data(bits).map_err(|why| format!("the output {name}: {why}"))? {
            Holds::Data(found) if found != depth => {
                return Err(format!("{name} comes {found} clocks after its input, and out_valid {depth}"));
            }
            _ => {}
        }
    }
    Ok((depth, before))
}

impl Pipeline {
    /// A circuit, if it is a pipeline of the depth `latency`. Errors: why it is none.
    pub(super) fn of(circuit: Circuit, latency: u32) -> Result<Self, Unfit> {
        let (depth, before) = depths(&circuit)?;
        if depth != latency {
            return Err(format!("its latency is {depth} clocks and not {latency}"));
        }
        Ok(Self { circuit, depth, before })
    }

    pub(super) fn data_inputs(&self) -> BTreeMap<&str, usize> {
        let ports = self.circuit.inputs.iter().filter(|(name, _)| Role::of(name).is_none());
        ports.map(|(name, nets)| (name.as_str(), nets.len())).collect()
    }

    pub(super) fn data_outputs(&self) -> BTreeMap<&str, &[Bit]> {
        let ports = self.circuit.outputs.iter().filter(|(name, _)| Role::of(name).is_none());
        ports.map(|(name, bits)| (name.as_str(), bits.as_slice())).collect()
    }

    /// The reads of memories that have a write port, in the order of their stages and of the names of the ports that
    /// they are written through: their places.
    pub(super) fn written_reads(&self) -> Vec<usize> {
        let circuit = &self.circuit;
        let is =
            |part: &Part| matches!(part, Part::Read { memory, .. } if !circuit.memories[*memory].writes.is_empty());
        let parts = circuit.parts.iter().enumerate();
        let mut reads: Vec<usize> = parts.filter(|(_, part)| is(part)).map(|(place, _)| place).collect();
        let ports = |place: usize| match &circuit.parts[place] {
            Part::Read { memory, .. } => self.ports_of(circuit.memories[*memory].writes.iter().flat_map(Write::bits)),
            _ => BTreeSet::new(),
        };
        reads.sort_by_cached_key(|&place| (self.before.get(&place), ports(place)));
        reads
    }

    /// The names of the ports that bits come from through gates alone.
    fn ports_of(&self, bits: impl Iterator<Item = Bit>) -> BTreeSet<&str> {
        let circuit = &self.circuit;
        let mut names = BTreeSet::new();
        let mut seen = BTreeSet::new();
        let mut left: Vec<Bit> = bits.collect();
        while let Some(bit) = left.pop() {
            let Bit::Net(net) = bit else { continue };
            if !seen.insert(net) {
                continue;
            }
            let own = circuit.inputs.iter().filter(|(_, nets)| nets.contains(&net));
            names.extend(own.map(|(name, _)| name.as_str()));
            let gates = circuit.parts.iter().filter(|part| matches!(part, Part::And { .. } | Part::Not { .. }));
            left.extend(gates.filter(|part| part.drives().contains(&net)).flat_map(Part::reads));
        }
        names
    }

    /// Runs the circuit on the inputs of golden vectors and compares what it shows: whether what Yosys reads is the
    /// core at all.
    ///
    /// Returns the number of vectors, or the first that differs.
    pub(super) fn against(&self, design: &Design, golden: &Golden) -> Result<usize, String> {
        let mut aig = Aig::new();
        let inputs = Inputs::new(&mut aig, self);
        let word = |aig: &mut Aig, place: usize, address: &[Literal]| match &self.circuit.parts[place] {
            Part::Read { memory, .. } => aig.word(&self.circuit.memories[*memory].words, address),
            _ => unreachable!("a read"),
        };
        let wires = self.circuit.build(&mut aig, &|name, bit| inputs.bit(name, bit), &word, &|_| None);
        let (taken, shown) = (design.numbers(Direction::In), design.numbers(Direction::Out));
        let outputs = self.data_outputs();
        let vectors = golden.vectors();
        for block in vectors.chunks(64) {
            let mut values = Vec::with_capacity(aig.inputs());
            for (name, port) in &inputs.0 {
                // A port that carries no number belongs to a memory's write port, which is not used here.
                let number = taken.iter().position(|(taken, _)| taken == name);
                let code = |vector: &Vector| number.map_or(0, |index| vector.inputs[index]);
                values.extend((0..port.len()).map(|bit| {
                    block.iter().enumerate().map(|(run, vector)| ((code(vector) >> bit & 1) as u64) << run).sum::<u64>()
                }));
            }
            values.resize(aig.inputs(), 0);
            let simulated = aig.simulate(&values);
            for (run, vector) in block.iter().enumerate() {
                for ((name, format), want) in shown.iter().zip(&vector.outputs) {
                    let bits = outputs.get(name).copied().ok_or_else(|| format!("there is no output {name}"))?;
                    let bits = wires.bits(bits).into_iter().enumerate();
                    let got: i64 = bits.map(|(place, bit)| ((simulated.of(bit) >> run & 1) as i64) << place).sum();
                    if got != want & ((1 << format.width()) - 1) {
                        return Err(format!("{}: {name} is {got} and not {want}", inputs.shown(&values, run)));
                    }
                }
            }
        }
        Ok(vectors.len())
    }
}

/// The data inputs of both circuits, as inputs of a graph.
pub(super) struct Inputs(pub(super) BTreeMap<String, Vec<Literal>>);

impl Inputs {
    /// The first inputs of a graph.
    pub(super) fn new(aig: &mut Aig, of: &Pipeline) -> Self {
        let port = |(name, width): (&str, usize)| (name.to_owned(), (0..width).map(|_| aig.input()).collect());
        Self(of.data_inputs().into_iter().map(port).collect())
    }

    /// A bit; the pipeline's control is outside of the function, where nothing reads it.
    pub(super) fn bit(&self, name: &str, bit: usize) -> Literal {
        self.0.get(name).map_or(Literal::FALSE, |port| port[bit])
    }

    /// All bits.
    pub(super) fn all(&self) -> Vec<Literal> {
        self.0.values().flatten().copied().collect()
    }

    /// The bits of the widest port as the first inputs of a graph, and those of the others as the constants of a
    /// number, lowest first.
    pub(super) fn of_widest(aig: &mut Aig, of: &Pipeline, mut number: u64) -> Self {
        let ports = of.data_inputs();
        let widest = widest(&ports);
        let port = |(name, width): (&str, usize)| {
            let mut bit = || {
                let bit = (number & 1 == 1).into();
                number >>= 1;
                bit
            };
            let bits = (0..width).map(|_| if Some(name) == widest { aig.input() } else { bit() }).collect();
            (name.to_owned(), bits)
        };
        Self(ports.into_iter().map(port).collect())
    }

    /// Values for all inputs of a graph, 64 runs: a port is even over its range, or near an end or the middle of it.
    pub(super) fn random(&self, aig: &Aig, rng: &mut Rng) -> Vec<u64> {
        let mut values = Vec::with_capacity(aig.inputs());
        for port in self.0.values() {
            let first = values.len();
            values.resize(first + port.len(), 0u64);
            for run in 0..64 {
                let any = rng.below(1 << 32) | rng.below(1 << 32) << 32;
                let (near, middle) = (rng.below(16), 1u64 << (port.len() - 1).min(63));
                let pattern = match rng.below(8) {
                    0 => near,
                    1 => near.wrapping_neg(),
                    2 => middle.wrapping_add(near),
                    3 => middle.wrapping_sub(near),
                    4 => (middle >> 1).wrapping_sub(near),
                    _ => any,
                };
                for (bit, value) in values[first..].iter_mut().enumerate() {
                    // A wider port repeats its bits.
                    *value |= (pattern >> (bit % 64) & 1) << run;
                }
            }
        }
        values.resize_with(aig.inputs(), || rng.below(1 << 32) | rng.below(1 << 32) << 32);
        values
    }

    /// The ports' codes in a run, in hexadecimal digits.
    pub(super) fn shown(&self, values: &[u64], run: usize) -> String {
        let mut rest = values;
        let mut texts = Vec::new();
        for (name, port) in &self.0 {
            let (own, others) = rest.split_at(port.len());
            rest = others;
            let digit =
                |bits: &[u64]| bits.iter().enumerate().map(|(place, bit)| (bit >> run & 1) << place).sum::<u64>();
            let digits: String = own.chunks(4).rev().map(|bits| format!("{:x}", digit(bits))).collect();
            texts.push(format!("{name} = {}'h{digits}", port.len()));
        }
        texts.join(", ")
    }
}

/// For each of the circuits the codes of the ports, as whole numbers, for which its outputs differ from the first
/// circuit's: of all inputs the first, those of the widest port for each value of the others. `None` if there are too
/// many inputs, or a memory has a write port.
pub(super) fn first_shown(core: &Pipeline, others: &[&Pipeline]) -> Option<Vec<Option<BTreeMap<String, u64>>>> {
    let ports = core.data_inputs();
    let bits: usize = ports.values().sum();
    let widest = ports.values().max().copied().unwrap_or(0);
    if bits > MOST_BITS || !core.written_reads().is_empty() {
        return None;
    }
    // The first values of the other ports of those that are known.
    let first: Vec<AtomicU64> = others.iter().map(|_| AtomicU64::new(u64::MAX)).collect();
    let run = |number: u64| -> Option<Vec<(usize, BTreeMap<String, u64>)>> {
        let open: Vec<usize> =
            (0..others.len()).filter(|&place| first[place].load(Ordering::Relaxed) > number).collect();
        let mut aig = Aig::new();
        let inputs = Inputs::of_widest(&mut aig, core, number);
        let mut outputs = |side: &Pipeline| -> Vec<Literal> {
            let no_write = |_: &mut Aig, _, _: &[Literal]| unreachable!("no memory has a write port");
            let wires = side.circuit.build(&mut aig, &|name, bit| inputs.bit(name, bit), &no_write, &|_| None);
            side.data_outputs().into_values().flat_map(|bits| wires.bits(bits)).collect()
        };
        let right = outputs(core);
        let differing = |wrong: Vec<Literal>| right.iter().copied().zip(wrong).filter(|(a, b)| a != b).collect();
        let groups: Vec<Vec<(Literal, Literal)>> =
            open.iter().map(|&place| differing(outputs(others[place]))).collect();
        let shown = aig.differences(&groups, widest).ok()?;
        let found = open.into_iter().zip(shown).filter_map(|(place, values)| {
            let values = values?;
            first[place].fetch_min(number, Ordering::Relaxed);
            let code = |port: &Vec<Literal>| {
                port.iter().enumerate().map(|(place, &bit)| u64::from(aig.value(bit, &values)) << place).sum()
            };
            Some((place, inputs.0.iter().map(|(name, port)| (name.clone(), code(port))).collect()))
        });
        Some(found.collect())
    };
    let found: Option<Vec<_>> = (0..1u64 << (bits - widest)).into_par_iter().map(run).collect();
    let mut shown: Vec<Option<BTreeMap<String, u64>>> = vec![None; others.len()];
    // In the order of the numbers.
    for (place, codes) in found?.into_iter().flatten() {
        shown[place].get_or_insert(codes);
    }
    Some(shown)
}

/// The name of the port with the most bits.
fn widest<'a>(ports: &BTreeMap<&'a str, usize>) -> Option<&'a str> {
    ports.iter().max_by_key(|(_, width)| **width).map(|(name, _)| *name)
}
