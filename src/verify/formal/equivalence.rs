//! Two texts of a core are the same circuit.
//!
//! Both are read by Yosys to gates and registers ([`super::circuit`]) and checked to be [pipelines](super::pipeline):
//! every register waits for `ce`, `rst` clears the valid bits, every path has the same number of registers, the
//! latency. For such circuits it is enough that they are the same function with their registers as wires, which is
//! proved for *all* inputs:
//!
//! 1. Both are built in one and-inverter graph ([`super::aig`]), memories without a write port as logic, with every bit
//!    of every word, so that their contents are compared with the rest, and products as gates. What is written alike is
//!    there already the same node.
//! 2. Random inputs are run through both. Outputs that differ refute the claim, with the inputs that show it. Registers
//!    of the two that are the same in all runs, under the same name or under different ones, become pairs, one bit of
//!    the one and one of the other. Of these only such are kept that also take the same in random runs of the circuits
//!    cut at them.
//! 3. The two are built again, cut at the pairs: one new input stands for both registers of a pair. For each pair the
//!    two inputs of the registers are compared, and so are the outputs, as functions of the circuits' inputs and these
//!    new ones; most are the same node, the others go to ABC's `cec`. If all are the same, then so are the circuits: by
//!    induction over the stages, as what stands before a register depends on earlier stages alone. A pair that was no
//!    pair makes this fail; it cannot make it succeed.
//! 4. If it fails, the outputs are compared as functions of the inputs, without cuts: by ABC within the time limit,
//!    then by running every value of the inputs through both where they have at most 28 bits. The rust-hdl kernels need
//!    this: they keep bits that the others leave out because they matter for no value of the inputs, though for values
//!    of the registers that never come up together.
//!
//! A memory with a write port is outside of both circuits: what it shows is a new input, and its address and its write
//! port (the word and the address of that only while it writes) are compared as outputs are, its first words as they
//! are. Two memories with the same words, written alike and read at the same address in the same stage, show the same.
//!
//! A bit that a text leaves undefined, as in a case that never happens, is a new input as well, another in each
//! circuit, so that the proof goes through only where it does not matter; before that Yosys may have taken one that it
//! sees to be harmless for what it likes.
//!
//! What is not said: what the outputs are while `out_valid` is 0, and what the registers hold when the power comes.

use std::collections::HashMap;

use rayon::prelude::*;

use super::abc::{self, Answer};
use super::aig::{Aig, Literal};
use super::circuit::{Part, Register, Wires, Write};
use super::pipeline::{Inputs, MOST_BITS, Pipeline};
use crate::fixed::Rng;
use crate::platform::error::Error;

/// Blocks of 64 random runs.
const BLOCKS: usize = 64;

/// How two circuits are compared.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Technique {
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
    Same { method: Technique, compared: usize, open: usize },
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
    /// What a write port of a side does: its enables; its word and address where they are taken, and 0 where they are
    /// not.
    fn written(&mut self, side: usize, write: &Write) -> Vec<Literal> {
        let [mut taken, data, address] =
            [&write.enable, &write.data, &write.address].map(|bits| self.wires[side].bits(bits));
        let any = taken.iter().fold(Literal::FALSE, |any, &enable| self.aig.or(any, enable));
        let enables = taken.clone().into_iter().chain(std::iter::repeat_n(any, address.len()));
        taken.extend(data.into_iter().chain(address).zip(enables).map(|(bit, enable)| self.aig.and(bit, enable)));
        taken
    }

    /// Makes the lowest bit of a result of the second side wrong for one of all inputs.
    fn inject(&mut self, duties: &mut [Pair]) {
        let mut rng = Rng::new(5);
        let hit = self.inputs.all().into_iter().fold(Literal::TRUE, |hit, bit| {
            let wanted = if rng.below(2) == 0 { bit } else { !bit };
            self.aig.and(hit, wanted)
        });
        if let Some(Pair { bits: (_, wrong), .. }) = duties.first_mut() {
            *wrong = self.aig.xor(*wrong, hit);
        }
    }
}

impl<'a> Comparison<'a> {
    /// Two pipelines with the same ports and the same memories that are written. Errors: how they differ.
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
        let mut rng = Rng::new(4);
        let registers = [0, 1].map(|side| self.sides[side].circuit.registers().collect::<Vec<_>>());
        let mut seen: [Vec<Vec<u64>>; 2] = [0, 1].map(|side| vec![Vec::with_capacity(BLOCKS); registers[side].len()]);
        for _ in 0..BLOCKS {
            let values = both.inputs.random(&both.aig, &mut rng);
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

    /// The pairs whose registers also take the same in random runs of the cut circuits: those that only looked alike
    /// are dropped, one round after the other, as what stands behind a pair that is dropped is then seen through it.
    pub(super) fn confirmed(&self, mut pairs: Vec<[usize; 2]>) -> Vec<[usize; 2]> {
        let mut rng = Rng::new(6);
        loop {
            let (both, duties) = self.cut(&pairs);
            let mut differs = vec![false; duties.len()];
            for _ in 0..BLOCKS / 8 {
                let simulated = both.aig.simulate(&both.inputs.random(&both.aig, &mut rng));
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

    /// Asks a method. Returns the answer, with the inputs that show a difference where the method says them, how many
    /// bits were compared, and how many were not the same node. `seconds` is the most that the solver may take. Errors:
    /// if the solver does not work.
    pub(super) fn ask(&self, method: &Technique, results: Results, seconds: u32) -> Result<Asked, Error> {
        let pairs: &[[usize; 2]] = match method {
            Technique::Stages(pairs) => pairs,
            Technique::Every => return Ok(self.every(results)),
            Technique::Whole => &[],
        };
        let (mut both, mut duties) = self.cut(pairs);
        if results == Results::OneWrong {
            both.inject(&mut duties);
        }
        let open = open(&duties);
        let answer = if open.is_empty() { Answer::Equal } else { abc::equal(&both.aig, &open, seconds)? };
        Ok(Asked { answer, shown: None, compared: duties.len(), open: open.len() })
    }

    /// Runs all values of the inputs through both: those of the widest port, once for each value of the others, which
    /// makes the graph small. Bits that a text leaves undefined are run through as well; where there are too many, it
    /// is not found out.
    fn every(&self, results: Results) -> Asked {
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
            if results == Results::OneWrong {
                both.inject(&mut duties);
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
    /// Errors: if the solver does not work.
    pub(super) fn run(&self, seconds: u32) -> Result<Compared, Error> {
        let pairs = match self.pairs() {
            Ok(pairs) => pairs,
            Err(differs) => return Ok(Compared::Different(differs)),
        };
        let stages = Technique::Stages(self.confirmed(pairs));
        let asked = self.ask(&stages, Results::Own, seconds)?;
        if asked.answer == Answer::Equal {
            return Ok(Compared::Same { method: stages, compared: asked.compared, open: asked.open });
        }
        let mut method = Technique::Whole;
        let mut asked = self.ask(&method, Results::Own, seconds)?;
        if asked.answer == Answer::Unknown {
            method = Technique::Every;
            asked = self.ask(&method, Results::Own, seconds)?;
        }
        let Asked { answer, shown, compared, open } = asked;
        Ok(match answer {
            Answer::Equal => Compared::Same { method, compared, open },
            Answer::Different => Compared::Different(shown.map_or_else(
                || "the solver has found inputs for which the outputs differ".to_owned(),
                |shown| format!("the outputs differ for {shown}"),
            )),
            Answer::Unknown => Compared::Unknown(format!(
                "their registers are not the same stage by stage, and the solver did not compare the outputs as \
                 functions of the inputs in {seconds} s; these have more values than are run through"
            )),
        })
    }
}

/// Whose results are compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Results {
    /// The circuits' own.
    Own,
    /// One of them wrong on purpose.
    OneWrong,
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
