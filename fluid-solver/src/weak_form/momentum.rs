//! Momentum: inertia, convection in conservative form with its orthogonal subscale, and viscous stress.

use super::{PorousCell, velocity_gradient, viscous_stress};
use crate::element::simplex::{Vector, dot};
use linear::dense::Block;

/// A cell with what moves the momentum through it.
#[derive(Debug, Clone, Copy)]
pub struct MomentumCell<'a, const D: usize, const N: usize> {
    cell: PorousCell<'a, D, N>,
    density: f64,
    viscosity: f64,
    relaxation_time: f64,
    /// ⟨N_j ρ ε a⟩ (kg/(m² s)).
    flux: [Vector<D>; N],
    /// ⟨ρ ε a⟩.
    mean_flux: Vector<D>,
}

impl<'a, const D: usize, const N: usize> MomentumCell<'a, D, N> {
    /// A cell convected by the P1 velocity a (m/s), stabilised with τ₁.
    pub fn new(
        cell: PorousCell<'a, D, N>,
        density: f64,
        viscosity: f64,
        convecting: &[Vector<D>; N],
        relaxation_time: f64,
    ) -> Self {
        let void = &cell.void_fraction;
        let flux: [Vector<D>; N] = std::array::from_fn(|j| {
            std::array::from_fn(|k| {
                density * (0..N).map(|b| void.second(b, j) * convecting[b][k]).sum::<f64>()
            })
        });
        let mean_flux = std::array::from_fn(|k| flux.iter().map(|part| part[k]).sum());
        Self { cell, density, viscosity, relaxation_time, flux, mean_flux }
    }

    /// The block of test function i and unknown u_j:
    /// (a₀ρε u, w) − (∇w, ρε u⊗a) + (ρε a·∇w, τ₁ ρε a·∇u) + (τ(u), ∇(ε w)).
    pub fn block(&self, rate: f64, i: usize, j: usize) -> Block<D> {
        let PorousCell { volume, gradients, void_fraction, .. } = self.cell;
        let [g_i, g_j] = [&gradients[i], &gradients[j]];
        let inertia = rate * self.density * void_fraction.second(i, j);
        let convection = -dot(g_i, &self.flux[j]);
        let subscale = self.relaxation_time * dot(&self.mean_flux, g_i) * dot(&self.mean_flux, g_j);
        let c_i = self.cell.test_gradient(i);
        let scalar = inertia + convection + subscale + self.viscosity * dot(&c_i, g_j);
        std::array::from_fn(|k| {
            std::array::from_fn(|l| {
                let diagonal = if k == l { scalar } else { 0.0 };
                let coupled = self.viscosity * (c_i[l] * g_j[k] - 2.0 / 3.0 * c_i[k] * g_j[l]);
                volume * (diagonal + coupled)
            })
        })
    }

    /// ρε a·∇u for a P1 velocity (Pa/m), taken at the mean of ρε a.
    pub fn convection(&self, velocity: &[Vector<D>; N]) -> Vector<D> {
        velocity_gradient(self.cell.gradients, velocity).map(|slope| dot(&self.mean_flux, &slope))
    }

    /// (ρε a·∇w, τ₁ π) for test function i and the cell mean of π.
    pub fn subscale(&self, i: usize, projection: &Vector<D>) -> Vector<D> {
        let factor = self.cell.volume * self.relaxation_time * dot(&self.mean_flux, &self.cell.gradients[i]);
        projection.map(|value| factor * value)
    }
}

impl<const D: usize, const N: usize> PorousCell<'_, D, N> {
    /// ⟨∇(ε N_i)⟩ = ⟨ε⟩ g_i + ∇ε/N (1/m).
    pub fn test_gradient(&self, i: usize) -> Vector<D> {
        let (mean, slope) = (self.void_fraction.mean(), self.void_gradient());
        std::array::from_fn(|k| mean * self.gradients[i][k] + slope[k] / N as f64)
    }

    /// ∫ τ(u) dV of a P1 velocity (Pa m³).
    pub fn stress(&self, viscosity: f64, velocity: &[Vector<D>; N]) -> [Vector<D>; D] {
        let stress = viscous_stress(viscosity, &velocity_gradient(self.gradients, velocity));
        stress.map(|row| row.map(|value| self.volume * value))
    }
}
