//! What is wrong in a file.

use std::fmt;

/// A flaw of a file; its text follows the file's path: `:3: …` where it has a line, else `: …`.
#[derive(Debug, PartialEq)]
pub struct Flaw {
    line: Option<usize>,
    what: String,
}

impl Flaw {
    /// In a line, counted from 1.
    pub fn at(line: usize, what: String) -> Flaw {
        Flaw { line: Some(line), what }
    }

    /// Of the file as a whole.
    pub fn whole(what: impl Into<String>) -> Flaw {
        Flaw { line: None, what: what.into() }
    }
}

impl fmt::Display for Flaw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.line {
            Some(line) => write!(f, ":{line}: {}", self.what),
            None => write!(f, ": {}", self.what),
        }
    }
}
