//! Scene files and meshes: what is read, and what is refused with which words.

mod mesh;
mod random;

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

/// Each text is no scene, and what is said of it contains this.
#[track_caller]
fn assert_named<const N: usize>(wrong: [(String, &str); N]) {
    for (text, expected) in wrong {
        let message = message(parse(&text).expect_err(&text));
        assert!(message.contains(expected), "{text}\n{message}\nexpected: {expected}");
    }
}

#[test]
fn every_wrong_value_of_pictures_cameras_and_materials_is_named() {
    let top = |top: &str| scene(top, CAMERA, MATERIAL, LIGHT, SPHERE, "");
    let camera = |camera: &str| scene("", camera, MATERIAL, LIGHT, SPHERE, "");
    let material = |material: &str| scene("", CAMERA, &format!("{MATERIAL}\n{material}"), LIGHT, SPHERE, "");
    let only = |material: &str| scene("", CAMERA, &format!("name = \"clay\"\n{material}"), LIGHT, SPHERE, "");
    assert_named([
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
    ]);
}

#[test]
fn every_wrong_value_of_lights_budgets_and_cores_is_named() {
    let top = |top: &str| scene(top, CAMERA, MATERIAL, LIGHT, SPHERE, "");
    let light = |light: &str| scene("", CAMERA, MATERIAL, &format!("{LIGHT}\n[[light]]\n{light}"), SPHERE, "");
    let end = |end: &str| scene("", CAMERA, MATERIAL, LIGHT, SPHERE, end);
    assert_named([
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
    ]);
}

#[test]
fn every_wrong_value_of_objects_is_named() {
    let top = |top: &str| scene(top, CAMERA, MATERIAL, LIGHT, SPHERE, "");
    let object = |object: &str| {
        scene("", CAMERA, MATERIAL, LIGHT, SPHERE, &format!("[[object]]\nmaterial = \"clay\"\n{object}"))
    };
    let mesh = |mesh: &str| object(&format!("kind = \"mesh\"\n{mesh}"));
    let teapot = |keys: &str| mesh(&format!("file = \"meshes/teapot.obj\"\n{keys}"));
    assert_named([
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
    ]);
}

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

fn mesh(text: &str, normals: Normals) -> Mesh {
    Mesh::parse(text.as_bytes(), "m", normals).unwrap_or_else(|error| panic!("{text}\n{}", message(error)))
}
