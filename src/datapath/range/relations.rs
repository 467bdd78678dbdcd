//! What plain intervals do not see: values of which a graph's operations say more together than each alone.

use crate::datapath::graph::{Graph, Node, NodeId, Op};
use crate::fixed::Format;

/// What x is multiplied by in a [`Complement`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Factor {
    /// A value.
    Node(NodeId),
    /// Two to the power of minus this: a shift of the binary point.
    Power(u32),
}

/// `x - floor(x p)`, which plain intervals take for a difference of two values that have nothing to do with each other.
#[derive(Clone, Copy, Debug)]
pub(super) struct Complement {
    pub(super) product: NodeId,
    pub(super) x: NodeId,
    pub(super) p: Factor,
    /// Fraction bits of the floor.
    pub(super) floor: NodeId,
    /// What is added to x first.
    pub(super) added: Option<NodeId>,
}

/// `a + (c - a) t`, which plain intervals take for a sum of two values that have nothing to do with each other: with t
/// in [0, 1] it lies between a and c.
#[derive(Clone, Copy, Debug)]
pub(super) struct Blend {
    pub(super) a: NodeId,
    pub(super) c: NodeId,
    /// c - a.
    pub(super) apart: NodeId,
    pub(super) t: NodeId,
    /// (c - a) t.
    pub(super) part: NodeId,
}

/// A step of a restoring division: `2r - d`, of which the sign selects between `2r` and the difference. Plain intervals
/// lose that what is selected is at most d, as r was.
#[derive(Clone, Copy, Debug)]
pub(super) struct Restoring {
    pub(super) doubled: NodeId,
    pub(super) divisor: NodeId,
    /// The `2r - d` of the step before.
    pub(super) before: Option<NodeId>,
}

/// The format that a node's exact value must fit for nothing to be lost: for a cast that keeps low bits while other
/// casts of the same value take the bits above these, the format with these bits too; a cast that takes the sign as a
/// bit loses nothing, nor does one that rounds nothing of a value that another node uses whole.
pub(super) fn room(graph: &Graph, id: NodeId) -> Format {
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

/// Whether a node is an unsigned cast of a signed value, used only as what a selection takes where that value is not
/// negative.
pub(super) fn is_guarded_by_sign(graph: &Graph, id: NodeId) -> bool {
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
pub(super) fn restoring(graph: &Graph, id: NodeId) -> Option<Restoring> {
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

/// Whether a node is an unsigned cast of the `2r` of a step of a restoring division, used only as what is selected
/// where the step's difference is negative: that difference.
pub(super) fn kept_where_less(graph: &Graph, id: NodeId) -> Option<NodeId> {
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

/// Whether a node is `a + (c - a) t`.
pub(super) fn blend(graph: &Graph, id: NodeId) -> Option<Blend> {
    let of = |id: NodeId| &graph.nodes[id];
    let [a, part] = of(id).args[..] else { return None };
    if of(id).op != Op::Add || of(part).op != Op::Mul {
        return None;
    }
    let [apart, t] = of(part).args[..] else { return None };
    let is_apart = of(apart).op == Op::Sub && of(apart).args[1] == a;
    is_apart.then(|| Blend { a, c: of(apart).args[0], apart, t, part })
}

/// Whether a flag is the sign of a value.
fn takes_sign(graph: &Graph, flag: NodeId, value: NodeId) -> bool {
    graph.nodes[flag].op == Op::Cast && graph.nodes[flag].args[0] == value && room(graph, flag).signed
}

/// Whether a node is `x - floor(x p)` or `(x + c) - floor(x p)`.
pub(super) fn complement(graph: &Graph, id: NodeId) -> Option<Complement> {
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
    if of(floor).format.frac_bits > of(product).format.frac_bits {
        return None;
    }
    let (base, added) = match of(minuend) {
        Node { op: Op::Add, args, .. } if matches!(of(args[1]).op, Op::Constant(_)) => (args[0], Some(args[1])),
        _ => (minuend, None),
    };
    let is_base = |factor: NodeId| unsigned(factor) == unsigned(base);
    let (x, p) = match *of(product) {
        Node { op: Op::Mul, ref args, .. } => {
            let place = args.iter().position(|&factor| is_base(factor))?;
            let p = args[1 - place];
            (args[place], (of(p).format.frac_bits >= 0).then_some(Factor::Node(p))?)
        }
        Node { op: Op::Scale, ref args, format, .. } if is_base(args[0]) => {
            let down = u32::try_from(format.frac_bits - of(args[0]).format.frac_bits).ok()?;
            (args[0], Factor::Power(down))
        }
        _ => return None,
    };
    Some(Complement { product, x, p, floor, added })
}
