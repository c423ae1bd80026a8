//! How the grains give way inside a step.
//!
//! A grain has felt u′ and p′ for the step Δt. Had it felt u and p, it would have kept the impulse
//! I = Δt [β_e (u − u′) − (V − R) ∇(p − p′)] more, so its velocity would be I/m another, and of the force on it the part
//! −R ∇(p − p′) would have gone on to the fluid. The equations of the step hold both, to first order in the differences:
//!
//! ```text
//! momentum    ε∇p + r ∇(p − p′) + …                                  r = Σ w R/|N_a|
//! continuity  D_t ε + ∇·(εu) + ∇·(e (u − u′) − k ∇(p − p′)) = 0      e = a₀Δt Σ w V β_e Δt/m /|N_a|
//!                                                                    k = a₀Δt Σ w V (V − R) Δt/m /|N_a|
//! ```
//! Without them one pass per step leaves the answer of the grains to the next step, and a bed in a closed vessel is
//! unstable. They vanish where nothing changes and where the iterations of a step have converged.

use crate::element::simplex::{Vector, dot};
use crate::weak_form::{Average, PorousCell};

/// Coefficients at a node.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Compliance {
    /// r (-).
    pub relayed: f64,
    /// e (-).
    pub entrained: f64,
    /// k (m³ s/kg).
    pub pressed: f64,
}

/// The coefficients at all nodes and the fields that the grains have felt.
#[derive(Debug, Clone, Copy)]
pub struct Given<'a, const D: usize> {
    /// At the nodes; empty if no grain acts.
    pub compliance: &'a [Compliance],
    /// u′ (m/s).
    pub velocity: &'a [Vector<D>],
    /// p′ (Pa).
    pub pressure: &'a [f64],
}

/// The coefficients in a cell.
#[derive(Debug, Clone, Copy)]
pub struct CompliantCell<'a, const D: usize, const N: usize> {
    cell: PorousCell<'a, D, N>,
    relayed: Average<N>,
    entrained: Average<N>,
    /// V ⟨k⟩.
    pressed: f64,
}

impl<'a, const D: usize, const N: usize> CompliantCell<'a, D, N> {
    /// A cell with these coefficients at its nodes.
    pub fn new(cell: PorousCell<'a, D, N>, nodal: &[Compliance; N]) -> Self {
        let pressed = nodal.iter().map(|c| c.pressed).sum::<f64>() / N as f64 * cell.volume;
        Self {
            cell,
            relayed: Average::new(nodal.map(|c| c.relayed)),
            entrained: Average::new(nodal.map(|c| c.entrained)),
            pressed,
        }
    }

    /// (w, r ∇p) for test function i and p_j.
    pub fn relay(&self, i: usize, j: usize) -> Vector<D> {
        let factor = self.cell.volume * self.relayed.first(i);
        self.cell.gradients[j].map(|slope| factor * slope)
    }

    /// −(∇q, e u) for test function i and u_j; no grain crosses the boundary.
    pub fn entrain(&self, i: usize, j: usize) -> Vector<D> {
        let factor = -self.cell.volume * self.entrained.first(j);
        self.cell.gradients[i].map(|slope| factor * slope)
    }

    /// (∇q, k ∇p) for test function i and p_j.
    pub fn press(&self, i: usize, j: usize) -> f64 {
        self.pressed * dot(&self.cell.gradients[i], &self.cell.gradients[j])
    }
}
