//! On which nodes of a mesh that moves a grain acts: those that it samples.

use crate::mesh::Mesh;
use crate::void_fraction::{Grain, NearestNode, SurfaceKernel, Weights};

/// The ways to spread grains.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Spreading {
    /// On all nodes around, by a kernel as wide as a grain or a cell.
    #[default]
    Kernel,
    /// On a node of its own.
    Nodal,
}

/// One of them, on a mesh.
pub enum Spread<const D: usize> {
    /// By a kernel.
    Kernel(SurfaceKernel<D>),
    /// On the nearest node.
    Nodal(NearestNode<D>),
}

impl<const D: usize> Spread<D> {
    /// On a mesh as it is now.
    pub fn new<const N: usize>(spreading: Spreading, mesh: &Mesh<D, N>) -> Self {
        match spreading {
            Spreading::Kernel => Self::Kernel(SurfaceKernel::new(mesh)),
            Spreading::Nodal => Self::Nodal(NearestNode::new(mesh)),
        }
    }

    /// Rebuilds the weights of all grains; `size` is the mesh size at a grain (m), none for a dry one, which gets no weights.
    pub fn weigh(
        &mut self,
        grains: &[Grain<D>],
        size: impl Fn(usize) -> Option<f64> + Sync,
        weights: &mut Weights,
    ) {
        match self {
            Self::Kernel(kernel) => {
                if (0..grains.len()).any(|grain| size(grain).is_some()) {
                    kernel.balance(mean_diameter(grains));
                }
                kernel.weigh(grains, size, weights);
            }
            Self::Nodal(nodes) => nodes.weigh(grains, size, weights),
        }
    }
}

/// Mean diameter, each by the volume of the grain (m).
fn mean_diameter<const D: usize>(grains: &[Grain<D>]) -> f64 {
    let moment = |power: usize| grains.iter().map(|grain| grain.diameter.powi(power as i32)).sum::<f64>();
    moment(D + 1) / moment(D)
}
