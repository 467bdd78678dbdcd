//! Reports: charts as SVG text. Same input, same bytes.

mod chart;

pub use chart::{Axis, BLACK, COLOURS, Chart, Curve, Scale, Style};
