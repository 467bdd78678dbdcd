//! Triangle meshes, from OBJ and PLY.

use std::collections::HashMap;
use std::path::Path;

use serde::Deserialize;

use super::file::{MAX_COORDINATE, beyond};
use super::obj::read_obj;
use super::ply::{plain_ply, read_ply};
use super::text::{first_line, without_mark};
use crate::core::sample::{Vector, cross, dot, minus, normalised};
use crate::platform::error::{Error, refuse};
use crate::platform::input;

/// The most vertices, and the most triangles, of a mesh.
pub const MAX_TRIANGLES: usize = 1 << 26;
/// The sine, relative to the longest edge squared, below which a triangle has no area: rounding alone would decide on
/// its normal.
const NO_AREA: f64 = 1e-12;
/// What can be read.
pub(super) const FORMATS: &str = "a mesh is an OBJ file, or a PLY file of version 1.0, ascii or binary";

/// A triangle mesh with a normal at each corner.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// The places of the vertices.
    pub positions: Vec<Vector>,
    /// The normals, unit vectors.
    pub normals: Vec<Vector>,
    /// The triangles: for each corner the place of its position and of its normal. Seen from outside they turn to the
    /// left.
    pub triangles: Vec<[Corner; 3]>,
    /// How many triangles of the file were left out because they have no area.
    pub dropped: usize,
}

/// A corner of a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Corner {
    /// Its place in [`Mesh::positions`].
    pub position: u32,
    /// Its place in [`Mesh::normals`].
    pub normal: u32,
}

/// Where a mesh's normals come from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Normals {
    /// The file's, where it has one for every corner; otherwise smooth ones.
    #[default]
    File,
    /// At each vertex the sum of the normals of the triangles around it, each times its area. Vertices in the same
    /// place are one.
    Smooth,
    /// Each triangle's own.
    Flat,
}

/// How a mesh is put into a scene: scaled, then turned about x, then y, then z, then moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    /// Factors along x, y and z; none is 0. A negative one mirrors.
    pub scale: Vector,
    /// Angles about x, y and z in degrees; a positive one turns to the left when looked at from the axis's end.
    pub rotate: Vector,
    /// What is added to each position.
    pub translate: Vector,
}

/// A name in an OBJ file, and where it stands first.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Named {
    /// The name as written: blanks and `#` may be in it.
    pub name: String,
    /// The line, from 1.
    pub line: usize,
}

/// A mesh with the materials that its file gives to its faces.
pub(super) struct Painted {
    /// The mesh.
    pub mesh: Mesh,
    /// What its statements `mtllib` name.
    pub libraries: Vec<Named>,
    /// The materials of its statements `usemtl`.
    pub materials: Vec<Named>,
    /// For each triangle the place of its material in `materials`; their number for none.
    pub of_triangle: Vec<u32>,
}

/// What a file says of a mesh: every coordinate within [`MAX_COORDINATE`], every corner there.
#[derive(Default)]
pub(super) struct Raw {
    pub positions: Vec<Vector>,
    /// Not yet of length 1; empty where the file has none, or not one for every corner.
    pub normals: Vec<Vector>,
    pub triangles: Vec<[Corner; 3]>,
    /// As in [`Painted`].
    pub libraries: Vec<Named>,
    pub materials: Vec<Named>,
    pub of_triangle: Vec<u32>,
}

impl Mesh {
    /// Reads an OBJ or a PLY file; which one it is, its text says. A byte order mark, any line ends and, in OBJ, lines
    /// continued by `\` are read as they are meant.
    ///
    /// # Errors
    /// An unreadable file, or what [`Mesh::parse`] refuses.
    pub fn read(path: &Path, normals: Normals) -> Result<Self, Error> {
        let bytes = input::read(path, input::MAX_MESH)?;
        Self::parse(&bytes, &path.display().to_string(), normals)
    }

    /// Reads the content of an OBJ or a PLY file; `file` is its name, for messages. Polygons become fans of triangles;
    /// points, lines, colours and textures are passed over; triangles without an area are left out and counted; a
    /// normal of length 0 is replaced by the triangle's own.
    ///
    /// # Errors
    /// Something else than the two formats, a coordinate that is no number or beyond [`MAX_COORDINATE`], a face with a
    /// vertex that is not there, a file that ends early, a mesh without any triangle that has an area, or with more
    /// than [`MAX_TRIANGLES`].
    pub fn parse(bytes: &[u8], file: &str, normals: Normals) -> Result<Self, Error> {
        Self::parse_painted(bytes, file, normals).map(|painted| painted.mesh)
    }

    /// As [`Mesh::parse`], with the materials of the faces.
    pub(super) fn parse_painted(bytes: &[u8], file: &str, normals: Normals) -> Result<Painted, Error> {
        let bytes = without_mark(bytes, file, FORMATS)?;
        let raw = if first_line(bytes).0.trim_ascii_end() == b"ply" {
            read_ply(&plain_ply(bytes), file)?
        } else {
            read_obj(&String::from_utf8_lossy(bytes), file)?
        };
        raw.finish(file, normals)
    }

    /// The part of the mesh whose triangles are `wanted`, with those positions and normals alone that it needs; no
    /// triangle was dropped from it.
    pub(super) fn part(&self, wanted: impl Fn(usize) -> bool) -> Self {
        /// The new place of a vector, which is copied when it is first met.
        fn moved(places: &mut HashMap<u32, u32>, place: u32, from: &[Vector], to: &mut Vec<Vector>) -> u32 {
            *places.entry(place).or_insert_with(|| {
                to.push(from[place as usize]);
                to.len() as u32 - 1
            })
        }
        let mut part = Self::default();
        let (mut positions, mut normals) = (HashMap::new(), HashMap::new());
        for (_, corners) in self.triangles.iter().enumerate().filter(|(index, _)| wanted(*index)) {
            let corners = corners.map(|corner| Corner {
                position: moved(&mut positions, corner.position, &self.positions, &mut part.positions),
                normal: moved(&mut normals, corner.normal, &self.normals, &mut part.normals),
            });
            part.triangles.push(corners);
        }
        part
    }

    /// The mesh in its place in a scene. Normals stay across the surface and outside, whatever the scale.
    ///
    /// # Errors
    /// A vertex beyond [`MAX_COORDINATE`], or no triangle that has an area left.
    pub fn transformed(self, transform: &Transform) -> Result<Self, Error> {
        let Transform { scale, rotate, translate } = *transform;
        let turns = rotate.map(|degrees| {
            let angle = degrees.to_radians();
            (libm::sin(angle), libm::cos(angle))
        });
        let turned = |v: Vector| {
            turns.iter().enumerate().fold(v, |mut v, (axis, (sin, cos))| {
                let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
                (v[a], v[b]) = (cos * v[a] - sin * v[b], sin * v[a] + cos * v[b]);
                v
            })
        };
        let place = |p: &Vector| {
            let turned = turned([0, 1, 2].map(|axis| p[axis] * scale[axis]));
            [0, 1, 2].map(|axis| turned[axis] + translate[axis])
        };
        // The inverse transpose of a scale is its reciprocal, of a rotation itself; times the least factor, so that
        // none overflows.
        let least = scale.iter().fold(f64::INFINITY, |least, factor| least.min(factor.abs()));
        let across = |n: &Vector| normalised(turned([0, 1, 2].map(|axis| n[axis] * (least / scale[axis]))));
        let positions: Vec<Vector> = self.positions.iter().map(place).collect();
        if let Some(vertex) = positions.iter().position(|p| beyond(p).is_some()) {
            return Err(Error::input(
                format!("the mesh's vertex {vertex} comes to lie at {:?}", positions[vertex]),
                format!("coordinates of at most {MAX_COORDINATE:e} either side of 0"),
            ));
        }
        let mirrored = scale.iter().filter(|factor| **factor < 0.0).count() % 2 == 1;
        let normals = self.normals.iter().map(across).collect();
        let (mut triangles, all) = (self.triangles, self.dropped);
        let before = triangles.len();
        triangles.retain(|triangle| own_normal(&positions, triangle).is_some());
        if mirrored {
            triangles.iter_mut().for_each(|triangle| triangle.swap(1, 2));
        }
        refuse!(triangles.is_empty(), "its scale leaves no triangle of the mesh with an area", "a scale nearer to 1");
        Ok(Self { positions, normals, dropped: all + before - triangles.len(), triangles })
    }
}

impl Default for Transform {
    fn default() -> Self {
        Self { scale: [1.0; 3], rotate: [0.0; 3], translate: [0.0; 3] }
    }
}

/// A triangle's normal by the order of its corners; none if it has no area.
fn own_normal(positions: &[Vector], triangle: &[Corner; 3]) -> Option<Vector> {
    let [a, b, c] = triangle.map(|corner| positions[corner.position as usize]);
    let edges = [minus(b, a), minus(c, a), minus(c, b)];
    let longest = edges.iter().flatten().fold(0.0f64, |most, component| most.max(component.abs()));
    // In units of the longest edge, so that tiny triangles are triangles too; a triangle of one point divides 0 by 0.
    let [first, second, _] = edges.map(|edge| edge.map(|component| component / longest));
    let normal = cross(first, second);
    let length = libm::sqrt(dot(normal, normal));
    (length > NO_AREA).then(|| normal.map(|component| component / length))
}

impl Raw {
    /// Leaves out what has no area, and sees to the normals.
    fn finish(self, file: &str, wanted: Normals) -> Result<Painted, Error> {
        let Self { positions, normals: given, mut triangles, libraries, materials, mut of_triangle } = self;
        if positions.len().max(triangles.len()) > MAX_TRIANGLES {
            let what = format!("{file} has {} vertices and {} triangles", positions.len(), triangles.len());
            return Err(Error::input(what, format!("a mesh has at most {MAX_TRIANGLES} of each")));
        }
        let all = triangles.len();
        let mut places = triangles.iter();
        of_triangle.retain(|_| places.next().is_some_and(|triangle| own_normal(&positions, triangle).is_some()));
        triangles.retain(|triangle| own_normal(&positions, triangle).is_some());
        let dropped = all - triangles.len();
        if triangles.is_empty() {
            let what = match all {
                0 => format!("{file} has no faces"),
                _ => format!("none of the {all} triangles of {file} has an area"),
            };
            return Err(Error::input(what, "a mesh has one triangle with an area at least"));
        }
        let own = |triangle: &[Corner; 3]| own_normal(&positions, triangle).expect("those without are left out");
        let mut normals = Vec::new();
        match wanted {
            Normals::Flat => {
                for triangle in &mut triangles {
                    let place = normals.len() as u32;
                    normals.push(own(triangle));
                    triangle.iter_mut().for_each(|corner| corner.normal = place);
                }
            }
            Normals::File if !given.is_empty() => place_normals(&given, &mut triangles, own, &mut normals),
            Normals::File | Normals::Smooth => {
                let (smooth, groups) = smooth(&positions, &triangles);
                for corner in triangles.iter_mut().flatten() {
                    corner.normal = groups[corner.position as usize];
                }
                place_normals(&smooth, &mut triangles, own, &mut normals);
            }
        }
        Ok(Painted { mesh: Mesh { positions, normals, triangles, dropped }, libraries, materials, of_triangle })
    }
}

/// Appends the unit vectors of those of the `given` normals that corners name to `normals` and has the corners name
/// them there; where one has the length 0, the triangle's own takes its place.
fn place_normals(
    given: &[Vector],
    triangles: &mut [[Corner; 3]],
    own: impl Fn(&[Corner; 3]) -> Vector,
    normals: &mut Vec<Vector>,
) {
    const NONE: u32 = u32::MAX;
    let mut places = vec![NONE; given.len()];
    for triangle in triangles {
        let mut own_place = NONE;
        let names = triangle.map(|corner| corner.normal as usize);
        for (corner, name) in names.into_iter().enumerate() {
            let normal = given[name];
            let largest = normal.iter().fold(0.0f64, |most, component| most.max(component.abs()));
            let place = if largest > 0.0 { &mut places[name] } else { &mut own_place };
            if *place == NONE {
                *place = normals.len() as u32;
                let unit = || normalised(normal.map(|component| component / largest));
                normals.push(if largest > 0.0 { unit() } else { own(triangle) });
            }
            triangle[corner].normal = *place;
        }
    }
}

/// For each place that vertices have the sum of the normals of the triangles there, each times its area, 0 where they
/// cancel; and for each vertex which of these it has.
fn smooth(positions: &[Vector], triangles: &[[Corner; 3]]) -> (Vec<Vector>, Vec<u32>) {
    let mut places: HashMap<[u64; 3], u32> = HashMap::with_capacity(positions.len());
    let groups: Vec<u32> = positions
        .iter()
        .map(|position| {
            let next = places.len() as u32;
            // Adding 0 makes one of the two zeros.
            *places.entry(position.map(|component| (component + 0.0).to_bits())).or_insert(next)
        })
        .collect();
    let largest = positions.iter().flatten().fold(0.0f64, |most, component| most.max(component.abs()));
    let (mut sums, mut areas) = (vec![[0.0; 3]; places.len()], vec![0.0; places.len()]);
    for triangle in triangles {
        // In units of the largest coordinate: the square of a tiny one would be 0.
        let [a, b, c] = triangle.map(|corner| positions[corner.position as usize].map(|p| p / largest));
        let normal = cross(minus(b, a), minus(c, a));
        for corner in triangle {
            let group = groups[corner.position as usize] as usize;
            sums[group] = [0, 1, 2].map(|axis| sums[group][axis] + normal[axis]);
            areas[group] += libm::sqrt(dot(normal, normal));
        }
    }
    for (sum, area) in sums.iter_mut().zip(&areas) {
        if libm::sqrt(dot(*sum, *sum)) <= NO_AREA * area {
            *sum = [0.0; 3];
        }
    }
    (sums, groups)
}

pub(super) fn allowed_coordinate() -> String {
    format!("a number of at most {MAX_COORDINATE:e} either side of 0")
}
