//! One case run in three processes: set up, watched, ended, summed up.

use crate::error::CouplerError;
use crate::launch::{Child, locate};
use crate::session::Session;
use crate::simulation::{Simulation, Watcher};
use crate::verdict;
use case_io::check::Checks;
use case_io::document::Case;
use case_io::exit_code::ExitCode;
use case_io::output::{OutputError, replace_file};
use case_io::plan::Plan;
use case_io::summary::{Exit, Seconds, Summary};
use interface::InterfaceError;
use interface::assignment::Assignment;
use interface::message::{Ready, Usage};
use interface::participant::Hold;
use interface::run::{RunId, Who, check_folder, free_shared_memory, sweep};
use interface::transport::{Deadlines, shared_memory};
use interface::usage::own_usage;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fmt::Display;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

/// What the command line asks for.
#[derive(Clone, Debug, Default)]
pub struct Request {
    /// The case folder or file as given.
    pub case: PathBuf,
    /// `--set`.
    pub set: Vec<String>,
    /// `--variant`.
    pub variant: Option<String>,
    /// Which run of the case's sweep, if it is one.
    pub run: Option<String>,
    /// Threads per solver; 0: all cores.
    pub threads: usize,
    /// Folder of the executables.
    pub bin_dir: Option<PathBuf>,
    /// A place where a participant stays (tests).
    pub hold: Option<(Who, Hold)>,
}

/// Where a run came from: what `resume` needs to make it again.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Origin {
    /// The case folder or file, absolute.
    pub case: PathBuf,
    /// `--set`.
    pub set: Vec<String>,
    /// `--variant`.
    pub variant: Option<String>,
    /// Which run of the sweep, if it was one.
    pub run: Option<String>,
}

const ORIGIN: &str = "origin.json";

impl Origin {
    fn write(&self, out: &Path) -> Result<(), CouplerError> {
        let text = serde_json::to_string_pretty(self).unwrap_or_default();
        Ok(replace_file(&out.join(ORIGIN), &[text.as_bytes()])?)
    }

    /// Of an output folder.
    ///
    /// # Errors
    /// The folder is no output of `coupler run`.
    pub fn read(out: &Path) -> Result<Origin, CouplerError> {
        let path = out.join(ORIGIN);
        let no_run = |found: &dyn Display| CouplerError::CommandLine {
            message: format!(
                "{}: {found}; allowed: the output folder of a run; name one, of a sweep the folder of one of its runs",
                path.display()
            ),
        };
        let text = fs::read_to_string(&path).map_err(|error| no_run(&error))?;
        serde_json::from_str(&text).map_err(|error| no_run(&error))
    }
}

/// Runs a case into `out` and leaves summary and report there, whatever happens.
///
/// # Errors
/// Only what prevents even that: an output folder that cannot be written.
pub fn run(
    case: &Case,
    request: &Request,
    out: &Path,
    resume: Option<&Path>,
    interrupted: &AtomicBool,
    watcher: &mut dyn Watcher,
) -> Result<Summary, CouplerError> {
    let start = Instant::now();
    make_folders(out)?;
    if resume.is_none() {
        origin(case, request).write(out)?;
    }
    sweep();
    let mut story = Story::default();
    let result = simulate(case, request, out, resume, interrupted, watcher, &mut story);
    let wall = start.elapsed().as_secs_f64();
    let mut summary = story.summary(case, wall);
    match result {
        Ok(()) => verdict::judge(case, out, &mut summary)?,
        Err(error) => summary.exit = Exit { code: error.exit_code(), reason: error.to_string() },
    }
    summary.write(&out.join("summary.json"))?;
    report::report(out)?;
    Ok(summary)
}

/// What is known of a run when it ends, well or not.
#[derive(Default)]
struct Story {
    time: f64,
    counts: case_io::summary::Counts,
    ledger: BTreeMap<String, case_io::summary::LedgerMaximum>,
    usages: Vec<(Who, Usage)>,
    windows_seconds: f64,
    /// Of the windows, what the participants were not computing: laws, frames, books, series.
    exchange_seconds: f64,
}

impl Story {
    fn summary(self, case: &Case, wall: f64) -> Summary {
        let own = own_usage();
        let mut seconds = BTreeMap::new();
        let mut thrift = BTreeMap::new();
        let mut taken = BTreeMap::new();
        let mut audits = BTreeMap::new();
        let mut peak_memory = own.peak_memory;
        for (who, usage) in self.usages {
            let computing: f64 = usage.parts.iter().map(|(_, wall)| wall).sum();
            for (part, wall) in usage.parts {
                // A process does not know its CPU seconds by part: they are shared out by wall time.
                let cpu = if computing > 0.0 { usage.cpu_seconds * wall / computing } else { 0.0 };
                seconds.insert(format!("{who}: {part}"), Seconds { wall, cpu });
            }
            thrift.extend(usage.counters);
            taken.extend(usage.taken);
            audits.extend(usage.audits);
            peak_memory += usage.peak_memory;
        }
        seconds.insert(
            "coupler: exchange".into(),
            Seconds { wall: self.exchange_seconds, cpu: own.cpu_seconds },
        );
        // Start and end of the processes, frames and restart points, the wait for a wake-up: the rest of the run's time.
        let known: f64 = seconds.values().map(|part| part.wall).sum();
        seconds.insert("set-up, output, waiting".into(), Seconds { wall: (wall - known).max(0.0), cpu: 0.0 });
        Summary {
            case: case.document.case.title.clone(),
            case_hash: case.hash.clone(),
            program_version: env!("CARGO_PKG_VERSION").to_string(),
            exit: Exit { code: ExitCode::Done, reason: "done".to_string() },
            time: self.time,
            seconds,
            counts: self.counts,
            peak_memory,
            thrift,
            taken,
            audits,
            ledger: self.ledger,
            checks: Vec::new(),
        }
    }
}

fn make_folders(out: &Path) -> Result<(), CouplerError> {
    for folder in ["series", "frames", "restart"] {
        let path = out.join(folder);
        fs::create_dir_all(&path).map_err(OutputError::system("create", &path))?;
    }
    Ok(())
}

fn simulate(
    case: &Case,
    request: &Request,
    out: &Path,
    resume: Option<&Path>,
    interrupted: &AtomicBool,
    watcher: &mut dyn Watcher,
    story: &mut Story,
) -> Result<(), CouplerError> {
    require_sound_checks(case)?;
    let (session, mut children) = launch(case, request, out, resume)?;
    let mut simulation = match Simulation::start(case, session, out, resume) {
        Ok(simulation) => simulation,
        Err(error) => return Err(explain_death(error, &mut children)),
    };
    let start = Instant::now();
    let waited = simulation.waited();
    let result = simulation.run(interrupted, watcher);
    story.windows_seconds = start.elapsed().as_secs_f64();
    story.exchange_seconds = story.windows_seconds - (simulation.waited() - waited);
    (story.time, story.counts, story.ledger) =
        (simulation.time(), simulation.counts, simulation.ledger.maxima());
    let reason = match &result {
        Ok(()) => "done".to_string(),
        Err(error) => error.to_string(),
    };
    let mut session = simulation.into_session();
    for child in &mut children {
        end(&mut session, child, &reason, result.as_ref().err(), story);
    }
    let result = result.map_err(|error| explain_death(error, &mut children));
    // No child outlives the session, which removes the shared memory when it is the last.
    drop(children);
    result
}

/// What the participants find in a case, without running it: `coupler check`.
///
/// # Errors
/// What keeps the case from running.
pub fn survey(case: &Case, request: &Request) -> Result<Vec<String>, CouplerError> {
    sweep();
    let out = check_folder()?;
    let result = survey_into(case, request, &out);
    // What cannot be removed now is swept later.
    let _ = fs::remove_dir_all(&out);
    result
}

fn survey_into(case: &Case, request: &Request, out: &Path) -> Result<Vec<String>, CouplerError> {
    require_sound_checks(case)?;
    make_folders(out)?;
    let (mut session, mut children) = launch(case, request, out, None)?;
    let plan = Plan::of(&case.document).hash();
    let result = session.greet(&case.hash, &plan).map_err(|error| explain_death(error, &mut children));
    for child in &mut children {
        end(&mut session, child, "checked", result.as_ref().err(), &mut Story::default());
    }
    drop(children);
    let notes = |(who, ready): (Who, Ready)| -> Vec<String> {
        ready.notes.iter().map(|note| format!("{who}: {note}")).collect()
    };
    Ok(result?.into_iter().flat_map(notes).collect())
}

/// A check that cannot be understood is found before the run, not after it.
fn require_sound_checks(case: &Case) -> Result<(), CouplerError> {
    if let Some(checks) = Checks::load(&case.folder)? {
        checks.of(case)?;
    }
    Ok(())
}

/// The wires of a run and its first frames touch this much shared memory; a page of it that cannot be had kills
/// whoever touches it.
const LEAST_SHARED_MEMORY: u64 = 2 << 20;
/// Rows that the first frames have room for.
const FIRST_ROWS: u64 = 1024;

fn require_shared_memory() -> Result<(), CouplerError> {
    let (needed, free) = (LEAST_SHARED_MEMORY, free_shared_memory()?);
    if needed <= free {
        return Ok(());
    }
    Err(InterfaceError::NoSpace { needed, free, rows: FIRST_ROWS, path: "/dev/shm".to_string() }.into())
}

/// Starts what the case needs and waits until all have joined.
fn launch(
    case: &Case,
    request: &Request,
    out: &Path,
    resume: Option<&Path>,
) -> Result<(Session, Vec<Child>), CouplerError> {
    let id = RunId::new();
    let deadlines = deadlines(case);
    let members = members(case);
    let executables = members
        .iter()
        .map(|who| locate(*who, request.bin_dir.as_deref()))
        .collect::<Result<Vec<PathBuf>, CouplerError>>()?;
    let log = out.join("log.txt");
    let header = format!("run {id}\nversion {}\n", env!("CARGO_PKG_VERSION"));
    fs::write(&log, header).map_err(OutputError::system("write", &log))?;
    require_shared_memory()?;
    let ends = shared_memory::create(id, deadlines)?;
    let mut session =
        Session { ends, dem: members.contains(&Who::Dem), fluid: members.contains(&Who::Fluid), waited: 0.0 };
    let mut children = Vec::new();
    for (who, executable) in members.iter().zip(&executables) {
        let part = assignment(case, request, out, resume, *who, id, deadlines);
        children.push(Child::start(*who, executable, &part, &log)?);
    }
    for child in &mut children {
        let wire = if child.who() == Who::Dem { &session.ends.dem } else { &session.ends.fluid };
        child.wait_joined(wire)?;
    }
    session.ends.dem.watch_peers(&members);
    session.ends.fluid.watch_peers(&members);
    Ok((session, children))
}

/// Ends a participant: asked to stop if it can hear, killed if it is frozen.
fn end(
    session: &mut Session,
    child: &mut Child,
    reason: &str,
    cause: Option<&CouplerError>,
    story: &mut Story,
) {
    let who = child.who();
    match cause {
        Some(CouplerError::Interface(InterfaceError::PeerFrozen { who: frozen, .. })) if *frozen == who => {
            child.kill()
        }
        Some(CouplerError::Interface(InterfaceError::AnswerOverdue { who: busy, .. })) if *busy == who => {
            child.kill()
        }
        // A participant that has failed has ended by itself.
        Some(CouplerError::Participant { who: failed, .. }) if *failed == who.name() => {}
        _ if child.status().is_some() => {}
        _ => {
            match session.stop(who, reason) {
                Ok(usage) => story.usages.push((who, usage)),
                // Busy, held or dying: what it has not committed is lost anyway.
                Err(_) => child.kill(),
            }
        }
    }
}

/// Says how a dead participant died.
fn explain_death(error: CouplerError, children: &mut [Child]) -> CouplerError {
    match error {
        CouplerError::Interface(InterfaceError::PeerDied { who, how }) if how.is_empty() => {
            let status = children.iter_mut().find(|child| child.who() == who).and_then(Child::status);
            let how = status.map_or_else(String::new, |status| format!(" ({status})"));
            InterfaceError::PeerDied { who, how }.into()
        }
        other => other,
    }
}

fn origin(case: &Case, request: &Request) -> Origin {
    Origin {
        case: fs::canonicalize(&request.case).unwrap_or_else(|_| request.case.clone()),
        set: request.set.clone(),
        variant: request.variant.clone(),
        run: case.run.clone(),
    }
}

fn members(case: &Case) -> Vec<Who> {
    let dem = case.document.grains.as_ref().map(|_| Who::Dem);
    let fluid = case.document.fluid.as_ref().map(|_| Who::Fluid);
    dem.into_iter().chain(fluid).collect()
}

fn deadlines(case: &Case) -> Deadlines {
    case.document.coupling.as_ref().map_or_else(Deadlines::default, |coupling| Deadlines {
        peer: Duration::from_secs_f64(coupling.peer_deadline.si()),
        answer: Duration::from_secs_f64(coupling.answer_deadline.si()),
    })
}

fn assignment(
    case: &Case,
    request: &Request,
    out: &Path,
    resume: Option<&Path>,
    who: Who,
    id: RunId,
    deadlines: Deadlines,
) -> Assignment {
    Assignment {
        run: id.to_string(),
        case: request.case.clone(),
        set: request.set.clone(),
        variant: request.variant.clone(),
        name: request.run.clone().or_else(|| case.run.clone()),
        out: out.to_path_buf(),
        threads: request.threads,
        resume: resume.map(Path::to_path_buf),
        peer_deadline: deadlines.peer.as_secs_f64(),
        hold: request.hold.as_ref().filter(|(held, _)| *held == who).map(|(_, hold)| hold.clone()),
    }
}
