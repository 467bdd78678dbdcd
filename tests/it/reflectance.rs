//! `brdfgen reflectance` from the outside: what it reads, writes, says and refuses.

use std::collections::BTreeMap;
use std::fs;
use std::time::Duration;

use crate::common::Scratch;

/// The worked points of the paper's form.
const POINTS: &str = include_str!("../data/image_based.csv");

/// A column of CSV text as numbers.
fn column(text: &str, name: &str) -> Vec<f64> {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let place = reader.headers().unwrap().iter().position(|own| own == name).unwrap();
    reader.records().map(|record| record.unwrap()[place].parse().unwrap()).collect()
}

/// The lines of the worked points for a material and a set of images, with the heading.
fn points(material: &str, images: &str) -> String {
    let start = format!("{material},{images},");
    let mut lines = POINTS.lines();
    let heading = lines.next().unwrap();
    std::iter::once(heading)
        .chain(lines.filter(|line| line.starts_with(&start)))
        .fold(String::new(), |text, line| text + line + "\n")
}

/// A directory with a table made from a model.
fn with_table() -> Scratch {
    let scratch = Scratch::new();
    scratch.run("reflectance convert gold.binary --model gold-paint").succeeds().says(&["90 × 90 × 180 cells"]);
    scratch
}

#[test]
fn eval_meets_the_worked_points() {
    let scratch = Scratch::new();
    for (material, images, exposure) in [("blinnphong", "0,45,90,135", 4.2), ("ggx", "0,30,60,90,120,150", 3.8)] {
        let set = if images.len() < 12 { "4" } else { "6" };
        let wanted = points(material, set);
        scratch.write("in.csv", &wanted);
        let line = format!(
            "reflectance eval --model {material} --form paper --images {images} --size 512 --texel float --exposure \
             {exposure} --points in.csv --csv out.csv"
        );
        scratch.run(&line).succeeds().says(&["100 points in out.csv"]);
        let exact = line.replace("--form paper", "--form exact").replace("out.csv", "exact.csv");
        scratch.run(&exact).succeeds();
        for (own, file, tolerance) in [("", "out.csv", 2e-6), ("direct_", "exact.csv", 2e-6)] {
            let read = scratch.text(file);
            for channel in ["r", "g", "b"] {
                let wanted = column(&wanted, &format!("{own}{channel}"));
                let read = column(&read, channel);
                assert_eq!(read.len(), 100);
                // The results stand last, and in place of those that the points had.
                let off = wanted.iter().zip(&read).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                assert!(off < tolerance, "{material} {file} {channel}: {off:e}");
            }
            assert!(read.lines().next().unwrap().ends_with(",direct_b,r,g,b"));
        }
    }
}

#[test]
fn eval_takes_defaults_and_prints_json() {
    let scratch = Scratch::new();
    scratch.write("p.csv", "phi_deg,gamma_deg,nx,ny,nz\n30,10,0,0,1\n180,0,0,0,1\n");
    for (form, kib) in [("half", 48.0), ("bivariate", 3.0), ("paper", 3072.0)] {
        let run = scratch
            .run(&format!("reflectance eval --model ggx --parameter alpha=0.3 --form {form} --points p.csv --json"))
            .succeeds();
        let value = run.json();
        assert_eq!((value["kib"].as_f64(), value["points"].as_u64()), (Some(kib), Some(2)), "{value}");
        let exact = scratch
            .run("reflectance eval --model ggx --parameter alpha=0.3 --form exact --points p.csv --json")
            .succeeds()
            .json();
        let (own, exact) = (value["values"][0][1].as_f64().unwrap(), exact["values"][0][1].as_f64().unwrap());
        assert!((own - exact).abs() < 0.2 * exact, "{form}: {own} {exact}");
        assert!(value["values"][1][0].as_f64().unwrap() < 0.01);
    }
    // To standard output, the texts of the points as they were.
    let run = scratch.run("reflectance eval --model lambert --form exact --exposure 2 --points p.csv").succeeds();
    assert!(run.stdout.starts_with("phi_deg,gamma_deg,nx,ny,nz,r,g,b\n30,10,0,0,1,0.27"), "{}", run.stdout);
}

#[test]
fn tables_are_told_and_converted() {
    let scratch = with_table();
    let info = scratch.run("reflectance info gold.binary --json").succeeds().json();
    assert_eq!((info["kind"].as_str(), info["shape"][2].as_u64()), (Some("merl"), Some(180)));
    let share = info["valid_share"].as_f64().unwrap();
    assert!(share > 0.5 && share < 1.0, "{share}");
    assert!(info["reciprocity_error"].as_f64().unwrap() < 1e-6);
    let albedo = |value: &serde_json::Value| value["albedo"][2]["rgb"][0].as_f64().unwrap();
    let model = scratch.run("reflectance info --model gold-paint --json").succeeds().json();
    assert!((albedo(&info) - albedo(&model)).abs() < 0.01 * albedo(&model), "{info} {model}");
    assert!((info["exposure"].as_f64().unwrap() / model["exposure"].as_f64().unwrap() - 1.0).abs() < 0.01);
    // The same bytes again, and all around and back.
    scratch.run("reflectance convert gold.binary again.binary").succeeds();
    assert!(scratch.read("gold.binary") == scratch.read("again.binary"));
    scratch.run("reflectance convert gold.binary whole.binary --phi-d 360").succeeds();
    assert_eq!(scratch.read("whole.binary").len(), 69_984_012);
    scratch.run("reflectance info whole.binary").succeeds().says(&[
        "90 × 90 × 360 cells",
        "reciprocity error",
        "albedo at 60°",
    ]);
    scratch.run("reflectance convert whole.binary back.binary --phi-d 180").succeeds();
    assert!(scratch.read("gold.binary") == scratch.read("back.binary"));
}

#[test]
fn images_are_written_whole_and_read_back() {
    let scratch = Scratch::new();
    for (form, texel, count, angles) in [
        ("paper", "linear:8", 6, "4"),
        ("paper", "float", 4, "0,90.5"),
        ("half", "sqrt:8", 18, "16"),
        ("bivariate", "sqrt:12", 3, "1"),
    ] {
        let material = "--model aluminium-bronze --exposure 1.5";
        let flags = format!("--form {form} --images {angles} --size 24 --texel {texel}");
        let made = scratch.run(&format!("reflectance images {material} {flags} --out dir --json")).succeeds().json();
        assert_eq!(made["files"].as_array().unwrap().len(), count, "{made}");
        // What an earlier run left has gone.
        assert_eq!(fs::read_dir(scratch.path("dir")).unwrap().count(), count, "{form}");
        scratch.write("p.csv", "phi_deg,gamma_deg,nx,ny,nz\n33,10,0.6,0,0.8\n80,200,0,-0.28,0.96\n120,0,0.8,0,0.6\n");
        scratch.run(&format!("reflectance eval {material} {flags} --points p.csv --csv a.csv")).succeeds();
        scratch.run("reflectance eval dir --points p.csv --csv b.csv").succeeds();
        assert_eq!(scratch.text("a.csv"), scratch.text("b.csv"), "{form} {texel}");
        scratch.run("reflectance info dir").succeeds().says(&[form, "exposure 1.5"]);
    }
    // The same bytes on one thread.
    scratch.run("reflectance images --model ggx --out a --size 32").succeeds();
    let one = scratch
        .command()
        .env("RAYON_NUM_THREADS", "1")
        .args(["reflectance", "images", "--model", "ggx", "--out", "b", "--size", "32"])
        .output()
        .unwrap();
    assert!(one.status.success());
    let tree = |name: &str| -> BTreeMap<_, _> { scratch.tree(name).into_iter().collect() };
    assert_eq!(tree("a"), tree("b"));
}

#[test]
fn wrong_directories_are_refused() {
    let scratch = Scratch::new();
    scratch.run("reflectance images --model ggx --out dir --size 16").succeeds();
    scratch.write("p.csv", "phi_deg,gamma_deg,nx,ny,nz\n30,10,0,0,1\n");
    fs::remove_file(scratch.path("dir/001_phi_45.png")).unwrap();
    scratch.refused("reflectance eval dir --points p.csv --csv out.csv", &["001_phi_45.png", "not there"]);
    scratch.write("other/notes.txt", "mine");
    scratch.refused("reflectance images --model ggx --out other", &["not empty", "sphere images"]);
    scratch.refused("reflectance eval other --points p.csv", &["other has no images.toml"]);
    scratch.refused("reflectance fit dir", &["001_phi_45.png"]);
}

#[test]
fn a_matcap_is_looked_up_without_a_turn() {
    let scratch = Scratch::new();
    scratch
        .run(
            "reflectance images --model red-specular-plastic --images 45, --texel float --size 64 --exposure 1 \
     --border extend --out dir",
        )
        .succeeds();
    fs::copy(scratch.path("dir/000_phi_45.exr"), scratch.path("ball.exr")).unwrap();
    scratch.write("p.csv", "phi_deg,gamma_deg,nx,ny,nz\n45,0,0.28,0,0.96\n120,77,0.28,0,0.96\n");
    scratch.run("reflectance eval ball.exr --points p.csv --csv matcap.csv").succeeds();
    scratch.run("reflectance eval dir --points p.csv --csv paper.csv").succeeds();
    let (matcap, paper) = (column(&scratch.text("matcap.csv"), "r"), column(&scratch.text("paper.csv"), "r"));
    assert_eq!(matcap[0], matcap[1]);
    assert!((matcap[0] - paper[0]).abs() < 1e-6, "{matcap:?} {paper:?}");
    scratch.run("reflectance info ball.exr --json").succeeds().says(&["\"kind\": \"matcap\"", "\"size\": 64"]);
    scratch.refused("reflectance fit ball.exr", &["sphere images, and no reflectance"]);
    scratch.refused("reflectance eval ball.exr --form half --points p.csv", &["is a form already"]);
}

#[test]
fn a_fit_says_how_near_it_is() {
    let scratch = Scratch::new();
    let fits = scratch.run("reflectance fit --model blinnphong --lobes 2 --json").succeeds().json();
    let of = |place: usize, key: &str| fits["fits"][place]["quality"][key].as_f64().unwrap();
    // Blinn's cosine is the model's own; only n·l of the highlight is not.
    assert!(of(0, "mean") > 30.0 && of(0, "mean") > of(1, "mean"), "{fits}");
    scratch.run("reflectance fit --model yellow-plastic --cosine phong").succeeds().says(&[
        "Phong",
        "kd",
        "ks",
        "dB in the mean",
        "steps of 8 bits",
    ]);
    scratch.refused("reflectance fit --model ggx --lobes 4", &["4 lobes", "1 to 3"]);
}

#[test]
fn the_trade_is_written_and_chooses() {
    let scratch = Scratch::new();
    let line = "reflectance trade --model ggx --csv t.csv --svg t.svg --json";
    let all = scratch.run(&format!("{line} --min-psnr 45")).succeeds().json();
    let chosen = &all["chosen"];
    assert!(chosen["mean"].as_f64().unwrap() >= 45.0, "{chosen}");
    let (kib, mean) = (column(&scratch.text("t.csv"), "kib"), column(&scratch.text("t.csv"), "mean"));
    assert!(kib.len() > 100 && kib.is_sorted());
    let least =
        kib.iter().zip(&mean).filter(|(_, mean)| **mean >= 45.0).map(|(kib, _)| *kib).fold(f64::INFINITY, f64::min);
    assert_eq!(chosen["kib"].as_f64(), Some(least));
    let svg = scratch.text("t.svg");
    assert!(svg.contains("half 16×32² sqrt:8: 48.000 KiB") && svg.contains("cos^n, Blinn"));
}

#[test]
fn wrong_tables_are_named() {
    let scratch = Scratch::new();
    scratch.write("p.csv", "phi_deg,gamma_deg,nx,ny,nz\n30,10,0,0,1\n");
    let header = [90u32, 90, 180].map(u32::to_le_bytes).concat();
    let table = |number: f64| [header.clone(), number.to_le_bytes().repeat(3 * 90 * 90 * 180)].concat();
    let good = table(1.0);
    let check = |bytes: &[u8], words: &[&str]| {
        scratch.write("t.binary", bytes);
        for command in [
            "info t.binary",
            "convert t.binary out.binary",
            "images t.binary --out dir",
            "eval t.binary --points p.csv --csv out.csv",
        ] {
            scratch.refused(&format!("reflectance {command}"), words);
        }
    };
    check(&good[..good.len() - 8], &["t.binary", "34992004 bytes", "cut short", "34992012"]);
    check(&[&good[..], &[0; 8]].concat(), &["goes on after the last cell"]);
    check(&table(f64::NAN), &["holds NaN"]);
    check(&table(-1.0), &["all 1458000 cells are invalid"]);
    let mut other = good.clone();
    other[0] = 91;
    check(&other, &["91 × 90 × 180"]);
    let mut big = good.clone();
    big[..12].copy_from_slice(&[0, 0, 0, 90, 0, 0, 0, 90, 0, 0, 0, 180]);
    check(&big, &["big-endian"]);
    check(&b"theta_h theta_d phi_d\n".repeat(34 * 47_000), &["is text"]);
    check(b"tensor_file\0\x01\0\x05\0\0\0", &["RGL tensor"]);
    check(b"", &["is empty"]);
    scratch.refused("reflectance info nothing.binary", &["cannot read nothing.binary"]);
}

#[test]
fn wrong_flags_are_named() {
    let scratch = Scratch::new();
    scratch.write("p.csv", "phi_deg,gamma_deg,nx,ny,nz\n30,10,0,0,1\n");
    let eval = |flags: &str| format!("reflectance eval --model ggx --form paper --points p.csv --csv out.csv {flags}");
    for (flags, words) in [
        ("--images 0,45,40", &["0, 45, 40 do not ascend"][..]),
        ("--images 0,181", &["181° is out of range", "0 to 180"]),
        ("--images -5,20", &["-5° is out of range"]),
        ("--images 0", &["images `0`", "1 to 360"]),
        ("--size 0", &["size 0 is out of range", "2 to 4096"]),
        ("--size 1000000", &["size 1000000 is out of range"]),
        ("--texel linear:40", &["linear:40", "565"]),
        ("--border shrink:2", &["shrink:2", "extend"]),
        ("--behind back", &["back", "literal"]),
        ("--exposure 0", &["--exposure", "above 0"]),
        ("--parameter roughness=1", &["ggx: there is no parameter `roughness`", "alpha"]),
        ("--parameter alpha=2", &["alpha = 2 is out of range", "0.001 to 1"]),
        ("--parameter alpha", &["the parameter `alpha`", "KEY=VALUE"]),
    ] {
        scratch.refused(&eval(flags), words);
    }
    scratch.refused("reflectance info --model chrome", &["no reflectance model `chrome`", "gold-paint"]);
    scratch.refused("reflectance info", &["FILE"]);
    scratch.refused("reflectance convert out.csv --model ggx", &["does not end in .binary"]);
    scratch.refused("reflectance images --model ggx --form exact --out dir", &["`exact` has no images"]);
    for (text, words) in [
        ("phi_deg,gamma_deg,nx,ny\n", &["no column `nz`"][..]),
        ("phi_deg,gamma_deg,nx,ny,nz\n1,2,0,0,1\n1,2,0,x,1\n", &["bad.csv, line 3: ny is `x`"]),
        ("phi_deg,gamma_deg,nx,ny,nz\n1,2,0,0,3\n", &["line 2", "has the length 3"]),
        ("phi_deg,gamma_deg,nx,ny,nz\n181,2,0,0,1\n", &["line 2: phi_deg is 181"]),
        ("phi_deg,gamma_deg,nx,ny,nz\n1,inf,0,0,1\n", &["line 2: gamma_deg is `inf`"]),
        ("phi_deg,gamma_deg,nx,ny,nz\n1,2,0\n", &["bad.csv"]),
        ("", &["no column `phi_deg`"]),
    ] {
        scratch.write("bad.csv", text);
        scratch.refused("reflectance eval --model ggx --form exact --points bad.csv --csv out.csv", words);
    }
}

/// A table of 35 MB is read at once and in little memory.
#[test]
#[cfg(target_os = "linux")]
fn reading_a_table_is_quick() {
    let scratch = with_table();
    let path = scratch.path("gold.binary");
    // The time of the processor, as other tests run at the same time.
    let spent = || {
        let text = fs::read_to_string("/proc/thread-self/schedstat").unwrap();
        Duration::from_nanos(text.split_whitespace().next().unwrap().parse().unwrap())
    };
    let took = (0..5).map(|_| {
        let start = spent();
        brdfgen::reflectance::merl::read(&path).unwrap();
        spent() - start
    });
    let least = took.min().unwrap();
    println!("{least:?}");
    assert!(least < Duration::from_millis(200), "{least:?}");
}

#[test]
fn the_chapter_of_the_extremes_is_as_measured() {
    let scratch = Scratch::new();
    scratch.run("reflectance stability --out own.md").succeeds().says(&["0 broken promises", "own.md"]);
    let kept = include_str!("../../docs/stability/reflectance.md");
    assert_eq!(
        scratch.text("own.md"),
        kept,
        "make it anew: brdfgen reflectance stability --out docs/stability/reflectance.md"
    );
    let answer = scratch.run("reflectance stability --json").succeeds().json();
    assert_eq!(answer["broken"].as_array().unwrap().len(), 0);
    assert!(answer["extremes"].as_array().unwrap().len() > 100);
}
