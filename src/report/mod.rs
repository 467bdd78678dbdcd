//! Reports: charts as SVG and PNG, and the page of the trade as HTML. Same input, same bytes.

mod chart;
mod lobes;
mod material;
mod page;
mod png;
mod scene;
mod speed;
mod trade;

pub(crate) use chart::escaped;
pub use chart::{Axis, BLACK, COLOURS, Chart, Curve, Scale, Shape, Spot, Spots, Style};
pub use material::{MaterialPart, chart as trade_of_material};
pub use page::Report;
pub use png::png;
pub(crate) use png::{draw, text_width};
pub use scene::ScenePart;
pub use speed::Speed;
pub use trade::{Group, Palette, groups};
