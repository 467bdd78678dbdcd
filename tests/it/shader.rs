//! The shader block: its model against its graph, an f64 shader written here, and the simulators.
//!
//! Needs iverilog, verilator, ghdl and yosys; `test.sh` installs them.

use std::process::Command;

use brdfgen::core::sample::{Sample, random_codes};
use brdfgen::core::{Account, Design, Direction};
use brdfgen::fixed::Rng;
use brdfgen::method::quadratic::Quadratic;
use brdfgen::platform::error::Error;
use brdfgen::spec::{Cosine, Language, LightColours, Shader, SpecFields};
use brdfgen::verify::cosim::{self, Job, Sim};
use brdfgen::verify::golden::{self, Golden};
use rayon::prelude::*;

use crate::common;
use crate::common::core::{Generated, OnDisk, design, ecp5_cells, silent};

const MATERIALS: &str = "
[[material]]
name = 'plastic'
shininess = 32
ambient = 1
diffuse = 0.55
specular = 0.7
colour = [0.9, 0.1, 0.1]
[[material]]
name = 'brass'
shininess = 127.9
diffuse = 1
specular = 1
colour = [1, 0.57, 0]
specular_colour = [0.99, 1, 0.81]
[[material]]
name = 'rubber'
shininess = 3.5
specular = 0
";

/// A spec with keys of the core, keys of the table `[shader]`, and the materials.
fn text(core: &str, shader: &str) -> String {
    format!("block = 'shader'\n{core}\n[shader]\n{shader}\n{MATERIALS}")
}

/// Each front end, each channel width, one light and three, both sources of colours, several methods.
fn specs() -> Vec<String> {
    [
        ("method = 'quadratic'", "model = 'phong'"),
        ("method = 'quadratic'", "model = 'phong'\nlights = 3\nchannel_bits = 10"),
        ("method = 'cubic'", "model = 'phong'\nlights = 2\nlight_colours = 'ports'"),
        ("method = 'cubic'\nform = 'paper'", "model = 'blinn'\nfront = 'half'\nchannel_bits = 12"),
        (
            "method = 'quadratic'\nrom = 'file'",
            "model = 'blinn'\nlights = 3\nlight_colours = 'ports'\nchannel_bits = \
         10",
        ),
        ("method = 'quadratic'", "model = 'blinn'\nfront = 'sqrt'"),
        ("method = 'cubic'", "model = 'blinn'\nfront = 'sqrt'\nlights = 3\nchannel_bits = 12"),
        (
            "method = 'quadratic'\ninput_fraction = 9\noutput_fraction = 7\npipeline = 3",
            "model = 'blinn'\nfront = 'sqrt'\nvector_fraction = 8\nlight_colours = [[0.5, 0, 1]]\nambient_light = [0, \
             0.5, 1]",
        ),
        ("method = 'segmented-4'", "model = 'phong'\nchannel_bits = 10"),
        ("method = 'log-exp'", "model = 'blinn'\nfront = 'half'\nlights = 2"),
        ("method = 'cubic-rational'\ndivider = 'reciprocal'", "model = 'phong'"),
    ]
    .map(|(core, shader)| text(core, shader))
    .to_vec()
}

fn shader(design: &Design) -> &Shader {
    design.spec.block.shader().expect("a shader")
}

fn through_graph(design: &Design, codes: &[i64]) -> Vec<i64> {
    let inputs: Vec<i128> = codes.iter().copied().map(i128::from).collect();
    let values = design.graph().values(design.tables(), &inputs);
    design.graph().outputs.iter().map(|&(_, node)| values[node] as i64).collect()
}

fn random_sample(design: &Design, rng: &mut Rng) -> Sample {
    let row = rng.below(design.lobe().interface.shininess.rows() as u64) as usize;
    Sample::random(shader(design), row as u32, design.lobe().interface.shininess.value(row), rng)
}

/// A million inputs: samples, random codes, and codes that are each at an end, about 0 or about 1.
#[test]
fn the_model_equals_the_graph_on_a_million_samples() {
    let specs = specs();
    let each = 1_000_000 / specs.len() + 1;
    specs.par_iter().enumerate().for_each(|(number, spec)| {
        let design = design(spec);
        let ports = design.numbers(Direction::In);
        let one = 1i64 << shader(&design).vector_fraction;
        let mut rng = Rng::new(100 + number as u64);
        let mut bright = 0;
        for sample in 0..each {
            let codes = match sample % 3 {
                0 => random_sample(&design, &mut rng).codes(shader(&design)),
                1 => random_codes(&ports, &mut rng),
                _ => ports
                    .iter()
                    .map(|(_, format)| {
                        let marks = [i64::MIN, -one - 1, -one, -one + 1, -1, 0, 1, one - 1, one, one + 1, i64::MAX];
                        let mark = marks[rng.below(marks.len() as u64) as usize];
                        mark.clamp(format.min_code() as i64, format.max_code() as i64)
                    })
                    .collect(),
            };
            let outputs = design.evaluate(&codes);
            assert_eq!(through_graph(&design, &codes), outputs, "{spec}\n{codes:?}");
            let full = shader(&design).full_scale();
            assert!(outputs.iter().all(|code| (0..=full).contains(code)), "{spec}\n{codes:?}: {outputs:?}");
            bright += usize::from(outputs[0] > full / 4);
        }
        assert!(bright > each / 20, "{spec}: too little is lit");
    });
}

/// A shader in double precision, from the formulas: the channels in codes, not rounded. `power` is the highlight for a
/// material's n and the cosine.
fn in_double(design: &Design, sample: &Sample, power: impl Fn(f64, f64) -> f64) -> [f64; 3] {
    let shader = shader(design);
    let dot = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let row = (sample.material as usize).min(design.lobe().interface.shininess.rows() - 1);
    let surface = Shader::surfaces(design.lobe().interface)[row];
    let mut sums = [0, 1, 2].map(|channel| shader.ambient_light[channel] * surface.ambient[channel]);
    for (number, light) in sample.lights.iter().enumerate() {
        let (nl, nv) = (dot(sample.normal, light.direction), dot(sample.normal, sample.viewer));
        let lv = dot(light.direction, sample.viewer);
        if nl <= 0.0 {
            continue;
        }
        let x = match shader.cosine {
            Cosine::Mirror => 2.0 * nl * nv - lv,
            Cosine::Sqrt => (nl + nv) / (2.0 + 2.0 * lv).sqrt(),
            Cosine::Half => {
                let d = [0, 1, 2].map(|axis| sample.normal[axis] - light.half[axis]);
                1.0 - dot(d, d) / 2.0
            }
        };
        let highlight = power(design.lobe().interface.shininess.value(row), x.clamp(0.0, 1.0));
        let colour = match &shader.light_colours {
            LightColours::Ports => light.colour,
            LightColours::Fixed(colours) => colours[number],
        };
        for channel in 0..3 {
            sums[channel] +=
                colour[channel] * (surface.diffuse[channel] * nl.min(1.0) + surface.specular[channel] * highlight);
        }
    }
    sums.map(|sum| sum.min(1.0) * shader.full_scale() as f64)
}

/// On the port's own vectors with the quadratic in place of the power only the hardware's roundings are left: half a
/// code for the output, and little beside it. On exact vectors with the power the error stays within what the account
/// states of it.
#[test]
fn the_hardware_is_near_a_shader_in_double_precision() {
    let quadratics = specs().into_iter().filter(|spec| spec.contains("quadratic") && !spec.contains("vector_fraction"));
    quadratics.collect::<Vec<_>>().par_iter().for_each(|spec| {
        let design = design(spec);
        let Account::Shader(account) = Account::of(&design) else { panic!("a shader's account") };
        assert_eq!(account.parts.len(), 5);
        let [low, high] = account.whole.codes;
        let mut rng = Rng::new(7);
        for _ in 0..20_000 {
            let sample = random_sample(&design, &mut rng);
            let rounded = sample.quantised(shader(&design));
            let hardware = design.evaluate(&sample.codes(shader(&design)));
            let quadratic = |n: f64, x: f64| (x * (1.0 - Quadratic::new(n).unwrap().a * (1.0 - x))).max(0.0);
            let method = in_double(&design, &rounded, quadratic);
            let exact = in_double(&design, &sample, |n, x| x.powf(n));
            // A highlight of n = 128 has a slope of 102 at its top; the cosine has errors of three of its dot products'
            // last bits, and where these are divided by a root of s = 2 + 2 L.V of more.
            let full = shader(&design).full_scale() as f64;
            let allowed = rounded.lights.iter().fold(0.6, |sum, light| {
                let lv: f64 = light.direction.iter().zip(rounded.viewer).map(|(a, b)| a * b).sum();
                let root = if shader(&design).cosine == Cosine::Sqrt { 1.0 / (2.0 + 2.0 * lv).max(1e-9) } else { 0.0 };
                sum + 0.2
                    + full * 102.0 * (3.0 + root) * 2f64.powi(-(design.lobe().interface.input_fraction as i32) - 2)
            });
            for channel in 0..3 {
                let (got, method) = (hardware[channel] as f64, method[channel]);
                assert!((got - method).abs() < allowed, "{spec}\n{sample:?}: {got}, in double precision {method}");
                let error = got - exact[channel];
                let on_horizon = rounded
                    .angles(shader(&design))
                    .iter()
                    .zip(sample.angles(shader(&design)))
                    .any(|(a, b)| (a.diffuse > 0.0) != (b.diffuse > 0.0));
                assert!(on_horizon || (low - 1.0..=high + 1.0).contains(&error), "{spec}\n{sample:?}: {error}");
            }
        }
        // The parts say what they should: the method's error is that of the quadratic, the rounding of the output half
        // a code.
        let part = |name: &str| account.parts.iter().find(|part| part.name == name).expect(name);
        assert!(part("method").rms > part("arithmetic").rms, "{account:?}");
        assert!((0.1..0.45).contains(&part("arithmetic").rms), "{account:?}");
    });
}

#[test]
fn every_shader_passes_in_icarus_and_ghdl_and_lints_clean() {
    specs().par_iter().enumerate().for_each(|(place, spec)| {
        let core = OnDisk::new(spec);
        // GHDL interprets: it takes most of the time, and analyses the others below.
        let ghdl = (common::all() || place % 2 == 0).then_some(Sim::Ghdl);
        for sim in [Sim::Builtin, Sim::Icarus].into_iter().chain(ghdl) {
            let outcome = core.run(sim);
            assert!(outcome.passed(), "{spec}\n{outcome:?}");
            assert_eq!(outcome.vectors, core.golden.vectors().len() as u64);
        }
        let work = core.beside("work");
        std::fs::create_dir(&work).expect("a directory");
        let (out, workdir) = (work.join("out").display().to_string(), format!("--workdir={}", work.display()));
        silent(core.path(), "verilator", &["--lint-only", "-Wall", "rtl/shader.v"], spec);
        silent(core.path(), "iverilog", &["-Wall", "-g2005", "-o", &out, "rtl/shader.v", "tb/shader_tb.v"], spec);
        silent(core.path(), "ghdl", &["-a", "--std=08", &workdir, "rtl/shader.vhd", "tb/shader_tb.vhd"], spec);
        for file in ["rtl/shader.v", "rtl/shader.vhd", "tb/shader_tb.v", "tb/shader_tb.vhd"] {
            let text = std::fs::read_to_string(core.path().join(file)).expect("text");
            let long = text.lines().find(|line| line.len() > 100 || line.ends_with(' '));
            assert_eq!(long, None, "{file} of {spec}");
        }
    });
}

#[test]
fn front_ends_pass_in_verilator() {
    let all = specs();
    let some = if common::all() { vec![&all[0], &all[4], &all[5]] } else { vec![&all[4]] };
    for spec in some {
        let outcome = OnDisk::new(spec).run(Sim::Verilator);
        assert!(outcome.passed(), "{spec}\n{outcome:?}");
    }
}

/// What a name in the HDL is followed by is its stage, which changes with the schedule: a fault is injected by a part
/// of a line.
type Fault = (&'static str, Language, &'static str, &'static str, &'static str);

/// A line that holds the first text gets the third for the second.
const FAULTS: &[Fault] = &[
    ("N.V for N.L", Language::Verilog, "nl1_x_0 =", "in_l1x", "in_vx"),
    ("a sign lost", Language::Verilog, "x1_exact_", " - ", " + "),
    ("light from behind", Language::Verilog, "spec1_", "dark1_", "~dark1_"),
    ("no saturation", Language::Verilog, "kept_g_", "(|", "(1'b0 & |"),
    ("another material", Language::Verilog, "case (in_material", "in_material", "~in_material"),
    ("a light lost", Language::Verilog, " lights2_b_", " + ", " & "),
    ("channels swapped", Language::Verilog, "assign out_r", "code_r", "code_g"),
    ("rounded down", Language::Vhdl, "sum_half_r_", " + to_unsigned(", " - to_unsigned("),
    ("clamped at another value", Language::Vhdl, "kept_b_", "255", "254"),
];

#[test]
fn broken_shaders_fail() {
    let spec = text("method = 'quadratic'", "lights = 2");
    let right = Generated::new(&spec);
    FAULTS.par_iter().for_each(|(what, language, line, from, to)| {
        let core = right.on_disk();
        let file = core.rtl(*language);
        let text = std::fs::read_to_string(&file).expect("HDL");
        let place = text.match_indices(line).find(|(place, _)| {
            let end = text[*place..].find(';').map_or(text.len(), |end| place + end);
            text[*place..end].contains(from)
        });
        let (place, _) = place.unwrap_or_else(|| panic!("{what}: `{line}` with `{from}` is in the core"));
        let faulty = format!("{}{}", &text[..place], text[place..].replacen(from, to, 1));
        std::fs::write(&file, faulty).expect("written");
        let outcome = core.run(if *language == Language::Verilog { Sim::Icarus } else { Sim::Ghdl });
        assert!(!outcome.passed(), "{what} goes unnoticed: {outcome:?}");
        assert!(outcome.vectors > 0 && outcome.first[0].contains("expected"), "{what}: {outcome:?}");
    });
}

/// A ROM word with a flipped bit changes the answer to some golden vector, but for last bits that hardly any sample
/// shows.
#[test]
fn golden_vectors_notice_flipped_rom_bits() {
    let design = design(&text("method = 'quadratic'", "lights = 2"));
    let golden = Golden::of(&design);
    let (mut flips, mut missed) = (0, 0);
    for memory in 0..design.tables().len() {
        for field in 0..design.tables()[memory].fields.len() {
            let format = design.tables()[memory].fields[field].format;
            for row in 0..3 {
                for bit in 0..format.width() {
                    let mut tables = design.tables().to_vec();
                    let code = &mut tables[memory].fields[field].codes[row];
                    *code = format.wrap(*code ^ (1 << bit));
                    let noticed = golden.vectors().iter().any(|vector| {
                        let inputs: Vec<i128> = vector.inputs.iter().copied().map(i128::from).collect();
                        let values = design.graph().values(&tables, &inputs);
                        design
                            .graph()
                            .outputs
                            .iter()
                            .zip(&vector.outputs)
                            .any(|(&(_, node), &want)| values[node] != i128::from(want))
                    });
                    (flips, missed) = (flips + 1, missed + i32::from(!noticed));
                }
            }
        }
    }
    println!("{missed} of {flips} flipped bits go unnoticed");
    // Materials without a highlight do not show their lobe's coefficient.
    assert!(flips > 300 && missed * 20 < flips, "{missed} of {flips} flipped bits go unnoticed");
}

#[test]
fn golden_files_are_read_back_and_changes_are_found() {
    let design = design(&specs()[2]);
    let golden = Golden::of(&design);
    let text = golden.to_text(&design);
    assert!(golden.digests.len() == 3 && golden.vectors().len() > 1000);
    let read = golden::parse(&design, &text, "test").expect("its own text");
    assert_eq!(golden::differences(&design, &golden, &read), []);
    let mut changed = read.clone();
    let group = changed.groups.iter_mut().find(|(heading, _)| heading.starts_with("every code"));
    group.expect("a group of that heading").1[0].outputs[1] ^= 1;
    changed.digests[1].digest ^= 1;
    let found: Vec<String> = golden::differences(&design, &golden, &changed).iter().map(ToString::to_string).collect();
    assert_eq!(found.len(), 2, "{found:?}");
    assert!(found[0].starts_with("in_material = 0 (plastic), in_nx = 0 (0)"), "{}", found[0]);
    assert!(found[1].starts_with("digest of in_material = 1: expected"), "{}", found[1]);
    let job = Job { design: &design, golden: &changed, directory: std::path::Path::new(".") };
    let outcome = cosim::golden(Sim::Builtin, &job).expect("it runs");
    assert!(!outcome.passed() && outcome.mismatches == 1, "{outcome:?}");
}

#[test]
fn every_pipeline_depth_computes_the_same() {
    let depths: &[u32] = if common::all() { &[1, 2, 5, 9, 30] } else { &[1, 5, 30] };
    for &depth in depths {
        let core = design(&text(&format!("method = 'cubic'\npipeline = {depth}"), "model = 'blinn'\nfront = 'sqrt'"));
        assert_eq!(core.schedule.latency, depth);
        let golden = Golden::of(&core);
        let job = Job { design: &core, golden: &golden, directory: std::path::Path::new(".") };
        let outcome = cosim::golden(Sim::Builtin, &job).expect("it runs");
        assert!(outcome.passed(), "{depth}: {outcome:?}");
    }
}

#[test]
fn resolved_specs_survive_toml() {
    for spec in specs() {
        let resolved = design(&spec).spec;
        let again =
            SpecFields::parse(&resolved.to_toml(), "again").and_then(SpecFields::resolve).expect("its own text");
        assert_eq!(again, resolved);
    }
}

#[test]
fn wrong_specs_are_refused() {
    let base = |shader: &str| text("method = 'quadratic'", shader);
    let lobe = "method = 'quadratic'\nshininess = [5]\n";
    for (text, expected) in [
        (base("lights = 0"), "lights = 0"),
        (base("lights = 9"), "from 1 to 8"),
        (base("channel_bits = 9"), "8, 10 or 12"),
        (base("vector_fraction = 30"), "from 8 to 20"),
        (base("front = 'half'"), "phong has no front"),
        (base("model = 'gouraud'"), "`gouraud`"),
        (base("colour = 3"), "unknown key `colour`"),
        (base("ambient_light = [1, 1]"), "has 2 numbers"),
        (base("ambient_light = [1, 1, 2]"), "ambient_light = 2"),
        (base("light_colours = [[1, 1, 1], [0, 0, 0]]"), "2 light colours are given for 1 lights"),
        (base("light_colours = [[1, 1, -1]]"), "light_colours = -1"),
        (base("light_colours = 'red'"), "`red` is no colour"),
        (text("method = 'quadratic'\noperand = 'cos'", ""), "its own cosine"),
        (base("") + "[[material]]\nname = 'x'\nshininess = 2\nambient = 1.5", "material x: ambient = 1.5"),
        (base("") + "[[material]]\nname = 'x'\nshininess = 2\ncolour = [0, nan, 0]", "material x: colour = NaN"),
        (base("") + "[[material]]\nname = 'x'\nshininess = 2\ncolour = [0, 1]", "length"),
        ("block = 'shader'\nmethod = 'quadratic'\nshininess = [5]".to_owned(), "serves materials"),
        ("block = 'shader'\nmethod = 'quadratic'".to_owned(), "given no materials"),
        ("block = 'lamp'".to_owned(), "`lamp`"),
        (format!("{lobe}[shader]\nlights = 2"), "for a lobe"),
        (
            "method = 'quadratic'\n[[material]]\nname = 'x'\nshininess = 2\ndiffuse = 1".to_owned(),
            "a lobe has no colours",
        ),
    ] {
        let refused = SpecFields::parse(&text, "test").and_then(SpecFields::resolve).expect_err(&text);
        let (Error::Input { what, allowed } | Error::Text { what, allowed, .. }) = refused else { panic!("{refused}") };
        let message = format!("{what} | {allowed}");
        assert!(message.contains(expected), "{text}\n{message}\nexpected: {expected}");
    }
}

/// The commands that make no sense for a shader say so; the others work from flags alone.
#[test]
fn commands_take_or_refuse_a_shader() {
    let scratch = tempfile::tempdir().expect("a directory");
    let run = |line: &str| {
        let program = env!("CARGO_BIN_EXE_brdfgen");
        let output = Command::new(program).current_dir(&scratch).args(line.split_whitespace()).output().expect(program);
        (
            output.status.code(),
            String::from_utf8_lossy(&output.stdout).into_owned(),
            String::from_utf8_lossy(&output.stderr).into_owned(),
        )
    };
    let flags =
        "--block shader --method quadratic --material a=5 --material b=60 --lights 2 --light-colours 1,0.5,0;0,0,1";
    let (code, out, error) = run(&format!("generate {flags} --out core"));
    assert_eq!(code, Some(0), "{out}{error}");
    assert!(out.contains("front end") && out.contains("PASS"), "{out}");
    assert_eq!(run("generate core --check --out core").0, Some(0));
    assert_eq!(run("golden core --check core/golden/shader.vec").0, Some(0));
    assert_eq!(run("rom core --check core/rom/shader_colours.mem").0, Some(0));
    assert_eq!(run("rom core --out all").0, Some(0));
    for (line, word) in [("eval core -n 5 -x 1", "is a shader"), ("cosim core --sim all --exhaustive", "too many")] {
        let (code, out, error) = run(line);
        assert!(code == Some(2) && out.is_empty() && error.contains(word), "{line}: {out}{error}");
    }
}

/// The reference core takes a DSP block a multiplier of up to 18 bits, and no more block RAM than it has large
/// memories.
#[test]
fn yosys_synthesises_the_reference_core() {
    let source = concat!(env!("CARGO_MANIFEST_DIR"), "/generated/shader/rtl/shader.v");
    let count = ecp5_cells(std::path::Path::new(source), "shader");
    let [dsp, ram, luts, registers] = ["MULT18X18D", "DP16KD", "LUT4", "TRELLIS_FF"].map(count);
    println!("shader: LUT4 {luts} FF {registers} DSP {dsp} BRAM {ram}");
    assert!((15..=45).contains(&dsp) && ram <= 8 && luts > 0, "{dsp} DSP, {ram} BRAM, {luts} LUT4");
}
