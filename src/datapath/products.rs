//! Wide products built of DSP blocks.
//!
//! A product that no block holds is a sum of products that one holds each: with `a = a_1 2^k + a_0`, `0 <= a_0 < 2^k`,
//! `a b = a_0 b + a_1 b 2^k` exactly, and likewise for the parts of `b`. Of a square the two mixed products are one,
//! doubled. Tools build the same sum of a wide multiplication by themselves, but without registers between the blocks
//! and the adders; as operations of the graph the parts get theirs from the [`schedule`](super::schedule).

use std::collections::HashMap;
use std::str::FromStr;

use clap::ValueEnum;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::graph::{Graph, Node, NodeId, Op};
use super::schedule::Schedule;
use crate::fixed::Format;
use crate::target::{Dsp, Family};

/// What wide products are built of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DspBlocks {
    /// The DSP blocks of a family.
    Of(Family),
    /// Nothing: each is one multiplication in the HDL, whatever its width.
    Whole,
}

impl DspBlocks {
    const WHOLE: &'static str = "none";

    /// The graph with its wide products built of these, and the wide products.
    #[must_use]
    pub fn built(self, graph: &Graph) -> (Graph, Vec<WideProduct>) {
        match self {
            Self::Of(family) => of_blocks(graph, &family.dsp),
            Self::Whole => (graph.clone(), Vec::new()),
        }
    }
}

impl Default for DspBlocks {
    /// Those of the family that is meant where none is named.
    fn default() -> Self {
        Self::Of(Family::default())
    }
}

impl std::fmt::Display for DspBlocks {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Of(family) => family.name,
            Self::Whole => Self::WHOLE,
        })
    }
}

impl FromStr for DspBlocks {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match Family::from_str(text, false) {
            Ok(family) => Ok(Self::Of(family)),
            Err(_) if text == Self::WHOLE => Ok(Self::Whole),
            Err(_) => {
                let names = Family::names(|_| true).join(", ");
                Err(format!("`{text}` is neither a family ({names}) nor {}", Self::WHOLE))
            }
        }
    }
}

impl Serialize for DspBlocks {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for DspBlocks {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        String::deserialize(deserializer)?.parse().map_err(serde::de::Error::custom)
    }
}

/// A product that is built of several.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WideProduct {
    /// Its node: the last sum.
    pub node: NodeId,
    /// The widths of its operands.
    pub operands: [u32; 2],
    /// The products that it is built of.
    pub parts: Vec<NodeId>,
}

impl WideProduct {
    /// The widths of the operands of each part.
    pub fn parts(&self, graph: &Graph) -> impl Iterator<Item = [u32; 2]> {
        let width = |id: NodeId| graph.nodes[id].format.width();
        self.parts.iter().map(move |&part| [0, 1].map(|place| width(graph.nodes[part].args[place])))
    }

    /// Clocks from the operands to the sum, of which the parts take the first.
    #[must_use]
    pub fn clocks(&self, schedule: &Schedule) -> u32 {
        let first = self.parts.iter().map(|&part| schedule.stage[part]).min().unwrap_or_default();
        schedule.stage[self.node] - first + 1
    }
}

/// The graph with each product that no block holds built of some that do, and these products.
#[must_use]
pub fn of_blocks(graph: &Graph, dsp: &Dsp) -> (Graph, Vec<WideProduct>) {
    let mut blocks = Blocks { dsp, nodes: Vec::new(), halves: HashMap::new(), parts: Vec::new() };
    let mut place: Vec<NodeId> = Vec::new();
    let mut wide = Vec::new();
    for node in &graph.nodes {
        let args: Vec<NodeId> = node.args.iter().map(|&arg| place[arg]).collect();
        let id = match (node.op, &args[..]) {
            (Op::Mul, &[a, b]) => {
                blocks.parts.clear();
                let id = blocks.product([a, b], node);
                if blocks.parts.len() > 1 {
                    let operands = [a, b].map(|id| blocks.width(id));
                    wide.push(WideProduct { node: id, operands, parts: blocks.parts.clone() });
                }
                id
            }
            _ => blocks.push(Node { args, ..node.clone() }),
        };
        place.push(id);
    }
    let inputs = graph.inputs.iter().map(|&id| place[id]).collect();
    let outputs = graph.outputs.iter().map(|(name, id)| (name.clone(), place[*id])).collect();
    (Graph { nodes: blocks.nodes, inputs, outputs }, wide)
}

/// Builds products of blocks.
struct Blocks<'d> {
    dsp: &'d Dsp,
    nodes: Vec<Node>,
    /// The low bits of a node, so many, and the others.
    halves: HashMap<(NodeId, u32), [NodeId; 2]>,
    /// The products that the present one is built of.
    parts: Vec<NodeId>,
}

impl Blocks<'_> {
    fn push(&mut self, node: Node) -> NodeId {
        self.nodes.push(node);
        self.nodes.len() - 1
    }

    fn width(&self, id: NodeId) -> u32 {
        self.nodes[id].format.width()
    }

    /// The product of two nodes, with the format, the name and the comment of `wide`.
    fn product(&mut self, [a, b]: [NodeId; 2], wide: &Node) -> NodeId {
        let signed = wide.format.signed;
        let [most, least] = self.dsp.operands(signed);
        let ways = [[most, least], [least, most]];
        let widths = [a, b].map(|id| self.width(id));
        let count = |limits: &[u32; 2]| parts(widths[0], limits[0], signed) * parts(widths[1], limits[1], signed);
        let limits = if count(&ways[1]) < count(&ways[0]) { ways[1] } else { ways[0] };
        if a == b && parts_of_square(widths[0], least, signed) < count(&limits) {
            self.square(a, least, wide, 0)
        } else {
            self.built([a, b], limits, wide, 0)
        }
    }

    /// A product of operands that are split into parts of so many bits; itself a part of a part ... of one, `depth`
    /// times.
    fn built(&mut self, [a, b]: [NodeId; 2], limits: [u32; 2], wide: &Node, depth: u32) -> NodeId {
        let Some(place) = (0..2).find(|&place| self.width([a, b][place]) > limits[place]) else {
            let part = self.push(Node { op: Op::Mul, args: vec![a, b], ..wide.clone() });
            self.parts.push(part);
            return part;
        };
        let split = [a, b][place];
        let halves = self.halves(split, limits[place]);
        let with = |half: NodeId| if place == 0 { [half, b] } else { [a, half] };
        let [low, high] = [(halves[0], "low"), (halves[1], "high")].map(|(half, which)| {
            let part = self.part(with(half), wide, which, depth);
            self.built(with(half), limits, &part, depth + 1)
        });
        self.push(Node { op: Op::Add, args: vec![low, high], ..wide.clone() })
    }

    /// The square of a node that is split into parts of so many bits.
    fn square(&mut self, a: NodeId, limit: u32, wide: &Node, depth: u32) -> NodeId {
        if self.width(a) <= limit {
            return self.built([a, a], [limit; 2], wide, depth);
        }
        let [low, high] = self.halves(a, limit);
        let part = self.part([low, low], wide, "low", depth);
        let lows = self.built([low, low], [limit; 2], &part, depth + 1);
        let part = self.part([low, high], wide, "mixed", depth);
        let mixed = self.built([low, high], [limit; 2], &part, depth + 1);
        let part = self.part([high, high], wide, "high", depth);
        let highs = self.square(high, limit, &part, depth + 1);
        let format = self.nodes[mixed].format;
        let doubled = self.push(Node {
            op: Op::Scale,
            args: vec![mixed],
            format: Format { int_bits: format.int_bits + 1, frac_bits: format.frac_bits - 1, ..format },
            name: format!("{}_twice", wide.name),
            comment: "both mixed products".to_owned(),
        });
        let ends = self.push(Node {
            op: Op::Add,
            args: vec![lows, highs],
            format: Format::product([self.nodes[a].format; 2]),
            name: format!("{}_ends", wide.name),
            comment: "the squares of both parts".to_owned(),
        });
        self.push(Node { op: Op::Add, args: vec![ends, doubled], ..wide.clone() })
    }

    /// A part of a product, of these operands: what it is called, and its format. Of parts of parts the names have
    /// first letters only, lest lines become long.
    fn part(&self, operands: [NodeId; 2], wide: &Node, which: &str, depth: u32) -> Node {
        let name = match depth {
            0 => format!("{}_{which}", wide.name),
            1 => format!("{}_{}", wide.name, &which[..1]),
            _ => format!("{}{}", wide.name, &which[..1]),
        };
        Node {
            op: Op::Mul,
            args: Vec::new(),
            format: Format::product(operands.map(|id| self.nodes[id].format)),
            name,
            comment: format!("part of {}", wide.name),
        }
    }

    /// The low bits of a node that fit an operand of so many bits, and the others. Of a signed one the low bits have
    /// a sign, too, which is 0.
    fn halves(&mut self, id: NodeId, limit: u32) -> [NodeId; 2] {
        let Node { op, format, name, .. } = self.nodes[id].clone();
        let bits = limit - u32::from(format.signed);
        if let Some(&halves) = self.halves.get(&(id, bits)) {
            return halves;
        }
        let low_format = Format { signed: false, int_bits: bits as i32 - format.frac_bits, ..format };
        let signed = Format { signed: format.signed, ..low_format };
        let high_format = Format { frac_bits: format.frac_bits - bits as i32, ..format };
        let low_name = format!("{name}_low");
        let high_name = format!("{name}_high");
        let low_comment = format!("the {bits} low bits of {name}");
        let high_comment = format!("{name} without its {bits} low bits");
        let mut part = |op: Op, args: Vec<NodeId>, format: Format, name: String, comment: String| {
            self.push(Node { op, args, format, name, comment })
        };
        let [low, high] = if let Op::Constant(code) = op {
            // Constants have no bits that could be taken in the HDL.
            [
                part(Op::Constant(low_format.wrap(code)), Vec::new(), signed, low_name, low_comment),
                part(Op::Constant(code >> bits), Vec::new(), high_format, high_name, high_comment),
            ]
        } else {
            let mut low = part(Op::Cast, vec![id], low_format, low_name.clone(), low_comment);
            if format.signed {
                low = part(Op::Cast, vec![low], signed, low_name + "_signed", "with a sign of 0".to_owned());
            }
            [low, part(Op::Cast, vec![id], high_format, high_name, high_comment)]
        };
        self.halves.insert((id, bits), [low, high]);
        [low, high]
    }
}

/// The parts of an operand, none of more than so many bits.
fn parts(width: u32, limit: u32, signed: bool) -> u32 {
    let sign = u32::from(signed);
    if width <= limit { 1 } else { (width - sign).div_ceil(limit - sign) }
}

/// The products that a square is built of.
fn parts_of_square(width: u32, limit: u32, signed: bool) -> u32 {
    if width <= limit {
        return 1;
    }
    let rest = width - (limit - u32::from(signed));
    1 + parts(rest, limit, signed) + parts_of_square(rest, limit, signed)
}
