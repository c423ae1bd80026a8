use fluid_solver::mesh::generate::{BentPipe, BoxMesh, Jitter, Pipe};
use fluid_solver::mesh::{Mesh, MeshError};
use std::f64::consts::PI;

fn cuboid<const D: usize>(cells: [usize; D], periodic: [bool; D], jitter: f64) -> BoxMesh<D> {
    let jitter = (jitter > 0.0).then_some(Jitter { fraction: jitter, seed: 7 });
    BoxMesh { lower: [-1.0; D], upper: std::array::from_fn(|k| k as f64 + 0.5), cells, periodic, jitter }
}

fn volume<const D: usize, const N: usize>(mesh: &Mesh<D, N>) -> f64 {
    mesh.volumes().iter().sum()
}

fn agree(found: f64, exact: f64) {
    assert!((found - exact).abs() < 1e-13 * exact.abs(), "{found} against {exact}");
}

/// `Σ A n = 0`, and by Gauss's theorem `Σ x·A n = D V`.
fn assert_boundary_closed<const D: usize, const N: usize>(mesh: &Mesh<D, N>) {
    let mut sum = [0.0; D];
    let mut flux = 0.0;
    for face in mesh.boundary() {
        let area = mesh.area_vector(face);
        let vertices = mesh.face_vertices(face);
        for k in 0..D {
            sum[k] += area[k];
            flux += area[k] * vertices.iter().map(|x| x[k]).sum::<f64>() / D as f64;
        }
    }
    assert!(sum.iter().all(|s| s.abs() < 1e-13), "{sum:?}");
    agree(flux, D as f64 * volume(mesh));
}

#[test]
fn boxes_have_their_exact_volume_and_a_closed_boundary_in_the_plane_and_in_space() {
    for jitter in [0.0, 0.3] {
        let plane = cuboid([7, 5], [false; 2], jitter).generate::<3>().unwrap();
        agree(volume(&plane), 1.5 * 2.5);
        assert_boundary_closed(&plane);
        let space = cuboid([4, 5, 3], [false; 3], jitter).generate::<4>().unwrap();
        agree(volume(&space), 1.5 * 2.5 * 3.5);
        assert_boundary_closed(&space);
        agree(space.measure().iter().sum(), volume(&space));
        assert_eq!(space.groups(), ["x-min", "x-max", "y-min", "y-max", "z-min", "z-max"]);
    }
}

#[test]
fn every_side_of_a_box_has_its_area_and_its_normal() {
    let mesh = cuboid([3, 4, 5], [false; 3], 0.0).generate::<4>().unwrap();
    let group = mesh.group("y-max").unwrap();
    let mut sum = [0.0; 3];
    for face in mesh.boundary().iter().filter(|face| face.group == group) {
        let area = mesh.area_vector(face);
        (0..3).for_each(|k| sum[k] += area[k]);
        assert!(mesh.face_vertices(face).iter().all(|x| x[1] == 1.5));
    }
    assert!(sum[0].abs() < 1e-14 && sum[2].abs() < 1e-14);
    agree(sum[1], 1.5 * 3.5);
}

#[test]
fn the_corners_of_boundary_faces_are_ordered_outward() {
    let mesh = cuboid([2, 2, 2], [false; 3], 0.0).generate::<4>().unwrap();
    for face in mesh.boundary() {
        let [a, b, c] = mesh.face_vertices(face);
        let (u, v): ([f64; 3], [f64; 3]) =
            (std::array::from_fn(|k| b[k] - a[k]), std::array::from_fn(|k| c[k] - a[k]));
        let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        let area = mesh.area_vector(face);
        assert!((0..3).all(|k| (normal[k] / 2.0 - area[k]).abs() < 1e-14));
    }
}

#[test]
fn a_periodic_box_has_one_node_per_brick_each_of_the_measure_of_a_brick() {
    let mesh = cuboid([4, 5, 3], [true; 3], 0.0).generate::<4>().unwrap();
    assert_eq!((mesh.node_count(), mesh.points().len(), mesh.boundary().len()), (60, 120, 0));
    mesh.measure().iter().for_each(|&measure| agree(measure, 1.5 * 2.5 * 3.5 / 60.0));
    for point in 0..mesh.points().len() {
        let node = mesh.node_of(point as u32) as usize;
        let wrapped = mesh.periodicity().wrap(&mesh.points()[point]);
        assert!((0..3).all(|k| (wrapped[k] - mesh.nodes()[node][k]).abs() < 1e-14));
    }
    let half = cuboid([4, 3], [true, false], 0.0).generate::<3>().unwrap();
    assert_eq!(half.groups(), ["y-min", "y-max"]);
    assert_eq!((half.node_count(), half.boundary().len()), (16, 8));
}

#[test]
fn jitter_moves_inner_nodes_only_and_repeats_with_its_seed() {
    let straight = cuboid([6, 6], [false; 2], 0.0).generate::<3>().unwrap();
    let moved = cuboid([6, 6], [false; 2], 0.5).generate::<3>().unwrap();
    assert_eq!(moved, cuboid([6, 6], [false; 2], 0.5).generate::<3>().unwrap());
    let displaced = straight.nodes().iter().zip(moved.nodes()).filter(|(a, b)| a != b);
    assert!(displaced.clone().count() > 15, "most of the 25 inner nodes move");
    for (x, _) in displaced {
        assert!(x[0] > -1.0 && x[0] < 0.5 && x[1] > -1.0 && x[1] < 1.5);
    }
}

fn polygon(radius: f64, rings: usize) -> f64 {
    let corners = 6.0 * rings as f64;
    corners / 2.0 * radius * radius * (2.0 * PI / corners).sin()
}

#[test]
fn a_pipe_has_the_volume_of_its_polygon_and_three_closed_boundaries() {
    for rings in [1, 2, 5] {
        let mesh = Pipe { radius: 0.3, length: 2.0, rings, layers: 7 }.generate().unwrap();
        agree(volume(&mesh), 2.0 * polygon(0.3, rings));
        assert_boundary_closed(&mesh);
        for (name, z) in [("inlet", 0.0), ("outlet", 2.0)] {
            let group = mesh.group(name);
            let end = mesh.boundary().iter().filter(|face| Some(face.group) == group);
            let area: f64 = end.map(|face| mesh.area_vector(face)[2]).sum();
            agree(area, if z == 0.0 { -1.0 } else { 1.0 } * polygon(0.3, rings));
        }
    }
}

#[test]
fn a_bent_pipe_has_the_volume_of_its_legs_and_wedges() {
    let pipe = BentPipe {
        radius: 0.2,
        rings: 3,
        bend_radius: 0.5,
        angle: PI / 2.0,
        legs: [0.7, 0.4],
        layers: [4, 6, 3],
    };
    let mesh = pipe.generate().unwrap();
    let wedges = 6.0 * 0.5 * (PI / 12.0).sin();
    agree(volume(&mesh), polygon(0.2, 3) * (0.7 + wedges + 0.4));
    assert_boundary_closed(&mesh);
    let outlet = mesh.group("outlet").unwrap();
    for face in mesh.boundary().iter().filter(|face| face.group == outlet) {
        assert!(mesh.face_vertices(face).iter().all(|x| (x[0] - 0.9).abs() < 1e-14));
    }
}

#[test]
fn impossible_wishes_are_refused_with_the_key_and_the_value() {
    let refused = |result: Result<Mesh<3, 4>, MeshError>, word: &str| {
        let message = result.unwrap_err().to_string();
        assert!(message.contains(word), "{message}");
    };
    let pipe = Pipe { radius: 0.1, length: 1.0, rings: 2, layers: 3 };
    refused(Pipe { radius: 0.0, ..pipe }.generate(), "radius is 0");
    refused(Pipe { length: f64::NAN, ..pipe }.generate(), "length is NaN");
    refused(Pipe { rings: 0, ..pipe }.generate(), "rings is 0");
    refused(Pipe { rings: usize::MAX, ..pipe }.generate(), "2^27");
    let cube = cuboid([3; 3], [false; 3], 0.0);
    refused(BoxMesh { cells: [3, 0, 3], ..cube }.generate(), "cells is 0");
    refused(
        BoxMesh { cells: [2, 3, 3], periodic: [true; 3], ..cube }.generate(),
        "at least 3 along a periodic axis",
    );
    refused(BoxMesh { upper: [-1.0, 1.0, 1.0], ..cube }.generate(), "upper - lower is 0");
    refused(BoxMesh { cells: [usize::MAX - 1; 3], ..cube }.generate(), "2^27");
    refused(
        BoxMesh { jitter: Some(Jitter { fraction: 0.7, seed: 0 }), ..cube }.generate(),
        "fraction is 0.7",
    );
    let bent =
        BentPipe { radius: 0.2, rings: 2, bend_radius: 0.5, angle: 1.0, legs: [1.0; 2], layers: [2; 3] };
    refused(BentPipe { bend_radius: 0.1, ..bent }.generate(), "bend radius is 0.1");
    refused(BentPipe { angle: 4.0, ..bent }.generate(), "angle is 4");
    refused(BentPipe { angle: 3.0, ..bent }.generate(), "every 45°");
}
