//! What each side books per window. Impulses in N s, momenta in kg m/s, energies in J.

use serde::{Deserialize, Serialize};

/// Three components; z = 0 in two dimensions.
pub type Vector = [f64; 3];

/// The grains' books of one window: Δ`momentum` = `gravity` + `walls` + `drag` + `explicit` + `born` − `removed`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct GrainLedger {
    /// Number of grains at the end of the window.
    pub count: u64,
    /// Mass of the moving grains \[kg\].
    pub mass: f64,
    /// Momentum of the moving grains at the start.
    pub momentum_before: Vector,
    /// Momentum of the moving grains at the end.
    pub momentum: Vector,
    /// Impulse of gravity.
    pub gravity: Vector,
    /// Impulse of walls, and of the supports of frozen grains through contacts.
    pub walls: Vector,
    /// Drag impulse on the moving grains.
    pub drag: Vector,
    /// Impulse of the explicit forces of the fluid on the moving grains.
    pub explicit: Vector,
    /// Impulse of drag and explicit forces on frozen grains, taken by their supports.
    pub supports: Vector,
    /// Σ|impulse| over all entries and grains: the scale of the residual.
    pub scale: f64,
    /// Translational and rotational kinetic energy \[J\].
    pub kinetic_energy: f64,
}

/// The fluid's books of one window. `rate` = `body` + `boundary` − `drag` − `stress` + `explicit`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FluidLedger {
    /// Fluid volume ∫n_f dV \[m³\].
    pub volume: f64,
    /// Momentum ∫ρ n_f u dV.
    pub momentum: Vector,
    /// Momentum gained in the window as the time scheme counts it: Δt · D(ρ n_f u).
    pub rate: Vector,
    /// Impulse of gravity and body force.
    pub body: Vector,
    /// Impulse of walls, inlets and outlets: reactions, tractions, momentum flux.
    pub boundary: Vector,
    /// Drag impulse given to the grains.
    pub drag: Vector,
    /// Impulse of the pressure gradient and the viscous stress that the grains' volume leaves to them.
    pub stress: Vector,
    /// Impulse of the explicit reactions received.
    pub explicit: Vector,
    /// Σ|impulse| over all entries: the scale of the residual.
    pub scale: f64,
    /// Fluid volume gained less what crossed the boundary and what the grains displaced \[m³\].
    pub volume_defect: f64,
    /// Kinetic energy \[J\].
    pub kinetic_energy: f64,
}
