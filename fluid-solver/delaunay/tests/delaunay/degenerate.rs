//! No cloud is too degenerate.

use crate::clouds::{Random, clusters, flat, from_bytes, grid, random, sphere};
use crate::{faultless, volumes};
use delaunay::{Delaunay, Error, check};

#[test]
fn random_clouds_have_no_fault() {
    faultless::<3, 4>(&random(20_000));
    faultless::<2, 3>(&random(50_000));
}

#[test]
fn exact_grids_have_no_fault_and_fill_their_box_with_cells_none_of_which_is_flat() {
    for side in [2, 3, 22, 46] {
        let pieces = f64::powi(side as f64 - 1.0, 3);
        let points = grid::<3>(side, 0.0);
        let volumes = volumes(&points, &faultless::<3, 4>(&points));
        assert!((volumes.iter().sum::<f64>() - 6.0).abs() < 1e-11);
        assert!(volumes.iter().all(|volume| volume * pieces > 1.0 - 1e-12));
        let points = grid::<2>(side, 0.0);
        let cells = faultless::<2, 3>(&points);
        assert_eq!(cells.cells.len(), 2 * (side - 1) * (side - 1));
    }
}

#[test]
fn perturbed_grids_have_no_fault_however_small_the_perturbation() {
    for noise in [1e-1, 1e-2, 1e-8, 1e-15] {
        faultless::<3, 4>(&grid(12, noise));
        faultless::<2, 3>(&grid(40, noise));
    }
}

#[test]
fn points_of_a_sphere_have_no_fault() {
    faultless::<3, 4>(&sphere(3000));
    let cells = faultless::<2, 3>(&sphere(3000));
    assert_eq!(cells.cells.len(), 2998);
}

#[test]
fn a_point_in_the_middle_of_a_sphere_digs_a_cavity_of_thousands_of_cells() {
    let mut points = sphere::<3>(3000);
    points.push([0.0; 3]);
    faultless::<3, 4>(&points);
    let mut points = sphere::<2>(3000);
    points.push([0.0; 2]);
    assert_eq!(faultless::<2, 3>(&points).cells.len(), 3000);
}

#[test]
fn collinear_and_coplanar_points_have_no_cells() {
    assert!(faultless::<3, 4>(&flat(500, 1)).cells.is_empty());
    assert!(faultless::<3, 4>(&flat(500, 2)).cells.is_empty());
    assert!(faultless::<2, 3>(&flat(500, 1)).cells.is_empty());
}

#[test]
fn one_point_off_a_plane_of_many_is_a_corner_of_every_cell() {
    let mut points = flat::<3>(500, 2);
    points.push([1.0, 2.0, 99.0]);
    let triangulation = faultless::<3, 4>(&points);
    assert!(!triangulation.cells.is_empty());
    assert!(triangulation.cells.iter().all(|cell| cell.contains(&500)));
}

#[test]
fn of_equal_points_the_one_of_lowest_rank_is_kept() {
    let mut points = random::<3>(1000);
    points.extend_from_within(100..400);
    points.extend_from_within(100..400);
    let twins = faultless::<3, 4>(&points).twins;
    let expected = (1000..1600).map(|left| [left, 100 + (left - 1000) % 300]).collect::<Vec<_>>();
    assert_eq!(twins, expected);
    let reversed = (0..points.len() as u32).rev().collect::<Vec<_>>();
    let mut delaunay = Delaunay::<3, 4>::new();
    let triangulation = delaunay.triangulate(&points, &reversed).unwrap();
    assert!(check(&points, &reversed, triangulation).unwrap().none());
    assert!(triangulation.twins.iter().all(|[_, kept]| *kept >= 1300));
    assert!(faultless::<2, 3>(&[[0.5; 2]; 40]).cells.is_empty());
}

#[test]
fn clusters_of_points_a_millionth_of_a_millionth_apart_have_no_fault() {
    faultless::<3, 4>(&clusters(20, 100));
    faultless::<2, 3>(&clusters(20, 200));
}

#[test]
fn a_few_points_have_the_cells_they_span() {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 1.0, 1.0]];
    for (count, cells) in [0, 0, 0, 0, 1, 2].into_iter().enumerate() {
        assert_eq!(faultless::<3, 4>(&corners[..count]).cells.len(), cells);
    }
    let corners = corners.map(|[x, y, _]| [x, y]);
    for (count, cells) in [0, 0, 0, 1].into_iter().enumerate() {
        assert_eq!(faultless::<2, 3>(&corners[..count]).cells.len(), cells);
    }
}

#[test]
fn coordinates_from_the_smallest_to_the_largest_numbers_have_no_fault() {
    for scale in [f64::from_bits(1), 1e-310, 1e-200, 1e-60, 1e60, 1e200, 1e307] {
        faultless::<3, 4>(&random::<3>(300).iter().map(|x| x.map(|x| x * scale)).collect::<Vec<_>>());
    }
    let spread = |k: i32| {
        [10f64.powi(-k), 10f64.powi(-k / 2) * f64::from(k % 3), 10f64.powi(-k / 3) * f64::from(k % 5)]
    };
    faultless::<3, 4>(&(0..60).map(spread).collect::<Vec<_>>());
    let [far, near] = [1e15, 1e-15];
    faultless::<3, 4>(&grid::<3>(6, 0.0).iter().map(|x| x.map(|x| far + x)).collect::<Vec<_>>());
    faultless::<3, 4>(&grid::<3>(6, 0.0).iter().map(|[x, y, z]| [*x, *y, near * z]).collect::<Vec<_>>());
}

#[test]
fn thousands_of_small_clouds_on_and_about_a_lattice_have_no_fault() {
    let mut random = Random(11);
    for _ in 0..4000 {
        let count = 3 * (3 + random.below(40));
        let bytes = (0..count).map(|_| random.below(256) as u8).collect::<Vec<_>>();
        faultless::<3, 4>(&from_bytes(&bytes));
        faultless::<2, 3>(&from_bytes(&bytes));
    }
}

#[test]
fn what_cannot_be_triangulated_is_refused_in_words() {
    let mut delaunay = Delaunay::<2, 3>::new();
    let lost = delaunay.triangulate(&[[0.0, 0.0], [f64::NAN, 1.0]], &[0, 1]).unwrap_err();
    assert_eq!(lost, Error::NotFinite { point: 1 });
    assert!(lost.to_string().contains("point 1"));
    let short = delaunay.triangulate(&[[0.0, 0.0], [1.0, 1.0]], &[0]).unwrap_err();
    assert_eq!(short, Error::Ranks { points: 2, ranks: 1 });
}
