//! Triangles between all nodes of the mesh, void included.

use super::draft::{Draft, NONE};
use crate::backend::pfem::cloud::Cloud;
use crate::element::simplex::Vector;
use delaunay::constrained::Constrained;
use delaunay::{Delaunay, Error, HULL};
use interface::usage::ThreadClock;

/// The triangles; a point is a node that is no drop.
#[derive(Default)]
pub struct Tessellation {
    /// Triangles between the points.
    pub made: Constrained,
    /// Places of the points (m).
    pub points: Vec<Vector<2>>,
    /// Node of each point.
    pub node_of: Vec<u32>,
    /// Point of each node, [`NONE`] for drops.
    pub point_of: Vec<u32>,
    /// Whether each triangle is fluid.
    pub fluid: Vec<bool>,
    /// Lists that passes over the triangles need.
    pub scratch: Scratch,
    /// Processor time of triangulation since the start (s).
    pub seconds: f64,
    rank: Vec<u32>,
    delaunay: Delaunay<2, 3>,
}

/// Lists that passes over the triangles need; they hold nothing from pass to pass.
#[derive(Debug, Default)]
pub struct Scratch {
    /// Winding number of each triangle.
    pub winding: Vec<Option<i32>>,
    /// By how much it grows across each edge into the triangle.
    pub steps: Vec<[i32; 3]>,
    /// Whether a triangle was visited.
    pub seen: Vec<bool>,
    /// Triangles to visit.
    pub front: Vec<usize>,
    /// A mark per node.
    pub marks: Vec<bool>,
}

impl Tessellation {
    /// Triangulates the nodes that are no drops and not to go; of nodes at one place the oldest stays.
    ///
    /// # Errors
    /// A place that is not finite.
    pub fn triangulate(&mut self, cloud: &mut Cloud<2, 3>, draft: &mut Draft) -> Result<(), Error> {
        let mut clock = ThreadClock::start();
        for list in [&mut self.node_of, &mut self.point_of, &mut self.rank] {
            list.clear();
        }
        self.points.clear();
        for (node, place) in cloud.place.iter().enumerate() {
            let meshed = cloud.drop[node] == 0.0 && !draft.removed[node];
            self.point_of.push(if meshed { self.points.len() as u32 } else { NONE });
            if meshed {
                self.points.push(*place);
                self.rank.push(cloud.birth[node]);
                self.node_of.push(node as u32);
            }
        }
        let plain = self.delaunay.triangulate(&self.points, &self.rank)?;
        for twins in &plain.twins {
            let [gone, kept] = twins.map(|point| self.node_of[point as usize]);
            draft.unite(cloud, gone, kept);
        }
        self.made.start(plain, self.points.len());
        self.seconds += clock.lap();
        Ok(())
    }

    /// Corners of a triangle as nodes.
    pub fn nodes(&self, triangle: usize) -> [u32; 3] {
        self.made.triangulation.cells[triangle].map(|point| self.node_of[point as usize])
    }

    /// Corners of a triangle (m).
    pub fn vertices(&self, triangle: usize) -> [Vector<2>; 3] {
        self.made.triangulation.cells[triangle].map(|point| self.points[point as usize])
    }

    /// Neighbours of a triangle, [`HULL`] where there is none.
    pub fn neighbours(&self, triangle: usize) -> [u32; 3] {
        self.made.triangulation.neighbours[triangle]
    }

    /// Whether all corners touch the same wall.
    pub fn along_one_wall(&self, cloud: &Cloud<2, 3>, triangle: usize) -> bool {
        let [a, b, c] = self.nodes(triangle).map(|node| cloud.contacts[node as usize]);
        !a.common(b).common(c).is_empty()
    }

    /// Whether the neighbour is fluid.
    pub fn fluid_across(&self, triangle: usize, corner: usize) -> bool {
        let neighbour = self.neighbours(triangle)[corner];
        neighbour != HULL && self.fluid[neighbour as usize]
    }

    /// Marks each of `nodes` nodes that belongs to a fluid triangle.
    pub fn mark_wet(&self, nodes: usize, wet: &mut Vec<bool>) {
        wet.clear();
        wet.resize(nodes, false);
        for triangle in (0..self.len()).filter(|&triangle| self.fluid[triangle]) {
            for node in self.nodes(triangle) {
                wet[node as usize] = true;
            }
        }
    }

    /// Number of fluid triangles.
    pub fn fluid_count(&self) -> usize {
        self.fluid.iter().filter(|&&fluid| fluid).count()
    }

    /// Number of triangles.
    pub fn len(&self) -> usize {
        self.made.triangulation.cells.len()
    }
}
