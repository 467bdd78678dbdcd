//! Line charts.

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

    /// A mark's number, without the rounding of the mark's place.
    fn mark(&self, value: f64) -> String {
        let short: f64 = format!("{value:.6e}").parse().unwrap_or(value);
        // A sum of steps may miss 0 by its rounding.
        let tiny = short.abs() < 1e-9 * (self.range.end - self.range.start).abs() && self.scale == Scale::Linear;
        format!("{}{}", if tiny { 0.0 } else { short }, self.unit)
    }
}

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// A line.
    Solid,
    /// A broken line.
    Dashed,
}

/// A curve and its name in the legend.
#[derive(Clone, Debug)]
pub struct Curve {
    /// The name.
    pub label: String,
    /// The colour.
    pub colour: RGBColor,
    /// Solid or dashed.
    pub style: Style,
    /// The points, in order; those outside the chart's ranges are left out and interrupt the line.
    pub points: Vec<(f64, f64)>,
}

/// A line chart with a legend beside it.
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
}

/// The picture's size, and the width of it that the legend has, in pixels.
const SIZE: (u32, u32) = (960, 480);
const LEGEND: u32 = 190;

impl Chart {
    /// The chart as SVG text.
    #[must_use]
    pub fn svg(&self) -> String {
        let (x, y) = (self.x.range.clone(), self.y.range.clone());
        match (self.x.scale, self.y.scale) {
            (Scale::Linear, Scale::Linear) => self.draw(x, y),
            (Scale::Linear, Scale::Log) => self.draw(x, y.log_scale()),
            (Scale::Log, Scale::Linear) => self.draw(x.log_scale(), y),
            (Scale::Log, Scale::Log) => self.draw(x.log_scale(), y.log_scale()),
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
        self.try_draw(x, y, &mut text).expect("drawing into a string cannot fail");
        text
    }

    fn try_draw<X, Y>(
        &self,
        x: X,
        y: Y,
        text: &mut String,
    ) -> Result<(), DrawingAreaErrorKind<<SVGBackend<'_> as DrawingBackend>::ErrorType>>
    where
        X: AsRangedCoord<Value = f64>,
        Y: AsRangedCoord<Value = f64>,
        X::CoordDescType: ValueFormatter<f64>,
        Y::CoordDescType: ValueFormatter<f64>,
    {
        let root = SVGBackend::with_string(text, SIZE).into_drawing_area();
        root.fill(&WHITE)?;
        let (left, legend) = root.split_horizontally(SIZE.0 - LEGEND);
        let mut chart = ChartBuilder::on(&left)
            .caption(&self.title, ("sans-serif", 20))
            .margin(10)
            .x_label_area_size(45)
            .y_label_area_size(80)
            .build_cartesian_2d(x, y)?;
        chart
            .configure_mesh()
            .x_desc(&self.x.label)
            .y_desc(&self.y.label)
            .x_label_formatter(&|v| self.x.mark(*v))
            .y_label_formatter(&|v| self.y.mark(*v))
            .light_line_style(WHITE)
            .draw()?;
        for curve in &self.curves {
            let stroke = curve.colour.stroke_width(2);
            for run in self.runs(curve) {
                match curve.style {
                    Style::Solid => chart.draw_series(LineSeries::new(run.iter().copied(), stroke))?,
                    Style::Dashed => chart.draw_series(DashedLineSeries::new(run.iter().copied(), 7, 4, stroke))?,
                };
            }
        }
        for (row, curve) in (0i32..).zip(&self.curves) {
            let (stroke, y) = (curve.colour.stroke_width(2), 50 + 22 * row);
            match curve.style {
                Style::Solid => legend.draw(&PathElement::new([(0, y), (28, y)], stroke))?,
                Style::Dashed => legend.draw(&DashedPathElement::new([(0, y), (28, y)], 7, 4, stroke))?,
            }
            legend.draw(&Text::new(curve.label.as_str(), (34, y - 7), ("sans-serif", 14)))?;
        }
        root.present()
    }

    /// The stretches of a curve that lie inside both ranges.
    fn runs<'a>(&self, curve: &'a Curve) -> Vec<&'a [(f64, f64)]> {
        let inside = |axis: &Axis, v: f64| axis.range.start <= v && v <= axis.range.end;
        let shown = |&(x, y): &(f64, f64)| inside(&self.x, x) && inside(&self.y, y);
        let stretches = curve.points.chunk_by(|a, b| shown(a) == shown(b));
        stretches.filter(|run| run.first().is_some_and(&shown)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chart(points: Vec<(f64, f64)>) -> Chart {
        let curve = Curve { label: "one & two".to_owned(), colour: COLOURS[0], style: Style::Solid, points };
        let (x, y) = (Axis::log("shininess n", 1.0..1000.0), Axis::linear("error", 0.0..1.0).with_unit(" %"));
        Chart { title: "A title".to_owned(), x, y, curves: vec![curve] }
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
}
