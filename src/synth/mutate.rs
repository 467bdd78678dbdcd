//! Mutants of a netlist, by Yosys.

use std::path::Path;

use super::yosys::Yosys;
use crate::error::Error;
use crate::package;
use crate::tool::scratch;

/// A netlist with many mutants.
#[derive(Clone, Debug)]
pub(crate) struct Mutated {
    /// Its Verilog, with an input `mutant` that chooses one; 0 is the netlist as it was.
    pub(crate) verilog: Vec<u8>,
    /// What is wrong in each, from 1 on: the mode, the cell, its port and bit.
    pub(crate) mutants: Vec<String>,
}

/// A core's netlist with so many mutants, which `seed` chooses. The core's memories must be in its text.
///
/// # Errors
/// No Yosys, or one that does not read the core.
pub(crate) fn mutated(top: &str, verilog: &[u8], count: u32, seed: u32) -> Result<Mutated, Error> {
    let directory = scratch()?;
    let path = |name: &str| directory.path().join(name);
    package::write_file(&path("core.v"), verilog)?;
    let bits = (u32::BITS - count.leading_zeros()).max(1);
    let script = format!(
        "read_verilog core.v\nprep -top {top} -flatten\n\
         mutate -list {count} -seed {seed} -ctrl mutant {bits} 1 -o mutants.ys\nscript mutants.ys\nopt_clean\nwrite_verilog -noattr mutated.v\n"
    );
    Yosys::find(None)?.run(directory.path(), &script)?;
    let read = |path: &Path| std::fs::read(path).map_err(|error| Error::io("cannot read", path, error));
    let list = String::from_utf8_lossy(&read(&path("mutants.ys"))?).into_owned();
    Ok(Mutated { verilog: read(&path("mutated.v"))?, mutants: list.lines().map(described).collect() })
}

/// A line of the list without the choice in front and the places in the text behind.
fn described(line: &str) -> String {
    let words: Vec<&str> = line.split_whitespace().collect();
    let option = |name: &str| words.iter().position(|word| *word == name).and_then(|place| words.get(place + 1));
    let part = |name: &str| option(name).map(|word| format!("{} {word}", name.trim_start_matches('-')));
    ["-mode", "-cell", "-port", "-portbit", "-ctrlbit", "-wire", "-wirebit"]
        .into_iter()
        .filter_map(part)
        .collect::<Vec<_>>()
        .join(" ")
}
