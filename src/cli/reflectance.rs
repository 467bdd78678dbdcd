//! `brdfgen reflectance`.

use std::path::{Path, PathBuf};

use clap::{Args, Subcommand, ValueEnum};
use rayon::prelude::*;
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

use super::{Verdict, progress, say, say_json, write_to};
use crate::platform::error::Error;
use crate::platform::input;
use crate::emit::package::{self, Kind};
use crate::reflectance::classical::{self, Cosine, Fit};
use crate::reflectance::measure::{self, Judge};
use crate::reflectance::paper::{Behind, Border};
use crate::reflectance::trade::{self, Point};
use crate::reflectance::vector::{Light, Vector};
use crate::reflectance::{
    Form, FormKind, FormSpec, Lookup, Model, Reflectance, Rgb, Source, Texel, directory, extremes, info, merl, open,
};
use crate::report::trade_of_material;

/// A directory of sphere images.
const IMAGES: Kind = Kind { what: "sphere images", file: directory::INDEX, mark: directory::MARK };
/// Pixels along a side of the spheres that a form's quality is measured on.
const PIXELS: usize = 128;
/// The angles from the normal that `info` shows the albedo for, in degrees.
const THETAS: [f64; 6] = [0.0, 15.0, 30.0, 45.0, 60.0, 75.0];

#[derive(Args)]
pub(super) struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Say what a file holds: its kind, valid cells, largest value, albedo, reciprocity, a fitting exposure
    Info(InfoArguments),
    /// Write a table, or a model as a table, as a MERL file
    Convert(ConvertArguments),
    /// Write the sphere images of a material as a directory
    Images(ImagesArguments),
    /// Find the classical material, diffuse and cos^n, that is nearest to a material
    Fit(FitArguments),
    /// Evaluate a material at the points of a CSV file, exactly or through a form
    Eval(EvalArguments),
    /// Measure memory against error for every form, number of images, size and kind of texel
    Trade(TradeArguments),
    /// Look every form up where it degenerates: values must be finite, within their bounds, at their limits, the same on all threads
    Stability(StabilityArguments),
}

/// What reflects.
#[derive(Args)]
struct MaterialArguments {
    /// A MERL table (.binary), a directory of sphere images, or a matcap (PNG, OpenEXR)
    #[arg(value_name = "FILE", required_unless_present = "model")]
    file: Option<PathBuf>,

    #[command(flatten)]
    model: ModelArguments,
}

#[derive(Args)]
struct ModelArguments {
    /// A reflectance model in place of a file: lambert, blinnphong, ward, cook-torrance, ggx, ashikhmin-shirley, or a preset:
    /// yellow-plastic, red-specular-plastic, orange-diffuse-paint, blue-acrylic, aluminium-bronze, gold-paint, colour-shifting-paint
    #[arg(long, value_name = "NAME")]
    model: Option<String>,

    /// A parameter of the model, such as alpha=0.18 or kd=0.4,0.3,0.1
    #[arg(long, value_name = "KEY=VALUE", num_args = 1.., requires = "model")]
    parameter: Vec<String>,

    /// How a table is looked up between the centres of its cells
    #[arg(long, value_enum, default_value = "trilinear")]
    lookup: LookupName,

    /// The exposure E that radiance is multiplied by [default: 0.6 over the 90th percentile of the sphere lit from 45 degrees]
    #[arg(long, value_name = "E", value_parser = positive)]
    exposure: Option<f64>,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum LookupName {
    /// Interpolated
    Trilinear,
    /// The cell's value, as MERL's own code
    Nearest,
}

fn positive(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|number: &f64| *number > 0.0 && number.is_finite());
    number.ok_or_else(|| "a number above 0".to_owned())
}

/// How a material is stored.
#[derive(Args)]
struct FormArguments {
    /// The form: sphere images (paper), slices about the half vector (half), or the mean over the azimuth (bivariate)
    #[arg(long, value_enum)]
    form: Option<FormName>,

    /// The light's angles of the images in degrees, as in 0,45,90,135, or how many [default: 4 images, 16 slices]
    ///
    /// So many images of the paper's form are 180/N degrees apart, so many slices of half even from 0 to 176; without a meaning for
    /// bivariate and exact
    #[arg(long, value_name = "ANGLES", allow_hyphen_values = true)]
    images: Option<String>,

    /// Texels along a side, 2 to 4096 [default: 512 for paper, 32 for half and bivariate]
    #[arg(long)]
    size: Option<usize>,

    /// How texels are stored: float, linear:BITS, sqrt:BITS, sqrt:BITS:CAP or 565 [default: linear:8 for paper, sqrt:8 for half and
    /// bivariate]
    #[arg(long)]
    texel: Option<Texel>,

    /// What keeps the black around a sphere out of the paper's form: shrink:FACTOR or extend [default: shrink:0.995]
    #[arg(long)]
    border: Option<Border>,

    /// What the paper's form looks up for a turned normal that points away: rim, literal or skip [default: rim]
    #[arg(long)]
    behind: Option<Behind>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum FormName {
    /// Equations 1 to 4
    Paper,
    /// Slices about the half vector
    Half,
    /// The mean over the azimuth about the half vector
    Bivariate,
    /// No form: the material itself
    Exact,
}

impl FormArguments {
    /// The form that is asked for; none is the material itself.
    fn spec(&self, form: FormName) -> Result<Option<FormSpec>, Error> {
        let kind = match form {
            FormName::Paper => FormKind::Paper,
            FormName::Half => FormKind::Half,
            FormName::Bivariate => FormKind::Bivariate,
            FormName::Exact => return Ok(None),
        };
        let mut spec = FormSpec::of(kind);
        if let Some(images) = self.images.as_ref().filter(|_| kind != FormKind::Bivariate) {
            spec.set_images(images)?;
        }
        spec.size = self.size.unwrap_or(spec.size);
        spec.texel = self.texel.unwrap_or(spec.texel);
        spec.options.border = self.border.unwrap_or(spec.options.border);
        spec.options.behind = self.behind.unwrap_or(spec.options.behind);
        spec.check()?;
        Ok(Some(spec))
    }

    /// Whether anything but the form's name is given.
    fn is_given(&self) -> bool {
        self.images.is_some()
            || self.size.is_some()
            || self.texel.is_some()
            || self.border.is_some()
            || self.behind.is_some()
    }
}

#[derive(Args)]
struct InfoArguments {
    #[command(flatten)]
    material: MaterialArguments,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,
}

#[derive(Args)]
struct ConvertArguments {
    /// The table to read, unless a model is given, and the file to write, which ends in .binary
    #[arg(value_name = "IN OUT", required = true, num_args = 1..=2)]
    files: Vec<PathBuf>,

    #[command(flatten)]
    model: ModelArguments,

    /// Cells along the azimuth φd: 180, which makes the table reciprocal, or 360 [default: as many as IN has; 180 for a model]
    #[arg(long, value_name = "CELLS", value_parser = ["180", "360"])]
    phi_d: Option<String>,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,
}

#[derive(Args)]
struct ImagesArguments {
    #[command(flatten)]
    material: MaterialArguments,

    #[command(flatten)]
    form: FormArguments,

    /// The directory: a new or empty one, or one of earlier sphere images
    #[arg(long, short, value_name = "DIR")]
    out: PathBuf,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,
}

#[derive(Args)]
struct FitArguments {
    #[command(flatten)]
    material: MaterialArguments,

    /// The cosine of the highlight [default: both]
    #[arg(long, value_enum)]
    cosine: Option<CosineName>,

    /// How many highlights, 1 to 3
    #[arg(long, default_value_t = 1)]
    lobes: usize,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum CosineName {
    /// n·h
    Blinn,
    /// r·v
    Phong,
}

#[derive(Args)]
struct EvalArguments {
    #[command(flatten)]
    material: MaterialArguments,

    #[command(flatten)]
    form: FormArguments,

    /// The points: a CSV file with the columns phi_deg, gamma_deg, nx, ny and nz
    #[arg(long, value_name = "IN.csv")]
    points: PathBuf,

    /// The results: the columns of IN, then r, g and b; `-` is standard output [default: `-`, and nothing with --json]
    #[arg(long, value_name = "OUT.csv")]
    csv: Option<PathBuf>,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,
}

#[derive(Args)]
struct TradeArguments {
    #[command(flatten)]
    material: MaterialArguments,

    /// Choose among those that take at most so much memory
    #[arg(long, value_name = "KIB", value_parser = positive)]
    max_kib: Option<f64>,

    /// Choose the one that takes the least memory among those whose mean is at least so many dB
    #[arg(long, value_name = "DB", value_parser = positive)]
    min_psnr: Option<f64>,

    /// Write all of them as CSV
    #[arg(long, value_name = "FILE.csv")]
    csv: Option<PathBuf>,

    /// Draw them as a chart
    #[arg(long, value_name = "FILE.svg")]
    svg: Option<PathBuf>,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,
}

#[derive(Args)]
struct StabilityArguments {
    /// Write what was found as a chapter in Markdown
    #[arg(long, short, value_name = "FILE.md")]
    out: Option<PathBuf>,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,
}

/// A material that is opened.
struct Material {
    /// The file's path, or the model with its parameters.
    name: String,
    what: What,
}

enum What {
    Table(Box<crate::reflectance::Table>),
    Model(Model),
    Images(Box<Form>),
}

impl Material {
    /// As a reflectance, which images are not.
    fn reflectance(&self) -> Result<&dyn Reflectance, Error> {
        match &self.what {
            What::Table(table) => Ok(&**table),
            What::Model(model) => Ok(model),
            What::Images(_) => Err(Error::input(
                format!("{} holds sphere images, and no reflectance", self.name),
                "give a MERL table, or a model with --model",
            )),
        }
    }
}

impl ModelArguments {
    fn model(&self) -> Result<Option<Model>, Error> {
        let Some(name) = &self.model else { return Ok(None) };
        let mut model = Model::named(name)?;
        for parameter in &self.parameter {
            let Some((key, value)) = parameter.split_once('=') else {
                return Err(Error::input(format!("the parameter `{parameter}`"), "KEY=VALUE, as in alpha=0.18"));
            };
            model.set(key.trim(), value.trim())?;
        }
        Ok(Some(model))
    }

    fn open(&self, file: Option<&Path>) -> Result<Material, Error> {
        match (self.model()?, file) {
            (Some(_), Some(file)) => {
                Err(Error::input(format!("both a model and the file {} are given", file.display()), "give one of them"))
            }
            (Some(model), None) => Ok(Material { name: model.to_string(), what: What::Model(model) }),
            (None, None) => Err(Error::input("no material is given", "name a file, or a model with --model")),
            (None, Some(file)) => {
                let what = match open(file)? {
                    Source::Table(mut table) => {
                        if self.lookup == LookupName::Nearest {
                            table.lookup = Lookup::Nearest;
                        }
                        What::Table(Box::new(table))
                    }
                    Source::Images(form) => What::Images(Box::new(form)),
                };
                Ok(Material { name: file.display().to_string(), what })
            }
        }
    }

    fn exposure(&self, reflectance: &dyn Reflectance) -> f64 {
        self.exposure.unwrap_or_else(|| measure::exposure(reflectance))
    }
}

impl MaterialArguments {
    fn open(&self) -> Result<Material, Error> {
        self.model.open(self.file.as_deref())
    }
}

pub(super) fn run(arguments: &Arguments) -> Result<Verdict, Error> {
    match &arguments.command {
        Command::Info(arguments) => run_info(arguments),
        Command::Convert(arguments) => run_convert(arguments),
        Command::Images(arguments) => run_images(arguments),
        Command::Fit(arguments) => run_fit(arguments),
        Command::Eval(arguments) => run_eval(arguments),
        Command::Trade(arguments) => run_trade(arguments),
        Command::Stability(arguments) => run_stability(arguments),
    }
}

fn colour(value: Rgb, digits: usize) -> String {
    value.map(|channel| format!("{channel:.digits$}")).join(" ")
}

fn run_info(arguments: &InfoArguments) -> Result<Verdict, Error> {
    let material = arguments.material.open()?;
    let (mut lines, mut values) = (Vec::new(), serde_json::Map::new());
    let mut put = |key: &str, value: Value| drop(values.insert(key.to_owned(), value));
    put("name", json!(material.name));
    match &material.what {
        What::Table(table) => {
            let [h, d, p] = table.shape();
            let (valid, count) = (table.valid_count(), h * d * p);
            let share = valid as f64 / count as f64;
            lines.push(format!("{}: a MERL table of {h} × {d} × {p} cells (θh, θd, φd)", material.name));
            lines.push(format!("  valid cells       {valid} of {count}, {:.2} %", 100.0 * share));
            lines.push(format!("  largest value     {:.6} per steradian", table.largest()));
            put("kind", json!("merl"));
            put("shape", json!([h, d, p]));
            put("valid", json!(valid));
            put("invalid", json!(count - valid));
            put("valid_share", json!(share));
            put("largest", json!(table.largest()));
        }
        What::Model(model) => {
            lines.push(format!("{model}: {}", model.family().source()));
            put("kind", json!("model"));
            put("model", json!(model.family().name()));
            put("source", json!(model.family().source()));
        }
        What::Images(form) => {
            let largest = form.texels.caps().iter().copied().fold(0.0, f64::max);
            lines.push(format!("{}: {}, {:.1} KiB, exposure {}", material.name, form.spec, form.kib(), form.exposure));
            put("kind", json!(form.spec.kind.name()));
            put("size", json!(form.spec.size));
            put("angles", json!(form.spec.angles));
            put("texel", json!(form.spec.texel.to_string()));
            put("kib", json!(form.kib()));
            put("exposure", json!(form.exposure));
            if form.spec.texel != Texel::Float {
                lines.push(format!("  full scale        {largest}"));
                put("full_scale", json!(largest));
            }
        }
    }
    if let Ok(reflectance) = material.reflectance() {
        let exposure = arguments.material.model.exposure(reflectance);
        let albedo: Vec<(f64, Rgb)> =
            THETAS.par_iter().map(|&theta| (theta, info::albedo(reflectance, theta))).collect();
        for (theta, albedo) in &albedo {
            lines.push(format!("  albedo at {theta:>2}°      {}", colour(*albedo, 4)));
        }
        let reciprocity = info::reciprocity_error(reflectance);
        lines.push(format!("  reciprocity error {reciprocity:.3e} of the root mean square"));
        lines.push(format!("  exposure          {exposure:.6}"));
        let albedo: Vec<Value> =
            albedo.iter().map(|(theta, albedo)| json!({ "theta": theta, "rgb": albedo })).collect();
        put("albedo", json!(albedo));
        put("reciprocity_error", json!(reciprocity));
        put("exposure", json!(exposure));
    }
    if arguments.json {
        say_json(&values);
    } else {
        lines.iter().for_each(say);
    }
    Ok(Verdict::Done)
}

fn run_convert(arguments: &ConvertArguments) -> Result<Verdict, Error> {
    let model = &arguments.model;
    let (from, to) = match (&arguments.files[..], &model.model) {
        ([to], Some(_)) => (None, to),
        ([from, to], None) => (Some(from.as_path()), to),
        ([_], None) => {
            return Err(Error::input(
                "only one file is given",
                "a table to read and a file to write, or --model and a file to write",
            ));
        }
        _ => return Err(Error::input("a file to read and a model are given", "give one of them, and a file to write")),
    };
    if to.as_os_str() != "-" && to.extension().is_none_or(|extension| extension != "binary") {
        return Err(Error::input(
            format!("{} does not end in .binary", to.display()),
            "tables are written as MERL files, NAME.binary, or `-` for standard output",
        ));
    }
    let material = model.open(from)?;
    let phi_d = arguments.phi_d.as_ref().and_then(|cells| cells.parse().ok());
    let table = match &material.what {
        What::Table(table) => table.with_phi_d(phi_d.unwrap_or(table.shape()[2])),
        _ => {
            let spinner = progress::spinner("sampling the model".to_owned());
            let table = crate::reflectance::Table::sampled(material.reflectance()?, phi_d.unwrap_or(180));
            spinner.finish_and_clear();
            table?
        }
    };
    write_to(to, &merl::bytes(&table))?;
    let [h, d, p] = table.shape();
    if arguments.json {
        say_json(&json!({ "file": to, "shape": [h, d, p], "valid": table.valid_count(), "largest": table.largest() }));
    } else if to.as_os_str() != "-" {
        say(format!("{}: {h} × {d} × {p} cells, {} of them valid", to.display(), table.valid_count()));
    }
    Ok(Verdict::Done)
}

fn run_images(arguments: &ImagesArguments) -> Result<Verdict, Error> {
    package::check_target_of(IMAGES, &arguments.out)?;
    let name = arguments.form.form.unwrap_or(FormName::Paper);
    let Some(spec) = arguments.form.spec(name)? else {
        return Err(Error::input("the form `exact` has no images", "paper, half or bivariate"));
    };
    let material = arguments.material.open()?;
    let reflectance = material.reflectance()?;
    let spinner = progress::spinner(format!("drawing {spec}"));
    let exposure = arguments.material.model.exposure(reflectance);
    let built = spec.build(reflectance, exposure).and_then(|form| Ok((directory::files(&form)?, form)));
    let quality = built
        .as_ref()
        .ok()
        .map(|(_, form)| Judge::new(reflectance, exposure, &measure::angles(5.0), PIXELS).quality(form));
    spinner.finish_and_clear();
    let (files, form) = built?;
    let mut files: Vec<package::File> = files.into_iter().map(|(path, bytes)| package::File { path, bytes }).collect();
    files.push(manifest(&files));
    package::write_directory_of(IMAGES, &arguments.out, &files)?;
    let names: Vec<&str> = files.iter().map(|file| file.path.as_str()).collect();
    if arguments.json {
        say_json(&json!({
            "material": material.name,
            "form": spec.kind.name(),
            "angles": spec.angles,
            "size": spec.size,
            "texel": spec.texel.to_string(),
            "exposure": exposure,
            "kib": form.kib(),
            "quality": quality,
            "directory": arguments.out,
            "files": names,
        }));
    } else {
        say(format!("{}: {spec}, {:.1} KiB, exposure {exposure:.6}", material.name, form.kib()));
        if let Some(quality) = quality {
            say(format!("  {:.2} dB in the mean, {:.2} dB at {}°", quality.mean, quality.worst, quality.worst_phi));
        }
        say(format!("{} files in {}", files.len(), arguments.out.display()));
    }
    Ok(Verdict::Done)
}

/// The list of a directory's files, by which the next run knows those that it no longer writes.
fn manifest(files: &[package::File]) -> package::File {
    let digest = |file: &package::File| {
        let hex = Sha256::digest(&file.bytes).iter().map(|byte| format!("{byte:02x}")).collect::<String>();
        (file.path.clone(), json!(hex))
    };
    let digests: serde_json::Map<String, Value> = files.iter().map(digest).collect();
    let text = serde_json::to_string_pretty(&json!({ "generator": "brdfgen", "files_sha256": digests }));
    package::File { path: "manifest.json".to_owned(), bytes: (text.expect("JSON of plain values") + "\n").into_bytes() }
}

fn run_fit(arguments: &FitArguments) -> Result<Verdict, Error> {
    let material = arguments.material.open()?;
    let reflectance = material.reflectance()?;
    let exposure = arguments.material.model.exposure(reflectance);
    let cosines = match arguments.cosine {
        Some(CosineName::Blinn) => vec![Cosine::Blinn],
        Some(CosineName::Phong) => vec![Cosine::Phong],
        None => vec![Cosine::Blinn, Cosine::Phong],
    };
    let bar =
        progress::bar("fitting", cosines.len() as u64 * classical::steps(arguments.lobes.min(classical::MOST_LOBES)));
    let fit = |cosine: Cosine| classical::fit(reflectance, cosine, arguments.lobes, exposure, &|| bar.inc(1));
    let fits: Result<Vec<Fit>, Error> = cosines.into_iter().map(fit).collect();
    bar.finish_and_clear();
    let fits = fits?;
    if arguments.json {
        say_json(&json!({ "material": material.name, "exposure": exposure, "fits": fits }));
        return Ok(Verdict::Done);
    }
    say(format!("{}: I = kd n·l + Σ ks x^n, exposure {exposure:.6}", material.name));
    for Fit { material, quality, max_steps, mean_steps, .. } in &fits {
        say(if material.cosine == Cosine::Blinn { "Blinn, x = n·h" } else { "Phong, x = r·v" });
        say(format!("  kd {}", colour(material.kd, 5)));
        for lobe in &material.lobes {
            say(format!("  ks {}  n {}", colour(lobe.ks, 5), lobe.n));
        }
        say(format!(
            "  {:.2} dB in the mean, {:.2} dB at {}°; at most {max_steps} steps of 8 bits, {mean_steps:.2} in the mean",
            quality.mean, quality.worst, quality.worst_phi
        ));
    }
    Ok(Verdict::Done)
}

/// The columns of a points file.
const COLUMNS: [&str; 5] = ["phi_deg", "gamma_deg", "nx", "ny", "nz"];
/// The columns of the results.
const RESULTS: [&str; 3] = ["r", "g", "b"];

/// Points with the texts of their lines, which stay as they are.
struct Points {
    /// Names of all columns but those of results.
    heading: Vec<String>,
    rows: Vec<(Vec<String>, Light, Vector)>,
}

fn read_points(path: &Path) -> Result<Points, Error> {
    let allowed = "points are a CSV file with the columns phi_deg, gamma_deg, nx, ny and nz";
    let text = input::read_text(path, allowed)?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(&text);
    let name = path.display();
    let wrong = |line: Option<u64>, what: String, allowed: &str| {
        let place = line.map(|line| format!(", line {line}")).unwrap_or_default();
        Error::input(format!("{name}{place}: {what}"), allowed)
    };
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(text.as_bytes());
    let heading = reader.headers().map_err(|error| wrong(None, error.to_string(), allowed))?.clone();
    let place = |column: &str| {
        let place = heading.iter().position(|own| own == column);
        place.ok_or_else(|| wrong(None, format!("there is no column `{column}`"), allowed))
    };
    let places = [place(COLUMNS[0])?, place(COLUMNS[1])?, place(COLUMNS[2])?, place(COLUMNS[3])?, place(COLUMNS[4])?];
    // Results of an earlier run are made anew.
    let kept: Vec<usize> = (0..heading.len()).filter(|&column| !RESULTS.contains(&&heading[column])).collect();
    let mut rows = Vec::new();
    for record in reader.records() {
        let record =
            record.map_err(|error| wrong(error.position().map(csv::Position::line), error.to_string(), allowed))?;
        let line = record.position().map(csv::Position::line);
        let number = |of: usize| {
            let text = &record[places[of]];
            let number = text.parse().ok().filter(|number: &f64| number.is_finite());
            number.ok_or_else(|| wrong(line, format!("{} is `{text}`", COLUMNS[of]), "a finite number"))
        };
        let light = Light::new(number(0)?, number(1)?);
        if !(0.0..=180.0).contains(&light.phi) {
            return Err(wrong(line, format!("phi_deg is {}", light.phi), "from 0, behind the viewer, to 180 degrees"));
        }
        let n = Vector::new(number(2)?, number(3)?, number(4)?);
        let length = n.norm();
        if !(0.99..=1.01).contains(&length) {
            return Err(wrong(
                line,
                format!("the normal {}, {}, {} has the length {length}", n.x, n.y, n.z),
                "normals have the length 1, to 1 %",
            ));
        }
        rows.push((kept.iter().map(|&column| record[column].to_owned()).collect(), light, n / length));
    }
    Ok(Points { heading: kept.iter().map(|&column| heading[column].to_owned()).collect(), rows })
}

fn run_eval(arguments: &EvalArguments) -> Result<Verdict, Error> {
    let Points { heading, rows } = read_points(&arguments.points)?;
    let (material, flags) = (&arguments.material, &arguments.form);
    // Wrong flags are named before a table is read.
    let asked = flags.form.unwrap_or(FormName::Exact);
    let spec = flags.spec(asked)?;
    let opened = material.open()?;
    let (form, exposure) = match &opened.what {
        What::Images(form) => {
            if flags.form.is_some() || flags.is_given() || material.model.exposure.is_some() {
                return Err(Error::input(
                    format!("{} is a form already: {}", opened.name, form.spec),
                    "leave --form, --exposure and the other keys of a form out",
                ));
            }
            (Some((**form).clone()), form.exposure)
        }
        _ => {
            let reflectance = opened.reflectance()?;
            let exposure = material.model.exposure(reflectance);
            let spinner = progress::spinner(
                spec.as_ref().map_or_else(|| "evaluating".to_owned(), |spec| format!("drawing {spec}")),
            );
            let form = spec.map(|spec| spec.build(reflectance, exposure)).transpose();
            spinner.finish_and_clear();
            (form?, exposure)
        }
    };
    let value = |(_, light, n): &(Vec<String>, Light, Vector)| match (&form, opened.reflectance()) {
        (Some(form), _) => form.at(*light, *n),
        (None, Ok(reflectance)) => reflectance.radiance(*light, *n, exposure),
        (None, Err(_)) => [0.0; 3],
    };
    let values: Vec<Rgb> = rows.par_iter().map(value).collect();
    let shape = form.as_ref().map_or_else(|| "exact".to_owned(), |form| form.spec.to_string());
    let to = arguments.csv.clone().or_else(|| (!arguments.json).then(|| PathBuf::from("-")));
    if let Some(path) = &to {
        if arguments.json && path.as_os_str() == "-" {
            return Err(Error::input("standard output cannot take two things", "write the CSV to a file"));
        }
        let mut writer = csv::Writer::from_writer(Vec::new());
        let failed = |_| Error::input("the results cannot be written as CSV", "fewer points");
        writer.write_record(heading.iter().map(String::as_str).chain(RESULTS)).map_err(failed)?;
        for ((texts, ..), value) in rows.iter().zip(&values) {
            let numbers = value.map(|channel| channel.to_string());
            writer.write_record(texts.iter().chain(&numbers)).map_err(failed)?;
        }
        let bytes =
            writer.into_inner().map_err(|_| Error::input("the results cannot be written as CSV", "fewer points"))?;
        write_to(path, &bytes)?;
    }
    if arguments.json {
        let mut value = json!({
            "material": opened.name,
            "form": shape,
            "exposure": exposure,
            "kib": form.as_ref().map(Form::kib),
            "points": rows.len(),
        });
        match &arguments.csv {
            Some(path) => value["csv"] = json!(path),
            None => value["values"] = json!(values),
        }
        say_json(&value);
    } else if let Some(path) = to.filter(|path| path.as_os_str() != "-") {
        say(format!("{}, {shape}, exposure {exposure}: {} points in {}", opened.name, rows.len(), path.display()));
    }
    Ok(Verdict::Done)
}

fn run_trade(arguments: &TradeArguments) -> Result<Verdict, Error> {
    let material = arguments.material.open()?;
    let reflectance = material.reflectance()?;
    let exposure = arguments.material.model.exposure(reflectance);
    let bar = progress::bar("measuring", trade::steps());
    let points = trade::trade(reflectance, exposure, &|| bar.inc(1));
    bar.finish_and_clear();
    let points = points?;
    let chosen = trade::choose(&points, arguments.max_kib, arguments.min_psnr);
    let csv = {
        let mut writer = csv::Writer::from_writer(Vec::new());
        let failed = || Error::input("the results cannot be written as CSV", "another file");
        points.iter().try_for_each(|point| writer.serialize(point)).map_err(|_| failed())?;
        writer.into_inner().map_err(|_| failed())?
    };
    if let Some(path) = &arguments.csv {
        write_to(path, &csv)?;
    }
    if let Some(path) = &arguments.svg {
        write_to(path, trade_of_material(&material.name, &points).svg().as_bytes())?;
    }
    if arguments.json {
        say_json(&json!({ "material": material.name, "exposure": exposure, "points": points, "chosen": chosen }));
    } else {
        say(format!(
            "{}, exposure {exposure:.6}: {} points; those that nothing smaller is better than:",
            material.name,
            points.len()
        ));
        say(format!("  {:>10}  {:>7}  {:>7}  {:>6}", "KiB", "mean dB", "worst", "at"));
        points.iter().filter(|point| point.front).for_each(|point| say(format!("  {}", line(point))));
        match chosen {
            Some(point) => say(format!("chosen: {}", line(point).trim_start())),
            None => say("nothing meets the wish"),
        }
        for path in arguments.csv.iter().chain(&arguments.svg) {
            say(path.display().to_string());
        }
    }
    Ok(Verdict::of(chosen.is_some()))
}

/// The chapter's beginning.
const CHAPTER: &str = "# Measured reflectance at the extremes

`brdfgen reflectance stability --out FILE.md` measures this chapter. Every value has to be finite and not negative, and no larger than a bound that
holds whatever is stored: of `paper` the largest sample, of `half` and `bivariate` the largest full scale times n·l. Where a case has a limit
(0 at φ = 180°, the value from beside it at φ = 0, the sum of single lights), values have to be within what the last column allows.
";

fn run_stability(arguments: &StabilityArguments) -> Result<Verdict, Error> {
    let bar = progress::bar("measuring", 1);
    let found = extremes::measure(&|done, of| progress::show(&bar, done, of))?;
    bar.finish_and_clear();
    let broken: Vec<String> = found
        .iter()
        .flat_map(|one| one.broken.iter().map(|what| format!("FAIL {}, {}: {what}", one.case, one.form)))
        .collect();
    if let Some(path) = &arguments.out {
        let mut text = format!(
            "{CHAPTER}\n{}\n\n| case | form | largest value | part of its bound | off its limit, allowed |\n| --- | --- | ---: | ---: | ---: |\n",
            if broken.is_empty() { "It holds for all of them." } else { "**It does not hold for all of them.**" }
        );
        for extremes::Extreme { case, form, largest, of_bound, off_limit, .. } in &found {
            let limit = off_limit.map_or_else(|| "-".to_owned(), |[off, within]| format!("{off:.1e}, {within:.1e}"));
            text += &format!("| {case} | {form} | {largest:.4e} | {of_bound:.3} | {limit} |\n");
        }
        write_to(path, text.as_bytes())?;
    }
    if arguments.json {
        say_json(&json!({ "extremes": found, "broken": broken }));
        return Ok(Verdict::of(broken.is_empty()));
    }
    broken.iter().for_each(say);
    let values: usize = found.iter().map(|one| one.values).sum();
    say(format!("{} cases and forms, {values} values, {} broken promises", found.len(), broken.len()));
    arguments.out.iter().for_each(|path| say(path.display().to_string()));
    Ok(Verdict::of(broken.is_empty()))
}

fn line(point: &Point) -> String {
    format!("{:>10.3}  {:>7.2}  {:>7.2}  {:>5}°  {}", point.kib, point.mean, point.worst, point.worst_phi, point.name())
}
