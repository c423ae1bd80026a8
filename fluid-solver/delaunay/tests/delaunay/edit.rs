//! Points that come, go and move one by one.

use crate::clouds::{Random, flat, from_bytes, grid, random, sphere};
use crate::program;
use delaunay::{Delaunay, Error, check};

/// Puts points in, moves and removes some, and compares with all of them together; returns how often the mesh was kept.
fn claim<const D: usize, const N: usize>(points: &[[f64; D]], seed: u64) -> usize {
    let mut random = Random(seed);
    let mut times = 0;
    let (mut places, mut ranks) = (points.to_vec(), (0..points.len() as u32).collect::<Vec<_>>());
    let mut edited = Delaunay::<D, N>::new();
    edited.triangulate(&places, &ranks).unwrap();
    for n in 0..places.len().min(60) {
        let point = random.below(places.len());
        match random.below(3) {
            0 => {
                edited.remove(point as u32);
                places.swap_remove(point);
                ranks.swap_remove(point);
            }
            1 => {
                let other = places[random.below(places.len())];
                places[point] = std::array::from_fn(|k| 0.5 * (places[point][k] + other[k]));
                edited.relocate(point as u32, places[point]).unwrap();
            }
            _ => {
                let place = std::array::from_fn(|k| 1.25 * points[random.below(points.len())][k]);
                places.push(place);
                ranks.push((points.len() + n) as u32);
                edited.insert(place, ranks[ranks.len() - 1]).unwrap();
            }
        }
        times += usize::from(edited.was_reused());
        if places.is_empty() {
            break;
        }
    }
    let together = Delaunay::<D, N>::new().triangulate(&places, &ranks).unwrap().clone();
    let made = edited.triangulation();
    assert!(check(&places, &ranks, made).unwrap().none());
    assert!(*made == together, "{} points", points.len());
    times
}

#[test]
fn random_clouds_grids_spheres_and_planes_have_the_cells_that_they_would_have_together() {
    for seed in 0..10 {
        assert_eq!(claim::<3, 4>(&random(400), seed), 60);
        assert_eq!(claim::<2, 3>(&random(400), seed), 60);
        claim::<3, 4>(&grid(6, 0.0), seed);
        claim::<2, 3>(&grid(12, 0.0), seed);
        claim::<3, 4>(&sphere(200), seed);
        claim::<2, 3>(&sphere(200), seed);
        claim::<3, 4>(&flat(100, 2), seed);
        claim::<2, 3>(&flat(100, 1), seed);
    }
}

#[test]
fn a_thousand_small_clouds_on_and_about_a_lattice_have_the_cells_that_they_would_have_together() {
    let mut random = Random(17);
    for seed in 0..1000 {
        let bytes = (0..3 * (3 + random.below(30))).map(|_| random.below(256) as u8).collect::<Vec<_>>();
        claim::<3, 4>(&from_bytes(&bytes), seed);
        claim::<2, 3>(&from_bytes(&bytes), seed);
    }
}

#[test]
fn programs_of_edits_from_the_lattice_to_either_end_of_the_range_of_numbers_leave_the_mesh_made_anew() {
    let mut random = Random(23);
    let mut kept = 0;
    for _ in 0..300 {
        let bytes: Vec<u8> = (0..random.below(300)).map(|_| random.below(256) as u8).collect();
        kept += program::edits::<2, 3>(&bytes) + program::edits::<3, 4>(&bytes);
    }
    assert!(kept > 1000, "kept {kept} times");
}

#[test]
fn edges_forced_between_points_of_a_lattice_are_there_or_something_is_in_their_way() {
    let mut random = Random(29);
    let bytes = |_| (0..random.below(200)).map(|_| random.below(256) as u8).collect::<Vec<_>>();
    let forced = (0..300).map(bytes).map(|bytes| program::forced_edges(&bytes)).sum::<usize>();
    assert!(forced > 1000, "forced {forced} edges");
}

#[test]
fn points_may_come_one_by_one_from_the_first_on() {
    let points = grid::<3>(5, 0.0);
    let mut edited = Delaunay::<3, 4>::new();
    for (rank, place) in points.iter().enumerate() {
        edited.insert(*place, rank as u32).unwrap();
    }
    let rank = (0..points.len() as u32).collect::<Vec<_>>();
    assert_eq!(edited.triangulation(), Delaunay::<3, 4>::new().triangulate(&points, &rank).unwrap());
}

#[test]
fn what_cannot_be_put_in_is_refused_in_words_and_changes_nothing() {
    let mut edited = Delaunay::<2, 3>::new();
    let before = edited.triangulate(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], &[0, 1, 2]).unwrap().clone();
    assert_eq!(edited.insert([f64::NAN, 0.0], 3), Err(Error::NotFinite { point: 3 }));
    let far = edited.relocate(1, [1e30, 0.0]).unwrap_err();
    assert_eq!(far, Error::TooFar { point: 1 });
    assert!(far.to_string().contains("point 1"));
    assert_eq!(&before, edited.triangulation());
}
