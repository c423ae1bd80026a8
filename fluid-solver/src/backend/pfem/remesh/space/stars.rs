//! The moved old mesh as seen from its nodes.

use crate::backend::pfem::cloud::{Cloud, OUTSIDE};
use crate::element::simplex::{Vector, difference, dot, volume_and_areas};

/// Cells around each node.
#[derive(Clone, Debug, Default)]
pub struct Stars {
    first: Vec<u32>,
    cells: Vec<u32>,
    /// The last visit that met each cell.
    met: Vec<u32>,
    visit: u32,
    near: Vec<u32>,
}

impl Stars {
    /// Reads the cells.
    pub fn read(&mut self, cloud: &Cloud<3, 4>) {
        self.first.clear();
        self.first.resize(cloud.place.len() + 1, 0);
        for node in cloud.cells.iter().flatten() {
            self.first[*node as usize] += 1;
        }
        let mut end = 0;
        for first in &mut self.first {
            end += *first;
            *first = end;
        }
        self.cells.clear();
        self.cells.resize(end as usize, 0);
        for (index, cell) in cloud.cells.iter().enumerate().rev() {
            for node in cell {
                let first = &mut self.first[*node as usize];
                *first -= 1;
                self.cells[*first as usize] = index as u32;
            }
        }
        self.met.clear();
        self.met.resize(cloud.cells.len(), 0);
        self.visit = 0;
    }

    /// Where the cells around a node are; none are around a node that was added since.
    fn range(&self, node: u32) -> std::ops::Range<usize> {
        match (self.first.get(node as usize), self.first.get(node as usize + 1)) {
            (Some(&first), Some(&end)) => first as usize..end as usize,
            _ => 0..0,
        }
    }

    /// Whether a cell with these corners was there before.
    pub fn has(&self, cloud: &Cloud<3, 4>, corners: &[u32; 4]) -> bool {
        let same = |cell: &u32| corners[1..].iter().all(|node| cloud.cells[*cell as usize].contains(node));
        self.cells[self.range(corners[0])].iter().any(same)
    }

    /// Collects the cells around some nodes and their neighbours.
    pub fn gather(&mut self, cloud: &Cloud<3, 4>, nodes: &[u32; 4]) {
        self.visit += 1;
        self.near.clear();
        for &node in nodes {
            for &cell in &self.cells[self.range(node)] {
                if self.met[cell as usize] != self.visit {
                    self.met[cell as usize] = self.visit;
                    self.near.push(cell);
                }
            }
        }
        for index in 0..self.near.len() {
            for next in cloud.neighbours[self.near[index] as usize] {
                if next != OUTSIDE && self.met[next as usize] != self.visit {
                    self.met[next as usize] = self.visit;
                    self.near.push(next);
                }
            }
        }
    }

    /// How often the cells gathered last cover a point; one that has turned over takes a cover away.
    pub fn cover(&self, cloud: &Cloud<3, 4>, point: &Vector<3>) -> i32 {
        let sign = |cell: &u32| sign_inside(&cloud.vertices(&cloud.cells[*cell as usize]), point);
        self.near.iter().map(sign).sum()
    }
}

/// The sign of the volume of a cell if the point lies in it, else zero.
fn sign_inside(vertices: &[Vector<3>; 4], point: &Vector<3>) -> i32 {
    for k in 0..3 {
        let apart = |sign: f64| vertices.iter().all(|x| sign * (x[k] - point[k]) > 0.0);
        if apart(1.0) || apart(-1.0) {
            return 0;
        }
    }
    let (volume, areas) = volume_and_areas(vertices);
    let sign = volume.signum();
    // λ_i V = V ∇N_i · (x − x_j), j ≠ i.
    let share = |i: usize| dot(&areas[i], &difference(point, &vertices[(i + 1) % 4]));
    if (0..4).all(|i| sign * share(i) >= 0.0) { sign as i32 } else { 0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_lies_in_a_cell_whichever_way_it_turns() {
        let cell = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let turned = [cell[1], cell[0], cell[2], cell[3]];
        assert_eq!([sign_inside(&cell, &[0.2; 3]), sign_inside(&turned, &[0.2; 3])], [1, -1]);
        assert_eq!(sign_inside(&cell, &[0.4; 3]), 0);
    }
}
