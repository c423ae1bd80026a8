//! Momentum: inertia, convection in conservative form with its orthogonal subscale, and viscous stress.

use super::{Average, PorousCell, velocity_gradient};
use crate::element::simplex::{Vector, dot};
use linear::dense::Block;

/// The mass that the P1 velocity a carries through a cell.
#[derive(Debug, Clone, Copy)]
pub struct MassFlux<const D: usize, const N: usize> {
    /// ⟨N_j ρ ε a⟩ (kg/(m² s)).
    nodal: [Vector<D>; N],
    /// ⟨ρ ε a⟩.
    mean: Vector<D>,
}

impl<const D: usize, const N: usize> MassFlux<D, N> {
    /// The flux at the density ρ (kg/m³) of a velocity (m/s) at the vertices.
    pub fn new(void_fraction: &Average<N>, density: f64, convecting: &[Vector<D>; N]) -> Self {
        let nodal = void_fraction.moments(convecting).map(|moment| moment.map(|value| density * value));
        Self { nodal, mean: std::array::from_fn(|k| nodal.iter().map(|part| part[k]).sum()) }
    }

    /// ρε a·∇u for a P1 velocity (Pa/m), taken at the mean of ρε a.
    pub fn convection(&self, gradients: &[Vector<D>; N], velocity: &[Vector<D>; N]) -> Vector<D> {
        velocity_gradient(gradients, velocity).map(|slope| dot(&self.mean, &slope))
    }
}

/// What the test function of one vertex meets in a cell.
#[derive(Debug, Clone, Copy)]
pub struct MomentumRow<'a, const D: usize, const N: usize> {
    cell: PorousCell<'a, D, N>,
    flux: &'a MassFlux<D, N>,
    i: usize,
    /// V a₀ρ.
    inertia: f64,
    /// V g_i.
    gradient: Vector<D>,
    /// V τ₁ ⟨ρεa⟩·g_i.
    stream: f64,
    /// V μ ⟨∇(ε N_i)⟩.
    viscous: Vector<D>,
}

impl<'a, const D: usize, const N: usize> MomentumRow<'a, D, N> {
    /// Row i of a cell convected by a flux, stabilised with τ₁; `inertia` is a₀ρ (kg/(m³ s)).
    pub fn new(
        cell: PorousCell<'a, D, N>,
        flux: &'a MassFlux<D, N>,
        i: usize,
        inertia: f64,
        viscosity: f64,
        relaxation_time: f64,
    ) -> Self {
        let g_i = &cell.gradients[i];
        Self {
            cell,
            flux,
            i,
            inertia: cell.volume * inertia,
            gradient: g_i.map(|slope| cell.volume * slope),
            stream: cell.volume * relaxation_time * dot(&flux.mean, g_i),
            viscous: cell.test_gradient(i).map(|slope| cell.volume * viscosity * slope),
        }
    }

    /// The block of u_j: (a₀ρε u, w) − (∇w, ρε u⊗a) + (ρε a·∇w, τ₁ ρε a·∇u) + (τ(u), ∇(ε w)).
    pub fn block(&self, j: usize) -> Block<D> {
        let (g_j, viscous) = (&self.cell.gradients[j], &self.viscous);
        let inertia = self.inertia * self.cell.void_fraction.second(self.i, j);
        let convection = -dot(&self.gradient, &self.flux.nodal[j]);
        let subscale = self.stream * dot(&self.flux.mean, g_j);
        let scalar = inertia + convection + subscale + dot(viscous, g_j);
        std::array::from_fn(|k| {
            std::array::from_fn(|l| {
                let diagonal = if k == l { scalar } else { 0.0 };
                diagonal + viscous[l] * g_j[k] - 2.0 / 3.0 * viscous[k] * g_j[l]
            })
        })
    }

    /// (ρε a·∇w, τ₁ π) for the cell mean of π.
    pub fn subscale(&self, projection: &Vector<D>) -> Vector<D> {
        projection.map(|value| self.stream * value)
    }
}

impl<const D: usize, const N: usize> PorousCell<'_, D, N> {
    /// ⟨∇(ε N_i)⟩ = ⟨ε⟩ g_i + ∇ε/N (1/m).
    pub fn test_gradient(&self, i: usize) -> Vector<D> {
        let (mean, slope) = (self.void_fraction.mean(), self.void_gradient());
        std::array::from_fn(|k| mean * self.gradients[i][k] + slope[k] / N as f64)
    }
}
