//! Surfaces of triangles and tables of motion that cannot be.

use std::fmt::Write;

use crate::refusal::assert_refused;
use crate::scene::Scene;

type Triangle = [[f64; 3]; 3];

/// A tetrahedron in the corner of the box.
const TETRAHEDRON: [Triangle; 4] = {
    let (o, x, y, z) = ([0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    [[o, y, x], [o, x, z], [o, z, y], [x, y, z]]
};

fn stl(triangles: &[Triangle]) -> String {
    let mut text = "solid part\n".to_string();
    for triangle in triangles {
        text += "facet normal 0 0 0\nouter loop\n";
        triangle.iter().for_each(|[x, y, z]| writeln!(text, "vertex {x} {y} {z}").unwrap());
        text += "endloop\nendfacet\n";
    }
    text + "endsolid part\n"
}

/// The floor is this shape.
fn shaped(shape: &str) -> Scene {
    Scene::coupled().with("plane = { point = [\"0 mm\", \"0 mm\", \"0 mm\"], normal = [0, 0, 1] }", shape)
}

fn assert_stl_refused(triangles: &[Triangle], parts: &[&str]) {
    let scene = shaped("stl = { path = \"part.stl\", scale = 0.01 }").with_file("part.stl", &stl(triangles));
    assert_refused(&scene, "part.stl", "wall[0].stl.path", &[&["part.stl: "], parts].concat());
}

#[test]
fn a_surface_with_a_hole_is_refused() {
    let parts = ["has 1 open rims (the smallest of 3 edges, near (", "allowed: 0; ", "state as rims"];
    assert_stl_refused(&TETRAHEDRON[..3], &parts);
}

#[test]
fn triangles_without_area_or_place_are_refused_and_counted() {
    let mut flat = TETRAHEDRON;
    flat[1][2] = [2.0, 0.0, 0.0];
    flat[2][1] = flat[2][0];
    assert_stl_refused(&flat, &["triangle 2 of 4 (and 1 more) has no area", "remove it or repair"]);
    let mut endless = TETRAHEDRON;
    endless[2][0][1] = f64::NAN;
    assert_stl_refused(&endless, &["triangle 3 of 4 has a coordinate that is not a finite number"]);
}

#[test]
fn triangles_that_meet_three_at_an_edge_or_twice_are_refused() {
    let fin = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, -1.0, -1.0]];
    let finned = [&TETRAHEDRON[..], &[fin]].concat();
    assert_stl_refused(&finned, &["1 edges belong to more than two triangles", "walls of their own"]);
    let twice = [&TETRAHEDRON[..], &TETRAHEDRON[1..2]].concat();
    assert_stl_refused(
        &twice,
        &["1 of 5 triangles are there twice, the first are 2 and 5", "remove one of each"],
    );
}

#[test]
fn an_obj_that_names_no_vertex_is_refused_with_its_line() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n";
    let scene = shaped("obj = { path = \"part.obj\", rims = 1 }").with_file("part.obj", text);
    assert_refused(
        &scene,
        "part.obj",
        "wall[0].obj.path",
        &["part.obj:4: corner \"4\" is none of the 3 vertices so far", "repair the file"],
    );
}

#[test]
fn a_table_of_motion_that_goes_back_in_time_is_refused_with_its_line() {
    let plane = "plane = { point = [\"0 mm\", \"0 mm\", \"0 mm\"], normal = [0, 0, 1] }";
    let scene = shaped(&format!("{plane}\nmotion = {{ table = {{ path = \"lid.csv\" }} }}"))
        .with_file("lid.csv", "t[s],z[m]\n0,0\n0.2,1e-3\n0.1,2e-3\n");
    assert_refused(
        &scene,
        "lid.csv",
        "wall[0].motion.table.path",
        &["lid.csv:4: t[s]: 0.1 is not after the time before, 0.2", "repair the file"],
    );
}
