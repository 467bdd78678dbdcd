//! What cores compute: error against the shininess, error against the angle, and the lobes themselves.

use std::collections::BTreeSet;

use rayon::prelude::*;

use super::trade::{Group, Palette, powers_about};
use crate::core::{Design, LobeDesign};
use crate::datapath::evaluate::Evaluator;
use crate::explore::Point;
use crate::fixed::exp2;
use crate::lobe::{degrees, exact, versine};
use crate::platform::error::Error;
use crate::plot::{Axis, BLACK, Chart, Curve, Style};
use crate::spec::{Shininess, SpecFields};

/// The shininesses that charts against the angle look for in the set.
const WANTED: [f64; 3] = [10.0, 100.0, 1000.0];
/// The level of the power at which those charts end.
const LOWEST: f64 = 1e-3;
/// Angles of a chart: one for about every second column of the picture.
const ANGLES: u32 = 400;
/// The error shown at an angle is the largest from as many angles before it to as many behind, so that the curve shows
/// what it may be there and not where it happens to be 0,
const AROUND: usize = 3;
/// at about as many codes.
const SAMPLES: i64 = 48;
/// The most shininesses of the chart against the shininess, but for those at which a core is worst.
const MOST_ROWS: usize = 256;
/// The most inputs of one core.
const MOST_INPUTS: u64 = 1 << 26;

/// A core that stands for its method, and what was measured of it.
#[derive(Debug)]
pub struct Measured<'a> {
    /// The core's point.
    pub point: &'a Point,
    /// The core.
    design: Design,
    /// The shininesses looked at, rising, and the largest error over the cosines.
    by_shininess: Vec<(f64, f64)>,
}

/// A core's result at an angle.
#[derive(Clone, Copy, Debug)]
struct Seen {
    /// In degrees.
    angle: f64,
    /// The power there.
    power: f64,
    /// What the core computes.
    value: f64,
    /// The largest error about the angle.
    error: f64,
}

/// The cores that stand for the methods of a group: of each method the one with the least error; and the chosen one, if
/// it is in the group.
#[must_use]
pub fn representatives<'a>(group: &Group<'a>, palette: &Palette, chosen: Option<&Point>) -> Vec<&'a Point> {
    let mut best: Vec<&Point> = Vec::new();
    for &point in &group.points {
        match best.iter_mut().find(|known| known.method == point.method) {
            Some(known) if point.max_abs < known.max_abs => *known = point,
            Some(_) => {}
            None => best.push(point),
        }
    }
    best.sort_by_key(|point| palette.place(&point.method));
    let others = group.points.iter().copied().filter(|point| chosen.is_some_and(|chosen| chosen.id == point.id));
    let others: Vec<&Point> = others.filter(|point| best.iter().all(|known| known.id != point.id)).collect();
    best.extend(others);
    best
}

/// The shininesses at which cores of one group are measured, by their places in the set: all, or, of more than
/// [`MOST_ROWS`], so many that lie evenly on a logarithmic axis, and those at which a core is worst.
fn places(set: &Shininess, points: &[&Point]) -> Vec<usize> {
    let rows = set.rows();
    if rows <= MOST_ROWS {
        return (0..rows).collect();
    }
    let step = libm::log(rows as f64) / (MOST_ROWS - 1) as f64;
    let even = (0..MOST_ROWS).map(|place| (libm::round(libm::exp(step * place as f64)) as usize).clamp(1, rows) - 1);
    let worst = (0..rows).filter(|&row| points.iter().any(|point| point.worst_n == set.value(row)));
    even.chain(worst).collect::<BTreeSet<_>>().into_iter().collect()
}

/// How many shininesses of how many cores [`measure`] looks at.
#[must_use]
pub fn work(points: &[&Point]) -> u64 {
    let spec = points.first().and_then(|point| SpecFields::parse(&point.spec, &point.name).ok()?.resolve().ok());
    spec.map_or(0, |spec| (places(&spec.block.lobe().interface.shininess, points).len() * points.len()) as u64)
}

/// Builds the cores of points of one group, which have their shininesses and their cosines in common, and measures them
/// at every shininess, or at some of many; `done` is called after each shininess of each core.
///
/// Every code of the cosine in [0, 1] is taken, or every 2nd, 3rd, ... where that would be more than 2^26 inputs of a
/// core.
///
/// # Errors
/// A point whose spec is none, or of which no core can be built.
pub fn measure<'a>(points: &[&'a Point], done: &(dyn Fn() + Sync)) -> Result<Vec<Measured<'a>>, Error> {
    let build = |point: &&'a Point| Design::new(SpecFields::parse(&point.spec, &point.name)?.resolve()?);
    let designs: Vec<Design> = points.par_iter().map(build).collect::<Result<_, _>>()?;
    let errors = by_shininess(points, &designs, done);
    let measured = |((&point, design), mut by_shininess): ((&&'a Point, Design), Vec<(f64, f64)>)| {
        by_shininess.sort_by(|a, b| a.0.total_cmp(&b.0));
        Measured { point, design, by_shininess }
    };
    Ok(points.iter().zip(designs).zip(errors).map(measured).collect())
}

/// Of each core the shininesses and the largest error of the bit-exact arithmetic against the power. The powers take
/// longer than the arithmetic, so that they are computed once for all cores.
fn by_shininess(points: &[&Point], designs: &[Design], done: &(dyn Fn() + Sync)) -> Vec<Vec<(f64, f64)>> {
    let lobes: Vec<LobeDesign> = designs.iter().map(Design::lobe).collect();
    let Some(&LobeDesign { interface, .. }) = lobes.first() else { return Vec::new() };
    let rows = interface.shininess.rows();
    let places = places(&interface.shininess, points);
    let codes = (1u64 << interface.input_fraction) + 1;
    let step = (codes * rows as u64).div_ceil(MOST_INPUTS) as usize;
    let one = exp2(interface.input_fraction as i32);
    let logs: Vec<f64> = (0..codes).step_by(step).map(|versine| libm::log1p(-(versine as f64 / one))).collect();
    let evaluators: Vec<_> = designs.iter().map(Design::evaluator).collect();
    let at = |&row: &usize| -> Vec<(f64, f64)> {
        let n = interface.shininess.value(row);
        // Below e^-40 the power is nothing beside an ulp.
        let power = |log: &f64| if n * log < -40.0 { 0.0 } else { libm::exp(n * log) };
        let powers: Vec<f64> = logs.iter().map(power).collect();
        let mut outputs = vec![0u32; powers.len()];
        let largest = |(lobe, evaluator): (&LobeDesign, &Evaluator)| {
            // Versine codes upwards are operand codes from this one on, up or down.
            let first = lobe.operand_of_versine(0);
            let stride = (lobe.operand_of_versine(1) - first) * step as i64;
            evaluator.evaluate(lobe.interface.shininess.index_of_row(row), first, stride, &mut outputs);
            let scale = exp2(-(lobe.interface.output_fraction as i32));
            let error = |(&output, power): (&u32, &f64)| (f64::from(output) * scale - power).abs();
            let largest = outputs.iter().zip(&powers).map(error).fold(0.0, f64::max);
            done();
            (n, largest)
        };
        lobes.iter().zip(&evaluators).map(largest).collect()
    };
    let by_row: Vec<Vec<(f64, f64)>> = places.par_iter().map(at).collect();
    (0..designs.len()).map(|core| by_row.iter().map(|row| row[core]).collect()).collect()
}

impl Measured<'_> {
    /// The place in the set of the shininess nearest to a wanted one.
    fn nearest(&self, wanted: f64) -> usize {
        let set = &self.design.lobe().interface.shininess;
        let distance = |&row: &usize| libm::fabs(libm::log(set.value(row) / wanted));
        (0..set.rows()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0)
    }

    /// The results from the angle 0 to the widest, at angles of codes of the operand.
    fn against_angle(&self, row: usize, widest: f64) -> Vec<Seen> {
        let lobe = self.design.lobe();
        let (n, index) = (lobe.interface.shininess.value(row), lobe.interface.shininess.index_of_row(row));
        let one = exp2(lobe.interface.input_fraction as i32);
        let wanted = |step| versine(widest * f64::from(step) / f64::from(ANGLES));
        let mut codes: Vec<i64> = (0..=ANGLES).map(|step| libm::round(wanted(step) * one) as i64).collect();
        codes.dedup();
        let scale = exp2(-(lobe.interface.output_fraction as i32));
        let model = lobe.model();
        let at = |code: i64| {
            let operand = lobe.operand_of_versine(code);
            let u = lobe.versine(operand);
            (u, exact(n, u), f64::from(model.evaluate(index, operand)) * scale)
        };
        let seen = |place: usize| {
            let (u, power, value) = at(codes[place]);
            let (first, last) = (codes[place.saturating_sub(AROUND)], codes[(place + AROUND).min(codes.len() - 1)]);
            let stride = ((last - first) / SAMPLES).max(1) as usize;
            let around = (first..=last).step_by(stride).map(at).map(|(_, power, value)| (value - power).abs());
            Seen { angle: degrees(u), power, value, error: around.fold(0.0, f64::max) }
        };
        (0..codes.len()).map(seen).collect()
    }

    fn curve(&self, palette: &Palette, chosen: Option<&Point>, points: Vec<(f64, f64)>) -> Curve {
        match chosen.filter(|chosen| chosen.id == self.point.id) {
            Some(_) => {
                Curve { label: format!("chosen: {}", self.point.name), colour: BLACK, style: Style::Dashed, points }
            }
            None => palette.curve(&self.point.method, points),
        }
    }
}

/// The charts of measured cores by name: error against the shininess, and for three shininesses error against the angle
/// and the lobes.
#[must_use]
pub fn charts(cores: &[Measured], palette: &Palette, chosen: Option<&Point>) -> Vec<(String, Chart)> {
    let Some(first) = cores.first() else { return Vec::new() };
    let mut charts = Vec::new();
    let (least, most) = (first.by_shininess[0].0, first.by_shininess[first.by_shininess.len() - 1].0);
    if least < most {
        let errors = cores.iter().flat_map(|core| &core.by_shininess).map(|&(_, error)| error);
        let y = powers_about(errors.map(|error| error.max(exp2(-20))));
        let curve = |core: &Measured| {
            let points = core.by_shininess.iter().map(|&(n, error)| (n, error.max(y.start))).collect();
            core.curve(palette, chosen, points)
        };
        let curves = cores.iter().map(curve).collect();
        let x = if most >= 10.0 * least { Axis::log } else { Axis::linear };
        charts.push((
            "error_against_n".to_owned(),
            Chart::of_curves(
                "Largest error of each method's most exact core",
                x("shininess n".to_owned(), least..most),
                Axis::powers("largest error against x^n", y),
                curves,
            ),
        ));
    }
    let mut rows: Vec<usize> = WANTED.iter().map(|&wanted| first.nearest(wanted)).collect();
    rows.dedup();
    for row in rows {
        let n = first.design.lobe().interface.shininess.value(row);
        let widest = degrees(-libm::expm1(libm::log(LOWEST) / n));
        let seen: Vec<Vec<Seen>> = cores.par_iter().map(|core| core.against_angle(core.nearest(n), widest)).collect();
        let lowest = exp2(-18);
        let error = |seen: &Seen| seen.error.max(lowest);
        let most = seen.iter().flatten().map(error).fold(lowest, f64::max);
        let each = |of: &dyn Fn(&Seen) -> f64| -> Vec<Curve> {
            let points = |seen: &[Seen]| seen.iter().map(|seen| (seen.angle, of(seen))).collect();
            cores.iter().zip(&seen).map(|(core, seen)| core.curve(palette, chosen, points(seen))).collect()
        };
        let angle = || Axis::linear("angle between N and H, degrees", 0.0..widest);
        charts.push((
            format!("error_against_angle_n{n}"),
            Chart::of_curves(
                format!("Largest error about the angle, n = {n}"),
                angle(),
                Axis::powers("error against x^n", lowest..powers_about([most].into_iter()).end),
                each(&error),
            ),
        ));
        let power = seen[0].iter().map(|seen| (seen.angle, seen.power)).collect();
        let mut curves = vec![Curve { label: format!("x^{n}"), colour: BLACK, style: Style::Solid, points: power }];
        curves.extend(each(&|seen| seen.value));
        charts.push((
            format!("lobes_n{n}"),
            Chart::of_curves(format!("The lobes, n = {n}"), angle(), Axis::linear("lobe", 0.0..1.05), curves),
        ));
    }
    charts
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::explore::sweep::Core;
    use crate::target::Family;

    fn point(set: &str, worst_n: f64) -> Point {
        let text = format!("method = 'schlick'\nshininess = '{set}'");
        let spec = SpecFields::parse(&text, "test").and_then(SpecFields::resolve).unwrap();
        Point { worst_n, ..Point::unmeasured(&Core::new(spec, Family::Ecp5)) }
    }

    #[test]
    fn of_many_shininesses_some_are_looked_at_and_the_worst_among_them() {
        let points = [point("1..=1000", 777.0), point("1..=1000", 999.0)];
        let points: Vec<&Point> = points.iter().collect();
        let places = places(&Shininess::Range(1, 1000), &points);
        assert!(places.is_sorted_by(|a, b| a < b) && places.len() <= MOST_ROWS + 2, "{places:?}");
        assert_eq!((places[..20].to_vec(), places.last()), ((0..20).collect(), Some(&999)));
        assert!(places.contains(&776) && places.contains(&998));
        // No gap of more than 3 %, where a chart of a thousand columns has 0.7 % a column.
        assert!(places.windows(2).all(|pair| (pair[1] + 1) as f64 <= 1.03 * (pair[0] + 2) as f64), "{places:?}");
        assert_eq!(work(&points), 2 * places.len() as u64);
        assert_eq!(super::places(&Shininess::Range(5, 260), &points), (0..256).collect::<Vec<_>>());
        assert_eq!(work(&[&point("4,2.5", 4.0)]), 2);
        assert_eq!(work(&[]), 0);
    }
}
