//! The files of a run: the claims and the papers' figures as tables and as charts.

use super::measure::versine_at;
use super::method::{LEVEL, PaperMethod, three_point};
use super::record::HEADER;
use super::survey::{MOST, QUADRATIC_LEVEL, SurveyRow, TAIL_BANDS};
use super::{Claim, Pieces, Unit, images};
use crate::emit::package::File;
use crate::lobe::{degrees, exact, versine};
use crate::method::cubic::Cubic;
use crate::papers::TaylorSeries;
use crate::platform::error::Error;
use crate::plot::{Axis, BLACK, COLOURS, Chart, Curve, Style, png};

/// The shininesses of the table of errors against the angle; 25 is that of the papers' figures.
const SHININESSES: [f64; 5] = [5.0, 25.0, 100.0, 256.0, 1000.0];
/// The level at which that table and its charts end.
const LOWEST: f64 = 1e-3;
/// The angles of the table for each shininess.
const ANGLES: usize = 201;

/// The tables among [`files`].
pub const TABLES: [&str; 3] = ["claims.csv", "error_against_n.csv", "error_against_angle.csv"];

/// All files of a run: `claims.csv`, two tables and the charts.
///
/// # Errors
/// None for the papers' parameters.
pub fn files(rows: &[SurveyRow], claims: &[Claim]) -> Result<Vec<File>, Error> {
    let file = |path: &str, text: String| File { path: path.to_owned(), bytes: text.into_bytes() };
    let mut files = vec![
        file(TABLES[0], claims_table(claims)),
        file(TABLES[1], error_against_n(rows)),
        file(TABLES[2], error_against_angle()?),
    ];
    for (name, chart) in charts(rows)? {
        let svg = chart.svg();
        files.push(File { path: format!("{name}.png"), bytes: png(&svg) });
        files.push(file(&format!("{name}.svg"), svg));
    }
    files.extend(images::pictures()?);
    Ok(files)
}

/// A field of a table, in quotes where it needs them.
fn quoted(text: &str) -> String {
    if text.contains([',', '"']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.to_owned() }
}

fn claims_table(claims: &[Claim]) -> String {
    let mut text = format!("{HEADER},unit,claimed,verdict,source,text\n");
    for claim in claims {
        for figure in &claim.measured {
            let unit = match figure.unit {
                Unit::Percent => "percent",
                Unit::Times => "times",
                Unit::Count => "count",
                Unit::Value => "value",
                Unit::Decibel => "decibel",
            };
            let rest = [claim.claimed, &claim.verdict.to_string(), claim.source, claim.text].map(quoted).join(",");
            text += &format!("{},{},{},{unit},{rest}\n", claim.id, figure.name, figure.digits());
        }
    }
    text
}

fn error_against_n(rows: &[SurveyRow]) -> String {
    let mut text = "n,method,max_absolute,max_absolute_epicentre,max_absolute_tail,max_relative_epicentre\n".to_owned();
    for row in rows {
        for (method, errors) in PaperMethod::ALL.iter().zip(&row.errors) {
            let values = [errors.absolute, errors.absolute_epicentre, errors.absolute_tail, errors.relative_epicentre];
            let values = values.map(|value| format!("{value:.4e}")).join(",");
            text += &format!("{},{},{values}\n", row.n, method.name());
        }
    }
    text
}

fn error_against_angle() -> Result<String, Error> {
    let mut text = "n,degrees,exact,method,value,error\n".to_owned();
    for n in SHININESSES {
        let lobes: Vec<Pieces> = PaperMethod::ALL.into_iter().map(|method| method.lobe(n)).collect::<Result<_, _>>()?;
        let widest = degrees(versine_at(n, LOWEST));
        for i in 0..ANGLES {
            let angle = widest * i as f64 / (ANGLES - 1) as f64;
            let u = versine(angle);
            let power = exact(n, u);
            for (method, pieces) in PaperMethod::ALL.iter().zip(&lobes) {
                let value = pieces.lobe.at(u);
                let error = value - power;
                text += &format!("{n},{angle:.5},{power:.6e},{},{value:.6e},{error:.4e}\n", method.name());
            }
        }
    }
    Ok(text)
}

/// The methods that a chart of all of them shows, with their colours: the proposed ones solid, the comparators dashed.
const SHOWN: [(PaperMethod, usize, Style); 9] = [
    (PaperMethod::Quadratic, 0, Style::Solid),
    (PaperMethod::Cubic, 2, Style::Solid),
    (PaperMethod::CubicRational, 3, Style::Solid),
    (PaperMethod::ThreePoint, 4, Style::Solid),
    (PaperMethod::MinZero, 5, Style::Solid),
    (PaperMethod::Schlick, 0, Style::Dashed),
    (PaperMethod::Lyon(4), 2, Style::Dashed),
    (PaperMethod::CosK(4), 4, Style::Dashed),
    (PaperMethod::Taylor(TaylorSeries::Chord), 5, Style::Dashed),
];

fn curve(label: impl Into<String>, colour: usize, style: Style, points: Vec<(f64, f64)>) -> Curve {
    Curve { label: label.into(), colour: COLOURS[colour], style, points }
}

fn dashed_black(label: &str, points: Vec<(f64, f64)>) -> Curve {
    Curve { label: label.to_owned(), colour: BLACK, style: Style::Dashed, points }
}

/// The line of a claimed bound, in percent.
fn bound(label: &str, percent: f64, to: f64) -> Curve {
    dashed_black(label, vec![(1.0, percent), (to, percent)])
}

fn shininess_axis() -> Axis {
    Axis::log("shininess n", 1.0..MOST as f64)
}

fn angle_axis(widest: f64) -> Axis {
    Axis::linear("angle, degrees", 0.0..widest)
}

/// A value of every row against n, in percent.
fn against_n(rows: &[SurveyRow], f: impl Fn(&SurveyRow) -> f64) -> Vec<(f64, f64)> {
    rows.iter().map(|row| (row.n as f64, 100.0 * f(row))).collect()
}

/// A function of the versine against the angle, from the axis to an angle in degrees.
fn against_angle(widest: f64, f: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    // One for about every second column of the picture.
    const STEPS: u32 = 400;
    let angles = (0..=STEPS).map(|i| widest * f64::from(i) / f64::from(STEPS));
    angles.map(|angle| (angle, f(versine(angle)))).collect()
}

/// The charts by their files' names.
fn charts(rows: &[SurveyRow]) -> Result<Vec<(String, Chart)>, Error> {
    let mut charts = vec![
        ("quadratic_error_against_n".to_owned(), quadratic_error_against_n(rows)),
        ("quadratic_error_against_angle".to_owned(), quadratic_error_against_angle()?),
        ("cubic_error_against_n".to_owned(), cubic_error_against_n(rows)),
        ("cubic_rises".to_owned(), cubic_rises()?),
        ("lobes_n25".to_owned(), lobes()?),
        ("tail_error_against_n".to_owned(), tail_error_against_n(rows)),
    ];
    charts.push((
        "error_against_n".to_owned(),
        all_against_n("Largest absolute error over all angles", 1.0, &SHOWN, |method| {
            against_n(rows, |row| row.of(method).absolute)
        }),
    ));
    // On the epicentre the cubic is the same with and without its tail.
    let shown: Vec<_> = SHOWN.into_iter().filter(|(method, ..)| *method != PaperMethod::CubicRational).collect();
    charts.push((
        "epicentre_error_against_n".to_owned(),
        all_against_n("Largest absolute error where x^n ≥ 1/2", 0.05, &shown, |method| {
            against_n(rows, |row| row.of(method).absolute_epicentre)
        }),
    ));
    for n in [25.0, 1000.0] {
        charts.push((format!("error_against_angle_n{n}"), all_against_angle(n)?));
    }
    Ok(charts)
}

/// Q, figure 3.
fn quadratic_error_against_n(rows: &[SurveyRow]) -> Chart {
    let worst = against_n(rows, |row| row.quadratic);
    Chart::of_curves(
        "Quadratic: largest relative error where x^n ≥ 0.56",
        shininess_axis(),
        Axis::linear("largest relative error", 0.0..5.0).with_unit(" %"),
        vec![curve("quadratic", 0, Style::Solid, worst), bound("claimed, n ≤ 512", 4.0, 512.0)],
    )
}

/// Q, figure 2b; the paper does not say for which n.
fn quadratic_error_against_angle() -> Result<Chart, Error> {
    let n = 25.0;
    let (lobe, widest) = (PaperMethod::Quadratic.lobe(n)?.lobe, degrees(versine_at(n, 0.3)));
    let points = against_angle(widest, |u| 100.0 * (lobe.at(u) / exact(n, u) - 1.0));
    let end = degrees(versine_at(n, QUADRATIC_LEVEL));
    Ok(Chart::of_curves(
        "Quadratic, n = 25: relative error",
        angle_axis(widest),
        Axis::linear("relative error", -30.0..10.0).with_unit(" %"),
        vec![curve("quadratic", 0, Style::Solid, points), dashed_black("x^n = 0.56", vec![(end, -30.0), (end, 10.0)])],
    ))
}

/// C7, figure 2, and C21, figure 1.
fn cubic_error_against_n(rows: &[SurveyRow]) -> Chart {
    let relative = against_n(rows, |row| row.of(PaperMethod::Cubic).relative_epicentre);
    let absolute = against_n(rows, |row| row.of(PaperMethod::Cubic).absolute_epicentre);
    Chart::of_curves(
        "Cubic: largest error where x^n ≥ 1/2",
        shininess_axis(),
        Axis::linear("largest error", 0.0..0.8).with_unit(" %"),
        vec![
            curve("relative to x^n", 2, Style::Solid, relative),
            curve("absolute, of the peak", 0, Style::Solid, absolute),
            bound("claimed, n ≤ 256", 0.67, 256.0),
        ],
    )
}

/// C7, figures 1 and 3.
fn cubic_rises() -> Result<Chart, Error> {
    let n = 25.0;
    let raw = |cubic: Cubic| move |u: f64| (1.0 - u) * (1.0 - u * (cubic.big_a - cubic.a * u));
    let curves = vec![
        Curve {
            label: "x^25".to_owned(),
            colour: BLACK,
            style: Style::Solid,
            points: against_angle(90.0, |u| exact(n, u)),
        },
        curve("cubic", 2, Style::Solid, against_angle(90.0, raw(Cubic::new(n, LEVEL)?))),
        curve("cubic-three-point", 4, Style::Dashed, against_angle(90.0, raw(three_point(n)?))),
    ];
    Ok(Chart::of_curves("The cubics without a cut, n = 25", angle_axis(90.0), Axis::linear("lobe", 0.0..24.0), curves))
}

/// C7, figure 4, and C21, figure 3.
fn lobes() -> Result<Chart, Error> {
    let n = 25.0;
    let power = against_angle(90.0, |u| exact(n, u));
    let mut curves = vec![Curve { label: "x^25".to_owned(), colour: BLACK, style: Style::Solid, points: power }];
    for (method, colour, style) in &SHOWN[..6] {
        let lobe = method.lobe(n)?.lobe;
        curves.push(curve(method.name(), *colour, *style, against_angle(90.0, |u| lobe.at(u))));
    }
    Ok(Chart::of_curves("The lobes, n = 25", angle_axis(60.0), Axis::linear("lobe", 0.0..1.0), curves))
}

/// The tail's claims of C7 and C21.
fn tail_error_against_n(rows: &[SurveyRow]) -> Chart {
    const CLAIMED: [(f64, &str); 3] = [(1.0, "claimed 1 %"), (3.0, "claimed 3 %"), (10.0, "claimed 10 %")];
    const COLOUR: [usize; 3] = [0, 4, 2];
    let mut curves = Vec::new();
    for (band, ((high, low), (percent, label))) in TAIL_BANDS.into_iter().zip(CLAIMED).enumerate() {
        let worst = against_n(rows, |row| row.tail[band]);
        curves.push(curve(format!("{low} < x^n < {high}"), COLOUR[band], Style::Solid, worst));
        curves.push(curve(label, COLOUR[band], Style::Dashed, vec![(1.0, percent), (MOST as f64, percent)]));
    }
    Chart::of_curves(
        "Rational tail: largest relative error",
        shininess_axis(),
        Axis::linear("largest relative error", 0.0..16.0).with_unit(" %"),
        curves,
    )
}

fn all_against_n(
    title: &str,
    least: f64,
    shown: &[(PaperMethod, usize, Style)],
    points: impl Fn(PaperMethod) -> Vec<(f64, f64)>,
) -> Chart {
    let curves = shown.iter().map(|&(method, colour, style)| curve(method.name(), colour, style, points(method)));
    Chart::of_curves(
        title,
        shininess_axis(),
        Axis::log("largest error, % of the peak (where it is exact, none)", least..100.0).with_unit(" %"),
        curves.collect(),
    )
}

fn all_against_angle(n: f64) -> Result<Chart, Error> {
    let widest = degrees(versine_at(n, LOWEST));
    let mut curves = Vec::new();
    for (method, colour, style) in SHOWN {
        let lobe = method.lobe(n)?.lobe;
        let points = against_angle(widest, |u| 100.0 * (lobe.at(u) - exact(n, u)).abs());
        curves.push(curve(method.name(), colour, style, points));
    }
    Ok(Chart::of_curves(
        format!("Absolute error, n = {n}"),
        angle_axis(widest),
        Axis::log("error, % of the peak", 0.001..100.0).with_unit(" %"),
        curves,
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_comma_needs_quotes() {
        assert_eq!(quoted("C7, fig. 2"), "\"C7, fig. 2\"");
        assert_eq!(quoted("4 %"), "4 %");
    }
}
