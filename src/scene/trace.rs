//! What a ray of sight meets in a scene, and which lights shine there.
//!
//! Spheres and triangles sit in one bounding volume hierarchy, built by the crate `bvh`; planes, which have no bounds,
//! are tried one by one. All tolerances grow with the coordinates, so that a scene looks the same at any scale.

use std::cmp::Ordering;
use std::sync::Arc;

use bvh::aabb::{Aabb, Bounded};
use bvh::bounding_hierarchy::{BHShape, BoundingHierarchy};
use bvh::bvh::{Bvh, BvhNode};
use nalgebra::Point3;

use super::mesh::Mesh;
use super::ray::{ROUNDING, Ray, V, across, unit};
use super::{Camera, LightKind, Object, Scene, Shape};
use crate::core::sample::Vector;
use crate::fixed::exp2;

/// How far from the surface a ray of shadow begins, relative to the size of the scene.
const OFFSET: f64 = 1.0 / (1u64 << 36) as f64;

/// What a ray of sight meets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The place, P.
    pub position: Vector,
    /// N, of length 1: of a mesh interpolated between its corners (Phong 1975), with which a mesh looks smooth. It is
    /// on the side of [`Hit::facet`], so that planes, open meshes and spheres from inside are lit on the side that is
    /// seen.
    pub normal: Vector,
    /// The normal of the surface as it is, of length 1, turned to the viewer. On a mesh, where it differs from N, the
    /// angle between N and the viewer may exceed 90 degrees near the outline; N is left as it is then.
    pub facet: Vector,
    /// V, of length 1: the direction to the viewer.
    pub viewer: Vector,
    /// How far it is from the origin of the ray.
    pub distance: f64,
    /// The place of its material in [`Scene::materials`].
    pub material: usize,
    /// Where rays of shadow begin.
    start: V,
    /// How far that is from the surface at least.
    offset: f64,
}

/// A light as it is seen from a point of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lit {
    /// L, of length 1: the direction to it. N for a point light that lies at the very point.
    pub direction: Vector,
    /// H, of length 1: halfway between L and V (Blinn 1977); across N where L and V are opposite.
    pub half: Vector,
    /// N.L.
    pub cosine: f64,
    /// Whether it shines on the point: it is in front of the surface (`N.L > 0`), nothing is in between (looked at only
    /// where the scene has shadows), and it does not lie at the point itself.
    pub visible: bool,
}

/// The objects of a scene, made ready for rays.
///
/// It knows nothing of the camera and of the lights: scenes with the same objects may share it.
#[derive(Debug)]
pub struct Tracer {
    /// The planes: point, normal, object.
    planes: Vec<(V, V, u32)>,
    /// The spheres: centre, radius, object.
    spheres: Vec<(V, f64, u32)>,
    triangles: Vec<Triangle>,
    /// The mesh of each object that is one.
    meshes: Vec<Option<Arc<Mesh>>>,
    /// The material of each object.
    materials: Vec<usize>,
    nodes: Vec<Node>,
    root: Option<Child>,
    /// The largest extent of spheres and meshes along an axis.
    size: f64,
    /// Their largest coordinate.
    reach: f64,
}

#[derive(Clone, Copy, Debug)]
struct Triangle {
    corners: [V; 3],
    object: u32,
    /// Its place in the mesh.
    index: u32,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    /// The children's boxes: least and greatest corner.
    boxes: [[Vector; 2]; 2],
    children: [Child; 2],
}

#[derive(Clone, Copy, Debug)]
enum Child {
    Node(u32),
    /// A sphere, or with the number of spheres added a triangle.
    Item(u32),
}

/// A thing with a box, while the hierarchy is built.
struct Boxed {
    bounds: Aabb<f64, 3>,
    node: usize,
}

impl Bounded<f64, 3> for Boxed {
    fn aabb(&self) -> Aabb<f64, 3> {
        self.bounds
    }
}

impl BHShape<f64, 3> for Boxed {
    fn set_bh_node_index(&mut self, node: usize) {
        self.node = node;
    }

    fn bh_node_index(&self) -> usize {
        self.node
    }
}

/// What is met, so far.
#[derive(Clone, Copy, Debug)]
struct Found {
    t: f64,
    /// The object, and the place of the triangle: decides between things at the same distance.
    key: (u32, u32),
    on: On,
}

#[derive(Clone, Copy, Debug)]
enum On {
    Plane(V),
    Sphere(V, f64),
    /// The triangle and the weights of its corners.
    Triangle(usize, [f64; 3]),
}

impl Camera {
    /// The camera's axes, of length 1: to the right, up and ahead.
    #[must_use]
    pub fn axes(&self) -> [Vector; 3] {
        let ahead = unit(V::from(self.target) - V::from(self.position)).unwrap_or_else(|| -V::z());
        let right = unit(ahead.cross(&V::from(self.up))).unwrap_or_else(|| across(ahead));
        [right, right.cross(&ahead), ahead].map(V::into)
    }

    /// The directions, not of length 1, through the middles of the pixels of a row; row 0 is at the top.
    pub fn row(&self, width: u32, height: u32, row: u32) -> impl Iterator<Item = Vector> + use<> {
        let [right, up, ahead] = self.axes().map(V::from);
        let (width, height) = (f64::from(width), f64::from(height));
        let tangent = libm::tan(self.field_of_view.to_radians() / 2.0);
        let along = up * (tangent * (1.0 - (2.0 * f64::from(row) + 1.0) / height)) + ahead;
        (0..width as u32).map(move |x| (along + right * (tangent * (2.0 * f64::from(x) + 1.0 - width) / height)).into())
    }
}

impl Tracer {
    /// Makes the objects of a scene ready. All their numbers must be finite; squares of coordinates must neither
    /// overflow nor vanish, as they do beyond about `1e150` and within `1e-150`.
    ///
    /// # Panics
    /// On `2^31` triangles or more.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        Self::of(&scene.objects)
    }

    fn of(objects: &[Object]) -> Self {
        let mut tracer = Self {
            planes: Vec::new(),
            spheres: Vec::new(),
            triangles: Vec::new(),
            meshes: Vec::new(),
            materials: Vec::new(),
            nodes: Vec::new(),
            root: None,
            size: 0.0,
            reach: 0.0,
        };
        for (number, object) in objects.iter().enumerate() {
            let number = u32::try_from(number).expect("a scene's objects are few");
            tracer.materials.push(object.material);
            tracer.meshes.push(None);
            match &object.shape {
                Shape::Sphere { centre, radius } => tracer.spheres.push((V::from(*centre), *radius, number)),
                Shape::Plane { point, normal } => tracer.planes.push((V::from(*point), V::from(*normal), number)),
                Shape::Mesh(mesh) => {
                    let triangle = |(index, corners): (usize, &[super::mesh::Corner; 3])| Triangle {
                        corners: corners.map(|corner| V::from(mesh.positions[corner.position as usize])),
                        object: number,
                        index: u32::try_from(index).expect("fewer than 2^31 triangles"),
                    };
                    tracer.triangles.extend(mesh.triangles.iter().enumerate().map(triangle));
                    tracer.meshes[number as usize] = Some(Arc::clone(mesh));
                }
            }
        }
        tracer.build();
        tracer
    }

    /// Builds the hierarchy over the spheres and the triangles.
    fn build(&mut self) {
        let of_sphere = |&(centre, radius, _): &(V, f64, u32)| [centre.add_scalar(-radius), centre.add_scalar(radius)];
        let of_triangle = |&Triangle { corners: [a, b, c], .. }: &Triangle| [a.inf(&b).inf(&c), a.sup(&b).sup(&c)];
        let boxes = self.spheres.iter().map(of_sphere).chain(self.triangles.iter().map(of_triangle));
        let Some([low, high]) = boxes.clone().reduce(|a, b| [a[0].inf(&b[0]), a[1].sup(&b[1])]) else { return };
        self.size = (high - low).max();
        self.reach = low.amax().max(high.amax());
        // The crate gives up to sort what is nearer than 2^-52: the scene is brought to about size 1 for it, by a power
        // of two, which rounds nothing.
        let exponent = if self.size > 0.0 { libm::ilogb(self.size).clamp(-1000, 1000) } else { 0 };
        let (down, up) = (exp2(-exponent), exp2(exponent));
        let boxed = |[low, high]: [V; 2]| Boxed {
            bounds: Aabb::with_bounds(Point3::from(low * down), Point3::from(high * down)),
            node: 0,
        };
        let mut items: Vec<Boxed> = boxes.map(boxed).collect();
        assert!(items.len() < 1 << 31, "fewer than 2^31 triangles");
        let hierarchy = Bvh::build_par(&mut items);
        drop(items);
        // Only inner nodes are kept, one after the other.
        let mut place = 0;
        let child = |node: &BvhNode<f64, 3>| match node {
            BvhNode::Node { .. } => {
                place += 1;
                Child::Node(place - 1)
            }
            BvhNode::Leaf { shape_index, .. } => Child::Item(*shape_index as u32),
        };
        let places: Vec<Child> = hierarchy.nodes.iter().map(child).collect();
        let back = |bounds: &Aabb<f64, 3>| [(bounds.min.coords * up).into(), (bounds.max.coords * up).into()];
        let node = |node: &BvhNode<f64, 3>| match node {
            BvhNode::Node { child_l_index, child_l_aabb, child_r_index, child_r_aabb, .. } => Some(Node {
                boxes: [back(child_l_aabb), back(child_r_aabb)],
                children: [places[*child_l_index], places[*child_r_index]],
            }),
            BvhNode::Leaf { .. } => None,
        };
        self.nodes = hierarchy.nodes.iter().filter_map(node).collect();
        self.root = places.first().copied();
    }

    /// The nearest surface along a ray. The direction need not have length 1 but must not be null. What is nearer to
    /// the origin than rounding errors (`2^-36` of the size of the scene) is not seen. Of surfaces at exactly the same
    /// distance, the one that is first in the scene, and in its mesh, is seen; a mesh within a plane is at the same
    /// distance but for the rounding.
    #[must_use]
    pub fn hit(&self, origin: Vector, direction: Vector) -> Option<Hit> {
        let ray = Ray::new(origin.into(), unit(direction.into())?, self.reach);
        let found = self.nearest(&ray, self.offset(ray.origin.amax()))?;
        Some(self.describe(&ray, found))
    }

    /// The nearest that a ray meets beyond a distance.
    fn nearest(&self, ray: &Ray, from: f64) -> Option<Found> {
        let mut found = None;
        for &(point, normal, object) in &self.planes {
            let t = normal.dot(&(point - ray.origin)) / normal.dot(&ray.direction);
            if t.is_finite() {
                self.consider(&mut found, from, Found { t, key: (object, 0), on: On::Plane(normal) });
            }
        }
        if let Some(root) = self.root {
            let reached = |found: Option<Found>| found.map_or(f64::INFINITY, |found| found.t);
            self.walk(root, ray, reached(found), &mut |item| {
                if let Some(candidate) = self.meet(ray, item, from) {
                    self.consider(&mut found, from, candidate);
                }
                reached(found)
            });
        }
        found
    }

    /// How far places with these coordinates may be off.
    fn offset(&self, coordinates: f64) -> f64 {
        OFFSET * self.size + ROUNDING * coordinates
    }

    /// Takes what is nearer.
    fn consider(&self, found: &mut Option<Found>, from: f64, candidate: Found) {
        let nearer = |found: &Found| match candidate.t.total_cmp(&found.t) {
            Ordering::Equal => candidate.key < found.key,
            order => order == Ordering::Less,
        };
        if candidate.t > from && found.as_ref().is_none_or(nearer) {
            *found = Some(candidate);
        }
    }

    /// Where a ray meets a sphere or a triangle, beyond a distance.
    fn meet(&self, ray: &Ray, item: usize, from: f64) -> Option<Found> {
        if let Some(&(centre, radius, object)) = self.spheres.get(item) {
            let t = ray.sphere(centre, radius)?.into_iter().find(|&t| t > from)?;
            return Some(Found { t, key: (object, 0), on: On::Sphere(centre, radius) });
        }
        let place = item - self.spheres.len();
        let triangle = &self.triangles[place];
        let (t, weights) = ray.triangle(&triangle.corners)?;
        Some(Found { t, key: (triangle.object, triangle.index), on: On::Triangle(place, weights) })
    }

    /// Visits the spheres and triangles whose boxes a ray meets before a limit, the nearer boxes first; a visit returns
    /// the new limit.
    fn walk(&self, from: Child, ray: &Ray, limit: f64, visit: &mut impl FnMut(usize) -> f64) -> f64 {
        let node = match from {
            Child::Item(item) => return visit(item as usize),
            Child::Node(node) => &self.nodes[node as usize],
        };
        let enters = [0, 1].map(|side| ray.enters(&node.boxes[side], limit));
        match enters {
            [None, None] => limit,
            [Some(_), None] => self.walk(node.children[0], ray, limit, visit),
            [None, Some(_)] => self.walk(node.children[1], ray, limit, visit),
            [Some(left), Some(right)] => {
                let (nearer, farther) = if left <= right { (0, 1) } else { (1, 0) };
                let limit = self.walk(node.children[nearer], ray, limit, visit);
                if left.max(right) <= limit { self.walk(node.children[farther], ray, limit, visit) } else { limit }
            }
        }
    }

    /// The place, the normals and the rest of what was found.
    fn describe(&self, ray: &Ray, found: Found) -> Hit {
        let viewer = -ray.direction;
        let ahead = ray.origin + ray.direction * found.t;
        let turned = |facet: V| if facet.dot(&viewer) < 0.0 { -facet } else { facet };
        let (mut lift, normal, facet, position);
        match found.on {
            On::Plane(of_plane) => {
                (lift, facet, position) = (V::zeros(), turned(of_plane), ahead);
                normal = facet;
            }
            On::Sphere(centre, radius) => {
                // The place is put onto the sphere: from afar, `origin + t direction` is not exact enough.
                let outwards = unit(ahead - centre).unwrap_or(viewer);
                (lift, facet, position) = (V::zeros(), turned(outwards), centre + outwards * radius);
                normal = facet;
            }
            On::Triangle(place, weights) => {
                let Triangle { corners, object, index } = &self.triangles[place];
                let mesh = self.meshes[*object as usize].as_ref().expect("a triangle's object is a mesh");
                let normals =
                    mesh.triangles[*index as usize].map(|corner| V::from(mesh.normals[corner.normal as usize]));
                let mix = |of: &[V; 3]| of[0] * weights[0] + of[1] * weights[1] + of[2] * weights[2];
                let [a, b, c] = *corners;
                facet = turned(unit((b - a).cross(&(c - a))).unwrap_or(viewer));
                position = mix(corners);
                let interpolated = unit(mix(&normals)).unwrap_or(facet);
                let side = f64::copysign(1.0, interpolated.dot(&facet));
                normal = interpolated * side;
                lift = V::zeros();
                for corner in 0..3 {
                    let below = (position - corners[corner]).dot(&normals[corner]) * side;
                    lift -= normals[corner] * (side * weights[corner] * below.min(0.0));
                }
            }
        }
        let offset = self.offset(position.amax() + found.t);
        lift += facet * offset;
        Hit {
            position: position.into(),
            normal: normal.into(),
            facet: facet.into(),
            viewer: viewer.into(),
            distance: found.t,
            material: self.materials[found.key.0 as usize],
            start: position + lift,
            offset,
        }
    }

    /// What the pixels of a row of a scene's picture show, from the left; row 0 is at the top.
    #[must_use]
    pub fn row(&self, scene: &Scene, row: u32) -> Vec<Option<Hit>> {
        let camera = &scene.camera;
        camera.row(scene.width, scene.height, row).map(|direction| self.hit(camera.position, direction)).collect()
    }

    /// A light of a scene, seen from a point of a surface. The scene must have the objects of the tracer.
    ///
    /// Rays of shadow begin off the surface by `2^-36` of the scene's size plus what rounding needs. On a mesh with
    /// interpolated normals a facet's plane would cut the light off before N.L does, and the shadow's edge would follow
    /// the facets; there the ray begins on the smooth surface that the normals imply, by "Hacking the shadow
    /// terminator" (J. Hanika, Ray Tracing Gems II 2021, chapter 4): the point is lifted to the tangent planes of the
    /// corners, as far as it is below them.
    #[must_use]
    pub fn light(&self, scene: &Scene, hit: &Hit, light: usize) -> Lit {
        let (normal, viewer) = (V::from(hit.normal), V::from(hit.viewer));
        let (towards, distant) = match scene.lights[light].kind {
            LightKind::Directional(direction) => (V::from(direction), true),
            LightKind::Point(place) => (V::from(place) - V::from(hit.position), false),
        };
        let apart = distant || towards.amax() > hit.offset;
        let direction = unit(towards).unwrap_or(normal);
        let half = direction + viewer;
        let half = if half.amax() > 1e-12 { unit(half) } else { None }.unwrap_or_else(|| across(normal));
        let cosine = normal.dot(&direction);
        let mut visible = apart && cosine > 0.0;
        if visible && scene.shadows {
            visible = match scene.lights[light].kind {
                LightKind::Directional(_) => !self.blocked(hit.start, direction, f64::INFINITY),
                LightKind::Point(place) => {
                    let way = V::from(place) - hit.start;
                    let length = way.norm();
                    length <= hit.offset || !self.blocked(hit.start, way / length, length - hit.offset)
                }
            };
        }
        Lit { direction: direction.into(), half: half.into(), cosine, visible }
    }

    /// Whether anything is met before a distance.
    fn blocked(&self, origin: V, direction: V, limit: f64) -> bool {
        let ray = Ray::new(origin, direction, self.reach);
        let meets = |t: f64| t > 0.0 && t < limit;
        let plane = |&(point, normal, _): &(V, V, u32)| meets(normal.dot(&(point - origin)) / normal.dot(&direction));
        if self.planes.iter().any(plane) {
            return true;
        }
        let Some(root) = self.root else { return false };
        let visit = &mut |item| {
            let blocked = self.meet(&ray, item, 0.0).is_some_and(|found| meets(found.t));
            if blocked { f64::NEG_INFINITY } else { limit }
        };
        self.walk(root, &ray, limit, visit) == f64::NEG_INFINITY
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::mesh::Corner;
    use super::super::ray::tests::vector;
    use super::*;

    /// A tracer of loose triangles and spheres.
    fn soup(triangles: &[[Vector; 3]], spheres: &[(Vector, f64)]) -> Tracer {
        let corner = |place: usize| Corner { position: place as u32, normal: 0 };
        let mesh = Arc::new(Mesh {
            positions: triangles.as_flattened().to_vec(),
            normals: vec![[0.0, 0.0, 1.0]],
            triangles: (0..triangles.len()).map(|t| [3 * t, 3 * t + 1, 3 * t + 2].map(corner)).collect(),
            ..Mesh::default()
        });
        let mut shapes: Vec<Shape> = spheres.iter().map(|&(centre, radius)| Shape::Sphere { centre, radius }).collect();
        shapes.insert(shapes.len() / 2, Shape::Mesh(mesh));
        let objects: Vec<_> = shapes.into_iter().map(|shape| Object { shape, material: 0 }).collect();
        Tracer::of(&objects)
    }

    /// The nearest of all, each tried.
    fn brute(tracer: &Tracer, ray: &Ray, from: f64) -> Option<Found> {
        let mut found = None;
        for item in 0..tracer.spheres.len() + tracer.triangles.len() {
            if let Some(candidate) = tracer.meet(ray, item, from) {
                tracer.consider(&mut found, from, candidate);
            }
        }
        found
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 2000, ..ProptestConfig::default() })]

        #[test]
        fn the_hierarchy_finds_what_trying_all_finds(
            triangles in prop::collection::vec(prop::array::uniform3(vector()), 0..40),
            spheres in prop::collection::vec((vector(), 0.1..1.0f64), 0..4),
            rays in prop::collection::vec((vector(), vector()), 1..40),
            exponent in prop::sample::select(vec![0, 0, -40, 40]),
            shift in prop::sample::select(vec![0.0, 0.0, 1e7]),
        ) {
            let scale = exp2(exponent);
            let put = |v: Vector| v.map(|c| (c + shift) * scale);
            let triangles: Vec<_> = triangles.into_iter().map(|corners| corners.map(put)).collect();
            let spheres: Vec<_> = spheres.into_iter().map(|(centre, r)| (put(centre), r * scale)).collect();
            let tracer = soup(&triangles, &spheres);
            for (origin, direction) in rays {
                let Some(unit) = unit(direction.into()) else { continue };
                let origin = V::from(put(origin));
                let ray = Ray::new(origin, unit, tracer.reach);
                let from = tracer.offset(origin.amax());
                let expected = brute(&tracer, &ray, from);
                let hit = tracer.hit(origin.into(), direction);
                let expected = expected.map(|found| tracer.describe(&ray, found));
                prop_assert_eq!(&hit, &expected);
                for vector in hit.iter().flat_map(|hit| [hit.normal, hit.facet, hit.viewer]) {
                    prop_assert!((V::from(vector).norm() - 1.0).abs() < 1e-14);
                }
                // Any hit is met before a limit if the nearest is.
                let nearest = brute(&tracer, &ray, 0.0).map_or(f64::INFINITY, |found| found.t);
                for limit in [nearest, nearest * 1.5, f64::INFINITY] {
                    prop_assert_eq!(tracer.blocked(origin, unit, limit), nearest < limit);
                }
            }
        }
    }

    /// Triangles whose sizes and distances shrink by half, far below what the crate can sort.
    #[test]
    fn an_uneven_hierarchy_is_walked_whole() {
        let triangle = |k: i32| {
            let at = |x: f64, y: f64| [x * exp2(-k), y * exp2(-k), 3.0 * exp2(-k)];
            [at(-1.0, -1.0), at(1.0, -1.0), at(0.0, 1.0)]
        };
        let triangles: Vec<_> = (0..400).map(triangle).collect();
        let tracer = soup(&triangles, &[]);
        for k in 0..400 {
            let from = [0.0, 0.0, 3.5 * exp2(-k)];
            let ray = Ray::new(V::from(from), -V::z(), tracer.reach);
            assert_eq!(tracer.nearest(&ray, 0.0).map(|found| found.key), Some((0, k as u32)));
        }
    }
}
