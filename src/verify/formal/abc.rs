//! ABC: whether two combinational circuits are the same function.

use std::time::Duration;

use super::aig::{Aig, Literal};
use crate::emit::package;
use crate::platform::error::Error;
use crate::platform::tool::{self, YOSYS_ABC, tail};

/// What ABC says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Answer {
    Equal,
    Different,
    /// It has not found out in its time.
    Unknown,
}

/// Whether the literals of each pair are the same function of the graph's inputs. `seconds` is the most that ABC may
/// take: it is stopped then, as its own limit does not hold in every phase of its work. Errors: if ABC is not
/// installed, or ends without a word about it.
pub(super) fn equal(aig: &Aig, pairs: &[(Literal, Literal)], seconds: u32) -> Result<Answer, Error> {
    let scratch = tool::scratch()?;
    let sides: [Vec<Literal>; 2] =
        [pairs.iter().map(|pair| pair.0).collect(), pairs.iter().map(|pair| pair.1).collect()];
    for (name, outputs) in [("one.aig", &sides[0]), ("other.aig", &sides[1])] {
        package::write_file(&scratch.path().join(name), &aig.aiger(outputs))?;
    }
    let mut command = YOSYS_ABC.command(scratch.path());
    command.arg("-c").arg(format!("cec -T {seconds} -n one.aig other.aig"));
    let output = match YOSYS_ABC.output_within(&mut command, Duration::from_secs(seconds.into())) {
        Err(Error::TimeLimit { .. }) => return Ok(Answer::Unknown),
        output => output?,
    };
    let text = String::from_utf8_lossy(&output.stdout);
    let answers = [
        ("Networks are equivalent", Answer::Equal),
        ("Networks are NOT EQUIVALENT", Answer::Different),
        ("Networks are UNDECIDED", Answer::Unknown),
    ];
    let said: Vec<Answer> =
        answers.into_iter().filter(|(words, _)| text.contains(words)).map(|(_, answer)| answer).collect();
    match said.as_slice() {
        [answer] if output.status.success() => Ok(*answer),
        _ => Err(Error::ToolFailed {
            tool: YOSYS_ABC.program.to_owned(),
            what: format!("it does not say whether the circuits are the same, {}", output.status),
            output: tail(&output, 12),
        }),
    }
}
