//! The tables by which a core computes a light's record from the vector l towards it, and their formats.
//!
//! With the viewer's direction v at +z, `l·v = l_z` is the cosine of the light's polar angle φ. What follows from φ
//! alone is looked up: over `1 - |l_z|` as a number with an exponent, the rows of `l_z >= 0` before those of
//! `l_z < 0`, because φ and its half's sine or cosine go as a root of it at either end. These are the place of φ among
//! the bands, which are evenly spaced, and
//!
//! - in the form half the cosine and the sine of φ/2, whose products with cos γ and sin γ are the rows of the turn.
//!   With `ρ² = l_x² + l_y²` these are `l_x/ρ` and `l_y/ρ`: ρ² is multiplied by four, and l_x and l_y by two, until ρ²
//!   is from 1/4 to 1, where a table has 1/ρ. Below the axis's least octave γ is 0: the slices of a light so near to
//!   the viewer are round.
//! - in the form bivariate `r = 1/√(2 + 2 l_z)`, which makes a unit vector of `l + v`. An error of r changes the length
//!   of h alone, and `|n - h|²/2` by no more than a part of itself and the square of the error.
//!
//! The blend of two bands and the gain of intensity 1 are looked up at the place among the bands, at which each band
//! has a row and rows evenly spaced up to the next: the kinks at the bands are exact. A row has an exponent for its
//! gains. Between two rows each function goes along a line.

use super::turn::{ReciprocalRoots, differences, field};
use super::{GAIN, GAIN_INT, Image, ImageForm, OctaveAxis, record};
use crate::fixed::{Field, Format, Table, exp2, interned};
use crate::reflectance::texels::Texels;

/// Fraction bits of sines, cosines and reciprocal roots: with a sign an operand of a multiplier.
pub(super) const UNIT: i32 = 16;
/// Fraction bits of r in the form bivariate, and its integer bits.
pub(super) const HALF_ROOT: i32 = 11;
pub(super) const HALF_ROOT_INT: i32 = 6;

/// The numbers ρ² that 1/ρ is found by.
pub(super) const AZIMUTH: OctaveAxis = OctaveAxis { size: 512, octave_bits: 5 };
/// The greatest exponent that l_x and l_y are multiplied with.
pub(super) const AZIMUTH_SHIFT: i32 = (AZIMUTH.size >> AZIMUTH.octave_bits) as i32 / 2 - 1;
/// Bits of the weights between its rows.
pub(super) const AZIMUTH_WEIGHT: u32 = 6;
/// Fraction bits of ρ².
pub(super) const AZIMUTH_OPERAND: i32 =
    (AZIMUTH.size >> AZIMUTH.octave_bits) as i32 - 1 + (AZIMUTH.octave_bits + AZIMUTH_WEIGHT) as i32;

/// The octaves of `1 - |l_z|`, as bits, and the most columns an octave.
const POLAR_OCTAVE_BITS: u32 = 3;
const POLAR_COLUMN_BITS: u32 = 5;
/// The most bits of the weights between the rows of the polar angle.
const POLAR_WEIGHT: u32 = 8;

/// The most rows between two bands, and in all, as bits.
const STEP_BITS: u32 = 4;
const ROW_BITS: u32 = 9;

/// The meaning of a field's rise.
const RISES: &str = "what it rises by to the next row";

/// Formats of a front end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct FrontEndFormats {
    /// The numbers `1 - |l_z|` that the table of the polar angle has rows for.
    pub(super) polar: OctaveAxis,
    /// Bits of the weights between these.
    pub(super) polar_weight: u32,
    /// Bits of a band's number.
    pub(super) band: u32,
    /// Fraction bits of a place among the bands.
    pub(super) place: u32,
    /// The rows from a band to the next, as bits.
    pub(super) step_bits: u32,
    /// Fraction bits of a blend in the table.
    pub(super) blend: u32,
}

impl Image {
    /// The formats of its front end.
    pub(super) fn front_end_formats(&self) -> FrontEndFormats {
        // Columns of the least octave are not closer than the codes of a component.
        let octave_bits = POLAR_COLUMN_BITS.min(self.vector_fraction + 1 - (1 << POLAR_OCTAVE_BITS));
        let band = Self::place_bits(self.extents()[0]);
        FrontEndFormats {
            polar: OctaveAxis { size: 1 << (POLAR_OCTAVE_BITS + octave_bits), octave_bits },
            polar_weight: POLAR_WEIGHT.min(self.vector_fraction - 1 - octave_bits),
            band,
            place: self.weight_bits + 5,
            step_bits: STEP_BITS.min(ROW_BITS.saturating_sub(band)),
            blend: self.weight_bits + 4,
        }
    }
}

/// A row of the table of bands.
#[derive(Clone, Copy, Debug)]
struct BandRow {
    /// The light's polar angle in degrees.
    phi: f64,
    /// The weight of the band with an odd number in the blend of a band with the next.
    odd: f64,
    /// The gain of a light of intensity 1.
    gain: f64,
}

/// The rows from each band to the next, and the last band's.
fn band_rows(image: &Image, texels: &Texels) -> Vec<BandRow> {
    let angles = image.band_angles();
    let steps = 1usize << image.front_end_formats().step_bits;
    let row = |number: usize| {
        let (band, step) = (number / steps, number % steps);
        let (next, t) = ((band + 1).min(angles.len() - 1), step as f64 / steps as f64);
        let [own, of_next] = texels.weights([band, next], t);
        let weight = own + of_next;
        let [even, odd] = if band % 2 == 0 { [own, of_next] } else { [of_next, own] };
        BandRow {
            phi: angles[band] * (1.0 - t) + angles[next] * t,
            // Without a weight the band itself.
            odd: if weight > 0.0 { odd / (even + odd) } else { f64::from(u8::from(band % 2 == 1)) },
            gain: record::gain(image, weight),
        }
    };
    (0..=(angles.len() - 1) * steps).map(row).collect()
}

/// The exponent of a row's gains: that of the greater one of its ends.
fn row_shifts(rows: &[BandRow]) -> Vec<i32> {
    let next = |number: usize| rows[(number + 1).min(rows.len() - 1)].gain;
    rows.iter().enumerate().map(|(number, row)| record::shift(row.gain.max(next(number)))).collect()
}

/// The exponents of the gains with the least angle in degrees that a light has there.
pub(super) fn shifts(image: &Image, texels: &Texels) -> Vec<(f64, i32)> {
    let rows = band_rows(image, texels);
    rows.iter().map(|row| row.phi).zip(row_shifts(&rows)).collect()
}

/// A field of the narrowest format with so many fraction bits, and a sign where it is wanted.
fn narrow(name: &'static str, meaning: &'static str, frac_bits: i32, reals: Vec<f64>) -> Field {
    let code = |real: f64| libm::round(real * exp2(frac_bits)) as i128;
    let least = reals.iter().copied().fold(0.0, f64::min);
    let greatest = reals.iter().copied().fold(0.0, f64::max);
    field(name, meaning, Format::holding(code(least), code(greatest), frac_bits), reals)
}

/// The name of a light's table or field.
fn name(what: &str, light: usize) -> &'static str {
    interned(format!("{what}_{}", light + 1))
}

/// A function at the rows of `l_z >= 0` and of `l_z < 0`, and its rise from each to the next.
fn both_ends(image: &Image, function: impl Fn(f64) -> f64) -> [Vec<f64>; 2] {
    let axis = image.front_end_formats().polar;
    let mut values = Vec::new();
    let mut rises = Vec::new();
    for sign in [1.0, -1.0] {
        let versine = |column: u32| if column == axis.size { 1.0 } else { axis.versine(column) };
        let of_end: Vec<f64> = (0..=axis.size).map(|column| function(sign * (1.0 - versine(column)))).collect();
        rises.extend(differences(&of_end));
        values.extend_from_slice(&of_end[..axis.size as usize]);
    }
    [values, rises]
}

/// What follows from l_z: in this order the place among the bands, and in the form half the cosine of φ/2 and minus its
/// sine, in the form bivariate r, each with its rise.
fn polar(image: &Image, light: usize) -> Table {
    let formats = image.front_end_formats();
    let angles = image.band_angles();
    let last = angles.len() - 1;
    let place = |z: f64| libm::acos(z).to_degrees() / angles[last] * last as f64;
    let [places, place_rises] = both_ends(image, place);
    let bits = formats.place as i32;
    let mut fields = vec![
        field(name("place", light), "the place among the bands", Format::unsigned(formats.band as i32, bits), places),
        narrow(name("place_rise", light), RISES, bits, place_rises),
    ];
    match image.form {
        ImageForm::Bivariate { .. } => {
            let axis = formats.polar;
            // 1/√(2d) behind, where the row at 0 is of half of the next, and a smooth function in front.
            let root = |z: f64| match 1.0 + z {
                0.0 => ReciprocalRoots::of(axis, 0) * libm::sqrt(0.5),
                d => 1.0 / libm::sqrt(2.0 * d),
            };
            let [roots, rises] = both_ends(image, root);
            let format = Format::unsigned(HALF_ROOT_INT, HALF_ROOT);
            fields.extend([
                field(name("half_root", light), "1/sqrt(2 + 2 l.v)", format, roots),
                narrow(name("half_root_rise", light), RISES, HALF_ROOT, rises),
            ]);
        }
        ImageForm::Half { .. } | ImageForm::Paper { .. } | ImageForm::Matcap => {
            let [cosines, cosine_rises] = both_ends(image, |z| libm::sqrt((1.0 + z) / 2.0));
            let [sines, sine_rises] = both_ends(image, |z| -libm::sqrt((1.0 - z) / 2.0));
            fields.extend([
                field(name("half_cosine", light), "cos(phi/2)", Format::unsigned(1, UNIT), cosines),
                narrow(name("half_cosine_rise", light), RISES, UNIT, cosine_rises),
                field(name("half_sine", light), "-sin(phi/2)", Format::signed(0, UNIT), sines),
                narrow(name("half_sine_rise", light), RISES, UNIT, sine_rises),
            ]);
        }
    }
    let [keys, _] = both_ends(image, |z| z);
    Table::listed(name("polar", light), "entry", keys, fields)
}

/// 1/ρ where ρ² is from 1/4 to 1.
fn azimuth(light: usize) -> Table {
    let columns = AZIMUTH.size >> AZIMUTH.octave_bits;
    ReciprocalRoots {
        axis: AZIMUTH,
        first: (columns - 2) << AZIMUTH.octave_bits,
        formats: [Format::unsigned(1, UNIT), Format::unsigned(-(AZIMUTH.octave_bits as i32), UNIT)],
        names: ["azimuth", "across", "across_fall"].map(|what| name(what, light)),
        meaning: "1/sqrt(l_x^2 + l_y^2)",
    }
    .table()
}

/// At the places of [`band_rows`] the blend and the gain, each with its rise, and the gains' exponent where lights
/// differ in it.
fn bands(image: &Image, texels: &Texels, light: usize) -> Table {
    let formats = image.front_end_formats();
    let rows = band_rows(image, texels);
    let shifts = row_shifts(&rows);
    // The last row is there for its own place alone.
    let rise = |of: &dyn Fn(&BandRow) -> f64| -> Vec<f64> {
        rows.windows(2).map(|two| of(&two[1]) - of(&two[0])).chain([0.0]).collect()
    };
    // Rounded down it is the nearest weight, or the upper one of two.
    let half = exp2(-(image.weight_bits as i32) - 1);
    let scaled = |values: Vec<f64>| -> Vec<f64> {
        values.iter().zip(&shifts).map(|(value, &shift)| value * exp2(-shift)).collect()
    };
    let (blend, gain) = (formats.blend as i32, GAIN);
    let mut fields = vec![
        field(
            name("odd", light),
            "the weight of the odd band, plus half of a weight's last bit",
            Format::unsigned(1, blend),
            rows.iter().map(|row| row.odd + half).collect(),
        ),
        narrow(name("odd_rise", light), RISES, blend, rise(&|row| row.odd)),
        field(
            name("gain", light),
            "the gain of intensity 1",
            Format::unsigned(GAIN_INT, gain),
            scaled(rows.iter().map(|row| row.gain).collect()),
        ),
        narrow(name("gain_rise", light), RISES, gain, scaled(rise(&|row| row.gain))),
    ];
    if shifts.iter().any(|&shift| shift > 0) {
        let exponents = shifts.iter().map(|&shift| f64::from(shift)).collect();
        fields.push(narrow(name("exponent", light), "the exponent of the gains", 0, exponents));
    }
    let keys = rows.iter().map(|row| row.phi).collect();
    Table::listed(name("bands", light), "entry", keys, fields)
}

/// The numbers of a light's tables.
pub(super) const POLAR_TABLE: usize = 0;
pub(super) const BANDS_TABLE: usize = 1;
pub(super) const AZIMUTH_TABLE: usize = 2;

/// The tables of a light, counted from 0, which are read at once; that of azimuths in the form half alone.
pub(super) fn tables(image: &Image, texels: &Texels, light: usize) -> Vec<Table> {
    let mut tables = vec![polar(image, light), bands(image, texels, light)];
    if let ImageForm::Half { .. } = image.form {
        tables.push(azimuth(light));
    }
    tables
}

/// Where the rows of the tables of a front end lie.
#[derive(Clone, Debug, PartialEq)]
pub struct FrontEndRows {
    /// The cosines of the polar angle at both ends of each row of what follows from that.
    pub cosines: Vec<[f64; 2]>,
    /// The polar angles in degrees at both ends of each row between bands; the last one's are that of the last band.
    pub angles: Vec<[f64; 2]>,
    /// The squares of the sine of the polar angle at both ends of each row of reciprocal roots: a row serves these
    /// times 4^-e for the exponents e from 0. None in the form bivariate.
    pub across: Vec<[f64; 2]>,
    /// How many exponents there are.
    pub exponents: usize,
}

/// Those of a light's tables.
pub(super) fn rows(tables: &[Table]) -> FrontEndRows {
    // Both ends of the polar angle end at 0.
    let half = tables[POLAR_TABLE].keys.len() / 2;
    let ends = |keys: &[f64], end: f64| -> Vec<[f64; 2]> {
        keys.iter().zip(keys[1..].iter().chain([&end])).map(|(&row, &next)| [row, next]).collect()
    };
    let (front, back) = tables[POLAR_TABLE].keys.split_at(half);
    let angles = &tables[BANDS_TABLE].keys;
    FrontEndRows {
        cosines: [ends(front, 0.0), ends(back, 0.0)].concat(),
        angles: ends(angles, angles[angles.len() - 1]),
        across: tables.get(AZIMUTH_TABLE).map(|table| ends(&table.keys, 1.0)).unwrap_or_default(),
        exponents: AZIMUTH_SHIFT as usize + 1,
    }
}
