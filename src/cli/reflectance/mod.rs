//! `brdfgen reflectance`.

mod arguments;

use std::path::PathBuf;

use clap::{Args, Subcommand};
use rayon::prelude::*;
use serde_json::{Value, json};

use self::arguments::{
    ConvertArguments, CosineName, EvalArguments, FitArguments, FormName, ImagesArguments, InfoArguments,
    StabilityArguments, TradeArguments,
};
use super::{Verdict, progress, say, say_json, write_to};
use crate::emit::package::{self, Kind};
use crate::platform::error::{Error, refuse};
use crate::reflectance::classical::{self, Cosine, Fit};
use crate::reflectance::measure::{self, Judge};
use crate::reflectance::points::Points;
use crate::reflectance::trade::{self, Point};
use crate::reflectance::{Form, Light, Rgb, Source, Texel, Vector, directory, extremes, info, merl};
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
    /// Look every form up where it degenerates: values must be finite, within their bounds, at their limits, the same
    /// on all threads
    Stability(StabilityArguments),
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
        Source::Table(table) => {
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
        Source::Model(model) => {
            lines.push(format!("{model}: {}", model.family().source()));
            put("kind", json!("model"));
            put("model", json!(model.family().name()));
            put("source", json!(model.family().source()));
        }
        Source::Images(form) => {
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
    refuse!(
        to.as_os_str() != "-" && to.extension().is_none_or(|extension| extension != "binary"),
        format!("{} does not end in .binary", to.display()),
        "tables are written as MERL files, NAME.binary, or `-` for standard output"
    );
    let material = model.open(from)?;
    let phi_d = arguments.phi_d.as_ref().and_then(|cells| cells.parse().ok());
    let table = match &material.what {
        Source::Table(table) => table.with_phi_d(phi_d.unwrap_or(table.shape()[2])),
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
    let files: Vec<package::File> = files.into_iter().map(|(path, bytes)| package::File { path, bytes }).collect();
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

fn run_eval(arguments: &EvalArguments) -> Result<Verdict, Error> {
    let points = Points::read(&arguments.points)?;
    let (material, flags) = (&arguments.material, &arguments.form);
    // Wrong flags are named before a table is read.
    let asked = flags.form.unwrap_or(FormName::Exact);
    let spec = flags.spec(asked)?;
    let opened = material.open()?;
    let (form, exposure) = match &opened.what {
        Source::Images(form) => {
            refuse!(
                flags.form.is_some() || flags.is_given() || material.model.exposure.is_some(),
                format!("{} is a form already: {}", opened.name, form.spec),
                "leave --form, --exposure and the other keys of a form out"
            );
            (Some(form.clone()), form.exposure)
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
    let values: Vec<Rgb> = points.rows.par_iter().map(value).collect();
    let shape = form.as_ref().map_or_else(|| "exact".to_owned(), |form| form.spec.to_string());
    let to = arguments.csv.clone().or_else(|| (!arguments.json).then(|| PathBuf::from("-")));
    if let Some(path) = &to {
        if arguments.json && path.as_os_str() == "-" {
            return Err(Error::input("standard output cannot take two things", "write the CSV to a file"));
        }
        write_to(path, &points.csv(&values)?)?;
    }
    if arguments.json {
        let mut value = json!({
            "material": opened.name,
            "form": shape,
            "exposure": exposure,
            "kib": form.as_ref().map(Form::kib),
            "points": points.rows.len(),
        });
        match &arguments.csv {
            Some(path) => value["csv"] = json!(path),
            None => value["values"] = json!(values),
        }
        say_json(&value);
    } else if let Some(path) = to.filter(|path| path.as_os_str() != "-") {
        say(format!(
            "{}, {shape}, exposure {exposure}: {} points in {}",
            opened.name,
            points.rows.len(),
            path.display()
        ));
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
    if let Some(path) = &arguments.csv {
        write_to(path, &trade::csv(&points)?)?;
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
            None => say("nothing meets the constraints"),
        }
        for path in arguments.csv.iter().chain(&arguments.svg) {
            say(path.display().to_string());
        }
    }
    Ok(Verdict::of(chosen.is_some()))
}

fn run_stability(arguments: &StabilityArguments) -> Result<Verdict, Error> {
    let bar = progress::bar("measuring", 1);
    let found = extremes::measure(&|done, of| progress::show(&bar, done, of))?;
    bar.finish_and_clear();
    let broken: Vec<String> = found.iter().flat_map(extremes::Extreme::failures).collect();
    if let Some(path) = &arguments.out {
        write_to(path, extremes::chapter(&found).as_bytes())?;
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
