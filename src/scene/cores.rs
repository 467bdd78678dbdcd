//! The cores that a scene's picture is drawn through, lobes and image-based blocks: named by keys or by a file, or
//! chosen for the scene.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

use clap::ValueEnum;
use serde::Serialize;

use super::choice::Search;
use super::image_core::{self, Points};
use super::{Compiled, CoreModel, Frame, Highlights, Requirements, Scene, Tracer};
use crate::core::{BlockDesign, Design};
use crate::emit::package::{self, Part, counted};
use crate::explore::run::Costing;
use crate::explore::sweep::Core;
use crate::explore::{Cost, Point};
use crate::platform::error::{Error, refuse};
use crate::platform::{input, tool};
use crate::spec::{Block, BlockKind, ImageFormName, Shininess, SpecFields};
use crate::target::Family;
use crate::verify::cosim;

/// What computes a core's highlights.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum, Serialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Through {
    /// The bit-exact model
    Model,
    /// The core's own HDL, compiled
    Verilator,
}

/// A core that a picture is drawn through.
#[derive(Clone, Debug)]
pub(crate) struct PictureCore {
    /// The core.
    pub(crate) design: Design,
    /// Where it is on disk, if it is taken from there as it is.
    directory: Option<PathBuf>,
    /// The materials that are drawn through an image-based core, as places in [`Scene::materials`].
    pub(crate) materials: Vec<usize>,
}

impl PictureCore {
    /// The core of these keys: a lobe for the shininesses of the materials of the scene's objects, or an image-based
    /// block of the reflectance of its material, unless the keys name some.
    fn of(scene: &Scene, fields: SpecFields) -> Result<Self, Error> {
        match fields.block {
            Some(BlockKind::Image) => Self::of_image(scene, fields),
            Some(kind @ BlockKind::Shader) => Err(Error::input(
                format!("the core is {}, and a picture's highlights need a lobe", kind.noun()),
                "leave `block` and its other keys out",
            )),
            Some(BlockKind::Lobe) | None => {
                refuse!(
                    !scene.has_highlights(),
                    "the core is a lobe, and all objects of the scene are drawn by a reflectance",
                    "give an image-based core, leave the core out, or give the materials shading = \"classical\""
                );
                let own = fields.shininess.is_some() || fields.material.is_some();
                let shininess = if own { fields.shininess.clone() } else { Some(Shininess::List(scene.shininesses())) };
                let design = Design::new(SpecFields { shininess, ..fields }.resolve()?)?;
                Ok(Self { design, directory: None, materials: Vec::new() })
            }
        }
    }

    fn of_image(scene: &Scene, fields: SpecFields) -> Result<Self, Error> {
        refuse!(
            !scene.is_measured(),
            format!(
                "the core is an image-based block, and the scene {} has no material with a reflectance",
                scene.name
            ),
            "give a material that an object has a table [material.reflectance], or draw the scene through a lobe"
        );
        let mut all = scene.measured_places();
        let fields = match (fields.reflectance.is_empty(), all.next(), all.next()) {
            (true, Some(only), None) => {
                let measured = scene.reflectance(only);
                let reflectance = measured.map(|measured| measured.block.clone()).unwrap_or_default();
                let is_matcap = measured.is_some_and(|measured| measured.matcap().is_some());
                let image_form = fields.image_form.or(is_matcap.then_some(ImageFormName::Matcap));
                let output_bits = fields.output_bits.or(Some(scene.channel_bits));
                SpecFields { reflectance, output_bits, image_form, ..fields }
            }
            _ => fields,
        };
        let design = Design::new(fields.resolve()?)?;
        let BlockDesign::Image(image) = design.block() else { unreachable!("an image-based block was asked for") };
        let materials = image_core::materials(scene, image)?;
        Ok(Self { materials, design, directory: None })
    }

    /// The core of keys with a method, and where one is missing that of the scene's `[core]` that any core may have.
    pub(crate) fn of_keys(scene: &Scene, keys: SpecFields) -> Result<Self, Error> {
        if keys.block == Some(BlockKind::Image) {
            return Self::of(scene, keys);
        }
        let own = scene.core.keys.clone();
        let own = SpecFields {
            input_fraction: own.input_fraction,
            output_fraction: own.output_fraction,
            operand: own.operand,
            pipeline: own.pipeline,
            ..SpecFields::default()
        };
        Self::of(scene, keys.or(own))
    }

    /// The core of a spec file or of a core's directory; `keys` win over it.
    pub(crate) fn of_file(scene: &Scene, path: &Path, keys: SpecFields) -> Result<Self, Error> {
        let directory = (path.is_dir() && keys == SpecFields::default()).then(|| path.to_owned());
        Ok(Self { directory, ..Self::of(scene, keys.or(read(path)?))? })
    }

    /// The core that a comparison names: `METHOD`, `METHOD:KEY=VALUE:...`, a spec file or a directory; `keys` win over
    /// it.
    pub(crate) fn named(scene: &Scene, entry: &str, keys: SpecFields) -> Result<Self, Error> {
        let path = Path::new(entry);
        let fields = if path.exists() {
            read(path)?
        } else {
            let mut parts = entry.split(':');
            let mut text = format!("method = {:?}\n", parts.next().unwrap_or_default());
            for part in parts {
                let (key, value) = part.split_once('=').ok_or_else(|| {
                    Error::input(
                        format!("`{part}` in `{entry}` is no key with its value"),
                        "write METHOD:KEY=VALUE, as in log-exp:accuracy=9, the name of a file, or that of a core's \
                         directory",
                    )
                })?;
                // Numbers as they are, words in quotes.
                let value = if value.parse::<f64>().is_ok() { value.to_owned() } else { format!("{value:?}") };
                text += &format!("{key} = {value}\n");
            }
            SpecFields::parse(&text, &format!("--compare {entry}"))?
        };
        Self::of_keys(scene, keys.or(fields))
    }

    /// The cheapest core with these keys that keeps the scene's budget, as `generate` chooses it. `progress` is told
    /// what is done, how much of it and of how much.
    pub(crate) fn needed(
        scene: &Scene,
        margin_degrees: f64,
        costing: &Costing,
        keys: &SpecFields,
        progress: &(dyn Fn(&'static str, usize, usize) + Sync),
    ) -> Result<Self, Error> {
        let requirements = Requirements::of(scene, margin_degrees, &|done, of| progress("rendering", done, of))?;
        let choice = Search::new(scene, &requirements, costing, keys)?.choose(progress)?;
        let chosen = choice.chosen.ok_or_else(|| {
            Error::input(
                format!(
                    "none of the {} cores considered keeps the budget of the scene {}",
                    choice.considered, scene.name
                ),
                "allow more in its [budget], or name a core with --core or --method: its picture is drawn in any case",
            )
        })?;
        Ok(Self { design: Design::new(chosen.spec()?.resolve()?)?, directory: None, materials: Vec::new() })
    }

    /// Whether it is an image-based block.
    pub(crate) fn is_image(&self) -> bool {
        self.design.spec.block.kind() == BlockKind::Image
    }

    /// The pixels of the materials that an image-based core is made of, with the core's codes. `done` is told how many
    /// rows the model has had, or samples the compiled core.
    ///
    /// # Panics
    /// On another core.
    pub(crate) fn imaged(
        &self,
        through: Through,
        scene: &Scene,
        tracer: &Tracer,
        done: &(dyn Fn(u64) + Sync),
    ) -> Result<Vec<(usize, [u16; 3])>, Error> {
        let points = Points::of(scene, tracer, &self.materials);
        if through == Through::Model {
            let rows = AtomicU64::new(0);
            return Ok(points.through(&self.design, &|| done(rows.fetch_add(1, Ordering::Relaxed) + 1)));
        }
        let scratch = tool::scratch()?;
        let (directory, paths) = self.compilable(scratch.path(), Part::sequenced(&self.design))?;
        let sources: Vec<PathBuf> = paths.into_iter().map(|path| directory.join(path)).collect();
        let mut pixels = Vec::new();
        let samples = points.iter().map(|point| {
            pixels.push(point.pixel);
            point.clocks(&self.design)
        });
        let codes = cosim::sequence(&self.design, directory, &sources, samples, done)?;
        Ok(pixels.into_iter().zip(codes).collect())
    }

    /// Where a part of the core lies to be compiled, in its own directory or written to another one, and the paths of
    /// its text and of those that it uses.
    fn compilable<'a>(&'a self, scratch: &'a Path, part: Part) -> Result<(&'a Path, Vec<String>), Error> {
        let (design, language) = (&self.design, self.design.spec.compiled_language());
        if let Some(directory) = &self.directory {
            return Ok((directory, part.rtl_paths(design, language)));
        }
        for file in package::sources(design, language)? {
            package::write_file(&scratch.join(&file.path), &file.bytes)?;
        }
        Ok((scratch, vec![package::rtl_path(design, language)]))
    }

    /// The core's highlights. `done` is told how many samples the compiled core has had.
    pub(crate) fn highlights(
        &self,
        through: Through,
        scene: &Scene,
        frame: &Frame,
        done: &dyn Fn(u64),
    ) -> Result<Vec<f64>, Error> {
        if through == Through::Model {
            return CoreModel::new(&self.design)?.of(scene, frame);
        }
        let scratch = tool::scratch()?;
        let (directory, _) = self.compilable(scratch.path(), Part::Core)?;
        Compiled::new(&self.design, directory, done)?.of(scene, frame)
    }
}

/// Reads the keys of a core; a scene is told apart.
fn read(path: &Path) -> Result<SpecFields, Error> {
    let text = if path.is_dir() { String::new() } else { input::read_text(path, "").unwrap_or_default() };
    refuse!(
        Scene::is_scene(&text),
        format!("{} is a scene, and no core", path.display()),
        "give --core a spec file or the directory of a generated core"
    );
    SpecFields::read(path)
}

impl Scene {
    /// The distinct shininesses of the materials that objects have, ascending.
    pub(crate) fn shininesses(&self) -> Vec<f64> {
        let classical = self.objects.iter().filter(|object| self.reflectance(object.material).is_none());
        let mut all: Vec<f64> = classical.map(|object| self.materials[object.material].shininess).collect();
        all.sort_by(f64::total_cmp);
        all.dedup();
        all
    }
}

/// A core's short name for people, without its shininesses.
pub(crate) fn name(design: &Design) -> String {
    // Those that need not be named.
    let mut spec = design.spec.clone();
    match &mut spec.block {
        Block::Image(of) => return of.image.to_string(),
        Block::Lobe(lobe) | Block::Shader(lobe, _) => lobe.interface.shininess = Shininess::Range(1, 1000),
    }
    Point::unmeasured(&Core::new(spec, Family::Ecp5)).name
}

/// A core in a line.
pub(crate) fn text(design: &Design) -> String {
    let what = match &design.spec.block {
        Block::Image(_) => package::title(&design.spec),
        _ => format!("{}, n = {}", name(design), design.lobe().interface.shininess.to_string().replace(',', ", "),),
    };
    format!("core {}: {what}, {} clocks", design.spec.name, design.whole_latency())
}

/// A core's cost in two lines.
pub(crate) fn cost_lines(cost: &Cost) -> Vec<String> {
    let Cost { lut, dsp, bram, latency, .. } = cost;
    let mhz = cost.mhz_text(0);
    vec![
        format!("{lut} LUTs, {}, {}", counted(*dsp, "DSP"), counted(*bram, "block RAM")),
        format!("{mhz}, {latency} clocks"),
    ]
}
