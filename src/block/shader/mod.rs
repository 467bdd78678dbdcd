//! A whole shader: a lobe with the cosine in front of it and the colours behind it.

pub mod datapath;
mod model;

pub use model::{Cosines, ShaderModel};
