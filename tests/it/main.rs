//! The tests, but those of private functions, which stand beside them. They are one program: each one more would link
//! the whole crate once more.

mod common;

mod axis;
mod baselines;
mod claims;
mod cli;
mod divide;
mod exactness;
mod explore;
mod fit;
mod formal;
mod image;
mod image_files;
mod image_grid;
mod image_matcap;
mod light_function;
mod lights;
mod lint;
mod lobes;
mod log_exp;
mod monotone;
mod mutate;
mod netlist;
mod options;
mod parsers;
mod reflectance;
mod report;
mod rooms;
mod scene_file;
mod scene_image;
mod scene_matcap;
mod scene_reflectance;
mod scene_render;
mod scene_require;
mod scene_shade;
mod scene_trace;
mod shader;
mod simulators;
mod stability;
mod surroundings;
mod synth;
mod texel_memory;
mod unit;
mod writable;
