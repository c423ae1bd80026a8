//! The checker finds what is wrong.

use crate::clouds::{grid, random};
use delaunay::{Delaunay, HULL, Triangulation, check};

fn triangulated<const D: usize, const N: usize>(points: &[[f64; D]], rank: &[u32]) -> Triangulation<N> {
    Delaunay::<D, N>::new().triangulate(points, rank).unwrap().clone()
}

#[test]
fn a_cell_turned_inside_out_is_found() {
    let (points, rank) = (random::<3>(200), (0..200).collect::<Vec<_>>());
    let mut triangulation = triangulated::<3, 4>(&points, &rank);
    triangulation.cells[17].swap(0, 1);
    triangulation.neighbours[17].swap(0, 1);
    assert_eq!(check(&points, &rank, &triangulation).unwrap().orientation, 1);
}

#[test]
fn a_wrong_neighbour_is_found() {
    let (points, rank) = (random::<2>(200), (0..200).collect::<Vec<_>>());
    let mut triangulation = triangulated::<2, 3>(&points, &rank);
    triangulation.neighbours[17].swap(0, 1);
    assert!(check(&points, &rank, &triangulation).unwrap().adjacency > 0);
    triangulation.neighbours[17] = [u32::MAX - 1; 3];
    assert!(check(&points, &rank, &triangulation).unwrap().adjacency > 0);
}

#[test]
fn a_missing_cell_is_found() {
    let (points, rank) = (random::<3>(200), (0..200).collect::<Vec<_>>());
    let mut triangulation = triangulated::<3, 4>(&points, &rank);
    let last = triangulation.cells.len() as u32 - 1;
    triangulation.cells.pop();
    triangulation.neighbours.pop();
    triangulation.neighbours.iter_mut().flatten().filter(|n| **n == last).for_each(|n| *n = HULL);
    assert!(check(&points, &rank, &triangulation).unwrap().hull > 0);
}

#[test]
fn points_moved_out_of_their_cells_circumspheres_order_are_found() {
    let (mut points, rank) = (random::<3>(2000), (0..2000).collect::<Vec<_>>());
    let triangulation = triangulated::<3, 4>(&points, &rank);
    for point in &mut points {
        point[0] += 1e-3 * (40.0 * point[1]).sin();
    }
    assert!(check(&points, &rank, &triangulation).unwrap().delaunay > 0);
}

#[test]
fn the_wrong_choice_on_a_grid_is_found() {
    let (points, rank) = (grid::<3>(5, 0.0), (0..125).collect::<Vec<_>>());
    let other = (0..125).map(|point| 7 * point % 125).collect::<Vec<_>>();
    let triangulation = triangulated::<3, 4>(&points, &other);
    assert!(check(&points, &other, &triangulation).unwrap().none());
    assert!(check(&points, &rank, &triangulation).unwrap().delaunay > 0);
}

#[test]
fn a_point_left_out_is_found() {
    let (mut points, rank) = (random::<2>(200), (0..201).collect::<Vec<_>>());
    let triangulation = triangulated::<2, 3>(&points, &rank[..200]);
    points.push([0.5, 0.5]);
    assert_eq!(check(&points, &rank, &triangulation).unwrap().points, 1);
    let nothing = Triangulation::<3>::default();
    assert!(check(&points, &rank, &nothing).unwrap().points > 0);
}
