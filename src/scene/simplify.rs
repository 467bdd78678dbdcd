//! What a scene's core may leave out, why, and what that saves.

use std::collections::BTreeMap;

use rayon::prelude::*;
use serde::Serialize;

use super::choice::{SceneCore, Search};
use super::{Requirements, Scene};
use crate::emit::package::counted;
use crate::explore::Cost;
use crate::fit::Objective;
use crate::platform::error::Error;
use crate::spec::{CoreSpec, InputRange, MAX_ROWS, MethodName, Shininess, SpecFields};

/// The fraction bits of input and output of a core that nothing is known of.
const GENERAL_FRACTION: u32 = 16;
/// The greatest shininess of a core that nothing is known of.
const GENERAL_SHININESS: u32 = 1000;

/// A simplification, or why there is none.
#[derive(Clone, Debug, Serialize)]
pub struct Simplification {
    /// What is simplified.
    pub what: &'static str,
    /// Whether the chosen core has it.
    pub applies: bool,
    /// Why it may be, or why it is not.
    pub reason: String,
    /// The figures behind the reason.
    pub evidence: BTreeMap<&'static str, f64>,
    /// The keys of the spec that make it; none of one that does not apply, or that no key makes.
    pub keys: SpecFields,
    /// The chosen core without it, whole.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub undone: Option<SpecFields>,
    /// What it saves.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub saves: Option<Saving>,
}

/// What a simplification saves: the chosen core against the same core without it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Saving {
    /// What the chosen core takes.
    pub with: Cost,
    /// The bits of its memories.
    pub with_rom_bits: u64,
    /// What it would take without the simplification.
    pub without: Cost,
    /// The bits of its memories then.
    pub without_rom_bits: u64,
}

impl Simplification {
    /// One that does not apply.
    fn new(what: &'static str, reason: String, evidence: &[(&'static str, f64)]) -> Self {
        let evidence = evidence.iter().copied().collect();
        Self { what, applies: false, reason, evidence, keys: SpecFields::default(), undone: None, saves: None }
    }

    /// The same applied, by these keys.
    fn with(self, keys: SpecFields, undone: SpecFields) -> Self {
        Self { applies: true, keys, undone: Some(undone), ..self }
    }
}

/// A share of samples as a percentage.
fn percent(part: u64, whole: u64) -> f64 {
    if whole == 0 { 0.0 } else { 100.0 * part as f64 / whole as f64 }
}

/// Everything that the chosen core of a scene may leave out, whether it does and why, with what each saves: the cost,
/// by the costing of the search, of the chosen core against the same core with that one simplification undone.
///
/// # Errors
/// A tool that is missing or fails.
pub fn simplifications(
    scene: &Scene,
    requirements: &Requirements,
    search: &Search,
    chosen: &SceneCore,
) -> Result<Vec<Simplification>, Error> {
    let fields = chosen.spec()?;
    let spec = fields.clone().resolve()?;
    let all = vec![
        materials(scene, requirements, &fields),
        input(requirements, &fields, &spec),
        output(requirements, &fields, &spec),
        accuracy(requirements, chosen, &fields, &spec, scene),
        tail(requirements, &fields, &spec),
        range(requirements, &fields, &spec),
        lights(requirements),
        saturation(requirements),
    ];
    let with = (chosen.candidate.cost, chosen.candidate.point.rom_bits);
    let costed = |one: Simplification| -> Result<Simplification, Error> {
        let saves = match &one.undone {
            Some(undone) if one.applies => {
                let (without, without_rom_bits) = search.cost(undone)?;
                Some(Saving { with: with.0, with_rom_bits: with.1, without, without_rom_bits })
            }
            _ => None,
        };
        Ok(Simplification { saves, ..one })
    };
    all.into_par_iter().map(costed).collect()
}

fn materials(scene: &Scene, requirements: &Requirements, fields: &SpecFields) -> Simplification {
    let rows = &requirements.rows;
    let greatest = rows.iter().map(|row| row.shininess).fold(1.0, f64::max);
    let last = f64::from(GENERAL_SHININESS).max(libm::ceil(greatest)) as u32;
    let unseen = requirements.materials.iter().filter(|need| need.row.is_none()).count();
    let shared = requirements.materials.len() - unseen - rows.len();
    let mut reason = format!(
        "the pictures ask for {} of the scene's {}: {} of a ROM",
        if rows.len() == 1 { "1 shininess".to_owned() } else { format!("{} shininesses", rows.len()) },
        counted(requirements.materials.len() as u64, "material"),
        counted(rows.len() as u64, "row"),
    );
    if shared > 0 {
        reason += &format!("; {shared} more {} the shininess of another", if shared == 1 { "has" } else { "have" });
    }
    if unseen > 0 {
        reason += &format!(
            "; {unseen} {} none: without a highlight, or on no lit pixel",
            if unseen == 1 { "needs" } else { "need" }
        );
    }
    // Beyond that many rows the general core cannot be built.
    let undone = (last as usize <= MAX_ROWS).then(|| SpecFields {
        material: None,
        shininess: Some(Shininess::Range(1, last)),
        ..fields.clone()
    });
    let keys = SpecFields { material: fields.material.clone(), ..SpecFields::default() };
    let evidence = [
        ("materials", scene.materials.len() as f64),
        ("rows", rows.len() as f64),
        ("rows_of_the_general_core", f64::from(last)),
        ("greatest_shininess", greatest),
    ];
    let simplification = Simplification::new("only the scene's materials", reason, &evidence);
    Simplification { applies: true, keys, undone, ..simplification }
}

/// Fewer bits of a port than a general core has: `what` is simplified, `own` of the bits are the chosen core's, and
/// `width` sets them.
fn fewer_bits(
    what: &'static str,
    (port, needed): (&str, super::require::Bits),
    own: u32,
    measure: (&'static str, f64),
    fields: &SpecFields,
    width: fn(u32) -> SpecFields,
) -> Simplification {
    let measured = match needed.measured {
        Some(fewest) => format!(
            "with the exact lobe, all pictures keep the budget with {fewest} fraction bits of the {port} and not with \
             fewer"
        ),
        None => format!("not even the most fraction bits of the {port} keep the budget"),
    };
    let derived = match needed.derived {
        Some(bits) => format!("with {bits} the rounding takes at most a quarter of the budget in any view"),
        None => "no number of them is proved to be enough in any view".to_owned(),
    };
    let mut reason = format!("{measured}, and {derived}; {own} were chosen by the pictures");
    let applies = own < GENERAL_FRACTION;
    if !applies {
        reason += &format!(", no fewer than the {GENERAL_FRACTION} of a general core");
    }
    let one = Simplification::new(what, reason, &[("bits", f64::from(own)), measure]);
    if applies { one.with(width(own), width(GENERAL_FRACTION).or(fields.clone())) } else { one }
}

fn input(requirements: &Requirements, fields: &SpecFields, spec: &CoreSpec) -> Simplification {
    let greatest = requirements.rows.iter().map(|row| row.shininess).fold(1.0, f64::max);
    let port = ("input", requirements.input_fraction);
    let measure = ("greatest_shininess", greatest);
    fewer_bits("fewer bits of the cosine", port, spec.block.lobe().interface.input_fraction, measure, fields, |bits| {
        SpecFields { input_fraction: Some(bits), ..SpecFields::default() }
    })
}

fn output(requirements: &Requirements, fields: &SpecFields, spec: &CoreSpec) -> Simplification {
    let peak = requirements.materials.iter().map(|need| need.peak_steps).fold(0.0, f64::max);
    let port = ("output", requirements.output_fraction);
    let measure = ("brightest_highlight_steps", peak);
    fewer_bits("fewer bits of the lobe", port, spec.block.lobe().interface.output_fraction, measure, fields, |bits| {
        SpecFields { output_fraction: Some(bits), ..SpecFields::default() }
    })
}

/// The core that computes `x^n` to its last bit, with the ports of the chosen one.
fn faithful(fields: &SpecFields) -> SpecFields {
    let fields = fields.clone();
    SpecFields {
        method: MethodName::named("log-exp"),
        name: fields.name,
        material: fields.material,
        input_fraction: fields.input_fraction,
        output_fraction: fields.output_fraction,
        monotone: fields.monotone,
        input_range: fields.input_range,
        operand: fields.operand,
        rom: fields.rom,
        rom_formats: fields.rom_formats,
        pipeline: fields.pipeline,
        languages: fields.languages,
        ..SpecFields::default()
    }
}

fn accuracy(
    requirements: &Requirements,
    chosen: &SceneCore,
    fields: &SpecFields,
    spec: &CoreSpec,
    scene: &Scene,
) -> Simplification {
    let point = &chosen.candidate.point;
    let applies =
        spec.block.lobe().method.about().name != "log-exp" || spec.block.lobe().method.options().accuracy.is_some();
    let allowed = requirements.budget.steps(scene.channel_bits);
    let reason = if applies {
        format!(
            "the budget allows {allowed:.3} step{} before the rounding; this core's lobe is off by at most {:.2e}, \
             {:.2e} rms on the picture's samples",
            if allowed == 1.0 { "" } else { "s" },
            point.max_abs,
            chosen.lobe_rms
        )
    } else {
        "the budget needs the lobe to its last bit".to_owned()
    };
    let evidence = [
        ("allowed_steps", allowed),
        ("max_abs", point.max_abs),
        ("rms_on_the_picture", chosen.lobe_rms),
        ("max_steps", f64::from(chosen.base.max_steps.max(chosen.moved.max_steps))),
    ];
    let one = Simplification { applies, ..Simplification::new("accuracy from the budget", reason, &evidence) };
    let undone = faithful(fields);
    if !applies || undone.clone().resolve().is_err() {
        return one;
    }
    let SpecFields { method, coefficients, accuracy, .. } = fields.clone();
    one.with(SpecFields { method, coefficients, accuracy, ..SpecFields::default() }, undone)
}

fn tail(requirements: &Requirements, fields: &SpecFields, spec: &CoreSpec) -> Simplification {
    let counts = requirements.base.and(&requirements.moved);
    let level = requirements.invisible_below.unwrap_or(1.0);
    let (visible, invisible) =
        (percent(counts.visible_tail, counts.lit()), percent(counts.invisible_tail, counts.lit()));
    let evidence = [
        ("invisible_below", level),
        ("visible_tail_percent", visible),
        ("invisible_tail_percent", invisible),
        ("epicentre_percent", percent(counts.epicentre, counts.lit())),
    ];
    let seen = format!(
        "highlights below {:.3} % of the lobe are less than half a step: {invisible:.1} % of the lit samples, and \
         {visible:.1} % are of a tail that is seen",
        100.0 * level
    );
    let objective = spec.block.lobe().method.options().objective;
    let what = "the tail that cannot be seen";
    if let Some(objective @ Objective::MaxAbsLevel { .. }) = objective {
        let reason = format!("{seen}; the coefficients are fitted above {objective} only");
        let keys = SpecFields { objective: Some(objective), ..SpecFields::default() };
        let undone = SpecFields { objective: Some(Objective::MaxAbs), ..fields.clone() };
        return Simplification::new(what, reason, &evidence).with(keys, undone);
    }
    let why = if spec.block.lobe().is_fitted() {
        "coefficients fitted to the visible part alone make no cheaper core that keeps the budget"
    } else {
        "the chosen method has no fitted coefficients that could leave it out"
    };
    Simplification::new(what, format!("{seen}; {why}"), &evidence)
}

fn range(requirements: &Requirements, fields: &SpecFields, spec: &CoreSpec) -> Simplification {
    let counts = requirements.base.and(&requirements.moved);
    let negative = percent(counts.negative, counts.lit());
    let least = requirements.least_cosine.unwrap_or(0.0);
    let evidence = [("least_cosine", least), ("negative_percent", negative)];
    let what = "no negative cosines";
    if !requirements.stays_in_range() {
        let reason =
            format!("negative cosines occur: {negative:.2} % of the lit samples, down to {least:.4}; the clamp stays");
        return Simplification::new(what, reason, &evidence);
    }
    let reason = format!("no lit sample has a negative cosine: the least is {least:.4}");
    if spec.block.lobe().interface.input_range != InputRange::Unit {
        return Simplification::new(what, reason + "; the keys ask for a port that takes any", &evidence);
    }
    let range = |range: InputRange| SpecFields { input_range: Some(range), ..SpecFields::default() };
    Simplification::new(what, reason, &evidence)
        .with(range(InputRange::Unit), range(InputRange::Any).or(fields.clone()))
}

fn lights(requirements: &Requirements) -> Simplification {
    let count = requirements.lights;
    let reason = format!("the scene has {}: a shader around this lobe needs no more", counted(count as u64, "light"));
    Simplification::new("no more lights than there are", reason, &[("lights", count as f64)])
}

fn saturation(requirements: &Requirements) -> Simplification {
    let [base, moved] = requirements.saturated;
    let reason = if base + moved > 0 {
        format!(
            "channels exceed full scale in {base} pixels of the base picture and {moved} of the moved ones: a shader \
             must saturate"
        )
    } else {
        "no channel exceeds full scale in any picture; the lobe has no adder that could lose its saturation".to_owned()
    };
    let evidence = [("pixels_base", base as f64), ("pixels_moved", moved as f64)];
    Simplification::new("no saturation", reason, &evidence)
}
