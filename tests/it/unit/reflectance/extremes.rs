use brdfgen::reflectance::extremes::*;

#[test]
fn nothing_is_broken() {
    let reported = std::cell::Cell::new((0, 0));
    let found = measure(&|done, of| reported.set((done, of))).unwrap();
    assert_eq!(reported.get(), (found.len(), found.len()));
    let broken: Vec<String> = found
        .iter()
        .flat_map(|one| one.broken.iter().map(|what| format!("{}, {}: {what}", one.case, one.form)))
        .collect();
    assert!(broken.is_empty(), "{broken:#?}");
    // The bounds are reached: they are no larger than they must be.
    assert!(found.iter().any(|one| one.of_bound > 0.9 && one.case.contains("α = 0.001")), "{found:#?}");
    assert!(found.iter().all(|one| one.values > 0));
}
