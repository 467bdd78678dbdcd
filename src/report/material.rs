//! A material's part of the page: memory against error of all that can stand in place of its reflectance.

use super::page::{Figure, Line, Table, number, word};
use crate::plot::{Axis, BLACK, COLOURS, Chart, Shape, Spot, Spots};
use crate::reflectance::trade::Point;

/// A material in the report.
#[derive(Debug)]
pub struct MaterialPart {
    /// Its name.
    pub(super) name: String,
    /// What is said of it.
    pub(super) line: String,
    pub(super) chart: (String, Chart),
    pub(super) table: Table,
}

impl MaterialPart {
    /// What was measured of the material in this place of the report.
    #[must_use]
    pub fn of(place: usize, name: &str, exposure: f64, points: &[Point]) -> Self {
        const HEADS: [(&str, &str); 8] = [
            ("what", "the form with its images, their size and texels, or the fitted material"),
            ("front", "whether nothing that takes less memory has a better mean"),
            ("KiB", "memory of the texels"),
            ("dB", "PSNR in the mean over the light's angles"),
            ("worst dB", "PSNR at the worst angle"),
            ("at", "that angle in degrees"),
            ("images", "images, slices or highlights"),
            ("size", "texels along a side"),
        ];
        let line = |point: &Point| Line {
            chosen: false,
            cells: vec![
                word(point.name()),
                word(if point.front { "yes" } else { "" }),
                number(Some(point.kib), |kib| format!("{kib:.3}")),
                number(Some(point.mean), |mean| format!("{mean:.2}")),
                number(Some(point.worst), |worst| format!("{worst:.2}")),
                number(Some(point.worst_phi), |phi| format!("{phi}")),
                number(Some(point.images as f64), |images| format!("{images}")),
                number(Some(point.size as f64), |size| format!("{size}")),
            ],
        };
        Self {
            name: name.to_owned(),
            line: format!(
                "Pictures of a sphere against those of the reflectance itself, at the exposure {exposure:.4}, over \
                 lights from 2.5 to 167.5 degrees from the viewer; on linear values from 0 to 1."
            ),
            chart: (format!("material_{}", place + 1), chart(name, points)),
            table: Table::of(format!("{} points", points.len()), &HEADS, points.iter().map(line).collect()),
        }
    }

    /// The chart for the page.
    pub(super) fn figure(&self) -> Figure {
        Figure::of(&self.chart.0, &self.chart.1)
    }
}

/// The chart of a material's trade.
#[must_use]
pub fn chart(name: &str, points: &[Point]) -> Chart {
    let of = |form: &'static str, label: &str, colour, shape, filled| Spots {
        label: label.to_owned(),
        colour,
        shape,
        filled,
        spots: points
            .iter()
            .filter(|point| point.form == form)
            .map(|point| Spot {
                at: (point.kib, point.mean),
                note: format!(
                    "{}: {:.3} KiB, {:.2} dB, worst {:.2} dB",
                    point.name(),
                    point.kib,
                    point.mean,
                    point.worst
                ),
            })
            .collect(),
    };
    Chart {
        title: format!("Memory and error of {name}"),
        x: Axis::log("memory in KiB", 0.01..100_000.0),
        y: Axis::linear("PSNR, the mean over the light's angles", 10.0..70.0).with_unit(" dB"),
        curves: Vec::new(),
        spots: vec![
            of("paper", "paper: sphere images", COLOURS[2], Shape::Circle, false),
            of("half", "half: slices", COLOURS[0], Shape::Square, false),
            of("bivariate", "bivariate", COLOURS[4], Shape::Diamond, false),
            of("blinn", "cos^n, Blinn", BLACK, Shape::Triangle, true),
            of("phong", "cos^n, Phong", COLOURS[5], Shape::Wedge, true),
        ],
    }
}
