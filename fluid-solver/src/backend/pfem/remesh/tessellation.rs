//! Triangles between all nodes of the mesh, void included.

use super::draft::{Draft, NONE};
use crate::backend::pfem::cloud::Cloud;
use crate::element::simplex::Vector;
use delaunay::constrained::Constrained;
use delaunay::{HULL, Triangulation};
use spade::{DelaunayTriangulation, HasPosition, Point2, Triangulation as _};

/// The triangles; a point is a node that is no drop.
#[derive(Clone, Debug, Default)]
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
    plain: Triangulation<3>,
}

struct Numbered(Vector<2>, u32);

impl HasPosition for Numbered {
    type Scalar = f64;
    fn position(&self) -> Point2<f64> {
        Point2::new(self.0[0], self.0[1])
    }
}

impl Tessellation {
    /// Triangulates the nodes that are no drops and not to go; of nodes at the same place one stays.
    pub fn triangulate(&mut self, cloud: &mut Cloud<2, 3>, draft: &mut Draft) {
        self.triangulate_distinct(cloud, draft);
        if self.made.misses_points() {
            draft.unite_coincident(cloud);
            self.triangulate_distinct(cloud, draft);
        }
    }

    fn triangulate_distinct(&mut self, cloud: &Cloud<2, 3>, draft: &Draft) {
        self.points.clear();
        self.node_of.clear();
        self.point_of.clear();
        for (node, place) in cloud.place.iter().enumerate() {
            let meshed = cloud.drop[node] == 0.0 && !draft.removed[node];
            self.point_of.push(if meshed { self.points.len() as u32 } else { NONE });
            if meshed {
                self.points.push(*place);
                self.node_of.push(node as u32);
            }
        }
        let numbered = self.points.iter().enumerate().map(|(k, x)| Numbered(*x, k as u32)).collect();
        let spade = DelaunayTriangulation::<Numbered>::bulk_load(numbered).unwrap_or_default();
        self.plain.cells.clear();
        self.plain.neighbours.clear();
        for face in spade.inner_faces() {
            self.plain.cells.push(face.vertices().map(|v| v.data().1));
            let across = face
                .adjacent_edges()
                .map(|e| e.rev().face().as_inner().map_or(HULL, |f| f.fix().index() as u32 - 1));
            // Edge k runs from corner k to the next, opposite to the one after that.
            self.plain.neighbours.push([across[1], across[2], across[0]]);
        }
        self.made.start(&self.plain, self.points.len());
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

    /// Whether the neighbour is fluid.
    pub fn fluid_across(&self, triangle: usize, corner: usize) -> bool {
        let neighbour = self.neighbours(triangle)[corner];
        neighbour != HULL && self.fluid[neighbour as usize]
    }

    /// For each of `nodes` nodes whether it belongs to a fluid triangle.
    pub fn wet(&self, nodes: usize) -> Vec<bool> {
        let mut wet = vec![false; nodes];
        for triangle in (0..self.len()).filter(|&triangle| self.fluid[triangle]) {
            for node in self.nodes(triangle) {
                wet[node as usize] = true;
            }
        }
        wet
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
