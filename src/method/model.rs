//! The bit-exact reference.
//!
//! Written straight from each method's formula with the crate `fixed`, in ignorance of the datapath graph: the two are
//! compared by the tests, and so is everything else that claims to compute the core's function. A model is given the
//! ROM words and the inner widths; what it does with them is its own account of the arithmetic.

use super::{Configured, InputRange, Interface, Operand, width};
use crate::fixed::wide::{self, Wide};
use crate::fixed::{Table, Width, Widths};

/// A core's function: what the model of its method is given besides the operand.
#[derive(Clone, Copy, Debug)]
pub struct Model<'a> {
    /// The method with its options.
    pub method: &'a Configured,
    /// The shininesses and formats.
    pub interface: &'a Interface,
    /// The inner widths.
    pub widths: &'a Widths,
    /// The ROM words.
    pub tables: &'a [Table],
    /// The numbers of the method that are in no ROM.
    pub constants: &'a [i128],
}

impl Model<'_> {
    /// The code of `out_spec` (UQ1.G) for a code of `in_n` and a code of the operand port (`in_cos` as a signed
    /// number).
    #[must_use]
    pub fn evaluate(&self, index: u32, operand: i64) -> u32 {
        let set = &self.interface.shininess;
        let place = set.row_of_index(index);
        let (row, fraction) = set.knot(place);
        let one = Wide::ONE;
        let operand = wide::from_code(operand.into(), self.interface.input_fraction);
        let within = match self.interface.input_range {
            InputRange::Any => operand.clamp(Wide::ZERO, one),
            InputRange::Unit if operand > one => operand - one,
            InputRange::Unit => operand,
        };
        let x = match self.interface.operand {
            Operand::Cos => within,
            Operand::Versine => one - within,
        };
        let inputs = Inputs {
            interface: self.interface,
            x,
            half_ulp: wide::from_code(1, self.interface.output_fraction + 1),
            fine_input: self.interface.input_fraction > self.interface.output_fraction,
            row,
            fraction: Wide::from_num(fraction),
            n: set.index_of_row(place),
            tables: self.tables,
            constants: self.constants,
            widths: self.widths,
        };
        wide::to_code(self.method.model(&inputs), self.interface.output_fraction) as u32
    }
}

/// What a method's formula is given.
#[derive(Debug)]
pub struct Inputs<'a> {
    pub(super) interface: &'a Interface,
    /// The cosine, in [0, 1].
    pub(super) x: Wide,
    /// Half of the output's last bit.
    pub(super) half_ulp: Wide,
    /// The input has more fraction bits than the output.
    pub(super) fine_input: bool,
    /// The row of the coefficient ROM.
    pub(super) row: usize,
    /// The code of `in_n`, clamped to the set.
    pub(super) n: u32,
    /// How far the shininess lies on the way to the next row.
    pub(super) fraction: Wide,
    pub(super) tables: &'a [Table],
    pub(super) constants: &'a [i128],
    pub(super) widths: &'a Widths,
}

impl Inputs<'_> {
    /// A memory by its name.
    pub(super) fn memory(&self, name: &str) -> &Table {
        self.tables.iter().find(|table| table.name == name).expect("a memory of this method")
    }

    /// A field of a row of a memory.
    pub(super) fn entry(&self, memory: &str, row: usize, name: &str) -> Wide {
        let field = self.memory(memory).field(name);
        let (code, frac_bits) = (field.codes[row], field.format.frac_bits);
        if frac_bits >= 0 { wide::from_code(code, frac_bits as u32) } else { wide::from_code(code << -frac_bits, 0) }
    }

    /// The named coefficient of this shininess: as the ROM holds it, or with its step to the next row for as much of
    /// the way.
    pub(super) fn coefficient(&self, name: &str) -> Wide {
        let base = self.entry(Table::COEFFICIENTS, self.row, name);
        // A step of 0 parts of the way adds nothing.
        let step = if self.fraction == Wide::ZERO { None } else { self.optional(&format!("{name}_step")) };
        match step {
            Some(step) => {
                let frac_bits = self.memory(Table::COEFFICIENTS).field(name).format.frac_bits;
                base + wide::floor_to(step * self.fraction, frac_bits as u32)
            }
            None => base,
        }
    }

    /// The named field of this shininess' row, if the ROM has such a field.
    pub(super) fn optional(&self, name: &str) -> Option<Wide> {
        let has = self.memory(Table::COEFFICIENTS).find(name).is_some();
        has.then(|| self.entry(Table::COEFFICIENTS, self.row, name))
    }

    /// n, where the port holds n itself.
    pub(super) fn port_shininess(&self) -> Option<Wide> {
        let set = &self.interface.shininess;
        set.is_at_port().then(|| wide::from_code(self.n.into(), set.frac_bits()))
    }

    /// n: the port's, or the ROM's.
    pub(super) fn shininess(&self) -> Wide {
        self.port_shininess().unwrap_or_else(|| self.coefficient("n"))
    }

    /// `value`, or 0 at x = 0, where a surface faces away.
    pub(super) fn lit(&self, value: Wide) -> Wide {
        if self.x == Wide::ZERO { Wide::ZERO } else { value }
    }

    /// The kth power, k a power of two, by squarings of which all but the last are rounded down to their width.
    pub(super) fn power(&self, base: Wide, k: u32) -> Wide {
        let mut value = base;
        for level in 0..k.trailing_zeros() {
            if level > 0 {
                value = self.floor(value, width::S);
            }
            value *= value;
        }
        value
    }

    /// `value` rounded down to a width.
    pub(super) fn floor(&self, value: Wide, width: Width) -> Wide {
        wide::floor_to(value, self.widths[width] as u32)
    }

    /// k of this row.
    pub(super) fn shift(&self) -> u32 {
        self.optional("k").map_or(0, |k| k.to_num::<u32>()) + self.memory(Table::COEFFICIENTS).shared_shift
    }

    /// `x (1 - p)` with x and `x p` rounded down to their widths, clamped to [0, 1]; rounded to nearest where the input
    /// is finer than the output.
    pub(super) fn lobe(&self, p: Wide) -> Wide {
        let x = self.floor(self.x, width::X);
        let rounding = if self.fine_input { self.half_ulp } else { Wide::ZERO };
        (x + rounding - self.floor(x * p, width::T)).clamp(Wide::ZERO, Wide::ONE)
    }
}
