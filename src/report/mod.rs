//! Reports: the pages of the trade, of a material and of a scene, as HTML. Same input, same bytes.

mod lobes;
mod material;
mod page;
mod scene;
mod speed;
mod trade;

pub use material::{MaterialPart, chart as trade_of_material};
pub use page::Report;
pub use scene::ScenePart;
pub use speed::Speed;
pub use trade::{Group, Palette, groups};
