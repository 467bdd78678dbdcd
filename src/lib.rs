//! brdfgen generates FPGA cores for the specular term of a shader: `cos^n` of the highlight, as a rule a polynomial in the cosine whose
//! coefficients, one set for each shininess n, sit in a ROM; and whole shaders around it.
//!
//! # The map of the house
//!
//! Data flows one way: spec → coefficients → datapath → {HDL, vectors, ROM files} → checks → reports.
//!
//! | module | what it does |
//! | --- | --- |
//! | [`spec`] | what the user asked for: TOML and flags, validated once, every default resolved |
//! | [`lobe`] | real-valued mathematics, one file a method; knows no bits |
//! | [`fit`] | minimax coefficients for the lobes' shapes, as real numbers |
//! | [`number`] | fixed-point formats, intervals, the model's wide type |
//! | [`reflectance`] | measured and analytic reflectance, sphere images of it; knows no cores |
//! | [`rom`] | quantised coefficient tables; writers and readers of every ROM format |
//! | [`datapath`] | the core as a graph of typed operations: error analysis, widths, schedule, simulation, evaluator |
//! | [`model`] | the bit-exact reference, straight from the formula; knows nothing of `datapath` |
//! | [`design`] | a resolved core: all of the above for one spec, and its measured error |
//! | [`kernel`] | the same blocks in rust-hdl: in-process simulation, a second road to Verilog |
//! | [`hdl`] | datapath to Verilog and VHDL, through templates |
//! | [`golden`] | golden vectors: make, read, compare |
//! | [`package`] | the core directory: all files of a core, put on disk whole |
//! | [`mutate`] | mutants of a core, and whether the golden vectors kill them |
//! | [`cosim`] | runs the HDL in simulators and compares it with the model |
//! | [`synth`] | runs Yosys and nextpnr: cells, Fmax, with a cache |
//! | [`formal`] | proves that the HDL texts of a core are the same circuit |
//! | [`tool`] | external programs: where they are, how they are run |
//! | [`transient`] | temporary files and started programs: none outlives a run |
//! | [`explore`] | sweeps of many cores: errors, costs, the Pareto front, the choice |
//! | [`scene`] | scene files, what a scene requires of a core, pictures |
//! | [`stability`] | how cores hold up where forms degenerate: registers (of shaders too), ends, seams, every input |
//! | [`report`] | charts as SVG and PNG; the trade as an HTML page |
//! | [`claims`] | the papers' claims and figures, measured on the real-valued lobes |
//! | [`input`] | the user's files, read within limits and as other programs write them |
//! | [`paths`] | which files a command reads and writes: nothing is written over what is read |
//! | [`cli`] | the commands; the only module that prints |
//!
//! `model` and `datapath` never import each other: what the one says, the other is checked against.
#![warn(missing_docs)]

pub mod block;
pub mod cli;
pub mod core;
pub mod datapath;
pub mod emit;
pub mod explore;
pub mod fit;
pub mod fixed;
pub mod lobe;
pub mod method;
pub mod papers;
pub mod platform;
pub mod reflectance;
pub mod report;
pub mod scene;
pub mod spec;
pub mod synth;
pub mod verify;
