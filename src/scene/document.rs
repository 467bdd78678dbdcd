//! What a scene's core says of itself: `scene.md` for people and `scene.json` for programs.

use askama::Template;
use serde::Serialize;
use serde_json::json;

use super::choice::{SceneChoice, SceneCore, Verified};
use super::highlight::Codes;
use super::require::{MaterialNeed, PictureError};
use super::shade::{self, Shaded};
use super::simplify::{Saving, Simplification};
use super::{Budget, Requirements, Scene};
use crate::core::{Design, Direction, Role};
use crate::emit::package::{File, counted, rounded};
use crate::emit::{markdown, render};
use crate::explore::Cost;
use crate::platform::error::Error;
use crate::spec::{InputRange, Operand, SpecFields};

/// The names of the files.
pub const FILES: [&str; 3] = ["scene.md", "scene.json", "scene.png"];

/// All that is known of a scene's core.
#[derive(Clone, Copy)]
pub struct Findings<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// What it requires.
    pub requirements: &'a Requirements,
    /// The choice.
    pub choice: &'a SceneChoice,
    /// The chosen core.
    pub chosen: &'a SceneCore,
    /// What it leaves out.
    pub simplifications: &'a [Simplification],
    /// The chosen core, built.
    pub design: &'a Design,
    /// Its pictures.
    pub verified: &'a Verified,
    /// The shader around it, where that is what was asked for.
    pub shaded: Option<&'a Shaded>,
}

/// A material and the code of `in_n` that stands for it.
#[derive(Clone, Debug, Serialize)]
struct Coded {
    name: String,
    /// None where it is drawn by its reflectance.
    shininess: Option<f64>,
    code: Option<u32>,
    modelled: bool,
    #[serde(skip)]
    note: String,
}

impl Coded {
    /// The name in a cell of a table.
    fn cell(&self) -> String {
        markdown::text(&self.name)
    }
}

struct LeftOut {
    what: &'static str,
    reason: String,
    keys: String,
    saves: String,
}

#[derive(Template)]
#[template(path = "scene/scene.md", escape = "none")]
struct Sheet<'a> {
    scene: &'a Scene,
    requirements: &'a Requirements,
    design: &'a Design,
    /// The name of the core: the lobe's, or that of the shader around it.
    name: &'a str,
    shader: bool,
    port: &'static str,
    budget: String,
    materials: Vec<Coded>,
    /// What of the MTL files is left out.
    not_read: Vec<String>,
    output: &'a str,
    samples: u64,
    errors: Vec<(&'static str, String, String, String, String)>,
    left_out: Vec<LeftOut>,
    estimated_by: String,
    kept: Vec<LeftOut>,
    outside: Vec<String>,
}

/// A budget in words.
#[must_use]
pub fn budget_text(budget: &Budget) -> String {
    let (steps, psnr) = budget.limits();
    let steps = steps.map(|steps| format!("an error of at most {}", counted(steps, "step")));
    let psnr = psnr.map(|psnr| format!("a PSNR of at least {psnr} dB"));
    steps.into_iter().chain(psnr).collect::<Vec<_>>().join(" and ")
}

/// A PSNR in words.
#[must_use]
pub fn psnr_text(psnr: Option<f64>) -> String {
    psnr.map_or_else(|| "no difference".to_owned(), |psnr| format!("{psnr:.2} dB"))
}

/// What a simplification saves, and what it costs, in words; nothing where the costs are the same.
#[must_use]
pub fn saving_text(saving: &Saving) -> String {
    let difference = |of: fn(&Cost) -> u32| i64::from(of(&saving.without)) - i64::from(of(&saving.with));
    let clocks = difference(|cost| cost.latency);
    let all = [
        (difference(|cost| cost.lut), "LUT"),
        (difference(|cost| cost.ff), "FF"),
        (difference(|cost| cost.dsp), "DSP"),
        (difference(|cost| cost.bram), "block RAM"),
        (clocks, if clocks.abs() == 1 { "clock" } else { "clocks" }),
        (saving.without_rom_bits as i64 - saving.with_rom_bits as i64, "ROM bits"),
    ];
    let listed = |sign: i64| -> String {
        let of_sign = all.iter().filter(|(more, _)| more.signum() == sign);
        of_sign.map(|(more, what)| format!("{} {what}", more.abs())).collect::<Vec<_>>().join(", ")
    };
    match (listed(1), listed(-1)) {
        (less, more) if less.is_empty() && more.is_empty() => "nothing".to_owned(),
        (less, more) if more.is_empty() => less,
        (less, more) if less.is_empty() => format!("nothing, and takes {more} more"),
        (less, more) => format!("{less}, and takes {more} more"),
    }
}

/// Keys of a spec in a line, a list of materials as its length.
#[must_use]
pub fn keys_text(keys: &SpecFields) -> String {
    let materials = keys.material.as_ref().map(|all| counted(all.len() as u64, "material"));
    let rest = SpecFields { material: None, ..keys.clone() }.to_toml();
    let rest = rest.lines().map(str::to_owned).filter(|line| !line.is_empty());
    materials.into_iter().chain(rest).collect::<Vec<_>>().join(", ")
}

impl Findings<'_> {
    fn materials(&self) -> Vec<Coded> {
        let Self { scene, requirements, design, shaded, .. } = self;
        if let Some(shaded) = shaded {
            let codes = shade::rows(&shaded.design, scene);
            let coded = |(need, code): (&MaterialNeed, &Option<u32>)| {
                let note = if code.is_some() { "" } else { "not modelled: no picture shows it" };
                let (name, note) = (need.name.clone(), note.to_owned());
                Coded { name, shininess: Some(need.shininess), code: *code, modelled: code.is_some(), note }
            };
            return requirements.materials.iter().zip(&codes).map(coded).collect();
        }
        let indices = Codes::of(design, scene, &requirements.frame).indices;
        let coded = |(need, &code): (&MaterialNeed, &u32)| {
            if need.measured {
                let note = "drawn by its reflectance: it asks for no lobe".to_owned();
                return Coded { name: need.name.clone(), shininess: None, code: None, modelled: false, note };
            }
            let row = design.lobe().interface.shininess.row_of_index(code);
            let modelled = need.row.is_some();
            let note = match (modelled, need.used) {
                (true, _) => String::new(),
                _ if need.peak_steps == 0.0 => "no highlight: k_s is 0".to_owned(),
                (_, used) => {
                    let why = if used { "on no lit pixel" } else { "no object has it" };
                    format!(
                        "not modelled: {why}; the nearest row, n = {}",
                        design.lobe().interface.shininess.value(row)
                    )
                }
            };
            Coded { name: need.name.clone(), shininess: Some(need.shininess), code: Some(code), modelled, note }
        };
        requirements.materials.iter().zip(&indices).map(coded).collect()
    }

    /// What the core does with inputs, materials and views that were not modelled.
    fn outside(&self) -> Vec<String> {
        let Self { requirements, chosen, design, scene, .. } = self;
        if let Some(shaded) = self.shaded {
            let last = shaded.design.lobe().interface.shininess.rows() - 1;
            return vec![
                format!("`in_material` above {last} selects row {last}."),
                "Vectors of any length and direction have a defined result: each cosine is taken into [0, 1], a light \
                 from behind gives nothing, and a channel above full scale is full scale."
                    .to_owned(),
                format!(
                    "Other views are measured only as far as the moved pictures go. Another light, colour or material \
                     than those of `{}` needs another shader.",
                    scene.name
                ),
            ];
        }
        let last = design.lobe().interface.shininess.rows() - 1;
        let mut lines = vec![format!(
            "`in_n` above {last} selects row {last}, n = {}.",
            design.lobe().interface.shininess.value(last)
        )];
        let operand = design.ports().into_iter().find(|port| port.role == Role::Operand);
        lines.extend(operand.map(|port| format!("`{}`: {}.", port.name, port.meaning)));
        if design.lobe().interface.operand == Operand::Cos && requirements.least_cosine.is_some_and(|least| least < 0.0)
        {
            lines.push("Negative cosines were met, and give 0.".to_owned());
        }
        if design.lobe().interface.operand == Operand::Cos && design.lobe().interface.input_range == InputRange::Unit {
            lines.push(
                "No picture has a negative cosine on a lit point; the port has no sign, so give 0 for one.".to_owned(),
            );
        }
        let n = match requirements.rows.as_slice() {
            [one] => format!("n = {}", one.shininess),
            _ => "the rows".to_owned(),
        };
        lines.push(format!(
            "Any other view, normal and light direction: with {n} of these materials and the {} of the scene no \
             channel is off by more than {}, as the lobe is off by at most {:.3e} ({}) and half of the input's last \
             bit moves it by at most n 2^-{}.",
            counted(requirements.lights as u64, "light"),
            counted(chosen.guaranteed_steps(), "step"),
            chosen.candidate.point.max_abs,
            chosen.candidate.point.checked,
            design.lobe().interface.input_fraction + 1,
        ));
        lines.push(format!(
            "Another shininess than those of the rows is not served; a material that is not modelled is drawn with the \
             row whose shininess is nearest. More or brighter lights raise the bound in proportion. Make the core anew \
             when `{}`'s materials change.",
            scene.name
        ));
        lines
    }

    fn errors(&self) -> Vec<(&'static str, String, String, String, String)> {
        let Self { verified, requirements, scene, shaded, .. } = self;
        let own = |of: fn(&Shaded) -> PictureError, lobe: PictureError| shaded.map_or(lobe, of);
        let base = own(|shaded| shaded.base, PictureError::of(&verified.base, scene.channel_bits));
        let row = |name, steps: u16, mean: f64, psnr, off| {
            (name, counted(steps, "step"), format!("{mean:.5}"), psnr_text(psnr), off)
        };
        let mut rows = vec![row("base", base.max_steps, base.mean_steps, base.psnr, base.pixels_off.to_string())];
        if requirements.pictures.len() > 1 {
            let moved = own(|shaded| shaded.moved, verified.moved);
            let PictureError { max_steps, mean_steps, psnr, pixels_off, .. } = moved;
            rows.push(row("moved, the worst of each", max_steps, mean_steps, psnr, format!("{pixels_off} in all")));
        }
        rows
    }

    /// The files `scene.md` and `scene.json`.
    ///
    /// # Errors
    /// If the template cannot be filled in.
    pub fn files(&self) -> Result<Vec<File>, Error> {
        let sheet = File { path: FILES[0].to_owned(), bytes: self.sheet()?.into_bytes() };
        let json = serde_json::to_string_pretty(&rounded(self.json())).expect("JSON of plain values") + "\n";
        Ok(vec![sheet, File { path: FILES[1].to_owned(), bytes: json.into_bytes() }])
    }

    /// The port that selects the material.
    fn port(&self) -> &'static str {
        if self.shaded.is_some() { "in_material" } else { "in_n" }
    }

    fn sheet(&self) -> Result<String, Error> {
        let Self { scene, requirements, choice, simplifications, design, verified, shaded, .. } = self;
        let (applied, kept): (Vec<&Simplification>, Vec<&Simplification>) =
            simplifications.iter().partition(|one| one.applies);
        let left_out = |one: &Simplification| LeftOut {
            what: one.what,
            reason: one.reason.clone(),
            keys: keys_text(&one.keys),
            saves: one.saves.as_ref().map(saving_text).unwrap_or_default(),
        };
        let tools = choice.tools.as_ref().map(|tools| tools.yosys.clone()).unwrap_or_default();
        let made = if choice.estimated { "estimates by a cost model that follows" } else { "as synthesised with" };
        let estimated_by =
            format!("Savings are {made} {tools}: the core against the same core with that one thing put back.");
        render(&Sheet {
            scene,
            requirements,
            design,
            name: &shaded.map_or(*design, |shaded| &shaded.design).spec.name,
            shader: shaded.is_some(),
            port: self.port(),
            budget: budget_text(&requirements.budget),
            materials: self.materials(),
            not_read: scene.left_out.iter().map(|line| markdown::text(line)).collect(),
            output: design.numbers(Direction::Out)[0].0,
            samples: shaded.map_or(verified.samples, |shaded| shaded.samples),
            errors: self.errors(),
            left_out: applied.into_iter().map(left_out).collect(),
            estimated_by,
            kept: kept.into_iter().map(left_out).collect(),
            outside: self.outside(),
        })
    }

    /// All of it.
    #[must_use]
    pub fn json(&self) -> serde_json::Value {
        let Self { scene, requirements, choice, chosen, simplifications, design, verified, .. } = self;
        let base = &verified.base;
        let core = |core: &SceneCore| {
            json!({
                "name": core.candidate.point.name,
                "cost": core.candidate.cost,
                "rom_bits": core.candidate.point.rom_bits,
                "max_abs": core.candidate.point.max_abs,
                "checked": core.candidate.point.checked,
                "lobe_rms_on_the_picture": core.lobe_rms,
                "base": core.base,
                "moved": core.moved,
                "guaranteed_steps": core.guaranteed_steps(),
            })
        };
        let refused = |one: &SceneCore, why: serde_json::Value| {
            let mut value = core(one);
            value["why_not"] = why;
            value
        };
        json!({
            "scene": scene.name,
            "model": scene.model,
            "channel_bits": scene.channel_bits,
            "lights": scene.lights.len(),
            "budget": requirements.budget,
            "margin_degrees": requirements.margin_degrees,
            "materials": self.materials(),
            "left_out_of_mtl": scene.left_out,
            "ports": {
                design.lobe().operand_name(): design.lobe().operand_format().to_string(),
                design.numbers(Direction::Out)[0].0: design.lobe().output_format().to_string(),
            },
            "pictures": requirements.pictures,
            "size": requirements.size,
            "moved_size": requirements.moved_size,
            "requires": requirements,
            "port": self.port(),
            "shader": self.shaded.map(|shaded| {
                json!({
                    "name": shaded.design.spec.name,
                    "flags": shaded.design.spec.flags(),
                    "latency": shaded.design.schedule.latency,
                    "samples": shaded.samples,
                    "base": shaded.base,
                    "moved": shaded.moved,
                    "missed": shaded.missed,
                })
            }),
            "through_the_model": {
                "samples": verified.samples,
                "base": base,
                "moved": verified.moved,
            },
            "chosen": core(chosen),
            "runner_ups": choice.runner_ups.iter().map(|one| refused(&one.core, json!(one.why))).collect::<Vec<_>>(),
            "near_misses": choice.misses.iter().map(|one| refused(&one.core, json!(one.why))).collect::<Vec<_>>(),
            "considered": choice.considered,
            "meeting": choice.meeting,
            "costs_are_estimates": choice.estimated,
            "tools": choice.tools,
            "simplifications": simplifications,
            "outside_of_what_was_modelled": self.outside(),
        })
    }
}
