//! What rays of sight meet, which lights shine there, and the frames made of it, against geometry done by hand.

mod hits;
mod precision;

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
