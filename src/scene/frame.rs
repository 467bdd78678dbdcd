//! A picture as the lobes that it asks for, and with their values as codes of its channels.

use nalgebra::Vector3;
use rayon::prelude::*;

use super::ray::{across, unit};
use super::reflectance::{Axes, Looks, Sight};
use super::trace::{Hit, Lit, Tracer};
use super::{Camera, Light, LightKind, Scene};
use crate::core::sample::Vector;
use crate::spec::{Colour, Model, Surface};

/// The material of a pixel that shows no object.
pub const BACKGROUND: u16 = u16::MAX;

/// A picture before its highlights: what each pixel shows, and which lobes it asks for.
///
/// A channel is `base + sum over the lights of k_s I x^n`, in units of full scale, clamped to [0, 1] and rounded to the
/// nearest code.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Pixels a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// The number of lights; 0 where every material is drawn by its reflectance and none has a highlight.
    pub lights: usize,
    /// The material of each pixel, row by row from the top, as its place in [`Scene::materials`]; [`BACKGROUND`] where
    /// there is none.
    pub material: Vec<u16>,
    /// Ambient and diffuse light of each pixel in units of full scale, 0 or more; of the background its colour; of a
    /// material that is drawn by its reflectance the ambient light alone: [`reflectance`](super::reflectance) adds the
    /// rest.
    pub base: Vec<Colour>,
    /// The versine `u = 1 - x` of the highlight for each pixel and, within it, each light: 0 to 2, above 1 where the
    /// cosine x is negative; NaN where the light gives no highlight: it is behind the surface or in shadow, or there is
    /// no object.
    pub versine: Vec<f64>,
}

/// A picture as it leaves the shader: codes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Pixels a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Bits of a channel; full scale is `2^bits - 1`.
    pub channel_bits: u32,
    /// Red, green and blue of each pixel, row by row from the top.
    pub codes: Vec<[u16; 3]>,
}

/// The greatest code of a channel.
pub(super) fn full_scale(channel_bits: u32) -> f64 {
    f64::from((1u32 << channel_bits) - 1)
}

/// The versine of a highlight's cosine, from 0 to 2 and without cancellation, for directions of length 1: half the
/// square of the distance between V and the mirrored light `R = 2 (N.L) N - L` (B. T. Phong, "Illumination for computer
/// generated pictures", 1975), or between N and H (J. F. Blinn, "Models of light reflection for computer synthesized
/// pictures", 1977).
///
/// It is computed as it is also where interpolation has turned N away from the viewer; it may exceed 1 there as
/// anywhere else.
#[must_use]
pub fn versine(model: Model, normal: Vector, viewer: Vector, direction: Vector, half: Vector) -> f64 {
    let normal = Vector3::from(normal);
    let apart = match model {
        Model::Phong => {
            let direction = Vector3::from(direction);
            let mirrored = normal * (2.0 * normal.dot(&direction)) - direction;
            // Its length is 1 but for the rounding, and but for that of N's length, which would move the highlight's
            // middle.
            Vector3::from(viewer) - unit(mirrored).unwrap_or(normal)
        }
        Model::Blinn => normal - Vector3::from(half),
    };
    (apart.dot(&apart) / 2.0).min(2.0)
}

impl Frame {
    /// Renders a scene but for its highlights, with one sample in the middle of each pixel. `done` is called once a
    /// row.
    ///
    /// The result does not depend on the number of threads.
    #[must_use]
    pub fn render(scene: &Scene, done: &(dyn Fn() + Sync)) -> Self {
        Self::trace(&Tracer::new(scene), scene, done)
    }

    /// The same with a tracer that was made of a scene with the same objects, such as the same scene before its camera
    /// or a light moved.
    #[must_use]
    pub fn trace(tracer: &Tracer, scene: &Scene, done: &(dyn Fn() + Sync)) -> Self {
        Self::with_looks(tracer, scene, &[], done).0
    }

    /// The same, and for each of some looks [`Frame::base`] with the light added that materials give by their
    /// reflectances.
    #[must_use]
    pub fn with_looks(
        tracer: &Tracer,
        scene: &Scene,
        looks: &[Looks],
        done: &(dyn Fn() + Sync),
    ) -> (Self, Vec<Vec<Colour>>) {
        // Where no material has a highlight there is nothing to be said of any light.
        let lights = if scene.has_highlights() { scene.lights.len() } else { 0 };
        let width = scene.width as usize;
        let surfaces: Vec<Surface> = scene.materials.iter().map(|material| material.surface()).collect();
        let axes = Axes::of(scene);
        let of_row = |row: u32| {
            let mut material = vec![BACKGROUND; width];
            let mut base = vec![scene.background; width];
            let mut versines = vec![f64::NAN; width * lights];
            let mut looked = vec![base.clone(); looks.len()];
            for (x, hit) in tracer.row(scene, row).into_iter().enumerate() {
                let Some(hit) = hit else { continue };
                material[x] = u16::try_from(hit.material).expect("materials are few");
                let surface = &surfaces[hit.material];
                let mut sum = [0, 1, 2].map(|c| scene.ambient[c] * surface.ambient[c]);
                if scene.reflectance(hit.material).is_none() {
                    for (light, versine) in versines[x * lights..][..lights].iter_mut().enumerate() {
                        let lit = tracer.light(scene, &hit, light);
                        if lit.visible {
                            let colour = scene.lights[light].colour;
                            sum = [0, 1, 2].map(|c| sum[c] + colour[c] * surface.diffuse[c] * lit.cosine);
                            *versine = of_light(scene.model, &hit, &lit);
                        }
                    }
                }
                base[x] = sum;
                looked.iter_mut().for_each(|row| row[x] = sum);
                if !looks.is_empty() && scene.reflectance(hit.material).is_some() {
                    let sight = Sight::of(tracer, scene, &hit);
                    for (row, looks) in looked.iter_mut().zip(looks) {
                        let own = looks.of[hit.material].as_ref().map(|look| look.radiance(&axes, &sight));
                        row[x] = own.map_or(sum, |own| [0, 1, 2].map(|c| sum[c] + own[c]));
                    }
                }
            }
            done();
            (material, base, versines, looked)
        };
        let rows: Vec<_> = (0..scene.height).into_par_iter().map(of_row).collect();
        let pixels = width * scene.height as usize;
        let mut frame = Self {
            width: scene.width,
            height: scene.height,
            lights,
            material: Vec::with_capacity(pixels),
            base: Vec::with_capacity(pixels),
            versine: Vec::with_capacity(pixels * lights),
        };
        let mut bases = vec![Vec::with_capacity(pixels); looks.len()];
        for (material, base, versines, looked) in rows {
            frame.material.extend(material);
            frame.base.extend(base);
            frame.versine.extend(versines);
            bases.iter_mut().zip(looked).for_each(|(base, row)| base.extend(row));
        }
        (frame, bases)
    }

    /// How many values of a lobe the picture asks for.
    #[must_use]
    pub fn samples(&self) -> u64 {
        self.versine.iter().filter(|versine| !versine.is_nan()).count() as u64
    }

    /// `k_s I` of each material and, within it, light.
    pub(super) fn weights(&self, scene: &Scene) -> Vec<Vec<Colour>> {
        (0..scene.materials.len()).map(|m| (0..self.lights).map(|l| scene.specular(m, l)).collect()).collect()
    }

    /// The channels in units of full scale: `base`, which is [`Frame::base`] or that of a look, with these values of
    /// the lobes, one a pixel and light, each 0 to 1; those of NaN versines are not looked at. What exceeds full scale
    /// is not cut off yet.
    #[must_use]
    pub fn channels(&self, scene: &Scene, base: &[Colour], highlights: &[f64]) -> Vec<Colour> {
        let weights = self.weights(scene);
        let pixel = |index: usize| {
            let mut sum = base[index];
            if self.material[index] != BACKGROUND {
                let of_material = &weights[usize::from(self.material[index])];
                for (light, weight) in of_material.iter().enumerate() {
                    let sample = index * self.lights + light;
                    if !self.versine[sample].is_nan() {
                        sum = [0, 1, 2].map(|c| sum[c] + weight[c] * highlights[sample]);
                    }
                }
            }
            sum
        };
        (0..self.material.len()).into_par_iter().map(pixel).collect()
    }

    /// The picture with these values of the lobes, as [`Frame::channels`] takes them.
    #[must_use]
    pub fn picture(&self, scene: &Scene, highlights: &[f64]) -> Picture {
        self.codes(scene.channel_bits, &self.channels(scene, &self.base, highlights))
    }

    /// The picture of these channels in units of full scale, clamped to [0, 1] and rounded to the nearest code.
    #[must_use]
    pub fn codes(&self, channel_bits: u32, channels: &[Colour]) -> Picture {
        let full = full_scale(channel_bits);
        let code = |channel: f64| libm::round(channel.clamp(0.0, 1.0) * full) as u16;
        let codes = channels.par_iter().map(|pixel| pixel.map(code)).collect();
        Picture { width: self.width, height: self.height, channel_bits, codes }
    }
}

fn of_light(model: Model, hit: &Hit, lit: &Lit) -> f64 {
    versine(model, hit.normal, hit.viewer, lit.direction, lit.half)
}

/// The directions across a way, to the right and up, as a camera has them that looks back along the way.
fn aside(way: Vector3<f64>, up: Vector) -> [Vector3<f64>; 2] {
    let right = unit(Vector3::from(up).cross(&way)).unwrap_or_else(|| across(way));
    [right, way.cross(&right)]
}

impl Scene {
    /// The scene with its camera and each of its lights moved by an angle, one at a time, with the names of the moves.
    ///
    /// The camera orbits its target: up, down, left and right as it sees them, and in the four directions between
    /// these; its own up turns with it. Each light moves up, down, left and right as one sees it who looks at it with
    /// the camera's up: a directional light turns, a point light orbits the camera's target (one at the target stays
    /// where it is, and is left out). Distances are kept. There are no moves by 0 degrees.
    #[must_use]
    pub fn moved(&self, margin_degrees: f64) -> Vec<(String, Self)> {
        if margin_degrees == 0.0 {
            return Vec::new();
        }
        let (sine, cosine) = libm::sincos(margin_degrees.to_radians());
        let turned = |from: Vector3<f64>, to: Vector3<f64>| from * cosine + to * sine;
        let diagonal = std::f64::consts::FRAC_1_SQRT_2;
        let moves = [
            ("up", [0.0, 1.0]),
            ("down", [0.0, -1.0]),
            ("left", [-1.0, 0.0]),
            ("right", [1.0, 0.0]),
            ("up and left", [-diagonal, diagonal]),
            ("up and right", [diagonal, diagonal]),
            ("down and left", [-diagonal, -diagonal]),
            ("down and right", [diagonal, -diagonal]),
        ];
        let mut scenes = Vec::new();
        let [right, up, ahead] = self.camera.axes().map(Vector3::from);
        let target = Vector3::from(self.camera.target);
        let distance = (Vector3::from(self.camera.position) - target).norm();
        for (name, [x, y]) in moves {
            let towards = right * x + up * y;
            let position = target + turned(-ahead, towards) * distance;
            // Of the camera's up, only the part in the plane of the turn moves.
            let up = up + turned(towards, ahead) * y - towards * y;
            let camera = Camera { position: position.into(), up: up.into(), ..self.camera };
            scenes.push((format!("camera {name}"), Self { camera, ..self.clone() }));
        }
        for (number, light) in self.lights.iter().enumerate() {
            let (way, distance) = match light.kind {
                LightKind::Directional(direction) => (Vector3::from(direction), 1.0),
                LightKind::Point(place) => (Vector3::from(place) - target, (Vector3::from(place) - target).norm()),
            };
            let Some(way) = unit(way) else { continue };
            let [right, up] = aside(way, up.into());
            for (name, [x, y]) in &moves[..4] {
                let way = turned(way, right * *x + up * *y);
                let kind = match light.kind {
                    LightKind::Directional(_) => LightKind::Directional(way.into()),
                    LightKind::Point(_) => LightKind::Point((target + way * distance).into()),
                };
                let mut scene = self.clone();
                scene.lights[number] = Light { kind, ..*light };
                scenes.push((format!("light {} {name}", number + 1), scene));
            }
        }
        scenes
    }

    /// The greatest code of a channel.
    #[must_use]
    pub fn full_scale(&self) -> f64 {
        full_scale(self.channel_bits)
    }

    /// The scene as a picture of another size.
    #[must_use]
    pub fn resized(&self, width: u32, height: u32) -> Self {
        Self { width, height, ..self.clone() }
    }

    /// `k_s I` of a material under a light, a channel: what its highlight is multiplied by.
    #[must_use]
    pub fn specular(&self, material: usize, light: usize) -> Colour {
        let surface = self.materials[material].surface();
        [0, 1, 2].map(|c| surface.specular[c] * self.lights[light].colour[c])
    }
}
