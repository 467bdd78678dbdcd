//! All options together: `generate`, from the spec to the directory, over specs in which every two values of two
//! options that go together do so in some spec, at the ends of the ranges that are allowed.
//!
//! Each core is made, written to disk, compiled by Icarus Verilog without a warning, analysed and elaborated by GHDL,
//! and simulated with its golden vectors; what cannot be a core is refused in words. Needs iverilog and ghdl; `test.sh`
//! installs them.
//!
//! By default the quickest cores of the set are made, and of shaders nothing is measured; with `BRDFGEN_TEST_ALL=1` all
//! of it.

use std::collections::{BTreeMap, BTreeSet};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::process::Command;
use std::sync::{LazyLock, Mutex};
use std::time::Instant;

use brdfgen::core::sample::random_codes;
use brdfgen::core::{Account, Design, Direction, Part, ShaderError};
use brdfgen::emit::package;
use brdfgen::fixed::Rng;
use brdfgen::method::METHODS;
use brdfgen::platform::error::Error;
use brdfgen::spec::{Block, CoreSpec, Interface, Language, LobeSpec, RomStyle, SpecFields};
use brdfgen::verify::cosim::{self, Job, Sim};
use brdfgen::verify::golden::{Golden, Vector};
use rayon::prelude::*;

use crate::common;
use crate::common::pairs::{Choice, Covering, covering, pairs_of};

const NOTHING: &str = "";

/// The places of the choices without which others do not go: see [`covering`].
const METHOD: usize = 0;
const HELPERS: [usize; 6] = [METHOD, 1, 2, 3, 4, 5];

/// Every method, as the line of a spec.
static METHOD_LINES: LazyLock<Vec<String>> =
    LazyLock::new(|| METHODS.iter().copied().flatten().map(|about| format!("method = '{}'", about.name)).collect());

/// What lobes and shaders both choose from: lines of a spec.
fn choices_of_all() -> Vec<Choice> {
    let choice = |name, values: &[&'static str]| Choice { name, values: values.to_vec() };
    vec![
        Choice { name: "method", values: METHOD_LINES.iter().map(String::as_str).collect() },
        choice("coefficients", &[NOTHING, "coefficients = 'paper'", "coefficients = 'minimax'"]),
        choice("output_fraction", &["output_fraction = 8", "output_fraction = 20", "output_fraction = 4"]),
        choice("accuracy", &[NOTHING, "accuracy = 3", "accuracy = 15"]),
        choice("g", &[NOTHING, "g = 0.001", "g = 0.049"]),
    ]
}

/// The rest of them.
fn more_choices() -> Vec<Choice> {
    let choice = |name, values: &[&'static str]| Choice { name, values: values.to_vec() };
    vec![
        choice("input_fraction", &["input_fraction = 8", "input_fraction = 4", "input_fraction = 24"]),
        choice("form", &[NOTHING, "form = 'paper'"]),
        choice("objective", &[NOTHING, "objective = 'max-rel:0.99'", "objective = 'weighted:-0.5'"]),
        choice("q", &[NOTHING, "q = 0.05", "q = 0.95"]),
        choice("tail", &[NOTHING, "tail = 'hold'"]),
        choice("inside", &[NOTHING, "inside = 'linear'"]),
        choice("memory", &[NOTHING, "memory = 'logic'", "memory = 'block'"]),
        choice("divider", &[NOTHING, "divider = 'reciprocal'"]),
        choice("table_bits", &[NOTHING, "table_bits = 2", "table_bits = 14"]),
        choice("log_bits", &[NOTHING, "log_bits = 2", "log_bits = 12"]),
        choice("exp_bits", &[NOTHING, "exp_bits = 2", "exp_bits = 14"]),
        choice("rom", &[NOTHING, "rom = 'file'", "rom = 'writable'"]),
        choice("rom_formats", &[NOTHING, "rom_formats = ['hex', 'coe', 'mif', 'vhdl', 'c', 'csv', 'bin']"]),
        choice("pipeline", &[NOTHING, "pipeline = 1", "pipeline = 2", "pipeline = 64"]),
        choice("languages", &[NOTHING, "languages = ['verilog']", "languages = ['vhdl']"]),
        choice("axi_stream", &[NOTHING, "axi_stream = true", "axi_stream = true\ntuser_bits = 64"]),
        choice("name", &[NOTHING, "name = 'a_name_of_the_64_characters_that_a_name_may_have_and_not_one_mor'"]),
    ]
}

/// The choices of a lobe.
fn lobe_choices() -> Vec<Choice> {
    let choice = |name, values: &[&'static str]| Choice { name, values: values.to_vec() };
    let mut choices = choices_of_all();
    choices.push(choice(
        "set",
        &[
            "shininess = [1]",
            "shininess = '1..=2'",
            "shininess = [2]",
            "shininess = '1..=20'",
            "shininess = '255..=256'",
            "shininess = '1048576..=1048576'",
            "shininess = [1048576, 1, 2.5]",
            "material = [{ name = 'one', shininess = 16 }]",
            "material = [{ name = 'a', shininess = 4 }, { name = 'b|<c>', shininess = 1 }]",
        ],
    ));
    choices.extend(more_choices());
    choices.push(choice("shininess_fraction", &[NOTHING, "shininess_fraction = 1", "shininess_fraction = 10"]));
    choices.push(choice("operand", &[NOTHING, "operand = 'versine'"]));
    choices.push(choice("input_range", &[NOTHING, "input_range = 'unit'"]));
    choices.push(choice("golden_inputs", &[NOTHING, "golden_inputs = [[0, 0], [1, 1]]"]));
    choices
}

/// The choices of a shader.
fn shader_choices() -> Vec<Choice> {
    let choice = |name, values: &[&'static str]| Choice { name, values: values.to_vec() };
    let mut choices = choices_of_all();
    choices.push(choice(
        "lights",
        &[
            "shader = { lights = 1 }",
            "shader = { lights = 8, light_colours = 'ports' }",
            "shader = { lights = 2, light_colours = [[0, 0, 0], [1, 0.5, 0.001]] }",
            "shader = { lights = 1, light_colours = 'ports' }",
        ],
    ));
    choices.extend(more_choices());
    choices.push(choice(
        "material",
        &[
            "material = [{ name = 'one', shininess = 1 }]",
            "material = [{ name = 'a', shininess = 4, ambient = 0, diffuse = 0, specular = 1 }, \
             { name = 'b', shininess = 1048576, colour = [0, 1, 0.5], specular_colour = [0, 0, 0] }]",
            "material = [{ name = 'a', shininess = 2 }, { name = 'a', shininess = 2 }, \
             { name = '|<c>&', shininess = 128 }]",
        ],
    ));
    choices.push(choice(
        "model",
        &["shader = {}", "shader = { model = 'blinn' }", "shader = { model = 'blinn', front = 'sqrt' }"],
    ));
    choices.push(choice(
        "channel_bits",
        &["shader = {}", "shader = { channel_bits = 10 }", "shader = { channel_bits = 12 }"],
    ));
    choices.push(choice(
        "vector_fraction",
        &["shader = { vector_fraction = 8 }", "shader = {}", "shader = { vector_fraction = 20 }"],
    ));
    choices.push(choice(
        "ambient_light",
        &["shader = {}", "shader = { ambient_light = [0, 0, 0] }", "shader = { ambient_light = [1, 1, 1] }"],
    ));
    choices
}

/// Specs made of choices.
struct Options {
    /// What all have.
    base: SpecFields,
    choices: Vec<Choice>,
    /// The value of each choice, read.
    read: Vec<Vec<SpecFields>>,
    /// Whether a method has a memory that could be written, by the method and whether the port holds n itself.
    writable: Mutex<BTreeMap<String, bool>>,
}

fn read(text: &str) -> SpecFields {
    SpecFields::parse(text, "choice").unwrap_or_else(|error| panic!("{error}: {text}"))
}

impl Options {
    fn of(base: &str, choices: Vec<Choice>) -> Self {
        let fields = choices.iter().map(|choice| choice.values.iter().map(|value| read(value)).collect()).collect();
        Self { base: read(base), choices, read: fields, writable: Mutex::default() }
    }

    /// The spec of a row, or why there is none.
    fn spec(&self, row: &[usize]) -> Result<CoreSpec, Error> {
        let chosen = row.iter().zip(&self.read).map(|(&value, values)| values[value].clone());
        chosen.fold(self.base.clone(), SpecFields::or).resolve()
    }

    /// Whether a row makes a spec of a core that can be written to if it is to be: what the design itself says of a
    /// small one like it.
    fn is_valid(&self, row: &[usize]) -> bool {
        let Ok(spec) = self.spec(row) else { return false };
        if spec.rom != RomStyle::Writable {
            return true;
        }
        let LobeSpec { method, interface } = spec.block.lobe().clone();
        let accuracy = method.options().accuracy;
        let key = format!("{:?} {accuracy:?} {:?}", method.name(), interface.shininess);
        let small = || {
            let (f, g) =
                (interface.input_fraction.min(8), interface.output_fraction.min(accuracy.map_or(8, |a| a + 1)));
            let interface = Interface { input_fraction: f, output_fraction: g, ..interface };
            // No shader can be written.
            let block = Block::Lobe(LobeSpec { method, interface });
            let small = CoreSpec { block, golden_inputs: Default::default(), ..spec };
            Design::new(small).is_ok()
        };
        *self.writable.lock().expect("no panic").entry(key).or_insert_with(small)
    }

    fn text(&self, row: &[usize]) -> String {
        let values = row.iter().zip(&self.choices).map(|(&value, choice)| choice.values[value]);
        values.filter(|value| !value.is_empty() && *value != "shader = {}").collect::<Vec<_>>().join("; ")
    }

    fn covering(&self) -> Covering {
        let covering = covering(&self.choices, &HELPERS, &|row| self.is_valid(row));
        // What does not go together says why, whatever is asked of it.
        for &((a, value_a), (b, value_b)) in &covering.impossible {
            let mut row = vec![0; self.choices.len()];
            (row[a], row[b]) = (value_a, value_b);
            if let Err(error) = self.spec(&row) {
                assert_clear(&error, &self.text(&row));
            }
        }
        covering
    }
}

/// One sentence of what is wrong, and another of what is allowed.
#[track_caller]
fn assert_clear(error: &Error, spec: &str) {
    let Error::Input { what, allowed } = error else { panic!("{spec}: {error:?}") };
    for text in [what, allowed] {
        assert!(text.len() > 3 && !text.contains('\n') && !text.contains("{}"), "{spec}: {error:?}");
    }
}

/// What becomes of a spec.
enum Made {
    Core,
    Refused(String),
    Wrong(String),
}

/// A shader's account without a measurement and some vectors of random codes: the whole of both takes a minute a
/// shader.
fn sketched(design: &Design) -> (Account, Golden) {
    let part = |name| Part { name, meaning: "", codes: [0.0; 2], rms: 0.0 };
    let account = Account::Shader(ShaderError { samples: 1, parts: vec![part("part")], whole: part("whole") });
    let ports = design.numbers(Direction::In);
    let mut rng = Rng::new(0);
    let vector = |stall| {
        let inputs = random_codes(&ports, &mut rng);
        Vector { outputs: design.evaluate(&inputs), inputs, idle: 0, stall }
    };
    let vectors = (0..64).map(|place| u32::from(place % 8 == 0)).map(vector).collect();
    let (core, spec_digest) = (design.spec.name.clone(), design.spec.digest());
    (account, Golden { core, spec_digest, groups: vec![("random codes".to_owned(), vectors)], digests: Vec::new() })
}

/// `generate`, and what tools say of the result. A shader is measured only if `whole`.
fn make(spec: &CoreSpec, whole: bool) -> Result<Made, Error> {
    let design = match Design::new(spec.clone()) {
        Ok(design) => design,
        Err(error) => {
            assert_clear(&error, &spec.to_toml());
            return Ok(Made::Refused(error.to_string()));
        }
    };
    let (account, golden) = if whole || spec.block.shader().is_none() {
        (Account::of(&design), Golden::of(&design))
    } else {
        sketched(&design)
    };
    if let Account::Lobe { measured, .. } = &account {
        let ([low, high], [least, most]) = (design.lobe().budget.proved_ulps, measured.ulps);
        if least < low - 1e-6 || most > high + 1e-6 {
            return Ok(Made::Wrong(format!("measured {least}..{most} ulp, proved {low}..{high}")));
        }
    }
    let files = package::files(&design, &account, &golden)?;
    let scratch = tempfile::tempdir().expect("a directory");
    let directory = scratch.path().join("core");
    package::write_directory(&directory, &files)?;
    let outcome = cosim::golden(Sim::Builtin, &Job { design: &design, golden: &golden, directory: &directory })?;
    if !outcome.passed() || outcome.vectors == 0 {
        return Ok(Made::Wrong(format!("{outcome:?}")));
    }
    // The directory says itself what it is made from.
    let again = SpecFields::read(&directory.join("core.toml")).and_then(SpecFields::resolve)?;
    if again != *spec {
        return Ok(Made::Wrong(format!("core.toml is another spec:\n{}", again.to_toml())));
    }
    Ok(match spec.languages.iter().find_map(|&language| complaint(&design, language, &directory)) {
        Some(complaint) => Made::Wrong(complaint),
        None => Made::Core,
    })
}

/// What a compiler says of a core, its wrapper and their benches.
fn complaint(design: &Design, language: Language, directory: &Path) -> Option<String> {
    let name = &design.spec.name;
    let parts = package::Part::of(design);
    let rtl: Vec<String> = parts.iter().map(|part| part.rtl_path(design, language)).collect();
    let benches: Vec<String> = parts.iter().map(|part| part.bench_path(design, language)).collect();
    let run = |program: &str, arguments: &[&str], files: &[String]| {
        let mut command = Command::new(program);
        command.current_dir(directory).args(arguments).args(files);
        let output = command.output().unwrap_or_else(|error| panic!("{program}: {error}"));
        let said = [output.stdout, output.stderr].concat();
        let said = String::from_utf8_lossy(&said).into_owned();
        (!output.status.success() || !said.is_empty())
            .then(|| format!("{program} {} {}: {}\n{said}", arguments.join(" "), files.join(" "), output.status))
    };
    match language {
        Language::Verilog => run("iverilog", &["-g2005", "-Wall", "-o", "core.vvp"], &rtl)
            .or_else(|| run("iverilog", &["-g2005", "-o", "bench.vvp"], &[rtl, benches].concat())),
        Language::Vhdl => {
            let tops: Vec<String> = match design.spec.axi_stream {
                Some(_) => vec![format!("{name}_tb"), format!("{name}_axis_tb")],
                None => vec![format!("{name}_tb")],
            };
            run("ghdl", &["-a", "--std=08"], &[rtl, benches].concat())
                .or_else(|| tops.into_iter().find_map(|top| run("ghdl", &["-e", "--std=08"], &[top])))
        }
    }
}

/// A rough measure of how long a core takes to be made, as a power of two: the codes of both ports, and the entries of
/// its tables.
fn size(spec: &CoreSpec) -> u32 {
    let LobeSpec { method, interface } = spec.block.lobe();
    let options = method.options();
    let entries = [options.table_bits, options.log_bits, options.exp_bits].into_iter().flatten().max().unwrap_or(0);
    interface.shininess.index_bits() + interface.input_fraction.max(entries)
}

fn all_is_made(what: &str, options: &Options, quick: impl Fn(&CoreSpec) -> bool) {
    let begun = Instant::now();
    let covering = options.covering();
    let searched = begun.elapsed();
    let all = common::all();
    println!("{what}: {} specs ({searched:.1?})", covering.rows.len());
    let specs: Vec<(&Vec<usize>, CoreSpec)> = covering
        .rows
        .iter()
        .map(|row| (row, options.spec(row).expect("rows are valid")))
        .filter(|(_, spec)| all || quick(spec))
        .collect();
    let made: Vec<(Made, f64)> = specs
        .par_iter()
        .map(|(row, spec)| {
            let begun = Instant::now();
            let made = catch_unwind(AssertUnwindSafe(|| make(spec, all)));
            let made = match made {
                Ok(Ok(made)) => made,
                Ok(Err(error)) => Made::Wrong(error.to_string()),
                Err(panic) => {
                    let text = panic.downcast_ref::<String>().cloned();
                    let text = text.or_else(|| panic.downcast_ref::<&str>().map(|&text| text.to_owned()));
                    Made::Wrong(format!("panic: {}", text.unwrap_or_default()))
                }
            };
            let seconds = begun.elapsed().as_secs_f64();
            if std::env::var_os("BRDFGEN_TEST_PROGRESS").is_some() {
                let said = match &made {
                    Made::Core => "made",
                    Made::Refused(why) | Made::Wrong(why) => why,
                };
                println!("{seconds:.1} s: {}: {said}", options.text(row).replace('\n', "; "));
            }
            (made, seconds)
        })
        .collect();
    let mut covered = BTreeSet::new();
    let (mut cores, mut refused, mut wrong) = (0, BTreeMap::<&str, usize>::new(), Vec::new());
    for ((row, _), (made, _)) in specs.iter().zip(&made) {
        match made {
            Made::Core => {
                cores += 1;
                covered.extend(pairs_of(row));
            }
            Made::Refused(why) => {
                *refused.entry(why).or_default() += 1;
                covered.extend(pairs_of(row));
            }
            Made::Wrong(why) => wrong.push(format!("{}\n    {why}", options.text(row))),
        }
    }
    println!(
        "{what}: {} pairs of values go together and {} do not, in {} specs; here {cores} cores made and {} refused, \
         {} pairs, {:.1?}",
        covering.pairs.len(),
        covering.impossible.len(),
        covering.rows.len(),
        refused.values().sum::<usize>(),
        covered.len(),
        begun.elapsed()
    );
    for (why, count) in &refused {
        println!("  {count} refused: {why}");
    }
    let mut slow: Vec<(f64, &Vec<usize>)> = made.iter().zip(&specs).map(|((_, s), (row, _))| (*s, *row)).collect();
    slow.sort_by(|a, b| b.0.total_cmp(&a.0));
    for (seconds, row) in slow.iter().take(4) {
        println!("  {seconds:.1} s: {}", options.text(row));
    }
    assert!(wrong.is_empty(), "{} of {} are wrong:\n{}", wrong.len(), specs.len(), wrong.join("\n"));
    let left: Vec<String> = covering
        .pairs
        .difference(&covered)
        .map(|&((a, _), (b, _))| format!("{} and {}", options.choices[a].name, options.choices[b].name))
        .collect();
    assert!(!all || left.is_empty(), "left out: {}", left.join(", "));
}

#[test]
fn lobes_with_any_two_options() {
    all_is_made("lobes", &Options::of("", lobe_choices()), |spec| size(spec) <= 9);
}

#[test]
fn shaders_with_any_two_options() {
    let quick = |spec: &CoreSpec| {
        let LobeSpec { method, interface } = spec.block.lobe();
        interface.input_fraction < 24 && method.options().accuracy.is_none() && interface.output_fraction < 20
    };
    all_is_made("shaders", &Options::of("block = 'shader'", shader_choices()), quick);
}

/// Of three choices of two values each, four rows cover all pairs, fewer do not; what does not go together is known.
#[test]
fn coverings_cover() {
    let choice = |name| Choice { name, values: vec!["", "one"] };
    let choices = [choice("a"), choice("b"), choice("c")];
    let whole = covering(&choices, &[0], &|_| true);
    assert_eq!((whole.pairs.len(), whole.impossible.len()), (12, 0));
    assert!((4..=5).contains(&whole.rows.len()), "{:?}", whole.rows);
    // b needs a.
    let part = covering(&choices, &[0], &|row| row[1] == 0 || row[0] == 1);
    assert_eq!(part.impossible, [((0, 0), (1, 1))]);
    assert_eq!(part.pairs.len(), 11);
    assert!(part.rows.iter().all(|row| row[1] == 0 || row[0] == 1), "{:?}", part.rows);
    let covered: BTreeSet<_> = part.rows.iter().flat_map(|row| pairs_of(row)).collect();
    assert_eq!(covered, part.pairs);
}
