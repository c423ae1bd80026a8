//! Grains that cannot start.

use crate::ending::coupler;
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
fn grains_that_overlap_at_the_start_are_refused_unless_the_case_allows_it() {
    let scene = Scene::coupled().with("\"17 mm\"", "\"14.98 mm\"");
    assert_refused(
        &scene,
        RIGHT,
        "insertion[1]",
        &[
            "grain 1 overlaps grain 0 by 2.000 % of a diameter",
            "allowed: at most 1 %",
            "insert grains apart from each other and from walls, or state a larger grains.start-overlap",
        ],
    );
    let allowed = scene.with("normal-law = \"hertz\"", "normal-law = \"hertz\"\nstart-overlap = 0.025");
    let checked = coupler(&allowed.folder, &["check", &allowed.path().display().to_string()]);
    assert_eq!((checked.code, checked.words.as_str()), (0, ""));
}

#[test]
fn a_grain_that_starts_in_a_wall_is_refused() {
    let scene = Scene::coupled().with("\"17 mm\", \"15 mm\", \"20 mm\"", "\"17 mm\", \"15 mm\", \"0.4 mm\"");
    assert_refused(
        &scene,
        RIGHT,
        "insertion[1]",
        &["grain 1 overlaps the wall \"floor\" by 10.000 % of a diameter", "allowed: at most 1 %"],
    );
}

#[test]
fn a_restitution_of_nothing_or_of_more_than_all_is_refused() {
    for found in ["0", "1.2", "-0.5"] {
        let scene = Scene::coupled().with("restitution = 0.9", &format!("restitution = {found}"));
        let parts = [format!("found {found}"), "allowed: more than 0, at most 1".to_string()];
        assert_refused(
            &scene,
            "restitution",
            "pairs.glass-glass.restitution",
            &parts.each_ref().map(String::as_str),
        );
    }
}

#[test]
fn grains_that_do_not_fit_are_refused_with_how_many_did_and_why() {
    let region = "random-cylinder = { from = [\"15 mm\", \"15 mm\", \"1 mm\"], to = [\"15 mm\", \"15 mm\", \"9 mm\"], radius = \"4 mm\", count = 500 }";
    let scene = Scene::coupled().with("at = [[\"17 mm\", \"15 mm\", \"20 mm\"]]", region);
    assert_refused(
        &scene,
        "random-cylinder",
        "insertion[1].random-cylinder",
        &[
            " of 500 grains fitted: the next, of diameter 0.0010 m, met a grain at 100000 and a wall at 0 of 100000 random places",
            "ask for fewer or smaller grains, or for a larger region",
        ],
    );
}

#[test]
fn a_sieve_curve_that_does_not_end_is_refused_with_its_line() {
    let scene = Scene::coupled()
        .with(
            "name = \"right\"\nmaterial = \"glass\"\ndiameter = \"1 mm\"",
            "name = \"right\"\nmaterial = \"glass\"\ndiameter-distribution = { sieve = { path = \"curve.csv\" } }",
        )
        .with_file("curve.csv", "diameter[m],passing[-]\n1e-3,0\n2e-3,0.9\n");
    assert_refused(
        &scene,
        "curve.csv",
        "insertion[1].diameter-distribution.sieve.path",
        &[
            "curve.csv:3: passing[-]: found 0.9; a sieve curve starts with 0 and ends with 1",
            "repair the file",
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
