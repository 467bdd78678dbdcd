use brdfgen::fixed::*;
use proptest::prelude::*;

fn interval() -> impl Strategy<Value = Interval> {
    (-8.0f64..8.0, 0.0f64..4.0).prop_map(|(low, span)| Interval::new(low, low + span))
}

proptest! {
    #[test]
    fn results_hold_every_pair(a in interval(), b in interval(), s in 0.0f64..=1.0, t in 0.0f64..=1.0) {
        let pick = |i: Interval, f: f64| (i.low + f * (i.high - i.low)).clamp(i.low, i.high);
        let (x, y) = (pick(a, s), pick(b, t));
        let holds = |i: Interval, v: f64| i.low <= v && v <= i.high;
        prop_assert!(holds(a + b, x + y));
        prop_assert!(holds(a - b, x - y));
        prop_assert!(holds(a * b, x * y));
        prop_assert!(holds(a.hull(b), x) && holds(a.hull(b), y));
    }
}
