//! Stop + resume gives the bits of running through, whatever stopped the run.

#[path = "../support/mod.rs"]
mod support;

use case_io::output::series::Series;
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

/// A case runs through, and is killed at a commit and resumed.
fn killed_and_resumed(name: &str, changes: &[&str], at: &str) {
    let folder = Folder::new();
    let case = case(name);
    let through = run(&case, &folder.join("through"), changes, &[]);
    let mut live = Live::start(&case, &folder.join("killed"), changes, &["--hold", at]);
    live.wait_held();
    for pid in live.solvers().iter().map(|(pid, _)| *pid).chain([live.child.id()]) {
        signal(pid, "KILL");
    }
    live.exit_code(Duration::from_secs(5));
    let resumed = coupler(&["resume", live.out.to_str().unwrap()]);
    assert_eq!(resumed.status.code(), through.status.code(), "{}", stderr(&resumed));
    assert_same_results(&folder.join("through"), &folder.join("killed"));
}

/// A fluid whose nodes and cells come and go, through the wall's impact: the restart point lies between steps that remesh.
#[test]
fn a_dam_break_resumes_to_the_same_bytes() {
    let changes = [
        "time.end=\"0.36 s\"",
        "output.series=\"12 ms\"",
        "output.restart=\"0.12 s\"",
        "output.frames=\"0.12 s\"",
    ];
    killed_and_resumed("dam-break", &changes, "fluid-solver:310:commit");
}

/// Fluid and grains come in through two inlets while the run is killed.
#[test]
fn a_container_that_fills_resumes_to_the_same_bytes() {
    let changes = [
        "time.end=\"0.2 s\"",
        "output.series=\"10 ms\"",
        "output.restart=\"50 ms\"",
        "output.frames=\"50 ms\"",
        "insertion[0].rate.stop=\"0.1 s\"",
        "insertion[1].rate.stop=\"0.1 s\"",
    ];
    killed_and_resumed("filling-container", &changes, "fluid-solver:65:commit");
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

const TRAY: &str = r#"
[case]
title = "grains on a shaken belt"
dimension = 3
gravity = ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]
[time]
end = "40 ms"
window = "1 ms"
[output]
series = "2.5 ms"
restart = "7 ms"
frames = "10 ms"
[materials.glass]
density = "2500 kg/m^3"
youngs-modulus = "5 MPa"
poissons-ratio = 0.3
[pairs.glass-glass]
restitution = 0.7
sliding-friction = 0.4
[grains]
normal-law = "hertz"
domain = { lower = ["-1 m", "-1 m", "-1 m"], upper = ["1 m", "1 m", "1 m"] }
[[insertion]]
name = "grains"
material = "glass"
diameter = "2 mm"
lattice = { lower = ["0 m", "0 m", "1 mm"], upper = ["9 mm", "9 mm", "6 mm"], spacing = "2.1 mm" }
[[wall]]
name = "belt"
material = "glass"
plane = { point = ["0 m", "0 m", "0 m"], normal = [0, 0, 1] }
torque-about = ["5 mm", "5 mm", "0 m"]
[wall.motion]
translation = ["0.2 m/s", "0 m/s", "0 m/s"]
oscillation = { direction = [0, 0, 1], amplitude = "0.5 mm", frequency = "60 Hz" }
[[wall]]
name = "paddle"
material = "glass"
plane = { point = ["-2 mm", "0 m", "0 m"], normal = [1, 0, 0] }
motion = { rotation = { axis = [0, 0, 1], point = ["-2 mm", "4 mm", "0 m"], rate = "15 rad/s" } }
"#;

/// The rows of walls.csv are means over intervals that a restart point cuts.
#[test]
fn walls_in_motion_resume_to_the_same_bytes_and_receive_what_the_grains_lose() {
    let folder = Folder::new();
    let case = folder.write("case/case.toml", TRAY);
    let through = run(&case, &folder.join("through"), &[], &[]);
    assert!(through.status.success(), "{}", stderr(&through));
    let mut live = Live::start(&case, &folder.join("killed"), &[], &["--hold", "dem-solver:17:commit"]);
    live.wait_held();
    for pid in live.solvers().iter().map(|(pid, _)| *pid).chain([live.child.id()]) {
        signal(pid, "KILL");
    }
    live.exit_code(Duration::from_secs(5));
    let resumed = coupler(&["resume", live.out.to_str().unwrap()]);
    assert!(resumed.status.success(), "{}", stderr(&resumed));
    assert_same_results(&folder.join("through"), &folder.join("killed"));

    let series =
        |name: &str| Series::read(&folder.join("through").join(format!("series/{name}.csv"))).unwrap();
    let (walls, grains) = (series("walls"), series("grains"));
    let column = |series: &Series, name: &str| series.column(name).unwrap().values.clone();
    let times = column(&walls, "t");
    let mass = column(&grains, "count")[0] * 2500.0 * 4.0 / 3.0 * std::f64::consts::PI * 1e-9;
    for (axis, gravity) in [("x", 0.0), ("z", -9.81)] {
        let force = |wall: &str| column(&walls, &format!("{wall}-f{axis}"));
        let sum =
            force("belt").iter().zip(force("paddle")).map(|(belt, paddle)| belt + paddle).collect::<Vec<_>>();
        let starts = std::iter::once(0.0).chain(times.iter().copied());
        let received: f64 =
            sum.iter().zip(times.iter().zip(starts)).map(|(f, (end, start))| f * (end - start)).sum();
        let momentum = mass * column(&grains, &format!("v{axis}")).last().unwrap();
        let lost = mass * gravity * times.last().unwrap() - momentum;
        assert!(received.abs() > 1e-6, "{axis}: {received} N s");
        assert!((received - lost).abs() < 1e-11 * received.abs(), "{axis}: {received} of {lost} N s");
    }
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
