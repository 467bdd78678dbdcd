//! Samples of a shader in real numbers.

use crate::block::shader::datapath::{COLOURS, colour_places};
use crate::core::ShaderDesign;
use crate::fixed::{Field, Format, Rng, exp2};
use crate::spec::{Colour, Cosine, LightColours, Shader};

/// A vector in space.
pub type Vector = [f64; 3];

/// A light of a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// L, the direction to it.
    pub direction: Vector,
    /// H, halfway between L and the viewer.
    pub half: Vector,
    /// Its colour, where that comes from a port.
    pub colour: Colour,
}

/// A sample: a point of a surface, seen and lit.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// The code of `in_material`.
    pub material: u32,
    /// N.
    pub normal: Vector,
    /// V, the direction to the viewer.
    pub viewer: Vector,
    /// The lights.
    pub lights: Vec<Light>,
}

/// The real cosines of a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angles {
    /// N.L in [0, 1].
    pub diffuse: f64,
    /// The versine of the highlight's cosine, in [0, 1]; 1 where the light is behind the surface.
    pub versine: f64,
}

/// The scalar product.
pub(crate) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// a, and b so many times.
pub(crate) fn plus(a: Vector, b: Vector, times: f64) -> Vector {
    [0, 1, 2].map(|axis| a[axis] + times * b[axis])
}

/// a - b.
pub(crate) fn minus(a: Vector, b: Vector) -> Vector {
    plus(a, b, -1.0)
}

/// The vector product.
pub(crate) fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The vector with this direction and the length 1; z where it has no direction.
#[must_use]
pub fn normalised(a: Vector) -> Vector {
    let length = libm::sqrt(dot(a, a));
    if length < 1e-9 { [0.0, 0.0, 1.0] } else { a.map(|component| component / length) }
}

/// A direction, each as likely as any other.
pub(crate) fn random_direction(rng: &mut Rng) -> Vector {
    let z = 2.0 * rng.unit() - 1.0;
    let angle = 2.0 * std::f64::consts::PI * rng.unit();
    let r = libm::sqrt((1.0 - z * z).max(0.0));
    [r * libm::cos(angle), r * libm::sin(angle), z]
}

/// The direction or its mirror image, whichever is in front of the surface with this normal.
pub(crate) fn front(direction: Vector, normal: Vector) -> Vector {
    let cosine = dot(direction, normal);
    if cosine < 0.0 { plus(direction, normal, -2.0 * cosine) } else { direction }
}

impl Sample {
    /// A sample of these directions, with white lights.
    #[must_use]
    pub fn of(material: u32, normal: Vector, viewer: Vector, lights: &[Vector]) -> Self {
        let light =
            |&direction: &Vector| Light { direction, half: normalised(plus(direction, viewer, 1.0)), colour: [1.0; 3] };
        Self { material, normal, viewer, lights: lights.iter().map(light).collect() }
    }

    /// A random sample that a camera may see: the viewer in front of the surface, half of the lights anywhere in front
    /// of it and some behind, the other half where their mirror images are near the viewer, as near as the highlight of
    /// `shininess` is wide.
    #[must_use]
    pub fn random(shader: &Shader, material: u32, shininess: f64, rng: &mut Rng) -> Self {
        let normal = random_direction(rng);
        let viewer = front(random_direction(rng), normal);
        Self::seen(shader, material, shininess, normal, viewer, rng)
    }

    /// The same for a given normal and a given viewer.
    #[must_use]
    pub fn seen(shader: &Shader, material: u32, shininess: f64, normal: Vector, viewer: Vector, rng: &mut Rng) -> Self {
        let mirrored = plus(normal.map(|c| 2.0 * dot(normal, viewer) * c), viewer, -1.0);
        let lights: Vec<Vector> = (0..shader.lights)
            .map(|_| {
                let anywhere = random_direction(rng);
                match rng.below(8) {
                    0 => anywhere,
                    1..=3 => front(anywhere, normal),
                    _ => {
                        let spread = 2.0 * rng.unit() / libm::sqrt(shininess);
                        normalised(plus(mirrored, anywhere, spread))
                    }
                }
            })
            .collect();
        let mut sample = Self::of(material, normal, viewer, &lights);
        if shader.light_colours == LightColours::Ports {
            let full = shader.full_scale();
            for light in &mut sample.lights {
                light.colour = [(); 3].map(|()| rng.below(full as u64 + 1) as f64 / full as f64);
            }
        }
        sample
    }

    /// The codes of the input ports: the nearest to each number.
    #[must_use]
    pub fn codes(&self, shader: &Shader) -> Vec<i64> {
        let near = |value: f64, scale: f64| libm::round(value * scale) as i64;
        let vector = |v: Vector| v.map(|component| near(component, exp2(shader.vector_fraction as i32)));
        let mut codes = vec![self.material.into()];
        codes.extend(vector(self.normal));
        if shader.cosine != Cosine::Half {
            codes.extend(vector(self.viewer));
        }
        for light in &self.lights {
            codes.extend(vector(light.direction));
            if shader.cosine == Cosine::Half {
                codes.extend(vector(light.half));
            }
            if shader.light_colours == LightColours::Ports {
                codes.extend(light.colour.map(|channel| near(channel, shader.full_scale() as f64)));
            }
        }
        codes
    }

    /// The sample with every number taken to the value of its nearest code.
    #[must_use]
    pub fn quantised(&self, shader: &Shader) -> Self {
        let scale = exp2(shader.vector_fraction as i32);
        let near = |v: Vector| v.map(|component| libm::round(component * scale) / scale);
        let light =
            |light: &Light| Light { direction: near(light.direction), half: near(light.half), colour: light.colour };
        Self {
            material: self.material,
            normal: near(self.normal),
            viewer: near(self.viewer),
            lights: self.lights.iter().map(light).collect(),
        }
    }

    /// The real cosines of each light.
    #[must_use]
    pub fn angles(&self, shader: &Shader) -> Vec<Angles> {
        let of = |light: &Light| {
            let nl = dot(self.normal, light.direction).clamp(0.0, 1.0);
            let (nv, lv) = (dot(self.normal, self.viewer), dot(light.direction, self.viewer));
            let versine = match shader.cosine {
                Cosine::Mirror => 1.0 - (2.0 * nl * nv - lv),
                Cosine::Half => {
                    let d = plus(self.normal, light.half, -1.0);
                    dot(d, d) / 2.0
                }
                Cosine::Sqrt => 1.0 - (nl + nv).max(0.0) / libm::sqrt((2.0 + 2.0 * lv).max(1e-300)),
            };
            Angles { diffuse: nl, versine: if nl > 0.0 { versine.clamp(0.0, 1.0) } else { 1.0 } }
        };
        self.lights.iter().map(of).collect()
    }

    /// The channels in codes, not rounded, for these diffuse cosines and highlights a light, with the colours that
    /// `value` takes from a field of the ROM at a row.
    #[must_use]
    pub fn channels(
        &self,
        design: ShaderDesign<'_>,
        lights: &[(f64, f64)],
        value: impl Fn(&Field, usize) -> f64,
    ) -> [f64; 3] {
        let table = design.tables().iter().find(|table| table.name == COLOURS).expect("a shader's colours");
        let shader = design.shader;
        let row = design.lobe.interface.shininess.row_of_index(self.material);
        let scale = exp2(shader.channel_bits as i32);
        [0, 1, 2].map(|channel| {
            let read = |place: usize| value(&table.fields[place], row);
            let mut sum = read(colour_places(shader, channel, 0)[0]);
            for (light, &(diffuse, highlight)) in lights.iter().enumerate() {
                let [_, k_d, k_s] = colour_places(shader, channel, light);
                let both = read(k_d) * diffuse + read(k_s) * highlight;
                sum += match shader.light_colours {
                    LightColours::Fixed(_) => both,
                    LightColours::Ports => {
                        both * self.lights[light].colour[channel] * shader.full_scale() as f64 / scale
                    }
                };
            }
            (sum * scale).clamp(0.0, shader.full_scale() as f64)
        })
    }
}

/// Random codes at every input port: vectors of any length, any colours, any material.
#[must_use]
pub fn random_codes(ports: &[(&str, Format)], rng: &mut Rng) -> Vec<i64> {
    let code = |&(_, format): &(&str, Format)| {
        let count = 1u64 << format.width();
        format.min_code() as i64 + rng.below(count) as i64
    };
    ports.iter().map(code).collect()
}
