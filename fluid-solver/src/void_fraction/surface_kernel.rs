//! The node kernel in a fluid with a free surface, on nodes that move.

use super::node_kernel::{Grain, fill};
use super::node_search::NodeSearch;
use super::weights::Weights;
use crate::mesh::Mesh;
use rayon::prelude::*;

/// Weights `w_pa ∝ |N_a| (1 - r_a²/R²)³₊`, scaled to `Σ_a w_pa = 1`, R as in [`super::NodeKernel`].
///
/// No gains are balanced: that takes many sweeps over a mesh, and this one does not last. A grain whose kernel is cut by the
/// surface or a wall gives all of its volume to the nodes that are left.
#[derive(Debug, Clone)]
pub struct SurfaceKernel<const D: usize> {
    search: NodeSearch<D>,
    /// `|N_a|` in the order of the search: nodes of no cell have no weight.
    measure: Vec<f64>,
}

impl<const D: usize> SurfaceKernel<D> {
    /// For the nodes of a mesh as they are now.
    pub fn new<const N: usize>(mesh: &Mesh<D, N>) -> Self {
        let search = NodeSearch::new(mesh);
        let measure = search.order().iter().map(|&node| mesh.measure()[node as usize]).collect();
        Self { search, measure }
    }

    /// Rebuilds the weights of all grains; `size` is the mesh size at a grain (m), none for a dry one, which gets no weights.
    pub fn weigh(
        &self,
        grains: &[Grain<D>],
        size: impl Fn(usize) -> Option<f64> + Sync,
        weights: &mut Weights,
    ) {
        let chunks = weights.clear(grains.len()).par_iter_mut();
        chunks.zip(grains.par_chunks(Weights::GRAINS_PER_CHUNK)).enumerate().for_each(
            |(index, (chunk, grains))| {
                for (number, grain) in (index * Weights::GRAINS_PER_CHUNK..).zip(grains) {
                    match size(number) {
                        None => chunk.close_row(0.0),
                        Some(size) => {
                            let width = grain.diameter.max(size);
                            fill(&self.search, &self.measure, &grain.position, width, chunk);
                        }
                    }
                }
            },
        );
    }
}
