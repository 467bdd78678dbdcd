use brdfgen::fixed::exp2;
use brdfgen::lobe::exact;
use brdfgen::verify::stability::quantisation::*;

#[test]
fn rounding_the_cosine_costs_what_the_design_says() {
    // 2^-8 at n = 1000 takes 17 fraction bits, 2^-12 takes 21.
    assert!(of_cosine(1000.0, 16) > exp2(-8) && of_cosine(1000.0, 17) < exp2(-8));
    assert!(of_cosine(1000.0, 20) > exp2(-12) && of_cosine(1000.0, 21) < exp2(-12));
    // The move at the top is the largest of all.
    for n in [1.0, 1.5, 1000.0] {
        let step = exp2(-10);
        let moves = (0..1024).map(|code| {
            let u = f64::from(code) * step;
            exact(n, u) - exact(n, (u + 0.5 * step).min(1.0))
        });
        assert!(moves.fold(0.0, f64::max) <= of_cosine(n, 10) + 1e-15, "{n}");
    }
}

#[test]
fn the_versine_saves_most_of_what_the_cosine_loses() {
    let sharp = front_end(1000.0, 14);
    assert!(sharp.versine * 8.0 < sharp.cosine, "{sharp:?}");
    assert_eq!(sharp, front_end(1000.0, 14));
}
