//! The linear system of a step: matrices, right-hand sides and their product with (u, p).
//!
//! ```text
//! momentum    A u − G p + d u − g                                              = f
//! continuity  E u + L p + Rᵀ(φ − Π),   Π = M⁻¹(R p − r + T φ),  φ = (d u − g)/|N_a|   = s
//! ```
//! G is ∫ N_j ∇(ε N_i) and E its transpose, both and L with what the grains give way ([`super::compliance`]). Π is the τ₁-weighted lumped projection of y = ε(∇p − ρ(g + b)) + φ on the nodes; the last terms are (ε∇q, τ₁(y − Πy)).

use super::exchange::{NodalDrag, Part};
use super::incidence::for_each_node;
use crate::element::simplex::Vector;
use linear::{BlockCsr, Pattern, dense};
use std::sync::Arc;

/// What couples pressure and velocity of two nodes.
#[derive(Debug, Clone, Copy)]
pub struct Coupling<const D: usize> {
    /// G_ij = ∫ N_j ∇(ε N_i) − ∫ r N_i ∇N_j.
    pub gradient: Vector<D>,
    /// E_ij = ∫ N_i ∇(ε N_j) − ∫ e N_j ∇N_i.
    pub divergence: Vector<D>,
    /// (Rᵀ)_ij = ∫ τ₁ N_j ε ∇N_i.
    pub projection: Vector<D>,
    /// L_ij = (ε∇N_i, τ₁ ε∇N_j) + (∇N_i, k ∇N_j).
    pub laplacian: f64,
}

/// What the projection needs of two nodes.
#[derive(Debug, Clone, Copy)]
pub struct Recovery<const D: usize> {
    /// R_ij = ∫ τ₁ N_i ε ∇N_j.
    pub gradient: Vector<D>,
    /// T_ij = ∫ τ₁ N_i N_j.
    pub mass: f64,
}

impl<const D: usize> Coupling<D> {
    pub(super) const ZERO: Self =
        Self { gradient: [0.0; D], divergence: [0.0; D], projection: [0.0; D], laplacian: 0.0 };
}

impl<const D: usize> Recovery<D> {
    pub(super) const ZERO: Self = Self { gradient: [0.0; D], mass: 0.0 };
}

/// Right-hand side of a row.
#[derive(Debug, Clone, Copy)]
pub struct Right<const D: usize> {
    /// f (N).
    pub force: Vector<D>,
    /// s (m³/s).
    pub source: f64,
    /// r = ∫ τ₁ N_a ε ρ(g + b).
    pub recovered_weight: Vector<D>,
    /// M_a = ∫ τ₁ N_a.
    pub recovery_mass: f64,
}

impl<const D: usize> Right<D> {
    pub(super) const ZERO: Self =
        Self { force: [0.0; D], source: 0.0, recovered_weight: [0.0; D], recovery_mass: 0.0 };
}

/// The system of a step.
pub struct Matrices<const D: usize> {
    /// The pattern of all.
    pub pattern: Arc<Pattern>,
    /// A.
    pub momentum: BlockCsr<D>,
    /// G, E, Rᵀ, L by slot.
    pub coupling: Vec<Coupling<D>>,
    /// R, T by slot.
    pub recovery: Vec<Recovery<D>>,
    /// Right-hand sides by row.
    pub right: Vec<Right<D>>,
    /// d, g.
    pub drag: NodalDrag<D>,
}

/// Scratch of a product.
#[derive(Debug, Default)]
pub struct ProductScratch<const D: usize> {
    /// Drag by nodes (N).
    drag: Vec<Vector<D>>,
    /// φ − Π (Pa/m).
    subscale: Vec<Vector<D>>,
}

impl<const D: usize> Matrices<D> {
    /// Zero matrices.
    pub fn zeros(pattern: Arc<Pattern>) -> Self {
        let (rows, entries) = (pattern.rows(), pattern.entries());
        Self {
            momentum: BlockCsr::zeros(pattern.clone()),
            coupling: vec![Coupling::ZERO; entries],
            recovery: vec![Recovery::ZERO; entries],
            right: vec![Right::ZERO; rows],
            drag: NodalDrag::default(),
            pattern,
        }
    }

    /// The linear part of the system at (u, p), or all of it: left less right-hand side.
    pub fn evaluate(
        &self,
        part: Part,
        measure: &[f64],
        (u, p): (&[Vector<D>], &[f64]),
        (momentum, continuity): (&mut [Vector<D>], &mut [f64]),
        ProductScratch { drag, subscale }: &mut ProductScratch<D>,
    ) {
        drag.resize(u.len(), [0.0; D]);
        subscale.resize(u.len(), [0.0; D]);
        let affine = if part == Part::Affine { 1.0 } else { 0.0 };
        let NodalDrag { resistance, given } = &self.drag;
        for (i, drag) in drag.iter_mut().enumerate() {
            *drag = std::array::from_fn(|k| resistance[i] * u[i][k] - affine * given[i][k]);
        }

        for_each_node(subscale, |i, subscale| {
            let right = &self.right[i];
            let mut sum = right.recovered_weight.map(|weight| -affine * weight);
            for (&j, entry) in self.pattern.row(i).iter().zip(&self.recovery[self.pattern.slots(i)]) {
                let j = j as usize;
                for k in 0..D {
                    sum[k] += entry.gradient[k] * p[j] + entry.mass * drag[j][k] / measure[j];
                }
            }
            *subscale = std::array::from_fn(|k| drag[i][k] / measure[i] - sum[k] / right.recovery_mass);
        });

        for_each_node(momentum, |i, row| {
            let (columns, blocks) = self.momentum.row(i);
            let mut sum: Vector<D> = std::array::from_fn(|k| drag[i][k] - affine * self.right[i].force[k]);
            for ((&j, block), entry) in columns.iter().zip(blocks).zip(&self.coupling[self.pattern.slots(i)])
            {
                let j = j as usize;
                dense::multiply_add(block, &u[j], &mut sum);
                for k in 0..D {
                    sum[k] -= entry.gradient[k] * p[j];
                }
            }
            *row = sum;
        });

        for_each_node(continuity, |i, row| {
            let mut sum = -affine * self.right[i].source;
            for (&j, entry) in self.pattern.row(i).iter().zip(&self.coupling[self.pattern.slots(i)]) {
                let j = j as usize;
                sum += entry.laplacian * p[j];
                for k in 0..D {
                    sum += entry.divergence[k] * u[j][k] + entry.projection[k] * subscale[j][k];
                }
            }
            *row = sum;
        });
    }

    /// Σ_j E_ij · u_j: the net outflow of a row (m³/s).
    pub fn divergence(&self, i: usize, u: &[Vector<D>]) -> f64 {
        let entries = self.pattern.row(i).iter().zip(&self.coupling[self.pattern.slots(i)]);
        entries.map(|(&j, entry)| (0..D).map(|k| entry.divergence[k] * u[j as usize][k]).sum::<f64>()).sum()
    }

    /// Σ_j G_ij p_j (N).
    pub fn gradient(&self, i: usize, p: &[f64]) -> Vector<D> {
        let mut sum = [0.0; D];
        for (&j, entry) in self.pattern.row(i).iter().zip(&self.coupling[self.pattern.slots(i)]) {
            for k in 0..D {
                sum[k] += entry.gradient[k] * p[j as usize];
            }
        }
        sum
    }
}
