//! Where grains are in the fluid: their weights on the nodes, and how much of them is wet.

mod fixed_mesh;
mod free_surface;
mod spread;
mod wetted;

pub use fixed_mesh::FixedMesh;
pub use free_surface::{FREE_SURFACE, FreeSurface};
pub use spread::Spreading;
pub use wetted::ball_volume;

use crate::mesh::Mesh;
use crate::void_fraction::{Grain, VoidFractionError, Weights};

/// Places grains in a mesh.
pub trait Placing<const D: usize, const N: usize> {
    /// Rebuilds the weights of every grain, Σ_a w_pa = 1 or none, and its wetted fraction: the share of its volume that is in
    /// the fluid, 0 to 1.
    ///
    /// # Errors
    /// A position that is not finite, a diameter that was not expected.
    fn place(
        &mut self,
        mesh: &Mesh<D, N>,
        grains: &[Grain<D>],
        weights: &mut Weights,
        wetted: &mut Vec<f64>,
    ) -> Result<(), VoidFractionError>;
}
