//! What can be wrong with a core, in terms of its graph and its pipeline: what both simulations of these can have
//! injected.
//!
//! A [`Fault`] changes the function of one operation: any simulation shows it. A [`Timing`] changes a pipeline register
//! or the valid chain: only the [simulation](super::simulate) clock by clock shows it. Both are a [`Defect`]. Which
//! there are, and what becomes of them, is the business of what checks a core.

use super::evaluate::Lane;
use super::graph::{Graph, Node, NodeId, Op};

/// What a fault does to the value of a node. Every result is taken modulo the width of the node's format.
#[derive(Clone, Debug, PartialEq)]
pub enum Change {
    /// A bit, from 0 for the least significant, that is always 0 or always 1.
    Stuck {
        /// Which bit.
        bit: u32,
        /// Always 1.
        high: bool,
    },
    /// A bit that is inverted.
    Flipped {
        /// Which bit.
        bit: u32,
    },
    /// So many codes more.
    Offset(i128),
    /// Bits dropped by a cast or a shift to the right round to the nearest code, halves up, in place of down.
    Nearest,
    /// Bits dropped by a cast or a shift to the right round up.
    Up,
    /// A comparison that holds for equal arguments too.
    OrEqual,
    /// Another operation on other arguments, which come before the node; the format stays.
    Instead {
        /// The operation.
        op: Op,
        /// The arguments.
        args: Vec<NodeId>,
    },
    /// A field of a memory read so many words further on, past the last word from the first again.
    Address(i64),
    /// A bit of a field's word at one address that is inverted when the memory comes up.
    Word {
        /// The address.
        address: usize,
        /// Which bit of the field.
        bit: u32,
    },
}

impl Change {
    /// Always the same code.
    #[must_use]
    pub fn constant(code: i128) -> Self {
        Self::Instead { op: Op::Constant(code), args: Vec::new() }
    }
}

/// A change of one operation.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// The node whose value is changed.
    pub node: NodeId,
    /// How.
    pub change: Change,
}

impl Fault {
    /// The node's operation and arguments with the fault in it.
    pub(crate) fn operation(&self, graph: &Graph) -> Node {
        let node = &graph.nodes[self.node];
        match &self.change {
            Change::Instead { op, args } => Node { op: *op, args: args.clone(), ..node.clone() },
            _ => node.clone(),
        }
    }

    /// How many words further on the node reads.
    pub(crate) fn words_on(&self) -> i64 {
        if let Change::Address(by) = self.change { by } else { 0 }
    }

    /// The node's code, given the code that its operation gives for the arguments' codes.
    pub(super) fn code(&self, graph: &Graph, args: &[i128], right: i128) -> i128 {
        let node = &graph.nodes[self.node];
        let mut result = [right];
        alter(&self.change, graph, node, |arg| &args[arg..=arg], &mut result);
        node.format.wrap(result[0])
    }
}

/// The bits that a cast or a shift by `amount` drops.
fn dropped<L: Lane>(graph: &Graph, node: &Node, amount: Option<L>) -> usize {
    let bits = match amount {
        Some(amount) => i64::from(amount.to_output()),
        None => i64::from(graph.nodes[node.args[0]].format.frac_bits - node.format.frac_bits),
    };
    bits.clamp(0, i64::from(2 * L::HALF) - 2) as usize
}

/// Changes values in place; [`Change::Instead`] and [`Change::Address`] are not done here but in place of the
/// operation.
#[inline(always)]
pub(crate) fn alter<'a, L: Lane + 'a>(
    change: &Change,
    graph: &Graph,
    node: &Node,
    arg: impl Fn(usize) -> &'a [L],
    result: &mut [L],
) {
    match change {
        Change::Stuck { bit, high } => {
            let mask = L::one() << *bit as usize;
            for value in result {
                *value = if *high { *value | mask } else { *value & !mask };
            }
        }
        Change::Flipped { bit } => {
            let mask = L::one() << *bit as usize;
            for value in result {
                *value = *value ^ mask;
            }
        }
        Change::Offset(by) => {
            let by = L::from_code(*by);
            for value in result {
                *value = value.wrapping_add(&by);
            }
        }
        Change::Nearest | Change::Up => {
            let shifts = matches!(node.op, Op::ShiftRight).then(|| arg(1));
            for (lane, (value, &from)) in result.iter_mut().zip(arg(0)).enumerate() {
                let bits = dropped(graph, node, shifts.map(|shifts| shifts[lane]));
                let rest = from & ((L::one() << bits).wrapping_sub(&L::one()));
                let up = match change {
                    Change::Up => rest != L::zero(),
                    _ => bits > 0 && rest >> (bits - 1) != L::zero(),
                };
                *value = if up { value.wrapping_add(&L::one()) } else { *value };
            }
        }
        Change::OrEqual => {
            for ((value, a), b) in result.iter_mut().zip(arg(0)).zip(arg(1)) {
                *value = if a == b { L::one() } else { *value };
            }
        }
        Change::Word { address, bit } => {
            let mask = L::one() << *bit as usize;
            for (value, at) in result.iter_mut().zip(arg(0)) {
                *value = if at.to_code() as usize == *address { *value ^ mask } else { *value };
            }
        }
        Change::Address(_) | Change::Instead { .. } => {}
    }
}

/// A change of a node's pipeline register; the registers count from 0 at the end of the stage in which the node is
/// computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Registered {
    /// It is left out: whoever reads its output or a later register's has the value a clock early.
    Missing,
    /// There is one more behind it: whoever reads its output or a later register's has the value a clock late.
    Doubled,
    /// It takes its input at every clock, whatever `ce` is.
    FreeRunning,
}

/// A change that only time shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Timing {
    /// Of a pipeline register.
    Register {
        /// The node whose value it holds.
        node: NodeId,
        /// Which of its registers.
        register: usize,
        /// How.
        what: Registered,
    },
    /// The valid chain takes `in_valid` at every clock, whatever `ce` is.
    ValidFreeRunning,
    /// `out_valid` comes a clock early.
    ValidEarly,
    /// `out_valid` comes a clock late.
    ValidLate,
    /// `out_valid` is inverted.
    ValidInverted,
    /// The valid chain takes 1, whatever `in_valid` is.
    ValidAlways,
    /// The reset does nothing.
    ResetIgnored,
    /// The reset acts only while `ce` is 1.
    ResetNeedsEnable,
    /// The reset clears only the last stage of the valid chain.
    ResetOfLastStage,
}

/// Something wrong with a core.
#[derive(Clone, Debug, PartialEq)]
pub enum Defect {
    /// With what it computes.
    Value(Fault),
    /// With when.
    Timing(Timing),
}

impl Defect {
    /// What is wrong with what it computes, if that is it.
    #[must_use]
    pub fn fault(&self) -> Option<&Fault> {
        if let Self::Value(fault) = self { Some(fault) } else { None }
    }
}
