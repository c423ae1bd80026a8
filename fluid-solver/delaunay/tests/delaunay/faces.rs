//! Faces put into triangulations in space.

use crate::clouds::{Random, random};
use crate::{faultless, program, volumes};
use delaunay::constrained::Recovery;
use delaunay::{HULL, Triangulation};
use std::collections::BTreeMap;

fn rising(mut face: [u32; 3]) -> [u32; 3] {
    face.sort_unstable();
    face
}

fn faces(cell: &[u32; 4]) -> [[u32; 3]; 4] {
    [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]].map(|at| rising(at.map(|k| cell[k])))
}

/// How often each face is one of a cell.
fn known(made: &Triangulation<4>) -> BTreeMap<[u32; 3], usize> {
    let mut known = BTreeMap::new();
    made.cells.iter().flat_map(faces).for_each(|face| *known.entry(face).or_default() += 1);
    known
}

/// Puts faces in and demands that positive cells fill the same hull, that neighbours share faces, and that no face that was
/// there is lost; returns how many were missing before and are missing after.
fn put_in(points: &[[f64; 3]], made: &mut Triangulation<4>, wanted: &[[u32; 3]]) -> (usize, usize) {
    let before = known(made);
    let volume = volumes(points, made).iter().sum::<f64>();
    let missing = wanted.iter().copied().filter(|face| !before.contains_key(face)).collect::<Vec<_>>();
    let kept = |face: [u32; 3]| wanted.contains(&rising(face));
    Recovery::default().recover(points, made, &missing, kept).unwrap();
    let after = known(made);
    let now = volumes(points, made);
    assert!(now.iter().all(|volume| *volume > 0.0));
    assert!((now.iter().sum::<f64>() / volume - 1.0).abs() < 1e-12);
    for (index, (cell, around)) in made.cells.iter().zip(&made.neighbours).enumerate() {
        for (face, next) in faces(cell).iter().zip(around) {
            if *next == HULL {
                assert!(after[face] == 1 && before[face] == 1, "the hull stays");
            } else {
                let at = faces(&made.cells[*next as usize]).iter().position(|other| other == face).unwrap();
                assert_eq!(made.neighbours[*next as usize][at] as usize, index);
                assert_eq!(after[face], 2);
            }
        }
    }
    assert!(wanted.iter().all(|face| !before.contains_key(face) || after.contains_key(face)));
    let left = missing.iter().filter(|face| !after.contains_key(*face)).count();
    (missing.len(), left)
}

/// The surface of what was inside of a ball, after all points have moved by up to `noise`.
fn moved_ball(count: usize, noise: f64) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let mut points = random::<3>(count);
    let old = faultless(&points);
    let inside = |cell: &[u32; 4]| {
        let middle: [f64; 3] =
            std::array::from_fn(|k| 0.25 * cell.iter().map(|p| points[*p as usize][k]).sum::<f64>());
        middle.iter().map(|x| (x - 0.5).powi(2)).sum::<f64>() < 0.09
    };
    let mut uses = BTreeMap::<[u32; 3], usize>::new();
    for face in old.cells.iter().filter(|cell| inside(cell)).flat_map(faces) {
        *uses.entry(face).or_default() += 1;
    }
    let mut noises = Random(11);
    points.iter_mut().flatten().for_each(|x| *x += noise * (2.0 * noises.next() - 1.0));
    (points, uses.into_iter().filter(|(_, uses)| *uses == 1).map(|(face, _)| face).collect())
}

#[test]
#[allow(clippy::print_stdout, reason = "the shares are figures of the documentation")]
fn the_surface_of_a_moved_ball_is_put_in_but_for_a_few_faces() {
    for (noise, share) in [(1e-3, 0.0), (3e-3, 0.02), (1e-2, 0.04)] {
        let (points, surface) = moved_ball(2000, noise);
        let mut made = faultless(&points);
        let (missing, left) = put_in(&points, &mut made, &surface);
        println!("noise {noise}: {left} faces are left of {missing} that were missing");
        assert!(missing > 0 && left as f64 <= share * missing as f64, "{noise}: {left} of {missing}");
    }
}

#[test]
fn a_face_across_an_edge_of_three_cells_takes_its_place() {
    // The edge between the poles is that of three cells; the face around it is that of two.
    let points = [[0.0, 0.0, 0.2], [0.0, 0.0, -0.2], [1.0, 0.0, 0.0], [-0.5, 0.8, 0.0], [-0.5, -0.8, 0.0]];
    let mut made = faultless(&points);
    assert_eq!(made.cells.len(), 3);
    assert_eq!(put_in(&points, &mut made, &[[2, 3, 4]]), (1, 0));
    assert_eq!(made.cells.len(), 2);
}

#[test]
fn either_diagonal_of_an_octahedron_is_as_good() {
    let points = [
        [1.0, 0.0, 0.0],
        [-1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, -1.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.0, 0.0, -1.0],
    ];
    for face in [[0, 1, 2], [0, 1, 4], [2, 3, 0], [2, 3, 5], [4, 5, 1], [4, 5, 3]] {
        let mut made = faultless(&points);
        let (_, left) = put_in(&points, &mut made, &[rising(face)]);
        assert_eq!(left, 0, "{face:?}");
    }
}

#[test]
fn faces_that_cross_a_kept_one_stay_out_and_change_nothing() {
    let points = [[0.0, 0.0, 0.2], [0.0, 0.0, -0.2], [1.0, 0.0, 0.0], [-0.5, 0.8, 0.0], [-0.5, -0.8, 0.0]];
    let mut made = faultless(&points);
    let before = made.clone();
    assert_eq!(put_in(&points, &mut made, &[[0, 1, 2], [2, 3, 4]]), (1, 1));
    assert_eq!(made, before);
}

#[test]
fn faces_put_in_one_after_another_between_points_of_a_lattice_leave_cells_that_fill_the_hull_once() {
    let mut random = Random(31);
    let bytes = |_| (0..150 + random.below(300)).map(|_| random.below(256) as u8).collect::<Vec<_>>();
    let put_in = (0..300).map(bytes).map(|bytes| program::recovered_faces(&bytes)).sum::<usize>();
    assert!(put_in > 1000, "put in {put_in} faces");
}
