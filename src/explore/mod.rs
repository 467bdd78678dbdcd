//! The trade, explored: many cores, the error and the cost of each, and the choice among them.
//!
//! - [`sweep`]: axes of spec keys, expanded to cores;
//! - [`run`]: the error and the cost of each core, a few at a time;
//! - [`store`]: where they are kept as they come, so that a run that was killed goes on where it was;
//! - [`point`]: one core for one family with its error and its cost;
//! - [`shape`]: what a core is made of;
//! - [`estimate`]: a cost model in terms of that, fitted to measured points;
//! - [`results`]: the points of a run as CSV, JSON or SQLite;
//! - [`pareto`](mod@pareto): the points that no other one beats in every way;
//! - [`choose`]: the cheapest core that meets constraints, and what just misses it.

pub mod choose;
mod columns;
pub mod estimate;
pub mod pareto;
pub mod point;
pub mod results;
pub mod run;
pub mod shape;
pub mod store;
pub mod sweep;

pub use choose::{Choice, Constraints, MaxError};
pub use estimate::Model;
pub(crate) use pareto::dominates;
pub use pareto::{Objective, pareto};
pub use point::{Cost, Estimate, Point};
pub use results::Results;
pub use shape::Shape;
pub use store::Store;
pub use sweep::Sweep;
