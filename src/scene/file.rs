//! Scene files: TOML, read and checked.

use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

use serde::{Deserialize, Serialize};
use toml::Spanned;
use toml::de::{DeTable, DeValue, Deserializer};

use super::mesh::{Mesh, Normals, Transform};
use super::mtl;
use super::reflectance::{Measured, ReflectanceFields, Shading};
use crate::core::sample::{Vector, dot, normalised};
use crate::explore::Objective;
use crate::lobe::MAX_SHININESS;
use crate::platform::error::Error;
use crate::platform::input;
use crate::spec::{
    CHANNEL_BITS, Colour, Material, Model, Shininess, SpecFields, check_name, suggest, toml_error, unit,
};
use crate::synth::Family;

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
    /// The materials, in the order of the file, then those of its meshes' MTL files, with their surfaces ([`Material::with_surface`]);
    /// shininess at least 1.
    pub materials: Vec<Material>,
    /// The reflectance of each material that is drawn by it. Such a material has no highlight of its own, and no light is diffused by its keys.
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
    /// What is wished of the core.
    pub core: Wishes,
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

/// Where a light's light comes from. Light is not weakened by distance, as in the classical models: the core then needs no light's strength.
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

/// The error that a picture may have; where both are given, both hold. A file that gives neither asks for one step at most.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Budget {
    /// The largest difference of a channel's code from the exact picture's, in steps.
    pub max_steps: Option<u32>,
    /// The least peak signal-to-noise ratio against the exact picture, in dB, over all pixels and channels, in codes of a channel.
    pub min_psnr: Option<f64>,
}

/// What is wished of the core, beside the picture's budget.
#[derive(Clone, Debug)]
pub struct Wishes {
    /// The family of FPGAs.
    pub family: Family,
    /// The least frequency in MHz.
    pub min_mhz: Option<f64>,
    /// What of the core is to be least.
    pub objective: Objective,
    /// Keys of the spec that the core must have, such as its method; no shininess and no materials.
    pub keys: SpecFields,
}

/// A scene as written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SceneFields {
    name: Option<String>,
    model: Option<Model>,
    width: Option<u32>,
    height: Option<u32>,
    channel_bits: Option<u32>,
    ambient: Option<Colour>,
    background: Option<Colour>,
    shadows: Option<bool>,
    shading: Option<Shading>,
    camera: Option<Spanned<CameraFields>>,
    #[serde(default)]
    material: Vec<Spanned<MaterialFields>>,
    #[serde(default)]
    light: Vec<Spanned<LightFields>>,
    #[serde(default)]
    object: Vec<Spanned<ObjectFields>>,
    budget: Option<Spanned<BudgetFields>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct CameraFields {
    position: Vector,
    target: Option<Vector>,
    up: Option<Vector>,
    field_of_view: Option<f64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct MaterialFields {
    name: String,
    shininess: Option<f64>,
    roughness: Option<f64>,
    #[serde(alias = "k_a")]
    ambient: Option<f64>,
    #[serde(alias = "k_d")]
    diffuse: Option<f64>,
    #[serde(alias = "k_s")]
    specular: Option<f64>,
    colour: Option<Colour>,
    ambient_colour: Option<Colour>,
    specular_colour: Option<Colour>,
    shading: Option<Shading>,
    reflectance: Option<Spanned<ReflectanceFields>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct LightFields {
    direction: Option<Vector>,
    position: Option<Vector>,
    colour: Option<Colour>,
    intensity: Option<f64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ObjectFields {
    kind: Kind,
    material: Option<String>,
    materials: Option<Materials>,
    centre: Option<Vector>,
    radius: Option<f64>,
    point: Option<Vector>,
    normal: Option<Vector>,
    file: Option<String>,
    normals: Option<Normals>,
    scale: Option<ScaleFields>,
    rotate: Option<Vector>,
    translate: Option<Vector>,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(untagged, expecting = "a scale is a number, or a list of three: along x, y and z")]
enum ScaleFields {
    All(f64),
    Each(Vector),
}

/// Where a mesh's materials come from, beside the object's own.
#[derive(Clone, Copy, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Materials {
    /// Each face's, from the file's MTL files.
    Mtl,
}

#[derive(Clone, Copy, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Kind {
    Sphere,
    Plane,
    Mesh,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
struct BudgetFields {
    max_steps: Option<u32>,
    min_psnr: Option<f64>,
}

/// The keys of `[core]` that are none of a core spec.
#[derive(Default, Deserialize)]
struct WishFields {
    family: Option<Family>,
    min_mhz: Option<f64>,
    objective: Option<Objective>,
}

const WISHES: [&str; 3] = ["family", "min_mhz", "objective"];

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

    /// Whether a TOML text is a scene rather than the spec of a core: it has one of the keys `camera` and `object`, or is no TOML but
    /// has a line with such a table.
    #[must_use]
    pub fn is_scene(text: &str) -> bool {
        match DeTable::parse(text) {
            Ok(table) => ["camera", "object"].iter().any(|key| table.get_ref().contains_key(*key)),
            Err(_) => text.lines().any(|line| ["[camera]", "[[object]]"].contains(&line.trim())),
        }
    }

    /// Reads the text of a scene file. `file` is its name, for messages and as the default of the scene's; the paths of its meshes
    /// start at `directory`.
    ///
    /// # Errors
    /// Text that is not TOML, an unknown key or material (with the nearest known one), a mesh that cannot be read, or a value that is
    /// wrong, with what is allowed and the place.
    pub fn parse(text: &str, file: &str, directory: &Path) -> Result<Self, Error> {
        let source = Source { text, file };
        let mut table = DeTable::parse(text).map_err(|error| source.toml(&error, "", &[]))?;
        let core = table.get_mut().remove("core");
        let fields = SceneFields::deserialize(Deserializer::from(table))
            .map_err(|error| source.toml(&error, "camera", &["core"]))?;
        let core = core.map(|table| wishes(&source, table)).transpose()?;
        let scene = fields.resolve(&source, core, directory)?;
        // Whatever was not refused for its own range.
        input::check_toml_numbers(text, file)?;
        Ok(scene)
    }
}

/// The table `[core]`.
fn wishes(source: &Source, table: Spanned<DeValue>) -> Result<Wishes, Error> {
    let span = table.span();
    let DeValue::Table(mut keys) = table.into_inner() else {
        return Err(source.at("", &span, Error::input("core is no table", "write a line [core] and its keys below")));
    };
    let mut own = DeTable::new();
    for key in WISHES {
        if let Some((key, value)) = keys.remove_entry(key) {
            own.insert(key, value);
        }
    }
    let table = |keys| Deserializer::from(Spanned::new(span.clone(), keys));
    let own = WishFields::deserialize(table(own)).map_err(|error| source.toml(&error, "", &[]))?;
    let keys = SpecFields::deserialize(table(keys)).map_err(|error| source.toml(&error, "method", &WISHES))?;
    let given = [
        ("a name", keys.name.is_some(), "the core is called as the scene: give the scene's key name"),
        ("a shininess", keys.shininess.is_some(), "the scene's materials have them"),
        ("materials", keys.material.is_some(), "give them as the scene's: [[material]]"),
    ];
    if let Some((what, _, allowed)) = given.into_iter().find(|(_, given, _)| *given) {
        return Err(source.at("", &span, Error::input(format!("core is given {what}"), allowed)));
    }
    if let Some(mhz) = own.min_mhz.filter(|mhz| !(*mhz > 0.0 && mhz.is_finite())) {
        let wrong = Error::input(format!("min_mhz = {mhz} is out of range"), "a real number above 0");
        return Err(source.at("core: ", &span, wrong));
    }
    Ok(Wishes {
        family: own.family.unwrap_or(Family::Ecp5),
        min_mhz: own.min_mhz,
        objective: own.objective.unwrap_or(Objective::Area),
        keys,
    })
}

impl SceneFields {
    /// Fills in the defaults and checks every value.
    fn resolve(self, source: &Source, core: Option<Wishes>, directory: &Path) -> Result<Scene, Error> {
        let name = match self.name {
            Some(name) => name,
            None => identifier(source.file),
        };
        check_name(&name)?;
        let (width, height) = (self.width.unwrap_or(640), self.height.unwrap_or(480));
        for (what, side) in [("width", width), ("height", height)] {
            if !(1..=MAX_SIDE).contains(&side) {
                return Err(Error::input(
                    format!("{what} = {side} is out of range"),
                    format!("a picture has 1 to {MAX_SIDE} pixels a side"),
                ));
            }
        }
        let channel_bits = self.channel_bits.unwrap_or(8);
        if !CHANNEL_BITS.contains(&channel_bits) {
            return Err(Error::input(format!("channel_bits = {channel_bits} is not offered"), "8, 10 or 12"));
        }
        let (ambient, background) = (self.ambient.unwrap_or([0.2; 3]), self.background.unwrap_or([0.0; 3]));
        unit("ambient", &ambient)?;
        unit("background", &background)?;
        let camera =
            self.camera.ok_or_else(|| Error::input("the scene has no camera", "give [camera] with a position"))?;
        let span = camera.span();
        let camera = camera.into_inner().resolve().map_err(|error| source.at("camera: ", &span, error))?;

        let mut materials: Vec<Material> = Vec::with_capacity(self.material.len());
        let mut reflectances: Vec<Option<Arc<Measured>>> = Vec::with_capacity(self.material.len());
        for (index, material) in self.material.into_iter().enumerate() {
            let span = material.span();
            let place = |error| source.at("", &span, error);
            let mut fields = material.into_inner();
            let reflectance = fields.reflectance.take();
            let own = reflectance.as_ref().and_then(|table| table.get_ref().shading).or(fields.shading);
            if reflectance.is_none() && own.is_some_and(|own| own != Shading::Classical) {
                return Err(place(Error::input(
                    format!("material {} has a shading and no reflectance", fields.name),
                    "give [material.reflectance] with a file or a model",
                )));
            }
            let shading = own.or(self.shading).unwrap_or(Shading::ImageBased);
            let measured = match reflectance {
                None => None,
                Some(table) => {
                    let (span, what) = (table.span(), format!("material {}: reflectance: ", fields.name));
                    let measured = table.into_inner().resolve(shading, directory);
                    Some(measured.map_err(|error| source.at(&what, &span, error))?)
                }
            };
            let material = match measured {
                Some(measured) if shading == Shading::Classical => {
                    fields.fit(&measured, self.model.unwrap_or(Model::Phong)).map_err(place)?;
                    reflectances.push(None);
                    fields
                }
                Some(measured) => {
                    reflectances.push(Some(Arc::new(measured)));
                    fields.without_highlight()
                }
                None => {
                    reflectances.push(None);
                    fields
                }
            };
            let material = material.resolve(index).map_err(place)?;
            if materials.iter().any(|other| other.name == material.name) {
                let what = format!("there are two materials {}", material.name);
                return Err(place(Error::input(what, "each has a name of its own")));
            }
            materials.push(material);
        }
        let from_files = self.object.iter().any(|object| object.get_ref().materials.is_some());
        if materials.is_empty() && !from_files {
            return Err(Error::input("the scene has no materials", "give one at least: [[material]]"));
        }

        if !(1..=MAX_LIGHTS).contains(&self.light.len()) {
            return Err(Error::input(
                format!("the scene has {} lights", self.light.len()),
                format!("a scene has 1 to {MAX_LIGHTS} lights: [[light]]"),
            ));
        }
        let lights = numbered(source, "light", self.light, |_| String::new(), LightFields::resolve)?;
        if self.object.is_empty() {
            return Err(Error::input("the scene has no objects", "give one at least: [[object]]"));
        }
        let mut left_out: Vec<String> = Vec::new();
        let objects = numbered(
            source,
            "object",
            self.object,
            |object| format!(" ({})", object.kind.name()),
            |object| object.resolve(&mut materials, &mut left_out, directory),
        )?;
        let objects = objects.into_iter().flatten().collect();
        left_out.sort();
        left_out.dedup();
        Shininess::Materials(materials.clone()).check()?;
        reflectances.resize(materials.len(), None);
        let has_budget = self.budget.is_some();
        let budget = match self.budget {
            None => Budget { max_steps: Some(1), min_psnr: None },
            Some(budget) => {
                budget.get_ref().resolve(channel_bits).map_err(|error| source.at("budget: ", &budget.span(), error))?
            }
        };
        Ok(Scene {
            name,
            model: self.model.unwrap_or(Model::Phong),
            width,
            height,
            channel_bits,
            ambient,
            background,
            camera,
            materials,
            reflectances,
            left_out,
            lights,
            objects,
            shadows: self.shadows.unwrap_or(false),
            budget,
            has_budget,
            core: core.unwrap_or_else(|| Wishes {
                family: Family::Ecp5,
                min_mhz: None,
                objective: Objective::Area,
                keys: SpecFields::default(),
            }),
        })
    }
}

/// Resolves each of a list; an error says which it is, counted from 1.
fn numbered<F, T>(
    source: &Source,
    what: &str,
    list: Vec<Spanned<F>>,
    kind: impl Fn(&F) -> String,
    mut resolve: impl FnMut(F) -> Result<T, Error>,
) -> Result<Vec<T>, Error> {
    let one = |(index, item): (usize, Spanned<F>)| {
        let (span, kind) = (item.span(), kind(item.get_ref()));
        resolve(item.into_inner()).map_err(|error| source.at(&format!("{what} {}{kind}: ", index + 1), &span, error))
    };
    list.into_iter().enumerate().map(one).collect()
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
    if largest == 0.0 {
        return Err(Error::input(format!("{what} is the zero vector"), "a direction has a length above 0"));
    }
    // By the largest component first: a direction of tiny numbers is one too.
    Ok(normalised(given.map(|c| c / largest)))
}

impl CameraFields {
    fn resolve(self) -> Result<Camera, Error> {
        let target = self.target.unwrap_or([0.0; 3]);
        coordinates("position", &self.position)?;
        coordinates("target", &target)?;
        let view = [0, 1, 2].map(|axis| target[axis] - self.position[axis]);
        if view == [0.0; 3] {
            return Err(Error::input("the camera stands at its target", "give it another position or target"));
        }
        let (view, up) = (direction("view", view)?, direction("up", self.up.unwrap_or([0.0, 1.0, 0.0]))?);
        if dot(view, up).abs() > 1.0 - 1e-12 {
            return Err(Error::input(
                "up is along the view",
                "give an up that is across the view from position to target",
            ));
        }
        let field_of_view = self.field_of_view.unwrap_or(40.0);
        if !(0.01..=179.0).contains(&field_of_view) {
            return Err(Error::input(
                format!("field_of_view = {field_of_view} is out of range"),
                "the vertical angle of view in degrees, from 0.01 to 179",
            ));
        }
        Ok(Camera { position: self.position, target, up, field_of_view })
    }
}

impl MaterialFields {
    /// Fills in the diffuse part and the highlight that are nearest to a reflectance, where the file has none of its own.
    fn fit(&mut self, measured: &Measured, model: Model) -> Result<(), Error> {
        if self.shininess.is_some() || self.roughness.is_some() {
            return Ok(());
        }
        let fitted = measured.fitted(model, 1)?;
        let lobe = fitted.lobes.first().map_or(([0.0; 3], 1.0), |lobe| (lobe.ks, lobe.n));
        // A factor and a colour are at most 1, and so is what is seen.
        let parts = |rgb: Colour| {
            let most = rgb.into_iter().fold(0.0, f64::max);
            let colour = if most > 0.0 { rgb.map(|channel| channel / most) } else { [1.0; 3] };
            (most.min(1.0), colour)
        };
        let ((diffuse, colour), (specular, specular_colour)) = (parts(fitted.kd), parts(lobe.0));
        self.shininess = Some(lobe.1);
        self.ambient = self.ambient.or(Some(0.0));
        self.diffuse = self.diffuse.or(Some(diffuse));
        self.colour = self.colour.or(Some(colour));
        self.specular = self.specular.or(Some(specular));
        self.specular_colour = self.specular_colour.or(Some(specular_colour));
        Ok(())
    }

    /// The material as one that asks for no lobe: a reflectance draws it. What it gives back of the ambient light stays.
    fn without_highlight(self) -> Self {
        Self {
            shininess: Some(1.0),
            roughness: None,
            ambient: self.ambient.or(Some(0.0)),
            diffuse: Some(0.0),
            specular: Some(0.0),
            ..self
        }
    }

    /// The material with its surface; `index` is its place in the file, from 0.
    fn resolve(self, index: usize) -> Result<Material, Error> {
        let name = if self.name.is_empty() { format!("{}", index + 1) } else { self.name.clone() };
        let shininess = match (self.shininess, self.roughness) {
            (Some(shininess), None) => shininess,
            (None, Some(alpha)) => of_roughness(alpha).ok_or_else(|| {
                Error::input(
                    format!("material {name}: roughness = {alpha} is out of range"),
                    "a real number above 0.0014 and at most sqrt(2/3) = 0.8164: the shininess is 2 / roughness^2 - 2",
                )
            })?,
            (Some(_), Some(_)) => {
                let what = format!("material {name} has both shininess and roughness");
                return Err(Error::input(what, "give one of the two"));
            }
            (None, None) => {
                return Err(Error::input(format!("material {name} has no shininess"), "give shininess or roughness"));
            }
        };
        let material = Material {
            name: self.name,
            shininess,
            ambient: self.ambient,
            diffuse: self.diffuse,
            specular: self.specular,
            colour: self.colour,
            ambient_colour: self.ambient_colour,
            specular_colour: self.specular_colour,
        };
        Shininess::Materials(vec![material.clone()]).check()?;
        material.check_surface()?;
        Ok(material.with_surface())
    }
}

/// The shininess of a roughness: the exponent of the Phong distribution of half vectors that is about as wide as the Beckmann
/// distribution of width alpha, `n = 2 / alpha^2 - 2` (Walter, Marschner, Li and Torrance 2007, "Microfacet Models for Refraction
/// through Rough Surfaces", section 5.2), to 12 significant digits; none where that is below 1 or beyond the greatest shininess.
fn of_roughness(alpha: f64) -> Option<f64> {
    let n = 2.0 / (alpha * alpha) - 2.0;
    // Without the last bits, which are of the computation: 0.4 gives 10.5.
    let n = format!("{n:.11e}").parse().unwrap_or(n);
    // The root of 2/3 itself is no f64.
    let n = if (1.0 - 1e-9..1.0).contains(&n) { 1.0 } else { n };
    (alpha > 0.0 && (1.0..=MAX_SHININESS).contains(&n)).then_some(n)
}

impl LightFields {
    fn resolve(self) -> Result<Light, Error> {
        let kind = match (self.direction, self.position) {
            (Some(towards), None) => LightKind::Directional(direction("direction", towards)?),
            (None, Some(position)) => {
                coordinates("position", &position)?;
                LightKind::Point(position)
            }
            (Some(_), Some(_)) => {
                return Err(Error::input("both direction and position are given", "give one of the two"));
            }
            (None, None) => {
                return Err(Error::input(
                    "neither direction nor position is given",
                    "give the direction towards a distant light, or the position of a near one",
                ));
            }
        };
        let colour = self.colour.unwrap_or([1.0; 3]);
        unit("colour", &colour)?;
        let intensity = self.intensity.unwrap_or(1.0);
        if !(intensity >= 0.0 && intensity.is_finite()) {
            return Err(Error::input(
                format!("intensity = {intensity} is out of range"),
                "a real number of at least 0",
            ));
        }
        let most = colour.iter().fold(0.0f64, |most, &channel| most.max(channel));
        if intensity * most > 1.0 {
            return Err(Error::input(
                format!("intensity = {intensity} times the colour is above 1, full scale: the channel saturates"),
                format!("an intensity of at most {} for this colour", 1.0 / most),
            ));
        }
        Ok(Light { kind, colour: colour.map(|channel| channel * intensity) })
    }
}

impl Kind {
    fn name(self) -> &'static str {
        match self {
            Self::Sphere => "sphere",
            Self::Plane => "plane",
            Self::Mesh => "mesh",
        }
    }
}

impl ObjectFields {
    /// The object, or the parts of a mesh with materials of its own, which are added to the scene's.
    fn resolve(
        self,
        materials: &mut Vec<Material>,
        left_out: &mut Vec<String>,
        directory: &Path,
    ) -> Result<Vec<Object>, Error> {
        let keys = [
            ("centre", self.centre.is_some(), Kind::Sphere),
            ("radius", self.radius.is_some(), Kind::Sphere),
            ("point", self.point.is_some(), Kind::Plane),
            ("normal", self.normal.is_some(), Kind::Plane),
            ("file", self.file.is_some(), Kind::Mesh),
            ("materials", self.materials.is_some(), Kind::Mesh),
            ("normals", self.normals.is_some(), Kind::Mesh),
            ("scale", self.scale.is_some(), Kind::Mesh),
            ("rotate", self.rotate.is_some(), Kind::Mesh),
            ("translate", self.translate.is_some(), Kind::Mesh),
        ];
        if let Some((key, ..)) = keys.iter().find(|(_, given, kind)| *given && *kind != self.kind) {
            let own = keys.iter().filter(|(.., kind)| *kind == self.kind).map(|(key, ..)| *key).collect::<Vec<_>>();
            let what = format!("a {} has no {key}", self.kind.name());
            return Err(Error::input(what, format!("its keys are kind, material, {}", own.join(", "))));
        }
        let find = |wanted: &String| {
            materials.iter().position(|material| material.name == *wanted).ok_or_else(|| {
                let known = materials.iter().map(|material| material.name.as_str());
                Error::input(format!("unknown material `{wanted}`"), suggest("materials", wanted, known))
            })
        };
        let own = self.material.as_ref().map(find).transpose()?;
        if own.is_none() && self.materials.is_none() {
            let what = format!("a {} has no material", self.kind.name());
            return Err(Error::input(what, "give material: the name of one of the [[material]]"));
        }
        let shape = match self.kind {
            Kind::Sphere => {
                let (centre, radius) = (self.centre.unwrap_or([0.0; 3]), self.radius.unwrap_or(1.0));
                coordinates("centre", &centre)?;
                if !(radius > 0.0 && radius <= MAX_COORDINATE) {
                    let allowed = format!("a radius is above 0 and at most {MAX_COORDINATE:e}");
                    return Err(Error::input(format!("radius = {radius} is out of range"), allowed));
                }
                Shape::Sphere { centre, radius }
            }
            Kind::Plane => {
                let point = self.point.unwrap_or([0.0; 3]);
                coordinates("point", &point)?;
                Shape::Plane { point, normal: direction("normal", self.normal.unwrap_or([0.0, 1.0, 0.0]))? }
            }
            Kind::Mesh => {
                let file =
                    self.file.ok_or_else(|| Error::input("file is missing", "give the path of an OBJ or PLY file"))?;
                let scale = match self.scale.unwrap_or(ScaleFields::All(1.0)) {
                    ScaleFields::All(factor) => [factor; 3],
                    ScaleFields::Each(factors) => factors,
                };
                let allowed = 1.0 / MAX_COORDINATE..=MAX_COORDINATE;
                if let Some(factor) = scale.iter().find(|factor| !allowed.contains(&factor.abs())) {
                    let what = format!("scale = {factor} is out of range");
                    let allowed =
                        format!("a factor from {:e} to {:e}, or the negative of one", allowed.start(), allowed.end());
                    return Err(Error::input(what, allowed));
                }
                let default = Transform::default();
                let (rotate, translate) =
                    (self.rotate.unwrap_or(default.rotate), self.translate.unwrap_or(default.translate));
                coordinates("rotate", &rotate)?;
                coordinates("translate", &translate)?;
                let (path, transform) = (directory.join(file), Transform { scale, rotate, translate });
                let normals = self.normals.unwrap_or_default();
                let placed = |mesh: Mesh| Ok(Shape::Mesh(Arc::new(mesh.transformed(&transform)?)));
                if self.materials != Some(Materials::Mtl) {
                    placed(Mesh::read(&path, normals)?)?
                } else {
                    let name = path.display().to_string();
                    let painted = Mesh::parse_painted(&input::read(&path, input::MAX_MESH)?, &name, normals)?;
                    let parts = mtl::parts(&painted, &name, path.parent().unwrap_or(Path::new("")))?;
                    left_out.extend(parts.left_out);
                    let object = |(mesh, material): (Mesh, Option<Material>)| {
                        let material =
                            material.map(|material| mtl::place(material, materials)).or(own).ok_or_else(|| {
                                Error::input(
                                    format!("{name} has faces before its first usemtl"),
                                    "give the object a material for them",
                                )
                            })?;
                        Ok(Object { shape: placed(mesh)?, material })
                    };
                    return parts.parts.into_iter().map(object).collect();
                }
            }
        };
        Ok(own.map(|material| Object { shape, material }).into_iter().collect())
    }
}

impl BudgetFields {
    fn resolve(self, channel_bits: u32) -> Result<Budget, Error> {
        let full = (1 << channel_bits) - 1;
        if let Some(steps) = self.max_steps.filter(|steps| *steps > full) {
            let allowed = format!("0 to {full}, the steps of a channel of {channel_bits} bits");
            return Err(Error::input(format!("max_steps = {steps} is out of range"), allowed));
        }
        if let Some(psnr) = self.min_psnr.filter(|psnr| !(*psnr > 0.0 && psnr.is_finite())) {
            return Err(Error::input(format!("min_psnr = {psnr} is out of range"), "a number of dB above 0"));
        }
        let max_steps = self.max_steps.or(if self.min_psnr.is_none() { Some(1) } else { None });
        Ok(Budget { max_steps, min_psnr: self.min_psnr })
    }
}
