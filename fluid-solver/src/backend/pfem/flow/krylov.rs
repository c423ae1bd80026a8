//! The system of a pass as the Krylov method sees it: x = (increments of v, increments of p), all rows in N.

use super::chunks::for_each;
use super::constraint::Constraint;
use super::nodal::{Assembly, Fields, Part};
use super::suspended::Suspended;
use super::topology::Topology;
use super::wall_function::Friction;
use crate::element::simplex::Vector;
use linear::{LinearOperator, dense, vector};
use std::cell::RefCell;

/// The product with the matrix of the free unknowns; rows of volume times `scale` (N s/m³).
pub struct StepOperator<'a, const D: usize, const N: usize> {
    pub topology: &'a Topology<N>,
    pub constraints: &'a [Constraint<D>],
    /// ρ/(θΔt) (kg/(m³ s)).
    pub inertia: f64,
    /// 1/(κΔt) (1/(Pa s)).
    pub compressibility: f64,
    pub scale: f64,
    /// The grains, if any.
    pub grains: Option<Suspended<'a, D, N>>,
    /// That of walls.
    pub friction: &'a Friction<D>,
    pub scratch: RefCell<Scratch<'a, D, N>>,
}

/// What a product writes to.
pub struct Scratch<'a, const D: usize, const N: usize> {
    pub assembly: &'a mut Assembly<D, N>,
    pub excess: &'a mut [Vector<D>],
}

impl<const D: usize, const N: usize> LinearOperator for StepOperator<'_, D, N> {
    fn size(&self) -> usize {
        (D + 1) * self.constraints.len()
    }

    fn apply(&self, x: &[f64], y: &mut [f64]) {
        let ((v, p), (momentum, volume)) = (split(x), split_mut::<D>(y));
        self.rows(v, p, 0.0, momentum, volume);
        let (volumes, compressibility) = (&self.scratch.borrow().assembly.volumes, self.compressibility);
        for_each(volume, |node, row| *row += compressibility * volumes[node] * p[node]);
        self.restrict(momentum, volume);
    }
}

impl<const D: usize, const N: usize> StepOperator<'_, D, N> {
    /// What increments of velocity and pressure add to all rows but by compressibility, those of volume not scaled; `bulk` as
    /// [`Fields`] has it.
    pub fn rows(
        &self,
        v: &[Vector<D>],
        p: &[f64],
        bulk: f64,
        momentum: &mut [Vector<D>],
        volume: &mut [f64],
    ) {
        let Scratch { assembly, excess } = &mut *self.scratch.borrow_mut();
        let inertia = self.inertia;
        for_each(excess, |node, e| *e = v[node].map(|v| inertia * v));
        let (part, grains) = (Part::Linear, self.grains);
        let fields = Fields { velocity: v, pressure: p, excess, density: 0.0, bulk, part, grains };
        assembly.evaluate(self.topology, fields, 0.0, momentum, volume);
        self.friction.add_change(v, momentum);
    }

    /// Keeps the free rows and scales those of volume.
    pub fn restrict(&self, momentum: &mut [Vector<D>], volume: &mut [f64]) {
        let constraints = self.constraints;
        for_each(momentum, |node, row| *row = constraints[node].free(row));
        vector::scale(self.scale, volume);
    }
}

/// The two parts of a vector of unknowns or rows.
pub fn split<const D: usize>(x: &[f64]) -> (&[Vector<D>], &[f64]) {
    let (v, p) = x.split_at(x.len() / (D + 1) * D);
    (dense::by_node(v), p)
}

/// The two parts of a vector of unknowns or rows.
pub fn split_mut<const D: usize>(x: &mut [f64]) -> (&mut [Vector<D>], &mut [f64]) {
    let (v, p) = x.split_at_mut(x.len() / (D + 1) * D);
    (dense::by_node_mut(v), p)
}
