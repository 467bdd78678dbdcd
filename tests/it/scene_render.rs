//! `brdfgen render`: the files, the figures, the flags; the model against the compiled core.
//!
//! Needs verilator; `test.sh` installs it.

use std::io::Cursor;

use serde_json::Value;

use crate::common::Scratch;

/// Two spheres on a plane under two lights.
const SPHERES: &str = r#"
name = "spheres"
width = 60
height = 40
background = [0.1, 0.1, 0.2]
[camera]
position = [0, 0.5, 6]
field_of_view = 35
[[material]]
name = "matt"
shininess = 8
k_d = 0.5
k_s = 0.5
[[material]]
name = "bright"
shininess = 120
k_d = 0.4
k_s = 0.6
colour = [0.9, 0.3, 0.2]
[[light]]
direction = [1, 1, 1]
[[light]]
position = [-3, 3, 3]
colour = [0.3, 0.4, 0.5]
[[object]]
kind = "sphere"
material = "matt"
centre = [-1, 0, 0]
radius = 0.9
[[object]]
kind = "sphere"
material = "bright"
centre = [1, 0, 0]
radius = 0.9
[[object]]
kind = "plane"
material = "matt"
point = [0, -0.9, 0]
normal = [0, 1, 0]
[budget]
max_steps = 2
"#;

/// The same spheres, seen from elsewhere, with half vectors and 10 bits a channel.
fn other_scene() -> String {
    let changed = SPHERES.replace("position = [0, 0.5, 6]", "position = [3, 2, 4]").replace("spheres\"", "second\"");
    format!("model = \"blinn\"\nchannel_bits = 10\n{changed}")
}

fn scratch() -> Scratch {
    let scratch = Scratch::new();
    scratch.write("spheres.toml", SPHERES);
    scratch.write("others.toml", other_scene());
    scratch
}

struct Png {
    width: u32,
    height: u32,
    bits: u32,
    pixels: Vec<[u16; 3]>,
}

impl Png {
    fn at(&self, x: u32, y: u32) -> [u16; 3] {
        self.pixels[(y * self.width + x) as usize]
    }
}

fn png(bytes: &[u8]) -> Png {
    let mut reader = png::Decoder::new(Cursor::new(bytes)).read_info().unwrap();
    let mut data = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut data).unwrap();
    assert_eq!(info.color_type, png::ColorType::Rgb);
    let (bits, channels): (u32, Vec<u16>) = match info.bit_depth {
        png::BitDepth::Eight => (8, data.iter().map(|&byte| byte.into()).collect()),
        png::BitDepth::Sixteen => (16, data.as_chunks::<2>().0.iter().map(|&pair| u16::from_be_bytes(pair)).collect()),
        other => panic!("{other:?}"),
    };
    Png { width: info.width, height: info.height, bits, pixels: channels.as_chunks::<3>().0.to_vec() }
}

/// The codes of a picture's channels, from the full range of its file.
fn codes(png: &Png, channel_bits: u32) -> Vec<[i64; 3]> {
    let (full, top) = (f64::from((1u32 << channel_bits) - 1), f64::from((1u32 << png.bits) - 1));
    let code = |stored: u16| (f64::from(stored) * full / top).round() as i64;
    png.pixels.iter().map(|pixel| pixel.map(code)).collect()
}

/// The figures, computed anew from two pictures: those of `Difference`, and how far each pixel is off.
fn figures(exact: &[[i64; 3]], core: &[[i64; 3]], channel_bits: u32) -> (Vec<i64>, Vec<u64>, f64, f64) {
    let off = |c: usize, (a, b): (&[i64; 3], &[i64; 3])| (a[c] - b[c]).abs();
    let steps: Vec<i64> = exact.iter().zip(core).map(|pair| (0..3).map(|c| off(c, pair)).max().unwrap()).collect();
    let mut pixels = vec![0; *steps.iter().max().unwrap() as usize + 1];
    steps.iter().for_each(|&steps| pixels[steps as usize] += 1);
    let all: Vec<f64> = exact.iter().zip(core).flat_map(|pair| [0, 1, 2].map(|c| off(c, pair) as f64)).collect();
    let mean = all.iter().sum::<f64>() / all.len() as f64;
    let square = all.iter().map(|d| d * d).sum::<f64>() / all.len() as f64;
    let full = f64::from((1u32 << channel_bits) - 1);
    (steps, pixels, mean, 20.0 * (full / square.sqrt()).log10())
}

/// The colours of the heat map as the program documents them: not off, off by 1, 2, up to 4, 8, 16, 32, 64 and more.
const HEAT: [(i64, [u16; 3]); 9] = [
    (0, [0x0a, 0x0c, 0x10]),
    (1, [0x72, 0x01, 0xa8]),
    (2, [0x9c, 0x17, 0x9e]),
    (4, [0xbd, 0x37, 0x86]),
    (8, [0xd8, 0x57, 0x6b]),
    (16, [0xed, 0x79, 0x53]),
    (32, [0xfb, 0x9f, 0x3a]),
    (64, [0xfd, 0xca, 0x26]),
    (i64::MAX, [0xf0, 0xf9, 0x21]),
];
const NO_OBJECT: [u16; 3] = [0x40; 3];

fn is_heat_of(colour: [u16; 3], steps: i64) -> bool {
    let wanted = HEAT.iter().find(|(last, _)| steps <= *last).unwrap().1;
    colour == wanted || steps == 0 && colour == NO_OBJECT
}

#[test]
fn the_figures_are_those_of_the_files() {
    for (file, bits) in [("spheres.toml", 8), ("others.toml", 10)] {
        let scratch = scratch();
        let line = |rest: &str| format!("render {file} --method quadratic --json {rest}");
        let run = scratch.run(&line("--out all.png --exr all.exr")).ends_with(1);
        let json = run.json();
        for (only, code) in [("exact", 0), ("core", 1), ("difference", 1)] {
            scratch.run(&line(&format!("--out {only}.png --only {only}"))).ends_with(code);
        }
        let [all, exact, core, heat] =
            ["all", "exact", "core", "difference"].map(|name| png(&scratch.read(format!("{name}.png"))));
        assert_eq!([exact.bits, core.bits, heat.bits, all.bits], if bits == 8 { [8; 4] } else { [16, 16, 8, 16] });
        assert_eq!((exact.width, exact.height), (60, 40));
        let (steps, pixels, mean, psnr) = figures(&codes(&exact, bits), &codes(&core, bits), bits);
        let difference = &json["core"]["difference"];
        assert!(steps.iter().max().unwrap() > &4, "the quadratic is visibly off");
        assert_eq!(difference["max_steps"], *steps.iter().max().unwrap());
        assert_eq!(difference["pixels"], serde_json::json!(pixels));
        assert!((difference["mean_steps"].as_f64().unwrap() - mean).abs() < 1e-9);
        assert!((difference["psnr"].as_f64().unwrap() - psnr).abs() < 1e-9);
        assert_eq!(json["kept"], false);

        // The heat map has each pixel's class, and is neutral only where nothing is.
        for (pixel, &steps) in steps.iter().enumerate() {
            assert!(is_heat_of(heat.pixels[pixel], steps), "pixel {pixel}, {steps} steps: {:?}", heat.pixels[pixel]);
        }
        let neutral = heat.pixels.iter().filter(|&&colour| colour == NO_OBJECT).count();
        // From above the plane fills the picture.
        assert_eq!((100..2000).contains(&neutral), file == "spheres.toml", "{neutral}");
        assert!(heat.pixels.iter().any(|&colour| colour == HEAT[0].1));

        // The page has the very pixels, each as a square.
        let panels = json["panels"].as_array().unwrap();
        assert_eq!(panels.len(), 3);
        for (panel, (shows, single)) in panels.iter().zip([("exact", &exact), ("core", &core), ("difference", &heat)]) {
            assert_eq!(panel["shows"], shows);
            let [left, top, zoom] = ["left", "top", "zoom"].map(|key| panel[key].as_u64().unwrap() as u32);
            assert!(zoom > 1, "a small picture is enlarged");
            for y in 0..40 * zoom {
                for x in 0..60 * zoom {
                    let deeper = if all.bits == single.bits { 1 } else { 257 };
                    let wanted = single.at(x / zoom, y / zoom).map(|channel| channel * deeper);
                    assert_eq!(all.at(left + x, top + y), wanted, "{shows} at {x}, {y}");
                }
            }
        }

        // The layers of the OpenEXR file are the pictures in parts of full scale, and what they differ by in steps.
        let image = {
            use exr::prelude::*;
            let read = read().no_deep_data().largest_resolution_level().all_channels().all_layers().all_attributes();
            read.from_file(scratch.path("all.exr")).unwrap()
        };
        let layer = |place: usize, name: &str, channel: &str| -> Vec<f32> {
            let layer = &image.layer_data[place];
            assert_eq!(layer.attributes.layer_name.as_ref().unwrap().to_string(), name);
            let data = layer.channel_data.list.iter().find(|data| data.name.eq(channel)).unwrap();
            data.sample_data.values_as_f32().collect()
        };
        let full = ((1u32 << bits) - 1) as f32;
        for (c, channel) in ["R", "G", "B"].into_iter().enumerate() {
            let layers = [layer(0, "exact", channel), layer(1, "core", channel), layer(2, "difference", channel)];
            for (pixel, (e, k)) in codes(&exact, bits).iter().zip(codes(&core, bits)).enumerate() {
                assert_eq!(layers[0][pixel], e[c] as f32 / full);
                assert_eq!(layers[1][pixel], k[c] as f32 / full);
                assert_eq!(layers[2][pixel], (k[c] - e[c]) as f32);
            }
        }
    }
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    let scratch = scratch();
    for round in 0..2 {
        let line = format!("render spheres.toml --method cubic --out {round}.png --exr {round}.exr");
        let run =
            scratch.command().args(line.split_whitespace()).env("RAYON_NUM_THREADS", (1 + 2 * round).to_string()).ok();
        // Over the budget or not: it was drawn.
        let code = run.map_or_else(|error| error.as_output().unwrap().status.code(), |output| output.status.code());
        assert!(matches!(code, Some(0 | 1)), "{code:?}");
        scratch.run(&format!("render spheres.toml --compare=cubic,lyon-4 --out c{round}.png")).succeeds();
    }
    assert_eq!(scratch.read("0.png"), scratch.read("1.png"));
    assert_eq!(scratch.read("0.exr"), scratch.read("1.exr"));
    assert_eq!(scratch.read("c0.png"), scratch.read("c1.png"));
}

#[test]
fn the_compiled_core_gives_the_models_picture() {
    let scratch = scratch();
    for scene in ["spheres.toml", "others.toml"] {
        for method in ["quadratic", "cubic-min-zero --operand versine"] {
            let pictures = ["model", "verilator"].map(|through| {
                let line = format!("render {scene} --method {method} --out {through}.png --exr {through}.exr --json");
                let mut command = scratch.command();
                command.timeout(std::time::Duration::from_secs(600));
                let output = command.args(line.split_whitespace()).args(["--through", through]).output().unwrap();
                assert_eq!(output.status.code(), Some(1), "{}", String::from_utf8_lossy(&output.stderr));
                let json: Value = serde_json::from_slice(&output.stdout).unwrap();
                assert_eq!(json["core"]["through"], through);
                assert!(json["samples"].as_u64().unwrap() > 1000);
                [scratch.read(format!("{through}.png")), scratch.read(format!("{through}.exr"))]
            });
            assert_eq!(pictures[0], pictures[1], "{scene} {method}");
        }
    }
}

#[test]
fn a_changed_coefficient_gives_another_picture() {
    let scratch = scratch();
    scratch.run("generate --method quadratic --shininess 8,120 --languages verilog --name own --out own").succeeds();
    let verilog = scratch.text("own/rtl/own.v");
    // The first row of the coefficient ROM.
    let line = verilog
        .lines()
        .find(|line| line.contains("'d0: ") && line.contains("'h"))
        .unwrap_or_else(|| panic!("{verilog}"));
    let (head, word) = line.rsplit_once("'h").unwrap();
    let digits: String = word.chars().take_while(char::is_ascii_hexdigit).collect();
    let changed = u64::from_str_radix(&digits, 16).unwrap() ^ 1 << (4 * digits.len() - 6);
    let other = format!("{head}'h{changed:0width$x}{}", &word[digits.len()..], width = digits.len());
    let render = |through: &str| {
        let line = format!("render spheres.toml --core own --only core --out p.png --through {through}");
        let mut command = scratch.command();
        command.timeout(std::time::Duration::from_secs(600));
        let output = command.args(line.split_whitespace()).output().unwrap();
        assert_eq!(output.status.code(), Some(1), "{}", String::from_utf8_lossy(&output.stderr));
        scratch.read("p.png")
    };
    let model = render("model");
    assert_eq!(render("verilator"), model);
    scratch.write("own/rtl/own.v", verilog.replace(line, &other));
    assert_ne!(render("verilator"), model, "{line} became {other}");
    assert_eq!(render("model"), model);
}

#[test]
fn a_missing_or_failing_verilator_is_said() {
    let scratch = scratch();
    let empty = scratch.path("empty");
    std::fs::create_dir(&empty).unwrap();
    scratch
        .run_with_path(&empty, "render spheres.toml --method lyon-2 --through verilator --out p.png")
        .refuses(&["verilator is needed for this and is not installed", "apt-get install verilator"]);
    scratch.run("generate --method lyon-2 --shininess 8,120 --languages verilog --name own --out own").succeeds();
    scratch.write("own/rtl/own.v", "module own; broken endmodule");
    scratch.run("render spheres.toml --core own --through verilator --out p.png").refuses(&["verilator failed"]);
    assert!(!scratch.path("p.png").exists());
}

#[test]
fn the_exit_code_says_whether_the_budget_is_kept() {
    let scratch = scratch();
    let exact = "--method log-exp --out p.png";
    scratch.run(&format!("render spheres.toml {exact}")).succeeds().says(&["within the budget: at most 2 steps off"]);
    let miss = scratch.run("render spheres.toml --method quadratic --out p.png").ends_with(1);
    miss.says(&[
        "core quadratic: quadratic",
        "the picture is off by ",
        " steps where 2 are allowed",
        "p.png",
        "traced in",
    ]);
    scratch.write("psnr.toml", SPHERES.replace("max_steps = 2", "min_psnr = 300"));
    scratch.run("render psnr.toml --method cubic --out p.png").ends_with(1).says(&["where 300 dB are wanted"]);
    // Nothing is compared where only the exact picture is drawn.
    scratch.run("render spheres.toml --only exact --out p.png").succeeds();
}

#[test]
fn without_a_core_the_scene_gets_the_one_that_it_needs() {
    let scratch = scratch();
    let run = scratch.run("render spheres.toml --size 30x20 --margin 0 --out p.png --json").ends_with(0);
    let json = run.json();
    assert_eq!(json["kept"], true);
    assert!(json["core"]["difference"]["max_steps"].as_u64().unwrap() <= 2);
    // The core that is named is the one that was drawn.
    let flags = json["core"]["flags"].as_str().unwrap();
    assert!(flags.contains("--method"), "{flags}");
    let again =
        scratch.run(&format!("render spheres.toml --size 30x20 --out q.png --json {flags}")).ends_with(0).json();
    assert_eq!(again["core"]["digest"], json["core"]["digest"]);
    assert_eq!(scratch.read("p.png"), scratch.read("q.png"));
}

#[test]
fn cores_come_from_specs_directories_and_flags() {
    let scratch = scratch();
    scratch.write("own.toml", "method = \"power-4\"\nname = \"own\"\nshininess = \"1..=200\"\n");
    scratch.run("generate own.toml --languages verilog --out own").succeeds();
    let digest = |core: &str| {
        let run = scratch.run(&format!("render spheres.toml --size 24x16 --json --out p.png {core}"));
        assert!(run.code < 2, "{}", run.stderr);
        let json = run.json();
        assert_eq!((&json["width"], &json["height"]), (&24.into(), &16.into()));
        json["core"]["flags"].as_str().unwrap().to_owned()
    };
    let own = digest("--core own.toml");
    assert!(own.contains("--shininess 1..=200") && own.contains("--name own"), "{own}");
    assert!(digest("--core own").contains("--shininess 1..=200"));
    assert!(digest("--core own.toml --output-fraction 9").contains("--output-fraction 9"));
    // Without a set of its own, a core is for the scene's shininesses.
    assert!(digest("--method cubic").contains("--shininess 8,120"));
    assert!(digest("--method cubic --shininess 1..=1000").contains("--shininess 1..=1000"));
}

#[test]
fn a_contact_sheet_shows_every_core() {
    let scratch = scratch();
    scratch.write("own.toml", "method = \"power-2\"\n");
    let line = "render spheres.toml --compare=quadratic,log-exp:accuracy=9,own.toml --out sheet.png";
    let json = scratch.run(&format!("{line} --json")).succeeds().json();
    let page = png(&scratch.read("sheet.png"));
    assert!(page.width < 3000 && page.height < 3000);
    let cores = json["cores"].as_array().unwrap();
    assert_eq!(cores.len(), 3);
    let names: Vec<&str> = cores.iter().map(|core| core["name"].as_str().unwrap()).collect();
    assert!(names[0].starts_with("quadratic") && names[1].contains("accuracy=9") && names[2].starts_with("power-2"));
    for core in cores {
        assert_eq!(core["cost"]["estimated"], true);
        assert!(core["cost"]["lut"].as_u64().unwrap() > 10);
        assert!(core["cost"]["latency"].as_u64().unwrap() > 1);
    }
    // Each cell has the core's own picture and its heat map.
    let panels = json["panels"].as_array().unwrap();
    let kinds: Vec<&str> = panels.iter().map(|panel| panel["shows"].as_str().unwrap()).collect();
    assert_eq!(kinds, ["exact", "core", "difference", "core", "difference", "core", "difference"]);
    let panel = |place: usize| -> Vec<[i64; 3]> {
        let [left, top, zoom] = ["left", "top", "zoom"].map(|key| panels[place][key].as_u64().unwrap() as u32);
        let pixel = |place: u32| page.at(left + place % 60 * zoom, top + place / 60 * zoom).map(i64::from);
        (0..60 * 40).map(pixel).collect()
    };
    for (place, core) in cores.iter().enumerate() {
        let (steps, pixels, ..) = figures(&panel(0), &panel(1 + 2 * place), 8);
        assert_eq!(core["difference"]["pixels"], serde_json::json!(pixels));
        for (colour, steps) in panel(2 + 2 * place).into_iter().zip(steps) {
            assert!(is_heat_of(colour.map(|channel| channel as u16), steps));
        }
        assert_eq!(core["kept"], pixels.len() <= 3);
    }
    let text = scratch.run(line).succeeds();
    text.says(&["estimated", "LUTs", "quadratic", "PSNR", "clocks", "sheet.png"]);
    // Without a list there is one.
    let json = scratch.run("render spheres.toml --compare --size 20x12 --json --out sheet.png").succeeds().json();
    assert_eq!(json["cores"].as_array().unwrap().len(), 7);
}

#[test]
fn pictures_can_be_tiny_wide_or_tall() {
    let scratch = scratch();
    for size in ["1x1", "200x3", "3x200"] {
        let run = scratch.run(&format!("render spheres.toml --method lyon-8 --size {size} --out p.png --json"));
        assert!(run.code < 2, "{}", run.stderr);
        let page = png(&scratch.read("p.png"));
        assert!(page.width >= 720 && page.width < 2000 && page.height < 3000, "{} x {}", page.width, page.height);
        // Wide ones stand one above the other.
        let panels = run.json()["panels"].clone();
        assert_eq!(panels[0]["left"] == panels[1]["left"], size == "200x3");
    }
}

#[test]
fn bad_input_is_refused_and_nothing_is_written() {
    let scratch = scratch();
    scratch.write("spec.toml", "method = \"cubic\"\n");
    scratch.write("shader.toml", "method = \"cubic\"\nblock = \"shader\"\n");
    std::fs::create_dir(scratch.path("folder")).unwrap();
    let out = "--out p.png";
    for (line, words) in [
        (format!("render spec.toml {out}"), vec!["spec.toml is the spec of a core, and no scene", "--core spec.toml"]),
        (format!("render folder {out}"), vec!["folder is a directory, and no scene"]),
        (format!("render none.toml {out}"), vec!["cannot read none.toml"]),
        (format!("render spheres.toml --core others.toml {out}"), vec!["others.toml is a scene, and no core"]),
        (format!("render spheres.toml --core shader.toml {out}"), vec!["is a shader", "highlights need a lobe"]),
        (format!("render spheres.toml --core none.toml {out}"), vec!["cannot read none.toml"]),
        (format!("render spheres.toml --method cubic --size 0x5 {out}"), vec!["WIDTHxHEIGHT"]),
        (format!("render spheres.toml --method cubic --size 5 {out}"), vec!["WIDTHxHEIGHT"]),
        (format!("render spheres.toml --method cubic --size 99999x5 {out}"), vec!["1 to 16384"]),
        (format!("render spheres.toml --method cubic --through icarus {out}"), vec!["icarus", "verilator"]),
        (format!("render spheres.toml --method cubic --only both {out}"), vec!["both", "difference"]),
        (format!("render spheres.toml --compare --method cubic {out}"), vec!["cannot be used with"]),
        (format!("render spheres.toml --compare --exr p.exr {out}"), vec!["cannot be used with"]),
        (format!("render spheres.toml --compare=cube {out}"), vec!["unknown variant `cube`"]),
        (format!("render spheres.toml --compare=cubic:accuracy {out}"), vec!["`accuracy` in `cubic:accuracy`"]),
        (format!("render spheres.toml --compare=cubic:colour=3 {out}"), vec!["unknown key `colour`"]),
        (format!("render spheres.toml --margin 90 {out}"), vec!["margin of 90 degrees"]),
        ("render spheres.toml --method cubic --out nowhere/p.png".to_owned(), vec!["no directory nowhere"]),
        (format!("render spheres.toml --method cubic {out} --exr nowhere/p.exr"), vec!["no directory nowhere"]),
        ("render spheres.toml --method cubic --out folder".to_owned(), vec!["folder is a directory"]),
        ("render spheres.toml --method cubic --json --out -".to_owned(), vec!["standard output"]),
        ("render spheres.toml --method cubic".to_owned(), vec!["--out"]),
    ] {
        scratch.refused(&line, &words);
    }
}

#[test]
fn the_picture_can_go_to_standard_output() {
    let scratch = scratch();
    let line = "render spheres.toml --only exact --out";
    scratch.run(&format!("{line} p.png")).succeeds();
    let output = scratch.command().args(line.split_whitespace()).arg("-").output().unwrap();
    assert_eq!(output.stdout, scratch.read("p.png"));
}
