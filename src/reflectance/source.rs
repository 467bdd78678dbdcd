//! A user's file, whatever of the kinds here it is.

use std::io::Read;
use std::path::Path;

use super::{Form, FormKind, FormSpec, Table, directory, images, merl};
use crate::platform::error::Error;
use crate::platform::input;

/// What a file holds.
#[derive(Clone, Debug)]
pub enum Source {
    /// A reflectance table.
    Table(Table),
    /// Sphere images, or a matcap.
    Images(Form),
}

/// Opens a MERL table, a directory of sphere images, or a PNG or OpenEXR picture as a matcap. What it is shows in its first bytes.
///
/// # Errors
/// If the system refuses, or the file is none of these or wrong.
pub fn open(path: &Path) -> Result<Source, Error> {
    if path.is_dir() {
        return directory::read(path).map(Source::Images);
    }
    let failed = |error| Error::io("cannot read", path, error);
    let mut start = Vec::new();
    input::open(path)?.take(16).read_to_end(&mut start).map_err(failed)?;
    if !images::is_picture(&start) {
        return merl::read(path).map(Source::Table);
    }
    let bytes = input::read(path, images::MAX_PICTURE)?;
    matcap(&bytes, &path.display().to_string()).map(Source::Images)
}

/// The form of a matcap's picture.
///
/// # Errors
/// A picture that cannot be read or is not square.
pub fn matcap(bytes: &[u8], name: &str) -> Result<Form, Error> {
    let (width, height, samples) = images::read_linear(bytes, name)?;
    if width != height || width < 2 {
        return Err(Error::input(
            format!("{name} has {width} × {height} pixels"),
            "a matcap is a square picture of a sphere that touches its sides, of at least 2 × 2 pixels",
        ));
    }
    let spec = FormSpec { size: width, ..FormSpec::of(FormKind::Matcap) };
    let samples = super::texels::Samples { width, height, data: samples };
    Ok(spec.encode(&samples, 1.0))
}
