//! What a Krylov method needs to know of a matrix and of a preconditioner.

/// A square linear map; it need not be assembled.
///
/// Interior scratch of a matrix-free operator belongs behind a cell or a lock of its own.
pub trait LinearOperator {
    /// Number of unknowns n.
    fn size(&self) -> usize;

    /// y ← A x, both of length n; y comes in with any content.
    fn apply(&self, x: &[f64], y: &mut [f64]);
}

/// An approximate inverse M⁻¹ of an operator.
///
/// Linear, symmetric and positive definite for [`ConjugateGradient`](crate::ConjugateGradient); linear for
/// [`BiCgStab`](crate::BiCgStab); anything, an inner iteration too, for [`FlexibleGmres`](crate::FlexibleGmres).
pub trait Preconditioner {
    /// z ← M⁻¹ r, both of length n; z comes in with any content.
    fn apply(&mut self, r: &[f64], z: &mut [f64]);
}
