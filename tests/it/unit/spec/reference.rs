#[test]
fn the_page_is_that_of_the_keys() {
    let kept = include_str!("../../../../docs/spec.md");
    assert!(brdfgen::spec::reference() == kept, "make it anew: cargo run --example spec");
}
