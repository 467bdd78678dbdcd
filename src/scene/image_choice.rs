//! The image-based core that a measured material of a scene needs: the cheapest whose pictures keep the scene's budget.
//!
//! Candidates are the block's forms with several numbers of images, sizes and bits of texels, and beside them the
//! shader around the cos^n material that is nearest to the reflectance; of a matcap several sizes alone. Each draws the
//! scene through its bit-exact model, in a picture that is made smaller if it has too many samples; all other materials
//! are exact. The cheapest that keeps the budget there draws the whole picture, and those with the camera and each
//! light moved, and if it keeps the budget in all of them it is chosen.

use clap::ValueEnum;
use rayon::prelude::*;
use serde::Serialize;

use super::drawing::{Drawn, Own};
use super::file::fitted;
use super::image_core::{Points, added};
use super::reflectance::Measured;
use super::require::{self, PictureError};
use super::{Exact, Frame, Highlights, Scene, Tracer};
use crate::block::image::{ImageSamples, ImageSource};
use crate::core::Design;
use crate::explore::Cost;
use crate::explore::choose::too_slow;
use crate::explore::run::Costing;
use crate::platform::error::{Error, refuse};
use crate::spec::{
    Block, BlockKind, Colour, CoreSpec, Front, ImageFormName, MethodName, Model as Highlight, ShaderFields, SpecFields,
};

/// Images that are tried of a form that has several.
const IMAGES: [u32; 5] = [4, 6, 8, 16, 32];
/// Texels along a side that are tried.
const SIZES: [u32; 4] = [8, 16, 32, 64];
/// The same of a matcap, as far as its picture has as many pixels.
const MATCAP_SIZES: [u32; 6] = [16, 32, 64, 128, 256, 512];
/// Bits of a texel's channel that are tried.
const TEXEL_BITS: [u32; 2] = [6, 8];
/// Bits of the lobe of the fitted shader.
const ACCURACY: u32 = 7;
/// Fraction bits of the fitted shader's vectors.
const SHADER_VECTOR: u32 = 14;
/// The most samples, pixels of the material times lights, of the picture that candidates are compared by.
const SAMPLES: u64 = 100_000;
/// The cores that are synthesised, where costs are synthesised: so many of those that keep the budget and are the
/// cheapest by the cost model.
const SHORTLIST: usize = 4;

/// What the picture that candidates are compared by is called where it misses the budget.
pub(super) const COMPARED: &str = "the picture";

/// A candidate.
#[derive(Debug, Serialize)]
pub struct ImageCandidate {
    /// What it is, in a few words.
    pub name: String,
    /// The flags that make its core.
    pub flags: String,
    /// Whether it is the shader around the fitted cos^n material, and no image-based block.
    pub fitted: bool,
    /// What it takes: the core, without the sequencer around it where costs are estimated.
    pub cost: Cost,
    /// Bits of its memories.
    pub memory_bits: u64,
    /// The error of the picture that candidates are compared by.
    pub error: PictureError,
    /// The ratio on linear values over the objects, in dB; none of the same picture.
    pub psnr: Option<f64>,
    /// What of the budget and of the frequency is missed, in words.
    pub missed: Vec<String>,
    #[serde(skip)]
    pub(crate) design: Design,
    #[serde(skip)]
    pub(crate) own: Own,
}

/// The outcome.
#[derive(Debug, Serialize)]
pub struct ImageChoice {
    /// The material.
    pub material: String,
    /// What its reflectance is.
    pub reflectance: String,
    /// The size of the picture that candidates are compared by.
    pub size: [u32; 2],
    /// The place of the chosen one among the candidates, the cheapest image-based core that keeps the budget.
    pub chosen: Option<usize>,
    /// The errors of the whole picture and the worst of the moved ones through the chosen core.
    pub verified: Option<[PictureError; 2]>,
    /// All of them, the cheapest first.
    pub candidates: Vec<ImageCandidate>,
    /// The frame and the exact picture that candidates are compared by.
    #[serde(skip)]
    pub(crate) compared: (Frame, super::Picture),
}

/// A view of the scene in which one material is drawn through cores.
struct View<'a> {
    tracer: &'a Tracer,
    material: usize,
    scene: Scene,
    frame: Frame,
    exact: Drawn,
    /// The channels without that material.
    base: Vec<Colour>,
    lobes: Vec<f64>,
}

impl<'a> View<'a> {
    fn of(tracer: &'a Tracer, scene: Scene, material: usize) -> Result<Self, Error> {
        let looks = [scene.exact_looks()?, scene.exact_looks_but(&[material])?];
        let (frame, mut bases) = Frame::with_looks(tracer, &scene, &looks, &|| ());
        let lobes = Exact.of(&scene, &frame)?;
        let exact = Drawn::of(&scene, &frame, &bases[0], &lobes);
        Ok(Self { tracer, material, frame, exact, base: bases.remove(1), lobes, scene })
    }

    /// The view through a core.
    fn through(&self, design: &Design) -> Own {
        let material = [self.material];
        let codes = Points::of(&self.scene, self.tracer, &material).through(design, &|| ());
        let base = added(&self.base, &codes, self.scene.channel_bits);
        Own::of(&self.frame, &self.exact, Drawn::of(&self.scene, &self.frame, &base, &self.lobes))
    }
}

/// The search for the image-based core of a scene's material.
pub struct ImageSearch<'a> {
    scene: &'a Scene,
    /// The material, by its place.
    material: usize,
    margin_degrees: f64,
    costing: &'a Costing,
    keys: SpecFields,
}

impl<'a> ImageSearch<'a> {
    /// Prepares the search for a material of a scene, by its name where there are several with a reflectance. `keys`
    /// narrow it beside those of the scene's `[core]`, over which they win; pictures with the camera and each light
    /// moved by `margin_degrees`, from 0 to [`MAX_MARGIN`](super::require::MAX_MARGIN), keep the budget too.
    ///
    /// # Errors
    /// A scene without a budget or without such a material, a material that holds images, keys that the scene itself
    /// says.
    pub fn new(
        scene: &'a Scene,
        material: Option<&str>,
        margin_degrees: f64,
        costing: &'a Costing,
        keys: &SpecFields,
    ) -> Result<Self, Error> {
        require::check_margin(margin_degrees)?;
        let material = material_of(scene, material)?;
        let keys = keys.clone().or(scene.core.keys.clone());
        refuse!(
            !scene.has_budget,
            format!("the scene {} has no budget, and a core is chosen by what it may miss", scene.name),
            "a table [budget] with max_steps or min_psnr, as in min_psnr = 40.0"
        );
        refuse!(
            !keys.reflectance.is_empty(),
            "the scene's material has its own reflectance and exposure",
            "leave the keys of [reflectance] out, or make the core of a spec"
        );
        refuse!(
            keys.min_psnr.is_some() || keys.max_error.is_some(),
            "min_psnr or max_error is given for a block of its own, and a scene's core is chosen by its pictures",
            "leave it out, and give min_psnr or max_steps in the table [budget] of the scene"
        );
        refuse!(
            keys.output_bits.is_some_and(|bits| bits != scene.channel_bits),
            format!("the scene has {} bits a channel", scene.channel_bits),
            "leave output_bits out, or set channel_bits in the scene"
        );
        Ok(Self { scene, material, margin_degrees, costing, keys })
    }

    fn measured(&self) -> &Measured {
        self.scene.reflectance(self.material).expect("a material with a reflectance")
    }

    /// Whether the material has its light in its picture: no cos^n is near to it.
    fn is_matcap(&self) -> bool {
        self.measured().matcap().is_some()
    }

    /// The specs of the image-based candidates, each with its name.
    fn specs(&self) -> Result<Vec<CoreSpec>, Error> {
        let picture = self.measured().matcap();
        let is_made = |form: &ImageFormName| (*form == ImageFormName::Matcap) == picture.is_some();
        let all = ImageFormName::value_variants().iter().copied().filter(is_made);
        let forms: Vec<ImageFormName> = self.keys.image_form.map_or_else(|| all.collect(), |form| vec![form]);
        if let Some(form) = forms.iter().find(|form| !is_made(form)) {
            return Err(Error::input(
                format!(
                    "image_form = {:?} is given for the material {}, which is {}",
                    form.to_possible_value().map(|value| value.get_name().to_owned()).unwrap_or_default(),
                    self.scene.materials[self.material].name,
                    if picture.is_some() { "a matcap" } else { "a reflectance and no matcap" }
                ),
                "leave image_form out",
            ));
        }
        let sizes: Vec<u32> = match picture {
            Some(form) => MATCAP_SIZES.into_iter().filter(|&size| size as usize <= form.spec.size).collect(),
            None => SIZES.to_vec(),
        };
        let keys = self.keys.clone().or(self.common());
        let of_form =
            |form| SpecFields { image_form: Some(form), ..keys.clone() }.with_image_sizes(&IMAGES, &sizes, &TEXEL_BITS);
        let (mut specs, mut refused) = (Vec::<CoreSpec>::new(), None);
        for own in forms.into_iter().flat_map(of_form) {
            match own.resolve_with_stand_in() {
                Ok(spec) if specs.iter().all(|other| other.block != spec.block) => specs.push(spec),
                Ok(_) => {}
                Err(error) => refused = Some(error),
            }
        }
        match refused {
            Some(error) if specs.is_empty() => Err(error),
            _ => Ok(specs),
        }
    }

    /// The keys of every candidate unless others are given.
    fn common(&self) -> SpecFields {
        SpecFields {
            name: Some(self.scene.name.clone()),
            output_bits: Some(self.scene.channel_bits),
            most_lights: (!self.is_matcap()).then_some(self.scene.lights.len().min(1024) as u32),
            ..SpecFields::default()
        }
    }

    /// The core of a spec with the material's reflectance in place of the stand-in's.
    fn design(&self, mut spec: CoreSpec) -> Result<Design, Error> {
        let measured = self.measured();
        let Block::Image(image) = &mut spec.block else { unreachable!("an image-based block") };
        image.exposure = measured.exposure;
        image.source = match (measured.model(), measured.reflectance(), measured.matcap()) {
            (Some(model), ..) => ImageSource::Model(model.clone()),
            (None, Some(table), _) => ImageSource::Samples(ImageSamples::of(&image.image, table, measured.exposure)?),
            (None, None, Some(picture)) => {
                let stored = ImageSamples::of_picture(&image.image, picture, measured.exposure, &measured.name)?;
                ImageSource::Samples(stored.into())
            }
            (None, None, None) => unreachable!("a material that holds images is refused"),
        };
        Design::new(spec)
    }

    /// The shader around the fitted material, one light a clock.
    fn shader(&self) -> Result<Design, Error> {
        let measured = self.measured();
        let material = fitted("fitted", measured, self.scene.model)?;
        let front = (self.scene.model == Highlight::Blinn).then_some(Front::Half);
        let fields = SpecFields {
            name: Some(self.scene.name.clone()),
            block: Some(BlockKind::Shader),
            method: MethodName::named("log-exp"),
            accuracy: Some(ACCURACY),
            material: Some(vec![material]),
            lights_a_clock: Some(self.keys.lights_a_clock.unwrap_or(1)),
            most_lights: self.common().most_lights,
            shader: ShaderFields {
                model: Some(self.scene.model),
                front,
                channel_bits: Some(self.scene.channel_bits),
                vector_fraction: Some(SHADER_VECTOR),
                // What is given back of it is added behind the core, as for the others.
                ambient_light: Some(vec![0.0; 3]),
                ..ShaderFields::default()
            },
            ..SpecFields::default()
        };
        Design::new(fields.resolve()?)
    }

    /// A core's place among the candidates.
    fn candidate(&self, view: &View, design: Design) -> Result<ImageCandidate, Error> {
        let own = view.through(&design);
        let error = PictureError::of(&own.difference, self.scene.channel_bits);
        let estimate = match self.costing {
            Costing::Estimate(_) => self.costing,
            Costing::Synthesis(_) => &Costing::built_in()?,
        };
        let cost = estimate.cost(&design, self.scene.core.family)?;
        let bits = |table: &crate::fixed::Table| table.depth() as u64 * u64::from(table.word_bits());
        let fitted = design.spec.block.kind() == BlockKind::Shader;
        Ok(ImageCandidate {
            name: if fitted { format!("log-exp, accuracy {ACCURACY}") } else { super::cores::name(&design) },
            flags: design.spec.flags().join(" "),
            fitted,
            memory_bits: design.tables().iter().map(bits).sum(),
            psnr: own.psnr,
            missed: self.missed(&error, &cost, COMPARED),
            error,
            cost,
            design,
            own,
        })
    }

    fn missed(&self, error: &PictureError, cost: &Cost, what: &str) -> Vec<String> {
        let missed = self.scene.budget.missed(error, what).into_iter();
        let slow = too_slow(cost, self.scene.core.min_mhz);
        missed.chain(slow).map(|(_, why)| why).collect()
    }

    /// All candidates and the choice among them. `progress` is told how many of how many have drawn their pictures.
    ///
    /// # Errors
    /// Keys that no candidate can have, a family without a cost model, a tool that is missing.
    pub fn choose(&self, progress: &(dyn Fn(&'static str, usize, usize) + Sync)) -> Result<ImageChoice, Error> {
        let scene = self.scene;
        let tracer = Tracer::new(scene);
        let pixels = Frame::trace(&tracer, scene, &|| ()).material;
        let pixels = pixels.iter().filter(|&&material| usize::from(material) == self.material).count();
        refuse!(
            pixels == 0,
            format!("no pixel of the scene {} shows the material {}", scene.name, scene.materials[self.material].name),
            "turn the camera to an object that has it"
        );
        let samples = pixels * if self.is_matcap() { 1 } else { scene.lights.len() };
        let few = libm::sqrt(SAMPLES as f64 / samples as f64).min(1.0);
        let [width, height] =
            [scene.width, scene.height].map(|side| (libm::round(f64::from(side) * few) as u32).max(1));
        let view = View::of(&tracer, scene.resized(width, height), self.material)?;
        let specs = self.specs()?;
        let count = specs.len() + usize::from(!self.is_matcap());
        let done = std::sync::atomic::AtomicUsize::new(0);
        let step = || progress("candidates", done.fetch_add(1, std::sync::atomic::Ordering::Relaxed) + 1, count);
        let mut candidates = specs
            .into_par_iter()
            .map(|spec| {
                let candidate = self.candidate(&view, self.design(spec)?);
                step();
                candidate
            })
            .collect::<Result<Vec<_>, Error>>()?;
        if !self.is_matcap() {
            candidates.push(self.candidate(&view, self.shader()?)?);
            step();
        }
        let rank = |cost: &Cost| (scene.core.objective.order().map(|one| one.of(cost)), cost.ff);
        let sort = |candidates: &mut [ImageCandidate]| {
            candidates.sort_by(|a, b| rank(&a.cost).cmp(&rank(&b.cost)).then_with(|| a.name.cmp(&b.name)));
        };
        sort(&mut candidates);
        self.synthesise(&mut candidates, progress)?;
        sort(&mut candidates);
        let chosen = self.verify(&tracer, &mut candidates, progress)?;
        let measured = self.measured();
        Ok(ImageChoice {
            material: scene.materials[self.material].name.clone(),
            reflectance: measured.name.clone(),
            size: [width, height],
            chosen: chosen.map(|(place, _)| place),
            verified: chosen.map(|(_, errors)| errors),
            candidates,
            compared: (view.frame, view.exact.picture),
        })
    }

    /// Measures those that keep the budget and are the cheapest, where costs are synthesised.
    fn synthesise(
        &self,
        candidates: &mut [ImageCandidate],
        progress: &(dyn Fn(&'static str, usize, usize) + Sync),
    ) -> Result<(), Error> {
        if matches!(self.costing, Costing::Estimate(_)) {
            return Ok(());
        }
        let kept = |candidate: &&mut ImageCandidate| {
            candidate.fitted || self.scene.budget.missed(&candidate.error, "").is_empty()
        };
        for (place, candidate) in candidates.iter_mut().filter(kept).take(SHORTLIST).enumerate() {
            candidate.cost = self.costing.cost(&candidate.design, self.scene.core.family)?;
            candidate.missed = self.missed(&candidate.error, &candidate.cost, COMPARED);
            progress("synthesis", place + 1, SHORTLIST);
        }
        Ok(())
    }

    /// The first image-based candidate that keeps the budget in the whole picture and the moved ones, with its errors.
    fn verify(
        &self,
        tracer: &Tracer,
        candidates: &mut [ImageCandidate],
        progress: &(dyn Fn(&'static str, usize, usize) + Sync),
    ) -> Result<Option<(usize, [PictureError; 2])>, Error> {
        let scenes = self.views();
        for (place, candidate) in candidates.iter_mut().enumerate() {
            if candidate.fitted || !candidate.missed.is_empty() {
                continue;
            }
            let mut errors = [PictureError::default(); 2];
            for (number, scene) in scenes.iter().enumerate() {
                let view = View::of(tracer, scene.clone(), self.material)?;
                let own = view.through(&candidate.design);
                let error = PictureError::of(&own.difference, scene.channel_bits);
                let (of, what) = if number == 0 { (0, "the whole picture") } else { (1, "a moved picture") };
                errors[of] = if number == 0 { error } else { errors[1].worst(error) };
                candidate.missed = self.missed(&error, &candidate.cost, what);
                progress("pictures", number + 1, scenes.len());
                if !candidate.missed.is_empty() {
                    break;
                }
            }
            if candidate.missed.is_empty() {
                return Ok(Some((place, errors)));
            }
        }
        Ok(None)
    }

    /// The whole picture, then the moved ones.
    fn views(&self) -> Vec<Scene> {
        let moved = self.scene.moved(self.margin_degrees);
        let [width, height] = require::moved_size(self.scene, moved.len());
        let moved = moved.into_iter().map(|(_, scene)| scene.resized(width, height));
        std::iter::once(self.scene.clone()).chain(moved).collect()
    }
}

/// The material that a core is asked for.
fn material_of(scene: &Scene, name: Option<&str>) -> Result<usize, Error> {
    let all: Vec<usize> = scene.measured_places().collect();
    let names = || all.iter().map(|&place| scene.materials[place].name.as_str()).collect::<Vec<_>>().join(", ");
    let place = match (name, all.as_slice()) {
        (_, []) => {
            return Err(Error::input(
                format!("no object of the scene {} has a material with a reflectance", scene.name),
                "give a material a table [material.reflectance], or leave --block image out",
            ));
        }
        (None, &[only]) => only,
        (None, _) => {
            return Err(Error::input(
                format!("the scene {} has several materials with a reflectance: {}", scene.name, names()),
                "name the one that the core is for with --for-material; the others are drawn exactly",
            ));
        }
        (Some(name), _) => all.iter().copied().find(|&place| scene.materials[place].name == name).ok_or_else(|| {
            Error::input(format!("the scene has no material {name} with a reflectance"), format!("one of: {}", names()))
        })?,
    };
    refuse!(
        scene
            .reflectance(place)
            .is_some_and(|measured| measured.reflectance().is_none() && measured.matcap().is_none()),
        format!(
            "the material {} holds sphere images, and no reflectance to choose a form for",
            scene.materials[place].name
        ),
        "a MERL table or a model; a core of the images is made with --block image --reflectance-file"
    );
    Ok(place)
}
