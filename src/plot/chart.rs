//! Charts of curves and of single points.

use std::fmt::Write;
use std::ops::Range;

use plotters::coord::ranged1d::{AsRangedCoord, ValueFormatter};
use plotters::element::DashedPathElement;
use plotters::prelude::*;

/// Colours that people who see red and green alike can tell apart (Okabe and Ito).
pub const COLOURS: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(86, 180, 233),
    RGBColor(213, 94, 0),
    RGBColor(230, 159, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(120, 94, 40),
];
/// For what the coloured curves are compared with.
pub const BLACK: RGBColor = RGBColor(0, 0, 0);

/// How an axis is divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Evenly.
    Linear,
    /// By decades; the range is above 0.
    Log,
    /// By powers of two, which the marks name as such; the range is above 0.
    Powers,
    /// By powers of two, with their values at the marks; the range is above 0.
    Doubling,
    /// Evenly, with marks at whole numbers only.
    Whole,
    /// By square roots, so that counts from 0 up to many have room; the marks stand at the squares.
    Root,
}

/// An axis.
#[derive(Clone, Debug)]
pub struct Axis {
    /// What it shows, with the unit.
    pub label: String,
    /// From where to where.
    pub range: Range<f64>,
    /// How it is divided.
    pub scale: Scale,
    /// What follows the number at each mark, such as " %".
    pub unit: &'static str,
}

impl Axis {
    /// An evenly divided axis without a unit at its marks.
    #[must_use]
    pub fn linear(label: impl Into<String>, range: Range<f64>) -> Self {
        Self { label: label.into(), range, scale: Scale::Linear, unit: "" }
    }

    /// An axis divided by decades without a unit at its marks.
    #[must_use]
    pub fn log(label: impl Into<String>, range: Range<f64>) -> Self {
        Self { label: label.into(), range, scale: Scale::Log, unit: "" }
    }

    /// The same with a unit at its marks.
    #[must_use]
    pub fn with_unit(self, unit: &'static str) -> Self {
        Self { unit, ..self }
    }

    /// An axis divided by powers of two.
    #[must_use]
    pub fn powers(label: impl Into<String>, range: Range<f64>) -> Self {
        Self { label: label.into(), range, scale: Scale::Powers, unit: "" }
    }

    /// An axis of counts above 0, from the power of two below the least to that above the largest.
    #[must_use]
    pub fn doubling(label: impl Into<String>, least: u32, largest: u32) -> Self {
        let (low, high) = (libm::log2(f64::from(least.max(1)) * 0.95), libm::log2(f64::from(largest.max(1)) * 1.05));
        let range = libm::exp2(libm::floor(low))..libm::exp2(libm::ceil(high));
        Self { label: label.into(), range, scale: Scale::Doubling, unit: "" }
    }

    /// An axis of counts from 0 up to the largest: evenly divided up to 12, by square roots if there are more; with
    /// room for a mark at 0.
    #[must_use]
    pub fn counts(label: impl Into<String>, largest: u32) -> Self {
        let most = f64::from(largest.max(1));
        let (scale, range) =
            if largest > 12 { (Scale::Root, -0.03..1.1 * most) } else { (Scale::Whole, -0.04 * most..1.06 * most) };
        Self { label: label.into(), range, scale, unit: "" }
    }

    /// An axis of whole numbers from 0 up to the largest.
    #[must_use]
    pub fn whole(label: impl Into<String>, largest: u32) -> Self {
        Self { label: label.into(), range: 0.0..1.06 * f64::from(largest.max(1)), scale: Scale::Whole, unit: "" }
    }

    /// The same axis with a range that can be drawn, however wide, narrow or empty its own is: the drawing library
    /// counts marks for ever where a step between them is lost in rounding.
    #[must_use]
    fn drawable(&self) -> Self {
        // Of the larger end, or of 1.
        const NARROWEST: f64 = 1e-9;
        let positive = matches!(self.scale, Scale::Log | Scale::Powers | Scale::Doubling);
        // The quotient of the ends of a logarithmic axis, and the difference of the others', must be finite.
        let farthest: f64 = if positive { 1e150 } else { 1e300 };
        let least: f64 = if positive { 1.0 / farthest } else { -farthest };
        let kept = |end: f64| if end.is_nan() { least.max(0.0) } else { end.clamp(least, farthest) };
        let Range { start, end } = self.range;
        let (low, high) = (kept(start.min(end)), kept(start.max(end)));
        let narrow =
            if positive { high < 1.001 * low } else { high - low < NARROWEST * low.abs().max(high.abs()).max(1.0) };
        let range = match (narrow, positive) {
            (false, _) => low..high,
            (true, true) => kept(0.5 * low)..kept(2.0 * high),
            (true, false) => {
                let margin = NARROWEST * low.abs().max(high.abs()).max(1.0);
                // At the far end there is room on one side only.
                kept(low - margin)..kept(high + margin)
            }
        };
        Self { range, ..self.clone() }
    }

    /// Where a value stands on an axis that is drawn as an even one.
    fn place(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Linear | Scale::Log | Scale::Whole => value,
            Scale::Powers | Scale::Doubling => libm::log2(value),
            Scale::Root => value.abs().sqrt().copysign(value),
        }
    }

    /// The range of [`Axis::place`].
    fn placed(&self) -> Range<f64> {
        self.place(self.range.start)..self.place(self.range.end)
    }

    /// The most marks that it should have, where that is not a matter of room alone.
    fn marks(&self) -> Option<usize> {
        let Range { start, end } = self.placed();
        // Where each whole number has a mark.
        (!matches!(self.scale, Scale::Linear | Scale::Log)).then(|| ((end - start) as usize).min(18) + 2)
    }

    /// The text of the mark at a place, without the rounding of the place.
    fn mark(&self, place: f64) -> String {
        let short: f64 = format!("{place:.6e}").parse().unwrap_or(place);
        let whole = libm::round(short);
        let text = match self.scale {
            Scale::Powers | Scale::Doubling | Scale::Root | Scale::Whole if (short - whole).abs() > 1e-6 => {
                return String::new();
            }
            Scale::Powers => format!("2{}", superscript(whole as i32)),
            Scale::Doubling => format!("{}", libm::exp2(whole)),
            Scale::Root => format!("{}", whole * whole),
            Scale::Whole => format!("{}", whole + 0.0),
            // A sum of steps may miss 0 by its rounding.
            Scale::Linear if short.abs() < 1e-9 * (self.range.end - self.range.start).abs() => "0".to_owned(),
            Scale::Linear | Scale::Log => format!("{short}"),
        };
        text + self.unit
    }
}

/// A number in raised figures.
fn superscript(number: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raised = |c: char| c.to_digit(10).map_or('⁻', |digit| DIGITS[digit as usize]);
    number.to_string().chars().map(raised).collect()
}

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// A line.
    Solid,
    /// A broken line.
    Dashed,
    /// A line of dots.
    Dotted,
}

impl Style {
    /// The lengths of what is drawn and what is left out, where it is not all drawn.
    fn dashes(self) -> Option<(u32, u32)> {
        match self {
            Self::Solid => None,
            Self::Dashed => Some((7, 4)),
            Self::Dotted => Some((2, 3)),
        }
    }
}

/// A curve and its name in the legend.
#[derive(Clone, Debug)]
pub struct Curve {
    /// The name.
    pub label: String,
    /// The colour.
    pub colour: RGBColor,
    /// How the line is drawn.
    pub style: Style,
    /// The points, in order; those outside the chart's ranges are left out and interrupt the line.
    pub points: Vec<(f64, f64)>,
}

/// The outline of a mark at a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A circle.
    Circle,
    /// A square on its side.
    Square,
    /// A square on its corner.
    Diamond,
    /// A triangle on its side.
    Triangle,
    /// A triangle on its corner.
    Wedge,
    /// A star of five points, twice as large as the others.
    Star,
}

impl Shape {
    /// Those for points among others.
    pub const PLAIN: [Self; 5] = [Self::Circle, Self::Square, Self::Diamond, Self::Triangle, Self::Wedge];

    /// Its outline about a place, as the `d` of an SVG path.
    fn path(self, (x, y): (i32, i32)) -> String {
        let corners: &[(f64, f64)] = match self {
            Self::Circle => return format!("M{},{y}a4.5,4.5 0 1,0 9,0a4.5,4.5 0 1,0 -9,0Z", f64::from(x) - 4.5),
            Self::Square => &[(-4.0, -4.0), (4.0, -4.0), (4.0, 4.0), (-4.0, 4.0)],
            Self::Diamond => &[(0.0, -5.5), (5.5, 0.0), (0.0, 5.5), (-5.5, 0.0)],
            Self::Triangle => &[(0.0, -5.5), (5.0, 4.0), (-5.0, 4.0)],
            Self::Wedge => &[(0.0, 5.5), (5.0, -4.0), (-5.0, -4.0)],
            Self::Star => &[
                (0.0, -11.0),
                (2.7, -3.7),
                (10.5, -3.4),
                (4.4, 1.4),
                (6.5, 8.9),
                (0.0, 4.6),
                (-6.5, 8.9),
                (-4.4, 1.4),
                (-10.5, -3.4),
                (-2.7, -3.7),
            ],
        };
        let corner = |(dx, dy): &(f64, f64)| format!("{:.1},{:.1}", f64::from(x) + dx, f64::from(y) + dy);
        format!("M{}Z", corners.iter().map(corner).collect::<Vec<_>>().join("L"))
    }
}

/// A point and what is said of it.
#[derive(Clone, Debug)]
pub struct Spot {
    /// Its place; one outside the chart's ranges is drawn at their edge.
    pub at: (f64, f64),
    /// The text that a reader sees who points at it.
    pub note: String,
}

/// Points with a mark each, and their name in the legend.
#[derive(Clone, Debug)]
pub struct Spots {
    /// The name.
    pub label: String,
    /// The colour.
    pub colour: RGBColor,
    /// The marks' shape.
    pub shape: Shape,
    /// Whether the marks are filled or outlines.
    pub filled: bool,
    /// The points; later ones are drawn over earlier ones.
    pub spots: Vec<Spot>,
}

/// A chart with a legend beside it.
#[derive(Clone, Debug)]
pub struct Chart {
    /// The heading.
    pub title: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// The curves, in the order of the legend.
    pub curves: Vec<Curve>,
    /// The points, drawn over the curves and after them in the legend.
    pub spots: Vec<Spots>,
}

/// The picture's width, in pixels.
const WIDTH: u32 = 960;
/// The picture's height where the legend does not need more.
const HEIGHT: u32 = 480;
/// The first line of the legend, and the distance to the next.
const LEGEND: (u32, u32) = (50, 22);
/// The font's size in the legend.
const SMALL: u32 = 14;

impl Chart {
    /// A chart of curves alone.
    #[must_use]
    pub fn of_curves(title: impl Into<String>, x: Axis, y: Axis, curves: Vec<Curve>) -> Self {
        Self { title: title.into(), x, y, curves, spots: Vec::new() }
    }

    /// The chart as SVG text, for any ranges and points.
    #[must_use]
    pub fn svg(&self) -> String {
        Self { x: self.x.drawable(), y: self.y.drawable(), ..self.clone() }.drawn()
    }

    fn drawn(&self) -> String {
        let (x, y) = (self.x.placed(), self.y.placed());
        match (self.x.scale == Scale::Log, self.y.scale == Scale::Log) {
            (false, false) => self.draw(x, y),
            (false, true) => self.draw(x, y.log_scale()),
            (true, false) => self.draw(x.log_scale(), y),
            (true, true) => self.draw(x.log_scale(), y.log_scale()),
        }
    }

    fn draw<X, Y>(&self, x: X, y: Y) -> String
    where
        X: AsRangedCoord<Value = f64>,
        Y: AsRangedCoord<Value = f64>,
        X::CoordDescType: ValueFormatter<f64>,
        Y::CoordDescType: ValueFormatter<f64>,
    {
        let mut text = String::new();
        let marks = self.try_draw(x, y, &mut text).expect("drawing into a string cannot fail");
        let end = text.rfind("</svg>").expect("an SVG ends so");
        text.insert_str(end, &marks);
        text
    }

    /// The labels of the legend, in order.
    fn labels(&self) -> impl Iterator<Item = &str> {
        let curves = self.curves.iter().map(|curve| curve.label.as_str());
        curves.chain(self.spots.iter().map(|spots| spots.label.as_str()))
    }

    /// The width of the legend: as the longest label needs.
    fn legend_width(&self) -> u32 {
        let longest = self.labels().map(|label| label.chars().count() as u32).max().unwrap_or(0);
        // Letters of a sans-serif font are on average about half as wide as high.
        (50 + longest * SMALL * 11 / 20).clamp(190, WIDTH / 2)
    }

    /// Draws all but the marks, and returns these as SVG elements: the drawing library has no place for their notes.
    fn try_draw<X, Y>(
        &self,
        x: X,
        y: Y,
        text: &mut String,
    ) -> Result<String, DrawingAreaErrorKind<<SVGBackend<'_> as DrawingBackend>::ErrorType>>
    where
        X: AsRangedCoord<Value = f64>,
        Y: AsRangedCoord<Value = f64>,
        X::CoordDescType: ValueFormatter<f64>,
        Y::CoordDescType: ValueFormatter<f64>,
    {
        // The last line ends above the horizontal axis' marks, which may reach out under the legend.
        let height = (LEGEND.0 + LEGEND.1 * self.labels().count() as u32 + 60).max(HEIGHT);
        let root = SVGBackend::with_string(text, (WIDTH, height)).into_drawing_area();
        root.fill(&WHITE)?;
        let border = WIDTH - self.legend_width();
        let (left, legend) = root.split_horizontally(border);
        let mut chart = ChartBuilder::on(&left)
            .caption(&self.title, ("sans-serif", 20))
            .margin(10)
            .x_label_area_size(45)
            .y_label_area_size(80)
            .build_cartesian_2d(x, y)?;
        let (x_mark, y_mark) = (|v: &f64| self.x.mark(*v), |v: &f64| self.y.mark(*v));
        let mut mesh = chart.configure_mesh();
        mesh.x_desc(&self.x.label).y_desc(&self.y.label).x_label_formatter(&x_mark).y_label_formatter(&y_mark);
        mesh.light_line_style(WHITE);
        if let Some(marks) = self.x.marks() {
            mesh.x_labels(marks);
        }
        if let Some(marks) = self.y.marks() {
            mesh.y_labels(marks);
        }
        mesh.draw()?;
        for curve in &self.curves {
            let stroke = curve.colour.stroke_width(2);
            for run in self.runs(curve) {
                let run = run.iter().map(|&(x, y)| (self.x.place(x), self.y.place(y)));
                match curve.style.dashes() {
                    None => chart.draw_series(LineSeries::new(run, stroke))?,
                    Some((dash, gap)) => chart.draw_series(DashedLineSeries::new(run, dash, gap, stroke))?,
                };
            }
        }
        let row = |place: usize| (LEGEND.0 + LEGEND.1 * place as u32) as i32;
        for (place, curve) in self.curves.iter().enumerate() {
            let (stroke, y) = (curve.colour.stroke_width(2), row(place));
            match curve.style.dashes() {
                None => legend.draw(&PathElement::new([(0, y), (28, y)], stroke))?,
                Some((dash, gap)) => legend.draw(&DashedPathElement::new([(0, y), (28, y)], dash, gap, stroke))?,
            }
        }
        for (place, label) in self.labels().enumerate() {
            legend.draw(&Text::new(label, (34, row(place) - 7), ("sans-serif", SMALL)))?;
        }
        let mut marks = String::new();
        for (place, spots) in self.spots.iter().enumerate() {
            let key = (border as i32 + 14, row(self.curves.len() + place));
            spots.draw(&mut marks, key, None);
            for spot in &spots.spots {
                let within = |axis: &Axis, v: f64| {
                    let v = if v.is_nan() { axis.range.start } else { v };
                    axis.place(v.clamp(axis.range.start, axis.range.end))
                };
                let at = chart.backend_coord(&(within(&self.x, spot.at.0), within(&self.y, spot.at.1)));
                spots.draw(&mut marks, at, Some(&spot.note));
            }
        }
        root.present()?;
        Ok(marks)
    }

    /// The stretches of a curve that lie inside both ranges.
    fn runs<'a>(&self, curve: &'a Curve) -> Vec<&'a [(f64, f64)]> {
        let inside = |axis: &Axis, v: f64| axis.range.start <= v && v <= axis.range.end;
        let shown = |&(x, y): &(f64, f64)| inside(&self.x, x) && inside(&self.y, y);
        let stretches = curve.points.chunk_by(|a, b| shown(a) == shown(b));
        stretches.filter(|run| run.first().is_some_and(&shown)).collect()
    }
}

impl Spots {
    /// Adds the mark at a place of the picture.
    fn draw(&self, text: &mut String, at: (i32, i32), note: Option<&str>) {
        let RGBColor(r, g, b) = self.colour;
        let colour = format!("#{r:02X}{g:02X}{b:02X}");
        // An outline is filled with nearly nothing, so that pointing at its middle shows its note.
        let fill = if self.filled { "0.75" } else { "0.01" };
        let path = self.shape.path(at);
        let _ = write!(
            text,
            r#"<path d="{path}" fill="{colour}" fill-opacity="{fill}" stroke="{colour}" stroke-width="1.5">"#
        );
        if let Some(note) = note {
            let _ = write!(text, "<title>{}</title>", escaped(note));
        }
        text.push_str("</path>\n");
    }
}

/// Text as it stands in an element of SVG.
pub(crate) fn escaped(text: &str) -> String {
    let mut result = String::new();
    for c in text.chars() {
        match c {
            '&' => result.push_str("&amp;"),
            '<' => result.push_str("&lt;"),
            '>' => result.push_str("&gt;"),
            // XML has no place for other control characters.
            c if c.is_control() && c != '\n' => result.push(' '),
            c => result.push(c),
        }
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chart(points: Vec<(f64, f64)>) -> Chart {
        let curve = Curve { label: "one & two".to_owned(), colour: COLOURS[0], style: Style::Solid, points };
        let (x, y) = (Axis::log("shininess n", 1.0..1000.0), Axis::linear("error", 0.0..1.0).with_unit(" %"));
        Chart::of_curves("A title", x, y, vec![curve])
    }

    #[test]
    fn the_text_has_what_was_asked_for() {
        let text = chart(vec![(1.0, 0.5), (10.0, 0.7)]).svg();
        for part in ["<svg", "A title", "shininess n", "error", "one &amp; two", "0.5 %", "\n100\n", "</svg>"] {
            assert!(text.contains(part), "`{part}` is not in\n{text}");
        }
    }

    #[test]
    fn points_outside_interrupt_a_curve() {
        let curve =
            chart(vec![(1.0, 0.1), (2.0, 0.2), (3.0, 1.1), (4.0, f64::NAN), (5.0, 0.3), (0.5, 0.3), (6.0, 0.4)]);
        let lengths: Vec<usize> = curve.runs(&curve.curves[0]).iter().map(|run| run.len()).collect();
        assert_eq!(lengths, [2, 1, 1]);
    }

    #[test]
    fn axes_name_their_places() {
        let powers = Axis::powers("error", 1e-5..0.5);
        assert_eq!(powers.mark(powers.place(1.0 / 4096.0)), "2⁻¹²");
        assert_eq!(powers.mark(-3.5), "");
        assert_eq!((powers.mark(0.0), powers.mark(16.0)), ("2⁰".to_owned(), "2¹⁶".to_owned()));
        let luts = Axis::doubling("LUTs", 30, 600);
        assert_eq!((luts.range.clone(), luts.mark(7.0)), (16.0..1024.0, "128".to_owned()));
        let many = Axis::counts("DSPs", 18);
        assert_eq!(
            (many.scale, many.mark(many.place(16.0)), many.mark(1.5)),
            (Scale::Root, "16".to_owned(), String::new())
        );
        let few = Axis::counts("DSPs", 3);
        assert_eq!(
            (few.scale, few.mark(2.0), few.mark(0.5), few.mark(-0.0)),
            (Scale::Whole, "2".to_owned(), String::new(), "0".to_owned())
        );
    }

    #[test]
    fn every_spot_has_its_mark_and_note() {
        let spot = |x: f64, y: f64| Spot { at: (x, y), note: format!("<{x}> & \"{y}\"") };
        let spots = |shape| Spots {
            label: "a < b".to_owned(),
            colour: COLOURS[1],
            shape,
            filled: shape == Shape::Circle,
            spots: vec![spot(2.0, 0.5), spot(5000.0, f64::INFINITY), spot(3.0, 0.0)],
        };
        let mut chart = chart(vec![(1.0, 0.5)]);
        chart.spots = Shape::PLAIN.into_iter().map(spots).collect();
        let text = chart.svg();
        assert_eq!(text.matches("<title>&lt;2&gt; &amp; \"0.5\"</title>").count(), 5);
        assert_eq!(text.matches("<title>&lt;5000&gt;").count(), 5);
        // One mark a spot and one in the legend.
        assert_eq!(text.matches("<path ").count(), 5 * 4);
        assert!(!text.contains("NaN") && !text.contains(",inf") && !text.contains("Minf"));
    }

    #[test]
    fn every_range_is_drawn_in_bounded_time() {
        use std::time::{Duration, Instant};

        let ends = [f64::MIN, 0.0, 5e-324, 1.0, 1.0 + 2e-16, f64::MAX, f64::NAN];
        let scales = [Scale::Linear, Scale::Log, Scale::Powers, Scale::Doubling, Scale::Whole, Scale::Root];
        for scale in scales {
            for low in ends {
                for high in ends {
                    let start = Instant::now();
                    let axis = Axis { label: "a".to_owned(), range: low..high, scale, unit: "" };
                    let mut chart = chart(vec![(low, 0.5), (high, 0.7), (0.5, 0.5)]);
                    chart.spots = vec![Spots {
                        label: "s".to_owned(),
                        colour: COLOURS[1],
                        shape: Shape::Circle,
                        filled: true,
                        spots: ends.map(|at| Spot { at: (at, 0.5), note: String::new() }).to_vec(),
                    }];
                    chart.x = axis;
                    let text = chart.svg();
                    assert!(text.len() < 60_000, "{scale:?} {low:e} {high:e}: {} bytes", text.len());
                    assert!(!text.contains("NaN"), "{scale:?} {low:e} {high:e}");
                    // Endless counting would show as memory, or here.
                    assert!(start.elapsed() < Duration::from_secs(30), "{scale:?} {low:e} {high:e}");
                }
            }
        }
        for (least, largest) in [(0, 0), (0, 1), (5, 5), (u32::MAX, u32::MAX), (0, u32::MAX), (9, 3)] {
            for x in [Axis::doubling("a", least, largest), Axis::counts("a", largest), Axis::whole("a", largest)] {
                assert!(Chart { x, ..chart(vec![(1.0, 0.5)]) }.svg().contains("</svg>"));
            }
        }
    }

    #[test]
    fn a_long_legend_has_room() {
        let mut chart = chart(vec![(1.0, 0.5)]);
        assert!(chart.svg().contains("height=\"480\""));
        chart.curves = (0..30).map(|_| chart.curves[0].clone()).collect();
        assert!(chart.svg().contains("height=\"770\""));
        chart.curves[0].label = "a label of thirty-two characters".to_owned();
        assert!(chart.legend_width() > 250);
    }
}
