//! The rules of the house, read off the sources: rooms stand one above the other and use only what is below them; a
//! method's model and its datapath know nothing of each other; only the commands print; only `platform` makes commands
//! of programs; no file is longer and no line wider than one takes in.

use std::path::Path;

/// The rooms, each above all that it uses. A folder within a room that stands elsewhere has its own place.
const ROOMS: [&str; 26] = [
    "platform",
    "plot",
    "fixed",
    // Words and files alone: what a spec names formats by.
    "emit/rom",
    "lobe",
    "target",
    "datapath",
    "fit",
    "method",
    "reflectance",
    "block",
    "spec",
    "core",
    "emit",
    "synth",
    "verify/faults",
    "verify/golden",
    "verify/kernel",
    "verify/cosim",
    "verify/formal",
    "verify/stability",
    "generate",
    "explore",
    "scene",
    "papers",
    "report",
];

/// What the commands and the program are: above everything.
const TOP: [&str; 2] = ["cli", "main"];

/// The columns of a line and the lines of a file, at most.
const WIDTH: usize = 120;
const LENGTH: usize = 600;

/// A file of the sources: its path in `src` without the ending, and its text.
struct Source {
    path: String,
    text: String,
}

/// The place in the order of what a path, of a file or of a module, lies in: the room whose name is the longest
/// beginning of it.
fn room(path: &str) -> Option<usize> {
    let lies_in = |room: &str| path.strip_prefix(room).is_some_and(|rest| rest.is_empty() || rest.starts_with('/'));
    (0..ROOMS.len()).filter(|&place| lies_in(ROOMS[place])).max_by_key(|&place| ROOMS[place].len())
}

fn is_top(path: &str) -> bool {
    TOP.iter().any(|top| path == *top || path.strip_prefix(top).is_some_and(|rest| rest.starts_with('/')))
}

/// The text without comments and without the tests at its end.
fn code(text: &str) -> String {
    let own = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default();
    own.lines().map(|line| line.split("//").next().unwrap_or_default()).collect::<Vec<_>>().join("\n")
}

fn is_word(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}

/// The paths that code names from `root::` on, with slashes; of a list in braces one for each item.
fn named(code: &str, root: &str) -> Vec<String> {
    let mut paths = Vec::new();
    for (at, _) in code.match_indices(root) {
        if code[..at].ends_with(|c: char| is_word(c) || c == ':') {
            continue;
        }
        let rest = &code[at + root.len()..];
        let plain = rest.find(|c: char| !is_word(c) && c != ':').unwrap_or(rest.len());
        let path = rest[..plain].trim_end_matches(':').replace("::", "/");
        match rest[plain..].strip_prefix('{') {
            Some(list) => {
                let list = list.split('}').next().unwrap_or_default();
                paths.extend(list.split(',').map(|item| {
                    let first: String = item.trim().chars().take_while(|&c| is_word(c)).collect();
                    format!("{path}/{first}").trim_matches('/').trim_end_matches("/self").to_owned()
                }));
            }
            None => paths.push(path),
        }
    }
    paths
}

/// What breaks a rule.
fn complaints(sources: &[Source]) -> Vec<String> {
    let mut complaints = Vec::new();
    for Source { path, text } in sources {
        let code = code(text);
        let mut complain = |what: String| complaints.push(format!("src/{path}.rs {what}"));
        let used = named(&code, "crate::");
        if !is_top(path) && path != "lib" {
            let own = room(path);
            if own.is_none() && path != "verify/mod" {
                complain("is in no room".to_owned());
            }
            for used in &used {
                let above = is_top(used) || room(used).zip(own).is_some_and(|(used, own)| used > own);
                if above {
                    complain(format!("uses {used}, which stands above it"));
                }
            }
            if ["println!", "print!", "eprintln!", "eprint!", "stdout()", "stderr()"]
                .iter()
                .any(|word| code.contains(word))
            {
                complain("prints".to_owned());
            }
        }
        let file = path.rsplit('/').next().unwrap_or_default();
        let relative: Vec<String> = ["crate::", "super::"].iter().flat_map(|root| named(&code, root)).collect();
        let uses = |module: &str| relative.iter().any(|path| path.split('/').any(|part| part == module));
        let in_method = path.starts_with("method/") || path.starts_with("block/");
        if in_method && file == "model" && uses("datapath") {
            complain("is a model and uses a datapath".to_owned());
        }
        if in_method && file == "datapath" && uses("model") {
            complain("is a datapath and uses a model".to_owned());
        }
        let is_bits =
            |path: &String| (path.starts_with("fixed") && path != "fixed/exp2") || path.starts_with("datapath");
        if in_method && file == "lobe" && used.iter().any(is_bits) {
            complain("is a lobe and knows bits".to_owned());
        }
        if !path.starts_with("platform/") && code.contains("process::") && code.contains("Command::new(") {
            complain("makes a command of a program".to_owned());
        }
    }
    complaints
}

fn sources_in(directory: &Path, root: &Path, sources: &mut Vec<Source>) {
    for entry in std::fs::read_dir(directory).expect("the sources") {
        let path = entry.expect("an entry").path();
        let name = path.strip_prefix(root).expect("within").with_extension("").to_string_lossy().replace('\\', "/");
        if path.is_dir() {
            sources_in(&path, root, sources);
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            sources.push(Source { path: name, text: std::fs::read_to_string(&path).expect("text") });
        }
    }
}

/// What is too large, of any sources.
fn too_large(sources: &[Source]) -> Vec<String> {
    let of = |Source { path, text }: &Source| {
        let lines = text.lines().count();
        let long = (lines > LENGTH).then(|| format!("{path}.rs has {lines} lines, more than {LENGTH}"));
        let wide = text.lines().enumerate().filter(|(_, line)| line.chars().count() > WIDTH);
        let wide = wide.map(|(place, _)| format!("{path}.rs:{} is wider than {WIDTH} columns", place + 1));
        long.into_iter().chain(wide).collect::<Vec<_>>()
    };
    sources.iter().flat_map(of).collect()
}

fn sources_of(folder: &str) -> Vec<Source> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut sources = Vec::new();
    sources_in(&root, &root, &mut sources);
    sources
}

#[test]
fn the_sources_keep_the_rules() {
    let sources = sources_of("src");
    assert!(sources.len() > 200, "{} sources", sources.len());
    let complaints = complaints(&sources);
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
    for folder in ["src", "tests", "examples", "benches", "fuzz"] {
        let complaints = too_large(&sources_of(folder));
        assert!(complaints.is_empty(), "{folder}: {}", complaints.join("\n"));
    }
}

#[test]
fn each_rule_that_is_broken_is_named() {
    for (path, text, expected) in [
        ("fixed/format", "use crate::spec::CoreSpec;", "uses spec/CoreSpec, which stands above"),
        ("spec/fields", "use crate::emit::{rom, Texts};", "uses emit/Texts, which stands above"),
        ("verify/faults/mod", "fn f() { crate::verify::cosim::run() }", "uses verify/cosim/run, which stands above"),
        ("report/page", "use crate::cli::say;", "uses cli/say, which stands above"),
        ("bits", "", "is in no room"),
        ("method/cubic/model", "use super::datapath::Stable;", "is a model and uses a datapath"),
        ("method/cubic/model", "use crate::datapath::graph::Graph;", "is a model and uses a datapath"),
        ("method/cubic/datapath", "use crate::method::cubic::model::stable;", "is a datapath and uses a model"),
        ("method/cubic/lobe", "use crate::fixed::Format;", "is a lobe and knows bits"),
        ("scene/frame", "fn f() { println!(\"done\"); }", "prints"),
        ("synth/yosys", "use std::process::Command;\nfn f() { Command::new(\"yosys\"); }", "makes a command"),
    ] {
        let found = complaints(&[Source { path: path.to_owned(), text: text.to_owned() }]);
        assert!(found.len() == 1 && found[0].contains(expected), "{path}: {found:?}");
    }
    for (text, expected) in [("\n".repeat(LENGTH + 1), "has 601 lines"), ("é".repeat(WIDTH + 1), "a.rs:1 is wider")] {
        let found = too_large(&[Source { path: "a".to_owned(), text }]);
        assert!(found.len() == 1 && found[0].contains(expected), "{found:?}");
    }
    let largest = Source { path: String::new(), text: format!("{}\n", "é".repeat(WIDTH)).repeat(LENGTH) };
    assert!(too_large(&[largest]).is_empty());
    for (path, text) in [
        ("spec/fields", "use crate::emit::rom::RomFormat;\n// crate::cli says\nuse crate::platform::{error, input};"),
        ("method/harris/lobe", "use crate::fixed::exp2;"),
        ("cli/eval", "fn f() { println!(\"{}\", crate::core::Design::ID); }"),
        ("fixed/table", "fn f() {}\n#[cfg(test)]\nmod tests {\n    use crate::spec::CoreSpec;\n}"),
    ] {
        let found = complaints(&[Source { path: path.to_owned(), text: text.to_owned() }]);
        assert!(found.is_empty(), "{path}: {found:?}");
    }
}
