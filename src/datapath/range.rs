//! Which values the nodes of a graph take: an interval analysis of their integers, refined until it decides.
//!
//! [`builder`](super::builder) chooses formats from intervals of reals, a case at a time. This is a second look, at the finished
//! graph and without any of the builder's knowledge: it follows intervals of codes through the operations as hardware does them, a
//! block of inputs at a time (a row, and a stretch of operand codes), and halves a block wherever the intervals are too wide to tell.
//! A block of one input is exact, so the analysis decides everything if it is let.
//!
//! A value is *needed* in a block if the output depends on it there: what a flag forces to 0 may be anything. It *overflows* if it is
//! needed and its exact value is outside its format. A cast that drops high bits on purpose is told from one that loses them by what
//! becomes of the bits: other nodes look at them.

use rayon::prelude::*;

use super::graph::{Graph, Node, NodeId, Op};
use crate::fixed::{Format, Table};

/// The codes from one to another, both included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Span {
    /// The least.
    pub low: i128,
    /// The greatest.
    pub high: i128,
}

impl Span {
    /// One code.
    #[must_use]
    pub const fn point(code: i128) -> Self {
        Self { low: code, high: code }
    }

    /// Every code of a format.
    #[must_use]
    pub const fn of(format: Format) -> Self {
        Self { low: format.min_code(), high: format.max_code() }
    }

    /// The least span that holds both.
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// Whether every code of it is one of the format's.
    #[must_use]
    pub fn fits(self, format: Format) -> bool {
        Self::of(format).holds(self)
    }

    /// Whether all of the other span is in it.
    #[must_use]
    pub fn holds(self, other: Self) -> bool {
        self.low <= other.low && other.high <= self.high
    }

    /// Whether the code is one of it.
    #[must_use]
    pub fn contains(self, code: i128) -> bool {
        self.low <= code && code <= self.high
    }

    /// The larger of the two ends' magnitudes.
    #[must_use]
    pub fn magnitude(self) -> u128 {
        self.low.unsigned_abs().max(self.high.unsigned_abs())
    }

    /// What of it is no greater than a bound that is known to hold; all of it where nothing is, as behind a value that has left its format.
    fn up_to(self, bound: i128) -> Self {
        if bound < self.low { self } else { Self { high: self.high.min(bound), ..self } }
    }

    fn map(self, f: impl Fn(i128) -> i128) -> Self {
        Self { low: f(self.low), high: f(self.high) }
    }

    fn times(self, other: Self) -> Self {
        let ends = [self.low * other.low, self.low * other.high, self.high * other.low, self.high * other.high];
        let [mut low, mut high] = [ends[0]; 2];
        for end in ends {
            (low, high) = (low.min(end), high.max(end));
        }
        Self { low, high }
    }

    /// Whether it holds one code only.
    #[must_use]
    pub fn is_point(self) -> bool {
        self.low == self.high
    }

    /// How many codes it holds.
    #[must_use]
    pub fn count(self) -> u128 {
        (self.high - self.low) as u128 + 1
    }

    fn middle(self) -> i128 {
        self.low + (self.high - self.low) / 2
    }

    /// The integer bits, sign not counted, of the narrowest format that holds it.
    fn int_bits(self, frac_bits: i32) -> i32 {
        Format::holding(self.low, self.high, frac_bits).int_bits
    }
}

/// The least and greatest codes of a field over any stretch of addresses.
#[derive(Clone, Debug)]
struct Extremes {
    /// A binary tree: `nodes[leaves + i]` is the code at address `i`, `nodes[i]` the hull of `nodes[2 i]` and `nodes[2 i + 1]`.
    nodes: Vec<Span>,
}

impl Extremes {
    fn of(table: &Table, field: usize) -> Self {
        let depth = table.depth();
        let mut nodes = vec![Span::point(0); 2 * depth];
        for address in 0..depth {
            nodes[depth + address] = Span::point(table.code_at(field, address));
        }
        for place in (1..depth).rev() {
            nodes[place] = nodes[2 * place].hull(nodes[2 * place + 1]);
        }
        Self { nodes }
    }

    fn over(&self, addresses: Span) -> Span {
        let leaves = self.nodes.len() / 2;
        let (mut low, mut high) = (leaves + addresses.low as usize, leaves + addresses.high as usize + 1);
        let mut hull = self.nodes[low];
        while low < high {
            if low % 2 == 1 {
                hull = hull.hull(self.nodes[low]);
                low += 1;
            }
            if high % 2 == 1 {
                high -= 1;
                hull = hull.hull(self.nodes[high]);
            }
            (low, high) = (low / 2, high / 2);
        }
        hull
    }
}

/// `x - floor(x p)`, which plain intervals take for a difference of two values that have nothing to do with each other.
#[derive(Clone, Copy, Debug)]
struct Complement {
    product: NodeId,
    x: NodeId,
    p: NodeId,
    /// Fraction bits of the floor.
    floor: NodeId,
    /// What is added to x first.
    added: Option<NodeId>,
}

/// A step of a restoring division: `2r - d`, of which the sign selects between `2r` and the difference. Plain intervals lose that what is
/// selected is at most d, as r was.
#[derive(Clone, Copy, Debug)]
struct Restoring {
    doubled: NodeId,
    divisor: NodeId,
    /// The `2r - d` of the step before.
    before: Option<NodeId>,
}

/// Inputs: the codes of each port.
pub type Region = Vec<Span>;

/// The whole of a graph's inputs, row by row: the codes of the first port, of format `index`, that read the same row, and what the other
/// ports take. What lies between two rows of a memory reads the one below: all of it goes together. A greater code reads no row before
/// that of a lesser one.
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

/// A value that got fewer bits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Narrowed {
    /// Its node's name.
    pub name: String,
    /// The format that the builder chose.
    pub from: Format,
    /// The format that it has now.
    pub to: Format,
}

impl Narrowed {
    /// The bits that were taken off.
    #[must_use]
    pub fn bits(&self) -> u32 {
        self.from.width() - self.to.width()
    }
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
    /// For each node that is a cast the bits that it drops above those that others take, as a number: the same wherever it is needed,
    /// as the leading 1 of a normalised value is.
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
    /// For each node the format that its exact value must fit, and the codes of that: the node's own, with the bits that a cast drops and
    /// other nodes take.
    room: Vec<(Format, Span)>,
    /// Casts whose value is looked at only where it is not negative.
    guarded: Vec<bool>,
    complements: Vec<Option<Complement>>,
    restoring: Vec<Option<Restoring>>,
    /// For each node that is the `2r` of a step of a restoring division, looked at only where it is less than d: the `2r - d`.
    kept: Vec<Option<NodeId>>,
}

impl<'a> Analysis<'a> {
    /// Prepares a graph, from its input ports to its outputs.
    #[must_use]
    pub fn new(graph: &'a Graph, tables: &[Table]) -> Self {
        let outputs: Vec<NodeId> = graph.outputs.iter().map(|&(_, node)| node).collect();
        Self { is_tight: true, ..Self::of_part(graph, tables, &graph.inputs, &outputs) }
    }

    /// Prepares the part of a graph between `ports`, which are any nodes, and `results`: a port takes what a region says of it, whatever
    /// makes it in the graph. Where the regions hold what the ports take in the graph, so does what is found of the part. Blocks are
    /// halved only until it is known whether values fit.
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
            [found.product, found.x, found.p, found.floor].into_iter().all(|id| seen[id]).then_some(found)
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

    /// What a node takes, given what its arguments do.
    fn value(&self, id: NodeId, inputs: &Region, block: &Block) -> Span {
        self.ports[id].map_or_else(|| self.exact(id, &self.graph.nodes[id], block), |port| inputs[port])
    }

    /// Follows a block of inputs through the operations.
    fn look(&self, inputs: &Region, block: &mut Block) {
        for &id in &self.nodes {
            let node = &self.graph.nodes[id];
            let mut exact = self.value(id, inputs, block);
            if self.guarded[id] {
                exact = exact.map(|code| code.max(0));
            }
            if let (Some(step), false) = (self.restoring[id], exact.is_point()) {
                block.restores[id] = self.restores(step, block);
                if block.restores[id] {
                    exact = exact.up_to(self.aligned(step.divisor, node.format, block).high);
                }
            }
            if let (Some(trial), false) = (self.kept[id], exact.is_point()) {
                let divisor = self.restoring[trial].expect("a step").divisor;
                // Below the divisor by a last bit of the finer at least.
                exact = exact.up_to(self.aligned(divisor, node.format, block).high);
            }
            block.exact[id] = exact;
            block.codes[id] = wrapped(exact, node.format);
            block.needed[id] = false;
        }
        self.results.iter().for_each(|&result| block.needed[result] = true);
        for &id in self.nodes.iter().rev() {
            if !block.needed[id] || self.ports[id].is_some() {
                continue;
            }
            let node = &self.graph.nodes[id];
            let flag = |place: usize| block.codes[node.args[place]];
            let (no, yes) = (Span::point(0), Span::point(1));
            let unused = match node.op {
                Op::ZeroIf | Op::Or if flag(0) == yes => Some(1),
                Op::Or if flag(1) == yes => Some(0),
                Op::Select if flag(0) == yes => Some(2),
                Op::Select if flag(0) == no => Some(1),
                // A product with 0 is 0, whatever the other factor is.
                Op::Mul if flag(0) == no => Some(1),
                Op::Mul if flag(1) == no => Some(0),
                _ => None,
            };
            for (place, &arg) in node.args.iter().enumerate() {
                block.needed[arg] |= Some(place) != unused;
            }
        }
    }

    /// The codes of a node with as many fraction bits as a format has, which are no fewer.
    fn aligned(&self, id: NodeId, format: Format, block: &Block) -> Span {
        block.codes[id].map(|code| code << (format.frac_bits - self.graph.nodes[id].format.frac_bits))
    }

    /// Whether r is at most d in a step: it was in the step before, or the whole block says so.
    fn restores(&self, step: Restoring, block: &Block) -> bool {
        if step.before.is_some_and(|before| block.restores[before]) {
            return true;
        }
        let [doubled, divisor] = [step.doubled, step.divisor].map(|id| self.graph.nodes[id].format);
        let finer = if doubled.frac_bits > divisor.frac_bits { doubled } else { divisor };
        self.aligned(step.doubled, finer, block).high <= 2 * self.aligned(step.divisor, finer, block).low
    }

    /// The exact values of a node, given its arguments' codes.
    fn exact(&self, id: NodeId, node: &Node, block: &Block) -> Span {
        let arg = |place: usize| block.codes[node.args[place]];
        let frac = |place: usize| self.graph.nodes[node.args[place]].format.frac_bits;
        let aligned = |place: usize| arg(place).map(|code| code << (node.format.frac_bits - frac(place)));
        let flag = |known: Option<bool>| match known {
            Some(known) => Span::point(known.into()),
            None => Span { low: 0, high: 1 },
        };
        match node.op {
            Op::Input => panic!("{} is no port of the part", node.name),
            Op::Field { .. } => self.extremes[id].as_ref().expect("a field has extremes").over(arg(0)),
            Op::Constant(code) => Span::point(code),
            Op::Clamp { low, high } => arg(0).map(|code| code.clamp(low, high)),
            Op::Add => {
                let (a, b) = (aligned(0), aligned(1));
                Span { low: a.low + b.low, high: a.high + b.high }
            }
            Op::Sub => {
                let (a, b) = (aligned(0), aligned(1));
                let plain = Span { low: a.low - b.high, high: a.high - b.low };
                let related = self.complements[id].and_then(|complement| self.related(node, complement, block));
                related.map_or(plain, |related| Span {
                    low: plain.low.max(related.low),
                    high: plain.high.min(related.high),
                })
            }
            Op::Mul if node.args[0] == node.args[1] => {
                let a = arg(0);
                let squares = a.map(|code| code * code);
                let least = if a.contains(0) { 0 } else { squares.low.min(squares.high) };
                Span { low: least, high: squares.low.max(squares.high) }
            }
            Op::Mul => arg(0).times(arg(1)),
            Op::ShiftLeft => {
                let (a, by) = (arg(0), arg(1));
                a.map(|code| code << by.low).hull(a.map(|code| code << by.high))
            }
            Op::ShiftRight => {
                let (a, by) = (arg(0), arg(1));
                let shifted = |by: i128| a.map(|code| code >> by.min(127));
                shifted(by.low).hull(shifted(by.high))
            }
            Op::Cast if node.format.frac_bits >= frac(0) => aligned(0),
            Op::Cast => arg(0).map(|code| code >> (frac(0) - node.format.frac_bits)),
            Op::Scale => arg(0),
            Op::NonZero => flag(match arg(0) {
                span if span == Span::point(0) => Some(false),
                span if !span.contains(0) => Some(true),
                _ => None,
            }),
            Op::Greater => {
                let (a, b) = (arg(0), arg(1));
                flag(if a.low > b.high {
                    Some(true)
                } else if a.high <= b.low {
                    Some(false)
                } else {
                    None
                })
            }
            Op::Or => {
                let (a, b) = (arg(0), arg(1));
                Span { low: a.low.max(b.low), high: a.high.max(b.high) }
            }
            Op::Not => Span { low: 1 - arg(0).high, high: 1 - arg(0).low },
            Op::Select => match arg(0) {
                span if span == Span::point(1) => arg(1),
                span if span == Span::point(0) => arg(2),
                _ => arg(1).hull(arg(2)),
            },
            Op::ZeroIf => match arg(0) {
                span if span == Span::point(1) => Span::point(0),
                span if span == Span::point(0) => arg(1),
                _ => arg(1).hull(Span::point(0)),
            },
        }
    }

    /// `x + c - floor(x p) = x (1 - p) + c + (x p - floor(x p))`, where nothing of it is taken modulo a width; in units of the node's
    /// last bit.
    fn related(&self, node: &Node, complement: Complement, block: &Block) -> Option<Span> {
        let format = |id: NodeId| self.graph.nodes[id].format;
        let Complement { product, x, p, floor, added } = complement;
        let untouched = |id: NodeId| block.exact[id].fits(format(id));
        if ![product, floor, node.args[0]].into_iter().all(untouched) {
            return None;
        }
        // All in units of the product's last bit.
        let one = 1i128.checked_shl(format(p).frac_bits.try_into().ok()?)?;
        let unit = format(product).frac_bits;
        let rest = Span { low: one - block.codes[p].high, high: one - block.codes[p].low };
        let product = block.codes[x].times(rest);
        let lost = (1i128 << (unit - format(floor).frac_bits).max(0)) - 1;
        let shift = unit - node.format.frac_bits;
        if shift < 0 {
            return None;
        }
        let constant = match added {
            Some(id) => block.codes[id].low << (unit - format(id).frac_bits),
            None => 0,
        };
        let (low, high) = (product.low + constant, product.high + constant + lost);
        // The value is a multiple of the node's last bit: the ends round inwards.
        let last = (1i128 << shift) - 1;
        Some(Span { low: (low + last) >> shift, high: high >> shift })
    }

    /// The graph with every format as narrow as the ranges allow: sums, differences, shifts and casts lose the integer bits that no
    /// needed value uses, and products those that their narrower operands leave idle. The function stays what it is for every input
    /// that `ranges` covers.
    #[must_use]
    pub fn narrowed(&self, ranges: &Ranges) -> (Graph, Vec<Narrowed>) {
        let mut graph = self.graph.clone();
        let fixed = self.fixed_formats();
        for (id, &fixed) in fixed.iter().enumerate() {
            let node = &graph.nodes[id];
            let format = |place: usize| graph.nodes[node.args[place]].format;
            let int_bits = match node.op {
                Op::Mul => format(0).int_bits + format(1).int_bits + i32::from(node.format.signed),
                Op::ZeroIf => format(1).int_bits,
                op if can_narrow(op) && !fixed && !ranges.undecided[id] => {
                    let span = ranges.needed[id].unwrap_or(Span::point(0)).hull(Span::point(0));
                    let bits = span.int_bits(node.format.frac_bits);
                    bits.clamp(1 - node.format.frac_bits, node.format.int_bits)
                }
                _ => node.format.int_bits,
            };
            graph.nodes[id].format.int_bits = int_bits;
        }
        let pairs = self.graph.nodes.iter().zip(&graph.nodes).filter(|(before, after)| before.format != after.format);
        let narrowed = |(before, after): (&Node, &Node)| Narrowed {
            name: after.name.clone(),
            from: before.format,
            to: after.format,
        };
        let narrowed = pairs.map(narrowed).collect();
        (graph, narrowed)
    }

    /// The graph with registers in which nothing can overflow unseen: sums, differences, products, shifts and casts get a sign and eight
    /// integer bits more, or as many as make them 62 bits wide, which are evaluated faster than more. Where no needed value leaves its
    /// format, its outputs are those of the graph itself; so running both over every input checks an analysis that found none. What casts
    /// drop on purpose, as `ranges` tells, they drop here too.
    #[must_use]
    pub fn with_spare_bits(&self, ranges: &Ranges) -> Graph {
        let mut graph = self.graph.clone();
        // An address beyond a memory would be none at all, and a flag is one bit: what makes these, through operations that pass on what
        // they get, stays.
        let mut stays = vec![false; graph.nodes.len()];
        for (id, node) in self.graph.nodes.iter().enumerate().rev() {
            let kept: &[NodeId] = match node.op {
                Op::Field { .. } | Op::Or | Op::Not => &node.args,
                Op::Scale | Op::ShiftRight | Op::Select | Op::ZeroIf if stays[id] => &node.args,
                Op::Select | Op::ZeroIf => &node.args[..1],
                _ => &[],
            };
            kept.iter().for_each(|&arg| stays[arg] = true);
        }
        // Two bits more than any value has are enough to see a carry out of it and its sign.
        let most = if graph.nodes.iter().all(|node| node.format.width() <= 59) { 61 } else { 126 };
        for (id, node) in graph.nodes.iter_mut().enumerate() {
            let widened = match node.op {
                _ if stays[id] => false,
                Op::Add | Op::Sub | Op::Mul | Op::ShiftLeft => true,
                Op::Cast => self.room[id].0 == node.format && matches!(ranges.dropped[id], None | Some(0)),
                _ => false,
            };
            if widened {
                let int_bits = (node.format.int_bits + SPARE_BITS).min(most - node.format.frac_bits);
                node.format = Format { signed: true, int_bits, ..node.format };
            }
        }
        graph
    }

    /// The nodes whose formats something else rests on: ports, addresses, operands of what only renames or shifts bits, of limits that
    /// are compared in the operand's width, and of a result that is a port.
    fn fixed_formats(&self) -> Vec<bool> {
        let graph = self.graph;
        let mut fixed: Vec<bool> = (0..graph.nodes.len()).map(|id| graph.is_output(id)).collect();
        for (id, node) in graph.nodes.iter().enumerate().rev() {
            let holds = match node.op {
                Op::Field { .. } | Op::Scale | Op::ShiftRight => true,
                Op::Clamp { low, .. } => low != 0,
                Op::ZeroIf => fixed[id],
                _ => false,
            };
            if holds {
                node.args.iter().for_each(|&arg| fixed[arg] = true);
            }
        }
        fixed
    }
}

/// What [`Analysis::with_spare_bits`] adds.
const SPARE_BITS: i32 = 8;

/// Operations whose result's format is the builder's choice.
fn can_narrow(op: Op) -> bool {
    matches!(op, Op::Add | Op::Sub | Op::ShiftLeft | Op::Cast)
}

/// What hardware keeps of a span of exact values.
fn wrapped(exact: Span, format: Format) -> Span {
    if exact.fits(format) {
        return exact;
    }
    let codes = exact.map(|code| format.wrap(code));
    // Within one period of the wrapping the order stays.
    if exact.count() <= 1 << format.width() && codes.low <= codes.high {
        return codes;
    }
    Span { low: format.min_code(), high: format.max_code() }
}

/// The format that a node's exact value must fit for nothing to be lost: for a cast that keeps low bits while other casts of the same
/// value take the bits above these, the format with these bits too; a cast that takes the sign as a bit loses nothing, nor does one
/// that rounds nothing of a value that another node uses whole.
fn room(graph: &Graph, id: NodeId) -> Format {
    let node = &graph.nodes[id];
    if node.op != Op::Cast {
        return node.format;
    }
    let from = graph.nodes[node.args[0]].format;
    if from.signed && node.format.width() == 1 && node.format.int_bits > from.int_bits {
        return Format { signed: true, int_bits: node.format.int_bits, ..node.format };
    }
    let of_same = |(other, other_node): &(usize, &Node)| {
        *other != id && other_node.op == Op::Cast && other_node.args[0] == node.args[0]
    };
    let others: Vec<Format> = graph.nodes.iter().enumerate().filter(of_same).map(|(_, node)| node.format).collect();
    let uses_whole = |user: &Node| user.op != Op::Cast && user.args.contains(&node.args[0]);
    if node.format.frac_bits == from.frac_bits && graph.nodes.iter().any(uses_whole) {
        return Format { int_bits: node.format.int_bits.max(from.int_bits), ..node.format };
    }
    let taken = |bit: &i32| others.iter().any(|other| (-other.frac_bits..other.int_bits).contains(bit));
    let above = (node.format.int_bits..from.int_bits).take_while(taken).count() as i32;
    Format { int_bits: node.format.int_bits + above, ..node.format }
}

/// Whether a node is an unsigned cast of a signed value, used only as what a selection takes where that value is not negative.
fn is_guarded_by_sign(graph: &Graph, id: NodeId) -> bool {
    let node = &graph.nodes[id];
    if node.op != Op::Cast || node.format.signed || !graph.nodes[node.args[0]].format.signed || graph.is_output(id) {
        return false;
    }
    let mut users = graph.nodes.iter().filter(|user| user.args.contains(&id)).peekable();
    users.peek().is_some()
        && users.all(|user| {
            user.op == Op::Select
                && takes_sign(graph, user.args[0], node.args[0])
                && user.args[1] != id
                && user.args[2] == id
        })
}

/// Whether a node is the `2r - d` of a step of a restoring division.
fn restoring(graph: &Graph, id: NodeId) -> Option<Restoring> {
    let of = |id: NodeId| &graph.nodes[id];
    let [doubled, divisor] = of(id).args[..] else { return None };
    if of(id).op != Op::Sub || of(doubled).op != Op::Scale {
        return None;
    }
    // r is what a step before selects, or anything.
    let step_before = || {
        let remainder = of(doubled).args[0];
        let [flag, kept, less] = of(remainder).args[..] else { return None };
        let (Op::Select, Op::Cast) = (of(remainder).op, of(less).op) else { return None };
        let trial = of(less).args[0];
        let is_step = of(trial).op == Op::Sub
            && of(trial).args[1] == divisor
            && takes_sign(graph, flag, trial)
            && of(kept).op == Op::Cast
            && of(kept).args[0] == of(trial).args[0]
            && [kept, less].iter().all(|&id| of(id).format.frac_bits == of(trial).format.frac_bits)
            && of(of(trial).args[0]).op == Op::Scale;
        is_step.then_some(trial)
    };
    // Twice what is scaled: the binary point is one place further.
    let is_twice = of(doubled).format.frac_bits + 1 == of(of(doubled).args[0]).format.frac_bits;
    is_twice.then(|| Restoring { doubled, divisor, before: step_before() })
}

/// Whether a node is an unsigned cast of the `2r` of a step of a restoring division, used only as what is selected where the step's
/// difference is negative: that difference.
fn kept_where_less(graph: &Graph, id: NodeId) -> Option<NodeId> {
    let of = |id: NodeId| &graph.nodes[id];
    if of(id).op != Op::Cast || graph.is_output(id) {
        return None;
    }
    let mut found = None;
    for user in graph.nodes.iter().filter(|user| user.args.contains(&id)) {
        let [flag, kept, less] = user.args[..] else { return None };
        if user.op != Op::Select || kept != id || less == id || flag == id || of(flag).op != Op::Cast {
            return None;
        }
        let trial = of(flag).args[0];
        let is_step = restoring(graph, trial).is_some_and(|step| step.doubled == of(id).args[0])
            && takes_sign(graph, flag, trial)
            && of(id).format.frac_bits == of(trial).format.frac_bits;
        if !is_step || found.is_some_and(|known| known != trial) {
            return None;
        }
        found = Some(trial);
    }
    found
}

/// Whether a flag is the sign of a value.
fn takes_sign(graph: &Graph, flag: NodeId, value: NodeId) -> bool {
    graph.nodes[flag].op == Op::Cast && graph.nodes[flag].args[0] == value && room(graph, flag).signed
}

/// Whether a node is `x - floor(x p)` or `(x + c) - floor(x p)`.
fn complement(graph: &Graph, id: NodeId) -> Option<Complement> {
    let of = |id: NodeId| &graph.nodes[id];
    // A sign bit makes no other number of an unsigned one.
    let unsigned = |id: NodeId| match of(id) {
        Node { op: Op::Cast, args, format, .. }
            if format.frac_bits == of(args[0]).format.frac_bits && format.int_bits >= of(args[0]).format.int_bits =>
        {
            args[0]
        }
        _ => id,
    };
    let node = of(id);
    if node.op != Op::Sub {
        return None;
    }
    let (minuend, floor) = (node.args[0], node.args[1]);
    let product = match of(floor) {
        Node { op: Op::Cast, args, .. } => args[0],
        _ => floor,
    };
    if of(product).op != Op::Mul || of(floor).format.frac_bits > of(product).format.frac_bits {
        return None;
    }
    let factors = [of(product).args[0], of(product).args[1]];
    let (base, added) = match of(minuend) {
        Node { op: Op::Add, args, .. } if matches!(of(args[1]).op, Op::Constant(_)) => (args[0], Some(args[1])),
        _ => (minuend, None),
    };
    let place = factors.iter().position(|&factor| unsigned(factor) == unsigned(base))?;
    let p = factors[1 - place];
    (of(p).format.frac_bits >= 0).then_some(Complement { product, x: factors[place], p, floor, added })
}
