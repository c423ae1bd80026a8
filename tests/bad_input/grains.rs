//! Grains that cannot start.

use crate::refusal::assert_refused;
use crate::scene::Scene;

/// The second insertion's header: where a fault of its grain is.
const RIGHT: &str = "[[insertion]]\nname = \"right\"";

#[test]
fn grains_with_one_centre_are_refused() {
    let scene = Scene::coupled().with("\"17 mm\"", "\"14 mm\"");
    assert_refused(
        &scene,
        RIGHT,
        "insertion[1]",
        &["grains 0 and 1", "(0.014, 0.015, 0.02) m", "insert grains apart from each other"],
    );
}

#[test]
fn a_grain_outside_the_domain_is_refused() {
    let scene = Scene::coupled().with("\"17 mm\"", "\"31 mm\"");
    assert_refused(
        &scene,
        RIGHT,
        "insertion[1]",
        &[
            "grain 1 is at (0.031, 0.015, 0.02) m",
            "allowed: from (0, 0, 0) m to (0.03, 0.03, 0.03) m",
            "move the grain, or enlarge grains.domain",
        ],
    );
}

#[test]
fn a_substep_above_the_critical_one_is_refused() {
    let scene = Scene::coupled().with("window = \"2 ms\"", "window = \"2 ms\"\nsubstep = \"1 ms\"");
    assert_refused(
        &scene,
        "substep",
        "time.substep",
        &[
            "found 0.001 s",
            "allowed: at most the critical step 2.",
            "a contact of grain 0",
            "take a smaller substep",
        ],
    );
}

#[test]
fn a_window_of_too_many_substeps_is_refused() {
    let scene = Scene::coupled().with("window = \"2 ms\"", "window = \"2 ms\"\nsubstep = \"1e-6 us\"");
    assert_refused(
        &scene,
        "window",
        "time.window",
        &["2.000e9 substeps", "allowed: at most 1000000", "take a shorter window or a longer time.substep"],
    );
}

#[test]
fn more_grains_than_a_lattice_can_mean_are_refused() {
    let lattice = "lattice = { lower = [\"1 mm\", \"1 mm\", \"1 mm\"], upper = [\"29 mm\", \"29 mm\", \"29 mm\"], spacing = \"1 um\" }";
    let scene = Scene::coupled().with("at = [[\"17 mm\", \"15 mm\", \"20 mm\"]]", lattice).with(
        "name = \"right\"\nmaterial = \"glass\"\ndiameter = \"1 mm\"",
        "name = \"right\"\nmaterial = \"glass\"\ndiameter = \"0.9 um\"",
    );
    assert_refused(
        &scene,
        "spacing",
        "insertion[1].lattice.spacing",
        &["2.2e13 grains", "allowed: no more than 1e8", "take a larger spacing"],
    );
}
