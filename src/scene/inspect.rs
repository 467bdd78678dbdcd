//! All that is found of a scene: what it requires, the core that this is, its pictures, and what it leaves out.

use std::sync::atomic::{AtomicUsize, Ordering};

use super::choice::{SceneChoice, Search, Verified};
use super::document::Findings;
use super::shade::{self, Shaded};
use super::simplify::{Simplification, simplifications};
use super::{Requirements, Scene};
use crate::core::Design;
use crate::explore::run::Costing;
use crate::generate::Core;
use crate::platform::error::{Error, refuse};
use crate::spec::{BlockKind, ShaderFields, SpecFields};

/// What is found of a scene, with a core or without.
#[derive(Debug)]
pub struct SceneInspection {
    /// What it requires.
    pub requirements: Requirements,
    /// The choice of its core.
    pub choice: SceneChoice,
    /// The chosen core, built, with what it leaves out and its pictures; none where no core keeps the budget.
    pub core: Option<(Design, Vec<Simplification>, Verified)>,
    /// The shader around it, where one is asked for.
    pub shaded: Option<Shaded>,
}

impl SceneInspection {
    /// Inspects a scene with its camera and lights moved by `margin_degrees`, as [`Requirements::of`] does; `keys` of
    /// the core win over those of the scene. `progress` is told what is done, how much of it and of how much.
    ///
    /// # Errors
    /// A scene that needs no core, keys that do not go with a scene or that make no core, or a tool that is missing or
    /// fails.
    pub fn of(
        scene: &Scene,
        margin_degrees: f64,
        costing: &Costing,
        keys: &SpecFields,
        progress: &(dyn Fn(&'static str, usize, usize) + Sync),
    ) -> Result<Self, Error> {
        // The lobe is chosen as if it were alone.
        let asked = keys.clone().or(scene.core.keys.clone());
        refuse!(
            asked.block == Some(BlockKind::Image),
            "an image-based block is asked for, and a scene's core is a lobe or a shader",
            "leave block = \"image\" out: `brdfgen generate --block image --reflectance ...` makes one without a scene"
        );
        let alone = |keys: &SpecFields| SpecFields { block: None, shader: ShaderFields::default(), ..keys.clone() };
        let mut lobe_scene = scene.clone();
        lobe_scene.core.keys = alone(&scene.core.keys);
        let scene = &lobe_scene;
        let requirements = Requirements::of(scene, margin_degrees, &|done, of| progress("rendering", done, of))?;
        let search = Search::new(scene, &requirements, costing, &alone(keys))?;
        let mut choice = search.choose(progress)?;
        let shader = asked.block == Some(BlockKind::Shader);
        if !shader && !asked.shader.is_empty() {
            return Err(Error::input("keys of a shader are given for a lobe", "use --block shader, or leave them out"));
        }
        let drawn = AtomicUsize::new(0);
        let draw = || progress("drawing the scene through its shader", drawn.fetch_add(1, Ordering::Relaxed) + 1, 0);
        let shaded = if shader {
            shade::around(&search, &mut choice, (scene, &requirements), &asked.shader, &draw)?
        } else {
            None
        };
        let core = match &choice.chosen {
            None => None,
            Some(chosen) => {
                progress("verifying", 0, 1);
                let design = Design::new(chosen.spec()?.resolve()?)?;
                let verified = search.verified(&design)?;
                Some((design, simplifications(scene, &requirements, &search, chosen)?, verified))
            }
        };
        Ok(Self { requirements, choice, core, shaded })
    }

    /// Whether there is a core that keeps the budget, and a shader around it where one is asked for.
    #[must_use]
    pub fn is_kept(&self) -> bool {
        self.core.is_some() && self.shaded.as_ref().is_none_or(|shaded| shaded.missed.is_empty())
    }

    /// What there is to say of the chosen core, for documents.
    #[must_use]
    pub fn findings<'a>(&'a self, scene: &'a Scene) -> Option<Findings<'a>> {
        let Self { requirements, choice, core, shaded } = self;
        let (chosen, (design, simplifications, verified)) = choice.chosen.as_ref().zip(core.as_ref())?;
        Some(Findings {
            scene,
            requirements,
            choice,
            chosen,
            simplifications,
            design,
            verified,
            shaded: shaded.as_ref(),
        })
    }

    /// The core, or the shader around it, with the scene's files beside its own; none where none keeps the budget.
    ///
    /// # Errors
    /// As [`Core::of`], and a picture or page of the scene that cannot be made.
    pub fn generate(self, scene: &Scene) -> Result<Option<Core>, Error> {
        let files = self.findings(scene).filter(|_| self.is_kept()).map(|findings| findings.files()).transpose()?;
        let lobe = self.core.map(|(design, ..)| design);
        let design = self.shaded.map(|shaded| shaded.design).or(lobe);
        design.zip(files).map(|(design, files)| Core::of(design, files)).transpose()
    }
}
