//! What rays of sight meet, which lights shine there, and the frames made of it, against geometry done by hand.

use std::f64::consts::PI;
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};

use astro_float::{BigFloat, RoundingMode};
use brdfgen::core::sample::Vector;
use brdfgen::explore::Objective;
use brdfgen::scene::frame::{BACKGROUND, versine};
use brdfgen::scene::mesh::{Corner, Mesh};
use brdfgen::scene::{
    Budget, Camera, CoreConstraints, Difference, Frame, Light, LightKind, Object, Picture, Scene, Shape, Tracer,
};
use brdfgen::spec::{Material, Model, SpecFields};
use brdfgen::target::Family;

fn dot(a: Vector, b: Vector) -> f64 {
    (0..3).map(|axis| a[axis] * b[axis]).sum()
}

fn minus(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|axis| a[axis] - b[axis])
}

fn scaled(a: Vector, factor: f64) -> Vector {
    a.map(|component| component * factor)
}

fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

fn unit(a: Vector) -> Vector {
    scaled(a, 1.0 / length(a))
}

fn sphere(centre: Vector, radius: f64) -> Shape {
    Shape::Sphere { centre, radius }
}

fn plane(point: Vector, normal: Vector) -> Shape {
    Shape::Plane { point, normal }
}

/// A camera at `(0, 0, 5)` that looks at the origin, one white light from its direction, one material an object.
fn scene(shapes: Vec<Shape>) -> Scene {
    let material = |place: usize| Material {
        name: format!("m{place}"),
        shininess: 10.0,
        ambient: Some(0.1),
        diffuse: Some(0.5),
        specular: Some(0.4),
        colour: Some([1.0, 0.5, 0.25]),
        ..Material::default()
    };
    Scene {
        name: "test".to_owned(),
        model: Model::Blinn,
        width: 64,
        height: 64,
        channel_bits: 8,
        ambient: [1.0, 0.5, 0.25],
        background: [0.2, 0.3, 0.4],
        camera: Camera { position: [0.0, 0.0, 5.0], target: [0.0; 3], up: [0.0, 1.0, 0.0], field_of_view: 40.0 },
        materials: (0..shapes.len()).map(|place| material(place).with_surface()).collect(),
        reflectances: vec![None; shapes.len()],
        left_out: Vec::new(),
        lights: vec![Light { kind: LightKind::Directional([0.0, 0.0, 1.0]), colour: [1.0; 3] }],
        objects: shapes.into_iter().enumerate().map(|(material, shape)| Object { shape, material }).collect(),
        shadows: true,
        budget: Budget { max_steps: Some(1), min_psnr: None },
        has_budget: false,
        core: CoreConstraints {
            family: Family::Ecp5,
            min_mhz: None,
            objective: Objective::Lut,
            keys: SpecFields::default(),
        },
    }
}

/// A sphere of triangles: rings of latitude, their poles along y; with the normals of the sphere.
fn globe(centre: Vector, radius: f64, rings: u32) -> Mesh {
    let around = 2 * rings;
    let mut normals = vec![[0.0, 1.0, 0.0]];
    for ring in 1..rings {
        let (r, y) = (PI * f64::from(ring) / f64::from(rings)).sin_cos();
        for step in 0..around {
            let (s, c) = (2.0 * PI * f64::from(step) / f64::from(around)).sin_cos();
            normals.push([r * s, y, r * c]);
        }
    }
    normals.push([0.0, -1.0, 0.0]);
    let place = |ring: u32, step: u32| match ring {
        0 => 0,
        _ if ring == rings => normals.len() as u32 - 1,
        _ => 1 + (ring - 1) * around + step % around,
    };
    let corner = |place: u32| Corner { position: place, normal: place };
    let mut triangles = Vec::new();
    for ring in 0..rings {
        for step in 0..around {
            let [a, b] = [step, step + 1].map(|step| place(ring, step));
            let [c, d] = [step, step + 1].map(|step| place(ring + 1, step));
            if ring > 0 {
                triangles.push([a, c, b].map(corner));
            }
            if ring + 1 < rings {
                triangles.push([b, c, d].map(corner));
            }
        }
    }
    let positions = normals.iter().map(|n| [0, 1, 2].map(|axis| centre[axis] + radius * n[axis])).collect();
    Mesh { positions, normals, triangles, ..Mesh::default() }
}

/// A square from -1 to 1 in x and y at z = 0, of two triangles whose normals are z.
fn square() -> Mesh {
    let corners = [[0, 1, 2], [0, 2, 3]];
    Mesh {
        positions: vec![[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]],
        normals: vec![[0.0, 0.0, 1.0]],
        triangles: corners.map(|corners| corners.map(|position| Corner { position, normal: 0 })).to_vec(),
        ..Mesh::default()
    }
}

fn mesh(mesh: Mesh) -> Shape {
    Shape::Mesh(Arc::new(mesh))
}

fn render(scene: &Scene) -> Frame {
    Frame::render(scene, &|| ())
}

/// Frames compared bit by bit, since a NaN is not equal to itself.
#[track_caller]
fn assert_same(a: &Frame, b: &Frame) {
    assert_eq!((a.width, a.height, a.lights), (b.width, b.height, b.lights));
    assert!(a.material == b.material, "materials");
    assert!(a.base == b.base, "base colours");
    let bits = |frame: &Frame| frame.versine.iter().map(|u| u.to_bits()).collect::<Vec<_>>();
    assert!(bits(a) == bits(b), "versines");
}

/// Directions all over the sphere.
fn directions(count: u32) -> impl Iterator<Item = Vector> {
    let golden = PI * (3.0 - 5f64.sqrt());
    (0..count).map(move |i| {
        let y = 1.0 - (2.0 * f64::from(i) + 1.0) / f64::from(count);
        let (s, c) = (golden * f64::from(i)).sin_cos();
        let r = (1.0 - y * y).sqrt();
        [r * s, y, r * c]
    })
}

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
