//! Starting a peer: is it there, is it the known version, did it get to its end.

use std::fs::{self, File as DiskFile};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus, Stdio};
use std::time::Instant;

use case_io::output::OutputError;

use super::error::PeerError;
use super::{File, LOOP_TIME, Peer};

/// Everything a peer says, in the folder of its deck.
const LOG: &str = "log.txt";
/// So many of its lines are told when it fails.
const TAIL: usize = 4;

/// A peer that is installed, in the known version.
pub struct Installed {
    peer: &'static dyn Peer,
    executable: PathBuf,
}

impl Installed {
    /// Looks for the peer, at `program` if it is named, and asks for its version.
    ///
    /// # Errors
    /// No such program, or another version.
    pub fn find(peer: &'static dyn Peer, program: Option<&Path>) -> Result<Self, PeerError> {
        let named = program.unwrap_or(Path::new(peer.executable()));
        // A path is from here, whatever folder the peer will run in; a bare name is looked up.
        let executable = match named.components().count() {
            1 => named.to_path_buf(),
            _ => std::path::absolute(named).unwrap_or(named.to_path_buf()),
        };
        let (question, [before, behind]) = peer.version_question();
        let shown = executable.display().to_string();
        let answer = Command::new(&executable).arg(question).stdin(Stdio::null()).output();
        let answer = answer.map_err(|source| PeerError::NotInstalled {
            peer: peer.name(),
            executable: shown.clone(),
            install: peer.install(),
            source,
        })?;
        let said = [answer.stdout, answer.stderr].concat();
        let said = String::from_utf8_lossy(&said);
        let version = said.split_once(before).and_then(|(_, rest)| rest.split(behind).next()).map(str::trim);
        let (name, wanted, install) = (peer.name(), peer.version(), peer.install());
        match version {
            Some(version) if version == wanted => Ok(Self { peer, executable }),
            Some(found) => Err(PeerError::OtherVersion {
                peer: name,
                executable: shown,
                found: found.to_string(),
                wanted,
                install,
            }),
            // A library that it needs is missing, or it is another program of this name.
            None => {
                let said = said.lines().find(|line| !line.trim().is_empty()).unwrap_or_default().to_string();
                Err(PeerError::NoVersion { peer: name, executable: shown, said, wanted, install })
            }
        }
    }

    /// Runs the deck in its folder to the end; wall time \[s\].
    ///
    /// # Errors
    /// The peer gave up: its last words.
    pub fn run(&self, folder: &Path) -> Result<f64, PeerError> {
        let log = folder.join(LOG);
        let file = DiskFile::create(&log).map_err(OutputError::system("write", &log))?;
        let copy = file.try_clone().map_err(OutputError::system("write", &log))?;
        let failed = |how: String| {
            let tail = tail(&log);
            PeerError::Failed { peer: self.peer.name(), how, tail, log: log.clone() }
        };
        let start = Instant::now();
        let status = Command::new(&self.executable)
            .args(self.peer.arguments())
            .current_dir(folder)
            // One thread, as this program's comparison of bits and of speed means it.
            .env("OMP_NUM_THREADS", "1")
            .stdin(Stdio::null())
            .stdout(file)
            .stderr(copy)
            .status()
            .map_err(|error| failed(error.to_string()))?;
        if status.success() { Ok(start.elapsed().as_secs_f64()) } else { Err(failed(ending(status))) }
    }

    /// Runs a deck that writes nothing to the end; wall time of its steps alone \[s\].
    ///
    /// # Errors
    /// The peer gave up: its last words; it does not tell the time.
    pub fn time(&self, folder: &Path) -> Result<f64, PeerError> {
        self.run(folder)?;
        let path = folder.join(LOG);
        let text = fs::read_to_string(&path).map_err(OutputError::system("read", &path))?;
        let told = text.rsplit_once(LOOP_TIME).and_then(|(_, rest)| rest.split_whitespace().next());
        let seconds = told.and_then(|word| word.parse().ok()).filter(|seconds: &f64| *seconds > 0.0);
        seconds.ok_or_else(|| PeerError::BadResult {
            path,
            problem: "it does not tell how long its steps took".into(),
            expected: format!("\"{LOOP_TIME}\" and seconds"),
        })
    }
}

/// Writes a deck into a folder, which it makes.
///
/// # Errors
/// The disk's.
pub fn write_deck(folder: &Path, deck: &[File]) -> Result<(), PeerError> {
    fs::create_dir_all(folder).map_err(OutputError::system("make", folder))?;
    for File { name, text } in deck {
        let path = folder.join(name);
        fs::write(&path, text).map_err(OutputError::system("write", &path))?;
    }
    Ok(())
}

fn ending(status: ExitStatus) -> String {
    use std::os::unix::process::ExitStatusExt;
    match (status.code(), status.signal()) {
        (Some(code), _) => format!("exit code {code}"),
        (None, Some(signal)) => format!("killed by signal {signal}"),
        (None, None) => status.to_string(),
    }
}

/// The last error and what follows it, or else the last lines that say something, in one.
fn tail(log: &Path) -> String {
    let bytes = fs::read(log).unwrap_or_default();
    let text = String::from_utf8_lossy(&bytes);
    let lines: Vec<&str> = text.lines().map(str::trim).filter(|line| !line.is_empty()).collect();
    let error = lines.iter().rposition(|line| line.to_lowercase().contains("error"));
    let start = error.unwrap_or(lines.len().saturating_sub(TAIL));
    let told: Vec<&str> = lines[start..].iter().take(TAIL).copied().collect();
    if told.is_empty() { "it said nothing".into() } else { told.join(" | ") }
}
