//! Killed and frozen processes: whoever is struck, at whatever step of the window, the rest end in time with the
//! documented code, and nothing is left.

#[path = "../support/mod.rs"]
mod support;

use case_io::output::vtk::Collection;
use std::time::Duration;
use support::{Folder, Live, case, signal, wait_until};

const STEPS: [&str; 3] = ["open", "advance", "commit"];
const SOLVERS: [&str; 2] = ["dem-solver", "fluid-solver"];

/// A run whose named participant stays at a step of window 150, after a restart point.
fn held_run(folder: &Folder, who: &str, step: &str) -> Live {
    let changes = [
        "time.end=\"10 s\"",
        "output.series=\"1 ms\"",
        "output.restart=\"5 ms\"",
        "coupling.peer-deadline=\"2 s\"",
    ];
    let hold = format!("{who}:150:{step}");
    let flags = ["--hold", hold.as_str(), "--set", "coupling.added-mass=0.5"];
    let case = folder.write("case/case.toml", &one_run());
    let mut live = Live::start(&case, &folder.join("out"), &changes, &flags);
    live.wait_held();
    live
}

/// The shipped case without its sweep.
fn one_run() -> String {
    let text = std::fs::read_to_string(case("settling-ode").join("case.toml")).unwrap();
    text.split("[[run]]").next().unwrap().to_string()
}

fn assert_nothing_left(live: &Live) {
    wait_until("the solvers end", Duration::from_secs(5), || live.solvers().is_empty());
    wait_until("shared memory is removed", Duration::from_secs(5), || live.shared_memory().is_empty());
}

fn assert_resumable(live: &Live) {
    let restart = live.out.join("restart");
    let points: Vec<_> = std::fs::read_dir(restart).unwrap().flatten().map(|entry| entry.path()).collect();
    let complete =
        points.iter().filter(|path| path.join("manifest.json").exists() && !path.ends_with(".tmp"));
    assert!(complete.count() >= 1, "{points:?}");
}

#[test]
fn a_killed_solver_ends_the_run_with_code_9_within_5_seconds() {
    for held in SOLVERS {
        for step in STEPS {
            for victim in SOLVERS {
                let folder = Folder::new();
                let mut live = held_run(&folder, held, step);
                signal(live.solver(victim), "KILL");
                let code = live.exit_code(Duration::from_secs(5));
                assert_eq!(code, Some(9), "{victim} killed with {held} at {step}");
                assert_nothing_left(&live);
                assert_resumable(&live);
            }
        }
    }
}

#[test]
fn a_killed_coupler_leaves_no_solver_and_no_shared_memory() {
    for held in SOLVERS {
        for step in STEPS {
            let folder = Folder::new();
            let mut live = held_run(&folder, held, step);
            signal(live.child.id(), "KILL");
            live.exit_code(Duration::from_secs(5));
            assert_nothing_left(&live);
            assert_resumable(&live);
        }
    }
}

#[test]
fn a_frozen_solver_ends_the_run_with_code_10_at_its_deadline() {
    for held in SOLVERS {
        for step in STEPS {
            for victim in SOLVERS {
                let folder = Folder::new();
                let mut live = held_run(&folder, held, step);
                signal(live.solver(victim), "STOP");
                let code = live.exit_code(Duration::from_secs(2 + 5));
                assert_eq!(code, Some(10), "{victim} frozen with {held} at {step}");
                assert_nothing_left(&live);
            }
        }
    }
}

#[test]
fn solvers_leave_a_frozen_coupler_at_its_deadline() {
    let folder = Folder::new();
    let live = held_run(&folder, "dem-solver", "advance");
    signal(live.child.id(), "STOP");
    wait_until("the solvers end", Duration::from_secs(2 + 5), || live.solvers().is_empty());
    signal(live.child.id(), "KILL");
    drop(live);
}

#[test]
fn all_three_killed_at_once_are_swept_by_clean() {
    let folder = Folder::new();
    let mut live = held_run(&folder, "fluid-solver", "advance");
    let solvers: Vec<u32> = live.solvers().into_iter().map(|(pid, _)| pid).collect();
    // Stopped first, so that none has the time to tidy up.
    for pid in solvers.iter().copied().chain([live.child.id()]) {
        signal(pid, "STOP");
    }
    for pid in solvers.iter().copied().chain([live.child.id()]) {
        signal(pid, "KILL");
    }
    live.exit_code(Duration::from_secs(5));
    wait_until("the solvers end", Duration::from_secs(5), || live.solvers().is_empty());
    assert!(!live.shared_memory().is_empty(), "there is something to sweep");
    assert!(support::coupler(&["clean"]).status.success());
    assert!(live.shared_memory().is_empty());
}

#[test]
fn an_interrupt_ends_the_run_cleanly_at_the_next_commit() {
    let folder = Folder::new();
    let case = folder.write("case/case.toml", &one_run());
    let mut live = Live::start(&case, &folder.join("out"), &["time.end=\"1000 s\""], &[]);
    wait_until("the run has begun", Duration::from_secs(60), || live.out.join("series/ledger.csv").exists());
    std::thread::sleep(Duration::from_millis(300));
    signal(live.child.id(), "INT");
    assert_eq!(live.exit_code(Duration::from_secs(5)), Some(130));
    assert_nothing_left(&live);
    assert!(live.out.join("report.html").exists(), "an interrupted run has its report");
}

#[test]
fn a_run_without_frames_in_time_shows_its_end() {
    let folder = Folder::new();
    let case = folder.write("case/case.toml", &one_run());
    let out = folder.join("out");
    let output = support::run(&case, &out, &["time.end=\"20 ms\"", "output.frames=\"none\""], &[]);
    assert!(output.status.success(), "{}", support::stderr(&output));
    let frames = Collection::open(&out.join("frames/grains.pvd")).unwrap();
    assert_eq!(frames.entries().iter().map(|entry| entry.time).collect::<Vec<_>>(), [0.02]);
    assert!(out.join("picture.png").exists());
    assert!(std::fs::read_to_string(out.join("report.html")).unwrap().contains("The scene at t = 0.02 s"));
}

#[test]
fn a_suspended_run_goes_on() {
    let folder = Folder::new();
    let case = folder.write("case/case.toml", &one_run());
    let changes = ["coupling.peer-deadline=\"1 s\""];
    let mut live = Live::start(&case, &folder.join("out"), &changes, &[]);
    wait_until("the run has begun", Duration::from_secs(60), || live.out.join("series/ledger.csv").exists());
    let pids: Vec<u32> = live.solvers().into_iter().map(|(pid, _)| pid).chain([live.child.id()]).collect();
    pids.iter().for_each(|pid| signal(*pid, "STOP"));
    std::thread::sleep(Duration::from_secs(3));
    pids.iter().for_each(|pid| signal(*pid, "CONT"));
    assert_eq!(live.exit_code(Duration::from_secs(60)), Some(0));
}

#[test]
fn two_runs_side_by_side_do_not_disturb_each_other() {
    let folder = Folder::new();
    let case = folder.write("case/case.toml", &one_run());
    let mut runs: Vec<Live> =
        ["a", "b"].iter().map(|name| Live::start(&case, &folder.join(name), &[], &[])).collect();
    for live in &mut runs {
        assert_eq!(live.exit_code(Duration::from_secs(60)), Some(0));
    }
    support::assert_same_results(&folder.join("a"), &folder.join("b"));
}
