//! How a command ends: in time, with a code, with one line, with nothing left.

use crate::support::{COUPLER, Folder};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Every case here is done or refused well within a second; a loaded machine gets more.
const DEADLINE: Duration = Duration::from_secs(30);

/// What a command left to the user.
pub struct Ending {
    pub code: i32,
    /// Standard error.
    pub words: String,
}

/// `coupler` in the folder, to its end, which must owe nothing.
pub fn coupler(folder: &Folder, arguments: &[&str]) -> Ending {
    let mut command = Command::new(COUPLER);
    command.args(arguments);
    ending(folder, command)
}

/// Runs a command in the folder to its end.
pub fn ending(folder: &Folder, mut command: Command) -> Ending {
    command.current_dir(&folder.0).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    let pid = child.id();
    let start = Instant::now();
    while child.try_wait().unwrap().is_none() {
        if start.elapsed() > DEADLINE {
            child.kill().unwrap();
            panic!("{command:?} goes on after {DEADLINE:?}");
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    let output = child.wait_with_output().unwrap();
    let words = String::from_utf8(output.stderr).unwrap();
    assert_eq!(children(&folder.0), Vec::<String>::new(), "{command:?} leaves processes");
    assert_eq!(files_of_runs(pid), Vec::<PathBuf>::new(), "{command:?} leaves files");
    let code = output.status.code();
    Ending { code: code.unwrap_or_else(|| panic!("{command:?}: {}: {words}", output.status)), words }
}

impl Ending {
    /// The one line of an error.
    pub fn line(&self) -> &str {
        let lines: Vec<&str> = self.words.lines().collect();
        let [line] = lines[..] else { panic!("one line is due, this is said: {:?}", self.words) };
        assert!(!line.contains("panicked"), "{line}");
        line.strip_prefix("error: ").unwrap_or_else(|| panic!("no error: {line}"))
    }

    /// Ended with this code and one line that holds all these parts; returns it.
    pub fn assert_line(&self, code: i32, parts: &[&str]) -> &str {
        let line = self.line();
        assert_eq!(self.code, code, "{line}");
        for part in parts {
            assert!(line.contains(part), "{part:?} is not in: {line}");
        }
        line
    }
}

/// Solvers that live and carry the folder on their command line.
pub fn children(folder: &Path) -> Vec<String> {
    let needle = folder.display().to_string();
    let lines = fs::read_dir("/proc").unwrap().flatten().filter_map(|entry| {
        let line = fs::read(entry.path().join("cmdline")).ok()?;
        let line = String::from_utf8_lossy(&line).replace('\0', " ");
        (line.contains(" participate ") && line.contains(&needle)).then_some(line)
    });
    lines.collect()
}

/// Files in shared memory and in the folder of runs that belong to this coupler: the last 16 bits of a run's identity are
/// its process id's, and the folder of a check carries it.
pub fn files_of_runs(coupler: u32) -> Vec<PathBuf> {
    let inside = |folder: &Path| -> Vec<PathBuf> {
        fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path()).collect()
    };
    let roots = inside(Path::new("/tmp")).into_iter().filter(|path| name(path).starts_with("silt-"));
    let files = inside(Path::new("/dev/shm"));
    let is_its = |path: &PathBuf| {
        let name = name(path);
        let run =
            u64::from_str_radix(name.strip_prefix("silt_").unwrap_or(&name).get(..16).unwrap_or(""), 16);
        run.is_ok_and(|run| run & 0xffff == u64::from(coupler & 0xffff))
            || name.starts_with(&format!("check-{coupler}-"))
    };
    files.into_iter().chain(roots.flat_map(|root| inside(&root))).filter(is_its).collect()
}

fn name(path: &Path) -> String {
    path.file_name().unwrap().to_string_lossy().into_owned()
}

mod tests {
    use super::*;
    use crate::scene::Scene;
    use crate::support::Live;

    #[test]
    fn what_a_living_run_holds_is_seen() {
        let scene = Scene::coupled();
        let out = scene.folder.join("out");
        let mut live = Live::start(&scene.path(), &out, &[], &["--hold", "dem-solver:1:advance"]);
        live.wait_held();
        assert_eq!(children(&scene.folder.0).len(), 2);
        let files = files_of_runs(live.child.id());
        assert!(files.iter().any(|path| path.starts_with("/dev/shm")), "{files:?}");
        assert!(files.iter().any(|path| path.starts_with("/tmp")), "{files:?}");
        crate::support::signal(live.child.id(), "KILL");
        live.exit_code(DEADLINE);
        crate::support::wait_until("the solvers end", DEADLINE, || children(&scene.folder.0).is_empty());
    }

    #[test]
    fn what_a_killed_check_leaves_is_swept() {
        let scene = Scene::coupled();
        let mut check =
            Command::new(COUPLER).arg("check").arg(scene.path()).stdout(Stdio::null()).spawn().unwrap();
        let pid = check.id();
        let left = || files_of_runs(pid).into_iter().any(|path| name(&path).starts_with("check-"));
        crate::support::wait_until("the check writes", DEADLINE, left);
        crate::support::signal(pid, "KILL");
        assert!(left(), "there is something to sweep");
        check.wait().unwrap();
        crate::support::wait_until("the solvers end", DEADLINE, || children(&scene.folder.0).is_empty());
        assert_eq!(coupler(&scene.folder, &["clean"]).code, 0);
        assert!(!left(), "it is swept");
    }
}
