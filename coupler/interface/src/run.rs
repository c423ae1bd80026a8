//! A run: its identity, its names in shared memory, and the sweeping of what dead runs left.

use crate::error::InterfaceError;
use crate::pulse::PulseMap;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::path::{Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};

/// The three programs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Who {
    /// `coupler`.
    Coupler,
    /// `dem-solver`.
    Dem,
    /// `fluid-solver`.
    Fluid,
}

impl Who {
    /// All, in the order of their places in shared tables.
    pub const ALL: [Who; 3] = [Who::Coupler, Who::Dem, Who::Fluid];

    /// The executable's name.
    pub fn name(self) -> &'static str {
        match self {
            Who::Coupler => "coupler",
            Who::Dem => "dem-solver",
            Who::Fluid => "fluid-solver",
        }
    }

    pub(crate) fn index(self) -> usize {
        self as usize
    }
}

impl fmt::Display for Who {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.name())
    }
}

/// Names one run among all runs of this machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RunId(pub u64);

const MEMORY: &str = "/dev/shm";

impl RunId {
    /// A new identity from the clock and the process id.
    pub fn new() -> RunId {
        let nanoseconds =
            SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |elapsed| elapsed.as_nanos());
        RunId((nanoseconds as u64) << 16 ^ u64::from(std::process::id()))
    }

    /// Reads the form that [`fmt::Display`] writes.
    pub fn parse(text: &str) -> Option<RunId> {
        u64::from_str_radix(text, 16).ok().map(RunId)
    }

    /// Prefix of all shared-memory files of the run.
    pub(crate) fn prefix(self) -> String {
        format!("silt_{self}_")
    }

    /// Folder of the run's static files.
    pub(crate) fn root(self) -> PathBuf {
        runs_folder().join(self.to_string())
    }

    pub(crate) fn pulse_path(self) -> PathBuf {
        Path::new(MEMORY).join(format!("{}pulse", self.prefix()))
    }

    /// Removes the run's shared memory and static files. Only for runs with no living process.
    pub(crate) fn remove(self) {
        let prefix = self.prefix();
        for entry in std::fs::read_dir(MEMORY).into_iter().flatten().flatten() {
            if entry.file_name().to_string_lossy().starts_with(&prefix) {
                // Whatever another sweeper has removed already is gone as wished.
                let _ = std::fs::remove_file(entry.path());
            }
        }
        let _ = std::fs::remove_dir_all(self.root());
    }
}

impl Default for RunId {
    fn default() -> RunId {
        RunId::new()
    }
}

impl fmt::Display for RunId {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{:016x}", self.0)
    }
}

fn runs_folder() -> PathBuf {
    // SAFETY: geteuid has no preconditions and cannot fail.
    let user = unsafe { libc::geteuid() };
    std::env::temp_dir().join(format!("silt-{user}"))
}

/// Removes what this user's dead runs left in shared memory; returns their identities.
pub fn sweep() -> Vec<RunId> {
    let mut runs: Vec<RunId> = names_in(Path::new(MEMORY))
        .filter_map(|name| RunId::parse(name.strip_prefix("silt_")?.get(..16)?))
        .chain(names_in(&runs_folder()).filter_map(|name| RunId::parse(&name)))
        .collect();
    runs.sort_unstable_by_key(|run| run.0);
    runs.dedup();
    runs.retain(|run| is_own(*run) && !PulseMap::any_alive(*run));
    for run in &runs {
        run.remove();
    }
    runs
}

fn names_in(folder: &Path) -> impl Iterator<Item = String> {
    std::fs::read_dir(folder)
        .into_iter()
        .flatten()
        .flatten()
        .map(|entry| entry.file_name().to_string_lossy().into_owned())
}

fn is_own(run: RunId) -> bool {
    use std::os::unix::fs::MetadataExt;
    // SAFETY: geteuid has no preconditions and cannot fail.
    let user = unsafe { libc::geteuid() };
    [run.pulse_path(), run.root()].iter().any(|path| path.metadata().is_ok_and(|data| data.uid() == user))
}

/// Free bytes of shared memory.
///
/// # Errors
/// [`InterfaceError::Transport`] if the file system cannot be asked.
pub fn free_shared_memory() -> Result<u64, InterfaceError> {
    // SAFETY: the path is a NUL-terminated literal and `status` a valid place for the answer.
    let (code, status) = unsafe {
        let mut status: libc::statvfs = std::mem::zeroed();
        (libc::statvfs(c"/dev/shm".as_ptr(), &mut status), status)
    };
    if code != 0 {
        return Err(InterfaceError::Transport {
            what: "asking for its free space",
            detail: std::io::Error::last_os_error().to_string(),
            path: MEMORY.to_string(),
        });
    }
    Ok(status.f_bavail * status.f_frsize)
}

/// Refuses a request for more shared memory than is free.
pub(crate) fn require_space(needed: u64, rows: u64) -> Result<(), InterfaceError> {
    let free = free_shared_memory()?;
    if needed <= free {
        return Ok(());
    }
    Err(InterfaceError::NoSpace { needed, free, rows, path: MEMORY.to_string() })
}

/// Leaves Ctrl-C to the coupler, which ends the run at the next commit.
pub fn leave_interrupts_to_coupler() {
    // SAFETY: ignoring a signal has no preconditions.
    unsafe { libc::signal(libc::SIGINT, libc::SIG_IGN) };
}

/// When a process started, by the kernel's clock; none if it is dead or a zombie.
pub(crate) fn process_start(pid: u32) -> Option<u64> {
    let text = std::fs::read_to_string(format!("/proc/{pid}/stat")).ok()?;
    // The second field is the name in parentheses and may hold anything.
    let mut fields = text.get(text.rfind(')')? + 1..)?.split_whitespace();
    if matches!(fields.next()?, "Z" | "X") {
        return None;
    }
    fields.nth(18)?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_id_survives_the_command_line() {
        let run = RunId::new();
        assert_eq!(RunId::parse(&run.to_string()), Some(run));
    }

    #[test]
    fn this_process_is_alive_and_pid_zero_is_not() {
        assert!(process_start(std::process::id()).is_some());
        assert!(process_start(0).is_none());
    }
}
