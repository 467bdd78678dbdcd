//! The materials of OBJ files: MTL.
//!
//! Of a material `Ns` is the shininess, `Ka`, `Kd` and `Ks` are what it gives back of ambient light, of a light
//! scattered, and of a light mirrored. Everything else is left out, and named.

use std::collections::BTreeMap;
use std::path::Path;

use super::mesh::{Mesh, Named, Painted};
use super::text::{Statements, name_of, without_comment, without_mark};
use crate::platform::error::{Error, refuse};
use crate::platform::input;
use crate::spec::{Colour, Material, suggest};

/// The greatest shininess that MTL has.
const MAX_NS: f64 = 1000.0;
/// What scatters a material that does not say it: MTL's default.
const SCATTERED: Colour = [0.8; 3];
/// What is read.
const FORMAT: &str = "an MTL file has newmtl NAME, and below it Ns, Ka, Kd and Ks";

/// A material of an MTL file, its numbers not yet checked against what a lobe may have.
#[derive(Clone, Debug, Default)]
struct Read {
    name: String,
    /// The line of its `newmtl`.
    line: usize,
    ns: Option<(f64, usize)>,
    /// `Ka`, `Kd` and `Ks`.
    colours: [Option<Colour>; 3],
    /// The keywords that are left out, each with its line.
    left_out: Vec<(String, usize)>,
}

/// An MTL file: its name as the OBJ file writes it, and its path for messages.
struct Library {
    name: String,
    file: String,
    materials: Vec<Read>,
}

/// The parts of a mesh, one for each of its file's materials that a triangle has.
pub(super) struct Parts {
    /// Each part with its material; none for triangles without one in the file.
    pub parts: Vec<(Mesh, Option<Material>)>,
    /// What of the materials is left out, a line for each MTL file.
    pub left_out: Vec<String>,
}

/// Divides a mesh by the materials of its file. `file` is the OBJ file's name for messages, `directory` where it lies.
/// Errors: a file without `mtllib`, an MTL file that is not there or cannot be read, a material that is in none of
/// them, a number that is none or out of its range.
pub(super) fn parts(painted: &Painted, file: &str, directory: &Path) -> Result<Parts, Error> {
    let Painted { mesh, libraries, materials, of_triangle } = painted;
    let used = |place: usize| of_triangle.iter().any(|material| *material as usize == place);
    if materials.is_empty() || libraries.is_empty() {
        let missing = if libraries.is_empty() { "mtllib" } else { "usemtl" };
        return Err(Error::input(
            format!("{file} has no {missing}, and materials = \"mtl\" asks for the materials of its MTL file"),
            "an OBJ file names its MTL file with mtllib and each face's material with usemtl; without the key every \
             face has the object's material",
        ));
    }
    let mut read: Vec<Library> = Vec::new();
    for library in libraries {
        for name in library_names(library, directory) {
            if read.iter().all(|known| known.name != name) {
                read.push(Library::read(&name, file, library.line, directory)?);
            }
        }
    }
    let mut parts = Vec::new();
    let mut left_out: Vec<BTreeMap<&str, Vec<usize>>> = vec![BTreeMap::new(); read.len()];
    for (place, named) in materials.iter().enumerate().filter(|(place, _)| used(*place)) {
        let (number, material) = find(&read, named).ok_or_else(|| {
            let known = read.iter().flat_map(|library| &library.materials).map(|material| material.name.as_str());
            let files = read.iter().map(|library| library.name.as_str()).collect::<Vec<_>>().join(", ");
            Error::input(
                format!("{file}, line {}: the material `{}` is not in {files}", named.line, named.name),
                suggest("materials", &named.name, known),
            )
        })?;
        for (keyword, line) in &material.left_out {
            left_out[number].entry(keyword).or_default().push(*line);
        }
        let part = mesh.part(|triangle| of_triangle[triangle] as usize == place);
        parts.push((part, Some(material.resolve(&read[number].file)?)));
    }
    let bare = |triangle: usize| of_triangle[triangle] as usize >= materials.len();
    if (0..of_triangle.len()).any(bare) {
        parts.push((mesh.part(bare), None));
    }
    if let Some((first, _)) = parts.first_mut() {
        first.dropped = mesh.dropped;
    }
    let line = |(library, keywords): (&Library, &BTreeMap<&str, Vec<usize>>)| {
        let each = |(keyword, lines): (&&str, &Vec<usize>)| {
            let mut lines = lines.clone();
            lines.sort_unstable();
            lines.dedup();
            let numbers = lines.iter().map(usize::to_string).collect::<Vec<_>>().join(", ");
            format!("{keyword} (line{} {numbers})", if lines.len() == 1 { "" } else { "s" })
        };
        let keywords = keywords.iter().map(each).collect::<Vec<_>>();
        (!keywords.is_empty()).then(|| format!("{}: left out {}", library.name, keywords.join(", ")))
    };
    let left_out = read.iter().zip(&left_out).filter_map(line).collect();
    Ok(Parts { parts, left_out })
}

/// The files of a statement `mtllib`: one, if there is a file of the whole name, otherwise one a word.
fn library_names(library: &Named, directory: &Path) -> Vec<String> {
    let whole = without_comment(&library.name).trim();
    let given = if path(&library.name, directory).is_file() { library.name.as_str() } else { whole };
    let words = || given.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
    if given.is_empty() || path(given, directory).is_file() || words().len() < 2 {
        return vec![given.to_owned()];
    }
    // A name with blanks that is not there is named whole.
    if words().iter().all(|word| word.to_ascii_lowercase().ends_with(".mtl")) {
        words()
    } else {
        vec![given.to_owned()]
    }
}

/// Where an MTL file lies. Programs on Windows write `\` between directories.
fn path(name: &str, directory: &Path) -> std::path::PathBuf {
    let own = directory.join(name);
    if own.is_file() { own } else { directory.join(name.replace('\\', "/")) }
}

/// The material of a statement `usemtl`, with the number of its library: by the whole name, then without what may be a
/// comment. Of two with one name the first is meant.
fn find<'a>(libraries: &'a [Library], named: &Named) -> Option<(usize, &'a Read)> {
    let all = || {
        let of = |(number, library): (usize, &'a Library)| library.materials.iter().map(move |one| (number, one));
        libraries.iter().enumerate().flat_map(of)
    };
    let plain = |name: &str| without_comment(name).trim().to_owned();
    let own = plain(&named.name);
    all()
        .find(|(_, material)| material.name == named.name)
        .or_else(|| all().find(|(_, material)| !own.is_empty() && plain(&material.name) == own))
}

impl Library {
    fn read(name: &str, obj: &str, line: usize, directory: &Path) -> Result<Self, Error> {
        refuse!(name.is_empty(), format!("{obj}, line {line}: mtllib names no file"), FORMAT);
        let path = path(name, directory);
        refuse!(
            !path.is_file(),
            format!("{obj}, line {line}: there is no file {}", path.display()),
            "the MTL file of mtllib lies where its path leads from the OBJ file's directory"
        );
        let file = path.display().to_string();
        let materials = read(&input::read(&path, input::MAX_TEXT)?, &file)?;
        Ok(Self { name: name.to_owned(), file, materials })
    }
}

/// Reads an MTL text.
fn read(bytes: &[u8], file: &str) -> Result<Vec<Read>, Error> {
    let text = String::from_utf8_lossy(without_mark(bytes, file, FORMAT)?);
    let mut all: Vec<Read> = Vec::new();
    for (line, statement) in Statements::new(&text) {
        let plain = without_comment(&statement);
        let mut words = plain.split_whitespace();
        let Some(keyword) = words.next() else { continue };
        let wrong = |what: String, allowed: &str| Error::input(format!("{file}, line {line}: {what}"), allowed);
        if keyword == "newmtl" {
            let name = name_of(&statement).to_owned();
            if name.is_empty() {
                return Err(wrong("newmtl names no material".to_owned(), FORMAT));
            }
            all.push(Read { name, line, ..Read::default() });
            continue;
        }
        let Some(material) = all.last_mut() else {
            return Err(wrong(format!("`{keyword}` stands before the first newmtl"), FORMAT));
        };
        let number = |word: &str| match word.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(number),
            _ => Err(wrong(format!("{keyword}: `{word}` is not a number"), "a real number")),
        };
        match ["Ka", "Kd", "Ks"].iter().position(|own| *own == keyword) {
            Some(place) => {
                const ALLOWED: &str =
                    "one number from 0 to 1, or three: red, green, blue; spectra and xyz are not read";
                let words: Vec<&str> = words.collect();
                let colour = match words[..] {
                    [one] => [number(one)?; 3],
                    [red, green, blue] => [number(red)?, number(green)?, number(blue)?],
                    _ => return Err(wrong(format!("{keyword} has {} values", words.len()), ALLOWED)),
                };
                if let Some(channel) = colour.iter().find(|channel| !(0.0..=1.0).contains(*channel)) {
                    return Err(wrong(format!("{keyword} = {channel} is out of range"), ALLOWED));
                }
                material.colours[place] = Some(colour);
            }
            None if keyword == "Ns" => match (words.next(), words.next()) {
                (Some(word), None) => material.ns = Some((number(word)?, line)),
                _ => return Err(wrong("Ns has not one value".to_owned(), "the shininess, one number")),
            },
            None => {
                let keyword: String = keyword.chars().filter(|c| !c.is_control()).take(40).collect();
                material.left_out.push((keyword, line));
            }
        }
    }
    Ok(all)
}

impl Read {
    /// The material for a scene; `file` is its MTL file, for messages.
    fn resolve(&self, file: &str) -> Result<Material, Error> {
        let Self { name, line, ns, colours: [ambient, scattered, mirrored], .. } = self;
        let of = |colour: &Option<Colour>| colour.unwrap_or_default();
        let (ka, kd, ks) = (of(ambient), scattered.unwrap_or(SCATTERED), of(mirrored));
        let allowed = 1.0..=MAX_NS;
        let shininess = match *ns {
            Some((ns, _)) if allowed.contains(&ns) => ns,
            // Without a highlight it does not matter.
            _ if ks == [0.0; 3] => 1.0,
            Some((ns, line)) => {
                return Err(Error::input(
                    format!("{file}, line {line}: the material `{name}` has Ns = {ns} and a highlight (Ks is not 0)"),
                    format!("Ns is the shininess, 1 to {MAX_NS}; or Ks 0 0 0 for no highlight"),
                ));
            }
            None => {
                return Err(Error::input(
                    format!("{file}, line {line}: the material `{name}` has a highlight (Ks is not 0) and no Ns"),
                    format!("Ns is the shininess, 1 to {MAX_NS}; or Ks 0 0 0 for no highlight"),
                ));
            }
        };
        // Names go into HDL, which is ASCII.
        let plain = |c: char| if c.is_ascii() && !c.is_ascii_control() { c } else { '_' };
        Ok(Material {
            name: name.chars().map(plain).collect(),
            shininess,
            ambient: Some(1.0),
            diffuse: Some(1.0),
            specular: Some(1.0),
            colour: Some(kd),
            ambient_colour: (ka != kd).then_some(ka),
            specular_colour: Some(ks),
        })
    }
}

/// The place of a material in a scene's list, to which it is added unless it is there; a name that another material has
/// gets a number.
pub(super) fn place(material: Material, all: &mut Vec<Material>) -> usize {
    let name = material.name.clone();
    let mut material = material;
    for number in 2.. {
        match all.iter().position(|known| known.name == material.name) {
            Some(place) if all[place] == material => return place,
            Some(_) => material.name = format!("{name} {number}"),
            None => break,
        }
    }
    all.push(material);
    all.len() - 1
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refused(text: &str) -> String {
        let read = read(text.as_bytes(), "a.mtl").and_then(|all| all.iter().map(|one| one.resolve("a.mtl")).collect());
        let error: Result<Vec<Material>, Error> = read;
        error.unwrap_err().to_string()
    }

    #[test]
    fn what_is_written_is_read_however_it_is_written() {
        let text =
            "# made\nnewmtl red # shiny\nNs 32.5\nKa 1 1 1\nKd 0.8 0.1 0.1\nKs 0.5\nd 1\nillum 2\nmap_Kd a b.png\n";
        let plain = read(text.as_bytes(), "a.mtl").unwrap();
        let [red] = &plain[..] else { panic!("{plain:?}") };
        let material = red.resolve("a.mtl").unwrap();
        let surface = material.surface();
        assert_eq!((material.shininess, surface.ambient, surface.diffuse), (32.5, [1.0; 3], [0.8, 0.1, 0.1]));
        assert_eq!(surface.specular, [0.5; 3]);
        let left = |keyword: &str, line| (keyword.to_owned(), line);
        assert_eq!(red.left_out, [left("d", 7), left("illum", 8), left("map_Kd", 9)]);
        let variants = [
            format!("\u{feff}{text}"),
            text.replace('\n', "\r\n"),
            text.replace('\n', "\r"),
            text.replace(' ', "\t"),
            text.replace("0.8 0.1", "0.8 \\\n0.1"),
        ];
        for variant in variants {
            let again = read(variant.as_bytes(), "a.mtl").unwrap()[0].resolve("a.mtl").unwrap();
            assert_eq!(again.surface(), surface, "{variant:?}");
        }
    }

    #[test]
    fn wrong_numbers_are_named_with_their_line() {
        let of = |rest: &str| refused(&format!("newmtl m\nKs 1 1 1\n{rest}"));
        assert!(of("Ns 0").starts_with("a.mtl, line 3: the material `m` has Ns = 0 "));
        assert!(of("Ns 0.5").contains("Ns = 0.5") && of("Ns 1001").contains("Ns = 1001") && of("Ns -1").contains("-1"));
        assert!(of("").contains("line 1") && of("").contains("no Ns"));
        assert!(of("Ns high").contains("line 3: Ns: `high` is not a number"));
        assert!(of("Ns 1 2").contains("Ns has not one value"));
        assert!(of("Ns 9\nKd 1 1").contains("line 4: Kd has 2 values"));
        assert!(of("Ns 9\nKd 1.5 0 0").contains("line 4: Kd = 1.5 is out of range"));
        assert!(of("Ns 9\nKa nan 0 0").contains("`nan` is not a number"));
        assert!(refused("Ns 9").contains("line 1: `Ns` stands before the first newmtl"));
        assert!(refused("newmtl").contains("newmtl names no material"));
        // Without a highlight any shininess will do.
        assert_eq!(read(b"newmtl m\nNs 0\nKs 0 0 0", "a").unwrap()[0].resolve("a").unwrap().shininess, 1.0);
    }
}
