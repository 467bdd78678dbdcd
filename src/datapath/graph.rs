//! Operations, formats and their integer semantics.

use crate::number::Format;
use crate::rom::Table;

/// The place of a node in its graph.
pub type NodeId = usize;

/// What a node computes from its arguments' codes. Every result is taken modulo its format's width.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Op {
    /// The port `in_n`.
    Index,
    /// The port `in_cos` or `in_ver`.
    Operand,
    /// A field of the ROM word at the address (argument 0).
    Field(usize),
    /// A constant code.
    Constant(i128),
    /// Argument 0 taken into `low..=high` (codes of the argument, which are those of the result).
    Clamp {
        /// The least code.
        low: i128,
        /// The greatest code.
        high: i128,
    },
    /// The sum, with as many fraction bits as the finer argument.
    Add,
    /// The difference, with as many fraction bits as the finer argument.
    Sub,
    /// The exact product. Both arguments have the same signedness.
    Mul,
    /// Argument 0 shifted left by argument 1; the result's fraction bits say where the binary point lies.
    ShiftLeft,
    /// Argument 0 in another format: low bits dropped (towards minus infinity) or zero, high bits dropped or extended.
    Cast,
    /// The same code with the binary point elsewhere.
    Scale,
    /// 1 if argument 0 is not zero.
    NonZero,
    /// 1 if argument 0 is greater than argument 1; same format fraction bits.
    Greater,
    /// 1 if either flag is.
    Or,
    /// 0 if the flag (argument 0) is 1, else argument 1.
    ZeroIf,
}

/// An operation with its result's name and format.
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    /// What is computed.
    pub op: Op,
    /// From what.
    pub args: Vec<NodeId>,
    /// The result's format.
    pub format: Format,
    /// The result's name, unique in the graph and an identifier in both languages.
    pub name: String,
    /// The formula or the reason, for the reader of the HDL; may be empty.
    pub comment: String,
}

/// A core's operations, arguments before results.
#[derive(Clone, Debug, PartialEq)]
pub struct Graph {
    /// The nodes.
    pub nodes: Vec<Node>,
    /// The node that `out_spec` shows.
    pub output: NodeId,
}

impl Graph {
    /// The code of node `id`, given its arguments' codes.
    ///
    /// # Panics
    /// For [`Op::Index`], [`Op::Operand`] and [`Op::Field`], which have their values from elsewhere.
    #[must_use]
    pub fn apply(&self, id: NodeId, args: &[i128]) -> i128 {
        let node = &self.nodes[id];
        let frac = |arg: usize| self.nodes[node.args[arg]].format.frac_bits;
        let aligned = |arg: usize| args[arg] << (node.format.frac_bits - frac(arg));
        node.format.wrap(match node.op {
            Op::Index | Op::Operand | Op::Field(_) => panic!("{} is not computed", node.name),
            Op::Constant(code) => code,
            Op::Clamp { low, high } => args[0].clamp(low, high),
            Op::Add => aligned(0) + aligned(1),
            Op::Sub => aligned(0) - aligned(1),
            Op::Mul => args[0] * args[1],
            Op::ShiftLeft => args[0] << args[1],
            Op::Cast if node.format.frac_bits >= frac(0) => aligned(0),
            Op::Cast => args[0] >> (frac(0) - node.format.frac_bits),
            Op::Scale => args[0],
            Op::NonZero => i128::from(args[0] != 0),
            Op::Greater => i128::from(args[0] > args[1]),
            Op::Or => args[0] | args[1],
            Op::ZeroIf => {
                if args[0] == 1 {
                    0
                } else {
                    args[1]
                }
            }
        })
    }

    /// The value of every node for one input: the codes of `in_n` and of the operand port.
    #[must_use]
    pub fn values(&self, table: &Table, index: i128, operand: i128) -> Vec<i128> {
        let mut values: Vec<i128> = Vec::with_capacity(self.nodes.len());
        for (id, node) in self.nodes.iter().enumerate() {
            let value = match node.op {
                Op::Index => index,
                Op::Operand => operand,
                Op::Field(field) => table.fields[field].codes[table.row_of_address(values[node.args[0]] as usize)],
                _ => {
                    let args: Vec<i128> = node.args.iter().map(|&arg| values[arg]).collect();
                    self.apply(id, &args)
                }
            };
            values.push(value);
        }
        values
    }

    /// The node that `in_n` feeds.
    #[must_use]
    pub fn index(&self) -> NodeId {
        self.port(Op::Index)
    }

    /// The node that `in_cos` or `in_ver` feeds.
    #[must_use]
    pub fn operand(&self) -> NodeId {
        self.port(Op::Operand)
    }

    fn port(&self, op: Op) -> NodeId {
        self.nodes.iter().position(|node| node.op == op).expect("the builder makes both ports")
    }

    /// The multiplications: the widths of the two operands of each.
    #[must_use]
    pub fn multipliers(&self) -> Vec<(u32, u32)> {
        let width = |id: NodeId| self.nodes[id].format.width();
        self.nodes.iter().filter(|n| n.op == Op::Mul).map(|n| (width(n.args[0]), width(n.args[1]))).collect()
    }
}
