//! Which tetrahedra a face passes through.

use super::edges_of;
use super::signs::{pierces, sign};
use crate::predicate::space::FACE;
use crate::{HULL, Triangulation};
use robust::{Coord, orient2d};

/// A face that passes through more tetrahedra is left.
const MOST_CELLS: usize = 100;

/// Points and a triangulation of them.
#[derive(Clone, Copy)]
pub struct Scene<'a> {
    /// Scaled points.
    pub points: &'a [[f64; 3]],
    pub made: &'a Triangulation<4>,
    /// Some cell of each point, [`HULL`] if it has none.
    pub incident: &'a [u32],
}

/// Edges of a cell.
const EDGES: [[usize; 2]; 6] = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];

impl Scene<'_> {
    /// Writes the cells that a face passes through; none if they are too many or a corner has no cells.
    pub fn crossed(&self, face: [u32; 3], cells: &mut Vec<u32>) {
        cells.clear();
        if face.iter().any(|corner| self.incident[*corner as usize] == HULL) {
            return;
        }
        let mut around = vec![];
        for corner in face {
            self.star(corner, &mut around);
            for &cell in &around {
                if !cells.contains(&cell) && self.meets(cell, face) {
                    cells.push(cell);
                }
            }
        }
        let mut visited = 0;
        while let Some(&cell) = cells.get(visited) {
            visited += 1;
            for next in self.made.neighbours[cell as usize] {
                if next != HULL && !cells.contains(&next) && self.meets(next, face) {
                    cells.push(next);
                }
            }
            if cells.len() > MOST_CELLS {
                cells.clear();
                return;
            }
        }
        cells.sort_unstable();
    }

    /// Writes the cells around a point.
    fn star(&self, point: u32, cells: &mut Vec<u32>) {
        cells.clear();
        cells.push(self.incident[point as usize]);
        let mut visited = 0;
        while let Some(&cell) = cells.get(visited) {
            visited += 1;
            let corners = &self.made.cells[cell as usize];
            for (at, &next) in self.made.neighbours[cell as usize].iter().enumerate() {
                if corners[at] != point && next != HULL && !cells.contains(&next) {
                    cells.push(next);
                }
            }
        }
    }

    /// Whether a face passes through a cell, or along its face and across an edge of it.
    fn meets(&self, cell: u32, face: [u32; 3]) -> bool {
        let corners = self.made.cells[cell as usize];
        let [a, b, c] = face;
        let above = corners.map(|p| if face.contains(&p) { 0 } else { self.sign([a, b, c, p]) });
        let edges = EDGES.map(|edge| edge.map(|k| corners[k]));
        let sides = edges_of(face);
        let parted = |[i, j]: &[usize; 2]| above[*i] * above[*j] < 0;
        let level = |[i, j]: &[usize; 2]| above[*i] == 0 && above[*j] == 0;
        if EDGES.iter().any(&parted) {
            let pierced = EDGES.iter().zip(edges).any(|(at, edge)| parted(at) && self.pierces(edge, face));
            return pierced
                || sides.iter().any(|side| {
                    FACE.iter().any(|at| self.pierces(*side, at.map(|k| corners[k])))
                        || edges.iter().any(|edge| self.cross(*side, *edge))
                });
        }
        let mut along = EDGES.iter().zip(edges).filter(|(at, _)| level(at));
        along.any(|(_, edge)| sides.iter().any(|side| self.cross(*side, edge)))
    }

    fn sign(&self, points: [u32; 4]) -> i8 {
        sign(points.map(|point| &self.points[point as usize]))
    }

    fn pierces(&self, edge: [u32; 2], face: [u32; 3]) -> bool {
        pierces(edge, face, |four| self.sign(four))
    }

    /// Whether two edges lie in a plane and cross there: they do so seen along some axis.
    fn cross(&self, [a, b]: [u32; 2], [c, d]: [u32; 2]) -> bool {
        if [a, b].contains(&c) || [a, b].contains(&d) || self.sign([a, b, c, d]) != 0 {
            return false;
        }
        let [a, b, c, d] = [a, b, c, d].map(|point| self.points[point as usize]);
        (0..3).any(|axis| {
            let [a, b, c, d] = [a, b, c, d].map(|x| Coord { x: x[(axis + 1) % 3], y: x[(axis + 2) % 3] });
            orient2d(a, b, c) * orient2d(a, b, d) < 0.0 && orient2d(c, d, a) * orient2d(c, d, b) < 0.0
        })
    }
}
