//! Scenes with materials that are drawn by their reflectance: exactly against formulas of their own, through the forms,
//! next to classical ones.

use std::path::Path;

use brdfgen::reflectance::vector::seen_from;
use brdfgen::reflectance::{FormKind, FormSpec, Model, Reflectance, Vector, measure};
use brdfgen::scene::reflectance::{Compared, Looks, psnr};
use brdfgen::scene::{Exact, Frame, Highlights, LightKind, Scene, Tracer};
use serde_json::Value;

use crate::common::Scratch;

/// A sphere of one material under one light; `{}` is the table of the reflectance.
fn sphere(reflectance: &str, light: &str) -> String {
    format!(
        "width = 48\nheight = 40\n[camera]\nposition = [0.5, 0.8, 4.0]\n[[material]]\nname \
         = \"own\"\n[material.reflectance]\n{reflectance}\n\
         [[light]]\n{light}\n[[object]]\nkind = \"sphere\"\nmaterial = \"own\"\n"
    )
}

const DISTANT: &str = "direction = [1.0, 1.0, 0.4]\ncolour = [1.0, 0.5, 0.25]";
const NEAR: &str = "position = [1.2, 1.5, 1.0]";

fn parse(text: &str) -> Scene {
    Scene::parse(text, "own.toml", Path::new("")).unwrap()
}

/// The channels of a scene's picture for some looks.
fn channels(scene: &Scene, looks: &Looks) -> (Frame, Vec<[f64; 3]>) {
    let (frame, bases) = Frame::with_looks(&Tracer::new(scene), scene, std::slice::from_ref(looks), &|| ());
    let lobes = Exact.of(scene, &frame).unwrap();
    let own = frame.channels(scene, &bases[0], &lobes);
    (frame, own)
}

/// GGX with Smith's shadowing and Schlick's Fresnel term, written down a second time.
fn ggx(alpha: f64, kd: [f64; 3], f0: [f64; 3], [l, v, n]: [Vector; 3]) -> [f64; 3] {
    let h = (l + v).normalize();
    let (nl, nv, nh, lh) = (n.dot(&l), n.dot(&v), n.dot(&h), l.dot(&h));
    let a2 = alpha * alpha;
    let d = a2 / (std::f64::consts::PI * (nh * nh * (a2 - 1.0) + 1.0).powi(2));
    let g = |c: f64| 2.0 / (1.0 + (1.0 + a2 * (1.0 - c * c) / (c * c)).sqrt());
    [0, 1, 2].map(|c| {
        let f = f0[c] + (1.0 - f0[c]) * (1.0 - lh).powi(5);
        kd[c] / std::f64::consts::PI + d * g(nl) * g(nv) * f / (4.0 * nl * nv)
    })
}

/// The pixels of a sphere about the origin by their own formula: normal, direction to the viewer, to the light.
fn geometry(scene: &Scene) -> Vec<Option<[Vector; 3]>> {
    let eye = Vector::from(scene.camera.position);
    let rows = (0..scene.height).flat_map(|row| scene.camera.row(scene.width, scene.height, row));
    rows.map(|way| {
        let way = Vector::from(way).normalize();
        let b = eye.dot(&way);
        let root = b * b - eye.dot(&eye) + 1.0;
        if root < 0.0 {
            return None;
        }
        let n = eye + way * (-b - root.sqrt());
        let l = match scene.lights[0].kind {
            LightKind::Directional(way) => Vector::from(way),
            LightKind::Point(place) => (Vector::from(place) - n).normalize(),
        };
        Some([l, -way, n])
    })
    .collect()
}

const GGX: &str =
    "model = \"ggx\"\nparameters = { alpha = 0.3, kd = [0.2, 0.1, 0.05], f0 = [0.9, 0.6, 0.3] }\nexposure = 1.5";

#[test]
fn the_exact_picture_is_that_of_the_formula() {
    for light in [DISTANT, NEAR] {
        let scene = parse(&sphere(GGX, light));
        let (_, own) = channels(&scene, &scene.exact_looks().unwrap());
        let mut lit = 0;
        for (pixel, geometry) in own.iter().zip(geometry(&scene)) {
            let Some([l, v, n]) = geometry else {
                assert_eq!(*pixel, [0.0; 3]);
                continue;
            };
            let cosine = n.dot(&l);
            // Where the sphere is seen from its side normals are turned to the viewer a little.
            if n.dot(&v) < 0.02 {
                continue;
            }
            let f = ggx(0.3, [0.2, 0.1, 0.05], [0.9, 0.6, 0.3], [l, v, n]);
            for c in 0..3 {
                let wanted = if cosine > 0.0 { 1.5 * f[c] * cosine * scene.lights[0].colour[c] } else { 0.0 };
                assert!((pixel[c] - wanted).abs() < 1e-9 * (1.0 + wanted), "{pixel:?} {wanted}");
            }
            lit += usize::from(cosine > 0.0);
        }
        assert!(lit > 200, "{lit}");
    }
}

#[test]
fn a_form_is_looked_up_in_the_frame_of_each_pixel() {
    for (form, kind, images) in
        [("paper", FormKind::Paper, 6), ("half", FormKind::Half, 9), ("bivariate", FormKind::Bivariate, 1)]
    {
        let keys = format!("{GGX}\nform = \"{form}\"\nimages = {images}\nsize = 48");
        let keys = if kind == FormKind::Bivariate { keys.replace("images = 1\n", "") } else { keys };
        let scene = parse(&sphere(&keys, NEAR));
        let (_, own) = channels(&scene, &scene.own_looks().unwrap());
        let mut model = Model::named("ggx").unwrap();
        for (key, value) in [("alpha", "0.3"), ("kd", "0.2,0.1,0.05"), ("f0", "0.9,0.6,0.3")] {
            model.set(key, value).unwrap();
        }
        let form = FormSpec::sized(kind, images, 48, kind.texel()).build(&model, 1.5).unwrap();
        for (pixel, geometry) in own.iter().zip(geometry(&scene)) {
            let Some([l, v, n]) = geometry.filter(|[l, v, n]| n.dot(v) > 0.02 && n.dot(l) > 0.0) else { continue };
            let (light, n) = seen_from(l, v, n);
            let wanted = form.at(light, n);
            assert!((0..3).all(|c| (pixel[c] - wanted[c]).abs() < 1e-7 * (1.0 + wanted[c])), "{pixel:?} {wanted:?}");
        }
    }
}

#[test]
fn the_viewer_along_the_axis_is_the_papers_reading() {
    // From far away both readings are the same; from near by the axis costs.
    let ratio = |position: &str, viewer: &str| {
        let keys = format!("{GGX}\nform = \"half\"\nviewer = \"{viewer}\"");
        let text = sphere(&keys, DISTANT).replace("position = [0.5, 0.8, 4.0]", position);
        let scene = parse(&text);
        let (frame, exact) = channels(&scene, &scene.exact_looks().unwrap());
        let (_, own) = channels(&scene, &scene.own_looks().unwrap());
        psnr(&frame, &exact, &own).unwrap()
    };
    let far = "position = [0.0, 0.0, 4000.0]\nfield_of_view = 0.035";
    let near = "position = [0.0, 0.0, 2.0]\nfield_of_view = 80";
    assert!((ratio(far, "axis") - ratio(far, "pixel")).abs() < 0.1);
    assert!(ratio(near, "pixel") > ratio(near, "axis") + 10.0, "{} {}", ratio(near, "pixel"), ratio(near, "axis"));
}

#[test]
fn any_number_of_lights_adds_up() {
    let one = parse(&sphere(GGX, "direction = [1.0, 1.0, 0.4]\nintensity = 1.0"));
    let many = "direction = [1.0, 1.0, 0.4]\nintensity = 0.015625\n[[light]]\n".repeat(63)
        + "direction = [1.0, 1.0, 0.4]\nintensity = 0.015625";
    let many = parse(&sphere(GGX, &many));
    assert_eq!(many.lights.len(), 64);
    let of = |scene: &Scene| channels(scene, &scene.own_looks().unwrap()).1;
    let (one, sum) = (of(&one), of(&many));
    assert!(one.as_flattened().iter().zip(sum.as_flattened()).all(|(a, b)| (a - b).abs() < 1e-12));
    let on =
        |threads: usize| rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(|| of(&many));
    assert!(on(1) == sum && on(3) == sum, "the number of threads matters");
    // A shader has eight at most: a classical scene may have more, and its shader is refused.
    let scratch = Scratch::new();
    let classical = sphere("", "").replace("[material.reflectance]\n", "shininess = 20\n");
    let lights = "direction = [1.0, 1.0, 0.4]\nintensity = 0.1\n[[light]]\n".repeat(8)
        + "direction = [0.0, 1.0, 0.4]\nintensity = 0.1\n";
    scratch.write("nine.toml", classical.replace("[[light]]\n", &format!("[[light]]\n{lights}")));
    scratch.run("render nine.toml --only exact --out nine.png").succeeds();
    scratch.refused("generate nine.toml --block shader --out nine", &["lights = 9"]);
}

/// Gold beside a classical floor.
const MIXED: &str = r#"
width = 60
height = 40
ambient = [0.5, 0.5, 0.5]
[camera]
position = [0.0, 1.0, 5.0]
[[material]]
name = "gold"
k_a = 0.1
[material.reflectance]
model = "gold-paint"
form = "paper"
images = [0, 30, 60, 90, 120, 150]
size = 64
texel = "linear:8"
border = "extend"
[[material]]
name = "floor"
shininess = 3
[[light]]
direction = [1.0, 1.0, 1.0]
[[light]]
position = [-2.0, 3.0, 2.0]
intensity = 0.5
[[object]]
kind = "sphere"
material = "gold"
centre = [0.0, 0.2, 0.0]
[[object]]
kind = "plane"
material = "floor"
point = [0.0, -0.8, 0.0]
"#;

fn json(scratch: &Scratch, line: &str) -> Value {
    scratch.run(line).ends_with(0).json()
}

#[test]
fn render_shows_exact_and_through_images() {
    let scratch = Scratch::new();
    scratch.write("mixed.toml", MIXED);
    let all = json(&scratch, "render mixed.toml --out all.png --json");
    let images = &all["images"];
    assert_eq!(images["materials"][0]["form"], "paper 6×64² linear:8");
    assert_eq!(images["materials"][0]["kib"], 72.0);
    assert_eq!(all["core"], Value::Null);
    assert_eq!(all["kept"], Value::Null, "there is no budget");
    let linear = images["psnr"].as_f64().unwrap();
    assert!((25.0..50.0).contains(&linear), "{linear}");
    for only in ["exact", "core", "difference"] {
        scratch.run(&format!("render mixed.toml --only {only} --out {only}.png")).succeeds();
    }
    assert_ne!(scratch.read("exact.png"), scratch.read("core.png"));
    // A core draws the floor's highlights; the gold stays.
    let core = json(&scratch, "render mixed.toml --method table --out table.png --json");
    assert_eq!(core["core"]["difference"]["max_steps"], images["difference"]["max_steps"]);
    let rough = json(&scratch, "render mixed.toml --method quadratic --output-fraction 4 --out rough.png --json");
    assert!(rough["core"]["difference"]["mean_steps"].as_f64() > images["difference"]["mean_steps"].as_f64());
    // With a budget it is judged.
    scratch.write("strict.toml", format!("{MIXED}[budget]\nmax_steps = 0\n"));
    scratch.run("render strict.toml --out strict.png").ends_with(1);
    // Measured: nothing is off.
    scratch.write("measured.toml", MIXED.replace("model = ", "shading = \"measured\"\nmodel = "));
    let measured = json(&scratch, "render measured.toml --out measured.png --json");
    assert_eq!(measured["images"]["difference"]["max_steps"], 0);
    assert_eq!(measured["images"]["psnr"], Value::Null);
}

#[test]
fn forms_are_compared_on_a_sheet() {
    let scratch = Scratch::new();
    scratch.write("mixed.toml", MIXED);
    let sheet = json(&scratch, "render mixed.toml --compare --out sheet.png --json");
    let name = |place: usize| sheet["forms"][place]["name"].as_str().unwrap().to_owned();
    let value = |place: usize, key: &str| sheet["forms"][place][key].as_f64().unwrap();
    assert_eq!(
        (0..5).map(name).collect::<Vec<_>>(),
        [
            "paper 4×512² linear:8",
            "paper 6×512² linear:8",
            "half 16×32² sqrt:8",
            "bivariate 32² sqrt:8",
            "fitted cos^n, 1 lobe"
        ]
    );
    assert_eq!([value(0, "kib"), value(1, "kib"), value(2, "kib"), value(3, "kib")], [3072.0, 4608.0, 48.0, 3.0]);
    assert!(value(4, "kib") < 0.1);
    let [four, six, half, bivariate, fitted] = [0, 1, 2, 3, 4].map(|place| value(place, "psnr"));
    assert!(
        six > four && half > six && bivariate > fitted && half > fitted + 8.0,
        "{four} {six} {half} {bivariate} {fitted}"
    );
    let own = json(
        &scratch,
        "render mixed.toml --compare=half:images=8:size=16:texel=sqrt:6,fit:lobes=2 --out own.png --json",
    );
    assert_eq!(own["forms"][0]["name"], "half 8×16² sqrt:6");
    assert_eq!(own["forms"][1]["name"], "fitted cos^n, 2 lobes");
    for (list, words) in [
        ("paper:pictures=4", ["no key `pictures`", "images, size, texel"]),
        ("papier", ["no form `papier`", "paper"]),
        ("fit:lobes=9", ["lobes=9", "1 to 3"]),
        ("half:size=1", ["size 1 is out of range", "2 to 4096"]),
        ("half --method cubic", ["cannot be used with", "--method"]),
    ] {
        scratch.refused(&format!("render mixed.toml --compare={list} --out no.png"), &words);
    }
    assert!(!scratch.files("").iter().any(|file| file == "no.png"));
}

#[test]
fn a_reflectance_becomes_a_classical_material() {
    let scratch = Scratch::new();
    scratch.write("mixed.toml", MIXED);
    scratch.write("classical.toml", format!("shading = \"classical\"\nmodel = \"blinn\"\n{MIXED}"));
    let scene = Scene::read(&scratch.path("classical.toml")).unwrap();
    assert!(!scene.is_measured());
    let gold = &scene.materials[0];
    let fitted = {
        let model = Model::named("gold-paint").unwrap();
        let exposure = measure::exposure(&model as &dyn Reflectance);
        let cosine = brdfgen::reflectance::classical::Cosine::Blinn;
        brdfgen::reflectance::classical::fit(&model, cosine, 1, exposure, &|| ()).unwrap().material
    };
    assert_eq!(gold.shininess, fitted.lobes[0].n);
    assert!(gold.diffuse.is_some_and(|kd| (kd - fitted.kd.into_iter().fold(0.0, f64::max)).abs() < 1e-12));
    // It gets a core and a shader; the reflectance itself does not.
    scratch.run("generate classical.toml --out core").ends_with(0);
    scratch.refused(
        "generate mixed.toml --block shader --out shader",
        &["drawn by a reflectance", "shading = \"classical\""],
    );
    scratch.run("generate mixed.toml --out floor").ends_with(0);
    let only = MIXED.replace("material = \"floor\"", "material = \"gold\"");
    scratch.write("only.toml", &only);
    scratch.refused("generate only.toml --out none", &["none asks for a lobe"]);
    scratch.refused("render only.toml --method cubic --out none.png", &["drawn by a reflectance"]);
    scratch.run("render only.toml --out only.png").succeeds();
    // What is written of the classical material holds.
    let own = Compared::parse("fit").unwrap();
    assert!(matches!(own, Compared::Fit(1)));
    let written = scratch.text("classical.toml").replace("k_a = 0.1", "k_a = 0.1\nshininess = 7");
    scratch.write("written.toml", written);
    assert_eq!(Scene::read(&scratch.path("written.toml")).unwrap().materials[0].shininess, 7.0);
}

#[test]
fn tables_and_images_are_read_from_beside_the_scene() {
    let scratch = Scratch::new();
    scratch.run("reflectance convert gold.binary --model gold-paint").succeeds();
    scratch.run("reflectance images gold.binary --form half --images 16 --out slices").succeeds();
    let table = MIXED.replace("model = \"gold-paint\"", "file = \"gold.binary\"");
    scratch.write("table.toml", &table);
    scratch.write("mixed.toml", MIXED);
    let (by_table, by_model) = (
        json(&scratch, "render table.toml --out table.png --json"),
        json(&scratch, "render mixed.toml --out mixed.png --json"),
    );
    let ratio = |answer: &Value| answer["images"]["psnr"].as_f64().unwrap();
    assert!((ratio(&by_table) - ratio(&by_model)).abs() < 1.0);
    // Sphere images have no reflectance to compare with.
    let slices: String = MIXED
        .lines()
        .filter(|line| !["form", "images", "size", "texel", "border"].iter().any(|key| line.starts_with(key)))
        .map(|line| line.replace("model = \"gold-paint\"", "file = \"slices\"") + "\n")
        .collect();
    scratch.write("slices.toml", &slices);
    let own = json(&scratch, "render slices.toml --out slices.png --json");
    assert_eq!(own["images"]["difference"]["max_steps"], 0);
    assert_eq!(own["images"]["materials"][0]["form"], "half 16×32² sqrt:8");
    scratch.write("measured.toml", slices.replace("file = ", "shading = \"measured\"\nfile = "));
    scratch.refused("render measured.toml --out no.png", &["slices holds sphere images", "image-based"]);
    scratch.write("sized.toml", slices.replace("file = ", "size = 32\nfile = "));
    scratch.refused("render sized.toml --out no.png", &["size is given", "holds images already"]);
    scratch.refused("render slices.toml --compare --out no.png", &["no reflectance to make others of"]);
    // A matcap: its light is in the picture.
    scratch.write("matcap.toml", slices.replace("\"slices\"", "\"ball.png\""));
    scratch.run("render mixed.toml --size 32x32 --only exact --out ball.png").succeeds();
    scratch.run("render matcap.toml --out matcap.png").succeeds();
    // Nothing is written over what is read.
    let before = scratch.read("gold.binary");
    scratch.refused("render table.toml --out gold.binary", &["gold.binary"]);
    assert!(scratch.read("gold.binary") == before);
}

#[test]
fn wrong_scenes_are_refused() {
    let scratch = Scratch::new();
    let cases: [(&str, &str, &[&str]); 14] = [
        ("model = \"gold-paint\"", "", &["neither file nor model is given"]),
        ("model = \"gold-paint\"", "model = \"gold\"", &["no reflectance model `gold`", "presets:"]),
        ("model = \"gold-paint\"", "model = \"gold-paint\"\nfile = \"a\"", &["both file and model"]),
        ("model = \"gold-paint\"", "file = \"none.binary\"", &["cannot read", "none.binary"]),
        ("model = \"gold-paint\"", "model = \"ggx\"\nparameters = { alpha = 0 }", &["alpha = 0 is out of range"]),
        ("model = \"gold-paint\"", "model = \"ggx\"\nparameters = { beta = 1 }", &["no parameter `beta`"]),
        ("model = \"gold-paint\"", "model = \"ggx\"\nexposure = -1.0", &["exposure = -1 is out of range"]),
        ("form = \"paper\"", "form = \"paint\"", &["no form `paint`", "paper, half, bivariate"]),
        ("images = [0, 30, 60, 90, 120, 150]", "images = [0, 30, 20]", &["do not ascend"]),
        ("images = [0, 30, 60, 90, 120, 150]", "images = 0", &["images `0`"]),
        ("size = 64", "size = 1000000", &["size 1000000 is out of range"]),
        ("texel = \"linear:8\"", "texel = \"linear:99\"", &["no texel"]),
        ("border = \"extend\"", "border = \"wide\"", &["no border"]),
        (
            "shininess = 3",
            "shininess = 3\nshading = \"measured\"",
            &["material floor has a shading and no reflectance"],
        ),
    ];
    for (from, to, words) in cases {
        assert!(MIXED.contains(from), "{from}");
        scratch.write("wrong.toml", MIXED.replacen(from, to, 1));
        scratch.refused("render wrong.toml --out no.png", words);
    }
    scratch.write("wrong.toml", MIXED.replace("border = ", "bordre = "));
    scratch.refused("render wrong.toml --out no.png", &["bordre", "wrong.toml"]);
}

#[test]
fn the_scenes_of_the_paper_are_drawn() {
    for (name, materials, lights, least) in [("materials", 5, 1, 33.0), ("gold", 1, 4, 33.0), ("skydome", 2, 64, 40.0)]
    {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name).with_extension("toml");
        let scene = Scene::read(&path).unwrap().resized(96, 64);
        assert_eq!((scene.measured().count(), scene.lights.len()), (materials, lights), "{name}");
        let (frame, exact) = channels(&scene, &scene.exact_looks().unwrap());
        let (_, own) = channels(&scene, &scene.own_looks().unwrap());
        let ratio = psnr(&frame, &exact, &own).unwrap();
        assert!(ratio > least, "{name}: {ratio}");
        // Neither black nor white.
        let seen: Vec<f64> = exact.iter().map(|pixel| pixel[0].clamp(0.0, 1.0)).collect();
        let mean = seen.iter().sum::<f64>() / seen.len() as f64;
        assert!((0.05..0.8).contains(&mean), "{name}: {mean}");
    }
}
