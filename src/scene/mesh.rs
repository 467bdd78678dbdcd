//! Triangle meshes, from OBJ and PLY.

use std::borrow::Cow;
use std::collections::HashMap;
use std::fmt::Write;
use std::path::Path;

use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{Property, PropertyAccess, PropertyAccessResult};
use serde::Deserialize;

use super::file::{MAX_COORDINATE, beyond};
use super::text::{Statements, first_line, name_of, without_comment, without_mark};
use crate::core::sample::{Vector, cross, dot, minus, normalised};
use crate::platform::error::Error;
use crate::platform::input;

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
struct Raw {
    positions: Vec<Vector>,
    /// Not yet of length 1; empty where the file has none, or not one for every corner.
    normals: Vec<Vector>,
    triangles: Vec<[Corner; 3]>,
    /// As in [`Painted`].
    libraries: Vec<Named>,
    materials: Vec<Named>,
    of_triangle: Vec<u32>,
}

impl Mesh {
    /// Reads an OBJ or a PLY file; which one it is, its text says. A byte order mark, any line ends and, in OBJ, lines continued by `\` are
    /// read as they are meant.
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

    /// The part of the mesh whose triangles are `wanted`, with those positions and normals alone that it needs; no triangle was dropped
    /// from it.
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

/// Reads an OBJ text: its statements `v`, `vn` and `f`, all objects and groups as one mesh.
fn read_obj(text: &str, file: &str) -> Result<Raw, Error> {
    let PlainObj { text: plain, lines, every_normal, libraries, materials } = plain_obj(text, file)?;
    let mut rest = plain.as_bytes();
    let options =
        tobj::LoadOptions { triangulate: true, ignore_points: true, ignore_lines: true, ..Default::default() };
    let loaded = tobj::load_obj_buf(&mut rest, &options, |_| Err(tobj::LoadError::MaterialParseError));
    let (models, _) = loaded.map_err(|error| {
        // The parser stops behind the line that it refuses.
        let read = &plain.as_bytes()[..plain.len() - rest.len()];
        let line = read.iter().filter(|byte| **byte == b'\n').count().max(1);
        Error::input(format!("{file}, line {}: {error}", lines.get(line - 1).unwrap_or(&line)), FORMATS)
    })?;
    let (mut positions, mut normals, mut triangles, mut of_triangle) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let vectors = |list: &[f64]| list.chunks_exact(3).map(|v| [v[0], v[1], v[2]]).collect::<Vec<Vector>>();
    for tobj::Model { mesh, name } in models {
        let (position, normal) = (positions.len() as u32, normals.len() as u32);
        positions.extend(vectors(&mesh.positions));
        if every_normal {
            normals.extend(vectors(&mesh.normals));
        }
        let count = mesh.indices.len() / 3;
        triangles.extend((0..count).map(|triangle| {
            [0, 1, 2].map(|corner| {
                let index = 3 * triangle + corner;
                let of_normal = if every_normal { mesh.normal_indices[index] } else { 0 };
                Corner { position: position + mesh.indices[index], normal: normal + of_normal }
            })
        }));
        let material = name.parse().unwrap_or(materials.len() as u32);
        of_triangle.extend(std::iter::repeat_n(material, count));
    }
    Ok(Raw { positions, normals, triangles, libraries, materials, of_triangle })
}

/// An OBJ text as the parser is given it.
struct PlainObj {
    /// Vertices, then normals, then faces with indices from 1; an object for each run of faces of one material, named as its place.
    text: String,
    /// For each line of the text that of the file, from 1.
    lines: Vec<usize>,
    /// Whether every corner of a face has a normal.
    every_normal: bool,
    libraries: Vec<Named>,
    materials: Vec<Named>,
}

/// The statements of an OBJ text that matter here, once it is known that every coordinate is a number and every face's vertices and normals
/// are there. The parser itself would wrap a face's index around, name no line, lend a corner without a normal another one's, pass over a
/// first line that begins with a byte order mark, and knows no continued lines.
fn plain_obj(text: &str, file: &str) -> Result<PlainObj, Error> {
    const KINDS: [&str; 2] = ["v", "vn"];
    let kind = |word: &str| KINDS.iter().position(|w| *w == word);
    let mut all = [0u64; 2];
    for (_, statement) in Statements::new(text) {
        if let Some(kind) = without_comment(&statement).split_whitespace().next().and_then(kind) {
            all[kind] += 1;
        }
    }
    let (mut read, mut every_normal) = ([0u64; 2], true);
    let (mut libraries, mut materials) = (Vec::new(), Vec::<Named>::new());
    let (mut vectors, mut faces) = (String::with_capacity(text.len()), String::new());
    let (mut lines, mut face_lines, mut count) = (Vec::new(), Vec::new(), 0);
    for (number, statement) in Statements::new(text) {
        let wrong =
            |what: String, allowed: String| Err(Error::input(format!("{file}, line {number}: {what}"), allowed));
        let mut words = without_comment(&statement).split_whitespace();
        match words.next() {
            Some(word @ ("v" | "vn")) => {
                let kind = kind(word).expect("one of the two");
                read[kind] += 1;
                let words: Vec<&str> = words.collect();
                let mut numbers = words.iter().map_while(|word| word.parse::<f64>().ok()).collect::<Vec<_>>();
                if let (0, &[x, y, z, weight]) = (kind, &numbers[..]) {
                    numbers = vec![x / weight, y / weight, z / weight];
                }
                if let Some(value) = beyond(&numbers[..numbers.len().min(3)]) {
                    let (what, index) = (["vertex", "normal"][kind], read[kind]);
                    return wrong(format!("the {what} {index} has the component {value}"), allowed_coordinate());
                }
                // More than a weight are colours, of which programs write three or four.
                let own = &words[..if words.len() > 4 || kind == 1 { words.len().min(3) } else { words.len() }];
                writeln!(vectors, "{word} {}", own.join(" ")).expect("a string takes it");
                lines.push(number);
            }
            Some("f") => {
                count += 1;
                faces.push('f');
                for corner in words {
                    let mut indices = corner.split('/').map(str::parse::<i64>);
                    let (vertex, normal) = (indices.next(), indices.nth(1));
                    every_normal &= matches!(normal, Some(Ok(_)));
                    let mut places = [None; 2];
                    for (kind, index) in [vertex, normal].into_iter().enumerate() {
                        let Some(Ok(index)) = index else { continue };
                        let there = if index < 0 { read[kind] } else { all[kind] };
                        if index == 0 || index.unsigned_abs() > there {
                            let what = ["vertex", "normal"][kind];
                            let allowed =
                                format!("the file has {} of them up to this line, {} in all", read[kind], all[kind]);
                            return wrong(format!("a face names the {what} {index}, which is not there"), allowed);
                        }
                        // From the end of those before it.
                        places[kind] = Some(if index < 0 { read[kind] as i64 + 1 + index } else { index });
                    }
                    let plain = |part: &str| part.is_empty() || part.parse::<i64>().is_ok();
                    match places {
                        // What is no corner is left to the parser to refuse.
                        _ if !corner.split('/').all(plain) || corner.split('/').count() > 3 => {
                            write!(faces, " {corner}")
                        }
                        [Some(vertex), Some(normal)] => write!(faces, " {vertex}//{normal}"),
                        [Some(vertex), None] => write!(faces, " {vertex}"),
                        [None, _] => write!(faces, " {corner}"),
                    }
                    .expect("a string takes it");
                }
                faces.push('\n');
                face_lines.push(number);
            }
            Some("mtllib") => libraries.push(Named { name: name_of(&statement).to_owned(), line: number }),
            Some("usemtl") => {
                let name = name_of(&statement);
                let place = materials.iter().position(|known| known.name == name).unwrap_or_else(|| {
                    materials.push(Named { name: name.to_owned(), line: number });
                    materials.len() - 1
                });
                writeln!(faces, "o {place}").expect("a string takes it");
                face_lines.push(number);
            }
            _ => {}
        }
    }
    if read[0] == 0 && count == 0 {
        return Err(Error::input(format!("{file} is neither OBJ nor PLY"), FORMATS));
    }
    vectors.push_str(&faces);
    lines.append(&mut face_lines);
    Ok(PlainObj { text: vectors, lines, every_normal, libraries, materials })
}

/// A PLY file with the line ends and the single blanks that its parser knows: of the whole file if it is text, otherwise of its header.
fn plain_ply(bytes: &[u8]) -> Cow<'_, [u8]> {
    let (mut plain, mut rest, mut text, mut body) = (Vec::new(), bytes, true, false);
    // Where a header's lines end with CR alone, a line feed behind it is the first byte of the body.
    let old =
        bytes.get(first_line(bytes).0.len()..).is_some_and(|end| end.starts_with(b"\r") && !end.starts_with(b"\r\n"));
    while !rest.is_empty() && (text || !body) {
        let (line, after) = first_line(rest);
        let end = rest.len() - after.len();
        let words: Vec<&[u8]> = line.split(|byte| byte.is_ascii_whitespace()).filter(|word| !word.is_empty()).collect();
        text &= body || words.first() != Some(&&b"format"[..]) || words.get(1) == Some(&&b"ascii"[..]);
        let last = !body && words == [b"end_header"];
        body |= last;
        if !words.is_empty() {
            plain.extend_from_slice(&words.join(&b' '));
            plain.push(b'\n');
        }
        let end = if last && old { (line.len() + 1).min(rest.len()) } else { end };
        rest = &rest[end..];
    }
    if plain.len() + rest.len() == bytes.len() && bytes.starts_with(&plain) {
        return Cow::Borrowed(bytes);
    }
    plain.extend_from_slice(rest);
    Cow::Owned(plain)
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
    Ok(Raw { positions, normals, triangles, ..Raw::default() })
}

fn allowed_coordinate() -> String {
    format!("a number of at most {MAX_COORDINATE:e} either side of 0")
}
