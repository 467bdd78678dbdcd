use brdfgen::core::Design;
use brdfgen::explore::shape::*;
use brdfgen::spec::SpecFields;

#[test]
fn the_shape_of_a_core_is_that_of_its_graph() {
    let text = "method = 'quadratic'\nshininess = '1..=1000'";
    let design = Design::new(SpecFields::parse(text, "spec").unwrap().resolve().unwrap()).unwrap();
    let shape = Shape::of(&design);
    let widths: Vec<(u32, u32)> = shape.multipliers.iter().map(|m| (m.wide, m.narrow)).collect();
    let expected: Vec<(u32, u32)> =
        design.graph().multipliers().into_iter().map(|(a, b)| (a.max(b), a.min(b))).collect();
    assert_eq!(widths, expected);
    let table = &design.tables()[0];
    let memory = MemorySize { depth: 1024, word: table.word_bits(), registered: true };
    assert_eq!(shape.memories, [memory]);
    assert_eq!(memory.to_string().parse(), Ok(memory));
    assert_eq!(shape.register_bits, design.register_bits());
    // Of what is chosen in place of the two limits, all bits but one come from the same place either way.
    let unit = format!("{text}\ninput_range = 'unit'");
    let unit = Shape::of(&Design::new(SpecFields::parse(&unit, "spec").unwrap().resolve().unwrap()).unwrap());
    assert_eq!(shape.mux_bits - unit.mux_bits, 2 * 17 - (16 + 1 + 1));
    assert!(shape.adder_bits > 0 && "12x".parse::<MemorySize>().is_err() && "12x3r".parse::<Multiplier>().is_err());
}
