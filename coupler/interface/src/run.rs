//! A run: its identity, its names in shared memory, and the sweeping of what dead runs left.

use crate::error::InterfaceError;
use crate::pulse::PulseMap;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::fs::{DirBuilder, Permissions};
use std::io::ErrorKind;
use std::os::unix::fs::{DirBuilderExt, MetadataExt, PermissionsExt};
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

fn user() -> u32 {
    // SAFETY: geteuid has no preconditions and cannot fail.
    unsafe { libc::geteuid() }
}

/// Folder of this user's runs and checks. Fixed whatever TMPDIR says: paths of sockets end at 108 bytes.
fn runs_folder() -> PathBuf {
    PathBuf::from(format!("/tmp/silt-{}", user()))
}

/// The folder of runs, made if need be.
pub(crate) fn make_runs_folder() -> Result<PathBuf, InterfaceError> {
    let folder = runs_folder();
    make_private(&folder, user())?;
    Ok(folder)
}

/// Makes a folder that only `user` can look into, or tightens the one that is there; another's is refused.
fn make_private(folder: &Path, user: u32) -> Result<(), InterfaceError> {
    let refused =
        |found: String| InterfaceError::RunsFolder { path: folder.display().to_string(), found, user };
    let failed = |error: std::io::Error| refused(error.to_string());
    match DirBuilder::new().mode(0o700).create(folder) {
        Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
        made => return made.map_err(failed),
    }
    let found = folder.symlink_metadata().map_err(failed)?;
    if !found.is_dir() {
        return Err(refused("it is no folder".to_string()));
    }
    if found.uid() != user {
        return Err(refused(format!("it belongs to user {}", found.uid())));
    }
    if found.mode() & 0o077 != 0 {
        std::fs::set_permissions(folder, Permissions::from_mode(0o700)).map_err(failed)?;
    }
    Ok(())
}

/// A folder for what a check writes, of this process alone; [`sweep`] removes it when the process is gone.
///
/// # Errors
/// [`InterfaceError::RunsFolder`]
pub fn check_folder() -> Result<PathBuf, InterfaceError> {
    let pid = std::process::id();
    let folder = make_runs_folder()?.join(format!("check-{pid}-{}", process_start(pid).unwrap_or(0)));
    make_private(&folder, user())?;
    Ok(folder)
}

/// Whether the name is that of the folder of a check whose process is gone.
fn is_dead_check(name: &str) -> bool {
    let process = || -> Option<(u32, u64)> {
        let (pid, start) = name.strip_prefix("check-")?.split_once('-')?;
        Some((pid.parse().ok()?, start.parse().ok()?))
    };
    process().is_some_and(|(pid, start)| process_start(pid) != Some(start))
}

/// Removes what this user's dead runs and checks left in shared memory and among temporary files; returns how many
/// they were.
pub fn sweep() -> usize {
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
    let checks: Vec<PathBuf> = names_in(&runs_folder())
        .filter(|name| is_dead_check(name))
        .map(|name| runs_folder().join(name))
        .filter(|folder| is_of_user(folder))
        .collect();
    for folder in &checks {
        // Whatever another sweeper has removed already is gone as wished.
        let _ = std::fs::remove_dir_all(folder);
    }
    runs.len() + checks.len()
}

fn names_in(folder: &Path) -> impl Iterator<Item = String> {
    std::fs::read_dir(folder)
        .into_iter()
        .flatten()
        .flatten()
        .map(|entry| entry.file_name().to_string_lossy().into_owned())
}

fn is_own(run: RunId) -> bool {
    [run.pulse_path(), run.root()].iter().any(|path| is_of_user(path))
}

fn is_of_user(path: &Path) -> bool {
    path.symlink_metadata().is_ok_and(|data| data.uid() == user())
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
    fn a_folder_of_runs_is_of_its_user_alone() {
        let folder = std::env::temp_dir().join(format!("silt-private-{}", std::process::id()));
        std::fs::create_dir(&folder).unwrap();
        std::fs::set_permissions(&folder, Permissions::from_mode(0o777)).unwrap();
        let foreign = make_private(&folder, user() + 1).unwrap_err().to_string();
        assert!(foreign.contains(&format!(": it belongs to user {}; allowed: ", user())), "{foreign}");
        make_private(&folder, user()).unwrap();
        assert_eq!(folder.metadata().unwrap().mode() & 0o777, 0o700);
        std::fs::remove_dir(&folder).unwrap();
        std::os::unix::fs::symlink(std::env::temp_dir(), &folder).unwrap();
        assert!(make_private(&folder, user()).is_err(), "a link may lead anywhere");
        std::fs::remove_file(&folder).unwrap();
    }

    #[test]
    fn the_folder_of_a_check_is_dead_when_its_process_is() {
        let pid = std::process::id();
        let start = process_start(pid).unwrap();
        assert!(!is_dead_check(&format!("check-{pid}-{start}")));
        assert!(is_dead_check(&format!("check-{pid}-{}", start + 1)), "another process has the number now");
        assert!(is_dead_check("check-0-1"));
        assert!(!is_dead_check("check-") && !is_dead_check("0123456789abcdef"));
    }

    #[test]
    fn this_process_is_alive_and_pid_zero_is_not() {
        assert!(process_start(std::process::id()).is_some());
        assert!(process_start(0).is_none());
    }
}
