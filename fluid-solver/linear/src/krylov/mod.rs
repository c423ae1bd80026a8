//! Krylov methods: the iterate starts from the given x, the residual that decides is the true one, b − A x.

mod bicgstab;
mod cg;
mod fgmres;

pub use bicgstab::BiCgStab;
pub use cg::ConjugateGradient;
pub use fgmres::FlexibleGmres;

use crate::vector::{norm, update};
use crate::{Error, LinearOperator};
use std::fmt;

/// When to stop: ‖b − A x‖ ≤ max(relative · ‖b‖, absolute), or after so many iterations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stopping {
    /// Tolerance relative to ‖b‖.
    pub relative: f64,
    /// Tolerance in the units of b.
    pub absolute: f64,
    /// Largest number of iterations (products with A).
    pub iterations: usize,
}

impl Stopping {
    /// Stops at a residual relative to ‖b‖, without absolute floor.
    pub fn relative(relative: f64, iterations: usize) -> Self {
        Self { relative, absolute: 0.0, iterations }
    }
}

/// How a solve ended; x holds the last iterate in any case.
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use = "a solve may fail: look at the verdict, or call accept()"]
pub struct Outcome {
    /// Iterations done.
    pub iterations: usize,
    /// ‖b − A x‖ at the end: computed from x where converged or stagnated, by recurrence otherwise.
    pub residual_norm: f64,
    /// Reason of the stop.
    pub verdict: Verdict,
}

impl Outcome {
    /// The outcome if it converged.
    ///
    /// # Errors
    /// [`Error::NotConverged`] for every other verdict.
    pub fn accept(self) -> Result<Self, Error> {
        let Self { iterations, residual_norm, verdict } = self;
        match verdict {
            Verdict::Converged => Ok(self),
            _ => Err(Error::NotConverged { iterations, residual_norm, verdict }),
        }
    }
}

/// Reason for which an iteration stopped.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// The true residual is within the tolerance.
    Converged,
    /// The number of iterations is used up.
    IterationLimit,
    /// The recurrence says converged, the true residual does not, and going on did not lower it.
    Stagnated,
    /// A quantity that the method divides by vanished or has the wrong sign.
    Breakdown(&'static str),
    /// A NaN or an infinity appeared.
    NonFinite,
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Converged => "converged",
            Self::IterationLimit => "the iteration limit is reached; allow more or use a stronger preconditioner",
            Self::Stagnated => "rounding keeps the residual above the tolerance; ask for less, or see whether b lies in the range of a singular matrix",
            Self::Breakdown(reason) => reason,
            Self::NonFinite => "a NaN or an infinity appeared in b, x, the operator or the preconditioner",
        })
    }
}

/// Bookkeeping that the methods share.
struct Progress {
    tolerance: f64,
    limit: usize,
    iterations: usize,
    /// True residual norm when the recurrence last said converged; the next must be clearly lower to go on.
    confirmed: f64,
}

impl Progress {
    /// Computes the residual of the start and its norm; the outcome if there is nothing to iterate on.
    fn begin<A: LinearOperator + ?Sized>(
        a: &A,
        b: &[f64],
        x: &mut [f64],
        r: &mut [f64],
        stopping: Stopping,
    ) -> Result<(Self, f64), Outcome> {
        assert_eq!(b.len(), a.size(), "right-hand side");
        assert_eq!(x.len(), a.size(), "solution");
        let b_norm = norm(b);
        if b_norm == 0.0 {
            x.fill(0.0);
            return Err(Outcome { iterations: 0, residual_norm: 0.0, verdict: Verdict::Converged });
        }
        let tolerance = (stopping.relative * b_norm).max(stopping.absolute);
        let progress =
            Self { tolerance, limit: stopping.iterations, iterations: 0, confirmed: f64::INFINITY };
        let r_norm = if x.iter().all(|&x| x == 0.0) {
            r.copy_from_slice(b);
            b_norm
        } else {
            residual(a, b, x, r)
        };
        if !b_norm.is_finite() || !r_norm.is_finite() {
            return Err(progress.stop(r_norm, Verdict::NonFinite));
        }
        if r_norm <= tolerance {
            return Err(progress.stop(r_norm, Verdict::Converged));
        }
        Ok((progress, r_norm))
    }

    /// Recomputes the residual of an iterate whose recurrence says converged: the outcome, or go on from there.
    fn confirm<A: LinearOperator + ?Sized>(
        &mut self,
        a: &A,
        b: &[f64],
        x: &[f64],
        r: &mut [f64],
    ) -> Result<f64, Outcome> {
        self.judge(residual(a, b, x, r))
    }

    /// The outcome for a true residual that was expected to be lower, or go on from there.
    fn judge(&mut self, r_norm: f64) -> Result<f64, Outcome> {
        if !r_norm.is_finite() {
            Err(self.stop(r_norm, Verdict::NonFinite))
        } else if r_norm <= self.tolerance {
            Err(self.stop(r_norm, Verdict::Converged))
        } else if r_norm > 0.5 * self.confirmed {
            Err(self.stop(r_norm, Verdict::Stagnated))
        } else {
            self.confirmed = r_norm;
            Ok(r_norm)
        }
    }

    /// Counts an iteration unless the limit is reached.
    fn next(&mut self, r_norm: f64) -> Result<(), Outcome> {
        if self.iterations == self.limit {
            return Err(self.stop(r_norm, Verdict::IterationLimit));
        }
        self.iterations += 1;
        Ok(())
    }

    fn stop(&self, residual_norm: f64, verdict: Verdict) -> Outcome {
        Outcome { iterations: self.iterations, residual_norm, verdict }
    }

    /// The verdict on a divisor that is not what the method needs.
    fn fault(&self, divisor: f64, r_norm: f64, reason: &'static str) -> Outcome {
        let verdict = if divisor.is_finite() { Verdict::Breakdown(reason) } else { Verdict::NonFinite };
        self.stop(r_norm, verdict)
    }
}

/// r ← b − A x; returns ‖r‖.
fn residual<A: LinearOperator + ?Sized>(a: &A, b: &[f64], x: &[f64], r: &mut [f64]) -> f64 {
    a.apply(x, r);
    update(b, r, |b, ax| b - ax);
    norm(r)
}
