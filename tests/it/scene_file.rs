//! Scene files and meshes: what is read, and what is refused with which words.

use std::fmt::Write;
use std::path::Path;
use std::time::{Duration, Instant};

use brdfgen::explore::Objective;
use brdfgen::platform::error::Error;
use brdfgen::scene::mesh::{Mesh, Normals, Transform};
use brdfgen::scene::{Exact, Frame, Highlights, LightKind, Scene, Shape};
use brdfgen::spec::{MethodName, SpecFields};
use brdfgen::target::Family;
use proptest::prelude::*;

fn scenes() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/scenes"))
}

fn parse(text: &str) -> Result<Scene, Error> {
    Scene::parse(text, "some scene.toml", scenes())
}

fn message(error: Error) -> String {
    match error {
        Error::Input { what, allowed } | Error::Text { what, allowed, .. } => format!("{what} | {allowed}"),
        other => other.to_string(),
    }
}

/// Top-level keys, the camera's, the material's, the light's and the object's keys, and what stands at the end.
fn scene(top: &str, camera: &str, material: &str, light: &str, object: &str, end: &str) -> String {
    format!("{top}\n[camera]\n{camera}\n[[material]]\n{material}\n[[light]]\n{light}\n[[object]]\n{object}\n{end}\n")
}

const CAMERA: &str = "position = [0, 0, 5]";
const MATERIAL: &str = "name = \"clay\"\nshininess = 8";
const LIGHT: &str = "direction = [0, 0, 1]";
const SPHERE: &str = "kind = \"sphere\"\nmaterial = \"clay\"";

#[test]
fn the_scenes_read() {
    for (file, materials, lights, objects) in [
        ("sphere", 1, 1, 1),
        ("shininess", 12, 1, 12),
        ("teapot", 2, 2, 2),
        ("bunny", 2, 2, 2),
        ("extremes", 4, 4, 6),
        ("materials", 5, 1, 5),
        ("gold", 2, 4, 2),
        ("skydome", 2, 64, 2),
    ] {
        let path = scenes().join(file).with_extension("toml");
        assert!(Scene::is_scene(&std::fs::read_to_string(&path).unwrap()), "{file}");
        let scene = Scene::read(&path).unwrap_or_else(|error| panic!("{file}: {}", message(error)));
        let counts = (scene.materials.len(), scene.lights.len(), scene.objects.len());
        assert_eq!((scene.name.as_str(), counts), (file, (materials, lights, objects)));
        for object in &scene.objects {
            let Shape::Mesh(mesh) = &object.shape else { continue };
            let known: &[(usize, usize)] = match file {
                "teapot" | "gold" => &[(992, 0)],
                "bunny" => &[(3674, 0)],
                "extremes" => &[(4, 2)],
                // The teapot and the bunny.
                _ => &[(992, 0), (3674, 0)],
            };
            assert!(known.contains(&(mesh.triangles.len(), mesh.dropped)), "{file}");
            outside(mesh, 0.02, file);
        }
    }
}

/// Every normal is a unit vector, and all but a part of them lie on the side of their triangle from which it turns to
/// the left: at a sharp edge a smooth one may not.
fn outside(mesh: &Mesh, part: f64, what: &str) {
    let mut inside = 0;
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|corner| mesh.positions[corner.position as usize]);
        let (u, v) = ([0, 1, 2].map(|i| b[i] - a[i]), [0, 1, 2].map(|i| c[i] - a[i]));
        let own = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        for corner in triangle {
            let normal = mesh.normals[corner.normal as usize];
            let dot = |a: [f64; 3]| a[0] * normal[0] + a[1] * normal[1] + a[2] * normal[2];
            assert!((dot(normal) - 1.0).abs() < 1e-9, "{what}: {normal:?}");
            inside += usize::from(dot(own) <= 0.0);
        }
    }
    assert!(inside as f64 <= part * 3.0 * mesh.triangles.len() as f64, "{what}: {inside} normals on the inside");
}

#[test]
fn defaults_are_filled_in() {
    let scene = parse(&scene("", CAMERA, MATERIAL, LIGHT, SPHERE, "")).unwrap();
    assert_eq!((scene.name.as_str(), scene.width, scene.height, scene.channel_bits), ("some_scene", 640, 480, 8));
    assert_eq!((scene.camera.target, scene.camera.up), ([0.0; 3], [0.0, 1.0, 0.0]));
    assert_eq!(scene.lights[0].kind, LightKind::Directional([0.0, 0.0, 1.0]));
    assert_eq!(scene.materials[0].diffuse, Some(0.6));
    assert_eq!((scene.budget.max_steps, scene.budget.min_psnr), (Some(1), None));
    assert_eq!((scene.core.family, scene.core.objective), (Family::Ecp5, Objective::Area));
    assert!(!scene.shadows);
}

#[test]
fn what_is_written_is_read() {
    let text = scene(
        "model = \"blinn\"",
        CAMERA,
        "name = \"clay\"\nroughness = 0.1\nk_a = 0.5\nk_d = 0.25\nk_s = 0.125",
        "position = [1, 2, 3]\ncolour = [1, 0.5, 0]\nintensity = 0.5",
        SPHERE,
        "[budget]\nmin_psnr = 40\n[core]\nfamily = \"ice40\"\nmin_mhz = 30\nobjective = \"dsp\"\nmethod = \"cubic\"",
    );
    let scene = parse(&text).unwrap();
    let clay = &scene.materials[0];
    assert!((clay.shininess - 198.0).abs() < 1e-9);
    assert_eq!((clay.ambient, clay.diffuse, clay.specular), (Some(0.5), Some(0.25), Some(0.125)));
    assert_eq!((scene.lights[0].kind, scene.lights[0].colour), (LightKind::Point([1.0, 2.0, 3.0]), [0.5, 0.25, 0.0]));
    assert_eq!((scene.budget.max_steps, scene.budget.min_psnr), (None, Some(40.0)));
    let core = &scene.core;
    assert_eq!((core.family, core.min_mhz, core.objective), (Family::Ice40, Some(30.0), Objective::Dsp));
    assert_eq!(core.keys, SpecFields { method: MethodName::named("cubic"), ..SpecFields::default() });
    let broadest = text.replace("roughness = 0.1", &format!("roughness = {}", (2.0f64 / 3.0).sqrt()));
    assert_eq!(parse(&broadest).unwrap().materials[0].shininess, 1.0);
}

#[test]
fn names_come_from_files() {
    let text = scene("", CAMERA, MATERIAL, LIGHT, SPHERE, "");
    for (file, name) in [
        ("dir/My Scene-2.toml", "my_scene_2"),
        ("7.toml", "scene_7"),
        ("module.toml", "scene_module"),
        ("__.toml", "scene"),
        (&"a".repeat(90), &format!("scene_{}", "a".repeat(58))),
    ] {
        assert_eq!(Scene::parse(&text, file, scenes()).unwrap().name, name, "{file}");
    }
}

#[test]
fn a_scene_is_told_from_the_spec_of_a_core() {
    assert!(Scene::is_scene(&scene("", CAMERA, MATERIAL, LIGHT, SPHERE, "")));
    assert!(Scene::is_scene("[camera]\nposition = [0, 0"));
    assert!(!Scene::is_scene("method = \"cubic\"\n[[material]]\nname = \"clay\"\nshininess = 8"));
    assert!(!Scene::is_scene("not TOML"));
}

#[test]
fn a_core_spec_takes_the_names_of_the_factors() {
    let text =
        "method = \"cubic\"\nblock = \"shader\"\n[[material]]\nname = \"a\"\nshininess = 8\nk_d = 0.5\nk_s = 0.25";
    let material = &SpecFields::parse(text, "core.toml").unwrap().material.unwrap()[0];
    assert_eq!((material.diffuse, material.specular), (Some(0.5), Some(0.25)));
}

#[test]
fn every_wrong_value_is_named() {
    let top = |top: &str| scene(top, CAMERA, MATERIAL, LIGHT, SPHERE, "");
    let camera = |camera: &str| scene("", camera, MATERIAL, LIGHT, SPHERE, "");
    let material = |material: &str| scene("", CAMERA, &format!("{MATERIAL}\n{material}"), LIGHT, SPHERE, "");
    let only = |material: &str| scene("", CAMERA, &format!("name = \"clay\"\n{material}"), LIGHT, SPHERE, "");
    let light = |light: &str| scene("", CAMERA, MATERIAL, &format!("{LIGHT}\n[[light]]\n{light}"), SPHERE, "");
    let object = |object: &str| {
        scene("", CAMERA, MATERIAL, LIGHT, SPHERE, &format!("[[object]]\nmaterial = \"clay\"\n{object}"))
    };
    let mesh = |mesh: &str| object(&format!("kind = \"mesh\"\n{mesh}"));
    let end = |end: &str| scene("", CAMERA, MATERIAL, LIGHT, SPHERE, end);
    let teapot = |keys: &str| mesh(&format!("file = \"meshes/teapot.obj\"\n{keys}"));
    for (text, expected) in [
        ("what = ".to_owned(), "docs/scene-files.md"),
        (String::new(), "the scene has no camera"),
        (top("widht = 3"), "did you mean `width`?"),
        (top("cores = 3"), "did you mean `core`?"),
        (top("name = \"a b\""), "the name `a b`"),
        (top("width = 0"), "width = 0 is out of range | a picture has 1 to 16384 pixels a side"),
        (top("height = 0"), "height = 0"),
        (top("height = 16385"), "height = 16385"),
        (top("width = -1"), "invalid value: integer `-1`"),
        (top("channel_bits = 9"), "channel_bits = 9 is not offered | 8, 10 or 12"),
        (top("ambient = [0.1, 1.5, 0]"), "ambient = 1.5"),
        (top("ambient = [0.1, nan, 0]"), "ambient = NaN"),
        (top("background = [0, 0, -0.1]"), "background = -0.1"),
        (top("background = [0, 0]"), "invalid length 2"),
        (top("model = \"cook\""), "unknown variant `cook`"),
        (camera("target = [0, 0, 0]"), "missing field `position`"),
        (camera("position = [0, inf, 0]"), "camera: position = inf"),
        (camera("position = [0, 1e10, 0]"), "camera: position = 10000000000"),
        (camera("position = [0, 0, 0]"), "camera: the camera stands at its target"),
        (camera("position = [0, 5, 0]"), "camera: up is along the view"),
        (camera(&format!("{CAMERA}\nup = [0, 0, 0]")), "camera: up is the zero vector"),
        (camera(&format!("{CAMERA}\nup = [0, nan, 0]")), "camera: up = NaN"),
        (camera(&format!("{CAMERA}\nfield_of_view = 180")), "camera: field_of_view = 180"),
        (camera(&format!("{CAMERA}\nfield_of_view = 0")), "camera: field_of_view = 0"),
        (camera(&format!("{CAMERA}\nfov = 30")), "unknown key `fov`"),
        (only(""), "material clay has no shininess"),
        (only("shininess = 0.5"), "material clay: shininess 0.5"),
        (only("shininess = nan"), "material clay: shininess NaN"),
        (only("shininess = inf"), "material clay: shininess inf"),
        (only("roughness = 0"), "material clay: roughness = 0"),
        (only("roughness = -0.5"), "roughness = -0.5"),
        (only("roughness = 0.82"), "sqrt(2/3)"),
        (only("roughness = nan"), "roughness = NaN"),
        (material("roughness = 0.5"), "material clay has both shininess and roughness"),
        (material("k_a = 2"), "material clay: ambient = 2"),
        (material("k_d = -0.1"), "material clay: diffuse = -0.1"),
        (material("k_s = nan"), "material clay: specular = NaN"),
        (material("k_s = 0.1\nspecular = 0.1"), "duplicate field `specular`"),
        (material("colour = [0, 0, 1.01]"), "material clay: colour = 1.01"),
        (material("specular_colour = [-1, 0, 0]"), "specular_colour = -1"),
        (material("color = [0, 0, 1]"), "did you mean `colour`?"),
        (material("[[material]]\nname = \"clay\"\nshininess = 9"), "there are two materials clay"),
        (material("[[material]]\nname = \"\"\nshininess = 9"), "the material name \"\""),
        (light(""), "light 2: neither direction nor position"),
        (light("direction = [0, 1, 0]\nposition = [0, 1, 0]"), "light 2: both direction and position"),
        (light("direction = [0, 0, 0]"), "light 2: direction is the zero vector"),
        (light("direction = [0, nan, 0]"), "light 2: direction = NaN"),
        (light("position = [0, inf, 0]"), "light 2: position = inf"),
        (light(&format!("{LIGHT}\ncolour = [2, 0, 0]")), "light 2: colour = 2"),
        (light(&format!("{LIGHT}\nintensity = -1")), "light 2: intensity = -1"),
        (light(&format!("{LIGHT}\nintensity = nan")), "light 2: intensity = NaN"),
        (
            light(&format!("{LIGHT}\nintensity = 3\ncolour = [0.5, 0, 0]")),
            "the channel saturates | an intensity of at most 2 for this colour",
        ),
        (end(&"[[light]]\nposition = [0, 1, 0]\n".repeat(4096)), "the scene has 4097 lights | a scene has 1 to 4096"),
        (format!("[camera]\n{CAMERA}"), "the scene has no materials"),
        (format!("[camera]\n{CAMERA}\n[[material]]\n{MATERIAL}"), "the scene has 0 lights"),
        (format!("[camera]\n{CAMERA}\n[[material]]\n{MATERIAL}\n[[light]]\n{LIGHT}"), "the scene has no objects"),
        (object("kind = \"cube\""), "unknown variant `cube`"),
        (object("radius = 1"), "missing field `kind`"),
        (object("kind = \"sphere\"\nradius = 0"), "object 2 (sphere): radius = 0"),
        (object("kind = \"sphere\"\nradius = nan"), "object 2 (sphere): radius = NaN"),
        (object("kind = \"sphere\"\nradius = inf"), "object 2 (sphere): radius = inf"),
        (object("kind = \"sphere\"\ncentre = [0, nan, 0]"), "object 2 (sphere): centre = NaN"),
        (
            object("kind = \"sphere\"\nnormal = [0, 1, 0]"),
            "object 2 (sphere): a sphere has no normal | its keys are kind, material, centre, radius",
        ),
        (object("kind = \"plane\"\nnormal = [0, 0, 0]"), "object 2 (plane): normal is the zero vector"),
        (object("kind = \"plane\"\npoint = [nan, 0, 0]"), "object 2 (plane): point = NaN"),
        (top("").replace("material = \"clay\"", "material = \"cly\""), "unknown material `cly` | did you mean `clay`?"),
        (mesh(""), "object 2 (mesh): file is missing"),
        (mesh("file = \"meshes/none.obj\""), "meshes/none.obj: No such file"),
        (mesh("file = \"sphere.toml\""), "sphere.toml is neither OBJ nor PLY"),
        (teapot("normals = \"round\""), "unknown variant `round`"),
        (teapot("scale = 0"), "object 2 (mesh): scale = 0"),
        (teapot("scale = [1, nan, 1]"), "object 2 (mesh): scale = NaN"),
        (teapot("scale = \"big\""), "a scale is a number, or a list of three"),
        (teapot("rotate = [0, inf, 0]"), "object 2 (mesh): rotate = inf"),
        (teapot("translate = [0, 0, nan]"), "object 2 (mesh): translate = NaN"),
        (teapot("scale = 1e9"), "comes to lie at"),
        (teapot("scale = [1e-9, 1e-9, 1e8]"), "its scale leaves no triangle of the mesh with an area"),
        (end("[budget]\nmax_steps = 256"), "budget: max_steps = 256 is out of range | 0 to 255"),
        (end("[budget]\nmin_psnr = 0"), "budget: min_psnr = 0"),
        (end("[budget]\nmin_psnr = nan"), "budget: min_psnr = NaN"),
        (end("[budget]\npsnr = 40"), "unknown key `psnr` | the keys are max_steps, min_psnr"),
        (end("[core]\nname = \"a\""), "core is given a name"),
        (end("[core]\nshininess = [3]"), "core is given a shininess"),
        (end("[[core.material]]\nname = \"a\"\nshininess = 3"), "core is given materials"),
        (end("[core]\nfamliy = \"ecp5\""), "did you mean `family`?"),
        (end("[core]\nfamily = \"spartan\""), "unknown variant `spartan`"),
        (end("[core]\nmethod = \"magic\""), "unknown variant `magic`"),
        (end("[core]\nmin_mhz = 0"), "core: min_mhz = 0"),
        (end("[core]\nmin_mhz = inf"), "core: min_mhz = inf"),
        (top("core = 3"), "core is no table"),
    ] {
        let message = message(parse(&text).expect_err(&text));
        assert!(message.contains(expected), "{text}\n{message}\nexpected: {expected}");
    }
}

/// A PLY header of these counts, with or without normals.
fn ply(format: &str, vertices: u64, faces: u64, normals: bool) -> String {
    let mut text = format!("ply\nformat {format} 1.0\nelement vertex {vertices}\n");
    let names: &[&str] = if normals { &["x", "y", "z", "nx", "ny", "nz"] } else { &["x", "y", "z"] };
    names.iter().for_each(|name| writeln!(text, "property float {name}").unwrap());
    write!(text, "element face {faces}\nproperty list uchar int vertex_indices\nend_header\n").unwrap();
    text
}

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

#[test]
fn every_wrong_mesh_is_named() {
    let ascii = |vertices, faces| ply("ascii", vertices, faces, false);
    let three = "0 0 0\n1 0 0\n0 1 0\n";
    let binary = ply("binary_little_endian", 3, 1, false);
    for (text, expected) in [
        (String::new(), "m.x is neither OBJ nor PLY | a mesh is an OBJ file, or a PLY file"),
        ("\u{7f}ELF".to_owned(), "neither"),
        (format!("{TRIANGLE}f 1 2 4"), "m.x, line 4: a face names the vertex 4, which is not there"),
        (format!("{TRIANGLE}f 1 2 0"), "the vertex 0, which is not there"),
        (format!("{TRIANGLE}f 1 2 -4"), "the vertex -4, which is not there | the file has 3 of them up to this line"),
        (format!("{TRIANGLE}f -9223372036854775808 1 2"), "which is not there"),
        (format!("{TRIANGLE}vn 0 0 1\nf 1//1 2//2 3//1"), "line 5: a face names the normal 2"),
        (format!("{TRIANGLE}f 1 2 x"), "line 4: face parse error"),
        (format!("{TRIANGLE}f 1 2 99999999999999999999"), "line 4: face parse error"),
        (format!("{TRIANGLE}v 1 2\nf 1 2 3"), "line 4: position parse error"),
        (format!("{TRIANGLE}v 1 nan 3\nf 1 2 3"), "line 4: the vertex 4 has the component NaN"),
        (format!("{TRIANGLE}v 1 2 3 0\nf 1 2 3"), "line 4: the vertex 4 has the component inf"),
        (format!("{TRIANGLE}vn 1 inf 3\nf 1 2 3"), "line 4: the normal 1 has the component inf"),
        (format!("{TRIANGLE}v 1 1e300 3\nf 1 2 3"), "line 4: the vertex 4 has the component 1000"),
        (TRIANGLE.to_owned(), "m.x has no faces"),
        (format!("{TRIANGLE}l 1 2 3"), "m.x has no faces"),
        (format!("{TRIANGLE}f 1 2\nf 1"), "m.x has no faces"),
        (format!("{TRIANGLE}f 1 1 2\nf 1 2 2"), "none of the 2 triangles of m.x has an area"),
        ("v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3".to_owned(), "none of the 1 triangles"),
        ("ply\n".to_owned(), "m.x: "),
        ("ply\nformat ascii 2.0\nend_header\n".to_owned(), "vertices have no x"),
        (format!("{}{three}3 0 1 3\n", ascii(3, 1)), "the face 0, counted from 0, names the vertex 3"),
        (format!("{}{three}3 0 1 -1\n", ascii(3, 1)), "the face 0, counted from 0, names a vertex, which is not there"),
        (
            format!("{}0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n", ascii(3, 1)),
            "m.x: Line 11: Couldn't read element line. String: '1 nan 0 ' | ",
        ),
        (
            format!("{}0 0 0\n1 1e99 0\n0 1 0\n3 0 1 2\n", ascii(3, 1)),
            "the vertex 1, counted from 0, has the component inf",
        ),
        (format!("{}{three}", ascii(3, 1)), "Unexpected end of file while reading element 'face'"),
        (format!("{}{three}4 0 1 2\n", ascii(3, 1)), "Expected 4 list elements"),
        (ascii(3, 0) + three, "m.x has no faces"),
        (format!("{}{three}3 0 0 1\n", ascii(3, 1)), "none of the 1 triangles"),
        (format!("{}{three}", ascii(1 << 60, 1 << 60)), "m.x: "),
        (format!("{binary}\0\0"), "Unexpected end of file"),
        (
            "ply\nformat binary_little_endian 1.0\nelement nothing 999999999999\nend_header\n".to_owned(),
            "the element nothing has no properties",
        ),
        (format!("{binary}{}\u{3}", "\0".repeat(36)).replace("list uchar", "list float"), "m.x: "),
        (binary.replace("property list uchar int vertex_indices\n", "property float a\n"), "m.x has no faces"),
    ] {
        let start = Instant::now();
        let message = message(Mesh::parse(text.as_bytes(), "m.x", Normals::File).expect_err(&text));
        assert!(message.contains(expected), "{text}\n{message}\nexpected: {expected}");
        assert!(start.elapsed() < Duration::from_secs(5), "{text}");
    }
    let nan = [binary.as_bytes(), &f32::NAN.to_le_bytes(), &[0; 32], &[3], &[0; 12]].concat();
    let message = message(Mesh::parse(&nan, "m.ply", Normals::File).unwrap_err());
    assert!(message.contains("the vertex 0, counted from 0, has the component NaN"), "{message}");
}

fn mesh(text: &str, normals: Normals) -> Mesh {
    Mesh::parse(text.as_bytes(), "m", normals).unwrap_or_else(|error| panic!("{text}\n{}", message(error)))
}

/// The normals of the corners, triangle by triangle.
fn corner_normals(mesh: &Mesh) -> Vec<[f64; 3]> {
    mesh.triangles.iter().flatten().map(|corner| mesh.normals[corner.normal as usize]).collect()
}

#[test]
fn obj_and_ply_say_the_same() {
    let obj = mesh(&format!("# a\no a\n{TRIANGLE}v 1 1 0 # b\r\ng b\nusemtl c\nf 1/1 2/2 4/3 3/4\n"), Normals::File);
    let ascii = ply("ascii", 4, 1, false) + "0 0 0\n1 0 0\n0 1 0\n1 1 0\n4 0 1 3 2\n";
    let ascii = mesh(&ascii, Normals::File);
    let places = |mesh: &Mesh| {
        mesh.triangles.iter().map(|t| t.map(|corner| mesh.positions[corner.position as usize])).collect::<Vec<_>>()
    };
    assert_eq!(places(&obj), places(&ascii));
    assert_eq!(places(&obj).len(), 2);
    assert_eq!(corner_normals(&obj), [[0.0, 0.0, 1.0]; 6]);
    assert_eq!(corner_normals(&ascii), corner_normals(&obj));
    for big in [false, true] {
        let mut bytes = ply(if big { "binary_big_endian" } else { "binary_little_endian" }, 4, 1, false).into_bytes();
        for value in [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0] {
            let value = value as f32;
            bytes.extend(if big { value.to_be_bytes() } else { value.to_le_bytes() });
        }
        bytes.push(4);
        for index in [0i32, 1, 3, 2] {
            bytes.extend(if big { index.to_be_bytes() } else { index.to_le_bytes() });
        }
        assert_eq!(Mesh::parse(&bytes, "m", Normals::File).unwrap(), ascii);
    }
}

/// A mesh with a vertex that no face names, so that a lost one would shift the faces in silence.
const UNUSED: &str = "# made\nv -1 -1 0\nv 1 -1 0 # right\nv 1 1 0\nv -1 1 0\nv 0 0 3\ncurv 1 2\nf 1 2 3\nf 1 3 4\n";

#[test]
fn a_mesh_is_the_same_however_its_text_is_written() {
    let picture = |bytes: &[u8], extension: &str| {
        let directory = tempfile::tempdir().unwrap();
        std::fs::write(directory.path().join("m").with_extension(extension), bytes).unwrap();
        let object = format!("kind = \"mesh\"\nmaterial = \"clay\"\nfile = \"m.{extension}\"");
        let text = scene("width = 24\nheight = 24", CAMERA, MATERIAL, LIGHT, &object, "");
        let scene = Scene::parse(&text, "s.toml", directory.path());
        let scene = scene.unwrap_or_else(|error| panic!("{:?}\n{}", String::from_utf8_lossy(bytes), message(error)));
        let frame = Frame::render(&scene, &|| {});
        let samples = frame.versine.iter().filter(|versine| !versine.is_nan()).count();
        (samples, frame.picture(&scene, &Exact.of(&scene, &frame).unwrap()).codes)
    };
    let plain = picture(UNUSED.as_bytes(), "obj");
    assert!(plain.0 > 100, "{}", plain.0);
    let continued = UNUSED.replace("f 1 2 3", "f 1 2 \\\n3").replace("v 1 1 0", "v 1 \\  \r\n 1\\\n0");
    let colours = UNUSED
        .replace("-1 -1 0", "-1 -1 0 0.5 0.5 0.5")
        .replace("v 1 1 0", "v 1 1 0 1 0 0 1")
        .replace("v 0 0 3", "v 0 0 3 1");
    let (vertices, faces) = UNUSED.split_at(UNUSED.find("curv").unwrap());
    for (what, text) in [
        ("a byte order mark", format!("\u{feff}{UNUSED}")),
        ("CR LF", UNUSED.replace('\n', "\r\n")),
        ("CR", UNUSED.replace('\n', "\r")),
        ("a byte order mark and CR", format!("\u{feff}{}", UNUSED.replace('\n', "\r"))),
        ("tabs and blanks", UNUSED.replace(' ', " \t ").replace('\n', " \n\n\t")),
        ("continued lines", continued),
        ("a path in a comment", format!("# C:\\models\\\n{UNUSED}")),
        ("comments behind statements", UNUSED.replace("3\nf", "3#x\nf").replace("4\n", "4 # last \\\n")),
        ("negative indices", UNUSED.replace("f 1 2 3", "f -5 -4 -3").replace("f 1 3 4", "f -5 -3 -2")),
        ("faces first", format!("{faces}{vertices}")),
        ("colours and weights", colours),
        ("weights", UNUSED.replace("v 1 1 0", "v 2 2 0 2")),
        (
            "materials and groups",
            UNUSED.replace("f 1 3 4", "o b\ng c\ns 1\nusemtl Material #25\nf 1 3 4\nmtllib a b.mtl"),
        ),
        ("textures", UNUSED.replace("f 1 2 3", "vt 0 0\nf 1/1 2/1 3/1")),
        ("no end of the last line", UNUSED.trim_end().to_owned()),
    ] {
        assert_eq!(picture(text.as_bytes(), "obj"), plain, "{what}");
    }
    let body = "-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n0 0 3\n3 0 1 2\n3 0 2 3\n";
    let ascii = ply("ascii", 5, 2, false) + body;
    for (what, text) in [
        ("plain", ascii.clone()),
        ("a byte order mark", format!("\u{feff}{ascii}")),
        ("CR LF", ascii.replace('\n', "\r\n")),
        ("CR", ascii.replace('\n', "\r")),
        ("blanks", ascii.replace(' ', "  ").replace('\n', " \n")),
        ("empty lines", ascii.replace("end_header\n", "comment  a\n\nend_header\n\n")),
    ] {
        assert_eq!(picture(text.as_bytes(), "ply"), plain, "{what}");
    }
    for end in ["\n", "\r\n", "\r"] {
        let header = ply("binary_little_endian", 5, 2, false).replace('\n', end);
        let mut bytes = [b"\xef\xbb\xbf", header.as_bytes()].concat();
        // The first byte of the body is a line feed: -1.0000012.
        let first = f32::from_le_bytes([10, 0, 0x80, 0xbf]);
        for value in [first, -1.0, 0.0, 1.0, -1.0, 0.0, 1.0, 1.0, 0.0, -1.0, 1.0, 0.0, 0.0, 0.0, 3.0f32] {
            bytes.extend(value.to_le_bytes());
        }
        for corners in [[0i32, 1, 2], [0, 2, 3]] {
            bytes.push(3);
            corners.iter().for_each(|corner| bytes.extend(corner.to_le_bytes()));
        }
        assert_eq!(picture(&bytes, "ply"), plain, "{end:?}");
    }
    for (text, big) in [("v 0 0 0\nf 1 1 1\n", false), ("ply\nformat ascii 1.0\n", true)] {
        let bytes: Vec<u8> =
            text.encode_utf16().flat_map(|unit| if big { unit.to_be_bytes() } else { unit.to_le_bytes() }).collect();
        let mark: &[u8] = if big { b"\xfe\xff" } else { b"\xff\xfe" };
        for bytes in [bytes.clone(), [mark, &bytes[..]].concat()] {
            let message = message(Mesh::parse(&bytes, "m.obj", Normals::File).unwrap_err());
            assert!(message.starts_with("m.obj is text in UTF-16 | save it as UTF-8"), "{message}");
        }
    }
}

/// Two squares side by side, of two materials.
const PAINTED: &str = "mtllib two.mtl\nv -2 -1 0\nv 0 -1 0\nv 0 1 0\nv -2 1 0\nv 2 -1 0\nv 2 1 0\nusemtl red\nf 1 2 3 4\nusemtl blue metal # right\nf 2 5 6 3\n";
const TWO: &str = "newmtl red\nNs 20\nKa 0.1 0 0\nKd 0.8 0.1 0.1\nKs 0.2 0.2 0.2\nillum 2\nmap_Kd red.png\nnewmtl blue metal\nNs 400.5\nKa 1 1 1\nKd 0 0 0.5\nKs 0.5\nd 1\n";

#[test]
fn a_mesh_has_the_materials_of_its_file_on_wish() {
    let directory = tempfile::tempdir().unwrap();
    let read = |obj: &str, mtl: &str, keys: &str| {
        std::fs::write(directory.path().join("two.obj"), obj).unwrap();
        std::fs::write(directory.path().join("two.mtl"), mtl).unwrap();
        let object = format!("kind = \"mesh\"\nfile = \"two.obj\"\n{keys}");
        Scene::parse(&scene("", CAMERA, MATERIAL, LIGHT, &object, ""), "s.toml", directory.path())
    };
    let wished = "materials = \"mtl\"";
    let painted = read(PAINTED, TWO, wished).unwrap_or_else(|error| panic!("{}", message(error)));
    let names: Vec<(&str, f64)> = painted.materials.iter().map(|one| (one.name.as_str(), one.shininess)).collect();
    assert_eq!(names, [("clay", 8.0), ("red", 20.0), ("blue metal", 400.5)]);
    let surface = painted.materials[2].surface();
    assert_eq!((surface.ambient, surface.diffuse, surface.specular), ([1.0; 3], [0.0, 0.0, 0.5], [0.5; 3]));
    assert_eq!(painted.materials[1].surface().ambient, [0.1, 0.0, 0.0]);
    assert_eq!(painted.left_out, ["two.mtl: left out d (line 13), illum (line 6), map_Kd (line 7)"]);
    let objects: Vec<usize> = painted.objects.iter().map(|object| object.material).collect();
    assert_eq!(objects, [1, 2]);
    let frame = Frame::render(&painted, &|| {});
    let mut seen: Vec<u16> = frame.material.clone();
    seen.sort_unstable();
    seen.dedup();
    assert_eq!(&seen[..2], [1, 2]);
    // Where nothing is wished the object's material holds, and the file need not be there.
    let plain = read(PAINTED, "?", "material = \"clay\"").unwrap_or_else(|error| panic!("{}", message(error)));
    assert_eq!((plain.materials.len(), plain.objects.len()), (1, 1));
    // A mark, other line ends and continued lines change nothing.
    for (obj, mtl) in [
        (format!("\u{feff}{PAINTED}"), format!("\u{feff}{TWO}")),
        (PAINTED.replace('\n', "\r\n"), TWO.replace('\n', "\r")),
        (PAINTED.replace("2 5 6", "2 5 \\\n6"), TWO.replace("0.8 0.1", "0.8 \\\n0.1")),
    ] {
        let again = read(&obj, &mtl, wished).unwrap_or_else(|error| panic!("{}", message(error)));
        assert_eq!(again.materials, painted.materials);
    }
    // Faces without a material have the object's.
    let both = read(&PAINTED.replace("usemtl red\n", ""), TWO, &format!("{wished}\nmaterial = \"clay\""));
    let both = both.unwrap_or_else(|error| panic!("{}", message(error)));
    assert_eq!(both.objects.iter().map(|object| object.material).collect::<Vec<_>>(), [1, 0]);
    let refused = |obj: &str, mtl: &str, keys: &str| message(read(obj, mtl, keys).expect_err(obj));
    for (obj, mtl, expected) in [
        (PAINTED.replace("two.mtl", "no.mtl"), TWO.to_owned(), "two.obj, line 1: there is no file "),
        (PAINTED.replace("mtllib two.mtl\n", ""), TWO.to_owned(), "two.obj has no mtllib"),
        (
            PAINTED.replace("usemtl red", "usemtl rod"),
            TWO.to_owned(),
            "two.obj, line 8: the material `rod` is not in two.mtl | did you mean `red`?",
        ),
        (PAINTED.replace("usemtl red\n", ""), TWO.to_owned(), "two.obj has faces before its first usemtl"),
        (PAINTED.to_owned(), TWO.replace("Ns 20", "Ns 0"), "two.mtl, line 2: the material `red` has Ns = 0 "),
        (PAINTED.to_owned(), TWO.replace("Ns 20", "Ns 1000.5"), "two.mtl, line 2: the material `red` has Ns = 1000.5"),
        (PAINTED.to_owned(), TWO.replace("0.8", "red"), "two.mtl, line 4: Kd: `red` is not a number"),
        (PAINTED.to_owned(), TWO.replace("0.8", "1.8"), "two.mtl, line 4: Kd = 1.8 is out of range"),
    ] {
        let message = refused(&obj, &mtl, wished);
        assert!(message.contains(expected), "{message}\nexpected: {expected}");
    }
    assert!(refused(PAINTED, TWO, "").contains("a mesh has no material"));
    let message = message(parse(&scene("", CAMERA, MATERIAL, LIGHT, &format!("{SPHERE}\n{wished}"), "")).unwrap_err());
    assert!(message.contains("a sphere has no materials"), "{message}");
}

#[test]
fn normals_are_the_files_smooth_or_flat() {
    // A roof of two slopes, its ridge's vertices given twice; the normals of the file are of other lengths, one of them
    // 0.
    let roof = "v -1 0 0\nv 0 1 0\nv 0 1 -1\nv 1 0 0\nv 0 1 0\nv 0 1 -1\n";
    let plain = format!("{roof}f 1 2 3\nf 4 6 5\n");
    let half = 0.5f64.sqrt();
    let near = |a: &[[f64; 3]], b: &[[f64; 3]]| {
        let far = a.iter().flatten().zip(b.iter().flatten()).any(|(a, b)| (a - b).abs() > 1e-12);
        assert!(a.len() == b.len() && !far, "{a:?} {b:?}");
    };
    let (left, right, up) = ([-half, half, 0.0], [half, half, 0.0], [0.0, 1.0, 0.0]);
    let flat = [left, left, left, right, right, right];
    near(&corner_normals(&mesh(&plain, Normals::Flat)), &flat);
    let turned = format!("{roof}f 1 3 2\nf 4 5 6\n");
    near(&corner_normals(&mesh(&turned, Normals::Flat)), &flat.map(|n| n.map(|c| -c)));
    let smooth = [left, up, up, right, up, up];
    near(&corner_normals(&mesh(&plain, Normals::Smooth)), &smooth);
    near(&corner_normals(&mesh(&plain, Normals::File)), &smooth);
    let given = format!("{roof}vn 0 0 7\nvn 0 0 0\nf 1//1 2//1 3//1\nf 4//1 6//2 5//2\n");
    let z = [0.0, 0.0, 1.0];
    near(&corner_normals(&mesh(&given, Normals::File)), &[z, z, z, z, right, right]);
    near(&corner_normals(&mesh(&given, Normals::Smooth)), &smooth);
    // Where a corner has none, the file's are not used.
    near(&corner_normals(&mesh(&given.replace("4//1", "4"), Normals::File)), &smooth);
    let ply = ply("ascii", 3, 1, true) + "0 0 0 1 0 0\n1 0 0 0 0 0\n0 1 0 0 2 0\n3 0 1 2\n";
    near(&corner_normals(&mesh(&ply, Normals::File)), &[[1.0, 0.0, 0.0], z, up]);
    // A sheet of two sides: the sums cancel, and each side keeps its own.
    let sheet = mesh(&format!("{TRIANGLE}f 1 2 3\nf 1 3 2\n"), Normals::Smooth);
    near(&corner_normals(&sheet), &[z, z, z, [0.0, 0.0, -1.0], [0.0, 0.0, -1.0], [0.0, 0.0, -1.0]]);
}

#[test]
fn triangles_without_an_area_are_dropped_and_tiny_ones_are_not() {
    let dropped = mesh(&format!("{TRIANGLE}f 1 1 2\nf 1 2 3\nf 1 2 2\n"), Normals::File);
    assert_eq!((dropped.triangles.len(), dropped.dropped), (1, 2));
    let tiny = mesh("v 0 0 0\nv 1e-200 0 0\nv 0 1e-200 0\nf 1 2 3\n", Normals::File);
    assert_eq!(corner_normals(&tiny), [[0.0, 0.0, 1.0]; 3]);
}

#[test]
fn transforms_scale_then_turn_then_move_and_keep_normals_outside() {
    let tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    for normals in [Normals::Smooth, Normals::Flat] {
        for scale in [[1.0, 1.0, 1.0], [-1.0, 1.0, 1.0], [2.0, -3.0, -0.1], [-1.0, -1.0, -1.0], [1e-6, 1e-6, 1e-6]] {
            let transform = Transform { scale, rotate: [20.0, 130.0, -70.0], translate: [3.0, 4.0, 5.0] };
            let there = mesh(tetrahedron, normals).transformed(&transform).unwrap();
            if normals == Normals::Flat {
                outside(&there, 0.0, &format!("{scale:?}"));
            }
            // A normal and the way from the middle to its corner keep their scalar product's sign, however the mesh is
            // scaled.
            let middle = [0, 1, 2].map(|i| there.positions.iter().map(|p| p[i]).sum::<f64>() / 4.0);
            for corner in there.triangles.iter().flatten() {
                let (p, n) = (there.positions[corner.position as usize], there.normals[corner.normal as usize]);
                let out: f64 = [0, 1, 2].iter().map(|&i| n[i] * (p[i] - middle[i])).sum();
                assert!(out > 0.0, "{normals:?} {scale:?}");
                assert!((n.iter().map(|c| c * c).sum::<f64>() - 1.0).abs() < 1e-9, "{n:?}");
            }
        }
    }
    let transform = Transform { scale: [2.0, 1.0, 1.0], rotate: [90.0, 0.0, 90.0], translate: [0.0, 0.0, 7.0] };
    let there = mesh(&format!("{TRIANGLE}f 1 2 3\n"), Normals::File).transformed(&transform).unwrap();
    // x, twice as long, goes to y; y to z; and z, the normal, to -y and on to x.
    for (place, expected) in there.positions.iter().zip([[0.0, 0.0, 7.0], [0.0, 2.0, 7.0], [0.0, 0.0, 8.0]]) {
        assert!([0, 1, 2].iter().all(|&i| (place[i] - expected[i]).abs() < 1e-12), "{place:?}");
    }
    assert!((there.normals[0][0] - 1.0).abs() < 1e-12, "{:?}", there.normals[0]);
}

#[test]
fn a_million_triangles_are_read_in_seconds() {
    let side = 708;
    let mut text = String::new();
    for y in 0..side {
        (0..side).for_each(|x| writeln!(text, "v {x} {y} {}", (x * y) % 7).unwrap());
    }
    for y in 1..side {
        for x in 1..side {
            let corner = |dx: i32, dy: i32| (y - dy) * side + x - dx + 1;
            let (a, b, c, d) = (corner(1, 1), corner(0, 1), corner(0, 0), corner(1, 0));
            writeln!(text, "f {a} {b} {c} {d}").unwrap();
        }
    }
    let start = Instant::now();
    let mesh = mesh(&text, Normals::File);
    println!("{} triangles in {:?}", mesh.triangles.len(), start.elapsed());
    assert_eq!(mesh.triangles.len(), 2 * 707 * 707 - mesh.dropped);
    assert!(start.elapsed() < Duration::from_secs(20), "{:?}", start.elapsed());
}

proptest! {
    #[test]
    fn any_text_is_taken_or_refused(text in "\\PC*") {
        let _ = parse(&text);
        let _ = Scene::is_scene(&text);
    }

    #[test]
    fn any_value_is_taken_or_refused(place in 0usize..6, key in "(name|width|position|target|up|field_of_view|shininess|roughness|k_s|colour|direction|intensity|radius|normal|point|scale|max_steps|min_psnr|family|method|core)", value in "(\"[a-z0-9.=,]{0,12}\"|-?[0-9]{1,12}|[0-9]{1,3}\\.[0-9]{1,3}|\\[[-0-9., ]{0,9}\\]|\\[nan, inf, 1\\]|nan|true)") {
        let mut parts = [String::new(), CAMERA.into(), MATERIAL.into(), LIGHT.into(), SPHERE.into(), "[core]".to_owned()];
        write!(parts[place], "\n{key} = {value}").unwrap();
        let [top, camera, material, light, object, end] = &parts;
        let _ = parse(&scene(top, camera, material, light, object, end));
    }

    #[test]
    fn any_obj_is_taken_or_refused(text in "((v|vn|vt|f|l|o|g|#|s|mtllib|usemtl|p)( (-?[0-9]{1,2}(\\.[0-9])?|nan|-?[0-9]{1,20}(//?-?[0-9]{1,20}){0,3}|1e300|/|a)){0,5}\n){0,20}") {
        for normals in [Normals::File, Normals::Smooth] {
            if let Ok(mesh) = Mesh::parse(format!("{TRIANGLE}vn 0 0 1\nf 1 2 3\n{text}").as_bytes(), "m", normals) {
                prop_assert!(mesh.triangles.iter().flatten().all(|c| (c.position as usize) < mesh.positions.len() && (c.normal as usize) < mesh.normals.len()));
            }
        }
    }

    #[test]
    fn any_ply_is_taken_or_refused(format in "(ascii|binary_little_endian|binary_big_endian)", header in "((element (vertex|face|edge) [0-9]{1,19}|property (float|double|uchar|int|int8|uint) (x|y|z|nx|a)|property list (uchar|int|float|uint|char) (int|uint|uchar|float) (vertex_indices|vertex_index|x|a)|comment a|obj_info)\n){0,9}", body in proptest::collection::vec(any::<u8>(), 0..80), numbers in "([0-9]{1,3}( |\n)){0,30}") {
        let full = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\n";
        for header in [format!("ply\nformat {format} 1.0\n{header}end_header\n"), format!("ply\nformat {format} 1.0\n{full}{header}end_header\n")] {
            let _ = Mesh::parse(&[header.as_bytes(), &body].concat(), "m", Normals::File);
            let _ = Mesh::parse(&[header.as_bytes(), numbers.as_bytes()].concat(), "m", Normals::File);
        }
    }
}
