//! A scene's part of the page: its pictures, what it asks for, the core that it needs.

use base64::Engine as _;

use super::page::{Cell, Figure, Line, Table, count, number, word};
use crate::emit::package::counted;
use crate::explore::Cost;
use crate::platform::error::Error;
use crate::plot::{Axis, COLOURS, Chart, Curve, Style};
use crate::scene::choice::SceneCore;
use crate::scene::document::{Findings, budget_text, keys_text, psnr_text, saving_text};
use crate::scene::require::MaterialNeed;
use crate::scene::sheet::{self, Sheet};
use crate::scene::survey::{Counts, DEGREE_BINS, SCALED_BINS};
use crate::scene::{CoreModel, Exact, Frame, Highlights, Tracer};

/// A scene in the report.
#[derive(Debug)]
pub struct ScenePart {
    /// Its name.
    pub(super) name: String,
    /// What is said of it, a paragraph each.
    pub(super) lines: Vec<String>,
    /// Its pictures as a PNG file in base 64, and the size at which they are shown.
    pub(super) picture: String,
    /// Pixels a row of them.
    pub(super) width: u32,
    /// Where on the lobes its samples are.
    pub(super) charts: Vec<(String, Chart)>,
    /// Materials, what is left out, cores.
    pub(super) tables: Vec<Table>,
}

impl ScenePart {
    /// What is found of a scene, with the page that shows its pictures.
    ///
    /// # Errors
    /// A scene or a core that no picture can be drawn of.
    pub fn of(findings: &Findings) -> Result<Self, Error> {
        let Findings { scene, requirements, choice, chosen, verified, .. } = findings;
        let pixels = pictures(findings)?.pixels;
        let figures = if choice.estimated { "estimated" } else { "measured" };
        let mut lines = vec![
            format!(
                "{} by {} pixels of {} bits a channel, {}; the budget is {}, with the camera and each light moved by \
                 up to {} degrees.",
                requirements.size[0],
                requirements.size[1],
                scene.channel_bits,
                counted(requirements.lights as u64, "light"),
                budget_text(&requirements.budget),
                requirements.margin_degrees,
            ),
            format!(
                "Of the {} cores that drew it the cheapest that keeps the budget is {}: {} ({figures}). Through its \
                 bit-exact model the picture is off by {} at most, PSNR {}; {} lit samples in {} pictures. In any view \
                 of these materials under these lights no channel is off by more than {} steps.",
                choice.considered,
                chosen.candidate.point.name,
                cost_text(&chosen.candidate.cost),
                counted(verified.base.max_steps, "step"),
                psnr_text(verified.base.psnr),
                verified.samples,
                verified.pictures,
                chosen.guaranteed_steps(),
            ),
        ];
        lines.extend(scene.left_out.iter().map(|line| format!("Of the materials' files {line}.")));
        let shiny: Vec<&MaterialNeed> = requirements.materials.iter().filter(|need| need.row.is_some()).collect();
        Ok(Self {
            name: scene.name.clone(),
            lines,
            picture: base64::engine::general_purpose::STANDARD.encode(pixels.png()),
            width: pixels.width,
            charts: vec![
                (format!("scene_{}_angle", scene.name), angles(&scene.name, &shiny)),
                (format!("scene_{}_lobe", scene.name), scaled(&scene.name, &shiny)),
            ],
            tables: vec![materials(&requirements.materials), left_out(findings), cores(findings)],
        })
    }

    /// The charts for the page.
    pub(super) fn figures(&self) -> Vec<Figure> {
        self.charts.iter().map(|(name, chart)| Figure::of(name, chart)).collect()
    }
}

/// The exact picture, the core's, and how they differ.
fn pictures(findings: &Findings) -> Result<Sheet, Error> {
    let Findings { scene, design, chosen, verified, .. } = findings;
    let (frame, bases) = Frame::with_looks(&Tracer::new(scene), scene, &[scene.exact_looks()?], &|| {});
    let frame = Frame { base: bases.concat(), ..frame };
    let exact = frame.picture(scene, &Exact.of(scene, &frame)?);
    let own = frame.picture(scene, &CoreModel::new(design)?.of(scene, &frame)?);
    let lines = [format!("core {}", chosen.candidate.point.name)];
    let budget = format!("budget: {}", budget_text(&scene.budget));
    Ok(sheet::triptych(&frame, [&exact, &own], "core", &verified.base, &scene.name, &lines, &budget))
}

/// A cost in words.
fn cost_text(cost: &Cost) -> String {
    let mhz = cost.mhz.map(|mhz| format!(", {mhz:.0} MHz")).unwrap_or_default();
    format!("{} LUTs, {} DSPs, {} block RAMs, {} clocks{mhz}", cost.lut, cost.dsp, cost.bram, cost.latency)
}

/// A distribution as shares of all of its samples, a point in the middle of each bin of this width.
fn shares(bins: &[u64], width: f64) -> Vec<(f64, f64)> {
    let all: u64 = bins.iter().sum();
    let share =
        |(place, &count): (usize, &u64)| ((place as f64 + 0.5) * width, 100.0 * count as f64 / all.max(1) as f64);
    bins.iter().enumerate().map(share).collect()
}

/// A curve a material; where there are more materials than colours the line tells them apart.
fn curves<'a>(materials: &[&'a MaterialNeed], points: impl Fn(&'a MaterialNeed) -> Vec<(f64, f64)>) -> Vec<Curve> {
    let curve = |(place, need): (usize, &&'a MaterialNeed)| Curve {
        label: format!("{} (n = {})", need.name, need.shininess),
        colour: COLOURS[place % COLOURS.len()],
        style: [Style::Solid, Style::Dashed, Style::Dotted][place / COLOURS.len() % 3],
        points: points(need),
    };
    materials.iter().enumerate().map(curve).collect()
}

fn share_axis(curves: &[Curve]) -> Axis {
    let most = curves.iter().flat_map(|curve| &curve.points).map(|point| point.1).fold(1.0, f64::max);
    Axis::linear("share of the material's lit samples", 0.0..1.05 * most).with_unit(" %")
}

/// How the angles of the highlights are distributed.
fn angles(name: &str, materials: &[&MaterialNeed]) -> Chart {
    let width = 180.0 / DEGREE_BINS as f64;
    let curves = curves(materials, |need| shares(&need.spread.degrees, width));
    let last = curves.iter().flat_map(|curve| &curve.points).filter(|point| point.1 > 0.0).map(|point| point.0);
    let last = last.fold(90.0, f64::max);
    Chart::of_curves(
        format!("{name}: where the cosines lie"),
        Axis::linear("angle whose cosine is given to the core, degrees", 0.0..last),
        share_axis(&curves),
        curves,
    )
}

/// The same along the lobe, where lobes of all shininesses look alike.
fn scaled(name: &str, materials: &[&MaterialNeed]) -> Chart {
    // The last bin holds all beyond.
    let inner = SCALED_BINS - 1;
    let curves = curves(materials, |need| {
        let mut points = shares(&need.spread.scaled, 0.25);
        points.truncate(inner);
        points
    });
    Chart::of_curves(
        format!("{name}: where on the lobe the samples are"),
        Axis::linear("n(1 - x): about 0.7 at the edge of the epicentre", 0.0..0.25 * inner as f64),
        share_axis(&curves),
        curves,
    )
}

fn materials(materials: &[MaterialNeed]) -> Table {
    let line = |need: &MaterialNeed| {
        let all: Counts = need.base.and(&need.moved);
        let share = |part: u64| {
            let share = (all.samples > 0).then(|| 100.0 * part as f64 / all.samples as f64);
            number(share, |share| format!("{share:.2} %"))
        };
        let cells = vec![
            word(&need.name),
            number((!need.measured).then_some(need.shininess), |n| format!("{n}")),
            number(need.row.map(|row| row as f64), |row| format!("{row}")),
            number(Some(need.peak_steps), |steps| format!("{steps:.1}")),
            number(Some(all.samples as f64), |count| format!("{count}")),
            share(all.dark),
            share(all.epicentre),
            share(all.visible_tail),
            share(all.invisible_tail),
            share(all.negative),
            number(need.least_cosine, |x| format!("{x:.4}")),
        ];
        Line { chosen: false, cells }
    };
    Table::of(
        "Materials, over the picture and the moved ones".to_owned(),
        &[
            ("material", "its name in the scene file"),
            ("n", "its shininess"),
            ("row", "the core's row that serves it; none where it needs none"),
            ("peak", "its highlight's peak in output steps"),
            ("samples", "pixels that show it, times lights"),
            ("dark", "samples that the light does not reach"),
            ("epicentre", "samples with x^n >= 1/2"),
            ("visible tail", "samples below it that are worth half an output step or more"),
            ("invisible tail", "samples below it that are worth less"),
            ("negative", "samples with a negative cosine"),
            ("least x", "the least cosine"),
        ],
        materials.iter().map(line).collect(),
    )
}

fn left_out(findings: &Findings) -> Table {
    let line = |one: &crate::scene::simplify::Simplification| {
        let saves = match (&one.saves, one.applies) {
            (Some(saving), _) => saving_text(saving),
            (None, true) => "not measured by itself".to_owned(),
            (None, false) => String::new(),
        };
        let cells = [one.what, if one.applies { "yes" } else { "no" }, &one.reason, &keys_text(&one.keys), &saves];
        Line { chosen: false, cells: cells.into_iter().map(word).collect() }
    };
    Table::of(
        "What the core leaves out".to_owned(),
        &[
            ("what", "what may be left out"),
            ("left out", "whether it is"),
            ("why", "why, or why not"),
            ("keys", "the keys of the core's spec that say so"),
            ("saves", "the core with it put back, less the core"),
        ],
        findings.simplifications.iter().map(line).collect(),
    )
}

fn cores(findings: &Findings) -> Table {
    let line = |core: &SceneCore, why: String, chosen: bool| {
        let cost = &core.candidate.cost;
        let psnr = |psnr: Option<f64>| number(psnr, |psnr| format!("{psnr:.2}"));
        let cells: Vec<Cell> = vec![
            word(&core.candidate.point.name),
            count(Some(cost.lut)),
            count(Some(cost.dsp)),
            count(Some(cost.bram)),
            count(Some(cost.latency)),
            number(cost.mhz, |mhz| format!("{mhz:.1}")),
            number(Some(core.candidate.point.rom_bits as f64), |bits| format!("{bits}")),
            count(Some(core.base.max_steps.into())),
            psnr(core.base.psnr),
            count(Some(core.moved.max_steps.into())),
            count(Some(core.guaranteed_steps())),
            number(Some(100.0 * core.candidate.point.max_abs), |error| format!("{error:.4} %")),
            word(why),
        ];
        Line { chosen, cells }
    };
    let choice = findings.choice;
    let chosen = line(findings.chosen, "chosen".to_owned(), true);
    let others = choice.runner_ups.iter().map(|one| line(&one.core, one.why.clone(), false));
    let misses = choice.misses.iter().map(|one| line(&one.core, one.why.join("; "), false));
    let tools = choice.tools.as_ref().map(|tools| format!(", by {}", tools.yosys)).unwrap_or_default();
    let figures = if choice.estimated { "estimated" } else { "measured" };
    Table::of(
        format!("The chosen core, the next ones and the nearest misses; costs {figures}{tools}"),
        &[
            ("core", "the core's name"),
            ("LUTs", "LUTs that are used up, carry chains counted"),
            ("DSPs", "DSP blocks"),
            ("BRAMs", "block RAMs"),
            ("clocks", "latency in clocks"),
            ("MHz", "median frequency"),
            ("ROM bits", "bits of all memories"),
            ("steps", "the picture's largest error in output steps"),
            ("PSNR", "of the picture, in dB; none where it is the exact one"),
            ("moved", "the largest error of the moved pictures in output steps"),
            ("any view", "the largest error in output steps that any view can have"),
            ("error", "the lobe's largest error against x^n"),
            ("why", "why it is not chosen"),
        ],
        std::iter::once(chosen).chain(others).chain(misses).collect(),
    )
}
