//! Model, datapath and real-valued method against each other, over every input where the space allows.

use std::sync::atomic::{AtomicU64, Ordering};

use brdfgen::datapath::evaluate::Evaluator;
use brdfgen::datapath::simulate::{Inputs, Simulation};
use brdfgen::design::{Design, Measured};
use brdfgen::golden::all_codes;
use brdfgen::number::exp2;
use brdfgen::spec::SpecFields;
use proptest::prelude::*;
use rayon::prelude::*;

fn design(spec: &str) -> Design {
    Design::new(SpecFields::parse(spec, "test").and_then(SpecFields::resolve).expect(spec)).expect(spec)
}

fn assert_proof(design: &Design, spec: &str) {
    let [low, high] = design.budget.proved_ulps;
    assert!(-1.0 < low && high < 1.0, "{spec}: proved {low}..{high}");
}

/// The real-valued method at a port code, in output ulps: saturated inputs included.
fn method_ulps(design: &Design, lobe: &dyn brdfgen::lobe::Lobe, operand: i64) -> f64 {
    lobe.at(design.versine(operand)) * exp2(design.spec.output_fraction as i32)
}

/// Every code of the operand port for every row: the evaluator is within the proved bound of the method, and, at every
/// `stride`th code, equal to the model.
fn assert_every_input(spec: &str, stride: i64) {
    let design = design(spec);
    assert_proof(&design, spec);
    let [low, high] = design.budget.proved_ulps;
    let (first, count) = all_codes(design.operand_format());
    let (evaluator, model, lobes) = (design.evaluator(), design.model(), design.lobes());
    let one = 1u32 << design.spec.output_fraction;
    let compared = AtomicU64::new(0);
    (0..design.spec.shininess.rows()).into_par_iter().for_each(|row| {
        let index = design.spec.shininess.index_of_row(row);
        let mut outputs = vec![0u32; count as usize];
        evaluator.evaluate(index, first, 1, &mut outputs);
        let mut own = 0;
        for (offset, &output) in outputs.iter().enumerate() {
            let operand = first + offset as i64;
            let error = f64::from(output) - method_ulps(&design, lobes[row].as_ref(), operand);
            // The method itself is computed in double precision here.
            assert!(
                low - 1e-6 <= error && error <= high + 1e-6 && output <= one,
                "{spec}: row {row}, operand {operand}: {output}, error {error} outside {low}..{high}"
            );
            if (operand + row as i64) % stride == 0 {
                assert_eq!(model.evaluate(index, operand), output, "{spec}: row {row}, operand {operand}");
                own += 1;
            }
        }
        compared.fetch_add(own, Ordering::Relaxed);
    });
    let expected = design.spec.shininess.rows() as u64 * count / stride.unsigned_abs();
    assert!(compared.into_inner() >= expected / 2, "{spec}: too few compared with the model");
}

const METHODS: [&str; 4] = [
    "method = 'quadratic'\nform = 'stable'",
    "method = 'quadratic'\nform = 'paper'",
    "method = 'cubic'\nform = 'stable'",
    "method = 'cubic'\nform = 'paper'",
];

#[test]
fn quadratic_is_faithful_for_every_input_at_16_bits() {
    assert_every_input(&format!("{}\nshininess = '1..=1000'", METHODS[0]), 1);
}

#[test]
fn quadratic_paper_is_faithful_for_every_input_at_16_bits() {
    assert_every_input(&format!("{}\nshininess = '1..=1000'", METHODS[1]), 1);
}

#[test]
fn cubic_is_faithful_for_every_input_at_16_bits() {
    assert_every_input(&format!("{}\nshininess = '1..=1000'", METHODS[2]), 1);
}

#[test]
fn cubic_paper_is_faithful_for_every_input_at_16_bits() {
    assert_every_input(&format!("{}\nshininess = '1..=1000'", METHODS[3]), 1);
}

#[test]
fn every_input_equals_the_model_at_9_bits() {
    for method in METHODS {
        for (f, g) in [(9, 9), (9, 12), (9, 6)] {
            assert_every_input(
                &format!("{method}\nshininess = '1..=300'\ninput_fraction = {f}\noutput_fraction = {g}"),
                1,
            );
        }
    }
}

#[test]
fn versine_operand_is_faithful_for_every_input() {
    for method in METHODS {
        let spec =
            format!("{method}\nshininess = '1..=200'\noperand = 'versine'\ninput_fraction = 12\noutput_fraction = 10");
        assert_every_input(&spec, 1);
    }
}

/// Where the forms degenerate: real n just above 1, about 2 and 3, and levels from end to end.
#[test]
fn real_shininesses_near_the_degenerate_ones_are_faithful() {
    for q in [0.05, 0.2, 0.2847, 0.5, 0.75, 0.95] {
        for method in &METHODS[2..] {
            let set = "[1, 1.0001, 1.05, 1.2, 1.5, 1.8, 1.999, 2, 2.001, 2.3, 2.6, 2.9, 2.9999, 3, 3.0001, 4.5]";
            assert_every_input(
                &format!("{method}\nshininess = {set}\nq = {q}\ninput_fraction = 11\noutput_fraction = 11"),
                1,
            );
        }
    }
}

#[test]
fn single_rows_are_faithful() {
    for method in METHODS {
        for n in ["1", "1.3", "2", "3", "50", "1000", "4096.5"] {
            assert_every_input(&format!("{method}\nshininess = [{n}]\ninput_fraction = 13\noutput_fraction = 12"), 1);
        }
    }
}

/// Where a coefficient rounds up to a power of two at some widths only, is a last bit below zero, or vanishes.
#[test]
fn awkward_coefficients_are_faithful() {
    for (method, n, q, f, g) in [
        (2, "33.5", 0.673_150_092_589_176_7, 8, 5),
        (2, "2.999897042275834", 0.5, 6, 12),
        (3, "2.0073503908925137", 0.533_043_022_147_211_1, 12, 4),
        (2, "1.9999", 0.5, 10, 10),
        (2, "1.000125310597362", 0.184_280_618_774_707_08, 10, 7),
        (1, "1.0105001220411538", 0.5, 4, 4),
        (3, "2.0388254932042136", 0.5, 9, 5),
        (2, "3", 0.3, 10, 10),
        (2, "4", 0.062_5, 8, 8),
        (2, "1000000", 0.5, 4, 4),
    ] {
        let spec =
            format!("{}\nshininess = [{n}]\nq = {q}\ninput_fraction = {f}\noutput_fraction = {g}", METHODS[method]);
        assert_every_input(&spec, 1);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    #[test]
    fn any_core_is_faithful(method in 0usize..4, f in 4u32..=11, g in 4u32..=20, n in proptest::collection::vec(1.0f64..300.0, 1..4), q in 0.05f64..0.95, versine: bool) {
        let q = if method < 2 { 0.5 } else { q };
        let operand = if versine { "versine" } else { "cos" };
        assert_every_input(&format!("{}\nshininess = {n:?}\nq = {q}\noperand = '{operand}'\ninput_fraction = {f}\noutput_fraction = {g}", METHODS[method]), 1);
    }

    /// At widths whose inputs cannot all be tried, the model and the graph agree on random ones.
    #[test]
    fn wide_cores_equal_the_model(method in 0usize..4, f in 12u32..=24, g in 12u32..=20, first in 1u32..2000, codes in proptest::collection::vec(any::<u64>(), 64)) {
        let spec = format!("{}\nshininess = '{first}..={}'\ninput_fraction = {f}\noutput_fraction = {g}", METHODS[method], first + 7);
        let design = design(&spec);
        assert_proof(&design, &spec);
        let (least, count) = all_codes(design.operand_format());
        let highlight = (4.0 / f64::from(first) * exp2(f as i32)) as u64 + 1;
        for code in codes {
            let index = first + (code % 8) as u32;
            // Half of them on the highlight, where there is something to differ.
            let operand = if code & 64 == 0 { least + (code >> 8) as i64 % count as i64 } else { (1 << f) - ((code >> 8) % highlight) as i64 };
            let mut output = [0];
            design.evaluator().evaluate(index, operand, 1, &mut output);
            prop_assert_eq!(design.model().evaluate(index, operand), output[0], "{} {} {}", &spec, index, operand);
        }
    }
}

/// Every depth gives the same function, delayed by that many clocks; a disabled clock freezes it, a reset empties it.
#[test]
fn every_pipeline_depth_computes_the_same() {
    for method in METHODS {
        for depth in (1..=32).map(|depth| depth.to_string()).chain(["'auto'".to_owned()]) {
            let design = design(&format!(
                "{method}\nshininess = [3, 7.5, 40]\npipeline = {depth}\ninput_fraction = 8\noutput_fraction = 8"
            ));
            let latency = design.schedule.latency as usize;
            if let Ok(depth) = depth.parse::<usize>() {
                assert_eq!(latency, depth);
            }
            let mut simulation = Simulation::new(design.graph(), &design.schedule, design.tables());
            let stimuli: Vec<(u32, i64)> = (0..60).map(|i| (i % 4, i64::from(i) * 17 % 300 - 20)).collect();
            let mut outputs = Vec::new();
            let mut enabled = 0;
            for step in 0.. {
                let ce = step % 5 != 3;
                let (index, operand) = stimuli.get(enabled).copied().unwrap_or((0, 0));
                let inputs = Inputs {
                    rst: false,
                    ce,
                    in_valid: ce && enabled < stimuli.len(),
                    codes: vec![index.into(), operand.into()],
                };
                let out = simulation.clock(&inputs);
                enabled += usize::from(ce);
                if ce && out.out_valid {
                    assert_eq!(enabled, outputs.len() + latency, "{method} depth {depth}");
                    outputs.push(out.codes[0] as u32);
                }
                if outputs.len() == stimuli.len() {
                    break;
                }
                assert!(step < 1000, "{method} depth {depth}: results are missing");
            }
            let expected: Vec<u32> = stimuli.iter().map(|&(n, x)| design.model().evaluate(n, x)).collect();
            assert_eq!(outputs, expected, "{method} depth {depth}");
            for ce in [true, false] {
                simulation.clock(&Inputs { ce: true, in_valid: true, ..Inputs::default() });
                simulation.clock(&Inputs { rst: true, ce, ..Inputs::default() });
                for _ in 0..=latency {
                    assert!(!simulation.clock(&Inputs { ce: true, ..Inputs::default() }).out_valid);
                }
            }
        }
    }
}

#[test]
fn the_measurement_is_exhaustive_and_within_the_proof() {
    let design = design("method = 'cubic'\nshininess = '1..=1000'");
    let measured = Measured::of(&design);
    assert!(measured.sweep.exhaustive && measured.sweep.inputs == 65_537_000);
    let [low, high] = design.budget.proved_ulps;
    assert!(low <= measured.ulps[0] && measured.ulps[1] <= high);
    // The papers' cubic: 0.551 % absolute and 0.689 % to 0.70 % relative on the epicentre; the ulp adds 0.002 %.
    assert!((measured.max_abs_epicentre - 0.005_51).abs() < 5e-5, "{}", measured.max_abs_epicentre);
    assert!((measured.max_rel_epicentre - 0.007_0).abs() < 1e-4, "{}", measured.max_rel_epicentre);
}

/// At x = 1 the lobe is 1 and at x = 0 it is 0, exactly, whatever the widths.
#[test]
fn ends_are_exact() {
    for method in METHODS {
        let design = design(&format!("{method}\nshininess = '1..=1000'\noutput_fraction = 11"));
        for n in 1..=1000 {
            assert_eq!(design.model().evaluate(n, 1 << 16), 1 << 11, "{method} n = {n}");
            assert_eq!(design.model().evaluate(n, 0), 0, "{method} n = {n}");
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

/// A ROM word with any one bit flipped changes the answer to some golden vector, unless it changes the answer to no input at all.
#[test]
fn golden_vectors_notice_every_flipped_rom_bit() {
    for method in METHODS {
        let design = design(&format!("{method}\nshininess = '1..=60'\ninput_fraction = 10\noutput_fraction = 10"));
        let golden = brdfgen::golden::Golden::of(&design);
        let vectors: Vec<(u32, i64)> = golden.vectors().iter().map(|v| (v.inputs[0] as u32, v.inputs[1])).collect();
        let flips: Vec<(usize, usize, u32)> = design
            .tables()
            .iter()
            .enumerate()
            .flat_map(|(memory, table)| table.fields.iter().enumerate().map(move |(field, f)| (memory, field, f)))
            .flat_map(|(memory, field, f)| (0..f.format.width()).map(move |bit| (memory, field, bit)))
            .collect();
        let missed: usize = flips
            .par_iter()
            .map(|&(memory, field, bit)| {
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
                    let mut outputs = vec![0; 1025];
                    evaluator.evaluate(index, 0, 1, &mut outputs);
                    outputs
                };
                let noticed = |row: usize| {
                    vectors.iter().any(|&(index, operand)| {
                        design.spec.shininess.row_of_index(index) == row
                            && at(&right, index, operand) != at(&wrong, index, operand)
                    })
                };
                let harmless = |row: usize| {
                    let index = design.spec.shininess.index_of_row(row);
                    all(&right, index) == all(&wrong, index)
                };
                (0..60).filter(|&row| !noticed(row) && !harmless(row)).count()
            })
            .sum();
        let words = 60 * flips.len();
        assert!(missed == 0, "{method}: {missed} of {words} flipped bits go unnoticed");
    }
}
