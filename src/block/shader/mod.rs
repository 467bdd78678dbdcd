//! A whole shader: a lobe with the cosine in front of it and the colours behind it.

pub mod datapath;
mod model;
mod options;

pub use model::{Cosines, ShaderModel};
pub(crate) use options::unit;
pub use options::{
    CHANNEL_BITS, Cosine, Front, LIGHTS, LightColours, Model, Shader, ShaderFields, ShaderWidths, Surface,
    VECTOR_FRACTION,
};
