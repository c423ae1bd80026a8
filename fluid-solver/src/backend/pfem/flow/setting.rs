//! What a flow is of, and what acts on it.

use super::rheology::Rheology;
use super::scheme::Scheme;
use super::strain::Strain;
use crate::element::simplex::Vector;
use crate::grains::Suspension;

/// The fluid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fluid {
    /// ρ (kg/m³).
    pub density: f64,
    /// What resists shear.
    pub rheology: Rheology,
    /// κ (Pa); none if incompressible.
    pub bulk_modulus: Option<f64>,
}

/// How accurate a step is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Control {
    /// Norm of the residual relative to that of the predictor and of the inertia and stresses of the flow.
    pub tolerance: f64,
    /// Least θ: v_m = v_n + θΔt v′ and v_{n+1} = v_n + Δt v′. One half is of second order and keeps the energy; more damps
    /// what rings from step to step, and waves. The segregated scheme and yield stresses have θ = 1.
    pub implicitness: f64,
    /// How velocity and pressure are found.
    pub scheme: Scheme,
    /// How far a cell may be strained in a step.
    pub strain: Strain,
}

impl Default for Control {
    fn default() -> Self {
        Self { tolerance: 1e-6, implicitness: 0.5, scheme: Scheme::default(), strain: Strain::default() }
    }
}

/// What acts on the fluid from outside.
#[derive(Clone, Copy, Debug)]
pub struct Forces<'a, const D: usize> {
    /// g (m/s²).
    pub gravity: Vector<D>,
    /// The grains in it, if any.
    pub grains: Option<Suspension<'a, D>>,
}
