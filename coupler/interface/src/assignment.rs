//! What the coupler tells a solver on its command line: one JSON argument, readable in a process list.

use crate::error::InterfaceError;
use crate::participant::Hold;
use crate::run::RunId;
use crate::transport::Deadlines;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;
use std::time::Duration;

/// A solver's part in a run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Assignment {
    /// The run's identity.
    pub run: String,
    /// The case folder or file.
    pub case: PathBuf,
    /// `--set` of the command line.
    pub set: Vec<String>,
    /// `--variant` of the command line.
    pub variant: Option<String>,
    /// Which run of the case's sweep, if it is one.
    pub name: Option<String>,
    /// Where results go.
    pub out: PathBuf,
    /// Threads to compute with; 0: all cores.
    pub threads: usize,
    /// Restart point to go on from.
    pub resume: Option<PathBuf>,
    /// Seconds without a heartbeat after which a peer is frozen.
    pub peer_deadline: f64,
    /// A place to stay at (tests).
    pub hold: Option<Hold>,
}

impl Assignment {
    /// The command-line form.
    ///
    /// # Panics
    /// Never: all fields have a JSON form.
    pub fn to_argument(&self) -> String {
        serde_json::to_string(self).unwrap_or_default()
    }

    /// Reads the command-line form.
    ///
    /// # Errors
    /// [`InterfaceError::Codec`]: it was not written by a coupler of this version.
    pub fn from_argument(text: &str) -> Result<Assignment, InterfaceError> {
        serde_json::from_str(text).map_err(|error| InterfaceError::Codec { detail: error.to_string() })
    }

    /// The run's identity.
    ///
    /// # Errors
    /// [`InterfaceError::Codec`]: it is not 16 hexadecimal digits.
    pub fn run_id(&self) -> Result<RunId, InterfaceError> {
        RunId::parse(&self.run).ok_or_else(|| InterfaceError::Codec {
            detail: format!("run id {:?} is not hexadecimal", self.run),
        })
    }

    /// How long the coupler may be silent.
    pub fn deadlines(&self) -> Deadlines {
        Deadlines { peer: Duration::from_secs_f64(self.peer_deadline), ..Deadlines::default() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_assignment_survives_the_command_line() {
        let assignment = Assignment {
            run: RunId::new().to_string(),
            case: "cases/a \"b\"".into(),
            set: vec!["time.end=\"1 s\"".into()],
            variant: None,
            name: Some("h2".into()),
            out: "out".into(),
            threads: 2,
            resume: None,
            peer_deadline: 10.0,
            hold: Some(Hold { window: 3, command: "advance".into(), marker: "held".into() }),
        };
        assert_eq!(Assignment::from_argument(&assignment.to_argument()).unwrap(), assignment);
        assert!(assignment.run_id().is_ok());
        assert!(Assignment { run: "x".into(), ..assignment }.run_id().is_err());
        assert!(Assignment::from_argument("{}").is_err());
    }
}
