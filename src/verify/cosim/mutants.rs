//! Many mutants of a netlist as one program.
//!
//! Verilator compiles a netlist with an input `mutant`, which chooses what is wrong in it, with a harness of ours,
//! `testbench/mutants.cpp`, into a program that runs golden vectors, any of all inputs, or random ones through each.

use std::path::PathBuf;

use askama::Template;

use super::compiled::{CORE, converse, program};
use crate::core::{Design, Direction, WritePort};
use crate::emit::render;
use crate::fixed::{Format, Table};
use crate::platform::error::Error;
use crate::verify::golden::{self, Golden, Vector};

/// How many of the last inputs are given of what random ones detect, beyond those that are on their way through the
/// core.
const BEFORE: usize = 8;

const HARNESS: &str = include_str!("../../../testbench/mutants.cpp");

/// What of a run of vectors detects a mutant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Detected {
    /// The reset in front of the vectors.
    ByReset,
    /// The vector of this number, from 1.
    ByVector(u32),
}

impl std::fmt::Display for Detected {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::ByReset => f.write_str("the reset"),
            Self::ByVector(number) => write!(f, "vector {number}"),
        }
    }
}

/// How random clocks detect a mutant.
pub(crate) struct AtRandom {
    /// At which clock, from 0.
    pub(crate) clock: u64,
    /// The last inputs that were taken until then, in order.
    pub(crate) recent: Vec<Vec<i64>>,
}

/// A netlist with mutants, compiled.
pub(crate) struct Mutants<'a> {
    design: &'a Design,
    program: PathBuf,
}

impl<'a> Mutants<'a> {
    /// Compiles a core's netlist with the input `mutant`, 0 for none.
    /// Errors: a tool that is not installed or does not compile the netlist.
    pub(crate) fn of(design: &'a Design, verilog: &[u8]) -> Result<Self, Error> {
        let sources = [
            ("core.v", verilog),
            ("core.h", &render(&Header::of(design))?.into_bytes()),
            ("mutants.cpp", HARNESS.as_bytes()),
        ];
        Ok(Self { design, program: program(&design.spec.name, &sources, "-O2")? })
    }

    /// What of golden vectors detects each of the mutants from 0 to before `count`, if anything does; where memories
    /// can be written, by some with other words as well, and by all with the right words written.
    /// Errors: a program that does not run to its end.
    pub(crate) fn golden(&self, golden: &Golden, count: u32) -> Result<Vec<Option<Detected>>, Error> {
        let own = golden.vectors();
        if self.design.write_ports().is_empty() {
            return self.by_vectors(&own, &[], 0, count);
        }
        let other = golden::complemented(self.design, golden);
        let vectors: Vec<&Vector> = own.iter().copied().chain(&other).chain(own.iter().copied()).collect();
        let loads = [
            (own.len(), golden::complemented_tables(self.design)),
            (own.len() + other.len(), self.design.tables().to_vec()),
        ];
        self.by_vectors(&vectors, &loads, 0, count)
    }

    /// The place of the vector that goes in when a mutant is first seen to differ from these vectors.
    /// Errors: a program that does not run to its end.
    pub(crate) fn first_of(&self, mutant: u32, vectors: &[Vector]) -> Result<Option<usize>, Error> {
        let found = self.by_vectors(&vectors.iter().collect::<Vec<_>>(), &[], mutant, 1)?;
        Ok(if let [Some(Detected::ByVector(number))] = found[..] { Some(number as usize - 1) } else { None })
    }

    /// Whether inputs show a mutant as vectors that a spec asks for. Errors: a program that does not run to its end.
    pub(crate) fn show(&self, mutant: u32, inputs: &[Vec<i64>]) -> Result<bool, Error> {
        let vectors = golden::asked_for(self.design, inputs);
        let found = self.by_vectors(&vectors.iter().collect::<Vec<_>>(), &[], mutant, 1)?;
        // In front of others the reset would find what it finds here.
        Ok(matches!(found[..], [Some(Detected::ByVector(_))]))
    }

    /// What of vectors detects each of so many mutants from the first on. Before those at some places words are written
    /// into the memories.
    fn by_vectors(
        &self,
        vectors: &[&Vector],
        loads: &[(usize, Vec<Table>)],
        first: u32,
        count: u32,
    ) -> Result<Vec<Option<Detected>>, Error> {
        let mut words = vec![0, first, count, vectors.len() as u32];
        for (place, vector) in vectors.iter().enumerate() {
            words.extend(vector.inputs.iter().chain(&vector.outputs).map(|&code| code as u32));
            words.extend([vector.idle, vector.stall]);
            let load = loads.iter().find(|(before, _)| *before == place);
            let writes = load.map_or_else(Vec::new, |(_, tables)| writes(self.design, tables));
            words.push(writes.len() as u32);
            words.extend(writes.into_iter().flatten());
        }
        let found = |word: u32| match word {
            0 => None,
            u32::MAX => Some(Detected::ByReset),
            number => Some(Detected::ByVector(number)),
        };
        Ok(self.ask(&words, count as usize)?.into_iter().map(found).collect())
    }

    /// The place of the first of all inputs, the ports' bits side by side, that detects a mutant, from `first` on.
    /// Errors: a program that does not run to its end.
    pub(crate) fn every(&self, mutant: u32, first: u64, count: u64) -> Result<Option<u64>, Error> {
        let halves = |word: u64| [word as u32, (word >> 32) as u32];
        let words = [[1, mutant].as_slice(), &halves(first), &halves(count)].concat();
        Ok(place(&self.ask(&words, 2)?))
    }

    /// The first of so many clocks with random inputs, `ce`, `in_valid` and `rst` that detects a mutant, and the last
    /// inputs that were taken until then. Errors: a program that does not run to its end.
    pub(crate) fn at_random(&self, mutant: u32, clocks: u32) -> Result<Option<AtRandom>, Error> {
        let ports = self.design.numbers(Direction::In);
        let answer = self.ask(&[2, mutant, clocks], 2 + recent(self.design) * ports.len())?;
        let code = |(&word, (_, format)): (&u32, &(&str, Format))| format.wrap(word.into()) as i64;
        let inputs = answer[2..].chunks(ports.len()).map(|words| words.iter().zip(&ports).map(code).collect());
        Ok(place(&answer).map(|clock| AtRandom { clock, recent: inputs.collect() }))
    }

    /// The program's answer of so many words.
    fn ask(&self, words: &[u32], answer: usize) -> Result<Vec<u32>, Error> {
        let question: Vec<u8> = words.iter().flat_map(|word| word.to_ne_bytes()).collect();
        let mut bytes = vec![0; 4 * answer];
        let mut whole = false;
        let output = converse(
            &mut crate::platform::tool::program(&self.program),
            |pipe| pipe.write_all(&question),
            |answer| whole = answer.read_exact(&mut bytes).is_ok(),
        )?;
        if whole && output.status.success() {
            return Ok(bytes.as_chunks::<4>().0.iter().map(|word| u32::from_ne_bytes(*word)).collect());
        }
        Err(Error::ToolFailed {
            tool: CORE.program.to_owned(),
            what: format!("no whole answer, {}", output.status),
            output: crate::platform::tool::tail(&output, 4),
        })
    }

    /// The codes of the ports at a place among all inputs.
    pub(crate) fn inputs_at(&self, place: u64) -> Vec<i64> {
        let ports = self.design.numbers(Direction::In);
        let mut rest: u32 = ports.iter().map(|(_, format)| format.width()).sum();
        let code = |(_, format): &(&str, Format)| {
            rest -= format.width();
            format.wrap(i128::from(place >> rest)) as i64
        };
        ports.iter().map(code).collect()
    }
}

/// How many of the last inputs are given.
fn recent(design: &Design) -> usize {
    design.schedule.latency as usize + BEFORE
}

/// A place in the first two words of an answer, if there is one.
fn place(answer: &[u32]) -> Option<u64> {
    let place = u64::from(answer[0]) | u64::from(answer[1]) << 32;
    (place != u64::MAX).then_some(place)
}

/// 32-bit words of the widest word that is written into a memory.
fn data_words(design: &Design) -> usize {
    let words = |port: &WritePort| design.tables()[port.memory].word_bits().div_ceil(u32::BITS) as usize;
    design.write_ports().iter().map(words).max().unwrap_or(0)
}

/// What is written to put these tables into the memories that can be written: the write port's number, the address, the
/// word.
fn writes(design: &Design, tables: &[Table]) -> Vec<Vec<u32>> {
    let mut writes = Vec::new();
    for (port, of) in design.write_ports().iter().enumerate() {
        for (address, word) in tables[of.memory].words().into_iter().enumerate() {
            let mut digits = word.to_u32_digits();
            digits.resize(data_words(design), 0);
            writes.push([vec![port as u32, address as u32], digits].concat());
        }
    }
    writes
}

/// What the harness needs to know of the core.
#[derive(Template)]
#[template(path = "cosim/mutants.h", escape = "none")]
struct Header<'a> {
    design: &'a Design,
    inputs: Vec<(&'a str, Format)>,
    outputs: Vec<(&'a str, Format)>,
    recent: usize,
    write_words: usize,
}

impl<'a> Header<'a> {
    fn of(design: &'a Design) -> Self {
        let (inputs, outputs) = (design.numbers(Direction::In), design.numbers(Direction::Out));
        Self { design, inputs, outputs, recent: recent(design), write_words: 2 + data_words(design) }
    }
}

/// How the template writes a format.
pub(super) mod filters {
    use askama::{Result, Values, filter_fn};

    use crate::fixed::Format;

    /// Its bits of a word.
    #[filter_fn]
    pub(in super::super) fn mask(format: &Format, _: &dyn Values) -> Result<String> {
        Ok(format!("{:#x}u", u32::MAX >> (32 - format.width())))
    }
}
