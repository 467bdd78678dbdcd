//! What a user names: a file, whatever of the kinds here it is, or a model.

use std::io::Read;
use std::path::Path;

use super::{Form, Lookup, Model, Reflectance, Table, directory, images, merl};
use crate::platform::error::{Error, refuse};
use crate::platform::input;

/// What reflects, or pictures of it.
#[derive(Clone, Debug)]
pub enum Source {
    /// A reflectance table.
    Table(Table),
    /// A model with its parameters.
    Model(Model),
    /// Sphere images, or a matcap.
    Images(Form),
}

impl Source {
    /// Opens a MERL table, a directory of sphere images, or a PNG or OpenEXR picture as a matcap. What it is shows in
    /// its first bytes.
    ///
    /// # Errors
    /// If the system refuses, or the file is none of these or wrong.
    pub fn open(path: &Path, lookup: Lookup) -> Result<Self, Error> {
        if path.is_dir() {
            return directory::read(path).map(Self::Images);
        }
        let failed = |error| Error::io("cannot read", path, error);
        let mut start = Vec::new();
        input::open(path)?.take(16).read_to_end(&mut start).map_err(failed)?;
        if !images::is_picture(&start) {
            let mut table = merl::read(path)?;
            table.lookup = lookup;
            return Ok(Self::Table(table));
        }
        let bytes = input::read(path, images::MAX_PICTURE)?;
        matcap(&bytes, &path.display().to_string()).map(Self::Images)
    }

    /// The reflectance; none of images.
    #[must_use]
    pub fn reflectance(&self) -> Option<&dyn Reflectance> {
        match self {
            Self::Table(table) => Some(table),
            Self::Model(model) => Some(model),
            Self::Images(_) => None,
        }
    }

    /// The reflectance.
    ///
    /// # Errors
    /// Images: what is so named has none, and something that is `allowed` is needed.
    pub fn needed(&self, name: &str, allowed: &str) -> Result<&dyn Reflectance, Error> {
        let refused = || Error::input(format!("{name} holds sphere images, and no reflectance"), allowed);
        self.reflectance().ok_or_else(refused)
    }
}

/// The form of a matcap's picture, as [`super::matcap::form`] makes it.
///
/// # Errors
/// A picture that cannot be read or is not square.
pub fn matcap(bytes: &[u8], name: &str) -> Result<Form, Error> {
    let (width, height, samples) = images::read_linear(bytes, name)?;
    refuse!(
        width != height || width < 2,
        format!("{name} has {width} × {height} pixels"),
        "a matcap is a square picture of a sphere that touches its sides, of at least 2 × 2 pixels"
    );
    Ok(super::matcap::form(width, samples))
}
