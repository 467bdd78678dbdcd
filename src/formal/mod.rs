//! Proofs about the HDL of a core, for every input and every clock, where [`crate::cosim`] compares runs.

use serde::Serialize;

/// What came of a proof.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// The claim holds.
    Proved,
    /// The claim is false.
    Refuted,
    /// Neither was found: the time limit, or a circuit of a form that the method does not know.
    Open,
}

/// A claim, and what came of its proof.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Proof {
    /// The claim, such as "Verilog = VHDL".
    pub claim: String,
    /// What came of it.
    pub verdict: Verdict,
    /// Why it is not proved, a line each.
    pub why: Vec<String>,
    /// The time it took, in seconds.
    pub seconds: f64,
}
