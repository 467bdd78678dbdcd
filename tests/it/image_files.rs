//! Image-based cores of a measured reflectance: made of a table or of images, made again without them.

use std::fs;

use brdfgen::core::Design;
use brdfgen::reflectance::{Model, Table, merl};
use brdfgen::spec::{CoreSpec, ReflectanceFields, SpecFields};

use crate::common::Scratch;
use crate::common::core::resolved;

/// A block that is made in no time.
const SMALL: &str = "--block image --images 4 --image-size 8";

/// A table of GGX as `table.binary`.
fn with_table() -> Scratch {
    let mut model = Model::named("ggx").expect("a model");
    model.set("alpha", "0.3").expect("a parameter");
    let table = Table::sampled(&model, 180).expect("a table");
    let scratch = Scratch::new();
    scratch.write("table.binary", merl::bytes(&table));
    scratch
}

/// The spec of a small block of a file.
fn spec_of(scratch: &Scratch, file: &str, keys: &str) -> String {
    let file = scratch.path(file);
    format!("block = 'image'\nimages = 4\nimage_size = 8\n[reflectance]\nfile = '{}'\n{keys}", file.display())
}

/// The images of the table as a directory.
fn images(scratch: &Scratch, keys: &str, out: &str) {
    scratch.run(&format!("reflectance images table.binary {keys} --out {out}")).succeeds();
}

/// The core of a table is made again from what it holds, byte for byte, wherever it lies, and its vectors are the same;
/// nothing of the table's path is in it.
#[test]
fn a_core_of_a_table_is_made_again_without_it() {
    let scratch = with_table();
    for (name, keys) in [
        ("image_half", SMALL.to_owned()),
        ("image_bivariate", "--block image --image-form bivariate --image-size 8 --octaves 4".to_owned()),
    ] {
        let run = scratch.run(&format!("generate {keys} --reflectance-file table.binary --out {name}")).succeeds();
        run.says(&["against the stored samples", "against the table itself"]);
    }
    // In a spec file the path starts from there.
    scratch.write("folder/spec.toml", "[reflectance]\nfile = '../table.binary'");
    scratch.run(&format!("generate folder/spec.toml {SMALL} --check --out image_half")).succeeds();
    fs::remove_file(scratch.path("table.binary")).expect("removed");
    for name in ["image_half", "image_bivariate"] {
        let made = scratch.tree(name);
        let half = [
            // In its own place.
            "generate image_half --out image_half",
            "golden image_half --check image_half/golden/image_half.vec",
            "rom image_half --out rom",
        ];
        let lines = [format!("generate {name}/core.toml --out again"), format!("image lights {name} --light 60,20")];
        let half = half.into_iter().filter(|_| name == "image_half").map(str::to_owned);
        for line in lines.into_iter().chain(half) {
            let run = scratch.run(&line).succeeds();
            assert!(!run.stdout.contains("table itself"), "{}", run.stdout);
        }
        assert_eq!(scratch.tree("again"), made);
        assert_eq!(scratch.tree(name), made);
        for (path, bytes) in made.iter().filter_map(|(path, bytes)| Some((path, bytes.as_ref()?))) {
            let text = String::from_utf8_lossy(bytes);
            let folder = scratch.path("").display().to_string();
            assert!(!text.contains("table.binary") && !text.contains(&folder), "{}", path.display());
        }
        let manifest = String::from_utf8(scratch.read(format!("{name}/manifest.json"))).expect("text");
        for file in ["reflectance/images.toml\": \"", "reflectance/000_phi_0.exr\": \"", "\"of_samples\": true"] {
            assert!(manifest.contains(file), "{file}");
        }
        let sheet = String::from_utf8(scratch.read(format!("{name}/README.md"))).expect("text");
        for words in
            ["image-based block of a measured reflectance", "brdfgen generate core.toml", "the stored\nsamples"]
        {
            assert!(sheet.contains(words), "{words}");
        }
        assert!(!sheet.contains("| method:"), "{sheet}");
        fs::remove_dir_all(scratch.path("again")).expect("removed");
    }
}

/// Images at the block's own places make the very core of their table: floating-point ones the same bytes, codes of as
/// many bits the same texels. An exposure of its own is kept, and another one scales.
#[test]
fn images_that_fit_make_the_core_of_their_table() {
    let scratch = with_table();
    images(&scratch, "--form half --images 4 --size 8 --texel float", "float");
    images(&scratch, "--form half --images 4 --size 8", "codes");
    for (file, out) in [("table.binary", "own"), ("float", "same")] {
        scratch.run(&format!("generate {SMALL} --reflectance-file {file} --out {out}")).succeeds();
    }
    assert_eq!(scratch.tree("own"), scratch.tree("same"));
    let own = CoreSpec::read(&scratch.path("own")).expect("its spec");
    let coded = resolved(&spec_of(&scratch, "codes", ""));
    let tables = |spec: &CoreSpec| Design::new(spec.clone()).expect("a core").tables().to_vec();
    assert_eq!(tables(&own), tables(&coded));
    assert_ne!(own.digest(), coded.digest());

    scratch.run("generate same --exposure 1.5 --out scaled").succeeds();
    scratch.run("generate scaled --check --out scaled").succeeds();
    let spec = String::from_utf8(scratch.read("scaled/core.toml")).expect("text");
    assert!(spec.contains("exposure = 1.5\n"), "{spec}");
    // A model or another file takes the place of a core's own.
    let with = |reflectance: ReflectanceFields| {
        let scaled = SpecFields::read(&scratch.path("scaled")).expect("its spec");
        SpecFields { reflectance, ..SpecFields::default() }.or(scaled).resolve().expect("a spec")
    };
    let file = Some(scratch.path("float").display().to_string());
    assert_eq!(with(ReflectanceFields { file, ..ReflectanceFields::default() }), own);
    let model = with(ReflectanceFields { model: Some("ggx".to_owned()), ..ReflectanceFields::default() });
    assert!(!model.to_toml().contains("digest") && !model.to_toml().contains("exposure = 1.5"), "{}", model.to_toml());
    // Where what reflects is a file, the flags say the core's own.
    let flags = SpecFields::read(&scratch.path("scaled")).and_then(SpecFields::resolve).expect("a spec").flags();
    assert_eq!(flags[..2], ["--block image", "--reflectance-file reflectance"]);
    assert!(flags.contains(&"--image-size 8".to_owned()) && !flags.iter().any(|flag| flag.contains("--texel-bits")));
}

/// A core whose samples were changed is not made again, whatever of them was.
#[test]
fn changed_samples_are_refused() {
    let scratch = with_table();
    scratch.run(&format!("generate {SMALL} --reflectance-file table.binary --out core")).succeeds();
    let (first, second) = ("core/reflectance/000_phi_0.exr", "core/reflectance/001_phi_58.667.exr");
    let index = "core/reflectance/images.toml";
    let picture = scratch.read(first);
    scratch.write(first, scratch.read(second));
    scratch.refused("generate core --out again", &["core/reflectance have the digest", "restore them"]);
    scratch.refused("golden core --check core/golden/image_half.vec", &["core/reflectance have the digest"]);
    scratch.write(first, &picture[..picture.len() / 2]);
    scratch.refused("generate core --out again", &["000_phi_0.exr", "cannot be read"]);
    scratch.write(first, &picture);
    let text = String::from_utf8(scratch.read(index)).expect("text");
    let line = text.lines().find(|line| line.starts_with("exposure")).expect("an exposure");
    scratch.write(index, text.replace(line, "exposure = 1.0"));
    scratch.refused("generate core --out again", &["core/reflectance have the digest"]);
    scratch.write(index, text.replace("caps = [1.0]", "caps = [2.0]"));
    scratch.refused("generate core --out again", &["core/reflectance have the digest"]);
    scratch.write(index, text.replace("000_phi_0.exr", "010_phi_0.exr"));
    scratch.refused("generate core --out again", &["lists 010_phi_0.exr, which is not there"]);
    scratch.write(index, &text);
    scratch.run("generate core --check --out core").succeeds();
    fs::rename(scratch.path("core/reflectance"), scratch.path("elsewhere")).expect("moved");
    scratch.refused("generate core --out again", &["there is no file or directory core/reflectance", "core.toml"]);
}

/// Images at other places are refused with what is there and what would fit; so is what is no reflectance.
#[test]
fn what_does_not_fit_is_refused() {
    let scratch = with_table();
    images(&scratch, "--form half --images 8 --size 16", "eight");
    images(&scratch, "--form half --images 0,40,80,120 --size 8", "uneven");
    images(&scratch, "--form paper --images 4 --size 8", "paper");
    images(&scratch, "--form bivariate --size 8", "bivariate");
    let columns = "--block image --image-form bivariate --image-size 8 --octaves";
    scratch.run(&format!("generate {columns} 4 --reflectance-file table.binary --out core")).succeeds();
    let table = scratch.read("table.binary");
    scratch.write("cut.binary", &table[..table.len() / 2]);
    scratch.write("core.csv", "phi");
    let takes = "this block takes 4 slices of 8 × 8 texels, evenly from 0 to 176 degrees";
    for (keys, file, words) in [
        (SMALL, "eight", ["8 slices of 16 × 16 texels", takes, "--images 8 --image-size 16"]),
        (
            SMALL,
            "uneven",
            ["4 slices of 8 × 8 texels at 0, 40, 80, 120 degrees", takes, "--form half --images 4 --size 8"],
        ),
        (
            SMALL,
            "paper",
            [
                "4 sphere images of 8 × 8 texels lit from 0, 45, 90, 135 degrees, with the border shrink",
                takes,
                "reflectance images",
            ],
        ),
        (SMALL, "core/reflectance", ["along 4 octaves", takes, "--image-form bivariate --octaves 4 --image-size 8"]),
        (SMALL, "cut.binary", ["17496006 bytes", "cut short", "34992012 bytes"]),
        (SMALL, "core.csv", ["core.csv has 3 bytes", "MERL", "table"]),
        (SMALL, "eight/000_phi_0.png", ["is a picture, a matcap", "MERL table", "--image-form matcap"]),
        (SMALL, "nothing", ["there is no file or directory nothing", "MERL table", "sphere images"]),
        (
            &format!("{columns} 4"),
            "bivariate",
            ["along the root of θh", "along 4 octaves of 1 - n.h", "give the table"],
        ),
        (&format!("{columns} 2"), "core/reflectance", ["along 4 octaves", "along 2 octaves", "--octaves 4"]),
        (&format!("{columns} 4"), "eight", ["8 slices", "along 4 octaves", "--image-form half --images 8"]),
    ] {
        scratch.refused(&format!("generate {keys} --reflectance-file {file} --out no"), &words);
    }
    for (keys, words) in [
        ("--reflectance-file eight --reflectance ggx", "both file and model are given"),
        ("--reflectance-file eight --parameters alpha=0.3", "a file has no parameters"),
        (
            "--reflectance-file eight --images 8 --image-size 16 --lookup nearest",
            "lookup is given, and eight holds images",
        ),
        ("--reflectance ggx --lookup nearest", "lookup is given for a model"),
        ("--reflectance ggx --reflectance-digest 12", "digest is given for a model"),
        ("--reflectance-file table.binary --exposure 0", "exposure = 0 is out of range"),
        ("--reflectance-file table.binary --exposure 1e300", "too large for 32 bits"),
        ("--reflectance-file table.binary --reflectance-digest 12", "table.binary have the digest"),
        ("", "no reflectance is given"),
    ] {
        let block = if keys.contains("--images") { "--block image" } else { SMALL };
        scratch.refused(&format!("generate {block} {keys} --out no"), &[words]);
    }
    // Only the block knows the columns along octaves.
    scratch.refused("reflectance info core/reflectance", &["along octaves of 1 - n.h"]);
    let index = String::from_utf8(scratch.read("eight/images.toml")).expect("text");
    scratch.write("eight/images.toml", index.replace("size = 16", "size = 16\noctaves = 4"));
    scratch.refused("reflectance info eight", &["images.toml: octaves of the form `half`"]);
}

/// A table may be looked up by its cells.
#[test]
fn the_lookup_of_a_table_is_chosen() {
    let scratch = with_table();
    let spec = |lookup: &str| resolved(&spec_of(&scratch, "table.binary", &format!("lookup = '{lookup}'")));
    let [one, other, again] = ["trilinear", "nearest", "trilinear"].map(spec);
    assert_eq!(one, again);
    assert_ne!(one, other);
    assert_ne!(one.digest(), other.digest());
    assert!(!one.to_toml().contains("lookup"), "{}", one.to_toml());
}
