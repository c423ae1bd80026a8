//! Edges of the moved surface that the new cells lack are put back.
//!
//! Where two faces of the surface turn inwards at their edge ab, Delaunay's cells often have the other diagonal cd of the four
//! corners instead: the valley is filled with the tetrahedron abcd. The fluid cells around cd are then made cells around ab,
//! and nothing is gained.

use super::super::surface::OUTWARD;
use super::faces::Faces;
use crate::backend::pfem::cloud::{Cloud, OUTSIDE};
use crate::backend::pfem::flow::regular_volume;
use crate::element::simplex::{longest_edge, volume_and_areas};

/// A new cell has at least this share of the volume of a regular one of the same longest edge.
const THINNEST: f64 = 0.05;
/// Valleys with less than this share of it are left filled, as slivers of the surface are shed: neither is worth bad cells.
const SHALLOWEST: f64 = 0.01;
/// Edges with more cells around them stay.
const MOST: usize = 6;

/// The fluid cells around an edge of the surface, from one face of it to the other.
#[derive(Default)]
struct Fan {
    /// The ends c and d.
    ends: [u32; 2],
    /// The other corners in order; the first and the last are on the surface. They turn left seen from c.
    ring: Vec<u32>,
    /// The cells between two corners each.
    cells: Vec<u32>,
}

/// Scratch of it.
#[derive(Default)]
pub struct Diagonals {
    fan: Fan,
    made: Vec<[u32; 4]>,
    best: Vec<[u32; 4]>,
    /// Faces of the cells around an edge, ascending, and what lies behind them.
    rim: Vec<([u32; 3], u32)>,
    indices: Vec<u32>,
}

impl Diagonals {
    /// Puts edges of the surface back; `faces` are those of the moved surface.
    pub fn restore(&mut self, cloud: &mut Cloud<3, 4>, faces: &Faces) {
        let mut cell = 0;
        while cell < cloud.cells.len() {
            for opposite in 0..4 {
                if cloud.neighbours[cell][opposite] == OUTSIDE && self.turn(cloud, faces, cell, opposite) {
                    break;
                }
            }
            cell += 1;
        }
    }

    /// Empties the valley at an edge of a face of the new surface, if the moved one had one there; whether it did.
    fn turn(&mut self, cloud: &mut Cloud<3, 4>, faces: &Faces, cell: usize, opposite: usize) -> bool {
        let face = OUTWARD[opposite].map(|k| cloud.cells[cell][k]);
        if faces.side(face) == Some(true) {
            return false;
        }
        (0..3).any(|k| {
            let [c, d, a] = [0, 1, 2].map(|i| face[(k + i) % 3]);
            if !self.fan.walk(cloud, [c, d, a], cell as u32) {
                return false;
            }
            let b = self.fan.ring[self.fan.ring.len() - 1];
            let of_surface = |face| faces.side(face) == Some(true);
            let torn = of_surface([a, c, b]) && of_surface([a, b, d]) && !of_surface([d, c, b]);
            let turns = torn && fullness(cloud, &[a, c, b, d]) > SHALLOWEST && self.choose(cloud);
            if turns {
                self.replace(cloud);
            }
            turns
        })
    }

    /// Chooses the cells around ab with the fullest thinnest of them; whether all are full enough.
    fn choose(&mut self, cloud: &Cloud<3, 4>) -> bool {
        let Self { fan, made, best, .. } = self;
        let mut fullest = THINNEST;
        best.clear();
        for apex in 0..fan.ring.len() {
            fan.cells_from(apex, made);
            let thinnest = made.iter().map(|cell| fullness(cloud, cell)).fold(f64::INFINITY, f64::min);
            if thinnest > fullest {
                fullest = thinnest;
                std::mem::swap(made, best);
            }
        }
        !best.is_empty()
    }

    /// Puts the chosen cells in the place of those of the fan.
    fn replace(&mut self, cloud: &mut Cloud<3, 4>) {
        let Self { fan, best, rim, indices, .. } = self;
        rim.clear();
        for &cell in &fan.cells {
            let (corners, around) = (&cloud.cells[cell as usize], &cloud.neighbours[cell as usize]);
            for end in 0..4 {
                if fan.ends.contains(&corners[end]) {
                    rim.push((ascending(OUTWARD[end].map(|k| corners[k])), around[end]));
                }
            }
        }
        indices.clone_from(&fan.cells);
        indices.extend((cloud.cells.len() as u32..).take(best.len() - fan.cells.len()));
        cloud.cells.resize(cloud.cells.len() + best.len() - fan.cells.len(), [0; 4]);
        cloud.neighbours.resize(cloud.cells.len(), [OUTSIDE; 4]);
        for (&index, corners) in indices.iter().zip(&*best) {
            cloud.cells[index as usize] = *corners;
            for opposite in 0..4 {
                let face = ascending(OUTWARD[opposite].map(|k| corners[k]));
                let holds = |cell: &[u32; 4]| cell != corners && face.iter().all(|node| cell.contains(node));
                let outer = rim.iter().find(|(other, _)| *other == face).map(|(_, next)| *next);
                let inner = || best.iter().position(holds).map(|place| indices[place]);
                let next = outer.or_else(inner).unwrap_or(OUTSIDE);
                cloud.neighbours[index as usize][opposite] = next;
                if let Some(back) = outer.filter(|next| *next != OUTSIDE) {
                    let apex = cloud.cells[back as usize].iter().position(|node| !face.contains(node));
                    if let Some(apex) = apex {
                        cloud.neighbours[back as usize][apex] = index;
                    }
                }
            }
        }
    }
}

impl Fan {
    /// Walks from the face cda of a cell about the edge cd to the other face of the surface; whether there is more than one cell,
    /// and not too many.
    fn walk(&mut self, cloud: &Cloud<3, 4>, [c, d, a]: [u32; 3], first: u32) -> bool {
        self.ends = [c, d];
        self.ring.clear();
        self.cells.clear();
        self.ring.push(a);
        let (mut cell, mut behind) = (first, a);
        while cell != OUTSIDE && self.cells.len() < MOST {
            let corners = &cloud.cells[cell as usize];
            let ahead = corners.iter().find(|node| ![c, d, behind].contains(node));
            let across = corners.iter().position(|node| *node == behind);
            let (Some(&ahead), Some(across)) = (ahead, across) else { return false };
            self.cells.push(cell);
            self.ring.push(ahead);
            (cell, behind) = (cloud.neighbours[cell as usize][across], ahead);
        }
        cell == OUTSIDE && self.cells.len() > 1
    }

    /// Cells from c and d to the triangles of the ring that has all its diagonals from one corner.
    fn cells_from(&self, apex: usize, cells: &mut Vec<[u32; 4]>) {
        let ([c, d], count) = (self.ends, self.ring.len());
        cells.clear();
        for j in 1..count - 1 {
            let [p, q, r] = [0, j, j + 1].map(|k| self.ring[(apex + k) % count]);
            cells.extend([[p, q, r, c], [p, r, q, d]]);
        }
    }
}

/// Volume of a cell as a share of that of a regular one of the same longest edge.
fn fullness(cloud: &Cloud<3, 4>, cell: &[u32; 4]) -> f64 {
    let vertices = cloud.vertices(cell);
    volume_and_areas(&vertices).0 / (regular_volume(3) * longest_edge(&vertices).powi(3))
}

fn ascending(mut face: [u32; 3]) -> [u32; 3] {
    face.sort_unstable();
    face
}
