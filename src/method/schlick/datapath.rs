//! Schlick's lobe `x / (1 + (n-1) u)`.

use crate::datapath::builder::{Bound, Builder, Case};
use crate::datapath::graph::{NodeId, Op};
use crate::datapath::{Architecture, Datapath, Description, Parameter, multiplier_cost};
use crate::fixed::{Format, Interval, Table, Width, Widths};
use crate::lobe::Lobe;
use crate::method::divide::Divider;
use crate::method::divide::datapath as divide;
use crate::method::exponent::exact_bits;
use crate::method::polynomial::datapath::{self as polynomial, rounded_field};
use crate::method::{Interface, width};
use crate::platform::error::Error;

/// `n - 1` of a list.
const N1: Width = Width("n1");

/// `den = 1 + (n-1) u`, `y = x / den`: a multiplication and a division. Where the set is a range, n is `in_n` itself;
/// for a list or materials `n - 1` comes from a ROM.
#[derive(Debug)]
pub struct Schlick<'a> {
    interface: &'a Interface,
    divider: Divider,
    lobes: Vec<crate::method::schlick::Schlick>,
    /// The least and the greatest shininess.
    ends: [f64; 2],
}

impl<'a> Schlick<'a> {
    /// For an interface of this method.
    ///
    /// # Errors
    /// A shininess that the method refuses.
    pub fn new(interface: &'a Interface, divider: Divider) -> Result<Self, Error> {
        let lobes = interface
            .shininess
            .values()
            .into_iter()
            .map(crate::method::schlick::Schlick::new)
            .collect::<Result<Vec<_>, _>>()?;
        let least = lobes.iter().map(|lobe| lobe.n).fold(f64::INFINITY, f64::min);
        let most = lobes.iter().map(|lobe| lobe.n).fold(1.0, f64::max);
        Ok(Self { interface, divider, lobes, ends: [least, most] })
    }

    /// Whether n comes from a ROM.
    fn listed(&self) -> bool {
        !self.interface.shininess.is_at_port()
    }

    /// The integer bits of the denominator, which is n at most.
    fn den_int_bits(&self) -> i32 {
        // Rounding n to a ROM word may lift it to the next power of two.
        libm::ilogb(self.ends[1] + 1.0) + 1
    }

    /// `n - 1` in the graph: from the port clamped to the range, or the ROM's.
    fn less_one(&self, b: &mut Builder) -> NodeId {
        let set = &self.interface.shininess;
        if self.listed() {
            let address = b.address(set, 0);
            return b.field(0, address, "n1");
        }
        let port = b.index(set);
        let code = b.clamped_index(set, port);
        let frac_bits = b.format(code).frac_bits;
        let one = b.constant(1 << frac_bits, b.format(code), "first");
        let range = Interval::new(self.ends[0] - 1.0, self.ends[1] - 1.0);
        let bounds = b.per_case(|_| Bound { range, error: Interval::ZERO, grid: frac_bits });
        b.push(Op::Sub, &[code, one], b.format(code), "n1", "n - 1".to_owned(), bounds)
    }
}

impl Architecture for Schlick<'_> {
    fn parameters(&self) -> Vec<Parameter> {
        let (f, g) = (self.interface.input_fraction as i32, self.interface.output_fraction as i32);
        let magnitude = libm::ilogb(self.ends[1]);
        let mut parameters = vec![
            Parameter::new(width::NUM, "numerator x", g..=g + 4).up_to(f),
            // An error of u is multiplied by n.
            Parameter::new(width::U, "versine u", g + magnitude..=g + magnitude + 5).up_to(f),
            Parameter::new(width::DEN, "denominator 1 + (n-1) u", g..=g + 5),
        ];
        if self.listed() {
            // An error of n is divided by 4n.
            let least = libm::ilogb(self.ends[0]);
            let range = (g - 3 - least).max(0)..=(g + 3 - least).max(0);
            parameters
                .push(Parameter::new(N1, "coefficient n - 1", range).up_to(exact_bits(&self.interface.shininess)));
        }
        parameters.extend(divide::parameters(self.divider, g));
        parameters
    }

    fn cost(&self, w: &Widths) -> f64 {
        let frac = if self.listed() { w[N1] } else { 0 };
        let n_bits = libm::ilogb(self.ends[1]) + 1 + frac;
        let g = self.interface.output_fraction as i32;
        multiplier_cost(n_bits, 1 + w[width::U])
            + f64::from(w[width::U] + w[width::NUM] + n_bits)
            + divide::cost(self.divider, w, g, self.den_int_bits(), w[width::DEN], 1 + w[width::NUM])
    }

    fn tables(&self, widths: &Widths) -> Vec<Table> {
        let mut tables = Vec::new();
        if self.listed() {
            let reals = self.lobes.iter().map(|lobe| lobe.n - 1.0).collect();
            let n1 = rounded_field("n1", "the shininess n, less 1", widths[N1], reals);
            tables.push(self.interface.shininess.rom(vec![n1], 0));
        }
        tables.extend(divide::table(self.divider, widths));
        tables
    }

    fn description(&self, _tables: &[Table]) -> Description {
        let source = if self.listed() { "n comes from the ROM" } else { "n is the input itself, taken into the range" };
        Description {
            formula: "y = x / (1 + (n-1) u)".to_owned(),
            evaluation: format!("As printed: {source}.\n{}", divide::description(self.divider)),
        }
    }

    fn lobes(&self, _tables: &[Table]) -> Vec<Box<dyn Lobe>> {
        self.lobes.iter().map(|&lobe| Box::new(lobe) as Box<dyn Lobe>).collect()
    }

    fn build(&self, widths: &Widths, tables: Vec<Table>) -> Option<Datapath> {
        let g = self.interface.output_fraction as i32;
        let listed = self.listed();
        let memories = tables.len();
        let case = |row: Option<usize>| Case {
            active: Interval::UNIT,
            shininess: row.map_or(self.ends[1], |row| self.lobes[row].n),
            rows: (0..memories).map(|memory| row.filter(|_| memory == 0)).collect(),
        };
        let cases: Vec<Case> =
            if listed { (0..self.lobes.len()).map(|row| case(Some(row))).collect() } else { vec![case(None)] };
        let mut b = Builder::new(&tables, cases);
        let n1 = self.less_one(&mut b);
        let (x, u) = b.operand(self.interface);
        let u = b.floor(u, widths[width::U], "u_cut", "u, rounded down");
        let num = b.floor(x, widths[width::NUM], "num", "x, rounded down");
        let rise = b.mul(n1, u, "n1u", "(n-1) u");
        let rise = b.floor(rise, widths[width::DEN], "rise", "(n-1) u, rounded down");
        let one = b.constant(1, Format::unsigned(1, 0), "unit");
        let den = b.add(one, rise, "den", "the denominator, 1 + (n-1) u");
        let y = b.divide(self.divider, widths, [num, den], g, 0, memories.saturating_sub(1));
        polynomial::finish(b, self.interface, &tables, y, |case| {
            if !listed {
                return Interval::ZERO;
            }
            // The move is -x u delta / (den den'), and x u / (1 + m u)^2 is at most 1/(4 (m + 1)).
            let (real, rounded) = (self.lobes[case].n - 1.0, tables[0].field("n1").value(case));
            let reach = (1.0 / (4.0 * (real.min(rounded) + 1.0))).next_up();
            -(Interval::new(0.0, reach) * Interval::point(rounded - real))
        })
    }
}
