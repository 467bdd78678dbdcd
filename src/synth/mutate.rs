//! Mutants of a netlist, by Yosys.

use std::path::Path;

use super::yosys::Yosys;
use crate::emit::package;
use crate::platform::error::Error;
use crate::platform::tool::scratch;

/// A netlist with many mutants.
#[derive(Clone, Debug)]
pub(crate) struct Mutated {
    /// Its Verilog, with an input `mutant` that chooses one; 0 is the netlist as it was.
    pub(crate) verilog: Vec<u8>,
    /// The mutants, from 1 on.
    pub(crate) mutants: Vec<Listed>,
}

/// A mutant of a netlist.
#[derive(Clone, Debug)]
pub(crate) struct Listed {
    /// What is wrong: the mode, the cell, its port and bit.
    pub(crate) what: String,
    /// Whether it is what makes a register take its input that is wrong, its clock, enable or reset, and not what it
    /// takes.
    pub(crate) is_control: bool,
    /// Yosys' command for it.
    command: String,
}

/// From the text to cells, whose ports get the mistakes. A register has its enable at a port of its own, as a flip-flop
/// has; only `rst` is a register's reset. What a memory shows goes to a register like any other.
fn script(top: &str) -> String {
    format!(
        "read_verilog core.v\nprep -top {top} -flatten -nordff\nopt_dff\nopt_clean\n\
         dffunmap -srst-only t:$sdff* i:rst %co1:+[SRST] %d\nopt_clean\n"
    )
}

/// Mutants that are asked for beyond those that are wanted, as some cannot be.
const SPARE: u32 = 40;

/// A core's netlist with so many mutants, which `seed` chooses. The core's memories must be in its text.
/// Errors: no Yosys, or one that does not read the core.
pub(crate) fn mutated(top: &str, verilog: &[u8], count: u32, seed: u32) -> Result<Mutated, Error> {
    let list = format!("mutate -list {} -seed {seed} -o mutants.ys\n", count + SPARE);
    let list = run(top, verilog, &list, "mutants.ys")?;
    let list = String::from_utf8_lossy(&list);
    // Yosys has no memory whose read without a clock has another enable or reset than constants.
    let possible = list
        .lines()
        .filter(|line| !line.contains("-port RD_") || line.contains("-port RD_ADDR") || line.contains("-port RD_DATA"));
    let bits = u32::BITS - count.leading_zeros();
    let mutants: Vec<Listed> =
        possible.take(count as usize).zip(1..).map(|(line, number)| Listed::of(line, bits, number)).collect();
    let verilog = with(top, verilog, &mutants.iter().collect::<Vec<_>>(), "write_verilog -noattr")?;
    Ok(Mutated { verilog, mutants })
}

/// The same netlist with some of its mutants alone, under their numbers, in Yosys' own language: in Verilog, a write
/// port of a memory may become several. Errors: as [`mutated`].
pub(crate) fn mutated_by(top: &str, verilog: &[u8], mutants: &[&Listed]) -> Result<Vec<u8>, Error> {
    with(top, verilog, mutants, "write_rtlil")
}

/// The netlist with these mutants, as a command writes it.
fn with(top: &str, verilog: &[u8], mutants: &[&Listed], write: &str) -> Result<Vec<u8>, Error> {
    let commands: Vec<&str> = mutants.iter().map(|mutant| mutant.command.as_str()).collect();
    run(top, verilog, &format!("{}\nopt_clean\n{write} mutated\n", commands.join("\n")), "mutated")
}

/// Runs commands on a core's netlist, and returns a file that they write.
fn run(top: &str, verilog: &[u8], commands: &str, file: &str) -> Result<Vec<u8>, Error> {
    let directory = scratch()?;
    package::write_file(&directory.path().join("core.v"), verilog)?;
    Yosys::find(None)?.run(directory.path(), &(script(top) + commands))?;
    read(&directory.path().join(file))
}

fn read(path: &Path) -> Result<Vec<u8>, Error> {
    std::fs::read(path).map_err(|error| Error::io("cannot read", path, error))
}

impl Listed {
    /// Of a line of the list, which has the places in the text at its end; the input `mutant` of so many bits chooses
    /// it by a number.
    fn of(line: &str, bits: u32, number: u32) -> Self {
        let words: Vec<&str> = line.split_whitespace().collect();
        let option = |name: &str| words.iter().position(|word| *word == name).and_then(|place| words.get(place + 1));
        let part = |name: &str| option(name).map(|word| format!("{} {word}", name.trim_start_matches('-')));
        let parts = ["-mode", "-cell", "-port", "-portbit", "-ctrlbit", "-wire", "-wirebit"];
        let is_control = option("-port").is_some_and(|port| ["CLK", "EN", "SRST", "ARST"].contains(port));
        let what = parts.into_iter().filter_map(part).collect::<Vec<_>>().join(" ");
        Self { what, is_control, command: line.replacen("mutate", &format!("mutate -ctrl mutant {bits} {number}"), 1) }
    }
}
