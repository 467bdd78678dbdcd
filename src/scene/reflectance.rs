//! Materials that are drawn by their reflectance, exactly or through sphere images, next to classical ones.
//!
//! Every light and the viewer are turned into the frame of each pixel, in which the viewer is at +Z, as
//! [`vector::seen_from`] has it: so point lights and perspective cameras cost a turn, and nothing else. The images'
//! authors take the viewer to be in the same direction everywhere (A. Mihálik, R. Ďurikovič, "Image-based BRDF
//! Representation", section 3): [`Viewer::Axis`].

use std::path::Path;
use std::sync::{Arc, OnceLock};

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::frame::{BACKGROUND, Frame};
use super::trace::Hit;
use super::{Scene, Tracer};
use crate::emit::package::counted;
use crate::platform::error::{Error, refuse};
use crate::reflectance::classical::{self, Classical, Cosine};
use crate::reflectance::vector::{self, Light};
use crate::reflectance::{Form, FormKind, FormSpec, Lookup, Model, Record, Reflectance, Source, Vector, measure};
use crate::spec::{
    Colour, Model as Highlight, Named, Parameters, ReflectanceFields as BlockFields, Written, check_exposure, suggest,
};

/// How a material with a reflectance is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Shading {
    /// As a diffuse part and a cos^n highlight: the material's own, or the nearest to its reflectance.
    Classical,
    /// By the reflectance itself.
    Measured,
    /// Through sphere images or slices of it.
    ImageBased,
}

/// Where a form takes the viewer to be.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Viewer {
    /// Where each pixel sees it.
    #[default]
    Pixel,
    /// Along the camera's axis for all pixels: the orthographic reading of the paper.
    Axis,
}

/// A material's reflectance and how it is drawn.
pub struct Measured {
    /// The file as the scene names it, or the model with its parameters.
    pub name: String,
    /// How it is drawn where an exact picture is not asked for; never classical.
    pub shading: Shading,
    /// What is made of it for [`Shading::ImageBased`].
    pub spec: FormSpec,
    /// Where that takes the viewer to be.
    pub viewer: Viewer,
    /// The exposure E that radiance is multiplied by.
    pub exposure: f64,
    /// The keys of a block that is made of it: its file from where the program runs, its exposure.
    pub(super) block: BlockFields,
    /// None of sphere images, which are the form.
    source: Option<Source>,
    form: OnceLock<Arc<Form>>,
}

impl std::fmt::Debug for Measured {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Measured({}, {:?}, {})", self.name, self.shading, self.spec)
    }
}

/// The table `[material.reflectance]` as written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ReflectanceFields {
    file: Option<String>,
    model: Option<String>,
    parameters: Option<Parameters>,
    lookup: Option<Lookup>,
    exposure: Option<f64>,
    pub(super) shading: Option<Shading>,
    form: Option<String>,
    images: Option<Written>,
    size: Option<Written>,
    texel: Option<Written>,
    border: Option<Written>,
    behind: Option<Written>,
    viewer: Option<Viewer>,
}

impl ReflectanceFields {
    /// The reflectance; its file lies where its path leads from `directory`.
    pub(super) fn resolve(self, shading: Shading, directory: &Path) -> Result<Measured, Error> {
        let named = Named::of(self.file.as_deref(), self.model.as_deref(), self.parameters.as_ref())?;
        let (name, source) = match named {
            None => {
                let allowed =
                    "give file: a MERL table, a directory of sphere images or a matcap; or model: the name of one";
                return Err(Error::input("neither file nor model is given", allowed));
            }
            Some(Named::File(file)) => {
                (file.to_owned(), Source::open(&directory.join(file), self.lookup.unwrap_or_default())?)
            }
            Some(Named::Model(model)) => (model.to_string(), Source::Model(model)),
        };
        check_exposure(self.exposure)?;
        let of_file = BlockFields { file: self.file.clone(), lookup: self.lookup, ..BlockFields::default() };
        let keys = [
            ("images", &self.images),
            ("size", &self.size),
            ("texel", &self.texel),
            ("border", &self.border),
            ("behind", &self.behind),
        ];
        let viewer = self.viewer.unwrap_or_default();
        match source {
            Source::Images(form) => {
                let given = keys.iter().find(|(_, value)| value.is_some()).map(|(key, _)| *key);
                if let Some(key) = given.or(self.form.as_ref().map(|_| "form")) {
                    return Err(Error::input(
                        format!("{key} is given, and {name} holds images already"),
                        "leave it out, or give a table or a model",
                    ));
                }
                refuse!(
                    shading != Shading::ImageBased,
                    format!("{name} holds sphere images, and no reflectance"),
                    "shading = \"image-based\", or give a MERL table or a model"
                );
                refuse!(
                    self.exposure.is_some(),
                    format!("exposure is given, and the images of {name} have theirs"),
                    "leave it out, or make the images anew with --exposure"
                );
                let (spec, exposure, form) = (form.spec.clone(), form.exposure, Arc::new(form).into());
                let block = of_file.within(directory)?;
                Ok(Measured { name, shading, spec, viewer, exposure, block, source: None, form })
            }
            Source::Table(_) | Source::Model(_) => {
                let mut spec = FormSpec::of(made(self.form.as_deref().unwrap_or(FormKind::Half.name()), None)?);
                for (key, value) in keys.iter().filter_map(|(key, value)| value.as_ref().map(|value| (key, value))) {
                    spec.set(key, &value.text())?;
                }
                spec.check()?;
                let reflectance = source.reflectance().expect("images alone have none");
                let exposure = self.exposure.unwrap_or_else(|| measure::exposure(reflectance));
                let block = match &source {
                    Source::Model(model) => BlockFields::of_model(model, exposure),
                    _ => BlockFields { exposure: Some(exposure), ..of_file.within(directory)? },
                };
                let (source, form) = (Some(source), OnceLock::new());
                Ok(Measured { name, shading, spec, viewer, exposure, block, source, form })
            }
        }
    }
}

/// A form that is made of a reflectance, by its name; `beside` is what else is known where it stands.
fn made(name: &str, beside: Option<&'static str>) -> Result<FormKind, Error> {
    FormKind::MADE.into_iter().find(|kind| kind.name() == name).ok_or_else(|| {
        let known = FormKind::MADE.into_iter().map(FormKind::name).chain(beside);
        Error::input(format!("there is no form `{name}`"), suggest("forms", name, known))
    })
}

impl Measured {
    /// The reflectance itself; none of sphere images.
    #[must_use]
    pub fn reflectance(&self) -> Option<&dyn Reflectance> {
        self.source.as_ref()?.reflectance()
    }

    /// The model, if its reflectance is one.
    #[must_use]
    pub fn model(&self) -> Option<&Model> {
        match &self.source {
            Some(Source::Model(model)) => Some(model),
            _ => None,
        }
    }

    /// The picture of a sphere with its light in it, if it is one.
    #[must_use]
    pub fn matcap(&self) -> Option<&Form> {
        self.form.get().map(Arc::as_ref).filter(|form| form.spec.kind == FormKind::Matcap)
    }

    /// The viewer that its normals are turned to: a matcap's is the camera.
    #[must_use]
    pub fn seen_by(&self) -> Viewer {
        if self.matcap().is_some() { Viewer::Axis } else { self.viewer }
    }

    /// What stands in place of it as its keys have it; made when it is first asked for.
    ///
    /// # Errors
    /// A sample that does not fit 32 bits.
    pub fn form(&self) -> Result<&Arc<Form>, Error> {
        if let (None, Some(reflectance)) = (self.form.get(), self.reflectance()) {
            let form = self.spec.build(reflectance, self.exposure)?;
            self.form.get_or_init(|| Arc::new(form));
        }
        Ok(self.form.get().expect("sphere images are a form from the first"))
    }

    /// The diffuse and cos^n material that is nearest to it.
    ///
    /// # Errors
    /// Sphere images, which have no reflectance.
    pub fn fitted(&self, model: Highlight, lobes: usize) -> Result<Classical, Error> {
        let reflectance = self.reflectance().ok_or_else(|| {
            Error::input(
                format!("{} holds sphere images, and no reflectance that a material can be fitted to", self.name),
                "give a MERL table or a model",
            )
        })?;
        let cosine = match model {
            Highlight::Blinn => Cosine::Blinn,
            Highlight::Phong => Cosine::Phong,
        };
        classical::fit(reflectance, cosine, lobes, self.exposure, &|| ()).map(|fit| fit.material)
    }
}

/// How one material is drawn in a picture.
#[derive(Clone)]
pub enum Look {
    /// By its reflectance; of sphere images by these.
    Exact(Arc<Measured>),
    /// Through its form.
    Form(Arc<Form>, Viewer),
    /// As a diffuse part and cos^n highlights.
    Classical(Classical),
}

/// How all of a scene's materials are drawn in a picture: none for the classical ones.
#[derive(Clone)]
pub struct Looks {
    /// What it is, in a few words.
    pub name: String,
    /// In the order of [`Scene::materials`].
    pub of: Vec<Option<Look>>,
    /// The memory of all of them in KiB; none where reflectances are evaluated.
    pub kib: Option<f64>,
}

/// What a form is to be in a comparison.
#[derive(Clone, Debug)]
pub enum Compared {
    /// This form.
    Form(FormSpec),
    /// The classical material with so many highlights.
    Fit(usize),
}

impl Compared {
    /// Those of a comparison that does not say which.
    pub const DEFAULT: [&str; 5] = ["paper:images=4", "paper:images=6", "half", "bivariate", "fit"];

    /// Reads `FORM` or `FORM:KEY=VALUE:…`, as in `half:images=8:texel=sqrt:6`, or `fit` or `fit:lobes=2`.
    ///
    /// # Errors
    /// An unknown form or key, a value out of range.
    pub fn parse(text: &str) -> Result<Self, Error> {
        let mut parts = text.split(':');
        let name = parts.next().unwrap_or_default();
        // A texel's name has colons of its own.
        let mut keys: Vec<(String, String)> = Vec::new();
        for part in parts {
            match (part.split_once('='), keys.last_mut()) {
                (Some((key, value)), _) => keys.push((key.to_owned(), value.to_owned())),
                (None, Some((_, value))) => *value += &format!(":{part}"),
                (None, None) => {
                    return Err(Error::input(
                        format!("`{part}` in `{text}` is no key with its value"),
                        "write FORM:KEY=VALUE, as in half:images=8:size=64",
                    ));
                }
            }
        }
        if name == "fit" {
            let mut lobes = 1;
            for (key, value) in &keys {
                let count = value.parse().ok().filter(|count| (1..=classical::MOST_LOBES).contains(count));
                lobes = count.filter(|_| key == "lobes").ok_or_else(|| {
                    Error::input(
                        format!("`{key}={value}` in `{text}`"),
                        format!("fit has the key lobes: 1 to {}", classical::MOST_LOBES),
                    )
                })?;
            }
            return Ok(Self::Fit(lobes));
        }
        let mut spec = FormSpec::of(made(name, Some("fit"))?);
        keys.iter().try_for_each(|(key, value)| spec.set(key, value))?;
        spec.check()?;
        Ok(Self::Form(spec))
    }
}

impl Scene {
    /// The reflectance by which a material is drawn; none of a classical one.
    #[must_use]
    pub fn reflectance(&self, material: usize) -> Option<&Arc<Measured>> {
        self.reflectances[material].as_ref()
    }

    /// Whether an object is drawn by its reflectance.
    #[must_use]
    pub fn is_measured(&self) -> bool {
        self.objects.iter().any(|object| self.reflectance(object.material).is_some())
    }

    /// Whether an object is drawn with highlights of cos^n.
    #[must_use]
    pub fn has_highlights(&self) -> bool {
        self.objects.iter().any(|object| self.reflectance(object.material).is_none())
    }

    /// The materials with a reflectance that objects have, by their places in [`Scene::materials`].
    pub fn measured_places(&self) -> impl Iterator<Item = usize> {
        let used = |place: &usize| self.objects.iter().any(|object| object.material == *place);
        (0..self.materials.len()).filter(used).filter(|&place| self.reflectance(place).is_some())
    }

    /// The reflectances that objects have, each once, with their materials' names.
    pub fn measured(&self) -> impl Iterator<Item = (&str, &Arc<Measured>)> {
        self.measured_places().filter_map(|place| Some((self.materials[place].name.as_str(), self.reflectance(place)?)))
    }

    fn looks(
        &self,
        name: String,
        left: &[usize],
        look: impl Fn(&Arc<Measured>) -> Result<(Look, Option<f64>), Error>,
    ) -> Result<Looks, Error> {
        let mut kib = Some(0.0);
        let mut one = |measured: &Arc<Measured>| {
            let (look, own) = look(measured)?;
            kib = kib.zip(own).map(|(sum, own)| sum + own);
            Ok(look)
        };
        let used = |place: usize| !left.contains(&place) && self.objects.iter().any(|object| object.material == place);
        let of = self.reflectances.iter().enumerate();
        let of = of
            .map(|(place, measured)| measured.as_ref().filter(|_| used(place)).map(&mut one).transpose())
            .collect::<Result<_, Error>>()?;
        Ok(Looks { name, of, kib })
    }

    /// All materials by their reflectances.
    ///
    /// # Errors
    /// None.
    pub fn exact_looks(&self) -> Result<Looks, Error> {
        self.exact_looks_but(&[])
    }

    /// The same without some of them, by their places, which are drawn in another way.
    pub(super) fn exact_looks_but(&self, left: &[usize]) -> Result<Looks, Error> {
        self.looks("exact".to_owned(), left, |measured| Ok((Look::Exact(Arc::clone(measured)), None)))
    }

    /// All materials as the scene says.
    ///
    /// # Errors
    /// As [`Measured::form`].
    pub fn own_looks(&self) -> Result<Looks, Error> {
        self.own_looks_but(&[])
    }

    /// The same without some of them, by their places, which are drawn in another way.
    pub(crate) fn own_looks_but(&self, left: &[usize]) -> Result<Looks, Error> {
        self.looks("image-based".to_owned(), left, |measured| match measured.shading {
            Shading::ImageBased => {
                let form = measured.form()?;
                Ok((Look::Form(Arc::clone(form), measured.viewer), Some(form.kib())))
            }
            _ => Ok((Look::Exact(Arc::clone(measured)), None)),
        })
    }

    /// All materials in the same way.
    ///
    /// # Errors
    /// A material without a reflectance of its own; as [`FormSpec::build`].
    pub fn compared_looks(&self, compared: &Compared) -> Result<Looks, Error> {
        match compared {
            Compared::Fit(lobes) => {
                self.looks(format!("fitted cos^n, {}", counted(*lobes as u64, "lobe")), &[], |measured| {
                    let fitted = measured.fitted(self.model, *lobes)?;
                    let kib = fitted.kib();
                    Ok((Look::Classical(fitted), Some(kib)))
                })
            }
            Compared::Form(spec) => self.looks(spec.to_string(), &[], |measured| {
                let reflectance = measured.reflectance().ok_or_else(|| {
                    Error::input(
                        format!("{} holds sphere images, and no reflectance to make others of", measured.name),
                        "give the material a MERL table or a model",
                    )
                })?;
                let form = spec.build(reflectance, measured.exposure)?;
                let kib = form.kib();
                Ok((Look::Form(Arc::new(form), measured.viewer), Some(kib)))
            }),
        }
    }
}

/// The least cosine of a normal and the direction to the viewer: interpolated normals that turn away near an outline
/// are turned back so far, or the outline would be black.
const LEAST_COSINE: f64 = 0.01;

/// The normal, turned towards the viewer as far as is needed to be seen.
fn facing(n: Vector, v: Vector) -> Vector {
    let cosine = n.dot(&v);
    if cosine >= LEAST_COSINE {
        return n;
    }
    let across = (n - v * cosine).try_normalize(1e-12).unwrap_or_else(|| v.cross(&super::ray::across(v)));
    across * libm::sqrt(1.0 - LEAST_COSINE * LEAST_COSINE) + v * LEAST_COSINE
}

/// The camera's frame: turns directions so that the viewer is at +Z.
pub(super) struct Axes([Vector; 3]);

impl Axes {
    pub(super) fn of(scene: &Scene) -> Self {
        Self(scene.camera.axes().map(Vector::from))
    }

    fn turned(&self, a: Vector) -> Vector {
        Vector::new(a.dot(&self.0[0]), a.dot(&self.0[1]), -a.dot(&self.0[2]))
    }
}

impl Viewer {
    /// A light and a normal as this viewer sees them: turned so that it is at +Z.
    fn seen(self, axes: &Axes, l: Vector, v: Vector, n: Vector) -> (Light, Vector) {
        match self {
            Self::Pixel => vector::seen_from(l, v, n),
            Self::Axis => (Light::towards(axes.turned(l)), axes.turned(n)),
        }
    }
}

/// A point as its looks are given it.
pub(super) struct Sight {
    n: Vector,
    v: Vector,
    /// Of each light that shines there its direction and its colour.
    lights: Vec<(Vector, Colour)>,
}

impl Sight {
    pub(super) fn of(tracer: &Tracer, scene: &Scene, hit: &Hit) -> Self {
        let v = Vector::from(hit.viewer);
        let light = |(place, light): (usize, &super::Light)| {
            let lit = tracer.light(scene, hit, place);
            lit.visible.then(|| (lit.direction.into(), light.colour))
        };
        let lights = scene.lights.iter().enumerate().filter_map(light).collect();
        Self { n: facing(Vector::from(hit.normal), v), v, lights }
    }

    /// The normal and the lights that shine there, with their colours, as a viewer sees them.
    pub(super) fn as_seen(&self, axes: &Axes, viewer: Viewer) -> (Vector, Vec<(Light, Colour)>) {
        let &Self { n, v, .. } = self;
        // The normal is the same whatever the light.
        let (_, normal) = viewer.seen(axes, v, v, n);
        (normal, self.lights.iter().map(|(l, colour)| (viewer.seen(axes, *l, v, n).0, *colour)).collect())
    }

    /// The sum over the lights of their colours times a radiance.
    fn sum(&self, of: impl Fn(Vector) -> Colour) -> Colour {
        self.lights.iter().fold([0.0; 3], |sum, (l, colour)| {
            let own = of(*l);
            [0, 1, 2].map(|c| sum[c] + colour[c] * own[c])
        })
    }
}

impl Look {
    pub(super) fn radiance(&self, axes: &Axes, sight: &Sight) -> Colour {
        let &Sight { n, v, .. } = sight;
        let (form, viewer) = match self {
            Self::Exact(measured) => match measured.reflectance() {
                Some(reflectance) => {
                    return sight.sum(|l| {
                        let cosine = n.dot(&l);
                        if cosine <= 0.0 {
                            return [0.0; 3];
                        }
                        reflectance.at(l, v, n).map(|f| measured.exposure * f * cosine)
                    });
                }
                None => (measured.form.get().expect("sphere images are a form from the first"), measured.viewer),
            },
            Self::Form(form, viewer) => (form, *viewer),
            Self::Classical(classical) => {
                return sight.sum(|l| {
                    let (light, n) = vector::seen_from(l, v, n);
                    classical.at(light, n)
                });
            }
        };
        if form.spec.kind == FormKind::Matcap {
            // The picture of a sphere has its light in it.
            return form.at(Light::new(0.0, 0.0), axes.turned(n));
        }
        sight.sum(|l| {
            let (light, n) = viewer.seen(axes, l, v, n);
            form.at(light, n)
        })
    }
}

/// The normals of the pixels that show objects as the camera has them, one axis after the other: what distant lights
/// need where the viewer is taken to be along the camera's axis. It is made once for any number of lights.
#[derive(Clone, Debug)]
pub struct Seen([Vec<f32>; 3]);

impl Seen {
    /// The normals that a scene's picture shows.
    #[must_use]
    pub fn of(tracer: &Tracer, scene: &Scene) -> Self {
        let axes = Axes::of(scene);
        let of_row = |row: u32| -> Vec<Vector> {
            let hits = tracer.row(scene, row).into_iter().flatten();
            hits.map(|hit| axes.turned(facing(Vector::from(hit.normal), Vector::from(hit.viewer)))).collect()
        };
        let rows: Vec<Vec<Vector>> = (0..scene.height).into_par_iter().map(of_row).collect();
        Self([0, 1, 2].map(|axis| rows.iter().flatten().map(|n| n[axis] as f32).collect()))
    }

    /// The radiance of each through a form, under lights of the colour 1 that are made ready.
    ///
    /// # Panics
    /// If a record is another form's.
    #[must_use]
    pub fn through(&self, form: &Form, records: &[Record]) -> Vec<[f32; 3]> {
        const PART: usize = 4096;
        let mut out = vec![[0.0; 3]; self.0[0].len()];
        out.par_chunks_mut(PART).enumerate().for_each(|(part, out)| {
            let normals = [0, 1, 2].map(|axis| &self.0[axis][part * PART..][..out.len()]);
            records.iter().for_each(|record| form.add(record, 1.0, normals, out));
        });
        out
    }
}

/// The peak signal-to-noise ratio in dB of channels in units of full scale, clamped to 0 to 1, over the pixels that
/// show objects; none where they are the same or there is no object.
#[must_use]
pub fn psnr(frame: &Frame, exact: &[Colour], own: &[Colour]) -> Option<f64> {
    let pixels = frame.material.iter().zip(exact.iter().zip(own)).filter(|(material, _)| **material != BACKGROUND);
    measure::ratio(pixels.flat_map(|(_, (exact, own))| exact.iter().copied().zip(own.iter().copied())))
}
