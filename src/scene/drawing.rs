//! A scene drawn exactly and otherwise: the pictures compared and judged, and what is said of them.

use clap::ValueEnum;
use serde::Serialize;

use super::cores::PictureCore;
use super::reflectance::{self, Looks, Shading, Viewer};
use super::require::PictureError;
use super::sheet::{self, Cell, Panel, Sheet};
use super::{Difference, Frame, Picture, Scene, cores, picture};
use crate::core::{BlockDesign, Design};
use crate::emit::package::counted;
use crate::explore::Cost;
use crate::method::word;
use crate::platform::error::Error;
use crate::spec::Colour;

/// What a picture's file shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Only {
    /// Exact, core and difference, with figures
    All,
    /// The picture with `x^n` in double precision
    Exact,
    /// The core's picture
    Core,
    /// How far the core's picture is off, as a heat map
    Difference,
}

/// A picture, and its channels before they are rounded.
pub(crate) struct Drawn {
    /// The picture.
    pub(crate) picture: Picture,
    channels: Vec<Colour>,
}

impl Drawn {
    /// The picture of this base and these values of the lobes, as [`Frame::channels`] takes them.
    pub(crate) fn of(scene: &Scene, frame: &Frame, base: &[Colour], highlights: &[f64]) -> Self {
        let channels = frame.channels(scene, base, highlights);
        Self { picture: frame.codes(scene.channel_bits, &channels), channels }
    }
}

/// A picture beside the exact one.
#[derive(Debug)]
pub(crate) struct Own {
    /// The picture.
    pub(crate) picture: Picture,
    /// How it differs from the exact one.
    pub(crate) difference: Difference,
    /// The ratio on linear values, over objects; none where they are the same.
    pub(crate) psnr: Option<f64>,
}

impl Own {
    /// Compares a picture with the exact one.
    pub(crate) fn of(frame: &Frame, exact: &Drawn, drawn: Drawn) -> Self {
        let difference = Difference::of(&exact.picture, &drawn.picture);
        Self { difference, psnr: reflectance::psnr(frame, &exact.channels, &drawn.channels), picture: drawn.picture }
    }

    /// As a cell of a contact sheet of forms.
    pub(crate) fn cell_of_form(self, looks: &Looks) -> Cell {
        Cell {
            name: looks.name.clone(),
            picture: self.picture,
            difference: self.difference,
            lines: vec![format!("{} KiB", kib_text(looks.kib.unwrap_or_default()))],
            verdict: linear_text(self.psnr),
        }
    }
}

/// A scene's pictures with what is to be said of them.
pub(crate) struct Drawing<'a> {
    scene: &'a Scene,
    frame: &'a Frame,
    exact: Picture,
    /// The core that the other picture is drawn through, where one is.
    pub(crate) design: Option<&'a Design>,
    /// The other picture, where one is asked for.
    pub(crate) own: Option<Own>,
    /// How its measured materials are drawn.
    pub(crate) materials: Vec<MaterialText>,
    /// What of the scene's budget the other picture misses, in words; none where it is not judged by it.
    pub(crate) missed: Option<Vec<String>>,
    /// The judgement in a line.
    pub(crate) verdict: String,
}

impl<'a> Drawing<'a> {
    /// Judges the pictures. Without a budget of its own, a picture through images is only measured.
    pub(crate) fn of(
        scene: &'a Scene,
        frame: &'a Frame,
        exact: Picture,
        core: Option<&'a PictureCore>,
        own: Option<Own>,
    ) -> Result<Self, Error> {
        let measured = scene.is_measured();
        let judged = !measured || scene.has_budget;
        let missed = own.as_ref().filter(|_| judged).map(|own| missed(scene, &own.difference));
        let mut verdict = match missed.as_deref().unwrap_or_default() {
            _ if !judged => "no budget is given".to_owned(),
            [] => format!("within the budget: {}", budget_text(scene)),
            missed => missed.join("; "),
        };
        if let (true, Some(own)) = (measured, &own) {
            verdict = format!("{}; {verdict}", linear_text(own.psnr));
        }
        let materials = if measured { materials_of(scene, core)? } else { Vec::new() };
        let design = core.map(|core| &core.design);
        Ok(Self { scene, frame, exact, design, own, materials, missed, verdict })
    }

    /// The picture file, and where on it the pictures are if there are several.
    pub(crate) fn png(&self, only: Only) -> (Vec<u8>, Option<Vec<Panel>>) {
        let pixels = match (only, &self.own) {
            (Only::All, Some(own)) => {
                let core = self.design.map(cores::text);
                let drawn = self.materials.iter().map(MaterialText::to_string);
                let lines: Vec<String> =
                    [scene_text(self.scene, self.frame)].into_iter().chain(core).chain(drawn).collect();
                let is_core = self.design.is_some_and(|design| !design.spec.block.has_lobe());
                let what = if self.scene.is_measured() && !is_core { "through images" } else { "core" };
                let pictures = [&self.exact, &own.picture];
                let Sheet { pixels, panels } = sheet::triptych(
                    self.frame,
                    pictures,
                    what,
                    &own.difference,
                    &self.scene.name,
                    &lines,
                    &self.verdict,
                );
                return (pixels.png(), Some(panels));
            }
            (Only::Core, Some(own)) => own.picture.pixels(),
            (Only::Difference, Some(own)) => sheet::heat_map(self.frame, &own.difference, 8),
            _ => self.exact.pixels(),
        };
        (pixels.png(), None)
    }

    /// Both pictures and their difference as OpenEXR; none if there is only one picture.
    pub(crate) fn exr(&self) -> Result<Option<Vec<u8>>, Error> {
        self.own.as_ref().map(|own| picture::exr(&self.exact, &own.picture)).transpose()
    }
}

/// How a measured material is drawn, for people and programs.
#[derive(Serialize)]
pub(crate) struct MaterialText {
    /// The material's name.
    pub(crate) name: String,
    /// What its reflectance is.
    pub(crate) reflectance: String,
    shading: Shading,
    form: Option<String>,
    kib: Option<f64>,
    viewer: Viewer,
    exposure: f64,
}

impl std::fmt::Display for MaterialText {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { name, reflectance, form, kib, viewer, exposure, .. } = self;
        write!(f, "material {name}: {reflectance}, exposure {exposure:.4}, ")?;
        match form.as_ref().zip(*kib) {
            None => write!(f, "evaluated exactly"),
            Some((form, kib)) => {
                let viewer = if *viewer == Viewer::Axis { ", the viewer along the axis" } else { "" };
                write!(f, "drawn through {form}, {} KiB{viewer}", kib_text(kib))
            }
        }
    }
}

/// How the scene's measured materials are drawn: those of an image-based core through it.
pub(crate) fn materials_of(scene: &Scene, core: Option<&PictureCore>) -> Result<Vec<MaterialText>, Error> {
    let text = |place: usize| {
        let measured = scene.reflectance(place).expect("a material with a reflectance");
        let through = core.filter(|core| core.materials.contains(&place)).map(|core| &core.design);
        let (form, kib) = match through.map(|design| (design, design.block())) {
            Some((design, BlockDesign::Image(image))) => {
                (Some(format!("the core {}", design.spec.name)), Some(image.block.texels().kib()))
            }
            _ if measured.shading == Shading::ImageBased => {
                let form = measured.form()?;
                (Some(form.spec.to_string()), Some(form.kib()))
            }
            _ => (None, None),
        };
        Ok(MaterialText {
            name: scene.materials[place].name.clone(),
            reflectance: measured.name.clone(),
            shading: measured.shading,
            form,
            kib,
            viewer: measured.viewer,
            exposure: measured.exposure,
        })
    };
    scene.measured_places().map(text).collect()
}

/// A core's cell of a contact sheet, and whether it keeps the scene's budget.
pub(crate) fn cell_of_core(
    scene: &Scene,
    exact: &Picture,
    design: &Design,
    picture: Picture,
    cost: &Cost,
) -> (Cell, bool) {
    let difference = Difference::of(exact, &picture);
    let kept = missed(scene, &difference).is_empty();
    let verdict = if kept { "keeps the budget" } else { "misses the budget" }.to_owned();
    (Cell { name: cores::name(design), picture, difference, lines: cores::cost_lines(cost), verdict }, kept)
}

fn kib_text(kib: f64) -> String {
    if kib < 10.0 { format!("{kib:.2}") } else { format!("{kib:.0}") }
}

/// The ratio on linear values, over the pixels that show objects, as reflectances are judged.
fn linear_text(psnr: Option<f64>) -> String {
    psnr.map_or_else(
        || "the same picture".to_owned(),
        |psnr| format!("PSNR {psnr:.1} dB on linear values of the objects"),
    )
}

/// What of the scene's budget a picture misses, in words.
fn missed(scene: &Scene, difference: &Difference) -> Vec<String> {
    let error = PictureError::of(difference, scene.channel_bits);
    scene.budget.missed(&error, "the picture").into_iter().map(|(_, why)| why).collect()
}

/// The scene's budget for a picture, in words.
pub(crate) fn budget_text(scene: &Scene) -> String {
    let (steps, psnr) = scene.budget.limits();
    let steps = steps.map(|steps| format!("at most {steps} {} off", if steps == 1 { "step" } else { "steps" }));
    let psnr = psnr.map(|psnr| format!("a PSNR of at least {psnr} dB"));
    steps.into_iter().chain(psnr).collect::<Vec<_>>().join(", ")
}

/// A scene and the size of its picture, in a line.
pub(crate) fn scene_text(scene: &Scene, frame: &Frame) -> String {
    let lights = counted(scene.lights.len() as u64, "light");
    let lobes = if scene.has_highlights() {
        format!("{}, {lights}, {} samples", word(&scene.model), frame.samples())
    } else {
        lights
    };
    format!("{} × {} pixels, {} bits a channel, {lobes}", frame.width, frame.height, scene.channel_bits)
}
