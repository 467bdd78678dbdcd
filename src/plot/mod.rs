//! Charts as SVG, and SVG as pixels. Same input, same bytes.

mod chart;
mod png;

pub(crate) use chart::escaped;
pub use chart::{Axis, BLACK, COLOURS, Chart, Curve, Scale, Shape, Spot, Spots, Style};
pub use png::png;
pub(crate) use png::{draw, text_width};
