//! A triangulation is a function of the points and their ranks.

use crate::clouds::{Random, grid, random};
use delaunay::{Delaunay, Triangulation};

/// Cells with their corners, renamed, in rising order; cells in rising order.
fn cells<const N: usize>(triangulation: &Triangulation<N>, name: impl Fn(u32) -> u32) -> Vec<[u32; N]> {
    let sorted = |cell: &[u32; N]| {
        let mut cell = cell.map(&name);
        cell.sort_unstable();
        cell
    };
    let mut cells = triangulation.cells.iter().map(sorted).collect::<Vec<_>>();
    cells.sort_unstable();
    cells
}

fn numbers(count: usize) -> Vec<u32> {
    (0..count as u32).collect()
}

/// Numbers in random order.
fn shuffled(count: usize) -> Vec<u32> {
    let (mut order, mut random) = (numbers(count), Random(2));
    for k in (1..count).rev() {
        order.swap(k, random.below(k + 1));
    }
    order
}

#[test]
fn what_came_before_does_not_matter() {
    let (grid, cloud) = (grid::<3>(9, 0.0), random::<3>(2000));
    let mut delaunay = Delaunay::<3, 4>::new();
    let first = delaunay.triangulate(&grid, &numbers(729)).unwrap().clone();
    delaunay.triangulate(&cloud, &numbers(2000)).unwrap();
    assert_eq!(&first, delaunay.triangulate(&grid, &numbers(729)).unwrap());
}

#[test]
fn the_order_in_which_points_are_given_does_not_matter_even_on_a_grid() {
    fn claim<const D: usize, const N: usize>(points: &[[f64; D]]) {
        let mut delaunay = Delaunay::<D, N>::new();
        let expected = cells(delaunay.triangulate(points, &numbers(points.len())).unwrap(), |point| point);
        let order = shuffled(points.len());
        let given = order.iter().map(|point| points[*point as usize]).collect::<Vec<_>>();
        let found = cells(delaunay.triangulate(&given, &order).unwrap(), |place| order[place as usize]);
        assert_eq!(expected, found);
    }
    claim::<3, 4>(&grid(10, 0.0));
    claim::<2, 3>(&grid(30, 0.0));
}

#[test]
fn ranks_decide_between_the_diagonals_of_a_square() {
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let mut delaunay = Delaunay::<2, 3>::new();
    let mut diagonal = |rank: [u32; 4]| {
        let cells = &delaunay.triangulate(&square, &rank).unwrap().cells;
        (0..4).filter(|k| cells.iter().all(|cell| cell.contains(k))).collect::<Vec<u32>>()
    };
    // The corner of the highest rank is raised most: it is cut off.
    assert_eq!(diagonal([0, 1, 2, 3]), [0, 2]);
    assert_eq!(diagonal([3, 1, 2, 0]), [1, 3]);
    assert_eq!(diagonal([7, 9, 8, 5]), [0, 2]);
}

#[test]
fn a_grid_that_is_scaled_or_moved_without_rounding_keeps_its_cells() {
    let points = grid::<3>(9, 0.0).iter().map(|x| x.map(|x| 8.0 * x)).collect::<Vec<_>>();
    let mut delaunay = Delaunay::<3, 4>::new();
    let rank = shuffled(points.len());
    let expected = cells(delaunay.triangulate(&points, &rank).unwrap(), |point| point);
    for (scale, shift) in [(0.125, 0.0), (1.0, 4096.0), (3.0, -7.0)] {
        let moved = points.iter().map(|x| x.map(|x| scale * x + shift)).collect::<Vec<_>>();
        assert_eq!(expected, cells(delaunay.triangulate(&moved, &rank).unwrap(), |point| point));
    }
}
