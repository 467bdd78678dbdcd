//! The one error type: what is wrong, where, and what is allowed.

use std::io;
use std::path::Path;
use std::sync::Arc;

use miette::{Diagnostic, NamedSource, SourceSpan};
use thiserror::Error as ThisError;

/// A reason why a command cannot do its work. All of them end the program with exit code 2.
#[derive(Debug, ThisError, Diagnostic)]
pub enum Error {
    /// A value that the user gave is not allowed.
    #[error("{what}")]
    #[diagnostic(code(brdfgen::input))]
    Input {
        /// What is wrong.
        what: String,
        /// What is allowed instead.
        #[help]
        allowed: String,
    },
    /// A file's text is wrong at a known place.
    #[error("{what}")]
    #[diagnostic(code(brdfgen::text))]
    Text {
        /// What is wrong.
        what: String,
        /// What is allowed instead.
        #[help]
        allowed: String,
        /// The file's name and text.
        #[source_code]
        text: Arc<NamedSource<String>>,
        /// The place.
        #[label("here")]
        at: SourceSpan,
    },
    /// The system refused a file operation.
    #[error("{action} {path}: {answer}")]
    #[diagnostic(code(brdfgen::io))]
    Io {
        /// What was tried, such as "cannot write".
        action: &'static str,
        /// The file or directory.
        path: String,
        /// The system's answer.
        answer: io::Error,
    },
    /// An external program is not installed.
    #[error("{tool} is needed for this and is not installed")]
    #[diagnostic(code(brdfgen::tool))]
    MissingTool {
        /// The program.
        tool: String,
        /// How it is installed.
        #[help]
        package: String,
    },
    /// An external program did not do its work.
    #[error("{tool} failed: {what}")]
    #[diagnostic(code(brdfgen::tool))]
    ToolFailed {
        /// The program.
        tool: String,
        /// Its exit status or what was wrong with its answer.
        what: String,
        /// The end of what it printed.
        #[help]
        output: String,
    },
    /// An external program ran longer than it may.
    #[error("{tool} was stopped, as it had not ended within {seconds} s")]
    #[diagnostic(code(brdfgen::tool), help("--time-limit SECONDS gives every program more time"))]
    TimeLimit {
        /// The program.
        tool: String,
        /// The limit.
        seconds: u64,
    },
}

/// Returns an [`Error::Input`] where a condition holds: what is wrong, and what is allowed.
macro_rules! refuse {
    ($condition:expr, $what:expr, $allowed:expr $(,)?) => {
        if $condition {
            return Err($crate::platform::error::Error::input($what, $allowed));
        }
    };
}
pub(crate) use refuse;

impl Error {
    /// A value that is not allowed.
    #[must_use]
    pub fn input(what: impl Into<String>, allowed: impl Into<String>) -> Self {
        Self::Input { what: what.into(), allowed: allowed.into() }
    }

    /// A place in a file's text that is not allowed: `length` bytes from `offset`.
    #[must_use]
    pub fn text(
        what: impl Into<String>,
        allowed: impl Into<String>,
        file: &str,
        text: &str,
        (offset, length): (usize, usize),
    ) -> Self {
        Self::Text {
            what: what.into(),
            allowed: allowed.into(),
            text: Arc::new(NamedSource::new(file, text.to_owned())),
            at: (offset, length).into(),
        }
    }

    /// A refused file operation.
    #[must_use]
    pub fn io(action: &'static str, path: &Path, answer: io::Error) -> Self {
        Self::Io { action, path: path.display().to_string(), answer }
    }
}
