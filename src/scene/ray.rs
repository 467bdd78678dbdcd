//! A ray against a box, a triangle and a sphere, so that nothing is missed through rounding.

use nalgebra::Vector3;

use crate::core::sample::Vector;

/// Rounding errors of places, relative to the coordinates that they come from: 64 times that of one operation, `2^-52`.
pub(super) const ROUNDING: f64 = 1.0 / (1u64 << 46) as f64;

pub(super) type V = Vector3<f64>;

/// A ray with what the tests need of it.
pub(super) struct Ray {
    pub(super) origin: V,
    pub(super) direction: V,
    inverse: Vector,
    /// For each axis which of a box's two corners is the nearer.
    near: [usize; 3],
    /// The origin, moved by more than all rounding errors so that boxes are met too early and left too late.
    early: Vector,
    late: Vector,
    /// The axis along which it runs most, and the two others.
    axes: [usize; 3],
    /// `d_x / d_z`, `d_y / d_z` and `1 / d_z` on these axes, with z the first of them.
    shear: Vector,
}

impl Ray {
    pub(super) fn new(origin: V, direction: V, reach: f64) -> Self {
        let slack = ROUNDING * (origin.amax() + reach);
        let z = direction.iamax();
        let axes = [z, (z + 1) % 3, (z + 2) % 3];
        let over = 1.0 / direction[z];
        let mut ray = Self {
            origin,
            direction,
            inverse: direction.map(|c| 1.0 / c).into(),
            near: [0; 3],
            early: origin.into(),
            late: origin.into(),
            axes,
            shear: [direction[axes[1]] * over, direction[axes[2]] * over, over],
        };
        for axis in 0..3 {
            let sign = f64::copysign(1.0, direction[axis]);
            ray.near[axis] = usize::from(sign < 0.0);
            ray.early[axis] += sign * slack;
            ray.late[axis] -= sign * slack;
        }
        ray
    }

    /// Where it enters a box, if it does so before `limit`. After "Robust BVH ray traversal" (T. Ize, 2013): NaN, of a
    /// ray within the plane of a face, takes no part in the comparisons, and no box is missed through rounding.
    pub(super) fn enters(&self, bounds: &[Vector; 2], limit: f64) -> Option<f64> {
        let (mut from, mut to) = (0.0, limit);
        for axis in 0..3 {
            let near = (bounds[self.near[axis]][axis] - self.early[axis]) * self.inverse[axis];
            let far = (bounds[1 - self.near[axis]][axis] - self.late[axis]) * self.inverse[axis];
            from = if near > from { near } else { from };
            to = if far < to { far } else { to };
        }
        // Three roundings on each side.
        (from <= to * (1.0 + 8.0 * f64::EPSILON)).then_some(from)
    }

    /// The distance of a triangle and the weights of its corners. After "Watertight ray/triangle intersection" (S.
    /// Woop, C. Benthin, I. Wald, JCGT 2013): the ray is sheared onto an axis, and three edge functions tell on which
    /// side of each edge it passes. The two triangles at an edge compute the same number for it, with opposite signs,
    /// and its sign is exact: no ray slips through.
    pub(super) fn triangle(&self, corners: &[V; 3]) -> Option<(f64, [f64; 3])> {
        let [z, x, y] = self.axes;
        let [a, b, c] = corners.map(|corner| {
            let p = corner - self.origin;
            [p[x] - self.shear[0] * p[z], p[y] - self.shear[1] * p[z], self.shear[2] * p[z]]
        });
        let weights = [edge(c, b), edge(a, c), edge(b, a)];
        if weights.iter().any(|&w| w < 0.0) && weights.iter().any(|&w| w > 0.0) {
            return None;
        }
        // All have one sign: nothing cancels. 0 is a triangle without area, or one that is seen edge-on.
        let sum = weights[0] + weights[1] + weights[2];
        if sum == 0.0 {
            return None;
        }
        let weights = weights.map(|w| w / sum);
        Some((weights[0] * a[2] + weights[1] * b[2] + weights[2] * c[2], weights))
    }

    /// The distances at which it passes through a sphere, the smaller first. After "Precision improvements for
    /// ray/sphere intersection" (E. Haines, J. Günther, T. Akenine-Möller, Ray Tracing Gems 2019): no cancellation for
    /// spheres far away.
    pub(super) fn sphere(&self, centre: V, radius: f64) -> Option<[f64; 2]> {
        let f = self.origin - centre;
        let b = -f.dot(&self.direction);
        let aside = f + self.direction * b;
        let discriminant = radius * radius - aside.dot(&aside);
        if discriminant < 0.0 {
            return None;
        }
        let q = b + f64::copysign(libm::sqrt(discriminant), b);
        let other = if q == 0.0 { 0.0 } else { (f.dot(&f) - radius * radius) / q };
        Some(if q < other { [q, other] } else { [other, q] })
    }
}

/// `b_x a_y - b_y a_x` with the right sign.
fn edge(b: Vector, a: Vector) -> f64 {
    let (p, q) = (b[0] * a[1], b[1] * a[0]);
    if (p - q).abs() > f64::EPSILON * (p.abs() + q.abs()) {
        return p - q;
    }
    // The products' rounding errors, which are numbers themselves.
    let (p_error, q_error) = (libm::fma(b[0], a[1], -p), libm::fma(-b[1], a[0], q));
    (p - q) + (p_error + q_error)
}

/// The vector of length 1 in a direction, or none for the null vector. Without overflow.
pub(super) fn unit(v: V) -> Option<V> {
    let largest = v.amax();
    (largest > 0.0).then(|| {
        let v = v / largest;
        v / libm::sqrt(v.dot(&v))
    })
}

/// A unit vector across another.
pub(super) fn across(v: V) -> V {
    let least = v.iamin();
    unit(v.cross(&V::ith(least, 1.0))).unwrap_or_else(V::x)
}

#[cfg(test)]
pub(super) mod tests {
    use std::cmp::Ordering;

    use num_bigint::{BigInt, Sign};
    use proptest::prelude::*;

    use super::*;

    /// Whole numbers, with which much is degenerate or parallel to an axis, mixed with any numbers.
    fn coordinate() -> impl Strategy<Value = f64> {
        prop_oneof![3 => (-2i32..=2).prop_map(f64::from), 1 => -2.0..2.0f64, 1 => Just(-0.0)]
    }

    pub(in crate::scene) fn vector() -> impl Strategy<Value = Vector> {
        prop::array::uniform3(coordinate())
    }

    /// The textbook's way: solve for t and the weights by Cramer's rule (T. Möller, B. Trumbore 1997).
    fn textbook(ray: &Ray, [a, b, c]: [V; 3]) -> Option<(f64, [f64; 3])> {
        let (e, f, s) = (b - a, c - a, ray.origin - a);
        let determinant = e.dot(&ray.direction.cross(&f));
        let v = s.dot(&ray.direction.cross(&f)) / determinant;
        let w = ray.direction.dot(&s.cross(&e)) / determinant;
        (determinant.abs() > 1e-9).then(|| (f.dot(&s.cross(&e)) / determinant, [1.0 - v - w, v, w]))
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 2000, ..ProptestConfig::default() })]

        #[test]
        fn triangles_are_met_as_in_the_textbook(
            corners in prop::array::uniform3(vector()),
            origin in vector(),
            direction in vector(),
        ) {
            prop_assume!(direction != [0.0; 3]);
            let ray = Ray::new(origin.into(), unit(direction.into()).unwrap(), 2.0);
            let corners = corners.map(V::from);
            let met = ray.triangle(&corners);
            if let Some((t, weights)) = textbook(&ray, corners) {
                let least = weights.into_iter().fold(f64::INFINITY, f64::min);
                prop_assert!(least.abs() < 1e-9 || met.is_some() == (least > 0.0));
                if let Some((own_t, own)) = met {
                    prop_assert!((own_t - t).abs() < 1e-9);
                    prop_assert!((0..3).all(|k| (own[k] - weights[k]).abs() < 1e-9));
                }
            }
        }

        #[test]
        fn edges_have_exact_signs(a in prop::array::uniform3(-1e3..1e3f64), k in 1u32..100, ulps in -3i64..=3) {
            // b is along a but for a few units in the last place of a component.
            let factor = f64::from(k) / 64.0;
            let mut b = a.map(|c| c * factor);
            b[1] = f64::from_bits((b[1].to_bits() as i64 + ulps) as u64);
            prop_assert_eq!(edge(a, b), -edge(b, a));
            let big = |x: f64| -> BigInt { num_traits::FromPrimitive::from_f64(x * 2f64.powi(60)).unwrap() };
            let product = |x: f64, y: f64| big(x) * big(y);
            let whole = |x: f64| (x * 2f64.powi(60)).fract() == 0.0;
            prop_assume!([a[0], a[1], b[0], b[1]].into_iter().all(whole));
            let exact = product(a[0], b[1]) - product(a[1], b[0]);
            let sign = |x: f64| match x.partial_cmp(&0.0) {
                Some(Ordering::Greater) => Sign::Plus,
                Some(Ordering::Less) => Sign::Minus,
                _ => Sign::NoSign,
            };
            prop_assert_eq!(sign(edge(a, b)), exact.sign());
        }
    }
}
