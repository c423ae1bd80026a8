//! What is too small or too thin for cells, or in a wall: voids are filled, pieces and slivers leave, dry nodes fly.

use super::super::VolumeBooks;
use super::super::buried::is_buried;
use super::super::draft::Draft;
use super::super::topology::Events;
use super::surface::OUTWARD;
use super::tetrahedra::Tetrahedra;
use crate::backend::pfem::cloud::Cloud;
use crate::backend::pfem::wall::{Contacts, Wall, inlet_of};
use crate::element::simplex::longest_edge;
use delaunay::HULL;

/// A closed void smaller than this many h³ is filled.
const SMALLEST_VOID: f64 = 0.5;
/// A piece smaller than this many h³ is drops.
const SMALLEST_PIECE: f64 = 0.3;
/// A cell under the surface with less than this share of the cube of its longest edge leaves where no node goes with it.
const THINNEST: f64 = 1e-3;
/// Nor do nodes keep one with less than this share: it has no mass, and any pressure would throw them out of it.
const EMPTY: f64 = 1e-6;

/// A node nearer to the plane of an inlet than this share of h is in it.
const FLAT: f64 = 1e-6;

/// What is known of the piece of a cell.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Piece {
    Unknown,
    /// It is the one that is being looked at.
    This,
    /// It stays as it is.
    Stays,
}

/// Scratch of it.
#[derive(Default)]
pub struct Patches {
    known: Vec<Piece>,
    piece: Vec<usize>,
    /// Fluid cells around each node.
    uses: Vec<u32>,
}

impl Patches {
    /// Fills voids, takes cells in walls, slivers and small pieces away, and makes drops of nodes without cells and nodes of drops with
    /// cells.
    ///
    /// Returns by how much the volume of the cells grew.
    pub fn settle(
        &mut self,
        cloud: &mut Cloud<3, 4>,
        draft: &mut Draft<3>,
        tetrahedra: &mut Tetrahedra,
        (walls, time): (&[Wall<3>], f64),
        book: &mut VolumeBooks,
        events: &mut Events,
    ) -> f64 {
        let smallest = draft.size.iter().copied().fold(f64::INFINITY, f64::min).powi(3);
        let (filled, gained) = self.turn(cloud, tetrahedra, false, SMALLEST_VOID * smallest);
        let (buried, in_walls) = unearth(cloud, draft, tetrahedra, walls, time);
        self.uses.clear();
        self.uses.resize(cloud.place.len(), 0);
        for cell in tetrahedra.fluids() {
            tetrahedra.made.cells[cell].iter().for_each(|&node| self.uses[node as usize] += 1);
        }
        let (broken, thin) = self.shed_slivers(cloud, tetrahedra);
        let (pieces, lost) = self.turn(cloud, tetrahedra, true, SMALLEST_PIECE * smallest);
        let fed = self.feed(cloud, draft, tetrahedra, walls);
        book.merging.add(gained + fed);
        book.separation.add(-in_walls - thin - lost);
        (events.filled, events.broken, events.released) = (filled, buried + broken, pieces);
        for node in 0..cloud.place.len() {
            let (wet, drop) = (self.uses[node] > 0, cloud.drop[node]);
            if wet && drop > 0.0 {
                cloud.drop[node] = 0.0;
                events.absorbed += 1;
                book.absorption.add(-drop);
            } else if !wet && drop == 0.0 && !draft.removed[node] {
                // The volume that the node had in its last cells.
                cloud.drop[node] = draft.mass[node];
                if draft.mass[node] <= 0.0 {
                    draft.remove(node as u32);
                }
            }
        }
        gained + fed - in_walls - thin - lost
    }

    /// Makes cells before inlets fluid: what comes in is there. Returns their volume.
    fn feed(
        &mut self,
        cloud: &Cloud<3, 4>,
        draft: &Draft<3>,
        tetrahedra: &mut Tetrahedra,
        walls: &[Wall<3>],
    ) -> f64 {
        let mut sum = 0.0;
        let closed = walls.iter().all(|wall| wall.inflow.is_none());
        for cell in 0..if closed { 0 } else { tetrahedra.fluid.len() } {
            let corners = tetrahedra.made.cells[cell];
            if !tetrahedra.fluid[cell] && is_fed(cloud, draft, walls, &corners) {
                tetrahedra.fluid[cell] = true;
                corners.iter().for_each(|&node| self.uses[node as usize] += 1);
                sum += tetrahedra.volume(cloud, cell);
            }
        }
        sum
    }

    /// Makes pieces of fluid void, or closed voids fluid, that are smaller than `limit`; returns their number and volume.
    fn turn(
        &mut self,
        cloud: &Cloud<3, 4>,
        tetrahedra: &mut Tetrahedra,
        fluid: bool,
        limit: f64,
    ) -> (u32, f64) {
        let Self { known, piece, uses } = self;
        let (mut count, mut sum) = (0, 0.0);
        known.clear();
        known.resize(tetrahedra.fluid.len(), Piece::Unknown);
        for seed in 0..known.len() {
            if tetrahedra.fluid[seed] != fluid || known[seed] != Piece::Unknown {
                continue;
            }
            known[seed] = Piece::This;
            piece.clear();
            piece.push(seed);
            let (mut stays, mut volume, mut visited) = (false, 0.0, 0);
            while let Some(&cell) = piece.get(visited).filter(|_| !stays) {
                visited += 1;
                for (opposite, &next) in tetrahedra.made.neighbours[cell].iter().enumerate() {
                    if next == HULL {
                        stays |= !fluid && !at_wall(cloud, &tetrahedra.made.cells[cell], opposite);
                    } else if tetrahedra.fluid[next as usize] == fluid {
                        match known[next as usize] {
                            Piece::Unknown => {
                                known[next as usize] = Piece::This;
                                piece.push(next as usize);
                            }
                            Piece::This => {}
                            Piece::Stays => stays = true,
                        }
                    }
                }
                if !stays {
                    volume += tetrahedra.volume(cloud, cell);
                    stays = volume >= limit;
                }
            }
            if stays {
                piece.iter().for_each(|&cell| known[cell] = Piece::Stays);
                continue;
            }
            for &cell in &*piece {
                tetrahedra.fluid[cell] = !fluid;
                if fluid {
                    tetrahedra.made.cells[cell].iter().for_each(|&node| uses[node as usize] -= 1);
                }
            }
            count += 1;
            sum += volume;
        }
        (count, sum)
    }

    /// Takes cells without thickness off the surface; where nodes go with them, only those without volume. Returns their number
    /// and volume.
    fn shed_slivers(&mut self, cloud: &Cloud<3, 4>, tetrahedra: &mut Tetrahedra) -> (u32, f64) {
        let Self { piece: next, uses, .. } = self;
        let (mut count, mut sum) = (0, 0.0);
        let open = |tetrahedra: &Tetrahedra, cell: usize| (0..4).any(|i| !tetrahedra.fluid_across(cell, i));
        next.clear();
        next.extend(tetrahedra.fluids().filter(|&cell| open(tetrahedra, cell)));
        let mut tried = 0;
        while let Some(&cell) = next.get(tried) {
            tried += 1;
            let corners = tetrahedra.made.cells[cell];
            if !tetrahedra.fluid[cell] {
                continue;
            }
            let volume = tetrahedra.volume(cloud, cell);
            let bears = corners.iter().any(|&node| uses[node as usize] == 1);
            let least = if bears { EMPTY } else { THINNEST };
            if volume < least * longest_edge(&cloud.vertices(&corners)).powi(3) {
                tetrahedra.fluid[cell] = false;
                corners.iter().for_each(|&node| uses[node as usize] -= 1);
                let around = tetrahedra.made.neighbours[cell].iter().map(|&other| other as usize);
                next.extend(around.filter(|&other| tetrahedra.fluid.get(other) == Some(&true)));
                count += 1;
                sum += volume;
            }
        }
        (count, sum)
    }
}

/// Whether three corners of a cell are in an inlet and the other before it.
fn is_fed(cloud: &Cloud<3, 4>, draft: &Draft<3>, walls: &[Wall<3>], corners: &[u32; 4]) -> bool {
    let contacts = corners.map(|node| cloud.contacts[node as usize]);
    (0..4).any(|apex| {
        let face = (0..4).filter(|&i| i != apex).map(|i| contacts[i]).reduce(Contacts::common);
        let Some((inlet, _)) = face.and_then(|face| inlet_of(walls, face)) else { return false };
        let (node, h) = (corners[apex] as usize, draft.size[corners[apex] as usize]);
        walls[inlet].touch(&cloud.place[node], 0.0).gap > FLAT * h
    })
}

/// Takes the cells away that are buried in walls; returns their number and volume.
fn unearth(
    cloud: &Cloud<3, 4>,
    draft: &Draft<3>,
    tetrahedra: &mut Tetrahedra,
    walls: &[Wall<3>],
    time: f64,
) -> (u32, f64) {
    let (mut count, mut sum) = (0, 0.0);
    for cell in 0..tetrahedra.fluid.len() {
        let corners = tetrahedra.made.cells[cell];
        let h = draft.size[corners[0] as usize];
        if tetrahedra.fluid[cell] && is_buried(cloud, walls, time, &corners, h) {
            tetrahedra.fluid[cell] = false;
            count += 1;
            sum += tetrahedra.volume(cloud, cell);
        }
    }
    (count, sum)
}

/// Whether all corners of a face touch the same wall.
fn at_wall(cloud: &Cloud<3, 4>, cell: &[u32; 4], opposite: usize) -> bool {
    let [a, b, c] = OUTWARD[opposite].map(|k| cloud.contacts[cell[k] as usize]);
    !a.common(b).common(c).is_empty()
}

#[cfg(test)]
mod tests {
    use super::super::super::size::TargetSize;
    use super::*;
    use crate::backend::pfem::body::Body;

    #[test]
    fn a_node_whose_only_cell_has_no_volume_flies_with_what_it_had() {
        let place = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 1.0, 0.0]];
        let cells = vec![[0, 1, 2, 3], [1, 0, 2, 4]];
        let neighbours = vec![[HULL, HULL, HULL, 1], [HULL, HULL, HULL, 0]];
        let mut cloud = Body { place, cells: cells.clone(), neighbours: neighbours.clone() }.cloud();
        let (mut draft, mut tetrahedra) = (Draft::<3>::default(), Tetrahedra::default());
        draft.read_sizes(&cloud, &TargetSize::Constant(0.5));
        draft.mass = vec![0.02; 5];
        (tetrahedra.made.cells, tetrahedra.made.neighbours) = (cells, neighbours);
        tetrahedra.fluid = vec![true; 2];
        let (mut book, mut events) = (VolumeBooks::default(), Events::default());
        let walls = (&[][..], 0.0);
        Patches::default().settle(&mut cloud, &mut draft, &mut tetrahedra, walls, &mut book, &mut events);
        assert_eq!(tetrahedra.fluid, [true, false]);
        assert_eq!(cloud.drop, [0.0, 0.0, 0.0, 0.0, 0.02]);
    }
}
