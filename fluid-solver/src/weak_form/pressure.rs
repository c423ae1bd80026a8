//! Pressure: gradient, divergence and the orthogonal subscale that lets both be of equal order.

use super::{PorousCell, share};
use crate::element::simplex::{Vector, dot};

/// A cell with the relaxation time of its pressure subscale.
#[derive(Debug, Clone, Copy)]
pub struct PressureCell<'a, const D: usize, const N: usize> {
    cell: PorousCell<'a, D, N>,
    void_gradient: Vector<D>,
    /// τ₁ V.
    weight: f64,
    /// τ₁ V ⟨ε²⟩.
    square: f64,
}

impl<'a, const D: usize, const N: usize> PressureCell<'a, D, N> {
    /// A cell stabilised with τ₁.
    pub fn new(cell: PorousCell<'a, D, N>, relaxation_time: f64) -> Self {
        let weight = relaxation_time * cell.volume;
        let square = weight * cell.void_fraction.square();
        Self { cell, void_gradient: cell.void_gradient(), weight, square }
    }

    /// ∫ N_j ∇(ε N_i): (p, ∇·(ε w)) for test function i and p_j, and (q, ∇·(ε u)) for test function j and u_i.
    pub fn gradient(&self, i: usize, j: usize) -> Vector<D> {
        let PorousCell { volume, gradients, void_fraction, .. } = &self.cell;
        let (first, pair) = (void_fraction.first(j), share::<N>(i, j));
        std::array::from_fn(|k| volume * (first * gradients[i][k] + pair * self.void_gradient[k]))
    }

    /// ∫ τ₁ N_a ε ∇N_j: what p_j brings to the weighted projection of ε∇p on node a.
    pub fn recovery(&self, a: usize, j: usize) -> Vector<D> {
        let factor = self.weight * self.cell.void_fraction.first(a);
        self.cell.gradients[j].map(|slope| factor * slope)
    }

    /// ∫ τ₁ N_a N_b.
    pub fn mass(&self, a: usize, b: usize) -> f64 {
        self.weight * share::<N>(a, b)
    }

    /// ∫ τ₁ N_a.
    pub fn lumped_mass(&self) -> f64 {
        self.weight / N as f64
    }

    /// (ε∇q, τ₁ ε∇p) for test function i and p_j.
    pub fn laplacian(&self, i: usize, j: usize) -> f64 {
        self.square * dot(&self.cell.gradients[i], &self.cell.gradients[j])
    }

    /// ∫ τ₁ N_a ε y for a constant y.
    pub fn recover(&self, a: usize, y: &Vector<D>) -> Vector<D> {
        let factor = self.weight * self.cell.void_fraction.first(a);
        y.map(|y| factor * y)
    }

    /// (ε∇q, τ₁ ε y) for test function i and a constant y.
    pub fn drive(&self, i: usize, y: &Vector<D>) -> f64 {
        self.square * dot(&self.cell.gradients[i], y)
    }
}
