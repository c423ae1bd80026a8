//! Files that a case names: meshes, surfaces, grains.

use crate::ending::coupler;
use crate::mesh_text::{CELLS, mesh_text};
use crate::refusal::assert_refused;
use crate::scene::Scene;

/// The box of water from a mesh file.
fn meshed() -> Scene {
    let mesh = "box = { lower = [\"0 mm\", \"0 mm\", \"0 mm\"], upper = [\"30 mm\", \"30 mm\", \"30 mm\"], cells = [3, 3, 3] }";
    Scene::coupled()
        .with(mesh, "gmsh = { path = \"cube.msh\", scale = 0.03 }")
        .with("[\"x-min\", \"x-max\", \"y-min\", \"y-max\", \"z-min\", \"z-max\"]", "[\"sides\"]")
}

/// A wall that is a surface file instead of the floor.
fn surfaced() -> Scene {
    Scene::coupled().with(
        "plane = { point = [\"0 mm\", \"0 mm\", \"0 mm\"], normal = [0, 0, 1] }",
        "stl = { path = \"floor.stl\", scale = 0.03, rims = 1 }",
    )
}

/// One insertion from a file.
fn listed() -> Scene {
    Scene::coupled().with("at = [[\"17 mm\", \"15 mm\", \"20 mm\"]]", "file = { path = \"grains.csv\" }")
}

const SURFACE: &str = "solid floor\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid floor\n";

#[test]
fn the_sound_files_are_taken() {
    for scene in [
        meshed().with_file("cube.msh", &mesh_text(&CELLS, &["sides"])),
        surfaced().with_file("floor.stl", SURFACE),
        listed().with_file("grains.csv", "x[m],y[m],z[m]\n0.017,0.015,0.02\n"),
    ] {
        let checked = coupler(&scene.folder, &["check", &scene.path().display().to_string()]);
        assert_eq!((checked.code, checked.words.as_str()), (0, ""));
    }
}

#[test]
fn a_missing_file_is_refused_with_its_key() {
    for (scene, name, key) in [
        (meshed(), "cube.msh", "fluid.mesh.gmsh.path"),
        (surfaced(), "floor.stl", "wall[0].stl.path"),
        (listed(), "grains.csv", "insertion[1].file.path"),
    ] {
        let parts = ["cannot read", name, "No such file", "the path starts from the case's folder"];
        assert_refused(&scene, name, key, &parts);
    }
}

#[test]
fn a_coordinate_that_is_no_number_is_refused_with_its_line() {
    let scene = listed().with_file("grains.csv", "x[m],y[m],z[m]\n0.017,0.015,0.02\n0.019,nan,0.02\n");
    assert_refused(
        &scene,
        "grains.csv",
        "insertion[1].file.path",
        &["grains.csv:3: y[m]: \"nan\" is not a finite number", "repair the file"],
    );
}

#[test]
fn an_empty_list_of_grains_is_refused() {
    for (text, part) in
        [("", "unknown column"), ("x[m],y[m],z[m]\n", "holds no grain; it needs at least one row")]
    {
        let scene = listed().with_file("grains.csv", text);
        assert_refused(&scene, "grains.csv", "insertion[1].file.path", &["grains.csv", part]);
    }
}

#[test]
fn a_surface_that_was_cut_short_is_refused() {
    let scene = surfaced().with_file("floor.stl", &SURFACE[..60]);
    assert_refused(&scene, "floor.stl", "wall[0].stl.path", &["floor.stl: ", "cut short", "write it again"]);
}

#[test]
fn an_empty_physical_group_is_refused() {
    let scene = meshed().with_file("cube.msh", &mesh_text(&CELLS, &["sides", "outlet"]));
    assert_refused(
        &scene,
        "cube.msh",
        "fluid.mesh.gmsh.path",
        &["cube.msh: ", "physical group \"outlet\" holds no face", "fill it or delete it"],
    );
}

#[test]
fn cells_that_are_to_be_larger_than_a_mesh_whose_nodes_move_are_refused() {
    let scene = meshed()
        .with_file("cube.msh", &mesh_text(&CELLS, &["sides"]))
        .with("backend = \"eulerian\"", "backend = \"pfem\"\npfem.size = \"60 mm\"")
        .with("kind = \"no-slip\"", "kind = \"free-surface\"");
    let allowed = "at most the shortest edge of the box around the mesh, 3.000e-2 m";
    assert_refused(&scene, "pfem.size", "fluid.pfem.size", &["6.000e-2 m", allowed]);
}

#[test]
fn an_inverted_element_is_refused() {
    let mut cells = CELLS;
    cells[3].swap(1, 2);
    let scene = meshed().with_file("cube.msh", &mesh_text(&cells, &["sides"]));
    assert_refused(
        &scene,
        "cube.msh",
        "fluid.mesh.gmsh.path",
        &[
            "cube.msh: ",
            "cell 3 with points [0, 6, 2, 7] is inverted",
            "must be positive",
            "swap two of its points",
        ],
    );
}

#[test]
fn a_mesh_that_is_no_mesh_is_refused() {
    let whole = mesh_text(&CELLS, &["sides"]);
    for (text, part) in
        [("", "$MeshFormat"), ("solid", "$MeshFormat"), (&whole[..whole.len() - 40], "expected")]
    {
        let scene = meshed().with_file("cube.msh", text);
        assert_refused(&scene, "cube.msh", "fluid.mesh.gmsh.path", &["cube.msh:", part]);
    }
}
