//! One level of the hierarchy: its matrix, its smoother, and the way to the next.

use super::{aggregation, product, prolongator, strength};
use crate::precondition::gauss_seidel::Diagonal;
use crate::{Csr, Error, Pattern};
use std::sync::Arc;

pub(super) struct Level {
    a: Csr,
    diagonal: Diagonal,
    strength: f64,
    strong: Vec<bool>,
    aggregate: Vec<u32>,
    p: Csr,
    /// R = Pᵀ, and the slot of P that each of its values comes from.
    r: Csr,
    source: Vec<u32>,
    ap: Csr,
    /// R A P.
    coarse: Csr,
}

impl Level {
    /// The level of a matrix; none if the next one would have hardly fewer unknowns.
    pub(super) fn coarsen(a: &Csr, strength: f64) -> Result<Option<Self>, Error> {
        let a = a.clone();
        let diagonal = Diagonal::new(&a)?;
        let strong = strength::strong_couplings(&a, &diagonal, strength);
        let (aggregate, count) = aggregation::aggregate(a.pattern(), &strong);
        if count == 0 || 10 * count > 9 * a.rows() {
            return Ok(None);
        }
        let p = Csr::zeros(Arc::new(prolongator::pattern(a.pattern(), &strong, &aggregate, count)));
        let (r_pattern, source) = p.pattern().transpose();
        let r = Csr::zeros(Arc::new(r_pattern));
        let ap = Csr::zeros(Arc::new(product::pattern(a.pattern(), p.pattern())?));
        let coarse = Csr::zeros(Arc::new(product::pattern(r.pattern(), ap.pattern())?));
        let mut level = Self { a, diagonal, strength, strong, aggregate, p, r, source, ap, coarse };
        level.fill();
        Ok(Some(level))
    }

    /// Takes new values; false if the strong couplings moved, so that the aggregates no longer fit.
    pub(super) fn refresh(&mut self, values: &[f64]) -> Result<bool, Error> {
        self.a.values_mut().copy_from_slice(values);
        self.diagonal.refresh(&self.a)?;
        if strength::strong_couplings(&self.a, &self.diagonal, self.strength) != self.strong {
            return Ok(false);
        }
        self.fill();
        Ok(true)
    }

    fn fill(&mut self) {
        prolongator::fill(&mut self.p, &self.a, &self.strong, &self.aggregate, &self.diagonal);
        for (r, &slot) in self.r.values_mut().iter_mut().zip(&self.source) {
            *r = self.p.values()[slot as usize];
        }
        product::multiply(&self.a, &self.p, &mut self.ap);
        product::multiply(&self.r, &self.ap, &mut self.coarse);
    }

    pub(super) fn pattern(&self) -> &Pattern {
        self.a.pattern()
    }

    pub(super) fn size(&self) -> usize {
        self.a.rows()
    }

    /// Matrix of the next level.
    pub(super) fn coarse(&self) -> &Csr {
        &self.coarse
    }

    /// x ← a forward sweep from zero; coarse_b ← R (b − A x).
    pub(super) fn smooth_and_restrict(
        &self,
        b: &[f64],
        x: &mut [f64],
        residual: &mut [f64],
        coarse_b: &mut [f64],
    ) {
        self.diagonal.forward_from_zero(&self.a, b, x);
        self.diagonal.residual_after_forward(&self.a, x, residual);
        self.r.multiply(residual, coarse_b);
    }

    /// x ← x + P x_coarse, then a backward sweep.
    pub(super) fn correct_and_smooth(&self, coarse_x: &[f64], b: &[f64], x: &mut [f64]) {
        self.p.multiply_add(coarse_x, x);
        self.diagonal.backward(&self.a, b, x);
    }
}
