//! The command line of brdfgen.

use std::process::ExitCode;

fn main() -> ExitCode {
    brdfgen::cli::main()
}
