//! The baselines: their proofs against brute force, the model, their errors against x^n, what they refuse.

use std::sync::atomic::{AtomicU64, Ordering};

use brdfgen::design::{Design, Measured};
use brdfgen::error::Error;
use brdfgen::golden::all_codes;
use brdfgen::number::exp2;
use brdfgen::spec::SpecFields;
use proptest::prelude::*;
use rayon::prelude::*;

fn try_design(spec: &str) -> Result<Design, Error> {
    SpecFields::parse(spec, "test").and_then(SpecFields::resolve).and_then(Design::new)
}

fn design(spec: &str) -> Design {
    try_design(spec).expect(spec)
}

/// Every code of the operand port for every `row_step`th shininess: within the proved bound of the real-valued method, which is below one
/// output ulp, and at every `stride`th code equal to the model.
fn assert_every_input(spec: &str, row_step: usize, stride: i64) {
    let design = design(spec);
    let [low, high] = design.budget.proved_ulps;
    assert!(-1.0 < low && high < 1.0, "{spec}: proved {low}..{high}");
    let scale = exp2(design.spec.output_fraction as i32);
    let (first, count) = all_codes(design.operand_format());
    let (evaluator, model, lobes) = (design.evaluator(), design.model(), design.lobes());
    let compared = AtomicU64::new(0);
    let rows: Vec<usize> = (0..design.spec.shininess.rows()).step_by(row_step).collect();
    rows.par_iter().for_each(|&row| {
        let index = design.spec.shininess.index_of_row(row);
        let mut outputs = vec![0u32; count as usize];
        evaluator.evaluate(index, first, 1, &mut outputs);
        let mut own = 0;
        for (offset, &output) in outputs.iter().enumerate() {
            let operand = first + offset as i64;
            let error = f64::from(output) - lobes[row].at(design.versine(operand)) * scale;
            // The method itself is computed in double precision here.
            assert!(
                low - 1e-6 <= error && error <= high + 1e-6 && f64::from(output) <= scale,
                "{spec}: row {row}, operand {operand}: {output}, error {error} outside {low}..{high}"
            );
            if (operand + row as i64) % stride == 0 {
                assert_eq!(model.evaluate(index, operand), output, "{spec}: row {row}, operand {operand}");
                own += 1;
            }
        }
        compared.fetch_add(own, Ordering::Relaxed);
    });
    let expected = rows.len() as u64 * count / stride.unsigned_abs();
    assert!(compared.into_inner() >= expected / 2, "{spec}: too few compared with the model");
}

fn evaluate(design: &Design, index: u32, operand: i64) -> u32 {
    let mut output = [0];
    design.evaluator().evaluate(index, operand, 1, &mut output);
    output[0]
}

/// What is refused, and in which words.
fn assert_refused(spec: &str, words: &[&str]) {
    let error = try_design(spec).expect_err(spec);
    let Error::Input { what, allowed } = &error else { panic!("{spec}: {error}") };
    let text = format!("{what} | {allowed}");
    assert!(words.iter().all(|word| text.contains(word)), "{spec}: {text}");
}

#[test]
fn squaring_is_within_the_proof_for_every_input() {
    for (set, f, g) in [
        ("[1, 2, 4, 8, 16, 32, 64, 128, 256, 512]", 12, 12),
        ("[1, 2, 4, 8, 16, 32, 64, 128, 256, 512]", 9, 14),
        ("[64, 2, 2, 1024, 16]", 13, 8),
        ("[1, 1048576]", 16, 20),
        ("'1..=2'", 10, 10),
        ("[1]", 10, 6),
        ("[1]", 6, 10),
        ("'32..=32'", 12, 10),
    ] {
        for operand in ["cos", "versine"] {
            let spec = format!(
                "method = 'squaring'\nshininess = {set}\ninput_fraction = {f}\noutput_fraction = {g}\noperand = '{operand}'"
            );
            assert_every_input(&spec, 1, 1);
        }
    }
    assert_every_input("method = 'squaring'\nshininess = [1, 2, 4, 8, 16, 32, 64, 128, 256, 512]", 1, 7);
}

/// The method is the power itself: the measured error is that of the roundings.
#[test]
fn squaring_is_the_power() {
    let design = design("method = 'squaring'\nshininess = [1, 4, 16, 64, 256, 1024]");
    let measured = Measured::of(&design);
    assert!(measured.sweep.exhaustive && measured.max_abs < exp2(-16) && measured.max_abs > exp2(-18));
    assert_eq!(evaluate(&design, 5, 1 << 16), 1 << 16);
    assert_eq!([evaluate(&design, 0, 0), evaluate(&design, 3, -5)], [0, 0]);
    // A chain of ten squarings, and no other multiplication.
    assert_eq!(design.graph().multipliers().len(), 10);
}

#[test]
fn squaring_refuses_what_is_no_power_of_two() {
    for (set, n) in [("[2, 3]", "3"), ("'1..=4'", "3"), ("[2.5]", "2.5"), ("[1.0000001]", "1.0000001")] {
        assert_refused(
            &format!("method = 'squaring'\nshininess = {set}"),
            &[&format!("shininess {n} is not a power of two"), "1,2,4,8,16"],
        );
    }
    assert_refused("method = 'squaring'\nshininess = '1..=2'\nshininess_fraction = 1", &["between the integers"]);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    #[test]
    fn any_squaring_core_is_within_the_proof(f in 4u32..=11, g in 4u32..=20, logs in prop::collection::vec(0u32..=20, 1..6)) {
        let set: Vec<u32> = logs.iter().map(|log| 1 << log).collect();
        assert_every_input(&format!("method = 'squaring'\nshininess = {set:?}\ninput_fraction = {f}\noutput_fraction = {g}"), 1, 1);
    }
}
