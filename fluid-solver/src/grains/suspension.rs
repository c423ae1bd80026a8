//! What grains do to the equations of a fluid whose nodes move with it.

use super::compliance::Given;
use super::exchange::NodalDrag;
use crate::element::simplex::Vector;

/// Fields at the nodes for one step t_n → t_n + Δt, the grains placed where they end:
///
/// ```text
/// momentum    ρε Dv/Dt = −ε∇p + ε∇·τ + ρεg − (d v − g)/|N_a|
/// volume      (ε' − ε_n)/Δt + (v − v̂)·∇ε + ε∇·v = 0
/// ```
/// ε' is what the nodes would have, were they carried by v̂: for v = v̂ the first two terms are Dε/Dt, and for any other v they
/// are to first order. Together with ε∇·v they make ∇·(εv), the transpose of ε∇p.
#[derive(Debug, Clone, Copy)]
pub struct Suspension<'a, const D: usize> {
    /// ε' (-).
    pub void_fraction: &'a [f64],
    /// |N_a|(ε' − ε_n)/Δt, |N_a| at t_n (m³/s).
    pub source: &'a [f64],
    /// v̂ (m/s).
    pub carrier: &'a [Vector<D>],
    /// d, g of the velocity at the end of the step.
    pub drag: &'a NodalDrag<D>,
    /// |N_a| where ε' was taken (m³).
    pub measure: &'a [f64],
    /// How the grains give way.
    pub given: Given<'a, D>,
}
