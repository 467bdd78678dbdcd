//! The lobe in segments: the cubic's datapath with a row of coefficients for each shininess and segment.
//!
//! The segment is found from a rough `s = n u`: a few leading bits of the scaled versine times a few of n's, compared
//! with bounds that all rows share, since in s the best bounds hardly depend on n. What little the roughness moves a
//! bound is known when the coefficients are fitted: they are those of the versines that the hardware takes for a
//! segment.

use rayon::prelude::*;

use crate::datapath::builder::{Bound, Builder, Case, HighBits};
use crate::datapath::graph::NodeId;
use crate::datapath::{Architecture, Datapath, Description, Parameter, multiplier_cost};
use crate::fit::{self, Constraint, Objective, Segment};
use crate::fixed::{Format, Interval, Table, Widths, exp2};
use crate::lobe::Lobe;
use crate::method::polynomial::Polynomial;
use crate::method::polynomial::datapath::{self as polynomial, Scaling, field, nearest_code};
use crate::method::segmented::Segmented;
use crate::method::{Interface, width};
use crate::platform::error::Error;

/// Fraction bits of n's leading bits, of the versine's, and of the rough s.
const ROUGH_BITS: i32 = 9;
/// Integer bits of the rough versine: s reaches 8.4 in 8 segments, and n's leading bits are at least 1/2.
const ROUGH_INT_BITS: i32 = 5;

/// `s = v m` finds the segment; `q = A 2^-k - (a 4^-k) v`, `d = c - q v`, `y = x d` with `v = u 2^k`: three
/// multiplications, and a small one for the segment.
#[derive(Debug)]
pub struct Segments<'a> {
    interface: &'a Interface,
    /// The first code of s of each segment but the first, and the first past the last.
    bounds: Vec<i128>,
    rows: Vec<SegmentRow>,
}

/// A shininess' part in the search for the segment, and its segments.
#[derive(Clone, Debug)]
struct SegmentRow {
    /// n lies in [2^(k-1), 2^k).
    k: i32,
    /// n 2^-k as a code.
    mantissa: i128,
    /// The coefficients of each segment and the versine codes that it serves, the last included; `None` where u ends
    /// before.
    segments: Vec<Option<(Segment, [i128; 2])>>,
}

/// The memory that says where the segments of a shininess lie.
const SCALE: &str = "scale";

/// What the fit keeps.
fn constraint(interface: &Interface) -> Constraint {
    if interface.monotone { Constraint::Falling } else { Constraint::None }
}

impl<'a> Segments<'a> {
    /// For an interface of a segmented method.
    ///
    /// # Errors
    /// A shininess that the fit refuses.
    pub fn new(interface: &'a Interface, count: u32, objective: &Objective) -> Result<Self, Error> {
        let knots = interface.shininess.knots();
        let largest = knots.iter().copied().fold(1.0, f64::max);
        let constraint = constraint(interface);
        let best = fit::segment_bounds(largest, count, constraint, objective)?.coefficients;
        let mut bounds: Vec<i128> = best.iter().map(|u| nearest_code(u * largest, ROUGH_BITS)).collect();
        // For a small shininess the lobe ends before the segments do; s itself fits its bits in any case.
        let most = Format::unsigned(ROUGH_INT_BITS, ROUGH_BITS).max_code();
        bounds.iter_mut().for_each(|bound| *bound = (*bound).min(most));
        let rows = knots
            .into_par_iter()
            .map(|n| SegmentRow::of(interface, objective, &bounds, n))
            .collect::<Result<_, _>>()?;
        Ok(Self { interface, bounds, rows })
    }

    fn segments(&self) -> usize {
        self.bounds.len()
    }

    fn scaling(&self) -> Scaling {
        Scaling { k: self.rows.iter().map(|row| row.k).collect() }
    }

    /// The segments of all rows that serve any versine: the row of the coefficient ROM, and the segment.
    fn served(&self) -> impl Iterator<Item = (usize, usize, [i128; 2])> + '_ {
        self.rows.iter().enumerate().flat_map(move |(row, of)| {
            let segment = move |(index, segment): (usize, &Option<(Segment, [i128; 2])>)| {
                segment.map(|(_, versines)| (row, row * self.segments() + index, versines))
            };
            of.segments.iter().enumerate().filter_map(segment)
        })
    }

    /// The number of the segment in the graph, in as many bits as it takes, by bisection of the bounds.
    fn segment(&self, b: &mut Builder, s: NodeId) -> NodeId {
        let format = b.format(s);
        let bound = |b: &mut Builder, index: usize| {
            // `s >= bound` is `s > bound - 1`.
            b.constant(self.bounds[index] - 1, format, &format!("bound_{}", index + 1))
        };
        // For each pattern of the bits found so far the bound that is compared next.
        let levels = self.segments().trailing_zeros();
        let mut bits: Vec<NodeId> = Vec::new();
        for level in 0..levels {
            let step = self.segments() >> (level + 1);
            let mut next: Vec<NodeId> = (0..1usize << level).map(|path| bound(b, path * 2 * step + step - 1)).collect();
            for (depth, &bit) in bits.iter().enumerate().rev() {
                let name = |pair: usize| format!("bound_{level}_{depth}_{pair}");
                next = (0..next.len() / 2)
                    .map(|pair| {
                        let both = [next[2 * pair + 1], next[2 * pair]];
                        b.select(bit, both, |_| None, &name(pair), "the next bound to compare with")
                    })
                    .collect();
            }
            bits.push(b.greater(s, next[0], &format!("segment_bit_{}", levels - 1 - level), "a bit of the segment"));
        }
        bits.into_iter()
            .enumerate()
            .map(|(level, bit)| {
                let shift = levels as i32 - 1 - level as i32;
                let shifts = vec![shift; b.cases().len()];
                b.scale(bit, None, shift, &shifts, &format!("segment_part_{shift}"), "the bit at its place")
            })
            .collect::<Vec<_>>()
            .into_iter()
            .enumerate()
            .fold(None, |sum: Option<NodeId>, (level, part)| match sum {
                Some(sum) => Some(b.add(sum, part, &format!("segment_{level}"), "the number of the segment")),
                None => Some(part),
            })
            .expect("two segments or more")
    }
}

impl SegmentRow {
    fn of(interface: &Interface, objective: &Objective, bounds: &[i128], n: f64) -> Result<Self, Error> {
        let k = libm::ilogb(n) + 1;
        let mantissa = nearest_code(n * exp2(-k), ROUGH_BITS);
        let f = interface.input_fraction as i32;
        let one = 1i128 << f;
        // The hardware's s of a versine's code, or more than any bound where the rough versine overflows.
        let s = |u: i128| {
            let scaled = u << k;
            if scaled >> (f + ROUGH_INT_BITS) != 0 {
                return i128::MAX;
            }
            let (rough, bits) = if f > ROUGH_BITS { (scaled >> (f - ROUGH_BITS), ROUGH_BITS) } else { (scaled, f) };
            (rough * mantissa) >> bits
        };
        let mut segments = Vec::new();
        let mut first = 0;
        for &bound in bounds {
            // By bisection: s never falls. u = 1 belongs to none, as the lobe is 0 there.
            let (mut low, mut high) = (first, one);
            while low < high {
                let middle = (low + high) / 2;
                if s(middle) >= bound { high = middle } else { low = middle + 1 }
            }
            let end = low;
            segments.push(if end > first {
                let versine = |code: i128| code as f64 / one as f64;
                // A segment of one code still needs an interval to be fitted over.
                let to = versine(end).max(versine(first) + versine(1));
                let is_last = end == one || segments.len() + 1 == bounds.len();
                let constraint = constraint(interface).of_segment(versine(first), is_last);
                let fit = fit::fit_segment(n, versine(first), to.min(1.0), constraint, objective)?;
                Some((fit.coefficients, [first, end - 1]))
            } else {
                None
            });
            first = end;
        }
        Ok(Self { k, mantissa, segments })
    }
}

/// The codes of c, A and a, each rounded given how the one after it was: `v dA - da v^2` is least over the segment for
/// `dA = (v_0 + v_1) da`, up to a constant, which c takes up.
fn rounded([c, big_a, a]: [f64; 3], bits: [i32; 3], [low, high]: [f64; 2]) -> [i128; 3] {
    rounded_from(nearest_code(a, bits[2]), [c, big_a, a], bits, [low, high])
}

/// As [`rounded`], where the vertex of `A v - a v^2` is not to come before the segment's end: for a greater a it does.
fn rounded_falling([c, big_a, a]: [f64; 3], bits: [i32; 3], [low, high]: [f64; 2]) -> [i128; 3] {
    let nearest = nearest_code(a, bits[2]);
    let vertex_is_late = |words: &[i128; 3]| {
        let [big_a, a] = [words[1] as f64 * exp2(-bits[1]), words[2] as f64 * exp2(-bits[2])];
        big_a >= 2.0 * a * high
    };
    let mut tried = (0..=2).map(|less| rounded_from(nearest - less, [c, big_a, a], bits, [low, high]));
    tried.find(vertex_is_late).unwrap_or_else(|| rounded([c, big_a, a], bits, [low, high]))
}

/// [`rounded`], given the code of a.
fn rounded_from(code_a: i128, [c, big_a, a]: [f64; 3], bits: [i32; 3], [low, high]: [f64; 2]) -> [i128; 3] {
    let value = |code: i128, bits: i32| code as f64 * exp2(-bits);
    let delta_a = value(code_a, bits[2]) - a;
    let code_big = nearest_code(big_a + (low + high) * delta_a, bits[1]);
    let rest = value(code_big, bits[1]) - big_a - (low + high) * delta_a;
    let middle = delta_a * (low * high + (high - low) * (high - low) / 8.0) + rest * (low + high) / 2.0;
    [nearest_code(c + middle, bits[0]), code_big, code_a]
}

impl Architecture for Segments<'_> {
    fn parameters(&self) -> Vec<Parameter> {
        let (f, g) = (self.interface.input_fraction as i32, self.interface.output_fraction as i32);
        let cap = (f - self.scaling().base()).max(1);
        // q v rises with v only where v loses less to the rounding of q than q itself gives a step: at the end of a
        // segment whose parabola ends in its vertex q is to be nearly exact.
        let finest = g + if self.interface.monotone { 15 } else { 7 };
        vec![
            Parameter::new(width::C, "coefficient c, and d = c - q v", g..=g + 4),
            Parameter::new(width::BIG_A, "coefficient A 2^-k, and q = A - a v", g + 1..=finest),
            Parameter::new(width::SMALL_A, "coefficient a 4^-k", g + 1..=g + 6),
            Parameter::new(width::V, "scaled versine v = u 2^k", g..=g + 5).up_to(cap),
            Parameter::new(width::X, "cosine x", g - 1..=g + 3).up_to(f),
        ]
    }

    fn cost(&self, w: &Widths) -> f64 {
        let v = w[width::V] + 4;
        multiplier_cost(w[width::SMALL_A], v)
            + multiplier_cost(w[width::BIG_A], v)
            + multiplier_cost(w[width::X] + 1, w[width::C])
            + f64::from(w[width::C] + w[width::BIG_A] + w[width::SMALL_A])
    }

    fn tables(&self, widths: &Widths) -> Vec<Table> {
        let scaling = self.scaling();
        let mantissas: Vec<i128> = self.rows.iter().map(|row| row.mantissa).collect();
        let values = mantissas.iter().map(|&code| code as f64 * exp2(-ROUGH_BITS)).collect();
        let mut fields = vec![field("m", "n 2^-k, for the segment", ROUGH_BITS, mantissas, values)];
        fields.extend(scaling.field());
        let scale = self.interface.shininess.rom(fields, scaling.base() as u32).named(SCALE);
        let bits = [width::C, width::BIG_A, width::SMALL_A].map(|width| widths[width]);
        let lsb = exp2(-(self.interface.input_fraction as i32));
        let mut columns: [(Vec<i128>, Vec<f64>); 3] = Default::default();
        for row in &self.rows {
            for segment in &row.segments {
                let (codes, reals) = segment.map_or(([0; 3], [0.0; 3]), |(segment, versines)| {
                    let v = versines.map(|code| code as f64 * lsb * exp2(row.k));
                    let reals = [segment.c, segment.big_a * exp2(-row.k), segment.a * exp2(-2 * row.k)];
                    let rounded = if self.interface.monotone { rounded_falling } else { rounded };
                    (rounded(reals, bits, v), reals)
                });
                for ((column, code), real) in columns.iter_mut().zip(codes).zip(reals) {
                    column.0.push(code);
                    column.1.push(real);
                }
            }
        }
        let names = [
            ("c", "the coefficient c"),
            ("big_a", "the coefficient A, times 2^-k"),
            ("a", "the coefficient a, times 4^-k"),
        ];
        let fields = names
            .into_iter()
            .zip(bits)
            .zip(columns)
            .map(|(((name, meaning), bits), (codes, reals))| field(name, meaning, bits, codes, reals))
            .collect();
        let rom = Table::parts(&scale, self.segments(), fields);
        vec![scale, rom]
    }

    fn description(&self, tables: &[Table]) -> Description {
        let bounds: Vec<String> =
            self.bounds.iter().map(|&bound| (bound as f64 * exp2(-ROUGH_BITS)).to_string()).collect();
        let formula = "y = x (c - u (A - a u)) with the coefficients of the segment, 0 past the last";
        let mut description = polynomial::stable_description(formula, self.interface, tables);
        description.evaluation += &format!(
            "\nThe segments end at s = {}, where s is n u to the {ROUGH_BITS} leading bits of both: 2^-k n is the \
             field m of the\n\
             memory {SCALE}. The coefficients of segment i of a shininess are at {} times its address plus i.",
            bounds.join(", "),
            self.segments()
        );
        description
    }

    fn versines(&self, row: usize) -> Option<[i128; 2]> {
        let segment = &self.rows[row / self.segments()].segments[row % self.segments()];
        segment.map(|(_, versines)| versines)
    }

    fn lobes(&self, tables: &[Table]) -> Vec<Box<dyn Lobe>> {
        let rom = &tables[1];
        let lsb = exp2(-(self.interface.input_fraction as i32));
        let mut lobes: Vec<Segmented> = self.rows.iter().map(|_| Segmented { pieces: Vec::new() }).collect();
        for (row, at, [_, last]) in self.served() {
            let real = |name: &str| rom.field(name).reals[at];
            let k = self.rows[row].k;
            lobes[row].pieces.push(Polynomial {
                cosine: true,
                power: 1,
                c: real("c"),
                big_a: real("big_a") * exp2(k),
                a: real("a") * exp2(2 * k),
                end: last as f64 * lsb,
                past: 0.0,
            });
        }
        lobes.into_iter().map(|lobe| Box::new(lobe) as Box<dyn Lobe>).collect()
    }

    fn build(&self, widths: &Widths, tables: Vec<Table>) -> Option<Datapath> {
        let (f, g) = (self.interface.input_fraction as i32, self.interface.output_fraction as i32);
        let (scaling, rom) = (self.scaling(), &tables[1]);
        let lsb = exp2(-f);
        let cases: Vec<Case> = self
            .served()
            .map(|(row, at, [first, last])| Case {
                active: Interval::new(first as f64 * lsb, last as f64 * lsb),
                shininess: rom.keys[at],
                rows: vec![Some(row), Some(at)],
            })
            .collect();
        let rows: Vec<(usize, usize)> = self.served().map(|(row, at, _)| (row, at)).collect();
        let mut b = Builder::new(&tables, cases);
        let address = b.address(&self.interface.shininess, 0);
        let (x, u) = b.operand(self.interface);
        let mantissa = b.field(0, address, "m");
        let scaled = scaling.over_cases(b.cases()).apply(&mut b, address, u);
        let beyond = b.reaches(scaled, ROUGH_INT_BITS, "beyond", "u 2^k is past every segment");
        let rough = Format::unsigned(ROUGH_INT_BITS, ROUGH_BITS.min(b.format(scaled).frac_bits));
        let rough = b.cast(scaled, rough, HighBits::Guarded, "v_rough", "the leading bits of u 2^k");
        let s = b.mul(rough, mantissa, "s_exact", "n u, roughly");
        let s = b.cast(s, Format::unsigned(ROUGH_INT_BITS, ROUGH_BITS), HighBits::Guarded, "s", "n u, roughly");
        let last = b.constant(self.bounds[self.segments() - 1] - 1, b.format(s), "last");
        let past = b.greater(s, last, "past", "past the last segment");
        let segment = self.segment(&mut b, s);
        let address = b.part_address(address, segment, 1);
        let [c, big_a, a] = ["c", "big_a", "a"].map(|name| b.field(1, address, name));
        let ends: Vec<f64> = b.cases().iter().map(|case| case.active.high).collect();
        let shifts = scaling.over_cases(b.cases()).k;
        let v = Format::unsigned(polynomial::Ends::int_bits(&ends, &shifts), widths[width::V]);
        let v = b.cast(scaled, v, HighBits::Guarded, "v", "v = u 2^k, rounded down; wraps past the last segment");
        let av = b.mul(a, v, "av", "(a 4^-k) v");
        let r = b.floor(av, widths[width::BIG_A], "r", "(a 4^-k) v, rounded down");
        let q = b.sub(big_a, r, "q", "q = (A - a u) 2^-k");
        let vq = b.mul(v, q, "vq", "u (A - a u) = v q");
        let m = b.floor(vq, widths[width::C], "m", "u (A - a u), rounded down");
        let d = b.sub(c, m, "d", "d = c - u (A - a u)");
        // The parabola's own range: the intervals of its terms do not see that they move together.
        let word = |name: &str, at: usize| rom.field(name).value(at);
        let known: Vec<Bound> = b
            .bounds(d)
            .iter()
            .zip(b.cases())
            .zip(&rows)
            .map(|((bound, case), &(row, at))| {
                let v = case.active.scale(self.rows[row].k);
                let ideal = Interval::point(word("c", at)) - polynomial::parabola(word("big_a", at), word("a", at), v);
                Bound { range: ideal + bound.error, ..*bound }
            })
            .collect();
        b.narrow(d, known);
        let d = if b.format(d).signed { b.at_least_zero(d, "d_positive", "d, at least 0") } else { d };
        let x = b.floor(x, widths[width::X], "x_cut", "x, rounded down");
        let y = b.mul(x, d, "xd", "x d");
        let y = polynomial::pad(&mut b, y, g + 1);
        let y = b.add_half(y, g, "y_half");
        let y = b.cast(y, Format::unsigned(1, g), HighBits::Unused, "y_cut", "rounded down to the output's bits");
        // The top of a fit may lie above 1.
        let over = b.bounds(y).iter().any(|bound| bound.range.high > 1.0);
        let y = if over { b.clamp_to_unit(y, "y_unit", "at most 1") } else { y };
        let zero = b.any(&[beyond, Some(past)], "zero", "the result is 0");
        let y = b.zero_if(zero, y, "y", "y, 0 past the last segment");
        let cases: Vec<Interval> = b.cases().iter().map(|case| case.active).collect();
        let datapath = polynomial::finish(b, self.interface, &tables, y, |case| {
            let (row, at) = rows[case];
            let [c, big_a, a] = ["c", "big_a", "a"].map(|name| rom.field(name).rounding(at));
            let moved = polynomial::parabola(big_a, a, cases[case].scale(self.rows[row].k));
            let x = Interval::new(1.0 - cases[case].high, 1.0 - cases[case].low);
            (Interval::point(c) - moved) * x
        })?;
        Some(Datapath { constants: self.bounds.clone(), ..datapath })
    }
}
