//! Starting the other programs, and making sure that none outlives the run.

use crate::error::CouplerError;
use interface::assignment::Assignment;
use interface::run::Who;
use interface::transport::CommandSender;
use std::fs::{File, OpenOptions};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// A started solver; killed when dropped.
pub struct Child {
    who: Who,
    process: std::process::Child,
    log: PathBuf,
}

/// How long a stopped participant may take to end by itself.
const PATIENCE: Duration = Duration::from_secs(3);

/// The executable of a program: beside this one, or in the folder named.
///
/// # Errors
/// [`CouplerError::ExecutableMissing`].
pub fn locate(who: Who, folder: Option<&Path>) -> Result<PathBuf, CouplerError> {
    let own = std::env::current_exe().ok();
    let folder = folder.or_else(|| own.as_deref().and_then(Path::parent)).unwrap_or(Path::new("."));
    let path = folder.join(who.name());
    if path.is_file() { Ok(path) } else { Err(CouplerError::ExecutableMissing { path }) }
}

impl Child {
    /// Starts a solver with its part of the run; what it writes goes to the log.
    ///
    /// # Errors
    /// The system's.
    pub fn start(who: Who, executable: &Path, part: &Assignment, log: &Path) -> Result<Child, CouplerError> {
        let not_started = |error: std::io::Error| CouplerError::NotStarted {
            path: executable.to_path_buf(),
            detail: error.to_string(),
        };
        let output = || -> std::io::Result<File> { OpenOptions::new().append(true).create(true).open(log) };
        let process = Command::new(executable)
            .arg("participate")
            .arg(part.to_argument())
            .stdin(Stdio::null())
            .stdout(output().map_err(not_started)?)
            .stderr(output().map_err(not_started)?)
            .spawn()
            .map_err(not_started)?;
        Ok(Child { who, process, log: log.to_path_buf() })
    }

    /// Waits until the solver has joined the run.
    ///
    /// # Errors
    /// [`CouplerError::NotJoined`] if it ended first or does not come.
    pub fn wait_joined(&mut self, wire: &CommandSender) -> Result<(), CouplerError> {
        let start = Instant::now();
        while !wire.has_joined() {
            let status = match self.process.try_wait() {
                Ok(Some(status)) => status.to_string(),
                _ if start.elapsed() > Duration::from_secs(60) => "no sign of life within 60 s".to_string(),
                _ => {
                    std::thread::sleep(Duration::from_millis(2));
                    continue;
                }
            };
            return Err(CouplerError::NotJoined { who: self.who.name(), status, log: self.log.clone() });
        }
        Ok(())
    }

    /// How the solver ended, if it did: for messages.
    pub fn status(&mut self) -> Option<String> {
        self.process.try_wait().ok().flatten().map(|status| status.to_string())
    }

    /// The program.
    pub fn who(&self) -> Who {
        self.who
    }

    fn wait_ended(&mut self) -> bool {
        let start = Instant::now();
        while start.elapsed() < PATIENCE {
            if !matches!(self.process.try_wait(), Ok(None)) {
                return true;
            }
            std::thread::sleep(Duration::from_millis(5));
        }
        false
    }

    /// Ends the solver at once: it is frozen, or no longer needed.
    pub fn kill(&mut self) {
        // A process that has ended already needs no killing.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

impl Drop for Child {
    fn drop(&mut self) {
        if !self.wait_ended() {
            self.kill();
        }
    }
}
