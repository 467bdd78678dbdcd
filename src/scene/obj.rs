//! OBJ files.

use std::fmt::Write;

use super::file::beyond;
use super::mesh::{Corner, FORMATS, Named, Raw, allowed_coordinate};
use super::text::{Statements, name_of, without_comment};
use crate::core::sample::Vector;
use crate::platform::error::{Error, refuse};

/// Reads an OBJ text: its statements `v`, `vn` and `f`, all objects and groups as one mesh.
pub(super) fn read_obj(text: &str, file: &str) -> Result<Raw, Error> {
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
    /// Vertices, then normals, then faces with indices from 1; an object for each run of faces of one material, named
    /// as its place.
    text: String,
    /// For each line of the text that of the file, from 1.
    lines: Vec<usize>,
    /// Whether every corner of a face has a normal.
    every_normal: bool,
    libraries: Vec<Named>,
    materials: Vec<Named>,
}

/// The statements of an OBJ text that matter here, once it is known that every coordinate is a number and every face's
/// vertices and normals are there. The parser itself would wrap a face's index around, name no line, lend a corner
/// without a normal another one's, pass over a first line that begins with a byte order mark, and knows no continued
/// lines.
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
        let wrong = |what: String, allowed: String| Error::input(format!("{file}, line {number}: {what}"), allowed);
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
                    return Err(wrong(format!("the {what} {index} has the component {value}"), allowed_coordinate()));
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
                    plain_corner(corner, (&read, &all), &mut every_normal, &mut faces)
                        .map_err(|(what, allowed)| wrong(what, allowed))?;
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
    refuse!(read[0] == 0 && count == 0, format!("{file} is neither OBJ nor PLY"), FORMATS);
    vectors.push_str(&faces);
    lines.append(&mut face_lines);
    Ok(PlainObj { text: vectors, lines, every_normal, libraries, materials })
}

/// Appends a face's corner with indices from 1 to `faces`. `read` are the vertices and the normals up to this line,
/// `all` those of the file. What is wrong with it, and what is allowed.
fn plain_corner(
    corner: &str,
    (read, all): (&[u64; 2], &[u64; 2]),
    every_normal: &mut bool,
    faces: &mut String,
) -> Result<(), (String, String)> {
    let mut indices = corner.split('/').map(str::parse::<i64>);
    let (vertex, normal) = (indices.next(), indices.nth(1));
    *every_normal &= matches!(normal, Some(Ok(_)));
    let mut places = [None; 2];
    for (kind, index) in [vertex, normal].into_iter().enumerate() {
        let Some(Ok(index)) = index else { continue };
        let there = if index < 0 { read[kind] } else { all[kind] };
        if index == 0 || index.unsigned_abs() > there {
            let what = ["vertex", "normal"][kind];
            let allowed = format!("the file has {} of them up to this line, {} in all", read[kind], all[kind]);
            return Err((format!("a face names the {what} {index}, which is not there"), allowed));
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
    Ok(())
}
