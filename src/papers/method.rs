//! The methods that the papers compare, by name.

use crate::lobe::Lobe;
use crate::method::cubic::Cubic;
use crate::method::cubic_min_zero::MinZero;
use crate::method::cubic_rational::CubicRational;
use crate::method::lyon::Lyon;
use crate::method::quadratic::Quadratic;
use crate::method::schlick::Schlick;
use crate::papers::{CosK, Taylor, TaylorSeries};
use crate::platform::error::Error;

/// A method that one of the papers proposes or compares itself with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PaperMethod {
    /// [`Quadratic`].
    Quadratic,
    /// [`Cubic`] at the level 1/2, cut to 0 past its minimum.
    Cubic,
    /// [`CubicRational`] at the level 1/2.
    CubicRational,
    /// [`Cubic::three_point`] at the paper's levels, cut to 0 past its minimum.
    ThreePoint,
    /// [`MinZero`] at the level 1/2.
    MinZero,
    /// [`Schlick`].
    Schlick,
    /// [`Lyon`] with its outer power.
    Lyon(u32),
    /// [`CosK`] with its outer power.
    CosK(u32),
    /// [`Taylor`], clamped.
    Taylor(TaylorSeries),
}

impl PaperMethod {
    /// All of them, in the order of the tables.
    pub const ALL: [Self; 15] = [
        Self::Quadratic,
        Self::Cubic,
        Self::CubicRational,
        Self::ThreePoint,
        Self::MinZero,
        Self::Schlick,
        Self::Lyon(2),
        Self::Lyon(4),
        Self::Lyon(8),
        Self::CosK(2),
        Self::CosK(4),
        Self::CosK(8),
        Self::Taylor(TaylorSeries::Chord),
        Self::Taylor(TaylorSeries::Versine3),
        Self::Taylor(TaylorSeries::Versine4),
    ];

    /// Its name in tables and plots.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Quadratic => "quadratic",
            Self::Cubic => "cubic",
            Self::CubicRational => "cubic-rational",
            Self::ThreePoint => "cubic-three-point",
            Self::MinZero => "cubic-min-zero",
            Self::Schlick => "schlick",
            Self::Lyon(2) => "lyon-2",
            Self::Lyon(4) => "lyon-4",
            Self::Lyon(_) => "lyon-8",
            Self::CosK(2) => "cos-2",
            Self::CosK(4) => "cos-4",
            Self::CosK(_) => "cos-8",
            Self::Taylor(TaylorSeries::Chord) => "taylor-chord-3",
            Self::Taylor(TaylorSeries::Versine3) => "taylor-3",
            Self::Taylor(TaylorSeries::Versine4) => "taylor-4",
        }
    }

    /// Its lobe for one shininess.
    ///
    /// # Errors
    /// A shininess that [`check_shininess`](crate::lobe::check_shininess) refuses.
    pub fn lobe(self, n: f64) -> Result<Pieces, Error> {
        // The versines where the lobe has a step or a bend.
        let (lobe, break_at): (Box<dyn Lobe>, Option<f64>) = match self {
            Self::Quadratic => {
                let lobe = Quadratic::new(n)?;
                (Box::new(lobe), Some(lobe.zero()))
            }
            Self::Cubic | Self::ThreePoint => {
                let lobe = if self == Self::Cubic { Cubic::new(n, LEVEL)? } else { three_point(n)? };
                (Box::new(lobe), lobe.cut())
            }
            Self::CubicRational => {
                let lobe = CubicRational::new(n, LEVEL)?;
                (Box::new(lobe), Some(lobe.cusp))
            }
            Self::MinZero => {
                let lobe = MinZero::new(n, LEVEL)?;
                (Box::new(lobe), Some(lobe.zero()))
            }
            Self::Schlick => (Box::new(Schlick::new(n)?), None),
            Self::Lyon(k) => (Box::new(Lyon::new(n, k)?), Some(f64::from(k) / n)),
            Self::CosK(k) => (Box::new(CosK::new(n, k)?), None),
            Self::Taylor(series) => (Box::new(Taylor::new(n, series)?), None),
        };
        Ok(Pieces { n, lobe, break_at: break_at.filter(|&u| u < 1.0) })
    }
}

/// The papers' level Q at which the cubic, its tail and the minimum-zero cubic meet the power.
pub const LEVEL: f64 = 0.5;

/// The three-point cubic at the paper's levels.
pub fn three_point(n: f64) -> Result<Cubic, Error> {
    Cubic::three_point(n, Cubic::THREE_POINT_Q, Cubic::THREE_POINT_G)
}

/// A lobe for one shininess, smooth but for one versine.
pub struct Pieces {
    /// The shininess.
    pub n: f64,
    /// The lobe.
    pub lobe: Box<dyn Lobe>,
    /// The versine below 1 after which another piece begins.
    pub break_at: Option<f64>,
}
