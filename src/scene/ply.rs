//! PLY files, ascii or binary.

use std::borrow::Cow;

use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{Property, PropertyAccess, PropertyAccessResult};

use super::file::beyond;
use super::mesh::{Corner, FORMATS, Raw, allowed_coordinate};
use super::text::first_line;
use crate::core::sample::Vector;
use crate::platform::error::Error;

/// The names of [`Element::components`].
const COMPONENTS: [&str; 6] = ["x", "y", "z", "nx", "ny", "nz"];
/// The two names that the list of a face's vertices goes by.
const CORNERS: [&str; 2] = ["vertex_indices", "vertex_index"];

/// Reads a PLY file: the elements `vertex` and `face`.
pub(super) fn read_ply(bytes: &[u8], file: &str) -> Result<Raw, Error> {
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

/// A PLY file with the line ends and the single blanks that its parser knows: of the whole file if it is text,
/// otherwise of its header.
pub(super) fn plain_ply(bytes: &[u8]) -> Cow<'_, [u8]> {
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
