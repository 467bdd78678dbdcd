use brdfgen::fixed::*;
use proptest::prelude::*;

#[test]
fn ranges_and_names() {
    let cosine = Format::signed(1, 16);
    assert_eq!((cosine.width(), cosine.min_code(), cosine.max_code()), (18, -(1 << 17), (1 << 17) - 1));
    assert_eq!(cosine.to_string(), "Q1.16");
    assert_eq!(Format::unsigned(-1, 19).width(), 18);
    assert_eq!(Format::unsigned(3, -1).value(3), 6.0);
    assert_eq!(Format::FLAG.max_code(), 1);
    // What has no bits is 0; what is too wide has the ends of the type.
    let none = Format::unsigned(-3, 3);
    assert_eq!((none.width(), none.min_code(), none.max_code(), none.wrap(5), none.bits(5)), (0, 0, 0, 0, 0));
    let widest = Format::signed(100, 26);
    assert_eq!((widest.min_code(), widest.max_code()), (-(1 << 126), (1 << 126) - 1));
    for code in [widest.min_code(), -1, 0, widest.max_code()] {
        assert_eq!(widest.wrap(code), code);
    }
    assert_eq!(widest.wrap(widest.max_code() + 1), widest.min_code());
    let too_wide = Format::signed(200, 26);
    assert_eq!((too_wide.min_code(), too_wide.max_code(), too_wide.wrap(-7)), (i128::MIN, i128::MAX, -7));
}

proptest! {
    #[test]
    fn wrap_keeps_codes_that_fit(low in -5000i128..5000, span in 0i128..5000, frac in -3i32..20) {
        let format = Format::holding(low, low + span, frac);
        for code in [low, low + span] {
            prop_assert_eq!(format.wrap(code), code);
            prop_assert_eq!(format.wrap(code + (1 << format.width())), code);
            prop_assert!(format.min_code() <= code && code <= format.max_code());
        }
        // One bit less would lose one of the two ends.
        let narrower = Format { int_bits: format.int_bits - 1, ..format };
        if format.width() > 1 + u32::from(format.signed) {
            prop_assert!(narrower.wrap(low) != low || narrower.wrap(low + span) != low + span);
        }
    }
}
