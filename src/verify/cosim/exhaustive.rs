//! Every input through a compiled core.
//!
//! The results of the [`compiled`](super::compiled) core are compared with the vectorised evaluator (itself checked
//! against the model). VHDL goes through GHDL's synthesis to Verilog first, so that its check is not independent of
//! GHDL's front end.

use std::io::{Read, Write};
use std::path::Path;

use super::compiled::{Compiled, Record};
use super::{LISTED, Outcome};
use crate::core::LobeDesign;
use crate::platform::error::Error;
use crate::platform::tool::tail;
use crate::spec::Language;
use crate::verify::golden::all_codes;

/// Runs every code of the operand port for every row through the core of a lobe in one language; `progress` is told how
/// many inputs are done, of how many.
///
/// # Errors
/// A tool that is not installed or does not compile the core.
pub fn exhaustive(
    lobe: LobeDesign<'_>,
    directory: &Path,
    language: Language,
    progress: &dyn Fn(u64, u64),
) -> Result<Outcome, Error> {
    let start = std::time::Instant::now();
    let simulator = match language {
        Language::Verilog => "verilator",
        Language::Vhdl => "ghdl --synth, verilator",
    };
    let mut outcome = match Compiled::of(lobe, directory, language) {
        Ok(core) => run(lobe, &core, progress)?,
        // A core that does not compile has failed its check; what other languages' checks found still counts.
        Err(Error::ToolFailed { tool, what, output }) => Outcome {
            first: vec![format!("{tool} does not compile the core ({what}): {output}")],
            ..nothing_compared(lobe)
        },
        Err(other) => return Err(other),
    };
    outcome.simulator = simulator.to_owned();
    outcome.seconds = start.elapsed().as_secs_f64();
    Ok(outcome)
}

/// The inputs that a run has to compare.
fn inputs(lobe: LobeDesign<'_>) -> u64 {
    lobe.interface.shininess.rows() as u64 * all_codes(lobe.operand_format()).1
}

fn nothing_compared(lobe: LobeDesign<'_>) -> Outcome {
    Outcome::none("", "every input", inputs(lobe))
}

fn run(lobe: LobeDesign<'_>, core: &Compiled, progress: &dyn Fn(u64, u64)) -> Result<Outcome, Error> {
    let (first, count) = all_codes(lobe.operand_format());
    let set = &lobe.interface.shininess;
    let indices: Vec<u32> = (0..set.rows()).map(|row| set.index_of_row(row)).collect();
    let total = inputs(lobe);
    let mut outcome = nothing_compared(lobe);
    let send = |pipe: &mut dyn Write| {
        let record = |&index: &u32| Record { index, first: first as i32, count: count as u32 }.write(pipe);
        indices.iter().try_for_each(record)
    };
    let receive = |pipe: &mut dyn Read| {
        let evaluator = lobe.evaluator();
        let block = count.min(1 << 16) as usize;
        let (mut bytes, mut expected) = (vec![0u8; 4 * block], vec![0u32; block]);
        for &index in &indices {
            for start in (0..count).step_by(block) {
                if pipe.read_exact(&mut bytes).is_err() {
                    return;
                }
                evaluator.evaluate(index, first + start as i64, 1, &mut expected);
                let got = bytes.as_chunks::<4>().0.iter().map(|bytes| u32::from_le_bytes(*bytes));
                for (offset, (got, &expected)) in got.zip(&expected).enumerate() {
                    if got != expected {
                        outcome.mismatches += 1;
                        if outcome.first.len() < LISTED {
                            let operand = first + start as i64 + offset as i64;
                            let what = format!("in_n {index}, operand {operand}: expected {expected}, got {got}");
                            outcome.first.push(what);
                        }
                    }
                }
                outcome.vectors += block as u64;
                progress(outcome.vectors, total);
            }
        }
    };
    let output = core.run(send, receive)?;
    if !output.status.success() {
        outcome.first.push(format!("the compiled core ends with {}: {}", output.status, tail(&output, 4)));
    }
    Ok(outcome)
}
