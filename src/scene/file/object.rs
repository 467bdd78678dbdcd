//! Objects as written.

use std::path::Path;
use std::sync::Arc;

use serde::Deserialize;

use super::{MAX_COORDINATE, Object, Shape, coordinates, direction};
use crate::core::sample::Vector;
use crate::platform::error::Error;
use crate::platform::input;
use crate::scene::mesh::{Mesh, Normals, Transform};
use crate::scene::mtl;
use crate::spec::{Material, suggest};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ObjectFields {
    pub(super) kind: Kind,
    material: Option<String>,
    pub(super) materials: Option<Materials>,
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
pub(super) enum Materials {
    /// Each face's, from the file's MTL files.
    Mtl,
}

#[derive(Clone, Copy, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Kind {
    Sphere,
    Plane,
    Mesh,
}

impl Kind {
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Sphere => "sphere",
            Self::Plane => "plane",
            Self::Mesh => "mesh",
        }
    }
}

impl ObjectFields {
    /// The object, or the parts of a mesh with materials of its own, which are added to the scene's.
    pub(super) fn resolve(
        self,
        materials: &mut Vec<Material>,
        left_out: &mut Vec<String>,
        directory: &Path,
    ) -> Result<Vec<Object>, Error> {
        self.check_keys()?;
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
            Kind::Mesh => return self.mesh(own, materials, left_out, directory),
        };
        Ok(own.map(|material| Object { shape, material }).into_iter().collect())
    }
    /// Refuses the keys of another kind of object.
    fn check_keys(&self) -> Result<(), Error> {
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
        Ok(())
    }

    /// A mesh of the material `own`, or its parts with those of its file, which are added to the scene's.
    fn mesh(
        self,
        own: Option<usize>,
        materials: &mut Vec<Material>,
        left_out: &mut Vec<String>,
        directory: &Path,
    ) -> Result<Vec<Object>, Error> {
        let file = self.file.ok_or_else(|| Error::input("file is missing", "give the path of an OBJ or PLY file"))?;
        let scale = match self.scale.unwrap_or(ScaleFields::All(1.0)) {
            ScaleFields::All(factor) => [factor; 3],
            ScaleFields::Each(factors) => factors,
        };
        let allowed = 1.0 / MAX_COORDINATE..=MAX_COORDINATE;
        if let Some(factor) = scale.iter().find(|factor| !allowed.contains(&factor.abs())) {
            let what = format!("scale = {factor} is out of range");
            let allowed = format!("a factor from {:e} to {:e}, or the negative of one", allowed.start(), allowed.end());
            return Err(Error::input(what, allowed));
        }
        let default = Transform::default();
        let (rotate, translate) = (self.rotate.unwrap_or(default.rotate), self.translate.unwrap_or(default.translate));
        coordinates("rotate", &rotate)?;
        coordinates("translate", &translate)?;
        let (path, transform) = (directory.join(file), Transform { scale, rotate, translate });
        let normals = self.normals.unwrap_or_default();
        let placed = |mesh: Mesh| Ok(Shape::Mesh(Arc::new(mesh.transformed(&transform)?)));
        if self.materials != Some(Materials::Mtl) {
            let shape = placed(Mesh::read(&path, normals)?)?;
            return Ok(own.map(|material| Object { shape, material }).into_iter().collect());
        }
        let name = path.display().to_string();
        let painted = Mesh::parse_painted(&input::read(&path, input::MAX_MESH)?, &name, normals)?;
        let parts = mtl::parts(&painted, &name, path.parent().unwrap_or(Path::new("")))?;
        left_out.extend(parts.left_out);
        let object = |(mesh, material): (Mesh, Option<Material>)| {
            let material = material.map(|material| mtl::place(material, materials)).or(own).ok_or_else(|| {
                Error::input(format!("{name} has faces before its first usemtl"), "give the object a material for them")
            })?;
            Ok(Object { shape: placed(mesh)?, material })
        };
        parts.parts.into_iter().map(object).collect()
    }
}
