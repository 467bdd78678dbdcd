use brdfgen::explore::sweep::*;
use brdfgen::target::Family;
use toml::Value;

fn plan(text: &str) -> Plan {
    Sweep::parse(text, "sweep.toml").and_then(Sweep::expand).unwrap()
}

#[test]
fn every_valid_combination_is_a_core_once() {
    let plan = plan(
        "[[sweep]]\nmethod = ['quadratic', 'power-4', 'schlick']\ncoefficients = ['default', 'paper', \
         'minimax']\noutput_fraction = [8, 12]\n\
         [[sweep]]\nmethod = 'quadratic'\noutput_fraction = 8\nfamily = ['ecp5', 'ice40']\n",
    );
    // quadratic: paper (twice: it is the default) and minimax; power-4: minimax (twice); schlick: none; two widths
    // each; then quadratic once more for ecp5, and for ice40.
    assert_eq!(plan.combinations, 18 + 2);
    assert_eq!(plan.cores.len(), 2 * (2 + 1 + 1) + 1);
    assert_eq!(plan.repeated, 2 * 2 + 1);
    assert_eq!(plan.invalid["the method power-4 has no paper coefficients"], 2);
    assert_eq!(plan.invalid["the method schlick has no paper coefficients"], 2);
    assert_eq!(plan.invalid.values().sum::<usize>(), 6);
    assert!(plan.cores.is_sorted_by(|a, b| a.id < b.id));
    let ice: Vec<&Core> = plan.cores.iter().filter(|core| core.family == Family::Ice40).collect();
    assert_eq!(ice.len(), 1);
    assert_eq!(ice[0].spec.block.lobe().method.about().name, "quadratic");
}

#[test]
fn lists_of_a_key_are_written_as_lists_in_the_list() {
    let plan = plan(
        "[[sweep]]\nmethod = 'cubic'\nshininess = ['1..=64', [5, 12.5], '3,4', 7]\nq = [0.5, 0.6]\npipeline = ['auto', \
         9]\n\
         [[sweep]]\nmethod = 'cubic'\nmaterial = [[{ name = 'a', shininess = 3 }], [{ name = 'a', shininess = 4 }]]\n",
    );
    assert_eq!(plan.cores.len(), 4 * 2 * 2 + 2);
    let rows: Vec<usize> = plan.cores.iter().map(|core| core.spec.block.lobe().interface.shininess.rows()).collect();
    assert_eq!([64, 2, 1].map(|count| rows.iter().filter(|&&rows| rows == count).count()), [4, 8, 6]);
}

#[test]
fn flags_win_over_the_file_and_shards_share_the_whole() {
    let sweep =
        Sweep::parse("[[sweep]]\nmethod = 'cubic'\nshininess = 5\n[[sweep]]\nmethod = 'quadratic'\n", "sweep.toml");
    let mut axes = Axes::default();
    axes.set_sets(&["1..=9".to_owned(), "2,3".to_owned()]).unwrap();
    axes.set_written("output_fraction", &["8".to_owned()]).unwrap();
    axes.set_written("objective", &["default".to_owned()]).unwrap();
    let plan = sweep.unwrap().with(&axes).expand().unwrap();
    assert_eq!(plan.cores.len(), 4);
    let mut parts: Vec<Core> = (1..=3).flat_map(|index| Shard { index, of: 3 }.of(plan.cores.clone())).collect();
    parts.sort_by(|a, b| a.id.cmp(&b.id));
    assert_eq!(parts, plan.cores);
    assert!("0/3".parse::<Shard>().is_err() && "4/3".parse::<Shard>().is_err() && "1".parse::<Shard>().is_err());
}

#[test]
fn wrong_sweeps_are_named() {
    for (text, expected) in [
        ("", "missing field `sweep`"),
        ("sweep = []", "no [[sweep]] block"),
        ("[[sweep]]\nmethods = 'cubic'", "unknown key `methods`"),
        ("[[sweep]]\nmethod = 'cubik'", "cubik"),
        ("[[sweep]]\nmethod = []", "has no value"),
        ("[[sweep]]\nfamily = 'ecp6'", "there is no family"),
        ("[[sweep]]\nblock = 'shader'", "shaders"),
        ("[[sweep]]\noutput_fraction = 'many'", "output_fraction"),
        ("[[sweep]]\nmethod = 'cubic'\noutput_fraction = 99", "none of the 1 combinations"),
        ("[[sweep]\n", "unclosed"),
    ] {
        let error = Sweep::parse(text, "sweep.toml").and_then(Sweep::expand).expect_err(text);
        assert!(error.to_string().contains(expected), "{text}\n{error}\nexpected: {expected}");
    }
    let mut axes = Axes::default();
    let many: Vec<Value> = (0..400).map(|q| Value::Float(0.1 + f64::from(q) / 1000.0)).collect();
    axes.set("q", many.clone()).unwrap();
    axes.set("g", many).unwrap();
    assert!(Sweep::of(axes).expand().unwrap_err().to_string().contains("too many"));
}

#[test]
fn a_key_is_given_once_and_its_numbers_are_finite() {
    for key in ["method", "output_fraction", "family", "shininess", "pipeline", "q"] {
        let values = vec![match key {
            "method" => "quadratic".into(),
            "family" => "ecp5".into(),
            "q" => Value::Float(0.5),
            _ => Value::Integer(8),
        }];
        let mut axes = Axes::default();
        axes.set(key, values.clone()).unwrap();
        let error = axes.set(key, values).unwrap_err().to_string();
        assert_eq!(error, format!("the axis {key} is given twice"));
    }
    assert!(Axes::default().set_written("q", &["1e999".to_owned()]).is_err());
    assert!(Sweep::parse("[[sweep]]\nmethod = 'cubic'\nq = 1e999\n", "sweep.toml").is_err());
    for value in ["nan", "-inf"] {
        let error = Axes::default().set_written("q", &[value.to_owned()]).unwrap_err().to_string();
        assert!(error.starts_with("q: ") && error.ends_with("is no number that can be used"), "{value}: {error}");
        let text = format!("[[sweep]]\nmethod = 'cubic'\nq = [0.5, {value}]\n");
        let error = Sweep::parse(&text, "sweep.toml").unwrap_err().to_string();
        assert!(error.ends_with("is no number that can be used"), "{value}: {error}");
    }
}
