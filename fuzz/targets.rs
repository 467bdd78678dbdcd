//! What is fuzzed: each reader of files with the properties that must hold of it whatever the bytes are, and `generate`
//! itself, from a spec to the files of its core. The fuzzer and `tests/it/parsers.rs` share this file.
//!
//! A property that fails is a panic. Memory and time are watched from outside.

use std::path::Path;
use std::sync::OnceLock;

use brdfgen::core::Direction;
use brdfgen::core::sample::random_codes;
use brdfgen::core::{Account, Design, Part, ShaderError};
use brdfgen::emit::package;
use brdfgen::emit::rom::{self, RomFormat};
use brdfgen::explore::{Results, Sweep};
use brdfgen::fixed::Rng;
use brdfgen::papers::Recorded;
use brdfgen::platform::error::Error;
use brdfgen::reflectance::{directory, images, merl, source};
use brdfgen::report::Speed;
use brdfgen::scene::Scene;
use brdfgen::scene::mesh::{Mesh, Normals};
use brdfgen::spec::{CoreSpec, LobeSpec, SpecFields};
use brdfgen::synth;
use brdfgen::target::pack;
use brdfgen::verify::cosim::{self, Job, Sim};
use brdfgen::verify::golden;

/// A reader, or `generate`: its name, which is that of its corpus, and what is done with some bytes.
pub type Target = (&'static str, fn(&[u8]));

/// All of them.
pub const TARGETS: [Target; 11] = [
    ("spec", spec),
    ("generate", generate),
    ("golden", golden_vectors),
    ("rom", rom_file),
    ("scene", scene),
    ("mesh", mesh),
    ("netlist", netlist),
    ("sweep", sweep),
    ("results", results),
    ("tables", tables),
    ("reflectance", reflectance),
];

/// An error points inside the text that it shows, at whole characters.
fn checked<T>(result: Result<T, Error>) -> Option<T> {
    match result {
        Ok(value) => Some(value),
        Err(Error::Text { text, at, .. }) => {
            let (from, to) = (at.offset(), at.offset() + at.len());
            let text = text.inner();
            assert!(to <= text.len(), "{from}..{to} is not in the {} bytes of the text", text.len());
            assert!(text.is_char_boundary(from) && text.is_char_boundary(to), "{from}..{to} cuts a character");
            None
        }
        Err(_) => None,
    }
}

/// A spec is the same after it was written and read, as given and with its defaults.
fn spec(bytes: &[u8]) {
    let Ok(text) = str::from_utf8(bytes) else { return };
    let Some(fields) = checked(SpecFields::parse(text, "spec.toml")) else { return };
    let again = SpecFields::parse(&fields.to_toml(), "again").expect("what was written can be read");
    // Not with `==`: a value may be no number.
    assert_eq!(again.to_toml(), fields.to_toml());
    let Some(spec) = checked(fields.resolve()) else { return };
    let again = SpecFields::parse(&spec.to_toml(), "again").and_then(SpecFields::resolve);
    assert_eq!(again.expect("a whole spec is a spec"), spec);
}

/// Whether a core is made in no time: few inputs, small tables, and few stages of few operations.
fn is_small(spec: &CoreSpec) -> bool {
    let LobeSpec { method, interface } = spec.block.lobe();
    let inputs = interface.shininess.index_bits() + interface.input_fraction;
    let options = method.options();
    let entries = [options.table_bits, options.log_bits, options.exp_bits];
    let lights = spec.block.shader().map_or(0, |shader| shader.lights);
    inputs <= 13
        && interface.shininess.rows() <= 300
        && entries.into_iter().flatten().all(|bits| bits <= 9)
        && lights <= 2
        && options.accuracy.is_none_or(|bits| bits <= 9)
}

/// A small core is made, or refused in words: model and datapath compute the same for every input, and what is measured
/// of it is within what is proved. Of a shader a few inputs are compared, and nothing is measured.
fn generate(bytes: &[u8]) {
    let Ok(text) = str::from_utf8(bytes) else { return };
    let Some(spec) = checked(SpecFields::parse(text, "spec.toml").and_then(SpecFields::resolve)) else { return };
    if !is_small(&spec) {
        return;
    }
    let design = match Design::new(spec) {
        Ok(design) => design,
        Err(Error::Input { .. }) => return,
        Err(error) => panic!("a core is made or refused: {error:?}"),
    };
    let (graph, tables) = (design.graph(), design.tables());
    let agree = |inputs: &[i64]| {
        let values = graph.values(tables, &inputs.iter().copied().map(i128::from).collect::<Vec<_>>());
        let outputs: Vec<i64> = graph.outputs.iter().map(|&(_, id)| values[id] as i64).collect();
        assert_eq!(design.evaluate(inputs), outputs, "model and datapath at {inputs:?}");
    };
    let (account, golden) = if design.spec.block.shader().is_some() {
        let ports = design.numbers(Direction::In);
        let mut rng = Rng::new(0);
        (0..64).for_each(|_| agree(&random_codes(&ports, &mut rng)));
        let none = |name| Part { name, meaning: "", codes: [0.0; 2], rms: 0.0 };
        let account = Account::Shader(ShaderError { samples: 1, parts: vec![none("part")], whole: none("whole") });
        let (core, spec_digest) = (design.spec.name.clone(), design.spec.digest());
        (account, golden::Golden { core, spec_digest, groups: Vec::new(), digests: Vec::new() })
    } else {
        let (first, count) = golden::all_codes(design.lobe().operand_format());
        for index in 0..1i64 << design.lobe().index_format().width() {
            (first..first + count as i64).for_each(|operand| agree(&[index, operand]));
        }
        let account = Account::of(&design);
        if let Account::Lobe { measured, .. } = &account {
            let ([low, high], [least, most]) = (design.lobe().budget.proved_ulps, measured.ulps);
            assert!(low - 1e-6 <= least && most <= high + 1e-6, "measured {least}..{most}, proved {low}..{high}");
        }
        (account, golden::Golden::of(&design))
    };
    let files = package::files(&design, &account, &golden).expect("the files of a core");
    assert!(files.iter().all(|file| !file.path.is_empty()) && files.len() > 4);
    let job = Job { design: &design, golden: &golden, directory: Path::new("") };
    let outcome = cosim::golden(Sim::Builtin, &job).expect("a simulation in this process");
    assert!(outcome.mismatches == 0 && outcome.vectors == outcome.expected_vectors, "{outcome:?}");
}

/// Two cores: one with a signed operand, one with several outputs.
fn designs() -> &'static [Design; 2] {
    static DESIGNS: OnceLock<[Design; 2]> = OnceLock::new();
    DESIGNS.get_or_init(|| {
        let small = "method = \"quadratic\"\nshininess = [5]\ninput_fraction = 4\noutput_fraction = 4\n";
        let shader = "block = \"shader\"\nmethod = \"quadratic\"\nmaterial = [{ name = \"a\", shininess = 9 }]\n";
        [small, shader].map(|text| {
            SpecFields::parse(text, "small").and_then(SpecFields::resolve).and_then(Design::new).expect("a core")
        })
    })
}

/// Vectors are the same after they were written and read; the first byte chooses the core, and whether its name is put
/// before them.
fn golden_vectors(bytes: &[u8]) {
    let Some((&first, rest)) = bytes.split_first() else { return };
    let Ok(text) = str::from_utf8(rest) else { return };
    let design = &designs()[usize::from(first & 1)];
    // No fuzzer guesses a digest.
    let head = format!("# core {}\n# spec {}\n", design.spec.name, design.spec.digest());
    let text = &if first & 2 == 0 { head + text } else { text.to_owned() };
    let Some(read) = checked(golden::parse(design, text, "file.vec")) else { return };
    let again = golden::parse(design, &read.to_text(design), "again").expect("what was written can be read");
    let plain = |golden: &golden::Golden| golden.vectors().into_iter().cloned().collect::<Vec<_>>();
    assert_eq!((plain(&again), &again.digests), (plain(&read), &read.digests));
}

/// The words of a file are no more than a ROM has and fit their width; written as plain words they are read again. The
/// first byte chooses the format, the second the width.
fn rom_file(bytes: &[u8]) {
    let [format, width, rest @ ..] = bytes else { return };
    let format = RomFormat::ALL[usize::from(*format) % RomFormat::ALL.len()];
    let width = u32::from(*width) % 150 + 1;
    let Some(image) = checked(rom::read(rest, format, "file", width)) else { return };
    assert!(!image.words.is_empty() && image.words.len() <= rom::MAX_DEPTH);
    assert!(image.words.iter().all(|word| word.bits() <= u64::from(width)));
    let digits = width.div_ceil(4) as usize;
    let text: String = image.words.iter().map(|word| format!("{word:0digits$x}\n")).collect();
    let again = rom::read(text.as_bytes(), RomFormat::Mem, "again", width).expect("plain words can be read");
    assert_eq!(again.words, image.words);
}

/// A scene is read or refused; its meshes are looked for where there are none.
fn scene(bytes: &[u8]) {
    let Ok(text) = str::from_utf8(bytes) else { return };
    // Anything that is there could be named, devices among it.
    if text.contains("/") || text.contains("..") {
        return;
    }
    let _ = Scene::is_scene(text);
    if let Some(scene) = checked(Scene::parse(text, "scene.toml", Path::new("/nonexistent"))) {
        assert!(scene.width > 0 && scene.height > 0 && !scene.materials.is_empty());
    }
}

/// The same mesh as other programs write it: with a byte order mark, with other line ends, and with lines that are
/// continued.
fn variants(bytes: &[u8]) -> Vec<Vec<u8>> {
    let mut all = vec![[b"\xef\xbb\xbf", bytes].concat()];
    let has = |part: &[u8]| bytes.windows(part.len()).any(|window| window == part);
    // The bytes of a binary file are no text.
    if !has(b"binary") {
        let mut ends = Vec::new();
        for (place, &byte) in bytes.iter().enumerate() {
            if byte == b'\n' && (place == 0 || bytes[place - 1] != b'\r') {
                ends.push(b'\r');
            }
            ends.push(byte);
        }
        all.push(ends);
    }
    // A comment and a name have an end of their own; a PLY file has no continued lines.
    if !has(b"#") && !has(b"\\") && !has(b"ply") && bytes.len() < 1 << 16 {
        all.push(bytes.iter().flat_map(|&byte| if byte == b' ' { b" \\\n".to_vec() } else { vec![byte] }).collect());
    }
    all
}

/// Every corner of a mesh is there, every number is one, and every normal has the length 1; written as plain OBJ it has
/// the same triangles. Neither a byte order mark nor line ends nor continued lines change it.
fn mesh(bytes: &[u8]) {
    if !bytes.starts_with(b"\xef\xbb\xbf")
        && let Some(mesh) = checked(Mesh::parse(bytes, "mesh", Normals::File))
    {
        for variant in variants(bytes) {
            let again = Mesh::parse(&variant, "variant", Normals::File).expect("another way to write it");
            assert_eq!(again, mesh, "{:?}", String::from_utf8_lossy(&variant));
        }
    }
    for normals in [Normals::File, Normals::Smooth, Normals::Flat] {
        let Some(mesh) = checked(Mesh::parse(bytes, "mesh", normals)) else { continue };
        let length = |v: &[f64; 3]| v.iter().map(|c| c * c).sum::<f64>().sqrt();
        assert!(mesh.positions.iter().flatten().all(|c| c.is_finite()));
        assert!(mesh.normals.iter().all(|n| (length(n) - 1.0).abs() < 1e-9), "{:?}", mesh.normals);
        for corner in mesh.triangles.iter().flatten() {
            assert!((corner.position as usize) < mesh.positions.len() && (corner.normal as usize) < mesh.normals.len());
        }
        let mut text = String::new();
        for [x, y, z] in &mesh.positions {
            text += &format!("v {x:?} {y:?} {z:?}\n");
        }
        for corners in &mesh.triangles {
            let [a, b, c] = corners.map(|corner| corner.position + 1);
            text += &format!("f {a} {b} {c}\n");
        }
        let again = Mesh::parse(text.as_bytes(), "again.obj", normals).expect("a plain mesh can be read");
        assert_eq!((again.triangles.len(), again.dropped), (mesh.triangles.len(), 0));
    }
}

/// Two JSON texts, with a zero byte between: a netlist, which is packed and counted, and a report of its placement.
fn netlist(bytes: &[u8]) {
    let mut parts = bytes.splitn(2, |byte| *byte == 0);
    let (netlist, report) = (parts.next().unwrap_or_default(), parts.next().unwrap_or_default());
    let mut value = checked(synth::parse_netlist(netlist)).unwrap_or_default();
    if checked(synth::count(&value, "top")).is_some() && checked(pack(&mut value, "top")).is_some() {
        checked(synth::count(&value, "top")).expect("a packed netlist has its cells");
    }
    if let Some(synth::Placed { clock: Some((mhz, _)) }) = checked(synth::parse_report(report, &value)) {
        assert!(mhz.is_finite() && mhz > 0.0);
    }
}

/// A sweep is read or refused, and has no more cores than a run may have.
fn sweep(bytes: &[u8]) {
    let Ok(text) = str::from_utf8(bytes) else { return };
    let Some(sweep) = checked(Sweep::parse(text, "sweep.toml")) else { return };
    // Each combination is resolved, which takes time: long lists are left to the count.
    if text.matches(',').count() < 12
        && let Some(plan) = checked(sweep.expand())
    {
        assert!(!plan.cores.is_empty() && plan.cores.len() + plan.repeated <= plan.combinations);
    }
}

/// Results are the same after they were written and read, in both forms.
fn results(bytes: &[u8]) {
    let Ok(text) = str::from_utf8(bytes) else { return };
    let json = checked(Results::from_json(text, "results.json"));
    let csv = checked(Results::from_csv(text, "results.csv"));
    for read in [json, csv].into_iter().flatten() {
        let again = Results::from_json(&read.to_json(), "again").expect("what was written can be read");
        assert_eq!(again, read);
        if !read.points().is_empty() {
            let again = Results::from_csv(&read.to_csv(), "again").expect("what was written can be read");
            assert_eq!(again.to_csv(), read.to_csv());
        }
    }
}

/// The tables of measured speeds and of claims' figures.
fn tables(bytes: &[u8]) {
    let Ok(text) = str::from_utf8(bytes) else { return };
    checked(Speed::from_csv(text, "speed.csv"));
    checked(Recorded::parse(text, "claims.csv"));
}

/// A small reflectance table, which is the same after it was written and read, an index of sphere images, or a picture;
/// the first byte chooses. A real table is larger than what is worth to be fuzzed, so that a small shape is allowed
/// beside those of files.
fn reflectance(bytes: &[u8]) {
    let Some((&first, rest)) = bytes.split_first() else { return };
    match first % 4 {
        0 => {
            let Some(table) = checked(merl::read_from(rest, "table.binary", &[[2, 3, 4], merl::SHAPES[0]])) else {
                return;
            };
            assert!(table.valid_count() > 0);
            assert!(table.cells().iter().flatten().all(|value| value.is_finite() && *value >= 0.0));
            let written = merl::bytes(&table);
            let again = merl::read_from(&written[..], "again", &[table.shape()]).expect("what was written can be read");
            assert_eq!((again.cells(), again.valid_count()), (table.cells(), table.valid_count()));
        }
        1 => {
            let Ok(text) = str::from_utf8(rest) else { return };
            checked(directory::parse(text, "images.toml"));
        }
        2 => {
            if let Some(form) = checked(source::matcap(rest, "matcap")) {
                assert!(form.texels.codes().iter().flatten().all(|value| value.is_finite() && *value >= 0.0));
            }
        }
        _ => {
            // No fuzzer guesses a check sum of a PNG file's parts: sizes and kinds of an OpenEXR header are within its
            // reach.
            if let Some((width, height, pixels)) = checked(images::read_exr(rest, "image.exr")) {
                assert_eq!(pixels.len(), width * height);
            }
            if let Some(pixels) = checked(images::read_png(rest, "image.png")) {
                assert_eq!(pixels.codes.len(), pixels.width * pixels.height);
            }
        }
    }
}
