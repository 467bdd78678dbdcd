//! `brdfgen report`.

use std::path::{Path, PathBuf};

use clap::Args;

use super::choose::{ConstraintFlags, Keys};
use super::scene::{self, SceneFlags};
use super::source::read_scene;
use super::{Verdict, progress, say};
use crate::emit::package;
use crate::explore::{MaxError, Objective, Point, Results};
use crate::platform::error::{Error, refuse};
use crate::platform::input;
use crate::platform::paths::Paths;
use crate::reflectance::{Lookup, Model, Source, measure, trade};
use crate::report::{MaterialPart, Report, ScenePart, Speed};
use crate::spec::SpecFields;

/// The page's name in a directory.
const PAGE: &str = "report.html";

#[derive(Args)]
pub(super) struct Arguments {
    /// The table that `cargo bench --bench ratios` writes [default: the one that comes with the program]
    #[arg(long, value_name = "FILE")]
    speed: Option<PathBuf>,

    /// The page: a file whose name ends in .html, or a directory for report.html
    #[arg(long, short, value_name = "PATH")]
    out: PathBuf,

    /// Also write each chart as SVG and PNG into this directory; what is there under the same names is replaced
    #[arg(long, value_name = "DIR")]
    plots: Option<PathBuf>,

    /// A scene file: its pictures, what it asks for and the core that it needs come first; repeat for more
    #[arg(long, value_name = "SCENE")]
    scene: Vec<PathBuf>,

    /// A MERL table, or the name of a reflectance model or preset: its memory against its error in every form; repeat
    /// for more
    #[arg(long, value_name = "FILE|MODEL")]
    material: Vec<PathBuf>,

    /// Mark the core that `brdfgen choose` chooses for this error and the other constraints, such as 0.01, 1% or 2^-7;
    /// exit 1 if there is none
    #[arg(long, value_name = "ERROR")]
    max_error: Option<MaxError>,

    /// What is to be least of the chosen core, as for `brdfgen choose` [default: lut]
    #[arg(long, visible_alias = "goal", value_enum, value_name = "COST", requires = "max_error")]
    objective: Option<Objective>,

    #[command(flatten)]
    constraints: ConstraintFlags,

    #[command(flatten)]
    keys: Keys,
}

pub(super) fn run(arguments: &Arguments) -> Result<Verdict, Error> {
    let page = page(&arguments.out);
    let paths = [&arguments.speed]
        .into_iter()
        .flatten()
        .fold(arguments.constraints.paths(), |paths, path| paths.reads("--speed", path));
    let paths = arguments.scene.iter().fold(paths, |paths, path| paths.reads("--scene", path));
    let files = arguments.material.iter().filter(|path| path.exists());
    let paths = files.fold(paths, |paths, path| paths.reads("--material", path)).writes("--out", &page);
    paths.check()?;
    let results = arguments.constraints.results()?;
    let speed = match &arguments.speed {
        Some(path) => {
            let text = input::read_text(path, "measured speeds are a CSV file")?;
            Speed::from_csv(&text, &path.display().to_string())?
        }
        None => Speed::built_in()?,
    };
    let points = results.points();
    refuse!(
        points.is_empty(),
        "there are no points in the results",
        "results of `brdfgen explore`, with at least one point"
    );
    let chosen = chosen(arguments, &results)?;
    let mut scenes = Vec::new();
    for path in &arguments.scene {
        let scene = read_scene(path)?;
        let inspection = scene::inspect(&scene, &SceneFlags::default(), &SpecFields::default())?;
        match inspection.findings(&scene) {
            Some(findings) => scenes.push(ScenePart::of(&findings)?),
            None => {
                let help = format!("see `brdfgen scene inspect {}`", path.display());
                return Err(Error::input(format!("no core keeps the budget of {}", path.display()), help));
            }
        }
    }
    let mut materials = Vec::new();
    for (place, path) in arguments.material.iter().enumerate() {
        materials.push(material(place, path)?);
    }
    let bar = progress::bar("measuring", Report::work(points, chosen));
    let report = Report::new(points, chosen, &speed, &|| bar.inc(1))?.with(scenes, materials);
    bar.finish_and_clear();
    let plots = arguments.plots.as_ref().map(|directory| (directory, report.plots()));
    // With what was read since, such as a scene's meshes, and the charts' names.
    let paths = paths.joined(Paths::new());
    let paths = plots.iter().fold(paths, |paths, (directory, files)| {
        paths.writes_in("--plots", directory, files.iter().map(|file| file.path.as_str()))
    });
    paths.check()?;
    package::write_file(&page, report.html().as_bytes())?;
    say(format!("{} points in {}", points.len(), page.display()));
    if let Some((directory, files)) = &plots {
        for file in files {
            package::write_file(&directory.join(&file.path), &file.bytes)?;
        }
        say(format!("{} charts, as SVG and PNG, in {}", files.len() / 2, directory.display()));
    }
    if let Some(chosen) = chosen {
        say(format!("chosen: {}", chosen.name));
    } else if arguments.max_error.is_some() {
        say("no core meets the constraints: see `brdfgen choose`");
        return Ok(Verdict::Differs);
    }
    Ok(Verdict::Done)
}

/// A material's part of the page. What is no file is a model.
fn material(place: usize, path: &Path) -> Result<MaterialPart, Error> {
    let name = path.display().to_string();
    let source =
        if path.exists() { Source::open(path, Lookup::default())? } else { Source::Model(Model::named(&name)?) };
    let reflectance = source.needed(&name, "give a MERL table, or the name of a model or a preset")?;
    let exposure = measure::exposure(reflectance);
    let bar = progress::bar("measuring forms", trade::steps());
    let points = trade::trade(reflectance, exposure, &|| bar.inc(1))?;
    bar.finish_and_clear();
    Ok(MaterialPart::of(place, &name, exposure, &points))
}

/// The point that is to be marked.
fn chosen<'a>(arguments: &Arguments, results: &'a Results) -> Result<Option<&'a Point>, Error> {
    let keys = arguments.keys.fields();
    let Some(max_error) = arguments.max_error else {
        refuse!(
            arguments.constraints.constrains() || keys != SpecFields::default(),
            "a core is asked for without the error that is allowed",
            "say --max-error as well, or leave the other constraints out"
        );
        return Ok(None);
    };
    let objective = arguments.objective.unwrap_or(Objective::Lut);
    let choice = arguments.constraints.with_error(max_error, objective, keys)?.choose(results)?;
    let id = choice.chosen.map(|candidate| candidate.point.id);
    Ok(results.points().iter().find(|point| Some(&point.id) == id.as_ref()))
}

/// The page's file.
fn page(out: &Path) -> PathBuf {
    let named = out.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("html")) && !out.is_dir();
    if named { out.to_owned() } else { out.join(PAGE) }
}
