//! The page: one HTML file that needs nothing else.

use askama::Template;

use super::lobes::{self, Measured};
use super::material::MaterialPart;
use super::scene::ScenePart;
use super::speed::{Speed, time};
use super::trade::{Group, Palette, error_text, groups};
use crate::emit::package::File;
use crate::explore::{Objective, Point, pareto};
use crate::platform::error::Error;
use crate::plot::{Chart, png};

/// Everything that a report shows, measured and drawn.
#[derive(Debug)]
pub struct Report<'a> {
    points: &'a [Point],
    chosen: Option<&'a Point>,
    speed: &'a Speed,
    groups: Vec<Group<'a>>,
    /// The charts of each group, and those of the lobes, by the names of their files.
    trade: Vec<Vec<(String, Chart)>>,
    lobes: Vec<(String, Chart)>,
    /// The cores that the charts of the lobes show.
    shown: Vec<&'a Point>,
    scenes: Vec<ScenePart>,
    materials: Vec<MaterialPart>,
}

impl<'a> Report<'a> {
    /// The number of calls of `done` that [`Report::new`] makes, as far as the points tell.
    #[must_use]
    pub fn work(points: &[Point], chosen: Option<&Point>) -> u64 {
        let (groups, palette) = (groups(points, chosen), Palette::of(points));
        let shown = groups.first().map(|group| lobes::representatives(group, &palette, chosen)).unwrap_or_default();
        lobes::work(&shown)
    }

    /// Measures the cores that stand for the methods and draws all charts; the chosen core is marked. `done` is called
    /// after each shininess of each measured core.
    ///
    /// # Errors
    /// A point whose spec is none, or of which no core can be built.
    pub fn new(
        points: &'a [Point],
        chosen: Option<&'a Point>,
        speed: &'a Speed,
        done: &(dyn Fn() + Sync),
    ) -> Result<Self, Error> {
        let (groups, palette) = (groups(points, chosen), Palette::of(points));
        let shown = groups.first().map(|group| lobes::representatives(group, &palette, chosen)).unwrap_or_default();
        let measured: Vec<Measured> = lobes::measure(&shown, done)?;
        let mut slugs: Vec<String> = Vec::new();
        for group in &groups {
            // Groups may differ in their tools' versions only.
            let slug = group.slug();
            let same = slugs.iter().filter(|known| **known == slug || known.starts_with(&format!("{slug}_v"))).count();
            slugs.push(if same == 0 { slug } else { format!("{slug}_v{}", same + 1) });
        }
        let trade = groups.iter().zip(slugs).map(|(group, slug)| {
            let charts = group.charts(&palette, chosen).into_iter();
            charts.map(|(what, chart)| (format!("trade_{slug}_{what}"), chart)).collect()
        });
        Ok(Self {
            points,
            chosen,
            speed,
            trade: trade.collect(),
            lobes: lobes::charts(&measured, &palette, chosen),
            groups,
            shown,
            scenes: Vec::new(),
            materials: Vec::new(),
        })
    }

    /// The report with these scenes, which stand first, and these materials, which stand behind them.
    #[must_use]
    pub fn with(self, scenes: Vec<ScenePart>, materials: Vec<MaterialPart>) -> Self {
        Self { scenes, materials, ..self }
    }

    /// All charts as files, each as SVG and as PNG.
    #[must_use]
    pub fn plots(&self) -> Vec<File> {
        let mut files = Vec::new();
        let of_scenes = self.scenes.iter().flat_map(|scene| &scene.charts);
        let of_materials = self.materials.iter().map(|material| &material.chart);
        for (name, chart) in self.trade.iter().flatten().chain(&self.lobes).chain(of_scenes).chain(of_materials) {
            let svg = chart.svg();
            files.push(File { path: format!("{name}.png"), bytes: png(&svg) });
            files.push(File { path: format!("{name}.svg"), bytes: svg.into_bytes() });
        }
        files
    }

    /// The page.
    ///
    /// # Panics
    /// Never: writing to memory cannot fail.
    #[must_use]
    pub fn html(&self) -> String {
        let figures = |charts: &[(String, Chart)]| charts.iter().map(|(name, chart)| Figure::of(name, chart)).collect();
        let sections = self.groups.iter().zip(&self.trade).map(|(group, charts)| Section {
            title: group.title(),
            tools: group.tools_text(),
            figures: figures(charts),
            table: table(&group.points, self.chosen),
        });
        let without: Vec<&Point> =
            self.points.iter().filter(|point| point.cost().is_none() || point.tools().is_none()).collect();
        let page = Page {
            version: env!("CARGO_PKG_VERSION"),
            points: self.points.len(),
            scenes: &self.scenes,
            materials: &self.materials,
            sections: sections.collect(),
            chosen: self.chosen.map(Chosen::of),
            lobes: figures(&self.lobes),
            shown: self.shown.iter().map(|point| format!("{} ({})", point.name, error_text(point.max_abs))).collect(),
            group: self.groups.first().map(Group::title).unwrap_or_default(),
            machine: self.speed.rows.first().map(|row| row.machine.clone()).unwrap_or_default(),
            speed: speed(self.speed),
            without: (!without.is_empty()).then(|| table(&without, None)),
        };
        page.render().expect("writing to memory")
    }
}

#[derive(Template)]
#[template(path = "report/report.html")]
struct Page<'a> {
    version: &'static str,
    points: usize,
    scenes: &'a [ScenePart],
    materials: &'a [MaterialPart],
    sections: Vec<Section>,
    chosen: Option<Chosen>,
    lobes: Vec<Figure>,
    /// The cores of these charts.
    shown: Vec<String>,
    /// The group that they are of.
    group: String,
    machine: String,
    speed: Vec<Table>,
    /// The points without a cost.
    without: Option<Table>,
}

/// A group of points.
struct Section {
    title: String,
    tools: String,
    figures: Vec<Figure>,
    table: Table,
}

/// A chart in the page.
pub(super) struct Figure {
    name: String,
    title: String,
    svg: String,
}

impl Figure {
    pub(super) fn of(name: &str, chart: &Chart) -> Self {
        // In HTML an SVG needs no name space.
        let svg = chart.svg().replacen(" xmlns=\"http://www.w3.org/2000/svg\"", "", 1);
        Self { name: name.to_owned(), title: chart.title.clone(), svg }
    }
}

/// The chosen core.
struct Chosen {
    name: String,
    family: &'static str,
    error: String,
    cost: String,
    spec: String,
}

impl Chosen {
    fn of(point: &Point) -> Self {
        let cost = |cost: crate::explore::Cost| {
            let mhz = cost.mhz.map(|mhz| format!(", {mhz:.1} MHz")).unwrap_or_default();
            let (lut, dsp, bram, latency) = (cost.lut, cost.dsp, cost.bram, cost.latency);
            format!("{lut} LUTs, {dsp} DSPs, {bram} block RAMs, {latency} clocks{mhz}")
        };
        Self {
            name: point.name.clone(),
            family: point.family.description().title,
            error: error_text(point.max_abs),
            cost: point.cost().map(cost).unwrap_or_default(),
            spec: point.spec.clone(),
        }
    }
}

/// A table that sorts.
#[derive(Debug)]
pub(super) struct Table {
    pub(super) title: String,
    pub(super) heads: Vec<Head>,
    pub(super) rows: Vec<Line>,
}

impl Table {
    /// A table with these columns, each by its name and what it means.
    pub(super) fn of(title: String, heads: &[(&'static str, &'static str)], rows: Vec<Line>) -> Self {
        Self { title, heads: heads.iter().map(|&(name, meaning)| Head { name, meaning }).collect(), rows }
    }
}

/// A column.
#[derive(Debug)]
pub(super) struct Head {
    name: &'static str,
    /// What it is, for who points at it.
    meaning: &'static str,
}

/// A line of a table.
#[derive(Debug)]
pub(super) struct Line {
    pub(super) chosen: bool,
    pub(super) cells: Vec<Cell>,
}

/// A field: its text, and the number by which it is sorted, or nothing where it is sorted by its text. A number that is
/// missing is the empty text.
#[derive(Debug)]
pub(super) struct Cell {
    text: String,
    key: Option<String>,
}

pub(super) fn word(text: impl Into<String>) -> Cell {
    Cell { text: text.into(), key: None }
}

pub(super) fn number(value: Option<f64>, text: impl Fn(f64) -> String) -> Cell {
    Cell {
        text: value.map(text).unwrap_or_default(),
        key: Some(value.map(|value| format!("{value:e}")).unwrap_or_default()),
    }
}

pub(super) fn count(value: Option<u32>) -> Cell {
    number(value.map(f64::from), |value| format!("{value}"))
}

/// The columns of the table of points, and what they mean.
const POINT_HEADS: [(&str, &str); 28] = [
    ("core", "the core's name"),
    ("front", "whether no other of these cores beats it in error, LUTs, DSPs, block RAMs and clocks together"),
    ("method", "the method; a baseline is one to compare with"),
    ("coefficients", "where the coefficients come from"),
    ("variant", "other settings that differ from the method's defaults"),
    ("G", "fraction bits of the output"),
    ("pipeline", "pipeline, as it is written in a spec"),
    ("error", "largest error against x^n, in hundredths of the peak"),
    ("log2 error", "the same as an exponent of two"),
    ("LUTs", "LUTs that are used up, carry chains counted"),
    ("FFs", "flip-flops"),
    ("DSPs", "DSP blocks"),
    ("BRAMs", "block RAMs"),
    ("clocks", "latency in clocks"),
    ("ns", "latency in ns at the median frequency"),
    ("MHz min", "least frequency over the seeds"),
    ("MHz", "median frequency over the seeds"),
    ("MHz max", "greatest frequency over the seeds"),
    ("M/s", "millions of results per second at the median frequency"),
    ("relative", "largest error relative to x^n, where x^n is at least 1/2"),
    ("RMS", "root of the mean square of the error"),
    ("worst n", "shininess of the largest error"),
    ("worst x", "cosine of the largest error"),
    ("bound", "proved distance from the real-valued method"),
    ("ROM bits", "bits of all memories"),
    ("figures", "whether the cost is measured or estimated"),
    ("checked", "over which inputs the error was measured"),
    ("failure", "why figures are missing"),
];

/// All figures of some points.
fn table(points: &[&Point], chosen: Option<&Point>) -> Table {
    let front = pareto(points, &Objective::ALL);
    let line = |(place, point): (usize, &&Point)| {
        let cost = point.cost();
        let timing = point.synthesis.as_ref().and_then(|synthesis| synthesis.timing.as_ref());
        let known = |value: f64| point.failure.is_none().then_some(value);
        let percent = |value: f64| number(known(value), |value| format!("{:.4} %", 100.0 * value));
        let mhz = |value: Option<f64>| number(value, |value| format!("{value:.1}"));
        let clocks = cost.map_or(point.latency, |cost| cost.latency);
        let ns = cost.and_then(|cost| cost.mhz).map(|mhz| 1e3 * f64::from(clocks) / mhz);
        let rate = point.synthesis.as_ref().and_then(|synthesis| synthesis.results_per_second);
        let figures = match cost {
            Some(cost) if cost.estimated => "estimated",
            Some(_) => "measured",
            None => "none",
        };
        let cells = vec![
            word(&point.name),
            word(if front.contains(&place) { "yes" } else { "" }),
            word(if point.baseline { format!("{} (baseline)", point.method) } else { point.method.clone() }),
            word(&point.coefficients),
            word(&point.variant),
            count(Some(point.output_fraction)),
            word(&point.pipeline),
            percent(point.max_abs),
            number(known(point.max_abs).filter(|&error| error > 0.0).map(libm::log2), |value| format!("{value:.2}")),
            count(cost.map(|cost| cost.lut)),
            count(cost.map(|cost| cost.ff)),
            count(cost.map(|cost| cost.dsp)),
            count(cost.map(|cost| cost.bram)),
            count(Some(clocks)),
            number(ns, |value| format!("{value:.1}")),
            mhz(timing.map(|timing| timing.min_mhz)),
            mhz(cost.and_then(|cost| cost.mhz)),
            mhz(timing.map(|timing| timing.max_mhz)),
            mhz(rate.map(|rate| rate / 1e6)),
            percent(point.max_rel),
            percent(point.rms),
            number(known(point.worst_n), |value| format!("{value}")),
            number(known(point.worst_x), |value| format!("{value:.6}")),
            percent(point.bound),
            number(known(point.rom_bits as f64), |value| format!("{value}")),
            word(figures),
            word(&point.checked),
            word(point.failure.as_deref().unwrap_or_default()),
        ];
        Line { chosen: chosen.is_some_and(|chosen| chosen.id == point.id), cells }
    };
    Table::of(format!("{} points", points.len()), &POINT_HEADS, points.iter().enumerate().map(line).collect())
}

/// The groups of the table of speeds.
fn speed(speed: &Speed) -> Vec<Table> {
    const HEADS: [(&str, &str); 5] = [
        ("what", "what ran"),
        ("time", "median of the rounds"),
        ("from", "least of the rounds"),
        ("to", "greatest of the rounds"),
        ("times as fast", "median of the rounds' own ratios to the group's first line"),
    ];
    let table = |rows: &[super::speed::SpeedRow]| {
        let line = |row: &super::speed::SpeedRow| {
            let name = if row.tool.is_empty() { row.name.clone() } else { format!("{} ({})", row.name, row.tool) };
            let shown = |value: f64| number(Some(value), time);
            let short = |value: f64| format!("{}", format!("{value:.2e}").parse::<f64>().unwrap_or(value));
            let times = number(Some(row.times_as_fast), short);
            Line {
                chosen: false,
                cells: vec![word(name), shown(row.ns_median), shown(row.ns_least), shown(row.ns_most), times],
            }
        };
        let title = format!("{}; times as fast as {}", rows[0].group, rows[0].reference);
        Table::of(title, &HEADS, rows.iter().map(line).collect())
    };
    speed.rows.chunk_by(|a, b| a.group == b.group).map(table).collect()
}
