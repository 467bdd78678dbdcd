//! What became of a core with something wrong in it, or of a fault injected in anything else that is checked.

use serde::Serialize;

/// What became of an injected fault.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "fate", rename_all = "kebab-case")]
pub enum Outcome {
    /// The check finds it, such as golden vectors that what has the fault does not give.
    #[serde(rename = "killed")]
    Detected {
        /// What shows it: the first thing that was not expected.
        by: String,
    },
    /// It changes nothing that can be seen.
    Equivalent {
        /// How that is proved.
        proof: String,
    },
    /// It changes something, and the check does not find it.
    #[serde(rename = "survives")]
    Survived {
        /// What would show it.
        input: String,
    },
    /// The check does not find it, and whether it changes anything is neither proved nor refuted.
    Undecided {
        /// What was tried.
        tried: String,
    },
}

/// How many faults came to which end.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Tally {
    /// All.
    pub mutants: usize,
    /// Detected.
    #[serde(rename = "killed")]
    pub detected: usize,
    /// Proved equivalent.
    pub equivalent: usize,
    /// Not detected, though not equivalent.
    pub survivors: usize,
    /// Not detected, and not known to be one or the other.
    pub undecided: usize,
}

impl Tally {
    /// Counts.
    #[must_use]
    pub fn of<'a>(outcomes: impl IntoIterator<Item = &'a Outcome>) -> Self {
        let mut tally = Self::default();
        for outcome in outcomes {
            tally.mutants += 1;
            *match outcome {
                Outcome::Detected { .. } => &mut tally.detected,
                Outcome::Equivalent { .. } => &mut tally.equivalent,
                Outcome::Survived { .. } => &mut tally.survivors,
                Outcome::Undecided { .. } => &mut tally.undecided,
            } += 1;
        }
        tally
    }
}
