use brdfgen::verify::stability::conditioning::*;

#[test]
fn printed_forms_need_bits_that_grow_with_the_square_and_built_ones_do_not() {
    let all = measure(&[1.0, 1000.0]).unwrap();
    let [_, _, quadratic, cubic] = &all[..] else { panic!("{all:?}") };
    // DESIGN: about 31 and 35 bits for the printed cubic at n = 1000; a is 0.319 n^2.
    let [Some(low), Some(high)] = cubic.printed_bits else { panic!("{cubic:?}") };
    assert!((28..=33).contains(&low) && (32..=37).contains(&high), "{cubic:?}");
    assert!(cubic.condition > 3e5 && quadratic.condition < 1e4, "{cubic:?} {quadratic:?}");
    for built in [quadratic, cubic].map(|of| of.built_bits) {
        let [Some(low), Some(high)] = built else { panic!("{built:?}") };
        assert!((11..=15).contains(&low) && (15..=19).contains(&high), "{built:?}");
    }
    // The line x of n = 1 is the same in every form.
    assert!(all[..2].iter().all(|of| of.condition == 1.0));
}
