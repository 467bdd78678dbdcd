//! Versines near the highlight, scale, threads, and what is degenerate.

use super::*;

/// `1 - cos` of the angle between two vectors, with 300 bits.
fn one_minus_cos(a: Vector, b: Vector) -> f64 {
    const BITS: usize = 320;
    let (m, big) = (RoundingMode::ToEven, |x: f64| BigFloat::from_f64(x, BITS));
    let product =
        |a: Vector, b: Vector| (0..3).fold(big(0.0), |sum, k| sum.add(&big(a[k]).mul(&big(b[k]), BITS, m), BITS, m));
    let lengths = product(a, a).mul(&product(b, b), BITS, m).sqrt(BITS, m);
    let u = big(1.0).sub(&product(a, b).div(&lengths, BITS, m), BITS, m);
    u.to_string().parse().unwrap()
}

#[test]
fn versines_keep_their_digits_near_the_highlight() {
    for (count, normal) in directions(40).enumerate() {
        for angle in [1e-4f64, 1.4e-4, 3e-3, 0.2, 1.2] {
            let aside = unit([normal[1] - normal[2], normal[2] - normal[0], normal[0] - normal[1]]);
            let turn = |angle: f64| unit([0, 1, 2].map(|k| normal[k] * angle.cos() + aside[k] * angle.sin()));
            let half = turn(angle);
            let exact = one_minus_cos(normal, half);
            let u = versine(Model::Blinn, normal, normal, normal, half);
            assert!((u / exact - 1.0).abs() < 1e-10, "{count} {angle}: {u} {exact}");
            // Light and viewer on both sides of the normal; N is turned by half the angle between R and V.
            let (light, viewer) = (turn(0.3), turn(-0.3 + angle));
            // R = 2 (N.L) N - L, whose components in doubles are off by 1e-16: so is the direction that they stand for.
            let mirrored = [0, 1, 2].map(|k| 2.0 * dot(normal, light) * normal[k] - light[k]);
            let exact = one_minus_cos(mirrored, viewer);
            let u = versine(Model::Phong, normal, viewer, light, half);
            assert!((u / exact - 1.0).abs() < 1e-10, "{count} {angle}: {u} {exact}");
            assert!((u - (1.0 - angle.cos())).abs() < 1e-12 * angle + 1e-15);
        }
    }
    // The ends of the range.
    let (z, down) = ([0.0, 0.0, 1.0], [0.0, 0.0, -1.0]);
    assert_eq!(versine(Model::Blinn, z, z, z, z), 0.0);
    assert_eq!(versine(Model::Phong, z, down, z, z), 2.0);
}

/// The number of threads decides nothing, and `done` is called once a row.
#[test]
fn frames_do_not_depend_on_threads() {
    let shapes = vec![
        mesh(globe([0.0, 0.5, 0.0], 1.0, 20)),
        plane([0.0, -1.0, 0.0], [0.0, 1.0, 0.0]),
        sphere([1.0, 0.0, 1.0], 0.4),
    ];
    let mut scene = scene(shapes).resized(97, 61);
    scene.lights.push(Light { kind: LightKind::Point([3.0, 3.0, 3.0]), colour: [0.5; 3] });
    let rows = AtomicU32::new(0);
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| Frame::render(&scene, &|| _ = rows.fetch_add(1, Ordering::Relaxed)))
    };
    let (one, two) = (with(1), with(2));
    assert_same(&one, &two);
    assert_eq!(rows.into_inner(), 2 * 61);
    // All three objects, and lit as well as dark samples, are in it.
    assert!((0..3).all(|material| one.material.contains(&material)));
    assert!(one.versine.iter().filter(|u| u.is_nan()).count() > 1000);
    assert!(one.versine.iter().all(|u| u.is_nan() || (0.0..=2.0).contains(u)));
}

#[test]
fn pictures_of_one_pixel() {
    let frame = render(&scene(vec![sphere([0.0; 3], 1.0)]).resized(1, 1));
    assert_eq!((frame.material.as_slice(), frame.versine.as_slice()), (&[0][..], &[0.0][..]));
    let wide = render(&scene(vec![sphere([0.0; 3], 1.0)]).resized(1001, 1));
    let seen: Vec<usize> = (0..1001).filter(|&x| wide.material[x] != BACKGROUND).collect();
    assert_eq!((wide.material.len(), seen), (1001, vec![500]));
}

fn grown(scene: &Scene, factor: f64) -> Scene {
    let mut scene = scene.clone();
    let grow = |v: &mut Vector| *v = scaled(*v, factor);
    grow(&mut scene.camera.position);
    grow(&mut scene.camera.target);
    for light in &mut scene.lights {
        if let LightKind::Point(place) = &mut light.kind {
            grow(place);
        }
    }
    for object in &mut scene.objects {
        match &mut object.shape {
            Shape::Sphere { centre, radius } => {
                grow(centre);
                *radius *= factor;
            }
            Shape::Plane { point, .. } => grow(point),
            Shape::Mesh(mesh) => Arc::make_mut(mesh).positions.iter_mut().for_each(grow),
        }
    }
    scene
}

/// A scene in nanometres is the scene in gigametres: tolerances are relative. By powers of two, bit by bit.
#[test]
fn scenes_look_the_same_at_any_scale() {
    let shapes = vec![
        mesh(globe([0.0, 0.5, 0.0], 1.0, 20)),
        plane([0.0, -1.0, 0.0], [0.0, 1.0, 0.0]),
        sphere([1.0, 0.0, 1.0], 0.4),
    ];
    let mut scene = scene(shapes).resized(90, 60);
    scene.lights = vec![
        Light { kind: LightKind::Point([3.0, 3.0, 3.0]), colour: [0.5; 3] },
        Light { kind: LightKind::Directional(unit([-1.0, 1.0, 0.5])), colour: [0.5; 3] },
    ];
    let frame = render(&scene);
    for exponent in [30, -30, 300, -300] {
        assert_same(&frame, &render(&grown(&scene, 2f64.powi(exponent))));
    }
    for factor in [1e9, 1e-9] {
        let other = render(&grown(&scene, factor));
        let differ = frame.material.iter().zip(&other.material).filter(|(a, b)| a != b).count();
        let far = |(a, b): &(&f64, &f64)| {
            if a.is_nan() || b.is_nan() { a.is_nan() != b.is_nan() } else { (*a - *b).abs() > 1e-9 }
        };
        let samples = frame.versine.iter().zip(&other.versine).filter(far).count();
        assert!(differ <= 2 && samples <= 4, "{factor}: {differ} {samples}");
    }
}

/// What lies at the same place is decided by the order in the scene.
#[test]
fn of_equal_surfaces_the_first_is_seen() {
    for shape in [mesh(square()), plane([0.0; 3], [0.0, 0.0, 1.0]), sphere([0.0; 3], 2.0)] {
        let mut scene = scene(vec![shape; 3]).resized(31, 31);
        scene.camera.field_of_view = 10.0;
        scene.camera.position = [0.3, 0.4, 5.0];
        assert!(render(&scene).material.iter().all(|&material| material == 0));
        scene.objects.rotate_left(1);
        assert!(render(&scene).material.iter().all(|&material| material == 1));
    }
}

#[test]
fn moved_scenes_are_moved_by_the_margin() {
    let mut scene = scene(vec![sphere([0.0; 3], 1.0)]);
    scene.camera.position = [3.0, 2.0, 5.0];
    scene.camera.target = [1.0, -1.0, 0.5];
    scene.lights.push(Light { kind: LightKind::Point([4.0, 1.0, -2.0]), colour: [0.5; 3] });
    scene.lights.push(Light { kind: LightKind::Point(scene.camera.target), colour: [0.5; 3] });
    assert!(scene.moved(0.0).is_empty());
    let moved = scene.moved(5.0);
    let names: Vec<&str> = moved.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names[..4], ["camera up", "camera down", "camera left", "camera right"]);
    assert_eq!(
        names[8..],
        [
            "light 1 up",
            "light 1 down",
            "light 1 left",
            "light 1 right",
            "light 2 up",
            "light 2 down",
            "light 2 left",
            "light 2 right"
        ]
    );
    let target = scene.camera.target;
    let angle = |a: Vector, b: Vector| one_minus_cos(a, b);
    let margin = 1.0 - 5f64.to_radians().cos();
    let [right, up, ahead] = scene.camera.axes();
    for (name, other) in &moved {
        if name.starts_with("camera") {
            let (before, after) = (minus(scene.camera.position, target), minus(other.camera.position, target));
            assert!((angle(before, after) - margin).abs() < 1e-14, "{name}");
            assert!((length(before) - length(after)).abs() < 1e-14);
            let way = minus(after, before);
            assert_eq!(dot(way, up) > 0.1, name.contains("up"), "{name}");
            assert_eq!(dot(way, up) < -0.1, name.contains("down"), "{name}");
            assert_eq!(dot(way, right) > 0.1, name.contains("right"), "{name}");
            assert_eq!(dot(way, right) < -0.1, name.contains("left"), "{name}");
            // It turns as a rigid body: its axes turn by no more than it does.
            for (a, b) in scene.camera.axes().into_iter().zip(other.camera.axes()) {
                assert!(angle(a, b) < margin + 1e-14, "{name}");
            }
            assert_eq!(scene.lights, other.lights);
        } else {
            assert_eq!(scene.camera, other.camera);
            let changed: Vec<usize> = (0..3).filter(|&light| scene.lights[light] != other.lights[light]).collect();
            assert_eq!(changed, [name[6..7].parse::<usize>().unwrap() - 1]);
            let way = |light: Light| match light.kind {
                LightKind::Directional(direction) => direction,
                LightKind::Point(place) => minus(place, target),
            };
            let (before, after) = (way(scene.lights[changed[0]]), way(other.lights[changed[0]]));
            assert!((angle(before, after) - margin).abs() < 1e-14 && (length(before) - length(after)).abs() < 1e-14);
            assert_eq!(dot(minus(after, before), up) > 0.05, name.ends_with("up"), "{name}");
        }
    }
    assert!(dot(ahead, right).abs() < 1e-15 && dot(up, right).abs() < 1e-15 && (length(up) - 1.0).abs() < 1e-15);
}

/// Where interpolation turns N away from the viewer, the formulas are used as they are; opposite directions have no
/// half vector, and give the cosine 0.
#[test]
fn normals_turned_away_from_the_viewer() {
    let tilted = Mesh { normals: vec![[0.8, 0.0, 0.6]], ..square() };
    let mut scene = scene(vec![mesh(tilted)]).resized(1, 1);
    scene.shadows = false;
    scene.camera.position = [-4.0, 0.0, 2.0];
    let viewer = unit(scene.camera.position);
    let hit = Tracer::new(&scene).row(&scene, 0)[0].unwrap();
    assert!(length(minus(hit.normal, [0.8, 0.0, 0.6])) < 1e-15 && hit.facet == [0.0, 0.0, 1.0]);
    assert!(dot(hit.normal, hit.viewer) < -0.4);
    for model in [Model::Blinn, Model::Phong] {
        scene.model = model;
        scene.lights[0].kind = LightKind::Directional([0.8, 0.0, 0.6]);
        let cosine = dot(hit.normal, viewer);
        let expected = match model {
            Model::Blinn => 1.0 - ((1.0 + cosine) / 2.0).sqrt(),
            Model::Phong => 1.0 - cosine,
        };
        assert!((render(&scene).versine[0] - expected).abs() < 1e-14);
        // The light on the other side of the eye's ray.
        scene.lights[0].kind = LightKind::Directional(scaled(viewer, -1.0));
        let opposite = render(&scene).versine[0];
        let expected = if model == Model::Blinn { 1.0 } else { 2.0 * cosine * cosine };
        assert!((opposite - expected).abs() < 1e-14, "{opposite} {expected}");
    }
}

/// Meshes of which nothing can be seen: without triangles, all in one point, all on a line.
#[test]
fn meshes_without_area_are_not_seen() {
    let flat = |corner: fn(usize) -> Vector| Mesh {
        positions: (0..30).map(corner).collect(),
        normals: vec![[0.0, 0.0, 1.0]],
        triangles: (0..10)
            .map(|t| [3 * t, 3 * t + 1, 3 * t + 2].map(|position| Corner { position, normal: 0 }))
            .collect(),
        ..Mesh::default()
    };
    let empty = Mesh::default();
    for mesh_of in
        [empty, flat(|_| [0.0; 3]), flat(|k| [k as f64 / 15.0 - 1.0, 0.0, 0.0]), flat(|k| [k as f64 / 15.0 - 1.0; 3])]
    {
        let frame = render(&scene(vec![mesh(mesh_of)]).resized(33, 33));
        assert!(frame.material.iter().all(|&material| material == BACKGROUND));
        assert!(frame.versine.iter().all(|u| u.is_nan()) && frame.base.iter().all(|&base| base == [0.2, 0.3, 0.4]));
    }
}

#[test]
fn a_million_triangles() {
    let ball = globe([0.0; 3], 1.0, 501);
    assert!(ball.triangles.len() > 1_000_000);
    let frame = render(&scene(vec![mesh(ball), sphere([0.0; 3], 0.999)]));
    assert!(frame.material.contains(&BACKGROUND) && !frame.material.contains(&1));
    assert!((frame.material.iter().filter(|&&m| m == 0).count() as f64 / 64.0 / 64.0 - 0.246).abs() < 0.01);
}

#[test]
fn differences_by_hand() {
    let picture = |codes: &[[u16; 3]]| Picture { width: 2, height: 2, channel_bits: 8, codes: codes.to_vec() };
    let exact = picture(&[[0, 0, 0], [255, 255, 255], [10, 20, 30], [7, 7, 7]]);
    let same = Difference::of(&exact, &exact.clone());
    assert_eq!((same.max_steps, same.mean_steps, same.pixels, same.psnr), (0, 0.0, vec![4], None));
    // Off by 1 and 2 up, by 3 down, by 4 twice: squares 1 + 4 + 9 + 16 + 16 = 46 over 12 channels.
    let other = picture(&[[1, 2, 0], [255, 252, 255], [10, 20, 30], [11, 7, 3]]);
    let difference = Difference::of(&exact, &other);
    assert_eq!(
        (difference.max_steps, &difference.pixels[..], &difference.steps[..]),
        (4, &[1, 0, 1, 1, 1][..], &[2, 3, 0, 4][..])
    );
    assert!((difference.mean_steps - 14.0 / 12.0).abs() < 1e-15);
    assert!((difference.psnr.unwrap() - 20.0 * (255.0 / (46.0f64 / 12.0).sqrt()).log10()).abs() < 1e-12);
    assert_eq!(Difference::of(&other, &exact), difference);
    // As far apart as 16 bits can be: no decibels are left.
    let deep = |code: u16| Picture { channel_bits: 16, ..picture(&[[code; 3]; 4]) };
    let far = Difference::of(&deep(0), &deep(u16::MAX));
    assert_eq!((far.max_steps, far.mean_steps, far.psnr), (u16::MAX, 65535.0, Some(0.0)));
    assert_eq!((far.pixels.len(), far.pixels[65535]), (65536, 4));
}
