//! Operations, formats and their integer semantics.

use crate::fixed::{Format, Table};

/// The place of a node in its graph.
pub type NodeId = usize;

/// What a node computes from its arguments' codes. Every result is taken modulo its format's width.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Op {
    /// An input port, which has the node's name.
    Input,
    /// A field of a memory's word at the address (argument 0). All fields of a memory are read at one address.
    Field {
        /// The memory's place among the datapath's tables.
        memory: usize,
        /// The field's place in its table.
        field: usize,
    },
    /// A constant code.
    Constant(i128),
    /// Argument 0 clamped to `low..=high` (codes of the argument, which are those of the result).
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
    /// Argument 0 shifted right by argument 1, towards minus infinity; fraction bits as argument 0.
    ShiftRight,
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
    /// 1 if the flag is 0.
    Not,
    /// Argument 1 if the flag (argument 0) is 1, else argument 2; all of one format.
    Select,
    /// 0 if the flag (argument 0) is 1, else argument 1.
    ZeroIf,
}

/// The power of two from which on numbers are clamped to `high`, if there is one: their high bits tell.
pub(crate) fn clamped_from(high: i128) -> Option<i128> {
    [high, high + 1].into_iter().find(|power| power.count_ones() == 1)
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
    /// The result's name, an identifier in both languages; [`crate::core::Layout`] tells two of one name apart.
    pub name: String,
    /// The formula or the reason, for the reader of the HDL; may be empty.
    pub comment: String,
}

/// A core's operations, arguments before results.
#[derive(Clone, Debug, PartialEq)]
pub struct Graph {
    /// The nodes.
    pub nodes: Vec<Node>,
    /// The input ports, in the order of their declaration. A lobe's are `in_n` and the operand.
    pub inputs: Vec<NodeId>,
    /// The output ports, in the order of their declaration: a name and the node that the port shows. A lobe's is
    /// `out_spec`.
    pub outputs: Vec<(String, NodeId)>,
}

impl Graph {
    /// The code of node `id`, given its arguments' codes.
    ///
    /// # Panics
    /// For [`Op::Input`] and [`Op::Field`], which have their values from elsewhere.
    #[must_use]
    pub fn apply(&self, id: NodeId, args: &[i128]) -> i128 {
        self.apply_node(&self.nodes[id], args)
    }

    /// The code of a node that may be another than the graph's own at its place, given its arguments' codes.
    ///
    /// # Panics
    /// As [`Graph::apply`].
    #[must_use]
    pub fn apply_node(&self, node: &Node, args: &[i128]) -> i128 {
        let frac = |arg: usize| self.nodes[node.args[arg]].format.frac_bits;
        let aligned = |arg: usize| args[arg] << (node.format.frac_bits - frac(arg));
        node.format.wrap(match node.op {
            Op::Input | Op::Field { .. } => panic!("{} is not computed", node.name),
            Op::Constant(code) => code,
            Op::Clamp { low, high } => args[0].clamp(low, high),
            Op::Add => aligned(0) + aligned(1),
            Op::Sub => aligned(0) - aligned(1),
            // What a fault makes longer than any format keeps its low bits.
            Op::Mul => args[0].wrapping_mul(args[1]),
            Op::ShiftLeft => args[0].checked_shl(args[1] as u32).unwrap_or_default(),
            Op::ShiftRight => args[0] >> args[1].min(127),
            Op::Cast if node.format.frac_bits >= frac(0) => aligned(0),
            Op::Cast => args[0] >> (frac(0) - node.format.frac_bits),
            Op::Scale => args[0],
            Op::NonZero => i128::from(args[0] != 0),
            Op::Greater => i128::from(args[0] > args[1]),
            Op::Or => args[0] | args[1],
            Op::Not => 1 - args[0],
            Op::Select => args[if args[0] == 1 { 1 } else { 2 }],
            Op::ZeroIf => (1 - args[0]) * args[1],
        })
    }

    /// The value of every node for the codes of the input ports, in their order.
    #[must_use]
    pub fn values(&self, tables: &[Table], inputs: &[i128]) -> Vec<i128> {
        let mut values: Vec<i128> = Vec::with_capacity(self.nodes.len());
        for (id, node) in self.nodes.iter().enumerate() {
            let value = match node.op {
                Op::Input => inputs[self.port(id)],
                Op::Field { memory, field } => tables[memory].code_at(field, values[node.args[0]] as usize),
                _ => {
                    let args: Vec<i128> = node.args.iter().map(|&arg| values[arg]).collect();
                    self.apply(id, &args)
                }
            };
            values.push(value);
        }
        values
    }

    /// The place of an input node among the input ports.
    ///
    /// # Panics
    /// If the node is no input.
    #[must_use]
    pub fn port(&self, id: NodeId) -> usize {
        self.inputs.iter().position(|&input| input == id).expect("every input node is a port")
    }

    /// The codes at the output ports for codes at the input ports, with these memories.
    #[must_use]
    pub fn results(&self, tables: &[Table], codes: &[i64]) -> Vec<i64> {
        let inputs: Vec<i128> = codes.iter().copied().map(i128::from).collect();
        let values = self.values(tables, &inputs);
        self.outputs.iter().map(|&(_, id)| values[id] as i64).collect()
    }

    /// The node of a lobe's `in_n`.
    #[must_use]
    pub fn index(&self) -> NodeId {
        self.inputs[0]
    }

    /// The node of a lobe's `in_cos` or `in_ver`.
    #[must_use]
    pub fn operand(&self) -> NodeId {
        self.inputs[1]
    }

    /// The node of the first output port: a lobe's `out_spec`.
    #[must_use]
    pub fn output(&self) -> NodeId {
        self.outputs[0].1
    }

    /// Whether an output port shows the node.
    #[must_use]
    pub fn is_output(&self, id: NodeId) -> bool {
        self.outputs.iter().any(|&(_, node)| node == id)
    }

    /// The graph with a copy of a node, which those read in its place that `reads_copy` says, and the outputs; and the
    /// copy. Nodes behind the first move one further.
    #[must_use]
    pub fn with_copy(&self, node: NodeId, reads_copy: impl Fn(NodeId) -> bool) -> (Self, NodeId) {
        let copy = node + 1;
        let moved = |id: NodeId| if id > node { id + 1 } else { id };
        let mut nodes: Vec<Node> = Vec::new();
        for (id, old) in self.nodes.iter().enumerate() {
            let arg = |&arg: &NodeId| if arg == node && reads_copy(id) { copy } else { moved(arg) };
            nodes.push(Node { args: old.args.iter().map(arg).collect(), ..old.clone() });
            if id == node {
                nodes.push(Node { op: Op::Scale, args: vec![node], name: format!("{}_late", old.name), ..old.clone() });
            }
        }
        let output = |(name, id): &(String, NodeId)| (name.clone(), if *id == node { copy } else { moved(*id) });
        let outputs = self.outputs.iter().map(output).collect();
        (Self { nodes, inputs: self.inputs.iter().map(|&id| moved(id)).collect(), outputs }, copy)
    }

    /// The multiplications: the widths of the two operands of each.
    #[must_use]
    pub fn multipliers(&self) -> Vec<(u32, u32)> {
        let width = |id: NodeId| self.nodes[id].format.width();
        self.nodes.iter().filter(|n| n.op == Op::Mul).map(|n| (width(n.args[0]), width(n.args[1]))).collect()
    }
}
