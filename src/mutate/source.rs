//! Mutants of what a core is made from, simulated in this process.

use rayon::prelude::*;

use super::equivalent::{self, Decision};
use super::{Fate, Kind, Mutant};
use crate::cosim::Vectors;
use crate::datapath::fault::{Change, Defect, Fault, Registered, Timing};
use crate::datapath::graph::{NodeId, Op};
use crate::design::Design;
use crate::golden::Golden;
use crate::number::{Dice, Format};

/// Words of each field of a memory that have a bit inverted.
const WORDS: usize = 16;

/// Every mutant of a design; `seed` says which words of a memory have an inverted bit.
#[must_use]
pub fn mutants(design: &Design, seed: u64) -> Vec<Mutant> {
    let mut list = List { design, mutants: Vec::new(), dice: Dice::new((3 << 40) + seed) };
    for id in 0..design.graph().nodes.len() {
        list.bits(id);
        list.operation(id);
        list.registers(id);
    }
    list.valid_chain();
    list.mutants
}

struct List<'a> {
    design: &'a Design,
    mutants: Vec<Mutant>,
    dice: Dice,
}

impl List<'_> {
    fn value(&mut self, kind: Kind, node: NodeId, what: String, change: Change) {
        let what = format!("{}: {what}", self.design.graph().nodes[node].name);
        self.mutants.push(Mutant { kind, what, defect: Defect::Value(Fault { node, change }) });
    }

    fn timing(&mut self, kind: Kind, what: String, timing: Timing) {
        self.mutants.push(Mutant { kind, what, defect: Defect::Timing(timing) });
    }

    /// Each bit stuck; the bit of a flag inverted.
    fn bits(&mut self, id: NodeId) {
        let node = &self.design.graph().nodes[id];
        if matches!(node.op, Op::Constant(_)) {
            return;
        }
        for bit in 0..node.format.width() {
            for high in [false, true] {
                let what = format!("bit {bit} stuck at {}", u8::from(high));
                self.value(Kind::StuckBit, id, what, Change::Stuck { bit, high });
            }
        }
        if node.format == Format::FLAG {
            self.value(Kind::Flag, id, "inverted".to_owned(), Change::Flipped { bit: 0 });
        }
    }

    fn off_by_one(&mut self, id: NodeId) {
        for by in [-1, 1] {
            self.value(Kind::OffByOne, id, format!("{by:+} ulp"), Change::Offset(by));
        }
    }

    fn instead(&mut self, kind: Kind, id: NodeId, what: &str, op: Op, args: Vec<NodeId>) {
        self.value(kind, id, what.to_owned(), Change::Instead { op, args });
    }

    /// What can be wrong with an operation.
    fn operation(&mut self, id: NodeId) {
        let graph = self.design.graph();
        let node = &graph.nodes[id];
        let (op, args) = (node.op, node.args.clone());
        let drops_bits = match op {
            Op::ShiftRight => true,
            Op::Cast => graph.nodes[args[0]].format.frac_bits > node.format.frac_bits,
            _ => false,
        };
        if drops_bits {
            self.value(Kind::Rounding, id, "rounded to nearest".to_owned(), Change::Nearest);
            self.value(Kind::Rounding, id, "rounded up".to_owned(), Change::Up);
        }
        match op {
            Op::Constant(code) => {
                self.off_by_one(id);
                if code != 0 {
                    self.instead(Kind::Rounding, id, "left out", Op::Constant(0), Vec::new());
                }
            }
            Op::Clamp { low, high } => {
                let bounds = [(low - 1, high), (low + 1, high), (low, high - 1), (low, high + 1)];
                for (to, what) in bounds.into_iter().zip(["low -1", "low +1", "high -1", "high +1"]) {
                    self.instead(Kind::Clamp, id, what, Op::Clamp { low: to.0, high: to.1 }, args.clone());
                }
            }
            Op::Add | Op::Sub => {
                self.off_by_one(id);
                let other = if op == Op::Add { Op::Sub } else { Op::Add };
                self.instead(Kind::Operand, id, "sum for difference", other, args.clone());
                if op == Op::Sub {
                    self.instead(Kind::Operand, id, "swapped", Op::Sub, vec![args[1], args[0]]);
                }
            }
            Op::Mul => {
                self.off_by_one(id);
                for place in 0..2 {
                    if let Some(neighbour) = self.neighbour(id, args[place]) {
                        let mut args = args.clone();
                        args[place] = neighbour;
                        let what = format!("times {}", graph.nodes[neighbour].name);
                        self.instead(Kind::Operand, id, &what, Op::Mul, args);
                    }
                }
            }
            Op::Cast | Op::Scale | Op::ShiftLeft | Op::ShiftRight if node.format.width() > 1 => self.off_by_one(id),
            Op::Greater => {
                self.value(Kind::Flag, id, ">= for >".to_owned(), Change::OrEqual);
                self.instead(Kind::Operand, id, "swapped", op, vec![args[1], args[0]]);
            }
            Op::Select => self.instead(Kind::Operand, id, "swapped", op, vec![args[0], args[2], args[1]]),
            Op::ZeroIf => self.instead(Kind::Operand, id, "never 0", Op::Scale, vec![args[1]]),
            Op::Field { memory, field } => {
                for by in [-1, 1] {
                    self.value(Kind::Word, id, format!("from address {by:+}"), Change::Address(by));
                }
                let table = &self.design.tables()[memory];
                let (depth, bits) = (table.depth() as u64, u64::from(table.fields[field].format.width()));
                for _ in 0..WORDS {
                    let (address, bit) = (self.dice.below(depth) as usize, self.dice.below(bits) as u32);
                    let what = format!("bit {bit} of the word at {address} inverted");
                    self.value(Kind::Word, id, what, Change::Word { address, bit });
                }
            }
            _ => {}
        }
    }

    /// Another value of the same signedness, the nearest before an operand, that the stage of a node can read.
    fn neighbour(&self, id: NodeId, operand: NodeId) -> Option<NodeId> {
        let (graph, schedule) = (self.design.graph(), &self.design.schedule);
        let readable = |&other: &NodeId| {
            let node = &graph.nodes[other];
            !matches!(node.op, Op::Constant(_))
                && !graph.nodes[id].args.contains(&other)
                && node.format.signed == graph.nodes[operand].format.signed
                && (schedule.stage[other]..=schedule.last_use[other]).contains(&schedule.stage[id])
        };
        (0..operand).rev().find(readable)
    }

    /// Each pipeline register of a node.
    fn registers(&mut self, node: NodeId) {
        let (graph, schedule) = (self.design.graph(), &self.design.schedule);
        let name = &graph.nodes[node].name;
        for register in 0..(schedule.last_use[node] - schedule.stage[node]) as usize {
            let stage = schedule.stage[node] as usize + register + 1;
            for (kind, what, text) in [
                (Kind::Register, Registered::Missing, "left out"),
                (Kind::Register, Registered::Doubled, "doubled"),
                (Kind::Enable, Registered::FreeRunning, "without ce"),
            ] {
                let what = Timing::Register { node, register, what };
                self.timing(kind, format!("register {name}_{stage} {text}"), what);
            }
        }
    }

    fn valid_chain(&mut self) {
        for (timing, what) in [
            (Timing::ValidFreeRunning, "valid chain without ce"),
            (Timing::ValidEarly, "valid chain a stage short"),
            (Timing::ValidLate, "valid chain a stage long"),
            (Timing::ValidInverted, "out_valid inverted"),
            (Timing::ValidAlways, "in_valid ignored"),
            (Timing::ResetIgnored, "rst ignored"),
            (Timing::ResetNeedsEnable, "rst only with ce"),
        ] {
            self.timing(Kind::Valid, what.to_owned(), timing);
        }
        if self.design.schedule.latency > 1 {
            self.timing(Kind::Valid, "rst clears only the last stage".to_owned(), Timing::ResetOfLastStage);
        }
    }
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
