//! Polynomials in the scaled versine, for the methods that evaluate any.

pub(crate) mod datapath;
mod lobe;

pub use lobe::Polynomial;
