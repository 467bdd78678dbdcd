//! What an image-based core of a scene says of itself: `scene.md`, `scene.json` and a contact sheet, `scene.png`.

use askama::Template;
use serde_json::json;

use super::document::{FILES, budget_text};
use super::image_choice::{COMPARED, ImageCandidate, ImageChoice};
use super::reflectance::Viewer;
use super::require::PictureError;
use super::sheet::{self, Sheet};
use super::{Scene, drawing};
use crate::core::Design;
use crate::emit::package::{File, rounded};
use crate::emit::render;
use crate::explore::dominates;
use crate::generate::Core;
use crate::platform::error::Error;

/// The most candidates of a contact sheet.
const CELLS: usize = 8;

impl ImageCandidate {
    /// What it is, in a few words.
    #[must_use]
    pub fn title(&self) -> String {
        if self.fitted { format!("fitted cos^n shader, {}", self.name) } else { self.name.clone() }
    }

    /// Whether it keeps the budget, or what it misses, in words.
    #[must_use]
    pub fn verdict(&self) -> String {
        match self.missed.as_slice() {
            [] => "keeps the budget".to_owned(),
            [missed] if missed.starts_with(COMPARED) => "misses the budget".to_owned(),
            missed => missed.join("; "),
        }
    }
}

impl ImageChoice {
    /// The chosen candidate.
    #[must_use]
    pub fn chosen(&self) -> Option<&ImageCandidate> {
        self.candidates.get(self.chosen?)
    }

    /// The fitted shader, if it keeps the budget and is no dearer than the chosen core: all before that one are.
    #[must_use]
    pub fn cheaper_shader(&self) -> Option<&ImageCandidate> {
        let before = self.chosen.unwrap_or(self.candidates.len());
        self.candidates[..before].iter().find(|candidate| candidate.fitted && candidate.missed.is_empty())
    }

    /// The candidates of the contact sheet: the chosen one, the shader, and of those that no other is both cheaper and
    /// better than the nearest to the chosen one in their order.
    fn shown(&self, scene: &Scene) -> Vec<&ImageCandidate> {
        let objective = scene.core.objective;
        let place = |one: &ImageCandidate| [f64::from(objective.of(&one.cost)), -one.psnr.unwrap_or(f64::INFINITY)];
        let all: Vec<[f64; 2]> = self.candidates.iter().map(place).collect();
        let middle = self.chosen.unwrap_or(self.candidates.len());
        let named = |place: usize| Some(place) == self.chosen || self.candidates[place].fitted;
        let mut front: Vec<usize> =
            (0..all.len()).filter(|&own| named(own) || !all.iter().any(|other| dominates(other, &all[own]))).collect();
        front.sort_by_key(|&place| (!named(place), place.abs_diff(middle)));
        front.truncate(CELLS);
        front.sort_unstable();
        front.into_iter().map(|place| &self.candidates[place]).collect()
    }

    /// The contact sheet: the exact picture, then candidates with what each takes.
    fn sheet(&self, scene: &Scene) -> Sheet {
        let (frame, exact) = &self.compared;
        let cell = |one: &ImageCandidate| {
            let (cell, _) = drawing::cell_of_core(scene, exact, &one.design, one.own.picture.clone(), &one.cost);
            sheet::Cell { name: one.title(), verdict: one.verdict(), ..cell }
        };
        let cells: Vec<sheet::Cell> = self.shown(scene).into_iter().map(cell).collect();
        let lines = [
            drawing::scene_text(scene, frame),
            format!("{}: {}; budget: {}", self.material, self.reflectance, budget_text(&scene.budget)),
            format!("cost for {}{}", scene.core.family.name, self.source()),
        ];
        sheet::contact(frame, exact, &cells, &scene.name, &lines)
    }

    /// Where the costs come from, in words behind a family's name.
    #[must_use]
    pub fn source(&self) -> &'static str {
        match self.candidates.iter().any(|one| !one.cost.estimated) {
            true => ", measured where the budget is kept and the core is among the cheapest, otherwise estimated",
            false => ", estimated by a cost model of lobes, without the sequencer",
        }
    }

    /// For programs.
    #[must_use]
    pub fn json(&self, scene: &Scene) -> serde_json::Value {
        let (max_steps, min_psnr) = scene.budget.limits();
        let budget = json!({ "max_steps": max_steps, "min_psnr": min_psnr });
        rounded(json!({ "scene": scene.name, "budget": budget, "family": scene.core.family, "choice": self }))
    }

    /// The files beside the chosen core; none where none is chosen.
    ///
    /// # Errors
    /// If the template cannot be filled in.
    pub fn files(&self, scene: &Scene) -> Result<Option<Vec<File>>, Error> {
        let Some((chosen, verified)) = self.chosen().zip(self.verified) else { return Ok(None) };
        let viewer = scene.measured().find(|(name, _)| *name == self.material).map(|(_, measured)| measured.seen_by());
        let page = Page {
            scene,
            design: &chosen.design,
            material: &self.material,
            reflectance: &self.reflectance,
            budget: budget_text(&scene.budget),
            viewer: if viewer == Some(Viewer::Axis) { "that of the camera" } else { "another for each pixel" },
            errors: vec![("whole", verified[0]), ("moved, the worst of each", verified[1])],
            size: self.size,
            source: self.source(),
            candidates: &self.candidates,
        };
        let json = serde_json::to_string_pretty(&self.json(scene)).expect("JSON of plain values") + "\n";
        let bytes = [render(&page)?.into_bytes(), json.into_bytes(), self.sheet(scene).pixels.png()];
        let file = |(path, bytes): (&str, Vec<u8>)| File { path: path.to_owned(), bytes };
        Ok(Some(FILES.into_iter().zip(bytes).map(file).collect()))
    }

    /// The chosen core with the scene's files beside its own; none where none keeps the budget.
    ///
    /// # Errors
    /// As [`Core::of`] and [`ImageChoice::files`].
    pub fn generate(mut self, scene: &Scene) -> Result<Option<Core>, Error> {
        let Some((place, files)) = self.chosen.zip(self.files(scene)?) else { return Ok(None) };
        Core::of(self.candidates.swap_remove(place).design, files).map(Some)
    }
}

/// The page.
#[derive(Template)]
#[template(path = "scene/image.md", escape = "none")]
struct Page<'a> {
    scene: &'a Scene,
    design: &'a Design,
    material: &'a str,
    reflectance: &'a str,
    budget: String,
    viewer: &'static str,
    errors: Vec<(&'static str, PictureError)>,
    size: [u32; 2],
    source: &'static str,
    candidates: &'a [ImageCandidate],
}

/// How the template writes figures that may be missing.
mod filters {
    use askama::{Result, Values, filter_fn};

    use crate::scene::document::psnr_text;

    /// A ratio in dB.
    #[filter_fn]
    pub(super) fn psnr(psnr: &Option<f64>, _: &dyn Values) -> Result<String> {
        Ok(psnr_text(*psnr))
    }

    /// A frequency.
    #[filter_fn]
    pub(super) fn mhz(mhz: &Option<f64>, _: &dyn Values) -> Result<String> {
        Ok(mhz.map_or_else(|| "not known".to_owned(), |mhz| format!("{mhz:.0}")))
    }
}
