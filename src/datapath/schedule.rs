//! Places the pipeline registers.
//!
//! A *stage* is what lies between two registers. Every node is computed in one stage, as early as the rules allow; its
//! value crosses into later stages through one register each. The rules for `auto`: the operands of a multiplier come
//! from registers and its product goes into one; a ROM has two registers behind it (its own output register, and one
//! more because a block RAM is slow to give its output), or three where it will be a block RAM, and is read no earlier
//! than its word is wanted; and what is chained within a stage takes no longer than a multiplier, by the rough delays
//! below.

use std::str::FromStr;

use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::graph::{Graph, Node, NodeId, Op, clamped_from};
use crate::platform::error::Error;
use crate::target::{self, BLOCK_REGISTERS};

/// Pipeline depths that are allowed.
pub const PIPELINE_DEPTH: std::ops::RangeInclusive<u32> = 1..=64;

/// How many registers lie between input and output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pipeline {
    /// Registers before and after each multiplier and two behind the ROM.
    Auto,
    /// As many as this.
    Depth(u32),
}

impl std::fmt::Display for Pipeline {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Auto => write!(f, "auto"),
            Self::Depth(depth) => write!(f, "{depth}"),
        }
    }
}

impl FromStr for Pipeline {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "auto" => Ok(Self::Auto),
            depth => depth.parse().map(Self::Depth).map_err(|_| format!("`{depth}` is neither a number nor auto")),
        }
    }
}

impl Serialize for Pipeline {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Auto => serializer.serialize_str("auto"),
            Self::Depth(depth) => serializer.serialize_u32(*depth),
        }
    }
}

impl<'de> Deserialize<'de> for Pipeline {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(Deserialize)]
        #[serde(untagged, expecting = "the pipeline is a number of registers or \"auto\"")]
        enum Written {
            Depth(u32),
            Text(String),
        }
        match Written::deserialize(deserializer)? {
            Written::Depth(depth) => Ok(Self::Depth(depth)),
            Written::Text(text) => text.parse().map_err(serde::de::Error::custom),
        }
    }
}

/// The memories that lie outside of the core, and when their words come.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct External {
    /// Their places among the datapath's tables.
    pub memories: Vec<usize>,
    /// Enabled clocks from an address at the core's ports to its word at the core's ports, 1 at least.
    pub clocks: u32,
}

impl External {
    /// The registers between an address and its word in the core, for a memory that lies outside of it: those of the
    /// memory, and the one that takes the word.
    #[must_use]
    pub fn registers(&self, memory: usize) -> Option<u32> {
        self.memories.contains(&memory).then_some(self.clocks + 1)
    }
}

/// The stage of every node, and the pipeline's depth.
#[derive(Clone, Debug, PartialEq)]
pub struct Schedule {
    /// The stage in which each node is computed, from 0.
    pub stage: Vec<u32>,
    /// The last stage in which each node's value is used.
    pub last_use: Vec<u32>,
    /// The number of stages: clocks from input to output.
    pub latency: u32,
    /// The memories outside of the core.
    pub external: External,
}

/// What limits a stage.
#[derive(Clone, Copy, Debug)]
struct Rules {
    /// Registers directly behind a ROM.
    rom_registers: u32,
    /// Registers directly behind a ROM that will be a block RAM.
    block_registers: u32,
    /// Registers behind a product in front of what takes a stage by itself, where one addition is much for a stage.
    product_registers: u32,
    /// Registers between what is made far from a DSP block ([`far_from_blocks`]) and the product that takes it, the
    /// product's own included.
    far_registers: u32,
    /// The longest chain of a stage, in units of a multiplier's delay.
    period: f64,
}

/// From the fastest to the shallowest pipeline. In the fastest a product has its own register, and one near the adder.
const RULES: [Rules; 8] = [
    Rules {
        rom_registers: 2,
        block_registers: BLOCK_REGISTERS + 1,
        product_registers: 2,
        far_registers: 2,
        period: 1.0,
    },
    Rules { rom_registers: 1, block_registers: 1, product_registers: 0, far_registers: 0, period: 1.0 },
    Rules { rom_registers: 1, block_registers: 1, product_registers: 0, far_registers: 0, period: 1.5 },
    Rules { rom_registers: 1, block_registers: 1, product_registers: 0, far_registers: 0, period: 2.0 },
    Rules { rom_registers: 1, block_registers: 1, product_registers: 0, far_registers: 0, period: 3.0 },
    Rules { rom_registers: 1, block_registers: 1, product_registers: 0, far_registers: 0, period: 4.0 },
    Rules { rom_registers: 1, block_registers: 1, product_registers: 0, far_registers: 0, period: 16.0 },
    Rules { rom_registers: 0, block_registers: 0, product_registers: 0, far_registers: 0, period: f64::INFINITY },
];

impl Rules {
    /// Registers directly behind each memory: the fastest pipeline leaves a block RAM two of its own, the second
    /// because it is slow to give its output, and one between it and what may lie far from it, such as a DSP block.
    fn registers_behind(&self, graph: &Graph, memory: usize, external: &External) -> u32 {
        if let Some(registers) = external.registers(memory) {
            return registers;
        }
        let of_memory = |node: &&Node| matches!(node.op, Op::Field { memory: of, .. } if of == memory);
        let words: u32 = graph.nodes.iter().filter(of_memory).map(|node| node.format.width()).sum();
        let address = graph.nodes.iter().find(of_memory).map_or(0, |node| graph.nodes[node.args[0]].format.width());
        if target::is_block(address, words) { self.block_registers } else { self.rom_registers }
    }
}

/// How many additions may follow each other in a stage of the fastest pipeline.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Adders {
    /// One: between two DSP blocks, which are slow to give a result and to take one, two wide ones are too long.
    One,
    /// Two.
    Two,
}

/// Rough delays in units of a multiplier's, the same for every family: they rank, they do not time.
fn delay(op: Op, adders: Adders) -> f64 {
    match op {
        Op::Input | Op::Constant(_) | Op::Cast | Op::Scale => 0.0,
        Op::Mul => 1.0,
        Op::Field { .. } => 0.9,
        Op::ShiftLeft | Op::ShiftRight => 0.6,
        // Past a power of two the high bits tell; elsewhere numbers are compared.
        Op::Clamp { high, .. } if adders == Adders::One && clamped_from(high).is_none() => 0.6,
        Op::Clamp { .. } => 0.3,
        Op::Add | Op::Sub | Op::Greater => match adders {
            Adders::One => 0.75,
            Adders::Two => 0.5,
        },
        Op::NonZero => 0.2,
        // Where a whole stage may follow a product, several in a row are as long as an adder.
        Op::Select if adders == Adders::Two => 0.2,
        Op::Or | Op::ZeroIf | Op::Not | Op::Select => 0.1,
    }
}

/// Schedules a graph.
///
/// # Errors
/// Never with [`Pipeline::Auto`]; with a depth, if registers cannot be placed to give it.
pub fn schedule(graph: &Graph, pipeline: Pipeline, adders: Adders, external: &External) -> Result<Schedule, Error> {
    let ways = Ways::of(graph, adders);
    let place = |rules: Rules, extra: &[u32]| place(graph, rules, adders, &ways, extra, external);
    let no_extra = vec![0; graph.nodes.len()];
    let Pipeline::Depth(depth) = pipeline else { return Ok(place(RULES[0], &no_extra)) };
    let fits = RULES.iter().map(|&rules| place(rules, &no_extra)).find(|s| s.latency <= depth);
    let Some(fastest) = fits else {
        return Err(Error::input(format!("a pipeline of {depth} is too shallow"), "use a deeper pipeline, or auto"));
    };
    if fastest.latency == depth {
        return Ok(fastest);
    }
    let rules = RULES.into_iter().find(|&rules| place(rules, &no_extra).latency <= depth).unwrap_or(RULES[0]);
    // Registers to spare go behind the multipliers, in turn, where DSP blocks can take them in.
    let multipliers: Vec<NodeId> = (0..graph.nodes.len()).filter(|&id| graph.nodes[id].op == Op::Mul).collect();
    let mut extra = no_extra;
    let mut schedule = fastest;
    for &id in multipliers.iter().cycle().take(64 * multipliers.len()) {
        if schedule.latency == depth {
            break;
        }
        extra[id] += 1;
        let longer = place(rules, &extra);
        if longer.latency <= depth {
            schedule = longer;
        } else {
            extra[id] -= 1;
        }
    }
    // A multiplier beside the longest path cannot make it longer by one: the rest delays the output.
    schedule.latency = depth;
    for &(_, output) in &graph.outputs {
        schedule.last_use[output] = depth;
    }
    Ok(schedule)
}

/// Puts off the reading of each memory to where the first use of its word allows, if the word is wider than its
/// address: then the narrower of the two waits in registers.
fn read_late(graph: &Graph, rules: Rules, external: &External, stage: &mut [u32]) {
    let memory_of = |node: &Node| match node.op {
        Op::Field { memory, .. } => Some(memory),
        _ => None,
    };
    let mut memories: Vec<usize> = graph.nodes.iter().filter_map(memory_of).collect();
    // The last first: a word may be the address of a memory that is read behind it.
    memories.sort_unstable();
    memories.dedup();
    for memory in memories.into_iter().rev() {
        let is_read = |id: NodeId| memory_of(&graph.nodes[id]) == Some(memory);
        let reads: Vec<NodeId> = (0..graph.nodes.len()).filter(|&id| is_read(id)).collect();
        let word: u32 = reads.iter().map(|&id| graph.nodes[id].format.width()).sum();
        let address = graph.nodes[graph.nodes[reads[0]].args[0]].format.width();
        let uses = (0..graph.nodes.len()).filter(|&id| graph.nodes[id].args.iter().any(|&arg| is_read(arg)));
        let shown = reads.iter().any(|&id| graph.is_output(id));
        let Some(first) = uses.map(|id| stage[id]).min().filter(|_| word > address && !shown) else { continue };
        for id in reads {
            stage[id] = stage[id].max(first.saturating_sub(rules.registers_behind(graph, memory, external)));
        }
    }
}

/// What a value is of, but for bits that are dropped or moved.
fn origin(graph: &Graph, mut id: NodeId) -> NodeId {
    while matches!(graph.nodes[id].op, Op::Cast | Op::Scale) {
        id = graph.nodes[id].args[0];
    }
    id
}

/// What makes the way into or out of a DSP block long, by nodes.
struct Ways {
    /// What is too long for a stage that begins with a product.
    long: Vec<bool>,
    /// Values whose last cells cannot all be near a DSP block that takes them.
    far: Vec<bool>,
}

impl Ways {
    fn of(graph: &Graph, adders: Adders) -> Self {
        let long = match adders {
            Adders::One => long_behind_products(graph),
            Adders::Two => vec![false; graph.nodes.len()],
        };
        Self { long, far: far_from_blocks(graph) }
    }
}

/// The values that are shifted by a variable, or the sum of products of several blocks, or a sum or a difference of
/// such a sum.
fn far_from_blocks(graph: &Graph) -> Vec<bool> {
    let is_product = |&id: &NodeId| graph.nodes[id].op == Op::Mul;
    let mut is_sum_of_blocks = vec![false; graph.nodes.len()];
    let far = |(id, node): (NodeId, &Node)| match node.op {
        Op::ShiftLeft | Op::ShiftRight => !matches!(graph.nodes[node.args[1]].op, Op::Constant(_)),
        Op::Add | Op::Sub => {
            let from: Vec<NodeId> = node.args.iter().map(|&arg| origin(graph, arg)).collect();
            is_sum_of_blocks[id] = from.iter().all(is_product) || from.iter().any(|&arg| is_sum_of_blocks[arg]);
            is_sum_of_blocks[id]
        }
        _ => false,
    };
    graph.nodes.iter().enumerate().map(far).collect()
}

/// What is too long for a stage that begins with a product: another product and a sum that is a factor, as the way to
/// another DSP block lies before them, and a comparison, whose carry goes on to a bit that much waits for.
fn long_behind_products(graph: &Graph) -> Vec<bool> {
    let is_product = |id: NodeId| graph.nodes[origin(graph, id)].op == Op::Mul;
    let is_sum = |id: NodeId| matches!(graph.nodes[id].op, Op::Add | Op::Sub);
    let factors = graph.nodes.iter().filter(|node| node.op == Op::Mul).flat_map(|node| &node.args);
    let sums = factors.map(|&arg| origin(graph, arg)).filter(|&id| is_sum(id));
    let others = (0..graph.nodes.len()).filter(|&id| matches!(graph.nodes[id].op, Op::Mul | Op::Greater));
    let mut long = vec![false; graph.nodes.len()];
    for id in sums.chain(others) {
        long[id] = graph.nodes[id].args.iter().any(|&arg| is_product(arg));
    }
    long
}

/// As early as possible under the rules, with `extra` registers behind each node.
fn place(graph: &Graph, rules: Rules, adders: Adders, ways: &Ways, extra: &[u32], external: &External) -> Schedule {
    let count = graph.nodes.len();
    let mut stage = vec![0u32; count];
    let mut done = vec![0.0f64; count];
    for (id, node) in graph.nodes.iter().enumerate() {
        let time = delay(node.op, adders);
        // An address goes out of the core from a register.
        let out = match node.op {
            Op::Field { memory, .. } => u32::from(external.registers(memory).is_some()),
            _ => 0,
        };
        for &arg in &node.args {
            let from = &graph.nodes[arg];
            let registers = out
                + extra[arg]
                + match from.op {
                    Op::Field { memory, .. } => rules.registers_behind(graph, memory, external),
                    _ if ways.long[id] && graph.nodes[origin(graph, arg)].op == Op::Mul => rules.product_registers,
                    _ if node.op == Op::Mul && ways.far[origin(graph, arg)] => rules.far_registers,
                    _ => 0,
                };
            let ready = stage[arg] + registers;
            if ready > stage[id] {
                (stage[id], done[id]) = (ready, 0.0);
            }
            if ready == stage[id] && registers == 0 {
                done[id] = done[id].max(done[arg]);
            }
        }
        let chained = done[id] > 0.0;
        // Dropping bits costs nothing and may follow anything.
        if chained && time > 0.0 && done[id] + time > rules.period {
            (stage[id], done[id]) = (stage[id] + 1, 0.0);
        }
        done[id] += time;
    }
    read_late(graph, rules, external, &mut stage);
    let latency = graph.outputs.iter().map(|&(_, output)| stage[output] + extra[output] + 1).max().unwrap_or(1);
    let mut last_use = stage.clone();
    for (id, node) in graph.nodes.iter().enumerate() {
        for &arg in &node.args {
            last_use[arg] = last_use[arg].max(stage[id]);
        }
    }
    // Constants are the same in every stage.
    for (id, node) in graph.nodes.iter().enumerate() {
        if matches!(node.op, Op::Constant(_)) {
            last_use[id] = stage[id];
        }
    }
    for &(_, output) in &graph.outputs {
        last_use[output] = latency;
    }
    Schedule { stage, last_use, latency, external: external.clone() }
}
