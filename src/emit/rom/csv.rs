//! Tables of comma-separated values.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use num_bigint::BigUint;

use super::source::{Source, Span, Words, image, shown};
use super::writing::{Writing, line};
use super::{FileFormat, MAX_DEPTH, RomImage};
use crate::platform::error::Error;
use crate::platform::input;

pub(super) const CSV: FileFormat = FileFormat {
    about: "Table of shininess, real and quantised coefficients: NAME.csv",
    suffix: ".csv",
    extensions: &["csv"],
    allowed: "a ROM's .csv has the columns address and word (hexadecimal), FIELD_code with integers and FIELD_real \
              with numbers, named in the first row",
    is_text: true,
    read,
    write,
};

/// The columns address, shininess, the real value and the code of each field, and the word.
///
/// The word is written with `0x`, so that a spreadsheet does not take 00e5 for a decimal number.
fn write(of: &Writing<'_>) -> Vec<u8> {
    let table = of.table;
    let mut text = format!("address,{}", table.key);
    for field in &table.fields {
        write!(text, ",{0}_real,{0}_code", field.name).expect("a string takes all text");
    }
    line!(text, ",word");
    for (address, word) in of.hex_words().enumerate() {
        let row = table.row_of_address(address);
        write!(text, "{address},{}", table.keys[row]).expect("a string takes all text");
        for field in &table.fields {
            // `{:?}` is the shortest text that reads back as the same number, with an exponent where that is shorter.
            write!(text, ",{:?},{}", field.reals[row], field.codes[row]).expect("a string takes all text");
        }
        line!(text, ",0x{word}");
    }
    text.into_bytes()
}

/// What a column of a .csv file holds.
enum Column<'s> {
    Address,
    Word,
    Code(&'s str),
    /// A number that nothing is compared with.
    Real,
    Other,
}

fn read(source: &Source<'_>) -> Result<RomImage, Error> {
    input::check_separator(&source.text, source.file)?;
    let mut rows = rows(&source.text);
    let Some(header) = rows.next() else {
        return Err(source.cut_off("the file has no header row"));
    };
    let columns = columns(source, &header)?;
    let mut words = Words::new(source);
    let mut codes_by_address = BTreeMap::new();
    for row in rows {
        if row.len() != columns.len() {
            let what = format!("the number of cells in this row is {}", row.len());
            let allowed = format!("the header row names {} columns", columns.len());
            return Err(source.error(what, allowed, row_span(&row)));
        }
        let mut address = 0;
        let mut word = (BigUint::ZERO, (0, 0));
        let mut codes: Vec<i128> = Vec::new();
        for (column, &(cell, span)) in columns.iter().zip(&row) {
            let not_a = |kind: &str| source.wrong(format!("{} is not {kind}", shown(cell)), span);
            match column {
                Column::Address => address = source.address(cell, 10, span)?,
                Column::Word => {
                    let digits = cell.strip_prefix("0x").or_else(|| cell.strip_prefix("0X")).unwrap_or(cell);
                    word = (words.read(digits, 16, span)?, span);
                }
                Column::Code(_) => codes.push(cell.parse().map_err(|_| not_a("an integer"))?),
                Column::Real => {
                    cell.parse::<f64>().ok().filter(|real| real.is_finite()).ok_or_else(|| not_a("a finite number"))?;
                }
                Column::Other => {}
            }
        }
        words.place(address, word.0, word.1, MAX_DEPTH)?;
        codes_by_address.insert(address, codes);
    }
    let fields = columns.iter().filter_map(|column| if let Column::Code(field) = column { Some(*field) } else { None });
    let codes = fields.enumerate().map(|(position, field)| {
        let codes = codes_by_address.values().map(|codes: &Vec<i128>| codes[position]).collect();
        (field.to_owned(), codes)
    });
    Ok(RomImage { codes: codes.collect(), ..image(words.finish(None)?) })
}

/// The columns that the header row names.
fn columns<'s>(source: &Source<'_>, header: &Fields<'s>) -> Result<Vec<Column<'s>>, Error> {
    let only_one = |name: &str| header.iter().filter(|(cell, _)| *cell == name).count() == 1;
    if let Some(name) = ["address", "word"].into_iter().find(|name| !only_one(name)) {
        let what = format!("the header row has not one column `{name}`");
        return Err(source.wrong(what, row_span(header)));
    }
    let column = |&(name, _): &(&'s str, Span)| match name {
        "address" => Column::Address,
        "word" => Column::Word,
        "shininess" | "entry" => Column::Real,
        name => match (name.strip_suffix("_code"), name.strip_suffix("_real")) {
            (Some(field), _) => Column::Code(field),
            (_, Some(_)) => Column::Real,
            _ => Column::Other,
        },
    };
    Ok(header.iter().map(column).collect())
}

/// A row's cells with their places.
type Fields<'s> = Vec<(&'s str, Span)>;

/// The rows that are not blank. A cell may stand in double quotes, but not hold a comma.
fn rows(text: &str) -> impl Iterator<Item = Fields<'_>> {
    let offset = |part: &str| part.as_ptr() as usize - text.as_ptr() as usize;
    text.lines().filter(|line| !line.trim().is_empty()).map(move |line| {
        let cells = line.split(',').map(|cell| {
            let cell = cell.trim();
            let inner = cell.strip_prefix('"').and_then(|cell| cell.strip_suffix('"')).unwrap_or(cell);
            (inner, (offset(inner), inner.len()))
        });
        cells.collect()
    })
}

fn row_span(row: &Fields<'_>) -> Span {
    match (row.first(), row.last()) {
        (Some((_, first)), Some((_, last))) => (first.0, last.0 + last.1 - first.0),
        _ => (0, 0),
    }
}
