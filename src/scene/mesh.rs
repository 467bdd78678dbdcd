//! Triangle meshes, from OBJ and PLY.

use std::collections::HashMap;
use std::path::Path;

use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{Property, PropertyAccess, PropertyAccessResult};
use serde::Deserialize;

use super::file::{MAX_COORDINATE, beyond};
use crate::design::sample::{Vector, cross, dot, minus, normalised};
use crate::error::Error;
use crate::input;

/// The most vertices, and the most triangles, of a mesh.
pub const MAX_TRIANGLES: usize = 1 << 26;
/// The sine, relative to the longest edge squared, below which a triangle has no area: rounding alone would decide on its normal.
const NO_AREA: f64 = 1e-12;
/// What can be read.
const FORMATS: &str = "a mesh is an OBJ file, or a PLY file of version 1.0, ascii or binary";

/// A triangle mesh with a normal at each corner.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// The places of the vertices.
    pub positions: Vec<Vector>,
    /// The normals, unit vectors.
    pub normals: Vec<Vector>,
    /// The triangles: for each corner the place of its position and of its normal. Seen from outside they turn to the left.
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
    /// At each vertex the sum of the normals of the triangles around it, each times its area. Vertices in the same place are one.
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

/// What a file says of a mesh: every coordinate within [`MAX_COORDINATE`], every corner there.
struct Raw {
    positions: Vec<Vector>,
    /// Not yet of length 1; empty where the file has none, or not one for every corner.
    normals: Vec<Vector>,
    triangles: Vec<[Corner; 3]>,
}

impl Mesh {
    /// Reads an OBJ or a PLY file; which one it is, its text says.
    ///
    /// # Errors
    /// An unreadable file, or what [`Mesh::parse`] refuses.
    pub fn read(path: &Path, normals: Normals) -> Result<Self, Error> {
        let bytes = input::read(path, input::MAX_MESH)?;
        Self::parse(&bytes, &path.display().to_string(), normals)
    }

    /// Reads the content of an OBJ or a PLY file; `file` is its name, for messages. Polygons become fans of triangles; points, lines,
    /// colours and textures are passed over; triangles without an area are left out and counted; a normal of length 0 is replaced
    /// by the triangle's own.
    ///
    /// # Errors
    /// Something else than the two formats, a coordinate that is no number or beyond [`MAX_COORDINATE`], a face with a vertex that
    /// is not there, a file that ends early, a mesh without any triangle that has an area, or with more than [`MAX_TRIANGLES`].
    pub fn parse(bytes: &[u8], file: &str, normals: Normals) -> Result<Self, Error> {
        let raw = if [&b"ply\n"[..], b"ply\r"].iter().any(|magic| bytes.starts_with(magic)) {
            read_ply(bytes, file)?
        } else {
            read_obj(&String::from_utf8_lossy(bytes), file)?
        };
        raw.finish(file, normals)
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
        // The inverse transpose of a scale is its reciprocal, of a rotation itself; times the least factor, so that none overflows.
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
        if triangles.is_empty() {
            return Err(Error::input("its scale leaves no triangle of the mesh with an area", "a scale nearer to 1"));
        }
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
    fn finish(self, file: &str, wanted: Normals) -> Result<Mesh, Error> {
        let Self { positions, normals: given, mut triangles } = self;
        if positions.len().max(triangles.len()) > MAX_TRIANGLES {
            let what = format!("{file} has {} vertices and {} triangles", positions.len(), triangles.len());
            return Err(Error::input(what, format!("a mesh has at most {MAX_TRIANGLES} of each")));
        }
        let all = triangles.len();
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
        Ok(Mesh { positions, normals, triangles, dropped })
    }
}

/// Appends the unit vectors of those of the `given` normals that corners name to `normals` and has the corners name them there; where
/// one has the length 0, the triangle's own takes its place.
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

/// For each place that vertices have the sum of the normals of the triangles there, each times its area, 0 where they cancel; and for
/// each vertex which of these it has.
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

/// Reads an OBJ text: its lines `v`, `vn` and `f`, all objects and groups as one mesh.
fn read_obj(text: &str, file: &str) -> Result<Raw, Error> {
    let (plain, every_normal) = plain_obj(text, file)?;
    let mut rest = plain.as_bytes();
    let options =
        tobj::LoadOptions { triangulate: true, ignore_points: true, ignore_lines: true, ..Default::default() };
    let loaded = tobj::load_obj_buf(&mut rest, &options, |_| Err(tobj::LoadError::MaterialParseError));
    let (models, _) = loaded.map_err(|error| {
        // The parser stops behind the line that it refuses.
        let read = &plain.as_bytes()[..plain.len() - rest.len()];
        let line = read.iter().filter(|byte| **byte == b'\n').count().max(1);
        Error::input(format!("{file}, line {line}: {error}"), FORMATS)
    })?;
    let (mut positions, mut normals, mut triangles) = (Vec::new(), Vec::new(), Vec::new());
    let vectors = |list: &[f64]| list.chunks_exact(3).map(|v| [v[0], v[1], v[2]]).collect::<Vec<Vector>>();
    for tobj::Model { mesh, .. } in models {
        let (position, normal) = (positions.len() as u32, normals.len() as u32);
        positions.extend(vectors(&mesh.positions));
        if every_normal {
            normals.extend(vectors(&mesh.normals));
        }
        triangles.extend((0..mesh.indices.len() / 3).map(|triangle| {
            [0, 1, 2].map(|corner| {
                let index = 3 * triangle + corner;
                let of_normal = if every_normal { mesh.normal_indices[index] } else { 0 };
                Corner { position: position + mesh.indices[index], normal: normal + of_normal }
            })
        }));
    }
    Ok(Raw { positions, normals, triangles })
}

/// The lines `v`, `vn` and `f` of an OBJ text, each in its place, once it is known that every coordinate is a number and every face's
/// vertices and normals are there; and whether every corner of a face has a normal. The parser itself would wrap a face's index
/// around, name no line, and lend a corner without a normal another one's.
fn plain_obj(text: &str, file: &str) -> Result<(String, bool), Error> {
    let first = |line: &str| {
        line.split_whitespace()
            .next()
            .map_or(0, |word| ["v", "vn"].iter().position(|w| *w == word).map_or(0, |at| at + 1))
    };
    let mut all = [0; 3];
    text.lines().for_each(|line| all[first(line)] += 1);
    let (mut read, mut faces, mut every_normal) = ([0u64; 3], 0, true);
    let mut plain = String::with_capacity(text.len());
    for (number, line) in text.lines().enumerate() {
        let line = line.split('#').next().unwrap_or_default();
        let wrong =
            |what: String, allowed: String| Err(Error::input(format!("{file}, line {}: {what}", number + 1), allowed));
        let mut words = line.split_whitespace();
        match words.next() {
            Some(word @ ("v" | "vn")) => {
                let kind = first(word);
                read[kind] += 1;
                let mut numbers = words.map_while(|word| word.parse::<f64>().ok()).collect::<Vec<_>>();
                if let (1, &[x, y, z, weight]) = (kind, &numbers[..]) {
                    numbers = vec![x / weight, y / weight, z / weight];
                }
                if let Some(value) = beyond(&numbers[..numbers.len().min(3)]) {
                    let (what, index) = (["vertex", "normal"][kind - 1], read[kind]);
                    return wrong(format!("the {what} {index} has the component {value}"), allowed_coordinate());
                }
            }
            Some("f") => {
                faces += 1;
                for corner in words {
                    let mut indices = corner.split('/').map(str::parse::<i64>);
                    let (vertex, normal) = (indices.next(), indices.nth(1));
                    every_normal &= matches!(normal, Some(Ok(_)));
                    for (kind, index) in [(1, vertex), (2, normal)] {
                        let Some(Ok(index)) = index else { continue };
                        let there = if index < 0 { read[kind] } else { all[kind] };
                        if index == 0 || index.unsigned_abs() > there {
                            let what = ["vertex", "normal"][kind - 1];
                            let allowed =
                                format!("the file has {} of them up to this line, {} in all", read[kind], all[kind]);
                            return wrong(format!("a face names the {what} {index}, which is not there"), allowed);
                        }
                    }
                }
            }
            _ => {
                plain.push('\n');
                continue;
            }
        }
        plain.push_str(line);
        plain.push('\n');
    }
    if read[1] == 0 && faces == 0 {
        return Err(Error::input(format!("{file} is neither OBJ nor PLY"), FORMATS));
    }
    Ok((plain, every_normal))
}

/// A vertex or a face of a PLY file: what is read of it.
struct Element {
    /// x, y, z, nx, ny, nz.
    components: [f64; 6],
    /// A face's vertices; one that no u32 holds is the greatest.
    corners: Vec<u32>,
}

/// The names of [`Element::components`].
const COMPONENTS: [&str; 6] = ["x", "y", "z", "nx", "ny", "nz"];
/// The two names that the list of a face's vertices goes by.
const CORNERS: [&str; 2] = ["vertex_indices", "vertex_index"];

impl PropertyAccess for Element {
    fn new() -> Self {
        Self { components: [f64::NAN; 6], corners: Vec::new() }
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        let Some(component) = COMPONENTS.iter().position(|component| *component == name) else {
            if !CORNERS.contains(&name) {
                return PropertyAccessResult::Ignored;
            }
            fn all<T: Copy + TryInto<u32>>(list: &[T]) -> Vec<u32> {
                list.iter().map(|index| (*index).try_into().unwrap_or(u32::MAX)).collect()
            }
            self.corners = match &property {
                Property::ListChar(list) => all(list),
                Property::ListUChar(list) => all(list),
                Property::ListShort(list) => all(list),
                Property::ListUShort(list) => all(list),
                Property::ListInt(list) => all(list),
                Property::ListUInt(list) => all(list),
                _ => return PropertyAccessResult::UnsupportedType,
            };
            return PropertyAccessResult::Set;
        };
        self.components[component] = match property {
            Property::Char(value) => value.into(),
            Property::UChar(value) => value.into(),
            Property::Short(value) => value.into(),
            Property::UShort(value) => value.into(),
            Property::Int(value) => value.into(),
            Property::UInt(value) => value.into(),
            Property::Float(value) => value.into(),
            Property::Double(value) => value,
            _ => return PropertyAccessResult::UnsupportedType,
        };
        PropertyAccessResult::Set
    }
}

/// Reads a PLY file: the elements `vertex` and `face`.
fn read_ply(bytes: &[u8], file: &str) -> Result<Raw, Error> {
    let refused = |error: ParseError| {
        let what = error.to_string().split_whitespace().collect::<Vec<_>>().join(" ");
        // What follows is its grammar's, and the line again.
        let what = what.split(" Error: Couldn't parse").next().unwrap_or_default();
        let what: String = what.chars().filter(|c| !c.is_control()).take(200).collect();
        Error::input(format!("{file}: {what}"), FORMATS)
    };
    let (parser, mut reader) = (Parser::<Element>::new(), Reader::new(bytes));
    let header = parser.read_header(&mut reader).map_err(refused)?;
    for (name, element) in &header.elements {
        // Any number of elements that take no bytes would be read from no bytes.
        if element.properties.is_empty() && element.count > 0 {
            return Err(Error::input(format!("{file}: the element {name} has no properties"), FORMATS));
        }
    }
    let has = |element: &str, property: &str| {
        header.elements.get(element).is_some_and(|element| element.properties.contains_key(property))
    };
    if let Some(missing) = COMPONENTS[..3].iter().find(|name| !has("vertex", name)) {
        return Err(Error::input(format!("{file}: its vertices have no {missing}"), FORMATS));
    }
    if !CORNERS.iter().any(|name| has("face", name)) {
        let what = format!("{file} has no faces");
        return Err(Error::input(what, "an element face with a list vertex_indices"));
    }
    let has_normals = COMPONENTS[3..].iter().all(|name| has("vertex", name));
    let mut payload = parser.read_payload(&mut reader, &header).map_err(refused)?;
    let mut elements = |name| payload.shift_remove(name).unwrap_or_default();
    let (vertices, faces): (Vec<Element>, Vec<Element>) = (elements("vertex"), elements("face"));
    let part = |from: usize| vertices.iter().map(|v| [0, 1, 2].map(|axis| v.components[from + axis])).collect();
    let (positions, normals): (Vec<Vector>, Vec<Vector>) = (part(0), if has_normals { part(3) } else { Vec::new() });
    for (what, vectors) in [("", &positions), ("normal's ", &normals)] {
        for (vertex, vector) in vectors.iter().enumerate() {
            if let Some(value) = beyond(vector) {
                let what = format!("{file}: the vertex {vertex}, counted from 0, has the {what}component {value}");
                return Err(Error::input(what, allowed_coordinate()));
            }
        }
    }
    let mut triangles = Vec::with_capacity(faces.len());
    for (face, Element { corners, .. }) in faces.iter().enumerate() {
        if let Some(vertex) = corners.iter().find(|vertex| **vertex as usize >= positions.len()) {
            let vertex = if *vertex == u32::MAX { "a vertex".to_owned() } else { format!("the vertex {vertex}") };
            return Err(Error::input(
                format!("{file}: the face {face}, counted from 0, names {vertex}, which is not there"),
                format!("the file has {} vertices, the first of them 0", positions.len()),
            ));
        }
        let corner = |index: usize| Corner { position: corners[index], normal: corners[index] };
        triangles.extend((2..corners.len()).map(|last| [corner(0), corner(last - 1), corner(last)]));
    }
    Ok(Raw { positions, normals, triangles })
}

fn allowed_coordinate() -> String {
    format!("a number of at most {MAX_COORDINATE:e} either side of 0")
}
