//! Fields at the grains, by the weights of the last deposit.

use crate::void_fraction::Weights;
use rayon::prelude::*;

/// Samples a nodal field of `K` components at all grains, `f_p = Σ_a w_pa f_a`; zero at a grain outside the mesh.
///
/// Adjoint of [`crate::deposit::Deposit::apply`]: `Σ_p F_p · sample(u)_p = Σ_a deposit(F)_a · u_a`.
///
/// # Panics
/// If `samples` has not one row per grain.
pub fn sample<const K: usize>(weights: &Weights, field: &[[f64; K]], samples: &mut [[f64; K]]) {
    assert_eq!(samples.len(), weights.grains());
    weights.chunks().par_iter().zip(samples.par_chunks_mut(Weights::GRAINS_PER_CHUNK)).for_each(
        |(chunk, samples)| {
            for ((nodes, values), sample) in chunk.rows().zip(samples) {
                *sample = [0.0; K];
                for (&node, weight) in nodes.iter().zip(values) {
                    let nodal = &field[node as usize];
                    for k in 0..K {
                        sample[k] += weight * nodal[k];
                    }
                }
            }
        },
    );
}
