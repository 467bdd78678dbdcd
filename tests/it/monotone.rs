//! Lobes whose output never falls as the cosine rises.

use brdfgen::core::Design;
use brdfgen::emit::package;
use brdfgen::fixed::Table;
use brdfgen::generate::Core;
use brdfgen::method::{Check, Use, are_falling, variants};
use rayon::prelude::*;

use crate::common::core::design;

/// By how many ulps the output falls at most, over every code of the operand's port, found without the check of the
/// crate.
fn largest_fall(design: &Design) -> u32 {
    let lobe = design.lobe();
    let (first, count) = brdfgen::verify::golden::all_codes(lobe.operand_format());
    let of_row = |row: usize| {
        let mut outputs = vec![0; count as usize];
        lobe.evaluator().evaluate(lobe.interface.shininess.index_of_row(row), first, 1, &mut outputs);
        if lobe.takes_versine() {
            outputs.reverse();
        }
        outputs.windows(2).map(|pair| pair[0].saturating_sub(pair[1])).max().unwrap_or(0)
    };
    (0..lobe.interface.shininess.rows()).into_par_iter().map(of_row).max().unwrap_or(0)
}

#[test]
fn no_method_falls() {
    let formats = [(12, 12), (14, 9), (8, 16), (4, 4)];
    let variants = variants(Use::Table).chain(variants(Use::Exactness)).chain(variants(Use::Smallest));
    let mut specs: Vec<String> = Vec::new();
    for (place, (about, variant)) in variants.enumerate() {
        let operand = ["cos", "versine"][place % 2];
        // Squaring takes powers of two.
        let set = if about.name == "squaring" { "[1, 2, 4, 8, 16]" } else { "'1..=24'" };
        for (f, g) in formats {
            specs.push(format!(
                "{}\nshininess = {set}\noperand = '{operand}'\ninput_fraction = {f}\noutput_fraction = {g}",
                variant.spec(about)
            ));
        }
    }
    let built = specs.par_iter().filter_map(|spec| {
        // Some methods refuse some formats: cores with an accuracy, and tables.
        let design = Design::new(brdfgen::spec::SpecFields::parse(spec, "variant").unwrap().resolve().ok()?);
        let design = design.unwrap_or_else(|error| panic!("{spec}: {error}"));
        let falls = design.lobe().falls;
        assert_eq!(largest_fall(&design), falls.most_ulps, "{spec}");
        // Between interpolated coefficients a method's own lobe may fall; nowhere else.
        let own = spec.contains("shininess_fraction") && !are_falling(design.lobe().lobes);
        assert!(falls.is_proof() || own, "{spec}: {falls:?}");
        Some(())
    });
    assert!(built.count() > specs.len() * 2 / 3);
}

#[test]
fn a_fine_input_does_not_fall_either() {
    // Steps of the input that are far below those of the output, and a coefficient that is negative.
    for spec in [
        "method = 'cubic'\nq = 0.2\nshininess = [1.001, 3]\ninput_fraction = 20\noutput_fraction = 12",
        "method = 'power-2'\nshininess = [1.001, 3]\ninput_fraction = 19\noutput_fraction = 12",
        "method = 'cubic-rational'\nshininess = [1.5, 3]\ninput_fraction = 16\noutput_fraction = 10",
        "method = 'segmented-4'\nshininess = [7.5, 300]\ninput_fraction = 18\noutput_fraction = 12",
    ] {
        assert_eq!(largest_fall(&design(spec)), 0, "{spec}");
    }
}

#[test]
fn without_it_the_cores_fall_as_they_did() {
    let cores = [
        ("method = 'log-exp'\naccuracy = 9\nshininess = '1..=256'\ninput_fraction = 14\noutput_fraction = 14", 20),
        ("method = 'power-4'\nshininess = '1..=127'\ninput_fraction = 12\noutput_fraction = 12", 1),
        ("method = 'segmented-4'\nshininess = '1..=63'\ninput_fraction = 12\noutput_fraction = 12", 1),
    ];
    for (spec, fall) in cores {
        let old = design(&format!("{spec}\nmonotone = false"));
        let falls = old.lobe().falls;
        assert!(falls.exhaustive && falls.count > 0 && !falls.is_proof(), "{spec}: {falls:?}");
        assert_eq!((falls.most_ulps, largest_fall(&old)), (fall, fall), "{spec}");
        // Where it says that it falls most, it does.
        let lobe = old.lobe();
        let one = f64::from(1 << lobe.interface.input_fraction);
        let code = (falls.worst[1] * one) as i64;
        let row = lobe.interface.shininess.values().iter().position(|&n| n == falls.worst[0]).unwrap();
        let mut pair = [0; 2];
        lobe.evaluator().evaluate(lobe.interface.shininess.index_of_row(row), code - 1, 1, &mut pair);
        assert_eq!(pair[0] - pair[1], fall, "{spec}");
    }
}

#[test]
fn words_with_which_it_falls_are_found() {
    for (spec, memory, field) in [
        ("method = 'log-exp'\naccuracy = 7\nshininess = '1..=63'\ninput_fraction = 12\noutput_fraction = 12", 0, 0),
        ("method = 'segmented-4'\nshininess = '1..=15'\ninput_fraction = 12\noutput_fraction = 12", 1, 0),
        ("method = 'table'\nshininess = '1..=15'\ninput_fraction = 12\noutput_fraction = 12", 0, 0),
    ] {
        let core = design(spec);
        let check = Check::new(core.lobe().interface);
        assert!(check.holds(&core.datapath) && check.falls(&core.datapath).is_proof(), "{spec}");
        let table: &Table = &core.tables()[memory];
        // A word in the middle of the memory that is a sixteenth of its field too little or too much.
        let place = table.rows() / 2;
        let by = 1i128 << (table.fields[field].format.width().saturating_sub(4));
        for by in [by, -by] {
            let mut broken = core.datapath.clone();
            let word = &mut broken.tables[memory].fields[field].codes[place];
            let format = table.fields[field].format;
            *word = (*word + by).clamp(format.min_code(), format.max_code());
            assert!(!check.holds(&broken), "{spec}: {by}");
            assert!(check.falls(&broken).count > 0, "{spec}: {by}");
        }
    }
}

#[test]
fn a_core_with_an_accuracy_is_1_at_its_centre() {
    for accuracy in 3..=13 {
        let spec = format!(
            "method = 'log-exp'\naccuracy = {accuracy}\nshininess = '1..=40'\ninput_fraction = 12\noutput_fraction = \
             14"
        );
        let core = design(&spec);
        for index in 1..=40 {
            let mut output = [0];
            core.evaluator().evaluate(index, 1 << 12, 1, &mut output);
            assert_eq!(output[0], 1 << 14, "{spec}, n = {index}");
        }
    }
}

#[test]
fn the_proof_is_in_manifest_and_datasheet() {
    let text = "method = 'cubic'\nshininess = '1..=15'\ninput_fraction = 10\noutput_fraction = 10\nmonotone = false";
    for (text, proved) in
        [(text.replace("\nmonotone = false", ""), true), (text.replace("cubic", "segmented-2"), false)]
    {
        let core =
            Core::generate(&brdfgen::spec::SpecFields::parse(&text, "core").unwrap().resolve().unwrap()).unwrap();
        let of = |path: &str| {
            let file = core.files.iter().find(|file| file.path == path).unwrap();
            String::from_utf8(file.bytes.clone()).unwrap()
        };
        let manifest: serde_json::Value = serde_json::from_str(&of("manifest.json")).unwrap();
        let falls = core.design.lobe().falls;
        assert_eq!(manifest["monotone"]["proved"], proved);
        assert_eq!(manifest["monotone"]["falls"], falls.count);
        assert_eq!(manifest["monotone"]["pairs"], 15 * 1024);
        assert!(of("README.md").contains(&package::monotone_text(falls)));
    }
}
