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

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::results::tests::point;
    use super::*;

    fn front(points: &[Point], costs: &[Objective]) -> Vec<String> {
        let all: Vec<&Point> = points.iter().collect();
        pareto(&all, costs).into_iter().map(|place| points[place].id.clone()).collect()
    }

    #[test]
    fn the_front_of_points_made_by_hand() {
        let mut points = vec![
            point("a", 0.10, [100, 2, 0, 7], 150.0),
            point("b", 0.10, [120, 1, 0, 7], 150.0),
            point("c", 0.20, [100, 2, 0, 7], 150.0),
            point("d", 0.05, [300, 2, 1, 6], 150.0),
            point("e", 0.05, [300, 2, 1, 6], 150.0),
            point("f", 0.01, [50, 0, 0, 1], 150.0),
        ];
        // The best of all has failed.
        points[5].failure = Some("it ran out of memory".to_owned());
        assert_eq!(front(&points, &[Objective::Lut]), ["a", "d", "e"]);
        assert_eq!(front(&points, &[Objective::Dsp]), ["b", "d", "e"]);
        assert_eq!(front(&points, &[Objective::Lut, Objective::Dsp]), ["a", "b", "d", "e"]);
        assert_eq!(front(&points, &[Objective::Latency]), ["d", "e"]);
        assert_eq!(front(&points, &[]), ["d", "e"]);
        points[5].failure = None;
        assert_eq!(front(&points, &Objective::ALL), ["f"]);
    }

    proptest! {
        #[test]
        fn no_point_of_the_front_is_dominated_and_every_other_one_is(
            values in proptest::collection::vec((1u32..6, 0u32..5, 0u32..4, 0u32..3, 1u32..6), 1..24),
            chosen in 0usize..16,
        ) {
            let made = |&(error, lut, dsp, bram, latency): &(u32, u32, u32, u32, u32)| {
                point("p", f64::from(error) / 100.0, [lut, dsp, bram, latency], 150.0)
            };
            let points: Vec<Point> = values.iter().map(made).collect();
            let all: Vec<&Point> = points.iter().collect();
            let costs: Vec<Objective> =
                Objective::ALL.into_iter().enumerate().filter(|(bit, _)| chosen >> bit & 1 == 1).map(|(_, cost)| cost).collect();
            let front = pareto(&all, &costs);
            prop_assert!(!front.is_empty());
            // Written out once more, in whole numbers.
            let better = |a: usize, b: usize| {
                let of = |place: usize| {
                    let (error, lut, dsp, bram, latency) = values[place];
                    let on = |bit: usize, value: u32| if chosen >> bit & 1 == 1 { value } else { 0 };
                    [error, on(0, lut), on(1, dsp), on(2, bram), on(3, latency)]
                };
                (0..5).all(|i| of(a)[i] <= of(b)[i]) && of(a) != of(b)
            };
            for own in 0..points.len() {
                let dominated = (0..points.len()).any(|other| better(other, own));
                prop_assert_eq!(front.contains(&own), !dominated, "point {} of {:?}", own, values);
            }
            prop_assert!(front.windows(2).all(|pair| points[pair[0]].max_abs >= points[pair[1]].max_abs));
        }
    }
}
