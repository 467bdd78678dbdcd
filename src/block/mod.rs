//! What a core is: a lobe alone, or what is built around one.

pub mod image;
pub mod lights;
mod parts;
pub mod shader;

use clap::ValueEnum;
use serde::{Deserialize, Serialize};

use crate::method::{Coefficients, Configured, Interface};
use image::ImageSpec;
use shader::Shader;

/// Red, green and blue in names.
pub const CHANNELS: [char; 3] = ['r', 'g', 'b'];

/// What a core is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum BlockKind {
    /// The lobe alone.
    #[default]
    Lobe,
    /// A lobe with the cosine in front of it and the colours behind it.
    Shader,
    /// A reflectance by texels of it.
    Image,
}

impl BlockKind {
    /// What such a core is, with its article.
    #[must_use]
    pub fn noun(self) -> &'static str {
        match self {
            Self::Lobe => "a lobe",
            Self::Shader => "a shader",
            Self::Image => "an image-based block",
        }
    }
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
    /// An image-based block, which has no lobe.
    Image(ImageSpec),
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
    ///
    /// # Panics
    /// An image-based block has none: where one may come, look at the variant.
    #[must_use]
    pub fn lobe(&self) -> &LobeSpec {
        match self {
            Self::Lobe(lobe) | Self::Shader(lobe, _) => lobe,
            Self::Image(_) => panic!("an image-based block has no lobe"),
        }
    }

    /// Its kind.
    #[must_use]
    pub fn kind(&self) -> BlockKind {
        match self {
            Self::Lobe(_) => BlockKind::Lobe,
            Self::Shader(..) => BlockKind::Shader,
            Self::Image(_) => BlockKind::Image,
        }
    }

    /// Whether there is a lobe in it.
    #[must_use]
    pub fn has_lobe(&self) -> bool {
        !matches!(self, Self::Image(_))
    }

    /// The shader, if it is one.
    #[must_use]
    pub fn shader(&self) -> Option<&Shader> {
        match self {
            Self::Lobe(_) | Self::Image(_) => None,
            Self::Shader(_, shader) => Some(shader),
        }
    }
}
