//! What a case can be refused for.

use std::fmt;
use std::path::PathBuf;

use crate::exit_code::ExitCode;

/// Why a case was refused; its message is one line.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum CaseError {
    /// A file could not be read.
    #[error("{}: {problem}", path.display())]
    Unreadable {
        /// The file or folder.
        path: PathBuf,
        /// What is wrong, and what to do.
        problem: String,
    },
    /// The file is no TOML.
    #[error("{}:{line}:{column}: not TOML: {problem}", path.display())]
    Syntax {
        /// The file.
        path: PathBuf,
        /// Line, from 1.
        line: usize,
        /// Column, from 1.
        column: usize,
        /// What is wrong.
        problem: String,
    },
    /// A flag of the command line cannot be understood.
    #[error("{flag}: {problem}")]
    CommandLine {
        /// The flag as given.
        flag: String,
        /// What is wrong, and what to do.
        problem: String,
    },
    /// A key is wrong.
    #[error("{place}{key}: {found}{}{}", clause("; allowed: ", allowed), clause("; ", advice))]
    Refused {
        /// Where the key was written.
        place: Place,
        /// Path of the key: `insertion[0].diameter`.
        key: String,
        /// What is wrong, and the value found.
        found: String,
        /// What is allowed (may be empty).
        allowed: String,
        /// What to do (may be empty).
        advice: String,
    },
}

impl CaseError {
    /// The code with which a program ends that meets this error.
    pub fn exit_code(&self) -> ExitCode {
        match self {
            Self::CommandLine { .. } => ExitCode::CommandLine,
            _ => ExitCode::CaseRefused,
        }
    }
}

fn clause(lead: &str, text: &str) -> String {
    if text.is_empty() { String::new() } else { format!("{lead}{text}") }
}

/// Where a key was written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// In a file.
    File {
        /// The file.
        path: PathBuf,
        /// Line, from 1.
        line: usize,
    },
    /// In a `--set` of the command line.
    Set,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::File { path, line } => write!(f, "{}:{line}: ", path.display()),
            Self::Set => f.write_str("--set "),
        }
    }
}
