//! The whole shader of a scene: the lobe that it needs with the cosine in front of it and the colours behind it.

use rayon::prelude::*;

use super::choice::{SceneChoice, SceneCore, Search};
use super::require::PictureError;
use super::trace::{Hit, Tracer};
use super::{Difference, Exact, Frame, Highlights, Picture, Requirements, Scene};
use crate::core::sample::{self, Sample, Vector};
use crate::core::{BlockDesign, Design, ShaderDesign};
use crate::explore::choose::NearMiss;
use crate::platform::error::{Error, refuse};
use crate::spec::{
    BlockKind, Front, INPUT_FRACTION, LightColours, Material, Model, ShaderFields, Shininess, SpecFields,
    VECTOR_FRACTION,
};

/// The spec of the shader of a scene around a lobe.
///
/// `lobe` is the lobe's spec, chosen for the scene; `asked` says of the shader what the scene does not: the front end
/// of Blinn's half vector and the vectors' fraction bits. Every material that a picture shows has its row; the colours
/// of the lights are constants. A material without a highlight has the shininess of the first row: it is multiplied by
/// 0.
///
/// # Errors
/// Keys that the scene itself says, or no material that is seen.
pub fn spec(
    scene: &Scene,
    requirements: &Requirements,
    lobe: &SpecFields,
    asked: &ShaderFields,
) -> Result<SpecFields, Error> {
    let of_scene = ShaderFields { front: None, vector_fraction: None, ..asked.clone() };
    refuse!(
        !of_scene.is_empty(),
        "the scene says itself which model, lights, colours and channels its shader has",
        "of the shader's keys give only front and vector_fraction"
    );
    refuse!(
        scene.is_measured(),
        "the scene has materials that are drawn by a reflectance, and a shader computes none",
        "shading = \"classical\" makes the nearest diffuse and cos^n materials of them"
    );
    let first = requirements.rows.first().map_or(1.0, |row| row.shininess);
    let needed =
        scene.materials.iter().zip(&requirements.materials).filter(|(_, need)| need.base.and(&need.moved).samples > 0);
    let materials: Vec<Material> = needed
        .map(|(material, need)| {
            let shininess = if need.row.is_some() { material.shininess } else { first };
            Material { shininess, ..material.clone() }
        })
        .collect();
    refuse!(materials.is_empty(), "no object of the scene is seen", "turn the camera to the objects");
    let front = match scene.model {
        Model::Phong => asked.front,
        Model::Blinn => Some(asked.front.unwrap_or(Front::Half)),
    };
    let shader = ShaderFields {
        model: Some(scene.model),
        front,
        lights: Some(scene.lights.len() as u32),
        channel_bits: Some(scene.channel_bits),
        vector_fraction: asked.vector_fraction,
        ambient_light: Some(scene.ambient.to_vec()),
        light_colours: Some(LightColours::Fixed(scene.lights.iter().map(|light| light.colour).collect())),
    };
    Ok(SpecFields {
        block: Some(BlockKind::Shader),
        shininess: None,
        material: Some(materials),
        operand: None,
        input_range: None,
        shader,
        ..lobe.clone()
    })
}

/// A scene's shader and its pictures.
#[derive(Debug)]
pub struct Shaded {
    /// The shader.
    pub design: Design,
    /// The samples, pixels of objects with all their lights, that went through its bit-exact model.
    pub samples: u64,
    /// The error of the base picture.
    pub base: PictureError,
    /// The worst error of a moved picture.
    pub moved: PictureError,
    /// What of the budget is missed, in words; nothing of a shader that keeps it.
    pub missed: Vec<String>,
    /// The lobes that were tried for it.
    pub tried: usize,
}

/// The fraction bits that the lobe's input may get beyond those that the lobe was chosen with: before it more is
/// rounded than one cosine.
const FINER: [u32; 3] = [0, 2, 4];

/// The most lobes around which a shader is tried.
const MOST_LOBES: usize = 6;

/// The shader of a scene around the cheapest of the lobes that keep the budget, with which it keeps it too: a whole
/// shader rounds more than its lobe, above all where many lights are added up. Lobes that differ from one that failed
/// in nothing but the input's fraction bits are passed over, as [`make`] tries these. If the shader around another than
/// the chosen lobe does, that is chosen; if none does, the nearest is returned, drawn through all pictures, and the
/// choice is left.
///
/// # Errors
/// As [`make`].
pub fn around(
    search: &Search,
    choice: &mut SceneChoice,
    (scene, requirements): (&Scene, &Requirements),
    asked: &ShaderFields,
    done: &(dyn Fn() + Sync),
) -> Result<Option<Shaded>, Error> {
    let lobes: Vec<SceneCore> = choice.chosen.iter().chain(&choice.others).cloned().collect();
    let pictures = Pictures::of(scene, requirements)?;
    let (mut tried, mut refused, mut nearest) = (Vec::new(), Vec::new(), None::<(f64, Design)>);
    for lobe in &lobes {
        let spec = lobe.spec()?;
        let but_input = SpecFields { input_fraction: None, ..spec.clone() };
        if tried.len() == MOST_LOBES || tried.contains(&but_input) {
            continue;
        }
        tried.push(but_input);
        let shaded = pictures.make(&spec, asked, done)?;
        if shaded.missed.is_empty() {
            if tried.len() > 1 {
                search.take(choice, lobe, refused);
            }
            return Ok(Some(Shaded { tried: tried.len(), ..shaded }));
        }
        let missed = |error: &PictureError| requirements.budget.missed(error, "");
        let octaves: f64 = [shaded.base, shaded.moved].iter().flat_map(missed).map(|(octaves, _)| octaves).sum();
        let why = shaded.missed.iter().map(|why| format!("as a shader {why}")).collect();
        refused.push(NearMiss { core: lobe.clone(), octaves, why });
        if nearest.as_ref().is_none_or(|(least, _)| octaves < *least) {
            nearest = Some((octaves, shaded.design));
        }
    }
    let Some((_, design)) = nearest else { return Ok(None) };
    let shaded = pictures.through(design, Extent::All, done)?;
    Ok(Some(Shaded { tried: tried.len(), ..shaded }))
}

/// The pictures of a scene that its shader is compared with.
struct Pictures<'a> {
    scene: &'a Scene,
    requirements: &'a Requirements,
    tracer: Tracer,
    views: Vec<Scene>,
    exact: Vec<Picture>,
}

/// Which of the pictures are drawn.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Extent {
    All,
    /// None after one that misses the budget.
    ToMiss,
}

impl<'a> Pictures<'a> {
    fn of(scene: &'a Scene, requirements: &'a Requirements) -> Result<Self, Error> {
        let tracer = Tracer::new(scene);
        let [width, height] = requirements.moved_size;
        let moved = scene.moved(requirements.margin_degrees).into_iter().map(|(_, moved)| moved.resized(width, height));
        let views: Vec<Scene> = std::iter::once(scene.clone()).chain(moved).collect();
        let exact = |view: &Scene| -> Result<Picture, Error> {
            let frame = Frame::trace(&tracer, view, &|| {});
            Ok(frame.picture(view, &Exact.of(view, &frame)?))
        };
        let exact = views.iter().map(exact).collect::<Result<_, _>>()?;
        Ok(Self { scene, requirements, tracer, views, exact })
    }

    /// The pictures through a shader.
    fn through(&self, design: Design, extent: Extent, done: &(dyn Fn() + Sync)) -> Result<Shaded, Error> {
        let (base, moved) = (PictureError::default(), PictureError::default());
        let mut shaded = Shaded { design, samples: 0, base, moved, missed: Vec::new(), tried: 1 };
        for (place, (view, exact)) in self.views.iter().zip(&self.exact).enumerate() {
            let BlockDesign::Shader(shader) = shaded.design.block() else { unreachable!("a shader was asked for") };
            let (own, samples) = picture(shader, view, &self.tracer, &|| {})?;
            done();
            let error = PictureError::of(&Difference::of(exact, &own), self.scene.channel_bits);
            shaded.samples += samples;
            if place == 0 {
                shaded.base = error;
            } else {
                shaded.moved = shaded.moved.worst(error);
            }
            let kept = self.requirements.budget.missed(&error, "").is_empty();
            if !kept && extent == Extent::ToMiss {
                break;
            }
        }
        for (error, what) in [(&shaded.base, "the picture"), (&shaded.moved, "a moved picture")] {
            shaded.missed.extend(self.requirements.budget.missed(error, what).into_iter().map(|(_, why)| why));
        }
        Ok(shaded)
    }

    /// As [`make`].
    fn make(&self, lobe: &SpecFields, asked: &ShaderFields, done: &(dyn Fn() + Sync)) -> Result<Shaded, Error> {
        let widths: Vec<u32> = asked.vector_fraction.map_or_else(|| VECTOR_FRACTION.collect(), |bits| vec![bits]);
        let input = lobe.clone().resolve()?.block.lobe().interface.input_fraction;
        let mut last = None;
        for finer in FINER.into_iter().filter(|finer| input + finer <= *INPUT_FRACTION.end()) {
            let lobe = SpecFields { input_fraction: Some(input + finer), ..lobe.clone() };
            let with = |bits: u32| -> Result<Shaded, Error> {
                let asked = ShaderFields { vector_fraction: Some(bits), ..asked.clone() };
                let design = Design::new(spec(self.scene, self.requirements, &lobe, &asked)?.resolve()?)?;
                self.through(design, Extent::ToMiss, done)
            };
            // With the most bits first: if these do not do, no fewer will.
            let mut best = with(widths[widths.len() - 1])?;
            if best.missed.is_empty() {
                let (mut few, mut enough) = (0, widths.len() - 1);
                while few < enough {
                    let middle = (few + enough) / 2;
                    let shaded = with(widths[middle])?;
                    if shaded.missed.is_empty() {
                        (enough, best) = (middle, shaded);
                    } else {
                        few = middle + 1;
                    }
                }
                return Ok(best);
            }
            last = Some(best);
        }
        last.ok_or_else(|| Error::input("the lobe's input has too many bits", "use fewer input_fraction bits"))
    }
}

/// The shader of a scene around the lobe that was chosen for it, with the fewest fraction bits of the vectors, and then
/// of the lobe's input, whose pictures keep the scene's budget; all of them are drawn through the bit-exact model,
/// every pixel and every light. If none does, the finest. `done` is called once a picture.
///
/// # Errors
/// As [`spec`], and a shader that cannot be built.
pub fn make(
    scene: &Scene,
    requirements: &Requirements,
    lobe: &SpecFields,
    asked: &ShaderFields,
    done: &(dyn Fn() + Sync),
) -> Result<Shaded, Error> {
    Pictures::of(scene, requirements)?.make(lobe, asked, done)
}

/// A point of a surface as the shader is given it: the material's row, N, V, and of each light L and H. A light that
/// does not shine on the point, because it is in shadow or lies at the very point, is put behind the surface, where the
/// shader finds no light.
fn sample(tracer: &Tracer, scene: &Scene, hit: &Hit, row: u32) -> Sample {
    let behind: Vector = hit.normal.map(|component| -component);
    let light = |light: usize| {
        let lit = tracer.light(scene, hit, light);
        let direction = if lit.visible { lit.direction } else { behind };
        sample::Light { direction, half: lit.half, colour: scene.lights[light].colour }
    };
    Sample {
        material: row,
        normal: hit.normal,
        viewer: hit.viewer,
        lights: (0..scene.lights.len()).map(light).collect(),
    }
}

/// The code of `in_material` of each material of the scene; none of a material that the shader does not have.
#[must_use]
pub fn rows(design: &Design, scene: &Scene) -> Vec<Option<u32>> {
    let Shininess::Materials(own) = &design.lobe().interface.shininess else {
        return vec![None; scene.materials.len()];
    };
    let place = |material: &Material| own.iter().position(|known| known.name == material.name).map(|row| row as u32);
    scene.materials.iter().map(place).collect()
}

/// A scene's picture by the bit-exact model of its shader, and the number of samples (pixels of objects, each with all
/// its lights) that it was given. `done` is called once a row.
///
/// # Errors
/// A pixel of a material that the shader does not have.
pub fn picture(
    design: ShaderDesign<'_>,
    scene: &Scene,
    tracer: &Tracer,
    done: &(dyn Fn() + Sync),
) -> Result<(Picture, u64), Error> {
    let (model, rows) = (design.model(), rows(&design, scene));
    let full = scene.full_scale();
    let background = scene.background.map(|channel| libm::round(channel * full) as u16);
    let of_row = |y: u32| -> Result<(Vec<[u16; 3]>, u64), Error> {
        let (mut codes, mut samples) = (Vec::with_capacity(scene.width as usize), 0);
        for hit in tracer.row(scene, y) {
            let Some(hit) = hit else {
                codes.push(background);
                continue;
            };
            let row = rows[hit.material].ok_or_else(|| {
                let name = &scene.materials[hit.material].name;
                Error::input(format!("the shader has no material {name}"), "make it with a wider --margin")
            })?;
            let channels = model.evaluate(&sample(tracer, scene, &hit, row).codes(design.shader));
            codes.push([0, 1, 2].map(|channel| channels[channel] as u16));
            samples += 1;
        }
        done();
        Ok((codes, samples))
    };
    let parts: Vec<(Vec<[u16; 3]>, u64)> = (0..scene.height).into_par_iter().map(of_row).collect::<Result<_, _>>()?;
    let samples = parts.iter().map(|(_, samples)| samples).sum();
    let codes = parts.into_iter().flat_map(|(codes, _)| codes).collect();
    let Scene { width, height, channel_bits, .. } = *scene;
    Ok((Picture { width, height, channel_bits, codes }, samples))
}
