//! The cubic lobe with a rational tail, `x / (d + b u)` past the point of contact.

use rayon::prelude::*;

use crate::datapath::builder::{Bound, Builder, Case, HighBits};
use crate::datapath::{Architecture, Datapath, Description, Parameter, multiplier_cost, widths};
use crate::fixed::{Format, Interval, Table, Width, Widths, exp2};
use crate::lobe::Lobe;
use crate::method::cubic::datapath as cubic;
use crate::method::divide::Divider;
use crate::method::divide::datapath as divide;
use crate::method::polynomial::datapath::{self as polynomial, field, nearest_code};
use crate::method::{Check, Interface, Operand, width};

/// The tail's slope b.
const B: Width = Width("b");

/// Both branches side by side: the cubic in three multiplications, and `x / (d + b u)` in one and a division. A
/// comparison of the versine with the ROM's field `cut` chooses between the two.
#[derive(Debug)]
pub struct Rational<'a> {
    interface: &'a Interface,
    divider: Divider,
    q: f64,
    lobes: Vec<super::CubicRational>,
    /// The code of the greatest versine of each row that belongs to the cubic.
    cuts: Vec<i128>,
    /// The cubic up to there.
    cubic: cubic::Stable<'a>,
}

/// The ROM's coefficients of a row's tail.
#[derive(Clone, Copy, Debug)]
struct TailCodes {
    b: i128,
    d: i128,
    /// The least d for which the denominator is large enough.
    least: i128,
}

/// What rounding moves the coefficients of a tail by.
#[derive(Clone, Copy, Debug)]
struct Moved {
    b: f64,
    d: f64,
}

impl<'a> Rational<'a> {
    /// These lobes, whose cubic is left at the level `q`.
    pub fn new(interface: &'a Interface, divider: Divider, q: f64, lobes: Vec<super::CubicRational>) -> Self {
        let one = exp2(interface.input_fraction as i32);
        let cuts: Vec<i128> = lobes.iter().map(|lobe| libm::floor(lobe.cusp * one).min(one - 1.0) as i128).collect();
        let cubics = lobes.iter().map(|lobe| lobe.cubic).collect();
        let cubic = cubic::Stable::up_to(interface, cubics, lobes.iter().map(|lobe| lobe.cusp));
        Self { interface, divider, q, lobes, cuts, cubic }
    }

    /// The versines of a row's tail: from the first code past the cubic's.
    fn tail(&self, row: usize) -> Interval {
        Interval::new((self.cuts[row] + 1) as f64 * exp2(-(self.interface.input_fraction as i32)), 1.0)
    }

    /// The greatest versine of each row that belongs to the cubic.
    fn ends(&self) -> Vec<f64> {
        self.cuts.iter().map(|&cut| cut as f64 * exp2(-(self.interface.input_fraction as i32))).collect()
    }

    /// The largest k for which the tail, at most Q, is at most 2^-k; only the digits of a quotient gain by it.
    fn most(&self) -> i32 {
        match self.divider {
            Divider::Digit => (0..).take_while(|&k| self.q <= exp2(-k)).last().unwrap_or(0),
            Divider::Reciprocal => 0,
        }
    }

    /// The fraction bits with which every b is exact, or as many as any core may need; below 0 where all are even.
    fn exact_bits(&self) -> i32 {
        let exact = |bits: i32| self.lobes.iter().all(|lobe| (lobe.b * exp2(bits)).fract() == 0.0);
        (-4..24).find(|&bits| exact(bits)).unwrap_or(24)
    }

    /// The codes of b and d of a row; of d the nearest one that the divider bears, and the least one that it does.
    fn tail_codes(&self, row: usize, widths: &Widths) -> TailCodes {
        let (lobe, f) = (&self.lobes[row], self.interface.input_fraction as i32);
        let [b_bits, den_bits, num_bits] = [B, width::DEN, width::NUM].map(|width| widths[width]);
        let b = nearest_code(lobe.b, b_bits);
        let u = self.cuts[row] + 1;
        let rise = shifted_down(b * u, b_bits + f - den_bits);
        // At the tail's first versine, and so at all of them, the denominator is at least 1 and 2^most times the
        // numerator, in the hardware too.
        let num = shifted_down((1i128 << f) - u, f - num_bits);
        let needed = -shifted_down(-(num << self.most()), num_bits - den_bits);
        let least = needed.max(1 << den_bits) - rise;
        TailCodes { b, d: nearest_code(lobe.d, den_bits).max(least), least }
    }

    /// The memories with these coefficients of the tails.
    fn with_tails(&self, widths: &Widths, tails: &[TailCodes]) -> Vec<Table> {
        let codes = |of: fn(&TailCodes) -> i128| tails.iter().map(of).collect();
        let reals = |of: fn(&super::CubicRational) -> f64| self.lobes.iter().map(of).collect();
        let mut fields = self.cubic.fields(widths);
        fields.extend([
            field("b", "the tail's slope b", widths[B], codes(|tail| tail.b), reals(|lobe| lobe.b)),
            field("d", "the tail's constant d", widths[width::DEN], codes(|tail| tail.d), reals(|lobe| lobe.d)),
            field(
                "cut",
                "the largest versine of the cubic",
                self.interface.input_fraction as i32,
                self.cuts.clone(),
                reals(|lobe| lobe.cusp),
            ),
        ]);
        let rom = self.interface.shininess.rom(fields, self.cubic.scaling(widths).base() as u32);
        [rom].into_iter().chain(divide::table(self.divider, widths)).collect()
    }

    /// The hardware's step from a row's last versine of the cubic to the next one, less the method's step, in output
    /// ulps.
    fn seam(&self, datapath: &Datapath, row: usize) -> f64 {
        let one = 1i128 << self.interface.input_fraction;
        let index = i128::from(self.interface.shininess.index_of_row(row));
        let error = |versine: i128| {
            let operand = match self.interface.operand {
                Operand::Cos => one - versine,
                Operand::Versine => versine,
            };
            let value = datapath.graph.values(&datapath.tables, &[index, operand])[datapath.graph.output()];
            let method = self.lobes[row].at(versine as f64 / one as f64);
            value as f64 - method * exp2(self.interface.output_fraction as i32)
        };
        error(self.cuts[row] + 1) - error(self.cuts[row])
    }

    /// Moves d of the rows whose seam is off by more than an output ulp until it is not: two values within an ulp of
    /// the method can be off by nearly two from each other.
    fn close_seams(&self, widths: &Widths, tails: &mut [TailCodes]) {
        let Some(mut datapath) = self.build(widths, self.with_tails(widths, tails)) else { return };
        let open = |datapath: &Datapath, row: &usize| self.seam(datapath, *row).abs() > 1.0;
        let mut rows: Vec<usize> = (0..tails.len()).into_par_iter().filter(|row| open(&datapath, row)).collect();
        // Half an output ulp is twice to four times as much in the denominator.
        let furthest = 1i128 << (widths[width::DEN] - self.interface.output_fraction as i32 + 2).clamp(0, 6);
        for by in (1..=furthest).flat_map(|by| [by, -by]) {
            if rows.is_empty() {
                return;
            }
            let mut moved = tails.to_vec();
            for &row in &rows {
                moved[row].d = (moved[row].d + by).max(moved[row].least);
            }
            datapath.tables = self.with_tails(widths, &moved);
            rows.retain(|row| {
                let still = open(&datapath, row);
                if !still {
                    tails[*row] = moved[*row];
                }
                still
            });
        }
    }

    /// What rounding b and d adds to the tail: `-x (dd + db u) / (den den')`.
    fn coefficient_error(&self, row: usize, moved: Moved) -> Interval {
        let lobe = &self.lobes[row];
        let tail = self.tail(row);
        let den = |u: f64| lobe.d + lobe.b * u;
        let ratio = |u: f64| (moved.d + moved.b * u) / den(u);
        // den'/den is monotone in u.
        let least = 1.0 + ratio(tail.low).min(ratio(1.0));
        // x/den^2 falls; x u/den^2 has its one maximum at d/(b + 2d).
        let constant = (1.0 - tail.low) / (den(tail.low) * den(tail.low));
        let vertex = (lobe.d / (lobe.b + 2.0 * lobe.d)).clamp(tail.low, 1.0);
        let at = |u: f64| (1.0 - u) * u / (den(u) * den(u));
        let linear = if lobe.d > 0.0 { at(vertex) } else { at(tail.low) };
        // A part in 2^40 covers the rounding of these bounds themselves.
        let upper = |bound: f64| Interval::new(0.0, bound / least * (1.0 + exp2(-40)));
        -(upper(constant) * Interval::point(moved.d) + upper(linear) * Interval::point(moved.b))
    }
}

/// `code 2^-places`, rounded down.
fn shifted_down(code: i128, places: i32) -> i128 {
    if places >= 0 { code >> places } else { code << -places }
}

impl Architecture for Rational<'_> {
    fn parameters(&self) -> Vec<Parameter> {
        let (f, g) = (self.interface.input_fraction as i32, self.interface.output_fraction as i32);
        // No width serves both branches, so each is solved alone: here the cubic, by whose widths the tail cannot gain.
        let check = Check::new(self.interface);
        let falling = |_: &Widths, cubic: Datapath| (!self.interface.monotone || check.holds(&cubic)).then_some(cubic);
        let alone = widths::solve(&self.cubic, &falling).map(|solution| solution.widths);
        let mut parameters = self.cubic.parameters();
        for parameter in &mut parameters {
            let bits = alone.as_ref().map_or(*parameter.range.end(), |widths| widths[parameter.width]);
            parameter.range = bits..=bits;
        }
        let least = libm::ilogb(self.lobes.iter().map(|lobe| lobe.b + 1.0).fold(f64::INFINITY, f64::min));
        parameters.extend([
            Parameter::new(width::NUM, "numerator x", g - 1..=g + 3).up_to(f),
            // An error of b is divided by about b.
            Parameter::new(B, "tail's slope b", g - 2 - least..=g + 2 - least).up_to(self.exact_bits()),
            Parameter::new(width::DEN, "coefficient d and denominator d + b u", g - 2..=g + 3),
        ]);
        parameters.extend(divide::parameters(self.divider, g));
        parameters
    }

    fn cost(&self, w: &Widths) -> f64 {
        let (f, g) = (self.interface.input_fraction as i32, self.interface.output_fraction as i32);
        let magnitude = libm::ilogb(self.lobes.iter().map(|lobe| lobe.b).fold(1.0, f64::max)) + 1;
        self.cubic.cost(w)
            + multiplier_cost(magnitude + w[B], f + 1)
            + f64::from(w[width::NUM] + w[B] + w[width::DEN])
            + divide::cost(self.divider, w, g, magnitude + 1, w[width::DEN], w[width::NUM])
    }

    fn tables(&self, widths: &Widths) -> Vec<Table> {
        let mut tails: Vec<TailCodes> = (0..self.lobes.len()).map(|row| self.tail_codes(row, widths)).collect();
        self.close_seams(widths, &mut tails);
        self.with_tails(widths, &tails)
    }

    fn searched(&self) -> &'static [&'static str] {
        // The tail is what is off most, and its words are chosen for the seam.
        &[]
    }

    fn description(&self, tables: &[Table]) -> Description {
        let cubic = self.cubic.description(tables);
        Description {
            formula: "y = x (1 - u (A - a u)) for u up to the field cut, x / (d + b u) past it".to_owned(),
            evaluation: format!("The cubic: {}\nThe tail: {}", cubic.evaluation, divide::description(self.divider)),
        }
    }

    fn lobes(&self, _tables: &[Table]) -> Vec<Box<dyn Lobe>> {
        self.lobes.iter().map(|&lobe| Box::new(lobe) as Box<dyn Lobe>).collect()
    }

    fn build(&self, widths: &Widths, tables: Vec<Table>) -> Option<Datapath> {
        let (f, g) = (self.interface.input_fraction as i32, self.interface.output_fraction as i32);
        let rows = self.lobes.len();
        let memories = tables.len();
        let ends = self.ends();
        // The cubic of every row, then the tail of every row.
        let cases: Vec<Case> = (0..2 * rows)
            .map(|case| Case {
                active: if case < rows { Interval::new(0.0, ends[case]) } else { self.tail(case - rows) },
                shininess: tables[0].keys[case % rows],
                rows: (0..memories).map(|memory| (memory == 0).then_some(case % rows)).collect(),
            })
            .collect();
        let mut b = Builder::new(&tables, cases);
        let address = b.address(&self.interface.shininess, 0);
        let (x, u) = b.operand(self.interface);
        let cut = b.field(0, address, "cut");
        let past = b.greater(u, cut, "past", "u > cut: past the cubic's versines");
        // A branch is not used where the other one is: its values may wrap there, and each is bounded for its own
        // versines only.
        let only = |b: &mut Builder, of: &dyn Fn(usize) -> Interval| {
            let exact = |range: Interval| Bound { range, error: Interval::ZERO, grid: f };
            let versines: Vec<Interval> = (0..2 * rows).map(|case| of(case % rows)).collect();
            b.assume(u, versines.iter().map(|&range| exact(range)).collect());
            let cosine = |range: &Interval| exact(Interval::new(1.0 - range.high, 1.0 - range.low));
            b.assume(x, versines.iter().map(cosine).collect());
        };
        only(&mut b, &|row| Interval::new(0.0, ends[row]));
        let (p, _) = self.cubic.p(&mut b, widths, &ends, (address, None), u, |_| None);
        let cubic = polynomial::output_of_p(&mut b, self.interface, widths, x, p, None);
        only(&mut b, &|row| self.tail(row));
        let [slope, constant] = ["b", "d"].map(|name| b.field(0, address, name));
        let num = b.cast(
            x,
            Format::unsigned(0, widths[width::NUM]),
            HighBits::Guarded,
            "num",
            "x, rounded down: below 1 in the tail",
        );
        let rise = b.mul(slope, u, "bu", "b u");
        let rise = b.floor(rise, widths[width::DEN], "rise", "b u, rounded down");
        let den = b.add(constant, rise, "den", "the tail's denominator, d + b u");
        let tail = b.divide(self.divider, widths, [num, den], g, self.most(), memories - 1);
        let y = b.select(
            past,
            [tail, cubic],
            |case| Some(case >= rows),
            "either",
            "the tail past the cut, the cubic up to it",
        );
        let table = &tables[0];
        polynomial::finish(b, self.interface, &tables, y, |case| {
            if case < rows {
                return cubic::Stable::coefficient_error(table, &ends, case);
            }
            let row = case - rows;
            let [b, d] = ["b", "d"].map(|name| table.field(name).rounding(row));
            self.coefficient_error(row, Moved { b, d })
        })
    }
}
