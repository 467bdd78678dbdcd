//! Error against cost: points that may be compared, side by side.

use std::cmp::Reverse;

use crate::explore::{Cost, Point};
use crate::plot::{Axis, BLACK, COLOURS, Chart, Curve, Shape, Spot, Spots, Style};
use crate::spec::{Material, Shininess, SpecFields};
use crate::synth::Tools;
use crate::target::Family;

/// Points that may be compared with one another: for the same family by the same versions of the tools, for the same
/// shininesses and the same cosine. All of them have a cost.
#[derive(Clone, Debug)]
pub struct Group<'a> {
    /// The family.
    pub family: Family,
    /// The tools' versions.
    pub tools: Tools,
    /// The devices that the tools were told, without repetitions; none where all is estimated.
    pub devices: Vec<&'a str>,
    /// The shininesses.
    pub shininess: &'a str,
    /// The set itself, as the specs say it.
    set: Set,
    /// F of the cosine.
    pub input_fraction: u32,
    /// The points, in their order in the results.
    pub points: Vec<&'a Point>,
}

/// The keys of a spec that say the shininesses.
type Set = (Option<Shininess>, Option<Vec<Material>>);

/// What a point's spec says of the shininesses; nothing if this version of the program does not know it.
fn set(point: &Point) -> Set {
    SpecFields::parse(&point.spec, &point.id).map(|fields| (fields.shininess, fields.material)).unwrap_or_default()
}

/// The groups of the points that have a cost: first that of the chosen point, then the largest.
#[must_use]
pub fn groups<'a>(points: &'a [Point], chosen: Option<&Point>) -> Vec<Group<'a>> {
    let mut groups: Vec<Group<'a>> = Vec::new();
    for point in points.iter().filter(|point| point.cost().is_some()) {
        let Some(tools) = point.tools() else { continue };
        let set = set(point);
        let device = point.synthesis.as_ref().map(|synthesis| synthesis.device.as_str());
        let same = |group: &&mut Group| {
            let key = (group.family, &group.tools, group.shininess, &group.set, group.input_fraction);
            key == (point.family, tools, point.shininess.as_str(), &set, point.input_fraction)
        };
        let group = match groups.iter_mut().find(same) {
            Some(group) => group,
            None => {
                groups.push(Group {
                    family: point.family,
                    tools: tools.clone(),
                    devices: Vec::new(),
                    shininess: &point.shininess,
                    set,
                    input_fraction: point.input_fraction,
                    points: Vec::new(),
                });
                groups.last_mut().expect("it was just put there")
            }
        };
        group.devices.extend(device.filter(|device| !group.devices.contains(device)));
        group.points.push(point);
    }
    groups.sort_by_key(|group| (!group.has(chosen), Reverse(group.points.len())));
    groups
}

/// How each method is drawn in all charts of a report: by its place among the methods.
#[derive(Clone, Debug)]
pub struct Palette(Vec<String>);

impl Palette {
    /// Of the points' methods: the project's own before the baselines, by name.
    #[must_use]
    pub fn of(points: &[Point]) -> Self {
        let mut methods: Vec<(bool, &str)> =
            points.iter().map(|point| (point.baseline, point.method.as_str())).collect();
        methods.sort_unstable();
        methods.dedup();
        Self(methods.into_iter().map(|(_, method)| method.to_owned()).collect())
    }

    /// A method's place.
    pub(super) fn place(&self, method: &str) -> usize {
        self.0.iter().position(|known| known == method).unwrap_or(self.0.len())
    }

    /// A method's curve.
    pub(super) fn curve(&self, method: &str, points: Vec<(f64, f64)>) -> Curve {
        const STYLES: [Style; 3] = [Style::Solid, Style::Dashed, Style::Dotted];
        let place = self.place(method);
        let (colour, style) = (COLOURS[place % COLOURS.len()], STYLES[place / COLOURS.len() % STYLES.len()]);
        Curve { label: method.to_owned(), colour, style, points }
    }

    /// A method's marks: the numbers of colours and of shapes have no common factor.
    pub(super) fn spots(&self, method: &str, filled: bool, spots: Vec<Spot>) -> Spots {
        let place = self.place(method);
        let (colour, shape) = (COLOURS[place % COLOURS.len()], Shape::PLAIN[place % Shape::PLAIN.len()]);
        Spots { label: method.to_owned(), colour, shape, filled, spots }
    }
}

/// The least and the greatest power of two about some errors; those that are 0 count as 2^-24.
pub(super) fn powers_about(errors: impl Iterator<Item = f64>) -> std::ops::Range<f64> {
    let exponents = errors.map(|error| libm::log2(error.max(crate::fixed::exp2(-24))));
    let (low, high) = exponents.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), e| (low.min(e), high.max(e)));
    let (low, high) = if low <= high { (low, high) } else { (-1.0, 0.0) };
    let low = libm::floor(low - 0.1);
    libm::exp2(low)..libm::exp2(libm::ceil(high + 0.1).max(low + 1.0))
}

/// An error as a power of two and in hundredths.
pub(super) fn error_text(error: f64) -> String {
    if error == 0.0 { "0".to_owned() } else { format!("2^{:.2} ({:.3} %)", libm::log2(error), 100.0 * error) }
}

/// What is said of a point in a chart.
fn note(point: &Point, cost: &Cost) -> String {
    let Cost { lut, ff, dsp, bram, latency, mhz, no_mhz, estimated } = cost;
    let mut text = format!("{}\nlargest error {}\n", point.name, error_text(point.max_abs));
    text += &format!("{lut} LUTs, {ff} flip-flops, {dsp} DSPs, {bram} block RAMs\n{latency} clocks");
    if let Some(mhz) = mhz {
        text += &format!(" at {mhz:.1} MHz");
    } else if let Some(why) = no_mhz {
        text += &format!(", frequency not known: {why}");
    }
    text += if *estimated { ", estimated" } else { "" };
    text + if point.baseline { "\na baseline" } else { "" }
}

impl<'a> Group<'a> {
    /// Whether a point is one of these.
    #[must_use]
    pub fn has(&self, point: Option<&Point>) -> bool {
        point.is_some_and(|wanted| self.points.iter().any(|point| point.id == wanted.id))
    }

    /// What the group is of, for headings.
    #[must_use]
    pub fn title(&self) -> String {
        format!("{}, n: {}, cosine of {} fraction bits", self.family.title, self.shininess, self.input_fraction)
    }

    /// The versions and the device, in one line.
    #[must_use]
    pub fn tools_text(&self) -> String {
        let mut parts = vec![self.tools.yosys.clone()];
        parts.extend(self.tools.nextpnr.clone());
        parts.extend(self.devices.iter().map(|&device| device.to_owned()));
        parts.join("; ")
    }

    /// A name for files.
    #[must_use]
    pub fn slug(&self) -> String {
        let keep = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
        let set: String = self.shininess.chars().map(keep).collect();
        let set: Vec<&str> = set.split('_').filter(|part| !part.is_empty()).collect();
        format!("{}_n{}_f{}", self.family.name, set.join("_"), self.input_fraction)
    }

    /// The charts by what they are of: error against LUTs, DSPs, block RAMs and latency in clocks, and in ns where the
    /// points were placed.
    #[must_use]
    pub fn charts(&self, palette: &Palette, chosen: Option<&Point>) -> Vec<(&'static str, Chart)> {
        let most = |of: fn(&Cost) -> u32| self.costs().map(|(_, cost)| of(&cost)).max().unwrap_or(1);
        let fewest = self.costs().map(|(_, cost)| cost.lut).min().unwrap_or(1);
        let luts = Axis::doubling("LUTs, carry chains counted", fewest, most(|cost| cost.lut));
        let chart = |what: &str, x: Axis, of: &dyn Fn(&Cost) -> Option<f64>| self.chart(what, x, palette, chosen, of);
        let whole = |value: u32| Some(f64::from(value));
        let mut charts = vec![
            ("lut", chart("LUTs", luts, &|cost| whole(cost.lut.max(1)))),
            ("dsp", chart("DSPs", Axis::counts("DSP blocks", most(|cost| cost.dsp)), &|cost| whole(cost.dsp))),
            ("bram", chart("block RAMs", Axis::counts("block RAMs", most(|cost| cost.bram)), &|cost| whole(cost.bram))),
            (
                "latency",
                chart("latency", Axis::whole("latency, clocks", most(|cost| cost.latency)), &|cost| {
                    whole(cost.latency)
                }),
            ),
        ];
        let ns = |cost: &Cost| cost.mhz.map(|mhz| 1e3 * f64::from(cost.latency) / mhz);
        let most = self.costs().filter_map(|(_, cost)| ns(&cost)).fold(0.0, f64::max);
        if most > 0.0 {
            let axis = Axis::linear("latency at the median frequency, ns", 0.0..1.05 * most);
            charts.push(("latency_ns", chart("latency in ns", axis, &ns)));
        }
        charts
    }

    fn costs(&self) -> impl Iterator<Item = (&'a Point, Cost)> {
        self.points.iter().filter_map(|point| point.cost().map(|cost| (*point, cost)))
    }

    /// Error against one cost.
    fn chart(
        &self,
        what: &str,
        x: Axis,
        palette: &Palette,
        chosen: Option<&Point>,
        of: &dyn Fn(&Cost) -> Option<f64>,
    ) -> Chart {
        let y = Axis::powers("largest error against x^n", powers_about(self.points.iter().map(|point| point.max_abs)));
        let placed: Vec<(&Point, Spot)> = self
            .costs()
            .filter_map(|(point, cost)| {
                let x = of(&cost)?;
                Some((point, Spot { at: (x, point.max_abs), note: note(point, &cost) }))
            })
            .collect();
        let mut curves = Vec::new();
        for (baselines, label, style) in
            [(false, "front", Style::Solid), (true, "front of the baselines", Style::Dashed)]
        {
            let spots: Vec<&Spot> =
                placed.iter().filter(|(point, _)| point.baseline == baselines).map(|(_, spot)| spot).collect();
            let points = steps(spots.iter().map(|spot| spot.at), x.range.end, &y.range);
            if !points.is_empty() {
                curves.push(Curve { label: label.to_owned(), colour: BLACK, style, points });
            }
        }
        let mut methods: Vec<(&str, bool)> =
            placed.iter().map(|(point, _)| (point.method.as_str(), point.baseline)).collect();
        methods.sort_by_key(|(method, _)| palette.place(method));
        methods.dedup();
        let of_method = |&(method, baseline): &(&str, bool)| {
            let own = placed.iter().filter(|(point, _)| (point.method.as_str(), point.baseline) == (method, baseline));
            palette.spots(method, !baseline, own.map(|(_, spot)| spot.clone()).collect())
        };
        let mut spots: Vec<Spots> = methods.iter().map(of_method).collect();
        // Baselines are told by their name too, not only by hollow marks.
        for (spots, (_, baseline)) in spots.iter_mut().zip(&methods) {
            spots.label += if *baseline { " (baseline)" } else { "" };
        }
        if let Some((_, spot)) = chosen.and_then(|chosen| placed.iter().find(|(point, _)| point.id == chosen.id)) {
            let (label, shape) = ("the chosen core".to_owned(), Shape::Star);
            let spot = Spot { note: format!("chosen: {}", spot.note), ..spot.clone() };
            spots.push(Spots { label, colour: BLACK, shape, filled: true, spots: vec![spot] });
        }
        Chart { title: format!("Error against {what}: {}", self.title()), x, y, curves, spots }
    }
}

/// The step line of the front of places (cost, error), less of both being better: from the upper edge at the cheapest
/// to the right edge at the most exact.
fn steps(places: impl Iterator<Item = (f64, f64)>, right: f64, errors: &std::ops::Range<f64>) -> Vec<(f64, f64)> {
    let mut places: Vec<(f64, f64)> = places.map(|(x, y)| (x, y.max(errors.start))).collect();
    places.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut line: Vec<(f64, f64)> = Vec::new();
    let mut best = errors.end;
    for (x, y) in places {
        if y < best {
            line.extend([(x, best), (x, y)]);
            best = y;
        }
    }
    line.extend((!line.is_empty()).then_some((right, best)));
    line
}
