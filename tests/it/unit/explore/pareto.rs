use brdfgen::explore::Point;
use brdfgen::explore::pareto::*;
use proptest::prelude::*;

use super::results::point;

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
        let is_chosen = |(bit, _): &(usize, Objective)| chosen >> bit & 1 == 1;
        let costs: Vec<Objective> =
            Objective::ALL.into_iter().enumerate().filter(is_chosen).map(|(_, cost)| cost).collect();
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
