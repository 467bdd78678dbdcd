//! A core as a program.
//!
//! Verilator compiles the core with a harness of ours, `testbench/exhaustive.cpp`, into a program that reads runs of
//! operand codes and writes the results, both as binary records through pipes, one input a clock.

use std::fs;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::Instant;

use sha2::{Digest, Sha256};

use crate::core::LobeDesign;
use crate::emit::package;
use crate::platform::error::Error;
use crate::platform::tool::{self, Tool, VERILATOR};
use crate::platform::transient::Folder;
use crate::spec::{Language, hex};
use crate::synth;

const HARNESS: &str = include_str!("../../../testbench/exhaustive.cpp");

/// The program, for messages.
pub(super) const CORE: Tool =
    Tool { program: "the compiled core", version_flag: "", package: "verilator", pypi: "", purpose: "" };

/// A run of consecutive operand codes for one shininess, as the harness reads it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Record {
    /// The code of `in_n`.
    pub(super) index: u32,
    /// The first operand code.
    pub(super) first: i32,
    /// How many there are.
    pub(super) count: u32,
}

impl Record {
    /// Writes it in the harness's form.
    pub(super) fn write(self, pipe: &mut dyn Write) -> io::Result<()> {
        let mut bytes = [0; 12];
        bytes[..4].copy_from_slice(&self.index.to_le_bytes());
        bytes[4..8].copy_from_slice(&self.first.to_le_bytes());
        bytes[8..].copy_from_slice(&self.count.to_le_bytes());
        pipe.write_all(&bytes)
    }
}

/// A compiled core.
pub(super) struct Compiled<'a> {
    program: PathBuf,
    /// The core's directory: a ROM file is named relative to it.
    directory: &'a Path,
}

impl<'a> Compiled<'a> {
    /// The core in a directory as a program; a build takes some ten seconds, so it is kept.
    /// Errors: a tool that is not installed or does not compile the core.
    pub(super) fn of(lobe: LobeDesign<'_>, directory: &'a Path, language: Language) -> Result<Self, Error> {
        let source = directory.join(package::rtl_path(&lobe, language));
        let verilog = match language {
            Language::Verilog => fs::read(&source).map_err(|error| Error::io("cannot read", &source, error))?,
            Language::Vhdl => synth::as_verilog(&lobe.spec.name, directory, &source)?,
        };
        Ok(Self { program: build(lobe, &verilog)?, directory })
    }

    /// Runs the core: `send` writes the records, in a thread of its own, `receive` reads the results, a little-endian
    /// `u32` each. Errors: a program that cannot be started, or takes longer than it may. How it ended is for the
    /// caller to judge.
    pub(super) fn run(
        &self,
        send: impl FnOnce(&mut dyn Write) -> io::Result<()> + Send,
        receive: impl FnOnce(&mut dyn Read),
    ) -> Result<Output, Error> {
        converse(tool::program(&self.program).current_dir(self.directory), send, receive)
    }
}

/// Runs a compiled core: `send` writes to it, in a thread of its own, `receive` reads what it answers.
/// Errors: a program that cannot be started, or takes longer than it may. How it ended is for the caller to judge.
pub(super) fn converse(
    command: &mut Command,
    send: impl FnOnce(&mut dyn Write) -> io::Result<()> + Send,
    receive: impl FnOnce(&mut dyn Read),
) -> Result<Output, Error> {
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let deadline = Instant::now() + tool::time_limit();
    let mut running = CORE.start(command)?;
    let errors = running.errors();
    let stdin = running.child.stdin.take().ok_or_else(|| CORE.missing())?;
    let mut stdout = running.child.stdout.take().ok_or_else(|| CORE.missing())?;
    std::thread::scope(|scope| {
        scope.spawn(move || {
            let mut pipe = io::BufWriter::with_capacity(1 << 16, stdin);
            // A core that ended early is noticed by its missing results.
            let _ = send(&mut pipe).and_then(|()| pipe.flush());
        });
        receive(&mut stdout);
        // A core that still has results to write must not wait for a reader.
        drop(stdout);
    });
    let status = running.finish()?;
    let stderr = errors.and_then(|errors| errors.printed(deadline).ok()).unwrap_or_default();
    Ok(Output { status, stdout: Vec::new(), stderr })
}

/// The program of a core.
fn build(lobe: LobeDesign<'_>, verilog: &[u8]) -> Result<PathBuf, Error> {
    let flags = format!(
        "-O2 -DOPERAND={} -DOPERAND_BITS={} -DLATENCY={}",
        lobe.operand_name(),
        lobe.operand_format().width(),
        lobe.schedule.latency
    );
    // The memories keep the words that they come up with.
    let low: String = lobe.write_ports().iter().map(|port| format!(" core->{} = 0;", port.enable.name)).collect();
    let harness = format!("#define DISABLE_WRITES{low}\n{HARNESS}");
    let sources = [("core.v", verilog), ("exhaustive.cpp", harness.as_bytes())];
    program(&lobe.spec.name, &sources, &flags)
}

/// The program that Verilator makes of a core and a harness in C++, a file each by its name; other files are headers.
/// `top` is the core's module. A build takes some ten seconds, so it is kept. Errors: a tool that is not installed or
/// does not compile it.
pub(super) fn program(top: &str, sources: &[(&str, &[u8])], flags: &str) -> Result<PathBuf, Error> {
    let version = VERILATOR.version().ok_or_else(|| VERILATOR.missing())?;
    let mut digest = Sha256::new();
    let names = sources.iter().flat_map(|(name, bytes)| [name.as_bytes(), bytes]);
    for part in names.chain([flags.as_bytes(), version.as_bytes()]) {
        digest.update((part.len() as u64).to_le_bytes());
        digest.update(part);
    }
    let cache = tool::cache_directory();
    let kept = cache.join(format!("{top}-{}", &hex(&digest.finalize())[..24]));
    if kept.exists() {
        return Ok(kept);
    }
    fs::create_dir_all(&cache).map_err(|error| Error::io("cannot make", &cache, error))?;
    let scratch = tool::scratch_for_make()?;
    for (name, bytes) in sources {
        let path = scratch.path().join(name);
        fs::write(&path, bytes).map_err(|error| Error::io("cannot write", &path, error))?;
    }
    let mut command = VERILATOR.command(scratch.path());
    command.args(["--cc", "--exe", "--build", "-O3", "-Wno-fatal", "-Wno-lint", "-j", "2", "--prefix", "Vcore"]);
    command.args(["--top-module", top, "-CFLAGS", flags]);
    command.args(sources.iter().map(|(name, _)| name).filter(|name| !name.ends_with(".h")));
    VERILATOR.succeed(&mut command)?;
    let built = scratch.path().join("obj_dir").join("Vcore");
    // A rename, so that two runs at once do not see each other's half-copied program.
    let whole = Folder::new_in(&cache).map_err(|error| Error::io("cannot make a directory in", &cache, error))?;
    let copy = whole.path().join("core");
    let keep = fs::copy(&built, &copy).and_then(|_| fs::rename(&copy, &kept));
    keep.map_err(|error| Error::io("cannot keep", &kept, error))?;
    Ok(kept)
}
