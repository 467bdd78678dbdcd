//! The tabulated form of a reflectance: a cell for each step of θh, θd and φd.

use std::f64::consts::{FRAC_PI_2, PI};

use clap::ValueEnum;
use libm::sqrt;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::vector::{Angles, Vector};
use super::{Reflectance, Rgb};
use crate::platform::error::Error;

/// Cells along θh: evenly spaced in √θh, from 0 to 90 degrees.
pub const THETA_H: usize = 90;
/// Cells along θd: one a degree.
pub const THETA_D: usize = 90;
/// Cells along φd of a reciprocal table: one a degree, up to 180.
pub const PHI_D: usize = 180;
/// Cells along φd of a table that need not be reciprocal.
pub const PHI_D_WHOLE: usize = 360;

/// How a value between the cells' centres is found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Lookup {
    /// Interpolated
    #[default]
    Trilinear,
    /// The cell's value, as MERL's own code
    Nearest,
}

/// A table. Cells below the horizon, or without a measurement, are invalid; they have the values of the nearest valid
/// ones.
#[derive(Clone, Debug)]
pub struct Table {
    /// How it is looked up.
    pub lookup: Lookup,
    /// Cells along θh, θd and φd.
    shape: [usize; 3],
    /// Values in 1/sr; φd runs fastest, then θd.
    cells: Vec<[f32; 3]>,
    /// A bit a cell: whether it was measured.
    valid: Bits,
}

/// A set of cells.
#[derive(Clone, Debug, PartialEq)]
struct Bits(Vec<u64>);

impl Bits {
    fn of(count: usize, has: impl Fn(usize) -> bool) -> Self {
        let mut words = vec![0u64; count.div_ceil(64)];
        (0..count).filter(|&cell| has(cell)).for_each(|cell| words[cell / 64] |= 1 << (cell % 64));
        Self(words)
    }

    fn has(&self, cell: usize) -> bool {
        self.0[cell / 64] >> (cell % 64) & 1 == 1
    }

    fn count(&self) -> usize {
        self.0.iter().map(|word| word.count_ones() as usize).sum()
    }
}

impl Table {
    /// A table of cells in 1/sr, φd running fastest, then θd; where a channel is negative the cell is invalid.
    ///
    /// # Errors
    /// A value that is no number or not finite; a table without a valid cell. `name` is the file's, for the message.
    ///
    /// # Panics
    /// If there are not as many cells as the shape says, or none.
    pub fn new(shape: [usize; 3], mut cells: Vec<[f32; 3]>, name: &str) -> Result<Self, Error> {
        assert!(!cells.is_empty() && cells.len() == shape.iter().product::<usize>(), "a cell for each step");
        if let Some(cell) = cells.iter().position(|cell| !cell.iter().all(|value| value.is_finite())) {
            let [h, d, p] = place(shape, cell);
            return Err(Error::input(
                format!(
                    "{name}: the cell θh {h}, θd {d}, φd {p} holds {}, {}, {}",
                    cells[cell][0], cells[cell][1], cells[cell][2]
                ),
                "every value is a finite number of 32 bits; a negative one marks a cell as invalid",
            ));
        }
        let valid = Bits::of(cells.len(), |cell| cells[cell].iter().all(|&value| value >= 0.0));
        match valid.count() {
            0 => Err(Error::input(
                format!("{name}: all {} cells are invalid", cells.len()),
                "a table needs a cell whose three values are at least 0",
            )),
            count => {
                if count < cells.len() {
                    fill(shape, &mut cells, &valid);
                }
                Ok(Self { lookup: Lookup::Trilinear, shape, cells, valid })
            }
        }
    }

    /// The table of a reflectance with 180 or 360 cells along φd: each cell's value is that at its centre. Cells whose
    /// light or viewer is below the horizon are invalid.
    ///
    /// # Errors
    /// If no cell is above the horizon or a value does not fit 32 bits, as [`Table::new`].
    pub fn sampled(reflectance: &dyn Reflectance, phi_d: usize) -> Result<Self, Error> {
        Self::sampled_as(reflectance, [THETA_H, THETA_D, phi_d])
    }

    /// The same with another number of cells; for tests.
    ///
    /// # Errors
    /// As [`Table::sampled`].
    pub fn sampled_as(reflectance: &dyn Reflectance, shape: [usize; 3]) -> Result<Self, Error> {
        let row = |row: usize| {
            (0..shape[2]).map(move |p| {
                let [l, v, n] = centre(shape, [row / shape[1], row % shape[1], p]).vectors();
                if n.dot(&l) <= 0.0 || n.dot(&v) <= 0.0 {
                    return [-1.0; 3];
                }
                reflectance.at(l, v, n).map(|value| value as f32)
            })
        };
        let rows: Vec<Vec<[f32; 3]>> =
            (0..shape[0] * shape[1]).into_par_iter().map(|place| row(place).collect()).collect();
        Self::new(shape, rows.concat(), "the model's table")
    }

    /// Cells along θh, θd and φd.
    #[must_use]
    pub fn shape(&self) -> [usize; 3] {
        self.shape
    }

    /// The values of all cells in 1/sr, the invalid ones filled.
    #[must_use]
    pub fn cells(&self) -> &[[f32; 3]] {
        &self.cells
    }

    /// Whether a cell was measured and not filled.
    #[must_use]
    pub fn is_valid(&self, cell: usize) -> bool {
        self.valid.has(cell)
    }

    /// How many cells were measured.
    #[must_use]
    pub fn valid_count(&self) -> usize {
        self.valid.count()
    }

    /// The largest value of a measured cell in 1/sr.
    #[must_use]
    pub fn largest(&self) -> f64 {
        let valid = self.cells.iter().enumerate().filter(|(cell, _)| self.valid.has(*cell));
        f64::from(valid.flat_map(|(_, cell)| *cell).fold(0.0, f32::max))
    }

    /// The cell of these angles, as the tables' authors count them.
    #[must_use]
    pub fn index(&self, angles: &Angles) -> usize {
        let [h, d, p] = self.coordinates(angles);
        let floor = |coordinate: f64, count: usize| (coordinate as usize).min(count - 1);
        let [nh, nd, np] = self.shape;
        floor(p, np) + np * (floor(d, nd) + nd * floor(h, nh))
    }

    /// Where angles lie among the cells: cell i reaches from i to i + 1.
    #[inline]
    fn coordinates(&self, angles: &Angles) -> [f64; 3] {
        let [h, d, p] = self.shape.map(|count| count as f64);
        // A reciprocal table has half of the circle.
        let turn = if self.is_whole() { 2.0 * PI } else { PI };
        let phi_d = if angles.phi_d < turn { angles.phi_d } else { angles.phi_d - turn };
        [h * sqrt(angles.theta_h / FRAC_PI_2), d * angles.theta_d / FRAC_PI_2, p * phi_d / turn]
    }

    /// Whether φd goes all around, so that the table need not be reciprocal.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.shape[2] == PHI_D_WHOLE
    }

    /// The value at these angles in 1/sr, interpolated between the centres of cells; above the last centre and below
    /// the first it stays.
    #[must_use]
    pub fn trilinear(&self, angles: &Angles) -> Rgb {
        let [nh, nd, np] = self.shape;
        let [h, d, p] = self.coordinates(angles).map(|coordinate| coordinate - 0.5);
        let held = |coordinate: f64, count: usize| {
            let low = (coordinate.max(0.0) as usize).min(count - 1);
            (low, (low + 1).min(count - 1), (coordinate - low as f64).clamp(0.0, 1.0))
        };
        let (h0, h1, ht) = held(h, nh);
        let (d0, d1, dt) = held(d, nd);
        // φd comes round.
        let (p0, p1, pt) = if p < 0.0 {
            (np - 1, 0, p + 1.0)
        } else {
            let low = (p as usize).min(np - 1);
            (low, if low + 1 == np { 0 } else { low + 1 }, (p - low as f64).min(1.0))
        };
        let along = |h: usize, d: usize| {
            let row = &self.cells[np * (d + nd * h)..][..np];
            let (a, b) = (row[p0], row[p1]);
            [0, 1, 2].map(|c| f64::from(a[c]) * (1.0 - pt) + f64::from(b[c]) * pt)
        };
        let mix = |a: Rgb, b: Rgb, t: f64| [0, 1, 2].map(|c| a[c] * (1.0 - t) + b[c] * t);
        mix(mix(along(h0, d0), along(h0, d1), dt), mix(along(h1, d0), along(h1, d1), dt), ht)
    }

    /// The value of the cell of these angles in 1/sr.
    #[must_use]
    pub fn nearest(&self, angles: &Angles) -> Rgb {
        self.cells[self.index(angles)].map(f64::from)
    }

    /// The table with 180 cells along φd, as the mean of both directions, or with 360.
    #[must_use]
    pub fn with_phi_d(&self, phi_d: usize) -> Self {
        let [nh, nd, np] = self.shape;
        if np == phi_d {
            return self.clone();
        }
        let cells = (0..nh * nd).flat_map(|row| {
            (0..phi_d).map(move |p| {
                let at = |p: usize| row * np + p % np;
                if phi_d > np {
                    return (self.cells[at(p)], self.is_valid(at(p)));
                }
                let (one, other) = (at(p), at(p + phi_d));
                match (self.is_valid(one), self.is_valid(other)) {
                    (true, false) => (self.cells[one], true),
                    (false, true) => (self.cells[other], true),
                    (valid, _) => ([0, 1, 2].map(|c| 0.5 * (self.cells[one][c] + self.cells[other][c])), valid),
                }
            })
        });
        let (cells, valid): (Vec<_>, Vec<bool>) = cells.unzip();
        let valid = Bits::of(cells.len(), |cell| valid[cell]);
        Self { lookup: self.lookup, shape: [nh, nd, phi_d], cells, valid }
    }
}

impl Reflectance for Table {
    fn at(&self, l: Vector, v: Vector, n: Vector) -> Rgb {
        if n.dot(&l) <= 0.0 || n.dot(&v) <= 0.0 {
            return [0.0; 3];
        }
        match (Angles::of(l, v, n), self.lookup) {
            (None, _) => [0.0; 3],
            (Some(angles), Lookup::Trilinear) => self.trilinear(&angles),
            (Some(angles), Lookup::Nearest) => self.nearest(&angles),
        }
    }
}

/// The steps along θh, θd and φd of a cell.
fn place([_, nd, np]: [usize; 3], cell: usize) -> [usize; 3] {
    [cell / np / nd, cell / np % nd, cell % np]
}

/// The angles of the centre of a cell.
#[must_use]
pub fn centre([nh, nd, np]: [usize; 3], [h, d, p]: [usize; 3]) -> Angles {
    let part = |step: usize, count: usize| (step as f64 + 0.5) / count as f64;
    let turn = if np == PHI_D_WHOLE { 2.0 * PI } else { PI };
    let root = part(h, nh);
    Angles { theta_h: FRAC_PI_2 * root * root, theta_d: FRAC_PI_2 * part(d, nd), phi_d: turn * part(p, np) }
}

/// Gives the invalid cells the values of the nearest valid ones, in steps along the axes, and their mean where several
/// are equally near: φd comes round. So no interpolation sees what was never measured.
fn fill([nh, nd, np]: [usize; 3], cells: &mut [[f32; 3]], valid: &Bits) {
    let neighbours = |cell: usize| {
        let [h, d, p] = place([nh, nd, np], cell);
        let row = cell - p;
        [
            Some(row + if p == 0 { np - 1 } else { p - 1 }),
            Some(row + if p + 1 == np { 0 } else { p + 1 }),
            (d > 0).then(|| cell - np),
            (d + 1 < nd).then(|| cell + np),
            (h > 0).then(|| cell - np * nd),
            (h + 1 < nh).then(|| cell + np * nd),
        ]
    };
    const EMPTY: u8 = 0;
    const NEXT: u8 = 1;
    const FULL: u8 = 2;
    let mut state: Vec<u8> = (0..cells.len()).map(|cell| if valid.has(cell) { FULL } else { EMPTY }).collect();
    let mut front: Vec<u32> = Vec::new();
    for cell in 0..cells.len() {
        if state[cell] == EMPTY && neighbours(cell).into_iter().flatten().any(|other| state[other] == FULL) {
            state[cell] = NEXT;
            front.push(cell as u32);
        }
    }
    while !front.is_empty() {
        for &cell in &front {
            let (mut sum, mut count) = ([0.0f64; 3], 0);
            for other in neighbours(cell as usize).into_iter().flatten().filter(|&other| state[other] == FULL) {
                (0..3).for_each(|c| sum[c] += f64::from(cells[other][c]));
                count += 1;
            }
            cells[cell as usize] = sum.map(|sum| (sum / f64::from(count)) as f32);
        }
        front.iter().for_each(|&cell| state[cell as usize] = FULL);
        let mut next = Vec::new();
        for &cell in &front {
            for other in neighbours(cell as usize).into_iter().flatten() {
                if state[other] == EMPTY {
                    state[other] = NEXT;
                    next.push(other as u32);
                }
            }
        }
        front = next;
    }
}
