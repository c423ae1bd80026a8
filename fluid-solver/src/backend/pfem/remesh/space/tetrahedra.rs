//! Tetrahedra between all nodes, void included.

use super::super::draft::Draft;
use crate::backend::pfem::cloud::{Cloud, OUTSIDE};
use crate::element::simplex::{Vector, volume_and_areas};
use delaunay::{Delaunay, Error, HULL, Triangulation};

/// The tetrahedra.
#[derive(Default)]
pub struct Tetrahedra {
    delaunay: Delaunay<3, 4>,
    /// Tetrahedra; their corners are nodes.
    pub made: Triangulation<4>,
    /// Whether each is fluid.
    pub fluid: Vec<bool>,
    points: Vec<Vector<3>>,
    ranks: Vec<u32>,
    node_of: Vec<u32>,
    number: Vec<u32>,
}

impl Tetrahedra {
    /// Triangulates the nodes that are not to go. Of nodes at the same place the first born stays.
    pub fn triangulate(&mut self, cloud: &mut Cloud<3, 4>, draft: &mut Draft<3>) -> Result<(), Error> {
        self.points.clear();
        self.ranks.clear();
        self.node_of.clear();
        for node in (0..cloud.place.len()).filter(|&node| !draft.removed[node]) {
            self.points.push(cloud.place[node]);
            self.ranks.push(cloud.birth[node]);
            self.node_of.push(node as u32);
        }
        self.delaunay.triangulate(&self.points, &self.ranks)?;
        self.delaunay.swap(&mut self.made);
        for [gone, kept] in self.made.twins.iter().map(|twin| twin.map(|point| self.node_of[point as usize]))
        {
            draft.unite(cloud, gone, kept);
        }
        if self.node_of.len() < cloud.place.len() {
            for corner in self.made.cells.iter_mut().flatten() {
                *corner = self.node_of[*corner as usize];
            }
        }
        Ok(())
    }

    /// Whether the neighbour across a face is fluid.
    pub fn fluid_across(&self, cell: usize, corner: usize) -> bool {
        let neighbour = self.made.neighbours[cell][corner];
        neighbour != HULL && self.fluid[neighbour as usize]
    }

    /// Indices of the fluid cells.
    pub fn fluids(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.fluid.len()).filter(|&cell| self.fluid[cell])
    }

    /// Volume of a cell.
    pub fn volume(&self, cloud: &Cloud<3, 4>, cell: usize) -> f64 {
        volume_and_areas(&cloud.vertices(&self.made.cells[cell])).0
    }

    /// Makes the fluid the cells of the cloud.
    pub fn take(&mut self, cloud: &mut Cloud<3, 4>) {
        self.number.clear();
        let mut count = 0;
        for &fluid in &self.fluid {
            self.number.push(if fluid { count } else { OUTSIDE });
            count += u32::from(fluid);
        }
        cloud.cells.clear();
        cloud.neighbours.clear();
        for cell in (0..self.fluid.len()).filter(|&cell| self.fluid[cell]) {
            let number = |next: u32| self.number.get(next as usize).copied().unwrap_or(OUTSIDE);
            cloud.cells.push(self.made.cells[cell]);
            cloud.neighbours.push(self.made.neighbours[cell].map(number));
        }
    }
}
