//! The system of a step as the Krylov method sees it: x = (increments of u, increments of p), all rows in N.

use super::exchange::{Exchange, Part};
use super::incidence::for_each_node;
use super::matrices::{Matrices, ProductScratch};
use super::schur::Schur;
use super::velocity_multigrid::VelocityMultigrid;
use super::velocity_sweep::VelocitySweep;
use crate::boundary::Constraints;
use crate::element::simplex::Vector;
use linear::{LinearOperator, Preconditioner, dense, vector};
use std::cell::RefCell;

/// The product with the matrix of the free unknowns; continuity rows times `scale` (N s/m³).
pub struct StepOperator<'a, const D: usize> {
    pub matrices: &'a Matrices<D>,
    pub exchange: &'a Exchange<D>,
    pub constraints: &'a Constraints<D>,
    pub measure: &'a [f64],
    pub scale: f64,
    /// The pressure has a free constant.
    pub enclosed: bool,
    pub scratch: RefCell<&'a mut ProductScratch<D>>,
}

impl<const D: usize> LinearOperator for StepOperator<'_, D> {
    fn size(&self) -> usize {
        (D + 1) * self.measure.len()
    }

    fn apply(&self, x: &[f64], y: &mut [f64]) {
        let ((u, p), (momentum, continuity)) = (split(x), split_mut::<D>(y));
        self.evaluate(Part::Linear, (u, p), (&mut *momentum, &mut *continuity));
        self.restrict(momentum, continuity);
    }
}

impl<const D: usize> StepOperator<'_, D> {
    /// All rows of the linear part at (u, p), or of left less right-hand side, unscaled.
    pub fn evaluate(&self, part: Part, fields: (&[Vector<D>], &[f64]), rows: (&mut [Vector<D>], &mut [f64])) {
        self.matrices.evaluate(part, self.exchange, self.measure, fields, rows, &mut self.scratch.borrow_mut());
    }

    /// Keeps the free rows; scales the rows of continuity and, where the fluid is enclosed, removes their sum.
    pub fn restrict(&self, momentum: &mut [Vector<D>], continuity: &mut [f64]) {
        self.constraints.project(momentum);
        if self.enclosed {
            remove_sum(self.measure, continuity);
        }
        vector::scale(self.scale, continuity);
    }
}

/// Subtracts from r the multiple of |N_a| that has its sum.
fn remove_sum(measure: &[f64], r: &mut [f64]) {
    let excess = vector::sum(r) / vector::sum(measure);
    vector::axpy(-excess, measure, r);
}

/// The two parts of a vector of unknowns or rows.
pub fn split<const D: usize>(x: &[f64]) -> (&[Vector<D>], &[f64]) {
    let (u, p) = x.split_at(x.len() / (D + 1) * D);
    (dense::by_node(u), p)
}

/// The two parts of a vector of unknowns or rows.
pub fn split_mut<const D: usize>(x: &mut [f64]) -> (&mut [Vector<D>], &mut [f64]) {
    let (u, p) = x.split_at_mut(x.len() / (D + 1) * D);
    (dense::by_node_mut(u), p)
}

/// What stands for the inverse of the velocity block.
pub enum VelocitySolver<'a, const D: usize> {
    /// Inertia prevails.
    Sweep(&'a VelocitySweep<D>),
    /// Viscosity prevails.
    Multigrid(&'a mut VelocityMultigrid),
}

/// An incomplete block factorisation.
///
/// Where inertia prevails u* = Â⁻¹ r_u, p = Ŝ⁻¹(r_p − Gᵀu*), u = u* + Δ⁻¹ G p, with Δ the lumped inertia and drag and
/// Ŝ ≈ GᵀΔ⁻¹G. Where viscosity does, p = Ŝ⁻¹ r_p, u = Â⁻¹(r_u + G p): no diagonal stands for a Laplacian there.
pub struct StepPreconditioner<'a, const D: usize> {
    pub matrices: &'a Matrices<D>,
    pub constraints: &'a Constraints<D>,
    pub velocity: VelocitySolver<'a, D>,
    pub schur: &'a mut Schur,
    /// (4/3) μ/(ε_a|N_a|).
    pub viscous: &'a [f64],
    /// Δ (kg/s).
    pub inertia: &'a [f64],
    pub measure: &'a [f64],
    pub scale: f64,
    pub enclosed: bool,
    /// Scratch.
    pub volumes: &'a mut Vec<f64>,
    /// Scratch.
    pub forces: &'a mut Vec<Vector<D>>,
}

impl<const D: usize> Preconditioner for StepPreconditioner<'_, D> {
    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        let ((r_u, r_p), (u, p)) = (split::<D>(r), split_mut::<D>(z));
        match self.velocity {
            VelocitySolver::Sweep(sweep) => {
                sweep.apply(&self.matrices.momentum, r_u, u);
                self.solve_pressure(r_p, Some(u), p);
                let (matrices, inertia) = (self.matrices, self.inertia);
                for_each_node(u, |i, u| {
                    let force = matrices.gradient(i, p);
                    for k in 0..D {
                        u[k] += force[k] / inertia[i];
                    }
                });
                self.constraints.project(u);
            }
            VelocitySolver::Multigrid(_) => {
                self.solve_pressure(r_p, None, p);
                let matrices = self.matrices;
                self.forces.resize(r_u.len(), [0.0; D]);
                for_each_node(self.forces, |i, force| {
                    let gradient = matrices.gradient(i, p);
                    *force = std::array::from_fn(|k| r_u[i][k] + gradient[k]);
                });
                if let VelocitySolver::Multigrid(multigrid) = &mut self.velocity {
                    multigrid.apply(self.constraints, self.forces, u);
                }
            }
        }
    }
}

impl<const D: usize> StepPreconditioner<'_, D> {
    /// p ← Ŝ⁻¹(r_p − Gᵀu).
    fn solve_pressure(&mut self, r_p: &[f64], u: Option<&[Vector<D>]>, p: &mut [f64]) {
        let (matrices, scale) = (self.matrices, self.scale);
        self.volumes.resize(r_p.len(), 0.0);
        for_each_node(self.volumes, |i, value| {
            *value = r_p[i] / scale - u.map_or(0.0, |u| matrices.divergence(i, u));
        });
        if self.enclosed {
            remove_sum(self.measure, self.volumes);
        }
        self.schur.apply(self.viscous, self.volumes, p);
        if self.enclosed {
            let mean = vector::dot(p, self.measure) / vector::sum(self.measure);
            p.iter_mut().for_each(|p| *p -= mean);
        }
    }
}
