//! External programs: where they are, which package has them, and how they are run.

use std::path::Path;
use std::process::{Command, Output};

use serde::Serialize;

use crate::error::Error;

/// An external program that brdfgen can use.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Tool {
    /// The program's name.
    pub program: &'static str,
    /// The argument that makes it say its version.
    pub version_flag: &'static str,
    /// The Debian package that has it.
    pub package: &'static str,
    /// What brdfgen uses it for.
    pub purpose: &'static str,
}

/// Icarus Verilog's compiler.
pub const IVERILOG: Tool =
    Tool { program: "iverilog", version_flag: "-V", package: "iverilog", purpose: "cosim --sim icarus" };
/// Icarus Verilog's run time.
pub const VVP: Tool = Tool { program: "vvp", version_flag: "-V", package: "iverilog", purpose: "cosim --sim icarus" };
/// Verilator.
pub const VERILATOR: Tool = Tool {
    program: "verilator",
    version_flag: "--version",
    package: "verilator",
    purpose: "cosim --sim verilator, cosim --exhaustive",
};
/// GHDL.
pub const GHDL: Tool = Tool {
    program: "ghdl",
    version_flag: "--version",
    package: "ghdl",
    purpose: "cosim --sim ghdl, cosim --exhaustive of the VHDL",
};
/// The C++ compiler that Verilator calls.
pub const CXX: Tool =
    Tool { program: "g++", version_flag: "--version", package: "g++", purpose: "Verilator's back end" };
/// The make program that Verilator calls.
pub const MAKE: Tool =
    Tool { program: "make", version_flag: "--version", package: "make", purpose: "Verilator's back end" };

/// All of them.
pub const TOOLS: [Tool; 6] = [IVERILOG, VVP, VERILATOR, GHDL, CXX, MAKE];

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
        Error::MissingTool {
            tool: self.program.to_owned(),
            package: format!("the Debian package `{0}` has it: apt-get install {0}", self.package),
        }
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
        let line = text.lines().map(str::trim).find(|line| !line.is_empty());
        Some(line.unwrap_or("of an unknown version").to_owned())
    }
}

/// The last lines of what a program printed, on both streams.
#[must_use]
pub fn tail(output: &Output, lines: usize) -> String {
    let text = format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    let all: Vec<&str> = text.lines().filter(|line| !line.trim().is_empty()).collect();
    all[all.len().saturating_sub(lines)..].join("\n")
}
