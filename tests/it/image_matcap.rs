//! Image-based cores of the form matcap: a picture of a sphere with its light in it.
//!
//! Needs iverilog, ghdl and yosys; `test.sh` installs them.

use std::fs;

use brdfgen::block::image::{FrontEnd, Image, ImageForm, ImageSamples};
use brdfgen::core::{BlockDesign, Design, Direction, ImageDesign};
use brdfgen::fixed::{Rng, exp2};
use brdfgen::reflectance::{images, matcap};
use brdfgen::spec::SpecFields;
use brdfgen::verify::cosim::Sim;
use brdfgen::verify::faults::{Tally, mutants, outcomes};
use brdfgen::verify::golden::Golden;
use rayon::prelude::*;

use crate::common::Scratch;
use crate::common::core::{Generated, design, ecp5_cells};
use crate::common::matcap::{picture, spec, specs, studio};

fn image(design: &Design) -> ImageDesign<'_> {
    match design.block() {
        BlockDesign::Image(image) => image,
        _ => panic!("an image-based block"),
    }
}

/// The texels' codes of a matcap, row by row from the bottom, as its memories hold them.
fn texels(design: &Design) -> Vec<[f64; 3]> {
    let size = image(design).of.image.size as usize;
    let texel = |place: usize| {
        let (y, x) = (place / size, place % size);
        let table = &design.tables()[2 * (y % 2) + x % 2];
        let address = y / 2 * (size / 2) + x / 2;
        [0, 1, 2].map(|c| table.fields[c].codes[address] as f64)
    };
    (0..size * size).map(texel).collect()
}

/// What a matcap is by its formula: the square of the bilinear blend of its texels where x and y are, in codes that are
/// not rounded.
fn formula(image: &Image, texels: &[[f64; 3]], [x, y]: [f64; 2]) -> [f64; 3] {
    let size = image.size as usize;
    let steps = exp2(image.weight_bits as i32);
    let place = |component: f64| {
        let place = ((component + 1.0) / 2.0 * size as f64 - 0.5) * steps;
        ((place + 0.5).floor() / steps).clamp(0.0, (size - 1) as f64)
    };
    let [u, v] = [x, y].map(place);
    let at = |x: f64, y: f64, c: usize| {
        let near = |place: f64| (place as usize).min(size - 1);
        texels[near(y) * size + near(x)][c]
    };
    let full = exp2(image.texel_bits as i32) - 1.0;
    [0, 1, 2].map(|c| {
        let row = |y: f64| at(u, y, c) * (1.0 - u.fract()) + at(u + 1.0, y, c) * u.fract();
        let blend = row(v) * (1.0 - v.fract()) + row(v + 1.0) * v.fract();
        (blend / full).powi(2) * image.full_scale() as f64
    })
}

/// Every place of small cores, and every one of a row, a column and many between of greater ones; places beside the
/// sphere and codes that no normal has: the operations are the model, and both are the formula to what is rounded down.
#[test]
fn every_place_is_the_formula() {
    for spec in specs() {
        let design = design(&spec);
        let own = image(&design);
        let asked = &own.of.image;
        let (texels, lsb) = (texels(&design), exp2(-(asked.vector_fraction as i32)));
        let parts = 1u64 << asked.weight_bits;
        let count = u64::from(asked.size - 1) * parts + 1;
        let step = if count > 300 { 7 } else { 1 };
        let places = (0..count).step_by(step).flat_map(|y| (0..count).step_by(step).map(move |x| [y, x]));
        let mut inputs: Vec<Vec<i64>> = places.map(|places| own.at_texels(&places)).collect();
        let mut rng = Rng::new(11);
        inputs.extend((0..4000).map(|_| own.varied(&mut rng)));
        let worst = inputs.par_iter().map(|inputs| {
            let outputs = design.graph().results(design.tables(), inputs);
            assert_eq!(outputs, design.evaluate(inputs), "{spec}: {inputs:?}");
            let exact = formula(asked, &texels, [inputs[0] as f64 * lsb, inputs[1] as f64 * lsb]);
            (0..3).map(|c| (outputs[c] as f64 - exact[c]).abs()).fold(0.0, f64::max)
        });
        // Rounded to the nearest, but for an eighth of a code where the greatest texel is not quite 1, a sixteenth of
        // each blend and each step towards 1, and a 32nd of the square.
        let most = 0.5 + 0.125 + 3.0 / 16.0 + 1.0 / 32.0;
        let worst = worst.reduce(|| 0.0, f64::max);
        println!("{worst:.4} of {most} codes");
        assert!(worst < most, "{spec}: {worst}");
        // Each channel's brightest texel is exact where it is full.
        let white = texels.iter().position(|texel| texel[0] == exp2(asked.texel_bits as i32) - 1.0);
        if let Some(white) = white {
            let size = asked.size as usize;
            let at = own.at_texels(&[(white / size) as u64 * parts, (white % size) as u64 * parts]);
            assert_eq!(design.evaluate(&at)[0], asked.full_scale());
        }
    }
}

/// Texels are the roots of the picture's means; +x is to the right of the picture and +y at its top, and a normal that
/// is turned away is seen where its x and y are.
#[test]
fn texels_are_the_picture() {
    let design = design(&spec(64, "image_size = 16"));
    let texels = texels(&design);
    let inside = |place: usize| {
        let (x, y) = ((2 * (place % 16)).abs_diff(15), (2 * (place / 16)).abs_diff(15));
        (x + 1).pow(2) + (y + 1).pow(2) < 15 * 15
    };
    let at = |place: f64| (2.0 * place + 1.0) / 64.0 - 1.0;
    let mut compared = 0;
    for place in (0..256).filter(|&place| inside(place)) {
        let (first_x, first_y) = (4 * (place % 16), 4 * (place / 16));
        let mut mean = [0.0; 3];
        for pixel in 0..16 {
            let own = studio(at((first_x + pixel % 4) as f64), at((first_y + pixel / 4) as f64));
            (0..3).for_each(|c| mean[c] += own[c].min(1.0) / 16.0);
        }
        for c in 0..3 {
            let code = 255.0 * mean[c].sqrt();
            assert!((texels[place][c] - code).abs() < 0.51, "{place}: {} {code}", texels[place][c]);
        }
        compared += 1;
    }
    assert!(compared > 120, "{compared}");

    let scratch = Scratch::new();
    scratch.write("sides.png", picture(32, |x, y| [f64::from(x > 0.0), f64::from(y > 0.0), 0.25]));
    let file = scratch.path("sides.png");
    let sides = self::design(&format!(
        "block = 'image'\nimage_form = 'matcap'\nimage_size = 8\nreflectance = {{ file = '{}' }}",
        file.display()
    ));
    let shown = |x: f64, y: f64| sides.evaluate(&[x, y].map(|value| (value * exp2(16)) as i64));
    for (x, y, colour) in [
        (0.6, 0.6, [255, 255]),
        (-0.6, 0.6, [0, 255]),
        (0.6, -0.6, [255, 0]),
        (-0.99, -0.4, [0, 0]),
        (1.9, -1.9, [255, 0]),
    ] {
        assert_eq!(shown(x, y)[..2], colour, "{x} {y}");
        // The root of a quarter is half of the codes, to the nearest of a texel's.
        assert!((63..=65).contains(&shown(x, y)[2]), "{:?}", shown(x, y));
    }
    let names: Vec<&str> = sides.numbers(Direction::In).into_iter().map(|(name, _)| name).collect();
    assert_eq!(names, ["in_nx", "in_ny"]);
}

/// Nothing of what is beside the sphere is seen: a white one on black is white for all codes of the ports, whatever the
/// sizes.
#[test]
fn nothing_beside_the_sphere_is_seen() {
    let scratch = Scratch::new();
    let white = |x: f64, y: f64| [f64::from(x * x + y * y <= 1.0); 3];
    for (pixels, size) in [(8, 8), (24, 8), (100, 64), (64, 64), (65, 32)] {
        // A pixel that the rim cuts is grey, as in a drawn picture.
        let grey = |x: f64, y: f64| {
            let off = |place: usize| ((place as f64 + 0.5) / 4.0 - 1.0) / pixels as f64;
            let all = (0..64).map(|part| white(x + off(part % 8), y + off(part / 8))[0]);
            [all.sum::<f64>() / 64.0; 3]
        };
        scratch.write("white.png", picture(pixels, grey));
        let design = design(&format!(
            "block = 'image'\nimage_form = 'matcap'\nimage_size = {size}\nreflectance = {{ file = '{}' }}",
            scratch.path("white.png").display()
        ));
        assert!(texels(&design).iter().all(|texel| *texel == [255.0; 3]), "{pixels} {size}");
        let mut rng = Rng::new(2);
        for _ in 0..200 {
            assert_eq!(design.evaluate(&image(&design).varied(&mut rng)), [255; 3]);
        }
    }
}

/// Means over cells that share pixels keep the sum of the light, and where there are as many cells the picture stays.
#[test]
fn smaller_pictures_keep_the_light() {
    let bytes = picture(100, |x, y| [0.5 + 0.4 * x, 0.5 + 0.4 * y, (3.0 * x * y).abs()]);
    let (size, _, data) = images::read_linear(&bytes, "p").expect("a picture");
    let form = matcap::form(size, data);
    assert_eq!(matcap::samples(&form, 100, 1.0), form.texels.samples());
    let mean =
        |data: &[[f32; 3]], c: usize| data.iter().map(|pixel| f64::from(pixel[c])).sum::<f64>() / data.len() as f64;
    for smaller in [64, 32, 8] {
        let samples = matcap::samples(&form, smaller, 2.0);
        assert_eq!(samples.data.len(), smaller * smaller);
        for c in 0..3 {
            let [own, whole] = [&samples.data, &form.texels.samples().data].map(|data| mean(data, c));
            assert!((own - 2.0 * whole).abs() < 1e-5, "{smaller}: {own} {whole}");
        }
    }
    let asked = Image {
        form: ImageForm::Matcap,
        size: 64,
        texel_bits: 8,
        weight_bits: 5,
        vector_fraction: 16,
        channel_bits: 8,
        lights: 0,
        most_lights: 0,
        front_end: FrontEnd::Record,
        blend_multipliers: None,
    };
    let error = |image: &Image| ImageSamples::of_picture(image, &form, 1.0, "p").unwrap_err().to_string();
    assert!(error(&Image { size: 128, ..asked.clone() }).contains("image_size = 128 is more than the 100 × 100"));
    assert!(error(&Image { form: ImageForm::Half { slices: 4 }, ..asked }).contains("p is a picture, a matcap"));
}

/// What a matcap is not made of, and what it has no use for: one message each, and nothing is written.
#[test]
fn what_is_no_matcap_is_refused() {
    let scratch = Scratch::new();
    scratch.write("ball.png", picture(32, studio));
    scratch.write("wide.png", images::encoded([8, 4], 8, None, &[[0; 3]; 32]));
    scratch.write("tiny.png", picture(4, studio));
    scratch.write("cut.png", &picture(32, studio)[..200]);
    scratch.write("text.png", "no picture");
    scratch.run("reflectance images --model ggx --form half --images 4 --size 8 --out slices").succeeds();
    scratch
        .run("reflectance images --model ggx --form paper --images 45, --size 8 --texel float --out sphere")
        .succeeds();
    let matcap = "generate --block image --image-form matcap --image-size 8 --out no";
    for (keys, words) in [
        ("", "a matcap is asked for without a picture"),
        ("--reflectance ggx", "the model ggx is a reflectance, and a matcap is made of a picture"),
        ("--min-psnr 30", "a matcap is asked for without a picture"),
        ("--min-psnr 30 --reflectance ggx", "the model ggx is a reflectance"),
        ("--min-psnr 99 --reflectance-file ball.png", "no image-based block of these keys keeps min_psnr = 99"),
        ("--min-psnr 30 --reflectance-file slices", "min_psnr or max_error is given for images"),
        ("--reflectance-file slices", "slices holds 4 slices of 8 × 8 texels"),
        ("--reflectance-file sphere", "sphere holds 1 sphere images"),
        ("--reflectance-file nothing.png", "there is no file or directory nothing.png"),
        ("--reflectance-file wide.png", "wide.png has 8 × 4 pixels"),
        ("--reflectance-file tiny.png", "image_size = 8 is more than the 4 × 4 pixels of tiny.png"),
        ("--reflectance-file cut.png", "cut.png: the picture cannot be read"),
        ("--reflectance-file text.png", "text.png has 10 bytes"),
        ("--reflectance-file ball.png --lookup nearest", "lookup is given, and ball.png is a picture"),
        ("--reflectance-file ball.png --images 4", "images are given for a matcap"),
        ("--reflectance-file ball.png --angles 0,90", "angles are given for a form whose angles are fixed"),
        ("--reflectance-file ball.png --octaves 4", "octaves are given for a matcap"),
        ("--reflectance-file ball.png --lights-a-clock 1", "lights_a_clock is given for a matcap"),
        ("--reflectance-file ball.png --most-lights 1", "most_lights is given for a matcap"),
        ("--reflectance-file ball.png --light-source table", "light_source is given for a matcap"),
        ("--reflectance-file ball.png --light-records 1,2", "light_records is given for a matcap"),
        ("--reflectance-file ball.png --vector-bits 10 --weight-bits 8", "is needed to 2^-10, and the normal is"),
        ("--reflectance-file ball.png --exposure 0", "exposure = 0 is out of range"),
        ("--reflectance-file ball.png --reflectance-digest 12", "ball.png have the digest"),
    ] {
        scratch.refused(&format!("{matcap} {keys}"), &[words]);
    }
    for form in ["half --images 4", "bivariate", "paper"] {
        let line = format!("generate --block image --image-form {form} --reflectance-file ball.png --out no");
        scratch.refused(&line, &["ball.png is a picture, a matcap", "use --image-form matcap"]);
    }
}

/// A core is made again from what it holds, byte for byte, and every command takes it or says why not.
#[test]
fn a_matcap_is_made_again_without_its_picture() {
    let scratch = Scratch::new();
    scratch.write("ball.png", picture(60, studio));
    let keys = "--block image --image-form matcap --image-size 16 --axi-stream";
    let run = scratch.run(&format!("generate {keys} --reflectance-file ball.png --out core")).succeeds();
    run.says(&["a picture of a sphere against the stored samples", "against the picture itself"]);
    scratch.run(&format!("generate {keys} --reflectance-file ball.png --check --out core")).succeeds();
    let json = scratch.run(&format!("generate {keys} --reflectance-file ball.png --out json --json")).json();
    assert!(json["measured_against_picture"]["mean"].as_f64().expect("a ratio") > 20.0, "{json}");
    let made = scratch.tree("core");
    assert_eq!(scratch.tree("json"), made);
    fs::remove_file(scratch.path("ball.png")).expect("removed");
    for (line, words) in [
        ("generate core/core.toml --out again", "a picture of a sphere"),
        ("generate core --out core", "a picture of a sphere"),
        ("golden core --check core/golden/image_matcap.vec", "0 differences"),
        ("rom core --out rom", "texels"),
        ("cosim core --sim icarus", "PASS icarus"),
        ("stability core", "proved that no needed value overflows"),
        ("generate core --exposure 0.5 --out dark", "a picture of a sphere"),
    ] {
        let run = scratch.run(line).succeeds().says(&[words]);
        assert!(!run.stdout.contains("picture itself"), "{}", run.stdout);
    }
    assert_eq!(scratch.tree("again"), made);
    assert_eq!(scratch.tree("core"), made);
    for (path, bytes) in made.iter().filter_map(|(path, bytes)| Some((path, bytes.as_ref()?))) {
        assert!(!String::from_utf8_lossy(bytes).contains("ball.png"), "{}", path.display());
    }
    let sheet = scratch.text("core/README.md");
    for words in ["matcap of 16 x 16 texels", "a picture of a sphere with its light in it", "| arithmetic: "] {
        assert!(sheet.contains(words), "{words}");
    }
    for words in ["light", "in_last", " gain"] {
        assert!(!sheet.replace("with its light in it", "").replace("linear light", "").contains(words), "{words}");
    }
    assert!(!scratch.files("core").iter().any(|file| file.contains("_light") || file.contains("model/")));
    let dark = SpecFields::read(&scratch.path("dark")).and_then(SpecFields::resolve).expect("a spec");
    let flags = ["--block image", "--reflectance-file reflectance", "--axi-stream", "--image-form matcap"];
    assert!(flags.iter().all(|flag| dark.flags().iter().any(|own| own == flag)), "{:?}", dark.flags());
    assert!(!dark.flags().iter().any(|flag| ["--name", "--weight-bits"].iter().any(|no| flag.starts_with(no))));
    for (line, words) in [
        ("image lights core --light 60,20", "has no lights"),
        ("eval core -n 5 -x 0.5", "this core is an image-based block"),
        ("cosim core --exhaustive", "an image-based block has too many"),
        ("generate core --image-size 8 --out no", "this block takes a matcap of 8 × 8 texels"),
        ("generate --block image --reflectance-file core/reflectance --out no", "--image-form matcap --image-size 16"),
    ] {
        scratch.refused(line, &[words]);
    }
    // A sample that was changed is seen.
    let (image, index) = ("core/reflectance/000_phi_0.exr", "core/reflectance/images.toml");
    scratch.write(index, scratch.text(index).replace("exposure = 1.0", "exposure = 2.0"));
    scratch.refused("generate core --out no", &["core/reflectance have the digest"]);
    scratch.write(image, &scratch.read(image)[..50]);
    scratch.refused("generate core --out no", &["cannot be read"]);
}

/// A budget finds the fewest bits of texels with which the picture is met.
#[test]
fn a_budget_finds_the_size_of_a_matcap() {
    let smooth = picture(64, |x, y| [0.5 + 0.4 * x, 0.5 - 0.3 * y, 0.3 + 0.2 * x * y]);
    let scratch = Scratch::new();
    scratch.write("smooth.png", smooth);
    let found = |keys: &str| {
        let text = format!(
            "block = 'image'\nimage_form = 'matcap'\n{keys}\n[reflectance]\nfile = '{}'\n",
            scratch.path("smooth.png").display()
        );
        SpecFields::parse(&text, "test").and_then(SpecFields::resolve).map(|spec| design(&spec_text(&spec, &scratch)))
    };
    let [low, high] = ["min_psnr = 30", "min_psnr = 45"].map(|keys| found(keys).expect("a core"));
    let bits = |design: &Design| design.tables().iter().map(|table| table.bits()).sum::<usize>();
    assert!(bits(&low) < bits(&high), "{} {}", bits(&low), bits(&high));
    assert!(found("max_error = 0.0001").is_err());
}

/// A resolved spec as text, with its picture in place of the core's own directory.
fn spec_text(spec: &brdfgen::spec::CoreSpec, scratch: &Scratch) -> String {
    let text: Vec<String> =
        spec.to_toml().lines().filter(|line| !line.starts_with("digest")).map(str::to_owned).collect();
    text.join("\n").replace("\"reflectance\"", &format!("'{}'", scratch.path("smooth.png").display()))
}

/// No mutant of the operations or the registers survives the golden vectors, and no wrong bit of a texel does that an
/// input could show.
#[test]
fn no_mutant_of_a_matcap_survives() {
    for keys in ["image_size = 16", "image_size = 16\ntexel_bits = 4\nweight_bits = 3"] {
        let design = design(&spec(64, keys));
        let golden = Golden::of(&design);
        let mutants = mutants(&design, 0);
        assert!(mutants.len() >= 150, "{}", mutants.len());
        let vectors = brdfgen::verify::cosim::Vectors::of(&design, &golden);
        let outcomes = outcomes(&design, &mutants, &golden.vectors(), &|defect| vectors.detect(defect));
        let tally = Tally::of(&outcomes);
        println!("{} vectors, {tally:?}", golden.vectors().len());
        // Codes that this picture never has tell some of the last bits of products: no input shows these.
        assert!(tally.survivors == 0 && tally.undecided < 12, "{keys}: {tally:?}");

        let own = image(&design);
        let channels = |tables: &[brdfgen::fixed::Table], inputs: &[i64]| design.graph().results(tables, inputs);
        let vectors = golden.vectors();
        let mut rng = Rng::new(8);
        let mut shown = 0;
        for _ in 0..60 {
            let (memory, c) = (rng.below(4) as usize, rng.below(3) as usize);
            let address = rng.below(design.tables()[memory].depth() as u64) as usize;
            let mut wrong = design.tables().to_vec();
            wrong[memory].fields[c].codes[address] ^= 1;
            let detects = |inputs: &[i64]| channels(&wrong, inputs) != channels(design.tables(), inputs);
            if vectors.iter().any(|vector| detects(&vector.inputs)) {
                shown += 1;
                continue;
            }
            // Too dark a texel for its last bit: no place about it shows the bit either.
            let (y, x) = (2 * (address / 8) + memory / 2, 2 * (address % 8) + memory % 2);
            let parts = 1u64 << own.of.image.weight_bits;
            let about = |texel: usize| {
                let middle = texel as u64 * parts;
                (0..512).map(move |_| middle)
            };
            let hidden = about(y).zip(about(x)).all(|(y, x)| {
                let off = |at: u64, rng: &mut Rng| (at + rng.below(2 * parts)).saturating_sub(parts).min(15 * parts);
                !detects(&own.at_texels(&[off(y, &mut rng), off(x, &mut rng)]))
            });
            assert!(hidden, "{keys}: memory {memory}, word {address}, channel {c}");
        }
        assert!(shown > 30, "{shown}");
    }
}

/// Verilog and VHDL are the same circuit, and the wrapper loses no beat.
#[test]
fn both_languages_of_a_matcap_are_proved_the_same() {
    let scratch = Scratch::new();
    for keys in
        ["image_size = 16\naxi_stream = true", "image_size = 8\ntexel_bits = 10\nweight_bits = 8\ntexels = 'writable'"]
    {
        scratch.write("spec.toml", spec(64, &format!("name = 'cap'\n{keys}")));
        scratch.run("generate spec.toml --out core").succeeds();
        let run = scratch.run("formal core").succeeds().says(&["PROVED Verilog = VHDL"]);
        assert_eq!(run.stdout.contains("keeps every beat"), keys.contains("axi_stream"), "{}", run.stdout);
        assert!(!run.stdout.contains("REFUTED") && !run.stdout.contains("OPEN"), "{}", run.stdout);
        fs::remove_dir_all(scratch.path("core")).expect("removed");
    }
}

/// A place, a rounding and a texel that are wrong are found in both languages; texels lie in block RAM.
#[test]
fn broken_matcaps_fail() {
    let generated = Generated::new(&spec(64, "image_size = 64"));
    let core = generated.on_disk();
    let source = core.rtl(brdfgen::spec::Language::Verilog);
    let count = ecp5_cells(&source, "image_matcap");
    assert_eq!((count("DP16KD"), count("MULT18X18D")), (8, 3));
    for memory in ["texels_1_even_even", "texels_1_odd_odd"] {
        let core = generated.on_disk();
        let path = core.path().join(format!("rom/image_matcap_{memory}.mem"));
        let text = fs::read_to_string(&path).expect("texels");
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        // In the middle of the sphere, by more than a code of the output.
        let place = lines.len() / 2 + 12;
        let word = u32::from_str_radix(&lines[place], 16).expect("a word");
        lines[place] = format!("{:06x}", word ^ 4);
        fs::write(&path, lines.join("\n") + "\n").expect("written");
        for sim in [Sim::Icarus, Sim::Ghdl] {
            assert!(!core.run(sim).passed(), "{memory} in {sim:?}");
        }
    }
}
