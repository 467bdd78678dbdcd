//! The image-based block as a core: keys, model, simulators, proofs, broken cores, pictures through the core.
//!
//! Needs iverilog, verilator, ghdl and yosys; `test.sh` installs them.

use std::process::Command;

use brdfgen::block::image::{FrontEnd, Places, RealTexels};
use brdfgen::core::{Account, BlockDesign, Design, ImageDesign, Role};
use brdfgen::datapath::graph::{Graph, Op};
use brdfgen::emit::package::{self, Part};
use brdfgen::fixed::{Rng, exp2};
use brdfgen::reflectance::measure::{self, Sphere};
use brdfgen::reflectance::{Light, Reflectance, Vector};
use brdfgen::spec::{CoreSpec, Language, RomStyle, SpecFields};
use brdfgen::verify::cosim::Sim;
use brdfgen::verify::golden::{Golden, differences, parse};
use brdfgen::verify::stability::sampled::{Proof, SampledInspection};
use rayon::prelude::*;

use crate::common::core::{Generated, design, ecp5_cells, resolved, silent};
use crate::common::{self, Scratch, matcap};

/// All forms, the ends of the ranges, texels in files, writable and outside, several lights, pipelines, AXI4-Stream,
/// lights that are told by records and by vectors.
const SPECS: [&str; 11] = [
    "image_form = 'bivariate'\nreflectance = { model = 'ggx' }",
    "images = 4\nimage_size = 8\ntexels = 'writable'\nlights_a_clock = 2\nreflectance = { model = 'gold-paint' }",
    "image_form = 'bivariate'\nimage_size = 8\noctaves = 2\ntexel_bits = 4\nweight_bits = 3\nvector_bits = 10\n\
     axi_stream = true\ntexels = 'writable'\n\
     reflectance = { model = 'blinnphong', parameters = { n = 5, ks = [0.1, 0.2, 0.3] } }",
    "image_size = 8\nimages = 4\ntexel_bits = 10\nweight_bits = 8\nvector_bits = 22\noutput_bits = 12\npipeline = \
     3\nreflectance = { model = 'ggx', exposure = 0.5 }",
    // All lights have the shift 0.
    "image_form = 'bivariate'\nimage_size = 8\noctaves = 4\npipeline = 1\nreflectance = { model = 'lambert' }",
    "images = 4\nimage_size = 8\nlights_a_clock = 3\noutput_bits = 10\n\
     rom_formats = ['hex', 'coe', 'mif', 'vhdl', 'c', 'csv', 'bin']\naxi_stream = true\n\
     reflectance = { model = 'ward' }",
    "image_form = 'paper'\nimage_size = 8\nimages = 4\nweight_bits = 4\nlights_a_clock = 2\ntexels = 'writable'\n\
     blend_multipliers = 15\nreflectance = { model = 'ggx' }",
    "image_form = 'paper'\nimage_size = 8\nangles = [20, 90, 130.5]\npipeline = 2\naxi_stream = true\n\
     reflectance = { model = 'blinnphong' }",
    "image_form = 'paper'\nimage_size = 8\nimages = 3\ntexels = 'external'\ntexel_latency = 1\nvhdl_ports = \
     'std-logic'\nreflectance = { model = 'gold-paint' }",
    "front_end = 'vector'\nimages = 4\nimage_size = 8\ntexels = 'writable'\nlights_a_clock = 2\n\
     reflectance = { model = 'gold-paint' }",
    "front_end = 'vector'\nimage_form = 'bivariate'\nimage_size = 8\noctaves = 4\nvector_bits = 14\n\
     axi_stream = true\npipeline = 2\nreflectance = { model = 'ggx' }",
];

fn text(spec: &str) -> String {
    format!("block = 'image'\n{spec}")
}

/// The same with matcaps, which are of a file.
fn all() -> Vec<String> {
    let of_models = SPECS.iter().map(|spec| text(spec));
    of_models.chain(matcap::specs()).collect()
}

fn image(design: &Design) -> ImageDesign<'_> {
    match design.block() {
        BlockDesign::Image(image) => image,
        _ => panic!("an image-based block"),
    }
}

#[test]
fn every_image_core_passes_in_every_simulator_and_lints_clean() {
    all().par_iter().enumerate().for_each(|(place, spec)| {
        let generated = Generated::new(spec);
        let core = generated.on_disk();
        // GHDL interprets: it takes most of the time, and analyses the others below.
        let ghdl = (common::all() || place % 2 == 0).then_some(Sim::Ghdl);
        for sim in [Sim::Builtin, Sim::Icarus].into_iter().chain(ghdl) {
            let outcome = core.run(sim);
            assert!(outcome.passed(), "{spec}\n{outcome:?}");
            assert_eq!(outcome.vectors, core.golden.vectors().len() as u64);
        }
        let path = core.path();
        let [verilog, vhdl] =
            [Language::Verilog, Language::Vhdl].map(|language| Part::Core.paths_with_bench(&core.design, language));
        let work = core.beside("work");
        std::fs::create_dir(&work).expect("a directory");
        let (workdir, out) = (format!("--workdir={}", work.display()), work.join("out").display().to_string());
        let silent = |program: &str, before: &[&str], files: &[String]| {
            let words: Vec<&str> = before.iter().copied().chain(files.iter().map(String::as_str)).collect();
            silent(path, program, &words, spec);
        };
        silent("verilator", &["--lint-only", "-Wall"], &verilog[..1]);
        silent("iverilog", &["-Wall", "-g2005", "-o", &out], &verilog);
        silent("ghdl", &["-a", "--std=08", &workdir], &vhdl);
        // No memory is a table of cases, and each of the core is read from its file.
        for (language, reads) in [(Language::Verilog, "initial $readmemh"), (Language::Vhdl, "readline(")] {
            let text = generated.text(&package::rtl_path(&core.design, language));
            let memories = core.design.tables().len() - core.design.read_ports().len();
            assert_eq!(text.matches(reads).count(), memories, "{spec}");
            assert!(text.lines().count() < 7000 * image(&core.design).of.image.look_ups(), "{spec}");
        }
    });
}

/// The golden file is read as it is written, and one of another core is not.
#[test]
fn vectors_are_read_back_and_belong_to_their_core() {
    let cores: Vec<Generated> = SPECS[..2].iter().map(|spec| Generated::new(&text(spec))).collect();
    let written: Vec<String> = cores.iter().map(|core| core.golden.to_text(&core.design)).collect();
    for (core, text) in cores.iter().zip(&written) {
        let read = parse(&core.design, text, "golden").expect("its own vectors");
        assert_eq!(differences(&core.design, &core.golden, &read), Vec::new());
        for vector in core.golden.vectors() {
            assert_eq!(core.design.evaluate(&vector.inputs), vector.outputs);
        }
    }
    let error = parse(&cores[0].design, &written[1], "golden").unwrap_err().to_string();
    assert!(error.contains("of core image_half"), "{error}");
}

#[test]
fn a_spec_and_its_command_give_the_same_core_again() {
    for spec in SPECS {
        let own = resolved(&text(spec));
        assert_eq!(own.to_toml().parse::<CoreSpec>().expect("core.toml"), own, "{spec}");
        let flags = own.flags().join(" ");
        let memory = Design::new(own.clone()).expect(spec).tables()[0].name;
        let rom = ["rom", "--format", "mem", "--memory-name", memory, "--out", "-"].map(str::to_owned).to_vec();
        let run = Scratch::new().run_each([rom, words(&flags)].concat());
        let digest = format!("// spec {}", own.digest());
        assert!(run.succeeds().stdout.lines().any(|line| line == digest), "{flags}");
    }
    assert_eq!(
        resolved("block = 'image'\nreflectance = { model = 'ggx' }").flags(),
        ["--block image", "--reflectance ggx"]
    );
}

/// The words of flags as a shell has them.
fn words(flags: &str) -> Vec<String> {
    let output = Command::new("sh").args(["-c", &format!("printf '%s\\n' {flags}")]).output().expect("sh");
    String::from_utf8(output.stdout).expect("text").lines().map(str::to_owned).collect()
}

#[test]
fn what_is_no_image_core_is_refused() {
    let ggx = "reflectance = { model = 'ggx' }";
    for (spec, words) in [
        ("", "no reflectance is given"),
        ("reflectance = { model = 'gold' }", "there is no reflectance model `gold`"),
        ("reflectance = { model = 'ggx', parameters = { alpha = 2 } }", "alpha = 2 is out of range"),
        ("reflectance = { model = 'ggx', parameters = { beta = 2 } }", "there is no parameter `beta`"),
        ("reflectance = { model = 'ggx', exposure = 0 }", "exposure = 0 is out of range"),
        ("images = 12", "images = 12 is no power of two"),
        ("image_size = 1024", "image_size = 1024 is out of range"),
        ("image_form = 'bivariate'\nimages = 16", "images are given for the form bivariate"),
        ("octaves = 8", "octaves are given for slices"),
        ("angles = [0, 90]", "angles are given for a form whose angles are fixed"),
        ("image_form = 'paper'\noctaves = 8", "octaves are given for sphere images"),
        ("image_form = 'paper'\nimages = 4\nangles = [0, 90]", "images and angles are given"),
        ("image_form = 'paper'\nimages = 33", "images = 33 is out of range"),
        ("image_form = 'paper'\nangles = [0, 90, 60]", "do not ascend"),
        ("image_form = 'paper'\nimages = 1", "no image is between 0 and 180 degrees"),
        ("vector_bits = 9", "vector_bits = 9 is out of range"),
        ("output_bits = 9", "output_bits = 9 is not offered"),
        ("lights_a_clock = 9", "lights_a_clock = 9 is out of range"),
        ("most_lights = 0", "most_lights = 0 is out of range"),
        ("texel_bits = 3", "texel_bits = 3 is out of range"),
        ("weight_bits = 9", "weight_bits = 9 is out of range"),
        ("image_form = 'paper'\nfront_end = 'vector'", "front_end = vector is given for sphere images"),
        ("method = 'cubic'", "method is given for an image-based block"),
        ("shininess = '1..=9'", "shininess is given for an image-based block"),
        ("rom = 'inline'", "rom is given for an image-based block"),
        ("shader = { lights = 2 }", "lights is given for an image-based block"),
        ("input_fraction = 12", "input_fraction is given for an image-based block"),
        ("golden_inputs = [[1, 2]]", "golden_inputs"),
    ] {
        let spec =
            if spec.is_empty() || spec.contains("reflectance") { spec.to_owned() } else { format!("{spec}\n{ggx}") };
        let error = SpecFields::parse(&text(&spec), "test").and_then(SpecFields::resolve).and_then(Design::new);
        let error = error.expect_err(&spec).to_string();
        assert!(error.contains(words), "{spec}: {error}");
    }
    let lobe = "method = 'cubic'\nshininess = '1..=9'\n";
    for (key, name) in [("texels = 'rom'", "texels"), (ggx, "reflectance"), ("octaves = 8", "octaves")] {
        let error = SpecFields::parse(&format!("{lobe}{key}"), "test").and_then(SpecFields::resolve).unwrap_err();
        assert!(error.to_string().contains(&format!("{name} is given, which is for image-based blocks")), "{error}");
    }
}

/// Commands that need a lobe say so.
#[test]
fn commands_take_or_refuse_an_image_core() {
    let scratch = Scratch::new();
    scratch.write("spec.toml", text("images = 4\nimage_size = 8\nreflectance = { model = 'ggx' }"));
    let scene = |name: &str| format!("{}/scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    for (line, words) in [
        ("generate spec.toml --out core", "dB in the mean"),
        ("generate core --check --out core", "files are as they should be"),
        ("golden core --check core/golden/image_half.vec", "0 differences"),
        ("cosim core --sim icarus", "PASS icarus"),
        ("rom core --out rom", "texels"),
        ("stability core", "proved that no needed value overflows"),
        ("image lights core --light 60,20", "in_l1x,in_l1y"),
        (&format!("image lights core --scene {} --json", scene("skydome")), "in_gain1b"),
    ] {
        scratch.run(line).succeeds().says(&[words]);
    }
    let (sphere, shader) = (scene("sphere"), format!("{}/generated/shader", env!("CARGO_MANIFEST_DIR")));
    for (line, words) in [
        ("image lights core", "--light"),
        ("image lights core --light 181,0", "from 0 to 180"),
        ("image lights core --light 60,0 --mem lights.mem", "has no table of lights"),
        ("image lights core --light 60", "PHI,GAMMA"),
        ("image lights core --light 60,0,2,0,0", "intensity"),
        (&format!("image lights {shader} --light 60,0"), "no image-based block"),
        (&format!("image lights core --scene {sphere} --csv core/core.toml"), "core.toml"),
        ("cosim core --exhaustive", "an image-based block has too many"),
        ("eval core -n 5 -x 0.5", "this core is an image-based block"),
        ("generate core --max-error 1% --out other", "chosen by its error"),
        ("generate core --blend-multipliers 22 --out other", "blend_multipliers = 22"),
        (&format!("generate {sphere} --block image --out other"), "no object of the scene sphere has a material"),
        (&format!("scene inspect {sphere} --block image"), "no object of the scene sphere has a material"),
        (&format!("render {sphere} --core core --out p.png"), "the core is an image-based block"),
        (&format!("render {sphere} --block image --out p.png"), "the core is an image-based block"),
    ] {
        scratch.refused(line, &[words]);
    }
}

/// The account keeps the targets, its parts are in order, and the model shows a sphere that is lit.
#[test]
fn pictures_through_the_core_are_as_good_as_its_account_says() {
    for (spec, mean, worst) in [
        (SPECS[0], 44.0, 34.5),
        ("reflectance = { model = 'ggx' }", 49.0, 42.0),
        ("image_form = 'paper'\nimage_size = 64\nreflectance = { model = 'ggx' }", 38.5, 27.0),
        ("front_end = 'vector'\nimage_form = 'bivariate'\nreflectance = { model = 'ggx' }", 44.0, 34.0),
        ("front_end = 'vector'\nreflectance = { model = 'ggx' }", 49.0, 42.0),
    ] {
        let design = design(&text(spec));
        let image = image(&design);
        let model = image.of.source.model().expect("a model");
        let Account::Image(account) = Account::of(&design) else { panic!("an image's account") };
        assert!(account.quality.mean > mean && account.quality.worst > worst, "{:?}", account.quality);
        let parts = &account.parts;
        let of = |name: &str| parts.iter().find(|part| part.name == name).expect(name);
        // Rounded to the nearest code, and less than a third more.
        let [low, high] = of("arithmetic").codes;
        assert!(-0.8 < low && high < 0.6, "{low} {high}");
        assert!(of("arithmetic").rms < of("texels").rms && of("weights").rms < of("texels").rms);
        assert_eq!(parts.iter().any(|part| part.name == "front end"), spec.contains("front_end"));
        assert!(parts.iter().filter(|part| part.name == "front end").all(|part| part.rms < of("texels").rms));
        let sphere = Sphere::new(64);
        let full = image.of.image.full_scale() as f64;
        let light = Light::new(40.0, 30.0);
        let sample = |n: Vector, light: Light| {
            design.sample_of(&[image.model().evaluate(&image.inputs(n, &[(light, [1.0; 3])]))])
        };
        let shown = |n: &Vector| {
            let out = sample(*n, light);
            [0, 1, 2].map(|c| (out[c] as f64 / full) as f32)
        };
        let exact = sphere.exact(model, light, image.of.exposure);
        let ratio = measure::psnr(&exact, &sphere.normals.iter().map(shown).collect::<Vec<_>>());
        assert!(ratio > mean - 4.0, "{ratio}");
        // Behind the surface, and where nothing is to be seen, it is black.
        let black = |n: Vector, phi: f64| sample(n, Light::new(phi, 0.0));
        assert_eq!(black(-Vector::z(), 10.0), [0; 3]);
        assert_eq!(black(Vector::new(-0.8, 0.0, 0.6), 90.0), [0; 3]);
        assert_eq!(black(Vector::z(), 180.0), [0; 3]);
        let l_is_v = model.radiance(Light::new(0.0, 0.0), Vector::z(), image.of.exposure);
        let middle = sample(Vector::z(), Light::new(0.0, 77.0));
        for channel in [0, 1, 2] {
            let exact = (l_is_v[channel] * full).min(full);
            assert!((middle[channel] as f64 - exact).abs() <= 3.0, "{middle:?} {l_is_v:?}");
        }
    }
}

/// Every texel and every weight in every direction of small blocks: the operations are the model, and both are what the
/// formula says of these texels and weights, to half a code for what is rounded down on the way.
#[test]
fn every_address_and_every_weight() {
    for spec in [
        "image_form = 'bivariate'\nimage_size = 8\noctaves = 4\nweight_bits = 4\nreflectance = { model = 'ggx' }",
        "images = 4\nimage_size = 8\nweight_bits = 3\nreflectance = { model = 'gold-paint' }",
        "image_form = 'paper'\nimages = 4\nimage_size = 8\nweight_bits = 3\nreflectance = { model = 'gold-paint' }",
        "front_end = 'vector'\nimage_form = 'bivariate'\nimage_size = 8\noctaves = 4\nweight_bits = 4\n\
         reflectance = { model = 'ggx' }",
        "front_end = 'vector'\nimages = 4\nimage_size = 8\nweight_bits = 3\nreflectance = { model = 'gold-paint' }",
    ] {
        let design = design(&text(spec));
        let image = image(&design);
        let parts = 1u64 << image.of.image.weight_bits;
        let counts: Vec<u64> =
            image.of.image.extents().iter().map(|&extent| u64::from(extent - 1) * parts + 1).collect();
        let lsb = exp2(-(image.of.image.vector_fraction as i32));
        let full = image.of.image.full_scale() as f64;
        let check = |number: u64| {
            let mut rest = number;
            let mut places: Vec<u64> = Vec::new();
            for &count in counts.iter().rev() {
                places.insert(0, rest % count);
                rest /= count;
            }
            // The last band is the next of the one before.
            let last = counts[0] - 1;
            if places[0] == last {
                return;
            }
            let codes = image.at_texels(&places);
            let inputs: Vec<i128> = codes.iter().copied().map(i128::from).collect();
            let values = design.graph().values(design.tables(), &inputs);
            let outputs: Vec<i64> = design.graph().outputs.iter().map(|&(_, id)| values[id] as i64).collect();
            assert_eq!(outputs, design.evaluate(&codes), "{places:?}");
            let to_codes = exp2(image.of.image.channel_bits as i32 - image.block.widths().term);
            let n = Vector::new(codes[0] as f64 * lsb, codes[1] as f64 * lsb, codes[2] as f64 * lsb);
            let record = image.model().record(&codes[3..]);
            // No unit vectors bring an n.l of 1 or more, or so great a shift together with so great an n.l.
            let l = record.direction.map(|l| Vector::from(l.map(|code| code as f64 * lsb)));
            let nl = l.map_or(0.5, |l| n.dot(&l));
            let shifted = nl * exp2(record.shift.unwrap_or(0) as i32);
            if nl >= 1.0 || shifted > exp2(image.block.widths().lit_int) {
                return;
            }
            let light = image.block.light_of(&record);
            let real = image.block.real(n, &light, RealTexels::Stored, Places::Rounded);
            for channel in [0, 1, 2] {
                let sum = (outputs[channel] as f64 * to_codes).min(full);
                let off = sum - (real[channel] * full).clamp(0.0, full);
                assert!(off.abs() < 0.5, "{places:?}: {outputs:?}, {real:?}");
            }
        };
        // A light's vector is sought for each of them; what lies behind its record is what the other forms have.
        let step = if image.of.image.front_end == FrontEnd::Vector && !common::all() { 7 } else { 1 };
        let places: Vec<u64> = (0..counts.iter().product()).step_by(step).collect();
        places.into_par_iter().for_each(check);
    }
}

/// A light that is missing changes nothing, and lights add up to 1.0.
#[test]
fn lights_add_up() {
    let design = design(&text(SPECS[1]));
    let image = image(&design);
    let mut rng = Rng::new(3);
    let mut lit = 0;
    for _ in 0..300 {
        let codes = image.random(&mut rng);
        let (normal, lights) = codes.split_at(3);
        let (first, second) = lights.split_at(lights.len() / 2);
        let dark = vec![0; first.len()];
        let of = |first: &[i64], second: &[i64]| design.evaluate(&[normal, first, second].concat());
        let [a, b, both] = [of(first, &dark), of(&dark, second), of(first, second)];
        for channel in [0, 1, 2] {
            let most = 1i64 << image.block.widths().term;
            assert_eq!(both[channel], (a[channel] + b[channel]).min(most), "{a:?} {b:?} {both:?}");
            lit += i64::from(both[channel] > 0);
        }
    }
    assert!(lit > 200, "{lit}");
}

#[test]
fn no_register_overflows() {
    all().par_iter().for_each(|spec| {
        let found = SampledInspection::of(&design(spec));
        assert_eq!(found.broken(), Vec::<String>::new(), "{spec}");
        assert_eq!(found.wide_differences, 0);
    });
}

/// A texel, a rounding, a place, an address, a normal that is turned away: each is found, in both languages.
#[test]
fn broken_image_cores_fail() {
    let generated = Generated::new(&text("images = 4\nimage_size = 8\nreflectance = { model = 'ggx' }"));
    let faults = [
        (Language::Verilog, ("the nearest weight", "u1_scaled_3 + 15'h0384", "u1_scaled_3 + 15'h0380")),
        (Language::Verilog, ("the next band", "{1'd0, in_band1} + 3'h1", "{1'd0, in_band1} + 3'h2")),
        (Language::Verilog, ("a hidden normal", "hidden_6 ? 18'd0 : nl1_within_6", "nl1_within_6")),
        (Language::Vhdl, ("the nearest weight", "u1_scaled_3 + to_signed(900, 15)", "u1_scaled_3")),
        (Language::Vhdl, ("the next band", "resize(in_band1, 3) + to_unsigned(1, 3)", "resize(in_band1, 3)")),
    ];
    faults.par_iter().for_each(|&(language, fault)| {
        let sim = if language == Language::Verilog { Sim::Icarus } else { Sim::Ghdl };
        let outcome = generated.with_fault(language, fault).run(sim);
        assert!(!outcome.passed() && outcome.vectors > 0, "{} goes unnoticed: {outcome:?}", fault.0);
    });
    for memory in ["texels_1_even_even_odd", "texels_1_odd_odd_odd"] {
        let core = generated.on_disk();
        let path = core.path().join(format!("rom/image_half_{memory}.mem"));
        let text = std::fs::read_to_string(&path).expect("texels");
        // The last bit of a word in the middle.
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        let place = lines.len() / 2 + 2;
        let word = u32::from_str_radix(&lines[place], 16).expect("a word");
        lines[place] = format!("{:06x}", word ^ 1);
        std::fs::write(&path, lines.join("\n") + "\n").expect("written");
        for sim in [Sim::Icarus, Sim::Ghdl] {
            assert!(!core.run(sim).passed(), "{memory} in {sim:?}");
        }
    }
}

/// Block RAM for the texels, as many as they need, and the multipliers of the datapath.
#[test]
fn texels_are_block_ram_on_ecp5() {
    let core = Generated::new(&text(SPECS[0])).on_disk();
    let source = core.rtl(Language::Verilog);
    let count = ecp5_cells(&source, "image_bivariate");
    assert_eq!(count("DP16KD"), 4);
    assert_eq!(count("MULT18X18D"), 15);
}

/// Any texels may be written: with those of another reflectance the core is the other one.
#[test]
fn written_texels_make_the_core_of_another_reflectance() {
    let spec = |f0: &str| {
        text(&format!(
            "image_form = 'bivariate'\nimage_size = 8\noctaves = 4\ntexels = 'writable'\n\
             reflectance = {{ model = 'ggx', parameters = {{ f0 = {f0} }}, exposure = 1 }}"
        ))
    };
    let [own, other] = ["[0.95, 0.64, 0.3]", "[0.2, 0.9, 0.95]"].map(|f0| design(&spec(f0)));
    assert_eq!(own.spec.rom, RomStyle::Writable);
    assert_eq!(own.write_ports().len(), 4);
    assert_eq!(own.ports().iter().filter(|port| port.role == Role::Write).count(), 12);
    assert_ne!(own.tables(), other.tables());
    assert_eq!(own.datapath_digest(), other.datapath_digest());
    let mut rng = Rng::new(9);
    for _ in 0..500 {
        let codes = image(&other).random(&mut rng);
        let inputs: Vec<i128> = codes.iter().copied().map(i128::from).collect();
        let values = own.graph().values(other.tables(), &inputs);
        let outputs: Vec<i64> = own.graph().outputs.iter().map(|&(_, id)| values[id] as i64).collect();
        assert_eq!(outputs, other.evaluate(&codes));
    }
    // Whatever the words are, no multiplier is narrower.
    let black = design(&text(
        "image_form = 'bivariate'\nimage_size = 8\noctaves = 4\ntexels = 'writable'\n\
         reflectance = { model = 'lambert', parameters = { kd = [1, 0, 0] }, exposure = 1 }",
    ));
    let of_texels = |design: &Design| {
        let mut all = design.graph().multipliers();
        all.retain(|&(a, b)| a.max(b) < 18);
        all
    };
    assert_eq!(of_texels(&black), of_texels(&own));
}

/// The records as the datasheet says them, worked out anew: before the first band's angle and between bands, at their
/// angles, past the last one, and behind the object.
#[test]
fn records_are_as_the_datasheet_says() {
    let paper = "image_form = 'paper'\nimage_size = 8\nreflectance = { model = 'gold-paint' }";
    for spec in [SPECS[0], "reflectance = { model = 'gold-paint' }", paper] {
        let design = design(&text(spec));
        let image = image(&design);
        let asked = &image.of.image;
        let angles = asked.band_angles();
        let last = angles.len() - 1;
        let caps = image.block.texels().caps();
        let near = |value: f64, bits: i32| (value * exp2(bits)).round() as i64;
        let component = |value: f64| near(value, asked.vector_fraction as i32);
        for (number, phi) in [0.0, 3.0, angles[3], 61.5, 120.0, angles[last], 179.9, 180.0].into_iter().enumerate() {
            let gamma = 50.0 * number as f64 - 120.0;
            let intensity = [1.0, 0.25, 0.0];
            let record = image.block.record(Light::new(phi, gamma), intensity).expect("a record");
            let [(ps, pc), (gs, gc)] = [phi, gamma].map(|angle: f64| angle.to_radians().sin_cos());
            let l = [ps * gc, ps * gs, pc];
            let off = |code: i64, value: f64| assert!((code - component(value)).abs() <= 1, "{phi}: {code} {value}");
            assert_eq!(record.direction.is_none(), spec == paper);
            record.direction.iter().flatten().zip(l).for_each(|(&code, value)| off(code, value));
            let frame = if asked.frame().len() == 1 {
                let length = (l[0] * l[0] + l[1] * l[1] + (l[2] + 1.0).powi(2)).sqrt();
                if phi == 180.0 {
                    vec![0.0, 0.0, 1.0]
                } else {
                    vec![l[0] / length, l[1] / length, (l[2] + 1.0) / length]
                }
            } else {
                let (hs, hc) = (phi / 2.0).to_radians().sin_cos();
                vec![hc * gc, hc * gs, -hs, -gs, gc]
            };
            record.frame.iter().zip(&frame).for_each(|(&code, &value)| off(code, value));
            let band = (0..last).rev().find(|&band| angles[band] <= phi).unwrap_or(0);
            if let Some([even, odd, alone]) = record.turns {
                let is_alone = phi >= angles[last];
                assert_eq!(alone, i64::from(is_alone), "{phi}");
                for (number, half) in [(band, [even, odd]), (band + 1, [odd, even])] {
                    if !is_alone || number == last {
                        assert_eq!(half[band % 2], near((angles[number] - phi) / 180.0, 14), "{phi}");
                    }
                }
            }
            let t = ((phi - angles[band]) / (angles[band + 1] - angles[band])).min(1.0);
            let [w1, w2] = [(1.0 - t) * caps[band].sqrt(), t * caps[band + 1].sqrt()];
            let odd = if band % 2 == 0 { w2 } else { w1 } / (w1 + w2);
            assert_eq!(record.band, band as i64, "{phi}");
            assert_eq!(record.blend, near(odd, asked.weight_bits as i32), "{phi}");
            let gains = intensity.map(|part| {
                let full = asked.full_scale() as f64;
                let steps = exp2(asked.texel_bits as i32);
                part * (w1 + w2).powi(2) * full / (full + 1.0) * (steps / (steps - 1.0)).powi(2)
            });
            let widths = image.block.widths();
            let shift = (0..).find(|&shift| gains[0] < 2.0 * exp2(shift)).unwrap_or_default();
            let (gains, shift) = if phi == 180.0 { ([0.0; 3], 0) } else { (gains, shift) };
            assert_eq!(record.shift, Some(i64::from(shift)), "{phi}");
            for (code, gain) in record.gain.iter().zip(gains) {
                assert!((code - near(gain, widths.gain - shift)).abs() <= 1, "{phi}: {code} {gain}");
            }
        }
    }
}

/// Verilog and VHDL are the same circuit, with several memories that are written, and the wrapper loses no beat.
#[test]
fn both_languages_are_proved_the_same() {
    let scratch = Scratch::new();
    let some = if common::all() { vec![SPECS[1], SPECS[2], SPECS[8]] } else { vec![SPECS[2], SPECS[8]] };
    for spec in some {
        scratch.write("spec.toml", text(&format!("name = 'lit'\n{spec}")));
        scratch.run("generate spec.toml --out core").succeeds();
        let run = scratch.run("formal core").succeeds().says(&["PROVED Verilog = VHDL"]);
        assert_eq!(run.stdout.contains("keeps every beat"), spec.contains("axi_stream"), "{}", run.stdout);
        assert!(!run.stdout.contains("REFUTED") && !run.stdout.contains("OPEN"), "{}", run.stdout);
        std::fs::remove_dir_all(scratch.path("core")).expect("removed");
    }
}

/// A blend stays between what is blended only if its weight is at most 1: with a weight that may be more, the analysis
/// does not claim so.
#[test]
fn a_weight_above_one_is_no_blend() {
    // With multipliers; what goes by the weights' bits takes all that is above one for one.
    for (spec, is_safe) in [(SPECS[3], false), (SPECS[0], true)] {
        let design = design(&text(spec));
        let mut graph = design.function().clone();
        let proof = |graph: &Graph| Proof::of_image(image(&design).joints, graph, design.tables());
        assert!(proof(&graph).is_safe(), "{spec}");
        let weight = graph.nodes.iter_mut().find(|node| node.name == "blend1").expect("the bands' weight");
        let Op::Clamp { high, .. } = &mut weight.op else { panic!("a clamp") };
        *high = weight.format.max_code();
        assert_eq!(proof(&graph).is_safe(), is_safe, "{spec}");
    }
}

#[test]
fn vectors_are_the_same_on_any_number_of_threads() {
    let design = design(&text(SPECS[4]));
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a pool");
    assert_eq!(pool.install(|| Golden::of(&design)), Golden::of(&design));
    let account = |design: &Design| match Account::of(design) {
        Account::Image(account) => account,
        _ => panic!("an image's account"),
    };
    assert_eq!(pool.install(|| account(&design)), account(&design));
}
