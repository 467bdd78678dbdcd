//! The trade, explored: many cores, the error and the cost of each, and the choice among them.
//!
//! - [`point`]: one core for one family with its error and its cost;
//! - [`results`]: the points of a run as CSV, JSON or SQLite.

pub mod point;
pub mod results;

pub use point::{Cost, Estimate, Point};
pub use results::Results;
