//! Builds a graph and bounds every value's range and error, row by row.
//!
//! The analysis is an abstract interpretation with intervals. It goes case by case: a case is a row of the coefficient
//! ROM, or a part of one, such as a segment. For every case it follows, next to the range of each hardware value, the
//! interval of its *error*: the hardware value minus the real value that the formula with the quantised coefficients
//! has there. Sums add errors, a product obeys `a'b' - ab = a (b' - b) + b' (a' - a)`, and dropping bits adds
//! `[-(2^-f - 2^-g), 0]`, where `g` is the number of fraction bits that the value really has in this case. The inputs
//! range over the case's *active* interval only, as a rule the versines from 0 to where the lobe is 0 for good; past it
//! a flag forces the result, and values there may wrap.

mod arithmetic;
mod choice;

use super::graph::{Graph, Node, NodeId, Op};
use crate::fixed::{Format, Interval, Table, exp2};

/// What is known of a value in one case.
#[derive(Clone, Copy, Debug)]
pub struct Bound {
    /// The hardware value.
    pub range: Interval,
    /// Hardware minus real.
    pub error: Interval,
    /// The value is a multiple of `2^-grid`.
    pub grid: i32,
}

/// No value of a graph is wider than this, so that products of two fit the 128-bit arithmetic here.
const MAX_BITS: i32 = 126;

/// Why high bits that a cast leaves out are not missed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HighBits {
    /// A flag of the caller's forces the result where they count.
    Guarded,
    /// The analysis shows that they are never used; a core for which it does not is refused.
    Unused,
}

/// A case of the analysis.
#[derive(Clone, Debug)]
pub struct Case {
    /// The versines of the case.
    pub active: Interval,
    /// The shininess; the largest of the set where the case holds several.
    pub shininess: f64,
    /// The row that the case reads of each memory, by the memories' numbers; `None` where it may read any.
    pub rows: Vec<Option<usize>>,
}

impl Case {
    /// One case a row of a coefficient ROM, with the versines from 0 to each row's end.
    #[must_use]
    pub fn of_rows(table: &Table, ends: &[f64]) -> Vec<Self> {
        let case = |(row, &end): (usize, &f64)| Self {
            active: Interval::new(0.0, end),
            shininess: table.keys[row],
            rows: vec![Some(row)],
        };
        ends.iter().enumerate().map(case).collect()
    }
}

/// A graph under construction.
#[derive(Debug)]
pub struct Builder<'a> {
    pub(crate) tables: &'a [Table],
    pub(crate) cases: Vec<Case>,
    pub(crate) nodes: Vec<Node>,
    bounds: Vec<Vec<Bound>>,
    pub(crate) inputs: Vec<NodeId>,
    fits: bool,
}

impl<'a> Builder<'a> {
    /// An empty graph with these memories, analysed for these cases.
    #[must_use]
    pub fn new(tables: &'a [Table], cases: Vec<Case>) -> Self {
        Self { tables, cases, nodes: Vec::new(), bounds: Vec::new(), inputs: Vec::new(), fits: true }
    }

    /// The cases.
    #[must_use]
    pub fn cases(&self) -> &[Case] {
        &self.cases
    }

    /// A memory.
    #[must_use]
    pub fn table(&self, memory: usize) -> &'a Table {
        &self.tables[memory]
    }

    /// The format of a node.
    #[must_use]
    pub fn format(&self, id: NodeId) -> Format {
        self.nodes[id].format
    }

    /// The name of a node.
    #[must_use]
    pub fn name(&self, id: NodeId) -> &str {
        &self.nodes[id].name
    }

    /// The bounds of a node, one a case.
    #[must_use]
    pub fn bounds(&self, id: NodeId) -> &[Bound] {
        &self.bounds[id]
    }

    /// Replaces what the analysis knows of a node by what the caller has proved: tighter bounds, case by case, from a
    /// relation between values that intervals do not see.
    pub fn assume(&mut self, id: NodeId, bounds: Vec<Bound>) {
        debug_assert_eq!(bounds.len(), self.cases.len());
        self.bounds[id] = bounds;
    }

    /// The finished graph with its output ports, without the nodes that no output needs (a lobe may do without x or
    /// without u), or `None` if a value left its format. `kept` are nodes that an output needs: each is given its place
    /// in the graph.
    #[must_use]
    pub fn finish<'k>(
        self,
        outputs: &[(&str, NodeId)],
        kept: impl IntoIterator<Item = &'k mut NodeId>,
    ) -> Option<Graph> {
        let mut needed = vec![false; self.nodes.len()];
        for id in outputs.iter().map(|&(_, node)| node).chain(self.inputs.iter().copied()) {
            needed[id] = true;
        }
        // Arguments come before results.
        for (id, node) in self.nodes.iter().enumerate().rev() {
            if needed[id] {
                node.args.iter().for_each(|&arg| needed[arg] = true);
            }
        }
        // The place of each node among those that stay.
        let place: Vec<NodeId> = needed
            .iter()
            .scan(0, |next, &needed| {
                let place = *next;
                *next += usize::from(needed);
                Some(place)
            })
            .collect();
        let stays = self.nodes.into_iter().zip(&needed).filter(|(_, needed)| **needed);
        let moved = |node: Node| Node { args: node.args.iter().map(|&arg| place[arg]).collect(), ..node };
        let nodes = stays.map(|(node, _)| moved(node)).collect();
        let inputs = self.inputs.into_iter().map(|input| place[input]).collect();
        kept.into_iter().for_each(|node| *node = place[*node]);
        let outputs = outputs.iter().map(|&(name, node)| (name.to_owned(), place[node])).collect();
        self.fits.then_some(Graph { nodes, inputs, outputs })
    }

    /// A node with the bounds of its value, one a case. Bounds that nothing asks for may be left out.
    pub(crate) fn push(
        &mut self,
        op: Op,
        args: &[NodeId],
        format: Format,
        name: &str,
        comment: String,
        bounds: Vec<Bound>,
    ) -> NodeId {
        self.fits &= (1..=MAX_BITS).contains(&(format.int_bits + format.frac_bits));
        self.nodes.push(Node { op, args: args.to_vec(), format, name: name.to_owned(), comment });
        self.bounds.push(bounds);
        self.nodes.len() - 1
    }

    /// A bound for each case.
    pub(crate) fn per_case(&self, bound: impl Fn(usize) -> Bound) -> Vec<Bound> {
        (0..self.cases.len()).map(bound).collect()
    }

    /// A bound for each case from that of a node.
    fn mapped(&self, id: NodeId, bound: impl Fn(Bound) -> Bound) -> Vec<Bound> {
        self.bounds[id].iter().copied().map(bound).collect()
    }

    /// The narrowest format with these fraction bits that holds the ranges of all cases.
    fn holding(&mut self, bounds: &[Bound], frac_bits: i32) -> Format {
        let low = bounds.iter().map(|b| b.range.low).fold(f64::INFINITY, f64::min);
        let high = bounds.iter().map(|b| b.range.high).fold(f64::NEG_INFINITY, f64::max);
        let scale = exp2(frac_bits);
        if low.abs().max(high.abs()) * scale > exp2(MAX_BITS) {
            self.fits = false;
            return Format::unsigned(1, frac_bits);
        }
        // Values are multiples of the last bit's weight: the ends round inwards.
        let (low, high) = ((low * scale).ceil() as i128, (high * scale).floor() as i128);
        Format::holding(low, high.max(low), frac_bits)
    }

    /// An input port; `bound` says what is known of its codes in each case.
    pub fn input(&mut self, format: Format, name: &str, bound: impl Fn(&Case) -> Bound) -> NodeId {
        let bounds = self.cases.iter().map(bound).collect();
        let id = self.push(Op::Input, &[], format, name, String::new(), bounds);
        self.inputs.push(id);
        id
    }

    /// An input port that any of its codes may come to.
    pub fn port(&mut self, format: Format, name: &str) -> NodeId {
        let range = Interval::new(format.value(format.min_code()), format.value(format.max_code()));
        self.input(format, name, |_| Bound { range, error: Interval::ZERO, grid: format.frac_bits })
    }

    /// A whole index of the set as the address in a memory whose rows begin at the set's first.
    pub(crate) fn offset_from_first(&mut self, index: NodeId, memory: usize) -> NodeId {
        let table = &self.tables[memory];
        let (first, address_bits, last) = (table.first_index, table.address_bits, table.rows() as u32 - 1);
        if first == 0 {
            return index;
        }
        let first = self.constant(first.into(), self.format(index), "first");
        let bounds = vec![Self::whole(0, last); self.cases.len()];
        let format = Format::unsigned(address_bits as i32, 0);
        self.push(Op::Sub, &[index, first], format, "address", "n minus the first of the range".to_owned(), bounds)
    }

    /// The address of a part of a row, for the memory `memory`: the row's address and the part's number side by side.
    pub fn part_address(&mut self, address: NodeId, part: NodeId, memory: usize) -> NodeId {
        let bits = self.format(part).width() as i32;
        let shifts = vec![bits; self.cases.len()];
        let base = self.scale(address, None, bits, &shifts, "address_of_parts", "the address of the row's first part");
        let format = Format::unsigned(self.tables[memory].address_bits as i32, 0);
        let bounds = vec![Self::whole(0, (1 << format.width()) - 1); self.cases.len()];
        self.push(Op::Add, &[base, part], format, "part_address", "the address of the part".to_owned(), bounds)
    }

    /// Replaces what the analysis knows of a node as [`Builder::assume`] does, and its format by the narrowest that
    /// holds it.
    pub fn narrow(&mut self, id: NodeId, bounds: Vec<Bound>) {
        let frac_bits = self.format(id).frac_bits;
        self.nodes[id].format = self.holding(&bounds, frac_bits);
        self.assume(id, bounds);
    }

    pub(crate) fn whole(low: u32, high: u32) -> Bound {
        Bound { range: Interval::new(f64::from(low), f64::from(high)), error: Interval::ZERO, grid: 0 }
    }

    /// The named field of a memory's word; a field that is read already is not read again.
    pub fn field(&mut self, memory: usize, address: NodeId, name: &'static str) -> NodeId {
        let tables = self.tables;
        let (index, field) = tables[memory]
            .fields
            .iter()
            .enumerate()
            .find(|(_, field)| field.name == name)
            .expect("a field of this method");
        // Any texels may be written.
        let whole = Bound {
            range: Interval::new(
                field.format.value(field.format.min_code()),
                field.format.value(field.format.max_code()),
            ),
            error: Interval::ZERO,
            grid: field.format.frac_bits,
        };
        let of_row = |row: usize| {
            let code = field.codes[row];
            let spare = if code == 0 { 1 << 20 } else { code.trailing_zeros() as i32 };
            Bound {
                range: Interval::point(field.format.value(code)),
                error: Interval::ZERO,
                grid: field.format.frac_bits - spare,
            }
        };
        let any = (0..tables[memory].rows()).map(of_row).reduce(|a, b| Bound {
            range: a.range.hull(b.range),
            error: Interval::ZERO,
            grid: a.grid.max(b.grid),
        });
        let bounds = self.per_case(|case| match self.cases[case].rows[memory] {
            Some(row) => of_row(row),
            None if tables[memory].holds_texels() => whole,
            None => any.expect("a memory has rows"),
        });
        let op = Op::Field { memory, field: index };
        if let Some(known) = self.nodes.iter().position(|node| node.op == op && node.args == [address]) {
            return known;
        }
        self.push(op, &[address], field.format, name, field.meaning.to_owned(), bounds)
    }

    /// A constant.
    pub fn constant(&mut self, code: i128, format: Format, name: &str) -> NodeId {
        let value = format.value(code);
        let grid = if code == 0 { -(1 << 20) } else { format.frac_bits - code.trailing_zeros() as i32 };
        let bound = Bound { range: Interval::point(value), error: Interval::ZERO, grid };
        self.push(Op::Constant(code), &[], format, name, String::new(), vec![bound; self.cases.len()])
    }

    /// Takes over another graph's operations up to its output, and returns that. `given` says which of its nodes are
    /// nodes here already; `memories` which memory here each of its own is. A field that is read here already is not
    /// read again. The new nodes' names begin with `prefix`.
    ///
    /// The graph has its own analysis: here its values are only known to fit their formats, and its errors are not
    /// followed.
    pub fn graft(&mut self, graph: &Graph, memories: &[usize], given: &[(NodeId, NodeId)], prefix: &str) -> NodeId {
        let mut here: Vec<Option<NodeId>> = vec![None; graph.nodes.len()];
        for &(there, known) in given {
            here[there] = Some(known);
        }
        let mut needed = vec![false; graph.nodes.len()];
        needed[graph.output()] = true;
        for id in (0..graph.nodes.len()).rev().filter(|&id| here[id].is_none()) {
            if needed[id] {
                graph.nodes[id].args.iter().for_each(|&arg| needed[arg] = true);
            }
        }
        for (id, node) in graph.nodes.iter().enumerate() {
            if here[id].is_some() || !needed[id] {
                continue;
            }
            let args: Vec<NodeId> = node.args.iter().map(|&arg| here[arg].expect("arguments come first")).collect();
            let op = match node.op {
                Op::Field { memory, field } => Op::Field { memory: memories[memory], field },
                op => op,
            };
            let is_read = |known: &Node| matches!(op, Op::Field { .. }) && known.op == op && known.args == args;
            if let Some(known) = self.nodes.iter().position(is_read) {
                here[id] = Some(known);
                continue;
            }
            let format = node.format;
            let range = Interval::new(format.value(format.min_code()), format.value(format.max_code()));
            let bound = Bound { range, error: Interval::ZERO, grid: format.frac_bits };
            let bounds = vec![bound; self.cases.len()];
            let name = format!("{prefix}_{}", node.name);
            here[id] = Some(self.push(op, &args, format, &name, node.comment.clone(), bounds));
        }
        here[graph.output()].expect("the output is needed")
    }
}
