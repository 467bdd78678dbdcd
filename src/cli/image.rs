//! `brdfgen image`.

use std::path::{Path, PathBuf};
use std::str::FromStr;

use clap::{Args, Subcommand};
use serde_json::{Map, json};

use super::source::{Source, read_scene};
use super::{Verdict, say, say_json, write_to};

use crate::core::sample::dot;
use crate::core::{BlockDesign, Design};
use crate::emit::package::{self, counted};
use crate::platform::error::{Error, refuse};
use crate::reflectance::{Light, Rgb, Vector};
use crate::scene::{self, LightKind};

#[derive(Args)]
pub(super) struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Write the records of lights: the codes that a core is given at the ports of a light
    Lights(Box<LightsArguments>),
}

#[derive(Args)]
struct LightsArguments {
    /// A light PHI,GAMMA or PHI,GAMMA,R,G,B: its angle from the viewer's direction in degrees, 0 to 180, its azimuth,
    /// and its intensity a channel, 0 to 1 [default: 1,1,1]; repeat for more
    #[arg(long, value_name = "LIGHT", allow_hyphen_values = true, required_unless_present = "scene")]
    light: Vec<GivenLight>,

    /// The distant lights of a scene, seen along its camera's axis
    #[arg(long, value_name = "SCENE", conflicts_with = "light")]
    scene: Option<PathBuf>,

    /// The table as CSV: a row a light, a column a port; `-` is standard output [default: `-`, and nothing with --json]
    #[arg(long, value_name = "FILE.csv")]
    csv: Option<PathBuf>,

    /// The words of the core's table of lights, a hexadecimal number a line from the word 0 on, as $readmemh takes them
    #[arg(long, value_name = "FILE.mem")]
    mem: Option<PathBuf>,

    /// Print the result as JSON
    #[arg(long)]
    json: bool,

    #[command(flatten)]
    source: Source,
}

/// A light as it is given.
#[derive(Clone, Copy, Debug)]
struct GivenLight {
    at: Light,
    intensity: Rgb,
}

impl FromStr for GivenLight {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || "a light is PHI,GAMMA or PHI,GAMMA,R,G,B, as in 60,20 or 60,20,1,0.5,0.2".to_owned();
        let numbers: Vec<f64> =
            text.split(',').map(|part| part.trim().parse()).collect::<Result<_, _>>().map_err(|_| wrong())?;
        let (phi, gamma, intensity) = match numbers[..] {
            [phi, gamma] => (phi, gamma, [1.0; 3]),
            [phi, gamma, r, g, b] => (phi, gamma, [r, g, b]),
            _ => return Err(wrong()),
        };
        if !(0.0..=180.0).contains(&phi) || !gamma.is_finite() {
            return Err(format!("{phi},{gamma}: PHI is from 0 to 180 degrees, GAMMA any number of degrees"));
        }
        Ok(Self { at: Light::new(phi, gamma), intensity })
    }
}

pub(super) fn run(arguments: &Arguments) -> Result<Verdict, Error> {
    match &arguments.command {
        Command::Lights(arguments) => lights(arguments),
    }
}

/// The distant lights of a scene in the frame in which the viewer is at +z.
fn of_scene(path: &Path) -> Result<Vec<GivenLight>, Error> {
    let scene = read_scene(path)?;
    let [right, up, ahead] = scene.camera.axes();
    let light = |light: &scene::Light| match light.kind {
        LightKind::Directional(l) => {
            let seen = Vector::new(dot(l, right), dot(l, up), -dot(l, ahead));
            Ok(GivenLight { at: Light::towards(seen), intensity: light.colour })
        }
        LightKind::Point(_) => Err(Error::input(
            format!("{} has a light at a point, which is in another direction for every pixel", path.display()),
            "lights in a direction only",
        )),
    };
    let lights = scene.lights.iter().map(light).collect::<Result<Vec<_>, Error>>()?;
    refuse!(lights.is_empty(), format!("{} has no lights", path.display()), "a scene with lights, or --light");
    Ok(lights)
}

/// The words of a core's table of lights for these records, as text.
fn words(design: &Design, records: &[Vec<i64>]) -> Result<String, Error> {
    let Some(table) = package::light_table(design).filter(|table| table.words.is_none()) else {
        return Err(Error::input(
            format!("the core {} has no table of lights that is written", design.spec.name),
            "leave --mem out, or generate the core with light_source = \"table\"",
        ));
    };
    let a_word = table.record.lanes.len() / records[0].len();
    let most = a_word * table.depth as usize;
    refuse!(
        records.len() > most,
        format!("{} lights are more than the {most} of the table of {}", records.len(), design.spec.name),
        "fewer lights, or a core with a greater most_lights"
    );
    Ok(records.chunks(a_word).map(|of_word| table.word(&of_word.concat()) + "\n").collect())
}

fn lights(arguments: &LightsArguments) -> Result<Verdict, Error> {
    let design = arguments.source.design()?;
    let BlockDesign::Image(image) = design.block() else {
        return Err(Error::input(
            format!("the core {} is no image-based block", design.spec.name),
            "give one: a spec with block = \"image\", or the directory of one",
        ));
    };
    let given = match &arguments.scene {
        Some(path) => of_scene(path)?,
        None => arguments.light.clone(),
    };
    let records = given
        .iter()
        .map(|light| image.block.fixed_light(light.at, light.intensity).map(|light| image.block.light_codes(&light)))
        .collect::<Result<Vec<_>, Error>>()?;
    // Those of the first light.
    let ports = &design.light_inputs()[..records[0].len()];
    if arguments.json {
        let row = |(light, record): (&GivenLight, &Vec<i64>)| {
            let codes: Map<String, serde_json::Value> =
                ports.iter().zip(record).map(|(&port, &code)| (port.to_owned(), json!(code))).collect();
            json!({ "phi": light.at.phi, "gamma": light.at.gamma, "intensity": light.intensity, "codes": codes })
        };
        say_json(&given.iter().zip(&records).map(row).collect::<Vec<_>>());
    }
    arguments
        .source
        .paths()
        .may_write("--csv", arguments.csv.as_ref())
        .may_write("--mem", arguments.mem.as_ref())
        .check()?;
    if let Some(path) = &arguments.mem {
        write_to(path, words(&design, &records)?.as_bytes())?;
    }
    let quiet = arguments.json || arguments.mem.is_some();
    let Some(path) = arguments.csv.clone().or_else(|| (!quiet).then(|| PathBuf::from("-"))) else {
        return Ok(Verdict::Done);
    };
    let mut text = format!("{}\n", ports.join(","));
    for record in &records {
        text += &(record.iter().map(i64::to_string).collect::<Vec<_>>().join(",") + "\n");
    }
    write_to(&path, text.as_bytes())?;
    if path.as_os_str() != "-" && !arguments.json {
        say(format!("{} in {}", counted(records.len() as u64, "record"), path.display()));
    }
    Ok(Verdict::Done)
}
