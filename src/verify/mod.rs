//! Whether a core does what it should: each check holds the core's text, netlist or operations against the model.
//!
//! In this order, none of which uses one below it:
//! - [`faults`]: what can be wrong with a core, what detects it, and what becomes of it;
//! - [`golden`]: golden vectors: make, read, compare;
//! - [`kernel`]: the same blocks in rust-hdl: in-process simulation, a second road to Verilog;
//! - [`cosim`]: runs the HDL in simulators and compares it with the model;
//! - [`formal`]: proves that the HDL texts of a core are the same circuit, and what mutants of its netlist are;
//! - [`stability`]: how cores hold up where forms degenerate: registers (of shaders too), ends, seams, every input.

pub mod cosim;
pub mod faults;
pub mod formal;
pub mod golden;
#[cfg(feature = "kernel")]
pub mod kernel;
pub mod stability;
