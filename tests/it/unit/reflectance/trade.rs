use brdfgen::reflectance::trade::*;

fn point(kib: f64, mean: f64) -> Point {
    Point {
        form: "half",
        images: 4,
        size: 8,
        texel: "sqrt:8".to_owned(),
        kib,
        mean,
        worst: mean - 5.0,
        worst_phi: 60.0,
        front: false,
    }
}

#[test]
fn the_cheapest_that_is_good_enough_is_chosen() {
    let points = [point(1.0, 30.0), point(2.0, 45.0), point(2.0, 44.0), point(9.0, 50.0)];
    let chosen = |kib, db| choose(&points, kib, db).map(|point| (point.kib, point.mean));
    assert_eq!(chosen(None, Some(40.0)), Some((2.0, 45.0)));
    assert_eq!(chosen(Some(5.0), None), Some((2.0, 45.0)));
    assert_eq!(chosen(None, None), Some((9.0, 50.0)));
    assert_eq!(chosen(Some(1.5), Some(40.0)), None);
    assert_eq!(chosen(Some(0.5), None), None);
    assert_eq!(points[0].name(), "half 4×8² sqrt:8");
}
