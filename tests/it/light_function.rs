//! Light records: the nearest codes to what a light is, and the same ones by the generated C function, bit for bit.
//!
//! Needs gcc; clang as well if it is there.

use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};

use brdfgen::block::image::{FixedLight, Image, ImageBlock, ImageForm};
use brdfgen::core::{BlockDesign, Design};
use brdfgen::emit::package;
use brdfgen::fixed::{Rng, exp2, turn};
use brdfgen::reflectance::Light;
use tempfile::TempDir;

use crate::common::core::design;

/// All forms, few bands and many, the ends of the widths, one shift for all lights, nothing that reflects, and vectors
/// that the core makes the records of.
const SPECS: [&str; 9] = [
    "images = 4\nimage_size = 8\nvector_bits = 22\nweight_bits = 8\nreflectance = { model = 'gold-paint' }",
    "images = 64\nimage_size = 8\nreflectance = { model = 'ggx', exposure = 30 }",
    "image_form = 'bivariate'\nimage_size = 16\nvector_bits = 10\nweight_bits = 3\noctaves = 2\n\
     reflectance = { model = 'ggx' }",
    "image_form = 'bivariate'\nimage_size = 8\noctaves = 4\nreflectance = { model = 'lambert' }",
    "image_form = 'paper'\nimage_size = 8\nreflectance = { model = 'ggx' }",
    "image_form = 'paper'\nimage_size = 8\nangles = [20, 90, 130.5]\nreflectance = { model = 'ggx' }",
    "images = 4\nimage_size = 8\nreflectance = { model = 'lambert', parameters = { kd = 0 }, exposure = 1 }",
    "front_end = 'vector'\nimages = 4\nimage_size = 8\nvector_bits = 22\nreflectance = { model = 'ggx' }",
    "front_end = 'vector'\nimage_form = 'bivariate'\nimage_size = 8\noctaves = 4\nvector_bits = 10\n\
     weight_bits = 3\nreflectance = { model = 'ggx' }",
];

const STRICT: [&str; 8] = [
    "-std=c99",
    "-Wall",
    "-Wextra",
    "-Wconversion",
    "-Werror",
    "-pedantic",
    "-fsanitize=undefined",
    "-fno-sanitize-recover=all",
];

fn block(design: &Design) -> &ImageBlock {
    match design.block() {
        BlockDesign::Image(image) => image.block,
        _ => panic!("an image-based block"),
    }
}

/// The ends of all ranges and what is beyond them, the angle of every band and its neighbours, a grid, and any.
fn lights(block: &ImageBlock) -> Vec<FixedLight> {
    let one = [turn::HALF; 3];
    let mut rng = Rng::new(3);
    let ends = [0, 1, turn::HALF - 1, turn::HALF, turn::HALF + 1, u64::MAX];
    let bands =
        block.record_table().bands.iter().flat_map(|band| [-1, 0, 1].map(|by| band.angle.wrapping_add_signed(by)));
    let gammas = [0, 1, 1 << 55, 1 << 61, 1 << 62, 3 << 61, turn::HALF, 3 << 62, u64::MAX, 0x1234_5678_9abc_def0];
    let exact = ends.into_iter().chain(bands);
    let mut lights: Vec<FixedLight> =
        exact.flat_map(|phi| gammas.map(|gamma| FixedLight { phi, gamma, intensity: one })).collect();
    lights.extend((0..=4096u64).map(|step| FixedLight {
        // The last step is 180 degrees.
        phi: step << 51,
        gamma: step.wrapping_mul(0x9e37_79b9_7f4a_7c15),
        intensity: one.map(|whole| whole >> (step % 40)),
    }));
    lights.extend((0..20_000).map(|_| FixedLight {
        phi: rng.below(turn::HALF + 1),
        gamma: rng.below(u64::MAX),
        intensity: [0, 1, 2].map(|_| match rng.below(8) {
            0 => 0,
            1 => u64::MAX,
            2 => turn::HALF,
            _ => rng.below(turn::HALF + 1) >> rng.below(24),
        }),
    }));
    lights
}

/// The function's two files in a directory, each with its text changed.
fn written(design: &Design, change: impl Fn(String) -> String) -> TempDir {
    let directory = tempfile::tempdir().expect("a directory");
    std::fs::create_dir(directory.path().join("model")).expect("a directory");
    for (path, text) in package::light_function(design).expect("a function") {
        std::fs::write(directory.path().join(path), change(text)).expect("written");
    }
    directory
}

/// A program of the function's two files that makes a record of every light that it reads.
fn compiled(design: &Design, directory: &Path, compiler: &str) {
    let name = &design.spec.name;
    let main = format!(
        "#include <stdio.h>\n#include \"model/{name}_light.h\"\nint main(void)\n{{\n    uint64_t in[5];\n    \
         while (fread(in, sizeof in, 1, stdin) == 1) {{\n        struct {name}_light_record record = \
         {name}_light(in[0], in[1], in + 2);\n        fwrite(&record, sizeof record, 1, stdout);\n    }}\n    \
         return 0;\n}}\n"
    );
    std::fs::write(directory.join("main.c"), main).expect("written");
    let output = Command::new(compiler)
        .current_dir(directory)
        .args(STRICT)
        .args(["main.c", &format!("model/{name}_light.c"), "-o", "records"])
        .output()
        .expect(compiler);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && said.is_empty(), "{compiler}: {said}");
}

/// The codes of each light's record by the compiled program.
fn by_program(directory: &Path, lights: &[FixedLight]) -> Vec<i64> {
    let mut program = Command::new(directory.join("records"))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("it runs");
    let mut stdin = program.stdin.take().expect("a pipe");
    let words = |light: &FixedLight| [&[light.phi, light.gamma][..], &light.intensity].concat();
    let bytes: Vec<u8> = lights.iter().flat_map(words).flat_map(u64::to_ne_bytes).collect();
    let writer = std::thread::spawn(move || stdin.write_all(&bytes));
    let output = program.wait_with_output().expect("it ends");
    writer.join().expect("no panic").expect("it reads");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    output.stdout.chunks_exact(4).map(|code| i32::from_ne_bytes(code.try_into().expect("4 bytes")).into()).collect()
}

#[test]
fn the_c_function_makes_the_same_records() {
    let clang = Command::new("clang").arg("--version").output().is_ok();
    for spec in SPECS {
        let design = design(&format!("block = 'image'\n{spec}"));
        let (block, function) = (block(&design), written(&design, |text| text));
        let lights = lights(block);
        let records: Vec<Vec<i64>> = lights.iter().map(|light| block.light_codes(light)).collect();
        for compiler in ["gcc"].into_iter().chain(clang.then_some("clang")) {
            compiled(&design, function.path(), compiler);
            let codes = by_program(function.path(), &lights);
            assert_eq!(codes.len(), records.iter().map(Vec::len).sum::<usize>(), "{spec}");
            for ((light, record), own) in lights.iter().zip(&records).zip(codes.chunks(records[0].len())) {
                assert_eq!(own, record, "{spec}\n{light:x?}");
            }
        }
    }
}

/// A digit of each table that matters, and of the constant beside them.
#[test]
fn a_changed_table_of_the_c_function_shows() {
    let design = design(&format!("block = 'image'\n{}", SPECS[0]));
    let block = block(&design);
    let text = package::light_function(&design).expect("a function").remove(1).1;
    let band = block.record_table().bands[1];
    let numbers = [turn::SINES[1], turn::SINES[40], turn::HALF_PI, band.angle, band.reciprocal, band.root];
    let lights = lights(block);
    let records: Vec<i64> = lights.iter().flat_map(|light| block.fixed_record(light).codes()).collect();
    for number in numbers {
        // To 24 bits of it, as many as the finest port has.
        let changed = number ^ (1 << (63 - number.leading_zeros() - 20));
        let [from, to] = [number, changed].map(|number| format!("{number:012x})"));
        // Bands that are as far apart have one reciprocal.
        assert!(text.contains(&from), "{from}");
        let function = written(&design, |text| text.replace(&from, &to));
        compiled(&design, function.path(), "gcc");
        assert_ne!(by_program(function.path(), &lights), records, "{from} as {to}");
    }
}

/// Each code from the formula of the datasheet in floating point.
fn exact(block: &ImageBlock, image: &Image, light: Light, intensity: [f64; 3]) -> Vec<f64> {
    let [phi, gamma] = [light.phi, light.gamma].map(f64::to_radians);
    let (direction, half) = (light.direction(), phi / 2.0);
    let frame = match image.form {
        ImageForm::Bivariate { .. } => vec![half.sin() * gamma.cos(), half.sin() * gamma.sin(), half.cos()],
        ImageForm::Matcap => panic!("a form with lights"),
        ImageForm::Half { .. } | ImageForm::Paper { .. } => {
            vec![half.cos() * gamma.cos(), half.cos() * gamma.sin(), -half.sin(), -gamma.sin(), gamma.cos()]
        }
    };
    let angles = image.band_angles();
    let band = (angles.iter().filter(|&&angle| angle <= light.phi).count() - 1).min(angles.len() - 2);
    let t = ((light.phi - angles[band]) / (angles[band + 1] - angles[band])).min(1.0);
    let [own, next] = block.texels().weights([band, band + 1], t);
    let (full, steps) = (image.full_scale() as f64, exp2(image.texel_bits as i32));
    let unit = full / (full + 1.0) * (steps / (steps - 1.0)).powi(2);
    let gains = intensity.map(|intensity| intensity * (own + next).powi(2) * unit);
    let widths = block.widths();
    let greatest = gains.into_iter().fold(0.0, f64::max);
    let shift = (0..widths.shift).find(|&shift| greatest < 2.0 * exp2(shift)).unwrap_or(widths.shift);
    let odd = if band % 2 == 0 { next } else { own };
    let direction = image.has_incidence().then_some([direction.x, direction.y, direction.z]);
    let vectors = direction.into_iter().flatten().chain(frame);
    let mut codes: Vec<f64> = vectors.map(|component| component * exp2(image.vector_fraction as i32)).collect();
    codes.extend([band as f64, odd / (own + next) * exp2(image.weight_bits as i32)]);
    if image.has_turns() {
        let half = |band: usize| ((angles[band] - light.phi) / 180.0).clamp(-0.5, 0.5) * exp2(14);
        codes.extend([band + band % 2, band + 1 - band % 2].map(half));
        codes.push(f64::from(u8::from(light.phi >= angles[angles.len() - 1])));
    }
    codes.extend((widths.shift > 0).then_some(f64::from(shift)));
    codes.extend(gains.map(|gain| (gain * exp2(widths.gain - shift)).min(2.0 * exp2(widths.gain) - 1.0)));
    codes
}

#[test]
fn records_are_the_nearest_codes() {
    for spec in &SPECS[..5] {
        let design = design(&format!("block = 'image'\n{spec}"));
        let (block, mut rng) = (block(&design), Rng::new(9));
        for round in 0..20_000 {
            let phi = if round < 1800 { f64::from(round) / 10.0 } else { 179.99 * rng.unit() };
            let (light, intensity) = (Light::new(phi, 720.0 * rng.unit() - 360.0), [1.0, rng.unit(), rng.unit()]);
            let record = block.record(light, intensity).expect("an intensity").codes();
            let exact = exact(block, block.image(), light, intensity);
            assert_eq!(record.len(), exact.len());
            for (place, (code, exact)) in record.iter().zip(exact).enumerate() {
                assert!((*code as f64 - exact).abs() < 0.5 + 1e-6, "{spec}\n{light:?}: code {place}, {code}, {exact}");
            }
        }
    }
}

#[test]
fn sines_are_those_of_floating_point() {
    let mut rng = Rng::new(1);
    let near = |value: i64, exact: f64| (value as f64 * exp2(-62) - exact).abs() < exp2(-47);
    for round in 0..20_000u64 {
        // Every step, halfway between two, and anywhere.
        let angle = match round {
            0..1024 => round << 54,
            _ => rng.below(u64::MAX),
        };
        let radians = angle as f64 * exp2(-64) * std::f64::consts::TAU;
        let [sine, cosine] = turn::sine_cosine(angle);
        assert!(near(sine, libm::sin(radians)) && near(cosine, libm::cos(radians)), "{angle:#x}");
    }
    let one = turn::ONE as i64;
    let quarters = [0, 1, 2, 3].map(|quarter| turn::sine_cosine(quarter << turn::FRACTION));
    assert_eq!(quarters, [[0, one], [one, 0], [0, -one], [-one, 0]]);
}

#[test]
fn degrees_are_turns() {
    for (degrees, angle) in
        [(0.0, 0), (180.0, turn::HALF), (90.0, turn::ONE), (-90.0, 3 << 62), (720.0, 0), (405.0, 1 << 61), (-0.0, 0)]
    {
        assert_eq!(turn::of_degrees(degrees), angle, "{degrees}");
    }
}

#[test]
fn codes_are_the_nearest() {
    assert_eq!([1 << 61, (1 << 61) - 1, -(1 << 61), 1 - (1 << 61)].map(|sine| turn::code(sine, 0)), [1, 0, -1, 0]);
    assert_eq!(turn::times(-(1 << 61), 1 << 61), -(1 << 60));
}
