//! The quantised coefficients, one row per shininess.

use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};

use num_bigint::BigUint;

use crate::fixed::{Format, Interval};

/// A column of the ROM: one coefficient for every row.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// The name, an identifier in every language.
    pub name: &'static str,
    /// What the field holds, for people.
    pub meaning: &'static str,
    /// The format of the codes.
    pub format: Format,
    /// The quantised value of each row, as a code of `format`.
    pub codes: Vec<i128>,
    /// The real value of each row before it was quantised.
    pub reals: Vec<f64>,
}

impl Field {
    /// The number that the word of a row stands for.
    #[must_use]
    pub fn value(&self, row: usize) -> f64 {
        self.format.value(self.codes[row])
    }

    /// What rounding added to the value of a row.
    #[must_use]
    pub fn rounding(&self, row: usize) -> f64 {
        self.value(row) - self.reals[row]
    }

    /// The range of that over all rows.
    #[must_use]
    pub fn roundings(&self) -> Interval {
        let of = |row| Interval::point(self.rounding(row));
        (0..self.codes.len()).map(of).reduce(Interval::hull).unwrap_or(Interval::ZERO)
    }
}

/// A memory of constants: its logical rows, for a coefficient ROM one a shininess, and the words that it holds.
///
/// A word is the fields' bit patterns side by side, the first field in the most significant bits. The
/// memory has `2^address_bits` words: every address holds one, those outside the set a copy of the
/// nearest row, so that no address is undefined and no clamp is needed in front of the memory.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// The name of the memory, an identifier in every language: `rom` for the coefficients.
    pub name: &'static str,
    /// The fields, most significant first.
    pub fields: Vec<Field>,
    /// What the rows are told apart by: `shininess`, or `entry` of a function table.
    pub key: &'static str,
    /// The key of each row.
    pub keys: Vec<f64>,
    /// The width of the address.
    pub address_bits: u32,
    /// Subtracted from the index (after taking it into the set) to give the address: 0 wherever a memory that
    /// is addressed by the index itself is no deeper, or at most twice as deep and a small one.
    pub first_index: u32,
    /// The shift of the versine that all rows share; what a row needs beyond it is its field `k`.
    pub shared_shift: u32,
    /// The row that each address holds.
    row_of_address: Vec<usize>,
}

impl Table {
    /// A coefficient ROM with the given fields: a row each of these shininesses, and at each address from 0 the row
    /// `row_of_address` of them.
    #[must_use]
    pub fn keyed(
        keys: Vec<f64>,
        fields: Vec<Field>,
        shared_shift: u32,
        first_index: u32,
        row_of_address: Vec<usize>,
    ) -> Self {
        let rows = keys.len();
        debug_assert!(fields.iter().all(|f| f.codes.len() == rows && f.reals.len() == rows));
        let address_bits = row_of_address.len().trailing_zeros();
        Self {
            name: Self::COEFFICIENTS,
            fields,
            key: "shininess",
            keys,
            address_bits,
            first_index,
            shared_shift,
            row_of_address,
        }
    }

    /// The name of the memory that holds the coefficients.
    pub const COEFFICIENTS: &str = "rom";

    /// A memory of one row of this one, which every address holds.
    #[must_use]
    pub fn only(&self, row: usize) -> Self {
        let field =
            |field: &Field| Field { codes: vec![field.codes[row]], reals: vec![field.reals[row]], ..field.clone() };
        Self {
            fields: self.fields.iter().map(field).collect(),
            keys: vec![self.keys[row]],
            row_of_address: vec![0; self.depth()],
            ..self.clone()
        }
    }

    /// The same under another name.
    #[must_use]
    pub fn named(self, name: &'static str) -> Self {
        Self { name, ..self }
    }

    /// The coefficient ROM that has `parts` rows side by side for each row of `whole`: row `i` of it holds `parts i` to
    /// `parts (i + 1) - 1`. `parts` is a power of two.
    #[must_use]
    pub fn parts(whole: &Self, parts: usize, fields: Vec<Field>) -> Self {
        debug_assert!(parts.is_power_of_two() && fields.iter().all(|f| f.codes.len() == parts * whole.rows()));
        let row = |address: usize| whole.row_of_address[address / parts] * parts + address % parts;
        Self {
            name: Self::COEFFICIENTS,
            fields,
            key: whole.key,
            keys: whole.keys.iter().flat_map(|&key| std::iter::repeat_n(key, parts)).collect(),
            address_bits: whole.address_bits + parts.trailing_zeros(),
            first_index: whole.first_index,
            shared_shift: whole.shared_shift,
            row_of_address: (0..whole.depth() * parts).map(row).collect(),
        }
    }

    /// A memory whose rows are addressed in order, `2^address_bits` words or fewer; the last row fills the rest.
    #[must_use]
    pub fn listed(name: &'static str, key: &'static str, keys: Vec<f64>, fields: Vec<Field>) -> Self {
        let rows = keys.len();
        debug_assert!(fields.iter().all(|f| f.codes.len() == rows && f.reals.len() == rows));
        let address_bits = (usize::BITS - (rows - 1).leading_zeros()).max(1);
        let row_of_address = (0..1usize << address_bits).map(|address| address.min(rows - 1)).collect();
        Self { name, fields, key, keys, address_bits, first_index: 0, shared_shift: 0, row_of_address }
    }

    /// Whether the rows are told apart by the shininess: the memory holds coefficients, not a function.
    #[must_use]
    pub fn is_keyed_by_shininess(&self) -> bool {
        self.key == "shininess"
    }

    /// The key of texels.
    pub const TEXEL: &str = "texel";

    /// Whether the memory holds data, coefficients or texels, and not a function that every core of its kind has.
    #[must_use]
    pub fn holds_data(&self) -> bool {
        self.is_keyed_by_shininess() || self.holds_texels()
    }

    /// Whether the memory holds texels, of which any code may stand in the place of any other.
    #[must_use]
    pub fn holds_texels(&self) -> bool {
        self.key == Self::TEXEL
    }

    /// The same memory with every bit of every word inverted: no word is what it was.
    #[must_use]
    pub fn complemented(&self) -> Self {
        let inverted = |field: &Field| {
            let codes: Vec<i128> = field.codes.iter().map(|&code| field.format.wrap(!code)).collect();
            let reals = codes.iter().map(|&code| field.format.value(code)).collect();
            Field { codes, reals, ..field.clone() }
        };
        Self { fields: self.fields.iter().map(inverted).collect(), ..self.clone() }
    }

    /// The codes of the fields, in their order, that a word holds; bits above the word's width are not looked at.
    #[must_use]
    pub fn codes_of(&self, word: &BigUint) -> Vec<i128> {
        let code = |(low, field): (u32, &Field)| {
            let bits = (word >> low) & ((BigUint::from(1u8) << field.format.width()) - 1u8);
            // A field is at most 126 bits wide, as every value of a datapath is.
            field.format.wrap(u128::try_from(bits).unwrap_or_default() as i128)
        };
        self.placed_fields().map(code).collect()
    }

    /// The number of logical rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.keys.len()
    }

    /// The number of words in the memory, a power of two.
    #[must_use]
    pub fn depth(&self) -> usize {
        self.row_of_address.len()
    }

    /// The width of a word.
    #[must_use]
    pub fn word_bits(&self) -> u32 {
        self.fields.iter().map(|f| f.format.width()).sum()
    }

    /// The memory's size in bits.
    #[must_use]
    pub fn bits(&self) -> usize {
        self.depth() * self.word_bits() as usize
    }

    /// The row that an address holds.
    #[must_use]
    pub fn row_of_address(&self, address: usize) -> usize {
        self.row_of_address[address]
    }

    /// The code of a field at an address.
    #[must_use]
    pub fn code_at(&self, field: usize, address: usize) -> i128 {
        self.fields[field].codes[self.row_of_address[address]]
    }

    /// The position of a field's least significant bit in the word.
    #[must_use]
    pub fn field_low_bit(&self, field: usize) -> u32 {
        self.fields[field + 1..].iter().map(|f| f.format.width()).sum()
    }

    /// The fields, each with the position of its least significant bit in the word.
    pub fn placed_fields(&self) -> impl Iterator<Item = (u32, &Field)> {
        self.fields.iter().enumerate().map(|(index, field)| (self.field_low_bit(index), field))
    }

    /// The word at an address.
    #[must_use]
    pub fn word(&self, address: usize) -> BigUint {
        let row = self.row_of_address[address];
        self.fields.iter().fold(BigUint::ZERO, |word, field| {
            (word << field.format.width()) | BigUint::from(field.format.bits(field.codes[row]))
        })
    }

    /// Every word, by address.
    #[must_use]
    pub fn words(&self) -> Vec<BigUint> {
        (0..self.depth()).map(|address| self.word(address)).collect()
    }

    /// The field with the given name, if there is one.
    #[must_use]
    pub fn find(&self, name: &str) -> Option<&Field> {
        self.fields.iter().find(|field| field.name == name)
    }

    /// The field with the given name.
    ///
    /// # Panics
    /// If there is none: names are fixed by the method.
    #[must_use]
    pub fn field(&self, name: &str) -> &Field {
        self.find(name).expect("a field of this method")
    }
}

/// A name that is made up while the program runs, kept for as long as it runs: each is kept once.
#[must_use]
pub fn interned(name: String) -> &'static str {
    static NAMES: Mutex<BTreeSet<&'static str>> = Mutex::new(BTreeSet::new());
    let mut names = NAMES.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = names.get(name.as_str()) {
        return known;
    }
    let kept: &'static str = name.leak();
    names.insert(kept);
    kept
}
