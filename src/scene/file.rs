//! Scene files: TOML, read and checked.

use std::sync::Arc;

use super::mesh::Mesh;
use crate::design::sample::Vector;
use crate::explore::Objective;
use crate::spec::{Colour, Material, Model, SpecFields};
use crate::synth::Family;

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
    /// The materials, in the order of the file, with their surfaces ([`Material::with_surface`]); shininess at least 1.
    pub materials: Vec<Material>,
    /// The lights, 1 to 8.
    pub lights: Vec<Light>,
    /// The objects, one at least.
    pub objects: Vec<Object>,
    /// Whether objects throw shadows.
    pub shadows: bool,
    /// The error that the picture may have.
    pub budget: Budget,
    /// What is wished of the core.
    pub core: Wishes,
}

/// A pinhole camera.
#[derive(Clone, Copy, Debug, PartialEq)]
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
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// Where its light comes from.
    pub kind: LightKind,
    /// Its colour, times its intensity; 0 to 1 a channel.
    pub colour: Colour,
}

/// Where a light's light comes from. Light is not weakened by distance, as in the classical models: the core then needs no light's strength.
#[derive(Clone, Copy, Debug, PartialEq)]
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

/// The error that a picture may have; where both are given, both hold. Without any: one step at most.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
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
