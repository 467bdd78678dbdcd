//! The reflectance over θh and θd alone, averaged over φd: for a directional light a curve of n·h, a measured lobe in
//! place of cos^n.

use std::f64::consts::{FRAC_PI_2, PI};

use libm::{asin, sqrt};
use multiversion::multiversion;
use rayon::prelude::*;

use super::texels::{Samples, Texels};
use super::vector::{Angles, Light, Vector};
use super::{Reflectance, Rgb};

/// The greatest θd, in degrees.
const LAST: f64 = 89.91;
/// Directions over which φd is averaged.
const AROUND: usize = 180;
/// The least cosine of light and viewer that takes part in the average.
const LEAST: f64 = 0.02;

/// The nodes at θh = 90° (i/(N-1))² along the columns; see [`samples_at`].
#[must_use]
pub fn samples(reflectance: &dyn Reflectance, size: usize, exposure: f64) -> Samples {
    let part = |step: usize| step as f64 / (size - 1) as f64;
    let columns: Vec<f64> = (0..size).map(|column| FRAC_PI_2 * part(column) * part(column)).collect();
    samples_at(reflectance, &columns, size, exposure)
}

/// The nodes: so many θd, evenly spaced, along the rows, ascending θh in radians along the columns; each the mean of
/// E f over φd weighted by (n·l)(n·v).
#[must_use]
pub fn samples_at(reflectance: &dyn Reflectance, columns: &[f64], rows: usize, exposure: f64) -> Samples {
    let part = |step: usize| step as f64 / (rows - 1) as f64;
    let row = |row: usize| {
        let theta_d = (LAST * part(row)).to_radians();
        let mut before = [0.0f32; 3];
        let node = |&theta_h: &f64| {
            let (mut sum, mut weights) = ([0.0; 3], 0.0);
            for step in 0..AROUND {
                let phi_d = 2.0 * PI * (step as f64 + 0.5) / AROUND as f64;
                let [l, v, n] = Angles { theta_h, theta_d, phi_d }.vectors();
                let (nl, nv) = (n.dot(&l), n.dot(&v));
                if nl > LEAST && nv > LEAST {
                    let f = reflectance.at(l, v, n);
                    (0..3).for_each(|c| sum[c] += nl * nv * f[c]);
                    weights += nl * nv;
                }
            }
            // Where nobody sees the normal, the last one that is seen.
            if weights > 0.0 {
                before = sum.map(|sum| (exposure * sum / weights) as f32);
            }
            before
        };
        columns.iter().map(node).collect()
    };
    let mut nodes: Vec<Vec<[f32; 3]>> = (0..rows).into_par_iter().map(row).collect();
    // At the last θd not even θh = 0 takes part: such a row is the one before.
    for place in 1..rows {
        if libm::cos((LAST * part(place)).to_radians()) <= LEAST {
            nodes[place] = nodes[place - 1].clone();
        }
    }
    Samples { width: columns.len(), height: rows, data: nodes.concat() }
}

/// What a light has ready for every normal.
#[derive(Clone, Copy, Debug)]
pub(super) struct Setup {
    l: Vector,
    h: Vector,
    rows: [usize; 2],
    t: f64,
    lit: bool,
}

/// The polar angles of lights in degrees that so many rows of nodes are of.
#[must_use]
pub fn angles(rows: usize) -> Vec<f64> {
    (0..rows).map(|row| 2.0 * LAST * row as f64 / (rows - 1) as f64).collect()
}

pub(super) fn setup(size: usize, light: Light) -> Setup {
    let l = light.direction();
    let place = (0.5 * light.phi / LAST * (size - 1) as f64).clamp(0.0, (size - 1) as f64);
    let row = (place as usize).min(size - 2);
    // Behind the object the half vector vanishes, and nothing that is seen is lit.
    let lit = light.phi < 180.0;
    let h = if lit { (l + Vector::z()).normalize() } else { Vector::z() };
    Setup { l, h, rows: [row, row + 1], t: place - row as f64, lit }
}

/// What the nodes give for a normal.
pub(super) fn at(texels: &Texels, setup: &Setup, n: Vector) -> Rgb {
    let cosine = n.dot(&setup.l);
    if !setup.lit || cosine <= 0.0 || n.z <= 0.0 {
        return [0.0; 3];
    }
    let size = texels.width;
    // The chord and not the cosine, which has half of the digits near the highlight's middle.
    let theta_h = 2.0 * asin((0.5 * (n - setup.h).norm()).min(1.0));
    let place = (sqrt(theta_h / FRAC_PI_2) * (size - 1) as f64).min((size - 1) as f64);
    let column = (place as usize).min(size - 2);
    let s = place - column as f64;
    let codes = texels.layer(0);
    let [w1, w2] = texels.weights(setup.rows, setup.t);
    let along = |row: usize, c: usize| {
        let (a, b) = (codes[row * size + column][c], codes[row * size + column + 1][c]);
        f64::from(a) * (1.0 - s) + f64::from(b) * s
    };
    let blend = [0, 1, 2].map(|c| w1 * along(setup.rows[0], c) + w2 * along(setup.rows[1], c));
    texels.value(blend).map(|value| value * cosine)
}

/// A light with its two rows blended to one curve.
#[derive(Clone, Debug)]
pub(super) struct Curve {
    l: [f32; 3],
    h: [f32; 3],
    root: bool,
    lit: bool,
    nodes: Vec<[f32; 4]>,
}

pub(super) fn curve(texels: &Texels, setup: &Setup) -> Curve {
    let [w1, w2] = texels.weights(setup.rows, setup.t).map(|weight| weight as f32);
    let size = texels.width;
    let row = |row: usize| &texels.layer(0)[row * size..][..size];
    let blend = |(a, b): (&[f32; 4], &[f32; 4])| [0, 1, 2, 3].map(|c| w1 * a[c] + w2 * b[c]);
    let single = |v: Vector| [v.x, v.y, v.z].map(|value| value as f32);
    Curve {
        l: single(setup.l),
        h: single(setup.h),
        root: texels.is_root(),
        lit: setup.lit,
        nodes: row(setup.rows[0]).iter().zip(row(setup.rows[1])).map(blend).collect(),
    }
}

const LANES: usize = 64;

/// arccos(x) = √(1-x) P(x) for x from 0 to 1, to 2e-8 (M. Abramowitz, I. A. Stegun, Handbook of Mathematical Functions,
/// 4.4.46).
const ARCCOS: [f32; 8] = [
    std::f32::consts::FRAC_PI_2,
    -0.214_598_8,
    0.088_978_99,
    -0.050_174_304,
    0.030_891_88,
    -0.017_088_126,
    0.006_670_09,
    -0.001_262_491_1,
];

/// What a light gives for many normals, added to what is there.
#[multiversion(targets("x86_64+avx2", "x86_64+sse4.1", "aarch64+neon"))]
pub(super) fn add(light: &Curve, intensity: f32, [xs, ys, zs]: [&[f32]; 3], out: &mut [[f32; 3]]) {
    if !light.lit {
        return;
    }
    let last = (light.nodes.len() - 1) as f32;
    let scale = last / (FRAC_PI_2 as f32).sqrt();
    let mut start = 0;
    while start < xs.len() {
        let lanes = LANES.min(xs.len() - start);
        let (xs, ys, zs) = (&xs[start..][..lanes], &ys[start..][..lanes], &zs[start..][..lanes]);
        let mut place = [0u32; LANES];
        let mut part = [0.0f32; LANES];
        let mut cosine = [0.0f32; LANES];
        for lane in 0..lanes {
            let (x, y, z) = (xs[lane], ys[lane], zs[lane]);
            let nl = light.l[0] * x + light.l[1] * y + light.l[2] * z;
            cosine[lane] = if nl > 0.0 && z > 0.0 { nl * intensity } else { 0.0 };
            let (dx, dy, dz) = (x - light.h[0], y - light.h[1], z - light.h[2]);
            // 1 - n·h, and n·h of what is lit and seen is above 0.
            let versine = (0.5 * (dx * dx + dy * dy + dz * dz)).min(1.0);
            let c = 1.0 - versine;
            let mut p = ARCCOS[7];
            for &coefficient in ARCCOS[..7].iter().rev() {
                p = p * c + coefficient;
            }
            let theta_h = versine.sqrt() * p;
            let at = (scale * theta_h.sqrt()).min(last);
            let low = at.min(last - 1.0).floor();
            place[lane] = low as u32;
            part[lane] = at - low;
        }
        for (lane, out) in out[start..][..lanes].iter_mut().enumerate() {
            let nodes = &light.nodes[place[lane] as usize..][..2];
            let mut value = [0.0f32; 4];
            for c in 0..4 {
                value[c] = nodes[0][c] + part[lane] * (nodes[1][c] - nodes[0][c]);
            }
            for c in 0..3 {
                out[c] += cosine[lane] * if light.root { value[c] * value[c] } else { value[c] };
            }
        }
        start += lanes;
    }
}
