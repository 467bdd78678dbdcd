//! What a core is: a lobe alone, or what is built around one.

pub mod image;
mod parts;
pub mod shader;

use clap::ValueEnum;
use serde::{Deserialize, Serialize};

use crate::method::{Coefficients, Configured, Interface};
use shader::Shader;

/// What a core is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum BlockKind {
    /// The lobe alone.
    #[default]
    Lobe,
    /// A lobe with the cosine in front of it and the colours behind it.
    Shader,
}

/// A lobe, resolved.
#[derive(Clone, Debug, PartialEq)]
pub struct LobeSpec {
    /// The method with its options.
    pub method: Configured,
    /// The shininesses and the formats of the lobe's ports.
    pub interface: Interface,
}

/// A core's block, resolved.
#[derive(Clone, Debug, PartialEq)]
pub enum Block {
    /// The lobe alone.
    Lobe(LobeSpec),
    /// A complete shader around the lobe.
    Shader(LobeSpec, Shader),
}

impl LobeSpec {
    /// Whether the coefficients are fitted.
    #[must_use]
    pub fn is_fitted(&self) -> bool {
        self.method.options().coefficients == Some(Coefficients::Minimax)
    }
}

impl Block {
    /// Its lobe.
    #[must_use]
    pub fn lobe(&self) -> &LobeSpec {
        match self {
            Self::Lobe(lobe) | Self::Shader(lobe, _) => lobe,
        }
    }

    /// The shader, if it is one.
    #[must_use]
    pub fn shader(&self) -> Option<&Shader> {
        match self {
            Self::Lobe(_) => None,
            Self::Shader(_, shader) => Some(shader),
        }
    }
}
