//! The quadratic lobe `x (1 - a u)`, clamped at 0.

use crate::datapath::builder::{Builder, Case, HighBits};
use crate::datapath::{Architecture, Datapath, Description, Parameter, multiplier_cost};
use crate::fixed::{Format, Interval, Table, Widths, exp2};
use crate::lobe::Lobe;
use crate::method::polynomial::datapath::{self as polynomial, Line, SMALL_A, Scaling, rounded_field};
use crate::method::quadratic::Quadratic;
use crate::method::{Interface, width};

/// `p = (a 2^-k) (u 2^k)`, `y = x - x p`: two multiplications whose operands are all below 2.
#[derive(Debug)]
pub struct Stable<'a> {
    /// What it is asked with.
    pub interface: &'a Interface,
    /// The lobe of each row.
    pub lobes: Vec<Quadratic>,
}

/// `y = x + a (x^2 - x)` as in figure 1 of the quadratic paper: between the registers RG1 (n) and RG2 (cos γ) and the
/// output a square, a subtraction, a multiplication by the PROM's a(n) and an addition.
#[derive(Debug)]
pub struct Paper<'a> {
    /// What it is asked with.
    pub interface: &'a Interface,
    /// The lobe of each row.
    pub lobes: Vec<Quadratic>,
}

/// What a coefficient `a + delta` in place of `a` does to the lobe: `-x u delta` up to the farther of the two zeros.
fn coefficient_error(zero: f64, delta: Interval) -> Interval {
    // x u = u (1 - u) has its maximum at 1/2.
    let peak = zero.min(0.5);
    -(Interval::new(0.0, peak * (1.0 - peak)) * delta)
}

impl Stable<'_> {
    fn lines(&self) -> Vec<Line> {
        let values: Vec<f64> = self.lobes.iter().map(|lobe| lobe.a).collect();
        Line::through(self.interface, &values)
    }

    fn scaling(&self, frac_bits: i32) -> Scaling {
        Scaling::of(self.lines().into_iter().map(|line| line.range().low), frac_bits)
    }
}

impl Architecture for Stable<'_> {
    fn parameters(&self) -> Vec<Parameter> {
        let (f, g) = (self.interface.input_fraction as i32, self.interface.output_fraction as i32);
        let cap = (f - self.scaling(g + 5).base()).max(1);
        vec![
            Parameter::new(width::SMALL_A, "coefficient a 2^-k", g - 1..=g + 5),
            Parameter::new(width::X, "cosine x", g - 1..=g + 4).up_to(f),
            Parameter::new(width::V, "scaled versine v = u 2^k", g - 2..=g + 4).up_to(cap),
            Parameter::new(width::P, "p = a u", g - 1..=g + 5),
            Parameter::new(width::T, "t = x p", g..=g + 4),
        ]
    }

    fn cost(&self, w: &Widths) -> f64 {
        let g = self.interface.output_fraction as i32;
        multiplier_cost(w[width::SMALL_A], 1 + w[width::V])
            + multiplier_cost(1 + w[width::X], w[width::P])
            + f64::from(w[width::X].max(w[width::T]).max(g))
            + f64::from(w[width::V] + w[width::X] + w[width::SMALL_A])
    }

    fn tables(&self, widths: &Widths) -> Vec<Table> {
        let bits = widths[width::SMALL_A];
        let scaling = self.scaling(bits);
        let meanings = ["the coefficient a, times 2^-k", "its step to the next row"];
        let lines = scaling.lines(&self.lines(), 1);
        let mut fields = polynomial::line_fields(self.interface, SMALL_A, meanings, bits, &lines);
        fields.extend(scaling.field());
        vec![self.interface.shininess.rom(fields, scaling.base() as u32)]
    }

    fn description(&self, tables: &[Table]) -> Description {
        polynomial::stable_description("y = max(0, x (1 - a u))", self.interface, tables)
    }

    fn lobes(&self, tables: &[Table]) -> Vec<Box<dyn Lobe>> {
        let coefficients = polynomial::real_coefficients(self.interface, &tables[0], SMALL_A, 1);
        coefficients.into_iter().map(|a| Box::new(Quadratic { a }) as Box<dyn Lobe>).collect()
    }

    fn build(&self, widths: &Widths, tables: Vec<Table>) -> Option<Datapath> {
        let scaling = self.scaling(widths[width::SMALL_A]);
        let table = &tables[0];
        // The least a that a row has, before or after rounding, makes the lobe end last.
        let least = |row: usize| {
            let [real, word] = polynomial::lines_of(table, SMALL_A, row).map(|line| line.range().low);
            real.min(word) * exp2(scaling.k[row])
        };
        // Just past the zero p may still be below 1, since v is rounded down: up to there the values must be right.
        let end = |row: usize| {
            let past = Quadratic { a: least(row) }.zero() + exp2(-scaling.k[row] - widths[width::V]);
            polynomial::below_one(self.interface, past.min(exp2(1 - scaling.k[row])))
        };
        let ends: Vec<f64> = (0..table.rows()).map(end).collect();
        let mut b = Builder::new(&tables, Case::of_rows(table, &ends));
        let address = polynomial::address(&mut b, self.interface, 0);
        let (x, u) = b.operand(self.interface);
        let a = polynomial::coefficient(&mut b, address, SMALL_A);
        let scaled = scaling.apply(&mut b, address.0, u);
        let beyond = b.reaches(scaled, 1, "beyond", "u 2^k >= 2: then a u >= 1, since a 2^-k >= 1/2");
        let v =
            b.cast(scaled, Format::unsigned(1, widths[width::V]), HighBits::Guarded, "v", "v = u 2^k, rounded down");
        let p = b.mul(a, v, "av", "a u = (a 2^-k) v");
        let y = polynomial::output_of_p(&mut b, self.interface, widths, x, p, beyond);
        polynomial::finish(b, self.interface, &tables, y, |row| {
            let delta = polynomial::delta(table, SMALL_A, row).scale(scaling.k[row]);
            coefficient_error(Quadratic { a: least(row) }.zero(), delta)
        })
    }
}

impl Architecture for Paper<'_> {
    fn parameters(&self) -> Vec<Parameter> {
        let (f, g) = (self.interface.input_fraction as i32, self.interface.output_fraction as i32);
        let largest = self.lobes.iter().map(|l| l.a).fold(1.0, f64::max);
        // An error of the square is multiplied by a.
        let square = g + libm::ilogb(largest) + 1;
        // Steps of a fine input ask for more, if the output is not to fall at any.
        let finer = if self.interface.monotone { (f - g + 2).max(0) } else { 0 };
        vec![
            Parameter::new(width::SMALL_A, "coefficient a", g - 3..=g + 4),
            Parameter::new(width::S, "square of the cosine", square..=square + 5 + finer).up_to(2 * f),
            Parameter::new(width::M, "product a (x^2 - x)", g..=g + 4 + finer),
        ]
    }

    fn cost(&self, w: &Widths) -> f64 {
        let f = self.interface.input_fraction as i32;
        let largest = self.lobes.iter().map(|l| l.a).fold(1.0, f64::max);
        multiplier_cost(f + 1, f + 1) + multiplier_cost(w[width::SMALL_A] + libm::ilogb(largest) + 1, w[width::S])
    }

    fn tables(&self, widths: &Widths) -> Vec<Table> {
        let reals = self.lobes.iter().map(|l| l.a).collect();
        let a = rounded_field("a", "the coefficient a", widths[width::SMALL_A], reals);
        vec![self.interface.shininess.rom(vec![a], 0)]
    }

    fn description(&self, _tables: &[Table]) -> Description {
        Description {
            formula: "y = max(0, x (1 - a u))".to_owned(),
            evaluation: "It is evaluated as printed, a (x^2 - x) + x: the square's rounding error is multiplied by a. \
             The result is rounded to\n\
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
        // The result is clamped, not flagged, so the whole of [0, 1] must stay in its formats.
        let everywhere = vec![1.0; table.rows()];
        let mut b = Builder::new(&tables, Case::of_rows(table, &everywhere));
        let address = b.address(&self.interface.shininess, 0);
        let (x, _) = b.operand(self.interface);
        let a = b.field(0, address, "a");
        let square = b.mul(x, x, "xx", "x^2");
        let s = b.floor(square, widths[width::S], "s", "x^2, rounded down");
        let d = b.sub(s, x, "d", "x^2 - x");
        let m = b.mul(a, d, "ad", "a (x^2 - x)");
        let m = b.floor(m, widths[width::M], "m", "a (x^2 - x), rounded down");
        let x = b.add_half(x, g, "x_half");
        let y = b.add(m, x, "y_exact", "a (x^2 - x) + x");
        let y = b.floor(y, g, "y_cut", "rounded down to the output's bits");
        let y = polynomial::pad(&mut b, y, g);
        let y = b.clamp_to_unit(y, "y", "taken into [0, 1]");
        polynomial::finish(b, self.interface, &tables, y, |row| {
            let (real, word) = (self.lobes[row].a, table.field("a").value(row));
            coefficient_error(Quadratic { a: real.min(word) }.zero(), Interval::point(word - real))
        })
    }
}
