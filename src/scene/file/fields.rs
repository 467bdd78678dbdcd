//! The scene, its camera, lights and budget, and the table `[core]`, as written.

use std::path::Path;

use serde::Deserialize;
use toml::Spanned;
use toml::de::{DeTable, DeValue, Deserializer};

use super::material::{self, MaterialFields};
use super::object::ObjectFields;
use super::{
    Budget, Camera, CoreConstraints, Light, LightKind, MAX_LIGHTS, MAX_SIDE, Scene, Source, coordinates, direction,
    identifier,
};
use crate::core::sample::{Vector, dot};
use crate::explore::Objective;
use crate::platform::error::{Error, refuse};
use crate::scene::reflectance::Shading;
use crate::spec::{CHANNEL_BITS, Colour, Model, Shininess, SpecFields, check_name, unit};
use crate::target::Family;

/// The keys of `[core]` that are none of a core spec.
const CORE_KEYS: [&str; 3] = ["family", "min_mhz", "objective"];

/// A scene as written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SceneFields {
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
struct LightFields {
    direction: Option<Vector>,
    position: Option<Vector>,
    colour: Option<Colour>,
    intensity: Option<f64>,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
struct BudgetFields {
    max_steps: Option<u32>,
    min_psnr: Option<f64>,
}

/// The keys of `[core]` that are none of a core spec.
#[derive(Default, Deserialize)]
struct CoreFields {
    family: Option<Family>,
    min_mhz: Option<f64>,
    objective: Option<Objective>,
}

/// The table `[core]`.
pub(super) fn core(source: &Source, table: Spanned<DeValue>) -> Result<CoreConstraints, Error> {
    let span = table.span();
    let DeValue::Table(mut keys) = table.into_inner() else {
        return Err(source.at("", &span, Error::input("core is no table", "write a line [core] and its keys below")));
    };
    let mut own = DeTable::new();
    for key in CORE_KEYS {
        if let Some((key, value)) = keys.remove_entry(key) {
            own.insert(key, value);
        }
    }
    let table = |keys| Deserializer::from(Spanned::new(span.clone(), keys));
    let own = CoreFields::deserialize(table(own)).map_err(|error| source.toml(&error, "", &[]))?;
    let keys = SpecFields::deserialize(table(keys)).map_err(|error| source.toml(&error, "method", &CORE_KEYS))?;
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
    Ok(own.with(keys))
}

impl CoreFields {
    /// With the other keys of the table, the defaults filled in.
    fn with(self, keys: SpecFields) -> CoreConstraints {
        CoreConstraints {
            family: self.family.unwrap_or_default(),
            min_mhz: self.min_mhz,
            objective: self.objective.unwrap_or(Objective::Area),
            keys,
        }
    }
}

impl SceneFields {
    /// Fills in the defaults and checks every value.
    pub fn resolve(self, source: &Source, core: Option<CoreConstraints>, directory: &Path) -> Result<Scene, Error> {
        let name = self.name.unwrap_or_else(|| identifier(source.file));
        check_name(&name)?;
        let (width, height) = (self.width.unwrap_or(640), self.height.unwrap_or(480));
        check_size(width, height)?;
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

        let model = self.model.unwrap_or(Model::Phong);
        let (mut materials, mut reflectances) = material::all(source, self.material, self.shading, model, directory)?;
        let from_files = self.object.iter().any(|object| object.get_ref().materials.is_some());
        refuse!(materials.is_empty() && !from_files, "the scene has no materials", "give one at least: [[material]]");

        refuse!(
            !(1..=MAX_LIGHTS).contains(&self.light.len()),
            format!("the scene has {} lights", self.light.len()),
            format!("a scene has 1 to {MAX_LIGHTS} lights: [[light]]")
        );
        let lights = numbered(source, "light", self.light, |_| String::new(), LightFields::resolve)?;
        refuse!(self.object.is_empty(), "the scene has no objects", "give one at least: [[object]]");
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
            model,
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
            core: core.unwrap_or_else(|| CoreFields::default().with(SpecFields::default())),
        })
    }
}

impl CameraFields {
    fn resolve(self) -> Result<Camera, Error> {
        let target = self.target.unwrap_or([0.0; 3]);
        coordinates("position", &self.position)?;
        coordinates("target", &target)?;
        let view = [0, 1, 2].map(|axis| target[axis] - self.position[axis]);
        refuse!(view == [0.0; 3], "the camera stands at its target", "give it another position or target");
        let (view, up) = (direction("view", view)?, direction("up", self.up.unwrap_or([0.0, 1.0, 0.0]))?);
        refuse!(
            dot(view, up).abs() > 1.0 - 1e-12,
            "up is along the view",
            "give an up that is across the view from position to target"
        );
        let field_of_view = self.field_of_view.unwrap_or(40.0);
        refuse!(
            !(0.01..=179.0).contains(&field_of_view),
            format!("field_of_view = {field_of_view} is out of range"),
            "the vertical angle of view in degrees, from 0.01 to 179"
        );
        Ok(Camera { position: self.position, target, up, field_of_view })
    }
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
        refuse!(
            !(intensity >= 0.0 && intensity.is_finite()),
            format!("intensity = {intensity} is out of range"),
            "a real number of at least 0"
        );
        let most = colour.iter().fold(0.0f64, |most, &channel| most.max(channel));
        refuse!(
            intensity * most > 1.0,
            format!("intensity = {intensity} times the colour is above 1, full scale: the channel saturates"),
            format!("an intensity of at most {} for this colour", 1.0 / most)
        );
        Ok(Light { kind, colour: colour.map(|channel| channel * intensity) })
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

fn check_size(width: u32, height: u32) -> Result<(), Error> {
    for (what, side) in [("width", width), ("height", height)] {
        refuse!(
            !(1..=MAX_SIDE).contains(&side),
            format!("{what} = {side} is out of range"),
            format!("a picture has 1 to {MAX_SIDE} pixels a side")
        );
    }
    Ok(())
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
