//! The turns of the form paper: IB equations 2 and 3 in the formats of the hardware.
//!
//! With n turned back by γ, the image at φ_i is looked up where n is after a turn by `k (φ_i - φ)` about y,
//! `k = (1 + sin αh)/2`; so a light record has half of each image's `φ_i - φ`, and the turn is that times
//! `1 + sin αh`. With h = (sin φ/2, 0, cos φ/2) the sine is `|x cos φ/2 - z sin φ/2| / √(1 - y²)`, the numerator a
//! scalar product like the first one of the form half. Where αh passes 90 degrees equation 3 is to be limited; no light
//! reaches such a normal, and here it is not.

use super::texels::OctaveAxis;
use crate::fixed::{Field, Format, Table, exp2, interned};

/// Fraction bits of angles, whose unit is a right angle.
pub(super) const ANGLE: i32 = 14;
/// Fraction bits of sines and cosines.
pub(super) const SINE: i32 = 14;
/// Fraction bits of sin αh.
pub(super) const TILT: i32 = 12;
/// The steps of a right angle in the table of sines, as bits.
pub(super) const STEPS: i32 = 6;
/// Fraction bits of the differences between the table's rows.
const DIFFERENCE: i32 = SINE + 2;

/// The numbers `1 - y²` that the table of reciprocal roots has rows for.
pub(super) const ROOT_AXIS: OctaveAxis = OctaveAxis { size: 128, octave_bits: 4 };
/// The octaves of these.
pub(super) const ROOT_OCTAVES: u32 = ROOT_AXIS.size >> ROOT_AXIS.octave_bits;
/// Bits of the weights between its rows.
pub(super) const ROOT_WEIGHT: u32 = 5;
/// Fraction bits of `1 - y²`.
pub(super) const ROOT_OPERAND: i32 = (ROOT_OCTAVES - 1 + ROOT_AXIS.octave_bits + ROOT_WEIGHT) as i32;
/// Fraction bits of reciprocal roots.
pub(super) const ROOT: i32 = 10;
/// Integer bits of them.
const ROOT_INT: i32 = 6;

/// The format of half of an image's angle less the light's: less than a right angle.
pub(super) const HALF_TURN: Format = Format::signed(0, ANGLE);

/// Half of the greatest turn, as a code: half of a right angle.
pub(super) const MOST_HALF: u64 = 1 << (ANGLE - 1);

/// A value as the nearest code of a format, and within it.
pub(super) fn field(name: &'static str, meaning: &'static str, format: Format, reals: Vec<f64>) -> Field {
    let one = exp2(format.frac_bits);
    let code = |real: &f64| (libm::round(real * one) as i128).clamp(format.min_code(), format.max_code());
    Field { name, meaning, format, codes: reals.iter().map(code).collect(), reals }
}

/// Each number's difference from the next.
pub(super) fn differences(values: &[f64]) -> Vec<f64> {
    values.windows(2).map(|two| two[1] - two[0]).collect()
}

/// Reciprocal roots over the last columns of an axis.
pub(super) struct ReciprocalRoots {
    /// The axis of the numbers.
    pub(super) axis: OctaveAxis,
    /// The first of the columns that have a row.
    pub(super) first: u32,
    /// The formats of the roots and of what they fall by.
    pub(super) formats: [Format; 2],
    /// The names of the table and of these fields.
    pub(super) names: [&'static str; 3],
    /// What a root is of.
    pub(super) meaning: &'static str,
}

impl ReciprocalRoots {
    /// `1/√r` of an axis's number r, 1 at its end.
    pub(super) fn of(axis: OctaveAxis, column: u32) -> f64 {
        match column {
            // The row at 0 is of half of the next.
            0 => 1.0 / libm::sqrt(0.5 * axis.versine(1)),
            _ if column == axis.size => 1.0,
            _ => 1.0 / libm::sqrt(axis.versine(column)),
        }
    }

    /// The table: each row with what it falls by to the next.
    pub(super) fn table(self) -> Table {
        let Self { axis, first, formats, names, meaning } = self;
        let roots: Vec<f64> = (first..=axis.size).map(|column| Self::of(axis, column)).collect();
        let falls = differences(&roots).into_iter().map(|rise| -rise).collect();
        let fields = vec![
            field(names[1], meaning, formats[0], roots[..roots.len() - 1].to_vec()),
            field(names[2], "what it falls by to the next row", formats[1], falls),
        ];
        let keys = (first..axis.size).map(|column| axis.versine(column)).collect();
        Table::listed(names[0], "entry", keys, fields)
    }
}

/// `1/√r` where r is [`ROOT_AXIS`]'s, each row with what it falls by to the next.
fn reciprocal_roots(light: usize) -> Table {
    let names = ["roots", "root", "fall"].map(|what| interned(format!("{what}_{}", light + 1)));
    let formats = [Format::unsigned(ROOT_INT, ROOT), Format::unsigned(ROOT_INT - 1, ROOT)];
    ReciprocalRoots { axis: ROOT_AXIS, first: 0, formats, names, meaning: "1/sqrt(1 - y^2)" }.table()
}

/// Sine and cosine from minus a right angle to one, each row with the way to the next, for the images of a parity.
fn sines(light: usize, parity: &str) -> Table {
    let name = |what: &str| interned(format!("{what}_{}_{parity}", light + 1));
    let steps = 1i32 << STEPS;
    let angles: Vec<f64> = (-steps..=steps).map(|step| f64::from(step) / f64::from(steps)).collect();
    let [sines, cosines] = [libm::sin, libm::cos].map(|function| -> Vec<f64> {
        angles.iter().map(|angle| function(angle * std::f64::consts::FRAC_PI_2)).collect()
    });
    let rows = angles.len() - 1;
    let difference = |signed| Format { signed, int_bits: 1 - STEPS, frac_bits: DIFFERENCE };
    let fields = vec![
        field(name("sine"), "the sine", Format::signed(0, SINE), sines[..rows].to_vec()),
        field(name("sine_rise"), "what it rises by to the next row", difference(false), differences(&sines)),
        field(name("cosine"), "the cosine", Format::unsigned(1, SINE), cosines[..rows].to_vec()),
        field(name("cosine_rise"), "what it rises by to the next row", difference(true), differences(&cosines)),
    ];
    Table::listed(name("sines"), "entry", angles[..rows].to_vec(), fields)
}

/// The tables of a light, in this order: reciprocal roots, the sines of the even images and those of the odd ones.
pub(super) fn tables(light: usize) -> Vec<Table> {
    vec![reciprocal_roots(light), sines(light, "even"), sines(light, "odd")]
}
