//! One result of a lobe's core.

use super::LobeDesign;
use crate::platform::error::Error;

/// A result of a lobe's core by the bit-exact model, with what it should be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Evaluation {
    /// The code of `in_n`.
    pub index: u32,
    /// The code of the operand's port.
    pub operand: i64,
    /// The code of `out_spec`.
    pub output: u32,
    /// The cosine that the operand counts as, from 0 to 1.
    pub cosine: f64,
    /// The result, from 0 to 1: what `output` stands for.
    pub value: f64,
    /// What the real-valued method gives for this cosine.
    pub method: f64,
    /// `x^n` of this cosine.
    pub exact: f64,
}

impl LobeDesign<'_> {
    /// The result of a lobe for the shininess of a row and the code nearest to a cosine.
    ///
    /// # Errors
    /// A cosine that the operand's port does not hold.
    pub fn at(self, row: usize, cosine: f64) -> Result<Evaluation, Error> {
        let format = self.operand_format();
        let wanted = if self.takes_versine() { 1.0 - cosine } else { cosine };
        let code = (wanted / format.lsb()).round();
        if !(format.min_code() as f64..=format.max_code() as f64).contains(&code) {
            return Err(Error::input(
                format!("{} = {wanted} does not fit {format}", self.operand_name()),
                format!("it holds {} to {}", format.value(format.min_code()), format.value(format.max_code())),
            ));
        }
        let (index, operand) = (self.interface.shininess.index_of_row(row), code as i64);
        let (output, versine) = (self.model().evaluate(index, operand), self.versine(operand));
        Ok(Evaluation {
            index,
            operand,
            output,
            cosine: 1.0 - versine,
            value: self.output_format().value(output.into()),
            method: self.lobes[row].at(versine),
            exact: self.exact(row, operand),
        })
    }
}
