//! The methods and what may be chosen of each.

use serde::{Deserialize, Serialize};

/// A way to approximate the lobe.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Method {
    /// x(1 - a u), clamped at 0.
    Quadratic,
    /// x(1 - u(A - a u)); past its minimum cut to 0 or held.
    Cubic,
    /// The cubic up to the cusp, x/(d + b u) past it.
    CubicRational,
    /// The cubic's shape through two points of the lobe.
    CubicThreePoint,
    /// x(1 - K u)^2, 0 past its zero.
    CubicMinZero,
    /// x/(1 + (n-1)u).
    Schlick,
    /// (1 - n u/2)^2, 0 past its zero.
    #[serde(rename = "lyon-2")]
    #[value(name = "lyon-2")]
    Lyon2,
    /// (1 - n u/4)^4, 0 past its zero.
    #[serde(rename = "lyon-4")]
    #[value(name = "lyon-4")]
    Lyon4,
    /// (1 - n u/8)^8, 0 past its zero.
    #[serde(rename = "lyon-8")]
    #[value(name = "lyon-8")]
    Lyon8,
    /// (1 - u(A - a u))^2 with fitted coefficients.
    #[serde(rename = "power-2")]
    #[value(name = "power-2")]
    Power2,
    /// (1 - u(A - a u))^4 with fitted coefficients.
    #[serde(rename = "power-4")]
    #[value(name = "power-4")]
    Power4,
    /// (1 - u(A - a u))^8 with fitted coefficients.
    #[serde(rename = "power-8")]
    #[value(name = "power-8")]
    Power8,
    /// x(c - u(A - a u)) in 2 segments.
    #[serde(rename = "segmented-2")]
    #[value(name = "segmented-2")]
    Segmented2,
    /// x(c - u(A - a u)) in 4 segments.
    #[serde(rename = "segmented-4")]
    #[value(name = "segmented-4")]
    Segmented4,
    /// x(c - u(A - a u)) in 8 segments.
    #[serde(rename = "segmented-8")]
    #[value(name = "segmented-8")]
    Segmented8,
    /// 2^(-n L(x)) with L = -log2 x, from small tables.
    LogExp,
    /// x squared log2 n times, for shininesses that are powers of two.
    Squaring,
    /// 2^(-n L(x)) with L from one table and 2^-f from another, neither interpolated: one multiplication.
    Harris,
    /// x^n from one table by n and the leading bits of the versine.
    Table,
}

impl Method {
    /// The lobe's formula, for headers and datasheets.
    #[must_use]
    pub fn formula(self) -> &'static str {
        match self {
            Self::Quadratic => "max(0, x(1 - a u))",
            Self::Cubic | Self::CubicThreePoint => "x(1 - u(A - a u))",
            Self::CubicRational => "x(1 - u(A - a u)) to the cusp, x/(d + b u) past it",
            Self::CubicMinZero => "x max(0, 1 - K u)^2",
            Self::Schlick => "x/(1 + (n-1)u)",
            Self::Lyon2 => "max(0, 1 - n u/2)^2",
            Self::Lyon4 => "max(0, 1 - n u/4)^4",
            Self::Lyon8 => "max(0, 1 - n u/8)^8",
            Self::Power2 => "max(0, 1 - u(A - a u))^2",
            Self::Power4 => "max(0, 1 - u(A - a u))^4",
            Self::Power8 => "max(0, 1 - u(A - a u))^8",
            Self::Segmented2 => "x(c - u(A - a u)) in 2 segments",
            Self::Segmented4 => "x(c - u(A - a u)) in 4 segments",
            Self::Segmented8 => "x(c - u(A - a u)) in 8 segments",
            Self::LogExp => "2^(-n L(x)), L = -log2 x",
            Self::Squaring => "x^n by log2 n squarings",
            Self::Harris => "2^(-n L(x)), L and 2^-f from tables",
            Self::Table => "x^n from a table",
        }
    }

    /// The coefficients that the method can have, the default first; none for a method without any.
    #[must_use]
    pub fn coefficients(self) -> &'static [Coefficients] {
        match self {
            Self::Quadratic | Self::Cubic | Self::CubicRational | Self::CubicThreePoint | Self::CubicMinZero => {
                &[Coefficients::Paper, Coefficients::Minimax]
            }
            Self::Power2 | Self::Power4 | Self::Power8 | Self::Segmented2 | Self::Segmented4 | Self::Segmented8 => {
                &[Coefficients::Minimax]
            }
            Self::Schlick
            | Self::Lyon2
            | Self::Lyon4
            | Self::Lyon8
            | Self::LogExp
            | Self::Squaring
            | Self::Harris
            | Self::Table => &[],
        }
    }

    /// Whether the papers print a form of it in powers of the cosine.
    #[must_use]
    pub fn has_paper_form(self) -> bool {
        matches!(self, Self::Quadratic | Self::Cubic)
    }

    /// Whether the paper's coefficients depend on a level Q.
    #[must_use]
    pub fn has_level(self) -> bool {
        matches!(self, Self::Cubic | Self::CubicRational | Self::CubicThreePoint | Self::CubicMinZero)
    }

    /// Whether the lobe past the cubic's minimum can be chosen.
    #[must_use]
    pub fn has_tail(self) -> bool {
        matches!(self, Self::Cubic | Self::CubicThreePoint)
    }

    /// Whether a core with less accuracy than the output's last bit can be asked for.
    #[must_use]
    pub fn has_accuracy(self) -> bool {
        self == Self::LogExp
    }

    /// Whether the core divides.
    #[must_use]
    pub fn divides(self) -> bool {
        matches!(self, Self::CubicRational | Self::Schlick)
    }

    /// k of a method that ends in a kth power.
    #[must_use]
    pub fn power(self) -> Option<u32> {
        match self {
            Self::Lyon2 | Self::Power2 => Some(2),
            Self::Lyon4 | Self::Power4 => Some(4),
            Self::Lyon8 | Self::Power8 => Some(8),
            _ => None,
        }
    }

    /// Whether the inner polynomial of a power can be chosen.
    #[must_use]
    pub fn has_inside(self) -> bool {
        matches!(self, Self::Power2 | Self::Power4 | Self::Power8)
    }

    /// The number of segments of a method that has any.
    #[must_use]
    pub fn segments(self) -> Option<u32> {
        match self {
            Self::Segmented2 => Some(2),
            Self::Segmented4 => Some(4),
            Self::Segmented8 => Some(8),
            _ => None,
        }
    }

    /// Whether the core computes with n itself, which the port of a range gives it, so that it needs no ROM for it.
    #[must_use]
    pub fn computes_with_shininess(self) -> bool {
        matches!(self, Self::Schlick | Self::Lyon2 | Self::Lyon4 | Self::Lyon8 | Self::LogExp | Self::Harris)
    }

    /// Whether coefficients may be interpolated between the ROM's rows.
    #[must_use]
    pub fn interpolates(self) -> bool {
        matches!(self, Self::Quadratic | Self::Cubic | Self::CubicMinZero | Self::Power2 | Self::Power4 | Self::Power8)
    }

    /// Whether it is there to be compared with: published by others, or what an engineer would build without this crate.
    #[must_use]
    pub fn is_baseline(self) -> bool {
        matches!(
            self,
            Self::Schlick | Self::Lyon2 | Self::Lyon4 | Self::Lyon8 | Self::Squaring | Self::Harris | Self::Table
        )
    }
}

/// How the polynomial is evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Form {
    /// In the versine, scaled per shininess: narrow and well conditioned.
    Stable,
    /// In powers of the cosine, as the papers print it.
    Paper,
}

/// Where the coefficients come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Coefficients {
    /// The papers' closed forms.
    Paper,
    /// Fitted to x^n for the least of an objective, then to the ROM words.
    Minimax,
}

/// What the cubic is past its minimum, where the polynomial rises again.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Tail {
    /// 0.
    Cut,
    /// The minimum's value, down to the cosine 0.
    Hold,
}

/// The polynomial inside a power.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Inside {
    /// 1 - A u.
    Linear,
    /// 1 - u(A - a u).
    Quadratic,
}

/// Where the function tables of a core are meant to lie; its widths are chosen accordingly.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Memory {
    /// Where they cost least, a block RAM counting as much as some hundred LUTs.
    Auto,
    /// In LUTs: no table is larger than synthesis leaves there.
    Logic,
    /// In block RAMs, wherever that saves LUTs.
    Block,
}

/// How a core divides.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Divider {
    /// One quotient digit a step, by subtraction: no multiplier.
    Digit,
    /// A table of reciprocals with their slopes, and a multiplication.
    Reciprocal,
}
