//! What is too small or too thin for cells: voids are filled, pieces and slivers leave, dry nodes fly.

use super::super::VolumeBooks;
use super::super::draft::Draft;
use super::super::topology::Events;
use super::tetrahedra::Tetrahedra;
use crate::backend::pfem::cloud::Cloud;
use crate::element::simplex::longest_edge;
use delaunay::HULL;

/// A closed void smaller than this many h³ is filled.
const SMALLEST_VOID: f64 = 0.5;
/// A piece smaller than this many h³ is drops.
const SMALLEST_PIECE: f64 = 0.3;
/// A cell under the surface with less than this share of the cube of its longest edge leaves.
const THINNEST: f64 = 1e-3;

/// Fills voids, takes slivers and small pieces away, and makes drops of nodes without cells and nodes of drops with cells.
pub fn settle(
    cloud: &mut Cloud<3, 4>,
    draft: &mut Draft<3>,
    tetrahedra: &mut Tetrahedra,
    book: &mut VolumeBooks,
    events: &mut Events,
) {
    let smallest = draft.size.iter().copied().fold(f64::INFINITY, f64::min).powi(3);
    let (filled, gained) = turn(cloud, tetrahedra, false, SMALLEST_VOID * smallest);
    (events.filled, events.broken) = (filled, 0);
    book.merging.add(gained);
    let (broken, thin) = shed_slivers(cloud, tetrahedra);
    let (pieces, lost) = turn(cloud, tetrahedra, true, SMALLEST_PIECE * smallest);
    book.separation.add(-thin - lost);
    (events.broken, events.released) = (broken, pieces);
    let mut wet = vec![false; cloud.place.len()];
    for cell in tetrahedra.fluids() {
        tetrahedra.made.cells[cell].iter().for_each(|&node| wet[node as usize] = true);
    }
    for node in 0..cloud.place.len() {
        let drop = cloud.drop[node];
        if wet[node] && drop > 0.0 {
            cloud.drop[node] = 0.0;
            events.absorbed += 1;
            book.absorption.add(-drop);
        } else if !wet[node] && drop == 0.0 && !draft.removed[node] {
            // The volume that the node had in its last cells.
            cloud.drop[node] = draft.mass[node];
            if draft.mass[node] <= 0.0 {
                draft.remove(node as u32);
            }
        }
    }
}

/// Makes pieces of fluid void, or closed voids fluid, that are smaller than `limit`; returns their number and volume.
fn turn(cloud: &Cloud<3, 4>, tetrahedra: &mut Tetrahedra, fluid: bool, limit: f64) -> (u32, f64) {
    let (mut count, mut sum) = (0, 0.0);
    let mut seen: Vec<bool> = tetrahedra.fluid.iter().map(|is| *is != fluid).collect();
    let mut piece = Vec::new();
    for seed in 0..seen.len() {
        if seen[seed] {
            continue;
        }
        seen[seed] = true;
        piece.clear();
        piece.push(seed);
        let (mut open, mut volume, mut visited) = (false, 0.0, 0);
        while let Some(&cell) = piece.get(visited) {
            visited += 1;
            volume += tetrahedra.volume(cloud, cell);
            for (i, next) in tetrahedra.made.neighbours[cell].into_iter().enumerate() {
                if next == HULL {
                    open |= !fluid && !at_wall(cloud, &tetrahedra.made.cells[cell], i);
                } else if !seen[next as usize] {
                    seen[next as usize] = true;
                    piece.push(next as usize);
                }
            }
        }
        if !open && volume < limit {
            piece.iter().for_each(|&cell| tetrahedra.fluid[cell] = !fluid);
            count += 1;
            sum += volume;
        }
    }
    (count, sum)
}

/// Whether all corners of a face touch the same wall.
fn at_wall(cloud: &Cloud<3, 4>, cell: &[u32; 4], opposite: usize) -> bool {
    let corners = (0..4).filter(|&k| k != opposite).map(|k| cloud.contacts[cell[k] as usize]);
    corners.reduce(|a, b| a.common(b)).is_some_and(|common| !common.is_empty())
}

/// Takes cells without thickness off the surface where no node goes with them; returns their number and volume.
fn shed_slivers(cloud: &Cloud<3, 4>, tetrahedra: &mut Tetrahedra) -> (u32, f64) {
    let (mut count, mut sum) = (0, 0.0);
    let mut uses = vec![0u32; cloud.place.len()];
    for cell in tetrahedra.fluids() {
        tetrahedra.made.cells[cell].iter().for_each(|&node| uses[node as usize] += 1);
    }
    let thin = |tetrahedra: &Tetrahedra, cell: usize| {
        let length = longest_edge(&cloud.vertices(&tetrahedra.made.cells[cell]));
        tetrahedra.volume(cloud, cell) < THINNEST * length.powi(3)
    };
    let mut next: Vec<usize> = tetrahedra.fluids().filter(|&cell| thin(tetrahedra, cell)).collect();
    loop {
        let before = next.len();
        next.retain(|&cell| {
            let corners = tetrahedra.made.cells[cell];
            let open = (0..4).any(|i| !tetrahedra.fluid_across(cell, i));
            let leaves = open && corners.iter().all(|&node| uses[node as usize] > 1);
            if leaves {
                tetrahedra.fluid[cell] = false;
                corners.iter().for_each(|&node| uses[node as usize] -= 1);
                count += 1;
                sum += tetrahedra.volume(cloud, cell);
            }
            !leaves
        });
        if next.len() == before {
            return (count, sum);
        }
    }
}
