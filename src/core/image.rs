//! The image-based block that a core is, and where its error comes from.

use std::ops::Deref;

use rayon::prelude::*;
use serde::Serialize;

use super::lights::{code_meanings, sum_meanings};
use super::{Design, Part};
use crate::block::image::quality::{MATCAP_SIZE, SIZE, STEP, turned};
use crate::block::image::{
    FrontEnd, Image, ImageBlock, ImageForm, ImageModel, ImageSource, ImageSpec, Joints, Places, RealLight, RealTexels,
};
use crate::fixed::exp2;
use crate::reflectance::measure::{self, Quality, Sphere};
use crate::reflectance::{Light, Reflectance, Rgb, Vector};

/// An image-based block; what is the whole core's is reached through it.
#[derive(Clone, Copy, Debug)]
pub struct ImageDesign<'a> {
    design: &'a Design,
    /// What was asked for of it.
    pub of: &'a ImageSpec,
    /// Its texels and widths.
    pub block: &'a ImageBlock,
    /// The joints of its datapath.
    pub joints: &'a Joints,
}

impl Deref for ImageDesign<'_> {
    type Target = Design;

    fn deref(&self) -> &Design {
        self.design
    }
}

impl<'a> ImageDesign<'a> {
    pub(super) fn new(design: &'a Design, of: &'a ImageSpec, block: &'a ImageBlock, joints: &'a Joints) -> Self {
        Self { design, of, block, joints }
    }

    /// The core that it is.
    #[must_use]
    pub fn core(self) -> &'a Design {
        self.design
    }

    /// The bit-exact reference.
    #[must_use]
    pub fn model(self) -> ImageModel<'a> {
        self.block.model()
    }

    /// The codes of a unit vector.
    #[must_use]
    pub fn vector(self, v: Vector) -> [i64; 3] {
        self.block.vector(v)
    }

    /// What each input port that carries numbers is for, in the order in which the ports are made.
    pub(super) fn input_meanings(self) -> Vec<String> {
        let image = &self.of.image;
        let axes = ["x", "y", "z"];
        let of_normal = axes[..image.normal_axes()].iter();
        let mut meanings: Vec<String> =
            of_normal.map(|axis| format!("{axis} of the unit normal, the viewer at +z")).collect();
        for light in 1..=image.lights {
            if image.has_incidence() {
                meanings.extend(axes.map(|axis| format!("{axis} of the unit vector to light {light}")));
            }
            let colours = ["red", "green", "blue"];
            if image.front_end == FrontEnd::Vector {
                meanings.extend(colours.map(|colour| format!("{colour} of light {light}'s intensity, at most 1")));
                continue;
            }
            meanings.extend(match image.form {
                ImageForm::Bivariate { .. } => {
                    axes.map(|axis| format!("{axis} of light {light}'s half vector")).to_vec()
                }
                ImageForm::Half { .. } | ImageForm::Paper { .. } => {
                    let row = |row, axis| format!("{axis} of row {row} of the turn to light {light}'s half vector");
                    [(1, "x"), (1, "y"), (1, "z"), (2, "x"), (2, "y")].map(|(number, axis)| row(number, axis)).to_vec()
                }
                ImageForm::Matcap => Vec::new(),
            });
            let band = match image.form {
                ImageForm::Bivariate { .. } => "row",
                ImageForm::Half { .. } => "slice",
                ImageForm::Paper { .. } | ImageForm::Matcap => "image",
            };
            meanings.push(format!("{band} of texels below light {light}'s angle"));
            meanings.push(format!("weight of the odd one of this {band} and the next, at most 1"));
            if image.has_turns() {
                let half =
                    |parity| format!("half of the way from light {light} to its {parity} image, in right angles");
                meanings.extend(["even", "odd"].map(half));
                meanings.push(format!("1 where a single image is looked up for light {light}"));
            }
            if self.block.widths().shift > 0 {
                meanings.push(format!("exponent of light {light}'s gain"));
            }
            meanings.extend(colours.map(|colour| format!("{colour} of light {light}'s gain")));
        }
        meanings
    }

    /// What each output port that carries numbers is for, in order.
    pub(super) fn output_meanings(self) -> Vec<String> {
        let codes = || code_meanings(self.of.image.channel_bits);
        self.block.sums().as_ref().map_or_else(codes, sum_meanings)
    }

    /// The inputs of a normal and of a light each, in the form matcap of the normal alone; lights that are missing give
    /// nothing.
    #[must_use]
    pub fn inputs(self, n: Vector, lights: &[(Light, Rgb)]) -> Vec<i64> {
        self.block.inputs(n, lights)
    }

    /// The codes of the channels of a sample of one clock.
    #[must_use]
    pub fn shown(self, inputs: &[i64]) -> Vec<i64> {
        self.block.shown(inputs)
    }

    /// How well the core's pictures of a sphere, with one light of intensity 1, meet those of a reflectance.
    #[must_use]
    pub fn quality(self, reflectance: &dyn Reflectance) -> Quality {
        self.block.quality(reflectance, self.of.exposure)
    }
}

/// The error account of an image-based block: against the reflectance of its model or, of a block that is made of a
/// file, against the stored samples of it, interpolated exactly. A matcap is measured without a light.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ImageError {
    /// The angles of the light that pictures of a sphere are drawn at; 1 of a matcap.
    pub angles: usize,
    /// The samples measured: the pictures' pixels.
    pub samples: u64,
    /// Whether it is the stored samples that all is measured against.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub of_samples: bool,
    /// The pictures' signal-to-noise ratios against exact ones.
    pub quality: Quality,
    /// The parts, each switched from exact to what the hardware does with all before it switched already; they add up,
    /// sample by sample, to the whole.
    pub parts: Vec<Part>,
    /// `hardware - exact`.
    pub whole: Part,
}

/// How many parts there are at most.
const PARTS: usize = 6;

/// The parts in their order, each with its meaning; `None` where a core has no such part, of which then nothing comes.
fn parts(image: &Image, of_samples: bool) -> [(&'static str, Option<&'static str>); PARTS] {
    let [ports, record] = match image.front_end {
        FrontEnd::Record if !image.has_lights() => ["x and y of the normal rounded to their ports", ""],
        FrontEnd::Record => ["the normal and the light's record rounded to their ports", ""],
        FrontEnd::Vector => {
            ["the normal and the vector to the light rounded to their ports", "the light's record as it is computed"]
        }
    };
    [
        // Samples of a file are what there is to be met.
        ("method", (!of_samples).then_some("texels in place of the reflectance, blended")),
        ("texels", Some("rounded to codes of their roots")),
        ("ports", Some(ports)),
        ("front end", (image.front_end == FrontEnd::Vector).then_some(record)),
        ("weights", Some("the places between texels rounded to the weights' last bit")),
        ("arithmetic", Some("the roundings behind them, the output's among them")),
    ]
}

/// Least, greatest, squares.
type Sums = [f64; 3];

impl ImageError {
    /// What all is measured against, in words.
    #[must_use]
    pub fn exact(&self) -> &'static str {
        if self.of_samples { "the stored samples" } else { "the exact reflectance" }
    }

    /// Measures a block over pictures of a sphere with one light of intensity 1, or of a matcap over one without.
    #[must_use]
    pub fn of(design: ImageDesign<'_>) -> Self {
        let image = &design.of.image;
        let (size, angles) = match image.has_lights() {
            true => (SIZE, measure::angles(STEP)),
            // All texels are seen, and between them what are no multiples of a weight.
            false => ((2 * image.size as usize + 1).clamp(65, MATCAP_SIZE), vec![0.0]),
        };
        Self::over(design, &Sphere::new(size), &angles)
    }

    /// As [`ImageError::of`], over these pictures: the light at each of the polar angles in degrees.
    #[must_use]
    pub fn over(design: ImageDesign<'_>, sphere: &Sphere, angles: &[f64]) -> Self {
        let image = &design.of.image;
        let full = image.full_scale() as f64;
        let ImageSpec { source, exposure, .. } = design.of;
        let of_angle = |&phi: &f64| {
            let light = turned(phi);
            let mut inputs = design.inputs(Vector::z(), &[(light, [1.0; 3])]);
            let [real, told, made] = if image.has_lights() {
                let codes = &inputs[3..3 + design.light_ports().len()];
                let made = design.block.light_of(&design.model().record(codes));
                [design.block.real_light(light, [1.0; 3]), design.block.told_light(codes), made]
            } else {
                [(); 3].map(|()| RealLight::none())
            };
            let mut errors = [[f64::INFINITY, f64::NEG_INFINITY, 0.0]; PARTS + 1];
            let mut pictures = [Vec::new(), Vec::new()];
            for &n in &sphere.normals {
                let codes = design.vector(n);
                let lsb = exp2(-(image.vector_fraction as i32));
                let near = Vector::new(codes[0] as f64 * lsb, codes[1] as f64 * lsb, codes[2] as f64 * lsb);
                inputs[..image.normal_axes()].copy_from_slice(&codes[..image.normal_axes()]);
                let hardware = design.shown(&inputs);
                let shown = |value: Rgb| value.map(|channel| (channel * full).clamp(0.0, full));
                let interpolated = design.block.real(n, &real, RealTexels::Exact, Places::Exact);
                let exact = match source {
                    ImageSource::Model(model) => model.radiance(light, n, *exposure),
                    ImageSource::Samples(_) => interpolated,
                };
                let stages = [
                    shown(exact),
                    shown(interpolated),
                    shown(design.block.real(n, &real, RealTexels::Stored, Places::Exact)),
                    shown(design.block.real(near, &told, RealTexels::Stored, Places::Exact)),
                    shown(design.block.real(near, &made, RealTexels::Stored, Places::Exact)),
                    shown(design.block.real(near, &made, RealTexels::Stored, Places::Rounded)),
                    [0, 1, 2].map(|channel| hardware[channel] as f64),
                ];
                for channel in [0, 1, 2] {
                    for (part, sum) in errors.iter_mut().enumerate() {
                        let (from, to) = if part < PARTS { (part, part + 1) } else { (0, PARTS) };
                        let error = stages[to][channel] - stages[from][channel];
                        *sum = [sum[0].min(error), sum[1].max(error), sum[2] + error * error];
                    }
                }
                pictures[0].push(stages[0].map(|code| (code / full) as f32));
                pictures[1].push(stages[PARTS].map(|code| (code / full) as f32));
            }
            (errors, (phi, measure::psnr(&pictures[0], &pictures[1])))
        };
        let by_angle: Vec<([Sums; PARTS + 1], (f64, f64))> = angles.par_iter().map(of_angle).collect();
        let samples = (angles.len() * sphere.normals.len()) as u64;
        // In order, so that the figures are the same on every machine.
        let part = |index: usize, (name, meaning): (&'static str, &'static str)| {
            let each = by_angle.iter().map(|(errors, _)| errors[index]);
            let total = each.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1]), a[2] + b[2]]);
            let [low, high, square] = total.unwrap_or_default();
            Part { name, meaning, codes: [low, high], rms: libm::sqrt(square / (3 * samples) as f64) }
        };
        let of_samples = source.model().is_none();
        Self {
            angles: angles.len(),
            samples,
            of_samples,
            quality: Quality::of(by_angle.iter().map(|(_, ratio)| *ratio).collect()),
            parts: parts(image, of_samples)
                .into_iter()
                .enumerate()
                .filter_map(|(index, (name, meaning))| meaning.map(|meaning| part(index, (name, meaning))))
                .collect(),
            whole: part(PARTS, ("whole", "hardware - exact")),
        }
    }
}
