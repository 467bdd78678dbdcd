use std::collections::BTreeMap;
use std::path::Path;

use brdfgen::explore::{Estimate, Point, Results, Shape};
use brdfgen::spec::SpecFields;
use brdfgen::synth::{Resources, Synthesis, Timing, Tools};
use brdfgen::target::Family;

/// A point with the given spec, error and costs.
pub fn point(id: &str, max_abs: f64, [lut, dsp, bram, latency]: [u32; 4], mhz: f64) -> Point {
    let spec = SpecFields::parse("method = 'power-4'\n[[material]]\nname = 'a, \"b\"'\nshininess = 5.5", "spec")
        .and_then(SpecFields::resolve)
        .unwrap();
    let tools = Tools { yosys: "Yosys 0.70, one".to_owned(), nextpnr: Some("nextpnr-ecp5 0.11".to_owned()) };
    let cells = BTreeMap::from([("LUT4".to_owned(), lut), ("TRELLIS_FF".to_owned(), 90)]);
    Point {
        id: id.to_owned(),
        name: format!("power-4 {id}"),
        family: Family::Ecp5,
        method: "power-4".to_owned(),
        coefficients: "minimax".to_owned(),
        variant: "inside=linear".to_owned(),
        baseline: false,
        shininess: "1 material".to_owned(),
        rows: 1,
        input_fraction: 16,
        output_fraction: 16,
        pipeline: "auto".to_owned(),
        max_abs,
        max_rel: 0.1 + 0.2,
        rms: max_abs / 3.0,
        worst_n: 5.5,
        worst_x: 0.987_654_321,
        checked: "exhaustive".to_owned(),
        bound: 1.4e-5,
        rom_bits: 100,
        latency,
        shape: Shape {
            multipliers: vec!["18x17".parse().unwrap(), "19x12s".parse().unwrap()],
            memories: vec!["1024x24r".parse().unwrap(), "16x9".parse().unwrap()],
            adder_bits: 40,
            mux_bits: 30,
            shift_bits: 20,
            register_bits: 200,
        },
        synthesis: Some(Synthesis {
            family: Family::Ecp5,
            device: "LFE5U-85F".to_owned(),
            tools: tools.clone(),
            resources: Resources { lut, carry: 0, lut_total: lut, ff: 90, dsp, bram, cells },
            timing: Some(Timing {
                target_mhz: 150.0,
                mhz: vec![mhz - 1.0, mhz, mhz + 1.1],
                min_mhz: mhz - 1.0,
                median_mhz: mhz,
                max_mhz: mhz + 1.1,
                limits: Vec::new(),
            }),
            latency_clocks: latency,
            latency_ns: Some(1000.0 * f64::from(latency) / mhz),
            results_per_second: Some(mhz * 1e6),
        }),
        estimate: Some(Estimate { tools, points: 9, lut: lut + 1, ff: 91, dsp, bram, mhz: None }),
        failure: None,
        spec: spec.to_toml(),
    }
}

#[test]
fn points_survive_csv_and_json() {
    let bare = Point {
        synthesis: None,
        estimate: None,
        failure: Some("no, \"none\"\nat all".to_owned()),
        ..point("b", 0.0, [1, 0, 0, 3], 100.0)
    };
    let results = Results::new(vec![bare, point("a", 0.1, [100, 2, 0, 7], 151.3)]);
    assert_eq!(results.points()[0].id, "a");
    let csv = results.to_csv();
    assert_eq!(csv.lines().count(), 4, "a line a point but for the failure's own line break\n{csv}");
    assert_eq!(Results::from_csv(&csv, "a.csv").unwrap(), results);
    assert_eq!(Results::from_json(&results.to_json(), "a.json").unwrap(), results);
}

#[test]
fn wrong_files_are_named_with_the_line() {
    let csv = Results::new(vec![point("a", 0.1, [100, 2, 0, 7], 151.3)]).to_csv();
    for (text, expected) in [
        (csv.replacen("ecp5", "ecp9", 1), "ecp9"),
        (csv.replacen("TRELLIS_FF=90", "TRELLIS_FF", 1), "not CELL=COUNT"),
        (csv.replacen("name", "nom", 1), "missing field"),
        (csv.replacen("power-4\"", "power-5\"", 1), "power-5"),
        (String::new(), "a.csv, line 1: there is no line of headings"),
        (csv.replacen(",16,16,auto,", ",16,auto,", 1), "a.csv, line 2: it has 53 fields, where the headings are 54"),
        (csv.replacen("exhaustive,0.000014", "exhaustive,x", 1), "a.csv, line 2: bound: \"x\" is no number"),
        (csv.replacen(",16,16,auto,0.1,", ",16,16,auto,NaN,", 1), "a.csv, line 2: the point a says max_abs is NaN"),
        (csv.replacen(",16,16,auto,0.1,", ",16,16,auto,-1,", 1), "the point a says max_abs is -1"),
        (csv.replacen(",16,16,auto,0.1,", ",16,16,auto,1e999,", 1), "the point a says max_abs is inf, where a finite"),
        (csv.replacen("5.5,0.987654321", "-1,0.987654321", 1), "says worst_n is -1, where a finite number of 0"),
        (csv.replacen("5.5,0.987654321", "5.5,9e875", 1), "says worst_x is inf, where a finite number is needed"),
        (csv.replacen(",100,100,0,90,", ",100,-1,0,90,", 1), "line 2: lut: \"-1\" is no count, a whole number from 0"),
        (csv.replacen(",100,100,0,90,", ",100,1.5,0,90,", 1), "line 2: lut: \"1.5\" is no count"),
        (csv.replacen(",100,100,0,90,", ",100,,0,90,", 1), "line 2: the synthesis has no lut, and has the rest"),
        (csv.replacen(",150.3,151.3,152.4", ",150.3,,152.4", 1), "line 2: the placement has no median_mhz, and has"),
        (csv.replacen(",150.3,151.3,152.4", ",0,0,0", 1), "says min_mhz is 0, where a finite number above 0 is needed"),
        (csv.replacen(",150.3,151.3,152.4", ",150.3,-0.0,152.4", 1), "says median_mhz is -0, where"),
        (csv.replacen(",150.3,151.3,152.4", ",150.3,149,152.4", 1), "150.3, 149 and 152.4, out of order"),
        (csv.replacen("150.3 151.3 152.4", "150.3 inf 152.4", 1), "says mhz_by_seed is inf"),
        (csv.replace(',', ";"), "columns are separated by commas and this has semicolons"),
        (csv.clone() + "\n\n" + csv.lines().nth(1).unwrap_or_default(), "a.csv, line 5: the point a is there twice"),
        (
            csv.replace('\n', "\r\n") + csv.lines().nth(1).unwrap_or_default(),
            "a.csv, line 3: the point a is there twice",
        ),
    ] {
        let error = Results::from_csv(&text, "a.csv").expect_err(expected);
        assert!(error.to_string().contains(expected), "{error}, expected: {expected}");
    }
    assert!(Results::from_json("[{}]", "a.json").is_err());
    let json = Results::new(vec![point("a", 0.1, [100, 2, 0, 7], 151.3)]).to_json();
    for (from, to, expected) in [
        ("\"median_mhz\": 151.3", "\"median_mhz\": 0", "a.json: the point a says median_mhz is 0, where"),
        ("\"median_mhz\": 151.3", "\"median_mhz\": 1e999", "number out of range"),
        ("\"lut\": 100", "\"lut\": -1", "invalid value: integer `-1`"),
        ("\"max_abs\": 0.1", "\"max_abs\": null", "invalid type: null"),
    ] {
        let changed = json.replacen(from, to, 1);
        assert_ne!(changed, json, "{from}");
        let error = Results::from_json(&changed, "a.json").expect_err(expected);
        assert!(error.to_string().contains(expected), "{error}, expected: {expected}");
    }
    assert!(Results::read(Path::new("results.xml")).unwrap_err().to_string().contains("unknown kind"));
}

#[test]
fn the_built_in_points_are_read() {
    assert!(Results::built_in().is_ok());
}
