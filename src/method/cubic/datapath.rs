//! The cubic lobe `x (1 - u (A - a u))`, cut to 0 past the minimum of its inner parabola.

use crate::datapath::builder::{Builder, Case, HighBits};
use crate::datapath::graph::NodeId;
use crate::datapath::{Architecture, Datapath, Description, Parameter, multiplier_cost};
use crate::fixed::{Field, Format, Interval, Table, Widths, exp2};
use crate::lobe::Lobe;
use crate::method::cubic::{Cubic, H, Tail};
use crate::method::polynomial::Polynomial;
use crate::method::polynomial::datapath::{
    self as polynomial, BIG_A, Ends, Line, SMALL_A, Scaling, field, nearest_code, rounded_field,
};
use crate::method::{Interface, width};

/// `q = A 2^-k - (a 4^-k) v`, `p = q v`, `y = x - x p` with `v = u 2^k`: three multiplications.
#[derive(Debug)]
pub struct Stable<'a> {
    interface: &'a Interface,
    tail: Tail,
    lobes: Vec<Cubic>,
    /// Where each row's cubic is left.
    ends: Ends,
}

/// `a x^3 + b x^2 + c x` in five multiplications and two additions, as printed.
#[derive(Debug)]
pub struct Paper<'a> {
    /// What it is asked with.
    pub interface: &'a Interface,
    /// The lobe of each row.
    pub lobes: Vec<Cubic>,
}

impl<'a> Stable<'a> {
    /// These cubics with this tail.
    pub fn new(interface: &'a Interface, tail: Tail, lobes: Vec<Cubic>) -> Self {
        // At the inner parabola's minimum to be cut, at its own to be held.
        let end = |lobe: &Cubic| match tail {
            Tail::Cut => lobe.cut(),
            Tail::Hold if interface.monotone => lobe.minimum().map(|minimum| Self::held_from(interface, lobe, minimum)),
            Tail::Hold => lobe.minimum(),
        };
        let ends = Ends::of(interface, lobes.iter().map(end));
        Self { interface, tail, lobes, ends }
    }

    /// The versine from which on a cubic is held that is never to rise: where it comes within half an ulp of the held
    /// value. About the minimum itself the roundings would show.
    fn held_from(interface: &Interface, lobe: &Cubic, minimum: f64) -> f64 {
        let ulp = exp2(-(interface.output_fraction as i32));
        let held = libm::round(lobe.formula(minimum).clamp(0.0, 1.0) / ulp) * ulp;
        let (mut low, mut high) = (0.0, minimum);
        for _ in 0..interface.input_fraction + 8 {
            let middle = 0.5 * (low + high);
            if lobe.formula(middle) > held + 0.5 * ulp { low = middle } else { high = middle }
        }
        high
    }

    /// These cubics, each up to one of these versines: what a core does past that is the caller's business.
    pub(in crate::method) fn up_to(
        interface: &'a Interface,
        lobes: Vec<Cubic>,
        ends: impl Iterator<Item = f64>,
    ) -> Self {
        Self { interface, tail: Tail::Cut, lobes, ends: Ends::of(interface, ends.map(Some)) }
    }

    /// The scaling of each row with these widths.
    pub(in crate::method) fn scaling(&self, widths: &Widths) -> Scaling {
        self.scaled_at(widths[width::BIG_A])
    }

    fn scaled_at(&self, frac_bits: i32) -> Scaling {
        Scaling::of(self.lines(|lobe| lobe.big_a).into_iter().map(|line| line.range().low), frac_bits)
    }

    fn lines(&self, of: impl Fn(&Cubic) -> f64) -> Vec<Line> {
        let values: Vec<f64> = self.lobes.iter().map(of).collect();
        Line::through(self.interface, &values)
    }

    /// The field with the values past the cut, where the tail is held and some row has a cut.
    fn held(table: &Table) -> Option<&Field> {
        table.find("hold")
    }

    /// The value that each row's cubic is held at; 0 where it is never left.
    fn hold_field(&self) -> Field {
        let bits = self.interface.output_fraction as i32;
        let value = |lobe: &Cubic| lobe.minimum().map_or(0.0, |minimum| lobe.formula(minimum).clamp(0.0, 1.0));
        rounded_field("hold", "the value past the cut", bits, self.lobes.iter().map(value).collect())
    }

    /// The ROM fields of the cubic itself: A, a and k.
    pub(in crate::method) fn fields(&self, widths: &Widths) -> Vec<Field> {
        let scaling = self.scaling(widths);
        let (bits_big, bits_small) = (widths[width::BIG_A], widths[width::SMALL_A]);
        let ends = self.ends.in_codes();
        let mut big_codes = Vec::new();
        for ((lobe, &k), &end) in self.lobes.iter().zip(&scaling.k).zip(&ends) {
            let (real_big, real_small) = (lobe.big_a * exp2(-k), lobe.a * exp2(-2 * k));
            // Rounding a by da moves the lobe by x v (da v - dA): with dA = (2 sqrt 2 - 2) v_end da the move is least,
            // 0.172 v_end^2 da in place of v_end^2 da.
            let delta = nearest_code(real_small, bits_small) as f64 * exp2(-bits_small) - real_small;
            let balance = (2.0 * std::f64::consts::SQRT_2 - 2.0) * end * exp2(k) * delta;
            big_codes.push(nearest_code(real_big + balance, bits_big));
        }
        let meanings = ["the coefficient A, times 2^-k", "the step of A to the next row"];
        let mut fields = polynomial::line_fields(
            self.interface,
            BIG_A,
            meanings,
            bits_big,
            &scaling.lines(&self.lines(|l| l.big_a), 1),
        );
        let meanings = ["the coefficient a, times 4^-k", "the step of a to the next row"];
        fields.extend(polynomial::line_fields(
            self.interface,
            SMALL_A,
            meanings,
            bits_small,
            &scaling.lines(&self.lines(|l| l.a), 2),
        ));
        fields[0] = field("big_a", "the coefficient A, times 2^-k", bits_big, big_codes, fields[0].reals.clone());
        fields.extend(scaling.field());
        fields
    }

    /// `p = u (A - a u)`, and the flag that `past_cut` makes once the coefficients are read. `ends` are the rows'
    /// greatest versines.
    pub(in crate::method) fn p(
        &self,
        b: &mut Builder,
        widths: &Widths,
        ends: &[f64],
        address: (NodeId, Option<NodeId>),
        u: NodeId,
        past_cut: impl FnOnce(&mut Builder) -> Option<NodeId>,
    ) -> (NodeId, Option<NodeId>) {
        let scaling = self.scaling(widths);
        let big_a = polynomial::coefficient(b, address, BIG_A);
        let a = polynomial::coefficient(b, address, SMALL_A);
        let past_cut = past_cut(b);
        let scaled = scaling.over_cases(b.cases()).apply(b, address.0, u);
        let v = Format::unsigned(Ends::int_bits(ends, &scaling.k), widths[width::V]);
        let v = b.cast(scaled, v, HighBits::Guarded, "v", "v = u 2^k, rounded down; wraps past the cut");
        let av = b.mul(a, v, "av", "(a 4^-k) v");
        let r = b.floor(av, widths[width::BIG_A], "r", "(a 4^-k) v, rounded down");
        let q = b.sub(big_a, r, "q", "q = (A - a u) 2^-k; wraps past the cut");
        (b.mul(v, q, "vq", "u (A - a u) = v q"), past_cut)
    }

    /// What rounding the coefficients of a row adds to its result.
    pub(in crate::method) fn coefficient_error(table: &Table, ends: &[f64], row: usize) -> Interval {
        let [delta_big, delta_small] = [BIG_A, SMALL_A].map(|names| polynomial::delta_line(table, names, row));
        let v = Interval::new(0.0, ends[row] * exp2(polynomial::shift_of(table, row)));
        // For each v the move is linear in the fraction: its extremes are at the row and at the next.
        let at_row = polynomial::parabola(delta_big.base, delta_small.base, v);
        let at_next = polynomial::parabola(delta_big.base + delta_big.step, delta_small.base + delta_small.step, v);
        at_row.hull(at_next) * -Interval::new(1.0 - ends[row], 1.0)
    }
}

impl Architecture for Stable<'_> {
    fn parameters(&self) -> Vec<Parameter> {
        let (f, g) = (self.interface.input_fraction as i32, self.interface.output_fraction as i32);
        let cap = (f - self.scaled_at(g + 6).base()).max(1);
        // q v rises with v only where v loses less to the rounding of q than q itself gives a step.
        let finest = g + if self.interface.monotone { 14 } else { 6 };
        vec![
            Parameter::new(width::BIG_A, "coefficient A 2^-k, and q = A - a v", g..=finest),
            Parameter::new(width::SMALL_A, "coefficient a 4^-k", g - 1..=g + 6),
            Parameter::new(width::X, "cosine x", g - 1..=g + 4).up_to(f),
            Parameter::new(width::V, "scaled versine v = u 2^k", g - 1..=g + 5).up_to(cap),
            Parameter::new(width::P, "p = v q", g - 1..=g + 5),
            Parameter::new(width::T, "t = x p", g..=g + 4),
        ]
    }

    fn finest(&self) -> Vec<Parameter> {
        let (f, g) = (self.interface.input_fraction as i32, self.interface.output_fraction as i32);
        if !self.interface.monotone || f <= g + 4 {
            return Vec::new();
        }
        // Every step of a fine input is one of x and of v, too, so that none of them goes alone.
        let cap = (f - self.scaled_at(g + 6).base()).max(1);
        self.parameters()
            .into_iter()
            .map(|parameter| {
                let range = match parameter.width {
                    width::BIG_A => g + 6..=f + 8,
                    width::SMALL_A => g + 4..=f,
                    width::X => f..=f,
                    width::V => cap..=cap,
                    _ => f + 1..=f + 3,
                };
                Parameter { range, ..parameter }
            })
            .collect()
    }

    fn cost(&self, w: &Widths) -> f64 {
        let v = w[width::V] + 2;
        multiplier_cost(w[width::SMALL_A] - 1, v)
            + multiplier_cost(w[width::BIG_A], v)
            + multiplier_cost(1 + w[width::X], w[width::P])
            + f64::from(w[width::X].max(w[width::T]) + w[width::BIG_A] + w[width::V] + w[width::X] + w[width::SMALL_A])
    }

    fn tables(&self, widths: &Widths) -> Vec<Table> {
        let mut fields = self.fields(widths);
        let cut = self.ends.clone().field(self.interface);
        let hold = (cut.is_some() && self.tail == Tail::Hold).then(|| self.hold_field());
        fields.extend(cut.into_iter().chain(hold));
        vec![self.interface.shininess.rom(fields, self.scaling(widths).base() as u32)]
    }

    fn description(&self, tables: &[Table]) -> Description {
        let formula = match self.tail {
            Tail::Cut => "y = x (1 - u (A - a u)) for u up to A/(2a), 0 past it; kept inside [0, 1]",
            Tail::Hold => {
                "y = x (1 - u (A - a u)) up to its minimum, the minimum's value past it; kept inside [0, 1], 0 at x = 0"
            }
        };
        polynomial::stable_description(formula, self.interface, tables)
    }

    fn lobes(&self, tables: &[Table]) -> Vec<Box<dyn Lobe>> {
        let table = &tables[0];
        let [big_a, a] = [(BIG_A, 1), (SMALL_A, 2)]
            .map(|(names, power)| polynomial::real_coefficients(self.interface, table, names, power));
        let ends = Ends::in_reals(table);
        let held = Self::held(table);
        let lobe = |place: usize| {
            // Where to leave the cubic, and what it is held at, are those of the row.
            let (row, _) = self.interface.shininess.knot(place);
            Polynomial {
                cosine: true,
                power: 1,
                c: 1.0,
                big_a: big_a[place],
                a: a[place],
                end: ends[row],
                past: held.map_or(0.0, |field| field.reals[row]),
            }
        };
        (0..big_a.len()).map(|place| Box::new(lobe(place)) as Box<dyn Lobe>).collect()
    }

    fn build(&self, widths: &Widths, tables: Vec<Table>) -> Option<Datapath> {
        let table = &tables[0];
        let ends = Ends::in_words(self.interface, table);
        let mut cases = Case::of_rows(table, &ends);
        let held = Self::held(table);
        if held.is_some() {
            // Past the end only the held value counts: the polynomial's values stay those at the end.
            let tails = cases.iter().map(|case| Case { active: Interval::point(case.active.high), ..case.clone() });
            cases.extend(tails.collect::<Vec<_>>());
        }
        let mut b = Builder::new(&tables, cases);
        let (address, fraction) = polynomial::address(&mut b, self.interface, 0);
        let (x, u) = b.operand(self.interface);
        let flag = |b: &mut Builder| Ends::flag(b, self.interface, table, address, u);
        let (p, past_cut) = self.p(&mut b, widths, &ends, (address, fraction), u, flag);
        let y = match (held, past_cut) {
            (Some(_), Some(past_cut)) => {
                let y = polynomial::output_of_p(&mut b, self.interface, widths, x, p, None);
                let hold = b.field(0, address, "hold");
                let rows = table.rows();
                let y = b.select(past_cut, [hold, y], |case| Some(case >= rows), "y_held", "y, held past the cut");
                polynomial::lit(&mut b, u, y)
            }
            _ => polynomial::output_of_p(&mut b, self.interface, widths, x, p, past_cut),
        };
        polynomial::finish(b, self.interface, &tables, y, |case| {
            let row = case % table.rows();
            if let Some(hold) = held.filter(|_| case >= table.rows()) {
                return Interval::point(hold.rounding(row));
            }
            Self::coefficient_error(table, &ends, row)
        })
    }
}

impl Paper<'_> {
    fn ends(&self) -> Ends {
        Ends::of(self.interface, self.lobes.iter().map(Cubic::cut))
    }

    fn largest(&self) -> f64 {
        self.lobes.iter().map(|l| l.a.abs()).fold(1.0, f64::max)
    }
}

impl Architecture for Paper<'_> {
    fn parameters(&self) -> Vec<Parameter> {
        let (f, g) = (self.interface.input_fraction as i32, self.interface.output_fraction as i32);
        // An error of a power of x is multiplied by a.
        let power = g + libm::ilogb(self.largest()) + 1;
        // Steps of a fine input ask for more, if the output is not to fall at any.
        let finer = if self.interface.monotone { (f - g + 2).max(0) } else { 0 };
        vec![
            Parameter::new(width::C, "coefficients a, b, c", g - 3..=g + 5),
            Parameter::new(width::S, "square of the cosine", power..=power + 5 + finer).up_to(2 * f),
            Parameter::new(H, "cube of the cosine", power..=power + 5 + finer).up_to(3 * f),
            Parameter::new(width::M, "products a x^3, b x^2, c x", g..=g + 5 + finer),
        ]
    }

    fn cost(&self, w: &Widths) -> f64 {
        let f = self.interface.input_fraction as i32;
        let coefficient = w[width::C] + libm::ilogb(self.largest()) + 1;
        multiplier_cost(f + 1, f + 1)
            + multiplier_cost(f + 1, w[width::S])
            + multiplier_cost(coefficient, w[H])
            + multiplier_cost(coefficient + 1, w[width::S])
            + multiplier_cost(coefficient, f + 1)
            + f64::from(2 * w[width::M])
    }

    fn tables(&self, widths: &Widths) -> Vec<Table> {
        let bits = widths[width::C];
        let mut codes = [Vec::new(), Vec::new(), Vec::new()];
        let mut reals = [Vec::new(), Vec::new(), Vec::new()];
        for lobe in &self.lobes {
            let printed = lobe.printed();
            let (a, b) = (nearest_code(printed[0], bits), nearest_code(printed[1], bits));
            // a + b + c = 1 exactly, so that the lobe is 1 at x = 1 whatever the rounding.
            for (column, code) in codes.iter_mut().zip([a, b, (1 << bits) - a - b]) {
                column.push(code);
            }
            for (column, real) in reals.iter_mut().zip(printed) {
                column.push(real);
            }
        }
        let names =
            [("a", "the coefficient a of x^3"), ("b", "the coefficient b of x^2"), ("c", "the coefficient c of x")];
        let mut fields: Vec<Field> = names
            .into_iter()
            .zip(codes.into_iter().zip(reals))
            .map(|((name, meaning), (codes, reals))| field(name, meaning, bits, codes, reals))
            .collect();
        fields.extend(self.ends().field(self.interface));
        vec![self.interface.shininess.rom(fields, 0)]
    }

    fn description(&self, _tables: &[Table]) -> Description {
        Description {
            formula: "y = x (1 - u (A - a u)) for u up to A/(2a), 0 past it; kept inside [0, 1]".to_owned(),
            evaluation: "It is evaluated as printed, a x^3 + b x^2 + c x with a = a, b = A - 2a, c = 1 - A + a: the \
             powers' rounding errors are\n\
                         multiplied by a, which grows with the square of the shininess. The result is rounded to \
                         nearest."
                .to_owned(),
        }
    }

    fn lobes(&self, _tables: &[Table]) -> Vec<Box<dyn Lobe>> {
        self.lobes.iter().map(|&lobe| Box::new(lobe) as Box<dyn Lobe>).collect()
    }

    fn build(&self, widths: &Widths, tables: Vec<Table>) -> Option<Datapath> {
        let g = self.interface.output_fraction as i32;
        let table = &tables[0];
        let ends = Ends::in_words(self.interface, table);
        let mut b = Builder::new(&tables, Case::of_rows(table, &ends));
        let address = b.address(&self.interface.shininess, 0);
        let (x, u) = b.operand(self.interface);
        let [ca, cb, cc] = ["a", "b", "c"].map(|name| b.field(0, address, name));
        let past_cut = Ends::flag(&mut b, self.interface, table, address, u);
        let square = b.mul(x, x, "xx", "x^2");
        let s = b.floor(square, widths[width::S], "s", "x^2, rounded down");
        let cube = b.mul(s, x, "sx", "x^3");
        let h = b.floor(cube, widths[H], "h", "x^3, rounded down");
        let third = b.mul(ca, h, "ah", "a x^3");
        let third = b.floor(third, widths[width::M], "m3", "a x^3, rounded down");
        let second = b.mul(cb, s, "bs", "b x^2");
        let second = b.floor(second, widths[width::M], "m2", "b x^2, rounded down");
        let first = b.mul(cc, x, "cx", "c x");
        let first = b.floor(first, widths[width::M], "m1", "c x, rounded down");
        let sum = b.add(third, second, "sum", "a x^3 + b x^2");
        let y = b.add(sum, first, "y_exact", "a x^3 + b x^2 + c x");
        let y = b.add_half(y, g, "y_half");
        let y = b.floor(y, g, "y_cut", "rounded down to the output's bits");
        let y = polynomial::pad(&mut b, y, g);
        let y = b.clamp_to_unit(y, "y_unit", "taken into [0, 1]");
        let y = b.zero_if(past_cut, y, "y", "y, 0 past the cut");
        polynomial::finish(b, self.interface, &tables, y, |row| {
            let [a, b] = ["a", "b"].map(|name| Interval::point(table.field(name).rounding(row)));
            // With the deltas adding up to 0 the move is da x^3 + db x^2 + dc x = -x u (da (1 + x) + db).
            let (x, u) = (Interval::new(1.0 - ends[row], 1.0), Interval::new(0.0, ends[row]));
            -(x * u * (a * (Interval::point(1.0) + x) + b))
        })
    }
}
