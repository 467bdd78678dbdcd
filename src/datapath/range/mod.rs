//! Which values the nodes of a graph take: an interval analysis of their integers, refined until it decides.
//!
//! [`builder`](super::builder) chooses formats from intervals of reals, a case at a time. This is a second look, at the
//! finished graph and without any of the builder's knowledge: it follows intervals of codes through the operations as
//! hardware does them, a block of inputs at a time (a row, and a stretch of operand codes), and halves a block wherever
//! the intervals are too wide to tell. A block of one input is exact, so the analysis decides everything if it is let.
//!
//! A value is *needed* in a block if the output depends on it there: what a flag forces to 0 may be anything. It
//! *overflows* if it is needed and its exact value is outside its format. A cast that drops high bits on purpose is
//! told from one that loses them by what becomes of the bits: other nodes look at them.

mod narrow;
mod relations;
mod span;
mod values;

use rayon::prelude::*;

pub use narrow::Narrowed;
use narrow::can_narrow;
use relations::{
    Blend, Complement, Factor, Restoring, blend, complement, is_guarded_by_sign, kept_where_less, restoring, room,
};
use span::Extremes;
pub use span::Span;
use values::wrapped;

use super::graph::{Graph, NodeId, Op};
use crate::fixed::{Format, Table};

/// Inputs: the codes of each port.
pub type Region = Vec<Span>;

/// The whole of a graph's inputs, row by row: the codes of the first port, of format `index`, that read the same row,
/// and what the other ports take. What lies between two rows of a memory reads the one below: all of it goes together.
/// A greater code reads no row before that of a lesser one.
#[must_use]
pub fn by_rows(index: Format, others: &[Span], row_of_index: impl Fn(u32) -> usize) -> Vec<Region> {
    let most = index.max_code();
    let mut regions = Vec::new();
    let mut first = 0;
    // Not code by code: a port of 31 bits may read a single row.
    while first <= most {
        let row = row_of_index(first as u32);
        let (mut last, mut past, mut step) = (first, most + 1, 1);
        while last + step < past {
            if row_of_index((last + step) as u32) == row {
                last += step
            } else {
                past = last + step
            }
            step *= 2;
        }
        while past - last > 1 {
            let middle = (last + past) / 2;
            if row_of_index(middle as u32) == row { last = middle } else { past = middle }
        }
        regions.push(std::iter::once(Span { low: first, high: last }).chain(others.iter().copied()).collect());
        first = last + 1;
    }
    regions
}

/// [`by_rows`] of a core, with every code of the other ports.
#[must_use]
pub fn regions(graph: &Graph, row_of_index: impl Fn(u32) -> usize) -> Vec<Region> {
    let formats: Vec<Format> = graph.inputs.iter().map(|&id| graph.nodes[id].format).collect();
    let others: Vec<Span> = formats[1..].iter().map(|&format| Span::of(format)).collect();
    by_rows(formats[0], &others, row_of_index)
}

/// What is known in a block of inputs, of the nodes that are looked at.
#[derive(Clone, Debug)]
struct Block {
    /// The exact values of each node, before they are taken into the node's format.
    exact: Vec<Span>,
    /// The codes of each node.
    codes: Vec<Span>,
    needed: Vec<bool>,
    /// Of each `2r - d` whether r is at most d, and so the difference, too.
    restores: Vec<bool>,
}

impl Block {
    /// Room for this many nodes.
    fn of(nodes: usize) -> Self {
        Self {
            exact: vec![Span::point(0); nodes],
            codes: vec![Span::point(0); nodes],
            needed: vec![false; nodes],
            restores: vec![false; nodes],
        }
    }
}

/// A needed value that leaves its format.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Overflow {
    /// The node.
    pub node: NodeId,
    /// The codes at the ports of what was analysed.
    pub inputs: Vec<i128>,
    /// The exact value, in units of the node's last bit.
    pub value: i128,
}

/// What was found over a set of inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct Ranges {
    /// For each node a span that holds its exact value wherever it is needed; `None` if it never is.
    pub needed: Vec<Option<Span>>,
    /// For each node that is a cast the bits that it drops above those that others take, as a number: the same wherever
    /// it is needed, as the leading 1 of a normalised value is.
    pub dropped: Vec<Option<i128>>,
    /// For each node whether the analysis ran out of blocks before it could tell whether the value fits.
    pub undecided: Vec<bool>,
    /// The first overflow of each node that has one, in the order of the inputs' blocks.
    pub overflows: Vec<Overflow>,
    /// The blocks that were looked at.
    pub blocks: u64,
}

impl Ranges {
    /// What is found over no input of a graph of so many nodes.
    #[must_use]
    pub fn none(nodes: usize) -> Self {
        let (needed, dropped) = (vec![None; nodes], vec![None; nodes]);
        Self { needed, dropped, undecided: vec![false; nodes], overflows: Vec::new(), blocks: 0 }
    }

    fn hold(&mut self, id: NodeId, span: Span) {
        self.needed[id] = Some(self.needed[id].map_or(span, |known| known.hull(span)));
    }

    /// What is found over two sets of inputs together; the overflows of `self` come first.
    #[must_use]
    pub fn and(mut self, other: Self) -> Self {
        for (id, span) in other.needed.into_iter().enumerate() {
            if let Some(span) = span {
                self.hold(id, span);
            }
        }
        self.undecided.iter_mut().zip(other.undecided).for_each(|(own, other)| *own |= other);
        for overflow in other.overflows {
            self.add(overflow);
        }
        for (id, dropped) in other.dropped.into_iter().enumerate() {
            match (self.dropped[id], dropped) {
                (None, dropped) => self.dropped[id] = dropped,
                (Some(own), Some(theirs)) if own != theirs => self.undecided[id] = true,
                _ => {}
            }
        }
        self.blocks += other.blocks;
        self
    }

    fn has_overflow(&self, id: NodeId) -> bool {
        self.overflows.iter().any(|known| known.node == id)
    }

    fn add(&mut self, overflow: Overflow) {
        if !self.has_overflow(overflow.node) {
            self.overflows.push(overflow);
        }
    }

    /// Whether it is proved that no needed value leaves its format.
    #[must_use]
    pub fn is_safe(&self) -> bool {
        self.overflows.is_empty() && !self.undecided.contains(&true)
    }
}

/// Analyses a graph, or a part of one, with given memories.
#[derive(Clone, Debug)]
pub struct Analysis<'a> {
    graph: &'a Graph,
    /// The nodes that the part's results depend on, from its ports on; arguments before results.
    nodes: Vec<NodeId>,
    /// For each node that is a port of the part its place among these.
    ports: Vec<Option<usize>>,
    /// The part's results: always needed.
    results: Vec<NodeId>,
    /// Whether blocks are halved until it is known which bits the values use, not only whether they fit.
    is_tight: bool,
    /// For each node that is a field its codes' extremes.
    extremes: Vec<Option<Extremes>>,
    /// For each node the format that its exact value must fit, and the codes of that: the node's own, with the bits
    /// that a cast drops and other nodes take.
    room: Vec<(Format, Span)>,
    /// Casts whose value is looked at only where it is not negative.
    guarded: Vec<bool>,
    complements: Vec<Option<Complement>>,
    blends: Vec<Option<Blend>>,
    restoring: Vec<Option<Restoring>>,
    /// For each node that is the `2r` of a step of a restoring division, looked at only where it is less than d: the
    /// `2r - d`.
    kept: Vec<Option<NodeId>>,
}

impl<'a> Analysis<'a> {
    /// Prepares a graph, from its input ports to its outputs.
    #[must_use]
    pub fn new(graph: &'a Graph, tables: &[Table]) -> Self {
        let outputs: Vec<NodeId> = graph.outputs.iter().map(|&(_, node)| node).collect();
        Self { is_tight: true, ..Self::of_part(graph, tables, &graph.inputs, &outputs) }
    }

    /// Prepares the part of a graph between `ports`, which are any nodes, and `results`: a port takes what a region
    /// says of it, whatever makes it in the graph. Where the regions hold what the ports take in the graph, so does
    /// what is found of the part. Blocks are halved only until it is known whether values fit.
    ///
    /// # Panics
    /// In [`Analysis::over`] if a result depends on an input of the graph that is no port of the part.
    #[must_use]
    pub fn of_part(graph: &'a Graph, tables: &[Table], ports: &[NodeId], results: &[NodeId]) -> Self {
        let ids = 0..graph.nodes.len();
        let place = |id: NodeId| ports.iter().position(|&port| port == id);
        let ports: Vec<Option<usize>> = ids.clone().map(place).collect();
        let mut seen = vec![false; graph.nodes.len()];
        results.iter().for_each(|&id| seen[id] = true);
        for id in ids.clone().rev() {
            if seen[id] && ports[id].is_none() {
                graph.nodes[id].args.iter().for_each(|&arg| seen[arg] = true);
            }
        }
        let extremes = |id: NodeId| match graph.nodes[id].op {
            Op::Field { memory, field } if seen[id] && ports[id].is_none() => {
                Some(Extremes::of(&tables[memory], field))
            }
            _ => None,
        };
        let with_codes = |format: Format| (format, Span::of(format));
        let is_inside = |id: NodeId| seen[id] && ports[id].is_none();
        let complement = |id: NodeId| {
            let found = complement(graph, id)?;
            let factor = match found.p {
                Factor::Node(p) => p,
                Factor::Power(_) => found.x,
            };
            [found.product, found.x, factor, found.floor].into_iter().all(|id| seen[id]).then_some(found)
        };
        let blend = |id: NodeId| {
            let found = blend(graph, id)?;
            [found.a, found.c, found.apart, found.t, found.part].into_iter().all(|id| seen[id]).then_some(found)
        };
        let kept = |id: NodeId| kept_where_less(graph, id).filter(|&trial| is_inside(trial));
        let restoring = |id: NodeId| {
            let found = restoring(graph, id)?;
            Some(Restoring { before: found.before.filter(|&trial| is_inside(trial)), ..found })
        };
        Self {
            extremes: ids.clone().map(extremes).collect(),
            room: ids.clone().map(|id| with_codes(if seen[id] { room(graph, id) } else { Format::FLAG })).collect(),
            guarded: ids.clone().map(|id| is_inside(id) && is_guarded_by_sign(graph, id)).collect(),
            complements: ids.clone().map(|id| is_inside(id).then(|| complement(id)).flatten()).collect(),
            blends: ids.clone().map(|id| is_inside(id).then(|| blend(id)).flatten()).collect(),
            restoring: ids.clone().map(|id| is_inside(id).then(|| restoring(id)).flatten()).collect(),
            kept: ids.clone().map(|id| is_inside(id).then(|| kept(id)).flatten()).collect(),
            nodes: ids.filter(|&id| seen[id]).collect(),
            results: results.to_vec(),
            is_tight: false,
            graph,
            ports,
        }
    }

    /// The nodes whose values are computed here: all that the results depend on, without the ports.
    pub fn computed(&self) -> impl Iterator<Item = NodeId> + '_ {
        self.nodes.iter().copied().filter(|&id| self.ports[id].is_none())
    }

    /// What the nodes take over these regions, looking at no more than about `most_blocks` blocks in each.
    #[must_use]
    pub fn over(&self, regions: &[Region], most_blocks: u64) -> Ranges {
        // In order, so that the overflows are the same whatever runs first.
        let parts: Vec<Ranges> = regions.par_iter().map(|region| self.region(region, most_blocks)).collect();
        parts.into_iter().fold(Ranges::none(self.graph.nodes.len()), Ranges::and)
    }

    fn region(&self, region: &Region, most_blocks: u64) -> Ranges {
        let nodes = self.graph.nodes.len();
        let mut found = Ranges::none(nodes);
        // What single inputs show is certain; a block tells more than these only by needing more bits.
        let mut certain = Ranges::none(nodes);
        let mut block = Block::of(nodes);
        for end in [|span: &Span| span.low, |span: &Span| span.high, |span: &Span| span.middle()] {
            self.point(region.iter().map(end), &mut block, &mut certain);
        }
        let mut open = vec![region.clone()];
        while let Some(mut inputs) = open.pop() {
            found.blocks += 1;
            self.look(&inputs, &mut block);
            let is_point = inputs.iter().all(|span| span.is_point());
            if is_point {
                self.hold(&block, &mut certain);
            }
            if is_point || found.blocks > most_blocks || !self.is_open(&block, &certain, &found) {
                self.accept(&block, &inputs, is_point, &mut found);
                continue;
            }
            let port = Self::widest(&inputs, region);
            let mut upper = inputs.clone();
            let middle = inputs[port].middle();
            (inputs[port].high, upper[port].low) = (middle, middle + 1);
            // A single input is looked at next.
            if !inputs.iter().all(|span| span.is_point()) {
                self.point(inputs.iter().map(|span| span.high), &mut block, &mut certain);
            }
            open.extend([upper, inputs]);
        }
        found
    }

    /// The port that has been halved least.
    fn widest(inputs: &Region, region: &Region) -> usize {
        let part = |port: usize| inputs[port].count() as f64 / region[port].count() as f64;
        let candidates = (0..inputs.len()).filter(|&port| !inputs[port].is_point());
        candidates.max_by(|&a, &b| part(a).total_cmp(&part(b))).expect("more than one input")
    }

    /// Whether halving the block may tell more.
    fn is_open(&self, block: &Block, certain: &Ranges, found: &Ranges) -> bool {
        self.nodes.iter().any(|&id| {
            let node = &self.graph.nodes[id];
            if !block.needed[id] {
                return false;
            }
            if !self.keeps(id, block.exact[id], certain.dropped[id]) {
                // One overflow of a node is enough.
                return !found.has_overflow(id);
            }
            let bits = |span: Span| span.int_bits(node.format.frac_bits);
            let taken = self.taken(id, block);
            let uses_more = |known: Span| !known.holds(taken) && bits(taken) > bits(known.hull(Span::point(0)));
            self.is_tight && can_narrow(node.op) && certain.needed[id].is_none_or(uses_more)
        })
    }

    fn accept(&self, block: &Block, inputs: &Region, is_point: bool, found: &mut Ranges) {
        for &id in self.nodes.iter().filter(|&&id| block.needed[id]) {
            let exact = block.exact[id];
            found.hold(id, self.taken(id, block));
            if self.keeps(id, exact, found.dropped[id]) {
                if self.graph.nodes[id].op == Op::Cast {
                    found.dropped[id] = self.dropped(id, exact);
                }
            } else if is_point {
                let inputs = inputs.iter().map(|span| span.low).collect();
                found.add(Overflow { node: id, inputs, value: exact.low });
            } else if !found.has_overflow(id) {
                found.undecided[id] = true;
            }
        }
    }

    /// What a format must hold of a node: its value, or of a cast that drops bits on purpose the code that is left.
    fn taken(&self, id: NodeId, block: &Block) -> Span {
        let is_cast = self.graph.nodes[id].op == Op::Cast;
        if is_cast && !block.exact[id].fits(self.graph.nodes[id].format) { block.codes[id] } else { block.exact[id] }
    }

    /// The bits of a value above its room, as a number, if they are the same all over the span.
    fn dropped(&self, id: NodeId, exact: Span) -> Option<i128> {
        let (room, codes) = self.room[id];
        if codes.holds(exact) {
            return Some(0);
        }
        let part = |code: i128| (code - room.wrap(code)) >> room.width();
        (part(exact.low) == part(exact.high)).then(|| part(exact.low))
    }

    /// Whether nothing is lost of a node's value: it fits, or a cast drops of it what it drops everywhere.
    fn keeps(&self, id: NodeId, exact: Span, known: Option<i128>) -> bool {
        match self.dropped(id, exact) {
            Some(dropped) if self.graph.nodes[id].op == Op::Cast => known.is_none_or(|known| known == dropped),
            dropped => dropped == Some(0),
        }
    }

    /// Looks at one input.
    fn point(&self, inputs: impl Iterator<Item = i128>, block: &mut Block, certain: &mut Ranges) {
        self.look(&inputs.map(Span::point).collect(), block);
        self.hold(block, certain);
    }

    /// Takes over what the block of one input shows.
    fn hold(&self, block: &Block, certain: &mut Ranges) {
        for &id in self.nodes.iter().filter(|&&id| block.needed[id]) {
            certain.hold(id, self.taken(id, block));
            if self.graph.nodes[id].op == Op::Cast {
                certain.dropped[id] = certain.dropped[id].or(self.dropped(id, block.exact[id]));
            }
        }
    }

    /// For each node a span that holds its code for every input of a region, whether it is needed or not.
    #[must_use]
    pub fn codes(&self, region: &Region) -> Vec<Span> {
        let mut block = Block::of(self.graph.nodes.len());
        block.codes = self.graph.nodes.iter().map(|node| Span::of(node.format)).collect();
        for &id in &self.nodes {
            block.exact[id] = self.value(id, region, &block);
            block.codes[id] = wrapped(block.exact[id], self.graph.nodes[id].format);
        }
        block.codes
    }
}
