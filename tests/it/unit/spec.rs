//! Specs that are taken, refused and written back.

mod reference;

use brdfgen::method::Form;
use brdfgen::platform::error::Error;
use brdfgen::spec::*;
use proptest::prelude::*;

fn parse(text: &str) -> Result<CoreSpec, Error> {
    SpecFields::parse(text, "core.toml")?.resolve()
}

fn message(text: &str) -> String {
    match parse(text).expect_err(text) {
        Error::Input { what, allowed } | Error::Text { what, allowed, .. } => format!("{what} | {allowed}"),
        other => panic!("{other}"),
    }
}

#[test]
fn defaults_are_resolved_and_written_back() {
    let spec = parse("method = \"quadratic\"\nshininess = \"1..=1000\"").unwrap();
    let LobeSpec { method, interface } = spec.block.lobe();
    assert_eq!((interface.input_fraction, interface.output_fraction, method.form()), (16, 16, Form::Stable));
    assert_eq!(spec.languages, [Language::Verilog, Language::Vhdl]);
    assert_eq!(parse(&spec.to_toml()).unwrap(), spec);
    assert_eq!(spec.command(), "brdfgen generate --method quadratic --shininess 1..=1000");
    // The default of a level that the method does not have is no obstacle.
    assert_eq!(
        parse("method = \"cubic\"\nshininess = [3]\nq = 0.051").unwrap().block.lobe().method.options().q,
        Some(0.051)
    );
}

/// What a core is comes first; then what differs from the defaults, in the order of the keys.
#[test]
fn flags_stand_in_their_order_as_a_shell_takes_them() {
    let spec = parse(
        "block = 'shader'\nmethod = 'quadratic'\ncoefficients = 'minimax'\nrom_formats = ['csv', 'c']\naxi_stream = \
         true\n\
         material = [{ name = 'a', shininess = 5 }, { name = \"b's\", shininess = 60.5 }]\n[shader]\nlights = 2\n\
         channel_bits = 10\nambient_light = [0, 0.5, 1]\nlight_colours = [[1, 1, 1], [0.25, 0, 0]]",
    );
    let expected = "--block shader --method quadratic --material a=5 --material 'b'\\''s'=60.5 --coefficients minimax \
                    --input-fraction 18 --output-fraction 14 --rom-formats mem,c,csv --axi-stream --model phong \
                    --lights 2 --channel-bits 10 --ambient-light 0,0.5,1 --light-colours '1,1,1;0.25,0,0'";
    assert_eq!(spec.unwrap().flags().join(" "), expected);
}

/// Specs without the interfaces keep the digests that they had before there were any.
#[test]
fn axi_stream_is_written_only_where_it_is_asked_for() {
    let base = "method = \"quadratic\"\nshininess = \"1..=1000\"\n";
    let plain = parse(base).unwrap();
    assert_eq!(plain.axi_stream, None);
    assert!(!plain.to_toml().contains("axi") && !plain.to_toml().contains("tuser"));
    assert_eq!(parse(&format!("{base}axi_stream = false")).unwrap(), plain);
    for (more, bits, flags) in [("", 1, "--axi-stream"), ("tuser_bits = 64", 64, "--axi-stream --tuser-bits 64")] {
        let spec = parse(&format!("{base}axi_stream = true\n{more}")).unwrap();
        assert_eq!(spec.axi_stream, Some(bits));
        assert!(spec.to_toml().contains(&format!("axi_stream = true\ntuser_bits = {bits}\n")));
        assert_eq!(parse(&spec.to_toml()).unwrap(), spec);
        assert_ne!(spec.digest(), plain.digest());
        assert_eq!(spec.command(), format!("brdfgen generate --method quadratic --shininess 1..=1000 {flags}"));
    }
}

/// As above; what the codes may be is for the design to say.
#[test]
fn golden_inputs_are_written_only_where_there_are_any() {
    let base = "method = \"quadratic\"\nshininess = \"1..=1000\"\n";
    let plain = parse(base).unwrap();
    assert!(!plain.to_toml().contains("golden_inputs"));
    assert_eq!(parse(&format!("{base}golden_inputs = []")).unwrap(), plain);
    let spec = parse(&format!("{base}golden_inputs = [[4, 57395], [7, -3]]")).unwrap();
    assert_eq!(spec.golden_inputs, "4,57395; 7, -3".parse().unwrap());
    assert!(spec.to_toml().contains("golden_inputs = [[4, 57395], [7, -3]]\n"));
    assert_eq!(parse(&spec.to_toml()).unwrap(), spec);
    assert_ne!(spec.digest(), plain.digest());
    assert_eq!(spec.flags().last().unwrap(), "--golden-inputs '4,57395;7,-3'");
    for wrong in ["4,", "", "4;;5", "0x4,5", "9223372036854775808,1"] {
        assert!(wrong.parse::<PortCodes>().unwrap_err().contains("is no code"), "{wrong}");
    }
}

#[test]
fn every_wrong_value_is_named() {
    let base = "method = \"cubic\"\nshininess = \"1..=1000\"\n";
    let set = |set: &str| format!("method = \"quadratic\"\nshininess = {set}");
    for (text, expected) in [
        (format!("{base}inputfraction = 8"), "did you mean `input_fraction`?"),
        (format!("{base}input_fraction = 0"), "input_fraction = 0 is out of range"),
        (format!("{base}output_fraction = 200"), "from 4 to 20"),
        (format!("{base}q = 1.5"), "level q = 1.5"),
        (format!("{base}name = \"module\""), "the name `module`"),
        (format!("{base}name = \"a b\""), "the name `a b`"),
        (format!("{base}pipeline = 99"), "from 1 to 64"),
        (format!("{base}languages = []"), "no language"),
        (format!("{base}[[material]]\nname = \"a\"\nshininess = 2"), "both shininess and materials"),
        (format!("{base}[[material]]\nname = \"a\"\nshine = 2"), "unknown key `shine`"),
        (set("[0.5]"), "shininess 0.5"),
        (set("[nan]"), "shininess NaN"),
        (set("[inf]"), "shininess inf"),
        (set("\"0..=5\""), "shininess 0"),
        (set("\"1..=1000000000\""), "1000000000 shininesses"),
        (set("\"0..=4294967295\""), "4294967296 shininesses"),
        (set("\"9..=2\""), "is empty"),
        (set("\"1..1000\""), "both ends"),
        (set("[]"), "0 shininesses"),
        (set("true"), "the shininess is a range"),
        ("shininess = [3]".to_owned(), "no method"),
        ("method = \"cubic\"".to_owned(), "no shininess"),
        (format!("{base}shininess_fraction = 40"), "from 0 to 10"),
        (format!("{base}g = 0.1"), "the method cubic has no level g"),
        (format!("{base}divider = \"digit\""), "the method cubic has no divider"),
        (format!("{base}inside = \"linear\""), "the method cubic has no choice of inside"),
        (format!("{base}coefficients = \"minimax\"\nq = 0.4"), "no level q with fitted coefficients"),
        (format!("{base}coefficients = \"minimax\"\nform = \"paper\""), "the paper form has the paper's"),
        ("method = \"schlick\"\nshininess = [3]\ncoefficients = \"paper\"".to_owned(), "has no paper coefficients"),
        ("method = \"cubic-three-point\"\nshininess = [3]\ng = 0.6".to_owned(), "level g = 0.6"),
        ("method = \"quadratic\"\nshininess = [3]\ntail = \"hold\"".to_owned(), "has no choice of tail"),
        ("method = \"quadratic\"\nshininess = [3]\nshininess_fraction = 2".to_owned(), "needs a range"),
        (set("\"3..=4\"\nform = \"paper\"\nshininess_fraction = 1"), "the paper form takes no shininess between"),
        (format!("{base}form = \"paper\"\nshininess_fraction = 10"), "the paper form takes no shininess between"),
        (format!("{}\nq = 0.7", set("[3]")), "the method quadratic has no level q"),
        (format!("{base}tuser_bits = 4"), "tuser_bits is given for a core without AXI4-Stream interfaces"),
        (format!("{base}axi_stream = false\ntuser_bits = 4"), "give axi_stream as well"),
        (format!("{base}axi_stream = true\ntuser_bits = 0"), "tuser_bits = 0 is out of range"),
        (format!("{base}axi_stream = true\ntuser_bits = 65"), "from 1 to 64"),
        (format!("{base}axi_stream = 1"), "invalid type"),
        (format!("{base}golden_inputs = [4, 57395]"), "invalid type"),
        (format!("{base}golden_inputs = [[4, 1.5]]"), "invalid type"),
    ] {
        let message = message(&text);
        assert!(message.contains(expected), "{text}\n{message}\nexpected: {expected}");
    }
}

proptest! {
    #[test]
    fn any_text_is_taken_or_refused(text in "\\PC*") {
        let _ = parse(&text);
    }

    #[test]
    fn any_value_is_taken_or_refused(
        key in "(method|form|q|shininess|input_fraction|rom|pipeline|languages|name)",
        value in "(\"[a-z0-9.=,]{0,12}\"|-?[0-9]{1,12}|[0-9]{1,3}\\.[0-9]{1,3}|\\[[0-9., ]{0,9}\\]|nan|true)",
    ) {
        let _ = parse(&format!("method = \"cubic\"\nshininess = [3]\n{key} = {value}\n"));
        let _ = parse(&format!("{key} = {value}\n"));
    }

    #[test]
    fn resolved_specs_survive_toml(
        n in proptest::collection::vec(1.0f64..5000.0, 1..5),
        f in 4u32..=24,
        g in 4u32..=20,
        q in 0.05f64..0.95,
        depth in 1u32..=32,
    ) {
        let text = format!("method = \"cubic\"\nshininess = {n:?}\ninput_fraction = {f}\noutput_fraction = {g}\nq = \
         {q:?}\npipeline = {depth}\nrom_formats = [\"csv\", \"mem\", \"csv\"]");
        let spec = parse(&text).unwrap();
        prop_assert_eq!(&parse(&spec.to_toml()).unwrap(), &spec);
    }
}
