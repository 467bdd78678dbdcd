//! brdfgen generates FPGA cores for the specular term of a shader: `cos^n` of the highlight, as a rule a polynomial in
//! the cosine whose coefficients, one set for each shininess n, sit in a ROM; and whole shaders around it.
//!
//! A program gives a [`Spec`] and gets a [`Core`]: all files in memory, the bit-exact model, what is proved and
//! measured of the error.
//!
//! ```
//! use brdfgen::{Core, Spec};
//!
//! let spec: Spec = "method = 'quadratic'\nshininess = '1..=16'\ninput_fraction = 8".parse()?;
//! let core = Core::generate(&spec)?;
//! for file in &core.files {
//!     println!("{}: {} bytes", file.path, file.bytes.len());
//! }
//! println!("{} clocks; 0.95^5 is {:.4}", core.design.schedule.latency, core.at(5.0, 0.95)?.value);
//! # Ok::<(), brdfgen::Error>(())
//! ```
//!
//! # The map of the house
//!
//! Data flows one way: spec → method → datapath → core → {HDL, ROM files, vectors} → checks → reports. A room stands
//! above all that it uses, as `tests/it/rooms.rs` reads off the sources; from the bottom up:
//!
//! | module | what it does |
//! | --- | --- |
//! | [`platform`] | external programs, temporary files, errors, the user's files |
//! | [`plot`] | charts as SVG and PNG |
//! | [`fixed`] | fixed-point formats, intervals, the model's wide type, the words of a memory |
//! | [`emit::rom`] | writers and readers of every ROM format, one file each |
//! | [`lobe`] | the lobe x^n as a real number, and what its approximations have in common |
//! | [`target`] | one file an FPGA family: cells, block RAM and DSP shapes, costs, tools |
//! | [`datapath`] | a core as a graph of typed operations: error analysis, widths, schedule, simulation, evaluator |
//! | [`fit`] | minimax coefficients for the lobes' shapes, as real numbers |
//! | [`method`] | one folder a method: its options, its reals, its graph, its bits |
//! | [`reflectance`] | measured and analytic reflectance, sphere images of it; knows no cores |
//! | [`block`] | what is built around a lobe: a whole shader |
//! | [`spec`] | what the user asked for: TOML and flags, validated once, every default resolved |
//! | [`core`] | a resolved core: all of the above for one spec, its ports and its measured error |
//! | [`emit`] | a core as Verilog and VHDL, test benches, and the core directory, put on disk whole |
//! | [`synth`] | runs Yosys and nextpnr: cells, Fmax, with a cache |
//! | [`verify`] | golden vectors, simulators, proofs, injected faults, stability |
//! | [`generate`] | the front door: a core with all that goes with it |
//! | [`explore`] | sweeps of many cores: errors, costs, the Pareto front, the choice |
//! | [`scene`] | scene files, what a scene requires of a core, pictures |
//! | [`papers`] | the papers' claims and figures, measured on the real-valued lobes |
//! | [`report`] | the trade as an HTML page |
//! | [`cli`] | the commands; the only module that prints |
//!
//! Within a method `model` and `datapath` never import each other: what the one says, the other is checked against.
#![warn(missing_docs)]

pub mod block;
pub mod cli;
pub mod core;
pub mod datapath;
pub mod emit;
pub mod explore;
pub mod fit;
pub mod fixed;
pub mod generate;
pub mod lobe;
pub mod method;
pub mod papers;
pub mod platform;
pub mod plot;
pub mod reflectance;
pub mod report;
pub mod scene;
pub mod spec;
pub mod synth;
pub mod target;
pub mod verify;

pub use generate::Core;
pub use platform::error::Error;
pub use spec::CoreSpec as Spec;
