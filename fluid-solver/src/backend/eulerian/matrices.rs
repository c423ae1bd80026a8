//! The linear system of a step: matrices, right-hand sides and their product with (u, p).
//!
//! ```text
//! momentum    A u − G p + d u − g                                              = f
//! continuity  E u + L p + Rᵀ(φ − Π),   Π = M⁻¹(R p − r + T φ),  φ = (d u − g)/|N_a|   = s
//! ```
//! G is ∫ N_j ∇(ε N_i) and E its transpose, both and L with what the grains give way ([`crate::grains::Compliance`]). Π is the τ₁-weighted lumped projection of y = ε(∇p − ρ(g + b)) + φ on the nodes; the last terms are (ε∇q, τ₁(y − Πy)).

use super::incidence::{Entries, for_each_row};
use crate::element::simplex::{Vector, dot};
use crate::grains::NodalDrag;
use crate::parallel::for_each_node;
use linear::dense::{self, Block};
use linear::{BlockCsr, Pattern};
use std::sync::Arc;

/// Which part of an affine map is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// Without constants: the map of increments.
    Linear,
    /// With constants.
    Affine,
}

/// What the subscale brings to the continuity of two nodes.
#[derive(Debug, Clone, Copy)]
pub struct Subscale<const D: usize> {
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

impl<const D: usize> Subscale<D> {
    const ZERO: Self = Self { projection: [0.0; D], laplacian: 0.0 };
}

impl<const D: usize> Recovery<D> {
    const ZERO: Self = Self { gradient: [0.0; D], mass: 0.0 };
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
    /// G_ij = ∫ N_j ∇(ε N_i) − ∫ r N_i ∇N_j by slot.
    gradient: Vec<Vector<D>>,
    /// E_ij = ∫ N_i ∇(ε N_j) − ∫ e N_j ∇N_i by slot.
    divergence: Vec<Vector<D>>,
    /// Rᵀ, L by slot.
    subscale: Vec<Subscale<D>>,
    /// R, T by slot.
    recovery: Vec<Recovery<D>>,
    /// Right-hand sides by row.
    pub right: Vec<Right<D>>,
    /// d, g.
    pub drag: NodalDrag<D>,
}

/// The entries of consecutive rows of all matrices.
pub struct RowEntries<'a, const D: usize> {
    pub momentum: &'a mut [Block<D>],
    pub gradient: &'a mut [Vector<D>],
    pub divergence: &'a mut [Vector<D>],
    pub subscale: &'a mut [Subscale<D>],
    pub recovery: &'a mut [Recovery<D>],
}

impl<const D: usize> RowEntries<'_, D> {
    /// Makes them zero.
    pub fn clear(&mut self) {
        self.momentum.fill([[0.0; D]; D]);
        self.gradient.fill([0.0; D]);
        self.divergence.fill([0.0; D]);
        self.subscale.fill(Subscale::ZERO);
        self.recovery.fill(Recovery::ZERO);
    }
}

impl<const D: usize> Entries for RowEntries<'_, D> {
    fn split(self, count: usize) -> (Self, Self) {
        let (momentum, momenta) = self.momentum.split(count);
        let (gradient, gradients) = self.gradient.split(count);
        let (divergence, divergences) = self.divergence.split(count);
        let (subscale, subscales) = self.subscale.split(count);
        let (recovery, recoveries) = self.recovery.split(count);
        (
            Self { momentum, gradient, divergence, subscale, recovery },
            Self {
                momentum: momenta,
                gradient: gradients,
                divergence: divergences,
                subscale: subscales,
                recovery: recoveries,
            },
        )
    }
}

/// Scratch of a product.
#[derive(Debug, Default)]
pub struct ProductScratch<const D: usize> {
    /// φ (Pa/m).
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
            gradient: vec![[0.0; D]; entries],
            divergence: vec![[0.0; D]; entries],
            subscale: vec![Subscale::ZERO; entries],
            recovery: vec![Recovery::ZERO; entries],
            right: vec![Right::ZERO; rows],
            drag: NodalDrag::default(),
            pattern,
        }
    }

    /// Calls `work(row, entries of the row, right-hand side of the row)` for every row.
    pub fn for_each_row(&mut self, work: impl Fn(usize, RowEntries<'_, D>, &mut Right<D>) + Sync) {
        let entries = RowEntries {
            momentum: self.momentum.blocks_mut(),
            gradient: &mut self.gradient,
            divergence: &mut self.divergence,
            subscale: &mut self.subscale,
            recovery: &mut self.recovery,
        };
        for_each_row(&self.pattern, entries, &mut self.right, work);
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
        let force = |i: usize| -> Vector<D> {
            std::array::from_fn(|k| resistance[i] * u[i][k] - affine * given[i][k])
        };
        for_each_node(drag, |i, drag| *drag = force(i).map(|force| force / measure[i]));

        for_each_node(subscale, |i, subscale| {
            let right = &self.right[i];
            let mut sum = right.recovered_weight.map(|weight| -affine * weight);
            for (&j, entry) in self.pattern.row(i).iter().zip(&self.recovery[self.pattern.slots(i)]) {
                let j = j as usize;
                for k in 0..D {
                    sum[k] += entry.gradient[k] * p[j] + entry.mass * drag[j][k];
                }
            }
            *subscale = std::array::from_fn(|k| drag[i][k] - sum[k] / right.recovery_mass);
        });

        for_each_node(momentum, |i, row| {
            let (columns, blocks) = self.momentum.row(i);
            let mut sum = force(i);
            for k in 0..D {
                sum[k] -= affine * self.right[i].force[k];
            }
            for ((&j, block), gradient) in
                columns.iter().zip(blocks).zip(&self.gradient[self.pattern.slots(i)])
            {
                let j = j as usize;
                dense::multiply_add(block, &u[j], &mut sum);
                for k in 0..D {
                    sum[k] -= gradient[k] * p[j];
                }
            }
            *row = sum;
        });

        for_each_node(continuity, |i, row| {
            let slots = self.pattern.slots(i);
            let entries = self.divergence[slots.clone()].iter().zip(&self.subscale[slots]);
            let mut sum = -affine * self.right[i].source;
            for (&j, (divergence, entry)) in self.pattern.row(i).iter().zip(entries) {
                let j = j as usize;
                sum += entry.laplacian * p[j];
                for k in 0..D {
                    sum += divergence[k] * u[j][k] + entry.projection[k] * subscale[j][k];
                }
            }
            *row = sum;
        });
    }

    /// Σ_j E_ij · u_j: the net outflow of a row (m³/s).
    pub fn divergence(&self, i: usize, u: &[Vector<D>]) -> f64 {
        let entries = self.pattern.row(i).iter().zip(&self.divergence[self.pattern.slots(i)]);
        entries.map(|(&j, divergence)| dot(divergence, &u[j as usize])).sum()
    }

    /// Σ_j G_ij p_j (N).
    pub fn gradient(&self, i: usize, p: &[f64]) -> Vector<D> {
        let mut sum = [0.0; D];
        for (&j, gradient) in self.pattern.row(i).iter().zip(&self.gradient[self.pattern.slots(i)]) {
            for k in 0..D {
                sum[k] += gradient[k] * p[j as usize];
            }
        }
        sum
    }

    /// Σ_j |G_ij p_j| + |f_i| by component: the size of the terms of a row (N).
    pub fn force_size(&self, i: usize, p: &[f64]) -> Vector<D> {
        let mut sizes = self.right[i].force.map(f64::abs);
        for (&j, gradient) in self.pattern.row(i).iter().zip(&self.gradient[self.pattern.slots(i)]) {
            for k in 0..D {
                sizes[k] += (gradient[k] * p[j as usize]).abs();
            }
        }
        sizes
    }
}
