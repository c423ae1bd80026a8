//! Stabilised bi-conjugate gradients.

use super::{Outcome, Progress, Stopping};
use crate::vector::{axpy, dot, norm, update, xpby};
use crate::{LinearOperator, Preconditioner};

/// Right-preconditioned BiCGStab for nonsymmetric A; holds scratch vectors only.
///
/// One iteration costs two products and two preconditionings. If r̂·r vanishes the method restarts with r̂ = r.
///
/// Source: van der Vorst, *SIAM J. Sci. Stat. Comput.* 13 (1992) 631; preconditioned as in Barrett et al., *Templates*, 1994.
#[derive(Debug, Clone, Default)]
pub struct BiCgStab {
    r: Vec<f64>,
    shadow: Vec<f64>,
    p: Vec<f64>,
    v: Vec<f64>,
    t: Vec<f64>,
    preconditioned: Vec<f64>,
}

impl BiCgStab {
    /// Scratch for n unknowns; it grows if a larger system comes.
    pub fn new(n: usize) -> Self {
        let mut scratch = Self::default();
        scratch.resize(n);
        scratch
    }

    fn resize(&mut self, n: usize) {
        let Self { r, shadow, p, v, t, preconditioned } = self;
        for vector in [r, shadow, p, v, t, preconditioned] {
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
        let Self { r, shadow, p, v, t, preconditioned } = self;
        let (mut progress, mut r_norm) = Progress::begin(a, b, x, r, stopping)?;
        let mut restart = true;
        let (mut rho_last, mut alpha, mut omega) = (1.0, 1.0, 1.0);
        loop {
            progress.next(r_norm)?;
            let mut rho = dot(shadow, r);
            if restart || rho.abs() <= f64::EPSILON * norm(shadow) * r_norm {
                shadow.copy_from_slice(r);
                p.copy_from_slice(r);
                rho = dot(shadow, r);
                restart = false;
            } else {
                let beta = (rho / rho_last) * (alpha / omega);
                axpy(-omega, v, p);
                xpby(r, beta, p);
            }
            m.apply(p, preconditioned);
            a.apply(preconditioned, v);
            let shadow_v = dot(shadow, v);
            alpha = rho / shadow_v;
            if !(alpha.is_finite() && shadow_v.is_finite()) {
                return Err(progress.fault(shadow_v, r_norm, "r̂·AM⁻¹p = 0: use FGMRES"));
            }
            axpy(alpha, preconditioned, x);
            axpy(-alpha, v, r);
            r_norm = norm(r);
            if r_norm <= progress.tolerance || !r_norm.is_finite() {
                r_norm = progress.confirm(a, b, x, r)?;
                restart = true;
                continue;
            }
            m.apply(r, preconditioned);
            a.apply(preconditioned, t);
            let tt = dot(t, t);
            omega = dot(t, r) / tt;
            if omega == 0.0 || !omega.is_finite() {
                let divisor = if tt.is_finite() { 0.0 } else { tt };
                return Err(progress.fault(divisor, r_norm, "the stabilising step is zero: use FGMRES"));
            }
            axpy(omega, preconditioned, x);
            update(t, r, |t, r| r - omega * t);
            r_norm = norm(r);
            rho_last = rho;
            if r_norm <= progress.tolerance || !r_norm.is_finite() {
                r_norm = progress.confirm(a, b, x, r)?;
                restart = true;
            }
        }
    }
}
