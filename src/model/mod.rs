//! The bit-exact reference.
//!
//! Written straight from each method's formula with the crate `fixed`, in ignorance of the datapath graph: the two are
//! compared by the tests, and so is everything else that claims to compute the core's function. A model is given the
//! ROM words and the inner widths; what it does with them is its own account of the arithmetic.

mod cubic;
mod cubic_rational;
mod divide;
mod harris;
mod log_exp;
mod power;
mod quadratic;
mod schlick;
mod segmented;
mod shader;
mod squaring;
mod tabulated;

pub use shader::{Cosines, ShaderModel};

use crate::fixed::wide::{self, Wide};
use crate::emit::rom::Table;
use crate::spec::{CoreSpec, Form, InputRange, Method, Operand, Widths};

/// The core's function for one spec.
#[derive(Clone, Debug)]
pub struct Model<'a> {
    spec: &'a CoreSpec,
    widths: &'a Widths,
    tables: &'a [Table],
    constants: &'a [i128],
}

impl<'a> Model<'a> {
    /// The model of a core with these widths, ROM words, and numbers of its method that are in no ROM.
    #[must_use]
    pub fn new(spec: &'a CoreSpec, widths: &'a Widths, tables: &'a [Table], constants: &'a [i128]) -> Self {
        Self { spec, widths, tables, constants }
    }

    /// The code of `out_spec` (UQ1.G) for a code of `in_n` and a code of the operand port (`in_cos` as a signed number).
    #[must_use]
    pub fn evaluate(&self, index: u32, operand: i64) -> u32 {
        let (row, fraction) = self.spec.shininess.knot(self.spec.shininess.row_of_index(index));
        let one = Wide::ONE;
        let operand = wide::from_code(operand.into(), self.spec.input_fraction);
        let within = match self.spec.input_range {
            InputRange::Any => operand.clamp(Wide::ZERO, one),
            InputRange::Unit if operand > one => operand - one,
            InputRange::Unit => operand,
        };
        let x = match self.spec.operand {
            Operand::Cos => within,
            Operand::Versine => one - within,
        };
        let inputs = Inputs {
            spec: self.spec,
            x,
            half_ulp: wide::from_code(1, self.spec.output_fraction + 1),
            fine_input: self.spec.input_fraction > self.spec.output_fraction,
            row,
            fraction: Wide::from_num(fraction),
            n: self.spec.shininess.index_of_row(self.spec.shininess.row_of_index(index)),
            tables: self.tables,
            widths: self.widths,
        };
        let y = match (self.spec.method, self.spec.form) {
            (Method::Quadratic, Form::Stable) => quadratic::stable(&inputs),
            (Method::Quadratic, Form::Paper) => quadratic::paper(&inputs),
            (Method::Cubic, Form::Stable) | (Method::CubicThreePoint, _) => cubic::stable(&inputs),
            (Method::Cubic, Form::Paper) => cubic::paper(&inputs),
            (Method::CubicMinZero, _) => power::min_zero(&inputs),
            (Method::Power2 | Method::Power4 | Method::Power8, _) => power::rom(&inputs, self.spec.method),
            (Method::Lyon2 | Method::Lyon4 | Method::Lyon8, _) => power::lyon(&inputs, self.spec),
            (Method::Segmented2 | Method::Segmented4 | Method::Segmented8, _) => {
                segmented::segmented(&inputs, self.constants)
            }
            (Method::Schlick, _) => schlick::schlick(&inputs),
            (Method::CubicRational, _) => cubic_rational::cubic_rational(&inputs),
            (Method::LogExp, _) => match self.spec.accuracy {
                None => log_exp::evaluate(&inputs, self.spec),
                Some(bits) => log_exp::coarse(&inputs, self.spec, bits),
            },
            (Method::Squaring, _) => squaring::squaring(&inputs, self.spec),
            (Method::Harris, _) => harris::harris(&inputs, self.spec),
            (Method::Table, _) => tabulated::tabulated(&inputs, self.spec),
        };
        wide::to_code(y, self.spec.output_fraction) as u32
    }
}

/// What a method's formula is given.
struct Inputs<'a> {
    spec: &'a CoreSpec,
    /// The cosine, in [0, 1].
    x: Wide,
    /// Half of the output's last bit.
    half_ulp: Wide,
    /// The input has more fraction bits than the output.
    fine_input: bool,
    /// The row of the coefficient ROM.
    row: usize,
    /// The code of `in_n`, taken into the set.
    n: u32,
    /// How far the shininess lies on the way to the next row.
    fraction: Wide,
    tables: &'a [Table],
    widths: &'a Widths,
}

impl Inputs<'_> {
    /// A memory by its name.
    fn memory(&self, name: &str) -> &Table {
        self.tables.iter().find(|table| table.name == name).expect("a memory of this method")
    }

    /// A field of a row of a memory.
    fn entry(&self, memory: &str, row: usize, name: &str) -> Wide {
        let field = self.memory(memory).field(name);
        let (code, frac_bits) = (field.codes[row], field.format.frac_bits);
        if frac_bits >= 0 { wide::from_code(code, frac_bits as u32) } else { wide::from_code(code << -frac_bits, 0) }
    }

    /// The named coefficient of this shininess: as the ROM holds it, or with its step to the next row for as much of the way.
    fn coefficient(&self, name: &str) -> Wide {
        let base = self.entry(Table::COEFFICIENTS, self.row, name);
        match self.optional(&format!("{name}_step")) {
            Some(step) => {
                let frac_bits = self.memory(Table::COEFFICIENTS).field(name).format.frac_bits;
                base + wide::floor_to(step * self.fraction, frac_bits as u32)
            }
            None => base,
        }
    }

    /// The named field of this shininess' row, if the ROM has such a field.
    fn optional(&self, name: &str) -> Option<Wide> {
        let has = self.memory(Table::COEFFICIENTS).find(name).is_some();
        has.then(|| self.entry(Table::COEFFICIENTS, self.row, name))
    }

    /// `value`, or 0 at x = 0, where a surface faces away.
    fn lit(&self, value: Wide) -> Wide {
        if self.x == Wide::ZERO { Wide::ZERO } else { value }
    }

    /// The kth power, k a power of two, by squarings of which all but the last are rounded down to their width.
    fn power(&self, base: Wide, k: u32) -> Wide {
        let mut value = base;
        for level in 0..k.trailing_zeros() {
            if level > 0 {
                value = self.floor(value, "s");
            }
            value *= value;
        }
        value
    }

    /// `value` rounded down to the named width.
    fn floor(&self, value: Wide, name: &str) -> Wide {
        wide::floor_to(value, self.widths.get(name) as u32)
    }

    /// k of this row.
    fn shift(&self) -> u32 {
        self.optional("k").map_or(0, |k| k.to_num::<u32>()) + self.memory(Table::COEFFICIENTS).shared_shift
    }

    /// `x (1 - p)` with x and `x p` rounded down to their widths, taken into [0, 1]; rounded to nearest where the input is
    /// finer than the output.
    fn lobe(&self, p: Wide) -> Wide {
        let x = self.floor(self.x, "x");
        let rounding = if self.fine_input { self.half_ulp } else { Wide::ZERO };
        (x + rounding - self.floor(x * p, "t")).clamp(Wide::ZERO, Wide::ONE)
    }
}
