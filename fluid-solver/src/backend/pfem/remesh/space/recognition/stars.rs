//! The moved old mesh as seen from its nodes.

use crate::backend::pfem::cloud::{Cloud, OUTSIDE};
use crate::element::simplex::{Vector, difference, dot, volume_and_areas};

/// Cells around some of the nodes.
#[derive(Clone, Debug, Default)]
pub struct Stars {
    chosen: Vec<bool>,
    first: Vec<u32>,
    cells: Vec<u32>,
    /// The last visit that met each cell.
    met: Vec<u32>,
    visit: u32,
    near: Vec<u32>,
    shapes: Vec<Shape>,
}

/// A cell of the moved mesh.
#[derive(Clone, Copy, Debug)]
struct Shape {
    vertices: [Vector<3>; 4],
    /// V∇N_i.
    areas: [Vector<3>; 4],
    /// Of the volume.
    sign: f64,
}

impl Stars {
    /// Reads the cells around some nodes.
    pub fn read(&mut self, cloud: &Cloud<3, 4>, nodes: impl Iterator<Item = u32>) {
        self.chosen.clear();
        self.chosen.resize(cloud.place.len(), false);
        nodes.for_each(|node| self.chosen[node as usize] = true);
        self.first.clear();
        self.first.resize(cloud.place.len() + 1, 0);
        for node in cloud.cells.iter().flatten().filter(|node| self.chosen[**node as usize]) {
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
            for node in cell.iter().filter(|node| self.chosen[**node as usize]) {
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
        self.first[node as usize] as usize..self.first[node as usize + 1] as usize
    }

    /// Whether a cell with these corners was there before.
    pub fn has(&self, cloud: &Cloud<3, 4>, corners: &[u32; 4]) -> bool {
        let same = |cell: &u32| corners[1..].iter().all(|node| cloud.cells[*cell as usize].contains(node));
        self.cells[self.range(corners[0])].iter().any(same)
    }

    /// Collects those of the cells around some nodes, and of their neighbours, whose boxes meet that of the nodes.
    pub fn gather(&mut self, cloud: &Cloud<3, 4>, nodes: &[u32; 4]) {
        let bounds = Bounds::around(&cloud.vertices(nodes));
        self.visit += 1;
        self.near.clear();
        self.shapes.clear();
        for &node in nodes {
            for index in self.range(node) {
                self.meet(cloud, self.cells[index], &bounds);
            }
        }
        for index in 0..self.near.len() {
            for next in cloud.neighbours[self.near[index] as usize] {
                if next != OUTSIDE {
                    self.meet(cloud, next, &bounds);
                }
            }
        }
    }

    fn meet(&mut self, cloud: &Cloud<3, 4>, cell: u32, bounds: &Bounds) {
        let met = &mut self.met[cell as usize];
        if *met != self.visit {
            *met = self.visit;
            let vertices = cloud.vertices(&cloud.cells[cell as usize]);
            if bounds.meets(&Bounds::around(&vertices)) {
                self.near.push(cell);
                self.shapes.push(Shape::new(vertices));
            }
        }
    }

    /// How often the cells gathered last cover a point; one that has turned over takes a cover away.
    pub fn cover(&self, point: &Vector<3>) -> i32 {
        self.shapes.iter().filter(|shape| shape.holds(point)).map(|shape| shape.sign as i32).sum()
    }
}

impl Shape {
    fn new(vertices: [Vector<3>; 4]) -> Self {
        let (volume, areas) = volume_and_areas(&vertices);
        Self { vertices, areas, sign: volume.signum() }
    }

    /// Whether all V ∇N_i · (x − x_j) = λ_i V, j ≠ i, have the sign of V.
    #[inline]
    fn holds(&self, point: &Vector<3>) -> bool {
        let share = |i: usize| dot(&self.areas[i], &difference(point, &self.vertices[(i + 1) % 4]));
        (0..4).all(|i| self.sign * share(i) >= 0.0)
    }
}

/// The least and the greatest coordinates of some points.
struct Bounds {
    low: Vector<3>,
    high: Vector<3>,
}

impl Bounds {
    fn around(points: &[Vector<3>; 4]) -> Self {
        let [a, b, c, d] = points;
        Self {
            low: std::array::from_fn(|k| a[k].min(b[k]).min(c[k].min(d[k]))),
            high: std::array::from_fn(|k| a[k].max(b[k]).max(c[k].max(d[k]))),
        }
    }

    fn meets(&self, other: &Self) -> bool {
        (0..3).all(|k| self.low[k] <= other.high[k] && other.low[k] <= self.high[k])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_lies_in_a_cell_whichever_way_it_turns() {
        let cell = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let [right, turned] = [cell, [cell[1], cell[0], cell[2], cell[3]]].map(Shape::new);
        assert_eq!([right.sign, turned.sign], [1.0, -1.0]);
        for shape in [right, turned] {
            assert!(shape.holds(&[0.2; 3]) && !shape.holds(&[0.4; 3]));
        }
    }
}
