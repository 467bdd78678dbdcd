//! Slices of the reflectance about the half vector, one for each angle of the light, all looked up at the same place.
//!
//! With the viewer fixed and a directional light, θd = φ/2 everywhere on the sphere: an image of it is one slice of the
//! table times n·l. In the frame of the half vector the highlight stands still, so that neighbouring slices can be
//! blended without a turn; n·l is exact.

use libm::{atan2, cos, sin, sqrt};
use multiversion::multiversion;
use rayon::prelude::*;

use super::texels::{Samples, Texels, pair};
use super::vector::{Light, Vector, about_y, about_z, sine_cosine};
use super::{Reflectance, Rgb};

/// The angle of the last slice, in degrees.
pub const LAST: f64 = 176.0;
/// The greatest angle that a slice may have, in degrees: past it no normal is lit by enough.
pub const MOST: f64 = 178.0;
/// Texels outside of the disc have the value at this radius.
const RADIUS: f64 = 0.9995;
/// How far from the horizon of light and viewer a texel's normal is kept, in degrees.
const MARGIN: f64 = 0.5;

/// The angles of so many slices in degrees, evenly spaced.
#[must_use]
pub fn angles(count: usize) -> Vec<f64> {
    (0..count).map(|i| if i == 0 { 0.0 } else { LAST * i as f64 / (count - 1) as f64 }).collect()
}

/// The slices of E f, a layer for each angle of the light.
#[must_use]
pub fn samples(reflectance: &dyn Reflectance, angles: &[f64], size: usize, exposure: f64) -> Samples {
    let at = |place: usize| (2.0 * place as f64 + 1.0) / size as f64 - 1.0;
    let row = |row: usize| {
        let (phi, y) = (angles[row / size], at(row % size));
        let l = Light::new(0.5 * phi, 0.0).direction();
        let v = Vector::new(-l.x, 0.0, l.z);
        let most = (90.0 - 0.5 * phi - MARGIN).to_radians();
        (0..size).map(move |column| {
            let (mut x, mut y) = (at(column), y);
            let r = sqrt(x * x + y * y);
            if r > RADIUS {
                (x, y) = (x * RADIUS / r, y * RADIUS / r);
            }
            let z = sqrt((1.0 - x * x - y * y).max(0.0));
            // Turned about Y until light and viewer both see it; lit normals that are seen are never looked up further
            // out.
            let psi = atan2(x, z).clamp(-most, most);
            let around = sqrt((1.0 - y * y).max(0.0));
            let n = Vector::new(around * sin(psi), y, around * cos(psi));
            reflectance.at(l, v, n).map(|f| (exposure * f) as f32)
        })
    };
    let rows: Vec<Vec<[f32; 3]>> = (0..angles.len() * size).into_par_iter().map(|place| row(place).collect()).collect();
    Samples { width: size, height: size, data: rows.concat() }
}

/// What a light has ready for every normal.
#[derive(Clone, Copy, Debug)]
pub(super) struct Setup {
    l: Vector,
    /// Sine and cosine of -γ and of -φ/2.
    gamma: [f64; 2],
    half: [f64; 2],
    layers: [usize; 2],
    /// Whether a light from here lights anything that is seen.
    lit: bool,
    t: f64,
}

pub(super) fn setup(angles: &[f64], light: Light) -> Setup {
    let pair = pair(angles, light.phi);
    Setup {
        l: light.direction(),
        gamma: sine_cosine(-light.gamma),
        half: sine_cosine(-0.5 * light.phi),
        layers: [pair.first, pair.second.unwrap_or(pair.first)],
        lit: light.phi < 180.0,
        t: pair.t,
    }
}

/// What the slices give for a normal.
pub(super) fn at(texels: &Texels, setup: &Setup, n: Vector) -> Rgb {
    let cosine = n.dot(&setup.l);
    if !setup.lit || cosine <= 0.0 || n.z <= 0.0 {
        return [0.0; 3];
    }
    let q = about_y(about_z(n, setup.gamma), setup.half);
    let (u, v) = (0.5 * (q.x + 1.0), 0.5 * (q.y + 1.0));
    let [w1, w2] = texels.weights(setup.layers, setup.t);
    let one = texels.bilinear(setup.layers[0], u, v);
    let blend = if setup.t == 0.0 {
        one.map(|code| w1 * code)
    } else {
        let other = texels.bilinear(setup.layers[1], u, v);
        [0, 1, 2].map(|c| w1 * one[c] + w2 * other[c])
    };
    texels.value(blend).map(|value| value * cosine)
}

/// A light with its two slices blended: both are looked up at the same place, so one look-up in their blend is the
/// blend of two.
#[derive(Clone, Debug)]
pub(super) struct Blended {
    l: [f32; 3],
    /// Rows of the turn of a normal into the half vector's frame, times half of the size.
    u: [f32; 3],
    v: [f32; 3],
    size: usize,
    root: bool,
    lit: bool,
    texels: Vec<[f32; 4]>,
}

pub(super) fn blended(texels: &Texels, setup: &Setup) -> Blended {
    let [w1, w2] = texels.weights(setup.layers, setup.t).map(|weight| weight as f32);
    let (one, other) = (texels.layer(setup.layers[0]), texels.layer(setup.layers[1]));
    let blend = |(a, b): (&[f32; 4], &[f32; 4])| [0, 1, 2, 3].map(|c| w1 * a[c] + w2 * b[c]);
    let scale = 0.5 * texels.width as f64;
    let row = |x: Vector| [x.x * scale, x.y * scale, x.z * scale].map(|value| value as f32);
    let [gs, gc] = setup.gamma;
    let [hs, hc] = setup.half;
    Blended {
        l: [setup.l.x, setup.l.y, setup.l.z].map(|value| value as f32),
        u: row(Vector::new(gc * hc, -gs * hc, hs)),
        v: row(Vector::new(gs, gc, 0.0)),
        size: texels.width,
        root: texels.is_root(),
        lit: setup.lit,
        texels: one.iter().zip(other).map(blend).collect(),
    }
}

const LANES: usize = 64;

/// What a light gives for many normals, added to what is there.
#[multiversion(targets("x86_64+avx2", "x86_64+sse4.1", "aarch64+neon"))]
pub(super) fn add(light: &Blended, intensity: f32, [xs, ys, zs]: [&[f32]; 3], out: &mut [[f32; 3]]) {
    if !light.lit {
        return;
    }
    let size = light.size;
    let (middle, last) = (0.5 * size as f32 - 0.5, (size - 1) as f32);
    let mut start = 0;
    while start < xs.len() {
        let lanes = LANES.min(xs.len() - start);
        let (xs, ys, zs) = (&xs[start..][..lanes], &ys[start..][..lanes], &zs[start..][..lanes]);
        let mut place = [0u32; LANES];
        let mut across = [0.0f32; LANES];
        let mut up = [0.0f32; LANES];
        let mut cosine = [0.0f32; LANES];
        for lane in 0..lanes {
            let (x, y, z) = (xs[lane], ys[lane], zs[lane]);
            let dot = |row: &[f32; 3]| row[0] * x + row[1] * y + row[2] * z;
            let nl = dot(&light.l);
            cosine[lane] = if nl > 0.0 && z > 0.0 { nl * intensity } else { 0.0 };
            let u = (middle + dot(&light.u)).max(0.0).min(last);
            let v = (middle + dot(&light.v)).max(0.0).min(last);
            let (column, row) = (u.min(last - 1.0).floor(), v.min(last - 1.0).floor());
            place[lane] = (row * size as f32 + column) as u32;
            across[lane] = u - column;
            up[lane] = v - row;
        }
        for (lane, out) in out[start..][..lanes].iter_mut().enumerate() {
            let at = place[lane] as usize;
            let (s, t) = (across[lane], up[lane]);
            let (low, high) = (&light.texels[at..][..2], &light.texels[at + size..][..2]);
            let mut value = [0.0f32; 4];
            for c in 0..4 {
                let low = low[0][c] + s * (low[1][c] - low[0][c]);
                let high = high[0][c] + s * (high[1][c] - high[0][c]);
                value[c] = low + t * (high - low);
            }
            for c in 0..3 {
                out[c] += cosine[lane] * if light.root { value[c] * value[c] } else { value[c] };
            }
        }
        start += lanes;
    }
}
