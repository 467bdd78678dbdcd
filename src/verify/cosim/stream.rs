//! Any inputs through a compiled core, in any order.

use std::io::{Read, Write};
use std::path::Path;

use super::compiled::{CORE, Compiled, Record};
use crate::core::LobeDesign;
use crate::platform::error::Error;
use crate::platform::tool::tail;

/// The results of the core in a directory for inputs, one a clock and in this order: each a code of `in_n` and one of
/// the operand, both within their ports. The core is its Verilog, or its VHDL where it has no Verilog. `progress` is
/// told how many results have come.
///
/// # Errors
/// A tool that is not installed or does not compile the core; a core that fails, or has not given a result for each
/// input.
pub fn stream(
    lobe: LobeDesign<'_>,
    directory: &Path,
    inputs: &[(u32, i32)],
    progress: &dyn Fn(u64),
) -> Result<Vec<u32>, Error> {
    let core = Compiled::of(lobe, directory, lobe.spec.compiled_language())?;
    let mut results = Vec::with_capacity(inputs.len());
    let receive = |pipe: &mut dyn Read| {
        let mut bytes = vec![0u8; 1 << 16];
        while results.len() < inputs.len() {
            let wanted = (4 * (inputs.len() - results.len())).min(bytes.len());
            if pipe.read_exact(&mut bytes[..wanted]).is_err() {
                return;
            }
            results.extend(bytes[..wanted].as_chunks::<4>().0.iter().map(|bytes| u32::from_le_bytes(*bytes)));
            progress(results.len() as u64);
        }
    };
    let send = |pipe: &mut dyn Write| {
        let mut rest = inputs;
        while let Some(&(index, first)) = rest.first() {
            let run = rest.windows(2).take_while(|pair| pair[1].0 == index && pair[1].1 == pair[0].1 + 1).count() + 1;
            Record { index, first, count: run as u32 }.write(pipe)?;
            rest = &rest[run..];
        }
        Ok(())
    };
    let output = core.run(send, receive)?;
    if output.status.success() && results.len() == inputs.len() {
        return Ok(results);
    }
    Err(Error::ToolFailed {
        tool: CORE.program.to_owned(),
        what: format!("{} of {} results, {}", results.len(), inputs.len(), output.status),
        output: tail(&output, 4),
    })
}
