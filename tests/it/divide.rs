//! The methods that divide: model, datapath and real-valued method against each other.

use brdfgen::datapath::simulate::{Inputs, Simulation};
use brdfgen::fixed::exp2;
use brdfgen::verify::golden::all_codes;
use proptest::prelude::*;

use crate::common::core::{assert_every_input, design};

const METHODS: [&str; 2] = ["schlick", "cubic-rational"];
const DIVIDERS: [&str; 2] = ["digit", "reciprocal"];

fn cores() -> impl Iterator<Item = String> {
    METHODS.iter().flat_map(|method| DIVIDERS.map(|divider| format!("method = '{method}'\ndivider = '{divider}'")))
}

#[test]
fn every_input_equals_the_model_at_9_and_10_bits() {
    for core in cores() {
        for (f, g) in [(9, 9), (10, 10), (10, 5), (6, 12)] {
            assert_every_input(
                &format!("{core}\nshininess = '1..=300'\ninput_fraction = {f}\noutput_fraction = {g}"),
                1,
                1,
            );
        }
    }
}

#[test]
fn every_shininess_is_faithful_at_16_bits() {
    for (method, divider) in METHODS.iter().zip(DIVIDERS) {
        assert_every_input(&format!("method = '{method}'\ndivider = '{divider}'\nshininess = '1..=1000'"), 1, 16);
    }
}

#[test]
fn fitted_tails_are_faithful_for_every_input() {
    for divider in DIVIDERS {
        for objective in ["max-abs", "max-rel:0.2", "weighted:-0.5"] {
            assert_every_input(
                &format!(
                    "method = 'cubic-rational'\ndivider = '{divider}'\ncoefficients = 'minimax'\nobjective = \
                     '{objective}'\n\
                     shininess = '1..=120'\ninput_fraction = 10\noutput_fraction = 10"
                ),
                1,
                1,
            );
        }
    }
}

#[test]
fn versine_operand_is_faithful_for_every_input() {
    for core in cores() {
        assert_every_input(
            &format!("{core}\nshininess = '1..=200'\noperand = 'versine'\ninput_fraction = 12\noutput_fraction = 10"),
            1,
            1,
        );
    }
}

/// Real shininesses from a ROM, from just above 1 to the largest, together and alone.
#[test]
fn real_shininesses_are_faithful() {
    let single = ["1", "1.0001", "1.5", "2.5", "3", "33.3", "1000", "1000.3", "65536", "1048576"];
    for core in cores() {
        for set in
            [single.join(","), "1.0001,1.5,2.0001,2.9999,4.5,40.7".to_owned()].iter().map(String::as_str).chain(single)
        {
            for (f, g) in [(11, 11), (13, 8), (8, 13)] {
                assert_every_input(
                    &format!("{core}\nshininess = [{set}]\ninput_fraction = {f}\noutput_fraction = {g}"),
                    1,
                    1,
                );
            }
        }
    }
}

/// Between the integers the port itself says what n is.
#[test]
fn fixed_point_shininesses_are_faithful() {
    for divider in DIVIDERS {
        for (bits, f, g) in [(3, 9, 9), (10, 6, 8), (2, 12, 7)] {
            assert_every_input(
                &format!(
                    "method = 'schlick'\ndivider = '{divider}'\nshininess = '1..=20'\nshininess_fraction = \
                     {bits}\ninput_fraction = {f}\noutput_fraction = {g}"
                ),
                1,
                1,
            );
        }
    }
}

#[test]
fn every_level_is_faithful() {
    for divider in DIVIDERS {
        for q in [0.05, 0.2, 0.25, 0.36, 0.5, 0.500_1, 0.75, 0.95] {
            let set = "[1, 1.0001, 1.2, 1.999, 2, 2.3, 2.9999, 3, 4.5, 60, 777.7]";
            assert_every_input(
                &format!(
                    "method = 'cubic-rational'\ndivider = '{divider}'\nshininess = {set}\nq = {q}\ninput_fraction = \
                     11\noutput_fraction = 11"
                ),
                1,
                1,
            );
        }
    }
}

#[test]
fn extreme_formats_are_faithful() {
    for core in cores() {
        for (f, g) in [(4, 4), (4, 20), (16, 4), (14, 20), (16, 6)] {
            assert_every_input(
                &format!("{core}\nshininess = '1..=40'\ninput_fraction = {f}\noutput_fraction = {g}"),
                1,
                1,
            );
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    #[test]
    fn any_core_is_faithful(
        core in 0usize..4,
        f in 4u32..=11,
        g in 4u32..=20,
        n in proptest::collection::vec(1.0f64..300.0, 1..4),
        q in 0.05f64..0.95,
        versine: bool,
    ) {
        let core = cores().nth(core).expect("four cores");
        let level = if core.contains("rational") { format!("q = {q}\n") } else { String::new() };
        let operand = if versine { "versine" } else { "cos" };
        assert_every_input(&format!("{core}\nshininess = {n:?}\n{level}operand = '{operand}'\ninput_fraction = \
         {f}\noutput_fraction = {g}"), 1, 1);
    }

    /// At widths whose inputs cannot all be tried, the model and the graph agree on random ones.
    #[test]
    fn wide_cores_equal_the_model(
        core in 0usize..4,
        f in 12u32..=24,
        g in 12u32..=20,
        first in 1u32..2000,
        codes in proptest::collection::vec(any::<u64>(), 64),
    ) {
        let core = cores().nth(core).expect("four cores");
        let spec = format!("{core}\nshininess = '{first}..={}'\ninput_fraction = {f}\noutput_fraction = \
         {g}", first + 7);
        let design = design(&spec);
        let [low, high] = design.lobe().budget.proved_ulps;
        let (least, count) = all_codes(design.lobe().operand_format());
        let highlight = (4.0 / f64::from(first) * exp2(f as i32)) as u64 + 1;
        for code in codes {
            let index = first + (code % 8) as u32;
            // Half of them on the highlight, where there is something to differ.
            let near_top = (1 << f) - ((code >> 8) % highlight) as i64;
            let operand = if code & 64 == 0 { least + (code >> 8) as i64 % count as i64 } else { near_top };
            let mut output = [0];
            design.evaluator().evaluate(index, operand, 1, &mut output);
            let lobe = design.lobe();
            prop_assert_eq!(lobe.model().evaluate(index, operand), output[0], "{} {} {}", &spec, index, operand);
            let method = lobe.lobes[(index - first) as usize].at(lobe.versine(operand)) * exp2(g as i32);
            let error = f64::from(output[0]) - method;
            prop_assert!(low - 1e-6 <= error && error <= high + 1e-6, "{} {} {}: {}", &spec, index, operand, error);
        }
    }
}

/// At x = 1 the lobe is 1, at x = 0 it is 0, and at n = 1 it is x, exactly.
#[test]
fn ends_and_the_identity_are_exact() {
    for core in cores() {
        let design = design(&format!("{core}\nshininess = '1..=1000'\noutput_fraction = 18"));
        let model = design.lobe().model();
        for n in 1..=1000 {
            assert_eq!(model.evaluate(n, 1 << 16), 1 << 18, "{core} n = {n}");
            assert_eq!(model.evaluate(n, 0), 0, "{core} n = {n}");
        }
        for code in 0..=1 << 16 {
            assert_eq!(model.evaluate(1, code), (code as u32) << 2, "{core}, the cosine's code {code}");
        }
    }
}

/// Between the last code of the cubic and the first of the tail the hardware steps by no more than an output ulp beyond
/// what the method does there, for every shininess.
#[test]
fn the_seam_is_below_an_ulp() {
    for divider in DIVIDERS {
        let design = design(&format!("method = 'cubic-rational'\ndivider = '{divider}'\nshininess = '1..=1000'"));
        let (evaluator, lobes) = (design.evaluator(), design.lobe().lobes);
        let cuts = &design.tables()[0].field("cut").codes;
        let mut largest = [0.0f64; 2];
        for row in 0..1000 {
            let index = design.lobe().interface.shininess.index_of_row(row);
            let operand = design.lobe().operand_of_versine(cuts[row] as i64 + 1);
            let mut around = [0; 2];
            evaluator.evaluate(index, operand, 1, &mut around);
            let [tail, cubic] = around.map(f64::from);
            let at = |operand: i64| lobes[row].at(design.lobe().versine(operand)) * exp2(16);
            let (own, method) = (cubic - tail, at(operand + 1) - at(operand));
            largest = [largest[0].max(own.abs() - method.abs()), largest[1].max((own - method).abs())];
        }
        println!("{divider}: beyond the method's step {largest:?}");
        assert!(largest[0] <= 1.0, "{divider}: the seam steps by {largest:?} ulp beyond the method's");
    }
}

/// Every depth gives the same function, delayed by that many clocks.
#[test]
fn every_pipeline_depth_computes_the_same() {
    for core in cores() {
        for depth in (1..=64).map(|depth| depth.to_string()).chain(["'auto'".to_owned()]) {
            let design = design(&format!(
                "{core}\nshininess = [3, 7.5, 40]\npipeline = {depth}\ninput_fraction = 8\noutput_fraction = 8"
            ));
            let latency = design.schedule.latency as usize;
            if let Ok(depth) = depth.parse::<usize>() {
                assert_eq!(latency, depth, "{core}");
            }
            let mut simulation = Simulation::new(design.graph(), &design.schedule, design.tables());
            let stimuli: Vec<(u32, i64)> = (0..60).map(|i| (i % 4, i64::from(i) * 17 % 300 - 20)).collect();
            let mut outputs = Vec::new();
            for step in 0..stimuli.len() + latency {
                let (index, operand) = stimuli.get(step).copied().unwrap_or((0, 0));
                let codes = vec![index.into(), operand.into()];
                let out = simulation.clock(&Inputs { rst: false, ce: true, in_valid: step < stimuli.len(), codes });
                if out.out_valid {
                    assert_eq!(step + 1, outputs.len() + latency, "{core} depth {depth}");
                    outputs.push(out.codes[0] as u32);
                }
            }
            let expected: Vec<u32> = stimuli.iter().map(|&(n, x)| design.lobe().model().evaluate(n, x)).collect();
            assert_eq!(outputs, expected, "{core} depth {depth}");
        }
    }
}
