//! Runs of the built executables in folders of their own.

#![allow(dead_code)]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::{Duration, Instant};

pub const COUPLER: &str = env!("CARGO_BIN_EXE_coupler");
pub const DEM: &str = env!("CARGO_BIN_EXE_dem-solver");
pub const FLUID: &str = env!("CARGO_BIN_EXE_fluid-solver");

/// A shipped case.
pub fn case(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("cases").join(name)
}

/// A folder that goes with its test.
pub struct Folder(pub PathBuf);

impl Folder {
    pub fn new() -> Folder {
        static COUNT: AtomicU32 = AtomicU32::new(0);
        let count = COUNT.fetch_add(1, Ordering::Relaxed);
        let path = std::env::temp_dir().join(format!("silt-test-{}-{count}", std::process::id()));
        fs::create_dir_all(&path).unwrap();
        Folder(path)
    }

    pub fn join(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    pub fn write(&self, name: &str, text: &str) -> PathBuf {
        let path = self.join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(&path, text).unwrap();
        path
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// `coupler` with these arguments, to its end.
pub fn coupler(arguments: &[&str]) -> Output {
    Command::new(COUPLER).args(arguments).output().unwrap()
}

/// `coupler run` of a case into a folder, with `--set` changes, to its end.
pub fn run(case: &Path, out: &Path, changes: &[&str], flags: &[&str]) -> Output {
    run_command(case, out, changes, flags).output().unwrap()
}

fn run_command(case: &Path, out: &Path, changes: &[&str], flags: &[&str]) -> Command {
    let mut command = Command::new(COUPLER);
    command.arg("run").arg(case).arg("--out").arg(out).args(flags);
    for change in changes {
        command.args(["--set", change]);
    }
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

/// A run in the background.
pub struct Live {
    pub child: Child,
    pub out: PathBuf,
}

impl Live {
    pub fn start(case: &Path, out: &Path, changes: &[&str], flags: &[&str]) -> Live {
        let child = run_command(case, out, changes, flags).spawn().unwrap();
        Live { child, out: out.to_path_buf() }
    }

    /// Waits until a participant has reached the place where it was told to stay.
    pub fn wait_held(&mut self) {
        wait_until("the participant is held", Duration::from_secs(60), || self.out.join("held").exists());
    }

    /// Process ids of the run's solvers, by executable name.
    pub fn solver(&self, name: &str) -> u32 {
        self.solvers().into_iter().find(|(_, found)| found == name).map(|(pid, _)| pid).unwrap()
    }

    /// The run's solvers that live: they carry the output folder on their command line.
    pub fn solvers(&self) -> Vec<(u32, String)> {
        let needle = self.out.display().to_string();
        let mut found = Vec::new();
        for entry in fs::read_dir("/proc").unwrap().flatten() {
            let Ok(pid) = entry.file_name().to_string_lossy().parse::<u32>() else { continue };
            let Ok(line) = fs::read(entry.path().join("cmdline")) else { continue };
            let line = String::from_utf8_lossy(&line).into_owned();
            let mut words = line.split('\0');
            let program = words.next().unwrap_or_default().to_string();
            if words.next() == Some("participate") && line.contains(&format!("\"{needle}\"")) {
                found.push((pid, Path::new(&program).file_name().unwrap().to_string_lossy().into_owned()));
            }
        }
        found
    }

    /// Shared-memory files of the run that are left.
    pub fn shared_memory(&self) -> Vec<String> {
        let prefix = format!("silt_{}", self.id());
        let names = fs::read_dir("/dev/shm").unwrap().flatten();
        names
            .map(|entry| entry.file_name().to_string_lossy().into_owned())
            .filter(|name| name.starts_with(&prefix))
            .collect()
    }

    /// The run's identity, from its log.
    pub fn id(&self) -> String {
        let log = fs::read_to_string(self.out.join("log.txt")).unwrap();
        log.lines().next().unwrap().strip_prefix("run ").unwrap().to_string()
    }

    /// Waits for the end; the exit code, none if a signal ended it.
    pub fn exit_code(&mut self, deadline: Duration) -> Option<i32> {
        let start = Instant::now();
        loop {
            if let Some(status) = self.child.try_wait().unwrap() {
                return status.code();
            }
            assert!(start.elapsed() < deadline, "the run goes on after {deadline:?}");
            std::thread::sleep(Duration::from_millis(10));
        }
    }
}

impl Drop for Live {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Sends a signal by its name.
pub fn signal(pid: u32, name: &str) {
    let status = Command::new("kill").args(["-s", name, &pid.to_string()]).status().unwrap();
    assert!(status.success());
}

/// Polls until true.
pub fn wait_until(what: &str, deadline: Duration, mut is_true: impl FnMut() -> bool) -> Duration {
    let start = Instant::now();
    while !is_true() {
        assert!(start.elapsed() < deadline, "not within {deadline:?}: {what}");
        std::thread::sleep(Duration::from_millis(10));
    }
    start.elapsed()
}

/// All series and frames of a run, as bytes by name.
pub fn results(out: &Path) -> Vec<(String, Vec<u8>)> {
    let mut files = Vec::new();
    for folder in ["series", "frames"] {
        let mut names: Vec<PathBuf> =
            fs::read_dir(out.join(folder)).unwrap().flatten().map(|entry| entry.path()).collect();
        names.sort();
        for path in names {
            files.push((path.strip_prefix(out).unwrap().display().to_string(), fs::read(&path).unwrap()));
        }
    }
    files
}

/// Asserts that two runs left the same bytes, naming the first file that differs.
pub fn assert_same_results(one: &Path, other: &Path) {
    let (one, other) = (results(one), results(other));
    let names = |files: &[(String, Vec<u8>)]| files.iter().map(|(name, _)| name.clone()).collect::<Vec<_>>();
    assert_eq!(names(&one), names(&other));
    for ((name, a), (_, b)) in one.iter().zip(&other) {
        assert!(a == b, "{name} differs");
    }
}

pub fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}
