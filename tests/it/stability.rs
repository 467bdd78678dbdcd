//! Cores where forms degenerate, and the range analysis against injected faults and against every input.

use assert_cmd::Command;
use brdfgen::core::sample::{Sample, random_codes};
use brdfgen::core::{BlockDesign, Design, Direction, ShaderDesign};
use brdfgen::datapath::evaluate::Evaluator;
use brdfgen::datapath::graph::{Graph, Op};
use brdfgen::datapath::range::Analysis;
use brdfgen::fixed::Rng;
use brdfgen::spec::MethodName;
use brdfgen::verify::stability::document::{self, Study};
use brdfgen::verify::stability::inspect::Inspection;
use brdfgen::verify::stability::sampled::{Proof, SampledInspection};
use brdfgen::verify::stability::study::{self, Axis, Extent};
use rayon::prelude::*;

use crate::common::core::design;

/// Cores of every kind of datapath, small enough for all their inputs.
const SPECS: [&str; 12] = [
    "method = 'quadratic'\nshininess = '1..=64'\ninput_fraction = 10\noutput_fraction = 10",
    "method = 'quadratic'\nform = 'paper'\nshininess = '1..=64'\ninput_fraction = 10\noutput_fraction = 10",
    "method = 'cubic'\nshininess = '1..=64'\ninput_fraction = 10\noutput_fraction = 10",
    "method = 'cubic'\nform = 'paper'\nshininess = [1.1, 2.5, 40]\ninput_fraction = 10\noutput_fraction = 10",
    "method = 'cubic'\ntail = 'hold'\nshininess = [1.1, 2.5, 40]\ninput_fraction = 10\noperand = 'versine'",
    "method = 'cubic-rational'\nshininess = '1..=40'\ninput_fraction = 10\noutput_fraction = 10",
    "method = 'schlick'\nshininess = '1..=20'\ninput_fraction = 9\noutput_fraction = 9",
    "method = 'power-4'\nshininess = '1..=64'\ninput_fraction = 10\noutput_fraction = 10",
    "method = 'segmented-4'\nshininess = '1..=32'\ninput_fraction = 10\noutput_fraction = 10",
    "method = 'log-exp'\nshininess = '1..=15'\nshininess_fraction = 1\ninput_fraction = 10\noutput_fraction = 10",
    "method = 'log-exp'\naccuracy = 6\nshininess = '1..=64'\ninput_fraction = 10\ninput_range = 'unit'",
    "method = 'harris'\nlog_bits = 4\nexp_bits = 6\nshininess = '1..=40'\ninput_fraction = 10\noutput_fraction = 10",
];

/// The outputs of a graph for every code of its operand's port, for each row.
fn outputs(design: &Design, graph: &Graph) -> Vec<Vec<u32>> {
    let evaluator = Evaluator::new(graph, design.tables());
    let (first, count) = brdfgen::verify::golden::all_codes(design.lobe().operand_format());
    let run = |row: usize| {
        let mut outputs = vec![0; count as usize];
        evaluator.evaluate(design.lobe().interface.shininess.index_of_row(row), first, 1, &mut outputs);
        outputs
    };
    (0..design.lobe().interface.shininess.rows()).into_par_iter().map(run).collect()
}

fn method(name: &str) -> MethodName {
    MethodName::named(name).expect("a method of the crate")
}

#[test]
fn no_needed_value_overflows_and_the_narrowed_graph_computes_the_same() {
    for spec in SPECS {
        let design = design(spec);
        let found = Inspection::of(design.lobe());
        assert_eq!(found.broken(), Vec::<String>::new(), "{spec}");
        // Once more, with everything that may be narrowed as wide as it can be: nothing but formats changes.
        let mut wide = design.function().clone();
        for id in 0..wide.nodes.len() {
            let fixed =
                wide.is_output(id) || wide.nodes.iter().any(|user| user.args.contains(&id) && needs_its_width(user.op));
            let node = &mut wide.nodes[id];
            // Where the sign of a signed value is taken as a bit, its place must stay.
            if matches!(node.op, Op::Add | Op::Sub | Op::ShiftLeft) && !fixed && !node.format.signed {
                node.format.int_bits += 3;
            }
        }
        let analysis = Analysis::new(&wide, design.tables());
        let ranges = analysis.over(&design.regions(), 1 << 16);
        let (narrowed, _) = analysis.narrowed(&ranges);
        assert!(ranges.is_safe(), "{spec}");
        assert_eq!(outputs(&design, &narrowed), outputs(&design, design.function()), "{spec}");
        let bits = |graph: &Graph| graph.nodes.iter().map(|node| node.format.width()).sum::<u32>();
        assert!(bits(&narrowed) <= bits(design.function()), "{spec}");
    }
}

fn needs_its_width(op: Op) -> bool {
    matches!(op, Op::Field { .. } | Op::Scale | Op::ShiftRight | Op::ZeroIf | Op::Clamp { .. } | Op::Mul)
}

#[test]
fn a_register_with_a_bit_too_few_is_found_by_the_analysis_and_by_the_wide_registers() {
    let mut injected = 0;
    for spec in SPECS {
        let design = design(spec);
        let regions = design.regions();
        let right = outputs(&design, design.function());
        for id in 0..design.function().nodes.len() {
            let mut graph = design.function().clone();
            let node = &mut graph.nodes[id];
            // Addresses stay as they are in the run with wide registers: beyond its end a memory has no words.
            let is_address =
                design.function().nodes.iter().any(|user| matches!(user.op, Op::Field { .. }) && user.args[0] == id);
            if !matches!(node.op, Op::Add | Op::Sub) || node.format.width() < 2 || is_address {
                continue;
            }
            node.format.int_bits -= 1;
            let name = node.name.clone();
            let analysis = Analysis::new(&graph, design.tables());
            let ranges = analysis.over(&regions, 1 << 16);
            let overflows = ranges.overflows.iter().any(|overflow| overflow.node == id);
            let differs = outputs(&design, &graph) != right;
            // A result that differs is an overflow; one that stays may be a bit that only values past the end use.
            assert!(overflows || !differs, "{spec}: {name}");
            if overflows {
                let overflow = ranges.overflows.iter().find(|overflow| overflow.node == id).unwrap();
                assert!(
                    !(graph.nodes[id].format.min_code()..=graph.nodes[id].format.max_code()).contains(&overflow.value)
                );
            }
            if differs {
                let wide = analysis.with_spare_bits(&ranges);
                assert_ne!(outputs(&design, &wide), outputs(&design, &graph), "{spec}: {name}");
                injected += 1;
            }
        }
    }
    assert!(injected >= 20, "only {injected} faults change a result");
}

#[test]
fn values_lie_in_their_ranges() {
    for spec in SPECS {
        let design = design(spec);
        let graph = design.function();
        let analysis = Analysis::new(graph, design.tables());
        let ranges = analysis.over(&design.regions(), 1 << 16);
        let (first, count) = brdfgen::verify::golden::all_codes(design.lobe().operand_format());
        for row in 0..design.lobe().interface.shininess.rows() {
            let index = design.lobe().interface.shininess.index_of_row(row);
            for place in (0..count as i64).step_by(37) {
                let values = graph.values(design.tables(), &[index.into(), (first + place).into()]);
                // The output is always needed.
                let (output, span) = (values[graph.output()], ranges.needed[graph.output()].unwrap());
                assert!(span.contains(output), "{spec}: {output} at {index}, {}", first + place);
            }
        }
        // A span is not wider than its format says.
        for (node, span) in graph.nodes.iter().zip(&ranges.needed) {
            assert!(span.is_none_or(|span| span.fits(node.format)), "{spec}: {}", node.name);
        }
    }
}

#[test]
fn a_writable_core_keeps_its_bits() {
    let text = "method = 'cubic-min-zero'\nshininess = '1..=64'\nrom = 'writable'";
    assert!(design(text).lobe().narrowed.is_empty());
    let fixed = design("method = 'cubic'\nshininess = '1..=64'");
    assert!(fixed.lobe().narrowed.iter().any(|narrowed| narrowed.name == "u_scaled"), "{:?}", fixed.lobe().narrowed);
}

#[test]
fn cores_at_the_extremes_keep_every_promise() {
    for axis in [Axis::Shininess, Axis::Level, Axis::Input, Axis::Output] {
        let cases = study::cases(axis, &study::methods(), Extent::Quick);
        assert!(cases.len() > 15, "{axis:?}");
        // Every other core of the quick study: the command runs all of them.
        for case in cases.iter().step_by(2) {
            let entry = case.inspect();
            match (&entry.found, &entry.refused) {
                (Some(found), _) => assert_eq!(found.broken(), Vec::<String>::new(), "{}", case.spec),
                (None, reason) => panic!("{}: {reason:?}", case.spec),
            }
        }
    }
}

#[test]
fn the_study_says_what_it_finds() {
    let entry = study::cases(Axis::Shininess, &[method("cubic")], Extent::Quick).remove(0).inspect();
    let found = entry.found.unwrap();
    assert_eq!((found.rows, found.at_zero, found.above_one, found.outside_differences), (13, 0, 0, 0));
    let places: Vec<&str> = found.places.iter().map(|place| place.name).collect();
    assert!(places.contains(&"cusp") && places.contains(&"x = 1"), "{places:?}");
    // The printed form's values are some thousand times as large.
    let printed = study::cases(Axis::Shininess, &[method("cubic")], Extent::Quick);
    let printed = printed.iter().find(|case| case.method.contains("printed")).unwrap().inspect();
    if let Some(printed) = printed.found {
        assert!(
            printed.largest.largest > 1e6 && found.largest.largest < 1e5,
            "{:?} {:?}",
            printed.largest,
            found.largest
        );
    }
}

#[test]
fn the_command_inspects_a_core_and_refuses_what_does_not_fit() {
    let run = |arguments: &[&str]| Command::cargo_bin("brdfgen").unwrap().args(arguments).output().unwrap();
    let output = run(&["stability", "--method", "cubic", "--shininess", "1..=40", "--input-fraction", "10", "--json"]);
    assert!(output.status.success(), "{output:?}");
    let value: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(value["core"]["wide_differences"], 0);
    assert_eq!(value["broken"].as_array().unwrap().len(), 0);
    let refused = run(&["stability", "--method", "cubic", "--shininess", "1..=40", "--quick"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("--quick"), "{refused:?}");
    let scratch = tempfile::tempdir().unwrap();
    let out = scratch.path().join("study");
    let arguments = ["stability", "--quick", "--axis", "shininess", "--only", "squaring", "--out"];
    let output = Command::cargo_bin("brdfgen").unwrap().args(arguments).arg(&out).output().unwrap();
    assert!(output.status.success(), "{output:?}");
    let text = std::fs::read_to_string(out.join("stability.md")).unwrap();
    assert!(text.contains("It holds for all of them") && text.contains("| squaring | 2 |"), "{text}");
    assert!(std::fs::read_to_string(out.join("cores.csv")).unwrap().lines().count() == 3);
}

const MATERIALS: &str = "
[[material]]
name = 'matt'
shininess = 3
diffuse = 0.9

[[material]]
name = 'steel'
shininess = 200
diffuse = 0.9
specular = 0.9
";

/// Every way to the highlight's cosine with both sources of the lights' colours, and lobes of several kinds.
const SHADERS: [(&str, &str); 6] = [
    ("method = 'quadratic'", "model = 'blinn'\nfront = 'half'"),
    ("method = 'cubic'", "model = 'blinn'\nfront = 'half'\nlight_colours = 'ports'\nlights = 2"),
    ("method = 'cubic-rational'", "model = 'phong'"),
    ("method = 'segmented-4'", "model = 'phong'\nlight_colours = 'ports'\nchannel_bits = 12"),
    ("method = 'power-4'", "model = 'blinn'\nfront = 'sqrt'\nlights = 2"),
    ("method = 'log-exp'", "model = 'blinn'\nfront = 'sqrt'\nlight_colours = 'ports'"),
];

fn shader_design((core, shader): (&str, &str)) -> Design {
    design(&format!(
        "block = 'shader'\n{core}\ninput_fraction = 10\noutput_fraction = 10\n[shader]\n{shader}\n{MATERIALS}"
    ))
}

fn shader(design: &Design) -> ShaderDesign<'_> {
    match design.block() {
        BlockDesign::Shader(shader) => shader,
        _ => panic!("a shader"),
    }
}

fn prove(design: &Design, graph: &Graph) -> Proof {
    Proof::of(&design.lobe().interface.shininess, shader(design).joints, graph, design.tables())
}

#[test]
fn no_value_of_a_shader_overflows() {
    for text in SHADERS {
        let design = shader_design(text);
        let found = SampledInspection::of(&design);
        assert_eq!(found.broken(), Vec::<String>::new(), "{text:?}");
        let parts = |name: &str| found.parts.iter().filter(|part| part.name.starts_with(name)).count();
        let lights = shader(&design).shader.lights as usize;
        let roots = if text.1.contains("sqrt") { lights } else { 0 };
        assert_eq!([parts("front end"), parts("root"), parts("lobe"), parts("colours")], [lights, roots, lights, 1]);
        // What random inputs make of the outputs lies in the ranges.
        let graph = design.function();
        let proof = prove(&design, graph);
        let ports = design.numbers(Direction::In);
        let mut rng = Rng::new(1);
        for _ in 0..500 {
            let codes: Vec<i128> = random_codes(&ports, &mut rng).into_iter().map(i128::from).collect();
            let values = graph.values(design.tables(), &codes);
            for &(_, id) in &graph.outputs {
                assert!(proof.ranges.needed[id].unwrap().contains(values[id]), "{text:?}");
            }
        }
    }
}

#[test]
fn a_register_of_a_shader_with_a_bit_too_few_is_found() {
    let mut found_in = std::collections::BTreeMap::new();
    for text in SHADERS {
        let design = shader_design(text);
        let shader = shader(&design).shader;
        let mut rng = Rng::new(1);
        let samples: Vec<Vec<i128>> = (0..200)
            .map(|place| {
                let sample = Sample::random(shader, place % 2, 3.0, &mut rng).codes(shader);
                sample.into_iter().map(i128::from).collect()
            })
            .collect();
        let outputs = |graph: &Graph| -> Vec<Vec<i128>> {
            let of = |codes: &Vec<i128>| {
                let values = graph.values(design.tables(), codes);
                graph.outputs.iter().map(|&(_, id)| values[id]).collect()
            };
            samples.iter().map(of).collect()
        };
        let right = outputs(design.function());
        let is_sum = |id: &usize| matches!(design.function().nodes[*id].op, Op::Add | Op::Sub);
        let sums: Vec<usize> = (0..design.function().nodes.len()).filter(is_sum).step_by(2).collect();
        // The colours' sums are sized for lobes of up to 2: of them a second bit is to go.
        for (id, bits) in sums.iter().flat_map(|&id| [(id, 1), (id, 2)]) {
            let mut graph = design.function().clone();
            let is_address = graph.nodes.iter().any(|user| matches!(user.op, Op::Field { .. }) && user.args[0] == id);
            let node = &mut graph.nodes[id];
            if node.format.width() <= bits || is_address {
                continue;
            }
            node.format.int_bits -= bits as i32;
            let name = node.name.clone();
            let proof = prove(&design, &graph);
            let overflow = proof.overflows.iter().find(|(node, _)| *node == id);
            assert!(!proof.is_safe() || outputs(&graph) == right, "{text:?}: {name}");
            if let Some((_, what)) = overflow {
                let part = what.split('"').nth(1).unwrap().split(" of ").next().unwrap().to_owned();
                *found_in.entry(part).or_insert(0) += 1;
            }
        }
    }
    for part in ["front end", "root", "lobe", "colours"] {
        assert!(found_in.get(part).is_some_and(|&count| count >= 2), "{part}: {found_in:?}");
    }
}

#[test]
fn the_committed_study_is_current() {
    let committed = |name: &str| {
        std::fs::read_to_string(std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/stability").join(name))
            .unwrap()
    };
    let [chapter, table] = ["stability.md", "cores.csv"].map(committed);
    for (axis, method, of_table) in [
        (Axis::Shininess, method("lyon-2"), 2),
        (Axis::Shininess, method("quadratic"), 3),
        (Axis::Output, method("squaring"), 3),
    ] {
        let cases = study::cases(axis, &[method], Extent::Whole);
        let is_whole = cases.len() == of_table;
        let entries = cases.iter().take(of_table).map(study::Case::inspect).collect();
        let study = Study { conditioning: Vec::new(), front_ends: Vec::new(), entries };
        let files = document::files(&study).unwrap();
        let text =
            |name: &str| String::from_utf8(files.iter().find(|file| file.path == name).unwrap().bytes.clone()).unwrap();
        assert_eq!(text("cores.csv").lines().count(), of_table + 1);
        for line in text("cores.csv").lines() {
            assert!(table.lines().any(|known| known == line), "not in docs/stability/cores.csv: {line}");
        }
        // The lines of methods in the tables of cores have twelve columns.
        for line in text("stability.md").lines().filter(|line| is_whole && line.matches('|').count() == 13) {
            assert!(chapter.lines().any(|known| known == line), "not in docs/stability/stability.md: {line}");
        }
    }
}
