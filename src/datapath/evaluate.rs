//! The function of a graph, many inputs at a time.
//!
//! A vectorised evaluator for exhaustive work: for one shininess, what depends on it alone is computed once, and
//! the rest is done a column of inputs at a time, one simple loop an operation, which the compiler turns into vector
//! instructions. Columns hold 64-bit integers, or 128-bit ones where a value of the graph needs them.

use multiversion::multiversion;
use num_traits::{PrimInt, WrappingAdd, WrappingMul, WrappingShl, WrappingShr, WrappingSub};

use super::graph::{Graph, Node, NodeId, Op};
use crate::fixed::{Format, Table};

/// Inputs of a column: small enough for all columns of a core to stay in the first-level cache.
pub(crate) const LANES: usize = 64;

/// An argument of a step: the same for all lanes, or a column.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Arg {
    Uniform(i128),
    Column(NodeId),
}

/// A graph prepared for evaluation.
#[derive(Clone, Debug)]
pub struct Evaluator<'a> {
    graph: &'a Graph,
    tables: &'a [Table],
    /// For each node whether it depends on a port other than the first, a lobe's `in_n`.
    varies: Vec<bool>,
    /// The codes by address of each field that is read at an address that varies.
    looked_up: Vec<Vec<i128>>,
    narrow: bool,
}

impl<'a> Evaluator<'a> {
    /// Prepares a graph.
    #[must_use]
    pub fn new(graph: &'a Graph, tables: &'a [Table]) -> Self {
        let mut varies: Vec<bool> = Vec::new();
        for (id, node) in graph.nodes.iter().enumerate() {
            let own = node.op == Op::Input && graph.port(id) > 0;
            // What every address of a memory holds does not depend on the address.
            let same = matches!(node.op, Op::Field { memory, .. } if tables[memory].rows() == 1);
            varies.push(own || (!same && node.args.iter().any(|&arg| varies[arg])));
        }
        let codes = |(node, &varies): (&Node, &bool)| if varies { codes_by_address(node, tables) } else { Vec::new() };
        let looked_up = graph.nodes.iter().zip(&varies).map(codes).collect();
        Self { graph, tables, varies, looked_up, narrow: is_narrow(graph) }
    }

    /// Writes the codes of `out_spec` for the `in_n` code `index` and the operand codes `first`, `first + stride`, ...
    pub fn evaluate(&self, index: u32, first: i64, stride: i64, out: &mut [u32]) {
        let uniform = self.uniform_values(index);
        if self.narrow {
            run_narrow(self, &uniform, first, stride, out);
        } else {
            run::<i128>(self, &uniform, first, stride, out);
        }
    }

    fn uniform_values(&self, index: u32) -> Vec<i128> {
        let mut values: Vec<i128> = Vec::with_capacity(self.varies.len());
        for (id, node) in self.graph.nodes.iter().enumerate() {
            let value = match node.op {
                _ if self.varies[id] => 0,
                Op::Input => index.into(),
                Op::Field { memory, field } => self.tables[memory].code_at(field, values[node.args[0]] as usize),
                _ => {
                    let args: Vec<i128> = node.args.iter().map(|&arg| values[arg]).collect();
                    self.graph.apply(id, &args)
                }
            };
            values.push(value);
        }
        values
    }
}

/// The codes of the field that a node reads, by address; none for any other node.
pub(crate) fn codes_by_address(node: &Node, tables: &[Table]) -> Vec<i128> {
    match node.op {
        Op::Field { memory, field } => {
            let table = &tables[memory];
            (0..table.depth()).map(|address| table.code_at(field, address)).collect()
        }
        _ => Vec::new(),
    }
}

/// Whether 64 bits are enough for every operation of a graph.
pub(crate) fn is_narrow(graph: &Graph) -> bool {
    // Aligning and shifting happen before a result is taken into its format: leave a bit for the carry.
    graph.nodes.iter().all(|node| node.format.width() <= 62)
}

#[multiversion(targets("x86_64+avx512f+avx512bw+avx512dq+avx512vl", "x86_64+avx2", "x86_64+sse4.1", "aarch64+neon"))]
fn run_narrow(evaluator: &Evaluator, uniform: &[i128], first: i64, stride: i64, out: &mut [u32]) {
    run::<i64>(evaluator, uniform, first, stride, out);
}

/// An integer that holds codes. Its operations wrap: the formats of a graph are proved to hold every value, so that
/// nothing wraps unless a fault is in it, and a check of each lane for overflow, as builds for tests have it, would
/// keep the compiler from vector instructions.
pub(crate) trait Lane: PrimInt + WrappingAdd + WrappingMul + WrappingShl + WrappingShr + WrappingSub {
    fn from_code(code: i128) -> Self;
    fn to_output(self) -> u32;
    /// The code that it holds.
    fn to_code(self) -> i128;
    /// Half of the lane's bits.
    const HALF: u32;
    /// The product of two numbers of at most [`Lane::HALF`] bits each, sign included: one multiplication of the
    /// machine.
    fn mul_narrow(self, other: Self) -> Self;
}

macro_rules! lane {
    ($lane:ty, of halves of $half:ty) => {
        impl Lane for $lane {
            const HALF: u32 = <$half>::BITS;
            #[inline(always)]
            fn from_code(code: i128) -> Self {
                code as Self
            }
            #[inline(always)]
            fn to_output(self) -> u32 {
                self as u32
            }
            #[inline(always)]
            fn to_code(self) -> i128 {
                self.into()
            }
            #[inline(always)]
            fn mul_narrow(self, other: Self) -> Self {
                Self::from(self as $half).wrapping_mul(Self::from(other as $half))
            }
        }
    };
}
lane!(i64, of halves of i32);
lane!(i128, of halves of i64);

#[inline(always)]
fn run<L: Lane>(evaluator: &Evaluator, uniform: &[i128], first: i64, stride: i64, out: &mut [u32]) {
    let graph = evaluator.graph;
    let mut columns = vec![[L::zero(); LANES]; graph.nodes.len()];
    let mut start = first;
    for block in out.chunks_mut(LANES) {
        for (id, node) in graph.nodes.iter().enumerate() {
            if !evaluator.varies[id] {
                continue;
            }
            let (before, rest) = columns.split_at_mut(id);
            let result = &mut rest[0];
            let arg = |index: usize| {
                let id = node.args[index];
                if evaluator.varies[id] { Arg::Column(id) } else { Arg::Uniform(uniform[id]) }
            };
            match node.op {
                Op::Input => {
                    for (lane, value) in result.iter_mut().enumerate() {
                        *value = L::from_code(start.wrapping_add(stride.wrapping_mul(lane as i64)).into());
                    }
                }
                _ => step(graph, node, &evaluator.looked_up[id], arg, before, result),
            }
        }
        let output = graph.output();
        if evaluator.varies[output] {
            for (to, from) in block.iter_mut().zip(&columns[output]) {
                *to = from.to_output();
            }
        } else {
            block.fill(uniform[output] as u32);
        }
        start += stride * LANES as i64;
    }
}

/// The values of a node for a column of inputs, given its arguments'; `codes` are those of the field that it reads, by
/// address. A port or a constant is not computed.
#[inline(always)]
pub(crate) fn step<L: Lane>(
    graph: &Graph,
    node: &Node,
    codes: &[i128],
    arg: impl Fn(usize) -> Arg,
    before: &[[L; LANES]],
    result: &mut [L; LANES],
) {
    let frac = |index: usize| graph.nodes[node.args[index]].format.frac_bits;
    let align = |index: usize| {
        let shift = node.format.frac_bits - frac(index);
        debug_assert!((0..2 * L::HALF as i32).contains(&shift), "an argument that cannot be aligned");
        shift as u32
    };
    match node.op {
        Op::Clamp { low, high } => {
            let (low, high) = (L::from_code(low), L::from_code(high));
            map(result, before, arg(0), |a| a.max(low).min(high));
        }
        Op::Add => {
            let (sa, sb) = (align(0), align(1));
            zip(result, before, arg(0), arg(1), |a: L, b: L| a.wrapping_shl(sa).wrapping_add(&b.wrapping_shl(sb)));
            wrap(result, node.format);
        }
        Op::Sub => {
            let (sa, sb) = (align(0), align(1));
            zip(result, before, arg(0), arg(1), |a: L, b: L| a.wrapping_shl(sa).wrapping_sub(&b.wrapping_shl(sb)));
            wrap(result, node.format);
        }
        Op::Mul => {
            let width = |index: usize| {
                let format = graph.nodes[node.args[index]].format;
                format.width() + u32::from(!format.signed)
            };
            if width(0) <= L::HALF && width(1) <= L::HALF {
                zip(result, before, arg(0), arg(1), L::mul_narrow);
            } else {
                // A product that a fault makes longer than its format keeps its low bits.
                zip(result, before, arg(0), arg(1), |a, b| a.wrapping_mul(&b));
            }
        }
        Op::ShiftLeft => {
            if fits_shift::<L>(graph, node) {
                zip(result, before, arg(0), arg(1), |a: L, b: L| a.wrapping_shl(b.to_output()));
            } else {
                let most = 2 * L::HALF - 1;
                let shift = |a: L, b: L| if b.to_output() > most { L::zero() } else { a.wrapping_shl(b.to_output()) };
                zip(result, before, arg(0), arg(1), shift);
            }
            wrap(result, node.format);
        }
        Op::ShiftRight if fits_shift::<L>(graph, node) => {
            zip(result, before, arg(0), arg(1), |a: L, b: L| a.wrapping_shr(b.to_output()));
        }
        Op::ShiftRight => {
            let most = 2 * L::HALF - 1;
            zip(result, before, arg(0), arg(1), |a: L, b: L| a.wrapping_shr(b.to_output().min(most)));
        }
        Op::Field { .. } => map(result, before, arg(0), |address| L::from_code(codes[address.to_output() as usize])),
        Op::Cast if node.format.frac_bits >= frac(0) => {
            let shift = align(0);
            map(result, before, arg(0), |a: L| a.wrapping_shl(shift));
            wrap(result, node.format);
        }
        Op::Cast => {
            let shift = (frac(0) - node.format.frac_bits) as u32;
            map(result, before, arg(0), |a: L| a.wrapping_shr(shift));
            wrap(result, node.format);
        }
        Op::Scale => map(result, before, arg(0), |a| a),
        Op::NonZero => map(result, before, arg(0), |a| if a == L::zero() { L::zero() } else { L::one() }),
        Op::Greater => zip(result, before, arg(0), arg(1), |a, b| if a > b { L::one() } else { L::zero() }),
        Op::Or => zip(result, before, arg(0), arg(1), |a, b| a | b),
        Op::Not => map(result, before, arg(0), |a: L| L::one().wrapping_sub(&a)),
        Op::ZeroIf => zip(result, before, arg(0), arg(1), |flag: L, a| flag.wrapping_sub(&L::one()) & a),
        Op::Select => select(result, before, [arg(0), arg(1), arg(2)]),
        Op::Input | Op::Constant(_) => {}
    }
}

/// Whether a lane can be shifted by every amount that a shift's argument may hold.
fn fits_shift<L: Lane>(graph: &Graph, node: &Node) -> bool {
    graph.nodes[node.args[1]].format.max_code() < i128::from(2 * L::HALF)
}

#[inline(always)]
fn select<L: Lane>(result: &mut [L; LANES], columns: &[[L; LANES]], [flag, a, b]: [Arg; 3]) {
    let mut second = [L::zero(); LANES];
    map(&mut second, columns, b, |b| b);
    zip(result, columns, flag, a, |flag: L, a| L::zero().wrapping_sub(&flag) & a);
    let mut rest = [L::zero(); LANES];
    map(&mut rest, columns, flag, |flag: L| flag.wrapping_sub(&L::one()));
    for ((result, second), keep) in result.iter_mut().zip(second).zip(rest) {
        *result = *result | (second & keep);
    }
}

#[inline(always)]
fn map<L: Lane>(result: &mut [L; LANES], columns: &[[L; LANES]], a: Arg, f: impl Fn(L) -> L) {
    match a {
        Arg::Uniform(a) => result.fill(f(L::from_code(a))),
        Arg::Column(a) => {
            for (result, &a) in result.iter_mut().zip(&columns[a]) {
                *result = f(a);
            }
        }
    }
}

#[inline(always)]
fn zip<L: Lane>(result: &mut [L; LANES], columns: &[[L; LANES]], a: Arg, b: Arg, f: impl Fn(L, L) -> L) {
    match (a, b) {
        (Arg::Uniform(a), b) => {
            let a = L::from_code(a);
            map(result, columns, b, |b| f(a, b));
        }
        (a, Arg::Uniform(b)) => {
            let b = L::from_code(b);
            map(result, columns, a, |a| f(a, b));
        }
        (Arg::Column(a), Arg::Column(b)) => {
            for ((result, &a), &b) in result.iter_mut().zip(&columns[a]).zip(&columns[b]) {
                *result = f(a, b);
            }
        }
    }
}

/// Takes codes into a format.
#[inline(always)]
pub(crate) fn wrap<L: Lane>(result: &mut [L; LANES], format: Format) {
    if format.signed {
        let spare = 2 * L::HALF - format.width();
        for value in result {
            *value = value.wrapping_shl(spare).wrapping_shr(spare);
        }
    } else {
        let mask = L::from_code(format.max_code());
        for value in result {
            *value = *value & mask;
        }
    }
}
