//! Model, datapath and real-valued method against each other, over every input where the space allows.

use std::fmt;
use std::sync::atomic::{AtomicU64, Ordering};

use brdfgen::core::{Design, Measured};
use brdfgen::datapath::evaluate::Evaluator;
use brdfgen::datapath::graph::{Node, Op};
use brdfgen::datapath::schedule::{Adders, External, schedule};
use brdfgen::datapath::simulate::{Inputs, Simulation};
use brdfgen::fixed::{Table, exp2};
use brdfgen::method::{About, Use, variants};
use brdfgen::spec::{Pipeline, SpecFields};
use brdfgen::verify::golden::all_codes;
use proptest::prelude::*;
use rayon::prelude::*;

use crate::common;
use crate::common::core::{assert_every_input, design};

fn assert_proof(design: &Design, spec: &str) {
    let [low, high] = design.lobe().budget.proved_ulps;
    assert!(-1.0 < low && high < 1.0, "{spec}: proved {low}..{high}");
}

/// The real-valued method at a port code, in output ulps: saturated inputs included.
fn method_ulps(design: &Design, lobe: &dyn brdfgen::lobe::Lobe, operand: i64) -> f64 {
    lobe.at(design.lobe().versine(operand)) * exp2(design.lobe().interface.output_fraction as i32)
}

/// A variant of a method, as the lines of a spec.
#[derive(Clone, Debug)]
struct Kind {
    about: &'static About,
    spec: String,
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.spec)
    }
}

impl Kind {
    /// Whether a level q can be given: the paper's coefficients have one, fitted ones do not.
    fn has_level(&self) -> bool {
        self.about.has("q") && !self.spec.contains("minimax")
    }

    /// Whether a range can have shininesses between its integers.
    fn interpolates(&self) -> bool {
        (self.about.interpolates || self.about.computes_with_shininess) && !self.spec.contains("paper")
    }
}

fn kinds_of(of: Use) -> Vec<Kind> {
    variants(of).map(|(about, variant)| Kind { about, spec: variant.spec(about) }).collect()
}

/// Those whose model, datapath and method are compared here; the others have tests of their own.
fn kinds() -> Vec<Kind> {
    kinds_of(Use::Exactness)
}

/// Those that take shininesses between the integers of a range.
fn interpolating() -> impl Iterator<Item = Kind> {
    kinds().into_iter().filter(Kind::interpolates)
}

/// Every input at F = G = 16 for the shininesses 1 to 1000, compared with the model at all of them.
#[test]
fn the_papers_methods_are_faithful_at_16_bits() {
    for lines in ["quadratic'", "quadratic'\nform = 'paper'", "cubic'", "cubic'\nform = 'paper'"] {
        assert_every_input(&format!("method = '{lines}\nshininess = '1..=1000'"), 1, 1);
    }
}

/// Every input at F = G = 16, compared with the model at every 31st: for some shininesses from 1 to 1000, from end to
/// end, and for all of them with `./test.sh --all`.
#[test]
fn every_method_is_faithful_at_16_bits() {
    let some = [1, 2, 3, 4, 5, 7].into_iter().chain((8..=1000).step_by(31)).chain([1000]);
    let some = some.map(|n: u32| n.to_string()).collect::<Vec<_>>().join(", ");
    let set = if common::all() { "'1..=1000'".to_owned() } else { format!("[{some}]") };
    for kind in kinds() {
        assert_every_input(&format!("{kind}\nshininess = {set}"), 1, 31);
    }
}

#[test]
fn every_input_equals_the_model_at_9_bits() {
    for kind in kinds() {
        for (f, g) in [(9, 9), (9, 12), (9, 6)] {
            assert_every_input(
                &format!("{kind}\nshininess = '1..=300'\ninput_fraction = {f}\noutput_fraction = {g}"),
                1,
                1,
            );
        }
    }
}

#[test]
fn a_core_for_the_codes_from_0_to_1_needs_no_limits_and_agrees_with_one_for_any() {
    // Squaring takes other shininesses; a core with an accuracy is not faithful.
    let suits = |kind: &Kind| !kind.about.powers_of_two && !kind.spec.contains("accuracy");
    for kind in kinds_of(Use::Smallest).into_iter().filter(suits) {
        for operand in ["cos", "versine"] {
            let spec = |range: &str| {
                format!(
                    "{kind}\nshininess = [1, 2, 7.5, 30, 300]\noperand = '{operand}'\ninput_range = \
                     '{range}'\ninput_fraction = 10\noutput_fraction = 10"
                )
            };
            assert_every_input(&spec("unit"), 1, 1);
            let [any, unit] = ["any", "unit"].map(|range| design(&spec(range)));
            let limits = |design: &Design| {
                let of_port = |node: &&Node| node.args.first() == Some(&design.graph().operand());
                let limit = |node: &Node| matches!(node.op, Op::Clamp { .. });
                design.graph().nodes.iter().filter(of_port).any(limit)
            };
            assert!(limits(&any) && !limits(&unit), "{kind}");
            assert_eq!(unit.lobe().operand_format().width(), 11, "{kind}: no sign");
            for row in 0..5 {
                for operand in 0..=1024i64 {
                    let (any, unit) =
                        (any.lobe().model().evaluate(row, operand), unit.lobe().model().evaluate(row, operand));
                    assert_eq!(any, unit, "{kind}: row {row}, operand {operand}");
                }
            }
        }
    }
}

#[test]
fn versine_operand_is_faithful_for_every_input() {
    for kind in kinds() {
        let spec =
            format!("{kind}\nshininess = '1..=200'\noperand = 'versine'\ninput_fraction = 12\noutput_fraction = 10");
        assert_every_input(&spec, 1, 3);
    }
}

/// Where the forms degenerate: real n just above 1, about 2 and 3 and about each power k, and levels from end to end.
#[test]
fn real_shininesses_near_the_degenerate_ones_are_faithful() {
    let set = "[1, 1.0001, 1.05, 1.2, 1.5, 1.8, 1.999, 2, 2.001, 2.3, 2.6, 2.9, 2.9999, 3, 3.0001, 3.9999, 4, 4.0001, \
               4.5, 7.9, 8, 8.1, 15.9999, 16, 16.0001]";
    for kind in kinds() {
        for q in [0.06, 0.2, 0.2847, 0.5, 0.75, 0.95] {
            let q = if kind.has_level() {
                format!("q = {q}")
            } else if q == 0.5 {
                String::new()
            } else {
                continue;
            };
            assert_every_input(
                &format!("{kind}\nshininess = {set}\n{q}\ninput_fraction = 11\noutput_fraction = 11"),
                1,
                1,
            );
        }
    }
}

#[test]
fn single_rows_are_faithful() {
    for kind in kinds() {
        for n in ["1", "1.3", "2", "3", "4", "50", "1000", "4096.5"] {
            assert_every_input(&format!("{kind}\nshininess = [{n}]\ninput_fraction = 13\noutput_fraction = 12"), 1, 1);
        }
    }
}

/// Shininesses between the integers: coefficients on the way from row to row, or n itself as a fixed-point number.
#[test]
fn shininesses_between_the_rows_are_faithful() {
    for kind in interpolating() {
        for (set, bits, f, g) in [
            ("1..=40", 1, 10, 12),
            ("1..=20", 3, 11, 9),
            ("1..=5", 6, 9, 9),
            ("120..=131", 3, 12, 10),
            ("7..=7", 2, 8, 8),
        ] {
            let spec = format!(
                "{kind}\nshininess = '{set}'\nshininess_fraction = {bits}\ninput_fraction = {f}\noutput_fraction = {g}"
            );
            assert_every_input(&spec, 1, 3);
        }
    }
}

/// Where a coefficient rounds up to a power of two at some widths only, is a last bit below zero, or vanishes; where a
/// parabola ends at u = 1 only, so that no row has a cut.
#[test]
fn awkward_coefficients_are_faithful() {
    for (kind, n, f, g) in [
        ("method = 'cubic'", "[33.5]\nq = 0.6731500925891767", 8, 5),
        ("method = 'cubic'", "[2.999897042275834]", 6, 12),
        ("method = 'cubic'\nform = 'paper'", "[2.0073503908925137]\nq = 0.5330430221472111", 12, 4),
        ("method = 'cubic'", "[1.9999]", 10, 10),
        ("method = 'cubic'", "[1.000125310597362]\nq = 0.18428061877470708", 10, 7),
        ("method = 'quadratic'\nform = 'paper'", "[1.0105001220411538]", 4, 4),
        ("method = 'cubic'\nform = 'paper'", "[2.0388254932042136]", 9, 5),
        ("method = 'cubic'", "[3]\nq = 0.3", 10, 10),
        ("method = 'cubic'", "[4]\nq = 0.0625", 8, 8),
        ("method = 'cubic'", "[1000000]", 4, 4),
        ("method = 'power-2'", "[4]", 10, 15),
        ("method = 'power-4'\nobjective = 'weighted:0.5'", "[8, 2.44]", 10, 13),
        ("method = 'power-8'", "[16, 2.63, 3.59]", 8, 15),
        ("method = 'power-2'", "'4..=4'\nshininess_fraction = 3", 5, 9),
        ("method = 'cubic'\ntail = 'hold'", "[1.0000009541307748]", 11, 9),
        (
            "method = 'cubic'\ncoefficients = 'minimax'\ntail = 'hold'",
            "[3.6172235051760584, 1.9915932567856647]",
            5,
            15,
        ),
        (
            "method = 'cubic-three-point'\ntail = 'hold'",
            "[1.000503219291507]\nq = 0.8982357175768237\ng = 0.2294135663548795",
            11,
            5,
        ),
    ] {
        let spec = format!("{kind}\nshininess = {n}\ninput_fraction = {f}\noutput_fraction = {g}");
        assert_every_input(&spec, 1, 1);
    }
}

/// What no output needs is not in the graph, and every field of a ROM is read.
#[test]
fn nothing_of_a_core_is_idle() {
    let unread = |design: &Design| {
        let nodes = &design.graph().nodes;
        let idle = |id: usize| {
            !design.graph().is_output(id)
                && !design.graph().inputs.contains(&id)
                && nodes.iter().all(|node| !node.args.contains(&id))
        };
        let fields = design.tables().iter().enumerate().flat_map(|(memory, table)| {
            table.fields.iter().enumerate().map(move |(field, of)| (Op::Field { memory, field }, of.name))
        });
        let unread = fields.filter(|(op, _)| nodes.iter().all(|node| node.op != *op)).map(|(_, name)| name.to_owned());
        unread.chain((0..nodes.len()).filter(|&id| idle(id)).map(|id| nodes[id].name.clone())).collect::<Vec<_>>()
    };
    for kind in kinds() {
        for set in ["'1..=40'", "[1]", "[1.5, 2.5]", "[3]", "[4.5]", "[60]"] {
            for operand in ["cos", "versine"] {
                let spec = format!(
                    "{kind}\nshininess = {set}\noperand = '{operand}'\ninput_fraction = 9\noutput_fraction = 8"
                );
                assert_eq!(unread(&design(&spec)), Vec::<String>::new(), "{spec}");
            }
        }
    }
}

/// Text of a random core: a method, and a set of one of the kinds that it takes.
fn any_core() -> impl Strategy<Value = String> {
    let shininess = prop_oneof![
        1.0f64..300.0,
        // Close above and below where forms degenerate, by up to 2^-20.
        (prop::sample::select(vec![1.0, 2.0, 3.0, 4.0, 8.0, 16.0]), 0.0f64..20.0, any::<bool>()).prop_map(
            |(n, power, above): (f64, f64, bool)| {
                (if above { n + libm::exp2(-power) } else { n - libm::exp2(-power) }).max(1.0)
            }
        ),
        (0.0f64..20.0).prop_map(libm::exp2),
    ];
    let list = prop::collection::vec(shininess, 1..4).prop_map(|list| (format!("{list:?}"), None));
    let range = (1u32..200, 0u32..12, 0u32..=6)
        .prop_map(|(first, more, bits)| (format!("'{first}..={}'", first + more), (bits > 0).then_some(bits)));
    (prop::sample::select(kinds()), prop_oneof![list, range], 0.06f64..0.95, any::<bool>()).prop_map(
        |(kind, (set, bits), q, versine)| {
            let operand = if versine { "versine" } else { "cos" };
            let mut spec = format!("{kind}\nshininess = {set}\noperand = '{operand}'");
            if kind.has_level() {
                spec += &format!("\nq = {q}");
            }
            if let Some(bits) = bits.filter(|_| kind.interpolates()) {
                spec += &format!("\nshininess_fraction = {bits}");
            }
            spec
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 256, ..ProptestConfig::default() })]

    #[test]
    fn any_core_is_faithful(core in any_core(), f in 4u32..=11, g in 4u32..=20) {
        assert_every_input(&format!("{core}\ninput_fraction = {f}\noutput_fraction = {g}"), 1, 1);
    }

    /// At widths whose inputs cannot all be tried, the model and the graph agree on random ones.
    #[test]
    fn wide_cores_equal_the_model(
        kind in prop::sample::select(kinds()),
        f in 12u32..=24,
        g in 12u32..=20,
        first in 1u32..2000,
        codes in proptest::collection::vec(any::<u64>(), 64),
    ) {
        let spec = format!("{kind}\nshininess = '{first}..={}'\ninput_fraction = {f}\noutput_fraction = \
         {g}", first + 7);
        let design = design(&spec);
        assert_proof(&design, &spec);
        let (least, count) = all_codes(design.lobe().operand_format());
        let highlight = (4.0 / f64::from(first) * exp2(f as i32)) as u64 + 1;
        let [low, high] = design.lobe().budget.proved_ulps;
        let lobes = design.lobe().lobes;
        for code in codes {
            let index = first + (code % 8) as u32;
            // Half of them on the highlight, where there is something to differ.
            let near_top = (1 << f) - ((code >> 8) % highlight) as i64;
            let operand = if code & 64 == 0 { least + (code >> 8) as i64 % count as i64 } else { near_top };
            let mut output = [0];
            design.evaluator().evaluate(index, operand, 1, &mut output);
            let expected = design.lobe().model().evaluate(index, operand);
            prop_assert_eq!(expected, output[0], "{} {} {}", &spec, index, operand);
            let error = f64::from(output[0]) - method_ulps(&design, lobes[(code % 8) as usize].as_ref(), operand);
            prop_assert!(low - 1e-6 <= error && error <= high + 1e-6, "{}: {} {}: {}", &spec, index, operand, error);
        }
    }
}

/// Every depth gives the same function, delayed by that many clocks; a disabled clock freezes it, a reset empties it.
#[test]
fn every_pipeline_depth_computes_the_same() {
    let list = "shininess = [3, 7.5, 40]";
    let between = "shininess = '3..=12'\nshininess_fraction = 2";
    let lists = kinds().into_iter().map(|kind| (kind, list));
    let ranges = interpolating().map(|kind| (kind, between));
    for (kind, set) in lists.chain(ranges) {
        let design = design(&format!("{kind}\n{set}\ninput_fraction = 8\noutput_fraction = 8"));
        let depths = (1..=32).map(Pipeline::Depth).chain([Pipeline::Auto]);
        depths.for_each(|depth| assert_pipeline(&design, depth, &format!("{kind} {set} {depth}")));
    }
}

fn assert_pipeline(design: &Design, depth: Pipeline, what: &str) {
    let schedule = schedule(design.graph(), depth, Adders::Two, &External::default()).expect(what);
    let latency = schedule.latency as usize;
    if let Pipeline::Depth(depth) = depth {
        assert_eq!(latency, depth as usize);
    }
    let indices = 1 << design.lobe().index_format().width();
    let mut simulation = Simulation::new(design.graph(), &schedule, design.tables());
    let stimuli: Vec<(u32, i64)> = (0..60).map(|i| (i * 5 % indices, i64::from(i) * 17 % 300 - 20)).collect();
    let mut outputs = Vec::new();
    let mut enabled = 0;
    for step in 0.. {
        let ce = step % 5 != 3;
        let (index, operand) = stimuli.get(enabled).copied().unwrap_or((0, 0));
        let in_valid = ce && enabled < stimuli.len();
        let inputs = Inputs { rst: false, ce, in_valid, codes: vec![index.into(), operand.into()] };
        let out = simulation.clock(&inputs);
        enabled += usize::from(ce);
        if ce && out.out_valid {
            assert_eq!(enabled, outputs.len() + latency, "{what}");
            outputs.push(out.codes[0] as u32);
        }
        if outputs.len() == stimuli.len() {
            break;
        }
        assert!(step < 1000, "{what}: results are missing");
    }
    let expected: Vec<u32> = stimuli.iter().map(|&(n, x)| design.lobe().model().evaluate(n, x)).collect();
    assert_eq!(outputs, expected, "{what}");
    for ce in [true, false] {
        simulation.clock(&Inputs { ce: true, in_valid: true, ..Inputs::default() });
        simulation.clock(&Inputs { rst: true, ce, ..Inputs::default() });
        for _ in 0..=latency {
            assert!(!simulation.clock(&Inputs { ce: true, ..Inputs::default() }).out_valid);
        }
    }
}

#[test]
fn the_measurement_is_exhaustive_and_within_the_proof() {
    let design = design("method = 'cubic'\nshininess = '1..=1000'");
    let measured = Measured::of(design.lobe());
    assert!(measured.sweep.exhaustive && measured.sweep.inputs == 65_537_000);
    let [low, high] = design.lobe().budget.proved_ulps;
    assert!(low <= measured.ulps[0] && measured.ulps[1] <= high);
    // The papers' cubic: 0.551 % absolute and 0.689 % to 0.70 % relative on the epicentre; the ulp adds 0.002 %.
    assert!((measured.max_abs_epicentre - 0.005_51).abs() < 5e-5, "{}", measured.max_abs_epicentre);
    assert!((measured.max_rel_epicentre - 0.007_0).abs() < 1e-4, "{}", measured.max_rel_epicentre);
}

/// At x = 0 the lobe is 0 and at x = 1 it is 1, exactly, whatever the widths; but for segments, whose fit leaves the
/// top within the error that it has everywhere.
#[test]
fn ends_are_exact() {
    for kind in kinds() {
        let design = design(&format!("{kind}\nshininess = '1..=1000'\noutput_fraction = 11"));
        for n in 1..=1000 {
            let top = design.lobe().model().evaluate(n, 1 << 16);
            let error = if kind.spec.contains("segmented-2") { 24 } else { 9 };
            let exact = top == 1 << 11;
            assert!(exact || kind.spec.contains("segmented") && (1 << 11) - top <= error, "{kind} n = {n}: {top}");
            assert_eq!(design.lobe().model().evaluate(n, 0), 0, "{kind} n = {n}");
        }
    }
}

#[test]
fn a_form_that_needs_too_many_bits_says_so() {
    let spec = "method = 'cubic'\nform = 'paper'\nshininess = [1000000]\ninput_fraction = 24\noutput_fraction = 20";
    let spec = SpecFields::parse(spec, "test").and_then(SpecFields::resolve).unwrap();
    let message = Design::new(spec).expect_err("wider than 126 bits").to_string();
    assert!(message.contains("126 bits"), "{message}");
}

/// A ROM word with any one bit flipped changes the answer to some golden vector, unless it changes the answer to no
/// input at all.
#[test]
fn golden_vectors_notice_every_flipped_rom_bit() {
    for kind in kinds() {
        assert_flips_are_noticed(&format!("{kind}\nshininess = '1..=60'\ninput_fraction = 10\noutput_fraction = 10"));
    }
    for kind in interpolating() {
        assert_flips_are_noticed(&format!(
            "{kind}\nshininess = '1..=30'\nshininess_fraction = 3\ninput_fraction = 9\noutput_fraction = 10"
        ));
    }
    // More shininesses than can have vectors of their own, but not more rows of the ROM.
    assert_flips_are_noticed(
        "method = 'quadratic'\nshininess = '1..=600'\nshininess_fraction = 1\ninput_fraction = 8\noutput_fraction = 8",
    );
}

fn assert_flips_are_noticed(spec: &str) {
    let design = design(spec);
    let set = &design.lobe().interface.shininess;
    let codes = (1usize << design.lobe().interface.input_fraction) + 1;
    let golden = brdfgen::verify::golden::Golden::of(&design);
    let vectors: Vec<(u32, i64)> = golden.vectors().iter().map(|v| (v.inputs[0] as u32, v.inputs[1])).collect();
    // The vectors and the places of the set that read each row of the ROM.
    let rows = set.of_knots().rows();
    let mut vectors_of = vec![Vec::new(); rows];
    for (index, operand) in vectors {
        vectors_of[set.knot(set.row_of_index(index)).0].push((index, operand));
    }
    let mut places_of = vec![Vec::new(); rows];
    (0..set.rows()).for_each(|place| places_of[set.knot(place).0].push(place));
    let flips: Vec<(usize, usize, u32)> = design
        .tables()
        .iter()
        .enumerate()
        // Tables of functions have no row a shininess: `mutate` flips their bits.
        .filter(|(_, table)| table.name == Table::COEFFICIENTS)
        .flat_map(|(memory, table)| table.fields.iter().enumerate().map(move |(field, f)| (memory, field, f)))
        .flat_map(|(memory, field, f)| (0..f.format.width()).map(move |bit| (memory, field, bit)))
        .collect();
    let missed: Vec<(&str, u32, usize)> = flips
        .par_iter()
        .flat_map_iter(|&(memory, field, bit)| {
            let mut flipped = design.tables().to_vec();
            let format = flipped[memory].fields[field].format;
            for code in &mut flipped[memory].fields[field].codes {
                *code = format.wrap(*code ^ (1 << bit));
            }
            let (right, wrong) = (design.evaluator(), Evaluator::new(design.graph(), &flipped));
            let at = |evaluator: &Evaluator, index: u32, operand: i64| {
                let mut output = [0];
                evaluator.evaluate(index, operand, 1, &mut output);
                output[0]
            };
            let all = |evaluator: &Evaluator, index: u32| {
                let mut outputs = vec![0; codes];
                evaluator.evaluate(index, 0, 1, &mut outputs);
                outputs
            };
            let noticed = |row: usize| {
                vectors_of[row].iter().any(|&(index, operand)| at(&right, index, operand) != at(&wrong, index, operand))
            };
            let harmless = |row: usize| {
                places_of[row].iter().all(|&place| {
                    let index = set.index_of_row(place);
                    all(&right, index) == all(&wrong, index)
                })
            };
            let name = design.tables()[memory].fields[field].name;
            let missed: Vec<usize> = (0..rows).filter(|&row| !noticed(row) && !harmless(row)).collect();
            missed.into_iter().map(move |row| (name, bit, row))
        })
        .collect();
    let words = rows * flips.len();
    let first: Vec<_> = missed.iter().take(10).collect();
    assert!(missed.is_empty(), "{spec}: {} of {words} flipped bits go unnoticed: {first:?}", missed.len());
}

/// Where the output has few bits, distances, slopes and steps may have none at all: those mean the same in the model,
/// in the datapath and in the evaluator, for every code at both ports.
#[test]
fn the_smallest_cores_are_the_same_everywhere() {
    let sets = ["'1..=5'", "[1]", "[2, 1048576]", "'255..=256'", "[1.5, 3.25, 700]"];
    let mut specs = Vec::new();
    for kind in kinds_of(Use::Smallest) {
        let sets: &[&str] = if kind.about.powers_of_two { &["[1, 2, 4, 1024]", "[1]"] } else { &sets };
        for (place, set) in sets.iter().enumerate() {
            for f in if kind.spec.contains("accuracy") { 8..=10 } else { 4..=10 } {
                for g in 4..=6 {
                    // Two or three sets for each pair of widths.
                    if (place + f + g) % 2 == 1 {
                        continue;
                    }
                    let operand = ["cos", "versine"][(place + f) % 2];
                    let range = ["any", "unit"][(place + g) % 2];
                    specs.push(format!(
                        "{kind}\nshininess = {set}\ninput_fraction = {f}\noutput_fraction = {g}\noperand = \
                         '{operand}'\n\
                         input_range = '{range}'"
                    ));
                }
            }
        }
    }
    let made = AtomicU64::new(0);
    specs.par_iter().for_each(|spec| {
        let design = match Design::new(SpecFields::parse(spec, "test").and_then(SpecFields::resolve).expect(spec)) {
            Ok(design) => design,
            // The printed forms need more bits than there are; all others are made.
            Err(_) if spec.contains("'paper'") => return,
            Err(error) => panic!("{spec}: {error}"),
        };
        made.fetch_add(1, Ordering::Relaxed);
        let (first, count) = all_codes(design.lobe().operand_format());
        let (evaluator, model) = (design.evaluator(), design.lobe().model());
        // Of a port of many bits the codes about both ends of the set.
        let last = design.lobe().index_format().max_code() as u32;
        let set = &design.lobe().interface.shininess;
        let mut indices: Vec<u32> = (0..4).chain(last..=last).collect();
        let ends = [set.index_of_row(0), set.index_of_row(set.rows() - 1)];
        indices.extend(ends.iter().flat_map(|&end| end.saturating_sub(1)..=end.saturating_add(1)));
        indices.retain(|&index| index <= last);
        indices.sort_unstable();
        indices.dedup();
        for index in indices {
            let mut outputs = vec![0u32; count as usize];
            evaluator.evaluate(index, first, 1, &mut outputs);
            for (operand, &output) in (first..).zip(&outputs) {
                let model = model.evaluate(index, operand);
                assert_eq!(output, model, "{spec}: in_n {index}, operand {operand}: evaluator and model");
                if operand % 7 == 0 {
                    let values = design.graph().values(design.tables(), &[index.into(), operand.into()]);
                    let graph = values[design.graph().output()];
                    assert_eq!(graph, i128::from(model), "{spec}: in_n {index}, operand {operand}: datapath and model");
                }
            }
        }
    });
    assert!(made.into_inner() > 1500, "few are made");
}
