//! The power from a table.

use crate::lobe::{Lobe, check_shininess, exact};
use crate::platform::error::Error;

/// `x^n` as a constant in each of equal cells of the versine: midway between the values at the cell's ends, which is
/// the constant with the least largest error. 0 at x = 0, where a surface faces away.
#[derive(Clone, Debug, PartialEq)]
pub struct Tabulated {
    /// The value of each cell.
    pub entries: Vec<f64>,
}

impl Tabulated {
    /// The table for the shininess `n` in `cells` cells, for versines that are multiples of `step`.
    ///
    /// # Errors
    /// See [`check_shininess`].
    pub fn new(n: f64, cells: usize, step: f64) -> Result<Self, Error> {
        check_shininess(n)?;
        let width = 1.0 / cells as f64;
        let entry = |cell: usize| {
            let first = cell as f64 * width;
            // A cell narrower than a step holds its first versine only, if any.
            0.5 * (exact(n, first) + exact(n, first + (width - step).max(0.0)))
        };
        Ok(Self { entries: (0..cells).map(entry).collect() })
    }
}

impl Lobe for Tabulated {
    fn at(&self, u: f64) -> f64 {
        if u >= 1.0 { 0.0 } else { self.entries[(u * self.entries.len() as f64) as usize] }
    }
}
