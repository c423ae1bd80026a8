//! Fluids whose nodes move: bodies, walls and steps that cannot be.

use crate::refusal::{assert_refused, refusal, run};
use crate::scene::Scene;

#[test]
fn the_sound_tank_is_run() {
    let scene = Scene::tank();
    let ran = run(&scene, &[]);
    assert_eq!((ran.code, ran.words.as_str()), (0, ""));
}

#[test]
fn cells_larger_than_the_vessel_are_refused() {
    let scene = Scene::tank().with("size = \"5 mm\"", "size = \"60 mm\"");
    assert_refused(
        &scene,
        "60 mm",
        "fluid.mesh.box.size",
        &["found 0.06 m", "at most the shortest edge, 0.05 m"],
    );
    let scene = Scene::tank().with("[fluid.mesh]", "pfem = { size = \"60 mm\" }\n[fluid.mesh]");
    assert_refused(
        &scene,
        "60 mm",
        "fluid.pfem.size",
        &["found 0.06 m", "at most the shortest edge of fluid.mesh.box, 0.05 m"],
    );
}

#[test]
fn nodes_too_far_apart_for_their_size_are_refused() {
    let scene = Scene::tank().with("[fluid.mesh]", "pfem = { size = \"2 mm\" }\n[fluid.mesh]");
    assert_refused(
        &scene,
        "2 mm",
        "fluid.pfem.size",
        &[
            "2.000e-3 m, but at",
            "nodes are 7.071e-3 m apart",
            "allowed: 2.828e-3 m or more",
            "make the mesh finer",
        ],
    );
}

#[test]
fn a_fluid_without_volume_is_refused() {
    let scene = Scene::tank().with("size = \"5 mm\"", "size = \"5 mm\", surface = \"x - 0.02\"");
    assert_refused(
        &scene,
        "[fluid.mesh]",
        "fluid.mesh",
        &["has no volume", "raise its surface above its bottom"],
    );
    let scene = Scene::tank().with("size = \"5 mm\"", "size = \"5 mm\", surface = \"0\"");
    assert_refused(&scene, "[fluid.mesh]", "fluid.mesh", &["has no volume"]);
}

#[test]
fn nodes_at_one_place_are_refused() {
    let twin =
        "[[fluid.body]]\nbox = { lower = [\"0 mm\", \"50 mm\"], upper = [\"50 mm\", \"60 mm\"] }\n[[wall]]";
    let scene = Scene::tank().with("[[wall]]", twin);
    assert_refused(&scene, "[fluid]", "fluid", &["two nodes are at [", "part the bodies"]);
}

#[test]
fn fluid_behind_a_wall_is_refused() {
    let scene = Scene::tank()
        .with("[[\"0.1 m\", \"0 m\"], [\"0.1 m\", \"1 m\"]]", "[[\"0.1 m\", \"1 m\"], [\"0.1 m\", \"0 m\"]]");
    assert_refused(
        &scene,
        "[fluid]",
        "fluid",
        &["is 1.000e-1 m behind the wall \"weir\"", "turn the wall round"],
    );
}

#[test]
fn walls_with_a_gap_between_them_are_refused() {
    let scene = Scene::tank().with("[\"0.1 m\", \"0 m\"]", "[\"0.1 m\", \"2 mm\"]");
    assert_refused(
        &scene,
        "[[fluid.boundary]]",
        "fluid.boundary",
        &[
            "a gap of 2.000e-3 m between an end of the wall \"weir\", at [0.1, 0.002] m, and \"y-min\"",
            "close it or widen it",
        ],
    );
}

#[test]
fn a_boundary_that_is_no_plane_is_refused_with_what_to_do() {
    let scene = Scene::tank().with("kind = \"free-surface\"", "kind = \"moving-wall\"");
    assert_refused(
        &scene,
        "\"moving-wall\"",
        "fluid.boundary[1].kind",
        &[
            "backend \"pfem\" has no kind \"moving-wall\"",
            "allowed: no-slip, slip, wall-function, inlet, outlet, free-surface",
        ],
    );
    let scene = Scene::tank().with("[\"x-min\", \"y-min\"]", "[\"x-min\", \"x-max\", \"y-min\", \"y-max\"]");
    let line = refusal(
        &scene
            .with("on = [\"x-max\", \"y-max\"]\nkind = \"free-surface\"", "on = [\"lid\"]\nkind = \"slip\""),
    );
    assert!(
        line.contains("there is no boundary \"lid\"; allowed: x-min, x-max, y-min, y-max, weir"),
        "{line}"
    );
}

/// The sound tank with an inlet in the plane of its left wall, 50 mm above the floor at most.
fn with_inlet(lower: [&str; 2], upper: [&str; 2], normal: &str) -> Scene {
    let table = format!(
        "[[fluid.inlet]]\nname = \"pipe\"\nbox = {{ lower = {lower:?}, upper = {upper:?} }}\nnormal = {normal}\nspeed = \"1 m/s\"\n[[wall]]"
    );
    Scene::tank().with("[[wall]]", &table)
}

#[test]
fn an_inlet_outside_of_the_vessel_or_facing_out_of_it_is_refused() {
    let outside = ["behind the wall \"x-min\"", "move it into the vessel, or turn its normal round"];
    let scene = with_inlet(["-50 mm", "60 mm"], ["-50 mm", "70 mm"], "[1, 0]");
    assert_refused(&scene, "[[fluid.inlet]]", "fluid.inlet[0]", &outside);
    let scene = with_inlet(["0 mm", "60 mm"], ["0 mm", "70 mm"], "[-1, 0]");
    assert_refused(&scene, "[[fluid.inlet]]", "fluid.inlet[0]", &outside);
}

#[test]
fn an_inlet_thinner_than_a_cell_is_refused() {
    let scene = with_inlet(["0 mm", "60 mm"], ["0 mm", "63 mm"], "[1, 0]");
    let message = ["\"pipe\" is 3.000e-3 m wide", "at least the size of the cells", "widen it"];
    assert_refused(&scene, "[[fluid.inlet]]", "fluid.inlet[0]", &message);
}

#[test]
fn an_inlet_half_in_the_fluid_is_refused() {
    let scene = with_inlet(["0 mm", "45 mm"], ["0 mm", "80 mm"], "[1, 0]");
    let message = ["the fluid covers 14 % of it", "raise the fluid over all of it, or lower it below"];
    assert_refused(&scene, "[[fluid.inlet]]", "fluid.inlet[0]", &message);
}

#[test]
fn an_outlet_that_no_fluid_can_reach_is_refused() {
    let table = "[[fluid.outlet]]\nname = \"drain\"\nbeyond = { point = [\"0 mm\", \"0 mm\"], normal = [0, 1] }\n[[wall]]";
    let message = ["the outlet \"drain\" is behind the wall \"y-min\"", "with a hole there"];
    assert_refused(&Scene::tank().with("[[wall]]", table), "[[fluid.outlet]]", "fluid.outlet", &message);
}

#[test]
fn fluid_behind_an_outlet_at_the_start_is_refused() {
    let table = "[[fluid.outlet]]\nname = \"drain\"\nbeyond = { point = [\"20 mm\", \"0 mm\"], normal = [-1, 0] }\n[[wall]]";
    let message = ["is behind the outlet \"drain\" at the start", "turn the normal round"];
    assert_refused(&Scene::tank().with("[[wall]]", table), "[[fluid.outlet]]", "fluid.outlet", &message);
}

#[test]
fn a_fluid_that_has_nowhere_to_go_ends_the_run_with_the_reason_and_its_last_state() {
    let scene = Scene::tank()
        .with("[\"x-max\", \"y-max\"]\nkind = \"free-surface\"", "[\"x-max\", \"y-max\"]\nkind = \"slip\"")
        .with("[[\"0.1 m\", \"0 m\"], [\"0.1 m\", \"1 m\"]]", "[[\"51 mm\", \"-1 m\"], [\"51 mm\", \"1 m\"]]")
        .with("# moves", "motion = { translation = [\"-1 m/s\", \"0 m/s\"] }");
    let ran = run(&scene, &[]);
    ran.assert_line(
        11,
        &["time: a window of", "is wanted by fluid-solver at t =", "because ", "time.smallest-window"],
    );
    let out = scene.folder.join("out");
    assert!(out.join("summary.json").exists() && out.join("series/fluid.csv").exists());
    assert!(ran.line().contains(" at ["), "where: {}", ran.line());
    let last = std::fs::read_dir(out.join("restart")).unwrap().count();
    assert!(last > 0, "a restart point of the last good state");
}
