//! Two texts of a core are the same circuit.
//!
//! Both are read by Yosys to gates and registers ([`super::circuit`]) and checked to be pipelines ([`Circuit::pipeline`]): every register
//! waits for `ce`, `rst` clears the valid bits, every path has the same number of registers, the latency. For such circuits it is enough
//! that they are the same function with their registers as wires, which is proved for *all* inputs:
//!
//! 1. Both are built in one and-inverter graph ([`super::aig`]), memories without a write port as logic, with every bit of every word, so
//!    that their contents are compared with the rest, and products as gates. What is written alike is there already the same node.
//! 2. Random inputs are run through both. Outputs that differ refute the claim, with the inputs that show it. Registers of the two that
//!    are the same in all runs, under the same name or under different ones, become pairs, one bit of the one and one of the other.
//!    Of these only such are kept that also take the same in random runs of the circuits cut at them.
//! 3. The two are built again, cut at the pairs: one new input stands for both registers of a pair. For each pair the two inputs of the
//!    registers are compared, and so are the outputs, as functions of the circuits' inputs and these new ones; most are the same node, the
//!    others go to ABC's `cec`. If all are the same, then so are the circuits: by induction over the stages, as what stands before a
//!    register depends on earlier stages alone. A pair that was no pair makes this fail; it cannot make it succeed.
//! 4. If it fails, the outputs are compared as functions of the inputs, without cuts: by ABC within the time limit, then by running every
//!    value of the inputs through both where they have at most 28 bits. The rust-hdl kernels need this: they keep bits that the
//!    others leave out because they matter for no value of the inputs, though for values of the registers that never come up together.
//!
//! A memory with a write port is outside of both circuits: what it shows is a new input, and its address and its write port (the
//! word and the address of that only while it writes) are compared as outputs are, its first words as they are. Two memories with the same words, written alike and read at the same address
//! in the same stage, show the same.
//!
//! A bit that a text leaves undefined, as in a case that never happens, is a new input as well, another in each circuit, so that the
//! proof goes through only where it does not matter; before that Yosys may have taken one that it sees to be harmless for what it likes.
//!
//! What is not said: what the outputs are while `out_valid` is 0, and what the registers hold when the power comes.

use std::collections::{BTreeMap, HashMap};
use std::sync::atomic::{AtomicU64, Ordering};

use super::abc::{self, Answer};
use super::aig::{Aig, Literal};
use super::circuit::{Bit, Circuit, Part, Register, Unfit, Wires, Write};
use rayon::prelude::*;

use crate::core::Design;
use crate::core::Direction;
use crate::fixed::Dice;
use crate::platform::error::Error;
use crate::verify::golden::{Golden, Vector};

/// Blocks of 64 random runs.
const BLOCKS: usize = 64;

/// The most bits of inputs whose values are all run through: a quarter of a minute for a cubic core on two cores.
const MOST_BITS: usize = 28;

/// Inputs that are no data.
const CONTROL: [&str; 4] = ["clk", "rst", "ce", "in_valid"];

/// A circuit that is a pipeline.
#[derive(Clone, Debug)]
pub(super) struct Pipeline {
    pub(super) circuit: Circuit,
    /// Registers between the inputs and the outputs.
    pub(super) depth: u32,
    /// Registers before each part, by its place.
    before: HashMap<usize, u32>,
}

/// How two circuits are compared.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Method {
    /// Cut at these pairs of registers, by the solver.
    Stages(Vec<[usize; 2]>),
    /// From the inputs to the outputs, each of the inputs' values.
    Every,
    /// From the inputs to the outputs, by the solver.
    Whole,
}

/// What a comparison gives.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Compared {
    /// They are the same. Of `compared` bits `open` were not the same node from the start.
    Same { method: Method, compared: usize, open: usize },
    /// They are not: why.
    Different(String),
    /// It was not found out: why.
    Unknown(String),
}

/// A bit of both circuits that must be the same.
struct Pair {
    what: String,
    bits: (Literal, Literal),
}

impl Pipeline {
    /// A circuit, if it is a pipeline of the depth `latency`.
    ///
    /// # Errors
    /// Why it is none.
    pub(super) fn of(circuit: Circuit, latency: u32) -> Result<Self, Unfit> {
        let (depth, before) = circuit.pipeline()?;
        if depth != latency {
            return Err(format!("its latency is {depth} clocks and not {latency}"));
        }
        Ok(Self { circuit, depth, before })
    }

    fn data_inputs(&self) -> BTreeMap<&str, usize> {
        let ports = self.circuit.inputs.iter().filter(|(name, _)| !CONTROL.contains(&name.as_str()));
        ports.map(|(name, nets)| (name.as_str(), nets.len())).collect()
    }

    fn data_outputs(&self) -> BTreeMap<&str, &[Bit]> {
        let ports = self.circuit.outputs.iter().filter(|(name, _)| *name != "out_valid");
        ports.map(|(name, bits)| (name.as_str(), bits.as_slice())).collect()
    }

    /// The reads of memories that have a write port, in the order of their stages: their places.
    fn written_reads(&self) -> Vec<usize> {
        let circuit = &self.circuit;
        let is =
            |part: &Part| matches!(part, Part::Read { memory, .. } if !circuit.memories[*memory].writes.is_empty());
        let parts = circuit.parts.iter().enumerate();
        let mut reads: Vec<usize> = parts.filter(|(_, part)| is(part)).map(|(place, _)| place).collect();
        reads.sort_by_key(|place| self.before.get(place));
        reads
    }

    /// Runs the circuit on the inputs of golden vectors and compares what it shows: whether what Yosys reads is the core at all.
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
struct Inputs(BTreeMap<String, Vec<Literal>>);

impl Inputs {
    /// The first inputs of a graph.
    fn new(aig: &mut Aig, of: &Pipeline) -> Self {
        let port = |(name, width): (&str, usize)| (name.to_owned(), (0..width).map(|_| aig.input()).collect());
        Self(of.data_inputs().into_iter().map(port).collect())
    }

    /// A bit; the pipeline's control is outside of the function, where nothing reads it.
    fn bit(&self, name: &str, bit: usize) -> Literal {
        self.0.get(name).map_or(Literal::FALSE, |port| port[bit])
    }

    /// All bits.
    fn all(&self) -> Vec<Literal> {
        self.0.values().flatten().copied().collect()
    }

    /// The bits of the widest port as the first inputs of a graph, and those of the others as the constants of a number, lowest first.
    fn of_widest(aig: &mut Aig, of: &Pipeline, mut number: u64) -> Self {
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
    fn random(&self, aig: &Aig, dice: &mut Dice) -> Vec<u64> {
        let mut values = Vec::with_capacity(aig.inputs());
        for port in self.0.values() {
            let first = values.len();
            values.resize(first + port.len(), 0u64);
            for run in 0..64 {
                let any = dice.below(1 << 32) | dice.below(1 << 32) << 32;
                let (near, middle) = (dice.below(16), 1u64 << (port.len() - 1).min(63));
                let pattern = match dice.below(8) {
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
        values.resize_with(aig.inputs(), || dice.below(1 << 32) | dice.below(1 << 32) << 32);
        values
    }

    /// The ports' codes in a run, in hexadecimal digits.
    fn shown(&self, values: &[u64], run: usize) -> String {
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

/// For each of the circuits the codes of the ports, as whole numbers, for which its outputs differ from the first circuit's: of all inputs
/// the first, those of the widest port for each value of the others. `None` if there are too many inputs, or a memory has a write port.
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

/// Two pipelines side by side.
pub(super) struct Comparison<'a> {
    pub(super) sides: [&'a Pipeline; 2],
    /// The reads of memories with a write port, of both.
    pub(super) reads: Vec<[usize; 2]>,
}

/// Both circuits in one graph.
struct Both {
    aig: Aig,
    inputs: Inputs,
    wires: [Wires; 2],
}

impl Both {
    /// What a write port of a side does: its enables; its word and address where they are taken, and 0 where they are not.
    fn written(&mut self, side: usize, write: &Write) -> Vec<Literal> {
        let [mut taken, data, address] =
            [&write.enable, &write.data, &write.address].map(|bits| self.wires[side].bits(bits));
        let any = taken.iter().fold(Literal::FALSE, |any, &enable| self.aig.or(any, enable));
        let enables = taken.clone().into_iter().chain(std::iter::repeat_n(any, address.len()));
        taken.extend(data.into_iter().chain(address).zip(enables).map(|(bit, enable)| self.aig.and(bit, enable)));
        taken
    }

    /// Makes the lowest bit of a result of the second side wrong for one of all inputs.
    fn plant(&mut self, duties: &mut [Pair]) {
        let mut dice = Dice::new(5);
        let hit = self.inputs.all().into_iter().fold(Literal::TRUE, |hit, bit| {
            let wanted = if dice.below(2) == 0 { bit } else { !bit };
            self.aig.and(hit, wanted)
        });
        if let Some(Pair { bits: (_, wrong), .. }) = duties.first_mut() {
            *wrong = self.aig.xor(*wrong, hit);
        }
    }
}

impl<'a> Comparison<'a> {
    /// Two pipelines with the same ports and the same memories that are written.
    ///
    /// # Errors
    /// How they differ.
    pub(super) fn new(one: &'a Pipeline, other: &'a Pipeline) -> Result<Self, String> {
        let widths = |side: &Pipeline| -> Vec<(String, usize)> {
            let outputs = side.data_outputs().into_iter().map(|(name, bits)| (name.to_owned(), bits.len()));
            side.data_inputs().into_iter().map(|(name, width)| (name.to_owned(), width)).chain(outputs).collect()
        };
        if widths(one) != widths(other) {
            return Err(format!("their ports differ: {:?} and {:?}", widths(one), widths(other)));
        }
        if one.depth != other.depth {
            return Err(format!("their latencies differ: {} and {} clocks", one.depth, other.depth));
        }
        let reads = [one.written_reads(), other.written_reads()];
        let [ours, theirs] = &reads;
        let same = |(&a, &b): (&usize, &usize)| match (&one.circuit.parts[a], &other.circuit.parts[b]) {
            (Part::Read { memory: m, .. }, Part::Read { memory: n, .. }) => {
                one.circuit.memories[*m].words == other.circuit.memories[*n].words
                    && one.before.get(&a) == other.before.get(&b)
            }
            _ => false,
        };
        if ours.len() != theirs.len() || !ours.iter().zip(theirs).all(same) {
            return Err("their memories that are written differ in their words or their stages".to_owned());
        }
        Ok(Self { sides: [one, other], reads: ours.iter().zip(theirs).map(|(&a, &b)| [a, b]).collect() })
    }

    /// Builds both in one graph, cut at registers.
    fn build(&self, cuts: &[[usize; 2]]) -> Both {
        let mut aig = Aig::new();
        let inputs = Inputs::new(&mut aig, self.sides[0]);
        self.build_on(aig, inputs, cuts)
    }

    fn build_on(&self, mut aig: Aig, inputs: Inputs, cuts: &[[usize; 2]]) -> Both {
        let mut shown: HashMap<usize, Vec<Literal>> = HashMap::new();
        for &[place, _] in &self.reads {
            if let Part::Read { data, .. } = &self.sides[0].circuit.parts[place] {
                shown.insert(place, data.iter().map(|_| aig.input()).collect());
            }
        }
        let bits: Vec<Literal> = cuts.iter().map(|_| aig.input()).collect();
        let wires = [0, 1].map(|side| {
            let cut: HashMap<usize, Literal> = cuts.iter().zip(&bits).map(|(cut, &bit)| (cut[side], bit)).collect();
            let word = |_: &mut Aig, place: usize, _: &[Literal]| {
                let pair =
                    self.reads.iter().find(|pair| pair[side] == place).expect("a read of a memory that is written");
                shown[&pair[0]].clone()
            };
            let input = |name: &str, bit: usize| inputs.bit(name, bit);
            self.sides[side].circuit.build(&mut aig, &input, &word, &|place| cut.get(&place).copied())
        });
        Both { aig, inputs, wires }
    }

    /// What must be the same: outputs, and what memories with a write port take.
    fn duties(&self, both: &mut Both) -> Vec<Pair> {
        let mut pairs = Vec::new();
        let mut add = |what: &dyn Fn(usize) -> String, [ours, theirs]: [Vec<Literal>; 2]| {
            let new = ours.into_iter().zip(theirs).enumerate();
            pairs.extend(new.map(|(place, bits)| Pair { what: what(place), bits }));
        };
        let outputs = self.sides.map(Pipeline::data_outputs);
        for name in outputs[0].keys() {
            add(&|place| format!("{name}[{place}]"), [0, 1].map(|side| both.wires[side].bits(outputs[side][name])));
        }
        for pair in &self.reads {
            let ports = [0, 1].map(|side| match &self.sides[side].circuit.parts[pair[side]] {
                Part::Read { memory, address, .. } => {
                    let mut port = both.wires[side].bits(address);
                    for write in &self.sides[side].circuit.memories[*memory].writes {
                        port.extend(both.written(side, write));
                    }
                    port
                }
                _ => unreachable!("a read"),
            });
            add(&|place| format!("the memory's port, bit {place}"), ports);
        }
        pairs
    }

    /// The pairs of registers that were the same in all runs, or a run that shows other outputs.
    fn pairs(&self) -> Result<Vec<[usize; 2]>, String> {
        let mut both = self.build(&[]);
        let duties = self.duties(&mut both);
        let mut dice = Dice::new(4);
        let registers = [0, 1].map(|side| self.sides[side].circuit.registers().collect::<Vec<_>>());
        let mut seen: [Vec<Vec<u64>>; 2] = [0, 1].map(|side| vec![Vec::with_capacity(BLOCKS); registers[side].len()]);
        for _ in 0..BLOCKS {
            let values = both.inputs.random(&both.aig, &mut dice);
            let simulated = both.aig.simulate(&values);
            for Pair { what, bits } in &duties {
                let differ = simulated.of(bits.0) ^ simulated.of(bits.1);
                if differ != 0 {
                    let run = differ.trailing_zeros() as usize;
                    return Err(format!("{what} differs for {}", both.inputs.shown(&values, run)));
                }
            }
            for side in [0, 1] {
                for (seen, (_, register)) in seen[side].iter_mut().zip(&registers[side]) {
                    seen.push(simulated.of(both.wires[side].bit(register.d)));
                }
            }
        }
        let before = |side: usize, index: usize| self.sides[side].before.get(&registers[side][index].0);
        let mut by_name: HashMap<&str, usize> = HashMap::new();
        let mut by_values: HashMap<(&[u64], Option<&u32>), Vec<usize>> = HashMap::new();
        for (index, (_, Register { names, .. })) in registers[1].iter().enumerate() {
            by_name.extend(names.iter().map(|name| (name.as_str(), index)));
            by_values.entry((seen[1][index].as_slice(), before(1, index))).or_default().push(index);
        }
        let mut taken = vec![false; registers[1].len()];
        let mut pairs = Vec::new();
        // Those of the same name first: there may be several with the same values.
        for named in [true, false] {
            for (index, (place, register)) in registers[0].iter().enumerate() {
                let Some(depth) = before(0, index) else { continue };
                let is = |other: &usize| {
                    seen[1][*other] == seen[0][index] && before(1, *other) == Some(depth) && !taken[*other]
                };
                let partner = if named {
                    register.names.iter().filter_map(|name| by_name.get(name.as_str()).copied()).find(is)
                } else if pairs.iter().any(|pair: &[usize; 2]| pair[0] == *place) {
                    None
                } else {
                    by_values.get(&(seen[0][index].as_slice(), Some(depth))).into_iter().flatten().copied().find(is)
                };
                if let Some(partner) = partner {
                    taken[partner] = true;
                    pairs.push([*place, registers[1][partner].0]);
                }
            }
        }
        Ok(pairs)
    }

    /// The pairs whose registers also take the same in random runs of the cut circuits: those that only looked alike are dropped, one
    /// round after the other, as what stands behind a pair that is dropped is then seen through it.
    pub(super) fn confirmed(&self, mut pairs: Vec<[usize; 2]>) -> Vec<[usize; 2]> {
        let mut dice = Dice::new(6);
        loop {
            let (both, duties) = self.cut(&pairs);
            let mut differs = vec![false; duties.len()];
            for _ in 0..BLOCKS / 8 {
                let simulated = both.aig.simulate(&both.inputs.random(&both.aig, &mut dice));
                for (differs, Pair { bits, .. }) in differs.iter_mut().zip(&duties) {
                    *differs |= simulated.of(bits.0) != simulated.of(bits.1);
                }
            }
            // Those of the registers come last.
            let of_registers = &differs[duties.len() - pairs.len()..];
            if !of_registers.contains(&true) {
                return pairs;
            }
            pairs =
                pairs.into_iter().zip(of_registers).filter(|(_, differs)| !**differs).map(|(pair, _)| pair).collect();
        }
    }

    /// Both, cut at the pairs, and what must then be the same.
    fn cut(&self, cuts: &[[usize; 2]]) -> (Both, Vec<Pair>) {
        let mut both = self.build(cuts);
        let mut duties = self.duties(&mut both);
        for cut in cuts {
            let [ours, theirs] = [0, 1].map(|side| match &self.sides[side].circuit.parts[cut[side]] {
                Part::Register(register) => (register.names.first(), both.wires[side].bit(register.d)),
                _ => unreachable!("a register"),
            });
            let what =
                ours.0.or(theirs.0).map_or_else(|| "a register".to_owned(), |name| format!("the register {name}"));
            duties.push(Pair { what, bits: (ours.1, theirs.1) });
        }
        (both, duties)
    }

    /// Asks a method. `planted`: with one wrong result. Returns the answer, with the inputs that show a difference where the method says
    /// them, how many bits were compared, and how many were not the same node. `seconds` is the most that the solver may take.
    ///
    /// # Errors
    /// If the solver does not work.
    pub(super) fn ask(&self, method: &Method, planted: bool, seconds: u32) -> Result<Asked, Error> {
        let pairs: &[[usize; 2]] = match method {
            Method::Stages(pairs) => pairs,
            Method::Every => return Ok(self.every(planted)),
            Method::Whole => &[],
        };
        let (mut both, mut duties) = self.cut(pairs);
        if planted {
            both.plant(&mut duties);
        }
        let open = open(&duties);
        let answer = if open.is_empty() { Answer::Equal } else { abc::equal(&both.aig, &open, seconds)? };
        Ok(Asked { answer, shown: None, compared: duties.len(), open: open.len() })
    }

    /// Runs all values of the inputs through both: those of the widest port, once for each value of the others, which makes the graph small.
    /// Bits that a text leaves undefined are run through as well; where there are too many, it is not found out.
    fn every(&self, planted: bool) -> Asked {
        let ports = self.sides[0].data_inputs();
        let bits: usize = ports.values().sum();
        let widest = ports.values().max().copied().unwrap_or(0);
        if bits > MOST_BITS || !self.reads.is_empty() {
            return Asked { answer: Answer::Unknown, shown: None, compared: 0, open: 0 };
        }
        let duties_of = |number: u64| {
            let mut aig = Aig::new();
            let inputs = Inputs::of_widest(&mut aig, self.sides[0], number);
            let mut both = self.build_on(aig, inputs, &[]);
            let mut duties = self.duties(&mut both);
            if planted {
                both.plant(&mut duties);
            }
            (both, duties)
        };
        let (_, duties) = duties_of(0);
        let found = (0..1u64 << (bits - widest)).into_par_iter().find_map_first(|number| {
            let (both, duties) = duties_of(number);
            let values = match both.aig.difference(&open(&duties), MOST_BITS - (bits - widest)) {
                Ok(found) => found?,
                Err(_) => return Some(None),
            };
            let port = |(name, port): (&String, &Vec<Literal>)| {
                let bits = port.iter().enumerate();
                let code: u64 = bits.map(|(place, &bit)| u64::from(both.aig.value(bit, &values)) << place).sum();
                format!("{name} = {}'h{code:x}", port.len())
            };
            Some(Some(both.inputs.0.iter().map(port).collect::<Vec<_>>().join(", ")))
        });
        let (answer, shown) = match found {
            None => (Answer::Equal, None),
            Some(None) => (Answer::Unknown, None),
            Some(shown) => (Answer::Different, shown),
        };
        Asked { answer, shown, compared: duties.len(), open: duties.len() }
    }

    /// Compares the two. `seconds` is the most that the solver may take, each of the two times that it is asked.
    ///
    /// # Errors
    /// If the solver does not work.
    pub(super) fn run(&self, seconds: u32) -> Result<Compared, Error> {
        let pairs = match self.pairs() {
            Ok(pairs) => pairs,
            Err(differs) => return Ok(Compared::Different(differs)),
        };
        let stages = Method::Stages(self.confirmed(pairs));
        let asked = self.ask(&stages, false, seconds)?;
        if asked.answer == Answer::Equal {
            return Ok(Compared::Same { method: stages, compared: asked.compared, open: asked.open });
        }
        let mut method = Method::Whole;
        let mut asked = self.ask(&method, false, seconds)?;
        if asked.answer == Answer::Unknown {
            method = Method::Every;
            asked = self.ask(&method, false, seconds)?;
        }
        let Asked { answer, shown, compared, open } = asked;
        Ok(match answer {
            Answer::Equal => Compared::Same { method, compared, open },
            Answer::Different => Compared::Different(shown.map_or_else(
                || "the solver has found inputs for which the outputs differ".to_owned(),
                |shown| format!("the outputs differ for {shown}"),
            )),
            Answer::Unknown => Compared::Unknown(format!(
                "their registers are not the same stage by stage, and the solver did not compare the outputs as functions of the inputs in {seconds} s; these have more values than are run through"
            )),
        })
    }
}

/// What a method says.
pub(super) struct Asked {
    pub(super) answer: Answer,
    /// The inputs for which the outputs differ, if the method says them.
    shown: Option<String>,
    compared: usize,
    open: usize,
}

/// The pairs that are not the same node.
fn open(pairs: &[Pair]) -> Vec<(Literal, Literal)> {
    pairs.iter().map(|pair| pair.bits).filter(|(one, other)| one != other).collect()
}
