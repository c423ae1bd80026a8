//! Grains as a volume fraction on the mesh.
//!
//! Every grain `p` has weights `w_pa` on the nodes around, `Σ_a w_pa = 1`. The same weights spread its volume and its
//! forces and sample the fields it feels.

mod balance;
mod error;
mod nearest_node;
mod node_kernel;
mod node_search;
mod surface_kernel;
mod weights;

pub use error::VoidFractionError;
pub use nearest_node::NearestNode;
pub use node_kernel::{Grain, NodeKernel};
pub use surface_kernel::SurfaceKernel;
pub use weights::Weights;

use crate::deposit::Deposit;

/// Void fraction of the nodes, `ε_a = 1 - Σ_p V_p w_pa / |N_a|`.
///
/// Then `Σ_a |N_a| (1 - ε_a) = Σ_p V_p` to round-off, over the grains that have a host.
/// `volumes` in the unit of `measure`: m³, in 2D m² (volume per depth of the slab).
///
/// # Errors
/// A void fraction below `floor` (or not a number): the lowest is reported, nothing is clipped.
///
/// # Panics
/// If the lengths do not match.
pub fn void_fraction(
    weights: &Weights,
    volumes: &[f64],
    measure: &[f64],
    floor: f64,
    deposit: &mut Deposit<1>,
    void_fraction: &mut [f64],
) -> Result<(), VoidFractionError> {
    assert_eq!(void_fraction.len(), measure.len());
    deposit.apply(weights, volumes.as_chunks().0, void_fraction.as_chunks_mut().0);
    for (value, measure) in void_fraction.iter_mut().zip(measure) {
        // A node of no cell has no measure and no grain.
        *value = if *measure == 0.0 { 1.0 } else { 1.0 - *value / measure };
    }
    let below =
        void_fraction.iter().copied().enumerate().filter(|(_, value)| value.is_nan() || *value < floor);
    match below.min_by(|a, b| a.1.total_cmp(&b.1)) {
        None => Ok(()),
        Some((node, value)) => Err(VoidFractionError::BelowFloor { node, value, floor }),
    }
}

/// Share of a grain's own volume in the solid fraction it samples, `φ_own = V_p Σ_a w_pa² / |N_a|`.
pub fn own_share(weights: &Weights, grain: usize, volume: f64, measure: &[f64]) -> f64 {
    let (nodes, values) = weights.row(grain);
    volume * nodes.iter().zip(values).map(|(&node, w)| w * w / measure[node as usize]).sum::<f64>()
}
