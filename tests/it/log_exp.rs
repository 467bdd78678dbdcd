//! The power from a logarithm and an exponential: its proof against brute force, its exact places, its vectors.

use std::sync::atomic::{AtomicU64, Ordering};

use brdfgen::core::Design;
use brdfgen::datapath::evaluate::Evaluator;
use brdfgen::fixed::{Table, exp2};
use brdfgen::lobe;
use brdfgen::verify::golden::{Golden, all_codes};
use proptest::prelude::*;
use rayon::prelude::*;

use crate::common::core::every_input;

fn design(spec: &str) -> Design {
    crate::common::core::design(&format!("method = 'log-exp'\n{spec}"))
}

fn evaluate(design: &Design, index: u32, operand: i64) -> u32 {
    let mut output = [0];
    design.evaluator().evaluate(index, operand, 1, &mut output);
    output[0]
}

/// The result in output ulps minus x^n for the versine and the real shininess that the codes stand for.
fn error(design: &Design, index: u32, operand: i64, output: u32) -> f64 {
    let n = design.lobe().interface.shininess.value(design.lobe().interface.shininess.row_of_index(index));
    f64::from(output)
        - lobe::exact(n, design.lobe().versine(operand)) * exp2(design.lobe().interface.output_fraction as i32)
}

fn assert_within(design: &Design, spec: &str, index: u32, operand: i64, output: u32) {
    let [low, high] = design.lobe().budget.proved_ulps;
    let accuracy = design.lobe().method.options().accuracy;
    let allowed = accuracy.map_or(1.0, |bits| exp2(design.lobe().interface.output_fraction as i32 - bits as i32));
    assert!(-allowed < low && high < allowed, "{spec}: proved {low}..{high}");
    let error = error(design, index, operand, output);
    // The power itself is computed in double precision here: its relative error is below (2 + n |ln x|) 2^-52.
    assert!(
        low - 1e-6 <= error && error <= high + 1e-6,
        "{spec}: in_n {index}, operand {operand}: {output}, error {error} outside {low}..{high}"
    );
    assert!(
        output <= 1 << design.lobe().interface.output_fraction,
        "{spec}: in_n {index}, operand {operand}: {output}"
    );
}

/// Every code of the operand port for every `row_step`th shininess: within the proved bound of x^n, and at every
/// `stride`th code equal to the model.
fn assert_every_input(spec: &str, row_step: usize, stride: i64) {
    let design = design(spec);
    every_input(design.lobe(), row_step, stride, |_, index, operand, output| {
        assert_within(&design, spec, index, operand, output);
    });
}

#[test]
fn every_input_of_small_cores_is_within_the_proof() {
    for (f, g) in [(10, 10), (10, 6), (9, 13), (12, 8), (4, 20), (6, 4)] {
        let spec = format!("shininess = '1..=300'\ninput_fraction = {f}\noutput_fraction = {g}");
        assert_every_input(&spec, 1, 3);
        let spec = format!("shininess = '1..=40'\nshininess_fraction = 4\ninput_fraction = {f}\noutput_fraction = {g}");
        assert_every_input(&spec, 1, 7);
    }
}

#[test]
fn every_cosine_of_the_default_core_is_within_the_proof() {
    assert_every_input("shininess = '1..=1000'", 7, 61);
}

#[test]
fn a_range_whose_least_shininess_needs_little_of_x_is_within_the_proof() {
    // From n = G + 1 on a cosine below 1/2 gives 0: there is nothing to normalise.
    for (range, most) in [("5..=20", 2), ("12..=90", 1), ("17..=40", 0), ("300..=400", 0)] {
        let spec = format!("shininess = '{range}'\ninput_fraction = 12\noutput_fraction = 12");
        assert_every_input(&spec, 1, 5);
        let steps = design(&spec).graph().nodes.iter().filter(|node| node.name.starts_with("m_moved_")).count();
        assert_eq!(steps, most, "{range}");
    }
}

#[test]
fn an_accuracy_is_kept_at_every_input() {
    for (accuracy, f, g) in [(3, 8, 8), (4, 11, 6), (5, 12, 12), (6, 10, 16), (7, 12, 9), (9, 13, 12), (11, 12, 16)] {
        let spec = format!("accuracy = {accuracy}\ninput_fraction = {f}\noutput_fraction = {g}");
        assert_every_input(&format!("{spec}\nshininess = '1..=300'"), 1, 7);
        assert_every_input(&format!("{spec}\nshininess = '3..=70'\noperand = 'versine'"), 1, 5);
    }
}

/// With n = 1 by a way of its own, the shininesses that the proof takes together begin behind it.
#[test]
fn an_accuracy_is_kept_by_every_shininess_of_a_coarse_cosine() {
    assert_every_input("accuracy = 11\nshininess = '1..=39'\ninput_fraction = 8\noutput_fraction = 14", 1, 3);
}

#[test]
fn every_cosine_of_the_default_core_keeps_an_accuracy() {
    for accuracy in [5, 14] {
        assert_every_input(&format!("accuracy = {accuracy}\nshininess = '1..=1000'"), 7, 61);
    }
}

#[test]
fn an_accuracy_is_kept_by_lists_and_by_shininesses_between_the_integers() {
    let list = "shininess = [1, 1.0001, 1.3, 2.71828, 7, 99.9, 1234.567, 300000.3]";
    assert_every_input(&format!("{list}\naccuracy = 8\ninput_fraction = 14\noutput_fraction = 12"), 1, 3);
    assert_every_input("shininess = [640, 5, 20]\naccuracy = 10\ninput_fraction = 13", 1, 3);
    assert_every_input("shininess = [1]\naccuracy = 7\ninput_fraction = 12", 1, 1);
    let fixed = "shininess = '1..=40'\nshininess_fraction = 4\naccuracy = 6\ninput_fraction = 11";
    assert_every_input(fixed, 1, 7);
}

#[test]
fn tables_lie_where_they_are_asked_to() {
    let memories = |memory: &str| {
        let spec = format!("accuracy = 10\nshininess = '1..=200'\ninput_fraction = 14\nmemory = '{memory}'");
        let design = design(&spec);
        design.tables().iter().map(|table| table.rows() as u64 * u64::from(table.word_bits())).collect::<Vec<_>>()
    };
    assert!(memories("logic").iter().all(|&bits| bits <= 2048), "{:?}", memories("logic"));
    assert!(memories("block").iter().any(|&bits| bits > 2048), "{:?}", memories("block"));
}

#[test]
fn versines_are_within_the_proof() {
    assert_every_input("shininess = '1..=100'\noperand = 'versine'\ninput_fraction = 12\noutput_fraction = 11", 1, 5);
    assert_every_input("shininess = [1, 7.7, 500000]\noperand = 'versine'\noutput_fraction = 20", 1, 5);
}

#[test]
fn codes_from_0_to_1_are_within_the_proof() {
    for operand in ["cos", "versine"] {
        for set in ["'3..=70'", "[1, 2, 40]", "[1000]"] {
            let unit = format!(
                "shininess = {set}\noperand = '{operand}'\ninput_range = 'unit'\naccuracy = 6\ninput_fraction = 11"
            );
            assert_every_input(&unit, 1, 1);
        }
    }
}

#[test]
fn rounding_a_list_to_its_rom_is_in_the_proof() {
    let list = "shininess = [1, 1.0001, 1.3, 2.71828, 7, 99.9, 1234.567, 300000.3, 1048576]";
    for (f, g) in [(16, 16), (13, 8), (11, 20), (20, 12)] {
        assert_every_input(&format!("{list}\ninput_fraction = {f}\noutput_fraction = {g}"), 1, 11);
    }
    let design = design(&format!("{list}\noutput_fraction = 8"));
    assert!(design.lobe().budget.coefficient_ulps[0] < 0.0 && design.lobe().budget.coefficient_ulps[1] > 0.0);
    // Numbers of few bits are exact in the ROM.
    let design = self::design("shininess = [5, 12.5, 80.25]");
    assert_eq!(design.lobe().budget.coefficient_ulps, [0.0, 0.0]);
    assert_eq!(design.datapath.coefficients().map(|table| table.field("n").format.frac_bits), Some(2));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    #[test]
    fn any_small_core_is_within_the_proof(
        f in 4u32..=11,
        g in 4u32..=20,
        n in proptest::collection::vec(1.0f64..300.0, 1..4),
        versine: bool,
    ) {
        let operand = if versine { "versine" } else { "cos" };
        assert_every_input(&format!("shininess = {n:?}\noperand = '{operand}'\ninput_fraction = {f}\noutput_fraction = \
         {g}"), 1, 1);
    }

    #[test]
    fn any_accuracy_is_kept(
        a in 3u32..=13,
        f in 8u32..=12,
        spare in 1u32..=6,
        first in 1u32..=9,
        span in 0u32..=300,
        versine: bool,
        unit: bool,
    ) {
        let (operand, g, last) = (if versine { "versine" } else { "cos" }, a + spare, first + span);
        let range = if unit { "unit" } else { "any" };
        let spec = format!("accuracy = {a}\nshininess = '{first}..={last}'\noperand = '{operand}'\ninput_range = \
         '{range}'");
        assert_every_input(&format!("{spec}\ninput_fraction = {f}\noutput_fraction = {g}"), 1, 3);
    }

    /// At widths whose inputs cannot all be tried: random ones, on the highlight and anywhere, and ones near the ends
    /// of the tables' entries.
    #[test]
    fn wide_cores_are_within_the_proof(
        f in 12u32..=24,
        g in 12u32..=20,
        first in 1u32..=3000,
        span in 0u32..=60_000,
        r in 0u32..=10,
        versine: bool,
        codes in proptest::collection::vec(any::<u64>(), 600),
    ) {
        let operand = if versine { "versine" } else { "cos" };
        let last = (first + span).min(first + 65_535);
        let spec = format!("shininess = '{first}..={last}'\nshininess_fraction = {r}\noperand = \
         '{operand}'\ninput_fraction = {f}\noutput_fraction = {g}");
        let design = design(&spec);
        let (evaluator, model) = (design.evaluator(), design.lobe().model());
        let rows = design.lobe().interface.shininess.rows() as u64;
        for code in codes {
            // As many small shininesses as large ones.
            let row = (code >> 40) % (rows >> ((code >> 8) % 20)).max(1);
            let index = design.lobe().interface.shininess.index_of_row(row as usize);
            let n = design.lobe().interface.shininess.value(row as usize);
            let one = 1u64 << f;
            let draw = code >> 20 & 0xf_ffff;
            let versine = match code & 3 {
                0 => draw % (one + 1),
                // From z = 0 to well past what the result shows.
                1 | 2 => ((draw as f64 * exp2(-20) * 1.3 * f64::from(g) / n).min(1.0) * one as f64) as u64,
                // A few bits only, and their neighbours.
                _ => {
                    let few_bits = one - ((draw & 31) << (code >> 8 & 31) & (one - 1));
                    few_bits.wrapping_add((code >> 16 & 3).wrapping_sub(1))
                }
            };
            let operand = design.lobe().operand_of_versine(versine.min(one) as i64);
            let mut output = [0];
            evaluator.evaluate(index, operand, 1, &mut output);
            assert_within(&design, &spec, index, operand, output[0]);
            prop_assert_eq!(model.evaluate(index, operand), output[0], "{} {} {}", &spec, index, operand);
        }
    }
}

/// n = 1 gives x, rounded to nearest where the output has fewer bits; x = 1 gives 1, and x <= 0 gives 0.
#[test]
fn the_exact_places_are_exact() {
    for (f, g) in [(16, 16), (16, 20), (12, 13), (16, 8), (24, 12), (10, 4)] {
        for set in ["'1..=1000'", "[7, 1, 900.5]"] {
            let design = design(&format!("shininess = {set}\ninput_fraction = {f}\noutput_fraction = {g}"));
            let one = 1i64 << f;
            let index = design.lobe().interface.shininess.index_of_row(usize::from(set.starts_with('[')));
            let step = (one / 4096).max(1) as usize;
            for code in (0..=one).step_by(step).chain([one - 1, 1, 2, 3]) {
                let exact = if g >= f { code << (g - f) } else { ((code >> (f - g - 1)) + 1) >> 1 };
                assert_eq!(i64::from(evaluate(&design, index, code)), exact, "F {f} G {g} set {set} code {code}");
            }
            for row in (0..design.lobe().interface.shininess.rows()).step_by(37) {
                let index = design.lobe().interface.shininess.index_of_row(row);
                for code in [one, one + 1, 2 * one - 1] {
                    assert_eq!(evaluate(&design, index, code), 1 << g);
                }
                for code in [0, -1, -one, -2 * one] {
                    assert_eq!(evaluate(&design, index, code), 0);
                }
            }
        }
    }
}

/// The target for the method: at most 0.01 % from n = 4 on, at 16 bits.
#[test]
fn the_target_is_met() {
    let design = design("shininess = '4..=1000'");
    let measured = brdfgen::core::Measured::of(design.lobe());
    assert!(measured.sweep.exhaustive && measured.max_abs < 0.000_02, "{}", measured.max_abs);
}

/// The tables have as many entries as the wanted error needs: more for a finer output, and about 4 times as many for 4
/// bits.
#[test]
fn tables_grow_with_the_wanted_error() {
    let sizes = [8, 12, 16, 20].map(|g| {
        let design = design(&format!("shininess = '1..=1000'\noutput_fraction = {g}"));
        design.tables().iter().map(Table::rows).collect::<Vec<_>>()
    });
    for pair in sizes.windows(2) {
        for (coarse, fine) in pair[0].iter().zip(&pair[1]) {
            assert!((2..=8).contains(&(fine / coarse)), "{sizes:?}");
        }
    }
}

/// An entry of a function table with any one bit flipped changes the answer to some golden vector, unless it changes
/// the answer to no input at all.
#[test]
fn golden_vectors_notice_every_flipped_bit_of_an_entry() {
    for spec in [
        "shininess = '1..=60'\ninput_fraction = 10\noutput_fraction = 10",
        "shininess = [1, 2.5, 80]\ninput_fraction = 12\noutput_fraction = 9\noperand = 'versine'",
    ] {
        let design = design(spec);
        let golden = Golden::of(&design);
        let vectors = golden.vectors();
        let (first, count) = all_codes(design.lobe().operand_format());
        let rows: Vec<u32> = (0..design.lobe().interface.shininess.rows())
            .map(|row| design.lobe().interface.shininess.index_of_row(row))
            .collect();
        let every_output = |evaluator: &Evaluator| -> Vec<u32> {
            let mut outputs = vec![0; rows.len() * count as usize];
            for (&index, outputs) in rows.iter().zip(outputs.chunks_mut(count as usize)) {
                evaluator.evaluate(index, first, 1, outputs);
            }
            outputs
        };
        let right = every_output(&design.evaluator());
        let mut flips = Vec::new();
        for (memory, table) in design.tables().iter().enumerate().filter(|(_, table)| table.key == "entry") {
            for (field, of) in table.fields.iter().enumerate() {
                let bits = 0..of.format.width();
                flips.extend(bits.flat_map(|bit| (0..table.rows()).map(move |entry| (memory, field, bit, entry))));
            }
        }
        let harmless = AtomicU64::new(0);
        flips.par_iter().for_each(|&(memory, field, bit, entry)| {
            let mut tables = design.tables().to_vec();
            let flipped = &mut tables[memory].fields[field];
            flipped.codes[entry] = flipped.format.wrap(flipped.codes[entry] ^ (1 << bit));
            let wrong = Evaluator::new(design.graph(), &tables);
            let noticed = vectors.iter().any(|vector| {
                let mut output = [0];
                wrong.evaluate(vector.inputs[0] as u32, vector.inputs[1], 1, &mut output);
                i64::from(output[0]) != vector.outputs[0]
            });
            if !noticed {
                assert_eq!(
                    every_output(&wrong),
                    right,
                    "{spec}: memory {memory}, field {field}, bit {bit}, entry {entry}"
                );
                harmless.fetch_add(1, Ordering::Relaxed);
            }
        });
        let harmless = harmless.into_inner() as usize;
        assert!(harmless < flips.len() / 10, "{spec}: {harmless} of {} flips change nothing", flips.len());
    }
}
