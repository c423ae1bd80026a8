//! Conjugate gradients.

use super::{Outcome, Progress, Stopping};
use crate::vector::{axpy, dot, norm, xpby};
use crate::{LinearOperator, Preconditioner};

/// Preconditioned conjugate gradients for symmetric positive definite A and M; holds scratch vectors only.
///
/// On a singular A (pure Neumann) b must lie in the range of A, and M must keep it there.
///
/// Source: Saad, *Iterative Methods for Sparse Linear Systems*, 2nd ed. 2003, algorithm 9.1.
#[derive(Debug, Clone, Default)]
pub struct ConjugateGradient {
    r: Vec<f64>,
    z: Vec<f64>,
    p: Vec<f64>,
    q: Vec<f64>,
}

impl ConjugateGradient {
    /// Scratch for n unknowns; it grows if a larger system comes.
    pub fn new(n: usize) -> Self {
        let mut scratch = Self::default();
        scratch.resize(n);
        scratch
    }

    fn resize(&mut self, n: usize) {
        for vector in [&mut self.r, &mut self.z, &mut self.p, &mut self.q] {
            vector.resize(n, 0.0);
        }
    }

    /// Improves x towards A x = b.
    pub fn solve<A, M>(&mut self, a: &A, m: &mut M, b: &[f64], x: &mut [f64], stopping: Stopping) -> Outcome
    where
        A: LinearOperator + ?Sized,
        M: Preconditioner + ?Sized,
    {
        self.resize(a.size());
        self.iterate(a, m, b, x, stopping).unwrap_or_else(|outcome| outcome)
    }

    fn iterate<A, M>(
        &mut self,
        a: &A,
        m: &mut M,
        b: &[f64],
        x: &mut [f64],
        stopping: Stopping,
    ) -> Result<Outcome, Outcome>
    where
        A: LinearOperator + ?Sized,
        M: Preconditioner + ?Sized,
    {
        let Self { r, z, p, q } = self;
        let (mut progress, mut r_norm) = Progress::begin(a, b, x, r, stopping)?;
        let mut rz_last = f64::INFINITY; // the first direction is the preconditioned residual alone: β = 0
        p.fill(0.0);
        loop {
            progress.next(r_norm)?;
            m.apply(r, z);
            let rz = dot(r, z);
            if !(rz > 0.0 && rz.is_finite()) {
                return Err(progress.fault(
                    rz,
                    r_norm,
                    "r·M⁻¹r ≤ 0: the preconditioner is not positive definite",
                ));
            }
            xpby(z, rz / rz_last, p);
            a.apply(p, q);
            let pq = dot(p, q);
            if !(pq > 0.0 && pq.is_finite()) {
                return Err(progress.fault(pq, r_norm, "p·Ap ≤ 0: the matrix is not positive definite"));
            }
            let alpha = rz / pq;
            axpy(alpha, p, x);
            axpy(-alpha, q, r);
            r_norm = norm(r);
            rz_last = rz;
            // A norm that is not finite must not be taken for a large one.
            if r_norm <= progress.tolerance || !r_norm.is_finite() {
                r_norm = progress.confirm(a, b, x, r)?;
                rz_last = f64::INFINITY;
            }
        }
    }
}
