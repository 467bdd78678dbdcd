use brdfgen::fixed::wide::*;
use proptest::prelude::*;

proptest! {
    #[test]
    fn products_are_floored(a in -(1i128 << 40)..(1i128 << 40), b in -(1i128 << 40)..(1i128 << 40), f in 0u32..40) {
        let product = from_code(a, 40) * from_code(b, 40);
        prop_assert_eq!(to_code(product, f), (a * b) >> (80 - f));
        prop_assert_eq!(floor_to(product, f), from_code((a * b) >> (80 - f), f));
    }
}
