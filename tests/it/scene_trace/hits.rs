//! What a ray meets, seen in the picture.

use super::*;

#[test]
fn a_sphere_is_met_where_it_is() {
    for (centre, radius) in [([0.0; 3], 1.0), ([0.3, -0.2, 0.7], 0.25), ([3.0, 4.0, -12.0], 9.0)] {
        let tracer = Tracer::new(&scene(vec![sphere(centre, radius)]));
        for eye in [[0.0, 0.0, 30.0], [17.0, -5.0, 8.0]] {
            let mut met = 0;
            for normal in directions(500) {
                let place = [0, 1, 2].map(|axis| centre[axis] + radius * normal[axis]);
                let viewer = unit(minus(eye, place));
                if dot(normal, viewer) < 0.1 {
                    continue;
                }
                let hit = tracer.hit(eye, minus(place, eye)).unwrap();
                assert!(length(minus(hit.position, place)) < 1e-12, "{:?} {place:?}", hit.position);
                assert!(length(minus(hit.normal, normal)) < 1e-12 && hit.facet == hit.normal);
                assert!(length(minus(hit.viewer, viewer)) < 1e-12);
                assert!((hit.distance - length(minus(eye, place))).abs() < 1e-12);
                met += 1;
            }
            assert!(met > 100);
        }
    }
}

#[test]
fn from_inside_a_sphere_is_lit_inside() {
    let tracer = Tracer::new(&scene(vec![sphere([1.0, 0.0, 0.0], 2.0)]));
    for direction in directions(200) {
        let hit = tracer.hit([0.5, 0.2, -0.3], direction).unwrap();
        assert!((length(minus(hit.position, [1.0, 0.0, 0.0])) - 2.0).abs() < 1e-14);
        assert!(dot(hit.normal, hit.viewer) > 0.0 && dot(hit.normal, minus([1.0, 0.0, 0.0], hit.position)) > 1.99);
    }
}

/// The outline of a sphere around the axis of view is a circle with the angle `asin(r / d)`.
#[test]
fn the_outline_of_a_sphere_has_its_area() {
    let mut scene = scene(vec![sphere([0.0; 3], 1.0)]).resized(1200, 800);
    scene.camera.up = [0.3, 1.0, 0.2];
    let seen = render(&scene).material.iter().filter(|&&material| material == 0).count();
    let radius = (0.2f64).asin().tan() * 800.0 / (2.0 * 20f64.to_radians().tan());
    let area = PI * radius * radius;
    assert!((seen as f64 - area).abs() < 1e-3 * area, "{seen} {area}");
}

#[test]
fn a_plane_reaches_to_the_horizon() {
    let mut flat = scene(vec![plane([0.0, -1.0, 0.0], [0.0, 1.0, 0.0])]).resized(7, 100);
    let frame = render(&flat);
    for (pixel, &material) in frame.material.iter().enumerate() {
        assert_eq!(material == 0, pixel / 7 >= 50, "row {}", pixel / 7);
    }
    // The middle row of an odd number runs along the plane and meets nothing.
    flat.height = 101;
    let frame = render(&flat);
    assert!(frame.material[50 * 7..51 * 7].iter().all(|&material| material == BACKGROUND));
    assert!(frame.material[51 * 7..].iter().all(|&material| material == 0));
    assert!(frame.base[..51 * 7].iter().all(|&base| base == flat.background));
    // One step below the horizon, it is met at `1 / tan`, far out and without an error that counts.
    let hit = &Tracer::new(&flat).row(&flat, 51)[3].unwrap();
    let tangent = 20f64.to_radians().tan() * 2.0 / 101.0;
    assert!((hit.position[2] - (5.0 - 1.0 / tangent)).abs() < 1e-12 / tangent && (hit.position[1] + 1.0).abs() < 1e-14);
}

/// Both sides of planes and open meshes are lit as seen: the light in front of one side is behind the other.
#[test]
fn planes_and_open_meshes_have_two_sides() {
    for shape in [plane([0.0; 3], [0.0, 0.0, 1.0]), mesh(square())] {
        let mut scene = scene(vec![shape]).resized(3, 3);
        scene.camera.field_of_view = 10.0;
        for side in [1.0, -1.0] {
            scene.camera.position[2] = 5.0 * side;
            let hit = Tracer::new(&scene).row(&scene, 1)[1].unwrap();
            assert_eq!((hit.normal, hit.facet), ([0.0, 0.0, side], [0.0, 0.0, side]));
            let frame = render(&scene);
            for pixel in 0..9 {
                assert_eq!(frame.material[pixel], 0);
                assert_eq!(frame.versine[pixel].is_nan(), side < 0.0);
                let diffuse = if side > 0.0 { 0.5 } else { 0.0 };
                let base = [1.0, 0.25, 0.0625].map(|ambient| 0.1 * ambient);
                let lit = [1.0, 0.5, 0.25].map(|colour| diffuse * colour);
                for c in 0..3 {
                    assert!((frame.base[pixel][c] - base[c] - lit[c]).abs() < 1e-15);
                }
            }
        }
    }
}

/// The directions to light and viewer, and the light colour that falls on a tilted plane, by hand.
#[test]
fn a_lit_plane_by_hand() {
    let mut scene = scene(vec![plane([0.0; 3], [0.0, 0.0, 1.0])]).resized(1, 1);
    // Seen at 30 degrees from the normal, lit at 60 on the other side and by a point light straight above.
    let tilt = |degrees: f64| [degrees.to_radians().sin(), 0.0, degrees.to_radians().cos()];
    scene.camera.position = scaled(tilt(-30.0), 4.0);
    scene.lights = vec![
        Light { kind: LightKind::Directional(tilt(60.0)), colour: [0.5, 0.25, 0.0] },
        Light { kind: LightKind::Point([0.0, 0.0, 7.0]), colour: [0.0, 0.0, 0.5] },
    ];
    let one_minus_cos = |degrees: f64| 1.0 - degrees.to_radians().cos();
    // Both mirrored lights are 30 degrees from the viewer, both half vectors 15 from the normal.
    for (model, expected) in [(Model::Phong, 30.0), (Model::Blinn, 15.0)] {
        scene.model = model;
        let frame = render(&scene);
        assert!(frame.versine.iter().all(|u| (u - one_minus_cos(expected)).abs() < 1e-14));
        let base = [0.1 + 0.5 * 0.5 * 0.5, 0.1 * 0.25 + 0.25 * 0.25 * 0.5, 0.1 * 0.0625 + 0.125 * 0.5];
        assert!((0..3).all(|c| (frame.base[0][c] - base[c]).abs() < 1e-14), "{:?} {base:?}", frame.base[0]);
    }
}

/// The shadow of a sphere on a plane is a disc: as large as the sphere under a distant light, larger under a near one.
#[test]
fn shadows_are_where_they_should_be() {
    let mut scene = scene(vec![plane([0.0; 3], [0.0, 0.0, 1.0]), sphere([0.0, 0.0, 2.0], 0.5)]).resized(200, 200);
    scene.camera.position = [6.0, 0.0, 3.0];
    // From 6, the sphere's outline as seen from the light meets the plane at 6 tan(asin(0.5 / 4)).
    let radii = [0.5, 6.0 * (0.125f64).asin().tan()];
    scene.lights.push(Light { kind: LightKind::Point([0.0, 0.0, 6.0]), colour: [1.0; 3] });
    for shadows in [true, false] {
        scene.shadows = shadows;
        let tracer = Tracer::new(&scene);
        let mut dark = [0, 0];
        for y in 0..scene.height {
            for hit in tracer.row(&scene, y).into_iter().flatten().filter(|hit| hit.material == 0) {
                let from_middle = length([hit.position[0], hit.position[1], 0.0]);
                for light in 0..2 {
                    let lit = tracer.light(&scene, &hit, light);
                    assert_eq!(lit.visible, !shadows || from_middle > radii[light], "{from_middle}");
                    dark[light] += u32::from(!lit.visible);
                }
            }
        }
        assert_eq!(shadows, dark[0] > 100 && dark[1] > dark[0] + 100, "{dark:?}");
    }
}

/// Nothing behind a point light throws a shadow, and no surface on itself: not a plane to the horizon, not a sphere,
/// not a mesh.
#[test]
fn no_shadow_without_a_thing_in_between() {
    let shapes = [
        plane([0.0, -1.0, 0.0], [0.0, 1.0, 0.0]),
        sphere([0.0; 3], 1.0),
        mesh(globe([0.0; 3], 1.0, 40)),
        mesh(square()),
    ];
    for shape in shapes {
        let mut scene = scene(vec![shape]).resized(150, 150);
        scene.camera.position = [1.0, 2.0, 4.0];
        scene.lights = vec![
            Light { kind: LightKind::Directional(unit([-0.5, 0.6, 0.8])), colour: [1.0; 3] },
            Light { kind: LightKind::Point([1.5, 1.0, 1.5]), colour: [1.0; 3] },
        ];
        let tracer = Tracer::new(&scene);
        let mut seen = 0;
        for y in 0..scene.height {
            for hit in tracer.row(&scene, y).into_iter().flatten() {
                for light in 0..2 {
                    let lit = tracer.light(&scene, &hit, light);
                    assert_eq!(lit.visible, lit.cosine > 0.0, "{hit:?} {lit:?}");
                    seen += u32::from(lit.visible);
                }
            }
        }
        assert!(seen > 1000);
    }
}

/// On a coarse mesh with smooth normals, facets do not cut the light off before the normals do.
#[test]
fn the_terminator_of_a_coarse_mesh_is_smooth() {
    for rings in [4, 7, 12] {
        let mut scene = scene(vec![mesh(globe([0.0; 3], 1.0, rings))]).resized(200, 200);
        scene.lights[0].kind = LightKind::Directional(unit([1.0, 0.3, 0.1]));
        let tracer = Tracer::new(&scene);
        let (mut cut, mut behind, mut lit_pixels) = (0, 0, 0);
        for y in 0..scene.height {
            for hit in tracer.row(&scene, y).into_iter().flatten() {
                let lit = tracer.light(&scene, &hit, 0);
                cut += u32::from(lit.cosine > 0.0 && !lit.visible);
                behind += u32::from(lit.visible && dot(hit.facet, lit.direction) < 0.0);
                lit_pixels += u32::from(lit.visible);
            }
        }
        // There are facets turned away from the light whose normals are not: these are what is at stake.
        assert!(behind > 100, "{rings}: {behind}");
        assert!(cut * 200 <= lit_pixels, "{rings}: {cut} of {lit_pixels}");
    }
}

#[test]
fn a_light_at_the_surface_gives_no_light() {
    for shape in [plane([0.0; 3], [0.0, 0.0, 1.0]), mesh(square()), sphere([0.0, 0.0, -1.0], 1.0)] {
        for shadows in [true, false] {
            let mut scene = scene(vec![shape.clone()]).resized(1, 1);
            scene.shadows = shadows;
            scene.lights[0].kind = LightKind::Point([0.0; 3]);
            let frame = render(&scene);
            assert!(frame.versine[0].is_nan());
            assert!((frame.base[0][0] - 0.1).abs() < 1e-15);
            // A little above, it shines.
            scene.lights[0].kind = LightKind::Point([0.0, 0.0, 1e-6]);
            assert!(render(&scene).versine[0] < 1e-9);
        }
    }
}

/// A sphere of many triangles looks like the sphere.
#[test]
fn a_tessellated_sphere_is_nearly_the_sphere() {
    let of = |shape: Shape| {
        let mut scene = scene(vec![shape]).resized(150, 150);
        scene.model = Model::Phong;
        scene.lights[0].kind = LightKind::Directional(unit([0.4, 0.3, 0.8]));
        render(&scene)
    };
    let (exact, near) = (of(sphere([0.1, 0.2, 0.3], 1.0)), of(mesh(globe([0.1, 0.2, 0.3], 1.0, 150))));
    let outline = exact.material.iter().zip(&near.material).filter(|(a, b)| a != b).count();
    assert!(outline <= 8, "{outline}");
    let (mut compared, mut differ) = (0, 0);
    for pixel in 0..exact.material.len() {
        if exact.material[pixel] == BACKGROUND || near.material[pixel] == BACKGROUND {
            continue;
        }
        assert!((0..3).all(|c| (exact.base[pixel][c] - near.base[pixel][c]).abs() < 5e-3));
        let (a, b) = (exact.versine[pixel], near.versine[pixel]);
        differ += u32::from(a.is_nan() != b.is_nan());
        if a < 0.5 {
            assert!((a - b).abs() < 1e-3, "{a} {b}");
            compared += 1;
        }
    }
    assert!(compared > 1500 && differ <= 10, "{compared} {differ}");
}

/// From inside a closed mesh no pixel shows the background, wherever rays pass along edges and through corners.
#[test]
fn closed_meshes_have_no_cracks() {
    for (centre, radius) in [([0.0; 3], 1.0), ([1e6, -3e5, 7e5], 1.0), ([0.0; 3], 1e-7), ([0.1, 0.2, 0.3], 1e9)] {
        let ball = globe(centre, radius, 16);
        let closed = scene(vec![mesh(ball.clone())]);
        let tracer = Tracer::new(&closed);
        let mut tried = 0;
        for inside in [[0.0; 3], [0.1, 0.2, -0.3], [0.0, 0.7, 0.0], [-0.5, 0.0, 0.5]] {
            let eye = [0, 1, 2].map(|axis| centre[axis] + radius * inside[axis]);
            let mut look = |at: Vector| {
                assert!(tracer.hit(eye, minus(at, eye)).is_some(), "{centre:?} {radius} {eye:?} {at:?}");
                tried += 1;
            };
            for triangle in &ball.triangles {
                let [a, b, c] = triangle.map(|corner| ball.positions[corner.position as usize]);
                for weights in [[1.0, 0.0, 0.0], [0.5, 0.5, 0.0], [0.3, 0.0, 0.7], [0.0, 1.0 / 3.0, 2.0 / 3.0]] {
                    look([0, 1, 2].map(|k| weights[0] * a[k] + weights[1] * b[k] + weights[2] * c[k]));
                }
            }
            for direction in directions(3000) {
                look([0, 1, 2].map(|axis| eye[axis] + radius * direction[axis]));
            }
            for axis in 0..3 {
                for sign in [1.0, -1.0] {
                    let mut at = eye;
                    at[axis] += sign * radius;
                    look(at);
                }
            }
        }
        assert!(tried > 10_000);
    }
}
