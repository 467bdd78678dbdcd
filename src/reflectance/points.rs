//! Points to evaluate a material at, as CSV, and the results beside them.

use std::path::Path;

use super::{Light, Rgb, Vector};
use crate::platform::error::Error;
use crate::platform::input;

/// The columns of a points file.
const COLUMNS: [&str; 5] = ["phi_deg", "gamma_deg", "nx", "ny", "nz"];
/// The columns of the results.
const RESULTS: [&str; 3] = ["r", "g", "b"];

/// Points with the texts of their lines, which stay as they are.
pub struct Points {
    /// Names of all columns but those of results.
    pub heading: Vec<String>,
    /// The texts of a line, the light and the normal.
    pub rows: Vec<(Vec<String>, Light, Vector)>,
}

impl Points {
    /// Reads a CSV file; columns of results are left out.
    ///
    /// # Errors
    /// A file that cannot be read or has not the columns, an angle out of range, a normal that is not of length 1.
    pub fn read(path: &Path) -> Result<Self, Error> {
        let allowed = "points are a CSV file with the columns phi_deg, gamma_deg, nx, ny and nz";
        let text = input::read_text(path, allowed)?;
        let text = text.strip_prefix('\u{feff}').unwrap_or(&text);
        let name = path.display();
        let wrong = |line: Option<u64>, what: String, allowed: &str| {
            let place = line.map(|line| format!(", line {line}")).unwrap_or_default();
            Error::input(format!("{name}{place}: {what}"), allowed)
        };
        let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(text.as_bytes());
        let heading = reader.headers().map_err(|error| wrong(None, error.to_string(), allowed))?.clone();
        let place = |column: &str| {
            let place = heading.iter().position(|own| own == column);
            place.ok_or_else(|| wrong(None, format!("there is no column `{column}`"), allowed))
        };
        let places =
            [place(COLUMNS[0])?, place(COLUMNS[1])?, place(COLUMNS[2])?, place(COLUMNS[3])?, place(COLUMNS[4])?];
        // Results of an earlier run are made anew.
        let kept: Vec<usize> = (0..heading.len()).filter(|&column| !RESULTS.contains(&&heading[column])).collect();
        let mut rows = Vec::new();
        for record in reader.records() {
            let record =
                record.map_err(|error| wrong(error.position().map(csv::Position::line), error.to_string(), allowed))?;
            let line = record.position().map(csv::Position::line);
            let number = |of: usize| {
                let text = &record[places[of]];
                let number = text.parse().ok().filter(|number: &f64| number.is_finite());
                number.ok_or_else(|| wrong(line, format!("{} is `{text}`", COLUMNS[of]), "a finite number"))
            };
            let light = Light::new(number(0)?, number(1)?);
            if !(0.0..=180.0).contains(&light.phi) {
                return Err(wrong(
                    line,
                    format!("phi_deg is {}", light.phi),
                    "from 0, behind the viewer, to 180 degrees",
                ));
            }
            let n = Vector::new(number(2)?, number(3)?, number(4)?);
            let length = n.norm();
            if !(0.99..=1.01).contains(&length) {
                return Err(wrong(
                    line,
                    format!("the normal {}, {}, {} has the length {length}", n.x, n.y, n.z),
                    "normals have the length 1, to 1 %",
                ));
            }
            rows.push((kept.iter().map(|&column| record[column].to_owned()).collect(), light, n / length));
        }
        Ok(Self { heading: kept.iter().map(|&column| heading[column].to_owned()).collect(), rows })
    }

    /// The CSV file with a colour to each point.
    ///
    /// # Errors
    /// If there are too many.
    pub fn csv(&self, values: &[Rgb]) -> Result<Vec<u8>, Error> {
        let failed = || Error::input("the results cannot be written as CSV", "fewer points");
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(self.heading.iter().map(String::as_str).chain(RESULTS)).map_err(|_| failed())?;
        for ((texts, ..), value) in self.rows.iter().zip(values) {
            let numbers = value.map(|channel| channel.to_string());
            writer.write_record(texts.iter().chain(&numbers)).map_err(|_| failed())?;
        }
        writer.into_inner().map_err(|_| failed())
    }
}
