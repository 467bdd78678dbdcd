//! `brdfgen claims` from the outside: the recorded values, the files, what it refuses and how it ends.

use serde_json::Value;

use crate::common::Scratch;

/// The measured value of a figure in the answer's JSON.
#[track_caller]
fn figure(answer: &Value, claim: &str, name: &str) -> f64 {
    let of = |list: &Value, key: &str, wanted: &str| {
        list.as_array()
            .unwrap()
            .iter()
            .find(|item| item[key] == wanted)
            .unwrap_or_else(|| panic!("no {wanted}"))
            .clone()
    };
    of(&of(&answer["claims"], "id", claim)["measured"], "name", name)["value"].as_f64().unwrap()
}

/// The recorded values hold, and they are those that were measured apart from this program.
#[test]
fn the_recorded_values_hold() {
    let scratch = Scratch::new();
    let answer = scratch.run("claims --json").succeeds().json();
    let speeds = answer["speeds"].as_array().unwrap();
    assert_eq!(speeds.len(), 8);
    assert!(speeds.iter().all(|speed| speed["fps"].as_f64().unwrap() > 0.0 && speed["ratio"].as_f64().unwrap() > 0.0));
    assert_eq!(answer["differences"].as_array().unwrap().len(), 0);
    for (claim, name, expected, unit_of_last_digit) in [
        ("quadratic-error", "relative; n <= 512", 3.15, 0.01),
        ("quadratic-error", "relative; n <= 1000", 3.16, 0.01),
        ("cubic-relative", "relative; n <= 256", 0.689, 0.001),
        ("cubic-relative", "first n over 0.67 %", 115.0, 0.0),
        ("cubic-absolute", "absolute; n <= 256", 0.542, 0.001),
        ("cubic-absolute", "absolute; n <= 1000", 0.551, 0.001),
        ("schlick-relative", "largest by largest error", 26.0, 1.0),
        ("schlick-absolute", "largest by largest error; n <= 256", 16.65, 0.01),
        ("tail-0.42", "f the power; n <= 1000", 1.37, 0.01),
        ("tail-0.37", "f the power; n <= 1000", 3.86, 0.01),
        ("tail-0.27", "f the power; n <= 1000", 14.6, 0.1),
        ("cubic-negative", "least value; real n <= 16 by 64ths", -0.003, 0.001),
        ("min-zero", "absolute; all angles; cut at its zero; n <= 1000", 11.1, 0.1),
        ("three-point-closed-form", "a + b + c as printed; n = 25", 156.0, 1.0),
        ("three-point-operations", "multiplications of x(1 - u(A - a u))", 3.0, 0.0),
    ] {
        let got = figure(&answer, claim, name);
        assert!((got - expected).abs() <= 0.5 * unit_of_last_digit, "{claim}, {name}: {got} for {expected}");
    }
    for (claim, verdict) in [
        ("quadratic-error", "holds"),
        ("cubic-relative", "holds only for n < 115"),
        ("cubic-absolute", "holds"),
        ("schlick-relative", "holds"),
        ("schlick-absolute", "does not hold"),
        ("tail-0.27", "holds only for n < 4"),
        ("cubic-negative", "holds only for real 2 < n < 3"),
    ] {
        let claims = answer["claims"].as_array().unwrap();
        let found = claims.iter().find(|item| item["id"] == claim).unwrap();
        assert_eq!(found["verdict"], verdict, "{claim}");
    }
}

/// The run's own table is a recorded table; one changed, missing or foreign value is exit code 1 and is named.
#[test]
fn a_changed_recorded_value_is_named() {
    let scratch = Scratch::new();
    scratch.run("claims --out report").succeeds().says(&["claims,", "0 not as recorded", "charts in report"]);
    let table = scratch.text("report/claims.csv");
    scratch.run("claims --recorded report/claims.csv").succeeds().says(&["0 not as recorded"]);

    // The fourth digit may change, the third not.
    let line = "cubic-relative,relative; n <= 256,0.6892,";
    assert!(table.contains(line), "{table}");
    let changed = |to: &str| table.replacen(line, to, 1);
    scratch.write("near.csv", changed("cubic-relative,relative; n <= 256,0.6893,"));
    scratch.run("claims --recorded near.csv").succeeds();
    scratch.write("changed.csv", changed("cubic-relative,relative; n <= 256,0.6882,"));
    let run = scratch.run("claims --recorded changed.csv").ends_with(1);
    run.says(&["cubic-relative: relative; n <= 256: measured 0.6892, recorded 0.6882", "1 not as recorded"]);

    let first = table.lines().nth(1).unwrap();
    let gone = table.replacen(&format!("{first}\n"), "", 1) + "unicorns,number,1\n";
    scratch.write("gone.csv", gone);
    let answer = scratch.run("claims --json --recorded gone.csv").ends_with(1).json();
    let differences = answer["differences"].as_array().unwrap();
    assert_eq!(differences.len(), 2);
    assert!(differences[0]["claim"] == "quadratic-error" && differences[0]["recorded"].is_null());
    assert!(differences[1]["claim"] == "unicorns" && differences[1]["measured"].is_null());
}

#[test]
fn the_files_of_a_run() {
    let scratch = Scratch::new();
    scratch.run("claims --out report").succeeds();
    let files = scratch.files("report");
    for name in ["claims.csv", "error_against_n.csv", "error_against_angle.csv", "cubic_error_against_n.svg"] {
        assert!(files.iter().any(|file| file == name), "{name} is not in {files:?}");
    }
    for chart in files.iter().filter(|file| file.ends_with(".svg")) {
        let text = scratch.text(format!("report/{chart}"));
        assert!(text.starts_with("<svg") && text.trim_end().ends_with("</svg>"), "{chart}");
        assert!(text.matches("<polyline").count() > 2, "{chart} has no curves");
        assert!(text.contains("shininess n") || text.contains("angle, degrees"), "{chart} has no label");
        let picture = scratch.read(format!("report/{}", chart.replace(".svg", ".png")));
        assert!(picture.starts_with(b"\x89PNG\r\n"), "{chart} has no PNG beside it");
    }

    // Figure 4 of the images, a to d and the exact one: five different pictures.
    let pictures = ["a", "b", "c", "d", "e"].map(|name| scratch.read(format!("report/images_figure_4{name}.png")));
    for (place, picture) in pictures.iter().enumerate() {
        assert!(picture.starts_with(b"\x89PNG\r\n") && pictures[..place].iter().all(|other| other != picture));
    }
    // Speeds are timed anew each time: they are told, and in no table.
    assert!(!scratch.text("report/claims.csv").contains("images-speed"));

    let table = scratch.text("report/error_against_n.csv");
    assert_eq!(
        table.lines().next(),
        Some("n,method,max_absolute,max_absolute_epicentre,max_absolute_tail,max_relative_epicentre")
    );
    assert_eq!(table.lines().count(), 1 + 1000 * 15);
    for (row, column, expected, unit_of_last_digit) in [
        ("1000,quadratic,", 2, 0.280, 0.001),
        ("1000,quadratic,", 3, 0.045, 0.001),
        ("1000,cubic,", 3, 0.00551, 0.00001),
        ("1000,cubic-min-zero,", 2, 0.111, 0.001),
        ("3,cubic,", 3, 0.0, 1e-14),
    ] {
        let line = table.lines().find(|line| line.starts_with(row)).unwrap();
        let got: f64 = line.split(',').nth(column).unwrap().parse().unwrap();
        assert!((got - expected).abs() <= 0.5 * unit_of_last_digit, "{line}: {got} for {expected}");
    }

    // Value less power is the error, and the power is the power.
    let table = scratch.text("report/error_against_angle.csv");
    assert_eq!(table.lines().next(), Some("n,degrees,exact,method,value,error"));
    let mut lines = 0;
    for line in table.lines().skip(1) {
        let fields: Vec<&str> = line.split(',').collect();
        let number = |place: usize| fields[place].parse::<f64>().unwrap();
        let (n, angle, power, value, error) = (number(0), number(1), number(2), number(4), number(5));
        assert!((power - angle.to_radians().cos().powf(n)).abs() < 2e-5, "{line}");
        assert!((value - power - error).abs() < 1e-6 + 1e-4 * error.abs() && (0.0..=1.0).contains(&value), "{line}");
        lines += 1;
    }
    assert_eq!(lines, 5 * 201 * 15);

    // The same bytes again, into the same directory.
    let before = scratch.tree("report");
    scratch.run("claims --out report").succeeds();
    assert!(scratch.tree("report") == before, "a second run wrote something else");
}

#[test]
fn what_is_refused() {
    let scratch = Scratch::new();
    scratch.write("file", "text");
    scratch.write("other/notes.txt", "mine");
    scratch.refused("claims --out file", &["cannot use file"]);
    scratch.refused("claims --out file/report", &["cannot use file/report"]);
    scratch.refused("claims --out other", &["other is not empty and not a report of claims", "new or empty directory"]);
    scratch.refused("claims --recorded none.csv", &["cannot read none.csv"]);
    scratch.refused("claims --recorded file", &["not a table of measured claims", "claim,figure,measured"]);
    scratch.write("empty.csv", "");
    scratch.refused("claims --recorded empty.csv", &["empty.csv is empty"]);
    scratch.write("short.csv", "claim,figure,measured\ncubic-relative,0.6\n");
    scratch.refused("claims --recorded short.csv", &["too few columns", "short.csv:2"]);
    for number in ["much", "", "nan", "inf"] {
        scratch.write("word.csv", format!("claim,figure,measured\ntail-0.42,f,{number}\n"));
        scratch.refused("claims --recorded word.csv", &["the measured value is no finite number", "word.csv:2"]);
    }
}
