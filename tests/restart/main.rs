//! Stop + resume gives the bits of running through, whatever stopped the run.

#[path = "../support/mod.rs"]
mod support;

use std::time::Duration;
use support::{Folder, Live, assert_same_results, case, coupler, run, signal, stderr, wait_until};

fn one_run() -> String {
    let text = std::fs::read_to_string(case("settling-ode").join("case.toml")).unwrap();
    text.split("[[run]]").next().unwrap().to_string()
}

const CHANGES: [&str; 3] = ["output.series=\"1 ms\"", "output.restart=\"5 ms\"", "output.frames=\"2 ms\""];

#[test]
fn a_run_killed_and_resumed_leaves_the_bytes_of_a_run_through() {
    let folder = Folder::new();
    let case = folder.write("case/case.toml", &one_run());
    let through = run(&case, &folder.join("through"), &CHANGES, &[]);
    assert!(through.status.success(), "{}", stderr(&through));

    let hold = ["--hold", "fluid-solver:1177:advance"];
    let mut live = Live::start(&case, &folder.join("killed"), &CHANGES, &hold);
    live.wait_held();
    let solvers = live.solvers();
    for pid in solvers.iter().map(|(pid, _)| *pid).chain([live.child.id()]) {
        signal(pid, "KILL");
    }
    live.exit_code(Duration::from_secs(5));
    let resumed = coupler(&["resume", live.out.to_str().unwrap()]);
    assert!(resumed.status.success(), "{}", stderr(&resumed));
    assert_same_results(&folder.join("through"), &folder.join("killed"));
}

/// Contacts, walls, insertion over time and a two-way fluid: stopped by Ctrl-C at some commit, killed, or run through.
#[test]
fn a_coupled_run_with_contacts_resumes_to_the_same_bytes() {
    let folder = Folder::new();
    let case = case("pipe-sediment");
    let changes = [
        "time.end=\"0.2 s\"",
        "output.series=\"8 ms\"",
        "output.restart=\"40 ms\"",
        "output.frames=\"40 ms\"",
    ];
    let through = run(&case, &folder.join("through"), &changes, &[]);
    // The checks of the case are about its end.
    assert_eq!(through.status.code(), Some(4), "{}", stderr(&through));

    let mut live = Live::start(&case, &folder.join("killed"), &changes, &["--hold", "dem-solver:37:commit"]);
    live.wait_held();
    for pid in live.solvers().iter().map(|(pid, _)| *pid).chain([live.child.id()]) {
        signal(pid, "KILL");
    }
    live.exit_code(Duration::from_secs(5));
    let resumed = coupler(&["resume", live.out.to_str().unwrap()]);
    assert_eq!(resumed.status.code(), Some(4), "{}", stderr(&resumed));
    assert_same_results(&folder.join("through"), &folder.join("killed"));

    let mut live = Live::start(&case, &folder.join("stopped"), &changes, &[]);
    let some_windows = || {
        std::fs::read_to_string(live.out.join("series/ledger.csv"))
            .is_ok_and(|rows| rows.lines().count() > 30)
    };
    wait_until("there is a restart point, and windows after it", Duration::from_secs(60), some_windows);
    signal(live.child.id(), "INT");
    assert_eq!(live.exit_code(Duration::from_secs(10)), Some(130));
    let resumed = coupler(&["resume", live.out.to_str().unwrap()]);
    assert_eq!(resumed.status.code(), Some(4), "{}", stderr(&resumed));
    assert_same_results(&folder.join("through"), &folder.join("stopped"));
}

#[test]
fn a_changed_case_is_not_resumed() {
    let folder = Folder::new();
    let case = folder.write("case/case.toml", &one_run());
    let out = folder.join("out");
    assert!(run(&case, &out, &["time.end=\"20 ms\"", "output.restart=\"5 ms\""], &[]).status.success());
    folder.write("case/case.toml", &one_run().replace("2 mm", "3 mm"));
    let resumed = coupler(&["resume", out.to_str().unwrap()]);
    assert_eq!(resumed.status.code(), Some(2));
    assert!(stderr(&resumed).contains("has changed since the run"), "{}", stderr(&resumed));
}

#[test]
fn a_run_without_a_restart_point_says_so() {
    let folder = Folder::new();
    let case = folder.write("case/case.toml", &one_run());
    let out = folder.join("out");
    assert!(run(&case, &out, &["time.end=\"5 ms\"", "output.restart=\"none\""], &[]).status.success());
    let resumed = coupler(&["resume", out.to_str().unwrap()]);
    assert_eq!(resumed.status.code(), Some(5));
    assert!(stderr(&resumed).contains("no complete restart point"), "{}", stderr(&resumed));
}
