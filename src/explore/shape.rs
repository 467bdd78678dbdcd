//! What a core is made of, before synthesis: the sizes of its operations, as its graph gives them.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use crate::core::Design;
use crate::datapath::graph::{Graph, NodeId, Op};
use crate::platform::as_text;

/// The sizes of a core's operations.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Shape {
    /// The multiplications.
    pub multipliers: Vec<Multiplier>,
    /// The memories that are read.
    pub memories: Vec<MemorySize>,
    /// The bits of all sums, differences and comparisons.
    pub adder_bits: u32,
    /// The bits of all results that are chosen: selected (but those that are the same either way), zeroed, clamped
    /// (twice: at either end), tested for zero.
    pub mux_bits: u32,
    /// The bits of all results that are shifted by a variable, each times the bits of its shift.
    pub shift_bits: u32,
    /// The bits of all registers.
    pub register_bits: u32,
}

/// A multiplication, written `17x18`, or `17x18s` of signed numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Multiplier {
    /// The width of the wider operand.
    pub wide: u32,
    /// The width of the other.
    pub narrow: u32,
    /// Whether both are signed; else neither is.
    pub signed: bool,
}

/// A memory, written `1024x24`, or `1024x24r` where there is a register behind it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MemorySize {
    /// The number of words.
    pub depth: u32,
    /// The bits of a word.
    pub word: u32,
    /// Whether its output goes into a register, as that of a block RAM must.
    pub registered: bool,
}

impl Shape {
    /// The shape of a core.
    #[must_use]
    pub fn of(design: &Design) -> Self {
        let graph = design.graph();
        let layout = design.layout();
        let mut shape = Self { register_bits: design.register_bits(), ..Self::default() };
        for node in &graph.nodes {
            let width = node.format.width();
            let arg = |index: usize| graph.nodes[node.args[index]].format;
            let constant = |index: usize| matches!(graph.nodes[node.args[index]].op, Op::Constant(_));
            match node.op {
                Op::Add | Op::Sub => shape.adder_bits += width,
                Op::Greater => shape.adder_bits += arg(0).width().max(arg(1).width()),
                Op::Clamp { .. } => shape.mux_bits += 2 * width,
                Op::ZeroIf => shape.mux_bits += width,
                Op::Select => {
                    // A bit that comes from the same place either way is a wire.
                    let chosen = |bit: &u32| source(graph, node.args[1], *bit) != source(graph, node.args[2], *bit);
                    shape.mux_bits += (0..width).filter(chosen).count() as u32;
                }
                Op::NonZero => shape.mux_bits += arg(0).width(),
                Op::ShiftLeft | Op::ShiftRight if !constant(1) => shape.shift_bits += width * arg(1).width(),
                Op::Mul => {
                    let (a, b) = (arg(0).width(), arg(1).width());
                    shape.multipliers.push(Multiplier { wide: a.max(b), narrow: a.min(b), signed: arg(0).signed });
                }
                _ => {}
            }
        }
        for (memory, table) in design.tables().iter().enumerate() {
            let is_own = design.schedule.external.registers(memory).is_none();
            if let Some(read) = layout.read(memory).filter(|_| is_own) {
                let (depth, word, registered) = (table.depth() as u32, table.word_bits(), read.registers > 0);
                let depth = depth * if table.holds_data() { design.texel_sets() } else { 1 };
                shape.memories.push(MemorySize { depth, word, registered });
            }
        }
        shape
    }
}

/// Where a bit of an unsigned node, counted from its last, comes from through formats that are changed: a node and its
/// bit, or nothing where it is always 0. Bits of signed nodes are their own.
fn source(graph: &Graph, id: NodeId, bit: u32) -> Option<(NodeId, u32)> {
    let node = &graph.nodes[id];
    if node.format.signed || !matches!(node.op, Op::Cast | Op::Scale) {
        return Some((id, bit));
    }
    let of = graph.nodes[node.args[0]].format;
    if of.signed {
        return Some((id, bit));
    }
    let moved = if node.op == Op::Cast { of.frac_bits - node.format.frac_bits } else { 0 };
    let bit = bit as i32 + moved;
    if !(0..of.width() as i32).contains(&bit) {
        return None;
    }
    source(graph, node.args[0], bit as u32)
}

impl fmt::Display for Multiplier {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}x{}{}", self.wide, self.narrow, if self.signed { "s" } else { "" })
    }
}

impl fmt::Display for MemorySize {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}x{}{}", self.depth, self.word, if self.registered { "r" } else { "" })
    }
}

/// Two numbers with an `x` between, and whether the mark is behind them.
fn sizes(text: &str, mark: char) -> Result<(u32, u32, bool), String> {
    let bare = text.strip_suffix(mark);
    let parts = bare.unwrap_or(text).split_once('x').and_then(|(a, b)| Some((a.parse().ok()?, b.parse().ok()?)));
    let (a, b) = parts.ok_or_else(|| format!("`{text}` is no size, such as 18x17"))?;
    Ok((a, b, bare.is_some()))
}

impl FromStr for Multiplier {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (a, b, signed) = sizes(text, 's')?;
        Ok(Self { wide: a.max(b), narrow: a.min(b), signed })
    }
}

impl FromStr for MemorySize {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (depth, word, registered) = sizes(text, 'r')?;
        Ok(Self { depth, word, registered })
    }
}

as_text!(Multiplier);
as_text!(MemorySize);
