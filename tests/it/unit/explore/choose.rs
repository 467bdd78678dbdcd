use brdfgen::explore::choose::*;
use brdfgen::explore::{Objective, Point, Results};
use brdfgen::spec::SpecFields;
use brdfgen::target::Family;

use super::results::point;

fn constraints(max_error: f64, objective: Objective) -> Constraints {
    Constraints {
        max_error: MaxError(max_error),
        family: Family::Ecp5,
        min_mhz: None,
        objective,
        limits: Vec::new(),
        shininess: "5..=9".parse().unwrap(),
        keys: SpecFields::default(),
        baselines: false,
    }
}

/// A core for 1..=100.
fn ranged(id: &str, max_abs: f64, costs: [u32; 4], mhz: f64) -> Point {
    let text = "method = 'quadratic'\nshininess = '1..=100'";
    let spec = SpecFields::parse(text, "spec").and_then(SpecFields::resolve).unwrap().to_toml();
    Point { spec, ..point(id, max_abs, costs, mhz) }
}

fn results() -> Results {
    let baseline = Point { baseline: true, ..ranged("base", 0.001, [10, 0, 0, 2], 300.0) };
    let failed = Point { failure: Some("no".to_owned()), ..ranged("fail", 0.001, [10, 0, 0, 2], 300.0) };
    Results::new(vec![
        ranged("rough", 0.30, [50, 1, 0, 5], 200.0),
        ranged("fair", 0.05, [100, 2, 0, 7], 160.0),
        ranged("tie", 0.04, [100, 2, 0, 8], 160.0),
        ranged("wasteful", 0.06, [400, 4, 2, 9], 100.0),
        ranged("fine", 0.01, [300, 1, 1, 9], 140.0),
        ranged("finest", 0.004, [500, 3, 1, 12], 151.0),
        baseline,
        failed,
        point("materials", 0.001, [5, 0, 0, 1], 300.0),
    ])
}

fn chosen(constraints: &Constraints) -> (Option<String>, Vec<String>) {
    let choice = constraints.choose(&results()).unwrap();
    let misses = choice.misses.into_iter().map(|miss| miss.core.point.id).collect();
    (choice.chosen.map(|candidate| candidate.point.id), misses)
}

#[test]
fn the_cheapest_that_meets_the_constraints_is_chosen_and_the_nearest_misses_named() {
    // Of equals in LUTs, DSPs and block RAMs the shorter; what is dominated is no near miss.
    let (core, misses) = chosen(&constraints(0.055, Objective::Lut));
    assert_eq!((core.as_deref(), misses), (Some("fair"), vec!["rough".to_owned()]));
    let (core, misses) = chosen(&constraints(0.035, Objective::Lut));
    assert_eq!((core.as_deref(), misses), (Some("fine"), ["tie", "fair", "rough"].map(str::to_owned).to_vec()));
    assert_eq!(chosen(&constraints(0.05, Objective::Dsp)).0.as_deref(), Some("fine"));
    assert_eq!(chosen(&constraints(0.05, Objective::Bram)).0.as_deref(), Some("fair"));
    assert_eq!(chosen(&constraints(0.5, Objective::Latency)).0.as_deref(), Some("rough"));
    // 100 LUTs and two DSP blocks are less than 300, one and a block RAM, and these less than 500 and three.
    assert_eq!(chosen(&constraints(0.055, Objective::Area)).0.as_deref(), Some("fair"));
    assert_eq!(chosen(&constraints(0.035, Objective::Area)).0.as_deref(), Some("fine"));
    let of = |costs| Objective::Area.of(&point("p", 0.1, costs, 150.0).cost().unwrap());
    assert_eq!([of([100, 2, 0, 7]), of([300, 1, 1, 9])], [100 + 2 * 536, 300 + 536 + 402]);
    // The very error that is allowed is met.
    assert_eq!(chosen(&constraints(0.004, Objective::Lut)).0.as_deref(), Some("finest"));
    let (core, misses) = chosen(&constraints(0.003, Objective::Lut));
    assert_eq!((core, misses), (None, ["finest", "fine", "tie"].map(str::to_owned).to_vec()));
    let with_baselines = Constraints { baselines: true, ..constraints(0.003, Objective::Lut) };
    assert_eq!(chosen(&with_baselines).0.as_deref(), Some("base"));
}

#[test]
fn frequency_and_limits_are_constraints() {
    let fast = Constraints { min_mhz: Some(150.0), ..constraints(0.02, Objective::Lut) };
    assert_eq!(chosen(&fast).0.as_deref(), Some("finest"));
    let choice = fast.choose(&results()).unwrap();
    assert_eq!(choice.misses[0].core.point.id, "fine");
    assert_eq!(choice.misses[0].why, ["it is 10.0 MHz too slow"]);
    let small =
        Constraints { limits: vec![(Objective::Bram, 0), (Objective::Dsp, 1)], ..constraints(0.02, Objective::Lut) };
    let choice = small.choose(&results()).unwrap();
    assert_eq!((choice.meeting, choice.considered), (0, 6));
    assert_eq!(choice.misses[0].core.point.id, "fine");
    assert_eq!(choice.misses[0].why, ["it has 1 block RAM too many"]);
    assert!(choice.misses[1].why[0].starts_with("its error is 2.000 times"), "{:?}", choice.misses[1].why);
}

#[test]
fn a_baseline_that_is_named_is_considered_and_two_versions_of_a_tool_never() {
    let baseline = Point { baseline: true, ..ranged("base", 0.001, [10, 0, 0, 2], 300.0) };
    let mut results = Results::new(vec![baseline]);
    let unnamed = constraints(0.5, Objective::Lut);
    assert!(unnamed.choose(&results).is_err());
    let named = Constraints { keys: SpecFields::parse("method = 'quadratic'", "keys").unwrap(), ..unnamed.clone() };
    assert_eq!(named.choose(&results).unwrap().chosen.unwrap().point.id, "base");
    let other = Constraints { keys: SpecFields::parse("method = 'squaring'", "keys").unwrap(), ..unnamed.clone() };
    let help = format!("{:?}", other.choose(&results).unwrap_err());
    assert!(help.contains("explore --family ecp5 --method squaring --shininess '5..=9'"), "{help}");
    // A core that was not placed is of no nextpnr; two of them are one too many.
    let version = |id: &str, nextpnr: Option<&str>| {
        let mut point = ranged(id, 0.1, [50, 1, 0, 5], 200.0);
        point.synthesis.as_mut().unwrap().tools.nextpnr = nextpnr.map(str::to_owned);
        point
    };
    results = Results::new(vec![version("a", None), version("b", Some("nextpnr 1"))]);
    assert_eq!(unnamed.choose(&results).unwrap().tools.nextpnr.as_deref(), Some("nextpnr 1"));
    results = Results::new(vec![version("a", Some("nextpnr 2")), version("b", Some("nextpnr 1"))]);
    let error = unnamed.choose(&results).unwrap_err().to_string();
    assert_eq!(error, "the results hold figures of nextpnr 1 and of nextpnr 2");
}

#[test]
fn only_what_serves_the_shininess_and_has_the_keys_is_considered() {
    let keys = |text: &str| SpecFields::parse(text, "keys").unwrap();
    let refused = |constraints: Constraints| constraints.choose(&results()).unwrap_err().to_string();
    let wide = Constraints { shininess: "1..=1000".parse().unwrap(), ..constraints(0.5, Objective::Lut) };
    assert!(refused(wide).contains("no such core for ecp5 that serves the shininess 1..=1000"));
    assert!(refused(Constraints { family: Family::Ice40, ..constraints(0.5, Objective::Lut) }).contains("for ice40"));
    assert!(
        refused(Constraints { keys: keys("method = 'cubic'"), ..constraints(0.5, Objective::Lut) })
            .contains("no such core")
    );
    let named = Constraints { keys: keys("method = 'quadratic'\nname = 'mine'"), ..constraints(0.5, Objective::Lut) };
    let choice = named.choose(&results()).unwrap();
    let spec = named.spec_of(choice.chosen.as_ref().unwrap()).unwrap().resolve().unwrap();
    assert_eq!((spec.name.as_str(), spec.block.lobe().interface.shininess.to_string().as_str()), ("mine", "5..=9"));
}

#[test]
fn figures_of_two_versions_are_not_compared() {
    let mut points = results().points().to_vec();
    points.retain(|point| !point.baseline && point.failure.is_none());
    let other = points[0].synthesis.as_mut().unwrap();
    other.tools.yosys = "Yosys 0.23".to_owned();
    let error = constraints(0.5, Objective::Lut).choose(&Results::new(points)).unwrap_err();
    assert!(error.to_string().contains("Yosys 0.23 and of Yosys 0.70"), "{error}");
}

#[test]
fn errors_are_written_in_three_ways() {
    for (text, value) in [("0.01", 0.01), ("1%", 0.01), ("2^-7", 0.007_812_5), ("1e-4", 1e-4), ("1", 1.0)] {
        assert_eq!(text.parse(), Ok(MaxError(value)), "{text}");
    }
    for text in ["", "0", "-1", "200%", "2^", "x%", "nan", "inf", "2^7"] {
        assert!(text.parse::<MaxError>().is_err(), "{text}");
    }
}
