//! The mutants of a core: one mistake each, such as a designer or a tool makes.

use crate::core::Design;
use crate::datapath::fault::{Change, Defect, Fault, Registered, Timing};
use crate::datapath::graph::{Graph, NodeId, Op};
use crate::datapath::schedule::Schedule;
use crate::fixed::{Format, Rng};

/// Words of each field of a memory that have a bit inverted.
const WORDS: usize = 16;

/// A core with one thing wrong in it.
#[derive(Clone, Debug)]
pub struct Mutant {
    /// What sort of mistake it stands for.
    pub kind: Kind,
    /// What is wrong, for people.
    pub what: String,
    /// The same for the simulation.
    pub defect: Defect,
}

/// Sorts of mistakes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A bit of a signal that never changes.
    StuckBit,
    /// A flag that is inverted, or a comparison that holds for equal values too.
    Flag,
    /// A result or a constant off by one.
    OffByOne,
    /// Rounding another way, or without its constant.
    Rounding,
    /// A bound of a clamp off by one.
    Clamp,
    /// Operands swapped, another operand, or another operation.
    Operand,
    /// A wrong bit in a memory, or the word beside the right one.
    Word,
    /// A pipeline register too few or too many.
    Register,
    /// A register that ignores `ce`.
    Enable,
    /// The valid chain or its reset.
    Valid,
}

impl Kind {
    /// Its name, for people.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::StuckBit => "stuck bit",
            Self::Flag => "flag",
            Self::OffByOne => "off by one",
            Self::Rounding => "rounding",
            Self::Clamp => "clamp",
            Self::Operand => "operand",
            Self::Word => "word",
            Self::Register => "register",
            Self::Enable => "enable",
            Self::Valid => "valid",
        }
    }
}

/// Every mutant of a design; `seed` says which words of a memory have an inverted bit.
#[must_use]
pub fn mutants(design: &Design, seed: u32) -> Vec<Mutant> {
    let mut list = List::of(design);
    let mut rng = Rng::new((3 << 40) + u64::from(seed));
    for (id, node) in design.graph().nodes.iter().enumerate() {
        let Op::Field { memory, .. } = node.op else { continue };
        for _ in 0..WORDS {
            let address = rng.below(design.tables()[memory].depth() as u64) as usize;
            let bit = rng.below(node.format.width().into()) as u32;
            let what = format!("bit {bit} of the word at {address} inverted");
            list.value(Kind::Word, id, what, Change::Word { address, bit });
        }
    }
    list.mutants
}

/// What is wrong with the mutants of a design that do not depend on what its memories hold.
pub(crate) fn defects(design: &Design) -> impl Iterator<Item = Defect> {
    List::of(design).mutants.into_iter().map(|mutant| mutant.defect)
}

struct List<'a> {
    graph: &'a Graph,
    schedule: &'a Schedule,
    mutants: Vec<Mutant>,
}

impl<'a> List<'a> {
    /// Those of the operations, the registers and the valid chain.
    fn of(design: &'a Design) -> Self {
        let mut list = Self { graph: design.graph(), schedule: &design.schedule, mutants: Vec::new() };
        for id in 0..list.graph.nodes.len() {
            list.bits(id);
            list.operation(id);
            list.registers(id);
        }
        list.valid_chain();
        list
    }

    fn value(&mut self, kind: Kind, node: NodeId, what: String, change: Change) {
        let what = format!("{}: {what}", self.graph.nodes[node].name);
        self.mutants.push(Mutant { kind, what, defect: Defect::Value(Fault { node, change }) });
    }

    fn timing(&mut self, kind: Kind, what: String, timing: Timing) {
        self.mutants.push(Mutant { kind, what, defect: Defect::Timing(timing) });
    }

    /// Each bit stuck; the bit of a flag inverted.
    fn bits(&mut self, id: NodeId) {
        let node = &self.graph.nodes[id];
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
        let graph = self.graph;
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
            Op::Field { .. } => {
                for by in [-1, 1] {
                    self.value(Kind::Word, id, format!("from address {by:+}"), Change::Address(by));
                }
            }
            _ => {}
        }
    }

    /// Another value of the same signedness, the nearest before an operand, that the stage of a node can read.
    fn neighbour(&self, id: NodeId, operand: NodeId) -> Option<NodeId> {
        let (graph, schedule) = (self.graph, self.schedule);
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
        let (graph, schedule) = (self.graph, self.schedule);
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
        if self.schedule.latency > 1 {
            self.timing(Kind::Valid, "rst clears only the last stage".to_owned(), Timing::ResetOfLastStage);
        }
    }
}
