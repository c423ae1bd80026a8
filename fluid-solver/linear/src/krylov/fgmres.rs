//! Flexible GMRES.

use super::{Outcome, Progress, Stopping, residual};
use crate::vector::{axpy, dot, norm, scale};
use crate::{LinearOperator, Preconditioner};

/// Restarted flexible GMRES, right-preconditioned: A may be anything, M may change from one application to the next;
/// holds scratch only.
///
/// AZ = VH with V orthonormal by modified Gram–Schmidt, done twice where the first pass cancels; x + Zy minimises
/// ‖b − Ax‖ over the cycle. The two bases grow as far as the iteration needs them.
///
/// Source: Saad, *SIAM J. Sci. Comput.* 14 (1993) 461; Daniel, Gragg, Kaufman and Stewart, *Math. Comp.* 30 (1976) 772.
#[derive(Debug, Clone)]
pub struct FlexibleGmres {
    restart: usize,
    v: Vec<Vec<f64>>,
    z: Vec<Vec<f64>>,
    /// Upper triangle of H after rotation, by columns.
    h: Vec<Vec<f64>>,
    rotation: Vec<[f64; 2]>,
    /// Rotated right-hand side, then the coefficients y.
    g: Vec<f64>,
}

impl FlexibleGmres {
    /// Scratch for cycles of `restart` iterations (at least one) on n unknowns; it grows if a larger system comes.
    pub fn new(n: usize, restart: usize) -> Self {
        let restart = restart.max(1);
        let column = |k| vec![0.0; k + 2];
        Self {
            restart,
            v: vec![vec![0.0; n]],
            z: Vec::new(),
            h: (0..restart).map(column).collect(),
            rotation: vec![[1.0, 0.0]; restart],
            g: vec![0.0; restart + 1],
        }
    }

    /// Improves x towards A x = b.
    pub fn solve<A, M>(&mut self, a: &A, m: &mut M, b: &[f64], x: &mut [f64], stopping: Stopping) -> Outcome
    where
        A: LinearOperator + ?Sized,
        M: Preconditioner + ?Sized,
    {
        for vector in self.v.iter_mut().chain(&mut self.z) {
            vector.resize(a.size(), 0.0);
        }
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
        let (mut progress, mut r_norm) = Progress::begin(a, b, x, &mut self.v[0], stopping)?;
        loop {
            let (steps, stop) = self.cycle(a, m, r_norm, &mut progress);
            let estimate = self.g[steps].abs();
            self.correct(x, steps);
            if let Some(outcome) = stop {
                return Err(outcome);
            }
            r_norm = residual(a, b, x, &mut self.v[0]);
            // Far from convergence the estimate is the residual; where it is not, rounding has taken over.
            let in_progress = estimate > progress.tolerance && r_norm > progress.tolerance;
            let estimate_holds = r_norm <= 10.0 * estimate;
            if !(in_progress && estimate_holds) {
                progress.judge(r_norm)?;
            }
        }
    }

    /// Builds the bases from the residual in `v[0]`; how many steps are good, and the outcome if the method must stop.
    fn cycle<A, M>(
        &mut self,
        a: &A,
        m: &mut M,
        r_norm: f64,
        progress: &mut Progress,
    ) -> (usize, Option<Outcome>)
    where
        A: LinearOperator + ?Sized,
        M: Preconditioner + ?Sized,
    {
        scale(1.0 / r_norm, &mut self.v[0]);
        self.g[0] = r_norm;
        for k in 0..self.restart {
            let estimate = self.g[k].abs();
            if estimate <= progress.tolerance {
                return (k, None);
            }
            if let Err(outcome) = progress.next(estimate) {
                return (k, Some(outcome));
            }
            self.extend(a, m, k);
            let pivot = self.rotate(k);
            if !(pivot > 0.0 && pivot.is_finite()) {
                let reason = "A M⁻¹ is singular on the Krylov space";
                return (k, Some(progress.fault(pivot, estimate, reason)));
            }
        }
        (self.restart, None)
    }

    /// z_k = M⁻¹ v_k; v_{k+1} is A z_k made orthonormal, with the coefficients in column k of H.
    fn extend<A, M>(&mut self, a: &A, m: &mut M, k: usize)
    where
        A: LinearOperator + ?Sized,
        M: Preconditioner + ?Sized,
    {
        let n = a.size();
        self.z.resize_with(self.z.len().max(k + 1), || vec![0.0; n]);
        self.v.resize_with(self.v.len().max(k + 2), || vec![0.0; n]);
        m.apply(&self.v[k], &mut self.z[k]);
        let (basis, rest) = self.v.split_at_mut(k + 1);
        let w = &mut rest[0];
        a.apply(&self.z[k], w);

        let column = &mut self.h[k];
        column.fill(0.0);
        let before = norm(w);
        let mut after = orthogonalise(basis, w, column);
        if after < std::f64::consts::FRAC_1_SQRT_2 * before {
            after = orthogonalise(basis, w, column);
        }
        // What is left after cancellation to rounding level has no direction: the space is exhausted.
        if after <= f64::EPSILON * before {
            after = 0.0;
        } else {
            scale(1.0 / after, w);
        }
        column[k + 1] = after;
    }

    /// Makes column k of H upper triangular by Givens rotations; returns its new diagonal.
    fn rotate(&mut self, k: usize) -> f64 {
        let column = &mut self.h[k];
        for (j, &[c, s]) in self.rotation[..k].iter().enumerate() {
            (column[j], column[j + 1]) =
                (c * column[j] + s * column[j + 1], c * column[j + 1] - s * column[j]);
        }
        let pivot = column[k].hypot(column[k + 1]);
        let [c, s] = [column[k] / pivot, column[k + 1] / pivot];
        column[k] = pivot;
        self.rotation[k] = [c, s];
        (self.g[k], self.g[k + 1]) = (c * self.g[k], -s * self.g[k]);
        pivot
    }

    /// x ← x + Z y with H y = g.
    fn correct(&mut self, x: &mut [f64], steps: usize) {
        for k in (0..steps).rev() {
            self.g[k] /= self.h[k][k];
            for j in 0..k {
                self.g[j] -= self.h[k][j] * self.g[k];
            }
            axpy(self.g[k], &self.z[k], x);
        }
    }
}

/// Removes from w its components along the basis and adds them to the coefficients; returns ‖w‖.
fn orthogonalise(basis: &[Vec<f64>], w: &mut [f64], coefficients: &mut [f64]) -> f64 {
    for (v, coefficient) in basis.iter().zip(coefficients) {
        let component = dot(v, w);
        *coefficient += component;
        axpy(-component, v, w);
    }
    norm(w)
}
