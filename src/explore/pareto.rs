//! The Pareto front: the points that no other one beats in every way.

use serde::{Deserialize, Serialize};

use super::{Cost, Point};
use crate::target::LUTS_OF_A_BLOCK;

/// A cost that is to be small.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Objective {
    /// LUTs that are used up, carry chains counted.
    Lut,
    /// DSP blocks.
    Dsp,
    /// Block RAMs.
    Bram,
    /// Clocks from input to output.
    Latency,
    /// LUTs, DSP blocks and block RAMs together, as LUTs: a DSP block is 536 of them and a block RAM 402.
    Area,
}

impl Objective {
    /// Those that are counted; [`Self::Area`] follows from them.
    pub const ALL: [Self; 4] = [Self::Lut, Self::Dsp, Self::Bram, Self::Latency];

    /// This cost of a core.
    #[must_use]
    pub fn of(self, cost: &Cost) -> u32 {
        match self {
            Self::Lut => cost.lut,
            Self::Dsp => cost.dsp,
            Self::Bram => cost.bram,
            Self::Latency => cost.latency,
            Self::Area => cost.lut + LUTS_OF_A_BLOCK[0] * cost.dsp + LUTS_OF_A_BLOCK[1] * cost.bram,
        }
    }
}

/// Whether `a` is at least as good as `b` in everything and better in something; less is better.
#[must_use]
pub fn dominates(a: &[f64], b: &[f64]) -> bool {
    a.iter().zip(b).all(|(a, b)| a <= b) && a.iter().zip(b).any(|(a, b)| a < b)
}

/// The places of the points that no other point dominates in error ([`Point::max_abs`]) and these costs: from the
/// largest error to the smallest, of equals in their order. Points that failed or have no cost are not among them; of
/// points that are equal in all of it, all are.
#[must_use]
pub fn pareto(points: &[&Point], costs: &[Objective]) -> Vec<usize> {
    let values = |(place, point): (usize, &&Point)| -> Option<(usize, Vec<f64>)> {
        let cost = point.cost()?;
        let costs = costs.iter().map(|objective| f64::from(objective.of(&cost)));
        Some((place, std::iter::once(point.max_abs).chain(costs).collect()))
    };
    let all: Vec<(usize, Vec<f64>)> = points.iter().enumerate().filter_map(values).collect();
    let beaten = |own: &[f64]| all.iter().any(|(_, other)| dominates(other, own));
    let mut front: Vec<usize> = all.iter().filter(|(_, own)| !beaten(own)).map(|&(place, _)| place).collect();
    front.sort_by(|&a, &b| points[b].max_abs.total_cmp(&points[a].max_abs).then(a.cmp(&b)));
    front
}
