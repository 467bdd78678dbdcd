//! A temporary directory in which the built program runs, and what it answers.

pub mod core;
pub mod matcap;
pub mod pairs;

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use assert_cmd::Command;
use resvg::tiny_skia::Pixmap;
use serde_json::Value;

/// The content of a directory by path: a file's bytes, or `None` for a directory.
pub type Tree = BTreeMap<PathBuf, Option<Vec<u8>>>;

/// Whether sets of cores and inputs are to be run whole (`./test.sh --all`), and not the part that every change has to
/// pass.
pub fn all() -> bool {
    std::env::var_os("BRDFGEN_TEST_ALL").is_some_and(|value| value == "1")
}

/// The pixels of a picture's file.
#[track_caller]
pub fn pixels(png: &[u8]) -> Vec<[i64; 3]> {
    let picture = Pixmap::decode_png(png).unwrap();
    picture.pixels().iter().map(|pixel| [pixel.red(), pixel.green(), pixel.blue()].map(i64::from)).collect()
}

/// How a run of the program ended and what it printed.
pub struct Run {
    /// The exit code.
    pub code: i32,
    /// Standard output.
    pub stdout: String,
    /// Standard error.
    pub stderr: String,
}

impl Run {
    /// Requires an exit code, and an answer in words and not in a panic.
    #[track_caller]
    pub fn ends_with(self, code: i32) -> Self {
        let (out, err) = (&self.stdout, &self.stderr);
        assert_eq!(self.code, code, "exit code\n--- stdout\n{out}\n--- stderr\n{err}");
        assert!(!err.contains("panicked") && !err.contains("RUST_BACKTRACE"), "{err}");
        self
    }

    /// Requires success without complaints.
    #[track_caller]
    pub fn succeeds(self) -> Self {
        let run = self.ends_with(0);
        assert_eq!(run.stderr, "");
        run
    }

    /// Requires all of `words` on standard output.
    #[track_caller]
    pub fn says(self, words: &[&str]) -> Self {
        for word in words {
            assert!(self.stdout.contains(word), "`{word}` is not in\n{}", self.stdout);
        }
        self
    }

    /// Requires a refusal: exit code 2, nothing on standard output, and one message that holds all of `words`.
    #[track_caller]
    pub fn refuses(self, words: &[&str]) -> Self {
        let run = self.ends_with(2);
        assert_eq!(run.stdout, "");
        let message = run.message();
        let begins = |line: &&str| line.trim_start().starts_with('×') || line.starts_with("error: ");
        assert_eq!(run.stderr.lines().filter(begins).count(), 1, "one message is wanted\n{}", run.stderr);
        for word in words {
            assert!(message.contains(word), "`{word}` is not in\n{}", run.stderr);
        }
        run
    }

    /// Standard output as JSON.
    #[track_caller]
    pub fn json(&self) -> Value {
        serde_json::from_str(&self.stdout).unwrap_or_else(|error| panic!("{error}\n{}", self.stdout))
    }

    /// Standard error with single spaces and without the bars in front of wrapped lines.
    fn message(&self) -> String {
        let words = |line: &str| line.trim_start_matches([' ', '│']).split_whitespace().map(str::to_owned).collect();
        self.stderr.lines().flat_map(|line| -> Vec<String> { words(line) }).collect::<Vec<_>>().join(" ")
    }
}

/// A temporary directory, removed at the end. Commands run in it.
pub struct Scratch {
    directory: tempfile::TempDir,
}

impl Scratch {
    /// A new, empty one.
    pub fn new() -> Self {
        Self { directory: tempfile::Builder::new().prefix("brdfgen-cli-test-").tempdir().unwrap() }
    }

    /// Its path, or that of something in it.
    pub fn path(&self, inside: impl AsRef<Path>) -> PathBuf {
        self.directory.path().join(inside)
    }

    /// A command of the program, to be given arguments and an environment.
    pub fn command(&self) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_brdfgen"));
        command.current_dir(self.directory.path()).timeout(Duration::from_secs(120));
        command
    }

    /// Runs the program with the words of `line` as its arguments.
    #[track_caller]
    pub fn run(&self, line: &str) -> Run {
        self.run_each(line.split_whitespace())
    }

    /// Runs the program with these arguments.
    #[track_caller]
    pub fn run_each(&self, arguments: impl IntoIterator<Item = impl AsRef<OsStr>>) -> Run {
        finish(self.command().args(arguments))
    }

    /// Runs the program with the words of `line` as its arguments and only `directory` to find programs in.
    #[track_caller]
    pub fn run_with_path(&self, directory: &Path, line: &str) -> Run {
        finish(self.command().env("PATH", directory).args(line.split_whitespace()))
    }

    /// Runs the program and requires that it refuses, with all of `words` in its message, and writes nothing.
    #[track_caller]
    pub fn refused(&self, line: &str, words: &[&str]) {
        let before = self.tree("");
        println!("brdfgen {line}");
        self.run(line).refuses(words);
        assert_eq!(self.tree(""), before, "`brdfgen {line}` wrote something");
    }

    /// Writes a file, with the directories above it.
    pub fn write(&self, path: impl AsRef<Path>, content: impl AsRef<[u8]>) {
        let path = self.path(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, content).unwrap();
    }

    /// The bytes of a file.
    #[track_caller]
    pub fn read(&self, path: impl AsRef<Path>) -> Vec<u8> {
        let path = self.path(path);
        fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
    }

    /// The text of a file.
    #[track_caller]
    pub fn text(&self, path: impl AsRef<Path>) -> String {
        String::from_utf8(self.read(path)).unwrap()
    }

    /// The picture and the answer of `render` with these arguments through the core's model or its compiled text, which
    /// takes a while to compile.
    #[track_caller]
    pub fn rendered(&self, arguments: &str, through: &str) -> (Vec<u8>, Value) {
        let line = format!("render {arguments} --only core --out p.png --json --through {through}");
        let mut command = self.command();
        command.timeout(Duration::from_secs(600));
        let output = command.args(line.split_whitespace()).output().unwrap();
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        let json: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(json["core"]["through"], through);
        (self.read("p.png"), json)
    }

    /// What is in a directory.
    pub fn tree(&self, path: impl AsRef<Path>) -> Tree {
        let root = self.path(path);
        let (mut tree, mut open) = (Tree::new(), vec![root.clone()]);
        while let Some(directory) = open.pop() {
            for entry in fs::read_dir(&directory).unwrap() {
                let (path, kind) = entry.map(|entry| (entry.path(), entry.file_type().unwrap())).unwrap();
                let content = kind.is_file().then(|| fs::read(&path).unwrap());
                tree.insert(path.strip_prefix(&root).unwrap().to_owned(), content);
                if kind.is_dir() {
                    open.push(path);
                }
            }
        }
        tree
    }

    /// The paths of the files in a directory, in order, with forward slashes.
    pub fn files(&self, path: impl AsRef<Path>) -> Vec<String> {
        let tree = self.tree(path).into_iter();
        tree.filter(|(_, content)| content.is_some()).map(|(path, _)| path.to_str().unwrap().to_owned()).collect()
    }
}

#[track_caller]
fn finish(command: &mut Command) -> Run {
    let output = command.output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    Run {
        code: output.status.code().expect("an exit code within the time limit"),
        stdout: text(output.stdout),
        stderr: text(output.stderr),
    }
}
