//! What is built around a lobe.

pub mod shader;
