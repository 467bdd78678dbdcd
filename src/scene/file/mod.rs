//! Scene files: TOML, read and checked.

mod fields;
mod material;
mod object;

use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

use serde::{Deserialize, Serialize};
use toml::de::{DeTable, Deserializer};

use self::fields::SceneFields;
pub(super) use self::material::fitted;
use super::mesh::Mesh;
use super::reflectance::Measured;
use crate::core::sample::{Vector, normalised};
use crate::explore::Objective;
use crate::platform::error::{Error, refuse};
use crate::platform::input;
use crate::spec::{Colour, Material, Model, SpecFields, check_name, toml_error};
use crate::target::Family;

/// The most pixels a side of a picture.
pub const MAX_SIDE: u32 = 16_384;
/// The most lights. A shader has 8 at most; lobes and reflectances do not care.
pub const MAX_LIGHTS: usize = 4096;
/// The greatest magnitude of a coordinate, a radius or a scale.
pub const MAX_COORDINATE: f64 = 1e9;
/// The help to errors of the TOML parser.
const HELP: &str = "docs/scene-files.md lists the keys and values of a scene file";

/// A scene, every default resolved and every value checked.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Its name, an identifier: the key `name`, or the file's stem. Cores made for it are called so by default.
    pub name: String,
    /// The reflection model.
    pub model: Model,
    /// Pixels a row, at least 1.
    pub width: u32,
    /// Rows, at least 1.
    pub height: u32,
    /// Bits of an output channel: one of [`crate::spec::CHANNEL_BITS`].
    pub channel_bits: u32,
    /// The ambient light, 0 to 1 a channel.
    pub ambient: Colour,
    /// What is seen where no object is, 0 to 1 a channel.
    pub background: Colour,
    /// The camera.
    pub camera: Camera,
    /// The materials, in the order of the file, then those of its meshes' MTL files, with their surfaces
    /// ([`Material::with_surface`]); shininess at least 1.
    pub materials: Vec<Material>,
    /// The reflectance of each material that is drawn by it. Such a material has no highlight of its own, and no light
    /// is diffused by its keys.
    pub reflectances: Vec<Option<Arc<Measured>>>,
    /// What of the MTL files is left out, a line each.
    pub left_out: Vec<String>,
    /// The lights, 1 to [`MAX_LIGHTS`].
    pub lights: Vec<Light>,
    /// The objects, one at least. A mesh with the materials of its file is one for each of them.
    pub objects: Vec<Object>,
    /// Whether objects throw shadows.
    pub shadows: bool,
    /// The error that the picture may have.
    pub budget: Budget,
    /// Whether the file says so, or it is the default.
    pub has_budget: bool,
    /// What is asked of the core.
    pub core: CoreConstraints,
}

/// A pinhole camera.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Camera {
    /// Where it stands.
    pub position: Vector,
    /// The point that it looks at, in the middle of the picture.
    pub target: Vector,
    /// The direction that is up in the picture; not along the view.
    pub up: Vector,
    /// The vertical angle of view in degrees, above 0 and below 180.
    pub field_of_view: f64,
}

/// A light.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Light {
    /// Where its light comes from.
    pub kind: LightKind,
    /// Its colour, times its intensity; 0 to 1 a channel.
    pub colour: Colour,
}

/// Where a light's light comes from. Light is not weakened by distance, as in the classical models: the core then needs
/// no light's strength.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum LightKind {
    /// From this direction, a unit vector towards the light.
    Directional(Vector),
    /// From this point.
    Point(Vector),
}

/// An object.
#[derive(Clone, Debug)]
pub struct Object {
    /// What it is.
    pub shape: Shape,
    /// The place of its material in [`Scene::materials`].
    pub material: usize,
}

/// What an object is.
#[derive(Clone, Debug)]
pub enum Shape {
    /// A sphere.
    Sphere {
        /// Its centre.
        centre: Vector,
        /// Its radius, above 0.
        radius: f64,
    },
    /// An infinite plane, seen from both sides.
    Plane {
        /// A point of it.
        point: Vector,
        /// Its normal, a unit vector.
        normal: Vector,
    },
    /// Triangles, with their transform already applied.
    Mesh(Arc<Mesh>),
}

/// The error that a picture may have; where both are given, both hold. A file that gives neither asks for one step at
/// most.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Budget {
    /// The largest difference of a channel's code from the exact picture's, in steps.
    pub max_steps: Option<u32>,
    /// The least peak signal-to-noise ratio against the exact picture, in dB, over all pixels and channels, in codes of
    /// a channel.
    pub min_psnr: Option<f64>,
}

/// What is asked of the core, beside the picture's budget.
#[derive(Clone, Debug)]
pub struct CoreConstraints {
    /// The family of FPGAs.
    pub family: Family,
    /// The least frequency in MHz.
    pub min_mhz: Option<f64>,
    /// What of the core is to be least.
    pub objective: Objective,
    /// Keys of the spec that the core must have, such as its method; no shininess and no materials.
    pub keys: SpecFields,
}

/// A file's text with its name, for messages.
struct Source<'a> {
    text: &'a str,
    file: &'a str,
}

impl Source<'_> {
    /// The error with a name and the place in the text of what it is about.
    fn at(&self, what: &str, span: &Range<usize>, error: Error) -> Error {
        match error {
            Error::Input { what: wrong, allowed } => {
                // Only the first line: the span of a table goes over all its keys.
                let length = self.text[span.clone()].find('\n').unwrap_or(span.len());
                Error::text(format!("{what}{wrong}"), allowed, self.file, self.text, (span.start, length))
            }
            other => other,
        }
    }

    /// What the TOML parser refuses; `more` are known keys of the table that has the key `beside`.
    fn toml(&self, error: &toml::de::Error, beside: &str, more: &[&str]) -> Error {
        let more = if error.message().contains(&format!("`{beside}`")) { more } else { &[] };
        toml_error(error, more, HELP, self.file, self.text)
    }
}

impl Scene {
    /// Reads a scene file; the meshes that it names lie where their paths lead from the file's directory.
    ///
    /// # Errors
    /// An unreadable file or what [`Scene::parse`] refuses.
    pub fn read(path: &Path) -> Result<Self, Error> {
        let text = input::read_text(path, "a scene is a TOML file")?;
        Self::parse(&text, &path.display().to_string(), path.parent().unwrap_or(Path::new("")))
    }

    /// Whether a TOML text is a scene rather than the spec of a core: it has one of the keys `camera` and `object`, or
    /// is no TOML but has a line with such a table.
    #[must_use]
    pub fn is_scene(text: &str) -> bool {
        match DeTable::parse(text) {
            Ok(table) => ["camera", "object"].iter().any(|key| table.get_ref().contains_key(*key)),
            Err(_) => text.lines().any(|line| ["[camera]", "[[object]]"].contains(&line.trim())),
        }
    }

    /// Reads the text of a scene file. `file` is its name, for messages and as the default of the scene's; the paths of
    /// its meshes start at `directory`.
    ///
    /// # Errors
    /// Text that is not TOML, an unknown key or material (with the nearest known one), a mesh that cannot be read, or a
    /// value that is wrong, with what is allowed and the place.
    pub fn parse(text: &str, file: &str, directory: &Path) -> Result<Self, Error> {
        let source = Source { text, file };
        let mut table = DeTable::parse(text).map_err(|error| source.toml(&error, "", &[]))?;
        let core = table.get_mut().remove("core");
        let fields = SceneFields::deserialize(Deserializer::from(table))
            .map_err(|error| source.toml(&error, "camera", &["core"]))?;
        let core = core.map(|table| fields::core(&source, table)).transpose()?;
        let scene = fields.resolve(&source, core, directory)?;
        // Whatever was not refused for its own range.
        input::check_toml_numbers(text, file)?;
        Ok(scene)
    }
}

/// A file's stem as an identifier of both languages: lower-case letters, digits and single underscores, a letter first.
fn identifier(file: &str) -> String {
    let stem = Path::new(file).file_stem().map(|stem| stem.to_string_lossy().to_ascii_lowercase()).unwrap_or_default();
    let words = stem.split(|c: char| !c.is_ascii_lowercase() && !c.is_ascii_digit()).filter(|word| !word.is_empty());
    let mut name = words.collect::<Vec<_>>().join("_");
    if check_name(&name).is_err() {
        // It starts with a digit, is a reserved word, too long or empty.
        name = format!("scene_{name}");
        name.truncate(64);
        name.truncate(name.trim_end_matches('_').len());
    }
    name
}

/// The first that is no number, or beyond [`MAX_COORDINATE`].
pub(super) fn beyond(coordinates: &[f64]) -> Option<f64> {
    coordinates.iter().copied().find(|value| !(-MAX_COORDINATE..=MAX_COORDINATE).contains(value))
}

/// Refuses a coordinate that is not a number or beyond all measure.
fn coordinates(what: &str, values: &[f64]) -> Result<(), Error> {
    match beyond(values) {
        None => Ok(()),
        Some(value) => {
            let allowed = format!("a number of at most {MAX_COORDINATE:e} either side of 0");
            Err(Error::input(format!("{what} = {value} is out of range"), allowed))
        }
    }
}

/// The unit vector of a direction as written.
fn direction(what: &str, given: Vector) -> Result<Vector, Error> {
    coordinates(what, &given)?;
    let largest = given.iter().fold(0.0f64, |most, c| most.max(c.abs()));
    refuse!(largest == 0.0, format!("{what} is the zero vector"), "a direction has a length above 0");
    // By the largest component first: a direction of tiny numbers is one too.
    Ok(normalised(given.map(|c| c / largest)))
}
