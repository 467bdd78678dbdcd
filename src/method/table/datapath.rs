//! The power from a table by the shininess and the leading bits of the versine.
//!
//! A word is the nearest code to its entry, so that the whole error is half an output ulp; where the surface faces
//! away, the result is 0.

use crate::datapath::builder::{Builder, Case, HighBits};
use crate::datapath::{Architecture, Datapath, Description, Parameter};
use crate::fixed::{Format, Interval, Table, Widths, exp2};
use crate::lobe::Lobe;
use crate::method::Interface;
use crate::method::polynomial::datapath::{self as polynomial, rounded_field};
use crate::platform::error::Error;

/// The most entries of a table: at 16 bits 2 Mbit, half of the block RAM of a large device of the ECP5 family.
const MOST_ENTRIES: usize = 1 << 17;

/// The memory of the power.
const POWER_TABLE: &str = "power_table";

/// A look-up: the set's row and the cell of the versine side by side are the address.
#[derive(Debug)]
pub struct Tabulated<'a> {
    interface: &'a Interface,
    table_bits: u32,
    lobes: Vec<crate::method::table::Tabulated>,
}

impl<'a> Tabulated<'a> {
    /// For an interface of this method.
    ///
    /// # Errors
    /// A shininess that the method refuses, and a table of more than 2^17 entries.
    pub fn new(interface: &'a Interface, table_bits: u32) -> Result<Self, Error> {
        let (rows, cells) = (interface.shininess.rows(), 1usize << table_bits);
        if rows.next_power_of_two() * cells > MOST_ENTRIES {
            let most = MOST_ENTRIES / rows.next_power_of_two();
            let allowed = if most < 1usize << super::TABLE_BITS.start() {
                "give fewer shininesses, as a list".to_owned()
            } else {
                format!(
                    "table_bits is at most {} for {rows} shininesses; or give fewer of them, as a list",
                    most.ilog2()
                )
            };
            return Err(Error::input(
                format!("a table of {rows} shininesses with {cells} entries each is too large"),
                format!("it may have {MOST_ENTRIES} entries, the shininesses counted up to a power of two: {allowed}"),
            ));
        }
        let step = exp2(-(interface.input_fraction as i32));
        let lobes =
            interface.shininess.values().into_iter().map(|n| crate::method::table::Tabulated::new(n, cells, step));
        Ok(Self { interface, table_bits, lobes: lobes.collect::<Result<_, _>>()? })
    }

    fn cells(&self) -> usize {
        1 << self.table_bits
    }
}

impl Architecture for Tabulated<'_> {
    fn parameters(&self) -> Vec<Parameter> {
        Vec::new()
    }

    fn cost(&self, _widths: &Widths) -> f64 {
        (self.lobes.len() * self.cells()) as f64 * f64::from(self.interface.output_fraction + 1) / 16.0
    }

    fn tables(&self, _widths: &Widths) -> Vec<Table> {
        let reals: Vec<f64> = self.lobes.iter().flat_map(|lobe| lobe.entries.iter().copied()).collect();
        let whole = self.interface.shininess.rom(Vec::new(), 0);
        let values = rounded_field("y", "x^n midway in the cell", self.interface.output_fraction as i32, reals);
        let mut table = Table::parts(&whole, self.cells(), vec![values]).named(POWER_TABLE);
        // A function table: its entries are told apart one by one.
        (table.key, table.keys) = ("entry", (0..table.rows()).map(|entry| entry as f64).collect());
        vec![table]
    }

    fn description(&self, tables: &[Table]) -> Description {
        Description {
            formula: "y = x^n midway between its values at the ends of a cell of the versine; 0 at x = 0".to_owned(),
            evaluation: format!(
                "A table of {} entries for each shininess, {} in all, rounded to nearest: the address is the shininess \
                 and the {} leading\n\
                 bits of the versine.",
                self.cells(),
                tables[0].rows(),
                self.table_bits,
            ),
        }
    }

    fn lobes(&self, _tables: &[Table]) -> Vec<Box<dyn Lobe>> {
        self.lobes.iter().map(|lobe| Box::new(lobe.clone()) as Box<dyn Lobe>).collect()
    }

    fn build(&self, _widths: &Widths, tables: Vec<Table>) -> Option<Datapath> {
        let (_, most) = self.interface.shininess.ends();
        let case = Case { active: Interval::UNIT, shininess: most, rows: vec![None] };
        let mut b = Builder::new(&tables, vec![case]);
        let address = b.address(&self.interface.shininess, 0);
        let (_, u) = b.operand(self.interface);
        let bits = self.table_bits as i32;
        let cell =
            b.cast(u, Format::unsigned(0, bits), HighBits::Guarded, "cell", "the cell of the versine, for u below 1");
        let cell = b.scale(cell, None, bits, &[bits], "cell_number", "the number of the cell");
        let address = b.part_address(address, cell, 0);
        let y = b.field(0, address, "y");
        let y = polynomial::lit(&mut b, u, y);
        // In the port's format, where no entry comes up to 1.
        let y = b.cast(
            y,
            Format::unsigned(1, self.interface.output_fraction as i32),
            HighBits::Unused,
            "y_wide",
            "with an integer bit",
        );
        polynomial::finish(b, self.interface, &tables, y, |_| tables[0].field("y").roundings())
    }
}
