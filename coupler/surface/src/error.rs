//! What is wrong with a file that a case names.

use std::path::PathBuf;

use case_io::document::Case;
use case_io::error::CaseError;
use case_io::exit_code::ExitCode;
use thiserror::Error;

use crate::flaw::Flaw;

/// What is wrong with a file that a case names.
#[derive(Debug, Error)]
pub enum InputError {
    /// It cannot be read.
    #[error("{path}: {source}; check the path and its permissions")]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// It holds something that cannot be used.
    #[error("{path}{flaw}")]
    BadFile {
        /// The file.
        path: PathBuf,
        /// Where in it, what is wrong and what is allowed.
        flaw: Flaw,
    },
    /// The case is refused.
    #[error(transparent)]
    Case(#[from] CaseError),
}

impl InputError {
    /// The documented exit code.
    pub fn exit_code(&self) -> ExitCode {
        match self {
            Self::Unreadable { .. } => ExitCode::Environment,
            Self::BadFile { .. } => ExitCode::CaseRefused,
            Self::Case(error) => error.exit_code(),
        }
    }

    /// The same, of a file that this key of the case names.
    pub fn at_key(self, case: &Case, key: &str) -> Self {
        match self {
            Self::BadFile { path, flaw } => {
                let found = format!("{}{flaw}", path.display());
                case.error(key, found, "", "repair the file or name another").into()
            }
            other => other,
        }
    }
}
