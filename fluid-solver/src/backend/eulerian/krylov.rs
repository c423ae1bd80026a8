//! The system of a step as the Krylov method sees it: x = (increments of u, increments of p), all rows in N.

use super::matrices::{Matrices, Part, ProductScratch};
use crate::boundary::Constraints;
use crate::element::simplex::Vector;
use linear::{LinearOperator, dense, vector};
use std::cell::RefCell;

/// The product with the matrix of the free unknowns; continuity rows times `scale` (N s/m³).
pub struct StepOperator<'a, const D: usize> {
    pub matrices: &'a Matrices<D>,
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
        self.matrices.evaluate(part, self.measure, fields, rows, &mut self.scratch.borrow_mut());
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
pub fn remove_sum(measure: &[f64], r: &mut [f64]) {
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
