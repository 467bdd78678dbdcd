use brdfgen::target::*;

#[test]
fn a_family_is_spelt_as_in_files() {
    for family in Family::ALL {
        assert_eq!(serde_json::to_value(family).unwrap(), family.name);
    }
    assert_eq!(Family::default(), Family::Ecp5);
}

#[test]
fn the_first_kind_that_fits_a_cell_counts() {
    let cells = [("MULT36X36", 2), ("MULT18X18", 3), ("ALU", 5)].map(|(kind, count)| (kind.to_owned(), count));
    assert_eq!(count(&[("MULT36X36", 4), ("MULT*", 1)], &cells.into()), 11);
}

#[test]
fn multiplications_are_split_over_blocks_as_yosys_does() {
    for (family, operands, signed, expected) in [
        (Family::Ecp5, [18, 18], false, 1),
        (Family::Ecp5, [18, 18], true, 1),
        (Family::Ecp5, [20, 18], false, 2),
        // The single bit that is left over takes no block.
        (Family::Ecp5, [19, 18], false, 1),
        (Family::Ecp5, [20, 20], false, 4),
        (Family::Ecp5, [37, 9], false, 2),
        (Family::Ecp5, [17, 1], false, 0),
        (Family::Ice40, [16, 16], false, 1),
        (Family::Ice40, [6, 4], false, 0),
        (Family::Xc7, [25, 18], true, 1),
        (Family::Xc7, [24, 17], false, 1),
        (Family::Xc7, [25, 17], false, 2),
    ] {
        assert_eq!(family.dsp.multipliers(operands, signed), [expected; 2], "{family:?} {operands:?}");
    }
}

#[test]
fn memories_go_into_blocks_where_they_are_worth_it() {
    for (words, bits, expected) in
        [(1024, 18, 1), (1024, 24, 2), (512, 36, 1), (64, 12, 0), (128, 16, 0), (512, 5, 1), (128, 41, 2)]
    {
        assert_eq!(Family::Ecp5.bram.blocks(words, bits), expected, "{words} x {bits}");
    }
}
