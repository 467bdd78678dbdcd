//! The form of the paper: pictures of the unit sphere, lit from a few angles; equations 1 to 4.
//!
//! With n turned back by γ about the viewer's axis, the images at φ1 ≤ φ ≤ φ2 are looked up where the normal is after a
//! turn by k(φi - φ) about Y and blended by t = (φ - φ1)/(φ2 - φ1). What the paper leaves open is decided here:
//!
//! - αh of equation 3 is at most 90 degrees; k is 1 where n has no part in the plane of light and viewer, as αh is
//!   undefined there.
//! - Past the last image it alone is taken with k = 3/4, and below the first image that one. At an image's own angle
//!   nothing is turned.
//! - A turned normal may point away from the viewer, where the image has nothing: see [`Behind`].
//!
//! Figure 4's Δφ2 = 55° is a misprint for 30°: its images are at 45 and 90 degrees and its light at 60.

use std::fmt;
use std::str::FromStr;

use libm::sqrt;
use multiversion::multiversion;
use rayon::prelude::*;

use super::texels::{Samples, Texels, pair};
use super::vector::{Light, Vector, about_y, about_z, sine_cosine};
use super::{Reflectance, Rgb};

/// What keeps the black outside of the sphere from an interpolation at its rim.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Border {
    /// Normals are made shorter by a factor before the look-up, the paper's 0.995; texels whose centre is outside of
    /// the sphere are black.
    Shrink(f64),
    /// The rim's colour goes on outside of the sphere.
    Extend,
    /// The same along x only: each row goes on with the colours of its ends, so that a turned normal behind the rim is
    /// on its side of the row.
    ExtendX,
}

impl FromStr for Border {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let factor = text.strip_prefix("shrink:").and_then(|factor| factor.parse().ok());
        match (text, factor) {
            ("extend", _) => Ok(Self::Extend),
            ("extend-x", _) => Ok(Self::ExtendX),
            ("shrink", _) => Ok(Self::Shrink(0.995)),
            (_, Some(factor)) if (0.5..=1.0).contains(&factor) => Ok(Self::Shrink(factor)),
            _ => Err(format!(
                "`{text}` is no border: `shrink:0.995` with a factor from 0.5 to 1, `extend` or `extend-x`"
            )),
        }
    }
}

impl fmt::Display for Border {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Shrink(factor) => write!(f, "shrink:{factor}"),
            Self::Extend => write!(f, "extend"),
            Self::ExtendX => write!(f, "extend-x"),
        }
    }
}

/// What is looked up for a turned normal that points away from the viewer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Behind {
    /// The nearest place on the rim.
    #[default]
    Rim,
    /// The place that its x and y name, which is that of its mirror image, as the equations are printed.
    Literal,
    /// Nothing: the other image takes its weight. Where there is none, the rim.
    Skip,
}

impl FromStr for Behind {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "rim" => Ok(Self::Rim),
            "literal" => Ok(Self::Literal),
            "skip" => Ok(Self::Skip),
            _ => Err(format!("`{text}` is not `rim`, `literal` or `skip`")),
        }
    }
}

impl fmt::Display for Behind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Rim => "rim",
            Self::Literal => "literal",
            Self::Skip => "skip",
        })
    }
}

/// The coefficient k of the turns.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Turn {
    /// k = 1/2 + sin(αh)/2, equation 3.
    #[default]
    Equation3,
    /// The same everywhere: 1 as in equation 2 and figure 4a, 1/2 as in figure 4b.
    Fixed(f64),
}

/// k past the last image and before the first.
const ALONE: f64 = 0.75;
/// The radius of the rim where a colour of it is asked for: at 1 itself the surface is seen from its side.
const RIM: f64 = 0.9995;

/// How the images are looked up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// At the rim of the sphere.
    pub border: Border,
    /// Behind it.
    pub behind: Behind,
    /// How far normals are turned.
    pub turn: Turn,
}

impl Default for Options {
    fn default() -> Self {
        Self { border: Border::Shrink(0.995), behind: Behind::Rim, turn: Turn::Equation3 }
    }
}

impl Options {
    fn factor(&self) -> f64 {
        match self.border {
            Border::Shrink(factor) => factor,
            Border::Extend | Border::ExtendX => 1.0,
        }
    }
}

/// Pictures of the sphere, a layer for each angle of the light: row 0 is at the bottom.
#[must_use]
pub fn samples(reflectance: &dyn Reflectance, angles: &[f64], size: usize, border: Border, exposure: f64) -> Samples {
    let at = |place: usize| 2.0 * (place as f64 + 0.5) / size as f64 - 1.0;
    let row = |row: usize| {
        let (light, of_row) = (Light::new(angles[row / size], 0.0), at(row % size));
        (0..size).map(move |column| {
            let (mut x, mut y) = (at(column), of_row);
            let r = sqrt(x * x + y * y);
            if r >= 1.0 {
                match border {
                    Border::Shrink(_) => return [0.0; 3],
                    Border::Extend => (x, y) = (x * RIM / r, y * RIM / r),
                    Border::ExtendX => {
                        y = y.clamp(-RIM, RIM);
                        x = sqrt(RIM * RIM - y * y).copysign(x);
                    }
                }
            }
            let z = sqrt((1.0 - x * x - y * y).max(0.0));
            reflectance.radiance(light, Vector::new(x, y, z), exposure).map(|value| value as f32)
        })
    };
    let rows: Vec<Vec<[f32; 3]>> = (0..angles.len() * size).into_par_iter().map(|place| row(place).collect()).collect();
    Samples { width: size, height: size, data: rows.concat() }
}

/// A look-up taken apart: the coefficient, the turned normals, the blend.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steps {
    /// k of equation 3, or what stands in its place.
    pub k: f64,
    /// The normal as the first image is asked for it, before anything is done at the rim.
    pub first: Vector,
    /// The same for the second image, where there is one.
    pub second: Option<Vector>,
    /// The weight of the second image.
    pub t: f64,
}

/// What a light has ready for every normal.
#[derive(Clone, Copy, Debug)]
pub(super) struct Setup {
    /// Sine and cosine of -γ.
    gamma: [f64; 2],
    /// x and z of the half vector of the plane of light and viewer.
    half: [f64; 2],
    layers: [usize; 2],
    /// Two images, or one with its turn.
    both: bool,
    /// The turns to the images in degrees.
    delta: [f64; 2],
    t: f64,
    /// Sine and cosine of the one image's turn.
    alone: [f64; 2],
    alone_k: f64,
}

pub(super) fn setup(angles: &[f64], options: &Options, light: Light) -> Setup {
    let pair = pair(angles, light.phi);
    let second = pair.second.unwrap_or(pair.first);
    let delta = [angles[pair.first] - light.phi, angles[second] - light.phi];
    let fixed = match options.turn {
        Turn::Equation3 => ALONE,
        Turn::Fixed(k) => k,
    };
    // At the image's own angle nothing is left to turn.
    let alone_k = if delta[0] == 0.0 { 1.0 } else { fixed };
    let [sine, cosine] = sine_cosine(0.5 * light.phi);
    Setup {
        gamma: sine_cosine(-light.gamma),
        half: [sine, cosine],
        layers: [pair.first, second],
        both: pair.second.is_some(),
        delta,
        t: pair.t,
        alone: sine_cosine(alone_k * delta[0]),
        alone_k,
    }
}

impl Setup {
    /// k of equation 3 for a normal turned back by γ.
    fn k(&self, options: &Options, n: Vector) -> f64 {
        if let Turn::Fixed(k) = options.turn {
            return k;
        }
        let length = sqrt(n.x * n.x + n.z * n.z);
        let [x, z] = self.half;
        // Past 90 degrees the angle is limited; without a part in the plane it is undefined, and k is 1.
        if length == 0.0 || n.x * x + n.z * z <= 0.0 {
            return 1.0;
        }
        0.5 + 0.5 * (n.x * z - n.z * x).abs() / length
    }

    pub(super) fn steps(&self, options: &Options, n: Vector) -> Steps {
        let n = about_z(n, self.gamma);
        if !self.both {
            return Steps { k: self.alone_k, first: about_y(n, self.alone), second: None, t: 0.0 };
        }
        let k = self.k(options, n);
        let turned = |delta: f64| about_y(n, sine_cosine(k * delta));
        Steps { k, first: turned(self.delta[0]), second: Some(turned(self.delta[1])), t: self.t }
    }
}

/// What the images give for a normal.
pub(super) fn at(texels: &Texels, options: &Options, setup: &Setup, n: Vector) -> Rgb {
    let steps = setup.steps(options, n);
    let code = |layer: usize, n: Vector| looked_up(texels, options, setup.layers[layer], n);
    let mut t = steps.t;
    if let (Behind::Skip, Some(second)) = (options.behind, steps.second) {
        match (steps.first.z < 0.0, second.z < 0.0) {
            (true, false) => t = 1.0,
            (false, true) => t = 0.0,
            _ => {}
        }
    }
    let weight = |layer: usize| texels.weight(setup.layers[layer]);
    let mut blend = code(0, steps.first).map(|code| (1.0 - t) * weight(0) * code);
    if let Some(second) = steps.second {
        let code = code(1, second);
        (0..3).for_each(|c| blend[c] += t * weight(1) * code[c]);
    }
    texels.value(blend)
}

/// The code of an image at a normal.
pub(super) fn looked_up(texels: &Texels, options: &Options, layer: usize, n: Vector) -> Rgb {
    let (mut x, mut y) = (n.x, n.y);
    if n.z < 0.0 && options.behind != Behind::Literal {
        let r = sqrt(x * x + y * y);
        // Straight away from the viewer no place of the rim is nearer than another.
        (x, y) = if r > 0.0 { (x / r, y / r) } else { (1.0, 0.0) };
    }
    let factor = options.factor();
    texels.bilinear(layer, 0.5 + 0.5 * factor * x, 0.5 + 0.5 * factor * y)
}

/// Normals taken at once: enough to fill vector registers, few enough to stay in the first cache.
const LANES: usize = 64;

/// The same for many normals in single precision, added to what is there.
#[multiversion(targets("x86_64+avx2", "x86_64+sse4.1", "aarch64+neon"))]
pub(super) fn add(
    texels: &Texels,
    options: &Options,
    setup: &Setup,
    intensity: f32,
    [xs, ys, zs]: [&[f32]; 3],
    out: &mut [[f32; 3]],
) {
    let (size, root) = (texels.width, texels.is_root());
    let [gamma, half, alone] = [setup.gamma, setup.half, setup.alone].map(|turn| turn.map(|value| value as f32));
    // Half of the turn in radians; sine and cosine of the whole follow from those of the half.
    let delta = setup.delta.map(|degrees| (0.5 * degrees.to_radians()) as f32);
    let weights = texels.weights(setup.layers, setup.t).map(|weight| weight as f32);
    let scale = 0.5 * (options.factor() * size as f64) as f32;
    let (middle, last) = (0.5 * size as f32 - 0.5, (size - 1) as f32);
    let fixed = if let Turn::Fixed(k) = options.turn { Some(k as f32) } else { None };
    let literal = options.behind == Behind::Literal;
    let images = if setup.both { 2 } else { 1 };
    let mut start = 0;
    while start < xs.len() {
        let lanes = LANES.min(xs.len() - start);
        let mut place = [[0u32; LANES]; 2];
        let mut across = [[0.0f32; LANES]; 2];
        let mut up = [[0.0f32; LANES]; 2];
        let mut behind = [[false; LANES]; 2];
        let (xs, ys, zs) = (&xs[start..][..lanes], &ys[start..][..lanes], &zs[start..][..lanes]);
        for image in 0..images {
            for lane in 0..lanes {
                let (x0, y0, z) = (xs[lane], ys[lane], zs[lane]);
                let (x, y) = (x0 * gamma[1] - y0 * gamma[0], x0 * gamma[0] + y0 * gamma[1]);
                let [sine, cosine] = if setup.both {
                    let length = (x * x + z * z).max(1e-30).sqrt();
                    let sine = (x * half[1] - z * half[0]).abs() / length;
                    let near = x * half[0] + z * half[1] > 0.0;
                    let k = fixed.unwrap_or(if near { 0.5 + 0.5 * sine } else { 1.0 });
                    sine_cosine_of_twice(k * delta[image])
                } else {
                    alone
                };
                let (nx, nz) = (x * cosine + z * sine, z * cosine - x * sine);
                let away = nz < 0.0;
                let r = (nx * nx + y * y).max(1e-30).sqrt();
                let factor = if away && !literal { scale / r } else { scale };
                let u = (middle + factor * nx).max(0.0).min(last);
                let v = (middle + factor * y).max(0.0).min(last);
                let (column, row) = (u.min(last - 1.0).max(0.0).floor(), v.min(last - 1.0).max(0.0).floor());
                place[image][lane] = row as u32 * size as u32 + column as u32;
                across[image][lane] = u - column;
                up[image][lane] = v - row;
                behind[image][lane] = away;
            }
        }
        for (lane, out) in out[start..][..lanes].iter_mut().enumerate() {
            let mut w = weights;
            if options.behind == Behind::Skip && setup.both && behind[0][lane] != behind[1][lane] {
                // The other takes the whole weight.
                let kept = usize::from(behind[0][lane]);
                w = [0.0; 2];
                w[kept] = texels.weight(setup.layers[kept]) as f32;
            }
            let mut sum = [0.0f32; 4];
            for image in 0..images {
                let texels = texels.layer(setup.layers[image]);
                let at = place[image][lane] as usize;
                let (s, t) = (across[image][lane], up[image][lane]);
                let rows = [&texels[at..][..2], &texels[at + size..][..2]];
                for c in 0..4 {
                    let low = rows[0][0][c] + s * (rows[0][1][c] - rows[0][0][c]);
                    let high = rows[1][0][c] + s * (rows[1][1][c] - rows[1][0][c]);
                    sum[c] += w[image] * (low + t * (high - low));
                }
            }
            for c in 0..3 {
                out[c] += intensity * if root { sum[c] * sum[c] } else { sum[c] };
            }
        }
        start += lanes;
    }
}

/// Sine and cosine of 2a for |a| up to π/2, to about 1e-7.
#[inline(always)]
fn sine_cosine_of_twice(a: f32) -> [f32; 2] {
    let z = a * a;
    let sine = a
        * (1.0
            + z * (-1.0 / 6.0
                + z * (1.0 / 120.0 + z * (-1.0 / 5040.0 + z * (1.0 / 362_880.0 - z * (1.0 / 39_916_800.0))))));
    let cosine = 1.0
        + z * (-0.5
            + z * (1.0 / 24.0
                + z * (-1.0 / 720.0 + z * (1.0 / 40_320.0 + z * (-1.0 / 3_628_800.0 + z * (1.0 / 479_001_600.0))))));
    [2.0 * sine * cosine, 1.0 - 2.0 * sine * sine]
}
