//! The spherical Gaussian as `2^-z`, `z = n u log2 e`, with `2^-f` for the fraction f of z from a table and the rest a
//! shift.
//!
//! # The proof
//!
//! As for `log-exp`, the cases are ranges of the real z. What the hardware has in place of z is off by what rounding u,
//! v and z down loses and by z times the relative error of the constant; the table makes up for the mean of it. The
//! result is forced to 0 where v or the integer part of z does not fit its bits. There the hardware's z is G + 1 at
//! least and the real one less by a quarter at most, so that the result is little more than half an output ulp, which
//! the bound of a case counts that reaches so far.

use crate::datapath::builder::{Bound, Builder, Case};
use crate::datapath::{Architecture, Datapath, Description, Parameter, multiplier_cost};
use crate::fixed::{Format, Interval, Table, Widths, exp2};
use crate::lobe::Lobe;
use crate::method::exponent::{Exponent, error_of_exponent};
use crate::method::log_exp::chords::{Rises, Slopes};
use crate::method::log_exp::datapath::{
    exp_chords, levels, power_of_two, rounded_or_zero, times_versine, versine_int_bits, whole_bits,
};
use crate::method::log_exp::{EXP_ADDRESS, EXP_TABLE};
use crate::method::polynomial::datapath::{self as polynomial, nearest_code};
use crate::method::{Interface, width};
use crate::platform::error::Error;

const LOG2_E: f64 = std::f64::consts::LOG2_E;

/// A multiplier for n u, one for the constant, a table and a shifter.
#[derive(Debug)]
pub struct Exponential<'a> {
    interface: &'a Interface,
    n: Exponent<'a>,
}

impl<'a> Exponential<'a> {
    /// For an interface of this method.
    ///
    /// # Errors
    /// A shininess that the method refuses.
    pub fn new(interface: &'a Interface) -> Result<Self, Error> {
        Ok(Self { interface, n: Exponent::new(interface)? })
    }

    fn input_bits(&self) -> i32 {
        self.interface.input_fraction as i32
    }

    fn output_bits(&self) -> i32 {
        self.interface.output_fraction as i32
    }
}

impl Architecture for Exponential<'_> {
    fn parameters(&self) -> Vec<Parameter> {
        let (f, g) = (self.input_bits(), self.output_bits());
        let n = self.n.parameter(g);
        let n_fraction = n.as_ref().map_or(self.interface.shininess.frac_bits() as i32, |n| *n.range.end());
        let exp = ((g - 4) / 2).max(1);
        let low = g + self.n.int_bits();
        let u = Parameter::new(width::U, "versine", low..=low + 4).up_to(f);
        let v = Parameter::new(width::V, "v = n u", g..=g + 4).up_to(n_fraction + u.range.end());
        let own = [
            Parameter::new(EXP_ADDRESS, "table of the exponential (bits of its address)", exp..=exp + 4),
            u,
            v,
            Parameter::new(width::K, "the constant log2 e", g..=g + 4),
            Parameter::new(width::Z, "z = v log2 e", g..=g + 4),
            Parameter::new(width::E, "2^-f", g + 1..=g + 5),
        ];
        n.into_iter().chain(own).collect()
    }

    fn cost(&self, w: &Widths) -> f64 {
        let power = |f: f64| libm::exp2(-f);
        multiplier_cost(self.n.int_bits() + self.n.frac_bits(w), w[width::U])
            + multiplier_cost(versine_int_bits(self.output_bits()) + w[width::V], w[width::K] + 1)
            + exp_chords(w, Slopes::Matched, &power).cost()
            // The shifter has a multiplexer a bit and level.
            + f64::from(w[width::E] * whole_bits(self.output_bits()) + w[width::Z] + w[width::V])
    }

    fn tables(&self, widths: &Widths) -> Vec<Table> {
        let lift = self.n.lift(self.input_bits(), widths);
        let exp = exp_chords(widths, Slopes::Matched, &|f| libm::exp2(-f - lift)).table(Rises::Between);
        self.n.table(self.n.frac_bits(widths)).into_iter().chain([exp]).collect()
    }

    fn description(&self, tables: &[Table]) -> Description {
        let entries = tables.iter().find(|table| table.name == EXP_TABLE).map_or(0, Table::rows);
        Description {
            formula: "y = e^(-n u); 0 at x = 0".to_owned(),
            evaluation: format!(
                "It is evaluated as 2^-z with z = n u log2 e: 2^-f for the fraction f of z comes from a table of \
                 {entries} entries with\n\
                 linear interpolation, and the integer part shifts. The result is rounded to nearest."
            ),
        }
    }

    fn lobes(&self, _tables: &[Table]) -> Vec<Box<dyn Lobe>> {
        let lobe = |n: f64| Box::new(super::Gaussian { n }) as Box<dyn Lobe>;
        self.interface.shininess.values().into_iter().map(lobe).collect()
    }

    fn build(&self, widths: &Widths, tables: Vec<Table>) -> Option<Datapath> {
        let memory = tables.iter().position(|table| table.name == EXP_TABLE)?;
        let levels = levels(self.output_bits());
        let active = Interval::new(0.0, polynomial::below_one(self.interface, 1.0));
        let case = Case { active, shininess: self.n.largest, rows: vec![None; tables.len()] };
        let mut b = Builder::new(&tables, vec![case; levels.len()]);

        let n = self.n.node(&mut b, &tables);
        let (_, versine) = b.operand(self.interface);
        let u = b.floor(versine, widths[width::U], "u_cut", "u, rounded down");
        let (v, beyond) = times_versine(&mut b, widths, [n, u], versine_int_bits(self.output_bits()), "u");

        let bits = widths[width::K];
        let code = nearest_code(LOG2_E, bits);
        let constant = b.constant(code, Format::unsigned(1, bits), "log2_e");
        let product = b.mul(v, constant, "vk", "v log2 e");
        let used = code as f64 * exp2(-bits);
        let relative = Interval::point((used - LOG2_E) / LOG2_E);
        let bounds = levels.iter().enumerate().map(|(case, level)| {
            let error = b.bounds(v)[case].error * Interval::point(used) + Interval::new(0.0, level.high) * relative;
            Bound { error, ..b.bounds(product)[case] }
        });
        let bounds = bounds.collect();
        b.assume(product, bounds);
        let z = b.floor(product, widths[width::Z], "z", "z = n u log2 e, rounded down");
        let whole_bits = whole_bits(self.output_bits());
        let over = b.reaches(z, whole_bits, "over", "z is past what the result can show");
        // The places where the result is forced to 0 rest on this.
        if b.bounds(z).iter().any(|z| z.error.magnitude() > 0.25) {
            return None;
        }

        let lift = self.n.lift(self.input_bits(), widths);
        let power = |f: f64| libm::exp2(-f - lift);
        let exp = exp_chords(widths, Slopes::Matched, &power);
        let shifted = power_of_two(&mut b, &exp, memory, z, whole_bits, lift, &levels)?;
        let y = rounded_or_zero(&mut b, shifted, self.output_bits(), &[beyond, over], &levels);
        let y = polynomial::lit(&mut b, versine, y);

        let relative = self.n.relative_error(&tables);
        polynomial::finish(b, self.interface, &tables, y, |case| error_of_exponent(levels[case], relative))
    }
}
