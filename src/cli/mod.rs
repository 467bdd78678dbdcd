//! The commands, one file each: arguments, printing, exit codes. No arithmetic.
//!
//! Exit codes: 0 for success, 1 for a comparison that failed, 2 for wrong input or a missing tool.

mod choose;
mod claims;
mod cosim;
mod doctor;
mod eval;
mod explore;
mod formal;
mod generate;
mod golden;
mod help;
mod image;
mod mutate;
mod progress;
mod reflectance;
mod render;
mod report;
mod rom;
mod scene;
mod source;
mod stability;
mod synth;

use std::io::{ErrorKind, Write};
use std::path::Path;
use std::process::ExitCode;
use std::sync::{Mutex, PoisonError};

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use serde::Serialize;

use crate::emit::package;
use crate::platform::error::Error;
use crate::platform::{tool, transient};

/// What to begin with.
const START: &str = "\
Start with a core, checked in process; look at one point of it; run it in simulators:
  brdfgen generate --method quadratic --shininess 1..=1000 --out out
  brdfgen eval out -n 200 -x 0.997
  brdfgen cosim out --sim all";

/// Generates FPGA cores for the specular term cos^n of a shader
#[derive(Parser)]
#[command(version, about, max_term_width = 100, after_help = START)]
struct Cli {
    /// How long each external program may run, in seconds [default: 600]
    #[arg(long, global = true, value_name = "SECONDS", value_parser = clap::value_parser!(u64).range(1..=31_536_000))]
    time_limit: Option<u64>,

    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Make a core directory, from a spec or from a scene, and check it in process
    Generate(Box<generate::Arguments>),
    /// Write the coefficient ROM in any format, or check a file
    Rom(rom::Arguments),
    /// Write the golden vectors, or check a file
    Golden(golden::Arguments),
    /// Run a core in simulators and compare it with the model
    Cosim(cosim::Arguments),
    /// Prove that a core's Verilog, VHDL and rust-hdl Verilog are the same circuit
    Formal(formal::Arguments),
    /// Plant mistakes in a core and say which of them its golden vectors miss
    Mutate(mutate::Arguments),
    /// Synthesise a core for an FPGA family: cells, clock, latency
    Synth(synth::Arguments),
    /// Evaluate one shininess and cosine: exact, method, model, error
    Eval(eval::Arguments),
    /// Measure error and cost of many cores
    Explore(Box<explore::Arguments>),
    /// Name the cheapest core that meets constraints, and what just misses it
    Choose(Box<choose::Arguments>),
    /// Measure the papers' claims and compare with the recorded values
    Claims(claims::Arguments),
    /// Inspect a core, or a study of many, where forms degenerate: every input, every register
    Stability(Box<stability::Arguments>),
    /// Read, convert, draw, fit and compare measured reflectance, and sphere images of it
    Reflectance(Box<reflectance::Arguments>),
    /// Make what an image-based block is told of lights
    Image(Box<image::Arguments>),
    /// Draw a scene exactly and through a core, and how the two differ
    Render(Box<render::Arguments>),
    /// Show the trade of error against cost as one HTML page, and its charts as SVG and PNG
    Report(report::Arguments),
    /// Say what a scene requires of a core
    Scene(Box<scene::Arguments>),
    /// Say which external tools are there, and which package brings the missing ones
    Doctor(doctor::Arguments),
}

/// How a command ended, when nothing was wrong with its input.
enum Verdict {
    /// It did what it was asked to.
    Done,
    /// A comparison failed.
    Differs,
}

impl Verdict {
    fn of(passed: bool) -> Self {
        if passed { Self::Done } else { Self::Differs }
    }
}

/// Runs the command that the arguments name.
#[must_use]
pub fn main() -> ExitCode {
    // Unwrapped, so that a path stays whole and can be found in a log.
    let _ = miette::set_hook(Box::new(|_| Box::new(miette::MietteHandlerOpts::new().wrap_lines(false).build())));
    transient::clean_on_signals();
    let mut program = help::arranged(Cli::command());
    let parsed = Cli::from_arg_matches_mut(&mut program.get_matches_mut());
    let Cli { time_limit, command } = parsed.unwrap_or_else(|error| error.format(&mut program).exit());
    time_limit.into_iter().for_each(tool::set_time_limit);
    let result = match command {
        Command::Generate(arguments) => generate::run(*arguments),
        Command::Rom(arguments) => rom::run(arguments),
        Command::Golden(arguments) => golden::run(arguments),
        Command::Cosim(arguments) => cosim::run(arguments),
        Command::Formal(arguments) => formal::run(&arguments),
        Command::Mutate(arguments) => mutate::run(&arguments),
        Command::Synth(arguments) => synth::run(arguments),
        Command::Eval(arguments) => eval::run(arguments),
        Command::Explore(arguments) => explore::run(*arguments),
        Command::Choose(arguments) => choose::run(&arguments),
        Command::Claims(arguments) => claims::run(&arguments),
        Command::Stability(arguments) => stability::run(&arguments),
        Command::Reflectance(arguments) => reflectance::run(&arguments),
        Command::Image(arguments) => image::run(&arguments),
        Command::Render(arguments) => render::run(&arguments),
        Command::Report(arguments) => report::run(&arguments),
        Command::Scene(arguments) => scene::run(&arguments),
        Command::Doctor(arguments) => doctor::run(&arguments),
    };
    match result.and_then(printed) {
        Ok(Verdict::Done) => ExitCode::SUCCESS,
        Ok(Verdict::Differs) => ExitCode::from(1),
        Err(error) => {
            warn(format!("{:?}", miette::Report::new(error)));
            ExitCode::from(2)
        }
    }
}

/// Whether something could not be printed: a full disk behind standard output, for one.
static UNPRINTED: Mutex<Option<std::io::Error>> = Mutex::new(None);

/// Prints a line to standard output. A reader that went away is no error; what else is wrong is told at the end.
fn say(text: impl AsRef<str>) {
    match writeln!(std::io::stdout(), "{}", text.as_ref()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            UNPRINTED.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
        }
        _ => {}
    }
}

/// The verdict, unless what was to be printed was not.
fn printed(verdict: Verdict) -> Result<Verdict, Error> {
    let unprinted = UNPRINTED.lock().unwrap_or_else(PoisonError::into_inner).take();
    let flushed = std::io::stdout().flush().err().filter(|error| error.kind() != ErrorKind::BrokenPipe);
    match unprinted.or(flushed) {
        None => Ok(verdict),
        Some(error) => Err(Error::io("cannot write to", Path::new("standard output"), error)),
    }
}

/// Prints a line to standard error. A reader that went away is no error: the exit code still says how the command
/// ended.
fn warn(text: impl AsRef<str>) {
    let _ = writeln!(std::io::stderr(), "{}", text.as_ref());
}

/// Prints a value as JSON.
fn say_json(value: &impl Serialize) {
    say(serde_json::to_string_pretty(value).expect("JSON of plain values"));
}

/// Writes to a file, or to standard output where the path is `-`. A reader that went away is no error.
fn write_to(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    if path.as_os_str() != "-" {
        return package::write_file(path, bytes);
    }
    let mut output = std::io::stdout();
    match output.write_all(bytes).and_then(|()| output.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Error::io("cannot write to", Path::new("standard output"), error))
        }
        _ => Ok(()),
    }
}
