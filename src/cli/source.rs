//! Where a command's core comes from: a spec file or a core directory, and flags.

use std::path::{Path, PathBuf};

use clap::Args;

use super::warn;
use crate::core::Design;
use crate::emit::package::{self, File};
use crate::generate::Core;
use crate::platform::error::{Error, refuse};
use crate::platform::paths::Paths;
use crate::platform::transient::Folder;
use crate::platform::{input, tool};
use crate::scene::{Scene, document};
use crate::spec::{CoreSpec, SpecFields};
use crate::verify::cosim::Job;
use crate::verify::golden::{self, Golden};

/// The core that a command works on.
#[derive(Args)]
pub(super) struct Source {
    /// A spec file, or the directory of a generated core; flags win over it. For `generate` also a scene file
    #[arg(value_name = "SPEC")]
    path: Option<PathBuf>,

    #[command(flatten)]
    fields: SpecFields,
}

impl Source {
    /// The directory, if the core is a generated one taken as it is.
    pub(super) fn directory(&self) -> Option<&Path> {
        self.path.as_deref().filter(|path| path.is_dir() && self.fields == SpecFields::default())
    }

    /// The files that a scene's core has beside its own, if the core is a generated one taken as it is.
    pub(super) fn companions(&self) -> Vec<File> {
        let read = |directory: &Path, path: &str| {
            let bytes = std::fs::read(directory.join(path)).ok()?;
            Some(File { path: path.to_owned(), bytes })
        };
        let all = |directory| document::FILES.into_iter().filter_map(|path| read(directory, path)).collect();
        self.directory().map(all).unwrap_or_default()
    }

    /// The paths of a command that reads the spec and no more of a core's directory.
    pub(super) fn paths(&self) -> Paths {
        match &self.path {
            Some(path) if path.is_dir() => Paths::new().reads("SPEC", path.join("core.toml")),
            Some(path) => Paths::new().reads("SPEC", path),
            None => Paths::new(),
        }
    }

    /// The paths of a command that reads all of a core's directory.
    pub(super) fn paths_of_core(&self) -> Paths {
        let directories = self.path.iter().filter(|path| path.is_dir());
        directories.fold(self.paths(), |paths, path| reads_core(paths, "SPEC", path))
    }

    /// Whether a core is named at all.
    pub(super) fn is_given(&self) -> bool {
        self.path.is_some() || self.fields != SpecFields::default()
    }

    /// The keys that are given.
    pub(super) fn fields(&self) -> Result<SpecFields, Error> {
        let written = match &self.path {
            None => SpecFields::default(),
            Some(path) if is_scene(path) => {
                let name = path.display();
                return Err(Error::input(
                    format!("{name} is a scene, and a core or its spec is needed"),
                    format!("make the scene's core first: brdfgen generate {name} --out DIR; then give DIR"),
                ));
            }
            Some(path) => SpecFields::read(path)?,
        };
        Ok(self.fields.clone().or(written))
    }

    /// The scene with the keys that are given beside it, if it is a scene file.
    pub(super) fn scene(&self) -> Result<Option<(Scene, SpecFields)>, Error> {
        let Some(path) = self.path.as_deref().filter(|path| is_scene(path)) else { return Ok(None) };
        Ok(Some((read_scene(path)?, self.fields.clone())))
    }

    /// The spec.
    pub(super) fn spec(&self) -> Result<CoreSpec, Error> {
        self.fields()?.resolve()
    }

    /// The design.
    pub(super) fn design(&self) -> Result<Design, Error> {
        Design::new(self.spec()?)
    }
}

/// The paths with all files of a core's directory, which are read.
pub(super) fn reads_core(paths: Paths, what: &str, directory: &Path) -> Paths {
    package::core_files(directory).into_iter().fold(paths, |paths, file| paths.reads(what, directory.join(file)))
}

/// Whether a path is a scene file; of one that cannot be read, whoever reads it says so.
fn is_scene(path: &Path) -> bool {
    !path.is_dir() && input::read_text(path, "").is_ok_and(|text| Scene::is_scene(&text))
}

/// Reads a scene; a spec is told apart.
pub(super) fn read_scene(path: &Path) -> Result<Scene, Error> {
    let shown = path.display();
    refuse!(
        path.is_dir(),
        format!("{shown} is a directory, and no scene"),
        format!("give a scene file; `render` takes the directory of a core as --core {shown}")
    );
    let text = input::read_text(path, "a scene is a TOML file")?;
    refuse!(
        !Scene::is_scene(&text) && SpecFields::parse(&text, &shown.to_string()).is_ok(),
        format!("{shown} is the spec of a core, and no scene"),
        format!("give a scene file; `render` takes the spec as --core {shown}")
    );
    let scene = Scene::read(path)?;
    scene.left_out.iter().for_each(warn);
    Ok(scene)
}

/// A core on disk: the user's directory, or one generated for the occasion.
pub(super) struct OnDisk {
    pub(super) design: Design,
    pub(super) golden: Golden,
    path: PathBuf,
    _scratch: Option<Folder>,
}

impl OnDisk {
    /// The core with its vectors and its directory.
    pub(super) fn job(&self) -> Job<'_> {
        Job { design: &self.design, golden: &self.golden, directory: &self.path }
    }

    /// The directory that the source names with the vectors in it, or a new one of all the core's files.
    pub(super) fn of(source: &Source, design: Design) -> Result<Self, Error> {
        if let Some(path) = source.directory() {
            let golden = read_golden(&design, &path.join(package::golden_path(&design)))?;
            return Ok(Self { design, golden, path: path.to_owned(), _scratch: None });
        }
        let scratch = tool::scratch()?;
        let path = scratch.path().join("core");
        let core = Core::of(design, Vec::new())?;
        core.write(&path)?;
        Ok(Self { design: core.design, golden: core.golden, path, _scratch: Some(scratch) })
    }
}

/// Reads a golden file of a design.
pub(super) fn read_golden(design: &Design, path: &Path) -> Result<Golden, Error> {
    let text = input::read_text(path, "golden vectors are ASCII text")?;
    golden::parse(design, &text, &path.display().to_string())
}
