//! Weak forms of flow through a void fraction on linear simplices: what one cell or one boundary face adds to a row.
//!
//! Velocity u, pressure p and void fraction ε are P1. All integrals are exact, in closed form: nothing here is
//! quadrature, so that u = 0 with a linear p is a solution for any ε, jumps included.

mod average;
mod facet;
mod momentum;
mod pressure;
mod stabilisation;

pub use average::{Average, share};
pub use facet::Facet;
pub use momentum::{MassFlux, MomentumRow};
pub use pressure::PressureCell;
pub use stabilisation::{Resistance, relaxation_time};

use crate::element::simplex::Vector;
use crate::mesh::Mesh;

/// Geometry of a cell and the void fraction in it.
#[derive(Debug, Clone, Copy)]
pub struct PorousCell<'a, const D: usize, const N: usize> {
    /// Volume V (m³; m² in 2D).
    pub volume: f64,
    /// Gradients g_i of the shape functions (1/m).
    pub gradients: &'a [Vector<D>; N],
    /// Void fraction ε (-).
    pub void_fraction: Average<N>,
}

impl<'a, const D: usize, const N: usize> PorousCell<'a, D, N> {
    /// A cell of a mesh whose nodes, and those of the nodal void fraction, are `nodes`.
    pub fn new(mesh: &'a Mesh<D, N>, cell: usize, nodes: &[u32; N], void_fraction: &[f64]) -> Self {
        Self {
            volume: mesh.volumes()[cell],
            gradients: &mesh.gradients()[cell],
            void_fraction: Average::new(nodes.map(|node| void_fraction[node as usize])),
        }
    }

    /// ∇ε (1/m).
    pub fn void_gradient(&self) -> Vector<D> {
        gradient(self.gradients, &self.void_fraction.values)
    }
}

/// ∇f = Σ_i f_i g_i of a P1 field.
pub fn gradient<const D: usize, const N: usize>(gradients: &[Vector<D>; N], values: &[f64; N]) -> Vector<D> {
    std::array::from_fn(|k| (0..N).map(|i| values[i] * gradients[i][k]).sum())
}

/// (∇u)_km = ∂u_k/∂x_m of a P1 vector field.
pub fn velocity_gradient<const D: usize, const N: usize>(
    gradients: &[Vector<D>; N],
    values: &[Vector<D>; N],
) -> [Vector<D>; D] {
    std::array::from_fn(|k| gradient(gradients, &values.map(|u| u[k])))
}

/// τ = μ(∇u + ∇uᵀ − ⅔ ∇·u I) (Pa).
///
/// The plane is a slab in plane strain, so the factor is ⅔ in 2D too.
pub fn viscous_stress<const D: usize>(viscosity: f64, slope: &[Vector<D>; D]) -> [Vector<D>; D] {
    let divergence: f64 = (0..D).map(|k| slope[k][k]).sum();
    std::array::from_fn(|k| {
        std::array::from_fn(|m| {
            let isotropic = if k == m { 2.0 / 3.0 * divergence } else { 0.0 };
            viscosity * (slope[k][m] + slope[m][k] - isotropic)
        })
    })
}

/// γ̇ = √(½E:E) (1/s), E = ∇u + ∇uᵀ − ⅔∇·u I, in the plane with its entry across it, which is what the trace lacks.
pub fn shear_rate<const D: usize>(slope: &[Vector<D>; D]) -> f64 {
    let strain_rate = viscous_stress(1.0, slope);
    let trace: f64 = (0..D).map(|k| strain_rate[k][k]).sum();
    let within: f64 = strain_rate.as_flattened().iter().map(|entry| entry * entry).sum();
    (0.5 * (within + trace * trace)).sqrt()
}
