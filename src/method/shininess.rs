//! The set of shininesses that a core serves.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::fixed::{Field, Table, exp2};
use crate::lobe::check_shininess;
use crate::platform::error::Error;
use crate::target::BLOCK_RAM_ADDRESS_BITS;

/// Red, green and blue, each from 0 to 1.
pub type Colour = [f64; 3];

/// The most rows that a ROM may have.
pub const MAX_ROWS: usize = 65_536;

/// A named material with its shininess and, for a shader, what its surface reflects.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// The name, for people.
    pub name: String,
    /// The shininess, a real number of at least 1.
    pub shininess: f64,
    /// k_a: how much of the ambient light it reflects, 0 to 1.
    #[serde(default, alias = "k_a", skip_serializing_if = "Option::is_none")]
    pub ambient: Option<f64>,
    /// k_d: how much it scatters, 0 to 1.
    #[serde(default, alias = "k_d", skip_serializing_if = "Option::is_none")]
    pub diffuse: Option<f64>,
    /// k_s: how much it mirrors, 0 to 1.
    #[serde(default, alias = "k_s", skip_serializing_if = "Option::is_none")]
    pub specular: Option<f64>,
    /// The colour of the diffuse light that it gives back, and of the ambient light unless that has its own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub colour: Option<Colour>,
    /// The colour of the ambient light that it gives back.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ambient_colour: Option<Colour>,
    /// The colour of its highlight.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub specular_colour: Option<Colour>,
}

impl FromStr for Material {
    type Err = String;

    /// Reads `NAME=SHININESS`.
    fn from_str(text: &str) -> Result<Self, String> {
        let (name, shininess) = text.split_once('=').ok_or("a material is written NAME=SHININESS, as in brass=51.2")?;
        let shininess = shininess.parse().map_err(|_| format!("`{shininess}` is not a number"))?;
        Ok(Self { name: name.to_owned(), shininess, ..Self::default() })
    }
}

/// The shininesses that a core serves: one ROM row each.
#[derive(Clone, Debug, PartialEq)]
pub enum Shininess {
    /// Every integer from the first to the last; the core's `in_n` is the shininess itself.
    Range(u32, u32),
    /// Every multiple of `2^-frac_bits` from the first to the last integer; the core's `in_n` is the shininess as a
    /// fixed-point number.
    Fixed {
        /// The least shininess.
        first: u32,
        /// The greatest.
        last: u32,
        /// Fraction bits of `in_n`.
        frac_bits: u32,
    },
    /// A list of real numbers; `in_n` is the index into it, from 0.
    List(Vec<f64>),
    /// Named materials; `in_n` is the index into them, from 0.
    Materials(Vec<Material>),
}

impl Shininess {
    /// The shininess of each row.
    #[must_use]
    pub fn values(&self) -> Vec<f64> {
        match self {
            Self::Range(..) | Self::Fixed { .. } => (0..self.rows()).map(|row| self.value(row)).collect(),
            Self::List(list) => list.clone(),
            Self::Materials(materials) => materials.iter().map(|m| m.shininess).collect(),
        }
    }

    /// The shininess of each row of a coefficient ROM: between the integers of a fixed-point range, coefficients are
    /// interpolated.
    #[must_use]
    pub fn knots(&self) -> Vec<f64> {
        match self {
            Self::Fixed { first, last, .. } => (*first..=*last).map(f64::from).collect(),
            other => other.values(),
        }
    }

    /// The ROM row of the shininess at a place of the set, and how far it lies on the way to the next, from 0 to below
    /// 1.
    #[must_use]
    pub fn knot(&self, place: usize) -> (usize, f64) {
        match self {
            Self::Fixed { frac_bits, .. } => {
                let fraction = place & ((1 << frac_bits) - 1);
                (place >> frac_bits, fraction as f64 * exp2(-(*frac_bits as i32)))
            }
            _ => (place, 0.0),
        }
    }

    /// The number of shininesses.
    #[must_use]
    pub fn rows(&self) -> usize {
        match self {
            Self::Range(first, last) => (last - first) as usize + 1,
            Self::Fixed { first, last, frac_bits } => ((last - first) as usize) * (1 << frac_bits) + 1,
            Self::List(list) => list.len(),
            Self::Materials(materials) => materials.len(),
        }
    }

    /// The set of the rows of a coefficient ROM: the integers of a fixed-point range.
    #[must_use]
    pub fn of_knots(&self) -> Self {
        match self {
            Self::Fixed { first, last, .. } => Self::Range(*first, *last),
            other => other.clone(),
        }
    }

    /// The fraction bits of `in_n`.
    #[must_use]
    pub fn frac_bits(&self) -> u32 {
        match self {
            Self::Fixed { frac_bits, .. } => *frac_bits,
            _ => 0,
        }
    }

    /// Whether `in_n` is the shininess itself, and no index.
    #[must_use]
    pub fn is_at_port(&self) -> bool {
        matches!(self, Self::Range(..) | Self::Fixed { .. })
    }

    /// The width of the port `in_n`.
    #[must_use]
    pub fn index_bits(&self) -> u32 {
        let last = match self {
            Self::Range(_, last) => *last,
            Self::Fixed { last, frac_bits, .. } => last << frac_bits,
            _ => self.rows() as u32 - 1,
        };
        (u32::BITS - last.leading_zeros()).max(1)
    }

    /// The row that a code of `in_n` selects: codes outside the set are taken to the nearest end.
    #[must_use]
    pub fn row_of_index(&self, index: u32) -> usize {
        match self {
            Self::Range(first, last) => (index.clamp(*first, *last) - first) as usize,
            Self::Fixed { first, last, frac_bits } => {
                let (low, high) = (first << frac_bits, last << frac_bits);
                (index.clamp(low, high) - low) as usize
            }
            _ => (index as usize).min(self.rows() - 1),
        }
    }

    /// The shininess of a row.
    #[must_use]
    pub fn value(&self, row: usize) -> f64 {
        match self {
            Self::Range(first, _) => f64::from(first + row as u32),
            Self::Fixed { frac_bits, .. } => f64::from(self.index_of_row(row)) * exp2(-(*frac_bits as i32)),
            Self::List(list) => list[row],
            Self::Materials(materials) => materials[row].shininess,
        }
    }

    /// The least and the greatest shininess.
    #[must_use]
    pub fn ends(&self) -> (f64, f64) {
        match self {
            Self::Range(first, last) | Self::Fixed { first, last, .. } => (f64::from(*first), f64::from(*last)),
            _ => self.values().into_iter().fold((f64::INFINITY, 0.0), |(low, high), n| (low.min(n), high.max(n))),
        }
    }

    /// The code of `in_n` that selects a row.
    #[must_use]
    pub fn index_of_row(&self, row: usize) -> u32 {
        match self {
            Self::Range(first, _) => first + row as u32,
            Self::Fixed { first, frac_bits, .. } => (first << frac_bits) + row as u32,
            _ => row as u32,
        }
    }

    /// What `in_n` means, for a port table.
    #[must_use]
    pub fn index_meaning(&self) -> String {
        match self {
            Self::Range(first, last) if first == last => format!("shininess; every code selects {first}"),
            Self::Range(first, last) => format!("shininess, {first} to {last}; outside: the nearest end"),
            Self::Fixed { first, last, frac_bits } => {
                format!("shininess, {first} to {last} in steps of 2^-{frac_bits}; outside: the nearest end")
            }
            _ => {
                format!("index of the shininess, 0 to {}; above: the last", self.rows() - 1)
            }
        }
    }

    /// A coefficient ROM with the given fields for the set.
    #[must_use]
    pub fn rom(&self, fields: Vec<Field>, shared_shift: u32) -> Table {
        let set = &self.of_knots();
        let packed_bits = (usize::BITS - (set.rows() - 1).leading_zeros()).max(1);
        // Up to the least depth of a block RAM, a memory twice as deep is cheaper than a clamp, a subtraction and their
        // clock.
        let direct = packed_bits.max((packed_bits + 1).min(BLOCK_RAM_ADDRESS_BITS));
        let (address_bits, first_index) =
            if set.index_bits() <= direct { (set.index_bits(), 0) } else { (packed_bits, set.index_of_row(0)) };
        let row_of_address = (0..1u32 << address_bits).map(|address| set.row_of_index(address + first_index)).collect();
        Table::keyed(set.values(), fields, shared_shift, first_index, row_of_address)
    }

    /// Refuses an empty or overlong set and any shininess out of range.
    ///
    /// # Errors
    /// Names the entry that is wrong.
    pub fn check(&self) -> Result<(), Error> {
        if let Self::Range(first, last) | Self::Fixed { first, last, .. } = self
            && first > last
        {
            return Err(Error::input(
                format!("the shininess range {first}..={last} is empty"),
                "write the smaller end first, as in 1..=1000",
            ));
        }
        let rows = match self {
            // The rows of the ROM are those of the integers.
            Self::Range(first, last) | Self::Fixed { first, last, .. } => u64::from(last - first) + 1,
            other => other.rows() as u64,
        };
        if rows == 0 || rows > MAX_ROWS as u64 {
            return Err(Error::input(
                format!("{rows} shininesses are asked for"),
                format!("a core serves 1 to {MAX_ROWS}: each is a row of its ROM"),
            ));
        }
        match self {
            Self::Range(first, last) | Self::Fixed { first, last, .. } => {
                check_shininess(f64::from(*first))?;
                check_shininess(f64::from(*last))
            }
            Self::List(list) => list.iter().try_for_each(|&n| check_shininess(n)),
            Self::Materials(materials) => materials.iter().try_for_each(|m| {
                if m.name.is_empty() || m.name.chars().any(|c| c.is_control() || !c.is_ascii()) {
                    return Err(Error::input(
                        format!("the material name {:?} is not allowed", m.name),
                        "a name is one or more printable ASCII characters: it goes into HDL comments",
                    ));
                }
                check_shininess(m.shininess).map_err(|error| match error {
                    Error::Input { what, allowed } => Error::input(format!("material {}: {what}", m.name), allowed),
                    other => other,
                })
            }),
        }
    }
}

impl fmt::Display for Shininess {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Range(first, last) | Self::Fixed { first, last, .. } => write!(f, "{first}..={last}"),
            _ => {
                let values: Vec<String> = self.values().iter().map(f64::to_string).collect();
                write!(f, "{}", values.join(","))
            }
        }
    }
}

const ALLOWED: &str = "a range of integers (1..=1000) or a list of real numbers (5,12.5,80)";

impl FromStr for Shininess {
    type Err = String;

    /// Reads a range, `FIRST..=LAST`, or a list, `A,B,C`.
    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = |part: &str| format!("`{part}` is not a number; the shininess is {ALLOWED}");
        if let Some((first, last)) = text.split_once("..=") {
            let end = |part: &str| part.trim().parse::<u32>().map_err(|_| wrong(part));
            return Ok(Self::Range(end(first)?, end(last)?));
        }
        if text.contains("..") {
            return Err(format!("`{text}`: write a range with both ends, as in 1..=1000"));
        }
        text.split(',')
            .map(|part| part.trim().parse().map_err(|_| wrong(part)))
            .collect::<Result<_, _>>()
            .map(Self::List)
    }
}

impl Serialize for Shininess {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Range(..) | Self::Fixed { .. } => serializer.collect_str(self),
            _ => self.values().serialize(serializer),
        }
    }
}

impl<'de> Deserialize<'de> for Shininess {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(Deserialize)]
        #[serde(untagged, expecting = "the shininess is a range of integers (\"1..=1000\") or a list ([5, 12.5, 80])")]
        enum Written {
            Text(String),
            One(f64),
            Many(Vec<f64>),
        }
        match Written::deserialize(deserializer)? {
            Written::Text(text) => text.parse().map_err(serde::de::Error::custom),
            Written::One(n) => Ok(Self::List(vec![n])),
            Written::Many(list) => Ok(Self::List(list)),
        }
    }
}
