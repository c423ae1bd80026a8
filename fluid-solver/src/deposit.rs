//! What the grains give to the nodes.

use crate::void_fraction::Weights;
use rayon::prelude::*;

/// Most lanes, and so most threads that work at a deposit.
const MOST_LANES: usize = 16;
/// Weights per node that pay for the summation of one more lane.
const WEIGHTS_PER_NODE_AND_LANE: usize = 4;
/// Nodes per chunk of the summation over lanes.
const NODES_PER_CHUNK: usize = 4096;

/// Spreads values of `K` components from grains to nodes; holds the memory this takes.
///
/// The grains are dealt to lanes, consecutive ones to the same lane; each lane sums in the order of its grains, and the
/// lanes are added in order. The number of lanes follows from the weights, not from the threads: so do the bits.
#[derive(Debug, Clone, Default)]
pub struct Deposit<const K: usize> {
    lanes: Vec<Vec<[f64; K]>>,
}

impl<const K: usize> Deposit<K> {
    /// `nodal_a = Σ_p w_pa F_p`; the sum over nodes is the sum over the grains in the mesh, to round-off.
    ///
    /// # Panics
    /// If `values` has not one row per grain, or a node is out of range.
    pub fn apply(&mut self, weights: &Weights, values: &[[f64; K]], nodal: &mut [[f64; K]]) {
        assert_eq!(values.len(), weights.grains());
        let worthwhile = weights.entries() / (WEIGHTS_PER_NODE_AND_LANE * nodal.len().max(1));
        let lanes = worthwhile.clamp(1, MOST_LANES);
        let chunks_per_lane = weights.chunks().len().div_ceil(lanes).max(1);
        self.lanes.resize_with(lanes - 1, Vec::new);
        let grains_per_lane = chunks_per_lane * Weights::GRAINS_PER_CHUNK;
        let scatter = |lane: usize, sums: &mut [[f64; K]]| {
            sums.fill([0.0; K]);
            let chunks = weights.chunks().iter().skip(lane * chunks_per_lane).take(chunks_per_lane);
            let values = values.iter().skip(lane * grains_per_lane);
            for ((nodes, row), value) in chunks.flat_map(|chunk| chunk.rows()).zip(values) {
                for (&node, weight) in nodes.iter().zip(row) {
                    let sum = &mut sums[node as usize];
                    for k in 0..K {
                        sum[k] += weight * value[k];
                    }
                }
            }
        };
        let count = nodal.len();
        rayon::join(
            || scatter(0, nodal),
            || {
                self.lanes.par_iter_mut().enumerate().for_each(|(lane, sums)| {
                    sums.resize(count, [0.0; K]);
                    scatter(lane + 1, sums);
                });
            },
        );
        let lanes = &self.lanes;
        nodal.par_chunks_mut(NODES_PER_CHUNK).enumerate().for_each(|(chunk, sums)| {
            let first = chunk * NODES_PER_CHUNK;
            for lane in lanes {
                for (sum, part) in sums.iter_mut().zip(&lane[first..]) {
                    for k in 0..K {
                        sum[k] += part[k];
                    }
                }
            }
        });
    }
}
