//! The power as `2^-z`, `z = n L`, from a table of L and a table of `2^-f`, neither interpolated: one multiplication.
//!
//! After D. Harris, "An Exponentiation Unit for an OpenGL Lighting Engine" (IEEE Trans. Computers 53(3), 2004); see
//! [`crate::method::harris::Harris`] for what is his and what is not. A cell of L within an octave of the versine u is
//! `u 2^-log_bits` wide or less, so that it counts `n u e^(-n u) 2^-log_bits` in the result, whatever n is.
//!
//! # The proof
//!
//! The words of L, and of n where that is read from a ROM, are the method's own numbers, and z is their exact product.
//! So the cell of its fraction is the method's cell, and what is left are the rounding of the second table's words,
//! what the shift by the integer part of z drops, and the last rounding. Where the integer part does not fit its bits
//! the result is forced to 0; there `z >= G + 1`, so that the method's value is half an output ulp at most.

use std::sync::Arc;

use crate::datapath::builder::{Bound, Builder, Case, HighBits};
use crate::datapath::graph::NodeId;
use crate::datapath::{Architecture, Datapath, Description, Parameter, multiplier_cost};
use crate::fixed::{Format, Interval, Table, Widths, exp2};
use crate::lobe::Lobe;
use crate::method::exponent::{Exponent, exact_bits};
use crate::method::log_exp::{EXP_TABLE, LOG_TABLE};
use crate::method::polynomial::datapath::{self as polynomial, rounded_field};
use crate::method::{Interface, width};
use crate::platform::error::Error;

/// No word of L needs more fraction bits than this.
const MOST_LOG_BITS: i32 = 26;

/// Two tables, a multiplier and a shifter.
#[derive(Debug)]
pub struct Harris<'a> {
    interface: &'a Interface,
    log_bits: u32,
    exp_bits: u32,
    n: Exponent<'a>,
}

impl<'a> Harris<'a> {
    /// For an interface of this method.
    ///
    /// # Errors
    /// A shininess that the method refuses.
    pub fn new(interface: &'a Interface, log_bits: u32, exp_bits: u32) -> Result<Self, Error> {
        Ok(Self { interface, log_bits, exp_bits, n: Exponent::new(interface)? })
    }

    fn input_bits(&self) -> i32 {
        self.interface.input_fraction as i32
    }

    fn output_bits(&self) -> i32 {
        self.interface.output_fraction as i32
    }

    /// Fraction bits of n: rounding it moves z by a fraction of a cell of the second table.
    fn shininess_bits(&self) -> i32 {
        if !self.n.is_read() {
            return self.interface.shininess.frac_bits() as i32;
        }
        exact_bits(&self.interface.shininess).min((self.exp_bits as i32 + 4 - libm::ilogb(self.n.least)).max(0))
    }

    /// Octaves of the versine with cells of their own: below them z is less than 0.4 of a cell of the second table.
    fn octaves(&self) -> i32 {
        self.input_bits().min(self.exp_bits as i32 + libm::ilogb(self.n.largest) + 3)
    }

    /// Fraction bits of L: rounding it moves z by a quarter of a cell of the second table at most.
    fn log_bits(&self) -> i32 {
        (self.exp_bits as i32 + libm::ilogb(self.n.largest) + 2).min(MOST_LOG_BITS)
    }

    /// Bits of the integer part of z: the result is 0 from `2^this >= G + 1` on.
    fn whole_bits(&self) -> i32 {
        libm::ilogb(f64::from(self.output_bits())) + 1
    }

    fn log_table(&self) -> Table {
        let (cells, one) = (1i32 << self.log_bits, exp2(self.input_bits()));
        // With the least shininess the result is 0 from here on.
        let most = f64::from(self.output_bits() + 2) / self.n.least;
        let entry = |index: i32| {
            let (octave, cell) = (index / cells, index % cells);
            let edge = |cell: i32| exp2(-octave - 1) * (1.0 + f64::from(cell) / f64::from(cells));
            // From the first to the last versine code in the cell; in a cell without any nothing matters.
            let first = libm::ceil(edge(cell) * one);
            let last = (libm::ceil(edge(cell + 1) * one) - 1.0).max(first).min(one - 1.0);
            crate::method::harris::Harris::logarithm(first.min(last) / one, last / one).min(most)
        };
        let reals: Vec<f64> = (0..self.octaves() * cells).map(entry).collect();
        let keys = (0..reals.len()).map(|entry| entry as f64).collect();
        let field = rounded_field("log", "L = -log2 x midway in the cell", self.log_bits(), reals);
        Table::listed(LOG_TABLE, "entry", keys, vec![field])
    }

    fn exp_table(&self, widths: &Widths) -> Table {
        let entries = 1usize << self.exp_bits;
        let width = 1.0 / entries as f64;
        let span = (width - exp2(-self.log_bits() - self.shininess_bits())).max(0.0);
        let entry = |index: usize| {
            let first = index as f64 * width;
            crate::method::harris::Harris::exponential(first, first + span)
        };
        let reals: Vec<f64> = (0..entries).map(entry).collect();
        let keys = (0..entries).map(|entry| entry as f64).collect();
        let field = rounded_field("exp", "2^-f midway in the cell", widths[width::E], reals);
        Table::listed(EXP_TABLE, "entry", keys, vec![field])
    }

    /// L of the versine, 0 below the octaves.
    fn logarithm(&self, b: &mut Builder, memory: usize, u: NodeId) -> NodeId {
        let count = b.cases().len();
        let low = b.reaches(u, -self.octaves(), "in_octaves", "the versine lies in one of the table's octaves");
        let top = low.map(|low| b.not(low, "top", "x is 1, or so near to it that L counts as 0"));
        let normal = b.normalise(u, -1, self.octaves() - 1, "m");
        let bits = self.log_bits as i32;
        let cell = b.cast(
            normal.value,
            Format::unsigned(-1, bits + 1),
            HighBits::Guarded,
            "cell",
            "where in its octave the versine lies",
        );
        let mut address = b.scale(cell, None, bits + 1, &vec![bits + 1; count], "cell_number", "as a number");
        let mut octave: Option<NodeId> = None;
        for (shift, above) in normal.steps {
            let power = libm::ilogb(f64::from(shift));
            let taken = b.not(above, &format!("taken_{shift}"), "this step of the shift was taken");
            let part =
                b.scale(taken, None, power, &vec![power; count], &format!("part_{shift}"), "its part of the octave");
            octave = Some(match octave {
                Some(sum) => {
                    b.add(sum, part, &format!("octave_{shift}"), "the octave: how far the versine was shifted")
                }
                None => part,
            });
        }
        if let Some(octave) = octave {
            address = b.part_address(octave, address, memory);
        }
        let log = b.field(memory, address, "log");
        b.zero_if(top, log, "L", "L = -log2 x")
    }
}

impl Architecture for Harris<'_> {
    fn parameters(&self) -> Vec<Parameter> {
        let g = self.output_bits();
        vec![Parameter::new(width::E, "2^-f", g + 1..=g + 3)]
    }

    fn cost(&self, w: &Widths) -> f64 {
        let word = 5 + self.log_bits();
        let memory = f64::from(self.octaves() * word) * exp2(self.log_bits as i32)
            + f64::from(w[width::E]) * exp2(self.exp_bits as i32);
        multiplier_cost(self.n.int_bits() + self.shininess_bits(), word)
            + memory / 16.0
            + f64::from(w[width::E] * self.whole_bits())
    }

    fn tables(&self, widths: &Widths) -> Vec<Table> {
        let rom = self.n.table(self.shininess_bits());
        rom.into_iter().chain([self.log_table(), self.exp_table(widths)]).collect()
    }

    fn description(&self, _tables: &[Table]) -> Description {
        let rounded =
            if self.n.is_read() { format!(", n with {} fraction bits", self.shininess_bits()) } else { String::new() };
        Description {
            formula: "y = 2^(-n L(u)), L and 2^-f constant in cells; 0 at x = 0".to_owned(),
            evaluation: format!(
                "In the manner of Harris (IEEE Trans. Computers 53(3), 2004): L = -log2 x comes from a table of {} \
                 octaves of the versine with\n\
                 {} cells each, as words with {} fraction bits{rounded}; the product n L is exact. Its integer part \
                 shifts what a\n\
                 table of {} entries has for its fraction. The result is rounded to nearest.",
                self.octaves(),
                1 << self.log_bits,
                self.log_bits(),
                1 << self.exp_bits,
            ),
        }
    }

    fn lobes(&self, tables: &[Table]) -> Vec<Box<dyn Lobe>> {
        let of = |name: &str| tables.iter().find(|table| table.name == name);
        let words = |table: &Table, name: &str| -> Vec<f64> {
            (0..table.rows()).map(|row| table.field(name).value(row)).collect()
        };
        let log: Arc<[f64]> = of(LOG_TABLE).map(|table| words(table, "log")).unwrap_or_default().into();
        let exp: Arc<[f64]> = of(EXP_TABLE).map(|table| table.field("exp").reals.clone()).unwrap_or_default().into();
        let shininess =
            of(Table::COEFFICIENTS).map_or_else(|| self.interface.shininess.values(), |table| words(table, "n"));
        let octaves = self.octaves() as usize;
        let lobe = |n: f64| {
            Box::new(crate::method::harris::Harris { n, octaves, log: log.clone(), exp: exp.clone() }) as Box<dyn Lobe>
        };
        shininess.into_iter().map(lobe).collect()
    }

    fn build(&self, _widths: &Widths, tables: Vec<Table>) -> Option<Datapath> {
        let (g, bits) = (self.output_bits(), self.exp_bits as i32);
        let exp_memory = tables.len() - 1;
        let case = Case { active: Interval::UNIT, shininess: self.n.largest, rows: vec![None; tables.len()] };
        let mut b = Builder::new(&tables, vec![case]);
        let n = self.n.node(&mut b, &tables);
        let (_, u) = b.operand(self.interface);
        let log = self.logarithm(&mut b, exp_memory - 1, u);
        let z = b.mul(n, log, "z", "z = n L");
        let whole_bits = self.whole_bits();
        let over = b.reaches(z, whole_bits, "over", "z is past what the result can show");
        let whole = whole_bits.min(b.format(z).int_bits);
        let whole = b.cast(z, Format::unsigned(whole, 0), HighBits::Guarded, "i", "the integer part of z");
        let entry =
            b.cast(z, Format::unsigned(0, bits), HighBits::Guarded, "f", "the leading bits of the fraction of z");
        let entry = b.scale(entry, None, bits, &[bits], "entry", "the entry of the second table");
        let power = b.field(exp_memory, entry, "exp");
        // The method's own value is the entry before it was rounded.
        let rounding = tables[exp_memory].field("exp").roundings();
        let bounds = b.bounds(power).iter().map(|bound| Bound { error: rounding, ..*bound }).collect();
        b.assume(power, bounds);
        let shifted = b.shift_right(power, whole, "power_shifted", "2^-z = 2^-f 2^-i");
        let y = b.add_half(shifted, g, "y_half");
        let y = b.cast(y, Format::unsigned(1, g), HighBits::Unused, "y_cut", "rounded to the output's bits");
        let dark = b.reaches(u, 0, "dark", "u = 1: the surface faces away");
        let zero = b.any(&[dark, over], "zero", "the result is 0");
        let y = b.zero_if(zero, y, "y", "y, 0 where it is below half an ulp");
        let gone = Interval::new(-exp2(-(1 << whole_bits)), 0.0);
        let bounds = b.bounds(y).iter().map(|bound| Bound { error: bound.error.hull(gone), ..*bound }).collect();
        b.assume(y, bounds);
        polynomial::finish(b, self.interface, &tables, y, |_| Interval::ZERO)
    }
}
