//! What goes wrong while a run goes on: it stops with a reason, and what was committed stays.

use crate::refusal::run;
use crate::scene::Scene;
use std::fs;

/// Runs into a fault: code and words as documented, the series end at the last commit, summary and report name the
/// reason. Returns the number of windows committed.
fn assert_fault(scene: &Scene, changes: &[&str], code: i32, parts: &[&str]) -> u64 {
    let ending = run(scene, changes);
    let line = ending.assert_line(code, parts);
    let out = scene.folder.join("out");
    let summary = fs::read_to_string(out.join("summary.json")).unwrap();
    let number = |table: &str, key: &str| -> f64 {
        let behind = |text: &str, word: &str| {
            let lead = format!("\"{word}\": ");
            text[text.find(&lead).unwrap_or_else(|| panic!("{word}: {summary}")) + lead.len()..].to_string()
        };
        let rest = behind(&behind(&summary, table), key);
        rest[..rest.find([',', '\n', '}']).unwrap()].parse().unwrap()
    };
    assert_eq!(number("exit", "code"), f64::from(code));
    let reason = format!("\"reason\": \"{}\"", line.replace('\\', "\\\\").replace('"', "\\\""));
    assert!(summary.contains(&reason), "{reason} is not in {summary}");
    let report = fs::read_to_string(out.join("report.html")).unwrap();
    let opening = line.split(['"', '<', '>', '&', '\'']).next().unwrap();
    assert!(report.contains(opening), "{opening} is not in the report");

    let windows = number("counts", "windows");
    let rows: Vec<String> =
        fs::read_to_string(out.join("series/grains.csv")).unwrap().lines().map(String::from).collect();
    assert_eq!(rows.len() as f64, 2.0 + windows, "a head, the start and each window: {rows:?}");
    let last: f64 = rows.last().unwrap().split(',').next().unwrap().parse().unwrap();
    assert_eq!(last, number("case_hash", "time"));
    assert!((last - 0.002 * windows).abs() < 1e-12);
    windows as u64
}

#[test]
fn a_field_that_becomes_no_number_stops_the_run_with_code_7() {
    let windows = assert_fault(
        &Scene::carried().with("\"0.1\", \"0\", \"0\"", "\"sqrt(0.0101 - t)\", \"0\", \"0\""),
        &[],
        7,
        &[
            "fluid-solver: fluid.field.velocity[0]: \"sqrt(0.0101 - t)\" is NaN near grain 0, at (",
            ") m, t = 0.01",
            "allowed: finite numbers; state a field that is finite wherever grains go",
        ],
    );
    assert!((5..=6).contains(&windows), "{windows}");
    let windows = assert_fault(
        &Scene::carried().with("\"-9810*z\"", "\"z*sqrt(0.0101 - t)\""),
        &[],
        7,
        &["fluid.field.pressure: \"z*sqrt(0.0101 - t)\" is NaN near grain 0", "t = 0.01"],
    );
    assert!((5..=6).contains(&windows), "{windows}");
}

#[test]
fn a_grain_that_leaves_the_domain_stops_the_run_with_code_8() {
    let scene = Scene::coupled().with(
        "domain = { lower = [\"0 mm\", \"0 mm\", \"0 mm\"]",
        "domain = { lower = [\"0 mm\", \"0 mm\", \"19.9 mm\"]",
    );
    let windows = assert_fault(
        &scene,
        &[],
        8,
        &[
            "dem-solver: at t = 0.0",
            "grain 0: its centre left the domain at (0.01",
            "enlarge grains.domain",
            "grains.escape = \"remove\"",
        ],
    );
    assert!(windows > 0);
}

#[test]
fn a_window_that_does_not_converge_stops_the_run_with_code_6() {
    let scene = Scene::coupled();
    let changes = ["coupling.max-iterations=1", "coupling.tolerance.velocity=1e-12"];
    assert_fault(
        &scene,
        &changes,
        6,
        &[
            "window 0 at t = 0 s has not converged after 1 iterations",
            "velocity ",
            "raise coupling.max-iterations",
        ],
    );
}

#[test]
fn books_that_do_not_balance_stop_the_run_with_code_8() {
    assert_fault(
        &Scene::coupled(),
        &["coupling.ledger-tolerance=1e-30"],
        8,
        &["ledger: ", " of window 0 at t = 0 s is off by ", "allowed: coupling.ledger-tolerance = 1.0e-30"],
    );
}

#[test]
fn a_window_that_comes_to_need_too_many_substeps_stops_the_run_with_code_11() {
    // Thrown this hard, the grain flies a tenth of its radius in less than a millionth of the second window.
    let scene = Scene::carried().with("\"-9.81 m/s^2\"", "\"1e9 m/s^2\"");
    let windows = assert_fault(
        &scene,
        &[],
        11,
        &[
            "dem-solver: ",
            "time.window: 0.002 s takes ",
            "more than 1000000 allowed",
            "the speed of grain 0",
            "take a shorter window",
        ],
    );
    assert_eq!(windows, 1);
}

#[test]
fn a_window_below_the_smallest_stops_the_run_with_code_11() {
    let scene =
        Scene::coupled().with("[fluid.mesh]", "velocity = [\"1e9 m/s\", \"0 m/s\", \"0 m/s\"]\n[fluid.mesh]");
    assert_fault(
        &scene,
        &[],
        11,
        &[
            "time: a window of ",
            "is wanted by fluid-solver at t = 0 s",
            "allowed: time.smallest-window = 1.953e-6 s",
            "coarsen the mesh",
        ],
    );
}
