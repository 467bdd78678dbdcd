use brdfgen::lobe::*;

#[test]
fn angles_and_versines() {
    assert!((degrees(1.0) - 90.0).abs() < 1e-12 && (versine(60.0) - 0.5).abs() < 1e-15);
    assert!((degrees(versine(0.001)) - 0.001).abs() < 1e-15);
}
