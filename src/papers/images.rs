//! What "Image-based BRDF Representation" (A. Mihálik, R. Ďurikovič) claims of its method, measured as
//! [`crate::reflectance::measure`] has it.
//!
//! No measured table comes with the program: the materials are the presets of [`Model`], named for those of the paper's
//! figures.

use std::sync::Arc;
use std::time::Instant;

use super::{Claim, Figure, Finding, Unit};
use crate::emit::package::File;
use crate::platform::error::Error;
use crate::reflectance::measure::{self, Judge, Sphere};
use crate::reflectance::paper::{Border, Options, Turn};
use crate::reflectance::{Form, FormKind, FormSpec, Light, Model, Texel, Vector, images};
use crate::scene::mesh::{Mesh, Normals};
use crate::scene::{Object, Scene, Shape, Tracer, reflectance};

/// The PSNR in the mean over the light's angles from which images are taken to suffice: a root mean square difference
/// of 1 in 56, 4.5 steps of 8 bits.
const SUFFICES: f64 = 35.0;
/// Pixels along a side of the spheres that are compared.
const PIXELS: usize = 96;
/// The size of the paper's images.
const SIZE: usize = 512;
/// The light of figure 4, between the images at 45 and 90 degrees.
const PHI: f64 = 60.0;

fn decibel(name: &'static str, value: f64) -> Figure {
    Figure { name, value, unit: Unit::Decibel }
}

/// The paper's form with images of 512² as floating-point numbers.
fn paper(images: usize, size: usize, options: Options) -> FormSpec {
    FormSpec { options, ..FormSpec::sized(FormKind::Paper, images, size, Texel::Float) }
}

/// A material with its exposure and exact pictures.
struct Judged {
    model: Model,
    exposure: f64,
    judge: Judge,
}

impl Judged {
    fn new(model: Model) -> Self {
        let exposure = measure::exposure(&model);
        let judge = Judge::new(&model, exposure, &measure::angles(5.0), PIXELS);
        Self { model, exposure, judge }
    }

    fn named(name: &str) -> Result<Self, Error> {
        Ok(Self::new(Model::named(name)?))
    }

    fn form(&self, spec: &FormSpec) -> Result<Form, Error> {
        spec.build(&self.model, self.exposure)
    }

    fn mean(&self, spec: &FormSpec) -> Result<f64, Error> {
        Ok(self.judge.quality(&self.form(spec)?).mean)
    }

    /// The mean over the angles between images of the paper's set of 4.
    fn between(&self, form: &Form) -> f64 {
        self.judge.quality(form).mean_within(0.0..=135.0)
    }
}

/// The shiny plastic of figure 4: Blinn and Phong's model with n = 60.
fn plastic() -> Result<Model, Error> {
    Model::named("blinnphong")
}

/// The four parts of figure 4, a to d, of a material: the same images, looked up in four ways.
fn parts(model: &Model, exposure: f64) -> Result<[Form; 4], Error> {
    let of = |turn, border| Options { turn, border, ..Options::default() };
    let border = Options::default().border;
    let all = [
        of(Turn::Fixed(1.0), border),
        of(Turn::Fixed(0.5), border),
        of(Turn::Equation3, border),
        of(Turn::Equation3, Border::Shrink(1.0)),
    ];
    let samples = paper(4, SIZE, all[0]).samples(model, exposure)?;
    Ok(all.map(|options| paper(4, SIZE, options).encode(&samples, exposure)))
}

/// The peaks of the blue channel along the plane of light and viewer, which is that of the highlight of a yellow
/// plastic: each higher by a fiftieth of full scale than the valleys beside it.
fn peaks(form: &Form) -> usize {
    let value = |step: i32| {
        let angle = f64::from(step).to_radians() / 10.0;
        form.at(Light::new(PHI, 0.0), Vector::new(libm::sin(angle), 0.0, libm::cos(angle)))[2]
    };
    let (mut count, mut rising, mut turn) = (0, false, value(-250));
    for value in (-250..=850).map(value) {
        // The extreme since the last turn, and what is far enough from it to be the next.
        if rising && value < turn - 0.02 {
            (count, rising, turn) = (count + 1, false, value);
        } else if !rising && value > turn + 0.02 {
            (rising, turn) = (true, value);
        }
        turn = if rising { turn.max(value) } else { turn.min(value) };
    }
    count
}

fn figure_4() -> Result<Vec<Claim>, Error> {
    let judged = Judged::new(plastic()?);
    let matt = Judged::named("lambert")?;
    let forms = parts(&judged.model, judged.exposure)?;
    let counted = |name, form| Figure { name, value: peaks(form) as f64, unit: Unit::Count };
    let (doubled, single) = (counted("highlights; k = 1", &forms[0]), counted("highlights; equation 4", &forms[2]));
    let shiny = forms.map(|form| judged.between(&form));
    let diffuse = parts(&matt.model, matt.exposure)?.map(|form| matt.between(&form));
    let extended = Options { border: Border::Extend, ..Options::default() };
    let extended = judged.between(&judged.form(&paper(4, SIZE, extended))?);
    let holds = doubled.value == 2.0 && single.value == 1.0;
    Ok(vec![
        Claim::of(
            "images-doubled",
            vec![doubled, single, decibel("plastic; k = 1; between 4 images", shiny[0])],
            Finding::of(holds),
        ),
        Claim::of(
            "images-halves",
            vec![
                decibel("matt; k = 1/2; between 4 images", diffuse[1]),
                decibel("matt; equation 4; between 4 images", diffuse[2]),
                decibel("matt; k = 1; between 4 images", diffuse[0]),
            ],
            Finding::of(diffuse[1] < diffuse[2]),
        ),
        Claim::of(
            "images-equation-4",
            vec![
                decibel("plastic; k = 1/2; between 4 images", shiny[1]),
                decibel("plastic; equation 4; between 4 images", shiny[2]),
            ],
            match (shiny[2] > shiny[0], shiny[2] > shiny[1]) {
                (true, true) => Finding::Holds,
                (true, false) => Finding::Only("against k = 1".to_owned()),
                _ => Finding::DoesNotHold,
            },
        ),
        Claim::of(
            "images-border",
            vec![
                decibel("plastic; without the factor; between 4 images", shiny[3]),
                decibel("plastic; factor 0.995; between 4 images", shiny[2]),
                decibel("plastic; rim extended; between 4 images", extended),
            ],
            Finding::of(shiny[2] > shiny[3]),
        ),
    ])
}

/// Whether so many images suffice for materials.
fn suffice(id: &str, images: usize, materials: &[(&'static str, &str)]) -> Result<Claim, Error> {
    let mut measured = Vec::new();
    let mut short = Vec::new();
    for (name, preset) in materials {
        let mean = Judged::named(preset)?.mean(&paper(images, SIZE, Options::default()))?;
        if mean < SUFFICES {
            short.push(*name);
        }
        measured.push(decibel(name, mean));
    }
    let verdict = match short.len() {
        0 => Finding::Holds,
        all if all == materials.len() => Finding::DoesNotHold,
        _ => Finding::Only(format!("without {}", short.join(" and "))),
    };
    Ok(Claim::of(id, measured, verdict))
}

fn size() -> Result<Claim, Error> {
    let judged = Judged::named("yellow-plastic")?;
    let mean = |size| judged.mean(&paper(4, size, Options::default()));
    let (less, own, more) = (mean(128)?, mean(SIZE)?, mean(2 * SIZE)?);
    Ok(Claim::of(
        "images-size",
        vec![
            decibel("yellow plastic; 4 images of 128", less),
            decibel("yellow plastic; 4 images of 512", own),
            decibel("yellow plastic; 4 images of 1024", more),
        ],
        // More than that would be seen.
        Finding::of(more - own < 0.5 && own >= SUFFICES),
    ))
}

fn memory() -> Result<Claim, Error> {
    // As its file has it.
    let table = (12 + 90 * 90 * 180 * 3 * 8) as f64 / 1024.0;
    let kib = |form: Result<Form, Error>| form.map(|form| form.kib());
    let judged = Judged::new(plastic()?);
    let linear = |images| FormSpec::sized(FormKind::Paper, images, SIZE, Texel::Linear(8));
    let (four, six) = (kib(judged.form(&linear(4)))?, kib(judged.form(&linear(6)))?);
    let half = kib(judged.form(&FormSpec::of(FormKind::Half)))?;
    let ratio = |name, kib: f64| Figure { name, value: table / kib, unit: Unit::Times };
    Ok(Claim::of(
        "images-memory",
        vec![
            ratio("table over 4 images of 512 at 8 bits", four),
            ratio("table over 6 images of 512 at 8 bits", six),
            ratio("table over 16 slices of 32 at 8 bits", half),
        ],
        Finding::of(six < table),
    ))
}

/// All claims of the paper.
///
/// # Errors
/// None for the presets.
pub fn claims() -> Result<Vec<Claim>, Error> {
    let mut claims = figure_4()?;
    claims.push(suffice(
        "images-plastics",
        4,
        &[
            ("yellow plastic; 4 images", "yellow-plastic"),
            ("red specular plastic; 4 images", "red-specular-plastic"),
            ("blue acrylic; 4 images", "blue-acrylic"),
        ],
    )?);
    claims.push(suffice(
        "images-metals",
        6,
        &[
            ("aluminium bronze; 6 images", "aluminium-bronze"),
            ("gold paint; 6 images", "gold-paint"),
            ("colour shift; 6 images", "colour-shifting-paint"),
        ],
    )?);
    claims.extend([size()?, memory()?]);
    Ok(claims)
}

/// The pictures of figure 4, a to d, and the exact one as e: a sphere of 512² pixels, codes with a gamma of 1/2.2.
///
/// # Errors
/// None for the presets.
pub fn pictures() -> Result<Vec<File>, Error> {
    let model = plastic()?;
    let exposure = measure::exposure(&model);
    let (sphere, light) = (Sphere::new(SIZE), Light::new(PHI, 0.0));
    let forms = parts(&model, exposure)?;
    let through = ["a", "b", "c", "d"].into_iter().zip(forms.map(|form| sphere.through(&form, light)));
    let drawn = through.chain([("e", sphere.exact(&model, light, exposure))]);
    let at = |place: usize| (2 * place + 1) as f64 / SIZE as f64 - 1.0;
    let file = |(name, seen): (&str, Vec<[f32; 3]>)| {
        let mut seen = seen.into_iter();
        let mut pixels: Vec<[f32; 3]> = (0..SIZE * SIZE)
            .map(|place| {
                let (x, y) = (at(place % SIZE), at(place / SIZE));
                if x * x + y * y < 1.0 { seen.next().unwrap_or_default() } else { [0.0; 3] }
            })
            .collect();
        images::flip(SIZE, &mut pixels);
        let code = |value: f32| libm::round(255.0 * libm::pow(f64::from(value.clamp(0.0, 1.0)), 1.0 / 2.2)) as u16;
        let codes = pixels.into_iter().map(|pixel| pixel.map(code)).collect();
        let picture = images::Pixels { width: SIZE, height: SIZE, depth: 8, gamma: Some(1.0 / 2.2), codes };
        File { path: format!("images_figure_4{name}.png"), bytes: images::png(&picture) }
    };
    Ok(drawn.map(file).collect())
}

/// What table I is measured with.
const MESHES: [(&str, &[u8]); 2] = [
    ("bunny.ply", include_bytes!("../../scenes/meshes/bunny.ply")),
    ("teapot.obj", include_bytes!("../../scenes/meshes/teapot.obj")),
];
/// The scene of table I: the object fills most of the picture, as in the paper's figure 5.
const SCENE: &str = r#"
width = 320
height = 240
[camera]
position = [0.0, 1.2, 6.0]
target = [0.0, 0.55, 0.0]
field_of_view = 24.0
[[material]]
name = "plastic"
[material.reflectance]
model = "yellow-plastic"
form = "paper"
viewer = "axis"
[[light]]
direction = [1.0, 1.0, 1.0]
[[object]]
kind = "sphere"
material = "plastic"
"#;

/// The frames a second of an object under so many lights.
#[derive(Clone, Debug, serde::Serialize)]
pub struct Speed {
    /// The mesh.
    pub mesh: &'static str,
    /// Distant lights.
    pub lights: usize,
    /// Frames a second of this renderer, on this processor.
    pub fps: f64,
    /// The same relative to one light.
    pub ratio: f64,
}

/// Table I: frames a second with 1, 2, 4 and 8 lights, measured here and now. Only the ratios to one light can be
/// compared with the paper's, which are of a graphics card that draws the object anew for each frame; here rays do.
/// Each is the best of three.
///
/// # Errors
/// None for the scene that is drawn.
pub fn speeds() -> Result<Vec<Speed>, Error> {
    let mut speeds = Vec::new();
    for (name, bytes) in MESHES {
        let mut scene = Scene::parse(SCENE, "table I", std::path::Path::new(""))?;
        let mesh = Mesh::parse(bytes, name, Normals::File)?;
        scene.objects = vec![Object { shape: Shape::Mesh(Arc::new(mesh)), material: 0 }];
        let tracer = Tracer::new(&scene);
        let measured = scene.reflectance(0).map(Arc::clone);
        let Some(form) = measured.as_ref().map(|measured| measured.form()).transpose()? else { continue };
        let mut one = None;
        for lights in [1, 2, 4, 8] {
            let light = |place: usize| Light::new(30.0 + 12.0 * place as f64, 45.0 * place as f64);
            let frame = || {
                let clock = Instant::now();
                let seen = reflectance::Seen::of(&tracer, &scene);
                let records: Vec<_> = (0..lights).map(|place| form.record(light(place))).collect();
                std::hint::black_box(seen.through(form, &records));
                clock.elapsed().as_secs_f64()
            };
            let fps = 1.0 / (0..3).map(|_| frame()).fold(f64::INFINITY, f64::min);
            let one = *one.get_or_insert(fps);
            speeds.push(Speed { mesh: name, lights, fps, ratio: fps / one });
        }
    }
    Ok(speeds)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ratios_are_those_measured_elsewhere() {
        // By another program on larger pictures, whose rims count for more, and in other steps of the angle.
        let judged = Judged::new(plastic().unwrap());
        let [a, b, c, d] = parts(&judged.model, judged.exposure).unwrap().map(|form| judged.between(&form));
        for (own, wanted) in [(a, 27.1), (b, 42.5), (c, 42.8), (d, 39.6)] {
            assert!((own - wanted).abs() < 2.2, "{own} for {wanted}");
        }
    }
}
