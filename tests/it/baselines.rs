//! The baselines: their proofs against brute force, the model, their errors against x^n, what they refuse.

use brdfgen::core::{Design, Measured};
use brdfgen::fixed::exp2;
use brdfgen::lobe;
use brdfgen::method::harris::Harris;
use brdfgen::method::table::Tabulated;
use brdfgen::platform::error::Error;
use brdfgen::spec::SpecFields;
use proptest::prelude::*;

use crate::common::core::{assert_every_input, design};

fn try_design(spec: &str) -> Result<Design, Error> {
    SpecFields::parse(spec, "test").and_then(SpecFields::resolve).and_then(Design::new)
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
                "method = 'squaring'\nshininess = {set}\ninput_fraction = {f}\noutput_fraction = {g}\noperand = \
                 '{operand}'"
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
    let measured = Measured::of(design.lobe());
    assert!(measured.sweep.exhaustive && measured.max_abs < exp2(-16) && measured.max_abs > exp2(-18));
    assert_eq!(evaluate(&design, 5, 1 << 16), 1 << 16);
    assert_eq!([evaluate(&design, 0, 0), evaluate(&design, 3, -5)], [0, 0]);
    // A chain of ten squarings, and no other multiplication.
    assert_eq!(design.function().multipliers().len(), 10);
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
    fn any_squaring_core_is_within_the_proof(
        f in 4u32..=11,
        g in 4u32..=20,
        logs in prop::collection::vec(0u32..=20, 1..6),
    ) {
        let set: Vec<u32> = logs.iter().map(|log| 1 << log).collect();
        assert_every_input(&format!("method = 'squaring'\nshininess = {set:?}\ninput_fraction = {f}\noutput_fraction = \
         {g}"), 1, 1);
    }
}

/// Each method of tables with sets of every kind, for every input.
#[test]
fn tables_are_within_the_proof_for_every_input() {
    for method in [
        "method = 'harris'\nlog_bits = 4\nexp_bits = 5",
        "method = 'harris'\nlog_bits = 2\nexp_bits = 9",
        "method = 'harris'\nlog_bits = 9\nexp_bits = 2",
        "method = 'table'\ntable_bits = 2",
        "method = 'table'\ntable_bits = 5",
        "method = 'table'\ntable_bits = 9",
    ] {
        for (set, f, g) in [
            ("'1..=100'", 12, 12),
            ("'1..=200'", 8, 14),
            ("'120..=131'", 10, 8),
            ("[1, 1.0001, 1.3, 2.71828, 7, 99.9]", 11, 16),
            ("[1.5, 64, 1234.567, 300000.3, 1048576]", 13, 4),
            ("[1]", 4, 20),
            // Four entries, all rounded down, and 0 exactly where the surface faces away.
            ("[16]", 4, 20),
            ("[17.25]", 14, 10),
            ("'3..=3'", 9, 9),
        ] {
            for operand in ["cos", "versine"] {
                assert_every_input(
                    &format!(
                        "{method}\nshininess = {set}\ninput_fraction = {f}\noutput_fraction = {g}\noperand = \
                         '{operand}'"
                    ),
                    1,
                    3,
                );
            }
        }
    }
    for (set, bits) in [("1..=40", 4), ("5..=6", 10), ("7..=7", 2)] {
        let set = format!("shininess = '{set}'\nshininess_fraction = {bits}");
        assert_every_input(
            &format!("method = 'harris'\nlog_bits = 5\nexp_bits = 6\n{set}\ninput_fraction = 11\noutput_fraction = 10"),
            1,
            5,
        );
    }
}

#[test]
fn tables_of_the_default_sizes_are_within_the_proof() {
    assert_every_input("method = 'harris'\nshininess = '1..=1000'", 7, 61);
    assert_every_input("method = 'table'\nshininess = '1..=1000'", 7, 61);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    #[test]
    fn any_small_core_with_tables_is_within_the_proof(
        f in 4u32..=11,
        g in 4u32..=20,
        n in prop::collection::vec(1.0f64..300.0, 1..4),
        log in 2u32..=8,
        exp in 2u32..=10,
        table in 2u32..=12,
        versine: bool,
    ) {
        let operand = if versine { "versine" } else { "cos" };
        let rest = format!("shininess = {n:?}\noperand = '{operand}'\ninput_fraction = {f}\noutput_fraction = {g}");
        assert_every_input(&format!("method = 'harris'\nlog_bits = {log}\nexp_bits = {exp}\n{rest}"), 1, 1);
        assert_every_input(&format!("method = 'table'\ntable_bits = {table}\n{rest}"), 1, 1);
    }
}

/// The largest |hardware - x^n| over every input.
fn largest_error(spec: &str) -> f64 {
    let measured = Measured::of(design(spec).lobe());
    assert!(measured.sweep.exhaustive, "{spec}");
    measured.max_abs
}

/// A cell of the logarithm counts `n u e^(-n u) 2^-log_bits` at most, half of it on either side; a cell of the
/// exponential half of `ln 2 2^-exp_bits`: the error against x^n is near the sum of both, for small and large
/// shininesses alike.
#[test]
fn the_error_of_harris_is_that_of_its_cells() {
    for (log, exp) in [(4, 5), (6, 7), (8, 9), (9, 7)] {
        let cells = 0.5 * (libm::exp(-1.0) * exp2(-log) + std::f64::consts::LN_2 * exp2(-exp));
        for set in ["[1, 2, 3.5]", "[10, 30]", "'990..=1000'"] {
            let spec = format!("method = 'harris'\nlog_bits = {log}\nexp_bits = {exp}\nshininess = {set}");
            let error = largest_error(&spec);
            assert!(0.4 * cells < error && error < 1.6 * cells, "{spec}: {error}, cells {cells}");
        }
    }
}

/// The constant of a cell is half of the cell's fall off, which is `n 2^-table_bits` at most.
#[test]
fn the_error_of_a_table_is_half_of_the_steepest_cell() {
    for (n, bits) in [(1, 4), (4, 6), (30, 8), (30, 12)] {
        let spec = format!("method = 'table'\ntable_bits = {bits}\nshininess = [{n}]");
        let half = 0.5 * (1.0 - lobe::exact(f64::from(n), exp2(-bits) - exp2(-16)));
        let error = largest_error(&spec);
        assert!((error - half).abs() < exp2(-16), "{spec}: {error}, half of the first cell {half}");
    }
    // With an entry for each versine the table is the power itself.
    let error = largest_error("method = 'table'\ntable_bits = 12\nshininess = [1, 7, 900]\ninput_fraction = 12");
    assert!(error <= exp2(-17), "{error}");
}

/// One multiplier or none, and the memories that the keys ask for.
#[test]
fn the_tables_have_the_sizes_asked_for() {
    let harris = design("method = 'harris'\nshininess = '1..=1000'\nlog_bits = 5\nexp_bits = 7");
    assert_eq!(harris.function().multipliers().len(), 1);
    let sizes: Vec<(&str, usize)> = harris.tables().iter().map(|table| (table.name, table.rows())).collect();
    assert_eq!(sizes, [("log_table", 16 << 5), ("exp_table", 1 << 7)]);
    let table = design("method = 'table'\nshininess = [5, 50, 500]\ntable_bits = 6");
    assert_eq!((table.function().multipliers().len(), table.tables()[0].rows()), (0, 3 << 6));
}

#[test]
fn the_dark_side_is_dark() {
    for method in ["harris", "table", "squaring"] {
        let design = design(&format!("method = '{method}'\nshininess = [1, 4, 64]"));
        for code in [0, -1, -(1 << 16), -(1 << 17)] {
            assert_eq!((0..3).map(|index| evaluate(&design, index, code)).collect::<Vec<_>>(), [0; 3], "{method}");
        }
    }
}

#[test]
fn a_table_that_is_too_large_is_refused() {
    assert_refused(
        "method = 'table'\nshininess = '1..=1000'\ntable_bits = 8",
        &["1000 shininesses with 256 entries", "131072 entries", "table_bits is at most 7"],
    );
    assert_refused("method = 'table'\nshininess = '1..=60000'\ntable_bits = 2", &["give fewer shininesses"]);
    assert_refused("method = 'table'\nshininess = [3]\ntable_bits = 15", &["table_bits = 15", "from 2 to 14"]);
    assert_refused("method = 'table'\nshininess = '1..=2'\nshininess_fraction = 1", &["between the integers"]);
    assert_refused("method = 'harris'\nshininess = [3]\nlog_bits = 1", &["log_bits = 1", "from 2 to 12"]);
    assert_refused("method = 'harris'\nshininess = [3]\nexp_bits = 20", &["exp_bits = 20", "from 2 to 14"]);
    assert_refused("method = 'harris'\nshininess = [3]\ntable_bits = 5", &["the method harris has no table_bits"]);
    assert_refused("method = 'table'\nshininess = [3]\nlog_bits = 5", &["the method table has no log_bits"]);
    assert_refused("method = 'table'\nshininess = [3]\nname = 'table'", &["the name `table` is not allowed"]);
}

/// The keys of the sizes survive being written, and the flags say them.
#[test]
fn the_sizes_are_written_back() {
    for (text, flags) in [
        ("method = 'harris'\nshininess = [3]\nlog_bits = 5\nexp_bits = 6", "--log-bits 5 --exp-bits 6"),
        ("method = 'table'\nshininess = [3]\ntable_bits = 4", "--table-bits 4"),
    ] {
        let spec = SpecFields::parse(text, "test").and_then(SpecFields::resolve).unwrap();
        assert_eq!(SpecFields::parse(&spec.to_toml(), "test").and_then(SpecFields::resolve).unwrap(), spec);
        assert!(spec.command().contains(flags), "{}", spec.command());
    }
    for method in ["schlick", "squaring", "harris", "table"] {
        let text = format!("method = '{method}'\nshininess = [4]");
        assert!(
            SpecFields::parse(&text, "test")
                .and_then(SpecFields::resolve)
                .unwrap()
                .block
                .lobe()
                .method
                .about()
                .is_baseline
        );
    }
    let other = SpecFields::parse("method = 'log-exp'\nshininess = [4]", "test").and_then(SpecFields::resolve).unwrap();
    assert!(!other.block.lobe().method.about().is_baseline && !other.to_toml().contains("_bits"));
}

/// The lobes' numbers where they are known exactly.
#[test]
fn the_entries_are_those_of_the_formulas() {
    let log = |first: f64, last: f64| Harris::logarithm(first, last);
    for (first, last, exact) in [(0.0, 0.0, 0.0), (0.5, 0.5, 1.0), (0.625, 0.875, 2.0), (0.9375, 0.9375, 4.0)] {
        assert!((log(first, last) - exact).abs() < 1e-15, "{first}..{last}");
    }
    // -log2(1 - 2^-20), from 50 digits.
    assert!((log(exp2(-20), exp2(-20)) - 1.375_861_862_964_634_2e-6).abs() < 1e-20);
    assert_eq!(Harris::exponential(0.0, 1.0), 0.75);
    // Four cells of squares over sixteenths: 1 and (13/16)^2, 9/16 and (9/16)^2, and so on.
    let table = Tabulated::new(2.0, 4, 1.0 / 16.0).unwrap();
    let mean = |first: i32, last: i32| f64::from(first * first + last * last) / 512.0;
    let exact = [mean(16, 13), mean(12, 9), mean(8, 5), mean(4, 1)];
    assert!(table.entries.iter().zip(exact).all(|(entry, exact)| (entry - exact).abs() < 1e-15), "{table:?}");
    assert!(Tabulated::new(0.5, 4, 0.1).is_err());
}
