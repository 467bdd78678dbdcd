//! `brdfgen report` from the outside: the page, its charts, what it refuses; and the page in a browser, where there is
//! one.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

use brdfgen::core::Design;
use brdfgen::explore::sweep::Core;
use brdfgen::explore::{Point, Results};
use brdfgen::spec::SpecFields;
use brdfgen::synth::{Resources, Synthesis, Timing, Tools};
use brdfgen::target::Family;
use resvg::tiny_skia::Pixmap;
use resvg::usvg::roxmltree::{Document, ParsingOptions};

use crate::common::Scratch;

/// A small core with its real errors and costs made up from its place.
fn point(place: u32, method: &str, set: &str, g: u32, family: Family, yosys: &str) -> Point {
    let text = format!("method = '{method}'\nshininess = '{set}'\ninput_fraction = 10\noutput_fraction = {g}");
    let spec = SpecFields::parse(&text, "test").unwrap().resolve().unwrap();
    let design = Design::new(spec.clone()).unwrap();
    let mut point = Point::measured(&Core::new(spec, family), &design);
    point.name = format!("{method} <b>\"{g}\"</b> & 'co'");
    let (lut, mhz) = (40 + 37 * place, 100.0 + f64::from(place));
    let timing = Timing {
        target_mhz: 150.0,
        mhz: vec![mhz - 5.0, mhz, mhz + 5.0],
        min_mhz: mhz - 5.0,
        median_mhz: mhz,
        max_mhz: mhz + 5.0,
        limits: Vec::new(),
    };
    point.synthesis = Some(Synthesis {
        family,
        device: "a device".to_owned(),
        tools: Tools { yosys: yosys.to_owned(), nextpnr: Some("nextpnr 9 <9>".to_owned()) },
        resources: Resources {
            lut,
            carry: 0,
            lut_total: lut,
            ff: 90,
            dsp: place,
            bram: 2 * place,
            cells: BTreeMap::from([("LUT4".to_owned(), lut)]),
        },
        timing: Some(timing),
        latency_clocks: point.latency,
        latency_ns: Some(1e3 * f64::from(point.latency) / mhz),
        results_per_second: Some(mhz * 1e6),
    });
    point
}

/// Cores of two families and two versions of a tool, a set of one shininess, and one that failed.
fn results() -> Results {
    let mut points = vec![
        point(0, "quadratic", "1..=40", 8, Family::Ecp5, "Yosys 1 & 2"),
        point(1, "cubic", "1..=40", 10, Family::Ecp5, "Yosys 1 & 2"),
        point(2, "power-4", "1..=40", 12, Family::Ecp5, "Yosys 1 & 2"),
        point(3, "lyon-4", "1..=40", 12, Family::Ecp5, "Yosys 1 & 2"),
        point(4, "log-exp", "1..=40", 12, Family::Ecp5, "Yosys 3"),
        point(5, "schlick", "7", 12, Family::Ice40, "Yosys 3"),
    ];
    let mut failed = point(6, "power-2", "1..=40", 8, Family::Ecp5, "Yosys 3");
    (failed.synthesis, failed.failure) = (None, Some("it <i>did</i> not".to_owned()));
    points.push(failed);
    Results::new(points)
}

fn scratch() -> Scratch {
    let scratch = Scratch::new();
    scratch.write("r.json", results().to_json());
    scratch
}

/// The text of an element, of all elements in it.
fn text(node: resvg::usvg::roxmltree::Node) -> String {
    node.descendants().filter_map(|node| if node.is_text() { node.text() } else { None }).collect()
}

#[test]
fn the_page_is_whole_and_stands_alone() {
    let scratch = scratch();
    let constraints = "--max-error 5% --shininess 1..=40 --input-fraction 10";
    // Of one version of the tools, or nothing can be chosen.
    let mut points = results().points().to_vec();
    points.retain(|point| point.tools().is_none_or(|tools| tools.yosys == "Yosys 1 & 2"));
    let one = Results::new(points);
    scratch.write("one.json", one.to_json());
    scratch
        .run(&format!("report --results one.json --out page.html {constraints}"))
        .succeeds()
        .says(&["chosen: power-4 "]);
    let page = scratch.text("page.html");
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    let document = Document::parse_with_options(&page, options).unwrap_or_else(|error| panic!("{error}"));
    for (element, attribute) in [("script", "src"), ("link", "href"), ("img", "src"), ("a", "href"), ("image", "href")]
    {
        let outside = document.descendants().any(|node| node.has_tag_name(element) && node.has_attribute(attribute));
        assert!(!outside, "<{element} {attribute}>");
    }
    assert!(!page.contains("http:") && !page.contains("https:") && !page.contains("url(") && !page.contains("@import"));
    let tables: Vec<_> = document.descendants().filter(|node| node.has_tag_name("table")).collect();
    let rows: Vec<String> =
        tables.iter().flat_map(|table| table.descendants()).filter(|node| node.has_tag_name("tr")).map(text).collect();
    for point in one.points() {
        let lines = rows.iter().filter(|row| row.starts_with(&point.name)).count();
        assert_eq!(lines, 1, "{} in the tables", point.name);
    }
    assert!(rows.iter().any(|row| row.contains("it <i>did</i> not")));
    let marked: Vec<_> = document.descendants().filter(|node| node.attribute("class") == Some("chosen")).collect();
    assert!(marked.len() == 1 && text(marked[0]).starts_with("power-4"));
    // Every point with a cost has a mark with its name in every chart of its group, the chosen one two.
    let notes: Vec<String> = document.descendants().filter(|node| node.has_tag_name("title")).map(text).collect();
    for point in one.points().iter().filter(|point| point.cost().is_some()) {
        let marks = notes.iter().filter(|note| note.starts_with(&point.name)).count();
        assert_eq!(marks, 5, "{}", point.name);
    }
    assert_eq!(notes.iter().filter(|note| note.starts_with("chosen: power-4")).count(), 5);
    assert!(text(document.root()).contains("Yosys 1 & 2; nextpnr 9 <9>; a device"));
}

/// A small scene with one material that nothing needs.
const SCENE: &str = "width = 48\nheight = 32\n[camera]\nposition = [0, 0, 5]\n[[light]]\ndirection = [1, 1, 2]\n\
    [[material]]\nname = 'wax'\nshininess = 12.0\n[[material]]\nname = 'unused'\nshininess = 90.0\n\
    [[object]]\nkind = 'sphere'\nmaterial = 'wax'\n[core]\nmethod = 'power-4'\n";

#[test]
fn a_scene_comes_with_its_pictures_its_needs_and_its_cores() {
    let scratch = scratch();
    scratch.write("ball.toml", SCENE);
    scratch.run("report --results r.json --scene ball.toml --out page.html --plots plots").succeeds();
    let page = scratch.text("page.html");
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    let document = Document::parse_with_options(&page, options).unwrap_or_else(|error| panic!("{error}"));
    let heading = document.descendants().filter(|node| node.has_tag_name("h2")).map(text).next();
    assert_eq!(heading.as_deref(), Some("The scene ball"));
    let picture = document.descendants().find(|node| node.has_tag_name("img")).unwrap().attribute("src").unwrap();
    let encoded = picture.strip_prefix("data:image/png;base64,").unwrap();
    let png = base64::Engine::decode(&base64::engine::general_purpose::STANDARD, encoded).unwrap();
    assert!(Pixmap::decode_png(&png).unwrap().width() >= 3 * 48);
    let rows: Vec<String> = document.descendants().filter(|node| node.has_tag_name("tr")).map(text).collect();
    let of = |start: &str| rows.iter().filter(|row| row.starts_with(start)).count();
    assert_eq!([of("wax12"), of("unused90"), of("only the scene's materialsyes")], [1, 1, 1], "{rows:#?}");
    assert!(rows.iter().any(|row| row.starts_with("power-4") && row.ends_with("chosen")), "{rows:#?}");
    for chart in ["scene_ball_angle", "scene_ball_lobe"] {
        assert!(scratch.text(format!("plots/{chart}.svg")).contains("wax (n = 12)"));
    }
    scratch.write("never.toml", SCENE.replace("[core]", "[budget]\nmin_psnr = 400.0\n[core]"));
    scratch.refused("report --results r.json --scene never.toml --out x.html", &["no core keeps the budget"]);
    scratch.refused("report --results r.json --scene r.json --out x.html", &["r.json"]);
}

#[test]
fn a_material_comes_with_its_trade() {
    let scratch = scratch();
    scratch.run("report --results r.json --material lambert --out page.html --plots plots").succeeds();
    let page = scratch.text("page.html");
    assert!(page.contains("<h2>The material lambert</h2>") && page.contains("bivariate 8² sqrt:6"), "{page}");
    assert!(scratch.text("plots/material_1.svg").contains("paper: sphere images"));
    scratch.refused("report --results r.json --material lamber --out x.html", &["no reflectance model `lamber`"]);
    scratch.write("table.binary", "no table");
    scratch.refused("report --results r.json --material table.binary --out x.html", &["table.binary"]);
    scratch.refused("report --results r.json --material table.binary --out table.binary", &["table.binary"]);
}

#[test]
fn constraints_that_none_meets_are_said() {
    let scratch = scratch();
    let constraints = "--max-error 2^-20 --shininess 7 --family ice40 --input-fraction 10 --baselines";
    let run = scratch.run(&format!("report --results r.json --out page {constraints}")).ends_with(1);
    run.says(&["no core meets the constraints"]);
    assert!(!scratch.text("page/report.html").contains("The chosen core"));
    let mixed = "report --results r.json --out x --max-error 5% --shininess 1..=40";
    scratch.refused(mixed, &["figures of Yosys 1 & 2 and of Yosys 3"]);
}

#[test]
fn groups_are_those_that_may_be_compared() {
    let results = results();
    let groups = brdfgen::report::groups(results.points(), None);
    let titles: Vec<(String, usize)> = groups.iter().map(|group| (group.tools_text(), group.points.len())).collect();
    assert_eq!(groups.len(), 3, "{titles:?}");
    assert_eq!(groups.iter().map(|group| group.points.len()).collect::<Vec<_>>(), [4, 1, 1]);
    let last = results.points().last();
    assert!(brdfgen::report::groups(results.points(), last)[0].has(last), "the chosen point's group comes first");
}

#[test]
fn the_same_results_make_the_same_bytes_and_pictures_show_something() {
    let scratch = scratch();
    for name in ["a", "b"] {
        scratch.run(&format!("report --results r.json --out {name} --plots {name}/plots")).succeeds();
    }
    assert_eq!(scratch.tree("a"), scratch.tree("b"));
    let files = scratch.files("a/plots");
    // Five of each of three groups, error against n, and two for each of the shininesses near 10 and 100.
    assert_eq!(files.len(), 2 * (3 * 5 + 1 + 2 * 2), "{files:?}");
    for name in [
        "trade_ecp5_n1_40_f10_lut",
        "trade_ecp5_n1_40_f10_v2_dsp",
        "trade_ice40_n1_value_f10_latency_ns",
        "error_against_n",
    ] {
        assert!(files.contains(&format!("{name}.svg")), "{name} is not in {files:?}");
    }
    for file in files.iter().filter(|file| file.ends_with(".png")) {
        let picture = Pixmap::decode_png(&scratch.read(Path::new("a/plots").join(file))).unwrap();
        let dark = picture.pixels().iter().filter(|pixel| pixel.red() < 100 && pixel.alpha() == 255).count();
        assert!(picture.width() == 1920 && (2000..400_000).contains(&dark), "{file}: {dark} dark pixels");
        let svg = scratch.text(Path::new("a/plots").join(file.replace(".png", ".svg")));
        Document::parse(&svg).unwrap_or_else(|error| panic!("{file}: {error}"));
        assert!(!svg.contains("NaN"), "{file}");
    }
}

#[test]
fn wrong_input_is_refused() {
    let scratch = scratch();
    scratch.refused("report --results none.json --out x", &["cannot read none.json"]);
    scratch.write("bad.json", "[{}]");
    scratch.refused("report --results bad.json --out x", &["missing field"]);
    scratch.write("empty.json", "[]");
    scratch.refused("report --results empty.json --out x", &["there are no points"]);
    scratch.refused("report --results r.xml --out x", &["unknown kind of results"]);
    scratch.write("speed.csv", "a,b\n1,2\n");
    scratch.refused("report --results r.json --speed speed.csv --out x", &["missing field", "speed.csv"]);
    scratch.refused(
        "report --results r.json --family ecp5 --out x",
        &["without the error that is allowed", "--max-error"],
    );
    scratch.refused("report --results r.json --max-error 2 --out x", &["above 0 and at most 1"]);
    scratch.write("file", "");
    scratch.refused("report --results r.json --out file/x.html", &["cannot write"]);
    let mut point = results().points()[0].clone();
    point.spec = "method = 'none such'".to_owned();
    scratch.write("spec.json", Results::new(vec![point]).to_json());
    scratch.refused("report --results spec.json --out x", &["none such"]);
}

/// The columns of the first table sort by a click and by the keyboard, in a real browser.
#[test]
fn the_tables_sort_in_a_browser() {
    let Ok(version) = Command::new("chromium").arg("--version").output() else {
        eprintln!("NOT TESTED: sorting in a browser, since chromium is not installed (package chromium)");
        return;
    };
    let scratch = scratch();
    scratch.run("report --results r.json --out page.html").succeeds();
    // What a reader would do, and what is seen then, as text in the page.
    let script = r#"<script>
const buttons = Array.from(document.querySelectorAll("section table th button"));
const head = (name) => buttons.find((button) => button.textContent === name);
const column = (name) => {
  const place = head(name).closest("th").cellIndex;
  return Array.from(head(name).closest("table").tBodies[0].rows, (row) => row.cells[place].textContent).join(" | ");
};
const say = (what) => {
  const line = document.createElement("p");
  line.textContent = "SEEN " + what + " END";
  document.body.append(line);
};
head("LUTs").click(); say("up: " + column("LUTs") + " " + head("LUTs").closest("th").getAttribute("aria-sort"));
head("LUTs").click(); say("down: " + column("LUTs") + " " + head("LUTs").closest("th").getAttribute("aria-sort"));
head("method").focus(); say("focus: " + document.activeElement.textContent);
head("method").click(); say("words: " + column("method"));
say("width: " + String(document.documentElement.scrollWidth === document.documentElement.clientWidth));
</script></body>"#;
    scratch.write("try.html", scratch.text("page.html").replace("</body>", script));
    let profile = tempfile::tempdir().unwrap();
    let output = Command::new("chromium")
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-background-networking", "--disable-sync"])
        .args(["--disable-component-update", "--no-first-run", "--window-size=1400,1000", "--dump-dom"])
        .arg(format!("--user-data-dir={}", profile.path().display()))
        .arg(format!("file://{}", scratch.path("try.html").display()))
        .output()
        .unwrap();
    let page = String::from_utf8_lossy(&output.stdout);
    let seen: Vec<&str> = page.split("<p>SEEN ").skip(1).filter_map(|rest| rest.split(" END</p>").next()).collect();
    let expected = [
        "up: 40 | 77 | 114 | 151 ascending",
        "down: 151 | 114 | 77 | 40 descending",
        "focus: method",
        "words: cubic | lyon-4 (baseline) | power-4 | quadratic",
        "width: true",
    ];
    assert_eq!(
        seen,
        expected,
        "{}\n{}",
        String::from_utf8_lossy(&version.stdout),
        String::from_utf8_lossy(&output.stderr)
    );
}
