//! The whole shader of a scene: its picture by the bit-exact model against the exact picture.

use std::path::Path;

use brdfgen::core::{BlockDesign, Design};
use brdfgen::scene::highlight::Exact;
use brdfgen::scene::trace::Tracer;
use brdfgen::scene::{Difference, Frame, Highlights, Requirements, Scene, shade};
use brdfgen::spec::{Front, ShaderFields, SpecFields};

use crate::common::Scratch;

const SCENE: &str = "
width = 96
height = 64
shadows = true
[camera]
position = [0, 1, 6]
target = [0, 0.4, 0]
[[material]]
name = 'floor'
shininess = 4
specular = 0
[[material]]
name = 'red'
shininess = 12.5
colour = [0.9, 0.2, 0.1]
[[material]]
name = 'steel'
shininess = 300
diffuse = 0.2
specular = 0.7
[[material]]
name = 'nowhere'
shininess = 900
[[light]]
direction = [1, 2, 3]
colour = [1, 0.9, 0.8]
intensity = 0.6
[[light]]
position = [-3, 4, 2]
intensity = 0.3
[[object]]
kind = 'plane'
material = 'floor'
point = [0, -1, 0]
normal = [0, 1, 0]
[[object]]
kind = 'sphere'
material = 'red'
centre = [-1.1, 0, 0]
radius = 1
[[object]]
kind = 'sphere'
material = 'steel'
centre = [1.1, 0, 0]
radius = 1
";

fn scene(model: &str) -> Scene {
    Scene::parse(&format!("model = '{model}'\n{SCENE}"), "test.toml", Path::new(".")).unwrap()
}

fn lobe(text: &str) -> SpecFields {
    SpecFields::parse(text, "lobe").unwrap()
}

/// The shader of a scene around a lobe, its picture's difference from the exact one, and the samples that went through
/// it.
fn through(scene: &Scene, lobe: &SpecFields, asked: &ShaderFields) -> (Design, Difference, u64) {
    let requirements = Requirements::of(scene, 0.0, &|_, _| {}).unwrap();
    let spec = shade::spec(scene, &requirements, lobe, asked).and_then(SpecFields::resolve).unwrap();
    let design = Design::new(spec).unwrap();
    let tracer = Tracer::new(scene);
    let BlockDesign::Shader(shader) = design.block() else { panic!("a shader") };
    let (picture, samples) = shade::picture(shader, scene, &tracer, &|| {}).unwrap();
    let frame = Frame::trace(&tracer, scene, &|| {});
    let exact = frame.picture(scene, &Exact.of(scene, &frame).unwrap());
    (design, Difference::of(&exact, &picture), samples)
}

#[test]
fn the_shader_draws_the_scene_within_a_step() {
    let fine = lobe("method = 'log-exp'\ninput_fraction = 18\noutput_fraction = 12");
    for (model, front) in [("phong", None), ("blinn", Some(Front::Half)), ("blinn", Some(Front::Sqrt))] {
        let scene = scene(model);
        let asked = ShaderFields { front, vector_fraction: Some(18), ..ShaderFields::default() };
        let (design, difference, samples) = through(&scene, &fine, &asked);
        assert_eq!(design.lobe().interface.shininess.rows(), 3, "the material that no object has is left out");
        assert!(samples > 3000 && difference.max_steps <= 1, "{model} {front:?}: {samples}, {difference:?}");
        assert!(difference.pixels[0] > samples / 2, "{model} {front:?}: {:?}", difference.pixels);
    }
}

#[test]
fn what_the_lobe_and_the_vectors_lose_is_seen() {
    let scene = scene("blinn");
    let fine = lobe("method = 'log-exp'\ninput_fraction = 18\noutput_fraction = 12");
    let steps = |lobe: &SpecFields, vector_fraction: u32| {
        let asked = ShaderFields { vector_fraction: Some(vector_fraction), ..ShaderFields::default() };
        through(&scene, lobe, &asked).1.max_steps
    };
    let [well, coarse, rough] = [steps(&fine, 18), steps(&fine, 8), steps(&lobe("method = 'quadratic'"), 18)];
    assert!(
        well <= 1 && coarse > well && rough > 10,
        "{well}, with coarse vectors {coarse}, with a rough lobe {rough}"
    );
}

#[test]
fn the_scene_itself_says_what_is_in_it() {
    let scene = scene("phong");
    let requirements = Requirements::of(&scene, 0.0, &|_, _| {}).unwrap();
    let asked = ShaderFields { lights: Some(3), ..ShaderFields::default() };
    let error = shade::spec(&scene, &requirements, &lobe("method = 'quadratic'"), &asked).unwrap_err();
    assert!(error.to_string().contains("the scene says itself"), "{error}");
}

#[test]
fn a_scene_becomes_a_shader_with_its_documents() {
    let scratch = Scratch::new();
    let small = SCENE.replace("width = 96", "width = 36").replace("height = 64", "height = 24");
    scratch.write("two.toml", format!("model = 'blinn'\n{small}"));
    let run = scratch.run("generate two.toml --block shader --method power-8 --margin 2 --out made").succeeds();
    run.says(&["the shader around it: vectors of ", "samples through its bit-exact model"]);
    scratch.run("generate two.toml --block shader --method power-8 --margin 2 --out made --check").succeeds();
    let core = scratch.text("made/core.toml");
    assert!(core.contains("block = \"shader\"") && core.contains("lights = 2") && !core.contains("nowhere"), "{core}");
    let json: serde_json::Value = serde_json::from_str(&scratch.text("made/scene.json")).unwrap();
    assert_eq!(json["port"], "in_material");
    assert_eq!(json["materials"][3]["code"], serde_json::Value::Null, "an object that is not there");
    for pictures in ["base", "moved"] {
        assert!(json["shader"][pictures]["max_steps"].as_u64().unwrap() <= 1, "{}", json["shader"]);
    }
    let sheet = scratch.text("made/scene.md");
    assert!(sheet.contains("the shader of a scene") && sheet.contains("L = -N"), "{sheet}");
    scratch
        .refused("generate two.toml --lights 3 --method power-8 --out x", &["keys of a shader are given for a lobe"]);
    let lights = "generate two.toml --block shader --lights 3 --method power-8 --out x";
    scratch.refused(lights, &["the scene says itself"]);
    // Vectors this coarse cannot keep the budget.
    let coarse = "generate two.toml --block shader --vector-fraction 8 --method power-8 --out x";
    scratch.run(coarse).ends_with(1);
    assert!(!scratch.path("x").exists());
}

/// What a name may hold at worst: markup and HTML, the ends of comments and of strings in every language that is
/// written.
const HOSTILE: [&str; 2] = [r#"<b>&"m|x"#, r#"a`b` *c* [d](e) */ (* -- // ; % ' $(f) {g} \"#];

/// Every table of a Markdown text has rows of as many cells, and no HTML is in it outside of code.
fn is_plain_markdown(what: &str, text: &str) {
    let mut columns = None;
    for line in text.lines() {
        let mut plain = String::new();
        let (mut escaped, mut code, mut cells) = (false, false, 0);
        for c in line.chars() {
            match c {
                _ if escaped => escaped = false,
                '\\' if !code => escaped = true,
                '`' => code = !code,
                '|' => cells += 1,
                _ if !code => plain.push(c),
                _ => {}
            }
        }
        assert!(!plain.contains("<b>"), "{what}: {line}");
        if line.starts_with('|') {
            assert_eq!(*columns.get_or_insert(cells), cells, "{what}: {line}");
        } else {
            columns = None;
        }
    }
}

/// The files of a core in a directory, each by its own grammar.
fn are_well_formed(scratch: &Scratch, core: &str) {
    let spec = SpecFields::read(&scratch.path(format!("{core}/core.toml"))).unwrap();
    let own: Vec<String> = spec.material.iter().flatten().map(|material| material.name.clone()).collect();
    assert_eq!(own, HOSTILE, "{core}: the names come back from the spec");
    let mut read = 0;
    for file in scratch.files(core) {
        let path = format!("{core}/{file}");
        match Path::new(&file).extension().and_then(|extension| extension.to_str()) {
            Some("md") => is_plain_markdown(&path, &scratch.text(&path)),
            Some("json") => drop(serde_json::from_slice::<serde_json::Value>(&scratch.read(&path)).unwrap()),
            Some("v" | "vhd" | "mem" | "vec" | "core" | "f" | "h" | "csv" | "coe" | "mif") => {
                assert!(scratch.read(&path).is_ascii(), "{path} is not ASCII");
            }
            _ => continue,
        }
        read += 1;
    }
    assert!(read > 5, "{core}: {read} files");
    scratch.run(&format!("generate {core} --out {core} --check")).succeeds();
    for sim in ["icarus", "ghdl"] {
        scratch.run(&format!("cosim {core} --sim {sim}")).succeeds();
    }
}

#[test]
fn names_of_the_user_are_text_in_every_file() {
    let scratch = Scratch::new();
    let quoted = HOSTILE.map(|name| format!("'''{name}'''"));
    let material =
        |(place, name): (usize, &String)| format!("[[material]]\nname = {name}\nshininess = {}\n", 5 + 7 * place);
    let materials: String = quoted.iter().enumerate().map(material).collect();
    let common = "method = 'quadratic'\ninput_fraction = 8\noutput_fraction = 8\nrom_formats = ['mem', 'coe', 'mif', \
     'c', 'csv', 'vhdl']\n";
    scratch.write("lobe.toml", format!("name = 'lobe'\n{common}{materials}"));
    scratch.run("generate lobe.toml --out lobe").succeeds();
    are_well_formed(&scratch, "lobe");
    let sheet = scratch.text("lobe/README.md");
    assert!(sheet.contains("| 0 | &lt;b&gt;&amp;\"m\\|x | 5 |"), "{sheet}");
    // Without the shape of files for its memories, of which a shader has several.
    let common = common.replace(", 'coe', 'mif', 'c', 'csv', 'vhdl'", "");
    scratch.write(
        "shader.toml",
        format!("name = 'whole'\nblock = 'shader'\n{common}{materials}[shader]\nvector_fraction = 8\n"),
    );
    scratch.run("generate shader.toml --out shader").succeeds();
    are_well_formed(&scratch, "shader");

    let object = |(place, name): (usize, &String)| {
        format!("[[object]]\nkind = 'sphere'\nmaterial = {name}\nradius = 0.7\ncentre = [{place}, 0, 0]\n")
    };
    let objects: String = quoted.iter().enumerate().map(object).collect();
    let top = "width = 24\nheight = 16\n[camera]\nposition = [0.5, 0, 5]\n[[light]]\ndirection = [1, 1, \
     2]\n[budget]\nmax_steps = 8\n";
    scratch.write("scene.toml", format!("{top}{materials}{objects}"));
    scratch.run("generate scene.toml --margin 0 --method power-4 --out picture").succeeds();
    are_well_formed(&scratch, "picture");
    let sheet = scratch.text("picture/scene.md");
    assert!(sheet.contains("| &lt;b&gt;&amp;\"m\\|x | 5 |"), "{sheet}");
    scratch.run("report --scene scene.toml --out page.html").succeeds();
    let page = scratch.text("page.html");
    assert!(!page.contains("<b>&") && page.matches("m|x").count() > 1, "a name is live in the page");
}
