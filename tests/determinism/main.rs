//! The same bits for any number of threads, and over any transport.

#[path = "../support/mod.rs"]
mod support;

use case_io::document::{Case, Overrides};
use coupler::{Clock, Session, Simulation, Watcher};
use interface::assignment::Assignment;
use interface::run::RunId;
use interface::transport::{FluidEnds, in_process};
use std::path::Path;
use std::sync::atomic::AtomicBool;
use support::{Folder, assert_same_results, case, run, stderr};

/// Contacts, walls, insertion over time and a two-way fluid, for a few windows of the shipped pipe.
const CHANGES: [&str; 4] =
    ["time.end=\"0.12 s\"", "output.series=\"20 ms\"", "output.frames=\"60 ms\"", "output.restart=\"60 ms\""];

#[test]
fn one_two_and_four_threads_leave_the_same_bytes() {
    let folder = Folder::new();
    for threads in ["1", "2", "4"] {
        let output = run(&case("pipe-sediment"), &folder.join(threads), &CHANGES, &["--threads", threads]);
        // Its checks are about the end of the run.
        assert_eq!(output.status.code(), Some(4), "{}", stderr(&output));
    }
    assert_same_results(&folder.join("1"), &folder.join("2"));
    assert_same_results(&folder.join("1"), &folder.join("4"));
}

#[test]
fn a_dam_break_is_the_same_for_one_two_and_four_threads() {
    const SHORT: [&str; 3] = ["time.end=\"0.3 s\"", "output.series=\"20 ms\"", "output.frames=\"0.1 s\""];
    let folder = Folder::new();
    for threads in ["1", "2", "4"] {
        let output = run(&case("dam-break"), &folder.join(threads), &SHORT, &["--threads", threads]);
        // Its checks are about times up to the end of the run.
        assert!(matches!(output.status.code(), Some(0 | 4)), "{}", stderr(&output));
    }
    assert_same_results(&folder.join("1"), &folder.join("2"));
    assert_same_results(&folder.join("1"), &folder.join("4"));
}

/// Fluid and grains come in through two inlets, nodes and cells come and go.
#[test]
fn a_container_that_fills_is_the_same_for_one_two_and_four_threads() {
    const SHORT: [&str; 5] = [
        "time.end=\"0.2 s\"",
        "output.series=\"10 ms\"",
        "output.frames=\"50 ms\"",
        "insertion[0].rate.stop=\"0.1 s\"",
        "insertion[1].rate.stop=\"0.1 s\"",
    ];
    let folder = Folder::new();
    for threads in ["1", "2", "4"] {
        let output = run(&case("filling-container"), &folder.join(threads), &SHORT, &["--threads", threads]);
        // Its checks are about the end of the run.
        assert!(matches!(output.status.code(), Some(0 | 4)), "{}", stderr(&output));
    }
    assert_same_results(&folder.join("1"), &folder.join("2"));
    assert_same_results(&folder.join("1"), &folder.join("4"));
}

struct Nobody;

impl Watcher for Nobody {
    fn window(&mut self, _: &Clock, _: &case_io::summary::Counts) {}
}

/// The run of a case by threads of this process.
fn run_in_process(path: &Path, out: &Path) {
    for folder in ["series", "frames", "restart"] {
        std::fs::create_dir_all(out.join(folder)).unwrap();
    }
    let set: Vec<String> = CHANGES.iter().map(|change| change.to_string()).collect();
    let overrides = Overrides { set: set.clone(), variant: None };
    let case = Case::load(path, &overrides).unwrap().remove(0);
    let id = RunId::new();
    let (coupler, dem, fluid) = in_process::connect(id);
    let part = Assignment {
        run: id.to_string(),
        case: path.to_path_buf(),
        set,
        variant: None,
        name: None,
        out: out.to_path_buf(),
        threads: 0,
        resume: None,
        peer_deadline: 10.0,
        hold: None,
    };
    let parts = (part.clone(), part);
    let dem = std::thread::spawn(move || dem_solver::program::take_part(&parts.0, dem));
    let fluid_thread =
        |fluid: FluidEnds| std::thread::spawn(move || fluid_solver::program::take_part(&parts.1, fluid));
    let fluid = fluid_thread(fluid);
    let session = Session { ends: coupler, dem: true, fluid: true, waited: 0.0 };
    let mut simulation = Simulation::start(&case, session, out, None).unwrap();
    simulation.run(&AtomicBool::new(false), &mut Nobody).unwrap();
    let mut session = simulation.into_session();
    for who in session.members() {
        session.stop(who, "done").unwrap();
    }
    dem.join().unwrap().unwrap();
    fluid.join().unwrap().unwrap();
}

#[test]
fn threads_of_one_process_leave_the_bytes_of_three_processes() {
    let folder = Folder::new();
    let path = case("pipe-sediment");
    run_in_process(&path, &folder.join("one"));
    let output = run(&path, &folder.join("three"), &CHANGES, &[]);
    assert_eq!(output.status.code(), Some(4), "{}", stderr(&output));
    assert_same_results(&folder.join("one"), &folder.join("three"));
}
