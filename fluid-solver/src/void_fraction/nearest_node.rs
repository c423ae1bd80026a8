//! A grain on the one node that is nearest: on its own node, where the mesh has one for it.

use super::node_kernel::Grain;
use super::node_search::NodeSearch;
use super::weights::Weights;
use crate::element::simplex::{Vector, distance};
use crate::mesh::Mesh;

/// σ over the mesh size: the kernel of this width drags the fluid that a grain samples along as much as a force on a node
/// does the node, measured at spheres of Re 10 to 150 and discs of Re 460 that settle. In creeping flow that is 0.073 (2D) and
/// 0.155 (3D), and a grain's own disturbance larger than what is corrected.
const WIDTH: [f64; 2] = [0.2, 0.25];

/// Doublings of the radius of the search.
const DOUBLINGS: usize = 64;

/// Weights of one on the nearest node of a cell.
#[derive(Debug, Clone)]
pub struct NearestNode<const D: usize> {
    search: NodeSearch<D>,
    /// Whether a node is of a cell, in the order of the search.
    wet: Vec<bool>,
}

impl<const D: usize> NearestNode<D> {
    /// For the nodes of a mesh as they are now.
    pub fn new<const N: usize>(mesh: &Mesh<D, N>) -> Self {
        let search = NodeSearch::new(mesh);
        let wet = search.order().iter().map(|&node| mesh.measure()[node as usize] > 0.0).collect();
        Self { search, wet }
    }

    /// Rebuilds the weights of all grains; `size` is the mesh size at a grain (m), none for a dry one, which gets no weights.
    pub fn weigh(
        &self,
        grains: &[Grain<D>],
        size: impl Fn(usize) -> Option<f64> + Sync,
        weights: &mut Weights,
    ) {
        weights.rebuild(grains, |chunk, number, grain| {
            match size(number).and_then(|h| Some((h, self.nearest(&grain.position, h)?))) {
                None => chunk.close_row(0.0),
                Some((h, node)) => {
                    chunk.extend_row(&[node], |_| 1.0);
                    chunk.close_row(WIDTH[D - 2] * h);
                }
            }
        });
    }

    /// The nearest node of a cell, looked for from a radius on (m).
    fn nearest(&self, x: &Vector<D>, radius: f64) -> Option<u32> {
        (0..DOUBLINGS as i32).find_map(|doubling| {
            let radius = radius * f64::powi(2.0, doubling);
            let mut nearest: Option<(f64, u32)> = None;
            self.search.for_each_run(x, radius, |run, x| {
                for place in run.filter(|&place| self.wet[place]) {
                    let found = (distance(&self.search.positions()[place], x), self.search.order()[place]);
                    if found.0 <= radius && nearest.is_none_or(|nearest| found < nearest) {
                        nearest = Some(found);
                    }
                }
            });
            nearest.map(|(_, node)| node)
        })
    }
}
