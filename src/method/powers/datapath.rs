//! The lobes that end in a power by squarings: `x (1 - K u)^2`, `(1 - u (A - a u))^k` and Lyon's `(1 - n u / k)^k`.

use crate::datapath::builder::{Bound, Builder, Case, HighBits};
use crate::datapath::graph::NodeId;
use crate::datapath::{Architecture, Datapath, Description, Parameter, multiplier_cost};
use crate::fit::Power;
use crate::fixed::{Format, Interval, Table, Widths, exp2};
use crate::lobe::Lobe;
use crate::method::polynomial::Polynomial;
use crate::method::polynomial::datapath::{self as polynomial, BIG_A, Ends, Line, SMALL_A, Scaling};
use crate::method::{Interface, width};

/// Parts of a row's versines that the analysis takes apart: near the highlight an error of p counts k times, farther
/// out the coefficients' errors grow and the power's slope falls.
const PIECES: usize = 8;

/// With the coefficients in a ROM: `p = v (A 2^-k - (a 4^-k) v)`, `w = 1 - p`, squarings of w, and a multiplication by
/// x where the lobe has that factor.
#[derive(Debug)]
pub struct Rom<'a> {
    /// What it is asked with.
    pub interface: &'a Interface,
    /// The inside of each row.
    pub rows: Vec<Power>,
    /// Whether a is 0 in all rows.
    pub linear: bool,
    /// Whether the power is multiplied by x.
    pub cosine: bool,
    /// The power that w is raised to.
    pub power: u32,
}

/// Lyon's lobe with n from the port: `p = n u / k`, `w = 1 - p`, squarings of w.
#[derive(Debug)]
pub struct Port<'a> {
    /// What it is asked with.
    pub interface: &'a Interface,
    /// k.
    pub power: u32,
}

/// The widths that squarings need, for a power and a factor x.
fn parameters_of_power(interface: &Interface, power: u32, cosine: bool) -> Vec<Parameter> {
    let (f, g) = (interface.input_fraction as i32, interface.output_fraction as i32);
    let gain = power.trailing_zeros() as i32;
    let mut parameters = vec![Parameter::new(width::P, "p, and the base w = 1 - p", g - 1 + gain..=g + 4 + gain)];
    if power > 2 || cosine {
        parameters.push(Parameter::new(width::S, "squares of w", g - 1..=g + 4 + gain));
    }
    if cosine {
        parameters.push(Parameter::new(width::X, "cosine x", g - 1..=g + 4).up_to(f));
    }
    parameters
}

fn cost_of_power(w: &Widths, power: u32, cosine: bool) -> f64 {
    let p = w[width::P] + 1;
    let s = if power > 2 || cosine { w[width::S] + 1 } else { p };
    multiplier_cost(p, p)
        + f64::from(power.trailing_zeros() - 1) * multiplier_cost(s, s)
        + if cosine { multiplier_cost(w[width::X] + 1, s) } else { 0.0 }
        + f64::from(p + s)
}

/// From the exact p to the output: `(1 - p)^power`, times x where one is given, rounded to nearest; 0 where `zero` or p
/// >= 1, and where the surface faces away.
fn output_of_power(
    b: &mut Builder,
    interface: &Interface,
    widths: &Widths,
    (p_exact, u): (NodeId, NodeId),
    power: u32,
    x: Option<NodeId>,
    zero: Option<NodeId>,
) -> NodeId {
    let g = interface.output_fraction as i32;
    // A coefficient below 0 cannot make p fall below it by more than roundings: what lies below counts as 0.
    let p_exact =
        if b.format(p_exact).signed { b.at_least_zero(p_exact, "p_positive", "p, at least 0") } else { p_exact };
    let ended: Vec<bool> = b.bounds(p_exact).iter().map(|bound| bound.range.high >= 1.0).collect();
    let above = b.reaches(p_exact, 0, "p_above", "the integer bits of p: the lobe is 0 from p = 1 on");
    let p = b.cast(p_exact, Format::unsigned(0, widths[width::P]), HighBits::Guarded, "p", "p, rounded down");
    let one = b.constant(1 << widths[width::P], Format::unsigned(1, widths[width::P]), "one_of_p");
    let mut base = b.sub(one, p, "w", "w = 1 - p");
    // Where p reaches 1 the hardware's w is 0 by the flag.
    let bounds = b.bounds(base).to_vec().into_iter().zip(&ended);
    let bounds = bounds.map(|(bound, &ended)| {
        let range = if ended { bound.range.hull(Interval::ZERO) } else { bound.range };
        Bound { range: range.clip(0.0, 1.0), ..bound }
    });
    let bounds = bounds.collect();
    b.assume(base, bounds);
    let mut level = 1;
    while level < power {
        if level > 1 {
            base = b.floor(base, widths[width::S], &format!("w{level}_cut"), &format!("w^{level}, rounded down"));
        }
        level *= 2;
        base = b.mul(base, base, &format!("w{level}"), &format!("w^{level}"));
    }
    if let Some(x) = x {
        let square = b.floor(base, widths[width::S], &format!("w{level}_cut"), &format!("w^{level}, rounded down"));
        let x = b.floor(x, widths[width::X], "x_cut", "x, rounded down");
        base = b.mul(x, square, "xw", "x w^2");
    }
    let y = polynomial::pad(b, base, g + 1);
    let y = b.add_half(y, g, "y_half");
    let y = b.cast(y, Format::unsigned(1, g), HighBits::Unused, "y_cut", "rounded down to the output's bits");
    let zero = b.any(&[zero, above], "zero", "the result is 0");
    let y = b.zero_if(zero, y, "y", "y, 0 where the lobe has ended");
    if x.is_some() { y } else { polynomial::lit(b, u, y) }
}

impl Rom<'_> {
    fn lines(&self, of: impl Fn(&Power) -> f64) -> Vec<Line> {
        let values: Vec<f64> = self.rows.iter().map(of).collect();
        Line::through(self.interface, &values)
    }

    fn scaling(&self, frac_bits: i32) -> Scaling {
        Scaling::of(self.lines(|row| row.big_a).into_iter().map(|line| line.range().low), frac_bits)
    }

    /// Where a quadratic inside ends: at its first zero, or at its minimum.
    fn ends(&self) -> Option<Ends> {
        let end = |row: &Power| {
            let root = libm::sqrt(row.big_a * row.big_a - 4.0 * row.a);
            let (zero, vertex) = (2.0 / (row.big_a + root), row.big_a / (2.0 * row.a));
            // With no real root the zero is not a number.
            [zero, vertex].into_iter().find(|&end| end > 0.0).filter(|&end| end < 1.0)
        };
        (!self.linear).then(|| Ends::of(self.interface, self.rows.iter().map(end)))
    }

    /// The last versine of each row at which something other than 0 may come out.
    fn active(&self, widths: &Widths, table: &Table, scaling: &Scaling) -> Vec<f64> {
        if !self.linear {
            return Ends::in_words(self.interface, table);
        }
        let end = |row: usize| {
            let [real, word] = polynomial::lines_of(table, BIG_A, row).map(|line| line.range().low);
            let zero = 1.0 / (real.min(word) * exp2(scaling.k[row])).max(1.0);
            // Just past the zero p may still be below 1, since v is rounded down.
            let past = zero + exp2(-scaling.k[row] - widths[width::V]);
            polynomial::below_one(self.interface, past.min(exp2(1 - scaling.k[row])))
        };
        (0..table.rows()).map(end).collect()
    }
}

impl Architecture for Rom<'_> {
    fn parameters(&self) -> Vec<Parameter> {
        let (f, g) = (self.interface.input_fraction as i32, self.interface.output_fraction as i32);
        let gain = self.power.trailing_zeros() as i32 - i32::from(self.cosine);
        let cap = (f - self.scaling(g + 6 + gain).base()).max(1);
        let (low, high) = (g - 1 + gain, g + 5 + gain);
        let meaning = if self.linear { "coefficient A 2^-k" } else { "coefficient A 2^-k, and q = A - a v" };
        let mut parameters = vec![Parameter::new(width::BIG_A, meaning, low..=high)];
        if !self.linear {
            parameters.push(Parameter::new(width::SMALL_A, "coefficient a 4^-k", low..=high));
        }
        parameters.push(Parameter::new(width::V, "scaled versine v = u 2^k", low..=high).up_to(cap));
        parameters.extend(parameters_of_power(self.interface, self.power, self.cosine));
        parameters
    }

    fn finest(&self) -> Vec<Parameter> {
        let (f, g) = (self.interface.input_fraction as i32, self.interface.output_fraction as i32);
        if !self.interface.monotone || f <= g + 2 {
            return Vec::new();
        }
        let gain = self.power.trailing_zeros() as i32;
        let refined = |parameter: Parameter| {
            let range = match parameter.width {
                // Every step of a fine input is one of x and of v, too, so that none of them goes alone.
                width::V => *parameter.range.end()..=f.max(*parameter.range.end()),
                width::X => f..=f,
                _ => *parameter.range.end()..=f + 4 + gain,
            };
            Parameter { range, ..parameter }
        };
        self.parameters().into_iter().map(refined).collect()
    }

    fn cost(&self, w: &Widths) -> f64 {
        let v = w[width::V] + 1;
        let inner = if self.linear {
            multiplier_cost(w[width::BIG_A], v) + f64::from(w[width::BIG_A])
        } else {
            multiplier_cost(w[width::SMALL_A], v)
                + multiplier_cost(w[width::BIG_A], v)
                + f64::from(w[width::SMALL_A] + w[width::BIG_A])
        };
        inner + f64::from(v) + cost_of_power(w, self.power, self.cosine)
    }

    fn tables(&self, widths: &Widths) -> Vec<Table> {
        let bits = widths[width::BIG_A];
        let scaling = self.scaling(bits);
        let lines = scaling.lines(&self.lines(|row| row.big_a), 1);
        let meanings = ["the coefficient A, times 2^-k", "its step to the next row"];
        let mut fields = polynomial::line_fields(self.interface, BIG_A, meanings, bits, &lines);
        if !self.linear {
            let lines = scaling.lines(&self.lines(|row| row.a), 2);
            let meanings = ["the coefficient a, times 4^-k", "its step to the next row"];
            fields.extend(polynomial::line_fields(self.interface, SMALL_A, meanings, widths[width::SMALL_A], &lines));
        }
        fields.extend(scaling.field());
        fields.extend(self.ends().and_then(|ends| ends.field(self.interface)));
        vec![self.interface.shininess.rom(fields, scaling.base() as u32)]
    }

    fn description(&self, tables: &[Table]) -> Description {
        let (power, inner) = (self.power, if self.linear { "A u" } else { "u (A - a u)" });
        let formula = match (self.cosine, self.linear) {
            (true, _) => "y = x max(0, 1 - K u)^2, with A = K".to_owned(),
            (false, true) => format!("y = max(0, 1 - {inner})^{power}; 0 at x = 0"),
            (false, false) => {
                format!("y = (1 - {inner})^{power} up to the base's first zero or its minimum, 0 past it; 0 at x = 0")
            }
        };
        let mut description = polynomial::stable_description(&formula, self.interface, tables);
        description.evaluation += " The power is taken by squarings.";
        description
    }

    fn lobes(&self, tables: &[Table]) -> Vec<Box<dyn Lobe>> {
        let table = &tables[0];
        let [big_a, a] = [(BIG_A, 1), (SMALL_A, 2)]
            .map(|(names, power)| polynomial::real_coefficients(self.interface, table, names, power));
        let ends = Ends::in_reals(table);
        let lobe = |place: usize| Polynomial {
            cosine: self.cosine,
            power: self.power,
            c: 1.0,
            big_a: big_a[place],
            a: a[place],
            end: ends[self.interface.shininess.knot(place).0],
            past: 0.0,
        };
        (0..big_a.len()).map(|place| Box::new(lobe(place)) as Box<dyn Lobe>).collect()
    }

    fn build(&self, widths: &Widths, tables: Vec<Table>) -> Option<Datapath> {
        let scaling = self.scaling(widths[width::BIG_A]);
        let table = &tables[0];
        let ends = self.active(widths, table, &scaling);
        let mut cases = Vec::new();
        for case in Case::of_rows(table, &ends) {
            let at = |piece: usize| case.active.high * piece as f64 / PIECES as f64;
            cases.extend((0..PIECES).map(|i| Case { active: Interval::new(at(i), at(i + 1)), ..case.clone() }));
        }
        let mut b = Builder::new(&tables, cases);
        let address = polynomial::address(&mut b, self.interface, 0);
        let (x, u) = b.operand(self.interface);
        let big_a = polynomial::coefficient(&mut b, address, BIG_A);
        let past_cut = Ends::flag(&mut b, self.interface, table, address.0, u);
        let scaled = scaling.over_cases(b.cases()).apply(&mut b, address.0, u);
        let (beyond, int_bits) = if self.linear {
            (b.reaches(scaled, 1, "beyond", "u 2^k >= 2: then A u >= 1, since A 2^-k >= 1/2"), 1)
        } else {
            (None, Ends::int_bits(&ends, &scaling.k))
        };
        let v = Format::unsigned(int_bits, widths[width::V]);
        let v = b.cast(scaled, v, HighBits::Guarded, "v", "v = u 2^k, rounded down");
        let p = if self.linear {
            b.mul(big_a, v, "Av", "A u = (A 2^-k) v")
        } else {
            let a = polynomial::coefficient(&mut b, address, SMALL_A);
            let av = b.mul(a, v, "av", "(a 4^-k) v");
            let r = b.floor(av, widths[width::BIG_A], "r", "(a 4^-k) v, rounded down");
            let q = b.sub(big_a, r, "q", "q = (A - a u) 2^-k; wraps past the cut");
            b.mul(v, q, "vq", "u (A - a u) = v q")
        };
        let zero = b.any(&[beyond, past_cut], "past", "past the end of the lobe");
        let x = self.cosine.then_some(x);
        let y = output_of_power(&mut b, self.interface, widths, (p, u), self.power, x, zero);
        let active: Vec<Interval> = b.cases().iter().map(|case| case.active).collect();
        polynomial::finish(b, self.interface, &tables, y, |case| {
            let (row, v) = (case / PIECES, active[case].scale(scaling.k[case / PIECES]));
            // By the mean value theorem: -k w^(k-1) times what the words add to p, w between the real and the words'
            // one.
            let [delta_big, delta_small] = [BIG_A, SMALL_A].map(|names| polynomial::delta(table, names, row));
            let moved = v * (delta_big - delta_small * v);
            let [real, _] = polynomial::lines_of(table, BIG_A, row);
            let [small, _] = polynomial::lines_of(table, SMALL_A, row);
            let p = v * (real.range() - small.range() * v);
            let base = (Interval::point(1.0) - p + moved.hull(-moved)).clip(0.0, 1.0);
            let slope = (1..self.power).fold(Interval::point(f64::from(self.power)), |slope, _| slope * base);
            -(moved * slope)
        })
    }
}

impl Port<'_> {
    /// The bits of n.
    fn index_bits(&self) -> i32 {
        self.interface.shininess.index_bits() as i32
    }
}

impl Architecture for Port<'_> {
    fn parameters(&self) -> Vec<Parameter> {
        parameters_of_power(self.interface, self.power, false)
    }

    fn cost(&self, w: &Widths) -> f64 {
        multiplier_cost(self.index_bits(), self.interface.input_fraction as i32 + 1)
            + cost_of_power(w, self.power, false)
    }

    fn tables(&self, _widths: &Widths) -> Vec<Table> {
        Vec::new()
    }

    fn description(&self, _tables: &[Table]) -> Description {
        let k = self.power;
        Description {
            formula: format!("y = max(0, 1 - n u/{k})^{k}; 0 at x = 0"),
            evaluation:
                "n is multiplied as the port gives it, taken into the range; the power is taken by squarings.\n\
                         The result is rounded to nearest."
                    .to_owned(),
        }
    }

    fn lobes(&self, _tables: &[Table]) -> Vec<Box<dyn Lobe>> {
        let lobe = |n: f64| Polynomial {
            cosine: false,
            power: self.power,
            c: 1.0,
            big_a: n / f64::from(self.power),
            a: 0.0,
            end: 1.0,
            past: 0.0,
        };
        self.interface.shininess.values().into_iter().map(|n| Box::new(lobe(n)) as Box<dyn Lobe>).collect()
    }

    fn build(&self, widths: &Widths, tables: Vec<Table>) -> Option<Datapath> {
        let set = &self.interface.shininess;
        let n = set.value(set.rows() - 1);
        // Every p from 0 to 1, in parts.
        let at = |piece: usize| piece as f64 / PIECES as f64;
        let case = Case {
            active: Interval::new(0.0, polynomial::below_one(self.interface, 1.0)),
            shininess: n,
            rows: Vec::new(),
        };
        let mut b = Builder::new(&tables, vec![case; PIECES]);
        let port = b.index(set);
        let (_, u) = b.operand(self.interface);
        let n = if set.is_at_port() { b.clamped_index(set, port) } else { port };
        let product = b.mul(n, u, "nu", "n u");
        let log2_k = self.power.trailing_zeros() as i32;
        let shifts = vec![-log2_k; PIECES];
        let p = b.scale(product, None, -log2_k, &shifts, "p_exact", "n u / k");
        let whole: Vec<Bound> = b.bounds(p).to_vec();
        let piece = |(piece, bound): (usize, Bound)| Bound {
            range: Interval::new(at(piece), if piece + 1 < PIECES { at(piece + 1) } else { bound.range.high.max(1.0) }),
            ..bound
        };
        let bounds = whole.into_iter().enumerate().map(piece).collect();
        b.assume(p, bounds);
        let y = output_of_power(&mut b, self.interface, widths, (p, u), self.power, None, None);
        polynomial::finish(b, self.interface, &tables, y, |_| Interval::ZERO)
    }
}
