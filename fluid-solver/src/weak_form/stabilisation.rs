//! The relaxation time of the unresolved scales.

/// What resists the unresolved scales of velocity in a cell.
#[derive(Debug, Clone, Copy)]
pub struct Resistance {
    /// Density ρ (kg/m³).
    pub density: f64,
    /// Dynamic viscosity μ (Pa s).
    pub viscosity: f64,
    /// Mean void fraction ε (-).
    pub void_fraction: f64,
    /// Speed |a| (m/s).
    pub speed: f64,
    /// Drag coefficient β per volume (kg/(m³ s)).
    pub drag: f64,
    /// Time step Δt (s).
    pub step: f64,
    /// Mesh size h (m).
    pub size: f64,
}

/// τ₁ = \[c₁ μ ε/h² + c₂ ρ ε|a|/h + β + ρ ε/Δt\]⁻¹ (m³ s/kg), c₁ = 4, c₂ = 2.
///
/// Source: Codina, *Comput. Methods Appl. Mech. Engrg.* 191 (2002) 4295; with drag, Badia and Codina, *SIAM J. Numer.
/// Anal.* 47 (2009) 1971.
pub fn relaxation_time(r: &Resistance) -> f64 {
    let Resistance { density, viscosity, void_fraction, speed, drag, step, size } = *r;
    let viscous = 4.0 * viscosity * void_fraction / (size * size);
    let convective = 2.0 * density * void_fraction * speed / size;
    1.0 / (viscous + convective + drag + density * void_fraction / step)
}
